// ---- The types and functions of GLSL that the noise uses ------------------------------------------------

#ifndef GABOR_VECTORS_HPP
#define GABOR_VECTORS_HPP

#include <cmath>
#include <cstdint>
#include <cstring>

// Compilers vectorize loops over points only if everything is inlined. Without such loops, define it as
// inline to compile faster.
#ifdef GABOR_INLINE
#elif defined(__GNUC__)
#define GABOR_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define GABOR_INLINE __forceinline
#else
#define GABOR_INLINE inline
#endif

template <typename T, int N>
struct gabor_vector;

// Defines a function that returns components of a vector.
#define GABOR_IMPL_GET(name, count, ...)                                                                     \
    GABOR_INLINE gabor_vector<T, count> name() const {                                                       \
        return {__VA_ARGS__};                                                                                \
    }
#define GABOR_IMPL_OF_TWO                                                                                    \
    GABOR_IMPL_GET(xy, 2, x, y)                                                                              \
    GABOR_IMPL_GET(yx, 2, y, x) GABOR_IMPL_GET(xx, 2, x, x) GABOR_IMPL_GET(yy, 2, y, y)
#define GABOR_IMPL_OF_THREE                                                                                  \
    GABOR_IMPL_OF_TWO GABOR_IMPL_GET(xz, 2, x, z) GABOR_IMPL_GET(zx, 2, z, x) GABOR_IMPL_GET(yz, 2, y, z)    \
        GABOR_IMPL_GET(zy, 2, z, y) GABOR_IMPL_GET(zz, 2, z, z) GABOR_IMPL_GET(xyz, 3, x, y, z)              \
            GABOR_IMPL_GET(yzx, 3, y, z, x) GABOR_IMPL_GET(zxy, 3, z, x, y) GABOR_IMPL_GET(xzy, 3, x, z, y)  \
                GABOR_IMPL_GET(zyx, 3, z, y, x) GABOR_IMPL_GET(yxz, 3, y, x, z)
#define GABOR_IMPL_OF_FOUR                                                                                   \
    GABOR_IMPL_OF_THREE GABOR_IMPL_GET(xw, 2, x, w) GABOR_IMPL_GET(wx, 2, w, x) GABOR_IMPL_GET(yw, 2, y, w)  \
        GABOR_IMPL_GET(wy, 2, w, y) GABOR_IMPL_GET(zw, 2, z, w) GABOR_IMPL_GET(wz, 2, w, z)                  \
            GABOR_IMPL_GET(ww, 2, w, w) GABOR_IMPL_GET(xyw, 3, x, y, w) GABOR_IMPL_GET(xzw, 3, x, z, w)      \
                GABOR_IMPL_GET(yzw, 3, y, z, w)

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
    GABOR_IMPL_OF_TWO
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
    GABOR_IMPL_OF_THREE
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
    GABOR_IMPL_OF_FOUR
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

// Returns a function's results for each component of its arguments.
template <typename F, typename... T>
GABOR_INLINE auto gabor_cpp_each(F f, gabor_vector<T, 2>... v) -> gabor_vector<decltype(f(v.x...)), 2> {
    return {f(v.x...), f(v.y...)};
}
template <typename F, typename... T>
GABOR_INLINE auto gabor_cpp_each(F f, gabor_vector<T, 3>... v) -> gabor_vector<decltype(f(v.x...)), 3> {
    return {f(v.x...), f(v.y...), f(v.z...)};
}
template <typename F, typename... T>
GABOR_INLINE auto gabor_cpp_each(F f, gabor_vector<T, 4>... v) -> gabor_vector<decltype(f(v.x...)), 4> {
    return {f(v.x...), f(v.y...), f(v.z...), f(v.w...)};
}

