#include "reference/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gabor::noise {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr std::uint32_t spread = 0x9e3779b1u;
constexpr double knee = 0.93687595;
constexpr double flattening = 0.89289313;
constexpr double cubic = 0.62342056;

std::uint32_t mix(std::uint32_t word, std::uint32_t salt) {
    word = (word ^ word >> 16) * 0x21f0aaadu + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

std::uint32_t next_word(std::uint32_t word) {
    return (word ^ word >> 15) * 0xd35a2d97u;
}

std::int32_t wrapped(std::int64_t index, std::int32_t period) {
    const std::int64_t whole = std::int64_t{1} << 32;
    const std::int64_t modulus = period == 0 ? whole : period;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(((index % modulus) + modulus) % modulus));
}

} // namespace

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
    constexpr std::array<std::uint32_t, 3> axes{0, 0x5bd1e995u, 0x27d4eb2fu};
    const std::uint32_t salt = mix(seed * spread, 0x2545f491u) ^ axes.at(static_cast<std::size_t>(axis));
    std::uint32_t word = static_cast<std::uint32_t>(index) * spread + salt;
    word *= word ^ word >> 15;
    return word >> 8 | 0x800001u;
}

std::uint32_t lattice_word(std::int32_t column, std::int32_t row, std::uint32_t seed) {
    return lattice_line_word(column, 0, seed) * lattice_line_word(row, 1, seed);
}

