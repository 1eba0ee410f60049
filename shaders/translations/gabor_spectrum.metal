// Generated from gabor_spectrum.glsl by tools/translate, for the Metal shading language: change that file, not this one.
//
// gabor_spectrum.metal: Gabor noise with any power spectrum, or averaged over a pixel.
//
// Paste or include this file after gabor_noise.metal.
//
//     float n = gabor_noise_spread(p, 2.0, 0.0, 0.0, 1.5707963, 7u);          // isotropic: mean 0, variance 1
//     float2 f = gabor_noise_filtered(p, dFdx(p), dFdy(p), 4.0, 0.7854, 7u);    // averaged over a pixel
//
// Positions are in kernel radii, as in gabor_noise.metal. Noise has variance 1; filtered noise has variance 1 minus
// the removed share. The filter needs GABOR_TAPS 3, the default.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#include <metal_stdlib>

using namespace metal;

#ifndef GABOR_NOISE_METAL
#error Include gabor_noise.metal before gabor_spectrum.metal
#endif
#ifndef GABOR_SPECTRUM_METAL
#define GABOR_SPECTRUM_METAL

// The maximum number of lobes in a GaborLobes; to change it, define it before this file.
#ifndef GABOR_LOBES
#define GABOR_LOBES 4
#endif
#if GABOR_LOBES < 1
#error GABOR_LOBES must be an int, at least 1
#endif

// ---- Sums of lobes -------------------------------------------------------------------------------------------------

// A lobe: waves around one wave vector. gabor_lobe returns it and documents its members.
struct GaborLobe {
    float frequency;
    float orientation;
    float2 radius;
    float power;
};

// A power spectrum: the first `count` lobes, at most GABOR_LOBES.
struct GaborLobes {
    GaborLobe lobe[GABOR_LOBES];
    int count;
};

// GaborLobe gabor_lobe(float frequency, float orientation, float radius, float power)
//     A lobe of waves around one wave vector.
//       frequency    cycles per unit of p, whatever the radius
//       orientation  as in gabor_noise
//       radius       radius of the lobe's kernels in units of p, positive. The lobe's standard deviation along each
//                    axis is 1/sqrt(12) / radius cycles per unit of p
//       power        power relative to the other lobes, not negative

// GaborLobe gabor_lobe_elliptical(float frequency, float orientation, float2 radius, float power)
//     The same with different kernel radii along x and y, at the same cost.

// float gabor_noise_lobes(float2 p, GaborLobes lobes, uint seed)
//     The noise of several lobes at p: a sum of independent noises, normal with mean 0 and variance 1. Costs one
//     gabor_noise per lobe.
//         #define GABOR_LOBES 2              // before the file
//         GaborLobes lobes;
//         lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//         lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//         lobes.count = 2;
//         float n = gabor_noise_lobes(p, lobes, 7u);

// float3 gabor_noise_lobes_gradient(float2 p, GaborLobes lobes, uint seed)
//     The noise with its analytic gradient per unit of p: (noise, d/dx, d/dy).

// float2 gabor_noise_lobes_complex(float2 p, GaborLobes lobes, uint seed)
//     The noise with its quadrature, like gabor_noise_complex.

// ---- A range of waves, up to isotropic noise -----------------------------------------------------------------------

// float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread,
//                          float orientation_spread, uint seed)
//     Noise of many waves at p. Their orientations are within `orientation_spread` radians of `orientation`, and their
//     frequencies within the fraction `frequency_spread` (0 to 1) of `frequency`, spread as evenly as lobes of kernel
//     radius 1 allow. An orientation_spread of pi/2 gives isotropic noise; its power varies with direction by at most
//     5 % at frequencies from 0.12 to 14, and by up to 7 % at lower ones. The noise has mean 0 and variance 1; it and
//     its derivatives are normal. It is continuous where the arguments are. Costs one gabor_noise per lobe. There are
//         2.86 frequency_spread frequency + 0.8 frequencies, 1 to 16, each with
//         (4.44 frequency + 0.6) orientation_spread / (pi/2) + 0.8 directions, 1 to 64,
//     both rounded down: 10 directions for isotropic noise of frequency 2. Just before one of these numbers changes,
//     for a fifth of all arguments, the noise is a sum of both sets of lobes, the old and the new.

// float3 gabor_noise_spread_gradient(float2 p, float frequency, float orientation, float frequency_spread,
//                                  float orientation_spread, uint seed)
//     The noise with its analytic gradient: (noise, d/dx, d/dy).

// float2 gabor_noise_spread_complex(float2 p, float frequency, float orientation, float frequency_spread,
//                                 float orientation_spread, uint seed)
//     The noise with its quadrature, like gabor_noise_complex.

// ---- Isotropic noise at a constant cost ----------------------------------------------------------------------------

// float gabor_noise_isotropic(float2 p, float frequency, uint seed)
//     Noise of waves in all directions at p, at the same cost for every frequency: 3.5 times that of gabor_noise. It
//     has mean 0 and variance 1; value and gradient are normal at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Values at several points together follow a mixture
//     of normal distributions; those of gabor_noise_spread, a sum over directions, are jointly normal.

// float3 gabor_noise_isotropic_gradient(float2 p, float frequency, uint seed)
//     The noise with its analytic gradient: (noise, d/dx, d/dy).

// float gabor_noise_isotropic_tiled(float2 p, float2 period, float frequency, uint seed)
//     The noise with a period, like gabor_noise_tiled.

// float2 gabor_noise_isotropic_filtered(float2 p, float2 dx, float2 dy, float frequency, uint seed)
//     (noise, removed), like gabor_noise_filtered, with GABOR_TAPS 3, at about twice the cost of gabor_noise_isotropic.
//     The rms error against exactly filtered noise is 2 % of a standard deviation while the pixel's longest axis is at
//     most 0.3 kernel radii, and 4 % at 0.4. For larger pixels, only the variance is right.

// ---- Filtered for a pixel, with GABOR_TAPS 3 -----------------------------------------------------------------------

// float2 gabor_noise_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed)
//     (noise, removed): Gabor noise at p averaged over a pixel, and the share of its variance that averaging removed.
//     A material can add the removed share, which is lost contrast, to its roughness.
//       dx, dy  change of p from one pixel to the next along x and y: dFdx(p) and dFdy(p), or any two vectors. If p
//               is fract(uv), which jumps, take the derivatives of uv. The filter is Gaussian with the covariance
//               (dx dx^T + dy dy^T) / 4: its standard deviation is half a pixel.
//     The rms error against exactly filtered noise is at most 1 % of a standard deviation while the pixel's longest
//     axis, twice the filter's largest standard deviation, is at most a third of a kernel radius, and 2 % up to a whole
//     radius; at the worst point, these errors are 2 and 3 %. For larger pixels, only the variance is right. The result
//     is continuous in p, dx and dy. The cost on GPUs, relative to gabor_noise, is 1.4 for pixels up to 0.18 kernel
//     radii (9 nodes), 3.1 from 0.2 (16 nodes), 3.4 from 0.66 along x or y (20 nodes), and 3.8 from 0.66 along both (25
//     nodes); between 0.18 and 0.2, both of the first two filters run. On CPUs, where drivers run both sides of a
//     branch, the cost is 3 for small pixels and 5 for larger ones.

// float4 gabor_noise_filtered_gradient(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed)
//     The noise with its gradient: (noise, d/dx, d/dy, removed). The gradient ignores the fading of the windows, so its
//     error is up to 7 %.

// float4 gabor_noise_four_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed,
//                                out float removed)
//     The four noises of gabor_noise_four, filtered, and the share of its variance that each lost.

// float2 gabor_noise_lobes_filtered(float2 p, float2 dx, float2 dy, GaborLobes lobes, uint seed)
//     The noise of gabor_noise_lobes, filtered: (noise, removed).

// float4 gabor_noise_lobes_filtered_gradient(float2 p, float2 dx, float2 dy, GaborLobes lobes, uint seed)
//     The noise with its gradient: (noise, d/dx, d/dy, removed).

