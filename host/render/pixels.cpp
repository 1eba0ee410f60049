#include "render/pixels.hpp"

#include "noise/spectrum.hpp"
#include "render/bake.hpp"

#include "passes/pixels.h"
#include "passes/pixels_lattice_2.h"
#include "passes/pixels_lattice_3.h"
#include "passes/pixels_lattice_4.h"

#include <algorithm>
#include <cmath>

namespace gabor::render {

namespace {

constexpr RecipeModules pixels_modules{
    pixels_spirv, {pixels_lattice_2_spirv, pixels_lattice_3_spirv, pixels_lattice_4_spirv}};

// Pixel i is centred at (i + 0.5) / scale kernel radii, or in perspective (i + 0.5) - origin pixels on.
std::vector<passes::Line> lines_along(const Request& request, int side, int first, int count, double origin) {
    const std::vector<double> radii = pixels_tables(request);
    std::vector<passes::Line> lines;
    for (int i = first; i < first + count; ++i) {
        for (const double radius : radii) {
            if (in_perspective(request)) {
                lines.push_back({0, static_cast<float>(i + 0.5 - origin)});
            } else {
                const double cells_per_pixel =
                    axis_along(request, side, radius).radius / (request.scale * radius);
                const double place = (i + 0.5) * cells_per_pixel;
                const double cell = std::floor(place);
                lines.push_back({static_cast<std::int32_t>(cell), static_cast<float>(place - cell)});
            }
        }
    }
    return lines;
}

} // namespace

double highest_frequency(const Paint& paint) {
    float highest = 0;
    for (std::size_t i = 0; i < paint.samples.size(); i += 2)
        highest = std::max(highest, std::abs(paint.samples[i]));
    return highest;
}

bool in_perspective(const Request& request) {
    return std::holds_alternative<Horizon>(request.view);
}

double pixel_length(const Request& request, int height) {
    return (in_perspective(request) ? height - 0.5 - sky_rows(height) : 1) / request.scale;
}

std::vector<std::uint32_t> pixels_constants(const Request& request) {
    const auto of_recipe = recipe_constants(request.recipe);
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    constants.push_back(request.filter);
    constants.push_back(in_perspective(request));
    constants.push_back(!request.paint.empty());
    constants.push_back(request.quadrature);
    constants.push_back(request.gradient);
    constants.push_back(request.phasor);
    constants.push_back(static_cast<std::uint32_t>(request.values));
    constants.push_back(wrapped_time(request) != 0);
    constants.push_back(request.colour.has_value());
    return constants;
}

passes::PixelsColour pixels_colour(const Request& request) {
    const noise::Colour colour = request.colour.value_or(noise::Colour());
    const auto vector = [](double x, double y, double z) {
        return passes::vec4{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0};
    };
    const auto& h = colour.histogram;
    passes::PixelsColour result{};
    for (std::size_t n = 0; n < h[0].size(); ++n)
        result.histogram[n] = vector(h[0][n], h[1][n], h[2][n]);
    result.mean = vector(colour.mean[0], colour.mean[1], colour.mean[2]);
    for (std::size_t i = 0; i < colour.mixing.size(); ++i)
        result.mixing[i] = vector(colour.mixing[i][0], colour.mixing[i][1], colour.mixing[i][2]);
    return result;
}

void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe) {
    if (!request.colour)
        return;
    std::ranges::transform(
        request.colour->weights.at(lobe), weights, [](const noise::Colour::Weight& weight) {
            return passes::vec2{static_cast<float>(weight.quadrature), static_cast<float>(weight.noise)};
        });
}

std::vector<double> pixels_tables(const Request& request) {
    return noise::radii(noise::waves(request.lobes, request.seed));
}

std::vector<passes::PixelsWave> pixels_waves(const Request& request, const Paint& paint) {
    std::vector<noise::Lobe> lobes = request.lobes;
    double unit = 1;
    if (!request.paint.empty()) { // a single lobe
        unit = std::clamp(highest_frequency(paint), 1e-3, 1e6);
        lobes.front().frequency = unit;
        lobes.front().orientation = 0;
    }
    const std::vector<double> tables = pixels_tables(request);
    std::vector<passes::PixelsWave> waves;
    for (const noise::Wave& wave : noise::waves(lobes, request.seed)) {
        const Axis x = axis_along(request, request.width, wave.radius);
        const Axis y = axis_along(request, request.height, wave.radius);
        const auto table = std::ranges::find(tables, wave.radius) - tables.begin();
        waves.push_back({.nodes = {static_cast<float>(x.radius), static_cast<float>(y.radius)},
                         .period = {x.period, y.period},
                         .camera = {0, 0},
                         .frequency = static_cast<float>(wave.frequency / unit * wave.radius),
                         .orientation = static_cast<float>(wave.angle),
                         .radius = static_cast<float>(wave.radius),
                         .amplitude = static_cast<float>(std::sqrt(wave.share)),
                         .seed = wave.seed,
                         .table = static_cast<int>(table),
                         .weights = {}});
    }
    for (std::size_t i = 0; i < waves.size(); ++i) // in colour one wave for each lobe
        put_weights(waves[i].weights, request, i);
    return waves;
}

passes::PixelsPush pixels_push(const Request& request, int width, int height) {
    passes::PixelsPush push{};
    push.paint_size = {1, 1};
    push.time = wrapped_time(request);
    push.pixel = static_cast<float>(pixel_length(request, height));
    push.focal_length = static_cast<float>(width);
    push.tables = static_cast<int>(pixels_tables(request).size());
    return push;
}

std::shared_ptr<const vulkan::Pass> Pixels::make_pass(const vulkan::Device& device, const Request& request,
                                                      Code code) {
    return std::make_shared<vulkan::Pass>(device, code_or(code, pixels_modules.of(request.recipe)),
                                          vulkan::Pass::Interface{6, sizeof(passes::PixelsPush)},
                                          pixels_constants(request));
}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region, Code code)
    : Pixels(device, request, region, make_pass(device, request, code)) {}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
               std::shared_ptr<const vulkan::Pass> pass)
    : Pixels(device, request, region, std::move(pass), load_paint(request.paint)) {}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
               std::shared_ptr<const vulkan::Pass> pass, const Paint& paint)
    : Pixels(device, request, region, std::move(pass), paint, pixels_waves(request, paint)) {}

Pixels::Pixels(const vulkan::Device& device, const Request& request, const image::Window& region,
               std::shared_ptr<const vulkan::Pass> pass, const Paint& paint,
               const std::vector<passes::PixelsWave>& waves)
    : pass_(std::move(pass)),
      columns_(
          upload(device, lines_along(request, request.width, region.x, region.width, request.width / 2.0))),
      rows_(upload(device,
                   lines_along(request, request.height, region.y, region.height, sky_rows(request.height)))),
      waves_(upload(device, waves)), paint_(upload(device, paint.samples)),
      colour_(upload(device, std::vector{pixels_colour(request)})),
      push_(pixels_push(request, request.width, request.height)), height_(region.height) {
    push_.waves = static_cast<int>(waves.size());
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
    return {device, *pass_, {columns_, rows_, waves_, paint_, colour_, result}};
}

void Pixels::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    submit_band(job, push_, band, passes::pixels_group, copy);
}

} // namespace gabor::render
