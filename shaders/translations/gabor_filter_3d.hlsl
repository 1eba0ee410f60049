// Generated from gabor_filter_3d.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl, gabor_spectrum.hlsl, gabor_filter.hlsl, gabor_noise_3d.hlsl; pasted after their texts, it includes nothing.
// It can do without gabor_spectrum.hlsl.
//
// gabor_filter_3d.hlsl: the noises of gabor_noise_3d.hlsl, averaged over a pixel.
//
//     GaborField3d f = gabor_field_3d_isotropic_filtered(gabor_place_3d_at(p), ddx(p), ddy(p), 2.0, 7u);
//
// dx and dy are the change of p, in kernel radii, from one pixel to the next along x and y; a field's `removed` is the
// share of the variance that averaging removed: see gabor_filter.hlsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#if !defined(GABOR_SPECTRUM_HLSL) && defined(__has_include)
#if __has_include("gabor_spectrum.hlsl")
#include "gabor_spectrum.hlsl"
#endif
#endif
#ifndef GABOR_FILTER_HLSL
#include "gabor_filter.hlsl"
#endif
#ifndef GABOR_NOISE_3D_HLSL
#include "gabor_noise_3d.hlsl"
#endif
#ifndef GABOR_FILTER_3D_HLSL
#define GABOR_FILTER_3D_HLSL 1

// GaborField3d gabor_field_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 wave, uint seed)
// GaborField3d gabor_field_surface_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 normal, float frequency,
//                                           float3 direction, uint seed)
//     The filtered noise. The error is that of gabor_field_filtered: 1 % as long as the pixel's longest axis is at most
//     a third of a kernel radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a
//     call costs 1.4 times as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2
//     (64 nodes), and at most 6.6 times (125 nodes).

// GaborField3d gabor_field_3d_isotropic_filtered(GaborPlace3d place, float3 dx, float3 dy, float frequency, uint seed)
// GaborField3d gabor_field_surface_isotropic_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 normal,
//                                                     float frequency, uint seed)
//     Filtered noise of waves in all directions. They cost less than twice as much as without the filter. The rms error
//     against exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3
//     kernel radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- The coupling of three axes ------------------------------------------------------------------------------------
//
// In addition to gabor_filter.hlsl: with M = S + v, a diagonal matrix D with D_ii^2 = M_ii / (M^-1)_ii, C = D^(-1/2) M
// D^(-1/2), B = (1 - C) (1 + C)^-1 and z = 2 pi D^(1/2) (q - c), the coupling of three axes is again a sum of products:
//     exp(-z.C z / 2) = sqrt(8 / |1 + C|) exp(-z.z / 2) (1 + 2 (B_yz z_y z_z + B_zx z_z z_x + B_xy z_x z_y) + ...).
// The right side is the series of exp(z.B z) with Hermite polynomials instead of powers of z, and without B's diagonal,
// which is at most 0.01. We use the terms up to the square of each factor.

// A symmetric 3 x 3 matrix.
struct GaborImplMatrix {
    float3 diagonal;
    float3 mixed; // yz, zx, xy
};

GaborImplMatrix GaborImplMatrix_of(float3 diagonal, float3 mixed) {
    GaborImplMatrix made = {diagonal, mixed};
    return made;
}

float3 gabor_impl_symmetric_3d(GaborImplMatrix m, float3 v) {
    return m.diagonal * v + m.mixed.zxy * v.yzx + m.mixed.yzx * v.zxy;
}

