// gabor_erosion.wgsl: eroded mountains, evaluated point by point: branching gullies and ridges on any slope: for WGSL.
//
// Generated from shaders/gabor_erosion.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl.
// Digest of the GLSL and of this file: c9557360c4cbf404
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height and slope
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of gullies. The idea
// comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
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
    sharpness: f32,
    ridge_rounding: f32,
    crease_rounding: f32,
    gully_weight: f32,
    branching: f32,
}

// Alpine ridges and valleys on the hills of gabor_terrain.
fn gabor_erosion() -> GaborErosion {
    return GaborErosion(5i, 1.5f, 0.12f, 2f, 0.5f, 0.5f, 1.5f, 2f, 0.1f, 0.1f, 0.5f, 1f);
}

// Hills to erode: about four units wide, with mean height 0, rms slope 0.6 and continuous curvature.
fn gabor_terrain(p: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e7 = gabor_terrain_at(GaborGround(vec2(0i), p, vec2(0f)), seed);
    return _e7;
}

// Adds gullies and ridges to the base at p. base.ridge tells what its flat places are: -1 for valleys, 1 for peaks.
// The height is continuous where the base and its slope are, and the result can be eroded again. The returned slope
// ignores that gullies change direction and fade: its rms error is 0.6 of the rms slope.
fn gabor_eroded(p: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e8 = gabor_eroded_filtered(p, vec2(0f), vec2(0f), base, erosion, seed);
    return _e8;
}

// The same without gullies that are too fine for a pixel, with the same mean height. dx and dy are dFdx(p) and
// dFdy(p), the change of p from one pixel to the next. Removed octaves cost almost nothing.
fn gabor_eroded_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e11 = gabor_eroded_at(GaborGround(vec2(0i), p, vec2(0f)), dx, dy, base, erosion, seed);
    return _e11;
}

// The same with an exact period along x and y, at least 4. Whole periods do not change the width of the hills.
fn gabor_terrain_tiled(p: vec2<f32>, period: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e6 = gabor_terrain_at(GaborGround(vec2(0i), p, period), seed);
    return _e6;
}

fn gabor_eroded_tiled(p: vec2<f32>, period: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e12 = gabor_eroded_at(GaborGround(vec2(0i), p, period), vec2(0f), vec2(0f), base, erosion, seed);
    return _e12;
}

// A position, cell + local, and the period of the world.
struct GaborGround {
    cell: vec2<i32>,
    local: vec2<f32>,
    period: vec2<f32>,
}

