// Computes the distribution of the lattice noise without sampling, from the equations, the windows and the
// distribution of the amplitudes.

#include "../largest.hpp"
#include "draws.hpp"
#include "reference/lattice.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <vector>

using namespace gabor::noise;
using std::numbers::pi;

namespace {

// The windows along an axis at offset x from a node, in node spacings.
std::vector<LatticeWindow> windows(int taps, double x) {
    std::vector<LatticeWindow> all;
    for (int k = -taps; k <= taps; ++k)
        all.push_back(lattice_window(taps, 2 * (x - k) / taps));
    return all;
}

// The characteristic function of one part of an amplitude, with variance 1, by linear interpolation.
class Characteristic {
  public:
    Characteristic() {
        std::array<double, 1024> parts{}; // evenly spaced samples of the part's 2^16 or 2^32 values
        for (std::size_t k = 0; k < parts.size(); ++k)
            parts[k] = lattice_amplitude_part((static_cast<double>(k) + 0.5) / 512 - 1) /
                       lattice_amplitude_deviation();
        for (std::size_t k = 0; k < table_.size(); ++k) {
            double sum = 0;
            for (const double part : parts)
                sum += std::cos(static_cast<double>(k) * step * part);
            table_[k] = sum / static_cast<double>(parts.size());
        }
    }

    double operator()(double t) const {
        const double place = std::abs(t) / step;
        const auto k = static_cast<std::size_t>(place);
        return std::lerp(table_[k], table_[k + 1], place - static_cast<double>(k));
    }

  private:
    static constexpr double step = 0.004;
    std::vector<double> table_ = std::vector<double>(4002);
};

constexpr double frequency_step = 0.07;
constexpr int frequencies = 200; // samples of the characteristic function, up to 14
constexpr double value_step = 0.05;
constexpr int values = 241; // from -6 to 6

double value_at(int k) {
    return (k - values / 2) * value_step;
}

// F(x) - Phi(x) at the values: the integral of (chi(t) - exp(-t^2 / 2)) sin(t x) / (pi t), for a
// symmetric distribution.
std::vector<double> excess_distribution(const std::vector<double>& weights, const Characteristic& part) {
    std::vector<double> result(values);
    for (int f = 1; f <= frequencies; ++f) {
        const double t = f * frequency_step;
        double chi = 1;
        for (const double weight : weights)
            chi *= part(t * weight);
        const double scale = (chi - std::exp(-t * t / 2)) * frequency_step / (pi * t);
        for (int k = 0; k < values; ++k)
            result[static_cast<std::size_t>(k)] += scale * std::sin(t * value_at(k));
    }
    return result;
}

// cvm is T at n = 2^18 minus its value for normal samples: n times the integral of (F - Phi)^2 dPhi.
double cvm(const std::vector<double>& excess) {
    double sum = 0;
    for (int k = 0; k < values; ++k) {
        const double x = value_at(k);
        sum += std::pow(excess[static_cast<std::size_t>(k)], 2) * std::exp(-x * x / 2);
    }
    return 262144 * sum * value_step / std::sqrt(2 * pi);
}

struct Law {
    double pooled;
    double mean;
    double worst;
};

// The distribution over `side` x `side` places of a cell, for one orientation.
Law law(int taps, double frequency, double orientation, int side, const Characteristic& part) {
    const double step_x = frequency * std::cos(orientation) * 2 / taps; // cycles per node
    const double step_y = frequency * std::sin(orientation) * 2 / taps;
    std::vector<double> together(values);
    Law result{};
    for (int a = 0; a < side; ++a) {
        for (int b = 0; b < side; ++b) {
            const double x = (a + 0.5) / side;
            const double y = (b + 0.5) / side;
            std::vector<double> weights;
            double power = 0;
            const auto along_x = windows(taps, x);
            const auto along_y = windows(taps, y);
            for (int j = -taps; j <= taps; ++j) {
                for (int i = -taps; i <= taps; ++i) {
                    const double window = along_x[static_cast<std::size_t>(i + taps)].value *
                                          along_y[static_cast<std::size_t>(j + taps)].value /
                                          lattice_energy(taps);
                    if (window == 0)
                        continue;
                    const double phase = 2 * pi * (step_x * (x - i) + step_y * (y - j));
                    weights.push_back(window * std::cos(phase));
                    weights.push_back(window * std::sin(phase));
                    power += window * window;
                }
            }
            REQUIRE(power == Approx(1).epsilon(1e-12)); // variance 1 everywhere, whatever the wave
            const std::vector<double> excess = excess_distribution(weights, part);
            for (std::size_t k = 0; k < excess.size(); ++k)
                together[k] += excess[k] / (side * side);
            const double here = cvm(excess);
            result.mean += here / (side * side);
            result.worst = std::max(result.worst, here);
        }
    }
    result.pooled = cvm(together);
    return result;
}

} // namespace

