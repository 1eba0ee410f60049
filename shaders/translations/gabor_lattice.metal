// gabor_lattice.metal: exactly normalized Gabor noise in two dimensions, from random amplitudes on a lattice: for the Metal shading language.
//
// Made from shaders/gabor_lattice.glsl by tools/translate: change that file, not this one.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // mean 0, variance 1
//     float v = gabor_unorm(n);                    // in [0, 1], to show
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                 the noise, and to show it
//     gabor_noise_gradient                     with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor        with its quadrature: phase and intensity
//     gabor_noise_four                         four independent ones at once
//     gabor_noise_tiled, gabor_noise_animated  with exact periods in space, and in time
//     gabor_noise_at, gabor_kernel             by integer cell and local offset, for large worlds
//
// The noise. The nodes c_ij of a square lattice, R to the unit of length, have random complex amplitudes A_ij,
// independent and normal, and each sends out a wave under a window that ends one unit from it along x and y:
//
//     n(p) = K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)),   F = frequency (cos o, sin o)
//
// The unit of length is the kernel radius, where the window h ends. It is Hann's, h(x) = (1 + cos pi x) / 2. GABOR_TAPS
// nodes along each axis reach a point, R = GABOR_TAPS / 2, and as three or more evenly spaced shifts of cos and of
// cos^2 over their period sum to a constant,
//
//     sum_i h(x - x_i)^2 = 3/8 GABOR_TAPS   at every x,
//
// and likewise for the squares of the derivatives: the variances of the noise, of its gradient and of its second
// derivatives are the same at every place, at every frequency. The sum is normal where the amplitudes are. Each wave's
// phase counts from its own node, so frequency and orientation may vary from place to place. After Tavernier, Neyret,
// Vergne and Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019, whose last section asks for it.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifdef GABOR_NOISE_METAL
#error Include gabor_noise.metal or gabor_lattice.metal, not both: they define the same functions
#endif
#ifndef GABOR_LATTICE_METAL
#define GABOR_LATTICE_METAL

#include <metal_stdlib>

using namespace metal;

// Nodes along each axis that reach a point: 3; 4 for a covariance that depends less on the place; 2 for speed.
#ifndef GABOR_TAPS
#define GABOR_TAPS 3
#endif
#if GABOR_TAPS < 2 || GABOR_TAPS > 4
#error GABOR_TAPS is 2, 3 or 4
#endif

// R, nodes per kernel radius.
#define GABOR_RADIUS (0.5 * float(GABOR_TAPS))

