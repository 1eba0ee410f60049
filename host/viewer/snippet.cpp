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

using noise::vec3;

// A number or a vector as a GLSL literal; other values unchanged.
template <typename T>
decltype(auto) written(const T& value) {
    if constexpr (std::is_floating_point_v<T>)
        return noise::literal(double{value});
    else if constexpr (std::is_same_v<T, passes::vec2>)
        return noise::vec2(double{value.x}, double{value.y});
    else if constexpr (std::is_same_v<T, std::array<double, 2>>)
        return noise::vec2(value[0], value[1]);
    else
        return (value);
}

// Formats GLSL, with `values` written as literals.
template <typename... Values>
std::string glsl(std::string_view text, const Values&... values) {
    return fmt::format(fmt::runtime(text), written(values)...);
}

// A shader that passes and copied code share.
std::string shader(std::string_view name) {
    const std::span<const unsigned char> bytes = embedded(name);
    return fmt::format("\n{}", std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string lighting(const render::Request& request) {
    return fmt::format("\nconst int environment = {};\n{}{}", request.environment, shader("srgb.glsl"),
                       shader("light.glsl"));
}

// Includes of drop-ins, for those who have the files.
std::string includes(const std::vector<std::string_view>& drop_ins) {
    std::string text;
    for (const std::string_view name : drop_ins)
        text += fmt::format("#include \"{}\" // or paste it here\n", name);
    return text;
}

// The push constants of the pass that draws the window's picture.
template <typename Push>
Push push_of(const Document& document, Extent extent) {
    const Drawing drawing = drawing_of(document);
    const render::Plan plan = render::plan(drawing.request, viewport_of(drawing, document.camera, extent));
    return render::values_of<Push>(plan.steps.front().push).front();
}

// Where the copied functions take the noise: their names' ends, parameters and arguments.
struct Place {
    std::string_view name;
    std::string_view parameters;
    std::string_view arguments;
};
constexpr Place in_view{"view", "vec2 pixel", "pixel"};
constexpr Place on_body{"body", "vec3 p, vec3 normal", "p, normal"};

const Place& place_of(const render::Request& request) {
    return render::in_space(request) ? on_body : in_view;
}

// What the parameters of the copied functions mean.
std::string parameters_are(const render::Request& request, Extent extent, std::string_view unit) {
    if (render::in_space(request))
        return fmt::format("// p: a point on or in the body, in {}. normal: the unit normal there.\n", unit);
    return fmt::format("// pixel: a position in a picture of {} x {}, in pixels from the upper left corner, "
                       "with y pointing down.\n",
                       extent.width, extent.height);
}

bool is_body(const render::Request& request) {
    return std::holds_alternative<render::Body>(request.view);
}

// ---- The noise ----

// Whether the window shows the noise as a photograph's colours.
bool is_coloured(const Document& document) {
    return document.request.colour && document.output == Output::value;
}

// The waves in a table of the plan that draws pixel by pixel.
template <typename Wave>
std::vector<Wave> waves_of(const render::Request& request, std::size_t table) {
    render::Viewport viewport = viewport_of(request, {0, 0, 1, 1});
    viewport.blocks = render::Blocks::none;
    return render::values_of<Wave>(render::plan(request, viewport).tables.at(table));
}

// Adds a GaborField or GaborField3d, `field`, to the sum. `radii` is a GLSL vec3.
template <typename Wave>
std::string added(const render::Request& request, const Wave& wave, std::string_view field,
                  std::string_view radii) {
    const auto& [a, b, c] = wave.weights;
    return request.colour ? glsl("    add_weighted(sum, {}, vec2[3]({}, {}, {}));\n", field, a, b, c)
                          : glsl("    add_noise(sum, {}, {}, {});\n", field, wave.amplitude, radii);
}

// The horizon or the flat plane that `pixel` shows, as a Footprint `here`.
std::string footprint_of(const Document& document, Extent extent) {
    const double pixel = 1 / (document.request.scale * document.camera.zoom); // in kernel radii
    if (!render::in_perspective(document.request))
        return glsl(
            "    Footprint here = footprint_from_above((pixel - 0.5) * {0}, {0}); // from the first pixel\n",
            pixel);
    const double sky = render::sky_rows(extent.height);
    return glsl("    vec2 at = pixel - {};\n"
                "    if (at.y <= 0.0)\n"
                "        return {};\n"
                "    Footprint here = footprint_below_horizon(at, {}, {}); // from the camera\n",
                std::array{extent.width / 2.0, sky},
                document.request.colour ? "noise_colour(vec3(0.0), vec3(1.0))"
                                        : "Noise(vec2(0.0), vec3(0.0), 1.0)",
                (extent.height - 0.5 - sky) * pixel, double(extent.width));
}

// Sets the place of a wave and the following ones with the same kernel radii.
std::string plane_place(const Document& document, const passes::PixelsWave& wave, Extent extent) {
    const render::Request& request = document.request;
    const double time = render::wrapped_time(request);
    const std::array cells{double{wave.nodes.x} / wave.radius.x, // per kernel radius of the picture
                           double{wave.nodes.y} / wave.radius.y};
    // The middle of the first pixel or, in perspective, the position of the camera.
    const auto corner = [&](const Coordinate& middle, int pixels, double cells_per_radius) {
        const double from_middle = (0.5 - pixels / 2.0) / (request.scale * document.camera.zoom);
        return render::cell_at(render::in_perspective(request) ? middle : middle.moved(from_middle),
                               cells_per_radius);
    };
    const auto [x, x_place] = corner(document.camera.x, extent.width, cells[0]);
    const auto [y, y_place] = corner(document.camera.y, extent.height, cells[1]);
    std::string text =
        glsl("    place = GaborPlace(ivec2({}, {}), {} + here.p * {}, {}, ivec2({}, {}), {}{});\n", x, y,
             std::array{x_place, y_place}, cells, wave.nodes, wave.period.x, wave.period.y,
             !request.recipe.is_lattice() ? ""
             : time != 0                  ? "true, "
                                          : "false, ",
             time);
    if (request.filter)
        text += glsl("    footprint = gabor_footprint(here.dx * {0}, here.dy * {0});\n",
                     std::array{cells[0] / request.recipe.radius, cells[1] / request.recipe.radius});
    return text;
}

// Sums the waves in the plane.
std::string plane_waves(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    std::string text = footprint_of(document, extent) +
                       "    GaborPlace place;\n    GaborField field;\n    float removed = 0.0;\n";
    if (request.filter)
        text += "    GaborFootprint footprint;\n";
    int table = -1;
    for (const passes::PixelsWave& wave : waves_of<passes::PixelsWave>(request, 2)) {
        if (wave.table != table)
            text += plane_place(document, wave, extent);
        table = wave.table;
        // The wave vector per kernel radius along each axis.
        const double x = std::cos(double{wave.orientation});
        const double y = std::sin(double{wave.orientation}) * wave.radius.y / wave.radius.x;
        const std::string kernel =
            glsl("gabor_kernel({}, {})", wave.frequency * std::hypot(x, y), std::atan2(y, x));
        text += request.filter
                    ? glsl("    field = gabor_field_filtered(place, {}, footprint, {}u, removed);\n", kernel,
                           wave.seed)
                    : glsl("    field = gabor_field(place, {}, {}u);\n", kernel, wave.seed);
        text += added(request, wave, "noise_of(field, removed)", glsl("vec3({}, 1.0)", wave.radius));
    }
    return text;
}

// Sums the waves in space.
std::string space_waves(const render::Request& request) {
    std::string text = "    GaborPlace3d place;\n    GaborField3d field;\n";
    const double time = render::wrapped_time(request);
    const bool surface = render::along_surface(request);
    float radius = 0;
    for (const passes::SolidWave& wave : waves_of<passes::SolidWave>(request, 0)) {
        if (wave.radius != radius) {
            text += glsl("    place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS / {});\n", wave.radius);
            if (time != 0)
                text += glsl("    place.animated = true;\n    place.time = {};\n", time);
            if (request.filter)
                text += glsl("    place.filtered = true;\n"
                             "    place.dx = dFdx(p) / {0}; // in a fragment shader\n"
                             "    place.dy = dFdy(p) / {0};\n",
                             wave.radius);
        }
        radius = wave.radius;
        const bool isotropic = wave.isotropic == 1;
        text += glsl("    field = gabor_field_{}{}(place, {}{}, {}{}u);\n", surface ? "surface" : "3d",
                     isotropic ? "_isotropic" : "", surface ? "normal, " : "", wave.frequency,
                     isotropic ? "" : glsl("vec3({}, 0.0), ", wave.direction), wave.seed);
        text += added(request, wave, "noise_of(field)", glsl("vec3({})", radius));
    }
    return text;
}

// The GLSL function that returns the noise or, if the document is coloured, its colour.
std::string of_noise(Document document, Extent extent) {
    render::Request& request = document.request;
    request.paint.clear();
    if (!is_coloured(document))
        request.colour.reset();
    const Place& place = place_of(request);
    return glsl("\n{}{}_of_{}({})\n{{\n", parameters_are(request, extent, "kernel radii"),
                request.colour ? "vec3 colour" : "Noise noise", place.name, place.parameters) +
           (request.colour ? "    Components sum = Components(vec3(0.0), vec3(0.0));\n"
                           : "    Noise sum = Noise(vec2(0.0), vec3(0.0), 0.0);\n") +
           (render::in_space(request) ? space_waves(request) : plane_waves(document, extent)) +
           glsl("    return {};\n}}\n", request.colour ? "noise_colour(sum.value, sum.removed)" : "sum");
}

// ---- Its colours ----

// The position of a stop, rounded to the 8 bits that the window's shader has for it.
double shown_place(const ColourStop& stop) {
    return std::round(255 * double{stop.at}) / 255;
}

// A GLSL function for the user's colour map.
std::string own_colours(const std::vector<ColourStop>& ramp) {
    const auto colour = [](const ColourStop& stop) {
        return vec3(double{stop.colour[0]}, double{stop.colour[1]}, double{stop.colour[2]});
    };
    std::string text = glsl("vec3 viewer_own_colour(float t)\n{{\n    vec3 colour = {};\n", colour(ramp[0]));
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        const double from = shown_place(ramp[i - 1]);
        text += glsl("    colour = mix(colour, {}, clamp((t - {}) / {}, 0.0, 1.0));\n", colour(ramp[i]), from,
                     std::max(shown_place(ramp[i]) - from, 0.001));
    }
    return text + "    return colour;\n}\n";
}

// Declares the picture's `axes`.
template <typename Push>
std::string axes_of(const render::Request& request, const Push& push) {
    return is_body(request) ? glsl("    Axes axes = camera_axes({}, {});\n", push.yaw, push.pitch)
                            : "    Axes axes = flat_axes();\n";
}

// The position of `pixel` or `p` in the picture, measured from the picture's middle in units of its longer
// side.
std::string position_of(const Document& document, Extent extent) {
    const std::array half{extent.width / 2.0, extent.height / 2.0};
    const double longer = std::max(extent.width, extent.height);
    if (!render::in_space(document.request))
        return glsl("(pixel - {}) / {}", half, longer);
    const auto push = push_of<passes::SolidPush>(document, extent);
    const double pixel = double{push.pixel} * longer;
    if (is_body(document.request))
        return glsl("in_picture(p, axes).xy / ({} * ({} * eye_distance - dot(p, axes.toward_eye)))", pixel,
                    push.unit);
    return glsl("p.xy / {} - {}", pixel,
                std::array{(push.first_column + half[0]) / longer, (push.first_row + half[1]) / longer});
}

// GLSL for a share of the colour map.
std::string mapped(const Document& document, const std::string& share) {
    return document.colours == passes::own_colours ? glsl("viewer_own_colour({})", share)
                                                   : glsl("viewer_colour({}, {})", document.colours, share);
}

std::string stripes(const Document& document, std::string_view noise) {
    return glsl("viewer_stripes({}.complex, {}, {})", noise, document.profile,
                stripe_turns(document.request) / document.camera.zoom);
}

double green_of(const Document& document) {
    return document.directx_normals ? -1 : 1;
}

// GLSL for the colour of the noise `seen`.
std::string shown(const Document& document) {
    const bool space = render::in_space(document.request);
    const float contrast = document.contrast;
    switch (document.output) {
    case Output::gradient:
        return glsl("viewer_gradient({}, {}, {}, {})",
                    space ? "in_picture(seen.slope, axes).xy" : "seen.slope.xy",
                    slope_deviation(document.request), contrast, green_of(document));
    case Output::phase:
        return glsl("viewer_phase(seen.complex, {})", document.colours);
    case Output::phasor:
    case Output::lit_phasor:
        return mapped(document, stripes(document, "seen"));
    case Output::intensity:
        return mapped(document, glsl("viewer_intensity(seen.complex, {})", contrast));
    case Output::variance:
        return mapped(document, space ? "1.0" : "viewer_variance(seen.removed)");
    case Output::value:
    case Output::lit:
        break;
    }
    return mapped(document, glsl("viewer_value(seen.complex.y, {})", contrast));
}

// GLSL for the slope, along the picture's axes, of the surface that a lit output shows.
std::string slope_of(const Document& document) {
    const bool space = render::in_space(document.request);
    const double relief = 0.5 * document.contrast / slope_deviation(document.request);
    if (document.output == Output::lit)
        return glsl("{} * {}", relief, space ? "in_picture(seen.slope, axes)" : "seen.slope");
    const std::string_view left =
        space ? "noise_of_body(p - dFdx(p), normal)" : "noise_of_view(pixel - vec2(1.0, 0.0))";
    const std::string_view above = space ? "noise_of_body(p + dFdy(p) * sign(dot(dFdy(p), axes.up)), normal)"
                                         : "noise_of_view(pixel - vec2(0.0, 1.0))";
    return glsl("{} * vec3({} - vec2({}, {}), 0.0)",
                2 * relief * document.request.scale * document.camera.zoom, stripes(document, "seen"),
                stripes(document, left), stripes(document, above));
}

// The GLSL function for the colours that the window shows.
std::string of_colours(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const bool space = render::in_space(request);
    const Place& place = place_of(request);
    std::string text = shader("colours.glsl");
    if (document.colours == passes::own_colours)
        text += "\n" + own_colours(document.ramp);
    if (is_lit(document))
        text += lighting(request) + shader("surface.glsl");
    if (space)
        text += shader("camera.glsl");
    text += glsl("\n// The colour that the viewer showed there.\nvec3 colour_of_{0}({1})\n{{\n"
                 "    Noise seen = noise_of_{0}({2});\n",
                 place.name, place.parameters, place.arguments);
    if (space)
        text += axes_of(request, push_of<passes::SolidPush>(document, extent));
    if (is_lit(document))
        return text + glsl("    vec3 facing = {};\n"
                           "    return viewer_lit({}, bumped_normal(facing, {}), {}, {}, {});\n}}\n",
                           space ? "in_picture(normal, axes)" : "vec3(0.0, 0.0, 1.0)", shown(document),
                           slope_of(document), position_of(document, extent),
                           render::light_direction(request), is_body(request));
    return text + glsl("    return {};\n}}\n", shown(document));
}

// ---- Materials and terrain ----

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
    std::string text =
        glsl("\n// The material at p, in its own units; dx and dy lead to the next pixels.\n"
             "GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy)\n{{\n    {} m = gabor_{}_default();\n",
             type, function);
    for (const render::Parameter& p : render::parameters()) {
        if (p.group != render::Parameter::Group::material || !render::is_set(request, p.name))
            continue;
        const render::Value value = *p.get(request);
        const auto* colour = std::get_if<std::array<double, 3>>(&value);
        const double number = colour ? 0 : std::get<double>(value);
        const bool angle = p.kind == render::Parameter::Kind::angle;
        text += glsl("    m.{} = {};\n", p.name.substr(p.name.find('.') + 1),
                     colour ? vec3((*colour)[0], (*colour)[1], (*colour)[2])
                            : written(angle ? noise::radians(number) : number));
    }
    text += glsl("    GaborPixel pixel = {};\n",
                 request.filter ? "gabor_pixel_filtered(p, dx, dy)" : "gabor_pixel(p)");
    if (render::is_tiled(request))
        text += glsl("    pixel = gabor_pixel_tiled(pixel, {});\n",
                     std::array{request.width / request.scale, request.height / request.scale});
    return text + glsl("    return gabor_{}_at(pixel, m, {}u);\n}}\n\n", function, request.seed);
}

