#pragma once

#include "oracle.hpp"
#include "render/plan.hpp"
#include "vulkan/pass.hpp"

#include "passes/sample.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gabor::test {

/// Moves a sample, by cell and by position.
template <typename AnySample>
void move_to(AnySample& sample, float local_x, float local_y) {
    sample.place.local_x = local_x;
    sample.place.local_y = local_y;
    sample.x = local_x / sample.place.radius_x;
    sample.y = local_y / sample.place.radius_y;
}

/// The place that functions of a position evaluate, in cells, rounded to single precision as they do.
template <typename AnySample>
noise::Place here(const AnySample& sample, const noise::Recipe& recipe) {
    return noise::place_at(recipe, 0, 0, sample.x * recipe.radius, sample.y * recipe.radius);
}

/// Same layout as in passes/sample.comp.
struct Sample {
    noise::Place place;
    float frequency;
    float orientation;
    std::uint32_t seed;
    std::uint32_t index = 0;
    float period_x = 4;
    float period_y = 4;
    std::uint32_t padding = 0;
    float x = place.local_x / place.radius_x; ///< of the functions of a position, kernel radii
    float y = place.local_y / place.radius_y;
};

inline std::string to_string(const Sample& s) {
    return fmt::format("{}, frequency {}, orientation {}, seed {}, tiled with ({}, {})", to_string(s.place),
                       s.frequency, s.orientation, s.seed, s.period_x, s.period_y);
}

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
};

/// All answers, or a few of which millions are needed: same values as in passes/sample.comp, which has no
/// `four`, and in passes/sample_lattice.glsl.
enum class Wanted : std::int32_t { all, at, moving, four };

/// Evaluates the drop-in on the device through one of these passes, up to `capacity` samples at a time.
template <typename Sample, typename Answer>
class Probe {
  public:
    /// `constants`: the pass's specialization constants except the last, which selects the answers.
    Probe(const vulkan::Device& device, std::size_t capacity, std::span<const std::uint32_t> spirv,
          std::span<const std::uint32_t> constants)
        : device_(device), spirv_(spirv), constants_(constants.begin(), constants.end()),
          samples_(device, capacity * sizeof(Sample), vulkan::Memory::upload),
          answers_(device, capacity * sizeof(Answer), vulkan::Memory::readback) {}

    std::span<Sample> samples() { return samples_.as<Sample>(); }

    /// The answers to the first `count` samples, valid until the next call.
    std::span<const Answer> answers(std::size_t count, Wanted wanted = Wanted::all) {
        const Push push{static_cast<std::uint32_t>(count)};
        vulkan::Job& job = job_for(wanted);
        job.submit(push, {(push.count + 63) / 64});
        job.wait();
        return answers_.as<Answer>().first(count);
    }

  private:
    struct Push {
        std::uint32_t count;
    };
    struct Pipeline {
        vulkan::Pass pass;
        vulkan::Job job;
    };

    // One pipeline per selection, because CPU drivers evaluate both sides of a branch.
    vulkan::Job& job_for(Wanted wanted) {
        auto at = pipelines_.find(wanted);
        if (at == pipelines_.end()) {
            std::vector<std::uint32_t> constants = constants_;
            constants.push_back(vulkan::constant(wanted));
            vulkan::Pass pass(device_, spirv_, {2, sizeof(Push)}, constants);
            vulkan::Job job(device_, pass, {samples_, answers_});
            at = pipelines_.emplace(wanted, Pipeline{std::move(pass), std::move(job)}).first;
        }
        return at->second.job;
    }

    const vulkan::Device& device_;
    std::span<const std::uint32_t> spirv_;
    std::vector<std::uint32_t> constants_;
    vulkan::Buffer samples_;
    vulkan::Buffer answers_;
    std::map<Wanted, Pipeline> pipelines_;
};

struct Sampler : Probe<Sample, Answer> {
    Sampler(const vulkan::Device& device, const noise::Recipe& recipe, std::size_t capacity)
        : Probe(device, capacity, sample_spirv, render::recipe_constants(recipe)) {}
};

} // namespace gabor::test
