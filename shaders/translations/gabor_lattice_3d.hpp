// clang-format off
// gabor_lattice_3d.hpp: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.hpp; every name that it adds begins with gabor_, Gabor or GABOR_: for C++ on the CPU.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hpp.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_HPP
#define GABOR_LATTICE_3D_HPP
#ifndef GABOR_LATTICE_HPP
#error Include gabor_lattice.hpp before gabor_lattice_3d.hpp
#elif GABOR_TAPS != 3
#error gabor_lattice_3d.hpp needs GABOR_TAPS 3
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    gabor_ivec3 cell;
    gabor_vec3 local;
    gabor_vec3 radius;
    gabor_ivec3 period;
    bool animated;
    float time;
    bool filtered; // whether to average over the pixel whose sides are dx and dy: see gabor_noise_3d_filtered
    gabor_vec3 dx;
    gabor_vec3 dy;
};

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GABOR_INLINE GaborPlace3d gabor_place_3d(gabor_ivec3 cell, gabor_vec3 local) {
    return GaborPlace3d{cell, local, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f, false, gabor_vec3(0.0f), gabor_vec3(0.0f)};
}

// The noise and its quadrature, each with its gradient per kernel radius. Apart, so that compilers drop unused ones.
struct GaborField3d {
    float noise;
    gabor_vec3 gradient;
    float quadrature;
    gabor_vec3 quadrature_gradient;
    float removed; // variance that the average over the pixel takes away
};

#define GABOR_IMPL_SLICES 0x27d4eb2fu // as GABOR_IMPL_ROWS
// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
GABOR_INLINE std::uint32_t gabor_impl_slice_word(std::uint32_t row, std::uint32_t slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// ---- The filter ----------------------------------------------------------------------------------------------------

// A complex number for each of 27 nodes or waves, in the order of three indices.
struct GaborCube {
    gabor_vec2 number[27];
};

// Takes the first index from the nodes along an axis to the three waves that they are together between nodes, and makes
// it the last: for a = -1, 0, 1 a node adds e^(pi i a d) / 4 = (h - 1/2 - i a h' / pi) / 2, 1/2 and again the first of
// its window h(d). Within half a deviation of the filter from the window's end it fades, so that nothing jumps.
GABOR_INLINE GaborCube gabor_impl_to_waves(GaborCube nodes, GaborAxis axis, float deviation) {
    gabor_vec4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    gabor_vec2 phase[3];
    for (int i = 0; i < 3; ++i) {
        float inside = 1.0f - gabor_cpp_abs(axis.offset + 1.0f - float(i)) / GABOR_RADIUS;
        float fade = gabor_cpp_smoothstep(0.0f, gabor_cpp_max(0.5f * deviation, 1.0e-6f), inside);
        phase[i] = 0.5f * fade * gabor_impl_wave(float(1 - i) * axis.turns);
    }
    GaborCube waves;
    for (int n = 0; n < 9; ++n) {
        gabor_vec2 mean = gabor_vec2(0.0f), even = gabor_vec2(0.0f), odd = gabor_vec2(0.0f);
        for (int i = 0; i < 3; ++i) {
            gabor_vec2 node = gabor_impl_product(nodes.number[9 * i + n], phase[i]);
            mean += node;
            even += (value[i] - 0.5f) * node;
            odd += 0.31830989f * slope[i] * gabor_vec2(node.y, -node.x);
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
GABOR_INLINE GaborField3d gabor_impl_filtered(GaborPlace3d place, gabor_vec3 wave, GaborAxis x, GaborAxis y, GaborAxis z, gabor_vec2 turn) {
    gabor_vec3 dx = gabor_cpp_clamp(place.dx, -1.0e6f, 1.0e6f);
    gabor_vec3 dy = gabor_cpp_clamp(place.dy, -1.0e6f, 1.0e6f);
    float trace = 0.25f * (gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy));
    float determinant = 0.0625f * gabor_cpp_dot(gabor_cpp_cross(dx, dy), gabor_cpp_cross(dx, dy));
    float fade = gabor_cpp_inversesqrt(gabor_cpp_length(gabor_vec2(trace, 1.0f - determinant)));
    gabor_vec3 spacing = 0.5f * place.radius / GABOR_RADIUS; // of waves
    GaborCube cube;
    for (int n = 0; n < 27; ++n) {
        std::uint32_t row = gabor_impl_slice_word(y.word[n / 3 % 3], z.word[n / 9]);
        cube.number[n] = gabor_impl_amplitude_at(x.word[n % 3] * row, place.animated, place.time);
    }
    cube = gabor_impl_to_waves(cube, z, spacing.z * gabor_cpp_length(gabor_vec2(dx.z, dy.z)));
    cube = gabor_impl_to_waves(cube, y, spacing.y * gabor_cpp_length(gabor_vec2(dx.y, dy.y)));
    cube = gabor_impl_to_waves(cube, x, spacing.x * gabor_cpp_length(gabor_vec2(dx.x, dy.x)));
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f};
    for (int n = 0; n < 27; ++n) {
        gabor_vec3 aside = gabor_vec3(float(n % 3), float(n / 3 % 3), float(n / 9)) - 1.0f;
        gabor_vec3 k = wave + spacing * aside;
        float left = fade * gabor_cpp_exp(-4.934802f * (gabor_cpp_dot(k, dx) * gabor_cpp_dot(k, dx) + gabor_cpp_dot(k, dy) * gabor_cpp_dot(k, dy)));
        gabor_vec2 value = left * gabor_impl_product(cube.number[n], turn);
        sum.noise += value.y;
        sum.gradient += 6.2831853f * value.x * k;
        sum.quadrature += value.x;
        sum.quadrature_gradient -= 6.2831853f * value.y * k;
        sum.removed -= 8.0f / 27.0f * left * left * gabor_cpp_exp2(-2.0f * gabor_cpp_dot(aside, aside));
    }
    return sum;
}

// ---- The noise at a place ------------------------------------------------------------------------------------------

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
GABOR_INLINE gabor_vec3 gabor_impl_unit(gabor_vec3 v) {
    v = gabor_cpp_clamp(v, -1.0e15f, 1.0e15f);
    return v * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(v, v), 1.0e-30f));
}

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z.
GABOR_INLINE void gabor_impl_add_slice(gabor_vec4& sum, gabor_vec4& slopes, GaborPlace3d place, GaborAxis x, GaborAxis y, GaborAxis z,
                          int k) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    gabor_vec4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, z.node[k].xy());
    slopes += gabor_vec4(gabor_impl_product(slope.xy(), z.node[k].xy()), gabor_impl_product(slice.xy(), z.node[k].zw()));
}

