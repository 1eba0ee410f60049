#include "reference/reference_3d.hpp"

#include "noise/variance.hpp"
#include "reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

using Matrix3 = std::array<Vector3, 3>; // by rows
using std::numbers::pi;

constexpr Recipe pure{"solid-pure", 1, 1.5f, 1.0f, 256, {0.7f, -0.9f, 1.2f}, "the lowest sidelobes"};

double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 product(const Matrix3& m, const Vector3& v) {
    return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

double determinant(const Matrix3& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// By cofactors; the matrix is symmetric.
Matrix3 inverse(const Matrix3& m) {
    Matrix3 result{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            result[r][c] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / determinant(m);
        }
    }
    return result;
}

Vector3 projected(const Vector3& direction, const Vector3& plane_normal) {
    const double height = dot(direction, plane_normal);
    Vector3 result;
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = direction[c] - height * plane_normal[c];
    return result;
}

// The wave vector of length 1 along the projection of a direction to the plane; 1/8 of a unit around the
// normal its length follows the tangent of 1 / sqrt at 1/64.
Vector3 tangent(const Vector3& direction, const Vector3& plane_normal) {
    Vector3 wave = projected(direction, plane_normal);
    const double square = dot(wave, wave);
    const double scale = square > 1.0 / 64 ? 1 / std::sqrt(square) : 8 - 256 * (square - 1.0 / 64);
    for (double& coordinate : wave)
        coordinate *= scale;
    return wave;
}

// The weight of an impulse whose direction has a projection of that squared length to the tangent plane,
// before normalization.
double fade(double square) {
    const double away = std::min(8 * square, 1.0);
    return away * (2 - away);
}

// Mean of its square over the sphere, whose heights above the plane are uniform: 1 up to where the fading
// begins, then by Simpson's rule.
double mean_square_of_fade() {
    const double begin = std::sqrt(7.0 / 8);
    constexpr int intervals = 1000;
    double sum = 0;
    for (int i = 0; i <= intervals; ++i) {
        const double height = begin + (1 - begin) * i / intervals;
        const double factor = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
        sum += factor * std::pow(fade(1 - height * height), 2);
    }
    return begin + sum * (1 - begin) / (3 * intervals);
}

// The window along an axis: q and its derivative.
std::array<double, 2> window(const Recipe& recipe, double x) {
    if (std::abs(x) >= 1)
        return {0, 0};
    const double u = 1 - x * x;
    std::array<double, 2> q{};
    for (int n = 2; n <= 4; ++n) {
        const double c = recipe.window[static_cast<std::size_t>(n - 2)];
        q[0] += c * std::pow(u, n);
        q[1] += c * n * std::pow(u, n - 1) * (-2 * x);
    }
    return q;
}

std::int32_t wrapped(std::int64_t cell, std::int32_t period) {
    const std::int64_t whole = std::int64_t{1} << 32;
    const auto turned = static_cast<std::int32_t>(static_cast<std::uint32_t>((cell % whole + whole) % whole));
    return period == 0 ? turned : (turned % period + period) % period;
}

std::uint32_t mix(std::uint32_t word, std::uint32_t salt) {
    word = (word ^ word >> 16) * 0x21f0aaadu + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

} // namespace

const Recipe& pure_recipe_3d() {
    return pure;
}

double variance_3d(const Recipe& recipe) {
    const double density = recipe.impulses * std::pow(double{recipe.radius}, 3);
    return density * std::pow(window_energy(recipe, 0), 3) / 2;
}

double window_variance(const Recipe& recipe) {
    // integral of (1 - x^2)^n is sqrt(pi) n! / Gamma(n + 3/2), and with x^2 before it that over 2n + 3.
    double area = 0;
    double second = 0;
    for (int n = 2; n <= 4; ++n) {
        const double integral = recipe.window[static_cast<std::size_t>(n - 2)] * std::sqrt(pi) *
                                std::tgamma(n + 1.0) / std::tgamma(n + 1.5);
        area += integral;
        second += integral / (2 * n + 3);
    }
    return second / area;
}

std::uint32_t impulse_word_3d(const std::array<std::int32_t, 3>& cell, int index, std::uint32_t seed) {
    constexpr std::uint32_t spread = 0x9e3779b1u;
    const auto spread_cell = [&](std::size_t axis) {
        return static_cast<std::uint32_t>(cell[axis]) * spread;
    };
    const std::uint32_t seed_word = mix(seed * spread, 0x2545f491u);
    const std::uint32_t slice_word = mix(spread_cell(2) + seed_word, seed_word);
    const std::uint32_t row_word = mix(spread_cell(1) + slice_word, slice_word);
    const std::uint32_t salt = row_word + static_cast<std::uint32_t>(index) * 0x85ebca6bu;
    return mix(spread_cell(0) + salt, salt);
}

Impulse3d::Impulse3d(std::uint32_t word)
    : place{(word >> 8 & 0x7fffff) * 0x1p-23, (word & 0x7fffff) * 0x1p-23,
            (word * 0x9e3779b1u >> 9) * 0x1p-23},
      phase((word & 0xff) / 256.0), tempo(static_cast<int>(word >> 8 & 7) - 4) {
    if (tempo >= 0)
        ++tempo;
    // Uniform on the sphere, for its height and its azimuth are.
    const std::uint32_t more = mix(word, 0x85ebca6bu);
    const double height = (more >> 8 & 0x7fffff) * 0x1p-22 - 1;
    const double azimuth = 2 * pi * (more & 0x7fffff) * 0x1p-23;
    const double across = std::sqrt(1 - height * height);
    direction = {across * std::cos(azimuth), across * std::sin(azimuth), height};
}

Reference3d::Reference3d(const Recipe& recipe, const Waves& waves, std::uint32_t seed)
    : recipe_(recipe), waves_(waves), shift_{}, damping_(2 * pi * pi * window_variance(recipe)),
      amplitude_(1 / std::sqrt(variance_3d(recipe))), seed_(seed) {
    // With S the covariance of the footprint, D = S (s^2 + S)^-1, and det(1 + S / s^2).
    const double s2 = window_variance(recipe);
    Matrix3 covariance{};
    Matrix3 widened{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            covariance[r][c] = (waves.dx[r] * waves.dx[c] + waves.dy[r] * waves.dy[c]) / 4;
            widened[r][c] = covariance[r][c] + (r == c ? s2 : 0);
        }
    }
    const Matrix3 inverted = inverse(widened);
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k)
                shift_[r][c] += covariance[r][k] * inverted[k][c];
    if (dot(waves.direction, waves.direction) == 0 && dot(waves.normal, waves.normal) > 0)
        amplitude_ /= std::sqrt(mean_square_of_fade());
    amplitude_ *= std::pow(determinant(widened) / (s2 * s2 * s2), -0.25);
}

