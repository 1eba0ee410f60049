// Gabor noise: waves whose frequency and direction you choose. Drag the mouse: to the right the frequency grows, upwards
// the waves turn. Paste all of this into shadertoy.com, or write your own mainImage.

// ---- gabor_lattice.glsl as it is ----
// gabor_lattice.glsl: exactly normalized Gabor noise in two dimensions, from random amplitudes on a lattice.
//
// Paste or include this one file after `#version`; it needs GLSL 450, 330 core or 300 es, declares no resources, and
// every name it adds begins with gabor_, Gabor or GABOR_. The functions to call are at its end:
//     gabor_noise, gabor_unorm                 the noise, mean 0 and variance 1, and to show it
//     gabor_noise_gradient                     with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor        with its quadrature: phase and intensity
//     gabor_noise_four                         four independent ones at once
//     gabor_noise_tiled, gabor_noise_animated  with exact periods in space, and in time
//     gabor_noise_at, gabor_kernel             by integer cell and local offset, for large worlds
//
// The nodes c_ij of a square lattice, R to the unit of length, have random complex amplitudes A_ij, independent and
// normal, and each sends out a wave under a window that ends one unit from it along x and y, the kernel radius:
//     n(p) = K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)),   F = frequency (cos o, sin o)
// The window is Hann's, h(x) = (1 + cos pi x) / 2. GABOR_TAPS nodes along each axis reach a point, R = GABOR_TAPS / 2,
// and as three or more evenly spaced shifts of cos and of cos^2 over their period sum to a constant,
//     sum_i h(x - x_i)^2 = 3/8 GABOR_TAPS   at every x,
// and likewise for the squares of the derivatives: the variances of the noise, of its gradient and of its second
// derivatives are the same at every place, at every frequency. The sum is normal where the amplitudes are. Each wave's
// phase counts from its own node, so frequency and orientation may vary from place to place. After [TNVT19] Tavernier,
// Neyret, Vergne, Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019, whose last section asks for it.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifdef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl or gabor_lattice.glsl, not both: they define the same functions
#endif
#ifndef GABOR_LATTICE_GLSL
#define GABOR_LATTICE_GLSL

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// Nodes along each axis that reach a point: 3; 4 for a covariance that depends less on the place; 2 for speed. Each
// function costs as many amplitudes as their square, and four and animated noise four and three times as many.
#ifndef GABOR_TAPS
#define GABOR_TAPS 3
#endif
#if GABOR_TAPS < 2 || GABOR_TAPS > 4
#error GABOR_TAPS is 2, 3 or 4
#endif
#define GABOR_RADIUS (0.5 * float(GABOR_TAPS)) // R, nodes per kernel radius

// ---- Randomness ----------------------------------------------------------------------------------------------------

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project).
uint gabor_impl_mix(uint word, uint salt)
{
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The seed of noise `index` of a sum: those of different indices are independent.
uint gabor_lobe_seed(uint seed, int index)
{
    return gabor_impl_mix(seed + uint(index) * 0x85ebca6bu, 0x9e3779b1u);
}

// The salt of the columns; that of the rows is its xor with a constant: with one salt for both, nodes on the diagonal
// would have squares for words.
#define GABOR_IMPL_ROWS 0x5bd1e995u
uint gabor_impl_salt(uint seed)
{
    return gabor_impl_mix(seed * 0x9e3779b1u, 0x2545f491u);
}

// The word of a column or a row of nodes: odd and of 24 bits, the highest set, so that it takes all products all over
// 32 bits; GPUs multiply 24 bits at a quarter of the cost. It has 2^22 values: of 4096 columns two pairs are alike.
uint gabor_impl_line_word(int index, uint salt)
{
    uint word = uint(index) * 0x9e3779b1u + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return (word >> 8u) | 0x800001u;
}

uint gabor_impl_node_word(uint column, uint row)
{
    return column * row;
}

// Another word of the same node.
uint gabor_impl_next_word(uint word)
{
    return (word ^ (word >> 15u)) * 0xd35a2d97u;
}

// The amplitude of a word. Its parts, of the whole word and of its low half, are independent and nearly normal: for u
// uniform in [-1, 1] the quantiles of (u - 0.893 clamp(u, -0.937, 0.937)) (1 + 0.623 u^2) are in proportion to those of
// the normal law. The cvm [TNVT19] of the noise is 0.03 at the worst place, a node, where its amplitude has 63 % of the
// power, and 0.001 on average. The deviation of a part in units of 2^-93 / 0.623:
#define GABOR_IMPL_DEVIATION 1.4599553e27
vec2 gabor_impl_amplitude(uint word)
{
    vec2 u = vec2(float(int(word)), float(int(word << 16u)));
    return (u - 0.89289313 * clamp(u, -2.0119258e9, 2.0119258e9)) * (u * u + 7.3973916e18);
}

// The same at the time with this cosine and sine, if animated: a sum of three amplitudes, of the word and of two that no
// other noise of the node has. Its law is theirs at every time, and its correlation with itself falls with the time
// between as (1 + cos) / 2.
vec2 gabor_impl_amplitude_at(uint word, bool animated, vec2 time)
{
    vec2 a = gabor_impl_amplitude(word);
    if (animated) {
        uint second = gabor_impl_next_word(word ^ 0x68e31da4u);
        vec2 b = gabor_impl_amplitude(second);
        vec2 c = gabor_impl_amplitude(gabor_impl_next_word(second));
        a = 0.5 * (a + b + time.x * (a - b)) + 0.70710678 * time.y * c;
    }
    return a;
}

// ---- Waves ---------------------------------------------------------------------------------------------------------

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1] and as t is rounded beyond. With t reduced to half a turn and
// y = |t| - 1/4, cos(2 pi t) = -sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), |2 pi y| <= pi/2: minimax polynomials.
vec2 gabor_impl_wave(float t)
{
    t -= floor(t + 0.5);
    float y = abs(t) - 0.25;
    float s = y * y;
    float r = s * s;
    float cosine = (41.341655 * s - 6.2831852) + r * ((76.549782 * s - 81.601004) - 39.536707 * r);
    float sine = (1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r);
    return vec2(y * cosine, t < 0.0 ? -sine : sine);
}

