// gabor_materials.glsl: eleven materials from Gabor noise.
//
// Paste or include this file after gabor_noise.glsl, gabor_spectrum.glsl and gabor_fractal.glsl.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, slope, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dFdx(p), dFdy(p), 7u);  // averaged over a pixel
//
//     GaborWood oak = gabor_wood_default();                            // your own parameters, which may vary per pixel
//     oak.rings = 20.0;
//     GaborMaterial o = gabor_wood_at(p, vec2(0.0), oak, 7u);
//
//     I want                                   call
//     a material                               gabor_wood, gabor_fabric, gabor_leather, gabor_marble and so on
//     the same without moire, at any distance  gabor_wood_filtered(p, dFdx(p), dFdy(p), seed)
//     my own colours, sizes and periods        gabor_wood_at, gabor_wood_filtered_at
//     a normal                                 normalize(vec3(-m.slope, 1.0)), in the space of p
//     highlights that stay right far away      gabor_roughness(m) instead of m.roughness
//
// One unit of p spans a characteristic piece of a material; a picture of four by four units shows the material well.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#if !defined(GABOR_SPECTRUM_GLSL) || !defined(GABOR_FRACTAL_GLSL)
#error Include gabor_noise.glsl, gabor_spectrum.glsl and gabor_fractal.glsl before gabor_materials.glsl
#endif
#ifndef GABOR_MATERIALS_GLSL
#define GABOR_MATERIALS_GLSL 1

struct GaborMaterial {
    vec3 colour;     // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // height in units of p
    vec2 slope;      // derivatives of the height along x and y
    float roughness; // roughness as in glTF, without what the filter removed
    float metalness; // 0 or 1, or between them at the edges of patina
    vec3 lost;       // covariance of the slopes that the filter removed: xx, yy, xy
};

// float gabor_roughness(GaborMaterial material)
//     The roughness with `lost`, for shading without anisotropy. With alpha = roughness^2 as in GGX, alpha^2 grows by
//     half of the variance of the removed slopes: with this share, GGX reflects a room most nearly as the relief does.

// ---- Materials -----------------------------------------------------------------------------------------------------
//
// Each has a struct of parameters and these functions, here for wood:
//
// GaborWood gabor_wood_default()
// GaborMaterial gabor_wood(vec2 p, uint seed)
// GaborMaterial gabor_wood_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_wood_at(vec2 p, vec2 period, GaborWood wood, uint seed)
// GaborMaterial gabor_wood_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborWood wood, uint seed)
//
// The first two take the default parameters. The filtered ones average over a pixel; dx and dy are dFdx(p) and dFdy(p).
// Far away, their slopes and `lost` have 0.8 to 1.25 times the energy of the plain slopes. `period` is in units of p,
// along both axes, or vec2(0.0) for none: a period holds a whole number of rings or threads, and scratches and hair
// snap to directions that fit it.
//
// Colours are linear, from 0 to 1. Brackets give the number of noises, and the shortest period at which the tiled
// material looks like the untiled one; shorter periods compress its large-scale variation. The grain of wood and bark
// and the streaks of metal follow p: bend p to bend them. Directions may vary from pixel to pixel.

// A board cut beside the pith: growth rings, pores and fibres along y [6 noises; period 3 x 9].
struct GaborWood {
    vec3 earlywood_colour; // colour of the early wood
    vec3 latewood_colour;  // colour of the late wood
    float rings;           // growth rings per unit, 2 to 60
    float waviness;        // how much the rings bend, 0 to 3
    float pore_strength;   // strength of the pores, 0 to 1
    float roughness;       // roughness of the early wood, 0 to 1
};

// Linen, a plain weave of uneven threads; twill or herringbone; or corduroy, whose cords run along y [5 noises; period
// 3 x 3].
struct GaborFabric {
    vec3 warp_colour; // colour of the threads along y
    vec3 weft_colour; // colour of the threads along x
    float threads;    // threads per unit, 2 to 60
    float unevenness; // unevenness of the threads' thickness, shade and course, 0 to 2
    float relief;     // height of the weave and of the cords, relative to the default, 0 to 3
    float roughness;  // 0 to 1
    float cords;      // cords per unit, 0 to 20
    float weave;      // plain weave 0, twill 1, herringbone 2, 0 to 2
};

// Pebbled grain: wrinkled cells with pores, between creases [8 noises; period 3 x 3].
struct GaborLeather {
    vec3 pebble_colour; // colour of the cells
    vec3 crease_colour; // colour between the cells
    float cells;        // cells per unit, 2 to 30
    float waviness;     // how much the rows of cells bend, 0 to 3
    float relief;       // height of the cells, relative to the default, 0 to 3
    float roughness;    // roughness of the cells, 0 to 0.7
};

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    vec3 stone_colour;    // colour of the stone
    vec3 vein_colour;     // colour of the darkest veins
    float vein_strength;  // strength of the veins, 0 to 1.3
    float turbulence;     // how much the veins bend, 0 to 2
    float cloud_strength; // darkening by clouds, 0 to 1
    float roughness;      // 0 to 1
};

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    vec3 trough_colour;   // colour of the troughs
    vec3 crest_colour;    // colour of the crests
    float ripples;        // ripples per unit, 1 to 20
    float ripple_height;  // height of the ripples, in units, 0 to 0.2
    float grain_contrast; // contrast of the grains, 0 to 0.25
    float roughness;      // 0 to 1
};

// Streaks along x, and patina [5 noises, 11 with patina; period 5 x 1].
struct GaborBrushedMetal {
    vec3 metal_colour;     // colour of the metal
    vec3 patina_colour;    // colour of the patina
    float streaks;         // number of the widest streaks per unit, 1 to 50
    float streak_contrast; // contrast of the streaks, 0 to 0.5
    float streak_height;   // height of the widest streaks, in units, 0 to 0.01
    float roughness;       // roughness of the metal, 0 to 1
    float patina_amount;   // amount of patina, 0 to 1
};

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    vec3 lacquer_colour;     // colour of the lacquer
    vec3 scratch_colour;     // colour in the scratches
    float amount;            // number of scratches, relative to the default, 0.01 to 8
    float scratch_length;    // length of the scratches, in units, 0.3 to 10
    float scratch_direction; // mean direction along the scratches, -6.2832 to 6.2832 radians
    float direction_spread;  // half-width of the range of their directions, 0 to 1.5708 radians: pi/2 for all
    float depth;             // depth of the scratches, in units, 0 to 0.02
    float roughness;         // 0 to 1
};

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    vec3 background_colour; // colour between the stripes
    vec3 stripe_colour;     // colour of the stripes
    float stripes;          // stripes per unit, 0.5 to 20
    float orientation;      // direction across the stripes, as that of a wave vector, -6.2832 to 6.2832 radians
    float bend_angle;       // how much the stripes' direction changes, 0 to 1.5708 radians
    float hair_contrast;    // contrast of the hair, 0 to 3
    float roughness;        // 0 to 1
};

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    vec3 plate_colour;  // colour of the plates
    vec3 furrow_colour; // colour of the furrows
    vec3 moss_colour;   // colour of the moss
    float furrows;      // furrows per unit, 0.5 to 10
    float moss_amount;  // amount of moss, 0 to 1
    float depth;        // depth of the furrows, in units, 0 to 0.4
    float roughness;    // 0 to 1
};

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    vec3 colour;          // colour of the fibres
    float tows;           // tows per unit, 1 to 20
    float fibre_contrast; // contrast of the fibres, 0 to 0.6
    float relief;         // height of the tows, relative to the default, 0 to 3
    float roughness;      // 0 to 1
};

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    vec3 dark_rock_colour;  // colour of the darker rock
    vec3 light_rock_colour; // colour of the lighter rock
    vec3 soft_layer_colour; // colour of the soft layers
    vec3 thin_layer_colour; // colour of the thin layers
    float layers;           // layers per unit, 1 to 30
    float folding;          // how much the layers bend, 0 to 3
    float relief;           // height of the layers, relative to the default, 0 to 3
    float roughness;        // 0 to 1
};

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
vec3 gabor_impl_times(vec3 a, vec3 b) {
    return vec3(a.x * b.x, a.x * b.yz + b.x * a.yz);
}

// The matrix v v^T: xx, yy, xy.
vec3 gabor_impl_square(vec2 v) {
    return vec3(v * v, v.x * v.y);
}

// (x y)^T M (x y), where M has the elements xx, yy, xy.
vec3 gabor_impl_turned_square(vec3 m, vec2 x, vec2 y) {
    vec2 a = m.xy * x + m.z * x.yx, b = m.xy * y + m.z * y.yx;
    return vec3(dot(x, a), dot(y, b), dot(x, b));
}

// ---- Positions -----------------------------------------------------------------------------------------------------

// A position, its derivatives along the plane's x and y, the steps (dx, dy) to the next pixels, which are 0 without a
// filter, and the period, 0 for none. Warps move it and bend the steps. A warp that a filter removed still steepens
// slopes: the gradient of position.x has the mean (by_x.x, by_y.x) and the covariance lost_x, as xx, yy, xy; that of
// position.y has lost_y, and nearly no covariance with the other.
struct GaborImplPixel {
    vec2 position;
    vec2 by_x;
    vec2 by_y;
    bool filtered;
    vec2 dx;
    vec2 dy;
    vec2 period;
    vec3 lost_x;
    vec3 lost_y;
};

GaborImplPixel gabor_impl_pixel_of(bool filtered, vec2 p, vec2 dx, vec2 dy, vec2 period) {
    p -= period.x > 0.0 ? period * floor(p / period) : vec2(0.0);
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = vec2(1.0e3, 0.0);
        dy = vec2(0.0, 1.0e3);
    }
    return GaborImplPixel(p, vec2(1.0, 0.0), vec2(0.0, 1.0), filtered, dx, dy, period, vec3(0.0), vec3(0.0));
}

GaborImplPixel gabor_impl_point(vec2 p, vec2 period) {
    return gabor_impl_pixel_of(false, p, vec2(0.0), vec2(0.0), period);
}

// A position along the warped x or y axis, with derivatives.
vec3 gabor_impl_along_x(GaborImplPixel at) {
    return vec3(at.position.x, at.by_x.x, at.by_y.x);
}
vec3 gabor_impl_along_y(GaborImplPixel at) {
    return vec3(at.position.y, at.by_x.y, at.by_y.y);
}

// The place of a layer with `density` kernel radii per unit along x and y.
GaborPlace gabor_impl_place(GaborImplPixel at, vec2 density) {
    if (at.period.x > 0.0)
        return gabor_place_tiled(density * at.position, density * at.period);
    return gabor_place_at(density * at.position);
}

// Adds a row of three nodes to two noises, (quadrature, noise), and to their derivatives along x and y.
void gabor_impl_add_spots(inout vec2 value, inout vec4 slope, GaborImplLine x, uint word, float even,
                          float even_slope) {
    uvec4 words = x.word * word;
    vec2 a = gabor_impl_amplitude(words.x), b = gabor_impl_amplitude(words.y), c = gabor_impl_amplitude(words.z);
    vec2 row = x.even.x * a + x.even.y * b + x.even.z * c;
    value += even * row;
    slope += vec4(even * (x.even_slope.x * a + x.even_slope.y * b + x.even_slope.z * c), even_slope * row);
}

// Adds a row of four nodes.
void gabor_impl_add_four_spots(inout vec2 value, inout vec4 slope, GaborImplLine x, uint word, float even,
                               float even_slope) {
    gabor_impl_add_spots(value, slope, x, word, even, even_slope);
    vec2 d = gabor_impl_amplitude(x.word.w * word), last = x.even.w * d;
    value += even * last;
    slope += vec4(even * x.even_slope.w * d, even_slope * last);
}

GaborField gabor_impl_spots_field(vec2 value, vec4 slope, float scale, vec2 stretch) {
    return GaborField(scale * value.y, stretch * slope.yw, scale * value.x, stretch * slope.xz, 0.0);
}

