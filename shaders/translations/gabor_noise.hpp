// gabor_noise.hpp: the sparse Gabor noise of [TNVT19] in two dimensions, with unit variance. For new work take
// gabor_lattice.hpp, which has the same calls, is faster, and is normal at every place: for C++ on the CPU.
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

#ifdef GABOR_LATTICE_HPP
#error Include gabor_noise.hpp or gabor_lattice.hpp, not both: they define the same functions
#endif
#ifndef GABOR_NOISE_HPP
#define GABOR_NOISE_HPP

// ---- GLSL's vectors, as much of them as the noise uses
// -------------------------------------------------------------

#ifndef GABOR_VECTORS_HPP
#define GABOR_VECTORS_HPP

#include <cmath>
#include <cstdint>
#include <cstring>

// All is inlined: only then do compilers make vectors of a loop over points.
#if defined(__GNUC__)
#define GABOR_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define GABOR_INLINE __forceinline
#else
#define GABOR_INLINE inline
#endif

template <typename T, int N>
struct gabor_vector;

template <typename T>
struct gabor_vector<T, 2> {
    T x, y;
    gabor_vector() = default;
    GABOR_INLINE gabor_vector(T x_, T y_) : x(x_), y(y_) {}
    GABOR_INLINE explicit gabor_vector(T all) : x(all), y(all) {}
    template <typename U>
    GABOR_INLINE explicit gabor_vector(gabor_vector<U, 2> v) : x(T(v.x)), y(T(v.y)) {}
    GABOR_INLINE T& operator[](int i) { return i == 0 ? x : y; }
    GABOR_INLINE T operator[](int i) const { return i == 0 ? x : y; }
    GABOR_INLINE gabor_vector<T, 2> yx() const { return {y, x}; }
};

template <typename T>
struct gabor_vector<T, 3> {
    T x, y, z;
    gabor_vector() = default;
    GABOR_INLINE gabor_vector(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, T z_) : x(v.x), y(v.y), z(z_) {}
    GABOR_INLINE explicit gabor_vector(T all) : x(all), y(all), z(all) {}
    template <typename U>
    GABOR_INLINE explicit gabor_vector(gabor_vector<U, 3> v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
    GABOR_INLINE T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    GABOR_INLINE T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    GABOR_INLINE gabor_vector<T, 2> xy() const { return {x, y}; }
    GABOR_INLINE gabor_vector<T, 2> yx() const { return {y, x}; }
    GABOR_INLINE gabor_vector<T, 2> yz() const { return {y, z}; }
    GABOR_INLINE void set_xy(gabor_vector<T, 2> v) { x = v.x, y = v.y; }
};

template <typename T>
struct gabor_vector<T, 4> {
    T x, y, z, w;
    gabor_vector() = default;
    GABOR_INLINE gabor_vector(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, T z_, T w_) : x(v.x), y(v.y), z(z_), w(w_) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, gabor_vector<T, 2> u) : x(v.x), y(v.y), z(u.x), w(u.y) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 3> v, T w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    GABOR_INLINE explicit gabor_vector(T all) : x(all), y(all), z(all), w(all) {}
    template <typename U>
    GABOR_INLINE explicit gabor_vector(gabor_vector<U, 4> v) : x(T(v.x)), y(T(v.y)), z(T(v.z)), w(T(v.w)) {}
    GABOR_INLINE T& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    GABOR_INLINE T operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    GABOR_INLINE gabor_vector<T, 2> xy() const { return {x, y}; }
    GABOR_INLINE gabor_vector<T, 2> zw() const { return {z, w}; }
    GABOR_INLINE gabor_vector<T, 3> xyz() const { return {x, y, z}; }
};

using gabor_vec2 = gabor_vector<float, 2>;
using gabor_vec3 = gabor_vector<float, 3>;
using gabor_vec4 = gabor_vector<float, 4>;
using gabor_ivec2 = gabor_vector<int, 2>;
using gabor_ivec3 = gabor_vector<int, 3>;
using gabor_uvec2 = gabor_vector<std::uint32_t, 2>;
using gabor_uvec4 = gabor_vector<std::uint32_t, 4>;

// A function of vectors of one length, part by part; R is the type of its results' parts.
#define GABOR_EACH(name, R, function)                                                                        \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 2> name(gabor_vector<T, 2> a) {                                             \
        return {function(a.x), function(a.y)};                                                               \
    }                                                                                                        \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 3> name(gabor_vector<T, 3> a) {                                             \
        return {function(a.x), function(a.y), function(a.z)};                                                \
    }                                                                                                        \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 4> name(gabor_vector<T, 4> a) {                                             \
        return {function(a.x), function(a.y), function(a.z), function(a.w)};                                 \
    }
#define GABOR_EACH_2(name, R, function)                                                                      \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 2> name(gabor_vector<T, 2> a, gabor_vector<T, 2> b) {                       \
        return {function(a.x, b.x), function(a.y, b.y)};                                                     \
    }                                                                                                        \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 3> name(gabor_vector<T, 3> a, gabor_vector<T, 3> b) {                       \
        return {function(a.x, b.x), function(a.y, b.y), function(a.z, b.z)};                                 \
    }                                                                                                        \
    template <typename T>                                                                                    \
    GABOR_INLINE gabor_vector<R, 4> name(gabor_vector<T, 4> a, gabor_vector<T, 4> b) {                       \
        return {function(a.x, b.x), function(a.y, b.y), function(a.z, b.z), function(a.w, b.w)};             \
    }
#define GABOR_OPERATOR(op, function)                                                                         \
    GABOR_EACH_2(operator op, T, function)                                                                   \
    template <typename T, int N>                                                                             \
    GABOR_INLINE gabor_vector<T, N> operator op(gabor_vector<T, N> a, T b) {                                 \
        return a op gabor_vector<T, N>(b);                                                                   \
    }                                                                                                        \
    template <typename T, int N>                                                                             \
    GABOR_INLINE gabor_vector<T, N> operator op(T a, gabor_vector<T, N> b) {                                 \
        return gabor_vector<T, N>(a) op b;                                                                   \
    }                                                                                                        \
    template <typename T, int N, typename U>                                                                 \
    GABOR_INLINE gabor_vector<T, N>& operator op##=(gabor_vector<T, N>& a, U b) {                            \
        return a = a op b;                                                                                   \
    }
#define GABOR_PLUS(a, b) (a) + (b)
#define GABOR_MINUS(a, b) (a) - (b)
#define GABOR_TIMES(a, b) (a) * (b)
#define GABOR_OVER(a, b) (a) / (b)
#define GABOR_NEGATIVE(a) -(a)
#define GABOR_BELOW(a, b) (a) < (b)
#define GABOR_UNEQUAL(a, b) (a) != (b)
GABOR_OPERATOR(+, GABOR_PLUS)
GABOR_OPERATOR(-, GABOR_MINUS)
GABOR_OPERATOR(*, GABOR_TIMES)
GABOR_OPERATOR(/, GABOR_OVER)
GABOR_EACH(operator-, T, GABOR_NEGATIVE)
GABOR_EACH_2(operator<, bool, GABOR_BELOW)
GABOR_EACH_2(operator!=, bool, GABOR_UNEQUAL)

