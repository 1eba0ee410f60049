#include "statistics/spectrum.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

using namespace gabor::statistics;

namespace {

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
    const double degrees = std::atan2(y, x) * 180 / std::numbers::pi;
    CHECK(summary.peak->orientation == Approx(degrees < 0 ? degrees + 180 : degrees).margin(0.01));
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
}
