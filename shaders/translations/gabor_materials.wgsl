// Generated from gabor_materials.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 893292f6840a0cad.
//
// gabor_materials.wgsl: twelve materials from Gabor noise.
//
// Paste or include this file after gabor_noise.wgsl and gabor_spectrum.wgsl, with GABOR_TAPS 3.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dFdx(p), dFdy(p), 7u);  // averaged over a pixel
//
//     GaborWood oak = gabor_wood_default();                            // your own parameters, which may vary per pixel
//     oak.rings = 20.0;
//     GaborMaterial o = gabor_wood_at(gabor_pixel(p), oak, 7u);
//
// One unit of p spans a characteristic piece of a material; a picture of four by four units shows the material well.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

struct GaborMaterial {
    colour: vec3<f32>,
    height: f32,
    roughness: f32,
    metalness: f32,
}

// ---- Where to draw -------------------------------------------------------------------------------------------------

// A position and the pixel around it.
struct GaborPixel {
    p: vec2<f32>,
    dx: vec2<f32>,
    dy: vec2<f32>,
    filtered: bool,
    period: vec2<f32>,
}

// GaborPixel gabor_pixel(vec2f p)
//     The point p, without a filter.

// GaborPixel gabor_pixel_filtered(vec2f p, vec2f dx, vec2f dy)
//     The average over a pixel. dx and dy are dFdx(p) and dFdy(p). Noises that only displace the pattern cost as much
//     as without the filter, and all others as much as gabor_noise_filtered.

// GaborPixel gabor_pixel_tiled(GaborPixel pixel, vec2f period)
//     The same pixel in a world that repeats after `period` units of p. Each period holds a whole number of rings or
//     threads; scratches and hair snap to directions that repeat with it.

// ---- Materials -----------------------------------------------------------------------------------------------------
//
// Each material has a struct of parameters, a function that returns their defaults, and a function of a pixel and
// parameters; the short forms use the defaults. Colours are linear, from 0 to 1. Brackets give the number of noises,
// and the shortest period at which the tiled material looks like the untiled one; shorter periods compress its
// large-scale variation. The grain of wood and bark and the streaks of metal follow p: bend p to bend them. Directions
// may vary from pixel to pixel.

// A board cut beside the pith: growth rings, pores and fibres along y [6 noises; period 3 x 9].
struct GaborWood {
    early: vec3<f32>,
    late: vec3<f32>,
    rings: f32,
    waviness: f32,
    pores: f32,
    roughness: f32,
}
// GaborWood gabor_wood_default()
// GaborMaterial gabor_wood_at(GaborPixel pixel, GaborWood wood, u32 seed)
// GaborMaterial gabor_wood(vec2f p, u32 seed)
// GaborMaterial gabor_wood_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Linen, a plain weave of uneven threads; or corduroy, whose cords run along y [5 noises; period 3 x 3].
struct GaborFabric {
    warp: vec3<f32>,
    weft: vec3<f32>,
    threads: f32,
    unevenness: f32,
    relief: f32,
    roughness: f32,
    cords: f32,
}
// GaborFabric gabor_fabric_default()
// GaborMaterial gabor_fabric_at(GaborPixel pixel, GaborFabric fabric, u32 seed)
// GaborMaterial gabor_fabric(vec2f p, u32 seed)
// GaborMaterial gabor_fabric_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Pebbled grain: cells between creases [8 noises; period 3 x 3].
struct GaborLeather {
    pebble: vec3<f32>,
    crease: vec3<f32>,
    cells: f32,
    wrinkles: f32,
    relief: f32,
    roughness: f32,
}
// GaborLeather gabor_leather_default()
// GaborMaterial gabor_leather_at(GaborPixel pixel, GaborLeather leather, u32 seed)
// GaborMaterial gabor_leather(vec2f p, u32 seed)
// GaborMaterial gabor_leather_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    stone: vec3<f32>,
    vein: vec3<f32>,
    veins: f32,
    turbulence: f32,
    clouds: f32,
    roughness: f32,
}
// GaborMarble gabor_marble_default()
// GaborMaterial gabor_marble_at(GaborPixel pixel, GaborMarble marble, u32 seed)
// GaborMaterial gabor_marble(vec2f p, u32 seed)
// GaborMaterial gabor_marble_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    trough: vec3<f32>,
    crest: vec3<f32>,
    ripples: f32,
    relief: f32,
    grain: f32,
    roughness: f32,
}
// GaborSand gabor_sand_default()
// GaborMaterial gabor_sand_at(GaborPixel pixel, GaborSand sand, u32 seed)
// GaborMaterial gabor_sand(vec2f p, u32 seed)
// GaborMaterial gabor_sand_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Water under a light wind [14 noises; period 8 x 8].
struct GaborRipples {
    deep: vec3<f32>,
    shallow: vec3<f32>,
    waves: f32,
    direction: f32,
    spread: f32,
    relief: f32,
    roughness: f32,
}
// GaborRipples gabor_ripples_default()
// GaborMaterial gabor_ripples_at(GaborPixel pixel, GaborRipples ripples, u32 seed)
// GaborMaterial gabor_ripples(vec2f p, u32 seed)
// GaborMaterial gabor_ripples_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Streaks along x [5 noises; period 5 x 1].
struct GaborBrushedMetal {
    colour: vec3<f32>,
    streaks: f32,
    contrast: f32,
    relief: f32,
    roughness: f32,
}
// GaborBrushedMetal gabor_brushed_metal_default()
// GaborMaterial gabor_brushed_metal_at(GaborPixel pixel, GaborBrushedMetal metal, u32 seed)
// GaborMaterial gabor_brushed_metal(vec2f p, u32 seed)
// GaborMaterial gabor_brushed_metal_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    lacquer: vec3<f32>,
    scratch: vec3<f32>,
    amount: f32,
    reach: f32,
    direction: f32,
    spread: f32,
    depth: f32,
    roughness: f32,
}
// GaborScratches gabor_scratches_default()
// GaborMaterial gabor_scratches_at(GaborPixel pixel, GaborScratches scratches, u32 seed)
// GaborMaterial gabor_scratches(vec2f p, u32 seed)
// GaborMaterial gabor_scratches_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    bright: vec3<f32>,
    stripe: vec3<f32>,
    stripes: f32,
    direction: f32,
    bends: f32,
    hair: f32,
    roughness: f32,
}
// GaborZebra gabor_zebra_default()
// GaborMaterial gabor_zebra_at(GaborPixel pixel, GaborZebra zebra, u32 seed)
// GaborMaterial gabor_zebra(vec2f p, u32 seed)
// GaborMaterial gabor_zebra_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    plate: vec3<f32>,
    furrow: vec3<f32>,
    moss: vec3<f32>,
    furrows: f32,
    cover: f32,
    depth: f32,
    roughness: f32,
}
// GaborBark gabor_bark_default()
// GaborMaterial gabor_bark_at(GaborPixel pixel, GaborBark bark, u32 seed)
// GaborMaterial gabor_bark(vec2f p, u32 seed)
// GaborMaterial gabor_bark_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    colour: vec3<f32>,
    tows: f32,
    contrast: f32,
    relief: f32,
    roughness: f32,
}
// GaborCarbonFibre gabor_carbon_fibre_default()
// GaborMaterial gabor_carbon_fibre_at(GaborPixel pixel, GaborCarbonFibre fibres, u32 seed)
// GaborMaterial gabor_carbon_fibre(vec2f p, u32 seed)
// GaborMaterial gabor_carbon_fibre_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    rock: vec3<f32>,
    sandstone: vec3<f32>,
    red: vec3<f32>,
    pale: vec3<f32>,
    layers: f32,
    folds: f32,
    relief: f32,
    roughness: f32,
}
// GaborStrata gabor_strata_default()
// GaborMaterial gabor_strata_at(GaborPixel pixel, GaborStrata strata, u32 seed)
// GaborMaterial gabor_strata(vec2f p, u32 seed)
// GaborMaterial gabor_strata_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// How to filter a nonlinear function f of a noise with variance 1: the filter leaves a value v and removes a share r of
// the variance. The removed part is normal too, so the pixel shows the mean of f(v + sqrt(r) z) over normal z. For the
// functions below, this mean has a closed form: a threshold becomes a normal distribution function; a line along the
// zeros of a noise becomes a Gaussian; an exponential of a noise remains one; and a profile of a phase becomes a mean
// over phases. Materials multiply and mix functions of independent noises, so the filtered colour is the mean of the
// unfiltered colour at every distance. Leather and the weaves fade to a measured mean instead.

// ---- Noises --------------------------------------------------------------------------------------------------------

fn gabor_impl_place(pixel: GaborPixel, density: vec2<f32>) -> GaborPlace {
    if (pixel.period.x > 0f) {
        let _e10 = gabor_place_tiled((density * pixel.p), (density * pixel.period));
        return _e10;
    }
    let _e20 = gabor_place(vec2(0i), ((1.5f * density) * pixel.p));
    return _e20;
}

// Returns two independent noises, the quadrature and noise of one field, and the share of the variance that the filter
// removed. `density` is in kernel radii per unit along x and y.
fn gabor_impl_layer(pixel: GaborPixel, density: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    var density_2: vec2<f32>;
    var place_24: GaborPlace;
    var kernel_10: GaborKernel;
    var removed_8: f32;
    var footprint_6: GaborFootprint;
    var value_11: vec2<f32>;
    density_2 = density;
    let _e6 = density_2;
    let _e7 = gabor_impl_place(pixel, _e6);
    place_24 = _e7;
    let _e9 = gabor_kernel(frequency, orientation);
    kernel_10 = _e9;
    if !(pixel.filtered) {
        let _e13 = place_24;
        let _e14 = kernel_10;
        let _e15 = gabor_field(_e13, _e14, seed);
        return vec3<f32>(_e15.value.x, _e15.value.y, 0f);
    }
    let _e22 = density_2;
    let _e23 = place_24;
    density_2 = (_e22 * (_e23.radius / vec2(1.5f)));
    let _e32 = density_2;
    let _e35 = density_2;
    let _e38 = gabor_footprint((_e32 * pixel.dx), (_e35 * pixel.dy));
    footprint_6 = _e38;
    let _e40 = place_24;
    let _e41 = kernel_10;
    let _e42 = footprint_6;
    let _e45 = gabor_field_filtered(_e40, _e41, _e42, seed, (&removed_8));
    value_11 = _e45.value;
    let _e48 = value_11;
    let _e49 = removed_8;
    return vec3<f32>(_e48.x, _e48.y, _e49);
}

