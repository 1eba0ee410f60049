// Generated from gabor_fractal.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl; pasted after their texts, it includes nothing.
//
// gabor_fractal.hlsl: fBm, billows, ridges and warps of smooth or Perlin-like noise, each with mean 0 and variance 1.
//
//     float clouds = gabor_fbm(p, 5.0, 0.5, 7u);                 // 5 octaves, each half as strong, seed 7
//     float sky = gabor_uniform(clouds) < 0.3 ? 1.0 : 0.0;       // covers 30 % of the area
//
//     I want                                   call
//     fBm, billows, ridges                     gabor_fbm, gabor_billow, gabor_ridged
//     the same in a volume                     gabor_fbm_3d, or a place, then gabor_fractal_noise_3d
//     one octave                               gabor_smooth, or gabor_perlin, which replaces Perlin and simplex noise
//     derivatives, periods, other octaves      a place and a GaborFractal, then gabor_fractal_noise
//     no flicker in the distance               gabor_fractal_noise_filtered
//     marble, smoke, swirls                    gabor_warp, then any noise at the place that it returns
//     a flow without sources                   float2(-g.y, g.x), where g is the gradient of any noise
//
// All noises have mean 0 and variance 1 at every point, for any number of octaves, gain, period and evolution. One
// octave and fBm are normal; so gabor_uniform gives their rank among all values. Octaves are independent, and each is
// turned against the previous one.
//
// Arguments of all functions, besides those of gabor_noise.hlsl:
//     octaves  1 to 16. The last octave fades in with the fraction: at 4.3, the fifth has 0.3 of its amplitude. Keep
//              |p| lacunarity^octaves below 2^30.
//     gain     amplitude of an octave relative to the previous one, 0 to 4
//     dx, dy   the pixel: see gabor_filter.hlsl
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#ifndef GABOR_NOISE_HLSL
#error Include gabor_noise.hlsl before gabor_fractal.hlsl
#elif GABOR_TAPS != 3
#error gabor_fractal.hlsl needs GABOR_TAPS 3
#endif
#ifndef GABOR_FRACTAL_HLSL
#define GABOR_FRACTAL_HLSL 1

// The noise of an octave. Smooth noise has most power at low frequencies: within 0.5 cycles per kernel radius. Perlin
// noise has little there: the centroid of its spectrum is 0.52 cycles per kernel radius. Along the axes of their
// lattice, they have 0.97 and 0.92 of the power along the diagonals.
#define GABOR_SMOOTH 0
#define GABOR_PERLIN 1

// What the octaves n become before they are summed: n; |n|, minus its mean and over its deviation; or minus that.
#define GABOR_FBM 0
#define GABOR_BILLOW 1
#define GABOR_RIDGED 2

struct GaborFractal {
    float octaves;
    float gain;
    float lacunarity; // frequency of an octave relative to the previous one, 1 to 4, rounded to a multiple of 1/4096
    float turn;       // angle in radians by which an octave is turned against the previous one, unused with a period
    int basis;        // GABOR_SMOOTH or GABOR_PERLIN
    int shape;        // GABOR_FBM, GABOR_BILLOW or GABOR_RIDGED
};

GaborFractal GaborFractal_of(float octaves, float gain, float lacunarity, float turn, int basis, int shape) {
    GaborFractal made = {octaves, gain, lacunarity, turn, basis, shape};
    return made;
}

// GaborFractal gabor_fractal(float octaves, float gain)
//     fBm of smooth noise, with lacunarity 2 and turns of 0.6435 radians.

struct GaborFractalNoise {
    float noise;
    float2 gradient; // per kernel radius of the first octave, with a filter at a fixed footprint
    float removed; // share of the variance that a filter removed
    float3 lost;     // covariance xx, yy, xy of the slopes that a filter removed, such as materials add to roughness
};

GaborFractalNoise GaborFractalNoise_of(float noise, float2 gradient, float removed, float3 lost) {
    GaborFractalNoise made = {noise, gradient, removed, lost};
    return made;
}

struct GaborFractalNoise3d {
    float noise;
    float3 gradient;
    float removed;
    float3 lost;       // covariance xx, yy, zz
    float3 lost_mixed; // covariance xy, xz, yz
};

GaborFractalNoise3d GaborFractalNoise3d_of(float noise, float3 gradient, float removed, float3 lost, float3 lost_mixed)
        {
    GaborFractalNoise3d made = {noise, gradient, removed, lost, lost_mixed};
    return made;
}

// float gabor_smooth(float2 p, uint seed)
// float gabor_perlin(float2 p, uint seed)
// float gabor_perlin_3d(float3 p, uint seed)
//     One octave. gabor_perlin's p is in the cells of Perlin noise, so both have the same size; to match its contrast,
//     multiply by its deviation, 0.25 to 0.3: see docs/other-noises.md.

// float gabor_fbm(float2 p, float octaves, float gain, uint seed)
// float gabor_fbm_3d(float3 p, float octaves, float gain, uint seed)
// float gabor_billow(float2 p, float octaves, float gain, uint seed)
// float gabor_ridged(float2 p, float octaves, float gain, uint seed)
//     Sums of smooth octaves. Ridges are billows upside down: at most 1.32 for one octave.

// GaborFractalNoise gabor_fractal_noise(GaborPlace place, GaborFractal fractal, uint seed)
// GaborFractalNoise3d gabor_fractal_noise_3d(GaborPlace3d place, GaborFractal fractal, uint seed)
//     Any sum of octaves at a place. Its evolution changes all octaves in place, and repeats when it grows by 1. With a
//     period of at least 8/3 kernel radii, every octave has a whole number of nodes along it, and none is turned.
//     Gradients of fBm are continuous. The variance of a smooth octave's is the same everywhere; a Perlin octave's is
//     0.6 to 1.5 of the mean, largest at nodes. Lit alone, a smooth octave shows where its second derivatives jump.

