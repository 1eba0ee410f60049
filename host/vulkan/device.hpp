#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

struct VkInstance_T;
struct VkPhysicalDevice_T;

namespace gabor::vulkan {

struct DeviceInfo {
    std::uint32_t index = 0; ///< number that Device accepts as its selector
    std::string name;
    std::string kind;                 ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;               ///< name and version
    std::string api;                  ///< highest Vulkan version, as in "1.3.230"
    std::uint64_t memory = 0;         ///< largest device-local heap, in bytes
    std::uint64_t storage_buffer = 0; ///< largest storage buffer that a shader can address, in bytes
    std::uint32_t group_invocations = 0; ///< invocations in the largest workgroup
    std::uint32_t subgroup = 0;          ///< lanes that run in lockstep
    bool timestamps = false;             ///< whether GPU time can be measured
};

/// What to do if the Vulkan loader finds no driver. Environment variables can hide those that are installed.
std::string how_to_get_a_driver();

/// Lists the Vulkan 1.1 devices with a compute queue. Throws RequestError if there is no device or no Vulkan
/// loader.
std::vector<DeviceInfo> devices();

/// Returns the number of messages from the validation layers so far. The environment variable
/// GABOR_VALIDATION loads the layers unless it is empty or 0: core checks, synchronization and best practices
/// or, if it is `gpu`, core checks and GPU-assisted ones. Each message also goes to stderr.
int validation_messages();

/// Whether a call of Vulkan failed because memory ran out.
bool out_of_memory(const std::error_code& code);

/// Requirements for showing pictures in windows; none by default.
struct Presentation {
    std::vector<const char*> instance_extensions;
    /// If set, tells whether a queue family of a device can present. A device must then support swapchains
    /// and have a family that can both present and draw.
    std::function<bool(VkInstance_T*, VkPhysicalDevice_T*, std::uint32_t family)> can_present;
};

/// A logical device with one compute queue.
class Device {
  public:
    /// `selector` is an index or part of the name, ignoring case; empty selects the best device (discrete
    /// GPU, then integrated, virtual, CPU). Throws RequestError if `selector` matches no device or several.
    explicit Device(const std::string& selector = {}, const Presentation& presentation = {});
    ~Device();
    Device(Device&&) noexcept;

    const DeviceInfo& info() const;
    /// Tells whether host and device share memory, so that results need no copy.
    bool unified() const;

    struct State;
    State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

} // namespace gabor::vulkan
