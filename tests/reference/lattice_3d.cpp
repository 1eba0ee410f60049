#include "reference/lattice_3d.hpp"

#include "reference/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

using std::numbers::pi;
using Vector = Lattice3d::Vector;

constexpr double nodes_per_radius = 1.5;

std::uint32_t node_word(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return x * (y * z >> 8 | 0x800001u);
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The sum of two vectors.
Vector sum(double s, const Vector& a, double t, const Vector& b) {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

Vector scaled(double s, const Vector& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

Vector unit(const Vector& a) {
    return scaled(1 / std::sqrt(dot(a, a)), a);
}

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Lobe `index` of a range of `count`, a real number: the middle of its share, from 0 to 1, and its power.
std::array<double, 2> share(int index, double count) {
    const double power = std::min(count - index, 1.0);
    return {(index + power / 2) / count, power / count};
}

} // namespace

Lattice3d::Lattice3d(const Vector& wave, std::uint32_t seed, bool animated)
    : wave_(wave), seed_(seed), animated_(animated) {}

std::vector<Lattice3d::Node> Lattice3d::nodes(const Place& place) const {
    struct Line {
        std::uint32_t word;
        double offset;
    };
    std::array<std::vector<Line>, 3> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Three at most reach here; the windows of others end before.
        const auto first = static_cast<std::int64_t>(std::ceil(place.local[axis] - nodes_per_radius));
        for (std::int64_t i = first; static_cast<double>(i) < place.local[axis] + nodes_per_radius; ++i) {
            auto index = static_cast<std::int32_t>(static_cast<std::uint32_t>(place.cell[axis] + i));
            if (const std::int32_t period = place.period[axis])
                index = (index % period + period) % period;
            lines[axis].push_back({lattice_line_word(index, static_cast<int>(axis), seed_),
                                   place.local[axis] - static_cast<double>(i)});
        }
    }
    std::vector<Node> nodes;
    for (const Line& z : lines[2]) {
        for (const Line& y : lines[1]) {
            for (const Line& x : lines[0]) {
                const std::uint32_t word = node_word(x.word, y.word, z.word);
                // Of variance 1 in each part.
                const std::complex<double> amplitude =
                    animated_ ? lattice_amplitude(word, place.time) : lattice_amplitude(word);
                nodes.push_back({{x.offset, y.offset, z.offset}, amplitude / lattice_amplitude_deviation()});
            }
        }
    }
    return nodes;
}

Lattice3d::Field Lattice3d::field(const Place& place) const {
    using namespace std::complex_literals;
    Field field{};
    for (const Node& node : nodes(place)) {
        double turns = 0;
        std::array<double, 3> window{};
        std::array<double, 3> slope{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            turns += wave_[axis] * node.offset[axis] / place.radius[axis];
            const double x = node.offset[axis] / nodes_per_radius;
            window[axis] = (1 + std::cos(pi * x)) / 2;
            slope[axis] = -pi / 2 * std::sin(pi * x) * place.radius[axis] / nodes_per_radius;
        }
        // E[n^2] = E[|A|^2] / 2 (sum h^2)^3, sum h^2 = 9/8.
        const std::complex<double> wave = std::pow(8.0 / 9, 1.5) * node.amplitude * std::exp(2i * pi * turns);
        const double all = window[0] * window[1] * window[2];
        field.value += all * wave;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double other = window[(axis + 1) % 3] * window[(axis + 2) % 3];
            field.slope[axis] += (slope[axis] * other + 2i * pi * wave_[axis] * all) * wave;
        }
    }
    return field;
}