// GaborFractalNoise gabor_fractal_noise_filtered(GaborPlace place, float2 dx, float2 dy, GaborFractal fractal, uint seed)
// GaborFractalNoise3d gabor_fractal_noise_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, GaborFractal fractal,
//                                                     uint seed)
//     The sum averaged over a pixel. |n| becomes its mean over what was removed, so billows and ridges keep their
//     brightness. The noise's rms error is 0.02 of a deviation for one smooth octave whose pixel has a standard
//     deviation of 0.1 kernel radii, and 0.23 for 1. Octaves that keep less than 1/1000 of their variance are left out.

// A warp moves a place along two noises, or three in a volume, whose deviation is its strength in kernel radii.
struct GaborWarp {
    GaborPlace place; // moved
    float2 dx;          // the moved position's derivative along x: a gradient g there becomes (dot(g, dx), dot(g, dy)),
    float2 dy;          // and a pixel (a, b) becomes a dx + b dy
    float3 lost;        // what a filter removed of it adds dot(g, g) times this to the lost slopes of a noise there
};

GaborWarp GaborWarp_of(GaborPlace place, float2 dx, float2 dy, float3 lost) {
    GaborWarp made = {place, dx, dy, lost};
    return made;
}

struct GaborWarp3d {
    GaborPlace3d place;
    float3 dx;
    float3 dy;
    float3 dz;
    float3 lost;       // xx, yy, zz
    float3 lost_mixed; // xy, xz, yz
};

GaborWarp3d GaborWarp3d_of(GaborPlace3d place, float3 dx, float3 dy, float3 dz, float3 lost, float3 lost_mixed) {
    GaborWarp3d made = {place, dx, dy, dz, lost, lost_mixed};
    return made;
}

// GaborWarp gabor_warp(GaborPlace place, float strength, GaborFractal fractal, uint seed)
// GaborWarp gabor_warp_filtered(GaborPlace place, float2 dx, float2 dy, float strength, GaborFractal fractal, uint seed)
// GaborWarp3d gabor_warp_3d(GaborPlace3d place, float strength, GaborFractal fractal, uint seed)
// GaborWarp3d gabor_warp_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, float strength, GaborFractal fractal,
//                                    uint seed)
//     The place moved by a warp, plain or filtered.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// An octave is noise on the lattice of gabor_noise.hlsl, with node spacings as unit of length. Smooth noise has real
// amplitudes A, Perlin noise gradients (A, B) at its nodes c:
//
//     smooth = sum A_c u(x) u(y),   Perlin = 1/sqrt(2) sum A_c v(x) u(y) + B_c u(x) v(y).
//
// u is a window h, and v its derivative h', of p - c. Each is divided by the root of the sum of its squares over the
// nodes that reach the point, so that the variance is 1 at every point. Smooth noise has Hann's window over three
// nodes. For Perlin noise, h = c^2 over four nodes, where c = (1 + cos(pi d / 2)) / 2: h'' is continuous, and so is the
// gradient.
//
// A filter widens the windows: with the pixel's deviation s along the axis, Hann's to a half-width of
// 3/2 sqrt(1 + s^2 / 0.294), at most 2; and Perlin noise's to c^2 (1 + t (1 - c)), where t = 5.5 s^2, at most 2. Each
// window is then multiplied by its correlation with the exactly filtered one, averaged over places: see
// gabor_impl_kept_even and gabor_impl_kept_odd. A pixel that is oblique to the axes keeps more: its covariance
// multiplies smooth noise by 1 / (1 - k^2 / 2), where k = 2.9 s_xy / sqrt((1 + 2.9 s_x^2) (1 + 2.9 s_y^2)), and Perlin
// noise by the cube of that.

// The windows of four nodes along an axis, from the one at or before node -1, and their derivatives.
struct GaborImplLine {
    uint4 word;
    float4 even; // u, for three nodes with w = 0
    float4 even_slope;
    float4 odd; // v
    float4 odd_slope;
};

GaborImplLine GaborImplLine_of(uint4 word, float4 even, float4 even_slope, float4 odd, float4 odd_slope) {
    GaborImplLine made = {word, even, even_slope, odd, odd_slope};
    return made;
}

// The squared correlations of filtered windows u and v with the exactly filtered ones: their roots are within 0.006.
float gabor_impl_kept_even(float variance) {
    return rsqrt(1.0 + variance * (2.888 + 1.52 * variance * variance / (variance + 0.5855)));
}

float gabor_impl_kept_odd(float variance) {
    float y = rsqrt(1.0 + variance * (2.704 + 1.173 * variance * variance / (variance + 0.149)));
    return y * y * y;
}

// Hann's windows as gabor_impl_windows returns them: the sum must be divided by the root of GABOR_IMPL_ENERGY, and its
// derivatives by GABOR_CELLS_PER_RADIUS as well.
GaborImplLine gabor_impl_smooth_line(int cell, float local, int period, uint salt) {
    float zero = floor(local + 0.5);
    float4 value, slope;
    gabor_impl_windows(clamp(local - zero, -0.5, 0.5), value, slope);
    return GaborImplLine_of(gabor_impl_four_line_words(cell + int(zero), period, salt), value, slope, (float4)(0.0),
                         (float4)(0.0));
}

// Divides a window and its derivative by the root of the sum of the squared windows, and multiplies both by `kept`.
void gabor_impl_normalize_windows(inout float4 value, inout float4 slope, float kept) {
    float scale = rsqrt(dot(value, value));
    value *= scale;
    slope = kept * scale * (slope - dot(value, slope) * value);
    value *= kept;
}

// One over the half-width of Hann's windows, in node spacings, for a filter.
float gabor_impl_inverse_width(float variance) {
    return rsqrt(min(2.25 + 7.6530612 * variance, 4.0)); // 2.25 / 0.294
}