// Defines an operator of vectors, of numbers and vectors, and its assignment.
#define GABOR_IMPL_OPERATOR(op)                                                                              \
    template <typename T, int N>                                                                             \
    GABOR_INLINE gabor_vector<T, N> operator op(gabor_vector<T, N> a, gabor_vector<T, N> b) {                \
        return gabor_cpp_each([](T x, T y) { return x op y; }, a, b);                                        \
    }                                                                                                        \
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
GABOR_IMPL_OPERATOR(+)
GABOR_IMPL_OPERATOR(-)
GABOR_IMPL_OPERATOR(*)
GABOR_IMPL_OPERATOR(/)
GABOR_IMPL_OPERATOR(%)
GABOR_IMPL_OPERATOR(&)
GABOR_IMPL_OPERATOR(|)
GABOR_IMPL_OPERATOR(^)
GABOR_IMPL_OPERATOR(<<)
GABOR_IMPL_OPERATOR(>>)
#define GABOR_IMPL_UNARY(op)                                                                                 \
    template <typename T, int N>                                                                             \
    GABOR_INLINE gabor_vector<T, N> operator op(gabor_vector<T, N> v) {                                      \
        return gabor_cpp_each([](T x) { return op x; }, v);                                                  \
    }
GABOR_IMPL_UNARY(-)
GABOR_IMPL_UNARY(~)

// Returns condition ? a : b without a branch, which would prevent vectorization. GCC turns this form into one
// instruction.
GABOR_INLINE float gabor_cpp_choose(bool condition, float a, float b) {
    std::uint32_t x, y;
    std::memcpy(&x, &a, sizeof x);
    std::memcpy(&y, &b, sizeof y);
    const std::uint32_t mask = std::uint32_t(-int(condition));
    x = y ^ ((x ^ y) & mask);
    std::memcpy(&a, &x, sizeof a);
    return a;
}
template <typename T>
GABOR_INLINE T gabor_cpp_choose(bool condition, T a, T b) {
    return condition ? a : b;
}

// Replace std::floor and std::trunc, which are function calls on processors without an instruction for
// them. All floats beyond 2^23 are integers.
GABOR_INLINE float gabor_cpp_floor(float x) {
    const float bounded = gabor_cpp_choose(std::fabs(x) < 8388608.0f, x, 0.0f);
    const float whole = float(int(bounded));
    return gabor_cpp_choose(bounded == x, whole - gabor_cpp_choose(whole > bounded, 1.0f, 0.0f), x);
}
GABOR_INLINE float gabor_cpp_trunc(float x) {
#if defined __SSE4_1__ || defined __aarch64__ || defined __wasm__
    return std::trunc(x);
#else
    const float bounded = gabor_cpp_choose(std::fabs(x) < 8388608.0f, x, 0.0f);
    return gabor_cpp_choose(bounded == x, float(int(bounded)), x);
#endif
}
GABOR_INLINE float gabor_cpp_ceil(float x) {
    return -gabor_cpp_floor(-x);
}
GABOR_INLINE float gabor_cpp_fract(float x) {
    return x - gabor_cpp_floor(x);
}
GABOR_INLINE float gabor_cpp_inversesqrt(float x) {
#if defined __FAST_MATH__ && __GNUC__ >= 14 // miscompiles products of 1 / sqrt(x) with itself
    return std::sqrt(1.0f / x);
#else
    return 1.0f / std::sqrt(x);
#endif
}
GABOR_INLINE float gabor_cpp_step(float edge, float x) {
    return gabor_cpp_choose(x < edge, 0.0f, 1.0f);
}
GABOR_INLINE float gabor_cpp_atan(float y, float x) {
    return std::atan2(y, x);
}
GABOR_INLINE int gabor_cpp_abs(int x) {
    return x < 0 ? -x : x;
}
template <typename T>
GABOR_INLINE T gabor_cpp_sign(T x) {
    return T(x > T(0)) - T(x < T(0));
}
#define GABOR_IMPL_ORDERED(T)                                                                                \
    GABOR_INLINE T gabor_cpp_min(T a, T b) {                                                                 \
        return gabor_cpp_choose(b < a, b, a);                                                                \
    }                                                                                                        \
    GABOR_INLINE T gabor_cpp_max(T a, T b) {                                                                 \
        return gabor_cpp_choose(a < b, b, a);                                                                \
    }