TEST_CASE("the lattice noise is normal at every place of a cell", "[lattice]") {
    const Characteristic part;
    for (const int taps : {2, 3, 4}) {
        for (const double frequency : {1.0, 4.0}) {
            Law all{};
            double pooled = 0;
            for (const double orientation : {0.0, 0.4, 0.785398, 1.1}) {
                const Law one = law(taps, frequency, orientation, 16, part);
                all.mean += one.mean / 4;
                all.worst = std::max(all.worst, one.worst);
                pooled = std::max(pooled, one.pooled);
            }
            fmt::print("{} taps, frequency {}: cvm at 16 x 16 places and 4 orientations {:.4f} on average, "
                       "{:.3f} at worst; pooled {:.4f}\n",
                       taps, frequency, all.mean, all.worst, pooled);
            // With two taps, only a node's own amplitude counts at its place.
            CHECK(all.mean < (taps == 2 ? 0.4 : 0.002));
            CHECK(all.worst < (taps == 2 ? 7 : 0.05));
            CHECK(pooled < (taps == 2 ? 0.08 : 0.001));
        }
    }
}

TEST_CASE("the variances of the lattice noise and its derivatives are the same at every place", "[lattice]") {
    for (const int taps : {3, 4}) {
        for (int k = 0; k < 64; ++k) {
            double value = 0, slope = 0, curvature = 0, mixed = 0;
            for (const LatticeWindow& w : windows(taps, (k + 0.5) / 64)) {
                value += w.value * w.value;
                slope += w.slope * w.slope;
                curvature += w.curvature * w.curvature;
                mixed += w.value * w.curvature;
            }
            CHECK(value == Approx(0.375 * taps).epsilon(1e-12));
            CHECK(slope == Approx(pi * pi / 8 * taps).epsilon(1e-12));
            CHECK(curvature == Approx(std::pow(pi, 4) / 8 * taps).epsilon(1e-12));
            CHECK(mixed == Approx(-pi * pi / 8 * taps).epsilon(1e-12));
        }
    }
}

TEST_CASE("sidelobes of the lattice noise are at most -31 dB", "[lattice]") {
    for (const int taps : {3, 4}) {
        const auto amplitude = [&](double frequency) {
            double sum = 0;
            constexpr int steps = 400;
            for (int k = 0; k < steps; ++k) {
                const double d = (k + 0.5) / steps;
                sum += lattice_window(taps, d).value * std::cos(2 * pi * frequency * d) / steps;
            }
            return std::abs(sum);
        };
        double largest = 0;
        for (double frequency = 1.0; frequency < 12; frequency += 0.01) // the lobe ends at 1
            largest = std::max(largest, amplitude(frequency) / amplitude(0));
        const double decibels = 20 * std::log10(largest);
        fmt::print("{} taps: the largest sidelobe is {:.2f} dB\n", taps, decibels);
        CHECK(decibels < -31);
        CHECK(decibels > -32);
    }
}

namespace {

// Numbers with mean 0 and variance 1 from a word: the amplitude's parts and their squares.
struct Numbers {
    double part[4];
};

Numbers numbers(std::uint32_t word) {
    const double high = static_cast<std::int32_t>(word) * 0x1p-31;
    const double low = static_cast<std::int32_t>(word << 12) * 0x1p-31;
    const double three = std::sqrt(3.0);
    const double square = std::sqrt(45.0) / 2; // scales u^2 - 1/3 to variance 1
    return {{three * high, three * low, square * (high * high - 1.0 / 3), square * (low * low - 1.0 / 3)}};
}

} // namespace