// Those windows, not normalized: the sum of their squares is within 1 % of 3/4 of the half-width. The nodes are at
// -3/2, -1/2, 1/2 and 3/2 times an angle from the middle, which is at the angle of `a`.
GaborImplLine gabor_impl_smooth_line_filtered(int cell, float local, int period, uint salt, float inverse_width) {
    float zero = floor(local), d = clamp(local - zero, 0.0, 1.0);
    float2 a = 0.5 * gabor_impl_half_turn(0.5 * inverse_width * (d - 0.5));
    float2 inner = gabor_impl_half_turn(0.25 * inverse_width);
    float square = 4.0 * inner.x * inner.x;
    float2 outer = inner * float2(square - 3.0, square - 1.0); // the cosine and sine of thrice the angle
    float4 cosine = a.x * float4(outer.x, inner.x, inner.x, outer.x) - a.y * float4(outer.y, inner.y, -inner.y, -outer.y);
    float4 sine = a.y * float4(outer.x, inner.x, inner.x, outer.x) + a.x * float4(outer.y, inner.y, -inner.y, -outer.y);
    float4 value = 0.5 + cosine, slope = -3.1415927 * inverse_width * sine; // pi
    bool first = (d + 1.0) * inverse_width < 1.0, last = (2.0 - d) * inverse_width < 1.0;
    value = float4(first ? value.x : 0.0, value.yz, last ? value.w : 0.0);
    slope = float4(first ? slope.x : 0.0, slope.yz, last ? slope.w : 0.0);
    return GaborImplLine_of(gabor_impl_four_line_words(cell + int(zero), period, salt), value, slope, (float4)(0.0),
                         (float4)(0.0));
}

// How much a filter widens Perlin noise's windows: t in the comment above.
float gabor_impl_widening(float variance) {
    return min(5.5 * variance, 2.0);
}

// A variance of 0 is no filter.
GaborImplLine gabor_impl_perlin_line(int cell, float local, int period, uint salt, float variance) {
    float zero = floor(local), t = gabor_impl_widening(variance);
    float2 turn = gabor_impl_half_turn(0.25 * clamp(local - zero, 0.0, 1.0));
    float4 cosine = float4(-turn.y, turn.x, turn.y, -turn.x); // of pi d / 2
    float4 hann = 0.5 + 0.5 * cosine, hann_slope = 0.78539816 * float4(-turn.x, -turn.y, turn.x, turn.y); // pi/4
    float4 share = 2.0 + 2.0 * t - 3.0 * t * hann;
    float4 even = hann * hann * (1.0 + t - t * hann), even_slope = hann_slope * hann * share, odd = even_slope;
    float4 odd_slope = -1.2337006 * cosine * hann * share + hann_slope * hann_slope * (share - 3.0 * t * hann); // pi^2/8
    gabor_impl_normalize_windows(even, even_slope, sqrt(gabor_impl_kept_even(variance)));
    gabor_impl_normalize_windows(odd, odd_slope, sqrt(gabor_impl_kept_odd(variance)));
    return GaborImplLine_of(gabor_impl_four_line_words(cell + int(zero), period, salt), even, even_slope, odd, odd_slope);
}

// Adds a row of nodes of smooth noise to (value, d/dx, d/dy). `even` is the row's window and its derivative.
void gabor_impl_add_smooth_row(inout float3 sum, GaborImplLine x, uint word, float2 even, bool four, float evolution) {
    uint4 words = x.word * word;
    float4 a = float4(gabor_impl_amplitude_at(words.x, evolution).x, gabor_impl_amplitude_at(words.y, evolution).x,
                  gabor_impl_amplitude_at(words.z, evolution).x, 0.0);
    if (four) a.w = gabor_impl_amplitude_at(words.w, evolution).x;
    float row = dot(x.even.xyz, a.xyz), side = dot(x.even_slope.xyz, a.xyz);
    if (four) {
        row += x.even.w * a.w;
        side += x.even_slope.w * a.w;
    }
    sum += float3(even.x * row, even.x * side, even.y * row);
}

// A smooth noise and its gradient. `four` is whether the windows of four nodes reach a point, not three.
float3 gabor_impl_smooth_sum(GaborImplLine x, GaborImplLine y, bool four, float evolution) {
    float3 sum = (float3)(0.0);
    gabor_impl_add_smooth_row(sum, x, y.word.x, float2(y.even.x, y.even_slope.x), four, evolution);
    gabor_impl_add_smooth_row(sum, x, y.word.y, float2(y.even.y, y.even_slope.y), four, evolution);
    gabor_impl_add_smooth_row(sum, x, y.word.z, float2(y.even.z, y.even_slope.z), four, evolution);
    if (four) gabor_impl_add_smooth_row(sum, x, y.word.w, float2(y.even.w, y.even_slope.w), four, evolution);
    return sum / GABOR_IMPL_DEVIATION;
}

// The same for Perlin noise. `even` and `odd` are the row's windows and their derivatives.
void gabor_impl_add_perlin_row(inout float3 sum, GaborImplLine x, uint word, float2 even, float2 odd, float evolution) {
    uint4 words = x.word * word;
    float2 g0 = gabor_impl_amplitude_at(words.x, evolution), g1 = gabor_impl_amplitude_at(words.y, evolution);
    float2 g2 = gabor_impl_amplitude_at(words.z, evolution), g3 = gabor_impl_amplitude_at(words.w, evolution);
    float4 a = float4(g0.x, g1.x, g2.x, g3.x), b = float4(g0.y, g1.y, g2.y, g3.y);
    float odd_row = dot(x.odd, a), even_row = dot(x.even, b);
    sum += float3(even.x * odd_row + odd.x * even_row, even.x * dot(x.odd_slope, a) + odd.x * dot(x.even_slope, b),
                even.y * odd_row + odd.y * even_row);
}

// The sum of two of a Perlin noise's terms, with variance 2.
float3 gabor_impl_perlin_sum(GaborImplLine x, GaborImplLine y, float evolution) {
    float3 sum = (float3)(0.0);
    gabor_impl_add_perlin_row(sum, x, y.word.x, float2(y.even.x, y.even_slope.x), float2(y.odd.x, y.odd_slope.x),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.y, float2(y.even.y, y.even_slope.y), float2(y.odd.y, y.odd_slope.y),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.z, float2(y.even.z, y.even_slope.z), float2(y.odd.z, y.odd_slope.z),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.w, float2(y.even.w, y.even_slope.w), float2(y.odd.w, y.odd_slope.w),
                              evolution);
    return sum / GABOR_IMPL_DEVIATION;
}