GABOR_IMPL_ORDERED(float)
GABOR_IMPL_ORDERED(int)
GABOR_IMPL_ORDERED(std::uint32_t)
GABOR_INLINE float gabor_cpp_uintBitsToFloat(std::uint32_t bits) {
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

// Defines a function of numbers for vectors, too.
#define GABOR_IMPL_EACH(name)                                                                                \
    template <typename T, int N, typename... U>                                                              \
    GABOR_INLINE auto gabor_cpp_##name(gabor_vector<T, N> a, gabor_vector<U, N>... b)                        \
        ->gabor_vector<decltype(gabor_cpp_##name(a.x, b.x...)), N> {                                         \
        return gabor_cpp_each([](T x, U... y) { return gabor_cpp_##name(x, y...); }, a, b...);               \
    }
#define GABOR_IMPL_STANDARD(name)                                                                            \
    template <typename... T>                                                                                 \
    GABOR_INLINE float gabor_cpp_##name(float x, T... y) {                                                   \
        return std::name(x, y...);                                                                           \
    }                                                                                                        \
    GABOR_IMPL_EACH(name)
GABOR_IMPL_STANDARD(abs)
GABOR_IMPL_STANDARD(sin)
GABOR_IMPL_STANDARD(cos)
GABOR_IMPL_STANDARD(tan)
GABOR_IMPL_STANDARD(asin)
GABOR_IMPL_STANDARD(acos)
GABOR_IMPL_STANDARD(atan)
GABOR_IMPL_STANDARD(exp)
GABOR_IMPL_STANDARD(exp2)
GABOR_IMPL_STANDARD(pow)
GABOR_IMPL_STANDARD(log)
GABOR_IMPL_STANDARD(log2)
GABOR_IMPL_STANDARD(sqrt)
GABOR_IMPL_EACH(floor)
GABOR_IMPL_EACH(trunc)
GABOR_IMPL_EACH(ceil)
GABOR_IMPL_EACH(fract)
GABOR_IMPL_EACH(inversesqrt)
GABOR_IMPL_EACH(step)
GABOR_IMPL_EACH(sign)
GABOR_IMPL_EACH(min)
GABOR_IMPL_EACH(max)
GABOR_IMPL_EACH(uintBitsToFloat)
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_max(gabor_vector<T, N> a, T b) {
    return gabor_cpp_max(a, gabor_vector<T, N>(b));
}
template <typename T, int N>
GABOR_INLINE gabor_vector<T, N> gabor_cpp_min(gabor_vector<T, N> a, T b) {
    return gabor_cpp_min(a, gabor_vector<T, N>(b));
}
template <int N>
GABOR_INLINE gabor_vector<float, N> gabor_cpp_step(float edge, gabor_vector<float, N> v) {
    return gabor_cpp_step(gabor_vector<float, N>(edge), v);
}
// x is a number or vector, and the bounds are of the same type or numbers.
template <typename T, typename B>
GABOR_INLINE T gabor_cpp_clamp(T x, B low, B high) {
    return gabor_cpp_min(gabor_cpp_max(x, low), high);
}
template <typename T, typename S>
GABOR_INLINE T gabor_cpp_mix(T a, T b, S share) {
    return a * (1.0f - share) + b * share;
}
template <typename T, typename B>
GABOR_INLINE T gabor_cpp_smoothstep(B low, B high, T x) {
    const T t = gabor_cpp_clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
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
template <int N>
GABOR_INLINE gabor_vector<float, N> gabor_cpp_reflect(gabor_vector<float, N> v,
                                                      gabor_vector<float, N> normal) {
    return v - normal * (2.0f * gabor_cpp_dot(normal, v));
}

#endif // GABOR_VECTORS_HPP
