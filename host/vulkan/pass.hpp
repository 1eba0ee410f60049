#pragma once

#include "vulkan/buffer.hpp"

#include <bit>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace gabor::vulkan {

/// The 32 bits of a specialization constant of type int, uint or float.
template <typename T>
constexpr std::uint32_t constant(T value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// A compute pipeline: storage buffers at set 0, bindings 0 to `buffers` - 1, and one block of push
/// constants.
class Pass {
  public:
    struct Interface {
        std::uint32_t buffers = 1;
        std::uint32_t push_bytes = 0;
        bool statistics = false; ///< whether to allow calls to `statistics`
        bool uniform = false;    ///< whether the last buffer is a uniform buffer instead
        bool optimized = false;  ///< whether to optimize the SPIR-V as spirv-opt -O does
    };

    /// `constants` are the specialization constants with ids 0, 1, 2, ...
    Pass(const Device& device, std::span<const std::uint32_t> spirv, Interface interface,
         std::span<const std::uint32_t> constants = {});
    ~Pass();
    Pass(Pass&&) noexcept;
    Pass& operator=(Pass&&) noexcept;

    /// Returns the compiler's statistics of the code under the names that the driver gives them, such as
    /// "Instructions". Throws RequestError on a device without VK_KHR_pipeline_executable_properties.
    std::map<std::string, std::uint64_t> statistics(const Device& device) const;

    /// Returns the CPU seconds that the driver took to compile the code.
    double seconds() const;

    struct State;
    State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

/// Workgroups along each axis.
struct Groups {
    std::uint32_t x = 1;
    std::uint32_t y = 1;
    std::uint32_t z = 1;
};

/// A pass with its buffers. You can submit it any number of times, one submission at a time.
class Job {
  public:
    using Buffers = std::vector<std::reference_wrapper<const Buffer>>;

    Job(const Device& device, const Pass& pass, const Buffers& buffers);
    ~Job();
    Job(Job&&) noexcept;

    /// A copy after the pass, from the start of one buffer to the start of another.
    struct Copy {
        const Buffer& from;
        const Buffer& to;
        std::size_t bytes;
    };

    /// A dispatch of the pass, or of another pass with the same interface, with these push constants.
    struct Dispatch {
        std::span<const std::byte> push;
        Groups groups;
        const Pass* other = nullptr;
    };

    /// Submits the dispatches. Each one sees the results of earlier ones.
    void submit(std::span<const Dispatch> dispatches, const std::optional<Copy>& copy = {});

    template <typename Push>
    void submit(const Push& push, Groups groups, const std::optional<Copy>& copy = {}) {
        const Dispatch dispatch{std::as_bytes(std::span(&push, 1)), groups};
        submit(std::span(&dispatch, 1), copy);
    }

    /// Waits for the submission and makes its results visible to the host. Returns the seconds that the pass
    /// took on the device; NaN if the device cannot measure them.
    double wait();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace gabor::vulkan
