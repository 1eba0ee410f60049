// Generated from gabor_materials.glsl by tools/translate, for the Metal shading language: change that file, not this one.
//
// gabor_materials.metal: twelve materials from Gabor noise.
//
// Paste or include this file after gabor_noise.metal and gabor_spectrum.metal, with GABOR_TAPS 3.
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

#include <metal_stdlib>

using namespace metal;

#ifndef GABOR_SPECTRUM_METAL
#error Include gabor_noise.metal and gabor_spectrum.metal before gabor_materials.metal
#endif
#if GABOR_TAPS != 3
#error gabor_materials.metal needs GABOR_TAPS 3
#endif
#ifndef GABOR_MATERIALS_METAL
#define GABOR_MATERIALS_METAL

struct GaborMaterial {
    float3 colour;     // base colour for physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // height in units of p
    float roughness; // roughness as in glTF
    float metalness; // 0 or 1
};

// ---- Where to draw -------------------------------------------------------------------------------------------------

// A position and the pixel around it.
struct GaborPixel {
    float2 p;
    float2 dx;       // change in p to the pixel on the right
    float2 dy;       // change in p to the pixel below
    bool filtered; // whether to average over the pixel
    float2 period;   // period of p, 0 for none
};

// GaborPixel gabor_pixel(float2 p)
//     The point p, without a filter.

// GaborPixel gabor_pixel_filtered(float2 p, float2 dx, float2 dy)
//     The average over a pixel. dx and dy are dFdx(p) and dFdy(p). Noises that only displace the pattern cost as much
//     as without the filter, and all others as much as gabor_noise_filtered.

// GaborPixel gabor_pixel_tiled(GaborPixel pixel, float2 period)
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
    float3 early;      // colour of the early wood
    float3 late;       // colour of the late wood
    float rings;     // growth rings per unit, 2 to 60
    float waviness;  // how much the rings bend, 0 to 3
    float pores;     // strength of the pores, 0 to 1
    float roughness; // roughness of the early wood, 0 to 1
};
// GaborWood gabor_wood_default()
// GaborMaterial gabor_wood_at(GaborPixel pixel, GaborWood wood, uint seed)
// GaborMaterial gabor_wood(float2 p, uint seed)
// GaborMaterial gabor_wood_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Linen, a plain weave of uneven threads; or corduroy, whose cords run along y [5 noises; period 3 x 3].
struct GaborFabric {
    float3 warp;        // colour of the threads along y
    float3 weft;        // colour of the threads along x
    float threads;    // threads per unit, 2 to 60
    float unevenness; // unevenness of the threads' thickness, shade and course, 0 to 2
    float relief;     // height of the weave and of the cords, relative to the default, 0 to 3
    float roughness;  // 0 to 1
    float cords;      // cords per unit, 0 to 20
};
// GaborFabric gabor_fabric_default()
// GaborMaterial gabor_fabric_at(GaborPixel pixel, GaborFabric fabric, uint seed)
// GaborMaterial gabor_fabric(float2 p, uint seed)
// GaborMaterial gabor_fabric_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Pebbled grain: cells between creases [8 noises; period 3 x 3].
struct GaborLeather {
    float3 pebble;     // colour of the cells
    float3 crease;     // colour between the cells
    float cells;     // cells per unit, 2 to 30
    float wrinkles;  // how much the rows of cells bend, 0 to 3
    float relief;    // height of the cells, relative to the default, 0 to 3
    float roughness; // roughness of the cells, 0 to 0.7
};
// GaborLeather gabor_leather_default()
// GaborMaterial gabor_leather_at(GaborPixel pixel, GaborLeather leather, uint seed)
// GaborMaterial gabor_leather(float2 p, uint seed)
// GaborMaterial gabor_leather_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Polished stone with veins of four sizes [12 noises; period 3 x 3].
struct GaborMarble {
    float3 stone;       // colour of the stone
    float3 vein;        // colour of the darkest veins
    float veins;      // strength of the veins, 0 to 1.3
    float turbulence; // how much the veins bend, 0 to 2
    float clouds;     // darkening by clouds, 0 to 1
    float roughness;  // 0 to 1
};
// GaborMarble gabor_marble_default()
// GaborMaterial gabor_marble_at(GaborPixel pixel, GaborMarble marble, uint seed)
// GaborMaterial gabor_marble(float2 p, uint seed)
// GaborMaterial gabor_marble_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Wind ripples that are steep on one side, and grains [7 noises; period 4 x 4].
struct GaborSand {
    float3 trough;     // colour of the troughs
    float3 crest;      // colour of the crests
    float ripples;   // ripples per unit, 1 to 20
    float relief;    // height of the ripples, in units, 0 to 0.2
    float grain;     // contrast of the grains, 0 to 0.25
    float roughness; // 0 to 1
};
// GaborSand gabor_sand_default()
// GaborMaterial gabor_sand_at(GaborPixel pixel, GaborSand sand, uint seed)
// GaborMaterial gabor_sand(float2 p, uint seed)
// GaborMaterial gabor_sand_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Water under a light wind [14 noises; period 8 x 8].
struct GaborRipples {
    float3 deep;       // colour of the troughs
    float3 shallow;    // colour of the crests
    float waves;     // number of the longest waves per unit, 0.1 to 5
    float direction; // direction of the wind, -6.2832 to 6.2832 radians
    float spread;    // range of the waves' directions, 0 to 6.2832 radians
    float relief;    // height of the longest waves, in units, 0 to 0.2
    float roughness; // 0 to 1
};
// GaborRipples gabor_ripples_default()
// GaborMaterial gabor_ripples_at(GaborPixel pixel, GaborRipples ripples, uint seed)
// GaborMaterial gabor_ripples(float2 p, uint seed)
// GaborMaterial gabor_ripples_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Streaks along x [5 noises; period 5 x 1].
struct GaborBrushedMetal {
    float3 colour;     // colour of the metal
    float streaks;   // number of the widest streaks per unit, 1 to 50
    float contrast;  // contrast of the streaks, 0 to 0.5
    float relief;    // height of the widest streaks, in units, 0 to 0.01
    float roughness; // 0 to 1
};
// GaborBrushedMetal gabor_brushed_metal_default()
// GaborMaterial gabor_brushed_metal_at(GaborPixel pixel, GaborBrushedMetal metal, uint seed)
// GaborMaterial gabor_brushed_metal(float2 p, uint seed)
// GaborMaterial gabor_brushed_metal_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Fine scratches in lacquer [28 noises; period 8 x 8].
struct GaborScratches {
    float3 lacquer;    // colour of the lacquer
    float3 scratch;    // colour in the scratches
    float amount;    // number of scratches, relative to the default, 0.01 to 8
    float reach;     // length of the scratches, in units, 0.3 to 10
    float direction; // mean direction of the scratches, -6.2832 to 6.2832 radians
    float spread;    // range of the scratches' directions, 0 to 3.1416 radians
    float depth;     // depth of the scratches, in units, 0 to 0.02
    float roughness; // 0 to 1
};
// GaborScratches gabor_scratches_default()
// GaborMaterial gabor_scratches_at(GaborPixel pixel, GaborScratches scratches, uint seed)
// GaborMaterial gabor_scratches(float2 p, uint seed)
// GaborMaterial gabor_scratches_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Stripes that fork, and hair [5 noises; period 4 x 4].
struct GaborZebra {
    float3 bright;     // colour between the stripes
    float3 stripe;     // colour of the stripes
    float stripes;   // stripes per unit, 0.5 to 20
    float direction; // direction of the waves, at right angles to the stripes, -6.2832 to 6.2832 radians
    float bends;     // how much the stripes' direction changes, 0 to 1.5708 radians
    float hair;      // contrast of the hair, 0 to 3
    float roughness; // 0 to 1
};
// GaborZebra gabor_zebra_default()
// GaborMaterial gabor_zebra_at(GaborPixel pixel, GaborZebra zebra, uint seed)
// GaborMaterial gabor_zebra(float2 p, uint seed)
// GaborMaterial gabor_zebra_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Furrows and plates along y, and moss [11 noises; period 3 x 6].
struct GaborBark {
    float3 plate;      // colour of the plates
    float3 furrow;     // colour of the furrows
    float3 moss;       // colour of the moss
    float furrows;   // furrows per unit, 0.5 to 10
    float cover;     // amount of moss, 0 to 1
    float depth;     // depth of the furrows, in units, 0 to 0.4
    float roughness; // 0 to 1
};
// GaborBark gabor_bark_default()
// GaborMaterial gabor_bark_at(GaborPixel pixel, GaborBark bark, uint seed)
// GaborMaterial gabor_bark(float2 p, uint seed)
// GaborMaterial gabor_bark_filtered(float2 p, float2 dx, float2 dy, uint seed)

