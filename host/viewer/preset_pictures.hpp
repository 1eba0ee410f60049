#pragma once

#include "render/load.hpp"
#include "viewer/background.hpp"
#include "viewer/extent.hpp"

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace gabor::viewer {

/// Small pictures of the presets that come with the program, drawn in the background on a logical device of
/// its own. Together they are one picture of cells, row by row, each with a preset in its middle.
class PresetPictures {
  public:
    static constexpr int side = 128; ///< of a small picture, in pixels
    static constexpr int cell = 144;
    static constexpr int columns = 7;

    /// `selector`: as for vulkan::Device.
    explicit PresetPictures(std::string selector) : selector_(std::move(selector)) {}

    /// Starts drawing on the first call.
    void begin();
    /// How many have been drawn, in the order of render::presets().
    std::size_t drawn() const { return drawn_; }
    /// Whether drawing has ended, or failed.
    bool done() const { return !colours_.empty() && !work_.running(); }
    static Extent extent();
    /// Red, green and blue of each pixel, from 0 to 1; 0 in cells that are not drawn yet.
    std::vector<float> colours() const;

  private:
    void work();

    std::string selector_;
    std::atomic<std::size_t> drawn_ = 0;
    mutable std::mutex mutex_; ///< of `colours_`
    std::vector<float> colours_;
    Background work_;
};

/// Shrinks a preset to `side` x `side` pixels: all of a material; of noise, as much as has at least four
/// pixels in each wave.
render::Request miniature(const render::Request& request, int side);

} // namespace gabor::viewer
