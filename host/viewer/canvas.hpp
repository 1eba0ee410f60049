#pragma once

#include "render/output/renderer.hpp"
#include "viewer/drawing.hpp"

#include <array>
#include <optional>
#include <span>

namespace gabor::viewer {

/// A grid of values on the device, filled at once or row by row.
class ValueGrid {
  public:
    explicit ValueGrid(const vulkan::Device& device);

    /// Starts over. `renderer` must keep its plan until the grid is filled.
    void start(const render::Renderer& renderer);
    /// Fills up to `rows` more rows, and adds their time to `cost`, a running average of the seconds per
    /// value.
    void fill(const render::Renderer& renderer, int rows, double& cost);

    bool filling() const { return next_row_ >= 0; }
    Extent extent() const { return extent_; }
    const vulkan::Buffer& values() const { return values_; }
    /// The values on the host, once the grid is filled.
    std::span<const float> read();

  private:
    const vulkan::Device& device_;
    Extent extent_;
    std::size_t count_ = 0;
    vulkan::Buffer values_;
    std::optional<vulkan::Buffer> staging_; ///< used if the host cannot read the device's memory
    std::optional<vulkan::Job> job_;
    int next_row_ = -1; ///< -1: all are filled
};

/// Draws values for the view's pixels: coarsely while the view moves, then more finely in short slices that
/// keep the window responsive.
class Canvas {
  public:
    explicit Canvas(const vulkan::Device& device);

    /// Works for about `seconds` on the part of the drawing that the camera shows in `extent` pixels. Returns
    /// whether any work is left. A new view is drawn at once, as finely as the time allows. Throws
    /// RequestError if the drawing's paint cannot be read.
    bool refine(const Drawing& drawing, const Camera& camera, Extent extent, double seconds);

    /// Draws the whole view at once, with one value per `stride` x `stride` pixels.
    void draw(const Drawing& drawing, const Camera& camera, Extent extent, int stride);

    const vulkan::Buffer& values() const { return grids_[front_].values(); }
    const std::vector<std::string>& channels() const { return channels_; } ///< channels of each value
    Extent grid() const { return grids_[front_].extent(); }
    int stride() const { return stride_; } ///< pixels per value; 0 if nothing has been drawn yet
    bool fine() const { return stride_ == 1; }
    /// The values on the host; valid until the next `refine` or `draw`.
    std::span<const float> pixels() { return grids_[front_].read(); }

  private:
    void load_paint(const std::string& path);
    void start(ValueGrid& grid, int stride);

    Drawing drawing_;
    Camera camera_;
    Extent extent_;
    std::string paint_path_;
    render::Paint paint_;
    render::Renderer renderer_;
    std::array<ValueGrid, 2> grids_; ///< the grid shown, and a finer one that is being filled
    std::vector<std::string> channels_;
    std::size_t front_ = 0;
    int stride_ = 0;     ///< stride of the grid shown
    double cost_ = 1e-6; ///< seconds per value; the first frames correct this guess
};

} // namespace gabor::viewer
