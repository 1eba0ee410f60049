#pragma once

#include "render/filler.hpp"

#include <array>
#include <cstdint>

namespace gabor::render {

enum class SolidView : std::int32_t { slice, sphere, torus };

/// Which wave vectors the impulses have: `direction` or all, in space or in the tangent plane of the surface.
enum class SolidWaves : std::int32_t { oriented, isotropic, surface, surface_isotropic };

/// Everything that decides the pixels of a picture of noise in space, passes/solid.comp. A slice shows at
/// pixel (x, y), rows growing downwards, the noise at ((x + 0.5) / scale, (y + 0.5) / scale, depth) kernel
/// radii. A sphere or a torus, axis z, is seen in perspective from 30 degrees above, and fits the shorter
/// side. Its channels are `Y`, the noise, 0 where nothing is seen, and `A`, the share of the pixel that is
/// covered; Y is not multiplied by A.
struct SolidPicture {
    int width = 1024;
    int height = 1024;
    SolidView view = SolidView::sphere;
    SolidWaves waves = SolidWaves::surface_isotropic;
    double scale = 32;    ///< pixels per kernel radius, in [2, 4096]; where a sphere is nearest
    double frequency = 4; ///< cycles per kernel radius, in [0.001, 1024]
    std::array<double, 3> direction{1, 0, 0}; ///< of the waves, any but 0; each coordinate in [-1e6, 1e6]
    double depth = 0;                         ///< of the slice, kernel radii, in [-1e6, 1e6]
    std::uint32_t seed = 0;
    bool filtered = true; ///< by a Gaussian footprint whose standard deviation is half a pixel
};

/// Throws RequestError when a value is outside its range, naming it and the range.
void check(const SolidPicture& picture);

/// What a picture of the views `slice`, `sphere` or `torus` comes to.
SolidPicture in_space(const Picture& picture);

/// Kernel radii in the radius of the sphere, which is the unit of bodies in passes/solid.comp.
double sphere_radius(const SolidPicture& picture);

/// As in passes/solid.comp.
struct SolidPush {
    float center_x, center_y;
    float pixel;
    float unit;
    float depth;
    float frequency;
    float direction_x, direction_y, direction_z;
    std::uint32_t seed;
    std::int32_t first_column, first_row;
    std::int32_t columns, rows;
};

/// The pass that fills a region of a picture of noise in space, passes/solid.comp.
class Solid : public Filler {
  public:
    /// `picture` must have passed `check`, and `region` lie within it.
    Solid(const vulkan::Device& device, const SolidPicture& picture, const image::Window& region);

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    int height_;
    vulkan::Pass pass_;
    SolidPush push_;
};

} // namespace gabor::render
