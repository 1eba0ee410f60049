// clang-format off
// Generated from gabor_noise_3d.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
//
// gabor_noise_3d.hpp: Gabor noise in space, and on surfaces without texture coordinates, with mean 0, variance 1 and
// a normal distribution at every point.
//
// Paste or include this file after gabor_noise.hpp and gabor_spectrum.hpp, with GABOR_TAPS 3, the default.
//
//     float n = gabor_noise_3d_isotropic(p, 2.0, 7u);                   // 2 cycles per kernel radius, seed 7
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
//
// Arguments of all functions, besides those of gabor_noise.hpp:
//     direction  a vector along the wave vector, of any length from 10^-15 to 10^15; (0, 0, 0) gives noise of
//                frequency 0
//     normal     normal of the surface, of any length from 10^-15 to 10^15
//     dx, dy     change of p, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// All may vary with p; where they are continuous, so is the noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#include "gabor_vectors.hpp"

#ifndef GABOR_NOISE_3D_HPP
#define GABOR_NOISE_3D_HPP
#ifndef GABOR_SPECTRUM_HPP
#error Include gabor_noise.hpp and gabor_spectrum.hpp before gabor_noise_3d.hpp
#elif GABOR_TAPS != 3
#error gabor_noise_3d.hpp needs GABOR_TAPS 3
#endif

// ---- Solid noise with one wave vector ------------------------------------------------------------------------------

// float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed)
// float gabor_noise_3d_tiled(vec3 p, vec3 period, float frequency, vec3 direction, uint seed)
//     The noise, with continuous first derivatives.

// float gabor_noise_3d_animated(vec3 p, float moment, float frequency, vec3 direction, uint seed)
// vec4 gabor_noise_3d_four(vec3 p, float frequency, vec3 direction, uint seed)
// vec2 gabor_noise_3d_complex(vec3 p, float frequency, vec3 direction, uint seed)
//     Like gabor_noise_animated, gabor_noise_four and gabor_noise_complex.

// vec4 gabor_noise_3d_gradient(vec3 p, float frequency, vec3 direction, uint seed)
//     (noise, d/dx, d/dy, d/dz). The derivatives are per kernel radius, for a constant wave vector. For a bump map,
//     subtract the gradient's component along the normal.

// vec2 gabor_noise_3d_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, vec3 direction, uint seed)
//     (noise, removed): the noise averaged over a pixel, and the share of its variance that averaging removed. The
//     error is that of gabor_noise_filtered: 1 % as long as the pixel's longest axis is at most a third of a kernel
//     radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a call costs 1.4 times
//     as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2 (64 nodes), and at
//     most 6.6 times (125 nodes).

// ---- Isotropic solid noise -----------------------------------------------------------------------------------------

// float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed)
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions.

// vec4 gabor_noise_3d_isotropic_gradient(vec3 p, float frequency, uint seed)
//     (noise, d/dx, d/dy, d/dz), per kernel radius.

// vec2 gabor_noise_3d_isotropic_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, uint seed)
//     Like gabor_noise_3d_filtered, at less than twice the cost of gabor_noise_3d_isotropic. The rms error against
//     exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3 kernel
//     radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ---- Noise on a surface --------------------------------------------------------------------------------------------

// float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed)
//     Noise at point p on a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed)
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ---- For large worlds, and for periods, time and filters combined --------------------------------------------------

// A position in node spacings of the lattice, with a period, a time and a pixel: see GaborPlace.
struct GaborPlace3d {
    gabor_ivec3 cell;
    gabor_vec3 local;
    gabor_vec3 radius;
    gabor_ivec3 period;
    bool animated;
    float moment;
    bool filtered; // whether to average over a pixel with sides dx and dy: see gabor_noise_3d_filtered
    gabor_vec3 dx;
    gabor_vec3 dy;
};

// Noise and quadrature, with their gradients per kernel radius. Unused parts cost nothing.
struct GaborField3d {
    float noise;
    gabor_vec3 gradient;
    float quadrature; // in isotropic noise, independent of the noise at each point, but not of the noise's gradient
    gabor_vec3 quadrature_gradient;
    float removed; // share of the variance that averaging over the pixel removed
};

// GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
//     The position (cell + local) / GABOR_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells along each
//     axis.

// GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, vec3 direction, uint seed)
// GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, uint seed)
// GaborField3d gabor_field_surface(GaborPlace3d place, vec3 normal, float frequency, vec3 direction, uint seed)
// GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, vec3 normal, float frequency, uint seed)
//     The noises above, for a GaborPlace3d. All noise functions call these four.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

GABOR_INLINE GaborPlace3d gabor_place_3d(gabor_ivec3 cell, gabor_vec3 local) {
    return GaborPlace3d{cell, local, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f, false, gabor_vec3(0.0f), gabor_vec3(0.0f)};
}

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
GABOR_INLINE gabor_vec3 gabor_impl_unit(gabor_vec3 v) {
    v = gabor_cpp_clamp(v, -1.0e15f, 1.0e15f);
    return v * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(v, v), 1.0e-30f));
}

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// Adds slice k of nodes. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the
// window; `slopes` receives the same part of its derivatives along y and z. The filter adds mixed derivatives, weighted
// by its covariances yz, zx, xy.
GABOR_INLINE void gabor_impl_add_node_slice(gabor_vec4& sum, gabor_vec4& slopes, GaborPlace3d place, GaborAxis x, GaborAxis y,
                               GaborAxis z, int k, gabor_vec3 mixed) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    gabor_vec4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.moment, slice, slope);
    gabor_impl_add_products(sum, slice, z.node[k].xy());
    slopes += gabor_vec4(gabor_impl_product(slope.xy(), z.node[k].xy()), gabor_impl_product(slice.xy(), z.node[k].zw()));
    if (place.filtered)
        sum += gabor_vec4(gabor_impl_product(mixed.x * slope.xy() + mixed.y * slice.zw(), z.node[k].zw())
                    + mixed.z * gabor_impl_product(slope.zw(), z.node[k].xy()), 0.0f, 0.0f);
}

// The noise of 27 nodes. If the place is filtered, the filter uses three waves along each axis: see
// gabor_spectrum.hpp. K makes E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1. A wave's derivative is the wave times
// 2 pi i F.
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
        turn *= gabor_cpp_exp(-19.739209f * gabor_cpp_max(gabor_cpp_dot(wave, blurred), 0.0f));
    }
    gabor_vec4 sum = gabor_vec4(0.0f), slopes = gabor_vec4(0.0f);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 0, pixel.mixed);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 1, pixel.mixed);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 2, pixel.mixed);
    sum = gabor_vec4(gabor_impl_product(sum.xy(), turn), gabor_impl_product(sum.zw(), turn));
    slopes = gabor_vec4(gabor_impl_product(slopes.xy(), turn), gabor_impl_product(slopes.zw(), turn));
    return GaborField3d{sum.y, gabor_vec3(sum.w, slopes.y, slopes.w) + 6.2831853f * sum.x * wave,
                        sum.x, gabor_vec3(sum.z, slopes.x, slopes.z) - 6.2831853f * sum.y * wave, 0.0f};
}

// Adds a field times an amplitude. A kernel radius is `stretch` times the field's unit of length.
GABOR_INLINE void gabor_impl_add_field_3d(GaborField3d& sum, GaborField3d field, float amplitude, gabor_vec3 stretch) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * stretch * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
}

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_RADIUS node spacings.
struct GaborPixelAxes {
    gabor_vec3 major;
    gabor_vec3 minor;
};

GABOR_INLINE GaborPixelAxes gabor_impl_pixel(GaborPlace3d place, gabor_vec3 stretch) {
    gabor_vec3 dx = gabor_cpp_clamp(place.dx, -1.0e6f, 1.0e6f) * stretch;
    gabor_vec3 dy = gabor_cpp_clamp(place.dy, -1.0e6f, 1.0e6f) * stretch;
    gabor_vec2 twice = gabor_vec2(gabor_cpp_dot(dx, dx) - gabor_cpp_dot(dy, dy), 2.0f * gabor_cpp_dot(dx, dy)); // at twice the angle of `turn`
    float cosine = twice.x / gabor_cpp_max(gabor_cpp_length(twice), 1.0e-30f);
    gabor_vec2 turn = gabor_cpp_sqrt(gabor_cpp_max(0.5f + gabor_vec2(0.5f, -0.5f) * cosine, 0.0f));
    if (twice.y < 0.0f) turn.y = -turn.y;
    return GaborPixelAxes{turn.x * dx + turn.y * dy, turn.x * dy - turn.y * dx};
}

