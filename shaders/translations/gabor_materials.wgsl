// Generated from gabor_materials.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 2cf0c8cdcac32683.
// Paste it after gabor_noise.wgsl, gabor_spectrum.wgsl, gabor_filter.wgsl.
//
// gabor_materials.wgsl: eleven materials from Gabor noise.
//
// Paste or include this file after gabor_noise.wgsl, gabor_spectrum.wgsl and, for the filtered forms,
// gabor_filter.wgsl.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, slope, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dpdx(p), dpdy(p), 7u);  // averaged over a pixel
//
//     GaborWood oak = gabor_wood_default();                            // your own parameters, which may vary per pixel
//     oak.rings = 20.0;
//     GaborMaterial o = gabor_wood_at(p, vec2f(0.0), oak, 7u);
//
//     I want                                   call
//     a material                               gabor_wood, gabor_fabric, gabor_leather, gabor_marble and so on
//     the same without moire, at any distance  gabor_wood_filtered(p, dpdx(p), dpdy(p), seed)
//     my own colours, sizes and periods        gabor_wood_at, gabor_wood_filtered_at
//     a normal                                 normalize(vec3f(-m.slope, 1.0)), in the space of p
//     highlights that stay right far away      gabor_roughness(m) instead of m.roughness
//
// One unit of p spans a characteristic piece of a material; a picture of four by four units shows the material well.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

struct GaborMaterial {
    colour: vec3<f32>, // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    height: f32, // height in units of p
    slope: vec2<f32>, // derivatives of the height along x and y
    roughness: f32, // roughness as in glTF, without what the filter removed
    metalness: f32, // 0 or 1, or between them at the edges of patina
    lost: vec3<f32>, // covariance of the slopes that the filter removed: xx, yy, xy
}

// f32 gabor_roughness(GaborMaterial material)
//     The roughness with `lost`, for shading without anisotropy. With alpha = roughness^2 as in GGX, alpha^2 grows by
//     half of the variance of the removed slopes: with this share, GGX reflects a room most nearly as the relief does.

// ---- Materials -----------------------------------------------------------------------------------------------------
//
// Each has a struct of parameters and these functions, here for wood:
//
// GaborWood gabor_wood_default()
// GaborMaterial gabor_wood(vec2f p, u32 seed)
// GaborMaterial gabor_wood_filtered(vec2f p, vec2f dx, vec2f dy, u32 seed)
// GaborMaterial gabor_wood_at(vec2f p, vec2f period, GaborWood wood, u32 seed)
// GaborMaterial gabor_wood_filtered_at(vec2f p, vec2f dx, vec2f dy, vec2f period, GaborWood wood, u32 seed)
//
// The first two take the default parameters. The filtered ones average over a pixel; dx and dy are dpdx(p) and dpdy(p).
// Noises that only displace the pattern then cost as much as without the filter. `period` is in units of p, vec2f(0.0)
// for none: a period holds a whole number of rings or threads, and scratches and hair snap to directions that fit it.
//
// Colours are linear, from 0 to 1. Brackets give the number of noises, and the shortest period at which the tiled
// material looks like the untiled one; shorter periods compress its large-scale variation. The grain of wood and bark
// and the streaks of metal follow p: bend p to bend them. Directions may vary from pixel to pixel.

// A board cut beside the pith: growth rings, pores and fibres along y [6 noises; period 3 x 9].
struct GaborWood {
    earlywood_colour: vec3<f32>, // colour of the early wood
    latewood_colour: vec3<f32>, // colour of the late wood
    rings: f32, // growth rings per unit, 2 to 60
    waviness: f32, // how much the rings bend, 0 to 3
    pore_strength: f32, // strength of the pores, 0 to 1
    roughness: f32, // roughness of the early wood, 0 to 1
}

// Linen, a plain weave of uneven threads; twill or herringbone; or corduroy, whose cords run along y [5 noises; period
// 3 x 3].
struct GaborFabric {
    warp_colour: vec3<f32>, // colour of the threads along y
    weft_colour: vec3<f32>, // colour of the threads along x
    threads: f32, // threads per unit, 2 to 60
    unevenness: f32, // unevenness of the threads' thickness, shade and course, 0 to 2
    relief: f32, // height of the weave and of the cords, relative to the default, 0 to 3
    roughness: f32, // 0 to 1
    cords: f32, // cords per unit, 0 to 20
    weave: f32, // plain weave 0, twill 1, herringbone 2, 0 to 2
}

// Pebbled grain: cells between creases [8 noises; period 3 x 3].
struct GaborLeather {
    pebble_colour: vec3<f32>, // colour of the cells
    crease_colour: vec3<f32>, // colour between the cells
    cells: f32, // cells per unit, 2 to 30
    waviness: f32, // how much the rows of cells bend, 0 to 3
    relief: f32, // height of the cells, relative to the default, 0 to 3
    roughness: f32, // roughness of the cells, 0 to 0.7
}

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    stone_colour: vec3<f32>, // colour of the stone
    vein_colour: vec3<f32>, // colour of the darkest veins
    vein_strength: f32, // strength of the veins, 0 to 1.3
    turbulence: f32, // how much the veins bend, 0 to 2
    cloud_strength: f32, // darkening by clouds, 0 to 1
    roughness: f32, // 0 to 1
}

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    trough_colour: vec3<f32>, // colour of the troughs
    crest_colour: vec3<f32>, // colour of the crests
    ripples: f32, // ripples per unit, 1 to 20
    ripple_height: f32, // height of the ripples, in units, 0 to 0.2
    grain_contrast: f32, // contrast of the grains, 0 to 0.25
    roughness: f32, // 0 to 1
}

// Streaks along x, and patina [5 noises, 11 with patina; period 5 x 1].
struct GaborBrushedMetal {
    metal_colour: vec3<f32>, // colour of the metal
    patina_colour: vec3<f32>, // colour of the patina
    streaks: f32, // number of the widest streaks per unit, 1 to 50
    streak_contrast: f32, // contrast of the streaks, 0 to 0.5
    streak_height: f32, // height of the widest streaks, in units, 0 to 0.01
    roughness: f32, // roughness of the metal, 0 to 1
    patina_amount: f32, // amount of patina, 0 to 1
}

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    lacquer_colour: vec3<f32>, // colour of the lacquer
    scratch_colour: vec3<f32>, // colour in the scratches
    amount: f32, // number of scratches, relative to the default, 0.01 to 8
    scratch_length: f32, // length of the scratches, in units, 0.3 to 10
    scratch_direction: f32, // mean direction along the scratches, -6.2832 to 6.2832 radians
    direction_spread: f32, // half-width of the range of their directions, 0 to 1.5708 radians: pi/2 for all
    depth: f32, // depth of the scratches, in units, 0 to 0.02
    roughness: f32, // 0 to 1
}

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    background_colour: vec3<f32>, // colour between the stripes
    stripe_colour: vec3<f32>, // colour of the stripes
    stripes: f32, // stripes per unit, 0.5 to 20
    orientation: f32, // direction across the stripes, as that of a wave vector, -6.2832 to 6.2832 radians
    bend_angle: f32, // how much the stripes' direction changes, 0 to 1.5708 radians
    hair_contrast: f32, // contrast of the hair, 0 to 3
    roughness: f32, // 0 to 1
}

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    plate_colour: vec3<f32>, // colour of the plates
    furrow_colour: vec3<f32>, // colour of the furrows
    moss_colour: vec3<f32>, // colour of the moss
    furrows: f32, // furrows per unit, 0.5 to 10
    moss_amount: f32, // amount of moss, 0 to 1
    depth: f32, // depth of the furrows, in units, 0 to 0.4
    roughness: f32, // 0 to 1
}

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    colour: vec3<f32>, // colour of the fibres
    tows: f32, // tows per unit, 1 to 20
    fibre_contrast: f32, // contrast of the fibres, 0 to 0.6
    relief: f32, // height of the tows, relative to the default, 0 to 3
    roughness: f32, // 0 to 1
}

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    dark_rock_colour: vec3<f32>, // colour of the darker rock
    light_rock_colour: vec3<f32>, // colour of the lighter rock
    soft_layer_colour: vec3<f32>, // colour of the soft layers
    thin_layer_colour: vec3<f32>, // colour of the thin layers
    layers: f32, // layers per unit, 1 to 30
    folding: f32, // how much the layers bend, 0 to 3
    relief: f32, // height of the layers, relative to the default, 0 to 3
    roughness: f32, // 0 to 1
}

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// How to filter a nonlinear function f of a noise with variance 1: the filter leaves a value v and removes a share r of
// the variance. The removed part is normal too, so the pixel shows the mean of f(v + sqrt(r) z) over normal z. For the
// functions below, this mean has a closed form: a threshold becomes a normal distribution function; a line along the
// zeros of a noise becomes a Gaussian; an exponential of a noise remains one; and a profile of a phase becomes a mean
// over phases. Materials multiply and mix functions of independent noises, so the filtered colour is the mean of the
// unfiltered colour at every distance. Leather and the weaves average samples, and fade to a measured mean.
//
// The slope f'(v + sqrt(r) z) g, where the noise's gradient g has a removed part of covariance C, has the covariance
//     E[f'^2] (C + g g^T) - E[f']^2 g g^T
// over what the filter removed. A height is a sum of such terms; their covariances add up.
//
// Each material has a function that lists its layers, one that gathers their noises, one that gathers them filtered, and
// one that shades them. Those that filter are loops, because compilers inline the filter for each call.

// Computes values with derivatives along x and y of p: (value, d/dx, d/dy).
fn gabor_impl_times(a: vec3<f32>, b: vec3<f32>) -> vec3<f32> {
    let _e11 = ((a.x * b.yz) + (b.x * a.yz));
    return vec3<f32>((a.x * b.x), _e11.x, _e11.y);
}

// The matrix v v^T: xx, yy, xy.
fn gabor_impl_square(v: vec2<f32>) -> vec3<f32> {
    let _e1 = (v * v);
    return vec3<f32>(_e1.x, _e1.y, (v.x * v.y));
}

// (x y)^T M (x y), where M has the elements xx, yy, xy.
fn gabor_impl_turned_square(m: vec3<f32>, x: vec2<f32>, y: vec2<f32>) -> vec3<f32> {
    var a_8: vec2<f32>;
    var b_11: vec2<f32>;
    a_8 = ((m.xy * x) + (m.z * x.yx));
    b_11 = ((m.xy * y) + (m.z * y.yx));
    let _e17 = a_8;
    let _e19 = b_11;
    let _e21 = b_11;
    return vec3<f32>(dot(x, _e17), dot(y, _e19), dot(x, _e21));
}

// ---- Positions -----------------------------------------------------------------------------------------------------

// A position, its derivatives along the plane's x and y, the steps (dx, dy) to the next pixels, which are 0 without a
// filter, and the period, 0 for none. Warps move it and bend the steps.
struct GaborPixel {
    p: vec2<f32>,
    x: vec2<f32>,
    y: vec2<f32>,
    dx: vec2<f32>,
    dy: vec2<f32>,
    period: vec2<f32>,
}

fn gabor_impl_pixel_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>) -> GaborPixel {
    var p_12: vec2<f32>;
    var local_24: vec2<f32>;
    p_12 = p;
    let _e5 = p_12;
    if (period.x > 0f) {
        let _e9 = p_12;
        local_24 = (period * floor((_e9 / period)));
    } else {
        local_24 = vec2(0f);
    }
    let _e16 = local_24;
    p_12 = (_e5 - _e16);
    let _e18 = p_12;
    return GaborPixel(_e18, vec2<f32>(1f, 0f), vec2<f32>(0f, 1f), dx, dy, period);
}

// A position along the warped x or y axis, with derivatives.
fn gabor_impl_along_x(at: GaborPixel) -> vec3<f32> {
    return vec3<f32>(at.p.x, at.x.x, at.y.x);
}
fn gabor_impl_along_y(at: GaborPixel) -> vec3<f32> {
    return vec3<f32>(at.p.y, at.x.y, at.y.y);
}

// The place of a layer with `density` kernel radii per unit along x and y.
fn gabor_impl_place(at: GaborPixel, density: vec2<f32>) -> GaborPlace {
    if (at.period.x > 0f) {
        let _e10 = gabor_place_tiled((density * at.p), (density * at.period));
        return _e10;
    }
    let _e13 = gabor_place_at((density * at.p));
    return _e13;
}

fn gabor_impl_three_line_words(index: i32, period: i32, salt: u32) -> vec3<u32> {
    var first_2: i32;
    var second_2: i32;
    let _e3 = gabor_impl_wrap(index, period);
    first_2 = _e3;
    let _e5 = first_2;
    let _e6 = gabor_impl_next_node(_e5, period);
    second_2 = _e6;
    let _e8 = first_2;
    let _e9 = gabor_impl_line_word(_e8, salt);
    let _e10 = second_2;
    let _e11 = gabor_impl_line_word(_e10, salt);
    let _e12 = second_2;
    let _e13 = gabor_impl_next_node(_e12, period);
    let _e14 = gabor_impl_line_word(_e13, salt);
    return vec3<u32>(_e9, _e11, _e14);
}

// Adds a row of nodes to two noises, (quadrature, noise), and to their derivatives along x and y.
fn gabor_impl_add_spots(value: ptr<function, vec2<f32>>, slope: ptr<function, vec4<f32>>, words: vec3<u32>, x: vec4<f32>, slope_x: vec4<f32>, y: f32, slope_y: f32) {
    var a_9: vec2<f32>;
    var b_12: vec2<f32>;
    var c_6: vec2<f32>;
    var row_6: vec2<f32>;
    let _e8 = gabor_impl_amplitude(words.x);
    a_9 = _e8;
    let _e11 = gabor_impl_amplitude(words.y);
    b_12 = _e11;
    let _e14 = gabor_impl_amplitude(words.z);
    c_6 = _e14;
    let _e17 = a_9;
    let _e20 = b_12;
    let _e24 = c_6;
    row_6 = (((x.x * _e17) + (x.y * _e20)) + (x.z * _e24));
    let _e28 = (*value);
    let _e29 = row_6;
    (*value) = (_e28 + (y * _e29));
    let _e32 = (*slope);
    let _e34 = a_9;
    let _e37 = b_12;
    let _e41 = c_6;
    let _e44 = (y * (((slope_x.x * _e34) + (slope_x.y * _e37)) + (slope_x.z * _e41)));
    let _e45 = row_6;
    let _e46 = (slope_y * _e45);
    (*slope) = (_e32 + vec4<f32>(_e44.x, _e44.y, _e46.x, _e46.y));
    return;
}

// Noise of frequency 0, which needs no waves: spots as large as a kernel. The same as gabor_field.
fn gabor_impl_spots(place: GaborPlace, seed: u32) -> GaborField {
    var zero_2: vec2<f32>;
    var offset: vec2<f32>;
    var salt_11: u32;
    var columns_5: vec3<u32>;
    var rows_3: vec3<u32>;
    var x_14: vec4<f32>;
    var y_11: vec4<f32>;
    var slope_x_1: vec4<f32>;
    var slope_y_1: vec4<f32>;
    var value_11: vec2<f32> = vec2(0f);
    var slope_10: vec4<f32> = vec4(0f);
    var local_25: f32;
    var scale_1: f32;
    var stretch_6: vec2<f32>;
    zero_2 = floor((place.local + vec2(0.5f)));
    let _e9 = zero_2;
    offset = clamp((place.local - _e9), vec2(-0.5f), vec2(0.5f));
    let _e18 = gabor_impl_salt(seed);
    salt_11 = _e18;
    let _e22 = zero_2;
    let _e30 = salt_11;
    let _e31 = gabor_impl_three_line_words(((place.cell.x + i32(_e22.x)) - 1i), place.period.x, _e30);
    columns_5 = _e31;
    let _e35 = zero_2;
    let _e43 = salt_11;
    let _e46 = gabor_impl_three_line_words(((place.cell.y + i32(_e35.y)) - 1i), place.period.y, (_e43 ^ 1540483477u));
    rows_3 = _e46;
    let _e52 = offset;
    gabor_impl_windows(_e52.x, (&x_14), (&slope_x_1));
    let _e58 = offset;
    gabor_impl_windows(_e58.y, (&y_11), (&slope_y_1));
    let _e72 = columns_5;
    let _e73 = rows_3;
    let _e76 = x_14;
    let _e77 = slope_x_1;
    let _e78 = y_11;
    let _e80 = slope_y_1;
    gabor_impl_add_spots((&value_11), (&slope_10), (_e72 * _e73.x), _e76, _e77, _e78.x, _e80.x);
    let _e86 = columns_5;
    let _e87 = rows_3;
    let _e90 = x_14;
    let _e91 = slope_x_1;
    let _e92 = y_11;
    let _e94 = slope_y_1;
    gabor_impl_add_spots((&value_11), (&slope_10), (_e86 * _e87.y), _e90, _e91, _e92.y, _e94.y);
    let _e100 = columns_5;
    let _e101 = rows_3;
    let _e104 = x_14;
    let _e105 = slope_x_1;
    let _e106 = y_11;
    let _e108 = slope_y_1;
    gabor_impl_add_spots((&value_11), (&slope_10), (_e100 * _e101.z), _e104, _e105, _e106.z, _e108.z);
    if false {
        local_25 = 1f;
    } else {
        local_25 = 1.125f;
    }
    let _e123 = local_25;
    scale_1 = (1f / (1459955300000000000000000000f * _e123));
    let _e127 = scale_1;
    stretch_6 = ((_e127 * place.cells_per_radius) / vec2(1.5f));
    let _e137 = scale_1;
    let _e138 = value_11;
    let _e141 = stretch_6;
    let _e142 = slope_10;
    let _e145 = scale_1;
    let _e146 = value_11;
    let _e149 = stretch_6;
    let _e150 = slope_10;
    return GaborField((_e137 * _e138.y), (_e141 * _e142.yw), (_e145 * _e146.x), (_e149 * _e150.xz), 0f);
}

// The steps (dx, dy) to the next pixels, in kernel radii of a noise with this density.
fn gabor_impl_radii(at: GaborPixel, density: vec2<f32>) -> vec4<f32> {
    let _e3 = (density * at.dx);
    let _e5 = (density * at.dy);
    return vec4<f32>(_e3.x, _e3.y, _e5.x, _e5.y);
}