GaborImplLine gabor_impl_nodes(int cell, float local, int period, uint salt, float variance, int basis, bool filtered) {
    GaborImplLine line_;
    if (basis == GABOR_PERLIN) line_ = gabor_impl_perlin_line(cell, local, period, salt, variance);
    else if (filtered) {
        line_ = gabor_impl_smooth_line_filtered(cell, local, period, salt, gabor_impl_inverse_width(variance));
        float4 even = line_.even, slope = line_.even_slope;
        gabor_impl_normalize_windows(even, slope, sqrt(gabor_impl_kept_even(variance)));
        line_.even = even;
        line_.even_slope = slope;
    }
    else line_ = gabor_impl_smooth_line(cell, local, period, salt);
    return line_;
}

// The variances of the derivatives of u and v per node spacing, averaged over places. Hann's window of half-width w has
// pi^2/3 w^-2. Perlin noise's window is a sum of cosines of multiples of pi d / 2.
float2 gabor_impl_slope_powers(float variance, bool perlin) {
    if (!perlin) {
        float inverse_width = gabor_impl_inverse_width(variance);
        return float2(3.2898681 * inverse_width * inverse_width, 0.0); // pi^2/3
    }
    float t = gabor_impl_widening(variance), mean = 0.375 + 0.0625 * t;
    float3 power = float3(0.5 + 0.03125 * t, 0.125 - 0.0625 * t, 0.03125 * t);
    power *= power;
    float slope = dot(power, float3(1.0, 4.0, 9.0));
    return 2.4674011 * float2(slope / (2.0 * mean * mean + dot(power, (float3)(1.0))),
                            dot(power, float3(1.0, 16.0, 81.0)) / slope); // pi^2/4
}

uint gabor_impl_octave_salt(uint seed, int octave) {
    return gabor_impl_mix(seed * 0x9e3779b1u + uint(octave) * 0x85ebca6bu, 0xc2b2ae35u);
}

// By how much an oblique pixel keeps more of two axes' windows.
float gabor_impl_oblique(float covariance, float variance_x, float variance_y) {
    // 4.205 is 2.9^2 / 2
    return 1.0 / (1.0 - 4.205 * covariance * covariance / ((1.0 + 2.9 * variance_x) * (1.0 + 2.9 * variance_y)));
}

// 1, but 0 for what keeps less than 1/1000 of its variance.
float gabor_impl_visible(float kept) {
    return clamp(1000.0 * kept - 1.0, 0.0, 1.0);
}

// The mean of |n + sqrt(1 - kept) z| over a normal z of variance 1, and its derivative by n. 0.79788456 is sqrt(2/pi).
float2 gabor_impl_mean_magnitude(float n, float kept) {
    float deviation = sqrt(max(1.0 - kept, 1.0e-8));
    float t = clamp(n / deviation, -9.0, 9.0), slope = 2.0 * gabor_uniform(t) - 1.0;
    return kept < 1.0 ? float2(0.79788456 * deviation * exp(-0.5 * t * t) + n * slope, slope) : float2(abs(n), sign(n));
}

// The variance of |n| that is left where a filter leaves n the share `kept`, within 8e-6. With correlation r, two
// normal values have E|a b| = 2/pi (sqrt(1 - r^2) + r asin(r)), but some drivers' asin errs by 4e-4.
float gabor_impl_kept_magnitude(float kept) {
    float square = min(kept * kept, 1.0), rest = 1.0 - square;
    // fit: see tools/constants.py
    return square * (0.65746669 - 0.07981755 * square) + rest * sqrt(rest) * (0.19638946 + 0.01788676 * rest)
         - 0.21427622;
}

GaborFractal gabor_fractal(float octaves, float gain) {
    // 0.64350111, atan(3/4), was chosen because five such turns spread evenly over a right angle
    return GaborFractal_of(octaves, gain, 2.0, 0.64350111, GABOR_SMOOTH, GABOR_FBM);
}

// ---- In the plane --------------------------------------------------------------------------------------------------

// A place on the lattice of an octave. A unit of x or y in kernel radii of the first octave is along_x or along_y.
struct GaborImplOctave {
    int2 cell;
    float2 local;
    int2 period;
    float2 along_x;
    float2 along_y;
};

GaborImplOctave GaborImplOctave_of(int2 cell, float2 local, int2 period, float2 along_x, float2 along_y) {
    GaborImplOctave made = {cell, local, period, along_x, along_y};
    return made;
}

// A multiple of 1/4096, so that its product with a cell splits exactly into integer and fraction.
float2 gabor_impl_octave_step(GaborFractal fractal) {
    float2 turn = gabor_impl_wave(0.15915494 * clamp(fractal.turn, -1.0e6, 1.0e6)); // 1/(2 pi)
    return floor(4096.0 * clamp(fractal.lacunarity, 1.0, 4.0) * turn + 0.5) / 4096.0;
}

// How many nodes octave i has along a period of `nodes`, and a factor for an axis without a period.
float gabor_impl_octave_nodes(float nodes, float scale) {
    return nodes > 0.0 ? min(floor(nodes * scale + 0.5), 1.0e9) : scale;
}

