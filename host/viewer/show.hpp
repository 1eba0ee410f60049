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
using ShowConstants = std::array<std::int32_t, 8>;

/// `channels`: of the values, as render::channels names them, or red, green and blue. Where the output's own
/// are not among them it is the value that is shown. `coarse`: whether the values are further apart than the
/// pixels. `tiles`: whether they are repeated, two by two.
ShowConstants show_constants(const Document& document, std::span<const std::string> channels, bool coarse,
                             bool tiles = false);

/// Those that show red, green and blue as they are.
ShowConstants colours_constants();

/// What the document decides of the push constants. `stride`: pixels of the picture per value.
passes::ShowPush show_push(const Document& document, double stride);

/// The standard deviation of a derivative, on average over the directions, per kernel radius.
double slope_deviation(const render::Request& request);

/// Whether a PNG of `gabor render` shows the same: the noise in grey, the colours of a photograph, a lit
/// material.
bool shows_plainly(const Document& document);

/// Shows the pixels of files, one after the other, as the window would: shaders/viewer/show.comp.
class FileColours {
  public:
    /// `channels`: of the file's pixels. Throws RequestError where the window alone can show it.
    FileColours(const vulkan::Device& device, const Document& document,
                std::span<const std::string> channels);

    /// Red, green and blue of each pixel of the next rows, from 0 to 1; valid until the next call.
    std::span<const float> of(std::span<const float> values);

  private:
    const vulkan::Device& device_;
    vulkan::Pass pass_;
    passes::ShowPush push_;
    std::size_t channels_;
    vulkan::Buffer values_;
    vulkan::Buffer colours_;
};

} // namespace gabor::viewer
