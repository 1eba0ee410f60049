// Generated from gabor_compose.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 62a6f00ab6288058.
//
// gabor_compose.wgsl: materials together, as planks and tiles, one over another, or worn.
//
// Paste or include this file after gabor_materials.wgsl.
//
//     GaborBoards planks = gabor_boards_default();
//     GaborBoard board = gabor_board(p, dFdx(p), dFdy(p), vec2f(0.0), planks, 7u);      // the one at p
//     GaborMaterial m = gabor_wood_filtered(board.p, board.dx, board.dy, board.seed);
//     m = gabor_laid(m, board, planks);
//     GaborMaterial dusty = gabor_covered(m, gabor_sand(p, 8u), 0.02);                 // sand where it lies above m
//     GaborMaterial rubbed = gabor_worn(m, gabor_brushed_metal(p, 8u), 0.01);          // metal where m stands out
//
//     I want                                 call
//     planks, tiles, bricks or cobbles       gabor_board, then any material at board.p, then gabor_laid
//     moss, snow or sand that fills hollows  gabor_covered(below, above, softness)
//     edges and crests that are rubbed off   gabor_worn(coat, core, softness)
//     more or less of it in places           add a mask to a material's height, and the mask's gradient to its slope
//     no two objects alike                   another seed for each
//
// The slope of the result remains the derivative of its height. A board costs three quarters of gabor_noise, and the
// others next to nothing besides their materials. For filtered materials, `softness` should not be less than the heights
// differ within a pixel.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- Boards --------------------------------------------------------------------------------------------------------

// Boards in columns along y or, if they are wider than long, in rows along x.
struct GaborBoards {
    joint: vec3<f32>,
    width: f32,
    reach: f32,
    shift: f32,
    turns: f32,
    shades: f32,
    gap: f32,
    depth: f32,
}

// The board at a point.
struct GaborBoard {
    p: vec2<f32>,
    dx: vec2<f32>,
    dy: vec2<f32>,
    seed: u32,
    turn: vec2<f32>,
    tone: f32,
    joint: vec3<f32>,
}

// GaborBoards gabor_boards_default()
//     Planks of half by three units.

// GaborBoard gabor_board(vec2f p, vec2f dx, vec2f dy, vec2f period, GaborBoards boards, u32 seed)
//     The board at p. dx and dy are dFdx(p) and dFdy(p), or vec2f(0.0) without a filter. If `period` is not vec2f(0.0),
//     the boards repeat after it: it holds a whole number of boards. Give the material itself no period.

// GaborMaterial gabor_laid(GaborMaterial material, GaborBoard board, GaborBoards boards)
//     The material at board.p as part of its board: turned, with the board's shade, and with joints. `lost` leaves out
//     the slopes of joints, which are too few and too steep to widen a highlight.

// ---- One material over another -------------------------------------------------------------------------------------

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

