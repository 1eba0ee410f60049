#include "noise/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace gabor::noise {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double nodes_per_radius = 1.5;

std::uint32_t mix(std::uint32_t word, std::uint32_t salt) {
    word = (word ^ word >> 16) * 0x21f0aaadu + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

// The word of a column or, with `rows`, of a row of nodes.
std::uint32_t line_word(std::int64_t index, std::uint32_t seed, std::uint32_t rows) {
    const std::uint32_t salt = mix(seed * 0x9e3779b1u, 0x2545f491u) ^ rows;
    std::uint32_t word = static_cast<std::uint32_t>(index) * 0x9e3779b1u + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word >> 8 | 0x800001u;
}

// The law of one part of an amplitude, of u in [-1, 1], scaled to variance 1 where u is uniform.
double amplitude_part(double u) {
    constexpr double slope = 0.79794583;
    constexpr double edge = 1.7317979e9 / 2147483648.0;
    // With s the slope and e the edge, the integral of (u - s min(u, e))^2 from 0 to 1.
    const double inner = (1 - slope) * (1 - slope) * edge * edge * edge / 3;
    const double outer = (std::pow(1 - slope * edge, 3) - std::pow(edge - slope * edge, 3)) / 3;
    return (u - slope * std::clamp(u, -edge, edge)) / std::sqrt(inner + outer);
}

// The amplitude of a node: u is the word's high byte, in the middle of its step, and then the 24 bits below.
std::complex<double> amplitude(std::int64_t column, std::int64_t row, std::uint32_t seed) {
    const std::uint32_t word = line_word(column, seed, 0) * line_word(row, seed, 0x5bd1e995u);
    return {amplitude_part((static_cast<std::int8_t>(word >> 24) + 0.5) / 128),
            amplitude_part(static_cast<std::int32_t>(word << 8) / 2147483648.0)};
}

double hann(double x) {
    return std::abs(x) < 1 ? 0.5 + 0.5 * std::cos(pi * x) : 0;
}

double hann_slope(double x) {
    return std::abs(x) < 1 ? -0.5 * pi * std::sin(pi * x) : 0;
}

// Of a normal filter: its two principal axes, as long as its standard deviations.
std::array<Spectrum::Vector, 2> principal_axes(Spectrum::Vector dx, Spectrum::Vector dy) {
    const double xx = (dx[0] * dx[0] + dy[0] * dy[0]) / 4;
    const double yy = (dx[1] * dx[1] + dy[1] * dy[1]) / 4;
    const double xy = (dx[0] * dx[1] + dy[0] * dy[1]) / 4;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double longer = std::sqrt(std::max(0.0, xx * c * c + 2 * xy * c * s + yy * s * s));
    const double shorter = std::sqrt(std::max(0.0, xx * s * s - 2 * xy * c * s + yy * c * c));
    return {{{c * longer, s * longer}, {-s * shorter, c * shorter}}};
}

// The mean of a function under a normal density with these axes times `widening`, by the trapezoidal rule
// over six deviations each way: `step` is the longest allowed along an axis.
double normal_mean(const std::array<Spectrum::Vector, 2>& axes, double widening, double step,
                   const std::function<double(double, double)>& function) {
    std::array<int, 2> half{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double deviation = widening * std::hypot(axes[i][0], axes[i][1]);
        half[i] = deviation < 1e-7 ? 0 : std::max(18, static_cast<int>(std::ceil(6 * deviation / step)));
    }
    double sum = 0;
    double weights = 0;
    for (int j = -half[1]; j <= half[1]; ++j) {
        for (int i = -half[0]; i <= half[0]; ++i) {
            const double u = half[0] ? 6.0 * i / half[0] : 0;
            const double v = half[1] ? 6.0 * j / half[1] : 0;
            const double weight = std::exp(-(u * u + v * v) / 2);
            sum += weight * function(widening * (u * axes[0][0] + v * axes[1][0]),
                                     widening * (u * axes[0][1] + v * axes[1][1]));
            weights += weight;
        }
    }
    return sum / weights;
}

// integral of h(t) h(t + x) over that of h^2: with c = cos(pi x), the overlap of two Hann windows x apart.
double hann_correlation(double x) {
    x = std::abs(x);
    if (x >= 2)
        return 0;
    return ((2 - x) * (1 + 0.5 * std::cos(pi * x)) + 1.5 / pi * std::sin(pi * x)) / 3;
}

} // namespace

std::uint32_t lobe_seed_of(std::uint32_t seed, int index) {
    return mix(seed + static_cast<std::uint32_t>(index) * 0x85ebca6bu, 0x9e3779b1u);
}

