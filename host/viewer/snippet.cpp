#include "viewer/snippet.hpp"

#include "fit/glsl.hpp"
#include "noise/glsl_literal.hpp"
#include "viewer/display.hpp"
#include "viewer/drawing.hpp"
#include "viewer/embedded.hpp"

#include "passes/material_interface.h"
#include "passes/pixels_interface.h"
#include "passes/solid_interface.h"
#include "passes/terrain_interface.h"
#include "viewer/display_interface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gabor::viewer {

namespace {

using noise::literal;
using noise::vec2;
using noise::vec3;

// A quantity that an output shows, summed over the waves.
struct Quantity {
    std::string_view is;
    std::string_view type;
    std::string_view name;  // start of its function's name: NAME_of_wave, NAME_of_view or NAME_of_body
    std::string_view plane; // GLSL in the plane, from a GaborField `field`, and `removed` if filtered
    std::string_view space; // GLSL in space, from a GaborField3d `field`
    std::string_view sky;   // the quantity above a horizon
};

namespace quantities {

constexpr Quantity value{
    "The noise, of mean 0 and variance 1.", "float", "noise", "field.value.y", "field.noise", "0.0"};
constexpr Quantity gradient{"The gradient, per kernel radius.",       "vec2",           "gradient",
                            "vec2(field.slope_x.y, field.slope_y.y)", "field.gradient", "vec2(0.0)"};
constexpr Quantity relief{"The gradient, per kernel radius, and the noise.",
                          "vec4",
                          "relief",
                          "vec4(field.slope_x.y, field.slope_y.y, 0.0, field.value.y)",
                          "vec4(field.gradient, field.noise)",
                          "vec4(0.0)"};
constexpr Quantity complex_value{"The noise as a complex number: its quadrature, and the noise itself.",
                                 "vec2",
                                 "complex",
                                 "field.value",
                                 "vec2(field.quadrature, field.noise)",
                                 "vec2(0.0)"};
constexpr Quantity removed{
    "The share of the variance that the filter removed.", "float", "removed", "removed", "0.0", "1.0"};

// Computed from each wave's quadrature, noise and removed share of the variance.
constexpr Quantity colour{"The colour.",
                          "vec3",
                          "colour",
                          "vec3(field.value, removed)",
                          "vec3(field.quadrature, field.noise, field.removed)",
                          "noise_colour(vec3(0.0), vec3(1.0))"};

} // namespace quantities

const Quantity& quantity(const Document& document) {
    switch (document.output) {
    case Output::lit:
        return quantities::relief;
    case Output::gradient:
        return quantities::gradient;
    case Output::phase:
    case Output::intensity:
    case Output::phasor:
    case Output::lit_phasor:
        return quantities::complex_value;
    case Output::variance:
        return quantities::removed;
    default:
        return document.request.colour ? quantities::colour : quantities::value;
    }
}

render::Plan pixel_plan(const render::Request& request) {
    render::Viewport viewport = viewport_of(request, {0, 0, 1, 1});
    viewport.blocks = render::Blocks::none;
    return render::plan(request, viewport);
}

// The waves in a table of the plan.
template <typename Wave>
std::vector<Wave> waves_of(const render::Request& request, std::size_t table) {
    return render::values_of<Wave>(pixel_plan(request).tables.at(table));
}

// Declares the sums. `type` is the GLSL type of the quantity, which for a gradient in space is not `of.type`.
std::string sums(const Quantity& of, std::string_view type) {
    if (&of == &quantities::colour)
        return "    vec3 wave, z = vec3(0.0), removed = vec3(0.0);\n";
    return fmt::format("    {0} sum = {0}(0.0);\n", type);
}

// The factor of a wave's derivatives, which the drop-in returns per radius of the wave's kernels.
std::string per_radius(double amplitude, float radius) {
    return literal(amplitude / radius);
}

std::string per_radius(double amplitude, const passes::vec2& radius) {
    return vec2(amplitude / radius.x, amplitude / radius.y);
}

// Adds a wave to the sums. `call` is the GLSL expression of the wave's quantity.
template <typename Wave>
std::string added(const Quantity& of, const Wave& wave, const std::string& call) {
    if (&of == &quantities::colour) {
        const auto weights = [&](auto of_weight) {
            return vec3(of_weight(wave.weights[0]), of_weight(wave.weights[1]), of_weight(wave.weights[2]));
        };
        return fmt::format(
            "    wave = {};\n    z += wave.x * {} + wave.y * {};\n    removed += wave.z * {};\n", call,
            weights([](const passes::vec2& w) { return w.x; }),
            weights([](const passes::vec2& w) { return w.y; }),
            weights([](const passes::vec2& w) { return w.x * w.x + w.y * w.y; }));
    }
    const double amplitude = wave.amplitude;
    if (&of == &quantities::relief)
        return fmt::format("    sum += vec4({}, {}) * {};\n",
                           std::is_same_v<Wave, passes::SolidWave>
                               ? fmt::format("vec3({})", per_radius(amplitude, wave.radius))
                               : per_radius(amplitude, wave.radius) + ", 0.0",
                           literal(amplitude), call);
    const std::string factor = &of == &quantities::gradient  ? per_radius(amplitude, wave.radius)
                               : &of == &quantities::removed ? literal(amplitude * amplitude)
                                                             : literal(amplitude);
    return fmt::format("    sum += {}{};\n", factor == literal(1) ? "" : factor + " * ", call);
}

std::string_view summed(const Quantity& of) {
    return &of == &quantities::colour ? "    return noise_colour(z, removed);\n}\n" : "    return sum;\n}\n";
}

// The GLSL function for one wave, in the wave's own kernel radii.
std::string of_wave(const render::Request& request, const Quantity& of) {
    const std::string_view sharp = "    GaborField field = gabor_field(place, kernel, seed);\n";
    const std::string_view filtered =
        "    float removed; // share of the variance\n"
        "    GaborField field = gabor_field_filtered(place, kernel, footprint, seed, removed);\n";
    std::string made(of.plane);
    if (const std::size_t at = made.find("removed"); at != std::string::npos && !request.filter)
        made.replace(at, std::string_view("removed").size(), "0.0");
    return fmt::format(
        R"(
{} {}_of_wave(GaborPlace place,{} float frequency, float orientation, uint seed)
{{
    GaborKernel kernel = gabor_kernel(frequency, orientation);
{}    return {};
}}
)",
        of.type, of.name, request.filter ? " GaborFootprint footprint," : "",
        request.filter ? filtered : sharp, made);
}

