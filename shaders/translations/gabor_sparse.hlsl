// Generated from gabor_sparse.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
//
// gabor_sparse.hlsl: the sparse Gabor noise of Tavernier et al. (2019) in the plane, with mean 0 and variance 1 at
// every point.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//     float v = gabor_unorm(n);                    // in [0, 1], for display
//
// Use this file for the paper's own noise. The noise of gabor_noise.hlsl, which has the same functions, is faster and
// is normal at every point. Positions are in kernel radii: a kernel ends one radius from its impulse. Frequencies are
// in cycles per kernel radius.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifdef GABOR_NOISE_HLSL
#error Include gabor_sparse.hlsl or gabor_noise.hlsl, not both: they define the same functions
#endif
#ifndef GABOR_SPARSE_HLSL
#define GABOR_SPARSE_HLSL 1

// 10000 major + 100 minor + patch
#define GABOR_NOISE_VERSION 30000

// ---- Macros: define them before the file. The defaults are the recipe `one`; docs/recipes.md lists others ----------

// N, the number of impulses per cell: an int, at least 1.
#ifndef GABOR_IMPULSES
#define GABOR_IMPULSES 1
#endif
// R, cells per kernel radius: a float, at least 1. Loops visit ceil(2 R) + 1 cells per axis.
#ifndef GABOR_CELLS_PER_RADIUS
#define GABOR_CELLS_PER_RADIUS 1.0
#endif
// A, a float in [0, 1]: weights have magnitude A or 1, with equal probability.
#ifndef GABOR_WEIGHT_FLOOR
#define GABOR_WEIGHT_FLOOR 0.675
#endif
// Number of phases, evenly spaced over a turn: a power of two up to 256. 2 gives sine kernels, which integrate to 0.
#ifndef GABOR_PHASES
#define GABOR_PHASES 256
#endif
// c of the window q(x) = u^2 (c.x + c.y u + c.z u^2), u = 1 - x^2.
#ifndef GABOR_WINDOW
#define GABOR_WINDOW float3(3.0, -4.5, 2.5)
#endif

// Define GABOR_UNCHECKED as 1 if the macros are constants that #if cannot evaluate.
#ifndef GABOR_UNCHECKED
#if GABOR_IMPULSES < 1
#error GABOR_IMPULSES must be an int, at least 1
#endif
#if GABOR_PHASES < 2 || GABOR_PHASES > 256 || (GABOR_PHASES & (GABOR_PHASES - 1)) != 0
#error GABOR_PHASES must be a power of two, from 2 to 256
#endif
#endif

// ---- Functions -----------------------------------------------------------------------------------------------------

// float gabor_noise(float2 p, float frequency, float orientation, uint seed)
//     Gabor noise at p, with mean 0 and variance 1 at every point, and continuous first derivatives. Values pooled over
//     all points are nearly normal; those at a fixed position in the cells are less so: see docs/recipes.md.
//       p            position in kernel radii, |p| < 2^31 / GABOR_CELLS_PER_RADIUS. Float rounding shows earlier: at
//       10^5, p has
//                    steps of 0.008
//       frequency    cycles per kernel radius, 10^-6 to 10^6; the sign is ignored. Above 64, positions of impulses are
//                    too coarse for the exact variance
//       orientation  direction of the wave vector in radians from +x towards +y, precise from -400 to 400
//       seed         any; different seeds give independent noises
//     Frequency and orientation may vary with p; where they are continuous, so is the noise. NaN gives an unspecified
//     value. Cost: (ceil(2 GABOR_CELLS_PER_RADIUS) + 1)^2 GABOR_IMPULSES impulses, 9 by default.

// float3 gabor_noise_gradient(float2 p, float frequency, float orientation, uint seed)
//     (noise, d/dx, d/dy), per kernel radius, for constant frequency and orientation.

