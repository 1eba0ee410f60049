// clang-format off
// gabor_materials.hpp: twelve materials from Gabor noise: for C++ on the CPU.
//
// Generated from shaders/gabor_materials.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hpp. Paste or include it after gabor_spectrum.hpp.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dFdx(p), dFdy(p), 7u);  // averaged over a pixel
//
// One unit of p shows a characteristic piece of a material; four by four units make a good picture.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_SPECTRUM_HPP
#error Include gabor_lattice.hpp and gabor_spectrum.hpp before gabor_materials.hpp
#endif
#if GABOR_TAPS != 3
#error gabor_materials.hpp needs GABOR_TAPS 3
#endif
#ifndef GABOR_MATERIALS_HPP
#define GABOR_MATERIALS_HPP

struct GaborMaterial {
    gabor_vec3 colour;     // base colour of physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // in units of p
    float roughness; // as in glTF
    float metalness; // 0 or 1
};

// The material at p; the number of noises that it evaluates is in brackets.
// GaborMaterial gabor_wood(vec2 p, uint seed)             a board: year rings cut lengthwise, pores, fibres [6]
// GaborMaterial gabor_fabric(vec2 p, uint seed)           linen: a plain weave of uneven threads [5]
// GaborMaterial gabor_leather(vec2 p, uint seed)          pebbled grain: cells between creases [8]
// GaborMaterial gabor_marble(vec2 p, uint seed)           white, with veins of four sizes [12]
// GaborMaterial gabor_sand(vec2 p, uint seed)             wind ripples, steep on one side, and grains [7]
// GaborMaterial gabor_ripples(vec2 p, uint seed)          water under a light wind [14]
// GaborMaterial gabor_brushed_metal(vec2 p, uint seed)    streaks along x [5]
// GaborMaterial gabor_scratches(vec2 p, uint seed)        hairlines in a dark lacquer [28]
// GaborMaterial gabor_zebra(vec2 p, uint seed)            stripes that fork, and hair [5]
// GaborMaterial gabor_bark(vec2 p, uint seed)             furrows and plates, moss [11]
// GaborMaterial gabor_carbon_fibre(vec2 p, uint seed)     a twill of black tows [3]
// GaborMaterial gabor_strata(vec2 p, uint seed)           layers of sandstone, seen from the side [11]

// The same averaged over a pixel. dx and dy are dFdx(p) and dFdy(p): the change of p from one pixel to the next. Noises
// that only displace the pattern cost as much as unfiltered, all others as much as gabor_noise_filtered.
// GaborMaterial gabor_wood_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_fabric_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_leather_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_marble_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_sand_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_ripples_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_brushed_metal_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_scratches_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_zebra_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_bark_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_carbon_fibre_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborMaterial gabor_strata_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)

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

// ---- Noises --------------------------------------------------------------------------------------------------------

// A place and the steps to the neighbouring pixels.
struct GaborPixel {
    gabor_vec2 p;
    gabor_vec2 dx;
    gabor_vec2 dy;
    bool filtered;
};

// Two independent noises, the parts of a complex one, and the removed share of their variance.
//   density  kernels per unit along x and y
GABOR_INLINE gabor_vec3 gabor_impl_layer(GaborPixel pixel, gabor_vec2 density, float frequency, float orientation, std::uint32_t seed) {
    GaborPlace place = gabor_place(gabor_ivec2(0), GABOR_RADIUS * density * pixel.p);
    GaborKernel kernel = gabor_kernel(frequency, orientation);
    if (!pixel.filtered)
        return gabor_vec3(gabor_field(place, kernel, seed).value, 0.0f);
    float removed;
    GaborFootprint footprint = gabor_footprint(density * pixel.dx, density * pixel.dy);
    gabor_vec2 value = gabor_field_filtered(place, kernel, footprint, seed, removed).value;
    return gabor_vec3(value, removed);
}

// The same at frequency 0: spots as large as a kernel.
GABOR_INLINE gabor_vec3 gabor_impl_spots(GaborPixel pixel, gabor_vec2 density, std::uint32_t seed) {
    return gabor_impl_layer(pixel, density, 0.0f, 0.0f, seed);
}

