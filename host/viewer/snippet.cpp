#include "viewer/snippet.hpp"

#include "fit/glsl.hpp"
#include "noise/glsl_literal.hpp"
#include "viewer/display.hpp"
#include "viewer/document_json.hpp"
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
#include <utility>

namespace gabor::viewer {

namespace {

// A document, and the size in pixels of the view that shows it.
struct View : Document {
    Extent extent;

    bool in_space() const { return render::in_space(request); }
    bool shows_body() const { return std::holds_alternative<render::Body>(request.view); }
};

// A number or a vector as a GLSL literal; other values unchanged.
template <typename T>
decltype(auto) written(const T& value) {
    if constexpr (std::is_same_v<T, passes::vec2>)
        return noise::literal(std::array{value.x, value.y});
    else if constexpr (std::is_integral_v<T> || std::is_convertible_v<T, std::string_view>)
        return (value);
    else
        return noise::literal(value);
}

// Formats GLSL, with `values` written as literals.
template <typename... Values>
std::string glsl(std::string_view text, const Values&... values) {
    return fmt::format(fmt::runtime(text), written(values)...);
}

// The value of a material's or an erosion's parameter.
std::string value_of(const render::Parameter& parameter, const render::Request& request) {
    const render::Value value = *parameter.get(request);
    if (const auto* colour = std::get_if<std::array<double, 3>>(&value))
        return noise::literal(*colour);
    const double number = std::get<double>(value);
    return parameter.kind == render::Parameter::Kind::integer ? fmt::format("{}", number)
           : parameter.kind == render::Parameter::Kind::angle ? noise::literal(noise::radians(number))
                                                              : noise::literal(number);
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
Push push_of(const View& view) {
    const Drawing drawing = drawing_of(view);
    const render::Plan plan = render::plan(drawing.request, viewport_of(drawing, view.camera, view.extent));
    return render::values_of<Push>(plan.steps.front().push).front();
}

// What the parameters of the copied functions mean.
std::string parameters_are(const View& view, std::string_view unit) {
    if (view.in_space())
        return fmt::format("// p: a point on or in the body, in {}. normal: the unit normal there.\n", unit);
    return fmt::format("// pixel: a position in a picture of {} x {}, in pixels from the upper left corner, "
                       "with y pointing down.\n",
                       view.extent.width, view.extent.height);
}

// The head of a copied function.
std::string head(const View& view, std::string_view name) {
    return glsl("{}_of_{}\n{{\n", name, view.in_space() ? "body(vec3 p, vec3 normal)" : "view(vec2 pixel)");
}

// ---- The noise ----

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
std::string footprint_of(const View& view) {
    const double pixel = 1 / (view.request.scale * view.camera.zoom); // in kernel radii
    if (!render::in_perspective(view.request))
        return glsl(
            "    Footprint here = footprint_from_above((pixel - 0.5) * {0}, {0}); // from the first pixel\n",
            pixel);
    const double sky = render::sky_rows(view.extent.height);
    return glsl("    vec2 at = pixel - {};\n"
                "    if (at.y <= 0.0)\n"
                "        return {};\n"
                "    Footprint here = footprint_below_horizon(at, {}, {}); // from the camera\n",
                std::array{view.extent.width / 2.0, sky},
                view.request.colour ? "noise_colour(vec3(0.0), vec3(1.0))"
                                    : "Noise(vec2(0.0), vec3(0.0), 1.0)",
                (view.extent.height - 0.5 - sky) * pixel, double(view.extent.width));
}

// Sets the place of a wave and the following ones with the same kernel radii.
std::string plane_place(const View& view, const passes::PixelsWave& wave) {
    const render::Request& request = view.request;
    const double time = render::wrapped_time(request);
    const std::array cells{double{wave.nodes.x} / wave.radius.x, // per kernel radius of the picture
                           double{wave.nodes.y} / wave.radius.y};
    // The middle of the first pixel or, in perspective, the position of the camera.
    const auto corner = [&](const Coordinate& middle, int pixels, double cells_per_radius) {
        const double from_middle = (0.5 - pixels / 2.0) / (request.scale * view.camera.zoom);
        return render::cell_at(render::in_perspective(request) ? middle : middle.moved(from_middle),
                               cells_per_radius);
    };
    const auto [x, x_place] = corner(view.camera.x, view.extent.width, cells[0]);
    const auto [y, y_place] = corner(view.camera.y, view.extent.height, cells[1]);
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
std::string plane_waves(const View& view) {
    const render::Request& request = view.request;
    std::string text =
        footprint_of(view) + "    GaborPlace place;\n    GaborField field;\n    float removed = 0.0;\n";
    if (request.filter)
        text += "    GaborFootprint footprint;\n";
    int table = -1;
    for (const passes::PixelsWave& wave : waves_of<passes::PixelsWave>(request, 2)) {
        if (wave.table != table)
            text += plane_place(view, wave);
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
                text += glsl("    place.animated = true;\n    place.moment = {};\n", time);
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

// The GLSL function that returns the noise or, if the request has colours, its colour.
std::string of_noise(const View& view) {
    const bool coloured = view.request.colour.has_value();
    return glsl("\n{}{}    {};\n{}    return {};\n}}\n", parameters_are(view, "kernel radii"),
                head(view, coloured ? "vec3 colour" : "Noise noise"),
                coloured ? "Components sum = Components(vec3(0.0), vec3(0.0))"
                         : "Noise sum = Noise(vec2(0.0), vec3(0.0), 0.0)",
                view.in_space() ? space_waves(view.request) : plane_waves(view),
                coloured ? "noise_colour(sum.value, sum.removed)" : "sum");
}

// ---- Its colours ----

// A GLSL function for the user's colour map. Its positions have 8 bits, as in the window's shader.
std::string own_colours(const std::vector<ColourStop>& ramp) {
    const auto place = [](const ColourStop& stop) { return std::round(255 * double{stop.at}) / 255; };
    std::string text = glsl("vec3 viewer_own_colour(float t)\n{{\n    vec3 colour = {};\n", ramp[0].colour);
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        const double from = place(ramp[i - 1]);
        text += glsl("    colour = mix(colour, {}, clamp((t - {}) / {}, 0.0, 1.0));\n", ramp[i].colour, from,
                     std::max(place(ramp[i]) - from, 0.001));
    }
    return text + "    return colour;\n}\n";
}

// Declares the picture's `axes`.
template <typename Push>
std::string axes_of(const View& view, const Push& push) {
    return view.shows_body() ? glsl("    Axes axes = camera_axes({}, {});\n", push.yaw, push.pitch)
                             : "    Axes axes = flat_axes();\n";
}

// The position of `pixel` or `p` in the picture, measured from the picture's middle in units of its longer
// side.
std::string position_of(const View& view) {
    const std::array half{view.extent.width / 2.0, view.extent.height / 2.0};
    const double longer = std::max(view.extent.width, view.extent.height);
    if (!view.in_space())
        return glsl("(pixel - {}) / {}", half, longer);
    const auto push = push_of<passes::SolidPush>(view);
    const double pixel = double{push.pixel} * longer;
    if (view.shows_body())
        return glsl("in_picture(p, axes).xy / ({} * ({} * eye_distance - dot(p, axes.toward_eye)))", pixel,
                    push.unit);
    return glsl("p.xy / {} - {}", pixel,
                std::array{(push.first_column + half[0]) / longer, (push.first_row + half[1]) / longer});
}

std::string stripes(const View& view, std::string_view noise) {
    return glsl("viewer_stripes({}.complex, {}, {})", noise, view.profile,
                stripe_turns(view.request) / view.camera.zoom);
}

// GLSL for the share of the colour map or, for gradients and phases, the colour that each Output shows of the
// noise `seen`.
constexpr std::array<std::string_view, output_names.size()> seen_as{
    "viewer_value(seen.complex.y, {contrast})",
    "viewer_gradient({slope}.xy, {deviation}, {contrast}, {green})",
    "viewer_phase(seen.complex, {colours})",
    "viewer_intensity(seen.complex, {contrast})",
    "{left}",
    "{stripes}",
    "viewer_value(seen.complex.y, {contrast})",
    "{stripes}"};

// GLSL for the colour that each Look shows of the Sample `here`.
constexpr std::array<std::string_view, look_names.size()> looks_as{
    "srgb(lit_sample(here, {lamp}, {body}))",
    "srgb(here.material.colour)",
    "viewer_height(here.material.height, {contrast})",
    "viewer_normal(normalize(vec3(-here.slope.xy, 1.0)), {green})",
    "vec3(here.material.roughness)",
    "vec3(here.material.metalness)"};

// Fills in a text of one of these lists.
std::string filled(std::string_view text, const View& view) {
    return fmt::format(fmt::runtime(text), fmt::arg("contrast", noise::literal(view.contrast)),
                       fmt::arg("slope", view.in_space() ? "in_picture(seen.slope, axes)" : "seen.slope"),
                       fmt::arg("deviation", noise::literal(slope_deviation(view.request))),
                       fmt::arg("green", view.directx_normals ? "-1.0" : "1.0"),
                       fmt::arg("colours", view.colours),
                       fmt::arg("left", view.in_space() ? "1.0" : "viewer_variance(seen.removed)"),
                       fmt::arg("stripes", stripes(view, "seen")),
                       fmt::arg("lamp", noise::literal(render::light_direction(view.request))),
                       fmt::arg("body", view.shows_body()));
}

// GLSL for the colour of the noise `seen`.
std::string shown(const View& view) {
    const std::string text = filled(seen_as.at(static_cast<std::size_t>(view.output)), view);
    if (view.output == Output::gradient || view.output == Output::phase)
        return text;
    return view.colours == passes::own_colours ? glsl("viewer_own_colour({})", text)
                                               : glsl("viewer_colour({}, {})", view.colours, text);
}

// GLSL for the slope, along the picture's axes, of the surface that a lit output shows.
std::string slope_of(const View& view) {
    const double relief = 0.5 * view.contrast / slope_deviation(view.request);
    if (view.output == Output::lit)
        return glsl("{} * {}", relief, filled("{slope}", view));
    const auto [left, above] =
        view.in_space()
            ? std::pair("noise_of_body(p - dFdx(p), normal)",
                        "noise_of_body(p + dFdy(p) * sign(dot(dFdy(p), axes.up)), normal)")
            : std::pair("noise_of_view(pixel - vec2(1.0, 0.0))", "noise_of_view(pixel - vec2(0.0, 1.0))");
    return glsl("{} * vec3({} - vec2({}, {}), 0.0)", 2 * relief * view.request.scale * view.camera.zoom,
                stripes(view, "seen"), stripes(view, left), stripes(view, above));
}

// The GLSL function for the colours that the window shows.
std::string of_colours(const View& view) {
    const bool space = view.in_space(), lit = is_lit(view);
    std::string text = shader("colours.glsl");
    if (view.colours == passes::own_colours)
        text += "\n" + own_colours(view.ramp);
    if (lit)
        text += lighting(view.request) + shader("surface.glsl");
    if (space)
        text += shader("camera.glsl");
    text += glsl("\n// The colour that the viewer showed there.\n{}    Noise seen = {};\n{}",
                 head(view, "vec3 colour"), space ? "noise_of_body(p, normal)" : "noise_of_view(pixel)",
                 space ? axes_of(view, push_of<passes::SolidPush>(view)) : "");
    if (!lit)
        return text + glsl("    return {};\n}}\n", shown(view));
    return text + glsl("    vec3 facing = {};\n"
                       "    return viewer_lit({}, bumped_normal(facing, {}), {}, {}, {});\n}}\n",
                       space ? "in_picture(normal, axes)" : "vec3(0.0, 0.0, 1.0)", shown(view),
                       slope_of(view), position_of(view), render::light_direction(view.request),
                       view.shows_body());
}

// ---- Materials and terrain ----

// Returns a GLSL function that sets the material's parameters and evaluates it.
std::string material_function(const render::Request& request) {
    std::string function, type = "Gabor";
    bool begins = true; // a word of the name
    for (const char letter : request.material) {
        function += letter == '-' ? '_' : letter;
        if (letter != '-')
            type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
        begins = letter == '-';
    }
    std::string text =
        glsl("\n// The material at p, in its own units; dx and dy lead to the next pixels.\n"
             "GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy)\n{{\n    {} m = gabor_{}_default();\n",
             type, function);
    for (const render::Parameter& p : render::parameters())
        if (p.group == render::Parameter::Group::material && render::is_set(request, p.name))
            text += glsl("    m.{} = {};\n", p.name.substr(p.name.find('.') + 1), value_of(p, request));
    text += glsl("    GaborPixel pixel = {};\n",
                 request.filter ? "gabor_pixel_filtered(p, dx, dy)" : "gabor_pixel(p)");
    if (render::is_tiled(request))
        text += glsl("    pixel = gabor_pixel_tiled(pixel, {});\n",
                     std::array{request.width / request.scale, request.height / request.scale});
    return text + glsl("    return gabor_{}_at(pixel, m, {}u);\n}}\n\n", function, request.seed);
}

// Declares the Sample `here`.
std::string material_sample(const View& view) {
    const auto push = push_of<passes::MaterialPush>(view);
    if (view.in_space())
        return axes_of(view, push) +
               glsl("    vec3 to_eye = {} * eye_distance * axes.toward_eye - p;\n"
                    "    SurfacePoint point = point_of_body(p, dFdx(p), dFdy(p), normal, to_eye, axes);\n"
                    "    Sample here = sample_at(point, true, axes);\n",
                    push.unit);
    if (!render::in_perspective(view.request))
        return glsl("    SurfacePoint point = point_from_above(pixel, {}, {}, {});\n"
                    "    Sample here = sample_at(point, false, flat_axes());\n",
                    push.center, push.corner, push.pixel);
    return glsl("    vec2 at = pixel - {};\n"
                "    if (at.y <= 0.0)\n"
                "        return {};\n"
                "    SurfacePoint point = point_below_horizon(at, {}, {}, {});\n"
                "    Sample here = sample_at(point, false, flat_axes());\n",
                passes::vec2{push.center.x, push.sky},
                view.look == Look::lit ? glsl("srgb(sky_colour(-at.y / {}))", push.sky) : "vec3(0.0)",
                push.corner, push.pixel, push.size.x);
}

std::string material_snippet(const View& view) {
    std::string text = "// A material of Gabor noise, as gabor-viewer showed it. Put this after #version.\n" +
                       includes({"gabor_noise.glsl", "gabor_spectrum.glsl", "gabor_materials.glsl"}) +
                       material_function(view.request) + lighting(view.request);
    for (const std::string_view name : {"plane.glsl", "camera.glsl", "relief.glsl", "colours.glsl"})
        text += shader(name);
    return text + glsl("\n// The colour that the viewer showed there; on a body, for fragment shaders.\n"
                       "{}{}{}    return {};\n}}\n",
                       parameters_are(view, "units of the material"), head(view, "vec3 colour"),
                       material_sample(view), filled(looks_as.at(static_cast<std::size_t>(view.look)), view));
}

std::string terrain_snippet(const View& view) {
    const auto push = push_of<passes::TerrainPush>(view);
    std::vector<std::string> members;
    for (const render::Parameter& p : render::parameters())
        if (p.group == render::Parameter::Group::erosion)
            members.push_back(value_of(p, view.request));
    const std::string hit =
        std::get<render::Terrain>(view.request.view).perspective
            ? glsl("seen_by_camera(ground, {}, {}, {}, {}, pixel - {}, {})", push.corner, push.distance,
                   push.yaw, push.pitch, push.center, push.pixel)
            : glsl("seen_from_above(ground, {} + {} * pixel, {})", push.corner, push.pixel, push.pixel);
    return "// Eroded mountains, as gabor-viewer showed them. Put this after #version.\n" +
           includes({"gabor_noise.glsl", "gabor_erosion.glsl"}) + shader("landscape.glsl") +
           shader("srgb.glsl") +
           glsl("\n// The colour for the screen.\n{}{}"
                "    GaborErosion erosion = GaborErosion({});\n"
                "    Ground ground = Ground(ivec2({}, {}), {}, {}u, erosion, {}, {});\n"
                "    return srgb({}.light);\n}}\n",
                parameters_are(view, ""), head(view, "vec3 colour"),
                fmt::format("{}", fmt::join(members, ", ")), push.cell.x, push.cell.y, push.period, push.seed,
                push.reach, push.sun, hit);
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    View view{document, extent};
    render::Request& request = view.request;
    if (render::has_terrain(request))
        return terrain_snippet(view);
    if (render::has_material(request))
        return material_snippet(view);
    std::string text = "// Gabor noise, as gabor-viewer showed it. Put this after #version.\n";
    const noise::Recipe recipe = render::drawing_recipe(request);
    for (const noise::Macro& macro : noise::macros(recipe))
        text += fmt::format("#define {} {}\n", macro.name, macro.value);
    if (!std::exchange(request.paint, {}).empty())
        text += "// The paint is left out: frequency and orientation are the same everywhere.\n";
    std::vector<std::string_view> drop_ins{noise::drop_in(recipe)};
    if (view.in_space() || request.filter)
        drop_ins.emplace_back("gabor_spectrum.glsl");
    if (view.in_space())
        drop_ins.emplace_back("gabor_noise_3d.glsl");
    text += includes(drop_ins) + shader("sum.glsl");
    if (!view.in_space())
        text += shader("plane.glsl");
    if (view.output != Output::value) // a photograph's colours are those of its value
        request.colour.reset();
    if (request.colour)
        return text + "\n" + fit::colour_function("noise", *request.colour) + of_noise(view);
    return text + of_noise(view) + of_colours(view);
}

} // namespace gabor::viewer
