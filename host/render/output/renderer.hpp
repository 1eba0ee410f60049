#pragma once

#include "render/plan/plan.hpp"
#include "vulkan/pass.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace gabor::render {

/// Builds the pipeline of a step. `statistics` is as in vulkan::Pass::Interface.
vulkan::Pass make_pass(const vulkan::Device& device, const Plan& plan, const Step& step,
                       bool statistics = false);

/// Executes plans on a device, one after the other. Reuses pipelines, and tables that are large enough.
class Renderer {
  public:
    explicit Renderer(const vulkan::Device& device, Plan plan = {});

    /// Sets the plan. Jobs of the previous plan must not be submitted again.
    void set(Plan plan);
    const Plan& plan() const { return plan_; }
    const vulkan::Device& device() const { return device_; }

    /// Returns a job that fills bands in `values` and reads the plan's `source`.
    vulkan::Job job(const vulkan::Buffer& values, const vulkan::Buffer* source = nullptr) const;

    /// Submits a job that fills a band. `before` is the number of values in its buffer before the band.
    void submit(vulkan::Job& job, const Band& band, int before = 0,
                const std::optional<vulkan::Job::Copy>& copy = {}) const;

  private:
    const vulkan::Device& device_;
    Plan plan_;
    std::map<std::pair<std::string, Constants>, vulkan::Pass> passes_;
    std::vector<const vulkan::Pass*> of_steps_;
    std::vector<vulkan::Buffer> tables_;
};

/// The number of work groups of `group` invocations that cover `invocations`.
constexpr std::uint32_t groups(int invocations, std::uint32_t group) {
    return (static_cast<std::uint32_t>(invocations) + group - 1) / group;
}

/// The memory for values: the device's, or the host's if they share memory.
vulkan::Memory values_memory(const vulkan::Device& device);

/// Tells whether a device is a CPU or a GPU.
DeviceKind kind_of(const vulkan::Device& device);

/// Copies values to a buffer on the device.
template <typename T>
vulkan::Buffer upload(const vulkan::Device& device, const std::vector<T>& values) {
    vulkan::Buffer buffer(device, values.size() * sizeof(T), vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
    return buffer;
}

/// Receives whole rows of pixels, from top to bottom. It may throw.
using Sink = std::function<void(std::span<const float>)>;
/// Provides the next band's rows of a plan's source, including the halo.
using Fill = std::function<void(std::span<float>)>;

/// Renders `region` of a checked request and passes its rows to `sink`, band by band, while the device draws
/// the next band. Memory use does not grow with the height. `normals` is as in Viewport.
void render_region(const vulkan::Device& device, const Request& request, const image::Rect& region,
                   const Sink& sink, bool normals = false);

/// Executes a renderer's plan in the same way. `fill` provides the rows of its source.
void render_plan(const vulkan::Device& device, const Renderer& renderer, const Sink& sink,
                 const Fill& fill = {});

} // namespace gabor::render
