#include "reference/sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

using std::numbers::pi;

// A sample point for a function's mean under a normal density in the plane, with its weight.
struct NormalPoint {
    double u; // position along the first axis, in deviations
    double v; // position along the second axis, in deviations
    double weight;
};

// Points of the trapezoidal rule out to six deviations. Their spacing is at most `step`, in the unit of the
// deviations, and at most two thirds of a deviation, at which the rule errs by less than 1e-15.
std::vector<NormalPoint> normal_points(const std::array<double, 2>& deviations, double step) {
    std::array<int, 2> half{};
    for (std::size_t i = 0; i < 2; ++i)
        if (deviations[i] >= 1e-7)
            half[i] = std::max(9, static_cast<int>(std::ceil(6 * deviations[i] / step)));
    std::vector<NormalPoint> points;
    double weights = 0;
    for (int j = -half[1]; j <= half[1]; ++j) {
        for (int i = -half[0]; i <= half[0]; ++i) {
            const double u = half[0] ? 6.0 * i / half[0] : 0;
            const double v = half[1] ? 6.0 * j / half[1] : 0;
            if (u * u + v * v > 36)
                continue;
            points.push_back({u, v, std::exp(-(u * u + v * v) / 2)});
            weights += points.back().weight;
        }
    }
    for (NormalPoint& point : points)
        point.weight /= weights;
    return points;
}

// Converts a place to a term's own kernel radii and nodes.
template <std::size_t N>
Place<N> placed(const Place<N>& place, const Vector<N>& radius) {
    Place<N> own = place;
    for (std::size_t axis = 0; axis < N; ++axis) {
        if (radius[axis] == 1)
            continue;
        own.radius[axis] = 1.5;
        const double nodes = place.radius[axis] * radius[axis]; // nodes of `place` per radius of the term
        if (place.period[axis]) {
            const double length = place.period[axis] / nodes;
            own.period[axis] = std::max(3, static_cast<int>(std::lround(1.5 * length)));
            own.radius[axis] = own.period[axis] / length;
        }
        own.local[axis] = (place.cell[axis] + place.local[axis]) / nodes * own.radius[axis];
        own.cell[axis] = 0;
    }
    return own;
}

// The spacing at which a noise's mean under a normal density is exact to 1e-9.
template <std::size_t N>
double step_of(double frequency, const Vector<N>& radius) {
    return std::min(0.1, 0.3 / (frequency + 1e-9)) * std::ranges::min(radius);
}

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

double hann_correlation(double x) {
    x = std::abs(x);
    if (x >= 2)
        return 0;
    const double turn = std::numbers::pi * x;
    return ((2 - x) * (1 + 0.5 * std::cos(turn)) + 1.5 / std::numbers::pi * std::sin(turn)) / 3;
}

template <std::size_t N>
std::array<Vector<N>, 2> principal_axes(const Vector<N>& dx, const Vector<N>& dy) {
    const double angle = 0.5 * std::atan2(2 * dot(dx, dy), dot(dx, dx) - dot(dy, dy));
    return {sum(std::cos(angle) / 2, dx, std::sin(angle) / 2, dy),
            sum(-std::sin(angle) / 2, dx, std::cos(angle) / 2, dy)};
}

template std::array<Vector<2>, 2> principal_axes(const Vector<2>&, const Vector<2>&);

template <std::size_t N>
Field<N> Sum<N>::field(const Place<N>& place) const {
    Field<N> all;
    for (const auto& [weight, noise, radius] : terms_)
        all.add(weight, noise.field(placed(place, radius)), radius);
    return all;
}

template <std::size_t N>
Field<N> Sum<N>::filtered(const Place<N>& place, const Vector<N>& dx, const Vector<N>& dy) const {
    const auto [longer, shorter] = principal_axes(dx, dy);
    Field<N> mean;
    for (const auto& [weight, noise, radius] : terms_) {
        for (const auto& [u, v, share] :
             normal_points({length(longer), length(shorter)}, step_of(noise.frequency(), radius))) {
            Place<N> there = place;
            for (std::size_t axis = 0; axis < N; ++axis)
                there.local[axis] += (u * longer[axis] + v * shorter[axis]) * place.radius[axis];
            mean.add(share * weight, noise.field(placed(there, radius)), radius);
        }
    }
    return mean;
}