// The inverse times the determinant.
GaborImplMatrix gabor_impl_adjugate(GaborImplMatrix m, out float determinant) {
    GaborImplMatrix a = GaborImplMatrix_of(m.diagonal.yzx * m.diagonal.zxy - m.mixed * m.mixed,
                                        m.mixed.yzx * m.mixed.zxy - m.diagonal * m.mixed);
    determinant = m.diagonal.x * a.diagonal.x + m.mixed.y * a.mixed.y + m.mixed.z * a.mixed.z;
    return a;
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
float3 gabor_impl_along_z(float3 y_0, float3 y_1, float3 y_2, float3 w) {
    return float3(y_0.x + w.z * (y_1.y + 0.5 * w.z * y_2.z),
                w.y * (y_0.y + w.z * y_1.z) + w.x * (y_1.x + w.z * y_2.y),
                0.5 * (w.y * w.y * y_0.z + w.x * w.x * y_2.x) + w.x * w.y * (y_1.y + w.z * y_2.z));
}

// The weighted sum of the products of three axes' factors.
float2 gabor_impl_contracted_3d(GaborImplFactors y_0, GaborImplFactors y_1, GaborImplFactors y_2, GaborImplFactors z,
                              float3 w) {
    GaborImplFactors slice = GaborImplFactors_of(gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w),
                                              gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w));
    return gabor_impl_contracted(slice, z, (float3)(1.0));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
GaborField3d gabor_impl_filtered_wide_3d(GaborPlace3d place, float3 wave, GaborImplMatrix s, bool wanted, uint salt) {
    float determinant;
    // 0.13069097 is 1/3 - 2/pi^2
    GaborImplMatrix m = GaborImplMatrix_of(s.diagonal + 0.13069097, s.mixed); // S + v
    GaborImplMatrix adjugate = gabor_impl_adjugate(m, determinant);
    float3 blurred = gabor_impl_symmetric_3d(s, wave);
    float3 c = gabor_impl_symmetric_3d(adjugate, blurred) / -determinant;
    float3 d = sqrt(m.diagonal * determinant / adjugate.diagonal);
    float3 pairs = sqrt(d.yzx * d.zxy);
    adjugate = gabor_impl_adjugate(GaborImplMatrix_of(1.0 + m.diagonal / d, s.mixed / pairs), determinant); // of 1 + C
    // 157.91367 is 16 pi^2
    float3 w = 157.91367 / determinant * pairs * adjugate.mixed; // 8 pi^2 sqrt(D_yy D_zz) B_yz and so on
    GaborImplFilteredAxis x = gabor_impl_filtered_axis(sqrt(s.diagonal.x), d.x, c.x, place.cell.x, place.local.x,
                                                       place.period.x, salt,
                                                           gabor_impl_wave(wave.x / GABOR_CELLS_PER_RADIUS));
    GaborImplFilteredAxis y = gabor_impl_filtered_axis(sqrt(s.diagonal.y), d.y, c.y, place.cell.y, place.local.y,
                                                       place.period.y, salt ^ GABOR_IMPL_ROWS,
                                                       gabor_impl_wave(wave.y / GABOR_CELLS_PER_RADIUS));
    GaborImplFilteredAxis z = gabor_impl_filtered_axis(sqrt(s.diagonal.z), d.z, c.z, place.cell.z, place.local.z,
                                                       place.period.z, salt ^ GABOR_IMPL_SLICES,
                                                       gabor_impl_wave(wave.z / GABOR_CELLS_PER_RADIUS));
    GaborImplColumns columns = gabor_impl_columns(x);
    GaborImplFilteredLine first = gabor_impl_line_before(y, float2(y.back.x, -y.back.y));
    GaborImplFilteredLine slice = gabor_impl_line_before(
        z, gabor_impl_wave(dot(wave, float3(x.offset, y.offset, z.offset + 1.0)) / GABOR_CELLS_PER_RADIUS));
    GaborImplFactors none = GaborImplFactors_of((float3)(0.0), (float3)(0.0));
    int rows = wanted ? y.count : 0, slices = wanted ? z.count : 0; // see gabor_impl_filtered_wide
    float2 value = (float2)(0.0), next_x = (float2)(0.0), next_y = (float2)(0.0), next_z = (float2)(0.0);
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
    float3 real = float3(next_x.x, next_y.x, next_z.x), imaginary = float3(next_x.y, next_y.y, next_z.y);
    // 0.012665148 is 1/(8 pi^2)
    float3 quarter = 0.012665148 / d; // 1 / 4g, g = 2 pi^2 D
    real += (wave + c) * value.x + quarter * gabor_impl_symmetric_3d(GaborImplMatrix_of((float3)(0.0), w), real);
    imaginary += (wave + c) * value.y + quarter * gabor_impl_symmetric_3d(GaborImplMatrix_of((float3)(0.0), w), imaginary);
    float exponent = 19.739209 * (dot(wave + c, blurred) + dot(d, c * c));
    float scale = sqrt(8.0 / determinant / GABOR_IMPL_ENERGY) * exp(-exponent);
    scale /= GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY;
    // 6.2831853 is 2 pi
    return GaborField3d_of(scale * value.y, 6.2831853 * scale * real, scale * value.x, -6.2831853 * scale * imaginary,
                        0.0);
}
// ---- One wave vector -----------------------------------------------------------------------------------------------

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_CELLS_PER_RADIUS node spacings.
struct GaborImplPixelAxes {
    float3 major;
    float3 minor;
};

