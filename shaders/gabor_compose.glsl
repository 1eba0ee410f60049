// gabor_compose.glsl: materials together, as planks and tiles, one over another, or worn.
//
// Paste or include this file after gabor_noise.glsl, gabor_spectrum.glsl, gabor_fractal.glsl and gabor_materials.glsl.
//
//     GaborBoards planks = gabor_boards_default();
//     GaborBoard board = gabor_board(p, dFdx(p), dFdy(p), vec2(0.0), planks, 7u);      // the one at p
//     GaborMaterial m = gabor_wood_filtered(board.position, board.dx, board.dy, board.seed);
//     m = gabor_laid(m, board, planks);
//     GaborMaterial sand = gabor_sand_filtered(p, dFdx(p), dFdy(p), 8u);              // a layer
//     sand.height = 0.2 * sand.height - 0.015;                                         // so low that it lies in joints
//     m = gabor_covered(m, sand, 0.005);
//
//     I want                                 call
//     planks, tiles, bricks or cobbles       gabor_board, then any material at board.position, then gabor_laid
//     moss, snow or sand that fills hollows  gabor_covered(below, above, softness)
//     edges and crests that are rubbed off   gabor_worn(coat, core, softness)
//     more or less of it in places           add a mask to a material's height, and the mask's gradient to its slope
//     no two objects alike                   another seed for each
//     uneven colour, gloss, dirt, dust       gabor_finished or, for a filtered material, gabor_finished_filtered
//
// The slope of the result remains the derivative of its height. gabor_board and gabor_laid together cost three quarters
// of gabor_noise; gabor_covered and gabor_worn cost next to nothing. For filtered materials, give a `softness` of at
// least the difference in height within a pixel.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_MATERIALS_GLSL
#error Include gabor_noise.glsl, gabor_spectrum.glsl, gabor_fractal.glsl, gabor_materials.glsl before gabor_compose.glsl
#endif
#ifndef GABOR_COMPOSE_GLSL
#define GABOR_COMPOSE_GLSL 1

// ---- Boards --------------------------------------------------------------------------------------------------------

// Boards in columns along y or, if they are wider than long, in rows along x.
struct GaborBoards {
    vec3 joint_colour;     // colour of the joints
    float board_width;     // width of the boards along x, in units, 0.05 to 10
    float board_length;    // length of the boards along y, in units, 0.05 to 20
    float offset;          // shift of each column or row from the one before it, in boards, 0 to 1
    float turned_share;    // share of the boards whose material is turned by a quarter turn, 0 to 1
    float shade_variation; // how much darker the darkest boards are than the material, 0 to 1
    float joint_width;     // width of the joints, in units, 0 to 0.2
    float joint_depth;     // depth of the joints below height 0, in units, 0 to 0.2
};

// The board at a point.
struct GaborBoard {
    vec2 position;    // where to evaluate its material
    vec2 dx;          // the pixel there, for a filtered material
    vec2 dy;
    uint seed;        // the board's own seed for its material
    vec2 rotation;    // cosine and sine of its turn
    float shade;      // factor for its colours
    vec3 joint_cover; // how much of the pixel is a joint, and the derivatives of that along x and y
};

// GaborBoards gabor_boards_default()
//     Planks of half by three units.

// GaborBoard gabor_board(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborBoards boards, uint seed)
//     The board at p. dx and dy are dFdx(p) and dFdy(p), or vec2(0.0) without a filter: a pixel of several boards shows
//     one of them, in their mean shade. If `period` is not vec2(0.0), the boards repeat after it: their size and shift
//     change so that whole boards fill it. Give the material itself no period.

// GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards)
//     The material at board.position as part of its board: turned, with the board's shade, and with joints. `lost`
//     leaves out the slopes of joints, which are too few and too steep to widen a highlight.

// GaborMaterial gabor_covered(GaborMaterial below, GaborMaterial above, float softness)
//     The higher of two materials. Their edge is as soft as a difference in height of `softness`.

