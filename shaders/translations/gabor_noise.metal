// gabor_noise.metal: the sparse Gabor noise of [TNVT19] in two dimensions, with unit variance. For new work take
// gabor_lattice.metal, which has the same calls, is faster, and is normal at every place: for the Metal shading language.
//
// Made from shaders/gabor_noise.glsl by tools/translate: change that file, not this one.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // mean 0, variance 1
//     float v = gabor_unorm(n);                    // in [0, 1], to show
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                the noise, and to show it
//     gabor_noise_gradient                    with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor       with its quadrature: phase and intensity
//     gabor_noise_four                        four uncorrelated ones at once
//     gabor_noise_tiled, gabor_noise_animated with exact periods in space, and in time
//     gabor_noise_spread                      waves of many orientations and frequencies, up to isotropic
//     gabor_noise_lobes, gabor_noise_sum      any spectrum, as a list of lobes
//     gabor_noise_filtered                    without aliasing, whatever a pixel covers
//     gabor_noise_at, gabor_kernel            by integer cell and local offset, for large worlds
//     gabor_field                             all of it at once
// Names with gabor_impl_ are private.
//
// The noise is a sum of Gabor kernels around random places x_i (sparse convolution):
//
//     n(p) = K sum_i w_i g_i(p - x_i),     g_i(d) = q(d.x) q(d.y) sin(2 pi (F d.omega + phase_i))
//
// after Tavernier, Neyret, Vergne and Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019 [TNVT19]:
// a fixed number of impulses in each cell of a grid instead of Poisson counts, and weights that vary little. The unit
// of length is the kernel radius: the window q ends at 1, where it and its slope are 0. K makes the variance exactly 1
// at every frequency and every place.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifdef GABOR_LATTICE_METAL
#error Include gabor_noise.metal or gabor_lattice.metal, not both: they define the same functions
#endif
#ifndef GABOR_NOISE_METAL
#define GABOR_NOISE_METAL

#include <metal_stdlib>

using namespace metal;

#define GABOR_NOISE_VERSION 10100 // 10000 major + 100 minor + patch

// ---- Recipe: macros that trade quality for speed --------------------------------------------------------------------
// Define these before the file for another recipe. The defaults are the recipe `one`; README has a table of others.
// GABOR_UNCHECKED is for those who define them as constants that the preprocessor cannot know.

// N, impulses per cell: an int, at least 1.
#ifndef GABOR_IMPULSES
#define GABOR_IMPULSES 1
#endif
#if !defined(GABOR_UNCHECKED) && GABOR_IMPULSES < 1
#error GABOR_IMPULSES is an int, at least 1
#endif

// R, cells per kernel radius: a float, at least 1. Each axis visits ceil(2 R) + 1 cells.
#ifndef GABOR_RADIUS
#define GABOR_RADIUS 1.0
#endif

// A: a weight's magnitude is A or 1, equally likely: a float in [0, 1].
#ifndef GABOR_WEIGHT_FLOOR
#define GABOR_WEIGHT_FLOOR 0.675
#endif

// Phases that impulses have, evenly spread over a turn: a power of two from 4 to 256. Or 2, which is the sine kernel
// with weights of random sign: each kernel then integrates to exactly 0, and gabor_kernel costs more.
#ifndef GABOR_PHASES
#define GABOR_PHASES 256
#endif
#if !defined(GABOR_UNCHECKED) && (GABOR_PHASES < 2 || GABOR_PHASES > 256 || (GABOR_PHASES & (GABOR_PHASES - 1)) != 0)
#error GABOR_PHASES is a power of two, from 2 to 256
#endif

// The window: q(x) = u^2 (c.x + c.y u + c.z u^2) with u = 1 - x^2.
#ifndef GABOR_WINDOW
#define GABOR_WINDOW float3(3.0, -4.5, 2.5)
#endif

// Lobes that gabor_noise_lobes and gabor_noise_sum take: an int, at least 1. The other functions do not depend on it.
#ifndef GABOR_LOBES
#define GABOR_LOBES 1
#endif
#if !defined(GABOR_UNCHECKED) && GABOR_LOBES < 1
#error GABOR_LOBES is an int, at least 1
#endif

// 1 where the device's own sine is to be used: faster on most GPUs, as exact as the driver makes it (Vulkan promises
// 5e-4, many give 1e-6). 0 for a polynomial that is exact to 3e-7 everywhere.
#ifndef GABOR_NATIVE_SINE
#define GABOR_NATIVE_SINE 0
#endif

// Put before each loop over impulses: define it as [[unroll]] (GL_EXT_control_flow_attributes) or [unroll] (HLSL) where
// the compiler leaves the loops of a larger recipe as they are. `one` is unrolled by all that were tried.
#ifndef GABOR_UNROLL
#define GABOR_UNROLL
#endif

// A macro of another type ends here, in a compile error that says what it must be.
inline int gabor_impl_macro_must_be_an_int(int value)
{
    return value;
}

inline float gabor_impl_macro_must_be_a_float(float value)
{
    return value;
}

inline float3 gabor_impl_macro_must_be_a_vec3(float3 value)
{
    return value;
}

