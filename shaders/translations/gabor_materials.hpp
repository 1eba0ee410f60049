// clang-format off
// Generated from gabor_materials.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
//
// gabor_materials.hpp: twelve materials from Gabor noise.
//
// Paste or include this file after gabor_noise.hpp and gabor_spectrum.hpp, with GABOR_TAPS 3.
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

#include "gabor_vectors.hpp"

#ifndef GABOR_SPECTRUM_HPP
#error Include gabor_noise.hpp and gabor_spectrum.hpp before gabor_materials.hpp
#endif
#if GABOR_TAPS != 3
#error gabor_materials.hpp needs GABOR_TAPS 3
#endif
#ifndef GABOR_MATERIALS_HPP
#define GABOR_MATERIALS_HPP

struct GaborMaterial {
    gabor_vec3 colour;     // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // height in units of p
    float roughness; // roughness as in glTF
    float metalness; // 0 or 1
};

// ---- Where to draw -------------------------------------------------------------------------------------------------

// A position and the pixel around it.
struct GaborPixel {
    gabor_vec2 p;
    gabor_vec2 dx;       // change in p to the pixel on the right
    gabor_vec2 dy;       // change in p to the pixel below
    bool filtered; // whether to average over the pixel
    gabor_vec2 period;   // period of p, 0 for none
};

// GaborPixel gabor_pixel(vec2 p)
//     The point p, without a filter.

// GaborPixel gabor_pixel_filtered(vec2 p, vec2 dx, vec2 dy)
//     The average over a pixel. dx and dy are dFdx(p) and dFdy(p). Noises that only displace the pattern cost as much
//     as without the filter, and all others as much as gabor_noise_filtered.

// GaborPixel gabor_pixel_tiled(GaborPixel pixel, vec2 period)
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
    gabor_vec3 early;      // colour of the early wood
    gabor_vec3 late;       // colour of the late wood
    float rings;     // growth rings per unit, 2 to 60
    float waviness;  // how much the rings bend, 0 to 3
    float pores;     // strength of the pores, 0 to 1
    float roughness; // roughness of the early wood, 0 to 1
};
// GaborWood gabor_wood_default()
// GaborMaterial gabor_wood_at(GaborPixel pixel, GaborWood wood, uint seed)
// GaborMaterial gabor_wood(vec2 p, uint seed)
// GaborMaterial gabor_wood_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Linen, a plain weave of uneven threads; or corduroy, whose cords run along y [5 noises; period 3 x 3].
struct GaborFabric {
    gabor_vec3 warp;        // colour of the threads along y
    gabor_vec3 weft;        // colour of the threads along x
    float threads;    // threads per unit, 2 to 60
    float unevenness; // unevenness of the threads' thickness, shade and course, 0 to 2
    float relief;     // height of the weave and of the cords, relative to the default, 0 to 3
    float roughness;  // 0 to 1
    float cords;      // cords per unit, 0 to 20
};
// GaborFabric gabor_fabric_default()
// GaborMaterial gabor_fabric_at(GaborPixel pixel, GaborFabric fabric, uint seed)
// GaborMaterial gabor_fabric(vec2 p, uint seed)
// GaborMaterial gabor_fabric_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Pebbled grain: cells between creases [8 noises; period 3 x 3].
struct GaborLeather {
    gabor_vec3 pebble;     // colour of the cells
    gabor_vec3 crease;     // colour between the cells
    float cells;     // cells per unit, 2 to 30
    float wrinkles;  // how much the rows of cells bend, 0 to 3
    float relief;    // height of the cells, relative to the default, 0 to 3
    float roughness; // roughness of the cells, 0 to 0.7
};
// GaborLeather gabor_leather_default()
// GaborMaterial gabor_leather_at(GaborPixel pixel, GaborLeather leather, uint seed)
// GaborMaterial gabor_leather(vec2 p, uint seed)
// GaborMaterial gabor_leather_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    gabor_vec3 stone;       // colour of the stone
    gabor_vec3 vein;        // colour of the darkest veins
    float veins;      // strength of the veins, 0 to 1.3
    float turbulence; // how much the veins bend, 0 to 2
    float clouds;     // darkening by clouds, 0 to 1
    float roughness;  // 0 to 1
};
// GaborMarble gabor_marble_default()
// GaborMaterial gabor_marble_at(GaborPixel pixel, GaborMarble marble, uint seed)
// GaborMaterial gabor_marble(vec2 p, uint seed)
// GaborMaterial gabor_marble_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    gabor_vec3 trough;     // colour of the troughs
    gabor_vec3 crest;      // colour of the crests
    float ripples;   // ripples per unit, 1 to 20
    float relief;    // height of the ripples, in units, 0 to 0.2
    float grain;     // contrast of the grains, 0 to 0.25
    float roughness; // 0 to 1
};
// GaborSand gabor_sand_default()
// GaborMaterial gabor_sand_at(GaborPixel pixel, GaborSand sand, uint seed)
// GaborMaterial gabor_sand(vec2 p, uint seed)
// GaborMaterial gabor_sand_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Water under a light wind [14 noises; period 8 x 8].
struct GaborRipples {
    gabor_vec3 deep;       // colour of the troughs
    gabor_vec3 shallow;    // colour of the crests
    float waves;     // number of the longest waves per unit, 0.1 to 5
    float direction; // direction of the wind, -6.2832 to 6.2832 radians
    float spread;    // range of the waves' directions, 0 to 6.2832 radians
    float relief;    // height of the longest waves, in units, 0 to 0.2
    float roughness; // 0 to 1
};
// GaborRipples gabor_ripples_default()
// GaborMaterial gabor_ripples_at(GaborPixel pixel, GaborRipples ripples, uint seed)
// GaborMaterial gabor_ripples(vec2 p, uint seed)
// GaborMaterial gabor_ripples_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Streaks along x [5 noises; period 5 x 1].
struct GaborBrushedMetal {
    gabor_vec3 colour;     // colour of the metal
    float streaks;   // number of the widest streaks per unit, 1 to 50
    float contrast;  // contrast of the streaks, 0 to 0.5
    float relief;    // height of the widest streaks, in units, 0 to 0.01
    float roughness; // 0 to 1
};
// GaborBrushedMetal gabor_brushed_metal_default()
// GaborMaterial gabor_brushed_metal_at(GaborPixel pixel, GaborBrushedMetal metal, uint seed)
// GaborMaterial gabor_brushed_metal(vec2 p, uint seed)
// GaborMaterial gabor_brushed_metal_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    gabor_vec3 lacquer;    // colour of the lacquer
    gabor_vec3 scratch;    // colour in the scratches
    float amount;    // number of scratches, relative to the default, 0.01 to 8
    float reach;     // length of the scratches, in units, 0.3 to 10
    float direction; // mean direction of the scratches, -6.2832 to 6.2832 radians
    float spread;    // range of the scratches' directions, 0 to 3.1416 radians
    float depth;     // depth of the scratches, in units, 0 to 0.02
    float roughness; // 0 to 1
};
// GaborScratches gabor_scratches_default()
// GaborMaterial gabor_scratches_at(GaborPixel pixel, GaborScratches scratches, uint seed)
// GaborMaterial gabor_scratches(vec2 p, uint seed)
// GaborMaterial gabor_scratches_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    gabor_vec3 bright;     // colour between the stripes
    gabor_vec3 stripe;     // colour of the stripes
    float stripes;   // stripes per unit, 0.5 to 20
    float direction; // direction of the waves, at right angles to the stripes, -6.2832 to 6.2832 radians
    float bends;     // how much the stripes' direction changes, 0 to 1.5708 radians
    float hair;      // contrast of the hair, 0 to 3
    float roughness; // 0 to 1
};
// GaborZebra gabor_zebra_default()
// GaborMaterial gabor_zebra_at(GaborPixel pixel, GaborZebra zebra, uint seed)
// GaborMaterial gabor_zebra(vec2 p, uint seed)
// GaborMaterial gabor_zebra_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    gabor_vec3 plate;      // colour of the plates
    gabor_vec3 furrow;     // colour of the furrows
    gabor_vec3 moss;       // colour of the moss
    float furrows;   // furrows per unit, 0.5 to 10
    float cover;     // amount of moss, 0 to 1
    float depth;     // depth of the furrows, in units, 0 to 0.4
    float roughness; // 0 to 1
};
// GaborBark gabor_bark_default()
// GaborMaterial gabor_bark_at(GaborPixel pixel, GaborBark bark, uint seed)
// GaborMaterial gabor_bark(vec2 p, uint seed)
// GaborMaterial gabor_bark_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    gabor_vec3 colour;     // colour of the fibres
    float tows;      // tows per unit, 1 to 20
    float contrast;  // contrast of the fibres, 0 to 0.6
    float relief;    // height of the tows, relative to the default, 0 to 3
    float roughness; // 0 to 1
};
// GaborCarbonFibre gabor_carbon_fibre_default()
// GaborMaterial gabor_carbon_fibre_at(GaborPixel pixel, GaborCarbonFibre fibres, uint seed)
// GaborMaterial gabor_carbon_fibre(vec2 p, uint seed)
// GaborMaterial gabor_carbon_fibre_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    gabor_vec3 rock;       // colour of the darker rock
    gabor_vec3 sandstone;  // colour of the lighter rock
    gabor_vec3 red;        // colour of the soft layers
    gabor_vec3 pale;       // colour of the thin layers
    float layers;    // layers per unit, 1 to 30
    float folds;     // how much the layers bend, 0 to 3
    float relief;    // height of the layers, relative to the default, 0 to 3
    float roughness; // 0 to 1
};
// GaborStrata gabor_strata_default()
// GaborMaterial gabor_strata_at(GaborPixel pixel, GaborStrata strata, uint seed)
// GaborMaterial gabor_strata(vec2 p, uint seed)
// GaborMaterial gabor_strata_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

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