// Moves the position by two noises. Noises that are finer than the pixel move it only as much as a filter keeps of their
// slopes. They bend its steps even less, for two reasons: slopes at one point are not those of the whole pixel, and the
// slopes of a filtered height leave out how the steps change.
fn gabor_impl_warp(at: GaborPixel, density: vec2<f32>, amplitude: vec2<f32>, seed: u32, index: i32) -> GaborPixel {
    var amplitude_5: vec2<f32>;
    var steps: vec4<f32>;
    var size: f32;
    var bend: f32;
    var field_10: GaborField;
    var along_x_3: vec2<f32>;
    var along_y_3: vec2<f32>;
    amplitude_5 = amplitude;
    let _e6 = gabor_impl_radii(at, density);
    steps = _e6;
    let _e8 = steps;
    let _e9 = steps;
    size = min(dot(_e8, _e9), 1000000f);
    let _e17 = size;
    bend = (1f / (1f + (64f * _e17)));
    let _e22 = amplitude_5;
    let _e25 = size;
    amplitude_5 = (_e22 / vec2((1f + (0.822467f * _e25))));
    let _e30 = gabor_impl_place(at, density);
    let _e31 = gabor_derived_seed(seed, index);
    let _e32 = gabor_impl_spots(_e30, _e31);
    field_10 = _e32;
    let _e34 = amplitude_5;
    let _e37 = field_10;
    let _e40 = field_10;
    along_x_3 = ((_e34 * density.x) * vec2<f32>(_e37.quadrature_gradient.x, _e40.gradient.x));
    let _e46 = amplitude_5;
    let _e49 = field_10;
    let _e52 = field_10;
    along_y_3 = ((_e46 * density.y) * vec2<f32>(_e49.quadrature_gradient.y, _e52.gradient.y));
    let _e59 = amplitude_5;
    let _e60 = field_10;
    let _e62 = field_10;
    let _e70 = along_x_3;
    let _e75 = along_y_3;
    let _e81 = along_x_3;
    let _e86 = along_y_3;
    let _e90 = bend;
    let _e93 = along_x_3;
    let _e97 = along_y_3;
    let _e103 = bend;
    let _e106 = along_x_3;
    let _e110 = along_y_3;
    return GaborPixel((at.p + (_e59 * vec2<f32>(_e60.quadrature, _e62.noise))), ((at.x + (at.x.x * _e70)) + (at.x.y * _e75)), ((at.y + (at.y.x * _e81)) + (at.y.y * _e86)), (at.dx + (_e90 * ((at.dx.x * _e93) + (at.dx.y * _e97)))), (at.dy + (_e103 * ((at.dy.x * _e106) + (at.dy.y * _e110)))), at.period);
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
fn gabor_impl_turned(at: GaborPixel, angle: f32) -> GaborPixel {
    var turn_10: vec2<f32>;
    var x_15: vec2<f32>;
    var y_12: vec2<f32>;
    var period_8: vec2<f32> = vec2(0f);
    var whole: vec2<f32>;
    var size_1: vec2<f32>;
    var local_26: f32;
    var local_27: f32;
    var signs: vec2<f32>;
    var local_28: vec2<f32>;
    var local_29: vec2<f32>;
    var local_30: vec2<f32>;
    var other: vec2<f32>;
    let _e4 = gabor_impl_wave((0.15915494f * angle));
    turn_10 = _e4;
    let _e6 = turn_10;
    x_15 = _e6;
    let _e8 = turn_10;
    let _e11 = turn_10;
    y_12 = vec2<f32>(-(_e8.y), _e11.x);
    if (at.period.x > 0f) {
        {
            let _e23 = turn_10;
            whole = floor(((3f * normalize((_e23 / at.period))) + vec2(0.5f)));
            let _e33 = whole;
            size_1 = abs(_e33);
            let _e36 = whole;
            if (_e36.x < 0f) {
                local_26 = -1f;
            } else {
                local_26 = 1f;
            }
            let _e44 = local_26;
            let _e45 = whole;
            if (_e45.y < 0f) {
                local_27 = -1f;
            } else {
                local_27 = 1f;
            }
            let _e53 = local_27;
            signs = vec2<f32>(_e44, _e53);
            let _e56 = size_1;
            let _e58 = size_1;
            let _e61 = size_1;
            let _e63 = size_1;
            if ((_e56.x == _e58.y) || ((_e61.x * _e63.y) == 0f)) {
                let _e69 = signs;
                let _e70 = size_1;
                whole = (_e69 * min(_e70, vec2(1f)));
            }
            let _e75 = whole;
            size_1 = abs(_e75);
            let _e77 = size_1;
            let _e81 = size_1;
            if ((_e77.x > 1f) && (_e81.y > 1f)) {
                let _e86 = size_1;
                let _e88 = size_1;
                if (_e86.x > _e88.y) {
                    let _e91 = signs;
                    local_28 = _e91;
                } else {
                    let _e92 = signs;
                    local_28 = -(_e92);
                }
                let _e95 = local_28;
                local_30 = _e95;
            } else {
                let _e96 = size_1;
                if (_e96.x == 1f) {
                    let _e101 = whole;
                    local_29 = vec2<f32>(0f, _e101.x);
                } else {
                    let _e104 = whole;
                    local_29 = vec2<f32>(-(_e104.y), 0f);
                }
                let _e110 = local_29;
                local_30 = _e110;
            }
            let _e112 = local_30;
            other = _e112;
            let _e115 = whole;
            period_8.x = length((_e115 * at.period));
            let _e125 = period_8;
            period_8.y = ((at.period.x * at.period.y) / _e125.x);
            let _e128 = period_8;
            let _e130 = other;
            let _e132 = other;
            x_15 = ((_e128.x * vec2<f32>(_e130.y, -(_e132.x))) / at.period);
            let _e139 = period_8;
            let _e141 = whole;
            let _e144 = whole;
            y_12 = ((_e139.y * vec2<f32>(-(_e141.y), _e144.x)) / at.period);
        }
    }
    let _e150 = x_15;
    let _e153 = y_12;
    let _e157 = x_15;
    let _e160 = y_12;
    let _e164 = x_15;
    let _e167 = y_12;
    let _e171 = x_15;
    let _e174 = y_12;
    let _e178 = x_15;
    let _e181 = y_12;
    let _e185 = period_8;
    return GaborPixel(vec2<f32>(dot(_e150, at.p), dot(_e153, at.p)), vec2<f32>(dot(_e157, at.x), dot(_e160, at.x)), vec2<f32>(dot(_e164, at.y), dot(_e167, at.y)), vec2<f32>(dot(_e171, at.dx), dot(_e174, at.dx)), vec2<f32>(dot(_e178, at.dy), dot(_e181, at.dy)), _e185);
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
fn gabor_impl_repeated(pixel: GaborPixel, count: f32, whole: f32) -> vec2<f32> {
    if (pixel.period.x > 0f) {
        return ((max(floor(((pixel.period * (count / whole)) + vec2(0.5f))), vec2(1f)) * whole) / pixel.period);
    }
    return vec2(count);
}

// What a pixel keeps of a sine along x that repeats `count` times per unit.
fn gabor_impl_sine_kept(at: GaborPixel, count: f32) -> f32 {
    return exp(-(min((((4.934802f * count) * count) * ((at.dx.x * at.dx.x) + (at.dy.x * at.dy.x))), 40f)));
}

// ---- Layers --------------------------------------------------------------------------------------------------------

// A noise with `density` kernel radii per unit along x and y, and a wave vector per kernel radius. It is added, times
// `amplitude`, to pair `slot` of a material.
struct GaborLayer {
    slot: i32,
    at: GaborPixel,
    density: vec2<f32>,
    wave: vec2<f32>,
    amplitude: f32,
    seed: u32,
}

// A layer of frequency 0.
fn gabor_impl_spots_layer(slot: i32, at: GaborPixel, density: vec2<f32>, seed: u32, index: i32) -> GaborLayer {
    let _e8 = gabor_derived_seed(seed, index);
    return GaborLayer(slot, at, density, vec2(0f), 1f, _e8);
}

fn gabor_impl_waves_layer(slot: i32, at: GaborPixel, density: vec2<f32>, frequency: f32, orientation: f32, seed: u32, index: i32) -> GaborLayer {
    let _e7 = gabor_wave_vector(frequency, orientation);
    let _e9 = gabor_derived_seed(seed, index);
    return GaborLayer(slot, at, density, _e7, 1f, _e9);
}

// Octave i of `count`, each with spots of about half the previous size and `gain` times the amplitude.
fn gabor_impl_octave(at: GaborPixel, density: vec2<f32>, i: i32, count: i32, gain: f32, seed: u32) -> GaborLayer {
    var power_5: f32;
    power_5 = ((1f - pow(gain, (2f * f32(count)))) / (1f - (gain * gain)));
    let _e27 = power_5;
    let _e30 = gabor_derived_seed(seed, i);
    return GaborLayer(0i, at, (density * exp2((1.0214797f * f32(i)))), vec2(0f), (pow(gain, f32(i)) * inverseSqrt(_e27)), _e30);
}

// Two independent noises with their derivatives along x and y of p, the quadrature and noise of a layer's field; the
// share of their variance that a filter removed, and the covariance of their derivatives that it removed.
struct GaborPair {
    first: vec3<f32>,
    second: vec3<f32>,
    removed: f32,
    lost: vec3<f32>,
}

// The pairs of a material.
struct GaborPairs {
    a: GaborPair,
    b: GaborPair,
    c: GaborPair,
    d: GaborPair,
    e: GaborPair,
}

fn gabor_impl_no_pair() -> GaborPair {
    return GaborPair(vec3(0f), vec3(0f), 0f, vec3(0f));
}

fn gabor_impl_no_pairs() -> GaborPairs {
    var none_1: GaborPair;
    let _e0 = gabor_impl_no_pair();
    none_1 = _e0;
    let _e2 = none_1;
    let _e3 = none_1;
    let _e4 = none_1;
    let _e5 = none_1;
    let _e6 = none_1;
    return GaborPairs(_e2, _e3, _e4, _e5, _e6);
}

fn gabor_impl_pair(layer: GaborLayer, field: GaborField, lost: vec3<f32>) -> GaborPair {
    var x_16: vec2<f32>;
    var y_13: vec2<f32>;
    x_16 = (layer.density * layer.at.x);
    y_13 = (layer.density * layer.at.y);
    let _e15 = x_16;
    let _e18 = y_13;
    let _e23 = x_16;
    let _e26 = y_13;
    let _e30 = x_16;
    let _e31 = y_13;
    let _e32 = gabor_impl_turned_square(lost, _e30, _e31);
    return GaborPair(vec3<f32>(field.quadrature, dot(field.quadrature_gradient, _e15), dot(field.quadrature_gradient, _e18)), vec3<f32>(field.noise, dot(field.gradient, _e23), dot(field.gradient, _e26)), field.removed, _e32);
}

fn gabor_impl_plus(sum: GaborPair, pair: GaborPair, amplitude: f32) -> GaborPair {
    return GaborPair((sum.first + (amplitude * pair.first)), (sum.second + (amplitude * pair.second)), (sum.removed + ((amplitude * amplitude) * pair.removed)), (sum.lost + ((amplitude * amplitude) * pair.lost)));
}

fn gabor_impl_spots_pair(layer: GaborLayer) -> GaborPair {
    let _e3 = gabor_impl_place(layer.at, layer.density);
    let _e5 = gabor_impl_spots(_e3, layer.seed);
    let _e8 = gabor_impl_pair(layer, _e5, vec3(0f));
    return _e8;
}

// A sum and an octave of it.
fn gabor_impl_plus_octave(sum: GaborPair, layer: GaborLayer) -> GaborPair {
    let _e2 = gabor_impl_spots_pair(layer);
    let _e4 = gabor_impl_plus(sum, _e2, layer.amplitude);
    return _e4;
}

fn gabor_impl_waves_pair(layer: GaborLayer) -> GaborPair {
    let _e3 = gabor_impl_place(layer.at, layer.density);
    let _e6 = gabor_field(_e3, layer.wave, layer.seed);
    let _e9 = gabor_impl_pair(layer, _e6, vec3(0f));
    return _e9;
}

// ---- Filtered spots: see gabor_filter.wgsl, with real windows ------------------------------------------------------

// A node's window with three waves and its fade: the window, the part of its derivative that couples the axes, and the
// derivatives of both.
fn gabor_impl_spots_node(value: f32, slope: f32, damped: f32, fade: vec2<f32>) -> vec4<f32> {
    var window_3: f32;
    window_3 = (0.5f + (damped * (value - 0.5f)));
    let _e11 = window_3;
    let _e20 = window_3;
    let _e27 = window_3;
    return vec4<f32>((fade.x * _e11), ((fade.x * damped) * slope), (((fade.x * damped) * slope) + (fade.y * _e20)), ((-9.869604f * fade.x) * (_e27 - 0.5f)));
}

// The nodes of an axis with its words.
struct GaborSpotsAxis {
    word: vec3<u32>,
    first: vec4<f32>,
    middle: vec4<f32>,
    last: vec4<f32>,
}

fn gabor_impl_spots_axis(cell: i32, local: f32, period: i32, salt: u32, variance: f32) -> GaborSpotsAxis {
    var zero_3: f32;
    var offset_1: f32;
    var damped_1: f32;
    var width_4: f32;
    var t_8: vec2<f32>;
    var fade_5: vec2<f32>;
    var change_1: vec2<f32>;
    var value_13: vec4<f32>;
    var slope_12: vec4<f32>;
    zero_3 = floor((local + 0.5f));
    let _e9 = zero_3;
    offset_1 = clamp((local - _e9), -0.5f, 0.5f);
    damped_1 = exp((-4.934802f * variance));
    width_4 = clamp((0.5f * sqrt(variance)), 0.001f, 0.05f);
    let _e30 = offset_1;
    let _e32 = offset_1;
    let _e37 = width_4;
    t_8 = clamp(((vec2(0.33333334f) + (0.6666667f * vec2<f32>(-(_e30), _e32))) / vec2(_e37)), vec2(0f), vec2(1f));
    let _e46 = t_8;
    let _e47 = t_8;
    let _e51 = t_8;
    fade_5 = ((_e46 * _e47) * (vec2(3f) - (2f * _e51)));
    let _e58 = width_4;
    let _e60 = t_8;
    let _e63 = t_8;
    change_1 = ((((6f / _e58) * _e60) * (vec2(1f) - _e63)) * vec2<f32>(-1f, 1f));
    let _e75 = offset_1;
    gabor_impl_windows(_e75, (&value_13), (&slope_12));
    let _e80 = zero_3;
    let _e85 = gabor_impl_three_line_words(((cell + i32(_e80)) - 1i), period, salt);
    let _e86 = value_13;
    let _e88 = slope_12;
    let _e90 = damped_1;
    let _e91 = fade_5;
    let _e93 = change_1;
    let _e96 = gabor_impl_spots_node(_e86.x, _e88.x, _e90, vec2<f32>(_e91.x, _e93.x));
    let _e97 = value_13;
    let _e99 = slope_12;
    let _e101 = damped_1;
    let _e105 = gabor_impl_spots_node(_e97.y, _e99.y, _e101, vec2<f32>(1f, 0f));
    let _e106 = value_13;
    let _e108 = slope_12;
    let _e110 = damped_1;
    let _e111 = fade_5;
    let _e113 = change_1;
    let _e116 = gabor_impl_spots_node(_e106.z, _e108.z, _e110, vec2<f32>(_e111.y, _e113.y));
    return GaborSpotsAxis(_e85, _e96, _e105, _e116);
}

// Adds a row of nodes to (value, value, d/dx, d/dx) and (d/dy, d/dy) of two noises.
fn gabor_impl_add_spots_row(sum: ptr<function, vec4<f32>>, along_y: ptr<function, vec2<f32>>, x: GaborSpotsAxis, word: u32, y: vec4<f32>, coupling: f32) {
    var a_10: vec2<f32>;
    var b_13: vec2<f32>;
    var c_7: vec2<f32>;
    var real_3: vec4<f32>;
    var imaginary_3: vec4<f32>;
    let _e9 = gabor_impl_amplitude((x.word.x * word));
    a_10 = _e9;
    let _e14 = gabor_impl_amplitude((x.word.y * word));
    b_13 = _e14;
    let _e19 = gabor_impl_amplitude((x.word.z * word));
    c_7 = _e19;
    let _e22 = a_10;
    let _e26 = b_13;
    let _e31 = c_7;
    real_3 = (((x.first * _e22.x) + (x.middle * _e26.x)) + (x.last * _e31.x));
    let _e37 = a_10;
    let _e41 = b_13;
    let _e46 = c_7;
    imaginary_3 = (((x.first * _e37.y) + (x.middle * _e41.y)) + (x.last * _e46.y));
    let _e51 = (*sum);
    let _e53 = real_3;
    let _e55 = imaginary_3;
    let _e57 = real_3;
    let _e59 = imaginary_3;
    let _e65 = real_3;
    let _e67 = imaginary_3;
    let _e69 = real_3;
    let _e71 = imaginary_3;
    (*sum) = (_e51 + ((y.x * vec4<f32>(_e53.x, _e55.x, _e57.z, _e59.z)) + ((coupling * y.y) * vec4<f32>(_e65.y, _e67.y, _e69.w, _e71.w))));
    let _e77 = (*along_y);
    let _e79 = real_3;
    let _e81 = imaginary_3;
    let _e87 = real_3;
    let _e89 = imaginary_3;
    (*along_y) = (_e77 + ((y.z * vec2<f32>(_e79.x, _e81.x)) + ((coupling * y.w) * vec2<f32>(_e87.y, _e89.y))));
    return;
}

// A line's window with seven waves, for each factor, where the second is imaginary, and its fade.
struct GaborSpotsLine {
    word: u32,
    window: vec3<f32>,
    fade: vec2<f32>,
}

fn gabor_impl_spots_line(b: GaborFilteredAxis, index: i32) -> GaborSpotsLine {
    var turn_11: vec2<f32>;
    var real_4: vec3<f32>;
    var imaginary_4: f32;
    let _e9 = gabor_impl_wave(((0.5f / b.reach) * (b.offset - f32(index))));
    turn_11 = _e9;
    let _e12 = turn_11;
    let _e15 = turn_11;
    let _e18 = turn_11;
    real_4 = (b.even_0_ + (_e12.x * (b.even_1_ + (_e15.x * (b.even_2_ + (_e18.x * b.even_3_))))));
    let _e28 = turn_11;
    let _e32 = turn_11;
    let _e36 = turn_11;
    imaginary_4 = (_e28.y * (b.odd_1_.y + (_e32.x * (b.odd_2_.y + (_e36.x * b.odd_3_.y)))));
    let _e49 = gabor_impl_wrap((b.first + index), b.period);
    let _e51 = gabor_impl_line_word(_e49, b.salt);
    let _e52 = real_4;
    let _e54 = imaginary_4;
    let _e55 = real_4;
    let _e58 = gabor_impl_fade(b, index);
    return GaborSpotsLine(_e51, vec3<f32>(_e52.x, _e54, _e55.z), _e58);
}

// The sums of a row over its columns: the factors times both parts of the amplitudes, and the first factor with the
// derivative of its fade.
struct GaborSpotsRow {
    real: vec3<f32>,
    imaginary: vec3<f32>,
    edge: vec2<f32>,
}

fn gabor_impl_add_spot(row: ptr<function, GaborSpotsRow>, x: GaborSpotsLine, row_word: u32) {
    var a_11: vec2<f32>;
    let _e5 = gabor_impl_amplitude((x.word * row_word));
    a_11 = _e5;
    let _e8 = (*row);
    let _e12 = a_11;
    (*row).real = (_e8.real + ((x.fade.x * _e12.x) * x.window));
    let _e19 = (*row);
    let _e23 = a_11;
    (*row).imaginary = (_e19.imaginary + ((x.fade.x * _e23.y) * x.window));
    let _e30 = (*row);
    let _e37 = a_11;
    (*row).edge = (_e30.edge + ((x.fade.y * x.window.x) * _e37));
    return;
}

fn gabor_impl_spots_wide(place: GaborPlace, s: vec3<f32>, wanted: bool, salt: u32) -> GaborField {
    var m_3: vec2<f32>;
    var rho_1: f32;
    var r_2: f32;
    var lambda_1: f32;
    var mixed_1: f32;
    var across_1: GaborFilteredAxis;
    var along_1: GaborFilteredAxis;
    var x_0_: GaborSpotsLine;
    var x_1_: GaborSpotsLine;
    var x_2_: GaborSpotsLine;
    var x_3_: GaborSpotsLine;
    var x_4_: GaborSpotsLine;
    var value_14: vec2<f32> = vec2(0f);
    var next_x_1: vec2<f32> = vec2(0f);
    var next_y_1: vec2<f32> = vec2(0f);
    var edge_x_1: vec2<f32> = vec2(0f);
    var edge_y_1: vec2<f32> = vec2(0f);
    var local_32: i32;
    var rows_4: i32;
    var j_5: i32 = 0i;
    var y_15: GaborSpotsLine;
    var row_8: GaborSpotsRow;
    var w: vec3<f32>;
    var sum_18: vec2<f32>;
    var before_1: vec2<f32>;
    var x_19: vec2<f32>;
    var y_16: vec2<f32>;
    var local_33: f32;
    var scale_2: f32;
    m_3 = (s.xy + vec2(0.13069098f));
    let _e10 = m_3;
    let _e12 = m_3;
    rho_1 = (s.z * inverseSqrt((_e10.x * _e12.y)));
    let _e19 = rho_1;
    let _e20 = rho_1;
    r_2 = sqrt((1f - (_e19 * _e20)));
    let _e25 = rho_1;
    let _e27 = r_2;
    lambda_1 = (_e25 / (1f + _e27));
    let _e34 = r_2;
    let _e37 = r_2;
    mixed_1 = (((78.95683f * s.z) * _e34) / (1f + _e37));
    let _e43 = r_2;
    let _e44 = m_3;
    let _e57 = gabor_impl_filtered_axis(sqrt(s.x), (_e43 * _e44.x), 0f, place.cell.x, place.local.x, place.period.x, salt, vec2<f32>(1f, 0f));
    across_1 = _e57;
    let _e61 = r_2;
    let _e62 = m_3;
    let _e77 = gabor_impl_filtered_axis(sqrt(s.y), (_e61 * _e62.y), 0f, place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), vec2<f32>(1f, 0f));
    along_1 = _e77;
    let _e79 = across_1;
    let _e81 = gabor_impl_spots_line(_e79, 0i);
    x_0_ = _e81;
    let _e83 = across_1;
    let _e85 = gabor_impl_spots_line(_e83, 1i);
    x_1_ = _e85;
    let _e87 = across_1;
    let _e89 = gabor_impl_spots_line(_e87, 2i);
    x_2_ = _e89;
    let _e91 = across_1;
    let _e93 = gabor_impl_spots_line(_e91, 3i);
    x_3_ = _e93;
    let _e95 = x_3_;
    x_4_ = _e95;
    let _e97 = across_1;
    if (_e97.count == 5i) {
        let _e101 = across_1;
        let _e103 = gabor_impl_spots_line(_e101, 4i);
        x_4_ = _e103;
    }
    if wanted {
        let _e119 = along_1;
        local_32 = _e119.count;
    } else {
        local_32 = 0i;
    }
    let _e123 = local_32;
    rows_4 = _e123;
    loop {
        {
            let _e127 = along_1;
            let _e128 = j_5;
            let _e129 = gabor_impl_spots_line(_e127, _e128);
            y_15 = _e129;
            row_8 = GaborSpotsRow(vec3(0f), vec3(0f), vec2(0f));
            let _e140 = x_0_;
            let _e141 = y_15;
            gabor_impl_add_spot((&row_8), _e140, _e141.word);
            let _e145 = x_1_;
            let _e146 = y_15;
            gabor_impl_add_spot((&row_8), _e145, _e146.word);
            let _e150 = x_2_;
            let _e151 = y_15;
            gabor_impl_add_spot((&row_8), _e150, _e151.word);
            let _e155 = x_3_;
            let _e156 = y_15;
            gabor_impl_add_spot((&row_8), _e155, _e156.word);
            let _e159 = across_1;
            if (_e159.count == 5i) {
                let _e164 = x_4_;
                let _e165 = y_15;
                gabor_impl_add_spot((&row_8), _e164, _e165.word);
            }
            let _e169 = mixed_1;
            let _e171 = mixed_1;
            let _e173 = mixed_1;
            let _e176 = y_15;
            w = (vec3<f32>(1f, _e169, ((0.5f * _e171) * _e173)) * _e176.window);
            let _e180 = w;
            let _e181 = row_8;
            let _e184 = w;
            let _e185 = row_8;
            sum_18 = vec2<f32>(dot(_e180, _e181.real), dot(_e184, _e185.imaginary));
            let _e190 = value_14;
            let _e191 = y_15;
            let _e194 = sum_18;
            value_14 = (_e190 + (_e191.fade.x * _e194));
            let _e197 = next_x_1;
            let _e198 = y_15;
            let _e201 = w;
            let _e203 = row_8;
            let _e206 = row_8;
            let _e211 = w;
            let _e213 = row_8;
            let _e216 = row_8;
            next_x_1 = (_e197 + (_e198.fade.x * ((_e201.x * vec2<f32>(_e203.real.y, _e206.imaginary.y)) - (_e211.y * vec2<f32>(_e213.real.z, _e216.imaginary.z)))));
            let _e224 = next_y_1;
            let _e225 = y_15;
            let _e228 = y_15;
            let _e231 = row_8;
            let _e234 = row_8;
            let _e239 = mixed_1;
            let _e240 = y_15;
            let _e244 = row_8;
            let _e247 = row_8;
            next_y_1 = (_e224 + (_e225.fade.x * ((_e228.window.y * vec2<f32>(_e231.real.x, _e234.imaginary.x)) - ((_e239 * _e240.window.z) * vec2<f32>(_e244.real.y, _e247.imaginary.y)))));
            let _e255 = edge_x_1;
            let _e256 = y_15;
            let _e259 = w;
            let _e262 = row_8;
            edge_x_1 = (_e255 + ((_e256.fade.x * _e259.x) * _e262.edge));
            let _e266 = edge_y_1;
            let _e267 = y_15;
            let _e270 = sum_18;
            edge_y_1 = (_e266 + (_e267.fade.y * _e270));
        }
        let _e273 = j_5;
        let _e275 = (_e273 + 1i);
        j_5 = _e275;
        let _e276 = rows_4;
        if !((_e275 < _e276)) {
            break;
        }
    }
    let _e279 = lambda_1;
    let _e280 = m_3;
    let _e282 = m_3;
    before_1 = (_e279 * sqrt((_e280.yx / _e282)));
    let _e287 = edge_x_1;
    let _e289 = next_x_1;
    let _e290 = before_1;
    let _e292 = next_y_1;
    x_19 = (_e287 - (6.2831855f * (_e289 - (_e290.x * _e292))));
    let _e298 = edge_y_1;
    let _e300 = next_y_1;
    let _e301 = before_1;
    let _e303 = next_x_1;
    y_16 = (_e298 - (6.2831855f * (_e300 - (_e301.y * _e303))));
    let _e310 = lambda_1;
    let _e311 = lambda_1;
    if false {
        local_33 = 1f;
    } else {
        local_33 = 1.125f;
    }
    let _e325 = local_33;
    scale_2 = (sqrt((1f - (_e310 * _e311))) / (1459955300000000000000000000f * _e325));
    let _e329 = scale_2;
    let _e330 = value_14;
    let _e333 = scale_2;
    let _e334 = x_19;
    let _e336 = y_16;
    let _e340 = scale_2;
    let _e341 = value_14;
    let _e344 = scale_2;
    let _e345 = x_19;
    let _e347 = y_16;
    return GaborField((_e329 * _e330.y), (_e333 * vec2<f32>(_e334.y, _e336.y)), (_e340 * _e341.x), (_e344 * vec2<f32>(_e345.x, _e347.x)), 0f);
}

fn gabor_impl_spots_narrow(place: GaborPlace, s: vec3<f32>, salt: u32) -> GaborField {
    var x_20: GaborSpotsAxis;
    var y_17: GaborSpotsAxis;
    var sum_19: vec4<f32> = vec4(0f);
    var along_y_5: vec2<f32> = vec2(0f);
    var local_34: f32;
    var scale_3: f32;
    let _e10 = gabor_impl_spots_axis(place.cell.x, place.local.x, place.period.x, salt, s.x);
    x_20 = _e10;
    let _e21 = gabor_impl_spots_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), s.y);
    y_17 = _e21;
    let _e31 = x_20;
    let _e32 = y_17;
    let _e35 = y_17;
    gabor_impl_add_spots_row((&sum_19), (&along_y_5), _e31, _e32.word.x, _e35.first, s.z);
    let _e42 = x_20;
    let _e43 = y_17;
    let _e46 = y_17;
    gabor_impl_add_spots_row((&sum_19), (&along_y_5), _e42, _e43.word.y, _e46.middle, s.z);
    let _e53 = x_20;
    let _e54 = y_17;
    let _e57 = y_17;
    gabor_impl_add_spots_row((&sum_19), (&along_y_5), _e53, _e54.word.z, _e57.last, s.z);
    if false {
        local_34 = 1f;
    } else {
        local_34 = 1.125f;
    }
    let _e73 = local_34;
    scale_3 = (1f / (1459955300000000000000000000f * _e73));
    let _e77 = scale_3;
    let _e78 = sum_19;
    let _e81 = scale_3;
    let _e82 = sum_19;
    let _e84 = along_y_5;
    let _e88 = scale_3;
    let _e89 = sum_19;
    let _e92 = scale_3;
    let _e93 = sum_19;
    let _e95 = along_y_5;
    return GaborField((_e77 * _e78.y), (_e81 * vec2<f32>(_e82.w, _e84.y)), (_e88 * _e89.x), (_e92 * vec2<f32>(_e93.z, _e95.x)), 0f);
}

