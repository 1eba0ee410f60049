// gabor_spectrum.hpp: Gabor noise of any power spectrum, and without aliasing. Include it after gabor_lattice.hpp: for C++ on the CPU.
//
// Made from shaders/gabor_spectrum.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hpp.
//
// Functions to call, at the end of the file:
//     gabor_noise_lobes, gabor_noise_lobes_gradient, gabor_noise_lobes_complex     a sum of lobes
//     gabor_noise_spread, gabor_noise_spread_gradient, gabor_noise_spread_complex  a range of waves, up to isotropic
//     gabor_noise_filtered, gabor_noise_lobes_filtered                             as a pixel sees it
//     gabor_lobe, gabor_footprint, gabor_field_filtered                            their parts
//
// The unit of length is the kernel radius, as in gabor_lattice.hpp, and every function's variance is exactly 1.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_HPP
#error Include gabor_lattice.hpp before gabor_spectrum.hpp
#endif
#ifndef GABOR_SPECTRUM_HPP
#define GABOR_SPECTRUM_HPP

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

GABOR_INLINE void gabor_impl_accumulate(GaborField& sum, GaborField field, float amplitude, float slope)
{
    sum.value += amplitude * field.value;
    sum.slope_x += slope * field.slope_x;
    sum.slope_y += slope * field.slope_y;
    sum.four += amplitude * field.four;
}

// The same place, period and time for a kernel whose radius is `radius` times that of the place's. Its position is
// rounded to a float: within a period, or without one as p is.
GABOR_INLINE GaborPlace gabor_place_scaled(GaborPlace place, float radius)
{
    gabor_ivec2 cell = gabor_ivec2(gabor_impl_wrap(place.cell.x, place.period.x), gabor_impl_wrap(place.cell.y, place.period.y));
    gabor_vec2 unit = 1.0f / (place.radius * radius);
    GaborPlace scaled = gabor_place_tiled((gabor_vec2(cell) + place.local) * unit, gabor_vec2(place.period) * unit);
    scaled.animated = place.animated;
    scaled.time = place.time;
    return scaled;
}

