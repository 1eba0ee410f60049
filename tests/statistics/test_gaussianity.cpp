#include "statistics/gaussianity.hpp"

#include "samples.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

using namespace gabor::statistics;

namespace {

const boost::math::normal normal;

/// A normal variable bent into another distribution of unit variance,
/// g(x) = (x + c x^3) / sqrt(1 + 6 c + 15 c^2).
struct Bent {
    double c;

    double norm() const { return std::sqrt(1 + 6 * c + 15 * c * c); }
    double operator()(double x) const { return (x + c * x * x * x) / norm(); }
    void apply(std::span<float> values) const {
        for (float& value : values)
            value = static_cast<float>((*this)(value));
    }
    /// Its Cramér-von Mises index, 2^18 times the integral of (F - Phi)^2 dPhi with F(g(x)) = Phi(x).
    double index() const {
        const auto square = [&](double x) {
            const double y = (*this)(x), slope = (1 + 3 * c * x * x) / norm();
            return std::pow(cdf(normal, x) - cdf(normal, y), 2) * pdf(normal, y) * slope;
        };
        return 262144 * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(square, -10.0, 10.0);
    }
};

/// The index by its definition.
double sorted_index(std::vector<float> values, double deviation) {
    std::sort(values.begin(), values.end());
    const double n = static_cast<double>(values.size());
    double t = 1 / (12 * n);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double d = (2 * static_cast<double>(i) + 1) / (2 * n) - cdf(normal, values[i] / deviation);
        t += d * d;
    }
    return 262144 * (t - 1.0 / 6) / n;
}

Estimate index_of(const std::vector<float>& values, double deviation = 1) {
    Gaussianity gaussianity(deviation);
    gaussianity.add(values);
    return gaussianity.index();
}

/// The share of 1500 samples of `count` values whose interval contains the exact index, and the mean index.
struct Coverage {
    double part = 0;
    double mean = 0;
};

Coverage coverage(std::size_t count, const Bent& bent) {
    constexpr int repetitions = 1500;
    const double exact = bent.index();
    Coverage result;
    for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
        std::vector<float> values = samples::normal(count, 1000 + seed);
        bent.apply(values);
        const Estimate index = index_of(values);
        result.part += (index.low <= exact && exact <= index.high) / double(repetitions);
        result.mean += index.value / repetitions;
    }
    return result;
}

} // namespace

TEST_CASE("the index agrees with its definition, which sorts the values") {
    const std::size_t count = GENERATE(1u, 2u, 100u, 50000u);
    const double c = GENERATE(0.0, 0.03);
    const double deviation = GENERATE(1.0, 0.25);
    std::vector<float> values = samples::normal(count, count);
    Bent{c}.apply(values);
    for (float& value : values)
        value *= static_cast<float>(deviation);
    // The unit is that of the statistic T, whose standard deviation is at least 0.15.
    const double unit = 262144 / static_cast<double>(count);
    CHECK(index_of(values, deviation).value / unit ==
          Approx(sorted_index(values, deviation) / unit).epsilon(1e-3).margin(1e-3));
}

TEST_CASE("the index of two values equals the one computed by hand") {
    // For x = 0 and -0, u = Phi(x) is 1/2, so T = 1/24 + 2 (1/4)^2 = 1/6.
    const Estimate index = index_of({0.0f, -0.0f});
    CHECK(index.value == Approx(0).margin(262144 / 2 * 1e-3));
    CHECK(index.value - index.low == Approx(262144 / 2 * 1.96 / std::sqrt(45)).epsilon(1e-6));
}

TEST_CASE("a deviation measured afterwards gives the same index as one known beforehand") {
    // gabor-lab study counts sums and differences of two values in units of the largest deviation that they
    // can have, so it passes relative deviations up to 1. The test goes slightly beyond.
    const double relative = GENERATE(0.1, 0.5, 0.7, 1.2);
    std::vector<float> values = samples::normal(1000000, 8);
    Bent{0.05}.apply(values);
    const Estimate known = index_of(values);
    for (float& value : values)
        value *= static_cast<float>(relative);
    Gaussianity gaussianity;
    gaussianity.add(values);
    const Estimate told = gaussianity.index(relative);
    INFO("known " << known.value << ", told " << told.value);
    CHECK(told.value == Approx(known.value).epsilon(0.005));
    CHECK(told.low == Approx(known.low).epsilon(0.005));
    CHECK(told.high == Approx(known.high).epsilon(0.005));
    CHECK(gaussianity.index().value != Approx(known.value).epsilon(0.1));
}

TEST_CASE("indices are unbiased, and 95 % of their intervals cover the truth") {
    SECTION("normal") {
        const Coverage normal = coverage(1000, {0});
        CHECK(normal.part == Approx(0.95).margin(0.02));
        CHECK(normal.mean == Approx(0).margin(3 * 262.144 * 0.149 / std::sqrt(1500)));
    }
    SECTION("nearly normal: intervals are wider than necessary, never too narrow") {
        const double c = GENERATE(0.01, 0.03, 0.05);
        const Coverage near = coverage(1000, {c});
        INFO("c " << c << ", index " << Bent{c}.index() << ", covered " << near.part);
        CHECK(near.part > 0.94);
    }
    SECTION("far from normal") {
        const Bent bent{0.2};
        const Coverage far = coverage(4000, bent);
        CHECK(far.part == Approx(0.95).margin(0.02));
        CHECK(far.mean == Approx(bent.index()).epsilon(0.01));
    }
}

TEST_CASE("merging is exact, in any order") {
    const std::vector<float> values = samples::normal(30000, 7);
    const std::span<const float> all = values;
    Gaussianity whole;
    Gaussianity first;
    Gaussianity second;
    whole.add(all);
    first.add(all.first(7777));
    for (const float value : all.subspan(7777))
        second.add(static_cast<double>(value));
    Gaussianity forth = first;
    Gaussianity back = second;
    forth.merge(second);
    back.merge(first);
    CHECK(forth.index() == whole.index());
    CHECK(back.index() == whole.index());
    CHECK(whole.count() == values.size());
}

TEST_CASE("infinities count as extreme values, and NaN is refused") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    CHECK(index_of({-infinity, 0, infinity}).value == index_of({-20, 0, 20}).value);
    CHECK_THROWS_AS(index_of({std::numeric_limits<float>::quiet_NaN()}), std::domain_error);
}
