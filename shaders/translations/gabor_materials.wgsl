// Generated from gabor_materials.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl, gabor_fractal.wgsl, gabor_spectrum.wgsl.
//
// gabor_materials.wgsl: eleven materials from Gabor noise.
//
//     let m = gabor_wood(p, 7u);                             // colour, height, slope, roughness, metalness
//     let f = gabor_wood_filtered(p, dpdx(p), dpdy(p), 7u);  // averaged over a pixel
//
//     var oak = gabor_wood_default();                            // your own parameters, which may vary per pixel
//     oak.rings = 20.0;
//     let o = gabor_wood_at(p, vec2f(0.0), oak, 7u);
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
    colour: vec3f,  // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    height: f32,    // height in units of p
    slope: vec2f,   // derivatives of the height along x and y
    roughness: f32, // roughness as in glTF, without what the filter removed
    metalness: f32, // 0 or 1, or between them at the edges of patina
    lost: vec3f,    // covariance of the slopes that the filter removed: xx, yy, xy
}

// fn gabor_roughness(material: GaborMaterial) -> f32
//     The roughness with `lost`, for shading without anisotropy. With alpha = roughness^2 as in GGX, alpha^2 grows by
//     half of the variance of the removed slopes: with this share, GGX reflects a room most nearly as the relief does.

// ---- Materials -----------------------------------------------------------------------------------------------------
//
// Each has a struct of parameters and these functions, here for wood:
//
// fn gabor_wood_default() -> GaborWood
// fn gabor_wood(p: vec2f, seed: u32) -> GaborMaterial
// fn gabor_wood_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial
// fn gabor_wood_at(p: vec2f, period: vec2f, wood: GaborWood, seed: u32) -> GaborMaterial
// fn gabor_wood_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, wood: GaborWood, seed: u32) -> GaborMaterial
//
// The first two take the default parameters. The filtered ones average over a pixel; dx and dy are dpdx(p) and dpdy(p).
// Far away, their slopes and `lost` have 0.8 to 1.25 times the energy of the plain slopes. `period` is in units of p,
// along both axes, or vec2f(0.0) for none: a period holds a whole number of rings or threads, and scratches and hair
// snap to directions that fit it.
//
// Colours are linear, from 0 to 1. Brackets give the number of noises, and the shortest period at which the tiled
// material looks like the untiled one; shorter periods compress its large-scale variation. The grain of wood and bark
// and the streaks of metal follow p: bend p to bend them. Directions may vary from pixel to pixel.

// A board cut beside the pith: growth rings, pores and fibres along y [6 noises; period 3 x 9].
struct GaborWood {
    earlywood_colour: vec3f, // colour of the early wood
    latewood_colour: vec3f,  // colour of the late wood
    rings: f32,              // growth rings per unit, 2 to 60
    waviness: f32,           // how much the rings bend, 0 to 3
    pore_strength: f32,      // strength of the pores, 0 to 1
    roughness: f32,          // roughness of the early wood, 0 to 1
}

// Linen, a plain weave of uneven threads; twill or herringbone; or corduroy, whose cords run along y [5 noises; period
// 3 x 3].
struct GaborFabric {
    warp_colour: vec3f, // colour of the threads along y
    weft_colour: vec3f, // colour of the threads along x
    threads: f32,       // threads per unit, 2 to 60
    unevenness: f32,    // unevenness of the threads' thickness, shade and course, 0 to 2
    relief: f32,        // height of the weave and of the cords, relative to the default, 0 to 3
    roughness: f32,     // 0 to 1
    cords: f32,         // cords per unit, 0 to 20
    weave: f32,         // plain weave 0, twill 1, herringbone 2, 0 to 2
}

// Pebbled grain: wrinkled cells with pores, between creases [8 noises; period 3 x 3].
struct GaborLeather {
    pebble_colour: vec3f, // colour of the cells
    crease_colour: vec3f, // colour between the cells
    cells: f32,           // cells per unit, 2 to 30
    waviness: f32,        // how much the rows of cells bend, 0 to 3
    relief: f32,          // height of the cells, relative to the default, 0 to 3
    roughness: f32,       // roughness of the cells, 0 to 0.7
}

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    stone_colour: vec3f, // colour of the stone
    vein_colour: vec3f,  // colour of the darkest veins
    vein_strength: f32,  // strength of the veins, 0 to 1.3
    turbulence: f32,     // how much the veins bend, 0 to 2
    cloud_strength: f32, // darkening by clouds, 0 to 1
    roughness: f32,      // 0 to 1
}

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    trough_colour: vec3f, // colour of the troughs
    crest_colour: vec3f,  // colour of the crests
    ripples: f32,         // ripples per unit, 1 to 20
    ripple_height: f32,   // height of the ripples, in units, 0 to 0.2
    grain_contrast: f32,  // contrast of the grains, 0 to 0.25
    roughness: f32,       // 0 to 1
}

// Streaks along x, and patina [5 noises, 11 with patina; period 5 x 1].
struct GaborBrushedMetal {
    metal_colour: vec3f,  // colour of the metal
    patina_colour: vec3f, // colour of the patina
    streaks: f32,         // number of the widest streaks per unit, 1 to 50
    streak_contrast: f32, // contrast of the streaks, 0 to 0.5
    streak_height: f32,   // height of the widest streaks, in units, 0 to 0.01
    roughness: f32,       // roughness of the metal, 0 to 1
    patina_amount: f32,   // amount of patina, 0 to 1
}

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    lacquer_colour: vec3f,  // colour of the lacquer
    scratch_colour: vec3f,  // colour in the scratches
    amount: f32,            // number of scratches, relative to the default, 0.01 to 8
    scratch_length: f32,    // length of the scratches, in units, 0.3 to 10
    scratch_direction: f32, // mean direction along the scratches, -6.2832 to 6.2832 radians
    direction_spread: f32,  // half-width of the range of their directions, 0 to 1.5708 radians: pi/2 for all
    depth: f32,             // depth of the scratches, in units, 0 to 0.02
    roughness: f32,         // 0 to 1
}

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    background_colour: vec3f, // colour between the stripes
    stripe_colour: vec3f,     // colour of the stripes
    stripes: f32,             // stripes per unit, 0.5 to 20
    orientation: f32,         // direction across the stripes, as that of a wave vector, -6.2832 to 6.2832 radians
    bend_angle: f32,          // how much the stripes' direction changes, 0 to 1.5708 radians
    hair_contrast: f32,       // contrast of the hair, 0 to 3
    roughness: f32,           // 0 to 1
}

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    plate_colour: vec3f,  // colour of the plates
    furrow_colour: vec3f, // colour of the furrows
    moss_colour: vec3f,   // colour of the moss
    furrows: f32,         // furrows per unit, 0.5 to 10
    moss_amount: f32,     // amount of moss, 0 to 1
    depth: f32,           // depth of the furrows, in units, 0 to 0.4
    roughness: f32,       // 0 to 1
}

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    colour: vec3f,       // colour of the fibres
    tows: f32,           // tows per unit, 1 to 20
    fibre_contrast: f32, // contrast of the fibres, 0 to 0.6
    relief: f32,         // height of the tows, relative to the default, 0 to 3
    roughness: f32,      // 0 to 1
}

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    dark_rock_colour: vec3f,  // colour of the darker rock
    light_rock_colour: vec3f, // colour of the lighter rock
    soft_layer_colour: vec3f, // colour of the soft layers
    thin_layer_colour: vec3f, // colour of the thin layers
    layers: f32,              // layers per unit, 1 to 30
    folding: f32,             // how much the layers bend, 0 to 3
    relief: f32,              // height of the layers, relative to the default, 0 to 3
    roughness: f32,           // 0 to 1
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
// Each material has a function that lists its layers, one that gathers their noises, one that gathers them filtered,
// and one that shades them.

// Computes values with derivatives along x and y of p: (value, d/dx, d/dy).
fn gabor_impl_times(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(a.x * b.x, a.x * b.yz + b.x * a.yz);
}

// The matrix v v^T: xx, yy, xy.
fn gabor_impl_square(v: vec2f) -> vec3f {
    return vec3f(v * v, v.x * v.y);
}

// (x y)^T M (x y), where M has the elements xx, yy, xy.
fn gabor_impl_turned_square(m: vec3f, x: vec2f, y: vec2f) -> vec3f {
    let a = m.xy * x + m.z * x.yx; let b = m.xy * y + m.z * y.yx;
    return vec3f(dot(x, a), dot(y, b), dot(x, b));
}

// ---- Positions -----------------------------------------------------------------------------------------------------

// A position, its derivatives along the plane's x and y, the steps (dx, dy) to the next pixels, which are 0 without a
// filter, and the period, 0 for none. Warps move it and bend the steps. A warp that a filter removed still steepens
// slopes: the gradient of position.x has the mean (by_x.x, by_y.x) and the covariance lost_x, as xx, yy, xy; that of
// position.y has lost_y, and nearly no covariance with the other.
struct GaborImplPixel {
    position: vec2f,
    by_x: vec2f,
    by_y: vec2f,
    filtered: bool,
    dx: vec2f,
    dy: vec2f,
    period: vec2f,
    lost_x: vec3f,
    lost_y: vec3f,
}

fn gabor_impl_pixel_of(filtered: bool, p_in: vec2f, dx_in: vec2f, dy_in: vec2f, period: vec2f) -> GaborImplPixel {
    var p = p_in;
    var dx = dx_in;
    var dy = dy_in;
    p -= select(vec2f(0.0), period * floor(p / period), period.x > 0.0);
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = vec2f(1.0e3, 0.0);
        dy = vec2f(0.0, 1.0e3);
    }
    return GaborImplPixel(p, vec2f(1.0, 0.0), vec2f(0.0, 1.0), filtered, dx, dy, period, vec3f(0.0), vec3f(0.0));
}

fn gabor_impl_point(p: vec2f, period: vec2f) -> GaborImplPixel {
    return gabor_impl_pixel_of(false, p, vec2f(0.0), vec2f(0.0), period);
}

// A position along the warped x or y axis, with derivatives.
fn gabor_impl_along_x(at: GaborImplPixel) -> vec3f {
    return vec3f(at.position.x, at.by_x.x, at.by_y.x);
}
fn gabor_impl_along_y(at: GaborImplPixel) -> vec3f {
    return vec3f(at.position.y, at.by_x.y, at.by_y.y);
}

// The place of a layer with `density` kernel radii per unit along x and y.
fn gabor_impl_place(at: GaborImplPixel, density: vec2f) -> GaborPlace {
    if (at.period.x > 0.0) {
        return gabor_place_tiled(density * at.position, density * at.period);
    }
    return gabor_place_at(density * at.position);
}

// Adds a row of three nodes to two noises, (quadrature, noise), and to their derivatives along x and y.
fn gabor_impl_add_spots(value: ptr<function, vec2f>, slope: ptr<function, vec4f>, x: GaborImplLine, word: u32,
                        even: f32, even_slope: f32) {
    let words = x.word * word;
    let a = gabor_impl_amplitude(words.x); let b = gabor_impl_amplitude(words.y); let c = gabor_impl_amplitude(words.z);
    let row = x.even.x * a + x.even.y * b + x.even.z * c;
    *value += even * row;
    *slope += vec4f(even * (x.even_slope.x * a + x.even_slope.y * b + x.even_slope.z * c), even_slope * row);
}

// Adds a row of four nodes.
fn gabor_impl_add_four_spots(value: ptr<function, vec2f>, slope: ptr<function, vec4f>, x: GaborImplLine, word: u32,
                             even: f32, even_slope: f32) {
    gabor_impl_add_spots(value, slope, x, word, even, even_slope);
    let d = gabor_impl_amplitude(x.word.w * word); let last = x.even.w * d;
    *value += even * last;
    *slope += vec4f(even * x.even_slope.w * d, even_slope * last);
}

fn gabor_impl_spots_field(value: vec2f, slope: vec4f, scale: f32, stretch: vec2f) -> GaborField {
    return GaborField(scale * value.y, stretch * slope.yw, scale * value.x, stretch * slope.xz, 0.0);
}

