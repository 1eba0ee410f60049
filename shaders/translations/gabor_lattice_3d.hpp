// clang-format off
// gabor_lattice_3d.hpp: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_spectrum.hpp, which has the filter; every name that it adds begins with gabor_, Gabor or GABOR_: for C++ on the CPU.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hpp. Paste or include it after gabor_spectrum.hpp.
//
//     float n = gabor_noise_3d(p, 2.0, vec3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
// As in the plane, of the nodes c of a lattice, R = 3/2 to the kernel radius, the nearest and its neighbours, 27, reach
// a point with their waves under Hann's windows h, times independent normal amplitudes A:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// Whatever the wave vector F is, the variance is 1 at every place: so F may follow a surface, which sees the frequency
// asked for and no trace of the lattice. Several directions are a sum of independent noises, jointly normal like one.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_HPP
#define GABOR_LATTICE_3D_HPP
#ifndef GABOR_SPECTRUM_HPP
#error Include gabor_lattice.hpp and gabor_spectrum.hpp before gabor_lattice_3d.hpp
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

// ---- The noise at a place ------------------------------------------------------------------------------------------

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
GABOR_INLINE gabor_vec3 gabor_impl_unit(gabor_vec3 v) {
    v = gabor_cpp_clamp(v, -1.0e15f, 1.0e15f);
    return v * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(v, v), 1.0e-30f));
}

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z. The
// filter adds mixed derivatives, with its covariances yz, zx, xy.
GABOR_INLINE void gabor_impl_add_slice(gabor_vec4& sum, gabor_vec4& slopes, GaborPlace3d place, GaborAxis x, GaborAxis y, GaborAxis z,
                          int k, gabor_vec3 mixed) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    gabor_vec4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, z.node[k].xy());
    slopes += gabor_vec4(gabor_impl_product(slope.xy(), z.node[k].xy()), gabor_impl_product(slice.xy(), z.node[k].zw()));
    if (place.filtered)
        sum += gabor_vec4(gabor_impl_product(mixed.x * slope.xy() + mixed.y * slice.zw(), z.node[k].zw())
                    + mixed.z * gabor_impl_product(slope.zw(), z.node[k].xy()), 0.0f, 0.0f);
}

// The noise of 27 nodes; filtered by three waves along each axis. E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the
// derivative of a wave is 2 pi i F times it.
GABOR_INLINE GaborField3d gabor_impl_sum_3d(GaborPlace3d place, gabor_vec3 wave, GaborMatrix pixel, std::uint32_t salt) {
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, GABOR_RADIUS);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                  GABOR_RADIUS);
    GaborAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                  GABOR_RADIUS);
    gabor_vec2 turn = gabor_cpp_inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
              * gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    if (place.filtered) {
        gabor_vec3 blurred = gabor_impl_symmetric_3d(pixel, wave);
        gabor_impl_filter(x, pixel.diagonal.x, blurred.x);
        gabor_impl_filter(y, pixel.diagonal.y, blurred.y);
        gabor_impl_filter(z, pixel.diagonal.z, blurred.z);
        turn *= gabor_cpp_exp(-19.739209f * gabor_cpp_dot(wave, blurred));
    }
    gabor_vec4 sum = gabor_vec4(0.0f), slopes = gabor_vec4(0.0f);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 0, pixel.mixed);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 1, pixel.mixed);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 2, pixel.mixed);
    sum = gabor_vec4(gabor_impl_product(sum.xy(), turn), gabor_impl_product(sum.zw(), turn));
    slopes = gabor_vec4(gabor_impl_product(slopes.xy(), turn), gabor_impl_product(slopes.zw(), turn));
    return GaborField3d{sum.y, gabor_vec3(sum.w, slopes.y, slopes.w) + 6.2831853f * sum.x * wave,
                        sum.x, gabor_vec3(sum.z, slopes.x, slopes.z) - 6.2831853f * sum.y * wave, 0.0f};
}

GABOR_INLINE void gabor_impl_accumulate_3d(GaborField3d& sum, GaborField3d field, float amplitude) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * field.quadrature_gradient;
}

// The share of its variance that a lobe keeps, of a pixel whose axes are at right angles: see gabor_impl_transmitted.
GABOR_INLINE float gabor_impl_transmitted_3d(gabor_vec3 wave, gabor_vec3 major, gabor_vec3 minor) {
    gabor_vec2 d = 1.0f + 1.6449341f * gabor_vec2(gabor_cpp_dot(major, major), gabor_cpp_dot(minor, minor));
    gabor_vec2 k = gabor_vec2(gabor_cpp_dot(wave, major), gabor_cpp_dot(wave, minor));
    return gabor_cpp_exp(-gabor_cpp_min(9.8696044f * gabor_cpp_dot(k * k, 1.0f / d), 80.0f)) * gabor_cpp_inversesqrt(d.x * d.y);
}

