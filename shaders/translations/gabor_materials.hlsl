// gabor_materials.hlsl: twelve materials from Gabor noise: for HLSL, shader model 5.0 and up.
//
// Generated from shaders/gabor_materials.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hlsl. Paste or include it after gabor_spectrum.hlsl.
//
//     GaborMaterial m = gabor_wood(p, 7u);                             // colour, height, roughness, metalness
//     GaborMaterial f = gabor_wood_filtered(p, dFdx(p), dFdy(p), 7u);  // averaged over a pixel
//
// One unit of p shows a characteristic piece of a material; four by four units make a good picture.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_SPECTRUM_HLSL
#error Include gabor_lattice.hlsl and gabor_spectrum.hlsl before gabor_materials.hlsl
#endif
#if GABOR_TAPS != 3
#error gabor_materials.hlsl needs GABOR_TAPS 3
#endif
#ifndef GABOR_MATERIALS_HLSL
#define GABOR_MATERIALS_HLSL

struct GaborMaterial {
    float3 colour;     // base colour of physically based shading: linear, Rec. 709 primaries, within [0, 1]
    float height;    // in units of p
    float roughness; // as in glTF
    float metalness; // 0 or 1
};

GaborMaterial GaborMaterial_of(float3 colour, float height, float roughness, float metalness)
{
    GaborMaterial made;
    made.colour = colour;
    made.height = height;
    made.roughness = roughness;
    made.metalness = metalness;
    return made;
}

// The material at p; the number of noises that it evaluates is in brackets.
// GaborMaterial gabor_wood(float2 p, uint seed)             a board: year rings cut lengthwise, pores, fibres [6]
// GaborMaterial gabor_fabric(float2 p, uint seed)           linen: a plain weave of uneven threads [5]
// GaborMaterial gabor_leather(float2 p, uint seed)          pebbled grain: cells between creases [8]
// GaborMaterial gabor_marble(float2 p, uint seed)           white, with veins of four sizes [12]
// GaborMaterial gabor_sand(float2 p, uint seed)             wind ripples, steep on one side, and grains [7]
// GaborMaterial gabor_ripples(float2 p, uint seed)          water under a light wind [14]
// GaborMaterial gabor_brushed_metal(float2 p, uint seed)    streaks along x [5]
// GaborMaterial gabor_scratches(float2 p, uint seed)        hairlines in a dark lacquer [28]
// GaborMaterial gabor_zebra(float2 p, uint seed)            stripes that fork, and hair [5]
// GaborMaterial gabor_bark(float2 p, uint seed)             furrows and plates, moss [11]
// GaborMaterial gabor_carbon_fibre(float2 p, uint seed)     a twill of black tows [3]
// GaborMaterial gabor_strata(float2 p, uint seed)           layers of sandstone, seen from the side [11]

// The same averaged over a pixel. dx and dy are dFdx(p) and dFdy(p): the change of p from one pixel to the next. Noises
// that only displace the pattern cost as much as unfiltered, all others as much as gabor_noise_filtered.
// GaborMaterial gabor_wood_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_fabric_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_leather_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_marble_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_sand_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_ripples_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_brushed_metal_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_scratches_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_zebra_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_bark_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_carbon_fibre_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborMaterial gabor_strata_filtered(float2 p, float2 dx, float2 dy, uint seed)

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
    float2 p;
    float2 dx;
    float2 dy;
    bool filtered;
};

GaborPixel GaborPixel_of(float2 p, float2 dx, float2 dy, bool filtered)
{
    GaborPixel made;
    made.p = p;
    made.dx = dx;
    made.dy = dy;
    made.filtered = filtered;
    return made;
}

// Two independent noises, the parts of a complex one, and the removed share of their variance.
//   density  kernels per unit along x and y
float3 gabor_impl_layer(GaborPixel pixel, float2 density, float frequency, float orientation, uint seed) {
    GaborPlace place = gabor_place((int2)(0), GABOR_RADIUS * density * pixel.p);
    GaborKernel kernel_ = gabor_kernel(frequency, orientation);
    if (!pixel.filtered)
        return float3(gabor_field(place, kernel_, seed).value, 0.0);
    float removed;
    GaborFootprint footprint = gabor_footprint(density * pixel.dx, density * pixel.dy);
    float2 value = gabor_field_filtered(place, kernel_, footprint, seed, removed).value;
    return float3(value, removed);
}