// A twill weave of tows, which are flat bundles of fibres [3 noises; period 3 x 3].
struct GaborCarbonFibre {
    float3 colour;     // colour of the fibres
    float tows;      // tows per unit, 1 to 20
    float contrast;  // contrast of the fibres, 0 to 0.6
    float relief;    // height of the tows, relative to the default, 0 to 3
    float roughness; // 0 to 1
};
// GaborCarbonFibre gabor_carbon_fibre_default()
// GaborMaterial gabor_carbon_fibre_at(GaborPixel pixel, GaborCarbonFibre fibres, uint seed)
// GaborMaterial gabor_carbon_fibre(float2 p, uint seed)
// GaborMaterial gabor_carbon_fibre_filtered(float2 p, float2 dx, float2 dy, uint seed)

// Layers of sandstone, seen from the side [11 noises; period 20 x 4].
struct GaborStrata {
    float3 rock;       // colour of the darker rock
    float3 sandstone;  // colour of the lighter rock
    float3 red;        // colour of the soft layers
    float3 pale;       // colour of the thin layers
    float layers;    // layers per unit, 1 to 30
    float folds;     // how much the layers bend, 0 to 3
    float relief;    // height of the layers, relative to the default, 0 to 3
    float roughness; // 0 to 1
};
// GaborStrata gabor_strata_default()
// GaborMaterial gabor_strata_at(GaborPixel pixel, GaborStrata strata, uint seed)
// GaborMaterial gabor_strata(float2 p, uint seed)
// GaborMaterial gabor_strata_filtered(float2 p, float2 dx, float2 dy, uint seed)

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

inline GaborPlace gabor_impl_place(GaborPixel pixel, float2 density) {
    if (pixel.period.x > 0.0)
        return gabor_place_tiled(density * pixel.p, density * pixel.period);
    return gabor_place(int2(0), GABOR_RADIUS * density * pixel.p);
}

// Returns two independent noises, the quadrature and noise of one field, and the share of the variance that the filter
// removed. `density` is in kernel radii per unit along x and y.
inline float3 gabor_impl_layer(GaborPixel pixel, float2 density, float frequency, float orientation, uint seed) {
    GaborPlace place = gabor_impl_place(pixel, density);
    GaborKernel kernel_ = gabor_kernel(frequency, orientation);
    if (!pixel.filtered)
        return float3(gabor_field(place, kernel_, seed).value, 0.0);
    float removed;
    density *= place.radius / GABOR_RADIUS;
    GaborFootprint footprint = gabor_footprint(density * pixel.dx, density * pixel.dy);
    float2 value = gabor_field_filtered(place, kernel_, footprint, seed, removed).value;
    return float3(value, removed);
}

// A layer of frequency 0: spots as large as a kernel.
inline float3 gabor_impl_spots(GaborPixel pixel, float2 density, uint seed) {
    return gabor_impl_layer(pixel, density, 0.0, 0.0, seed);
}

// A sum of octaves of spots. Each octave has spots of about half the previous size, and `gain` times the amplitude.
inline float3 gabor_impl_octaves(GaborPixel pixel, float2 density, int count, float gain, uint seed) {
    float3 sum = float3(0.0);
    float power = 0.0;
    float amplitude = 1.0;
    for (int i = 0; i < count; ++i) {
        sum += float3(amplitude, amplitude, amplitude * amplitude)
               * gabor_impl_spots(pixel, density, gabor_lobe_seed(seed, i));
        power += amplitude * amplitude;
        amplitude *= gain;
        density *= 2.03;
    }
    return sum / float3(float2(sqrt(power)), power);
}

