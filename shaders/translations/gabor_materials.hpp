// clang-format off
// Generated from gabor_materials.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp, gabor_fractal.hpp, gabor_spectrum.hpp; pasted after their texts, it includes nothing.
//
// gabor_materials.hpp: eleven materials from Gabor noise.
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

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#ifndef GABOR_FRACTAL_HPP
#include "gabor_fractal.hpp"
#endif
#ifndef GABOR_SPECTRUM_HPP
#include "gabor_spectrum.hpp"
#endif
#ifndef GABOR_MATERIALS_HPP
#define GABOR_MATERIALS_HPP 1

struct GaborMaterial {
    gabor_vec3 colour;     // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // height in units of p
    gabor_vec2 slope;      // derivatives of the height along x and y
    float roughness; // roughness as in glTF, without what the filter removed
    float metalness; // 0 or 1, or between them at the edges of patina
    gabor_vec3 lost;       // covariance of the slopes that the filter removed: xx, yy, xy
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
    gabor_vec3 earlywood_colour; // colour of the early wood
    gabor_vec3 latewood_colour;  // colour of the late wood
    float rings;           // growth rings per unit, 2 to 60
    float waviness;        // how much the rings bend, 0 to 3
    float pore_strength;   // strength of the pores, 0 to 1
    float roughness;       // roughness of the early wood, 0 to 1
};

// Linen, a plain weave of uneven threads; twill or herringbone; or corduroy, whose cords run along y [5 noises; period
// 3 x 3].
struct GaborFabric {
    gabor_vec3 warp_colour; // colour of the threads along y
    gabor_vec3 weft_colour; // colour of the threads along x
    float threads;    // threads per unit, 2 to 60
    float unevenness; // unevenness of the threads' thickness, shade and course, 0 to 2
    float relief;     // height of the weave and of the cords, relative to the default, 0 to 3
    float roughness;  // 0 to 1
    float cords;      // cords per unit, 0 to 20
    float weave;      // plain weave 0, twill 1, herringbone 2, 0 to 2
};

// Pebbled grain: wrinkled cells with pores, between creases [8 noises; period 3 x 3].
struct GaborLeather {
    gabor_vec3 pebble_colour; // colour of the cells
    gabor_vec3 crease_colour; // colour between the cells
    float cells;        // cells per unit, 2 to 30
    float waviness;     // how much the rows of cells bend, 0 to 3
    float relief;       // height of the cells, relative to the default, 0 to 3
    float roughness;    // roughness of the cells, 0 to 0.7
};

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    gabor_vec3 stone_colour;    // colour of the stone
    gabor_vec3 vein_colour;     // colour of the darkest veins
    float vein_strength;  // strength of the veins, 0 to 1.3
    float turbulence;     // how much the veins bend, 0 to 2
    float cloud_strength; // darkening by clouds, 0 to 1
    float roughness;      // 0 to 1
};

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    gabor_vec3 trough_colour;   // colour of the troughs
    gabor_vec3 crest_colour;    // colour of the crests
    float ripples;        // ripples per unit, 1 to 20
    float ripple_height;  // height of the ripples, in units, 0 to 0.2
    float grain_contrast; // contrast of the grains, 0 to 0.25
    float roughness;      // 0 to 1
};

// Streaks along x, and patina [5 noises, 11 with patina; period 5 x 1].
struct GaborBrushedMetal {
    gabor_vec3 metal_colour;     // colour of the metal
    gabor_vec3 patina_colour;    // colour of the patina
    float streaks;         // number of the widest streaks per unit, 1 to 50
    float streak_contrast; // contrast of the streaks, 0 to 0.5
    float streak_height;   // height of the widest streaks, in units, 0 to 0.01
    float roughness;       // roughness of the metal, 0 to 1
    float patina_amount;   // amount of patina, 0 to 1
};

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    gabor_vec3 lacquer_colour;     // colour of the lacquer
    gabor_vec3 scratch_colour;     // colour in the scratches
    float amount;            // number of scratches, relative to the default, 0.01 to 8
    float scratch_length;    // length of the scratches, in units, 0.3 to 10
    float scratch_direction; // mean direction along the scratches, -6.2832 to 6.2832 radians
    float direction_spread;  // half-width of the range of their directions, 0 to 1.5708 radians: pi/2 for all
    float depth;             // depth of the scratches, in units, 0 to 0.02
    float roughness;         // 0 to 1
};

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    gabor_vec3 background_colour; // colour between the stripes
    gabor_vec3 stripe_colour;     // colour of the stripes
    float stripes;          // stripes per unit, 0.5 to 20
    float orientation;      // direction across the stripes, as that of a wave vector, -6.2832 to 6.2832 radians
    float bend_angle;       // how much the stripes' direction changes, 0 to 1.5708 radians
    float hair_contrast;    // contrast of the hair, 0 to 3
    float roughness;        // 0 to 1
};

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    gabor_vec3 plate_colour;  // colour of the plates
    gabor_vec3 furrow_colour; // colour of the furrows
    gabor_vec3 moss_colour;   // colour of the moss
    float furrows;      // furrows per unit, 0.5 to 10
    float moss_amount;  // amount of moss, 0 to 1
    float depth;        // depth of the furrows, in units, 0 to 0.4
    float roughness;    // 0 to 1
};

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    gabor_vec3 colour;          // colour of the fibres
    float tows;           // tows per unit, 1 to 20
    float fibre_contrast; // contrast of the fibres, 0 to 0.6
    float relief;         // height of the tows, relative to the default, 0 to 3
    float roughness;      // 0 to 1
};

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    gabor_vec3 dark_rock_colour;  // colour of the darker rock
    gabor_vec3 light_rock_colour; // colour of the lighter rock
    gabor_vec3 soft_layer_colour; // colour of the soft layers
    gabor_vec3 thin_layer_colour; // colour of the thin layers
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
GABOR_INLINE gabor_vec3 gabor_impl_times(gabor_vec3 a, gabor_vec3 b) {
    return gabor_vec3(a.x * b.x, a.x * b.yz() + b.x * a.yz());
}

// The matrix v v^T: xx, yy, xy.
GABOR_INLINE gabor_vec3 gabor_impl_square(gabor_vec2 v) {
    return gabor_vec3(v * v, v.x * v.y);
}

// (x y)^T M (x y), where M has the elements xx, yy, xy.
GABOR_INLINE gabor_vec3 gabor_impl_turned_square(gabor_vec3 m, gabor_vec2 x, gabor_vec2 y) {
    gabor_vec2 a = m.xy() * x + m.z * x.yx(), b = m.xy() * y + m.z * y.yx();
    return gabor_vec3(gabor_cpp_dot(x, a), gabor_cpp_dot(y, b), gabor_cpp_dot(x, b));
}

// ---- Positions -----------------------------------------------------------------------------------------------------

// A position, its derivatives along the plane's x and y, the steps (dx, dy) to the next pixels, which are 0 without a
// filter, and the period, 0 for none. Warps move it and bend the steps. A warp that a filter removed still steepens
// slopes: the gradient of position.x has the mean (by_x.x, by_y.x) and the covariance lost_x, as xx, yy, xy; that of
// position.y has lost_y, and nearly no covariance with the other.
struct GaborImplPixel {
    gabor_vec2 position;
    gabor_vec2 by_x;
    gabor_vec2 by_y;
    bool filtered;
    gabor_vec2 dx;
    gabor_vec2 dy;
    gabor_vec2 period;
    gabor_vec3 lost_x;
    gabor_vec3 lost_y;
};

GABOR_INLINE GaborImplPixel gabor_impl_pixel_of(bool filtered, gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period) {
    p -= period.x > 0.0f ? period * gabor_cpp_floor(p / period) : gabor_vec2(0.0f);
    if (!(gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy) < 1.0e6f)) { // too large, or NaN: nothing is left
        dx = gabor_vec2(1.0e3f, 0.0f);
        dy = gabor_vec2(0.0f, 1.0e3f);
    }
    return GaborImplPixel{p, gabor_vec2(1.0f, 0.0f), gabor_vec2(0.0f, 1.0f), filtered, dx, dy, period, gabor_vec3(0.0f), gabor_vec3(0.0f)};
}

GABOR_INLINE GaborImplPixel gabor_impl_point(gabor_vec2 p, gabor_vec2 period) {
    return gabor_impl_pixel_of(false, p, gabor_vec2(0.0f), gabor_vec2(0.0f), period);
}

// A position along the warped x or y axis, with derivatives.
GABOR_INLINE gabor_vec3 gabor_impl_along_x(GaborImplPixel at) {
    return gabor_vec3(at.position.x, at.by_x.x, at.by_y.x);
}
GABOR_INLINE gabor_vec3 gabor_impl_along_y(GaborImplPixel at) {
    return gabor_vec3(at.position.y, at.by_x.y, at.by_y.y);
}

// The place of a layer with `density` kernel radii per unit along x and y.
GABOR_INLINE GaborPlace gabor_impl_place(GaborImplPixel at, gabor_vec2 density) {
    if (at.period.x > 0.0f)
        return gabor_place_tiled(density * at.position, density * at.period);
    return gabor_place_at(density * at.position);
}

// Adds a row of three nodes to two noises, (quadrature, noise), and to their derivatives along x and y.
GABOR_INLINE void gabor_impl_add_spots(gabor_vec2& value, gabor_vec4& slope, GaborImplLine x, std::uint32_t word, float even,
                          float even_slope) {
    gabor_uvec4 words = x.word * word;
    gabor_vec2 a = gabor_impl_amplitude(words.x), b = gabor_impl_amplitude(words.y), c = gabor_impl_amplitude(words.z);
    gabor_vec2 row = x.even.x * a + x.even.y * b + x.even.z * c;
    value += even * row;
    slope += gabor_vec4(even * (x.even_slope.x * a + x.even_slope.y * b + x.even_slope.z * c), even_slope * row);
}

// Adds a row of four nodes.
GABOR_INLINE void gabor_impl_add_four_spots(gabor_vec2& value, gabor_vec4& slope, GaborImplLine x, std::uint32_t word, float even,
                               float even_slope) {
    gabor_impl_add_spots(value, slope, x, word, even, even_slope);
    gabor_vec2 d = gabor_impl_amplitude(x.word.w * word), last = x.even.w * d;
    value += even * last;
    slope += gabor_vec4(even * x.even_slope.w * d, even_slope * last);
}

GABOR_INLINE GaborField gabor_impl_spots_field(gabor_vec2 value, gabor_vec4 slope, float scale, gabor_vec2 stretch) {
    return GaborField{scale * value.y, stretch * slope.yw(), scale * value.x, stretch * slope.xz(), 0.0f};
}