// GaborMaterial gabor_worn(GaborMaterial coat, GaborMaterial core, float softness)
//     The lower of two materials: a coat that is worn off where it stands out of the core.

// ---- A finish ------------------------------------------------------------------------------------------------------

// What time does to a material: brightness, hue and roughness differ from place to place, dirt lies low, dust on flat
// ground. And a grain, which is visible from 300 pixels per unit on.
struct GaborFinish {
    vec3 dirt_colour;          // colour of the dirt
    vec3 dust_colour;          // colour of the dust
    float patch_size;          // size of the patches that differ, in units, 0.1 to 10
    float shade_variation;     // variation of the brightness: the deviation of its logarithm, 0 to 0.5
    float hue_variation;       // variation of the hue: the deviation of the logarithm of red over blue, 0 to 0.5
    float roughness_variation; // variation of the roughness: its deviation, 0 to 0.3
    float dirt_amount;         // share of the dirt where it is thickest, 0 to 1
    float dirt_height;         // height of half the dirt, in units, -1 to 1
    float dirt_depth;          // difference in height from most dirt to none, in units, 0.001 to 2
    float dust_amount;         // share of the dust where it is thickest, 0 to 1
    float grain_size;          // size of the grains along x, in units, 0.001 to 0.05
    float grain_stretch;       // length of the grains along y, relative to their size, 1 to 50
    float grain_contrast;      // contrast of the grains: the deviation of the logarithm of the brightness, 0 to 0.5
    float grain_height;        // deviation of the height by the grains, in units, 0 to 0.002
};

// GaborFinish gabor_finish_default()
//     A slightly worn surface without dirt or dust.

// GaborMaterial gabor_finished(GaborMaterial material, vec2 p, vec2 period, GaborFinish finish, uint seed)
// GaborMaterial gabor_finished_filtered(GaborMaterial material, vec2 p, vec2 dx, vec2 dy, vec2 period,
//                                       GaborFinish finish, uint seed)
//     The material with a finish at p, plain or filtered; after gabor_laid, patches run across boards. Patches and
//     grains change no mean of colour, roughness and height, unless they clip. The mean share of dirt is the same from
//     afar if dirt_depth is the whole relief.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

GaborBoards gabor_boards_default() {
    return GaborBoards(vec3(0.03, 0.02, 0.014), 0.5, 3.0, 0.38, 0.0, 0.3, 0.012, 0.012);
}

// The share of a joint, `gap` wide, at distance x from its middle, and its derivative along x. The joint's edges are
// normal distribution functions with the standard deviation 1 / scale.
vec2 gabor_impl_joint(float x, float gap, float scale) {
    vec2 t = clamp(scale * vec2(x + 0.5 * gap, x - 0.5 * gap), -10.0, 10.0), density = exp(-0.5 * t * t);
    // 0.39894228 is 1/sqrt(2 pi)
    return vec2(gabor_impl_below(t.x) - gabor_impl_below(t.y), 0.39894228 * scale * (density.x - density.y));
}

// The joints on both sides of a board of this size, at x from its middle, averaged over a pixel of variance `wide`.
vec2 gabor_impl_joints(float x, float size, float gap, float wide) {
    if (gap <= 0.0) return vec2(0.0);
    gap = min(gap, size);
    // Pixels wider than 0.4 of a board reach more than two joints, whose sum is nearly constant.
    float scale = inversesqrt(0.04 * gap * gap + min(wide, 0.16 * size * size));
    return gabor_impl_joint(x - 0.5 * size, gap, scale) + gabor_impl_joint(x + 0.5 * size, gap, scale);
}

// Wraps indices to 0 ... count - 1, unless count is 0.
vec2 gabor_impl_board_index(vec2 index, vec2 count) {
    return count.x > 0.0 ? index - count * floor(index / count) : index;
}

