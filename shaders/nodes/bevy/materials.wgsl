#define_import_path gabor_noise::materials
#import gabor_noise::lattice::{gabor_lobe_seed, GaborKernel, GaborPlace, GaborField, gabor_kernel, gabor_place, gabor_field, gabor_impl_product, gabor_impl_wave}
#import gabor_noise::spectrum::{gabor_stripes_sawtooth, gabor_stripes_ridges, GaborFootprint, gabor_footprint, gabor_field_filtered}

// gabor_materials.wgsl: twelve materials from Gabor noise: for WGSL.
//
// Generated from shaders/gabor_materials.glsl by tools/translate and naga 30.0.1: change that file, not this one.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dFdx(p), dFdy(p), 7u);  // averaged over a pixel
//
// One unit of p shows a characteristic piece of a material; four by four units make a good picture.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

struct GaborMaterial {
    colour: vec3<f32>,
    height: f32,
    roughness: f32,
    metalness: f32,
}

// a board: year rings cut lengthwise, pores, fibres [6]
fn gabor_wood(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_wood(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// linen: a plain weave of uneven threads [5]
fn gabor_fabric(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_fabric(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// pebbled grain: cells between creases [8]
fn gabor_leather(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_leather(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// white, with veins of four sizes [12]
fn gabor_marble(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_marble(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// wind ripples, steep on one side, and grains [7]
fn gabor_sand(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_sand(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// water under a light wind [14]
fn gabor_ripples(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_ripples(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// streaks along x [5]
fn gabor_brushed_metal(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_brushed_metal(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// hairlines in a dark lacquer [28]
fn gabor_scratches(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_scratches(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// stripes that fork, and hair [5]
fn gabor_zebra(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_zebra(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// furrows and plates, moss [11]
fn gabor_bark(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_bark(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// a twill of black tows [3]
fn gabor_carbon_fibre(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_carbon_fibre(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

// layers of sandstone, seen from the side [11]
fn gabor_strata(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e8 = gabor_impl_strata(GaborPixel(p, vec2(0f), vec2(0f), false), seed);
    return _e8;
}

fn gabor_wood_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_wood(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_fabric_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_fabric(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_leather_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_leather(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_marble_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_marble(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_sand_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_sand(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_ripples_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_ripples(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_brushed_metal_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_brushed_metal(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_scratches_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_scratches(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_zebra_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_zebra(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_bark_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_bark(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_carbon_fibre_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_carbon_fibre(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

fn gabor_strata_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_impl_strata(GaborPixel(p, dx, dy, true), seed);
    return _e6;
}

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// How to filter a nonlinear function f of noise: the pixel's filter leaves the value v of a noise of variance 1, and
// removes the share r of its variance. The removed part is normal too, so the pixel sees the mean of f(v + sqrt(r) z)
// over normal z. For the functions below, this mean has a closed form: a threshold becomes a normal distribution
// function, a line along the zeros of a noise a normal curve, a change of tone an exponential, a profile of a phase a
// mean over phases. Materials multiply and mix functions of independent noises, so the filtered colour equals the mean
// of the sharp one at every distance; leather and the weaves fade to a measured mean.

// A place and the steps to the neighbouring pixels.
struct GaborPixel {
    p: vec2<f32>,
    dx: vec2<f32>,
    dy: vec2<f32>,
    filtered: bool,
}

// Two independent noises, the parts of a complex one, and the removed share of their variance.
//   density  kernels per unit along x and y
fn gabor_impl_layer(pixel: GaborPixel, density: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    var place_22: GaborPlace;
    var kernel_8: GaborKernel;
    var removed_6: f32;
    var footprint_4: GaborFootprint;
    var value_11: vec2<f32>;

    let _e14 = gabor_place(vec2(0i), ((1.5f * density) * pixel.p));
    place_22 = _e14;
    let _e16 = gabor_kernel(frequency, orientation);
    kernel_8 = _e16;
    if !(pixel.filtered) {
        let _e20 = place_22;
        let _e21 = kernel_8;
        let _e22 = gabor_field(_e20, _e21, seed);
        return vec3<f32>(_e22.value.x, _e22.value.y, 0f);
    }
    let _e33 = gabor_footprint((density * pixel.dx), (density * pixel.dy));
    footprint_4 = _e33;
    let _e35 = place_22;
    let _e36 = kernel_8;
    let _e37 = footprint_4;
    let _e40 = gabor_field_filtered(_e35, _e36, _e37, seed, (&removed_6));
    value_11 = _e40.value;
    let _e43 = value_11;
    let _e44 = removed_6;
    return vec3<f32>(_e43.x, _e43.y, _e44);
}

// The same at frequency 0: spots as large as a kernel.
fn gabor_impl_spots(pixel: GaborPixel, density: vec2<f32>, seed: u32) -> vec3<f32> {
    let _e5 = gabor_impl_layer(pixel, density, 0f, 0f, seed);
    return _e5;
}

// A sum of spots, each octave half as large with `gain` times the amplitude.
fn gabor_impl_octaves(pixel: GaborPixel, density: vec2<f32>, count: i32, gain: f32, seed: u32) -> vec3<f32> {
    var density_3: vec2<f32>;
    var sum_15: vec3<f32> = vec3(0f);
    var power_4: f32 = 0f;
    var amplitude_4: f32 = 1f;
    var i_7: i32 = 0i;

    density_3 = density;
    loop {
        let _e15 = i_7;
        if !((_e15 < count)) {
            break;
        }
        {
            let _e21 = sum_15;
            let _e22 = amplitude_4;
            let _e23 = amplitude_4;
            let _e24 = amplitude_4;
            let _e25 = amplitude_4;
            let _e28 = density_3;
            let _e29 = i_7;
            let _e30 = gabor_lobe_seed(seed, _e29);
            let _e31 = gabor_impl_spots(pixel, _e28, _e30);
            sum_15 = (_e21 + (vec3<f32>(_e22, _e23, (_e24 * _e25)) * _e31));
            let _e34 = power_4;
            let _e35 = amplitude_4;
            let _e36 = amplitude_4;
            power_4 = (_e34 + (_e35 * _e36));
            let _e39 = amplitude_4;
            amplitude_4 = (_e39 * gain);
            let _e41 = density_3;
            density_3 = (_e41 * 2.03f);
        }
        continuing {
            let _e18 = i_7;
            i_7 = (_e18 + 1i);
        }
    }
    let _e44 = sum_15;
    let _e45 = power_4;
    let _e47 = vec2(sqrt(_e45));
    let _e48 = power_4;
    return (_e44 / vec3<f32>(_e47.x, _e47.y, _e48));
}

// Moves the place by two noises, and its steps accordingly.
fn gabor_impl_warp(pixel: GaborPixel, density: vec2<f32>, amplitude: vec2<f32>, seed: u32) -> GaborPixel {
    var place_23: GaborPlace;
    var field_13: GaborField;
    var along_x: vec2<f32>;
    var along_y: vec2<f32>;

    let _e13 = gabor_place(vec2(0i), ((1.5f * density) * pixel.p));
    place_23 = _e13;
    let _e15 = place_23;
    let _e18 = gabor_kernel(0f, 0f);
    let _e19 = gabor_field(_e15, _e18, seed);
    field_13 = _e19;
    let _e23 = field_13;
    along_x = ((amplitude * density.x) * _e23.slope_x);
    let _e29 = field_13;
    along_y = ((amplitude * density.y) * _e29.slope_y);
    let _e34 = field_13;
    let _e41 = along_x;
    let _e46 = along_y;
    let _e52 = along_x;
    let _e57 = along_y;
    return GaborPixel((pixel.p + (amplitude * _e34.value)), ((pixel.dx + (pixel.dx.x * _e41)) + (pixel.dx.y * _e46)), ((pixel.dy + (pixel.dy.x * _e52)) + (pixel.dy.y * _e57)), pixel.filtered);
}

// Turns the axes by an angle.
fn gabor_impl_turned(pixel: GaborPixel, angle: f32) -> GaborPixel {
    var turn_10: vec2<f32>;

    let _e5 = gabor_impl_wave((-0.15915494f * angle));
    turn_10 = _e5;
    let _e7 = turn_10;
    let _e9 = gabor_impl_product(_e7, pixel.p);
    let _e10 = turn_10;
    let _e12 = gabor_impl_product(_e10, pixel.dx);
    let _e13 = turn_10;
    let _e15 = gabor_impl_product(_e13, pixel.dy);
    return GaborPixel(_e9, _e12, _e15, pixel.filtered);
}

// Where the noise is above a threshold: the normal distribution function of (noise - threshold) / softness, within
// 1.5e-4 (Bowling et al., "A logistic approximation to the cumulative normal distribution", 2009).
fn gabor_impl_above(noise: f32, removed: f32, threshold: f32, softness: f32) -> f32 {
    var x_14: f32;

    x_14 = clamp(((noise - threshold) * inverseSqrt(((softness * softness) + removed))), -8f, 8f);
    let _e16 = x_14;
    let _e20 = x_14;
    let _e22 = x_14;
    return (1f / (1f + exp((-(_e16) * (1.5976f + ((0.07056f * _e20) * _e22))))));
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
fn gabor_impl_line(noise: f32, removed: f32, width: f32) -> f32 {
    var variance_1: f32;

    variance_1 = ((width * width) + removed);
    let _e6 = variance_1;
    let _e13 = variance_1;
    return ((width * inverseSqrt(_e6)) * exp((((-0.5f * noise) * noise) / _e13)));
}

// A factor of mean 1: exp(contrast noise - contrast^2 / 2).
fn gabor_impl_tone(noise: f32, removed: f32, contrast: f32) -> f32 {
    return exp((contrast * (noise - ((0.5f * contrast) * (1f - removed)))));
}

// The unit vector of a complex noise's phase; shorter where it is a mean.
fn gabor_impl_phase(layer: vec3<f32>) -> vec2<f32> {
    return (layer.xy * inverseSqrt(((dot(layer.xy, layer.xy) + (2.5f * layer.z)) + 0.000001f)));
}

// The same for a phase that grows evenly: the wave after a normal filter.
fn gabor_impl_turns(turns: f32, dx: f32, dy: f32) -> vec2<f32> {
    let _e12 = gabor_impl_wave(turns);
    return (exp(-(min((4.934802f * ((dx * dx) + (dy * dy))), 40f))) * _e12);
}

// The square of a sawtooth from 0 to 1, with mean 1/3: t^2 = t - 4 t (1 - t) / 4.
fn gabor_impl_rise(stripes: vec2<f32>) -> f32 {
    let _e1 = gabor_stripes_sawtooth(stripes);
    let _e3 = gabor_stripes_ridges(stripes);
    return (_e1 - (0.25f * _e3));
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
fn gabor_impl_material(colour: vec3<f32>, height: f32, roughness: f32, metalness: f32) -> GaborMaterial {
    return GaborMaterial(clamp(colour, vec3(0f), vec3(1f)), height, roughness, metalness);
}

// Rings are lines of equal x that slow noise bends until they close: a board cut beside the pith.
fn gabor_impl_wood(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var board: GaborPixel;
    var years: GaborPixel;
    var ring: f32;
    var pore: vec3<f32>;
    var fibre: vec3<f32>;
    var tone: vec3<f32>;
    var pores: f32;
    var colour_1: vec3<f32>;
    var height_1: f32;

    let _e9 = gabor_lobe_seed(seed, 0i);
    let _e10 = gabor_impl_warp(pixel, vec2<f32>(1.1f, 0.24f), vec2<f32>(0.43f, 0f), _e9);
    board = _e10;
    let _e12 = board;
    let _e20 = gabor_lobe_seed(seed, 1i);
    let _e21 = gabor_impl_warp(_e12, vec2<f32>(4f, 0.9f), vec2<f32>(0.018f, 0f), _e20);
    board = _e21;
    let _e22 = board;
    let _e30 = gabor_lobe_seed(seed, 2i);
    let _e31 = gabor_impl_warp(_e22, vec2<f32>(6.5f, 0.08f), vec2<f32>(0.035f, 0f), _e30);
    years = _e31;
    let _e35 = years;
    let _e40 = years;
    let _e45 = years;
    let _e49 = gabor_impl_turns((13f * _e35.p.x), (13f * _e40.dx.x), (13f * _e45.dy.x));
    let _e51 = gabor_impl_rise((0.97f * _e49));
    ring = _e51;
    let _e57 = gabor_lobe_seed(seed, 3i);
    let _e58 = gabor_impl_spots(pixel, vec2<f32>(90f, 4.5f), _e57);
    pore = _e58;
    let _e64 = gabor_lobe_seed(seed, 4i);
    let _e65 = gabor_impl_spots(pixel, vec2<f32>(150f, 2f), _e64);
    fibre = _e65;
    let _e67 = board;
    let _e72 = gabor_lobe_seed(seed, 5i);
    let _e73 = gabor_impl_spots(_e67, vec2<f32>(3.5f, 0.35f), _e72);
    tone = _e73;
    let _e77 = ring;
    let _e80 = pore;
    let _e82 = pore;
    let _e86 = gabor_impl_above(_e80.y, _e82.z, 1.1f, 0.25f);
    pores = ((1f - (0.75f * _e77)) * _e86);
    let _e97 = ring;
    colour_1 = mix(vec3<f32>(0.5f, 0.275f, 0.115f), vec3<f32>(0.2f, 0.078f, 0.027f), vec3(_e97));
    let _e101 = colour_1;
    let _e102 = fibre;
    let _e104 = fibre;
    let _e107 = gabor_impl_tone(_e102.y, _e104.z, 0.11f);
    let _e108 = tone;
    let _e110 = tone;
    let _e113 = gabor_impl_tone(_e108.y, _e110.z, 0.13f);
    colour_1 = (_e101 * (_e107 * _e113));
    let _e116 = colour_1;
    let _e122 = pores;
    colour_1 = mix(_e116, vec3<f32>(0.09f, 0.035f, 0.014f), vec3((0.75f * _e122)));
    let _e127 = ring;
    let _e130 = pores;
    let _e134 = fibre;
    height_1 = (((0.0006f * _e127) - (0.0018f * _e130)) + (0.0002f * _e134.y));
    let _e139 = colour_1;
    let _e140 = height_1;
    let _e143 = ring;
    let _e147 = gabor_impl_material(_e139, _e140, (0.5f - (0.1f * _e143)), 0f);
    return _e147;
}

fn gabor_impl_fabric(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var count_1: f32 = 12f;
    var cloth: GaborPixel;
    var upright: vec3<f32>;
    var level: vec3<f32>;
    var upright_fibre: vec3<f32>;
    var level_fibre: vec3<f32>;
    var at: vec2<f32>;
    var thread: vec2<f32>;
    var within_1: vec2<f32>;
    var local_31: f32;
    var parity: f32;
    var thick: vec2<f32>;
    var inside_1: vec2<f32>;
    var crest: vec2<f32>;
    var first_4: bool;
    var top: f32;
    var local_32: vec3<f32>;
    var tone_1: vec3<f32>;
    var local_33: vec3<f32>;
    var fibre_1: vec3<f32>;
    var steps: vec2<f32>;
    var kept_1: f32;
    var light: f32;
    var local_34: f32;
    var share_2: f32;
    var colour_2: vec3<f32>;

    let _e9 = gabor_lobe_seed(seed, 0i);
    let _e10 = gabor_impl_warp(pixel, vec2(0.7f), vec2(0.02f), _e9);
    cloth = _e10;
    let _e12 = cloth;
    let _e14 = count_1;
    let _e19 = gabor_lobe_seed(seed, 1i);
    let _e20 = gabor_impl_spots(_e12, vec2<f32>((0.7f * _e14), 1.1f), _e19);
    upright = _e20;
    let _e22 = cloth;
    let _e25 = count_1;
    let _e29 = gabor_lobe_seed(seed, 2i);
    let _e30 = gabor_impl_spots(_e22, vec2<f32>(1.1f, (0.7f * _e25)), _e29);
    level = _e30;
    let _e32 = cloth;
    let _e36 = count_1;
    let _e39 = gabor_lobe_seed(seed, 3i);
    let _e40 = gabor_impl_spots(_e32, (vec2<f32>(14f, 2f) * _e36), _e39);
    upright_fibre = _e40;
    let _e42 = cloth;
    let _e46 = count_1;
    let _e49 = gabor_lobe_seed(seed, 4i);
    let _e50 = gabor_impl_spots(_e42, (vec2<f32>(2f, 14f) * _e46), _e49);
    level_fibre = _e50;
    let _e52 = count_1;
    let _e53 = cloth;
    let _e57 = upright;
    let _e59 = level;
    at = ((_e52 * _e53.p) + (0.13f * vec2<f32>(_e57.x, _e59.x)));
    let _e65 = at;
    thread = floor(_e65);
    let _e68 = at;
    let _e69 = thread;
    within_1 = ((_e68 - _e69) - vec2(0.5f));
    let _e76 = thread;
    let _e78 = thread;
    if (fract((0.5f * (_e76.x + _e78.y))) > 0.25f) {
        local_31 = -1f;
    } else {
        local_31 = 1f;
    }
    let _e89 = local_31;
    parity = _e89;
    let _e93 = upright;
    let _e95 = level;
    thick = (vec2(1f) + (0.16f * vec2<f32>(_e93.y, _e95.y)));
    let _e104 = within_1;
    let _e106 = within_1;
    let _e108 = thick;
    let _e109 = thick;
    inside_1 = (vec2(1f) - (((4.2f * _e104) * _e106) / (_e108 * _e109)));
    let _e115 = thick;
    let _e116 = inside_1;
    let _e126 = parity;
    let _e129 = within_1;
    let _e140 = inside_1;
    crest = ((((_e115 * sqrt(max(_e116, vec2(0f)))) - vec2(1f)) + (((0.55f * _e126) * cos((3.1415927f * _e129.yx))) * vec2<f32>(1f, -1f))) - select(vec2(0f), vec2(1f), (_e140 < vec2(0f))));
    let _e151 = crest;
    let _e153 = crest;
    first_4 = (_e151.x > _e153.y);
    let _e157 = crest;
    let _e159 = crest;
    top = max(max(_e157.x, _e159.y), -1.3f);
    let _e166 = first_4;
    if _e166 {
        let _e167 = upright;
        local_32 = _e167;
    } else {
        let _e168 = level;
        local_32 = _e168;
    }
    let _e170 = local_32;
    tone_1 = _e170;
    let _e172 = first_4;
    if _e172 {
        let _e173 = upright_fibre;
        local_33 = _e173;
    } else {
        let _e174 = level_fibre;
        local_33 = _e174;
    }
    let _e176 = local_33;
    fibre_1 = _e176;
    let _e178 = count_1;
    let _e179 = count_1;
    let _e181 = cloth;
    let _e183 = cloth;
    let _e186 = cloth;
    let _e188 = cloth;
    steps = ((_e178 * _e179) * ((_e181.dx * _e183.dx) + (_e186.dy * _e188.dy)));
    let _e195 = steps;
    let _e197 = steps;
    kept_1 = exp(-(min((2.5f * (_e195.x + _e197.y)), 40f)));
    let _e210 = top;
    let _e212 = kept_1;
    light = mix(0.87f, smoothstep(-1.3f, 0.5f, _e210), _e212);
    let _e216 = first_4;
    if _e216 {
        local_34 = 1f;
    } else {
        local_34 = 0f;
    }
    let _e220 = local_34;
    let _e221 = kept_1;
    share_2 = mix(0.5f, _e220, _e221);
    let _e232 = share_2;
    let _e237 = light;
    colour_2 = (mix(vec3<f32>(0.6f, 0.53f, 0.42f), vec3<f32>(0.5f, 0.43f, 0.33f), vec3(_e232)) * mix(0.18f, 1f, _e237));
    let _e241 = colour_2;
    let _e242 = tone_1;
    let _e244 = tone_1;
    let _e247 = gabor_impl_tone(_e242.y, _e244.z, 0.09f);
    let _e248 = fibre_1;
    let _e250 = fibre_1;
    let _e253 = gabor_impl_tone(_e248.y, _e250.z, 0.12f);
    colour_2 = (_e241 * (_e247 * _e253));
    let _e256 = colour_2;
    let _e259 = top;
    let _e260 = kept_1;
    let _e264 = fibre_1;
    let _e268 = count_1;
    let _e272 = gabor_impl_material(_e256, (((0.3f * mix(0.146f, _e259, _e260)) + (0.035f * _e264.y)) / _e268), 0.85f, 0f);
    return _e272;
}

// Two phases and their sum belong to three waves whose crests meet: a lattice of cells, with faults.
fn gabor_impl_leather(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var skin: GaborPixel;
    var one: vec3<f32>;
    var other: vec3<f32>;
    var fine: vec3<f32>;
    var tone_2: vec3<f32>;
    var powers: vec2<f32>;
    var a_7: vec2<f32>;
    var b_9: vec2<f32>;
    var cells: f32;
    var shares: vec2<f32>;
    var kept_2: f32;
    var blur: f32;
    var pebble: f32;
    var colour_3: vec3<f32>;
    var dome: f32;

    let _e7 = gabor_lobe_seed(seed, 0i);
    let _e8 = gabor_impl_warp(pixel, vec2(0.9f), vec2(0.07f), _e7);
    skin = _e8;
    let _e10 = skin;
    let _e16 = gabor_lobe_seed(seed, 1i);
    let _e17 = gabor_impl_warp(_e10, vec2(4f), vec2(0.014f), _e16);
    skin = _e17;
    let _e18 = skin;
    let _e24 = gabor_lobe_seed(seed, 2i);
    let _e25 = gabor_impl_layer(_e18, vec2(4.3f), 1.6f, 0.2f, _e24);
    one = _e25;
    let _e27 = skin;
    let _e33 = gabor_lobe_seed(seed, 3i);
    let _e34 = gabor_impl_layer(_e27, vec2(4.3f), 1.6f, 2.2944f, _e33);
    other = _e34;
    let _e41 = gabor_lobe_seed(seed, 4i);
    let _e42 = gabor_impl_octaves(pixel, vec2(18f), 3i, 0.75f, _e41);
    fine = _e42;
    let _e47 = gabor_lobe_seed(seed, 5i);
    let _e48 = gabor_impl_spots(pixel, vec2(0.8f), _e47);
    tone_2 = _e48;
    let _e50 = one;
    let _e52 = one;
    let _e55 = other;
    let _e57 = other;
    powers = vec2<f32>(dot(_e50.xy, _e52.xy), dot(_e55.xy, _e57.xy));
    let _e62 = one;
    let _e64 = powers;
    a_7 = (_e62.xy * inverseSqrt((_e64.x + 0.12f)));
    let _e71 = other;
    let _e73 = powers;
    b_9 = (_e71.xy * inverseSqrt((_e73.y + 0.12f)));
    let _e80 = a_7;
    let _e82 = b_9;
    let _e85 = a_7;
    let _e86 = b_9;
    let _e87 = gabor_impl_product(_e85, _e86);
    cells = ((_e80.x + _e82.x) + _e87.x);
    let _e91 = powers;
    let _e92 = powers;
    let _e94 = one;
    let _e96 = other;
    shares = (_e91 / (_e92 + (2.5f * vec2<f32>(_e94.z, _e96.z))));
    let _e103 = shares;
    let _e105 = shares;
    kept_2 = sqrt((_e103.x * _e105.y));
    let _e111 = kept_2;
    blur = (1f - _e111);
    let _e117 = blur;
    let _e121 = blur;
    let _e123 = cells;
    let _e125 = fine;
    let _e130 = kept_2;
    pebble = mix(0.806f, smoothstep((-1.45f - _e117), (-0.55f + _e121), (_e123 + (0.1f * _e125.y))), _e130);
    let _e141 = pebble;
    colour_3 = mix(vec3<f32>(0.04f, 0.014f, 0.007f), vec3<f32>(0.2f, 0.068f, 0.026f), vec3(_e141));
    let _e145 = colour_3;
    let _e146 = tone_2;
    let _e148 = tone_2;
    let _e151 = gabor_impl_tone(_e146.y, _e148.z, 0.14f);
    let _e152 = fine;
    let _e154 = fine;
    let _e157 = gabor_impl_tone(_e152.x, _e154.z, 0.08f);
    colour_3 = (_e145 * (_e151 * _e157));
    let _e164 = cells;
    let _e166 = kept_2;
    dome = mix(0.236f, smoothstep(-1f, 3f, _e164), _e166);
    let _e169 = colour_3;
    let _e171 = pebble;
    let _e174 = dome;
    let _e178 = fine;
    let _e184 = pebble;
    let _e188 = gabor_impl_material(_e169, (((0.016f * _e171) + (0.013f * _e174)) + (0.0016f * _e178.y)), (0.55f - (0.15f * _e184)), 0f);
    return _e188;
}

// A vein is every other zero line of a noise, where its other part is high enough: long lines that end.
fn gabor_impl_vein(layer: vec3<f32>, width: f32, threshold: f32) -> f32 {
    let _e5 = gabor_impl_line(layer.x, layer.z, width);
    let _e9 = gabor_impl_above(layer.y, layer.z, threshold, 0.5f);
    return (_e5 * _e9);
}

fn gabor_impl_marble(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var stone: GaborPixel;
    var large: vec3<f32>;
    var middle: vec3<f32>;
    var thin: vec3<f32>;
    var hair: vec3<f32>;
    var cloud: vec3<f32>;
    var crystal: vec3<f32>;
    var colour_4: vec3<f32>;

    let _e7 = gabor_lobe_seed(seed, 0i);
    let _e8 = gabor_impl_warp(pixel, vec2(1.1f), vec2(0.17f), _e7);
    stone = _e8;
    let _e10 = stone;
    let _e16 = gabor_lobe_seed(seed, 1i);
    let _e17 = gabor_impl_warp(_e10, vec2(4f), vec2(0.038f), _e16);
    stone = _e17;
    let _e18 = stone;
    let _e24 = gabor_lobe_seed(seed, 2i);
    let _e25 = gabor_impl_warp(_e18, vec2(13f), vec2(0.01f), _e24);
    stone = _e25;
    let _e26 = stone;
    let _e32 = gabor_lobe_seed(seed, 3i);
    let _e33 = gabor_impl_warp(_e26, vec2(40f), vec2(0.003f), _e32);
    stone = _e33;
    let _e34 = stone;
    let _e40 = gabor_lobe_seed(seed, 4i);
    let _e41 = gabor_impl_layer(_e34, vec2(0.95f), 0.85f, 0.65f, _e40);
    large = _e41;
    let _e43 = stone;
    let _e50 = gabor_lobe_seed(seed, 5i);
    let _e51 = gabor_impl_layer(_e43, vec2(1.9f), 0.95f, -0.45f, _e50);
    middle = _e51;
    let _e53 = stone;
    let _e59 = gabor_lobe_seed(seed, 6i);
    let _e60 = gabor_impl_layer(_e53, vec2(4.5f), 0.95f, 0.95f, _e59);
    thin = _e60;
    let _e62 = stone;
    let _e68 = gabor_lobe_seed(seed, 7i);
    let _e69 = gabor_impl_layer(_e62, vec2(13f), 0.9f, 0.2f, _e68);
    hair = _e69;
    let _e71 = stone;
    let _e77 = gabor_lobe_seed(seed, 8i);
    let _e78 = gabor_impl_octaves(_e71, vec2(1.5f), 3i, 0.6f, _e77);
    cloud = _e78;
    let _e83 = gabor_lobe_seed(seed, 9i);
    let _e84 = gabor_impl_spots(pixel, vec2(75f), _e83);
    crystal = _e84;
    let _e92 = cloud;
    let _e94 = cloud;
    let _e98 = gabor_impl_above(_e92.y, _e94.z, 0.5f, 0.8f);
    colour_4 = (vec3<f32>(0.8f, 0.79f, 0.77f) * (1f - (0.25f * _e98)));
    let _e103 = colour_4;
    let _e104 = crystal;
    let _e106 = crystal;
    let _e109 = gabor_impl_tone(_e104.x, _e106.z, 0.02f);
    colour_4 = (_e103 * _e109);
    let _e111 = colour_4;
    let _e117 = middle;
    let _e120 = gabor_impl_vein(_e117, 0.25f, 0.6f);
    colour_4 = mix(_e111, vec3<f32>(0.36f, 0.37f, 0.385f), vec3((0.6f * _e120)));
    let _e124 = colour_4;
    let _e130 = large;
    let _e134 = gabor_impl_vein(_e130, 0.35f, -0.4f);
    colour_4 = mix(_e124, vec3<f32>(0.36f, 0.37f, 0.385f), vec3((0.55f * _e134)));
    let _e138 = colour_4;
    let _e144 = large;
    let _e148 = gabor_impl_vein(_e144, 0.05f, -0.4f);
    colour_4 = mix(_e138, vec3<f32>(0.13f, 0.135f, 0.145f), vec3((0.75f * _e148)));
    let _e152 = colour_4;
    let _e158 = middle;
    let _e161 = gabor_impl_vein(_e158, 0.035f, 0.4f);
    colour_4 = mix(_e152, vec3<f32>(0.2f, 0.2f, 0.21f), vec3((0.6f * _e161)));
    let _e165 = colour_4;
    let _e171 = thin;
    let _e174 = gabor_impl_vein(_e171, 0.04f, 0.8f);
    colour_4 = mix(_e165, vec3<f32>(0.32f, 0.31f, 0.3f), vec3((0.45f * _e174)));
    let _e178 = colour_4;
    let _e184 = hair;
    let _e187 = gabor_impl_vein(_e184, 0.05f, 1.1f);
    colour_4 = mix(_e178, vec3<f32>(0.5f, 0.47f, 0.43f), vec3((0.45f * _e187)));
    let _e191 = colour_4;
    let _e193 = crystal;
    let _e198 = gabor_impl_material(_e191, (0.00012f * _e193.y), 0.2f, 0f);
    return _e198;
}

fn gabor_impl_sand(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var dune: GaborPixel;
    var wind: vec3<f32>;
    var grain: vec3<f32>;
    var large_1: vec3<f32>;
    var ripple: f32;
    var colour_5: vec3<f32>;
    var height_2: f32;

    let _e7 = gabor_lobe_seed(seed, 0i);
    let _e8 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.15f), _e7);
    dune = _e8;
    let _e10 = dune;
    let _e16 = gabor_lobe_seed(seed, 1i);
    let _e17 = gabor_impl_warp(_e10, vec2(3f), vec2(0.02f), _e16);
    dune = _e17;
    let _e18 = dune;
    let _e25 = gabor_lobe_seed(seed, 2i);
    let _e26 = gabor_impl_layer(_e18, vec2<f32>(0.9f, 1.7f), 2.3f, 1.4f, _e25);
    wind = _e26;
    let _e31 = gabor_lobe_seed(seed, 3i);
    let _e32 = gabor_impl_spots(pixel, vec2(75f), _e31);
    grain = _e32;
    let _e39 = gabor_lobe_seed(seed, 4i);
    let _e40 = gabor_impl_octaves(pixel, vec2(0.6f), 3i, 0.5f, _e39);
    large_1 = _e40;
    let _e43 = wind;
    let _e44 = gabor_impl_phase(_e43);
    let _e46 = gabor_impl_rise((0.9f * _e44));
    ripple = _e46;
    let _e56 = ripple;
    colour_5 = mix(vec3<f32>(0.43f, 0.3f, 0.17f), vec3<f32>(0.6f, 0.44f, 0.265f), vec3(_e56));
    let _e60 = colour_5;
    let _e61 = grain;
    let _e63 = grain;
    let _e66 = gabor_impl_tone(_e61.x, _e63.z, 0.16f);
    let _e67 = large_1;
    let _e69 = large_1;
    let _e72 = gabor_impl_tone(_e67.y, _e69.z, 0.06f);
    colour_5 = (_e60 * (_e66 * _e72));
    let _e75 = colour_5;
    let _e81 = grain;
    let _e83 = grain;
    let _e87 = gabor_impl_above(_e81.y, _e83.z, 1.9f, 0.15f);
    colour_5 = mix(_e75, vec3<f32>(0.1f, 0.075f, 0.05f), vec3((0.6f * _e87)));
    let _e91 = colour_5;
    let _e97 = grain;
    let _e100 = grain;
    let _e104 = gabor_impl_above(-(_e97.y), _e100.z, 1.9f, 0.15f);
    colour_5 = mix(_e91, vec3<f32>(0.85f, 0.76f, 0.62f), vec3((0.5f * _e104)));
    let _e109 = ripple;
    let _e113 = large_1;
    let _e119 = large_1;
    let _e124 = grain;
    height_2 = ((((0.055f * _e109) * (1f + (0.2f * _e113.x))) + (0.03f * _e119.x)) + (0.0014f * _e124.x));
    let _e129 = colour_5;
    let _e130 = height_2;
    let _e133 = gabor_impl_material(_e129, _e130, 0.9f, 0f);
    return _e133;
}

// A sum of waves with their second harmonics, after Stokes: sharp crests, flat troughs. The harmonic of the removed
// part has mean 0.
fn gabor_impl_ripples(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var height_3: f32 = 0f;
    var crest_1: f32 = 0f;
    var removed_10: f32 = 0f;
    var power_5: f32 = 0f;
    var i_8: i32 = 0i;
    var waves: f32;
    var angle_1: f32;
    var wave_20: vec3<f32>;
    var amplitude_6: f32;
    var light_1: f32;

    loop {
        let _e12 = i_8;
        if !((_e12 < 14i)) {
            break;
        }
        {
            let _e21 = i_8;
            waves = (0.6f * exp2((0.27f * f32(_e21))));
            let _e30 = i_8;
            angle_1 = (0.3f + (1.1f * fract(((0.618034f * f32(_e30)) + 0.1f))));
            let _e39 = waves;
            let _e44 = angle_1;
            let _e45 = i_8;
            let _e46 = gabor_lobe_seed(seed, _e45);
            let _e47 = gabor_impl_layer(pixel, vec2((_e39 / 2.2f)), 2.2f, _e44, _e46);
            wave_20 = _e47;
            let _e50 = waves;
            amplitude_6 = (0.018f / pow(_e50, 1.3f));
            let _e55 = height_3;
            let _e56 = amplitude_6;
            let _e57 = wave_20;
            let _e60 = wave_20;
            let _e62 = wave_20;
            let _e65 = wave_20;
            let _e67 = wave_20;
            height_3 = (_e55 + (_e56 * (_e57.x + (0.2f * ((_e60.x * _e62.x) - (_e65.y * _e67.y))))));
            let _e75 = crest_1;
            let _e76 = amplitude_6;
            let _e77 = wave_20;
            crest_1 = (_e75 + (_e76 * _e77.x));
            let _e81 = removed_10;
            let _e82 = amplitude_6;
            let _e83 = amplitude_6;
            let _e85 = wave_20;
            removed_10 = (_e81 + ((_e82 * _e83) * _e85.z));
            let _e89 = power_5;
            let _e90 = amplitude_6;
            let _e91 = amplitude_6;
            power_5 = (_e89 + (_e90 * _e91));
        }
        continuing {
            let _e16 = i_8;
            i_8 = (_e16 + 1i);
        }
    }
    let _e94 = crest_1;
    let _e95 = power_5;
    let _e98 = removed_10;
    let _e99 = power_5;
    let _e103 = gabor_impl_above((_e94 * inverseSqrt(_e95)), (_e98 / _e99), 0.5f, 1f);
    light_1 = _e103;
    let _e113 = light_1;
    let _e116 = height_3;
    let _e119 = gabor_impl_material(mix(vec3<f32>(0.004f, 0.06f, 0.085f), vec3<f32>(0.03f, 0.25f, 0.27f), vec3(_e113)), _e116, 0.1f, 0f);
    return _e119;
}

fn gabor_impl_brushed_metal(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var height_4: f32 = 0f;
    var tone_3: vec2<f32> = vec2(0f);
    var i_9: i32 = 0i;
    var fine_1: f32;
    var streak: vec3<f32>;

    loop {
        let _e9 = i_9;
        if !((_e9 < 5i)) {
            break;
        }
        {
            let _e16 = i_9;
            fine_1 = exp2(f32(_e16));
            let _e22 = fine_1;
            let _e26 = fine_1;
            let _e29 = i_9;
            let _e30 = gabor_lobe_seed(seed, _e29);
            let _e31 = gabor_impl_spots(pixel, vec2<f32>((0.3f + (0.12f * _e22)), (9f * _e26)), _e30);
            streak = _e31;
            let _e33 = height_4;
            let _e35 = fine_1;
            let _e37 = streak;
            height_4 = (_e33 + ((0.0012f / _e35) * _e37.x));
            let _e41 = tone_3;
            let _e45 = streak;
            tone_3 = (_e41 + (vec2<f32>(0.4472136f, 0.2f) * _e45.yz));
        }
        continuing {
            let _e13 = i_9;
            i_9 = (_e13 + 1i);
        }
    }
    let _e53 = tone_3;
    let _e55 = tone_3;
    let _e58 = gabor_impl_tone(_e53.x, _e55.y, 0.09f);
    let _e60 = height_4;
    let _e63 = gabor_impl_material((vec3<f32>(0.55f, 0.555f, 0.565f) * _e58), _e60, 0.36f, 1f);
    return _e63;
}

// Needles are the peaks of noise with kernels a hundred times as long as wide, in many directions.
fn gabor_impl_scratches(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var whole: f32 = 1f;
    var height_5: f32 = 0f;
    var i_10: i32 = 0i;
    var size: f32;
    var turned_2: GaborPixel;
    var noise_7: vec3<f32>;
    var scratch: f32;
    var colour_6: vec3<f32>;

    loop {
        let _e8 = i_10;
        if !((_e8 < 14i)) {
            break;
        }
        {
            let _e17 = i_10;
            size = exp2((-0.13f * f32(_e17)));
            let _e24 = i_10;
            let _e28 = gabor_impl_turned(pixel, (0.3f + (2.399963f * f32(_e24))));
            turned_2 = _e28;
            let _e30 = turned_2;
            let _e38 = i_10;
            let _e40 = gabor_lobe_seed(seed, (2i * _e38));
            let _e41 = gabor_impl_warp(_e30, vec2<f32>(0.3f, 0.1f), vec2<f32>(0f, 0.17f), _e40);
            turned_2 = _e41;
            let _e42 = turned_2;
            let _e46 = size;
            let _e50 = i_10;
            let _e54 = gabor_lobe_seed(seed, ((2i * _e50) + 1i));
            let _e55 = gabor_impl_spots(_e42, (vec2<f32>(0.33f, 42f) / vec2(_e46)), _e54);
            noise_7 = _e55;
            let _e57 = noise_7;
            let _e59 = noise_7;
            let _e63 = gabor_impl_above(_e57.x, _e59.z, 2.4f, 0.2f);
            let _e64 = noise_7;
            let _e66 = noise_7;
            let _e70 = gabor_impl_above(_e64.y, _e66.z, 0.3f, 0.7f);
            scratch = (_e63 * _e70);
            let _e73 = whole;
            let _e77 = size;
            let _e80 = scratch;
            whole = (_e73 * (1f - ((0.25f + (0.7f * _e77)) * _e80)));
            let _e84 = height_5;
            let _e86 = size;
            let _e88 = scratch;
            height_5 = (_e84 - ((0.0025f * _e86) * _e88));
        }
        continuing {
            let _e12 = i_10;
            i_10 = (_e12 + 1i);
        }
    }
    let _e99 = whole;
    colour_6 = mix(vec3<f32>(0.6f, 0.61f, 0.62f), vec3<f32>(0.035f, 0.042f, 0.05f), vec3(_e99));
    let _e103 = colour_6;
    let _e104 = height_5;
    let _e107 = gabor_impl_material(_e103, _e104, 0.3f, 0f);
    return _e107;
}

fn gabor_impl_zebra(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var skin_1: GaborPixel;
    var lean: f32;
    var stripe: vec3<f32>;
    var hair_1: vec3<f32>;
    var tone_4: vec3<f32>;
    var intensity_2: f32;
    var dark: f32;
    var colour_7: vec3<f32>;

    let _e7 = gabor_lobe_seed(seed, 0i);
    let _e8 = gabor_impl_warp(pixel, vec2(0.9f), vec2(0.14f), _e7);
    skin_1 = _e8;
    let _e20 = gabor_place(vec2(0i), (0.90000004f * pixel.p));
    let _e23 = gabor_kernel(0f, 0f);
    let _e25 = gabor_lobe_seed(seed, 1i);
    let _e26 = gabor_field(_e20, _e23, _e25);
    lean = _e26.value.x;
    let _e30 = skin_1;
    let _e36 = lean;
    let _e40 = gabor_lobe_seed(seed, 2i);
    let _e41 = gabor_impl_layer(_e30, vec2(1.4f), 1.4f, (0.3f + (0.35f * _e36)), _e40);
    stripe = _e41;
    let _e43 = skin_1;
    let _e45 = gabor_impl_turned(_e43, 0.5f);
    let _e50 = gabor_lobe_seed(seed, 3i);
    let _e51 = gabor_impl_spots(_e45, vec2<f32>(80f, 6f), _e50);
    hair_1 = _e51;
    let _e56 = gabor_lobe_seed(seed, 4i);
    let _e57 = gabor_impl_spots(pixel, vec2(1.2f), _e56);
    tone_4 = _e57;
    let _e59 = stripe;
    intensity_2 = length(_e59.xy);
    let _e63 = stripe;
    let _e66 = intensity_2;
    let _e68 = hair_1;
    let _e72 = stripe;
    let _e75 = hair_1;
    let _e82 = intensity_2;
    let _e85 = gabor_impl_above((_e63.x + ((0.1f * _e66) * _e68.x)), (_e72.z + (0.01f * _e75.z)), 0f, (0.01f + (0.09f * _e82)));
    dark = _e85;
    let _e95 = dark;
    colour_7 = mix(vec3<f32>(0.7f, 0.64f, 0.54f), vec3<f32>(0.018f, 0.014f, 0.012f), vec3(_e95));
    let _e99 = colour_7;
    let _e100 = hair_1;
    let _e102 = hair_1;
    let _e105 = gabor_impl_tone(_e100.y, _e102.z, 0.14f);
    let _e106 = tone_4;
    let _e108 = tone_4;
    let _e111 = gabor_impl_tone(_e106.y, _e108.z, 0.08f);
    colour_7 = (_e99 * (_e105 * _e111));
    let _e114 = colour_7;
    let _e116 = hair_1;
    let _e121 = gabor_impl_material(_e114, (0.002f * _e116.x), 0.7f, 0f);
    return _e121;
}

fn gabor_impl_bark(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var trunk: GaborPixel;
    var furrow: vec3<f32>;
    var crack: vec3<f32>;
    var rough: vec3<f32>;
    var moss: vec3<f32>;
    var plate: f32;
    var colour_8: vec3<f32>;
    var height_6: f32;

    let _e9 = gabor_lobe_seed(seed, 0i);
    let _e10 = gabor_impl_warp(pixel, vec2<f32>(0.8f, 0.35f), vec2<f32>(0.22f, 0.1f), _e9);
    trunk = _e10;
    let _e12 = trunk;
    let _e20 = gabor_lobe_seed(seed, 1i);
    let _e21 = gabor_impl_warp(_e12, vec2<f32>(3f, 1.6f), vec2<f32>(0.05f, 0.05f), _e20);
    trunk = _e21;
    let _e22 = trunk;
    let _e28 = gabor_lobe_seed(seed, 2i);
    let _e29 = gabor_impl_warp(_e22, vec2(10f), vec2(0.013f), _e28);
    trunk = _e29;
    let _e30 = trunk;
    let _e37 = gabor_lobe_seed(seed, 3i);
    let _e38 = gabor_impl_layer(_e30, vec2<f32>(1.7f, 0.55f), 1.3f, 0.1f, _e37);
    furrow = _e38;
    let _e40 = trunk;
    let _e47 = gabor_lobe_seed(seed, 4i);
    let _e48 = gabor_impl_layer(_e40, vec2<f32>(1.2f, 1.3f), 0.9f, 1.5f, _e47);
    crack = _e48;
    let _e50 = trunk;
    let _e57 = gabor_lobe_seed(seed, 5i);
    let _e58 = gabor_impl_octaves(_e50, vec2<f32>(7f, 3f), 5i, 0.75f, _e57);
    rough = _e58;
    let _e64 = gabor_lobe_seed(seed, 6i);
    let _e65 = gabor_impl_spots(pixel, vec2<f32>(1.1f, 0.7f), _e64);
    moss = _e65;
    let _e67 = furrow;
    let _e70 = rough;
    let _e74 = furrow;
    let _e77 = rough;
    let _e84 = gabor_impl_above((_e67.x + (0.2f * _e70.x)), (_e74.z + (0.04f * _e77.z)), -0.15f, 0.35f);
    let _e87 = crack;
    let _e89 = crack;
    let _e92 = gabor_impl_line(_e87.x, _e89.z, 0.13f);
    plate = (_e84 * (1f - (0.55f * _e92)));
    let _e105 = plate;
    colour_8 = mix(vec3<f32>(0.025f, 0.014f, 0.008f), vec3<f32>(0.2f, 0.145f, 0.1f), vec3(_e105));
    let _e109 = colour_8;
    let _e110 = rough;
    let _e112 = rough;
    let _e115 = gabor_impl_tone(_e110.y, _e112.z, 0.25f);
    colour_8 = (_e109 * _e115);
    let _e117 = colour_8;
    let _e123 = plate;
    let _e125 = rough;
    let _e127 = rough;
    let _e131 = gabor_impl_above(_e125.x, _e127.z, 0.5f, 0.4f);
    colour_8 = mix(_e117, vec3<f32>(0.3f, 0.27f, 0.225f), vec3(((0.5f * _e123) * _e131)));
    let _e135 = colour_8;
    let _e141 = moss;
    let _e143 = moss;
    let _e147 = gabor_impl_above(_e141.y, _e143.z, 0.9f, 0.5f);
    let _e151 = plate;
    colour_8 = mix(_e135, vec3<f32>(0.1f, 0.13f, 0.045f), vec3(((0.35f * _e147) * (1f - (0.4f * _e151)))));
    let _e158 = plate;
    let _e161 = rough;
    let _e166 = plate;
    height_6 = ((0.13f * _e158) + ((0.018f * _e161.x) * (0.4f + (0.6f * _e166))));
    let _e172 = colour_8;
    let _e173 = height_6;
    let _e176 = gabor_impl_material(_e172, _e173, 0.9f, 0f);
    return _e176;
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
fn gabor_impl_carbon_fibre(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var count_2: f32 = 4f;
    var cloth_1: GaborPixel;
    var upright_1: vec3<f32>;
    var level_1: vec3<f32>;
    var tow: vec2<f32>;
    var within_2: vec2<f32>;
    var turn_11: f32;
    var first_5: bool;
    var local_35: vec3<f32>;
    var fibre_2: vec3<f32>;
    var local_36: vec2<f32>;
    var along_across: vec2<f32>;
    var local_37: f32;
    var along_1: f32;
    var across_1: f32;
    var steps_1: vec2<f32>;
    var kept_3: f32;
    var bulge: f32;
    var colour_9: vec3<f32>;

    let _e9 = gabor_lobe_seed(seed, 0i);
    let _e10 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.008f), _e9);
    cloth_1 = _e10;
    let _e12 = cloth_1;
    let _e16 = count_2;
    let _e19 = gabor_lobe_seed(seed, 1i);
    let _e20 = gabor_impl_spots(_e12, (vec2<f32>(20f, 0.6f) * _e16), _e19);
    upright_1 = _e20;
    let _e22 = cloth_1;
    let _e26 = count_2;
    let _e29 = gabor_lobe_seed(seed, 2i);
    let _e30 = gabor_impl_spots(_e22, (vec2<f32>(0.6f, 20f) * _e26), _e29);
    level_1 = _e30;
    let _e32 = count_2;
    let _e33 = cloth_1;
    tow = floor((_e32 * _e33.p));
    let _e38 = count_2;
    let _e39 = cloth_1;
    let _e42 = tow;
    within_2 = ((_e38 * _e39.p) - _e42);
    let _e47 = tow;
    let _e49 = tow;
    turn_11 = ((4f * fract(((0.25f * (_e47.x + _e49.y)) + 0.125f))) - 0.5f);
    let _e60 = turn_11;
    first_5 = (_e60 < 1.5f);
    let _e64 = first_5;
    if _e64 {
        let _e65 = upright_1;
        local_35 = _e65;
    } else {
        let _e66 = level_1;
        local_35 = _e66;
    }
    let _e68 = local_35;
    fibre_2 = _e68;
    let _e70 = first_5;
    if _e70 {
        let _e71 = within_2;
        local_36 = _e71.yx;
    } else {
        let _e73 = within_2;
        local_36 = _e73;
    }
    let _e75 = local_36;
    along_across = _e75;
    let _e78 = along_across;
    let _e81 = turn_11;
    if (fract(((0.5f * _e81) + 0.25f)) < 0.5f) {
        local_37 = 0f;
    } else {
        local_37 = 1f;
    }
    let _e91 = local_37;
    along_1 = (0.5f * (_e78.x + _e91));
    let _e96 = along_across;
    across_1 = ((2f * _e96.y) - 1f);
    let _e102 = count_2;
    let _e103 = count_2;
    let _e105 = cloth_1;
    let _e107 = cloth_1;
    let _e110 = cloth_1;
    let _e112 = cloth_1;
    steps_1 = ((_e102 * _e103) * ((_e105.dx * _e107.dx) + (_e110.dy * _e112.dy)));
    let _e119 = steps_1;
    let _e121 = steps_1;
    kept_3 = exp(-(min((2.5f * (_e119.x + _e121.y)), 40f)));
    let _e132 = along_1;
    let _e136 = across_1;
    let _e137 = across_1;
    let _e139 = across_1;
    let _e141 = across_1;
    let _e145 = kept_3;
    bulge = mix(0.51f, (sin((3.1415927f * _e132)) * (1f - (((_e136 * _e137) * _e139) * _e141))), _e145);
    let _e154 = bulge;
    let _e158 = fibre_2;
    let _e160 = fibre_2;
    let _e163 = gabor_impl_tone(_e158.x, _e160.z, 0.3f);
    colour_9 = ((vec3<f32>(0.028f, 0.029f, 0.031f) * (0.35f + (0.65f * _e154))) * _e163);
    let _e166 = colour_9;
    let _e168 = bulge;
    let _e171 = fibre_2;
    let _e175 = count_2;
    let _e179 = gabor_impl_material(_e166, (((0.16f * _e168) + (0.006f * _e171.x)) / _e175), 0.3f, 0f);
    return _e179;
}

fn gabor_impl_strata(pixel: GaborPixel, seed: u32) -> GaborMaterial {
    var rock: GaborPixel;
    var broad: vec3<f32>;
    var band: vec3<f32>;
    var thin_1: vec3<f32>;
    var lamina: vec3<f32>;
    var grain_1: vec3<f32>;
    var soft: f32;
    var colour_10: vec3<f32>;
    var height_7: f32;

    let _e9 = gabor_lobe_seed(seed, 0i);
    let _e10 = gabor_impl_warp(pixel, vec2<f32>(0.35f, 0.6f), vec2<f32>(0f, 0.2f), _e9);
    rock = _e10;
    let _e12 = rock;
    let _e20 = gabor_lobe_seed(seed, 1i);
    let _e21 = gabor_impl_warp(_e12, vec2<f32>(1.6f, 2.6f), vec2<f32>(0.016f, 0.022f), _e20);
    rock = _e21;
    let _e22 = rock;
    let _e29 = gabor_lobe_seed(seed, 2i);
    let _e30 = gabor_impl_warp(_e22, vec2<f32>(7f, 10f), vec2(0.004f), _e29);
    rock = _e30;
    let _e31 = rock;
    let _e36 = gabor_lobe_seed(seed, 3i);
    let _e37 = gabor_impl_spots(_e31, vec2<f32>(0.1f, 2f), _e36);
    broad = _e37;
    let _e39 = rock;
    let _e44 = gabor_lobe_seed(seed, 4i);
    let _e45 = gabor_impl_spots(_e39, vec2<f32>(0.14f, 6f), _e44);
    band = _e45;
    let _e47 = rock;
    let _e52 = gabor_lobe_seed(seed, 5i);
    let _e53 = gabor_impl_spots(_e47, vec2<f32>(0.25f, 17f), _e52);
    thin_1 = _e53;
    let _e55 = rock;
    let _e60 = gabor_lobe_seed(seed, 6i);
    let _e61 = gabor_impl_spots(_e55, vec2<f32>(0.6f, 50f), _e60);
    lamina = _e61;
    let _e69 = gabor_lobe_seed(seed, 7i);
    let _e70 = gabor_impl_octaves(pixel, vec2<f32>(16f, 24f), 4i, 0.8f, _e69);
    grain_1 = _e70;
    let _e72 = band;
    let _e74 = band;
    let _e78 = gabor_impl_above(_e72.x, _e74.z, 0.5f, 0.22f);
    soft = _e78;
    let _e88 = broad;
    let _e90 = broad;
    let _e94 = gabor_impl_above(_e88.x, _e90.z, 0f, 0.5f);
    colour_10 = mix(vec3<f32>(0.5f, 0.22f, 0.09f), vec3<f32>(0.6f, 0.35f, 0.18f), vec3(_e94));
    let _e98 = colour_10;
    let _e104 = soft;
    colour_10 = mix(_e98, vec3<f32>(0.28f, 0.075f, 0.035f), vec3((0.8f * _e104)));
    let _e108 = colour_10;
    let _e114 = thin_1;
    let _e116 = thin_1;
    let _e120 = gabor_impl_above(_e114.x, _e116.z, 1f, 0.2f);
    colour_10 = mix(_e108, vec3<f32>(0.74f, 0.58f, 0.4f), vec3((0.75f * _e120)));
    let _e124 = colour_10;
    let _e130 = thin_1;
    let _e132 = thin_1;
    let _e136 = gabor_impl_above(_e130.y, _e132.z, 1.3f, 0.15f);
    colour_10 = mix(_e124, vec3<f32>(0.2f, 0.06f, 0.035f), vec3((0.6f * _e136)));
    let _e140 = colour_10;
    let _e141 = lamina;
    let _e143 = lamina;
    let _e146 = gabor_impl_tone(_e141.x, _e143.z, 0.13f);
    let _e147 = grain_1;
    let _e149 = grain_1;
    let _e152 = gabor_impl_tone(_e147.x, _e149.z, 0.11f);
    colour_10 = (_e140 * (_e146 * _e152));
    let _e156 = broad;
    let _e160 = soft;
    let _e164 = thin_1;
    let _e169 = lamina;
    let _e174 = grain_1;
    height_7 = (((((0.02f * _e156.y) - (0.012f * _e160)) + (0.006f * _e164.x)) + (0.0015f * _e169.x)) + (0.003f * _e174.y));
    let _e179 = colour_10;
    let _e180 = height_7;
    let _e183 = gabor_impl_material(_e179, _e180, 0.9f, 0f);
    return _e183;
}