GABOR_INLINE bool gabor_cpp_all(gabor_vector<bool, 2> v) {
    return v.x && v.y;
}
GABOR_INLINE bool gabor_cpp_any(gabor_vector<bool, 2> v) {
    return v.x || v.y;
}
GABOR_INLINE bool gabor_cpp_any(gabor_vector<bool, 3> v) {
    return v.x || v.y || v.z;
}

// condition ? a : b, without a branch, at which compilers would give up making vectors.
GABOR_INLINE float gabor_cpp_choose(bool condition, float a, float b) {
    std::uint32_t x, y;
    std::memcpy(&x, &a, sizeof x);
    std::memcpy(&y, &b, sizeof y);
    const std::uint32_t mask = std::uint32_t(-int(condition));
    x = (x & mask) | (y & ~mask);
    std::memcpy(&a, &x, sizeof a);
    return a;
}

// std::floor is a call where the processor has no instruction for it; and beyond 2^23 all floats are
// integers.
GABOR_INLINE float gabor_cpp_floor(float x) {
    const float near = gabor_cpp_choose(std::fabs(x) < 8388608.0f, x, 0.0f);
    const float whole = float(int(near));
    return gabor_cpp_choose(near == x, whole - gabor_cpp_choose(whole > near, 1.0f, 0.0f), x);
}
GABOR_INLINE float gabor_cpp_ceil(float x) {
    return -gabor_cpp_floor(-x);
}
GABOR_INLINE float gabor_cpp_fract(float x) {
    return x - gabor_cpp_floor(x);
}
GABOR_INLINE float gabor_cpp_abs(float x) {
    return std::fabs(x);
}
GABOR_INLINE float gabor_cpp_sqrt(float x) {
    return std::sqrt(x);
}
GABOR_INLINE float gabor_cpp_min(float a, float b) {
    return gabor_cpp_choose(b < a, b, a);
}
GABOR_INLINE float gabor_cpp_max(float a, float b) {
    return gabor_cpp_choose(a < b, b, a);
}
GABOR_INLINE int gabor_cpp_min(int a, int b) {
    return b < a ? b : a;
}
GABOR_INLINE int gabor_cpp_max(int a, int b) {
    return a < b ? b : a;
}
GABOR_EACH(gabor_cpp_floor, T, gabor_cpp_floor)
GABOR_EACH(gabor_cpp_ceil, T, gabor_cpp_ceil)
GABOR_EACH(gabor_cpp_abs, T, gabor_cpp_abs)
GABOR_EACH(gabor_cpp_sqrt, T, gabor_cpp_sqrt)
GABOR_EACH_2(gabor_cpp_min, T, gabor_cpp_min)
GABOR_EACH_2(gabor_cpp_max, T, gabor_cpp_max)
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_max(gabor_vector<T, N> a, T b) {
    return gabor_cpp_max(a, gabor_vector<T, N>(b));
}
GABOR_INLINE float gabor_cpp_clamp(float x, float low, float high) {
    return gabor_cpp_min(gabor_cpp_max(x, low), high);
}
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_clamp(gabor_vector<T, N> v, T low, T high) {
    return gabor_cpp_min(gabor_cpp_max(v, gabor_vector<T, N>(low)), gabor_vector<T, N>(high));
}
GABOR_INLINE float gabor_cpp_smoothstep(float low, float high, float x) {
    const float t = gabor_cpp_clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}
