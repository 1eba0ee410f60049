// clang-format off
// Generated from gabor_filter_3d.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp, gabor_spectrum.hpp, gabor_filter.hpp, gabor_noise_3d.hpp; pasted after their texts, it includes nothing.
// It can do without gabor_spectrum.hpp.
//
// gabor_filter_3d.hpp: the noises of gabor_noise_3d.hpp, averaged over a pixel.
//
//     GaborField3d f = gabor_field_3d_isotropic_filtered(gabor_place_3d_at(p), dFdx(p), dFdy(p), 2.0, 7u);
//
// dx and dy are the change of p, in kernel radii, from one pixel to the next along x and y; a field's `removed` is the
// share of the variance that averaging removed: see gabor_filter.hpp.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#if !defined(GABOR_SPECTRUM_HPP) && defined(__has_include)
#if __has_include("gabor_spectrum.hpp")
#include "gabor_spectrum.hpp"
#endif
#endif
#ifndef GABOR_FILTER_HPP
#include "gabor_filter.hpp"
#endif
#ifndef GABOR_NOISE_3D_HPP
#include "gabor_noise_3d.hpp"
#endif
#ifndef GABOR_FILTER_3D_HPP
#define GABOR_FILTER_3D_HPP 1

// GaborField3d gabor_field_3d_filtered(GaborPlace3d place, vec3 dx, vec3 dy, vec3 wave, uint seed)
// GaborField3d gabor_field_surface_filtered(GaborPlace3d place, vec3 dx, vec3 dy, vec3 normal, float frequency,
//                                           vec3 direction, uint seed)
//     The filtered noise. The error is that of gabor_field_filtered: 1 % as long as the pixel's longest axis is at most
//     a third of a kernel radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a
//     call costs 1.4 times as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2
//     (64 nodes), and at most 6.6 times (125 nodes).

// GaborField3d gabor_field_3d_isotropic_filtered(GaborPlace3d place, vec3 dx, vec3 dy, float frequency, uint seed)
// GaborField3d gabor_field_surface_isotropic_filtered(GaborPlace3d place, vec3 dx, vec3 dy, vec3 normal,
//                                                     float frequency, uint seed)
//     Filtered noise of waves in all directions. They cost less than twice as much as without the filter. The rms error
//     against exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3
//     kernel radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- The coupling of three axes ------------------------------------------------------------------------------------
//
// In addition to gabor_filter.hpp: with M = S + v, a diagonal matrix D with D_ii^2 = M_ii / (M^-1)_ii, C = D^(-1/2) M
// D^(-1/2), B = (1 - C) (1 + C)^-1 and z = 2 pi D^(1/2) (q - c), the coupling of three axes is again a sum of products:
//     exp(-z.C z / 2) = sqrt(8 / |1 + C|) exp(-z.z / 2) (1 + 2 (B_yz z_y z_z + B_zx z_z z_x + B_xy z_x z_y) + ...).
// The right side is the series of exp(z.B z) with Hermite polynomials instead of powers of z, and without B's diagonal,
// which is at most 0.01. We use the terms up to the square of each factor.

// A symmetric 3 x 3 matrix.
struct GaborImplMatrix {
    gabor_vec3 diagonal;
    gabor_vec3 mixed; // yz, zx, xy
};

GABOR_INLINE gabor_vec3 gabor_impl_symmetric_3d(GaborImplMatrix m, gabor_vec3 v) {
    return m.diagonal * v + m.mixed.zxy() * v.yzx() + m.mixed.yzx() * v.zxy();
}