// Noise of frequency 0, which needs no waves: spots as large as a kernel. The same as gabor_field.
GaborField gabor_impl_spots(GaborPlace place, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborImplLine x = gabor_impl_smooth_line(place.cell.x, place.local.x, place.period.x, salt);
    GaborImplLine y = gabor_impl_smooth_line(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS);
    vec2 value = vec2(0.0);
    vec4 slope = vec4(0.0);
    gabor_impl_add_spots(value, slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_spots(value, slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_spots(value, slope, x, y.word.z, y.even.z, y.even_slope.z);
    float scale = 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// The steps (dx, dy) to the next pixels, in kernel radii of a noise with this density.
vec4 gabor_impl_radii(GaborImplPixel at, vec2 density) {
    return vec4(density * at.dx, density * at.dy);
}

// Moves the position by two noises. Noises that are finer than the pixel move it only as much as a filter keeps of
// their slopes. They bend dx and dy even less, for two reasons: slopes at one point are not those of the whole pixel,
// and the slopes of a filtered height leave out how the steps change.
GaborImplPixel gabor_impl_warp(GaborImplPixel at, vec2 density, vec2 amplitude, uint seed, int index) {
    vec4 steps = gabor_impl_radii(at, density);
    float size = min(dot(steps, steps), 1.0e6), bend = 1.0 / (1.0 + 64.0 * size);
    vec2 whole = amplitude * amplitude;
    amplitude /= 1.0 + 0.82246703 * size; // pi^2 / 12
    GaborField field = gabor_impl_spots(gabor_impl_place(at, density), gabor_derived_seed(seed, index));
    vec2 along_x = amplitude * density.x * vec2(field.quadrature_gradient.x, field.gradient.x);
    vec2 along_y = amplitude * density.y * vec2(field.quadrature_gradient.y, field.gradient.y);
    vec3 lost_x = vec3(0.0), lost_y = vec3(0.0);
    if (at.filtered) {
        vec2 power = 3.2898681 * density * density; // pi^2 / 3, the noises' mean square gradient
        vec3 lost = power.x * (gabor_impl_square(vec2(at.by_x.x, at.by_y.x)) + at.lost_x)
                  + power.y * (gabor_impl_square(vec2(at.by_x.y, at.by_y.y)) + at.lost_y);
        whole -= amplitude * amplitude;
        lost_x = (1.0 + along_x.x) * (1.0 + along_x.x) * at.lost_x + along_y.x * along_y.x * at.lost_y + whole.x * lost;
        lost_y = along_x.y * along_x.y * at.lost_x + (1.0 + along_y.y) * (1.0 + along_y.y) * at.lost_y + whole.y * lost;
    }
    return GaborImplPixel(at.position + amplitude * vec2(field.quadrature, field.noise),
                          at.by_x + at.by_x.x * along_x + at.by_x.y * along_y,
                          at.by_y + at.by_y.x * along_x + at.by_y.y * along_y, at.filtered,
                          at.dx + bend * (at.dx.x * along_x + at.dx.y * along_y),
                          at.dy + bend * (at.dy.x * along_x + at.dy.y * along_y), at.period, lost_x, lost_y);
}

// The covariance of the slopes in the plane that warps lost of a layer or profile, whose slopes along the warped axes
// have these mean squares.
vec3 gabor_impl_warp_lost(GaborImplPixel at, vec2 power) {
    return power.x * at.lost_x + power.y * at.lost_y;
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
GaborImplPixel gabor_impl_turned(GaborImplPixel at, float angle) {
    vec2 turn = gabor_impl_wave(0.15915494 * angle); // 1/(2 pi)
    vec2 x = turn;
    vec2 y = vec2(-turn.y, turn.x);
    vec2 period = vec2(0.0);
    if (at.period.x > 0.0) {
        vec2 whole = floor(3.0 * normalize(turn / at.period) + 0.5);
        vec2 size = abs(whole);
        vec2 signs = vec2(whole.x < 0.0 ? -1.0 : 1.0, whole.y < 0.0 ? -1.0 : 1.0);
        if (size.x == size.y || size.x * size.y == 0.0) // (2, 2), (3, 0), (0, 3) become (1, 1), (1, 0), (0, 1)
            whole = signs * min(size, vec2(1.0));
        size = abs(whole);
        vec2 other = size.x > 1.0 && size.y > 1.0 ? (size.x > size.y ? signs : -signs)
                     : size.x == 1.0              ? vec2(0.0, whole.x)
                                                  : vec2(-whole.y, 0.0);
        period.x = length(whole * at.period);
        period.y = at.period.x * at.period.y / period.x;
        x = period.x * vec2(other.y, -other.x) / at.period;
        y = period.y * vec2(-whole.y, whole.x) / at.period;
    }
    return GaborImplPixel(vec2(dot(x, at.position), dot(y, at.position)), vec2(dot(x, at.by_x), dot(y, at.by_x)),
                          vec2(dot(x, at.by_y), dot(y, at.by_y)), at.filtered,
                          vec2(dot(x, at.dx), dot(y, at.dx)), vec2(dot(x, at.dy), dot(y, at.dy)), period,
                          x.x * x.x * at.lost_x + x.y * x.y * at.lost_y, y.x * y.x * at.lost_x + y.y * y.y * at.lost_y);
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
vec2 gabor_impl_repeated(GaborImplPixel pixel, float count, float whole) {
    if (pixel.period.x > 0.0)
        return max(floor(pixel.period * (count / whole) + 0.5), vec2(1.0)) * whole / pixel.period;
    return vec2(count);
}

// What a pixel keeps of a sine along x that repeats `count` times per unit.
float gabor_impl_sine_kept(GaborImplPixel at, float count) {
    return exp(-min(4.9348022 * count * count * (at.dx.x * at.dx.x + at.dy.x * at.dy.x), 40.0)); // pi^2 / 2
}

// ---- Layers --------------------------------------------------------------------------------------------------------

// A noise with `density` kernel radii per unit along x and y, a wave vector per kernel radius, and its amplitude in a
// sum.
struct GaborImplLayer {
    GaborImplPixel at;
    vec2 density;
    vec2 wave;
    float amplitude;
    uint seed;
};

// A layer of frequency 0.
GaborImplLayer gabor_impl_spots_layer(GaborImplPixel at, vec2 density, uint seed, int index) {
    return GaborImplLayer(at, density, vec2(0.0), 1.0, gabor_derived_seed(seed, index));
}

GaborImplLayer gabor_impl_waves_layer(GaborImplPixel at, vec2 density, float frequency, float orientation,
                                      uint seed, int index) {
    return GaborImplLayer(at, density, gabor_wave_vector(frequency, orientation), 1.0,
                          gabor_derived_seed(seed, index));
}

// Octave i of `count`, each with spots of about half the previous size and `gain` times the amplitude.
GaborImplLayer gabor_impl_octave(GaborImplPixel at, vec2 density, int i, int count, float gain, uint seed) {
    float power = (1.0 - pow(gain, 2.0 * float(count))) / (1.0 - gain * gain);
    // 1.0214797 is ln 2.03 / ln 2
    return GaborImplLayer(at, density * exp2(1.0214797 * float(i)), vec2(0.0),
                          pow(gain, float(i)) * inversesqrt(power), gabor_derived_seed(seed, i));
}

// Two independent noises with their derivatives along x and y of p, the quadrature and noise of a layer's field; the
// share of their variance that a filter removed, and the covariance of their derivatives that it removed.
struct GaborImplPair {
    vec3 first;
    vec3 second;
    float removed;
    vec3 lost;
};

// All pairs of noises that one material needs.
struct GaborImplPairs {
    GaborImplPair pair_0;
    GaborImplPair pair_1;
    GaborImplPair pair_2;
    GaborImplPair pair_3;
    GaborImplPair pair_4;
};

GaborImplPair gabor_impl_no_pair() {
    return GaborImplPair(vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
}

GaborImplPairs gabor_impl_no_pairs() {
    GaborImplPair none = gabor_impl_no_pair();
    return GaborImplPairs(none, none, none, none, none);
}

// `whole` is the covariance of the plain field's gradient, and `left` what is left of it.
GaborImplPair gabor_impl_pair(GaborImplLayer layer, GaborField field, vec3 whole, vec3 left) {
    vec2 x = layer.density * layer.at.by_x, y = layer.density * layer.at.by_y;
    vec3 lost = vec3(0.0);
    if (layer.at.filtered)
        lost = gabor_impl_turned_square(whole - left, x, y)
             + gabor_impl_warp_lost(layer.at, layer.density * layer.density * whole.xy);
    return GaborImplPair(vec3(field.quadrature, dot(field.quadrature_gradient, x), dot(field.quadrature_gradient, y)),
                         vec3(field.noise, dot(field.gradient, x), dot(field.gradient, y)), field.removed, lost);
}

GaborImplPair gabor_impl_plus(GaborImplPair sum, GaborImplPair pair, float amplitude) {
    return GaborImplPair(sum.first + amplitude * pair.first, sum.second + amplitude * pair.second,
                         sum.removed + amplitude * amplitude * pair.removed,
                         sum.lost + amplitude * amplitude * pair.lost);
}

// What a filter does to a layer. Nearly, the window of a node is a Gaussian of variance v = 3/(2 pi^2), and its wave
// exp(2 pi i F.d). A filter of covariance S widens the window to v + S, turns the wave vector F into
// K = (1 + S/v)^-1 F, and leaves the share exp(-6 F.(F - K)) / sqrt(|1 + S/v|) of the variance.
struct GaborImplKept {
    vec2 wave;
    float share;
    vec2 widened; // S/v along x and y
};

GaborImplKept gabor_impl_kept(GaborImplLayer layer) {
    vec4 steps = gabor_impl_radii(layer.at, layer.density);
    vec3 s = 1.6449341 * (gabor_impl_square(steps.xy) + gabor_impl_square(steps.zw)); // pi^2 / 6
    float d = (1.0 + s.x) * (1.0 + s.y) - s.z * s.z;
    vec2 wave = ((1.0 + s.yx) * layer.wave - s.z * layer.wave.yx) / d;
    return GaborImplKept(wave, exp(-6.0 * dot(layer.wave, layer.wave - wave)) * inversesqrt(d), s.xy);
}

GaborImplPair gabor_impl_spots_pair(GaborImplLayer layer) {
    return gabor_impl_pair(layer, gabor_impl_spots(gabor_impl_place(layer.at, layer.density), layer.seed), vec3(0.0),
                           vec3(0.0));
}

// A sum and an octave of it.
GaborImplPair gabor_impl_plus_octave(GaborImplPair sum, GaborImplLayer layer) {
    return gabor_impl_plus(sum, gabor_impl_spots_pair(layer), layer.amplitude);
}

GaborImplPair gabor_impl_waves_pair(GaborImplLayer layer) {
    return gabor_impl_pair(layer, gabor_field(gabor_impl_place(layer.at, layer.density), layer.wave, layer.seed),
                           vec3(0.0), vec3(0.0));
}

// The same, filtered with the windows of gabor_fractal.glsl.
GaborImplPair gabor_impl_filtered_spots(GaborImplLayer layer) {
    GaborPlace place = gabor_impl_place(layer.at, layer.density);
    GaborImplKept kept = gabor_impl_kept(layer);
    // 0.34195899 is 27/(8 pi^2)
    vec2 inverse_width = vec2(gabor_impl_inverse_width(0.34195899 * kept.widened.x),
                              gabor_impl_inverse_width(0.34195899 * kept.widened.y));
    uint salt = gabor_impl_salt(layer.seed);
    GaborImplLine x =
        gabor_impl_smooth_line_filtered(place.cell.x, place.local.x, place.period.x, salt, inverse_width.x);
    GaborImplLine y = gabor_impl_smooth_line_filtered(place.cell.y, place.local.y, place.period.y,
                                                      salt ^ GABOR_IMPL_ROWS, inverse_width.y);
    // 1.7777778 is 16/9: see gabor_impl_smooth_line_filtered
    float scale = sqrt(1.7777778 * kept.share * inverse_width.x * inverse_width.y) / GABOR_IMPL_DEVIATION;
    vec2 value = vec2(0.0);
    vec4 slope = vec4(0.0);
    gabor_impl_add_four_spots(value, slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_four_spots(value, slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_four_spots(value, slope, x, y.word.z, y.even.z, y.even_slope.z);
    gabor_impl_add_four_spots(value, slope, x, y.word.w, y.even.w, y.even_slope.w);
    GaborField field = gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius);
    field.removed = 1.0 - kept.share;
    // 3.2898681 is pi^2 / 3 and 7.4022033 is 3/4 pi^2; the plain windows have a half-width of 3/2
    return gabor_impl_pair(layer, field, vec3(3.2898681, 3.2898681, 0.0),
                           vec3(7.4022033 * kept.share * inverse_width * inverse_width, 0.0));
}

GaborImplPair gabor_impl_plus_filtered_octave(GaborImplPair sum, GaborImplLayer layer) {
    return gabor_impl_plus(sum, gabor_impl_filtered_spots(layer), layer.amplitude);
}

// Filtered waves have the plain windows: where others would fit better, little is left.
GaborImplPair gabor_impl_filtered_waves(GaborImplLayer layer) {
    GaborImplKept kept = gabor_impl_kept(layer);
    GaborField field = GaborField(0.0, vec2(0.0), 0.0, vec2(0.0), 0.0);
    gabor_impl_add_field(field, gabor_field(gabor_impl_place(layer.at, layer.density), kept.wave, layer.seed),
                         sqrt(kept.share), vec2(1.0));
    field.removed = 1.0 - kept.share;
    // 3.2898681 is pi^2 / 3 and 39.478418 is 4 pi^2
    vec3 spots = vec3(3.2898681, 3.2898681, 0.0);
    return gabor_impl_pair(layer, field, spots + 39.478418 * gabor_impl_square(layer.wave),
                           kept.share * (spots + 39.478418 * gabor_impl_square(kept.wave)));
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// The normal distribution function, within 2e-5.
float gabor_impl_below(float x) {
    x = clamp(x, -8.0, 8.0);
    // fit: see tools/constants.py
    return 1.0 / (1.0 + exp2(-x * (2.301726 + x * x * (0.1061787 - 0.00091164 * x * x))));
}

// A soft threshold: the normal distribution function of (noise - threshold) / softness.
vec3 gabor_impl_above(vec3 noise, float removed, float threshold, float softness) {
    float scale = inversesqrt(softness * softness + removed);
    float x = scale * noise.x - scale * threshold;
    return vec3(gabor_impl_below(x), 0.39894228 * scale * exp(-0.5 * min(x * x, 100.0)) * noise.yz); // 1/sqrt(2 pi)
}

// What the filter removed of a mean square: 0 without a filter, in spite of rounding.
float gabor_impl_removed_square(float square, float mean, float removed) {
    return removed > 0.0 ? max(square - mean * mean, 0.0) : 0.0;
}

// The variance that the filter removed of the threshold itself, nearly.
float gabor_impl_above_variance(float above, float removed, float softness) {
    return above * (1.0 - above) * removed / (removed + 1.5 * softness * softness);
}

// The covariance of its slopes that the filter removed.
vec3 gabor_impl_above_lost(vec3 noise, float removed, vec3 lost, float threshold, float softness) {
    float scale = inversesqrt(softness * softness + removed), variance = 0.5 * softness * softness + removed;
    float d = (noise.x - threshold) * (noise.x - threshold);
    float mean = 0.39894228 * scale * exp(-0.5 * min(d * scale * scale, 100.0)); // 1/sqrt(2 pi)
    // 0.11253954 is 1/(2 pi sqrt(2))
    float square = 0.11253954 / softness * inversesqrt(variance) * exp(-0.5 * min(d / variance, 100.0));
    return square * lost + gabor_impl_removed_square(square, mean, removed) * gabor_impl_square(noise.yz);
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
vec3 gabor_impl_line(vec3 noise, float removed, float width) {
    float variance = width * width + removed;
    float line = width * inversesqrt(variance) * exp(-0.5 * min(noise.x * noise.x / variance, 100.0));
    return line * vec3(1.0, -noise.x / variance * noise.yz);
}

// The covariance of its slopes that the filter removed.
vec3 gabor_impl_line_lost(vec3 noise, float removed, vec3 lost, float width) {
    float half_square = 0.5 * width * width, variance = half_square + removed;
    float mean = noise.x * half_square / variance, spread = half_square * removed / variance;
    float square = sqrt(half_square / variance) * exp(-0.5 * min(noise.x * noise.x / variance, 100.0))
                 * (mean * mean + spread) / (4.0 * half_square * half_square);
    vec3 slope = gabor_impl_line(vec3(noise.x, 1.0, 0.0), removed, width);
    return square * lost + gabor_impl_removed_square(square, slope.y, removed) * gabor_impl_square(noise.yz);
}

// A factor of mean 1, exp(contrast noise - contrast^2 / 2), as its logarithm and the variance of the logarithm that the
// filter removed. A product of factors is the sum of their vectors.
vec2 gabor_impl_tone(float noise, float removed, float contrast) {
    return vec2(contrast * noise - 0.5 * contrast * contrast, contrast * contrast * removed);
}

// The mean of min(colour * tone, 1). If the logarithm of X is normal with mean m and variance r, and P is the normal
// distribution function, the mean of min(c X, 1) is c e^(m + r/2) P(d - sqrt(r)) + 1 - P(d), where d = -(ln c + m) /
// sqrt(r). Where d > 3, this is nearly the mean of c X: if all of a colour is so dark, only its first part gets the
// rest. Materials mix colours after this, so that means remain right.
vec3 gabor_impl_toned(vec3 colour, vec2 tone) {
    vec3 mean = colour * exp(tone.x + 0.5 * tone.y);
    if (tone.y > 0.0) {
        float s = sqrt(tone.y);
        int parts = max(max(colour.x, colour.y), colour.z) * exp(tone.x + 3.0 * s) > 1.0 ? 3 : 1, i = 0;
        do { // a loop, because drivers for CPUs run both sides of a branch
            float d = (-tone.x - log(max(colour.x, 1.0e-6))) / s;
            mean = vec3(mean.yz, mean.x * gabor_impl_below(d - s) + 1.0 - gabor_impl_below(d));
            colour = colour.yzx;
        } while (++i < parts);
        if (parts == 1) mean = mean.zxy;
    }
    return min(mean, 1.0);
}

// The square of a sawtooth that rises from 0 to 1, averaged over the phases that a vector of length `span` stands for:
// see gabor_impl_ends_at. `phase` is in turns.
vec3 gabor_impl_rise(vec3 phase, vec3 span) {
    vec3 ends = gabor_impl_ends_at(phase.x, span.x);
    vec2 turns = floor(ends.xy), t = ends.xy - turns, integral = 0.33333333 * (turns + t * t * t); // 1/3
    float mean = ends.z * (integral.y - integral.x), change = ends.z * (t.y * t.y - t.x * t.x);
    // The change with the width, which is about 0.78 sqrt(1 - span).
    float widen = ends.z * (0.5 * (t.y * t.y + t.x * t.x) - mean) * (-0.5 / (ends.z * max(1.0 - span.x, 0.001)));
    return vec3(mean, change * phase.yz + widen * span.yz);
}

// The variance of its slope per turn over the phases that the filter added; at a span of `full`, it added none. Where
// the sawtooth rises, over a share 1 - w of the phases, its slope is 2 t; where it falls, over w, it is
// -(1 - w) (1 - w + 2 t) / w, with t from 0 to w.
float gabor_impl_rise_lost(float phase, float span, float full) {
    vec3 ends = gabor_impl_ends_at(phase, span);
    vec2 turns = floor(ends.xy), t = ends.xy - turns;
    float w = 1.0 / gabor_impl_ends_at(0.0, full).z, rise = 1.0 - w;
    // 1.3333333 is 4/3 and 0.33333333 is 1/3
    float risen = 1.3333333 - w * (2.0 - w + 0.33333333 * w * w), fallen = rise * rise * (1.0 / w + 0.33333333 * w);
    vec2 integral = risen * (turns + t * t * t) + fallen * turns;
    float change = ends.z * (t.y * t.y - t.x * t.x);
    return max(ends.z * (integral.y - integral.x) - change * change, 0.0)
         * sqrt(max(1.0 - span * span / (full * full), 0.0)); // an edge loses in proportion to the blur's length
}

// A smoothstep from `low` to `high`.
vec3 gabor_impl_step(float low, float high, vec3 x) {
    float t = clamp((x.x - low) / (high - low), 0.0, 1.0);
    return vec3(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (high - low) * x.yz);
}

GaborMaterial gabor_impl_material(vec3 colour, vec3 height, vec3 lost, float roughness, float metalness) {
    return GaborMaterial(clamp(colour, 0.0, 1.0), height.x, height.yz, roughness, metalness, lost);
}

// ---- Wood ----------------------------------------------------------------------------------------------------------
//
// Rings are lines of constant x that noise of low frequency bends until they close.

GaborImplPixel gabor_impl_board(GaborImplPixel pixel, GaborWood wood, uint seed) {
    vec2 bends = vec2(0.43, 0.018) * wood.waviness;
    GaborImplPixel board = gabor_impl_warp(pixel, vec2(1.1, 0.24), vec2(bends.x, 0.0), seed, 0);
    return gabor_impl_warp(board, vec2(4.0, 0.9), vec2(bends.y, 0.0), seed, 1);
}

// Pores, fibres and tone.
GaborImplLayer gabor_impl_wood_layer(int i, GaborImplPixel pixel, GaborImplPixel board, uint seed) {
    if (i == 2) return gabor_impl_spots_layer(board, vec2(3.5, 0.35), seed, 5);
    return gabor_impl_spots_layer(pixel, i == 0 ? vec2(90.0, 4.5) : vec2(150.0, 2.0), seed, 3 + i);
}

GaborMaterial gabor_impl_wood(GaborImplPixel board, GaborWood wood, GaborImplPairs of, uint seed) {
    board = gabor_impl_warp(board, vec2(6.5, 0.08), vec2(0.455 / wood.rings, 0.0), seed, 2);
    float rings = gabor_impl_repeated(board, wood.rings, 1.0).x;
    vec3 years = rings * gabor_impl_along_x(board); // the number of rings up to here
    float kept = 0.97 * gabor_impl_sine_kept(board, rings); // amplitude of the rings' wave
    vec3 rise = gabor_impl_rise(vec3(years.x, 1.0, 0.0), vec3(kept, 0.0, 0.0)), ring = vec3(rise.x, rise.y * years.yz);
    vec3 open = gabor_impl_above(of.pair_0.second, of.pair_0.removed, 1.1, 0.25), pores = wood.pore_strength * open;
    vec3 within = vec3(1.0, 0.0, 0.0) - 0.75 * ring; // a quarter as deep in late wood
    vec3 deep = gabor_impl_times(pores, within);
    float early = (1.0 - ring.x) * (1.0 - pores.x), late = ring.x * (1.0 - 0.25 * pores.x);
    vec2 tones = gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.11)
               + gabor_impl_tone(of.pair_2.second.x, of.pair_2.removed, 0.13);
    vec3 colour = early * gabor_impl_toned(wood.earlywood_colour, tones)
        + late * gabor_impl_toned(wood.latewood_colour, tones)
                + 0.45 * deep.x * wood.latewood_colour;
    vec3 height = 0.0006 * ring - 0.0024 * deep + 0.0002 * of.pair_1.second;
    // Mean squares: of the depth of pores, and of the height's derivative by the rings.
    float depth = 5.76e-6 * wood.pore_strength * wood.pore_strength
        * (within.x * within.x + 0.05 * (1.0 - kept * kept));
    float by_ring = 0.0006 + 0.0018 * pores.x, spread = 3.24e-6 * wood.pore_strength * wood.pore_strength
        * gabor_impl_above_variance(open.x, of.pair_0.removed, 0.25);
    float steep = gabor_impl_rise_lost(years.x, kept, 0.97), all_steep = gabor_impl_rise_lost(0.0, 0.0, 0.97);
    vec3 lost = ((by_ring * by_ring + spread) * steep + spread * rise.y * rise.y) * gabor_impl_square(years.yz)
              + (by_ring * by_ring + spread) * all_steep * gabor_impl_warp_lost(board, vec2(rings * rings, 0.0))
              + 4.0e-8 * of.pair_1.lost
              + depth * gabor_impl_above_lost(of.pair_0.second, of.pair_0.removed, of.pair_0.lost, 1.1, 0.25);
    return gabor_impl_material(colour, height, lost, wood.roughness * (1.0 - 0.2 * ring.x), 0.0);
}

GaborMaterial gabor_wood_at(vec2 p, vec2 period, GaborWood wood, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel board = gabor_impl_board(pixel, wood, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_wood_layer(0, pixel, board, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_wood_layer(1, pixel, board, seed));
    of.pair_2 = gabor_impl_spots_pair(gabor_impl_wood_layer(2, pixel, board, seed));
    return gabor_impl_wood(board, wood, of, seed);
}

// ---- Samples -------------------------------------------------------------------------------------------------------
//
// The filters of weaves and of leather average samples, and fade to measured means where samples are too few.

// The standard deviation of positions within a pixel: the root of the mean of their variances along x and y. dx and
// dy are the pixel's sides.
float gabor_impl_sample_spread(vec2 dx, vec2 dy) {
    return sqrt(0.125 * (dot(dx, dx) + dot(dy, dy)));
}

// The number of samples for that standard deviation, 4 or `most`, if they have the share `kept` in the result.
int gabor_impl_samples(float spread, float kept, int most) {
    return spread < 0.001 || kept == 0.0 ? 1 : spread < 0.12 ? 4 : most;
}

// Sample i of 4, 8 or 12 in steps (dx, dy) from the middle of the pixel: quantiles of a normal distribution.
vec2 gabor_impl_sample(int i, int count) {
    int j = count > 8 ? (5 * i + 4) % 13 : count > 4 ? (5 * i + 2) % 8 : (2 * i + 1) % 5;
    vec2 at = vec2(float(i), float(j)) * (2.0 / float(count));
    at -= 1.0 - 1.0 / float(count);
    return count > 1 ? at * (0.5566 + 0.507 * at * at) : vec2(0.0);
}

// The sum of heights over samples. `height` becomes their mean, which fades to `mean`; `lost` has the sum of the
// slopes' squares, and becomes their covariance, which fades to `square`.
void gabor_impl_average(inout vec3 height, inout vec3 lost, int count, float kept, float mean, vec3 square) {
    height = kept / float(count) * height + vec3((1.0 - kept) * mean, 0.0, 0.0);
    lost = count > 1 || kept == 0.0 ? mix(square, lost / float(count), kept) - gabor_impl_square(height.yz)
                                    : vec3(0.0);
}

// ---- Weaves --------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_cloth(GaborImplPixel pixel, GaborFabric fabric, uint seed) {
    return gabor_impl_warp(pixel, vec2(0.7), vec2(0.02 * fabric.unevenness), seed, 0);
}

// The thickness and course of threads along y and x, and their fibres.
GaborImplLayer gabor_impl_fabric_layer(int i, GaborImplPixel cloth, vec2 count, uint seed) {
    vec2 density = i == 0 ? vec2(0.7 * count.x, 1.1) : i == 1 ? vec2(1.1, 0.7 * count.y)
                 : i == 2 ? vec2(14.0, 2.0) * count : vec2(2.0, 14.0) * count;
    return gabor_impl_spots_layer(cloth, density, seed, 1 + i);
}

// Threads per unit; a weave repeats after 2, 4 or 16 of them.
vec2 gabor_impl_threads(GaborImplPixel pixel, GaborFabric fabric) {
    return gabor_impl_repeated(pixel, fabric.threads, fabric.weave < 0.5 ? 2.0 : fabric.weave < 1.5 ? 4.0 : 16.0);
}

// 1 where the thread along y passes over that along x, which have these numbers, and -1 where it passes under.
float gabor_impl_over(float x, float y, float weave) {
    if (weave < 0.5) return fract(0.5 * (x + y)) > 0.25 ? -1.0 : 1.0;
    if (weave > 1.5) x = abs(16.0 * fract(0.0625 * x + 0.03125) - 8.5); // turns back every eight threads
    return fract(0.25 * (x + y) + 0.125) < 0.5 ? 1.0 : -1.0; // over two, under two
}

// The height of a thread: a circle of radius `thick`, which passes over the crossing thread if `bend` is 1, under if
// -1, and is level towards a thread that it crosses on the same side.
vec3 gabor_impl_thread(vec3 across, vec3 thick, vec3 along, float bend, bool level) {
    float square = thick.x * thick.x - 4.2 * across.x * across.x;
    float side = sqrt(max(square, 0.0)), turn = level ? 0.0 : 3.1415927 * along.x; // pi
    vec2 slope = (thick.x * thick.yz - 4.2 * across.x * across.yz) / max(side, 0.05);
    // 1.7278760 is 0.55 pi
    return vec3(side - (square < 0.0 ? 2.0 : 1.0) + 0.55 * bend * cos(turn),
                (square < 0.0 ? vec2(0.0) : slope) - 1.7278760 * bend * sin(turn) * along.yz);
}

// The means to which the filter fades the weave were measured; they depend on the unevenness.
GaborMaterial gabor_impl_fabric(GaborImplPixel cloth, vec2 count, GaborFabric fabric, GaborImplPairs of) {
    float uneven = fabric.unevenness, unit = fabric.relief / fabric.threads;
    vec3 at_x = count.x * gabor_impl_along_x(cloth), at_y = count.y * gabor_impl_along_y(cloth);
    vec2 dx = count * cloth.dx, dy = count * cloth.dy;
    float spread = gabor_impl_sample_spread(dx, dy), kept = 1.0 - smoothstep(0.3, 0.7, spread);
    at_x += 0.13 * uneven * of.pair_0.first;
    at_y += 0.13 * uneven * of.pair_1.first;
    vec2 warp_tones = gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, 0.09 * uneven)
                    + gabor_impl_tone(of.pair_2.second.x, of.pair_2.removed, 0.12);
    vec2 weft_tones = gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, 0.09 * uneven)
                    + gabor_impl_tone(of.pair_3.second.x, of.pair_3.removed, 0.12);
    vec3 warp = gabor_impl_toned(fabric.warp_colour, warp_tones),
        weft = gabor_impl_toned(fabric.weft_colour, weft_tones);
    vec3 height = vec3(0.0), colour = vec3(0.0), lost = vec3(0.0);
    int samples = gabor_impl_samples(spread, kept, 8);
    for (int i = 0; i < samples; ++i) {
        vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        vec3 x = at_x + vec3(offset.x, 0.0, 0.0), y = at_y + vec3(offset.y, 0.0, 0.0);
        vec2 thread = floor(vec2(x.x, y.x));
        x.x -= thread.x + 0.5;
        y.x -= thread.y + 0.5;
        float over = gabor_impl_over(thread.x, thread.y, fabric.weave);
        bool level_y = over == gabor_impl_over(thread.x, thread.y + (y.x < 0.0 ? -1.0 : 1.0), fabric.weave);
        bool level_x = over == gabor_impl_over(thread.x + (x.x < 0.0 ? -1.0 : 1.0), thread.y, fabric.weave);
        vec3 along_y = gabor_impl_thread(x, vec3(1.0, 0.0, 0.0) + 0.16 * uneven * of.pair_0.second, y, over, level_y);
        vec3 along_x = gabor_impl_thread(y, vec3(1.0, 0.0, 0.0) + 0.16 * uneven * of.pair_1.second, x, -over, level_x);
        bool first = along_y.x > along_x.x;
        vec3 top = first ? along_y : along_x;
        if (top.x < -1.3) top = vec3(-1.3, 0.0, 0.0);
        colour += mix(0.18, 1.0, smoothstep(-1.3, 0.5, top.x)) * (first ? warp : weft);
        top = 0.3 * top + 0.035 * (first ? of.pair_2.second : of.pair_3.second);
        height += top;
        lost += gabor_impl_square(top.yz);
    }
    vec3 mean =
        vec3(0.8828 - 0.0056 * uneven * uneven, 0.0406 + 0.0025 * uneven * uneven, 0.29); // light, height, slope
    if (fabric.weave >= 0.5) mean = vec3(0.91 - uneven * (0.0105 + 0.0045 * uneven), 0.0655, 0.37);
    gabor_impl_average(height, lost, samples, kept, mean.y, vec3(mean.z * count * count, 0.0));
    float bare = fabric.cords > 0.0 ? 0.12 : 1.0; // pile hides the weave of corduroy
    colour = mix(0.5 * mean.x * (warp + weft), colour / float(samples), bare * kept);
    unit *= bare;
    height *= unit;
    lost = unit * unit * (lost + 0.0006125 * (of.pair_2.lost + of.pair_3.lost));
    if (fabric.cords > 0.0) { // wide crests and narrow furrows, 1 - cos(pi x)^4: two waves, which the filter damps
        float cords = gabor_impl_repeated(cloth, fabric.cords, 1.0).x;
        vec3 at = cords * gabor_impl_along_x(cloth);
        float damped = gabor_impl_sine_kept(cloth, cords), half_cord = 0.5 * damped;
        float second = 0.125 * damped * damped * damped * damped, turn = 6.2831853 * fract(at.x); // 2 pi
        float cord = 0.625 - half_cord * cos(turn) - second * cos(2.0 * turn);
        float depth = 0.3 * fabric.relief / cords, swing = depth * 6.2831853;
        colour *= mix(0.3, 1.0, cord);
        height += vec3(depth * cord, swing * (half_cord * sin(turn) + 2.0 * second * sin(2.0 * turn)) * at.yz);
        // 0.15625 is 5/32
        lost += swing * swing * (0.15625 - 0.5 * half_cord * half_cord - 2.0 * second * second)
                * gabor_impl_square(at.yz);
    }
    return gabor_impl_material(colour, height, lost, fabric.roughness, 0.0);
}

GaborMaterial gabor_fabric_at(vec2 p, vec2 period, GaborFabric fabric, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel cloth = gabor_impl_cloth(pixel, fabric, seed);
    vec2 count = gabor_impl_threads(pixel, fabric);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_fabric_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_fabric_layer(1, cloth, count, seed));
    of.pair_2 = gabor_impl_spots_pair(gabor_impl_fabric_layer(2, cloth, count, seed));
    of.pair_3 = gabor_impl_spots_pair(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of);
}

GaborImplPixel gabor_impl_twill(GaborImplPixel pixel, uint seed) {
    return gabor_impl_warp(pixel, vec2(0.8), vec2(0.008), seed, 0);
}

// The fibres of tows along y and x.
GaborImplLayer gabor_impl_tow_layer(int i, GaborImplPixel cloth, vec2 count, uint seed) {
    return gabor_impl_spots_layer(cloth, (i == 0 ? vec2(32.0, 0.6) : vec2(0.6, 32.0)) * count, seed, 1 + i);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
GaborMaterial gabor_impl_carbon_fibre(GaborImplPixel cloth, vec2 count, GaborCarbonFibre fibres, GaborImplPairs of) {
    vec3 at_x = count.x * gabor_impl_along_x(cloth), at_y = count.y * gabor_impl_along_y(cloth);
    vec2 dx = count * cloth.dx, dy = count * cloth.dy;
    float spread = gabor_impl_sample_spread(dx, dy), kept = 1.0 - smoothstep(0.5, 0.9, spread);
    float unit = fibres.relief / fibres.tows;
    vec3 warp = gabor_impl_toned(fibres.colour,
                                 gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, fibres.fibre_contrast));
    vec3 weft = gabor_impl_toned(fibres.colour,
                                 gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, fibres.fibre_contrast));
    vec3 height = vec3(0.0), colour = vec3(0.0), lost = vec3(0.0);
    int samples = gabor_impl_samples(spread, kept, 8);
    for (int i = 0; i < samples; ++i) {
        vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        vec3 x = at_x + vec3(offset.x, 0.0, 0.0), y = at_y + vec3(offset.y, 0.0, 0.0);
        float turn = 4.0 * fract(0.25 * (floor(x.x) + floor(y.x)) + 0.125) - 0.5; // 0 to 3
        x.x -= floor(x.x);
        y.x -= floor(y.x);
        bool first = turn < 1.5;
        vec3 along = 0.5 * (first ? y : x), across = 2.0 * (first ? x : y);
        along.x += fract(0.5 * turn + 0.25) < 0.5 ? 0.0 : 0.5; // from 0 to 1 over two rows
        across.x -= 1.0;
        float cube = across.x * across.x * across.x, low = 1.0 - cube * across.x, arch = low * low;
        vec2 wave = vec2(cos(3.1415927 * along.x), sin(3.1415927 * along.x)); // pi
        vec3 bulge = vec3(wave.y * arch, 3.1415927 * arch * wave.x * along.yz - 8.0 * cube * low * wave.y * across.yz);
        colour += (0.35 + 0.65 * bulge.x) * (first ? warp : weft);
        bulge = 0.16 * bulge + 0.0035 * (first ? of.pair_0.first : of.pair_1.first);
        height += bulge;
        lost += gabor_impl_square(bulge.yz);
    }
    // The bulge's mean is 0.4527, and its slope's mean square, over tows along x and y, 2.154.
    // 0.072432 is 0.16 * 0.4527
    gabor_impl_average(height, lost, samples, kept, 0.072432, 0.0256 * 2.154 * vec3(count * count, 0.0));
    colour = mix(0.3221275 * (warp + weft), colour / float(samples), kept); // (0.35 + 0.65 * 0.4527) / 2
    lost = unit * unit * (lost + 6.125e-6 * (of.pair_0.lost + of.pair_1.lost));
    return gabor_impl_material(colour, unit * height, lost, fibres.roughness, 0.0);
}

GaborMaterial gabor_carbon_fibre_at(vec2 p, vec2 period, GaborCarbonFibre fibres, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel cloth = gabor_impl_twill(pixel, seed);
    vec2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_tow_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of);
}

// ---- Leather -------------------------------------------------------------------------------------------------------
//
// Three waves. The phase of the third is the sum of the other two, so the crests of all three meet in each cell's
// middle.

GaborImplPixel gabor_impl_skin(GaborImplPixel pixel, GaborLeather leather, uint seed) {
    vec2 bends = vec2(0.07, 0.014) * leather.waviness;
    GaborImplPixel skin = gabor_impl_warp(pixel, vec2(0.9), vec2(bends.x), seed, 0);
    return gabor_impl_warp(skin, vec2(4.0), vec2(bends.y), seed, 1);
}

// Three octaves of fine grain, the tone, and the first two waves.
GaborImplLayer gabor_impl_leather_layer(int i, GaborImplPixel pixel, GaborImplPixel skin, GaborLeather leather,
                                        uint seed) {
    if (i < 3) return gabor_impl_octave(pixel, vec2(18.0), i, 3, 0.75, gabor_derived_seed(seed, 4));
    if (i == 3) return gabor_impl_spots_layer(pixel, vec2(0.8), seed, 5);
    // 2.2944 is 0.2 + 2/3 pi
    return gabor_impl_waves_layer(skin, vec2(leather.cells / 1.6), 1.6, i == 4 ? 0.2 : 2.2944, seed, i - 2);
}

// Waves at an offset: their envelope moves along its slope, and the phase turns.
GaborImplPair gabor_impl_moved_waves(GaborImplPair waves, GaborImplPixel at, vec2 wave, vec2 offset, float turns) {
    vec2 turn = gabor_impl_wave(turns);
    vec3 phase = 6.2831853 * vec3(0.0, dot(wave, at.by_x), dot(wave, at.by_y)); // 2 pi
    vec3 a = waves.first + waves.second.x * phase, b = waves.second - waves.first.x * phase; // the envelope's slopes
    a.x += dot(a.yz, offset);
    b.x += dot(b.yz, offset);
    vec3 first = turn.x * a - turn.y * b, second = turn.y * a + turn.x * b;
    return GaborImplPair(first - second.x * phase, second + first.x * phase, 0.0, vec3(0.0));
}

// Brings the waves of a pair near length 1: their cosine and sine.
void gabor_impl_crest(GaborImplPair waves, out vec3 cosine, out vec3 sine) {
    float power = waves.first.x * waves.first.x + waves.second.x * waves.second.x + 0.12;
    vec2 change = waves.first.x * waves.first.yz + waves.second.x * waves.second.yz;
    vec3 unit = inversesqrt(power) * vec3(1.0, -1.0 / power * change);
    cosine = gabor_impl_times(waves.first, unit);
    sine = gabor_impl_times(waves.second, unit);
}

// The means to which the filter fades, and the mean squares of the slopes, were measured.
GaborMaterial gabor_impl_leather(GaborImplPixel pixel, GaborImplPixel skin, GaborLeather leather, GaborImplPairs of) {
    // 2.2944 is 0.2 + 2/3 pi
    vec2 wave_a = gabor_wave_vector(leather.cells, 0.2), wave_b = gabor_wave_vector(leather.cells, 2.2944);
    vec2 dx = vec2(dot(wave_a, skin.dx), dot(wave_b, skin.dx));
    vec2 dy = vec2(dot(wave_a, skin.dy), dot(wave_b, skin.dy));
    float spread = gabor_impl_sample_spread(dx, dy), bend = exp(-60.0 * spread * spread);
    float kept = 1.0 - smoothstep(0.4, 0.8, spread), share = 0.0, grains = 0.0;
    vec3 height = vec3(0.0), lost = vec3(0.0);
    int samples = gabor_impl_samples(spread, kept, 12);
    for (int i = 0; i < samples; ++i) {
        vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        vec2 further = bend * (at.x * pixel.dx + at.y * pixel.dy);
        vec3 a, b, sine_a, sine_b;
        gabor_impl_crest(gabor_impl_moved_waves(of.pair_2, skin, wave_a, further, offset.x), a, sine_a);
        gabor_impl_crest(gabor_impl_moved_waves(of.pair_3, skin, wave_b, further, offset.y), b, sine_b);
        // 3 in the middle of a cell, -1.5 in a corner
        vec3 cells = a + b + gabor_impl_times(a, b) - gabor_impl_times(sine_a, sine_b);
        vec3 grained = cells + 0.1 * of.pair_0.second;
        vec2 pebble = gabor_impl_step(-1.45, -0.55, vec3(grained.x, 1.0, 0.0)).xy; // with its derivative
        share += pebble.x;
        vec3 relief = 0.016 * vec3(pebble.x, pebble.y * grained.yz) + 0.013 * gabor_impl_step(-1.0, 3.0, cells)
                    + 0.0008 * of.pair_0.second;
        float grain = 0.0016 * pebble.y + 0.0008; // the height's derivative by the grain
        grains += grain * grain;
        height += relief;
        lost += gabor_impl_square(relief.yz);
    }
    vec3 square = leather.cells * leather.cells * vec3(0.00235, 0.00194, -0.0001); // along the skin's axes
    vec3 warped = gabor_impl_warp_lost(skin, square.xy);
    square = gabor_impl_turned_square(square, skin.by_x, skin.by_y);
    // 0.015964 was measured; tools/constants.py derives 0.01595
    gabor_impl_average(height, lost, samples, kept, 0.015964, square);
    share = mix(0.806, share / float(samples), kept);
    // Wrinkles along the zeros of the grain's other noise, and pores at its peaks.
    GaborImplPair fine = of.pair_0;
    vec3 wrinkle = gabor_impl_line(fine.first, fine.removed, 0.25);
    vec3 pore = gabor_impl_above(fine.first, fine.removed, 1.8, 0.2);
    height -= 0.0018 * wrinkle + 0.004 * pore;
    share *= 1.0 - 0.25 * wrinkle.x - 0.6 * pore.x;
    vec2 tones = gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.14);
    vec3 colour = mix(gabor_impl_toned(leather.crease_colour, tones), gabor_impl_toned(leather.pebble_colour, tones),
                      share);
    lost += warped + mix(3.67e-6, grains / float(samples), kept) * of.pair_0.lost
          + 3.24e-6 * gabor_impl_line_lost(fine.first, fine.removed, fine.lost, 0.25)
          + 1.6e-5 * gabor_impl_above_lost(fine.first, fine.removed, fine.lost, 1.8, 0.2);
    float unit = 0.6 * leather.relief;
    return gabor_impl_material(colour, unit * height, unit * unit * lost, leather.roughness + 0.15 * (1.0 - share),
                               0.0);
}

GaborMaterial gabor_leather_at(vec2 p, vec2 period, GaborLeather leather, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel skin = gabor_impl_skin(pixel, leather, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 3; ++i)
        of.pair_0 = gabor_impl_plus_octave(of.pair_0, gabor_impl_leather_layer(i, pixel, skin, leather, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_leather_layer(3, pixel, skin, leather, seed));
    of.pair_2 = gabor_impl_waves_pair(gabor_impl_leather_layer(4, pixel, skin, leather, seed));
    of.pair_3 = gabor_impl_waves_pair(gabor_impl_leather_layer(5, pixel, skin, leather, seed));
    return gabor_impl_leather(pixel, skin, leather, of);
}

// ---- Marble --------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_stone(GaborImplPixel pixel, GaborMarble marble, uint seed) {
    vec4 bends = vec4(0.17, 0.038, 0.010, 0.003) * marble.turbulence;
    GaborImplPixel stone = gabor_impl_warp(pixel, vec2(1.1), vec2(bends.x), seed, 0);
    stone = gabor_impl_warp(stone, vec2(4.0), vec2(bends.y), seed, 1);
    stone = gabor_impl_warp(stone, vec2(13.0), vec2(bends.z), seed, 2);
    return gabor_impl_warp(stone, vec2(40.0), vec2(bends.w), seed, 3);
}

// Three octaves of clouds, crystals, and four sizes of veins: middle, large, thin, hair.
GaborImplLayer gabor_impl_marble_layer(int i, GaborImplPixel pixel, GaborImplPixel stone, uint seed) {
    if (i < 3) return gabor_impl_octave(stone, vec2(1.5), i, 3, 0.6, gabor_derived_seed(seed, 8));
    if (i == 3) return gabor_impl_spots_layer(pixel, vec2(75.0), seed, 9);
    vec3 vein = i == 4 ? vec3(1.9, 0.95, -0.45) : i == 5 ? vec3(0.95, 0.85, 0.65)
              : i == 6 ? vec3(4.5, 0.95, 0.95) : vec3(13.0, 0.9, 0.2);
    return gabor_impl_waves_layer(stone, vec2(vein.x), vein.y, vein.z, seed, i == 4 ? 5 : i == 5 ? 4 : i);
}

GaborMaterial gabor_impl_marble(GaborMarble marble, GaborImplPair cloud, GaborImplPair crystal) {
    float clouds = marble.cloud_strength * gabor_impl_above(cloud.second, cloud.removed, 0.5, 0.8).x;
    vec3 colour = gabor_impl_toned(marble.stone_colour * (1.0 - clouds),
                                   gabor_impl_tone(crystal.first.x, crystal.removed, 0.02));
    return gabor_impl_material(colour, 0.00012 * crystal.second, 1.44e-8 * crystal.lost, marble.roughness, 0.0);
}

// Adds veins of layer i: lines along the zeros of a noise, drawn only where a second noise exceeds a threshold, so that
// they have ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
void gabor_impl_add_veins(inout GaborMaterial stone, GaborMarble marble, int i, GaborImplPair vein) {
    vec2 width = i == 4 ? vec2(0.25, 0.035) : i == 5 ? vec2(0.35, 0.05) : vec2(1.0, i == 6 ? 0.04 : 0.05);
    vec2 strength = marble.vein_strength * (i == 4 ? vec2(0.6, 0.6) : i == 5 ? vec2(0.55, 0.75) : vec2(0.0, 0.45));
    float threshold = i == 4 ? 0.5 : i == 5 ? -0.4 : i == 6 ? 0.8 : 1.1;
    float open = gabor_impl_above(vein.second, vein.removed, threshold, 0.5).x;
    // The second noise widens the core by exp(0.8 noise); so weighted, its removed part has a mean of 0.8 times its
    // variance.
    width.y *= 0.6 * exp(min(0.8 * vein.second.x, 2.4) + 0.32 * vein.removed); // 0.8^2 / 2
    vec3 weighted = vein.second + vec3(0.8 * vein.removed, 0.0, 0.0);
    strength.y *= gabor_impl_above(weighted, vein.removed, threshold, 0.5).x
                * gabor_impl_line(vein.first, vein.removed, width.y).x;
    strength.x *= open * gabor_impl_line(vein.first, vein.removed, width.x).x - strength.y;
    vec3 halo = mix(marble.stone_colour, marble.vein_colour, 0.65);
    vec3 core = mix(marble.stone_colour, marble.vein_colour, i == 4 ? 0.9 : i == 5 ? 1.0 : i == 6 ? 0.65 : 0.45);
    stone.colour += strength.x * (halo - stone.colour) + strength.y * (core - stone.colour);
    stone.colour = clamp(stone.colour, 0.0, 1.0);
}

GaborMaterial gabor_marble_at(vec2 p, vec2 period, GaborMarble marble, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel stone = gabor_impl_stone(pixel, marble, seed);
    GaborImplPair cloud = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        cloud = gabor_impl_plus_octave(cloud, gabor_impl_marble_layer(i, pixel, stone, seed));
    GaborImplPair crystal = gabor_impl_spots_pair(gabor_impl_marble_layer(3, pixel, stone, seed));
    GaborMaterial material = gabor_impl_marble(marble, cloud, crystal);
    for (int j = 4; j < 8; ++j) {
        GaborImplLayer layer = gabor_impl_marble_layer(j, pixel, stone, seed);
        gabor_impl_add_veins(material, marble, j, gabor_impl_waves_pair(layer));
    }
    return material;
}

// ---- Sand ----------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_dune(GaborImplPixel pixel, uint seed) {
    GaborImplPixel dune = gabor_impl_warp(pixel, vec2(0.8), vec2(0.15), seed, 0);
    return gabor_impl_warp(dune, vec2(3.0), vec2(0.02), seed, 1);
}

// Three octaves of large shapes, grains, and ripples.
GaborImplLayer gabor_impl_sand_layer(int i, GaborImplPixel pixel, GaborImplPixel dune, GaborSand sand, uint seed) {
    if (i < 3) return gabor_impl_octave(pixel, vec2(0.6), i, 3, 0.5, gabor_derived_seed(seed, 4));
    if (i == 3) return gabor_impl_spots_layer(pixel, vec2(75.0), seed, 3);
    return gabor_impl_waves_layer(dune, vec2(0.9, 1.7) / 3.87 * sand.ripples, 2.3, 1.4, seed, 2);
}

GaborMaterial gabor_impl_sand(GaborSand sand, GaborImplLayer ripples, GaborImplPairs of) {
    vec2 z = vec2(of.pair_2.first.x, of.pair_2.second.x);
    float power = max(dot(z, z), 1.0e-6), whole = power + 2.5 * of.pair_2.removed, span = 0.9 * sqrt(power / whole);
    vec2 change = z.x * of.pair_2.first.yz + z.y * of.pair_2.second.yz; // half the derivative of the power
    // 0.15915494 is 1/(2 pi)
    vec3 phase = vec3(gabor_turns_intensity(z.yx).x,
                      0.15915494 / power * (z.x * of.pair_2.second.yz - z.y * of.pair_2.first.yz));
    vec3 ripple = gabor_impl_rise(phase, span * vec3(1.0, (1.0 / power - 1.0 / whole) * change));
    vec2 tones = gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, sand.grain_contrast)
               + gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.06);
    vec3 colour = mix(gabor_impl_toned(sand.trough_colour, tones), gabor_impl_toned(sand.crest_colour, tones),
                      ripple.x);
    float dark = gabor_impl_above(of.pair_1.second, of.pair_1.removed, 1.9, 0.15).x;
    float bright = gabor_impl_above(-of.pair_1.second, of.pair_1.removed, 1.9, 0.15).x;
    colour = mix(colour, 0.23 * sand.trough_colour, 3.75 * sand.grain_contrast * dark);
    colour = mix(colour, mix(sand.crest_colour, vec3(1.0), 0.6), 3.0 * sand.grain_contrast * bright);
    vec3 tall = vec3(sand.ripple_height, 0.0, 0.0) + 0.2 * sand.ripple_height * of.pair_0.first;
    vec3 height = gabor_impl_times(ripple, tall) + 0.03 * of.pair_0.first
        + 0.00875 * sand.grain_contrast * of.pair_1.first;
    vec2 wave = ripples.density * ripples.wave; // per unit of the dune
    wave = vec2(dot(wave, ripples.at.by_x), dot(wave, ripples.at.by_y));
    // The phase's mean square slope is that of the wave, and more where the noise is near 0: 0.4 was measured.
    vec3 bent = vec3(0.4 * ripples.density * ripples.density, 0.0);
    vec3 square = gabor_impl_square(wave) + gabor_impl_turned_square(bent, ripples.at.by_x, ripples.at.by_y);
    vec3 warped = gabor_impl_warp_lost(
        ripples.at, ripples.density * ripples.density * (0.4 + ripples.wave * ripples.wave));
    // Mean squares of factors; 0.0888889 is 4/45, the variance of a ripple.
    float high = tall.x * tall.x + 0.04 * sand.ripple_height * sand.ripple_height * of.pair_0.removed;
    float by_shape = 0.03 + 0.2 * sand.ripple_height * ripple.x;
    float varied = 0.04 * sand.ripple_height * sand.ripple_height * 0.0888889 * (1.0 - span * span / 0.81);
    // 7.65625e-5 is 0.00875^2
    vec3 lost = high * (gabor_impl_rise_lost(phase.x, span, 0.9) * square
                        + gabor_impl_rise_lost(0.0, 0.0, 0.9) * warped)
              + (by_shape * by_shape + varied) * of.pair_0.lost
              + 7.65625e-5 * sand.grain_contrast * sand.grain_contrast * of.pair_1.lost;
    return gabor_impl_material(colour, height, lost, sand.roughness, 0.0);
}