// The covariance of the place's pixel; beyond a deviation of 1/2 that at 1/2, at which noise has the amplitude that is
// left. And the share of its variance that the noise keeps.
GABOR_INLINE GaborMatrix gabor_impl_pixel(GaborPlace3d place, gabor_vec3 wave, gabor_vec3 stretch, float& amplitude, float& transmitted) {
    gabor_vec3 dx = gabor_cpp_clamp(place.dx, -1.0e6f, 1.0e6f) * stretch;
    gabor_vec3 dy = gabor_cpp_clamp(place.dy, -1.0e6f, 1.0e6f) * stretch;
    gabor_vec2 twice = gabor_vec2(gabor_cpp_dot(dx, dx) - gabor_cpp_dot(dy, dy), 2.0f * gabor_cpp_dot(dx, dy)); // its axes are turned by half of that angle
    float cosine = twice.x / gabor_cpp_max(gabor_cpp_length(twice), 1.0e-30f);
    gabor_vec2 turn = gabor_cpp_sqrt(gabor_cpp_max(0.5f + gabor_vec2(0.5f, -0.5f) * cosine, 0.0f));
    if (twice.y < 0.0f) turn.y = -turn.y;
    gabor_vec3 major = turn.x * dx + turn.y * dy;
    gabor_vec3 minor = turn.x * dy - turn.y * dx;
    transmitted = gabor_impl_transmitted_3d(wave, major, minor);
    major *= gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(major, major), 1.0f));
    minor *= gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(minor, minor), 1.0f));
    amplitude = gabor_cpp_sqrt(transmitted / gabor_impl_transmitted_3d(wave, major, minor));
    if (!(transmitted > 1.0e-10f)) transmitted = 0.0f; // or not a number
    return GaborMatrix{0.25f * (major * major + minor * minor),
                       0.25f * (major.yzx() * major.zxy() + minor.yzx() * minor.zxy())};
}

// With periods, whose nodes are not 1 / GABOR_RADIUS apart, everything counts in units of GABOR_RADIUS nodes.
GABOR_INLINE GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    gabor_vec3 wave = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f) * gabor_impl_unit(direction) / stretch;
    std::uint32_t salt = gabor_impl_salt(seed);
    float amplitude = 1.0f, transmitted = 1.0f, wide = 0.0f;
    GaborMatrix pixel = GaborMatrix{gabor_vec3(0.0f), gabor_vec3(0.0f)};
    if (place.filtered) {
        pixel = gabor_impl_pixel(place, wave, stretch, amplitude, transmitted);
        gabor_vec3 variance = pixel.diagonal;
        wide = gabor_cpp_clamp(100.0f * gabor_cpp_sqrt(gabor_cpp_max(gabor_cpp_max(variance.x, variance.y), variance.z)) - 9.0f, 0.0f, 1.0f);
    }
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f - transmitted};
    if (transmitted == 0.0f)
        return sum;
    if (wide < 1.0f)
        gabor_impl_accumulate_3d(sum, gabor_impl_sum_3d(place, wave, pixel, salt), (1.0f - wide) * amplitude);
    if (wide > 0.0f) {
        gabor_vec4 noise, quadrature;
        gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.time, wave, pixel,
                                  wide > 0.0f, salt, noise, quadrature);
        gabor_impl_accumulate_3d(sum, GaborField3d{noise.x, noise.yzw(), quadrature.x, quadrature.yzw(), 0.0f},
                                 wide * amplitude);
    }
    sum.gradient *= stretch;
    sum.quadrature_gradient *= stretch;
    return sum;
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
GABOR_INLINE void gabor_impl_add_term(GaborField3d& sum, GaborPlace3d place, float frequency, gabor_vec3 direction, std::uint32_t seed,
                         int index, float power) {
    GaborField3d term = gabor_field_3d(place, frequency, direction, gabor_lobe_seed(seed, index));
    gabor_impl_accumulate_3d(sum, term, gabor_cpp_sqrt(power));
    sum.removed += power * term.removed;
}

