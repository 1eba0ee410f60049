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
//     paint that wears, sand or moss on top  gabor_coated or, for a filtered material, gabor_coated_filtered
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
    float hue_variation;   // how much the boards differ in hue and saturation, 0 to 0.5
};

// The board at a point.
struct GaborBoard {
    vec2 position;    // where to evaluate its material
    vec2 dx;          // the pixel there, for a filtered material
    vec2 dy;
    uint seed;        // the board's own seed for its material
    vec2 rotation;    // cosine and sine of its turn
    float shade;      // factor for its colours
    vec2 tint;        // shift of its hue, as the logarithm of red over green, and of its saturation
    vec3 joint_cover; // how much of the pixel is a joint, and the derivatives of that along x and y
    vec2 to_edge;     // where the nearest edges across x and y are, seen from here, in units
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

// ---- A coat --------------------------------------------------------------------------------------------------------

// Paint, which follows the relief, wears off crests and edges, and chips; or sand, moss or snow, which fills hollows.
// The coat's surface is at `level` and varies around it; where it would be thicker than `thickness`, it is as thick.
struct GaborCoat {
    vec3 coat_colour;    // colour of the coat
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

// GaborCoat gabor_coat_default()
//     Paint that starts to chip.

// GaborMaterial gabor_coated(GaborMaterial material, vec2 p, vec2 period, vec2 to_edge, GaborCoat coat, uint seed)
// GaborMaterial gabor_coated_filtered(GaborMaterial material, vec2 p, vec2 dx, vec2 dy, vec2 period, vec2 to_edge,
//                                     GaborCoat coat, uint seed)
//     The material under a coat at p, plain or filtered. `to_edge` is GaborBoard's, or vec2(1000.0) without edges.
//     After gabor_laid, a coat with board.seed chips board by board, and a coat with one seed lies over all boards.

// ---- A finish ------------------------------------------------------------------------------------------------------

// Wear and dirt: brightness, hue and roughness differ from place to place, dirt lies low, dust on flat ground. And a
// grain, which appears between 150 and 300 pixels per unit if it has the default size.
struct GaborFinish {
    vec3 dirt_colour;          // colour of the dirt
    vec3 dust_colour;          // colour of the dust
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
    return GaborBoards(vec3(0.03, 0.02, 0.014), 0.5, 3.0, 0.38, 0.0, 0.3, 0.012, 0.012, 0.1);
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
    uint other = gabor_derived_seed(word, 2);
    // 32767.5 is 65535 / 2
    vec2 tint = mean * boards.hue_variation * (vec2(float(other & 65535u), float(other >> 16u)) / 32767.5 - 1.0);
    return GaborBoard(gabor_impl_product(local, back), gabor_impl_product(dx, back), gabor_impl_product(dy, back),
                      gabor_derived_seed(word, 0), turn, 1.0 - boards.shade_variation * dark, tint,
                      vec3(1.0 - free.x * free.y, free.y * across.y, free.x * along.y),
                      vec2(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0) * (0.5 * size - abs(local)));
}

// How the logarithms of red, green and blue change with that of red over green, while the luminance of grey stays and
// blue changes half as much as red.
vec3 gabor_impl_hue() {
    // 0.7152 / 0.9639, 1 - 0.7152 / 0.9639, and 0.3576 / 0.9639
    return vec3(0.7419857, -0.2580143, 0.3709928);
}

GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards) {
    float joint = board.joint_cover.x, free = 1.0 - joint;
    vec2 back = vec2(board.rotation.x, -board.rotation.y);
    vec3 grey = vec3(dot(material.colour, vec3(0.2126, 0.7152, 0.0722)));
    vec3 colour = board.shade * exp(board.tint.x * gabor_impl_hue())
                * mix(grey, material.colour, 1.0 + 2.0 * board.tint.y);
    return GaborMaterial(mix(clamp(colour, 0.0, 1.0), boards.joint_colour, joint),
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

// ---- A coat --------------------------------------------------------------------------------------------------------

GaborCoat gabor_coat_default() {
    return GaborCoat(vec3(0.09, 0.22, 0.24), 0.45, 0.05, 0.04, 0.4, 2.0, 0.6, 0.004, 0.06, 0.06);
}

// Three octaves of the places, each 2^2.5 times as fine.
GaborImplLayer gabor_impl_coat_layer(int i, GaborImplPixel at, GaborCoat coat, uint seed) {
    vec2 density = vec2(1.0, 1.0 / coat.patch_stretch) / coat.patch_size * exp2(2.5 * float(i));
    float gain = coat.raggedness, square = gain * gain;
    float amplitude = (i == 0 ? 1.0 : i == 1 ? gain : square) * inversesqrt(1.0 + square + square * square);
    return GaborImplLayer(at, density, vec2(0.0), amplitude, gabor_derived_seed(seed, 67 + i));
}

// The mean of max(x, 0) over a normal law with this mean and deviation, and the share above 0.
vec2 gabor_impl_positive(float mean, float deviation) {
    float x = mean / deviation, share = gabor_impl_below(x);
    return vec2(mean * share + 0.39894228 * deviation * exp(-0.5 * min(x * x, 100.0)), share); // 1/sqrt(2 pi)
}

// The depth d of the coat's surface over the material has a mean and, over what the filter removed, a deviation. The
// coat adds clamp(d, 0, thickness), so its slope is that of the coat's surface where d is between both.
GaborMaterial gabor_impl_coat(GaborMaterial material, GaborCoat coat, GaborImplPair places, vec2 to_edge, float wide) {
    float width = sqrt(coat.edge_width * coat.edge_width + wide);
    vec2 worn = coat.edge_wear * coat.edge_width / width * exp(-min(abs(to_edge) / width, 40.0));
    vec2 outward = vec2(to_edge.x < 0.0 ? -1.0 : 1.0, to_edge.y < 0.0 ? -1.0 : 1.0);
    float depth = coat.level + coat.variation * places.second.x - worn.x - worn.y - material.height;
    vec2 surface = coat.variation * places.second.yz - outward * worn / width, rise = surface - material.slope;
    float soft = 0.3 * min(coat.thickness, 0.02), removed = coat.variation * coat.variation * places.removed;
    float deviation = sqrt(soft * soft + removed);
    vec2 above = gabor_impl_positive(depth, deviation), beyond = gabor_impl_positive(depth - coat.thickness, deviation);
    float share = above.y - beyond.y;
    vec3 lost = mix(material.lost, coat.variation * coat.variation * places.lost, share)
              + gabor_impl_above_variance(share, removed, soft) * gabor_impl_square(rise);
    return GaborMaterial(mix(material.colour, coat.coat_colour, above.y), material.height + above.x - beyond.x,
                         material.slope + share * rise, mix(material.roughness, coat.roughness, above.y),
                         material.metalness * (1.0 - above.y), lost);
}

GaborMaterial gabor_coated(GaborMaterial material, vec2 p, vec2 period, vec2 to_edge, GaborCoat coat, uint seed) {
    GaborImplPixel at = gabor_impl_point(p, period);
    GaborImplPair places = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        places = gabor_impl_plus_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    return gabor_impl_coat(material, coat, places, to_edge, 0.0);
}

GaborMaterial gabor_coated_filtered(GaborMaterial material, vec2 p, vec2 dx, vec2 dy, vec2 period, vec2 to_edge,
                                    GaborCoat coat, uint seed) {
    GaborImplPixel at = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPair places = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        places = gabor_impl_plus_filtered_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    return gabor_impl_coat(material, coat, places, to_edge, 0.25 * (dot(at.dx, at.dx) + dot(at.dy, at.dy)));
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

// Patches: the first noise is the brightness, the second one the roughness and, with it, the hue.
GaborMaterial gabor_impl_finish(GaborMaterial material, GaborFinish finish, GaborImplPair patches,
                                GaborImplPair grain) {
    vec2 shade = gabor_impl_tone(patches.first.x, patches.removed, finish.shade_variation)
               + gabor_impl_tone(grain.first.x, grain.removed, finish.grain_contrast);
    vec3 hue = finish.hue_variation * gabor_impl_hue();
    vec3 tint = hue * patches.second.x - 0.5 * (1.0 - patches.removed) * hue * hue; // of mean 1, as gabor_impl_tone
    vec3 colour = min(material.colour * exp(shade.x + 0.5 * shade.y + tint), 1.0);
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
    GaborImplLayer fine = gabor_impl_finish_layer(1, at, finish, seed);
    // The grain fades in where pixels become smaller than it.
    vec4 steps = gabor_impl_radii(at, fine.density);
    float visible = 1.0 - smoothstep(0.3, 1.0, sqrt(0.5 * dot(steps, steps)));
    vec3 whole = 3.2898681 * vec3(fine.density * fine.density, 0.0); // pi^2 / 3
    GaborImplPair grain = GaborImplPair(vec3(0.0), vec3(0.0), 1.0, whole);
    int grains = visible > 0.0 ? 1 : 0;
    for (int i = 0; i < grains; ++i) { // a loop, because drivers for CPUs run both sides of a branch
        grain = gabor_impl_filtered_spots(fine);
        float share = visible * visible;
        grain = GaborImplPair(visible * grain.first, visible * grain.second, 1.0 - share * (1.0 - grain.removed),
                              whole - share * (whole - grain.lost));
    }
    return gabor_impl_finish(material, finish, gabor_impl_filtered_spots(gabor_impl_finish_layer(0, at, finish, seed)),
                             grain);
}

#endif