// Noise of frequency 0, which needs no waves: spots as large as a kernel. The same as gabor_field.
fn gabor_impl_spots(place: GaborPlace, seed: u32) -> GaborField {
    let salt = gabor_impl_salt(seed);
    let x = gabor_impl_smooth_line(place.cell.x, place.local.x, place.period.x, salt);
    let y = gabor_impl_smooth_line(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS);
    var value = vec2f(0.0);
    var slope = vec4f(0.0);
    gabor_impl_add_spots(&value, &slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_spots(&value, &slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_spots(&value, &slope, x, y.word.z, y.even.z, y.even_slope.z);
    let scale = 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// The steps (dx, dy) to the next pixels, in kernel radii of a noise with this density.
fn gabor_impl_radii(at: GaborImplPixel, density: vec2f) -> vec4f {
    return vec4f(density * at.dx, density * at.dy);
}

// Moves the position by two noises. Noises that are finer than the pixel move it only as much as a filter keeps of
// their slopes. They bend dx and dy even less, for two reasons: slopes at one point are not those of the whole pixel,
// and the slopes of a filtered height leave out how the steps change.
fn gabor_impl_warp(at: GaborImplPixel, density: vec2f, amplitude_in: vec2f, seed: u32, index: i32) -> GaborImplPixel {
    var amplitude = amplitude_in;
    let steps = gabor_impl_radii(at, density);
    let size = min(dot(steps, steps), 1.0e6); let bend = 1.0 / (1.0 + 64.0 * size);
    var whole = amplitude * amplitude;
    amplitude /= 1.0 + 0.82246703 * size; // pi^2 / 12
    let field = gabor_impl_spots(gabor_impl_place(at, density), gabor_derived_seed(seed, index));
    let along_x = amplitude * density.x * vec2f(field.quadrature_gradient.x, field.gradient.x);
    let along_y = amplitude * density.y * vec2f(field.quadrature_gradient.y, field.gradient.y);
    var lost_x = vec3f(0.0); var lost_y = vec3f(0.0);
    if (at.filtered) {
        let power = 3.2898681 * density * density; // pi^2 / 3, the noises' mean square gradient
        let lost = power.x * (gabor_impl_square(vec2f(at.by_x.x, at.by_y.x)) + at.lost_x)
                  + power.y * (gabor_impl_square(vec2f(at.by_x.y, at.by_y.y)) + at.lost_y);
        whole -= amplitude * amplitude;
        lost_x = (1.0 + along_x.x) * (1.0 + along_x.x) * at.lost_x + along_y.x * along_y.x * at.lost_y + whole.x * lost;
        lost_y = along_x.y * along_x.y * at.lost_x + (1.0 + along_y.y) * (1.0 + along_y.y) * at.lost_y + whole.y * lost;
    }
    return GaborImplPixel(at.position + amplitude * vec2f(field.quadrature, field.noise),
                          at.by_x + at.by_x.x * along_x + at.by_x.y * along_y,
                          at.by_y + at.by_y.x * along_x + at.by_y.y * along_y, at.filtered,
                          at.dx + bend * (at.dx.x * along_x + at.dx.y * along_y),
                          at.dy + bend * (at.dy.x * along_x + at.dy.y * along_y), at.period, lost_x, lost_y);
}

// The covariance of the slopes in the plane that warps lost of a layer or profile, whose slopes along the warped axes
// have these mean squares.
fn gabor_impl_warp_lost(at: GaborImplPixel, power: vec2f) -> vec3f {
    return power.x * at.lost_x + power.y * at.lost_y;
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
fn gabor_impl_turned(at: GaborImplPixel, angle: f32) -> GaborImplPixel {
    let turn = gabor_impl_wave(0.15915494 * angle); // 1/(2 pi)
    var x = turn;
    var y = vec2f(-turn.y, turn.x);
    var period = vec2f(0.0);
    if (at.period.x > 0.0) {
        var whole = floor(3.0 * normalize(turn / at.period) + 0.5);
        var size = abs(whole);
        let signs = vec2f(select(1.0, -1.0, whole.x < 0.0), select(1.0, -1.0, whole.y < 0.0));
        if (size.x == size.y || size.x * size.y == 0.0) { // (2, 2), (3, 0), (0, 3) become (1, 1), (1, 0), (0, 1)
            whole = signs * min(size, vec2f(1.0));
        }
        size = abs(whole);
        let other = select(select(vec2f(-whole.y, 0.0),
                      vec2f(0.0, whole.x), size.x == 1.0),
                    select(-signs, signs, size.x > size.y), size.x > 1.0 && size.y > 1.0);
        period.x = length(whole * at.period);
        period.y = at.period.x * at.period.y / period.x;
        x = period.x * vec2f(other.y, -other.x) / at.period;
        y = period.y * vec2f(-whole.y, whole.x) / at.period;
    }
    return GaborImplPixel(vec2f(dot(x, at.position), dot(y, at.position)), vec2f(dot(x, at.by_x), dot(y, at.by_x)),
                          vec2f(dot(x, at.by_y), dot(y, at.by_y)), at.filtered,
                          vec2f(dot(x, at.dx), dot(y, at.dx)), vec2f(dot(x, at.dy), dot(y, at.dy)), period,
                          x.x * x.x * at.lost_x + x.y * x.y * at.lost_y, y.x * y.x * at.lost_x + y.y * y.y * at.lost_y);
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
fn gabor_impl_repeated(pixel: GaborImplPixel, count: f32, whole: f32) -> vec2f {
    if (pixel.period.x > 0.0) {
        return max(floor(pixel.period * (count / whole) + 0.5), vec2f(1.0)) * whole / pixel.period;
    }
    return vec2f(count);
}

// What a pixel keeps of a sine along x that repeats `count` times per unit.
fn gabor_impl_sine_kept(at: GaborImplPixel, count: f32) -> f32 {
    return exp(-min(4.9348022 * count * count * (at.dx.x * at.dx.x + at.dy.x * at.dy.x), 40.0)); // pi^2 / 2
}

// ---- Layers --------------------------------------------------------------------------------------------------------

// A noise with `density` kernel radii per unit along x and y, a wave vector per kernel radius, and its amplitude in a
// sum.
struct GaborImplLayer {
    at: GaborImplPixel,
    density: vec2f,
    wave: vec2f,
    amplitude: f32,
    seed: u32,
}

// A layer of frequency 0.
fn gabor_impl_spots_layer(at: GaborImplPixel, density: vec2f, seed: u32, index: i32) -> GaborImplLayer {
    return GaborImplLayer(at, density, vec2f(0.0), 1.0, gabor_derived_seed(seed, index));
}

fn gabor_impl_waves_layer(at: GaborImplPixel, density: vec2f, frequency: f32, orientation: f32, seed: u32, index: i32) -> GaborImplLayer {
    return GaborImplLayer(at, density, gabor_wave_vector(frequency, orientation), 1.0,
                          gabor_derived_seed(seed, index));
}

// Octave i of `count`, each with spots of about half the previous size and `gain` times the amplitude.
fn gabor_impl_octave(at: GaborImplPixel, density: vec2f, i: i32, count: i32, gain: f32, seed: u32) -> GaborImplLayer {
    let power = (1.0 - pow(gain, 2.0 * f32(count))) / (1.0 - gain * gain);
    // 1.0214797 is ln 2.03 / ln 2
    return GaborImplLayer(at, density * exp2(1.0214797 * f32(i)), vec2f(0.0),
                          pow(gain, f32(i)) * inverseSqrt(power), gabor_derived_seed(seed, i));
}

// Two independent noises with their derivatives along x and y of p, the quadrature and noise of a layer's field; the
// share of their variance that a filter removed, and the covariance of their derivatives that it removed.
struct GaborImplPair {
    first: vec3f,
    second: vec3f,
    removed: f32,
    lost: vec3f,
}

// All pairs of noises that one material needs.
struct GaborImplPairs {
    pair_0: GaborImplPair,
    pair_1: GaborImplPair,
    pair_2: GaborImplPair,
    pair_3: GaborImplPair,
    pair_4: GaborImplPair,
}

fn gabor_impl_no_pair() -> GaborImplPair {
    return GaborImplPair(vec3f(0.0), vec3f(0.0), 0.0, vec3f(0.0));
}

fn gabor_impl_no_pairs() -> GaborImplPairs {
    let none = gabor_impl_no_pair();
    return GaborImplPairs(none, none, none, none, none);
}

// `whole` is the covariance of the plain field's gradient, and `left` what is left of it.
fn gabor_impl_pair(layer: GaborImplLayer, field: GaborField, whole: vec3f, left: vec3f) -> GaborImplPair {
    let x = layer.density * layer.at.by_x; let y = layer.density * layer.at.by_y;
    var lost = vec3f(0.0);
    if (layer.at.filtered) {
        lost = gabor_impl_turned_square(whole - left, x, y)
             + gabor_impl_warp_lost(layer.at, layer.density * layer.density * whole.xy);
    }
    return GaborImplPair(vec3f(field.quadrature, dot(field.quadrature_gradient, x), dot(field.quadrature_gradient, y)),
                         vec3f(field.noise, dot(field.gradient, x), dot(field.gradient, y)), field.removed, lost);
}

fn gabor_impl_plus(sum: GaborImplPair, pair: GaborImplPair, amplitude: f32) -> GaborImplPair {
    return GaborImplPair(sum.first + amplitude * pair.first, sum.second + amplitude * pair.second,
                         sum.removed + amplitude * amplitude * pair.removed,
                         sum.lost + amplitude * amplitude * pair.lost);
}

// What a filter does to a layer. Nearly, the window of a node is a Gaussian of variance v = 3/(2 pi^2), and its wave
// exp(2 pi i F.d). A filter of covariance S widens the window to v + S, turns the wave vector F into
// K = (1 + S/v)^-1 F, and leaves the share exp(-6 F.(F - K)) / sqrt(|1 + S/v|) of the variance.
struct GaborImplKept {
    wave: vec2f,
    share: f32,
    widened: vec2f, // S/v along x and y
}

fn gabor_impl_kept(layer: GaborImplLayer) -> GaborImplKept {
    let steps = gabor_impl_radii(layer.at, layer.density);
    let s = 1.6449341 * (gabor_impl_square(steps.xy) + gabor_impl_square(steps.zw)); // pi^2 / 6
    let d = (1.0 + s.x) * (1.0 + s.y) - s.z * s.z;
    let wave = ((1.0 + s.yx) * layer.wave - s.z * layer.wave.yx) / d;
    return GaborImplKept(wave, exp(-6.0 * dot(layer.wave, layer.wave - wave)) * inverseSqrt(d), s.xy);
}

fn gabor_impl_spots_pair(layer: GaborImplLayer) -> GaborImplPair {
    return gabor_impl_pair(layer, gabor_impl_spots(gabor_impl_place(layer.at, layer.density), layer.seed), vec3f(0.0),
                           vec3f(0.0));
}

// A sum and an octave of it.
fn gabor_impl_plus_octave(sum: GaborImplPair, layer: GaborImplLayer) -> GaborImplPair {
    return gabor_impl_plus(sum, gabor_impl_spots_pair(layer), layer.amplitude);
}

fn gabor_impl_waves_pair(layer: GaborImplLayer) -> GaborImplPair {
    return gabor_impl_pair(layer, gabor_field(gabor_impl_place(layer.at, layer.density), layer.wave, layer.seed),
                           vec3f(0.0), vec3f(0.0));
}

// The same, filtered with the windows of gabor_fractal.wgsl.
fn gabor_impl_filtered_spots(layer: GaborImplLayer) -> GaborImplPair {
    let place = gabor_impl_place(layer.at, layer.density);
    let kept = gabor_impl_kept(layer);
    // 0.34195899 is 27/(8 pi^2)
    let inverse_width = vec2f(gabor_impl_inverse_width(0.34195899 * kept.widened.x),
                              gabor_impl_inverse_width(0.34195899 * kept.widened.y));
    let salt = gabor_impl_salt(layer.seed);
    let x = gabor_impl_smooth_line_filtered(place.cell.x, place.local.x, place.period.x, salt, inverse_width.x);
    let y = gabor_impl_smooth_line_filtered(place.cell.y, place.local.y, place.period.y,
                                            salt ^ GABOR_IMPL_ROWS, inverse_width.y);
    // 1.7777778 is 16/9: see gabor_impl_smooth_line_filtered
    let scale = sqrt(1.7777778 * kept.share * inverse_width.x * inverse_width.y) / GABOR_IMPL_DEVIATION;
    var value = vec2f(0.0);
    var slope = vec4f(0.0);
    gabor_impl_add_four_spots(&value, &slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_four_spots(&value, &slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_four_spots(&value, &slope, x, y.word.z, y.even.z, y.even_slope.z);
    gabor_impl_add_four_spots(&value, &slope, x, y.word.w, y.even.w, y.even_slope.w);
    var field = gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius);
    field.removed = 1.0 - kept.share;
    // 3.2898681 is pi^2 / 3 and 7.4022033 is 3/4 pi^2; the plain windows have a half-width of 3/2
    return gabor_impl_pair(layer, field, vec3f(3.2898681, 3.2898681, 0.0),
                           vec3f(7.4022033 * kept.share * inverse_width * inverse_width, 0.0));
}

fn gabor_impl_plus_filtered_octave(sum: GaborImplPair, layer: GaborImplLayer) -> GaborImplPair {
    return gabor_impl_plus(sum, gabor_impl_filtered_spots(layer), layer.amplitude);
}

// Filtered waves have the plain windows: where others would fit better, little is left.
fn gabor_impl_filtered_waves(layer: GaborImplLayer) -> GaborImplPair {
    let kept = gabor_impl_kept(layer);
    var field = GaborField(0.0, vec2f(0.0), 0.0, vec2f(0.0), 0.0);
    gabor_impl_add_field(&field, gabor_field(gabor_impl_place(layer.at, layer.density), kept.wave, layer.seed),
                         sqrt(kept.share), vec2f(1.0));
    field.removed = 1.0 - kept.share;
    // 3.2898681 is pi^2 / 3 and 39.478418 is 4 pi^2
    let spots = vec3f(3.2898681, 3.2898681, 0.0);
    return gabor_impl_pair(layer, field, spots + 39.478418 * gabor_impl_square(layer.wave),
                           kept.share * (spots + 39.478418 * gabor_impl_square(kept.wave)));
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// The normal distribution function, within 2e-5.
fn gabor_impl_below(x_in: f32) -> f32 {
    var x = x_in;
    x = clamp(x, -8.0, 8.0);
    // fit: see tools/constants.py
    return 1.0 / (1.0 + exp2(-x * (2.301726 + x * x * (0.1061787 - 0.00091164 * x * x))));
}

// A soft threshold: the normal distribution function of (noise - threshold) / softness.
fn gabor_impl_above(noise: vec3f, removed: f32, threshold: f32, softness: f32) -> vec3f {
    let scale = inverseSqrt(softness * softness + removed);
    let x = scale * noise.x - scale * threshold;
    return vec3f(gabor_impl_below(x), 0.39894228 * scale * exp(-0.5 * min(x * x, 100.0)) * noise.yz); // 1/sqrt(2 pi)
}

// What the filter removed of a mean square: 0 without a filter, in spite of rounding.
fn gabor_impl_removed_square(square: f32, mean: f32, removed: f32) -> f32 {
    return select(0.0, max(square - mean * mean, 0.0), removed > 0.0);
}

// The variance that the filter removed of the threshold itself, nearly.
fn gabor_impl_above_variance(above: f32, removed: f32, softness: f32) -> f32 {
    return above * (1.0 - above) * removed / (removed + 1.5 * softness * softness);
}

// The covariance of its slopes that the filter removed.
fn gabor_impl_above_lost(noise: vec3f, removed: f32, lost: vec3f, threshold: f32, softness: f32) -> vec3f {
    let scale = inverseSqrt(softness * softness + removed); let variance = 0.5 * softness * softness + removed;
    let d = (noise.x - threshold) * (noise.x - threshold);
    let mean = 0.39894228 * scale * exp(-0.5 * min(d * scale * scale, 100.0)); // 1/sqrt(2 pi)
    // 0.11253954 is 1/(2 pi sqrt(2))
    let square = 0.11253954 / softness * inverseSqrt(variance) * exp(-0.5 * min(d / variance, 100.0));
    return square * lost + gabor_impl_removed_square(square, mean, removed) * gabor_impl_square(noise.yz);
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
fn gabor_impl_line(noise: vec3f, removed: f32, width: f32) -> vec3f {
    let variance = width * width + removed;
    let line = width * inverseSqrt(variance) * exp(-0.5 * min(noise.x * noise.x / variance, 100.0));
    return line * vec3f(1.0, -noise.x / variance * noise.yz);
}

// The covariance of its slopes that the filter removed.
fn gabor_impl_line_lost(noise: vec3f, removed: f32, lost: vec3f, width: f32) -> vec3f {
    let half_square = 0.5 * width * width; let variance = half_square + removed;
    let mean = noise.x * half_square / variance; let spread = half_square * removed / variance;
    let square = sqrt(half_square / variance) * exp(-0.5 * min(noise.x * noise.x / variance, 100.0))
                 * (mean * mean + spread) / (4.0 * half_square * half_square);
    let slope = gabor_impl_line(vec3f(noise.x, 1.0, 0.0), removed, width);
    return square * lost + gabor_impl_removed_square(square, slope.y, removed) * gabor_impl_square(noise.yz);
}

// A factor of mean 1, exp(contrast noise - contrast^2 / 2), as its logarithm and the variance of the logarithm that the
// filter removed. A product of factors is the sum of their vectors.
fn gabor_impl_tone(noise: f32, removed: f32, contrast: f32) -> vec2f {
    return vec2f(contrast * noise - 0.5 * contrast * contrast, contrast * contrast * removed);
}

// The mean of min(colour * tone, 1). If the logarithm of X is normal with mean m and variance r, and P is the normal
// distribution function, the mean of min(c X, 1) is c e^(m + r/2) P(d - sqrt(r)) + 1 - P(d), where d = -(ln c + m) /
// sqrt(r). Where d > 3, this is nearly the mean of c X: if all of a colour is so dark, only its first part gets the
// rest. Materials mix colours after this, so that means remain right.
fn gabor_impl_toned(colour_in: vec3f, tone: vec2f) -> vec3f {
    var colour = colour_in;
    var mean = colour * exp(tone.x + 0.5 * tone.y);
    if (tone.y > 0.0) {
        let s = sqrt(tone.y);
        let parts = select(1, 3, max(max(colour.x, colour.y), colour.z) * exp(tone.x + 3.0 * s) > 1.0); var i = 0;
        loop { // a loop, because drivers for CPUs run both sides of a branch
            let d = (-tone.x - log(max(colour.x, 1.0e-6))) / s;
            mean = vec3f(mean.yz, mean.x * gabor_impl_below(d - s) + 1.0 - gabor_impl_below(d));
            colour = colour.yzx;
            continuing { i++; break if i >= parts; }
        }
        if (parts == 1) { mean = mean.zxy; }
    }
    return min(mean, vec3f(1.0));
}

// The square of a sawtooth that rises from 0 to 1, averaged over the phases that a vector of length `span` stands for:
// see gabor_impl_ends_at. `phase` is in turns.
fn gabor_impl_rise(phase: vec3f, span: vec3f) -> vec3f {
    let ends = gabor_impl_ends_at(phase.x, span.x);
    let turns = floor(ends.xy); let t = ends.xy - turns; let integral = 0.33333333 * (turns + t * t * t); // 1/3
    let mean = ends.z * (integral.y - integral.x); let change = ends.z * (t.y * t.y - t.x * t.x);
    // The change with the width, which is about 0.78 sqrt(1 - span).
    let widen = ends.z * (0.5 * (t.y * t.y + t.x * t.x) - mean) * (-0.5 / (ends.z * max(1.0 - span.x, 0.001)));
    return vec3f(mean, change * phase.yz + widen * span.yz);
}

// The variance of its slope per turn over the phases that the filter added; at a span of `full`, it added none. Where
// the sawtooth rises, over a share 1 - w of the phases, its slope is 2 t; where it falls, over w, it is
// -(1 - w) (1 - w + 2 t) / w, with t from 0 to w.
fn gabor_impl_rise_lost(phase: f32, span: f32, full: f32) -> f32 {
    let ends = gabor_impl_ends_at(phase, span);
    let turns = floor(ends.xy); let t = ends.xy - turns;
    let w = 1.0 / gabor_impl_ends_at(0.0, full).z; let rise = 1.0 - w;
    // 1.3333333 is 4/3 and 0.33333333 is 1/3
    let risen = 1.3333333 - w * (2.0 - w + 0.33333333 * w * w); let fallen = rise * rise * (1.0 / w + 0.33333333 * w);
    let integral = risen * (turns + t * t * t) + fallen * turns;
    let change = ends.z * (t.y * t.y - t.x * t.x);
    return max(ends.z * (integral.y - integral.x) - change * change, 0.0)
         * sqrt(max(1.0 - span * span / (full * full), 0.0)); // an edge loses in proportion to the blur's length
}

// A smoothstep from `low` to `high`.
fn gabor_impl_step(low: f32, high: f32, x: vec3f) -> vec3f {
    let t = clamp((x.x - low) / (high - low), 0.0, 1.0);
    return vec3f(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (high - low) * x.yz);
}

fn gabor_impl_material(colour: vec3f, height: vec3f, lost: vec3f, roughness: f32, metalness: f32) -> GaborMaterial {
    return GaborMaterial(clamp(colour, vec3f(0.0), vec3f(1.0)), height.x, height.yz, roughness, metalness, lost);
}

// ---- Wood ----------------------------------------------------------------------------------------------------------
//
// Rings are lines of constant x that noise of low frequency bends until they close.

fn gabor_impl_board(pixel: GaborImplPixel, wood: GaborWood, seed: u32) -> GaborImplPixel {
    let bends = vec2f(0.43, 0.018) * wood.waviness;
    let board = gabor_impl_warp(pixel, vec2f(1.1, 0.24), vec2f(bends.x, 0.0), seed, 0);
    return gabor_impl_warp(board, vec2f(4.0, 0.9), vec2f(bends.y, 0.0), seed, 1);
}

// Pores, fibres and tone.
fn gabor_impl_wood_layer(i: i32, pixel: GaborImplPixel, board: GaborImplPixel, seed: u32) -> GaborImplLayer {
    if (i == 2) { return gabor_impl_spots_layer(board, vec2f(3.5, 0.35), seed, 5); }
    return gabor_impl_spots_layer(pixel, select(vec2f(150.0, 2.0), vec2f(90.0, 4.5), i == 0), seed, 3 + i);
}

fn gabor_impl_wood(board_in: GaborImplPixel, wood: GaborWood, of_: GaborImplPairs, seed: u32) -> GaborMaterial {
    var board = board_in;
    board = gabor_impl_warp(board, vec2f(6.5, 0.08), vec2f(0.455 / wood.rings, 0.0), seed, 2);
    let rings = gabor_impl_repeated(board, wood.rings, 1.0).x;
    let years = rings * gabor_impl_along_x(board); // the number of rings up to here
    let kept = 0.97 * gabor_impl_sine_kept(board, rings); // amplitude of the rings' wave
    let rise = gabor_impl_rise(vec3f(years.x, 1.0, 0.0), vec3f(kept, 0.0, 0.0));
    let ring = vec3f(rise.x, rise.y * years.yz);
    let open = gabor_impl_above(of_.pair_0.second, of_.pair_0.removed, 1.1, 0.25);
    let pores = wood.pore_strength * open;
    let within = vec3f(1.0, 0.0, 0.0) - 0.75 * ring; // a quarter as deep in late wood
    let deep = gabor_impl_times(pores, within);
    let early = (1.0 - ring.x) * (1.0 - pores.x); let late = ring.x * (1.0 - 0.25 * pores.x);
    let tones = gabor_impl_tone(of_.pair_1.second.x, of_.pair_1.removed, 0.11)
               + gabor_impl_tone(of_.pair_2.second.x, of_.pair_2.removed, 0.13);
    let colour = early * gabor_impl_toned(wood.earlywood_colour, tones)
        + late * gabor_impl_toned(wood.latewood_colour, tones)
                + 0.45 * deep.x * wood.latewood_colour;
    let height = 0.0006 * ring - 0.0024 * deep + 0.0002 * of_.pair_1.second;
    // Mean squares: of the depth of pores, and of the height's derivative by the rings.
    let depth = 5.76e-6 * wood.pore_strength * wood.pore_strength
        * (within.x * within.x + 0.05 * (1.0 - kept * kept));
    let by_ring = 0.0006 + 0.0018 * pores.x;
    let spread = 3.24e-6 * wood.pore_strength * wood.pore_strength
        * gabor_impl_above_variance(open.x, of_.pair_0.removed, 0.25);
    let steep = gabor_impl_rise_lost(years.x, kept, 0.97); let all_steep = gabor_impl_rise_lost(0.0, 0.0, 0.97);
    let lost = ((by_ring * by_ring + spread) * steep + spread * rise.y * rise.y) * gabor_impl_square(years.yz)
              + (by_ring * by_ring + spread) * all_steep * gabor_impl_warp_lost(board, vec2f(rings * rings, 0.0))
              + 4.0e-8 * of_.pair_1.lost
              + depth * gabor_impl_above_lost(of_.pair_0.second, of_.pair_0.removed, of_.pair_0.lost, 1.1, 0.25);
    return gabor_impl_material(colour, height, lost, wood.roughness * (1.0 - 0.2 * ring.x), 0.0);
}

fn gabor_wood_at(p: vec2f, period: vec2f, wood: GaborWood, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let board = gabor_impl_board(pixel, wood, seed);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_spots_pair(gabor_impl_wood_layer(0, pixel, board, seed));
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_wood_layer(1, pixel, board, seed));
    of_.pair_2 = gabor_impl_spots_pair(gabor_impl_wood_layer(2, pixel, board, seed));
    return gabor_impl_wood(board, wood, of_, seed);
}

// ---- Samples -------------------------------------------------------------------------------------------------------
//
// The filters of weaves and of leather average samples, and fade to measured means where samples are too few.

// The standard deviation of positions within a pixel: the root of the mean of their variances along x and y. dx and
// dy are the pixel's sides.
fn gabor_impl_sample_spread(dx: vec2f, dy: vec2f) -> f32 {
    return sqrt(0.125 * (dot(dx, dx) + dot(dy, dy)));
}

// The number of samples for that standard deviation, 4 or `most`, if they have the share `kept` in the result.
fn gabor_impl_samples(spread: f32, kept: f32, most: i32) -> i32 {
    return select(select(most, 4, spread < 0.12), 1, spread < 0.001 || kept == 0.0);
}

// Sample i of 4, 8 or 12 in steps (dx, dy) from the middle of the pixel: quantiles of a normal distribution.
fn gabor_impl_sample(i: i32, count: i32) -> vec2f {
    let j = select(select((2 * i + 1) % 5, (5 * i + 2) % 8, count > 4), (5 * i + 4) % 13, count > 8);
    var at = vec2f(f32(i), f32(j)) * (2.0 / f32(count));
    at -= 1.0 - 1.0 / f32(count);
    return select(vec2f(0.0), at * (0.5566 + 0.507 * at * at), count > 1);
}

// The sum of heights over samples. `height` becomes their mean, which fades to `mean`; `lost` has the sum of the
// slopes' squares, and becomes their covariance, which fades to `square`.
fn gabor_impl_average(height: ptr<function, vec3f>, lost: ptr<function, vec3f>, count: i32, kept: f32, mean: f32,
                      square: vec3f) {
    *height = kept / f32(count) * (*height) + vec3f((1.0 - kept) * mean, 0.0, 0.0);
    *lost = select(vec3f(0.0),
            mix(square, (*lost) / f32(count), kept) - gabor_impl_square((*height).yz), count > 1 || kept == 0.0);
}

// ---- Weaves --------------------------------------------------------------------------------------------------------

fn gabor_impl_cloth(pixel: GaborImplPixel, fabric: GaborFabric, seed: u32) -> GaborImplPixel {
    return gabor_impl_warp(pixel, vec2f(0.7), vec2f(0.02 * fabric.unevenness), seed, 0);
}

// The thickness and course of threads along y and x, and their fibres.
fn gabor_impl_fabric_layer(i: i32, cloth: GaborImplPixel, count: vec2f, seed: u32) -> GaborImplLayer {
    let density = select(select(select(vec2f(2.0, 14.0) * count, vec2f(14.0, 2.0) * count, i == 2),
                                                      vec2f(1.1, 0.7 * count.y), i == 1), vec2f(0.7 * count.x, 1.1), i == 0);
    return gabor_impl_spots_layer(cloth, density, seed, 1 + i);
}

// Threads per unit; a weave repeats after 2, 4 or 16 of them.
fn gabor_impl_threads(pixel: GaborImplPixel, fabric: GaborFabric) -> vec2f {
    return gabor_impl_repeated(pixel, fabric.threads, select(select(16.0, 4.0, fabric.weave < 1.5), 2.0, fabric.weave < 0.5));
}

// 1 where the thread along y passes over that along x, which have these numbers, and -1 where it passes under.
fn gabor_impl_over(x_in: f32, y: f32, weave: f32) -> f32 {
    var x = x_in;
    if (weave < 0.5) { return select(1.0, -1.0, fract(0.5 * (x + y)) > 0.25); }
    if (weave > 1.5) { x = abs(16.0 * fract(0.0625 * x + 0.03125) - 8.5); } // turns back every eight threads
    return select(-1.0, 1.0, fract(0.25 * (x + y) + 0.125) < 0.5); // over two, under two
}

// The height of a thread: a circle of radius `thick`, which passes over the crossing thread if `bend` is 1, under if
// -1, and is level towards a thread that it crosses on the same side.
fn gabor_impl_thread(across: vec3f, thick: vec3f, along: vec3f, bend: f32, level: bool) -> vec3f {
    let square = thick.x * thick.x - 4.2 * across.x * across.x;
    let side = sqrt(max(square, 0.0)); let turn = select(3.1415927 * along.x, 0.0, level); // pi
    let slope = (thick.x * thick.yz - 4.2 * across.x * across.yz) / max(side, 0.05);
    // 1.7278760 is 0.55 pi
    return vec3f(side - select(1.0, 2.0, square < 0.0) + 0.55 * bend * cos(turn),
                 select(slope, vec2f(0.0), square < 0.0) - 1.7278760 * bend * sin(turn) * along.yz);
}

// The means to which the filter fades the weave were measured; they depend on the unevenness.
fn gabor_impl_fabric(cloth: GaborImplPixel, count: vec2f, fabric: GaborFabric, of_: GaborImplPairs) -> GaborMaterial {
    let uneven = fabric.unevenness; var unit = fabric.relief / fabric.threads;
    var at_x = count.x * gabor_impl_along_x(cloth); var at_y = count.y * gabor_impl_along_y(cloth);
    let dx = count * cloth.dx; let dy = count * cloth.dy;
    let spread = gabor_impl_sample_spread(dx, dy); let kept = 1.0 - smoothstep(0.3, 0.7, spread);
    at_x += 0.13 * uneven * of_.pair_0.first;
    at_y += 0.13 * uneven * of_.pair_1.first;
    let warp_tones = gabor_impl_tone(of_.pair_0.first.x, of_.pair_0.removed, 0.09 * uneven)
                    + gabor_impl_tone(of_.pair_2.second.x, of_.pair_2.removed, 0.12);
    let weft_tones = gabor_impl_tone(of_.pair_1.first.x, of_.pair_1.removed, 0.09 * uneven)
                    + gabor_impl_tone(of_.pair_3.second.x, of_.pair_3.removed, 0.12);
    let warp = gabor_impl_toned(fabric.warp_colour, warp_tones);
    let weft = gabor_impl_toned(fabric.weft_colour, weft_tones);
    var height = vec3f(0.0); var colour = vec3f(0.0); var lost = vec3f(0.0);
    let samples = gabor_impl_samples(spread, kept, 8);
    for (var i = 0; i < samples; i++) {
        let at = gabor_impl_sample(i, samples); let offset = at.x * dx + at.y * dy;
        var x = at_x + vec3f(offset.x, 0.0, 0.0); var y = at_y + vec3f(offset.y, 0.0, 0.0);
        let thread = floor(vec2f(x.x, y.x));
        x.x -= thread.x + 0.5;
        y.x -= thread.y + 0.5;
        let over = gabor_impl_over(thread.x, thread.y, fabric.weave);
        let level_y = over == gabor_impl_over(thread.x, thread.y + select(1.0, -1.0, y.x < 0.0), fabric.weave);
        let level_x = over == gabor_impl_over(thread.x + select(1.0, -1.0, x.x < 0.0), thread.y, fabric.weave);
        let along_y = gabor_impl_thread(x, vec3f(1.0, 0.0, 0.0) + 0.16 * uneven * of_.pair_0.second, y, over, level_y);
        let along_x = gabor_impl_thread(y, vec3f(1.0, 0.0, 0.0) + 0.16 * uneven * of_.pair_1.second, x, -over, level_x);
        let first = along_y.x > along_x.x;
        var top = select(along_x, along_y, first);
        if (top.x < -1.3) { top = vec3f(-1.3, 0.0, 0.0); }
        colour += mix(0.18, 1.0, smoothstep(-1.3, 0.5, top.x)) * select(weft, warp, first);
        top = 0.3 * top + 0.035 * select(of_.pair_3.second, of_.pair_2.second, first);
        height += top;
        lost += gabor_impl_square(top.yz);
    }
    var mean = vec3f(0.8828 - 0.0056 * uneven * uneven, 0.0406 + 0.0025 * uneven * uneven, 0.29); // light, height, slope
    if (fabric.weave >= 0.5) { mean = vec3f(0.91 - uneven * (0.0105 + 0.0045 * uneven), 0.0655, 0.37); }
    gabor_impl_average(&height, &lost, samples, kept, mean.y, vec3f(mean.z * count * count, 0.0));
    let bare = select(1.0, 0.12, fabric.cords > 0.0); // pile hides the weave of corduroy
    colour = mix(0.5 * mean.x * (warp + weft), colour / f32(samples), bare * kept);
    unit *= bare;
    height *= unit;
    lost = unit * unit * (lost + 0.0006125 * (of_.pair_2.lost + of_.pair_3.lost));
    if (fabric.cords > 0.0) { // wide crests and narrow furrows, 1 - cos(pi x)^4: two waves, which the filter damps
        let cords = gabor_impl_repeated(cloth, fabric.cords, 1.0).x;
        let at = cords * gabor_impl_along_x(cloth);
        let damped = gabor_impl_sine_kept(cloth, cords); let half_cord = 0.5 * damped;
        let second = 0.125 * damped * damped * damped * damped; let turn = 6.2831853 * fract(at.x); // 2 pi
        let cord = 0.625 - half_cord * cos(turn) - second * cos(2.0 * turn);
        let depth = 0.3 * fabric.relief / cords; let swing = depth * 6.2831853;
        colour *= mix(0.3, 1.0, cord);
        height += vec3f(depth * cord, swing * (half_cord * sin(turn) + 2.0 * second * sin(2.0 * turn)) * at.yz);
        // 0.15625 is 5/32
        lost += swing * swing * (0.15625 - 0.5 * half_cord * half_cord - 2.0 * second * second)
                * gabor_impl_square(at.yz);
    }
    return gabor_impl_material(colour, height, lost, fabric.roughness, 0.0);
}

fn gabor_fabric_at(p: vec2f, period: vec2f, fabric: GaborFabric, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let cloth = gabor_impl_cloth(pixel, fabric, seed);
    let count = gabor_impl_threads(pixel, fabric);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_spots_pair(gabor_impl_fabric_layer(0, cloth, count, seed));
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_fabric_layer(1, cloth, count, seed));
    of_.pair_2 = gabor_impl_spots_pair(gabor_impl_fabric_layer(2, cloth, count, seed));
    of_.pair_3 = gabor_impl_spots_pair(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of_);
}

fn gabor_impl_twill(pixel: GaborImplPixel, seed: u32) -> GaborImplPixel {
    return gabor_impl_warp(pixel, vec2f(0.8), vec2f(0.008), seed, 0);
}

// The fibres of tows along y and x.
fn gabor_impl_tow_layer(i: i32, cloth: GaborImplPixel, count: vec2f, seed: u32) -> GaborImplLayer {
    return gabor_impl_spots_layer(cloth, select(vec2f(0.6, 32.0), vec2f(32.0, 0.6), i == 0) * count, seed, 1 + i);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
fn gabor_impl_carbon_fibre(cloth: GaborImplPixel, count: vec2f, fibres: GaborCarbonFibre, of_: GaborImplPairs) -> GaborMaterial {
    let at_x = count.x * gabor_impl_along_x(cloth); let at_y = count.y * gabor_impl_along_y(cloth);
    let dx = count * cloth.dx; let dy = count * cloth.dy;
    let spread = gabor_impl_sample_spread(dx, dy); let kept = 1.0 - smoothstep(0.5, 0.9, spread);
    let unit = fibres.relief / fibres.tows;
    let warp = gabor_impl_toned(fibres.colour,
                                gabor_impl_tone(of_.pair_0.first.x, of_.pair_0.removed, fibres.fibre_contrast));
    let weft = gabor_impl_toned(fibres.colour,
                                gabor_impl_tone(of_.pair_1.first.x, of_.pair_1.removed, fibres.fibre_contrast));
    var height = vec3f(0.0); var colour = vec3f(0.0); var lost = vec3f(0.0);
    let samples = gabor_impl_samples(spread, kept, 8);
    for (var i = 0; i < samples; i++) {
        let at = gabor_impl_sample(i, samples); let offset = at.x * dx + at.y * dy;
        var x = at_x + vec3f(offset.x, 0.0, 0.0); var y = at_y + vec3f(offset.y, 0.0, 0.0);
        let turn = 4.0 * fract(0.25 * (floor(x.x) + floor(y.x)) + 0.125) - 0.5; // 0 to 3
        x.x -= floor(x.x);
        y.x -= floor(y.x);
        let first = turn < 1.5;
        var along = 0.5 * select(x, y, first); var across = 2.0 * select(y, x, first);
        along.x += select(0.5, 0.0, fract(0.5 * turn + 0.25) < 0.5); // from 0 to 1 over two rows
        across.x -= 1.0;
        let cube = across.x * across.x * across.x; let low = 1.0 - cube * across.x; let arch = low * low;
        let wave = vec2f(cos(3.1415927 * along.x), sin(3.1415927 * along.x)); // pi
        var bulge = vec3f(wave.y * arch, 3.1415927 * arch * wave.x * along.yz - 8.0 * cube * low * wave.y * across.yz);
        colour += (0.35 + 0.65 * bulge.x) * select(weft, warp, first);
        bulge = 0.16 * bulge + 0.0035 * select(of_.pair_1.first, of_.pair_0.first, first);
        height += bulge;
        lost += gabor_impl_square(bulge.yz);
    }
    // The bulge's mean is 0.4527, and its slope's mean square, over tows along x and y, 2.154.
    // 0.072432 is 0.16 * 0.4527
    gabor_impl_average(&height, &lost, samples, kept, 0.072432, 0.0256 * 2.154 * vec3f(count * count, 0.0));
    colour = mix(0.3221275 * (warp + weft), colour / f32(samples), kept); // (0.35 + 0.65 * 0.4527) / 2
    lost = unit * unit * (lost + 6.125e-6 * (of_.pair_0.lost + of_.pair_1.lost));
    return gabor_impl_material(colour, unit * height, lost, fibres.roughness, 0.0);
}

fn gabor_carbon_fibre_at(p: vec2f, period: vec2f, fibres: GaborCarbonFibre, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let cloth = gabor_impl_twill(pixel, seed);
    let count = gabor_impl_repeated(pixel, fibres.tows, 4.0);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_spots_pair(gabor_impl_tow_layer(0, cloth, count, seed));
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of_);
}

// ---- Leather -------------------------------------------------------------------------------------------------------
//
// Three waves. The phase of the third is the sum of the other two, so the crests of all three meet in each cell's
// middle.

fn gabor_impl_skin(pixel: GaborImplPixel, leather: GaborLeather, seed: u32) -> GaborImplPixel {
    let bends = vec2f(0.07, 0.014) * leather.waviness;
    let skin = gabor_impl_warp(pixel, vec2f(0.9), vec2f(bends.x), seed, 0);
    return gabor_impl_warp(skin, vec2f(4.0), vec2f(bends.y), seed, 1);
}

// Three octaves of fine grain, the tone, and the first two waves.
fn gabor_impl_leather_layer(i: i32, pixel: GaborImplPixel, skin: GaborImplPixel, leather: GaborLeather, seed: u32) -> GaborImplLayer {
    if (i < 3) { return gabor_impl_octave(pixel, vec2f(18.0), i, 3, 0.75, gabor_derived_seed(seed, 4)); }
    if (i == 3) { return gabor_impl_spots_layer(pixel, vec2f(0.8), seed, 5); }
    // 2.2944 is 0.2 + 2/3 pi
    return gabor_impl_waves_layer(skin, vec2f(leather.cells / 1.6), 1.6, select(2.2944, 0.2, i == 4), seed, i - 2);
}

// Waves at an offset: their envelope moves along its slope, and the phase turns.
fn gabor_impl_moved_waves(waves: GaborImplPair, at: GaborImplPixel, wave: vec2f, offset: vec2f, turns: f32) -> GaborImplPair {
    let turn = gabor_impl_wave(turns);
    let phase = 6.2831853 * vec3f(0.0, dot(wave, at.by_x), dot(wave, at.by_y)); // 2 pi
    var a = waves.first + waves.second.x * phase; var b = waves.second - waves.first.x * phase; // the envelope's slopes
    a.x += dot(a.yz, offset);
    b.x += dot(b.yz, offset);
    let first = turn.x * a - turn.y * b; let second = turn.y * a + turn.x * b;
    return GaborImplPair(first - second.x * phase, second + first.x * phase, 0.0, vec3f(0.0));
}

// Brings the waves of a pair near length 1: their cosine and sine.
fn gabor_impl_crest(waves: GaborImplPair, cosine: ptr<function, vec3f>, sine: ptr<function, vec3f>) {
    let power = waves.first.x * waves.first.x + waves.second.x * waves.second.x + 0.12;
    let change = waves.first.x * waves.first.yz + waves.second.x * waves.second.yz;
    let unit = inverseSqrt(power) * vec3f(1.0, -1.0 / power * change);
    *cosine = gabor_impl_times(waves.first, unit);
    *sine = gabor_impl_times(waves.second, unit);
}

// The means to which the filter fades, and the mean squares of the slopes, were measured.
fn gabor_impl_leather(pixel: GaborImplPixel, skin: GaborImplPixel, leather: GaborLeather, of_: GaborImplPairs) -> GaborMaterial {
    // 2.2944 is 0.2 + 2/3 pi
    let wave_a = gabor_wave_vector(leather.cells, 0.2); let wave_b = gabor_wave_vector(leather.cells, 2.2944);
    let dx = vec2f(dot(wave_a, skin.dx), dot(wave_b, skin.dx));
    let dy = vec2f(dot(wave_a, skin.dy), dot(wave_b, skin.dy));
    let spread = gabor_impl_sample_spread(dx, dy); let bend = exp(-60.0 * spread * spread);
    let kept = 1.0 - smoothstep(0.4, 0.8, spread); var share = 0.0; var grains = 0.0;
    var height = vec3f(0.0); var lost = vec3f(0.0);
    let samples = gabor_impl_samples(spread, kept, 12);
    for (var i = 0; i < samples; i++) {
        let at = gabor_impl_sample(i, samples); let offset = at.x * dx + at.y * dy;
        let further = bend * (at.x * pixel.dx + at.y * pixel.dy);
        var a: vec3f; var b: vec3f; var sine_a: vec3f; var sine_b: vec3f;
        gabor_impl_crest(gabor_impl_moved_waves(of_.pair_2, skin, wave_a, further, offset.x), &a, &sine_a);
        gabor_impl_crest(gabor_impl_moved_waves(of_.pair_3, skin, wave_b, further, offset.y), &b, &sine_b);
        // 3 in the middle of a cell, -1.5 in a corner
        let cells = a + b + gabor_impl_times(a, b) - gabor_impl_times(sine_a, sine_b);
        let grained = cells + 0.1 * of_.pair_0.second;
        let pebble = gabor_impl_step(-1.45, -0.55, vec3f(grained.x, 1.0, 0.0)).xy; // with its derivative
        share += pebble.x;
        let relief = 0.016 * vec3f(pebble.x, pebble.y * grained.yz) + 0.013 * gabor_impl_step(-1.0, 3.0, cells)
                    + 0.0008 * of_.pair_0.second;
        let grain = 0.0016 * pebble.y + 0.0008; // the height's derivative by the grain
        grains += grain * grain;
        height += relief;
        lost += gabor_impl_square(relief.yz);
    }
    var square = leather.cells * leather.cells * vec3f(0.00235, 0.00194, -0.0001); // along the skin's axes
    let warped = gabor_impl_warp_lost(skin, square.xy);
    square = gabor_impl_turned_square(square, skin.by_x, skin.by_y);
    // 0.015964 was measured; tools/constants.py derives 0.01595
    gabor_impl_average(&height, &lost, samples, kept, 0.015964, square);
    share = mix(0.806, share / f32(samples), kept);
    // Wrinkles along the zeros of the grain's other noise, and pores at its peaks.
    let fine = of_.pair_0;
    let wrinkle = gabor_impl_line(fine.first, fine.removed, 0.25);
    let pore = gabor_impl_above(fine.first, fine.removed, 1.8, 0.2);
    height -= 0.0018 * wrinkle + 0.004 * pore;
    share *= 1.0 - 0.25 * wrinkle.x - 0.6 * pore.x;
    let tones = gabor_impl_tone(of_.pair_1.second.x, of_.pair_1.removed, 0.14);
    let colour = mix(gabor_impl_toned(leather.crease_colour, tones), gabor_impl_toned(leather.pebble_colour, tones),
                     share);
    lost += warped + mix(3.67e-6, grains / f32(samples), kept) * of_.pair_0.lost
          + 3.24e-6 * gabor_impl_line_lost(fine.first, fine.removed, fine.lost, 0.25)
          + 1.6e-5 * gabor_impl_above_lost(fine.first, fine.removed, fine.lost, 1.8, 0.2);
    let unit = 0.6 * leather.relief;
    return gabor_impl_material(colour, unit * height, unit * unit * lost, leather.roughness + 0.15 * (1.0 - share),
                               0.0);
}

fn gabor_leather_at(p: vec2f, period: vec2f, leather: GaborLeather, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let skin = gabor_impl_skin(pixel, leather, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 3; i++) {
        of_.pair_0 = gabor_impl_plus_octave(of_.pair_0, gabor_impl_leather_layer(i, pixel, skin, leather, seed));
    }
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_leather_layer(3, pixel, skin, leather, seed));
    of_.pair_2 = gabor_impl_waves_pair(gabor_impl_leather_layer(4, pixel, skin, leather, seed));
    of_.pair_3 = gabor_impl_waves_pair(gabor_impl_leather_layer(5, pixel, skin, leather, seed));
    return gabor_impl_leather(pixel, skin, leather, of_);
}

// ---- Marble --------------------------------------------------------------------------------------------------------

fn gabor_impl_stone(pixel: GaborImplPixel, marble: GaborMarble, seed: u32) -> GaborImplPixel {
    let bends = vec4f(0.17, 0.038, 0.010, 0.003) * marble.turbulence;
    var stone = gabor_impl_warp(pixel, vec2f(1.1), vec2f(bends.x), seed, 0);
    stone = gabor_impl_warp(stone, vec2f(4.0), vec2f(bends.y), seed, 1);
    stone = gabor_impl_warp(stone, vec2f(13.0), vec2f(bends.z), seed, 2);
    return gabor_impl_warp(stone, vec2f(40.0), vec2f(bends.w), seed, 3);
}

// Three octaves of clouds, crystals, and four sizes of veins: middle, large, thin, hair.
fn gabor_impl_marble_layer(i: i32, pixel: GaborImplPixel, stone: GaborImplPixel, seed: u32) -> GaborImplLayer {
    if (i < 3) { return gabor_impl_octave(stone, vec2f(1.5), i, 3, 0.6, gabor_derived_seed(seed, 8)); }
    if (i == 3) { return gabor_impl_spots_layer(pixel, vec2f(75.0), seed, 9); }
    let vein = select(select(select(vec3f(13.0, 0.9, 0.2), vec3f(4.5, 0.95, 0.95), i == 6),
                                                 vec3f(0.95, 0.85, 0.65), i == 5), vec3f(1.9, 0.95, -0.45), i == 4);
    return gabor_impl_waves_layer(stone, vec2f(vein.x), vein.y, vein.z, seed, select(select(i, 4, i == 5), 5, i == 4));
}

fn gabor_impl_marble(marble: GaborMarble, cloud: GaborImplPair, crystal: GaborImplPair) -> GaborMaterial {
    let clouds = marble.cloud_strength * gabor_impl_above(cloud.second, cloud.removed, 0.5, 0.8).x;
    let colour = gabor_impl_toned(marble.stone_colour * (1.0 - clouds),
                                  gabor_impl_tone(crystal.first.x, crystal.removed, 0.02));
    return gabor_impl_material(colour, 0.00012 * crystal.second, 1.44e-8 * crystal.lost, marble.roughness, 0.0);
}

// Adds veins of layer i: lines along the zeros of a noise, drawn only where a second noise exceeds a threshold, so that
// they have ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
fn gabor_impl_add_veins(stone: ptr<function, GaborMaterial>, marble: GaborMarble, i: i32, vein: GaborImplPair) {
    var width = select(select(vec2f(1.0, select(0.05, 0.04, i == 6)), vec2f(0.35, 0.05), i == 5), vec2f(0.25, 0.035), i == 4);
    var strength = marble.vein_strength * select(select(vec2f(0.0, 0.45), vec2f(0.55, 0.75), i == 5), vec2f(0.6, 0.6), i == 4);
    let threshold = select(select(select(1.1, 0.8, i == 6), -0.4, i == 5), 0.5, i == 4);
    let open = gabor_impl_above(vein.second, vein.removed, threshold, 0.5).x;
    // The second noise widens the core by exp(0.8 noise); so weighted, its removed part has a mean of 0.8 times its
    // variance.
    width.y *= 0.6 * exp(min(0.8 * vein.second.x, 2.4) + 0.32 * vein.removed); // 0.8^2 / 2
    let weighted = vein.second + vec3f(0.8 * vein.removed, 0.0, 0.0);
    strength.y *= gabor_impl_above(weighted, vein.removed, threshold, 0.5).x
                * gabor_impl_line(vein.first, vein.removed, width.y).x;
    strength.x *= open * gabor_impl_line(vein.first, vein.removed, width.x).x - strength.y;
    let halo = mix(marble.stone_colour, marble.vein_colour, 0.65);
    let core = mix(marble.stone_colour, marble.vein_colour, select(select(select(0.45, 0.65, i == 6), 1.0, i == 5), 0.9, i == 4));
    (*stone).colour += strength.x * (halo - (*stone).colour) + strength.y * (core - (*stone).colour);
    (*stone).colour = clamp((*stone).colour, vec3f(0.0), vec3f(1.0));
}

fn gabor_marble_at(p: vec2f, period: vec2f, marble: GaborMarble, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let stone = gabor_impl_stone(pixel, marble, seed);
    var cloud = gabor_impl_no_pair();
    for (var i = 0; i < 3; i++) {
        cloud = gabor_impl_plus_octave(cloud, gabor_impl_marble_layer(i, pixel, stone, seed));
    }
    let crystal = gabor_impl_spots_pair(gabor_impl_marble_layer(3, pixel, stone, seed));
    var material = gabor_impl_marble(marble, cloud, crystal);
    for (var j = 4; j < 8; j++) {
        let layer = gabor_impl_marble_layer(j, pixel, stone, seed);
        gabor_impl_add_veins(&material, marble, j, gabor_impl_waves_pair(layer));
    }
    return material;
}

// ---- Sand ----------------------------------------------------------------------------------------------------------

fn gabor_impl_dune(pixel: GaborImplPixel, seed: u32) -> GaborImplPixel {
    let dune = gabor_impl_warp(pixel, vec2f(0.8), vec2f(0.15), seed, 0);
    return gabor_impl_warp(dune, vec2f(3.0), vec2f(0.02), seed, 1);
}

// Three octaves of large shapes, grains, and ripples.
fn gabor_impl_sand_layer(i: i32, pixel: GaborImplPixel, dune: GaborImplPixel, sand: GaborSand, seed: u32) -> GaborImplLayer {
    if (i < 3) { return gabor_impl_octave(pixel, vec2f(0.6), i, 3, 0.5, gabor_derived_seed(seed, 4)); }
    if (i == 3) { return gabor_impl_spots_layer(pixel, vec2f(75.0), seed, 3); }
    return gabor_impl_waves_layer(dune, vec2f(0.9, 1.7) / 3.87 * sand.ripples, 2.3, 1.4, seed, 2);
}

fn gabor_impl_sand(sand: GaborSand, ripples: GaborImplLayer, of_: GaborImplPairs) -> GaborMaterial {
    let z = vec2f(of_.pair_2.first.x, of_.pair_2.second.x);
    let power = max(dot(z, z), 1.0e-6); let whole = power + 2.5 * of_.pair_2.removed;
    let span = 0.9 * sqrt(power / whole);
    let change = z.x * of_.pair_2.first.yz + z.y * of_.pair_2.second.yz; // half the derivative of the power
    // 0.15915494 is 1/(2 pi)
    let phase = vec3f(gabor_turns_intensity(z.yx).x,
                      0.15915494 / power * (z.x * of_.pair_2.second.yz - z.y * of_.pair_2.first.yz));
    let ripple = gabor_impl_rise(phase, span * vec3f(1.0, (1.0 / power - 1.0 / whole) * change));
    let tones = gabor_impl_tone(of_.pair_1.first.x, of_.pair_1.removed, sand.grain_contrast)
               + gabor_impl_tone(of_.pair_0.second.x, of_.pair_0.removed, 0.06);
    var colour = mix(gabor_impl_toned(sand.trough_colour, tones), gabor_impl_toned(sand.crest_colour, tones),
                     ripple.x);
    let dark = gabor_impl_above(of_.pair_1.second, of_.pair_1.removed, 1.9, 0.15).x;
    let bright = gabor_impl_above(-of_.pair_1.second, of_.pair_1.removed, 1.9, 0.15).x;
    colour = mix(colour, 0.23 * sand.trough_colour, 3.75 * sand.grain_contrast * dark);
    colour = mix(colour, mix(sand.crest_colour, vec3f(1.0), 0.6), 3.0 * sand.grain_contrast * bright);
    let tall = vec3f(sand.ripple_height, 0.0, 0.0) + 0.2 * sand.ripple_height * of_.pair_0.first;
    let height = gabor_impl_times(ripple, tall) + 0.03 * of_.pair_0.first
        + 0.00875 * sand.grain_contrast * of_.pair_1.first;
    var wave = ripples.density * ripples.wave; // per unit of the dune
    wave = vec2f(dot(wave, ripples.at.by_x), dot(wave, ripples.at.by_y));
    // The phase's mean square slope is that of the wave, and more where the noise is near 0: 0.4 was measured.
    let bent = vec3f(0.4 * ripples.density * ripples.density, 0.0);
    let square = gabor_impl_square(wave) + gabor_impl_turned_square(bent, ripples.at.by_x, ripples.at.by_y);
    let warped = gabor_impl_warp_lost(
        ripples.at, ripples.density * ripples.density * (0.4 + ripples.wave * ripples.wave));
    // Mean squares of factors; 0.0888889 is 4/45, the variance of a ripple.
    let high = tall.x * tall.x + 0.04 * sand.ripple_height * sand.ripple_height * of_.pair_0.removed;
    let by_shape = 0.03 + 0.2 * sand.ripple_height * ripple.x;
    let varied = 0.04 * sand.ripple_height * sand.ripple_height * 0.0888889 * (1.0 - span * span / 0.81);
    // 7.65625e-5 is 0.00875^2
    let lost = high * (gabor_impl_rise_lost(phase.x, span, 0.9) * square
                       + gabor_impl_rise_lost(0.0, 0.0, 0.9) * warped)
              + (by_shape * by_shape + varied) * of_.pair_0.lost
              + 7.65625e-5 * sand.grain_contrast * sand.grain_contrast * of_.pair_1.lost;
    return gabor_impl_material(colour, height, lost, sand.roughness, 0.0);
}

fn gabor_sand_at(p: vec2f, period: vec2f, sand: GaborSand, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let dune = gabor_impl_dune(pixel, seed);
    let ripples = gabor_impl_sand_layer(4, pixel, dune, sand, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 3; i++) {
        of_.pair_0 = gabor_impl_plus_octave(of_.pair_0, gabor_impl_sand_layer(i, pixel, dune, sand, seed));
    }
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_sand_layer(3, pixel, dune, sand, seed));
    of_.pair_2 = gabor_impl_waves_pair(ripples);
    return gabor_impl_sand(sand, ripples, of_);
}

// ---- Brushed metal -------------------------------------------------------------------------------------------------

// Five sizes of streaks, and six octaves of patina.
fn gabor_impl_metal_layer(i: i32, pixel: GaborImplPixel, metal: GaborBrushedMetal, seed: u32) -> GaborImplLayer {
    if (i >= 5) { return gabor_impl_octave(pixel, vec2f(1.3), i - 5, 6, 0.75, gabor_derived_seed(seed, 5)); }
    let density = vec2f(0.3 + 0.12 * exp2(f32(i)), metal.streaks * exp2(f32(i)));
    return gabor_impl_spots_layer(pixel, density, seed, i);
}

// The layers that the metal needs.
fn gabor_impl_metal_layers(metal: GaborBrushedMetal) -> i32 {
    return select(5, 11, metal.patina_amount > 0.0);
}

// Adds a layer: of the streaks, the first sum is the height, the second the tone.
fn gabor_impl_add_metal(of_: ptr<function, GaborImplPairs>, i: i32, layer: GaborImplLayer, pair: GaborImplPair) {
    if (i >= 5) {
        (*of_).pair_1 = gabor_impl_plus((*of_).pair_1, pair, layer.amplitude);
        return;
    }
    let size = exp2(-f32(i));
    (*of_).pair_0.first += size * pair.first;
    (*of_).pair_0.second += 0.4472136 * pair.second; // 1/sqrt(5)
    (*of_).pair_0.removed += 0.2 * pair.removed;
    (*of_).pair_0.lost += size * size * pair.lost;
}

fn gabor_impl_brushed_metal(metal: GaborBrushedMetal, of_: GaborImplPairs) -> GaborMaterial {
    let colour = gabor_impl_toned(metal.metal_colour,
                                  gabor_impl_tone(of_.pair_0.second.x, of_.pair_0.removed, metal.streak_contrast));
    var height = metal.streak_height * of_.pair_0.first;
    var lost = metal.streak_height * metal.streak_height * of_.pair_0.lost;
    if (metal.patina_amount <= 0.0) { return gabor_impl_material(colour, height, lost, metal.roughness, 1.0); }
    let threshold = 2.4 - 3.8 * metal.patina_amount;
    let cover = gabor_impl_above(of_.pair_1.second, of_.pair_1.removed, threshold, 0.3);
    let patina = gabor_impl_toned(metal.patina_colour, gabor_impl_tone(of_.pair_1.first.x, of_.pair_1.removed, 0.3));
    height += 0.003 * cover + 0.001 * of_.pair_1.first;
    lost += 9.0e-6 * gabor_impl_above_lost(of_.pair_1.second, of_.pair_1.removed, of_.pair_1.lost, threshold, 0.3)
          + 1.0e-6 * of_.pair_1.lost;
    return gabor_impl_material(mix(colour, patina, cover.x), height, lost, mix(metal.roughness, 0.85, cover.x),
                               1.0 - cover.x);
}

fn gabor_brushed_metal_at(p: vec2f, period: vec2f, metal: GaborBrushedMetal, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    var of_ = gabor_impl_no_pairs();
    let layers = gabor_impl_metal_layers(metal);
    for (var i = 0; i < layers; i++) {
        let layer = gabor_impl_metal_layer(i, pixel, metal, seed);
        gabor_impl_add_metal(&of_, i, layer, gabor_impl_spots_pair(layer));
    }
    return gabor_impl_brushed_metal(metal, of_);
}

// ---- Scratches -----------------------------------------------------------------------------------------------------
//
// Scratches are the peaks of noise with very long and narrow kernels, in many directions.

fn gabor_impl_scratches_layer(i: i32, pixel: GaborImplPixel, scratches: GaborScratches, seed: u32) -> GaborImplLayer {
    // 3 - sqrt(5).
    let angle = scratches.scratch_direction
        + scratches.direction_spread * (2.0 * fract(0.0955 + 0.763932 * f32(i)) - 1.0);
    var at = gabor_impl_turned(pixel, angle);
    // Across a tile's scratches, a period holds at least three nodes however short it is: bend less, or scratches
    // swell.
    let bend = select(0.17, min(0.17, 0.02 * at.period.y), at.period.y > 0.0);
    at = gabor_impl_warp(at, vec2f(0.3, 0.1), vec2f(0.0, bend), seed, 2 * i);
    return gabor_impl_spots_layer(at, vec2f(1.0 / scratches.scratch_length, 60.0) * exp2(0.13 * f32(i)), seed,
                                  2 * i + 1);
}

// Adds scratches: the height is in units of their depth, and the colour is the share of whole lacquer. A scratch is
// the overlap of two long ovals, which tapers at its ends: there, both noises of a pair exceed sharp thresholds.
fn gabor_impl_add_scratches(sum: ptr<function, GaborMaterial>, scratches: GaborScratches, i: i32, noise: GaborImplPair) {
    let size = exp2(-0.13 * f32(i));
    let threshold = sqrt(5.76 - 2.0 * log(scratches.amount)); // the area above it is about proportional to amount
    let peak = gabor_impl_above(noise.first, noise.removed, threshold, 0.12);
    let open = gabor_impl_above(noise.second, noise.removed, 0.3, 0.25);
    let scratch = gabor_impl_times(peak, open);
    (*sum).colour *= 1.0 - (0.25 + 0.7 * size) * scratch.x;
    (*sum).height -= size * scratch.x;
    (*sum).slope -= size * scratch.yz;
    // The mean square of `open`, as in gabor_impl_above_variance; 1.14 stands for its own slopes.
    // Beyond three deviations, the noise has fewer values than a normal law: a fit to amounts from 0.01 to 8.
    let rare = threshold / 3.85; let rarer = rare * rare * rare * rare;
    (*sum).lost += 1.14 / (1.0 + rarer * rarer) * size * size
              * open.x * mix(open.x, 1.0, noise.removed / (noise.removed + 0.09375))
              * gabor_impl_above_lost(noise.first, noise.removed, noise.lost, threshold, 0.12);
}

fn gabor_impl_scratches(scratches: GaborScratches, sum: GaborMaterial) -> GaborMaterial {
    let height = scratches.depth * vec3f(sum.height, sum.slope);
    let lost = scratches.depth * scratches.depth * sum.lost;
    return gabor_impl_material(mix(scratches.scratch_colour, scratches.lacquer_colour, sum.colour), height, lost,
                               scratches.roughness,
                               0.0);
}

fn gabor_scratches_at(p: vec2f, period: vec2f, scratches: GaborScratches, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    var sum = GaborMaterial(vec3f(1.0), 0.0, vec2f(0.0), 0.0, 0.0, vec3f(0.0));
    for (var i = 0; i < 14; i++) {
        gabor_impl_add_scratches(&sum, scratches, i,
                                 gabor_impl_spots_pair(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    }
    return gabor_impl_scratches(scratches, sum);
}

// ---- Zebra ---------------------------------------------------------------------------------------------------------

fn gabor_impl_hide(pixel: GaborImplPixel, seed: u32) -> GaborImplPixel {
    return gabor_impl_warp(pixel, vec2f(0.9), vec2f(0.14), seed, 0);
}

fn gabor_impl_stripes_direction(pixel: GaborImplPixel, zebra: GaborZebra, seed: u32) -> f32 {
    let place = gabor_impl_place(pixel, vec2f(0.6));
    return zebra.orientation + zebra.bend_angle * gabor_impl_spots(place, gabor_derived_seed(seed, 1)).quadrature;
}

// Hair, tone and stripes.
fn gabor_impl_zebra_layer(i: i32, pixel: GaborImplPixel, skin: GaborImplPixel, direction: f32, zebra: GaborZebra,
                          seed: u32) -> GaborImplLayer {
    // 2.0707963 is 0.5 + pi/2
    if (i == 0) { return gabor_impl_spots_layer(gabor_impl_turned(skin, 2.0707963), vec2f(6.0, 80.0), seed, 3); }
    if (i == 1) { return gabor_impl_spots_layer(pixel, vec2f(1.2), seed, 4); }
    return gabor_impl_waves_layer(skin, vec2f(zebra.stripes / 1.4), 1.4, direction, seed, 2);
}

fn gabor_impl_zebra(zebra: GaborZebra, of_: GaborImplPairs) -> GaborMaterial {
    let ragged = 0.1 * zebra.hair_contrast; let relief = 0.002 * zebra.hair_contrast;
    // where it is small, a constant softness would blur the edge
    let intensity = length(vec2f(of_.pair_2.first.x, of_.pair_2.second.x));
    let dark = gabor_impl_above(of_.pair_2.first + ragged * intensity * of_.pair_0.first,
                                of_.pair_2.removed + ragged * ragged * intensity * intensity * of_.pair_0.removed, 0.0,
                                0.01 + 0.09 * intensity).x;
    let tones = gabor_impl_tone(of_.pair_0.second.x, of_.pair_0.removed, 0.14 * zebra.hair_contrast)
               + gabor_impl_tone(of_.pair_1.second.x, of_.pair_1.removed, 0.08);
    let colour = mix(gabor_impl_toned(zebra.background_colour, tones), gabor_impl_toned(zebra.stripe_colour, tones),
                     dark);
    return gabor_impl_material(colour, relief * of_.pair_0.first, relief * relief * of_.pair_0.lost, zebra.roughness,
                               0.0);
}

fn gabor_zebra_at(p: vec2f, period: vec2f, zebra: GaborZebra, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let skin = gabor_impl_hide(pixel, seed);
    let direction = gabor_impl_stripes_direction(pixel, zebra, seed);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_spots_pair(gabor_impl_zebra_layer(0, pixel, skin, direction, zebra, seed));
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_zebra_layer(1, pixel, skin, direction, zebra, seed));
    of_.pair_2 = gabor_impl_waves_pair(gabor_impl_zebra_layer(2, pixel, skin, direction, zebra, seed));
    return gabor_impl_zebra(zebra, of_);
}

// ---- Bark ----------------------------------------------------------------------------------------------------------

fn gabor_impl_trunk(pixel: GaborImplPixel, seed: u32) -> GaborImplPixel {
    var trunk = gabor_impl_warp(pixel, vec2f(0.8, 0.35), vec2f(0.22, 0.1), seed, 0);
    trunk = gabor_impl_warp(trunk, vec2f(3.0, 1.6), vec2f(0.05, 0.05), seed, 1);
    return gabor_impl_warp(trunk, vec2f(10.0), vec2f(0.013), seed, 2);
}

// Five octaves of roughness, moss, furrows, and cracks.
fn gabor_impl_bark_layer(i: i32, pixel: GaborImplPixel, trunk: GaborImplPixel, bark: GaborBark, seed: u32) -> GaborImplLayer {
    var at = trunk;
    if (i > 1 && i < 6) { at = pixel; } // the trunk's warps would stretch small spots into smears
    if (i < 5) { return gabor_impl_octave(at, vec2f(7.0, 3.5), i, 5, 0.7, gabor_derived_seed(seed, 5)); }
    if (i == 5) { return gabor_impl_spots_layer(at, vec2f(1.1, 0.7), seed, 6); }
    if (i == 6) { return gabor_impl_waves_layer(trunk, vec2f(1.7, 0.55) / 2.21 * bark.furrows, 1.3, 0.1, seed, 3); }
    return gabor_impl_waves_layer(trunk, vec2f(1.2, 1.3), 0.9, 1.5, seed, 4);
}

fn gabor_impl_bark(bark: GaborBark, of_: GaborImplPairs) -> GaborMaterial {
    let shape = of_.pair_2.first + 0.2 * of_.pair_0.first;
    let removed = of_.pair_2.removed + 0.04 * of_.pair_0.removed;
    let whole = vec3f(1.0, 0.0, 0.0) - 0.55 * gabor_impl_line(of_.pair_3.first, of_.pair_3.removed, 0.13);
    let risen = gabor_impl_above(shape, removed, -0.15, 0.35); let plate = gabor_impl_times(risen, whole);
    // Weighted by the tone exp(0.25 noise), the removed part of the noise has a mean of 0.25 times its variance.
    let weighted = of_.pair_0.second + vec3f(0.25 * of_.pair_0.removed, 0.0, 0.0);
    let worn = 0.5 * gabor_impl_above(weighted, of_.pair_0.removed, 0.5, 0.4).x;
    let covered = bark.moss_amount * gabor_impl_above(of_.pair_1.second, of_.pair_1.removed, 0.9, 0.5).x;
    let tone = gabor_impl_tone(of_.pair_0.second.x, of_.pair_0.removed, 0.25);
    let top = mix(gabor_impl_toned(bark.plate_colour, tone),
                  gabor_impl_toned(mix(bark.plate_colour, vec3f(1.0), 0.13), tone), worn);
    let moss = gabor_impl_toned(bark.moss_colour, tone);
    let colour = mix(mix(gabor_impl_toned(bark.furrow_colour, tone), moss, covered), mix(top, moss, 0.6 * covered),
                     plate.x);
    let coarse = vec3f(0.4, 0.0, 0.0) + 0.6 * plate;
    let height = bark.depth * plate + 0.018 * gabor_impl_times(of_.pair_0.first, coarse);
    // Mean squares of factors; that of a line is a line of 1/sqrt(2) times the width. `deep` is the height's derivative
    // by the plate.
    // 0.0919239 is 0.13/sqrt(2)
    let wholes = 2.0 * whole.x - 1.0 + 0.3025 * gabor_impl_line(of_.pair_3.first, of_.pair_3.removed, 0.0919239).x;
    let rises = risen.x * risen.x + risen.x * (1.0 - risen.x) * removed / (removed + 0.18);
    let deep = bark.depth + 0.0108 * of_.pair_0.first.x; let coarses = 0.16 + 0.48 * plate.x + 0.36 * wholes * rises;
    let both = 0.0072 * deep * coarse.x * whole.x * gabor_impl_above(vec3f(shape.x, 1.0, 0.0), removed, -0.15, 0.35).y;
    // 0.00011664 is 0.0108^2
    let lost = (deep * deep + 0.00011664 * of_.pair_0.removed)
              * (wholes * gabor_impl_above_lost(shape, removed, of_.pair_2.lost + 0.04 * of_.pair_0.lost, -0.15, 0.35)
                + 0.3025 * rises * gabor_impl_line_lost(of_.pair_3.first, of_.pair_3.removed, of_.pair_3.lost, 0.13))
              + (0.000324 * coarses + both) * of_.pair_0.lost;
    return gabor_impl_material(colour, height, lost, bark.roughness, 0.0);
}

fn gabor_bark_at(p: vec2f, period: vec2f, bark: GaborBark, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let trunk = gabor_impl_trunk(pixel, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 5; i++) {
        of_.pair_0 = gabor_impl_plus_octave(of_.pair_0, gabor_impl_bark_layer(i, pixel, trunk, bark, seed));
    }
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_bark_layer(5, pixel, trunk, bark, seed));
    of_.pair_2 = gabor_impl_waves_pair(gabor_impl_bark_layer(6, pixel, trunk, bark, seed));
    of_.pair_3 = gabor_impl_waves_pair(gabor_impl_bark_layer(7, pixel, trunk, bark, seed));
    return gabor_impl_bark(bark, of_);
}

// ---- Strata --------------------------------------------------------------------------------------------------------

fn gabor_impl_rock(pixel: GaborImplPixel, strata: GaborStrata, seed: u32) -> GaborImplPixel {
    let folds = vec4f(0.2, 0.016, 0.022, 0.004) * strata.folding;
    var rock = gabor_impl_warp(pixel, vec2f(0.35, 0.6), vec2f(0.0, folds.x), seed, 0);
    rock = gabor_impl_warp(rock, vec2f(1.6, 2.6), folds.yz, seed, 1);
    return gabor_impl_warp(rock, vec2f(7.0, 10.0), vec2f(folds.w), seed, 2);
}

// Four octaves of grain, and four sizes of layers: broad, band, thin, lamina.
fn gabor_impl_strata_layer(i: i32, pixel: GaborImplPixel, rock: GaborImplPixel, strata: GaborStrata, seed: u32) -> GaborImplLayer {
    if (i < 4) {
        return gabor_impl_octave(pixel, vec2f(16.0, 24.0), i, 4, 0.8, gabor_derived_seed(seed, 7));
    }
    // 0.33333333 is 1/3, 2.8333333 is 17/6 and 8.3333333 is 25/3
    let density = select(select(select(vec2f(0.6, 8.3333333), vec2f(0.25, 2.8333333), i == 6),
                                                   vec2f(0.14, 1.0), i == 5), vec2f(0.1, 0.33333333), i == 4);
    return gabor_impl_spots_layer(rock, density * vec2f(1.0, strata.layers), seed, i - 1);
}

fn gabor_impl_strata(strata: GaborStrata, of_: GaborImplPairs) -> GaborMaterial {
    let soft = gabor_impl_above(of_.pair_2.first, of_.pair_2.removed, 0.5, 0.22); // the soft layers, which erode
    let tones = gabor_impl_tone(of_.pair_4.first.x, of_.pair_4.removed, 0.13)
               + gabor_impl_tone(of_.pair_0.first.x, of_.pair_0.removed, 0.11);
    var colour = mix(gabor_impl_toned(strata.dark_rock_colour, tones),
                     gabor_impl_toned(strata.light_rock_colour, tones),
                     gabor_impl_above(of_.pair_1.first, of_.pair_1.removed, 0.0, 0.5).x);
    colour = mix(colour, gabor_impl_toned(strata.soft_layer_colour, tones), 0.8 * soft.x);
    colour = mix(colour, gabor_impl_toned(strata.thin_layer_colour, tones),
                 0.75 * gabor_impl_above(of_.pair_3.first, of_.pair_3.removed, 1.0, 0.2).x);
    colour = mix(colour, gabor_impl_toned(0.75 * strata.soft_layer_colour, tones),
                 0.6 * gabor_impl_above(of_.pair_3.second, of_.pair_3.removed, 1.3, 0.15).x);
    let height = 0.02 * of_.pair_1.second - 0.012 * soft + 0.006 * of_.pair_3.first + 0.0015 * of_.pair_4.first
                + 0.003 * of_.pair_0.second;
    let lost = 0.0004 * of_.pair_1.lost + 3.6e-5 * of_.pair_3.lost + 2.25e-6 * of_.pair_4.lost + 9.0e-6 * of_.pair_0.lost
              + 0.000144 * gabor_impl_above_lost(of_.pair_2.first, of_.pair_2.removed, of_.pair_2.lost, 0.5, 0.22);
    return gabor_impl_material(colour, strata.relief * height, strata.relief * strata.relief * lost, strata.roughness,
                               0.0);
}

fn gabor_strata_at(p: vec2f, period: vec2f, strata: GaborStrata, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_point(p, period);
    let rock = gabor_impl_rock(pixel, strata, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 4; i++) {
        of_.pair_0 = gabor_impl_plus_octave(of_.pair_0, gabor_impl_strata_layer(i, pixel, rock, strata, seed));
    }
    of_.pair_1 = gabor_impl_spots_pair(gabor_impl_strata_layer(4, pixel, rock, strata, seed));
    of_.pair_2 = gabor_impl_spots_pair(gabor_impl_strata_layer(5, pixel, rock, strata, seed));
    of_.pair_3 = gabor_impl_spots_pair(gabor_impl_strata_layer(6, pixel, rock, strata, seed));
    of_.pair_4 = gabor_impl_spots_pair(gabor_impl_strata_layer(7, pixel, rock, strata, seed));
    return gabor_impl_strata(strata, of_);
}

// ---- The same, filtered --------------------------------------------------------------------------------------------

fn gabor_wood_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, wood: GaborWood, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let board = gabor_impl_board(pixel, wood, seed);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_filtered_spots(gabor_impl_wood_layer(0, pixel, board, seed));
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_wood_layer(1, pixel, board, seed));
    of_.pair_2 = gabor_impl_filtered_spots(gabor_impl_wood_layer(2, pixel, board, seed));
    return gabor_impl_wood(board, wood, of_, seed);
}

fn gabor_fabric_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, fabric: GaborFabric, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let cloth = gabor_impl_cloth(pixel, fabric, seed);
    let count = gabor_impl_threads(pixel, fabric);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(0, cloth, count, seed));
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(1, cloth, count, seed));
    of_.pair_2 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(2, cloth, count, seed));
    of_.pair_3 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of_);
}