// The same at frequency 0: spots as large as a kernel.
float3 gabor_impl_spots(GaborPixel pixel, float2 density, uint seed) {
    return gabor_impl_layer(pixel, density, 0.0, 0.0, seed);
}

// A sum of spots, each octave half as large with `gain` times the amplitude.
float3 gabor_impl_octaves(GaborPixel pixel, float2 density, int count, float gain, uint seed) {
    float3 sum = (float3)(0.0);
    float power = 0.0;
    float amplitude = 1.0;
    for (int i = 0; i < count; ++i) {
        sum += float3(amplitude, amplitude, amplitude * amplitude)
               * gabor_impl_spots(pixel, density, gabor_lobe_seed(seed, i));
        power += amplitude * amplitude;
        amplitude *= gain;
        density *= 2.03;
    }
    return sum / float3((float2)(sqrt(power)), power);
}

// Moves the place by two noises, and its steps accordingly.
GaborPixel gabor_impl_warp(GaborPixel pixel, float2 density, float2 amplitude, uint seed) {
    GaborPlace place = gabor_place((int2)(0), GABOR_RADIUS * density * pixel.p);
    GaborField field = gabor_field(place, gabor_kernel(0.0, 0.0), seed);
    float2 along_x = amplitude * density.x * field.slope_x;
    float2 along_y = amplitude * density.y * field.slope_y;
    return GaborPixel_of(pixel.p + amplitude * field.value, pixel.dx + pixel.dx.x * along_x + pixel.dx.y * along_y,
                      pixel.dy + pixel.dy.x * along_x + pixel.dy.y * along_y, pixel.filtered);
}

// Turns the axes by an angle.
GaborPixel gabor_impl_turned(GaborPixel pixel, float angle) {
    float2 turn = gabor_impl_wave(-0.15915494 * angle);
    return GaborPixel_of(gabor_impl_product(turn, pixel.p), gabor_impl_product(turn, pixel.dx),
                      gabor_impl_product(turn, pixel.dy), pixel.filtered);
}

// ---- Functions of noise, and their means over the removed part -----------------------------------------------------

// Where the noise is above a threshold: the normal distribution function of (noise - threshold) / softness, within
// 1.5e-4 (Bowling et al., "A logistic approximation to the cumulative normal distribution", 2009).
float gabor_impl_above(float noise, float removed, float threshold, float softness) {
    float x = clamp((noise - threshold) * rsqrt(softness * softness + removed), -8.0, 8.0);
    return 1.0 / (1.0 + exp(-x * (1.5976 + 0.07056 * x * x)));
}

// A line along the zeros of the noise: exp(-noise^2 / (2 width^2)).
float gabor_impl_line(float noise, float removed, float width) {
    float variance = width * width + removed;
    return width * rsqrt(variance) * exp(-0.5 * noise * noise / variance);
}

// A factor of mean 1: exp(contrast noise - contrast^2 / 2).
float gabor_impl_tone(float noise, float removed, float contrast) {
    return exp(contrast * (noise - 0.5 * contrast * (1.0 - removed)));
}

// The unit vector of a complex noise's phase; shorter where it is a mean.
float2 gabor_impl_phase(float3 layer) {
    return layer.xy * rsqrt(dot(layer.xy, layer.xy) + 2.5 * layer.z + 1.0e-6);
}

// The same for a phase that grows evenly: the wave after a normal filter.
float2 gabor_impl_turns(float turns, float dx, float dy) {
    return exp(-min(4.9348022 * (dx * dx + dy * dy), 40.0)) * gabor_impl_wave(turns);
}

// The square of a sawtooth from 0 to 1, with mean 1/3: t^2 = t - 4 t (1 - t) / 4.
float gabor_impl_rise(float2 stripes) {
    return gabor_stripes_sawtooth(stripes) - 0.25 * gabor_stripes_ridges(stripes);
}