// Everything together: full precision far away, a period, and a filter, unless dx and dy are vec2(0.0).
fn gabor_terrain_at(ground: GaborGround, seed: u32) -> GaborTerrain {
    var place_8: GaborPlace;
    var zero_1: vec2<f32>;
    var x_5: vec4<f32>;
    var y_5: vec4<f32>;
    var slope_x_1: vec4<f32>;
    var slope_y_1: vec4<f32>;
    var salt_5: u32;
    var columns: vec4<u32>;
    var rows: vec4<u32>;
    var hills: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var noise_1: vec2<f32>;
    var wave_10: vec2<f32>;
    var rough: f32;
    var height: f32;
    var factors: vec2<f32>;
    var slope_7: vec2<f32>;

    let _e3 = gabor_impl_place(ground, 1f);
    place_8 = _e3;
    let _e5 = place_8;
    zero_1 = floor(_e5.local);
    let _e13 = place_8;
    let _e16 = zero_1;
    gabor_impl_splines((_e13.local.x - _e16.x), (&x_5), (&slope_x_1));
    let _e23 = place_8;
    let _e26 = zero_1;
    gabor_impl_splines((_e23.local.y - _e26.y), (&y_5), (&slope_y_1));
    let _e33 = gabor_impl_salt(seed);
    salt_5 = _e33;
    let _e35 = place_8;
    let _e38 = zero_1;
    let _e42 = place_8;
    let _e45 = salt_5;
    let _e46 = gabor_impl_lines((_e35.cell.x + i32(_e38.x)), _e42.period.x, _e45);
    columns = _e46;
    let _e48 = place_8;
    let _e51 = zero_1;
    let _e55 = place_8;
    let _e58 = salt_5;
    let _e61 = gabor_impl_lines((_e48.cell.y + i32(_e51.y)), _e55.period.y, (_e58 ^ 1540483477u));
    rows = _e61;
    let _e72 = columns;
    let _e73 = rows;
    let _e76 = x_5;
    let _e77 = slope_x_1;
    let _e78 = y_5;
    let _e80 = slope_y_1;
    gabor_impl_add_hills((&hills), (_e72 * _e73.x), _e76, _e77, _e78.x, _e80.x);
    let _e84 = columns;
    let _e85 = rows;
    let _e88 = x_5;
    let _e89 = slope_x_1;
    let _e90 = y_5;
    let _e92 = slope_y_1;
    gabor_impl_add_hills((&hills), (_e84 * _e85.y), _e88, _e89, _e90.y, _e92.y);
    let _e96 = columns;
    let _e97 = rows;
    let _e100 = x_5;
    let _e101 = slope_x_1;
    let _e102 = y_5;
    let _e104 = slope_y_1;
    gabor_impl_add_hills((&hills), (_e96 * _e97.z), _e100, _e101, _e102.z, _e104.z);
    let _e108 = columns;
    let _e109 = rows;
    let _e112 = x_5;
    let _e113 = slope_x_1;
    let _e114 = y_5;
    let _e116 = slope_y_1;
    gabor_impl_add_hills((&hills), (_e108 * _e109.w), _e112, _e113, _e114.w, _e116.w);
    let _e120 = hills;
    noise_1 = (0.000000001682536f * _e120.value);
    let _e125 = noise_1;
    let _e128 = gabor_impl_wave((0.4f * _e125.y));
    wave_10 = _e128;
    let _e132 = noise_1;
    rough = (0.3f + (0.12f * _e132.x));
    let _e137 = noise_1;
    let _e139 = rough;
    let _e140 = wave_10;
    height = (_e137.x + (_e139 * _e140.y));
    let _e150 = wave_10;
    let _e155 = rough;
    let _e157 = wave_10;
    factors = (0.0000000005552369f * vec2<f32>((1f + (0.12f * _e150.y)), ((2.5132742f * _e155) * _e157.x)));
    let _e163 = place_8;
    let _e165 = factors;
    let _e166 = hills;
    let _e169 = factors;
    let _e170 = hills;
    slope_7 = (_e163.radius * vec2<f32>(dot(_e165, _e166.slope_x), dot(_e169, _e170.slope_y)));
    let _e177 = height;
    let _e179 = slope_7;
    let _e180 = height;
    let _e182 = height;
    let _e183 = height;
    return GaborTerrain((0.33f * _e177), _e179, (_e180 * inverseSqrt((1f + (_e182 * _e183)))));
}

