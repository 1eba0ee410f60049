// Draws arguments over all floats and all cells, edge cases and random bits, and records broken promises.

#pragma once

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <string>

namespace gabor::test {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float world = 2147483520; ///< the last float below 2^31

/// Larger than any noise of variance 1 from so few impulses or nodes.
inline constexpr float largest_noise = 40;

inline constexpr float edges[] = {0,
                                  std::numeric_limits<float>::denorm_min(),
                                  1e-40f,
                                  std::numeric_limits<float>::min(),
                                  1e-30f,
                                  1e-20f,
                                  1e-10f,
                                  std::numeric_limits<float>::epsilon(),
                                  1e-6f,
                                  0.1f,
                                  0.25f,
                                  0.5f,
                                  0.99999994f,
                                  1,
                                  1.0000001f,
                                  1.5f,
                                  2,
                                  4,
                                  64,
                                  400,
                                  16777215,
                                  16777216,
                                  1e9f,
                                  world,
                                  2147483648.0f,
                                  4294967296.0f,
                                  1e15f,
                                  1e20f,
                                  1e30f,
                                  std::numeric_limits<float>::max(),
                                  infinity,
                                  std::numeric_limits<float>::quiet_NaN()};

inline constexpr std::int32_t cell_edges[] = {0,
                                              1,
                                              -1,
                                              2,
                                              0x00ffffff,
                                              0x01000000,
                                              std::numeric_limits<std::int32_t>::max(),
                                              std::numeric_limits<std::int32_t>::max() - 1,
                                              std::numeric_limits<std::int32_t>::min(),
                                              std::numeric_limits<std::int32_t>::min() + 1};

/// Draws arguments: floats, words and cells.
class AnyFloat {
  public:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }

    /// Half edge cases of either sign, half random bits.
    float any() {
        if (word() % 2)
            return std::bit_cast<float>(word());
        const float edge = edges[word() % std::size(edges)];
        return word() % 2 ? -edge : edge;
    }

    /// Restricts them to [-most, most]; with infinity, excludes only NaN.
    float within(float most) {
        float value = any();
        while (!(std::abs(value) <= most))
            value = any();
        return value;
    }

    std::int32_t cell() {
        return word() % 2 ? static_cast<std::int32_t>(word()) : cell_edges[word() % std::size(cell_edges)];
    }

  private:
    std::mt19937 random_{11};
};

/// Counts a function's broken promises and keeps the first place.
struct Broken {
    std::string function;
    std::size_t times = 0;
    std::string where = {};

    template <typename Sample>
    void see(std::span<const float> values, float most, const Sample& sample) {
        for (const float value : values) {
            if (std::abs(value) <= most) // false for a NaN
                continue;
            if (times++ == 0)
                where = fmt::format("{} at {}", value, to_string(sample));
        }
    }
};

} // namespace gabor::test
