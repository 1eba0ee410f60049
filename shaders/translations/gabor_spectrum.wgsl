// Generated from gabor_spectrum.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 4298653a05cdf27c.
// Paste it after gabor_noise.wgsl.
//
// gabor_spectrum.wgsl: Gabor noise with any power spectrum, isotropic noise, and profiles of stripes.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     f32 n = gabor_noise_isotropic(p, 2.0, 7u);   // waves in all directions: mean 0, variance 1
//
//     I want                                   call
//     isotropic noise                          gabor_noise_isotropic
//     a range of directions or frequencies     gabor_noise_spread
//     a spectrum of my own                     gabor_field_lobes
//     rectangular, round or sharp stripes      gabor_profile_pulse and so on, after gabor_stripes
//     derivatives, periods, an evolution       a place, then gabor_field_isotropic, _spread or _lobes
//     noise averaged over a pixel              gabor_filter.wgsl
//
// Arguments and fields are those of gabor_noise.wgsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- Isotropic noise at a constant cost ----------------------------------------------------------------------------

// f32 gabor_noise_isotropic(vec2f p, f32 frequency, u32 seed)
// GaborField gabor_field_isotropic(GaborPlace place, f32 frequency, u32 seed)
//     Noise of waves in all directions, at the same cost for every frequency: 4 to 6 times that of gabor_noise. It has
//     mean 0 and variance 1; value and gradient are normal at every point. The power varies with direction only because
//     of the window, by 7 % at frequency 0 and 0.1 % at 1. Values at several points together follow a mixture of normal
//     distributions; those of gabor_noise_spread, a sum over directions, are jointly normal. At each point the
//     quadrature is independent of the noise, but not of the noise's gradient.

// ---- A range of waves ----------------------------------------------------------------------------------------------

// f32 gabor_noise_spread(vec2f p, f32 frequency, f32 orientation, f32 frequency_spread,
//                          f32 orientation_spread, u32 seed)
// GaborField gabor_field_spread(GaborPlace place, f32 frequency, f32 orientation, f32 frequency_spread,
//                               f32 orientation_spread, u32 seed)
//     Noise of many waves. Their orientations are within `orientation_spread` radians of `orientation`, and their
//     frequencies within the fraction `frequency_spread` (0 to 1) of `frequency`, spread as evenly as lobes of kernel
//     radius 1 allow. An orientation_spread of pi/2 gives isotropic noise; its power varies with direction by at most
//     5 % at frequencies from 0.12 to 14, by up to 7 % at lower ones, and beyond 14, where 64 directions are too few,
//     by 34 % at 20. The noise has mean 0 and variance 1; it and its derivatives are normal. It is continuous where the
//     arguments are. Costs one gabor_noise per lobe. There are
//         2.86 frequency_spread frequency + 0.8 frequencies, 1 to 16, each with
//         (4.44 frequency + 0.6) orientation_spread / (pi/2) + 0.8 directions, 1 to 64,
//     both rounded down: 10 directions for isotropic noise of frequency 2. Just before one of these numbers changes,
//     for a fifth of all arguments, the noise is a sum of both sets of lobes, the old and the new.

// ---- Sums of lobes -------------------------------------------------------------------------------------------------

// A lobe: waves around one wave vector.
struct GaborLobe {
    cycles_per_unit: f32, // the waves' frequency per unit of p, whatever the radius
    orientation: f32, // as in gabor_noise
    radius: vec2<f32>, // radius of the lobe's kernels along x and y in units of p, positive. The lobe's standard
    power: f32, // power relative to the other lobes, not negative
}

// A power spectrum: the first `count` lobes, at most GABOR_LOBES.
struct GaborLobes {
    lobe: array<GaborLobe, 4>,
    count: i32,
}

// GaborLobe gabor_lobe(f32 cycles_per_unit, f32 orientation, f32 radius, f32 power)
//     A lobe whose kernels are as wide along x as along y.

// GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, u32 seed)
//     The noise of several lobes: a sum of independent noises, normal with mean 0 and variance 1. Its gradients are per
//     unit of p. Costs one gabor_noise per lobe.
//         #define GABOR_LOBES 2              // before the file
//         GaborLobes lobes;
//         lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//         lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//         lobes.count = 2;
//         f32 n = gabor_field_lobes(gabor_place_at(p), lobes, 7u).noise;

// ---- Profiles of stripes, each from 0 to 1 -------------------------------------------------------------------------
//
// They take the (cosine, sine) of stripes. The profile is sharp where this vector has length 1. Where it is shorter,
// because a filter removed variance or stripes fork, the profile is averaged over a range of phases whose mean vector
// has that length. So a phase of t turns, averaged over w turns, is sin(pi w) / (pi w) vec2f(cos(2 pi t), sin(2 pi t)).

// f32 gabor_profile_triangle(vec2f stripes)
//     Straight lines from 0 at phase 0 to 1 at half a turn and back.

// f32 gabor_profile_sawtooth(vec2f stripes)
//     A straight line from 0 at phase 0 to 1 after a turn.

// f32 gabor_profile_pulse(vec2f stripes, f32 duty)
//     1 for the first `duty` (0 to 1) of each turn, then 0.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- Lobes ---------------------------------------------------------------------------------------------------------

// The same position, period and evolution, for kernels whose radius is `radius` times the place's. The position is
// rounded to a f32, within the period if there is one.
fn gabor_impl_stretched(place: GaborPlace, radius: vec2<f32>) -> GaborPlace {
    var cell_2: vec2<i32>;
    var unit: vec2<f32>;
    var stretched: GaborPlace;
    let _e6 = gabor_impl_wrap(place.cell.x, place.period.x);
    let _e11 = gabor_impl_wrap(place.cell.y, place.period.y);
    cell_2 = vec2<i32>(_e6, _e11);
    unit = (vec2(1f) / (place.cells_per_radius * radius));
    let _e20 = cell_2;
    let _e24 = unit;
    let _e28 = unit;
    let _e30 = gabor_place_tiled(((vec2<f32>(_e20) + place.local) * _e24), (vec2<f32>(place.period) * _e28));
    stretched = _e30;
    stretched.evolution = place.evolution;
    let _e34 = stretched;
    return _e34;
}

// A lobe's wave vector, in cycles per kernel radius along each axis.
fn gabor_impl_lobe_wave(lobe: GaborLobe) -> vec2<f32> {
    var wave_5: vec2<f32>;
    let _e6 = gabor_wave_vector((lobe.cycles_per_unit * lobe.radius.x), lobe.orientation);
    wave_5 = _e6;
    let _e8 = wave_5;
    let _e10 = wave_5;
    return vec2<f32>(_e8.x, (_e10.y * (lobe.radius.y / lobe.radius.x)));
}

fn gabor_impl_lobes_power(lobes: GaborLobes) -> f32 {
    var lobes_1: GaborLobes;
    var power_1: f32 = 0f;
    var i: i32 = 0i;
    lobes_1 = lobes;
    loop {
        let _e6 = i;
        let _e7 = lobes_1;
        if !((_e6 < min(_e7.count, 4i))) {
            break;
        }
        let _e16 = power_1;
        let _e17 = i;
        let _e20 = lobes_1.lobe[_e17];
        power_1 = (_e16 + _e20.power);
        continuing {
            let _e13 = i;
            i = (_e13 + 1i);
        }
    }
    let _e23 = power_1;
    return _e23;
}