GABOR_INLINE GaborPlace gabor_impl_place(GaborPixel pixel, gabor_vec2 density) {
    if (pixel.period.x > 0.0f)
        return gabor_place_tiled(density * pixel.p, density * pixel.period);
    return gabor_place(gabor_ivec2(0), GABOR_RADIUS * density * pixel.p);
}

// Returns two independent noises, the quadrature and noise of one field, and the share of the variance that the filter
// removed. `density` is in kernel radii per unit along x and y.
GABOR_INLINE gabor_vec3 gabor_impl_layer(GaborPixel pixel, gabor_vec2 density, float frequency, float orientation, std::uint32_t seed) {
    GaborPlace place = gabor_impl_place(pixel, density);
    GaborKernel kernel_ = gabor_kernel(frequency, orientation);
    if (!pixel.filtered)
        return gabor_vec3(gabor_field(place, kernel_, seed).value, 0.0f);
    float removed;
    density *= place.radius / GABOR_RADIUS;
    GaborFootprint footprint = gabor_footprint(density * pixel.dx, density * pixel.dy);
    gabor_vec2 value = gabor_field_filtered(place, kernel_, footprint, seed, removed).value;
    return gabor_vec3(value, removed);
}

// A layer of frequency 0: spots as large as a kernel.
GABOR_INLINE gabor_vec3 gabor_impl_spots(GaborPixel pixel, gabor_vec2 density, std::uint32_t seed) {
    return gabor_impl_layer(pixel, density, 0.0f, 0.0f, seed);
}

// A sum of octaves of spots. Each octave has spots of about half the previous size, and `gain` times the amplitude.
GABOR_INLINE gabor_vec3 gabor_impl_octaves(GaborPixel pixel, gabor_vec2 density, int count, float gain, std::uint32_t seed) {
    gabor_vec3 sum = gabor_vec3(0.0f);
    float power = 0.0f;
    float amplitude = 1.0f;
    for (int i = 0; i < count; ++i) {
        sum += gabor_vec3(amplitude, amplitude, amplitude * amplitude)
               * gabor_impl_spots(pixel, density, gabor_lobe_seed(seed, i));
        power += amplitude * amplitude;
        amplitude *= gain;
        density *= 2.03f;
    }
    return sum / gabor_vec3(gabor_vec2(gabor_cpp_sqrt(power)), power);
}