Lattice3d::Field Lattice3d::filtered(const Place& place, const Vector& dx, const Vector& dy) const {
    using namespace std::complex_literals;
    // Far footprints average all out: (det(1 + S^2))^(-1/4), by the traces of S and S^2.
    const double trace = (dot(dx, dx) + dot(dy, dy)) / 4;
    const double square =
        (std::pow(dot(dx, dx), 2) + std::pow(dot(dy, dy), 2) + 2 * std::pow(dot(dx, dy), 2)) / 16;
    const double determinant = (trace * trace - square) / 2;
    const double fade = std::pow(1 + square + determinant * determinant, -0.25);

    constexpr std::array share{0.25, 0.5, 0.25};           // of the window
    constexpr std::array power{1.0 / 6, 2.0 / 3, 1.0 / 6}; // of the variance
    const auto turns_of = [&](std::size_t axis, std::size_t wave) {
        return wave_[axis] + (static_cast<double>(wave) - 1) / 2 * place.radius[axis] / nodes_per_radius;
    };
    Field field{};
    double kept = 0;
    const std::vector<Node> all = nodes(place);
    // What each node has of each wave along each axis.
    std::vector<std::array<std::array<std::complex<double>, 3>, 3>> factors;
    for (const Node& node : all) {
        auto& factor = factors.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double width = std::hypot(dx[axis], dy[axis]) / 4 * place.radius[axis];
            const double to_end = nodes_per_radius - std::abs(node.offset[axis]);
            const double reach = width > 0 ? smoothstep(0, width, to_end) : 1;
            for (std::size_t wave = 0; wave < 3; ++wave)
                factor[axis][wave] =
                    share[wave] * reach *
                    std::exp(2i * pi * turns_of(axis, wave) * node.offset[axis] / double{place.radius[axis]});
        }
    }
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Vector k{turns_of(0, a), turns_of(1, b), turns_of(2, c)};
                const double blurred = (std::pow(dot(k, dx), 2) + std::pow(dot(k, dy), 2)) / 4;
                const double damped = fade * std::exp(-2 * pi * pi * blurred);
                kept += power[a] * power[b] * power[c] * damped * damped;
                std::complex<double> sum = 0;
                for (std::size_t i = 0; i < all.size(); ++i)
                    sum += all[i].amplitude * factors[i][0][a] * factors[i][1][b] * factors[i][2][c];
                const std::complex<double> one = std::pow(8.0 / 9, 1.5) * damped * sum;
                field.value += one;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    field.slope[axis] += 2i * pi * k[axis] * one;
            }
        }
    }
    field.removed = 1 - kept;
    return field;
}

std::vector<WeightedWave> isotropic_waves(double frequency, std::uint32_t seed) {
    const double count = 8 + 8 * std::pow(std::min(frequency, 8.0), 2);
    std::vector<WeightedWave> waves;
    for (int i = 0; i < count; ++i) {
        const auto [height, power] = share(i, count);
        const double azimuth = 2 * pi * (std::sqrt(5.0) - 1) / 2 * i;
        const double across = std::sqrt(1 - height * height);
        waves.push_back({std::sqrt(power),
                         scaled(frequency, {across * std::cos(azimuth), across * std::sin(azimuth), height}),
                         lattice_lobe_seed(seed, i)});
    }
    return waves;
}

std::vector<WeightedWave> surface_waves(const Vector& normal, double frequency, const Vector& direction,
                                        std::uint32_t seed) {
    const Vector axis = std::abs(direction[2]) < 0.7 ? Vector{0, 0, 1} : Vector{1, 0, 0};
    const Vector other = cross(direction, axis);
    const Vector along = sum(1, direction, -dot(direction, normal), normal);
    const Vector instead = sum(1, other, -dot(other, normal), normal);
    const double first = smoothstep(1.0 / 16, 1.0 / 4, dot(along, along));
    const double length = std::hypot(first, 1 - first);
    std::vector<WeightedWave> waves;
    if (first > 0)
        waves.push_back({first / length, scaled(frequency, unit(along)), lattice_lobe_seed(seed, 0)});
    if (first < 1)
        waves.push_back({(1 - first) / length, scaled(frequency, unit(instead)), lattice_lobe_seed(seed, 1)});
    return waves;
}

std::vector<WeightedWave> surface_isotropic_waves(const Vector& normal, double frequency,
                                                  std::uint32_t seed) {
    const double count = 2 + 4.5 * std::min(frequency, 32.0);
    const double first = smoothstep(0.25, 0.5, 1 - normal[2] * normal[2]);
    const double length = std::hypot(first, 1 - first);
    std::vector<WeightedWave> waves;
    const auto add = [&](const Vector& axis, double weight, int first_index) {
        if (weight == 0)
            return;
        const Vector along = unit(cross(axis, normal));
        for (int i = 0; i < count; ++i) {
            const auto [turn, power] = share(i, count);
            waves.push_back({weight / length * std::sqrt(power),
                             sum(frequency * std::cos(pi * turn), along, frequency * std::sin(pi * turn),
                                 cross(normal, along)),
                             lattice_lobe_seed(seed, first_index + i)});
        }
    };
    add({0, 0, 1}, first, 0);
    add({1, 0, 0}, 1 - first, 256);
    return waves;
}

} // namespace gabor::noise