// The inverse times the determinant.
GABOR_INLINE GaborImplMatrix gabor_impl_adjugate(GaborImplMatrix m, float& determinant) {
    GaborImplMatrix a = GaborImplMatrix{m.diagonal.yzx() * m.diagonal.zxy() - m.mixed * m.mixed,
                                        m.mixed.yzx() * m.mixed.zxy() - m.diagonal * m.mixed};
    determinant = m.diagonal.x * a.diagonal.x + m.mixed.y * a.mixed.y + m.mixed.z * a.mixed.z;
    return a;
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
GABOR_INLINE gabor_vec3 gabor_impl_along_z(gabor_vec3 y_0, gabor_vec3 y_1, gabor_vec3 y_2, gabor_vec3 w) {
    return gabor_vec3(y_0.x + w.z * (y_1.y + 0.5f * w.z * y_2.z),
                w.y * (y_0.y + w.z * y_1.z) + w.x * (y_1.x + w.z * y_2.y),
                0.5f * (w.y * w.y * y_0.z + w.x * w.x * y_2.x) + w.x * w.y * (y_1.y + w.z * y_2.z));
}

// The weighted sum of the products of three axes' factors.
GABOR_INLINE gabor_vec2 gabor_impl_contracted_3d(GaborImplFactors y_0, GaborImplFactors y_1, GaborImplFactors y_2, GaborImplFactors z,
                              gabor_vec3 w) {
    GaborImplFactors slice = GaborImplFactors{gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w),
                                              gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w)};
    return gabor_impl_contracted(slice, z, gabor_vec3(1.0f));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