// The same as gabor_field_filtered with the wave vector 0.
fn gabor_impl_spots_filtered(place: GaborPlace, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborField {
    var stretch_7: vec2<f32>;
    var footprint_4: GaborFootprint;
    var wide_1: f32;
    var kept_1: f32;
    var amplitude_7: f32;
    var sum_20: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var salt_15: u32;
    stretch_7 = (place.cells_per_radius / vec2(1.5f));
    let _e12 = stretch_7;
    let _e14 = stretch_7;
    let _e16 = gabor_impl_footprint((_e12 * dx), (_e14 * dy));
    footprint_4 = _e16;
    let _e18 = footprint_4;
    let _e19 = gabor_impl_wide_share(_e18);
    wide_1 = _e19;
    let _e23 = footprint_4;
    let _e25 = gabor_impl_transmitted(vec2(0f), _e23.covariance);
    kept_1 = _e25;
    let _e27 = kept_1;
    let _e30 = footprint_4;
    let _e32 = gabor_impl_transmitted(vec2(0f), _e30.resolved);
    amplitude_7 = sqrt((_e27 / _e32));
    let _e45 = gabor_impl_salt(seed);
    salt_15 = _e45;
    let _e47 = wide_1;
    if (_e47 < 1f) {
        let _e51 = footprint_4;
        let _e53 = salt_15;
        let _e54 = gabor_impl_spots_narrow(place, _e51.resolved, _e53);
        let _e56 = wide_1;
        let _e58 = amplitude_7;
        let _e60 = stretch_7;
        gabor_impl_add_field((&sum_20), _e54, ((1f - _e56) * _e58), _e60);
    }
    let _e62 = wide_1;
    if (_e62 > 0f) {
        let _e66 = footprint_4;
        let _e68 = wide_1;
        let _e71 = salt_15;
        let _e72 = gabor_impl_spots_wide(place, _e66.resolved, (_e68 > 0f), _e71);
        let _e73 = wide_1;
        let _e74 = amplitude_7;
        let _e76 = stretch_7;
        gabor_impl_add_field((&sum_20), _e72, (_e73 * _e74), _e76);
    }
    let _e80 = kept_1;
    sum_20.removed = (1f - _e80);
    let _e82 = sum_20;
    return _e82;
}

// A layer's filtered field, with the covariance of its gradient that the filter removes: see gabor_impl_transmitted. The
// lobe has the covariance I / 12, and the filter leaves (12 + 8 pi^2 S)^-1 around the wave vector (1 + 2/3 pi^2 S)^-1 F.
fn gabor_impl_filtered_pair(layer: GaborLayer, field: GaborField) -> GaborPair {
    var steps_1: vec4<f32>;
    var a_12: vec3<f32>;
    var inverse: vec3<f32>;
    var whole_2: vec3<f32>;
    var left_1: vec3<f32>;
    let _e4 = gabor_impl_radii(layer.at, layer.density);
    steps_1 = _e4;
    let _e7 = steps_1;
    let _e9 = steps_1;
    let _e11 = gabor_impl_footprint(_e7.xy, _e9.zw);
    a_12 = (6.579736f * _e11.covariance);
    let _e16 = a_12;
    let _e20 = a_12;
    let _e23 = a_12;
    inverse = vec3<f32>((1f + _e16.y), (1f + _e20.x), -(_e23.z));
    let _e28 = inverse;
    let _e29 = inverse;
    let _e31 = inverse;
    let _e34 = a_12;
    let _e36 = a_12;
    inverse = (_e28 / vec3(((_e29.x * _e31.y) - (_e34.z * _e36.z))));
    let _e48 = gabor_impl_square(layer.wave);
    whole_2 = (vec3<f32>(3.289868f, 3.289868f, 0f) + (39.478416f * _e48));
    let _e53 = inverse;
    let _e56 = inverse;
    let _e58 = gabor_impl_symmetric(_e56, layer.wave);
    let _e59 = gabor_impl_square(_e58);
    left_1 = ((3.289868f * _e53) + (39.478416f * _e59));
    let _e63 = whole_2;
    let _e67 = left_1;
    let _e70 = gabor_impl_pair(layer, field, (_e63 - ((1f - field.removed) * _e67)));
    return _e70;
}

fn gabor_impl_filtered_waves(layer: GaborLayer) -> GaborPair {
    var place_17: GaborPlace;
    var steps_2: vec4<f32>;
    let _e3 = gabor_impl_place(layer.at, layer.density);
    place_17 = _e3;
    let _e7 = gabor_impl_radii(layer.at, layer.density);
    steps_2 = _e7;
    let _e9 = place_17;
    let _e10 = steps_2;
    let _e12 = steps_2;
    let _e16 = gabor_field_filtered(_e9, _e10.xy, _e12.zw, layer.wave, layer.seed);
    let _e17 = gabor_impl_filtered_pair(layer, _e16);
    return _e17;
}

fn gabor_impl_filtered_spots(layer: GaborLayer) -> GaborPair {
    var place_18: GaborPlace;
    var steps_3: vec4<f32>;
    let _e3 = gabor_impl_place(layer.at, layer.density);
    place_18 = _e3;
    let _e7 = gabor_impl_radii(layer.at, layer.density);
    steps_3 = _e7;
    let _e9 = place_18;
    let _e10 = steps_3;
    let _e12 = steps_3;
    let _e15 = gabor_impl_spots_filtered(_e9, _e10.xy, _e12.zw, layer.seed);
    let _e16 = gabor_impl_filtered_pair(layer, _e15);
    return _e16;
}

fn gabor_impl_add_filtered_spots(sum: ptr<function, GaborPairs>, layer: GaborLayer) {
    var pair_2: GaborPair;
    let _e2 = gabor_impl_filtered_spots(layer);
    pair_2 = _e2;
    if (layer.slot == 0i) {
        let _e8 = (*sum);
        let _e10 = pair_2;
        let _e12 = gabor_impl_plus(_e8.a, _e10, layer.amplitude);
        (*sum).a = _e12;
        return;
    } else {
        if (layer.slot == 1i) {
            let _e17 = (*sum);
            let _e19 = pair_2;
            let _e21 = gabor_impl_plus(_e17.b, _e19, layer.amplitude);
            (*sum).b = _e21;
            return;
        } else {
            if (layer.slot == 2i) {
                let _e26 = (*sum);
                let _e28 = pair_2;
                let _e30 = gabor_impl_plus(_e26.c, _e28, layer.amplitude);
                (*sum).c = _e30;
                return;
            } else {
                if (layer.slot == 3i) {
                    let _e35 = (*sum);
                    let _e37 = pair_2;
                    let _e39 = gabor_impl_plus(_e35.d, _e37, layer.amplitude);
                    (*sum).d = _e39;
                    return;
                } else {
                    let _e41 = (*sum);
                    let _e43 = pair_2;
                    let _e45 = gabor_impl_plus(_e41.e, _e43, layer.amplitude);
                    (*sum).e = _e45;
                    return;
                }
            }
        }
    }
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// The normal distribution function, within 2e-5.
fn gabor_impl_below(x: f32) -> f32 {
    var x_22: f32;
    x_22 = x;
    let _e2 = x_22;
    x_22 = clamp(_e2, -8f, 8f);
    let _e9 = x_22;
    let _e12 = x_22;
    let _e13 = x_22;
    let _e17 = x_22;
    let _e19 = x_22;
    return (1f / (1f + exp2((-(_e9) * (2.301726f + ((_e12 * _e13) * (0.1061787f - ((0.00091164f * _e17) * _e19))))))));
}

// A soft threshold: the normal distribution function of (noise - threshold) / softness.
fn gabor_impl_above(noise: vec3<f32>, removed: f32, threshold: f32, softness: f32) -> vec3<f32> {
    var scale_4: f32;
    var x_23: f32;
    scale_4 = inverseSqrt(((softness * softness) + removed));
    let _e8 = scale_4;
    let _e11 = scale_4;
    x_23 = ((_e8 * noise.x) - (_e11 * threshold));
    let _e15 = x_23;
    let _e16 = gabor_impl_below(_e15);
    let _e18 = scale_4;
    let _e22 = x_23;
    let _e23 = x_23;
    let _e31 = (((0.3989423f * _e18) * exp((-0.5f * min((_e22 * _e23), 100f)))) * noise.yz);
    return vec3<f32>(_e16, _e31.x, _e31.y);
}

// What the filter removed of a mean square: 0 without a filter, in spite of rounding.
fn gabor_impl_removed_square(square: f32, mean: f32, removed: f32) -> f32 {
    var local_35: f32;
    if (removed > 0f) {
        local_35 = max((square - (mean * mean)), 0f);
    } else {
        local_35 = 0f;
    }
    let _e11 = local_35;
    return _e11;
}

// The covariance of its slopes that the filter removed.
fn gabor_impl_above_lost(noise: vec3<f32>, removed: f32, lost: vec3<f32>, threshold: f32, softness: f32) -> vec3<f32> {
    var scale_5: f32;
    var variance_2: f32;
    var d_6: f32;
    var mean_3: f32;
    var square_1: f32;
    scale_5 = inverseSqrt(((softness * softness) + removed));
    variance_2 = (((0.5f * softness) * softness) + removed);
    d_6 = ((noise.x - threshold) * (noise.x - threshold));
    let _e21 = scale_5;
    let _e25 = d_6;
    let _e26 = scale_5;
    let _e28 = scale_5;
    mean_3 = ((0.3989423f * _e21) * exp((-0.5f * min(((_e25 * _e26) * _e28), 100f))));
    let _e38 = variance_2;
    let _e43 = d_6;
    let _e44 = variance_2;
    square_1 = (((0.11253954f / softness) * inverseSqrt(_e38)) * exp((-0.5f * min((_e43 / _e44), 100f))));
    let _e52 = square_1;
    let _e54 = square_1;
    let _e55 = mean_3;
    let _e56 = gabor_impl_removed_square(_e54, _e55, removed);
    let _e58 = gabor_impl_square(noise.yz);
    return ((_e52 * lost) + (_e56 * _e58));
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
fn gabor_impl_line(noise: vec3<f32>, removed: f32, width: f32) -> vec3<f32> {
    var variance_3: f32;
    var line_5: f32;
    variance_3 = ((width * width) + removed);
    let _e6 = variance_3;
    let _e14 = variance_3;
    line_5 = ((width * inverseSqrt(_e6)) * exp((-0.5f * min(((noise.x * noise.x) / _e14), 100f))));
    let _e22 = line_5;
    let _e26 = variance_3;
    let _e29 = ((-(noise.x) / _e26) * noise.yz);
    return (_e22 * vec3<f32>(1f, _e29.x, _e29.y));
}

// The covariance of its slopes that the filter removed.
fn gabor_impl_line_lost(noise: vec3<f32>, removed: f32, lost: vec3<f32>, width: f32) -> vec3<f32> {
    var half_square: f32;
    var variance_4: f32;
    var mean_4: f32;
    var spread: f32;
    var square_2: f32;
    var slope_13: vec3<f32>;
    half_square = ((0.5f * width) * width);
    let _e8 = half_square;
    variance_4 = (_e8 + removed);
    let _e12 = half_square;
    let _e14 = variance_4;
    mean_4 = ((noise.x * _e12) / _e14);
    let _e17 = half_square;
    let _e19 = variance_4;
    spread = ((_e17 * removed) / _e19);
    let _e22 = half_square;
    let _e23 = variance_4;
    let _e31 = variance_4;
    let _e38 = mean_4;
    let _e39 = mean_4;
    let _e41 = spread;
    let _e45 = half_square;
    let _e47 = half_square;
    square_2 = (((sqrt((_e22 / _e23)) * exp((-0.5f * min(((noise.x * noise.x) / _e31), 100f)))) * ((_e38 * _e39) + _e41)) / ((4f * _e45) * _e47));
    let _e55 = gabor_impl_line(vec3<f32>(noise.x, 1f, 0f), removed, width);
    slope_13 = _e55;
    let _e57 = square_2;
    let _e59 = square_2;
    let _e60 = slope_13;
    let _e62 = gabor_impl_removed_square(_e59, _e60.y, removed);
    let _e64 = gabor_impl_square(noise.yz);
    return ((_e57 * lost) + (_e62 * _e64));
}

// A factor of mean 1, exp(contrast noise - contrast^2 / 2), as its logarithm and the variance of the logarithm that the
// filter removed. A product of factors is the sum of their vectors.
fn gabor_impl_tone(noise: f32, removed: f32, contrast: f32) -> vec2<f32> {
    return vec2<f32>(((contrast * noise) - ((0.5f * contrast) * contrast)), ((contrast * contrast) * removed));
}

// The mean of min(colour * tone, 1). If the logarithm of X is normal with mean m and variance r, and P is the normal
// distribution function, the mean of min(c X, 1) is c e^(m + r/2) P(d - sqrt(r)) + 1 - P(d), where d = -(ln c + m) /
// sqrt(r). Where d > 3, this is nearly the mean of c X. Materials mix colours after this, so that means remain right.
fn gabor_impl_toned(colour: vec3<f32>, tone: vec2<f32>) -> vec3<f32> {
    var mean_5: vec3<f32>;
    var s_9: f32;
    var d_7: vec3<f32>;
    var i_9: i32 = 0i;
    mean_5 = (colour * exp((tone.x + (0.5f * tone.y))));
    if (tone.y > 0f) {
        {
            s_9 = sqrt(tone.y);
            let _e24 = s_9;
            d_7 = ((vec3(-(tone.x)) - log(max(colour, vec3(0.000001f)))) / vec3(_e24));
            let _e28 = d_7;
            let _e30 = d_7;
            let _e33 = d_7;
            if (min(min(_e28.x, _e30.y), _e33.z) < 3f) {
                loop {
                    let _e40 = i_9;
                    if !((_e40 < 3i)) {
                        break;
                    }
                    let _e47 = i_9;
                    let _e49 = i_9;
                    let _e51 = mean_5[_e49];
                    let _e52 = i_9;
                    let _e54 = d_7[_e52];
                    let _e55 = s_9;
                    let _e57 = gabor_impl_below((_e54 - _e55));
                    let _e61 = i_9;
                    let _e63 = d_7[_e61];
                    let _e64 = gabor_impl_below(_e63);
                    mean_5[_e47] = (((_e51 * _e57) + 1f) - _e64);
                    continuing {
                        let _e44 = i_9;
                        i_9 = (_e44 + 1i);
                    }
                }
            }
        }
    }
    let _e66 = mean_5;
    return min(_e66, vec3(1f));
}

// The square of a sawtooth that rises from 0 to 1, averaged over the phases that a vector of length `span` stands for: see
// gabor_impl_ends_at. `phase` is in turns.
fn gabor_impl_rise(phase: vec3<f32>, span: vec3<f32>) -> vec3<f32> {
    var ends_3: vec3<f32>;
    var turns_3: vec2<f32>;
    var t_9: vec2<f32>;
    var integral: vec2<f32>;
    var mean_6: f32;
    var change_2: f32;
    var widen: f32;
    let _e4 = gabor_impl_ends_at(phase.x, span.x);
    ends_3 = _e4;
    let _e6 = ends_3;
    turns_3 = floor(_e6.xy);
    let _e10 = ends_3;
    let _e12 = turns_3;
    t_9 = (_e10.xy - _e12);
    let _e16 = turns_3;
    let _e17 = t_9;
    let _e18 = t_9;
    let _e20 = t_9;
    integral = (0.33333334f * (_e16 + ((_e17 * _e18) * _e20)));
    let _e25 = ends_3;
    let _e27 = integral;
    let _e29 = integral;
    mean_6 = (_e25.z * (_e27.y - _e29.x));
    let _e34 = ends_3;
    let _e36 = t_9;
    let _e38 = t_9;
    let _e41 = t_9;
    let _e43 = t_9;
    change_2 = (_e34.z * ((_e36.y * _e38.y) - (_e41.x * _e43.x)));
    let _e49 = ends_3;
    let _e52 = t_9;
    let _e54 = t_9;
    let _e57 = t_9;
    let _e59 = t_9;
    let _e64 = mean_6;
    let _e69 = ends_3;
    widen = ((_e49.z * ((0.5f * ((_e52.y * _e54.y) + (_e57.x * _e59.x))) - _e64)) * (-0.5f / (_e69.z * max((1f - span.x), 0.001f))));
    let _e80 = mean_6;
    let _e81 = change_2;
    let _e84 = widen;
    let _e87 = ((_e81 * phase.yz) + (_e84 * span.yz));
    return vec3<f32>(_e80, _e87.x, _e87.y);
}

// The variance of its slope per turn over the phases that the filter added; at a span of `full`, it added none. Where
// the sawtooth rises, over a share 1 - w of the phases, its slope is 2 t; where it falls, over w, it is
// -(1 - w) (1 - w + 2 t) / w, with t from 0 to w.
fn gabor_impl_rise_lost(phase: f32, span: f32, full: f32) -> f32 {
    var ends_4: vec3<f32>;
    var turns_4: vec2<f32>;
    var t_10: vec2<f32>;
    var w_1: f32;
    var rise_2: f32;
    var risen: f32;
    var fallen: f32;
    var integral_1: vec2<f32>;
    var change_3: f32;
    let _e3 = gabor_impl_ends_at(phase, span);
    ends_4 = _e3;
    let _e5 = ends_4;
    turns_4 = floor(_e5.xy);
    let _e9 = ends_4;
    let _e11 = turns_4;
    t_10 = (_e9.xy - _e11);
    let _e16 = gabor_impl_ends_at(0f, full);
    w_1 = (1f / _e16.z);
    let _e21 = w_1;
    rise_2 = (1f - _e21);
    let _e25 = w_1;
    let _e27 = w_1;
    let _e30 = w_1;
    let _e32 = w_1;
    risen = (1.3333333f - (_e25 * ((2f - _e27) + ((0.33333334f * _e30) * _e32))));
    let _e38 = rise_2;
    let _e39 = rise_2;
    let _e42 = w_1;
    let _e45 = w_1;
    fallen = ((_e38 * _e39) * ((1f / _e42) + (0.33333334f * _e45)));
    let _e50 = risen;
    let _e51 = turns_4;
    let _e52 = t_10;
    let _e53 = t_10;
    let _e55 = t_10;
    let _e59 = fallen;
    let _e60 = turns_4;
    integral_1 = ((_e50 * (_e51 + ((_e52 * _e53) * _e55))) + (_e59 * _e60));
    let _e64 = ends_4;
    let _e66 = t_10;
    let _e68 = t_10;
    let _e71 = t_10;
    let _e73 = t_10;
    change_3 = (_e64.z * ((_e66.y * _e68.y) - (_e71.x * _e73.x)));
    let _e79 = ends_4;
    let _e81 = integral_1;
    let _e83 = integral_1;
    let _e87 = change_3;
    let _e88 = change_3;
    return (max(((_e79.z * (_e81.y - _e83.x)) - (_e87 * _e88)), 0f) * sqrt(max((1f - ((span * span) / (full * full))), 0f)));
}

// A smoothstep from `low` to `high`.
fn gabor_impl_step(low: f32, high: f32, x: vec3<f32>) -> vec3<f32> {
    var t_11: f32;
    t_11 = clamp(((x.x - low) / (high - low)), 0f, 1f);
    let _e11 = t_11;
    let _e12 = t_11;
    let _e16 = t_11;
    let _e21 = t_11;
    let _e24 = t_11;
    let _e30 = ((((6f * _e21) * (1f - _e24)) / (high - low)) * x.yz);
    return vec3<f32>(((_e11 * _e12) * (3f - (2f * _e16))), _e30.x, _e30.y);
}

fn gabor_impl_material(colour: vec3<f32>, height: vec3<f32>, lost: vec3<f32>, roughness: f32, metalness: f32) -> GaborMaterial {
    return GaborMaterial(clamp(colour, vec3(0f), vec3(1f)), height.x, height.yz, roughness, metalness, lost);
}

// ---- Wood ----------------------------------------------------------------------------------------------------------
//
// Rings are lines of constant x that noise of low frequency bends until they close.

fn gabor_impl_board(pixel: GaborPixel, wood: GaborWood, seed: u32) -> GaborPixel {
    var bends: vec2<f32>;
    var board: GaborPixel;
    bends = (vec2<f32>(0.43f, 0.018f) * wood.waviness);
    let _e12 = bends;
    let _e17 = gabor_impl_warp(pixel, vec2<f32>(1.1f, 0.24f), vec2<f32>(_e12.x, 0f), seed, 0i);
    board = _e17;
    let _e19 = board;
    let _e23 = bends;
    let _e28 = gabor_impl_warp(_e19, vec2<f32>(4f, 0.9f), vec2<f32>(_e23.y, 0f), seed, 1i);
    return _e28;
}

// Pores, fibres and tone.
fn gabor_impl_wood_layer(i: i32, pixel: GaborPixel, board: GaborPixel, seed: u32) -> GaborLayer {
    var local_36: vec2<f32>;
    if (i == 2i) {
        let _e11 = gabor_impl_spots_layer(2i, board, vec2<f32>(3.5f, 0.35f), seed, 5i);
        return _e11;
    }
    if (i == 0i) {
        local_36 = vec2<f32>(90f, 4.5f);
    } else {
        local_36 = vec2<f32>(150f, 2f);
    }
    let _e21 = local_36;
    let _e24 = gabor_impl_spots_layer(i, pixel, _e21, seed, (3i + i));
    return _e24;
}

fn gabor_impl_wood(board: GaborPixel, wood: GaborWood, of_: GaborPairs, seed: u32) -> GaborMaterial {
    var board_3: GaborPixel;
    var rings: f32;
    var years: vec3<f32>;
    var kept_2: f32;
    var ring: vec3<f32>;
    var pores: vec3<f32>;
    var within_1: vec3<f32>;
    var deep: vec3<f32>;
    var early: f32;
    var late: f32;
    var tones: vec2<f32>;
    var colour_2: vec3<f32>;
    var height_1: vec3<f32>;
    var depth: f32;
    var lost_4: vec3<f32>;
    board_3 = board;
    let _e5 = board_3;
    let _e15 = gabor_impl_warp(_e5, vec2<f32>(6.5f, 0.08f), vec2<f32>((0.455f / wood.rings), 0f), seed, 2i);
    board_3 = _e15;
    let _e16 = board_3;
    let _e19 = gabor_impl_repeated(_e16, wood.rings, 1f);
    rings = _e19.x;
    let _e22 = rings;
    let _e23 = board_3;
    let _e24 = gabor_impl_along_x(_e23);
    years = (_e22 * _e24);
    let _e28 = board_3;
    let _e29 = rings;
    let _e30 = gabor_impl_sine_kept(_e28, _e29);
    kept_2 = (0.97f * _e30);
    let _e33 = years;
    let _e34 = kept_2;
    let _e38 = gabor_impl_rise(_e33, vec3<f32>(_e34, 0f, 0f));
    ring = _e38;
    let _e47 = gabor_impl_above(of_.a.second, of_.a.removed, 1.1f, 0.25f);
    pores = (wood.pore_strength * _e47);
    let _e55 = ring;
    within_1 = (vec3<f32>(1f, 0f, 0f) - (0.75f * _e55));
    let _e59 = pores;
    let _e60 = within_1;
    let _e61 = gabor_impl_times(_e59, _e60);
    deep = _e61;
    let _e64 = ring;
    let _e68 = pores;
    early = ((1f - _e64.x) * (1f - _e68.x));
    let _e73 = ring;
    let _e77 = pores;
    late = (_e73.x * (1f - (0.25f * _e77.x)));
    let _e89 = gabor_impl_tone(of_.b.second.x, of_.b.removed, 0.11f);
    let _e96 = gabor_impl_tone(of_.c.second.x, of_.c.removed, 0.13f);
    tones = (_e89 + _e96);
    let _e99 = early;
    let _e101 = tones;
    let _e102 = gabor_impl_toned(wood.earlywood_colour, _e101);
    let _e104 = late;
    let _e106 = tones;
    let _e107 = gabor_impl_toned(wood.latewood_colour, _e106);
    let _e111 = deep;
    colour_2 = (((_e99 * _e102) + (_e104 * _e107)) + ((0.45f * _e111.x) * wood.latewood_colour));
    let _e119 = ring;
    let _e122 = deep;
    height_1 = (((0.0006f * _e119) - (0.0024f * _e122)) + (0.0002f * of_.b.second));
    let _e136 = within_1;
    let _e138 = within_1;
    let _e143 = kept_2;
    let _e144 = kept_2;
    depth = (((0.00000576f * wood.pore_strength) * wood.pore_strength) * ((_e136.x * _e138.x) + (0.05f * (1f - (_e143 * _e144)))));
    let _e152 = years;
    let _e154 = kept_2;
    let _e156 = gabor_impl_rise_lost(_e152.x, _e154, 0.97f);
    let _e158 = years;
    let _e160 = gabor_impl_square(_e158.yz);
    let _e167 = depth;
    let _e176 = gabor_impl_above_lost(of_.a.second, of_.a.removed, of_.a.lost, 1.1f, 0.25f);
    lost_4 = ((((0.00000036f * _e156) * _e160) + (0.00000004f * of_.b.lost)) + (_e167 * _e176));
    let _e180 = colour_2;
    let _e181 = height_1;
    let _e182 = lost_4;
    let _e186 = ring;
    let _e192 = gabor_impl_material(_e180, _e181, _e182, (wood.roughness * (1f - (0.2f * _e186.x))), 0f);
    return _e192;
}

fn gabor_wood_at(p: vec2<f32>, period: vec2<f32>, wood: GaborWood, seed: u32) -> GaborMaterial {
    var pixel_3: GaborPixel;
    var board_4: GaborPixel;
    var of_1: GaborPairs;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_3 = _e8;
    let _e10 = pixel_3;
    let _e11 = gabor_impl_board(_e10, wood, seed);
    board_4 = _e11;
    let _e13 = gabor_impl_no_pairs();
    of_1 = _e13;
    let _e17 = pixel_3;
    let _e18 = board_4;
    let _e19 = gabor_impl_wood_layer(0i, _e17, _e18, seed);
    let _e20 = gabor_impl_spots_pair(_e19);
    of_1.a = _e20;
    let _e23 = pixel_3;
    let _e24 = board_4;
    let _e25 = gabor_impl_wood_layer(1i, _e23, _e24, seed);
    let _e26 = gabor_impl_spots_pair(_e25);
    of_1.b = _e26;
    let _e29 = pixel_3;
    let _e30 = board_4;
    let _e31 = gabor_impl_wood_layer(2i, _e29, _e30, seed);
    let _e32 = gabor_impl_spots_pair(_e31);
    of_1.c = _e32;
    let _e33 = board_4;
    let _e34 = of_1;
    let _e35 = gabor_impl_wood(_e33, wood, _e34, seed);
    return _e35;
}

// ---- Samples -------------------------------------------------------------------------------------------------------
//
// The filters of weaves and of leather average 16 samples, and fade to measured means where samples are too few.

// The standard deviation of a pixel's positions along two axes together; dx and dy are its steps along them.
fn gabor_impl_sample_spread(dx: vec2<f32>, dy: vec2<f32>) -> f32 {
    return sqrt((0.125f * (dot(dx, dx) + dot(dy, dy))));
}

// The number of samples for that standard deviation.
fn gabor_impl_samples(spread: f32) -> i32 {
    var local_37: i32;
    if (spread > 0.001f) {
        local_37 = 16i;
    } else {
        local_37 = 1i;
    }
    let _e6 = local_37;
    return _e6;
}

// Sample i of 16 in steps (dx, dy) from the middle of the pixel: quantiles of a normal distribution.
fn gabor_impl_sample(i: i32, count: i32) -> vec2<f32> {
    var at_10: vec2<f32>;
    var local_38: vec2<f32>;
    at_10 = ((0.125f * vec2<f32>(f32(i), f32((((7i * i) + 10i) % 16i)))) - vec2(0.9375f));
    if (count > 1i) {
        let _e19 = at_10;
        let _e22 = at_10;
        let _e24 = at_10;
        local_38 = (_e19 * (vec2(0.5566f) + ((0.507f * _e22) * _e24)));
    } else {
        local_38 = vec2(0f);
    }
    let _e32 = local_38;
    return _e32;
}

// The sum of heights over samples. `height` becomes their mean, which fades to `mean`; `lost` has the sum of the slopes'
// squares, and becomes their covariance, which fades to `square`.
fn gabor_impl_average(height: ptr<function, vec3<f32>>, lost: ptr<function, vec3<f32>>, count: i32, kept: f32, mean: f32, square: vec3<f32>) {
    var local_39: vec3<f32>;
    let _e8 = (*height);
    (*height) = (((kept / f32(count)) * _e8) + vec3<f32>(((1f - kept) * mean), 0f, 0f));
    if (count > 1i) {
        let _e19 = (*lost);
        let _e25 = (*height);
        let _e27 = gabor_impl_square(_e25.yz);
        local_39 = (mix(square, (_e19 / vec3(f32(count))), vec3(kept)) - _e27);
    } else {
        local_39 = vec3(0f);
    }
    let _e32 = local_39;
    (*lost) = _e32;
    return;
}

// ---- Weaves --------------------------------------------------------------------------------------------------------

fn gabor_impl_cloth(pixel: GaborPixel, fabric: GaborFabric, seed: u32) -> GaborPixel {
    let _e10 = gabor_impl_warp(pixel, vec2(0.7f), vec2((0.02f * fabric.unevenness)), seed, 0i);
    return _e10;
}

// The thickness and course of threads along y and x, and their fibres.
fn gabor_impl_fabric_layer(i: i32, cloth: GaborPixel, count: vec2<f32>, seed: u32) -> GaborLayer {
    var local_40: vec2<f32>;
    var local_41: vec2<f32>;
    var local_42: vec2<f32>;
    var density_6: vec2<f32>;
    if (i == 0i) {
        local_42 = vec2<f32>((0.7f * count.x), 1.1f);
    } else {
        if (i == 1i) {
            local_41 = vec2<f32>(1.1f, (0.7f * count.y));
        } else {
            if (i == 2i) {
                local_40 = (vec2<f32>(14f, 2f) * count);
            } else {
                local_40 = (vec2<f32>(2f, 14f) * count);
            }
            let _e29 = local_40;
            local_41 = _e29;
        }
        let _e31 = local_41;
        local_42 = _e31;
    }
    let _e33 = local_42;
    density_6 = _e33;
    let _e35 = density_6;
    let _e38 = gabor_impl_spots_layer(i, cloth, _e35, seed, (1i + i));
    return _e38;
}

// Threads per unit; a weave repeats after 2, 4 or 16 of them.
fn gabor_impl_threads(pixel: GaborPixel, fabric: GaborFabric) -> vec2<f32> {
    var local_43: f32;
    var local_44: f32;
    if (fabric.weave < 0.5f) {
        local_44 = 2f;
    } else {
        if (fabric.weave < 1.5f) {
            local_43 = 4f;
        } else {
            local_43 = 16f;
        }
        let _e13 = local_43;
        local_44 = _e13;
    }
    let _e15 = local_44;
    let _e16 = gabor_impl_repeated(pixel, fabric.threads, _e15);
    return _e16;
}

// 1 where the thread along y passes over that along x, which have these numbers, and -1 where it passes under.
fn gabor_impl_over(x: f32, y: f32, weave: f32) -> f32 {
    var x_26: f32;
    var local_45: f32;
    var local_46: f32;
    x_26 = x;
    if (weave < 0.5f) {
        let _e7 = x_26;
        if (fract((0.5f * (_e7 + y))) > 0.25f) {
            local_45 = -1f;
        } else {
            local_45 = 1f;
        }
        let _e17 = local_45;
        return _e17;
    }
    if (weave > 1.5f) {
        let _e22 = x_26;
        x_26 = abs(((16f * fract(((0.0625f * _e22) + 0.03125f))) - 8.5f));
    }
    let _e32 = x_26;
    if (fract(((0.25f * (_e32 + y)) + 0.125f)) < 0.5f) {
        local_46 = 1f;
    } else {
        local_46 = -1f;
    }
    let _e44 = local_46;
    return _e44;
}

// The height of a thread: a circle of radius `thick`, which passes over the crossing thread if `bend` is 1, under if -1,
// and is level towards a thread that it crosses on the same side.
fn gabor_impl_thread(across: vec3<f32>, thick: vec3<f32>, along: vec3<f32>, bend: f32, level: bool) -> vec3<f32> {
    var square_4: f32;
    var side_2: f32;
    var local_47: f32;
    var turn_12: f32;
    var slope_14: vec2<f32>;
    var local_48: f32;
    var local_49: vec2<f32>;
    square_4 = ((thick.x * thick.x) - ((4.2f * across.x) * across.x));
    let _e15 = square_4;
    side_2 = sqrt(max(_e15, 0f));
    if level {
        local_47 = 0f;
    } else {
        local_47 = (3.1415927f * along.x);
    }
    let _e25 = local_47;
    turn_12 = _e25;
    let _e36 = side_2;
    slope_14 = (((thick.x * thick.yz) - ((4.2f * across.x) * across.yz)) / vec2(max(_e36, 0.05f)));
    let _e42 = side_2;
    let _e43 = square_4;
    if (_e43 < 0f) {
        local_48 = 2f;
    } else {
        local_48 = 1f;
    }
    let _e49 = local_48;
    let _e53 = turn_12;
    let _e57 = square_4;
    if (_e57 < 0f) {
        local_49 = vec2(0f);
    } else {
        let _e62 = slope_14;
        local_49 = _e62;
    }
    let _e64 = local_49;
    let _e67 = turn_12;
    let _e72 = (_e64 - (((1.727876f * bend) * sin(_e67)) * along.yz));
    return vec3<f32>(((_e42 - _e49) + ((0.55f * bend) * cos(_e53))), _e72.x, _e72.y);
}

// The means to which the filter fades the weave were measured; they depend on the unevenness.
fn gabor_impl_fabric(cloth: GaborPixel, count: vec2<f32>, fabric: GaborFabric, of_: GaborPairs) -> GaborMaterial {
    var uneven: f32;
    var unit_5: f32;
    var at_x: vec3<f32>;
    var at_y: vec3<f32>;
    var dx_9: vec2<f32>;
    var dy_9: vec2<f32>;
    var spread_2: f32;
    var kept_4: f32;
    var warp_tones: vec2<f32>;
    var weft_tones: vec2<f32>;
    var warp: vec3<f32>;
    var weft: vec3<f32>;
    var height_3: vec3<f32> = vec3(0f);
    var colour_3: vec3<f32> = vec3(0f);
    var lost_6: vec3<f32> = vec3(0f);
    var samples: i32;
    var i_13: i32 = 0i;
    var at_11: vec2<f32>;
    var offset_2: vec2<f32>;
    var x_27: vec3<f32>;
    var y_19: vec3<f32>;
    var thread: vec2<f32>;
    var over: f32;
    var local_50: f32;
    var level_y: bool;
    var local_51: f32;
    var level_x: bool;
    var along_y_6: vec3<f32>;
    var along_x_4: vec3<f32>;
    var first_3: bool;
    var local_52: vec3<f32>;
    var top: vec3<f32>;
    var local_53: vec3<f32>;
    var local_54: vec3<f32>;
    var mean_8: vec3<f32>;
    var cords: f32;
    var at_12: vec3<f32>;
    var damped_2: f32;
    var half_cord: f32;
    var second_3: f32;
    var turn_13: f32;
    var cord: f32;
    var depth_1: f32;
    var swing: f32;
    uneven = fabric.unevenness;
    unit_5 = (fabric.relief / fabric.threads);
    let _e11 = gabor_impl_along_x(cloth);
    at_x = (count.x * _e11);
    let _e15 = gabor_impl_along_y(cloth);
    at_y = (count.y * _e15);
    dx_9 = (count * cloth.dx);
    dy_9 = (count * cloth.dy);
    let _e24 = dx_9;
    let _e25 = dy_9;
    let _e26 = gabor_impl_sample_spread(_e24, _e25);
    spread_2 = _e26;
    let _e31 = spread_2;
    kept_4 = (1f - smoothstep(0.3f, 0.7f, _e31));
    let _e35 = at_x;
    let _e37 = uneven;
    at_x = (_e35 + ((0.13f * _e37) * of_.a.first));
    let _e43 = at_y;
    let _e45 = uneven;
    at_y = (_e43 + ((0.13f * _e45) * of_.b.first));
    let _e57 = uneven;
    let _e59 = gabor_impl_tone(of_.a.first.x, of_.a.removed, (0.09f * _e57));
    let _e66 = gabor_impl_tone(of_.c.second.x, of_.c.removed, 0.12f);
    warp_tones = (_e59 + _e66);
    let _e75 = uneven;
    let _e77 = gabor_impl_tone(of_.b.first.x, of_.b.removed, (0.09f * _e75));
    let _e84 = gabor_impl_tone(of_.d.second.x, of_.d.removed, 0.12f);
    weft_tones = (_e77 + _e84);
    let _e88 = warp_tones;
    let _e89 = gabor_impl_toned(fabric.warp_colour, _e88);
    warp = _e89;
    let _e92 = weft_tones;
    let _e93 = gabor_impl_toned(fabric.weft_colour, _e92);
    weft = _e93;
    let _e104 = spread_2;
    let _e105 = gabor_impl_samples(_e104);
    samples = _e105;
    loop {
        let _e109 = i_13;
        let _e110 = samples;
        if !((_e109 < _e110)) {
            break;
        }
        {
            let _e116 = i_13;
            let _e117 = samples;
            let _e118 = gabor_impl_sample(_e116, _e117);
            at_11 = _e118;
            let _e120 = at_11;
            let _e122 = dx_9;
            let _e124 = at_11;
            let _e126 = dy_9;
            offset_2 = ((_e120.x * _e122) + (_e124.y * _e126));
            let _e130 = at_x;
            let _e131 = offset_2;
            x_27 = (_e130 + vec3<f32>(_e131.x, 0f, 0f));
            let _e138 = at_y;
            let _e139 = offset_2;
            y_19 = (_e138 + vec3<f32>(_e139.y, 0f, 0f));
            let _e146 = x_27;
            let _e148 = y_19;
            thread = floor(vec2<f32>(_e146.x, _e148.x));
            let _e154 = x_27;
            let _e156 = thread;
            x_27.x = (_e154.x - (_e156.x + 0.5f));
            let _e162 = y_19;
            let _e164 = thread;
            y_19.x = (_e162.x - (_e164.y + 0.5f));
            let _e169 = thread;
            let _e171 = thread;
            let _e174 = gabor_impl_over(_e169.x, _e171.y, fabric.weave);
            over = _e174;
            let _e176 = over;
            let _e177 = thread;
            let _e179 = thread;
            let _e181 = y_19;
            if (_e181.x < 0f) {
                local_50 = -1f;
            } else {
                local_50 = 1f;
            }
            let _e189 = local_50;
            let _e192 = gabor_impl_over(_e177.x, (_e179.y + _e189), fabric.weave);
            level_y = (_e176 == _e192);
            let _e195 = over;
            let _e196 = thread;
            let _e198 = x_27;
            if (_e198.x < 0f) {
                local_51 = -1f;
            } else {
                local_51 = 1f;
            }
            let _e206 = local_51;
            let _e208 = thread;
            let _e211 = gabor_impl_over((_e196.x + _e206), _e208.y, fabric.weave);
            level_x = (_e195 == _e211);
            let _e214 = x_27;
            let _e220 = uneven;
            let _e226 = y_19;
            let _e227 = over;
            let _e228 = level_y;
            let _e229 = gabor_impl_thread(_e214, (vec3<f32>(1f, 0f, 0f) + ((0.16f * _e220) * of_.a.second)), _e226, _e227, _e228);
            along_y_6 = _e229;
            let _e231 = y_19;
            let _e237 = uneven;
            let _e243 = x_27;
            let _e244 = over;
            let _e246 = level_x;
            let _e247 = gabor_impl_thread(_e231, (vec3<f32>(1f, 0f, 0f) + ((0.16f * _e237) * of_.b.second)), _e243, -(_e244), _e246);
            along_x_4 = _e247;
            let _e249 = along_y_6;
            let _e251 = along_x_4;
            first_3 = (_e249.x > _e251.x);
            let _e255 = first_3;
            if _e255 {
                let _e256 = along_y_6;
                local_52 = _e256;
            } else {
                let _e257 = along_x_4;
                local_52 = _e257;
            }
            let _e259 = local_52;
            top = _e259;
            let _e261 = top;
            if (_e261.x < -1.3f) {
                top = vec3<f32>(-1.3f, 0f, 0f);
            }
            let _e271 = colour_3;
            let _e277 = top;
            let _e281 = first_3;
            if _e281 {
                let _e282 = warp;
                local_53 = _e282;
            } else {
                let _e283 = weft;
                local_53 = _e283;
            }
            let _e285 = local_53;
            colour_3 = (_e271 + (mix(0.18f, 1f, smoothstep(-1.3f, 0.5f, _e277.x)) * _e285));
            let _e289 = top;
            let _e292 = first_3;
            if _e292 {
                local_54 = of_.c.second;
            } else {
                local_54 = of_.d.second;
            }
            let _e298 = local_54;
            top = ((0.3f * _e289) + (0.035f * _e298));
            let _e301 = height_3;
            let _e302 = top;
            height_3 = (_e301 + _e302);
            let _e304 = lost_6;
            let _e305 = top;
            let _e307 = gabor_impl_square(_e305.yz);
            lost_6 = (_e304 + _e307);
        }
        continuing {
            let _e113 = i_13;
            i_13 = (_e113 + 1i);
        }
    }
    let _e311 = uneven;
    let _e313 = uneven;
    let _e318 = uneven;
    let _e320 = uneven;
    mean_8 = vec3<f32>((0.8828f - ((0.0056f * _e311) * _e313)), (0.0406f + ((0.0025f * _e318) * _e320)), 0.29f);
    if (fabric.weave >= 0.5f) {
        let _e330 = uneven;
        let _e333 = uneven;
        mean_8 = vec3<f32>((0.91f - (_e330 * (0.0105f + (0.0045f * _e333)))), 0.0655f, 0.37f);
    }
    let _e343 = samples;
    let _e344 = kept_4;
    let _e345 = mean_8;
    let _e347 = mean_8;
    let _e350 = ((_e347.z * count) * count);
    gabor_impl_average((&height_3), (&lost_6), _e343, _e344, _e345.y, vec3<f32>(_e350.x, _e350.y, 0f));
    let _e358 = mean_8;
    let _e361 = warp;
    let _e362 = weft;
    let _e365 = colour_3;
    let _e366 = samples;
    let _e370 = kept_4;
    colour_3 = mix(((0.5f * _e358.x) * (_e361 + _e362)), (_e365 / vec3(f32(_e366))), vec3(_e370));
    let _e373 = height_3;
    let _e374 = unit_5;
    height_3 = (_e373 * _e374);
    let _e376 = unit_5;
    let _e377 = unit_5;
    let _e379 = lost_6;
    lost_6 = ((_e376 * _e377) * (_e379 + (0.0006125f * (of_.c.lost + of_.d.lost))));
    if (fabric.cords > 0f) {
        {
            let _e394 = gabor_impl_repeated(cloth, fabric.cords, 1f);
            cords = _e394.x;
            let _e397 = cords;
            let _e398 = gabor_impl_along_x(cloth);
            at_12 = (_e397 * _e398);
            let _e401 = cords;
            let _e402 = gabor_impl_sine_kept(cloth, _e401);
            damped_2 = _e402;
            let _e405 = damped_2;
            half_cord = (0.5f * _e405);
            let _e409 = damped_2;
            let _e411 = damped_2;
            let _e413 = damped_2;
            let _e415 = damped_2;
            second_3 = ((((0.125f * _e409) * _e411) * _e413) * _e415);
            let _e419 = at_12;
            turn_13 = (6.2831855f * fract(_e419.x));
            let _e425 = half_cord;
            let _e426 = turn_13;
            let _e430 = second_3;
            let _e432 = turn_13;
            cord = ((0.625f - (_e425 * cos(_e426))) - (_e430 * cos((2f * _e432))));
            let _e441 = cords;
            depth_1 = ((0.3f * fabric.relief) / _e441);
            let _e444 = depth_1;
            swing = (_e444 * 6.2831855f);
            let _e448 = colour_3;
            let _e451 = cord;
            colour_3 = (_e448 * mix(0.3f, 1f, _e451));
            let _e454 = height_3;
            let _e455 = depth_1;
            let _e456 = cord;
            let _e458 = swing;
            let _e459 = half_cord;
            let _e460 = turn_13;
            let _e464 = second_3;
            let _e467 = turn_13;
            let _e473 = at_12;
            let _e475 = ((_e458 * ((_e459 * sin(_e460)) + ((2f * _e464) * sin((2f * _e467))))) * _e473.yz);
            height_3 = (_e454 + vec3<f32>((_e455 * _e456), _e475.x, _e475.y));
            let _e480 = lost_6;
            let _e481 = swing;
            let _e482 = swing;
            let _e486 = half_cord;
            let _e488 = half_cord;
            let _e492 = second_3;
            let _e494 = second_3;
            let _e498 = at_12;
            let _e500 = gabor_impl_square(_e498.yz);
            lost_6 = (_e480 + (((_e481 * _e482) * ((0.15625f - ((0.5f * _e486) * _e488)) - ((2f * _e492) * _e494))) * _e500));
        }
    }
    let _e503 = colour_3;
    let _e504 = height_3;
    let _e505 = lost_6;
    let _e508 = gabor_impl_material(_e503, _e504, _e505, fabric.roughness, 0f);
    return _e508;
}

fn gabor_fabric_at(p: vec2<f32>, period: vec2<f32>, fabric: GaborFabric, seed: u32) -> GaborMaterial {
    var pixel_6: GaborPixel;
    var cloth_2: GaborPixel;
    var count_7: vec2<f32>;
    var of_3: GaborPairs;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_6 = _e8;
    let _e10 = pixel_6;
    let _e11 = gabor_impl_cloth(_e10, fabric, seed);
    cloth_2 = _e11;
    let _e13 = pixel_6;
    let _e14 = gabor_impl_threads(_e13, fabric);
    count_7 = _e14;
    let _e16 = gabor_impl_no_pairs();
    of_3 = _e16;
    let _e20 = cloth_2;
    let _e21 = count_7;
    let _e22 = gabor_impl_fabric_layer(0i, _e20, _e21, seed);
    let _e23 = gabor_impl_spots_pair(_e22);
    of_3.a = _e23;
    let _e26 = cloth_2;
    let _e27 = count_7;
    let _e28 = gabor_impl_fabric_layer(1i, _e26, _e27, seed);
    let _e29 = gabor_impl_spots_pair(_e28);
    of_3.b = _e29;
    let _e32 = cloth_2;
    let _e33 = count_7;
    let _e34 = gabor_impl_fabric_layer(2i, _e32, _e33, seed);
    let _e35 = gabor_impl_spots_pair(_e34);
    of_3.c = _e35;
    let _e38 = cloth_2;
    let _e39 = count_7;
    let _e40 = gabor_impl_fabric_layer(3i, _e38, _e39, seed);
    let _e41 = gabor_impl_spots_pair(_e40);
    of_3.d = _e41;
    let _e42 = cloth_2;
    let _e43 = count_7;
    let _e44 = of_3;
    let _e45 = gabor_impl_fabric(_e42, _e43, fabric, _e44);
    return _e45;
}

fn gabor_impl_twill(pixel: GaborPixel, seed: u32) -> GaborPixel {
    let _e7 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.008f), seed, 0i);
    return _e7;
}

// The fibres of tows along y and x.
fn gabor_impl_tow_layer(i: i32, cloth: GaborPixel, count: vec2<f32>, seed: u32) -> GaborLayer {
    var local_55: vec2<f32>;
    if (i == 0i) {
        local_55 = vec2<f32>(20f, 0.6f);
    } else {
        local_55 = vec2<f32>(0.6f, 20f);
    }
    let _e13 = local_55;
    let _e17 = gabor_impl_spots_layer(i, cloth, (_e13 * count), seed, (1i + i));
    return _e17;
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
fn gabor_impl_carbon_fibre(cloth: GaborPixel, count: vec2<f32>, fibres: GaborCarbonFibre, of_: GaborPairs) -> GaborMaterial {
    var at_x_1: vec3<f32>;
    var at_y_1: vec3<f32>;
    var dx_10: vec2<f32>;
    var dy_10: vec2<f32>;
    var spread_3: f32;
    var kept_5: f32;
    var unit_6: f32;
    var warp_1: vec3<f32>;
    var weft_1: vec3<f32>;
    var height_4: vec3<f32> = vec3(0f);
    var colour_4: vec3<f32> = vec3(0f);
    var lost_7: vec3<f32> = vec3(0f);
    var samples_1: i32;
    var i_15: i32 = 0i;
    var at_13: vec2<f32>;
    var offset_3: vec2<f32>;
    var x_28: vec3<f32>;
    var y_20: vec3<f32>;
    var turn_14: f32;
    var first_4: bool;
    var local_56: vec3<f32>;
    var along_3: vec3<f32>;
    var local_57: vec3<f32>;
    var across_3: vec3<f32>;
    var local_58: f32;
    var cube: f32;
    var low_1: f32;
    var arch: f32;
    var wave_17: vec2<f32>;
    var bulge: vec3<f32>;
    var local_59: vec3<f32>;
    var local_60: vec3<f32>;
    let _e5 = gabor_impl_along_x(cloth);
    at_x_1 = (count.x * _e5);
    let _e9 = gabor_impl_along_y(cloth);
    at_y_1 = (count.y * _e9);
    dx_10 = (count * cloth.dx);
    dy_10 = (count * cloth.dy);
    let _e18 = dx_10;
    let _e19 = dy_10;
    let _e20 = gabor_impl_sample_spread(_e18, _e19);
    spread_3 = _e20;
    let _e25 = spread_3;
    kept_5 = (1f - smoothstep(0.5f, 1f, _e25));
    unit_6 = (fibres.relief / fibres.tows);
    let _e40 = gabor_impl_tone(of_.a.first.x, of_.a.removed, fibres.fibre_contrast);
    let _e41 = gabor_impl_toned(fibres.colour, _e40);
    warp_1 = _e41;
    let _e50 = gabor_impl_tone(of_.b.first.x, of_.b.removed, fibres.fibre_contrast);
    let _e51 = gabor_impl_toned(fibres.colour, _e50);
    weft_1 = _e51;
    let _e62 = spread_3;
    let _e63 = gabor_impl_samples(_e62);
    samples_1 = _e63;
    loop {
        let _e67 = i_15;
        let _e68 = samples_1;
        if !((_e67 < _e68)) {
            break;
        }
        {
            let _e74 = i_15;
            let _e75 = samples_1;
            let _e76 = gabor_impl_sample(_e74, _e75);
            at_13 = _e76;
            let _e78 = at_13;
            let _e80 = dx_10;
            let _e82 = at_13;
            let _e84 = dy_10;
            offset_3 = ((_e78.x * _e80) + (_e82.y * _e84));
            let _e88 = at_x_1;
            let _e89 = offset_3;
            x_28 = (_e88 + vec3<f32>(_e89.x, 0f, 0f));
            let _e96 = at_y_1;
            let _e97 = offset_3;
            y_20 = (_e96 + vec3<f32>(_e97.y, 0f, 0f));
            let _e106 = x_28;
            let _e109 = y_20;
            turn_14 = ((4f * fract(((0.25f * (floor(_e106.x) + floor(_e109.x))) + 0.125f))) - 0.5f);
            let _e122 = x_28;
            let _e124 = x_28;
            x_28.x = (_e122.x - floor(_e124.x));
            let _e129 = y_20;
            let _e131 = y_20;
            y_20.x = (_e129.x - floor(_e131.x));
            let _e135 = turn_14;
            first_4 = (_e135 < 1.5f);
            let _e140 = first_4;
            if _e140 {
                let _e141 = y_20;
                local_56 = _e141;
            } else {
                let _e142 = x_28;
                local_56 = _e142;
            }
            let _e144 = local_56;
            along_3 = (0.5f * _e144);
            let _e148 = first_4;
            if _e148 {
                let _e149 = x_28;
                local_57 = _e149;
            } else {
                let _e150 = y_20;
                local_57 = _e150;
            }
            let _e152 = local_57;
            across_3 = (2f * _e152);
            let _e156 = along_3;
            let _e159 = turn_14;
            if (fract(((0.5f * _e159) + 0.25f)) < 0.5f) {
                local_58 = 0f;
            } else {
                local_58 = 0.5f;
            }
            let _e169 = local_58;
            along_3.x = (_e156.x + _e169);
            let _e172 = across_3;
            across_3.x = (_e172.x - 1f);
            let _e176 = across_3;
            let _e178 = across_3;
            let _e181 = across_3;
            cube = ((_e176.x * _e178.x) * _e181.x);
            let _e186 = cube;
            let _e187 = across_3;
            low_1 = (1f - (_e186 * _e187.x));
            let _e192 = low_1;
            let _e193 = low_1;
            arch = (_e192 * _e193);
            let _e197 = along_3;
            let _e202 = along_3;
            wave_17 = vec2<f32>(cos((3.1415927f * _e197.x)), sin((3.1415927f * _e202.x)));
            let _e208 = wave_17;
            let _e210 = arch;
            let _e213 = arch;
            let _e215 = wave_17;
            let _e218 = along_3;
            let _e222 = cube;
            let _e224 = low_1;
            let _e226 = wave_17;
            let _e229 = across_3;
            let _e232 = ((((3.1415927f * _e213) * _e215.x) * _e218.yz) - ((((8f * _e222) * _e224) * _e226.y) * _e229.yz));
            bulge = vec3<f32>((_e208.y * _e210), _e232.x, _e232.y);
            let _e237 = colour_4;
            let _e240 = bulge;
            let _e244 = first_4;
            if _e244 {
                let _e245 = warp_1;
                local_59 = _e245;
            } else {
                let _e246 = weft_1;
                local_59 = _e246;
            }
            let _e248 = local_59;
            colour_4 = (_e237 + ((0.35f + (0.65f * _e240.x)) * _e248));
            let _e252 = bulge;
            let _e255 = first_4;
            if _e255 {
                local_60 = of_.a.first;
            } else {
                local_60 = of_.b.first;
            }
            let _e261 = local_60;
            bulge = ((0.16f * _e252) + (0.006f * _e261));
            let _e264 = height_4;
            let _e265 = bulge;
            height_4 = (_e264 + _e265);
            let _e267 = lost_7;
            let _e268 = bulge;
            let _e270 = gabor_impl_square(_e268.yz);
            lost_7 = (_e267 + _e270);
        }
        continuing {
            let _e71 = i_15;
            i_15 = (_e71 + 1i);
        }
    }
    let _e274 = samples_1;
    let _e275 = kept_5;
    let _e280 = (count * count);
    gabor_impl_average((&height_4), (&lost_7), _e274, _e275, 0.072432f, (0.0551424f * vec3<f32>(_e280.x, _e280.y, 0f)));
    let _e289 = warp_1;
    let _e290 = weft_1;
    let _e293 = colour_4;
    let _e294 = samples_1;
    let _e298 = kept_5;
    colour_4 = mix((0.3221275f * (_e289 + _e290)), (_e293 / vec3(f32(_e294))), vec3(_e298));
    let _e301 = unit_6;
    let _e302 = unit_6;
    let _e304 = lost_7;
    lost_7 = ((_e301 * _e302) * (_e304 + (0.000018f * (of_.a.lost + of_.b.lost))));
    let _e314 = colour_4;
    let _e315 = unit_6;
    let _e316 = height_4;
    let _e318 = lost_7;
    let _e321 = gabor_impl_material(_e314, (_e315 * _e316), _e318, fibres.roughness, 0f);
    return _e321;
}

fn gabor_carbon_fibre_at(p: vec2<f32>, period: vec2<f32>, fibres: GaborCarbonFibre, seed: u32) -> GaborMaterial {
    var pixel_8: GaborPixel;
    var cloth_5: GaborPixel;
    var count_10: vec2<f32>;
    var of_5: GaborPairs;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_8 = _e8;
    let _e10 = pixel_8;
    let _e11 = gabor_impl_twill(_e10, seed);
    cloth_5 = _e11;
    let _e13 = pixel_8;
    let _e16 = gabor_impl_repeated(_e13, fibres.tows, 4f);
    count_10 = _e16;
    let _e18 = gabor_impl_no_pairs();
    of_5 = _e18;
    let _e22 = cloth_5;
    let _e23 = count_10;
    let _e24 = gabor_impl_tow_layer(0i, _e22, _e23, seed);
    let _e25 = gabor_impl_spots_pair(_e24);
    of_5.a = _e25;
    let _e28 = cloth_5;
    let _e29 = count_10;
    let _e30 = gabor_impl_tow_layer(1i, _e28, _e29, seed);
    let _e31 = gabor_impl_spots_pair(_e30);
    of_5.b = _e31;
    let _e32 = cloth_5;
    let _e33 = count_10;
    let _e34 = of_5;
    let _e35 = gabor_impl_carbon_fibre(_e32, _e33, fibres, _e34);
    return _e35;
}

// ---- Leather -------------------------------------------------------------------------------------------------------
//
// Three waves. The phase of the third is the sum of the other two, so the crests of all three meet in each cell's middle.

fn gabor_impl_skin(pixel: GaborPixel, leather: GaborLeather, seed: u32) -> GaborPixel {
    var bends_1: vec2<f32>;
    var skin: GaborPixel;
    bends_1 = (vec2<f32>(0.07f, 0.014f) * leather.waviness);
    let _e11 = bends_1;
    let _e15 = gabor_impl_warp(pixel, vec2(0.9f), vec2(_e11.x), seed, 0i);
    skin = _e15;
    let _e17 = skin;
    let _e20 = bends_1;
    let _e24 = gabor_impl_warp(_e17, vec2(4f), vec2(_e20.y), seed, 1i);
    return _e24;
}

// Three octaves of fine grain, the tone, and the first two waves.
fn gabor_impl_leather_layer(i: i32, pixel: GaborPixel, skin: GaborPixel, leather: GaborLeather, seed: u32) -> GaborLayer {
    var local_61: f32;
    if (i < 3i) {
        let _e12 = gabor_derived_seed(seed, 4i);
        let _e13 = gabor_impl_octave(pixel, vec2(18f), i, 3i, 0.75f, _e12);
        return _e13;
    }
    if (i == 3i) {
        let _e20 = gabor_impl_spots_layer(1i, pixel, vec2(0.8f), seed, 5i);
        return _e20;
    }
    if (i == 4i) {
        local_61 = 0.2f;
    } else {
        local_61 = 2.2944f;
    }
    let _e33 = local_61;
    let _e36 = gabor_impl_waves_layer((i - 2i), skin, vec2((leather.cells / 1.6f)), 1.6f, _e33, seed, (i - 2i));
    return _e36;
}

// Waves at an offset: their envelope moves along its slope, and the phase turns.
fn gabor_impl_moved_waves(waves: GaborPair, at: GaborPixel, wave: vec2<f32>, offset: vec2<f32>, turns: f32) -> GaborPair {
    var turn_15: vec2<f32>;
    var phase_9: vec3<f32>;
    var a_13: vec3<f32>;
    var b_15: vec3<f32>;
    var first_5: vec3<f32>;
    var second_4: vec3<f32>;
    let _e5 = gabor_impl_wave(turns);
    turn_15 = _e5;
    phase_9 = (6.2831855f * vec3<f32>(0f, dot(wave, at.x), dot(wave, at.y)));
    let _e19 = phase_9;
    a_13 = (waves.first + (waves.second.x * _e19));
    let _e26 = phase_9;
    b_15 = (waves.second - (waves.first.x * _e26));
    let _e31 = a_13;
    let _e33 = a_13;
    a_13.x = (_e31.x + dot(_e33.yz, offset));
    let _e38 = b_15;
    let _e40 = b_15;
    b_15.x = (_e38.x + dot(_e40.yz, offset));
    let _e44 = turn_15;
    let _e46 = a_13;
    let _e48 = turn_15;
    let _e50 = b_15;
    first_5 = ((_e44.x * _e46) - (_e48.y * _e50));
    let _e54 = turn_15;
    let _e56 = a_13;
    let _e58 = turn_15;
    let _e60 = b_15;
    second_4 = ((_e54.y * _e56) + (_e58.x * _e60));
    let _e64 = first_5;
    let _e65 = second_4;
    let _e67 = phase_9;
    let _e70 = second_4;
    let _e71 = first_5;
    let _e73 = phase_9;
    return GaborPair((_e64 - (_e65.x * _e67)), (_e70 + (_e71.x * _e73)), 0f, vec3(0f));
}

// Brings the waves of a pair near length 1: their cosine and sine.
fn gabor_impl_crest(waves: GaborPair, cosine: ptr<function, vec3<f32>>, sine: ptr<function, vec3<f32>>) {
    var power_6: f32;
    var change_4: vec2<f32>;
    var unit_7: vec3<f32>;
    power_6 = (((waves.first.x * waves.first.x) + (waves.second.x * waves.second.x)) + 0.12f);
    change_4 = ((waves.first.x * waves.first.yz) + (waves.second.x * waves.second.yz));
    let _e29 = power_6;
    let _e34 = power_6;
    let _e36 = change_4;
    let _e37 = ((-1f / _e34) * _e36);
    unit_7 = (inverseSqrt(_e29) * vec3<f32>(1f, _e37.x, _e37.y));
    let _e44 = unit_7;
    let _e45 = gabor_impl_times(waves.first, _e44);
    (*cosine) = _e45;
    let _e47 = unit_7;
    let _e48 = gabor_impl_times(waves.second, _e47);
    (*sine) = _e48;
    return;
}

// The means to which the filter fades, and the mean squares of the slopes, were measured.
fn gabor_impl_leather(pixel: GaborPixel, skin: GaborPixel, leather: GaborLeather, of_: GaborPairs) -> GaborMaterial {
    var wave_a: vec2<f32>;
    var wave_b: vec2<f32>;
    var dx_11: vec2<f32>;
    var dy_11: vec2<f32>;
    var spread_4: f32;
    var bend_2: f32;
    var kept_6: f32;
    var share: f32 = 0f;
    var grains: f32 = 0f;
    var height_5: vec3<f32> = vec3(0f);
    var lost_8: vec3<f32> = vec3(0f);
    var samples_2: i32;
    var i_17: i32 = 0i;
    var at_15: vec2<f32>;
    var offset_5: vec2<f32>;
    var further: vec2<f32>;
    var a_14: vec3<f32>;
    var b_16: vec3<f32>;
    var sine_a: vec3<f32>;
    var sine_b: vec3<f32>;
    var cells: vec3<f32>;
    var grained: vec3<f32>;
    var pebble: vec2<f32>;
    var relief: vec3<f32>;
    var grain: f32;
    var square_5: vec3<f32>;
    var tones_1: vec2<f32>;
    var colour_5: vec3<f32>;
    let _e6 = gabor_wave_vector(leather.cells, 0.2f);
    wave_a = _e6;
    let _e10 = gabor_wave_vector(leather.cells, 2.2944f);
    wave_b = _e10;
    let _e12 = wave_a;
    let _e15 = wave_b;
    dx_11 = vec2<f32>(dot(_e12, skin.dx), dot(_e15, skin.dx));
    let _e20 = wave_a;
    let _e23 = wave_b;
    dy_11 = vec2<f32>(dot(_e20, skin.dy), dot(_e23, skin.dy));
    let _e28 = dx_11;
    let _e29 = dy_11;
    let _e30 = gabor_impl_sample_spread(_e28, _e29);
    spread_4 = _e30;
    let _e34 = spread_4;
    let _e36 = spread_4;
    bend_2 = exp(((-30f * _e34) * _e36));
    let _e43 = spread_4;
    kept_6 = (1f - smoothstep(0.4f, 0.8f, _e43));
    let _e57 = spread_4;
    let _e58 = gabor_impl_samples(_e57);
    samples_2 = _e58;
    loop {
        let _e62 = i_17;
        let _e63 = samples_2;
        if !((_e62 < _e63)) {
            break;
        }
        {
            let _e69 = i_17;
            let _e70 = samples_2;
            let _e71 = gabor_impl_sample(_e69, _e70);
            at_15 = _e71;
            let _e73 = at_15;
            let _e75 = dx_11;
            let _e77 = at_15;
            let _e79 = dy_11;
            offset_5 = ((_e73.x * _e75) + (_e77.y * _e79));
            let _e83 = bend_2;
            let _e84 = at_15;
            let _e88 = at_15;
            further = (_e83 * ((_e84.x * pixel.dx) + (_e88.y * pixel.dy)));
            let _e100 = wave_a;
            let _e101 = further;
            let _e102 = offset_5;
            let _e104 = gabor_impl_moved_waves(of_.c, skin, _e100, _e101, _e102.x);
            gabor_impl_crest(_e104, (&a_14), (&sine_a));
            let _e110 = wave_b;
            let _e111 = further;
            let _e112 = offset_5;
            let _e114 = gabor_impl_moved_waves(of_.d, skin, _e110, _e111, _e112.y);
            gabor_impl_crest(_e114, (&b_16), (&sine_b));
            let _e119 = a_14;
            let _e120 = b_16;
            let _e122 = a_14;
            let _e123 = b_16;
            let _e124 = gabor_impl_times(_e122, _e123);
            let _e126 = sine_a;
            let _e127 = sine_b;
            let _e128 = gabor_impl_times(_e126, _e127);
            cells = (((_e119 + _e120) + _e124) - _e128);
            let _e131 = cells;
            grained = (_e131 + (0.1f * of_.a.second));
            let _e142 = grained;
            let _e147 = gabor_impl_step(-1.45f, -0.55f, vec3<f32>(_e142.x, 1f, 0f));
            pebble = _e147.xy;
            let _e150 = share;
            let _e151 = pebble;
            share = (_e150 + _e151.x);
            let _e155 = pebble;
            let _e157 = pebble;
            let _e159 = grained;
            let _e161 = (_e157.y * _e159.yz);
            let _e170 = cells;
            let _e171 = gabor_impl_step(-1f, 3f, _e170);
            relief = (((0.016f * vec3<f32>(_e155.x, _e161.x, _e161.y)) + (0.013f * _e171)) + (0.0008f * of_.a.second));
            let _e181 = pebble;
            grain = ((0.0016f * _e181.y) + 0.0008f);
            let _e187 = grains;
            let _e188 = grain;
            let _e189 = grain;
            grains = (_e187 + (_e188 * _e189));
            let _e192 = height_5;
            let _e193 = relief;
            height_5 = (_e192 + _e193);
            let _e195 = lost_8;
            let _e196 = relief;
            let _e198 = gabor_impl_square(_e196.yz);
            lost_8 = (_e195 + _e198);
        }
        continuing {
            let _e66 = i_17;
            i_17 = (_e66 + 1i);
        }
    }
    square_5 = ((leather.cells * leather.cells) * vec3<f32>(0.0027f, 0.0024f, -0.00012f));
    let _e212 = samples_2;
    let _e213 = kept_6;
    let _e215 = square_5;
    gabor_impl_average((&height_5), (&lost_8), _e212, _e213, 0.015964f, _e215);
    let _e219 = share;
    let _e220 = samples_2;
    let _e223 = kept_6;
    share = mix(0.806f, (_e219 / f32(_e220)), _e223);
    let _e231 = gabor_impl_tone(of_.b.second.x, of_.b.removed, 0.14f);
    let _e238 = gabor_impl_tone(of_.a.first.x, of_.a.removed, 0.08f);
    tones_1 = (_e231 + _e238);
    let _e242 = tones_1;
    let _e243 = gabor_impl_toned(leather.crease_colour, _e242);
    let _e245 = tones_1;
    let _e246 = gabor_impl_toned(leather.pebble_colour, _e245);
    let _e247 = share;
    colour_5 = mix(_e243, _e246, vec3(_e247));
    let _e254 = lost_8;
    let _e256 = grains;
    let _e257 = samples_2;
    let _e260 = kept_6;
    lost_8 = ((leather.relief * leather.relief) * (_e254 + (mix(0.00000064f, (_e256 / f32(_e257)), _e260) * of_.a.lost)));
    let _e267 = colour_5;
    let _e269 = height_5;
    let _e271 = lost_8;
    let _e275 = share;
    let _e280 = gabor_impl_material(_e267, (leather.relief * _e269), _e271, (leather.roughness + (0.15f * (1f - _e275))), 0f);
    return _e280;
}

fn gabor_leather_at(p: vec2<f32>, period: vec2<f32>, leather: GaborLeather, seed: u32) -> GaborMaterial {
    var pixel_12: GaborPixel;
    var skin_3: GaborPixel;
    var of_7: GaborPairs;
    var i_18: i32 = 0i;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_12 = _e8;
    let _e10 = pixel_12;
    let _e11 = gabor_impl_skin(_e10, leather, seed);
    skin_3 = _e11;
    let _e13 = gabor_impl_no_pairs();
    of_7 = _e13;
    loop {
        let _e17 = i_18;
        if !((_e17 < 3i)) {
            break;
        }
        let _e25 = of_7;
        let _e27 = i_18;
        let _e28 = pixel_12;
        let _e29 = skin_3;
        let _e30 = gabor_impl_leather_layer(_e27, _e28, _e29, leather, seed);
        let _e31 = gabor_impl_plus_octave(_e25.a, _e30);
        of_7.a = _e31;
        continuing {
            let _e21 = i_18;
            i_18 = (_e21 + 1i);
        }
    }
    let _e34 = pixel_12;
    let _e35 = skin_3;
    let _e36 = gabor_impl_leather_layer(3i, _e34, _e35, leather, seed);
    let _e37 = gabor_impl_spots_pair(_e36);
    of_7.b = _e37;
    let _e40 = pixel_12;
    let _e41 = skin_3;
    let _e42 = gabor_impl_leather_layer(4i, _e40, _e41, leather, seed);
    let _e43 = gabor_impl_waves_pair(_e42);
    of_7.c = _e43;
    let _e46 = pixel_12;
    let _e47 = skin_3;
    let _e48 = gabor_impl_leather_layer(5i, _e46, _e47, leather, seed);
    let _e49 = gabor_impl_waves_pair(_e48);
    of_7.d = _e49;
    let _e50 = pixel_12;
    let _e51 = skin_3;
    let _e52 = of_7;
    let _e53 = gabor_impl_leather(_e50, _e51, leather, _e52);
    return _e53;
}

// ---- Marble --------------------------------------------------------------------------------------------------------

fn gabor_impl_stone(pixel: GaborPixel, marble: GaborMarble, seed: u32) -> GaborPixel {
    var bends_2: vec4<f32>;
    var stone: GaborPixel;
    bends_2 = (vec4<f32>(0.17f, 0.038f, 0.01f, 0.003f) * marble.turbulence);
    let _e13 = bends_2;
    let _e17 = gabor_impl_warp(pixel, vec2(1.1f), vec2(_e13.x), seed, 0i);
    stone = _e17;
    let _e19 = stone;
    let _e22 = bends_2;
    let _e26 = gabor_impl_warp(_e19, vec2(4f), vec2(_e22.y), seed, 1i);
    stone = _e26;
    let _e27 = stone;
    let _e30 = bends_2;
    let _e34 = gabor_impl_warp(_e27, vec2(13f), vec2(_e30.z), seed, 2i);
    stone = _e34;
    let _e35 = stone;
    let _e38 = bends_2;
    let _e42 = gabor_impl_warp(_e35, vec2(40f), vec2(_e38.w), seed, 3i);
    return _e42;
}

// Three octaves of clouds, crystals, and four sizes of veins: middle, large, thin, hair.
fn gabor_impl_marble_layer(i: i32, pixel: GaborPixel, stone: GaborPixel, seed: u32) -> GaborLayer {
    var local_62: vec3<f32>;
    var local_63: vec3<f32>;
    var local_64: vec3<f32>;
    var vein: vec3<f32>;
    var local_65: i32;
    var local_66: i32;
    if (i < 3i) {
        let _e11 = gabor_derived_seed(seed, 8i);
        let _e12 = gabor_impl_octave(stone, vec2(1.5f), i, 3i, 0.6f, _e11);
        return _e12;
    }
    if (i == 3i) {
        let _e19 = gabor_impl_spots_layer(1i, pixel, vec2(75f), seed, 9i);
        return _e19;
    }
    if (i == 4i) {
        local_64 = vec3<f32>(1.9f, 0.95f, -0.45f);
    } else {
        if (i == 5i) {
            local_63 = vec3<f32>(0.95f, 0.85f, 0.65f);
        } else {
            if (i == 6i) {
                local_62 = vec3<f32>(4.5f, 0.95f, 0.95f);
            } else {
                local_62 = vec3<f32>(13f, 0.9f, 0.2f);
            }
            let _e44 = local_62;
            local_63 = _e44;
        }
        let _e46 = local_63;
        local_64 = _e46;
    }
    let _e48 = local_64;
    vein = _e48;
    let _e51 = vein;
    let _e54 = vein;
    let _e56 = vein;
    if (i == 4i) {
        local_66 = 5i;
    } else {
        if (i == 5i) {
            local_65 = 4i;
        } else {
            local_65 = i;
        }
        let _e65 = local_65;
        local_66 = _e65;
    }
    let _e67 = local_66;
    let _e68 = gabor_impl_waves_layer(2i, stone, vec2(_e51.x), _e54.y, _e56.z, seed, _e67);
    return _e68;
}

fn gabor_impl_marble(marble: GaborMarble, cloud: GaborPair, crystal: GaborPair) -> GaborMaterial {
    var clouds: f32;
    var colour_6: vec3<f32>;
    let _e8 = gabor_impl_above(cloud.second, cloud.removed, 0.5f, 0.8f);
    clouds = (marble.cloud_strength * _e8.x);
    let _e14 = clouds;
    let _e21 = gabor_impl_tone(crystal.first.x, crystal.removed, 0.02f);
    let _e22 = gabor_impl_toned((marble.stone_colour * (1f - _e14)), _e21);
    colour_6 = _e22;
    let _e24 = colour_6;
    let _e33 = gabor_impl_material(_e24, (0.00012f * crystal.second), (0.0000000144f * crystal.lost), marble.roughness, 0f);
    return _e33;
}

// Adds veins of layer i: lines along the zeros of a noise, drawn only where the other exceeds a threshold, so they have
// ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
fn gabor_impl_add_veins(stone: ptr<function, GaborMaterial>, marble: GaborMarble, i: i32, vein: GaborPair) {
    var local_67: f32;
    var local_68: vec2<f32>;
    var local_69: vec2<f32>;
    var width_7: vec2<f32>;
    var local_70: vec2<f32>;
    var local_71: vec2<f32>;
    var strength: vec2<f32>;
    var local_72: f32;
    var local_73: f32;
    var local_74: f32;
    var open: f32;
    var halo: vec3<f32>;
    var local_75: f32;
    var local_76: f32;
    var local_77: f32;
    var core: vec3<f32>;
    if (i == 4i) {
        local_69 = vec2<f32>(0.25f, 0.035f);
    } else {
        if (i == 5i) {
            local_68 = vec2<f32>(0.35f, 0.05f);
        } else {
            if (i == 6i) {
                local_67 = 0.04f;
            } else {
                local_67 = 0.05f;
            }
            let _e20 = local_67;
            local_68 = vec2<f32>(1f, _e20);
        }
        let _e23 = local_68;
        local_69 = _e23;
    }
    let _e25 = local_69;
    width_7 = _e25;
    if (i == 4i) {
        local_71 = vec2<f32>(0.6f, 0.6f);
    } else {
        if (i == 5i) {
            local_70 = vec2<f32>(0.55f, 0.75f);
        } else {
            local_70 = vec2<f32>(0f, 0.45f);
        }
        let _e42 = local_70;
        local_71 = _e42;
    }
    let _e44 = local_71;
    strength = (marble.vein_strength * _e44);
    if (i == 4i) {
        local_74 = 0.5f;
    } else {
        if (i == 5i) {
            local_73 = -0.4f;
        } else {
            if (i == 6i) {
                local_72 = 0.8f;
            } else {
                local_72 = 1.1f;
            }
            let _e61 = local_72;
            local_73 = _e61;
        }
        let _e63 = local_73;
        local_74 = _e63;
    }
    let _e65 = local_74;
    let _e67 = gabor_impl_above(vein.second, vein.removed, _e65, 0.5f);
    open = _e67.x;
    let _e71 = strength;
    let _e73 = open;
    let _e76 = width_7;
    let _e78 = gabor_impl_line(vein.first, vein.removed, _e76.y);
    strength.y = (_e71.y * (_e73 * _e78.x));
    let _e83 = strength;
    let _e85 = open;
    let _e88 = width_7;
    let _e90 = gabor_impl_line(vein.first, vein.removed, _e88.x);
    let _e93 = strength;
    strength.x = (_e83.x * ((_e85 * _e90.x) - _e93.y));
    halo = mix(marble.stone_colour, marble.vein_colour, vec3(0.65f));
    if (i == 4i) {
        local_77 = 0.9f;
    } else {
        if (i == 5i) {
            local_76 = 1f;
        } else {
            if (i == 6i) {
                local_75 = 0.65f;
            } else {
                local_75 = 0.45f;
            }
            let _e116 = local_75;
            local_76 = _e116;
        }
        let _e118 = local_76;
        local_77 = _e118;
    }
    let _e120 = local_77;
    core = mix(marble.stone_colour, marble.vein_colour, vec3(_e120));
    let _e125 = (*stone);
    let _e127 = strength;
    let _e129 = halo;
    let _e130 = (*stone);
    let _e134 = strength;
    let _e136 = core;
    let _e137 = (*stone);
    (*stone).colour = (_e125.colour + ((_e127.x * (_e129 - _e130.colour)) + (_e134.y * (_e136 - _e137.colour))));
    let _e144 = (*stone);
    (*stone).colour = clamp(_e144.colour, vec3(0f), vec3(1f));
    return;
}

fn gabor_marble_at(p: vec2<f32>, period: vec2<f32>, marble: GaborMarble, seed: u32) -> GaborMaterial {
    var pixel_15: GaborPixel;
    var stone_3: GaborPixel;
    var cloud_1: GaborPair;
    var i_21: i32 = 0i;
    var crystal_1: GaborPair;
    var material: GaborMaterial;
    var j_6: i32 = 4i;
    var layer_8: GaborLayer;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_15 = _e8;
    let _e10 = pixel_15;
    let _e11 = gabor_impl_stone(_e10, marble, seed);
    stone_3 = _e11;
    let _e13 = gabor_impl_no_pair();
    cloud_1 = _e13;
    loop {
        let _e17 = i_21;
        if !((_e17 < 3i)) {
            break;
        }
        let _e24 = cloud_1;
        let _e25 = i_21;
        let _e26 = pixel_15;
        let _e27 = stone_3;
        let _e28 = gabor_impl_marble_layer(_e25, _e26, _e27, seed);
        let _e29 = gabor_impl_plus_octave(_e24, _e28);
        cloud_1 = _e29;
        continuing {
            let _e21 = i_21;
            i_21 = (_e21 + 1i);
        }
    }
    let _e31 = pixel_15;
    let _e32 = stone_3;
    let _e33 = gabor_impl_marble_layer(3i, _e31, _e32, seed);
    let _e34 = gabor_impl_spots_pair(_e33);
    crystal_1 = _e34;
    let _e36 = cloud_1;
    let _e37 = crystal_1;
    let _e38 = gabor_impl_marble(marble, _e36, _e37);
    material = _e38;
    loop {
        let _e42 = j_6;
        if !((_e42 < 8i)) {
            break;
        }
        {
            let _e49 = j_6;
            let _e50 = pixel_15;
            let _e51 = stone_3;
            let _e52 = gabor_impl_marble_layer(_e49, _e50, _e51, seed);
            layer_8 = _e52;
            let _e55 = j_6;
            let _e56 = layer_8;
            let _e57 = gabor_impl_waves_pair(_e56);
            gabor_impl_add_veins((&material), marble, _e55, _e57);
        }
        continuing {
            let _e46 = j_6;
            j_6 = (_e46 + 1i);
        }
    }
    let _e59 = material;
    return _e59;
}

// ---- Sand ----------------------------------------------------------------------------------------------------------

fn gabor_impl_dune(pixel: GaborPixel, seed: u32) -> GaborPixel {
    var dune: GaborPixel;
    let _e7 = gabor_impl_warp(pixel, vec2(0.8f), vec2(0.15f), seed, 0i);
    dune = _e7;
    let _e9 = dune;
    let _e15 = gabor_impl_warp(_e9, vec2(3f), vec2(0.02f), seed, 1i);
    return _e15;
}

// Three octaves of large shapes, grains, and ripples.
fn gabor_impl_sand_layer(i: i32, pixel: GaborPixel, dune: GaborPixel, sand: GaborSand, seed: u32) -> GaborLayer {
    if (i < 3i) {
        let _e12 = gabor_derived_seed(seed, 4i);
        let _e13 = gabor_impl_octave(pixel, vec2(0.6f), i, 3i, 0.5f, _e12);
        return _e13;
    }
    if (i == 3i) {
        let _e20 = gabor_impl_spots_layer(1i, pixel, vec2(75f), seed, 3i);
        return _e20;
    }
    let _e37 = gabor_impl_waves_layer(2i, dune, (vec2<f32>(0.23255815f, 0.43927652f) * sand.ripples), 2.3f, 1.4f, seed, 2i);
    return _e37;
}

fn gabor_impl_sand(sand: GaborSand, ripples: GaborLayer, of_: GaborPairs) -> GaborMaterial {
    var z_1: vec2<f32>;
    var power_7: f32;
    var whole_3: f32;
    var span_3: f32;
    var change_5: vec2<f32>;
    var phase_10: vec3<f32>;
    var ripple: vec3<f32>;
    var tones_2: vec2<f32>;
    var colour_7: vec3<f32>;
    var dark: f32;
    var bright: f32;
    var tall: vec3<f32>;
    var height_6: vec3<f32>;
    var wave_19: vec2<f32>;
    var bent: vec3<f32>;
    var square_6: vec3<f32>;
    var lost_9: vec3<f32>;
    z_1 = vec2<f32>(of_.c.first.x, of_.c.second.x);
    let _e11 = z_1;
    let _e12 = z_1;
    power_7 = max(dot(_e11, _e12), 0.000001f);
    let _e17 = power_7;
    whole_3 = (_e17 + (2.5f * of_.c.removed));
    let _e25 = power_7;
    let _e26 = whole_3;
    span_3 = (0.9f * sqrt((_e25 / _e26)));
    let _e31 = z_1;
    let _e37 = z_1;
    change_5 = ((_e31.x * of_.c.first.yz) + (_e37.y * of_.c.second.yz));
    let _e45 = z_1;
    let _e47 = gabor_turns_intensity(_e45.yx);
    let _e50 = power_7;
    let _e52 = z_1;
    let _e58 = z_1;
    let _e65 = ((0.15915494f / _e50) * ((_e52.x * of_.c.second.yz) - (_e58.y * of_.c.first.yz)));
    phase_10 = vec3<f32>(_e47.x, _e65.x, _e65.y);
    let _e70 = phase_10;
    let _e71 = span_3;
    let _e74 = power_7;
    let _e77 = whole_3;
    let _e80 = change_5;
    let _e81 = (((1f / _e74) - (1f / _e77)) * _e80);
    let _e86 = gabor_impl_rise(_e70, (_e71 * vec3<f32>(1f, _e81.x, _e81.y)));
    ripple = _e86;
    let _e94 = gabor_impl_tone(of_.b.first.x, of_.b.removed, sand.grain_contrast);
    let _e101 = gabor_impl_tone(of_.a.second.x, of_.a.removed, 0.06f);
    tones_2 = (_e94 + _e101);
    let _e105 = tones_2;
    let _e106 = gabor_impl_toned(sand.trough_colour, _e105);
    let _e108 = tones_2;
    let _e109 = gabor_impl_toned(sand.crest_colour, _e108);
    let _e110 = ripple;
    colour_7 = mix(_e106, _e109, vec3(_e110.x));
    let _e121 = gabor_impl_above(of_.b.second, of_.b.removed, 1.9f, 0.15f);
    dark = _e121.x;
    let _e131 = gabor_impl_above(-(of_.b.second), of_.b.removed, 1.9f, 0.15f);
    bright = _e131.x;
    let _e134 = colour_7;
    let _e141 = dark;
    colour_7 = mix(_e134, (0.23f * sand.trough_colour), vec3(((3.75f * sand.grain_contrast) * _e141)));
    let _e145 = colour_7;
    let _e155 = bright;
    colour_7 = mix(_e145, mix(sand.crest_colour, vec3(1f), vec3(0.6f)), vec3(((3f * sand.grain_contrast) * _e155)));
    tall = (vec3<f32>(sand.ripple_height, 0f, 0f) + ((0.2f * sand.ripple_height) * of_.a.first));
    let _e171 = ripple;
    let _e172 = tall;
    let _e173 = gabor_impl_times(_e171, _e172);
    height_6 = ((_e173 + (0.03f * of_.a.first)) + ((0.00875f * sand.grain_contrast) * of_.b.first));
    wave_19 = (ripples.density * ripples.wave);
    let _e191 = wave_19;
    let _e195 = wave_19;
    wave_19 = vec2<f32>(dot(_e191, ripples.at.x), dot(_e195, ripples.at.y));
    let _e204 = ((0.4f * ripples.density) * ripples.density);
    bent = vec3<f32>(_e204.x, _e204.y, 0f);
    let _e210 = wave_19;
    let _e211 = gabor_impl_square(_e210);
    let _e212 = bent;
    let _e217 = gabor_impl_turned_square(_e212, ripples.at.x, ripples.at.y);
    square_6 = (_e211 + _e217);
    let _e220 = tall;
    let _e222 = tall;
    let _e225 = phase_10;
    let _e227 = span_3;
    let _e229 = gabor_impl_rise_lost(_e225.x, _e227, 0.9f);
    let _e231 = square_6;
    lost_9 = (((((_e220.x * _e222.x) * _e229) * _e231) + (0.0009f * of_.a.lost)) + (((0.0000765625f * sand.grain_contrast) * sand.grain_contrast) * of_.b.lost));
    let _e248 = colour_7;
    let _e249 = height_6;
    let _e250 = lost_9;
    let _e253 = gabor_impl_material(_e248, _e249, _e250, sand.roughness, 0f);
    return _e253;
}

fn gabor_sand_at(p: vec2<f32>, period: vec2<f32>, sand: GaborSand, seed: u32) -> GaborMaterial {
    var pixel_18: GaborPixel;
    var dune_2: GaborPixel;
    var ripples_1: GaborLayer;
    var of_9: GaborPairs;
    var i_23: i32 = 0i;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_18 = _e8;
    let _e10 = pixel_18;
    let _e11 = gabor_impl_dune(_e10, seed);
    dune_2 = _e11;
    let _e14 = pixel_18;
    let _e15 = dune_2;
    let _e16 = gabor_impl_sand_layer(4i, _e14, _e15, sand, seed);
    ripples_1 = _e16;
    let _e18 = gabor_impl_no_pairs();
    of_9 = _e18;
    loop {
        let _e22 = i_23;
        if !((_e22 < 3i)) {
            break;
        }
        let _e30 = of_9;
        let _e32 = i_23;
        let _e33 = pixel_18;
        let _e34 = dune_2;
        let _e35 = gabor_impl_sand_layer(_e32, _e33, _e34, sand, seed);
        let _e36 = gabor_impl_plus_octave(_e30.a, _e35);
        of_9.a = _e36;
        continuing {
            let _e26 = i_23;
            i_23 = (_e26 + 1i);
        }
    }
    let _e39 = pixel_18;
    let _e40 = dune_2;
    let _e41 = gabor_impl_sand_layer(3i, _e39, _e40, sand, seed);
    let _e42 = gabor_impl_spots_pair(_e41);
    of_9.b = _e42;
    let _e44 = ripples_1;
    let _e45 = gabor_impl_waves_pair(_e44);
    of_9.c = _e45;
    let _e46 = ripples_1;
    let _e47 = of_9;
    let _e48 = gabor_impl_sand(sand, _e46, _e47);
    return _e48;
}

// ---- Brushed metal -------------------------------------------------------------------------------------------------

// Five sizes of streaks, and six octaves of patina.
fn gabor_impl_metal_layer(i: i32, pixel: GaborPixel, metal: GaborBrushedMetal, seed: u32) -> GaborLayer {
    var density_7: vec2<f32>;
    if (i >= 5i) {
        let _e13 = gabor_derived_seed(seed, 5i);
        let _e14 = gabor_impl_octave(pixel, vec2(1.3f), (i - 5i), 6i, 0.75f, _e13);
        return _e14;
    }
    density_7 = vec2<f32>((0.3f + (0.12f * exp2(f32(i)))), (metal.streaks * exp2(f32(i))));
    let _e28 = density_7;
    let _e29 = gabor_impl_spots_layer(0i, pixel, _e28, seed, i);
    return _e29;
}

// The layers that the metal needs.
fn gabor_impl_metal_layers(metal: GaborBrushedMetal) -> i32 {
    var local_78: i32;
    if (metal.patina_amount > 0f) {
        local_78 = 11i;
    } else {
        local_78 = 5i;
    }
    let _e7 = local_78;
    return _e7;
}

// Adds a layer: of the streaks, the first sum is the height, the second the tone.
fn gabor_impl_add_metal(of_: ptr<function, GaborPairs>, i: i32, layer: GaborLayer, pair: GaborPair) {
    var size_2: f32;
    if (i >= 5i) {
        {
            let _e7 = (*of_);
            let _e10 = gabor_impl_plus(_e7.b, pair, layer.amplitude);
            (*of_).b = _e10;
            return;
        }
    }
    size_2 = exp2(-(f32(i)));
    let _e17 = (*of_);
    let _e20 = size_2;
    (*of_).a.first = (_e17.a.first + (_e20 * pair.first));
    let _e26 = (*of_);
    (*of_).a.second = (_e26.a.second + (0.4472136f * pair.second));
    let _e35 = (*of_);
    (*of_).a.removed = (_e35.a.removed + (0.2f * pair.removed));
    let _e44 = (*of_);
    let _e47 = size_2;
    let _e48 = size_2;
    (*of_).a.lost = (_e44.a.lost + ((_e47 * _e48) * pair.lost));
    return;
}

fn gabor_impl_brushed_metal(metal: GaborBrushedMetal, of_: GaborPairs) -> GaborMaterial {
    var colour_8: vec3<f32>;
    var height_7: vec3<f32>;
    var lost_10: vec3<f32>;
    var threshold_2: f32;
    var cover: vec3<f32>;
    var patina: vec3<f32>;
    let _e9 = gabor_impl_tone(of_.a.second.x, of_.a.removed, metal.streak_contrast);
    let _e10 = gabor_impl_toned(metal.metal_colour, _e9);
    colour_8 = _e10;
    height_7 = (metal.streak_height * of_.a.first);
    lost_10 = ((metal.streak_height * metal.streak_height) * of_.a.lost);
    if (metal.patina_amount <= 0f) {
        let _e27 = colour_8;
        let _e28 = height_7;
        let _e29 = lost_10;
        let _e32 = gabor_impl_material(_e27, _e28, _e29, metal.roughness, 1f);
        return _e32;
    }
    threshold_2 = (2.4f - (3.8f * metal.patina_amount));
    let _e43 = threshold_2;
    let _e45 = gabor_impl_above(of_.b.second, of_.b.removed, _e43, 0.3f);
    cover = _e45;
    let _e54 = gabor_impl_tone(of_.b.first.x, of_.b.removed, 0.3f);
    let _e55 = gabor_impl_toned(metal.patina_colour, _e54);
    patina = _e55;
    let _e57 = height_7;
    let _e59 = cover;
    height_7 = (_e57 + ((0.003f * _e59) + (0.001f * of_.b.first)));
    let _e67 = lost_10;
    let _e75 = threshold_2;
    let _e77 = gabor_impl_above_lost(of_.b.second, of_.b.removed, of_.b.lost, _e75, 0.3f);
    lost_10 = (_e67 + ((0.000009f * _e77) + (0.000001f * of_.b.lost)));
    let _e85 = colour_8;
    let _e86 = patina;
    let _e87 = cover;
    let _e91 = height_7;
    let _e92 = lost_10;
    let _e95 = cover;
    let _e99 = cover;
    let _e102 = gabor_impl_material(mix(_e85, _e86, vec3(_e87.x)), _e91, _e92, mix(metal.roughness, 0.85f, _e95.x), (1f - _e99.x));
    return _e102;
}

fn gabor_brushed_metal_at(p: vec2<f32>, period: vec2<f32>, metal: GaborBrushedMetal, seed: u32) -> GaborMaterial {
    var pixel_20: GaborPixel;
    var of_12: GaborPairs;
    var layers: i32;
    var i_26: i32 = 0i;
    var layer_10: GaborLayer;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_20 = _e8;
    let _e10 = gabor_impl_no_pairs();
    of_12 = _e10;
    let _e12 = gabor_impl_metal_layers(metal);
    layers = _e12;
    loop {
        let _e16 = i_26;
        let _e17 = layers;
        if !((_e16 < _e17)) {
            break;
        }
        {
            let _e23 = i_26;
            let _e24 = pixel_20;
            let _e25 = gabor_impl_metal_layer(_e23, _e24, metal, seed);
            layer_10 = _e25;
            let _e28 = i_26;
            let _e29 = layer_10;
            let _e30 = layer_10;
            let _e31 = gabor_impl_spots_pair(_e30);
            gabor_impl_add_metal((&of_12), _e28, _e29, _e31);
        }
        continuing {
            let _e20 = i_26;
            i_26 = (_e20 + 1i);
        }
    }
    let _e33 = of_12;
    let _e34 = gabor_impl_brushed_metal(metal, _e33);
    return _e34;
}

// ---- Scratches -----------------------------------------------------------------------------------------------------
//
// Scratches are the peaks of noise with very long and narrow kernels, in many directions.

fn gabor_impl_scratches_layer(i: i32, pixel: GaborPixel, scratches: GaborScratches, seed: u32) -> GaborLayer {
    var angle_1: f32;
    var at_16: GaborPixel;
    var local_79: f32;
    var bend_3: f32;
    angle_1 = (scratches.scratch_direction + (scratches.direction_spread * ((2f * fract((0.0955f + (0.763932f * f32(i))))) - 1f)));
    let _e19 = angle_1;
    let _e20 = gabor_impl_turned(pixel, _e19);
    at_16 = _e20;
    let _e22 = at_16;
    if (_e22.period.y > 0f) {
        let _e29 = at_16;
        local_79 = min(0.17f, (0.02f * _e29.period.y));
    } else {
        local_79 = 0.17f;
    }
    let _e36 = local_79;
    bend_3 = _e36;
    let _e38 = at_16;
    let _e43 = bend_3;
    let _e47 = gabor_impl_warp(_e38, vec2<f32>(0.3f, 0.1f), vec2<f32>(0f, _e43), seed, (2i * i));
    at_16 = _e47;
    let _e49 = at_16;
    let _e64 = gabor_impl_spots_layer(0i, _e49, (vec2<f32>((1f / scratches.scratch_length), 42f) * exp2((0.13f * f32(i)))), seed, ((2i * i) + 1i));
    return _e64;
}

// Adds scratches: the height is in units of their depth, and the colour is the share of whole lacquer.
fn gabor_impl_add_scratches(sum: ptr<function, GaborMaterial>, scratches: GaborScratches, i: i32, noise: GaborPair) {
    var size_3: f32;
    var threshold_3: f32;
    var open_1: vec3<f32>;
    var scratch: vec3<f32>;
    var change_6: f32;
    size_3 = exp2((-0.13f * f32(i)));
    threshold_3 = sqrt((5.76f - (2f * log(scratches.amount))));
    let _e22 = gabor_impl_above(noise.second, noise.removed, 0.3f, 0.7f);
    open_1 = _e22;
    let _e26 = threshold_3;
    let _e28 = gabor_impl_above(noise.first, noise.removed, _e26, 0.2f);
    let _e29 = open_1;
    let _e30 = gabor_impl_times(_e28, _e29);
    scratch = _e30;
    let _e33 = (*sum);
    let _e38 = size_3;
    let _e41 = scratch;
    (*sum).colour = (_e33.colour * (1f - ((0.25f + (0.7f * _e38)) * _e41.x)));
    let _e47 = (*sum);
    let _e49 = size_3;
    let _e50 = scratch;
    (*sum).height = (_e47.height - (_e49 * _e50.x));
    let _e55 = (*sum);
    let _e57 = size_3;
    let _e58 = scratch;
    (*sum).slope = (_e55.slope - (_e57 * _e58.yz));
    let _e70 = gabor_impl_above(vec3<f32>(noise.second.x, 1f, 0f), noise.removed, 0.3f, 0.7f);
    change_6 = _e70.y;
    let _e74 = (*sum);
    let _e77 = size_3;
    let _e79 = size_3;
    let _e81 = open_1;
    let _e83 = open_1;
    let _e86 = change_6;
    let _e87 = change_6;
    let _e96 = threshold_3;
    let _e98 = gabor_impl_above_lost(noise.first, noise.removed, noise.lost, _e96, 0.2f);
    (*sum).lost = (_e74.lost + ((((1.15f * _e77) * _e79) * ((_e81.x * _e83.x) + ((_e86 * _e87) * noise.removed))) * _e98));
    return;
}

fn gabor_impl_scratches(scratches: GaborScratches, sum: GaborMaterial) -> GaborMaterial {
    var height_8: vec3<f32>;
    var lost_11: vec3<f32>;
    height_8 = (scratches.depth * vec3<f32>(sum.height, sum.slope.x, sum.slope.y));
    lost_11 = ((scratches.depth * scratches.depth) * sum.lost);
    let _e20 = height_8;
    let _e21 = lost_11;
    let _e24 = gabor_impl_material(mix(scratches.scratch_colour, scratches.lacquer_colour, sum.colour), _e20, _e21, scratches.roughness, 0f);
    return _e24;
}

fn gabor_scratches_at(p: vec2<f32>, period: vec2<f32>, scratches: GaborScratches, seed: u32) -> GaborMaterial {
    var pixel_22: GaborPixel;
    var sum_24: GaborMaterial = GaborMaterial(vec3(1f), 0f, vec2(0f), 0f, 0f, vec3(0f));
    var i_29: i32 = 0i;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_22 = _e8;
    loop {
        let _e23 = i_29;
        if !((_e23 < 14i)) {
            break;
        }
        let _e31 = i_29;
        let _e32 = i_29;
        let _e33 = pixel_22;
        let _e34 = gabor_impl_scratches_layer(_e32, _e33, scratches, seed);
        let _e35 = gabor_impl_spots_pair(_e34);
        gabor_impl_add_scratches((&sum_24), scratches, _e31, _e35);
        continuing {
            let _e27 = i_29;
            i_29 = (_e27 + 1i);
        }
    }
    let _e37 = sum_24;
    let _e38 = gabor_impl_scratches(scratches, _e37);
    return _e38;
}

// ---- Zebra ---------------------------------------------------------------------------------------------------------

fn gabor_impl_hide(pixel: GaborPixel, seed: u32) -> GaborPixel {
    let _e7 = gabor_impl_warp(pixel, vec2(0.9f), vec2(0.14f), seed, 0i);
    return _e7;
}

fn gabor_impl_stripes_direction(pixel: GaborPixel, zebra: GaborZebra, seed: u32) -> f32 {
    var place_19: GaborPlace;
    let _e5 = gabor_impl_place(pixel, vec2(0.6f));
    place_19 = _e5;
    let _e9 = place_19;
    let _e11 = gabor_derived_seed(seed, 1i);
    let _e12 = gabor_impl_spots(_e9, _e11);
    return (zebra.orientation + (zebra.bend_angle * _e12.quadrature));
}

// Hair, tone and stripes.
fn gabor_impl_zebra_layer(i: i32, pixel: GaborPixel, skin: GaborPixel, direction: f32, zebra: GaborZebra, seed: u32) -> GaborLayer {
    if (i == 0i) {
        let _e10 = gabor_impl_turned(skin, 2.0707963f);
        let _e15 = gabor_impl_spots_layer(0i, _e10, vec2<f32>(6f, 80f), seed, 3i);
        return _e15;
    }
    if (i == 1i) {
        let _e22 = gabor_impl_spots_layer(1i, pixel, vec2(1.2f), seed, 4i);
        return _e22;
    }
    let _e30 = gabor_impl_waves_layer(2i, skin, vec2((zebra.stripes / 1.4f)), 1.4f, direction, seed, 2i);
    return _e30;
}

fn gabor_impl_zebra(zebra: GaborZebra, of_: GaborPairs) -> GaborMaterial {
    var ragged: f32;
    var relief_1: f32;
    var intensity_1: f32;
    var dark_1: f32;
    var tones_3: vec2<f32>;
    var colour_9: vec3<f32>;
    ragged = (0.1f * zebra.hair_contrast);
    relief_1 = (0.002f * zebra.hair_contrast);
    intensity_1 = length(vec2<f32>(of_.c.first.x, of_.c.second.x));
    let _e21 = ragged;
    let _e22 = intensity_1;
    let _e30 = ragged;
    let _e31 = ragged;
    let _e33 = intensity_1;
    let _e35 = intensity_1;
    let _e44 = intensity_1;
    let _e47 = gabor_impl_above((of_.c.first + ((_e21 * _e22) * of_.a.first)), (of_.c.removed + ((((_e30 * _e31) * _e33) * _e35) * of_.a.removed)), 0f, (0.01f + (0.09f * _e44)));
    dark_1 = _e47.x;
    let _e58 = gabor_impl_tone(of_.a.second.x, of_.a.removed, (0.14f * zebra.hair_contrast));
    let _e65 = gabor_impl_tone(of_.b.second.x, of_.b.removed, 0.08f);
    tones_3 = (_e58 + _e65);
    let _e69 = tones_3;
    let _e70 = gabor_impl_toned(zebra.background_colour, _e69);
    let _e72 = tones_3;
    let _e73 = gabor_impl_toned(zebra.stripe_colour, _e72);
    let _e74 = dark_1;
    colour_9 = mix(_e70, _e73, vec3(_e74));
    let _e78 = colour_9;
    let _e79 = relief_1;
    let _e83 = relief_1;
    let _e84 = relief_1;
    let _e91 = gabor_impl_material(_e78, (_e79 * of_.a.first), ((_e83 * _e84) * of_.a.lost), zebra.roughness, 0f);
    return _e91;
}

fn gabor_zebra_at(p: vec2<f32>, period: vec2<f32>, zebra: GaborZebra, seed: u32) -> GaborMaterial {
    var pixel_26: GaborPixel;
    var skin_5: GaborPixel;
    var direction_2: f32;
    var of_14: GaborPairs;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_26 = _e8;
    let _e10 = pixel_26;
    let _e11 = gabor_impl_hide(_e10, seed);
    skin_5 = _e11;
    let _e13 = pixel_26;
    let _e14 = gabor_impl_stripes_direction(_e13, zebra, seed);
    direction_2 = _e14;
    let _e16 = gabor_impl_no_pairs();
    of_14 = _e16;
    let _e20 = pixel_26;
    let _e21 = skin_5;
    let _e22 = direction_2;
    let _e23 = gabor_impl_zebra_layer(0i, _e20, _e21, _e22, zebra, seed);
    let _e24 = gabor_impl_spots_pair(_e23);
    of_14.a = _e24;
    let _e27 = pixel_26;
    let _e28 = skin_5;
    let _e29 = direction_2;
    let _e30 = gabor_impl_zebra_layer(1i, _e27, _e28, _e29, zebra, seed);
    let _e31 = gabor_impl_spots_pair(_e30);
    of_14.b = _e31;
    let _e34 = pixel_26;
    let _e35 = skin_5;
    let _e36 = direction_2;
    let _e37 = gabor_impl_zebra_layer(2i, _e34, _e35, _e36, zebra, seed);
    let _e38 = gabor_impl_waves_pair(_e37);
    of_14.c = _e38;
    let _e39 = of_14;
    let _e40 = gabor_impl_zebra(zebra, _e39);
    return _e40;
}

// ---- Bark ----------------------------------------------------------------------------------------------------------

fn gabor_impl_trunk(pixel: GaborPixel, seed: u32) -> GaborPixel {
    var trunk: GaborPixel;
    let _e9 = gabor_impl_warp(pixel, vec2<f32>(0.8f, 0.35f), vec2<f32>(0.22f, 0.1f), seed, 0i);
    trunk = _e9;
    let _e11 = trunk;
    let _e19 = gabor_impl_warp(_e11, vec2<f32>(3f, 1.6f), vec2<f32>(0.05f, 0.05f), seed, 1i);
    trunk = _e19;
    let _e20 = trunk;
    let _e26 = gabor_impl_warp(_e20, vec2(10f), vec2(0.013f), seed, 2i);
    return _e26;
}

// Five octaves of roughness, moss, furrows, and cracks.
fn gabor_impl_bark_layer(i: i32, pixel: GaborPixel, trunk: GaborPixel, bark: GaborBark, seed: u32) -> GaborLayer {
    var at_17: GaborPixel;
    at_17 = trunk;
    if ((i > 1i) && (i < 6i)) {
        at_17 = pixel;
    }
    if (i < 5i) {
        let _e13 = at_17;
        let _e20 = gabor_derived_seed(seed, 5i);
        let _e21 = gabor_impl_octave(_e13, vec2<f32>(7f, 3.5f), i, 5i, 0.7f, _e20);
        return _e21;
    }
    if (i == 5i) {
        let _e25 = at_17;
        let _e30 = gabor_impl_spots_layer(1i, _e25, vec2<f32>(1.1f, 0.7f), seed, 6i);
        return _e30;
    }
    if (i == 6i) {
        let _e49 = gabor_impl_waves_layer(2i, trunk, (vec2<f32>(0.7692308f, 0.24886878f) * bark.furrows), 1.3f, 0.1f, seed, 3i);
        return _e49;
    }
    let _e57 = gabor_impl_waves_layer(3i, trunk, vec2<f32>(1.2f, 1.3f), 0.9f, 1.5f, seed, 4i);
    return _e57;
}

fn gabor_impl_bark(bark: GaborBark, of_: GaborPairs) -> GaborMaterial {
    var shape: vec3<f32>;
    var removed_7: f32;
    var whole_4: vec3<f32>;
    var risen_1: vec3<f32>;
    var plate: vec3<f32>;
    var weighted: vec3<f32>;
    var worn: f32;
    var covered: f32;
    var tone_1: vec2<f32>;
    var top_1: vec3<f32>;
    var moss: vec3<f32>;
    var colour_10: vec3<f32>;
    var coarse: vec3<f32>;
    var height_9: vec3<f32>;
    var wholes: f32;
    var rises: f32;
    var deep_1: f32;
    var coarses: f32;
    var both: f32;
    var lost_12: vec3<f32>;
    shape = (of_.c.first + (0.2f * of_.a.first));
    removed_7 = (of_.c.removed + (0.04f * of_.a.removed));
    let _e28 = gabor_impl_line(of_.d.first, of_.d.removed, 0.13f);
    whole_4 = (vec3<f32>(1f, 0f, 0f) - (0.55f * _e28));
    let _e32 = shape;
    let _e33 = removed_7;
    let _e37 = gabor_impl_above(_e32, _e33, -0.15f, 0.35f);
    risen_1 = _e37;
    let _e39 = risen_1;
    let _e40 = whole_4;
    let _e41 = gabor_impl_times(_e39, _e40);
    plate = _e41;
    weighted = (of_.a.second + vec3<f32>((0.25f * of_.a.removed), 0f, 0f));
    let _e55 = weighted;
    let _e60 = gabor_impl_above(_e55, of_.a.removed, 0.5f, 0.4f);
    worn = (0.5f * _e60.x);
    let _e71 = gabor_impl_above(of_.b.second, of_.b.removed, 0.9f, 0.5f);
    covered = (bark.moss_amount * _e71.x);
    let _e81 = gabor_impl_tone(of_.a.second.x, of_.a.removed, 0.25f);
    tone_1 = _e81;
    let _e84 = tone_1;
    let _e85 = gabor_impl_toned(bark.plate_colour, _e84);
    let _e92 = tone_1;
    let _e93 = gabor_impl_toned(mix(bark.plate_colour, vec3(1f), vec3(0.13f)), _e92);
    let _e94 = worn;
    top_1 = mix(_e85, _e93, vec3(_e94));
    let _e99 = tone_1;
    let _e100 = gabor_impl_toned(bark.moss_colour, _e99);
    moss = _e100;
    let _e103 = tone_1;
    let _e104 = gabor_impl_toned(bark.furrow_colour, _e103);
    let _e105 = moss;
    let _e106 = covered;
    let _e109 = top_1;
    let _e110 = moss;
    let _e112 = covered;
    let _e116 = plate;
    colour_10 = mix(mix(_e104, _e105, vec3(_e106)), mix(_e109, _e110, vec3((0.6f * _e112))), vec3(_e116.x));
    let _e126 = plate;
    coarse = (vec3<f32>(0.4f, 0f, 0f) + (0.6f * _e126));
    let _e131 = plate;
    let _e136 = coarse;
    let _e137 = gabor_impl_times(of_.a.first, _e136);
    height_9 = ((bark.depth * _e131) + (0.018f * _e137));
    let _e142 = whole_4;
    let _e153 = gabor_impl_line(of_.d.first, of_.d.removed, 0.0919239f);
    wholes = (((2f * _e142.x) - 1f) + (0.3025f * _e153.x));
    let _e158 = risen_1;
    let _e160 = risen_1;
    let _e163 = risen_1;
    let _e166 = risen_1;
    let _e170 = removed_7;
    let _e172 = removed_7;
    rises = ((_e158.x * _e160.x) + (((_e163.x * (1f - _e166.x)) * _e170) / (_e172 + 0.18f)));
    deep_1 = (bark.depth + (0.0108f * of_.a.first.x));
    let _e188 = plate;
    let _e193 = wholes;
    let _e195 = rises;
    coarses = ((0.16f + (0.48f * _e188.x)) + ((0.36f * _e193) * _e195));
    let _e200 = deep_1;
    let _e202 = coarse;
    let _e205 = whole_4;
    let _e208 = shape;
    let _e213 = removed_7;
    let _e217 = gabor_impl_above(vec3<f32>(_e208.x, 1f, 0f), _e213, -0.15f, 0.35f);
    both = ((((0.0072f * _e200) * _e202.x) * _e205.x) * _e217.y);
    let _e221 = deep_1;
    let _e222 = deep_1;
    let _e229 = wholes;
    let _e230 = shape;
    let _e231 = removed_7;
    let _e242 = gabor_impl_above_lost(_e230, _e231, (of_.c.lost + (0.04f * of_.a.lost)), -0.15f, 0.35f);
    let _e245 = rises;
    let _e254 = gabor_impl_line_lost(of_.d.first, of_.d.removed, of_.d.lost, 0.13f);
    let _e259 = coarses;
    let _e261 = both;
    lost_12 = ((((_e221 * _e222) + (0.00011664f * of_.a.removed)) * ((_e229 * _e242) + ((0.3025f * _e245) * _e254))) + (((0.000324f * _e259) + _e261) * of_.a.lost));
    let _e268 = colour_10;
    let _e269 = height_9;
    let _e270 = lost_12;
    let _e273 = gabor_impl_material(_e268, _e269, _e270, bark.roughness, 0f);
    return _e273;
}

fn gabor_bark_at(p: vec2<f32>, period: vec2<f32>, bark: GaborBark, seed: u32) -> GaborMaterial {
    var pixel_29: GaborPixel;
    var trunk_2: GaborPixel;
    var of_16: GaborPairs;
    var i_32: i32 = 0i;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_29 = _e8;
    let _e10 = pixel_29;
    let _e11 = gabor_impl_trunk(_e10, seed);
    trunk_2 = _e11;
    let _e13 = gabor_impl_no_pairs();
    of_16 = _e13;
    loop {
        let _e17 = i_32;
        if !((_e17 < 5i)) {
            break;
        }
        let _e25 = of_16;
        let _e27 = i_32;
        let _e28 = pixel_29;
        let _e29 = trunk_2;
        let _e30 = gabor_impl_bark_layer(_e27, _e28, _e29, bark, seed);
        let _e31 = gabor_impl_plus_octave(_e25.a, _e30);
        of_16.a = _e31;
        continuing {
            let _e21 = i_32;
            i_32 = (_e21 + 1i);
        }
    }
    let _e34 = pixel_29;
    let _e35 = trunk_2;
    let _e36 = gabor_impl_bark_layer(5i, _e34, _e35, bark, seed);
    let _e37 = gabor_impl_spots_pair(_e36);
    of_16.b = _e37;
    let _e40 = pixel_29;
    let _e41 = trunk_2;
    let _e42 = gabor_impl_bark_layer(6i, _e40, _e41, bark, seed);
    let _e43 = gabor_impl_waves_pair(_e42);
    of_16.c = _e43;
    let _e46 = pixel_29;
    let _e47 = trunk_2;
    let _e48 = gabor_impl_bark_layer(7i, _e46, _e47, bark, seed);
    let _e49 = gabor_impl_waves_pair(_e48);
    of_16.d = _e49;
    let _e50 = of_16;
    let _e51 = gabor_impl_bark(bark, _e50);
    return _e51;
}

// ---- Strata --------------------------------------------------------------------------------------------------------

fn gabor_impl_rock(pixel: GaborPixel, strata: GaborStrata, seed: u32) -> GaborPixel {
    var folds: vec4<f32>;
    var rock: GaborPixel;
    folds = (vec4<f32>(0.2f, 0.016f, 0.022f, 0.004f) * strata.folding);
    let _e15 = folds;
    let _e19 = gabor_impl_warp(pixel, vec2<f32>(0.35f, 0.6f), vec2<f32>(0f, _e15.x), seed, 0i);
    rock = _e19;
    let _e21 = rock;
    let _e25 = folds;
    let _e28 = gabor_impl_warp(_e21, vec2<f32>(1.6f, 2.6f), _e25.yz, seed, 1i);
    rock = _e28;
    let _e29 = rock;
    let _e33 = folds;
    let _e37 = gabor_impl_warp(_e29, vec2<f32>(7f, 10f), vec2(_e33.w), seed, 2i);
    return _e37;
}

// Four octaves of grain, and four sizes of layers: broad, band, thin, lamina.
fn gabor_impl_strata_layer(i: i32, pixel: GaborPixel, rock: GaborPixel, strata: GaborStrata, seed: u32) -> GaborLayer {
    var local_80: vec2<f32>;
    var local_81: vec2<f32>;
    var local_82: vec2<f32>;
    var density_8: vec2<f32>;
    if (i < 4i) {
        let _e13 = gabor_derived_seed(seed, 7i);
        let _e14 = gabor_impl_octave(pixel, vec2<f32>(16f, 24f), i, 4i, 0.8f, _e13);
        return _e14;
    }
    if (i == 4i) {
        local_82 = vec2<f32>(0.1f, 0.33333334f);
    } else {
        if (i == 5i) {
            local_81 = vec2<f32>(0.14f, 1f);
        } else {
            if (i == 6i) {
                local_80 = vec2<f32>(0.25f, 2.8333333f);
            } else {
                local_80 = vec2<f32>(0.6f, 8.333333f);
            }
            let _e34 = local_80;
            local_81 = _e34;
        }
        let _e36 = local_81;
        local_82 = _e36;
    }
    let _e38 = local_82;
    density_8 = _e38;
    let _e42 = density_8;
    let _e49 = gabor_impl_spots_layer((i - 3i), rock, (_e42 * vec2<f32>(1f, strata.layers)), seed, (i - 1i));
    return _e49;
}

fn gabor_impl_strata(strata: GaborStrata, of_: GaborPairs) -> GaborMaterial {
    var soft: vec3<f32>;
    var tones_4: vec2<f32>;
    var colour_11: vec3<f32>;
    var height_10: vec3<f32>;
    var lost_13: vec3<f32>;
    let _e8 = gabor_impl_above(of_.c.first, of_.c.removed, 0.5f, 0.22f);
    soft = _e8;
    let _e16 = gabor_impl_tone(of_.e.first.x, of_.e.removed, 0.13f);
    let _e23 = gabor_impl_tone(of_.a.first.x, of_.a.removed, 0.11f);
    tones_4 = (_e16 + _e23);
    let _e27 = tones_4;
    let _e28 = gabor_impl_toned(strata.dark_rock_colour, _e27);
    let _e30 = tones_4;
    let _e31 = gabor_impl_toned(strata.light_rock_colour, _e30);
    let _e38 = gabor_impl_above(of_.b.first, of_.b.removed, 0f, 0.5f);
    colour_11 = mix(_e28, _e31, vec3(_e38.x));
    let _e43 = colour_11;
    let _e45 = tones_4;
    let _e46 = gabor_impl_toned(strata.soft_layer_colour, _e45);
    let _e48 = soft;
    colour_11 = mix(_e43, _e46, vec3((0.8f * _e48.x)));
    let _e53 = colour_11;
    let _e55 = tones_4;
    let _e56 = gabor_impl_toned(strata.thin_layer_colour, _e55);
    let _e64 = gabor_impl_above(of_.d.first, of_.d.removed, 1f, 0.2f);
    colour_11 = mix(_e53, _e56, vec3((0.75f * _e64.x)));
    let _e69 = colour_11;
    let _e73 = tones_4;
    let _e74 = gabor_impl_toned((0.75f * strata.soft_layer_colour), _e73);
    let _e82 = gabor_impl_above(of_.d.second, of_.d.removed, 1.3f, 0.15f);
    colour_11 = mix(_e69, _e74, vec3((0.6f * _e82.x)));
    let _e92 = soft;
    height_10 = (((((0.02f * of_.b.second) - (0.012f * _e92)) + (0.006f * of_.d.first)) + (0.0015f * of_.e.first)) + (0.003f * of_.a.second));
    let _e139 = gabor_impl_above_lost(of_.c.first, of_.c.removed, of_.c.lost, 0.5f, 0.22f);
    lost_13 = (((((0.0004f * of_.b.lost) + (0.000036f * of_.d.lost)) + (0.00000225f * of_.e.lost)) + (0.000009f * of_.a.lost)) + (0.000144f * _e139));
    let _e143 = colour_11;
    let _e145 = height_10;
    let _e150 = lost_13;
    let _e154 = gabor_impl_material(_e143, (strata.relief * _e145), ((strata.relief * strata.relief) * _e150), strata.roughness, 0f);
    return _e154;
}

fn gabor_strata_at(p: vec2<f32>, period: vec2<f32>, strata: GaborStrata, seed: u32) -> GaborMaterial {
    var pixel_32: GaborPixel;
    var rock_2: GaborPixel;
    var of_18: GaborPairs;
    var i_34: i32 = 0i;
    let _e8 = gabor_impl_pixel_at(p, vec2(0f), vec2(0f), period);
    pixel_32 = _e8;
    let _e10 = pixel_32;
    let _e11 = gabor_impl_rock(_e10, strata, seed);
    rock_2 = _e11;
    let _e13 = gabor_impl_no_pairs();
    of_18 = _e13;
    loop {
        let _e17 = i_34;
        if !((_e17 < 4i)) {
            break;
        }
        let _e25 = of_18;
        let _e27 = i_34;
        let _e28 = pixel_32;
        let _e29 = rock_2;
        let _e30 = gabor_impl_strata_layer(_e27, _e28, _e29, strata, seed);
        let _e31 = gabor_impl_plus_octave(_e25.a, _e30);
        of_18.a = _e31;
        continuing {
            let _e21 = i_34;
            i_34 = (_e21 + 1i);
        }
    }
    let _e34 = pixel_32;
    let _e35 = rock_2;
    let _e36 = gabor_impl_strata_layer(4i, _e34, _e35, strata, seed);
    let _e37 = gabor_impl_spots_pair(_e36);
    of_18.b = _e37;
    let _e40 = pixel_32;
    let _e41 = rock_2;
    let _e42 = gabor_impl_strata_layer(5i, _e40, _e41, strata, seed);
    let _e43 = gabor_impl_spots_pair(_e42);
    of_18.c = _e43;
    let _e46 = pixel_32;
    let _e47 = rock_2;
    let _e48 = gabor_impl_strata_layer(6i, _e46, _e47, strata, seed);
    let _e49 = gabor_impl_spots_pair(_e48);
    of_18.d = _e49;
    let _e52 = pixel_32;
    let _e53 = rock_2;
    let _e54 = gabor_impl_strata_layer(7i, _e52, _e53, strata, seed);
    let _e55 = gabor_impl_spots_pair(_e54);
    of_18.e = _e55;
    let _e56 = of_18;
    let _e57 = gabor_impl_strata(strata, _e56);
    return _e57;
}

// ---- The same, filtered --------------------------------------------------------------------------------------------

fn gabor_wood_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, wood: GaborWood, seed: u32) -> GaborMaterial {
    var pixel_33: GaborPixel;
    var board_5: GaborPixel;
    var of_19: GaborPairs;
    var i_35: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_33 = _e6;
    let _e8 = pixel_33;
    let _e9 = gabor_impl_board(_e8, wood, seed);
    board_5 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_19 = _e11;
    loop {
        let _e15 = i_35;
        if !((_e15 < 3i)) {
            break;
        }
        let _e23 = i_35;
        let _e24 = pixel_33;
        let _e25 = board_5;
        let _e26 = gabor_impl_wood_layer(_e23, _e24, _e25, seed);
        gabor_impl_add_filtered_spots((&of_19), _e26);
        continuing {
            let _e19 = i_35;
            i_35 = (_e19 + 1i);
        }
    }
    let _e28 = board_5;
    let _e29 = of_19;
    let _e30 = gabor_impl_wood(_e28, wood, _e29, seed);
    return _e30;
}

fn gabor_fabric_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, fabric: GaborFabric, seed: u32) -> GaborMaterial {
    var pixel_34: GaborPixel;
    var cloth_6: GaborPixel;
    var count_11: vec2<f32>;
    var of_20: GaborPairs;
    var i_36: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_34 = _e6;
    let _e8 = pixel_34;
    let _e9 = gabor_impl_cloth(_e8, fabric, seed);
    cloth_6 = _e9;
    let _e11 = pixel_34;
    let _e12 = gabor_impl_threads(_e11, fabric);
    count_11 = _e12;
    let _e14 = gabor_impl_no_pairs();
    of_20 = _e14;
    loop {
        let _e18 = i_36;
        if !((_e18 < 4i)) {
            break;
        }
        let _e26 = i_36;
        let _e27 = cloth_6;
        let _e28 = count_11;
        let _e29 = gabor_impl_fabric_layer(_e26, _e27, _e28, seed);
        gabor_impl_add_filtered_spots((&of_20), _e29);
        continuing {
            let _e22 = i_36;
            i_36 = (_e22 + 1i);
        }
    }
    let _e31 = cloth_6;
    let _e32 = count_11;
    let _e33 = of_20;
    let _e34 = gabor_impl_fabric(_e31, _e32, fabric, _e33);
    return _e34;
}