// Clamps the colour to [0, 1], which a product of tones can exceed.
GaborMaterial gabor_impl_material(float3 colour, float height, float roughness, float metalness) {
    return GaborMaterial_of(clamp(colour, 0.0, 1.0), height, roughness, metalness);
}

// ---- Materials -----------------------------------------------------------------------------------------------------

// Rings are lines of equal x that slow noise bends until they close: a board cut beside the pith.
GaborMaterial gabor_impl_wood(GaborPixel pixel, uint seed) {
    GaborPixel board = gabor_impl_warp(pixel, float2(1.1, 0.24), float2(0.43, 0.0), gabor_lobe_seed(seed, 0));
    board = gabor_impl_warp(board, float2(4.0, 0.9), float2(0.018, 0.0), gabor_lobe_seed(seed, 1));
    GaborPixel years = gabor_impl_warp(board, float2(6.5, 0.08), float2(0.035, 0.0), gabor_lobe_seed(seed, 2));
    float ring = gabor_impl_rise(0.97 * gabor_impl_turns(13.0 * years.p.x, 13.0 * years.dx.x, 13.0 * years.dy.x));
    float3 pore = gabor_impl_spots(pixel, float2(90.0, 4.5), gabor_lobe_seed(seed, 3));
    float3 fibre = gabor_impl_spots(pixel, float2(150.0, 2.0), gabor_lobe_seed(seed, 4));
    float3 tone = gabor_impl_spots(board, float2(3.5, 0.35), gabor_lobe_seed(seed, 5));

    float pores = (1.0 - 0.75 * ring) * gabor_impl_above(pore.y, pore.z, 1.1, 0.25);
    float3 colour = lerp(float3(0.50, 0.275, 0.115), float3(0.20, 0.078, 0.027), ring);
    colour *= gabor_impl_tone(fibre.y, fibre.z, 0.11) * gabor_impl_tone(tone.y, tone.z, 0.13);
    colour = lerp(colour, float3(0.09, 0.035, 0.014), 0.75 * pores);
    float height = 0.0006 * ring - 0.0018 * pores + 0.0002 * fibre.y;
    return gabor_impl_material(colour, height, 0.5 - 0.1 * ring, 0.0);
}

GaborMaterial gabor_impl_fabric(GaborPixel pixel, uint seed) {
    const float count = 12.0; // threads per unit
    GaborPixel cloth = gabor_impl_warp(pixel, (float2)(0.7), (float2)(0.02), gabor_lobe_seed(seed, 0));
    float3 upright = gabor_impl_spots(cloth, float2(0.7 * count, 1.1), gabor_lobe_seed(seed, 1)); // uneven along y
    float3 level = gabor_impl_spots(cloth, float2(1.1, 0.7 * count), gabor_lobe_seed(seed, 2));
    float3 upright_fibre = gabor_impl_spots(cloth, float2(14.0, 2.0) * count, gabor_lobe_seed(seed, 3));
    float3 level_fibre = gabor_impl_spots(cloth, float2(2.0, 14.0) * count, gabor_lobe_seed(seed, 4));

    // A thread has a round profile, and goes over one crossing thread and under the next.
    float2 at = count * cloth.p + 0.13 * float2(upright.x, level.x);
    float2 thread_ = floor(at);
    float2 within = at - thread_ - 0.5;
    float parity = frac(0.5 * (thread_.x + thread_.y)) > 0.25 ? -1.0 : 1.0;
    float2 thick = 1.0 + 0.16 * float2(upright.y, level.y);
    float2 inside = 1.0 - 4.2 * within * within / (thick * thick);
    float2 crest = thick * sqrt(max(inside, 0.0)) - 1.0
                 + 0.55 * parity * cos(3.1415927 * within.yx) * float2(1.0, -1.0) - (float2)((inside < (float2)(0.0)));
    bool first = crest.x > crest.y;
    float top = max(max(crest.x, crest.y), -1.3);
    float3 tone = first ? upright : level;
    float3 fibre = first ? upright_fibre : level_fibre;

    // The part of the weave that the filter keeps; the rest becomes the mean.
    float2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = exp(-min(2.5 * (steps.x + steps.y), 40.0));
    float light = lerp(0.87, smoothstep(-1.3, 0.5, top), kept);
    float share = lerp(0.5, first ? 1.0 : 0.0, kept);
    float3 colour = lerp(float3(0.60, 0.53, 0.42), float3(0.50, 0.43, 0.33), share) * lerp(0.18, 1.0, light);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.09) * gabor_impl_tone(fibre.y, fibre.z, 0.12);
    return gabor_impl_material(colour, (0.3 * lerp(0.146, top, kept) + 0.035 * fibre.y) / count, 0.85, 0.0);
}

