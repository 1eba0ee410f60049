#include "study/noise.hpp"

#include "passes/ingredients.h"
#include "passes/places_interface.h"
#include "passes/recipes.h"

#include <algorithm>
#include <cmath>

namespace gabor::study {

namespace {

constexpr std::size_t batch = std::size_t{1} << 20; // values

} // namespace

Noise::Noise(const vulkan::Device& device, const Ingredients& ingredients, const Wave& wave, double variance)
    : Noise(device, ingredients_spirv, constants(ingredients), wave,
            std::sqrt(variance / study::variance(ingredients, wave)), 1) {}

Noise::Noise(const vulkan::Device& device, const Variant& variant, const Wave& wave, double variance)
    : Noise(device, recipes_spirv, constants(variant), wave, std::sqrt(variance / study::variance(variant)),
            variant.radius) {}

Noise::Noise(const vulkan::Device& device, std::span<const std::uint32_t> spirv,
             std::span<const std::uint32_t> constants, const Wave& wave, double amplitude,
             double cells_per_radius)
    : wave_(wave), amplitude_(amplitude), cells_per_radius_(cells_per_radius),
      pass_(device, spirv, {1, sizeof(passes::PlacesPush)}, constants),
      values_(device, batch * sizeof(float),
              device.unified() ? vulkan::Memory::readback : vulkan::Memory::device),
      job_(device, pass_, {values_}) {
    if (!device.unified())
        staging_.emplace(device, batch * sizeof(float), vulkan::Memory::readback);
}

double Noise::fill(std::span<float> values, const Grid& grid, std::uint32_t first, std::uint32_t noise_seed,
                   std::uint32_t place_seed) {
    passes::PlacesPush push{};
    push.wave = {static_cast<float>(wave_.frequency * std::cos(wave_.orientation)),
                 static_cast<float>(wave_.frequency * std::sin(wave_.orientation))};
    push.amplitude = static_cast<float>(amplitude_);
    push.spacing =
        static_cast<float>(std::ldexp(grid.side * cells_per_radius_, -static_cast<int>(grid.bits)));
    push.origin = grid.random ? 1 : 0;
    push.grid_bits = grid.bits;
    push.place_seed = place_seed;
    push.noise_seed = noise_seed;
    double seconds = 0;
    for (std::size_t done = 0; done < values.size(); done += batch) {
        const std::span<float> part = values.subspan(done, std::min(batch, values.size() - done));
        push.first = first + static_cast<std::uint32_t>(done >> 2 * grid.bits);
        push.count = static_cast<std::uint32_t>(part.size());
        std::optional<vulkan::Job::Copy> copy;
        if (staging_)
            copy.emplace(vulkan::Job::Copy{values_, *staging_, part.size_bytes()});
        job_.submit(push, {(push.count + passes::places_group - 1) / passes::places_group}, copy);
        seconds += job_.wait();
        std::ranges::copy((staging_ ? *staging_ : values_).as<float>().first(part.size()), part.begin());
    }
    return seconds;
}

} // namespace gabor::study