GaborMaterial gabor_sand_at(vec2 p, vec2 period, GaborSand sand, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel dune = gabor_impl_dune(pixel, seed);
    GaborImplLayer ripples = gabor_impl_sand_layer(4, pixel, dune, sand, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 3; ++i)
        of.pair_0 = gabor_impl_plus_octave(of.pair_0, gabor_impl_sand_layer(i, pixel, dune, sand, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_sand_layer(3, pixel, dune, sand, seed));
    of.pair_2 = gabor_impl_waves_pair(ripples);
    return gabor_impl_sand(sand, ripples, of);
}

// ---- Brushed metal -------------------------------------------------------------------------------------------------

// Five sizes of streaks, and six octaves of patina.
GaborImplLayer gabor_impl_metal_layer(int i, GaborImplPixel pixel, GaborBrushedMetal metal, uint seed) {
    if (i >= 5) return gabor_impl_octave(pixel, vec2(1.3), i - 5, 6, 0.75, gabor_derived_seed(seed, 5));
    vec2 density = vec2(0.3 + 0.12 * exp2(float(i)), metal.streaks * exp2(float(i)));
    return gabor_impl_spots_layer(pixel, density, seed, i);
}

// The layers that the metal needs.
int gabor_impl_metal_layers(GaborBrushedMetal metal) {
    return metal.patina_amount > 0.0 ? 11 : 5;
}

// Adds a layer: of the streaks, the first sum is the height, the second the tone.
void gabor_impl_add_metal(inout GaborImplPairs of, int i, GaborImplLayer layer, GaborImplPair pair) {
    if (i >= 5) {
        of.pair_1 = gabor_impl_plus(of.pair_1, pair, layer.amplitude);
        return;
    }
    float size = exp2(-float(i));
    of.pair_0.first += size * pair.first;
    of.pair_0.second += 0.4472136 * pair.second; // 1/sqrt(5)
    of.pair_0.removed += 0.2 * pair.removed;
    of.pair_0.lost += size * size * pair.lost;
}

GaborMaterial gabor_impl_brushed_metal(GaborBrushedMetal metal, GaborImplPairs of) {
    vec3 colour =
        gabor_impl_toned(metal.metal_colour,
                         gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, metal.streak_contrast));
    vec3 height = metal.streak_height * of.pair_0.first,
        lost = metal.streak_height * metal.streak_height * of.pair_0.lost;
    if (metal.patina_amount <= 0.0) return gabor_impl_material(colour, height, lost, metal.roughness, 1.0);
    float threshold = 2.4 - 3.8 * metal.patina_amount;
    vec3 cover = gabor_impl_above(of.pair_1.second, of.pair_1.removed, threshold, 0.3);
    vec3 patina = gabor_impl_toned(metal.patina_colour, gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, 0.3));
    height += 0.003 * cover + 0.001 * of.pair_1.first;
    lost += 9.0e-6 * gabor_impl_above_lost(of.pair_1.second, of.pair_1.removed, of.pair_1.lost, threshold, 0.3)
          + 1.0e-6 * of.pair_1.lost;
    return gabor_impl_material(mix(colour, patina, cover.x), height, lost, mix(metal.roughness, 0.85, cover.x),
                               1.0 - cover.x);
}