GaborImplPixelAxes GaborImplPixelAxes_of(float3 major, float3 minor) {
    GaborImplPixelAxes made = {major, minor};
    return made;
}

GaborImplPixelAxes gabor_impl_pixel(float3 dx, float3 dy, float3 stretch) {
    dx = clamp(dx, -1.0e6, 1.0e6) * stretch;
    dy = clamp(dy, -1.0e6, 1.0e6) * stretch;
    float2 twice = float2(dot(dx, dx) - dot(dy, dy), 2.0 * dot(dx, dy)); // at twice the angle of `turn`
    float cosine = twice.x / max(length(twice), 1.0e-30);
    float2 turn = sqrt(max(0.5 + float2(0.5, -0.5) * cosine, 0.0));
    if (twice.y < 0.0) turn.y = -turn.y;
    return GaborImplPixelAxes_of(turn.x * dx + turn.y * dy, turn.x * dy - turn.y * dx);
}

// Limits the length of each axis to `most`.
GaborImplPixelAxes gabor_impl_resolved(GaborImplPixelAxes pixel, float most) {
    return GaborImplPixelAxes_of(most * rsqrt(max(dot(pixel.major, pixel.major), most * most)) * pixel.major,
                              most * rsqrt(max(dot(pixel.minor, pixel.minor), most * most)) * pixel.minor);
}

GaborImplMatrix gabor_impl_covariance(GaborImplPixelAxes pixel) {
    float3 major = 0.5 * pixel.major, minor = 0.5 * pixel.minor;
    return GaborImplMatrix_of(major * major + minor * minor, major.yzx * major.zxy + minor.yzx * minor.zxy);
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
float2 gabor_impl_spread(GaborImplPixelAxes pixel) {
    return 1.0 + 1.6449341 * float2(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor)); // pi^2 / 6
}

// The share of a lobe's variance that a pixel's filter keeps.
float gabor_impl_transmitted_3d(float3 wave, GaborImplPixelAxes pixel) {
    float2 d = gabor_impl_spread(pixel);
    float2 k = float2(dot(wave, pixel.major), dot(wave, pixel.minor));
    return exp(-min(9.8696044 * dot(k * k, 1.0 / d), 80.0)) * rsqrt(d.x * d.y); // pi^2
}

// Adds slice 0, as gabor_impl_add_slice does. The filter adds mixed derivatives, weighted by its covariances
// yz, zx and xy.
void gabor_impl_add_filtered_slice(inout float4 sum, inout float4 slopes, GaborImplAxis x, GaborImplAxis y, GaborImplAxis z,
                                   float3 mixed, float evolution) {
    float4 slice, slope;
    gabor_impl_sum_slice(x, y, z, 0, evolution, slice, slope);
    gabor_impl_add_products(sum, slice, z.node[0].xy);
    slopes += float4(gabor_impl_product(slope.xy, z.node[0].xy), gabor_impl_product(slice.xy, z.node[0].zw));
    sum += float4(gabor_impl_product(mixed.x * slope.xy + mixed.y * slice.zw, z.node[0].zw)
                + mixed.z * gabor_impl_product(slope.zw, z.node[0].xy), 0.0, 0.0);
}