// E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the derivative of a wave is 2 pi i F times it.
GABOR_INLINE GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    gabor_vec3 wave = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f) * gabor_impl_unit(direction);
    std::uint32_t salt = gabor_impl_salt(seed);
    std::uint32_t rows = salt ^ GABOR_IMPL_ROWS, slices = salt ^ GABOR_IMPL_SLICES;
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, place.radius.x);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, rows, wave.y, place.radius.y);
    GaborAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, slices, wave.z, place.radius.z);
    gabor_vec2 turn = gabor_cpp_inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
              * gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    if (place.filtered)
        return gabor_impl_filtered(place, wave, x, y, z, turn);
    gabor_vec4 sum = gabor_vec4(0.0f), slopes = gabor_vec4(0.0f);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 0);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 1);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 2);
    sum = gabor_vec4(gabor_impl_product(sum.xy(), turn), gabor_impl_product(sum.zw(), turn));
    slopes = gabor_vec4(gabor_impl_product(slopes.xy(), turn), gabor_impl_product(slopes.zw(), turn));
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d{sum.y, stretch * gabor_vec3(sum.w, slopes.y, slopes.w) + 6.2831853f * sum.x * wave,
                        sum.x, stretch * gabor_vec3(sum.z, slopes.x, slopes.z) - 6.2831853f * sum.y * wave, 0.0f};
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
GABOR_INLINE void gabor_impl_add_term(GaborField3d& sum, GaborPlace3d place, float frequency, gabor_vec3 direction, std::uint32_t seed,
                         int index, float power) {
    GaborField3d term = gabor_field_3d(place, frequency, direction, gabor_lobe_seed(seed, index));
    sum.noise += gabor_cpp_sqrt(power) * term.noise;
    sum.gradient += gabor_cpp_sqrt(power) * term.gradient;
    sum.quadrature += gabor_cpp_sqrt(power) * term.quadrature;
    sum.quadrature_gradient += gabor_cpp_sqrt(power) * term.quadrature_gradient;
    sum.removed += power * term.removed;
}

// Directions evenly on a spiral over half the sphere, a real number of them: the last has what is left of the power.
GABOR_INLINE GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, std::uint32_t seed) {
    float count = 8.0f + 8.0f * gabor_cpp_min(frequency * frequency, 64.0f);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = 0; i < int(gabor_cpp_ceil(count)); ++i) {
        float share = gabor_cpp_min(count - float(i), 1.0f) / count, z = float(i) / count + 0.5f * share;
        gabor_vec3 direction = gabor_vec3(gabor_cpp_sqrt(1.0f - z * z) * gabor_impl_wave(0.61803399f * float(i)), z);
        gabor_impl_add_term(sum, place, frequency, direction, seed, i, share);
    }
    return sum;
}

