// ---- The types and functions of GLSL that the noise uses ------------------------------------------------

#ifndef GABOR_VECTORS_HPP
#define GABOR_VECTORS_HPP

#include <cmath>
#include <cstdint>
#include <cstring>

// Compilers vectorize loops over points only if everything is inlined.
#if defined(__GNUC__)
#define GABOR_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define GABOR_INLINE __forceinline
#else
#define GABOR_INLINE inline
#endif

template <typename T, int N>
struct gabor_vector;

// Defines functions that read and change two or three different components of a vector, or read one twice or
// three times.
#define GABOR_TWO(a, b)                                                                                      \
    GABOR_INLINE gabor_vector<T, 2> a##b() const {                                                           \
        return {a, b};                                                                                       \
    }                                                                                                        \
    GABOR_INLINE gabor_vector<T, 2> set_##a##b(gabor_vector<T, 2> v) {                                       \
        return {a = v.x, b = v.y};                                                                           \
    }
#define GABOR_THREE(a, b, c)                                                                                 \
    GABOR_INLINE gabor_vector<T, 3> a##b##c() const {                                                        \
        return {a, b, c};                                                                                    \
    }                                                                                                        \
    GABOR_INLINE gabor_vector<T, 3> set_##a##b##c(gabor_vector<T, 3> v) {                                    \
        return {a = v.x, b = v.y, c = v.z};                                                                  \
    }
#define GABOR_SAME(a)                                                                                        \
    GABOR_INLINE gabor_vector<T, 2> a##a() const {                                                           \
        return {a, a};                                                                                       \
    }                                                                                                        \
    GABOR_INLINE gabor_vector<T, 3> a##a##a() const {                                                        \
        return {a, a, a};                                                                                    \
    }
#define GABOR_OF_TWO GABOR_TWO(x, y) GABOR_TWO(y, x) GABOR_SAME(x) GABOR_SAME(y)
#define GABOR_OF_THREE                                                                                       \
    GABOR_OF_TWO GABOR_TWO(x, z) GABOR_TWO(z, x) GABOR_TWO(y, z) GABOR_TWO(z, y) GABOR_SAME(z)               \
        GABOR_THREE(x, y, z) GABOR_THREE(y, z, x) GABOR_THREE(z, x, y) GABOR_THREE(x, z, y)                  \
            GABOR_THREE(z, y, x) GABOR_THREE(y, x, z)
#define GABOR_OF_FOUR                                                                                        \
    GABOR_OF_THREE GABOR_TWO(x, w) GABOR_TWO(w, x) GABOR_TWO(y, w) GABOR_TWO(w, y) GABOR_TWO(z, w)           \
        GABOR_TWO(w, z) GABOR_SAME(w) GABOR_THREE(x, y, w) GABOR_THREE(x, z, w) GABOR_THREE(x, w, y)         \
            GABOR_THREE(x, w, z) GABOR_THREE(y, x, w) GABOR_THREE(y, z, w) GABOR_THREE(y, w, x)              \
                GABOR_THREE(y, w, z) GABOR_THREE(z, x, w) GABOR_THREE(z, y, w) GABOR_THREE(z, w, x)          \
                    GABOR_THREE(z, w, y) GABOR_THREE(w, x, y) GABOR_THREE(w, x, z) GABOR_THREE(w, y, x)      \
                        GABOR_THREE(w, y, z) GABOR_THREE(w, z, x) GABOR_THREE(w, z, y)

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
    GABOR_OF_TWO
};