// A sum of spots, each octave half as large with `gain` times the amplitude.
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

// Moves the place by two noises, and its steps accordingly.
GABOR_INLINE GaborPixel gabor_impl_warp(GaborPixel pixel, gabor_vec2 density, gabor_vec2 amplitude, std::uint32_t seed) {
    GaborPlace place = gabor_place(gabor_ivec2(0), GABOR_RADIUS * density * pixel.p);
    GaborField field = gabor_field(place, gabor_kernel(0.0f, 0.0f), seed);
    gabor_vec2 along_x = amplitude * density.x * field.slope_x;
    gabor_vec2 along_y = amplitude * density.y * field.slope_y;
    return GaborPixel{pixel.p + amplitude * field.value, pixel.dx + pixel.dx.x * along_x + pixel.dx.y * along_y,
                      pixel.dy + pixel.dy.x * along_x + pixel.dy.y * along_y, pixel.filtered};
}

// Turns the axes by an angle.
GABOR_INLINE GaborPixel gabor_impl_turned(GaborPixel pixel, float angle) {
    gabor_vec2 turn = gabor_impl_wave(-0.15915494f * angle);
    return GaborPixel{gabor_impl_product(turn, pixel.p), gabor_impl_product(turn, pixel.dx),
                      gabor_impl_product(turn, pixel.dy), pixel.filtered};
}

// ---- Functions of noise, and their means over the removed part -----------------------------------------------------

