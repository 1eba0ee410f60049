#include "statistics/spectrum.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

using namespace gabor::statistics;

namespace {

SpectrumSummary spectrum_of(const std::vector<float>& picture, int width, int height) {
    Spectrum spectrum(width, height, *segment_side(width, height));
    const std::span<const float> pixels = picture;
    const auto columns = static_cast<std::size_t>(width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        spectrum.add_row(pixels.subspan(y * columns, columns));
    return summarize(spectrum.periodogram(), spectrum.side());
}

std::vector<float> wave(int width, int height, double fx, double fy, double amplitude, double noise) {
    std::vector<float> picture =
        samples::normal(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 21, 0, noise);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double x = static_cast<double>(i % static_cast<std::size_t>(width));
        const double y = static_cast<double>(i / static_cast<std::size_t>(width));
        picture[i] +=
            static_cast<float>(amplitude * std::cos(2 * std::numbers::pi * (fx * x + fy * y) + 0.7));
    }
    return picture;
}

double degrees(double fx, double fy) {
    const double angle = std::atan2(fy, fx) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 180 : angle;
}

constexpr int lobe_side = 256;

/// The periodogram that has density(x, y) at each frequency (x, y) / lobe_side.
std::vector<double> periodogram_of(const std::function<double(double, double)>& density) {
    std::vector<double> periodogram;
    for (int row = 0; row < lobe_side; ++row)
        for (int x = 0; x <= lobe_side / 2; ++x)
            periodogram.push_back(density(x, row < lobe_side / 2 ? row : row - lobe_side));
    return periodogram;
}

double gauss(double dx, double dy, double sigma) {
    return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma);
}

} // namespace

TEST_CASE("a plane wave in white noise is found at its frequency and orientation") {
    const auto [fx, fy] = GENERATE(table<double, double>(
        {{0.1, 0.0}, {0.0, 0.123}, {0.0817, 0.0433}, {0.0817, -0.0433}, {-0.21, 0.3}, {0.4, 0.4}}));
    const SpectrumSummary summary = spectrum_of(wave(300, 200, fx, fy, 0.5, 1), 300, 200);
    INFO("wave " << fx << ", " << fy);
    CHECK(summary.peak->frequency == Approx(std::hypot(fx, fy)).margin(0.0005));
    CHECK(std::remainder(summary.peak->orientation - degrees(fx, fy), 180) == Approx(0).margin(0.3));
    CHECK(summary.peak->orientation >= 0);
    CHECK(summary.peak->orientation < 180);
    CHECK(summary.power == Approx(1.125).epsilon(0.02));
}

TEST_CASE("the bandwidth of a single plane wave equals the resolution") {
    const double fx = GENERATE(0.1, 0.105, 0.1075);
    const SpectrumSummary summary = spectrum_of(wave(512, 512, fx, 0.02, 1, 0), 512, 512);
    CHECK(summary.resolution == Approx(2.0 / 256));
    CHECK(summary.bandwidth == Approx(summary.resolution).epsilon(0.1));
    CHECK(summary.power == Approx(0.5).epsilon(0.002));
}

TEST_CASE("the power is the mean power of the windowed segments") {
    const int side = 16;
    const std::vector<float> picture = samples::normal(side * side, 8);
    Spectrum spectrum(side, side, *segment_side(side, side));
    REQUIRE(spectrum.side() == 8);
    for (int y = 0; y < side; ++y)
        spectrum.add_row(std::span(picture).subspan(static_cast<std::size_t>(y * side), side));
    double expected = 0;
    for (const int top : {0, 4, 8})
        for (const int left : {0, 4, 8})
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) {
                    const double w = std::pow(std::sin(std::numbers::pi * x / 8), 2) *
                                     std::pow(std::sin(std::numbers::pi * y / 8), 2);
                    const double v = w * picture[static_cast<std::size_t>((top + y) * side + left + x)];
                    expected += v * v / (9 * 9); // 9 segments, and the squares of their weights sum to 9
                }
    const SpectrumSummary summary = summarize(spectrum.periodogram(), 8);
    CHECK(summary.power == Approx(expected).epsilon(1e-6));
    CHECK(std::reduce(summary.radial.begin(), summary.radial.end()) == Approx(summary.power).epsilon(1e-12));
}

