#pragma once

#include "vulkan/device.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace gabor::vulkan {

enum class Memory {
    device,   ///< fastest for shaders, not mapped
    upload,   ///< written by the host, read by shaders
    readback, ///< written by shaders or copies, read by the host
};

/// A storage buffer. Mapped memory is coherent.
class Buffer {
  public:
    Buffer(const Device& device, std::size_t bytes, Memory memory);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;

    std::size_t size() const;

    /// The mapped contents; empty for Memory::device.
    template <typename T>
    std::span<T> as() const {
        const std::span<std::byte> bytes = mapped();
        return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
    }

    struct State;
    State& state() const { return *state_; }

  private:
    std::span<std::byte> mapped() const;
    std::unique_ptr<State> state_;
};

} // namespace gabor::vulkan
