#include "render/solid.hpp"

#include "noise/spectrum.hpp"
#include "render/pixels.hpp"

#include "passes/solid.h"
#include "passes/solid_surface.h"

#include <algorithm>
#include <cmath>

namespace gabor::render {

namespace {

// Side of a pixel in the plane at distance 1 from the eye, such that a sphere of radius 1 at distance 4
// leaves a margin of 1/20 in a picture whose shorter side has so many.
double pixel_side(int shorter_side) {
    return 2 * 1.05 * std::tan(std::asin(0.25)) / shorter_side;
}

passes::vec2 direction(double angle) {
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

} // namespace

double sphere_radius(const Request& request) {
    // At distance 3 a unit takes 1 / (3 side) pixels.
    return 1 / (3 * pixel_side(std::min(request.width, request.height)) * request.scale);
}

bool along_surface(const Request& request) {
    const Body* body = std::get_if<Body>(&request.view);
    return body && !body->solid;
}

std::string solid_pass(const Request& request) {
    return along_surface(request) ? "passes/solid.comp@surface" : "passes/solid.comp";
}

std::vector<std::uint32_t> solid_constants(const Request& request) {
    const Body* body = std::get_if<Body>(&request.view);
    return {body ? static_cast<std::uint32_t>(body->shape) + 1 : 0,
            std::ranges::any_of(request.lobes, is_isotropic),
            !std::ranges::all_of(request.lobes, is_isotropic),
            request.filter,
            static_cast<std::uint32_t>(request.values),
            request.quadrature,
            request.gradient,
            request.phasor,
            wrapped_time(request) != 0,
            request.colour.has_value()};
}

std::vector<passes::SolidWave> solid_waves(const Request& request) {
    std::vector<passes::SolidWave> waves;
    for (const noise::Wave& wave : noise::waves_in_space(request.lobes, request.seed))
        waves.push_back({.direction = direction(wave.angle),
                         .frequency = static_cast<float>(wave.frequency * wave.radius),
                         .radius = static_cast<float>(wave.radius),
                         .amplitude = static_cast<float>(std::sqrt(wave.share)),
                         .seed = wave.seed,
                         .isotropic = wave.isotropic,
                         .weights = {}});
    for (std::size_t i = 0; i < waves.size(); ++i) // in colour one wave for each lobe
        put_weights(waves[i].weights, request, i);
    return waves;
}

passes::SolidPush solid_push(const Request& request, int width, int height, int stride) {
    passes::SolidPush push{};
    push.center = {static_cast<float>(width / 2.0 / stride), static_cast<float>(height / 2.0 / stride)};
    push.time = wrapped_time(request);
    push.unit = static_cast<float>(sphere_radius(request));
    if (const Slice* slice = std::get_if<Slice>(&request.view)) {
        push.pixel = static_cast<float>(stride / request.scale);
        push.depth = static_cast<float>(slice->depth);
    } else {
        const Body& body = std::get<Body>(request.view);
        push.pixel = static_cast<float>(pixel_side(std::min(width, height)) * stride / body.zoom);
        push.yaw = direction(noise::radians(std::remainder(body.yaw, 360.0)));
        push.pitch = direction(noise::radians(body.pitch));
    }
    push.width = (width + stride - 1) / stride;
    push.height = (height + stride - 1) / stride;
    return push;
}

Solid::Solid(const vulkan::Device& device, const Request& request, const image::Window& region, Code code)
    : Solid(device, request, region, solid_waves(request), code) {}

Solid::Solid(const vulkan::Device& device, const Request& request, const image::Window& region,
             const std::vector<passes::SolidWave>& waves, Code code)
    : height_(region.height),
      pass_(device, code_or(code, along_surface(request) ? Code(solid_surface_spirv) : Code(solid_spirv)),
            {3, sizeof(passes::SolidPush)}, solid_constants(request)),
      waves_(upload(device, waves)), colour_(upload(device, std::vector{pixels_colour(request)})),
      push_(solid_push(request, request.width, request.height)) {
    push_.waves = static_cast<int>(waves.size());
    push_.width = region.width;
    push_.first_column = region.x;
    push_.first_row = region.y;
}

std::vector<RegionRenderer::Band> Solid::bands(int most_rows) const {
    return bands_of_rows(height_, most_rows);
}

vulkan::Job Solid::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, pass_, {waves_, result, colour_}};
}

void Solid::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    submit_band(job, push_, band, passes::solid_group, copy);
}

} // namespace gabor::render