GaborBoard gabor_board(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborBoards boards, uint seed) {
    vec2 size = vec2(boards.board_width, boards.board_length), count = vec2(0.0);
    bool rows = size.x > size.y;
    float shift = boards.offset;
    if (period.x > 0.0) { // the shift must also fit between the last row and the first
        count = max(floor(period / size + 0.5), vec2(1.0));
        float lines = rows ? count.y : count.x, rest = fract(lines * shift);
        if (abs(rest - 0.5) < 0.25) lines += 1.0;
        shift = floor(lines * shift + 0.5) / lines;
        count = rows ? vec2(count.x, lines) : vec2(lines, count.y);
        size = period / count;
    }
    vec2 at = p / size, line = gabor_impl_board_index(floor(at), count);
    at += rows ? vec2(fract(shift * line.y), 0.0) : vec2(0.0, fract(shift * line.x));
    vec2 cell = floor(at), index = gabor_impl_board_index(cell, count), local = (at - cell - 0.5) * size;
    uint salt = gabor_impl_salt(seed);
    uint word = gabor_impl_line_word(int(index.x), salt) * gabor_impl_line_word(int(index.y), salt ^ GABOR_IMPL_ROWS);
    uint random = gabor_derived_seed(word, 1);
    vec2 turn = float(random & 65535u) < 65536.0 * boards.turned_share ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    vec2 back = vec2(turn.x, -turn.y);
    vec2 wide = 0.25 * (dx * dx + dy * dy); // the variance of the pixel along x and y
    vec2 boards_wide = min(wide / (size * size), 4.0);
    // 19.739209 is 2 pi^2
    float mean = exp(-19.739209 * max(boards_wide.x, boards_wide.y)); // a pixel of several boards has their mean shade
    vec2 across = gabor_impl_joints(local.x, size.x, boards.joint_width, wide.x);
    vec2 along = gabor_impl_joints(local.y, size.y, boards.joint_width, wide.y);
    vec2 free = 1.0 - vec2(across.x, along.x); // of a joint along each axis
    float dark = 0.5 + mean * (float(random >> 16u) / 65535.0 - 0.5);
    return GaborBoard(gabor_impl_product(local, back), gabor_impl_product(dx, back), gabor_impl_product(dy, back),
                      gabor_derived_seed(word, 0), turn, 1.0 - boards.shade_variation * dark,
                      vec3(1.0 - free.x * free.y, free.y * across.y, free.x * along.y));
}

GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards) {
    float joint = board.joint_cover.x, free = 1.0 - joint;
    vec2 back = vec2(board.rotation.x, -board.rotation.y);
    return GaborMaterial(mix(board.shade * material.colour, boards.joint_colour, joint),
                         free * material.height - joint * boards.joint_depth,
                         free * gabor_impl_product(material.slope, board.rotation)
                             - (material.height + boards.joint_depth) * board.joint_cover.yz,
                         mix(material.roughness, max(material.roughness, 0.8), joint), free * material.metalness,
                         free * gabor_impl_turned_square(material.lost, back, board.rotation.yx));
}

// The higher of two materials if `side` is 1, the lower if it is -1. In this smooth maximum the derivatives have the
// same shares as the materials: over a difference d from -s to s, it grows by (d + s)^2 / (4 s).
GaborMaterial gabor_impl_outer(GaborMaterial a, GaborMaterial b, float softness, float side) {
    float d = side * (b.height - a.height) / max(softness, 1.0e-6), edge = max(1.0 - abs(d), 0.0);
    float share = clamp(0.5 + 0.5 * d, 0.0, 1.0), height = max(side * a.height, side * b.height);
    return GaborMaterial(mix(a.colour, b.colour, share), side * (height + 0.25 * softness * edge * edge),
                         mix(a.slope, b.slope, share), mix(a.roughness, b.roughness, share),
                         mix(a.metalness, b.metalness, share), mix(a.lost, b.lost, share));
}

GaborMaterial gabor_covered(GaborMaterial below, GaborMaterial above, float softness) {
    return gabor_impl_outer(below, above, softness, 1.0);
}

GaborMaterial gabor_worn(GaborMaterial coat, GaborMaterial core, float softness) {
    return gabor_impl_outer(coat, core, softness, -1.0);
}

// ---- A finish ------------------------------------------------------------------------------------------------------

