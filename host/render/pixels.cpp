#include "render/pixels.hpp"

#include "render/bake.hpp"

#include "passes/pixels.h"
#include "passes/pixels_lattice_2.h"
#include "passes/pixels_lattice_3.h"
#include "passes/pixels_lattice_4.h"

#include <cmath>

namespace gabor::render {

namespace {

constexpr RecipeModules modules{pixels_spirv,
                                {pixels_lattice_2_spirv, pixels_lattice_3_spirv, pixels_lattice_4_spirv}};

bool in_perspective(const Request& request) {
    return std::holds_alternative<Horizon>(request.view);
}

// Pixel i is centred at (i + 0.5) / scale kernel radii, or in perspective (i + 0.5) - origin pixels on.
std::vector<passes::Line> lines_along(const Request& request, int side, int first, int count, double origin) {
    const double cells_per_pixel = axis_along(request, side).radius / request.scale;
    std::vector<passes::Line> lines;
    for (int i = first; i < first + count; ++i) {
        if (in_perspective(request)) {
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

std::vector<passes::Lobe> pixels_lobes(const Request& request) {
    std::vector<passes::Lobe> lobes;
    for (const noise::Lobe& lobe : request.lobes)
        lobes.push_back({static_cast<float>(lobe.frequency), static_cast<float>(lobe.angle()),
                         static_cast<float>(lobe.frequency_spread),
                         static_cast<float>(noise::radians(lobe.orientation_spread)),
                         static_cast<float>(lobe.power)});
    return lobes;
}

std::vector<std::uint32_t> pixels_constants(const Request& request) {
    const auto of_recipe = recipe_constants(drawing_recipe(request));
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    // A single wave is not counted as a lobe: it keeps the phases of the recipe.
    constants.push_back(is_one_wave(request) ? 0 : static_cast<std::uint32_t>(request.lobes.size()));
    constants.push_back(request.sum && request.lobes.size() > 1);
    constants.push_back(request.filter);
    constants.push_back(in_perspective(request));
    constants.push_back(!request.paint.empty());
    constants.push_back(request.quadrature);
    constants.push_back(request.gradient);
    constants.push_back(request.phasor);
    constants.push_back(static_cast<std::uint32_t>(request.values));
    constants.push_back(wrapped_time(request) != 0);
    return constants;
}

passes::PixelsPush pixels_push(const Request& request, int width, int height) {
    const noise::Lobe& lobe = request.lobes.front();
    const Axis x = axis_along(request, request.width);
    const Axis y = axis_along(request, request.height);
    passes::PixelsPush push{};
    push.radius = {static_cast<float>(x.radius), static_cast<float>(y.radius)};
    push.period = {x.period, y.period};
    push.paint_size = {1, 1};
    push.time = wrapped_time(request);
    push.frequency = static_cast<float>(lobe.frequency);
    push.orientation = static_cast<float>(lobe.angle());
    // In perspective the scale is that of the bottom row.
    push.pixel =
        static_cast<float>((in_perspective(request) ? height - 0.5 - sky_rows(height) : 1) / request.scale);
    push.focal_length = static_cast<float>(width);
    push.seed = request.seed;
    return push;
}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region)
    : Pixels(device, request, region, load_paint(request.paint)) {}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
               const Paint& paint)
    : pass_(device, modules.of(drawing_recipe(request)), {5, sizeof(passes::PixelsPush)},
            pixels_constants(request)),
      columns_(
          upload(device, lines_along(request, request.width, region.x, region.width, request.width / 2.0))),
      rows_(upload(device,
                   lines_along(request, request.height, region.y, region.height, sky_rows(request.height)))),
      lobes_(upload(device, pixels_lobes(request))), paint_(upload(device, paint.samples)),
      push_(pixels_push(request, request.width, request.height)), height_(region.height) {
    push_.width = region.width;
    push_.paint_size = {paint.width, paint.height};
    push_.paint_scale = {static_cast<float>(static_cast<double>(paint.width) / request.width),
                         static_cast<float>(static_cast<double>(paint.height) / request.height)};
    push_.paint_corner = {static_cast<float>(region.x) * push_.paint_scale.x,
                          static_cast<float>(region.y) * push_.paint_scale.y};
}

std::vector<RegionRenderer::Band> Pixels::bands(int most_rows) const {
    return bands_of_rows(height_, most_rows);
}

vulkan::Job Pixels::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, pass_, {columns_, rows_, lobes_, paint_, result}};
}

void Pixels::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    passes::PixelsPush push = push_;
    push.first_row = band.first_row;
    push.height = band.rows;
    job.submit(push, {groups(push.width, passes::pixels_group), groups(band.rows, passes::pixels_group)},
               copy);
}

} // namespace gabor::render
