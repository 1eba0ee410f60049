#pragma once

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace gabor::test {

/// The largest difference seen, in units of its tolerance, and where it was. A NaN or an infinity counts as
/// larger than any number, and stays.
class Largest {
  public:
    /// `place` is a string, a function that returns one, or an object for which to_string is defined.
    template <typename Place>
    void see(double value, double expected, double tolerance, const Place& place) {
        ++points_;
        const double scaled = std::abs(value - expected) / tolerance;
        if (!std::isfinite(difference_) || scaled <= difference_)
            return;
        difference_ = scaled;
        where_ = fmt::format("{} instead of {} at {}", value, expected, text_of(place));
    }

    /// Whether it saw at least one point, and every difference was within its tolerance.
    bool holds() const { return points_ > 0 && difference_ <= 1; }

    void check(std::string_view name) const {
        const std::string found =
            fmt::format("{:<22} {:.3f} in {} points: {}", name, difference_, points_, where_);
        fmt::print("  {}\n", found);
        INFO(found);
        CHECK(holds());
    }

  private:
    template <typename Place>
    static std::string text_of(const Place& place) {
        if constexpr (std::invocable<Place>)
            return place();
        else if constexpr (std::convertible_to<Place, std::string_view>)
            return std::string(std::string_view(place));
        else
            return to_string(place);
    }

    std::size_t points_ = 0;
    double difference_ = 0;
    std::string where_ = "nowhere";
};

/// The largest differences of several functions, by name.
using Differences = std::map<std::string, Largest>;

inline void check(const Differences& differences, std::size_t functions) {
    CHECK(differences.size() == functions); // no function was left out
    for (const auto& [name, largest] : differences)
        largest.check(name);
}

} // namespace gabor::test