// ---- Randomness ----------------------------------------------------------------------------------------------------

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project).
inline uint gabor_impl_mix(uint word, uint salt)
{
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The salt of an axis: x is 0, y is 1, z is 2. With one salt for all, nodes on the diagonal would have the same word.
inline uint gabor_impl_salt(uint seed, uint axis)
{
    return gabor_impl_mix(seed * 0x9e3779b1u + axis, 0x2545f491u);
}

// The word of a column (axis 0) or a row (axis 1) of nodes.
inline uint gabor_impl_line_word(int index, uint salt)
{
    return gabor_impl_mix(uint(index) * 0x9e3779b1u + salt, salt);
}

// The word of a node, from the xor of those of its column and its row. The 16 high bits are well mixed.
inline uint gabor_impl_node_word(uint lines)
{
    return lines * 0x85ebca6bu;
}

// Another word of the same node.
inline uint gabor_impl_next_word(uint word)
{
    return (word ^ (word >> 15u)) * 0xd35a2d97u;
}

// The amplitude of a word: its parts, from the word's two high bytes, are independent and nearly normal, with mean 0
// and the deviation below. With u uniform in [-1, 1] each is proportional to u (1 - 1.2373 u^2 + 1.7741 u^4).
#define GABOR_IMPL_DEVIATION 1.1657255e10
inline float2 gabor_impl_amplitude(uint word)
{
    float2 u = float2(float(int(word) >> 24), float(int(word << 8u) >> 24)) + 0.5;
    float2 t = u * u - 5713.2978;
    return u * (t * t + 118666190.0);
}

// ---- Waves ---------------------------------------------------------------------------------------------------------

// (cos, sin) of 2 pi t for any t, within 2e-7: reduced to half a turn, then minimax polynomials that share the zeros.
inline float2 gabor_impl_wave(float t)
{
    t -= floor(t + 0.5);
    float s = t * t;
    float cosine = 6.5400201 * s - 25.567098;
    cosine = cosine * s + 58.571857;
    cosine = cosine * s - 81.78964;
    cosine = cosine * s + 59.827274;
    cosine = cosine * s - 16.0;
    float sine = 38.123197 - 12.233302 * s;
    sine = sine * s - 67.043898;
    sine = sine * s + 64.834681;
    sine = sine * s - 25.13273;
    return float2((s - 0.0625) * cosine, t * (s - 0.25) * sine);
}

// The unit vector at an angle in radians: reduced by pi/2 in three steps, then minimax polynomials. Its error stays
// near 1e-7, for a large frequency multiplies it.
inline float2 gabor_impl_direction(float angle)
{
    float quarter = floor(angle * 0.63661977 + 0.5);
    float r = angle - quarter * 1.5703125;
    r -= quarter * 4.837512969970703e-4;
    r -= quarter * 7.549789948768648e-8;
    r = abs(r) < 1.0 ? r : 0.0; // far outside the range, where no digit is left of it, any direction will do
    float s = r * r;
    float sine = r + r * s * (-0.16666654 + s * (8.3321608e-3 - s * 1.9515295e-4));
    float cosine = 1.0 - 0.5 * s + s * s * (4.1666645e-2 + s * (-1.3887316e-3 + s * 2.4433157e-5));
    float2 axis = fract(0.5 * quarter) < 0.25 ? float2(cosine, sine) : float2(-sine, cosine);
    return fract(0.25 * quarter) < 0.375 ? axis : -axis;
}

// Product of complex numbers.
inline float2 gabor_impl_product(float2 a, float2 b)
{
    return float2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// ---- Windows -------------------------------------------------------------------------------------------------------

// The windows of one axis' GABOR_TAPS nodes, and their derivatives per kernel radius where nodes are 1/R apart.
struct GaborWindows {
    float4 value;
    float4 slope;
};

#if GABOR_TAPS == 2
// Two shifts of Hann's window do not sum to a constant. Vorbis' window sin(pi/2 cos^2(pi x / 2)) does, for its two
// shifts are the sine and the cosine of one angle [Princen and Bradley 1986]; the derivatives' variances do vary.
//   x   offset from the first node, in [0, 1) node spacings
inline GaborWindows gabor_impl_windows(float x)
{
    float2 half_turn = gabor_impl_wave(0.5 * x);
    float2 window = gabor_impl_wave(0.125 + 0.125 * half_turn.x); // of the angle pi/2 cos^2(pi x / 2)
    float slope = 2.4674011 * half_turn.y; // pi^2 / 4 sin(pi x)
    return GaborWindows{float4(window.yx, 0.0, 0.0), float4(-slope * window.x, slope * window.y, 0.0, 0.0)};
}
#elif GABOR_TAPS == 3
//   x   offset from the first node, in [1/2, 3/2) node spacings
inline GaborWindows gabor_impl_windows(float x)
{
    x -= 1.0;
    float s = x * x;
    float cosine = 1.0 + s * (-2.1932453 + s * (0.80171627 + s * (-0.11716848 + s * 0.00891324)));
    float sine = x * (2.0943948 + s * (-1.5311589 + s * (0.33560338 - s * 0.03389007)));
    float3 c = float3(-0.5 * cosine - 0.8660254 * sine, cosine, -0.5 * cosine + 0.8660254 * sine);
    float3 d = float3(-0.5 * sine + 0.8660254 * cosine, sine, -0.5 * sine - 0.8660254 * cosine);
    return GaborWindows{float4(0.5 + 0.5 * c, 0.0), float4(-1.5707963 * d, 0.0)};
}
#else
//   x   offset from the first node, in [1, 2) node spacings
inline GaborWindows gabor_impl_windows(float x)
{
    x -= 1.5;
    float s = x * x;
    float cosine = 1.0 + s * (-1.2337005 + s * (0.25366924 + s * (-0.020860289 + s * 0.00090402167)));
    float sine = x * (1.5707963 + s * (-0.64596294 + s * (0.0796759 - s * 0.00459229)));
    float2 c = 0.35355339 * float2(cosine - sine, cosine + sine); // half of cos and sin of pi/4 + pi/2 x
    return GaborWindows{0.5 + float4(-c.y, c.x, c.y, -c.x), 3.1415927 * float4(-c.x, -c.y, c.x, c.y)};
}
#endif

// The mean square of the sum over one axis.
#if GABOR_TAPS == 2
#define GABOR_IMPL_ENERGY 1.0
#else
#define GABOR_IMPL_ENERGY (0.375 * float(GABOR_TAPS))
#endif

// ---- The sum -------------------------------------------------------------------------------------------------------

// A wave vector and all that the noise needs of it: make it once where frequency and orientation do not vary.
struct GaborKernel {
    float2 wave;   // F, cycles per kernel radius
    float2 step_x; // e^(2 pi i F.x / R), what a wave turns from one node to the next along x
    float2 step_y; // along y
};

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    int2 cell;    // any integers, but for the last few before the world wraps around at 2^31
    float2 local;    // offset from that cell's corner, in node spacings: any small vector, [0, 1)^2 is the most precise
    float2 radius;   // nodes per kernel radius along each axis: GABOR_RADIUS, or near it to fit a period
    int2 period;  // in nodes, 0 for none
    bool animated; // whether time counts
    float time;    // in periods of time
};

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField {
    float2 value;
    float2 slope_x;
    float2 slope_y;
    float4 four; // four independent noises, the first the noise itself
};

// The nodes of one axis that reach a point: their words, and the factors that their amplitudes meet along it, h e and
// h' e with e = exp(2 pi i F (x - x_i)) but for what is common to all.
struct GaborAxis {
    uint4 word;
    float4 real;
    float4 imaginary;
    float4 slope_real;
    float4 slope_imaginary;
};

// An index within a period.
inline int gabor_impl_wrap(int index, int period)
{
    if (period == 0)
        return index;
    int within = index - index / period * period;
    return within < 0 ? within + period : within;
}

//   first   index of the first node
//   x       offset from it, in node spacings
//   period  in nodes, 0 for none
//   step    e^(2 pi i F / R): what the wave turns from one node to the next
// The wave is taken relative to the second node, of the first for two taps.
inline GaborAxis gabor_impl_axis(int first, float x, int period, uint salt, float2 step)
{
    GaborAxis axis;
    axis.word = uint4(gabor_impl_line_word(gabor_impl_wrap(first, period), salt),
                      gabor_impl_line_word(gabor_impl_wrap(first + 1, period), salt),
                      gabor_impl_line_word(gabor_impl_wrap(first + 2, period), salt),
                      gabor_impl_line_word(gabor_impl_wrap(first + 3, period), salt));
#if GABOR_TAPS == 2
    float4 cosine = float4(1.0, step.x, 0.0, 0.0);
    float4 sine = float4(0.0, -step.y, 0.0, 0.0);
#else
    float2 two = gabor_impl_product(step, step);
    float4 cosine = float4(step.x, 1.0, step.x, two.x);
    float4 sine = float4(step.y, 0.0, -step.y, -two.y);
#endif
    GaborWindows window = gabor_impl_windows(x);
    axis.real = window.value * cosine;
    axis.imaginary = window.value * sine;
    axis.slope_real = window.slope * cosine;
    axis.slope_imaginary = window.slope * sine;
    return axis;
}

// The amplitude of a node at a time, whose cosine and sine are given: (A0 + A1 cos + A2 sin) / sqrt(2), normal at every
// time; the correlation of two times is cos^2(pi lag).
inline float2 gabor_impl_amplitude_at(uint word, float2 time)
{
    uint second = gabor_impl_next_word(word);
    float2 moving = time.x * gabor_impl_amplitude(second)
                + time.y * gabor_impl_amplitude(gabor_impl_next_word(second));
    return 0.70710678 * (gabor_impl_amplitude(word) + moving);
}

// Sums over the nodes of one row: what it gives to the field and, with the windows' derivatives, to its slope along x.
struct GaborRow {
    float2 value;
    float2 slope;
    float4 four_real;
    float4 four_imaginary;
};

inline void gabor_impl_add_node(thread GaborRow& row, uint word, float2 factor, float2 slope, bool animated, float2 time)
{
    float2 amplitude = gabor_impl_amplitude(word);
    if (animated)
        amplitude = gabor_impl_amplitude_at(word, time);
    row.value += gabor_impl_product(amplitude, factor);
    row.slope += gabor_impl_product(amplitude, slope);

    uint second = gabor_impl_next_word(word);
    uint third = gabor_impl_next_word(second);
    float2 b = gabor_impl_amplitude(second);
    float2 c = gabor_impl_amplitude(third);
    float2 d = gabor_impl_amplitude(gabor_impl_next_word(third));
    float4 real = float4(amplitude.x, b.x, c.x, d.x);
    float4 imaginary = float4(amplitude.y, b.y, c.y, d.y);
    row.four_real += factor.x * real - factor.y * imaginary;
    row.four_imaginary += factor.x * imaginary + factor.y * real;
}

inline GaborRow gabor_impl_row(GaborAxis axis, uint word, bool animated, float2 time)
{
    GaborRow row = GaborRow{float2(0.0), float2(0.0), float4(0.0), float4(0.0)};
    gabor_impl_add_node(row, gabor_impl_node_word(axis.word.x ^ word), float2(axis.real.x, axis.imaginary.x),
                        float2(axis.slope_real.x, axis.slope_imaginary.x), animated, time);
    gabor_impl_add_node(row, gabor_impl_node_word(axis.word.y ^ word), float2(axis.real.y, axis.imaginary.y),
                        float2(axis.slope_real.y, axis.slope_imaginary.y), animated, time);
#if GABOR_TAPS > 2
    gabor_impl_add_node(row, gabor_impl_node_word(axis.word.z ^ word), float2(axis.real.z, axis.imaginary.z),
                        float2(axis.slope_real.z, axis.slope_imaginary.z), animated, time);
#endif
#if GABOR_TAPS > 3
    gabor_impl_add_node(row, gabor_impl_node_word(axis.word.w ^ word), float2(axis.real.w, axis.imaginary.w),
                        float2(axis.slope_real.w, axis.slope_imaginary.w), animated, time);
#endif
    return row;
}

inline void gabor_impl_add_row(thread GaborField& sum, GaborRow row, float2 factor, float2 slope, float2 base)
{
    factor = gabor_impl_product(factor, base);
    sum.value += gabor_impl_product(row.value, factor);
    sum.slope_x += gabor_impl_product(row.slope, factor);
    sum.slope_y += gabor_impl_product(row.value, gabor_impl_product(slope, base));
    sum.four += factor.x * row.four_imaginary + factor.y * row.four_real;
}

// The noise at a place: what the functions below call.
inline GaborField gabor_field(GaborPlace place, GaborKernel kernel_, uint seed)
{
    float2 first = floor(place.local - GABOR_RADIUS) + 1.0;
    float2 x = place.local - first;
    int2 node = place.cell + int2(first);
    GaborAxis columns = gabor_impl_axis(node.x, x.x, place.period.x, gabor_impl_salt(seed, 0u), kernel_.step_x);
    GaborAxis rows = gabor_impl_axis(node.y, x.y, place.period.y, gabor_impl_salt(seed, 1u), kernel_.step_y);
    float2 cycles = kernel_.wave / place.radius;
#if GABOR_TAPS > 2
    x -= 1.0;
#endif
    float2 base = gabor_impl_wave(dot(cycles, x));
    float2 time = gabor_impl_wave(place.time);

    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0), float4(0.0)};
    gabor_impl_add_row(sum, gabor_impl_row(columns, rows.word.x, place.animated, time),
                       float2(rows.real.x, rows.imaginary.x), float2(rows.slope_real.x, rows.slope_imaginary.x), base);
    gabor_impl_add_row(sum, gabor_impl_row(columns, rows.word.y, place.animated, time),
                       float2(rows.real.y, rows.imaginary.y), float2(rows.slope_real.y, rows.slope_imaginary.y), base);
