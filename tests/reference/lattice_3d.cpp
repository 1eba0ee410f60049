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

Lattice3d::Nodes Lattice3d::nodes(const Place& place) const {
    Nodes nodes{};
    std::array<std::array<std::uint32_t, 3>, 3> words{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // The windows of all but three end before.
        const auto first = static_cast<std::int64_t>(std::ceil(place.local[axis] - nodes_per_radius));
        for (std::size_t line = 0; line < 3; ++line) {
            const std::int64_t i = first + static_cast<std::int64_t>(line);
            auto index = static_cast<std::int32_t>(static_cast<std::uint32_t>(place.cell[axis] + i));
            if (const std::int32_t period = place.period[axis])
                index = (index % period + period) % period;
            words[axis][line] = lattice_line_word(index, static_cast<int>(axis), seed_);
            nodes.offset[axis][line] = place.local[axis] - static_cast<double>(i);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t word = node_word(words[0][i], words[1][j], words[2][k]);
                const Complex amplitude =
                    animated_ ? lattice_amplitude(word, place.time) : lattice_amplitude(word);
                nodes.amplitude[i][j][k] = amplitude / lattice_amplitude_deviation();
            }
        }
    }
    return nodes;
}

// Sums over the last index with factors for three new values of it, which come first: out of x, y, z become
// z', x, y.
Lattice3d::Cube Lattice3d::transformed(const Cube& cube,
                                       const std::array<std::array<Complex, 3>, 3>& factors) {
    Cube result{};
    for (std::size_t to = 0; to < 3; ++to)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t from = 0; from < 3; ++from)
                    result[to][i][j] += factors[from][to] * cube[i][j][from];
    return result;
}

Lattice3d::Field Lattice3d::field(const Place& place) const {
    using namespace std::complex_literals;
    const Nodes near = nodes(place);
    struct Line {
        double window;
        double slope; // of the window, per kernel radius
        Complex wave;
    };
    std::array<std::array<Line, 3>, 3> lines{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = near.offset[axis][i] / nodes_per_radius;
            lines[axis][i] = {
                (1 + std::cos(pi * x)) / 2,
                -pi / 2 * std::sin(pi * x) * place.radius[axis] / nodes_per_radius,
                std::exp(2i * pi * wave_[axis] * near.offset[axis][i] / double{place.radius[axis]})};
        }
    }
    // E[n^2] = E[|A|^2] / 2 (sum h^2)^3, sum h^2 = 9/8.
    const double scale = std::pow(8.0 / 9, 1.5);
    Field field{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Line& x = lines[0][i];
                const Line& y = lines[1][j];
                const Line& z = lines[2][k];
                const Complex wave = scale * near.amplitude[i][j][k] * x.wave * y.wave * z.wave;
                const double all = x.window * y.window * z.window;
                field.value += all * wave;
                field.slope[0] += (x.slope * y.window * z.window + 2i * pi * wave_[0] * all) * wave;
                field.slope[1] += (x.window * y.slope * z.window + 2i * pi * wave_[1] * all) * wave;
                field.slope[2] += (x.window * y.window * z.slope + 2i * pi * wave_[2] * all) * wave;
            }
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
    const Nodes near = nodes(place);
    Cube waves = near.amplitude;
    for (const std::size_t axis : {2u, 1u, 0u}) {
        std::array<std::array<Complex, 3>, 3> factors; // what each node has of each wave
        for (std::size_t i = 0; i < 3; ++i) {
            const double offset = near.offset[axis][i];
            const double width = std::hypot(dx[axis], dy[axis]) / 4 * place.radius[axis];
            const double to_end = nodes_per_radius - std::abs(offset);
            const double reach = width > 0 ? smoothstep(0, width, to_end) : 1;
            for (std::size_t wave = 0; wave < 3; ++wave)
                factors[i][wave] =
                    share[wave] * reach *
                    std::exp(2i * pi * turns_of(axis, wave) * offset / double{place.radius[axis]});
        }
        waves = transformed(waves, factors);
    }
    Field field{};
    double kept = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Vector k{turns_of(0, a), turns_of(1, b), turns_of(2, c)};
                const double blurred = (std::pow(dot(k, dx), 2) + std::pow(dot(k, dy), 2)) / 4;
                const double damped = fade * std::exp(-2 * pi * pi * blurred);
                kept += power[a] * power[b] * power[c] * damped * damped;
                const Complex one = std::pow(8.0 / 9, 1.5) * damped * waves[a][b][c];
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