fn gabor_eroded_at(ground: GaborGround, dx: vec2<f32>, dy: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    var terrain: GaborTerrain;
    var gully: GaborTerrain;
    var steer: vec2<f32>;
    var frequency_7: f32;
    var depth: f32;
    var mask: f32 = 1f;
    var rounding_1: f32;
    var i: i32 = 0i;
    var steep: f32;
    var full: f32;
    var wave_11: vec2<f32>;
    var steps: vec2<f32>;
    var kept: f32;
    var z_1: vec2<f32>;
    var slope_8: vec2<f32>;
    var place_9: GaborPlace;
    var stripes: GaborField;
    var even: f32;
    var local_13: f32;
    var side: f32;

    terrain = base;
    gully = GaborTerrain(base.ridge, vec2(0f), base.ridge);
    steer = base.slope;
    frequency_7 = erosion.frequency;
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
            let _e59 = frequency_7;
            let _e60 = steep;
            let _e62 = steer;
            let _e65 = steer;
            wave_11 = ((_e59 / _e60) * vec2<f32>(-(_e62.y), _e65.x));
            let _e70 = wave_11;
            let _e72 = wave_11;
            steps = vec2<f32>(dot(_e70, dx), dot(_e72, dy));
            let _e79 = steps;
            let _e80 = steps;
            kept = max(((1.02f * exp((-4.934802f * dot(_e79, _e80)))) - 0.02f), 0f);
            z_1 = vec2(0f);
            slope_8 = vec2(0f);
            let _e96 = kept;
            if (_e96 > 0f) {
                {
                    let _e105 = frequency_7;
                    let _e107 = gabor_impl_place(ground, (1.2f * _e105));
                    place_9 = _e107;
                    let _e109 = place_9;
                    let _e110 = wave_11;
                    let _e112 = i;
                    let _e113 = gabor_lobe_seed(seed, _e112);
                    let _e114 = gabor_field(_e109, GaborKernel(_e110), _e113);
                    stripes = _e114;
                    let _e117 = stripes;
                    z_1 = (erosion.sharpness * _e117.value);
                    let _e121 = z_1;
                    let _e122 = z_1;
                    even = inverseSqrt((1f + dot(_e121, _e122)));
                    let _e127 = z_1;
                    let _e128 = stripes;
                    let _e131 = z_1;
                    let _e132 = stripes;
                    let _e136 = even;
                    let _e137 = even;
                    let _e139 = z_1;
                    slope_8 = (vec2<f32>(dot(_e127, _e128.slope_x), dot(_e131, _e132.slope_y)) * ((_e136 * _e137) * _e139.x));
                    let _e143 = kept;
                    let _e144 = even;
                    let _e148 = stripes;
                    let _e151 = stripes;
                    let _e155 = slope_8;
                    slope_8 = (((_e143 * _e144) * erosion.sharpness) * (vec2<f32>(_e148.slope_x.x, _e151.slope_y.x) - _e155));
                    let _e158 = z_1;
                    let _e159 = kept;
                    let _e160 = even;
                    z_1 = (_e158 * (_e159 * _e160));
                }
            }
            let _e164 = gully;
            let _e167 = z_1;
            let _e170 = mask;
            gully.height = mix(_e164.height, (erosion.gully_weight * _e167.x), _e170);
            let _e173 = gully;
            let _e176 = slope_8;
            let _e178 = mask;
            gully.slope = mix(_e173.slope, (erosion.gully_weight * _e176), vec2(_e178));
            let _e182 = gully;
            let _e184 = z_1;
            let _e186 = mask;
            gully.ridge = mix(_e182.ridge, _e184.x, _e186);
            let _e189 = terrain;
            let _e191 = depth;
            let _e192 = gully;
            terrain.height = (_e189.height + (_e191 * _e192.height));
            let _e197 = terrain;
            let _e199 = depth;
            let _e200 = gully;
            terrain.slope = (_e197.slope + (_e199 * _e200.slope));
            let _e204 = z_1;
            if (_e204.y < 0f) {
                local_13 = -6.2831855f;
            } else {
                local_13 = 6.2831855f;
            }
            let _e212 = local_13;
            let _e213 = kept;
            side = (((_e212 * _e213) * erosion.branching) * erosion.gully_weight);
            let _e220 = steer;
            let _e221 = side;
            let _e222 = depth;
            let _e224 = mask;
            let _e226 = wave_11;
            steer = (_e220 - (((_e221 * _e222) * _e224) * _e226));
            let _e233 = z_1;
            rounding_1 = mix(erosion.crease_rounding, erosion.ridge_rounding, (0.5f + (0.5f * _e233.x)));
            let _e238 = mask;
            let _e242 = mask;
            let _e251 = kept;
            let _e254 = z_1;
            let _e258 = rounding_1;
            let _e259 = frequency_7;
            let _e263 = gabor_impl_mask(((0.5f - (0.5f * _e251)) + abs(_e254.y)), ((_e258 * _e259) / erosion.frequency));
            mask = (((_e238 * erosion.detail) / (1f + (_e242 * (erosion.detail - 1f)))) * _e263);
            let _e265 = frequency_7;
            frequency_7 = (_e265 * erosion.lacunarity);
            let _e268 = depth;
            depth = (_e268 * erosion.gain);
        }
        continuing {
            let _e38 = i;
            i = (_e38 + 1i);
        }
    }
    let _e271 = terrain;
    let _e273 = terrain;
    let _e275 = gully;
    return GaborTerrain(_e271.height, _e273.slope, _e275.ridge);
}

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice whose number of nodes per unit of p is a multiple of 1 / 65536, so that its product with a
// cell is an exact integer and fraction. The kernel radius is one unit of p.
fn gabor_impl_place(ground: GaborGround, nodes: f32) -> GaborPlace {
    var rounded: u32;
    var place_7: GaborPlace;
    var low: vec2<u32>;
    var high: vec2<u32>;

    rounded = u32(((clamp(nodes, 0.0001f, 30000f) * 65536f) + 0.5f));
    let _e15 = gabor_place(vec2(0i), vec2(0f));
    place_7 = _e15;
    let _e18 = rounded;
    place_7.radius = vec2((f32(_e18) / 65536f));
    let _e28 = rounded;
    low = ((vec2<u32>(ground.cell) & vec2(65535u)) * (_e28 & 65535u));
    let _e35 = rounded;
    let _e46 = rounded;
    high = ((vec2<u32>(ground.cell) * (_e35 >> 16u)) + (vec2<u32>((ground.cell >> vec2(16u))) * (_e46 & 65535u)));
    let _e53 = high;
    let _e54 = low;
    place_7.cell = vec2<i32>((_e53 + (_e54 >> vec2(16u))));
    let _e61 = low;
    let _e70 = place_7;
    place_7.local = ((vec2<f32>((_e61 & vec2(65535u))) / vec2(65536f)) + (ground.local * _e70.radius));
    if ((ground.period.x <= 0f) && (ground.period.y <= 0f)) {
        let _e83 = place_7;
        return _e83;
    }
    let _e86 = place_7;
    place_7.period = vec2<i32>(max(floor(((ground.period * _e86.radius) + vec2(0.5f))), vec2(4f)));
    if (ground.period.x > 0f) {
        let _e103 = place_7;
        place_7.radius.x = (f32(_e103.period.x) / ground.period.x);
    } else {
        place_7.period.x = 0i;
    }
    if (ground.period.y > 0f) {
        let _e119 = place_7;
        place_7.radius.y = (f32(_e119.period.y) / ground.period.y);
    } else {
        place_7.period.y = 0i;
    }
    place_7.cell = vec2(0i);
    let _e137 = place_7;
    place_7.local = ((vec2<f32>(ground.cell) + ground.local) * _e137.radius);
    let _e140 = place_7;
    return _e140;
}