// Two phases and their sum belong to three waves whose crests meet: a lattice of cells, with faults.
GaborMaterial gabor_impl_leather(GaborPixel pixel, uint seed) {
    GaborPixel skin = gabor_impl_warp(pixel, (float2)(0.9), (float2)(0.07), gabor_lobe_seed(seed, 0));
    skin = gabor_impl_warp(skin, (float2)(4.0), (float2)(0.014), gabor_lobe_seed(seed, 1));
    float3 one = gabor_impl_layer(skin, (float2)(4.3), 1.6, 0.2, gabor_lobe_seed(seed, 2));
    float3 other = gabor_impl_layer(skin, (float2)(4.3), 1.6, 2.2944, gabor_lobe_seed(seed, 3));
    float3 fine = gabor_impl_octaves(pixel, (float2)(18.0), 3, 0.75, gabor_lobe_seed(seed, 4));
    float3 tone = gabor_impl_spots(pixel, (float2)(0.8), gabor_lobe_seed(seed, 5));

    float2 powers = float2(dot(one.xy, one.xy), dot(other.xy, other.xy));
    float2 a = one.xy * rsqrt(powers.x + 0.12);
    float2 b = other.xy * rsqrt(powers.y + 0.12);
    float cells = a.x + b.x + gabor_impl_product(a, b).x; // 3 in the middle of a cell, -1.5 in a corner
    float2 shares = powers / (powers + 2.5 * float2(one.z, other.z));
    float kept = sqrt(shares.x * shares.y);
    float blur = 1.0 - kept;
    float pebble = lerp(0.806, smoothstep(-1.45 - blur, -0.55 + blur, cells + 0.1 * fine.y), kept);
    float3 colour = lerp(float3(0.04, 0.014, 0.007), float3(0.20, 0.068, 0.026), pebble);
    colour *= gabor_impl_tone(tone.y, tone.z, 0.14) * gabor_impl_tone(fine.x, fine.z, 0.08);
    float dome = lerp(0.236, smoothstep(-1.0, 3.0, cells), kept);
    return gabor_impl_material(colour, 0.016 * pebble + 0.013 * dome + 0.0016 * fine.y, 0.55 - 0.15 * pebble, 0.0);
}

// A vein is every other zero line of a noise, where its other part is high enough: long lines that end.
float gabor_impl_vein(float3 layer, float width, float threshold) {
    return gabor_impl_line(layer.x, layer.z, width) * gabor_impl_above(layer.y, layer.z, threshold, 0.5);
}