GaborMaterial gabor_brushed_metal_at(vec2 p, vec2 period, GaborBrushedMetal metal, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPairs of = gabor_impl_no_pairs();
    int layers = gabor_impl_metal_layers(metal);
    for (int i = 0; i < layers; ++i) {
        GaborImplLayer layer = gabor_impl_metal_layer(i, pixel, metal, seed);
        gabor_impl_add_metal(of, i, layer, gabor_impl_spots_pair(layer));
    }
    return gabor_impl_brushed_metal(metal, of);
}

// ---- Scratches -----------------------------------------------------------------------------------------------------
//
// Scratches are the peaks of noise with very long and narrow kernels, in many directions.

GaborImplLayer gabor_impl_scratches_layer(int i, GaborImplPixel pixel, GaborScratches scratches, uint seed) {
    // 3 - sqrt(5).
    float angle = scratches.scratch_direction
        + scratches.direction_spread * (2.0 * fract(0.0955 + 0.763932 * float(i)) - 1.0);
    GaborImplPixel at = gabor_impl_turned(pixel, angle);
    // Across a tile's scratches, a period holds at least three nodes however short it is: bend less, or scratches
    // swell.
    float bend = at.period.y > 0.0 ? min(0.17, 0.02 * at.period.y) : 0.17;
    at = gabor_impl_warp(at, vec2(0.3, 0.1), vec2(0.0, bend), seed, 2 * i);
    return gabor_impl_spots_layer(at, vec2(1.0 / scratches.scratch_length, 60.0) * exp2(0.13 * float(i)), seed,
                                  2 * i + 1);
}

