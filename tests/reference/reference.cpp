#include "reference/reference.hpp"

#include "noise/variance.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace gabor::noise {

namespace {

constexpr std::uint32_t spread_impulses = 0x85ebca6bu;

// The window's value and derivative at x.
struct Window {
    double value;
    double slope;
};

// |x| must be at most 1.
Window window(const Recipe& recipe, double x) {
    const double u = 1 - x * x;
    double power = u;
    Window q{0, 0};
    for (int n = 2; n <= 4; ++n) { // c u^n, and its derivative with respect to u times du/dx = -2 x
        const double c = recipe.window[static_cast<std::size_t>(n - 2)];
        q.slope += c * n * power * (-2 * x);
        power *= u;
        q.value += c * power;
    }
    return q;
}

} // namespace

Place<2> place_at(const Recipe& recipe, std::int32_t cell_x, std::int32_t cell_y, double local_x,
                  double local_y) {
    return {{cell_x, cell_y}, {local_x, local_y}, {recipe.radius, recipe.radius}};
}

std::uint32_t impulse_word(std::int32_t cell_x, std::int32_t cell_y, int index, std::uint32_t seed) {
    const std::uint32_t seed_word = mix(seed * spread, 0x2545f491u);
    const std::uint32_t row_word = mix(static_cast<std::uint32_t>(cell_y) * spread + seed_word, seed_word);
    const std::uint32_t salt = row_word + static_cast<std::uint32_t>(index) * spread_impulses;
    return mix(static_cast<std::uint32_t>(cell_x) * spread + salt, salt);
}

Reference::Reference(const Recipe& recipe, double frequency, double orientation, std::uint32_t seed)
    : recipe_(recipe), frequency_(frequency), orientation_(orientation),
      deviation_(std::sqrt(variance(recipe, frequency, orientation))), seed_(seed) {}

Field<2> Reference::field(const Place<2>& place) const {
    using namespace std::complex_literals;
    constexpr double pi = std::numbers::pi;
    const double radius_x = place.radius[0];
    const double radius_y = place.radius[1];
    const double wave_x = frequency_ * std::cos(orientation_);
    const double wave_y = frequency_ * std::sin(orientation_);
    const auto lowest = [](double local, double radius) {
        return static_cast<std::int64_t>(std::floor(local - radius));
    };
    const auto highest = [](double local, double radius) {
        return static_cast<std::int64_t>(std::floor(local + radius));
    };
    Field<2> sum;
    for (std::int64_t j = lowest(place.local[1], radius_y); j <= highest(place.local[1], radius_y); ++j) {
        for (std::int64_t i = lowest(place.local[0], radius_x); i <= highest(place.local[0], radius_x); ++i) {
            for (int k = 0; k < recipe_.impulses; ++k) {
                const std::uint32_t word =
                    impulse_word(wrapped(wrapped(place.cell[0] + i, 0), place.period[0]),
                                 wrapped(wrapped(place.cell[1] + j, 0), place.period[1]), k, seed_);
                const double x = (word >> 8 & 0x7fffff) * 0x1p-23;
                const double y = (word & 0x7fffff) * 0x1p-23;
                const auto phases = static_cast<std::uint32_t>(recipe_.phases);
                const int tempo = static_cast<int>(word >> 8 & 7) - 4;
                const double phase = word % phases / static_cast<double>(phases) +
                                     (tempo < 0 ? tempo : tempo + 1) * place.time;
                const double weight = word >> 31 ? 1 : recipe_.weight_floor;
                const double dx = (place.local[0] - static_cast<double>(i) - x) / radius_x;
                const double dy = (place.local[1] - static_cast<double>(j) - y) / radius_y;
                if (std::abs(dx) >= 1 || std::abs(dy) >= 1)
                    continue;
                const auto wave = weight * std::exp(2i * pi * (wave_x * dx + wave_y * dy + phase));
                const Window qx = window(recipe_, dx);
                const Window qy = window(recipe_, dy);
                sum.value += qx.value * qy.value * wave;
                sum.slope[0] += (qx.slope * qy.value + 2i * pi * wave_x * qx.value * qy.value) * wave;
                sum.slope[1] += (qx.value * qy.slope + 2i * pi * wave_y * qx.value * qy.value) * wave;
            }
        }
    }
    if (std::exchange(time_, place.time) != place.time)
        deviation_ = std::sqrt(variance(recipe_, frequency_, orientation_, time_));
    // The variance is proportional to the number of impulses per unit area.
    const double scale = recipe_.radius / (deviation_ * std::sqrt(radius_x * radius_y));
    Field<2> scaled;
    scaled.add(scale, sum);
    return scaled;
}

} // namespace gabor::noise
