// Generated from gabor_compose.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl, gabor_fractal.wgsl, gabor_spectrum.wgsl, gabor_materials.wgsl.
//
// gabor_compose.wgsl: materials together, as planks and tiles, one over another, or worn.
//
//     let planks = gabor_boards_default();
//     let board = gabor_board(p, dpdx(p), dpdy(p), vec2f(0.0), planks, 7u);      // the one at p
//     var m = gabor_wood_filtered(board.position, board.dx, board.dy, board.seed);
//     m = gabor_laid(m, board, planks);
//     var sand = gabor_sand_filtered(p, dpdx(p), dpdy(p), 8u);              // a layer
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

// ---- Boards --------------------------------------------------------------------------------------------------------

// Boards in columns along y or, if they are wider than long, in rows along x.
struct GaborBoards {
    joint_colour: vec3f,  // colour of the joints
    board_width: f32,     // width of the boards along x, in units, 0.05 to 10
    board_length: f32,    // length of the boards along y, in units, 0.05 to 20
    offset: f32,          // shift of each column or row from the one before it, in boards, 0 to 1
    turned_share: f32,    // share of the boards whose material is turned by a quarter turn, 0 to 1
    shade_variation: f32, // how much darker the darkest boards are than the material, 0 to 1
    joint_width: f32,     // width of the joints, in units, 0 to 0.2
    joint_depth: f32,     // depth of the joints below height 0, in units, 0 to 0.2
    hue_variation: f32,   // how much the boards differ in hue and saturation, 0 to 0.5
}

// The board at a point.
struct GaborBoard {
    position: vec2f,    // where to evaluate its material
    dx: vec2f,          // the pixel there, for a filtered material
    dy: vec2f,
    seed: u32,          // the board's own seed for its material
    rotation: vec2f,    // cosine and sine of its turn
    shade: f32,         // factor for its colours
    tint: vec2f,        // shift of its hue, as the logarithm of red over green, and of its saturation
    joint_cover: vec3f, // how much of the pixel is a joint, and the derivatives of that along x and y
    to_edge: vec2f,     // where the nearest edges across x and y are, seen from here, in units
}

// fn gabor_boards_default() -> GaborBoards
//     Planks of half by three units.

// fn gabor_board(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, boards: GaborBoards, seed: u32) -> GaborBoard
//     The board at p. dx and dy are dpdx(p) and dpdy(p), or vec2f(0.0) without a filter: a pixel of several boards shows
//     one of them, in their mean shade. If `period` is not vec2f(0.0), the boards repeat after it: their size and shift
//     change so that whole boards fill it. Give the material itself no period.

// fn gabor_laid(material: GaborMaterial, board: GaborBoard, boards: GaborBoards) -> GaborMaterial
//     The material at board.position as part of its board: turned, with the board's shade, and with joints. `lost`
//     leaves out the slopes of joints, which are too few and too steep to widen a highlight.

// fn gabor_covered(below: GaborMaterial, above: GaborMaterial, softness: f32) -> GaborMaterial
//     The higher of two materials. Their edge is as soft as a difference in height of `softness`.

// fn gabor_worn(coat: GaborMaterial, core: GaborMaterial, softness: f32) -> GaborMaterial
//     The lower of two materials: a coat that is worn off where it stands out of the core.

// ---- A coat --------------------------------------------------------------------------------------------------------

// Paint, which follows the relief, wears off crests and edges, and chips; or sand, moss or snow, which fills hollows.
// The coat's surface is at `level` and varies around it; where it would be thicker than `thickness`, it is as thick.
struct GaborCoat {
    coat_colour: vec3f, // colour of the coat
    roughness: f32,     // roughness of the coat, 0 to 1
    level: f32,         // height of the coat's surface, in units, -1 to 1
    variation: f32,     // deviation of that height from place to place, in units, 0.0001 to 1
    patch_size: f32,    // size of the places along x, in units, 0.05 to 10
    patch_stretch: f32, // length of the places along y, relative to their size, 0.2 to 10
    raggedness: f32,    // amplitude of finer places relative to coarser ones, 0 to 1: chips, or smooth drifts
    thickness: f32,     // largest thickness of the coat, in units, 0.0002 to 1
    edge_wear: f32,     // how much lower the coat's surface is at edges of boards, in units, 0 to 1
    edge_width: f32,    // width of that wear, in units, 0.01 to 1
}

// fn gabor_coat_default() -> GaborCoat
//     Paint that starts to chip.