// float2 gabor_noise_quadrature(float2 p, float frequency, float orientation, uint seed)
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are uncorrelated and have variance 1; with
//     GABOR_PHASES 2, the quadrature has variance 1 only at frequencies of 1.5 or more.

// float2 gabor_turns_intensity(float2 noise_quadrature)
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., Procedural phasor noise, 2019].

// float gabor_noise_tiled(float2 p, float2 period, float frequency, float orientation, uint seed)
//     Noise that repeats exactly after `period` kernel radii along x and y, at any frequency and orientation, with the
//     mean and variance of gabor_noise. If period * GABOR_CELLS_PER_RADIUS is an integer, the distribution is also the
//     same. Otherwise cells grow to fit, and values become less normal: with the recipe `one`, cvm (see
//     docs/recipes.md) is 1.1 for 5 % fewer cells per radius, 6.4 for 10 %, and 14 to 425 for square periods of 2.3 to
//     4.9. A period below 2, the diameter of a kernel, counts as 2.

// float gabor_noise_animated(float2 p, float evolution, float frequency, float orientation, uint seed)
//     Noise that evolves in place and repeats when `evolution` grows by 1. It always has the statistics of gabor_noise.
//     Its autocorrelation is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at a lag of 0.03, 0 at 0.1, -0.38 at
//     0.16. At 3.5 % of all points, the noise hardly changes.

// float gabor_unorm(float noise)
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// ---- For large worlds, and for periods that evolve -----------------------------------------------------------------

// A wave and its normalization, returned by gabor_kernel.
struct GaborKernel {
    float2 wave;             // wave vector, cycles per kernel radius
    float amplitude;       // K
    float variance_factor; // variance for K = 1, relative to that at high frequencies: 1 unless there are two phases
};

GaborKernel GaborKernel_of(float2 wave, float amplitude, float variance_factor) {
    GaborKernel made = {wave, amplitude, variance_factor};
    return made;
}

// A position in cells, with a period and an evolution.
struct GaborPlace {
    int2 cell;   // any integers except the last few before 2^31, where the world wraps around
    float2 local;   // offset from that cell's corner in cells, most precise in [0, 1)^2
    float2 cells_per_radius; // along each axis: GABOR_CELLS_PER_RADIUS, or as little as half of it to fit a period
    int2 period; // period in cells, 0 for none
    float evolution; // as in gabor_noise_animated, in turns: only its fraction counts
};

GaborPlace GaborPlace_of(int2 cell, float2 local, float2 cells_per_radius, int2 period, float evolution) {
    GaborPlace made = {cell, local, cells_per_radius, period, evolution};
    return made;
}

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    float noise;
    float2 gradient;
    float quadrature;
    float2 quadrature_gradient;
};

GaborField GaborField_of(float noise, float2 gradient, float quadrature, float2 quadrature_gradient) {
    GaborField made = {noise, gradient, quadrature, quadrature_gradient};
    return made;
}

// GaborKernel gabor_kernel(float frequency, float orientation)
//     The kernel with a given frequency and orientation; ranges are those of gabor_noise. Compute it once for many
//     calls.

// GaborPlace gabor_place(int2 cell, float2 local)
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// GaborField gabor_field(GaborPlace place, GaborKernel kernel, uint seed)
//     The noise, its quadrature, and their gradients at `place`. All noise functions call it.

// float gabor_noise_at(int2 cell, float2 local, GaborKernel kernel, uint seed)
//     The noise at gabor_place(cell, local).

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// The noise is a sum of Gabor kernels, windowed waves, around random impulses x_i (sparse convolution):
//
//     n(p) = K sum_i w_i g_i(p - x_i),     g_i(d) = q(d.x) q(d.y) sin(2 pi (F d.omega + phase_i)),
//
// with a fixed number of impulses in each cell of a grid, and weights that vary little. The unit of length is the
// kernel radius, where q and its slope are 0. K makes the variance exactly 1 at every frequency and every point. Each
// wave's phase starts at its own impulse, so frequency and orientation may vary with the position.
//
// After Tavernier, Neyret, Vergne, Thollot: Making Gabor Noise Fast and Normalized, Eurographics 2019.