fn gabor_carbon_fibre_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, fibres: GaborCarbonFibre, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let cloth = gabor_impl_twill(pixel, seed);
    let count = gabor_impl_repeated(pixel, fibres.tows, 4.0);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_filtered_spots(gabor_impl_tow_layer(0, cloth, count, seed));
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of_);
}

fn gabor_leather_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, leather: GaborLeather, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let skin = gabor_impl_skin(pixel, leather, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 3; i++) {
        of_.pair_0 = gabor_impl_plus_filtered_octave(of_.pair_0, gabor_impl_leather_layer(i, pixel, skin, leather, seed));
    }
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_leather_layer(3, pixel, skin, leather, seed));
    of_.pair_2 = gabor_impl_waves_pair(gabor_impl_leather_layer(4, pixel, skin, leather, seed));
    of_.pair_3 = gabor_impl_waves_pair(gabor_impl_leather_layer(5, pixel, skin, leather, seed));
    return gabor_impl_leather(pixel, skin, leather, of_);
}

fn gabor_marble_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, marble: GaborMarble, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let stone = gabor_impl_stone(pixel, marble, seed);
    var cloud = gabor_impl_no_pair();
    for (var i = 0; i < 3; i++) {
        cloud = gabor_impl_plus_filtered_octave(cloud, gabor_impl_marble_layer(i, pixel, stone, seed));
    }
    let crystal = gabor_impl_filtered_spots(gabor_impl_marble_layer(3, pixel, stone, seed));
    var material = gabor_impl_marble(marble, cloud, crystal);
    for (var j = 4; j < 8; j++) {
        let layer = gabor_impl_marble_layer(j, pixel, stone, seed);
        gabor_impl_add_veins(&material, marble, j, gabor_impl_filtered_waves(layer));
    }
    return material;
}