// Goes to octave i from the previous one, or with a period from the first one. Its lattice is moved, so that its nodes
// are not those of the previous one.
void gabor_impl_next_octave(inout GaborImplOctave octave, GaborPlace place, float2 by, float lacunarity, int i) {
    float2 moved = float2(0.382, 0.731);
    if (place.period.x == 0 && place.period.y == 0) {
        octave.local = gabor_impl_product(by, octave.local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0) {
            int2 m = (int2)(by * 4096.0), low = octave.cell & (int2)(4095);
            uint2 high = (uint2)(octave.cell >> (int2)(12)), n = (uint2)(m);
            int2 part = m.x * low + m.y * int2(-low.y, low.x);
            octave.cell = (int2)(n.x * high + n.y * uint2(0u - high.y, high.x)) + (part >> (int2)(12));
            octave.local += (float2)(part & (int2)(4095)) / 4096.0;
        }
        octave.along_x = gabor_impl_product(by, octave.along_x);
        octave.along_y = gabor_impl_product(by, octave.along_y);
    } else {
        float scale = pow(clamp(lacunarity, 1.0, 4.0), float(i));
        float2 first = (float2)(place.period);
        float2 within = float2(float(gabor_impl_wrap(place.cell.x, place.period.x)),
                           float(gabor_impl_wrap(place.cell.y, place.period.y))) + place.local;
        float2 nodes = float2(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale));
        float2 growth = nodes / max(first, 1.0);
        octave.cell = (int2)(0);
        octave.local = growth * (within - first * floor(within / max(first, 1.0))) + float(i) * moved;
        octave.period = int2(place.period.x == 0 ? 0 : int(nodes.x), place.period.y == 0 ? 0 : int(nodes.y));
        octave.along_x = float2(growth.x * place.cells_per_radius.x, 0.0);
        octave.along_y = float2(0.0, growth.y * place.cells_per_radius.y);
    }
}

// The noise of an octave, and its gradient per node spacing.
float3 gabor_impl_octave_noise(GaborImplOctave octave, uint salt, float2 variance, int basis, bool filtered,
                             float evolution) {
    GaborImplLine x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                                      filtered);
    GaborImplLine y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                                      variance.y, basis, filtered);
    float3 noise;
    if (basis == GABOR_PERLIN) noise = 0.70710678 * gabor_impl_perlin_sum(x, y, evolution); // 1/sqrt(2)
    else noise = gabor_impl_smooth_sum(x, y, filtered, evolution);
    if (basis != GABOR_PERLIN && !filtered)
        noise *= float3(1.0, (float2)(1.0 / GABOR_CELLS_PER_RADIUS)) / GABOR_IMPL_ENERGY;
    return noise;
}

// Adds an octave (value, d/dx, d/dy per node spacing) to the sum, of which `kept` of the variance is left, with an
// amplitude. `lost` is the variance of its lost slopes along the lattice's axes.
void gabor_impl_add_octave(inout GaborFractalNoise sum, GaborImplOctave octave, int shape, float amplitude, float3 noise,
                           float kept, float2 lost) {
    float2 gradient = float2(dot(noise.yz, octave.along_x), dot(noise.yz, octave.along_y));
    float3 covariance = float3(dot(lost, octave.along_x * octave.along_x), dot(lost, octave.along_y * octave.along_y),
                           dot(lost, octave.along_x * octave.along_y));
    float value = noise.x;
    if (shape != GABOR_FBM) {
        float2 mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456; // sqrt(2/pi)
        covariance += (1.0 - mean.y * mean.y) * float3(gradient * gradient, gradient.x * gradient.y);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= shape == GABOR_RIDGED ? -1.6588967 : 1.6588967; // 1/sqrt(1 - 2/pi)
    }
    sum.noise += amplitude * value;
    sum.gradient += amplitude * gradient;
    sum.removed += amplitude * amplitude * kept;
    sum.lost += amplitude * amplitude * covariance;
}

GaborFractalNoise gabor_impl_fractal(GaborPlace place, bool filtered, float2 dx, float2 dy, GaborFractal fractal,
                                     uint seed) {
    GaborFractalNoise sum = GaborFractalNoise_of(0.0, (float2)(0.0), 0.0, (float3)(0.0));
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = float2(1.0e3, 0.0);
        dy = float2(0.0, 1.0e3);
    }
    GaborImplOctave octave = GaborImplOctave_of(place.cell, place.local, place.period, float2(place.cells_per_radius.x, 0.0),
                                             float2(0.0, place.cells_per_radius.y));
    float2 by = gabor_impl_octave_step(fractal);
    float octaves = clamp(fractal.octaves, 1.0, 16.0), amplitude = 1.0, power = 0.0;
    bool perlin = fractal.basis == GABOR_PERLIN;
    int count = int(ceil(octaves));
    for (int i = 0; i < count; ++i) {
        float weight = amplitude * min(octaves - float(i), 1.0);
        power += weight * weight;
        amplitude *= fractal.gain;
        uint salt = gabor_impl_octave_salt(seed, i);
        float2 variance = (float2)(0.0), lost = (float2)(0.0);
        float oblique = 1.0, kept = 1.0;
        if (filtered) {
            float2 a = clamp(0.5 * (dx.x * octave.along_x + dx.y * octave.along_y), -1.0e3, 1.0e3);
            float2 b = clamp(0.5 * (dy.x * octave.along_x + dy.y * octave.along_y), -1.0e3, 1.0e3);
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y);
            float2 even = float2(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y));
            kept = even.x * even.y;
            float2 x = gabor_impl_slope_powers(variance.x, perlin), y = gabor_impl_slope_powers(variance.y, perlin);
            float2 slopes = kept * float2(x.x, y.x); // of u(x) u(y), or the terms of v(x) u(y) and u(x) v(y)
            if (perlin) {
                float2 odd = float2(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y));
                odd = 0.5 * kept * odd / even;
                slopes = float2(odd.x * x.y + odd.y * x.x, odd.x * y.x + odd.y * y.y);
                kept = odd.x + odd.y;
                oblique *= oblique * oblique;
            }
            oblique = min(oblique, rsqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = max((perlin ? 2.6788926 : 1.4621636) - oblique * oblique * slopes, 0.0); // 19/70 pi^2, 4/27 pi^2
        }
        float3 noise = (float3)(0.0);
        if (kept > 0.0) {
            noise = gabor_impl_octave_noise(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) noise *= oblique;
        }
        gabor_impl_add_octave(sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave(octave, place, by, fractal.lacunarity, i + 1);
    }
    float scale = rsqrt(max(power, 1.0e-30));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.removed = filtered ? clamp(1.0 - scale * scale * sum.removed, 0.0, 1.0) : 0.0;
    return sum;
}