std::string of_plane(const Document& document, const Quantity& of, Extent extent) {
    render::Request request = document.request;
    request.paint.clear();
    if (&of != &quantities::colour)
        request.colour.reset();
    const double scale = request.scale * document.camera.zoom;
    const bool horizon = std::holds_alternative<render::Horizon>(request.view);
    std::string text = of_wave(request, of);
    text += fmt::format(R"(
// {}
// pixel: a position in a picture of {} x {}, in pixels from the upper left corner, with y pointing down.
{} {}_of_view(vec2 pixel)
{{
)",
                        of.is, extent.width, extent.height, of.type, of.name);
    if (horizon) {
        const double sky = render::sky_rows(extent.height);
        text += fmt::format(R"(    vec2 at = pixel - {};
    if (at.y <= 0.0)
        return {};
    float near = {} / at.y; // kernel radii per pixel
    vec2 p = near * vec2(at.x, {}); // from the camera, in kernel radii
)",
                            vec2(extent.width / 2.0, sky), of.sky,
                            literal((extent.height - 0.5 - sky) / scale), literal(-extent.width));
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

    // The middle of the first pixel or, in perspective, the position of the camera.
    const auto corner = [&](const Coordinate& middle, int pixels, double cells) {
        return render::cell_at(horizon ? middle : middle.moved((0.5 - pixels / 2.0) / scale), cells);
    };
    const double time = render::wrapped_time(request);
    const std::string moment = (!request.recipe.is_lattice() ? ""
                                : time != 0                  ? "true, "
                                                             : "false, ") +
                               literal(time);
    text += sums(of, of.type) + "    GaborPlace place;\n";
    if (request.filter)
        text += "    GaborFootprint footprint;\n";
    int table = -1;
    for (const passes::PixelsWave& wave : waves_of<passes::PixelsWave>(request, 2)) {
        if (wave.table != table) { // another kernel radius
            table = wave.table;
            const double x_cells = double{wave.nodes.x} / wave.radius.x; // per kernel radius of the picture
            const double y_cells = double{wave.nodes.y} / wave.radius.y;
            const auto [x, x_place] = corner(document.camera.x, extent.width, x_cells);
            const auto [y, y_place] = corner(document.camera.y, extent.height, y_cells);
            text +=
                fmt::format("    place = GaborPlace(ivec2({}, {}), {} + p * {}, {}, ivec2({}, {}), {});\n", x,
                            y, vec2(x_place, y_place), vec2(x_cells, y_cells),
                            vec2(wave.nodes.x, wave.nodes.y), wave.period.x, wave.period.y, moment);
            if (request.filter) {
                const std::string unit =
                    vec2(x_cells / request.recipe.radius, y_cells / request.recipe.radius);
                text += fmt::format("    footprint = gabor_footprint(dx * {0}, dy * {0});\n", unit);
            }
        }
        // The wave vector per kernel radius along each axis.
        const double x = std::cos(double{wave.orientation});
        const double y = std::sin(double{wave.orientation}) * wave.radius.y / wave.radius.x;
        text += added(
            of, wave,
            fmt::format("{}_of_wave(place,{} {}, {}, {}u)", of.name, request.filter ? " footprint," : "",
                        literal(wave.frequency * std::hypot(x, y)), literal(std::atan2(y, x)), wave.seed));
    }
    return text.append(summed(of));
}

// The beginning of a GLSL call to the noise in space that a wave needs.
std::string field_in_space(const render::Request& request, const passes::SolidWave& wave) {
    const bool on_surface = render::along_surface(request);
    const std::string frequency = literal(wave.frequency);
    const std::string direction =
        fmt::format("vec3({}, {}, 0.0)", literal(wave.direction.x), literal(wave.direction.y));
    if (on_surface && wave.isotropic == 1)
        return fmt::format("gabor_field_surface_isotropic(place, normal, {}", frequency);
    if (on_surface)
        return fmt::format("gabor_field_surface(place, normal, {}, {}", frequency, direction);
    if (wave.isotropic == 1)
        return fmt::format("gabor_field_3d_isotropic(place, {}", frequency);
    return fmt::format("gabor_field_3d(place, {}, {}", frequency, direction);
}

std::string of_space(const render::Request& request, const Quantity& of) {
    const std::string_view type = &of == &quantities::gradient ? "vec3" : of.type;
    std::string settings;
    if (const double time = render::wrapped_time(request); time != 0)
        settings += fmt::format("    place.animated = true;\n    place.time = {};\n", literal(time));
    std::string text = fmt::format(R"(
// {}
// p: a point on or in the body, in kernel radii. normal: the unit normal of the surface there.
{} {}_of_body(vec3 p, vec3 normal)
{{
{}    GaborPlace3d place;
    GaborField3d field;
)",
                                   of.is, type, of.name, sums(of, type));
    float radius = 0;
    for (const passes::SolidWave& wave : waves_of<passes::SolidWave>(request, 0)) {
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
        text += fmt::format("    field = {}, {}u);\n{}", field_in_space(request, wave), wave.seed,
                            added(of, wave, std::string(of.space)));
    }
    return text.append(summed(of));
}

// The distance from the eye to the middle of a body, in radii of the sphere, as in passes/body.glsl.
constexpr double eye_distance = 4;

// The push constants of the pass that draws the window's picture.
template <typename Push>
Push push_of(const Document& document, Extent extent) {
    const Drawing drawing = drawing_of(document);
    const render::Plan plan = render::plan(drawing.request, viewport_of(drawing, document.camera, extent));
    return render::values_of<Push>(plan.steps.front().push).front();
}

// The picture's axes to the right, down and towards the eye.
template <typename Push>
std::string axes_of(const render::Request& request, const Push& push) {
    if (!std::holds_alternative<render::Body>(request.view))
        return "mat3(1.0)";
    const auto [cos_yaw, sin_yaw] = std::pair(double{push.yaw.x}, double{push.yaw.y});
    const auto [cos_pitch, sin_pitch] = std::pair(double{push.pitch.x}, double{push.pitch.y});
    return fmt::format("mat3({}, {}, {})", vec3(cos_yaw, sin_yaw, 0),
                       vec3(sin_yaw * sin_pitch, -cos_yaw * sin_pitch, -cos_pitch),
                       vec3(sin_yaw * cos_pitch, -cos_yaw * cos_pitch, sin_pitch));
}

// The direction of the sky: up in the picture for bodies, towards the eye for planes.
std::string up_of(const render::Request& request) {
    return std::holds_alternative<render::Body>(request.view) ? "vec3(0.0, -1.0, 0.0)"
                                                              : "vec3(0.0, 0.0, 1.0)";
}

// The position of a point in the picture, measured from the picture's middle in units of its longer side.
std::string place_of(const render::Request& request, const passes::SolidPush& push, Extent extent) {
    const double longer = std::max(extent.width, extent.height);
    const double pixel = double{push.pixel} * longer;
    if (std::holds_alternative<render::Body>(request.view))
        return fmt::format("(p * axes).xy / ({} * ({} - dot(p, axes[2])))", literal(pixel),
                           literal(eye_distance * double{push.unit}));
    return fmt::format("p.xy / {} - {}", literal(pixel),
                       vec2((push.first_column + extent.width / 2.0) / longer,
                            (push.first_row + extent.height / 2.0) / longer));
}

// The position of a stop, rounded to the 8 bits that the window's shader has for it.
double shown_place(const ColourStop& stop) {
    return std::round(255 * double{stop.at}) / 255;
}

// A GLSL function for the user's colour map.
std::string own_colours(const std::vector<ColourStop>& ramp) {
    const auto colour = [](const ColourStop& stop) {
        return vec3(double{stop.colour[0]}, double{stop.colour[1]}, double{stop.colour[2]});
    };
    std::string text =
        fmt::format("vec3 viewer_own_colour(float t)\n{{\n    vec3 colour = {};\n", colour(ramp[0]));
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        const double from = shown_place(ramp[i - 1]);
        text +=
            fmt::format("    colour = mix(colour, {}, clamp((t - {}) / {}, 0.0, 1.0));\n", colour(ramp[i]),
                        literal(from), literal(std::max(shown_place(ramp[i]) - from, 0.001)));
    }
    return text + "    return colour;\n}\n";
}

std::string_view shader(std::string_view name) {
    const std::span<const unsigned char> bytes = embedded(name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string lighting(const render::Request& request) {
    return fmt::format("const int environment = {};\n\n{}\n", request.environment, shader("light.glsl"));
}

// The GLSL functions for the colours that the window shows.
std::string of_colours(const Document& document, const Quantity& of, Extent extent) {
    const render::Request& request = document.request;
    const bool space = render::in_space(request);
    const bool lit = is_lit(document);
    const bool lit_stripes = document.output == Output::lit_phasor;
    const double scale = request.scale * document.camera.zoom;
    const std::string contrast = literal(document.contrast);
    const bool own = document.colours == passes::own_colours;
    const auto mapped = [&](const std::string& share) {
        return own ? fmt::format("viewer_own_colour({})", share)
                   : fmt::format("viewer_colour({}, {})", document.colours, share);
    };
    const auto stripes = [&](std::string_view value) {
        return fmt::format("viewer_stripes({}, {}, {})", value, document.profile,
                           literal(stripe_turns(request) / document.camera.zoom));
    };
    std::string text = fmt::format("\n{}\n", shader("colours.glsl"));
    if (own)
        text += own_colours(document.ramp) + "\n";
    if (lit)
        text += lighting(request);
    if (lit_stripes)
        text += fmt::format("float stripes_of_{0})\n{{\n    return {1};\n}}\n\n",
                            space ? "body(vec3 p, vec3 normal" : "view(vec2 pixel",
                            stripes(space ? "complex_of_body(p, normal)" : "complex_of_view(pixel)"));
    text += "// The colour that the viewer showed there.\n";
    text += space ? "vec3 colour_of_body(vec3 p, vec3 normal)\n{\n" : "vec3 colour_of_view(vec2 pixel)\n{\n";
    const auto push = space ? push_of<passes::SolidPush>(document, extent) : passes::SolidPush{};
    if (space && (lit || of.name == quantities::gradient.name))
        text +=
            fmt::format("    mat3 axes = {}; // right, down and towards the eye\n", axes_of(request, push));
    if (space && of.name == quantities::gradient.name)
        text += "    vec2 seen = (gradient_of_body(p, normal) * axes).xy;\n";
    else if (!lit_stripes)
        text += fmt::format("    {} seen = {}_of_{};\n", of.type, of.name,
                            space ? "body(p, normal)" : "view(pixel)");
    if (lit) { // as in lit_surface of shaders/viewer/display.glsl
        const double relief = 0.5 * document.contrast / slope_deviation(request);
        const auto [right, below] = render::light_direction(request);
        text +=
            space
                ? fmt::format("    vec2 place = {};\n", place_of(request, push, extent))
                : fmt::format("    vec3 normal = vec3(0.0, 0.0, 1.0);\n    vec2 place = (pixel - {}) / {};\n",
                              vec2(extent.width / 2.0, extent.height / 2.0),
                              literal(std::max(extent.width, extent.height)));
        if (!lit_stripes)
            text += fmt::format("    vec3 slope = {} * seen.xyz{};\n    vec3 colour = {};\n", literal(relief),
                                space ? " * axes" : "",
                                mapped(fmt::format("viewer_value(seen.w, {})", contrast)));
        else // differences from the pixels to the left and above
            text += fmt::format(
                "    float height = stripes_of_{0};\n"
                "    vec3 slope = {1} * vec3(height - stripes_of_{2}, height - stripes_of_{3}, 0.0);\n"
                "    vec3 colour = {4};\n",
                space ? "body(p, normal)" : "view(pixel)", literal(2 * relief * scale),
                space ? "body(p - dFdx(p), normal)" : "view(pixel - vec2(1.0, 0.0))",
                space ? "body(p - dFdy(p) * sign(dot(dFdy(p), axes[1])), normal)"
                      : "view(pixel - vec2(0.0, 1.0))",
                mapped("height"));
        if (space)
            text += "    normal = normalize(normal * axes);\n";
        return text + fmt::format(R"(    normal = normalize(normal - (slope - dot(slope, normal) * normal));
    vec3 linear = pow(colour, vec3(2.2));
    return srgb(lit(Surface(linear, 0.45, 0.0), normal, eye_above(place), lamp_above(place, {}), {}));
}}
)",
                                  vec2(right, below), up_of(request));
    }
    const auto shown = [&] {
        switch (document.output) {
        case Output::gradient:
            return fmt::format("viewer_gradient(seen, {}, {}, {})", literal(slope_deviation(request)),
                               contrast, literal(document.directx_normals ? -1 : 1));
        case Output::phase:
            return fmt::format("viewer_phase(seen, {})", document.colours);
        case Output::phasor:
            return mapped(stripes("seen"));
        case Output::intensity:
            return mapped(fmt::format("viewer_intensity(seen, {})", contrast));
        case Output::variance:
            return mapped("viewer_variance(seen)");
        default:
            return mapped(fmt::format("viewer_value(seen, {})", contrast));
        }
    }();
    return text + fmt::format("    return {};\n}}\n", shown);
}