fn gabor_carbon_fibre_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, fibres: GaborCarbonFibre, seed: u32) -> GaborMaterial {
    var pixel_35: GaborPixel;
    var cloth_7: GaborPixel;
    var count_12: vec2<f32>;
    var of_21: GaborPairs;
    var i_37: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_35 = _e6;
    let _e8 = pixel_35;
    let _e9 = gabor_impl_twill(_e8, seed);
    cloth_7 = _e9;
    let _e11 = pixel_35;
    let _e14 = gabor_impl_repeated(_e11, fibres.tows, 4f);
    count_12 = _e14;
    let _e16 = gabor_impl_no_pairs();
    of_21 = _e16;
    loop {
        let _e20 = i_37;
        if !((_e20 < 2i)) {
            break;
        }
        let _e28 = i_37;
        let _e29 = cloth_7;
        let _e30 = count_12;
        let _e31 = gabor_impl_tow_layer(_e28, _e29, _e30, seed);
        gabor_impl_add_filtered_spots((&of_21), _e31);
        continuing {
            let _e24 = i_37;
            i_37 = (_e24 + 1i);
        }
    }
    let _e33 = cloth_7;
    let _e34 = count_12;
    let _e35 = of_21;
    let _e36 = gabor_impl_carbon_fibre(_e33, _e34, fibres, _e35);
    return _e36;
}

