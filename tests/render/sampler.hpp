#pragma once

#include "noise/recipe.hpp"
#include "noise/reference.hpp"
#include "render/bake.hpp"
#include "vulkan/pass.hpp"

#include "passes/sample.h"

#include <cstdint>
#include <span>

namespace gabor::test {

/// As in passes/sample.comp.
struct Sample {
    noise::Place place;
    float frequency;
    float orientation;
    std::uint32_t seed;
    std::uint32_t index = 0;
    float period_x = 4;
    float period_y = 4;
    std::uint32_t padding = 0;
};

struct Answer {
    float value[2];
    float slope_x[2];
    float slope_y[2];
    float complex[2];
    float gradient[3];
    float noise;
    float tiled;
    float animated;
    float unorm;
    float at;
    float phasor[2];
    std::uint32_t word;
    std::uint32_t padding;
    float four[4];
};

/// Asks the drop-in on the device, up to `capacity` samples at a time.
class Sampler {
  public:
    Sampler(const vulkan::Device& device, const noise::Recipe& recipe, std::size_t capacity)
        : pass_(device, sample_spirv, {2, sizeof(std::uint32_t)}, render::recipe_constants(recipe)),
          samples_(device, capacity * sizeof(Sample), vulkan::Memory::upload),
          answers_(device, capacity * sizeof(Answer), vulkan::Memory::readback),
          job_(device, pass_, {samples_, answers_}) {}

    std::span<Sample> samples() { return samples_.as<Sample>(); }

    /// The answers to the first `count` samples, valid until the next call.
    std::span<const Answer> answers(std::size_t count) {
        const auto wanted = static_cast<std::uint32_t>(count);
        job_.submit(wanted, {(wanted + 63) / 64});
        job_.wait();
        return answers_.as<Answer>().first(count);
    }

  private:
    vulkan::Pass pass_;
    vulkan::Buffer samples_;
    vulkan::Buffer answers_;
    vulkan::Job job_;
};

} // namespace gabor::test
