#include "render/pixels.hpp"

#include "render/axis.hpp"
#include "render/bake.hpp"

#include "passes/pixels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr std::uint32_t group = 8; // local_size of passes/pixels.comp, in x and y

/// As in passes/pixels.comp.
struct Line {
    std::int32_t cell;
    float local;
};

bool in_perspective(const Picture& picture) {
    return picture.view == "horizon";
}

double sky(const Picture& picture) {
    return sky_rows(picture.height);
}

// Pixel i is centred at (i + 0.5) / scale kernel radii, or in perspective (i + 0.5) - origin pixels on.
std::vector<Line> lines_along(const Picture& picture, int side, int first, int count, double origin) {
    const double cells_per_pixel = axis_along(picture, side).radius / picture.scale;
    std::vector<Line> lines;
    for (int i = first; i < first + count; ++i) {
        if (in_perspective(picture)) {
            lines.push_back({0, static_cast<float>(i + 0.5 - origin)});
        } else {
            const double place = (i + 0.5) * cells_per_pixel;
            const double cell = std::floor(place);
            lines.push_back({static_cast<std::int32_t>(cell), static_cast<float>(place - cell)});
        }
    }
    return lines;
}

} // namespace

std::vector<PassLobe> pass_lobes(const Picture& picture) {
    std::vector<PassLobe> lobes;
    for (const noise::Lobe& lobe : spectrum(picture))
        lobes.push_back({static_cast<float>(lobe.frequency), static_cast<float>(lobe.orientation),
                         static_cast<float>(lobe.frequency_spread),
                         static_cast<float>(lobe.orientation_spread), static_cast<float>(lobe.power)});
    return lobes;
}

std::vector<std::uint32_t> pixels_constants(const Picture& picture) {
    const auto of_recipe = recipe_constants(noise::find_recipe(picture.recipe));
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    // A plain lobe is not counted: it keeps the phases of the recipe.
    const std::vector<noise::Lobe> lobes = spectrum(picture);
    const bool plain =
        picture.lobes.empty() && lobes[0].frequency_spread == 0 && lobes[0].orientation_spread == 0;
    constants.push_back(plain ? 0 : static_cast<std::uint32_t>(lobes.size()));
    constants.push_back(picture.sum && !plain);
    constants.push_back(picture.filter);
    constants.push_back(in_perspective(picture));
    constants.push_back(!picture.paint.empty());
    constants.push_back(picture.quadrature);
    constants.push_back(picture.gradient);
    constants.push_back(picture.phasor);
    constants.push_back(static_cast<std::uint32_t>(picture.values));
    return constants;
}

Pixels::Pixels(const vulkan::Device& device, const Picture& picture, const image::Window& region)
    : Pixels(device, picture, region, read_paint(picture.paint)) {}

Pixels::Pixels(const vulkan::Device& device, const Picture& picture, const image::Window& region,
               const Paint& paint)
    : pass_(device, pixels_spirv, {5, sizeof(PixelsPush)}, pixels_constants(picture)),
      columns_(
          upload(device, lines_along(picture, picture.width, region.x, region.width, picture.width / 2.0))),
      rows_(upload(device, lines_along(picture, picture.height, region.y, region.height, sky(picture)))),
      lobes_(upload(device, pass_lobes(picture))), paint_(upload(device, paint.samples)), push_{},
      height_(region.height) {
    const noise::Lobe first = spectrum(picture).front();
    const Axis x = axis_along(picture, picture.width);
    const Axis y = axis_along(picture, picture.height);
    push_.radius_x = static_cast<float>(x.radius);
    push_.radius_y = static_cast<float>(y.radius);
    push_.period_x = x.period;
    push_.period_y = y.period;
    push_.time = static_cast<float>(picture.time - std::floor(picture.time));
    push_.frequency = static_cast<float>(first.frequency);
    push_.orientation = static_cast<float>(first.orientation);
    // In perspective the scale is that of the bottom row.
    push_.pixel = static_cast<float>((in_perspective(picture) ? picture.height - 0.5 - sky(picture) : 1) /
                                     picture.scale);
    push_.focal_length = static_cast<float>(picture.width);
    push_.seed = picture.seed;
    push_.width = region.width;
    push_.paint_width = paint.width;
    push_.paint_height = paint.height;
    push_.paint_scale_x = static_cast<float>(static_cast<double>(paint.width) / picture.width);
    push_.paint_scale_y = static_cast<float>(static_cast<double>(paint.height) / picture.height);
    push_.paint_x = static_cast<float>(region.x) * push_.paint_scale_x;
    push_.paint_y = static_cast<float>(region.y) * push_.paint_scale_y;
}

std::vector<Filler::Band> Pixels::bands(int most_rows) const {
    std::vector<Band> bands;
    for (int row = 0; row < height_; row += std::max(most_rows, 1))
        bands.push_back({row, std::min(std::max(most_rows, 1), height_ - row), 0, 0});
    return bands;
}

vulkan::Job Pixels::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, pass_, {columns_, rows_, lobes_, paint_, result}};
}

void Pixels::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    PixelsPush push = push_;
    push.first_row = band.first_row;
    push.height = band.rows;
    const auto groups = [](int pixels) { return (static_cast<std::uint32_t>(pixels) + group - 1) / group; };
    job.submit(push, {groups(push.width), groups(band.rows)}, copy);
}

} // namespace gabor::render
