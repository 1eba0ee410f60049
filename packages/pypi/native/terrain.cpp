// Kernels of hills and of erosion.

#include "kernel.hpp"

#include "gabor_erosion.hpp"

#include <cstring>

namespace {

const char* const ground_inputs = "x y period.x period.y pixel_size.x pixel_size.y seed ";

struct Ground {
    GaborTerrainPlace place;
    gabor_vec2 dx, dy;
};

Ground ground_of(const Block& block, std::size_t i) {
    const std::vector<Input>& in = block.in;
    const Split across(in[0].exact(i), 1.0f), down(in[1].exact(i), 1.0f);
    return {{{across.cell, down.cell}, {across.local, down.local}, {in[2][i], in[3][i]}},
            {in[4][i], 0.0f},
            {0.0f, in[5][i]}};
}

// The members of GaborErosion: one integer, then floats.
constexpr std::size_t floats = sizeof(GaborErosion) / sizeof(float) - 1;

GaborErosion erosion_of(const Input* members, std::size_t i) {
    GaborErosion erosion;
    erosion.octaves = static_cast<int>(members[0][i]);
    float values[floats];
    for (std::size_t k = 0; k < floats; ++k)
        values[k] = members[k + 1][i];
    std::memcpy(&erosion.gully_frequency, values, sizeof values);
    return erosion;
}

void put(const Block& block, std::size_t i, const GaborTerrain& terrain) {
    block.put(0, i, terrain.height);
    block.put(1, i, terrain.slope.x);
    block.put(2, i, terrain.slope.y);
    block.put(3, i, terrain.ridge);
}

void fill_terrain(const Block& block) {
    for (std::size_t i = 0; i < block.count; ++i) {
        const Ground ground = ground_of(block, i);
        const GaborErosion erosion = erosion_of(&block.in[7], i);
        GaborTerrain terrain = gabor_terrain_at(ground.place, ground.dx, ground.dy, block.seed(6, i));
        if (erosion.octaves > 0)
            terrain = gabor_eroded_at(ground.place, ground.dx, ground.dy, terrain, erosion, block.seed(6, i));
        put(block, i, terrain);
    }
}

void fill_eroded(const Block& block) {
    const Input* base = &block.in[7];
    for (std::size_t i = 0; i < block.count; ++i) {
        const Ground ground = ground_of(block, i);
        const GaborErosion erosion = erosion_of(base + 7, i);
        GaborTerrain terrain{base[0][i],
                             {base[1][i], base[2][i]},
                             base[3][i],
                             {base[4][i], base[5][i], base[6][i]},
                             {0.0f, 0.0f}};
        if (erosion.octaves > 0)
            terrain = gabor_eroded_at(ground.place, ground.dx, ground.dy, terrain, erosion, block.seed(6, i));
        put(block, i, terrain);
    }
}

} // namespace

std::vector<Kernel> terrain_kernels() {
    const GaborErosion erosion = gabor_erosion();
    std::vector<float> defaults(1 + floats, float(erosion.octaves));
    std::memcpy(&defaults[1], &erosion.gully_frequency, floats * sizeof(float));
    const std::string ground = ground_inputs;
    return {
        {"terrain", ground, 4, fill_terrain, defaults},
        {"eroded", ground + "base.0 base.1 base.2 base.3 base.4 base.5 base.6 ", 4, fill_eroded, defaults}};
}