fn gabor_sand_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, sand: GaborSand, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let dune = gabor_impl_dune(pixel, seed);
    let ripples = gabor_impl_sand_layer(4, pixel, dune, sand, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 3; i++) {
        of_.pair_0 = gabor_impl_plus_filtered_octave(of_.pair_0, gabor_impl_sand_layer(i, pixel, dune, sand, seed));
    }
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_sand_layer(3, pixel, dune, sand, seed));
    of_.pair_2 = gabor_impl_filtered_waves(ripples);
    return gabor_impl_sand(sand, ripples, of_);
}

fn gabor_brushed_metal_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, metal: GaborBrushedMetal, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    var of_ = gabor_impl_no_pairs();
    let layers = gabor_impl_metal_layers(metal);
    for (var i = 0; i < layers; i++) {
        let layer = gabor_impl_metal_layer(i, pixel, metal, seed);
        gabor_impl_add_metal(&of_, i, layer, gabor_impl_filtered_spots(layer));
    }
    return gabor_impl_brushed_metal(metal, of_);
}

fn gabor_scratches_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, scratches: GaborScratches, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    var sum = GaborMaterial(vec3f(1.0), 0.0, vec2f(0.0), 0.0, 0.0, vec3f(0.0));
    for (var i = 0; i < 14; i++) {
        gabor_impl_add_scratches(&sum, scratches, i,
                                 gabor_impl_filtered_spots(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    }
    return gabor_impl_scratches(scratches, sum);
}

fn gabor_zebra_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, zebra: GaborZebra, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let skin = gabor_impl_hide(pixel, seed);
    let direction = gabor_impl_stripes_direction(pixel, zebra, seed);
    var of_ = gabor_impl_no_pairs();
    of_.pair_0 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(0, pixel, skin, direction, zebra, seed));
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(1, pixel, skin, direction, zebra, seed));
    of_.pair_2 = gabor_impl_filtered_waves(gabor_impl_zebra_layer(2, pixel, skin, direction, zebra, seed));
    return gabor_impl_zebra(zebra, of_);
}