GaborMaterial gabor_impl_marble(GaborPixel pixel, uint seed) {
    GaborPixel stone = gabor_impl_warp(pixel, (float2)(1.1), (float2)(0.17), gabor_lobe_seed(seed, 0));
    stone = gabor_impl_warp(stone, (float2)(4.0), (float2)(0.038), gabor_lobe_seed(seed, 1));
    stone = gabor_impl_warp(stone, (float2)(13.0), (float2)(0.010), gabor_lobe_seed(seed, 2));
    stone = gabor_impl_warp(stone, (float2)(40.0), (float2)(0.003), gabor_lobe_seed(seed, 3));
    float3 large = gabor_impl_layer(stone, (float2)(0.95), 0.85, 0.65, gabor_lobe_seed(seed, 4));
    float3 middle = gabor_impl_layer(stone, (float2)(1.9), 0.95, -0.45, gabor_lobe_seed(seed, 5));
    float3 thin = gabor_impl_layer(stone, (float2)(4.5), 0.95, 0.95, gabor_lobe_seed(seed, 6));
    float3 hair = gabor_impl_layer(stone, (float2)(13.0), 0.9, 0.2, gabor_lobe_seed(seed, 7));
    float3 cloud = gabor_impl_octaves(stone, (float2)(1.5), 3, 0.6, gabor_lobe_seed(seed, 8));
    float3 crystal = gabor_impl_spots(pixel, (float2)(75.0), gabor_lobe_seed(seed, 9));

    float3 colour = float3(0.80, 0.79, 0.77) * (1.0 - 0.25 * gabor_impl_above(cloud.y, cloud.z, 0.5, 0.8));
    colour *= gabor_impl_tone(crystal.x, crystal.z, 0.02);
    colour = lerp(colour, float3(0.36, 0.37, 0.385), 0.6 * gabor_impl_vein(middle, 0.25, 0.6));
    colour = lerp(colour, float3(0.36, 0.37, 0.385), 0.55 * gabor_impl_vein(large, 0.35, -0.4));
    colour = lerp(colour, float3(0.13, 0.135, 0.145), 0.75 * gabor_impl_vein(large, 0.05, -0.4));
    colour = lerp(colour, float3(0.20, 0.20, 0.21), 0.6 * gabor_impl_vein(middle, 0.035, 0.4));
    colour = lerp(colour, float3(0.32, 0.31, 0.30), 0.45 * gabor_impl_vein(thin, 0.04, 0.8));
    colour = lerp(colour, float3(0.50, 0.47, 0.43), 0.45 * gabor_impl_vein(hair, 0.05, 1.1));
    return gabor_impl_material(colour, 0.00012 * crystal.y, 0.2, 0.0);
}

GaborMaterial gabor_impl_sand(GaborPixel pixel, uint seed) {
    GaborPixel dune = gabor_impl_warp(pixel, (float2)(0.8), (float2)(0.15), gabor_lobe_seed(seed, 0));
    dune = gabor_impl_warp(dune, (float2)(3.0), (float2)(0.02), gabor_lobe_seed(seed, 1));
    float3 wind = gabor_impl_layer(dune, float2(0.9, 1.7), 2.3, 1.4, gabor_lobe_seed(seed, 2));
    float3 grain = gabor_impl_spots(pixel, (float2)(75.0), gabor_lobe_seed(seed, 3));
    float3 large = gabor_impl_octaves(pixel, (float2)(0.6), 3, 0.5, gabor_lobe_seed(seed, 4));

    float ripple = gabor_impl_rise(0.9 * gabor_impl_phase(wind));
    float3 colour = lerp(float3(0.43, 0.30, 0.17), float3(0.60, 0.44, 0.265), ripple);
    colour *= gabor_impl_tone(grain.x, grain.z, 0.16) * gabor_impl_tone(large.y, large.z, 0.06);
    colour = lerp(colour, float3(0.10, 0.075, 0.05), 0.6 * gabor_impl_above(grain.y, grain.z, 1.9, 0.15));
    colour = lerp(colour, float3(0.85, 0.76, 0.62), 0.5 * gabor_impl_above(-grain.y, grain.z, 1.9, 0.15));
    float height = 0.055 * ripple * (1.0 + 0.2 * large.x) + 0.03 * large.x + 0.0014 * grain.x;
    return gabor_impl_material(colour, height, 0.9, 0.0);
}