// float4 gabor_stripes_filtered(float2 p, float2 dx, float2 dy, float2 wave, float sharpness, uint seed)
//     gabor_stripes, filtered: (cosine, sine, intensity, removed). Each value is the mean over the removed part of the
//     noise, within 0.1. So (cosine, sine) gets shorter as waves are removed, and its profiles fade to their mean.

// ---- Profiles of a phase, each from 0 to 1 -------------------------------------------------------------------------
//
// The first five take a phase in turns and average over `width` turns, 0.001 to 1: the change of the phase over a
// pixel, for example the frequency times the length of dFdx(p).

// float gabor_profile_sine(float phase, float width)
//     A sine wave from 0 at phase 0 to 1 at half a turn.

// float gabor_profile_triangle(float phase, float width)
//     Straight lines from 0 at phase 0 to 1 at half a turn and back.

// float gabor_profile_sawtooth(float phase, float width)
//     A straight line from 0 at phase 0 to 1 after a turn.

// float gabor_profile_pulse(float phase, float duty, float width)
//     1 for the first `duty` (0 to 1) of each turn, then 0.

// float gabor_profile_ridges(float phase, float width)
//     Round ridges between sharp creases: a parabola, 0 at phase 0 and 1 at half a turn.

// The others take the (cosine, sine) of stripes instead of a phase and a width. The profile is sharp where this vector
// has length 1. Where the vector is shorter, because variance was removed or stripes fork, the profile is averaged over
// a range of phases whose mean vector has that length.

// float gabor_stripes_sine(float2 stripes)
// float gabor_stripes_triangle(float2 stripes)
// float gabor_stripes_sawtooth(float2 stripes)
// float gabor_stripes_pulse(float2 stripes, float duty)
// float gabor_stripes_ridges(float2 stripes)
//     The profiles of gabor_profile_sine and so on.

// ---- For large worlds, and for periods combined with time ----------------------------------------------------------

// GaborPlace gabor_place_scaled(GaborPlace place, float radius)
// GaborPlace gabor_place_stretched(GaborPlace place, float2 radius)
//     The same position, period and time, for kernels whose radius is `radius` times the place's; the factor may differ
//     along x and y. The position is rounded to a float, within the period if there is one.

// GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, uint seed)
//     The noise of a sum of lobes, with its quadrature and derivatives per kernel radius of the place.

// GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
//                               float orientation_spread, uint seed)
//     The noise of a range of waves, like gabor_noise_spread, with quadrature and derivatives per kernel radius.

// GaborField gabor_field_isotropic(GaborPlace place, float frequency, uint seed)
//     Isotropic noise at `place`, with quadrature and derivatives. At each point the quadrature is independent of the
//     noise, but not of the noise's gradient.

#if GABOR_TAPS == 3
// The filter of a pixel, returned by gabor_footprint.
struct GaborFootprint {
    float3 covariance; // xx, yy, xy in kernel radii^2
    float3 resolved;   // the same, limited to standard deviations of 1/2, the most that the windows allow
};
#endif

// GaborFootprint gabor_footprint(float2 dx, float2 dy)
//     The footprint of a pixel, from dx and dy as in gabor_noise_filtered.

// float4 gabor_stripes_filtered_at(GaborPlace place, float2 wave, GaborFootprint footprint, float sharpness, uint seed)
//     The same as gabor_stripes_filtered, at `place`, with a footprint as in gabor_field_filtered.

// GaborField gabor_field_filtered(GaborPlace place, GaborKernel kernel, GaborFootprint footprint, uint seed,
//                                 out float removed)
//     The filtered noise at `place`, with quadrature and derivatives, and the removed share of its variance. With a
//     period, multiply dx and dy by place.radius / GABOR_RADIUS before calling gabor_footprint, because nodes are then
//     not 1 / GABOR_RADIUS kernel radii apart.

// GaborField gabor_field_isotropic_filtered(GaborPlace place, float frequency, GaborFootprint footprint, uint seed,
//                                           out float removed)
//     The same for isotropic noise.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

inline void gabor_impl_add_field(thread GaborField& sum, GaborField field, float amplitude) {
    sum.value += amplitude * field.value;
    sum.slope_x += amplitude * field.slope_x;
    sum.slope_y += amplitude * field.slope_y;
}

inline GaborPlace gabor_place_stretched(GaborPlace place, float2 radius) {
    int2 cell = int2(gabor_impl_wrap(place.cell.x, place.period.x), gabor_impl_wrap(place.cell.y, place.period.y));
    float2 unit = 1.0 / (place.radius * radius);
    GaborPlace scaled = gabor_place_tiled((float2(cell) + place.local) * unit, float2(place.period) * unit);
    scaled.animated = place.animated;
    scaled.moment = place.moment;
    return scaled;
}

inline GaborPlace gabor_place_scaled(GaborPlace place, float radius) {
    return gabor_place_stretched(place, float2(radius));
}

// A lobe's wave vector, in cycles per kernel radius along each axis.
inline GaborKernel gabor_impl_lobe_kernel(GaborLobe lobe) {
    GaborKernel kernel_ = gabor_kernel(lobe.frequency * lobe.radius.x, lobe.orientation);
    kernel_.wave.y *= lobe.radius.y / lobe.radius.x;
    return kernel_;
}

inline GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, uint seed) {
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0)};
    float power = 0.0;
    for (int i = 0; i < min(lobes.count, GABOR_LOBES); ++i) {
        GaborLobe lobe = lobes.lobe[i];
        GaborPlace stretched = gabor_place_stretched(place, lobe.radius);
        GaborField field = gabor_field(stretched, gabor_impl_lobe_kernel(lobe), gabor_lobe_seed(seed, i));
        field.slope_x /= lobe.radius.x;
        field.slope_y /= lobe.radius.y;
        gabor_impl_add_field(sum, field, sqrt(lobe.power));
        power += lobe.power;
    }
    float scale = power > 0.0 ? rsqrt(power) : 0.0;
    return GaborField{scale * sum.value, scale * sum.slope_x, scale * sum.slope_y};
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is cut into equal pieces of at most 0.7 cycles per kernel radius, with a lobe in the middle of each.
// The power of Hann's window has a standard deviation of 1/sqrt(12) cycles per kernel radius, so the sum of the lobes
// is nearly flat. The number of pieces is the integer part of a number c. As the fraction of c goes from 0.8 to 1,
// these pieces fade out and a set with one more piece fades in, so that the noise is continuous in frequency and
// spread.

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
inline float gabor_impl_takeover(float x) {
    return x * x / (x * x + (1.0 - x) * (1.0 - x));
}

// The number of lobes for `c`; while one set fades into the next, the total of both.
inline int gabor_impl_pieces(float c) {
    return fract(c) > 0.8 ? 2 * int(c) + 1 : int(c);
}

// Returns lobe `i` as (position in the range, from -1 to 1; share of the power; number from which its seed derives).
inline float3 gabor_impl_piece(int i, float c) {
    int n = int(c);
    float left = min(5.0 - 5.0 * fract(c), 1.0);
    if (i >= n) {
        i -= n;
        n += 1;
        left = 1.0 - left;
    }
    float width = 1.0 / float(n);
    return float3((2.0 * float(i) + 1.0) * width - 1.0, gabor_impl_takeover(left) * width, float(i + (n & 1) * 64));
}

