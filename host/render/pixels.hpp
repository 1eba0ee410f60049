#pragma once

#include "render/load.hpp"
#include "render/renderer.hpp"

#include "passes/pixels_interface.h"

namespace gabor::render {

/// Whether it is seen in perspective.
bool in_perspective(const Request& request);

/// Rows above the horizon of a picture of so many rows.
constexpr double sky_rows(double height) {
    return height / 4;
}

/// How long a pixel is, in kernel radii. In perspective, where the scale is that of the bottom row, the
/// height of the camera, of a picture of so many rows.
double pixel_length(const Request& request, int height);

/// The specialization constants of passes/pixels.comp.
std::vector<std::uint32_t> pixels_constants(const Request& request);

/// The noises that it adds up, but for their cameras. Waves that follow the paint are as many as its highest
/// frequency needs.
std::vector<passes::PixelsWave> pixels_waves(const Request& request, const Paint& paint);

/// In the paint, cycles per kernel radius.
double highest_frequency(const Paint& paint);

/// What its colours are made of, zeros where there are none.
passes::PixelsColour pixels_colour(const Request& request);

/// Of a lobe, the weights of its quadrature and its noise in the components of these colours: zeros likewise.
void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe);

/// The kernel radius of each of its tables of lines, PixelsWave.table.
std::vector<double> pixels_tables(const Request& request);

/// What the request alone decides of the push constants: of region, band and paint they know nothing.
/// `height`: of the picture, which perspective fills.
passes::PixelsPush pixels_push(const Request& request, int width, int height);

/// Fills any picture of noise in the plane pixel by pixel, with passes/pixels.comp.
class Pixels : public RegionRenderer {
  public:
    /// `request` must have passed `check`, and `region` lie within it. Reads the request's paint.
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region, Code code = {});

    /// With the pipeline of another picture, which may differ in its size, scale, lobes and seed: to compile
    /// one takes longer than to draw a small picture.
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
           std::shared_ptr<const vulkan::Pass> pass);
    static std::shared_ptr<const vulkan::Pass> make_pass(const vulkan::Device& device, const Request& request,
                                                         Code code = {});

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
           std::shared_ptr<const vulkan::Pass> pass, const Paint& paint);
    Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
           std::shared_ptr<const vulkan::Pass> pass, const Paint& paint,
           const std::vector<passes::PixelsWave>& waves);

    std::shared_ptr<const vulkan::Pass> pass_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer waves_;
    vulkan::Buffer paint_;
    vulkan::Buffer colour_;
    passes::PixelsPush push_;
    int height_;
};

} // namespace gabor::render