fn gabor_leather_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, leather: GaborLeather, seed: u32) -> GaborMaterial {
    var pixel_36: GaborPixel;
    var skin_6: GaborPixel;
    var of_22: GaborPairs;
    var i_38: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_36 = _e6;
    let _e8 = pixel_36;
    let _e9 = gabor_impl_skin(_e8, leather, seed);
    skin_6 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_22 = _e11;
    loop {
        let _e15 = i_38;
        if !((_e15 < 4i)) {
            break;
        }
        let _e23 = i_38;
        let _e24 = pixel_36;
        let _e25 = skin_6;
        let _e26 = gabor_impl_leather_layer(_e23, _e24, _e25, leather, seed);
        gabor_impl_add_filtered_spots((&of_22), _e26);
        continuing {
            let _e19 = i_38;
            i_38 = (_e19 + 1i);
        }
    }
    let _e30 = pixel_36;
    let _e31 = skin_6;
    let _e32 = gabor_impl_leather_layer(4i, _e30, _e31, leather, seed);
    let _e33 = gabor_impl_waves_pair(_e32);
    of_22.c = _e33;
    let _e36 = pixel_36;
    let _e37 = skin_6;
    let _e38 = gabor_impl_leather_layer(5i, _e36, _e37, leather, seed);
    let _e39 = gabor_impl_waves_pair(_e38);
    of_22.d = _e39;
    let _e40 = pixel_36;
    let _e41 = skin_6;
    let _e42 = of_22;
    let _e43 = gabor_impl_leather(_e40, _e41, leather, _e42);
    return _e43;
}