inline GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
                              float orientation_spread, uint seed) {
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0)};
    frequency = min(abs(frequency), 1.0e6);
    frequency_spread = clamp(frequency_spread, 0.0, 1.0);
    orientation_spread = clamp(orientation_spread, 0.0, 1.5707963);
    float shells = clamp(2.857 * frequency_spread * frequency + 0.8, 1.0, 16.0);
    int shell_count = gabor_impl_pieces(shells);
    for (int j = 0; j < shell_count; ++j) {
        float3 shell = gabor_impl_piece(j, shells);
        float magnitude = frequency * (1.0 + frequency_spread * shell.x);
        float directions = clamp(0.63661977 * orientation_spread * (4.44 * magnitude + 0.6) + 0.8, 1.0, 64.0);
        int direction_count = gabor_impl_pieces(directions);
        for (int i = 0; i < direction_count; ++i) {
            float3 direction = gabor_impl_piece(i, directions);
            GaborKernel kernel_ = gabor_kernel(magnitude, orientation + orientation_spread * direction.x);
            GaborField field = gabor_field(place, kernel_, gabor_lobe_seed(seed, int(128.0 * shell.z + direction.z)));
            float amplitude = sqrt(shell.y * direction.y);
            gabor_impl_add_field(sum, field, amplitude);
        }
    }
    return sum;
}

// ---- The filter ----------------------------------------------------------------------------------------------------
//
// A Gaussian filter of covariance S multiplies a wave with wave vector k by exp(-2 pi^2 k.S k). If H is the Fourier
// transform of h, one node's kernel h(x) h(y) e^(2 pi i F.d) becomes the integral over q of
//
//     H(q_x) H(q_y) exp(-2 pi^2 (F + q).S (F + q)) e^(2 pi i (F + q).d).
//
// Along an axis and within w of the node, this is a Fourier series of period 2w: a sum over q = a / 2w. With w = 1, the
// three waves a = -1, 0, 1 are h itself. After the filter, they are wrong only near the ends of h: by less than 1 % of
// the noise's standard deviation if the filter's standard deviation is at most 0.1 kernel radii. A wider filter widens
// the kernel beyond the ends of h, and needs the seven waves a = -3 ... 3: with w = 4/3 and four nodes along the axis
// up to a standard deviation of 0.33, and with w up to 5/3 and five nodes beyond that. Between 0.09 and 0.1, seven
// waves gradually replace three. All of this is for GABOR_TAPS 3.
//
// The factor exp(-4 pi^2 S_xy q_x q_y) couples the axes. It acts like exp(S_xy d/dx d/dy): for three waves, 1 + S_xy
// d/dx d/dy is enough. For seven waves, we use the fact that H is nearly a Gaussian:
// H = (H e^(2 pi^2 v q^2)) e^(-2 pi^2 v q^2), where v = 1/3 - 2/pi^2 is the variance of h. Mehler's formula (DLMF
// 18.18.28) then separates the axes: with M = S + v, the centre c = -M^-1 S F of the filtered lobe,
// rho = M_xy / sqrt(M_xx M_yy), r = sqrt(1 - rho^2), lambda = rho / (1 + r) and, for each axis, g = 2 pi^2 r M and
// z = sqrt(2 g) (q - c),
//
//     exp(-2 pi^2 (q - c).M (q - c)) = sqrt(1 - lambda^2) exp(-(z_x^2 + z_y^2) / 2)
//                                      (1 - 2 lambda z_x z_y + 2 lambda^2 (z_x^2 - 1/2) (z_y^2 - 1/2) - ...).
//
// We use these three terms; |lambda| is at most 0.26.

#if GABOR_TAPS == 3
// A symmetric matrix (xx, yy, xy) times a vector.
inline float2 gabor_impl_symmetric(float3 matrix_, float2 v) {
    return matrix_.xy * v + matrix_.z * v.yx;
}

// The share of a lobe's variance that a filter of covariance S keeps. If we approximate the lobe's power by a
// Gaussian with the variance 1/12 of Hann's window along each axis, and d is the determinant of 1 + 2/3 pi^2 S, this is
//     d^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F),   where S (1 + 2/3 pi^2 S)^-1 = (S + 2/3 pi^2 |S|) / d.
inline float gabor_impl_transmitted(float2 wave, float3 covariance) {
    float area = 6.5797363 * (covariance.x * covariance.y - covariance.z * covariance.z);
    float d = 1.0 + 6.5797363 * (covariance.x + covariance.y + area);
    float exponent = 39.478418 / d * dot(wave, gabor_impl_symmetric(covariance, wave) + area * wave);
    return exp(-clamp(exponent, 0.0, 80.0)) * rsqrt(d);
}

// Approximates exp(-q/2) I_0(q/2), the mean of exp(-q cos^2) over angles, by the square root of a rational function.
inline float gabor_impl_mean_angle(float q) {
    return sqrt((1.0 + q * (0.19075951 + 0.0865599 * q))
                / (1.0 + q * (1.1907595 + q * (0.60787136 + 0.27193595 * q))));
}

// Returns a node's filtered window, in the form with three waves, and the window's derivative. The filter multiplies
// the wave q = -1/2, 0 or 1/2 of Hann's window by exp(-2 pi^2 S q^2 - 4 pi^2 (S F) q), where S is its variance along
// the axis. If `even` and `odd` are the even and odd parts of this factor at q = 1/2, the window h becomes
// 1/2 + even (h - 1/2) + i odd h' / pi.
inline float4 gabor_impl_filtered_node(float value, float slope, float2 part, float2 phase) {
    float2 wave = float2(value - 0.5, slope);
    float2 even = part.x * wave, odd = part.y * float2(-3.1415927, 0.31830989) * wave;
    return float4(gabor_impl_product(float2(0.5 + even.x, odd.y), phase), gabor_impl_product(float2(even.y, odd.x), phase));
}

// Filters an axis with the given S and S F. Windows fade out within half a standard deviation of their ends; the middle
// window never fades.
inline void gabor_impl_filter(thread GaborAxis& axis, float variance, float blurred) {
    float rise = exp(19.739209 * blurred);
    float2 part = 0.5 * exp(-4.934802 * variance) * float2(rise + 1.0 / rise, rise - 1.0 / rise);
    float2 inside = 0.33333333 + 0.66666667 * float2(-axis.offset, axis.offset);
    float2 fade = clamp(inside / clamp(0.5 * sqrt(variance), 0.001, 0.05), 0.0, 1.0);
    fade *= fade * (3.0 - 2.0 * fade);
    float2 turn = gabor_impl_wave(axis.turns);
    float4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    axis.node[0] = gabor_impl_filtered_node(value.x, slope.x, part, fade.x * turn);
    axis.node[1] = gabor_impl_filtered_node(value.y, slope.y, part, float2(1.0, 0.0));
    axis.node[2] = gabor_impl_filtered_node(value.z, slope.z, part, fade.y * float2(turn.x, -turn.y));
}

// The filtered noise at `place`, with three waves along each axis.
inline GaborField gabor_impl_filtered_narrow(GaborPlace place, float2 wave, float3 s, uint salt) {
    float2 blurred = gabor_impl_symmetric(s, wave);
    GaborAxis columns = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, GABOR_RADIUS);
    GaborAxis rows = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                     GABOR_RADIUS);
    float2 turn = gabor_impl_wave(columns.offset * columns.turns + rows.offset * rows.turns);
    gabor_impl_filter(columns, s.x, blurred.x);
    gabor_impl_filter(rows, s.y, blurred.y);
    float4 sum, slope;
    gabor_impl_sum(columns, rows, place.animated, place.moment, sum, slope);
    sum += float4(s.z * slope.zw, 0.0, 0.0);
    return gabor_impl_field(sum, slope, exp(-19.739209 * dot(wave, blurred)) * turn, wave, float2(1.0));
}

// For the form with seven waves: a complex number for each factor of an axis, 1, q - c and (q - c)^2 - 1 / 4g.
struct GaborFactors {
    float3 real;
    float3 imaginary;
};

// The nodes along an axis and their filtered windows. At a distance of d kernel radii, the window for each factor is
//     even_0 + C (even_1 + C (even_2 + C even_3)) + i S (odd_1 + C (odd_2 + C odd_3)),
// where C and S are the cosine and sine of 2 pi d / 2w.
struct GaborFilteredAxis {
    float3 even_0;
    float3 even_1;
    float3 even_2;
    float3 even_3;
    float3 odd_1;
    float3 odd_2;
    float3 odd_3;
    float reach;  // w, in node spacings
    float offset; // offset of the point from the first node, in node spacings
    int count;    // number of nodes, 4 or 5
    int first;    // index of the first node
    int period;
    uint salt;
    float2 turn_back; // turn of the wave q = 1 / 2w from one node to the next
    float2 back;      // the same for the noise's wave
};

