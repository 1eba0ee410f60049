// Generated from gabor_compose.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl, gabor_fractal.hlsl, gabor_spectrum.hlsl, gabor_materials.hlsl; pasted after their texts, it includes nothing.
//
// gabor_compose.hlsl: materials together, as planks and tiles, one over another, or worn.
//
//     GaborBoards planks = gabor_boards_default();
//     GaborBoard board = gabor_board(p, ddx(p), ddy(p), float2(0.0), planks, 7u);      // the one at p
//     GaborMaterial m = gabor_wood_filtered(board.position, board.dx, board.dy, board.seed);
//     m = gabor_laid(m, board, planks);
//     GaborMaterial sand = gabor_sand_filtered(p, ddx(p), ddy(p), 8u);              // a layer
//     sand.height = 0.2 * sand.height - 0.015;                                         // so low that it lies in joints
//     m = gabor_covered(m, sand, 0.005);
//
//     I want                                 call
//     planks, tiles, bricks or cobbles       gabor_board, then any material at board.position, then gabor_laid
//     moss, snow or sand that fills hollows  gabor_covered(below, above, softness)
//     edges and crests that are rubbed off   gabor_worn(coat, core, softness)
//     more or less of it in places           add a mask to a material's height, and the mask's gradient to its slope
//     no two objects alike                   another seed for each
//
// The slope of the result remains the derivative of its height. gabor_board and gabor_laid together cost three quarters
// of gabor_noise; gabor_covered and gabor_worn cost next to nothing. For filtered materials, give a `softness` of at
// least the difference in height within a pixel.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#ifndef GABOR_FRACTAL_HLSL
#include "gabor_fractal.hlsl"
#endif
#ifndef GABOR_SPECTRUM_HLSL
#include "gabor_spectrum.hlsl"
#endif
#ifndef GABOR_MATERIALS_HLSL
#include "gabor_materials.hlsl"
#endif
#ifndef GABOR_COMPOSE_HLSL
#define GABOR_COMPOSE_HLSL 1

// ---- Boards --------------------------------------------------------------------------------------------------------

// Boards in columns along y or, if they are wider than long, in rows along x.
struct GaborBoards {
    float3 joint_colour;     // colour of the joints
    float board_width;     // width of the boards along x, in units, 0.05 to 10
    float board_length;    // length of the boards along y, in units, 0.05 to 20
    float offset;          // shift of each column or row from the one before it, in boards, 0 to 1
    float turned_share;    // share of the boards whose material is turned by a quarter turn, 0 to 1
    float shade_variation; // how much darker the darkest boards are than the material, 0 to 1
    float joint_width;     // width of the joints, in units, 0 to 0.2
    float joint_depth;     // depth of the joints below height 0, in units, 0 to 0.2
};

GaborBoards GaborBoards_of(float3 joint_colour, float board_width, float board_length, float offset, float turned_share,
        float shade_variation, float joint_width, float joint_depth) {
    GaborBoards made = {joint_colour, board_width, board_length, offset, turned_share, shade_variation, joint_width,
        joint_depth};
    return made;
}

// The board at a point.
struct GaborBoard {
    float2 position;    // where to evaluate its material
    float2 dx;          // the pixel there, for a filtered material
    float2 dy;
    uint seed;        // the board's own seed for its material
    float2 rotation;    // cosine and sine of its turn
    float shade;      // factor for its colours
    float3 joint_cover; // how much of the pixel is a joint, and the derivatives of that along x and y
};

GaborBoard GaborBoard_of(float2 position, float2 dx, float2 dy, uint seed, float2 rotation, float shade,
        float3 joint_cover) {
    GaborBoard made = {position, dx, dy, seed, rotation, shade, joint_cover};
    return made;
}

// GaborBoards gabor_boards_default()
//     Planks of half by three units.

// GaborBoard gabor_board(float2 p, float2 dx, float2 dy, float2 period, GaborBoards boards, uint seed)
//     The board at p. dx and dy are ddx(p) and ddy(p), or float2(0.0) without a filter: a pixel of several boards shows
//     one of them, in their mean shade. If `period` is not float2(0.0), the boards repeat after it: their size and shift
//     change so that whole boards fill it. Give the material itself no period.

// GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards)
//     The material at board.position as part of its board: turned, with the board's shade, and with joints. `lost`
//     leaves out the slopes of joints, which are too few and too steep to widen a highlight.

// GaborMaterial gabor_covered(GaborMaterial below, GaborMaterial above, float softness)
//     The higher of two materials. Their edge is as soft as a difference in height of `softness`.

// GaborMaterial gabor_worn(GaborMaterial coat, GaborMaterial core, float softness)
//     The lower of two materials: a coat that is worn off where it stands out of the core.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

GaborBoards gabor_boards_default() {
    return GaborBoards_of(float3(0.03, 0.02, 0.014), 0.5, 3.0, 0.38, 0.0, 0.3, 0.012, 0.012);
}

// The share of a joint, `gap` wide, at distance x from its middle, and its derivative along x. The joint's edges are
// normal distribution functions with the standard deviation 1 / scale.
float2 gabor_impl_joint(float x, float gap, float scale) {
    float2 t = clamp(scale * float2(x + 0.5 * gap, x - 0.5 * gap), -10.0, 10.0), density = exp(-0.5 * t * t);
    // 0.39894228 is 1/sqrt(2 pi)
    return float2(gabor_impl_below(t.x) - gabor_impl_below(t.y), 0.39894228 * scale * (density.x - density.y));
}