fn gabor_marble_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, marble: GaborMarble, seed: u32) -> GaborMaterial {
    var pixel_37: GaborPixel;
    var stone_4: GaborPixel;
    var of_23: GaborPairs;
    var i_39: i32 = 0i;
    var material_1: GaborMaterial;
    var j_7: i32 = 4i;
    var layer_11: GaborLayer;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_37 = _e6;
    let _e8 = pixel_37;
    let _e9 = gabor_impl_stone(_e8, marble, seed);
    stone_4 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_23 = _e11;
    loop {
        let _e15 = i_39;
        if !((_e15 < 4i)) {
            break;
        }
        let _e23 = i_39;
        let _e24 = pixel_37;
        let _e25 = stone_4;
        let _e26 = gabor_impl_marble_layer(_e23, _e24, _e25, seed);
        gabor_impl_add_filtered_spots((&of_23), _e26);
        continuing {
            let _e19 = i_39;
            i_39 = (_e19 + 1i);
        }
    }
    let _e28 = of_23;
    let _e30 = of_23;
    let _e32 = gabor_impl_marble(marble, _e28.a, _e30.b);
    material_1 = _e32;
    loop {
        let _e36 = j_7;
        if !((_e36 < 8i)) {
            break;
        }
        {
            let _e43 = j_7;
            let _e44 = pixel_37;
            let _e45 = stone_4;
            let _e46 = gabor_impl_marble_layer(_e43, _e44, _e45, seed);
            layer_11 = _e46;
            let _e49 = j_7;
            let _e50 = layer_11;
            let _e51 = gabor_impl_filtered_waves(_e50);
            gabor_impl_add_veins((&material_1), marble, _e49, _e51);
        }
        continuing {
            let _e40 = j_7;
            j_7 = (_e40 + 1i);
        }
    }
    let _e53 = material_1;
    return _e53;
}

