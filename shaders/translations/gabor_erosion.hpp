// clang-format off
// Generated from gabor_erosion.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp; pasted after their texts, it includes nothing.
//
// gabor_erosion.hpp: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height, slope and curvature
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//     vec4 cover = gabor_ground_cover(rocks);                             // shares of grass, scree, rock and snow
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#ifndef GABOR_EROSION_HPP
#define GABOR_EROSION_HPP 1

// A height in units of p, and what erosion needs to know about it. Members that nobody reads cost nothing.
struct GaborTerrain {
    float height;
    gabor_vec2 slope;       // the derivatives of the height along x and y
    float ridge;      // from -1 in creases and valleys to 1 on ridges and peaks
    gabor_vec3 curvature;   // the second derivatives of the height: xx, xy and yy
    gabor_vec2 ridge_slope; // the derivatives of ridge
};

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

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(vec2 p, uint seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.637 and continuous curvature. The variance
//     of the height differs by up to 17 % between the positions in a square unit.

// GaborTerrain gabor_eroded(vec2 p, GaborTerrain base, GaborErosion erosion, uint seed)
//     Adds gullies and ridges to the base at p. A base whose ridge is 1 where it is flat gets pointed peaks there.
//     Elsewhere, flat ground stays as it is. The height is continuous where the base and its slope are. The returned
//     slope is the derivative of the height, if the base has its curvature and the derivatives of its ridge; with zeros
//     instead, its rms error is 0.45 times the rms slope. The returned curvature and ridge_slope are 0: to erode the
//     result again, draw it as a heightmap first, which has its curvature in nine texels.

// vec4 gabor_ground_cover(GaborTerrain terrain)
//     The shares of grass, scree, rock and snow, whose sum is 1: snow where it is high, rock where it is steep,
//     elsewhere scree where it is fairly high, and grass below. Ridges count as a little higher. Heights are about from
//     -1 to 1, as those of gabor_terrain.

struct GaborTerrainPlace { // the position cell + local: GaborTerrainPlace(ivec2(0), p, vec2(0.0)) for a point
    gabor_ivec2 cell;  // any integers: the world wraps around after 2^32 cells along each axis
    gabor_vec2 local;  // most precise in [0, 1)^2
    gabor_vec2 period; // exact, along x and y: at least 4, or 0 for none. Integers do not change the width of the hills
};

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, uint seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, GaborTerrain base, GaborErosion erosion,
//                              uint seed)
//     The same with a period, a filter, or both. The filter leaves out features that are too fine for a pixel and keeps
//     the mean height: dx and dy are dFdx(p) and dFdy(p), or vec2(0.0) for no filter, and slopes are derivatives for a
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
GABOR_INLINE GaborPlace gabor_impl_ground(GaborTerrainPlace ground, float nodes) {
    std::uint32_t rounded = std::uint32_t(gabor_cpp_clamp(nodes, 1.0e-4f, 3.0e4f) * 65536.0f + 0.5f);
    GaborPlace place = gabor_place(gabor_ivec2(0), gabor_vec2(0.0f));
    place.cells_per_radius = gabor_vec2(float(rounded) / 65536.0f);
    gabor_uvec2 low = (gabor_uvec2(ground.cell) & gabor_uvec2(0xffffu)) * (rounded & 0xffffu);
    gabor_uvec2 high = gabor_uvec2(ground.cell) * (rounded >> 16u) + gabor_uvec2(ground.cell >> gabor_ivec2(16)) * (rounded & 0xffffu);
    place.cell = gabor_ivec2(high + (low >> gabor_uvec2(16u)));
    place.local = gabor_vec2(low & gabor_uvec2(0xffffu)) / 65536.0f + ground.local * place.cells_per_radius;
    if (ground.period.x <= 0.0f && ground.period.y <= 0.0f) return place;
    place.period = gabor_ivec2(gabor_cpp_max(gabor_cpp_floor(ground.period * place.cells_per_radius + 0.5f), 4.0f));
    if (ground.period.x > 0.0f) place.cells_per_radius.x = float(place.period.x) / ground.period.x;
    else place.period.x = 0;
    if (ground.period.y > 0.0f) place.cells_per_radius.y = float(place.period.y) / ground.period.y;
    else place.period.y = 0;
    place.cell = gabor_ivec2(0);
    place.local = (gabor_vec2(ground.cell) + ground.local) * place.cells_per_radius;
    return place;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
GABOR_INLINE void gabor_impl_splines(float t, gabor_vec4& value, gabor_vec4& slope, gabor_vec4& curvature) {
    float u = 1.0f - t;
    value = gabor_vec4(u * u * u, 4.0f - 3.0f * t * t * (1.0f + u), 4.0f - 3.0f * u * u * (1.0f + t), t * t * t) / 6.0f;
    slope = 0.5f * gabor_vec4(-u * u, t * (3.0f * t - 4.0f), u * (4.0f - 3.0f * u), t * t);
    curvature = gabor_vec4(u, 3.0f * t - 2.0f, 3.0f * u - 2.0f, t);
}

// Two noises and their derivatives.
struct GaborImplHills {
    gabor_vec2 value;
    gabor_vec2 slope_x;
    gabor_vec2 slope_y;
    gabor_vec2 curvature_xx;
    gabor_vec2 curvature_xy;
    gabor_vec2 curvature_yy;
};

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises. y holds the row's spline and its
// derivatives.
GABOR_INLINE void gabor_impl_add_hill_row(GaborImplHills& sum, gabor_uvec4 words, gabor_vec4 x, gabor_vec4 slope_x, gabor_vec4 curvature_x, gabor_vec3 y) {
    gabor_vec4 a = gabor_vec4(gabor_ivec4(words)), b = gabor_vec4(gabor_ivec4(words << 16u));
    gabor_vec2 row = gabor_vec2(gabor_cpp_dot(x, a), gabor_cpp_dot(x, b)), along_x = gabor_vec2(gabor_cpp_dot(slope_x, a), gabor_cpp_dot(slope_x, b));
    sum.value += y.x * row;
    sum.slope_x += y.x * along_x;
    sum.slope_y += y.y * row;
    sum.curvature_xx += y.x * gabor_vec2(gabor_cpp_dot(curvature_x, a), gabor_cpp_dot(curvature_x, b));
    sum.curvature_xy += y.y * along_x;
    sum.curvature_yy += y.z * row;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
GABOR_INLINE GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    GaborPlace place = gabor_impl_ground(ground, 1.0f);
    gabor_vec2 zero = gabor_cpp_floor(place.local);
    gabor_vec4 x, y, slope_x, slope_y, curvature_x, curvature_y;
    gabor_impl_splines(place.local.x - zero.x, x, slope_x, curvature_x);
    gabor_impl_splines(place.local.y - zero.y, y, slope_y, curvature_y);
    std::uint32_t salt = gabor_impl_salt(seed);
    gabor_uvec4 columns = gabor_impl_four_line_words(place.cell.x + int(zero.x), place.period.x, salt);
    gabor_uvec4 rows = gabor_impl_four_line_words(place.cell.y + int(zero.y), place.period.y, salt ^ GABOR_IMPL_ROWS);
    GaborImplHills hills = GaborImplHills{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f)};
    gabor_impl_add_hill_row(hills, columns * rows.x, x, slope_x, curvature_x, gabor_vec3(y.x, slope_y.x, curvature_y.x));
    gabor_impl_add_hill_row(hills, columns * rows.y, x, slope_x, curvature_x, gabor_vec3(y.y, slope_y.y, curvature_y.y));
    gabor_impl_add_hill_row(hills, columns * rows.z, x, slope_x, curvature_x, gabor_vec3(y.z, slope_y.z, curvature_y.z));
    gabor_impl_add_hill_row(hills, columns * rows.w, x, slope_x, curvature_x, gabor_vec3(y.w, slope_y.w, curvature_y.w));
    gabor_vec4 s = gabor_cpp_clamp(gabor_vec4(dx, dy), -1.0e9f, 1.0e9f);
    float area = s.x * s.w - s.y * s.z;
    // 0.34768212 is (2/3) / (151/315) / 4 and 0.12088286 is ((2/3) / (151/315) / 4)^2
    float kept = gabor_cpp_inversesqrt(1.0f + 0.34768212f * gabor_cpp_dot(s, s) + 0.12088286f * area * area);
    float unit = 1.6825360e-9f * kept; // 315 / 151 sqrt(3) / 2^31: variance 1
    // 3.1582734 is (0.8 pi)^2 / 2
    gabor_vec2 noise = unit * hills.value, wave = gabor_cpp_exp(3.1582734f * (kept * kept - 1.0f)) * gabor_impl_wave(0.4f * noise.y);
    float rough = 0.3f + 0.12f * noise.x, height = noise.x + rough * wave.y;
    // The height of noises a and b is 0.33 (a + (0.3 + 0.12 a) sin(2 pi 0.4 b)). Its derivatives by a and b;
    // by ab and bb:
    gabor_vec2 first = 0.33f * unit * gabor_vec2(1.0f + 0.12f * wave.y, 2.5132741f * rough * wave.x); // 0.8 pi
    // 0.30159289 is 0.12 * 0.8 pi and 6.3165468 is (0.8 pi)^2
    gabor_vec2 second = 0.33f * unit * unit * gabor_vec2(0.30159289f * wave.x, -6.3165468f * rough * wave.y);
    gabor_vec2 along_x = hills.slope_x, along_y = hills.slope_y;
    gabor_vec2 slope = place.cells_per_radius * gabor_vec2(gabor_cpp_dot(first, along_x), gabor_cpp_dot(first, along_y));
    gabor_vec3 curvature =
        gabor_vec3(gabor_cpp_dot(first, hills.curvature_xx) + along_x.y * (2.0f * second.x * along_x.x + second.y * along_x.y),
               gabor_cpp_dot(first, hills.curvature_xy) + second.x * (along_x.x * along_y.y + along_x.y * along_y.x)
                   + second.y * along_x.y * along_y.y,
               gabor_cpp_dot(first, hills.curvature_yy) + along_y.y * (2.0f * second.x * along_y.x + second.y * along_y.y));
    curvature *= gabor_vec3(place.cells_per_radius * place.cells_per_radius.x,
                      place.cells_per_radius.y * place.cells_per_radius.y);
    float to_ridge = gabor_cpp_inversesqrt(1.0f + height * height);
    return GaborTerrain{0.33f * height, slope, height * to_ridge, curvature,
                        to_ridge * to_ridge * to_ridge / 0.33f * slope};
}

// The complex noise (quadrature, noise), its derivatives along x and y, and its derivative as the wave vector moves in
// a direction.
struct GaborImplBentField {
    gabor_vec2 value;
    gabor_vec2 along_x;
    gabor_vec2 along_y;
    gabor_vec2 bent;
};

// Adds row j of nodes to the sums of gabor_impl_sum, and to `places`, weighted by the nodes' places along x and y.
GABOR_INLINE void gabor_impl_add_bent_row(gabor_vec4& sum, gabor_vec2& along_y, gabor_vec4& places, GaborImplAxis x, GaborImplAxis y,
                             int j) {
    gabor_vec4 before = gabor_vec4(0.0f), row = gabor_vec4(0.0f), after = gabor_vec4(0.0f);
    gabor_impl_add_products(before, x.node[0], gabor_impl_amplitude(x.word[0] * y.word[j]));
    gabor_impl_add_products(row, x.node[1], gabor_impl_amplitude(x.word[1] * y.word[j]));
    if (GABOR_TAPS > 2) gabor_impl_add_products(after, x.node[2], gabor_impl_amplitude(x.word[2] * y.word[j]));
    gabor_vec2 moved = after.xy() - before.xy();
    row += before + after;
    if (GABOR_TAPS > 3) {
        after = gabor_vec4(0.0f);
        gabor_impl_add_products(after, x.node[3], gabor_impl_amplitude(x.word[3] * y.word[j]));
        moved += 2.0f * after.xy();
        row += after;
    }
    gabor_vec4 here = gabor_vec4(0.0f);
    gabor_impl_add_products(here, row, y.node[j].xy());
    sum += here;
    along_y += gabor_impl_product(row.xy(), y.node[j].zw());
    places += gabor_vec4(gabor_impl_product(moved, y.node[j].xy()), float(j - 1) * here.xy());
}

// gabor_field with the derivative of a wave's phase by its wave vector: 2 pi times the offset from the wave's node.
GABOR_INLINE GaborImplBentField gabor_impl_bent_field(GaborPlace place, gabor_vec2 wave, gabor_vec2 direction, std::uint32_t seed) {
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                                      place.cells_per_radius.y);
    gabor_vec4 sum = gabor_vec4(0.0f), places = gabor_vec4(0.0f);
    gabor_vec2 along_y = gabor_vec2(0.0f);
    gabor_impl_add_bent_row(sum, along_y, places, x, y, 0);
    gabor_impl_add_bent_row(sum, along_y, places, x, y, 1);
    if (GABOR_TAPS > 2) gabor_impl_add_bent_row(sum, along_y, places, x, y, 2);
    if (GABOR_TAPS > 3) gabor_impl_add_bent_row(sum, along_y, places, x, y, 3);
    gabor_vec2 turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    GaborField field = gabor_impl_field(sum, gabor_vec4(along_y, 0.0f, 0.0f), turn, wave,
                                        place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
    gabor_vec2 value = gabor_vec2(field.quadrature, field.noise);
    direction *= 6.2831853f / place.cells_per_radius;
    gabor_vec2 nodes = direction.x * places.xy() + direction.y * places.zw();
    gabor_vec2 bent = gabor_cpp_dot(direction, gabor_vec2(x.offset, y.offset)) * value
              - gabor_impl_product(nodes, turn) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return GaborImplBentField{value, gabor_vec2(field.quadrature_gradient.x, field.gradient.x),
                              gabor_vec2(field.quadrature_gradient.y, field.gradient.y), gabor_vec2(-bent.y, bent.x)};
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded; and its derivatives by t
// and by the rounding.
GABOR_INLINE gabor_vec3 gabor_impl_mask(float t, float rounding) {
    float part = t < rounding ? t / rounding : 1.0f; // how far t is into the rounded start
    float s = gabor_cpp_max(1.0f - part * (t - 0.5f * part * rounding), 0.0f), slope = s * part;
    return gabor_vec3(1.0f - s * s, 2.0f * slope, -slope * part);
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + open sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
// `open` is the first mask, and 1 on peaks: it leaves flat valleys as they are, because there gullies would dam them.
// For the exact slope, each quantity is differentiated along x and y: names end in _x and _y, or are vec2(by x, by y).
// A wave vector keeps its length as it turns, so it changes along the slope that its gullies follow.
GABOR_INLINE GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, gabor_vec2 dx, gabor_vec2 dy, GaborTerrain base, GaborErosion erosion,
                             std::uint32_t seed) {
    gabor_vec2 steer = base.slope, steer_x = base.curvature.xy(), steer_y = base.curvature.yz();
    float gully = base.ridge, ridge = base.ridge, sum = 0.0f; // t_i, t_i with w = 1, sum_i depth_i t_i
    gabor_vec2 gully_slope = base.ridge_slope, sum_slope = gabor_vec2(0.0f);
    float frequency = erosion.gully_frequency, depth = erosion.strength / erosion.gully_frequency;
    float mask = 1.0f, open = 1.0f;
    float rounding = gabor_cpp_mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5f + 0.5f * base.ridge);
    gabor_vec2 mask_slope = gabor_vec2(0.0f), open_slope = gabor_vec2(0.0f);
    float rounded = 0.5f * (erosion.ridge_rounding - erosion.crease_rounding), peak = gabor_cpp_clamp(base.ridge, 0.0f, 1.0f);
    gabor_vec2 rounding_slope = rounded * base.ridge_slope;
    float per_onset = 1.0f / gabor_cpp_max(erosion.onset_slope, 1.0e-6f);
    for (int i = 0; i < erosion.octaves; ++i) {
        float steep = gabor_cpp_max(gabor_cpp_length(steer), 1.0e-9f);
        gabor_vec2 down = steer / steep, across = gabor_vec2(-down.y, down.x);
        gabor_vec3 full = gabor_impl_mask(steep * per_onset, rounding);
        gabor_vec2 full_slope = full.y * per_onset * gabor_vec2(gabor_cpp_dot(down, steer_x), gabor_cpp_dot(down, steer_y)) + full.z * rounding_slope;
        mask_slope = full.x * (full.x * mask_slope + 2.0f * mask * full_slope);
        mask *= full.x * full.x;
        if (i == 0) {
            open = gabor_cpp_mix(mask, 1.0f, peak * peak);
            open_slope = (1.0f - peak * peak) * mask_slope + (1.0f - mask) * 2.0f * peak * base.ridge_slope;
        }
        gabor_vec2 wave = frequency * across;
        // The wave changes by -down * bend.
        gabor_vec2 bend = frequency / steep * gabor_vec2(gabor_cpp_dot(across, steer_x), gabor_cpp_dot(across, steer_y));
        gabor_vec2 steps = gabor_vec2(gabor_cpp_dot(wave, dx), gabor_cpp_dot(wave, dy));
        // The share of a wave that a Gaussian filter of standard deviation half a pixel keeps; small shares are 0.
        float share = 1.02f * gabor_cpp_exp(-4.9348022f * gabor_cpp_dot(steps, steps)), kept = gabor_cpp_max(share - 0.02f, 0.0f); // pi^2 / 2
        gabor_vec2 z = gabor_vec2(0.0f), z_x = gabor_vec2(0.0f), z_y = gabor_vec2(0.0f), kept_slope = gabor_vec2(0.0f);
        if (kept > 0.0f) {
            // 1.25 gullies per radius.
            GaborPlace place = gabor_impl_ground(ground, 0.8f * GABOR_CELLS_PER_RADIUS * frequency);
            GaborImplBentField field = gabor_impl_bent_field(place, wave, down, gabor_derived_seed(seed, i));
            z = erosion.uniformity * field.value;
            float shrink = gabor_cpp_inversesqrt(1.0f + gabor_cpp_dot(z, z)); // brings the length of z near 1, except where waves cancel
            z *= shrink;
            z_x = shrink * erosion.uniformity * (field.along_x - bend.x * field.bent);
            z_y = shrink * erosion.uniformity * (field.along_y - bend.y * field.bent);
            kept_slope = 9.8696044f * share * gabor_cpp_dot(steps, gabor_vec2(gabor_cpp_dot(down, dx), gabor_cpp_dot(down, dy))) * bend; // pi^2
            z_x = kept * (z_x - gabor_cpp_dot(z, z_x) * z) + kept_slope.x * z;
            z_y = kept * (z_y - gabor_cpp_dot(z, z_y) * z) + kept_slope.y * z;
            z *= kept;
        }
        float crest = erosion.gully_weight * z.x;
        gully_slope = gabor_cpp_mix(gully_slope, erosion.gully_weight * gabor_vec2(z_x.x, z_y.x), mask) + (crest - gully) * mask_slope;
        gully = gabor_cpp_mix(gully, crest, mask);
        ridge = gabor_cpp_mix(ridge, z.x, mask);
        sum += depth * gully;
        sum_slope += depth * gully_slope;
        float side = z.y < 0.0f ? -1.0f : 1.0f;
        float turns = 6.2831853f * depth * erosion.branching * erosion.gully_weight * side; // 2 pi
        float turn = turns * kept * mask;
        gabor_vec2 turn_slope = turns * (kept * mask_slope + mask * kept_slope);
        steer -= turn * wave;
        steer_x += turn * bend.x * down - turn_slope.x * wave;
        steer_y += turn * bend.y * down - turn_slope.y * wave;
        float wide = frequency / erosion.gully_frequency;
        rounding = gabor_cpp_mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5f + 0.5f * z.x);
        rounding_slope = rounded * gabor_vec2(z_x.x, z_y.x);
        gabor_vec3 edge = gabor_impl_mask(0.5f - 0.5f * kept + gabor_cpp_abs(z.y), wide * rounding);
        gabor_vec2 edge_slope =
            edge.y * side * gabor_vec2(z_x.y, z_y.y) - 0.5f * edge.y * kept_slope + edge.z * wide * rounding_slope;
        float reach = 1.0f / (1.0f + mask * (erosion.detail - 1.0f));
        mask_slope = erosion.detail * reach * (reach * edge.x * mask_slope + mask * edge_slope);
        mask *= erosion.detail * reach * edge.x;
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return GaborTerrain{base.height + open * sum, base.slope + open * sum_slope + sum * open_slope, ridge, gabor_vec3(0.0f),
                        gabor_vec2(0.0f)};
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GABOR_INLINE GaborErosion gabor_erosion() {
    return GaborErosion{5, 1.5f, 0.12f, 2.0f, 0.5f, 0.5f, 1.5f, 2.0f, 0.1f, 0.1f, 0.5f, 1.0f};
}

GABOR_INLINE GaborTerrain gabor_terrain(gabor_vec2 p, std::uint32_t seed) {
    return gabor_terrain_at(GaborTerrainPlace{gabor_ivec2(0), p, gabor_vec2(0.0f)}, gabor_vec2(0.0f), gabor_vec2(0.0f), seed);
}

GABOR_INLINE GaborTerrain gabor_eroded(gabor_vec2 p, GaborTerrain base, GaborErosion erosion, std::uint32_t seed) {
    return gabor_eroded_at(GaborTerrainPlace{gabor_ivec2(0), p, gabor_vec2(0.0f)}, gabor_vec2(0.0f), gabor_vec2(0.0f), base, erosion, seed);
}

GABOR_INLINE gabor_vec4 gabor_ground_cover(GaborTerrain terrain) {
    float steep = gabor_cpp_length(terrain.slope);
    float scree = gabor_cpp_smoothstep(-0.3f, 0.35f, terrain.height + 0.1f * terrain.ridge), rock = gabor_cpp_smoothstep(0.55f, 1.0f, steep);
    float snow = gabor_cpp_smoothstep(0.42f, 0.62f, terrain.height + 0.08f * terrain.ridge) * (1.0f - gabor_cpp_smoothstep(1.0f, 1.9f, steep));
    return gabor_vec4((1.0f - snow) * gabor_vec3((1.0f - rock) * gabor_vec2(1.0f - scree, scree), rock), snow);
}

#endif
