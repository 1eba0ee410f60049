#pragma once

#include "viewer/source.hpp"
#include "viewer/window.hpp"

#include <optional>
#include <span>

namespace gabor::viewer {

/// One side of the view: the values of a noise on a grid of the view's pixels, coarse while it moves, then
/// finer and finer, in portions that leave the window alive.
class Canvas {
  public:
    Canvas(const vulkan::Device& device, const Subject& subject, const std::vector<std::uint32_t>& spirv);

    const Subject& subject() const { return subject_; }
    /// Another pass for the same subject, from changed shaders.
    void replace(const std::vector<std::uint32_t>& spirv);

    /// What the canvas is to show.
    struct Request {
        FieldPush push{};
        Camera camera;
        double scale = 1;
        Extent extent;
    };

    /// Works for about `seconds`, and returns whether there is more to do. A new request is answered at once,
    /// as finely as the time allows.
    bool work(const Request& request, double seconds);
    /// The same until nothing is left to do.
    void finish(const Request& request);

    /// Values of as many random places of independent instances as fit about `seconds`, from the one after the
    /// last call's.
    std::span<const float> sample(const FieldPush& push, std::uint32_t first, double seconds);

    const vulkan::Buffer& values() const { return front().values; }
    Extent grid() const { return front().grid; }
    int stride() const { return front().stride; }
    bool fine() const { return front().stride == 1 && !stale_; }
    double seconds_per_pixel() const { return cost_; }
    /// The values on the host, once `fine`: valid until the next work.
    std::span<const float> pixels();

  private:
    struct Grid {
        explicit Grid(const vulkan::Device& device);
        void resize(const vulkan::Device& device, const vulkan::Pass& pass, std::size_t bytes, std::size_t axes);

        vulkan::Buffer values;
        vulkan::Buffer places;
        std::optional<vulkan::Buffer> staging; ///< where the host cannot read the device's memory
        std::optional<vulkan::Job> job;
        Extent grid;
        int stride = 0; ///< pixels per value; 0: empty
    };

    Grid& front() { return grids_[front_]; }
    const Grid& front() const { return grids_[front_]; }
    void start(Grid& grid, const Request& request, int stride);
    void fill(Grid& grid, FieldPush push, int rows);
    int coarsest(const Request& request, double seconds) const;

    const vulkan::Device& device_;
    Subject subject_;
    vulkan::Pass pass_;
    std::array<Grid, 2> grids_;
    Grid samples_;
    std::size_t front_ = 0;
    int next_row_ = -1; ///< of the grid behind; -1: none is begun
    bool stale_ = true;
    Request shown_;
    double cost_ = 1e-6; ///< seconds per value; a first guess that the first frames correct
};

} // namespace gabor::viewer