GABOR_INLINE GaborField3d gabor_impl_filtered_wide_3d(GaborPlace3d place, gabor_vec3 wave, GaborImplMatrix s, bool wanted, std::uint32_t salt) {
    float determinant;
    // 0.13069097 is 1/3 - 2/pi^2
    GaborImplMatrix m = GaborImplMatrix{s.diagonal + 0.13069097f, s.mixed}; // S + v
    GaborImplMatrix adjugate = gabor_impl_adjugate(m, determinant);
    gabor_vec3 blurred = gabor_impl_symmetric_3d(s, wave);
    gabor_vec3 c = gabor_impl_symmetric_3d(adjugate, blurred) / -determinant;
    gabor_vec3 d = gabor_cpp_sqrt(m.diagonal * determinant / adjugate.diagonal);
    gabor_vec3 pairs = gabor_cpp_sqrt(d.yzx() * d.zxy());
    adjugate = gabor_impl_adjugate(GaborImplMatrix{1.0f + m.diagonal / d, s.mixed / pairs}, determinant); // of 1 + C
    // 157.91367 is 16 pi^2
    gabor_vec3 w = 157.91367f / determinant * pairs * adjugate.mixed; // 8 pi^2 sqrt(D_yy D_zz) B_yz and so on
    GaborImplFilteredAxis x = gabor_impl_filtered_axis(gabor_cpp_sqrt(s.diagonal.x), d.x, c.x, place.cell.x, place.local.x,
                                                       place.period.x, salt,
                                                           gabor_impl_wave(wave.x / GABOR_CELLS_PER_RADIUS));
    GaborImplFilteredAxis y = gabor_impl_filtered_axis(gabor_cpp_sqrt(s.diagonal.y), d.y, c.y, place.cell.y, place.local.y,
                                                       place.period.y, salt ^ GABOR_IMPL_ROWS,
                                                       gabor_impl_wave(wave.y / GABOR_CELLS_PER_RADIUS));
    GaborImplFilteredAxis z = gabor_impl_filtered_axis(gabor_cpp_sqrt(s.diagonal.z), d.z, c.z, place.cell.z, place.local.z,
                                                       place.period.z, salt ^ GABOR_IMPL_SLICES,
                                                       gabor_impl_wave(wave.z / GABOR_CELLS_PER_RADIUS));
    GaborImplColumns columns = gabor_impl_columns(x);
    GaborImplFilteredLine first = gabor_impl_line_before(y, gabor_vec2(y.back.x, -y.back.y));
    GaborImplFilteredLine slice = gabor_impl_line_before(
        z, gabor_impl_wave(gabor_cpp_dot(wave, gabor_vec3(x.offset, y.offset, z.offset + 1.0f)) / GABOR_CELLS_PER_RADIUS));
    GaborImplFactors none = GaborImplFactors{gabor_vec3(0.0f), gabor_vec3(0.0f)};
    int rows = wanted ? y.count : 0, slices = wanted ? z.count : 0; // see gabor_impl_filtered_wide
    gabor_vec2 value = gabor_vec2(0.0f), next_x = gabor_vec2(0.0f), next_y = gabor_vec2(0.0f), next_z = gabor_vec2(0.0f);
    int k = 0;
    do {
        slice = gabor_impl_next_line(slice, z, k, gabor_impl_fade(z, k));
        GaborImplFactors y_0 = none, y_1 = none, y_2 = none;
        GaborImplFilteredLine row = first;
        int j = 0;
        do {
            row = gabor_impl_next_line(row, y, j, gabor_impl_fade(y, j));
            GaborImplFactors sum =
                gabor_impl_filtered_row(columns, gabor_impl_slice_word(row.word, slice.word), place.evolution);
            GaborImplFactors window = gabor_impl_faded(row);
            y_0 = gabor_impl_plus_product(y_0, sum, window.real.x, window.imaginary.x);
            y_1 = gabor_impl_plus_product(y_1, sum, window.real.y, window.imaginary.y);
            y_2 = gabor_impl_plus_product(y_2, sum, window.real.z, window.imaginary.z);
        } while (++j < rows);
        GaborImplFactors along_z = gabor_impl_faded(slice);
        value += gabor_impl_contracted_3d(y_0, y_1, y_2, along_z, w);
        next_x += gabor_impl_contracted_3d(gabor_impl_next(y_0), gabor_impl_next(y_1), gabor_impl_next(y_2),
                                           along_z, w);
        next_y += gabor_impl_contracted_3d(y_1, y_2, none, along_z, w);
        next_z += gabor_impl_contracted_3d(y_0, y_1, y_2, gabor_impl_next(along_z), w);
    } while (++k < slices);
    // The derivatives follow as in the plane. In the sum over the series, n / 4g times the previous factor becomes
    // w / 4g times the next factor of the other axes.
    gabor_vec3 real = gabor_vec3(next_x.x, next_y.x, next_z.x), imaginary = gabor_vec3(next_x.y, next_y.y, next_z.y);
    // 0.012665148 is 1/(8 pi^2)
    gabor_vec3 quarter = 0.012665148f / d; // 1 / 4g, g = 2 pi^2 D
    real += (wave + c) * value.x + quarter * gabor_impl_symmetric_3d(GaborImplMatrix{gabor_vec3(0.0f), w}, real);
    imaginary += (wave + c) * value.y + quarter * gabor_impl_symmetric_3d(GaborImplMatrix{gabor_vec3(0.0f), w}, imaginary);
    float exponent = 19.739209f * (gabor_cpp_dot(wave + c, blurred) + gabor_cpp_dot(d, c * c));
    float scale = gabor_cpp_sqrt(8.0f / determinant / GABOR_IMPL_ENERGY) * gabor_cpp_exp(-exponent);
    scale /= GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY;
    // 6.2831853 is 2 pi
    return GaborField3d{scale * value.y, 6.2831853f * scale * real, scale * value.x, -6.2831853f * scale * imaginary,
                        0.0f};
}
// ---- One wave vector -----------------------------------------------------------------------------------------------

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_CELLS_PER_RADIUS node spacings.
struct GaborImplPixelAxes {
    gabor_vec3 major;
    gabor_vec3 minor;
};

GABOR_INLINE GaborImplPixelAxes gabor_impl_pixel(gabor_vec3 dx, gabor_vec3 dy, gabor_vec3 stretch) {
    dx = gabor_cpp_clamp(dx, -1.0e6f, 1.0e6f) * stretch;
    dy = gabor_cpp_clamp(dy, -1.0e6f, 1.0e6f) * stretch;
    gabor_vec2 twice = gabor_vec2(gabor_cpp_dot(dx, dx) - gabor_cpp_dot(dy, dy), 2.0f * gabor_cpp_dot(dx, dy)); // at twice the angle of `turn`
    float cosine = twice.x / gabor_cpp_max(gabor_cpp_length(twice), 1.0e-30f);
    gabor_vec2 turn = gabor_cpp_sqrt(gabor_cpp_max(0.5f + gabor_vec2(0.5f, -0.5f) * cosine, 0.0f));
    if (twice.y < 0.0f) turn.y = -turn.y;
    return GaborImplPixelAxes{turn.x * dx + turn.y * dy, turn.x * dy - turn.y * dx};
}