// Adds scratches: the height is in units of their depth, and the colour is the share of whole lacquer. A scratch is
// the overlap of two long ovals, which tapers at its ends: there, both noises of a pair exceed sharp thresholds.
void gabor_impl_add_scratches(inout GaborMaterial sum, GaborScratches scratches, int i, GaborImplPair noise) {
    float size = exp2(-0.13 * float(i));
    float threshold = sqrt(5.76 - 2.0 * log(scratches.amount)); // the area above it is about proportional to amount
    vec3 peak = gabor_impl_above(noise.first, noise.removed, threshold, 0.12);
    vec3 open = gabor_impl_above(noise.second, noise.removed, 0.3, 0.25);
    vec3 scratch = gabor_impl_times(peak, open);
    sum.colour *= 1.0 - (0.25 + 0.7 * size) * scratch.x;
    sum.height -= size * scratch.x;
    sum.slope -= size * scratch.yz;
    // The mean square of `open`, as in gabor_impl_above_variance; 1.14 stands for its own slopes.
    // Beyond three deviations, the noise has fewer values than a normal law: a fit to amounts from 0.01 to 8.
    float rare = threshold / 3.85, rarer = rare * rare * rare * rare;
    sum.lost += 1.14 / (1.0 + rarer * rarer) * size * size
              * open.x * mix(open.x, 1.0, noise.removed / (noise.removed + 0.09375))
              * gabor_impl_above_lost(noise.first, noise.removed, noise.lost, threshold, 0.12);
}