// Displaces p by two noises, and changes dx and dy accordingly.
inline GaborPixel gabor_impl_warp(GaborPixel pixel, float2 density, float2 amplitude, uint seed) {
    GaborField field = gabor_field(gabor_impl_place(pixel, density), gabor_kernel(0.0, 0.0), seed);
    float2 along_x = amplitude * density.x * field.slope_x;
    float2 along_y = amplitude * density.y * field.slope_y;
    return GaborPixel{pixel.p + amplitude * field.value, pixel.dx + pixel.dx.x * along_x + pixel.dx.y * along_y,
                      pixel.dy + pixel.dy.x * along_x + pixel.dy.y * along_y, pixel.filtered, pixel.period};
}

// Turns the axes by an angle. If the pattern repeats, the new x axis takes one of 24 directions near that angle. A line
// in this direction closes after whole.x periods along x and whole.y along y; `other` completes a basis of the lattice
// of periods. So p repeats after the line's length along the new x axis, and after the distance between neighbouring
// lines along the new y axis. The axes are then not quite at right angles, which long kernels hide.
inline GaborPixel gabor_impl_turned(GaborPixel pixel, float angle) {
    float2 turn = gabor_impl_wave(0.15915494 * angle);
    float2 x = turn;
    float2 y = float2(-turn.y, turn.x);
    float2 period = float2(0.0);
    if (pixel.period.x > 0.0) {
        float2 whole = floor(3.0 * normalize(turn / pixel.period) + 0.5);
        float2 size = abs(whole);
        float2 signs = float2(whole.x < 0.0 ? -1.0 : 1.0, whole.y < 0.0 ? -1.0 : 1.0);
        if (size.x == size.y || size.x * size.y == 0.0) // (2, 2), (3, 0), (0, 3) become (1, 1), (1, 0), (0, 1)
            whole = signs * min(size, float2(1.0));
        size = abs(whole);
        float2 other = size.x > 1.0 && size.y > 1.0 ? (size.x > size.y ? signs : -signs)
                     : size.x == 1.0              ? float2(0.0, whole.x)
                                                  : float2(-whole.y, 0.0);
        period.x = length(whole * pixel.period);
        period.y = pixel.period.x * pixel.period.y / period.x;
        x = period.x * float2(other.y, -other.x) / pixel.period;
        y = period.y * float2(-whole.y, whole.x) / pixel.period;
    }
    return GaborPixel{float2(dot(x, pixel.p), dot(y, pixel.p)), float2(dot(x, pixel.dx), dot(y, pixel.dx)),
                      float2(dot(x, pixel.dy), dot(y, pixel.dy)), pixel.filtered, period};
}

// Repetitions per unit along each axis: `count` or, with a period, the nearest number for which the period holds a
// multiple of `whole` repetitions.
inline float2 gabor_impl_repeated(GaborPixel pixel, float count, float whole) {
    if (pixel.period.x > 0.0)
        return max(floor(pixel.period * (count / whole) + 0.5), float2(1.0)) * whole / pixel.period;
    return float2(count);
}

// ---- Functions of noise, averaged over what the filter removed -----------------------------------------------------

// A soft threshold: the normal distribution function of (noise - threshold) / softness, within 2e-5.
inline float gabor_impl_above(float noise, float removed, float threshold, float softness) {
    float scale = rsqrt(softness * softness + removed);
    float x = clamp(scale * noise - scale * threshold, -8.0, 8.0);
    return 1.0 / (1.0 + exp2(-x * (2.301726 + x * x * (0.1061787 - 0.00091164 * x * x))));
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
inline float gabor_impl_line(float noise, float removed, float width) {
    float variance = width * width + removed;
    return width * rsqrt(variance) * exp(-0.5 * noise * noise / variance);
}

// A factor of mean 1: exp(contrast noise - contrast^2 / 2).
inline float gabor_impl_tone(float noise, float removed, float contrast) {
    return exp(contrast * (noise - 0.5 * contrast * (1.0 - removed)));
}

// The phase of a complex noise as a vector: of length 1, or shorter where the filter averages over phases.
inline float2 gabor_impl_phase(float3 layer) {
    return layer.xy * rsqrt(dot(layer.xy, layer.xy) + 2.5 * layer.z + 1.0e-6);
}

// The integral of the square of a sawtooth that rises from 0 to 1.
inline float gabor_impl_rise_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.33333333 * (turns + t * t * t);
}