// Limits the length of each axis to `most`.
GABOR_INLINE GaborImplPixelAxes gabor_impl_resolved(GaborImplPixelAxes pixel, float most) {
    return GaborImplPixelAxes{most * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(pixel.major, pixel.major), most * most)) * pixel.major,
                              most * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(pixel.minor, pixel.minor), most * most)) * pixel.minor};
}

GABOR_INLINE GaborImplMatrix gabor_impl_covariance(GaborImplPixelAxes pixel) {
    gabor_vec3 major = 0.5f * pixel.major, minor = 0.5f * pixel.minor;
    return GaborImplMatrix{major * major + minor * minor, major.yzx() * major.zxy() + minor.yzx() * minor.zxy()};
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
GABOR_INLINE gabor_vec2 gabor_impl_spread(GaborImplPixelAxes pixel) {
    return 1.0f + 1.6449341f * gabor_vec2(gabor_cpp_dot(pixel.major, pixel.major), gabor_cpp_dot(pixel.minor, pixel.minor)); // pi^2 / 6
}

// The share of a lobe's variance that a pixel's filter keeps.
GABOR_INLINE float gabor_impl_transmitted_3d(gabor_vec3 wave, GaborImplPixelAxes pixel) {
    gabor_vec2 d = gabor_impl_spread(pixel);
    gabor_vec2 k = gabor_vec2(gabor_cpp_dot(wave, pixel.major), gabor_cpp_dot(wave, pixel.minor));
    return gabor_cpp_exp(-gabor_cpp_min(9.8696044f * gabor_cpp_dot(k * k, 1.0f / d), 80.0f)) * gabor_cpp_inversesqrt(d.x * d.y); // pi^2
}

// Adds slice 0, as gabor_impl_add_slice does. The filter adds mixed derivatives, weighted by its covariances
// yz, zx and xy.
GABOR_INLINE void gabor_impl_add_filtered_slice(gabor_vec4& sum, gabor_vec4& slopes, GaborImplAxis x, GaborImplAxis y, GaborImplAxis z,
                                   gabor_vec3 mixed, float evolution) {
    gabor_vec4 slice, slope;
    gabor_impl_sum_slice(x, y, z, 0, evolution, slice, slope);
    gabor_impl_add_products(sum, slice, z.node[0].xy());
    slopes += gabor_vec4(gabor_impl_product(slope.xy(), z.node[0].xy()), gabor_impl_product(slice.xy(), z.node[0].zw()));
    sum += gabor_vec4(gabor_impl_product(mixed.x * slope.xy() + mixed.y * slice.zw(), z.node[0].zw())
                + mixed.z * gabor_impl_product(slope.zw(), z.node[0].xy()), 0.0f, 0.0f);
}

// The filtered noise of 27 nodes, with three waves along each axis. If not `wanted`, computes none of them. FXC
// compiles a loop whose length it does not know much faster than three calls.
GABOR_INLINE GaborField3d gabor_impl_filtered_narrow_3d(GaborPlace3d place, gabor_vec3 wave, GaborImplMatrix pixel, bool wanted,
                                           std::uint32_t salt) {
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                      GABOR_CELLS_PER_RADIUS);
    gabor_vec2 turn = gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    gabor_vec3 blurred = gabor_impl_symmetric_3d(pixel, wave);
    GaborImplAxis unused = x;
    gabor_impl_filter(x, pixel.diagonal.x, blurred.x, unused);
    gabor_impl_filter(y, pixel.diagonal.y, blurred.y, unused);
    gabor_impl_filter(z, pixel.diagonal.z, blurred.z, unused);
    gabor_vec4 sum = gabor_vec4(0.0f), slopes = gabor_vec4(0.0f);
    int slices = wanted ? 3 : 0;
    for (int k = 0; k < slices; ++k) {
        gabor_impl_add_filtered_slice(sum, slopes, x, y, z, pixel.mixed, place.evolution);
        z.node[0] = z.node[1];
        z.node[1] = z.node[2];
        z.word[0] = z.word[1];
        z.word[1] = z.word[2];
    }
    return gabor_impl_field_3d(sum, slopes, gabor_cpp_exp(-19.739209f * gabor_cpp_max(gabor_cpp_dot(wave, blurred), 0.0f)) * turn, wave); // 2 pi^2
}