GaborMaterial gabor_impl_scratches(GaborScratches scratches, GaborMaterial sum) {
    vec3 height = scratches.depth * vec3(sum.height, sum.slope), lost = scratches.depth * scratches.depth * sum.lost;
    return gabor_impl_material(mix(scratches.scratch_colour, scratches.lacquer_colour, sum.colour), height, lost,
                               scratches.roughness,
                               0.0);
}

GaborMaterial gabor_scratches_at(vec2 p, vec2 period, GaborScratches scratches, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborMaterial sum = GaborMaterial(vec3(1.0), 0.0, vec2(0.0), 0.0, 0.0, vec3(0.0));
    for (int i = 0; i < 14; ++i)
        gabor_impl_add_scratches(sum, scratches, i,
                                 gabor_impl_spots_pair(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    return gabor_impl_scratches(scratches, sum);
}

// ---- Zebra ---------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_hide(GaborImplPixel pixel, uint seed) {
    return gabor_impl_warp(pixel, vec2(0.9), vec2(0.14), seed, 0);
}

float gabor_impl_stripes_direction(GaborImplPixel pixel, GaborZebra zebra, uint seed) {
    GaborPlace place = gabor_impl_place(pixel, vec2(0.6));
    return zebra.orientation + zebra.bend_angle * gabor_impl_spots(place, gabor_derived_seed(seed, 1)).quadrature;
}

// Hair, tone and stripes.
GaborImplLayer gabor_impl_zebra_layer(int i, GaborImplPixel pixel, GaborImplPixel skin, float direction,
                                      GaborZebra zebra, uint seed) {
    // 2.0707963 is 0.5 + pi/2
    if (i == 0) return gabor_impl_spots_layer(gabor_impl_turned(skin, 2.0707963), vec2(6.0, 80.0), seed, 3);
    if (i == 1) return gabor_impl_spots_layer(pixel, vec2(1.2), seed, 4);
    return gabor_impl_waves_layer(skin, vec2(zebra.stripes / 1.4), 1.4, direction, seed, 2);
}

GaborMaterial gabor_impl_zebra(GaborZebra zebra, GaborImplPairs of) {
    float ragged = 0.1 * zebra.hair_contrast, relief = 0.002 * zebra.hair_contrast;
    // where it is small, a constant softness would blur the edge
    float intensity = length(vec2(of.pair_2.first.x, of.pair_2.second.x));
    float dark = gabor_impl_above(of.pair_2.first + ragged * intensity * of.pair_0.first,
                                  of.pair_2.removed + ragged * ragged * intensity * intensity * of.pair_0.removed, 0.0,
                                  0.01 + 0.09 * intensity).x;
    vec2 tones = gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.14 * zebra.hair_contrast)
               + gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.08);
    vec3 colour = mix(gabor_impl_toned(zebra.background_colour, tones), gabor_impl_toned(zebra.stripe_colour, tones),
                      dark);
    return gabor_impl_material(colour, relief * of.pair_0.first, relief * relief * of.pair_0.lost, zebra.roughness,
                               0.0);
}