fn gabor_bark_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, bark: GaborBark, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let trunk = gabor_impl_trunk(pixel, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 5; i++) {
        of_.pair_0 = gabor_impl_plus_filtered_octave(of_.pair_0, gabor_impl_bark_layer(i, pixel, trunk, bark, seed));
    }
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_bark_layer(5, pixel, trunk, bark, seed));
    of_.pair_2 = gabor_impl_filtered_waves(gabor_impl_bark_layer(6, pixel, trunk, bark, seed));
    of_.pair_3 = gabor_impl_filtered_waves(gabor_impl_bark_layer(7, pixel, trunk, bark, seed));
    return gabor_impl_bark(bark, of_);
}

fn gabor_strata_filtered_at(p: vec2f, dx: vec2f, dy: vec2f, period: vec2f, strata: GaborStrata, seed: u32) -> GaborMaterial {
    let pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    let rock = gabor_impl_rock(pixel, strata, seed);
    var of_ = gabor_impl_no_pairs();
    for (var i = 0; i < 4; i++) {
        of_.pair_0 = gabor_impl_plus_filtered_octave(of_.pair_0, gabor_impl_strata_layer(i, pixel, rock, strata, seed));
    }
    of_.pair_1 = gabor_impl_filtered_spots(gabor_impl_strata_layer(4, pixel, rock, strata, seed));
    of_.pair_2 = gabor_impl_filtered_spots(gabor_impl_strata_layer(5, pixel, rock, strata, seed));
    of_.pair_3 = gabor_impl_filtered_spots(gabor_impl_strata_layer(6, pixel, rock, strata, seed));
    of_.pair_4 = gabor_impl_filtered_spots(gabor_impl_strata_layer(7, pixel, rock, strata, seed));
    return gabor_impl_strata(strata, of_);
}