// Product of complex numbers.
vec2 gabor_impl_product(vec2 a, vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// ---- Windows -------------------------------------------------------------------------------------------------------

// The windows of the GABOR_TAPS nodes along an axis that reach a point, and their derivatives per kernel radius.
// GABOR_IMPL_ENERGY is the sum of the squares of the windows.
struct GaborWindows {
    vec4 value;
    vec4 slope;
};

#if GABOR_TAPS == 2
// The squares of two shifts of Hann's window do not sum to a constant. Those of 1 - s and s over the root of the sum of
// their squares, with s = x^2 (3 - 2 x), do; but the variances of their derivatives vary.
//   x   offset from the first node, in [0, 1) node spacings
#define GABOR_IMPL_ENERGY 1.0
GaborWindows gabor_impl_windows(float x)
{
    float s = x * x * (3.0 - 2.0 * x);
    vec2 pair = vec2(1.0 - s, s);
    float scale = inversesqrt(dot(pair, pair));
    vec2 slope = (6.0 * x * (1.0 - x) * scale * scale * scale) * pair.yx;
    return GaborWindows(vec4(scale * pair, 0.0, 0.0), vec4(-slope.x, slope.y, 0.0, 0.0));
}
#elif GABOR_TAPS == 3
//   x   offset from the second node, in [-1/2, 1/2) node spacings
#define GABOR_IMPL_ENERGY 1.125
GaborWindows gabor_impl_windows(float x)
{
    float s = x * x;
    float c = 0.5 + s * (-1.0966099 + s * (0.40054826 - s * 0.05644487));              // cos(2 pi x / 3) / 2
    float b = x * (0.90689956 + s * (-0.66301124 + s * (0.14532053 - s * 0.01467483))); // sqrt(3)/4 sin(2 pi x / 3)
    float a = 0.5 - 0.5 * c;
    float slope = 1.8137994 * b; // pi/4 sin(2 pi x / 3)
    return GaborWindows(vec4(a - b, 0.5 + c, a + b, 0.0),
                        vec4(slope - 2.7206991 * c, -2.0 * slope, slope + 2.7206991 * c, 0.0));
}
#else
//   x   offset from the second node, in [0, 1) node spacings
#define GABOR_IMPL_ENERGY 1.5
GaborWindows gabor_impl_windows(float x)
{
    x -= 0.5;
    float s = x * x;
    float cosine = 0.35355338 + s * (-0.43617776 + s * (0.089660662 - s * 0.0072154454));
    float sine = x * (0.55536036 + s * (-0.22838239 + s * (0.028169686 - s * 0.0016236194)));
    vec2 c = vec2(cosine - sine, cosine + sine); // half of cos and sin of pi/4 + pi/2 x
    return GaborWindows(0.5 + vec4(-c.y, c.x, c.y, -c.x), 3.1415927 * vec4(-c.x, -c.y, c.x, c.y));
}
#endif

// ---- The sum -------------------------------------------------------------------------------------------------------

// A wave vector and all that the noise needs of it: make it once where frequency and orientation do not vary.
struct GaborKernel {
    vec2 wave;   // F, cycles per kernel radius
    vec2 step_x; // e^(2 pi i F.x / R): what a wave turns from one node to the next along x
    vec2 step_y; // along y
};

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    ivec2 cell;    // any integers, but for the last few before the world wraps around at 2^31
    vec2 local;    // offset from that cell's corner, in node spacings: any small vector, [0, 1)^2 is the most precise
    vec2 radius;   // nodes per kernel radius along each axis: GABOR_RADIUS, or near it to fit a period
    ivec2 period;  // in nodes, 0 for none
    bool animated; // whether time counts
    float time;    // in periods of time
};

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Compilers leave out what is not used.
struct GaborField {
    vec2 value;
    vec2 slope_x;
    vec2 slope_y;
    vec4 four; // four independent noises, the first the noise itself
};