template <typename T>
struct gabor_vector<T, 3> {
    T x, y, z;
    gabor_vector() = default;
    GABOR_INLINE gabor_vector(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, T z_) : x(v.x), y(v.y), z(z_) {}
    GABOR_INLINE gabor_vector(T x_, gabor_vector<T, 2> v) : x(x_), y(v.x), z(v.y) {}
    GABOR_INLINE explicit gabor_vector(T all) : x(all), y(all), z(all) {}
    template <typename U>
    GABOR_INLINE explicit gabor_vector(gabor_vector<U, 3> v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
    GABOR_INLINE T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    GABOR_INLINE T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    GABOR_OF_THREE
};

template <typename T>
struct gabor_vector<T, 4> {
    T x, y, z, w;
    gabor_vector() = default;
    GABOR_INLINE gabor_vector(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, T z_, T w_) : x(v.x), y(v.y), z(z_), w(w_) {}
    GABOR_INLINE gabor_vector(T x_, gabor_vector<T, 2> v, T w_) : x(x_), y(v.x), z(v.y), w(w_) {}
    GABOR_INLINE gabor_vector(T x_, T y_, gabor_vector<T, 2> v) : x(x_), y(y_), z(v.x), w(v.y) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 2> v, gabor_vector<T, 2> u) : x(v.x), y(v.y), z(u.x), w(u.y) {}
    GABOR_INLINE gabor_vector(gabor_vector<T, 3> v, T w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    GABOR_INLINE gabor_vector(T x_, gabor_vector<T, 3> v) : x(x_), y(v.x), z(v.y), w(v.z) {}
    GABOR_INLINE explicit gabor_vector(T all) : x(all), y(all), z(all), w(all) {}
    template <typename U>
    GABOR_INLINE explicit gabor_vector(gabor_vector<U, 4> v) : x(T(v.x)), y(T(v.y)), z(T(v.z)), w(T(v.w)) {}
    GABOR_INLINE T& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    GABOR_INLINE T operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    GABOR_OF_FOUR
};

using gabor_vec2 = gabor_vector<float, 2>;
using gabor_vec3 = gabor_vector<float, 3>;
using gabor_vec4 = gabor_vector<float, 4>;
using gabor_ivec2 = gabor_vector<int, 2>;
using gabor_ivec3 = gabor_vector<int, 3>;
using gabor_ivec4 = gabor_vector<int, 4>;
using gabor_uvec2 = gabor_vector<std::uint32_t, 2>;
using gabor_uvec3 = gabor_vector<std::uint32_t, 3>;
using gabor_uvec4 = gabor_vector<std::uint32_t, 4>;
using gabor_bvec2 = gabor_vector<bool, 2>;
using gabor_bvec3 = gabor_vector<bool, 3>;
using gabor_bvec4 = gabor_vector<bool, 4>;

// Defines a function that applies `function` to each component. R is the type of the result's components.
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
#define GABOR_REST(a, b) (a) % (b)
#define GABOR_AND(a, b) (a) & (b)
#define GABOR_OR(a, b) (a) | (b)
#define GABOR_XOR(a, b) (a) ^ (b)
#define GABOR_LEFT(a, b) (a) << (b)
#define GABOR_RIGHT(a, b) (a) >> (b)
#define GABOR_NEGATIVE(a) -(a)
#define GABOR_INVERTED(a) ~(a)
#define GABOR_BELOW(a, b) (a) < (b)
#define GABOR_UP_TO(a, b) (a) <= (b)
#define GABOR_ABOVE(a, b) (a) > (b)
#define GABOR_FROM(a, b) (a) >= (b)
#define GABOR_EQUAL(a, b) (a) == (b)
#define GABOR_UNEQUAL(a, b) (a) != (b)
GABOR_OPERATOR(+, GABOR_PLUS)
GABOR_OPERATOR(-, GABOR_MINUS)
GABOR_OPERATOR(*, GABOR_TIMES)
GABOR_OPERATOR(/, GABOR_OVER)
GABOR_OPERATOR(%, GABOR_REST)
GABOR_OPERATOR(&, GABOR_AND)
GABOR_OPERATOR(|, GABOR_OR)
GABOR_OPERATOR(^, GABOR_XOR)
GABOR_OPERATOR(<<, GABOR_LEFT)
GABOR_OPERATOR(>>, GABOR_RIGHT)
GABOR_EACH(operator-, T, GABOR_NEGATIVE)
GABOR_EACH(operator~, T, GABOR_INVERTED)
GABOR_EACH_2(operator<, bool, GABOR_BELOW)
GABOR_EACH_2(operator<=, bool, GABOR_UP_TO)
GABOR_EACH_2(operator>, bool, GABOR_ABOVE)
GABOR_EACH_2(operator>=, bool, GABOR_FROM)
GABOR_EACH_2(operator==, bool, GABOR_EQUAL)
GABOR_EACH_2(operator!=, bool, GABOR_UNEQUAL)

GABOR_INLINE bool gabor_cpp_all(gabor_vector<bool, 2> v) {
    return v.x && v.y;
}
GABOR_INLINE bool gabor_cpp_any(gabor_vector<bool, 2> v) {
    return v.x || v.y;
}
GABOR_INLINE bool gabor_cpp_all(gabor_vector<bool, 3> v) {
    return v.x && v.y && v.z;
}
GABOR_INLINE bool gabor_cpp_any(gabor_vector<bool, 3> v) {
    return v.x || v.y || v.z;
}
GABOR_INLINE bool gabor_cpp_all(gabor_vector<bool, 4> v) {
    return v.x && v.y && v.z && v.w;
}
GABOR_INLINE bool gabor_cpp_any(gabor_vector<bool, 4> v) {
    return v.x || v.y || v.z || v.w;
}

// Returns condition ? a : b without a branch, which would prevent vectorization.
GABOR_INLINE float gabor_cpp_choose(bool condition, float a, float b) {
    std::uint32_t x, y;
    std::memcpy(&x, &a, sizeof x);
    std::memcpy(&y, &b, sizeof y);
    const std::uint32_t mask = std::uint32_t(-int(condition));
    x = (x & mask) | (y & ~mask);
    std::memcpy(&a, &x, sizeof a);
    return a;
}

// Replaces std::floor, which is a function call on processors without an instruction for it. All floats
// beyond 2^23 are integers.
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
GABOR_INLINE int gabor_cpp_abs(int x) {
    return x < 0 ? -x : x;
}
template <typename T>
GABOR_INLINE T gabor_cpp_sign(T x) {
    return T(x > T(0)) - T(x < T(0));
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
GABOR_INLINE std::uint32_t gabor_cpp_min(std::uint32_t a, std::uint32_t b) {
    return b < a ? b : a;
}
GABOR_INLINE std::uint32_t gabor_cpp_max(std::uint32_t a, std::uint32_t b) {
    return a < b ? b : a;
}
GABOR_INLINE float gabor_cpp_step(float edge, float x) {
    return gabor_cpp_choose(x < edge, 0.0f, 1.0f);
}
GABOR_INLINE float gabor_cpp_sin(float x) {
    return std::sin(x);
}
GABOR_INLINE float gabor_cpp_cos(float x) {
    return std::cos(x);
}
GABOR_INLINE float gabor_cpp_tan(float x) {
    return std::tan(x);
}
GABOR_INLINE float gabor_cpp_asin(float x) {
    return std::asin(x);
}
GABOR_INLINE float gabor_cpp_acos(float x) {
    return std::acos(x);
}
GABOR_INLINE float gabor_cpp_atan(float x) {
    return std::atan(x);
}
GABOR_INLINE float gabor_cpp_exp(float x) {
    return std::exp(x);
}
GABOR_INLINE float gabor_cpp_exp2(float x) {
    return std::exp2(x);
}
GABOR_INLINE float gabor_cpp_log(float x) {
    return std::log(x);
}
GABOR_INLINE float gabor_cpp_log2(float x) {
    return std::log2(x);
}
GABOR_INLINE float gabor_cpp_pow(float x, float y) {
    return std::pow(x, y);
}
GABOR_INLINE float gabor_cpp_inversesqrt(float x) {
    return 1.0f / std::sqrt(x);
}
GABOR_INLINE float gabor_cpp_atan(float y, float x) {
    return std::atan2(y, x);
}
GABOR_INLINE float gabor_cpp_uintBitsToFloat(std::uint32_t bits) {
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}
GABOR_INLINE float gabor_cpp_intBitsToFloat(int bits) {
    return gabor_cpp_uintBitsToFloat(std::uint32_t(bits));
}
GABOR_INLINE std::uint32_t gabor_cpp_floatBitsToUint(float x) {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
GABOR_INLINE int gabor_cpp_floatBitsToInt(float x) {
    return int(gabor_cpp_floatBitsToUint(x));
}
GABOR_EACH(gabor_cpp_floor, T, gabor_cpp_floor)
GABOR_EACH(gabor_cpp_fract, T, gabor_cpp_fract)
GABOR_EACH(gabor_cpp_sin, T, gabor_cpp_sin)
GABOR_EACH(gabor_cpp_cos, T, gabor_cpp_cos)
GABOR_EACH(gabor_cpp_tan, T, gabor_cpp_tan)
GABOR_EACH(gabor_cpp_asin, T, gabor_cpp_asin)
GABOR_EACH(gabor_cpp_acos, T, gabor_cpp_acos)
GABOR_EACH(gabor_cpp_atan, T, gabor_cpp_atan)
GABOR_EACH_2(gabor_cpp_atan, T, gabor_cpp_atan)
GABOR_EACH(gabor_cpp_exp, T, gabor_cpp_exp)
GABOR_EACH(gabor_cpp_exp2, T, gabor_cpp_exp2)
GABOR_EACH(gabor_cpp_log, T, gabor_cpp_log)
GABOR_EACH(gabor_cpp_log2, T, gabor_cpp_log2)
GABOR_EACH(gabor_cpp_inversesqrt, T, gabor_cpp_inversesqrt)
GABOR_EACH(gabor_cpp_sign, T, gabor_cpp_sign<T>)
GABOR_EACH(gabor_cpp_uintBitsToFloat, float, gabor_cpp_uintBitsToFloat)
GABOR_EACH(gabor_cpp_intBitsToFloat, float, gabor_cpp_intBitsToFloat)
GABOR_EACH(gabor_cpp_floatBitsToUint, std::uint32_t, gabor_cpp_floatBitsToUint)
GABOR_EACH(gabor_cpp_floatBitsToInt, int, gabor_cpp_floatBitsToInt)
GABOR_EACH_2(gabor_cpp_step, T, gabor_cpp_step)
GABOR_EACH_2(gabor_cpp_pow, T, gabor_cpp_pow)
GABOR_EACH(gabor_cpp_ceil, T, gabor_cpp_ceil)
GABOR_EACH(gabor_cpp_abs, T, gabor_cpp_abs)
GABOR_EACH(gabor_cpp_sqrt, T, gabor_cpp_sqrt)
GABOR_EACH_2(gabor_cpp_min, T, gabor_cpp_min)
GABOR_EACH_2(gabor_cpp_max, T, gabor_cpp_max)
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_max(gabor_vector<T, N> a, T b) {
    return gabor_cpp_max(a, gabor_vector<T, N>(b));
}
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_min(gabor_vector<T, N> a, T b) {
    return gabor_cpp_min(a, gabor_vector<T, N>(b));
}
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_step(T edge, gabor_vector<T, N> v) {
    return gabor_cpp_step(gabor_vector<T, N>(edge), v);
}
template <typename T>
GABOR_INLINE T gabor_cpp_clamp(T x, T low, T high) {
    return gabor_cpp_min(gabor_cpp_max(x, low), high);
}
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_clamp(gabor_vector<T, N> v, T low, T high) {
    return gabor_cpp_min(gabor_cpp_max(v, gabor_vector<T, N>(low)), gabor_vector<T, N>(high));
}
GABOR_INLINE float gabor_cpp_mix(float a, float b, float share) {
    return a * (1.0f - share) + b * share;
}
template <typename T, int N, typename S>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_mix(gabor_vector<T, N> a, gabor_vector<T, N> b, S share) {
    return a * (T(1) - share) + b * share;
}
GABOR_INLINE float gabor_cpp_smoothstep(float low, float high, float x) {
    const float t = gabor_cpp_clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}
template <int N>
GABOR_INLINE gabor_vector<float, N>
gabor_cpp_smoothstep(gabor_vector<float, N> low, gabor_vector<float, N> high, gabor_vector<float, N> v) {
    const gabor_vector<float, N> t = gabor_cpp_clamp((v - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}
template <int N>
GABOR_INLINE gabor_vector<float, N> gabor_cpp_smoothstep(float low, float high, gabor_vector<float, N> v) {
    return gabor_cpp_smoothstep(gabor_vector<float, N>(low), gabor_vector<float, N>(high), v);
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
template <int N>
GABOR_INLINE float gabor_cpp_length(gabor_vector<float, N> v) {
    return std::sqrt(gabor_cpp_dot(v, v));
}
template <int N>
GABOR_INLINE float gabor_cpp_distance(gabor_vector<float, N> a, gabor_vector<float, N> b) {
    return gabor_cpp_length(a - b);
}
template <int N>
GABOR_INLINE gabor_vector<float, N> gabor_cpp_normalize(gabor_vector<float, N> v) {
    return v / gabor_cpp_length(v);
}
GABOR_INLINE gabor_vec3 gabor_cpp_cross(gabor_vec3 a, gabor_vec3 b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

#undef GABOR_TWO
#undef GABOR_THREE
#undef GABOR_SAME
#undef GABOR_OF_TWO
#undef GABOR_OF_THREE
#undef GABOR_OF_FOUR
#undef GABOR_EACH
#undef GABOR_EACH_2
#undef GABOR_OPERATOR
#undef GABOR_PLUS
#undef GABOR_MINUS
#undef GABOR_TIMES
#undef GABOR_OVER
#undef GABOR_AND
#undef GABOR_LEFT
#undef GABOR_RIGHT
#undef GABOR_NEGATIVE
#undef GABOR_REST
#undef GABOR_OR
#undef GABOR_XOR
#undef GABOR_INVERTED
#undef GABOR_BELOW
#undef GABOR_UP_TO
#undef GABOR_ABOVE
#undef GABOR_FROM
#undef GABOR_EQUAL
#undef GABOR_UNEQUAL
#endif // GABOR_VECTORS_HPP
