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
    float camera_x;
    float camera_y;
    std::int32_t before;
};

struct PassLobe {
    float frequency;
    float orientation;
    float frequency_spread;
    float orientation_spread;
    float power;

    bool operator==(const PassLobe&) const = default;
};

/// The specialization constants of passes/pixels.comp, and the lobes that it reads.
std::vector<std::uint32_t> pixels_constants(const Picture& picture);
std::vector<PassLobe> pass_lobes(const Picture& picture);

/// Rows above the horizon of a picture or a view of so many rows.
constexpr double sky_rows(double height) {
    return height / 4;
}

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
