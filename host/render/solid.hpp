#pragma once

#include "render/renderer.hpp"

#include "passes/solid_interface.h"

namespace gabor::render {

/// Whether the waves run along a body's surface, and not through it.
bool along_surface(const Request& request);

/// The module of passes/solid.comp that draws it, as recipe_pass.
std::string solid_pass(const Request& request);

/// The specialization constants of passes/solid.comp, but for the last one.
std::vector<std::uint32_t> solid_constants(const Request& request);

/// The noises that it adds up.
std::vector<passes::SolidWave> solid_waves(const Request& request);

/// The push constants of all pixels of a view of `width` x `height` pixels, of which one value stands for
/// `stride` x `stride`: the view that the request's picture has when these are its sides, and the stride 1.
/// How coarse the noise on a body is follows from the request; of its waves they know nothing.
passes::SolidPush solid_push(const Request& request, int width, int height, int stride = 1);

/// Kernel radii in the radius of the sphere, which is the unit of bodies in passes/solid.comp.
double sphere_radius(const Request& request);

/// Fills pictures of noise in space with passes/solid.comp.
class Solid : public RegionRenderer {
  public:
    /// `request` must have passed `check`, and `region` lie within it.
    Solid(const vulkan::Device& device, const Request& request, const image::Window& region, Code code = {});

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Solid(const vulkan::Device& device, const Request& request, const image::Window& region,
          const std::vector<passes::SolidWave>& waves, Code code);

    int height_;
    vulkan::Pass pass_;
    vulkan::Buffer waves_;
    vulkan::Buffer colour_;
    passes::SolidPush push_;
};

} // namespace gabor::render
