#include "reference/lattice_3d.hpp"

#include "reference/lattice.hpp"
#include "reference/normal_mean.hpp"

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

// The weighted sum of two vectors.
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

// The two principal axes of a normal filter, as long as its standard deviations.
std::array<Vector, 2> principal_axes(const Vector& dx, const Vector& dy) {
    const double angle = 0.5 * std::atan2(2 * dot(dx, dy), dot(dx, dx) - dot(dy, dy));
    return {sum(std::cos(angle) / 2, dx, std::sin(angle) / 2, dy),
            sum(-std::sin(angle) / 2, dx, std::cos(angle) / 2, dy)};
}

double length(const Vector& a) {
    return std::sqrt(dot(a, a));
}

// How far a pixel's normal filter reaches along each axis, in nodes.
Vector reach_of(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) {
    const auto [longer, shorter] = principal_axes(dx, dy);
    Vector reach{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        reach[axis] = 6.001 * std::hypot(longer[axis], shorter[axis]) * place.radius[axis];
    return reach;
}

// The mean over a pixel of a field at offsets from the place, in nodes.
template <typename FieldAt>
Lattice3d::Field filtered_field(const Lattice3d::Place& place, const Vector& dx, const Vector& dy,
                                double frequency, const FieldAt& field_at) {
    const auto [longer, shorter] = principal_axes(dx, dy);
    const double step = std::min(0.06, 0.15 / (frequency + 1e-9));
    Lattice3d::Field mean{};
    for (const auto& [u, v, weight] : normal_points({length(longer), length(shorter)}, step)) {
        Vector offset = sum(u, longer, v, shorter);
        for (std::size_t axis = 0; axis < 3; ++axis)
            offset[axis] *= place.radius[axis];
        const Lattice3d::Field one = field_at(offset);
        mean.value += weight * one.value;
        for (std::size_t axis = 0; axis < 3; ++axis)
            mean.slope[axis] += weight * one.slope[axis];
    }
    return mean;
}

// The same as Spectrum::removed. `correlation_of` is the waves' correlation at an offset.
template <typename CorrelationOf>
double removed_share(const Lattice3d::Place& place, const Vector& dx, const Vector& dy, double step,
                     const CorrelationOf& correlation_of) {
    const auto [longer, shorter] = principal_axes(dx, dy);
    const double apart = std::numbers::sqrt2;
    double kept = 0;
    for (const auto& [u, v, weight] :
         normal_points({apart * length(longer), apart * length(shorter)}, step)) {
        const Vector offset = sum(apart * u, longer, apart * v, shorter);
        double windows = 1;
        for (std::size_t axis = 0; axis < 3 && windows > 0; ++axis)
            windows *= hann_correlation(offset[axis] * place.radius[axis] / nodes_per_radius);
        if (windows > 0) // most points of a large pixel are too far apart for the windows
            kept += weight * windows * correlation_of(offset);
    }
    return 1 - kept;
}

// The word of the line of nodes with an index along an axis, counted from the place's cell.
std::uint32_t line_word(const Lattice3d::Place& place, std::size_t axis, std::int64_t offset,
                        std::uint32_t seed) {
    auto index = static_cast<std::int32_t>(static_cast<std::uint32_t>(place.cell[axis] + offset));
    if (const std::int32_t period = place.period[axis])
        index = (index % period + period) % period;
    return lattice_line_word(index, static_cast<int>(axis), seed);
}

} // namespace

Lattice3d::Lattice3d(const Vector& wave, std::uint32_t seed, bool animated)
    : wave_(wave), seed_(seed), animated_(animated) {}

// The amplitudes of the nodes that reach a box around a place.
class Lattice3d::Nodes {
  public:
    Nodes(const Lattice3d& noise, const Place& place, const Vector& reach) {
        std::array<std::vector<std::uint32_t>, 3> words;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double around = reach[axis] + nodes_per_radius;
            first_[axis] = static_cast<std::int64_t>(std::ceil(place.local[axis] - around));
            const auto last = static_cast<std::int64_t>(std::floor(place.local[axis] + around));
            for (std::int64_t i = first_[axis]; i <= last; ++i)
                words[axis].push_back(line_word(place, axis, i, noise.seed_));
            count_[axis] = words[axis].size();
        }
        for (const std::uint32_t x : words[0])
            for (const std::uint32_t y : words[1])
                for (const std::uint32_t z : words[2])
                    amplitudes_.push_back((noise.animated_ ? lattice_amplitude(node_word(x, y, z), place.time)
                                                           : lattice_amplitude(node_word(x, y, z))) /
                                          lattice_amplitude_deviation());
    }

    const Complex& at(std::int64_t i, std::int64_t j, std::int64_t k) const {
        const auto index = [&](std::size_t axis, std::int64_t line) {
            return static_cast<std::size_t>(line - first_[axis]);
        };
        return amplitudes_[(index(0, i) * count_[1] + index(1, j)) * count_[2] + index(2, k)];
    }

  private:
    std::array<std::int64_t, 3> first_{};
    std::array<std::size_t, 3> count_{};
    std::vector<Complex> amplitudes_;
};

