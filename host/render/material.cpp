#include "render/material.hpp"

#include "render/pixels.hpp"

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
constexpr std::array<std::span<const std::uint32_t>, materials.size()> modules{
    material_wood_spirv,  material_fabric_spirv,  material_leather_spirv,       material_marble_spirv,
    material_sand_spirv,  material_ripples_spirv, material_brushed_metal_spirv, material_scratches_spirv,
    material_zebra_spirv, material_bark_spirv,    material_carbon_fibre_spirv,  material_strata_spirv};

std::span<const std::uint32_t> module_of(const Request& request) {
    return modules.at(
        static_cast<std::size_t>(std::ranges::find(materials, request.material) - materials.begin()));
}

} // namespace

std::shared_ptr<const vulkan::Pass> Material::make_pass(const vulkan::Device& device, const Request& request,
                                                        Code code) {
    return std::make_shared<vulkan::Pass>(
        device, code_or(code, module_of(request)), vulkan::Pass::Interface{1, sizeof(passes::MaterialPush)},
        std::vector<std::uint32_t>{request.filter, in_perspective(request)});
}

Material::Material(const vulkan::Device& device, const Request& request, const image::Window& region,
                   Code code)
    : Material(request, region, make_pass(device, request, code)) {}

Material::Material(const Request& request, const image::Window& region,
                   std::shared_ptr<const vulkan::Pass> pass)
    : pass_(std::move(pass)) {
    push_.size = {static_cast<float>(request.width), static_cast<float>(request.height)};
    push_.pixel = static_cast<float>(pixel_length(request, request.height));
    push_.sky = static_cast<float>(in_perspective(request) ? sky_rows(request.height) : 0);
    push_.seed = request.seed;
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