GaborFractalNoise gabor_fractal_noise(GaborPlace place, GaborFractal fractal, uint seed) {
    return gabor_impl_fractal(place, false, (float2)(0.0), (float2)(0.0), fractal, seed);
}

GaborFractalNoise gabor_fractal_noise_filtered(GaborPlace place, float2 dx, float2 dy, GaborFractal fractal, uint seed) {
    return gabor_impl_fractal(place, true, dx, dy, fractal, seed);
}

float gabor_smooth(float2 p, uint seed) {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(1.0, 0.0), seed).noise;
}

float gabor_perlin(float2 p, uint seed) {
    GaborFractal fractal = gabor_fractal(1.0, 0.0);
    fractal.basis = GABOR_PERLIN;
    // the centroids of the spectra are 0.62 cycles per cell of Perlin noise and 0.5227 per kernel radius
    return gabor_fractal_noise(gabor_place_at(1.186 * p), fractal, seed).noise;
}

float gabor_fbm(float2 p, float octaves, float gain, uint seed) {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain), seed).noise;
}

float gabor_billow(float2 p, float octaves, float gain, uint seed) {
    GaborFractal fractal = gabor_fractal(octaves, gain);
    fractal.shape = GABOR_BILLOW;
    return gabor_fractal_noise(gabor_place_at(p), fractal, seed).noise;
}

float gabor_ridged(float2 p, float octaves, float gain, uint seed) {
    return -gabor_billow(p, octaves, gain, seed);
}

GaborWarp gabor_impl_moved(GaborPlace place, bool filtered, float2 dx, float2 dy, float strength, GaborFractal fractal,
                           uint seed) {
    GaborFractalNoise x = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    GaborFractalNoise y = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    place.local += strength * float2(x.noise, y.noise) * place.cells_per_radius;
    return GaborWarp_of(place, strength * float2(x.gradient.x, y.gradient.x) + float2(1.0, 0.0),
                     strength * float2(x.gradient.y, y.gradient.y) + float2(0.0, 1.0),
                     0.5 * strength * strength * (x.lost + y.lost));
}

GaborWarp gabor_warp(GaborPlace place, float strength, GaborFractal fractal, uint seed) {
    return gabor_impl_moved(place, false, (float2)(0.0), (float2)(0.0), strength, fractal, seed);
}

GaborWarp gabor_warp_filtered(GaborPlace place, float2 dx, float2 dy, float strength, GaborFractal fractal, uint seed) {
    return gabor_impl_moved(place, true, dx, dy, strength, fractal, seed);
}

// ---- In a volume ---------------------------------------------------------------------------------------------------

// A place on the lattice of an octave: see GaborImplOctave.
struct GaborImplOctave3d {
    int3 cell;
    float3 local;
    int3 period;
    float3 along_x;
    float3 along_y;
    float3 along_z;
};

GaborImplOctave3d GaborImplOctave3d_of(int3 cell, float3 local, int3 period, float3 along_x, float3 along_y,
        float3 along_z) {
    GaborImplOctave3d made = {cell, local, period, along_x, along_y, along_z};
    return made;
}

// A step to the next octave: lacunarity times a rotation about (1, 1, 1), v.x times the vector, v.y times its yzx and
// v.z times its zxy.
float3 gabor_impl_octave_step_3d(GaborFractal fractal) {
    float2 turn = gabor_impl_wave(0.15915494 * clamp(fractal.turn, -1.0e6, 1.0e6)); // 1/(2 pi)
    float rest = (1.0 - turn.x) / 3.0, side = 0.57735027 * turn.y; // 1/sqrt(3)
    return floor(4096.0 * clamp(fractal.lacunarity, 1.0, 4.0) * float3(turn.x + rest, rest - side, rest + side) + 0.5)
         / 4096.0;
}

float3 gabor_impl_step_3d(float3 by, float3 v) {
    return by.x * v + by.y * v.yzx + by.z * v.zxy;
}

void gabor_impl_next_octave_3d(inout GaborImplOctave3d octave, GaborPlace3d place, float3 by, float lacunarity, int i) {
    float3 moved = float3(0.382, 0.731, 0.545);
    if (place.period.x == 0 && place.period.y == 0 && place.period.z == 0) {
        octave.local = gabor_impl_step_3d(by, octave.local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0 || place.cell.z != 0) {
            int3 m = (int3)(by * 4096.0), low = octave.cell & (int3)(4095);
            uint3 high = (uint3)(octave.cell >> (int3)(12)), n = (uint3)(m);
            int3 part = m.x * low + m.y * low.yzx + m.z * low.zxy;
            octave.cell = (int3)(n.x * high + n.y * high.yzx + n.z * high.zxy) + (part >> (int3)(12));
            octave.local += (float3)(part & (int3)(4095)) / 4096.0;
        }
        octave.along_x = gabor_impl_step_3d(by, octave.along_x);
        octave.along_y = gabor_impl_step_3d(by, octave.along_y);
        octave.along_z = gabor_impl_step_3d(by, octave.along_z);
    } else {
        float scale = pow(clamp(lacunarity, 1.0, 4.0), float(i));
        float3 first = (float3)(place.period);
        float3 within = float3(float(gabor_impl_wrap(place.cell.x, place.period.x)),
                           float(gabor_impl_wrap(place.cell.y, place.period.y)),
                           float(gabor_impl_wrap(place.cell.z, place.period.z))) + place.local;
        float3 nodes = float3(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale),
                          gabor_impl_octave_nodes(first.z, scale));
        float3 growth = nodes / max(first, 1.0);
        octave.cell = (int3)(0);
        octave.local = growth * (within - first * floor(within / max(first, 1.0))) + float(i) * moved;
        octave.period = int3(place.period.x == 0 ? 0 : int(nodes.x), place.period.y == 0 ? 0 : int(nodes.y),
                              place.period.z == 0 ? 0 : int(nodes.z));
        octave.along_x = float3(growth.x * place.cells_per_radius.x, 0.0, 0.0);
        octave.along_y = float3(0.0, growth.y * place.cells_per_radius.y, 0.0);
        octave.along_z = float3(0.0, 0.0, growth.z * place.cells_per_radius.z);
    }
}

