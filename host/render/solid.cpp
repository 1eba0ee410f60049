#include "render/solid.hpp"

#include "error.hpp"

#include "passes/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr std::uint32_t group = 8; // local_size_x and local_size_y of passes/solid.comp

// Side of a pixel: of a slice in kernel radii; else in the plane at distance 1 from the eye, such that a
// sphere of radius 1 at distance 4 leaves a margin of 1/20.
double pixel_side(const SolidPicture& picture) {
    if (picture.view == SolidView::slice)
        return 1 / picture.scale;
    return 2 * 1.05 * std::tan(std::asin(0.25)) / std::min(picture.width, picture.height);
}

std::array<std::uint32_t, 3> constants_of(const SolidPicture& picture) {
    using vulkan::constant;
    return {constant(static_cast<std::int32_t>(picture.view)),
            constant(static_cast<std::int32_t>(picture.waves)),
            constant(static_cast<std::int32_t>(picture.filtered))};
}

SolidPush make_push(const SolidPicture& picture, const image::Window& region) {
    SolidPush push{};
    push.center_x = static_cast<float>(picture.width / 2.0);
    push.center_y = static_cast<float>(picture.height / 2.0);
    push.pixel = static_cast<float>(pixel_side(picture));
    push.unit = static_cast<float>(sphere_radius(picture));
    push.depth = static_cast<float>(picture.depth);
    push.frequency = static_cast<float>(picture.frequency);
    push.direction_x = static_cast<float>(picture.direction[0]);
    push.direction_y = static_cast<float>(picture.direction[1]);
    push.direction_z = static_cast<float>(picture.direction[2]);
    push.seed = picture.seed;
    push.first_column = region.x;
    push.first_row = region.y;
    push.columns = region.width;
    return push;
}

} // namespace

void check(const SolidPicture& picture) {
    check_range("width", picture.width, 1, largest_side);
    check_range("height", picture.height, 1, largest_side);
    check_range("scale", picture.scale, smallest_scale, largest_scale);
    check_range("frequency", picture.frequency, smallest_frequency, largest_frequency);
    check_range("depth", picture.depth, -1e6, 1e6);
    for (const double coordinate : picture.direction)
        check_range("direction", coordinate, -1e6, 1e6);
    if (std::ranges::all_of(picture.direction, [](double coordinate) { return std::abs(coordinate) < 1e-6; }))
        throw RequestError("direction is 0: at least one of its coordinates must be 1e-6 or larger");
}

SolidPicture in_space(const Picture& picture) {
    const double radians = picture.orientation * std::numbers::pi / 180;
    const bool isotropic = picture.orientation_spread > 0;
    SolidPicture space;
    space.width = picture.width;
    space.height = picture.height;
    space.view = picture.view == "slice"    ? SolidView::slice
                 : picture.view == "sphere" ? SolidView::sphere
                                            : SolidView::torus;
    if (picture.solid || picture.view == "slice")
        space.waves = isotropic ? SolidWaves::isotropic : SolidWaves::oriented;
    else
        space.waves = isotropic ? SolidWaves::surface_isotropic : SolidWaves::surface;
    space.scale = picture.scale;
    space.frequency = picture.frequency;
    space.direction = {std::cos(radians), std::sin(radians), 0};
    space.depth = picture.depth;
    space.seed = picture.seed;
    space.filtered = picture.filter;
    return space;
}

double sphere_radius(const SolidPicture& picture) {
    // At distance 3 a unit takes 1 / (3 pixel) pixels.
    return 1 / (3 * pixel_side(picture) * picture.scale);
}

Solid::Solid(const vulkan::Device& device, const SolidPicture& picture, const image::Window& region)
    : height_(region.height), pass_(device, solid_spirv, {1, sizeof(SolidPush)}, constants_of(picture)),
      push_(make_push(picture, region)) {}

std::vector<Filler::Band> Solid::bands(int most_rows) const {
    std::vector<Band> bands;
    for (int row = 0; row < height_; row += most_rows)
        bands.push_back({row, std::min(most_rows, height_ - row), 0, 0});
    return bands;
}

vulkan::Job Solid::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, pass_, {result}};
}

void Solid::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    SolidPush push = push_;
    push.first_row += band.first_row;
    push.rows = band.rows;
    const auto groups = [](int side) { return (static_cast<std::uint32_t>(side) + group - 1) / group; };
    job.submit(push, {groups(push.columns), groups(push.rows)}, copy);
}

} // namespace gabor::render