// ---- Definitions of the other public functions ---------------------------------------------------------------------

fn gabor_roughness(material: GaborMaterial) -> f32 {
    let alpha = material.roughness * material.roughness;
    return sqrt(sqrt(min(alpha * alpha + 0.5 * (material.lost.x + material.lost.y), 1.0)));
}

fn gabor_wood_default() -> GaborWood {
    return GaborWood(vec3f(0.51, 0.283, 0.098), vec3f(0.21, 0.061, 0.027), 13.0, 1.0, 0.75, 0.5);
}
fn gabor_fabric_default() -> GaborFabric {
    return GaborFabric(vec3f(0.50, 0.43, 0.33), vec3f(0.60, 0.53, 0.42), 12.0, 1.0, 1.0, 0.85, 0.0, 0.0);
}
fn gabor_leather_default() -> GaborLeather {
    return GaborLeather(vec3f(0.20, 0.068, 0.026), vec3f(0.093, 0.016, 0.0086), 6.88, 1.0, 1.0, 0.4);
}
fn gabor_marble_default() -> GaborMarble {
    return GaborMarble(vec3f(0.80, 0.79, 0.77), vec3f(0.13, 0.135, 0.145), 1.0, 1.0, 0.25, 0.2);
}
fn gabor_sand_default() -> GaborSand {
    return GaborSand(vec3f(0.43, 0.30, 0.17), vec3f(0.60, 0.44, 0.265), 3.87, 0.055, 0.16, 0.9);
}
fn gabor_brushed_metal_default() -> GaborBrushedMetal {
    return GaborBrushedMetal(vec3f(0.55, 0.555, 0.565), vec3f(0.14, 0.33, 0.27), 9.0, 0.09, 0.0012, 0.36, 0.0);
}
fn gabor_scratches_default() -> GaborScratches {
    // 1.5707963 is pi/2 and 3.1415927 is pi
    return GaborScratches(vec3f(0.035, 0.042, 0.05), vec3f(0.60, 0.61, 0.62), 1.0, 3.0, 1.5707963, 1.5707964, 0.0014,
                          0.3);
}
fn gabor_zebra_default() -> GaborZebra {
    // 0.2967060 is 17/180 pi and 0.3490659 is 20/180 pi
    return GaborZebra(vec3f(0.70, 0.64, 0.54), vec3f(0.018, 0.014, 0.012), 1.96, 0.2967060, 0.3490659, 1.0, 0.7);
}
fn gabor_bark_default() -> GaborBark {
    return GaborBark(vec3f(0.20, 0.145, 0.10), vec3f(0.025, 0.014, 0.008), vec3f(0.10, 0.13, 0.045), 2.21, 0.35, 0.08,
                     0.9);
}
fn gabor_carbon_fibre_default() -> GaborCarbonFibre {
    return GaborCarbonFibre(vec3f(0.028, 0.029, 0.031), 4.0, 0.3, 1.0, 0.3);
}
fn gabor_strata_default() -> GaborStrata {
    return GaborStrata(vec3f(0.50, 0.22, 0.09), vec3f(0.60, 0.35, 0.18), vec3f(0.28, 0.075, 0.035), vec3f(0.74, 0.58, 0.40),
                       6.0, 1.0, 1.0, 0.9);
}

