// Generated from gabor_erosion.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
//
// gabor_erosion.hlsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
// Paste or include this file after gabor_noise.hlsl.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height and slope
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#error Include gabor_noise.hlsl before gabor_erosion.hlsl
#endif
#ifndef GABOR_EROSION_HLSL
#define GABOR_EROSION_HLSL

// A height in units of p, its derivatives, and a ridge value from -1 in creases and valleys to 1 on ridges and peaks.
struct GaborTerrain {
    float height;
    float2 slope;
    float ridge;
};

GaborTerrain GaborTerrain_of(float height, float2 slope, float ridge)
{
    GaborTerrain made;
    made.height = height;
    made.slope = slope;
    made.ridge = ridge;
    return made;
}

struct GaborErosion {
    int octaves;           // octaves of gullies, 0 to 16, usually 0 to 10: each costs about as much as gabor_noise_gradient
    float frequency;       // gullies per unit of p in the first octave, 0.001 to 10000, usually 0.1 to 10
    float strength;        // depth of gullies times their frequency, 0 to 10, usually 0 to 0.5: how steep they are
    float lacunarity;      // frequency of an octave relative to the previous one, 1 to 8, usually 1 to 4
    float gain;            // depth of an octave relative to the previous one, 0 to 2, usually 0 to 1: 1 / lacunarity for equal slopes
    float onset;           // slope at which gullies reach their full depth, 0.000001 to 100, usually 0.01 to 4
    float detail;          // how far fine gullies reach into creases, ridges and flat areas, 0.1 to 100, usually 0.1 to 10
    float uniformity;      // how uniform the depths of gullies are, 0 to 100, usually 0 to 8: 1 for natural variety, 4 for
                           // even stripes
    float ridge_rounding;  // width of rounded ridges, 0 to 10, usually 0 to 2: radians of the first octave's phase
    float crease_rounding; // width of rounded creases, 0 to 10, usually 0 to 2
    float gully_weight;    // depth of gullies, relative to how far peaks rise and valleys sink, 0 to 1
    float branching;       // how much of a gully's slope turns finer gullies, 0 to 10, usually 0 to 2: 1 for all of it
};