void gabor_impl_add_octave_3d(inout GaborFractalNoise3d sum, GaborImplOctave3d octave, int shape, float amplitude,
                              float4 noise, float kept, float3 lost) {
    float3 gradient = float3(dot(noise.yzw, octave.along_x), dot(noise.yzw, octave.along_y),
                         dot(noise.yzw, octave.along_z));
    float3 covariance = float3(dot(lost, octave.along_x * octave.along_x), dot(lost, octave.along_y * octave.along_y),
                           dot(lost, octave.along_z * octave.along_z));
    float3 mixed = float3(dot(lost, octave.along_x * octave.along_y), dot(lost, octave.along_x * octave.along_z),
                      dot(lost, octave.along_y * octave.along_z));
    float value = noise.x;
    if (shape != GABOR_FBM) {
        float2 mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456; // sqrt(2/pi)
        covariance += (1.0 - mean.y * mean.y) * gradient * gradient;
        mixed += (1.0 - mean.y * mean.y) * float3(gradient.x * gradient.yz, gradient.y * gradient.z);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= shape == GABOR_RIDGED ? -1.6588967 : 1.6588967; // 1/sqrt(1 - 2/pi)
    }
    sum.noise += amplitude * value;
    sum.gradient += amplitude * gradient;
    sum.removed += amplitude * amplitude * kept;
    sum.lost += amplitude * amplitude * covariance;
    sum.lost_mixed += amplitude * amplitude * mixed;
}

// The words of the lattice's rows in slice k, given those of rows in any slice, and as many words independent of them.
uint4 gabor_impl_slice_words(uint4 rows, uint slice) {
    return uint4(gabor_impl_slice_word(rows.x, slice), gabor_impl_slice_word(rows.y, slice),
                 gabor_impl_slice_word(rows.z, slice), gabor_impl_slice_word(rows.w, slice));
}

uint4 gabor_impl_other_words(uint4 words) {
    return (((words ^ (words >> (uint4)(15u))) * 0xd35a2d97u) >> (uint4)(8u)) | (uint4)(0x800001u);
}

// Adds a slice of smooth noise to (value, d/dx, d/dy, d/dz).
void gabor_impl_add_smooth_slice(inout float4 sum, GaborImplLine x, GaborImplLine y, uint slice, float2 even, bool four,
                                 float evolution) {
    y.word = gabor_impl_slice_words(y.word, slice);
    float3 noise = gabor_impl_smooth_sum(x, y, four, evolution);
    sum += float4(even.x * noise, even.y * noise.x);
}

float4 gabor_impl_smooth_sum_3d(GaborImplLine x, GaborImplLine y, GaborImplLine z, bool four, float evolution) {
    float4 sum = (float4)(0.0);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.x, float2(z.even.x, z.even_slope.x), four, evolution);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.y, float2(z.even.y, z.even_slope.y), four, evolution);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.z, float2(z.even.z, z.even_slope.z), four, evolution);
    if (four) gabor_impl_add_smooth_slice(sum, x, y, z.word.w, float2(z.even.w, z.even_slope.w), four, evolution);
    return sum;
}

// Adds a slice of Perlin noise: v(x) u(y) and u(x) v(y) times u(z), and u(x) u(y) times v(z).
void gabor_impl_add_perlin_slice(inout float4 sum, GaborImplLine x, GaborImplLine y, uint slice, float2 even, float2 odd,
                                 float evolution) {
    y.word = gabor_impl_slice_words(y.word, slice);
    float3 noise = gabor_impl_perlin_sum(x, y, evolution);
    y.word = gabor_impl_other_words(y.word);
    float3 third = gabor_impl_smooth_sum(x, y, true, evolution);
    sum += float4(even.x * noise + odd.x * third, even.y * noise.x + odd.y * third.x);
}

// Three terms, with variance 3.
float4 gabor_impl_perlin_sum_3d(GaborImplLine x, GaborImplLine y, GaborImplLine z, float evolution) {
    float4 sum = (float4)(0.0);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.x, float2(z.even.x, z.even_slope.x), float2(z.odd.x, z.odd_slope.x),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.y, float2(z.even.y, z.even_slope.y), float2(z.odd.y, z.odd_slope.y),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.z, float2(z.even.z, z.even_slope.z), float2(z.odd.z, z.odd_slope.z),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.w, float2(z.even.w, z.even_slope.w), float2(z.odd.w, z.odd_slope.w),
                                evolution);
    return sum;
}

float4 gabor_impl_octave_noise_3d(GaborImplOctave3d octave, uint salt, float3 variance, int basis, bool filtered,
                                float evolution) {
    GaborImplLine x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                                      filtered);
    GaborImplLine y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                                      variance.y, basis, filtered);
    GaborImplLine z = gabor_impl_nodes(octave.cell.z, octave.local.z, octave.period.z, salt ^ GABOR_IMPL_SLICES,
                                      variance.z, basis, filtered);
    float4 noise;
    if (basis == GABOR_PERLIN) noise = 0.57735027 * gabor_impl_perlin_sum_3d(x, y, z, evolution); // 1/sqrt(3)
    else noise = gabor_impl_smooth_sum_3d(x, y, z, filtered, evolution);
    if (basis != GABOR_PERLIN && !filtered)
        noise *= float4(1.0, (float3)(1.0 / GABOR_CELLS_PER_RADIUS)) * (rsqrt(GABOR_IMPL_ENERGY) / GABOR_IMPL_ENERGY);
    return noise;
}

