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
//     paint that wears, sand or moss on top  gabor_coated or, for a filtered material, gabor_coated_filtered
//     uneven colour, gloss, dirt, dust       gabor_finished or, for a filtered material, gabor_finished_filtered
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
    float hue_variation;   // how much the boards differ in hue and saturation, 0 to 0.5
};

GaborBoards GaborBoards_of(float3 joint_colour, float board_width, float board_length, float offset, float turned_share,
        float shade_variation, float joint_width, float joint_depth, float hue_variation) {
    GaborBoards made = {joint_colour, board_width, board_length, offset, turned_share, shade_variation, joint_width,
        joint_depth, hue_variation};
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
    float2 tint;        // shift of its hue, as the logarithm of red over green, and of its saturation
    float3 joint_cover; // how much of the pixel is a joint, and the derivatives of that along x and y
    float2 to_edge;     // where the nearest edges across x and y are, seen from here, in units
};

GaborBoard GaborBoard_of(float2 position, float2 dx, float2 dy, uint seed, float2 rotation, float shade, float2 tint,
        float3 joint_cover, float2 to_edge) {
    GaborBoard made = {position, dx, dy, seed, rotation, shade, tint, joint_cover, to_edge};
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

// ---- A coat --------------------------------------------------------------------------------------------------------

// Paint, which follows the relief, wears off crests and edges, and chips; or sand, moss or snow, which fills hollows.
// The coat's surface is at `level` and varies around it; where it would be thicker than `thickness`, it is as thick.
struct GaborCoat {
    float3 coat_colour;    // colour of the coat
    float roughness;     // roughness of the coat, 0 to 1
    float level;         // height of the coat's surface, in units, -1 to 1
    float variation;     // deviation of that height from place to place, in units, 0.0001 to 1
    float patch_size;    // size of the places along x, in units, 0.05 to 10
    float patch_stretch; // length of the places along y, relative to their size, 0.2 to 10
    float raggedness;    // amplitude of finer places relative to coarser ones, 0 to 1: chips, or smooth drifts
    float thickness;     // largest thickness of the coat, in units, 0.0002 to 1
    float edge_wear;     // how much lower the coat's surface is at edges of boards, in units, 0 to 1
    float edge_width;    // width of that wear, in units, 0.01 to 1
};

GaborCoat GaborCoat_of(float3 coat_colour, float roughness, float level, float variation, float patch_size,
        float patch_stretch, float raggedness, float thickness, float edge_wear, float edge_width) {
    GaborCoat made = {coat_colour, roughness, level, variation, patch_size, patch_stretch, raggedness, thickness,
        edge_wear, edge_width};
    return made;
}

// GaborCoat gabor_coat_default()
//     Paint that starts to chip.

// GaborMaterial gabor_coated(GaborMaterial material, float2 p, float2 period, float2 to_edge, GaborCoat coat, uint seed)
// GaborMaterial gabor_coated_filtered(GaborMaterial material, float2 p, float2 dx, float2 dy, float2 period, float2 to_edge,
//                                     GaborCoat coat, uint seed)
//     The material under a coat at p, plain or filtered. `to_edge` is GaborBoard's, or float2(1000.0) without edges.
//     After gabor_laid, a coat with board.seed chips board by board, and a coat with one seed lies over all boards.

// ---- A finish ------------------------------------------------------------------------------------------------------

// Wear and dirt: brightness, hue and roughness differ from place to place, dirt lies low, dust on flat ground. And a
// grain, which appears between 150 and 300 pixels per unit if it has the default size.
struct GaborFinish {
    float3 dirt_colour;          // colour of the dirt
    float3 dust_colour;          // colour of the dust
    float patch_size;          // size of the patches that differ, in units, 0.1 to 10
    float shade_variation;     // variation of the brightness: the deviation of its logarithm, 0 to 0.5
    float hue_variation;       // variation of the hue: the deviation of the logarithm of red over green, 0 to 0.5
    float roughness_variation; // variation of the roughness: its deviation, 0 to 0.3
    float dirt_amount;         // share of the dirt where it is thickest, 0 to 1
    float dirt_height;         // height of half the dirt, in units, -1 to 1
    float dirt_depth;          // difference in height from most dirt to none, in units, 0.001 to 2
    float dust_amount;         // share of the dust where it is thickest, 0 to 1
    float grain_size;          // size of the grains along x, in units, 0.001 to 0.05
    float grain_stretch;       // length of the grains along y, relative to their size, 0.02 to 50
    float grain_contrast;      // contrast of the grains: the deviation of the logarithm of the brightness, 0 to 0.5
    float grain_height;        // deviation of the height by the grains, in units, 0 to 0.002
};

GaborFinish GaborFinish_of(float3 dirt_colour, float3 dust_colour, float patch_size, float shade_variation,
        float hue_variation, float roughness_variation, float dirt_amount, float dirt_height, float dirt_depth,
        float dust_amount, float grain_size, float grain_stretch, float grain_contrast, float grain_height) {
    GaborFinish made = {dirt_colour, dust_colour, patch_size, shade_variation, hue_variation, roughness_variation,
        dirt_amount, dirt_height, dirt_depth, dust_amount, grain_size, grain_stretch, grain_contrast, grain_height};
    return made;
}

// GaborFinish gabor_finish_default()
//     A slightly worn surface without dirt or dust.

// GaborMaterial gabor_finished(GaborMaterial material, float2 p, float2 period, GaborFinish finish, uint seed)
// GaborMaterial gabor_finished_filtered(GaborMaterial material, float2 p, float2 dx, float2 dy, float2 period,
//                                       GaborFinish finish, uint seed)
//     The material with a finish at p, plain or filtered; after gabor_laid, patches run across boards. Patches and
//     grains change no mean of colour, roughness and height, unless they clip. The mean share of dirt is the same from
//     afar if dirt_depth is the whole relief.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

GaborBoards gabor_boards_default() {
    return GaborBoards_of(float3(0.03, 0.02, 0.014), 0.5, 3.0, 0.38, 0.0, 0.3, 0.012, 0.012, 0.1);
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
    uint other = gabor_derived_seed(word, 2);
    // 32767.5 is 65535 / 2
    float2 tint = mean * boards.hue_variation * (float2(float(other & 65535u), float(other >> 16u)) / 32767.5 - 1.0);
    return GaborBoard_of(gabor_impl_product(local, back), gabor_impl_product(dx, back), gabor_impl_product(dy, back),
                      gabor_derived_seed(word, 0), turn, 1.0 - boards.shade_variation * dark, tint,
                      float3(1.0 - free.x * free.y, free.y * across.y, free.x * along.y),
                      float2(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0) * (0.5 * size - abs(local)));
}

// How the logarithms of red, green and blue change with that of red over green, while the luminance of grey stays and
// blue changes half as much as red.
float3 gabor_impl_hue() {
    // 0.7152 / 0.9639, 1 - 0.7152 / 0.9639, and 0.3576 / 0.9639
    return float3(0.7419857, -0.2580143, 0.3709928);
}

GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards) {
    float joint = board.joint_cover.x, free = 1.0 - joint;
    float2 back = float2(board.rotation.x, -board.rotation.y);
    float3 grey = (float3)(dot(material.colour, float3(0.2126, 0.7152, 0.0722)));
    float3 colour = board.shade * exp(board.tint.x * gabor_impl_hue())
                * lerp(grey, material.colour, 1.0 + 2.0 * board.tint.y);
    return GaborMaterial_of(lerp(clamp(colour, 0.0, 1.0), boards.joint_colour, joint),
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

// ---- A coat --------------------------------------------------------------------------------------------------------

GaborCoat gabor_coat_default() {
    return GaborCoat_of(float3(0.09, 0.22, 0.24), 0.45, 0.05, 0.04, 0.4, 2.0, 0.6, 0.004, 0.06, 0.06);
}

// Three octaves of the places, each 2^2.5 times as fine.
GaborImplLayer gabor_impl_coat_layer(int i, GaborImplPixel at, GaborCoat coat, uint seed) {
    float2 density = float2(1.0, 1.0 / coat.patch_stretch) / coat.patch_size * exp2(2.5 * float(i));
    float gain = coat.raggedness, square = gain * gain;
    float amplitude = (i == 0 ? 1.0 : i == 1 ? gain : square) * rsqrt(1.0 + square + square * square);
    return GaborImplLayer_of(at, density, (float2)(0.0), amplitude, gabor_derived_seed(seed, 67 + i));
}

// The mean of max(x, 0) over a normal law with this mean and deviation, and the share above 0.
float2 gabor_impl_positive(float mean, float deviation) {
    float x = mean / deviation, share = gabor_impl_below(x);
    return float2(mean * share + 0.39894228 * deviation * exp(-0.5 * min(x * x, 100.0)), share); // 1/sqrt(2 pi)
}

// The depth d of the coat's surface over the material has a mean and, over what the filter removed, a deviation. The
// coat adds clamp(d, 0, thickness), so its slope is that of the coat's surface where d is between both.
GaborMaterial gabor_impl_coat(GaborMaterial material, GaborCoat coat, GaborImplPair places, float2 to_edge, float wide) {
    float width = sqrt(coat.edge_width * coat.edge_width + wide);
    float2 worn = coat.edge_wear * coat.edge_width / width * exp(-min(abs(to_edge) / width, 40.0));
    float2 outward = float2(to_edge.x < 0.0 ? -1.0 : 1.0, to_edge.y < 0.0 ? -1.0 : 1.0);
    float depth = coat.level + coat.variation * places.second.x - worn.x - worn.y - material.height;
    float2 surface = coat.variation * places.second.yz - outward * worn / width, rise = surface - material.slope;
    float soft = 0.3 * min(coat.thickness, 0.02), removed = coat.variation * coat.variation * places.removed;
    float deviation = sqrt(soft * soft + removed);
    float2 above = gabor_impl_positive(depth, deviation), beyond = gabor_impl_positive(depth - coat.thickness, deviation);
    float share = above.y - beyond.y;
    float3 lost = lerp(material.lost, coat.variation * coat.variation * places.lost, share)
              + gabor_impl_above_variance(share, removed, soft) * gabor_impl_square(rise);
    return GaborMaterial_of(lerp(material.colour, coat.coat_colour, above.y), material.height + above.x - beyond.x,
                         material.slope + share * rise, lerp(material.roughness, coat.roughness, above.y),
                         material.metalness * (1.0 - above.y), lost);
}

GaborMaterial gabor_coated(GaborMaterial material, float2 p, float2 period, float2 to_edge, GaborCoat coat, uint seed) {
    GaborImplPixel at = gabor_impl_point(p, period);
    GaborImplPair places = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        places = gabor_impl_plus_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    return gabor_impl_coat(material, coat, places, to_edge, 0.0);
}

GaborMaterial gabor_coated_filtered(GaborMaterial material, float2 p, float2 dx, float2 dy, float2 period, float2 to_edge,
                                    GaborCoat coat, uint seed) {
    GaborImplPixel at = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPair places = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        places = gabor_impl_plus_filtered_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    return gabor_impl_coat(material, coat, places, to_edge, 0.25 * (dot(at.dx, at.dx) + dot(at.dy, at.dy)));
}

// ---- A finish ------------------------------------------------------------------------------------------------------

GaborFinish gabor_finish_default() {
    return GaborFinish_of(float3(0.03, 0.022, 0.016), float3(0.42, 0.38, 0.33), 0.5, 0.12, 0.04, 0.06, 0.0, 0.0, 0.1, 0.0,
                       0.006, 1.0, 0.1, 0.0);
}

// Patches and grains.
GaborImplLayer gabor_impl_finish_layer(int i, GaborImplPixel at, GaborFinish finish, uint seed) {
    if (i == 0) return gabor_impl_spots_layer(at, (float2)(1.0 / finish.patch_size), seed, 65);
    return gabor_impl_spots_layer(at, float2(1.0, 1.0 / finish.grain_stretch) / finish.grain_size, seed, 66);
}

// Patches: the first noise is the brightness, the second one the roughness and, with it, the hue.
GaborMaterial gabor_impl_finish(GaborMaterial material, GaborFinish finish, GaborImplPair patches,
                                GaborImplPair grain) {
    float2 shade = gabor_impl_tone(patches.first.x, patches.removed, finish.shade_variation)
               + gabor_impl_tone(grain.first.x, grain.removed, finish.grain_contrast);
    float3 hue = finish.hue_variation * gabor_impl_hue();
    float3 tint = hue * patches.second.x - 0.5 * (1.0 - patches.removed) * hue * hue; // of mean 1, as gabor_impl_tone
    float3 colour = min(material.colour * exp(shade.x + 0.5 * shade.y + tint), 1.0);
    float roughness = material.roughness + finish.roughness_variation * patches.second.x;
    float dirt = finish.dirt_amount * clamp(0.5 + (finish.dirt_height - material.height) / finish.dirt_depth, 0.0, 1.0);
    // The mean of exp(-|slope|^2) over normal slopes whose covariance has the trace steep - 1.
    float steep = 1.0 + material.lost.x + material.lost.y;
    float flatness = exp(-dot(material.slope, material.slope) / steep) / steep;
    float dust = finish.dust_amount * flatness * gabor_impl_above(patches.second, patches.removed, 0.0, 0.7).x;
    float bare = (1.0 - dirt) * (1.0 - dust);
    return GaborMaterial_of(lerp(lerp(colour, finish.dirt_colour, dirt), finish.dust_colour, dust),
                         material.height + finish.grain_height * grain.first.x,
                         material.slope + finish.grain_height * grain.first.yz,
                         lerp(0.9, clamp(roughness, 0.03, 1.0), bare), bare * material.metalness,
                         material.lost + finish.grain_height * finish.grain_height * grain.lost);
}

GaborMaterial gabor_finished(GaborMaterial material, float2 p, float2 period, GaborFinish finish, uint seed) {
    GaborImplPixel at = gabor_impl_point(p, period);
    return gabor_impl_finish(material, finish, gabor_impl_spots_pair(gabor_impl_finish_layer(0, at, finish, seed)),
                             gabor_impl_spots_pair(gabor_impl_finish_layer(1, at, finish, seed)));
}

GaborMaterial gabor_finished_filtered(GaborMaterial material, float2 p, float2 dx, float2 dy, float2 period,
                                      GaborFinish finish, uint seed) {
    GaborImplPixel at = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplLayer fine = gabor_impl_finish_layer(1, at, finish, seed);
    // The grain fades in where pixels become smaller than it.
    float4 steps = gabor_impl_radii(at, fine.density);
    float visible = 1.0 - smoothstep(0.3, 1.0, sqrt(0.5 * dot(steps, steps)));
    float3 whole = 3.2898681 * float3(fine.density * fine.density, 0.0); // pi^2 / 3
    GaborImplPair grain = GaborImplPair_of((float3)(0.0), (float3)(0.0), 1.0, whole);
    int grains = visible > 0.0 ? 1 : 0;
    for (int i = 0; i < grains; ++i) { // a loop, because drivers for CPUs run both sides of a branch
        grain = gabor_impl_filtered_spots(fine);
        float share = visible * visible;
        grain = GaborImplPair_of(visible * grain.first, visible * grain.second, 1.0 - share * (1.0 - grain.removed),
                              whole - share * (whole - grain.lost));
    }
    return gabor_impl_finish(material, finish, gabor_impl_filtered_spots(gabor_impl_finish_layer(0, at, finish, seed)),
                             grain);
}

#endif