// Noise of frequency 0, which needs no waves: spots as large as a kernel. The same as gabor_field.
GABOR_INLINE GaborField gabor_impl_spots(GaborPlace place, std::uint32_t seed) {
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplLine x = gabor_impl_smooth_line(place.cell.x, place.local.x, place.period.x, salt);
    GaborImplLine y = gabor_impl_smooth_line(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS);
    gabor_vec2 value = gabor_vec2(0.0f);
    gabor_vec4 slope = gabor_vec4(0.0f);
    gabor_impl_add_spots(value, slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_spots(value, slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_spots(value, slope, x, y.word.z, y.even.z, y.even_slope.z);
    float scale = 1.0f / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// The steps (dx, dy) to the next pixels, in kernel radii of a noise with this density.
GABOR_INLINE gabor_vec4 gabor_impl_radii(GaborImplPixel at, gabor_vec2 density) {
    return gabor_vec4(density * at.dx, density * at.dy);
}

// Moves the position by two noises. Noises that are finer than the pixel move it only as much as a filter keeps of
// their slopes. They bend dx and dy even less, for two reasons: slopes at one point are not those of the whole pixel,
// and the slopes of a filtered height leave out how the steps change.
GABOR_INLINE GaborImplPixel gabor_impl_warp(GaborImplPixel at, gabor_vec2 density, gabor_vec2 amplitude, std::uint32_t seed, int index) {
    gabor_vec4 steps = gabor_impl_radii(at, density);
    float size = gabor_cpp_min(gabor_cpp_dot(steps, steps), 1.0e6f), bend = 1.0f / (1.0f + 64.0f * size);
    gabor_vec2 whole = amplitude * amplitude;
    amplitude /= 1.0f + 0.82246703f * size; // pi^2 / 12
    GaborField field = gabor_impl_spots(gabor_impl_place(at, density), gabor_derived_seed(seed, index));
    gabor_vec2 along_x = amplitude * density.x * gabor_vec2(field.quadrature_gradient.x, field.gradient.x);
    gabor_vec2 along_y = amplitude * density.y * gabor_vec2(field.quadrature_gradient.y, field.gradient.y);
    gabor_vec3 lost_x = gabor_vec3(0.0f), lost_y = gabor_vec3(0.0f);
    if (at.filtered) {
        gabor_vec2 power = 3.2898681f * density * density; // pi^2 / 3, the noises' mean square gradient
        gabor_vec3 lost = power.x * (gabor_impl_square(gabor_vec2(at.by_x.x, at.by_y.x)) + at.lost_x)
                  + power.y * (gabor_impl_square(gabor_vec2(at.by_x.y, at.by_y.y)) + at.lost_y);
        whole -= amplitude * amplitude;
        lost_x = (1.0f + along_x.x) * (1.0f + along_x.x) * at.lost_x + along_y.x * along_y.x * at.lost_y + whole.x * lost;
        lost_y = along_x.y * along_x.y * at.lost_x + (1.0f + along_y.y) * (1.0f + along_y.y) * at.lost_y + whole.y * lost;
    }
    return GaborImplPixel{at.position + amplitude * gabor_vec2(field.quadrature, field.noise),
                          at.by_x + at.by_x.x * along_x + at.by_x.y * along_y,
                          at.by_y + at.by_y.x * along_x + at.by_y.y * along_y, at.filtered,
                          at.dx + bend * (at.dx.x * along_x + at.dx.y * along_y),
                          at.dy + bend * (at.dy.x * along_x + at.dy.y * along_y), at.period, lost_x, lost_y};
}

// The covariance of the slopes in the plane that warps lost of a layer or profile, whose slopes along the warped axes
// have these mean squares.
GABOR_INLINE gabor_vec3 gabor_impl_warp_lost(GaborImplPixel at, gabor_vec2 power) {
    return power.x * at.lost_x + power.y * at.lost_y;
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
GABOR_INLINE GaborImplPixel gabor_impl_turned(GaborImplPixel at, float angle) {
    gabor_vec2 turn = gabor_impl_wave(0.15915494f * angle); // 1/(2 pi)
    gabor_vec2 x = turn;
    gabor_vec2 y = gabor_vec2(-turn.y, turn.x);
    gabor_vec2 period = gabor_vec2(0.0f);
    if (at.period.x > 0.0f) {
        gabor_vec2 whole = gabor_cpp_floor(3.0f * gabor_cpp_normalize(turn / at.period) + 0.5f);
        gabor_vec2 size = gabor_cpp_abs(whole);
        gabor_vec2 signs = gabor_vec2(whole.x < 0.0f ? -1.0f : 1.0f, whole.y < 0.0f ? -1.0f : 1.0f);
        if (size.x == size.y || size.x * size.y == 0.0f) // (2, 2), (3, 0), (0, 3) become (1, 1), (1, 0), (0, 1)
            whole = signs * gabor_cpp_min(size, gabor_vec2(1.0f));
        size = gabor_cpp_abs(whole);
        gabor_vec2 other = size.x > 1.0f && size.y > 1.0f ? (size.x > size.y ? signs : -signs)
                     : size.x == 1.0f              ? gabor_vec2(0.0f, whole.x)
                                                  : gabor_vec2(-whole.y, 0.0f);
        period.x = gabor_cpp_length(whole * at.period);
        period.y = at.period.x * at.period.y / period.x;
        x = period.x * gabor_vec2(other.y, -other.x) / at.period;
        y = period.y * gabor_vec2(-whole.y, whole.x) / at.period;
    }
    return GaborImplPixel{gabor_vec2(gabor_cpp_dot(x, at.position), gabor_cpp_dot(y, at.position)), gabor_vec2(gabor_cpp_dot(x, at.by_x), gabor_cpp_dot(y, at.by_x)),
                          gabor_vec2(gabor_cpp_dot(x, at.by_y), gabor_cpp_dot(y, at.by_y)), at.filtered,
                          gabor_vec2(gabor_cpp_dot(x, at.dx), gabor_cpp_dot(y, at.dx)), gabor_vec2(gabor_cpp_dot(x, at.dy), gabor_cpp_dot(y, at.dy)), period,
                          x.x * x.x * at.lost_x + x.y * x.y * at.lost_y, y.x * y.x * at.lost_x + y.y * y.y * at.lost_y};
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
GABOR_INLINE gabor_vec2 gabor_impl_repeated(GaborImplPixel pixel, float count, float whole) {
    if (pixel.period.x > 0.0f)
        return gabor_cpp_max(gabor_cpp_floor(pixel.period * (count / whole) + 0.5f), gabor_vec2(1.0f)) * whole / pixel.period;
    return gabor_vec2(count);
}

// What a pixel keeps of a sine along x that repeats `count` times per unit.
GABOR_INLINE float gabor_impl_sine_kept(GaborImplPixel at, float count) {
    return gabor_cpp_exp(-gabor_cpp_min(4.9348022f * count * count * (at.dx.x * at.dx.x + at.dy.x * at.dy.x), 40.0f)); // pi^2 / 2
}

// ---- Layers --------------------------------------------------------------------------------------------------------

// A noise with `density` kernel radii per unit along x and y, a wave vector per kernel radius, and its amplitude in a
// sum.
struct GaborImplLayer {
    GaborImplPixel at;
    gabor_vec2 density;
    gabor_vec2 wave;
    float amplitude;
    std::uint32_t seed;
};

// A layer of frequency 0.
GABOR_INLINE GaborImplLayer gabor_impl_spots_layer(GaborImplPixel at, gabor_vec2 density, std::uint32_t seed, int index) {
    return GaborImplLayer{at, density, gabor_vec2(0.0f), 1.0f, gabor_derived_seed(seed, index)};
}

GABOR_INLINE GaborImplLayer gabor_impl_waves_layer(GaborImplPixel at, gabor_vec2 density, float frequency, float orientation,
                                      std::uint32_t seed, int index) {
    return GaborImplLayer{at, density, gabor_wave_vector(frequency, orientation), 1.0f,
                          gabor_derived_seed(seed, index)};
}

// Octave i of `count`, each with spots of about half the previous size and `gain` times the amplitude.
GABOR_INLINE GaborImplLayer gabor_impl_octave(GaborImplPixel at, gabor_vec2 density, int i, int count, float gain, std::uint32_t seed) {
    float power = (1.0f - gabor_cpp_pow(gain, 2.0f * float(count))) / (1.0f - gain * gain);
    // 1.0214797 is ln 2.03 / ln 2
    return GaborImplLayer{at, density * gabor_cpp_exp2(1.0214797f * float(i)), gabor_vec2(0.0f),
                          gabor_cpp_pow(gain, float(i)) * gabor_cpp_inversesqrt(power), gabor_derived_seed(seed, i)};
}

// Two independent noises with their derivatives along x and y of p, the quadrature and noise of a layer's field; the
// share of their variance that a filter removed, and the covariance of their derivatives that it removed.
struct GaborImplPair {
    gabor_vec3 first;
    gabor_vec3 second;
    float removed;
    gabor_vec3 lost;
};

// All pairs of noises that one material needs.
struct GaborImplPairs {
    GaborImplPair pair_0;
    GaborImplPair pair_1;
    GaborImplPair pair_2;
    GaborImplPair pair_3;
    GaborImplPair pair_4;
};

GABOR_INLINE GaborImplPair gabor_impl_no_pair() {
    return GaborImplPair{gabor_vec3(0.0f), gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f)};
}

GABOR_INLINE GaborImplPairs gabor_impl_no_pairs() {
    GaborImplPair none = gabor_impl_no_pair();
    return GaborImplPairs{none, none, none, none, none};
}

// `whole` is the covariance of the plain field's gradient, and `left` what is left of it.
GABOR_INLINE GaborImplPair gabor_impl_pair(GaborImplLayer layer, GaborField field, gabor_vec3 whole, gabor_vec3 left) {
    gabor_vec2 x = layer.density * layer.at.by_x, y = layer.density * layer.at.by_y;
    gabor_vec3 lost = gabor_vec3(0.0f);
    if (layer.at.filtered)
        lost = gabor_impl_turned_square(whole - left, x, y)
             + gabor_impl_warp_lost(layer.at, layer.density * layer.density * whole.xy());
    return GaborImplPair{gabor_vec3(field.quadrature, gabor_cpp_dot(field.quadrature_gradient, x), gabor_cpp_dot(field.quadrature_gradient, y)),
                         gabor_vec3(field.noise, gabor_cpp_dot(field.gradient, x), gabor_cpp_dot(field.gradient, y)), field.removed, lost};
}

GABOR_INLINE GaborImplPair gabor_impl_plus(GaborImplPair sum, GaborImplPair pair, float amplitude) {
    return GaborImplPair{sum.first + amplitude * pair.first, sum.second + amplitude * pair.second,
                         sum.removed + amplitude * amplitude * pair.removed,
                         sum.lost + amplitude * amplitude * pair.lost};
}

// What a filter does to a layer. Nearly, the window of a node is a Gaussian of variance v = 3/(2 pi^2), and its wave
// exp(2 pi i F.d). A filter of covariance S widens the window to v + S, turns the wave vector F into
// K = (1 + S/v)^-1 F, and leaves the share exp(-6 F.(F - K)) / sqrt(|1 + S/v|) of the variance.
struct GaborImplKept {
    gabor_vec2 wave;
    float share;
    gabor_vec2 widened; // S/v along x and y
};

GABOR_INLINE GaborImplKept gabor_impl_kept(GaborImplLayer layer) {
    gabor_vec4 steps = gabor_impl_radii(layer.at, layer.density);
    gabor_vec3 s = 1.6449341f * (gabor_impl_square(steps.xy()) + gabor_impl_square(steps.zw())); // pi^2 / 6
    float d = (1.0f + s.x) * (1.0f + s.y) - s.z * s.z;
    gabor_vec2 wave = ((1.0f + s.yx()) * layer.wave - s.z * layer.wave.yx()) / d;
    return GaborImplKept{wave, gabor_cpp_exp(-6.0f * gabor_cpp_dot(layer.wave, layer.wave - wave)) * gabor_cpp_inversesqrt(d), s.xy()};
}

GABOR_INLINE GaborImplPair gabor_impl_spots_pair(GaborImplLayer layer) {
    return gabor_impl_pair(layer, gabor_impl_spots(gabor_impl_place(layer.at, layer.density), layer.seed), gabor_vec3(0.0f),
                           gabor_vec3(0.0f));
}

// A sum and an octave of it.
GABOR_INLINE GaborImplPair gabor_impl_plus_octave(GaborImplPair sum, GaborImplLayer layer) {
    return gabor_impl_plus(sum, gabor_impl_spots_pair(layer), layer.amplitude);
}

GABOR_INLINE GaborImplPair gabor_impl_waves_pair(GaborImplLayer layer) {
    return gabor_impl_pair(layer, gabor_field(gabor_impl_place(layer.at, layer.density), layer.wave, layer.seed),
                           gabor_vec3(0.0f), gabor_vec3(0.0f));
}

// The same, filtered with the windows of gabor_fractal.hpp.
GABOR_INLINE GaborImplPair gabor_impl_filtered_spots(GaborImplLayer layer) {
    GaborPlace place = gabor_impl_place(layer.at, layer.density);
    GaborImplKept kept = gabor_impl_kept(layer);
    // 0.34195899 is 27/(8 pi^2)
    gabor_vec2 inverse_width = gabor_vec2(gabor_impl_inverse_width(0.34195899f * kept.widened.x),
                              gabor_impl_inverse_width(0.34195899f * kept.widened.y));
    std::uint32_t salt = gabor_impl_salt(layer.seed);
    GaborImplLine x =
        gabor_impl_smooth_line_filtered(place.cell.x, place.local.x, place.period.x, salt, inverse_width.x);
    GaborImplLine y = gabor_impl_smooth_line_filtered(place.cell.y, place.local.y, place.period.y,
                                                      salt ^ GABOR_IMPL_ROWS, inverse_width.y);
    // 1.7777778 is 16/9: see gabor_impl_smooth_line_filtered
    float scale = gabor_cpp_sqrt(1.7777778f * kept.share * inverse_width.x * inverse_width.y) / GABOR_IMPL_DEVIATION;
    gabor_vec2 value = gabor_vec2(0.0f);
    gabor_vec4 slope = gabor_vec4(0.0f);
    gabor_impl_add_four_spots(value, slope, x, y.word.x, y.even.x, y.even_slope.x);
    gabor_impl_add_four_spots(value, slope, x, y.word.y, y.even.y, y.even_slope.y);
    gabor_impl_add_four_spots(value, slope, x, y.word.z, y.even.z, y.even_slope.z);
    gabor_impl_add_four_spots(value, slope, x, y.word.w, y.even.w, y.even_slope.w);
    GaborField field = gabor_impl_spots_field(value, slope, scale, scale * place.cells_per_radius);
    field.removed = 1.0f - kept.share;
    // 3.2898681 is pi^2 / 3 and 7.4022033 is 3/4 pi^2; the plain windows have a half-width of 3/2
    return gabor_impl_pair(layer, field, gabor_vec3(3.2898681f, 3.2898681f, 0.0f),
                           gabor_vec3(7.4022033f * kept.share * inverse_width * inverse_width, 0.0f));
}

GABOR_INLINE GaborImplPair gabor_impl_plus_filtered_octave(GaborImplPair sum, GaborImplLayer layer) {
    return gabor_impl_plus(sum, gabor_impl_filtered_spots(layer), layer.amplitude);
}

// Filtered waves have the plain windows: where others would fit better, little is left.
GABOR_INLINE GaborImplPair gabor_impl_filtered_waves(GaborImplLayer layer) {
    GaborImplKept kept = gabor_impl_kept(layer);
    GaborField field = GaborField{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec2(0.0f), 0.0f};
    gabor_impl_add_field(field, gabor_field(gabor_impl_place(layer.at, layer.density), kept.wave, layer.seed),
                         gabor_cpp_sqrt(kept.share), gabor_vec2(1.0f));
    field.removed = 1.0f - kept.share;
    // 3.2898681 is pi^2 / 3 and 39.478418 is 4 pi^2
    gabor_vec3 spots = gabor_vec3(3.2898681f, 3.2898681f, 0.0f);
    return gabor_impl_pair(layer, field, spots + 39.478418f * gabor_impl_square(layer.wave),
                           kept.share * (spots + 39.478418f * gabor_impl_square(kept.wave)));
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// The normal distribution function, within 2e-5.
GABOR_INLINE float gabor_impl_below(float x) {
    x = gabor_cpp_clamp(x, -8.0f, 8.0f);
    // fit: see tools/constants.py
    return 1.0f / (1.0f + gabor_cpp_exp2(-x * (2.301726f + x * x * (0.1061787f - 0.00091164f * x * x))));
}

// A soft threshold: the normal distribution function of (noise - threshold) / softness.
GABOR_INLINE gabor_vec3 gabor_impl_above(gabor_vec3 noise, float removed, float threshold, float softness) {
    float scale = gabor_cpp_inversesqrt(softness * softness + removed);
    float x = scale * noise.x - scale * threshold;
    return gabor_vec3(gabor_impl_below(x), 0.39894228f * scale * gabor_cpp_exp(-0.5f * gabor_cpp_min(x * x, 100.0f)) * noise.yz()); // 1/sqrt(2 pi)
}

// What the filter removed of a mean square: 0 without a filter, in spite of rounding.
GABOR_INLINE float gabor_impl_removed_square(float square, float mean, float removed) {
    return removed > 0.0f ? gabor_cpp_max(square - mean * mean, 0.0f) : 0.0f;
}

// The variance that the filter removed of the threshold itself, nearly.
GABOR_INLINE float gabor_impl_above_variance(float above, float removed, float softness) {
    return above * (1.0f - above) * removed / (removed + 1.5f * softness * softness);
}

// The covariance of its slopes that the filter removed.
GABOR_INLINE gabor_vec3 gabor_impl_above_lost(gabor_vec3 noise, float removed, gabor_vec3 lost, float threshold, float softness) {
    float scale = gabor_cpp_inversesqrt(softness * softness + removed), variance = 0.5f * softness * softness + removed;
    float d = (noise.x - threshold) * (noise.x - threshold);
    float mean = 0.39894228f * scale * gabor_cpp_exp(-0.5f * gabor_cpp_min(d * scale * scale, 100.0f)); // 1/sqrt(2 pi)
    // 0.11253954 is 1/(2 pi sqrt(2))
    float square = 0.11253954f / softness * gabor_cpp_inversesqrt(variance) * gabor_cpp_exp(-0.5f * gabor_cpp_min(d / variance, 100.0f));
    return square * lost + gabor_impl_removed_square(square, mean, removed) * gabor_impl_square(noise.yz());
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
GABOR_INLINE gabor_vec3 gabor_impl_line(gabor_vec3 noise, float removed, float width) {
    float variance = width * width + removed;
    float line_ = width * gabor_cpp_inversesqrt(variance) * gabor_cpp_exp(-0.5f * gabor_cpp_min(noise.x * noise.x / variance, 100.0f));
    return line_ * gabor_vec3(1.0f, -noise.x / variance * noise.yz());
}

// The covariance of its slopes that the filter removed.
GABOR_INLINE gabor_vec3 gabor_impl_line_lost(gabor_vec3 noise, float removed, gabor_vec3 lost, float width) {
    float half_square = 0.5f * width * width, variance = half_square + removed;
    float mean = noise.x * half_square / variance, spread = half_square * removed / variance;
    float square = gabor_cpp_sqrt(half_square / variance) * gabor_cpp_exp(-0.5f * gabor_cpp_min(noise.x * noise.x / variance, 100.0f))
                 * (mean * mean + spread) / (4.0f * half_square * half_square);
    gabor_vec3 slope = gabor_impl_line(gabor_vec3(noise.x, 1.0f, 0.0f), removed, width);
    return square * lost + gabor_impl_removed_square(square, slope.y, removed) * gabor_impl_square(noise.yz());
}

// A factor of mean 1, exp(contrast noise - contrast^2 / 2), as its logarithm and the variance of the logarithm that the
// filter removed. A product of factors is the sum of their vectors.
GABOR_INLINE gabor_vec2 gabor_impl_tone(float noise, float removed, float contrast) {
    return gabor_vec2(contrast * noise - 0.5f * contrast * contrast, contrast * contrast * removed);
}

// The mean of min(colour * tone, 1). If the logarithm of X is normal with mean m and variance r, and P is the normal
// distribution function, the mean of min(c X, 1) is c e^(m + r/2) P(d - sqrt(r)) + 1 - P(d), where d = -(ln c + m) /
// sqrt(r). Where d > 3, this is nearly the mean of c X: if all of a colour is so dark, only its first part gets the
// rest. Materials mix colours after this, so that means remain right.
GABOR_INLINE gabor_vec3 gabor_impl_toned(gabor_vec3 colour, gabor_vec2 tone) {
    gabor_vec3 mean = colour * gabor_cpp_exp(tone.x + 0.5f * tone.y);
    if (tone.y > 0.0f) {
        float s = gabor_cpp_sqrt(tone.y);
        int parts = gabor_cpp_max(gabor_cpp_max(colour.x, colour.y), colour.z) * gabor_cpp_exp(tone.x + 3.0f * s) > 1.0f ? 3 : 1, i = 0;
        do { // a loop, because drivers for CPUs run both sides of a branch
            float d = (-tone.x - gabor_cpp_log(gabor_cpp_max(colour.x, 1.0e-6f))) / s;
            mean = gabor_vec3(mean.yz(), mean.x * gabor_impl_below(d - s) + 1.0f - gabor_impl_below(d));
            colour = colour.yzx();
        } while (++i < parts);
        if (parts == 1) mean = mean.zxy();
    }
    return gabor_cpp_min(mean, 1.0f);
}

// The square of a sawtooth that rises from 0 to 1, averaged over the phases that a vector of length `span` stands for:
// see gabor_impl_ends_at. `phase` is in turns.
GABOR_INLINE gabor_vec3 gabor_impl_rise(gabor_vec3 phase, gabor_vec3 span) {
    gabor_vec3 ends = gabor_impl_ends_at(phase.x, span.x);
    gabor_vec2 turns = gabor_cpp_floor(ends.xy()), t = ends.xy() - turns, integral = 0.33333333f * (turns + t * t * t); // 1/3
    float mean = ends.z * (integral.y - integral.x), change = ends.z * (t.y * t.y - t.x * t.x);
    // The change with the width, which is about 0.78 sqrt(1 - span).
    float widen = ends.z * (0.5f * (t.y * t.y + t.x * t.x) - mean) * (-0.5f / (ends.z * gabor_cpp_max(1.0f - span.x, 0.001f)));
    return gabor_vec3(mean, change * phase.yz() + widen * span.yz());
}

// The variance of its slope per turn over the phases that the filter added; at a span of `full`, it added none. Where
// the sawtooth rises, over a share 1 - w of the phases, its slope is 2 t; where it falls, over w, it is
// -(1 - w) (1 - w + 2 t) / w, with t from 0 to w.
GABOR_INLINE float gabor_impl_rise_lost(float phase, float span, float full) {
    gabor_vec3 ends = gabor_impl_ends_at(phase, span);
    gabor_vec2 turns = gabor_cpp_floor(ends.xy()), t = ends.xy() - turns;
    float w = 1.0f / gabor_impl_ends_at(0.0f, full).z, rise = 1.0f - w;
    // 1.3333333 is 4/3 and 0.33333333 is 1/3
    float risen = 1.3333333f - w * (2.0f - w + 0.33333333f * w * w), fallen = rise * rise * (1.0f / w + 0.33333333f * w);
    gabor_vec2 integral = risen * (turns + t * t * t) + fallen * turns;
    float change = ends.z * (t.y * t.y - t.x * t.x);
    return gabor_cpp_max(ends.z * (integral.y - integral.x) - change * change, 0.0f)
         * gabor_cpp_sqrt(gabor_cpp_max(1.0f - span * span / (full * full), 0.0f)); // an edge loses in proportion to the blur's length
}

// A smoothstep from `low` to `high`.
GABOR_INLINE gabor_vec3 gabor_impl_step(float low, float high, gabor_vec3 x) {
    float t = gabor_cpp_clamp((x.x - low) / (high - low), 0.0f, 1.0f);
    return gabor_vec3(t * t * (3.0f - 2.0f * t), 6.0f * t * (1.0f - t) / (high - low) * x.yz());
}

GABOR_INLINE GaborMaterial gabor_impl_material(gabor_vec3 colour, gabor_vec3 height, gabor_vec3 lost, float roughness, float metalness) {
    return GaborMaterial{gabor_cpp_clamp(colour, 0.0f, 1.0f), height.x, height.yz(), roughness, metalness, lost};
}

// ---- Wood ----------------------------------------------------------------------------------------------------------
//
// Rings are lines of constant x that noise of low frequency bends until they close.

GABOR_INLINE GaborImplPixel gabor_impl_board(GaborImplPixel pixel, GaborWood wood, std::uint32_t seed) {
    gabor_vec2 bends = gabor_vec2(0.43f, 0.018f) * wood.waviness;
    GaborImplPixel board = gabor_impl_warp(pixel, gabor_vec2(1.1f, 0.24f), gabor_vec2(bends.x, 0.0f), seed, 0);
    return gabor_impl_warp(board, gabor_vec2(4.0f, 0.9f), gabor_vec2(bends.y, 0.0f), seed, 1);
}

// Pores, fibres and tone.
GABOR_INLINE GaborImplLayer gabor_impl_wood_layer(int i, GaborImplPixel pixel, GaborImplPixel board, std::uint32_t seed) {
    if (i == 2) return gabor_impl_spots_layer(board, gabor_vec2(3.5f, 0.35f), seed, 5);
    return gabor_impl_spots_layer(pixel, i == 0 ? gabor_vec2(90.0f, 4.5f) : gabor_vec2(150.0f, 2.0f), seed, 3 + i);
}

GABOR_INLINE GaborMaterial gabor_impl_wood(GaborImplPixel board, GaborWood wood, GaborImplPairs of, std::uint32_t seed) {
    board = gabor_impl_warp(board, gabor_vec2(6.5f, 0.08f), gabor_vec2(0.455f / wood.rings, 0.0f), seed, 2);
    float rings = gabor_impl_repeated(board, wood.rings, 1.0f).x;
    gabor_vec3 years = rings * gabor_impl_along_x(board); // the number of rings up to here
    float kept = 0.97f * gabor_impl_sine_kept(board, rings); // amplitude of the rings' wave
    gabor_vec3 rise = gabor_impl_rise(gabor_vec3(years.x, 1.0f, 0.0f), gabor_vec3(kept, 0.0f, 0.0f)), ring = gabor_vec3(rise.x, rise.y * years.yz());
    gabor_vec3 open = gabor_impl_above(of.pair_0.second, of.pair_0.removed, 1.1f, 0.25f), pores = wood.pore_strength * open;
    gabor_vec3 within = gabor_vec3(1.0f, 0.0f, 0.0f) - 0.75f * ring; // a quarter as deep in late wood
    gabor_vec3 deep = gabor_impl_times(pores, within);
    float early = (1.0f - ring.x) * (1.0f - pores.x), late = ring.x * (1.0f - 0.25f * pores.x);
    gabor_vec2 tones = gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.11f)
               + gabor_impl_tone(of.pair_2.second.x, of.pair_2.removed, 0.13f);
    gabor_vec3 colour = early * gabor_impl_toned(wood.earlywood_colour, tones)
        + late * gabor_impl_toned(wood.latewood_colour, tones)
                + 0.45f * deep.x * wood.latewood_colour;
    gabor_vec3 height = 0.0006f * ring - 0.0024f * deep + 0.0002f * of.pair_1.second;
    // Mean squares: of the depth of pores, and of the height's derivative by the rings.
    float depth = 5.76e-6f * wood.pore_strength * wood.pore_strength
        * (within.x * within.x + 0.05f * (1.0f - kept * kept));
    float by_ring = 0.0006f + 0.0018f * pores.x, spread = 3.24e-6f * wood.pore_strength * wood.pore_strength
        * gabor_impl_above_variance(open.x, of.pair_0.removed, 0.25f);
    float steep = gabor_impl_rise_lost(years.x, kept, 0.97f), all_steep = gabor_impl_rise_lost(0.0f, 0.0f, 0.97f);
    gabor_vec3 lost = ((by_ring * by_ring + spread) * steep + spread * rise.y * rise.y) * gabor_impl_square(years.yz())
              + (by_ring * by_ring + spread) * all_steep * gabor_impl_warp_lost(board, gabor_vec2(rings * rings, 0.0f))
              + 4.0e-8f * of.pair_1.lost
              + depth * gabor_impl_above_lost(of.pair_0.second, of.pair_0.removed, of.pair_0.lost, 1.1f, 0.25f);
    return gabor_impl_material(colour, height, lost, wood.roughness * (1.0f - 0.2f * ring.x), 0.0f);
}

GABOR_INLINE GaborMaterial gabor_wood_at(gabor_vec2 p, gabor_vec2 period, GaborWood wood, std::uint32_t seed) {
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
GABOR_INLINE float gabor_impl_sample_spread(gabor_vec2 dx, gabor_vec2 dy) {
    return gabor_cpp_sqrt(0.125f * (gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy)));
}

// The number of samples for that standard deviation, 4 or `most`, if they have the share `kept` in the result.
GABOR_INLINE int gabor_impl_samples(float spread, float kept, int most) {
    return spread < 0.001f || kept == 0.0f ? 1 : spread < 0.12f ? 4 : most;
}

// Sample i of 4, 8 or 12 in steps (dx, dy) from the middle of the pixel: quantiles of a normal distribution.
GABOR_INLINE gabor_vec2 gabor_impl_sample(int i, int count) {
    int j = count > 8 ? (5 * i + 4) % 13 : count > 4 ? (5 * i + 2) % 8 : (2 * i + 1) % 5;
    gabor_vec2 at = gabor_vec2(float(i), float(j)) * (2.0f / float(count));
    at -= 1.0f - 1.0f / float(count);
    return count > 1 ? at * (0.5566f + 0.507f * at * at) : gabor_vec2(0.0f);
}

// The sum of heights over samples. `height` becomes their mean, which fades to `mean`; `lost` has the sum of the
// slopes' squares, and becomes their covariance, which fades to `square`.
GABOR_INLINE void gabor_impl_average(gabor_vec3& height, gabor_vec3& lost, int count, float kept, float mean, gabor_vec3 square) {
    height = kept / float(count) * height + gabor_vec3((1.0f - kept) * mean, 0.0f, 0.0f);
    lost = count > 1 || kept == 0.0f ? gabor_cpp_mix(square, lost / float(count), kept) - gabor_impl_square(height.yz())
                                    : gabor_vec3(0.0f);
}

// ---- Weaves --------------------------------------------------------------------------------------------------------

GABOR_INLINE GaborImplPixel gabor_impl_cloth(GaborImplPixel pixel, GaborFabric fabric, std::uint32_t seed) {
    return gabor_impl_warp(pixel, gabor_vec2(0.7f), gabor_vec2(0.02f * fabric.unevenness), seed, 0);
}

// The thickness and course of threads along y and x, and their fibres.
GABOR_INLINE GaborImplLayer gabor_impl_fabric_layer(int i, GaborImplPixel cloth, gabor_vec2 count, std::uint32_t seed) {
    gabor_vec2 density = i == 0 ? gabor_vec2(0.7f * count.x, 1.1f) : i == 1 ? gabor_vec2(1.1f, 0.7f * count.y)
                 : i == 2 ? gabor_vec2(14.0f, 2.0f) * count : gabor_vec2(2.0f, 14.0f) * count;
    return gabor_impl_spots_layer(cloth, density, seed, 1 + i);
}

// Threads per unit; a weave repeats after 2, 4 or 16 of them.
GABOR_INLINE gabor_vec2 gabor_impl_threads(GaborImplPixel pixel, GaborFabric fabric) {
    return gabor_impl_repeated(pixel, fabric.threads, fabric.weave < 0.5f ? 2.0f : fabric.weave < 1.5f ? 4.0f : 16.0f);
}

// 1 where the thread along y passes over that along x, which have these numbers, and -1 where it passes under.
GABOR_INLINE float gabor_impl_over(float x, float y, float weave) {
    if (weave < 0.5f) return gabor_cpp_fract(0.5f * (x + y)) > 0.25f ? -1.0f : 1.0f;
    if (weave > 1.5f) x = gabor_cpp_abs(16.0f * gabor_cpp_fract(0.0625f * x + 0.03125f) - 8.5f); // turns back every eight threads
    return gabor_cpp_fract(0.25f * (x + y) + 0.125f) < 0.5f ? 1.0f : -1.0f; // over two, under two
}

// The height of a thread: a circle of radius `thick`, which passes over the crossing thread if `bend` is 1, under if
// -1, and is level towards a thread that it crosses on the same side.
GABOR_INLINE gabor_vec3 gabor_impl_thread(gabor_vec3 across, gabor_vec3 thick, gabor_vec3 along, float bend, bool level) {
    float square = thick.x * thick.x - 4.2f * across.x * across.x;
    float side = gabor_cpp_sqrt(gabor_cpp_max(square, 0.0f)), turn = level ? 0.0f : 3.1415927f * along.x; // pi
    gabor_vec2 slope = (thick.x * thick.yz() - 4.2f * across.x * across.yz()) / gabor_cpp_max(side, 0.05f);
    // 1.7278760 is 0.55 pi
    return gabor_vec3(side - (square < 0.0f ? 2.0f : 1.0f) + 0.55f * bend * gabor_cpp_cos(turn),
                (square < 0.0f ? gabor_vec2(0.0f) : slope) - 1.7278760f * bend * gabor_cpp_sin(turn) * along.yz());
}

// The means to which the filter fades the weave were measured; they depend on the unevenness.
GABOR_INLINE GaborMaterial gabor_impl_fabric(GaborImplPixel cloth, gabor_vec2 count, GaborFabric fabric, GaborImplPairs of) {
    float uneven = fabric.unevenness, unit = fabric.relief / fabric.threads;
    gabor_vec3 at_x = count.x * gabor_impl_along_x(cloth), at_y = count.y * gabor_impl_along_y(cloth);
    gabor_vec2 dx = count * cloth.dx, dy = count * cloth.dy;
    float spread = gabor_impl_sample_spread(dx, dy), kept = 1.0f - gabor_cpp_smoothstep(0.3f, 0.7f, spread);
    at_x += 0.13f * uneven * of.pair_0.first;
    at_y += 0.13f * uneven * of.pair_1.first;
    gabor_vec2 warp_tones = gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, 0.09f * uneven)
                    + gabor_impl_tone(of.pair_2.second.x, of.pair_2.removed, 0.12f);
    gabor_vec2 weft_tones = gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, 0.09f * uneven)
                    + gabor_impl_tone(of.pair_3.second.x, of.pair_3.removed, 0.12f);
    gabor_vec3 warp = gabor_impl_toned(fabric.warp_colour, warp_tones),
        weft = gabor_impl_toned(fabric.weft_colour, weft_tones);
    gabor_vec3 height = gabor_vec3(0.0f), colour = gabor_vec3(0.0f), lost = gabor_vec3(0.0f);
    int samples = gabor_impl_samples(spread, kept, 8);
    for (int i = 0; i < samples; ++i) {
        gabor_vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        gabor_vec3 x = at_x + gabor_vec3(offset.x, 0.0f, 0.0f), y = at_y + gabor_vec3(offset.y, 0.0f, 0.0f);
        gabor_vec2 thread_ = gabor_cpp_floor(gabor_vec2(x.x, y.x));
        x.x -= thread_.x + 0.5f;
        y.x -= thread_.y + 0.5f;
        float over = gabor_impl_over(thread_.x, thread_.y, fabric.weave);
        bool level_y = over == gabor_impl_over(thread_.x, thread_.y + (y.x < 0.0f ? -1.0f : 1.0f), fabric.weave);
        bool level_x = over == gabor_impl_over(thread_.x + (x.x < 0.0f ? -1.0f : 1.0f), thread_.y, fabric.weave);
        gabor_vec3 along_y = gabor_impl_thread(x, gabor_vec3(1.0f, 0.0f, 0.0f) + 0.16f * uneven * of.pair_0.second, y, over, level_y);
        gabor_vec3 along_x = gabor_impl_thread(y, gabor_vec3(1.0f, 0.0f, 0.0f) + 0.16f * uneven * of.pair_1.second, x, -over, level_x);
        bool first = along_y.x > along_x.x;
        gabor_vec3 top = first ? along_y : along_x;
        if (top.x < -1.3f) top = gabor_vec3(-1.3f, 0.0f, 0.0f);
        colour += gabor_cpp_mix(0.18f, 1.0f, gabor_cpp_smoothstep(-1.3f, 0.5f, top.x)) * (first ? warp : weft);
        top = 0.3f * top + 0.035f * (first ? of.pair_2.second : of.pair_3.second);
        height += top;
        lost += gabor_impl_square(top.yz());
    }
    gabor_vec3 mean =
        gabor_vec3(0.8828f - 0.0056f * uneven * uneven, 0.0406f + 0.0025f * uneven * uneven, 0.29f); // light, height, slope
    if (fabric.weave >= 0.5f) mean = gabor_vec3(0.91f - uneven * (0.0105f + 0.0045f * uneven), 0.0655f, 0.37f);
    gabor_impl_average(height, lost, samples, kept, mean.y, gabor_vec3(mean.z * count * count, 0.0f));
    float bare = fabric.cords > 0.0f ? 0.12f : 1.0f; // pile hides the weave of corduroy
    colour = gabor_cpp_mix(0.5f * mean.x * (warp + weft), colour / float(samples), bare * kept);
    unit *= bare;
    height *= unit;
    lost = unit * unit * (lost + 0.0006125f * (of.pair_2.lost + of.pair_3.lost));
    if (fabric.cords > 0.0f) { // wide crests and narrow furrows, 1 - cos(pi x)^4: two waves, which the filter damps
        float cords = gabor_impl_repeated(cloth, fabric.cords, 1.0f).x;
        gabor_vec3 at = cords * gabor_impl_along_x(cloth);
        float damped = gabor_impl_sine_kept(cloth, cords), half_cord = 0.5f * damped;
        float second = 0.125f * damped * damped * damped * damped, turn = 6.2831853f * gabor_cpp_fract(at.x); // 2 pi
        float cord = 0.625f - half_cord * gabor_cpp_cos(turn) - second * gabor_cpp_cos(2.0f * turn);
        float depth = 0.3f * fabric.relief / cords, swing = depth * 6.2831853f;
        colour *= gabor_cpp_mix(0.3f, 1.0f, cord);
        height += gabor_vec3(depth * cord, swing * (half_cord * gabor_cpp_sin(turn) + 2.0f * second * gabor_cpp_sin(2.0f * turn)) * at.yz());
        // 0.15625 is 5/32
        lost += swing * swing * (0.15625f - 0.5f * half_cord * half_cord - 2.0f * second * second)
                * gabor_impl_square(at.yz());
    }
    return gabor_impl_material(colour, height, lost, fabric.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_fabric_at(gabor_vec2 p, gabor_vec2 period, GaborFabric fabric, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel cloth = gabor_impl_cloth(pixel, fabric, seed);
    gabor_vec2 count = gabor_impl_threads(pixel, fabric);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_fabric_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_fabric_layer(1, cloth, count, seed));
    of.pair_2 = gabor_impl_spots_pair(gabor_impl_fabric_layer(2, cloth, count, seed));
    of.pair_3 = gabor_impl_spots_pair(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of);
}

GABOR_INLINE GaborImplPixel gabor_impl_twill(GaborImplPixel pixel, std::uint32_t seed) {
    return gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.008f), seed, 0);
}

// The fibres of tows along y and x.
GABOR_INLINE GaborImplLayer gabor_impl_tow_layer(int i, GaborImplPixel cloth, gabor_vec2 count, std::uint32_t seed) {
    return gabor_impl_spots_layer(cloth, (i == 0 ? gabor_vec2(32.0f, 0.6f) : gabor_vec2(0.6f, 32.0f)) * count, seed, 1 + i);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
GABOR_INLINE GaborMaterial gabor_impl_carbon_fibre(GaborImplPixel cloth, gabor_vec2 count, GaborCarbonFibre fibres, GaborImplPairs of) {
    gabor_vec3 at_x = count.x * gabor_impl_along_x(cloth), at_y = count.y * gabor_impl_along_y(cloth);
    gabor_vec2 dx = count * cloth.dx, dy = count * cloth.dy;
    float spread = gabor_impl_sample_spread(dx, dy), kept = 1.0f - gabor_cpp_smoothstep(0.5f, 0.9f, spread);
    float unit = fibres.relief / fibres.tows;
    gabor_vec3 warp = gabor_impl_toned(fibres.colour,
                                 gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, fibres.fibre_contrast));
    gabor_vec3 weft = gabor_impl_toned(fibres.colour,
                                 gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, fibres.fibre_contrast));
    gabor_vec3 height = gabor_vec3(0.0f), colour = gabor_vec3(0.0f), lost = gabor_vec3(0.0f);
    int samples = gabor_impl_samples(spread, kept, 8);
    for (int i = 0; i < samples; ++i) {
        gabor_vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        gabor_vec3 x = at_x + gabor_vec3(offset.x, 0.0f, 0.0f), y = at_y + gabor_vec3(offset.y, 0.0f, 0.0f);
        float turn = 4.0f * gabor_cpp_fract(0.25f * (gabor_cpp_floor(x.x) + gabor_cpp_floor(y.x)) + 0.125f) - 0.5f; // 0 to 3
        x.x -= gabor_cpp_floor(x.x);
        y.x -= gabor_cpp_floor(y.x);
        bool first = turn < 1.5f;
        gabor_vec3 along = 0.5f * (first ? y : x), across = 2.0f * (first ? x : y);
        along.x += gabor_cpp_fract(0.5f * turn + 0.25f) < 0.5f ? 0.0f : 0.5f; // from 0 to 1 over two rows
        across.x -= 1.0f;
        float cube = across.x * across.x * across.x, low = 1.0f - cube * across.x, arch = low * low;
        gabor_vec2 wave = gabor_vec2(gabor_cpp_cos(3.1415927f * along.x), gabor_cpp_sin(3.1415927f * along.x)); // pi
        gabor_vec3 bulge = gabor_vec3(wave.y * arch, 3.1415927f * arch * wave.x * along.yz() - 8.0f * cube * low * wave.y * across.yz());
        colour += (0.35f + 0.65f * bulge.x) * (first ? warp : weft);
        bulge = 0.16f * bulge + 0.0035f * (first ? of.pair_0.first : of.pair_1.first);
        height += bulge;
        lost += gabor_impl_square(bulge.yz());
    }
    // The bulge's mean is 0.4527, and its slope's mean square, over tows along x and y, 2.154.
    // 0.072432 is 0.16 * 0.4527
    gabor_impl_average(height, lost, samples, kept, 0.072432f, 0.0256f * 2.154f * gabor_vec3(count * count, 0.0f));
    colour = gabor_cpp_mix(0.3221275f * (warp + weft), colour / float(samples), kept); // (0.35 + 0.65 * 0.4527) / 2
    lost = unit * unit * (lost + 6.125e-6f * (of.pair_0.lost + of.pair_1.lost));
    return gabor_impl_material(colour, unit * height, lost, fibres.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre_at(gabor_vec2 p, gabor_vec2 period, GaborCarbonFibre fibres, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborImplPixel cloth = gabor_impl_twill(pixel, seed);
    gabor_vec2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0f);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_spots_pair(gabor_impl_tow_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_spots_pair(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of);
}

// ---- Leather -------------------------------------------------------------------------------------------------------
//
// Three waves. The phase of the third is the sum of the other two, so the crests of all three meet in each cell's
// middle.

GABOR_INLINE GaborImplPixel gabor_impl_skin(GaborImplPixel pixel, GaborLeather leather, std::uint32_t seed) {
    gabor_vec2 bends = gabor_vec2(0.07f, 0.014f) * leather.waviness;
    GaborImplPixel skin = gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(bends.x), seed, 0);
    return gabor_impl_warp(skin, gabor_vec2(4.0f), gabor_vec2(bends.y), seed, 1);
}

// Three octaves of fine grain, the tone, and the first two waves.
GABOR_INLINE GaborImplLayer gabor_impl_leather_layer(int i, GaborImplPixel pixel, GaborImplPixel skin, GaborLeather leather,
                                        std::uint32_t seed) {
    if (i < 3) return gabor_impl_octave(pixel, gabor_vec2(18.0f), i, 3, 0.75f, gabor_derived_seed(seed, 4));
    if (i == 3) return gabor_impl_spots_layer(pixel, gabor_vec2(0.8f), seed, 5);
    // 2.2944 is 0.2 + 2/3 pi
    return gabor_impl_waves_layer(skin, gabor_vec2(leather.cells / 1.6f), 1.6f, i == 4 ? 0.2f : 2.2944f, seed, i - 2);
}

// Waves at an offset: their envelope moves along its slope, and the phase turns.
GABOR_INLINE GaborImplPair gabor_impl_moved_waves(GaborImplPair waves, GaborImplPixel at, gabor_vec2 wave, gabor_vec2 offset, float turns) {
    gabor_vec2 turn = gabor_impl_wave(turns);
    gabor_vec3 phase = 6.2831853f * gabor_vec3(0.0f, gabor_cpp_dot(wave, at.by_x), gabor_cpp_dot(wave, at.by_y)); // 2 pi
    gabor_vec3 a = waves.first + waves.second.x * phase, b = waves.second - waves.first.x * phase; // the envelope's slopes
    a.x += gabor_cpp_dot(a.yz(), offset);
    b.x += gabor_cpp_dot(b.yz(), offset);
    gabor_vec3 first = turn.x * a - turn.y * b, second = turn.y * a + turn.x * b;
    return GaborImplPair{first - second.x * phase, second + first.x * phase, 0.0f, gabor_vec3(0.0f)};
}

// Brings the waves of a pair near length 1: their cosine and sine.
GABOR_INLINE void gabor_impl_crest(GaborImplPair waves, gabor_vec3& cosine, gabor_vec3& sine) {
    float power = waves.first.x * waves.first.x + waves.second.x * waves.second.x + 0.12f;
    gabor_vec2 change = waves.first.x * waves.first.yz() + waves.second.x * waves.second.yz();
    gabor_vec3 unit = gabor_cpp_inversesqrt(power) * gabor_vec3(1.0f, -1.0f / power * change);
    cosine = gabor_impl_times(waves.first, unit);
    sine = gabor_impl_times(waves.second, unit);
}

// The means to which the filter fades, and the mean squares of the slopes, were measured.
GABOR_INLINE GaborMaterial gabor_impl_leather(GaborImplPixel pixel, GaborImplPixel skin, GaborLeather leather, GaborImplPairs of) {
    // 2.2944 is 0.2 + 2/3 pi
    gabor_vec2 wave_a = gabor_wave_vector(leather.cells, 0.2f), wave_b = gabor_wave_vector(leather.cells, 2.2944f);
    gabor_vec2 dx = gabor_vec2(gabor_cpp_dot(wave_a, skin.dx), gabor_cpp_dot(wave_b, skin.dx));
    gabor_vec2 dy = gabor_vec2(gabor_cpp_dot(wave_a, skin.dy), gabor_cpp_dot(wave_b, skin.dy));
    float spread = gabor_impl_sample_spread(dx, dy), bend = gabor_cpp_exp(-60.0f * spread * spread);
    float kept = 1.0f - gabor_cpp_smoothstep(0.4f, 0.8f, spread), share = 0.0f, grains = 0.0f;
    gabor_vec3 height = gabor_vec3(0.0f), lost = gabor_vec3(0.0f);
    int samples = gabor_impl_samples(spread, kept, 12);
    for (int i = 0; i < samples; ++i) {
        gabor_vec2 at = gabor_impl_sample(i, samples), offset = at.x * dx + at.y * dy;
        gabor_vec2 further = bend * (at.x * pixel.dx + at.y * pixel.dy);
        gabor_vec3 a, b, sine_a, sine_b;
        gabor_impl_crest(gabor_impl_moved_waves(of.pair_2, skin, wave_a, further, offset.x), a, sine_a);
        gabor_impl_crest(gabor_impl_moved_waves(of.pair_3, skin, wave_b, further, offset.y), b, sine_b);
        // 3 in the middle of a cell, -1.5 in a corner
        gabor_vec3 cells = a + b + gabor_impl_times(a, b) - gabor_impl_times(sine_a, sine_b);
        gabor_vec3 grained = cells + 0.1f * of.pair_0.second;
        gabor_vec2 pebble = gabor_impl_step(-1.45f, -0.55f, gabor_vec3(grained.x, 1.0f, 0.0f)).xy(); // with its derivative
        share += pebble.x;
        gabor_vec3 relief = 0.016f * gabor_vec3(pebble.x, pebble.y * grained.yz()) + 0.013f * gabor_impl_step(-1.0f, 3.0f, cells)
                    + 0.0008f * of.pair_0.second;
        float grain = 0.0016f * pebble.y + 0.0008f; // the height's derivative by the grain
        grains += grain * grain;
        height += relief;
        lost += gabor_impl_square(relief.yz());
    }
    gabor_vec3 square = leather.cells * leather.cells * gabor_vec3(0.00235f, 0.00194f, -0.0001f); // along the skin's axes
    gabor_vec3 warped = gabor_impl_warp_lost(skin, square.xy());
    square = gabor_impl_turned_square(square, skin.by_x, skin.by_y);
    // 0.015964 was measured; tools/constants.py derives 0.01595
    gabor_impl_average(height, lost, samples, kept, 0.015964f, square);
    share = gabor_cpp_mix(0.806f, share / float(samples), kept);
    // Wrinkles along the zeros of the grain's other noise, and pores at its peaks.
    GaborImplPair fine = of.pair_0;
    gabor_vec3 wrinkle = gabor_impl_line(fine.first, fine.removed, 0.25f);
    gabor_vec3 pore = gabor_impl_above(fine.first, fine.removed, 1.8f, 0.2f);
    height -= 0.0018f * wrinkle + 0.004f * pore;
    share *= 1.0f - 0.25f * wrinkle.x - 0.6f * pore.x;
    gabor_vec2 tones = gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.14f);
    gabor_vec3 colour = gabor_cpp_mix(gabor_impl_toned(leather.crease_colour, tones), gabor_impl_toned(leather.pebble_colour, tones),
                      share);
    lost += warped + gabor_cpp_mix(3.67e-6f, grains / float(samples), kept) * of.pair_0.lost
          + 3.24e-6f * gabor_impl_line_lost(fine.first, fine.removed, fine.lost, 0.25f)
          + 1.6e-5f * gabor_impl_above_lost(fine.first, fine.removed, fine.lost, 1.8f, 0.2f);
    float unit = 0.6f * leather.relief;
    return gabor_impl_material(colour, unit * height, unit * unit * lost, leather.roughness + 0.15f * (1.0f - share),
                               0.0f);
}

GABOR_INLINE GaborMaterial gabor_leather_at(gabor_vec2 p, gabor_vec2 period, GaborLeather leather, std::uint32_t seed) {
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

GABOR_INLINE GaborImplPixel gabor_impl_stone(GaborImplPixel pixel, GaborMarble marble, std::uint32_t seed) {
    gabor_vec4 bends = gabor_vec4(0.17f, 0.038f, 0.010f, 0.003f) * marble.turbulence;
    GaborImplPixel stone = gabor_impl_warp(pixel, gabor_vec2(1.1f), gabor_vec2(bends.x), seed, 0);
    stone = gabor_impl_warp(stone, gabor_vec2(4.0f), gabor_vec2(bends.y), seed, 1);
    stone = gabor_impl_warp(stone, gabor_vec2(13.0f), gabor_vec2(bends.z), seed, 2);
    return gabor_impl_warp(stone, gabor_vec2(40.0f), gabor_vec2(bends.w), seed, 3);
}

// Three octaves of clouds, crystals, and four sizes of veins: middle, large, thin, hair.
GABOR_INLINE GaborImplLayer gabor_impl_marble_layer(int i, GaborImplPixel pixel, GaborImplPixel stone, std::uint32_t seed) {
    if (i < 3) return gabor_impl_octave(stone, gabor_vec2(1.5f), i, 3, 0.6f, gabor_derived_seed(seed, 8));
    if (i == 3) return gabor_impl_spots_layer(pixel, gabor_vec2(75.0f), seed, 9);
    gabor_vec3 vein = i == 4 ? gabor_vec3(1.9f, 0.95f, -0.45f) : i == 5 ? gabor_vec3(0.95f, 0.85f, 0.65f)
              : i == 6 ? gabor_vec3(4.5f, 0.95f, 0.95f) : gabor_vec3(13.0f, 0.9f, 0.2f);
    return gabor_impl_waves_layer(stone, gabor_vec2(vein.x), vein.y, vein.z, seed, i == 4 ? 5 : i == 5 ? 4 : i);
}

GABOR_INLINE GaborMaterial gabor_impl_marble(GaborMarble marble, GaborImplPair cloud, GaborImplPair crystal) {
    float clouds = marble.cloud_strength * gabor_impl_above(cloud.second, cloud.removed, 0.5f, 0.8f).x;
    gabor_vec3 colour = gabor_impl_toned(marble.stone_colour * (1.0f - clouds),
                                   gabor_impl_tone(crystal.first.x, crystal.removed, 0.02f));
    return gabor_impl_material(colour, 0.00012f * crystal.second, 1.44e-8f * crystal.lost, marble.roughness, 0.0f);
}

// Adds veins of layer i: lines along the zeros of a noise, drawn only where a second noise exceeds a threshold, so that
// they have ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
GABOR_INLINE void gabor_impl_add_veins(GaborMaterial& stone, GaborMarble marble, int i, GaborImplPair vein) {
    gabor_vec2 width = i == 4 ? gabor_vec2(0.25f, 0.035f) : i == 5 ? gabor_vec2(0.35f, 0.05f) : gabor_vec2(1.0f, i == 6 ? 0.04f : 0.05f);
    gabor_vec2 strength = marble.vein_strength * (i == 4 ? gabor_vec2(0.6f, 0.6f) : i == 5 ? gabor_vec2(0.55f, 0.75f) : gabor_vec2(0.0f, 0.45f));
    float threshold = i == 4 ? 0.5f : i == 5 ? -0.4f : i == 6 ? 0.8f : 1.1f;
    float open = gabor_impl_above(vein.second, vein.removed, threshold, 0.5f).x;
    // The second noise widens the core by exp(0.8 noise); so weighted, its removed part has a mean of 0.8 times its
    // variance.
    width.y *= 0.6f * gabor_cpp_exp(gabor_cpp_min(0.8f * vein.second.x, 2.4f) + 0.32f * vein.removed); // 0.8^2 / 2
    gabor_vec3 weighted = vein.second + gabor_vec3(0.8f * vein.removed, 0.0f, 0.0f);
    strength.y *= gabor_impl_above(weighted, vein.removed, threshold, 0.5f).x
                * gabor_impl_line(vein.first, vein.removed, width.y).x;
    strength.x *= open * gabor_impl_line(vein.first, vein.removed, width.x).x - strength.y;
    gabor_vec3 halo = gabor_cpp_mix(marble.stone_colour, marble.vein_colour, 0.65f);
    gabor_vec3 core = gabor_cpp_mix(marble.stone_colour, marble.vein_colour, i == 4 ? 0.9f : i == 5 ? 1.0f : i == 6 ? 0.65f : 0.45f);
    stone.colour += strength.x * (halo - stone.colour) + strength.y * (core - stone.colour);
    stone.colour = gabor_cpp_clamp(stone.colour, 0.0f, 1.0f);
}

GABOR_INLINE GaborMaterial gabor_marble_at(gabor_vec2 p, gabor_vec2 period, GaborMarble marble, std::uint32_t seed) {
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

GABOR_INLINE GaborImplPixel gabor_impl_dune(GaborImplPixel pixel, std::uint32_t seed) {
    GaborImplPixel dune = gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.15f), seed, 0);
    return gabor_impl_warp(dune, gabor_vec2(3.0f), gabor_vec2(0.02f), seed, 1);
}

// Three octaves of large shapes, grains, and ripples.
GABOR_INLINE GaborImplLayer gabor_impl_sand_layer(int i, GaborImplPixel pixel, GaborImplPixel dune, GaborSand sand, std::uint32_t seed) {
    if (i < 3) return gabor_impl_octave(pixel, gabor_vec2(0.6f), i, 3, 0.5f, gabor_derived_seed(seed, 4));
    if (i == 3) return gabor_impl_spots_layer(pixel, gabor_vec2(75.0f), seed, 3);
    return gabor_impl_waves_layer(dune, gabor_vec2(0.9f, 1.7f) / 3.87f * sand.ripples, 2.3f, 1.4f, seed, 2);
}

GABOR_INLINE GaborMaterial gabor_impl_sand(GaborSand sand, GaborImplLayer ripples, GaborImplPairs of) {
    gabor_vec2 z = gabor_vec2(of.pair_2.first.x, of.pair_2.second.x);
    float power = gabor_cpp_max(gabor_cpp_dot(z, z), 1.0e-6f), whole = power + 2.5f * of.pair_2.removed, span = 0.9f * gabor_cpp_sqrt(power / whole);
    gabor_vec2 change = z.x * of.pair_2.first.yz() + z.y * of.pair_2.second.yz(); // half the derivative of the power
    // 0.15915494 is 1/(2 pi)
    gabor_vec3 phase = gabor_vec3(gabor_turns_intensity(z.yx()).x,
                      0.15915494f / power * (z.x * of.pair_2.second.yz() - z.y * of.pair_2.first.yz()));
    gabor_vec3 ripple = gabor_impl_rise(phase, span * gabor_vec3(1.0f, (1.0f / power - 1.0f / whole) * change));
    gabor_vec2 tones = gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, sand.grain_contrast)
               + gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.06f);
    gabor_vec3 colour = gabor_cpp_mix(gabor_impl_toned(sand.trough_colour, tones), gabor_impl_toned(sand.crest_colour, tones),
                      ripple.x);
    float dark = gabor_impl_above(of.pair_1.second, of.pair_1.removed, 1.9f, 0.15f).x;
    float bright = gabor_impl_above(-of.pair_1.second, of.pair_1.removed, 1.9f, 0.15f).x;
    colour = gabor_cpp_mix(colour, 0.23f * sand.trough_colour, 3.75f * sand.grain_contrast * dark);
    colour = gabor_cpp_mix(colour, gabor_cpp_mix(sand.crest_colour, gabor_vec3(1.0f), 0.6f), 3.0f * sand.grain_contrast * bright);
    gabor_vec3 tall = gabor_vec3(sand.ripple_height, 0.0f, 0.0f) + 0.2f * sand.ripple_height * of.pair_0.first;
    gabor_vec3 height = gabor_impl_times(ripple, tall) + 0.03f * of.pair_0.first
        + 0.00875f * sand.grain_contrast * of.pair_1.first;
    gabor_vec2 wave = ripples.density * ripples.wave; // per unit of the dune
    wave = gabor_vec2(gabor_cpp_dot(wave, ripples.at.by_x), gabor_cpp_dot(wave, ripples.at.by_y));
    // The phase's mean square slope is that of the wave, and more where the noise is near 0: 0.4 was measured.
    gabor_vec3 bent = gabor_vec3(0.4f * ripples.density * ripples.density, 0.0f);
    gabor_vec3 square = gabor_impl_square(wave) + gabor_impl_turned_square(bent, ripples.at.by_x, ripples.at.by_y);
    gabor_vec3 warped = gabor_impl_warp_lost(
        ripples.at, ripples.density * ripples.density * (0.4f + ripples.wave * ripples.wave));
    // Mean squares of factors; 0.0888889 is 4/45, the variance of a ripple.
    float high = tall.x * tall.x + 0.04f * sand.ripple_height * sand.ripple_height * of.pair_0.removed;
    float by_shape = 0.03f + 0.2f * sand.ripple_height * ripple.x;
    float varied = 0.04f * sand.ripple_height * sand.ripple_height * 0.0888889f * (1.0f - span * span / 0.81f);
    // 7.65625e-5 is 0.00875^2
    gabor_vec3 lost = high * (gabor_impl_rise_lost(phase.x, span, 0.9f) * square
                        + gabor_impl_rise_lost(0.0f, 0.0f, 0.9f) * warped)
              + (by_shape * by_shape + varied) * of.pair_0.lost
              + 7.65625e-5f * sand.grain_contrast * sand.grain_contrast * of.pair_1.lost;
    return gabor_impl_material(colour, height, lost, sand.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_sand_at(gabor_vec2 p, gabor_vec2 period, GaborSand sand, std::uint32_t seed) {
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
GABOR_INLINE GaborImplLayer gabor_impl_metal_layer(int i, GaborImplPixel pixel, GaborBrushedMetal metal, std::uint32_t seed) {
    if (i >= 5) return gabor_impl_octave(pixel, gabor_vec2(1.3f), i - 5, 6, 0.75f, gabor_derived_seed(seed, 5));
    gabor_vec2 density = gabor_vec2(0.3f + 0.12f * gabor_cpp_exp2(float(i)), metal.streaks * gabor_cpp_exp2(float(i)));
    return gabor_impl_spots_layer(pixel, density, seed, i);
}

// The layers that the metal needs.
GABOR_INLINE int gabor_impl_metal_layers(GaborBrushedMetal metal) {
    return metal.patina_amount > 0.0f ? 11 : 5;
}

// Adds a layer: of the streaks, the first sum is the height, the second the tone.
GABOR_INLINE void gabor_impl_add_metal(GaborImplPairs& of, int i, GaborImplLayer layer, GaborImplPair pair) {
    if (i >= 5) {
        of.pair_1 = gabor_impl_plus(of.pair_1, pair, layer.amplitude);
        return;
    }
    float size = gabor_cpp_exp2(-float(i));
    of.pair_0.first += size * pair.first;
    of.pair_0.second += 0.4472136f * pair.second; // 1/sqrt(5)
    of.pair_0.removed += 0.2f * pair.removed;
    of.pair_0.lost += size * size * pair.lost;
}

GABOR_INLINE GaborMaterial gabor_impl_brushed_metal(GaborBrushedMetal metal, GaborImplPairs of) {
    gabor_vec3 colour =
        gabor_impl_toned(metal.metal_colour,
                         gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, metal.streak_contrast));
    gabor_vec3 height = metal.streak_height * of.pair_0.first,
        lost = metal.streak_height * metal.streak_height * of.pair_0.lost;
    if (metal.patina_amount <= 0.0f) return gabor_impl_material(colour, height, lost, metal.roughness, 1.0f);
    float threshold = 2.4f - 3.8f * metal.patina_amount;
    gabor_vec3 cover = gabor_impl_above(of.pair_1.second, of.pair_1.removed, threshold, 0.3f);
    gabor_vec3 patina = gabor_impl_toned(metal.patina_colour, gabor_impl_tone(of.pair_1.first.x, of.pair_1.removed, 0.3f));
    height += 0.003f * cover + 0.001f * of.pair_1.first;
    lost += 9.0e-6f * gabor_impl_above_lost(of.pair_1.second, of.pair_1.removed, of.pair_1.lost, threshold, 0.3f)
          + 1.0e-6f * of.pair_1.lost;
    return gabor_impl_material(gabor_cpp_mix(colour, patina, cover.x), height, lost, gabor_cpp_mix(metal.roughness, 0.85f, cover.x),
                               1.0f - cover.x);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal_at(gabor_vec2 p, gabor_vec2 period, GaborBrushedMetal metal, std::uint32_t seed) {
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

GABOR_INLINE GaborImplLayer gabor_impl_scratches_layer(int i, GaborImplPixel pixel, GaborScratches scratches, std::uint32_t seed) {
    // 3 - sqrt(5).
    float angle = scratches.scratch_direction
        + scratches.direction_spread * (2.0f * gabor_cpp_fract(0.0955f + 0.763932f * float(i)) - 1.0f);
    GaborImplPixel at = gabor_impl_turned(pixel, angle);
    // Across a tile's scratches, a period holds at least three nodes however short it is: bend less, or scratches
    // swell.
    float bend = at.period.y > 0.0f ? gabor_cpp_min(0.17f, 0.02f * at.period.y) : 0.17f;
    at = gabor_impl_warp(at, gabor_vec2(0.3f, 0.1f), gabor_vec2(0.0f, bend), seed, 2 * i);
    return gabor_impl_spots_layer(at, gabor_vec2(1.0f / scratches.scratch_length, 60.0f) * gabor_cpp_exp2(0.13f * float(i)), seed,
                                  2 * i + 1);
}

// Adds scratches: the height is in units of their depth, and the colour is the share of whole lacquer. A scratch is
// the overlap of two long ovals, which tapers at its ends: there, both noises of a pair exceed sharp thresholds.
GABOR_INLINE void gabor_impl_add_scratches(GaborMaterial& sum, GaborScratches scratches, int i, GaborImplPair noise) {
    float size = gabor_cpp_exp2(-0.13f * float(i));
    float threshold = gabor_cpp_sqrt(5.76f - 2.0f * gabor_cpp_log(scratches.amount)); // the area above it is about proportional to amount
    gabor_vec3 peak = gabor_impl_above(noise.first, noise.removed, threshold, 0.12f);
    gabor_vec3 open = gabor_impl_above(noise.second, noise.removed, 0.3f, 0.25f);
    gabor_vec3 scratch = gabor_impl_times(peak, open);
    sum.colour *= 1.0f - (0.25f + 0.7f * size) * scratch.x;
    sum.height -= size * scratch.x;
    sum.slope -= size * scratch.yz();
    // The mean square of `open`, as in gabor_impl_above_variance; 1.14 stands for its own slopes.
    // Beyond three deviations, the noise has fewer values than a normal law: a fit to amounts from 0.01 to 8.
    float rare = threshold / 3.85f, rarer = rare * rare * rare * rare;
    sum.lost += 1.14f / (1.0f + rarer * rarer) * size * size
              * open.x * gabor_cpp_mix(open.x, 1.0f, noise.removed / (noise.removed + 0.09375f))
              * gabor_impl_above_lost(noise.first, noise.removed, noise.lost, threshold, 0.12f);
}

GABOR_INLINE GaborMaterial gabor_impl_scratches(GaborScratches scratches, GaborMaterial sum) {
    gabor_vec3 height = scratches.depth * gabor_vec3(sum.height, sum.slope), lost = scratches.depth * scratches.depth * sum.lost;
    return gabor_impl_material(gabor_cpp_mix(scratches.scratch_colour, scratches.lacquer_colour, sum.colour), height, lost,
                               scratches.roughness,
                               0.0f);
}

GABOR_INLINE GaborMaterial gabor_scratches_at(gabor_vec2 p, gabor_vec2 period, GaborScratches scratches, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_point(p, period);
    GaborMaterial sum = GaborMaterial{gabor_vec3(1.0f), 0.0f, gabor_vec2(0.0f), 0.0f, 0.0f, gabor_vec3(0.0f)};
    for (int i = 0; i < 14; ++i)
        gabor_impl_add_scratches(sum, scratches, i,
                                 gabor_impl_spots_pair(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    return gabor_impl_scratches(scratches, sum);
}

// ---- Zebra ---------------------------------------------------------------------------------------------------------

GABOR_INLINE GaborImplPixel gabor_impl_hide(GaborImplPixel pixel, std::uint32_t seed) {
    return gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(0.14f), seed, 0);
}

GABOR_INLINE float gabor_impl_stripes_direction(GaborImplPixel pixel, GaborZebra zebra, std::uint32_t seed) {
    GaborPlace place = gabor_impl_place(pixel, gabor_vec2(0.6f));
    return zebra.orientation + zebra.bend_angle * gabor_impl_spots(place, gabor_derived_seed(seed, 1)).quadrature;
}

// Hair, tone and stripes.
GABOR_INLINE GaborImplLayer gabor_impl_zebra_layer(int i, GaborImplPixel pixel, GaborImplPixel skin, float direction,
                                      GaborZebra zebra, std::uint32_t seed) {
    // 2.0707963 is 0.5 + pi/2
    if (i == 0) return gabor_impl_spots_layer(gabor_impl_turned(skin, 2.0707963f), gabor_vec2(6.0f, 80.0f), seed, 3);
    if (i == 1) return gabor_impl_spots_layer(pixel, gabor_vec2(1.2f), seed, 4);
    return gabor_impl_waves_layer(skin, gabor_vec2(zebra.stripes / 1.4f), 1.4f, direction, seed, 2);
}

GABOR_INLINE GaborMaterial gabor_impl_zebra(GaborZebra zebra, GaborImplPairs of) {
    float ragged = 0.1f * zebra.hair_contrast, relief = 0.002f * zebra.hair_contrast;
    // where it is small, a constant softness would blur the edge
    float intensity = gabor_cpp_length(gabor_vec2(of.pair_2.first.x, of.pair_2.second.x));
    float dark = gabor_impl_above(of.pair_2.first + ragged * intensity * of.pair_0.first,
                                  of.pair_2.removed + ragged * ragged * intensity * intensity * of.pair_0.removed, 0.0f,
                                  0.01f + 0.09f * intensity).x;
    gabor_vec2 tones = gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.14f * zebra.hair_contrast)
               + gabor_impl_tone(of.pair_1.second.x, of.pair_1.removed, 0.08f);
    gabor_vec3 colour = gabor_cpp_mix(gabor_impl_toned(zebra.background_colour, tones), gabor_impl_toned(zebra.stripe_colour, tones),
                      dark);
    return gabor_impl_material(colour, relief * of.pair_0.first, relief * relief * of.pair_0.lost, zebra.roughness,
                               0.0f);
}

GABOR_INLINE GaborMaterial gabor_zebra_at(gabor_vec2 p, gabor_vec2 period, GaborZebra zebra, std::uint32_t seed) {
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

GABOR_INLINE GaborImplPixel gabor_impl_trunk(GaborImplPixel pixel, std::uint32_t seed) {
    GaborImplPixel trunk = gabor_impl_warp(pixel, gabor_vec2(0.8f, 0.35f), gabor_vec2(0.22f, 0.1f), seed, 0);
    trunk = gabor_impl_warp(trunk, gabor_vec2(3.0f, 1.6f), gabor_vec2(0.05f, 0.05f), seed, 1);
    return gabor_impl_warp(trunk, gabor_vec2(10.0f), gabor_vec2(0.013f), seed, 2);
}

// Five octaves of roughness, moss, furrows, and cracks.
GABOR_INLINE GaborImplLayer gabor_impl_bark_layer(int i, GaborImplPixel pixel, GaborImplPixel trunk, GaborBark bark, std::uint32_t seed) {
    GaborImplPixel at = trunk;
    if (i > 1 && i < 6) at = pixel; // the trunk's warps would stretch small spots into smears
    if (i < 5) return gabor_impl_octave(at, gabor_vec2(7.0f, 3.5f), i, 5, 0.7f, gabor_derived_seed(seed, 5));
    if (i == 5) return gabor_impl_spots_layer(at, gabor_vec2(1.1f, 0.7f), seed, 6);
    if (i == 6) return gabor_impl_waves_layer(trunk, gabor_vec2(1.7f, 0.55f) / 2.21f * bark.furrows, 1.3f, 0.1f, seed, 3);
    return gabor_impl_waves_layer(trunk, gabor_vec2(1.2f, 1.3f), 0.9f, 1.5f, seed, 4);
}

GABOR_INLINE GaborMaterial gabor_impl_bark(GaborBark bark, GaborImplPairs of) {
    gabor_vec3 shape = of.pair_2.first + 0.2f * of.pair_0.first;
    float removed = of.pair_2.removed + 0.04f * of.pair_0.removed;
    gabor_vec3 whole = gabor_vec3(1.0f, 0.0f, 0.0f) - 0.55f * gabor_impl_line(of.pair_3.first, of.pair_3.removed, 0.13f);
    gabor_vec3 risen = gabor_impl_above(shape, removed, -0.15f, 0.35f), plate = gabor_impl_times(risen, whole);
    // Weighted by the tone exp(0.25 noise), the removed part of the noise has a mean of 0.25 times its variance.
    gabor_vec3 weighted = of.pair_0.second + gabor_vec3(0.25f * of.pair_0.removed, 0.0f, 0.0f);
    float worn = 0.5f * gabor_impl_above(weighted, of.pair_0.removed, 0.5f, 0.4f).x;
    float covered = bark.moss_amount * gabor_impl_above(of.pair_1.second, of.pair_1.removed, 0.9f, 0.5f).x;
    gabor_vec2 tone = gabor_impl_tone(of.pair_0.second.x, of.pair_0.removed, 0.25f);
    gabor_vec3 top = gabor_cpp_mix(gabor_impl_toned(bark.plate_colour, tone),
                   gabor_impl_toned(gabor_cpp_mix(bark.plate_colour, gabor_vec3(1.0f), 0.13f), tone), worn);
    gabor_vec3 moss = gabor_impl_toned(bark.moss_colour, tone);
    gabor_vec3 colour = gabor_cpp_mix(gabor_cpp_mix(gabor_impl_toned(bark.furrow_colour, tone), moss, covered), gabor_cpp_mix(top, moss, 0.6f * covered),
                      plate.x);
    gabor_vec3 coarse = gabor_vec3(0.4f, 0.0f, 0.0f) + 0.6f * plate;
    gabor_vec3 height = bark.depth * plate + 0.018f * gabor_impl_times(of.pair_0.first, coarse);
    // Mean squares of factors; that of a line is a line of 1/sqrt(2) times the width. `deep` is the height's derivative
    // by the plate.
    // 0.0919239 is 0.13/sqrt(2)
    float wholes = 2.0f * whole.x - 1.0f + 0.3025f * gabor_impl_line(of.pair_3.first, of.pair_3.removed, 0.0919239f).x;
    float rises = risen.x * risen.x + risen.x * (1.0f - risen.x) * removed / (removed + 0.18f);
    float deep = bark.depth + 0.0108f * of.pair_0.first.x, coarses = 0.16f + 0.48f * plate.x + 0.36f * wholes * rises;
    float both = 0.0072f * deep * coarse.x * whole.x * gabor_impl_above(gabor_vec3(shape.x, 1.0f, 0.0f), removed, -0.15f, 0.35f).y;
    // 0.00011664 is 0.0108^2
    gabor_vec3 lost = (deep * deep + 0.00011664f * of.pair_0.removed)
              * (wholes * gabor_impl_above_lost(shape, removed, of.pair_2.lost + 0.04f * of.pair_0.lost, -0.15f, 0.35f)
                 + 0.3025f * rises * gabor_impl_line_lost(of.pair_3.first, of.pair_3.removed, of.pair_3.lost, 0.13f))
              + (0.000324f * coarses + both) * of.pair_0.lost;
    return gabor_impl_material(colour, height, lost, bark.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_bark_at(gabor_vec2 p, gabor_vec2 period, GaborBark bark, std::uint32_t seed) {
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

GABOR_INLINE GaborImplPixel gabor_impl_rock(GaborImplPixel pixel, GaborStrata strata, std::uint32_t seed) {
    gabor_vec4 folds = gabor_vec4(0.2f, 0.016f, 0.022f, 0.004f) * strata.folding;
    GaborImplPixel rock = gabor_impl_warp(pixel, gabor_vec2(0.35f, 0.6f), gabor_vec2(0.0f, folds.x), seed, 0);
    rock = gabor_impl_warp(rock, gabor_vec2(1.6f, 2.6f), folds.yz(), seed, 1);
    return gabor_impl_warp(rock, gabor_vec2(7.0f, 10.0f), gabor_vec2(folds.w), seed, 2);
}

// Four octaves of grain, and four sizes of layers: broad, band, thin, lamina.
GABOR_INLINE GaborImplLayer gabor_impl_strata_layer(int i, GaborImplPixel pixel, GaborImplPixel rock, GaborStrata strata,
                                       std::uint32_t seed) {
    if (i < 4)
        return gabor_impl_octave(pixel, gabor_vec2(16.0f, 24.0f), i, 4, 0.8f, gabor_derived_seed(seed, 7));
    // 0.33333333 is 1/3, 2.8333333 is 17/6 and 8.3333333 is 25/3
    gabor_vec2 density = i == 4 ? gabor_vec2(0.1f, 0.33333333f) : i == 5 ? gabor_vec2(0.14f, 1.0f)
                 : i == 6 ? gabor_vec2(0.25f, 2.8333333f) : gabor_vec2(0.6f, 8.3333333f);
    return gabor_impl_spots_layer(rock, density * gabor_vec2(1.0f, strata.layers), seed, i - 1);
}

GABOR_INLINE GaborMaterial gabor_impl_strata(GaborStrata strata, GaborImplPairs of) {
    gabor_vec3 soft = gabor_impl_above(of.pair_2.first, of.pair_2.removed, 0.5f, 0.22f); // the soft layers, which erode
    gabor_vec2 tones = gabor_impl_tone(of.pair_4.first.x, of.pair_4.removed, 0.13f)
               + gabor_impl_tone(of.pair_0.first.x, of.pair_0.removed, 0.11f);
    gabor_vec3 colour = gabor_cpp_mix(gabor_impl_toned(strata.dark_rock_colour, tones),
                      gabor_impl_toned(strata.light_rock_colour, tones),
                      gabor_impl_above(of.pair_1.first, of.pair_1.removed, 0.0f, 0.5f).x);
    colour = gabor_cpp_mix(colour, gabor_impl_toned(strata.soft_layer_colour, tones), 0.8f * soft.x);
    colour = gabor_cpp_mix(colour, gabor_impl_toned(strata.thin_layer_colour, tones),
                 0.75f * gabor_impl_above(of.pair_3.first, of.pair_3.removed, 1.0f, 0.2f).x);
    colour = gabor_cpp_mix(colour, gabor_impl_toned(0.75f * strata.soft_layer_colour, tones),
                 0.6f * gabor_impl_above(of.pair_3.second, of.pair_3.removed, 1.3f, 0.15f).x);
    gabor_vec3 height = 0.02f * of.pair_1.second - 0.012f * soft + 0.006f * of.pair_3.first + 0.0015f * of.pair_4.first
                + 0.003f * of.pair_0.second;
    gabor_vec3 lost = 0.0004f * of.pair_1.lost + 3.6e-5f * of.pair_3.lost + 2.25e-6f * of.pair_4.lost + 9.0e-6f * of.pair_0.lost
              + 0.000144f * gabor_impl_above_lost(of.pair_2.first, of.pair_2.removed, of.pair_2.lost, 0.5f, 0.22f);
    return gabor_impl_material(colour, strata.relief * height, strata.relief * strata.relief * lost, strata.roughness,
                               0.0f);
}

GABOR_INLINE GaborMaterial gabor_strata_at(gabor_vec2 p, gabor_vec2 period, GaborStrata strata, std::uint32_t seed) {
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

GABOR_INLINE GaborMaterial gabor_wood_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborWood wood, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel board = gabor_impl_board(pixel, wood, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_wood_layer(0, pixel, board, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_wood_layer(1, pixel, board, seed));
    of.pair_2 = gabor_impl_filtered_spots(gabor_impl_wood_layer(2, pixel, board, seed));
    return gabor_impl_wood(board, wood, of, seed);
}

GABOR_INLINE GaborMaterial gabor_fabric_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborFabric fabric, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel cloth = gabor_impl_cloth(pixel, fabric, seed);
    gabor_vec2 count = gabor_impl_threads(pixel, fabric);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(1, cloth, count, seed));
    of.pair_2 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(2, cloth, count, seed));
    of.pair_3 = gabor_impl_filtered_spots(gabor_impl_fabric_layer(3, cloth, count, seed));
    return gabor_impl_fabric(cloth, count, fabric, of);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborCarbonFibre fibres,
                                             std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel cloth = gabor_impl_twill(pixel, seed);
    gabor_vec2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0f);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_tow_layer(0, cloth, count, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_tow_layer(1, cloth, count, seed));
    return gabor_impl_carbon_fibre(cloth, count, fibres, of);
}

GABOR_INLINE GaborMaterial gabor_leather_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborLeather leather, std::uint32_t seed) {
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

GABOR_INLINE GaborMaterial gabor_marble_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborMarble marble, std::uint32_t seed) {
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

GABOR_INLINE GaborMaterial gabor_sand_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborSand sand, std::uint32_t seed) {
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

GABOR_INLINE GaborMaterial gabor_brushed_metal_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborBrushedMetal metal,
                                              std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPairs of = gabor_impl_no_pairs();
    int layers = gabor_impl_metal_layers(metal);
    for (int i = 0; i < layers; ++i) {
        GaborImplLayer layer = gabor_impl_metal_layer(i, pixel, metal, seed);
        gabor_impl_add_metal(of, i, layer, gabor_impl_filtered_spots(layer));
    }
    return gabor_impl_brushed_metal(metal, of);
}

GABOR_INLINE GaborMaterial gabor_scratches_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborScratches scratches, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborMaterial sum = GaborMaterial{gabor_vec3(1.0f), 0.0f, gabor_vec2(0.0f), 0.0f, 0.0f, gabor_vec3(0.0f)};
    for (int i = 0; i < 14; ++i)
        gabor_impl_add_scratches(sum, scratches, i,
                                 gabor_impl_filtered_spots(gabor_impl_scratches_layer(i, pixel, scratches, seed)));
    return gabor_impl_scratches(scratches, sum);
}

GABOR_INLINE GaborMaterial gabor_zebra_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborZebra zebra, std::uint32_t seed) {
    GaborImplPixel pixel = gabor_impl_pixel_of(true, p, dx, dy, period);
    GaborImplPixel skin = gabor_impl_hide(pixel, seed);
    float direction = gabor_impl_stripes_direction(pixel, zebra, seed);
    GaborImplPairs of = gabor_impl_no_pairs();
    of.pair_0 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(0, pixel, skin, direction, zebra, seed));
    of.pair_1 = gabor_impl_filtered_spots(gabor_impl_zebra_layer(1, pixel, skin, direction, zebra, seed));
    of.pair_2 = gabor_impl_filtered_waves(gabor_impl_zebra_layer(2, pixel, skin, direction, zebra, seed));
    return gabor_impl_zebra(zebra, of);
}