std::uint32_t lattice_lobe_seed(std::uint32_t seed, int index) {
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

Complex lattice_amplitude(std::uint32_t word) {
    const auto whole = static_cast<std::int32_t>(word);
    const auto low = static_cast<std::int32_t>(word << 12);
    return {lattice_amplitude_part(whole * 0x1p-31), lattice_amplitude_part(low * 0x1p-31)};
}

Complex lattice_amplitude(std::uint32_t word, double time) {
    const std::uint32_t second = next_word(word);
    const double angle = 2 * pi * time;
    return (1 + std::cos(angle)) / 2 * lattice_amplitude(word) +
           (1 - std::cos(angle)) / 2 * lattice_amplitude(second) +
           std::sin(angle) / std::numbers::sqrt2 * lattice_amplitude(next_word(second));
}

Lattice::Lattice(int taps, double frequency, double orientation, std::uint32_t seed)
    : taps_(taps), wave_x_(std::abs(frequency) * std::cos(orientation)),
      wave_y_(std::abs(frequency) * std::sin(orientation)), seed_(seed) {}

Lattice::Lattice(int taps, std::array<double, 2> wave, std::uint32_t seed)
    : taps_(taps), wave_x_(wave[0]), wave_y_(wave[1]), seed_(seed) {}

std::array<double, 3> lattice_stripes(Complex value, double sharpness) {
    const double intensity = std::abs(value);
    const Complex stripes = sharpness * intensity > 1 ? value / intensity : sharpness * value;
    return {stripes.real(), stripes.imag(), intensity};
}

namespace {

Complex amplitude_at(std::uint32_t word, const LatticePlace& place) {
    return place.animated ? lattice_amplitude(word, place.time) : lattice_amplitude(word);
}

// A column or a row of nodes whose windows reach the place.
struct Line {
    LatticeWindow window;
    double slope;                       // slope of the window, per kernel radius
    Complex wave;                       // phase of the noise's wave from the nodes to the place
    std::array<std::uint32_t, 4> words; // words of four noises
};

// `axis` is 0 for columns and 1 for rows; `radius` is in nodes per kernel radius.
std::vector<Line> lines_around(int taps, std::int32_t cell, double local, double radius, std::int32_t period,
                               double wave, int axis, std::uint32_t seed) {
    // Nodes are at the integers. A window's radius is taps / 2 spacings, for any number of nodes per kernel
    // radius.
    const double window_radius = 0.5 * taps;
    std::vector<Line> lines;
    for (auto i = static_cast<std::int64_t>(std::ceil(local - window_radius));
         static_cast<double>(i) < local + window_radius; ++i) {
        const double x = local - static_cast<double>(i);
        Line line{
            lattice_window(taps, x / window_radius), 0, std::polar(1.0, 2 * pi * wave * x / radius), {}};
        line.slope = line.window.slope * radius / window_radius;
        for (int c = 0; c < 4; ++c)
            line.words.at(static_cast<std::size_t>(c)) =
                lattice_line_word(wrapped(cell + i, period), axis, c ? lattice_lobe_seed(seed, -c) : seed);
        lines.push_back(line);
    }
    return lines;
}

} // namespace

Lattice::Field Lattice::field(const LatticePlace& place) const {
    const auto columns =
        lines_around(taps_, place.cell_x, place.local_x, place.radius_x, place.period_x, wave_x_, 0, seed_);
    const auto rows =
        lines_around(taps_, place.cell_y, place.local_y, place.radius_y, place.period_y, wave_y_, 1, seed_);
    Field sum;
    for (const Line& y : rows) {
        for (const Line& x : columns) {
            const Complex wave = x.wave * y.wave;
            const Complex kernel = x.window.value * y.window.value * wave;
            std::array<Complex, 4> amplitudes;
            for (std::size_t c = 0; c < 4; ++c) {
                const std::uint32_t word = x.words[c] * y.words[c];
                amplitudes[c] = amplitude_at(word, place);
                sum.four[c] += (amplitudes[c] * kernel).imag();
            }
            sum.value += amplitudes[0] * kernel;
            sum.slope_x +=
                amplitudes[0] * (x.slope * y.window.value * wave + Complex(0, 2 * pi * wave_x_) * kernel);
            sum.slope_y +=
                amplitudes[0] * (y.slope * x.window.value * wave + Complex(0, 2 * pi * wave_y_) * kernel);
        }
    }
    return sum.scaled(1 / (lattice_amplitude_deviation() * lattice_energy(taps_)));
}

namespace {

// Adds a wave of a node to the noise (x, y) node spacings away from it, with three taps.
void add_wave(Field& sum, const LatticePlace& place, double x, double y, double wave_x, double wave_y,
              Complex amplitude) {
    const LatticeWindow across = lattice_window(3, x / 1.5);
    const LatticeWindow along = lattice_window(3, y / 1.5);
    const Complex wave =
        amplitude * std::polar(1.0, 2 * pi * (wave_x * x / place.radius_x + wave_y * y / place.radius_y));
    const Complex kernel = across.value * along.value * wave;
    sum.value += kernel;
    sum.slope_x +=
        across.slope * place.radius_x / 1.5 * along.value * wave + Complex(0, 2 * pi * wave_x) * kernel;
    sum.slope_y +=
        across.value * along.slope * place.radius_y / 1.5 * wave + Complex(0, 2 * pi * wave_y) * kernel;
}

} // namespace

// n(p) = K sum_c A_c h(x - c_x) h(y - c_y) exp(2 pi i F_c.(p - c)), and its derivatives.
Lattice::Field Lattice::field(const LatticePlace& place, const Waves& waves, std::uint32_t seed) {
    const auto nearest_x = static_cast<std::int64_t>(std::floor(place.local_x + 0.5));
    const auto nearest_y = static_cast<std::int64_t>(std::floor(place.local_y + 0.5));
    Field sum;
    for (int k = 0; k < 9; ++k) {
        const std::int64_t i = nearest_x + k % 3 - 1;
        const std::int64_t j = nearest_y + k / 3 - 1;
        const auto [wave_x, wave_y] = waves.at(static_cast<std::size_t>(k));
        const std::uint32_t word = lattice_line_word(wrapped(place.cell_x + i, place.period_x), 0, seed) *
                                   lattice_line_word(wrapped(place.cell_y + j, place.period_y), 1, seed);
        add_wave(sum, place, place.local_x - static_cast<double>(i), place.local_y - static_cast<double>(j),
                 wave_x, wave_y, amplitude_at(word, place));
    }
    return sum.scaled(1 / (lattice_amplitude_deviation() * lattice_energy(3)));
}

Lattice::Field lattice_isotropic(const LatticePlace& place, double frequency, std::uint32_t seed) {
    const auto nearest_x = static_cast<std::int64_t>(std::floor(place.local_x + 0.5));
    const auto nearest_y = static_cast<std::int64_t>(std::floor(place.local_y + 0.5));
    Lattice::Field sum;
    for (std::int64_t j = nearest_y - 1; j <= nearest_y + 1; ++j) {
        std::array<std::uint32_t, 4> row{}; // words of three amplitudes and of the angle
        std::uint32_t mixed = lattice_line_word(wrapped(place.cell_y + j, place.period_y), 1, seed);
        for (std::uint32_t& word : row) {
            mixed = next_word(mixed);
            word = mixed >> 8 | 0x800001u;
        }
        for (std::int64_t i = nearest_x - 1; i <= nearest_x + 1; ++i) {
            const std::uint32_t column =
                lattice_line_word(wrapped(place.cell_x + i, place.period_x), 0, seed);
            const double first = pi / 6 * static_cast<std::int32_t>(column * row[3]) / 0x1p31;
            for (std::size_t m = 0; m < 3; ++m) {
                const double angle = first + pi / 3 * static_cast<double>(m);
                add_wave(sum, place, place.local_x - static_cast<double>(i),
                         place.local_y - static_cast<double>(j), std::abs(frequency) * std::cos(angle),
                         std::abs(frequency) * std::sin(angle), amplitude_at(column * row[m], place));
            }
        }
    }
    return sum.scaled(1 / (lattice_amplitude_deviation() * lattice_energy(3) * std::sqrt(3.0)));
}

} // namespace gabor::noise
