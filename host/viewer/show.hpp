#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"
#include "vulkan/pass.hpp"

#include "viewer/show_interface.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gabor::viewer {

/// The specialization constants of shaders/viewer/show.glsl.
using ShowConstants = std::array<std::int32_t, 11>;

/// `channels`: of the values, as in render::channels. If the output's channels are missing, the value is
/// shown. `coarse`: values are further apart than pixels. `tiles`: repeat the values two by two. `unlit`:
/// show the normals of what is lit.
ShowConstants show_constants(const Document& document, std::span<const std::string> channels, bool coarse,
                             bool tiles = false, bool unlit = false);

/// Constants that show red, green and blue unchanged.
ShowConstants colours_constants();

/// Push constants that the document decides. `stride`: pixels of the view per value. `zoom`: pixels of the
/// view per pixel of the picture.
passes::ShowPush show_push(const Document& document, double stride, double zoom);

/// The standard deviation of a derivative per kernel radius, averaged over directions.
double slope_deviation(const render::Request& request);

/// Turns of the stripes' phase per pixel of the picture.
double stripe_turns(const render::Request& request);

/// Whether a PNG of `gabor render` looks the same.
bool shows_plainly(const Document& document);

/// Describes a pixel in words: its place, in pixels from the middle of the view, and its channels.
std::string reading(const Document& document, std::array<double, 2> from_middle,
                    std::span<const std::string> channels, std::span<const float> values);

/// Colours the pixels of a file as the window does: shaders/viewer/show.comp.
class FileColours {
  public:
    /// `channels`: of the file's pixels. `unlit`: as above. Throws RequestError for outputs that only the
    /// window can show.
    FileColours(const vulkan::Device& device, const Document& document, std::span<const std::string> channels,
                bool unlit = false);

    /// Returns red, green and blue of each pixel of the next rows, from 0 to 1; valid until the next call.
    std::span<const float> of(std::span<const float> values);

  private:
    const vulkan::Device& device_;
    vulkan::Pass pass_;
    passes::ShowPush push_;
    std::size_t channels_;
    std::vector<float> last_row_; ///< of the band before
    vulkan::Buffer values_;
    vulkan::Buffer colours_;
};

} // namespace gabor::viewer