fn gabor_wood(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_wood_at(p, vec2f(0.0), gabor_wood_default(), seed);
}
fn gabor_fabric(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_fabric_at(p, vec2f(0.0), gabor_fabric_default(), seed);
}
fn gabor_leather(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_leather_at(p, vec2f(0.0), gabor_leather_default(), seed);
}
fn gabor_marble(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_marble_at(p, vec2f(0.0), gabor_marble_default(), seed);
}
fn gabor_sand(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_sand_at(p, vec2f(0.0), gabor_sand_default(), seed);
}
fn gabor_brushed_metal(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_brushed_metal_at(p, vec2f(0.0), gabor_brushed_metal_default(), seed);
}
fn gabor_scratches(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_scratches_at(p, vec2f(0.0), gabor_scratches_default(), seed);
}
fn gabor_zebra(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_zebra_at(p, vec2f(0.0), gabor_zebra_default(), seed);
}
fn gabor_bark(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_bark_at(p, vec2f(0.0), gabor_bark_default(), seed);
}
fn gabor_carbon_fibre(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_carbon_fibre_at(p, vec2f(0.0), gabor_carbon_fibre_default(), seed);
}
fn gabor_strata(p: vec2f, seed: u32) -> GaborMaterial {
    return gabor_strata_at(p, vec2f(0.0), gabor_strata_default(), seed);
}