// The filtered noise of 27 nodes, with three waves along each axis. If not `wanted`, computes none of them. FXC
// compiles a loop whose length it does not know much faster than three calls.
GaborField3d gabor_impl_filtered_narrow_3d(GaborPlace3d place, float3 wave, GaborImplMatrix pixel, bool wanted,
                                           uint salt) {
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                      GABOR_CELLS_PER_RADIUS);
    float2 turn = gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    float3 blurred = gabor_impl_symmetric_3d(pixel, wave);
    GaborImplAxis unused = x;
    gabor_impl_filter(x, pixel.diagonal.x, blurred.x, unused);
    gabor_impl_filter(y, pixel.diagonal.y, blurred.y, unused);
    gabor_impl_filter(z, pixel.diagonal.z, blurred.z, unused);
    float4 sum = (float4)(0.0), slopes = (float4)(0.0);
    int slices = wanted ? 3 : 0;
    for (int k = 0; k < slices; ++k) {
        gabor_impl_add_filtered_slice(sum, slopes, x, y, z, pixel.mixed, place.evolution);
        z.node[0] = z.node[1];
        z.node[1] = z.node[2];
        z.word[0] = z.word[1];
        z.word[1] = z.word[2];
    }
    return gabor_impl_field_3d(sum, slopes, exp(-19.739209 * max(dot(wave, blurred), 0.0)) * turn, wave); // 2 pi^2
}

GaborField3d gabor_field_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 wave, uint seed) {
    float3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = clamp(wave, -1.0e6, 1.0e6) / stretch;
    uint salt = gabor_impl_salt(seed);
    GaborImplPixelAxes whole = gabor_impl_pixel(dx, dy, stretch), resolved = gabor_impl_resolved(whole, 1.0);
    float transmitted = gabor_impl_transmitted_3d(wave, whole);
    float amplitude = sqrt(transmitted / gabor_impl_transmitted_3d(wave, resolved));
    if (!(transmitted > 1.0e-10)) transmitted = 0.0; // also if it is NaN
    GaborImplMatrix pixel = gabor_impl_covariance(resolved);
    float3 variance = pixel.diagonal;
    float wide = clamp(100.0 * sqrt(max(max(variance.x, variance.y), variance.z)) - 9.0, 0.0, 1.0);
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 1.0 - transmitted);
    bool kept = transmitted > 0.0; // a return would take FXC longer
    if (kept && wide < 1.0)
        gabor_impl_add_field_3d(sum, gabor_impl_filtered_narrow_3d(place, wave, pixel, wide < 1.0, salt),
                                (1.0 - wide) * amplitude, stretch);
    if (kept && wide > 0.0)
        gabor_impl_add_field_3d(sum, gabor_impl_filtered_wide_3d(place, wave, pixel, wide > 0.0, salt),
                                wide * amplitude, stretch);
    return sum;
}

