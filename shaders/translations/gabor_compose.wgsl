// Generated from gabor_compose.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 40e25ed72c77d58c.
// Paste it after gabor_noise.wgsl, gabor_spectrum.wgsl, gabor_filter.wgsl, gabor_materials.wgsl.
//
// gabor_compose.wgsl: materials together, as planks and tiles, one over another, or worn.
//
// Paste or include this file after gabor_noise.wgsl, gabor_spectrum.wgsl, gabor_filter.wgsl for filtered materials, and
// gabor_materials.wgsl.
//
//     GaborBoards planks = gabor_boards_default();
//     GaborBoard board = gabor_board(p, dpdx(p), dpdy(p), vec2f(0.0), planks, 7u);      // the one at p
//     GaborMaterial m = gabor_wood_filtered(board.p, board.dx, board.dy, board.seed);
//     m = gabor_laid(m, board, planks);
//     GaborMaterial sand = gabor_sand_filtered(p, dpdx(p), dpdy(p), 8u);              // a layer
//     sand.height = 0.2 * sand.height - 0.015;                                         // so low that it lies in joints
//     m = gabor_covered(m, sand, 0.005);
//
//     I want                                 call
//     planks, tiles, bricks or cobbles       gabor_board, then any material at board.p, then gabor_laid
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

// ---- Boards --------------------------------------------------------------------------------------------------------

// Boards in columns along y or, if they are wider than long, in rows along x.
struct GaborBoards {
    joint_colour: vec3<f32>, // colour of the joints
    board_width: f32, // width of the boards along x, in units, 0.05 to 10
    board_length: f32, // length of the boards along y, in units, 0.05 to 20
    offset: f32, // shift of each column or row from the one before it, in boards, 0 to 1
    turned_share: f32, // share of the boards whose material is turned by a quarter turn, 0 to 1
    shade_variation: f32, // how much darker the darkest boards are than the material, 0 to 1
    joint_width: f32, // width of the joints, in units, 0 to 0.2
    joint_depth: f32, // depth of the joints below height 0, in units, 0 to 0.2
}

// The board at a point.
struct GaborBoard {
    p: vec2<f32>, // where to evaluate its material
    dx: vec2<f32>, // the pixel there, for a filtered material
    dy: vec2<f32>,
    seed: u32, // the board's own seed for its material
    rotation: vec2<f32>, // cosine and sine of its turn
    shade: f32, // factor for its colours
    joint_cover: vec3<f32>, // how much of the pixel is a joint, and the derivatives of that along x and y
}

// GaborBoards gabor_boards_default()
//     Planks of half by three units.

// GaborBoard gabor_board(vec2f p, vec2f dx, vec2f dy, vec2f period, GaborBoards boards, u32 seed)
//     The board at p. dx and dy are dpdx(p) and dpdy(p), or vec2f(0.0) without a filter: a pixel of several boards shows
//     one of them, in their mean shade. If `period` is not vec2f(0.0), the boards repeat after it: their size and shift
//     change so that whole boards fill it. Give the material itself no period.

// GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards)
//     The material at board.p as part of its board: turned, with the board's shade, and with joints. `lost` leaves out
//     the slopes of joints, which are too few and too steep to widen a highlight.

// GaborMaterial gabor_covered(GaborMaterial below, GaborMaterial above, f32 softness)
//     The higher of two materials. Their edge is as soft as a difference in height of `softness`.

// GaborMaterial gabor_worn(GaborMaterial coat, GaborMaterial core, f32 softness)
//     The lower of two materials: a coat that is worn off where it stands out of the core.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

fn gabor_boards_default() -> GaborBoards {
    return GaborBoards(vec3<f32>(0.03f, 0.02f, 0.014f), 0.5f, 3f, 0.38f, 0f, 0.3f, 0.012f, 0.012f);
}

