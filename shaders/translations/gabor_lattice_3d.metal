// gabor_lattice_3d.metal: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.metal; every name that it adds begins with gabor_, Gabor or GABOR_: for the Metal shading language.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.metal.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_METAL
#define GABOR_LATTICE_3D_METAL

#include <metal_stdlib>

using namespace metal;
#ifndef GABOR_LATTICE_METAL
#error Include gabor_lattice.metal before gabor_lattice_3d.metal
#elif GABOR_TAPS != 3
#error gabor_lattice_3d.metal needs GABOR_TAPS 3
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    int3 cell;
    float3 local;
    float3 radius;
    int3 period;
    bool animated;
    float time;
    bool filtered; // whether to average over the pixel whose sides are dx and dy: see gabor_noise_3d_filtered
    float3 dx;
    float3 dy;
};

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
inline GaborPlace3d gabor_place_3d(int3 cell, float3 local) {
    return GaborPlace3d{cell, local, float3(GABOR_RADIUS), int3(0), false, 0.0, false, float3(0.0), float3(0.0)};
}

// The noise and its quadrature, each with its gradient per kernel radius. Apart, so that compilers drop unused ones.
struct GaborField3d {
    float noise;
    float3 gradient;
    float quadrature;
    float3 quadrature_gradient;
    float removed; // variance that the average over the pixel takes away
};

#define GABOR_IMPL_SLICES 0x27d4eb2fu // as GABOR_IMPL_ROWS
// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
inline uint gabor_impl_slice_word(uint row, uint slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// ---- The filter ----------------------------------------------------------------------------------------------------

// A complex number for each of 27 nodes or waves, in the order of three indices.
struct GaborCube {
    float2 number[27];
};

// Takes the first index from the nodes along an axis to the three waves that they are together between nodes, and makes
// it the last: for a = -1, 0, 1 a node adds e^(pi i a d) / 4 = (h - 1/2 - i a h' / pi) / 2, 1/2 and again the first of
// its window h(d). Within half a deviation of the filter from the window's end it fades, so that nothing jumps.
inline GaborCube gabor_impl_to_waves(GaborCube nodes, GaborAxis axis, float deviation) {
    float4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    float2 phase[3];
    for (int i = 0; i < 3; ++i) {
        float inside = 1.0 - abs(axis.offset + 1.0 - float(i)) / GABOR_RADIUS;
        float fade = smoothstep(0.0, max(0.5 * deviation, 1.0e-6), inside);
        phase[i] = 0.5 * fade * gabor_impl_wave(float(1 - i) * axis.turns);
    }
    GaborCube waves;
    for (int n = 0; n < 9; ++n) {
        float2 mean = float2(0.0), even = float2(0.0), odd = float2(0.0);
        for (int i = 0; i < 3; ++i) {
            float2 node = gabor_impl_product(nodes.number[9 * i + n], phase[i]);
            mean += node;
            even += (value[i] - 0.5) * node;
            odd += 0.31830989 * slope[i] * float2(node.y, -node.x);
        }
        waves.number[3 * n] = even - odd;
        waves.number[3 * n + 1] = mean;
        waves.number[3 * n + 2] = even + odd;
    }
    return waves;
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: |det(1 + i S)|^(-1/2).
inline GaborField3d gabor_impl_filtered(GaborPlace3d place, float3 wave, GaborAxis x, GaborAxis y, GaborAxis z, float2 turn) {
    float3 dx = clamp(place.dx, -1.0e6, 1.0e6);
    float3 dy = clamp(place.dy, -1.0e6, 1.0e6);
    float trace = 0.25 * (dot(dx, dx) + dot(dy, dy));
    float determinant = 0.0625 * dot(cross(dx, dy), cross(dx, dy));
    float fade = rsqrt(length(float2(trace, 1.0 - determinant)));
    float3 spacing = 0.5 * place.radius / GABOR_RADIUS; // of waves
    GaborCube cube;
    for (int n = 0; n < 27; ++n) {
        uint row = gabor_impl_slice_word(y.word[n / 3 % 3], z.word[n / 9]);
        cube.number[n] = gabor_impl_amplitude_at(x.word[n % 3] * row, place.animated, place.time);
    }
    cube = gabor_impl_to_waves(cube, z, spacing.z * length(float2(dx.z, dy.z)));
    cube = gabor_impl_to_waves(cube, y, spacing.y * length(float2(dx.y, dy.y)));
    cube = gabor_impl_to_waves(cube, x, spacing.x * length(float2(dx.x, dy.x)));
    GaborField3d sum = GaborField3d{0.0, float3(0.0), 0.0, float3(0.0), 1.0};
    for (int n = 0; n < 27; ++n) {
        float3 aside = float3(float(n % 3), float(n / 3 % 3), float(n / 9)) - 1.0;
        float3 k = wave + spacing * aside;
        float left = fade * exp(-4.934802 * (dot(k, dx) * dot(k, dx) + dot(k, dy) * dot(k, dy)));
        float2 value = left * gabor_impl_product(cube.number[n], turn);
        sum.noise += value.y;
        sum.gradient += 6.2831853 * value.x * k;
        sum.quadrature += value.x;
        sum.quadrature_gradient -= 6.2831853 * value.y * k;
        sum.removed -= 8.0 / 27.0 * left * left * exp2(-2.0 * dot(aside, aside));
    }
    return sum;
}

// ---- The noise at a place ------------------------------------------------------------------------------------------

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
inline float3 gabor_impl_unit(float3 v) {
    v = clamp(v, -1.0e15, 1.0e15);
    return v * rsqrt(max(dot(v, v), 1.0e-30));
}

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z.
inline void gabor_impl_add_slice(thread float4& sum, thread float4& slopes, GaborPlace3d place, GaborAxis x, GaborAxis y, GaborAxis z,
                          int k) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    float4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, z.node[k].xy);
    slopes += float4(gabor_impl_product(slope.xy, z.node[k].xy), gabor_impl_product(slice.xy, z.node[k].zw));
}