// The joints on both sides of a board of this size, at x from its middle, averaged over a pixel of variance `wide`.
float2 gabor_impl_joints(float x, float size, float gap, float wide) {
    if (gap <= 0.0) return (float2)(0.0);
    gap = min(gap, size);
    // Pixels wider than 0.4 of a board reach more than two joints, whose sum is nearly constant.
    float scale = rsqrt(0.04 * gap * gap + min(wide, 0.16 * size * size));
    return gabor_impl_joint(x - 0.5 * size, gap, scale) + gabor_impl_joint(x + 0.5 * size, gap, scale);
}

// Wraps indices to 0 ... count - 1, unless count is 0.
float2 gabor_impl_board_index(float2 index, float2 count) {
    return count.x > 0.0 ? index - count * floor(index / count) : index;
}

GaborBoard gabor_board(float2 p, float2 dx, float2 dy, float2 period, GaborBoards boards, uint seed) {
    float2 size = float2(boards.board_width, boards.board_length), count = (float2)(0.0);
    bool rows = size.x > size.y;
    float shift = boards.offset;
    if (period.x > 0.0) { // the shift must also fit between the last row and the first
        count = max(floor(period / size + 0.5), (float2)(1.0));
        float lines = rows ? count.y : count.x, rest = frac(lines * shift);
        if (abs(rest - 0.5) < 0.25) lines += 1.0;
        shift = floor(lines * shift + 0.5) / lines;
        count = rows ? float2(count.x, lines) : float2(lines, count.y);
        size = period / count;
    }
    float2 at = p / size, line_ = gabor_impl_board_index(floor(at), count);
    at += rows ? float2(frac(shift * line_.y), 0.0) : float2(0.0, frac(shift * line_.x));
    float2 cell = floor(at), index = gabor_impl_board_index(cell, count), local = (at - cell - 0.5) * size;
    uint salt = gabor_impl_salt(seed);
    uint word = gabor_impl_line_word(int(index.x), salt) * gabor_impl_line_word(int(index.y), salt ^ GABOR_IMPL_ROWS);
    uint random = gabor_derived_seed(word, 1);
    float2 turn = float(random & 65535u) < 65536.0 * boards.turned_share ? float2(0.0, 1.0) : float2(1.0, 0.0);
    float2 back = float2(turn.x, -turn.y);
    float2 wide = 0.25 * (dx * dx + dy * dy); // the variance of the pixel along x and y
    float2 boards_wide = min(wide / (size * size), 4.0);
    // 19.739209 is 2 pi^2
    float mean = exp(-19.739209 * max(boards_wide.x, boards_wide.y)); // a pixel of several boards has their mean shade
    float2 across = gabor_impl_joints(local.x, size.x, boards.joint_width, wide.x);
    float2 along = gabor_impl_joints(local.y, size.y, boards.joint_width, wide.y);
    float2 free = 1.0 - float2(across.x, along.x); // of a joint along each axis
    float dark = 0.5 + mean * (float(random >> 16u) / 65535.0 - 0.5);
    return GaborBoard_of(gabor_impl_product(local, back), gabor_impl_product(dx, back), gabor_impl_product(dy, back),
                      gabor_derived_seed(word, 0), turn, 1.0 - boards.shade_variation * dark,
                      float3(1.0 - free.x * free.y, free.y * across.y, free.x * along.y));
}

GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards) {
    float joint = board.joint_cover.x, free = 1.0 - joint;
    float2 back = float2(board.rotation.x, -board.rotation.y);
    return GaborMaterial_of(lerp(board.shade * material.colour, boards.joint_colour, joint),
                         free * material.height - joint * boards.joint_depth,
                         free * gabor_impl_product(material.slope, board.rotation)
                             - (material.height + boards.joint_depth) * board.joint_cover.yz,
                         lerp(material.roughness, max(material.roughness, 0.8), joint), free * material.metalness,
                         free * gabor_impl_turned_square(material.lost, back, board.rotation.yx));
}

// The higher of two materials if `side` is 1, the lower if it is -1. In this smooth maximum the derivatives have the
// same shares as the materials: over a difference d from -s to s, it grows by (d + s)^2 / (4 s).
GaborMaterial gabor_impl_outer(GaborMaterial a, GaborMaterial b, float softness, float side) {
    float d = side * (b.height - a.height) / max(softness, 1.0e-6), edge = max(1.0 - abs(d), 0.0);
    float share = clamp(0.5 + 0.5 * d, 0.0, 1.0), height = max(side * a.height, side * b.height);
    return GaborMaterial_of(lerp(a.colour, b.colour, share), side * (height + 0.25 * softness * edge * edge),
                         lerp(a.slope, b.slope, share), lerp(a.roughness, b.roughness, share),
                         lerp(a.metalness, b.metalness, share), lerp(a.lost, b.lost, share));
}

GaborMaterial gabor_covered(GaborMaterial below, GaborMaterial above, float softness) {
    return gabor_impl_outer(below, above, softness, 1.0);
}

GaborMaterial gabor_worn(GaborMaterial coat, GaborMaterial core, float softness) {
    return gabor_impl_outer(coat, core, softness, -1.0);
}

#endif
