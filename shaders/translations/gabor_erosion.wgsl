// Generated from gabor_erosion.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest a438e0b593a1575c.
//
// gabor_erosion.wgsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height and slope
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// A height in units of p, its derivatives, and a ridge value from -1 in creases and valleys to 1 on ridges and peaks.
struct GaborTerrain {
    height: f32,
    slope: vec2<f32>,
    ridge: f32,
}

struct GaborErosion {
    octaves: i32,
    frequency: f32,
    strength: f32,
    lacunarity: f32,
    gain: f32,
    onset: f32,
    detail: f32,
    uniformity: f32,
    ridge_rounding: f32,
    crease_rounding: f32,
    gully_weight: f32,
    branching: f32,
}

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(vec2f p, u32 seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.6 and continuous curvature.

// GaborTerrain gabor_eroded(vec2f p, GaborTerrain base, GaborErosion erosion, u32 seed)
//     Adds gullies and ridges to the base at p. Where the base is flat, base.ridge distinguishes valleys, -1, from
//     peaks, 1. The height is continuous where the base and its slope are, and the result can be eroded again. The
//     returned slope takes only the phase of the gullies into account, not how they turn and fade: its rms error is
//     0.63 times the rms slope.

// GaborTerrain gabor_terrain_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)
// GaborTerrain gabor_eroded_filtered(vec2f p, vec2f dx, vec2f dy, GaborTerrain base, GaborErosion erosion, u32 seed)
//     The same without features that are too fine for a pixel; the mean height does not change. dx and dy are dFdx(p)
//     and dFdy(p).

// GaborTerrain gabor_terrain_tiled(vec2f p, vec2f period, u32 seed)
// GaborTerrain gabor_eroded_tiled(vec2f p, vec2f period, GaborTerrain base, GaborErosion erosion, u32 seed)
//     The same with an exact period along x and y, at least 4 units of p. Integer periods do not change the width of
//     the hills.

struct GaborTerrainPlace {
    cell: vec2<i32>,
    local: vec2<f32>,
    period: vec2<f32>,
}

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, vec2f dx, vec2f dy, u32 seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, vec2f dx, vec2f dy, GaborTerrain base, GaborErosion erosion,
//                              u32 seed)
//     The same with a period, a filter (unless dx and dy are vec2f(0.0)), or both. Without a period, the result is
//     precise at any distance from the origin.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `radius` is in nodes per unit of
// p, so that wave vectors and derivatives are per unit of p.
fn gabor_impl_ground(ground: GaborTerrainPlace, nodes: f32) -> GaborPlace {
    var rounded: u32;
    var place_3: GaborPlace;
    var low: vec2<u32>;
    var high: vec2<u32>;
    rounded = u32(((clamp(nodes, 0.0001f, 30000f) * 65536f) + 0.5f));
    let _e15 = gabor_place(vec2(0i), vec2(0f));
    place_3 = _e15;
    let _e18 = rounded;
    place_3.radius = vec2((f32(_e18) / 65536f));
    let _e28 = rounded;
    low = ((vec2<u32>(ground.cell) & vec2(65535u)) * (_e28 & 65535u));
    let _e35 = rounded;
    let _e46 = rounded;
    high = ((vec2<u32>(ground.cell) * (_e35 >> 16u)) + (vec2<u32>((ground.cell >> vec2(16u))) * (_e46 & 65535u)));
    let _e53 = high;
    let _e54 = low;
    place_3.cell = vec2<i32>((_e53 + (_e54 >> vec2(16u))));
    let _e61 = low;
    let _e70 = place_3;
    place_3.local = ((vec2<f32>((_e61 & vec2(65535u))) / vec2(65536f)) + (ground.local * _e70.radius));
    if ((ground.period.x <= 0f) && (ground.period.y <= 0f)) {
        let _e83 = place_3;
        return _e83;
    }
    let _e86 = place_3;
    place_3.period = vec2<i32>(max(floor(((ground.period * _e86.radius) + vec2(0.5f))), vec2(4f)));
    if (ground.period.x > 0f) {
        let _e103 = place_3;
        place_3.radius.x = (f32(_e103.period.x) / ground.period.x);
    } else {
        place_3.period.x = 0i;
    }
    if (ground.period.y > 0f) {
        let _e119 = place_3;
        place_3.radius.y = (f32(_e119.period.y) / ground.period.y);
    } else {
        place_3.period.y = 0i;
    }
    place_3.cell = vec2(0i);
    let _e137 = place_3;
    place_3.local = ((vec2<f32>(ground.cell) + ground.local) * _e137.radius);
    let _e140 = place_3;
    return _e140;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
fn gabor_impl_splines(t: f32, value: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    var u_1: f32;
    u_1 = (1f - t);
    let _e6 = u_1;
    let _e7 = u_1;
    let _e9 = u_1;
    let _e16 = u_1;
    let _e22 = u_1;
    let _e24 = u_1;
    (*value) = (vec4<f32>(((_e6 * _e7) * _e9), (4f - (((3f * t) * t) * (1f + _e16))), (4f - (((3f * _e22) * _e24) * (1f + t))), ((t * t) * t)) / vec4(6f));
    let _e37 = u_1;
    let _e39 = u_1;
    let _e46 = u_1;
    let _e49 = u_1;
    (*slope) = (0.5f * vec4<f32>((-(_e37) * _e39), (t * ((3f * t) - 4f)), (_e46 * (4f - (3f * _e49))), (t * t)));
    return;
}

fn gabor_impl_four_line_words(index: i32, period: i32, salt: u32) -> vec4<u32> {
    var first_1: i32;
    var second_2: i32;
    var third_2: i32;
    let _e5 = gabor_impl_wrap((index - 1i), period);
    first_1 = _e5;
    let _e7 = first_1;
    let _e8 = gabor_impl_next_node(_e7, period);
    second_2 = _e8;
    let _e10 = second_2;
    let _e11 = gabor_impl_next_node(_e10, period);
    third_2 = _e11;
    let _e13 = first_1;
    let _e14 = gabor_impl_line_word(_e13, salt);
    let _e15 = second_2;
    let _e16 = gabor_impl_line_word(_e15, salt);
    let _e17 = third_2;
    let _e18 = gabor_impl_line_word(_e17, salt);
    let _e19 = third_2;
    let _e20 = gabor_impl_next_node(_e19, period);
    let _e21 = gabor_impl_line_word(_e20, salt);
    return vec4<u32>(_e14, _e16, _e18, _e21);
}

// Two noises and their derivatives.
struct GaborHills {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises.
fn gabor_impl_add_hill_row(sum: ptr<function, GaborHills>, words: vec4<u32>, x: vec4<f32>, slope_x: vec4<f32>, y: f32, slope_y: f32) {
    var a_2: vec4<f32>;
    var b_2: vec4<f32>;
    var row_1: vec2<f32>;
    a_2 = vec4<f32>(vec4<i32>(words));
    b_2 = vec4<f32>(vec4<i32>((words << vec4(16u))));
    let _e15 = a_2;
    let _e17 = b_2;
    row_1 = vec2<f32>(dot(x, _e15), dot(x, _e17));
    let _e22 = (*sum);
    let _e24 = row_1;
    (*sum).value = (_e22.value + (y * _e24));
    let _e28 = (*sum);
    let _e30 = a_2;
    let _e32 = b_2;
    (*sum).slope_x = (_e28.slope_x + (y * vec2<f32>(dot(slope_x, _e30), dot(slope_x, _e32))));
    let _e38 = (*sum);
    let _e40 = row_1;
    (*sum).slope_y = (_e38.slope_y + (slope_y * _e40));
    return;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
fn gabor_terrain_at(ground: GaborTerrainPlace, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborTerrain {
    var place_4: GaborPlace;
    var zero_1: vec2<f32>;
    var x_6: vec4<f32>;
    var y_5: vec4<f32>;
    var slope_x_1: vec4<f32>;
    var slope_y_1: vec4<f32>;
    var salt_5: u32;
    var columns: vec4<u32>;
    var rows: vec4<u32>;
    var hills: GaborHills = GaborHills(vec2(0f), vec2(0f), vec2(0f));
    var s_2: vec4<f32>;
    var area: f32;
    var kept: f32;
    var unit: f32;
    var noise_1: vec2<f32>;
    var wave_5: vec2<f32>;
    var rough: f32;
    var height: f32;
    var factors: vec2<f32>;
    var slope_7: vec2<f32>;
    let _e5 = gabor_impl_ground(ground, 1f);
    place_4 = _e5;
    let _e7 = place_4;
    zero_1 = floor(_e7.local);
    let _e15 = place_4;
    let _e18 = zero_1;
    gabor_impl_splines((_e15.local.x - _e18.x), (&x_6), (&slope_x_1));
    let _e25 = place_4;
    let _e28 = zero_1;
    gabor_impl_splines((_e25.local.y - _e28.y), (&y_5), (&slope_y_1));
    let _e35 = gabor_impl_salt(seed);
    salt_5 = _e35;
    let _e37 = place_4;
    let _e40 = zero_1;
    let _e44 = place_4;
    let _e47 = salt_5;
    let _e48 = gabor_impl_four_line_words((_e37.cell.x + i32(_e40.x)), _e44.period.x, _e47);
    columns = _e48;
    let _e50 = place_4;
    let _e53 = zero_1;
    let _e57 = place_4;
    let _e60 = salt_5;
    let _e63 = gabor_impl_four_line_words((_e50.cell.y + i32(_e53.y)), _e57.period.y, (_e60 ^ 1540483477u));
    rows = _e63;
    let _e74 = columns;
    let _e75 = rows;
    let _e78 = x_6;
    let _e79 = slope_x_1;
    let _e80 = y_5;
    let _e82 = slope_y_1;
    gabor_impl_add_hill_row((&hills), (_e74 * _e75.x), _e78, _e79, _e80.x, _e82.x);
    let _e86 = columns;
    let _e87 = rows;
    let _e90 = x_6;
    let _e91 = slope_x_1;
    let _e92 = y_5;
    let _e94 = slope_y_1;
    gabor_impl_add_hill_row((&hills), (_e86 * _e87.y), _e90, _e91, _e92.y, _e94.y);
    let _e98 = columns;
    let _e99 = rows;
    let _e102 = x_6;
    let _e103 = slope_x_1;
    let _e104 = y_5;
    let _e106 = slope_y_1;
    gabor_impl_add_hill_row((&hills), (_e98 * _e99.z), _e102, _e103, _e104.z, _e106.z);
    let _e110 = columns;
    let _e111 = rows;
    let _e114 = x_6;
    let _e115 = slope_x_1;
    let _e116 = y_5;
    let _e118 = slope_y_1;
    gabor_impl_add_hill_row((&hills), (_e110 * _e111.w), _e114, _e115, _e116.w, _e118.w);
    s_2 = clamp(vec4<f32>(dx.x, dx.y, dy.x, dy.y), vec4(-1000000000f), vec4(1000000000f));
    let _e133 = s_2;
    let _e135 = s_2;
    let _e138 = s_2;
    let _e140 = s_2;
    area = ((_e133.x * _e135.w) - (_e138.y * _e140.z));
    let _e147 = s_2;
    let _e148 = s_2;
    let _e153 = area;
    let _e155 = area;
    kept = inverseSqrt(((1f + (0.34768212f * dot(_e147, _e148))) + ((0.12088286f * _e153) * _e155)));
    let _e161 = kept;
    unit = (0.000000001682536f * _e161);
    let _e164 = unit;
    let _e165 = hills;
    noise_1 = (_e164 * _e165.value);
    let _e170 = kept;
    let _e171 = kept;
    let _e178 = noise_1;
    let _e181 = gabor_impl_wave((0.4f * _e178.y));
    wave_5 = (exp((3.1582735f * ((_e170 * _e171) - 1f))) * _e181);
    let _e186 = noise_1;
    rough = (0.3f + (0.12f * _e186.x));
    let _e191 = noise_1;
    let _e193 = rough;
    let _e194 = wave_5;
    height = (_e191.x + (_e193 * _e194.y));
    let _e200 = unit;
    let _e204 = wave_5;
    let _e209 = rough;
    let _e211 = wave_5;
    factors = ((0.33f * _e200) * vec2<f32>((1f + (0.12f * _e204.y)), ((2.5132742f * _e209) * _e211.x)));
    let _e217 = place_4;
    let _e219 = factors;
    let _e220 = hills;
    let _e223 = factors;
    let _e224 = hills;
    slope_7 = (_e217.radius * vec2<f32>(dot(_e219, _e220.slope_x), dot(_e223, _e224.slope_y)));
    let _e231 = height;
    let _e233 = slope_7;
    let _e234 = height;
    let _e236 = height;
    let _e237 = height;
    return GaborTerrain((0.33f * _e231), _e233, (_e234 * inverseSqrt((1f + (_e236 * _e237)))));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded.
fn gabor_impl_mask(t: f32, rounding: f32) -> f32 {
    var local_11: f32;
    var s_3: f32;
    if (t < rounding) {
        local_11 = (((0.5f * t) * t) / rounding);
    } else {
        local_11 = (t - (0.5f * rounding));
    }
    let _e12 = local_11;
    s_3 = (1f - min(_e12, 1f));
    let _e18 = s_3;
    let _e19 = s_3;
    return (1f - (_e18 * _e19));
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
fn gabor_eroded_at(ground: GaborTerrainPlace, dx: vec2<f32>, dy: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    var terrain: GaborTerrain;
    var gully: GaborTerrain;
    var steer: vec2<f32>;
    var frequency_6: f32;
    var depth: f32;
    var mask: f32 = 1f;
    var rounding_1: f32;
    var i: i32 = 0i;
    var steep: f32;
    var full: f32;
    var wave_6: vec2<f32>;
    var steps: vec2<f32>;
    var kept_1: f32;
    var z_1: vec2<f32>;
    var place_5: GaborPlace;
    var field_4: GaborField;
    var local_12: f32;
    var side_1: f32;
    terrain = base;
    gully = GaborTerrain(base.ridge, vec2(0f), base.ridge);
    steer = base.slope;
    frequency_6 = erosion.frequency;
    depth = (erosion.strength / erosion.frequency);
    rounding_1 = mix(erosion.crease_rounding, erosion.ridge_rounding, (0.5f + (0.5f * base.ridge)));
    loop {
        let _e34 = i;
        if !((_e34 < erosion.octaves)) {
            break;
        }
        {
            let _e41 = steer;
            steep = max(length(_e41), 0.000000001f);
            let _e46 = steep;
            let _e51 = rounding_1;
            let _e52 = gabor_impl_mask((_e46 / max(erosion.onset, 0.000001f)), _e51);
            full = _e52;
            let _e54 = mask;
            let _e55 = full;
            let _e56 = full;
            mask = (_e54 * (_e55 * _e56));
            let _e59 = frequency_6;
            let _e60 = steep;
            let _e62 = steer;
            let _e65 = steer;
            wave_6 = ((_e59 / _e60) * vec2<f32>(-(_e62.y), _e65.x));
            let _e70 = wave_6;
            let _e72 = wave_6;
            steps = vec2<f32>(dot(_e70, dx), dot(_e72, dy));
            let _e79 = steps;
            let _e80 = steps;
            kept_1 = max(((1.02f * exp((-4.934802f * dot(_e79, _e80)))) - 0.02f), 0f);
            z_1 = vec2(0f);
            let _e93 = kept_1;
            if (_e93 > 0f) {
                {
                    let _e102 = frequency_6;
                    let _e104 = gabor_impl_ground(ground, (1.2f * _e102));
                    place_5 = _e104;
                    let _e106 = place_5;
                    let _e107 = wave_6;
                    let _e108 = i;
                    let _e109 = gabor_lobe_seed(seed, _e108);
                    let _e110 = gabor_field(_e106, _e107, _e109);
                    field_4 = _e110;
                    let _e113 = field_4;
                    let _e115 = field_4;
                    z_1 = (erosion.uniformity * vec2<f32>(_e113.quadrature, _e115.noise));
                    let _e119 = z_1;
                    let _e120 = kept_1;
                    let _e122 = z_1;
                    let _e123 = z_1;
                    z_1 = (_e119 * (_e120 * inverseSqrt((1f + dot(_e122, _e123)))));
                }
            }
            let _e130 = gully;
            let _e133 = z_1;
            let _e136 = mask;
            gully.height = mix(_e130.height, (erosion.gully_weight * _e133.x), _e136);
            let _e139 = gully;
            let _e145 = z_1;
            let _e148 = wave_6;
            let _e150 = mask;
            gully.slope = mix(_e139.slope, (((-6.2831855f * erosion.gully_weight) * _e145.y) * _e148), vec2(_e150));
            let _e154 = gully;
            let _e156 = z_1;
            let _e158 = mask;
            gully.ridge = mix(_e154.ridge, _e156.x, _e158);
            let _e161 = terrain;
            let _e163 = depth;
            let _e164 = gully;
            terrain.height = (_e161.height + (_e163 * _e164.height));
            let _e169 = terrain;
            let _e171 = depth;
            let _e172 = gully;
            terrain.slope = (_e169.slope + (_e171 * _e172.slope));
            let _e176 = z_1;
            if (_e176.y < 0f) {
                local_12 = -6.2831855f;
            } else {
                local_12 = 6.2831855f;
            }
            let _e184 = local_12;
            let _e185 = kept_1;
            side_1 = (((_e184 * _e185) * erosion.branching) * erosion.gully_weight);
            let _e192 = steer;
            let _e193 = side_1;
            let _e194 = depth;
            let _e196 = mask;
            let _e198 = wave_6;
            steer = (_e192 - (((_e193 * _e194) * _e196) * _e198));
            let _e205 = z_1;
            rounding_1 = mix(erosion.crease_rounding, erosion.ridge_rounding, (0.5f + (0.5f * _e205.x)));
            let _e210 = mask;
            let _e214 = mask;
            let _e223 = kept_1;
            let _e226 = z_1;
            let _e230 = rounding_1;
            let _e231 = frequency_6;
            let _e235 = gabor_impl_mask(((0.5f - (0.5f * _e223)) + abs(_e226.y)), ((_e230 * _e231) / erosion.frequency));
            mask = (((_e210 * erosion.detail) / (1f + (_e214 * (erosion.detail - 1f)))) * _e235);
            let _e237 = frequency_6;
            frequency_6 = (_e237 * erosion.lacunarity);
            let _e240 = depth;
            depth = (_e240 * erosion.gain);
        }
        continuing {
            let _e38 = i;
            i = (_e38 + 1i);
        }
    }
    let _e243 = terrain;
    let _e245 = terrain;
    let _e247 = gully;
    return GaborTerrain(_e243.height, _e245.slope, _e247.ridge);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_erosion() -> GaborErosion {
    return GaborErosion(5i, 1.5f, 0.12f, 2f, 0.5f, 0.5f, 1.5f, 2f, 0.1f, 0.1f, 0.5f, 1f);
}

fn gabor_terrain_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e9 = gabor_terrain_at(GaborTerrainPlace(vec2(0i), p, vec2(0f)), dx, dy, seed);
    return _e9;
}

fn gabor_terrain(p: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e6 = gabor_terrain_filtered(p, vec2(0f), vec2(0f), seed);
    return _e6;
}

fn gabor_terrain_tiled(p: vec2<f32>, period: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e10 = gabor_terrain_at(GaborTerrainPlace(vec2(0i), p, period), vec2(0f), vec2(0f), seed);
    return _e10;
}

fn gabor_eroded_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e11 = gabor_eroded_at(GaborTerrainPlace(vec2(0i), p, vec2(0f)), dx, dy, base, erosion, seed);
    return _e11;
}

fn gabor_eroded(p: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e8 = gabor_eroded_filtered(p, vec2(0f), vec2(0f), base, erosion, seed);
    return _e8;
}

fn gabor_eroded_tiled(p: vec2<f32>, period: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e12 = gabor_eroded_at(GaborTerrainPlace(vec2(0i), p, period), vec2(0f), vec2(0f), base, erosion, seed);
    return _e12;
}