GaborField3d gabor_field_surface_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 normal, float frequency,
                                          float3 direction, uint seed) {
    GaborImplSurface surface = gabor_impl_surface(normal, direction);
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = surface.second < 1.0 ? 0 : 1; i < (surface.second > 0.0 ? 2 : 1); ++i) {
        float3 wave = abs(frequency) * (i == 0 ? surface.direction : surface.other);
        float power = gabor_impl_takeover(i == 0 ? 1.0 - surface.second : surface.second);
        gabor_impl_add_field_3d(sum, gabor_field_3d_filtered(place, dx, dy, wave, gabor_derived_seed(seed, i)),
                                sqrt(power), (float3)(1.0));
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

GaborImplFilteredNode GaborImplFilteredNode_of(float offset, float middle, float cosine, float sine) {
    GaborImplFilteredNode made = {offset, middle, cosine, sine};
    return made;
}

GaborImplFilteredNode gabor_impl_filtered_node_3d(GaborImplNode node, float variance) {
    float width = clamp(0.5 * sqrt(variance), 0.001, 0.05);
    float t = clamp((1.0 - abs(node.offset)) / width, 0.0, 1.0), fade = t * t * (3.0 - 2.0 * t);
    float fall = fade * exp(-4.934802 * variance); // pi^2 / 2
    return GaborImplFilteredNode_of(node.offset, 0.5 * fade, fall * (node.value - 0.5), fall * node.slope);
}

// Adds a wave of a node: see gabor_impl_add_wave_3d. The filter multiplies the wave by exp(-2 pi^2 F.S F). With
// s = 2 pi^2 S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
void gabor_impl_add_filtered_wave_3d(inout GaborField3d sum, GaborImplFilteredNode x, GaborImplFilteredNode y,
                                     GaborImplFilteredNode z, float4 wave, float evolution, GaborImplMatrix pixel,
                                     uint word) {
    float2 a = gabor_impl_product(gabor_impl_amplitude_at(word, evolution), gabor_impl_wave(wave.w));
    float3 middle = float3(x.middle, y.middle, z.middle), cosine = float3(x.cosine, y.cosine, z.cosine);
    float3 sine = float3(x.sine, y.sine, z.sine), s = 19.739209 * gabor_impl_symmetric_3d(pixel, wave.xyz);
    a *= exp(-max(dot(wave.xyz, s), 0.0));
    s = clamp(s, -3.0, 3.0); // changes no wave that the filter keeps
    float3 r = s * s, even = 1.0 + r * (0.5 + 0.041666667 * r); // 1/24
    float3 odd = s * (1.0 + r * (0.16666667 + 0.0083333333 * r)), h = middle + cosine; // 1/6, 1/120
    float mixed = dot(pixel.mixed, sine.yzx * sine.zxy * h);
    h = middle + even * cosine;
    float3 i_h = 0.31830989 * odd * sine, i_slope = -3.1415927 * odd * cosine; // 1/pi, pi
    float3 real = h.yzx * h.zxy - i_h.yzx * i_h.zxy, imaginary = h.yzx * i_h.zxy + i_h.yzx * h.zxy;
    float2 value =
        gabor_impl_product(float2(h.x * real.x - i_h.x * imaginary.x + mixed, h.x * imaginary.x + i_h.x * real.x), a);
    float3 slope = even * sine * real - i_slope * imaginary, turned = even * sine * imaginary + i_slope * real;
    sum.noise += value.y;
    sum.gradient += slope * a.y + turned * a.x + 6.2831853 * value.x * wave.xyz; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += slope * a.x - turned * a.y - 6.2831853 * value.y * wave.xyz;
}

void gabor_impl_add_filtered_waves_3d(inout GaborField3d sum, GaborImplFilteredNode x, GaborImplFilteredNode y,
                                      GaborImplFilteredNode z, float3 scale, float evolution, GaborImplMatrix pixel,
                                      GaborImplTangents tangents, uint column, uint4 row) {
    float3 d = scale * float3(x.offset, y.offset, z.offset);
    GaborImplStar3d star = gabor_impl_star_3d(tangents, d, column * row.w);
    float4 unit = float4(scale, 1.0);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.first, evolution, pixel, column * row.x);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.second, evolution, pixel, column * row.y);
    if (!tangents.only)
        gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.third, evolution, pixel, column * row.z);
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
float gabor_impl_transmitted_isotropic(float frequency, GaborImplPixelAxes pixel, GaborImplTangents tangents) {
    float2 d = gabor_impl_spread(pixel);
    float2 unit = min(9.8696044 * frequency * frequency, 1.0e6) / d; // pi^2
    float mean;
    if (tangents.only) {
        float2 a = float2(dot(tangents.along, pixel.major), dot(tangents.along, pixel.minor));
        float2 b = float2(dot(tangents.across, pixel.major), dot(tangents.across, pixel.minor));
        float sum = dot(unit, a * a + b * b), apart = length(float2(dot(unit, a * a - b * b), 2.0 * dot(unit, a * b)));
        mean = exp(min(0.5 * (apart - sum), 0.0)) * gabor_impl_mean_angle(apart);
    } else {
        float2 q = unit * float2(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor));
        float larger = max(q.x, q.y), smaller = min(q.x, q.y);
        // fit: see tools/constants.py
        mean = sqrt((1.0 + larger * (0.31500545 + 0.08868891 * larger))
                    / (1.0 + larger * (0.98167212 + larger * (0.42128292 + 0.11292425 * larger))));
        mean *= gabor_impl_mean_angle(smaller * (1.0 - 1.0 / (3.0 + 0.8 * larger)));
    }
    return mean * rsqrt(d.x * d.y);
}