// Builds the windows, without their common factor e^(-g c^2), for a filter with a given standard deviation along the
// axis. `m` is r M in the plane and D in space.
inline GaborFilteredAxis gabor_impl_filtered_axis(float deviation, float m, float c, int cell, float local, int period, uint salt, float2 step) {
    GaborFilteredAxis b;
    b.reach = clamp(0.35 + 5.0 * deviation, 2.0, 2.5);
    b.count = b.reach > 2.0 ? 5 : 4;
    float zero = floor(local + (b.count == 5 ? 0.5 : 1.0)) - 2.0;
    b.offset = b.count == 5 ? clamp(local - zero, 1.5, 2.5) : clamp(local - zero, 1.0, 2.0); // see gabor_impl_axis
    b.first = cell + int(zero);
    b.period = period;
    b.salt = salt;
    b.turn_back = gabor_impl_wave(-0.5 / b.reach);
    b.back = float2(step.x, -step.y);

    float g = 19.739209 * m, unit = 0.75 / b.reach;
    float fall = exp((2.5797363 - g) * unit * unit); // e^(-2 pi^2 (m - v) q^2)
    float rise = exp(2.0 * g * c * unit), sink = 1.0 / rise;
    // H(q) / 2w, within 0.00024, at q = 1, 2 and 3 times 1 / 2w. The values are multiplied by 1, 2 and 4, the leading
    // coefficients of the waves' cosines C, 2 C^2 - 1 and 4 C^3 - 3 C and of their sines S, 2 S C and S (4 C^2 - 1).
    float t = b.reach - 2.0;
    float3 wave = float3(0.25723323, 0.12732396, -0.03693604)
              + t * (float3(-0.03099653, 0.22852218, 0.10636504) - t * float3(0.0214304, 0.11618766, -0.1615392));
    float fall_4 = fall * fall * (fall * fall);
    wave *= float3(fall, fall_4, fall_4 * fall_4 * fall);
    float3 above = wave * float3(rise, rise * rise, rise * rise * rise);
    float3 below = wave * float3(sink, sink * sink, sink * sink * sink);
    float3 even = above + below, odd = above - below;
    float3 q = unit * float3(1.0, 2.0, 3.0);
    float quarter = 0.25 / g;
    float3 even_1 = q * odd - c * even, odd_1 = q * even - c * odd; // for the factor q - c
    float3 even_2 = q * odd_1 - c * even_1 - quarter * even, odd_2 = q * even_1 - c * odd_1 - quarter * odd;
    b.even_2 = float3(even.y, even_1.y, even_2.y);
    b.even_3 = float3(even.z, even_1.z, even_2.z);
    b.odd_2 = float3(odd.y, odd_1.y, odd_2.y);
    b.odd_3 = float3(odd.z, odd_1.z, odd_2.z);
    b.even_0 = unit * float3(1.0, -c, c * c - quarter) - 0.5 * b.even_2;
    b.even_1 = float3(even.x, even_1.x, even_2.x) - 0.75 * b.even_3;
    b.odd_1 = float3(odd.x, odd_1.x, odd_2.x) - 0.25 * b.odd_3;
    return b;
}

// A column or a row of nodes: its word, and for each factor its window times the noise's wave.
struct GaborFilteredLine {
    uint word;
    GaborFactors window;
    float2 turn;  // e^(2 pi i d / 2w)
    float2 phase; // the same for the noise's wave
};

// The factor by which the windows of line `index` fade, over the last quarter of a node spacing.
inline float gabor_impl_fade(GaborFilteredAxis b, int index) {
    float fade = clamp(4.0 * (b.reach - abs(b.offset - float(index))), 0.0, 1.0);
    return fade * fade * (3.0 - 2.0 * fade);
}

// Computes line `index` from its turn and phase.
inline GaborFilteredLine gabor_impl_filtered_line(GaborFilteredAxis b, int index, float2 turn, float2 phase, float fade) {
    GaborFilteredLine line_;
    line_.word = gabor_impl_line_word(gabor_impl_wrap(b.first + index, b.period), b.salt);
    line_.turn = turn;
    line_.phase = phase;
    float3 real = b.even_0 + turn.x * (b.even_1 + turn.x * (b.even_2 + turn.x * b.even_3));
    float3 imaginary = turn.y * (b.odd_1 + turn.x * (b.odd_2 + turn.x * b.odd_3));
    phase *= fade;
    line_.window = GaborFactors{phase.x * real - phase.y * imaginary, phase.x * imaginary + phase.y * real};
    return line_;
}

// Computes line `index` from the previous one.
inline GaborFilteredLine gabor_impl_next_line(GaborFilteredLine line_, GaborFilteredAxis b, int index, float fade) {
    return gabor_impl_filtered_line(b, index, gabor_impl_product(line_.turn, b.turn_back),
                                    gabor_impl_product(line_.phase, b.back), fade);
}

// The four or five columns of nodes that reach a point.
struct GaborColumns {
    GaborFilteredLine column_0;
    GaborFilteredLine column_1;
    GaborFilteredLine column_2;
    GaborFilteredLine column_3;
    GaborFilteredLine column_4;
    bool five;
};

inline GaborColumns gabor_impl_columns(GaborFilteredAxis b) {
    GaborColumns columns;
    float2 turn = gabor_impl_wave(0.5 / b.reach * b.offset);
    columns.five = b.count == 5;
    columns.column_0 = gabor_impl_filtered_line(b, 0, turn, float2(1.0, 0.0), gabor_impl_fade(b, 0));
    columns.column_1 = gabor_impl_next_line(columns.column_0, b, 1, 1.0);
    columns.column_2 = gabor_impl_next_line(columns.column_1, b, 2, 1.0);
    columns.column_3 = gabor_impl_next_line(columns.column_2, b, 3, gabor_impl_fade(b, 3));
    columns.column_4 = columns.column_3;
    if (columns.five) columns.column_4 = gabor_impl_next_line(columns.column_3, b, 4, gabor_impl_fade(b, 4));
    return columns;
}

// The line before line 0, given the phase of the noise's wave there.
inline GaborFilteredLine gabor_impl_line_before(GaborFilteredAxis b, float2 phase) {
    GaborFilteredLine line_;
    line_.turn = gabor_impl_wave(0.5 / b.reach * (b.offset + 1.0));
    line_.phase = phase;
    return line_;
}

// Returns the sum plus a complex number times the factors.
inline GaborFactors gabor_impl_plus_product(GaborFactors sum, GaborFactors factors, float real, float imaginary) {
    return GaborFactors{sum.real + (real * factors.real - imaginary * factors.imaginary),
                        sum.imaginary + (real * factors.imaginary + imaginary * factors.real)};
}

// Adds a node to the sums of a row.
inline void gabor_impl_add_filtered_node(thread GaborFactors& row, GaborFilteredLine column, uint row_word, bool animated,
                                  float moment) {
    float2 a = gabor_impl_amplitude_at(column.word * row_word, animated, moment);
    row = gabor_impl_plus_product(row, column.window, a.x, a.y);
}

// The sums of a row over its columns.
inline GaborFactors gabor_impl_filtered_row(GaborColumns columns, uint row_word, bool animated, float moment) {
    GaborFactors row = GaborFactors{float3(0.0), float3(0.0)};
    gabor_impl_add_filtered_node(row, columns.column_0, row_word, animated, moment);
    gabor_impl_add_filtered_node(row, columns.column_1, row_word, animated, moment);
    gabor_impl_add_filtered_node(row, columns.column_2, row_word, animated, moment);
    gabor_impl_add_filtered_node(row, columns.column_3, row_word, animated, moment);
    if (columns.five) gabor_impl_add_filtered_node(row, columns.column_4, row_word, animated, moment);
    return row;
}

