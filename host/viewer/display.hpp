#pragma once

#include "viewer/document.hpp"
#include "vulkan/pass.hpp"

#include "viewer/display_interface.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gabor::viewer {

/// The specialization constants of shaders/viewer/display.glsl.
using DisplayConstants = std::array<std::int32_t, passes::display_constant_count>;

/// `channels` are those of the values, as in render::channels. If the output's channels are missing, the
/// value is shown. `coarse`: values are further apart than pixels. `tiles`: repeat the values two by two.
/// `unlit`: show the normals instead of the lit surface.
DisplayConstants display_constants(const Document& document, std::span<const std::string> channels,
                                   bool coarse, bool tiles = false, bool unlit = false);

/// Constants that show red, green and blue unchanged.
DisplayConstants colours_constants();

/// Returns the stops of the document's colour map, the last one repeated: red, green, blue and position,
/// rounded to 8 bits.
std::array<std::array<float, 4>, most_stops> stops_of(const Document& document);

/// The push constants that depend on the document. `stride` is in pixels of the view per value, `zoom` in
/// pixels of the view per pixel of the picture.
passes::DisplayPush display_push(const Document& document, double stride, double zoom);

/// The standard deviation of a derivative per kernel radius, averaged over directions.
double slope_deviation(const render::Request& request);

/// The turns by which the phase of the stripes advances per pixel of the picture.
double stripe_turns(const render::Request& request);

/// Whether a PNG written by `gabor render` looks like the window.
bool shows_plainly(const Document& document);

/// Describes a pixel by its position and channels. `from_middle` is in pixels from the middle of the view.
std::string reading(const Document& document, std::array<double, 2> from_middle,
                    std::span<const std::string> channels, std::span<const float> values);

/// Colours the pixels of a file as the window does, with shaders/viewer/display.comp.
class FileColours {
  public:
    /// `channels` are those of the file's pixels. `unlit` is as for display_constants.
    FileColours(const vulkan::Device& device, const Document& document, std::span<const std::string> channels,
                bool unlit = false);

    /// Returns red, green and blue of each pixel of the next rows, from 0 to 1; valid until the next call.
    std::span<const float> of(std::span<const float> values);

  private:
    const vulkan::Device& device_;
    vulkan::Pass pass_;
    passes::DisplayPush push_;
    std::size_t channels_;
    std::vector<float> last_row_; ///< last row of the previous band
    vulkan::Buffer values_;
    vulkan::Buffer colours_;
};

} // namespace gabor::viewer
