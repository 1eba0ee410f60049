#include "render/material.hpp"

#include "render/pixels.hpp"
#include "render/solid.hpp"

#include "passes/material_bark.h"
#include "passes/material_brushed_metal.h"
#include "passes/material_carbon_fibre.h"
#include "passes/material_fabric.h"
#include "passes/material_leather.h"
#include "passes/material_marble.h"
#include "passes/material_ripples.h"
#include "passes/material_sand.h"
#include "passes/material_scratches.h"
#include "passes/material_strata.h"
#include "passes/material_wood.h"
#include "passes/material_zebra.h"

#include <algorithm>

namespace gabor::render {

namespace {

// A pass for each material, in their order: of one pass for all compilers take minutes.
constexpr std::array<std::span<const std::uint32_t>, materials.size()> material_modules{
    material_wood_spirv,  material_fabric_spirv,  material_leather_spirv,       material_marble_spirv,
    material_sand_spirv,  material_ripples_spirv, material_brushed_metal_spirv, material_scratches_spirv,
    material_zebra_spirv, material_bark_spirv,    material_carbon_fibre_spirv,  material_strata_spirv};

std::span<const std::uint32_t> module_of(const Request& request) {
    return material_modules.at(
        static_cast<std::size_t>(std::ranges::find(materials, request.material) - materials.begin()));
}

} // namespace

std::vector<std::uint32_t> material_constants(const Request& request) {
    const Body* body = std::get_if<Body>(&request.view);
    constexpr std::uint32_t perspective = 3;
    return {request.filter, body                      ? static_cast<std::uint32_t>(body->shape) + 1
                            : in_perspective(request) ? perspective
                                                      : 0};
}

passes::MaterialPush material_push(const Request& request, int width, int height, int stride) {
    passes::MaterialPush push{};
    const auto pixels = [&](double side) { return static_cast<float>(side / stride); };
    push.size = {pixels(width), pixels(height)};
    push.center = {pixels(width / 2.0), pixels(height / 2.0)};
    push.pixel = static_cast<float>(stride / request.scale);
    push.seed = request.seed;
    if (in_perspective(request)) {
        push.sky = pixels(sky_rows(height));
        push.pixel = static_cast<float>(pixel_length(request, height));
    } else if (std::holds_alternative<Body>(request.view)) {
        const passes::SolidPush seen = solid_push(request, width, height, stride);
        push.pixel = seen.pixel;
        push.unit = seen.unit;
        push.yaw = seen.yaw;
        push.pitch = seen.pitch;
    }
    push.width = (width + stride - 1) / stride;
    push.height = (height + stride - 1) / stride;
    return push;
}

std::shared_ptr<const vulkan::Pass> Material::make_pass(const vulkan::Device& device, const Request& request,
                                                        Code code) {
    return std::make_shared<vulkan::Pass>(device, code_or(code, module_of(request)),
                                          vulkan::Pass::Interface{1, sizeof(passes::MaterialPush)},
                                          material_constants(request));
}

Material::Material(const vulkan::Device& device, const Request& request, const image::Window& region,
                   Code code)
    : Material(request, region, make_pass(device, request, code)) {}

Material::Material(const Request& request, const image::Window& region,
                   std::shared_ptr<const vulkan::Pass> pass)
    : pass_(std::move(pass)), push_(material_push(request, request.width, request.height)) {
    push_.first_column = region.x;
    push_.first_row = region.y;
    push_.width = region.width;
    push_.height = region.height;
}

std::vector<RegionRenderer::Band> Material::bands(int most_rows) const {
    return bands_of_rows(push_.height, most_rows);
}

vulkan::Job Material::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, *pass_, {result}};
}

void Material::submit(vulkan::Job& job, const Band& band,
                      const std::optional<vulkan::Job::Copy>& copy) const {
    submit_band(job, push_, band, passes::material_group, copy);
}

} // namespace gabor::render