// A layer of frequency 0: spots as large as a kernel.
fn gabor_impl_spots(pixel: GaborPixel, density: vec2<f32>, seed: u32) -> vec3<f32> {
    let _e5 = gabor_impl_layer(pixel, density, 0f, 0f, seed);
    return _e5;
}

// A sum of octaves of spots. Each octave has spots of about half the previous size, and `gain` times the amplitude.
fn gabor_impl_octaves(pixel: GaborPixel, density: vec2<f32>, count: i32, gain: f32, seed: u32) -> vec3<f32> {
    var density_5: vec2<f32>;
    var sum_15: vec3<f32> = vec3(0f);
    var power_5: f32 = 0f;
    var amplitude_4: f32 = 1f;
    var i_7: i32 = 0i;
    density_5 = density;
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
            let _e28 = density_5;
            let _e29 = i_7;
            let _e30 = gabor_lobe_seed(seed, _e29);
            let _e31 = gabor_impl_spots(pixel, _e28, _e30);
            sum_15 = (_e21 + (vec3<f32>(_e22, _e23, (_e24 * _e25)) * _e31));
            let _e34 = power_5;
            let _e35 = amplitude_4;
            let _e36 = amplitude_4;
            power_5 = (_e34 + (_e35 * _e36));
            let _e39 = amplitude_4;
            amplitude_4 = (_e39 * gain);
            let _e41 = density_5;
            density_5 = (_e41 * 2.03f);
        }
        continuing {
            let _e18 = i_7;
            i_7 = (_e18 + 1i);
        }
    }
    let _e44 = sum_15;
    let _e45 = power_5;
    let _e47 = vec2(sqrt(_e45));
    let _e48 = power_5;
    return (_e44 / vec3<f32>(_e47.x, _e47.y, _e48));
}

