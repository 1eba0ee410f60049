// Tests the field of node amplitudes for repeated lines, special nodes, similar seeds and periodicity.

#include "reference/lattice.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <kiss_fft.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

using namespace gabor;

namespace {

using Complex = std::complex<double>;

// Turns a counter into seeds that are far from each other.
std::uint32_t seed_of(std::uint32_t i) {
    return noise::lattice_derived_seed(12345, static_cast<int>(i));
}

// The largest count that chance can explain if `expected` is the mean.
double most(double expected) {
    return expected + 6 * std::sqrt(expected) + 6;
}

Complex amplitude(std::int32_t column, std::int32_t row, std::uint32_t seed) {
    return noise::lattice_amplitude(noise::lattice_word(column, row, seed)) /
           (std::numbers::sqrt2 * noise::lattice_amplitude_deviation());
}

} // namespace

// 384 lines span 8192 pixels at 32 pixels per kernel radius.
TEST_CASE("lines at any distance have equal, nearly equal or opposite words only as often as by chance",
          "[amplitudes]") {
    for (const int axis : {0, 1}) {
        double equal = 0, near = 0, low = 0, pairs = 0;
        for (int distance = 1; distance < 384; ++distance) {
            const int seeds = distance > 96 ? 1 << 14 : 1 << 17;
            pairs += seeds;
            int equal_here = 0, near_here = 0, low_here = 0;
            for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(seeds); ++i) {
                const std::uint32_t a = noise::lattice_line_word(-3, axis, seed_of(i));
                const std::uint32_t b = noise::lattice_line_word(distance - 3, axis, seed_of(i));
                const std::uint32_t difference = (a - b) & 0x7fffff; // the highest bit is set in both
                equal_here += difference == 0;
                near_here += difference < 64 || difference > 0x7fffff - 63;
                low_here +=
                    ((a - b) & 0xfffff) == 0 || ((a + b) & 0xfffff) == 0; // equal or opposite imaginary parts
            }
            INFO("axis " << axis << ", distance " << distance << ": " << equal_here << " equal, " << near_here
                         << " nearly equal, " << low_here << " with equal or opposite low bits");
            CHECK(equal_here < most(seeds * 0x1p-22));
            CHECK(near_here < most(seeds * 64 * 0x1p-22));
            CHECK(low_here < most(seeds * 0x1p-18));
            equal += equal_here;
            near += near_here;
            low += low_here;
        }
        fmt::print("axis {}: {} lines equal, {} nearly equal, {} with equal or opposite low bits\n", axis,
                   equal, near, low);
        CHECK(equal < most(pairs * 0x1p-22));
        CHECK(near < 1.1 * pairs * 64 * 0x1p-22);
        CHECK(low < most(pairs * 0x1p-18));
    }
}

TEST_CASE("few pairs of lines correlate in either part of their amplitudes", "[amplitudes]") {
    constexpr int lines = 512, length = 1024;
    for (const bool columns : {true, false}) {
        std::vector<std::array<float, 2>> parts(lines * length);
        for (int i = 0; i < lines; ++i)
            for (int j = 0; j < length; ++j) {
                const Complex a = columns ? amplitude(i, j, 7) : amplitude(j, i, 7);
                parts[static_cast<std::size_t>(i * length + j)] = {static_cast<float>(a.real()),
                                                                   static_cast<float>(a.imag())};
            }
        for (const std::size_t part : {0u, 1u}) {
            int correlated = 0;
            for (std::size_t a = 0; a < lines; ++a)
                for (std::size_t b = 0; b < a; ++b) {
                    float sum = 0;
                    for (std::size_t j = 0; j < length; ++j)
                        sum += parts[a * length + j][part] * parts[b * length + j][part];
                    correlated += std::abs(2 * sum / length) > 0.2; // six standard deviations
                }
            fmt::print("{} of {} pairs of {} correlate in part {}\n", correlated, lines * (lines - 1) / 2,
                       columns ? "columns" : "rows", part);
            CHECK(correlated < 30);
        }
    }
}