// Returns a GLSL function that sets the material's parameters and evaluates it.
std::string material_function(const render::Request& request) {
    std::string function = request.material;
    std::ranges::replace(function, '-', '_');
    std::string type = "Gabor";
    for (std::size_t i = 0; i < function.size(); ++i)
        if (function[i] != '_')
            type += i == 0 || function[i - 1] == '_'
                        ? static_cast<char>(std::toupper(static_cast<unsigned char>(function[i])))
                        : function[i];
    std::string text = fmt::format(R"(
// The material at p, in its own units; dx and dy lead to the next pixels.
GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy)
{{
    {} m = gabor_{}_default();
)",
                                   type, function);
    for (const render::Parameter& p : render::parameters()) {
        if (p.group != render::Parameter::Group::material || !render::is_set(request, p.name))
            continue;
        const render::Value value = *p.get(request);
        const auto* colour = std::get_if<std::array<double, 3>>(&value);
        const double number = colour ? 0 : std::get<double>(value);
        const bool angle = p.kind == render::Parameter::Kind::angle;
        text += fmt::format("    m.{} = {};\n", p.name.substr(p.name.find('.') + 1),
                            colour ? vec3((*colour)[0], (*colour)[1], (*colour)[2])
                                   : literal(angle ? noise::radians(number) : number));
    }
    text += fmt::format("    GaborPixel pixel = {};\n",
                        request.filter ? "gabor_pixel_filtered(p, dx, dy)" : "gabor_pixel(p)");
    const auto* plane = std::get_if<render::Plane>(&request.view);
    if (plane && plane->tileable)
        text += fmt::format("    pixel = gabor_pixel_tiled(pixel, {});\n",
                            vec2(request.width / request.scale, request.height / request.scale));
    return text + fmt::format("    return gabor_{}_at(pixel, m, {}u);\n}}\n\n", function, request.seed);
}