GaborMaterial gabor_zebra_at(vec2 p, vec2 period, GaborZebra zebra, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel skin = gabor_impl_hide(pixel, seed);
    float direction = gabor_impl_stripes_direction(pixel, zebra, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_zebra_layer(0, pixel, skin, direction, zebra, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_zebra_layer(1, pixel, skin, direction, zebra, seed));
    of.pair_2 = gabor_impl_waves_pair(gabor_impl_zebra_layer(2, pixel, skin, direction, zebra, seed));
    return gabor_impl_zebra(zebra, of);
}

// ---- Bark ----------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_trunk(GaborImplPixel pixel, uint seed) {
    GaborImplPixel trunk = gabor_impl_warp(pixel, vec2(0.8, 0.35), vec2(0.22, 0.1), seed, 0);
    trunk = gabor_impl_warp(trunk, vec2(3.0, 1.6), vec2(0.05, 0.05), seed, 1);
    return gabor_impl_warp(trunk, vec2(10.0), vec2(0.013), seed, 2);
}

// Five octaves of roughness, moss, furrows, and cracks.
GaborImplLayer gabor_impl_bark_layer(int i, GaborImplPixel pixel, GaborImplPixel trunk, GaborBark bark, uint seed) {
    GaborImplPixel at = trunk;
    if (i > 1 && i < 6) at = pixel; // the trunk's warps would stretch small spots into smears
    if (i < 5) return gabor_impl_octave(at, vec2(7.0, 3.5), i, 5, 0.7, gabor_derived_seed(seed, 5));
    if (i == 5) return gabor_impl_spots_layer(at, vec2(1.1, 0.7), seed, 6);
    if (i == 6) return gabor_impl_waves_layer(trunk, vec2(1.7, 0.55) / 2.21 * bark.furrows, 1.3, 0.1, seed, 3);
    return gabor_impl_waves_layer(trunk, vec2(1.2, 1.3), 0.9, 1.5, seed, 4);
}

GaborMaterial gabor_impl_bark(GaborBark bark, GaborImplPairs of) {
    vec3 shape = of.pair_2.first + 0.2 * of.pair_0.first;
    float removed = of.pair_2.removed + 0.04 * of.pair_0.removed;
    vec3 whole = vec3(1.0, 0.0, 0.0) - 0.55 * gabor_impl_line(of.pair_3.first, of.pair_3.removed, 0.13);
    vec3 risen = gabor_impl_above(shape, removed, -0.15, 0.35), plate = gabor_impl_times(risen, whole);
    // Weighted by the tone exp(0.25 noise), the removed part of the noise has a mean of 0.25 times its variance.
    vec3 weighted = of.pair_0.second + vec3(0.25 * of.pair_0.removed, 0.0, 0.0);
    float worn = 0.5 * gabor_impl_above(weighted, of.pair_0.removed, 0.5, 0.4).x;
    float covered = bark.moss_amount * gabor_impl_above(of.pair_1.second, of.pair_1.removed, 0.9, 0.5).x;
    vec2 tone = gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.25);
    vec3 top = mix(gabor_impl_toned(bark.plate_colour, tone),
                   gabor_impl_toned(mix(bark.plate_colour, vec3(1.0), 0.13), tone), worn);
    vec3 moss = gabor_impl_toned(bark.moss_colour, tone);
    vec3 colour = mix(mix(gabor_impl_toned(bark.furrow_colour, tone), moss, covered), mix(top, moss, 0.6 * covered),
                      plate.x);
    vec3 coarse = vec3(0.4, 0.0, 0.0) + 0.6 * plate;
    vec3 height = bark.depth * plate + 0.018 * gabor_impl_times(of.pair_0.first, coarse);
    // Mean squares of factors; that of a line is a line of 1/sqrt(2) times the width. `deep` is the height's derivative
    // by the plate.
    // 0.0919239 is 0.13/sqrt(2)
    float wholes = 2.0 * whole.x - 1.0 + 0.3025 * gabor_impl_line(of.pair_3.first, of.pair_3.removed, 0.0919239).x;
    float rises = risen.x * risen.x + risen.x * (1.0 - risen.x) * removed / (removed + 0.18);
    float deep = bark.depth + 0.0108 * of.pair_0.first.x, coarses = 0.16 + 0.48 * plate.x + 0.36 * wholes * rises;
    float both = 0.0072 * deep * coarse.x * whole.x * gabor_impl_above(vec3(shape.x, 1.0, 0.0), removed, -0.15, 0.35).y;
    // 0.00011664 is 0.0108^2
    vec3 lost = (deep * deep + 0.00011664 * of.pair_0.removed)
              * (wholes * gabor_impl_above_lost(shape, removed, of.pair_2.lost + 0.04 * of.pair_0.lost, -0.15, 0.35)
                 + 0.3025 * rises * gabor_impl_line_lost(of.pair_3.first, of.pair_3.removed, of.pair_3.lost, 0.13))
              + (0.000324 * coarses + both) * of.pair_0.lost;
    return gabor_impl_material(colour, height, lost, bark.roughness, 0.0);
}

GaborMaterial gabor_bark_at(vec2 p, vec2 period, GaborBark bark, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel trunk = gabor_impl_trunk(pixel, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 5; ++i)
        of.pair_0 = gabor_impl_plus_octave(of.pair_0, gabor_impl_bark_layer(i, pixel, trunk, bark, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_bark_layer(5, pixel, trunk, bark, seed));
    of.pair_2 = gabor_impl_waves_pair(gabor_impl_bark_layer(6, pixel, trunk, bark, seed));
    of.pair_3 = gabor_impl_waves_pair(gabor_impl_bark_layer(7, pixel, trunk, bark, seed));
    return gabor_impl_bark(bark, of);
}

// ---- Strata --------------------------------------------------------------------------------------------------------

GaborImplPixel gabor_impl_rock(GaborImplPixel pixel, GaborStrata strata, uint seed) {
    vec4 folds = vec4(0.2, 0.016, 0.022, 0.004) * strata.folding;
    GaborImplPixel rock = gabor_impl_warp(pixel, vec2(0.35, 0.6), vec2(0.0, folds.x), seed, 0);
    rock = gabor_impl_warp(rock, vec2(1.6, 2.6), folds.yz, seed, 1);
    return gabor_impl_warp(rock, vec2(7.0, 10.0), vec2(folds.w), seed, 2);
}

// Four octaves of grain, and four sizes of layers: broad, band, thin, lamina.
GaborImplLayer gabor_impl_strata_layer(int i, GaborImplPixel pixel, GaborImplPixel rock, GaborStrata strata,
                                       uint seed) {
    if (i < 4)
        return gabor_impl_octave(pixel, vec2(16.0, 24.0), i, 4, 0.8, gabor_derived_seed(seed, 7));
    // 0.33333333 is 1/3, 2.8333333 is 17/6 and 8.3333333 is 25/3
    vec2 density = i == 4 ? vec2(0.1, 0.33333333) : i == 5 ? vec2(0.14, 1.0)
                 : i == 6 ? vec2(0.25, 2.8333333) : vec2(0.6, 8.3333333);
    return gabor_impl_spots_layer(rock, density * vec2(1.0, strata.layers), seed, i - 1);
}

GaborMaterial gabor_impl_strata(GaborStrata strata, GaborImplPairs of) {
    vec3 soft = gabor_impl_above(of.pair_2.first, of.pair_2.removed, 0.5, 0.22); // the soft layers, which erode
    vec2 tones = gabor_impl_tone(of.pair_4.first.x, of.pair_4.removed, 0.13)
               + gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, 0.11);
    vec3 colour = mix(gabor_impl_toned(strata.dark_rock_colour, tones),
                      gabor_impl_toned(strata.light_rock_colour, tones),
                      gabor_impl_above(of.pair_1.first, of.pair_1.removed, 0.0, 0.5).x);
    colour = mix(colour, gabor_impl_toned(strata.soft_layer_colour, tones), 0.8 * soft.x);
    colour = mix(colour, gabor_impl_toned(strata.thin_layer_colour, tones),
                 0.75 * gabor_impl_above(of.pair_3.first, of.pair_3.removed, 1.0, 0.2).x);
    colour = mix(colour, gabor_impl_toned(0.75 * strata.soft_layer_colour, tones),
                 0.6 * gabor_impl_above(of.pair_3.second, of.pair_3.removed, 1.3, 0.15).x);
    vec3 height = 0.02 * of.pair_1.second - 0.012 * soft + 0.006 * of.pair_3.first + 0.0015 * of.pair_4.first
                + 0.003 * of.pair_0.second;
    vec3 lost = 0.0004 * of.pair_1.lost + 3.6e-5 * of.pair_3.lost + 2.25e-6 * of.pair_4.lost + 9.0e-6 * of.pair_0.lost
              + 0.000144 * gabor_impl_above_lost(of.pair_2.first, of.pair_2.removed, of.pair_2.lost, 0.5, 0.22);
    return gabor_impl_material(colour, strata.relief * height, strata.relief * strata.relief * lost, strata.roughness,
                               0.0);
}

GaborMaterial gabor_strata_at(vec2 p, vec2 period, GaborStrata strata, uint seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel rock = gabor_impl_rock(pixel, strata, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 4; ++i)
        of.pair_0 = gabor_impl_plus_octave(of.pair_0, gabor_impl_strata_layer(i, pixel, rock, strata, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_strata_layer(4, pixel, rock, strata, seed));
    of.pair_2 = gabor_impl_spots_pair(gabor_impl_strata_layer(5, pixel, rock, strata, seed));
    of.pair_3 = gabor_impl_spots_pair(gabor_impl_strata_layer(6, pixel, rock, strata, seed));
    of.pair_4 = gabor_impl_spots_pair(gabor_impl_strata_layer(7, pixel, rock, strata, seed));
    return gabor_impl_strata(strata, of);
}

// ---- The same, filtered --------------------------------------------------------------------------------------------

GaborMaterial gabor_wood_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborWood wood, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel board = gabor_impl_board(pixel, wood, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_wood_layer(0, pixel, board, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_wood_layer(1, pixel, board, seed));
    of.pair_2 = gabor_impl_filtered_spots(gabor_impl_wood_layer(2, pixel, board, seed));
    return gabor_impl_wood(board, wood, of, seed);
}

GaborMaterial gabor_fabric_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborFabric fabric, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel cloth = gabor_impl_cloth(pixel, fabric, seed);
    vec2 count = gabor_impl_threads(pixel, fabric);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(1, cloth, count, seed));
    of.pair_2 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(2, cloth, count, seed));
    of.pair_3 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of);
}