TEST_CASE("the amplitudes around node (0, 0) have mean 0 and variance 1 over seeds", "[amplitudes]") {
    const double deviation = noise::lattice_amplitude_deviation();
    for (const auto& [column, row, seeds] : {std::array{0, 0, 1 << 25},
                                             {1, 0, 1 << 21},
                                             {0, 1, 1 << 21},
                                             {-1, -1, 1 << 21},
                                             {1, 1, 1 << 21},
                                             {5, 0, 1 << 21},
                                             {13, 0, 1 << 21}}) {
        double sums[5] = {};
        for (int i = 0; i < seeds; ++i) {
            const Complex a =
                noise::lattice_amplitude(noise::lattice_word(column, row, static_cast<std::uint32_t>(i)));
            sums[0] += a.real();
            sums[1] += a.imag();
            sums[2] += a.real() * a.real();
            sums[3] += a.imag() * a.imag();
            sums[4] += a.real() * a.imag();
        }
        const double error = 5 / std::sqrt(seeds);
        INFO("node (" << column << ", " << row << ")");
        CHECK(std::abs(sums[0] / seeds) < error * deviation);
        CHECK(std::abs(sums[1] / seeds) < error * deviation);
        CHECK(std::abs(sums[2] / seeds / (deviation * deviation) - 1) < std::numbers::sqrt2 * error);
        CHECK(std::abs(sums[3] / seeds / (deviation * deviation) - 1) < std::numbers::sqrt2 * error);
        CHECK(std::abs(sums[4] / seeds / (deviation * deviation)) < error + 5e-4); // the parts share 20 bits
    }
}

TEST_CASE("the fields of small seeds and of lobe seeds do not correlate", "[amplitudes]") {
    constexpr int side = 48, fields = 64;
    for (const bool lobes : {false, true}) {
        std::vector<std::vector<Complex>> field(fields);
        for (int k = 0; k < fields; ++k)
            for (int i = 0; i < side * side; ++i)
                field[static_cast<std::size_t>(k)].push_back(
                    amplitude(i % side - 9, i / side - 9,
                              lobes ? noise::lattice_derived_seed(0, k - 4) : static_cast<std::uint32_t>(k)));
        double largest = 0;
        for (std::size_t a = 0; a < fields; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                Complex with = 0, mirrored = 0;
                for (std::size_t i = 0; i < side * side; ++i) {
                    with += field[a][i] * std::conj(field[b][i]);
                    mirrored += field[a][i] * std::conj(field[b][side * side - 1 - i]);
                }
                largest = std::max({largest, std::abs(with) / side, std::abs(mirrored) / side});
            }
        fmt::print("{}: largest correlation {:.2f} deviations\n", lobes ? "lobes" : "small seeds", largest);
        CHECK(largest < 5); // fewer than one in a million sets of 4032 complex normal numbers reach 5
    }
}

TEST_CASE("periodograms of lines, diagonals and increments are flat", "[amplitudes]") {
    constexpr int length = 4096;
    const std::unique_ptr<kiss_fft_state, void (*)(void*)> fft(kiss_fft_alloc(length, 0, nullptr, nullptr),
                                                               kiss_fft_free);
    const auto of_kiss = [](auto& numbers) { return reinterpret_cast<kiss_fft_cpx*>(numbers.data()); };
    const auto largest = [&](auto value) {
        double peak = 0;
        for (std::int32_t line = -8; line < 8; ++line) {
            std::vector<std::complex<float>> row(length), powers(length);
            for (std::size_t i = 0; i < length; ++i)
                row[i] = std::complex<float>(value(static_cast<std::int32_t>(i), line));
            kiss_fft(fft.get(), of_kiss(row), of_kiss(powers));
            for (std::size_t k = 1; k < length; ++k)
                peak = std::max(peak, double{std::norm(powers[k])} / length);
        }
        return peak;
    };
    const auto a = [](std::int32_t x, std::int32_t y) { return amplitude(x - 2048, y, 7); };
    const auto power = [&](std::int32_t x, std::int32_t y) { return Complex(std::norm(a(x, y)) - 1); };
    const auto sign = [](double part) { return part < 0 ? -1.0 : 1.0; };
    const std::pair<const char*, double> peaks[] = {
        {"rows", largest(a)},
        {"columns", largest([&](auto i, auto line) { return amplitude(line, i - 2048, 7); })},
        {"diagonals", largest([&](auto i, auto line) { return amplitude(i - 2048, i - 2048 + line, 7); })},
        {"increments", largest([&](auto i, auto line) { return a(i, line) * std::conj(a(i + 1, line)); })},
        {"power", largest(power)},
        {"signs", largest([&](auto i, auto line) {
             const Complex value = a(i, line);
             return Complex(sign(value.real()), sign(value.imag())) / std::numbers::sqrt2;
         })},
    };
    // The largest of 65536 exponential numbers is 11.7 on average; one in 5 * 10^4 sets reaches 22.
    for (const auto& [name, peak] : peaks) {
        fmt::print("{}: largest power of a wave {:.1f}\n", name, peak);
        CHECK(peak < 22);
    }
}