fn gabor_sand_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, sand: GaborSand, seed: u32) -> GaborMaterial {
    var pixel_38: GaborPixel;
    var dune_3: GaborPixel;
    var of_24: GaborPairs;
    var i_40: i32 = 0i;
    var ripples_2: GaborLayer;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_38 = _e6;
    let _e8 = pixel_38;
    let _e9 = gabor_impl_dune(_e8, seed);
    dune_3 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_24 = _e11;
    loop {
        let _e15 = i_40;
        if !((_e15 < 4i)) {
            break;
        }
        let _e23 = i_40;
        let _e24 = pixel_38;
        let _e25 = dune_3;
        let _e26 = gabor_impl_sand_layer(_e23, _e24, _e25, sand, seed);
        gabor_impl_add_filtered_spots((&of_24), _e26);
        continuing {
            let _e19 = i_40;
            i_40 = (_e19 + 1i);
        }
    }
    let _e29 = pixel_38;
    let _e30 = dune_3;
    let _e31 = gabor_impl_sand_layer(4i, _e29, _e30, sand, seed);
    ripples_2 = _e31;
    let _e34 = ripples_2;
    let _e35 = gabor_impl_filtered_waves(_e34);
    of_24.c = _e35;
    let _e36 = ripples_2;
    let _e37 = of_24;
    let _e38 = gabor_impl_sand(sand, _e36, _e37);
    return _e38;
}

