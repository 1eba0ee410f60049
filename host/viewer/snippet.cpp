#include "viewer/snippet.hpp"

#include "viewer/glsl_literal.hpp"
#include "viewer/noise_pass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gabor::viewer {

namespace {

// A function for one noise of the sum, in kernel radii of its own.
std::string of_wave(const render::Request& request) {
    const bool lattice = request.recipe.is_lattice();
    return fmt::format(R"(
float noise_of_wave(GaborPlace place,{} float frequency, float orientation, uint seed)
{{
    GaborKernel kernel = gabor_kernel(frequency, orientation);
{}{}    return {};
}}
)",
                       request.filter ? " GaborFootprint footprint," : "",
                       lattice ? "    kernel = gabor_kernel_stretched(kernel, place.radius);\n" : "",
                       request.filter ? "    float removed; // share of the variance\n" : "",
                       request.filter
                           ? "gabor_field_filtered(place, kernel, footprint, seed, removed).value.y"
                           : "gabor_field(place, kernel, seed).value.y");
}

std::string of_plane(const Document& document, Extent extent) {
    render::Request request = document.request;
    request.paint.clear();
    request.colour.reset();
    const double scale = request.scale * document.camera.zoom;
    const bool horizon = std::holds_alternative<render::Horizon>(request.view);
    std::string text = of_wave(request);
    text += fmt::format(R"(
// pixel: the place in a picture of {} x {}, in pixels from its upper left corner, y growing downwards.
// Mean 0, variance 1; gabor_unorm(noise_of_view(pixel)) is what to show.
float noise_of_view(vec2 pixel)
{{
)",
                        extent.width, extent.height);
    if (horizon) {
        const double sky = render::sky_rows(extent.height);
        text += fmt::format(R"(    vec2 at = pixel - {};
    if (at.y <= 0.0)
        return 0.0;
    float near = {} / at.y; // kernel radii per pixel
    vec2 p = near * vec2(at.x, {}); // from the camera, in kernel radii
)",
                            vec2(extent.width / 2.0, sky), literal((extent.height - 0.5 - sky) / scale),
                            literal(-extent.width));
        if (request.filter)
            text +=
                fmt::format("    vec2 dx = vec2(near, 0.0);\n    vec2 dy = near / at.y * vec2(-at.x, {});\n",
                            literal(extent.width));
    } else {
        text += fmt::format("    vec2 p = (pixel - 0.5) * {}; // from the first pixel, in kernel radii\n",
                            literal(1 / scale));
        if (request.filter)
            text +=
                fmt::format("    vec2 dx = {};\n    vec2 dy = {};\n", vec2(1 / scale, 0), vec2(0, 1 / scale));
    }

    // The middle of the first pixel; or where the camera stands.
    const auto corner = [&](const Coordinate& middle, int pixels, double cells) {
        return axis_point(middle, horizon ? 0 : (0.5 - pixels / 2.0) / scale, cells);
    };
    const double time = render::wrapped_time(request);
    const std::string moment = (!request.recipe.is_lattice() ? ""
                                : time != 0                  ? "true, "
                                                             : "false, ") +
                               literal(time);
    text += "    float noise = 0.0;\n    GaborPlace place;\n";
    if (request.filter)
        text += "    GaborFootprint footprint;\n";
    int table = -1;
    for (const passes::PixelsWave& wave : render::pixels_waves(request, render::Paint())) {
        if (wave.table != table) { // another kernel radius
            table = wave.table;
            const double x_cells = double{wave.nodes.x} / wave.radius; // per kernel radius of the picture
            const double y_cells = double{wave.nodes.y} / wave.radius;
            const passes::Line x = corner(document.camera.x, extent.width, x_cells);
            const passes::Line y = corner(document.camera.y, extent.height, y_cells);
            text +=
                fmt::format("    place = GaborPlace(ivec2({}, {}), {} + p * {}, {}, ivec2({}, {}), {});\n",
                            x.cell, y.cell, vec2(x.local, y.local), vec2(x_cells, y_cells),
                            vec2(wave.nodes.x, wave.nodes.y), wave.period.x, wave.period.y, moment);
            if (request.filter) {
                const std::string unit =
                    vec2(x_cells / request.recipe.radius, y_cells / request.recipe.radius);
                text += fmt::format("    footprint = gabor_footprint(dx * {0}, dy * {0});\n", unit);
            }
        }
        text += fmt::format("    noise += {}noise_of_wave(place,{} {}, {}, {}u);\n",
                            wave.amplitude == 1 ? "" : literal(wave.amplitude) + " * ",
                            request.filter ? " footprint," : "", literal(wave.frequency),
                            literal(wave.orientation), wave.seed);
    }
    return text + "    return noise;\n}\n";
}