// Drops the first factor and moves the others up by one.
inline GaborFactors gabor_impl_next(GaborFactors f) {
    return GaborFactors{float3(f.real.yz, 0.0), float3(f.imaginary.yz, 0.0)};
}

// The weighted sum of the products of two axes' factors.
inline float2 gabor_impl_contracted(GaborFactors a, GaborFactors b, float3 weights) {
    return float2(dot(weights, a.real * b.real - a.imaginary * b.imaginary),
                dot(weights, a.real * b.imaginary + a.imaginary * b.real));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
inline GaborField gabor_impl_filtered_wide(GaborPlace place, float2 wave, float3 s, bool wanted, uint salt) {
    float2 m = s.xy + 0.13069097; // v
    float2 deviation = sqrt(s.xy);
    float2 blurred = gabor_impl_symmetric(s, wave);
    float2 c = gabor_impl_symmetric(float3(m.yx, -s.z), blurred) / (s.z * s.z - m.x * m.y);
    float rho = s.z * rsqrt(m.x * m.y);
    float r = sqrt(1.0 - rho * rho);
    float lambda = rho / (1.0 + r);
    float mixed = 39.478418 * s.z * r / (1.0 + r); // 2 lambda sqrt(g_x g_y)
    float3 weights = float3(1.0, -2.0 * mixed, 2.0 * mixed * mixed);
    float2 step_x = gabor_impl_wave(wave.x / GABOR_RADIUS);
    float2 step_y = gabor_impl_wave(wave.y / GABOR_RADIUS);
    GaborFilteredAxis across = gabor_impl_filtered_axis(deviation.x, r * m.x, c.x, place.cell.x, place.local.x, place.period.x, salt,
                                       step_x);
    GaborFilteredAxis along = gabor_impl_filtered_axis(deviation.y, r * m.y, c.y, place.cell.y, place.local.y, place.period.y,
                                      salt ^ GABOR_IMPL_ROWS, step_y);
    GaborColumns columns = gabor_impl_columns(across);
    GaborFilteredLine line_ = gabor_impl_line_before(
        along, gabor_impl_wave(dot(wave, float2(across.offset, along.offset + 1.0)) / GABOR_RADIUS));
    int rows = wanted ? along.count : 0; // saves time where a driver runs both sides of a branch
    float2 value = float2(0.0), next_x = float2(0.0), next_y = float2(0.0);
    int j = 0; // a do-while loop, because some drivers run a while loop's body once more after its test fails
    do {
        line_ = gabor_impl_next_line(line_, along, j, gabor_impl_fade(along, j));
        GaborFactors row = gabor_impl_filtered_row(columns, line_.word, place.animated, place.moment);
        value += gabor_impl_contracted(row, line_.window, weights);
        next_x += gabor_impl_contracted(gabor_impl_next(row), line_.window, weights);
        next_y += gabor_impl_contracted(row, gabor_impl_next(line_.window), weights);
    } while (++j < rows);
    float exponent = 19.739209 * (dot(wave + c, blurred) + r * dot(m, c * c));
    // The derivative of a wave is 2 pi i (F + q) times the wave. For the factors f_0, f_1, f_2 of an axis,
    // (q - c) f_n = f_(n + 1) + n / 4g f_(n - 1); f_3 is left out.
    float2 mean = wave + c, before = lambda * sqrt(m.yx / m);
    float2 x = 6.2831853 * (mean.x * value + next_x - before.x * next_y);
    float2 y = 6.2831853 * (mean.y * value + next_y - before.y * next_x);
    float scale = sqrt(1.0 - lambda * lambda) * exp(-exponent) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return GaborField{scale * value, scale * float2(-x.y, x.x), scale * float2(-y.y, y.x)};
}

// The share of the form with seven waves in the filtered noise; the rest is the form with three.
inline float gabor_impl_wide_share(GaborFootprint footprint) {
    return clamp(100.0 * sqrt(max(footprint.resolved.x, footprint.resolved.y)) - 9.0, 0.0, 1.0);
}

inline GaborField gabor_impl_filtered(GaborPlace place, GaborKernel kernel_, GaborFootprint footprint, float wide, uint seed,
                               thread float& removed) {
    float2 stretch = place.radius / GABOR_RADIUS;
    float2 wave = kernel_.wave / stretch;
    float transmitted = gabor_impl_transmitted(wave, footprint.covariance);
    removed = 1.0 - transmitted;
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0)};
    if (transmitted < 1.0e-10)
        return sum;
    float3 s = footprint.resolved;
    uint salt = gabor_impl_salt(seed);
    float amplitude = 1.0;
    if (distance(footprint.resolved, footprint.covariance) > 0.0)
        amplitude *= sqrt(transmitted / gabor_impl_transmitted(wave, s));
    if (wide < 1.0)
        gabor_impl_add_field(sum, gabor_impl_filtered_narrow(place, wave, s, salt), (1.0 - wide) * amplitude);
    if (wide > 0.0)
        gabor_impl_add_field(sum, gabor_impl_filtered_wide(place, wave, s, wide > 0.0, salt), wide * amplitude);
    sum.slope_x *= stretch.x;
    sum.slope_y *= stretch.y;
    return sum;
}

inline GaborField gabor_field_filtered(GaborPlace place, GaborKernel kernel_, GaborFootprint footprint, uint seed,
                                thread float& removed) {
    return gabor_impl_filtered(place, kernel_, footprint, gabor_impl_wide_share(footprint), seed, removed);
}

// ---- The filter in space -------------------------------------------------------------------------------------------
//
// For gabor_noise_3d.metal. With M = S + v, a diagonal matrix D with D_ii^2 = M_ii / (M^-1)_ii, C = D^(-1/2) M
// D^(-1/2), B = (1 - C) (1 + C)^-1 and z = 2 pi D^(1/2) (q - c), the coupling of three axes is again a sum of products:
//     exp(-z.C z / 2) = sqrt(8 / |1 + C|) exp(-z.z / 2) (1 + 2 (B_yz z_y z_z + B_zx z_z z_x + B_xy z_x z_y) + ...).
// The right side is the series of exp(z.B z) with Hermite polynomials instead of powers of z, and without B's diagonal,
// which is at most 0.01. We use the terms up to the square of each factor.

// A symmetric 3 x 3 matrix.
struct GaborMatrix {
    float3 diagonal;
    float3 mixed; // yz, zx, xy
};

inline float3 gabor_impl_symmetric_3d(GaborMatrix m, float3 v) {
    return m.diagonal * v + m.mixed.zxy * v.yzx + m.mixed.yzx * v.zxy;
}

// The inverse times the determinant.
inline GaborMatrix gabor_impl_adjugate(GaborMatrix m, thread float& determinant) {
    GaborMatrix a = GaborMatrix{m.diagonal.yzx * m.diagonal.zxy - m.mixed * m.mixed,
                                m.mixed.yzx * m.mixed.zxy - m.diagonal * m.mixed};
    determinant = m.diagonal.x * a.diagonal.x + m.mixed.y * a.mixed.y + m.mixed.z * a.mixed.z;
    return a;
}

#define GABOR_IMPL_SLICES 0x27d4eb2fu // like GABOR_IMPL_ROWS, for slices
// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
inline uint gabor_impl_slice_word(uint row, uint slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
inline float3 gabor_impl_along_z(float3 y_0, float3 y_1, float3 y_2, float3 w) {
    return float3(y_0.x + w.z * (y_1.y + 0.5 * w.z * y_2.z),
                w.y * (y_0.y + w.z * y_1.z) + w.x * (y_1.x + w.z * y_2.y),
                0.5 * (w.y * w.y * y_0.z + w.x * w.x * y_2.x) + w.x * w.y * (y_1.y + w.z * y_2.z));
}

// The weighted sum of the products of three axes' factors.
inline float2 gabor_impl_contracted_3d(GaborFactors y_0, GaborFactors y_1, GaborFactors y_2, GaborFactors z, float3 w) {
    GaborFactors slice = GaborFactors{gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w),
                                      gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w)};
    return gabor_impl_contracted(slice, z, float3(1.0));
}