float gabor_impl_needs_int_float_float_int_vec3_macros(int n, float r, float a, int phases, float3 window) {
    return float(n + phases) + r + a + window.x;
}
float gabor_impl_check_macros() { // a macro of the wrong type fails to compile here
    return gabor_impl_needs_int_float_float_int_vec3_macros(GABOR_IMPULSES, GABOR_CELLS_PER_RADIUS, GABOR_WEIGHT_FLOOR,
                                                            GABOR_PHASES, GABOR_WINDOW);
}

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Odd, and spreads consecutive cells over all 32 bits.
#define GABOR_IMPL_CELL_STRIDE 0x9e3779b1u

// Mixes a word in two rounds of shift and multiply, with constants from the hash-prospector project. The salt enters
// between the rounds, so that no salt's sequence is a shifted copy of another's.
uint gabor_impl_mix(uint word, uint salt) {
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The word of a seed determines the words of the rows of cells, which determine the words of the impulses.
uint gabor_impl_seed_word(uint seed) {
    return gabor_impl_mix(seed * GABOR_IMPL_CELL_STRIDE, 0x2545f491u);
}

uint gabor_impl_row_word(int row, uint seed_word) {
    return gabor_impl_mix(uint(row) * GABOR_IMPL_CELL_STRIDE + seed_word, seed_word);
}

// The word of impulse `index` in a cell. Its bits hold y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading bits of y and trailing bits of
// x: only offsets in x below 1/256 of a cell depend on y.
uint gabor_impl_impulse_word(int column, uint row_word, int index) {
    uint salt = row_word + uint(index) * 0x85ebca6bu;
    return gabor_impl_mix(uint(column) * GABOR_IMPL_CELL_STRIDE + salt, salt);
}

// The parts of an impulse's word. Positions are offset by 1, to [1, 2)^2, which avoids a conversion from integers.
struct GaborImplImpulse {
    float2 position_plus_one;
    float phase;      // phase in turns
    float phase_rate; // turns per turn of the evolution: -4 to -1 or 1 to 4
    float magnitude;  // magnitude of the weight
};

GaborImplImpulse GaborImplImpulse_of(float2 position_plus_one, float phase, float phase_rate, float magnitude) {
    GaborImplImpulse made = {position_plus_one, phase, phase_rate, magnitude};
    return made;
}

GaborImplImpulse gabor_impl_impulse(uint word) {
    float2 position_plus_one = float2(asfloat(0x3f800000u | ((word >> 8u) & 0x7fffffu)),
                                  asfloat(0x3f800000u | (word & 0x7fffffu)));
    float rate = float((word >> 8u) & 7u) - 4.0;
    return GaborImplImpulse_of(position_plus_one, frac(position_plus_one.y * (8388608.0 / float(GABOR_PHASES))),
                            rate < 0.0 ? rate : rate + 1.0, int(word) < 0 ? 1.0 : GABOR_WEIGHT_FLOOR);
}

// sin(2 pi t), as t (1/4 - t^2) times a minimax polynomial in t^2. The error is at most 3e-7 in [-1, 1]; beyond that,
// the rounding of t adds to it.
float gabor_impl_sine(float t) {
    t = frac(t) - 0.5;
    float s = t * t;
    // fit: see tools/constants.py
    float p = 12.233303 * s - 38.123196;
    p = p * s + 67.0439;
    p = p * s - 64.83468;
    p = p * s + 25.13273;
    return t * (s - 0.25) * p;
}

// The unit vector at an angle in radians, within 1e-7. Multiples of pi/2 are subtracted in three steps, for precision;
// minimax polynomials give the sine and cosine of the rest.
float2 gabor_impl_direction(float angle) {
    float quarter = floor(angle * 0.63661977 + 0.5); // 2/pi
    float r = angle - quarter * 1.5703125; // 201/128
    r -= quarter * 4.837512969970703e-4; // 4058/2^23
    r -= quarter * 7.549789948768648e-8; // pi/2 - 201/128 - 4058/2^23
    r = abs(r) < 1.0 ? r : 0.0; // far outside the range, no digits are left and the direction is arbitrary
    float s = r * r;
    // fits: see tools/constants.py
    float sine = r + r * s * (-0.16666654 + s * (8.3321608e-3 - s * 1.9515295e-4));
    float cosine = 1.0 - 0.5 * s + s * s * (4.1666645e-2 + s * (-1.3887316e-3 + s * 2.4433157e-5));
    float2 axis = frac(0.5 * quarter) < 0.25 ? float2(cosine, sine) : float2(-sine, cosine);
    return frac(0.25 * quarter) < 0.375 ? axis : -axis;
}

// ---- Normalization -------------------------------------------------------------------------------------------------
// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). GaborImplEnergy holds the five c_n I_n and their sum, the
// integral of q^2.
struct GaborImplEnergy {
    float4 e4567;
    float e8;
    float sum;
};

GaborImplEnergy GaborImplEnergy_of(float4 e4567, float e8, float sum) {
    GaborImplEnergy made = {e4567, e8, sum};
    return made;
}

GaborImplEnergy gabor_impl_energy() {
    float3 c = GABOR_WINDOW;
    float4 e4567 = float4(256.0 / 315.0, 512.0 / 693.0, 2048.0 / 3003.0, 4096.0 / 6435.0)
               * float4(c.x * c.x, 2.0 * c.x * c.y, c.y * c.y + 2.0 * c.x * c.z, 2.0 * c.y * c.z);
    float e8 = c.z * c.z * (65536.0 / 109395.0);
    return GaborImplEnergy_of(e4567, e8, dot(e4567, (float4)(1.0)) + e8);
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel with k cycles per radius, relative to the energy at high frequency. For small a, it is computed from
// 1 - L_n, by the power series of L_7 and L_8 and downward recurrence; for large a, by upward recurrence from
// L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
float gabor_impl_relative_energy(float k, GaborImplEnergy energy) {
    float a = 12.566371 * k;
    float z = a * a;
    float4 d4567;
    float2 d78 = (float2)(0.0);
    if (z < 64.0) {
        float2 term = (float2)(1.0);
        for (int i = 1; i <= 14; ++i) {
            term *= -0.25 * z / (float(i) * (float(i) + float2(7.5, 8.5)));
            d78 -= term;
        }
        float d6 = d78.x + z * (1.0 - d78.y) * (1.0 / 255.0);
        float d5 = d6 + z * (1.0 - d78.x) * (1.0 / 195.0);
        d4567 = float4(d5 + z * (1.0 - d6) * (1.0 / 143.0), d5, d6, d78.x);
    } else {
        float y = 1.0 / z;
        float l0 = gabor_impl_sine(2.0 * k) / a;
        float l1 = 3.0 * y * (l0 - gabor_impl_sine(2.0 * k + 0.25));
        float l2 = 15.0 * y * (l1 - l0);
        float l3 = 35.0 * y * (l2 - l1);
        float4 l;
        l.x = 63.0 * y * (l3 - l2);
        l.y = 99.0 * y * (l.x - l3);
        l.z = 143.0 * y * (l.y - l.x);
        l.w = 195.0 * y * (l.z - l.y);
        d78.y = 1.0 - 255.0 * y * (l.w - l.z);
        d4567 = 1.0 - l;
    }
    return (dot(energy.e4567, d4567) + energy.e8 * d78.y) / energy.sum;
}

// ---- Kernels -------------------------------------------------------------------------------------------------------
// The window q along one axis, which is 0 for |x| >= 1, and its derivative.
float2 gabor_impl_window(float x) {
    float3 c = GABOR_WINDOW;
    float u = max(1.0 - x * x, 0.0);
    return float2(u * u * (c.x + u * (c.y + u * c.z)), -2.0 * x * u * (2.0 * c.x + u * (3.0 * c.y + u * (4.0 * c.z))));
}

// Wraps a cell's coordinate into a period.
int gabor_impl_wrap(int cell, int period) {
    if (period != 0) {
        cell -= cell / max(period, 1) * period; // FXC refuses a division by 0, even one that never runs
        if (cell < 0) cell += period;
    }
    return cell;
}

// The gain that keeps the variance of sine kernels at 1 while their phases turn. An evolution t multiplies J(a.x)
// J(a.y) in gabor_kernel by 1 - u, the mean of cos(4 pi k t) = 1 - 2 sin^2(2 pi k t) over the phase rates k.
float gabor_impl_phase_gain(GaborKernel kernel_, float evolution) {
    if (GABOR_PHASES != 2 || evolution == 0.0)
        return 1.0;
    float4 sines = float4(gabor_impl_sine(evolution), gabor_impl_sine(2.0 * evolution),
                      gabor_impl_sine(3.0 * evolution), gabor_impl_sine(4.0 * evolution));
    float u = 0.5 * dot(sines, sines);
    return rsqrt(1.0 + u * (1.0 - kernel_.variance_factor) / kernel_.variance_factor);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborPlace gabor_place(int2 cell, float2 local) {
    return GaborPlace_of(cell, local, (float2)(GABOR_CELLS_PER_RADIUS), (int2)(0), 0.0);
}

// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
// With two phases, sin^2 does not average to 1/2: J(0)^2 - J(a.x) J(a.y) replaces J(0)^2, with a = 4 pi F omega.
GaborKernel gabor_kernel(float frequency, float orientation) {
    float2 wave = min(abs(frequency) > 1.0e-6 ? abs(frequency) : 1.0e-6, 1.0e6) * gabor_impl_direction(orientation);
    GaborImplEnergy energy = gabor_impl_energy();
    float density = float(GABOR_IMPULSES) * GABOR_CELLS_PER_RADIUS * GABOR_CELLS_PER_RADIUS;
    float power = 0.5 + 0.5 * GABOR_WEIGHT_FLOOR * GABOR_WEIGHT_FLOOR; // E[w^2]
    float amplitude = rsqrt(0.5 * density * power * energy.sum * energy.sum);
    if (GABOR_PHASES != 2)
        return GaborKernel_of(wave, amplitude, 1.0);
    float x = gabor_impl_relative_energy(wave.x, energy);
    float y = gabor_impl_relative_energy(wave.y, energy);
    float variance_factor = x + y - x * y;
    return GaborKernel_of(wave, amplitude * rsqrt(variance_factor), variance_factor);
}

GaborField gabor_field(GaborPlace place, GaborKernel kernel_, uint seed) {
    int visited = int(ceil(2.0 * GABOR_CELLS_PER_RADIUS)) + 1;
    float2 whole = floor(place.local);
    float2 local = clamp(place.local - whole, 0.0, 1.0); // the clamp matters only if a compiler fuses this with a product
    float2 first = floor(local - place.cells_per_radius);
    int2 cell = place.cell + (int2)(whole + first);
    first -= 1.0; // undoes the 1 of position_plus_one
    float2 cell_side = 1.0 / place.cells_per_radius;
    float evolution = frac(place.evolution);
    uint seed_word = gabor_impl_seed_word(seed);
    float2 sum = (float2)(0.0), slope_x = (float2)(0.0), slope_y = (float2)(0.0); // each (quadrature, noise)
    for (int j = 0; j < visited; ++j) {
        uint row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        for (int i = 0; i < visited; ++i) {
            int column = gabor_impl_wrap(cell.x + i, place.period.x);
            for (int k = 0; k < GABOR_IMPULSES; ++k) {
                uint word = gabor_impl_impulse_word(column, row_word, k);
                GaborImplImpulse impulse = gabor_impl_impulse(word);
                // The sum in the inner brackets is exact, so only one rounding remains.
                float2 d = (local - (impulse.position_plus_one + (first + float2(float(i), float(j))))) * cell_side;
                // Only about half of the impulses reach this point. The branch also keeps CPU compilers from spilling
                // registers.
                if (max(abs(d.x), abs(d.y)) < 1.0) {
                    float turns = dot(kernel_.wave, d) + impulse.phase + impulse.phase_rate * evolution;
                    float2 x = gabor_impl_window(d.x);
                    float2 y = gabor_impl_window(d.y);
                    float2 wave = impulse.magnitude * float2(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns));
                    // The derivative of e^(2 pi i F x) is 2 pi i F e^(2 pi i F x).
                    float2 turned = (6.2831853 * x.x * y.x) * float2(-wave.y, wave.x);
                    sum += (x.x * y.x) * wave;
                    slope_x += (x.y * y.x) * wave + kernel_.wave.x * turned;
                    slope_y += (y.y * x.x) * wave + kernel_.wave.y * turned;
                }
            }
        }
    }
    // With fewer cells per radius, fewer impulses reach the point; the scale makes up for this.
    float scale = kernel_.amplitude * GABOR_CELLS_PER_RADIUS
        * rsqrt(place.cells_per_radius.x * place.cells_per_radius.y)
                * gabor_impl_phase_gain(kernel_, evolution);
    return GaborField_of(scale * sum.y, scale * float2(slope_x.y, slope_y.y), scale * sum.x,
                      scale * float2(slope_x.x, slope_y.x));
}

float gabor_noise_at(int2 cell, float2 local, GaborKernel kernel_, uint seed) {
    return gabor_field(gabor_place(cell, local), kernel_, seed).noise;
}

float gabor_noise(float2 p, float frequency, float orientation, uint seed) {
    return gabor_noise_at((int2)(0), p * GABOR_CELLS_PER_RADIUS, gabor_kernel(frequency, orientation), seed);
}

float3 gabor_noise_gradient(float2 p, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field(gabor_place((int2)(0), p * GABOR_CELLS_PER_RADIUS),
                                   gabor_kernel(frequency, orientation), seed);
    return float3(field.noise, field.gradient);
}

float2 gabor_noise_quadrature(float2 p, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field(gabor_place((int2)(0), p * GABOR_CELLS_PER_RADIUS),
                                   gabor_kernel(frequency, orientation), seed);
    return float2(field.noise, field.quadrature);
}

float2 gabor_turns_intensity(float2 noise_quadrature) {
    float intensity = length(noise_quadrature.yx);
    float phase = intensity > 0.0 ? atan2(noise_quadrature.x, noise_quadrature.y) * 0.15915494 : 0.0; // 1/(2 pi)
    return float2(phase < 0.0 ? min(phase + 1.0, 0.99999994) : phase, intensity); // 1 - 2^-24
}

float gabor_noise_tiled(float2 p, float2 period, float frequency, float orientation, uint seed) {
    period = max(period, (float2)(2.0));
    float2 cells = floor(period * GABOR_CELLS_PER_RADIUS);
    float2 density = cells / period;
    float2 within = p - floor(p / period) * period;
    GaborPlace place = GaborPlace_of((int2)(0), within * density, density, (int2)(cells), 0.0);
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).noise;
}

float gabor_noise_animated(float2 p, float evolution, float frequency, float orientation, uint seed) {
    GaborPlace place = gabor_place((int2)(0), p * GABOR_CELLS_PER_RADIUS);
    place.evolution = evolution;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).noise;
}

float gabor_unorm(float noise) {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

#endif