// Of directions evenly in a range, a real number `count` of them, the last in what is left of it: the place of number
// `index`, from 0 to 1, and its power. That is nearly in proportion to its size, but falls to 0 as the square of that: in
// proportion, the amplitude, its root, would begin with an infinite slope.
GABOR_INLINE gabor_vec2 gabor_impl_direction(int index, float count) {
    gabor_vec2 size = gabor_vec2(gabor_cpp_min(count - float(index), 1.0f), gabor_cpp_fract(count)); // of this one, and of the last
    gabor_vec2 power = size * size * 1.05f / (size + 0.05f);
    return gabor_vec2((float(index) + 0.5f * size.x) / count, power.x / (gabor_cpp_floor(count) + power.y));
}

// Directions evenly on a spiral over half the sphere.
GABOR_INLINE GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, std::uint32_t seed) {
    float count = 8.0f + 8.0f * gabor_cpp_min(frequency * frequency, 64.0f);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = 0; i < int(gabor_cpp_ceil(count)); ++i) {
        gabor_vec2 part = gabor_impl_direction(i, count);
        gabor_vec3 direction = gabor_vec3(gabor_cpp_sqrt(1.0f - part.x * part.x) * gabor_impl_wave(0.61803399f * float(i)), part.x);
        gabor_impl_add_term(sum, place, frequency, direction, seed, i, part.y);
    }
    return sum;
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
GABOR_INLINE GaborField3d gabor_surface_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    gabor_vec3 other = gabor_cpp_cross(direction, gabor_cpp_abs(direction.z) < 0.7f ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f));
    direction -= gabor_cpp_dot(direction, normal) * normal;
    other -= gabor_cpp_dot(other, normal) * normal;
    float power = gabor_impl_takeover(gabor_cpp_smoothstep(0.0625f, 0.25f, gabor_cpp_dot(direction, direction)));
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = power > 0.0f ? 0 : 1; i < (power < 1.0f ? 2 : 1); ++i)
        gabor_impl_add_term(sum, place, frequency, i == 0 ? direction : other, seed, i, i == 0 ? power : 1.0f - power);
    return sum;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
GABOR_INLINE GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0f + 4.5f * gabor_cpp_min(gabor_cpp_abs(frequency), 32.0f);
    float power = gabor_impl_takeover(gabor_cpp_smoothstep(0.25f, 0.5f, gabor_cpp_dot(normal.xy(), normal.xy())));
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int axis = 0; axis < 2; ++axis) {
        gabor_vec3 along = gabor_impl_unit(gabor_cpp_cross(axis == 0 ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f), normal));
        for (int i = 0; i < int(gabor_cpp_ceil(count)) && power > 0.0f; ++i) {
            gabor_vec2 part = gabor_impl_direction(i, count);
            gabor_vec2 turn = gabor_impl_wave(0.5f * part.x);
            gabor_vec3 direction = turn.x * along + turn.y * gabor_cpp_cross(normal, along);
            gabor_impl_add_term(sum, place, frequency, direction, seed, 256 * axis + i, power * part.y);
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
// The filter and its accuracy are those of gabor_noise_filtered: 1 % up to a third of a kernel radius along the pixel's
// longest axis, 2 % up to a whole one. Continuous in the place and in both steps. On GPUs 1.4 times gabor_noise_3d up to
// steps of 0.18, with 27 nodes; from 0.2 on 4.2 times, with 64, and up to 6.6 times with 125.
GABOR_INLINE gabor_vec2 gabor_noise_3d_filtered(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = GaborPlace3d{gabor_ivec3(0), p * GABOR_RADIUS, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f,
                                      true, dx, dy};
    GaborField3d field = gabor_field_3d(place, frequency, direction, seed);
    return gabor_vec2(field.noise, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises, rounded up, for a frequency F of at most 8, and no more
// beyond. Its power differs between directions by 14 % (root mean square) at F = 0.5, 16 % at 1 and 25 % at 4.
GABOR_INLINE float gabor_noise_3d_isotropic(gabor_vec3 p, float frequency, std::uint32_t seed) {
    return gabor_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, seed).noise;
}

// Noise on a surface at its point p, whose normal has any length from 10^-15 to 10^15, its waves along the projection of a direction: one
// noise, two where that is 14 to 30 degrees from the normal. Where the surface is curved the waves of a kernel bend.
GABOR_INLINE float gabor_noise_surface(gabor_vec3 p, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_surface_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

// The same along all directions of the tangent plane: 2 + 4.5 F noises, F up to 32, twice as many 30 to 45 degrees from z.
GABOR_INLINE float gabor_noise_surface_isotropic(gabor_vec3 p, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_LATTICE_3D_HPP
