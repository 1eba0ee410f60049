// gabor_spectrum.metal: Gabor noise of any power spectrum, and without aliasing. Include it after gabor_lattice.metal: for the Metal shading language.
//
// Made from shaders/gabor_spectrum.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.metal.
//
// Functions to call, at the end of the file:
//     gabor_noise_lobes, gabor_noise_lobes_gradient, gabor_noise_lobes_complex     a sum of lobes
//     gabor_noise_spread, gabor_noise_spread_gradient, gabor_noise_spread_complex  a range of waves, up to isotropic
//     gabor_noise_filtered, gabor_noise_lobes_filtered                             as a pixel sees it
//     gabor_lobe, gabor_footprint, gabor_field_filtered                            their parts
//
// The unit of length is the kernel radius, as in gabor_lattice.metal, and every function's variance is exactly 1.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_METAL
#error Include gabor_lattice.metal before gabor_spectrum.metal
#endif
#ifndef GABOR_SPECTRUM_METAL
#define GABOR_SPECTRUM_METAL

#include <metal_stdlib>

using namespace metal;

// The most lobes that a GaborLobes holds: an int, at least 1.
#ifndef GABOR_LOBES
#define GABOR_LOBES 4
#endif

// ---- Lobes ---------------------------------------------------------------------------------------------------------

// Waves around one wave vector: see gabor_lobe.
struct GaborLobe {
    float frequency;
    float orientation;
    float radius;
    float power;
};

// A power spectrum: the first `count` lobes.
struct GaborLobes {
    GaborLobe lobe[GABOR_LOBES];
    int count;
};

inline void gabor_impl_accumulate(thread GaborField& sum, GaborField field, float amplitude, float slope)
{
    sum.value += amplitude * field.value;
    sum.slope_x += slope * field.slope_x;
    sum.slope_y += slope * field.slope_y;
    sum.four += amplitude * field.four;
}

// The same place, period and time for a kernel whose radius is `radius` times that of the place's. Its position is
// rounded to a float: within a period, or without one as p is.
inline GaborPlace gabor_place_scaled(GaborPlace place, float radius)
{
    int2 cell = int2(gabor_impl_wrap(place.cell.x, place.period.x), gabor_impl_wrap(place.cell.y, place.period.y));
    float2 unit = 1.0 / (place.radius * radius);
    GaborPlace scaled = gabor_place_tiled((float2(cell) + place.local) * unit, float2(place.period) * unit);
    scaled.animated = place.animated;
    scaled.time = place.time;
    return scaled;
}

// The noise of a sum of lobes at a place, with its quadrature and derivatives per kernel radius of the place.
inline GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, uint seed)
{
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0), float4(0.0)};
    float power = 0.0;
    for (int i = 0; i < lobes.count; ++i) {
        GaborLobe lobe = lobes.lobe[i];
        GaborPlace scaled = gabor_place_scaled(place, lobe.radius);
        GaborKernel kernel_ = gabor_kernel_stretched(gabor_kernel(lobe.frequency * lobe.radius, lobe.orientation),
                                                    scaled.radius);
        GaborField field = gabor_field(scaled, kernel_, gabor_lobe_seed(seed, i));
        gabor_impl_accumulate(sum, field, sqrt(lobe.power), sqrt(lobe.power) / lobe.radius);
        power += lobe.power;
    }
    float scale = power > 0.0 ? rsqrt(power) : 0.0;
    return GaborField{scale * sum.value, scale * sum.slope_x, scale * sum.slope_y, scale * sum.four};
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is a sum of lobes in the middle of equal pieces of it, at most 0.7 cycles wide: the power of Hann's
// window falls off with a standard deviation of 1/sqrt(12) cycles, so that the sum is even. There are as many pieces as
// the whole part of a number c says. While the rest of c goes from 0.8 to 1 they fade out and one more fade in: the
// noise is continuous in frequency and spread.