// E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the derivative of a wave is 2 pi i F times it.
inline GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, float3 direction, uint seed) {
    float3 wave = min(abs(frequency), 1.0e6) * gabor_impl_unit(direction);
    uint salt = gabor_impl_salt(seed);
    uint rows = salt ^ GABOR_IMPL_ROWS, slices = salt ^ GABOR_IMPL_SLICES;
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, place.radius.x);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, rows, wave.y, place.radius.y);
    GaborAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, slices, wave.z, place.radius.z);
    float2 turn = rsqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
              * gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    if (place.filtered)
        return gabor_impl_filtered(place, wave, x, y, z, turn);
    float4 sum = float4(0.0), slopes = float4(0.0);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 0);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 1);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 2);
    sum = float4(gabor_impl_product(sum.xy, turn), gabor_impl_product(sum.zw, turn));
    slopes = float4(gabor_impl_product(slopes.xy, turn), gabor_impl_product(slopes.zw, turn));
    float3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d{sum.y, stretch * float3(sum.w, slopes.y, slopes.w) + 6.2831853 * sum.x * wave,
                        sum.x, stretch * float3(sum.z, slopes.x, slopes.z) - 6.2831853 * sum.y * wave, 0.0};
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
inline void gabor_impl_add_term(thread GaborField3d& sum, GaborPlace3d place, float frequency, float3 direction, uint seed,
                         int index, float power) {
    GaborField3d term = gabor_field_3d(place, frequency, direction, gabor_lobe_seed(seed, index));
    sum.noise += sqrt(power) * term.noise;
    sum.gradient += sqrt(power) * term.gradient;
    sum.quadrature += sqrt(power) * term.quadrature;
    sum.quadrature_gradient += sqrt(power) * term.quadrature_gradient;
    sum.removed += power * term.removed;
}

// Directions evenly on a spiral over half the sphere, a real number of them: the last has what is left of the power.
inline GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, uint seed) {
    float count = 8.0 + 8.0 * min(frequency * frequency, 64.0);
    GaborField3d sum = GaborField3d{0.0, float3(0.0), 0.0, float3(0.0), 0.0};
    for (int i = 0; i < int(ceil(count)); ++i) {
        float share = min(count - float(i), 1.0) / count, z = float(i) / count + 0.5 * share;
        float3 direction = float3(sqrt(1.0 - z * z) * gabor_impl_wave(0.61803399 * float(i)), z);
        gabor_impl_add_term(sum, place, frequency, direction, seed, i, share);
    }
    return sum;
}

