// The positions at which a study evaluates a noise: a square grid of 4^grid_bits positions in each of many
// instances. The grid starts at a fixed position, or at a random offset of up to a cell from there. Single
// values, pairs, windows, cells and pictures are all such grids. Include a file that defines gabor_impl_mix
// before this one.

#include "passes/places_interface.h"

layout(local_size_x = places_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };

// Returns two random numbers in [0, 1).
vec2 place_random(uint instance) {
    uint x = gabor_impl_mix(instance * 0x9e3779b1u, place_seed);
    uint y = gabor_impl_mix(x, place_seed ^ 0x85ebca6bu);
    return vec2(ivec2(x >> 8u, y >> 8u)) / 16777216.0;
}

// Returns the position of a value, in cells, and sets the seed of its instance.
vec2 place_of(uint index, out uint seed) {
    uint instance = first + (index >> (2u * grid_bits));
    seed = gabor_impl_mix(instance * 0x9e3779b1u + noise_seed, noise_seed);
    uint mask = (1u << grid_bits) - 1u;
    vec2 node = vec2(ivec2(index & mask, (index >> grid_bits) & mask));
    return corner + within * place_random(instance) + (node + 0.5) * spacing;
}