// A sum of waves with their second harmonics, after Stokes: sharp crests, flat troughs. The harmonic of the removed
// part has mean 0.
GaborMaterial gabor_impl_ripples(GaborPixel pixel, uint seed) {
    float height = 0.0;
    float crest = 0.0;
    float removed = 0.0;
    float power = 0.0;
    for (int i = 0; i < 14; ++i) {
        float waves = 0.6 * exp2(0.27 * float(i)); // per unit
        float angle = 0.3 + 1.1 * frac(0.618034 * float(i) + 0.1);
        float3 wave = gabor_impl_layer(pixel, (float2)(waves / 2.2), 2.2, angle, gabor_lobe_seed(seed, i));
        float amplitude = 0.018 / pow(waves, 1.3);
        height += amplitude * (wave.x + 0.2 * (wave.x * wave.x - wave.y * wave.y));
        crest += amplitude * wave.x;
        removed += amplitude * amplitude * wave.z;
        power += amplitude * amplitude;
    }
    float light = gabor_impl_above(crest * rsqrt(power), removed / power, 0.5, 1.0);
    return gabor_impl_material(lerp(float3(0.004, 0.06, 0.085), float3(0.03, 0.25, 0.27), light), height, 0.1, 0.0);
}

GaborMaterial gabor_impl_brushed_metal(GaborPixel pixel, uint seed) {
    float height = 0.0;
    float2 tone = (float2)(0.0);
    for (int i = 0; i < 5; ++i) {
        float fine = exp2(float(i));
        float3 streak = gabor_impl_spots(pixel, float2(0.3 + 0.12 * fine, 9.0 * fine), gabor_lobe_seed(seed, i));
        height += 0.0012 / fine * streak.x;
        tone += float2(0.4472136, 0.2) * streak.yz;
    }
    return gabor_impl_material(float3(0.55, 0.555, 0.565) * gabor_impl_tone(tone.x, tone.y, 0.09), height, 0.36, 1.0);
}

// Needles are the peaks of noise with kernels a hundred times as long as wide, in many directions.
GaborMaterial gabor_impl_scratches(GaborPixel pixel, uint seed) {
    float whole = 1.0;
    float height = 0.0;
    for (int i = 0; i < 14; ++i) {
        float size = exp2(-0.13 * float(i));
        GaborPixel turned = gabor_impl_turned(pixel, 0.3 + 2.399963 * float(i));
        turned = gabor_impl_warp(turned, float2(0.3, 0.1), float2(0.0, 0.17), gabor_lobe_seed(seed, 2 * i));
        float3 noise = gabor_impl_spots(turned, float2(0.33, 42.0) / size, gabor_lobe_seed(seed, 2 * i + 1));
        float scratch = gabor_impl_above(noise.x, noise.z, 2.4, 0.2) * gabor_impl_above(noise.y, noise.z, 0.3, 0.7);
        whole *= 1.0 - (0.25 + 0.7 * size) * scratch;
        height -= 0.0025 * size * scratch;
    }
    float3 colour = lerp(float3(0.60, 0.61, 0.62), float3(0.035, 0.042, 0.05), whole);
    return gabor_impl_material(colour, height, 0.3, 0.0);
}

GaborMaterial gabor_impl_zebra(GaborPixel pixel, uint seed) {
    GaborPixel skin = gabor_impl_warp(pixel, (float2)(0.9), (float2)(0.14), gabor_lobe_seed(seed, 0));
    float lean = gabor_field(gabor_place((int2)(0), 0.6 * GABOR_RADIUS * pixel.p), gabor_kernel(0.0, 0.0),
                             gabor_lobe_seed(seed, 1)).value.x;
    float3 stripe = gabor_impl_layer(skin, (float2)(1.4), 1.4, 0.3 + 0.35 * lean, gabor_lobe_seed(seed, 2));
    float3 hair = gabor_impl_spots(gabor_impl_turned(skin, 0.5), float2(80.0, 6.0), gabor_lobe_seed(seed, 3));
    float3 tone = gabor_impl_spots(pixel, (float2)(1.2), gabor_lobe_seed(seed, 4));

    float intensity = length(stripe.xy); // at the zeros of stripe.x, the smaller its slope, the wider the edge
    float dark = gabor_impl_above(stripe.x + 0.1 * intensity * hair.x, stripe.z + 0.01 * hair.z, 0.0,
                                  0.01 + 0.09 * intensity);
    float3 colour = lerp(float3(0.70, 0.64, 0.54), float3(0.018, 0.014, 0.012), dark);
    colour *= gabor_impl_tone(hair.y, hair.z, 0.14) * gabor_impl_tone(tone.y, tone.z, 0.08);
    return gabor_impl_material(colour, 0.002 * hair.x, 0.7, 0.0);
}

