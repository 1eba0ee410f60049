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
//     gabor_noise_spread                      waves of many orientations and frequencies, up to isotropic
//     gabor_noise_lobes, gabor_noise_sum      any spectrum, as a list of lobes
//     gabor_noise_filtered                    without aliasing, whatever a pixel covers
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

#define GABOR_NOISE_VERSION 10000

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
    uint _317 = gabor_mix(param, 625341585u);
    return _317;
}

// The word of a row of cells, from which those of its impulses follow.
static inline __attribute__((always_inline))
uint gabor_row_word(int row, uint seed_word)
{
    uint param = (uint(row) * 2654435761u) + seed_word;
    uint _324 = gabor_mix(param, seed_word);
    return _324;
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
    uint _338 = gabor_mix(param, salt);
    return _338;
}

// Place of an impulse in its cell, plus 1: in [1, 2)^2.
static inline __attribute__((always_inline))
float2 gabor_place_plus_one(uint word)
{
    return float2(as_type<float>(1065353216u | ((word >> 8u) & 8388607u)), as_type<float>(1065353216u | (word & 8388607u)));
}

// Phase of the impulse at that place, in turns.
static inline __attribute__((always_inline))
float gabor_phase(float2 place_plus_one, float phases)
{
    return fract(place_plus_one.y * (8388608.0 / phases));
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
static inline __attribute__((always_inline))
float gabor_tempo(uint word)
{
    float turns = float((word >> 8u) & 7u) - 4.0;
    float _372;
    if (turns < 0.0)
    {
        _372 = turns;
    }
    else
    {
        _372 = turns + 1.0;
    }
    return _372;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
static inline __attribute__((always_inline))
float4 gabor_four(float2 wave, uint word)
{
    uint param = word;
    uint _385 = gabor_mix(param, 2246822507u);
    uint quarters = _385;
    float _392;
    if ((quarters & 1u) == 0u)
    {
        _392 = wave.y;
    }
    else
    {
        _392 = wave.x;
    }
    float _403;
    if ((quarters & 2u) == 0u)
    {
        _403 = wave.y;
    }
    else
    {
        _403 = wave.x;
    }
    float _414;
    if ((quarters & 4u) == 0u)
    {
        _414 = wave.y;
    }
    else
    {
        _414 = wave.x;
    }
    float _424;
    if ((quarters & 8u) == 0u)
    {
        _424 = wave.y;
    }
    else
    {
        _424 = wave.x;
    }
    float4 shifted = float4(_392, _403, _414, _424);
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
    float2 _579;
    if (fract(0.5 * quarter) < 0.25)
    {
        _579 = float2(cosine, sine);
    }
    else
    {
        _579 = float2(-sine, cosine);
    }
    float2 axis = _579;
    float2 _596;
    if (fract(0.25 * quarter) < 0.375)
    {
        _596 = axis;
    }
    else
    {
        _596 = -axis;
    }
    return _596;
}

// Product of complex numbers.
static inline __attribute__((always_inline))
float2 gabor_times(float2 a, float2 b)
{
    return float2((a.x * b.x) - (a.y * b.y), (a.x * b.y) + (a.y * b.x));
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
        float _788 = gabor_sin_turns(param);
        float l0 = _788 / a;
        float param_1 = (2.0 * k) + 0.25;
        float _798 = gabor_sin_turns(param_1);
        float l1 = (3.0 * y) * (l0 - _798);
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

// Waves around one frequency and orientation.
struct GaborLobe
{
    float2 wave;
    float2 spread;
    float power;
};

// The lobe of a frequency and an orientation, with the ranges of gabor_noise, and
//   frequency_spread    a share of the frequency, within [0, 1]
//   orientation_spread  radians: pi/2 and more is every direction, isotropic
//   power               in any unit, up to 10^9
// What is less than 0 or NaN counts as 0.
static inline __attribute__((always_inline))
GaborLobe gabor_lobe(float frequency, float orientation, float frequency_spread, float orientation_spread, float power)
{
    float magnitude = abs(frequency);
    float _880;
    if (magnitude > 9.9999999747524270787835121154785e-07)
    {
        _880 = fast::min(magnitude, 1000000.0);
    }
    else
    {
        _880 = 9.9999999747524270787835121154785e-07;
    }
    magnitude = _880;
    GaborLobe lobe;
    lobe.wave = gabor_direction(orientation) * magnitude;
    float _895;
    if (frequency_spread > 0.0)
    {
        _895 = fast::min(frequency_spread, 1.0);
    }
    else
    {
        _895 = 0.0;
    }
    lobe.spread.x = _895;
    float _903;
    if (orientation_spread > 0.0)
    {
        _903 = 0.15915493667125701904296875 * fast::min(orientation_spread, 1.5707962512969970703125);
    }
    else
    {
        _903 = 0.0;
    }
    lobe.spread.y = _903;
    float _914;
    if (power > 0.0)
    {
        _914 = fast::min(power, 1000000000.0);
    }
    else
    {
        _914 = 0.0;
    }
    lobe.power = _914;
    return lobe;
}

// A spectrum: what gabor_noise_lobes and gabor_noise_sum take.
struct GaborLobes
{
    GaborLobe lobe[1];
    int count;
};

// Gabor kernels ready to be summed: all that the noise needs to know of its spectrum.
struct GaborKernel
{
    GaborLobes lobes;
    float phases;
    float amplitude;
    float deficit;
};

// The kernels of some lobes' spectrum: each impulse has a wave of one lobe, chosen with a probability in proportion to
// its power, so that many lobes have the impulses of one. The variance is 1 whatever the powers. Impulses have 256
// phases, even where GABOR_PHASES is 2: then the variance depends on no frequency.
//
// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
static inline __attribute__((always_inline))
GaborKernel gabor_kernel_lobes(const GaborLobes lobes)
{
    GaborKernel kernel0;
    kernel0.lobes = lobes;
    kernel0.lobes.count = clamp(lobes.count, 1, 1);
    float together = 0.0;
    float _945;
    for (int i = 0; i < 1; i++)
    {
        if (i < kernel0.lobes.count)
        {
            _945 = lobes.lobe[i].power;
        }
        else
        {
            _945 = 0.0;
        }
        together += _945;
        kernel0.lobes.lobe[i].power = together;
    }
    kernel0.phases = 256.0;
    kernel0.deficit = 1.0;
    float density = 1.0;
    float power = 0.7278125286102294921875;
    float energy = gabor_energy().sum;
    kernel0.amplitude = rsqrt((((0.5 * density) * power) * energy) * energy);
    return kernel0;
}

// The kernel of one lobe.
static inline __attribute__((always_inline))
GaborKernel gabor_kernel_lobe(GaborLobe lobe)
{
    GaborLobes lobes;
    for (int i = 0; i < 1; i++)
    {
        lobes.lobe[i] = lobe;
    }
    lobes.count = 1;
    GaborLobes param = lobes;
    return gabor_kernel_lobes(param);
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise. Make it once where they do not vary.
//
// With two phases the sin^2 of gabor_kernel_lobes does not average to 1/2: with a = 4 pi F omega,
//     J(0)^2 - J(a.x) J(a.y)   takes the place of   J(0)^2.
static inline __attribute__((always_inline))
GaborKernel gabor_kernel(float frequency, float orientation)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, 0.0, 0.0, 1.0);
    GaborKernel kernel0 = gabor_kernel_lobe(lobe);
    kernel0.phases = 256.0;
    if (false)
    {
        GaborEnergy energy = gabor_energy();
        float x = gabor_deficit(lobe.wave.x, energy);
        float y = gabor_deficit(lobe.wave.y, energy);
        kernel0.deficit = (x + y) - (x * y);
        kernel0.amplitude *= rsqrt(kernel0.deficit);
    }
    return kernel0;
}

// A wave vector within a lobe's spread, as that is written.
static inline __attribute__((always_inline))
float2 gabor_within(GaborLobe lobe, float2 spread)
{
    float param = spread.y + 0.25;
    float _1044 = gabor_sin_turns(param);
    float param_1 = spread.y;
    float _1047 = gabor_sin_turns(param_1);
    float2 turn = float2(_1044, _1047);
    return gabor_times(lobe.wave, turn) * (1.0 + spread.x);
}

// The wave vector of the impulse that has this word.
static inline __attribute__((always_inline))
float2 gabor_wave(const GaborKernel kernel0, uint word)
{
    GaborLobe lobe = kernel0.lobes.lobe[0];
    uint param = word;
    uint _1062 = gabor_mix(param, 2654435761u);
    uint choice = _1062;
    if (kernel0.lobes.count > 1)
    {
        float chosen = kernel0.lobes.lobe[0].power * ((float(choice >> 16u) + 0.5) / 65536.0);
        for (int i = 1; i < 1; i++)
        {
            bool _1089 = i < kernel0.lobes.count;
            bool _1098;
            if (_1089)
            {
                _1098 = chosen >= kernel0.lobes.lobe[i - 1].power;
            }
            else
            {
                _1098 = _1089;
            }
            if (_1098)
            {
                lobe = kernel0.lobes.lobe[i];
            }
        }
    }
    bool _1108 = lobe.spread.x == 0.0;
    bool _1114;
    if (_1108)
    {
        _1114 = lobe.spread.y == 0.0;
    }
    else
    {
        _1114 = _1108;
    }
    if (_1114)
    {
        return lobe.wave;
    }
    float2 drawn = float2(float((choice * 2654435761u) >> 16u), float(choice & 65535u));
    return gabor_within(lobe, lobe.spread * (((drawn + float2(0.5)) / float2(32768.0)) - float2(1.0)));
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
    int _1210;
    if (within < 0)
    {
        _1210 = within + period;
    }
    else
    {
        _1210 = within;
    }
    return _1210;
}

// What a sine kernel's amplitude gains while time turns the phases: of J(0)^2 - J(a.x) J(a.y), gabor_kernel, the second
// term is taken times 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the tempos k.
static inline __attribute__((always_inline))
float gabor_tempo_gain(const GaborKernel kernel0, float time)
{
    if ((kernel0.phases != 2.0) || (time == 0.0))
    {
        return 1.0;
    }
    float param = time;
    float _1230 = gabor_sin_turns(param);
    float param_1 = 2.0 * time;
    float _1233 = gabor_sin_turns(param_1);
    float param_2 = 3.0 * time;
    float _1236 = gabor_sin_turns(param_2);
    float param_3 = 4.0 * time;
    float _1239 = gabor_sin_turns(param_3);
    float4 sines = float4(_1230, _1233, _1236, _1239);
    float u = 0.5 * dot(sines, sines);
    return rsqrt(1.0 + ((u * (1.0 - kernel0.deficit)) / kernel0.deficit));
}

// What the sum of kernels is to be multiplied with: with fewer cells per radius there are fewer impulses.
static inline __attribute__((always_inline))
float gabor_scale(const GaborKernel kernel0, GaborPlace place)
{
    GaborKernel param = kernel0;
    return ((kernel0.amplitude * 1.0) * rsqrt(place.radius.x * place.radius.y)) * gabor_tempo_gain(param, fract(place.time));
}

// The noise at a place, by its cell: what most functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
static inline __attribute__((always_inline))
GaborField gabor_field(GaborPlace place, const GaborKernel kernel0, uint seed)
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
                    GaborKernel param = kernel0;
                    float2 cycles = gabor_wave(param, word);
                    float turns = (dot(cycles, d) + gabor_phase(impulse, kernel0.phases)) + (gabor_tempo(word) * time);
                    float magnitude = gabor_magnitude(word);
                    float2 window = float2(gabor_window(d.x), gabor_window(d.y));
                    float param_1 = turns + 0.25;
                    float _1422 = gabor_sin_turns(param_1);
                    float param_2 = turns;
                    float _1425 = gabor_sin_turns(param_2);
                    float2 wave = float2(_1422, _1425) * magnitude;
                    float2 turned = float2(-wave.y, wave.x) * ((6.283185482025146484375 * window.x) * window.y);
                    sum.value += (wave * (window.x * window.y));
                    sum.slope_x += ((wave * (gabor_window_slope(d.x) * window.y)) + (turned * cycles.x));
                    sum.slope_y += ((wave * (gabor_window_slope(d.y) * window.x)) + (turned * cycles.y));
                    sum.four += (gabor_four(wave, word) * (window.x * window.y));
                }
            }
        }
    }
    GaborKernel param_3 = kernel0;
    float scale = gabor_scale(param_3, place);
    return GaborField{ sum.value * scale, sum.slope_x * scale, sum.slope_y * scale, sum.four * scale };
}