// Limits the length of each axis to `most`.
GABOR_INLINE GaborPixelAxes gabor_impl_resolved(GaborPixelAxes pixel, float most) {
    return GaborPixelAxes{most * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(pixel.major, pixel.major), most * most)) * pixel.major,
                      most * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(pixel.minor, pixel.minor), most * most)) * pixel.minor};
}

GABOR_INLINE GaborMatrix gabor_impl_covariance(GaborPixelAxes pixel) {
    gabor_vec3 major = 0.5f * pixel.major, minor = 0.5f * pixel.minor;
    return GaborMatrix{major * major + minor * minor, major.yzx() * major.zxy() + minor.yzx() * minor.zxy()};
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
GABOR_INLINE gabor_vec2 gabor_impl_spread(GaborPixelAxes pixel) {
    return 1.0f + 1.6449341f * gabor_vec2(gabor_cpp_dot(pixel.major, pixel.major), gabor_cpp_dot(pixel.minor, pixel.minor));
}

// The share of a lobe's variance that a pixel's filter keeps.
GABOR_INLINE float gabor_impl_transmitted_3d(gabor_vec3 wave, GaborPixelAxes pixel) {
    gabor_vec2 d = gabor_impl_spread(pixel);
    gabor_vec2 k = gabor_vec2(gabor_cpp_dot(wave, pixel.major), gabor_cpp_dot(wave, pixel.minor));
    return gabor_cpp_exp(-gabor_cpp_min(9.8696044f * gabor_cpp_dot(k * k, 1.0f / d), 80.0f)) * gabor_cpp_inversesqrt(d.x * d.y);
}

// With periods, nodes are not 1 / GABOR_RADIUS kernel radii apart, so all lengths here are in units of GABOR_RADIUS
// node spacings.
GABOR_INLINE GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    gabor_vec3 wave = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f) * gabor_impl_unit(direction) / stretch;
    std::uint32_t salt = gabor_impl_salt(seed);
    float amplitude = 1.0f, transmitted = 1.0f, wide = 0.0f;
    GaborMatrix pixel = GaborMatrix{gabor_vec3(0.0f), gabor_vec3(0.0f)};
    if (place.filtered) {
        GaborPixelAxes whole = gabor_impl_pixel(place, stretch), resolved = gabor_impl_resolved(whole, 1.0f);
        transmitted = gabor_impl_transmitted_3d(wave, whole);
        amplitude = gabor_cpp_sqrt(transmitted / gabor_impl_transmitted_3d(wave, resolved));
        if (!(transmitted > 1.0e-10f)) transmitted = 0.0f; // also if it is NaN
        pixel = gabor_impl_covariance(resolved);
        gabor_vec3 variance = pixel.diagonal;
        wide = gabor_cpp_clamp(100.0f * gabor_cpp_sqrt(gabor_cpp_max(gabor_cpp_max(variance.x, variance.y), variance.z)) - 9.0f, 0.0f, 1.0f);
    }
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f - transmitted};
    if (transmitted == 0.0f)
        return sum;
    if (wide < 1.0f)
        gabor_impl_add_field_3d(sum, gabor_impl_sum_3d(place, wave, pixel, salt), (1.0f - wide) * amplitude, stretch);
    if (wide > 0.0f) {
        gabor_vec4 noise, quadrature;
        gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.moment, wave, pixel,
                                  wide > 0.0f, salt, noise, quadrature);
        gabor_impl_add_field_3d(sum, GaborField3d{noise.x, noise.yzw(), quadrature.x, quadrature.yzw(), 0.0f},
                                wide * amplitude, stretch);
    }
    return sum;
}

// Adds one of two independent noises, which replaces the other as x goes from 0 to 1.
GABOR_INLINE void gabor_impl_add_share_3d(GaborField3d& sum, GaborField3d term, float x) {
    float power = gabor_impl_takeover(x);
    gabor_impl_add_field_3d(sum, term, gabor_cpp_sqrt(power), gabor_vec3(1.0f));
    sum.removed += power * term.removed;
}