// Computes the filtered noise in space and its derivatives at `local`, in node spacings from a cell's corner, with
// seven waves along each axis. If not `wanted`, computes only one row.
inline void gabor_impl_filtered_space(int3 cell, float3 local, int3 period, bool animated, float moment, float3 wave,
                               GaborMatrix s, bool wanted, uint salt, thread float4& noise, thread float4& quadrature) {
    float determinant;
    GaborMatrix m = GaborMatrix{s.diagonal + 0.13069097, s.mixed}; // S + v
    GaborMatrix adjugate = gabor_impl_adjugate(m, determinant);
    float3 blurred = gabor_impl_symmetric_3d(s, wave);
    float3 c = gabor_impl_symmetric_3d(adjugate, blurred) / -determinant;
    float3 d = sqrt(m.diagonal * determinant / adjugate.diagonal);
    float3 pairs = sqrt(d.yzx * d.zxy);
    adjugate = gabor_impl_adjugate(GaborMatrix{1.0 + m.diagonal / d, s.mixed / pairs}, determinant); // of 1 + C
    float3 w = 157.91367 / determinant * pairs * adjugate.mixed; // 8 pi^2 sqrt(D_yy D_zz) B_yz and so on
    GaborFilteredAxis x = gabor_impl_filtered_axis(sqrt(s.diagonal.x), d.x, c.x, cell.x, local.x, period.x, salt,
                                  gabor_impl_wave(wave.x / GABOR_RADIUS));
    GaborFilteredAxis y = gabor_impl_filtered_axis(sqrt(s.diagonal.y), d.y, c.y, cell.y, local.y, period.y,
                                  salt ^ GABOR_IMPL_ROWS, gabor_impl_wave(wave.y / GABOR_RADIUS));
    GaborFilteredAxis z = gabor_impl_filtered_axis(sqrt(s.diagonal.z), d.z, c.z, cell.z, local.z, period.z,
                                  salt ^ GABOR_IMPL_SLICES, gabor_impl_wave(wave.z / GABOR_RADIUS));
    GaborColumns columns = gabor_impl_columns(x);
    GaborFilteredLine first = gabor_impl_line_before(y, float2(y.back.x, -y.back.y));
    GaborFilteredLine slice = gabor_impl_line_before(
        z, gabor_impl_wave(dot(wave, float3(x.offset, y.offset, z.offset + 1.0)) / GABOR_RADIUS));
    GaborFactors none = GaborFactors{float3(0.0), float3(0.0)};
    int rows = wanted ? y.count : 0, slices = wanted ? z.count : 0; // see gabor_impl_filtered_wide
    float2 value = float2(0.0), next_x = float2(0.0), next_y = float2(0.0), next_z = float2(0.0);
    int k = 0;
    do {
        slice = gabor_impl_next_line(slice, z, k, gabor_impl_fade(z, k));
        GaborFactors y_0 = none, y_1 = none, y_2 = none;
        GaborFilteredLine row = first;
        int j = 0;
        do {
            row = gabor_impl_next_line(row, y, j, gabor_impl_fade(y, j));
            GaborFactors sum = gabor_impl_filtered_row(columns, gabor_impl_slice_word(row.word, slice.word), animated,
                                                       moment);
            y_0 = gabor_impl_plus_product(y_0, sum, row.window.real.x, row.window.imaginary.x);
            y_1 = gabor_impl_plus_product(y_1, sum, row.window.real.y, row.window.imaginary.y);
            y_2 = gabor_impl_plus_product(y_2, sum, row.window.real.z, row.window.imaginary.z);
        } while (++j < rows);
        value += gabor_impl_contracted_3d(y_0, y_1, y_2, slice.window, w);
        next_x += gabor_impl_contracted_3d(gabor_impl_next(y_0), gabor_impl_next(y_1), gabor_impl_next(y_2),
                                           slice.window, w);
        next_y += gabor_impl_contracted_3d(y_1, y_2, none, slice.window, w);
        next_z += gabor_impl_contracted_3d(y_0, y_1, y_2, gabor_impl_next(slice.window), w);
    } while (++k < slices);
    // The derivatives follow as in the plane. In the sum over the series, n / 4g times the previous factor becomes
    // w / 4g times the next factor of the other axes.
    float3 real = float3(next_x.x, next_y.x, next_z.x), imaginary = float3(next_x.y, next_y.y, next_z.y);
    float3 quarter = 0.012665148 / d; // 1 / 4g, g = 2 pi^2 D
    real += (wave + c) * value.x + quarter * gabor_impl_symmetric_3d(GaborMatrix{float3(0.0), w}, real);
    imaginary += (wave + c) * value.y + quarter * gabor_impl_symmetric_3d(GaborMatrix{float3(0.0), w}, imaginary);
    float exponent = 19.739209 * (dot(wave + c, blurred) + dot(d, c * c));
    float scale = sqrt(8.0 / determinant / GABOR_IMPL_ENERGY) * exp(-exponent);
    scale /= GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY;
    noise = scale * float4(value.y, 6.2831853 * real);
    quadrature = scale * float4(value.x, -6.2831853 * imaginary);
}
#endif

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three unit vectors u_cm, 60 degrees apart and turned at random, each with its own amplitude:
//     n(p) = K / sqrt(3) Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with variance 1. Its gradient is normal with the constant covariance
// K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 2 pi^2 F^2 h^2 I), because sum_m u_cm u_cm^T = 3/2 I, with I the identity.
// Value and gradient are independent. Since none of this depends on the directions, both are also normal over random
// directions.

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
inline uint4 gabor_impl_row(uint word) {
    uint first = (word ^ (word >> 15u)) * 0xd35a2d97u;
    uint second = (first ^ (first >> 15u)) * 0xd35a2d97u;
    uint third = (second ^ (second >> 15u)) * 0xd35a2d97u;
    uint fourth = (third ^ (third >> 15u)) * 0xd35a2d97u;
    return uint4((first >> 8u) | 0x800001u, (second >> 8u) | 0x800001u, (third >> 8u) | 0x800001u,
                 (fourth >> 8u) | 0x800001u);
}

// The windows of a node along both axes, and their derivatives. Filtered windows are middle + cosine, and their
// derivatives `sine`.
struct GaborWindows {
    float2 value;
    float2 slope;
    float2 middle;
    float2 cosine;
    float2 sine;
};

// The covariance of a filter, and the factors by which it damps the cosines of the windows.
struct GaborFilter {
    bool used;
    float3 covariance;
    float2 fall;
};

// Adds a node's wave. `a` is its amplitude times the wave at the point. The filter multiplies it by exp(-2 pi^2 F.S F)
// and shifts its window along each axis by i x / pi, x = 2 pi^2 S F: see gabor_impl_filtered_node.
inline void gabor_impl_add_node_wave(thread GaborField& sum, GaborWindows node, GaborFilter pixel, float2 a, float2 wave) {
    float2 value = node.value.x * node.value.y * a;
    float2 slope_x = node.slope.x * node.value.y * a, slope_y = node.value.x * node.slope.y * a;
#if GABOR_TAPS == 3
    if (pixel.used) {
        float2 x = 19.739209 * gabor_impl_symmetric(pixel.covariance, wave);
        a *= exp(-max(dot(wave, x), 0.0));
        x = clamp(x, -3.0, 3.0); // changes no wave that the filter keeps
        float2 y = x * x;
        float2 even = 1.0 + y * (0.5 + 0.041666667 * y), odd = x * (1.0 + y * (0.16666667 + 0.0083333333 * y));
        float2 real = node.middle + even * node.cosine, imaginary = 0.31830989 * odd * node.sine;
        float2 h_x = float2(real.x, imaginary.x), h_y = float2(real.y, imaginary.y);
        value = gabor_impl_product(gabor_impl_product(h_x, h_y)
                                   + float2(pixel.covariance.z * node.sine.x * node.sine.y, 0.0), a);
        real = even * node.sine;
        imaginary = -3.1415927 * odd * node.cosine;
        slope_x = gabor_impl_product(gabor_impl_product(float2(real.x, imaginary.x), h_y), a);
        slope_y = gabor_impl_product(gabor_impl_product(h_x, float2(real.y, imaginary.y)), a);
    }
#endif
    float2 turned = 6.2831853 * float2(-value.y, value.x);
    sum.value += value;
    sum.slope_x += slope_x + wave.x * turned;
    sum.slope_y += slope_y + wave.y * turned;
}

