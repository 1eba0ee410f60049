#pragma once

#include "render/paint.hpp"
#include "viewer/noise_pass.hpp"

#include <array>
#include <optional>
#include <span>

namespace gabor::viewer {

using Spirv = std::vector<std::uint32_t>;

/// One side of the view: the values of a noise on a grid of the view's pixels, coarse while it moves, then
/// finer and finer, in portions that leave the window alive.
class Canvas {
  public:
    Canvas(const vulkan::Device& device, const NoisePass& noise, const Spirv& spirv);

    const NoisePass& noise() const { return noise_; }
    /// Another pass for the same noise, from changed shaders.
    void replace(const Spirv& spirv);

    /// Works for about `seconds` at what a view of the document shows in `extent` pixels, and returns whether
    /// there is more to do. Where that is something else than before it is answered at once, as finely as the
    /// time allows. `noise` must be of the same pass.
    bool refine(const NoisePass& noise, const Document& document, Extent extent, double seconds);

    const vulkan::Buffer& values() const { return front().values; }
    Extent grid() const { return front().grid; }
    int stride() const { return front().stride; } ///< pixels per value
    bool fine() const { return front().stride == 1 && !stale_; }
    double seconds_per_pixel() const { return cost_; }
    /// The values on the host, once `fine`: valid until the next work.
    std::span<const float> pixels();

  private:
    struct Grid {
        explicit Grid(const vulkan::Device& device);

        vulkan::Buffer values;
        vulkan::Buffer columns;
        vulkan::Buffer rows;
        vulkan::Buffer lobes;
        std::optional<vulkan::Buffer> staging; ///< where the host cannot read the device's memory
        std::optional<vulkan::Job> job;
        Extent grid;
        int stride = 0;    ///< pixels per value; 0: empty
        int next_row = -1; ///< -1: all are filled
    };

    /// All that decides the pixels of a view.
    struct Request {
        ViewParameters parameters;
        Camera camera;
        double scale;
        Extent extent;
    };

    Grid& front() { return grids_[front_]; }
    const Grid& front() const { return grids_[front_]; }
    static bool same(const Request& a, const Request& b);
    void start(Grid& grid, const SamplePoints& points, int stride);
    void fill(Grid& grid, int rows);
    int coarsest(double seconds) const;

    const vulkan::Device& device_;
    NoisePass noise_;
    render::Paint paint_;
    vulkan::Buffer paint_samples_;
    vulkan::Pass pass_;
    std::array<Grid, 2> grids_;
    std::size_t front_ = 0;
    bool stale_ = true;
    Request shown_;
    double cost_ = 1e-6; ///< seconds per value; a first guess that the first frames correct

    friend class ValueSampler;
};

/// Values of a noise at random points, for their law.
class ValueSampler {
  public:
    ValueSampler(const vulkan::Device& device, const NoisePass& noise, const Spirv& spirv)
        : canvas_(device, in_plane(noise), spirv) {}

    /// As many as fit about `seconds`; another `draw`, other points of another instance.
    std::span<const float> sample(const Document& document, std::uint32_t draw, double seconds);
    int channels() const { return canvas_.noise_.channels; }

  private:
    Canvas canvas_;
};

} // namespace gabor::viewer