Lattice3d::Field Lattice3d::field(const Place& place) const {
    return field(place, {}, Nodes(*this, place, {}));
}

Lattice3d::Field Lattice3d::field(const Place& place, const Vector& offset, const Nodes& nodes) const {
    using namespace std::complex_literals;
    struct Line {
        double window;
        double slope; // slope of the window, per kernel radius
        Complex wave;
    };
    std::array<std::array<Line, 3>, 3> lines{};
    std::array<std::int64_t, 3> first{}; // the windows of all but three lines end before this place
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double local = place.local[axis] + offset[axis];
        first[axis] = static_cast<std::int64_t>(std::ceil(local - nodes_per_radius));
        for (std::size_t i = 0; i < 3; ++i) {
            const double distance = local - static_cast<double>(first[axis] + static_cast<std::int64_t>(i));
            const double x = std::min(distance / nodes_per_radius, 1.0);
            lines[axis][i] = {(1 + std::cos(pi * x)) / 2,
                              -pi / 2 * std::sin(pi * x) * place.radius[axis] / nodes_per_radius,
                              std::exp(2i * pi * wave_[axis] * distance / double{place.radius[axis]})};
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
                const Complex amplitude =
                    nodes.at(first[0] + static_cast<std::int64_t>(i), first[1] + static_cast<std::int64_t>(j),
                             first[2] + static_cast<std::int64_t>(k));
                const Complex wave = scale * amplitude * x.wave * y.wave * z.wave;
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
    const Nodes nodes(*this, place, reach_of(place, dx, dy));
    return filtered_field(place, dx, dy, length(wave_),
                          [&](const Vector& offset) { return field(place, offset, nodes); });
}

double Lattice3d::removed(const Place& place, const Vector& dx, const Vector& dy) const {
    return removed_share(place, dx, dy, 0.06,
                         [&](const Vector& offset) { return std::cos(2 * pi * dot(wave_, offset)); });
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

Isotropic3d::Isotropic3d(double frequency, std::uint32_t seed, bool animated)
    : frequency_(frequency), seed_(seed), animated_(animated) {}

Isotropic3d::Isotropic3d(double frequency, const Tangents& tangents, std::uint32_t seed, bool animated)
    : frequency_(frequency), tangents_(tangents), seed_(seed), animated_(animated) {}

Isotropic3d::Frame isotropic_frame(std::uint32_t word) {
    const auto uniform = [](std::uint32_t bits) { return static_cast<std::int32_t>(bits) / 0x1p31; };
    const double azimuth = pi / 2 * uniform(word);
    const double rise = uniform(word << 12);
    const double spin = pi / 4 * uniform(word << 20);
    const double level = std::sqrt(1 - rise * rise);
    const Vector first{level * std::cos(azimuth), level * std::sin(azimuth), rise};
    const Vector level_one{-std::sin(azimuth), std::cos(azimuth), 0};
    const Vector other = cross(first, level_one);
    return {first, sum(std::cos(spin), level_one, std::sin(spin), other),
            sum(-std::sin(spin), level_one, std::cos(spin), other)};
}

std::vector<Isotropic3d::Node> Isotropic3d::nodes(const Lattice3d::Place& place, const Vector& reach) const {
    std::array<std::vector<std::pair<double, std::uint32_t>>, 3> lines; // each line's position and word
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double around = reach[axis] + nodes_per_radius;
        for (double i = std::ceil(place.local[axis] - around); i <= place.local[axis] + around; ++i)
            lines[axis].emplace_back(i, line_word(place, axis, static_cast<std::int64_t>(i), seed_));
    }
    std::vector<Node> all;
    for (const auto& [z, z_word] : lines[2]) {
        for (const auto& [y, y_word] : lines[1]) {
            std::array<std::uint32_t, 4> row{};
            std::uint32_t mixed = y_word * z_word;
            for (std::uint32_t& word : row) {
                mixed = (mixed ^ mixed >> 15) * 0xd35a2d97u;
                word = mixed >> 8 | 0x800001u;
            }
            for (const auto& [x, x_word] : lines[0]) {
                const std::uint32_t word = x_word * row[3];
                Frame frame = isotropic_frame(word);
                std::size_t count = 3;
                if (tangents_) {
                    const double angle = pi / 2 * static_cast<std::int32_t>(word) / 0x1p31;
                    const auto& [along, across] = *tangents_;
                    frame[0] = sum(std::cos(angle), along, std::sin(angle), across);
                    frame[1] = sum(-std::sin(angle), along, std::cos(angle), across);
                    count = 2;
                }
                Node node{{x, y, z}, {}};
                for (std::size_t m = 0; m < count; ++m)
                    node.waves.push_back({scaled(frequency_, frame[m]),
                                          (animated_ ? lattice_amplitude(x_word * row[m], place.time)
                                                     : lattice_amplitude(x_word * row[m])) /
                                              lattice_amplitude_deviation()});
                all.push_back(node);
            }
        }
    }
    return all;
}

Lattice3d::Field Isotropic3d::field(const Lattice3d::Place& place) const {
    return field(place, {}, nodes(place, {}));
}

Lattice3d::Field Isotropic3d::field(const Lattice3d::Place& place, const Vector& offset,
                                    const std::vector<Node>& nodes) const {
    using namespace std::complex_literals;
    Lattice3d::Field field{};
    for (const Node& node : nodes) {
        Vector window{}, slope{}, distance{};
        bool reaches = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double apart = place.local[axis] + offset[axis] - node.index[axis];
            reaches = reaches && std::abs(apart) < nodes_per_radius;
            window[axis] = (1 + std::cos(pi * apart / nodes_per_radius)) / 2;
            slope[axis] =
                -pi / 2 * std::sin(pi * apart / nodes_per_radius) * place.radius[axis] / nodes_per_radius;
            distance[axis] = apart / double{place.radius[axis]};
        }
        if (!reaches)
            continue;
        const double all = window[0] * window[1] * window[2];
        for (const auto& [wave, amplitude] : node.waves) {
            // E[n^2] = E[|A|^2] / 2 (sum h^2)^3 for each wave of a node, sum h^2 = 9/8.
            const std::complex<double> turned = std::pow(8.0 / 9, 1.5) /
                                                std::sqrt(static_cast<double>(node.waves.size())) *
                                                amplitude * std::exp(2i * pi * dot(wave, distance));
            field.value += all * turned;
            for (std::size_t axis = 0; axis < 3; ++axis)
                field.slope[axis] += (slope[axis] * window[(axis + 1) % 3] * window[(axis + 2) % 3] +
                                      2i * pi * wave[axis] * all) *
                                     turned;
        }
    }
    return field;
}