// Cubic B-splines of the four nodes around a point at t in [0, 1) between the middle two, and their derivatives.
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

// The words of the four lines of nodes around line `index`.
fn gabor_impl_lines(index: i32, period: i32, salt: u32) -> vec4<u32> {
    let _e5 = gabor_impl_wrap((index - 1i), period);
    let _e6 = gabor_impl_line_word(_e5, salt);
    let _e7 = gabor_impl_wrap(index, period);
    let _e8 = gabor_impl_line_word(_e7, salt);
    let _e11 = gabor_impl_wrap((index + 1i), period);
    let _e12 = gabor_impl_line_word(_e11, salt);
    let _e15 = gabor_impl_wrap((index + 2i), period);
    let _e16 = gabor_impl_line_word(_e15, salt);
    return vec4<u32>(_e6, _e8, _e12, _e16);
}

// Adds a row of nodes to two noises; their amplitudes are uniform between -2^31 and 2^31.
fn gabor_impl_add_hills(sum: ptr<function, GaborField>, words: vec4<u32>, x: vec4<f32>, slope_x: vec4<f32>, y: f32, slope_y: f32) {
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

// Rises from 0 to 1 at t = 1 and stays there; starts straight, or rounded.
fn gabor_impl_mask(t: f32, rounding: f32) -> f32 {
    var local_12: f32;
    var s_2: f32;

    if (t < rounding) {
        local_12 = (((0.5f * t) * t) / rounding);
    } else {
        local_12 = (t - (0.5f * rounding));
    }
    let _e12 = local_12;
    s_2 = (1f - min(_e12, 1f));
    let _e18 = s_2;
    let _e19 = s_2;
    return (1f - (_e18 * _e19));
}