// fn gabor_coated(material: GaborMaterial, p: vec2f, period: vec2f, to_edge: vec2f, coat: GaborCoat, seed: u32) -> GaborMaterial
// fn gabor_coated_filtered(material: GaborMaterial, p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, vec2f to_edge, -> GaborMaterial
//                                     GaborCoat coat, u32 seed)
//     The material under a coat at p, plain or filtered. `to_edge` is GaborBoard's, or vec2f(1000.0) without edges.
//     After gabor_laid, a coat with board.seed chips board by board, and a coat with one seed lies over all boards.

// ---- A finish ------------------------------------------------------------------------------------------------------

// Wear and dirt: brightness, hue and roughness differ from place to place, dirt lies low, dust on flat ground. And a
// grain, which appears between 150 and 300 pixels per unit if it has the default size.
struct GaborFinish {
    dirt_colour: vec3f,       // colour of the dirt
    dust_colour: vec3f,       // colour of the dust
    patch_size: f32,          // size of the patches that differ, in units, 0.1 to 10
    shade_variation: f32,     // variation of the brightness: the deviation of its logarithm, 0 to 0.5
    hue_variation: f32,       // variation of the hue: the deviation of the logarithm of red over green, 0 to 0.5
    roughness_variation: f32, // variation of the roughness: its deviation, 0 to 0.3
    dirt_amount: f32,         // share of the dirt where it is thickest, 0 to 1
    dirt_height: f32,         // height of half the dirt, in units, -1 to 1
    dirt_depth: f32,          // difference in height from most dirt to none, in units, 0.001 to 2
    dust_amount: f32,         // share of the dust where it is thickest, 0 to 1
    grain_size: f32,          // size of the grains along x, in units, 0.001 to 0.05
    grain_stretch: f32,       // length of the grains along y, relative to their size, 0.02 to 50
    grain_contrast: f32,      // contrast of the grains: the deviation of the logarithm of the brightness, 0 to 0.5
    grain_height: f32,        // deviation of the height by the grains, in units, 0 to 0.002
}

// fn gabor_finish_default() -> GaborFinish
//     A slightly worn surface without dirt or dust.

// fn gabor_finished(material: GaborMaterial, p: vec2f, period: vec2f, finish: GaborFinish, seed: u32) -> GaborMaterial
// fn gabor_finished_filtered(material: GaborMaterial, p: vec2f, dx: vec2f, dy: vec2f, vec2f period, -> GaborMaterial
//                                       GaborFinish finish, u32 seed)
//     The material with a finish at p, plain or filtered; after gabor_laid, patches run across boards. Patches and
//     grains change no mean of colour, roughness and height, unless they clip. The mean share of dirt is the same from
//     afar if dirt_depth is the whole relief.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

fn gabor_boards_default() -> GaborBoards {
    return GaborBoards(vec3f(0.03, 0.02, 0.014), 0.5, 3.0, 0.38, 0.0, 0.3, 0.012, 0.012, 0.1);
}

// The share of a joint, `gap` wide, at distance x from its middle, and its derivative along x. The joint's edges are
// normal distribution functions with the standard deviation 1 / scale.
fn gabor_impl_joint(x: f32, gap: f32, scale: f32) -> vec2f {
    let t = clamp(scale * vec2f(x + 0.5 * gap, x - 0.5 * gap), vec2f(-10.0), vec2f(10.0));
    let density = exp(-0.5 * t * t);
    // 0.39894228 is 1/sqrt(2 pi)
    return vec2f(gabor_impl_below(t.x) - gabor_impl_below(t.y), 0.39894228 * scale * (density.x - density.y));
}

// The joints on both sides of a board of this size, at x from its middle, averaged over a pixel of variance `wide`.
fn gabor_impl_joints(x: f32, size: f32, gap_in: f32, wide: f32) -> vec2f {
    var gap = gap_in;
    if (gap <= 0.0) { return vec2f(0.0); }
    gap = min(gap, size);
    // Pixels wider than 0.4 of a board reach more than two joints, whose sum is nearly constant.
    let scale = inverseSqrt(0.04 * gap * gap + min(wide, 0.16 * size * size));
    return gabor_impl_joint(x - 0.5 * size, gap, scale) + gabor_impl_joint(x + 0.5 * size, gap, scale);
}

// Wraps indices to 0 ... count - 1, unless count is 0.
fn gabor_impl_board_index(index: vec2f, count: vec2f) -> vec2f {
    return select(index, index - count * floor(index / count), count.x > 0.0);
}