#if GABOR_TAPS > 2
    gabor_impl_add_row(sum, gabor_impl_row(columns, rows.word.z, place.animated, time),
                       float2(rows.real.z, rows.imaginary.z), float2(rows.slope_real.z, rows.slope_imaginary.z), base);
#endif
#if GABOR_TAPS > 3
    gabor_impl_add_row(sum, gabor_impl_row(columns, rows.word.w, place.animated, time),
                       float2(rows.real.w, rows.imaginary.w), float2(rows.slope_real.w, rows.slope_imaginary.w), base);
#endif
    // E[n^2] = E[|A|^2] / 2 sum_i h^2 sum_j h^2.
    float scale = 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    float2 stretch = scale / GABOR_RADIUS * place.radius;
    float2 turn = 6.2831853 * scale * kernel_.wave;
    GaborField field;
    field.value = scale * sum.value;
    field.slope_x = stretch.x * sum.slope_x + turn.x * float2(-sum.value.y, sum.value.x);
    field.slope_y = stretch.y * sum.slope_y + turn.y * float2(-sum.value.y, sum.value.x);
    field.four = scale * sum.four;
    return field;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// (cell + local) / GABOR_RADIUS kernel radii, without periods: full precision everywhere in a world of 2^32 cells each
// way, where it wraps around.
inline GaborPlace gabor_place(int2 cell, float2 local)
{
    return GaborPlace{cell, local, float2(GABOR_RADIUS), int2(0), false, 0.0};
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise.
inline GaborKernel gabor_kernel(float frequency, float orientation)
{
    float magnitude = min(abs(frequency), 1.0e6);
    float2 wave = magnitude * gabor_impl_direction(orientation);
    return GaborKernel{wave, gabor_impl_wave(wave.x / GABOR_RADIUS), gabor_impl_wave(wave.y / GABOR_RADIUS)};
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere.
inline float gabor_noise_at(int2 cell, float2 local, GaborKernel kernel_, uint seed)
{
    return gabor_field(gabor_place(cell, local), kernel_, seed).value.y;
}

// Gabor noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p            position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float
//                steps by 0.008.
//   frequency    cycles per kernel radius; its magnitude is used, up to 10^6
//   orientation  direction of the wave vector in radians from +x towards +y, precise within +-400
//   seed         any; each seed is another instance, independent of the others
// Frequency and orientation may vary from place to place: where they are continuous so is the noise, for each wave
// turns about its own node. A slope of theirs adds to that of the noise.
inline float gabor_noise(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_noise_at(int2(0), p * GABOR_RADIUS, gabor_kernel(frequency, orientation), seed);
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
inline float3 gabor_noise_gradient(float2 p, float frequency, float orientation, uint seed)
{
    GaborField field = gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent.
inline float2 gabor_noise_complex(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).value;
}

// Four noises at p, independent of each other, for colours and for displacement along vectors; the first is gabor_noise.
inline float4 gabor_noise_four(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
inline float2 gabor_phasor(float2 value)
{
    float intensity = length(value);
    float phase = intensity > 0.0 ? atan2(value.y, value.x) * 0.15915494 : 0.0;
    return float2(phase < 0.0 ? min(phase + 1.0, 0.99999994) : phase, intensity);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation,
// with the law of gabor_noise: windows become a little wider or narrower, so that a whole number of nodes fits.
// Each period is at least 1/1024; from 2 up windows change by a sixth at most, shorter ones make them as narrow.
inline float gabor_noise_tiled(float2 p, float2 period, float frequency, float orientation, uint seed)
{
    period = max(period, float2(0.0009765625));
    float2 nodes = max(floor(period * GABOR_RADIUS + 0.5), float2(float(GABOR_TAPS)));
    float2 radius = nodes / period;
    float2 within = p - floor(p / period) * period;
    GaborKernel kernel_ = gabor_kernel(frequency, orientation);
    kernel_.step_x = gabor_impl_wave(kernel_.wave.x / radius.x);
    kernel_.step_y = gabor_impl_wave(kernel_.wave.y / radius.y);
    GaborPlace place = GaborPlace{int2(0), within * radius, radius, int2(nodes), false, 0.0};
    return gabor_field(place, kernel_, seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// has the law of gabor_noise, and at all times and places together; its correlation with itself falls with the time
// between as cos^2(pi time): 1/2 after a quarter of the period, 0 after half of it.
inline float gabor_noise_animated(float2 p, float time, float frequency, float orientation, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    place.animated = true;
    place.time = time;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
inline float gabor_unorm(float noise)
{
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

#endif // GABOR_LATTICE_METAL
