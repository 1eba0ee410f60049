#pragma once

#include "render/plan.hpp"
#include "vulkan/pass.hpp"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace gabor::render {

/// The pipeline of a plan's step. `statistics`: as in vulkan::Pass::Interface.
vulkan::Pass make_pass(const vulkan::Device& device, const Plan& plan, const Step& step,
                       bool statistics = false);

/// Carries out plans on a device, one after the other. Keeps pipelines, and tables as long as they are large
/// enough.
class Renderer {
  public:
    explicit Renderer(const vulkan::Device& device, Plan plan = {});

    /// Another plan. Jobs of the one before must not be submitted again.
    void set(Plan plan);
    const Plan& plan() const { return plan_; }
    const vulkan::Device& device() const { return device_; }

    /// A job that writes to `values`, which holds the values of a band, or of as many as are to be filled.
    vulkan::Job job(const vulkan::Buffer& values) const;

    /// Has `job` fill a band. `before`: values in its buffer before those of the band.
    void submit(vulkan::Job& job, const Band& band, int before = 0,
                const std::optional<vulkan::Job::Copy>& copy = {}) const;

  private:
    const vulkan::Device& device_;
    Plan plan_;
    std::map<std::pair<std::string, Constants>, vulkan::Pass> passes_;
    std::vector<const vulkan::Pass*> of_steps_;
    std::vector<vulkan::Buffer> tables_;
};

/// Work groups of a side of `group` that cover so many invocations.
constexpr std::uint32_t groups(int invocations, std::uint32_t group) {
    return (static_cast<std::uint32_t>(invocations) + group - 1) / group;
}

/// Where the values of a band are written: the device's memory, or that of the host where it is the same.
vulkan::Memory values_memory(const vulkan::Device& device);

/// `cpu` or `gpu`.
DeviceKind kind_of(const vulkan::Device& device);

/// A table on the device.
template <typename T>
vulkan::Buffer upload(const vulkan::Device& device, const std::vector<T>& values) {
    vulkan::Buffer buffer(device, values.size() * sizeof(T), vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
    return buffer;
}

struct Times {
    double first_dispatch = 0; ///< seconds from the call to the first submission
    double waiting = 0;        ///< seconds that the host waited for the device
    double gpu = 0;            ///< seconds that the passes took on the device, NaN where it cannot tell
};

/// Renders `region` of a checked request from top to bottom and hands whole rows to `sink`, band by band:
/// while one band is taken the next is on the device. Memory does not grow with the height. What `sink`
/// throws ends it.
Times render_region(const vulkan::Device& device, const Request& request, const image::Rect& region,
                    const std::function<void(std::span<const float>)>& sink);

/// The same of a renderer's plan.
Times render_plan(const vulkan::Device& device, const Renderer& renderer,
                  const std::function<void(std::span<const float>)>& sink);

} // namespace gabor::render
