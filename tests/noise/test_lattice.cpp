// Tests the lattice noise's windows, and the randomness of its nodes' hash words and amplitudes.

#include "../largest.hpp"
#include "randomness.hpp"
#include "reference/lattice.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

using namespace gabor::noise;
using gabor::test::Largest;
using std::numbers::pi;

namespace {

// The windows along an axis at offset x from a node, in node spacings.
std::vector<LatticeWindow> windows(int taps, double x) {
    std::vector<LatticeWindow> all;
    for (int k = -taps; k <= taps; ++k)
        all.push_back(lattice_window(taps, 2 * (x - k) / taps));
    return all;
}

struct Offset {
    int x, y;
};

// The words around the i-th node of a sequence, which runs over seeds or over the nodes of a square.
class Words {
  public:
    Words(bool over_seeds, std::uint64_t i)
        : x_(over_seeds ? 3 : static_cast<std::int32_t>(i & 0xfff) - 2048),
          y_(over_seeds ? -5 : static_cast<std::int32_t>(i >> 12) - 128),
          seed_(over_seeds ? static_cast<std::uint32_t>(i) : 7) {}

    std::uint32_t at(Offset offset) const { return lattice_word(x_ + offset.x, y_ + offset.y, seed_); }

  private:
    std::int32_t x_, y_;
    std::uint32_t seed_;
};

std::string name(bool over_seeds) {
    return over_seeds ? "over seeds" : "in a square";
}

// Numbers with mean 0 and variance 1 from a word: its amplitude's uniform numbers and their squares.
std::array<double, 4> numbers(std::uint32_t word) {
    const double high = static_cast<std::int32_t>(word) * 0x1p-31;
    const double low = static_cast<std::int32_t>(word << 12) * 0x1p-31;
    const double three = std::sqrt(3.0);
    const double square = std::sqrt(45.0) / 2; // scales u^2 - 1/3 to variance 1
    return {three * high, three * low, square * (high * high - 1.0 / 3), square * (low * low - 1.0 / 3)};
}

} // namespace

TEST_CASE("the variances of the lattice noise and its derivatives are the same at every point", "[lattice]") {
    for (const int taps : {2, 3, 4}) {
        for (int k = 0; k < 64; ++k) {
            double value = 0, slope = 0, curvature = 0, mixed = 0;
            for (const LatticeWindow& w : windows(taps, (k + 0.5) / 64)) {
                value += w.value * w.value;
                slope += w.slope * w.slope;
                curvature += w.curvature * w.curvature;
                mixed += w.value * w.curvature;
            }
            CHECK(value == Approx(lattice_energy(taps)).epsilon(1e-12));
            if (taps == 2) // only Hann's windows keep the variances of derivatives constant
                continue;
            CHECK(slope == Approx(pi * pi / 8 * taps).epsilon(1e-12));
            CHECK(curvature == Approx(std::pow(pi, 4) / 8 * taps).epsilon(1e-12));
            CHECK(mixed == Approx(-pi * pi / 8 * taps).epsilon(1e-12));
        }
    }
}

TEST_CASE("second derivatives jump where windows end, as docs/lattice.md says", "[lattice]") {
    // The root mean square of the jump, relative to the standard deviation, of the second derivative along an
    // axis of a noise with `frequency` along that axis. Along the other axis, windows are factors that
    // cancel.
    const auto jump = [](int taps, double frequency) {
        const double turn = 2 * pi * frequency;
        const double end = taps % 2 / 2.0;
        double change = 0, power = 0;
        const auto before = windows(taps, end - 1e-9), after = windows(taps, end + 1e-9);
        for (std::size_t i = 0; i < before.size(); ++i)
            change += std::pow(after[i].curvature - before[i].curvature, 2);
        for (const LatticeWindow& w : windows(taps, 0.2))
            power += std::norm(std::complex(w.curvature - turn * turn * w.value, 2 * turn * w.slope));
        return std::sqrt(change / power);
    };
    CHECK(jump(3, 0) == Approx(2 / std::sqrt(3.0)).epsilon(1e-6));
    CHECK(std::abs(jump(3, 1) - 0.14) < 0.005);
    CHECK(jump(4, 0) == Approx(1).epsilon(1e-6));
}

TEST_CASE("noises of a frequency and its double with one seed are correlated, as docs/lattice.md says",
          "[lattice]") {
    // At a node: the noises are K Im sum A_c w_c e^(-2 pi i F.c), so that E[n_F n_2F] = K^2 sum_c w_c^2 cos 2
    // pi F.c.
    double least = 1, most = 0, lowest_mean = 1, highest_mean = 0;
    for (double frequency = 1; frequency <= 40; frequency += 0.25) {
        double mean = 0;
        constexpr int directions = 180;
        for (int i = 0; i < directions; ++i) {
            const auto along = [&](double wave) {
                double sum = 0;
                for (int k = -2; k <= 2; ++k)
                    sum += std::pow(lattice_window(3, k / 1.5).value, 2) * std::cos(2 * pi * wave * k / 1.5);
                return sum / lattice_energy(3);
            };
            const double angle = pi * i / directions;
            const double correlation =
                along(frequency * std::cos(angle)) * along(frequency * std::sin(angle));
            least = std::min(least, correlation);
            most = std::max(most, correlation);
            mean += correlation / directions;
        }
        lowest_mean = std::min(lowest_mean, mean);
        highest_mean = std::max(highest_mean, mean);
    }
    fmt::print("correlations {:.3f} to {:.3f}, means over directions {:.3f} to {:.3f}\n", least, most,
               lowest_mean, highest_mean);
    CHECK(std::abs(least - 0.60) < 0.01);
    CHECK(std::abs(most - 1.0) < 0.01);
    CHECK(std::abs(lowest_mean - 0.72) < 0.005);
    CHECK(std::abs(highest_mean - 0.84) < 0.006);
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
        for (double frequency = 1.0; frequency < 12; frequency += 0.01) // the main lobe ends at 1
            largest = std::max(largest, amplitude(frequency) / amplitude(0));
        const double decibels = 20 * std::log10(largest);
        fmt::print("{} taps: the largest sidelobe is {:.2f} dB\n", taps, decibels);
        CHECK(decibels < -31);
        CHECK(decibels > -32);
    }
}