// A joint `gap` wide at distance x, of whose edges the standard deviation is 1 / scale: its share and the derivative
// along x.
fn gabor_impl_joint(x: f32, gap: f32, scale: f32) -> vec2<f32> {
    var t_13: vec2<f32>;
    var density_9: vec2<f32>;
    t_13 = clamp((scale * vec2<f32>((x + (0.5f * gap)), (x - (0.5f * gap)))), vec2(-10f), vec2(10f));
    let _e20 = t_13;
    let _e22 = t_13;
    density_9 = exp(((-0.5f * _e20) * _e22));
    let _e26 = t_13;
    let _e28 = gabor_impl_below(_e26.x);
    let _e29 = t_13;
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

// Indices from 0 to count - 1; any indices if count is 0.
fn gabor_impl_board_index(index: vec2<f32>, count: vec2<f32>) -> vec2<f32> {
    var local_85: vec2<f32>;
    if (count.x > 0f) {
        local_85 = (index - (count * floor((index / count))));
    } else {
        local_85 = index;
    }
    let _e10 = local_85;
    return _e10;
}

fn gabor_board(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, boards: GaborBoards, seed: u32) -> GaborBoard {
    var size_4: vec2<f32>;
    var count_13: vec2<f32> = vec2(0f);
    var at_13: vec2<f32>;
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
    size_4 = vec2<f32>(boards.width, boards.reach);
    if (period.x > 0f) {
        {
            let _e16 = size_4;
            count_13 = max(floor(((period / _e16) + vec2(0.5f))), vec2(1f));
            let _e25 = count_13;
            size_4 = (period / _e25);
        }
    }
    let _e27 = size_4;
    at_13 = (p / _e27);
    let _e30 = at_13;
    let _e32 = count_13;
    let _e33 = gabor_impl_board_index(floor(_e30), _e32);
    line_6 = _e33;
    let _e35 = at_13;
    let _e36 = size_4;
    let _e38 = size_4;
    if (_e36.x > _e38.y) {
        let _e42 = line_6;
        local_86 = vec2<f32>(fract((boards.shift * _e42.y)), 0f);
    } else {
        let _e50 = line_6;
        local_86 = vec2<f32>(0f, fract((boards.shift * _e50.x)));
    }
    let _e56 = local_86;
    at_13 = (_e35 + _e56);
    let _e58 = at_13;
    cell_5 = floor(_e58);
    let _e61 = cell_5;
    let _e62 = count_13;
    let _e63 = gabor_impl_board_index(_e61, _e62);
    index_15 = _e63;
    let _e65 = at_13;
    let _e66 = cell_5;
    let _e71 = size_4;
    local_87 = (((_e65 - _e66) - vec2(0.5f)) * _e71);
    let _e74 = gabor_impl_salt(seed);
    salt_16 = _e74;
    let _e76 = index_15;
    let _e79 = salt_16;
    let _e80 = gabor_impl_line_word(i32(_e76.x), _e79);
    let _e81 = index_15;
    let _e84 = salt_16;
    let _e87 = gabor_impl_line_word(i32(_e81.y), (_e84 ^ 1540483477u));
    word_6 = (_e80 * _e87);
    let _e90 = word_6;
    let _e92 = gabor_lobe_seed(_e90, 1i);
    random = _e92;
    let _e94 = random;
    if (f32((_e94 & 65535u)) < (65536f * boards.turns)) {
        local_88 = vec2<f32>(0f, 1f);
    } else {
        local_88 = vec2<f32>(1f, 0f);
    }
    let _e109 = local_88;
    turn_16 = _e109;
    let _e111 = turn_16;
    let _e113 = turn_16;
    back_1 = vec2<f32>(_e111.x, -(_e113.y));
    wide_3 = (0.25f * ((dx * dx) + (dy * dy)));
    let _e124 = wide_3;
    let _e125 = size_4;
    let _e126 = size_4;
    boards_wide = min((_e124 / (_e125 * _e126)), vec2(4f));
    let _e135 = boards_wide;
    let _e137 = boards_wide;
    mean_9 = exp((-19.739208f * max(_e135.x, _e137.y)));
    let _e143 = local_87;
    let _e145 = size_4;
    let _e148 = wide_3;
    let _e150 = gabor_impl_joints(_e143.x, _e145.x, boards.gap, _e148.x);
    across_4 = _e150;
    let _e152 = local_87;
    let _e154 = size_4;
    let _e157 = wide_3;
    let _e159 = gabor_impl_joints(_e152.y, _e154.y, boards.gap, _e157.y);
    along_4 = _e159;
    let _e162 = across_4;
    let _e164 = along_4;
    free = (vec2(1f) - vec2<f32>(_e162.x, _e164.x));
    let _e170 = local_87;
    let _e171 = back_1;
    let _e172 = gabor_impl_product(_e170, _e171);
    let _e173 = back_1;
    let _e174 = gabor_impl_product(dx, _e173);
    let _e175 = back_1;
    let _e176 = gabor_impl_product(dy, _e175);
    let _e177 = word_6;
    let _e179 = gabor_lobe_seed(_e177, 0i);
    let _e180 = turn_16;
    let _e184 = mean_9;
    let _e185 = random;
    let _e198 = free;
    let _e200 = free;
    let _e204 = free;
    let _e206 = across_4;
    let _e209 = free;
    let _e211 = along_4;
    return GaborBoard(_e172, _e174, _e176, _e179, _e180, (1f - (boards.shades * (0.5f + (_e184 * ((f32((_e185 >> 16u)) / 65535f) - 0.5f))))), vec3<f32>((1f - (_e198.x * _e200.y)), (_e204.y * _e206.y), (_e209.x * _e211.y)));
}

fn gabor_laid(material: GaborMaterial, board: GaborBoard, boards: GaborBoards) -> GaborMaterial {
    var joint: f32;
    var free_1: f32;
    var back_2: vec2<f32>;
    joint = board.joint.x;
    let _e7 = joint;
    free_1 = (1f - _e7);
    back_2 = vec2<f32>(board.turn.x, -(board.turn.y));
    let _e21 = joint;
    let _e24 = free_1;
    let _e27 = joint;
    let _e31 = free_1;
    let _e34 = gabor_impl_product(material.slope, board.turn);
    let _e47 = joint;
    let _e49 = free_1;
    let _e52 = free_1;
    let _e54 = back_2;
    let _e57 = gabor_impl_turned_square(material.lost, _e54, board.turn.yx);
    return GaborMaterial(mix((board.tone * material.colour), boards.joint, vec3(_e21)), ((_e24 * material.height) - (_e27 * boards.depth)), ((_e31 * _e34) - ((material.height + boards.depth) * board.joint.yz)), mix(material.roughness, max(material.roughness, 0.8f), _e47), (_e49 * material.metalness), (_e52 * _e57));
}

// A share of one material and the rest of another, with this height.
fn gabor_impl_shared(rest: GaborMaterial, part: GaborMaterial, share: f32, height: f32) -> GaborMaterial {
    return GaborMaterial(mix(rest.colour, part.colour, vec3(share)), height, mix(rest.slope, part.slope, vec2(share)), mix(rest.roughness, part.roughness, share), mix(rest.metalness, part.metalness, share), mix(rest.lost, part.lost, vec3(share)));
}

// A smooth maximum whose derivatives are the shares: over a difference d from -s to s, it grows by (d + s)^2 / (4 s).
fn gabor_covered(below: GaborMaterial, above: GaborMaterial, softness: f32) -> GaborMaterial {
    var d_8: f32;
    var edge_3: f32;
    d_8 = ((above.height - below.height) / max(softness, 0.000001f));
    let _e11 = d_8;
    edge_3 = max((1f - abs(_e11)), 0f);
    let _e19 = d_8;
    let _e30 = edge_3;
    let _e32 = edge_3;
    let _e35 = gabor_impl_shared(below, above, clamp((0.5f + (0.5f * _e19)), 0f, 1f), (max(below.height, above.height) + (((0.25f * softness) * _e30) * _e32)));
    return _e35;
}

fn gabor_worn(coat: GaborMaterial, core: GaborMaterial, softness: f32) -> GaborMaterial {
    var d_9: f32;
    var edge_4: f32;
    d_9 = ((coat.height - core.height) / max(softness, 0.000001f));
    let _e11 = d_9;
    edge_4 = max((1f - abs(_e11)), 0f);
    let _e19 = d_9;
    let _e30 = edge_4;
    let _e32 = edge_4;
    let _e35 = gabor_impl_shared(coat, core, clamp((0.5f + (0.5f * _e19)), 0f, 1f), (min(coat.height, core.height) - (((0.25f * softness) * _e30) * _e32)));
    return _e35;
}

