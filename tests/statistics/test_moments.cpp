#include "statistics/moments.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace gabor::statistics;

namespace {

/// Skewed and heavy-tailed values, moved away from 0 by `offset`.
std::vector<float> skewed_values(std::size_t count, double offset) {
    std::vector<float> values = samples::normal(count, 11);
    for (float& value : values)
        value = static_cast<float>(offset + value + 0.3 * value * value + 0.1 * value * value * value);
    return values;
}

struct Direct {
    long double mean = 0;
    long double m2 = 0;
    long double m3 = 0;
    long double m4 = 0;
};

Direct directly(const std::vector<float>& values) {
    Direct direct;
    const long double n = static_cast<long double>(values.size());
    for (const float value : values)
        direct.mean += value / n;
    for (const float value : values) {
        const long double d = value - direct.mean;
        direct.m2 += d * d / n;
        direct.m3 += d * d * d / n;
        direct.m4 += d * d * d * d / n;
    }
    return direct;
}

void check(const Moments& moments, const std::vector<float>& values) {
    const Direct direct = directly(values);
    CHECK(moments.count() == values.size());
    CHECK(moments.mean() == Approx(static_cast<double>(direct.mean)).epsilon(1e-12));
    CHECK(moments.variance() == Approx(static_cast<double>(direct.m2)).epsilon(1e-11));
    CHECK(moments.skewness() ==
          Approx(static_cast<double>(direct.m3 / std::pow(direct.m2, 1.5L))).epsilon(1e-9));
    CHECK(moments.excess_kurtosis() ==
          Approx(static_cast<double>(direct.m4 / (direct.m2 * direct.m2) - 3)).epsilon(1e-9));
    CHECK(moments.minimum() == *std::min_element(values.begin(), values.end()));
    CHECK(moments.maximum() == *std::max_element(values.begin(), values.end()));
}

} // namespace

TEST_CASE("moments agree with direct sums in long double, far from zero too") {
    const double offset = GENERATE(0.0, 500.0);
    const std::vector<float> values = skewed_values(20011, offset);
    Moments together;
    together.add(values);
    check(together, values);
    Moments singly;
    for (const float value : values)
        singly.add(static_cast<double>(value));
    check(singly, values);
}

TEST_CASE("merged moments are those of all values") {
    const std::vector<float> values = skewed_values(10007, 3);
    const std::span<const float> all = values;
    Moments merged;
    Moments rest;
    merged.add(all.first(1234));
    rest.add(all.subspan(1234));
    merged.merge(Moments());
    merged.merge(rest);
    check(merged, values);
}

TEST_CASE("moments of no values are NaN") {
    const Moments moments;
    CHECK(moments.count() == 0);
    CHECK(std::isnan(moments.variance()));
}