fn gabor_wood_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_wood_filtered_at(p, dx, dy, vec2f(0.0), gabor_wood_default(), seed);
}
fn gabor_fabric_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_fabric_filtered_at(p, dx, dy, vec2f(0.0), gabor_fabric_default(), seed);
}
fn gabor_leather_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_leather_filtered_at(p, dx, dy, vec2f(0.0), gabor_leather_default(), seed);
}
fn gabor_marble_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_marble_filtered_at(p, dx, dy, vec2f(0.0), gabor_marble_default(), seed);
}
fn gabor_sand_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_sand_filtered_at(p, dx, dy, vec2f(0.0), gabor_sand_default(), seed);
}
fn gabor_brushed_metal_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_brushed_metal_filtered_at(p, dx, dy, vec2f(0.0), gabor_brushed_metal_default(), seed);
}
fn gabor_scratches_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_scratches_filtered_at(p, dx, dy, vec2f(0.0), gabor_scratches_default(), seed);
}
fn gabor_zebra_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_zebra_filtered_at(p, dx, dy, vec2f(0.0), gabor_zebra_default(), seed);
}
fn gabor_bark_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_bark_filtered_at(p, dx, dy, vec2f(0.0), gabor_bark_default(), seed);
}
fn gabor_carbon_fibre_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_carbon_fibre_filtered_at(p, dx, dy, vec2f(0.0), gabor_carbon_fibre_default(), seed);
}
fn gabor_strata_filtered(p: vec2f, dx: vec2f, dy: vec2f, seed: u32) -> GaborMaterial {
    return gabor_strata_filtered_at(p, dx, dy, vec2f(0.0), gabor_strata_default(), seed);
}