// The noise of a sum of lobes at a place, with its quadrature and derivatives per kernel radius of the place.
GABOR_INLINE GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, std::uint32_t seed)
{
    GaborField sum = GaborField{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec4(0.0f)};
    float power = 0.0f;
    for (int i = 0; i < lobes.count; ++i) {
        GaborLobe lobe = lobes.lobe[i];
        GaborPlace scaled = gabor_place_scaled(place, lobe.radius);
        GaborKernel kernel = gabor_kernel_stretched(gabor_kernel(lobe.frequency * lobe.radius, lobe.orientation),
                                                    scaled.radius);
        GaborField field = gabor_field(scaled, kernel, gabor_lobe_seed(seed, i));
        gabor_impl_accumulate(sum, field, gabor_cpp_sqrt(lobe.power), gabor_cpp_sqrt(lobe.power) / lobe.radius);
        power += lobe.power;
    }
    float scale = power > 0.0f ? gabor_cpp_inversesqrt(power) : 0.0f;
    return GaborField{scale * sum.value, scale * sum.slope_x, scale * sum.slope_y, scale * sum.four};
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is a sum of lobes in the middle of equal pieces of it, at most 0.7 cycles wide: the power of Hann's
// window falls off with a standard deviation of 1/sqrt(12) cycles, so that the sum is even. There are as many pieces as
// the whole part of a number c says. While the rest of c goes from 0.8 to 1 they fade out and one more fade in: the
// noise is continuous in frequency and spread.

// Of `c`: how many lobes there are, of both numbers where one fades.
GABOR_INLINE int gabor_impl_pieces(float c)
{
    return gabor_cpp_fract(c) > 0.8f ? 2 * int(c) + 1 : int(c);
}

// Of lobe `i`: its place in the range, from -1 to 1, its share of the power, and a number for its seed.
GABOR_INLINE gabor_vec3 gabor_impl_piece(int i, float c)
{
    int n = int(c);
    float share = gabor_cpp_min(5.0f - 5.0f * gabor_cpp_fract(c), 1.0f);
    if (i >= n) {
        i -= n;
        n += 1;
        share = 1.0f - share;
    }
    float width = 1.0f / float(n);
    return gabor_vec3((2.0f * float(i) + 1.0f) * width - 1.0f, share * width, float(i + (n & 1) * 64));
}

// The noise of a range of waves at a place, as gabor_noise_spread, with its quadrature and derivatives per kernel radius.
GABOR_INLINE GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
                              float orientation_spread, std::uint32_t seed)
{
    GaborField sum = GaborField{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec4(0.0f)};
    frequency = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f);
    frequency_spread = gabor_cpp_clamp(frequency_spread, 0.0f, 1.0f);
    orientation_spread = gabor_cpp_clamp(orientation_spread, 0.0f, 1.5707963f);
    float shells = gabor_cpp_clamp(2.857f * frequency_spread * frequency + 0.8f, 1.0f, 16.0f);
    int shell_count = gabor_impl_pieces(shells);
    for (int j = 0; j < shell_count; ++j) {
        gabor_vec3 shell = gabor_impl_piece(j, shells);
        float magnitude = frequency * (1.0f + frequency_spread * shell.x);
        float directions = gabor_cpp_clamp(0.63661977f * orientation_spread * (4.44f * magnitude + 0.6f) + 0.8f, 1.0f, 64.0f);
        int direction_count = gabor_impl_pieces(directions);
        for (int i = 0; i < direction_count; ++i) {
            gabor_vec3 direction = gabor_impl_piece(i, directions);
            GaborKernel kernel = gabor_kernel(magnitude, orientation + orientation_spread * direction.x);
            kernel = gabor_kernel_stretched(kernel, place.radius);
            GaborField field = gabor_field(place, kernel, gabor_lobe_seed(seed, int(128.0f * shell.z + direction.z)));
            float amplitude = gabor_cpp_sqrt(shell.y * direction.y);
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
    gabor_vec3 covariance; // xx, yy, xy in kernel radii^2
    gabor_vec3 resolved;   // the same with standard deviations of at most 1/2, for which the windows are made
};

// A symmetric matrix (xx, yy, xy) times a vector.
GABOR_INLINE gabor_vec2 gabor_impl_symmetric(gabor_vec3 matrix, gabor_vec2 v)
{
    return matrix.xy() * v + matrix.z * v.yx();
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe's power taken as
// normal, of variance 1/12 along each axis, as Hann's window has it,
//     |1 + 2/3 pi^2 S|^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F).
GABOR_INLINE float gabor_impl_transmitted(gabor_vec2 wave, gabor_vec3 covariance)
{
    gabor_vec3 widened = gabor_vec3(1.0f, 1.0f, 0.0f) + 6.5797363f * covariance;
    float determinant = widened.x * widened.y - widened.z * widened.z;
    gabor_vec2 through = gabor_impl_symmetric(gabor_vec3(widened.y, widened.x, -widened.z), wave) / determinant;
    float exponent = 39.478418f * gabor_cpp_dot(wave, gabor_impl_symmetric(covariance, through));
    return gabor_cpp_exp(-gabor_cpp_min(exponent, 80.0f)) * gabor_cpp_inversesqrt(determinant);
}

// The filtered windows of one axis for the factors 1, z and 2 z^2 - 1. At a distance d from the node, with the cosine
// and sine of pi d / w, a window's real part is a polynomial in the cosine, its imaginary part the sine times another.
struct GaborBand {
    float reach; // w, in kernel radii
    float slope; // of the taper
    gabor_vec3 real_0, real_1, real_2, real_3;
    gabor_vec3 imaginary_0, imaginary_1, imaginary_2;
};

//   deviation  of the filter along the axis
//   g, c       see above
GABOR_INLINE GaborBand gabor_impl_band(float deviation, float g, float c)
{
    GaborBand band;
    float wide = gabor_cpp_clamp(25.0f * deviation - 2.0f, 0.0f, 1.0f);
    float widest = gabor_cpp_clamp(5.8823529f * deviation - 1.5882353f, 0.0f, 1.0f);
    float t = (wide + widest) / 3.0f;
    band.reach = 1.0f + t;
    float taper = gabor_cpp_min(0.625f * deviation, 0.05f) + 0.35f * wide - 0.3f * gabor_cpp_clamp(12.5f * deviation - 2.125f, 0.0f, 1.0f)
                + 0.1f * widest;
    band.slope = 1.0f / gabor_cpp_max(taper, 0.001f);

    // H(a / 2w) / 2w for a = 1, 2, 3 by a polynomial in w - 1; 1 / 2w for 0.
    gabor_vec3 h = gabor_vec3(0.1581287f, -0.3374857f, 0.6033444f) * t + gabor_vec3(-0.4607931f, 0.8628952f, -1.266219f);
    h = h * t + gabor_vec3(0.6127236f, -0.850095f, 0.8539023f);
    h = h * t + gabor_vec3(-0.4679222f, 0.271717f, -0.05810602f);
    h = h * t + gabor_vec3(0.1246983f, 0.1670957f, -0.06381795f);
    h = h * t + gabor_vec3(0.25f, 0.0f, 0.0f);

    // H e^(2 pi^2 v q^2 - g (q - c)^2).
    float q = 0.5f / band.reach;
    float center = gabor_cpp_exp(-g * c * c);
    float curve = gabor_cpp_exp((2.5797363f - g) * q * q);
    float rise = gabor_cpp_exp(2.0f * g * c * q);
    gabor_vec3 rises = gabor_vec3(rise, rise * rise, rise * rise * rise);
    float curve_4 = curve * curve * curve * curve;
    h *= center * gabor_vec3(curve, curve_4, curve_4 * curve_4 * curve);
    float scale = gabor_cpp_sqrt(2.0f * g);
    gabor_vec3 z = scale * q * gabor_vec3(1.0f, 2.0f, 3.0f);
    c *= scale;

    // Sums and differences of the waves a and -a, a = 1 to 3, for each factor; then Chebyshev's polynomials.
    gabor_vec3 even = h * (rises + 1.0f / rises);
    gabor_vec3 odd = h * (rises - 1.0f / rises);
    gabor_vec3 even_z = z * odd - c * even;
    gabor_vec3 odd_z = z * even - c * odd;
    gabor_vec3 even_zz = 2.0f * (z * odd_z - c * even_z) - even;
    gabor_vec3 odd_zz = 2.0f * (z * even_z - c * odd_z) - odd;
    gabor_vec3 first = gabor_vec3(even.x, even_z.x, even_zz.x);
    gabor_vec3 second = gabor_vec3(even.y, even_z.y, even_zz.y);
    gabor_vec3 third = gabor_vec3(even.z, even_z.z, even_zz.z);
    band.real_0 = center * q * gabor_vec3(1.0f, -c, 2.0f * c * c - 1.0f) - second;
    band.real_1 = first - 3.0f * third;
    band.real_2 = 2.0f * second;
    band.real_3 = 4.0f * third;
    first = gabor_vec3(odd.x, odd_z.x, odd_zz.x);
    second = gabor_vec3(odd.y, odd_z.y, odd_zz.y);
    third = gabor_vec3(odd.z, odd_z.z, odd_zz.z);
    band.imaginary_0 = first - third;
    band.imaginary_1 = 2.0f * second;
    band.imaginary_2 = 4.0f * third;
    return band;
}

// The windows of a node at a distance, in kernel radii, as complex numbers, and their sums over the nodes of a row.
struct GaborFactors {
    gabor_vec3 real;
    gabor_vec3 imaginary;
};

//   turn  e^(pi i distance / w)
GABOR_INLINE GaborFactors gabor_impl_factors(GaborBand band, float distance, gabor_vec2 turn)
{
    float taper = gabor_cpp_clamp((band.reach - gabor_cpp_abs(distance)) * band.slope, 0.0f, 1.0f);
    taper *= taper * (3.0f - 2.0f * taper);
    float c = turn.x;
    gabor_vec3 real = ((band.real_3 * c + band.real_2) * c + band.real_1) * c + band.real_0;
    gabor_vec3 imaginary = (band.imaginary_2 * c + band.imaginary_1) * c + band.imaginary_0;
    return GaborFactors{taper * real, taper * turn.y * imaginary};
}

GABOR_INLINE void gabor_impl_add_filtered(GaborFactors& row, std::uint32_t word, GaborFactors column, bool animated, gabor_vec2 time)
{
    gabor_vec2 amplitude = gabor_impl_amplitude(word);
    std::uint32_t second = gabor_impl_next_word(word);
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
GABOR_INLINE GaborLobe gabor_lobe(float frequency, float orientation, float radius, float power)
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
GABOR_INLINE float gabor_noise_lobes(gabor_vec2 p, GaborLobes lobes, std::uint32_t seed)
{
    return gabor_field_lobes(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), lobes, seed).value.y;
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
GABOR_INLINE gabor_vec3 gabor_noise_lobes_gradient(gabor_vec2 p, GaborLobes lobes, std::uint32_t seed)
{
    GaborField field = gabor_field_lobes(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), lobes, seed);
    return gabor_vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The same with its quadrature, as gabor_noise_complex.
GABOR_INLINE gabor_vec2 gabor_noise_lobes_complex(gabor_vec2 p, GaborLobes lobes, std::uint32_t seed)
{
    return gabor_field_lobes(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), lobes, seed).value;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` (0 to 1) of the frequency, both evenly spread, as far as lobes of kernel radius 1 can be. pi/2
// radians are every direction: isotropic noise, whose power varies with direction by at most 5 %. Normal with all its
// derivatives, mean 0, variance 1. Continuous where the arguments are.
// Cost: that of gabor_noise for each lobe. Of directions there are, with o for the orientation_spread,
//     (4.44 frequency + 0.6) o / (pi/2) + 0.8, rounded down, from 1 to 64,
// 10 for isotropic noise of frequency 2, and of frequencies in the same way 2.86 frequency_spread frequency + 0.8, up
// to 16; at some arguments, a fifth of all, two such numbers next to each other together.
GABOR_INLINE float gabor_noise_spread(gabor_vec2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         std::uint32_t seed)
{
    GaborPlace place = gabor_place(gabor_ivec2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value.y;
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
GABOR_INLINE gabor_vec3 gabor_noise_spread_gradient(gabor_vec2 p, float frequency, float orientation, float frequency_spread,
                                 float orientation_spread, std::uint32_t seed)
{
    GaborPlace place = gabor_place(gabor_ivec2(0), p * GABOR_RADIUS);
    GaborField field = gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed);
    return gabor_vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The same with its quadrature, as gabor_noise_complex.
GABOR_INLINE gabor_vec2 gabor_noise_spread_complex(gabor_vec2 p, float frequency, float orientation, float frequency_spread,
                                float orientation_spread, std::uint32_t seed)
{
    GaborPlace place = gabor_place(gabor_ivec2(0), p * GABOR_RADIUS);
    return gabor_field_spread(place, frequency, orientation, frequency_spread, orientation_spread, seed).value;
}

#if GABOR_TAPS == 3
// What a pixel covers that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p) in kernel radii: a normal
// filter of covariance (dx dx^T + dy dy^T) / 4, half a pixel's standard deviation. Any two vectors, parallel ones too.
GABOR_INLINE GaborFootprint gabor_footprint(gabor_vec2 dx, gabor_vec2 dy)
{
    if (!(gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy) < 1.0e6f)) { // or not a number: nothing is left of any wave
        dx = gabor_vec2(1.0e3f, 0.0f);
        dy = gabor_vec2(0.0f, 1.0e3f);
    }
    GaborFootprint footprint;
    footprint.covariance = 0.25f * gabor_vec3(dx * dx + dy * dy, dx.x * dx.y + dy.x * dy.y);

    // The eigenvalues are mean +- apart, the smaller one precisely the determinant over the larger one.
    float mean = 0.5f * (footprint.covariance.x + footprint.covariance.y);
    gabor_vec2 axis = gabor_vec2(0.5f * (footprint.covariance.x - footprint.covariance.y), footprint.covariance.z);
    float apart = gabor_cpp_length(axis);
    float larger = mean + apart;
    float side = 0.25f * (dx.x * dy.y - dx.y * dy.x);
    float smaller = larger > 1.0e-12f ? gabor_cpp_min(side / larger * side, mean) : 0.0f;
    footprint.resolved = footprint.covariance;
    if (larger > 0.25f) {
        smaller = gabor_cpp_min(smaller, 0.25f);
        axis *= apart > 0.0f ? 0.5f * (0.25f - smaller) / apart : 0.0f;
        footprint.resolved = gabor_vec3(0.5f * (0.25f + smaller) + gabor_vec2(axis.x, -axis.x), axis.y);
    }
    return footprint;
}

// The noise at a place as a pixel sees it, (real, imaginary), and the share of its variance that is removed. For
// periods, whose nodes are not 1 / GABOR_RADIUS apart, give gabor_footprint steps times place.radius / GABOR_RADIUS.
GABOR_INLINE gabor_vec3 gabor_field_filtered(GaborPlace place, GaborKernel kernel, GaborFootprint footprint, std::uint32_t seed)
{
    gabor_vec2 wave = kernel.wave * (GABOR_RADIUS / place.radius);
    float transmitted = gabor_impl_transmitted(wave, footprint.covariance);
    if (transmitted < 1.0e-10f)
        return gabor_vec3(0.0f, 0.0f, 1.0f);

    gabor_vec3 s = footprint.resolved;
    gabor_vec2 blurred = gabor_impl_symmetric(s, wave); // S F
    gabor_vec2 m = s.xy() + 0.13069097f;
    gabor_vec2 c = gabor_impl_symmetric(gabor_vec3(m.yx(), -s.z), blurred) / (s.z * s.z - m.x * m.y);
    float rho = s.z * gabor_cpp_inversesqrt(m.x * m.y);
    float r = gabor_cpp_sqrt(1.0f - rho * rho);
    float lambda = rho / (1.0f + r);
    gabor_vec3 weights = gabor_vec3(1.0f, -2.0f * lambda, 0.5f * lambda * lambda);
    gabor_vec2 g = 19.739209f * r * m;
    GaborBand across = gabor_impl_band(gabor_cpp_sqrt(s.x), g.x, c.x);
    GaborBand along = gabor_impl_band(gabor_cpp_sqrt(s.y), g.y, c.y);

    gabor_vec2 reach = gabor_vec2(across.reach, along.reach);
    gabor_vec2 first = gabor_cpp_floor(place.local - GABOR_RADIUS * reach) + 1.0f;
    gabor_ivec2 count = gabor_ivec2(gabor_cpp_ceil(2.0f * GABOR_RADIUS * reach - 0.001f)); // nodes within reach
    gabor_vec2 x = place.local - first;
    gabor_ivec2 node = place.cell + gabor_ivec2(first);
    gabor_vec2 turns = 0.5f / (GABOR_RADIUS * reach);
    gabor_vec2 time = gabor_impl_wave(place.time);

    // Columns, of which three are always within reach.
    std::uint32_t salt = gabor_impl_salt(seed);
    std::uint32_t word[5];
    GaborFactors column[5];
    gabor_vec2 turn = gabor_impl_wave(turns.x * x.x);
    gabor_vec2 step = gabor_impl_wave(-turns.x);
    gabor_vec2 back = gabor_vec2(kernel.step_x.x, -kernel.step_x.y);
    gabor_vec2 phase = gabor_vec2(1.0f, 0.0f);
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
    back = gabor_vec2(kernel.step_y.x, -kernel.step_y.y);
    phase = gabor_impl_wave(gabor_cpp_dot(kernel.wave / place.radius, x));
    gabor_vec2 sum = gabor_vec2(0.0f);
    int j = 0;
    do {
        std::uint32_t row_word = gabor_impl_line_word(gabor_impl_wrap(node.y + j, place.period.y), salt ^ GABOR_IMPL_ROWS);
        GaborFactors row = GaborFactors{gabor_vec3(0.0f), gabor_vec3(0.0f)};
        gabor_impl_add_filtered(row, gabor_impl_node_word(word[0], row_word), column[0], place.animated, time);
        gabor_uvec2 words = gabor_uvec2(word[1], word[2]);
        GaborFactors left = column[1];
        GaborFactors right = column[2];
        int i = 3;
        do {
            gabor_impl_add_filtered(row, gabor_impl_node_word(words.x, row_word), left, place.animated, time);
            gabor_impl_add_filtered(row, gabor_impl_node_word(words.y, row_word), right, place.animated, time);
            words = gabor_uvec2(word[3], word[4]);
            left = column[3];
            right = column[4];
            i += 2;
        } while (i < count.x + 2);
        GaborFactors factors = gabor_impl_factors(along, (x.y - float(j)) / GABOR_RADIUS, turn);
        gabor_vec2 part = gabor_vec2(gabor_cpp_dot(weights, factors.real * row.real - factors.imaginary * row.imaginary),
                         gabor_cpp_dot(weights, factors.real * row.imaginary + factors.imaginary * row.real));
        sum += gabor_impl_product(part, phase);
        turn = gabor_impl_product(turn, step);
        phase = gabor_impl_product(phase, back);
        ++j;
    } while (j < count.y);
    float amplitude = gabor_cpp_sqrt(1.0f - lambda * lambda) * gabor_cpp_exp(-19.739209f * gabor_cpp_dot(wave + c, blurred));
    if (gabor_cpp_any((footprint.resolved != footprint.covariance)))
        amplitude *= gabor_cpp_sqrt(transmitted / gabor_impl_transmitted(wave, s));
    return gabor_vec3(amplitude / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY) * sum, 1.0f - transmitted);
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this removed: what a material lost in roughness, or a picture in contrast. Against the
// noise filtered exactly, see gabor_footprint, the root mean square error is at most 1 % of the noise's deviation for
// steps of up to a third of a kernel radius and 2 % up to a whole one; what covers more fades as it should. Continuous
// in the place and in both steps.
// Cost: 9 nodes up to steps of 0.16 kernel radii, 16 up to 0.54, 25 beyond: on lavapipe 3.4 to 4.9 times gabor_noise.
GABOR_INLINE gabor_vec2 gabor_noise_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, float frequency, float orientation, std::uint32_t seed)
{
    return gabor_field_filtered(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation),
                                gabor_footprint(dx, dy), seed).yz();
}

// The noise of several lobes at p, as gabor_noise_lobes, and filtered as gabor_noise_filtered.
GABOR_INLINE gabor_vec2 gabor_noise_lobes_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, GaborLobes lobes, std::uint32_t seed)
{
    gabor_vec2 sum = gabor_vec2(0.0f);
    float power = 0.0f;
    for (int i = 0; i < lobes.count; ++i) {
        GaborLobe lobe = lobes.lobe[i];
        gabor_vec2 value = gabor_noise_filtered(p / lobe.radius, dx / lobe.radius, dy / lobe.radius,
                                          lobe.frequency * lobe.radius, lobe.orientation, gabor_lobe_seed(seed, i));
        sum += gabor_vec2(gabor_cpp_sqrt(lobe.power), lobe.power) * value;
        power += lobe.power;
    }
    return power > 0.0f ? sum * gabor_vec2(gabor_cpp_inversesqrt(power), 1.0f / power) : gabor_vec2(0.0f);
}

#endif // GABOR_TAPS == 3

#endif // GABOR_SPECTRUM_HPP
