#pragma once

#include "vulkan/pass.hpp"

#include "viewer/noise_pass.hpp"

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

/// A grid of values on the device, filled by a pass in one go or row by row.
class ValueGrid {
  public:
    ValueGrid(const vulkan::Device& device, int channels);

    /// Begins anew. `pass` and `paint` must live as long as the grid is being filled.
    void start(const vulkan::Pass& pass, GridInput input, const vulkan::Buffer& paint);
    /// Fills up to `rows` rows from the next one on, and adds what it took to `cost`.
    void fill(int rows, Cost& cost);

    bool filling() const { return next_row_ >= 0; }
    Extent extent() const { return input_.grid; }
    const vulkan::Buffer& values() const { return values_; }
    /// The values on the host, once they are filled.
    std::span<const float> read();

  private:
    std::size_t count() const;

    const vulkan::Device& device_;
    int channels_;
    GridInput input_;
    vulkan::Buffer values_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer waves_;
    vulkan::Buffer colour_;
    std::optional<vulkan::Buffer> staging_; ///< where the host cannot read the device's memory
    std::optional<vulkan::Job> job_;
    int next_row_ = -1; ///< -1: all are filled
};

/// The values of a noise on a grid of the view's pixels: coarse while it moves, then finer and finer, in
/// short slices that keep the window responsive.
class Canvas {
  public:
    Canvas(const vulkan::Device& device, const NoisePass& noise);

    const NoisePass& noise() const { return noise_; }

    /// Works for about `seconds` at what the camera shows of the noise in `extent` pixels, and returns
    /// whether there is more to do. Where that is something else than before it is answered at once, as
    /// finely as the time allows. `noise` must have the same pipeline.
    bool refine(const NoisePass& noise, const Camera& camera, Extent extent, double seconds);

    /// All of it at once, one value for `stride` x `stride` pixels.
    void draw(const Camera& camera, Extent extent, int stride);

    const vulkan::Buffer& values() const { return grids_[front_].values(); }
    Extent grid() const { return grids_[front_].extent(); }
    int stride() const { return stride_; } ///< pixels per value
    bool fine() const { return stride_ == 1; }
    /// The values on the host: valid until the next work.
    std::span<const float> pixels() { return grids_[front_].read(); }

  private:
    void start(ValueGrid& grid, int stride);

    NoisePass noise_;
    Camera camera_;
    Extent extent_;
    render::Paint paint_;
    vulkan::Buffer paint_samples_;
    const vulkan::Device& device_;
    vulkan::Pass pass_;
    std::array<ValueGrid, 2> grids_; ///< the one that is shown, and a finer one that is being filled
    std::size_t front_ = 0;
    int stride_ = 0; ///< of the one shown
    Cost cost_;
};

/// Values of a noise at random points, for their statistics.
class ValueSampler {
  public:
    /// `noise`: a `value_pass`.
    ValueSampler(const vulkan::Device& device, NoisePass noise);

    const NoisePass& noise() const { return noise_; }
    /// Another noise of the same pipeline.
    void set(NoisePass noise) { noise_ = std::move(noise); }
    /// As many values as fit about `seconds`; another `draw`, other points of another instance.
    std::span<const float> sample(std::uint32_t draw, double seconds);

  private:
    NoisePass noise_;
    vulkan::Buffer no_paint_;
    vulkan::Pass pass_;
    ValueGrid grid_;
    Cost cost_;
};

} // namespace gabor::viewer
