#include "reference/spectrum.hpp"

#include "reference/lattice.hpp"
#include "reference/normal_mean.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int taps = 3;

// The principal axes of a normal filter, scaled by its standard deviations.
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

double length(const Spectrum::Vector& v) {
    return std::hypot(v[0], v[1]);
}

} // namespace

// A range is cut into n pieces with a lobe in the middle of each, where n is the integer part of c. As the
// fraction of c goes from 0.8 to 1, the amplitudes of these lobes fall linearly to 0, and those of n + 1
// other lobes rise.
std::vector<SpectrumLobe> spread_lobes(double frequency, double orientation, double frequency_spread,
                                       double orientation_spread, std::uint32_t seed) {
    struct Piece {
        double middle; // middle of the piece, in the range from -1 to 1
        double share;
        int index;
    };
    const auto pieces = [](double c) {
        std::vector<Piece> result;
        const int whole = static_cast<int>(c);
        const double fade = std::max(0.0, (c - whole - 0.8) / 0.2);
        for (const int n : {whole, whole + 1}) {
            const double amplitude = n == whole ? 1 - fade : fade;
            const double share = std::pow(amplitude / std::hypot(fade, 1 - fade), 2);
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
            lobes.push_back({magnitude,
                             orientation + orientation_spread * around.middle,
                             {1, 1},
                             along.share * around.share,
                             lattice_lobe_seed(seed, 128 * along.index + around.index)});
    }
    return lobes;
}

// Converts a place to a lobe's own kernel radius and lattice.
static LatticePlace placed(const LatticePlace& place, std::array<double, 2> radii) {
    LatticePlace result = place;
    const auto along = [](std::int32_t cell, std::int32_t period, double nodes, double radius, double& local,
                          double& lobe_nodes, std::int32_t& lobe_period) {
        const double length = period / (nodes * radius);
        if (period) {
            lobe_period = std::max(3, static_cast<int>(std::lround(1.5 * length)));
            lobe_nodes = lobe_period / length;
        } else {
            lobe_nodes = 1.5;
        }
        local = (cell + local) / (nodes * radius) * lobe_nodes;
    };
    along(place.cell_x, place.period_x, place.radius_x, radii[0], result.local_x, result.radius_x,
          result.period_x);
    along(place.cell_y, place.period_y, place.radius_y, radii[1], result.local_y, result.radius_y,
          result.period_y);
    result.cell_x = result.cell_y = 0;
    return result;
}

// Each lobe is a separate noise, in units of its own kernel radii.
Spectrum::Field Spectrum::field(const LatticePlace& place) const {
    double power = 0;
    for (const SpectrumLobe& lobe : lobes_)
        power += lobe.power;
    Field sum{};
    for (const SpectrumLobe& lobe : lobes_) {
        const Lattice lattice(taps,
                              {lobe.frequency * std::cos(lobe.orientation) * lobe.radius[0],
                               lobe.frequency * std::sin(lobe.orientation) * lobe.radius[1]},
                              lobe.seed);
        const bool standard = lobe.radius == std::array{1.0, 1.0};
        sum.add(std::sqrt(lobe.power / power), lattice.field(standard ? place : placed(place, lobe.radius)),
                lobe.radius);
    }
    return sum;
}

Spectrum::Field Spectrum::field(double x, double y) const {
    LatticePlace place;
    place.local_x = x * place.radius_x;
    place.local_y = y * place.radius_y;
    return field(place);
}

Spectrum::Field Spectrum::filtered(double x, double y, Vector dx, Vector dy) const {
    double step = 1;
    for (const SpectrumLobe& lobe : lobes_)
        step = std::min({step, 0.06 * std::ranges::min(lobe.radius), 0.15 / (lobe.frequency + 1e-9)});
    const auto [longer, shorter] = principal_axes(dx, dy);
    Field mean{};
    for (const auto& [u, v, weight] : normal_points({length(longer), length(shorter)}, step))
        mean.add(weight, field(x - u * longer[0] - v * shorter[0], y - u * longer[1] - v * shorter[1]));
    return mean;
}

// The variance of the filtered noise is the mean covariance of the noise between two points drawn
// independently from the filter. Their difference is normal, with twice the covariance of the filter.
double Spectrum::removed(Vector dx, Vector dy) const {
    const auto [longer, shorter] = principal_axes(dx, dy);
    const double apart = std::numbers::sqrt2;
    double kept = 0;
    double power = 0;
    for (const SpectrumLobe& lobe : lobes_) {
        const double fx = lobe.frequency * std::cos(lobe.orientation);
        const double fy = lobe.frequency * std::sin(lobe.orientation);
        for (const auto& [u, v, weight] : normal_points({apart * length(longer), apart * length(shorter)},
                                                        0.03 * std::ranges::min(lobe.radius))) {
            const double x = apart * (u * longer[0] + v * shorter[0]);
            const double y = apart * (u * longer[1] + v * shorter[1]);
            kept += weight * lobe.power * hann_correlation(x / lobe.radius[0]) *
                    hann_correlation(y / lobe.radius[1]) * std::cos(2 * pi * (fx * x + fy * y));
        }
        power += lobe.power;
    }
    return 1 - kept / power;
}

} // namespace gabor::noise