// The GLSL expression for what the window shows of a Sample `here`.
std::string material_colour(const Document& document) {
    switch (document.look) {
    case Look::lit:
        return glsl("srgb(lit_sample(here, {}, {}))", render::light_direction(document.request),
                    is_body(document.request));
    case Look::colour:
        return "srgb(here.material.colour)";
    case Look::height:
        return glsl("viewer_height(here.material.height, {})", document.contrast);
    case Look::normal:
        return glsl("viewer_normal(normalize(vec3(-here.slope.xy, 1.0)), {})", green_of(document));
    case Look::roughness:
        return "vec3(here.material.roughness)";
    case Look::metalness:
        break;
    }
    return "vec3(here.material.metalness)";
}

// Declares the Sample `here`.
std::string material_sample(const Document& document, Extent extent) {
    const auto push = push_of<passes::MaterialPush>(document, extent);
    if (render::in_space(document.request))
        return axes_of(document.request, push) +
               glsl("    vec3 to_eye = {} * eye_distance * axes.toward_eye - p;\n"
                    "    Sample here = sample_of_body(p, dFdx(p), dFdy(p), normal, to_eye, axes);\n",
                    push.unit);
    if (!render::in_perspective(document.request))
        return glsl("    Sample here = sample_from_above(pixel, {}, {}, {});\n", push.center, push.corner,
                    push.pixel);
    return glsl("    vec2 at = pixel - {};\n"
                "    if (at.y <= 0.0)\n"
                "        return {};\n"
                "    Sample here = sample_below_horizon(at, {}, {}, {});\n",
                passes::vec2{push.center.x, push.sky},
                document.look == Look::lit ? glsl("srgb(sky_colour(-at.y / {}))", push.sky) : "vec3(0.0)",
                push.corner, push.pixel, push.size.x);
}