GABOR_INLINE GaborField3d gabor_field_surface(GaborPlace3d place, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    gabor_vec3 other = gabor_cpp_cross(direction, gabor_cpp_abs(direction.z) < 0.7f ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f));
    direction -= gabor_cpp_dot(direction, normal) * normal;
    other -= gabor_cpp_dot(other, normal) * normal;
    float flat_length = gabor_cpp_dot(direction, direction);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = flat_length > 0.0625f ? 0 : 1; i < (flat_length < 0.25f ? 2 : 1); ++i)
        gabor_impl_add_share_3d(sum,
                                gabor_field_3d(place, frequency, i == 0 ? direction : other, gabor_lobe_seed(seed, i)),
                                i == 0 ? gabor_cpp_smoothstep(0.0625f, 0.25f, flat_length)
                                       : gabor_cpp_smoothstep(-0.25f, -0.0625f, -flat_length));
    return sum;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three perpendicular unit vectors u_cm, turned at random, each with its own amplitude:
//     n(p) = K Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with the constant variance K^2 E[|A|^2] / 2 sum_c 3 h_c^2. The gradient is
// independent of the value and has the constant covariance K^2 E[|A|^2] / 2 sum_c (3 grad h grad h^T + 4 pi^2 F^2 h^2
// I), because sum_m u_cm u_cm^T is the identity I. Since none of this depends on the directions, both are also normal
// over random directions. On a surface there are two tangent vectors, and the same holds for the value and its
// derivatives along the surface.

// Adds a wave of a node; x, y and z come from gabor_impl_node. `wave` is the wave vector and, in w, the turns from the
// node to the point. The filter (see gabor_spectrum.hpp) multiplies the wave by exp(-2 pi^2 F.S F). With s = 2 pi^2
// S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
GABOR_INLINE void gabor_impl_add_node_wave_3d(GaborField3d& sum, gabor_vec4 x, gabor_vec4 y, gabor_vec4 z, gabor_vec4 wave, GaborPlace3d place,
                                 GaborMatrix pixel, std::uint32_t word) {
    gabor_vec2 a = gabor_impl_product(gabor_impl_amplitude_at(word, place.animated, place.moment), gabor_impl_wave(wave.w));
    gabor_vec3 middle = gabor_vec3(x.y, y.y, z.y), cosine = gabor_vec3(x.z, y.z, z.z), sine = gabor_vec3(x.w, y.w, z.w);
    gabor_vec3 h = middle + cosine, slope = sine * (h.yzx() * h.zxy()), turned = gabor_vec3(0.0f);
    gabor_vec2 value = h.x * (h.y * h.z) * a;
    if (place.filtered) {
        gabor_vec3 s = 19.739209f * gabor_impl_symmetric_3d(pixel, wave.xyz());
        a *= gabor_cpp_exp(-gabor_cpp_max(gabor_cpp_dot(wave.xyz(), s), 0.0f));
        s = gabor_cpp_clamp(s, -3.0f, 3.0f); // changes no wave that the filter keeps
        gabor_vec3 r = s * s, even = 1.0f + r * (0.5f + 0.041666667f * r);
        gabor_vec3 odd = s * (1.0f + r * (0.16666667f + 0.0083333333f * r));
        float mixed = gabor_cpp_dot(pixel.mixed, sine.yzx() * sine.zxy() * h);
        h = middle + even * cosine;
        gabor_vec3 i_h = 0.31830989f * odd * sine, i_slope = -3.1415927f * odd * cosine;
        gabor_vec3 real = h.yzx() * h.zxy() - i_h.yzx() * i_h.zxy(), imaginary = h.yzx() * i_h.zxy() + i_h.yzx() * h.zxy();
        value = gabor_vec2(h.x * real.x - i_h.x * imaginary.x + mixed, h.x * imaginary.x + i_h.x * real.x);
        value = gabor_impl_product(value, a);
        slope = even * sine * real - i_slope * imaginary;
        turned = even * sine * imaginary + i_slope * real;
    }
    sum.noise += value.y;
    sum.gradient += slope * a.y + turned * a.x + 6.2831853f * value.x * wave.xyz();
    sum.quadrature += value.x;
    sum.quadrature_gradient += slope * a.x - turned * a.y - 6.2831853f * value.y * wave.xyz();
}