TEST_CASE("the power of white noise in an annulus of frequencies is proportional to its area") {
    const SpectrumSummary summary = spectrum_of(samples::normal(1024 * 1024, 9), 1024, 1024);
    CHECK(summary.power == Approx(1).epsilon(0.01));
    const double df = summary.radial_step;
    // An annulus of radius f < 1/2 and width df has the area 2 pi f df in a plane of area 1.
    const double inner = std::accumulate(summary.radial.begin() + 52, summary.radial.begin() + 205, 0.0);
    double area = 0;
    for (int k = 52; k < 205; ++k)
        area += 2 * std::numbers::pi * k * df * df;
    CHECK(inner == Approx(area).epsilon(0.01));
}

TEST_CASE("segments fit into the picture, and tiny pictures have none") {
    CHECK(segment_side(1024, 1024) == 512);
    CHECK(segment_side(1023, 4000) == 256);
    CHECK(segment_side(65536, 65536) == 512);
    CHECK(segment_side(1 << 20, 65536) == 32);
    CHECK(segment_side(16, 100) == 8);
    CHECK_FALSE(segment_side(15, 100));
    CHECK_FALSE(segment_side(100, 15));
}

TEST_CASE("a Gaussian lobe is measured correctly") {
    const double x = GENERATE(50.0, 51.3);
    const double y = GENERATE(0.0, 33.4, -33.4);
    const double sigma = GENERATE(3.0, 6.0);
    const auto summary =
        summarize(periodogram_of([&](double fx, double fy) {
                      return 0.7 * gauss(fx - x, fy - y, sigma) + 0.7 * gauss(fx + x, fy + y, sigma);
                  }),
                  lobe_side);
    INFO("lobe at " << x << ", " << y << ", sigma " << sigma);
    CHECK(summary.power == Approx(1.4).epsilon(1e-6));
    CHECK(summary.radial_step == 1.0 / lobe_side);
    CHECK(std::reduce(summary.radial.begin(), summary.radial.end()) == Approx(1.4).epsilon(1e-6));
    CHECK(summary.peak->frequency == Approx(std::hypot(x, y) / lobe_side).epsilon(1e-5));
    CHECK(summary.peak->orientation == Approx(degrees(x, y)).margin(0.01));
    CHECK(summary.bandwidth ==
          Approx(2 * std::sqrt(2 * std::numbers::ln2) * sigma / lobe_side).epsilon(0.02));
}

TEST_CASE("the bandwidth of a wide ring is right, though the ring is not Gaussian") {
    const auto summary =
        summarize(periodogram_of([](double fx, double fy) {
                      const double r = std::hypot(fx, fy);
                      const double phase = std::numbers::pi * (r - 65) / 30;
                      // The power per annulus is one period of 1 + cos, 60 wide at its base.
                      return std::abs(phase) < std::numbers::pi ? (1 + std::cos(phase)) / r : 0;
                  }),
                  lobe_side);
    CHECK(summary.bandwidth == Approx(30.0 / lobe_side).epsilon(0.015));
    CHECK(summary.peak->frequency == Approx(65.0 / lobe_side).epsilon(0.15)); // the ring has no single peak
}

TEST_CASE("lobes beyond the highest frequency appear where sampling aliases them") {
    const auto summary = summarize(periodogram_of([](double fx, double fy) {
                                       double power = 0;
                                       for (const double fold : {-1.0, 0.0, 1.0})
                                           power += gauss(fx - 126 - fold * lobe_side, fy - 10, 4) +
                                                    gauss(fx + 126 - fold * lobe_side, fy + 10, 4);
                                       return power;
                                   }),
                                   lobe_side);
    CHECK(summary.peak->frequency == Approx(std::hypot(126, 10) / lobe_side).epsilon(0.01));
    CHECK(summary.power == Approx(2).epsilon(1e-3));
}

TEST_CASE("a spectrum of zeros has no peak") {
    const auto summary = summarize(periodogram_of([](double, double) { return 0; }), lobe_side);
    CHECK(summary.power == 0);
    CHECK(!summary.peak);
    const auto longest = summarize(
        periodogram_of([](double fx, double fy) { return std::abs(fx) == 1 && fx == fy; }), lobe_side);
    REQUIRE(longest.peak);
    CHECK(longest.peak->frequency ==
          Approx(std::numbers::sqrt2 / lobe_side)); // the longest waves with a peak
    CHECK(
        !summarize(periodogram_of([](double fx, double fy) { return fx == 0 && fy == 0; }), lobe_side).peak);
}