fn gabor_field_lobes(place: GaborPlace, lobes: GaborLobes, seed: u32) -> GaborField {
    var lobes_3: GaborLobes;
    var sum_5: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var power_2: f32;
    var i_1: i32 = 0i;
    var lobe_1: GaborLobe;
    var field_4: GaborField;
    var local_11: f32;
    lobes_3 = lobes;
    let _e13 = lobes_3;
    let _e14 = gabor_impl_lobes_power(_e13);
    power_2 = _e14;
    loop {
        let _e18 = i_1;
        let _e19 = lobes_3;
        if !((_e18 < min(_e19.count, 4i))) {
            break;
        }
        {
            let _e28 = i_1;
            let _e31 = lobes_3.lobe[_e28];
            lobe_1 = _e31;
            let _e33 = lobe_1;
            let _e35 = gabor_impl_stretched(place, _e33.radius);
            let _e36 = lobe_1;
            let _e37 = gabor_impl_lobe_wave(_e36);
            let _e38 = i_1;
            let _e39 = gabor_derived_seed(seed, _e38);
            let _e40 = gabor_field(_e35, _e37, _e39);
            field_4 = _e40;
            let _e43 = field_4;
            let _e44 = power_2;
            if (_e44 > 0f) {
                let _e47 = lobe_1;
                let _e49 = power_2;
                local_11 = sqrt((_e47.power / _e49));
            } else {
                local_11 = 0f;
            }
            let _e54 = local_11;
            let _e56 = lobe_1;
            gabor_impl_add_field((&sum_5), _e43, _e54, (vec2(1f) / _e56.radius));
        }
        continuing {
            let _e25 = i_1;
            i_1 = (_e25 + 1i);
        }
    }
    let _e61 = sum_5;
    return _e61;
}

