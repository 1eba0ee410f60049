#pragma once

#include "viewer/document.hpp"
#include "viewer/shaders.hpp"
#include "viewer/window.hpp"
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
    float middle_x;
    float middle_y;
    float stride;
    float focal;
    float unit;
    float yaw;
    float pitch;
    std::int32_t cell_x;
    std::int32_t cell_y;
    float local_x;
    float local_y;
};

/// Which noise one side of the view shows.
struct Subject {
    std::string recipe; ///< of the drop-in, or empty for `ingredients`
    study::Ingredients ingredients;
    int channels = 1; ///< the noise; 2: and its quadrature; 4: and its derivatives
    View view = View::plane;
    Waves waves = Waves::oriented; ///< in space
    bool filtered = false;

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

/// What the pass is told of the document, for a view of so many pixels; its grid and rows are left open.
FieldPush make_push(const Subject& subject, const Document& document, Extent extent);

} // namespace gabor::viewer