// The share of a joint, `gap` wide, at distance x from its middle, and its derivative along x. The joint's edges are
// normal distribution functions with the standard deviation 1 / scale.
fn gabor_impl_joint(x: f32, gap: f32, scale: f32) -> vec2<f32> {
    var t_12: vec2<f32>;
    var density_9: vec2<f32>;
    t_12 = clamp((scale * vec2<f32>((x + (0.5f * gap)), (x - (0.5f * gap)))), vec2(-10f), vec2(10f));
    let _e20 = t_12;
    let _e22 = t_12;
    density_9 = exp(((-0.5f * _e20) * _e22));
    let _e26 = t_12;
    let _e28 = gabor_impl_below(_e26.x);
    let _e29 = t_12;
    let _e31 = gabor_impl_below(_e29.y);
    let _e35 = density_9;
    let _e37 = density_9;
    return vec2<f32>((_e28 - _e31), ((0.3989423f * scale) * (_e35.x - _e37.y)));
}

// The joints on both sides of a board of this size, at x from its middle, averaged over a pixel of variance `wide`.
fn gabor_impl_joints(x: f32, size: f32, gap: f32, wide: f32) -> vec2<f32> {
    var gap_2: f32;
    var scale_7: f32;
    gap_2 = gap;
    let _e5 = gap_2;
    if (_e5 <= 0f) {
        return vec2(0f);
    }
    let _e10 = gap_2;
    gap_2 = min(_e10, size);
    let _e13 = gap_2;
    let _e15 = gap_2;
    scale_7 = inverseSqrt((((0.04f * _e13) * _e15) + min(wide, ((0.16f * size) * size))));
    let _e27 = gap_2;
    let _e28 = scale_7;
    let _e29 = gabor_impl_joint((x - (0.5f * size)), _e27, _e28);
    let _e33 = gap_2;
    let _e34 = scale_7;
    let _e35 = gabor_impl_joint((x + (0.5f * size)), _e33, _e34);
    return (_e29 + _e35);
}

// Wraps indices to 0 ... count - 1, unless count is 0.
fn gabor_impl_board_index(index: vec2<f32>, count: vec2<f32>) -> vec2<f32> {
    var local_83: vec2<f32>;
    if (count.x > 0f) {
        local_83 = (index - (count * floor((index / count))));
    } else {
        local_83 = index;
    }
    let _e10 = local_83;
    return _e10;
}

