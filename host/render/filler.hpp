#pragma once

#include "image/exr.hpp"
#include "render/picture.hpp"
#include "vulkan/pass.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace gabor::render {

/// A compute pass that fills a region of a picture, band by band, with its tables on the device.
class Filler {
  public:
    virtual ~Filler() = default;

    /// Consecutive rows of the region that can be filled on their own.
    struct Band {
        int first_row;
        int rows;
        std::size_t first_run; ///< for the filler
        std::size_t runs;
    };

    /// The region cut into bands of at most `most_rows`, or the fewest rows that can be filled where that is
    /// more, from top to bottom.
    virtual std::vector<Band> bands(int most_rows) const = 0;

    /// A job that writes to `result`, which holds a band's pixels row by row, the channels of each side by
    /// side.
    virtual vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const = 0;

    /// Has `job` fill a band.
    virtual void submit(vulkan::Job& job, const Band& band,
                        const std::optional<vulkan::Job::Copy>& copy = {}) const = 0;
};

/// A table on the device.
template <typename T>
vulkan::Buffer upload(const vulkan::Device& device, const std::vector<T>& values) {
    vulkan::Buffer buffer(device, values.size() * sizeof(T), vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
    return buffer;
}

/// The fastest that can fill the picture. `picture` must have passed `check`, and `region` lie within it.
std::unique_ptr<Filler> make_filler(const vulkan::Device& device, const Picture& picture,
                                    const image::Window& region);

} // namespace gabor::render
