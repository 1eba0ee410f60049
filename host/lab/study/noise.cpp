#include "study/noise.hpp"

#include "recipe_modules.hpp"
#include "render/plan/plan.hpp"

#include "passes/drop_in.h"
#include "passes/drop_in_lattice_2.h"
#include "passes/drop_in_lattice_3.h"
#include "passes/drop_in_lattice_4.h"
#include "passes/ingredients.h"
#include "passes/places_interface.h"
#include "passes/points.h"
#include "passes/points_interface.h"
#include "passes/variants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gabor::study {

namespace {

constexpr std::size_t dispatch_size = std::size_t{1} << 20; // values per dispatch

constexpr RecipeModules drop_in_modules{
    drop_in_spirv, {drop_in_lattice_2_spirv, drop_in_lattice_3_spirv, drop_in_lattice_4_spirv}};

} // namespace

Noise::Noise(const vulkan::Device& device, const Ingredients& ingredients, const PlaneWave& wave,
             double variance)
    : Noise(device, ingredients_spirv, constants(ingredients), wave,
            std::sqrt(variance / study::variance(ingredients, wave)), 1) {}

Noise::Noise(const vulkan::Device& device, const Variant& variant, const PlaneWave& wave, double variance)
    : Noise(device, variants_spirv, constants(variant), wave, std::sqrt(variance / study::variance(variant)),
            variant.radius) {}

Noise::Noise(const vulkan::Device& device, const noise::Recipe& recipe, const PlaneWave& wave)
    : Noise(device, drop_in_modules.of(recipe), render::recipe_constants(recipe), wave, 1,
            double{recipe.radius}) {}

Noise::Noise(const vulkan::Device& device, std::span<const std::uint32_t> spirv,
             std::span<const std::uint32_t> constants, const PlaneWave& wave, double amplitude,
             double cells_per_radius)
    : wave_(wave), amplitude_(amplitude), cells_per_radius_(cells_per_radius),
      pass_(device, spirv, {1, sizeof(passes::PlacesPush)}, constants),
      values_(device, dispatch_size * sizeof(float),
              device.unified() ? vulkan::Memory::readback : vulkan::Memory::device),
      job_(device, pass_, {values_}) {
    if (!device.unified())
        staging_.emplace(device, dispatch_size * sizeof(float), vulkan::Memory::readback);
}

double Noise::fill(std::span<float> values, const Grid& grid, std::uint32_t first, std::uint32_t noise_seed,
                   std::uint32_t place_seed) {
    passes::PlacesPush push{};
    push.wave = {static_cast<float>(wave_.frequency * std::cos(wave_.orientation)),
                 static_cast<float>(wave_.frequency * std::sin(wave_.orientation))};
    push.amplitude = static_cast<float>(amplitude_);
    push.spacing =
        static_cast<float>(std::ldexp(grid.side * cells_per_radius_, -static_cast<int>(grid.bits)));
    push.corner = {static_cast<float>(grid.shift[0] * cells_per_radius_),
                   static_cast<float>(grid.shift[1] * cells_per_radius_)};
    push.within = grid.random ? 1 : 0;
    push.grid_bits = grid.bits;
    push.place_seed = place_seed;
    push.noise_seed = noise_seed;
    double seconds = 0;
    for (std::size_t done = 0; done < values.size(); done += dispatch_size) {
        const std::span<float> part = values.subspan(done, std::min(dispatch_size, values.size() - done));
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

PointSet point_set(const vulkan::Device& device, const Ingredients& ingredients, int side,
                   std::uint32_t seed) {
    // In practice, Poisson counts stay within twelve standard deviations.
    const double capacity = ingredients.impulses + 12 * std::sqrt(ingredients.impulses) + 12;
    const passes::PointsPush push{static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(capacity),
                                  seed};
    const std::size_t cells = std::size_t{push.side} * push.side;
    const vulkan::Pass pass(device, points_spirv, {2, sizeof(push)}, constants(ingredients));
    const vulkan::Buffer counts(device, cells * sizeof(std::int32_t), vulkan::Memory::readback);
    const vulkan::Buffer places(device, cells * push.capacity * sizeof(Point), vulkan::Memory::readback);
    vulkan::Job job(device, pass, {counts, places});
    const std::uint32_t groups = (push.side + passes::points_group - 1) / passes::points_group;
    job.submit(push, {groups, groups});
    job.wait();

    PointSet set;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const auto count = static_cast<std::size_t>(counts.as<std::int32_t>()[cell]);
        if (count > push.capacity)
            throw std::runtime_error("a cell has too many impulses for a Poisson count");
        const auto first = places.as<Point>().subspan(cell * push.capacity, count);
        set.emplace_back(first.begin(), first.end());
    }
    return set;
}

} // namespace gabor::study