// Adds a node's three waves, at `d` node spacings from it. The third phase is the difference of the other two.
inline void gabor_impl_add_node_waves(thread GaborField& sum, GaborPlace place, GaborWindows node, GaborFilter pixel, float2 d,
                               float frequency, uint4 words) {
    if (pixel.used) { // windows fade out within half a standard deviation of their ends
        float2 fade = clamp((1.0 - abs(d) / GABOR_RADIUS) / clamp(0.5 * sqrt(pixel.covariance.xy), 0.001, 0.05), 0.0, 1.0);
        fade *= fade * (3.0 - 2.0 * fade);
        node.middle = 0.5 * fade;
        node.cosine = fade * pixel.fall * (node.value - 0.5);
        node.sine = fade * pixel.fall * node.slope;
    }
    d *= frequency / place.radius;
    float2 u = gabor_impl_half_turn(3.8805107e-11 * float(int(words.w))); // up to a twelfth of a turn either way
    float2 v = 0.5 * u + 0.8660254 * float2(-u.y, u.x);
    float2 first = gabor_impl_wave(dot(u, d)), second = gabor_impl_wave(dot(v, d));
    float2 third = gabor_impl_product(second, float2(first.x, -first.y));
    first = gabor_impl_product(gabor_impl_amplitude_at(words.x, place.animated, place.moment), first);
    second = gabor_impl_product(gabor_impl_amplitude_at(words.y, place.animated, place.moment), second);
    third = gabor_impl_product(gabor_impl_amplitude_at(words.z, place.animated, place.moment), third);
    gabor_impl_add_node_wave(sum, node, pixel, first, frequency * u);
    gabor_impl_add_node_wave(sum, node, pixel, second, frequency * v);
    gabor_impl_add_node_wave(sum, node, pixel, third, frequency * (v - u));
}

// The sum over all nodes, without the factor GABOR_IMPL_STAR. Unrolling the loops by hand made them four times slower
// on lavapipe.
inline GaborField gabor_impl_sum_isotropic_2d(GaborPlace place, float frequency, GaborFilter pixel, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, place.radius.x);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                                  place.radius.y);
    float2 stretch = place.radius / GABOR_RADIUS;
    frequency = min(abs(frequency), 1.0e6);
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0)};
    for (int j = 0; j < GABOR_TAPS; ++j) {
        uint4 row = gabor_impl_row(y.word[j]);
        for (int i = 0; i < GABOR_TAPS; ++i) {
            GaborWindows node;
            node.value = float2(x.node[i].x, y.node[j].x);
            node.slope = stretch * float2(x.node[i].z, y.node[j].z);
            float2 d = float2(x.offset - float(i - 1), y.offset - float(j - 1));
            gabor_impl_add_node_waves(sum, place, node, pixel, d, frequency, x.word[i] * row);
        }
    }
    return sum;
}

inline GaborField gabor_impl_scaled_field(GaborField field, float scale) {
    return GaborField{scale * field.value, scale * field.slope_x, scale * field.slope_y};
}

#define GABOR_IMPL_STAR (0.57735027 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY))
inline GaborField gabor_field_isotropic(GaborPlace place, float frequency, uint seed) {
    GaborFilter none = GaborFilter{false, float3(0.0), float2(1.0)};
    return gabor_impl_scaled_field(gabor_impl_sum_isotropic_2d(place, frequency, none, seed), GABOR_IMPL_STAR);
}

#if GABOR_TAPS == 3
// The share of isotropic noise's variance that a filter keeps: the mean of gabor_impl_transmitted over all directions.
inline float gabor_impl_transmitted_isotropic_2d(float frequency, float3 covariance) {
    float area = 6.5797363 * (covariance.x * covariance.y - covariance.z * covariance.z);
    float d = 1.0 + 6.5797363 * (covariance.x + covariance.y + area);
    float unit = 39.478418 / d * min(frequency * frequency, 1.0e12);
    float apart = length(float2(covariance.x - covariance.y, 2.0 * covariance.z));
    float smaller = area + max(0.5 * (covariance.x + covariance.y - apart), 0.0);
    return exp(-clamp(unit * smaller, 0.0, 80.0)) * gabor_impl_mean_angle(min(unit * apart, 1.0e8)) * rsqrt(d);
}

inline GaborField gabor_field_isotropic_filtered(GaborPlace place, float frequency, GaborFootprint footprint, uint seed,
                                          thread float& removed) {
    float kept = gabor_impl_transmitted_isotropic_2d(frequency, footprint.covariance);
    removed = 1.0 - kept;
    if (!(kept > 1.0e-10)) {
        removed = 1.0;
        return GaborField{float2(0.0), float2(0.0), float2(0.0)};
    }
    float3 s = footprint.covariance;
    // The windows allow a standard deviation of at most 0.2.
    s *= 0.04 / max(0.5 * (s.x + s.y + length(float2(s.x - s.y, 2.0 * s.z))), 0.04);
    GaborFilter pixel = GaborFilter{true, s, exp(-4.934802 * s.xy)};
    return gabor_impl_scaled_field(gabor_impl_sum_isotropic_2d(place, frequency, pixel, seed),
                                   GABOR_IMPL_STAR * sqrt(kept / gabor_impl_transmitted_isotropic_2d(frequency, s)));
}
#endif

// ---- Definitions of the public functions ---------------------------------------------------------------------------

inline GaborLobe gabor_lobe(float frequency, float orientation, float radius, float power) {
    return GaborLobe{frequency, orientation, float2(radius), power};
}

inline GaborLobe gabor_lobe_elliptical(float frequency, float orientation, float2 radius, float power) {
    return GaborLobe{frequency, orientation, radius, power};
}

inline float gabor_noise_lobes(float2 p, GaborLobes lobes, uint seed) {
    return gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed).value.y;
}

inline float3 gabor_noise_lobes_gradient(float2 p, GaborLobes lobes, uint seed) {
    GaborField field = gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

inline float2 gabor_noise_lobes_complex(float2 p, GaborLobes lobes, uint seed) {
    return gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed).value;
}

inline float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         uint seed) {
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value.y;
}