// The mean of the square of a sawtooth over the interval (phase, width) that gabor_impl_phase_of returns.
inline float gabor_impl_rise(float2 phase) {
    float3 ends = gabor_impl_ends(phase.x, phase.y);
    return ends.z * (gabor_impl_rise_integral(ends.y) - gabor_impl_rise_integral(ends.x));
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
inline GaborMaterial gabor_impl_material(float3 colour, float height, float roughness, float metalness) {
    return GaborMaterial{clamp(colour, 0.0, 1.0), height, roughness, metalness};
}

// ---- Materials -----------------------------------------------------------------------------------------------------

// Rings are lines of constant x that noise of low frequency bends until they close.
inline GaborMaterial gabor_wood_at(GaborPixel pixel, GaborWood wood, uint seed) {
    float2 bends = float2(0.43, 0.018) * wood.waviness;
    GaborPixel board = gabor_impl_warp(pixel, float2(1.1, 0.24), float2(bends.x, 0.0), gabor_lobe_seed(seed, 0));
    board = gabor_impl_warp(board, float2(4.0, 0.9), float2(bends.y, 0.0), gabor_lobe_seed(seed, 1));
    GaborPixel years = gabor_impl_warp(board, float2(6.5, 0.08), float2(0.455 / wood.rings, 0.0), gabor_lobe_seed(seed, 2));
    float rings = gabor_impl_repeated(pixel, wood.rings, 1.0).x;
    float steps = rings * rings * (years.dx.x * years.dx.x + years.dy.x * years.dy.x);
    float kept = 0.97 * exp(-min(4.9348022 * steps, 40.0)); // amplitude of the rings' wave after a Gaussian filter
    float ring = gabor_impl_rise(float2(rings * years.p.x, gabor_impl_phase_of(float2(kept, 0.0)).y));
    float3 pore = gabor_impl_spots(pixel, float2(90.0, 4.5), gabor_lobe_seed(seed, 3));
    float3 fibre = gabor_impl_spots(pixel, float2(150.0, 2.0), gabor_lobe_seed(seed, 4));
    float3 tone = gabor_impl_spots(board, float2(3.5, 0.35), gabor_lobe_seed(seed, 5));

    float tones = gabor_impl_tone(fibre.y, fibre.z, 0.11) * gabor_impl_tone(tone.y, tone.z, 0.13);
    float pores = wood.pores * gabor_impl_above(pore.y, pore.z, 1.1, 0.25); // a quarter as deep in late wood
    float early = (1.0 - ring) * (1.0 - pores);
    float late = ring * (1.0 - 0.25 * pores);
    float deep = 1.0 - early - late;
    float3 colour = tones * early * wood.early + (tones * late + 0.45 * deep) * wood.late;
    float height = 0.0006 * ring - 0.0024 * deep + 0.0002 * fibre.y;
    return gabor_impl_material(colour, height, wood.roughness * (1.0 - 0.2 * ring), 0.0);
}

inline GaborMaterial gabor_fabric_at(GaborPixel pixel, GaborFabric fabric, uint seed) {
    float2 count = gabor_impl_repeated(pixel, fabric.threads, 2.0);
    GaborPixel cloth = gabor_impl_warp(pixel, float2(0.7), float2(0.02 * fabric.unevenness), gabor_lobe_seed(seed, 0));
    float3 upright = gabor_impl_spots(cloth, float2(0.7 * count.x, 1.1), gabor_lobe_seed(seed, 1)); // for threads along y
    float3 level = gabor_impl_spots(cloth, float2(1.1, 0.7 * count.y), gabor_lobe_seed(seed, 2));
    float3 upright_fibre = gabor_impl_spots(cloth, float2(14.0, 2.0) * count, gabor_lobe_seed(seed, 3));
    float3 level_fibre = gabor_impl_spots(cloth, float2(2.0, 14.0) * count, gabor_lobe_seed(seed, 4));

    // A thread has a round profile, and goes over one crossing thread and under the next.
    float2 at = count * cloth.p + 0.13 * fabric.unevenness * float2(upright.x, level.x);
    float2 thread_ = floor(at);
    float2 within = at - thread_ - 0.5;
    float parity = fract(0.5 * (thread_.x + thread_.y)) > 0.25 ? -1.0 : 1.0;
    float2 thick = 1.0 + 0.16 * fabric.unevenness * float2(upright.y, level.y);
    float2 inside = 1.0 - 4.2 * within * within / (thick * thick);
    float2 crest = thick * sqrt(max(inside, 0.0)) - 1.0
                 + 0.55 * parity * cos(3.1415927 * within.yx) * float2(1.0, -1.0) - (1.0 - step(0.0, inside));
    bool first = crest.x > crest.y;
    float top = max(max(crest.x, crest.y), -1.3);
    float3 tone = first ? upright : level;
    float3 fibre = first ? upright_fibre : level_fibre;

    // `kept` is the part of the weave that the filter keeps. The rest becomes the mean, which was measured and depends
    // on the unevenness.
    float2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = exp(-min(2.5 * (steps.x + steps.y), 40.0));
    float uneven = fabric.unevenness;
    float light = mix(0.8572 + uneven * (0.005 + 0.0083 * uneven), smoothstep(-1.3, 0.5, top), kept);
    float share = mix(0.5, first ? 1.0 : 0.0, kept);
    float3 colour = mix(fabric.weft, fabric.warp, share) * mix(0.18, 1.0, light);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.09 * fabric.unevenness) * gabor_impl_tone(fibre.y, fibre.z, 0.12);
    top = mix(0.1352 + uneven * (0.0045 + 0.0062 * uneven), top, kept);
    float height = fabric.relief / fabric.threads * (0.3 * top + 0.035 * fibre.y);
    if (fabric.cords > 0.0) { // wide crests and narrow furrows, 1 - cos(pi x)^4: two waves, which the filter damps
        float cords = gabor_impl_repeated(pixel, fabric.cords, 1.0).x;
        float damped = exp(-min(4.9348022 * cords * cords * (cloth.dx.x * cloth.dx.x + cloth.dy.x * cloth.dy.x), 20.0));
        float turn = 6.2831853 * fract(cords * cloth.p.x);
        float cord = 0.625 - damped * (0.5 * cos(turn) + 0.125 * damped * damped * damped * cos(2.0 * turn));
        colour *= mix(0.3, 1.0, cord);
        height += 0.3 * fabric.relief / cords * cord;
    }
    return gabor_impl_material(colour, height, fabric.roughness, 0.0);
}

// Three waves; the phase of the third is the sum of the other two, so the crests of all three meet in each cell's middle.
inline GaborMaterial gabor_leather_at(GaborPixel pixel, GaborLeather leather, uint seed) {
    GaborPixel skin = gabor_impl_warp(pixel, float2(0.9), float2(0.07 * leather.wrinkles), gabor_lobe_seed(seed, 0));
    skin = gabor_impl_warp(skin, float2(4.0), float2(0.014 * leather.wrinkles), gabor_lobe_seed(seed, 1));
    float2 density = float2(leather.cells / 1.6);
    float3 one = gabor_impl_layer(skin, density, 1.6, 0.2, gabor_lobe_seed(seed, 2));
    float3 other = gabor_impl_layer(skin, density, 1.6, 2.2944, gabor_lobe_seed(seed, 3));
    float3 fine = gabor_impl_octaves(pixel, float2(18.0), 3, 0.75, gabor_lobe_seed(seed, 4));
    float3 tone = gabor_impl_spots(pixel, float2(0.8), gabor_lobe_seed(seed, 5));

    float2 powers = float2(dot(one.xy, one.xy), dot(other.xy, other.xy));
    float2 a = one.xy * rsqrt(powers.x + 0.12);
    float2 b = other.xy * rsqrt(powers.y + 0.12);
    float cells = a.x + b.x + gabor_impl_product(a, b).x; // 3 in the middle of a cell, -1.5 in a corner
    float2 shares = powers / (powers + 2.5 * float2(one.z, other.z));
    float kept = sqrt(shares.x * shares.y);
    float blur = 1.0 - kept;
    float pebble = mix(0.806, smoothstep(-1.45 - blur, -0.55 + blur, cells + 0.1 * fine.y), kept);
    float3 colour = mix(leather.crease, leather.pebble, pebble);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.14) * gabor_impl_tone(fine.x, fine.z, 0.08);
    float dome = mix(0.236, smoothstep(-1.0, 3.0, cells), kept);
    float height = leather.relief * (0.016 * pebble + 0.013 * dome + 0.0016 * fine.y);
    return gabor_impl_material(colour, height, leather.roughness + 0.15 * (1.0 - pebble), 0.0);
}