// Even polynomial p0 + p1 x^2 + ... + p5 x^10.
struct GaborPolynomial
{
    float3 low;
    float3 high;
};

// P, by least squares: within 1.8 % of the default window in the root mean square, and closer to smoother ones.
static inline __attribute__((always_inline))
GaborPolynomial gabor_normal_window()
{
    float3 c = float3(3.0, -4.5, 2.5);
    GaborPolynomial p;
    p.low = ((float3(1.002895355224609375, 0.2277657687664031982421875, 0.057445429265499114990234375) * c.x) + (float3(1.0014522075653076171875, 0.11853905022144317626953125, 0.0179650001227855682373046875) * c.y)) + (float3(0.999785006046295166015625, 0.01664751954376697540283203125, -0.0276734195649623870849609375) * c.z);
    p.high = ((float3(-0.014669599942862987518310546875, -0.00010419000318506732583045959472656, 5.601000157184898853302001953125e-05) * c.x) + (float3(-0.0198055095970630645751953125, 0.00225160992704331874847412109375, -6.9039997470099478960037231445312e-05) * c.y)) + (float3(-0.0058468398638069629669189453125, 0.0013106199912726879119873046875, -5.5339998652925714850425720214844e-05) * c.z);
    return p;
}

// E[P(x + v)] as a polynomial of x, for v normal of this variance.
static inline __attribute__((always_inline))
GaborPolynomial gabor_averaged(GaborPolynomial p, float variance)
{
    float3 v = float3(1.0, variance, variance * variance) * variance;
    float2 w = v.yz * v.y;
    GaborPolynomial mean;
    mean.low.x = (p.low.x + dot(v, float3(p.low.y, 3.0 * p.low.z, 15.0 * p.high.x))) + dot(w, float2(105.0 * p.high.y, 945.0 * p.high.z));
    mean.low.y = (p.low.y + dot(v, float3(6.0 * p.low.z, 45.0 * p.high.x, 420.0 * p.high.y))) + ((w.x * 4725.0) * p.high.z);
    mean.low.z = p.low.z + dot(v, float3(15.0 * p.high.x, 210.0 * p.high.y, 3150.0 * p.high.z));
    mean.high.x = p.high.x + dot(v.xy, float2(28.0 * p.high.y, 630.0 * p.high.z));
    mean.high.y = p.high.y + ((45.0 * variance) * p.high.z);
    mean.high.z = p.high.z;
    return mean;
}