inline void gabor_impl_check_macros()
{
    gabor_impl_macro_must_be_an_int(GABOR_IMPULSES);
    gabor_impl_macro_must_be_a_float(GABOR_RADIUS);
    gabor_impl_macro_must_be_a_float(GABOR_WEIGHT_FLOOR);
    gabor_impl_macro_must_be_an_int(GABOR_PHASES);
    gabor_impl_macro_must_be_a_vec3(GABOR_WINDOW);
    gabor_impl_macro_must_be_an_int(GABOR_LOBES);
    gabor_impl_macro_must_be_an_int(GABOR_NATIVE_SINE);
}

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Odd constants that spread consecutive cells, and the impulses of one cell, over all 32 bits.
#define GABOR_IMPL_CELL_STRIDE 0x9e3779b1u
#define GABOR_IMPL_IMPULSE_STRIDE 0x85ebca6bu

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project), the salt entering between them too, so that no two sequences share a run.
inline uint gabor_impl_mix(uint word, uint salt)
{
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The seed of noise `index` of several that are independent of each other, as the lobes of a sum are.
inline uint gabor_lobe_seed(uint seed, int index)
{
    return gabor_impl_mix(seed + uint(index) * GABOR_IMPL_IMPULSE_STRIDE, GABOR_IMPL_CELL_STRIDE);
}

// The word of `seed`, from which those of the rows follow.
inline uint gabor_impl_seed_word(uint seed)
{
    return gabor_impl_mix(seed * GABOR_IMPL_CELL_STRIDE, 0x2545f491u);
}

// The word of a row of cells, from which those of its impulses follow.
inline uint gabor_impl_row_word(int row, uint seed_word)
{
    return gabor_impl_mix(uint(row) * GABOR_IMPL_CELL_STRIDE + seed_word, seed_word);
}

// The word of impulse `index` in a cell. In its bits are y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading ones of y and the trailing ones
// of x: only offsets in x below 1/256 of a cell depend on y.
inline uint gabor_impl_impulse_word(int column, uint row_word, int index)
{
    uint salt = row_word + uint(index) * GABOR_IMPL_IMPULSE_STRIDE;
    return gabor_impl_mix(uint(column) * GABOR_IMPL_CELL_STRIDE + salt, salt);
}

// Position of an impulse in its cell, plus 1: in [1, 2)^2, which takes no conversion from integers.
inline float2 gabor_impl_position_plus_one(uint word)
{
    return float2(as_type<float>(0x3f800000u | ((word >> 8u) & 0x7fffffu)),
                as_type<float>(0x3f800000u | (word & 0x7fffffu)));
}

// Phase of the impulse at that position, in turns.
inline float gabor_impl_phase(float2 position_plus_one, float phases)
{
    return fract(position_plus_one.y * (8388608.0 / phases));
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
inline float gabor_impl_phase_rate(uint word)
{
    float rate = float((word >> 8u) & 7u) - 4.0;
    return rate < 0.0 ? rate : rate + 1.0;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
inline float4 gabor_impl_four(float2 wave, uint word)
{
    uint quarters = gabor_impl_mix(word, GABOR_IMPL_IMPULSE_STRIDE);
    float4 shifted = float4((quarters & 1u) == 0u ? wave.y : wave.x, (quarters & 2u) == 0u ? wave.y : wave.x,
                        (quarters & 4u) == 0u ? wave.y : wave.x, (quarters & 8u) == 0u ? wave.y : wave.x);
    return shifted * float4((quarters & 16u) == 0u ? 1.0 : -1.0, (quarters & 32u) == 0u ? 1.0 : -1.0,
                          (quarters & 64u) == 0u ? 1.0 : -1.0, (quarters & 128u) == 0u ? 1.0 : -1.0);
}

// Magnitude of an impulse's weight.
inline float gabor_impl_magnitude(uint word)
{
    return int(word) < 0 ? 1.0 : GABOR_WEIGHT_FLOOR;
}

// ---- Sine ----------------------------------------------------------------------------------------------------------

// sin(2 pi t) for any t: reduced to half a turn, then t (1/4 - t^2) times a minimax polynomial in t^2.
// Absolute error below 3e-7 within +-1, growing with the rounding of t beyond.
inline float gabor_impl_sine(float t)
{
    t = fract(t) - 0.5;
    if (GABOR_NATIVE_SINE != 0)
        return -sin(6.2831853 * t);
    float s = t * t;
    float p = 12.233303 * s - 38.123196;
    p = p * s + 67.0439;
    p = p * s - 64.83468;
    p = p * s + 25.13273;
    return t * (s - 0.25) * p;
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

// ---- Normalization -------------------------------------------------------------------------------------------------

// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). The five c_n I_n, whose sum is the energy of one axis:
struct GaborEnergy {
    float4 e4567;
    float e8;
    float sum;
};

inline GaborEnergy gabor_impl_energy()
{
    float3 c = GABOR_WINDOW;
    GaborEnergy energy;
    energy.e4567 = float4(c.x * c.x, 2.0 * c.x * c.y, c.y * c.y + 2.0 * c.x * c.z, 2.0 * c.y * c.z)
                 * float4(256.0 / 315.0, 512.0 / 693.0, 2048.0 / 3003.0, 4096.0 / 6435.0);
    energy.e8 = c.z * c.z * (65536.0 / 109395.0);
    energy.sum = dot(energy.e4567, float4(1.0)) + energy.e8;
    return energy;
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel of k cycles per radius, relative to that at high frequency. For small a from 1 - L_n by the power
// series of L_7 and L_8 and downward recurrence; for large a by upward recurrence from L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
inline float gabor_impl_relative_energy(float k, GaborEnergy energy)
{
    float a = 12.566371 * k;
    float z = a * a;
    float4 d4567;
    float d8 = 0.0;
    if (z < 64.0) {
        float d7 = 0.0;
        float term7 = 1.0;
        float term8 = 1.0;
        for (int i = 1; i <= 14; ++i) {
            float n = float(i);
            term7 *= -0.25 * z / (n * (n + 7.5));
            term8 *= -0.25 * z / (n * (n + 8.5));
            d7 -= term7;
            d8 -= term8;
        }
        float d6 = d7 + z * (1.0 - d8) * (1.0 / 255.0);
        float d5 = d6 + z * (1.0 - d7) * (1.0 / 195.0);
        float d4 = d5 + z * (1.0 - d6) * (1.0 / 143.0);
        d4567 = float4(d4, d5, d6, d7);
    } else {
        float y = 1.0 / z;
        float l0 = gabor_impl_sine(2.0 * k) / a;
        float l1 = 3.0 * y * (l0 - gabor_impl_sine(2.0 * k + 0.25));
        float l2 = 15.0 * y * (l1 - l0);
        float l3 = 35.0 * y * (l2 - l1);
        float l4 = 63.0 * y * (l3 - l2);
        float l5 = 99.0 * y * (l4 - l3);
        float l6 = 143.0 * y * (l5 - l4);
        float l7 = 195.0 * y * (l6 - l5);
        d8 = 1.0 - 255.0 * y * (l7 - l6);
        d4567 = 1.0 - float4(l4, l5, l6, l7);
    }
    return (dot(energy.e4567, d4567) + energy.e8 * d8) / energy.sum;
}

// ---- Kernels -------------------------------------------------------------------------------------------------------

// Waves around one frequency and orientation.
struct GaborLobe {
    float2 wave;   // wave vector in the middle, cycles per kernel radius
    float2 spread; // impulses have waves evenly spread within frequency (1 +- x), and within +- y turns
    float power; // in proportion to those of other lobes
};

// The lobe of a frequency and an orientation, with the ranges of gabor_noise, and
//   frequency_spread    a share of the frequency, within [0, 1]
//   orientation_spread  radians: pi/2 and more is every direction, isotropic
//   power               in any unit, up to 10^9
// What is less than 0 or NaN counts as 0.
inline GaborLobe gabor_lobe(float frequency, float orientation, float frequency_spread, float orientation_spread, float power)
{
    float magnitude = abs(frequency);
    magnitude = magnitude > 1.0e-6 ? min(magnitude, 1.0e6) : 1.0e-6;
    GaborLobe lobe;
    lobe.wave = magnitude * gabor_impl_direction(orientation);
    lobe.spread.x = frequency_spread > 0.0 ? min(frequency_spread, 1.0) : 0.0;
    lobe.spread.y = orientation_spread > 0.0 ? 0.15915494 * min(orientation_spread, 1.5707963) : 0.0;
    lobe.power = power > 0.0 ? min(power, 1.0e9) : 0.0;
    return lobe;
}

// A spectrum: what gabor_noise_lobes and gabor_noise_sum take.
struct GaborLobes {
    GaborLobe lobe[GABOR_LOBES];
    int count; // of those in use, 1 to GABOR_LOBES
};

// Gabor kernels ready to be summed: all that the noise needs to know of its spectrum.
struct GaborKernel {
    GaborLobes lobes; // each with the cumulative power, its own and that of those before it
    float phases;     // that impulses have
    float amplitude;  // K
    float variance_factor; // variance for K = 1, relative to that at high frequency: 1 but for two phases
};

// The kernels of some lobes' spectrum: each impulse has a wave of one lobe, chosen with a probability in proportion to
// its power, so that many lobes have the impulses of one. The variance is 1 whatever the powers. Impulses have 256
// phases, even where GABOR_PHASES is 2: then the variance depends on no frequency.
//
// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
inline GaborKernel gabor_kernel_lobes(GaborLobes lobes)
{
    GaborKernel kernel_;
    kernel_.lobes = lobes;
    kernel_.lobes.count = clamp(lobes.count, 1, GABOR_LOBES);
    float total_power = 0.0;
    GABOR_UNROLL for (int i = 0; i < GABOR_LOBES; ++i) {
        total_power += i < kernel_.lobes.count ? lobes.lobe[i].power : 0.0;
        kernel_.lobes.lobe[i].power = total_power;
    }
    kernel_.phases = 256.0;
    kernel_.variance_factor = 1.0;
    float density = float(GABOR_IMPULSES) * GABOR_RADIUS * GABOR_RADIUS;
    float power = 0.5 + 0.5 * GABOR_WEIGHT_FLOOR * GABOR_WEIGHT_FLOOR;
    float energy = gabor_impl_energy().sum;
    kernel_.amplitude = rsqrt(0.5 * density * power * energy * energy);
    return kernel_;
}

// The kernel of one lobe.
inline GaborKernel gabor_kernel_lobe(GaborLobe lobe)
{
    GaborLobes lobes;
    for (int i = 0; i < GABOR_LOBES; ++i)
        lobes.lobe[i] = lobe;
    lobes.count = 1;
    return gabor_kernel_lobes(lobes);
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise. Make it once where they do not vary.
//
// With two phases the sin^2 of gabor_kernel_lobes does not average to 1/2: with a = 4 pi F omega,
//     J(0)^2 - J(a.x) J(a.y)   takes the place of   J(0)^2.
inline GaborKernel gabor_kernel(float frequency, float orientation)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, 0.0, 0.0, 1.0);
    GaborKernel kernel_ = gabor_kernel_lobe(lobe);
    kernel_.phases = float(GABOR_PHASES);
    if (GABOR_PHASES == 2) {
        GaborEnergy energy = gabor_impl_energy();
        float x = gabor_impl_relative_energy(lobe.wave.x, energy);
        float y = gabor_impl_relative_energy(lobe.wave.y, energy);
        kernel_.variance_factor = x + y - x * y;
        kernel_.amplitude *= rsqrt(kernel_.variance_factor);
    }
    return kernel_;
}

// A wave vector within a lobe's spread, as that is written.
inline float2 gabor_impl_wave_within(GaborLobe lobe, float2 spread)
{
    float2 turn = float2(gabor_impl_sine(spread.y + 0.25), gabor_impl_sine(spread.y));
    return (1.0 + spread.x) * gabor_impl_product(lobe.wave, turn);
}

// The wave vector of the impulse that has this word.
inline float2 gabor_impl_wave(GaborKernel kernel_, uint word)
{
    GaborLobe lobe = kernel_.lobes.lobe[0];
    uint choice = gabor_impl_mix(word, GABOR_IMPL_CELL_STRIDE);
    if (kernel_.lobes.count > 1) {
        float chosen = kernel_.lobes.lobe[GABOR_LOBES - 1].power * ((float(choice >> 16u) + 0.5) / 65536.0);
        GABOR_UNROLL for (int i = 1; i < GABOR_LOBES; ++i) {
            if (i < kernel_.lobes.count && chosen >= kernel_.lobes.lobe[i - 1].power)
                lobe = kernel_.lobes.lobe[i];
        }
    }
    if (lobe.spread.x == 0.0 && lobe.spread.y == 0.0)
        return lobe.wave;
    float2 drawn = float2(float(choice * GABOR_IMPL_CELL_STRIDE >> 16u), float(choice & 0xffffu));
    return gabor_impl_wave_within(lobe, lobe.spread * ((drawn + 0.5) / 32768.0 - 1.0));
}

// The window q along one axis, 0 from |x| = 1 on.
inline float gabor_impl_window(float x)
{
    float3 c = GABOR_WINDOW;
    float u = max(1.0 - x * x, 0.0);
    return u * u * (c.x + u * (c.y + u * c.z));
}

// Its derivative.
inline float gabor_impl_window_slope(float x)
{
    float3 c = GABOR_WINDOW;
    float u = max(1.0 - x * x, 0.0);
    return -2.0 * x * u * (2.0 * c.x + u * (3.0 * c.y + u * (4.0 * c.z)));
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    int2 cell;   // any integers, but for the last few before the world wraps around at 2^31
    float2 local;   // offset from that cell's corner, in cells: any small vector, [0, 1)^2 is the most precise
    float2 radius;  // cells per kernel radius along each axis: GABOR_RADIUS, or between half of it and it to fit a period
    int2 period; // in cells, 0 for none
    float time;   // in periods of time: only its fraction counts
};

// (cell + local) / GABOR_RADIUS kernel radii, without periods, at time 0: full precision everywhere in a world of 2^32
// cells each way, where it wraps around.
inline GaborPlace gabor_place(int2 cell, float2 local)
{
    return GaborPlace{cell, local, float2(GABOR_RADIUS), int2(0), 0.0};
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part is the same with cosines
// for sines, and its gradient. Parts that are not used cost nothing: compilers leave them out.
struct GaborField {
    float2 value;   // real, imaginary: each of mean 0 and variance 1
    float2 slope_x; // their derivatives along x, per kernel radius
    float2 slope_y; // along y
    float4 four;    // four noises of the same spectrum, uncorrelated with each other wherever they are compared
};

// A cell's coordinate within a period.
inline int gabor_impl_wrap(int cell, int period)
{
    if (period == 0)
        return cell;
    int within = cell - cell / period * period;
    return within < 0 ? within + period : within;
}

// The gain that keeps the variance of sine kernels at 1 while time turns their phases: J(a.x) J(a.y) in gabor_kernel is
// multiplied by 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the phase rates k.
inline float gabor_impl_phase_gain(GaborKernel kernel_, float time)
{
    if (kernel_.phases != 2.0 || time == 0.0)
        return 1.0;
    float4 sines = float4(gabor_impl_sine(time), gabor_impl_sine(2.0 * time), gabor_impl_sine(3.0 * time),
                      gabor_impl_sine(4.0 * time));
    float u = 0.5 * dot(sines, sines);
    return rsqrt(1.0 + u * (1.0 - kernel_.variance_factor) / kernel_.variance_factor);
}

// The factor of the sum of kernels: with fewer cells per radius there are fewer impulses.
inline float gabor_impl_scale(GaborKernel kernel_, GaborPlace place)
{
    return kernel_.amplitude * GABOR_RADIUS * rsqrt(place.radius.x * place.radius.y)
         * gabor_impl_phase_gain(kernel_, fract(place.time));
}

// The noise at a place, by its cell: what most functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
inline GaborField gabor_field(GaborPlace place, GaborKernel kernel_, uint seed)
{
    int visited = int(ceil(2.0 * GABOR_RADIUS)) + 1;
    float2 cell_base = floor(place.local);
    float2 local = place.local - cell_base;
    float2 first = floor(local - place.radius);
    int2 cell = place.cell + int2(cell_base + first);
    first -= 1.0; // what gabor_impl_position_plus_one adds
    float2 cell_side = 1.0 / place.radius;
    float time = fract(place.time);

    uint seed_word = gabor_impl_seed_word(seed);
    GaborField sum = GaborField{float2(0.0), float2(0.0), float2(0.0), float4(0.0)};
    GABOR_UNROLL for (int j = 0; j < visited; ++j) {
        uint row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        GABOR_UNROLL for (int i = 0; i < visited; ++i) {
            int column = gabor_impl_wrap(cell.x + i, place.period.x);
            GABOR_UNROLL for (int k = 0; k < GABOR_IMPULSES; ++k) {
                uint word = gabor_impl_impulse_word(column, row_word, k);
                float2 impulse = gabor_impl_position_plus_one(word);
                // The sum in the inner brackets is exact, which leaves one rounding.
                float2 d = (local - (impulse + (first + float2(float(i), float(j))))) * cell_side;
                // About half of the impulses reach here. GPUs skip what no pixel of a wave needs, and compilers for
                // CPUs keep their registers in order, which without the branch they do not: lavapipe takes 2.5 x as
                // long.
                if (max(abs(d.x), abs(d.y)) < 1.0) {
                    float2 cycles = gabor_impl_wave(kernel_, word);
                    float turns = dot(cycles, d) + gabor_impl_phase(impulse, kernel_.phases)
                                + gabor_impl_phase_rate(word) * time;
                    float magnitude = gabor_impl_magnitude(word);
                    float2 window = float2(gabor_impl_window(d.x), gabor_impl_window(d.y));
                    float2 wave = magnitude * float2(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns));
                    // The derivative of e^(2 pi i F x) is 2 pi i F times it.
                    float2 turned = (6.2831853 * window.x * window.y) * float2(-wave.y, wave.x);
                    sum.value += (window.x * window.y) * wave;
                    sum.slope_x += (gabor_impl_window_slope(d.x) * window.y) * wave + cycles.x * turned;
                    sum.slope_y += (gabor_impl_window_slope(d.y) * window.x) * wave + cycles.y * turned;
                    sum.four += (window.x * window.y) * gabor_impl_four(wave, word);
                }
            }
        }
    }
    float scale = gabor_impl_scale(kernel_, place);
    return GaborField{scale * sum.value, scale * sum.slope_x, scale * sum.slope_y, scale * sum.four};
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// A pixel's filter is a normal density of covariance S. To take it along, the window is written as a normal density of
// variance s^2 = 0.121 times an even polynomial, q(x) = e^(-x^2 / (2 s^2)) P(x / s). By completing the square, with
// omega = 2 pi F, C = s^2 + S, z = d + i S omega, and v drawn from the normal law of covariance V = 1 - s^2 / C,
//     (q q e^(i omega d)) * filter = s^2 |C|^(-1/2) e^(i omega d - omega S omega / 2 - z C^-1 z / 2) E[P(m.x) P(m.y)]
//     m = s C^-1 z + v:
// again a window around a wave, but wider, weaker, and the wave slower.
#define GABOR_IMPL_NORMAL_VARIANCE 0.121104
#define GABOR_IMPL_NORMAL_DEVIATION 0.348

// Even polynomial p0 + p1 x^2 + ... + p5 x^10.
struct GaborPolynomial {
    float3 low;
    float3 high;
};

// P, by least squares: within 1.8 % of the default window in the root mean square, and closer to smoother ones.
inline GaborPolynomial gabor_impl_normal_window()
{
    float3 c = GABOR_WINDOW;
    GaborPolynomial p;
    p.low = c.x * float3(1.00289538, 0.22776577, 0.05744543) + c.y * float3(1.00145225, 0.11853905, 0.01796500)
          + c.z * float3(0.99978500, 0.01664752, -0.02767342);
    p.high = c.x * float3(-0.01466960, -0.00010419, 0.00005601) + c.y * float3(-0.01980551, 0.00225161, -0.00006904)
           + c.z * float3(-0.00584684, 0.00131062, -0.00005534);
    return p;
}

// E[P(x + v)] as a polynomial of x, for v normal of this variance.
inline GaborPolynomial gabor_impl_averaged(GaborPolynomial p, float variance)
{
    float3 v = variance * float3(1.0, variance, variance * variance);
    float2 w = v.y * v.yz;
    GaborPolynomial mean;
    mean.low.x = p.low.x + dot(v, float3(p.low.y, 3.0 * p.low.z, 15.0 * p.high.x))
               + dot(w, float2(105.0 * p.high.y, 945.0 * p.high.z));
    mean.low.y = p.low.y + dot(v, float3(6.0 * p.low.z, 45.0 * p.high.x, 420.0 * p.high.y)) + w.x * 4725.0 * p.high.z;
    mean.low.z = p.low.z + dot(v, float3(15.0 * p.high.x, 210.0 * p.high.y, 3150.0 * p.high.z));
    mean.high.x = p.high.x + dot(v.xy, float2(28.0 * p.high.y, 630.0 * p.high.z));
    mean.high.y = p.high.y + 45.0 * variance * p.high.z;
    mean.high.z = p.high.z;
    return mean;
}

// A polynomial of a complex number.
inline float2 gabor_impl_polynomial(GaborPolynomial p, float2 z)
{
    float2 square = gabor_impl_product(z, z);
    float2 sum = p.high.z * square + float2(p.high.y, 0.0);
    sum = gabor_impl_product(sum, square) + float2(p.high.x, 0.0);
    sum = gabor_impl_product(sum, square) + float2(p.low.z, 0.0);
    sum = gabor_impl_product(sum, square) + float2(p.low.y, 0.0);
    return gabor_impl_product(sum, square) + float2(p.low.x, 0.0);
}

// Symmetric matrices are (xx, yy, xy).
inline float2 gabor_impl_symmetric(float3 matrix_, float2 v)
{
    return matrix_.xy * v + matrix_.z * v.yx;
}

inline float3 gabor_impl_inverse(float3 matrix_)
{
    return float3(matrix_.yx, -matrix_.z) / (matrix_.x * matrix_.y - matrix_.z * matrix_.z);
}

// What a pixel covers, and what windows become under it. Lengths are in kernel radii.
struct GaborFootprint {
    float3 covariance;   // of the filter
    float3 widening;     // S: the same, but at most 1/4 in every direction
    float3 inverse;      // of C
    float amplitude;   // s^2 |C|^(-1/2)
    float2 reach;        // where windows end along each axis
    float2 joint;        // deviations of the part of v that both axes share
    GaborPolynomial x; // E[P(m.x)] over the rest of v
    GaborPolynomial y;
};

// The footprint of a pixel, seen through a normal filter whose standard deviation is half a pixel.
//   dx, dy   steps from the pixel's place to its neighbours', dFdx(p) and dFdy(p), in kernel radii. Where they are NaN
//            or infinite or longer than 10^3, 10^3 is taken.
inline GaborFootprint gabor_footprint(float2 dx, float2 dy)
{
    float3 unit = float3(1.0, 1.0, 0.0);
    float3 covariance = 0.25 * (float3(dx * dx, dx.x * dx.y) + float3(dy * dy, dy.x * dy.y));
    if (!(covariance.x + covariance.y < 2.5e5)) {
        dx = float2(1.0e3, 0.0);
        dy = float2(0.0, 1.0e3);
        covariance = 2.5e5 * unit;
    }
    GaborFootprint footprint;
    footprint.covariance = covariance;

    // The eigenvalues are mean +- difference, the smaller one precisely the determinant over the larger one.
    float mean = 0.5 * (covariance.x + covariance.y);
    float difference = length(float2(0.5 * (covariance.x - covariance.y), covariance.z));
    float larger = mean + difference;
    float side = 0.25 * (dx.x * dy.y - dx.y * dy.x);
    float smaller = larger > 1.0e-12 ? min(side / larger * side, mean) : 0.0;
    float2 kept = min(float2(larger, smaller), float2(0.25));
    float3 direction = difference > 0.0 ? (covariance - mean * unit) / difference : float3(0.0);
    footprint.widening = 0.5 * ((kept.x + kept.y) * unit + (kept.x - kept.y) * direction);
    footprint.widening.xy = max(footprint.widening.xy, float2(0.0));

    footprint.inverse = gabor_impl_inverse(GABOR_IMPL_NORMAL_VARIANCE * unit + footprint.widening);
    footprint.amplitude = GABOR_IMPL_NORMAL_VARIANCE
                        * sqrt(footprint.inverse.x * footprint.inverse.y - footprint.inverse.z * footprint.inverse.z);
    footprint.reach = 1.045 + 1.5 * sqrt(footprint.widening.xy);
    float3 v = unit - GABOR_IMPL_NORMAL_VARIANCE * footprint.inverse;
    float2 variance = max(v.xy, float2(0.0));
    float product = variance.x * variance.y;
    float correlation = product > 0.0 ? min(abs(v.z) * rsqrt(product), 1.0) : 0.0;
    footprint.joint = sqrt(correlation * variance) * float2(1.0, v.z < 0.0 ? -1.0 : 1.0);
    float2 rest = (1.0 - correlation) * variance;
    footprint.x = gabor_impl_averaged(gabor_impl_normal_window(), rest.x);
    footprint.y = gabor_impl_averaged(gabor_impl_normal_window(), rest.y);
    return footprint;
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe taken as normal, of
// the variance B = integral(q'^2) / (4 pi^2 integral(q^2)) along each axis,
//     |1 + 8 pi^2 B S|^(-1/2) e^(-4 pi^2 F S (1 + 8 pi^2 B S)^-1 F).
inline float gabor_impl_transmitted(float2 wave, float3 covariance)
{
    float3 c = GABOR_WINDOW;
    // The integral of x^2 u^n is I_n / (2n+3).
    float4 slope = float4(4.0 * c.x * c.x, 12.0 * c.x * c.y, 9.0 * c.y * c.y + 16.0 * c.x * c.z, 24.0 * c.y * c.z)
               * float4(16.0 / 105.0, 32.0 / 315.0, 256.0 / 3465.0, 512.0 / 9009.0);
    float energy = 4.0 * (dot(slope, float4(1.0)) + 16.0 * c.z * c.z * (2048.0 / 45045.0));
    float3 widened = float3(1.0, 1.0, 0.0) + (2.0 * energy / gabor_impl_energy().sum) * covariance;
    float2 slower = gabor_impl_symmetric(gabor_impl_inverse(widened), wave);
    float taken = 39.478418 * dot(wave, gabor_impl_symmetric(covariance, slower));
    return exp(-min(taken, 80.0)) * rsqrt(widened.x * widened.y - widened.z * widened.z);
}

// The share of its variance that all of a kernel's noise loses under the footprint: in [0, 1].
inline float gabor_removed(GaborKernel kernel_, GaborFootprint footprint)
{
    float kept = 0.0;
    float before = 0.0;
    for (int i = 0; i < GABOR_LOBES; ++i) {
        if (i >= kernel_.lobes.count)
            break;
        GaborLobe lobe = kernel_.lobes.lobe[i];
        float mean = 0.0;
        if (lobe.spread.x == 0.0 && lobe.spread.y == 0.0) {
            mean = gabor_impl_transmitted(lobe.wave, footprint.covariance);
        } else {
            for (int j = 0; j < 72; ++j) {
                float2 within = lobe.spread * (float2(float(j % 3), float(j / 3)) * float2(2.0 / 3.0, 1.0 / 12.0)
                                             - float2(2.0 / 3.0, 23.0 / 24.0));
                mean += gabor_impl_transmitted(gabor_impl_wave_within(lobe, within), footprint.covariance) / 72.0;
            }
        }
        kept += (lobe.power - before) * mean;
        before = lobe.power;
    }
    return before > 0.0 ? clamp(1.0 - kept / before, 0.0, 1.0) : 0.0;
}

// A kernel of amplitude 1 under a footprint, as (real, imaginary): at a distance d from an impulse of this phase.
inline float2 gabor_impl_kernel_filtered(float2 d, float2 wave, float phase, GaborFootprint footprint)
{
    float2 shift = gabor_impl_symmetric(footprint.widening, 6.2831853 * wave);
    float2 real = gabor_impl_symmetric(footprint.inverse, d);
    float2 imaginary = gabor_impl_symmetric(footprint.inverse, shift);
    float exponent = 0.5 * (dot(shift, imaginary) - dot(6.2831853 * wave, shift) - dot(d, real));
    real *= GABOR_IMPL_NORMAL_DEVIATION;
    imaginary *= GABOR_IMPL_NORMAL_DEVIATION;
    if (exponent < -20.0 || dot(imaginary, imaginary) > 40.0) // the second follows from the first, but for rounding
        return float2(0.0);

    // The part of v that the axes share, by Gauss and Hermite's rule of five points.
    float2 window = float2(0.0);
    for (int i = -2; i <= 2; ++i) {
        float point_ = i == 0 ? 0.0 : float(i) * (abs(i) == 1 ? 1.3556262 : 1.4284850);
        float weight = i == 0 ? 0.53333333 : abs(i) == 1 ? 0.22207592 : 0.01125741;
        float2 v = point_ * footprint.joint;
        window += weight * gabor_impl_product(gabor_impl_polynomial(footprint.x, float2(real.x + v.x, imaginary.x)),
                                       gabor_impl_polynomial(footprint.y, float2(real.y + v.y, imaginary.y)));
    }

    float amplitude = footprint.amplitude * exp(exponent);
    if (footprint.widening.x + footprint.widening.y < footprint.covariance.x + footprint.covariance.y)
        amplitude *= sqrt(gabor_impl_transmitted(wave, footprint.covariance)
                          / gabor_impl_transmitted(wave, footprint.widening));
    float turns = dot(wave, d) - dot(shift, real) / (6.2831853 * GABOR_IMPL_NORMAL_DEVIATION) + phase;
    return amplitude * gabor_impl_product(window, float2(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns)));
}

// The noise at a place as a pixel sees it, (real, imaginary), as in gabor_field. Each part is within 2 % of a standard
// deviation, in the root mean square, of the noise seen through the filter, for footprints of up to a kernel radius; in
// larger ones it fades as it should, but is no smoother. Its variance is 1 - gabor_removed, within 1 %: for two phases
// from frequency 1.5 up.
// Cost: (2 reach R + 1)^2 N impulses on average, reach from 1 to 1.8, each about four times that of gabor_field.
inline float2 gabor_field_filtered(GaborPlace place, GaborKernel kernel_, GaborFootprint footprint, uint seed)
{
    float2 cell_base = floor(place.local);
    float2 local = place.local - cell_base;
    int2 first = int2(floor(local - place.radius * footprint.reach));
    int2 last = int2(floor(local + place.radius * footprint.reach));
    int2 cell = place.cell + int2(cell_base);
    float time = fract(place.time);
    uint seed_word = gabor_impl_seed_word(seed);
    float2 sum = float2(0.0);
    for (int j = first.y; j <= last.y; ++j) {
        uint row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        for (int i = first.x; i <= last.x; ++i) {
            int column = gabor_impl_wrap(cell.x + i, place.period.x);
            for (int k = 0; k < GABOR_IMPULSES; ++k) {
                uint word = gabor_impl_impulse_word(column, row_word, k);
                float2 impulse = gabor_impl_position_plus_one(word);
                float2 d = (local - (impulse + (float2(float(i), float(j)) - 1.0))) / place.radius;
                if (all((abs(d) < footprint.reach))) {
                    float phase = gabor_impl_phase(impulse, kernel_.phases) + gabor_impl_phase_rate(word) * time;
                    sum += gabor_impl_magnitude(word)
                         * gabor_impl_kernel_filtered(d, gabor_impl_wave(kernel_, word), phase, footprint);
                }
            }
        }
    }
    return gabor_impl_scale(kernel_, place) * sum;
}

// ---- The simple calls ----------------------------------------------------------------------------------------------

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
inline float gabor_noise_at(int2 cell, float2 local, GaborKernel kernel_, uint seed)
{
    return gabor_field(gabor_place(cell, local), kernel_, seed).value.y;
}

// Gabor noise at p: as gabor_noise_at, in one call.
//   p            position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float
//                steps by 0.008.
//   frequency    cycles per kernel radius; its magnitude is used, within [10^-6, 10^6]. From about 1 up the noise is a
//                distinct lobe; above 64 the places of impulses are too coarse for the exact variance.
//   orientation  direction of the wave vector in radians from +x towards +y, precise within +-400.
//   seed         any; each seed is another instance, independent of the others
// Frequency and orientation may vary from place to place: where they are continuous so is the noise, for each wave
// turns about its own impulse. A slope of theirs adds to that of the noise.
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
// have mean 0 and variance 1, and at one place are independent; with GABOR_PHASES 2 the real part's variance is 1 only
// from frequency 1.5 up.
inline float2 gabor_noise_complex(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).value;
}

// Four noises at p from one traversal, for colours and for displacement along vectors: each as gabor_noise,
// uncorrelated with each other. With GABOR_PHASES 2 their variance is 1 only from frequency 1.5 up.
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

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation.
// Mean and variance are those of gabor_noise. So is the rest of the law where period * R is whole; else cells grow to
// fit, and values become less normal: for `one` cvm 1.1 with 5 % fewer cells per radius, 6.4 with 10 %, 14 to 425 for
// square periods of 2.3 to 4.9. A period below 2, a kernel's diameter, is taken as 2.
inline float gabor_noise_tiled(float2 p, float2 period, float frequency, float orientation, uint seed)
{
    period = max(period, float2(2.0));
    float2 cells = floor(period * GABOR_RADIUS);
    float2 radius = cells / period;
    float2 within = p - floor(p / period) * period;
    GaborPlace place = GaborPlace{int2(0), within * radius, radius, int2(cells), 0.0};
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance. Its correlation with itself is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at
// a lag of 0.03, 0 at 0.1, -0.38 at 0.16.
inline float gabor_noise_animated(float2 p, float time, float frequency, float orientation, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    place.time = time;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` of the frequency, both evenly spread. pi/2 radians are every direction: isotropic noise. As
// gabor_noise, with the ranges of gabor_lobe.
inline float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         uint seed)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, frequency_spread, orientation_spread, 1.0);
    return gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel_lobe(lobe), seed).value.y;
}

// Noise of a spectrum of several lobes at p, as many impulses as for one: see gabor_kernel_lobes.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 0.0, 0.1, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.3, 0.0, 1.0);
//     lobes.count = 2;
inline float gabor_noise_lobes(float2 p, GaborLobes lobes, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * GABOR_RADIUS), gabor_kernel_lobes(lobes), seed).value.y;
}

// The same spectrum as a sum of independent noises, one for each lobe [TNVT19, figure 6]: at the cost of each. Every
// place has waves of every lobe, which looks smoother where lobes differ much.
inline float gabor_noise_sum(float2 p, GaborLobes lobes, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * GABOR_RADIUS);
    float power = 0.0;
    float sum = 0.0;
    for (int i = 0; i < GABOR_LOBES; ++i) {
        if (i >= lobes.count)
            break;
        uint own_seed = gabor_lobe_seed(seed, i);
        sum += sqrt(lobes.lobe[i].power) * gabor_field(place, gabor_kernel_lobe(lobes.lobe[i]), own_seed).value.y;
        power += lobes.lobe[i].power;
    }
    return power > 0.0 ? sum * rsqrt(power) : 0.0;
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this took away: what a material lost in roughness, or a picture in contrast. For small
// steps it is gabor_noise, within 2 %. See gabor_footprint and gabor_field_filtered.
inline float2 gabor_noise_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed)
{
    GaborKernel kernel_ = gabor_kernel(frequency, orientation);
    GaborFootprint footprint = gabor_footprint(dx, dy);
    float2 value = gabor_field_filtered(gabor_place(int2(0), p * GABOR_RADIUS), kernel_, footprint, seed);
    return float2(value.y, gabor_removed(kernel_, footprint));
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
inline float gabor_unorm(float noise)
{
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

#endif // GABOR_NOISE_METAL
