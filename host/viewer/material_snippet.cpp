#include "viewer/material_snippet.hpp"

#include "noise/glsl_literal.hpp"
#include "viewer/drawing.hpp"

#include "passes/material_interface.h"

#include <fmt/format.h>

#include <algorithm>

namespace gabor::viewer {

namespace {

using noise::literal;
using noise::vec2;

// A call at a place, with the steps to the next pixels where it is filtered.
std::string call(const render::Request& request, std::string_view p, std::string_view dx,
                 std::string_view dy) {
    std::string function = request.material;
    std::ranges::replace(function, '-', '_');
    return request.filter
               ? fmt::format("gabor_{}_filtered({}, {}, {}, {}u)", function, p, dx, dy, request.seed)
               : fmt::format("gabor_{}({}, {}u)", function, p, request.seed);
}

std::string of_body(const render::Request& request) {
    const auto on = [&](std::string_view plane) {
        return call(request, plane, fmt::format("dFdx({})", plane), fmt::format("dFdy({})", plane));
    };
    return fmt::format(R"(
// p: a point of the body, in units of the material. normal: of the surface there, of length 1. The material lies on the
// planes of the axes, and is seen on those that the surface faces.
GaborMaterial material_of_body(vec3 p, vec3 normal)
{{
    vec3 share = pow(abs(normal), vec3(8.0));
    share /= share.x + share.y + share.z;
    vec2 on_x = vec2(p.y, -p.z);
    vec2 on_y = vec2(p.x, -p.z);
    vec2 on_z = p.xy;
    GaborMaterial x = {};
    GaborMaterial y = {};
    GaborMaterial z = {};
    return GaborMaterial(share.x * x.colour + share.y * y.colour + share.z * z.colour,
                         dot(share, vec3(x.height, y.height, z.height)),
                         dot(share, vec3(x.roughness, y.roughness, z.roughness)),
                         dot(share, vec3(x.metalness, y.metalness, z.metalness)));
}}
)",
                       on("on_x"), on("on_y"), on("on_z"));
}

std::string of_plane(const render::Request& request, const passes::MaterialPush& push, Extent extent) {
    std::string text = fmt::format(R"(
// pixel: the place in a picture of {} x {}, in pixels from its upper left corner, y growing downwards.
GaborMaterial material_of_view(vec2 pixel)
{{
)",
                                   extent.width, extent.height);
    if (push.sky > 0)
        text += fmt::format(
            "    vec2 at = pixel - {0};\n"
            "    float near = {1} / max(at.y, 1e-3); // units of the material per pixel; above is the sky\n"
            "    vec2 p = {2} + near * vec2(at.x, {3});\n"
            "    vec2 dx = vec2(near, 0.0);\n"
            "    vec2 dy = near / max(at.y, 1e-3) * vec2(-at.x, {4});\n",
            vec2(double{push.center.x}, double{push.sky}), literal(double{push.pixel}),
            vec2(double{push.corner.x}, double{push.corner.y}), literal(-extent.width),
            literal(extent.width));
    else
        text += fmt::format("    vec2 p = {0} + {1} * pixel;\n"
                            "    vec2 dx = vec2({1}, 0.0);\n"
                            "    vec2 dy = vec2(0.0, {1});\n",
                            vec2(double{push.corner.x}, double{push.corner.y}), literal(double{push.pixel}));
    return text + fmt::format("    return {};\n}}\n", call(request, "p", "dx", "dy"));
}

} // namespace

std::string material_snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const std::string text = R"(// A material of Gabor noise, as gabor-viewer showed it: put after #version.
#include "gabor_lattice.glsl" // or paste it here
#include "gabor_spectrum.glsl" // and this one
#include "gabor_materials.glsl" // and this one
)";
    if (render::in_space(request))
        return text + of_body(request);
    const render::Plan plan =
        render::plan(request, viewport_of(drawing_of(document), document.camera, extent));
    const auto push = render::values_of<passes::MaterialPush>(plan.steps.front().push).front();
    return text + of_plane(request, push, extent);
}

} // namespace gabor::viewer
