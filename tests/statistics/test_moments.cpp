#include "statistics/moments.hpp"

#include "samples.hpp"

#include <boost/math/statistics/univariate_statistics.hpp>
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

void check(const Moments& moments, const std::vector<float>& values) {
    const auto [mean, m2, m3, m4] =
        boost::math::statistics::first_four_moments(std::vector<long double>(values.begin(), values.end()));
    CHECK(moments.count() == values.size());
    CHECK(moments.mean() == Approx(static_cast<double>(mean)).epsilon(1e-12));
    CHECK(moments.variance() == Approx(static_cast<double>(m2)).epsilon(1e-11));
    CHECK(moments.skewness() == Approx(static_cast<double>(m3 / std::pow(m2, 1.5L))).epsilon(1e-9));
    CHECK(moments.excess_kurtosis() == Approx(static_cast<double>(m4 / (m2 * m2) - 3)).epsilon(1e-9));
    CHECK(moments.minimum() == *std::min_element(values.begin(), values.end()));
    CHECK(moments.maximum() == *std::max_element(values.begin(), values.end()));
}

} // namespace

TEST_CASE("moments agree with another library's in long double, even far from zero") {
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