TEST_CASE("amplitudes of nodes are independent: pairs, runs along columns and rows, rectangles",
          "[lattice][randomness]") {
    // Products of the numbers at a node and at these offsets from it have mean 0 and variance 1.
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
    const auto count = gabor::test::draws();
    Largest sigmas;
    for (const bool over_seeds : {false, true}) {
        for (const auto& figure : figures) {
            double sums[4][4] = {};
            for (std::uint64_t i = 0; i < count; ++i) {
                const Words words(over_seeds, i);
                const auto first = numbers(words.at({0, 0}));
                std::array<double, 4> product{1, 1, 1, 1};
                for (const Offset& offset : figure) {
                    const auto there = numbers(words.at(offset));
                    for (std::size_t b = 0; b < 4; ++b)
                        product[b] *= there[b];
                }
                for (std::size_t a = 0; a < 4; ++a)
                    for (std::size_t b = 0; b < 4; ++b)
                        sums[a][b] += first[a] * product[b];
            }
            const bool is_same = figure.size() == 1 && figure[0].x == 0 && figure[0].y == 0;
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = is_same ? a + 1 : 0; b < 4; ++b) // not a number with itself
                    sigmas.see(sums[a][b] / std::sqrt(static_cast<double>(count)), 0, gabor::test::far, [&] {
                        return fmt::format("{} offsets from ({}, {}), numbers {} and {}, {}", figure.size(),
                                           figure[0].x, figure[0].y, a, b, name(over_seeds));
                    });
        }
    }
    sigmas.check("products of numbers");
}

// A word is its column's word times its row's, modulo 2^32, and all words are odd. Since multiplication is
// commutative, three words at the corners of a rectangle determine the fourth. This checks that the
// amplitudes do not reveal that dependence.
TEST_CASE("the amplitudes of a rectangle's corners do not correlate, nor do their leading bits",
          "[lattice][randomness]") {
    const auto count = gabor::test::draws();
    Largest sigmas;
    for (const bool over_seeds : {false, true}) {
        for (const auto& [width, height] : {Offset{1, 1}, {2, 1}, {1, 2}, {2, 2}, {7, 5}}) {
            std::complex<double> alternating, plain;
            // Counts by the two leading bits of all four real parts (high) or imaginary parts (low).
            std::vector<std::uint64_t> high(256), low(256);
            for (std::uint64_t i = 0; i < count; ++i) {
                const Words node(over_seeds, i);
                const std::array words{node.at({0, 0}), node.at({width, 0}), node.at({width, height}),
                                       node.at({0, height})};
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
            // The standard deviation of each part of a sum of such products, since E|A|^2 = 2.
            const double sigma = std::sqrt(8 * static_cast<double>(count));
            for (const auto& [value, of] :
                 {std::pair(alternating.real() / sigma, "Re A1 A2* A3 A4*"),
                  {alternating.imag() / sigma, "Im A1 A2* A3 A4*"},
                  {plain.real() / sigma, "Re A1 A2 A3 A4"},
                  {plain.imag() / sigma, "Im A1 A2 A3 A4"},
                  {gabor::test::chi_square(high), "leading bits of real parts"},
                  {gabor::test::chi_square(low), "leading bits of imaginary parts"}})
                sigmas.see(value, 0, gabor::test::far,
                           fmt::format("{}, {} x {} {}", of, width, height, name(over_seeds)));
        }
    }
    sigmas.check("rectangles");
}

// The number of draws is limited, because a column's or row's word is one of 2^22, and longer sequences cover
// these more evenly than chance would.
TEST_CASE("the leading bits of both parts of node words are uniform, along rows and columns and over seeds",
          "[lattice][randomness]") {
    using Sequence = std::uint32_t (*)(std::int32_t);
    constexpr std::pair<const char*, Sequence> sequences[]{
        {"square",
         [](std::int32_t k) {
             return Words(false, static_cast<std::uint64_t>(k)).at({0, 0});
         }},
        {"row", [](std::int32_t k) { return lattice_word(k, -77, 7); }},
        {"column", [](std::int32_t k) { return lattice_word(-77, k, 7); }},
        {"seeds", [](std::int32_t k) {
             return Words(true, static_cast<std::uint64_t>(k)).at({0, 0});
         }}};
    Largest sigmas;
    for (const auto& [along, word_of] : sequences) {
        std::vector<std::uint64_t> high(4096), low(4096);
        for (std::int32_t k = 0; k < 1 << 21; ++k) {
            const std::uint32_t word = word_of(k);
            ++high[word >> 20];
            ++low[word >> 8 & 0xfff];
        }
        sigmas.see(gabor::test::chi_square(high), 0, gabor::test::far, along);
        sigmas.see(gabor::test::chi_square(low), 0, gabor::test::far, along);
    }
    sigmas.check("chi-squares");
}