fn gabor_board(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, boards: GaborBoards, seed: u32) -> GaborBoard {
    var size = vec2f(boards.board_width, boards.board_length); var count = vec2f(0.0);
    let rows = size.x > size.y;
    var shift = boards.offset;
    if (period.x > 0.0) { // the shift must also fit between the last row and the first
        count = max(floor(period / size + 0.5), vec2f(1.0));
        var lines = select(count.x, count.y, rows); let rest = fract(lines * shift);
        if (abs(rest - 0.5) < 0.25) { lines += 1.0; }
        shift = floor(lines * shift + 0.5) / lines;
        count = select(vec2f(lines, count.y), vec2f(count.x, lines), rows);
        size = period / count;
    }
    var at = p / size; let line = gabor_impl_board_index(floor(at), count);
    at += select(vec2f(0.0, fract(shift * line.x)), vec2f(fract(shift * line.y), 0.0), rows);
    let cell = floor(at); let index = gabor_impl_board_index(cell, count); let local = (at - cell - 0.5) * size;
    let salt = gabor_impl_salt(seed);
    let word = gabor_impl_line_word(i32(index.x), salt) * gabor_impl_line_word(i32(index.y), salt ^ GABOR_IMPL_ROWS);
    let random = gabor_derived_seed(word, 1);
    let turn = select(vec2f(1.0, 0.0), vec2f(0.0, 1.0), f32(random & 65535u) < 65536.0 * boards.turned_share);
    let back = vec2f(turn.x, -turn.y);
    let wide = 0.25 * (dx * dx + dy * dy); // the variance of the pixel along x and y
    let boards_wide = min(wide / (size * size), vec2f(4.0));
    // 19.739209 is 2 pi^2
    let mean = exp(-19.739209 * max(boards_wide.x, boards_wide.y)); // a pixel of several boards has their mean shade
    let across = gabor_impl_joints(local.x, size.x, boards.joint_width, wide.x);
    let along = gabor_impl_joints(local.y, size.y, boards.joint_width, wide.y);
    let free = 1.0 - vec2f(across.x, along.x); // of a joint along each axis
    let dark = 0.5 + mean * (f32(random >> 16u) / 65535.0 - 0.5);
    let other = gabor_derived_seed(word, 2);
    // 32767.5 is 65535 / 2
    let tint = mean * boards.hue_variation * (vec2f(f32(other & 65535u), f32(other >> 16u)) / 32767.5 - 1.0);
    return GaborBoard(gabor_impl_product(local, back), gabor_impl_product(dx, back), gabor_impl_product(dy, back),
                      gabor_derived_seed(word, 0), turn, 1.0 - boards.shade_variation * dark, tint,
                      vec3f(1.0 - free.x * free.y, free.y * across.y, free.x * along.y),
                      vec2f(select(1.0, -1.0, local.x < 0.0), select(1.0, -1.0, local.y < 0.0)) * (0.5 * size - abs(local)));
}

// How the logarithms of red, green and blue change with that of red over green, while the luminance of grey stays and
// blue changes half as much as red.
fn gabor_impl_hue() -> vec3f {
    // 0.7152 / 0.9639, 1 - 0.7152 / 0.9639, and 0.3576 / 0.9639
    return vec3f(0.7419857, -0.2580143, 0.3709928);
}

fn gabor_laid(material: GaborMaterial, board: GaborBoard, boards: GaborBoards) -> GaborMaterial {
    let joint = board.joint_cover.x; let free = 1.0 - joint;
    let back = vec2f(board.rotation.x, -board.rotation.y);
    let grey = vec3f(dot(material.colour, vec3f(0.2126, 0.7152, 0.0722)));
    let colour = board.shade * exp(board.tint.x * gabor_impl_hue())
                * mix(grey, material.colour, 1.0 + 2.0 * board.tint.y);
    return GaborMaterial(mix(clamp(colour, vec3f(0.0), vec3f(1.0)), boards.joint_colour, joint),
                         free * material.height - joint * boards.joint_depth,
                         free * gabor_impl_product(material.slope, board.rotation)
                             - (material.height + boards.joint_depth) * board.joint_cover.yz,
                         mix(material.roughness, max(material.roughness, 0.8), joint), free * material.metalness,
                         free * gabor_impl_turned_square(material.lost, back, board.rotation.yx));
}

// The higher of two materials if `side` is 1, the lower if it is -1. In this smooth maximum the derivatives have the
// same shares as the materials: over a difference d from -s to s, it grows by (d + s)^2 / (4 s).
fn gabor_impl_outer(a: GaborMaterial, b: GaborMaterial, softness: f32, side: f32) -> GaborMaterial {
    let d = side * (b.height - a.height) / max(softness, 1.0e-6); let edge = max(1.0 - abs(d), 0.0);
    let share = clamp(0.5 + 0.5 * d, 0.0, 1.0); let height = max(side * a.height, side * b.height);
    return GaborMaterial(mix(a.colour, b.colour, share), side * (height + 0.25 * softness * edge * edge),
                         mix(a.slope, b.slope, share), mix(a.roughness, b.roughness, share),
                         mix(a.metalness, b.metalness, share), mix(a.lost, b.lost, share));
}