GaborErosion GaborErosion_of(int octaves, float frequency, float strength, float lacunarity, float gain, float onset, float detail, float uniformity, float ridge_rounding, float crease_rounding, float gully_weight, float branching)
{
    GaborErosion made;
    made.octaves = octaves;
    made.frequency = frequency;
    made.strength = strength;
    made.lacunarity = lacunarity;
    made.gain = gain;
    made.onset = onset;
    made.detail = detail;
    made.uniformity = uniformity;
    made.ridge_rounding = ridge_rounding;
    made.crease_rounding = crease_rounding;
    made.gully_weight = gully_weight;
    made.branching = branching;
    return made;
}

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(float2 p, uint seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.6 and continuous curvature.

// GaborTerrain gabor_eroded(float2 p, GaborTerrain base, GaborErosion erosion, uint seed)
//     Adds gullies and ridges to the base at p. Where the base is flat, base.ridge distinguishes valleys, -1, from
//     peaks, 1. The height is continuous where the base and its slope are, and the result can be eroded again. The
//     returned slope takes only the phase of the gullies into account, not how they turn and fade: its rms error is
//     0.63 times the rms slope.

// GaborTerrain gabor_terrain_filtered(float2 p, float2 dx, float2 dy, uint seed)
// GaborTerrain gabor_eroded_filtered(float2 p, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion, uint seed)
//     The same without features that are too fine for a pixel; the mean height does not change. dx and dy are dFdx(p)
//     and dFdy(p).

// GaborTerrain gabor_terrain_tiled(float2 p, float2 period, uint seed)
// GaborTerrain gabor_eroded_tiled(float2 p, float2 period, GaborTerrain base, GaborErosion erosion, uint seed)
//     The same with an exact period along x and y, at least 4 units of p. Integer periods do not change the width of
//     the hills.

struct GaborTerrainPlace { // the position cell + local
    int2 cell;  // any integers: the world wraps around after 2^32 cells along each axis
    float2 local;  // most precise in [0, 1)^2
    float2 period; // 0 for none. With a period, cell + local is rounded to a float
};

GaborTerrainPlace GaborTerrainPlace_of(int2 cell, float2 local, float2 period)
{
    GaborTerrainPlace made;
    made.cell = cell;
    made.local = local;
    made.period = period;
    return made;
}

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, float2 dx, float2 dy, uint seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion,
//                              uint seed)
//     The same with a period, a filter (unless dx and dy are float2(0.0)), or both. Without a period, the result is
//     precise at any distance from the origin.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `radius` is in nodes per unit of
// p, so that wave vectors and derivatives are per unit of p.
GaborPlace gabor_impl_ground(GaborTerrainPlace ground, float nodes) {
    uint rounded = uint(clamp(nodes, 1.0e-4, 3.0e4) * 65536.0 + 0.5);
    GaborPlace place = gabor_place((int2)(0), (float2)(0.0));
    place.radius = (float2)(float(rounded) / 65536.0);
    uint2 low = ((uint2)(ground.cell) & (uint2)(0xffffu)) * (rounded & 0xffffu);
    uint2 high = (uint2)(ground.cell) * (rounded >> 16u) + (uint2)(ground.cell >> (int2)(16)) * (rounded & 0xffffu);
    place.cell = (int2)(high + (low >> (uint2)(16u)));
    place.local = (float2)(low & (uint2)(0xffffu)) / 65536.0 + ground.local * place.radius;
    if (ground.period.x <= 0.0 && ground.period.y <= 0.0) return place;
    place.period = (int2)(max(floor(ground.period * place.radius + 0.5), 4.0));
    if (ground.period.x > 0.0) place.radius.x = float(place.period.x) / ground.period.x; else place.period.x = 0;
    if (ground.period.y > 0.0) place.radius.y = float(place.period.y) / ground.period.y; else place.period.y = 0;
    place.cell = (int2)(0);
    place.local = ((float2)(ground.cell) + ground.local) * place.radius;
    return place;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
void gabor_impl_splines(float t, out float4 value, out float4 slope) {
    float u = 1.0 - t;
    value = float4(u * u * u, 4.0 - 3.0 * t * t * (1.0 + u), 4.0 - 3.0 * u * u * (1.0 + t), t * t * t) / 6.0;
    slope = 0.5 * float4(-u * u, t * (3.0 * t - 4.0), u * (4.0 - 3.0 * u), t * t);
}

uint4 gabor_impl_four_line_words(int index, int period, uint salt) {
    int first = gabor_impl_wrap(index - 1, period);
    int second = gabor_impl_next_node(first, period);
    int third = gabor_impl_next_node(second, period);
    return uint4(gabor_impl_line_word(first, salt), gabor_impl_line_word(second, salt), gabor_impl_line_word(third, salt),
                 gabor_impl_line_word(gabor_impl_next_node(third, period), salt));
}

// Two noises and their derivatives.
struct GaborHills {
    float2 value;
    float2 slope_x;
    float2 slope_y;
};

GaborHills GaborHills_of(float2 value, float2 slope_x, float2 slope_y)
{
    GaborHills made;
    made.value = value;
    made.slope_x = slope_x;
    made.slope_y = slope_y;
    return made;
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises.
void gabor_impl_add_hill_row(inout GaborHills sum, uint4 words, float4 x, float4 slope_x, float y, float slope_y) {
    float4 a = (float4)((int4)(words)), b = (float4)((int4)(words << 16u));
    float2 row = float2(dot(x, a), dot(x, b));
    sum.value += y * row;
    sum.slope_x += y * float2(dot(slope_x, a), dot(slope_x, b));
    sum.slope_y += slope_y * row;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, float2 dx, float2 dy, uint seed) {
    GaborPlace place = gabor_impl_ground(ground, 1.0);
    float2 zero = floor(place.local);
    float4 x, y, slope_x, slope_y;
    gabor_impl_splines(place.local.x - zero.x, x, slope_x);
    gabor_impl_splines(place.local.y - zero.y, y, slope_y);
    uint salt = gabor_impl_salt(seed);
    uint4 columns = gabor_impl_four_line_words(place.cell.x + int(zero.x), place.period.x, salt);
    uint4 rows = gabor_impl_four_line_words(place.cell.y + int(zero.y), place.period.y, salt ^ GABOR_IMPL_ROWS);
    GaborHills hills = GaborHills_of((float2)(0.0), (float2)(0.0), (float2)(0.0));
    gabor_impl_add_hill_row(hills, columns * rows.x, x, slope_x, y.x, slope_y.x);
    gabor_impl_add_hill_row(hills, columns * rows.y, x, slope_x, y.y, slope_y.y);
    gabor_impl_add_hill_row(hills, columns * rows.z, x, slope_x, y.z, slope_y.z);
    gabor_impl_add_hill_row(hills, columns * rows.w, x, slope_x, y.w, slope_y.w);
    float4 s = clamp(float4(dx, dy), -1.0e9, 1.0e9);
    float area = s.x * s.w - s.y * s.z;
    float kept = rsqrt(1.0 + 0.34768212 * dot(s, s) + 0.12088286 * area * area);
    float unit = 1.6825360e-9 * kept; // 315 / 151 sqrt(3) / 2^31: variance 1
    float2 noise = unit * hills.value, wave = exp(3.1582734 * (kept * kept - 1.0)) * gabor_impl_wave(0.4 * noise.y);
    float rough = 0.3 + 0.12 * noise.x, height = noise.x + rough * wave.y;
    float2 factors = 0.33 * unit * float2(1.0 + 0.12 * wave.y, 2.5132741 * rough * wave.x);
    float2 slope = place.radius * float2(dot(factors, hills.slope_x), dot(factors, hills.slope_y));
    return GaborTerrain_of(0.33 * height, slope, height * rsqrt(1.0 + height * height));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded.
float gabor_impl_mask(float t, float rounding) {
    float s = 1.0 - min(t < rounding ? 0.5 * t * t / rounding : t - 0.5 * rounding, 1.0);
    return 1.0 - s * s;
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion, uint seed) {
    GaborTerrain terrain = base;
    GaborTerrain gully = GaborTerrain_of(base.ridge, (float2)(0.0), base.ridge); // t_i, its slope, and t_i with w = 1
    float2 steer = base.slope;
    float frequency = erosion.frequency, depth = erosion.strength / erosion.frequency;
    float mask = 1.0, rounding = lerp(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * base.ridge);
    for (int i = 0; i < erosion.octaves; ++i) {
        float steep = max(length(steer), 1.0e-9), full = gabor_impl_mask(steep / max(erosion.onset, 1.0e-6), rounding);
        mask *= full * full;
        float2 wave = frequency / steep * float2(-steer.y, steer.x);
        float2 steps = float2(dot(wave, dx), dot(wave, dy));
        // The share of a wave that a Gaussian filter of standard deviation half a pixel keeps; small shares are 0.
        float kept = max(1.02 * exp(-4.9348022 * dot(steps, steps)) - 0.02, 0.0);
        float2 z = (float2)(0.0);
        if (kept > 0.0) {
            GaborPlace place = gabor_impl_ground(ground, 0.8 * GABOR_RADIUS * frequency); // 1.25 gullies per radius
            GaborField field = gabor_field(place, wave, gabor_lobe_seed(seed, i));
            z = erosion.uniformity * float2(field.quadrature, field.noise);
            z *= kept * rsqrt(1.0 + dot(z, z)); // brings the length of z near `kept`, except where waves cancel
        }
        gully.height = lerp(gully.height, erosion.gully_weight * z.x, mask);
        gully.slope = lerp(gully.slope, -6.2831853 * erosion.gully_weight * z.y * wave, mask);
        gully.ridge = lerp(gully.ridge, z.x, mask);
        terrain.height += depth * gully.height;
        terrain.slope += depth * gully.slope;
        float side = (z.y < 0.0 ? -6.2831853 : 6.2831853) * kept * erosion.branching * erosion.gully_weight;
        steer -= side * depth * mask * wave;
        rounding = lerp(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * z.x);
        mask = mask * erosion.detail / (1.0 + mask * (erosion.detail - 1.0))
             * gabor_impl_mask(0.5 - 0.5 * kept + abs(z.y), rounding * frequency / erosion.frequency);
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return GaborTerrain_of(terrain.height, terrain.slope, gully.ridge);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborErosion gabor_erosion() {
    return GaborErosion_of(5, 1.5, 0.12, 2.0, 0.5, 0.5, 1.5, 2.0, 0.1, 0.1, 0.5, 1.0);
}

GaborTerrain gabor_terrain_filtered(float2 p, float2 dx, float2 dy, uint seed) {
    return gabor_terrain_at(GaborTerrainPlace_of((int2)(0), p, (float2)(0.0)), dx, dy, seed);
}

GaborTerrain gabor_terrain(float2 p, uint seed) {
    return gabor_terrain_filtered(p, (float2)(0.0), (float2)(0.0), seed);
}

GaborTerrain gabor_terrain_tiled(float2 p, float2 period, uint seed) {
    return gabor_terrain_at(GaborTerrainPlace_of((int2)(0), p, period), (float2)(0.0), (float2)(0.0), seed);
}

GaborTerrain gabor_eroded_filtered(float2 p, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_at(GaborTerrainPlace_of((int2)(0), p, (float2)(0.0)), dx, dy, base, erosion, seed);
}

GaborTerrain gabor_eroded(float2 p, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_filtered(p, (float2)(0.0), (float2)(0.0), base, erosion, seed);
}

GaborTerrain gabor_eroded_tiled(float2 p, float2 period, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_at(GaborTerrainPlace_of((int2)(0), p, period), (float2)(0.0), (float2)(0.0), base, erosion, seed);
}

#endif // GABOR_EROSION_HLSL
