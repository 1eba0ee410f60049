#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace samples {

/// Normal values from a fixed seed.
inline std::vector<float> normal(std::size_t count, std::uint64_t seed, double mean = 0,
                                 double deviation = 1) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> law(mean, deviation);
    std::vector<float> values(count);
    for (float& value : values)
        value = static_cast<float>(law(generator));
    return values;
}

} // namespace samples