fn gabor_board(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, boards: GaborBoards, seed: u32) -> GaborBoard {
    var size_5: vec2<f32>;
    var count_14: vec2<f32> = vec2(0f);
    var rows_5: bool;
    var shift: f32;
    var local_84: f32;
    var lines: f32;
    var rest: f32;
    var local_85: vec2<f32>;
    var at_18: vec2<f32>;
    var line_6: vec2<f32>;
    var local_86: vec2<f32>;
    var cell_5: vec2<f32>;
    var index_15: vec2<f32>;
    var local_87: vec2<f32>;
    var salt_16: u32;
    var word_6: u32;
    var random: u32;
    var local_88: vec2<f32>;
    var turn_16: vec2<f32>;
    var back_1: vec2<f32>;
    var wide_3: vec2<f32>;
    var boards_wide: vec2<f32>;
    var mean_9: f32;
    var across_4: vec2<f32>;
    var along_4: vec2<f32>;
    var free: vec2<f32>;
    var dark_2: f32;
    size_5 = vec2<f32>(boards.board_width, boards.board_length);
    let _e13 = size_5;
    let _e15 = size_5;
    rows_5 = (_e13.x > _e15.y);
    shift = boards.offset;
    if (period.x > 0f) {
        {
            let _e24 = size_5;
            count_14 = max(floor(((period / _e24) + vec2(0.5f))), vec2(1f));
            let _e33 = rows_5;
            if _e33 {
                let _e34 = count_14;
                local_84 = _e34.y;
            } else {
                let _e36 = count_14;
                local_84 = _e36.x;
            }
            let _e39 = local_84;
            lines = _e39;
            let _e41 = lines;
            let _e42 = shift;
            rest = fract((_e41 * _e42));
            let _e46 = rest;
            if (abs((_e46 - 0.5f)) < 0.25f) {
                let _e52 = lines;
                lines = (_e52 + 1f);
            }
            let _e55 = lines;
            let _e56 = shift;
            let _e61 = lines;
            shift = (floor(((_e55 * _e56) + 0.5f)) / _e61);
            let _e63 = rows_5;
            if _e63 {
                let _e64 = count_14;
                let _e66 = lines;
                local_85 = vec2<f32>(_e64.x, _e66);
            } else {
                let _e68 = lines;
                let _e69 = count_14;
                local_85 = vec2<f32>(_e68, _e69.y);
            }
            let _e73 = local_85;
            count_14 = _e73;
            let _e74 = count_14;
            size_5 = (period / _e74);
        }
    }
    let _e76 = size_5;
    at_18 = (p / _e76);
    let _e79 = at_18;
    let _e81 = count_14;
    let _e82 = gabor_impl_board_index(floor(_e79), _e81);
    line_6 = _e82;
    let _e84 = at_18;
    let _e85 = rows_5;
    if _e85 {
        let _e86 = shift;
        let _e87 = line_6;
        local_86 = vec2<f32>(fract((_e86 * _e87.y)), 0f);
    } else {
        let _e94 = shift;
        let _e95 = line_6;
        local_86 = vec2<f32>(0f, fract((_e94 * _e95.x)));
    }
    let _e101 = local_86;
    at_18 = (_e84 + _e101);
    let _e103 = at_18;
    cell_5 = floor(_e103);
    let _e106 = cell_5;
    let _e107 = count_14;
    let _e108 = gabor_impl_board_index(_e106, _e107);
    index_15 = _e108;
    let _e110 = at_18;
    let _e111 = cell_5;
    let _e116 = size_5;
    local_87 = (((_e110 - _e111) - vec2(0.5f)) * _e116);
    let _e119 = gabor_impl_salt(seed);
    salt_16 = _e119;
    let _e121 = index_15;
    let _e124 = salt_16;
    let _e125 = gabor_impl_line_word(i32(_e121.x), _e124);
    let _e126 = index_15;
    let _e129 = salt_16;
    let _e132 = gabor_impl_line_word(i32(_e126.y), (_e129 ^ 1540483477u));
    word_6 = (_e125 * _e132);
    let _e135 = word_6;
    let _e137 = gabor_derived_seed(_e135, 1i);
    random = _e137;
    let _e139 = random;
    if (f32((_e139 & 65535u)) < (65536f * boards.turned_share)) {
        local_88 = vec2<f32>(0f, 1f);
    } else {
        local_88 = vec2<f32>(1f, 0f);
    }
    let _e154 = local_88;
    turn_16 = _e154;
    let _e156 = turn_16;
    let _e158 = turn_16;
    back_1 = vec2<f32>(_e156.x, -(_e158.y));
    wide_3 = (0.25f * ((dx * dx) + (dy * dy)));
    let _e169 = wide_3;
    let _e170 = size_5;
    let _e171 = size_5;
    boards_wide = min((_e169 / (_e170 * _e171)), vec2(4f));
    let _e180 = boards_wide;
    let _e182 = boards_wide;
    mean_9 = exp((-19.739208f * max(_e180.x, _e182.y)));
    let _e188 = local_87;
    let _e190 = size_5;
    let _e193 = wide_3;
    let _e195 = gabor_impl_joints(_e188.x, _e190.x, boards.joint_width, _e193.x);
    across_4 = _e195;
    let _e197 = local_87;
    let _e199 = size_5;
    let _e202 = wide_3;
    let _e204 = gabor_impl_joints(_e197.y, _e199.y, boards.joint_width, _e202.y);
    along_4 = _e204;
    let _e207 = across_4;
    let _e209 = along_4;
    free = (vec2(1f) - vec2<f32>(_e207.x, _e209.x));
    let _e216 = mean_9;
    let _e217 = random;
    dark_2 = (0.5f + (_e216 * ((f32((_e217 >> 16u)) / 65535f) - 0.5f)));
    let _e228 = local_87;
    let _e229 = back_1;
    let _e230 = gabor_impl_product(_e228, _e229);
    let _e231 = back_1;
    let _e232 = gabor_impl_product(dx, _e231);
    let _e233 = back_1;
    let _e234 = gabor_impl_product(dy, _e233);
    let _e235 = word_6;
    let _e237 = gabor_derived_seed(_e235, 0i);
    let _e238 = turn_16;
    let _e241 = dark_2;
    let _e245 = free;
    let _e247 = free;
    let _e251 = free;
    let _e253 = across_4;
    let _e256 = free;
    let _e258 = along_4;
    return GaborBoard(_e230, _e232, _e234, _e237, _e238, (1f - (boards.shade_variation * _e241)), vec3<f32>((1f - (_e245.x * _e247.y)), (_e251.y * _e253.y), (_e256.x * _e258.y)));
}