GaborMaterial gabor_impl_bark(GaborPixel pixel, uint seed) {
    GaborPixel trunk = gabor_impl_warp(pixel, float2(0.8, 0.35), float2(0.22, 0.1), gabor_lobe_seed(seed, 0));
    trunk = gabor_impl_warp(trunk, float2(3.0, 1.6), float2(0.05, 0.05), gabor_lobe_seed(seed, 1));
    trunk = gabor_impl_warp(trunk, (float2)(10.0), (float2)(0.013), gabor_lobe_seed(seed, 2));
    float3 furrow = gabor_impl_layer(trunk, float2(1.7, 0.55), 1.3, 0.1, gabor_lobe_seed(seed, 3));
    float3 crack = gabor_impl_layer(trunk, float2(1.2, 1.3), 0.9, 1.5, gabor_lobe_seed(seed, 4));
    float3 rough = gabor_impl_octaves(trunk, float2(7.0, 3.0), 5, 0.75, gabor_lobe_seed(seed, 5));
    float3 moss = gabor_impl_spots(pixel, float2(1.1, 0.7), gabor_lobe_seed(seed, 6));

    float plate = gabor_impl_above(furrow.x + 0.2 * rough.x, furrow.z + 0.04 * rough.z, -0.15, 0.35)
                  * (1.0 - 0.55 * gabor_impl_line(crack.x, crack.z, 0.13));
    float3 colour = lerp(float3(0.025, 0.014, 0.008), float3(0.20, 0.145, 0.10), plate);
    colour *= gabor_impl_tone(rough.y, rough.z, 0.25);
    colour = lerp(colour, float3(0.30, 0.27, 0.225), 0.5 * plate * gabor_impl_above(rough.x, rough.z, 0.5, 0.4));
    colour = lerp(colour, float3(0.10, 0.13, 0.045),
                 0.35 * gabor_impl_above(moss.y, moss.z, 0.9, 0.5) * (1.0 - 0.4 * plate));
    float height = 0.13 * plate + 0.018 * rough.x * (0.4 + 0.6 * plate);
    return gabor_impl_material(colour, height, 0.9, 0.0);
}

// A 2/2 twill: each tow goes over two and under two, and each row is shifted by one.
GaborMaterial gabor_impl_carbon_fibre(GaborPixel pixel, uint seed) {
    const float count = 4.0; // tows per unit
    GaborPixel cloth = gabor_impl_warp(pixel, (float2)(0.8), (float2)(0.008), gabor_lobe_seed(seed, 0));
    float3 upright = gabor_impl_spots(cloth, float2(20.0, 0.6) * count, gabor_lobe_seed(seed, 1));
    float3 level = gabor_impl_spots(cloth, float2(0.6, 20.0) * count, gabor_lobe_seed(seed, 2));
    float2 tow = floor(count * cloth.p);
    float2 within = count * cloth.p - tow;
    float turn = 4.0 * frac(0.25 * (tow.x + tow.y) + 0.125) - 0.5; // 0 to 3
    bool first = turn < 1.5;
    float3 fibre = first ? upright : level;
    float2 along_across = first ? within.yx : within;
    float along = 0.5 * (along_across.x + (frac(0.5 * turn + 0.25) < 0.5 ? 0.0 : 1.0)); // across two rows
    float across = 2.0 * along_across.y - 1.0;

    float2 steps = count * count * (cloth.dx * cloth.dx + cloth.dy * cloth.dy);
    float kept = exp(-min(2.5 * (steps.x + steps.y), 40.0));
    float bulge = lerp(0.51, sin(3.1415927 * along) * (1.0 - across * across * across * across), kept);
    float3 colour = float3(0.028, 0.029, 0.031) * (0.35 + 0.65 * bulge) * gabor_impl_tone(fibre.x, fibre.z, 0.3);
    return gabor_impl_material(colour, (0.16 * bulge + 0.006 * fibre.x) / count, 0.3, 0.0);
}