// The variance of the filtered noise is the mean covariance of the noise between two points drawn
// independently from the filter. Their difference is normal, with twice the covariance of the filter.
template <std::size_t N>
double Sum<N>::removed(const Place<N>& place, const Vector<N>& dx, const Vector<N>& dy) const {
    const auto [longer, shorter] = principal_axes(dx, dy);
    const double apart = std::numbers::sqrt2;
    double kept = 0;
    for (const auto& [weight, noise, radius] : terms_) {
        const Place<N> own = placed(place, radius);
        for (const auto& [u, v, share] : normal_points({apart * length(longer), apart * length(shorter)},
                                                       step_of(noise.frequency(), radius))) {
            const Vector<N> offset = sum(apart * u, longer, apart * v, shorter);
            Vector<N> in_radii;
            double windows = 1;
            for (std::size_t axis = 0; axis < N; ++axis) {
                in_radii[axis] = offset[axis] / radius[axis];
                windows *= hann_correlation(in_radii[axis] * own.radius[axis] / 1.5);
            }
            if (windows > 0) // most offsets in a large pixel exceed the windows' reach
                kept += share * weight * weight * windows * noise.correlation(in_radii);
        }
    }
    return 1 - kept;
}

template class Sum<2>;
template class Sum<3>;

Sum<2> spectrum(const std::vector<SpectrumLobe>& lobes) {
    double power = 0;
    for (const SpectrumLobe& lobe : lobes)
        power += lobe.power;
    Sum<2> sum;
    for (const SpectrumLobe& lobe : lobes) {
        Vector<2> wave = wave_along(lobe.frequency, lobe.orientation);
        for (std::size_t axis = 0; axis < 2; ++axis)
            wave[axis] *= lobe.radius[axis];
        sum.add(std::sqrt(lobe.power / power), wave_noise(3, wave, lobe.seed), lobe.radius);
    }
    return sum;
}

// A range is cut into n pieces with a lobe in the middle of each, where n is the integer part of a count c.
// As the fraction of c goes from 0.8 to 1, the amplitudes of these lobes fall linearly to 0, and those of n +
// 1 other lobes rise.
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
                             lattice_derived_seed(seed, 128 * along.index + around.index)});
    }
    return lobes;
}

Sum<3> surface_noise(const Vector<3>& normal, double frequency, const Vector<3>& direction,
                     std::uint32_t seed) {
    const Vector<3> axis = std::abs(direction[2]) < 0.7 ? Vector<3>{0, 0, 1} : Vector<3>{1, 0, 0};
    const Vector<3> other = cross(direction, axis);
    const Vector<3> along = sum(1, direction, -dot(direction, normal), normal);
    const Vector<3> instead = sum(1, other, -dot(other, normal), normal);
    const double first = smoothstep(1.0 / 16, 1.0 / 4, dot(along, along));
    Sum<3> sum;
    const auto add = [&](const Vector<3>& wave, double weight, int index) {
        if (weight > 0)
            sum.add(weight / std::hypot(first, 1 - first),
                    wave_noise(3, scaled(frequency, unit(wave)), lattice_derived_seed(seed, index)));
    };
    add(along, first, 0);
    add(instead, 1 - first, 1);
    return sum;
}

Sum<3> isotropic_surface_noise(const Vector<3>& normal, double frequency, std::uint32_t seed) {
    const double first = smoothstep(0.25, 0.5, 1 - normal[2] * normal[2]);
    const double length = std::hypot(first, 1 - first);
    Sum<3> sum;
    const auto add = [&](const Vector<3>& axis, double weight, int index) {
        if (weight == 0)
            return;
        const Vector<3> along = unit(cross(axis, normal));
        sum.add(weight / length,
                tangent_noise(frequency, {along, cross(normal, along)}, lattice_derived_seed(seed, index)));
    };
    add({0, 0, 1}, first, 0);
    add({1, 0, 0}, 1 - first, 1);
    return sum;
}

} // namespace gabor::noise
