#pragma once

#include "render/load.hpp"
#include "viewer/extent.hpp"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gabor::viewer {

/// The presets that come with the program, as small pictures that are drawn in the background, on a thread
/// and a logical device of its own. All of them are one picture: cells row by row, each with one in its
/// middle.
class PresetPictures {
  public:
    static constexpr int side = 128; ///< of a small picture, in pixels
    static constexpr int cell = 144;
    static constexpr int columns = 5;

    /// `selector`: as for vulkan::Device.
    explicit PresetPictures(std::string selector) : selector_(std::move(selector)) {}
    ~PresetPictures();

    /// Begins to draw them, the first time.
    void begin();
    /// How many have been drawn, in the order of render::presets().
    std::size_t drawn() const { return drawn_; }
    /// Whether none is left to draw, or none can be.
    bool done() const { return done_; }
    static Extent extent();
    /// Red, green and blue of each pixel, from 0 to 1; those of cells that are still to be drawn are 0.
    std::vector<float> colours() const;

  private:
    void work();

    std::string selector_;
    std::thread thread_;
    std::atomic<bool> ending_ = false;
    std::atomic<bool> done_ = false;
    std::atomic<std::size_t> drawn_ = 0;
    mutable std::mutex mutex_; ///< of what follows
    std::vector<float> colours_;
};

/// As much of a preset as shows well in a picture of `side` x `side` pixels: a material whole, and of noise
/// as much as has at least four pixels to each wave.
render::Request miniature(const render::Request& request, int side);

} // namespace gabor::viewer
