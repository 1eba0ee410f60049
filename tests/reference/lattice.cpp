#include "reference/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double knee = 0.93687595;
constexpr double flattening = 0.89289313;
constexpr double cubic = 0.62342056;

} // namespace

std::uint32_t next_word(std::uint32_t word) {
    return (word ^ word >> 15) * 0xd35a2d97u;
}

std::int32_t wrapped(std::int64_t index, std::int32_t period) {
    const std::int64_t whole = std::int64_t{1} << 32;
    const std::int64_t modulus = period == 0 ? whole : period;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(((index % modulus) + modulus) % modulus));
}

std::uint32_t mix(std::uint32_t word, std::uint32_t salt) {
    word = (word ^ word >> 16) * 0x21f0aaadu + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

LatticeWindow lattice_window(int taps, double d) {
    if (std::abs(d) >= 1)
        return {};
    if (taps == 2) {
        const double x = std::abs(d);
        const double c = (1 - x) * (1 - x) * (1 + 2 * x);
        const double c_slope = -6 * x * (1 - x) * (d < 0 ? -1 : 1);
        const double sum = c * c + (1 - c) * (1 - c);
        // c / sqrt(sum) by the quotient rule
        return {c / std::sqrt(sum), c_slope * (sum - c * (2 * c - 1)) / std::pow(sum, 1.5), 0};
    }
    return {0.5 + 0.5 * std::cos(pi * d), -0.5 * pi * std::sin(pi * d), -0.5 * pi * pi * std::cos(pi * d)};
}

double lattice_energy(int taps) {
    return taps == 2 ? 1 : 0.375 * taps;
}

std::uint32_t lattice_line_word(std::int32_t index, int axis, std::uint32_t seed) {
    return salted_line_word(index, axis, mix(seed * spread, 0x2545f491u));
}

std::uint32_t salted_line_word(std::int32_t index, int axis, std::uint32_t salt) {
    constexpr std::array<std::uint32_t, 3> axes{0, 0x5bd1e995u, 0x27d4eb2fu};
    std::uint32_t word =
        static_cast<std::uint32_t>(index) * spread + (salt ^ axes.at(static_cast<std::size_t>(axis)));
    word *= word ^ word >> 15;
    return word >> 8 | 0x800001u;
}

std::uint32_t node_word(const std::array<std::uint32_t, 2>& lines) {
    return lines[0] * lines[1];
}
std::uint32_t node_word(const std::array<std::uint32_t, 3>& lines) {
    return lines[0] * (lines[1] * lines[2] >> 8 | 0x800001u);
}

namespace {

// The words of a node of isotropic noise: three for the amplitudes of its waves, and one for their angles.
std::array<std::uint32_t, 4> isotropic_words(std::uint32_t column, std::uint32_t row) {
    std::array<std::uint32_t, 4> words{};
    for (std::uint32_t& word : words) {
        row = next_word(row);
        word = column * (row >> 8 | 0x800001u);
    }
    return words;
}

// A word as a number from -1 to 1.
double uniform(std::uint32_t word) {
    return static_cast<std::int32_t>(word) * 0x1p-31;
}

// The three orthogonal directions of the waves at a node of isotropic noise in space, from its word.
std::array<Vector<3>, 3> isotropic_frame(std::uint32_t word) {
    const double azimuth = pi / 2 * uniform(word);
    const double rise = uniform(word << 12);
    const double spin = pi / 4 * uniform(word << 20);
    const double level = std::sqrt(1 - rise * rise);
    const Vector<3> first{level * std::cos(azimuth), level * std::sin(azimuth), rise};
    const Vector<3> level_one{-std::sin(azimuth), std::cos(azimuth), 0};
    const Vector<3> other = cross(first, level_one);
    return {first, sum(std::cos(spin), level_one, std::sin(spin), other),
            sum(-std::sin(spin), level_one, std::cos(spin), other)};
}

} // namespace

std::uint32_t lattice_word(std::int32_t column, std::int32_t row, std::uint32_t seed) {
    return node_word(std::array{lattice_line_word(column, 0, seed), lattice_line_word(row, 1, seed)});
}

std::uint32_t lattice_derived_seed(std::uint32_t seed, int index) {
    return mix(seed + static_cast<std::uint32_t>(index) * 0x85ebca6bu, spread);
}

double lattice_amplitude_part(double u) {
    return (u - flattening * std::clamp(u, -knee, knee)) * (1 + cubic * u * u);
}

double lattice_amplitude_deviation() {
    static const double deviation = [] {
        constexpr int values = 1 << 20;
        double sum = 0;
        for (int k = 0; k < values; ++k)
            sum += std::pow(lattice_amplitude_part((2.0 * k + 1) / values - 1), 2);
        return std::sqrt(sum / values);
    }();
    return deviation;
}

Complex lattice_amplitude(std::uint32_t word, double time) {
    const auto still = [](std::uint32_t of) {
        const auto whole = static_cast<std::int32_t>(of);
        const auto low = static_cast<std::int32_t>(of << 12);
        return Complex(lattice_amplitude_part(whole * 0x1p-31), lattice_amplitude_part(low * 0x1p-31));
    };
    if (time == 0)
        return still(word);
    const std::uint32_t second = next_word(word);
    const double angle = 2 * pi * time;
    return (1 + std::cos(angle)) / 2 * still(word) + (1 - std::cos(angle)) / 2 * still(second) +
           std::sin(angle) / std::numbers::sqrt2 * still(next_word(second));
}

std::array<double, 3> lattice_stripes(Complex value, double sharpness) {
    const double intensity = std::abs(value);
    const Complex stripes = sharpness * intensity > 1 ? value / intensity : sharpness * value;
    return {stripes.real(), stripes.imag(), intensity};
}

template <std::size_t N>
Field<N> Lattice<N>::field(const Place<N>& place) const {
    // Nodes are at the integers. A window's radius is taps / 2 spacings, for any number of nodes per kernel
    // radius.
    const double reach = 0.5 * taps_;
    const auto taps = static_cast<std::size_t>(taps_);
    struct Line {
        std::uint32_t word;
        double distance; // from the line to the point, in kernel radii
        double window, slope;
    };
    std::array<std::array<Line, 4>, N> lines;
    std::size_t nodes = 1;
    for (std::size_t axis = 0; axis < N; ++axis) {
        nodes *= taps;
        const double local = place.local[axis], radius = place.radius[axis];
        const auto first = static_cast<std::int64_t>(std::floor(local - reach)) + 1;
        for (std::size_t k = 0; k < taps; ++k) {
            const std::int64_t index = first + static_cast<std::int64_t>(k);
            const double x = local - static_cast<double>(index);
            const LatticeWindow window = lattice_window(taps_, x / reach);
            lines[axis].at(k) = {lattice_line_word(wrapped(place.cell[axis] + index, place.period[axis]),
                                                   static_cast<int>(axis), seed_),
                                 x / radius, window.value, window.slope * radius / reach};
        }
    }
    Field<N> sum;
    std::vector<Wave> waves;
    for (std::size_t number = 0; number < nodes; ++number) {
        std::array<std::uint32_t, N> words{};
        Vector<N> distance{}, slope;
        double window = 1;
        slope.fill(1);
        std::size_t rest = number;
        for (std::size_t axis = 0; axis < N; ++axis, rest /= taps) {
            const Line& line = lines[axis].at(rest % taps);
            words[axis] = line.word;
            distance[axis] = line.distance;
            window *= line.window;
            for (std::size_t along = 0; along < N; ++along)
                slope[along] *= along == axis ? line.slope : line.window;
        }
        waves.clear();
        waves_(words, number, waves);
        for (const auto& [wave, word] : waves) {
            const Complex turned = lattice_amplitude(word, place.time) /
                                   std::sqrt(static_cast<double>(waves.size())) *
                                   std::polar(1.0, 2 * pi * dot(wave, distance));
            sum.value += window * turned;
            for (std::size_t axis = 0; axis < N; ++axis)
                sum.slope[axis] += (slope[axis] + Complex(0, 2 * pi * wave[axis]) * window) * turned;
        }
    }
    // E[n^2] = E[|A|^2] / 2 (sum h^2)^N
    Field<N> scaled;
    scaled.add(1 / (lattice_amplitude_deviation() * std::pow(lattice_energy(taps_), 0.5 * N)), sum);
    return scaled;
}

template class Lattice<2>;
template class Lattice<3>;

template <std::size_t N>
Lattice<N> wave_noise(int taps, const Vector<N>& wave, std::uint32_t seed) {
    return {taps, seed,
            [wave](const auto& lines, std::size_t, auto& waves) {
                waves.push_back({wave, node_word(lines)});
            },
            length(wave), [wave](const Vector<N>& offset) { return std::cos(2 * pi * dot(wave, offset)); }};
}

template Lattice<2> wave_noise(int, const Vector<2>&, std::uint32_t);
template Lattice<3> wave_noise(int, const Vector<3>&, std::uint32_t);

Vector<2> wave_along(double frequency, double orientation) {
    return {std::abs(frequency) * std::cos(orientation), std::abs(frequency) * std::sin(orientation)};
}

Lattice<2> map_noise(const std::array<Vector<2>, 9>& given, std::uint32_t seed) {
    return {3, seed, [given](const auto& lines, std::size_t number, auto& waves) {
                waves.push_back({given.at(number), node_word(lines)});
            }};
}

// The correlation of isotropic noise at an offset d is the mean of cos(2 pi F u.d) over directions u: J_0(t)
// in a plane that contains d, and sin(t) / t in space, where t = 2 pi F |d|.
Lattice<2> isotropic_noise(double frequency, std::uint32_t seed, int taps) {
    return {taps, seed,
            [frequency](const auto& lines, std::size_t, auto& waves) {
                const auto words = isotropic_words(lines[0], lines[1]);
                for (std::size_t m = 0; m < 3; ++m)
                    waves.push_back(
                        {wave_along(frequency, pi / 6 * uniform(words[3]) + pi / 3 * static_cast<double>(m)),
                         words.at(m)});
            },
            frequency,
            [frequency](const Vector<2>& offset) {
                return std::cyl_bessel_j(0, 2 * pi * std::abs(frequency) * length(offset));
            }};
}

Lattice<3> isotropic_noise_3d(double frequency, std::uint32_t seed) {
    return {3, seed,
            [frequency](const auto& lines, std::size_t, auto& waves) {
                const auto words = isotropic_words(lines[0], lines[1] * lines[2]);
                for (const Vector<3>& along : isotropic_frame(words[3]))
                    waves.push_back({scaled(frequency, along), words.at(waves.size())});
            },
            frequency,
            [frequency](const Vector<3>& offset) {
                const double turn = 2 * pi * frequency * length(offset);
                return turn < 1e-6 ? 1 : std::sin(turn) / turn;
            }};
}

Lattice<3> tangent_noise(double frequency, const std::array<Vector<3>, 2>& tangents, std::uint32_t seed) {
    return {3, seed,
            [frequency, tangents](const auto& lines, std::size_t, auto& waves) {
                const auto words = isotropic_words(lines[0], lines[1] * lines[2]);
                const double angle = pi / 2 * uniform(words[3]);
                const double x = frequency * std::cos(angle), y = frequency * std::sin(angle);
                waves.push_back({sum(x, tangents[0], y, tangents[1]), words[0]});
                waves.push_back({sum(-y, tangents[0], x, tangents[1]), words[1]});
            },
            frequency,
            [frequency, tangents](const Vector<3>& offset) {
                return std::cyl_bessel_j(
                    0, 2 * pi * frequency * std::hypot(dot(offset, tangents[0]), dot(offset, tangents[1])));
            }};
}

} // namespace gabor::noise