// The directions of isotropic noise: all or, if `only`, those in the tangent plane that two perpendicular unit vectors
// span.
struct GaborTangents {
    bool only;
    gabor_vec3 along;
    gabor_vec3 across;
};

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions. A wave
// along -u is also a wave along u, so turning the first vector within half a circle reaches every direction of a
// surface. In space, the first vector also tilts along z, and the other two turn around it within a quarter circle.
GABOR_INLINE void gabor_impl_add_node_waves_3d(GaborField3d& sum, gabor_vec4 x, gabor_vec4 y, gabor_vec4 z, GaborPlace3d place, GaborMatrix pixel,
                                  gabor_vec3 scale, GaborTangents tangents, std::uint32_t column, gabor_uvec4 row) {
    std::uint32_t word = column * row.w;
    gabor_vec2 turn = gabor_impl_half_turn(1.1641532e-10f * float(int(word)));
    gabor_vec3 first = turn.x * tangents.along + turn.y * tangents.across;
    gabor_vec3 second = turn.x * tangents.across - turn.y * tangents.along;
    gabor_vec3 d = scale * gabor_vec3(x.x, y.x, z.x);
    gabor_vec4 u = gabor_vec4(first, gabor_cpp_dot(first, d)), v = gabor_vec4(second, gabor_cpp_dot(second, d)), w = gabor_vec4(0.0f, 0.0f, 1.0f, d.z);
    if (!tangents.only) {
        float rise = 4.6566129e-10f * float(int(word << 12u)), level = gabor_cpp_sqrt(gabor_cpp_max(1.0f - rise * rise, 0.0f));
        gabor_vec2 spin = gabor_impl_half_turn(5.8207661e-11f * float(int(word << 20u)));
        gabor_vec4 across = v, lifted = level * w - rise * u;
        u = level * u + rise * w;
        v = spin.x * across + spin.y * lifted;
        w = spin.x * lifted - spin.y * across;
    }
    gabor_vec4 unit = gabor_vec4(scale, 1.0f);
    gabor_impl_add_node_wave_3d(sum, x, y, z, unit * u, place, pixel, column * row.x);
    gabor_impl_add_node_wave_3d(sum, x, y, z, unit * v, place, pixel, column * row.y);
    if (!tangents.only) gabor_impl_add_node_wave_3d(sum, x, y, z, unit * w, place, pixel, column * row.z);
}

// (d, middle, cosine, sine) of a node on an axis: the point's offset d from the node; the parts of the window,
// middle = 1/2 and cosine = cos(pi d) / 2; and the window's derivative, sine = -pi / 2 sin(pi d). Filtered windows fade
// out within half a standard deviation of their ends.
GABOR_INLINE gabor_vec4 gabor_impl_node(float offset, gabor_vec4 node, float variance) {
    offset /= GABOR_RADIUS;
    float fade = 1.0f, fall = 1.0f;
    if (variance > 0.0f) {
        fade = gabor_cpp_clamp((1.0f - gabor_cpp_abs(offset)) / gabor_cpp_clamp(0.5f * gabor_cpp_sqrt(variance), 0.001f, 0.05f), 0.0f, 1.0f);
        fade *= fade * (3.0f - 2.0f * fade);
        fall = fade * gabor_cpp_exp(-4.934802f * variance);
    }
    return gabor_vec4(offset, 0.5f * fade, fall * (node.x - 0.5f), fall * node.z);
}

GABOR_INLINE GaborAxis gabor_impl_nodes(int cell, float local, int period, std::uint32_t salt, float variance) {
    GaborAxis axis = gabor_impl_axis(cell, local, period, salt, 0.0f, GABOR_RADIUS);
    axis.node[0] = gabor_impl_node(axis.offset + 1.0f, axis.node[0], variance);
    axis.node[1] = gabor_impl_node(axis.offset, axis.node[1], variance);
    axis.node[2] = gabor_impl_node(axis.offset - 1.0f, axis.node[2], variance);
    return axis;
}

