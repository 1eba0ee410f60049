// Kernels of the sea.

#include "kernel.hpp"

#include "gabor_ocean.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace {

const char* const inputs = "x y seconds direction loop_seconds seed ";
constexpr std::size_t seed_input = 5, members = offsetof(GaborSea, direction) / sizeof(float);

// The members of GaborSea that have a range are the block's last inputs.
GaborOcean ocean_of(const Block& block, std::size_t i) {
    float values[members];
    for (std::size_t m = 0; m < members; ++m)
        values[m] = block.in[block.in.size() - members + m][i];
    GaborSea sea = gabor_sea();
    std::memcpy(&sea, values, sizeof values);
    sea.direction = block.in[3][i];
    sea.loop_seconds = static_cast<int>(block.in[4][i]);
    return gabor_ocean_of(sea);
}

std::vector<float> defaults() {
    const GaborSea sea = gabor_sea();
    std::vector<float> values(members);
    std::memcpy(values.data(), &sea, members * sizeof(float));
    return values;
}

bool one_ocean(const Block& block) {
    const auto constant = [](const Input& input) { return input.constant; };
    return std::all_of(block.in.begin() + 3, block.in.begin() + seed_input, constant) &&
           std::all_of(block.in.end() - members, block.in.end(), constant);
}

GaborWater water_at(const Block& block, std::size_t i, double x, double y, gabor_vec2 dx, gabor_vec2 dy,
                    const GaborOcean& ocean) {
    const Split across(x, 1.0f), down(y, 1.0f), time(block.in[2].exact(i), 1.0f);
    return gabor_water_at({across.cell, down.cell}, {across.local, down.local}, time.cell, time.local, dx, dy,
                          ocean, block.seed(seed_input, i));
}

void fill_water(const Block& block) {
    GaborOcean ocean = ocean_of(block, 0);
    for (std::size_t i = 0; i < block.count; ++i) {
        if (i > 0 && !one_ocean(block))
            ocean = ocean_of(block, i);
        const GaborWater water =
            water_at(block, i, block.in[0].exact(i), block.in[1].exact(i),
                     {block.in[seed_input + 1][i], 0.0f}, {0.0f, block.in[seed_input + 2][i]}, ocean);
        const float values[]{water.height,  water.slope.x,    water.slope.y,    water.shift.x,
                             water.shift.y, water.jacobian,   water.lost.x,     water.lost.y,
                             water.lost.z,  water.velocity.x, water.velocity.y, water.velocity.z};
        for (std::size_t c = 0; c < 12; ++c)
            block.put(c, i, values[c]);
    }
}

// As gabor_water_height, precise wherever the place is.
void fill_height(const Block& block) {
    GaborOcean ocean = ocean_of(block, 0);
    for (std::size_t i = 0; i < block.count; ++i) {
        if (i > 0 && !one_ocean(block))
            ocean = ocean_of(block, i);
        GaborWater water{};
        for (int k = 0; k < 6; ++k)
            water = water_at(block, i, block.in[0].exact(i) - double(water.shift.x),
                             block.in[1].exact(i) - double(water.shift.y), {0.0f, 0.0f}, {0.0f, 0.0f}, ocean);
        block.put(0, i, water.height);
    }
}

} // namespace

std::vector<Kernel> ocean_kernels() {
    return {{"water", std::string(inputs) + "pixel_size.x pixel_size.y ", 12, fill_water, defaults()},
            {"water_height", inputs, 1, fill_height, defaults()}};
}