// Where the noise is above a threshold: the normal distribution function of (noise - threshold) / softness, within
// 1.5e-4 (Bowling et al., "A logistic approximation to the cumulative normal distribution", 2009).
GABOR_INLINE float gabor_impl_above(float noise, float removed, float threshold, float softness) {
    float x = gabor_cpp_clamp((noise - threshold) * gabor_cpp_inversesqrt(softness * softness + removed), -8.0f, 8.0f);
    return 1.0f / (1.0f + gabor_cpp_exp(-x * (1.5976f + 0.07056f * x * x)));
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

// The unit vector of a complex noise's phase; shorter where it is a mean.
GABOR_INLINE gabor_vec2 gabor_impl_phase(gabor_vec3 layer) {
    return layer.xy() * gabor_cpp_inversesqrt(gabor_cpp_dot(layer.xy(), layer.xy()) + 2.5f * layer.z + 1.0e-6f);
}

// The same for a phase that grows evenly: the wave after a normal filter.
GABOR_INLINE gabor_vec2 gabor_impl_turns(float turns, float dx, float dy) {
    return gabor_cpp_exp(-gabor_cpp_min(4.9348022f * (dx * dx + dy * dy), 40.0f)) * gabor_impl_wave(turns);
}

// The square of a sawtooth from 0 to 1, with mean 1/3: t^2 = t - 4 t (1 - t) / 4.
GABOR_INLINE float gabor_impl_rise(gabor_vec2 stripes) {
    return gabor_stripes_sawtooth(stripes) - 0.25f * gabor_stripes_ridges(stripes);
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
GABOR_INLINE GaborMaterial gabor_impl_material(gabor_vec3 colour, float height, float roughness, float metalness) {
    return GaborMaterial{gabor_cpp_clamp(colour, 0.0f, 1.0f), height, roughness, metalness};
}

// ---- Materials -----------------------------------------------------------------------------------------------------

// Rings are lines of equal x that slow noise bends until they close: a board cut beside the pith.
GABOR_INLINE GaborMaterial gabor_impl_wood(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel board = gabor_impl_warp(pixel, gabor_vec2(1.1f, 0.24f), gabor_vec2(0.43f, 0.0f), gabor_lobe_seed(seed, 0));
    board = gabor_impl_warp(board, gabor_vec2(4.0f, 0.9f), gabor_vec2(0.018f, 0.0f), gabor_lobe_seed(seed, 1));
    GaborPixel years = gabor_impl_warp(board, gabor_vec2(6.5f, 0.08f), gabor_vec2(0.035f, 0.0f), gabor_lobe_seed(seed, 2));
    float ring = gabor_impl_rise(0.97f * gabor_impl_turns(13.0f * years.p.x, 13.0f * years.dx.x, 13.0f * years.dy.x));
    gabor_vec3 pore = gabor_impl_spots(pixel, gabor_vec2(90.0f, 4.5f), gabor_lobe_seed(seed, 3));
    gabor_vec3 fibre = gabor_impl_spots(pixel, gabor_vec2(150.0f, 2.0f), gabor_lobe_seed(seed, 4));
    gabor_vec3 tone = gabor_impl_spots(board, gabor_vec2(3.5f, 0.35f), gabor_lobe_seed(seed, 5));

    float pores = (1.0f - 0.75f * ring) * gabor_impl_above(pore.y, pore.z, 1.1f, 0.25f);
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.50f, 0.275f, 0.115f), gabor_vec3(0.20f, 0.078f, 0.027f), ring);
    colour *= gabor_impl_tone(fibre.y, fibre.z, 0.11f) * gabor_impl_tone(tone.y, tone.z, 0.13f);
    colour = gabor_cpp_mix(colour, gabor_vec3(0.09f, 0.035f, 0.014f), 0.75f * pores);
    float height = 0.0006f * ring - 0.0018f * pores + 0.0002f * fibre.y;
    return gabor_impl_material(colour, height, 0.5f - 0.1f * ring, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_fabric(GaborPixel pixel, std::uint32_t seed) {
    const float count = 12.0f; // threads per unit
    GaborPixel cloth = gabor_impl_warp(pixel, gabor_vec2(0.7f), gabor_vec2(0.02f), gabor_lobe_seed(seed, 0));
    gabor_vec3 upright = gabor_impl_spots(cloth, gabor_vec2(0.7f * count, 1.1f), gabor_lobe_seed(seed, 1)); // uneven along y
    gabor_vec3 level = gabor_impl_spots(cloth, gabor_vec2(1.1f, 0.7f * count), gabor_lobe_seed(seed, 2));
    gabor_vec3 upright_fibre = gabor_impl_spots(cloth, gabor_vec2(14.0f, 2.0f) * count, gabor_lobe_seed(seed, 3));
    gabor_vec3 level_fibre = gabor_impl_spots(cloth, gabor_vec2(2.0f, 14.0f) * count, gabor_lobe_seed(seed, 4));

    // A thread has a round profile, and goes over one crossing thread and under the next.
    gabor_vec2 at = count * cloth.p + 0.13f * gabor_vec2(upright.x, level.x);
    gabor_vec2 thread = gabor_cpp_floor(at);
    gabor_vec2 within = at - thread - 0.5f;
    float parity = gabor_cpp_fract(0.5f * (thread.x + thread.y)) > 0.25f ? -1.0f : 1.0f;
    gabor_vec2 thick = 1.0f + 0.16f * gabor_vec2(upright.y, level.y);
    gabor_vec2 inside = 1.0f - 4.2f * within * within / (thick * thick);
    gabor_vec2 crest = thick * gabor_cpp_sqrt(gabor_cpp_max(inside, 0.0f)) - 1.0f
                 + 0.55f * parity * gabor_cpp_cos(3.1415927f * within.yx()) * gabor_vec2(1.0f, -1.0f) - gabor_vec2((inside < gabor_vec2(0.0f)));
    bool first = crest.x > crest.y;
    float top = gabor_cpp_max(gabor_cpp_max(crest.x, crest.y), -1.3f);
    gabor_vec3 tone = first ? upright : level;
    gabor_vec3 fibre = first ? upright_fibre : level_fibre;

    // The part of the weave that the filter keeps; the rest becomes the mean.
    gabor_vec2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = gabor_cpp_exp(-gabor_cpp_min(2.5f * (steps.x + steps.y), 40.0f));
    float light = gabor_cpp_mix(0.87f, gabor_cpp_smoothstep(-1.3f, 0.5f, top), kept);
    float share = gabor_cpp_mix(0.5f, first ? 1.0f : 0.0f, kept);
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.60f, 0.53f, 0.42f), gabor_vec3(0.50f, 0.43f, 0.33f), share) * gabor_cpp_mix(0.18f, 1.0f, light);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.09f) * gabor_impl_tone(fibre.y, fibre.z, 0.12f);
    return gabor_impl_material(colour, (0.3f * gabor_cpp_mix(0.146f, top, kept) + 0.035f * fibre.y) / count, 0.85f, 0.0f);
}