fn gabor_covered(below: GaborMaterial, above: GaborMaterial, softness: f32) -> GaborMaterial {
    return gabor_impl_outer(below, above, softness, 1.0);
}

fn gabor_worn(coat: GaborMaterial, core: GaborMaterial, softness: f32) -> GaborMaterial {
    return gabor_impl_outer(coat, core, softness, -1.0);
}

// ---- A coat --------------------------------------------------------------------------------------------------------

fn gabor_coat_default() -> GaborCoat {
    return GaborCoat(vec3f(0.09, 0.22, 0.24), 0.45, 0.05, 0.04, 0.4, 2.0, 0.6, 0.004, 0.06, 0.06);
}

// Three octaves of the places, each 2^2.5 times as fine.
fn gabor_impl_coat_layer(i: i32, at: GaborImplPixel, coat: GaborCoat, seed: u32) -> GaborImplLayer {
    let density = vec2f(1.0, 1.0 / coat.patch_stretch) / coat.patch_size * exp2(2.5 * f32(i));
    let gain = coat.raggedness; let square = gain * gain;
    let amplitude = select(select(square, gain, i == 1), 1.0, i == 0) * inverseSqrt(1.0 + square + square * square);
    return GaborImplLayer(at, density, vec2f(0.0), amplitude, gabor_derived_seed(seed, 67 + i));
}

// The mean of max(x, 0) over a normal law with this mean and deviation, and the share above 0.
fn gabor_impl_positive(mean: f32, deviation: f32) -> vec2f {
    let x = mean / deviation; let share = gabor_impl_below(x);
    return vec2f(mean * share + 0.39894228 * deviation * exp(-0.5 * min(x * x, 100.0)), share); // 1/sqrt(2 pi)
}

// The depth d of the coat's surface over the material has a mean and, over what the filter removed, a deviation. The
// coat adds clamp(d, 0, thickness), so its slope is that of the coat's surface where d is between both.
fn gabor_impl_coat(material: GaborMaterial, coat: GaborCoat, places: GaborImplPair, to_edge: vec2f, wide: f32) -> GaborMaterial {
    let width = sqrt(coat.edge_width * coat.edge_width + wide);
    let worn = coat.edge_wear * coat.edge_width / width * exp(-min(abs(to_edge) / width, vec2f(40.0)));
    let outward = vec2f(select(1.0, -1.0, to_edge.x < 0.0), select(1.0, -1.0, to_edge.y < 0.0));
    let depth = coat.level + coat.variation * places.second.x - worn.x - worn.y - material.height;
    let surface = coat.variation * places.second.yz - outward * worn / width; let rise = surface - material.slope;
    let soft = 0.3 * min(coat.thickness, 0.02); let removed = coat.variation * coat.variation * places.removed;
    let deviation = sqrt(soft * soft + removed);
    let above = gabor_impl_positive(depth, deviation);
    let beyond = gabor_impl_positive(depth - coat.thickness, deviation);
    let share = above.y - beyond.y;
    let lost = mix(material.lost, coat.variation * coat.variation * places.lost, share)
              + gabor_impl_above_variance(share, removed, soft) * gabor_impl_square(rise);
    return GaborMaterial(mix(material.colour, coat.coat_colour, above.y), material.height + above.x - beyond.x,
                         material.slope + share * rise, mix(material.roughness, coat.roughness, above.y),
                         material.metalness * (1.0 - above.y), lost);
}

fn gabor_coated(material: GaborMaterial, p: vec2f, period: vec2f, to_edge: vec2f, coat: GaborCoat, seed: u32) -> GaborMaterial {
    let at = gabor_impl_point(p, period);
    var places = gabor_impl_no_pair();
    for (var i = 0; i < 3; i++) {
        places = gabor_impl_plus_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    }
    return gabor_impl_coat(material, coat, places, to_edge, 0.0);
}

fn gabor_coated_filtered(material: GaborMaterial, p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, to_edge: vec2f,
                         coat: GaborCoat, seed: u32) -> GaborMaterial {
    let at = gabor_impl_pixel_of(true, p, dx, dy, period);
    var places = gabor_impl_no_pair();
    for (var i = 0; i < 3; i++) {
        places = gabor_impl_plus_filtered_octave(places, gabor_impl_coat_layer(i, at, coat, seed));
    }
    return gabor_impl_coat(material, coat, places, to_edge, 0.25 * (dot(at.dx, at.dx) + dot(at.dy, at.dy)));
}