GABOR_INLINE GaborField3d gabor_field_3d_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, gabor_vec3 wave, std::uint32_t seed) {
    gabor_vec3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = gabor_cpp_clamp(wave, -1.0e6f, 1.0e6f) / stretch;
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplPixelAxes whole = gabor_impl_pixel(dx, dy, stretch), resolved = gabor_impl_resolved(whole, 1.0f);
    float transmitted = gabor_impl_transmitted_3d(wave, whole);
    float amplitude = gabor_cpp_sqrt(transmitted / gabor_impl_transmitted_3d(wave, resolved));
    if (!(transmitted > 1.0e-10f)) transmitted = 0.0f; // also if it is NaN
    GaborImplMatrix pixel = gabor_impl_covariance(resolved);
    gabor_vec3 variance = pixel.diagonal;
    float wide = gabor_cpp_clamp(100.0f * gabor_cpp_sqrt(gabor_cpp_max(gabor_cpp_max(variance.x, variance.y), variance.z)) - 9.0f, 0.0f, 1.0f);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f - transmitted};
    bool kept = transmitted > 0.0f; // a return would take FXC longer
    if (kept && wide < 1.0f)
        gabor_impl_add_field_3d(sum, gabor_impl_filtered_narrow_3d(place, wave, pixel, wide < 1.0f, salt),
                                (1.0f - wide) * amplitude, stretch);
    if (kept && wide > 0.0f)
        gabor_impl_add_field_3d(sum, gabor_impl_filtered_wide_3d(place, wave, pixel, wide > 0.0f, salt),
                                wide * amplitude, stretch);
    return sum;
}

GABOR_INLINE GaborField3d gabor_field_surface_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, gabor_vec3 normal, float frequency,
                                          gabor_vec3 direction, std::uint32_t seed) {
    GaborImplSurface surface = gabor_impl_surface(normal, direction);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = surface.second < 1.0f ? 0 : 1; i < (surface.second > 0.0f ? 2 : 1); ++i) {
        gabor_vec3 wave = gabor_cpp_abs(frequency) * (i == 0 ? surface.direction : surface.other);
        float power = gabor_impl_takeover(i == 0 ? 1.0f - surface.second : surface.second);
        gabor_impl_add_field_3d(sum, gabor_field_3d_filtered(place, dx, dy, wave, gabor_derived_seed(seed, i)),
                                gabor_cpp_sqrt(power), gabor_vec3(1.0f));
    }
    return sum;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------

// A node's filtered window along an axis: its value is middle + cosine, its derivative sine. The window fades out
// within half a standard deviation of its ends.
struct GaborImplFilteredNode {
    float offset; // offset of the point from the node
    float middle;
    float cosine;
    float sine;
};

GABOR_INLINE GaborImplFilteredNode gabor_impl_filtered_node_3d(GaborImplNode node, float variance) {
    float width = gabor_cpp_clamp(0.5f * gabor_cpp_sqrt(variance), 0.001f, 0.05f);
    float t = gabor_cpp_clamp((1.0f - gabor_cpp_abs(node.offset)) / width, 0.0f, 1.0f), fade = t * t * (3.0f - 2.0f * t);
    float fall = fade * gabor_cpp_exp(-4.934802f * variance); // pi^2 / 2
    return GaborImplFilteredNode{node.offset, 0.5f * fade, fall * (node.value - 0.5f), fall * node.slope};
}