Lattice3d::Field Isotropic3d::filtered(const Lattice3d::Place& place, const Vector& dx,
                                       const Vector& dy) const {
    const std::vector<Node> around = nodes(place, reach_of(place, dx, dy));
    return filtered_field(place, dx, dy, frequency_,
                          [&](const Vector& offset) { return field(place, offset, around); });
}

// The mean of cos(2 pi F u.d) over directions u is sin(t) / t in space, and J_0(t) on a surface with d along
// it, where t = 2 pi F |d|.
double Isotropic3d::removed(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) const {
    return removed_share(place, dx, dy, std::min(0.06, 0.1 / (frequency_ + 1e-9)), [&](const Vector& offset) {
        const double distance = tangents_
                                    ? std::hypot(dot(offset, (*tangents_)[0]), dot(offset, (*tangents_)[1]))
                                    : length(offset);
        const double turn = 2 * pi * frequency_ * distance;
        return tangents_ ? std::cyl_bessel_j(0, turn) : turn < 1e-6 ? 1 : std::sin(turn) / turn;
    });
}

std::vector<WeightedIsotropic> surface_isotropic(const Vector& normal, double frequency, std::uint32_t seed,
                                                 bool animated) {
    const double first = smoothstep(0.25, 0.5, 1 - normal[2] * normal[2]);
    const double length = std::hypot(first, 1 - first);
    std::vector<WeightedIsotropic> terms;
    const auto add = [&](const Vector& axis, double weight, int index) {
        if (weight == 0)
            return;
        const Vector along = unit(cross(axis, normal));
        terms.push_back({weight / length, Isotropic3d(frequency, {along, cross(normal, along)},
                                                      lattice_lobe_seed(seed, index), animated)});
    };
    add({0, 0, 1}, first, 0);
    add({1, 0, 0}, 1 - first, 1);
    return terms;
}

} // namespace gabor::noise