// An index within a period.
int gabor_impl_wrap(int index, int period)
{
    if (period == 0)
        return index;
    int within = index - index / period * period;
    return within < 0 ? within + period : within;
}

// The nodes of an axis that reach a point: their words, and what their amplitudes are multiplied with along it, h e and
// h' e with e = exp(2 pi i F (x - x_i)), relative to the second node (for two taps, to the first).
struct GaborAxis {
    uvec4 word;
    vec4 real;
    vec4 imaginary;
    vec4 slope_real;
    vec4 slope_imaginary;
};

//   step             e^(2 pi i F / R): what the wave turns from one node to the next
//   real, imaginary  windows: the latter are there after a filter
GaborAxis gabor_impl_axis(int first, int period, uint salt, vec2 step, GaborWindows real, GaborWindows imaginary)
{
#if GABOR_TAPS == 2
    vec4 cosine = vec4(1.0, step.x, 0.0, 0.0);
    vec4 sine = vec4(0.0, -step.y, 0.0, 0.0);
#else
    vec2 two = gabor_impl_product(step, step);
    vec4 cosine = vec4(step.x, 1.0, step.x, two.x);
    vec4 sine = vec4(step.y, 0.0, -step.y, -two.y);
#endif
    uvec4 word = uvec4(gabor_impl_line_word(gabor_impl_wrap(first, period), salt),
                       gabor_impl_line_word(gabor_impl_wrap(first + 1, period), salt),
                       gabor_impl_line_word(gabor_impl_wrap(first + 2, period), salt),
                       gabor_impl_line_word(gabor_impl_wrap(first + 3, period), salt));
    return GaborAxis(word, real.value * cosine - imaginary.value * sine, real.value * sine + imaginary.value * cosine,
                     real.slope * cosine - imaginary.slope * sine, real.slope * sine + imaginary.slope * cosine);
}

// Sums of amplitudes times windows and waves, of four noises, with the windows' derivatives too: along x, along y (of the
// first noise), and along both.
struct GaborSum {
    vec4 real;
    vec4 imaginary;
    vec4 slope_real;
    vec4 slope_imaginary;
    vec2 slope_y;
    vec4 mixed_real;
    vec4 mixed_imaginary;
};

GaborSum gabor_impl_no_sum()
{
    return GaborSum(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec2(0.0), vec4(0.0), vec4(0.0));
}

// Adds node k of a row. Loops over nodes and rows would be shorter, but some compilers do not unroll them.
//   time  cosine and sine of time
void gabor_impl_add_node(inout GaborSum row, GaborAxis columns, int k, uint row_word, bool animated, vec2 time)
{
    uint word = gabor_impl_node_word(columns.word[k], row_word);
    uint second = gabor_impl_next_word(word);
    uint third = gabor_impl_next_word(second);
    vec2 a = gabor_impl_amplitude_at(word, animated, time);
    vec2 b = gabor_impl_amplitude_at(second, animated, time);
    vec2 c = gabor_impl_amplitude_at(third, animated, time);
    vec2 d = gabor_impl_amplitude_at(gabor_impl_next_word(third), animated, time);
    vec4 real = vec4(a.x, b.x, c.x, d.x);
    vec4 imaginary = vec4(a.y, b.y, c.y, d.y);
    row.real += columns.real[k] * real - columns.imaginary[k] * imaginary;
    row.imaginary += columns.real[k] * imaginary + columns.imaginary[k] * real;
    row.slope_real += columns.slope_real[k] * real - columns.slope_imaginary[k] * imaginary;
    row.slope_imaginary += columns.slope_real[k] * imaginary + columns.slope_imaginary[k] * real;
}