// Of `c`: how many lobes there are, of both numbers where one fades.
inline int gabor_impl_pieces(float c)
{
    return fract(c) > 0.8 ? 2 * int(c) + 1 : int(c);
}

// Of lobe `i`: its place in the range, from -1 to 1, its share of the power, and a number for its seed.
inline float3 gabor_impl_piece(int i, float c)
{
    int n = int(c);
    float share = min(5.0 - 5.0 * fract(c), 1.0);
    if (i >= n) {
        i -= n;
        n += 1;
        share = 1.0 - share;
    }
    float width = 1.0 / float(n);
    return float3((2.0 * float(i) + 1.0) * width - 1.0, share * width, float(i + (n & 1) * 64));
}

// The noise of a range of waves at a place, as gabor_noise_spread, with its quadrature and derivatives per kernel radius.
inline GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
                              float orientation_spread, uint seed)
{
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0), float4(0.0)};
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
            kernel_ = gabor_kernel_stretched(kernel_, place.radius);
            GaborField field = gabor_field(place, kernel_, gabor_lobe_seed(seed, int(128.0 * shell.z + direction.z)));
            float amplitude = sqrt(shell.y * direction.y);
            gabor_impl_accumulate(sum, field, amplitude, amplitude);
        }
    }
    return sum;
}

// ---- The filter ----------------------------------------------------------------------------------------------------
//
// A normal filter of covariance S multiplies a wave of k cycles by exp(-2 pi^2 k.S k). What it leaves of one node's
// kernel h(x) h(y) e^(2 pi i F.d) is, with H the transform of h, the integral over q of
//
//     H(q_x) H(q_y) exp(-2 pi^2 (F + q).S (F + q)) e^(2 pi i (F + q).d).
//
// Along one axis that is a sum over q = a / 2w, a = -3 ... 3, where the filtered window ends at +-w, which a taper sees
// to: for w = 1 it is h itself, which has three of these waves. The filter widens w from 1 to 5/3, so that 3, 4 or 5
// nodes along each axis take part; the filter is for GABOR_TAPS 3. The axes meet in the factor exp(-4 pi^2 S_xy q_x
// q_y). With H as wide as a normal curve, H = (H e^(2 pi^2 v q^2)) e^(-2 pi^2 v q^2), v = 1/3 - 2/pi^2 the variance of
// h, Mehler's formula (DLMF 18.18.28) separates it: with M = S + v, the center c = -M^-1 S F of the filtered lobe, rho
// = M_xy / sqrt(M_xx M_yy), r = sqrt(1 - rho^2), lambda = rho / (1 + r) and, for each axis, g = 2 pi^2 r M and z =
// sqrt(2 g) (q - c),
//
//     exp(-2 pi^2 (q - c).M (q - c)) = sqrt(1 - lambda^2) exp(-(z_x^2 + z_y^2) / 2)
//                                      (1 - 2 lambda z_x z_y + lambda^2 / 2 (2 z_x^2 - 1) (2 z_y^2 - 1) - ...),
//
// of which these three terms are used; |lambda| is at most 0.26.

#if GABOR_TAPS == 3
// What a pixel covers: see gabor_footprint.
struct GaborFootprint {
    float3 covariance; // xx, yy, xy in kernel radii^2
    float3 resolved;   // the same with standard deviations of at most 1/2, for which the windows are made
};

