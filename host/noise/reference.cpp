#include "noise/reference.hpp"

#include "noise/variance.hpp"

#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

constexpr std::uint32_t spread = 0x9e3779b1u;

std::uint32_t mix(std::uint32_t word, std::uint32_t salt) {
    word = (word ^ word >> 16) * 0x21f0aaadu + salt;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

// Cells wrap modulo 2^32.
std::int32_t shifted(std::int32_t cell, std::int64_t by) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(cell) + static_cast<std::uint32_t>(by));
}

double window(const Recipe& recipe, double x) {
    if (std::abs(x) >= 1)
        return 0;
    const double u = 1 - x * x;
    return u * u * (recipe.window[0] + recipe.window[1] * u + recipe.window[2] * u * u);
}

} // namespace

std::uint32_t impulse_word(std::int32_t cell_x, std::int32_t cell_y, int index, std::uint32_t seed) {
    const std::uint32_t seed_word = mix(seed * spread, 0x2545f491u);
    const std::uint32_t row_word = mix(static_cast<std::uint32_t>(cell_y) * spread + seed_word, seed_word);
    const std::uint32_t salt = row_word + static_cast<std::uint32_t>(index) * 0x85ebca6bu;
    return mix(static_cast<std::uint32_t>(cell_x) * spread + salt, salt);
}

Reference::Reference(const Recipe& recipe, double frequency, double orientation, std::uint32_t seed)
    : recipe_(recipe), wave_x_(frequency * std::cos(orientation)), wave_y_(frequency * std::sin(orientation)),
      deviation_(std::sqrt(variance(recipe, frequency, orientation))), seed_(seed) {}

double Reference::operator()(const Position& position) const {
    const double radius = recipe_.radius;
    const auto lowest = [&](double local) { return static_cast<std::int64_t>(std::floor(local - radius)); };
    const auto highest = [&](double local) { return static_cast<std::int64_t>(std::floor(local + radius)); };
    double sum = 0;
    for (std::int64_t j = lowest(position.local_y); j <= highest(position.local_y); ++j) {
        for (std::int64_t i = lowest(position.local_x); i <= highest(position.local_x); ++i) {
            for (int k = 0; k < recipe_.impulses; ++k) {
                const std::uint32_t word =
                    impulse_word(shifted(position.cell_x, i), shifted(position.cell_y, j), k, seed_);
                const double x = (word >> 8 & 0x7fffff) * 0x1p-23;
                const double y = (word & 0x7fffff) * 0x1p-23;
                const auto phases = static_cast<std::uint32_t>(recipe_.phases);
                const double phase = word % phases / static_cast<double>(phases);
                const double weight = word >> 31 ? 1 : recipe_.weight_floor;
                const double dx = (position.local_x - static_cast<double>(i) - x) / radius;
                const double dy = (position.local_y - static_cast<double>(j) - y) / radius;
                sum += weight * window(recipe_, dx) * window(recipe_, dy) *
                       std::sin(2 * std::numbers::pi * (wave_x_ * dx + wave_y_ * dy + phase));
            }
        }
    }
    return sum / deviation_;
}

} // namespace gabor::noise