// Adds row k.
void gabor_impl_add_row(inout GaborSum sum, GaborAxis columns, GaborAxis rows, int k, bool animated, vec2 time)
{
    GaborSum row = gabor_impl_no_sum();
    gabor_impl_add_node(row, columns, 0, rows.word[k], animated, time);
    gabor_impl_add_node(row, columns, 1, rows.word[k], animated, time);
    if (GABOR_TAPS > 2)
        gabor_impl_add_node(row, columns, 2, rows.word[k], animated, time);
    if (GABOR_TAPS > 3)
        gabor_impl_add_node(row, columns, 3, rows.word[k], animated, time);
    vec2 factor = vec2(rows.real[k], rows.imaginary[k]);
    if (factor.x > -2.0) { // always, but at a branch compilers for CPUs keep rows, and so registers, in order
        sum.real += factor.x * row.real - factor.y * row.imaginary;
        sum.imaginary += factor.x * row.imaginary + factor.y * row.real;
        sum.slope_real += factor.x * row.slope_real - factor.y * row.slope_imaginary;
        sum.slope_imaginary += factor.x * row.slope_imaginary + factor.y * row.slope_real;
        vec2 slope = vec2(rows.slope_real[k], rows.slope_imaginary[k]);
        sum.slope_y += gabor_impl_product(vec2(row.real.x, row.imaginary.x), slope);
        sum.mixed_real += slope.x * row.slope_real - slope.y * row.slope_imaginary;
        sum.mixed_imaginary += slope.x * row.slope_imaginary + slope.y * row.slope_real;
    }
}

// The sum over all nodes.
GaborSum gabor_impl_sum(GaborAxis columns, GaborAxis rows, bool animated, float time)
{
    vec2 turn = gabor_impl_wave(time);
    GaborSum sum = gabor_impl_no_sum();
    gabor_impl_add_row(sum, columns, rows, 0, animated, turn);
    gabor_impl_add_row(sum, columns, rows, 1, animated, turn);
    if (GABOR_TAPS > 2)
        gabor_impl_add_row(sum, columns, rows, 2, animated, turn);
    if (GABOR_TAPS > 3)
        gabor_impl_add_row(sum, columns, rows, 3, animated, turn);
    return sum;
}