// ---- A finish ------------------------------------------------------------------------------------------------------

fn gabor_finish_default() -> GaborFinish {
    return GaborFinish(vec3f(0.03, 0.022, 0.016), vec3f(0.42, 0.38, 0.33), 0.5, 0.12, 0.04, 0.06, 0.0, 0.0, 0.1, 0.0,
                       0.006, 1.0, 0.1, 0.0);
}

// Patches and grains.
fn gabor_impl_finish_layer(i: i32, at: GaborImplPixel, finish: GaborFinish, seed: u32) -> GaborImplLayer {
    if (i == 0) { return gabor_impl_spots_layer(at, vec2f(1.0 / finish.patch_size), seed, 65); }
    return gabor_impl_spots_layer(at, vec2f(1.0, 1.0 / finish.grain_stretch) / finish.grain_size, seed, 66);
}

// Patches: the first noise is the brightness, the second one the roughness and, with it, the hue.
fn gabor_impl_finish(material: GaborMaterial, finish: GaborFinish, patches: GaborImplPair, grain: GaborImplPair) -> GaborMaterial {
    let shade = gabor_impl_tone(patches.first.x, patches.removed, finish.shade_variation)
               + gabor_impl_tone(grain.first.x, grain.removed, finish.grain_contrast);
    let hue = finish.hue_variation * gabor_impl_hue();
    let tint = hue * patches.second.x - 0.5 * (1.0 - patches.removed) * hue * hue; // of mean 1, as gabor_impl_tone
    let colour = min(material.colour * exp(shade.x + 0.5 * shade.y + tint), vec3f(1.0));
    let roughness = material.roughness + finish.roughness_variation * patches.second.x;
    let dirt = finish.dirt_amount * clamp(0.5 + (finish.dirt_height - material.height) / finish.dirt_depth, 0.0, 1.0);
    // The mean of exp(-|slope|^2) over normal slopes whose covariance has the trace steep - 1.
    let steep = 1.0 + material.lost.x + material.lost.y;
    let flatness = exp(-dot(material.slope, material.slope) / steep) / steep;
    let dust = finish.dust_amount * flatness * gabor_impl_above(patches.second, patches.removed, 0.0, 0.7).x;
    let bare = (1.0 - dirt) * (1.0 - dust);
    return GaborMaterial(mix(mix(colour, finish.dirt_colour, dirt), finish.dust_colour, dust),
                         material.height + finish.grain_height * grain.first.x,
                         material.slope + finish.grain_height * grain.first.yz,
                         mix(0.9, clamp(roughness, 0.03, 1.0), bare), bare * material.metalness,
                         material.lost + finish.grain_height * finish.grain_height * grain.lost);
}

fn gabor_finished(material: GaborMaterial, p: vec2f, period: vec2f, finish: GaborFinish, seed: u32) -> GaborMaterial {
    let at = gabor_impl_point(p, period);
    return gabor_impl_finish(material, finish, gabor_impl_spots_pair(gabor_impl_finish_layer(0, at, finish, seed)),
                             gabor_impl_spots_pair(gabor_impl_finish_layer(1, at, finish, seed)));
}

fn gabor_finished_filtered(material: GaborMaterial, p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, finish: GaborFinish,
                           seed: u32) -> GaborMaterial {
    let at = gabor_impl_pixel_of(true, p, dx, dy, period);
    let fine = gabor_impl_finish_layer(1, at, finish, seed);
    // The grain fades in where pixels become smaller than it.
    let steps = gabor_impl_radii(at, fine.density);
    let visible = 1.0 - smoothstep(0.3, 1.0, sqrt(0.5 * dot(steps, steps)));
    let whole = 3.2898681 * vec3f(fine.density * fine.density, 0.0); // pi^2 / 3
    var grain = GaborImplPair(vec3f(0.0), vec3f(0.0), 1.0, whole);
    let grains = select(0, 1, visible > 0.0);
    for (var i = 0; i < grains; i++) { // a loop, because drivers for CPUs run both sides of a branch
        grain = gabor_impl_filtered_spots(fine);
        let share = visible * visible;
        grain = GaborImplPair(visible * grain.first, visible * grain.second, 1.0 - share * (1.0 - grain.removed),
                              whole - share * (whole - grain.lost));
    }
    return gabor_impl_finish(material, finish, gabor_impl_filtered_spots(gabor_impl_finish_layer(0, at, finish, seed)),
                             grain);
}
