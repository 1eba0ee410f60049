#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gabor::noise {

template <std::size_t N>
using Vector = std::array<double, N>;

template <std::size_t N>
Vector<N> filled(double number) {
    Vector<N> result;
    result.fill(number);
    return result;
}

template <std::size_t N>
double dot(const Vector<N>& a, const Vector<N>& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < N; ++axis)
        sum += a[axis] * b[axis];
    return sum;
}

template <std::size_t N>
double length(const Vector<N>& a) {
    return std::sqrt(dot(a, a));
}

/// The weighted sum of two vectors.
template <std::size_t N>
Vector<N> sum(double s, const Vector<N>& a, double t, const Vector<N>& b) {
    Vector<N> result;
    for (std::size_t axis = 0; axis < N; ++axis)
        result[axis] = s * a[axis] + t * b[axis];
    return result;
}

template <std::size_t N>
Vector<N> scaled(double s, const Vector<N>& a) {
    return sum(s, a, 0, a);
}

template <std::size_t N>
Vector<N> unit(const Vector<N>& a) {
    return scaled(1 / length(a), a);
}

inline Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace gabor::noise
