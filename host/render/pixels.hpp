#pragma once

#include "render/load.hpp"
#include "render/renderer.hpp"

#include "passes/pixels_interface.h"

namespace gabor::render {

/// The specialization constants of passes/pixels.comp, and the lobes that it reads.
std::vector<std::uint32_t> pixels_constants(const Request& request);
std::vector<passes::Lobe> pixels_lobes(const Request& request);

/// What the request alone decides of the push constants: of region, band, paint and camera they know nothing.
/// `height`: of the picture, which perspective fills.
passes::PixelsPush pixels_push(const Request& request, int width, int height);

/// Rows above the horizon of a picture of so many rows.
constexpr double sky_rows(double height) {
    return height / 4;
}

/// Fills any picture of noise in the plane pixel by pixel, with passes/pixels.comp.
class Pixels : public RegionRenderer {
  public:
    /// `request` must have passed `check`, and `region` lie within it. Reads the request's paint.
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region);

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
           const Paint& paint);

    vulkan::Pass pass_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer lobes_;
    vulkan::Buffer paint_;
    passes::PixelsPush push_;
    int height_;
};

} // namespace gabor::render