// The GLSL expression for what the window shows of a `relief`. `normal` and `slope` are along the axes of the
// picture.
std::string material_colour(const Document& document) {
    const auto [right, below] = render::light_direction(document.request);
    switch (document.look) {
    case Look::lit:
        return fmt::format("srgb(lit(Surface(m.colour, m.roughness, m.metalness), "
                           "bumped_normal(normal, slope), eye, lamp_above(place, {}), {}))",
                           vec2(right, below), up_of(document.request));
    case Look::colour:
        return "srgb(m.colour)";
    case Look::height:
        return fmt::format("vec3(0.5 + m.height / {})", literal(0.1 * double{document.contrast}));
    case Look::normal:
        return fmt::format("0.5 + 0.5 * normalize(vec3(-slope.xy, 1.0)) * vec3(1.0, {}, 1.0)",
                           document.directx_normals ? "1.0" : "-1.0");
    case Look::roughness:
        return "vec3(m.roughness)";
    case Look::metalness:
        break;
    }
    return "vec3(m.metalness)";
}

std::string material_snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const auto push = push_of<passes::MaterialPush>(document, extent);
    std::string text = fmt::format(
        R"(// A material of Gabor noise, as gabor-viewer showed it. Put this after #version.
#include "gabor_noise.glsl" // or paste it here
#include "gabor_spectrum.glsl" // and this one
#include "gabor_materials.glsl" // and this one
{}{}
{}
)",
        material_function(request), shader("relief.glsl"), lighting(request));
    const double wide = double{push.size.x};
    const std::string pixel = literal(double{push.pixel});
    const std::string corner = vec2(double{push.corner.x}, double{push.corner.y});
    const bool body = render::in_space(request);
    const bool horizon = push.sky > 0;
    if (body)
        text += fmt::format(
            R"(// The colour that the viewer showed there, for fragment shaders. p: a point of the body, in units of the material.
// normal: the unit normal of the surface there.
vec3 colour_of_body(vec3 p, vec3 normal)
{{
    mat3 axes = {}; // right, down and towards the eye
    Relief relief = relief_at(p, dFdx(p), dFdy(p), normal, true);
    normal = normal * axes;
    vec3 slope = relief.slope * axes;
    vec3 eye = normalize(vec3(0.0, 0.0, {}) - p * axes);
)",
            axes_of(request, push), literal(eye_distance * double{push.unit}));
    else
        text += fmt::format(
            R"(// The colour that the viewer showed there. pixel: a position in a picture of {} x {}, in pixels from the
// upper left corner, with y pointing down.
vec3 colour_of_view(vec2 pixel)
{{
    vec3 normal = vec3(0.0, 0.0, 1.0);
)",
            extent.width, extent.height);
    if (horizon)
        text += fmt::format("    vec2 at = pixel - {};\n"
                            "    if (at.y <= 0.0)\n"
                            "        return {};\n"
                            "    float near = {} / at.y;\n"
                            "    vec2 p = {} + near * vec2(at.x, {});\n"
                            "    vec2 dx = vec2(near, 0.0), dy = near / at.y * vec2(-at.x, {});\n"
                            "    vec3 eye = normalize(vec3(-at.x, {}, at.y));\n",
                            vec2(double{push.center.x}, double{push.sky}),
                            document.look == Look::lit
                                ? fmt::format("srgb(sky_colour(-at.y / {}))", literal(double{push.sky}))
                                : "vec3(0.0)",
                            pixel, corner, literal(-wide), literal(wide), literal(wide));
    else if (!body)
        text += fmt::format("    vec2 p = {} + {} * pixel;\n"
                            "    vec2 dx = vec2({}, 0.0), dy = dx.yx;\n",
                            corner, pixel, pixel);
    if (!body)
        text += "    Relief relief = relief_at(vec3(p, 0.0), vec3(dx, 0.0), vec3(dy, 0.0), normal, false);\n"
                "    vec3 slope = relief.slope;\n";
    if (body || horizon)
        text += "    vec2 place = vec2(0.0); // below the lamp\n";
    else
        text += fmt::format("    vec2 place = (pixel - {}) / {};\n"
                            "    vec3 eye = eye_above(place);\n",
                            vec2(double{push.center.x}, double{push.center.y}),
                            literal(2.0 * double{std::max(push.center.x, push.center.y)}));
    return text + fmt::format("    GaborMaterial m = relief.material;\n    return {};\n}}\n",
                              material_colour(document));
}

std::string terrain_snippet(const Document& document, Extent extent) {
    const auto push = push_of<passes::TerrainPush>(document, extent);
    const render::Terrain& terrain = std::get<render::Terrain>(document.request.view);
    std::vector<std::string> members;
    for (const render::Parameter& p : render::parameters())
        if (p.group == render::Parameter::Group::erosion) {
            const double value = std::get<double>(*p.get(document.request));
            members.push_back(p.kind == render::Parameter::Kind::integer ? fmt::format("{}", value)
                                                                         : literal(value));
        }
    const auto pair = [](const passes::vec2& v) { return vec2(double{v.x}, double{v.y}); };
    const std::string pixel = literal(double{push.pixel});
    const std::string seen =
        terrain.perspective
            ? fmt::format("    vec2 yaw = {}, pitch = {};\n"
                          "    vec3 eye = {} + {} * camera_at(yaw, pitch);\n"
                          "    vec3 ray = camera_ray(yaw, pitch, {} * (pixel - {}));\n"
                          "    vec3 light = seen_along(ground, eye, ray, {}, {}).light;\n",
                          pair(push.yaw), pair(push.pitch), vec3(push.corner.x, 0, push.corner.y),
                          literal(double{push.distance}), pixel, pair(push.center), pixel,
                          literal(double{push.distance}))
            : fmt::format("    vec3 light = seen_from_above(ground, {} + {} * pixel, {}).light;\n",
                          pair(push.corner), pixel, pixel);
    return fmt::format(R"(// Eroded mountains, as gabor-viewer showed them. Put this after #version.
#include "gabor_noise.glsl" // or paste it here
#include "gabor_erosion.glsl" // and this one

{}
// The colour for the screen. pixel: a position in a picture of {} x {}, in pixels from the upper left corner,
// with y pointing down.
vec3 colour_of_view(vec2 pixel)
{{
    GaborErosion erosion = GaborErosion({});
    Ground ground = Ground(ivec2({}, {}), {}, {}u, erosion, {}, {});
{}    light = clamp(light, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}}
)",
                       shader("landscape.glsl"), extent.width, extent.height, fmt::join(members, ", "),
                       push.cell.x, push.cell.y, pair(push.period), push.seed, literal(double{push.reach}),
                       pair(push.sun), seen);
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    if (render::has_terrain(request))
        return terrain_snippet(document, extent);
    if (render::has_material(request))
        return material_snippet(document, extent);
    const bool space = render::in_space(request);
    const noise::Recipe recipe = render::drawing_recipe(request);
    const Quantity& of = quantity(document);
    std::string text = "// Gabor noise, as gabor-viewer showed it. Put this after #version.\n";
    for (const noise::Macro& macro : noise::macros(recipe))
        text += fmt::format("#define {} {}\n", macro.name, macro.value);
    if (!request.paint.empty())
        text += "// The paint is left out: frequency and orientation are the same everywhere.\n";
    text += fmt::format("#include \"{}\" // or paste it here\n", noise::drop_in(recipe));
    if (space || request.filter)
        text += "#include \"gabor_spectrum.glsl\" // and this one\n";
    if (space)
        text += "#include \"gabor_noise_3d.glsl\" // and this one\n";
    if (&of == &quantities::colour)
        text += fit::colour_function("noise", *request.colour);
    text += space ? of_space(request, of) : of_plane(document, of, extent);
    return &of == &quantities::colour ? text : text + of_colours(document, of, extent);
}

} // namespace gabor::viewer