GABOR_INLINE float gabor_cpp_inversesqrt(float x) {
    return 1.0f / std::sqrt(x);
}
GABOR_INLINE float gabor_cpp_exp(float x) {
    return std::exp(x);
}
GABOR_INLINE float gabor_cpp_exp2(float x) {
    return std::exp2(x);
}
GABOR_INLINE float gabor_cpp_sin(float x) {
    return std::sin(x);
}
GABOR_INLINE float gabor_cpp_cos(float x) {
    return std::cos(x);
}
GABOR_INLINE float gabor_cpp_atan(float y, float x) {
    return std::atan2(y, x);
}
GABOR_INLINE float gabor_cpp_uintBitsToFloat(std::uint32_t bits) {
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}
GABOR_INLINE float gabor_cpp_dot(gabor_vec2 a, gabor_vec2 b) {
    return a.x * b.x + a.y * b.y;
}
GABOR_INLINE float gabor_cpp_dot(gabor_vec3 a, gabor_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
GABOR_INLINE float gabor_cpp_dot(gabor_vec4 a, gabor_vec4 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
GABOR_INLINE float gabor_cpp_length(gabor_vec2 v) {
    return std::sqrt(gabor_cpp_dot(v, v));
}
GABOR_INLINE gabor_vec3 gabor_cpp_cross(gabor_vec3 a, gabor_vec3 b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

// By columns.
struct gabor_mat3 {
    gabor_vec3 x, y, z;
    GABOR_INLINE gabor_vec3& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    GABOR_INLINE gabor_vec3 operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
GABOR_INLINE gabor_vec3 operator*(gabor_mat3 m, gabor_vec3 v) {
    return v.x * m.x + v.y * m.y + v.z * m.z;
}
GABOR_INLINE gabor_mat3 operator*(gabor_mat3 m, gabor_mat3 n) {
    return {m * n.x, m * n.y, m * n.z};
}
GABOR_INLINE gabor_mat3 operator+(gabor_mat3 m, gabor_mat3 n) {
    return {m.x + n.x, m.y + n.y, m.z + n.z};
}
GABOR_INLINE gabor_mat3 operator-(gabor_mat3 m, gabor_mat3 n) {
    return {m.x - n.x, m.y - n.y, m.z - n.z};
}
GABOR_INLINE gabor_mat3 gabor_cpp_transpose(gabor_mat3 m) {
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}

#undef GABOR_EACH
#undef GABOR_EACH_2
#undef GABOR_OPERATOR
#undef GABOR_PLUS
#undef GABOR_MINUS
#undef GABOR_TIMES
#undef GABOR_OVER
#undef GABOR_NEGATIVE
#undef GABOR_BELOW
#undef GABOR_UNEQUAL
#endif // GABOR_VECTORS_HPP

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
#define GABOR_RADIUS 1.0f
#endif

// A: a weight's magnitude is A or 1, equally likely: a float in [0, 1].
#ifndef GABOR_WEIGHT_FLOOR
#define GABOR_WEIGHT_FLOOR 0.675f
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
#define GABOR_WINDOW gabor_vec3(3.0f, -4.5f, 2.5f)
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
GABOR_INLINE int gabor_impl_macro_must_be_an_int(int value)
{
    return value;
}

GABOR_INLINE float gabor_impl_macro_must_be_a_float(float value)
{
    return value;
}

GABOR_INLINE gabor_vec3 gabor_impl_macro_must_be_a_vec3(gabor_vec3 value)
{
    return value;
}

GABOR_INLINE void gabor_impl_check_macros()
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
GABOR_INLINE std::uint32_t gabor_impl_mix(std::uint32_t word, std::uint32_t salt)
{
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The seed of noise `index` of several that are independent of each other, as the lobes of a sum are.
GABOR_INLINE std::uint32_t gabor_lobe_seed(std::uint32_t seed, int index)
{
    return gabor_impl_mix(seed + std::uint32_t(index) * GABOR_IMPL_IMPULSE_STRIDE, GABOR_IMPL_CELL_STRIDE);
}

// The word of `seed`, from which those of the rows follow.
GABOR_INLINE std::uint32_t gabor_impl_seed_word(std::uint32_t seed)
{
    return gabor_impl_mix(seed * GABOR_IMPL_CELL_STRIDE, 0x2545f491u);
}

// The word of a row of cells, from which those of its impulses follow.
GABOR_INLINE std::uint32_t gabor_impl_row_word(int row, std::uint32_t seed_word)
{
    return gabor_impl_mix(std::uint32_t(row) * GABOR_IMPL_CELL_STRIDE + seed_word, seed_word);
}

// The word of impulse `index` in a cell. In its bits are y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading ones of y and the trailing ones
// of x: only offsets in x below 1/256 of a cell depend on y.
GABOR_INLINE std::uint32_t gabor_impl_impulse_word(int column, std::uint32_t row_word, int index)
{
    std::uint32_t salt = row_word + std::uint32_t(index) * GABOR_IMPL_IMPULSE_STRIDE;
    return gabor_impl_mix(std::uint32_t(column) * GABOR_IMPL_CELL_STRIDE + salt, salt);
}

// Position of an impulse in its cell, plus 1: in [1, 2)^2, which takes no conversion from integers.
GABOR_INLINE gabor_vec2 gabor_impl_position_plus_one(std::uint32_t word)
{
    return gabor_vec2(gabor_cpp_uintBitsToFloat(0x3f800000u | ((word >> 8u) & 0x7fffffu)),
                gabor_cpp_uintBitsToFloat(0x3f800000u | (word & 0x7fffffu)));
}

// Phase of the impulse at that position, in turns.
GABOR_INLINE float gabor_impl_phase(gabor_vec2 position_plus_one, float phases)
{
    return gabor_cpp_fract(position_plus_one.y * (8388608.0f / phases));
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
GABOR_INLINE float gabor_impl_phase_rate(std::uint32_t word)
{
    float rate = float((word >> 8u) & 7u) - 4.0f;
    return rate < 0.0f ? rate : rate + 1.0f;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
GABOR_INLINE gabor_vec4 gabor_impl_four(gabor_vec2 wave, std::uint32_t word)
{
    std::uint32_t quarters = gabor_impl_mix(word, GABOR_IMPL_IMPULSE_STRIDE);
    gabor_vec4 shifted = gabor_vec4((quarters & 1u) == 0u ? wave.y : wave.x, (quarters & 2u) == 0u ? wave.y : wave.x,
                        (quarters & 4u) == 0u ? wave.y : wave.x, (quarters & 8u) == 0u ? wave.y : wave.x);
    return shifted * gabor_vec4((quarters & 16u) == 0u ? 1.0f : -1.0f, (quarters & 32u) == 0u ? 1.0f : -1.0f,
                          (quarters & 64u) == 0u ? 1.0f : -1.0f, (quarters & 128u) == 0u ? 1.0f : -1.0f);
}

// Magnitude of an impulse's weight.
GABOR_INLINE float gabor_impl_magnitude(std::uint32_t word)
{
    return int(word) < 0 ? 1.0f : GABOR_WEIGHT_FLOOR;
}

// ---- Sine ----------------------------------------------------------------------------------------------------------

// sin(2 pi t) for any t: reduced to half a turn, then t (1/4 - t^2) times a minimax polynomial in t^2.
// Absolute error below 3e-7 within +-1, growing with the rounding of t beyond.
GABOR_INLINE float gabor_impl_sine(float t)
{
    t = gabor_cpp_fract(t) - 0.5f;
    if (GABOR_NATIVE_SINE != 0)
        return -gabor_cpp_sin(6.2831853f * t);
    float s = t * t;
    float p = 12.233303f * s - 38.123196f;
    p = p * s + 67.0439f;
    p = p * s - 64.83468f;
    p = p * s + 25.13273f;
    return t * (s - 0.25f) * p;
}

// The unit vector at an angle in radians: reduced by pi/2 in three steps, then minimax polynomials. Its error stays
// near 1e-7, for a large frequency multiplies it.
GABOR_INLINE gabor_vec2 gabor_impl_direction(float angle)
{
    float quarter = gabor_cpp_floor(angle * 0.63661977f + 0.5f);
    float r = angle - quarter * 1.5703125f;
    r -= quarter * 4.837512969970703e-4f;
    r -= quarter * 7.549789948768648e-8f;
    r = gabor_cpp_abs(r) < 1.0f ? r : 0.0f; // far outside the range, where no digit is left of it, any direction will do
    float s = r * r;
    float sine = r + r * s * (-0.16666654f + s * (8.3321608e-3f - s * 1.9515295e-4f));
    float cosine = 1.0f - 0.5f * s + s * s * (4.1666645e-2f + s * (-1.3887316e-3f + s * 2.4433157e-5f));
    gabor_vec2 axis = gabor_cpp_fract(0.5f * quarter) < 0.25f ? gabor_vec2(cosine, sine) : gabor_vec2(-sine, cosine);
    return gabor_cpp_fract(0.25f * quarter) < 0.375f ? axis : -axis;
}

// Product of complex numbers.
GABOR_INLINE gabor_vec2 gabor_impl_product(gabor_vec2 a, gabor_vec2 b)
{
    return gabor_vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// ---- Normalization -------------------------------------------------------------------------------------------------

// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). The five c_n I_n, whose sum is the energy of one axis:
struct GaborEnergy {
    gabor_vec4 e4567;
    float e8;
    float sum;
};

GABOR_INLINE GaborEnergy gabor_impl_energy()
{
    gabor_vec3 c = GABOR_WINDOW;
    GaborEnergy energy;
    energy.e4567 = gabor_vec4(c.x * c.x, 2.0f * c.x * c.y, c.y * c.y + 2.0f * c.x * c.z, 2.0f * c.y * c.z)
                 * gabor_vec4(256.0f / 315.0f, 512.0f / 693.0f, 2048.0f / 3003.0f, 4096.0f / 6435.0f);
    energy.e8 = c.z * c.z * (65536.0f / 109395.0f);
    energy.sum = gabor_cpp_dot(energy.e4567, gabor_vec4(1.0f)) + energy.e8;
    return energy;
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel of k cycles per radius, relative to that at high frequency. For small a from 1 - L_n by the power
// series of L_7 and L_8 and downward recurrence; for large a by upward recurrence from L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
GABOR_INLINE float gabor_impl_relative_energy(float k, GaborEnergy energy)
{
    float a = 12.566371f * k;
    float z = a * a;
    gabor_vec4 d4567;
    float d8 = 0.0f;
    if (z < 64.0f) {
        float d7 = 0.0f;
        float term7 = 1.0f;
        float term8 = 1.0f;
        for (int i = 1; i <= 14; ++i) {
            float n = float(i);
            term7 *= -0.25f * z / (n * (n + 7.5f));
            term8 *= -0.25f * z / (n * (n + 8.5f));
            d7 -= term7;
            d8 -= term8;
        }
        float d6 = d7 + z * (1.0f - d8) * (1.0f / 255.0f);
        float d5 = d6 + z * (1.0f - d7) * (1.0f / 195.0f);
        float d4 = d5 + z * (1.0f - d6) * (1.0f / 143.0f);
        d4567 = gabor_vec4(d4, d5, d6, d7);
    } else {
        float y = 1.0f / z;
        float l0 = gabor_impl_sine(2.0f * k) / a;
        float l1 = 3.0f * y * (l0 - gabor_impl_sine(2.0f * k + 0.25f));
        float l2 = 15.0f * y * (l1 - l0);
        float l3 = 35.0f * y * (l2 - l1);
        float l4 = 63.0f * y * (l3 - l2);
        float l5 = 99.0f * y * (l4 - l3);
        float l6 = 143.0f * y * (l5 - l4);
        float l7 = 195.0f * y * (l6 - l5);
        d8 = 1.0f - 255.0f * y * (l7 - l6);
        d4567 = 1.0f - gabor_vec4(l4, l5, l6, l7);
    }
    return (gabor_cpp_dot(energy.e4567, d4567) + energy.e8 * d8) / energy.sum;
}

// ---- Kernels -------------------------------------------------------------------------------------------------------

// Waves around one frequency and orientation.
struct GaborLobe {
    gabor_vec2 wave;   // wave vector in the middle, cycles per kernel radius
    gabor_vec2 spread; // impulses have waves evenly spread within frequency (1 +- x), and within +- y turns
    float power; // in proportion to those of other lobes
};

// The lobe of a frequency and an orientation, with the ranges of gabor_noise, and
//   frequency_spread    a share of the frequency, within [0, 1]
//   orientation_spread  radians: pi/2 and more is every direction, isotropic
//   power               in any unit, up to 10^9
// What is less than 0 or NaN counts as 0.
GABOR_INLINE GaborLobe gabor_lobe(float frequency, float orientation, float frequency_spread, float orientation_spread, float power)
{
    float magnitude = gabor_cpp_abs(frequency);
    magnitude = magnitude > 1.0e-6f ? gabor_cpp_min(magnitude, 1.0e6f) : 1.0e-6f;
    GaborLobe lobe;
    lobe.wave = magnitude * gabor_impl_direction(orientation);
    lobe.spread.x = frequency_spread > 0.0f ? gabor_cpp_min(frequency_spread, 1.0f) : 0.0f;
    lobe.spread.y = orientation_spread > 0.0f ? 0.15915494f * gabor_cpp_min(orientation_spread, 1.5707963f) : 0.0f;
    lobe.power = power > 0.0f ? gabor_cpp_min(power, 1.0e9f) : 0.0f;
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
GABOR_INLINE GaborKernel gabor_kernel_lobes(GaborLobes lobes)
{
    GaborKernel kernel;
    kernel.lobes = lobes;
    kernel.lobes.count = gabor_cpp_clamp(lobes.count, 1, GABOR_LOBES);
    float total_power = 0.0f;
    GABOR_UNROLL for (int i = 0; i < GABOR_LOBES; ++i) {
        total_power += i < kernel.lobes.count ? lobes.lobe[i].power : 0.0f;
        kernel.lobes.lobe[i].power = total_power;
    }
    kernel.phases = 256.0f;
    kernel.variance_factor = 1.0f;
    float density = float(GABOR_IMPULSES) * GABOR_RADIUS * GABOR_RADIUS;
    float power = 0.5f + 0.5f * GABOR_WEIGHT_FLOOR * GABOR_WEIGHT_FLOOR;
    float energy = gabor_impl_energy().sum;
    kernel.amplitude = gabor_cpp_inversesqrt(0.5f * density * power * energy * energy);
    return kernel;
}

// The kernel of one lobe.
GABOR_INLINE GaborKernel gabor_kernel_lobe(GaborLobe lobe)
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
GABOR_INLINE GaborKernel gabor_kernel(float frequency, float orientation)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, 0.0f, 0.0f, 1.0f);
    GaborKernel kernel = gabor_kernel_lobe(lobe);
    kernel.phases = float(GABOR_PHASES);
    if (GABOR_PHASES == 2) {
        GaborEnergy energy = gabor_impl_energy();
        float x = gabor_impl_relative_energy(lobe.wave.x, energy);
        float y = gabor_impl_relative_energy(lobe.wave.y, energy);
        kernel.variance_factor = x + y - x * y;
        kernel.amplitude *= gabor_cpp_inversesqrt(kernel.variance_factor);
    }
    return kernel;
}

// A wave vector within a lobe's spread, as that is written.
GABOR_INLINE gabor_vec2 gabor_impl_wave_within(GaborLobe lobe, gabor_vec2 spread)
{
    gabor_vec2 turn = gabor_vec2(gabor_impl_sine(spread.y + 0.25f), gabor_impl_sine(spread.y));
    return (1.0f + spread.x) * gabor_impl_product(lobe.wave, turn);
}

// The wave vector of the impulse that has this word.
GABOR_INLINE gabor_vec2 gabor_impl_wave(GaborKernel kernel, std::uint32_t word)
{
    GaborLobe lobe = kernel.lobes.lobe[0];
    std::uint32_t choice = gabor_impl_mix(word, GABOR_IMPL_CELL_STRIDE);
    if (kernel.lobes.count > 1) {
        float chosen = kernel.lobes.lobe[GABOR_LOBES - 1].power * ((float(choice >> 16u) + 0.5f) / 65536.0f);
        GABOR_UNROLL for (int i = 1; i < GABOR_LOBES; ++i) {
            if (i < kernel.lobes.count && chosen >= kernel.lobes.lobe[i - 1].power)
                lobe = kernel.lobes.lobe[i];
        }
    }
    if (lobe.spread.x == 0.0f && lobe.spread.y == 0.0f)
        return lobe.wave;
    gabor_vec2 drawn = gabor_vec2(float(choice * GABOR_IMPL_CELL_STRIDE >> 16u), float(choice & 0xffffu));
    return gabor_impl_wave_within(lobe, lobe.spread * ((drawn + 0.5f) / 32768.0f - 1.0f));
}

// The window q along one axis, 0 from |x| = 1 on.
GABOR_INLINE float gabor_impl_window(float x)
{
    gabor_vec3 c = GABOR_WINDOW;
    float u = gabor_cpp_max(1.0f - x * x, 0.0f);
    return u * u * (c.x + u * (c.y + u * c.z));
}

// Its derivative.
GABOR_INLINE float gabor_impl_window_slope(float x)
{
    gabor_vec3 c = GABOR_WINDOW;
    float u = gabor_cpp_max(1.0f - x * x, 0.0f);
    return -2.0f * x * u * (2.0f * c.x + u * (3.0f * c.y + u * (4.0f * c.z)));
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    gabor_ivec2 cell;   // any integers, but for the last few before the world wraps around at 2^31
    gabor_vec2 local;   // offset from that cell's corner, in cells: any small vector, [0, 1)^2 is the most precise
    gabor_vec2 radius;  // cells per kernel radius along each axis: GABOR_RADIUS, or between half of it and it to fit a period
    gabor_ivec2 period; // in cells, 0 for none
    float time;   // in periods of time: only its fraction counts
};

// (cell + local) / GABOR_RADIUS kernel radii, without periods, at time 0: full precision everywhere in a world of 2^32
// cells each way, where it wraps around.
GABOR_INLINE GaborPlace gabor_place(gabor_ivec2 cell, gabor_vec2 local)
{
    return GaborPlace{cell, local, gabor_vec2(GABOR_RADIUS), gabor_ivec2(0), 0.0f};
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part is the same with cosines
// for sines, and its gradient. Parts that are not used cost nothing: compilers leave them out.
struct GaborField {
    gabor_vec2 value;   // real, imaginary: each of mean 0 and variance 1
    gabor_vec2 slope_x; // their derivatives along x, per kernel radius
    gabor_vec2 slope_y; // along y
    gabor_vec4 four;    // four noises of the same spectrum, uncorrelated with each other wherever they are compared
};

// A cell's coordinate within a period.
GABOR_INLINE int gabor_impl_wrap(int cell, int period)
{
    if (period == 0)
        return cell;
    int within = cell - cell / period * period;
    return within < 0 ? within + period : within;
}

// The gain that keeps the variance of sine kernels at 1 while time turns their phases: J(a.x) J(a.y) in gabor_kernel is
// multiplied by 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the phase rates k.
GABOR_INLINE float gabor_impl_phase_gain(GaborKernel kernel, float time)
{
    if (kernel.phases != 2.0f || time == 0.0f)
        return 1.0f;
    gabor_vec4 sines = gabor_vec4(gabor_impl_sine(time), gabor_impl_sine(2.0f * time), gabor_impl_sine(3.0f * time),
                      gabor_impl_sine(4.0f * time));
    float u = 0.5f * gabor_cpp_dot(sines, sines);
    return gabor_cpp_inversesqrt(1.0f + u * (1.0f - kernel.variance_factor) / kernel.variance_factor);
}

// The factor of the sum of kernels: with fewer cells per radius there are fewer impulses.
GABOR_INLINE float gabor_impl_scale(GaborKernel kernel, GaborPlace place)
{
    return kernel.amplitude * GABOR_RADIUS * gabor_cpp_inversesqrt(place.radius.x * place.radius.y)
         * gabor_impl_phase_gain(kernel, gabor_cpp_fract(place.time));
}

// The noise at a place, by its cell: what most functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
GABOR_INLINE GaborField gabor_field(GaborPlace place, GaborKernel kernel, std::uint32_t seed)
{
    int visited = int(gabor_cpp_ceil(2.0f * GABOR_RADIUS)) + 1;
    gabor_vec2 cell_base = gabor_cpp_floor(place.local);
    gabor_vec2 local = place.local - cell_base;
    gabor_vec2 first = gabor_cpp_floor(local - place.radius);
    gabor_ivec2 cell = place.cell + gabor_ivec2(cell_base + first);
    first -= 1.0f; // what gabor_impl_position_plus_one adds
    gabor_vec2 cell_side = 1.0f / place.radius;
    float time = gabor_cpp_fract(place.time);

    std::uint32_t seed_word = gabor_impl_seed_word(seed);
    GaborField sum = GaborField{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec4(0.0f)};
    GABOR_UNROLL for (int j = 0; j < visited; ++j) {
        std::uint32_t row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        GABOR_UNROLL for (int i = 0; i < visited; ++i) {
            int column = gabor_impl_wrap(cell.x + i, place.period.x);
            GABOR_UNROLL for (int k = 0; k < GABOR_IMPULSES; ++k) {
                std::uint32_t word = gabor_impl_impulse_word(column, row_word, k);
                gabor_vec2 impulse = gabor_impl_position_plus_one(word);
                // The sum in the inner brackets is exact, which leaves one rounding.
                gabor_vec2 d = (local - (impulse + (first + gabor_vec2(float(i), float(j))))) * cell_side;
                // About half of the impulses reach here. GPUs skip what no pixel of a wave needs, and compilers for
                // CPUs keep their registers in order, which without the branch they do not: lavapipe takes 2.5 x as
                // long.
                if (gabor_cpp_max(gabor_cpp_abs(d.x), gabor_cpp_abs(d.y)) < 1.0f) {
                    gabor_vec2 cycles = gabor_impl_wave(kernel, word);
                    float turns = gabor_cpp_dot(cycles, d) + gabor_impl_phase(impulse, kernel.phases)
                                + gabor_impl_phase_rate(word) * time;
                    float magnitude = gabor_impl_magnitude(word);
                    gabor_vec2 window = gabor_vec2(gabor_impl_window(d.x), gabor_impl_window(d.y));
                    gabor_vec2 wave = magnitude * gabor_vec2(gabor_impl_sine(turns + 0.25f), gabor_impl_sine(turns));
                    // The derivative of e^(2 pi i F x) is 2 pi i F times it.
                    gabor_vec2 turned = (6.2831853f * window.x * window.y) * gabor_vec2(-wave.y, wave.x);
                    sum.value += (window.x * window.y) * wave;
                    sum.slope_x += (gabor_impl_window_slope(d.x) * window.y) * wave + cycles.x * turned;
                    sum.slope_y += (gabor_impl_window_slope(d.y) * window.x) * wave + cycles.y * turned;
                    sum.four += (window.x * window.y) * gabor_impl_four(wave, word);
                }
            }
        }
    }
    float scale = gabor_impl_scale(kernel, place);
    return GaborField{scale * sum.value, scale * sum.slope_x, scale * sum.slope_y, scale * sum.four};
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// A pixel's filter is a normal density of covariance S. To take it along, the window is written as a normal density of
// variance s^2 = 0.121 times an even polynomial, q(x) = e^(-x^2 / (2 s^2)) P(x / s). By completing the square, with
// omega = 2 pi F, C = s^2 + S, z = d + i S omega, and v drawn from the normal law of covariance V = 1 - s^2 / C,
//     (q q e^(i omega d)) * filter = s^2 |C|^(-1/2) e^(i omega d - omega S omega / 2 - z C^-1 z / 2) E[P(m.x) P(m.y)]
//     m = s C^-1 z + v:
// again a window around a wave, but wider, weaker, and the wave slower.
#define GABOR_IMPL_NORMAL_VARIANCE 0.121104f
#define GABOR_IMPL_NORMAL_DEVIATION 0.348f

// Even polynomial p0 + p1 x^2 + ... + p5 x^10.
struct GaborPolynomial {
    gabor_vec3 low;
    gabor_vec3 high;
};

// P, by least squares: within 1.8 % of the default window in the root mean square, and closer to smoother ones.
GABOR_INLINE GaborPolynomial gabor_impl_normal_window()
{
    gabor_vec3 c = GABOR_WINDOW;
    GaborPolynomial p;
    p.low = c.x * gabor_vec3(1.00289538f, 0.22776577f, 0.05744543f) + c.y * gabor_vec3(1.00145225f, 0.11853905f, 0.01796500f)
          + c.z * gabor_vec3(0.99978500f, 0.01664752f, -0.02767342f);
    p.high = c.x * gabor_vec3(-0.01466960f, -0.00010419f, 0.00005601f) + c.y * gabor_vec3(-0.01980551f, 0.00225161f, -0.00006904f)
           + c.z * gabor_vec3(-0.00584684f, 0.00131062f, -0.00005534f);
    return p;
}

// E[P(x + v)] as a polynomial of x, for v normal of this variance.
GABOR_INLINE GaborPolynomial gabor_impl_averaged(GaborPolynomial p, float variance)
{
    gabor_vec3 v = variance * gabor_vec3(1.0f, variance, variance * variance);
    gabor_vec2 w = v.y * v.yz();
    GaborPolynomial mean;
    mean.low.x = p.low.x + gabor_cpp_dot(v, gabor_vec3(p.low.y, 3.0f * p.low.z, 15.0f * p.high.x))
               + gabor_cpp_dot(w, gabor_vec2(105.0f * p.high.y, 945.0f * p.high.z));
    mean.low.y = p.low.y + gabor_cpp_dot(v, gabor_vec3(6.0f * p.low.z, 45.0f * p.high.x, 420.0f * p.high.y)) + w.x * 4725.0f * p.high.z;
    mean.low.z = p.low.z + gabor_cpp_dot(v, gabor_vec3(15.0f * p.high.x, 210.0f * p.high.y, 3150.0f * p.high.z));
    mean.high.x = p.high.x + gabor_cpp_dot(v.xy(), gabor_vec2(28.0f * p.high.y, 630.0f * p.high.z));
    mean.high.y = p.high.y + 45.0f * variance * p.high.z;
    mean.high.z = p.high.z;
    return mean;
}

// A polynomial of a complex number.
GABOR_INLINE gabor_vec2 gabor_impl_polynomial(GaborPolynomial p, gabor_vec2 z)
{
    gabor_vec2 square = gabor_impl_product(z, z);
    gabor_vec2 sum = p.high.z * square + gabor_vec2(p.high.y, 0.0f);
    sum = gabor_impl_product(sum, square) + gabor_vec2(p.high.x, 0.0f);
    sum = gabor_impl_product(sum, square) + gabor_vec2(p.low.z, 0.0f);
    sum = gabor_impl_product(sum, square) + gabor_vec2(p.low.y, 0.0f);
    return gabor_impl_product(sum, square) + gabor_vec2(p.low.x, 0.0f);
}

// Symmetric matrices are (xx, yy, xy).
GABOR_INLINE gabor_vec2 gabor_impl_symmetric(gabor_vec3 matrix, gabor_vec2 v)
{
    return matrix.xy() * v + matrix.z * v.yx();
}

GABOR_INLINE gabor_vec3 gabor_impl_inverse(gabor_vec3 matrix)
{
    return gabor_vec3(matrix.yx(), -matrix.z) / (matrix.x * matrix.y - matrix.z * matrix.z);
}

// What a pixel covers, and what windows become under it. Lengths are in kernel radii.
struct GaborFootprint {
    gabor_vec3 covariance;   // of the filter
    gabor_vec3 widening;     // S: the same, but at most 1/4 in every direction
    gabor_vec3 inverse;      // of C
    float amplitude;   // s^2 |C|^(-1/2)
    gabor_vec2 reach;        // where windows end along each axis
    gabor_vec2 joint;        // deviations of the part of v that both axes share
    GaborPolynomial x; // E[P(m.x)] over the rest of v
    GaborPolynomial y;
};

// The footprint of a pixel, seen through a normal filter whose standard deviation is half a pixel.
//   dx, dy   steps from the pixel's place to its neighbours', dFdx(p) and dFdy(p), in kernel radii. Where they are NaN
//            or infinite or longer than 10^3, 10^3 is taken.
GABOR_INLINE GaborFootprint gabor_footprint(gabor_vec2 dx, gabor_vec2 dy)
{
    gabor_vec3 unit = gabor_vec3(1.0f, 1.0f, 0.0f);
    gabor_vec3 covariance = 0.25f * (gabor_vec3(dx * dx, dx.x * dx.y) + gabor_vec3(dy * dy, dy.x * dy.y));
    if (!(covariance.x + covariance.y < 2.5e5f)) {
        dx = gabor_vec2(1.0e3f, 0.0f);
        dy = gabor_vec2(0.0f, 1.0e3f);
        covariance = 2.5e5f * unit;
    }
    GaborFootprint footprint;
    footprint.covariance = covariance;

    // The eigenvalues are mean +- difference, the smaller one precisely the determinant over the larger one.
    float mean = 0.5f * (covariance.x + covariance.y);
    float difference = gabor_cpp_length(gabor_vec2(0.5f * (covariance.x - covariance.y), covariance.z));
    float larger = mean + difference;
    float side = 0.25f * (dx.x * dy.y - dx.y * dy.x);
    float smaller = larger > 1.0e-12f ? gabor_cpp_min(side / larger * side, mean) : 0.0f;
    gabor_vec2 kept = gabor_cpp_min(gabor_vec2(larger, smaller), gabor_vec2(0.25f));
    gabor_vec3 direction = difference > 0.0f ? (covariance - mean * unit) / difference : gabor_vec3(0.0f);
    footprint.widening = 0.5f * ((kept.x + kept.y) * unit + (kept.x - kept.y) * direction);
    footprint.widening.set_xy(gabor_cpp_max(footprint.widening.xy(), gabor_vec2(0.0f)));

    footprint.inverse = gabor_impl_inverse(GABOR_IMPL_NORMAL_VARIANCE * unit + footprint.widening);
    footprint.amplitude = GABOR_IMPL_NORMAL_VARIANCE
                        * gabor_cpp_sqrt(footprint.inverse.x * footprint.inverse.y - footprint.inverse.z * footprint.inverse.z);
    footprint.reach = 1.045f + 1.5f * gabor_cpp_sqrt(footprint.widening.xy());
    gabor_vec3 v = unit - GABOR_IMPL_NORMAL_VARIANCE * footprint.inverse;
    gabor_vec2 variance = gabor_cpp_max(v.xy(), gabor_vec2(0.0f));
    float product = variance.x * variance.y;
    float correlation = product > 0.0f ? gabor_cpp_min(gabor_cpp_abs(v.z) * gabor_cpp_inversesqrt(product), 1.0f) : 0.0f;
    footprint.joint = gabor_cpp_sqrt(correlation * variance) * gabor_vec2(1.0f, v.z < 0.0f ? -1.0f : 1.0f);
    gabor_vec2 rest = (1.0f - correlation) * variance;
    footprint.x = gabor_impl_averaged(gabor_impl_normal_window(), rest.x);
    footprint.y = gabor_impl_averaged(gabor_impl_normal_window(), rest.y);
    return footprint;
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe taken as normal, of
// the variance B = integral(q'^2) / (4 pi^2 integral(q^2)) along each axis,
//     |1 + 8 pi^2 B S|^(-1/2) e^(-4 pi^2 F S (1 + 8 pi^2 B S)^-1 F).
GABOR_INLINE float gabor_impl_transmitted(gabor_vec2 wave, gabor_vec3 covariance)
{
    gabor_vec3 c = GABOR_WINDOW;
    // The integral of x^2 u^n is I_n / (2n+3).
    gabor_vec4 slope = gabor_vec4(4.0f * c.x * c.x, 12.0f * c.x * c.y, 9.0f * c.y * c.y + 16.0f * c.x * c.z, 24.0f * c.y * c.z)
               * gabor_vec4(16.0f / 105.0f, 32.0f / 315.0f, 256.0f / 3465.0f, 512.0f / 9009.0f);
    float energy = 4.0f * (gabor_cpp_dot(slope, gabor_vec4(1.0f)) + 16.0f * c.z * c.z * (2048.0f / 45045.0f));
    gabor_vec3 widened = gabor_vec3(1.0f, 1.0f, 0.0f) + (2.0f * energy / gabor_impl_energy().sum) * covariance;
    gabor_vec2 slower = gabor_impl_symmetric(gabor_impl_inverse(widened), wave);
    float taken = 39.478418f * gabor_cpp_dot(wave, gabor_impl_symmetric(covariance, slower));
    return gabor_cpp_exp(-gabor_cpp_min(taken, 80.0f)) * gabor_cpp_inversesqrt(widened.x * widened.y - widened.z * widened.z);
}

// The share of its variance that all of a kernel's noise loses under the footprint: in [0, 1].
GABOR_INLINE float gabor_removed(GaborKernel kernel, GaborFootprint footprint)
{
    float kept = 0.0f;
    float before = 0.0f;
    for (int i = 0; i < GABOR_LOBES; ++i) {
        if (i >= kernel.lobes.count)
            break;
        GaborLobe lobe = kernel.lobes.lobe[i];
        float mean = 0.0f;
        if (lobe.spread.x == 0.0f && lobe.spread.y == 0.0f) {
            mean = gabor_impl_transmitted(lobe.wave, footprint.covariance);
        } else {
            for (int j = 0; j < 72; ++j) {
                gabor_vec2 within = lobe.spread * (gabor_vec2(float(j % 3), float(j / 3)) * gabor_vec2(2.0f / 3.0f, 1.0f / 12.0f)
                                             - gabor_vec2(2.0f / 3.0f, 23.0f / 24.0f));
                mean += gabor_impl_transmitted(gabor_impl_wave_within(lobe, within), footprint.covariance) / 72.0f;
            }
        }
        kept += (lobe.power - before) * mean;
        before = lobe.power;
    }
    return before > 0.0f ? gabor_cpp_clamp(1.0f - kept / before, 0.0f, 1.0f) : 0.0f;
}

// A kernel of amplitude 1 under a footprint, as (real, imaginary): at a distance d from an impulse of this phase.
GABOR_INLINE gabor_vec2 gabor_impl_kernel_filtered(gabor_vec2 d, gabor_vec2 wave, float phase, GaborFootprint footprint)
{
    gabor_vec2 shift = gabor_impl_symmetric(footprint.widening, 6.2831853f * wave);
    gabor_vec2 real = gabor_impl_symmetric(footprint.inverse, d);
    gabor_vec2 imaginary = gabor_impl_symmetric(footprint.inverse, shift);
    float exponent = 0.5f * (gabor_cpp_dot(shift, imaginary) - gabor_cpp_dot(6.2831853f * wave, shift) - gabor_cpp_dot(d, real));
    real *= GABOR_IMPL_NORMAL_DEVIATION;
    imaginary *= GABOR_IMPL_NORMAL_DEVIATION;
    if (exponent < -20.0f || gabor_cpp_dot(imaginary, imaginary) > 40.0f) // the second follows from the first, but for rounding
        return gabor_vec2(0.0f);

    // The part of v that the axes share, by Gauss and Hermite's rule of five points.
    gabor_vec2 window = gabor_vec2(0.0f);
    for (int i = -2; i <= 2; ++i) {
        float point = i == 0 ? 0.0f : float(i) * (gabor_cpp_abs(i) == 1 ? 1.3556262f : 1.4284850f);
        float weight = i == 0 ? 0.53333333f : gabor_cpp_abs(i) == 1 ? 0.22207592f : 0.01125741f;
        gabor_vec2 v = point * footprint.joint;
        window += weight * gabor_impl_product(gabor_impl_polynomial(footprint.x, gabor_vec2(real.x + v.x, imaginary.x)),
                                       gabor_impl_polynomial(footprint.y, gabor_vec2(real.y + v.y, imaginary.y)));
    }

    float amplitude = footprint.amplitude * gabor_cpp_exp(exponent);
    if (footprint.widening.x + footprint.widening.y < footprint.covariance.x + footprint.covariance.y)
        amplitude *= gabor_cpp_sqrt(gabor_impl_transmitted(wave, footprint.covariance)
                          / gabor_impl_transmitted(wave, footprint.widening));
    float turns = gabor_cpp_dot(wave, d) - gabor_cpp_dot(shift, real) / (6.2831853f * GABOR_IMPL_NORMAL_DEVIATION) + phase;
    return amplitude * gabor_impl_product(window, gabor_vec2(gabor_impl_sine(turns + 0.25f), gabor_impl_sine(turns)));
}

// The noise at a place as a pixel sees it, (real, imaginary), as in gabor_field. Each part is within 2 % of a standard
// deviation, in the root mean square, of the noise seen through the filter, for footprints of up to a kernel radius; in
// larger ones it fades as it should, but is no smoother. Its variance is 1 - gabor_removed, within 1 %: for two phases
// from frequency 1.5 up.
// Cost: (2 reach R + 1)^2 N impulses on average, reach from 1 to 1.8, each about four times that of gabor_field.
GABOR_INLINE gabor_vec2 gabor_field_filtered(GaborPlace place, GaborKernel kernel, GaborFootprint footprint, std::uint32_t seed)
{
    gabor_vec2 cell_base = gabor_cpp_floor(place.local);
    gabor_vec2 local = place.local - cell_base;
    gabor_ivec2 first = gabor_ivec2(gabor_cpp_floor(local - place.radius * footprint.reach));
    gabor_ivec2 last = gabor_ivec2(gabor_cpp_floor(local + place.radius * footprint.reach));
    gabor_ivec2 cell = place.cell + gabor_ivec2(cell_base);
    float time = gabor_cpp_fract(place.time);
    std::uint32_t seed_word = gabor_impl_seed_word(seed);
    gabor_vec2 sum = gabor_vec2(0.0f);
    for (int j = first.y; j <= last.y; ++j) {
        std::uint32_t row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        for (int i = first.x; i <= last.x; ++i) {
            int column = gabor_impl_wrap(cell.x + i, place.period.x);
            for (int k = 0; k < GABOR_IMPULSES; ++k) {
                std::uint32_t word = gabor_impl_impulse_word(column, row_word, k);
                gabor_vec2 impulse = gabor_impl_position_plus_one(word);
                gabor_vec2 d = (local - (impulse + (gabor_vec2(float(i), float(j)) - 1.0f))) / place.radius;
                if (gabor_cpp_all((gabor_cpp_abs(d) < footprint.reach))) {
                    float phase = gabor_impl_phase(impulse, kernel.phases) + gabor_impl_phase_rate(word) * time;
                    sum += gabor_impl_magnitude(word)
                         * gabor_impl_kernel_filtered(d, gabor_impl_wave(kernel, word), phase, footprint);
                }
            }
        }
    }
    return gabor_impl_scale(kernel, place) * sum;
}

// ---- The simple calls ----------------------------------------------------------------------------------------------

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
GABOR_INLINE float gabor_noise_at(gabor_ivec2 cell, gabor_vec2 local, GaborKernel kernel, std::uint32_t seed)
{
    return gabor_field(gabor_place(cell, local), kernel, seed).value.y;
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
GABOR_INLINE float gabor_noise(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed)
{
    return gabor_noise_at(gabor_ivec2(0), p * GABOR_RADIUS, gabor_kernel(frequency, orientation), seed);
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
GABOR_INLINE gabor_vec3 gabor_noise_gradient(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed)
{
    GaborField field = gabor_field(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed);
    return gabor_vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent; with GABOR_PHASES 2 the real part's variance is 1 only
// from frequency 1.5 up.
GABOR_INLINE gabor_vec2 gabor_noise_complex(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed)
{
    return gabor_field(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).value;
}

// Four noises at p from one traversal, for colours and for displacement along vectors: each as gabor_noise,
// uncorrelated with each other. With GABOR_PHASES 2 their variance is 1 only from frequency 1.5 up.
GABOR_INLINE gabor_vec4 gabor_noise_four(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed)
{
    return gabor_field(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
GABOR_INLINE gabor_vec2 gabor_phasor(gabor_vec2 value)
{
    float intensity = gabor_cpp_length(value);
    float phase = intensity > 0.0f ? gabor_cpp_atan(value.y, value.x) * 0.15915494f : 0.0f;
    return gabor_vec2(phase < 0.0f ? gabor_cpp_min(phase + 1.0f, 0.99999994f) : phase, intensity);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation.
// Mean and variance are those of gabor_noise. So is the rest of the law where period * R is whole; else cells grow to
// fit, and values become less normal: for `one` cvm 1.1 with 5 % fewer cells per radius, 6.4 with 10 %, 14 to 425 for
// square periods of 2.3 to 4.9. A period below 2, a kernel's diameter, is taken as 2.
GABOR_INLINE float gabor_noise_tiled(gabor_vec2 p, gabor_vec2 period, float frequency, float orientation, std::uint32_t seed)
{
    period = gabor_cpp_max(period, gabor_vec2(2.0f));
    gabor_vec2 cells = gabor_cpp_floor(period * GABOR_RADIUS);
    gabor_vec2 radius = cells / period;
    gabor_vec2 within = p - gabor_cpp_floor(p / period) * period;
    GaborPlace place = GaborPlace{gabor_ivec2(0), within * radius, radius, gabor_ivec2(cells), 0.0f};
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance. Its correlation with itself is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at
// a lag of 0.03, 0 at 0.1, -0.38 at 0.16.
GABOR_INLINE float gabor_noise_animated(gabor_vec2 p, float time, float frequency, float orientation, std::uint32_t seed)
{
    GaborPlace place = gabor_place(gabor_ivec2(0), p * GABOR_RADIUS);
    place.time = time;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` of the frequency, both evenly spread. pi/2 radians are every direction: isotropic noise. As
// gabor_noise, with the ranges of gabor_lobe.
GABOR_INLINE float gabor_noise_spread(gabor_vec2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         std::uint32_t seed)
{
    GaborLobe lobe = gabor_lobe(frequency, orientation, frequency_spread, orientation_spread, 1.0f);
    return gabor_field(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel_lobe(lobe), seed).value.y;
}

// Noise of a spectrum of several lobes at p, as many impulses as for one: see gabor_kernel_lobes.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 0.0, 0.1, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.3, 0.0, 1.0);
//     lobes.count = 2;
GABOR_INLINE float gabor_noise_lobes(gabor_vec2 p, GaborLobes lobes, std::uint32_t seed)
{
    return gabor_field(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), gabor_kernel_lobes(lobes), seed).value.y;
}

// The same spectrum as a sum of independent noises, one for each lobe [TNVT19, figure 6]: at the cost of each. Every
// place has waves of every lobe, which looks smoother where lobes differ much.
GABOR_INLINE float gabor_noise_sum(gabor_vec2 p, GaborLobes lobes, std::uint32_t seed)
{
    GaborPlace place = gabor_place(gabor_ivec2(0), p * GABOR_RADIUS);
    float power = 0.0f;
    float sum = 0.0f;
    for (int i = 0; i < GABOR_LOBES; ++i) {
        if (i >= lobes.count)
            break;
        std::uint32_t own_seed = gabor_lobe_seed(seed, i);
        sum += gabor_cpp_sqrt(lobes.lobe[i].power) * gabor_field(place, gabor_kernel_lobe(lobes.lobe[i]), own_seed).value.y;
        power += lobes.lobe[i].power;
    }
    return power > 0.0f ? sum * gabor_cpp_inversesqrt(power) : 0.0f;
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this took away: what a material lost in roughness, or a picture in contrast. For small
// steps it is gabor_noise, within 2 %. See gabor_footprint and gabor_field_filtered.
GABOR_INLINE gabor_vec2 gabor_noise_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, float frequency, float orientation, std::uint32_t seed)
{
    GaborKernel kernel = gabor_kernel(frequency, orientation);
    GaborFootprint footprint = gabor_footprint(dx, dy);
    gabor_vec2 value = gabor_field_filtered(gabor_place(gabor_ivec2(0), p * GABOR_RADIUS), kernel, footprint, seed);
    return gabor_vec2(value.y, gabor_removed(kernel, footprint));
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
GABOR_INLINE float gabor_unorm(float noise)
{
    return gabor_cpp_clamp(0.5f + 0.25f * noise, 0.0f, 1.0f);
}

#endif // GABOR_NOISE_HPP
