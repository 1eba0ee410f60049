// A kernel is a function of the drop-ins that fills a block of points.

#ifndef GABOR_PYTHON_KERNEL_HPP
#define GABOR_PYTHON_KERNEL_HPP

#include "gabor_noise.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// An argument's values at the points of a block.
struct Input {
    const double* data;
    bool constant; // all values are equal

    double exact(std::size_t i) const { return data[i]; }
    float operator[](std::size_t i) const { return static_cast<float>(exact(i)); }
};

struct Block {
    static constexpr std::size_t size = 256; // the maximum number of points
    std::size_t count;
    const std::vector<Input>& in;
    float* out; // channel c of point i is out[c * size + i]

    void put(std::size_t channel, std::size_t i, float value) const { out[channel * size + i] = value; }
    std::uint32_t seed(std::size_t input, std::size_t i) const {
        return static_cast<std::uint32_t>(in[input].exact(i)); // Python passes 0 to 2^32 - 1
    }
};

struct Kernel {
    const char* name;
    std::string inputs; // names, with a space between them, in the order of Block::in
    std::size_t channels;
    void (*fill)(const Block&);
    std::vector<float>
        defaults; // of the members of the last argument's struct, which follow the other inputs
};

// A coordinate as its cell and the offset in it, so that a float offset is precise at any distance from the
// origin.
struct Split {
    int cell;
    float local;

    Split(double position, float nodes) { // nodes per unit
        const double at = position * double(nodes);
        std::int64_t whole = static_cast<std::int64_t>(at);
        whole -= at < static_cast<double>(whole); // floor, without a function call
        cell = static_cast<int>(static_cast<std::uint32_t>(whole));
        local = static_cast<float>(at - static_cast<double>(whole));
    }
};

std::vector<Kernel> noise_kernels();
std::vector<Kernel> terrain_kernels();
std::vector<Kernel> material_kernels();
std::vector<Kernel> ocean_kernels();

#endif // GABOR_PYTHON_KERNEL_HPP
