// gabor_noise.metal: fast, normalized Gabor noise in two dimensions, for the Metal shading language.
//
// Made from shaders/gabor_noise.glsl: change that file, not this one.
// By tools/translate, glslang 11:12.0.0, SPIRV-Cross 2021.01.15+1.3.239.0-1.
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                the noise, and to show it
//     gabor_noise_gradient                    with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor       with its quadrature: phase and intensity
//     gabor_noise_four                        four uncorrelated ones at once
//     gabor_noise_tiled, gabor_noise_animated with exact periods in space, and in time
//     gabor_kernel, gabor_field               all of it by integer cell and local offset, for large worlds
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

#ifndef GABOR_NOISE_METAL
#define GABOR_NOISE_METAL

#define GABOR_NOISE_VERSION 100

#include <metal_stdlib>

using namespace metal;

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project), the salt entering between them too, so that no two sequences share a run.
static inline __attribute__((always_inline))
uint gabor_mix(uint word, uint salt)
{
    word = ((word ^ (word >> 16u)) * 569420461u) + salt;
    word = (word ^ (word >> 15u)) * 3545902487u;
    return word ^ (word >> 15u);
}

// The word of `seed`, from which those of the rows follow.
static inline __attribute__((always_inline))
uint gabor_seed_word(uint seed)
{
    uint param = seed * 2654435761u;
    uint _192 = gabor_mix(param, 625341585u);
    return _192;
}

// The word of a row of cells, from which those of its impulses follow.
static inline __attribute__((always_inline))
uint gabor_row_word(int row, uint seed_word)
{
    uint param = (uint(row) * 2654435761u) + seed_word;
    uint _199 = gabor_mix(param, seed_word);
    return _199;
}

// The word of impulse `index` in a cell; everything about the impulse is in its bits:
//     0 to 22   y in the cell            8 to 30   x in the cell
//     0 to 7    phase                    31        magnitude
//     8 to 10   turns of its phase while time goes by 1
// so the finest bits of a coordinate serve twice. Within 1/256 of a cell, far below what shows, x follows y.
static inline __attribute__((always_inline))
uint gabor_impulse_word(int column, uint row_word, int index)
{
    uint salt = row_word + (uint(index) * 2246822507u);
    uint param = (uint(column) * 2654435761u) + salt;
    uint _213 = gabor_mix(param, salt);
    return _213;
}

// Place of an impulse in its cell, plus 1: in [1, 2)^2.
static inline __attribute__((always_inline))
float2 gabor_place_plus_one(uint word)
{
    return float2(as_type<float>(1065353216u | ((word >> 8u) & 8388607u)), as_type<float>(1065353216u | (word & 8388607u)));
}