// Displaces p by two noises, and changes dx and dy accordingly.
GABOR_INLINE GaborPixel gabor_impl_warp(GaborPixel pixel, gabor_vec2 density, gabor_vec2 amplitude, std::uint32_t seed) {
    GaborField field = gabor_field(gabor_impl_place(pixel, density), gabor_kernel(0.0f, 0.0f), seed);
    gabor_vec2 along_x = amplitude * density.x * field.slope_x;
    gabor_vec2 along_y = amplitude * density.y * field.slope_y;
    return GaborPixel{pixel.p + amplitude * field.value, pixel.dx + pixel.dx.x * along_x + pixel.dx.y * along_y,
                      pixel.dy + pixel.dy.x * along_x + pixel.dy.y * along_y, pixel.filtered, pixel.period};
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
GABOR_INLINE GaborPixel gabor_impl_turned(GaborPixel pixel, float angle) {
    gabor_vec2 turn = gabor_impl_wave(0.15915494f * angle);
    gabor_vec2 x = turn;
    gabor_vec2 y = gabor_vec2(-turn.y, turn.x);
    gabor_vec2 period = gabor_vec2(0.0f);
    if (pixel.period.x > 0.0f) {
        gabor_vec2 whole = gabor_cpp_floor(3.0f * gabor_cpp_normalize(turn / pixel.period) + 0.5f);
        gabor_vec2 size = gabor_cpp_abs(whole);
        gabor_vec2 signs = gabor_vec2(whole.x < 0.0f ? -1.0f : 1.0f, whole.y < 0.0f ? -1.0f : 1.0f);
        if (size.x == size.y || size.x * size.y == 0.0f) // (2, 2), (3, 0), (0, 3) become (1, 1), (1, 0), (0, 1)
            whole = signs * gabor_cpp_min(size, gabor_vec2(1.0f));
        size = gabor_cpp_abs(whole);
        gabor_vec2 other = size.x > 1.0f && size.y > 1.0f ? (size.x > size.y ? signs : -signs)
                     : size.x == 1.0f              ? gabor_vec2(0.0f, whole.x)
                                                  : gabor_vec2(-whole.y, 0.0f);
        period.x = gabor_cpp_length(whole * pixel.period);
        period.y = pixel.period.x * pixel.period.y / period.x;
        x = period.x * gabor_vec2(other.y, -other.x) / pixel.period;
        y = period.y * gabor_vec2(-whole.y, whole.x) / pixel.period;
    }
    return GaborPixel{gabor_vec2(gabor_cpp_dot(x, pixel.p), gabor_cpp_dot(y, pixel.p)), gabor_vec2(gabor_cpp_dot(x, pixel.dx), gabor_cpp_dot(y, pixel.dx)),
                      gabor_vec2(gabor_cpp_dot(x, pixel.dy), gabor_cpp_dot(y, pixel.dy)), pixel.filtered, period};
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
GABOR_INLINE gabor_vec2 gabor_impl_repeated(GaborPixel pixel, float count, float whole) {
    if (pixel.period.x > 0.0f)
        return gabor_cpp_max(gabor_cpp_floor(pixel.period * (count / whole) + 0.5f), gabor_vec2(1.0f)) * whole / pixel.period;
    return gabor_vec2(count);
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// A soft threshold: the normal distribution function of (noise - threshold) / softness, within 2e-5.
GABOR_INLINE float gabor_impl_above(float noise, float removed, float threshold, float softness) {
    float scale = gabor_cpp_inversesqrt(softness * softness + removed);
    float x = gabor_cpp_clamp(scale * noise - scale * threshold, -8.0f, 8.0f);
    return 1.0f / (1.0f + gabor_cpp_exp2(-x * (2.301726f + x * x * (0.1061787f - 0.00091164f * x * x))));
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
GABOR_INLINE float gabor_impl_line(float noise, float removed, float width) {
    float variance = width * width + removed;
    return width * gabor_cpp_inversesqrt(variance) * gabor_cpp_exp(-0.5f * noise * noise / variance);
}

// A factor of mean 1: exp(contrast noise - contrast^2 / 2).
GABOR_INLINE float gabor_impl_tone(float noise, float removed, float contrast) {
    return gabor_cpp_exp(contrast * (noise - 0.5f * contrast * (1.0f - removed)));
}

// The phase of a complex noise as a vector: of length 1, or shorter where the filter averages over phases.
GABOR_INLINE gabor_vec2 gabor_impl_phase(gabor_vec3 layer) {
    return layer.xy() * gabor_cpp_inversesqrt(gabor_cpp_dot(layer.xy(), layer.xy()) + 2.5f * layer.z + 1.0e-6f);
}

// The integral of the square of a sawtooth that rises from 0 to 1.
GABOR_INLINE float gabor_impl_rise_integral(float x) {
    float turns = gabor_cpp_floor(x), t = x - turns;
    return 0.33333333f * (turns + t * t * t);
}

// The mean of the square of a sawtooth over the interval (phase, width) that gabor_impl_phase_of returns.
GABOR_INLINE float gabor_impl_rise(gabor_vec2 phase) {
    gabor_vec3 ends = gabor_impl_ends(phase.x, phase.y);
    return ends.z * (gabor_impl_rise_integral(ends.y) - gabor_impl_rise_integral(ends.x));
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
GABOR_INLINE GaborMaterial gabor_impl_material(gabor_vec3 colour, float height, float roughness, float metalness) {
    return GaborMaterial{gabor_cpp_clamp(colour, 0.0f, 1.0f), height, roughness, metalness};
}

// ---- Materials -----------------------------------------------------------------------------------------------------

// Rings are lines of constant x that noise of low frequency bends until they close.
GABOR_INLINE GaborMaterial gabor_wood_at(GaborPixel pixel, GaborWood wood, std::uint32_t seed) {
    gabor_vec2 bends = gabor_vec2(0.43f, 0.018f) * wood.waviness;
    GaborPixel board = gabor_impl_warp(pixel, gabor_vec2(1.1f, 0.24f), gabor_vec2(bends.x, 0.0f), gabor_lobe_seed(seed, 0));
    board = gabor_impl_warp(board, gabor_vec2(4.0f, 0.9f), gabor_vec2(bends.y, 0.0f), gabor_lobe_seed(seed, 1));
    GaborPixel years = gabor_impl_warp(board, gabor_vec2(6.5f, 0.08f), gabor_vec2(0.455f / wood.rings, 0.0f), gabor_lobe_seed(seed, 2));
    float rings = gabor_impl_repeated(pixel, wood.rings, 1.0f).x;
    float steps = rings * rings * (years.dx.x * years.dx.x + years.dy.x * years.dy.x);
    float kept = 0.97f * gabor_cpp_exp(-gabor_cpp_min(4.9348022f * steps, 40.0f)); // amplitude of the rings' wave after a Gaussian filter
    float ring = gabor_impl_rise(gabor_vec2(rings * years.p.x, gabor_impl_phase_of(gabor_vec2(kept, 0.0f)).y));
    gabor_vec3 pore = gabor_impl_spots(pixel, gabor_vec2(90.0f, 4.5f), gabor_lobe_seed(seed, 3));
    gabor_vec3 fibre = gabor_impl_spots(pixel, gabor_vec2(150.0f, 2.0f), gabor_lobe_seed(seed, 4));
    gabor_vec3 tone = gabor_impl_spots(board, gabor_vec2(3.5f, 0.35f), gabor_lobe_seed(seed, 5));

    float tones = gabor_impl_tone(fibre.y, fibre.z, 0.11f) * gabor_impl_tone(tone.y, tone.z, 0.13f);
    float pores = wood.pores * gabor_impl_above(pore.y, pore.z, 1.1f, 0.25f); // a quarter as deep in late wood
    float early = (1.0f - ring) * (1.0f - pores);
    float late = ring * (1.0f - 0.25f * pores);
    float deep = 1.0f - early - late;
    gabor_vec3 colour = tones * early * wood.early + (tones * late + 0.45f * deep) * wood.late;
    float height = 0.0006f * ring - 0.0024f * deep + 0.0002f * fibre.y;
    return gabor_impl_material(colour, height, wood.roughness * (1.0f - 0.2f * ring), 0.0f);
}

GABOR_INLINE GaborMaterial gabor_fabric_at(GaborPixel pixel, GaborFabric fabric, std::uint32_t seed) {
    gabor_vec2 count = gabor_impl_repeated(pixel, fabric.threads, 2.0f);
    GaborPixel cloth = gabor_impl_warp(pixel, gabor_vec2(0.7f), gabor_vec2(0.02f * fabric.unevenness), gabor_lobe_seed(seed, 0));
    gabor_vec3 upright = gabor_impl_spots(cloth, gabor_vec2(0.7f * count.x, 1.1f), gabor_lobe_seed(seed, 1)); // for threads along y
    gabor_vec3 level = gabor_impl_spots(cloth, gabor_vec2(1.1f, 0.7f * count.y), gabor_lobe_seed(seed, 2));
    gabor_vec3 upright_fibre = gabor_impl_spots(cloth, gabor_vec2(14.0f, 2.0f) * count, gabor_lobe_seed(seed, 3));
    gabor_vec3 level_fibre = gabor_impl_spots(cloth, gabor_vec2(2.0f, 14.0f) * count, gabor_lobe_seed(seed, 4));

    // A thread has a round profile, and goes over one crossing thread and under the next.
    gabor_vec2 at = count * cloth.p + 0.13f * fabric.unevenness * gabor_vec2(upright.x, level.x);
    gabor_vec2 thread_ = gabor_cpp_floor(at);
    gabor_vec2 within = at - thread_ - 0.5f;
    float parity = gabor_cpp_fract(0.5f * (thread_.x + thread_.y)) > 0.25f ? -1.0f : 1.0f;
    gabor_vec2 thick = 1.0f + 0.16f * fabric.unevenness * gabor_vec2(upright.y, level.y);
    gabor_vec2 inside = 1.0f - 4.2f * within * within / (thick * thick);
    gabor_vec2 crest = thick * gabor_cpp_sqrt(gabor_cpp_max(inside, 0.0f)) - 1.0f
                 + 0.55f * parity * gabor_cpp_cos(3.1415927f * within.yx()) * gabor_vec2(1.0f, -1.0f) - (1.0f - gabor_cpp_step(0.0f, inside));
    bool first = crest.x > crest.y;
    float top = gabor_cpp_max(gabor_cpp_max(crest.x, crest.y), -1.3f);
    gabor_vec3 tone = first ? upright : level;
    gabor_vec3 fibre = first ? upright_fibre : level_fibre;

    // `kept` is the part of the weave that the filter keeps. The rest becomes the mean, which was measured and depends
    // on the unevenness.
    gabor_vec2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = gabor_cpp_exp(-gabor_cpp_min(2.5f * (steps.x + steps.y), 40.0f));
    float uneven = fabric.unevenness;
    float light = gabor_cpp_mix(0.8572f + uneven * (0.005f + 0.0083f * uneven), gabor_cpp_smoothstep(-1.3f, 0.5f, top), kept);
    float share = gabor_cpp_mix(0.5f, first ? 1.0f : 0.0f, kept);
    gabor_vec3 colour = gabor_cpp_mix(fabric.weft, fabric.warp, share) * gabor_cpp_mix(0.18f, 1.0f, light);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.09f * fabric.unevenness) * gabor_impl_tone(fibre.y, fibre.z, 0.12f);
    top = gabor_cpp_mix(0.1352f + uneven * (0.0045f + 0.0062f * uneven), top, kept);
    float height = fabric.relief / fabric.threads * (0.3f * top + 0.035f * fibre.y);
    if (fabric.cords > 0.0f) { // wide crests and narrow furrows, 1 - cos(pi x)^4: two waves, which the filter damps
        float cords = gabor_impl_repeated(pixel, fabric.cords, 1.0f).x;
        float damped = gabor_cpp_exp(-gabor_cpp_min(4.9348022f * cords * cords * (cloth.dx.x * cloth.dx.x + cloth.dy.x * cloth.dy.x), 20.0f));
        float turn = 6.2831853f * gabor_cpp_fract(cords * cloth.p.x);
        float cord = 0.625f - damped * (0.5f * gabor_cpp_cos(turn) + 0.125f * damped * damped * damped * gabor_cpp_cos(2.0f * turn));
        colour *= gabor_cpp_mix(0.3f, 1.0f, cord);
        height += 0.3f * fabric.relief / cords * cord;
    }
    return gabor_impl_material(colour, height, fabric.roughness, 0.0f);
}

// Three waves; the phase of the third is the sum of the other two, so the crests of all three meet in each cell's middle.
GABOR_INLINE GaborMaterial gabor_leather_at(GaborPixel pixel, GaborLeather leather, std::uint32_t seed) {
    GaborPixel skin = gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(0.07f * leather.wrinkles), gabor_lobe_seed(seed, 0));
    skin = gabor_impl_warp(skin, gabor_vec2(4.0f), gabor_vec2(0.014f * leather.wrinkles), gabor_lobe_seed(seed, 1));
    gabor_vec2 density = gabor_vec2(leather.cells / 1.6f);
    gabor_vec3 one = gabor_impl_layer(skin, density, 1.6f, 0.2f, gabor_lobe_seed(seed, 2));
    gabor_vec3 other = gabor_impl_layer(skin, density, 1.6f, 2.2944f, gabor_lobe_seed(seed, 3));
    gabor_vec3 fine = gabor_impl_octaves(pixel, gabor_vec2(18.0f), 3, 0.75f, gabor_lobe_seed(seed, 4));
    gabor_vec3 tone = gabor_impl_spots(pixel, gabor_vec2(0.8f), gabor_lobe_seed(seed, 5));

    gabor_vec2 powers = gabor_vec2(gabor_cpp_dot(one.xy(), one.xy()), gabor_cpp_dot(other.xy(), other.xy()));
    gabor_vec2 a = one.xy() * gabor_cpp_inversesqrt(powers.x + 0.12f);
    gabor_vec2 b = other.xy() * gabor_cpp_inversesqrt(powers.y + 0.12f);
    float cells = a.x + b.x + gabor_impl_product(a, b).x; // 3 in the middle of a cell, -1.5 in a corner
    gabor_vec2 shares = powers / (powers + 2.5f * gabor_vec2(one.z, other.z));
    float kept = gabor_cpp_sqrt(shares.x * shares.y);
    float blur = 1.0f - kept;
    float pebble = gabor_cpp_mix(0.806f, gabor_cpp_smoothstep(-1.45f - blur, -0.55f + blur, cells + 0.1f * fine.y), kept);
    gabor_vec3 colour = gabor_cpp_mix(leather.crease, leather.pebble, pebble);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.14f) * gabor_impl_tone(fine.x, fine.z, 0.08f);
    float dome = gabor_cpp_mix(0.236f, gabor_cpp_smoothstep(-1.0f, 3.0f, cells), kept);
    float height = leather.relief * (0.016f * pebble + 0.013f * dome + 0.0016f * fine.y);
    return gabor_impl_material(colour, height, leather.roughness + 0.15f * (1.0f - pebble), 0.0f);
}

// Adds veins: lines along the zeros of layer.x, drawn only where layer.y exceeds a threshold, so they have
// ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
GABOR_INLINE gabor_vec3 gabor_impl_vein(gabor_vec3 colour, gabor_vec3 layer, float threshold, gabor_vec3 halo, gabor_vec3 core, gabor_vec2 width, gabor_vec2 strength) {
    float open = gabor_impl_above(layer.y, layer.z, threshold, 0.5f);
    strength.y *= open * gabor_impl_line(layer.x, layer.z, width.y);
    strength.x *= open * gabor_impl_line(layer.x, layer.z, width.x) - strength.y;
    return colour + strength.x * (halo - colour) + strength.y * (core - colour);
}

GABOR_INLINE GaborMaterial gabor_marble_at(GaborPixel pixel, GaborMarble marble, std::uint32_t seed) {
    gabor_vec4 bends = gabor_vec4(0.17f, 0.038f, 0.010f, 0.003f) * marble.turbulence;
    GaborPixel stone = gabor_impl_warp(pixel, gabor_vec2(1.1f), gabor_vec2(bends.x), gabor_lobe_seed(seed, 0));
    stone = gabor_impl_warp(stone, gabor_vec2(4.0f), gabor_vec2(bends.y), gabor_lobe_seed(seed, 1));
    stone = gabor_impl_warp(stone, gabor_vec2(13.0f), gabor_vec2(bends.z), gabor_lobe_seed(seed, 2));
    stone = gabor_impl_warp(stone, gabor_vec2(40.0f), gabor_vec2(bends.w), gabor_lobe_seed(seed, 3));
    gabor_vec3 large = gabor_impl_layer(stone, gabor_vec2(0.95f), 0.85f, 0.65f, gabor_lobe_seed(seed, 4));
    gabor_vec3 middle = gabor_impl_layer(stone, gabor_vec2(1.9f), 0.95f, -0.45f, gabor_lobe_seed(seed, 5));
    gabor_vec3 thin = gabor_impl_layer(stone, gabor_vec2(4.5f), 0.95f, 0.95f, gabor_lobe_seed(seed, 6));
    gabor_vec3 hair = gabor_impl_layer(stone, gabor_vec2(13.0f), 0.9f, 0.2f, gabor_lobe_seed(seed, 7));
    gabor_vec3 cloud = gabor_impl_octaves(stone, gabor_vec2(1.5f), 3, 0.6f, gabor_lobe_seed(seed, 8));
    gabor_vec3 crystal = gabor_impl_spots(pixel, gabor_vec2(75.0f), gabor_lobe_seed(seed, 9));

    gabor_vec3 colour = marble.stone * (1.0f - marble.clouds * gabor_impl_above(cloud.y, cloud.z, 0.5f, 0.8f));
    colour *= gabor_impl_tone(crystal.x, crystal.z, 0.02f);
    gabor_vec3 grey = gabor_cpp_mix(marble.stone, marble.vein, 0.65f);
    colour = gabor_impl_vein(colour, middle, 0.5f, grey, gabor_cpp_mix(marble.stone, marble.vein, 0.9f), gabor_vec2(0.25f, 0.035f),
                             gabor_vec2(0.6f, 0.6f) * marble.veins);
    colour = gabor_impl_vein(colour, large, -0.4f, grey, marble.vein, gabor_vec2(0.35f, 0.05f), gabor_vec2(0.55f, 0.75f) * marble.veins);
    colour = gabor_impl_vein(colour, thin, 0.8f, grey, grey, gabor_vec2(1.0f, 0.04f), gabor_vec2(0.0f, 0.45f) * marble.veins);
    colour = gabor_impl_vein(colour, hair, 1.1f, grey, gabor_cpp_mix(marble.stone, marble.vein, 0.45f), gabor_vec2(1.0f, 0.05f),
                             gabor_vec2(0.0f, 0.45f) * marble.veins);
    return gabor_impl_material(colour, 0.00012f * crystal.y, marble.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_sand_at(GaborPixel pixel, GaborSand sand, std::uint32_t seed) {
    GaborPixel dune = gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.15f), gabor_lobe_seed(seed, 0));
    dune = gabor_impl_warp(dune, gabor_vec2(3.0f), gabor_vec2(0.02f), gabor_lobe_seed(seed, 1));
    gabor_vec2 density = gabor_vec2(0.9f, 1.7f) / 3.87f * sand.ripples;
    gabor_vec3 wind = gabor_impl_layer(dune, density, 2.3f, 1.4f, gabor_lobe_seed(seed, 2));
    gabor_vec3 grain = gabor_impl_spots(pixel, gabor_vec2(75.0f), gabor_lobe_seed(seed, 3));
    gabor_vec3 large = gabor_impl_octaves(pixel, gabor_vec2(0.6f), 3, 0.5f, gabor_lobe_seed(seed, 4));

    float ripple = gabor_impl_rise(gabor_impl_phase_of(0.9f * gabor_impl_phase(wind)));
    gabor_vec3 colour = gabor_cpp_mix(sand.trough, sand.crest, ripple);
    colour *= gabor_impl_tone(grain.x, grain.z, sand.grain) * gabor_impl_tone(large.y, large.z, 0.06f);
    colour = gabor_cpp_mix(colour, 0.23f * sand.trough, 3.75f * sand.grain * gabor_impl_above(grain.y, grain.z, 1.9f, 0.15f));
    gabor_vec3 bright = gabor_cpp_mix(sand.crest, gabor_vec3(1.0f), 0.6f);
    colour = gabor_cpp_mix(colour, bright, 3.0f * sand.grain * gabor_impl_above(-grain.y, grain.z, 1.9f, 0.15f));
    float height = sand.relief * ripple * (1.0f + 0.2f * large.x) + 0.03f * large.x + 0.00875f * sand.grain * grain.x;
    return gabor_impl_material(colour, height, sand.roughness, 0.0f);
}

// A sum of waves with their second harmonics, after Stokes: crests are sharp and troughs flat. The part of a wave that
// the filter removed does not change the mean of the harmonic.
GABOR_INLINE GaborMaterial gabor_ripples_at(GaborPixel pixel, GaborRipples ripples, std::uint32_t seed) {
    float height = 0.0f;
    float crest = 0.0f;
    float removed = 0.0f;
    float power = 0.0f;
    for (int i = 0; i < 14; ++i) {
        float waves = ripples.waves * gabor_cpp_exp2(0.27f * float(i)); // waves per unit
        float angle = ripples.direction + ripples.spread * (gabor_cpp_fract(0.618034f * float(i) + 0.1f) - 0.5f);
        gabor_vec3 wave = gabor_impl_layer(pixel, gabor_vec2(waves / 2.2f), 2.2f, angle, gabor_lobe_seed(seed, i));
        float amplitude = gabor_cpp_exp2(-0.351f * float(i));
        height += amplitude * (wave.x + 0.2f * (wave.x * wave.x - wave.y * wave.y));
        crest += amplitude * wave.x;
        removed += amplitude * amplitude * wave.z;
        power += amplitude * amplitude;
    }
    float light = gabor_impl_above(crest * gabor_cpp_inversesqrt(power), removed / power, 0.5f, 1.0f);
    gabor_vec3 colour = gabor_cpp_mix(ripples.deep, ripples.shallow, light);
    return gabor_impl_material(colour, ripples.relief * height, ripples.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal_at(GaborPixel pixel, GaborBrushedMetal metal, std::uint32_t seed) {
    float height = 0.0f;
    gabor_vec2 tone = gabor_vec2(0.0f);
    for (int i = 0; i < 5; ++i) {
        float fine = gabor_cpp_exp2(float(i));
        gabor_vec2 density = gabor_vec2(0.3f + 0.12f * fine, metal.streaks * fine);
        gabor_vec3 streak = gabor_impl_spots(pixel, density, gabor_lobe_seed(seed, i));
        height += metal.relief / fine * streak.x;
        tone += gabor_vec2(0.4472136f, 0.2f) * streak.yz();
    }
    gabor_vec3 colour = metal.colour * gabor_impl_tone(tone.x, tone.y, metal.contrast);
    return gabor_impl_material(colour, height, metal.roughness, 1.0f);
}

// Scratches are the peaks of noise with very long and narrow kernels, in many directions.
GABOR_INLINE GaborMaterial gabor_scratches_at(GaborPixel pixel, GaborScratches scratches, std::uint32_t seed) {
    float whole = 1.0f;
    float height = 0.0f;
    float size = 1.0f;
    float turn = 0.0955f;
    float threshold = gabor_cpp_sqrt(5.76f - 2.0f * gabor_cpp_log(scratches.amount)); // the area above it is about proportional to amount
    for (int i = 0; i < 14; ++i) {
        GaborPixel turned = gabor_impl_turned(pixel, scratches.direction + scratches.spread * (turn - 0.5f));
        turned = gabor_impl_warp(turned, gabor_vec2(0.3f, 0.1f), gabor_vec2(0.0f, 0.17f), gabor_lobe_seed(seed, 2 * i));
        gabor_vec2 density = gabor_vec2(1.0f / scratches.reach, 42.0f) / size;
        gabor_vec3 noise = gabor_impl_spots(turned, density, gabor_lobe_seed(seed, 2 * i + 1));
        float scratch = gabor_impl_above(noise.x, noise.z, threshold, 0.2f);
        scratch *= gabor_impl_above(noise.y, noise.z, 0.3f, 0.7f);
        whole *= 1.0f - (0.25f + 0.7f * size) * scratch;
        height -= scratches.depth * size * scratch;
        size *= 0.9138315f;
        turn = gabor_cpp_fract(turn + 0.763932f);
    }
    return gabor_impl_material(gabor_cpp_mix(scratches.scratch, scratches.lacquer, whole), height, scratches.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_zebra_at(GaborPixel pixel, GaborZebra zebra, std::uint32_t seed) {
    GaborPixel skin = gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(0.14f), gabor_lobe_seed(seed, 0));
    GaborPlace place = gabor_impl_place(pixel, gabor_vec2(0.6f));
    float lean = gabor_field(place, gabor_kernel(0.0f, 0.0f), gabor_lobe_seed(seed, 1)).value.x;
    gabor_vec3 stripe = gabor_impl_layer(skin, gabor_vec2(zebra.stripes / 1.4f), 1.4f, zebra.direction + zebra.bends * lean,
                                   gabor_lobe_seed(seed, 2));
    gabor_vec3 hair = gabor_impl_spots(gabor_impl_turned(skin, 2.0707963f), gabor_vec2(6.0f, 80.0f), gabor_lobe_seed(seed, 3));
    gabor_vec3 tone = gabor_impl_spots(pixel, gabor_vec2(1.2f), gabor_lobe_seed(seed, 4));

    float intensity = gabor_cpp_length(stripe.xy()); // small where stripe.x is flat, where a constant softness would blur the edge
    float ragged = 0.1f * zebra.hair;
    float dark = gabor_impl_above(stripe.x + ragged * intensity * hair.x, stripe.z + ragged * ragged * hair.z, 0.0f,
                                  0.01f + 0.09f * intensity);
    gabor_vec3 colour = gabor_cpp_mix(zebra.bright, zebra.stripe, dark);
    colour *= gabor_impl_tone(hair.y, hair.z, 0.14f * zebra.hair) * gabor_impl_tone(tone.y, tone.z, 0.08f);
    return gabor_impl_material(colour, 0.002f * zebra.hair * hair.x, zebra.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_bark_at(GaborPixel pixel, GaborBark bark, std::uint32_t seed) {
    GaborPixel trunk = gabor_impl_warp(pixel, gabor_vec2(0.8f, 0.35f), gabor_vec2(0.22f, 0.1f), gabor_lobe_seed(seed, 0));
    trunk = gabor_impl_warp(trunk, gabor_vec2(3.0f, 1.6f), gabor_vec2(0.05f, 0.05f), gabor_lobe_seed(seed, 1));
    trunk = gabor_impl_warp(trunk, gabor_vec2(10.0f), gabor_vec2(0.013f), gabor_lobe_seed(seed, 2));
    gabor_vec2 density = gabor_vec2(1.7f, 0.55f) / 2.21f * bark.furrows;
    gabor_vec3 furrow = gabor_impl_layer(trunk, density, 1.3f, 0.1f, gabor_lobe_seed(seed, 3));
    gabor_vec3 crack = gabor_impl_layer(trunk, gabor_vec2(1.2f, 1.3f), 0.9f, 1.5f, gabor_lobe_seed(seed, 4));
    gabor_vec3 rough = gabor_impl_octaves(trunk, gabor_vec2(7.0f, 3.0f), 5, 0.75f, gabor_lobe_seed(seed, 5));
    gabor_vec3 moss = gabor_impl_spots(pixel, gabor_vec2(1.1f, 0.7f), gabor_lobe_seed(seed, 6));

    float shape = furrow.x + 0.2f * rough.x;
    float plate = gabor_impl_above(shape, furrow.z + 0.04f * rough.z, -0.15f, 0.35f)
                  * (1.0f - 0.55f * gabor_impl_line(crack.x, crack.z, 0.13f));
    // Weighted by the tone exp(0.25 noise), the removed part of the noise has a mean of 0.25 times its variance.
    float worn = 0.5f * gabor_impl_above(rough.y + 0.25f * rough.z, rough.z, 0.5f, 0.4f);
    float covered = bark.cover * gabor_impl_above(moss.y, moss.z, 0.9f, 0.5f);
    gabor_vec3 top = gabor_cpp_mix(bark.plate, gabor_cpp_mix(bark.plate, gabor_vec3(1.0f), 0.13f), worn);
    gabor_vec3 colour = gabor_cpp_mix(gabor_cpp_mix(bark.furrow, bark.moss, covered), gabor_cpp_mix(top, bark.moss, 0.6f * covered), plate);
    colour *= gabor_impl_tone(rough.y, rough.z, 0.25f);
    float height = bark.depth * plate + 0.018f * rough.x * (0.4f + 0.6f * plate);
    return gabor_impl_material(colour, height, bark.roughness, 0.0f);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
GABOR_INLINE GaborMaterial gabor_carbon_fibre_at(GaborPixel pixel, GaborCarbonFibre fibres, std::uint32_t seed) {
    gabor_vec2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0f);
    GaborPixel cloth = gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.008f), gabor_lobe_seed(seed, 0));
    gabor_vec3 upright = gabor_impl_spots(cloth, gabor_vec2(20.0f, 0.6f) * count, gabor_lobe_seed(seed, 1));
    gabor_vec3 level = gabor_impl_spots(cloth, gabor_vec2(0.6f, 20.0f) * count, gabor_lobe_seed(seed, 2));
    gabor_vec2 tow = gabor_cpp_floor(count * cloth.p);
    gabor_vec2 within = count * cloth.p - tow;
    float turn = 4.0f * gabor_cpp_fract(0.25f * (tow.x + tow.y) + 0.125f) - 0.5f; // 0 to 3
    bool first = turn < 1.5f;
    gabor_vec3 fibre = first ? upright : level;
    gabor_vec2 along_across = first ? within.yx() : within;
    float along = 0.5f * (along_across.x + (gabor_cpp_fract(0.5f * turn + 0.25f) < 0.5f ? 0.0f : 1.0f)); // from 0 to 1 over two rows
    float across = 2.0f * along_across.y - 1.0f;

    gabor_vec2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = gabor_cpp_exp(-gabor_cpp_min(2.5f * (steps.x + steps.y), 40.0f));
    float bulge = gabor_cpp_mix(0.5093f, gabor_cpp_sin(3.1415927f * along) * (1.0f - across * across * across * across), kept);
    gabor_vec3 colour = fibres.colour * (0.35f + 0.65f * bulge) * gabor_impl_tone(fibre.x, fibre.z, fibres.contrast);
    float height = fibres.relief / fibres.tows * (0.16f * bulge + 0.006f * fibre.x);
    return gabor_impl_material(colour, height, fibres.roughness, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_strata_at(GaborPixel pixel, GaborStrata strata, std::uint32_t seed) {
    gabor_vec4 folds = gabor_vec4(0.2f, 0.016f, 0.022f, 0.004f) * strata.folds;
    GaborPixel rock = gabor_impl_warp(pixel, gabor_vec2(0.35f, 0.6f), gabor_vec2(0.0f, folds.x), gabor_lobe_seed(seed, 0));
    rock = gabor_impl_warp(rock, gabor_vec2(1.6f, 2.6f), gabor_vec2(folds.y, folds.z), gabor_lobe_seed(seed, 1));
    rock = gabor_impl_warp(rock, gabor_vec2(7.0f, 10.0f), gabor_vec2(folds.w), gabor_lobe_seed(seed, 2));
    gabor_vec2 layers = gabor_vec2(1.0f, strata.layers);
    gabor_vec3 broad = gabor_impl_spots(rock, gabor_vec2(0.1f, 0.33333333f) * layers, gabor_lobe_seed(seed, 3));
    gabor_vec3 band = gabor_impl_spots(rock, gabor_vec2(0.14f, 1.0f) * layers, gabor_lobe_seed(seed, 4));
    gabor_vec3 thin = gabor_impl_spots(rock, gabor_vec2(0.25f, 2.8333333f) * layers, gabor_lobe_seed(seed, 5));
    gabor_vec3 lamina = gabor_impl_spots(rock, gabor_vec2(0.6f, 8.3333333f) * layers, gabor_lobe_seed(seed, 6));
    gabor_vec3 grain = gabor_impl_octaves(pixel, gabor_vec2(16.0f, 24.0f), 4, 0.8f, gabor_lobe_seed(seed, 7));

    float soft = gabor_impl_above(band.x, band.z, 0.5f, 0.22f); // the soft layers, which erode
    gabor_vec3 colour = gabor_cpp_mix(strata.rock, strata.sandstone, gabor_impl_above(broad.x, broad.z, 0.0f, 0.5f));
    colour = gabor_cpp_mix(colour, strata.red, 0.8f * soft);
    colour = gabor_cpp_mix(colour, strata.pale, 0.75f * gabor_impl_above(thin.x, thin.z, 1.0f, 0.2f));
    colour = gabor_cpp_mix(colour, 0.75f * strata.red, 0.6f * gabor_impl_above(thin.y, thin.z, 1.3f, 0.15f));
    colour *= gabor_impl_tone(lamina.x, lamina.z, 0.13f) * gabor_impl_tone(grain.x, grain.z, 0.11f);
    float height = 0.02f * broad.y - 0.012f * soft + 0.006f * thin.x + 0.0015f * lamina.x + 0.003f * grain.y;
    return gabor_impl_material(colour, strata.relief * height, strata.roughness, 0.0f);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GABOR_INLINE GaborPixel gabor_pixel(gabor_vec2 p) {
    return GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false, gabor_vec2(0.0f)};
}

GABOR_INLINE GaborPixel gabor_pixel_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy) {
    return GaborPixel{p, dx, dy, true, gabor_vec2(0.0f)};
}

GABOR_INLINE GaborPixel gabor_pixel_tiled(GaborPixel pixel, gabor_vec2 period) {
    return GaborPixel{pixel.p - period * gabor_cpp_floor(pixel.p / period), pixel.dx, pixel.dy, pixel.filtered, period};
}

GABOR_INLINE GaborWood gabor_wood_default() {
    return GaborWood{gabor_vec3(0.50f, 0.275f, 0.115f), gabor_vec3(0.20f, 0.078f, 0.027f), 13.0f, 1.0f, 0.75f, 0.5f};
}

GABOR_INLINE GaborFabric gabor_fabric_default() {
    return GaborFabric{gabor_vec3(0.50f, 0.43f, 0.33f), gabor_vec3(0.60f, 0.53f, 0.42f), 12.0f, 1.0f, 1.0f, 0.85f, 0.0f};
}

GABOR_INLINE GaborLeather gabor_leather_default() {
    return GaborLeather{gabor_vec3(0.20f, 0.068f, 0.026f), gabor_vec3(0.04f, 0.014f, 0.007f), 6.88f, 1.0f, 1.0f, 0.4f};
}

GABOR_INLINE GaborMarble gabor_marble_default() {
    return GaborMarble{gabor_vec3(0.80f, 0.79f, 0.77f), gabor_vec3(0.13f, 0.135f, 0.145f), 1.0f, 1.0f, 0.25f, 0.2f};
}

GABOR_INLINE GaborSand gabor_sand_default() {
    return GaborSand{gabor_vec3(0.43f, 0.30f, 0.17f), gabor_vec3(0.60f, 0.44f, 0.265f), 3.87f, 0.055f, 0.16f, 0.9f};
}

GABOR_INLINE GaborRipples gabor_ripples_default() {
    return GaborRipples{gabor_vec3(0.004f, 0.06f, 0.085f), gabor_vec3(0.03f, 0.25f, 0.27f), 0.6f, 0.8726646f, 1.0471976f, 0.035f, 0.1f};
}

GABOR_INLINE GaborBrushedMetal gabor_brushed_metal_default() {
    return GaborBrushedMetal{gabor_vec3(0.55f, 0.555f, 0.565f), 9.0f, 0.09f, 0.0012f, 0.36f};
}

GABOR_INLINE GaborScratches gabor_scratches_default() {
    return GaborScratches{gabor_vec3(0.035f, 0.042f, 0.05f), gabor_vec3(0.60f, 0.61f, 0.62f), 1.0f, 3.0f, 1.5707963f, 3.1415927f, 0.0025f,
                          0.3f};
}

GABOR_INLINE GaborZebra gabor_zebra_default() {
    return GaborZebra{gabor_vec3(0.70f, 0.64f, 0.54f), gabor_vec3(0.018f, 0.014f, 0.012f), 1.96f, 0.2967060f, 0.3490659f, 1.0f, 0.7f};
}

GABOR_INLINE GaborBark gabor_bark_default() {
    return GaborBark{gabor_vec3(0.20f, 0.145f, 0.10f), gabor_vec3(0.025f, 0.014f, 0.008f), gabor_vec3(0.10f, 0.13f, 0.045f), 2.21f, 0.35f, 0.13f,
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
    return gabor_wood_at(gabor_pixel(p), gabor_wood_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_fabric(gabor_vec2 p, std::uint32_t seed) {
    return gabor_fabric_at(gabor_pixel(p), gabor_fabric_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_leather(gabor_vec2 p, std::uint32_t seed) {
    return gabor_leather_at(gabor_pixel(p), gabor_leather_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_marble(gabor_vec2 p, std::uint32_t seed) {
    return gabor_marble_at(gabor_pixel(p), gabor_marble_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_sand(gabor_vec2 p, std::uint32_t seed) {
    return gabor_sand_at(gabor_pixel(p), gabor_sand_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_ripples(gabor_vec2 p, std::uint32_t seed) {
    return gabor_ripples_at(gabor_pixel(p), gabor_ripples_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal(gabor_vec2 p, std::uint32_t seed) {
    return gabor_brushed_metal_at(gabor_pixel(p), gabor_brushed_metal_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_scratches(gabor_vec2 p, std::uint32_t seed) {
    return gabor_scratches_at(gabor_pixel(p), gabor_scratches_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_zebra(gabor_vec2 p, std::uint32_t seed) {
    return gabor_zebra_at(gabor_pixel(p), gabor_zebra_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_bark(gabor_vec2 p, std::uint32_t seed) {
    return gabor_bark_at(gabor_pixel(p), gabor_bark_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre(gabor_vec2 p, std::uint32_t seed) {
    return gabor_carbon_fibre_at(gabor_pixel(p), gabor_carbon_fibre_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_strata(gabor_vec2 p, std::uint32_t seed) {
    return gabor_strata_at(gabor_pixel(p), gabor_strata_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_wood_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_wood_at(gabor_pixel_filtered(p, dx, dy), gabor_wood_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_fabric_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_fabric_at(gabor_pixel_filtered(p, dx, dy), gabor_fabric_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_leather_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_leather_at(gabor_pixel_filtered(p, dx, dy), gabor_leather_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_marble_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_marble_at(gabor_pixel_filtered(p, dx, dy), gabor_marble_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_sand_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_sand_at(gabor_pixel_filtered(p, dx, dy), gabor_sand_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_ripples_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_ripples_at(gabor_pixel_filtered(p, dx, dy), gabor_ripples_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_brushed_metal_at(gabor_pixel_filtered(p, dx, dy), gabor_brushed_metal_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_scratches_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_scratches_at(gabor_pixel_filtered(p, dx, dy), gabor_scratches_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_zebra_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_zebra_at(gabor_pixel_filtered(p, dx, dy), gabor_zebra_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_bark_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_bark_at(gabor_pixel_filtered(p, dx, dy), gabor_bark_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_carbon_fibre_at(gabor_pixel_filtered(p, dx, dy), gabor_carbon_fibre_default(), seed);
}

GABOR_INLINE GaborMaterial gabor_strata_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_strata_at(gabor_pixel_filtered(p, dx, dy), gabor_strata_default(), seed);
}

#endif // GABOR_MATERIALS_HPP
