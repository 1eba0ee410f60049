#pragma once

#include "image/exr.hpp"
#include "render/request.hpp"
#include "vulkan/pass.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gabor::render {

/// The cells along a side of a picture: the recipe's, or as many whole ones as fit a tileable picture.
struct Axis {
    double radius;       ///< cells per kernel radius
    std::int32_t period; ///< in cells, 0 for none
};

/// `side`: width or height of the request. `radius`: of the kernels, as noise::Wave has it.
Axis axis_along(const Request& request, int side, double radius = 1);

/// The time within its period, in [0, 1), as the passes take it.
float wrapped_time(const Request& request);

/// A compute pass that fills a region of a picture, band by band, with its tables on the device.
class RegionRenderer {
  public:
    virtual ~RegionRenderer() = default;

    /// Consecutive rows of the region that can be filled on their own.
    struct Band {
        int first_row;
        int rows;
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

  protected:
    /// Bands of any rows.
    static std::vector<Band> bands_of_rows(int height, int most_rows);
};

/// Work groups of a side of `group` that cover so many invocations.
constexpr std::uint32_t groups(int invocations, std::uint32_t group) {
    return (static_cast<std::uint32_t>(invocations) + group - 1) / group;
}

/// Submits a band of a pass whose groups are squares of `group` pixels. `push`: that of the whole region.
template <typename Push>
void submit_band(vulkan::Job& job, Push push, const RegionRenderer::Band& band, std::uint32_t group,
                 const std::optional<vulkan::Job::Copy>& copy) {
    push.first_row += band.first_row;
    push.height = band.rows;
    job.submit(push, {groups(push.width, group), groups(push.height, group)}, copy);
}

/// A table on the device.
template <typename T>
vulkan::Buffer upload(const vulkan::Device& device, const std::vector<T>& values) {
    vulkan::Buffer buffer(device, values.size() * sizeof(T), vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
    return buffer;
}

/// SPIR-V of a pass.
using Code = std::span<const std::uint32_t>;

/// `code`, or what was built in where that is empty.
inline Code code_or(Code code, Code built_in) {
    return code.empty() ? built_in : code;
}

/// The pass that draws the request: a file of the folder shaders, with the GABOR_TAPS that it is compiled
/// with, as "passes/bake.comp@3", or its material.
std::string pass_of(const Request& request);

/// The fastest one for the request, which must have passed `check`; `region` must lie within the picture.
/// `code`: of `pass_of(request)`, in place of what was built in.
std::unique_ptr<RegionRenderer> make_renderer(const vulkan::Device& device, const Request& request,
                                              const image::Window& region, Code code = {});

struct Times {
    double first_dispatch = 0; ///< seconds from the call to the first submission
    double waiting = 0;        ///< seconds that the host waited for the device
    double gpu = 0;            ///< seconds that the passes took on the device, NaN where it cannot tell
};

/// Renders `region` of a checked request from top to bottom and hands whole rows to `sink`, band by band:
/// while one band is taken the next is on the device. Memory does not grow with the height. What `sink`
/// throws ends it.
Times render_region(const vulkan::Device& device, const Request& request, const image::Window& region,
                    const std::function<void(std::span<const float>)>& sink, Code code = {});

/// The same by a renderer of one's own choice.
Times render_region(const vulkan::Device& device, const RegionRenderer& renderer, const Request& request,
                    const image::Window& region, const std::function<void(std::span<const float>)>& sink);

} // namespace gabor::render
