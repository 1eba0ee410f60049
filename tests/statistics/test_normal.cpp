#include "statistics/estimate.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace gabor::statistics;

TEST_CASE("the normal distribution function has its tabulated values") {
    CHECK(normal_cdf(0) == 0.5);
    CHECK(normal_cdf(1) == Approx(0.84134474606854293).epsilon(1e-15));
    CHECK(normal_cdf(-1.5) == Approx(0.066807201268858066).epsilon(1e-14));
    CHECK(normal_cdf(-10) == Approx(7.6198530241605261e-24).epsilon(1e-13));
    CHECK(normal_density(0) == Approx(0.39894228040143268).epsilon(1e-15));
    CHECK(normal_density(2) == Approx(0.053990966513188063).epsilon(1e-15));
}

TEST_CASE("quantiles invert the distribution function, far into the tails") {
    for (double x = -37; x <= 5; x += 0.37)
        CHECK(normal_quantile(normal_cdf(x)) == Approx(x).epsilon(1e-10).margin(1e-14));
}

TEST_CASE("quantiles are defined at the ends of the range and beyond") {
    CHECK(normal_quantile(0) == -std::numeric_limits<double>::infinity());
    CHECK(normal_quantile(1) == std::numeric_limits<double>::infinity());
    CHECK(std::isnan(normal_quantile(-0.1)));
    CHECK(std::isnan(normal_quantile(1.1)));
    CHECK(std::isnan(normal_quantile(std::numeric_limits<double>::quiet_NaN())));
}