// Two phases and their sum belong to three waves whose crests meet: a lattice of cells, with faults.
GABOR_INLINE GaborMaterial gabor_impl_leather(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel skin = gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(0.07f), gabor_lobe_seed(seed, 0));
    skin = gabor_impl_warp(skin, gabor_vec2(4.0f), gabor_vec2(0.014f), gabor_lobe_seed(seed, 1));
    gabor_vec3 one = gabor_impl_layer(skin, gabor_vec2(4.3f), 1.6f, 0.2f, gabor_lobe_seed(seed, 2));
    gabor_vec3 other = gabor_impl_layer(skin, gabor_vec2(4.3f), 1.6f, 2.2944f, gabor_lobe_seed(seed, 3));
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
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.04f, 0.014f, 0.007f), gabor_vec3(0.20f, 0.068f, 0.026f), pebble);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.14f) * gabor_impl_tone(fine.x, fine.z, 0.08f);
    float dome = gabor_cpp_mix(0.236f, gabor_cpp_smoothstep(-1.0f, 3.0f, cells), kept);
    return gabor_impl_material(colour, 0.016f * pebble + 0.013f * dome + 0.0016f * fine.y, 0.55f - 0.15f * pebble, 0.0f);
}

// A vein is every other zero line of a noise, where its other part is high enough: long lines that end.
GABOR_INLINE float gabor_impl_vein(gabor_vec3 layer, float width, float threshold) {
    return gabor_impl_line(layer.x, layer.z, width) * gabor_impl_above(layer.y, layer.z, threshold, 0.5f);
}