fn gabor_laid(material: GaborMaterial, board: GaborBoard, boards: GaborBoards) -> GaborMaterial {
    var joint: f32;
    var free_1: f32;
    var back_2: vec2<f32>;
    joint = board.joint_cover.x;
    let _e7 = joint;
    free_1 = (1f - _e7);
    back_2 = vec2<f32>(board.rotation.x, -(board.rotation.y));
    let _e21 = joint;
    let _e24 = free_1;
    let _e27 = joint;
    let _e31 = free_1;
    let _e34 = gabor_impl_product(material.slope, board.rotation);
    let _e47 = joint;
    let _e49 = free_1;
    let _e52 = free_1;
    let _e54 = back_2;
    let _e57 = gabor_impl_turned_square(material.lost, _e54, board.rotation.yx);
    return GaborMaterial(mix((board.shade * material.colour), boards.joint_colour, vec3(_e21)), ((_e24 * material.height) - (_e27 * boards.joint_depth)), ((_e31 * _e34) - ((material.height + boards.joint_depth) * board.joint_cover.yz)), mix(material.roughness, max(material.roughness, 0.8f), _e47), (_e49 * material.metalness), (_e52 * _e57));
}

// The higher of two materials if `side` is 1, the lower if it is -1. In this smooth maximum the derivatives have the
// same shares as the materials: over a difference d from -s to s, it grows by (d + s)^2 / (4 s).
fn gabor_impl_outer(a: GaborMaterial, b: GaborMaterial, softness: f32, side: f32) -> GaborMaterial {
    var d_8: f32;
    var edge_3: f32;
    var share_1: f32;
    var height_11: f32;
    d_8 = ((side * (b.height - a.height)) / max(softness, 0.000001f));
    let _e13 = d_8;
    edge_3 = max((1f - abs(_e13)), 0f);
    let _e21 = d_8;
    share_1 = clamp((0.5f + (0.5f * _e21)), 0f, 1f);
    height_11 = max((side * a.height), (side * b.height));
    let _e36 = share_1;
    let _e39 = height_11;
    let _e42 = edge_3;
    let _e44 = edge_3;
    let _e50 = share_1;
    let _e55 = share_1;
    let _e59 = share_1;
    let _e63 = share_1;
    return GaborMaterial(mix(a.colour, b.colour, vec3(_e36)), (side * (_e39 + (((0.25f * softness) * _e42) * _e44))), mix(a.slope, b.slope, vec2(_e50)), mix(a.roughness, b.roughness, _e55), mix(a.metalness, b.metalness, _e59), mix(a.lost, b.lost, vec3(_e63)));
}

fn gabor_covered(below: GaborMaterial, above: GaborMaterial, softness: f32) -> GaborMaterial {
    let _e4 = gabor_impl_outer(below, above, softness, 1f);
    return _e4;
}

fn gabor_worn(coat: GaborMaterial, core: GaborMaterial, softness: f32) -> GaborMaterial {
    let _e5 = gabor_impl_outer(coat, core, softness, -1f);
    return _e5;
}