// Phase of the impulse at that place, in turns.
static inline __attribute__((always_inline))
float gabor_phase(float2 place_plus_one)
{
    return fract(place_plus_one.y * 32768.0);
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
static inline __attribute__((always_inline))
float gabor_tempo(uint word)
{
    float turns = float((word >> 8u) & 7u) - 4.0;
    float _247;
    if (turns < 0.0)
    {
        _247 = turns;
    }
    else
    {
        _247 = turns + 1.0;
    }
    return _247;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
static inline __attribute__((always_inline))
float4 gabor_four(float2 wave, uint word)
{
    uint param = word;
    uint _260 = gabor_mix(param, 2246822507u);
    uint quarters = _260;
    float _267;
    if ((quarters & 1u) == 0u)
    {
        _267 = wave.y;
    }
    else
    {
        _267 = wave.x;
    }
    float _278;
    if ((quarters & 2u) == 0u)
    {
        _278 = wave.y;
    }
    else
    {
        _278 = wave.x;
    }
    float _289;
    if ((quarters & 4u) == 0u)
    {
        _289 = wave.y;
    }
    else
    {
        _289 = wave.x;
    }
    float _299;
    if ((quarters & 8u) == 0u)
    {
        _299 = wave.y;
    }
    else
    {
        _299 = wave.x;
    }
    float4 shifted = float4(_267, _278, _289, _299);
    return shifted * float4(((quarters & 16u) == 0u) ? 1.0 : (-1.0), ((quarters & 32u) == 0u) ? 1.0 : (-1.0), ((quarters & 64u) == 0u) ? 1.0 : (-1.0), ((quarters & 128u) == 0u) ? 1.0 : (-1.0));
}

// Magnitude of an impulse's weight.
static inline __attribute__((always_inline))
float gabor_magnitude(uint word)
{
    return (int(word) < 0) ? 1.0 : 0.675000011920928955078125;
}

// sin(2 pi t) for any t: reduced to half a turn, then t (1/4 - t^2) times a minimax polynomial in t^2.
// Absolute error below 3e-7 within +-1, growing with the rounding of t beyond.
static inline __attribute__((always_inline))
float gabor_sin_turns(float t)
{
    t = fract(t) - 0.5;
    if (false)
    {
        return -sin(6.283185482025146484375 * t);
    }
    float s = t * t;
    float p = (12.233303070068359375 * s) - 38.123195648193359375;
    p = (p * s) + 67.0438995361328125;
    p = (p * s) - 64.83467864990234375;
    p = (p * s) + 25.1327304840087890625;
    return (t * (s - 0.25)) * p;
}

// The unit vector at an angle in radians: reduced by pi/2 in three steps, then minimax polynomials. Its error stays
// near 1e-7, for a large frequency multiplies it.
static inline __attribute__((always_inline))
float2 gabor_direction(float angle)
{
    float quarter = floor((angle * 0.636619746685028076171875) + 0.5);
    float r = angle - (quarter * 1.5703125);
    r -= (quarter * 0.0004837512969970703125);
    r -= (quarter * 7.5497901264043321134522557258606e-08);
    r = (abs(r) < 1.0) ? r : 0.0;
    float s = r * r;
    float sine = r + ((r * s) * ((-0.1666665375232696533203125) + (s * (0.00833216123282909393310546875 - (s * 0.00019515295571181923151016235351562)))));
    float cosine = (1.0 - (0.5 * s)) + ((s * s) * (0.0416666455566883087158203125 + (s * ((-0.00138873164542019367218017578125) + (s * 2.4433156795566901564598083496094e-05)))));
    float2 _454;
    if (fract(0.5 * quarter) < 0.25)
    {
        _454 = float2(cosine, sine);
    }
    else
    {
        _454 = float2(-sine, cosine);
    }
    float2 axis = _454;
    float2 _471;
    if (fract(0.25 * quarter) < 0.375)
    {
        _471 = axis;
    }
    else
    {
        _471 = -axis;
    }
    return _471;
}

// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). The five c_n I_n, whose sum is the energy of one axis:
struct GaborEnergy
{
    float4 e4567;
    float e8;
    float sum;
};

static inline __attribute__((always_inline))
GaborEnergy gabor_energy()
{
    float3 c = float3(3.0, -4.5, 2.5);
    GaborEnergy energy;
    energy.e4567 = float4(c.x * c.x, (2.0 * c.x) * c.y, (c.y * c.y) + ((2.0 * c.x) * c.z), (2.0 * c.y) * c.z) * float4(0.812698423862457275390625, 0.738816738128662109375, 0.6819846630096435546875, 0.636519014835357666015625);
    energy.e8 = (c.z * c.z) * 0.599076747894287109375;
    energy.sum = dot(energy.e4567, float4(1.0)) + energy.e8;
    return energy;
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the share by which one axis
// of a sine kernel of k cycles falls short of its energy at high frequency. For small a from 1 - L_n by the power
// series of L_7 and L_8 and downward recurrence; for large a by upward recurrence from L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
static inline __attribute__((always_inline))
float gabor_deficit(float k, GaborEnergy energy)
{
    float a = 12.56637096405029296875 * k;
    float z = a * a;
    float d8 = 0.0;
    float4 d4567;
    if (z < 64.0)
    {
        float d7 = 0.0;
        float term7 = 1.0;
        float term8 = 1.0;
        for (int i = 1; i <= 14; i++)
        {
            float n = float(i);
            term7 *= (((-0.25) * z) / (n * (n + 7.5)));
            term8 *= (((-0.25) * z) / (n * (n + 8.5)));
            d7 -= term7;
            d8 -= term8;
        }
        float d6 = d7 + ((z * (1.0 - d8)) * 0.0039215688593685626983642578125);
        float d5 = d6 + ((z * (1.0 - d7)) * 0.0051282052882015705108642578125);
        float d4 = d5 + ((z * (1.0 - d6)) * 0.0069930069148540496826171875);
        d4567 = float4(d4, d5, d6, d7);
    }
    else
    {
        float y = 1.0 / z;
        float param = 2.0 * k;
        float _646 = gabor_sin_turns(param);
        float l0 = _646 / a;
        float param_1 = (2.0 * k) + 0.25;
        float _656 = gabor_sin_turns(param_1);
        float l1 = (3.0 * y) * (l0 - _656);
        float l2 = (15.0 * y) * (l1 - l0);
        float l3 = (35.0 * y) * (l2 - l1);
        float l4 = (63.0 * y) * (l3 - l2);
        float l5 = (99.0 * y) * (l4 - l3);
        float l6 = (143.0 * y) * (l5 - l4);
        float l7 = (195.0 * y) * (l6 - l5);
        d8 = 1.0 - ((255.0 * y) * (l7 - l6));
        d4567 = float4(1.0) - float4(l4, l5, l6, l7);
    }
    return (dot(energy.e4567, d4567) + (energy.e8 * d8)) / energy.sum;
}

// A Gabor kernel ready to be summed: all that the noise needs to know of its frequency and orientation.
struct GaborKernel
{
    float2 wave;
    float amplitude;
    float deficit;
};

// The kernel of a frequency and an orientation, with the ranges of gabor_noise. Make it once where they do not vary.
//
// There are N R^2 impulses per unit area, so by Campbell's theorem, with a = 4 pi F omega,
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] (J(0)^2 - J(a.x) J(a.y)) / 2,
// where four or more phases average the sin^2 to 1/2 and leave J(0)^2 alone.
static inline __attribute__((always_inline))
GaborKernel gabor_kernel(float frequency, float orientation)
{
    float magnitude = abs(frequency);
    float _738;
    if (magnitude > 9.9999999747524270787835121154785e-07)
    {
        _738 = fast::min(magnitude, 1000000.0);
    }
    else
    {
        _738 = 9.9999999747524270787835121154785e-07;
    }
    magnitude = _738;
    GaborKernel kernel0;
    kernel0.wave = gabor_direction(orientation) * magnitude;
    float density = 1.0;
    float power = 0.7278125286102294921875;
    GaborEnergy energy = gabor_energy();
    kernel0.deficit = 1.0;
    if (false)
    {
        float x = gabor_deficit(kernel0.wave.x, energy);
        float y = gabor_deficit(kernel0.wave.y, energy);
        kernel0.deficit = (x + y) - (x * y);
    }
    kernel0.amplitude = rsqrt(((((0.5 * density) * power) * energy.sum) * energy.sum) * kernel0.deficit);
    return kernel0;
}

// The window q along one axis, 0 from |x| = 1 on.
static inline __attribute__((always_inline))
float gabor_window(float x)
{
    float3 c = float3(3.0, -4.5, 2.5);
    float u = fast::max(1.0 - (x * x), 0.0);
    return (u * u) * (c.x + (u * (c.y + (u * c.z))));
}

// Its derivative.
static inline __attribute__((always_inline))
float gabor_window_slope(float x)
{
    float3 c = float3(3.0, -4.5, 2.5);
    float u = fast::max(1.0 - (x * x), 0.0);
    return (((-2.0) * x) * u) * ((2.0 * c.x) + (u * ((3.0 * c.y) + (u * (4.0 * c.z)))));
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace
{
    int2 cell;
    float2 local;
    float2 radius;
    int2 period;
    float time;
};

// (cell + local) / GABOR_RADIUS kernel radii, without periods, at time 0: full precision everywhere in a world of 2^32
// cells each way, where it wraps around.
static inline __attribute__((always_inline))
GaborPlace gabor_place(int2 cell, float2 local)
{
    return GaborPlace{ cell, local, float2(1.0), int2(0), 0.0 };
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part is the same with cosines
// for sines, and its gradient. Parts that are not used cost nothing: compilers leave them out.
struct GaborField
{
    float2 value;
    float2 slope_x;
    float2 slope_y;
    float4 four;
};

// A cell's coordinate within a period.
static inline __attribute__((always_inline))
int gabor_wrap(int cell, int period)
{
    if (period == 0)
    {
        return cell;
    }
    int within = cell - ((cell / period) * period);
    int _861;
    if (within < 0)
    {
        _861 = within + period;
    }
    else
    {
        _861 = within;
    }
    return _861;
}

// What a sine kernel's amplitude gains while time turns the phases: of J(0)^2 - J(a.x) J(a.y), gabor_kernel, the second
// term is taken times 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the tempos k.
static inline __attribute__((always_inline))
float gabor_tempo_gain(GaborKernel kernel0, float time)
{
    if (true)
    {
        return 1.0;
    }
    float param = time;
    float _877 = gabor_sin_turns(param);
    float param_1 = 2.0 * time;
    float _880 = gabor_sin_turns(param_1);
    float param_2 = 3.0 * time;
    float _883 = gabor_sin_turns(param_2);
    float param_3 = 4.0 * time;
    float _886 = gabor_sin_turns(param_3);
    float4 sines = float4(_877, _880, _883, _886);
    float u = 0.5 * dot(sines, sines);
    return rsqrt(1.0 + ((u * (1.0 - kernel0.deficit)) / kernel0.deficit));
}

// The noise at a place, by its cell: what all functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
static inline __attribute__((always_inline))
GaborField gabor_field(GaborPlace place, GaborKernel kernel0, uint seed)
{
    int visited = 3;
    float2 whole = floor(place.local);
    float2 local = place.local - whole;
    float2 first = floor(local - place.radius);
    int2 cell = place.cell + int2(whole + first);
    first -= float2(1.0);
    float2 cell_side = float2(1.0) / place.radius;
    float time = fract(place.time);
    uint seed_word = gabor_seed_word(seed);
    GaborField sum = GaborField{ float2(0.0), float2(0.0), float2(0.0), float4(0.0) };
    for (int j = 0; j < visited; j++)
    {
        uint row_word = gabor_row_word(gabor_wrap(cell.y + j, place.period.y), seed_word);
        for (int i = 0; i < visited; i++)
        {
            int column = gabor_wrap(cell.x + i, place.period.x);
            for (int k = 0; k < 1; k++)
            {
                uint word = gabor_impulse_word(column, row_word, k);
                float2 impulse = gabor_place_plus_one(word);
                float2 d = (local - (impulse + (first + float2(float(i), float(j))))) * cell_side;
                if (fast::max(abs(d.x), abs(d.y)) < 1.0)
                {
                    float turns = (dot(kernel0.wave, d) + gabor_phase(impulse)) + (gabor_tempo(word) * time);
                    float magnitude = gabor_magnitude(word);
                    float2 window = float2(gabor_window(d.x), gabor_window(d.y));
                    float param = turns + 0.25;
                    float _1045 = gabor_sin_turns(param);
                    float param_1 = turns;
                    float _1048 = gabor_sin_turns(param_1);
                    float2 wave = float2(_1045, _1048) * magnitude;
                    sum.value += (wave * (window.x * window.y));
                    sum.slope_x += (wave * (gabor_window_slope(d.x) * window.y));
                    sum.slope_y += (wave * (gabor_window_slope(d.y) * window.x));
                    sum.four += (gabor_four(wave, word) * (window.x * window.y));
                }
            }
        }
    }
    float scale = (kernel0.amplitude * 1.0) * rsqrt(place.radius.x * place.radius.y);
    if (time != 0.0)
    {
        scale *= gabor_tempo_gain(kernel0, time);
    }
    float2 turned = float2(-sum.value.y, sum.value.x) * 6.283185482025146484375;
    return GaborField{ sum.value * scale, (sum.slope_x + (turned * kernel0.wave.x)) * scale, (sum.slope_y + (turned * kernel0.wave.y)) * scale, sum.four * scale };
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
static inline __attribute__((always_inline))
float gabor_noise_at(int2 cell, float2 local, GaborKernel kernel0, uint seed)
{
    return gabor_field(gabor_place(cell, local), kernel0, seed).value.y;
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
static inline __attribute__((always_inline))
float gabor_noise(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_noise_at(int2(0), p * 1.0, gabor_kernel(frequency, orientation), seed);
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
static inline __attribute__((always_inline))
float3 gabor_noise_gradient(float2 p, float frequency, float orientation, uint seed)
{
    GaborField field = gabor_field(gabor_place(int2(0), p * 1.0), gabor_kernel(frequency, orientation), seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent; with GABOR_PHASES 2 the real part's variance is 1 only
// from frequency 1.5 up.
static inline __attribute__((always_inline))
float2 gabor_noise_complex(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * 1.0), gabor_kernel(frequency, orientation), seed).value;
}

// Four noises at p from one traversal, for colours and for displacement along vectors: each as gabor_noise,
// uncorrelated with each other. With GABOR_PHASES 2 their variance is 1 only from frequency 1.5 up.
static inline __attribute__((always_inline))
float4 gabor_noise_four(float2 p, float frequency, float orientation, uint seed)
{
    return gabor_field(gabor_place(int2(0), p * 1.0), gabor_kernel(frequency, orientation), seed).four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
static inline __attribute__((always_inline))
float2 gabor_phasor(float2 value)
{
    float intensity = length(value);
    float _1199;
    if (intensity > 0.0)
    {
        _1199 = precise::atan2(value.y, value.x) * 0.15915493667125701904296875;
    }
    else
    {
        _1199 = 0.0;
    }
    float phase = _1199;
    float _1211;
    if (phase < 0.0)
    {
        _1211 = fast::min(phase + 1.0, 0.999999940395355224609375);
    }
    else
    {
        _1211 = phase;
    }
    return float2(_1211, intensity);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation.
// Mean and variance are those of gabor_noise. So is the rest of the law where period * R is whole; where it is not,
// cells grow until a whole number fits, and the fewer they become the less normal the values are: cvm 0.6 with 5 %
// fewer cells per radius, 2.2 with 10 %. Each period is at least 2, a kernel's diameter; a shorter one is taken as 2.
static inline __attribute__((always_inline))
float gabor_noise_tiled(float2 p, float2 period, float frequency, float orientation, uint seed)
{
    period = fast::max(period, float2(2.0));
    float2 cells = floor(period * 1.0);
    float2 radius = cells / period;
    float2 within = p - (floor(p / period) * period);
    GaborPlace place = GaborPlace{ int2(0), within * radius, radius, int2(cells), 0.0 };
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance; after a tenth of the period it has little in common with what it was.
static inline __attribute__((always_inline))
float gabor_noise_animated(float2 p, float time, float frequency, float orientation, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * 1.0);
    place.time = time;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
static inline __attribute__((always_inline))
float gabor_unorm(float _noise)
{
    return fast::clamp(0.5 + (0.25 * _noise), 0.0, 1.0);
}

#endif // GABOR_NOISE_METAL