GaborMaterial gabor_impl_strata(GaborPixel pixel, uint seed) {
    GaborPixel rock = gabor_impl_warp(pixel, float2(0.35, 0.6), float2(0.0, 0.2), gabor_lobe_seed(seed, 0));
    rock = gabor_impl_warp(rock, float2(1.6, 2.6), float2(0.016, 0.022), gabor_lobe_seed(seed, 1));
    rock = gabor_impl_warp(rock, float2(7.0, 10.0), (float2)(0.004), gabor_lobe_seed(seed, 2));
    float3 broad = gabor_impl_spots(rock, float2(0.1, 2.0), gabor_lobe_seed(seed, 3));
    float3 band = gabor_impl_spots(rock, float2(0.14, 6.0), gabor_lobe_seed(seed, 4));
    float3 thin = gabor_impl_spots(rock, float2(0.25, 17.0), gabor_lobe_seed(seed, 5));
    float3 lamina = gabor_impl_spots(rock, float2(0.6, 50.0), gabor_lobe_seed(seed, 6));
    float3 grain = gabor_impl_octaves(pixel, float2(16.0, 24.0), 4, 0.8, gabor_lobe_seed(seed, 7));

    float soft = gabor_impl_above(band.x, band.z, 0.5, 0.22); // red and washed-out layers
    float3 colour = lerp(float3(0.50, 0.22, 0.09), float3(0.60, 0.35, 0.18), gabor_impl_above(broad.x, broad.z, 0.0, 0.5));
    colour = lerp(colour, float3(0.28, 0.075, 0.035), 0.8 * soft);
    colour = lerp(colour, float3(0.74, 0.58, 0.40), 0.75 * gabor_impl_above(thin.x, thin.z, 1.0, 0.2));
    colour = lerp(colour, float3(0.20, 0.06, 0.035), 0.6 * gabor_impl_above(thin.y, thin.z, 1.3, 0.15));
    colour *= gabor_impl_tone(lamina.x, lamina.z, 0.13) * gabor_impl_tone(grain.x, grain.z, 0.11);
    float height = 0.02 * broad.y - 0.012 * soft + 0.006 * thin.x + 0.0015 * lamina.x + 0.003 * grain.y;
    return gabor_impl_material(colour, height, 0.9, 0.0);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborMaterial gabor_wood(float2 p, uint seed) {
    return gabor_impl_wood(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_fabric(float2 p, uint seed) {
    return gabor_impl_fabric(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_leather(float2 p, uint seed) {
    return gabor_impl_leather(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_marble(float2 p, uint seed) {
    return gabor_impl_marble(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_sand(float2 p, uint seed) {
    return gabor_impl_sand(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_ripples(float2 p, uint seed) {
    return gabor_impl_ripples(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_brushed_metal(float2 p, uint seed) {
    return gabor_impl_brushed_metal(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_scratches(float2 p, uint seed) {
    return gabor_impl_scratches(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_zebra(float2 p, uint seed) {
    return gabor_impl_zebra(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_bark(float2 p, uint seed) {
    return gabor_impl_bark(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_carbon_fibre(float2 p, uint seed) {
    return gabor_impl_carbon_fibre(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_strata(float2 p, uint seed) {
    return gabor_impl_strata(GaborPixel_of(p, (float2)(0.0), (float2)(0.0), false), seed);
}

GaborMaterial gabor_wood_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_wood(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_fabric_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_fabric(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_leather_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_leather(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_marble_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_marble(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_sand_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_sand(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_ripples_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_ripples(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_brushed_metal_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_brushed_metal(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_scratches_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_scratches(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_zebra_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_zebra(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_bark_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_bark(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_carbon_fibre_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_carbon_fibre(GaborPixel_of(p, dx, dy, true), seed);
}

GaborMaterial gabor_strata_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_impl_strata(GaborPixel_of(p, dx, dy, true), seed);
}

#endif // GABOR_MATERIALS_HLSL