Reference3d::Field Reference3d::field(const Place3d& place) const {
    using namespace std::complex_literals;
    const bool own_directions = dot(waves_.direction, waves_.direction) == 0;
    std::array<std::int64_t, 3> lowest{};
    std::array<std::int64_t, 3> highest{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lowest[axis] =
            static_cast<std::int64_t>(std::floor(double{place.local[axis]} - double{place.radius[axis]}));
        highest[axis] =
            static_cast<std::int64_t>(std::floor(double{place.local[axis]} + double{place.radius[axis]}));
    }
    Field sum{};
    const auto add = [&](const std::array<std::int64_t, 3>& at, int index) {
        std::array<std::int32_t, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = wrapped(place.cell[axis] + at[axis], place.period[axis]);
        const Impulse3d impulse(impulse_word_3d(cell, index, seed_));
        Vector3 d{};
        std::array<std::array<double, 2>, 3> q{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            d[axis] = (place.local[axis] - static_cast<double>(at[axis]) - impulse.place[axis]) /
                      place.radius[axis];
            q[axis] = window(recipe_, d[axis]);
        }
        double weight = 1;
        Vector3 wave = tangent(waves_.direction, waves_.normal);
        if (own_directions) {
            wave = projected(impulse.direction, waves_.normal);
            const double square = dot(wave, wave);
            weight = fade(square);
            for (double& coordinate : wave)
                coordinate /= std::sqrt(square);
        }
        for (double& coordinate : wave)
            coordinate *= waves_.frequency;
        const Vector3 shift = product(shift_, wave);
        weight *= std::exp(-damping_ * dot(wave, shift));
        for (std::size_t axis = 0; axis < 3; ++axis)
            wave[axis] -= shift[axis];
        const double phase = impulse.phase + impulse.tempo * double{place.time};
        const std::complex<double> unit = weight * std::exp(2i * pi * (dot(wave, d) + phase));
        const double all = q[0][0] * q[1][0] * q[2][0];
        sum.value += all * unit;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double slope = q[axis][1] * q[(axis + 1) % 3][0] * q[(axis + 2) % 3][0];
            sum.slope[axis] += (slope + 2i * pi * wave[axis] * all) * unit;
        }
    };
    for (std::int64_t z = lowest[2]; z <= highest[2]; ++z)
        for (std::int64_t y = lowest[1]; y <= highest[1]; ++y)
            for (std::int64_t x = lowest[0]; x <= highest[0]; ++x)
                for (int k = 0; k < recipe_.impulses; ++k)
                    add({x, y, z}, k);
    // The variance is in proportion to the number of impulses per unit volume.
    double fewer = 1;
    for (const float radius : place.radius)
        fewer *= radius / recipe_.radius;
    const double scale = amplitude_ / std::sqrt(fewer);
    sum.value *= scale;
    for (std::complex<double>& slope : sum.slope)
        slope *= scale;
    return sum;
}

} // namespace gabor::noise