// The power of the first of two sums where it takes over from the second as x goes from `low` to `high`.
GABOR_INLINE float gabor_impl_takeover(float low, float high, float x) {
    float share = gabor_cpp_smoothstep(low, high, x);
    return share * share / (share * share + (1.0f - share) * (1.0f - share));
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
GABOR_INLINE GaborField3d gabor_surface_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    gabor_vec3 other = gabor_cpp_cross(direction, gabor_cpp_abs(direction.z) < 0.7f ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f));
    direction -= gabor_cpp_dot(direction, normal) * normal;
    other -= gabor_cpp_dot(other, normal) * normal;
    float power = gabor_impl_takeover(0.0625f, 0.25f, gabor_cpp_dot(direction, direction));
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = power > 0.0f ? 0 : 1; i < (power < 1.0f ? 2 : 1); ++i)
        gabor_impl_add_term(sum, place, frequency, i == 0 ? direction : other, seed, i, i == 0 ? power : 1.0f - power);
    return sum;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
GABOR_INLINE GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0f + 4.5f * gabor_cpp_min(gabor_cpp_abs(frequency), 32.0f);
    float power = gabor_impl_takeover(0.25f, 0.5f, gabor_cpp_dot(normal.xy(), normal.xy()));
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int axis = 0; axis < 2; ++axis) {
        gabor_vec3 along = gabor_impl_unit(gabor_cpp_cross(axis == 0 ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f), normal));
        for (int i = 0; i < int(gabor_cpp_ceil(count)) && power > 0.0f; ++i) {
            float share = gabor_cpp_min(count - float(i), 1.0f) / count;
            gabor_vec2 turn = gabor_impl_wave(0.5f * (float(i) / count + 0.5f * share));
            gabor_vec3 direction = turn.x * along + turn.y * gabor_cpp_cross(normal, along);
            gabor_impl_add_term(sum, place, frequency, direction, seed, 256 * axis + i, power * share);
        }
        power = 1.0f - power;
    }
    return sum;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p, frequency, seed  as for gabor_noise
//   direction           of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
GABOR_INLINE float gabor_noise_3d(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed).noise;
}

// The same with its gradient: (noise, d/dx, d/dy, d/dz). For bumps take away the part of it along the normal.
GABOR_INLINE gabor_vec4 gabor_noise_3d_gradient(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return gabor_vec4(field.noise, field.gradient);
}

// (quadrature, noise), for gabor_phasor: see gabor_noise_complex.
GABOR_INLINE gabor_vec2 gabor_noise_3d_complex(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return gabor_vec2(field.quadrature, field.noise);
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
GABOR_INLINE gabor_vec4 gabor_noise_3d_four(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_vec4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
GABOR_INLINE float gabor_noise_3d_tiled(gabor_vec3 p, gabor_vec3 period, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    period = gabor_cpp_clamp(period, 0.0009765625f, 1.0e9f);
    gabor_vec3 nodes = gabor_cpp_max(gabor_cpp_floor(period * GABOR_RADIUS + 0.5f), gabor_vec3(3.0f));
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), (p - gabor_cpp_floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = gabor_ivec3(nodes);
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
GABOR_INLINE float gabor_noise_3d_animated(gabor_vec3 p, float time, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = GaborPlace3d{gabor_ivec3(0), p * GABOR_RADIUS, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), true, time,
                                      false, gabor_vec3(0.0f), gabor_vec3(0.0f)};
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
GABOR_INLINE gabor_vec2 gabor_noise_3d_filtered(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = GaborPlace3d{gabor_ivec3(0), p * GABOR_RADIUS, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f,
                                      true, dx, dy};
    GaborField3d field = gabor_field_3d(place, frequency, direction, seed);
    return gabor_vec2(field.noise, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises for a frequency F of at most 8, and no more beyond.
GABOR_INLINE float gabor_noise_3d_isotropic(gabor_vec3 p, float frequency, std::uint32_t seed) {
    return gabor_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, seed).noise;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction: one
// noise, two where that is 14 to 30 degrees from the normal. Where the surface is curved the waves of a kernel bend.
GABOR_INLINE float gabor_noise_surface(gabor_vec3 p, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_surface_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

// The same along all directions of the tangent plane: 2 + 4.5 F noises, F up to 32, twice as many 30 to 45 degrees from z.
GABOR_INLINE float gabor_noise_surface_isotropic(gabor_vec3 p, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_LATTICE_3D_HPP