TEST_CASE("amplitudes of nodes are independent: pairs, runs along columns and rows, rectangles",
          "[lattice][randomness]") {
    struct Offset {
        int x;
        int y;
    };
    // Products of the numbers at the node and at the offsets have mean 0 and variance 1.
    const std::vector<std::vector<Offset>> figures{{{0, 0}},
                                                   {{1, 0}},
                                                   {{0, 1}},
                                                   {{1, 1}},
                                                   {{1, -1}},
                                                   {{2, 0}},
                                                   {{0, 2}},
                                                   {{256, 0}},
                                                   {{0, 256}},
                                                   {{1, 0}, {2, 0}},
                                                   {{0, 1}, {0, 2}},
                                                   {{1, 0}, {0, 1}},
                                                   {{1, 0}, {0, 1}, {1, 1}},
                                                   {{2, 0}, {0, 1}, {2, 1}},
                                                   {{1, 0}, {0, 3}, {1, 3}},
                                                   {{1, 0}, {2, 0}, {3, 0}},
                                                   {{0, 1}, {0, 2}, {0, 3}},
                                                   {{7, 0}, {0, 5}, {7, 5}}};
    const auto count = draws();
    gabor::test::Largest sigmas;
    for (const bool over_seeds : {false, true}) {
        for (const auto& figure : figures) {
            double sums[4][4] = {};
            for (std::uint64_t i = 0; i < count; ++i) {
                const std::int32_t x = over_seeds ? 3 : static_cast<std::int32_t>(i & 0xfff) - 2048;
                const std::int32_t y = over_seeds ? -5 : static_cast<std::int32_t>(i >> 12) - 128;
                const std::uint32_t seed = over_seeds ? static_cast<std::uint32_t>(i) : 7;
                const Numbers first = numbers(lattice_word(x, y, seed));
                for (int b = 0; b < 4; ++b) {
                    double product = 1;
                    for (const Offset& offset : figure)
                        product *= numbers(lattice_word(x + offset.x, y + offset.y, seed)).part[b];
                    for (int a = 0; a < 4; ++a)
                        sums[a][b] += first.part[a] * product;
                }
            }
            for (int a = 0; a < 4; ++a) {
                for (int b = 0; b < 4; ++b) {
                    if (figure.size() == 1 && figure[0].x == 0 && figure[0].y == 0 && a >= b)
                        continue; // the same pair again, or a number with itself
                    sigmas.see(sums[a][b] / std::sqrt(static_cast<double>(count)), 0, 5.5, [&] {
                        return fmt::format("{} offsets from ({}, {}), numbers {} and {}, {}", figure.size(),
                                           figure[0].x, figure[0].y, a, b,
                                           over_seeds ? "over seeds" : "in a square");
                    });
                }
            }
        }
    }
    sigmas.check("products, in units of 5.5 sigma");
}