// The sum over 27 nodes, without the factor K.
GABOR_INLINE GaborField3d gabor_impl_sum_isotropic(GaborPlace3d place, GaborMatrix pixel, gabor_vec3 scale, GaborTangents tangents,
                                      std::uint32_t salt) {
    gabor_vec3 s = pixel.diagonal;
    GaborAxis x = gabor_impl_nodes(place.cell.x, place.local.x, place.period.x, salt, s.x);
    GaborAxis y = gabor_impl_nodes(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, s.y);
    GaborAxis z = gabor_impl_nodes(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, s.z);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = 0; i < 9; ++i) {
        int j = i % 3;
        gabor_vec4 y_j = j == 0 ? y.node[0] : j == 1 ? y.node[1] : y.node[2];
        gabor_vec4 z_k = i < 3 ? z.node[0] : i < 6 ? z.node[1] : z.node[2];
        std::uint32_t word = (j == 0 ? y.word[0] : j == 1 ? y.word[1] : y.word[2])
                  * (i < 3 ? z.word[0] : i < 6 ? z.word[1] : z.word[2]);
        gabor_uvec4 row = gabor_impl_row(word);
        gabor_impl_add_node_waves_3d(sum, x.node[0], y_j, z_k, place, pixel, scale, tangents, x.word[0], row);
        gabor_impl_add_node_waves_3d(sum, x.node[1], y_j, z_k, place, pixel, scale, tangents, x.word[1], row);
        gabor_impl_add_node_waves_3d(sum, x.node[2], y_j, z_k, place, pixel, scale, tangents, x.word[2], row);
    }
    return sum;
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
GABOR_INLINE float gabor_impl_transmitted_isotropic(float frequency, GaborPixelAxes pixel, GaborTangents tangents) {
    gabor_vec2 d = gabor_impl_spread(pixel);
    gabor_vec2 unit = gabor_cpp_min(9.8696044f * frequency * frequency, 1.0e6f) / d;
    float mean;
    if (tangents.only) {
        gabor_vec2 a = gabor_vec2(gabor_cpp_dot(tangents.along, pixel.major), gabor_cpp_dot(tangents.along, pixel.minor));
        gabor_vec2 b = gabor_vec2(gabor_cpp_dot(tangents.across, pixel.major), gabor_cpp_dot(tangents.across, pixel.minor));
        float sum = gabor_cpp_dot(unit, a * a + b * b), apart = gabor_cpp_length(gabor_vec2(gabor_cpp_dot(unit, a * a - b * b), 2.0f * gabor_cpp_dot(unit, a * b)));
        mean = gabor_cpp_exp(gabor_cpp_min(0.5f * (apart - sum), 0.0f)) * gabor_impl_mean_angle(apart);
    } else {
        gabor_vec2 q = unit * gabor_vec2(gabor_cpp_dot(pixel.major, pixel.major), gabor_cpp_dot(pixel.minor, pixel.minor));
        float larger = gabor_cpp_max(q.x, q.y), smaller = gabor_cpp_min(q.x, q.y);
        mean = gabor_cpp_sqrt((1.0f + larger * (0.31500545f + 0.08868891f * larger))
                    / (1.0f + larger * (0.98167212f + larger * (0.42128292f + 0.11292425f * larger))));
        mean *= gabor_impl_mean_angle(smaller * (1.0f - 1.0f / (3.0f + 0.8f * larger)));
    }
    return mean * gabor_cpp_inversesqrt(d.x * d.y);
}

GABOR_INLINE GaborField3d gabor_impl_isotropic(GaborPlace3d place, float frequency, GaborTangents tangents, std::uint32_t seed) {
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    frequency = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f);
    float amplitude = gabor_cpp_inversesqrt((tangents.only ? 2.0f : 3.0f) * GABOR_IMPL_ENERGY)
                    / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    float transmitted = 1.0f;
    GaborMatrix pixel = GaborMatrix{gabor_vec3(0.0f), gabor_vec3(0.0f)};
    if (place.filtered) {
        GaborPixelAxes whole = gabor_impl_pixel(place, gabor_vec3(1.0f)), resolved = gabor_impl_resolved(whole, 0.5f);
        transmitted = gabor_impl_transmitted_isotropic(frequency, whole, tangents);
        amplitude *= gabor_cpp_sqrt(transmitted / gabor_impl_transmitted_isotropic(frequency, resolved, tangents));
        pixel = gabor_impl_covariance(GaborPixelAxes{resolved.major * stretch, resolved.minor * stretch});
        if (!(transmitted > 1.0e-10f)) transmitted = 0.0f; // also if it is NaN
    }
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f - transmitted};
    if (transmitted > 0.0f)
        gabor_impl_add_field_3d(sum, gabor_impl_sum_isotropic(place, pixel, frequency / stretch, tangents,
                                                              gabor_impl_salt(seed)), amplitude, stretch);
    return sum;
}

