#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct VkInstance_T;
struct VkPhysicalDevice_T;

namespace gabor::vulkan {

struct DeviceInfo {
    std::uint32_t index = 0; ///< as accepted by Device
    std::string name;
    std::string kind;                 ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;               ///< name and version
    std::string api;                  ///< highest Vulkan version, "1.3.230"
    std::uint64_t memory = 0;         ///< largest device-local heap, bytes
    std::uint64_t storage_buffer = 0; ///< largest storage buffer that a shader can address, bytes
    std::uint32_t group_invocations = 0; ///< largest workgroup
    std::uint32_t subgroup = 0;          ///< lanes that run in step
    bool timestamps = false;             ///< whether GPU time can be measured
};

/// Every Vulkan 1.1 device with a compute queue. Throws RequestError when there is none, or no Vulkan loader.
std::vector<DeviceInfo> devices();

/// Messages of the validation layers so far. The layers are loaded when the environment variable
/// GABOR_VALIDATION is set and not 0: core checks, synchronization and best practices, or, where it is `gpu`,
/// core checks and those that run within the shaders. Each message also goes to stderr.
int validation_messages();

/// What a device takes to show pictures in windows; the defaults ask for nothing.
struct Presentation {
    std::vector<const char*> instance_extensions;
    /// Whether a queue family of a device can present. Where set, devices are those that can, with a
    /// swapchain, from a family that also draws.
    std::function<bool(VkInstance_T*, VkPhysicalDevice_T*, std::uint32_t family)> can_present;
};

/// A logical device with one compute queue.
class Device {
  public:
    /// `selector`: an index, or a part of the name in any case; empty for the best one (a discrete GPU, then
    /// integrated, virtual, CPU). Throws RequestError when it matches none or several, or there is no device.
    explicit Device(std::string_view selector = {}, const Presentation& presentation = {});
    ~Device();
    Device(Device&&) noexcept;

    const DeviceInfo& info() const;
    /// Whether the host's memory is the device's own, so that results need no copy to be read.
    bool unified() const;

    struct State;
    State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

} // namespace gabor::vulkan
