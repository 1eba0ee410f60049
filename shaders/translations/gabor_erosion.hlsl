// Generated from gabor_erosion.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl; pasted after their texts, it includes nothing.
//
// gabor_erosion.hlsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height, slope and curvature
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//     float4 cover = gabor_ground_cover(rocks);                             // shares of grass, scree, rock and snow
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#ifndef GABOR_EROSION_HLSL
#define GABOR_EROSION_HLSL 1

// A height in units of p, and what erosion needs to know about it. Members that nobody reads cost nothing.
struct GaborTerrain {
    float height;
    float2 slope;       // the derivatives of the height along x and y
    float ridge;      // from -1 in creases and valleys to 1 on ridges and peaks
    float3 curvature;   // the second derivatives of the height: xx, xy and yy
    float2 ridge_slope; // the derivatives of ridge
};

GaborTerrain GaborTerrain_of(float height, float2 slope, float ridge, float3 curvature, float2 ridge_slope) {
    GaborTerrain made = {height, slope, ridge, curvature, ridge_slope};
    return made;
}

struct GaborErosion {
    int octaves;           // octaves of gullies, 0 to 16, usually 0 to 10: each costs two gabor_noise_gradient
    float gully_frequency; // gullies per unit of p in the first octave, 0.001 to 10000, usually 0.1 to 10
    float strength;        // how far peaks and valleys move, times the gullies' frequency, 0 to 10, usually 0 to 0.5
    float lacunarity;      // frequency of an octave relative to the previous one, 1 to 8, usually 1 to 4
    float gain;            // depth of an octave relative to the previous one, 0 to 2, usually 0 to 1: 1 / lacunarity
                           // for equal slopes
    float onset_slope;     // slope at which gullies reach their full depth, 0.000001 to 100, usually 0.01 to 4: twice
                           // the rms slope of a map leaves its valleys open
    float detail;          // how far fine gullies enter creases, ridges and flat areas, 0.1 to 100, usually 0.1 to 10
    float uniformity;      // how uniform the depths of gullies are, 0 to 100, usually 0 to 8: 1 for natural variety, 4
                           // for even stripes
    float ridge_rounding;  // width of rounded ridges in radians of the first octave, 0 to 10, usually 0 to 2
    float crease_rounding; // width of rounded creases in radians of the first octave, 0 to 10, usually 0 to 2
    float gully_weight;    // depth of gullies, as a share of how far peaks and valleys move, 0 to 1
    float branching;       // how much of a gully's slope turns finer gullies, 0 to 10, usually 0 to 2: 1 for all of it
};

