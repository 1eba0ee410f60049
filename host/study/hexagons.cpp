#include "study/hexagons.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::study {

namespace {

using Vector = std::array<double, 2>;

double dot(const Vector& u, const Vector& v) {
    return u[0] * v[0] + u[1] * v[1];
}

Vector less(const Vector& u, const Vector& v, double times) {
    return {u[0] - times * v[0], u[1] - times * v[1]};
}

// Lagrange's reduction: a is a shortest vector, b a shortest one beside it.
void reduce(Vector& a, Vector& b) {
    for (;;) {
        if (dot(b, b) < dot(a, a))
            std::swap(a, b);
        const Vector shorter = less(b, a, std::round(dot(a, b) / dot(a, a)));
        if (dot(shorter, shorter) >= dot(b, b) - 1e-12)
            break;
        b = shorter;
    }
    if (dot(a, b) < 0)
        b = {-b[0], -b[1]};
}

// Of the triangle 0, a, b, which is that of the hexagon's corners.
double circumradius(const Vector& a, const Vector& b) {
    const double area = std::abs(a[0] * b[1] - a[1] * b[0]) / 2;
    const Vector c = less(b, a, 1);
    return std::sqrt(dot(a, a) * dot(b, b) * dot(c, c)) / (4 * area);
}

} // namespace

Hexagons hexagons(int n) {
    Hexagons best;
    for (int step = 0; step < n; ++step) {
        Vector a{1.0 / n, static_cast<double>(step) / n};
        Vector b{0, 1};
        reduce(a, b);
        if (dot(a, a) > dot(best.a, best.a) + 1e-12)
            best = {step, a, b, std::max(0.0, circumradius(a, b) - 0.5 / n)};
    }
    // One square cell needs no neighbours beyond the usual ones.
    if (n == 1)
        best.overhang = 0;
    return best;
}

} // namespace gabor::study