inline float3 gabor_noise_spread_gradient(float2 p, float frequency, float orientation, float frequency_spread,
                                 float orientation_spread, uint seed) {
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    GaborField field = gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

inline float2 gabor_noise_spread_complex(float2 p, float frequency, float orientation, float frequency_spread,
                                float orientation_spread, uint seed) {
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value;
}

inline float gabor_noise_isotropic(float2 p, float frequency, uint seed) {
    return gabor_field_isotropic(gabor_place(int2(0), p * GABOR_RADIUS), frequency, seed).value.y;
}

inline float3 gabor_noise_isotropic_gradient(float2 p, float frequency, uint seed) {
    GaborField field = gabor_field_isotropic(gabor_place(int2(0), p * GABOR_RADIUS), frequency, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

inline float gabor_noise_isotropic_tiled(float2 p, float2 period, float frequency, uint seed) {
    GaborPlace place = gabor_place_tiled(p, clamp(period, 0.0009765625, 1.0e9));
    return gabor_field_isotropic(place, frequency, seed).value.y;
}

#if GABOR_TAPS == 3
inline GaborFootprint gabor_footprint(float2 dx, float2 dy) {
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: no wave is left
        dx = float2(1.0e5, 0.0);
        dy = float2(0.0, 1.0e5);
    }
    GaborFootprint footprint;
    footprint.covariance = 0.25 * float3(dx * dx + dy * dy, dx.x * dx.y + dy.x * dy.y);

    // The eigenvalues are mean +- apart. Dividing the determinant by the larger gives the smaller more precisely.
    float mean = 0.5 * (footprint.covariance.x + footprint.covariance.y);
    float2 axis = float2(0.5 * (footprint.covariance.x - footprint.covariance.y), footprint.covariance.z);
    float apart = length(axis);
    float larger = mean + apart;
    footprint.resolved = footprint.covariance;
    if (larger > 0.25) {
        float side = 0.25 * (dx.x * dy.y - dx.y * dy.x);
        float smaller = min(side / larger * side, 0.25);
        axis *= apart > 0.0 ? 0.5 * (0.25 - smaller) / apart : 0.0;
        footprint.resolved = float3(max(0.5 * (0.25 + smaller) + float2(axis.x, -axis.x), 0.0), axis.y);
    }
    return footprint;
}

inline float4 gabor_noise_filtered_gradient(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed) {
    float removed;
    GaborField field = gabor_field_filtered(gabor_place(int2(0), p * GABOR_RADIUS),
                                            gabor_kernel(frequency, orientation), gabor_footprint(dx, dy), seed,
                                            removed);
    return float4(field.value.y, field.slope_x.y, field.slope_y.y, removed);
}

inline float2 gabor_noise_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed) {
    float4 field = gabor_noise_filtered_gradient(p, dx, dy, frequency, orientation, seed);
    return float2(field.x, field.w);
}

inline float2 gabor_noise_isotropic_filtered(float2 p, float2 dx, float2 dy, float frequency, uint seed) {
    float removed;
    GaborField field = gabor_field_isotropic_filtered(gabor_place(int2(0), p * GABOR_RADIUS), frequency, gabor_footprint(dx, dy),
                                                      seed, removed);
    return float2(field.value.y, removed);
}

inline float4 gabor_noise_four_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed,
                               thread float& removed) {
    float4 four;
    for (int i = 0; i < 4; ++i) {
        float4 noise = gabor_noise_filtered_gradient(p, dx, dy, frequency, orientation,
                                                   i == 0 ? seed : gabor_lobe_seed(seed, -i));
        four[i] = noise.x;
        removed = noise.w;
    }
    return four;
}

inline float4 gabor_noise_lobes_filtered_gradient(float2 p, float2 dx, float2 dy, GaborLobes lobes, uint seed) {
    float4 sum = float4(0.0);
    float power = 0.0;
    for (int i = 0; i < min(lobes.count, GABOR_LOBES); ++i) {
        GaborLobe lobe = lobes.lobe[i];
        float2 unit = 1.0 / lobe.radius;
        float removed;
        GaborField field = gabor_field_filtered(gabor_place(int2(0), p * unit * GABOR_RADIUS),
                                                gabor_impl_lobe_kernel(lobe), gabor_footprint(dx * unit, dy * unit),
                                                gabor_lobe_seed(seed, i), removed);
        float3 noise = float3(field.value.y, unit.x * field.slope_x.y, unit.y * field.slope_y.y);
        sum += float4(sqrt(lobe.power) * noise, lobe.power * removed);
        power += lobe.power;
    }
    return power > 0.0 ? sum * float4(float3(rsqrt(power)), 1.0 / power) : float4(0.0);
}

inline float2 gabor_noise_lobes_filtered(float2 p, float2 dx, float2 dy, GaborLobes lobes, uint seed) {
    float4 field = gabor_noise_lobes_filtered_gradient(p, dx, dy, lobes, seed);
    return float2(field.x, field.w);
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
inline float4 gabor_stripes_filtered_at(GaborPlace place, float2 wave, GaborFootprint footprint, float sharpness, uint seed) {
    float removed;
    float2 value = gabor_field_filtered(place, gabor_kernel_wave(wave), footprint, seed, removed).value;
    float power = dot(value, value);
    float reach = sqrt(power + 2.5464791 * max(removed, 0.0));
    return float4(sharpness / max(sharpness * reach, 1.0) * value, sqrt(power + 1.5707963 * max(removed, 0.0)), removed);
}

inline float4 gabor_stripes_filtered(float2 p, float2 dx, float2 dy, float2 wave, float sharpness, uint seed) {
    return gabor_stripes_filtered_at(gabor_place(int2(0), p * GABOR_RADIUS), wave, gabor_footprint(dx, dy), sharpness,
                                     seed);
}
#endif // GABOR_TAPS == 3

// The mean of a profile over [phase - width / 2, phase + width / 2] is the change of its integral from one end to
// the other, divided by the width. Each whole turn adds the integral of one period.
inline float3 gabor_impl_ends(float phase, float width) {
    width = clamp(width, 0.001, 1.0);
    phase -= floor(phase);
    return float3(phase - 0.5 * width, phase + 0.5 * width, 1.0 / width);
}

inline float gabor_profile_sine(float phase, float width) {
    float x = 3.1415927 * clamp(width, 0.001, 1.0);
    return 0.5 - 0.5 * gabor_impl_wave(phase).x * (gabor_impl_wave(0.15915494 * x).y / x);
}

inline float gabor_impl_triangle_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.5 * turns + (t < 0.5 ? t * t : 2.0 * t - t * t - 0.5);
}

inline float gabor_profile_triangle(float phase, float width) {
    float3 ends = gabor_impl_ends(phase, width);
    return ends.z * (gabor_impl_triangle_integral(ends.y) - gabor_impl_triangle_integral(ends.x));
}

inline float gabor_impl_sawtooth_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.5 * (turns + t * t);
}

inline float gabor_profile_sawtooth(float phase, float width) {
    float3 ends = gabor_impl_ends(phase, width);
    return ends.z * (gabor_impl_sawtooth_integral(ends.y) - gabor_impl_sawtooth_integral(ends.x));
}

inline float gabor_impl_pulse_integral(float x, float duty) {
    float turns = floor(x);
    return duty * turns + min(x - turns, duty);
}

inline float gabor_profile_pulse(float phase, float duty, float width) {
    float3 ends = gabor_impl_ends(phase, width);
    return ends.z * (gabor_impl_pulse_integral(ends.y, duty) - gabor_impl_pulse_integral(ends.x, duty));
}

inline float gabor_impl_ridges_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.66666667 * turns + t * t * (2.0 - 1.3333333 * t);
}

inline float gabor_profile_ridges(float phase, float width) {
    float3 ends = gabor_impl_ends(phase, width);
    return ends.z * (gabor_impl_ridges_integral(ends.y) - gabor_impl_ridges_integral(ends.x));
}

// The (phase, width) of stripes. The mean of a unit vector over `width` turns has the length sin(pi width) / (pi
// width); the polynomial inverts this within 0.0025.
inline float2 gabor_impl_phase_of(float2 stripes) {
    float2 phasor = gabor_phasor(stripes);
    float y = max(1.0 - phasor.y, 0.0);
    return float2(phasor.x, sqrt(y) * (0.7796968 + y * (0.13925488 + y * (0.1322011 * y - 0.05362376))));
}

inline float gabor_stripes_sine(float2 stripes) {
    return 0.5 - 0.5 * stripes.x;
}

inline float gabor_stripes_triangle(float2 stripes) {
    float2 phase = gabor_impl_phase_of(stripes);
    return gabor_profile_triangle(phase.x, phase.y);
}

inline float gabor_stripes_sawtooth(float2 stripes) {
    float2 phase = gabor_impl_phase_of(stripes);
    return gabor_profile_sawtooth(phase.x, phase.y);
}

inline float gabor_stripes_pulse(float2 stripes, float duty) {
    float2 phase = gabor_impl_phase_of(stripes);
    return gabor_profile_pulse(phase.x, duty, phase.y);
}

inline float gabor_stripes_ridges(float2 stripes) {
    float2 phase = gabor_impl_phase_of(stripes);
    return gabor_profile_ridges(phase.x, phase.y);
}

#endif // GABOR_SPECTRUM_METAL