// Adds veins: lines along the zeros of layer.x, drawn only where layer.y exceeds a threshold, so they have
// ends. Each vein has a core in the middle of a halo. Widths and strengths are (halo, core).
inline float3 gabor_impl_vein(float3 colour, float3 layer, float threshold, float3 halo, float3 core, float2 width, float2 strength) {
    float open = gabor_impl_above(layer.y, layer.z, threshold, 0.5);
    strength.y *= open * gabor_impl_line(layer.x, layer.z, width.y);
    strength.x *= open * gabor_impl_line(layer.x, layer.z, width.x) - strength.y;
    return colour + strength.x * (halo - colour) + strength.y * (core - colour);
}

inline GaborMaterial gabor_marble_at(GaborPixel pixel, GaborMarble marble, uint seed) {
    float4 bends = float4(0.17, 0.038, 0.010, 0.003) * marble.turbulence;
    GaborPixel stone = gabor_impl_warp(pixel, float2(1.1), float2(bends.x), gabor_lobe_seed(seed, 0));
    stone = gabor_impl_warp(stone, float2(4.0), float2(bends.y), gabor_lobe_seed(seed, 1));
    stone = gabor_impl_warp(stone, float2(13.0), float2(bends.z), gabor_lobe_seed(seed, 2));
    stone = gabor_impl_warp(stone, float2(40.0), float2(bends.w), gabor_lobe_seed(seed, 3));
    float3 large = gabor_impl_layer(stone, float2(0.95), 0.85, 0.65, gabor_lobe_seed(seed, 4));
    float3 middle = gabor_impl_layer(stone, float2(1.9), 0.95, -0.45, gabor_lobe_seed(seed, 5));
    float3 thin = gabor_impl_layer(stone, float2(4.5), 0.95, 0.95, gabor_lobe_seed(seed, 6));
    float3 hair = gabor_impl_layer(stone, float2(13.0), 0.9, 0.2, gabor_lobe_seed(seed, 7));
    float3 cloud = gabor_impl_octaves(stone, float2(1.5), 3, 0.6, gabor_lobe_seed(seed, 8));
    float3 crystal = gabor_impl_spots(pixel, float2(75.0), gabor_lobe_seed(seed, 9));

    float3 colour = marble.stone * (1.0 - marble.clouds * gabor_impl_above(cloud.y, cloud.z, 0.5, 0.8));
    colour *= gabor_impl_tone(crystal.x, crystal.z, 0.02);
    float3 grey = mix(marble.stone, marble.vein, 0.65);
    colour = gabor_impl_vein(colour, middle, 0.5, grey, mix(marble.stone, marble.vein, 0.9), float2(0.25, 0.035),
                             float2(0.6, 0.6) * marble.veins);
    colour = gabor_impl_vein(colour, large, -0.4, grey, marble.vein, float2(0.35, 0.05), float2(0.55, 0.75) * marble.veins);
    colour = gabor_impl_vein(colour, thin, 0.8, grey, grey, float2(1.0, 0.04), float2(0.0, 0.45) * marble.veins);
    colour = gabor_impl_vein(colour, hair, 1.1, grey, mix(marble.stone, marble.vein, 0.45), float2(1.0, 0.05),
                             float2(0.0, 0.45) * marble.veins);
    return gabor_impl_material(colour, 0.00012 * crystal.y, marble.roughness, 0.0);
}

inline GaborMaterial gabor_sand_at(GaborPixel pixel, GaborSand sand, uint seed) {
    GaborPixel dune = gabor_impl_warp(pixel, float2(0.8), float2(0.15), gabor_lobe_seed(seed, 0));
    dune = gabor_impl_warp(dune, float2(3.0), float2(0.02), gabor_lobe_seed(seed, 1));
    float2 density = float2(0.9, 1.7) / 3.87 * sand.ripples;
    float3 wind = gabor_impl_layer(dune, density, 2.3, 1.4, gabor_lobe_seed(seed, 2));
    float3 grain = gabor_impl_spots(pixel, float2(75.0), gabor_lobe_seed(seed, 3));
    float3 large = gabor_impl_octaves(pixel, float2(0.6), 3, 0.5, gabor_lobe_seed(seed, 4));

    float ripple = gabor_impl_rise(gabor_impl_phase_of(0.9 * gabor_impl_phase(wind)));
    float3 colour = mix(sand.trough, sand.crest, ripple);
    colour *= gabor_impl_tone(grain.x, grain.z, sand.grain) * gabor_impl_tone(large.y, large.z, 0.06);
    colour = mix(colour, 0.23 * sand.trough, 3.75 * sand.grain * gabor_impl_above(grain.y, grain.z, 1.9, 0.15));
    float3 bright = mix(sand.crest, float3(1.0), 0.6);
    colour = mix(colour, bright, 3.0 * sand.grain * gabor_impl_above(-grain.y, grain.z, 1.9, 0.15));
    float height = sand.relief * ripple * (1.0 + 0.2 * large.x) + 0.03 * large.x + 0.00875 * sand.grain * grain.x;
    return gabor_impl_material(colour, height, sand.roughness, 0.0);
}

