// Tests Largest, which other tests use for comparisons: one wrong point in a million must fail.

#include "../largest.hpp"

#include <limits>
#include <string>

using gabor::test::Largest;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A million correct points, except one that has `value` instead of `expected`.
Largest with(double value, double expected = 0) {
    Largest largest;
    for (int i = 0; i < 1'000'000; ++i)
        largest.see(i == 500'000 ? value : 0, i == 500'000 ? expected : 0, 1e-5, "here");
    return largest;
}

} // namespace

TEST_CASE("one bad point in a million fails a comparison") {
    CHECK(with(0.9e-5).holds());
    CHECK_FALSE(with(1.1e-5).holds());
    CHECK_FALSE(with(-1.1e-5).holds());
    CHECK_FALSE(with(not_a_number).holds());
    CHECK_FALSE(with(infinity).holds());
    CHECK_FALSE(with(-infinity).holds());
    CHECK_FALSE(with(0, not_a_number).holds());
    CHECK_FALSE(with(infinity, infinity).holds());
}

TEST_CASE("a larger difference does not hide an earlier NaN, nor a NaN an earlier difference") {
    for (const double first : {not_a_number, 3.0})
        for (const double second : {not_a_number, infinity, 5.0}) {
            Largest largest;
            largest.see(first, 0, 1, "first");
            largest.see(second, 0, 1, "second");
            CHECK_FALSE(largest.holds());
        }
}

TEST_CASE("a comparison without points fails") {
    CHECK_FALSE(Largest().holds());
}
