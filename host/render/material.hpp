#pragma once

#include "render/renderer.hpp"

#include "passes/material_interface.h"

#include <array>
#include <string_view>
#include <vector>

namespace gabor::render {

/// The materials of gabor_materials.glsl, as its functions are called after their prefix, with - for _.
constexpr std::array<std::string_view, 12> materials{"wood",  "fabric",  "leather",       "marble",
                                                     "sand",  "ripples", "brushed-metal", "scratches",
                                                     "zebra", "bark",    "carbon-fibre",  "strata"};

/// In place of a material's name: the noise itself.
constexpr std::string_view no_material = "none";

/// Of a material's pixels: base colour, height and so on as in GaborMaterial, and its look under a lamp.
constexpr std::array<std::string_view, 9> material_channels{
    "R", "G", "B", "height", "roughness", "metalness", "lit.R", "lit.G", "lit.B"};

/// The specialization constants of passes/material.comp.
std::vector<std::uint32_t> material_constants(const Request& request);

/// What it is given for all of a picture of `width` x `height` pixels, each `stride`th along both axes. A
/// horizon and a body fit that size, whatever the request's is.
passes::MaterialPush material_push(const Request& request, int width, int height, int stride = 1);

/// Fills a picture of a material with passes/material.comp.
class Material : public RegionRenderer {
  public:
    /// `request` must have passed `check`, and `region` lie within it.
    Material(const vulkan::Device& device, const Request& request, const image::Window& region,
             Code code = {});

    /// With the pipeline of another picture of the same material and view, filtered or not as this one: to
    /// compile one takes seconds.
    Material(const Request& request, const image::Window& region, std::shared_ptr<const vulkan::Pass> pass);
    static std::shared_ptr<const vulkan::Pass> make_pass(const vulkan::Device& device, const Request& request,
                                                         Code code = {});

    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    std::shared_ptr<const vulkan::Pass> pass_;
    passes::MaterialPush push_{};
};

} // namespace gabor::render