// Adds a wave of a node: see gabor_impl_add_wave_3d. The filter multiplies the wave by exp(-2 pi^2 F.S F). With
// s = 2 pi^2 S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
GABOR_INLINE void gabor_impl_add_filtered_wave_3d(GaborField3d& sum, GaborImplFilteredNode x, GaborImplFilteredNode y,
                                     GaborImplFilteredNode z, gabor_vec4 wave, float evolution, GaborImplMatrix pixel,
                                     std::uint32_t word) {
    gabor_vec2 a = gabor_impl_product(gabor_impl_amplitude_at(word, evolution), gabor_impl_wave(wave.w));
    gabor_vec3 middle = gabor_vec3(x.middle, y.middle, z.middle), cosine = gabor_vec3(x.cosine, y.cosine, z.cosine);
    gabor_vec3 sine = gabor_vec3(x.sine, y.sine, z.sine), s = 19.739209f * gabor_impl_symmetric_3d(pixel, wave.xyz());
    a *= gabor_cpp_exp(-gabor_cpp_max(gabor_cpp_dot(wave.xyz(), s), 0.0f));
    s = gabor_cpp_clamp(s, -3.0f, 3.0f); // changes no wave that the filter keeps
    gabor_vec3 r = s * s, even = 1.0f + r * (0.5f + 0.041666667f * r); // 1/24
    gabor_vec3 odd = s * (1.0f + r * (0.16666667f + 0.0083333333f * r)), h = middle + cosine; // 1/6, 1/120
    float mixed = gabor_cpp_dot(pixel.mixed, sine.yzx() * sine.zxy() * h);
    h = middle + even * cosine;
    gabor_vec3 i_h = 0.31830989f * odd * sine, i_slope = -3.1415927f * odd * cosine; // 1/pi, pi
    gabor_vec3 real = h.yzx() * h.zxy() - i_h.yzx() * i_h.zxy(), imaginary = h.yzx() * i_h.zxy() + i_h.yzx() * h.zxy();
    gabor_vec2 value =
        gabor_impl_product(gabor_vec2(h.x * real.x - i_h.x * imaginary.x + mixed, h.x * imaginary.x + i_h.x * real.x), a);
    gabor_vec3 slope = even * sine * real - i_slope * imaginary, turned = even * sine * imaginary + i_slope * real;
    sum.noise += value.y;
    sum.gradient += slope * a.y + turned * a.x + 6.2831853f * value.x * wave.xyz(); // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += slope * a.x - turned * a.y - 6.2831853f * value.y * wave.xyz();
}

GABOR_INLINE void gabor_impl_add_filtered_waves_3d(GaborField3d& sum, GaborImplFilteredNode x, GaborImplFilteredNode y,
                                      GaborImplFilteredNode z, gabor_vec3 scale, float evolution, GaborImplMatrix pixel,
                                      GaborImplTangents tangents, std::uint32_t column, gabor_uvec4 row) {
    gabor_vec3 d = scale * gabor_vec3(x.offset, y.offset, z.offset);
    GaborImplStar3d star = gabor_impl_star_3d(tangents, d, column * row.w);
    gabor_vec4 unit = gabor_vec4(scale, 1.0f);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.first, evolution, pixel, column * row.x);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.second, evolution, pixel, column * row.y);
    if (!tangents.only)
        gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.third, evolution, pixel, column * row.z);
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
GABOR_INLINE float gabor_impl_transmitted_isotropic(float frequency, GaborImplPixelAxes pixel, GaborImplTangents tangents) {
    gabor_vec2 d = gabor_impl_spread(pixel);
    gabor_vec2 unit = gabor_cpp_min(9.8696044f * frequency * frequency, 1.0e6f) / d; // pi^2
    float mean;
    if (tangents.only) {
        gabor_vec2 a = gabor_vec2(gabor_cpp_dot(tangents.along, pixel.major), gabor_cpp_dot(tangents.along, pixel.minor));
        gabor_vec2 b = gabor_vec2(gabor_cpp_dot(tangents.across, pixel.major), gabor_cpp_dot(tangents.across, pixel.minor));
        float sum = gabor_cpp_dot(unit, a * a + b * b), apart = gabor_cpp_length(gabor_vec2(gabor_cpp_dot(unit, a * a - b * b), 2.0f * gabor_cpp_dot(unit, a * b)));
        mean = gabor_cpp_exp(gabor_cpp_min(0.5f * (apart - sum), 0.0f)) * gabor_impl_mean_angle(apart);
    } else {
        gabor_vec2 q = unit * gabor_vec2(gabor_cpp_dot(pixel.major, pixel.major), gabor_cpp_dot(pixel.minor, pixel.minor));
        float larger = gabor_cpp_max(q.x, q.y), smaller = gabor_cpp_min(q.x, q.y);
        // fit: see tools/constants.py
        mean = gabor_cpp_sqrt((1.0f + larger * (0.31500545f + 0.08868891f * larger))
                    / (1.0f + larger * (0.98167212f + larger * (0.42128292f + 0.11292425f * larger))));
        mean *= gabor_impl_mean_angle(smaller * (1.0f - 1.0f / (3.0f + 0.8f * larger)));
    }
    return mean * gabor_cpp_inversesqrt(d.x * d.y);
}