GaborFinish gabor_finish_default() {
    return GaborFinish(vec3(0.03, 0.022, 0.016), vec3(0.42, 0.38, 0.33), 0.5, 0.12, 0.04, 0.06, 0.0, 0.0, 0.1, 0.0,
                       0.006, 1.0, 0.1, 0.0);
}

// Patches and grains.
GaborImplLayer gabor_impl_finish_layer(int i, GaborImplPixel at, GaborFinish finish, uint seed) {
    if (i == 0) return gabor_impl_spots_layer(at, vec2(1.0 / finish.patch_size), seed, 65);
    return gabor_impl_spots_layer(at, vec2(1.0, 1.0 / finish.grain_stretch) / finish.grain_size, seed, 66);
}

// A colour channel times the factors of mean 1 of `shade`, and of the hue with this weight.
float gabor_impl_tinted(float colour, vec2 shade, float hue, float removed, float contrast) {
    return gabor_impl_toned(vec3(colour), shade + gabor_impl_tone(hue, removed, contrast)).x;
}

// Patches: the first noise is the brightness, the second one the roughness and, with it, the hue.
GaborMaterial gabor_impl_finish(GaborMaterial material, GaborFinish finish, GaborImplPair patches,
                                GaborImplPair grain) {
    vec2 shade = gabor_impl_tone(patches.first.x, patches.removed, finish.shade_variation)
               + gabor_impl_tone(grain.first.x, grain.removed, finish.grain_contrast);
    // Red and blue change against each other, and green so that the luminance of grey stays:
    // 0.19631 is (0.2126 - 0.0722) / 0.7152
    float hue = patches.second.x, red = 0.5 * finish.hue_variation;
    vec3 colour = vec3(gabor_impl_tinted(material.colour.x, shade, hue, patches.removed, red),
                       gabor_impl_tinted(material.colour.y, shade, hue, patches.removed, -0.19631 * red),
                       gabor_impl_tinted(material.colour.z, shade, hue, patches.removed, -red));
    float roughness = material.roughness + finish.roughness_variation * patches.second.x;
    float dirt = finish.dirt_amount * clamp(0.5 + (finish.dirt_height - material.height) / finish.dirt_depth, 0.0, 1.0);
    // The mean of exp(-|slope|^2) over normal slopes whose covariance has the trace steep - 1.
    float steep = 1.0 + material.lost.x + material.lost.y;
    float flatness = exp(-dot(material.slope, material.slope) / steep) / steep;
    float dust = finish.dust_amount * flatness * gabor_impl_above(patches.second, patches.removed, 0.0, 0.7).x;
    float bare = (1.0 - dirt) * (1.0 - dust);
    return GaborMaterial(mix(mix(colour, finish.dirt_colour, dirt), finish.dust_colour, dust),
                         material.height + finish.grain_height * grain.first.x,
                         material.slope + finish.grain_height * grain.first.yz,
                         mix(0.9, clamp(roughness, 0.03, 1.0), bare), bare * material.metalness,
                         material.lost + finish.grain_height * finish.grain_height * grain.lost);
}

GaborMaterial gabor_finished(GaborMaterial material, vec2 p, vec2 period, GaborFinish finish, uint seed) {
    GaborImplPixel at = gabor_impl_point(p, period);
    return gabor_impl_finish(material, finish, gabor_impl_spots_pair(gabor_impl_finish_layer(0, at, finish, seed)),
                             gabor_impl_spots_pair(gabor_impl_finish_layer(1, at, finish, seed)));
}

GaborMaterial gabor_finished_filtered(GaborMaterial material, vec2 p, vec2 dx, vec2 dy, vec2 period,
                                      GaborFinish finish, uint seed) {
    GaborImplPixel at = gabor_impl_pixel_of(true, p, dx, dy, period);
    return gabor_impl_finish(material, finish, gabor_impl_filtered_spots(gabor_impl_finish_layer(0, at, finish, seed)),
                             gabor_impl_filtered_spots(gabor_impl_finish_layer(1, at, finish, seed)));
}

#endif