// A word is its column's word times its row's, modulo 2^32, and all words are odd. Since multiplication is
// commutative, three words at the corners of a rectangle determine the fourth. This checks that the
// amplitudes do not reveal it.
TEST_CASE("the amplitudes of a rectangle's corners do not correlate, nor do their leading bits",
          "[lattice][randomness]") {
    struct Sides {
        int x;
        int y;
    };
    const auto count = draws();
    const double n = static_cast<double>(count);
    gabor::test::Largest sigmas;
    const auto see = [&](double sigma, const std::string& name) { sigmas.see(sigma, 0, 5.5, name); };
    for (const bool over_seeds : {false, true}) {
        for (const Sides sides : {Sides{1, 1}, {2, 1}, {1, 2}, {2, 2}, {7, 5}}) {
            std::complex<double> alternating,
                plain; // E[A1 A2* A3 A4*] and E[A1 A2 A3 A4] around the rectangle
            std::vector<std::uint64_t> high(256), low(256); // the two leading bits of each part of the four
            for (std::uint64_t i = 0; i < count; ++i) {
                const std::int32_t x = over_seeds ? 3 : static_cast<std::int32_t>(i & 0xfff) - 2048;
                const std::int32_t y = over_seeds ? -5 : static_cast<std::int32_t>(i >> 12) - 128;
                const std::uint32_t seed = over_seeds ? static_cast<std::uint32_t>(i) : 7;
                const std::array words{lattice_word(x, y, seed), lattice_word(x + sides.x, y, seed),
                                       lattice_word(x + sides.x, y + sides.y, seed),
                                       lattice_word(x, y + sides.y, seed)};
                if (words[0] * words[2] != words[1] * words[3])
                    FAIL("the words are no longer products: update the comment above");
                std::array<std::complex<double>, 4> a;
                std::size_t high_bits = 0, low_bits = 0;
                for (std::size_t k = 0; k < 4; ++k) {
                    a[k] = lattice_amplitude(words[k]) / lattice_amplitude_deviation();
                    high_bits = high_bits << 2 | words[k] >> 30;
                    low_bits = low_bits << 2 | (words[k] >> 18 & 3);
                }
                alternating += a[0] * std::conj(a[1]) * a[2] * std::conj(a[3]);
                plain += a[0] * a[1] * a[2] * a[3];
                ++high[high_bits];
                ++low[low_bits];
            }
            const std::string name =
                fmt::format("{} x {} {}", sides.x, sides.y, over_seeds ? "over seeds" : "in a square");
            const double sigma = std::sqrt(8 * n); // for either part of a product of four, E|A|^2 = 2
            for (const auto& [sum, conjugated] :
                 {std::pair(alternating, "A1 A2* A3 A4*"), {plain, "A1 A2 A3 A4"}}) {
                see(sum.real() / sigma, fmt::format("Re {}, {}", conjugated, name));
                see(sum.imag() / sigma, fmt::format("Im {}, {}", conjugated, name));
            }
            for (const auto& [counts, part] : {std::pair(&high, "real"), {&low, "imaginary"}}) {
                double chi_square = 0;
                for (const std::uint64_t c : *counts)
                    chi_square += std::pow(static_cast<double>(c) - n / 256, 2) / (n / 256);
                see((chi_square - 255) / std::sqrt(510.0),
                    fmt::format("leading bits of {} parts, {}", part, name));
            }
            fmt::print("  {}: E[A1 A2* A3 A4*] / E[|A|^2]^2 = {:.5f} {:+.5f} i +- {:.5f}\n", name,
                       alternating.real() / n / 4, alternating.imag() / n / 4, std::sqrt(8 / n) / 4);
        }
    }
    sigmas.check("rectangles, in units of 5.5 sigma");
}

// The number of draws is limited, because a column's or row's word is one of 2^22, and longer sequences cover
// these more evenly than chance would.
TEST_CASE("the leading bits of both parts of node words are uniform, along rows and columns and over seeds",
          "[lattice][randomness]") {
    constexpr std::uint64_t count = 1 << 21;
    gabor::test::Largest sigmas;
    for (const int along : {0, 1, 2, 3}) { // a square, a row, a column, seeds
        std::array<std::vector<std::uint64_t>, 2> counts{std::vector<std::uint64_t>(4096),
                                                         std::vector<std::uint64_t>(4096)};
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto k = static_cast<std::int32_t>(i);
            const std::uint32_t word = along == 0   ? lattice_word((k & 0xfff) - 2048, (k >> 12) - 128, 7)
                                       : along == 1 ? lattice_word(k, -77, 7)
                                       : along == 2 ? lattice_word(-77, k, 7)
                                                    : lattice_word(3, -5, static_cast<std::uint32_t>(i));
            ++counts[0][word >> 20];
            ++counts[1][word >> 8 & 0xfff];
        }
        for (const auto& part : counts) {
            const double expected = static_cast<double>(count) / 4096;
            double chi_square = 0;
            for (const std::uint64_t c : part)
                chi_square += std::pow(static_cast<double>(c) - expected, 2) / expected;
            sigmas.see((chi_square - 4095) / std::sqrt(2 * 4095.0), 0, 5.5,
                       [&] { return fmt::format("sequence {}", along); });
        }
    }
    sigmas.check("chi-squares, in units of 5.5 sigma");
}