GaborMaterial gabor_carbon_fibre_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborCarbonFibre fibres,
                                             uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel cloth = gabor_impl_twill(pixel, seed);
    vec2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_tow_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of);
}

GaborMaterial gabor_leather_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborLeather leather, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel skin = gabor_impl_skin(pixel, leather, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 3; ++i)
        of.pair_0 = gabor_impl_plus_filtered_octave(of.pair_0, gabor_impl_leather_layer(i, pixel, skin, leather, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_leather_layer(3, pixel, skin, leather, seed));
    of.pair_2 = gabor_impl_waves_pair(gabor_impl_leather_layer(4, pixel, skin, leather, seed));
    of.pair_3 = gabor_impl_waves_pair(gabor_impl_leather_layer(5, pixel, skin, leather, seed));
    return gabor_impl_leather(pixel, skin, leather, of);
}

GaborMaterial gabor_marble_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborMarble marble, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel stone = gabor_impl_stone(pixel, marble, seed);
    GaborImplPair cloud = gabor_impl_no_pair();
    for (int i = 0; i < 3; ++i)
        cloud = gabor_impl_plus_filtered_octave(cloud, gabor_impl_marble_layer(i, pixel, stone, seed));
    GaborImplPair crystal = gabor_impl_filtered_spots(gabor_impl_marble_layer(3, pixel, stone, seed));
    GaborMaterial material = gabor_impl_marble(marble, cloud, crystal);
    for (int j = 4; j < 8; ++j) {
        GaborImplLayer layer = gabor_impl_marble_layer(j, pixel, stone, seed);
        gabor_impl_add_veins(material, marble, j, gabor_impl_filtered_waves(layer));
    }
    return material;
}

GaborMaterial gabor_sand_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborSand sand, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel dune = gabor_impl_dune(pixel, seed);
    GaborImplLayer ripples = gabor_impl_sand_layer(4, pixel, dune, sand, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 3; ++i)
        of.pair_0 = gabor_impl_plus_filtered_octave(of.pair_0, gabor_impl_sand_layer(i, pixel, dune, sand, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_sand_layer(3, pixel, dune, sand, seed));
    of.pair_2 = gabor_impl_filtered_waves(ripples);
    return gabor_impl_sand(sand, ripples, of);
}

GaborMaterial gabor_brushed_metal_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborBrushedMetal metal,
                                              uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPairs of = gabor_impl_no_pairs();
    int layers = gabor_impl_metal_layers(metal);
    for (int i = 0; i < layers; ++i) {
        GaborImplLayer layer = gabor_impl_metal_layer(i, pixel, metal, seed);
        gabor_impl_add_metal(of, i, layer, gabor_impl_filtered_spots(layer));
    }
    return gabor_impl_brushed_metal(metal, of);
}

GaborMaterial gabor_scratches_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborScratches scratches, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborMaterial sum = GaborMaterial(vec3(1.0), 0.0, vec2(0.0), 0.0, 0.0, vec3(0.0));
    for (int i = 0; i < 14; ++i)
        gabor_impl_add_scratches(sum, scratches, i,
                                 gabor_impl_filtered_spots(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    return gabor_impl_scratches(scratches, sum);
}

GaborMaterial gabor_zebra_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborZebra zebra, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel skin = gabor_impl_hide(pixel, seed);
    float direction = gabor_impl_stripes_direction(pixel, zebra, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(0, pixel, skin, direction, zebra, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(1, pixel, skin, direction, zebra, seed));
    of.pair_2 = gabor_impl_filtered_waves(gabor_impl_zebra_layer(2, pixel, skin, direction, zebra, seed));
    return gabor_impl_zebra(zebra, of);
}

GaborMaterial gabor_bark_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborBark bark, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel trunk = gabor_impl_trunk(pixel, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 5; ++i)
        of.pair_0 = gabor_impl_plus_filtered_octave(of.pair_0, gabor_impl_bark_layer(i, pixel, trunk, bark, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_bark_layer(5, pixel, trunk, bark, seed));
    of.pair_2 = gabor_impl_filtered_waves(gabor_impl_bark_layer(6, pixel, trunk, bark, seed));
    of.pair_3 = gabor_impl_filtered_waves(gabor_impl_bark_layer(7, pixel, trunk, bark, seed));
    return gabor_impl_bark(bark, of);
}

GaborMaterial gabor_strata_filtered_at(vec2 p, vec2 dx, vec2 dy, vec2 period, GaborStrata strata, uint seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel rock = gabor_impl_rock(pixel, strata, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    for (int i = 0; i < 4; ++i)
        of.pair_0 = gabor_impl_plus_filtered_octave(of.pair_0, gabor_impl_strata_layer(i, pixel, rock, strata, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_strata_layer(4, pixel, rock, strata, seed));
    of.pair_2 = gabor_impl_filtered_spots(gabor_impl_strata_layer(5, pixel, rock, strata, seed));
    of.pair_3 = gabor_impl_filtered_spots(gabor_impl_strata_layer(6, pixel, rock, strata, seed));
    of.pair_4 = gabor_impl_filtered_spots(gabor_impl_strata_layer(7, pixel, rock, strata, seed));
    return gabor_impl_strata(strata, of);
}

// ---- Definitions of the other public functions ---------------------------------------------------------------------

float gabor_roughness(GaborMaterial material) {
    float alpha = material.roughness * material.roughness;
    return sqrt(sqrt(min(alpha * alpha + 0.5 * (material.lost.x + material.lost.y), 1.0)));
}

GaborWood gabor_wood_default() {
    return GaborWood(vec3(0.51, 0.283, 0.098), vec3(0.21, 0.061, 0.027), 13.0, 1.0, 0.75, 0.5);
}
GaborFabric gabor_fabric_default() {
    return GaborFabric(vec3(0.50, 0.43, 0.33), vec3(0.60, 0.53, 0.42), 12.0, 1.0, 1.0, 0.85, 0.0, 0.0);
}
GaborLeather gabor_leather_default() {
    return GaborLeather(vec3(0.20, 0.068, 0.026), vec3(0.093, 0.016, 0.0086), 6.88, 1.0, 1.0, 0.4);
}
GaborMarble gabor_marble_default() {
    return GaborMarble(vec3(0.80, 0.79, 0.77), vec3(0.13, 0.135, 0.145), 1.0, 1.0, 0.25, 0.2);
}
GaborSand gabor_sand_default() {
    return GaborSand(vec3(0.43, 0.30, 0.17), vec3(0.60, 0.44, 0.265), 3.87, 0.055, 0.16, 0.9);
}
GaborBrushedMetal gabor_brushed_metal_default() {
    return GaborBrushedMetal(vec3(0.55, 0.555, 0.565), vec3(0.14, 0.33, 0.27), 9.0, 0.09, 0.0012, 0.36, 0.0);
}
GaborScratches gabor_scratches_default() {
    // 1.5707963 is pi/2 and 3.1415927 is pi
    return GaborScratches(vec3(0.035, 0.042, 0.05), vec3(0.60, 0.61, 0.62), 1.0, 3.0, 1.5707963, 1.5707964, 0.0014,
                          0.3);
}
GaborZebra gabor_zebra_default() {
    // 0.2967060 is 17/180 pi and 0.3490659 is 20/180 pi
    return GaborZebra(vec3(0.70, 0.64, 0.54), vec3(0.018, 0.014, 0.012), 1.96, 0.2967060, 0.3490659, 1.0, 0.7);
}
GaborBark gabor_bark_default() {
    return GaborBark(vec3(0.20, 0.145, 0.10), vec3(0.025, 0.014, 0.008), vec3(0.10, 0.13, 0.045), 2.21, 0.35, 0.08,
                     0.9);
}
GaborCarbonFibre gabor_carbon_fibre_default() {
    return GaborCarbonFibre(vec3(0.028, 0.029, 0.031), 4.0, 0.3, 1.0, 0.3);
}
GaborStrata gabor_strata_default() {
    return GaborStrata(vec3(0.50, 0.22, 0.09), vec3(0.60, 0.35, 0.18), vec3(0.28, 0.075, 0.035), vec3(0.74, 0.58, 0.40),
                       6.0, 1.0, 1.0, 0.9);
}


GaborMaterial gabor_wood(vec2 p, uint seed) {
    return gabor_wood_at(p, vec2(0.0), gabor_wood_default(), seed);
}
GaborMaterial gabor_fabric(vec2 p, uint seed) {
    return gabor_fabric_at(p, vec2(0.0), gabor_fabric_default(), seed);
}
GaborMaterial gabor_leather(vec2 p, uint seed) {
    return gabor_leather_at(p, vec2(0.0), gabor_leather_default(), seed);
}
GaborMaterial gabor_marble(vec2 p, uint seed) {
    return gabor_marble_at(p, vec2(0.0), gabor_marble_default(), seed);
}
GaborMaterial gabor_sand(vec2 p, uint seed) {
    return gabor_sand_at(p, vec2(0.0), gabor_sand_default(), seed);
}
GaborMaterial gabor_brushed_metal(vec2 p, uint seed) {
    return gabor_brushed_metal_at(p, vec2(0.0), gabor_brushed_metal_default(), seed);
}
GaborMaterial gabor_scratches(vec2 p, uint seed) {
    return gabor_scratches_at(p, vec2(0.0), gabor_scratches_default(), seed);
}
GaborMaterial gabor_zebra(vec2 p, uint seed) {
    return gabor_zebra_at(p, vec2(0.0), gabor_zebra_default(), seed);
}
GaborMaterial gabor_bark(vec2 p, uint seed) {
    return gabor_bark_at(p, vec2(0.0), gabor_bark_default(), seed);
}
GaborMaterial gabor_carbon_fibre(vec2 p, uint seed) {
    return gabor_carbon_fibre_at(p, vec2(0.0), gabor_carbon_fibre_default(), seed);
}
GaborMaterial gabor_strata(vec2 p, uint seed) {
    return gabor_strata_at(p, vec2(0.0), gabor_strata_default(), seed);
}

GaborMaterial gabor_wood_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_wood_filtered_at(p, dx, dy, vec2(0.0), gabor_wood_default(), seed);
}
GaborMaterial gabor_fabric_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_fabric_filtered_at(p, dx, dy, vec2(0.0), gabor_fabric_default(), seed);
}
GaborMaterial gabor_leather_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_leather_filtered_at(p, dx, dy, vec2(0.0), gabor_leather_default(), seed);
}
GaborMaterial gabor_marble_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_marble_filtered_at(p, dx, dy, vec2(0.0), gabor_marble_default(), seed);
}
GaborMaterial gabor_sand_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_sand_filtered_at(p, dx, dy, vec2(0.0), gabor_sand_default(), seed);
}
GaborMaterial gabor_brushed_metal_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_brushed_metal_filtered_at(p, dx, dy, vec2(0.0), gabor_brushed_metal_default(), seed);
}
GaborMaterial gabor_scratches_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_scratches_filtered_at(p, dx, dy, vec2(0.0), gabor_scratches_default(), seed);
}
GaborMaterial gabor_zebra_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_zebra_filtered_at(p, dx, dy, vec2(0.0), gabor_zebra_default(), seed);
}
GaborMaterial gabor_bark_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_bark_filtered_at(p, dx, dy, vec2(0.0), gabor_bark_default(), seed);
}
GaborMaterial gabor_carbon_fibre_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_carbon_fibre_filtered_at(p, dx, dy, vec2(0.0), gabor_carbon_fibre_default(), seed);
}
GaborMaterial gabor_strata_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_strata_filtered_at(p, dx, dy, vec2(0.0), gabor_strata_default(), seed);
}

#endif