GABOR_INLINE GaborField3d gabor_impl_isotropic_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, float frequency,
                                           GaborImplTangents tangents, std::uint32_t seed) {
    gabor_vec3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    frequency = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f);
    GaborImplPixelAxes whole = gabor_impl_pixel(dx, dy, gabor_vec3(1.0f)), resolved = gabor_impl_resolved(whole, 0.5f);
    float transmitted = gabor_impl_transmitted_isotropic(frequency, whole, tangents);
    float amplitude = gabor_cpp_sqrt(transmitted / gabor_impl_transmitted_isotropic(frequency, resolved, tangents));
    if (!(transmitted > 1.0e-10f)) transmitted = 0.0f; // also if it is NaN
    GaborField3d field = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 1.0f - transmitted};
    if (transmitted == 0.0f)
        return field;
    GaborImplMatrix pixel =
        gabor_impl_covariance(GaborImplPixelAxes{resolved.major * stretch, resolved.minor * stretch});
    gabor_vec3 s = pixel.diagonal, scale = frequency / stretch;
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0f, GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y =
        gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0f,
                        GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, 0.0f,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplFilteredNode x_0 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 0), s.x);
    GaborImplFilteredNode x_1 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 1), s.x);
    GaborImplFilteredNode x_2 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 2), s.x);
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = 0; i < 9; ++i) {
        GaborImplFilteredNode y_j = gabor_impl_filtered_node_3d(gabor_impl_node(y, i % 3), s.y);
        GaborImplFilteredNode z_k = gabor_impl_filtered_node_3d(gabor_impl_node(z, i / 3), s.z);
        gabor_uvec4 row = gabor_impl_row(gabor_impl_node_word(y, i % 3) * gabor_impl_node_word(z, i / 3));
        gabor_impl_add_filtered_waves_3d(sum, x_0, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[0], row);
        gabor_impl_add_filtered_waves_3d(sum, x_1, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[1], row);
        gabor_impl_add_filtered_waves_3d(sum, x_2, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[2], row);
    }
    amplitude *= gabor_cpp_inversesqrt((tangents.only ? 2.0f : 3.0f) * GABOR_IMPL_ENERGY)
               / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_impl_add_field_3d(field, sum, amplitude, stretch);
    return field;
}

GABOR_INLINE GaborField3d gabor_field_3d_isotropic_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, float frequency, std::uint32_t seed) {
    return gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_all_directions(), seed);
}

GABOR_INLINE GaborField3d gabor_field_surface_isotropic_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, gabor_vec3 normal, float frequency,
                                                    std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    float aside = gabor_cpp_dot(normal.xy(), normal.xy()); // see gabor_field_surface_isotropic
    GaborField3d sum = GaborField3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), 0.0f};
    for (int i = aside > 0.25f ? 0 : 1; i < (aside < 0.5f ? 2 : 1); ++i) {
        float power = gabor_impl_takeover(i == 0 ? gabor_cpp_smoothstep(0.25f, 0.5f, aside) : 1.0f - gabor_cpp_smoothstep(0.25f, 0.5f, aside));
        GaborField3d field = gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_tangents(normal, i),
                                                           gabor_derived_seed(seed, i));
        gabor_impl_add_field_3d(sum, field, gabor_cpp_sqrt(power), gabor_vec3(1.0f));
    }
    return sum;
}

#endif
