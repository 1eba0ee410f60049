#pragma once

#include "render/filler.hpp"
#include "render/paint.hpp"

namespace gabor::render {

/// As in passes/pixels.comp.
struct PixelsPush {
    float radius_x, radius_y;
    std::int32_t period_x, period_y;
    float time;
    float frequency;
    float orientation;
    float pixel;
    float focal_length;
    std::uint32_t seed;
    std::int32_t width;
    std::int32_t height;
    std::int32_t first_row;
    std::int32_t paint_width;
    std::int32_t paint_height;
    float paint_scale_x;
    float paint_scale_y;
    float paint_x;
    float paint_y;
};

/// The pass that fills any picture pixel by pixel, passes/pixels.comp.
class Pixels : public Filler {
  public:
    /// `picture` must have passed `check`, and `region` lie within it. Reads the picture's paint.
    Pixels(const vulkan::Device& device, const Picture& picture, const image::Window& region);

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Pixels(const vulkan::Device& device, const Picture& picture, const image::Window& region,
           const Paint& paint);

    vulkan::Pass pass_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer lobes_;
    vulkan::Buffer paint_;
    PixelsPush push_;
    int height_;
};

} // namespace gabor::render