GaborFractalNoise3d gabor_impl_fractal_3d(GaborPlace3d place, bool filtered, float3 dx, float3 dy, GaborFractal fractal,
                                          uint seed) {
    GaborFractalNoise3d sum = GaborFractalNoise3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), (float3)(0.0));
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = float3(1.0e3, 0.0, 0.0);
        dy = float3(0.0, 1.0e3, 1.0e3);
    }
    GaborImplOctave3d octave = GaborImplOctave3d_of(place.cell, place.local, place.period,
                                                 float3(place.cells_per_radius.x, 0.0, 0.0),
                                                 float3(0.0, place.cells_per_radius.y, 0.0),
                                                 float3(0.0, 0.0, place.cells_per_radius.z));
    float3 by = gabor_impl_octave_step_3d(fractal);
    float octaves = clamp(fractal.octaves, 1.0, 16.0), amplitude = 1.0, power = 0.0;
    bool perlin = fractal.basis == GABOR_PERLIN;
    int count = int(ceil(octaves));
    for (int i = 0; i < count; ++i) {
        float weight = amplitude * min(octaves - float(i), 1.0);
        power += weight * weight;
        amplitude *= fractal.gain;
        uint salt = gabor_impl_octave_salt(seed, i);
        float3 variance = (float3)(0.0), lost = (float3)(0.0);
        float oblique = 1.0, kept = 1.0;
        if (filtered) {
            float3 a = 0.5 * (dx.x * octave.along_x + dx.y * octave.along_y + dx.z * octave.along_z);
            float3 b = 0.5 * (dy.x * octave.along_x + dy.y * octave.along_y + dy.z * octave.along_z);
            a = clamp(a, -1.0e3, 1.0e3);
            b = clamp(b, -1.0e3, 1.0e3);
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y)
                    * gabor_impl_oblique(a.x * a.z + b.x * b.z, variance.x, variance.z)
                    * gabor_impl_oblique(a.y * a.z + b.y * b.z, variance.y, variance.z);
            float3 even = float3(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y),
                             gabor_impl_kept_even(variance.z));
            kept = even.x * even.y * even.z;
            float2 x = gabor_impl_slope_powers(variance.x, perlin), y = gabor_impl_slope_powers(variance.y, perlin);
            float2 z = gabor_impl_slope_powers(variance.z, perlin);
            float3 slopes = kept * float3(x.x, y.x, z.x);
            if (perlin) {
                float3 odd = float3(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y),
                                gabor_impl_kept_odd(variance.z));
                odd = 0.33333333 * kept * odd / even; // 1/3
                slopes = float3(odd.x * x.y + (odd.y + odd.z) * x.x, odd.y * y.y + (odd.x + odd.z) * y.x,
                              odd.z * z.y + (odd.x + odd.y) * z.x);
                kept = odd.x + odd.y + odd.z;
                oblique *= oblique * oblique;
            }
            oblique = min(oblique, rsqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = max((perlin ? 2.2559096 : 1.4621636) - oblique * oblique * slopes, 0.0); // 8/35 pi^2, 4/27 pi^2
        }
        float4 noise = (float4)(0.0);
        if (kept > 0.0) {
            noise = gabor_impl_octave_noise_3d(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) noise *= oblique;
        }
        gabor_impl_add_octave_3d(sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave_3d(octave, place, by, fractal.lacunarity, i + 1);
    }
    float scale = rsqrt(max(power, 1.0e-30));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.lost_mixed *= scale * scale;
    sum.removed = filtered ? clamp(1.0 - scale * scale * sum.removed, 0.0, 1.0) : 0.0;
    return sum;
}

GaborFractalNoise3d gabor_fractal_noise_3d(GaborPlace3d place, GaborFractal fractal, uint seed) {
    return gabor_impl_fractal_3d(place, false, (float3)(0.0), (float3)(0.0), fractal, seed);
}

GaborFractalNoise3d gabor_fractal_noise_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, GaborFractal fractal,
                                                    uint seed) {
    return gabor_impl_fractal_3d(place, true, dx, dy, fractal, seed);
}

float gabor_perlin_3d(float3 p, uint seed) {
    GaborFractal fractal = gabor_fractal(1.0, 0.0);
    fractal.basis = GABOR_PERLIN;
    return gabor_fractal_noise_3d(gabor_place_3d_at(1.186 * p), fractal, seed).noise; // as in gabor_perlin
}

float gabor_fbm_3d(float3 p, float octaves, float gain, uint seed) {
    return gabor_fractal_noise_3d(gabor_place_3d_at(p), gabor_fractal(octaves, gain), seed).noise;
}

GaborWarp3d gabor_impl_moved_3d(GaborPlace3d place, bool filtered, float3 dx, float3 dy, float strength,
                                GaborFractal fractal, uint seed) {
    GaborFractalNoise3d x = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    GaborFractalNoise3d y = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    GaborFractalNoise3d z = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 2));
    place.local += strength * float3(x.noise, y.noise, z.noise) * place.cells_per_radius;
    float power = strength * strength / 3.0;
    return GaborWarp3d_of(place, strength * float3(x.gradient.x, y.gradient.x, z.gradient.x) + float3(1.0, 0.0, 0.0),
                       strength * float3(x.gradient.y, y.gradient.y, z.gradient.y) + float3(0.0, 1.0, 0.0),
                       strength * float3(x.gradient.z, y.gradient.z, z.gradient.z) + float3(0.0, 0.0, 1.0),
                       power * (x.lost + y.lost + z.lost), power * (x.lost_mixed + y.lost_mixed + z.lost_mixed));
}

GaborWarp3d gabor_warp_3d(GaborPlace3d place, float strength, GaborFractal fractal, uint seed) {
    return gabor_impl_moved_3d(place, false, (float3)(0.0), (float3)(0.0), strength, fractal, seed);
}

GaborWarp3d gabor_warp_3d_filtered(GaborPlace3d place, float3 dx, float3 dy, float strength, GaborFractal fractal,
                                   uint seed) {
    return gabor_impl_moved_3d(place, true, dx, dy, strength, fractal, seed);
}

#endif