// A sum of waves with their second harmonics, after Stokes: crests are sharp and troughs flat. The part of a wave that
// the filter removed does not change the mean of the harmonic.
inline GaborMaterial gabor_ripples_at(GaborPixel pixel, GaborRipples ripples, uint seed) {
    float height = 0.0;
    float crest = 0.0;
    float removed = 0.0;
    float power = 0.0;
    for (int i = 0; i < 14; ++i) {
        float waves = ripples.waves * exp2(0.27 * float(i)); // waves per unit
        float angle = ripples.direction + ripples.spread * (fract(0.618034 * float(i) + 0.1) - 0.5);
        float3 wave = gabor_impl_layer(pixel, float2(waves / 2.2), 2.2, angle, gabor_lobe_seed(seed, i));
        float amplitude = exp2(-0.351 * float(i));
        height += amplitude * (wave.x + 0.2 * (wave.x * wave.x - wave.y * wave.y));
        crest += amplitude * wave.x;
        removed += amplitude * amplitude * wave.z;
        power += amplitude * amplitude;
    }
    float light = gabor_impl_above(crest * rsqrt(power), removed / power, 0.5, 1.0);
    float3 colour = mix(ripples.deep, ripples.shallow, light);
    return gabor_impl_material(colour, ripples.relief * height, ripples.roughness, 0.0);
}

inline GaborMaterial gabor_brushed_metal_at(GaborPixel pixel, GaborBrushedMetal metal, uint seed) {
    float height = 0.0;
    float2 tone = float2(0.0);
    for (int i = 0; i < 5; ++i) {
        float fine = exp2(float(i));
        float2 density = float2(0.3 + 0.12 * fine, metal.streaks * fine);
        float3 streak = gabor_impl_spots(pixel, density, gabor_lobe_seed(seed, i));
        height += metal.relief / fine * streak.x;
        tone += float2(0.4472136, 0.2) * streak.yz;
    }
    float3 colour = metal.colour * gabor_impl_tone(tone.x, tone.y, metal.contrast);
    return gabor_impl_material(colour, height, metal.roughness, 1.0);
}

// Scratches are the peaks of noise with very long and narrow kernels, in many directions.
inline GaborMaterial gabor_scratches_at(GaborPixel pixel, GaborScratches scratches, uint seed) {
    float whole = 1.0;
    float height = 0.0;
    float size = 1.0;
    float turn = 0.0955;
    float threshold = sqrt(5.76 - 2.0 * log(scratches.amount)); // the area above it is about proportional to amount
    for (int i = 0; i < 14; ++i) {
        GaborPixel turned = gabor_impl_turned(pixel, scratches.direction + scratches.spread * (turn - 0.5));
        turned = gabor_impl_warp(turned, float2(0.3, 0.1), float2(0.0, 0.17), gabor_lobe_seed(seed, 2 * i));
        float2 density = float2(1.0 / scratches.reach, 42.0) / size;
        float3 noise = gabor_impl_spots(turned, density, gabor_lobe_seed(seed, 2 * i + 1));
        float scratch = gabor_impl_above(noise.x, noise.z, threshold, 0.2);
        scratch *= gabor_impl_above(noise.y, noise.z, 0.3, 0.7);
        whole *= 1.0 - (0.25 + 0.7 * size) * scratch;
        height -= scratches.depth * size * scratch;
        size *= 0.9138315;
        turn = fract(turn + 0.763932);
    }
    return gabor_impl_material(mix(scratches.scratch, scratches.lacquer, whole), height, scratches.roughness, 0.0);
}

inline GaborMaterial gabor_zebra_at(GaborPixel pixel, GaborZebra zebra, uint seed) {
    GaborPixel skin = gabor_impl_warp(pixel, float2(0.9), float2(0.14), gabor_lobe_seed(seed, 0));
    GaborPlace place = gabor_impl_place(pixel, float2(0.6));
    float lean = gabor_field(place, gabor_kernel(0.0, 0.0), gabor_lobe_seed(seed, 1)).value.x;
    float3 stripe = gabor_impl_layer(skin, float2(zebra.stripes / 1.4), 1.4, zebra.direction + zebra.bends * lean,
                                   gabor_lobe_seed(seed, 2));
    float3 hair = gabor_impl_spots(gabor_impl_turned(skin, 2.0707963), float2(6.0, 80.0), gabor_lobe_seed(seed, 3));
    float3 tone = gabor_impl_spots(pixel, float2(1.2), gabor_lobe_seed(seed, 4));

    float intensity = length(stripe.xy); // small where stripe.x is flat, where a constant softness would blur the edge
    float ragged = 0.1 * zebra.hair;
    float dark = gabor_impl_above(stripe.x + ragged * intensity * hair.x, stripe.z + ragged * ragged * hair.z, 0.0,
                                  0.01 + 0.09 * intensity);
    float3 colour = mix(zebra.bright, zebra.stripe, dark);
    colour *= gabor_impl_tone(hair.y, hair.z, 0.14 * zebra.hair) * gabor_impl_tone(tone.y, tone.z, 0.08);
    return gabor_impl_material(colour, 0.002 * zebra.hair * hair.x, zebra.roughness, 0.0);
}