GABOR_INLINE GaborMaterial gabor_impl_marble(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel stone = gabor_impl_warp(pixel, gabor_vec2(1.1f), gabor_vec2(0.17f), gabor_lobe_seed(seed, 0));
    stone = gabor_impl_warp(stone, gabor_vec2(4.0f), gabor_vec2(0.038f), gabor_lobe_seed(seed, 1));
    stone = gabor_impl_warp(stone, gabor_vec2(13.0f), gabor_vec2(0.010f), gabor_lobe_seed(seed, 2));
    stone = gabor_impl_warp(stone, gabor_vec2(40.0f), gabor_vec2(0.003f), gabor_lobe_seed(seed, 3));
    gabor_vec3 large = gabor_impl_layer(stone, gabor_vec2(0.95f), 0.85f, 0.65f, gabor_lobe_seed(seed, 4));
    gabor_vec3 middle = gabor_impl_layer(stone, gabor_vec2(1.9f), 0.95f, -0.45f, gabor_lobe_seed(seed, 5));
    gabor_vec3 thin = gabor_impl_layer(stone, gabor_vec2(4.5f), 0.95f, 0.95f, gabor_lobe_seed(seed, 6));
    gabor_vec3 hair = gabor_impl_layer(stone, gabor_vec2(13.0f), 0.9f, 0.2f, gabor_lobe_seed(seed, 7));
    gabor_vec3 cloud = gabor_impl_octaves(stone, gabor_vec2(1.5f), 3, 0.6f, gabor_lobe_seed(seed, 8));
    gabor_vec3 crystal = gabor_impl_spots(pixel, gabor_vec2(75.0f), gabor_lobe_seed(seed, 9));

    gabor_vec3 colour = gabor_vec3(0.80f, 0.79f, 0.77f) * (1.0f - 0.25f * gabor_impl_above(cloud.y, cloud.z, 0.5f, 0.8f));
    colour *= gabor_impl_tone(crystal.x, crystal.z, 0.02f);
    colour = gabor_cpp_mix(colour, gabor_vec3(0.36f, 0.37f, 0.385f), 0.6f * gabor_impl_vein(middle, 0.25f, 0.6f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.36f, 0.37f, 0.385f), 0.55f * gabor_impl_vein(large, 0.35f, -0.4f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.13f, 0.135f, 0.145f), 0.75f * gabor_impl_vein(large, 0.05f, -0.4f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.20f, 0.20f, 0.21f), 0.6f * gabor_impl_vein(middle, 0.035f, 0.4f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.32f, 0.31f, 0.30f), 0.45f * gabor_impl_vein(thin, 0.04f, 0.8f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.50f, 0.47f, 0.43f), 0.45f * gabor_impl_vein(hair, 0.05f, 1.1f));
    return gabor_impl_material(colour, 0.00012f * crystal.y, 0.2f, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_sand(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel dune = gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.15f), gabor_lobe_seed(seed, 0));
    dune = gabor_impl_warp(dune, gabor_vec2(3.0f), gabor_vec2(0.02f), gabor_lobe_seed(seed, 1));
    gabor_vec3 wind = gabor_impl_layer(dune, gabor_vec2(0.9f, 1.7f), 2.3f, 1.4f, gabor_lobe_seed(seed, 2));
    gabor_vec3 grain = gabor_impl_spots(pixel, gabor_vec2(75.0f), gabor_lobe_seed(seed, 3));
    gabor_vec3 large = gabor_impl_octaves(pixel, gabor_vec2(0.6f), 3, 0.5f, gabor_lobe_seed(seed, 4));

    float ripple = gabor_impl_rise(0.9f * gabor_impl_phase(wind));
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.43f, 0.30f, 0.17f), gabor_vec3(0.60f, 0.44f, 0.265f), ripple);
    colour *= gabor_impl_tone(grain.x, grain.z, 0.16f) * gabor_impl_tone(large.y, large.z, 0.06f);
    colour = gabor_cpp_mix(colour, gabor_vec3(0.10f, 0.075f, 0.05f), 0.6f * gabor_impl_above(grain.y, grain.z, 1.9f, 0.15f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.85f, 0.76f, 0.62f), 0.5f * gabor_impl_above(-grain.y, grain.z, 1.9f, 0.15f));
    float height = 0.055f * ripple * (1.0f + 0.2f * large.x) + 0.03f * large.x + 0.0014f * grain.x;
    return gabor_impl_material(colour, height, 0.9f, 0.0f);
}