fn gabor_brushed_metal_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, metal: GaborBrushedMetal, seed: u32) -> GaborMaterial {
    var pixel_39: GaborPixel;
    var of_25: GaborPairs;
    var layers_1: i32;
    var i_41: i32 = 0i;
    var layer_12: GaborLayer;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_39 = _e6;
    let _e8 = gabor_impl_no_pairs();
    of_25 = _e8;
    let _e10 = gabor_impl_metal_layers(metal);
    layers_1 = _e10;
    loop {
        let _e14 = i_41;
        let _e15 = layers_1;
        if !((_e14 < _e15)) {
            break;
        }
        {
            let _e21 = i_41;
            let _e22 = pixel_39;
            let _e23 = gabor_impl_metal_layer(_e21, _e22, metal, seed);
            layer_12 = _e23;
            let _e26 = i_41;
            let _e27 = layer_12;
            let _e28 = layer_12;
            let _e29 = gabor_impl_filtered_spots(_e28);
            gabor_impl_add_metal((&of_25), _e26, _e27, _e29);
        }
        continuing {
            let _e18 = i_41;
            i_41 = (_e18 + 1i);
        }
    }
    let _e31 = of_25;
    let _e32 = gabor_impl_brushed_metal(metal, _e31);
    return _e32;
}

fn gabor_scratches_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, scratches: GaborScratches, seed: u32) -> GaborMaterial {
    var pixel_40: GaborPixel;
    var sum_25: GaborMaterial = GaborMaterial(vec3(1f), 0f, vec2(0f), 0f, 0f, vec3(0f));
    var i_42: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_40 = _e6;
    loop {
        let _e21 = i_42;
        if !((_e21 < 14i)) {
            break;
        }
        let _e29 = i_42;
        let _e30 = i_42;
        let _e31 = pixel_40;
        let _e32 = gabor_impl_scratches_layer(_e30, _e31, scratches, seed);
        let _e33 = gabor_impl_filtered_spots(_e32);
        gabor_impl_add_scratches((&sum_25), scratches, _e29, _e33);
        continuing {
            let _e25 = i_42;
            i_42 = (_e25 + 1i);
        }
    }
    let _e35 = sum_25;
    let _e36 = gabor_impl_scratches(scratches, _e35);
    return _e36;
}

fn gabor_zebra_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, zebra: GaborZebra, seed: u32) -> GaborMaterial {
    var pixel_41: GaborPixel;
    var skin_7: GaborPixel;
    var direction_3: f32;
    var of_26: GaborPairs;
    var i_43: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_41 = _e6;
    let _e8 = pixel_41;
    let _e9 = gabor_impl_hide(_e8, seed);
    skin_7 = _e9;
    let _e11 = pixel_41;
    let _e12 = gabor_impl_stripes_direction(_e11, zebra, seed);
    direction_3 = _e12;
    let _e14 = gabor_impl_no_pairs();
    of_26 = _e14;
    loop {
        let _e18 = i_43;
        if !((_e18 < 2i)) {
            break;
        }
        let _e26 = i_43;
        let _e27 = pixel_41;
        let _e28 = skin_7;
        let _e29 = direction_3;
        let _e30 = gabor_impl_zebra_layer(_e26, _e27, _e28, _e29, zebra, seed);
        gabor_impl_add_filtered_spots((&of_26), _e30);
        continuing {
            let _e22 = i_43;
            i_43 = (_e22 + 1i);
        }
    }
    let _e34 = pixel_41;
    let _e35 = skin_7;
    let _e36 = direction_3;
    let _e37 = gabor_impl_zebra_layer(2i, _e34, _e35, _e36, zebra, seed);
    let _e38 = gabor_impl_filtered_waves(_e37);
    of_26.c = _e38;
    let _e39 = of_26;
    let _e40 = gabor_impl_zebra(zebra, _e39);
    return _e40;
}

fn gabor_bark_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, bark: GaborBark, seed: u32) -> GaborMaterial {
    var pixel_42: GaborPixel;
    var trunk_3: GaborPixel;
    var of_27: GaborPairs;
    var i_44: i32 = 0i;
    var j_8: i32 = 6i;
    var pair_4: GaborPair;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_42 = _e6;
    let _e8 = pixel_42;
    let _e9 = gabor_impl_trunk(_e8, seed);
    trunk_3 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_27 = _e11;
    loop {
        let _e15 = i_44;
        if !((_e15 < 6i)) {
            break;
        }
        let _e23 = i_44;
        let _e24 = pixel_42;
        let _e25 = trunk_3;
        let _e26 = gabor_impl_bark_layer(_e23, _e24, _e25, bark, seed);
        gabor_impl_add_filtered_spots((&of_27), _e26);
        continuing {
            let _e19 = i_44;
            i_44 = (_e19 + 1i);
        }
    }
    loop {
        let _e30 = j_8;
        if !((_e30 < 8i)) {
            break;
        }
        {
            let _e37 = j_8;
            let _e38 = pixel_42;
            let _e39 = trunk_3;
            let _e40 = gabor_impl_bark_layer(_e37, _e38, _e39, bark, seed);
            let _e41 = gabor_impl_filtered_waves(_e40);
            pair_4 = _e41;
            let _e43 = j_8;
            if (_e43 == 6i) {
                let _e47 = pair_4;
                of_27.c = _e47;
            } else {
                let _e49 = pair_4;
                of_27.d = _e49;
            }
        }
        continuing {
            let _e34 = j_8;
            j_8 = (_e34 + 1i);
        }
    }
    let _e50 = of_27;
    let _e51 = gabor_impl_bark(bark, _e50);
    return _e51;
}

fn gabor_strata_filtered_at(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, period: vec2<f32>, strata: GaborStrata, seed: u32) -> GaborMaterial {
    var pixel_43: GaborPixel;
    var rock_3: GaborPixel;
    var of_28: GaborPairs;
    var i_45: i32 = 0i;
    let _e6 = gabor_impl_pixel_at(p, dx, dy, period);
    pixel_43 = _e6;
    let _e8 = pixel_43;
    let _e9 = gabor_impl_rock(_e8, strata, seed);
    rock_3 = _e9;
    let _e11 = gabor_impl_no_pairs();
    of_28 = _e11;
    loop {
        let _e15 = i_45;
        if !((_e15 < 8i)) {
            break;
        }
        let _e23 = i_45;
        let _e24 = pixel_43;
        let _e25 = rock_3;
        let _e26 = gabor_impl_strata_layer(_e23, _e24, _e25, strata, seed);
        gabor_impl_add_filtered_spots((&of_28), _e26);
        continuing {
            let _e19 = i_45;
            i_45 = (_e19 + 1i);
        }
    }
    let _e28 = of_28;
    let _e29 = gabor_impl_strata(strata, _e28);
    return _e29;
}

// ---- Definitions of the other public functions ---------------------------------------------------------------------

fn gabor_roughness(material: GaborMaterial) -> f32 {
    var alpha: f32;
    alpha = (material.roughness * material.roughness);
    let _e5 = alpha;
    let _e6 = alpha;
    return sqrt(sqrt(min(((_e5 * _e6) + (0.5f * (material.lost.x + material.lost.y))), 1f)));
}

fn gabor_wood_default() -> GaborWood {
    return GaborWood(vec3<f32>(0.5f, 0.275f, 0.115f), vec3<f32>(0.2f, 0.078f, 0.027f), 13f, 1f, 0.75f, 0.5f);
}
fn gabor_fabric_default() -> GaborFabric {
    return GaborFabric(vec3<f32>(0.5f, 0.43f, 0.33f), vec3<f32>(0.6f, 0.53f, 0.42f), 12f, 1f, 1f, 0.85f, 0f, 0f);
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
fn gabor_brushed_metal_default() -> GaborBrushedMetal {
    return GaborBrushedMetal(vec3<f32>(0.55f, 0.555f, 0.565f), vec3<f32>(0.14f, 0.33f, 0.27f), 9f, 0.09f, 0.0012f, 0.36f, 0f);
}
fn gabor_scratches_default() -> GaborScratches {
    return GaborScratches(vec3<f32>(0.035f, 0.042f, 0.05f), vec3<f32>(0.6f, 0.61f, 0.62f), 1f, 3f, 1.5707963f, 1.5707964f, 0.0025f, 0.3f);
}
fn gabor_zebra_default() -> GaborZebra {
    return GaborZebra(vec3<f32>(0.7f, 0.64f, 0.54f), vec3<f32>(0.018f, 0.014f, 0.012f), 1.96f, 0.296706f, 0.3490659f, 1f, 0.7f);
}
fn gabor_bark_default() -> GaborBark {
    return GaborBark(vec3<f32>(0.2f, 0.145f, 0.1f), vec3<f32>(0.025f, 0.014f, 0.008f), vec3<f32>(0.1f, 0.13f, 0.045f), 2.21f, 0.35f, 0.08f, 0.9f);
}
fn gabor_carbon_fibre_default() -> GaborCarbonFibre {
    return GaborCarbonFibre(vec3<f32>(0.028f, 0.029f, 0.031f), 4f, 0.3f, 1f, 0.3f);
}
fn gabor_strata_default() -> GaborStrata {
    return GaborStrata(vec3<f32>(0.5f, 0.22f, 0.09f), vec3<f32>(0.6f, 0.35f, 0.18f), vec3<f32>(0.28f, 0.075f, 0.035f), vec3<f32>(0.74f, 0.58f, 0.4f), 6f, 1f, 1f, 0.9f);
}

fn gabor_wood(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_wood_default();
    let _e5 = gabor_wood_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_fabric(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_fabric_default();
    let _e5 = gabor_fabric_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_leather(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_leather_default();
    let _e5 = gabor_leather_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_marble(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_marble_default();
    let _e5 = gabor_marble_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_sand(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_sand_default();
    let _e5 = gabor_sand_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_brushed_metal(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_brushed_metal_default();
    let _e5 = gabor_brushed_metal_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_scratches(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_scratches_default();
    let _e5 = gabor_scratches_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_zebra(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_zebra_default();
    let _e5 = gabor_zebra_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_bark(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_bark_default();
    let _e5 = gabor_bark_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_carbon_fibre(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_carbon_fibre_default();
    let _e5 = gabor_carbon_fibre_at(p, vec2(0f), _e4, seed);
    return _e5;
}
fn gabor_strata(p: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e4 = gabor_strata_default();
    let _e5 = gabor_strata_at(p, vec2(0f), _e4, seed);
    return _e5;
}

fn gabor_wood_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_wood_default();
    let _e7 = gabor_wood_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_fabric_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_fabric_default();
    let _e7 = gabor_fabric_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_leather_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_leather_default();
    let _e7 = gabor_leather_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_marble_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_marble_default();
    let _e7 = gabor_marble_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_sand_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_sand_default();
    let _e7 = gabor_sand_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_brushed_metal_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_brushed_metal_default();
    let _e7 = gabor_brushed_metal_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_scratches_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_scratches_default();
    let _e7 = gabor_scratches_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_zebra_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_zebra_default();
    let _e7 = gabor_zebra_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_bark_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_bark_default();
    let _e7 = gabor_bark_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_carbon_fibre_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_carbon_fibre_default();
    let _e7 = gabor_carbon_fibre_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}
fn gabor_strata_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborMaterial {
    let _e6 = gabor_strata_default();
    let _e7 = gabor_strata_filtered_at(p, dx, dy, vec2(0f), _e6, seed);
    return _e7;
}