inline GaborMaterial gabor_bark_at(GaborPixel pixel, GaborBark bark, uint seed) {
    GaborPixel trunk = gabor_impl_warp(pixel, float2(0.8, 0.35), float2(0.22, 0.1), gabor_lobe_seed(seed, 0));
    trunk = gabor_impl_warp(trunk, float2(3.0, 1.6), float2(0.05, 0.05), gabor_lobe_seed(seed, 1));
    trunk = gabor_impl_warp(trunk, float2(10.0), float2(0.013), gabor_lobe_seed(seed, 2));
    float2 density = float2(1.7, 0.55) / 2.21 * bark.furrows;
    float3 furrow = gabor_impl_layer(trunk, density, 1.3, 0.1, gabor_lobe_seed(seed, 3));
    float3 crack = gabor_impl_layer(trunk, float2(1.2, 1.3), 0.9, 1.5, gabor_lobe_seed(seed, 4));
    float3 rough = gabor_impl_octaves(trunk, float2(7.0, 3.0), 5, 0.75, gabor_lobe_seed(seed, 5));
    float3 moss = gabor_impl_spots(pixel, float2(1.1, 0.7), gabor_lobe_seed(seed, 6));

    float shape = furrow.x + 0.2 * rough.x;
    float plate = gabor_impl_above(shape, furrow.z + 0.04 * rough.z, -0.15, 0.35)
                  * (1.0 - 0.55 * gabor_impl_line(crack.x, crack.z, 0.13));
    // Weighted by the tone exp(0.25 noise), the removed part of the noise has a mean of 0.25 times its variance.
    float worn = 0.5 * gabor_impl_above(rough.y + 0.25 * rough.z, rough.z, 0.5, 0.4);
    float covered = bark.cover * gabor_impl_above(moss.y, moss.z, 0.9, 0.5);
    float3 top = mix(bark.plate, mix(bark.plate, float3(1.0), 0.13), worn);
    float3 colour = mix(mix(bark.furrow, bark.moss, covered), mix(top, bark.moss, 0.6 * covered), plate);
    colour *= gabor_impl_tone(rough.y, rough.z, 0.25);
    float height = bark.depth * plate + 0.018 * rough.x * (0.4 + 0.6 * plate);
    return gabor_impl_material(colour, height, bark.roughness, 0.0);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
inline GaborMaterial gabor_carbon_fibre_at(GaborPixel pixel, GaborCarbonFibre fibres, uint seed) {
    float2 count = gabor_impl_repeated(pixel, fibres.tows, 4.0);
    GaborPixel cloth = gabor_impl_warp(pixel, float2(0.8), float2(0.008), gabor_lobe_seed(seed, 0));
    float3 upright = gabor_impl_spots(cloth, float2(20.0, 0.6) * count, gabor_lobe_seed(seed, 1));
    float3 level = gabor_impl_spots(cloth, float2(0.6, 20.0) * count, gabor_lobe_seed(seed, 2));
    float2 tow = floor(count * cloth.p);
    float2 within = count * cloth.p - tow;
    float turn = 4.0 * fract(0.25 * (tow.x + tow.y) + 0.125) - 0.5; // 0 to 3
    bool first = turn < 1.5;
    float3 fibre = first ? upright : level;
    float2 along_across = first ? within.yx : within;
    float along = 0.5 * (along_across.x + (fract(0.5 * turn + 0.25) < 0.5 ? 0.0 : 1.0)); // from 0 to 1 over two rows
    float across = 2.0 * along_across.y - 1.0;

    float2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = exp(-min(2.5 * (steps.x + steps.y), 40.0));
    float bulge = mix(0.5093, sin(3.1415927 * along) * (1.0 - across * across * across * across), kept);
    float3 colour = fibres.colour * (0.35 + 0.65 * bulge) * gabor_impl_tone(fibre.x, fibre.z, fibres.contrast);
    float height = fibres.relief / fibres.tows * (0.16 * bulge + 0.006 * fibre.x);
    return gabor_impl_material(colour, height, fibres.roughness, 0.0);
}

inline GaborMaterial gabor_strata_at(GaborPixel pixel, GaborStrata strata, uint seed) {
    float4 folds = float4(0.2, 0.016, 0.022, 0.004) * strata.folds;
    GaborPixel rock = gabor_impl_warp(pixel, float2(0.35, 0.6), float2(0.0, folds.x), gabor_lobe_seed(seed, 0));
    rock = gabor_impl_warp(rock, float2(1.6, 2.6), float2(folds.y, folds.z), gabor_lobe_seed(seed, 1));
    rock = gabor_impl_warp(rock, float2(7.0, 10.0), float2(folds.w), gabor_lobe_seed(seed, 2));
    float2 layers = float2(1.0, strata.layers);
    float3 broad = gabor_impl_spots(rock, float2(0.1, 0.33333333) * layers, gabor_lobe_seed(seed, 3));
    float3 band = gabor_impl_spots(rock, float2(0.14, 1.0) * layers, gabor_lobe_seed(seed, 4));
    float3 thin = gabor_impl_spots(rock, float2(0.25, 2.8333333) * layers, gabor_lobe_seed(seed, 5));
    float3 lamina = gabor_impl_spots(rock, float2(0.6, 8.3333333) * layers, gabor_lobe_seed(seed, 6));
    float3 grain = gabor_impl_octaves(pixel, float2(16.0, 24.0), 4, 0.8, gabor_lobe_seed(seed, 7));

    float soft = gabor_impl_above(band.x, band.z, 0.5, 0.22); // the soft layers, which erode
    float3 colour = mix(strata.rock, strata.sandstone, gabor_impl_above(broad.x, broad.z, 0.0, 0.5));
    colour = mix(colour, strata.red, 0.8 * soft);
    colour = mix(colour, strata.pale, 0.75 * gabor_impl_above(thin.x, thin.z, 1.0, 0.2));
    colour = mix(colour, 0.75 * strata.red, 0.6 * gabor_impl_above(thin.y, thin.z, 1.3, 0.15));
    colour *= gabor_impl_tone(lamina.x, lamina.z, 0.13) * gabor_impl_tone(grain.x, grain.z, 0.11);
    float height = 0.02 * broad.y - 0.012 * soft + 0.006 * thin.x + 0.0015 * lamina.x + 0.003 * grain.y;
    return gabor_impl_material(colour, strata.relief * height, strata.roughness, 0.0);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

inline GaborPixel gabor_pixel(float2 p) {
    return GaborPixel{p, float2(0.0), float2(0.0), false, float2(0.0)};
}

inline GaborPixel gabor_pixel_filtered(float2 p, float2 dx, float2 dy) {
    return GaborPixel{p, dx, dy, true, float2(0.0)};
}

inline GaborPixel gabor_pixel_tiled(GaborPixel pixel, float2 period) {
    return GaborPixel{pixel.p - period * floor(pixel.p / period), pixel.dx, pixel.dy, pixel.filtered, period};
}

inline GaborWood gabor_wood_default() {
    return GaborWood{float3(0.50, 0.275, 0.115), float3(0.20, 0.078, 0.027), 13.0, 1.0, 0.75, 0.5};
}

inline GaborFabric gabor_fabric_default() {
    return GaborFabric{float3(0.50, 0.43, 0.33), float3(0.60, 0.53, 0.42), 12.0, 1.0, 1.0, 0.85, 0.0};
}

inline GaborLeather gabor_leather_default() {
    return GaborLeather{float3(0.20, 0.068, 0.026), float3(0.04, 0.014, 0.007), 6.88, 1.0, 1.0, 0.4};
}

inline GaborMarble gabor_marble_default() {
    return GaborMarble{float3(0.80, 0.79, 0.77), float3(0.13, 0.135, 0.145), 1.0, 1.0, 0.25, 0.2};
}

inline GaborSand gabor_sand_default() {
    return GaborSand{float3(0.43, 0.30, 0.17), float3(0.60, 0.44, 0.265), 3.87, 0.055, 0.16, 0.9};
}

inline GaborRipples gabor_ripples_default() {
    return GaborRipples{float3(0.004, 0.06, 0.085), float3(0.03, 0.25, 0.27), 0.6, 0.8726646, 1.0471976, 0.035, 0.1};
}

inline GaborBrushedMetal gabor_brushed_metal_default() {
    return GaborBrushedMetal{float3(0.55, 0.555, 0.565), 9.0, 0.09, 0.0012, 0.36};
}

inline GaborScratches gabor_scratches_default() {
    return GaborScratches{float3(0.035, 0.042, 0.05), float3(0.60, 0.61, 0.62), 1.0, 3.0, 1.5707963, 3.1415927, 0.0025,
                          0.3};
}

inline GaborZebra gabor_zebra_default() {
    return GaborZebra{float3(0.70, 0.64, 0.54), float3(0.018, 0.014, 0.012), 1.96, 0.2967060, 0.3490659, 1.0, 0.7};
}

inline GaborBark gabor_bark_default() {
    return GaborBark{float3(0.20, 0.145, 0.10), float3(0.025, 0.014, 0.008), float3(0.10, 0.13, 0.045), 2.21, 0.35, 0.13,
                     0.9};
}

inline GaborCarbonFibre gabor_carbon_fibre_default() {
    return GaborCarbonFibre{float3(0.028, 0.029, 0.031), 4.0, 0.3, 1.0, 0.3};
}

inline GaborStrata gabor_strata_default() {
    return GaborStrata{float3(0.50, 0.22, 0.09), float3(0.60, 0.35, 0.18), float3(0.28, 0.075, 0.035), float3(0.74, 0.58, 0.40),
                       6.0, 1.0, 1.0, 0.9};
}

inline GaborMaterial gabor_wood(float2 p, uint seed) {
    return gabor_wood_at(gabor_pixel(p), gabor_wood_default(), seed);
}

inline GaborMaterial gabor_fabric(float2 p, uint seed) {
    return gabor_fabric_at(gabor_pixel(p), gabor_fabric_default(), seed);
}

inline GaborMaterial gabor_leather(float2 p, uint seed) {
    return gabor_leather_at(gabor_pixel(p), gabor_leather_default(), seed);
}

inline GaborMaterial gabor_marble(float2 p, uint seed) {
    return gabor_marble_at(gabor_pixel(p), gabor_marble_default(), seed);
}

inline GaborMaterial gabor_sand(float2 p, uint seed) {
    return gabor_sand_at(gabor_pixel(p), gabor_sand_default(), seed);
}

inline GaborMaterial gabor_ripples(float2 p, uint seed) {
    return gabor_ripples_at(gabor_pixel(p), gabor_ripples_default(), seed);
}

inline GaborMaterial gabor_brushed_metal(float2 p, uint seed) {
    return gabor_brushed_metal_at(gabor_pixel(p), gabor_brushed_metal_default(), seed);
}

inline GaborMaterial gabor_scratches(float2 p, uint seed) {
    return gabor_scratches_at(gabor_pixel(p), gabor_scratches_default(), seed);
}

inline GaborMaterial gabor_zebra(float2 p, uint seed) {
    return gabor_zebra_at(gabor_pixel(p), gabor_zebra_default(), seed);
}

inline GaborMaterial gabor_bark(float2 p, uint seed) {
    return gabor_bark_at(gabor_pixel(p), gabor_bark_default(), seed);
}

inline GaborMaterial gabor_carbon_fibre(float2 p, uint seed) {
    return gabor_carbon_fibre_at(gabor_pixel(p), gabor_carbon_fibre_default(), seed);
}

inline GaborMaterial gabor_strata(float2 p, uint seed) {
    return gabor_strata_at(gabor_pixel(p), gabor_strata_default(), seed);
}

inline GaborMaterial gabor_wood_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_wood_at(gabor_pixel_filtered(p, dx, dy), gabor_wood_default(), seed);
}

inline GaborMaterial gabor_fabric_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_fabric_at(gabor_pixel_filtered(p, dx, dy), gabor_fabric_default(), seed);
}