GABOR_INLINE GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, std::uint32_t seed) {
    return gabor_impl_isotropic(place, frequency, GaborTangents{false, gabor_vec3(1.0f, 0.0f, 0.0f), gabor_vec3(0.0f, 1.0f, 0.0f)}, seed);
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
GABOR_INLINE GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    float aside = gabor_cpp_dot(normal.xy(), normal.xy()); // squared sine of the normal's angle to the z axis
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = aside > 0.25f ? 0 : 1; i < (aside < 0.5f ? 2 : 1); ++i) {
        gabor_vec3 along = gabor_impl_unit(gabor_cpp_cross(i == 0 ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f), normal));
        GaborField3d term = gabor_impl_isotropic(place, frequency, GaborTangents{true, along, gabor_cpp_cross(normal, along)},
                                                 gabor_lobe_seed(seed, i));
        gabor_impl_add_share_3d(sum, term, i == 0 ? gabor_cpp_smoothstep(0.25f, 0.5f, aside) : gabor_cpp_smoothstep(-0.5f, -0.25f, -aside));
    }
    return sum;
}

// ---- Functions of a position ---------------------------------------------------------------------------------------

GABOR_INLINE float gabor_noise_3d(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed).noise;
}

GABOR_INLINE gabor_vec4 gabor_noise_3d_gradient(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return gabor_vec4(field.noise, field.gradient);
}

GABOR_INLINE gabor_vec2 gabor_noise_3d_complex(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return gabor_vec2(field.quadrature, field.noise);
}

GABOR_INLINE gabor_vec4 gabor_noise_3d_four(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_vec4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

GABOR_INLINE float gabor_noise_3d_tiled(gabor_vec3 p, gabor_vec3 period, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    period = gabor_cpp_clamp(period, 0.0009765625f, 1.0e9f);
    gabor_vec3 nodes = gabor_cpp_max(gabor_cpp_floor(period * GABOR_RADIUS + 0.5f), gabor_vec3(3.0f));
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), (p - gabor_cpp_floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = gabor_ivec3(nodes);
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

GABOR_INLINE float gabor_noise_3d_animated(gabor_vec3 p, float moment, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS);
    place.animated = true;
    place.moment = moment;
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

GABOR_INLINE GaborPlace3d gabor_impl_place_of_pixel(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy) {
    return GaborPlace3d{gabor_ivec3(0), p * GABOR_RADIUS, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f, true, dx, dy};
}

GABOR_INLINE gabor_vec2 gabor_noise_3d_filtered(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d(gabor_impl_place_of_pixel(p, dx, dy), frequency, direction, seed);
    return gabor_vec2(field.noise, field.removed);
}

GABOR_INLINE float gabor_noise_3d_isotropic(gabor_vec3 p, float frequency, std::uint32_t seed) {
    return gabor_field_3d_isotropic(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, seed).noise;
}

GABOR_INLINE gabor_vec4 gabor_noise_3d_isotropic_gradient(gabor_vec3 p, float frequency, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d_isotropic(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, seed);
    return gabor_vec4(field.noise, field.gradient);
}

GABOR_INLINE gabor_vec2 gabor_noise_3d_isotropic_filtered(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy, float frequency, std::uint32_t seed) {
    GaborField3d field = gabor_field_3d_isotropic(gabor_impl_place_of_pixel(p, dx, dy), frequency, seed);
    return gabor_vec2(field.noise, field.removed);
}

GABOR_INLINE float gabor_noise_surface(gabor_vec3 p, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_field_surface(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

GABOR_INLINE float gabor_noise_surface_isotropic(gabor_vec3 p, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    return gabor_field_surface_isotropic(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_NOISE_3D_HPP
