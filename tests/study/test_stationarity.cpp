#include "../statistics/samples.hpp"
#include "statistics/stationarity.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace gabor::statistics;

TEST_CASE("known values have the expected quantiles and spreads", "[stationarity]") {
    CHECK(quantile({3, 1, 2}, 0.5) == 2);
    CHECK(quantile({0, 10}, 0.25) == 2.5);
    CHECK(quantile({7}, 0.9) == 7);
    CHECK_THROWS_AS(quantile({}, 0.5), std::invalid_argument);
    std::vector<double> values;
    for (int i = 0; i <= 100; ++i)
        values.push_back(i);
    CHECK(dispersion(values).median == 50);
    CHECK(dispersion(values).interdecile == Approx(80.0 / 50));
}

TEST_CASE("windows of white noise have the spread of a chi-square distribution", "[stationarity]") {
    constexpr std::size_t pixels = 256;
    constexpr std::size_t count = 20000;
    const std::vector<float> values = samples::normal(pixels * count, 1, 0, 2);
    InstanceStationarity whole;
    for (std::size_t i = 0; i < count; ++i)
        whole.add(std::span(values).subspan(i * pixels, pixels));
    // The variance of 256 normal values is nearly normal, with mean 4 (255 / 256) and relative deviation
    // sqrt(2 / 255).
    CHECK(whole.contrast().median == Approx(4 * 255.0 / 256 * (1 - 2.0 / (9 * 255) * 3)).epsilon(0.003));
    CHECK(whole.contrast().interdecile == Approx(2 * 1.28155 * std::sqrt(2 / 255.0)).epsilon(0.02));
    CHECK(whole.median_deviation() == Approx(std::sqrt(whole.contrast().median)).epsilon(1e-6));
}

TEST_CASE("points with equal statistics differ only by chance, and a point with another mean is detected",
          "[stationarity]") {
    constexpr std::size_t count = 64;
    constexpr std::size_t instances = 20000;
    std::vector<float> values = samples::normal(count * instances, 2);
    const auto at_each_place = [&] {
        ProcessStationarity result;
        for (std::size_t place = 0; place < count; ++place) {
            Moments moments;
            moments.add(std::span(values).subspan(place * instances, instances));
            result.add(moments);
        }
        return result;
    };
    const ProcessStationarity alike = at_each_place();
    CHECK(alike.variance().median == Approx(1).epsilon(0.005));
    CHECK(alike.chance_interdecile() == Approx(2 * 1.28155 * std::sqrt(2.0 / instances)).epsilon(0.01));
    CHECK(alike.variance().interdecile == Approx(alike.chance_interdecile()).epsilon(0.35));
    CHECK(alike.largest_mean() < alike.chance_largest_mean());

    for (float& value : std::span(values).subspan(5 * instances, instances))
        value += 0.05f;
    const ProcessStationarity shifted = at_each_place();
    CHECK(shifted.largest_mean() > 1.3 * shifted.chance_largest_mean());
}
