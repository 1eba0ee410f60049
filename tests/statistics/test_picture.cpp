#include "statistics/picture.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace gabor::statistics;

namespace {

PictureReport report_on(const std::vector<float>& picture, int width, int height, int band, double mean = 0) {
    PictureStatistics statistics(width, height, mean);
    const std::span<const float> pixels = picture;
    const auto columns = static_cast<std::size_t>(width);
    for (int y = 0; y < height; y += band) {
        const auto rows = static_cast<std::size_t>(std::min(band, height - y));
        statistics.add_rows(pixels.subspan(static_cast<std::size_t>(y) * columns, rows * columns));
    }
    return statistics.report();
}

} // namespace

TEST_CASE("reports do not depend on the band height") {
    const std::vector<float> picture = samples::picture(203, 181, {1.5, 0.2, 0.1}, 41);
    const PictureReport one = report_on(picture, 203, 181, 1);
    REQUIRE(one.spectrum);
    CHECK(report_on(picture, 203, 181, 37) == one);
    CHECK(report_on(picture, 203, 181, 181) == one);
}

TEST_CASE("a report contains the results of its parts") {
    const int side = 512;
    std::vector<float> picture = samples::picture(side, side, {2, 0.2, 0.1}, 42);
    for (float& value : picture)
        value = 0.5f + 0.25f * value;
    Moments moments;
    CHECK(add_finite(moments, picture) == 0);
    CHECK(moments.mean() == Approx(0.5).epsilon(0.01));

    const PictureReport report = report_on(picture, side, side, 100, moments.mean());
    CHECK(report.not_finite == 0);
    CHECK(report.moments.count() == picture.size());
    CHECK(report.moments.mean() == Approx(moments.mean()).epsilon(1e-12));
    CHECK(report.moments.excess_kurtosis() == Approx(moments.excess_kurtosis()).epsilon(1e-9));
    CHECK(report.spectrum->power == Approx(moments.variance()).epsilon(0.05));
    CHECK(report.spectrum->peak->frequency == Approx(std::hypot(0.2, 0.1)).epsilon(0.02));
}

TEST_CASE("non-finite pixels are counted and ignored") {
    std::vector<float> picture = samples::normal(64 * 64, 43);
    const PictureReport clean = report_on(picture, 64, 64, 64);
    Moments rest;
    for (const std::size_t bad : {0u, 63u, 64u, 2000u, 2001u, 4095u})
        picture[bad] =
            bad % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    CHECK(add_finite(rest, picture) == 6);
    CHECK(rest.count() == 64 * 64 - 6);

    const PictureReport report = report_on(picture, 64, 64, 64);
    CHECK(report.not_finite == 6);
    CHECK(report.moments.count() == rest.count());
    CHECK(report.moments.mean() == Approx(rest.mean()).epsilon(1e-9));
    CHECK(report.spectrum->power == Approx(clean.spectrum->power).epsilon(0.01));

    const PictureReport nothing =
        report_on(std::vector<float>(64 * 64, std::numeric_limits<float>::quiet_NaN()), 64, 64, 64);
    CHECK(nothing.not_finite == 64 * 64);
    CHECK(nothing.moments.count() == 0);
}

TEST_CASE("small pictures have no spectrum") {
    const PictureReport tiny = report_on(samples::normal(15 * 3, 44), 15, 3, 3);
    CHECK(tiny.moments.count() == 45);
    CHECK_FALSE(tiny.spectrum);
}