fn gabor_lobe(cycles_per_unit: f32, orientation: f32, radius: f32, power: f32) -> GaborLobe {
    return GaborLobe(cycles_per_unit, orientation, vec2(radius), power);
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is cut into equal pieces of at most 0.7 cycles per kernel radius, with a lobe in the middle of each.
// The power of Hann's window has a standard deviation of 1/sqrt(12) cycles per kernel radius, so the sum of the lobes
// is nearly flat. The number of pieces is the integer part of a number c. As the fraction of c goes from 0.8 to 1,
// these pieces fade out and a set with one more piece fades in, so that the noise is continuous in frequency and
// spread.

// The number of lobes for `c`; while one set fades into the next, the total of both.
fn gabor_impl_pieces(c: f32) -> i32 {
    var local_12: i32;
    if (fract(c) > 0.8f) {
        local_12 = ((2i * i32(c)) + 1i);
    } else {
        local_12 = i32(c);
    }
    let _e11 = local_12;
    return _e11;
}

// Returns lobe `i` as (position in the range, from -1 to 1; share of the power; number from which its seed derives).
fn gabor_impl_piece(i: i32, c: f32) -> vec3<f32> {
    var i_3: i32;
    var n: i32;
    var left: f32;
    var width: f32;
    i_3 = i;
    n = i32(c);
    left = min((5f - (5f * fract(c))), 1f);
    let _e13 = i_3;
    let _e14 = n;
    if (_e13 >= _e14) {
        {
            let _e16 = i_3;
            let _e17 = n;
            i_3 = (_e16 - _e17);
            let _e19 = n;
            n = (_e19 + 1i);
            let _e23 = left;
            left = (1f - _e23);
        }
    }
    let _e26 = n;
    width = (1f / f32(_e26));
    let _e31 = i_3;
    let _e36 = width;
    let _e40 = left;
    let _e41 = gabor_impl_takeover(_e40);
    let _e42 = width;
    let _e44 = i_3;
    let _e45 = n;
    return vec3<f32>(((((2f * f32(_e31)) + 1f) * _e36) - 1f), (_e41 * _e42), f32((_e44 + ((_e45 & 1i) * 64i))));
}

fn gabor_field_spread(place: GaborPlace, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> GaborField {
    var frequency_7: f32;
    var frequency_spread_1: f32;
    var orientation_spread_1: f32;
    var sum_6: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var shells: f32;
    var shell_count: i32;
    var j_1: i32 = 0i;
    var shell: vec3<f32>;
    var magnitude: f32;
    var directions: f32;
    var direction_count: i32;
    var i_4: i32;
    var direction: vec3<f32>;
    var wave_6: vec2<f32>;
    var field_5: GaborField;
    frequency_7 = frequency;
    frequency_spread_1 = frequency_spread;
    orientation_spread_1 = orientation_spread;
    let _e18 = frequency_7;
    frequency_7 = min(abs(_e18), 1000000f);
    let _e22 = frequency_spread_1;
    frequency_spread_1 = clamp(_e22, 0f, 1f);
    let _e26 = orientation_spread_1;
    orientation_spread_1 = clamp(_e26, 0f, 1.5707963f);
    let _e31 = frequency_spread_1;
    let _e33 = frequency_7;
    shells = clamp((((2.857f * _e31) * _e33) + 0.8f), 1f, 16f);
    let _e41 = shells;
    let _e42 = gabor_impl_pieces(_e41);
    shell_count = _e42;
    loop {
        let _e46 = j_1;
        let _e47 = shell_count;
        if !((_e46 < _e47)) {
            break;
        }
        {
            let _e53 = j_1;
            let _e54 = shells;
            let _e55 = gabor_impl_piece(_e53, _e54);
            shell = _e55;
            let _e57 = frequency_7;
            let _e59 = frequency_spread_1;
            let _e60 = shell;
            magnitude = (_e57 * (1f + (_e59 * _e60.x)));
            let _e67 = orientation_spread_1;
            let _e70 = magnitude;
            directions = clamp((((0.63661975f * _e67) * ((4.44f * _e70) + 0.6f)) + 0.8f), 1f, 64f);
            let _e81 = directions;
            let _e82 = gabor_impl_pieces(_e81);
            direction_count = _e82;
            i_4 = 0i;
            loop {
                let _e86 = i_4;
                let _e87 = direction_count;
                if !((_e86 < _e87)) {
                    break;
                }
                {
                    let _e93 = i_4;
                    let _e94 = directions;
                    let _e95 = gabor_impl_piece(_e93, _e94);
                    direction = _e95;
                    let _e97 = magnitude;
                    let _e98 = orientation_spread_1;
                    let _e99 = direction;
                    let _e103 = gabor_wave_vector(_e97, (orientation + (_e98 * _e99.x)));
                    wave_6 = _e103;
                    let _e105 = wave_6;
                    let _e107 = shell;
                    let _e110 = direction;
                    let _e114 = gabor_derived_seed(seed, i32(((128f * _e107.z) + _e110.z)));
                    let _e115 = gabor_field(place, _e105, _e114);
                    field_5 = _e115;
                    let _e118 = field_5;
                    let _e119 = shell;
                    let _e121 = direction;
                    gabor_impl_add_field((&sum_6), _e118, sqrt((_e119.y * _e121.y)), vec2(1f));
                }
                continuing {
                    let _e90 = i_4;
                    i_4 = (_e90 + 1i);
                }
            }
        }
        continuing {
            let _e50 = j_1;
            j_1 = (_e50 + 1i);
        }
    }
    let _e128 = sum_6;
    return _e128;
}

fn gabor_noise_spread(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> f32 {
    let _e6 = gabor_place_at(p);
    let _e7 = gabor_field_spread(_e6, frequency, orientation, frequency_spread, orientation_spread, seed);
    return _e7.noise;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three unit vectors u_cm, 60 degrees apart and turned at random, each with its own amplitude:
//     n(p) = K / sqrt(3) Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with variance 1. Its gradient is normal with the constant covariance
// K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 2 pi^2 F^2 h^2 I), because sum_m u_cm u_cm^T = 3/2 I, with I the identity.
// Value and gradient are independent. Since none of this depends on the directions, both are also normal over random
// directions.

// The three waves of a node: amplitudes times the waves at the point, and unit vectors along the first two wave vectors.
// The third is their difference, and so is its phase.
struct GaborStar {
    first: vec2<f32>,
    second: vec2<f32>,
    third: vec2<f32>,
    u: vec2<f32>,
    v: vec2<f32>,
}

// `d`: offset of the point from the node, in periods of the waves.
fn gabor_impl_star(words: vec4<u32>, d: vec2<f32>, evolution: f32) -> GaborStar {
    var star: GaborStar;
    let _e10 = gabor_impl_half_turn((0.00000000003880511f * f32(i32(words.w))));
    star.u = _e10;
    let _e13 = star;
    let _e17 = star;
    let _e21 = star;
    star.v = ((0.5f * _e13.u) + (0.8660254f * vec2<f32>(-(_e17.u.y), _e21.u.x)));
    let _e28 = star;
    let _e31 = gabor_impl_wave(dot(_e28.u, d));
    star.first = _e31;
    let _e33 = star;
    let _e36 = gabor_impl_wave(dot(_e33.v, d));
    star.second = _e36;
    let _e38 = star;
    let _e40 = star;
    let _e43 = star;
    let _e48 = gabor_impl_product(_e38.second, vec2<f32>(_e40.first.x, -(_e43.first.y)));
    star.third = _e48;
    let _e51 = gabor_impl_amplitude_at(words.x, evolution);
    let _e52 = star;
    let _e54 = gabor_impl_product(_e51, _e52.first);
    star.first = _e54;
    let _e57 = gabor_impl_amplitude_at(words.y, evolution);
    let _e58 = star;
    let _e60 = gabor_impl_product(_e57, _e58.second);
    star.second = _e60;
    let _e63 = gabor_impl_amplitude_at(words.z, evolution);
    let _e64 = star;
    let _e66 = gabor_impl_product(_e63, _e64.third);
    star.third = _e66;
    let _e67 = star;
    return _e67;
}

// Adds a wave of a node: `a` is its amplitude times the wave at the point, `window` the value and gradient of the node's
// window.
fn gabor_impl_add_wave(sum: ptr<function, GaborField>, window: vec3<f32>, a: vec2<f32>, wave: vec2<f32>) {
    var value_4: vec2<f32>;
    value_4 = (window.x * a);
    let _e8 = (*sum);
    let _e10 = value_4;
    (*sum).noise = (_e8.noise + _e10.y);
    let _e14 = (*sum);
    let _e20 = value_4;
    (*sum).gradient = (_e14.gradient + ((a.y * window.yz) + ((6.2831855f * _e20.x) * wave)));
    let _e27 = (*sum);
    let _e29 = value_4;
    (*sum).quadrature = (_e27.quadrature + _e29.x);
    let _e33 = (*sum);
    let _e39 = value_4;
    (*sum).quadrature_gradient = (_e33.quadrature_gradient + ((a.x * window.yz) - ((6.2831855f * _e39.y) * wave)));
    return;
}

// Unrolling these loops by hand made them four times slower on lavapipe.
fn gabor_field_isotropic(place: GaborPlace, frequency: f32, seed: u32) -> GaborField {
    var frequency_10: f32;
    var salt_4: u32;
    var x_5: GaborAxis;
    var y_4: GaborAxis;
    var stretch_2: vec2<f32>;
    var sum_8: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var j_2: i32 = 0i;
    var row_1: vec4<u32>;
    var i_5: i32;
    var d_1: vec2<f32>;
    var star_1: GaborStar;
    var h: vec2<f32>;
    var window_1: vec3<f32>;
    var field_6: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var local_13: f32;
    frequency_10 = frequency;
    let _e4 = gabor_impl_salt(seed);
    salt_4 = _e4;
    let _e12 = salt_4;
    let _e16 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e12, 0f, place.cells_per_radius.x);
    x_5 = _e16;
    let _e24 = salt_4;
    let _e30 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e24 ^ 1540483477u), 0f, place.cells_per_radius.y);
    y_4 = _e30;
    stretch_2 = (place.cells_per_radius / vec2(1.5f));
    let _e40 = frequency_10;
    frequency_10 = min(abs(_e40), 1000000f);
    loop {
        let _e55 = j_2;
        if !((_e55 < 3i)) {
            break;
        }
        {
            let _e62 = j_2;
            let _e65 = y_4.word[_e62];
            let _e66 = gabor_impl_row(_e65);
            row_1 = _e66;
            i_5 = 0i;
            loop {
                let _e70 = i_5;
                if !((_e70 < 3i)) {
                    break;
                }
                {
                    let _e77 = frequency_10;
                    let _e81 = x_5;
                    let _e83 = i_5;
                    let _e88 = y_4;
                    let _e90 = j_2;
                    d_1 = ((vec2(_e77) / place.cells_per_radius) * vec2<f32>((_e81.offset - f32((_e83 - 1i))), (_e88.offset - f32((_e90 - 1i)))));
                    let _e98 = i_5;
                    let _e101 = x_5.word[_e98];
                    let _e102 = row_1;
                    let _e104 = d_1;
                    let _e106 = gabor_impl_star((_e101 * _e102), _e104, place.evolution);
                    star_1 = _e106;
                    let _e108 = i_5;
                    let _e111 = x_5.node[_e108];
                    let _e113 = j_2;
                    let _e116 = y_4.node[_e113];
                    h = vec2<f32>(_e111.x, _e116.x);
                    let _e120 = h;
                    let _e122 = h;
                    let _e125 = stretch_2;
                    let _e126 = i_5;
                    let _e129 = x_5.node[_e126];
                    let _e131 = j_2;
                    let _e134 = y_4.node[_e131];
                    let _e138 = h;
                    let _e140 = ((_e125 * vec2<f32>(_e129.z, _e134.z)) * _e138.yx);
                    window_1 = vec3<f32>((_e120.x * _e122.y), _e140.x, _e140.y);
                    let _e146 = window_1;
                    let _e147 = star_1;
                    let _e149 = frequency_10;
                    let _e150 = star_1;
                    gabor_impl_add_wave((&sum_8), _e146, _e147.first, (_e149 * _e150.u));
                    let _e155 = window_1;
                    let _e156 = star_1;
                    let _e158 = frequency_10;
                    let _e159 = star_1;
                    gabor_impl_add_wave((&sum_8), _e155, _e156.second, (_e158 * _e159.v));
                    let _e164 = window_1;
                    let _e165 = star_1;
                    let _e167 = frequency_10;
                    let _e168 = star_1;
                    let _e170 = star_1;
                    gabor_impl_add_wave((&sum_8), _e164, _e165.third, (_e167 * (_e168.v - _e170.u)));
                }
                continuing {
                    let _e74 = i_5;
                    i_5 = (_e74 + 1i);
                }
            }
        }
        continuing {
            let _e59 = j_2;
            j_2 = (_e59 + 1i);
        }
    }
    let _e185 = sum_8;
    if false {
        local_13 = 1f;
    } else {
        local_13 = 1.125f;
    }
    let _e197 = local_13;
    gabor_impl_add_field((&field_6), _e185, (0.57735026f / (1459955300000000000000000000f * _e197)), vec2(1f));
    let _e203 = field_6;
    return _e203;
}

fn gabor_noise_isotropic(p: vec2<f32>, frequency: f32, seed: u32) -> f32 {
    let _e3 = gabor_place_at(p);
    let _e4 = gabor_field_isotropic(_e3, frequency, seed);
    return _e4.noise;
}

// ---- Profiles ------------------------------------------------------------------------------------------------------

// Returns (phase - width / 2, phase + width / 2, 1 / width) of stripes, in turns. The mean of a unit vector over `width`
// turns has the length sin(pi width) / (pi width); the polynomial inverts this within 0.0025. The mean of a profile
// between the ends is the change of its integral from one end to the other, divided by the width. Each whole turn adds
// the integral of one period.
fn gabor_impl_ends_at(phase: f32, span: f32) -> vec3<f32> {
    var phase_2: f32;
    var y_5: f32;
    var width_1: f32;
    phase_2 = phase;
    y_5 = max((1f - span), 0f);
    let _e8 = y_5;
    let _e11 = y_5;
    let _e13 = y_5;
    let _e15 = y_5;
    width_1 = (sqrt(_e8) * (0.7796968f + (_e11 * (0.13925488f + (_e13 * ((0.1322011f * _e15) - 0.05362376f))))));
    let _e25 = width_1;
    width_1 = clamp(_e25, 0.001f, 1f);
    let _e29 = phase_2;
    let _e30 = phase_2;
    phase_2 = (_e29 - floor(_e30));
    let _e33 = phase_2;
    let _e35 = width_1;
    let _e38 = phase_2;
    let _e40 = width_1;
    let _e44 = width_1;
    return vec3<f32>((_e33 - (0.5f * _e35)), (_e38 + (0.5f * _e40)), (1f / _e44));
}

fn gabor_impl_ends(stripes: vec2<f32>) -> vec3<f32> {
    var phasor: vec2<f32>;
    let _e2 = gabor_turns_intensity(stripes.yx);
    phasor = _e2;
    let _e4 = phasor;
    let _e6 = phasor;
    let _e8 = gabor_impl_ends_at(_e4.x, _e6.y);
    return _e8;
}

fn gabor_impl_triangle_integral(x: f32) -> f32 {
    var turns: f32;
    var t_2: f32;
    var local_14: f32;
    turns = floor(x);
    let _e3 = turns;
    t_2 = (x - _e3);
    let _e7 = turns;
    let _e9 = t_2;
    if (_e9 < 0.5f) {
        let _e12 = t_2;
        let _e13 = t_2;
        local_14 = (_e12 * _e13);
    } else {
        let _e16 = t_2;
        let _e18 = t_2;
        let _e19 = t_2;
        local_14 = (((2f * _e16) - (_e18 * _e19)) - 0.5f);
    }
    let _e25 = local_14;
    return ((0.5f * _e7) + _e25);
}

fn gabor_profile_triangle(stripes: vec2<f32>) -> f32 {
    var ends: vec3<f32>;
    let _e1 = gabor_impl_ends(stripes);
    ends = _e1;
    let _e3 = ends;
    let _e5 = ends;
    let _e7 = gabor_impl_triangle_integral(_e5.y);
    let _e8 = ends;
    let _e10 = gabor_impl_triangle_integral(_e8.x);
    return (_e3.z * (_e7 - _e10));
}

fn gabor_impl_sawtooth_integral(x: f32) -> f32 {
    var turns_1: f32;
    var t_3: f32;
    turns_1 = floor(x);
    let _e3 = turns_1;
    t_3 = (x - _e3);
    let _e7 = turns_1;
    let _e8 = t_3;
    let _e9 = t_3;
    return (0.5f * (_e7 + (_e8 * _e9)));
}

fn gabor_profile_sawtooth(stripes: vec2<f32>) -> f32 {
    var ends_1: vec3<f32>;
    let _e1 = gabor_impl_ends(stripes);
    ends_1 = _e1;
    let _e3 = ends_1;
    let _e5 = ends_1;
    let _e7 = gabor_impl_sawtooth_integral(_e5.y);
    let _e8 = ends_1;
    let _e10 = gabor_impl_sawtooth_integral(_e8.x);
    return (_e3.z * (_e7 - _e10));
}

fn gabor_impl_pulse_integral(x: f32, duty: f32) -> f32 {
    var turns_2: f32;
    turns_2 = floor(x);
    let _e4 = turns_2;
    let _e6 = turns_2;
    return ((duty * _e4) + min((x - _e6), duty));
}

fn gabor_profile_pulse(stripes: vec2<f32>, duty: f32) -> f32 {
    var ends_2: vec3<f32>;
    let _e2 = gabor_impl_ends(stripes);
    ends_2 = _e2;
    let _e4 = ends_2;
    let _e6 = ends_2;
    let _e8 = gabor_impl_pulse_integral(_e6.y, duty);
    let _e9 = ends_2;
    let _e11 = gabor_impl_pulse_integral(_e9.x, duty);
    return (_e4.z * (_e8 - _e11));
}