inline GaborMaterial gabor_leather_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_leather_at(gabor_pixel_filtered(p, dx, dy), gabor_leather_default(), seed);
}

inline GaborMaterial gabor_marble_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_marble_at(gabor_pixel_filtered(p, dx, dy), gabor_marble_default(), seed);
}

inline GaborMaterial gabor_sand_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_sand_at(gabor_pixel_filtered(p, dx, dy), gabor_sand_default(), seed);
}

inline GaborMaterial gabor_ripples_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_ripples_at(gabor_pixel_filtered(p, dx, dy), gabor_ripples_default(), seed);
}

inline GaborMaterial gabor_brushed_metal_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_brushed_metal_at(gabor_pixel_filtered(p, dx, dy), gabor_brushed_metal_default(), seed);
}

inline GaborMaterial gabor_scratches_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_scratches_at(gabor_pixel_filtered(p, dx, dy), gabor_scratches_default(), seed);
}

inline GaborMaterial gabor_zebra_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_zebra_at(gabor_pixel_filtered(p, dx, dy), gabor_zebra_default(), seed);
}

inline GaborMaterial gabor_bark_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_bark_at(gabor_pixel_filtered(p, dx, dy), gabor_bark_default(), seed);
}

inline GaborMaterial gabor_carbon_fibre_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_carbon_fibre_at(gabor_pixel_filtered(p, dx, dy), gabor_carbon_fibre_default(), seed);
}

inline GaborMaterial gabor_strata_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_strata_at(gabor_pixel_filtered(p, dx, dy), gabor_strata_default(), seed);
}

#endif // GABOR_MATERIALS_METAL