GABOR_INLINE GaborMaterial gabor_bark_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborBark bark, std::uint32_t seed) {
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

GABOR_INLINE GaborMaterial gabor_strata_filtered_at(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period, GaborStrata strata, std::uint32_t seed) {
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

GABOR_INLINE float gabor_roughness(GaborMaterial material) {
    float alpha = material.roughness * material.roughness;
    return gabor_cpp_sqrt(gabor_cpp_sqrt(gabor_cpp_min(alpha * alpha + 0.5f * (material.lost.x + material.lost.y), 1.0f)));
}

GABOR_INLINE GaborWood gabor_wood_default() {
    return GaborWood{gabor_vec3(0.51f, 0.283f, 0.098f), gabor_vec3(0.21f, 0.061f, 0.027f), 13.0f, 1.0f, 0.75f, 0.5f};
}
GABOR_INLINE GaborFabric gabor_fabric_default() {
    return GaborFabric{gabor_vec3(0.50f, 0.43f, 0.33f), gabor_vec3(0.60f, 0.53f, 0.42f), 12.0f, 1.0f, 1.0f, 0.85f, 0.0f, 0.0f};
}
GABOR_INLINE GaborLeather gabor_leather_default() {
    return GaborLeather{gabor_vec3(0.20f, 0.068f, 0.026f), gabor_vec3(0.093f, 0.016f, 0.0086f), 6.88f, 1.0f, 1.0f, 0.4f};
}
GABOR_INLINE GaborMarble gabor_marble_default() {
    return GaborMarble{gabor_vec3(0.80f, 0.79f, 0.77f), gabor_vec3(0.13f, 0.135f, 0.145f), 1.0f, 1.0f, 0.25f, 0.2f};
}
GABOR_INLINE GaborSand gabor_sand_default() {
    return GaborSand{gabor_vec3(0.43f, 0.30f, 0.17f), gabor_vec3(0.60f, 0.44f, 0.265f), 3.87f, 0.055f, 0.16f, 0.9f};
}
GABOR_INLINE GaborBrushedMetal gabor_brushed_metal_default() {
    return GaborBrushedMetal{gabor_vec3(0.55f, 0.555f, 0.565f), gabor_vec3(0.14f, 0.33f, 0.27f), 9.0f, 0.09f, 0.0012f, 0.36f, 0.0f};
}
GABOR_INLINE GaborScratches gabor_scratches_default() {
    // 1.5707963 is pi/2 and 3.1415927 is pi
    return GaborScratches{gabor_vec3(0.035f, 0.042f, 0.05f), gabor_vec3(0.60f, 0.61f, 0.62f), 1.0f, 3.0f, 1.5707963f, 1.5707964f, 0.0014f,
                          0.3f};
}
GABOR_INLINE GaborZebra gabor_zebra_default() {
    // 0.2967060 is 17/180 pi and 0.3490659 is 20/180 pi
    return GaborZebra{gabor_vec3(0.70f, 0.64f, 0.54f), gabor_vec3(0.018f, 0.014f, 0.012f), 1.96f, 0.2967060f, 0.3490659f, 1.0f, 0.7f};
}
GABOR_INLINE GaborBark gabor_bark_default() {
    return GaborBark{gabor_vec3(0.20f, 0.145f, 0.10f), gabor_vec3(0.025f, 0.014f, 0.008f), gabor_vec3(0.10f, 0.13f, 0.045f), 2.21f, 0.35f, 0.08f,
                     0.9f};
}
GABOR_INLINE GaborCarbonFibre gabor_carbon_fibre_default() {
    return GaborCarbonFibre{gabor_vec3(0.028f, 0.029f, 0.031f), 4.0f, 0.3f, 1.0f, 0.3f};
}
GABOR_INLINE GaborStrata gabor_strata_default() {
    return GaborStrata{gabor_vec3(0.50f, 0.22f, 0.09f), gabor_vec3(0.60f, 0.35f, 0.18f), gabor_vec3(0.28f, 0.075f, 0.035f), gabor_vec3(0.74f, 0.58f, 0.40f),
                       6.0f, 1.0f, 1.0f, 0.9f};
}

GABOR_INLINE GaborMaterial gabor_wood(gabor_vec2 p, std::uint32_t seed) {
    return gabor_wood_at(p, gabor_vec2(0.0f), gabor_wood_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_fabric(gabor_vec2 p, std::uint32_t seed) {
    return gabor_fabric_at(p, gabor_vec2(0.0f), gabor_fabric_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_leather(gabor_vec2 p, std::uint32_t seed) {
    return gabor_leather_at(p, gabor_vec2(0.0f), gabor_leather_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_marble(gabor_vec2 p, std::uint32_t seed) {
    return gabor_marble_at(p, gabor_vec2(0.0f), gabor_marble_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_sand(gabor_vec2 p, std::uint32_t seed) {
    return gabor_sand_at(p, gabor_vec2(0.0f), gabor_sand_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_brushed_metal(gabor_vec2 p, std::uint32_t seed) {
    return gabor_brushed_metal_at(p, gabor_vec2(0.0f), gabor_brushed_metal_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_scratches(gabor_vec2 p, std::uint32_t seed) {
    return gabor_scratches_at(p, gabor_vec2(0.0f), gabor_scratches_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_zebra(gabor_vec2 p, std::uint32_t seed) {
    return gabor_zebra_at(p, gabor_vec2(0.0f), gabor_zebra_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_bark(gabor_vec2 p, std::uint32_t seed) {
    return gabor_bark_at(p, gabor_vec2(0.0f), gabor_bark_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_carbon_fibre(gabor_vec2 p, std::uint32_t seed) {
    return gabor_carbon_fibre_at(p, gabor_vec2(0.0f), gabor_carbon_fibre_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_strata(gabor_vec2 p, std::uint32_t seed) {
    return gabor_strata_at(p, gabor_vec2(0.0f), gabor_strata_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_wood_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_wood_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_wood_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_fabric_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_fabric_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_fabric_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_leather_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_leather_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_leather_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_marble_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_marble_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_marble_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_sand_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_sand_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_sand_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_brushed_metal_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_brushed_metal_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_brushed_metal_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_scratches_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_scratches_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_scratches_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_zebra_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_zebra_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_zebra_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_bark_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_bark_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_bark_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_carbon_fibre_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_carbon_fibre_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_carbon_fibre_default(), seed);
}
GABOR_INLINE GaborMaterial gabor_strata_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_strata_filtered_at(p, dx, dy, gabor_vec2(0.0f), gabor_strata_default(), seed);
}

#endif