// A range is cut into n pieces with a lobe in the middle of each, n the whole part of c. While the rest of c
// goes from 0.8 to 1 these fade out and n + 1 others fade in.
std::vector<SpectrumLobe> spread_lobes(double frequency, double orientation, double frequency_spread,
                                       double orientation_spread, std::uint32_t seed) {
    struct Piece {
        double middle; // of the range from -1 to 1
        double share;
        int index;
    };
    const auto pieces = [](double c) {
        std::vector<Piece> result;
        const int whole = static_cast<int>(c);
        const double fade = std::max(0.0, (c - whole - 0.8) / 0.2);
        for (const int n : {whole, whole + 1}) {
            const double share = n == whole ? 1 - fade : fade;
            for (int i = 0; i < n && share > 0; ++i)
                result.push_back({(2 * i + 1.0) / n - 1, share / n, i + n % 2 * 64});
        }
        return result;
    };
    std::vector<SpectrumLobe> lobes;
    for (const Piece& along : pieces(std::clamp(2.857 * frequency_spread * frequency + 0.8, 1.0, 16.0))) {
        const double magnitude = frequency * (1 + frequency_spread * along.middle);
        const double count = orientation_spread * 2 / pi * (4.44 * magnitude + 0.6) + 0.8;
        for (const Piece& around : pieces(std::clamp(count, 1.0, 64.0)))
            lobes.push_back({magnitude, orientation + orientation_spread * around.middle, 1,
                             along.share * around.share,
                             lobe_seed_of(seed, 128 * along.index + around.index)});
    }
    return lobes;
}

// n(p) = sum over lobes of sqrt(power) K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)), and
// at every place sum_i h(x - x_i)^2 = 9/8 with three nodes in reach, E|A|^2 = 2.
Spectrum::Field Spectrum::field(double x, double y) const {
    using namespace std::complex_literals;
    double power = 0;
    for (const SpectrumLobe& lobe : lobes_)
        power += lobe.power;
    Field sum{};
    for (const SpectrumLobe& lobe : lobes_) {
        const double scale = std::sqrt(lobe.power / power) * 8 / 9;
        const double px = x / lobe.radius;
        const double py = y / lobe.radius;
        const double fx = lobe.frequency * lobe.radius * std::cos(lobe.orientation);
        const double fy = lobe.frequency * lobe.radius * std::sin(lobe.orientation);
        const auto nearest_x = static_cast<std::int64_t>(std::llround(px * nodes_per_radius));
        const auto nearest_y = static_cast<std::int64_t>(std::llround(py * nodes_per_radius));
        for (std::int64_t j = nearest_y - 2; j <= nearest_y + 2; ++j) {
            const double dy = py - static_cast<double>(j) / nodes_per_radius;
            if (std::abs(dy) >= 1)
                continue;
            for (std::int64_t i = nearest_x - 2; i <= nearest_x + 2; ++i) {
                const double dx = px - static_cast<double>(i) / nodes_per_radius;
                if (std::abs(dx) >= 1)
                    continue;
                const auto wave =
                    scale * amplitude(i, j, lobe.seed) * std::exp(2i * pi * (fx * dx + fy * dy));
                sum.value += hann(dx) * hann(dy) * wave;
                sum.slope_x += (hann_slope(dx) + 2i * pi * fx * hann(dx)) * hann(dy) * wave / lobe.radius;
                sum.slope_y += (hann_slope(dy) + 2i * pi * fy * hann(dy)) * hann(dx) * wave / lobe.radius;
            }
        }
    }
    return sum;
}

double Spectrum::filtered(double x, double y, Vector dx, Vector dy) const {
    double step = 1;
    for (const SpectrumLobe& lobe : lobes_)
        step = std::min({step, 0.06 * lobe.radius, 0.15 / (lobe.frequency + 1e-9)});
    return normal_mean(principal_axes(dx, dy), 1, step,
                       [&](double u, double v) { return field(x - u, y - v).value.imag(); });
}

// The filtered noise's variance is the mean of its covariance between two points that the filter draws
// independently, whose difference is normal with twice the covariance.
double Spectrum::removed(Vector dx, Vector dy) const {
    double kept = 0;
    double power = 0;
    for (const SpectrumLobe& lobe : lobes_) {
        const double fx = lobe.frequency * std::cos(lobe.orientation);
        const double fy = lobe.frequency * std::sin(lobe.orientation);
        kept += lobe.power * normal_mean(principal_axes(dx, dy), std::numbers::sqrt2, 0.03 * lobe.radius,
                                         [&](double u, double v) {
                                             return hann_correlation(u / lobe.radius) *
                                                    hann_correlation(v / lobe.radius) *
                                                    std::cos(2 * pi * (fx * u + fy * v));
                                         });
        power += lobe.power;
    }
    return 1 - kept / power;
}

} // namespace gabor::noise