// A polynomial of a complex number.
static inline __attribute__((always_inline))
float2 gabor_polynomial(GaborPolynomial p, float2 z)
{
    float2 square = gabor_times(z, z);
    float2 sum = (square * p.high.z) + float2(p.high.y, 0.0);
    sum = gabor_times(sum, square) + float2(p.high.x, 0.0);
    sum = gabor_times(sum, square) + float2(p.low.z, 0.0);
    sum = gabor_times(sum, square) + float2(p.low.y, 0.0);
    return gabor_times(sum, square) + float2(p.low.x, 0.0);
}

// Symmetric matrices are (xx, yy, xy).
static inline __attribute__((always_inline))
float2 gabor_symmetric(float3 matrix, float2 v)
{
    return (matrix.xy * v) + (v.yx * matrix.z);
}

static inline __attribute__((always_inline))
float3 gabor_inverse(float3 matrix)
{
    return float3(matrix.yx, -matrix.z) / float3((matrix.x * matrix.y) - (matrix.z * matrix.z));
}

// What a pixel covers, and what windows become under it. Lengths are in kernel radii.
struct GaborFootprint
{
    float3 covariance;
    float3 widening;
    float3 _inverse;
    float amplitude;
    float2 reach;
    float2 joint;
    GaborPolynomial x;
    GaborPolynomial y;
};

