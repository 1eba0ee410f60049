#pragma once

#include "viewer/document.hpp"
#include "viewer/shaders.hpp"
#include "vulkan/pass.hpp"

#include <memory>
#include <string>

namespace gabor::viewer {

/// As in shaders/viewer/grid.glsl.
struct FieldPush {
    float frequency;
    float orientation;
    float time;
    float amplitude;
    std::uint32_t seed;
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t first_row;
    std::uint32_t end_row;
    std::uint32_t sampling;
    std::uint32_t first_sample;
};

/// Which noise one side of the view shows.
struct Subject {
    std::string recipe; ///< of the drop-in, or empty for `ingredients`
    study::Ingredients ingredients;
    int channels = 1; ///< the noise; 2: and its quadrature; 4: and its derivatives

    double radius() const;  ///< cells per kernel radius
    double visited() const; ///< impulses for each pixel; the mean where their number is random
    std::string name() const;
    bool operator==(const Subject&) const = default;
};

/// The subjects of a document: the picture, and its rival in the split view.
std::vector<Subject> subjects(const Document& document);

/// A subject's pass, from shaders/viewer/noise.comp or ingredients.comp.
vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, const std::vector<std::uint32_t>& spirv);
std::string_view shader_of(const Subject& subject);

/// What the pass is told of the document.
FieldPush make_push(const Subject& subject, const render::Picture& picture);

} // namespace gabor::viewer