// Displaces p by two noises, and changes dx and dy accordingly.
fn gabor_impl_warp(pixel: GaborPixel, density: vec2<f32>, amplitude: vec2<f32>, seed: u32) -> GaborPixel {
    var field_14: GaborField;
    var along_x: vec2<f32>;
    var along_y: vec2<f32>;
    let _e4 = gabor_impl_place(pixel, density);
    let _e7 = gabor_kernel(0f, 0f);
    let _e8 = gabor_field(_e4, _e7, seed);
    field_14 = _e8;
    let _e12 = field_14;
    along_x = ((amplitude * density.x) * _e12.slope_x);
    let _e18 = field_14;
    along_y = ((amplitude * density.y) * _e18.slope_y);
    let _e23 = field_14;
    let _e30 = along_x;
    let _e35 = along_y;
    let _e41 = along_x;
    let _e46 = along_y;
    return GaborPixel((pixel.p + (amplitude * _e23.value)), ((pixel.dx + (pixel.dx.x * _e30)) + (pixel.dx.y * _e35)), ((pixel.dy + (pixel.dy.x * _e41)) + (pixel.dy.y * _e46)), pixel.filtered, pixel.period);
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
fn gabor_impl_turned(pixel: GaborPixel, angle: f32) -> GaborPixel {
    var turn_10: vec2<f32>;
    var x_14: vec2<f32>;
    var y_9: vec2<f32>;
    var period_10: vec2<f32> = vec2(0f);
    var whole: vec2<f32>;
    var size: vec2<f32>;
    var local_31: f32;
    var local_32: f32;
    var signs: vec2<f32>;
    var local_33: vec2<f32>;
    var local_34: vec2<f32>;
    var local_35: vec2<f32>;
    var other: vec2<f32>;
    let _e4 = gabor_impl_wave((0.15915494f * angle));
    turn_10 = _e4;
    let _e6 = turn_10;
    x_14 = _e6;
    let _e8 = turn_10;
    let _e11 = turn_10;
    y_9 = vec2<f32>(-(_e8.y), _e11.x);
    if (pixel.period.x > 0f) {
        {
            let _e23 = turn_10;
            whole = floor(((3f * normalize((_e23 / pixel.period))) + vec2(0.5f)));
            let _e33 = whole;
            size = abs(_e33);
            let _e36 = whole;
            if (_e36.x < 0f) {
                local_31 = -1f;
            } else {
                local_31 = 1f;
            }
            let _e44 = local_31;
            let _e45 = whole;
            if (_e45.y < 0f) {
                local_32 = -1f;
            } else {
                local_32 = 1f;
            }
            let _e53 = local_32;
            signs = vec2<f32>(_e44, _e53);
            let _e56 = size;
            let _e58 = size;
            let _e61 = size;
            let _e63 = size;
            if ((_e56.x == _e58.y) || ((_e61.x * _e63.y) == 0f)) {
                let _e69 = signs;
                let _e70 = size;
                whole = (_e69 * min(_e70, vec2(1f)));
            }
            let _e75 = whole;
            size = abs(_e75);
            let _e77 = size;
            let _e81 = size;
            if ((_e77.x > 1f) && (_e81.y > 1f)) {
                let _e86 = size;
                let _e88 = size;
                if (_e86.x > _e88.y) {
                    let _e91 = signs;
                    local_33 = _e91;
                } else {
                    let _e92 = signs;
                    local_33 = -(_e92);
                }
                let _e95 = local_33;
                local_35 = _e95;
            } else {
                let _e96 = size;
                if (_e96.x == 1f) {
                    let _e101 = whole;
                    local_34 = vec2<f32>(0f, _e101.x);
                } else {
                    let _e104 = whole;
                    local_34 = vec2<f32>(-(_e104.y), 0f);
                }
                let _e110 = local_34;
                local_35 = _e110;
            }
            let _e112 = local_35;
            other = _e112;
            let _e115 = whole;
            period_10.x = length((_e115 * pixel.period));
            let _e125 = period_10;
            period_10.y = ((pixel.period.x * pixel.period.y) / _e125.x);
            let _e128 = period_10;
            let _e130 = other;
            let _e132 = other;
            x_14 = ((_e128.x * vec2<f32>(_e130.y, -(_e132.x))) / pixel.period);
            let _e139 = period_10;
            let _e141 = whole;
            let _e144 = whole;
            y_9 = ((_e139.y * vec2<f32>(-(_e141.y), _e144.x)) / pixel.period);
        }
    }
    let _e150 = x_14;
    let _e153 = y_9;
    let _e157 = x_14;
    let _e160 = y_9;
    let _e164 = x_14;
    let _e167 = y_9;
    let _e172 = period_10;
    return GaborPixel(vec2<f32>(dot(_e150, pixel.p), dot(_e153, pixel.p)), vec2<f32>(dot(_e157, pixel.dx), dot(_e160, pixel.dx)), vec2<f32>(dot(_e164, pixel.dy), dot(_e167, pixel.dy)), pixel.filtered, _e172);
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
fn gabor_impl_repeated(pixel: GaborPixel, count: f32, whole: f32) -> vec2<f32> {
    if (pixel.period.x > 0f) {
        return ((max(floor(((pixel.period * (count / whole)) + vec2(0.5f))), vec2(1f)) * whole) / pixel.period);
    }
    return vec2(count);
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// A soft threshold: the normal distribution function of (noise - threshold) / softness, within 2e-5.
fn gabor_impl_above(noise: f32, removed: f32, threshold: f32, softness: f32) -> f32 {
    var scale_4: f32;
    var x_15: f32;
    scale_4 = inverseSqrt(((softness * softness) + removed));
    let _e8 = scale_4;
    let _e10 = scale_4;
    x_15 = clamp(((_e8 * noise) - (_e10 * threshold)), -8f, 8f);
    let _e20 = x_15;
    let _e23 = x_15;
    let _e24 = x_15;
    let _e28 = x_15;
    let _e30 = x_15;
    return (1f / (1f + exp2((-(_e20) * (2.301726f + ((_e23 * _e24) * (0.1061787f - ((0.00091164f * _e28) * _e30))))))));
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

// The phase of a complex noise as a vector: of length 1, or shorter where the filter averages over phases.
fn gabor_impl_phase(layer: vec3<f32>) -> vec2<f32> {
    return (layer.xy * inverseSqrt(((dot(layer.xy, layer.xy) + (2.5f * layer.z)) + 0.000001f)));
}

// The integral of the square of a sawtooth that rises from 0 to 1.
fn gabor_impl_rise_integral(x: f32) -> f32 {
    var turns_4: f32;
    var t_6: f32;
    turns_4 = floor(x);
    let _e3 = turns_4;
    t_6 = (x - _e3);
    let _e7 = turns_4;
    let _e8 = t_6;
    let _e9 = t_6;
    let _e11 = t_6;
    return (0.33333334f * (_e7 + ((_e8 * _e9) * _e11)));
}

// The mean of the square of a sawtooth over the interval (phase, width) that gabor_impl_phase_of returns.
fn gabor_impl_rise(phase: vec2<f32>) -> f32 {
    var ends_4: vec3<f32>;
    let _e3 = gabor_impl_ends(phase.x, phase.y);
    ends_4 = _e3;
    let _e5 = ends_4;
    let _e7 = ends_4;
    let _e9 = gabor_impl_rise_integral(_e7.y);
    let _e10 = ends_4;
    let _e12 = gabor_impl_rise_integral(_e10.x);
    return (_e5.z * (_e9 - _e12));
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
fn gabor_impl_material(colour: vec3<f32>, height: f32, roughness: f32, metalness: f32) -> GaborMaterial {
    return GaborMaterial(clamp(colour, vec3(0f), vec3(1f)), height, roughness, metalness);
}

// ---- Materials -----------------------------------------------------------------------------------------------------

// Rings are lines of constant x that noise of low frequency bends until they close.
fn gabor_wood_at(pixel: GaborPixel, wood: GaborWood, seed: u32) -> GaborMaterial {
    var bends: vec2<f32>;
    var board: GaborPixel;
    var years: GaborPixel;
    var rings: f32;
    var steps: f32;
    var kept_1: f32;
    var ring: f32;
    var pore: vec3<f32>;
    var fibre: vec3<f32>;
    var tone: vec3<f32>;
    var tones: f32;
    var pores: f32;
    var early: f32;
    var late: f32;
    var deep: f32;
    var colour_1: vec3<f32>;
    var height_1: f32;
    bends = (vec2<f32>(0.43f, 0.018f) * wood.waviness);
    let _e12 = bends;
    let _e17 = gabor_lobe_seed(seed, 0i);
    let _e18 = gabor_impl_warp(pixel, vec2<f32>(1.1f, 0.24f), vec2<f32>(_e12.x, 0f), _e17);
    board = _e18;
    let _e20 = board;
    let _e24 = bends;
    let _e29 = gabor_lobe_seed(seed, 1i);
    let _e30 = gabor_impl_warp(_e20, vec2<f32>(4f, 0.9f), vec2<f32>(_e24.y, 0f), _e29);
    board = _e30;
    let _e31 = board;
    let _e41 = gabor_lobe_seed(seed, 2i);
    let _e42 = gabor_impl_warp(_e31, vec2<f32>(6.5f, 0.08f), vec2<f32>((0.455f / wood.rings), 0f), _e41);
    years = _e42;
    let _e46 = gabor_impl_repeated(pixel, wood.rings, 1f);
    rings = _e46.x;
    let _e49 = rings;
    let _e50 = rings;
    let _e52 = years;
    let _e55 = years;
    let _e59 = years;
    let _e62 = years;
    steps = ((_e49 * _e50) * ((_e52.dx.x * _e55.dx.x) + (_e59.dy.x * _e62.dy.x)));
    let _e71 = steps;
    kept_1 = (0.97f * exp(-(min((4.934802f * _e71), 40f))));
    let _e79 = rings;
    let _e80 = years;
    let _e84 = kept_1;
    let _e87 = gabor_impl_phase_of(vec2<f32>(_e84, 0f));
    let _e90 = gabor_impl_rise(vec2<f32>((_e79 * _e80.p.x), _e87.y));
    ring = _e90;
    let _e96 = gabor_lobe_seed(seed, 3i);
    let _e97 = gabor_impl_spots(pixel, vec2<f32>(90f, 4.5f), _e96);
    pore = _e97;
    let _e103 = gabor_lobe_seed(seed, 4i);
    let _e104 = gabor_impl_spots(pixel, vec2<f32>(150f, 2f), _e103);
    fibre = _e104;
    let _e106 = board;
    let _e111 = gabor_lobe_seed(seed, 5i);
    let _e112 = gabor_impl_spots(_e106, vec2<f32>(3.5f, 0.35f), _e111);
    tone = _e112;
    let _e114 = fibre;
    let _e116 = fibre;
    let _e119 = gabor_impl_tone(_e114.y, _e116.z, 0.11f);
    let _e120 = tone;
    let _e122 = tone;
    let _e125 = gabor_impl_tone(_e120.y, _e122.z, 0.13f);
    tones = (_e119 * _e125);
    let _e129 = pore;
    let _e131 = pore;
    let _e135 = gabor_impl_above(_e129.y, _e131.z, 1.1f, 0.25f);
    pores = (wood.pores * _e135);
    let _e139 = ring;
    let _e142 = pores;
    early = ((1f - _e139) * (1f - _e142));
    let _e146 = ring;
    let _e149 = pores;
    late = (_e146 * (1f - (0.25f * _e149)));
    let _e155 = early;
    let _e157 = late;
    deep = ((1f - _e155) - _e157);
    let _e160 = tones;
    let _e161 = early;
    let _e165 = tones;
    let _e166 = late;
    let _e169 = deep;
    colour_1 = (((_e160 * _e161) * wood.early) + (((_e165 * _e166) + (0.45f * _e169)) * wood.late));
    let _e177 = ring;
    let _e180 = deep;
    let _e184 = fibre;
    height_1 = (((0.0006f * _e177) - (0.0024f * _e180)) + (0.0002f * _e184.y));
    let _e189 = colour_1;
    let _e190 = height_1;
    let _e194 = ring;
    let _e199 = gabor_impl_material(_e189, _e190, (wood.roughness * (1f - (0.2f * _e194))), 0f);
    return _e199;
}

fn gabor_fabric_at(pixel: GaborPixel, fabric: GaborFabric, seed: u32) -> GaborMaterial {
    var count_2: vec2<f32>;
    var cloth: GaborPixel;
    var upright: vec3<f32>;
    var level: vec3<f32>;
    var upright_fibre: vec3<f32>;
    var level_fibre: vec3<f32>;
    var at: vec2<f32>;
    var thread: vec2<f32>;
    var within_1: vec2<f32>;
    var local_36: f32;
    var parity: f32;
    var thick: vec2<f32>;
    var inside_1: vec2<f32>;
    var crest: vec2<f32>;
    var first_3: bool;
    var top: f32;
    var local_37: vec3<f32>;
    var tone_1: vec3<f32>;
    var local_38: vec3<f32>;
    var fibre_1: vec3<f32>;
    var steps_1: vec2<f32>;
    var kept_2: f32;
    var uneven: f32;
    var light: f32;
    var local_39: f32;
    var share: f32;
    var colour_2: vec3<f32>;
    var height_2: f32;
    var cords: f32;
    var damped: f32;
    var turn_11: f32;
    var cord: f32;
    let _e5 = gabor_impl_repeated(pixel, fabric.threads, 2f);
    count_2 = _e5;
    let _e14 = gabor_lobe_seed(seed, 0i);
    let _e15 = gabor_impl_warp(pixel, vec2(0.7f), vec2((0.02f * fabric.unevenness)), _e14);
    cloth = _e15;
    let _e17 = cloth;
    let _e19 = count_2;
    let _e25 = gabor_lobe_seed(seed, 1i);
    let _e26 = gabor_impl_spots(_e17, vec2<f32>((0.7f * _e19.x), 1.1f), _e25);
    upright = _e26;
    let _e28 = cloth;
    let _e31 = count_2;
    let _e36 = gabor_lobe_seed(seed, 2i);
    let _e37 = gabor_impl_spots(_e28, vec2<f32>(1.1f, (0.7f * _e31.y)), _e36);
    level = _e37;
    let _e39 = cloth;
    let _e43 = count_2;
    let _e46 = gabor_lobe_seed(seed, 3i);
    let _e47 = gabor_impl_spots(_e39, (vec2<f32>(14f, 2f) * _e43), _e46);
    upright_fibre = _e47;
    let _e49 = cloth;
    let _e53 = count_2;
    let _e56 = gabor_lobe_seed(seed, 4i);
    let _e57 = gabor_impl_spots(_e49, (vec2<f32>(2f, 14f) * _e53), _e56);
    level_fibre = _e57;
    let _e59 = count_2;
    let _e60 = cloth;
    let _e66 = upright;
    let _e68 = level;
    at = ((_e59 * _e60.p) + ((0.13f * fabric.unevenness) * vec2<f32>(_e66.x, _e68.x)));
    let _e74 = at;
    thread = floor(_e74);
    let _e77 = at;
    let _e78 = thread;
    within_1 = ((_e77 - _e78) - vec2(0.5f));
    let _e85 = thread;
    let _e87 = thread;
    if (fract((0.5f * (_e85.x + _e87.y))) > 0.25f) {
        local_36 = -1f;
    } else {
        local_36 = 1f;
    }
    let _e98 = local_36;
    parity = _e98;
    let _e104 = upright;
    let _e106 = level;
    thick = (vec2(1f) + ((0.16f * fabric.unevenness) * vec2<f32>(_e104.y, _e106.y)));
    let _e115 = within_1;
    let _e117 = within_1;
    let _e119 = thick;
    let _e120 = thick;
    inside_1 = (vec2(1f) - (((4.2f * _e115) * _e117) / (_e119 * _e120)));
    let _e126 = thick;
    let _e127 = inside_1;
    let _e137 = parity;
    let _e140 = within_1;
    let _e153 = inside_1;
    crest = ((((_e126 * sqrt(max(_e127, vec2(0f)))) - vec2(1f)) + (((0.55f * _e137) * cos((3.1415927f * _e140.yx))) * vec2<f32>(1f, -1f))) - (vec2(1f) - step(vec2(0f), _e153)));
    let _e160 = crest;
    let _e162 = crest;
    first_3 = (_e160.x > _e162.y);
    let _e166 = crest;
    let _e168 = crest;
    top = max(max(_e166.x, _e168.y), -1.3f);
    let _e175 = first_3;
    if _e175 {
        let _e176 = upright;
        local_37 = _e176;
    } else {
        let _e177 = level;
        local_37 = _e177;
    }
    let _e179 = local_37;
    tone_1 = _e179;
    let _e181 = first_3;
    if _e181 {
        let _e182 = upright_fibre;
        local_38 = _e182;
    } else {
        let _e183 = level_fibre;
        local_38 = _e183;
    }
    let _e185 = local_38;
    fibre_1 = _e185;
    let _e187 = count_2;
    let _e188 = count_2;
    let _e190 = cloth;
    let _e192 = cloth;
    let _e195 = cloth;
    let _e197 = cloth;
    steps_1 = ((_e187 * _e188) * ((_e190.dx * _e192.dx) + (_e195.dy * _e197.dy)));
    let _e204 = steps_1;
    let _e206 = steps_1;
    kept_2 = exp(-(min((2.5f * (_e204.x + _e206.y)), 40f)));
    uneven = fabric.unevenness;
    let _e218 = uneven;
    let _e221 = uneven;
    let _e229 = top;
    let _e231 = kept_2;
    light = mix((0.8572f + (_e218 * (0.005f + (0.0083f * _e221)))), smoothstep(-1.3f, 0.5f, _e229), _e231);
    let _e235 = first_3;
    if _e235 {
        local_39 = 1f;
    } else {
        local_39 = 0f;
    }
    let _e239 = local_39;
    let _e240 = kept_2;
    share = mix(0.5f, _e239, _e240);
    let _e245 = share;
    let _e250 = light;
    colour_2 = (mix(fabric.weft, fabric.warp, vec3(_e245)) * mix(0.18f, 1f, _e250));
    let _e254 = colour_2;
    let _e255 = tone_1;
    let _e257 = tone_1;
    let _e262 = gabor_impl_tone(_e255.y, _e257.z, (0.09f * fabric.unevenness));
    let _e263 = fibre_1;
    let _e265 = fibre_1;
    let _e268 = gabor_impl_tone(_e263.y, _e265.z, 0.12f);
    colour_2 = (_e254 * (_e262 * _e268));
    let _e272 = uneven;
    let _e275 = uneven;
    let _e280 = top;
    let _e281 = kept_2;
    top = mix((0.1352f + (_e272 * (0.0045f + (0.0062f * _e275)))), _e280, _e281);
    let _e287 = top;
    let _e290 = fibre_1;
    height_2 = ((fabric.relief / fabric.threads) * ((0.3f * _e287) + (0.035f * _e290.y)));
    if (fabric.cords > 0f) {
        {
            let _e301 = gabor_impl_repeated(pixel, fabric.cords, 1f);
            cords = _e301.x;
            let _e305 = cords;
            let _e307 = cords;
            let _e309 = cloth;
            let _e312 = cloth;
            let _e316 = cloth;
            let _e319 = cloth;
            damped = exp(-(min((((4.934802f * _e305) * _e307) * ((_e309.dx.x * _e312.dx.x) + (_e316.dy.x * _e319.dy.x))), 20f)));
            let _e331 = cords;
            let _e332 = cloth;
            turn_11 = (6.2831855f * fract((_e331 * _e332.p.x)));
            let _e340 = damped;
            let _e342 = turn_11;
            let _e346 = damped;
            let _e348 = damped;
            let _e350 = damped;
            let _e353 = turn_11;
            cord = (0.625f - (_e340 * ((0.5f * cos(_e342)) + ((((0.125f * _e346) * _e348) * _e350) * cos((2f * _e353))))));
            let _e361 = colour_2;
            let _e364 = cord;
            colour_2 = (_e361 * mix(0.3f, 1f, _e364));
            let _e367 = height_2;
            let _e371 = cords;
            let _e373 = cord;
            height_2 = (_e367 + (((0.3f * fabric.relief) / _e371) * _e373));
        }
    }
    let _e376 = colour_2;
    let _e377 = height_2;
    let _e380 = gabor_impl_material(_e376, _e377, fabric.roughness, 0f);
    return _e380;
}

// Three waves; the phase of the third is the sum of the other two, so the crests of all three meet in each cell's middle.
fn gabor_leather_at(pixel: GaborPixel, leather: GaborLeather, seed: u32) -> GaborMaterial {
    var skin: GaborPixel;
    var density_7: vec2<f32>;
    var one: vec3<f32>;
    var other_1: vec3<f32>;
    var fine: vec3<f32>;
    var tone_2: vec3<f32>;
    var powers: vec2<f32>;
    var a_7: vec2<f32>;
    var b_9: vec2<f32>;
    var cells: f32;
    var shares: vec2<f32>;
    var kept_3: f32;
    var blur: f32;
    var pebble: f32;
    var colour_3: vec3<f32>;
    var dome: f32;
    var height_3: f32;
    let _e10 = gabor_lobe_seed(seed, 0i);
    let _e11 = gabor_impl_warp(pixel, vec2(0.9f), vec2((0.07f * leather.wrinkles)), _e10);
    skin = _e11;
    let _e13 = skin;
    let _e21 = gabor_lobe_seed(seed, 1i);
    let _e22 = gabor_impl_warp(_e13, vec2(4f), vec2((0.014f * leather.wrinkles)), _e21);
    skin = _e22;
    density_7 = vec2((leather.cells / 1.6f));
    let _e28 = skin;
    let _e29 = density_7;
    let _e33 = gabor_lobe_seed(seed, 2i);
    let _e34 = gabor_impl_layer(_e28, _e29, 1.6f, 0.2f, _e33);
    one = _e34;
    let _e36 = skin;
    let _e37 = density_7;
    let _e41 = gabor_lobe_seed(seed, 3i);
    let _e42 = gabor_impl_layer(_e36, _e37, 1.6f, 2.2944f, _e41);
    other_1 = _e42;
    let _e49 = gabor_lobe_seed(seed, 4i);
    let _e50 = gabor_impl_octaves(pixel, vec2(18f), 3i, 0.75f, _e49);
    fine = _e50;
    let _e55 = gabor_lobe_seed(seed, 5i);
    let _e56 = gabor_impl_spots(pixel, vec2(0.8f), _e55);
    tone_2 = _e56;
    let _e58 = one;
    let _e60 = one;
    let _e63 = other_1;
    let _e65 = other_1;
    powers = vec2<f32>(dot(_e58.xy, _e60.xy), dot(_e63.xy, _e65.xy));
    let _e70 = one;
    let _e72 = powers;
    a_7 = (_e70.xy * inverseSqrt((_e72.x + 0.12f)));
    let _e79 = other_1;
    let _e81 = powers;
    b_9 = (_e79.xy * inverseSqrt((_e81.y + 0.12f)));
    let _e88 = a_7;
    let _e90 = b_9;
    let _e93 = a_7;
    let _e94 = b_9;
    let _e95 = gabor_impl_product(_e93, _e94);
    cells = ((_e88.x + _e90.x) + _e95.x);
    let _e99 = powers;
    let _e100 = powers;
    let _e102 = one;
    let _e104 = other_1;
    shares = (_e99 / (_e100 + (2.5f * vec2<f32>(_e102.z, _e104.z))));
    let _e111 = shares;
    let _e113 = shares;
    kept_3 = sqrt((_e111.x * _e113.y));
    let _e119 = kept_3;
    blur = (1f - _e119);
    let _e125 = blur;
    let _e129 = blur;
    let _e131 = cells;
    let _e133 = fine;
    let _e138 = kept_3;
    pebble = mix(0.806f, smoothstep((-1.45f - _e125), (-0.55f + _e129), (_e131 + (0.1f * _e133.y))), _e138);
    let _e143 = pebble;
    colour_3 = mix(leather.crease, leather.pebble, vec3(_e143));
    let _e147 = colour_3;
    let _e148 = tone_2;
    let _e150 = tone_2;
    let _e153 = gabor_impl_tone(_e148.y, _e150.z, 0.14f);
    let _e154 = fine;
    let _e156 = fine;
    let _e159 = gabor_impl_tone(_e154.x, _e156.z, 0.08f);
    colour_3 = (_e147 * (_e153 * _e159));
    let _e166 = cells;
    let _e168 = kept_3;
    dome = mix(0.236f, smoothstep(-1f, 3f, _e166), _e168);
    let _e173 = pebble;
    let _e176 = dome;
    let _e180 = fine;
    height_3 = (leather.relief * (((0.016f * _e173) + (0.013f * _e176)) + (0.0016f * _e180.y)));
    let _e186 = colour_3;
    let _e187 = height_3;
    let _e191 = pebble;
    let _e196 = gabor_impl_material(_e186, _e187, (leather.roughness + (0.15f * (1f - _e191))), 0f);
    return _e196;
}

// Adds veins: lines along the zeros of layer.x, drawn only where layer.y exceeds a threshold, so they have
// ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
fn gabor_impl_vein(colour: vec3<f32>, layer: vec3<f32>, threshold: f32, halo: vec3<f32>, core: vec3<f32>, width: vec2<f32>, strength: vec2<f32>) -> vec3<f32> {
    var strength_1: vec2<f32>;
    var open: f32;
    strength_1 = strength;
    let _e11 = gabor_impl_above(layer.y, layer.z, threshold, 0.5f);
    open = _e11;
    let _e14 = strength_1;
    let _e16 = open;
    let _e20 = gabor_impl_line(layer.x, layer.z, width.y);
    strength_1.y = (_e14.y * (_e16 * _e20));
    let _e24 = strength_1;
    let _e26 = open;
    let _e30 = gabor_impl_line(layer.x, layer.z, width.x);
    let _e32 = strength_1;
    strength_1.x = (_e24.x * ((_e26 * _e30) - _e32.y));
    let _e36 = strength_1;
    let _e41 = strength_1;
    return ((colour + (_e36.x * (halo - colour))) + (_e41.y * (core - colour)));
}

fn gabor_marble_at(pixel: GaborPixel, marble: GaborMarble, seed: u32) -> GaborMaterial {
    var bends_1: vec4<f32>;
    var stone: GaborPixel;
    var large: vec3<f32>;
    var middle: vec3<f32>;
    var thin: vec3<f32>;
    var hair: vec3<f32>;
    var cloud: vec3<f32>;
    var crystal: vec3<f32>;
    var colour_5: vec3<f32>;
    var grey: vec3<f32>;
    bends_1 = (vec4<f32>(0.17f, 0.038f, 0.01f, 0.003f) * marble.turbulence);
    let _e13 = bends_1;
    let _e17 = gabor_lobe_seed(seed, 0i);
    let _e18 = gabor_impl_warp(pixel, vec2(1.1f), vec2(_e13.x), _e17);
    stone = _e18;
    let _e20 = stone;
    let _e23 = bends_1;
    let _e27 = gabor_lobe_seed(seed, 1i);
    let _e28 = gabor_impl_warp(_e20, vec2(4f), vec2(_e23.y), _e27);
    stone = _e28;
    let _e29 = stone;
    let _e32 = bends_1;
    let _e36 = gabor_lobe_seed(seed, 2i);
    let _e37 = gabor_impl_warp(_e29, vec2(13f), vec2(_e32.z), _e36);
    stone = _e37;
    let _e38 = stone;
    let _e41 = bends_1;
    let _e45 = gabor_lobe_seed(seed, 3i);
    let _e46 = gabor_impl_warp(_e38, vec2(40f), vec2(_e41.w), _e45);
    stone = _e46;
    let _e47 = stone;
    let _e53 = gabor_lobe_seed(seed, 4i);
    let _e54 = gabor_impl_layer(_e47, vec2(0.95f), 0.85f, 0.65f, _e53);
    large = _e54;
    let _e56 = stone;
    let _e63 = gabor_lobe_seed(seed, 5i);
    let _e64 = gabor_impl_layer(_e56, vec2(1.9f), 0.95f, -0.45f, _e63);
    middle = _e64;
    let _e66 = stone;
    let _e72 = gabor_lobe_seed(seed, 6i);
    let _e73 = gabor_impl_layer(_e66, vec2(4.5f), 0.95f, 0.95f, _e72);
    thin = _e73;
    let _e75 = stone;
    let _e81 = gabor_lobe_seed(seed, 7i);
    let _e82 = gabor_impl_layer(_e75, vec2(13f), 0.9f, 0.2f, _e81);
    hair = _e82;
    let _e84 = stone;
    let _e90 = gabor_lobe_seed(seed, 8i);
    let _e91 = gabor_impl_octaves(_e84, vec2(1.5f), 3i, 0.6f, _e90);
    cloud = _e91;
    let _e96 = gabor_lobe_seed(seed, 9i);
    let _e97 = gabor_impl_spots(pixel, vec2(75f), _e96);
    crystal = _e97;
    let _e102 = cloud;
    let _e104 = cloud;
    let _e108 = gabor_impl_above(_e102.y, _e104.z, 0.5f, 0.8f);
    colour_5 = (marble.stone * (1f - (marble.clouds * _e108)));
    let _e113 = colour_5;
    let _e114 = crystal;
    let _e116 = crystal;
    let _e119 = gabor_impl_tone(_e114.x, _e116.z, 0.02f);
    colour_5 = (_e113 * _e119);
    grey = mix(marble.stone, marble.vein, vec3(0.65f));
    let _e127 = colour_5;
    let _e128 = middle;
    let _e130 = grey;
    let _e144 = gabor_impl_vein(_e127, _e128, 0.5f, _e130, mix(marble.stone, marble.vein, vec3(0.9f)), vec2<f32>(0.25f, 0.035f), (vec2<f32>(0.6f, 0.6f) * marble.veins));
    colour_5 = _e144;
    let _e145 = colour_5;
    let _e146 = large;
    let _e149 = grey;
    let _e159 = gabor_impl_vein(_e145, _e146, -0.4f, _e149, marble.vein, vec2<f32>(0.35f, 0.05f), (vec2<f32>(0.55f, 0.75f) * marble.veins));
    colour_5 = _e159;
    let _e160 = colour_5;
    let _e161 = thin;
    let _e163 = grey;
    let _e164 = grey;
    let _e173 = gabor_impl_vein(_e160, _e161, 0.8f, _e163, _e164, vec2<f32>(1f, 0.04f), (vec2<f32>(0f, 0.45f) * marble.veins));
    colour_5 = _e173;
    let _e174 = colour_5;
    let _e175 = hair;
    let _e177 = grey;
    let _e191 = gabor_impl_vein(_e174, _e175, 1.1f, _e177, mix(marble.stone, marble.vein, vec3(0.45f)), vec2<f32>(1f, 0.05f), (vec2<f32>(0f, 0.45f) * marble.veins));
    colour_5 = _e191;
    let _e192 = colour_5;
    let _e194 = crystal;
    let _e199 = gabor_impl_material(_e192, (0.00012f * _e194.y), marble.roughness, 0f);
    return _e199;
}

fn gabor_sand_at(pixel: GaborPixel, sand: GaborSand, seed: u32) -> GaborMaterial {
    var dune: GaborPixel;
    var density_8: vec2<f32>;
    var wind: vec3<f32>;
    var grain: vec3<f32>;
    var large_1: vec3<f32>;
    var ripple: f32;
    var colour_6: vec3<f32>;
    var bright: vec3<f32>;
    var height_4: f32;
    let _e8 = gabor_lobe_seed(seed, 0i);
    let _e9 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.15f), _e8);
    dune = _e9;
    let _e11 = dune;
    let _e17 = gabor_lobe_seed(seed, 1i);
    let _e18 = gabor_impl_warp(_e11, vec2(3f), vec2(0.02f), _e17);
    dune = _e18;
    density_8 = (vec2<f32>(0.23255815f, 0.43927652f) * sand.ripples);
    let _e32 = dune;
    let _e33 = density_8;
    let _e37 = gabor_lobe_seed(seed, 2i);
    let _e38 = gabor_impl_layer(_e32, _e33, 2.3f, 1.4f, _e37);
    wind = _e38;
    let _e43 = gabor_lobe_seed(seed, 3i);
    let _e44 = gabor_impl_spots(pixel, vec2(75f), _e43);
    grain = _e44;
    let _e51 = gabor_lobe_seed(seed, 4i);
    let _e52 = gabor_impl_octaves(pixel, vec2(0.6f), 3i, 0.5f, _e51);
    large_1 = _e52;
    let _e55 = wind;
    let _e56 = gabor_impl_phase(_e55);
    let _e58 = gabor_impl_phase_of((0.9f * _e56));
    let _e59 = gabor_impl_rise(_e58);
    ripple = _e59;
    let _e63 = ripple;
    colour_6 = mix(sand.trough, sand.crest, vec3(_e63));
    let _e67 = colour_6;
    let _e68 = grain;
    let _e70 = grain;
    let _e73 = gabor_impl_tone(_e68.x, _e70.z, sand.grain);
    let _e74 = large_1;
    let _e76 = large_1;
    let _e79 = gabor_impl_tone(_e74.y, _e76.z, 0.06f);
    colour_6 = (_e67 * (_e73 * _e79));
    let _e82 = colour_6;
    let _e89 = grain;
    let _e91 = grain;
    let _e95 = gabor_impl_above(_e89.y, _e91.z, 1.9f, 0.15f);
    colour_6 = mix(_e82, (0.23f * sand.trough), vec3(((3.75f * sand.grain) * _e95)));
    bright = mix(sand.crest, vec3(1f), vec3(0.6f));
    let _e106 = colour_6;
    let _e107 = bright;
    let _e111 = grain;
    let _e114 = grain;
    let _e118 = gabor_impl_above(-(_e111.y), _e114.z, 1.9f, 0.15f);
    colour_6 = mix(_e106, _e107, vec3(((3f * sand.grain) * _e118)));
    let _e123 = ripple;
    let _e127 = large_1;
    let _e133 = large_1;
    let _e140 = grain;
    height_4 = ((((sand.relief * _e123) * (1f + (0.2f * _e127.x))) + (0.03f * _e133.x)) + ((0.00875f * sand.grain) * _e140.x));
    let _e145 = colour_6;
    let _e146 = height_4;
    let _e149 = gabor_impl_material(_e145, _e146, sand.roughness, 0f);
    return _e149;
}

// A sum of waves with their second harmonics, after Stokes: crests are sharp and troughs flat. The part of a wave that
// the filter removed does not change the mean of the harmonic.
fn gabor_ripples_at(pixel: GaborPixel, ripples: GaborRipples, seed: u32) -> GaborMaterial {
    var height_5: f32 = 0f;
    var crest_1: f32 = 0f;
    var removed_12: f32 = 0f;
    var power_6: f32 = 0f;
    var i_8: i32 = 0i;
    var waves: f32;
    var angle_1: f32;
    var wave_20: vec3<f32>;
    var amplitude_6: f32;
    var light_1: f32;
    var colour_7: vec3<f32>;
    loop {
        let _e13 = i_8;
        if !((_e13 < 14i)) {
            break;
        }
        {
            let _e22 = i_8;
            waves = (ripples.waves * exp2((0.27f * f32(_e22))));
            let _e31 = i_8;
            angle_1 = (ripples.direction + (ripples.spread * (fract(((0.618034f * f32(_e31)) + 0.1f)) - 0.5f)));
            let _e42 = waves;
            let _e47 = angle_1;
            let _e48 = i_8;
            let _e49 = gabor_lobe_seed(seed, _e48);
            let _e50 = gabor_impl_layer(pixel, vec2((_e42 / 2.2f)), 2.2f, _e47, _e49);
            wave_20 = _e50;
            let _e54 = i_8;
            amplitude_6 = exp2((-0.351f * f32(_e54)));
            let _e59 = height_5;
            let _e60 = amplitude_6;
            let _e61 = wave_20;
            let _e64 = wave_20;
            let _e66 = wave_20;
            let _e69 = wave_20;
            let _e71 = wave_20;
            height_5 = (_e59 + (_e60 * (_e61.x + (0.2f * ((_e64.x * _e66.x) - (_e69.y * _e71.y))))));
            let _e79 = crest_1;
            let _e80 = amplitude_6;
            let _e81 = wave_20;
            crest_1 = (_e79 + (_e80 * _e81.x));
            let _e85 = removed_12;
            let _e86 = amplitude_6;
            let _e87 = amplitude_6;
            let _e89 = wave_20;
            removed_12 = (_e85 + ((_e86 * _e87) * _e89.z));
            let _e93 = power_6;
            let _e94 = amplitude_6;
            let _e95 = amplitude_6;
            power_6 = (_e93 + (_e94 * _e95));
        }
        continuing {
            let _e17 = i_8;
            i_8 = (_e17 + 1i);
        }
    }
    let _e98 = crest_1;
    let _e99 = power_6;
    let _e102 = removed_12;
    let _e103 = power_6;
    let _e107 = gabor_impl_above((_e98 * inverseSqrt(_e99)), (_e102 / _e103), 0.5f, 1f);
    light_1 = _e107;
    let _e111 = light_1;
    colour_7 = mix(ripples.deep, ripples.shallow, vec3(_e111));
    let _e115 = colour_7;
    let _e117 = height_5;
    let _e121 = gabor_impl_material(_e115, (ripples.relief * _e117), ripples.roughness, 0f);
    return _e121;
}

fn gabor_brushed_metal_at(pixel: GaborPixel, metal: GaborBrushedMetal, seed: u32) -> GaborMaterial {
    var height_6: f32 = 0f;
    var tone_3: vec2<f32> = vec2(0f);
    var i_9: i32 = 0i;
    var fine_1: f32;
    var density_9: vec2<f32>;
    var streak: vec3<f32>;
    var colour_8: vec3<f32>;
    loop {
        let _e10 = i_9;
        if !((_e10 < 5i)) {
            break;
        }
        {
            let _e17 = i_9;
            fine_1 = exp2(f32(_e17));
            let _e23 = fine_1;
            let _e27 = fine_1;
            density_9 = vec2<f32>((0.3f + (0.12f * _e23)), (metal.streaks * _e27));
            let _e31 = density_9;
            let _e32 = i_9;
            let _e33 = gabor_lobe_seed(seed, _e32);
            let _e34 = gabor_impl_spots(pixel, _e31, _e33);
            streak = _e34;
            let _e36 = height_6;
            let _e38 = fine_1;
            let _e40 = streak;
            height_6 = (_e36 + ((metal.relief / _e38) * _e40.x));
            let _e44 = tone_3;
            let _e48 = streak;
            tone_3 = (_e44 + (vec2<f32>(0.4472136f, 0.2f) * _e48.yz));
        }
        continuing {
            let _e14 = i_9;
            i_9 = (_e14 + 1i);
        }
    }
    let _e53 = tone_3;
    let _e55 = tone_3;
    let _e58 = gabor_impl_tone(_e53.x, _e55.y, metal.contrast);
    colour_8 = (metal.colour * _e58);
    let _e61 = colour_8;
    let _e62 = height_6;
    let _e65 = gabor_impl_material(_e61, _e62, metal.roughness, 1f);
    return _e65;
}

// Scratches are the peaks of noise with very long and narrow kernels, in many directions.
fn gabor_scratches_at(pixel: GaborPixel, scratches: GaborScratches, seed: u32) -> GaborMaterial {
    var whole_2: f32 = 1f;
    var height_7: f32 = 0f;
    var size_1: f32 = 1f;
    var turn_12: f32 = 0.0955f;
    var threshold_2: f32;
    var i_10: i32 = 0i;
    var turned_2: GaborPixel;
    var density_10: vec2<f32>;
    var noise_7: vec3<f32>;
    var scratch: f32;
    threshold_2 = sqrt((5.76f - (2f * log(scratches.amount))));
    loop {
        let _e21 = i_10;
        if !((_e21 < 14i)) {
            break;
        }
        {
            let _e30 = turn_12;
            let _e35 = gabor_impl_turned(pixel, (scratches.direction + (scratches.spread * (_e30 - 0.5f))));
            turned_2 = _e35;
            let _e37 = turned_2;
            let _e45 = i_10;
            let _e47 = gabor_lobe_seed(seed, (2i * _e45));
            let _e48 = gabor_impl_warp(_e37, vec2<f32>(0.3f, 0.1f), vec2<f32>(0f, 0.17f), _e47);
            turned_2 = _e48;
            let _e54 = size_1;
            density_10 = (vec2<f32>((1f / scratches.reach), 42f) / vec2(_e54));
            let _e58 = turned_2;
            let _e59 = density_10;
            let _e61 = i_10;
            let _e65 = gabor_lobe_seed(seed, ((2i * _e61) + 1i));
            let _e66 = gabor_impl_spots(_e58, _e59, _e65);
            noise_7 = _e66;
            let _e68 = noise_7;
            let _e70 = noise_7;
            let _e72 = threshold_2;
            let _e74 = gabor_impl_above(_e68.x, _e70.z, _e72, 0.2f);
            scratch = _e74;
            let _e76 = scratch;
            let _e77 = noise_7;
            let _e79 = noise_7;
            let _e83 = gabor_impl_above(_e77.y, _e79.z, 0.3f, 0.7f);
            scratch = (_e76 * _e83);
            let _e85 = whole_2;
            let _e89 = size_1;
            let _e92 = scratch;
            whole_2 = (_e85 * (1f - ((0.25f + (0.7f * _e89)) * _e92)));
            let _e96 = height_7;
            let _e98 = size_1;
            let _e100 = scratch;
            height_7 = (_e96 - ((scratches.depth * _e98) * _e100));
            let _e103 = size_1;
            size_1 = (_e103 * 0.9138315f);
            let _e106 = turn_12;
            turn_12 = fract((_e106 + 0.763932f));
        }
        continuing {
            let _e25 = i_10;
            i_10 = (_e25 + 1i);
        }
    }
    let _e112 = whole_2;
    let _e115 = height_7;
    let _e118 = gabor_impl_material(mix(scratches.scratch, scratches.lacquer, vec3(_e112)), _e115, scratches.roughness, 0f);
    return _e118;
}

fn gabor_zebra_at(pixel: GaborPixel, zebra: GaborZebra, seed: u32) -> GaborMaterial {
    var skin_1: GaborPixel;
    var place_25: GaborPlace;
    var lean: f32;
    var stripe: vec3<f32>;
    var hair_1: vec3<f32>;
    var tone_4: vec3<f32>;
    var intensity_2: f32;
    var ragged: f32;
    var dark: f32;
    var colour_9: vec3<f32>;
    let _e8 = gabor_lobe_seed(seed, 0i);
    let _e9 = gabor_impl_warp(pixel, vec2(0.9f), vec2(0.14f), _e8);
    skin_1 = _e9;
    let _e13 = gabor_impl_place(pixel, vec2(0.6f));
    place_25 = _e13;
    let _e15 = place_25;
    let _e18 = gabor_kernel(0f, 0f);
    let _e20 = gabor_lobe_seed(seed, 1i);
    let _e21 = gabor_field(_e15, _e18, _e20);
    lean = _e21.value.x;
    let _e25 = skin_1;
    let _e33 = lean;
    let _e37 = gabor_lobe_seed(seed, 2i);
    let _e38 = gabor_impl_layer(_e25, vec2((zebra.stripes / 1.4f)), 1.4f, (zebra.direction + (zebra.bends * _e33)), _e37);
    stripe = _e38;
    let _e40 = skin_1;
    let _e42 = gabor_impl_turned(_e40, 2.0707963f);
    let _e47 = gabor_lobe_seed(seed, 3i);
    let _e48 = gabor_impl_spots(_e42, vec2<f32>(6f, 80f), _e47);
    hair_1 = _e48;
    let _e53 = gabor_lobe_seed(seed, 4i);
    let _e54 = gabor_impl_spots(pixel, vec2(1.2f), _e53);
    tone_4 = _e54;
    let _e56 = stripe;
    intensity_2 = length(_e56.xy);
    ragged = (0.1f * zebra.hair);
    let _e64 = stripe;
    let _e66 = ragged;
    let _e67 = intensity_2;
    let _e69 = hair_1;
    let _e73 = stripe;
    let _e75 = ragged;
    let _e76 = ragged;
    let _e78 = hair_1;
    let _e85 = intensity_2;
    let _e88 = gabor_impl_above((_e64.x + ((_e66 * _e67) * _e69.x)), (_e73.z + ((_e75 * _e76) * _e78.z)), 0f, (0.01f + (0.09f * _e85)));
    dark = _e88;
    let _e92 = dark;
    colour_9 = mix(zebra.bright, zebra.stripe, vec3(_e92));
    let _e96 = colour_9;
    let _e97 = hair_1;
    let _e99 = hair_1;
    let _e104 = gabor_impl_tone(_e97.y, _e99.z, (0.14f * zebra.hair));
    let _e105 = tone_4;
    let _e107 = tone_4;
    let _e110 = gabor_impl_tone(_e105.y, _e107.z, 0.08f);
    colour_9 = (_e96 * (_e104 * _e110));
    let _e113 = colour_9;
    let _e117 = hair_1;
    let _e122 = gabor_impl_material(_e113, ((0.002f * zebra.hair) * _e117.x), zebra.roughness, 0f);
    return _e122;
}

fn gabor_bark_at(pixel: GaborPixel, bark: GaborBark, seed: u32) -> GaborMaterial {
    var trunk: GaborPixel;
    var density_11: vec2<f32>;
    var furrow: vec3<f32>;
    var crack: vec3<f32>;
    var rough: vec3<f32>;
    var moss: vec3<f32>;
    var shape: f32;
    var plate: f32;
    var worn: f32;
    var covered: f32;
    var top_1: vec3<f32>;
    var colour_10: vec3<f32>;
    var height_8: f32;
    let _e10 = gabor_lobe_seed(seed, 0i);
    let _e11 = gabor_impl_warp(pixel, vec2<f32>(0.8f, 0.35f), vec2<f32>(0.22f, 0.1f), _e10);
    trunk = _e11;
    let _e13 = trunk;
    let _e21 = gabor_lobe_seed(seed, 1i);
    let _e22 = gabor_impl_warp(_e13, vec2<f32>(3f, 1.6f), vec2<f32>(0.05f, 0.05f), _e21);
    trunk = _e22;
    let _e23 = trunk;
    let _e29 = gabor_lobe_seed(seed, 2i);
    let _e30 = gabor_impl_warp(_e23, vec2(10f), vec2(0.013f), _e29);
    trunk = _e30;
    density_11 = (vec2<f32>(0.7692308f, 0.24886878f) * bark.furrows);
    let _e44 = trunk;
    let _e45 = density_11;
    let _e49 = gabor_lobe_seed(seed, 3i);
    let _e50 = gabor_impl_layer(_e44, _e45, 1.3f, 0.1f, _e49);
    furrow = _e50;
    let _e52 = trunk;
    let _e59 = gabor_lobe_seed(seed, 4i);
    let _e60 = gabor_impl_layer(_e52, vec2<f32>(1.2f, 1.3f), 0.9f, 1.5f, _e59);
    crack = _e60;
    let _e62 = trunk;
    let _e69 = gabor_lobe_seed(seed, 5i);
    let _e70 = gabor_impl_octaves(_e62, vec2<f32>(7f, 3f), 5i, 0.75f, _e69);
    rough = _e70;
    let _e76 = gabor_lobe_seed(seed, 6i);
    let _e77 = gabor_impl_spots(pixel, vec2<f32>(1.1f, 0.7f), _e76);
    moss = _e77;
    let _e79 = furrow;
    let _e82 = rough;
    shape = (_e79.x + (0.2f * _e82.x));
    let _e87 = shape;
    let _e88 = furrow;
    let _e91 = rough;
    let _e98 = gabor_impl_above(_e87, (_e88.z + (0.04f * _e91.z)), -0.15f, 0.35f);
    let _e101 = crack;
    let _e103 = crack;
    let _e106 = gabor_impl_line(_e101.x, _e103.z, 0.13f);
    plate = (_e98 * (1f - (0.55f * _e106)));
    let _e112 = rough;
    let _e115 = rough;
    let _e119 = rough;
    let _e123 = gabor_impl_above((_e112.y + (0.25f * _e115.z)), _e119.z, 0.5f, 0.4f);
    worn = (0.5f * _e123);
    let _e127 = moss;
    let _e129 = moss;
    let _e133 = gabor_impl_above(_e127.y, _e129.z, 0.9f, 0.5f);
    covered = (bark.cover * _e133);
    let _e143 = worn;
    top_1 = mix(bark.plate, mix(bark.plate, vec3(1f), vec3(0.13f)), vec3(_e143));
    let _e149 = covered;
    let _e152 = top_1;
    let _e155 = covered;
    let _e159 = plate;
    colour_10 = mix(mix(bark.furrow, bark.moss, vec3(_e149)), mix(_e152, bark.moss, vec3((0.6f * _e155))), vec3(_e159));
    let _e163 = colour_10;
    let _e164 = rough;
    let _e166 = rough;
    let _e169 = gabor_impl_tone(_e164.y, _e166.z, 0.25f);
    colour_10 = (_e163 * _e169);
    let _e172 = plate;
    let _e175 = rough;
    let _e180 = plate;
    height_8 = ((bark.depth * _e172) + ((0.018f * _e175.x) * (0.4f + (0.6f * _e180))));
    let _e186 = colour_10;
    let _e187 = height_8;
    let _e190 = gabor_impl_material(_e186, _e187, bark.roughness, 0f);
    return _e190;
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
fn gabor_carbon_fibre_at(pixel: GaborPixel, fibres: GaborCarbonFibre, seed: u32) -> GaborMaterial {
    var count_3: vec2<f32>;
    var cloth_1: GaborPixel;
    var upright_1: vec3<f32>;
    var level_1: vec3<f32>;
    var tow: vec2<f32>;
    var within_2: vec2<f32>;
    var turn_13: f32;
    var first_4: bool;
    var local_40: vec3<f32>;
    var fibre_2: vec3<f32>;
    var local_41: vec2<f32>;
    var along_across: vec2<f32>;
    var local_42: f32;
    var along_1: f32;
    var across_1: f32;
    var steps_2: vec2<f32>;
    var kept_4: f32;
    var bulge: f32;
    var colour_11: vec3<f32>;
    var height_9: f32;
    let _e5 = gabor_impl_repeated(pixel, fibres.tows, 4f);
    count_3 = _e5;
    let _e12 = gabor_lobe_seed(seed, 0i);
    let _e13 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.008f), _e12);
    cloth_1 = _e13;
    let _e15 = cloth_1;
    let _e19 = count_3;
    let _e22 = gabor_lobe_seed(seed, 1i);
    let _e23 = gabor_impl_spots(_e15, (vec2<f32>(20f, 0.6f) * _e19), _e22);
    upright_1 = _e23;
    let _e25 = cloth_1;
    let _e29 = count_3;
    let _e32 = gabor_lobe_seed(seed, 2i);
    let _e33 = gabor_impl_spots(_e25, (vec2<f32>(0.6f, 20f) * _e29), _e32);
    level_1 = _e33;
    let _e35 = count_3;
    let _e36 = cloth_1;
    tow = floor((_e35 * _e36.p));
    let _e41 = count_3;
    let _e42 = cloth_1;
    let _e45 = tow;
    within_2 = ((_e41 * _e42.p) - _e45);
    let _e50 = tow;
    let _e52 = tow;
    turn_13 = ((4f * fract(((0.25f * (_e50.x + _e52.y)) + 0.125f))) - 0.5f);
    let _e63 = turn_13;
    first_4 = (_e63 < 1.5f);
    let _e67 = first_4;
    if _e67 {
        let _e68 = upright_1;
        local_40 = _e68;
    } else {
        let _e69 = level_1;
        local_40 = _e69;
    }
    let _e71 = local_40;
    fibre_2 = _e71;
    let _e73 = first_4;
    if _e73 {
        let _e74 = within_2;
        local_41 = _e74.yx;
    } else {
        let _e76 = within_2;
        local_41 = _e76;
    }
    let _e78 = local_41;
    along_across = _e78;
    let _e81 = along_across;
    let _e84 = turn_13;
    if (fract(((0.5f * _e84) + 0.25f)) < 0.5f) {
        local_42 = 0f;
    } else {
        local_42 = 1f;
    }
    let _e94 = local_42;
    along_1 = (0.5f * (_e81.x + _e94));
    let _e99 = along_across;
    across_1 = ((2f * _e99.y) - 1f);
    let _e105 = count_3;
    let _e106 = count_3;
    let _e108 = cloth_1;
    let _e110 = cloth_1;
    let _e113 = cloth_1;
    let _e115 = cloth_1;
    steps_2 = ((_e105 * _e106) * ((_e108.dx * _e110.dx) + (_e113.dy * _e115.dy)));
    let _e122 = steps_2;
    let _e124 = steps_2;
    kept_4 = exp(-(min((2.5f * (_e122.x + _e124.y)), 40f)));
    let _e135 = along_1;
    let _e139 = across_1;
    let _e140 = across_1;
    let _e142 = across_1;
    let _e144 = across_1;
    let _e148 = kept_4;
    bulge = mix(0.5093f, (sin((3.1415927f * _e135)) * (1f - (((_e139 * _e140) * _e142) * _e144))), _e148);
    let _e154 = bulge;
    let _e158 = fibre_2;
    let _e160 = fibre_2;
    let _e163 = gabor_impl_tone(_e158.x, _e160.z, fibres.contrast);
    colour_11 = ((fibres.colour * (0.35f + (0.65f * _e154))) * _e163);
    let _e170 = bulge;
    let _e173 = fibre_2;
    height_9 = ((fibres.relief / fibres.tows) * ((0.16f * _e170) + (0.006f * _e173.x)));
    let _e179 = colour_11;
    let _e180 = height_9;
    let _e183 = gabor_impl_material(_e179, _e180, fibres.roughness, 0f);
    return _e183;
}

fn gabor_strata_at(pixel: GaborPixel, strata: GaborStrata, seed: u32) -> GaborMaterial {
    var folds: vec4<f32>;
    var rock: GaborPixel;
    var layers: vec2<f32>;
    var broad: vec3<f32>;
    var band: vec3<f32>;
    var thin_1: vec3<f32>;
    var lamina: vec3<f32>;
    var grain_1: vec3<f32>;
    var soft: f32;
    var colour_12: vec3<f32>;
    var height_10: f32;
    folds = (vec4<f32>(0.2f, 0.016f, 0.022f, 0.004f) * strata.folds);
    let _e15 = folds;
    let _e19 = gabor_lobe_seed(seed, 0i);
    let _e20 = gabor_impl_warp(pixel, vec2<f32>(0.35f, 0.6f), vec2<f32>(0f, _e15.x), _e19);
    rock = _e20;
    let _e22 = rock;
    let _e26 = folds;
    let _e28 = folds;
    let _e32 = gabor_lobe_seed(seed, 1i);
    let _e33 = gabor_impl_warp(_e22, vec2<f32>(1.6f, 2.6f), vec2<f32>(_e26.y, _e28.z), _e32);
    rock = _e33;
    let _e34 = rock;
    let _e38 = folds;
    let _e42 = gabor_lobe_seed(seed, 2i);
    let _e43 = gabor_impl_warp(_e34, vec2<f32>(7f, 10f), vec2(_e38.w), _e42);
    rock = _e43;
    layers = vec2<f32>(1f, strata.layers);
    let _e48 = rock;
    let _e52 = layers;
    let _e55 = gabor_lobe_seed(seed, 3i);
    let _e56 = gabor_impl_spots(_e48, (vec2<f32>(0.1f, 0.33333334f) * _e52), _e55);
    broad = _e56;
    let _e58 = rock;
    let _e62 = layers;
    let _e65 = gabor_lobe_seed(seed, 4i);
    let _e66 = gabor_impl_spots(_e58, (vec2<f32>(0.14f, 1f) * _e62), _e65);
    band = _e66;
    let _e68 = rock;
    let _e72 = layers;
    let _e75 = gabor_lobe_seed(seed, 5i);
    let _e76 = gabor_impl_spots(_e68, (vec2<f32>(0.25f, 2.8333333f) * _e72), _e75);
    thin_1 = _e76;
    let _e78 = rock;
    let _e82 = layers;
    let _e85 = gabor_lobe_seed(seed, 6i);
    let _e86 = gabor_impl_spots(_e78, (vec2<f32>(0.6f, 8.333333f) * _e82), _e85);
    lamina = _e86;
    let _e94 = gabor_lobe_seed(seed, 7i);
    let _e95 = gabor_impl_octaves(pixel, vec2<f32>(16f, 24f), 4i, 0.8f, _e94);
    grain_1 = _e95;
    let _e97 = band;
    let _e99 = band;
    let _e103 = gabor_impl_above(_e97.x, _e99.z, 0.5f, 0.22f);
    soft = _e103;
    let _e107 = broad;
    let _e109 = broad;
    let _e113 = gabor_impl_above(_e107.x, _e109.z, 0f, 0.5f);
    colour_12 = mix(strata.rock, strata.sandstone, vec3(_e113));
    let _e117 = colour_12;
    let _e120 = soft;
    colour_12 = mix(_e117, strata.red, vec3((0.8f * _e120)));
    let _e124 = colour_12;
    let _e127 = thin_1;
    let _e129 = thin_1;
    let _e133 = gabor_impl_above(_e127.x, _e129.z, 1f, 0.2f);
    colour_12 = mix(_e124, strata.pale, vec3((0.75f * _e133)));
    let _e137 = colour_12;
    let _e142 = thin_1;
    let _e144 = thin_1;
    let _e148 = gabor_impl_above(_e142.y, _e144.z, 1.3f, 0.15f);
    colour_12 = mix(_e137, (0.75f * strata.red), vec3((0.6f * _e148)));
    let _e152 = colour_12;
    let _e153 = lamina;
    let _e155 = lamina;
    let _e158 = gabor_impl_tone(_e153.x, _e155.z, 0.13f);
    let _e159 = grain_1;
    let _e161 = grain_1;
    let _e164 = gabor_impl_tone(_e159.x, _e161.z, 0.11f);
    colour_12 = (_e152 * (_e158 * _e164));
    let _e168 = broad;
    let _e172 = soft;
    let _e176 = thin_1;
    let _e181 = lamina;
    let _e186 = grain_1;
    height_10 = (((((0.02f * _e168.y) - (0.012f * _e172)) + (0.006f * _e176.x)) + (0.0015f * _e181.x)) + (0.003f * _e186.y));
    let _e191 = colour_12;
    let _e193 = height_10;
    let _e197 = gabor_impl_material(_e191, (strata.relief * _e193), strata.roughness, 0f);
    return _e197;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_pixel(p: vec2<f32>) -> GaborPixel {
    return GaborPixel(p, vec2(0f), vec2(0f), false, vec2(0f));
}

fn gabor_pixel_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>) -> GaborPixel {
    return GaborPixel(p, dx, dy, true, vec2(0f));
}

fn gabor_pixel_tiled(pixel: GaborPixel, period: vec2<f32>) -> GaborPixel {
    return GaborPixel((pixel.p - (period * floor((pixel.p / period)))), pixel.dx, pixel.dy, pixel.filtered, period);
}

fn gabor_wood_default() -> GaborWood {
    return GaborWood(vec3<f32>(0.5f, 0.275f, 0.115f), vec3<f32>(0.2f, 0.078f, 0.027f), 13f, 1f, 0.75f, 0.5f);
}

fn gabor_fabric_default() -> GaborFabric {
    return GaborFabric(vec3<f32>(0.5f, 0.43f, 0.33f), vec3<f32>(0.6f, 0.53f, 0.42f), 12f, 1f, 1f, 0.85f, 0f);
}

fn gabor_leather_default() -> GaborLeather {
    return GaborLeather(vec3<f32>(0.2f, 0.068f, 0.026f), vec3<f32>(0.04f, 0.014f, 0.007f), 6.88f, 1f, 1f, 0.4f);
}

fn gabor_marble_default() -> GaborMarble {
    return GaborMarble(vec3<f32>(0.8f, 0.79f, 0.77f), vec3<f32>(0.13f, 0.135f, 0.145f), 1f, 1f, 0.25f, 0.2f);
}

fn gabor_sand_default() -> GaborSand {
    return GaborSand(vec3<f32>(0.43f, 0.3f, 0.17f), vec3<f32>(0.6f, 0.44f, 0.265f), 3.87f, 0.055f, 0.16f, 0.9f);
}

fn gabor_ripples_default() -> GaborRipples {
    return GaborRipples(vec3<f32>(0.004f, 0.06f, 0.085f), vec3<f32>(0.03f, 0.25f, 0.27f), 0.6f, 0.8726646f, 1.0471976f, 0.035f, 0.1f);
}

fn gabor_brushed_metal_default() -> GaborBrushedMetal {
    return GaborBrushedMetal(vec3<f32>(0.55f, 0.555f, 0.565f), 9f, 0.09f, 0.0012f, 0.36f);
}

fn gabor_scratches_default() -> GaborScratches {
    return GaborScratches(vec3<f32>(0.035f, 0.042f, 0.05f), vec3<f32>(0.6f, 0.61f, 0.62f), 1f, 3f, 1.5707963f, 3.1415927f, 0.0025f, 0.3f);
}

fn gabor_zebra_default() -> GaborZebra {
    return GaborZebra(vec3<f32>(0.7f, 0.64f, 0.54f), vec3<f32>(0.018f, 0.014f, 0.012f), 1.96f, 0.296706f, 0.3490659f, 1f, 0.7f);
}

fn gabor_bark_default() -> GaborBark {
    return GaborBark(vec3<f32>(0.2f, 0.145f, 0.1f), vec3<f32>(0.025f, 0.014f, 0.008f), vec3<f32>(0.1f, 0.13f, 0.045f), 2.21f, 0.35f, 0.13f, 0.9f);
}

fn gabor_carbon_fibre_default() -> GaborCarbonFibre {
    return GaborCarbonFibre(vec3<f32>(0.028f, 0.029f, 0.031f), 4f, 0.3f, 1f, 0.3f);
}

fn gabor_strata_default() -> GaborStrata {
    return GaborStrata(vec3<f32>(0.5f, 0.22f, 0.09f), vec3<f32>(0.6f, 0.35f, 0.18f), vec3<f32>(0.28f, 0.075f, 0.035f), vec3<f32>(0.74f, 0.58f, 0.4f), 6f, 1f, 1f, 0.9f);
}

fn gabor_wood(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_wood_default();
    let _e4 = gabor_wood_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_fabric(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_fabric_default();
    let _e4 = gabor_fabric_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_leather(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_leather_default();
    let _e4 = gabor_leather_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_marble(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_marble_default();
    let _e4 = gabor_marble_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_sand(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_sand_default();
    let _e4 = gabor_sand_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_ripples(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_ripples_default();
    let _e4 = gabor_ripples_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_brushed_metal(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_brushed_metal_default();
    let _e4 = gabor_brushed_metal_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_scratches(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_scratches_default();
    let _e4 = gabor_scratches_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_zebra(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_zebra_default();
    let _e4 = gabor_zebra_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_bark(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_bark_default();
    let _e4 = gabor_bark_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_carbon_fibre(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_carbon_fibre_default();
    let _e4 = gabor_carbon_fibre_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_strata(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e2 = gabor_pixel(p);
    let _e3 = gabor_strata_default();
    let _e4 = gabor_strata_at(_e2, _e3, seed);
    return _e4;
}

fn gabor_wood_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_wood_default();
    let _e6 = gabor_wood_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_fabric_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_fabric_default();
    let _e6 = gabor_fabric_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_leather_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_leather_default();
    let _e6 = gabor_leather_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_marble_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_marble_default();
    let _e6 = gabor_marble_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_sand_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_sand_default();
    let _e6 = gabor_sand_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_ripples_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_ripples_default();
    let _e6 = gabor_ripples_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_brushed_metal_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_brushed_metal_default();
    let _e6 = gabor_brushed_metal_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_scratches_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_scratches_default();
    let _e6 = gabor_scratches_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_zebra_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_zebra_default();
    let _e6 = gabor_zebra_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_bark_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_bark_default();
    let _e6 = gabor_bark_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_carbon_fibre_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_carbon_fibre_default();
    let _e6 = gabor_carbon_fibre_at(_e4, _e5, seed);
    return _e6;
}

fn gabor_strata_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_pixel_filtered(p, dx, dy);
    let _e5 = gabor_strata_default();
    let _e6 = gabor_strata_at(_e4, _e5, seed);
    return _e6;
}