// The footprint of a pixel, seen through a normal filter whose standard deviation is half a pixel.
//   dx, dy   steps from the pixel's place to its neighbours', dFdx(p) and dFdy(p), in kernel radii. Where they are NaN
//            or infinite or longer than 10^3, 10^3 is taken.
static inline __attribute__((always_inline))
GaborFootprint gabor_footprint(float2 dx, float2 dy)
{
    float3 unit = float3(1.0, 1.0, 0.0);
    float3 covariance = (float3(dx * dx, dx.x * dx.y) + float3(dy * dy, dy.x * dy.y)) * 0.25;
    if (!((covariance.x + covariance.y) < 250000.0))
    {
        dx = float2(1000.0, 0.0);
        dy = float2(0.0, 1000.0);
        covariance = unit * 250000.0;
    }
    GaborFootprint footprint;
    footprint.covariance = covariance;
    float mean = 0.5 * (covariance.x + covariance.y);
    float apart = length(float2(0.5 * (covariance.x - covariance.y), covariance.z));
    float larger = mean + apart;
    float side = 0.25 * ((dx.x * dy.y) - (dx.y * dy.x));
    float _1820;
    if (larger > 9.9999999600419720025001879548654e-13)
    {
        _1820 = fast::min((side / larger) * side, mean);
    }
    else
    {
        _1820 = 0.0;
    }
    float smaller = _1820;
    float2 kept = fast::min(float2(larger, smaller), float2(0.25));
    float3 _1841;
    if (apart > 0.0)
    {
        _1841 = (covariance - (unit * mean)) / float3(apart);
    }
    else
    {
        _1841 = float3(0.0);
    }
    float3 direction = _1841;
    footprint.widening = ((unit * (kept.x + kept.y)) + (direction * (kept.x - kept.y))) * 0.5;
    float3 _1873 = footprint.widening;
    float2 _1875 = fast::max(_1873.xy, float2(0.0));
    footprint.widening.x = _1875.x;
    footprint.widening.y = _1875.y;
    footprint._inverse = gabor_inverse((unit * 0.1211040019989013671875) + footprint.widening);
    footprint.amplitude = 0.1211040019989013671875 * sqrt((footprint._inverse.x * footprint._inverse.y) - (footprint._inverse.z * footprint._inverse.z));
    footprint.reach = float2(1.04499995708465576171875) + (sqrt(footprint.widening.xy) * 1.5);
    float3 v = unit - (footprint._inverse * 0.1211040019989013671875);
    float2 variance = fast::max(v.xy, float2(0.0));
    float product = variance.x * variance.y;
    float _1931;
    if (product > 0.0)
    {
        _1931 = fast::min(abs(v.z) * rsqrt(product), 1.0);
    }
    else
    {
        _1931 = 0.0;
    }
    float correlation = _1931;
    footprint.joint = sqrt(variance * correlation) * float2(1.0, (v.z < 0.0) ? (-1.0) : 1.0);
    float2 rest = variance * (1.0 - correlation);
    footprint.x = gabor_averaged(gabor_normal_window(), rest.x);
    footprint.y = gabor_averaged(gabor_normal_window(), rest.y);
    return footprint;
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe taken as normal, of
// the variance B = integral(q'^2) / (4 pi^2 integral(q^2)) along each axis,
//     |1 + 8 pi^2 B S|^(-1/2) e^(-4 pi^2 F S (1 + 8 pi^2 B S)^-1 F).
static inline __attribute__((always_inline))
float gabor_kept(float2 wave, float3 covariance)
{
    float3 c = float3(3.0, -4.5, 2.5);
    float4 slope = float4((4.0 * c.x) * c.x, (12.0 * c.x) * c.y, ((9.0 * c.y) * c.y) + ((16.0 * c.x) * c.z), (24.0 * c.y) * c.z) * float4(0.15238095819950103759765625, 0.101587302982807159423828125, 0.07388167083263397216796875, 0.0568320564925670623779296875);
    float energy = 4.0 * (dot(slope, float4(1.0)) + (((16.0 * c.z) * c.z) * 0.0454656444489955902099609375));
    float3 widened = float3(1.0, 1.0, 0.0) + (covariance * ((2.0 * energy) / gabor_energy().sum));
    float2 slower = gabor_symmetric(gabor_inverse(widened), wave);
    float taken = 39.47841644287109375 * dot(wave, gabor_symmetric(covariance, slower));
    return exp(-fast::min(taken, 80.0)) * rsqrt((widened.x * widened.y) - (widened.z * widened.z));
}

// The share of its variance that all of a kernel's noise loses under the footprint: in [0, 1].
static inline __attribute__((always_inline))
float gabor_removed(const GaborKernel kernel0, GaborFootprint footprint)
{
    float kept = 0.0;
    float before = 0.0;
    for (int i = 0; i < 1; i++)
    {
        if (i >= kernel0.lobes.count)
        {
            break;
        }
        GaborLobe lobe = kernel0.lobes.lobe[i];
        float mean = 0.0;
        bool _2094 = lobe.spread.x == 0.0;
        bool _2100;
        if (_2094)
        {
            _2100 = lobe.spread.y == 0.0;
        }
        else
        {
            _2100 = _2094;
        }
        if (_2100)
        {
            mean = gabor_kept(lobe.wave, footprint.covariance);
        }
        else
        {
            for (int j = 0; j < 72; j++)
            {
                float2 within = lobe.spread * ((float2(float(j % 3), float(j / 3)) * float2(0.666666686534881591796875, 0.083333335816860198974609375)) - float2(0.666666686534881591796875, 0.958333313465118408203125));
                mean += (gabor_kept(gabor_within(lobe, within), footprint.covariance) / 72.0);
            }
        }
        kept += ((lobe.power - before) * mean);
        before = lobe.power;
    }
    float _2160;
    if (before > 0.0)
    {
        _2160 = fast::clamp(1.0 - (kept / before), 0.0, 1.0);
    }
    else
    {
        _2160 = 0.0;
    }
    return _2160;
}

// A kernel of amplitude 1 under a footprint, as (real, imaginary): at a distance d from an impulse of this phase.
static inline __attribute__((always_inline))
float2 gabor_kernel_filtered(float2 d, float2 wave, float phase, GaborFootprint footprint)
{
    float2 shift = gabor_symmetric(footprint.widening, wave * 6.283185482025146484375);
    float2 real = gabor_symmetric(footprint._inverse, d);
    float2 imaginary = gabor_symmetric(footprint._inverse, shift);
    float exponent = 0.5 * ((dot(shift, imaginary) - dot(wave * 6.283185482025146484375, shift)) - dot(d, real));
    real *= 0.347999989986419677734375;
    imaginary *= 0.347999989986419677734375;
    bool _2202 = exponent < (-20.0);
    bool _2211;
    if (!_2202)
    {
        _2211 = dot(imaginary, imaginary) > 40.0;
    }
    else
    {
        _2211 = _2202;
    }
    if (_2211)
    {
        return float2(0.0);
    }
    float2 window = float2(0.0);
    float _2228;
    float _2245;
    for (int i = -2; i <= 2; i++)
    {
        if (i == 0)
        {
            _2228 = 0.0;
        }
        else
        {
            _2228 = float(i) * ((abs(i) == 1) ? 1.35562622547149658203125 : 1.42848503589630126953125);
        }
        float point = _2228;
        if (i == 0)
        {
            _2245 = 0.533333301544189453125;
        }
        else
        {
            _2245 = (abs(i) == 1) ? 0.22207592427730560302734375 : 0.0112574100494384765625;
        }
        float weight = _2245;
        float2 v = footprint.joint * point;
        window += (gabor_times(gabor_polynomial(footprint.x, float2(real.x + v.x, imaginary.x)), gabor_polynomial(footprint.y, float2(real.y + v.y, imaginary.y))) * weight);
    }
    float amplitude = footprint.amplitude * exp(exponent);
    if ((footprint.widening.x + footprint.widening.y) < (footprint.covariance.x + footprint.covariance.y))
    {
        amplitude *= sqrt(gabor_kept(wave, footprint.covariance) / gabor_kept(wave, footprint.widening));
    }
    float turns = (dot(wave, d) - (dot(shift, real) / 2.1865484714508056640625)) + phase;
    float param = turns + 0.25;
    float _2324 = gabor_sin_turns(param);
    float param_1 = turns;
    float _2327 = gabor_sin_turns(param_1);
    return gabor_times(window, float2(_2324, _2327)) * amplitude;
}

// The noise at a place as a pixel sees it, (real, imaginary), as in gabor_field. Each part is within 2 % of a standard
// deviation, in the root mean square, of the noise seen through the filter, for footprints of up to a kernel radius; in
// larger ones it fades as it should, but is no smoother. Its variance is 1 - gabor_removed, within 1 %: for two phases
// from frequency 1.5 up.
// Cost: (2 reach R + 1)^2 N impulses on average, reach from 1 to 1.8, each about four times that of gabor_field.
static inline __attribute__((always_inline))
float2 gabor_field_filtered(GaborPlace place, const GaborKernel kernel0, GaborFootprint footprint, uint seed)
{
    float2 whole = floor(place.local);
    float2 local = place.local - whole;
    int2 first = int2(floor(local - (place.radius * footprint.reach)));
    int2 last = int2(floor(local + (place.radius * footprint.reach)));
    int2 cell = place.cell + int2(whole);
    float time = fract(place.time);
    uint seed_word = gabor_seed_word(seed);
    float2 sum = float2(0.0);
    for (int j = first.y; j <= last.y; j++)
    {
        uint row_word = gabor_row_word(gabor_wrap(cell.y + j, place.period.y), seed_word);
        for (int i = first.x; i <= last.x; i++)
        {
            int column = gabor_wrap(cell.x + i, place.period.x);
            for (int k = 0; k < 1; k++)
            {
                uint word = gabor_impulse_word(column, row_word, k);
                float2 impulse = gabor_place_plus_one(word);
                float2 d = (local - (impulse + (float2(float(i), float(j)) - float2(1.0)))) / place.radius;
                if (all(abs(d) < footprint.reach))
                {
                    float phase = gabor_phase(impulse, kernel0.phases) + (gabor_tempo(word) * time);
                    GaborKernel param = kernel0;
                    sum += (gabor_kernel_filtered(d, gabor_wave(param, word), phase, footprint) * gabor_magnitude(word));
                }
            }
        }
    }
    GaborKernel param_1 = kernel0;
    return sum * gabor_scale(param_1, place);
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
static inline __attribute__((always_inline))
float gabor_noise_at(int2 cell, float2 local, const GaborKernel kernel0, uint seed)
{
    GaborKernel param = kernel0;
    return gabor_field(gabor_place(cell, local), param, seed).value.y;
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
    GaborKernel param = gabor_kernel(frequency, orientation);
    return gabor_noise_at(int2(0), p * 1.0, param, seed);
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
static inline __attribute__((always_inline))
float3 gabor_noise_gradient(float2 p, float frequency, float orientation, uint seed)
{
    GaborKernel param = gabor_kernel(frequency, orientation);
    GaborField field = gabor_field(gabor_place(int2(0), p * 1.0), param, seed);
    return float3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent; with GABOR_PHASES 2 the real part's variance is 1 only
// from frequency 1.5 up.
static inline __attribute__((always_inline))
float2 gabor_noise_complex(float2 p, float frequency, float orientation, uint seed)
{
    GaborKernel param = gabor_kernel(frequency, orientation);
    return gabor_field(gabor_place(int2(0), p * 1.0), param, seed).value;
}

// Four noises at p from one traversal, for colours and for displacement along vectors: each as gabor_noise,
// uncorrelated with each other. With GABOR_PHASES 2 their variance is 1 only from frequency 1.5 up.
static inline __attribute__((always_inline))
float4 gabor_noise_four(float2 p, float frequency, float orientation, uint seed)
{
    GaborKernel param = gabor_kernel(frequency, orientation);
    return gabor_field(gabor_place(int2(0), p * 1.0), param, seed).four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
static inline __attribute__((always_inline))
float2 gabor_phasor(float2 value)
{
    float intensity = length(value);
    float _2529;
    if (intensity > 0.0)
    {
        _2529 = precise::atan2(value.y, value.x) * 0.15915493667125701904296875;
    }
    else
    {
        _2529 = 0.0;
    }
    float phase = _2529;
    float _2540;
    if (phase < 0.0)
    {
        _2540 = fast::min(phase + 1.0, 0.999999940395355224609375);
    }
    else
    {
        _2540 = phase;
    }
    return float2(_2540, intensity);
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
    GaborKernel param = gabor_kernel(frequency, orientation);
    return gabor_field(place, param, seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance; after a tenth of the period it has little in common with what it was.
static inline __attribute__((always_inline))
float gabor_noise_animated(float2 p, float time, float frequency, float orientation, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * 1.0);
    place.time = time;
    GaborKernel param = gabor_kernel(frequency, orientation);
    return gabor_field(place, param, seed).value.y;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` of the frequency, both evenly spread. pi/2 radians are every direction: isotropic noise. As
// gabor_noise, with the ranges of gabor_lobe.
static inline __attribute__((always_inline))
float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread, float orientation_spread, uint seed)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, frequency_spread, orientation_spread, 1.0);
    GaborKernel param = gabor_kernel_lobe(lobe);
    return gabor_field(gabor_place(int2(0), p * 1.0), param, seed).value.y;
}

// Noise of a spectrum of several lobes at p, as many impulses as for one: see gabor_kernel_lobes.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 0.0, 0.1, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.3, 0.0, 1.0);
//     lobes.count = 2;
static inline __attribute__((always_inline))
float gabor_noise_lobes(float2 p, const GaborLobes lobes, uint seed)
{
    GaborLobes param = lobes;
    GaborKernel param_1 = gabor_kernel_lobes(param);
    return gabor_field(gabor_place(int2(0), p * 1.0), param_1, seed).value.y;
}

// The same spectrum as a sum of independent noises, one for each lobe [TNVT19, figure 6]: at the cost of each. Every
// place has waves of every lobe, which looks smoother where lobes differ much.
static inline __attribute__((always_inline))
float gabor_noise_sum(float2 p, const GaborLobes lobes, uint seed)
{
    GaborPlace place = gabor_place(int2(0), p * 1.0);
    float power = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 1; i++)
    {
        if (i >= lobes.count)
        {
            break;
        }
        uint param = seed + (uint(i) * 2246822507u);
        uint _2646 = gabor_mix(param, 2654435761u);
        uint own_seed = _2646;
        GaborKernel param_1 = gabor_kernel_lobe(lobes.lobe[i]);
        sum += (sqrt(lobes.lobe[i].power) * gabor_field(place, param_1, own_seed).value.y);
        power += lobes.lobe[i].power;
    }
    float _2672;
    if (power > 0.0)
    {
        _2672 = sum * rsqrt(power);
    }
    else
    {
        _2672 = 0.0;
    }
    return _2672;
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this took away: what a material lost in roughness, or a picture in contrast. For small
// steps it is gabor_noise, within 2 %. See gabor_footprint and gabor_field_filtered.
static inline __attribute__((always_inline))
float2 gabor_noise_filtered(float2 p, float2 dx, float2 dy, float frequency, float orientation, uint seed)
{
    GaborKernel kernel0 = gabor_kernel(frequency, orientation);
    float2 param = dx;
    float2 param_1 = dy;
    GaborFootprint _2688 = gabor_footprint(param, param_1);
    GaborFootprint footprint = _2688;
    GaborKernel param_2 = kernel0;
    float2 value = gabor_field_filtered(gabor_place(int2(0), p * 1.0), param_2, footprint, seed);
    GaborKernel param_3 = kernel0;
    return float2(value.y, gabor_removed(param_3, footprint));
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
static inline __attribute__((always_inline))
float gabor_unorm(float _noise)
{
    return fast::clamp(0.5 + (0.25 * _noise), 0.0, 1.0);
}

#endif // GABOR_NOISE_METAL