std::string material_snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const Place& place = place_of(request);
    std::string text = "// A material of Gabor noise, as gabor-viewer showed it. Put this after #version.\n" +
                       includes({"gabor_noise.glsl", "gabor_spectrum.glsl", "gabor_materials.glsl"}) +
                       material_function(request) + lighting(request);
    for (const std::string_view name : {"plane.glsl", "camera.glsl", "relief.glsl", "colours.glsl"})
        text += shader(name);
    return text + glsl("\n// The colour that the viewer showed there; on a body, for fragment shaders.\n"
                       "{}vec3 colour_of_{}({})\n{{\n{}    return {};\n}}\n",
                       parameters_are(request, extent, "units of the material"), place.name, place.parameters,
                       material_sample(document, extent), material_colour(document));
}

std::string terrain_snippet(const Document& document, Extent extent) {
    const auto push = push_of<passes::TerrainPush>(document, extent);
    const render::Terrain& terrain = std::get<render::Terrain>(document.request.view);
    std::vector<std::string> members;
    for (const render::Parameter& p : render::parameters())
        if (p.group == render::Parameter::Group::erosion) {
            const double value = std::get<double>(*p.get(document.request));
            members.push_back(p.kind == render::Parameter::Kind::integer ? fmt::format("{}", value)
                                                                         : written(value));
        }
    const std::string hit =
        terrain.perspective
            ? glsl("seen_by_camera(ground, {}, {}, {}, {}, pixel - {}, {})", push.corner, push.distance,
                   push.yaw, push.pitch, push.center, push.pixel)
            : glsl("seen_from_above(ground, {} + {} * pixel, {})", push.corner, push.pixel, push.pixel);
    return "// Eroded mountains, as gabor-viewer showed them. Put this after #version.\n" +
           includes({"gabor_noise.glsl", "gabor_erosion.glsl"}) + shader("landscape.glsl") +
           shader("srgb.glsl") +
           glsl(R"(
// The colour for the screen.
{}vec3 colour_of_view(vec2 pixel)
{{
    GaborErosion erosion = GaborErosion({});
    Ground ground = Ground(ivec2({}, {}), {}, {}u, erosion, {}, {});
    return srgb({}.light);
}}
)",
                parameters_are(document.request, extent, ""), fmt::join(members, ", "), push.cell.x,
                push.cell.y, push.period, push.seed, push.reach, push.sun, hit);
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
    std::string text = "// Gabor noise, as gabor-viewer showed it. Put this after #version.\n";
    for (const noise::Macro& macro : noise::macros(recipe))
        text += fmt::format("#define {} {}\n", macro.name, macro.value);
    if (!request.paint.empty())
        text += "// The paint is left out: frequency and orientation are the same everywhere.\n";
    std::vector<std::string_view> drop_ins{noise::drop_in(recipe)};
    if (space || request.filter)
        drop_ins.emplace_back("gabor_spectrum.glsl");
    if (space)
        drop_ins.emplace_back("gabor_noise_3d.glsl");
    text += includes(drop_ins) + shader("sum.glsl");
    if (!space)
        text += shader("plane.glsl");
    if (is_coloured(document))
        return text + "\n" + fit::colour_function("noise", *request.colour) + of_noise(document, extent);
    return text + of_noise(document, extent) + of_colours(document, extent);
}

} // namespace gabor::viewer
