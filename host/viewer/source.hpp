#pragma once

#include "render/pixels.hpp"
#include "viewer/document.hpp"
#include "viewer/window.hpp"

#include <string>

namespace gabor::viewer {

/// What passes/pixels.comp is told, and beyond that the viewer's own passes: shaders/viewer/view.glsl.
struct ViewPush {
    render::PixelsPush pixels;
    float amplitude;
    float stride;
    float yaw;
    float pitch;
};

/// Which noise one side of the view shows, in which way.
struct Subject {
    std::string shader;
    std::vector<std::uint32_t> constants;
    render::Picture picture; ///< with the channels that the view shows
    View view = View::plane;
    std::optional<study::Ingredients> ingredients; ///< where it is no noise of the drop-in
    std::string name;
    double visited = 0; ///< impulses for each pixel; the mean where their number is random
    int channels = 1;

    /// Whether both are filled by the same pass.
    bool same_pass(const Subject& other) const {
        return shader == other.shader && constants == other.constants && picture.paint == other.picture.paint;
    }
};

/// The subjects of a document: the picture, and its rival in the split view.
std::vector<Subject> subjects(const Document& document);

/// The same noise, in a plane whatever the view: for the law of its values.
Subject in_plane(Subject subject);

/// What decides the pixels of a view beside its places.
struct Look {
    ViewPush push{};
    std::vector<render::PassLobe> lobes;
};

Look look_of(const Subject& subject, const Document& document, Extent extent);

/// Where the columns, and then the rows, of a view are whose values are `stride` pixels apart.
struct Places {
    std::vector<AxisPlace> columns;
    std::vector<AxisPlace> rows;
};

Places places_of(const Subject& subject, const Document& document, Extent extent, int stride);

/// So many columns and rows at random within their cells, each pair of them independent of all others.
Places random_places(const Subject& subject, int columns, int rows, std::uint32_t draw);

} // namespace gabor::viewer