// The power of the first of two sums where it takes over from the second as x goes from `low` to `high`.
inline float gabor_impl_takeover(float low, float high, float x) {
    float share = smoothstep(low, high, x);
    return share * share / (share * share + (1.0 - share) * (1.0 - share));
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
inline GaborField3d gabor_surface_3d(GaborPlace3d place, float3 normal, float frequency, float3 direction, uint seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    float3 other = cross(direction, abs(direction.z) < 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float power = gabor_impl_takeover(0.0625, 0.25, dot(direction, direction));
    GaborField3d sum = GaborField3d{0.0, float3(0.0), 0.0, float3(0.0), 0.0};
    for (int i = power > 0.0 ? 0 : 1; i < (power < 1.0 ? 2 : 1); ++i)
        gabor_impl_add_term(sum, place, frequency, i == 0 ? direction : other, seed, i, i == 0 ? power : 1.0 - power);
    return sum;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
inline GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, float3 normal, float frequency, uint seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0 + 4.5 * min(abs(frequency), 32.0);
    float power = gabor_impl_takeover(0.25, 0.5, dot(normal.xy, normal.xy));
    GaborField3d sum = GaborField3d{0.0, float3(0.0), 0.0, float3(0.0), 0.0};
    for (int axis = 0; axis < 2; ++axis) {
        float3 along = gabor_impl_unit(cross(axis == 0 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0), normal));
        for (int i = 0; i < int(ceil(count)) && power > 0.0; ++i) {
            float share = min(count - float(i), 1.0) / count;
            float2 turn = gabor_impl_wave(0.5 * (float(i) / count + 0.5 * share));
            float3 direction = turn.x * along + turn.y * cross(normal, along);
            gabor_impl_add_term(sum, place, frequency, direction, seed, 256 * axis + i, power * share);
        }
        power = 1.0 - power;
    }
    return sum;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p, frequency, seed  as for gabor_noise
//   direction           of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
inline float gabor_noise_3d(float3 p, float frequency, float3 direction, uint seed) {
    return gabor_field_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), frequency, direction, seed).noise;
}

// The same with its gradient: (noise, d/dx, d/dy, d/dz). For bumps take away the part of it along the normal.
inline float4 gabor_noise_3d_gradient(float3 p, float frequency, float3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return float4(field.noise, field.gradient);
}

// (quadrature, noise), for gabor_phasor: see gabor_noise_complex.
inline float2 gabor_noise_3d_complex(float3 p, float frequency, float3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return float2(field.quadrature, field.noise);
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
inline float4 gabor_noise_3d_four(float3 p, float frequency, float3 direction, uint seed) {
    return float4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
inline float gabor_noise_3d_tiled(float3 p, float3 period, float frequency, float3 direction, uint seed) {
    period = clamp(period, 0.0009765625, 1.0e9);
    float3 nodes = max(floor(period * GABOR_RADIUS + 0.5), float3(3.0));
    GaborPlace3d place = gabor_place_3d(int3(0), (p - floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = int3(nodes);
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
inline float gabor_noise_3d_animated(float3 p, float time, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = GaborPlace3d{int3(0), p * GABOR_RADIUS, float3(GABOR_RADIUS), int3(0), true, time,
                                      false, float3(0.0), float3(0.0)};
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
inline float2 gabor_noise_3d_filtered(float3 p, float3 dx, float3 dy, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = GaborPlace3d{int3(0), p * GABOR_RADIUS, float3(GABOR_RADIUS), int3(0), false, 0.0,
                                      true, dx, dy};
    GaborField3d field = gabor_field_3d(place, frequency, direction, seed);
    return float2(field.noise, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises for a frequency F of at most 8, and no more beyond.
inline float gabor_noise_3d_isotropic(float3 p, float frequency, uint seed) {
    return gabor_isotropic_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), frequency, seed).noise;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction: one
// noise, two where that is 14 to 30 degrees from the normal. Where the surface is curved the waves of a kernel bend.
inline float gabor_noise_surface(float3 p, float3 normal, float frequency, float3 direction, uint seed) {
    return gabor_surface_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

// The same along all directions of the tangent plane: 2 + 4.5 F noises, F up to 32, twice as many 30 to 45 degrees from z.
inline float gabor_noise_surface_isotropic(float3 p, float3 normal, float frequency, uint seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d(int3(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_LATTICE_3D_METAL
