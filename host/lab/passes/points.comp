#version 450
#extension GL_GOOGLE_include_directive : require

// Writes the point set of each cell in a square of cells: its count and the positions of the first `capacity`
// impulses.

#include "ingredients.glsl"
#include "passes/points_interface.h"

layout(local_size_x = points_group, local_size_y = points_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Counts { int counts[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Places { vec2 places[]; };

void main() {
    uvec2 cell = gl_GlobalInvocationID.xy;
    if (cell.x >= side || cell.y >= side)
        return;
    uint index = cell.y * side + cell.x;
    uint row_word = gabor_impl_row_word(int(cell.y), gabor_impl_seed_word(seed));
    uint cell_word = gabor_impl_impulse_word(int(cell.x), row_word, -1);
    int count = gabor_count(cell_word);
    counts[index] = count;
    for (int k = 0; k < min(count, int(capacity)); ++k) {
        uint word = gabor_impl_impulse_word(int(cell.x), row_word, k);
        places[index * capacity + uint(k)] = vec2(cell) + gabor_point(k, word, cell_word);
    }
}
