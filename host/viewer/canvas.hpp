#pragma once

#include "render/renderer.hpp"
#include "viewer/drawing.hpp"

#include <array>
#include <optional>
#include <span>

namespace gabor::viewer {

/// Seconds per value, as measured while grids are filled: a first guess that the first frames correct.
class Cost {
  public:
    void add(double seconds, double values);
    double per_value() const { return cost_; }

  private:
    double cost_ = 1e-6;
};

/// A grid of values on the device, filled in one go or row by row.
class ValueGrid {
  public:
    explicit ValueGrid(const vulkan::Device& device);

    /// Begins anew. `renderer` keeps its plan as long as the grid is being filled.
    void start(const render::Renderer& renderer);
    /// Fills up to `rows` rows from the next one on, and adds what it took to `cost`.
    void fill(const render::Renderer& renderer, int rows, Cost& cost);

    bool filling() const { return next_row_ >= 0; }
    Extent extent() const { return extent_; }
    const vulkan::Buffer& values() const { return values_; }
    /// The values on the host, once they are filled.
    std::span<const float> read();

  private:
    const vulkan::Device& device_;
    Extent extent_;
    std::size_t count_ = 0;
    vulkan::Buffer values_;
    std::optional<vulkan::Buffer> staging_; ///< where the host cannot read the device's memory
    std::optional<vulkan::Job> job_;
    int next_row_ = -1; ///< -1: all are filled
};

/// The values of a drawing on a grid of the view's pixels: coarse while it moves, then finer and finer, in
/// short slices that keep the window responsive.
class Canvas {
  public:
    explicit Canvas(const vulkan::Device& device);

    /// Works for about `seconds` at what the camera shows of the drawing in `extent` pixels, and returns
    /// whether there is more to do. Where that is something else than before it is answered at once, as
    /// finely as the time allows. Throws RequestError where its paint cannot be read.
    bool refine(const Drawing& drawing, const Camera& camera, Extent extent, double seconds);

    /// All of it at once, one value for `stride` x `stride` pixels.
    void draw(const Drawing& drawing, const Camera& camera, Extent extent, int stride);

    const vulkan::Buffer& values() const { return grids_[front_].values(); }
    const std::vector<std::string>& channels() const { return channels_; } ///< of each value
    Extent grid() const { return grids_[front_].extent(); }
    int stride() const { return stride_; } ///< pixels per value; 0 before anything was drawn
    bool fine() const { return stride_ == 1; }
    /// The values on the host: valid until the next work.
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
    std::array<ValueGrid, 2> grids_; ///< the one that is shown, and a finer one that is being filled
    std::vector<std::string> channels_;
    std::size_t front_ = 0;
    int stride_ = 0; ///< of the one shown
    Cost cost_;
};

/// Values of a noise at random points, for their statistics.
class ValueSampler {
  public:
    explicit ValueSampler(const vulkan::Device& device);

    /// As many values of a `value_request` as fit about `seconds`; another `draw`, other points of another
    /// instance.
    std::span<const float> sample(const render::Request& request, std::uint32_t draw, double seconds);

  private:
    render::Renderer renderer_;
    ValueGrid grid_;
    Cost cost_;
};

} // namespace gabor::viewer