GaborField3d gabor_impl_isotropic_filtered(GaborPlace3d place, float3 dx, float3 dy, float frequency,
                                           GaborImplTangents tangents, uint seed) {
    float3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    frequency = min(abs(frequency), 1.0e6);
    GaborImplPixelAxes whole = gabor_impl_pixel(dx, dy, (float3)(1.0)), resolved = gabor_impl_resolved(whole, 0.5);
    float transmitted = gabor_impl_transmitted_isotropic(frequency, whole, tangents);
    float amplitude = sqrt(transmitted / gabor_impl_transmitted_isotropic(frequency, resolved, tangents));
    if (!(transmitted > 1.0e-10)) transmitted = 0.0; // also if it is NaN
    GaborField3d field = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 1.0 - transmitted);
    if (transmitted == 0.0)
        return field;
    GaborImplMatrix pixel =
        gabor_impl_covariance(GaborImplPixelAxes_of(resolved.major * stretch, resolved.minor * stretch));
    float3 s = pixel.diagonal, scale = frequency / stretch;
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y =
        gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                        GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, 0.0,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplFilteredNode x_0 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 0), s.x);
    GaborImplFilteredNode x_1 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 1), s.x);
    GaborImplFilteredNode x_2 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 2), s.x);
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = 0; i < 9; ++i) {
        GaborImplFilteredNode y_j = gabor_impl_filtered_node_3d(gabor_impl_node(y, i % 3), s.y);
        GaborImplFilteredNode z_k = gabor_impl_filtered_node_3d(gabor_impl_node(z, i / 3), s.z);
        uint4 row = gabor_impl_row(gabor_impl_node_word(y, i % 3) * gabor_impl_node_word(z, i / 3));
        gabor_impl_add_filtered_waves_3d(sum, x_0, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[0], row);
        gabor_impl_add_filtered_waves_3d(sum, x_1, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[1], row);
        gabor_impl_add_filtered_waves_3d(sum, x_2, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[2], row);
    }
    amplitude *= rsqrt((tangents.only ? 2.0 : 3.0) * GABOR_IMPL_ENERGY)
               / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_impl_add_field_3d(field, sum, amplitude, stretch);
    return field;
}

GaborField3d gabor_field_3d_isotropic_filtered(GaborPlace3d place, float3 dx, float3 dy, float frequency, uint seed) {
    return gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_all_directions(), seed);
}

GaborField3d gabor_field_surface_isotropic_filtered(GaborPlace3d place, float3 dx, float3 dy, float3 normal, float frequency,
                                                    uint seed) {
    normal = gabor_impl_unit(normal);
    float aside = dot(normal.xy, normal.xy); // see gabor_field_surface_isotropic
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = aside > 0.25 ? 0 : 1; i < (aside < 0.5 ? 2 : 1); ++i) {
        float power = gabor_impl_takeover(i == 0 ? smoothstep(0.25, 0.5, aside) : 1.0 - smoothstep(0.25, 0.5, aside));
        GaborField3d field = gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_tangents(normal, i),
                                                           gabor_derived_seed(seed, i));
        gabor_impl_add_field_3d(sum, field, sqrt(power), (float3)(1.0));
    }
    return sum;
}

#endif