// A symmetric matrix (xx, yy, xy) times a vector.
inline float2 gabor_impl_symmetric(float3 matrix_, float2 v)
{
    return matrix_.xy * v + matrix_.z * v.yx;
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe's power taken as
// normal, of variance 1/12 along each axis, as Hann's window has it,
//     |1 + 2/3 pi^2 S|^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F).
inline float gabor_impl_transmitted(float2 wave, float3 covariance)
{
    float3 widened = float3(1.0, 1.0, 0.0) + 6.5797363 * covariance;
    float determinant = widened.x * widened.y - widened.z * widened.z;
    float2 through = gabor_impl_symmetric(float3(widened.y, widened.x, -widened.z), wave) / determinant;
    float exponent = 39.478418 * dot(wave, gabor_impl_symmetric(covariance, through));
    return exp(-min(exponent, 80.0)) * rsqrt(determinant);
}

// The filtered windows of one axis for the factors 1, z and 2 z^2 - 1. At a distance d from the node, with the cosine
// and sine of pi d / w, a window's real part is a polynomial in the cosine, its imaginary part the sine times another.
struct GaborBand {
    float reach; // w, in kernel radii
    float slope; // of the taper
    float3 real_0, real_1, real_2, real_3;
    float3 imaginary_0, imaginary_1, imaginary_2;
};

//   deviation  of the filter along the axis
//   g, c       see above
inline GaborBand gabor_impl_band(float deviation, float g, float c)
{
    GaborBand band;
    float wide = clamp(25.0 * deviation - 2.0, 0.0, 1.0);
    float widest = clamp(5.8823529 * deviation - 1.5882353, 0.0, 1.0);
    float t = (wide + widest) / 3.0;
    band.reach = 1.0 + t;
    float taper = min(0.625 * deviation, 0.05) + 0.35 * wide - 0.3 * clamp(12.5 * deviation - 2.125, 0.0, 1.0)
                + 0.1 * widest;
    band.slope = 1.0 / max(taper, 0.001);

    // H(a / 2w) / 2w for a = 1, 2, 3 by a polynomial in w - 1; 1 / 2w for 0.
    float3 h = float3(0.1581287, -0.3374857, 0.6033444) * t + float3(-0.4607931, 0.8628952, -1.266219);
    h = h * t + float3(0.6127236, -0.850095, 0.8539023);
    h = h * t + float3(-0.4679222, 0.271717, -0.05810602);
    h = h * t + float3(0.1246983, 0.1670957, -0.06381795);
    h = h * t + float3(0.25, 0.0, 0.0);

    // H e^(2 pi^2 v q^2 - g (q - c)^2).
    float q = 0.5 / band.reach;
    float center = exp(-g * c * c);
    float curve = exp((2.5797363 - g) * q * q);
    float rise = exp(2.0 * g * c * q);
    float3 rises = float3(rise, rise * rise, rise * rise * rise);
    float curve_4 = curve * curve * curve * curve;
    h *= center * float3(curve, curve_4, curve_4 * curve_4 * curve);
    float scale = sqrt(2.0 * g);
    float3 z = scale * q * float3(1.0, 2.0, 3.0);
    c *= scale;

    // Sums and differences of the waves a and -a, a = 1 to 3, for each factor; then Chebyshev's polynomials.
    float3 even = h * (rises + 1.0 / rises);
    float3 odd = h * (rises - 1.0 / rises);
    float3 even_z = z * odd - c * even;
    float3 odd_z = z * even - c * odd;
    float3 even_zz = 2.0 * (z * odd_z - c * even_z) - even;
    float3 odd_zz = 2.0 * (z * even_z - c * odd_z) - odd;
    float3 first = float3(even.x, even_z.x, even_zz.x);
    float3 second = float3(even.y, even_z.y, even_zz.y);
    float3 third = float3(even.z, even_z.z, even_zz.z);
    band.real_0 = center * q * float3(1.0, -c, 2.0 * c * c - 1.0) - second;
    band.real_1 = first - 3.0 * third;
    band.real_2 = 2.0 * second;
    band.real_3 = 4.0 * third;
    first = float3(odd.x, odd_z.x, odd_zz.x);
    second = float3(odd.y, odd_z.y, odd_zz.y);
    third = float3(odd.z, odd_z.z, odd_zz.z);
    band.imaginary_0 = first - third;
    band.imaginary_1 = 2.0 * second;
    band.imaginary_2 = 4.0 * third;
    return band;
}

// The windows of a node at a distance, in kernel radii, as complex numbers, and their sums over the nodes of a row.
struct GaborFactors {
    float3 real;
    float3 imaginary;
};

//   turn  e^(pi i distance / w)
inline GaborFactors gabor_impl_factors(GaborBand band, float distance, float2 turn)
{
    float taper = clamp((band.reach - abs(distance)) * band.slope, 0.0, 1.0);
    taper *= taper * (3.0 - 2.0 * taper);
    float c = turn.x;
    float3 real = ((band.real_3 * c + band.real_2) * c + band.real_1) * c + band.real_0;
    float3 imaginary = (band.imaginary_2 * c + band.imaginary_1) * c + band.imaginary_0;
    return GaborFactors{taper * real, taper * turn.y * imaginary};
}

inline void gabor_impl_add_filtered(thread GaborFactors& row, uint word, GaborFactors column, bool animated, float2 time)
{
    float2 amplitude = gabor_impl_amplitude(word);
    uint second = gabor_impl_next_word(word);
    if (animated)
        amplitude = gabor_impl_amplitude_at(time, amplitude, gabor_impl_amplitude(second),
                                            gabor_impl_amplitude(gabor_impl_next_word(second)));
    row.real += amplitude.x * column.real - amplitude.y * column.imaginary;
    row.imaginary += amplitude.x * column.imaginary + amplitude.y * column.real;
}
#endif

// ---- The functions to call -----------------------------------------------------------------------------------------

// A lobe of waves around one wave vector.
//   frequency, orientation  as for gabor_noise, whatever the radius: cycles per unit of p, radians
//   radius                  of its kernel, positive: the lobe's bandwidth falls with it, as 1/sqrt(12) / radius cycles
//                           (standard deviation along each axis)
//   power                   in proportion to other lobes', not negative
inline GaborLobe gabor_lobe(float frequency, float orientation, float radius, float power)
{
    return GaborLobe{frequency, orientation, radius, power};
}

// The noise of several lobes at p, a sum of independent noises [TNVT19, figure 6]: normal, mean 0, variance 1. At the
// cost of gabor_noise for each lobe.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//     lobes.count = 2;
inline float gabor_noise_lobes(float2 p, GaborLobes lobes, uint seed)
{
    return gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed).value.y;
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
inline float3 gabor_noise_lobes_gradient(float2 p, GaborLobes lobes, uint seed)
{
    GaborField field = gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The same with its quadrature, as gabor_noise_complex.
inline float2 gabor_noise_lobes_complex(float2 p, GaborLobes lobes, uint seed)
{
    return gabor_field_lobes(gabor_place(int2(0), p * GABOR_RADIUS), lobes, seed).value;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` (0 to 1) of the frequency, both evenly spread, as far as lobes of kernel radius 1 can be. pi/2
// radians are every direction: isotropic noise, whose power varies with direction by at most 5 %. Normal with all its
// derivatives, mean 0, variance 1. Continuous where the arguments are.
// Cost: that of gabor_noise for each lobe. Of directions there are, with o for the orientation_spread,
//     (4.44 frequency + 0.6) o / (pi/2) + 0.8, rounded down, from 1 to 64,
// 10 for isotropic noise of frequency 2, and of frequencies in the same way 2.86 frequency_spread frequency + 0.8, up
// to 16; at some arguments, a fifth of all, two such numbers next to each other together.
inline float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value.y;
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
inline float3 gabor_noise_spread_gradient(float2 p, float frequency, float orientation, float frequency_spread,
                                 float orientation_spread, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    GaborField field = gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The same with its quadrature, as gabor_noise_complex.
inline float2 gabor_noise_spread_complex(float2 p, float frequency, float orientation, float frequency_spread,
                                float orientation_spread, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value;
}

#if GABOR_TAPS == 3
// What a pixel covers that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p) in kernel radii: a normal
// filter of covariance (dx dx^T + dy dy^T) / 4, half a pixel's standard deviation. Any two vectors, parallel ones too.
inline GaborFootprint gabor_footprint(float2 dx, float2 dy)
{
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // or not a number: nothing is left of any wave
        dx = float2(1.0e3, 0.0);
        dy = float2(0.0, 1.0e3);
    }
    GaborFootprint footprint;
    footprint.covariance = 0.25 * float3(dx * dx + dy * dy, dx.x * dx.y + dy.x * dy.y);

    // The eigenvalues are mean +- apart, the smaller one precisely the determinant over the larger one.
    float mean = 0.5 * (footprint.covariance.x + footprint.covariance.y);
    float2 axis = float2(0.5 * (footprint.covariance.x - footprint.covariance.y), footprint.covariance.z);
    float apart = length(axis);
    float larger = mean + apart;
    float side = 0.25 * (dx.x * dy.y - dx.y * dy.x);
    float smaller = larger > 1.0e-12 ? min(side / larger * side, mean) : 0.0;
    footprint.resolved = footprint.covariance;
    if (larger > 0.25) {
        smaller = min(smaller, 0.25);
        axis *= apart > 0.0 ? 0.5 * (0.25 - smaller) / apart : 0.0;
        footprint.resolved = float3(0.5 * (0.25 + smaller) + float2(axis.x, -axis.x), axis.y);
    }
    return footprint;
}

// The noise at a place as a pixel sees it, (real, imaginary), and the share of its variance that is removed. For
// periods, whose nodes are not 1 / GABOR_RADIUS apart, give gabor_footprint steps times place.radius / GABOR_RADIUS.
inline float3 gabor_field_filtered(GaborPlace place, GaborKernel kernel_, GaborFootprint footprint, uint seed)
{
    float2 wave = kernel_.wave * (GABOR_RADIUS / place.radius);
    float transmitted = gabor_impl_transmitted(wave, footprint.covariance);
    if (transmitted < 1.0e-10)
        return float3(0.0, 0.0, 1.0);

    float3 s = footprint.resolved;
    float2 blurred = gabor_impl_symmetric(s, wave); // S F
    float2 m = s.xy + 0.13069097;
    float2 c = gabor_impl_symmetric(float3(m.yx, -s.z), blurred) / (s.z * s.z - m.x * m.y);
    float rho = s.z * rsqrt(m.x * m.y);
    float r = sqrt(1.0 - rho * rho);
    float lambda = rho / (1.0 + r);
    float3 weights = float3(1.0, -2.0 * lambda, 0.5 * lambda * lambda);
    float2 g = 19.739209 * r * m;
    GaborBand across = gabor_impl_band(sqrt(s.x), g.x, c.x);
    GaborBand along = gabor_impl_band(sqrt(s.y), g.y, c.y);

    float2 reach = float2(across.reach, along.reach);
    float2 first = floor(place.local - GABOR_RADIUS * reach) + 1.0;
    int2 count = int2(ceil(2.0 * GABOR_RADIUS * reach - 0.001)); // nodes within reach
    float2 x = place.local - first;
    int2 node = place.cell + int2(first);
    float2 turns = 0.5 / (GABOR_RADIUS * reach);
    float2 time = gabor_impl_wave(place.time);

    // Columns, of which three are always within reach.
    uint salt = gabor_impl_salt(seed);
    uint word[5];
    GaborFactors column[5];
    float2 turn = gabor_impl_wave(turns.x * x.x);
    float2 step = gabor_impl_wave(-turns.x);
    float2 back = float2(kernel_.step_x.x, -kernel_.step_x.y);
    float2 phase = float2(1.0, 0.0);
    for (int i = 0; i < 5; ++i) {
        word[i] = gabor_impl_line_word(gabor_impl_wrap(node.x + i, place.period.x), salt);
        GaborFactors factors = gabor_impl_factors(across, (x.x - float(i)) / GABOR_RADIUS, turn);
        column[i] = GaborFactors{phase.x * factors.real - phase.y * factors.imaginary,
                                 phase.x * factors.imaginary + phase.y * factors.real};
        turn = gabor_impl_product(turn, step);
        phase = gabor_impl_product(phase, back);
    }

    turn = gabor_impl_wave(turns.y * x.y);
    step = gabor_impl_wave(-turns.y);
    back = float2(kernel_.step_y.x, -kernel_.step_y.y);
    phase = gabor_impl_wave(dot(kernel_.wave / place.radius, x));
    float2 sum = float2(0.0);
    int j = 0;
    do {
        uint row_word = gabor_impl_line_word(gabor_impl_wrap(node.y + j, place.period.y), salt ^ GABOR_IMPL_ROWS);
        GaborFactors row = GaborFactors{float3(0.0), float3(0.0)};
        gabor_impl_add_filtered(row, gabor_impl_node_word(word[0], row_word), column[0], place.animated, time);
        uint2 words = uint2(word[1], word[2]);
        GaborFactors left = column[1];
        GaborFactors right = column[2];
        int i = 3;
        do {
            gabor_impl_add_filtered(row, gabor_impl_node_word(words.x, row_word), left, place.animated, time);
            gabor_impl_add_filtered(row, gabor_impl_node_word(words.y, row_word), right, place.animated, time);
            words = uint2(word[3], word[4]);
            left = column[3];
            right = column[4];
            i += 2;
        } while (i < count.x + 2);
        GaborFactors factors = gabor_impl_factors(along, (x.y - float(j)) / GABOR_RADIUS, turn);
        float2 part = float2(dot(weights, factors.real * row.real - factors.imaginary * row.imaginary),
                         dot(weights, factors.real * row.imaginary + factors.imaginary * row.real));
        sum += gabor_impl_product(part, phase);
        turn = gabor_impl_product(turn, step);
        phase = gabor_impl_product(phase, back);
        ++j;
    } while (j < count.y);
    float amplitude = sqrt(1.0 - lambda * lambda) * exp(-19.739209 * dot(wave + c, blurred));
    if (any((footprint.resolved != footprint.covariance)))
        amplitude *= sqrt(transmitted / gabor_impl_transmitted(wave, s));
    return float3(amplitude / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY) * sum, 1.0 - transmitted);
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this removed: what a material lost in roughness, or a picture in contrast. Against the
// noise filtered exactly, see gabor_footprint, the root mean square error is at most 1 % of the noise's deviation for
// steps of up to a third of a kernel radius and 2 % up to a whole one; what covers more fades as it should. Continuous
// in the place and in both steps.
// Cost: 9 nodes up to steps of 0.16 kernel radii, 16 up to 0.54, 25 beyond: on lavapipe 3.4 to 4.9 times gabor_noise.
inline float2 gabor_noise_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed)
{
    return gabor_field_filtered(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation),
                                gabor_footprint(dx, dy), seed).yz;
}

// The noise of several lobes at p, as gabor_noise_lobes, and filtered as gabor_noise_filtered.
inline float2 gabor_noise_lobes_filtered(float2 p, float2 dx, float2 dy, GaborLobes lobes, uint seed)
{
    float2 sum = float2(0.0);
    float power = 0.0;
    for (int i = 0; i < lobes.count; ++i) {
        GaborLobe lobe = lobes.lobe[i];
        float2 value = gabor_noise_filtered(p / lobe.radius, dx / lobe.radius, dy / lobe.radius,
                                          lobe.frequency * lobe.radius, lobe.orientation, gabor_lobe_seed(seed, i));
        sum += float2(sqrt(lobe.power), lobe.power) * value;
        power += lobe.power;
    }
    return power > 0.0 ? sum * float2(rsqrt(power), 1.0 / power) : float2(0.0);
}

#endif // GABOR_TAPS == 3

#endif // GABOR_SPECTRUM_METAL