// In space there are several kinds of noise.
std::string noise_in_space(const render::Request& request, const passes::SolidWave& wave) {
    const render::Body* body = std::get_if<render::Body>(&request.view);
    const bool on_surface = body && !body->solid;
    const std::string frequency = literal(wave.frequency);
    const std::string direction =
        fmt::format("vec3({}, {}, 0.0)", literal(wave.direction.x), literal(wave.direction.y));
    if (on_surface && wave.isotropic == 1)
        return fmt::format("gabor_surface_isotropic_3d(place, normal, {}", frequency);
    if (on_surface)
        return fmt::format("gabor_surface_3d(place, normal, {}, {}", frequency, direction);
    if (wave.isotropic == 1)
        return fmt::format("gabor_isotropic_3d(place, {}", frequency);
    return fmt::format("gabor_field_3d(place, gabor_wave_3d({}, {})", frequency, direction);
}

std::string of_space(const render::Request& request) {
    std::string settings;
    if (const double time = render::wrapped_time(request); time != 0)
        settings += fmt::format("    place.animated = true;\n    place.time = {};\n", literal(time));
    std::string text = R"(#include "gabor_lattice_3d.glsl" // and this one

// p: a point on or in the body, in kernel radii. normal: of the surface there, of length 1.
// Mean 0, variance 1; gabor_unorm(noise_of_body(p, normal)) is what to show.
float noise_of_body(vec3 p, vec3 normal)
{
    float noise = 0.0;
    GaborPlace3d place;
)";
    float radius = 0;
    for (const passes::SolidWave& wave : render::solid_waves(request)) {
        if (wave.radius != radius) {
            radius = wave.radius;
            const std::string unit = radius == 1 ? "" : fmt::format(" / {}", literal(radius));
            text +=
                fmt::format("    place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS{});\n{}", unit, settings);
            if (request.filter)
                text += fmt::format("    place.filtered = true;\n"
                                    "    place.dx = dFdx(p){0}; // in a fragment shader\n"
                                    "    place.dy = dFdy(p){0};\n",
                                    unit);
        }
        text += fmt::format("    noise += {}{}, {}u).value.y;\n",
                            wave.amplitude == 1 ? "" : literal(wave.amplitude) + " * ",
                            noise_in_space(request, wave), wave.seed);
    }
    return text + "    return noise;\n}\n";
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const bool space = render::in_space(request);
    const noise::Recipe recipe = render::drawing_recipe(request);
    std::string text = "// Gabor noise, as gabor-viewer showed it: put after #version.\n";
    for (const noise::Macro& macro : noise::macros(recipe))
        text += fmt::format("#define {} {}\n", macro.name, macro.value);
    if (!request.paint.empty())
        text += "// Frequency and orientation were painted; here they are those beside the paint.\n";
    text += fmt::format("#include \"{}\" // or paste it here\n", noise::drop_in(recipe));
    if (request.filter && !space)
        text += "#include \"gabor_spectrum.glsl\" // and this one\n";
    return text + (space ? of_space(request) : of_plane(document, extent));
}

} // namespace gabor::viewer