// A sum of waves with their second harmonics, after Stokes: sharp crests, flat troughs. The harmonic of the removed
// part has mean 0.
GABOR_INLINE GaborMaterial gabor_impl_ripples(GaborPixel pixel, std::uint32_t seed) {
    float height = 0.0f;
    float crest = 0.0f;
    float removed = 0.0f;
    float power = 0.0f;
    for (int i = 0; i < 14; ++i) {
        float waves = 0.6f * gabor_cpp_exp2(0.27f * float(i)); // per unit
        float angle = 0.3f + 1.1f * gabor_cpp_fract(0.618034f * float(i) + 0.1f);
        gabor_vec3 wave = gabor_impl_layer(pixel, gabor_vec2(waves / 2.2f), 2.2f, angle, gabor_lobe_seed(seed, i));
        float amplitude = 0.018f / gabor_cpp_pow(waves, 1.3f);
        height += amplitude * (wave.x + 0.2f * (wave.x * wave.x - wave.y * wave.y));
        crest += amplitude * wave.x;
        removed += amplitude * amplitude * wave.z;
        power += amplitude * amplitude;
    }
    float light = gabor_impl_above(crest * gabor_cpp_inversesqrt(power), removed / power, 0.5f, 1.0f);
    return gabor_impl_material(gabor_cpp_mix(gabor_vec3(0.004f, 0.06f, 0.085f), gabor_vec3(0.03f, 0.25f, 0.27f), light), height, 0.1f, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_brushed_metal(GaborPixel pixel, std::uint32_t seed) {
    float height = 0.0f;
    gabor_vec2 tone = gabor_vec2(0.0f);
    for (int i = 0; i < 5; ++i) {
        float fine = gabor_cpp_exp2(float(i));
        gabor_vec3 streak = gabor_impl_spots(pixel, gabor_vec2(0.3f + 0.12f * fine, 9.0f * fine), gabor_lobe_seed(seed, i));
        height += 0.0012f / fine * streak.x;
        tone += gabor_vec2(0.4472136f, 0.2f) * streak.yz();
    }
    return gabor_impl_material(gabor_vec3(0.55f, 0.555f, 0.565f) * gabor_impl_tone(tone.x, tone.y, 0.09f), height, 0.36f, 1.0f);
}

// Needles are the peaks of noise with kernels a hundred times as long as wide, in many directions.
GABOR_INLINE GaborMaterial gabor_impl_scratches(GaborPixel pixel, std::uint32_t seed) {
    float whole = 1.0f;
    float height = 0.0f;
    for (int i = 0; i < 14; ++i) {
        float size = gabor_cpp_exp2(-0.13f * float(i));
        GaborPixel turned = gabor_impl_turned(pixel, 0.3f + 2.399963f * float(i));
        turned = gabor_impl_warp(turned, gabor_vec2(0.3f, 0.1f), gabor_vec2(0.0f, 0.17f), gabor_lobe_seed(seed, 2 * i));
        gabor_vec3 noise = gabor_impl_spots(turned, gabor_vec2(0.33f, 42.0f) / size, gabor_lobe_seed(seed, 2 * i + 1));
        float scratch = gabor_impl_above(noise.x, noise.z, 2.4f, 0.2f) * gabor_impl_above(noise.y, noise.z, 0.3f, 0.7f);
        whole *= 1.0f - (0.25f + 0.7f * size) * scratch;
        height -= 0.0025f * size * scratch;
    }
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.60f, 0.61f, 0.62f), gabor_vec3(0.035f, 0.042f, 0.05f), whole);
    return gabor_impl_material(colour, height, 0.3f, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_zebra(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel skin = gabor_impl_warp(pixel, gabor_vec2(0.9f), gabor_vec2(0.14f), gabor_lobe_seed(seed, 0));
    float lean = gabor_field(gabor_place(gabor_ivec2(0), 0.6f * GABOR_RADIUS * pixel.p), gabor_kernel(0.0f, 0.0f),
                             gabor_lobe_seed(seed, 1)).value.x;
    gabor_vec3 stripe = gabor_impl_layer(skin, gabor_vec2(1.4f), 1.4f, 0.3f + 0.35f * lean, gabor_lobe_seed(seed, 2));
    gabor_vec3 hair = gabor_impl_spots(gabor_impl_turned(skin, 0.5f), gabor_vec2(80.0f, 6.0f), gabor_lobe_seed(seed, 3));
    gabor_vec3 tone = gabor_impl_spots(pixel, gabor_vec2(1.2f), gabor_lobe_seed(seed, 4));

    float intensity = gabor_cpp_length(stripe.xy()); // at the zeros of stripe.x, the smaller its slope, the wider the edge
    float dark = gabor_impl_above(stripe.x + 0.1f * intensity * hair.x, stripe.z + 0.01f * hair.z, 0.0f,
                                  0.01f + 0.09f * intensity);
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.70f, 0.64f, 0.54f), gabor_vec3(0.018f, 0.014f, 0.012f), dark);
    colour *= gabor_impl_tone(hair.y, hair.z, 0.14f) * gabor_impl_tone(tone.y, tone.z, 0.08f);
    return gabor_impl_material(colour, 0.002f * hair.x, 0.7f, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_bark(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel trunk = gabor_impl_warp(pixel, gabor_vec2(0.8f, 0.35f), gabor_vec2(0.22f, 0.1f), gabor_lobe_seed(seed, 0));
    trunk = gabor_impl_warp(trunk, gabor_vec2(3.0f, 1.6f), gabor_vec2(0.05f, 0.05f), gabor_lobe_seed(seed, 1));
    trunk = gabor_impl_warp(trunk, gabor_vec2(10.0f), gabor_vec2(0.013f), gabor_lobe_seed(seed, 2));
    gabor_vec3 furrow = gabor_impl_layer(trunk, gabor_vec2(1.7f, 0.55f), 1.3f, 0.1f, gabor_lobe_seed(seed, 3));
    gabor_vec3 crack = gabor_impl_layer(trunk, gabor_vec2(1.2f, 1.3f), 0.9f, 1.5f, gabor_lobe_seed(seed, 4));
    gabor_vec3 rough = gabor_impl_octaves(trunk, gabor_vec2(7.0f, 3.0f), 5, 0.75f, gabor_lobe_seed(seed, 5));
    gabor_vec3 moss = gabor_impl_spots(pixel, gabor_vec2(1.1f, 0.7f), gabor_lobe_seed(seed, 6));

    float plate = gabor_impl_above(furrow.x + 0.2f * rough.x, furrow.z + 0.04f * rough.z, -0.15f, 0.35f)
                  * (1.0f - 0.55f * gabor_impl_line(crack.x, crack.z, 0.13f));
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.025f, 0.014f, 0.008f), gabor_vec3(0.20f, 0.145f, 0.10f), plate);
    colour *= gabor_impl_tone(rough.y, rough.z, 0.25f);
    colour = gabor_cpp_mix(colour, gabor_vec3(0.30f, 0.27f, 0.225f), 0.5f * plate * gabor_impl_above(rough.x, rough.z, 0.5f, 0.4f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.10f, 0.13f, 0.045f),
                 0.35f * gabor_impl_above(moss.y, moss.z, 0.9f, 0.5f) * (1.0f - 0.4f * plate));
    float height = 0.13f * plate + 0.018f * rough.x * (0.4f + 0.6f * plate);
    return gabor_impl_material(colour, height, 0.9f, 0.0f);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
GABOR_INLINE GaborMaterial gabor_impl_carbon_fibre(GaborPixel pixel, std::uint32_t seed) {
    const float count = 4.0f; // tows per unit
    GaborPixel cloth = gabor_impl_warp(pixel, gabor_vec2(0.8f), gabor_vec2(0.008f), gabor_lobe_seed(seed, 0));
    gabor_vec3 upright = gabor_impl_spots(cloth, gabor_vec2(20.0f, 0.6f) * count, gabor_lobe_seed(seed, 1));
    gabor_vec3 level = gabor_impl_spots(cloth, gabor_vec2(0.6f, 20.0f) * count, gabor_lobe_seed(seed, 2));
    gabor_vec2 tow = gabor_cpp_floor(count * cloth.p);
    gabor_vec2 within = count * cloth.p - tow;
    float turn = 4.0f * gabor_cpp_fract(0.25f * (tow.x + tow.y) + 0.125f) - 0.5f; // 0 to 3
    bool first = turn < 1.5f;
    gabor_vec3 fibre = first ? upright : level;
    gabor_vec2 along_across = first ? within.yx() : within;
    float along = 0.5f * (along_across.x + (gabor_cpp_fract(0.5f * turn + 0.25f) < 0.5f ? 0.0f : 1.0f)); // across two rows
    float across = 2.0f * along_across.y - 1.0f;

    gabor_vec2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = gabor_cpp_exp(-gabor_cpp_min(2.5f * (steps.x + steps.y), 40.0f));
    float bulge = gabor_cpp_mix(0.51f, gabor_cpp_sin(3.1415927f * along) * (1.0f - across * across * across * across), kept);
    gabor_vec3 colour = gabor_vec3(0.028f, 0.029f, 0.031f) * (0.35f + 0.65f * bulge) * gabor_impl_tone(fibre.x, fibre.z, 0.3f);
    return gabor_impl_material(colour, (0.16f * bulge + 0.006f * fibre.x) / count, 0.3f, 0.0f);
}

GABOR_INLINE GaborMaterial gabor_impl_strata(GaborPixel pixel, std::uint32_t seed) {
    GaborPixel rock = gabor_impl_warp(pixel, gabor_vec2(0.35f, 0.6f), gabor_vec2(0.0f, 0.2f), gabor_lobe_seed(seed, 0));
    rock = gabor_impl_warp(rock, gabor_vec2(1.6f, 2.6f), gabor_vec2(0.016f, 0.022f), gabor_lobe_seed(seed, 1));
    rock = gabor_impl_warp(rock, gabor_vec2(7.0f, 10.0f), gabor_vec2(0.004f), gabor_lobe_seed(seed, 2));
    gabor_vec3 broad = gabor_impl_spots(rock, gabor_vec2(0.1f, 2.0f), gabor_lobe_seed(seed, 3));
    gabor_vec3 band = gabor_impl_spots(rock, gabor_vec2(0.14f, 6.0f), gabor_lobe_seed(seed, 4));
    gabor_vec3 thin = gabor_impl_spots(rock, gabor_vec2(0.25f, 17.0f), gabor_lobe_seed(seed, 5));
    gabor_vec3 lamina = gabor_impl_spots(rock, gabor_vec2(0.6f, 50.0f), gabor_lobe_seed(seed, 6));
    gabor_vec3 grain = gabor_impl_octaves(pixel, gabor_vec2(16.0f, 24.0f), 4, 0.8f, gabor_lobe_seed(seed, 7));

    float soft = gabor_impl_above(band.x, band.z, 0.5f, 0.22f); // red and washed-out layers
    gabor_vec3 colour = gabor_cpp_mix(gabor_vec3(0.50f, 0.22f, 0.09f), gabor_vec3(0.60f, 0.35f, 0.18f), gabor_impl_above(broad.x, broad.z, 0.0f, 0.5f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.28f, 0.075f, 0.035f), 0.8f * soft);
    colour = gabor_cpp_mix(colour, gabor_vec3(0.74f, 0.58f, 0.40f), 0.75f * gabor_impl_above(thin.x, thin.z, 1.0f, 0.2f));
    colour = gabor_cpp_mix(colour, gabor_vec3(0.20f, 0.06f, 0.035f), 0.6f * gabor_impl_above(thin.y, thin.z, 1.3f, 0.15f));
    colour *= gabor_impl_tone(lamina.x, lamina.z, 0.13f) * gabor_impl_tone(grain.x, grain.z, 0.11f);
    float height = 0.02f * broad.y - 0.012f * soft + 0.006f * thin.x + 0.0015f * lamina.x + 0.003f * grain.y;
    return gabor_impl_material(colour, height, 0.9f, 0.0f);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GABOR_INLINE GaborMaterial gabor_wood(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_wood(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_fabric(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_fabric(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_leather(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_leather(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_marble(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_marble(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_sand(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_sand(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_ripples(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_ripples(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_brushed_metal(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_scratches(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_scratches(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_zebra(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_zebra(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_bark(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_bark(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_carbon_fibre(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_strata(gabor_vec2 p, std::uint32_t seed) {
    return gabor_impl_strata(GaborPixel{p, gabor_vec2(0.0f), gabor_vec2(0.0f), false}, seed);
}

GABOR_INLINE GaborMaterial gabor_wood_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_wood(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_fabric_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_fabric(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_leather_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_leather(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_marble_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_marble(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_sand_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_sand(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_ripples_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_ripples(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_brushed_metal_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_brushed_metal(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_scratches_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_scratches(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_zebra_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_zebra(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_bark_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_bark(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_carbon_fibre_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_carbon_fibre(GaborPixel{p, dx, dy, true}, seed);
}

GABOR_INLINE GaborMaterial gabor_strata_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    return gabor_impl_strata(GaborPixel{p, dx, dy, true}, seed);
}

#endif // GABOR_MATERIALS_HPP