// The noise at a place: what the functions below call.
GaborField gabor_field(GaborPlace place, GaborKernel kernel, uint seed)
{
    vec2 first = floor(place.local - GABOR_RADIUS) + 1.0;
    vec2 offset = place.local - first - (GABOR_TAPS == 2 ? 0.0 : 1.0);
    ivec2 node = place.cell + ivec2(first);
    uint salt = gabor_impl_salt(seed);
    GaborWindows none = GaborWindows(vec4(0.0), vec4(0.0));
    GaborAxis columns = gabor_impl_axis(node.x, place.period.x, salt, kernel.step_x,
                                        gabor_impl_windows(offset.x), none);
    GaborAxis rows = gabor_impl_axis(node.y, place.period.y, salt ^ GABOR_IMPL_ROWS, kernel.step_y,
                                     gabor_impl_windows(offset.y), none);
    vec2 base = gabor_impl_wave(dot(kernel.wave, offset * (1.0 / place.radius)));
    GaborSum sum = gabor_impl_sum(columns, rows, place.animated, place.time);

    // E[n^2] is half of E|A|^2 times the sums of squared windows along x and y; exp' = 2 pi i F exp.
    base *= 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    vec2 value = gabor_impl_product(vec2(sum.real.x, sum.imaginary.x), base);
    vec2 turned = 6.2831853 * vec2(-value.y, value.x);
    vec2 stretch = place.radius / GABOR_RADIUS;
    return GaborField(value, stretch.x * gabor_impl_product(vec2(sum.slope_real.x, sum.slope_imaginary.x), base) + kernel.wave.x * turned,
                      stretch.y * gabor_impl_product(sum.slope_y, base) + kernel.wave.y * turned,
                      base.x * sum.imaginary + base.y * sum.real);
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// (cell + local) / GABOR_RADIUS kernel radii, without periods, precise everywhere in a world of 2^32 cells each way.
GaborPlace gabor_place(ivec2 cell, vec2 local)
{
    return GaborPlace(cell, local, vec2(GABOR_RADIUS), ivec2(0), false, 0.0);
}

// p in a world that repeats after `period` kernel radii along each axis where that is positive, and is endless where it
// is 0: a whole number of nodes fits in a period, GABOR_TAPS at least.
GaborPlace gabor_place_tiled(vec2 p, vec2 period)
{
    vec2 nodes = max(floor(period * GABOR_RADIUS + 0.5), vec2(float(GABOR_TAPS)));
    GaborPlace place = gabor_place(ivec2(0), vec2(0.0));
    if (period.x > 0.0) {
        place.period.x = int(nodes.x);
        place.radius.x = nodes.x / period.x;
    }
    if (period.y > 0.0) {
        place.period.y = int(nodes.y);
        place.radius.y = nodes.y / period.y;
    }
    place.local = p * place.radius;
    return place;
}

// A kernel's wave where there are other than GABOR_RADIUS nodes per kernel radius, to fit a period.
GaborKernel gabor_kernel_stretched(GaborKernel kernel, vec2 radius)
{
    vec2 step = kernel.wave / radius;
    return GaborKernel(kernel.wave, gabor_impl_wave(step.x), gabor_impl_wave(step.y));
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise.
GaborKernel gabor_kernel(float frequency, float orientation)
{
    vec2 wave = min(abs(frequency), 1.0e6) * gabor_impl_wave(0.15915494 * orientation);
    return gabor_kernel_stretched(GaborKernel(wave, vec2(0.0), vec2(0.0)), vec2(GABOR_RADIUS));
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere.
float gabor_noise_at(ivec2 cell, vec2 local, GaborKernel kernel, uint seed)
{
    return gabor_field(gabor_place(cell, local), kernel, seed).value.y;
}

// Gabor noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p            position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float
//                steps by 0.008.
//   frequency    cycles per kernel radius; its magnitude is used, up to 10^6
//   orientation  direction of the wave vector in radians from +x towards +y, precise within +-400
//   seed         any; each seed is another instance, independent of the others
// Frequency and orientation may vary from place to place: where they are continuous so is the noise, for each wave
// turns about its own node. A slope of theirs adds to that of the noise.
float gabor_noise(vec2 p, float frequency, float orientation, uint seed)
{
    return gabor_noise_at(ivec2(0), p * GABOR_RADIUS, gabor_kernel(frequency, orientation), seed);
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
// Second derivatives jump on the lines where windows end, midway between nodes for 3 taps and at nodes for 4: by 0.16
// of their deviation at frequency 1, by 1.1 of it at 0.
vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, uint seed)
{
    GaborField field = gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed);
    return vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent.
vec2 gabor_noise_complex(vec2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).value;
}

// Four noises at p, independent of each other, for colours or displacement along vectors; the first is gabor_noise.
vec4 gabor_noise_four(vec2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
vec2 gabor_phasor(vec2 value)
{
    float intensity = length(value);
    float phase = intensity > 0.0 ? atan(value.y, value.x) * 0.15915494 : 0.0;
    return vec2(phase < 0.0 ? min(phase + 1.0, 0.99999994) : phase, intensity);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation,
// with the law of gabor_noise: windows become a little wider or narrower, so that a whole number of nodes fits.
// Each period is at least 1/1024; from 2 up windows change by a sixth at most, shorter ones make them as narrow.
float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, uint seed)
{
    GaborPlace place = gabor_place_tiled(p, max(period, vec2(0.0009765625)));
    GaborKernel kernel = gabor_kernel_stretched(gabor_kernel(frequency, orientation), place.radius);
    return gabor_field(place, kernel, seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1; at time 0 it is
// gabor_noise. At every time it has the law of gabor_noise, and at all times and places together; its correlation with
// itself falls with the time between as cos^2(pi time): 1/2 after a quarter of the period, 0 after half of it.
float gabor_noise_animated(vec2 p, float time, float frequency, float orientation, uint seed)
{
    GaborPlace place = GaborPlace(ivec2(0), p * GABOR_RADIUS, vec2(GABOR_RADIUS), ivec2(0), true, time);
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
float gabor_unorm(float noise)
{
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

#endif // GABOR_LATTICE_GLSL
// ---- mine ----

void mainImage(out vec4 color, vec2 pixel)
{
    vec2 p = pixel / 32.0; // 32 pixels to the kernel radius
    float frequency = 4.0;
    float orientation = 0.7854;
    if (iMouse.z > 0.0) {
        frequency = 8.0 * iMouse.x / iResolution.x;
        orientation = 3.1416 * iMouse.y / iResolution.y;
    }
    float n = gabor_noise(p, frequency, orientation, 7u);
    color = vec4(vec3(gabor_unorm(n)), 1.0);
}