GaborErosion GaborErosion_of(int octaves, float gully_frequency, float strength, float lacunarity, float gain,
        float onset_slope, float detail, float uniformity, float ridge_rounding, float crease_rounding,
        float gully_weight, float branching) {
    GaborErosion made = {octaves, gully_frequency, strength, lacunarity, gain, onset_slope, detail, uniformity,
        ridge_rounding, crease_rounding, gully_weight, branching};
    return made;
}

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(float2 p, uint seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.637 and continuous curvature. The variance
//     of the height differs by up to 17 % between the positions in a square unit.

// GaborTerrain gabor_eroded(float2 p, GaborTerrain base, GaborErosion erosion, uint seed)
//     Adds gullies and ridges to the base at p. A base whose ridge is 1 where it is flat gets pointed peaks there.
//     Elsewhere, flat ground stays as it is. The height is continuous where the base and its slope are. The returned
//     slope is the derivative of the height, if the base has its curvature and the derivatives of its ridge; with zeros
//     instead, its rms error is 0.45 times the rms slope. The returned curvature and ridge_slope are 0: to erode the
//     result again, draw it as a heightmap first, which has its curvature in nine texels.

// float4 gabor_ground_cover(GaborTerrain terrain)
//     The shares of grass, scree, rock and snow, whose sum is 1: snow where it is high, rock where it is steep,
//     elsewhere scree where it is fairly high, and grass below. Ridges count as a little higher. Heights are about from
//     -1 to 1, as those of gabor_terrain.

struct GaborTerrainPlace { // the position cell + local: GaborTerrainPlace(int2(0), p, float2(0.0)) for a point
    int2 cell;  // any integers: the world wraps around after 2^32 cells along each axis
    float2 local;  // most precise in [0, 1)^2
    float2 period; // exact, along x and y: at least 4, or 0 for none. Integers do not change the width of the hills
};

GaborTerrainPlace GaborTerrainPlace_of(int2 cell, float2 local, float2 period) {
    GaborTerrainPlace made = {cell, local, period};
    return made;
}

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, float2 dx, float2 dy, uint seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion,
//                              uint seed)
//     The same with a period, a filter, or both. The filter leaves out features that are too fine for a pixel and keeps
//     the mean height: dx and dy are ddx(p) and ddy(p), or float2(0.0) for no filter, and slopes are derivatives for a
//     pixel of that size. Without a period, the result is precise at any distance from the origin; with one, cell +
//     local is rounded to a float. The nodes per unit of p are a multiple of 1 / 65536, so a mountain that is twice as
//     large and has half the frequency looks the same only near the origin: within 3e-4 of its height up to 10 units
//     away, and 3e-3 up to 100.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `cells_per_radius` is in nodes
// per unit of p, so that wave vectors and derivatives are per unit of p.
GaborPlace gabor_impl_ground(GaborTerrainPlace ground, float nodes) {
    uint rounded = uint(clamp(nodes, 1.0e-4, 3.0e4) * 65536.0 + 0.5);
    GaborPlace place = gabor_place((int2)(0), (float2)(0.0));
    place.cells_per_radius = (float2)(float(rounded) / 65536.0);
    uint2 low = ((uint2)(ground.cell) & (uint2)(0xffffu)) * (rounded & 0xffffu);
    uint2 high = (uint2)(ground.cell) * (rounded >> 16u) + (uint2)(ground.cell >> (int2)(16)) * (rounded & 0xffffu);
    place.cell = (int2)(high + (low >> (uint2)(16u)));
    place.local = (float2)(low & (uint2)(0xffffu)) / 65536.0 + ground.local * place.cells_per_radius;
    if (ground.period.x <= 0.0 && ground.period.y <= 0.0) return place;
    place.period = (int2)(max(floor(ground.period * place.cells_per_radius + 0.5), 4.0));
    if (ground.period.x > 0.0) place.cells_per_radius.x = float(place.period.x) / ground.period.x;
    else place.period.x = 0;
    if (ground.period.y > 0.0) place.cells_per_radius.y = float(place.period.y) / ground.period.y;
    else place.period.y = 0;
    place.cell = (int2)(0);
    place.local = ((float2)(ground.cell) + ground.local) * place.cells_per_radius;
    return place;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
void gabor_impl_splines(float t, out float4 value, out float4 slope, out float4 curvature) {
    float u = 1.0 - t;
    value = float4(u * u * u, 4.0 - 3.0 * t * t * (1.0 + u), 4.0 - 3.0 * u * u * (1.0 + t), t * t * t) / 6.0;
    slope = 0.5 * float4(-u * u, t * (3.0 * t - 4.0), u * (4.0 - 3.0 * u), t * t);
    curvature = float4(u, 3.0 * t - 2.0, 3.0 * u - 2.0, t);
}

// Two noises and their derivatives.
struct GaborImplHills {
    float2 value;
    float2 slope_x;
    float2 slope_y;
    float2 curvature_xx;
    float2 curvature_xy;
    float2 curvature_yy;
};

GaborImplHills GaborImplHills_of(float2 value, float2 slope_x, float2 slope_y, float2 curvature_xx, float2 curvature_xy,
        float2 curvature_yy) {
    GaborImplHills made = {value, slope_x, slope_y, curvature_xx, curvature_xy, curvature_yy};
    return made;
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises. y holds the row's spline and its
// derivatives.
void gabor_impl_add_hill_row(inout GaborImplHills sum, uint4 words, float4 x, float4 slope_x, float4 curvature_x, float3 y) {
    float4 a = (float4)((int4)(words)), b = (float4)((int4)(words << 16u));
    float2 row = float2(dot(x, a), dot(x, b)), along_x = float2(dot(slope_x, a), dot(slope_x, b));
    sum.value += y.x * row;
    sum.slope_x += y.x * along_x;
    sum.slope_y += y.y * row;
    sum.curvature_xx += y.x * float2(dot(curvature_x, a), dot(curvature_x, b));
    sum.curvature_xy += y.y * along_x;
    sum.curvature_yy += y.z * row;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, float2 dx, float2 dy, uint seed) {
    GaborPlace place = gabor_impl_ground(ground, 1.0);
    float2 zero = floor(place.local);
    float4 x, y, slope_x, slope_y, curvature_x, curvature_y;
    gabor_impl_splines(place.local.x - zero.x, x, slope_x, curvature_x);
    gabor_impl_splines(place.local.y - zero.y, y, slope_y, curvature_y);
    uint salt = gabor_impl_salt(seed);
    uint4 columns = gabor_impl_four_line_words(place.cell.x + int(zero.x), place.period.x, salt);
    uint4 rows = gabor_impl_four_line_words(place.cell.y + int(zero.y), place.period.y, salt ^ GABOR_IMPL_ROWS);
    GaborImplHills hills = GaborImplHills_of((float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0));
    gabor_impl_add_hill_row(hills, columns * rows.x, x, slope_x, curvature_x, float3(y.x, slope_y.x, curvature_y.x));
    gabor_impl_add_hill_row(hills, columns * rows.y, x, slope_x, curvature_x, float3(y.y, slope_y.y, curvature_y.y));
    gabor_impl_add_hill_row(hills, columns * rows.z, x, slope_x, curvature_x, float3(y.z, slope_y.z, curvature_y.z));
    gabor_impl_add_hill_row(hills, columns * rows.w, x, slope_x, curvature_x, float3(y.w, slope_y.w, curvature_y.w));
    float4 s = clamp(float4(dx, dy), -1.0e9, 1.0e9);
    float area = s.x * s.w - s.y * s.z;
    // 0.34768212 is (2/3) / (151/315) / 4 and 0.12088286 is ((2/3) / (151/315) / 4)^2
    float kept = rsqrt(1.0 + 0.34768212 * dot(s, s) + 0.12088286 * area * area);
    float unit = 1.6825360e-9 * kept; // 315 / 151 sqrt(3) / 2^31: variance 1
    // 3.1582734 is (0.8 pi)^2 / 2
    float2 noise = unit * hills.value, wave = exp(3.1582734 * (kept * kept - 1.0)) * gabor_impl_wave(0.4 * noise.y);
    float rough = 0.3 + 0.12 * noise.x, height = noise.x + rough * wave.y;
    // The height of noises a and b is 0.33 (a + (0.3 + 0.12 a) sin(2 pi 0.4 b)). Its derivatives by a and b;
    // by ab and bb:
    float2 first = 0.33 * unit * float2(1.0 + 0.12 * wave.y, 2.5132741 * rough * wave.x); // 0.8 pi
    // 0.30159289 is 0.12 * 0.8 pi and 6.3165468 is (0.8 pi)^2
    float2 second = 0.33 * unit * unit * float2(0.30159289 * wave.x, -6.3165468 * rough * wave.y);
    float2 along_x = hills.slope_x, along_y = hills.slope_y;
    float2 slope = place.cells_per_radius * float2(dot(first, along_x), dot(first, along_y));
    float3 curvature =
        float3(dot(first, hills.curvature_xx) + along_x.y * (2.0 * second.x * along_x.x + second.y * along_x.y),
               dot(first, hills.curvature_xy) + second.x * (along_x.x * along_y.y + along_x.y * along_y.x)
                   + second.y * along_x.y * along_y.y,
               dot(first, hills.curvature_yy) + along_y.y * (2.0 * second.x * along_y.x + second.y * along_y.y));
    curvature *= float3(place.cells_per_radius * place.cells_per_radius.x,
                      place.cells_per_radius.y * place.cells_per_radius.y);
    float to_ridge = rsqrt(1.0 + height * height);
    return GaborTerrain_of(0.33 * height, slope, height * to_ridge, curvature,
                        to_ridge * to_ridge * to_ridge / 0.33 * slope);
}

// The complex noise (quadrature, noise), its derivatives along x and y, and its derivative as the wave vector moves in
// a direction.
struct GaborImplBentField {
    float2 value;
    float2 along_x;
    float2 along_y;
    float2 bent;
};

GaborImplBentField GaborImplBentField_of(float2 value, float2 along_x, float2 along_y, float2 bent) {
    GaborImplBentField made = {value, along_x, along_y, bent};
    return made;
}

// Adds row j of nodes to the sums of gabor_impl_sum, and to `places`, weighted by the nodes' places along x and y.
void gabor_impl_add_bent_row(inout float4 sum, inout float2 along_y, inout float4 places, GaborImplAxis x, GaborImplAxis y,
                             int j) {
    float4 before = (float4)(0.0), row = (float4)(0.0), after = (float4)(0.0);
    gabor_impl_add_products(before, x.node[0], gabor_impl_amplitude(x.word[0] * y.word[j]));
    gabor_impl_add_products(row, x.node[1], gabor_impl_amplitude(x.word[1] * y.word[j]));
    if (GABOR_TAPS > 2) gabor_impl_add_products(after, x.node[2], gabor_impl_amplitude(x.word[2] * y.word[j]));
    float2 moved = after.xy - before.xy;
    row += before + after;
    if (GABOR_TAPS > 3) {
        after = (float4)(0.0);
        gabor_impl_add_products(after, x.node[3], gabor_impl_amplitude(x.word[3] * y.word[j]));
        moved += 2.0 * after.xy;
        row += after;
    }
    float4 here = (float4)(0.0);
    gabor_impl_add_products(here, row, y.node[j].xy);
    sum += here;
    along_y += gabor_impl_product(row.xy, y.node[j].zw);
    places += float4(gabor_impl_product(moved, y.node[j].xy), float(j - 1) * here.xy);
}

// gabor_field with the derivative of a wave's phase by its wave vector: 2 pi times the offset from the wave's node.
GaborImplBentField gabor_impl_bent_field(GaborPlace place, float2 wave, float2 direction, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                                      place.cells_per_radius.y);
    float4 sum = (float4)(0.0), places = (float4)(0.0);
    float2 along_y = (float2)(0.0);
    gabor_impl_add_bent_row(sum, along_y, places, x, y, 0);
    gabor_impl_add_bent_row(sum, along_y, places, x, y, 1);
    if (GABOR_TAPS > 2) gabor_impl_add_bent_row(sum, along_y, places, x, y, 2);
    if (GABOR_TAPS > 3) gabor_impl_add_bent_row(sum, along_y, places, x, y, 3);
    float2 turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    GaborField field = gabor_impl_field(sum, float4(along_y, 0.0, 0.0), turn, wave,
                                        place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
    float2 value = float2(field.quadrature, field.noise);
    direction *= 6.2831853 / place.cells_per_radius;
    float2 nodes = direction.x * places.xy + direction.y * places.zw;
    float2 bent = dot(direction, float2(x.offset, y.offset)) * value
              - gabor_impl_product(nodes, turn) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return GaborImplBentField_of(value, float2(field.quadrature_gradient.x, field.gradient.x),
                              float2(field.quadrature_gradient.y, field.gradient.y), float2(-bent.y, bent.x));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded; and its derivatives by t
// and by the rounding.
float3 gabor_impl_mask(float t, float rounding) {
    float part = t < rounding ? t / rounding : 1.0; // how far t is into the rounded start
    float s = max(1.0 - part * (t - 0.5 * part * rounding), 0.0), slope = s * part;
    return float3(1.0 - s * s, 2.0 * slope, -slope * part);
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + open sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
// `open` is the first mask, and 1 on peaks: it leaves flat valleys as they are, because there gullies would dam them.
// For the exact slope, each quantity is differentiated along x and y: names end in _x and _y, or are float2(by x, by y).
// A wave vector keeps its length as it turns, so it changes along the slope that its gullies follow.
GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, float2 dx, float2 dy, GaborTerrain base, GaborErosion erosion,
                             uint seed) {
    float2 steer = base.slope, steer_x = base.curvature.xy, steer_y = base.curvature.yz;
    float gully = base.ridge, ridge = base.ridge, sum = 0.0; // t_i, t_i with w = 1, sum_i depth_i t_i
    float2 gully_slope = base.ridge_slope, sum_slope = (float2)(0.0);
    float frequency = erosion.gully_frequency, depth = erosion.strength / erosion.gully_frequency;
    float mask = 1.0, open = 1.0;
    float rounding = lerp(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * base.ridge);
    float2 mask_slope = (float2)(0.0), open_slope = (float2)(0.0);
    float rounded = 0.5 * (erosion.ridge_rounding - erosion.crease_rounding), peak = clamp(base.ridge, 0.0, 1.0);
    float2 rounding_slope = rounded * base.ridge_slope;
    float per_onset = 1.0 / max(erosion.onset_slope, 1.0e-6);
    for (int i = 0; i < erosion.octaves; ++i) {
        float steep = max(length(steer), 1.0e-9);
        float2 down = steer / steep, across = float2(-down.y, down.x);
        float3 full = gabor_impl_mask(steep * per_onset, rounding);
        float2 full_slope = full.y * per_onset * float2(dot(down, steer_x), dot(down, steer_y)) + full.z * rounding_slope;
        mask_slope = full.x * (full.x * mask_slope + 2.0 * mask * full_slope);
        mask *= full.x * full.x;
        if (i == 0) {
            open = lerp(mask, 1.0, peak * peak);
            open_slope = (1.0 - peak * peak) * mask_slope + (1.0 - mask) * 2.0 * peak * base.ridge_slope;
        }
        float2 wave = frequency * across;
        // The wave changes by -down * bend.
        float2 bend = frequency / steep * float2(dot(across, steer_x), dot(across, steer_y));
        float2 steps = float2(dot(wave, dx), dot(wave, dy));
        // The share of a wave that a Gaussian filter of standard deviation half a pixel keeps; small shares are 0.
        float share = 1.02 * exp(-4.9348022 * dot(steps, steps)), kept = max(share - 0.02, 0.0); // pi^2 / 2
        float2 z = (float2)(0.0), z_x = (float2)(0.0), z_y = (float2)(0.0), kept_slope = (float2)(0.0);
        if (kept > 0.0) {
            // 1.25 gullies per radius.
            GaborPlace place = gabor_impl_ground(ground, 0.8 * GABOR_CELLS_PER_RADIUS * frequency);
            GaborImplBentField field = gabor_impl_bent_field(place, wave, down, gabor_derived_seed(seed, i));
            z = erosion.uniformity * field.value;
            float shrink = rsqrt(1.0 + dot(z, z)); // brings the length of z near 1, except where waves cancel
            z *= shrink;
            z_x = shrink * erosion.uniformity * (field.along_x - bend.x * field.bent);
            z_y = shrink * erosion.uniformity * (field.along_y - bend.y * field.bent);
            kept_slope = 9.8696044 * share * dot(steps, float2(dot(down, dx), dot(down, dy))) * bend; // pi^2
            z_x = kept * (z_x - dot(z, z_x) * z) + kept_slope.x * z;
            z_y = kept * (z_y - dot(z, z_y) * z) + kept_slope.y * z;
            z *= kept;
        }
        float crest = erosion.gully_weight * z.x;
        gully_slope = lerp(gully_slope, erosion.gully_weight * float2(z_x.x, z_y.x), mask) + (crest - gully) * mask_slope;
        gully = lerp(gully, crest, mask);
        ridge = lerp(ridge, z.x, mask);
        sum += depth * gully;
        sum_slope += depth * gully_slope;
        float side = z.y < 0.0 ? -1.0 : 1.0;
        float turns = 6.2831853 * depth * erosion.branching * erosion.gully_weight * side; // 2 pi
        float turn = turns * kept * mask;
        float2 turn_slope = turns * (kept * mask_slope + mask * kept_slope);
        steer -= turn * wave;
        steer_x += turn * bend.x * down - turn_slope.x * wave;
        steer_y += turn * bend.y * down - turn_slope.y * wave;
        float wide = frequency / erosion.gully_frequency;
        rounding = lerp(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * z.x);
        rounding_slope = rounded * float2(z_x.x, z_y.x);
        float3 edge = gabor_impl_mask(0.5 - 0.5 * kept + abs(z.y), wide * rounding);
        float2 edge_slope =
            edge.y * side * float2(z_x.y, z_y.y) - 0.5 * edge.y * kept_slope + edge.z * wide * rounding_slope;
        float reach = 1.0 / (1.0 + mask * (erosion.detail - 1.0));
        mask_slope = erosion.detail * reach * (reach * edge.x * mask_slope + mask * edge_slope);
        mask *= erosion.detail * reach * edge.x;
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return GaborTerrain_of(base.height + open * sum, base.slope + open * sum_slope + sum * open_slope, ridge, (float3)(0.0),
                        (float2)(0.0));
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborErosion gabor_erosion() {
    return GaborErosion_of(5, 1.5, 0.12, 2.0, 0.5, 0.5, 1.5, 2.0, 0.1, 0.1, 0.5, 1.0);
}

GaborTerrain gabor_terrain(float2 p, uint seed) {
    return gabor_terrain_at(GaborTerrainPlace_of((int2)(0), p, (float2)(0.0)), (float2)(0.0), (float2)(0.0), seed);
}

GaborTerrain gabor_eroded(float2 p, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_at(GaborTerrainPlace_of((int2)(0), p, (float2)(0.0)), (float2)(0.0), (float2)(0.0), base, erosion, seed);
}

float4 gabor_ground_cover(GaborTerrain terrain) {
    float steep = length(terrain.slope);
    float scree = smoothstep(-0.3, 0.35, terrain.height + 0.1 * terrain.ridge), rock = smoothstep(0.55, 1.0, steep);
    float snow = smoothstep(0.42, 0.62, terrain.height + 0.08 * terrain.ridge) * (1.0 - smoothstep(1.0, 1.9, steep));
    return float4((1.0 - snow) * float3((1.0 - rock) * float2(1.0 - scree, scree), rock), snow);
}

#endif
