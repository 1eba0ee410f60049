#include "viewer/snippet.hpp"

#include "fit/glsl.hpp"
#include "noise/glsl_literal.hpp"
#include "viewer/display.hpp"
#include "viewer/document_json.hpp"
#include "viewer/drawing.hpp"
#include "viewer/embedded.hpp"

#include "passes/fractal_interface.h"
#include "passes/material_interface.h"
#include "passes/ocean_interface.h"
#include "passes/pixels_interface.h"
#include "passes/solid_interface.h"
#include "passes/terrain_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace gabor::viewer {

namespace {

using noise::glsl, noise::literal;

// A document, the size in pixels of the view that shows it, the plan of this view, and how it is displayed.
struct View : Document {
    Extent extent;
    render::Plan plan;
    passes::DisplayPush display;

    bool in_space() const { return request.view.in_space(); }
    bool shows_body() const { return request.view.is_body(); }
    template <typename Push>
    Push push() const {
        return render::values_of<Push>(plan.steps.front().push).front();
    }
    template <typename Value>
    std::vector<Value> table(std::size_t index) const {
        return render::values_of<Value>(plan.tables.at(index));
    }
};

// Sets the members of a struct whose parameters differ from their defaults.
std::string members_of(const View& view, render::Parameter::Group group, std::string_view of = "m") {
    std::string text;
    for (const render::Parameter& p : render::parameters())
        if (p.of_struct && p.group == group && render::is_set(view.request, p.name)) {
            const render::Value value = *p.get(view.request);
            const auto* number = std::get_if<double>(&value);
            text += glsl("    {}.{} = {};\n", of, p.name.substr(p.name.find('.') + 1),
                         !number ? literal(std::get<std::array<double, 3>>(value))
                         : p.type == render::Parameter::Type::integer ? fmt::format("{}", *number)
                         : p.type == render::Parameter::Type::angle   ? literal(noise::radians(*number))
                                                                      : literal(*number));
        }
    return text;
}

// Shaders that passes and copied code share.
std::string shaders(std::initializer_list<std::string_view> names) {
    std::string text;
    for (const std::string_view name : names) {
        const std::span<const unsigned char> bytes = embedded(name);
        text.append(1, '\n').append(bytes.begin(), bytes.end());
    }
    return text;
}

std::string lighting(const View& view) {
    return glsl("\nconst int environment = {};\n", view.request.environment) +
           shaders({"srgb.glsl", "light.glsl"});
}

// Includes drop-ins, for users who have the files. Skips empty names.
std::string includes(std::initializer_list<std::string_view> drop_ins) {
    std::string text = "// Include these files, or paste them here.\n";
    for (const std::string_view name : drop_ins)
        text += name.empty() ? "" : glsl("#include \"gabor_{}.glsl\"\n", name);
    return text;
}

// The head of a copied function, whose parameters snippet() describes.
std::string head(const View& view, std::string_view name) {
    return glsl("{}_of_{}\n{{\n", name, view.in_space() ? "body(vec3 p, vec3 normal)" : "view(vec2 pixel)");
}

// If there is a horizon, returns `sky` above it, and declares the offset `at` of a pixel from its middle.
std::string below_horizon(const View& view, std::string_view sky) {
    if (!view.request.view.has_horizon())
        return {};
    return glsl("    vec2 at = pixel - {};\n    if (at.y <= 0.0)\n        return {};\n",
                std::array{view.extent.width / 2.0, render::sky_rows(view.extent.height)}, sky);
}

std::string axes_of(const View& view, passes::vec2 yaw, passes::vec2 pitch) {
    return view.shows_body() ? glsl("camera_axes({}, {})", yaw, pitch) : "flat_axes()";
}

// GLSL for one of the noises: its place, and the function that returns its field, with the arguments that
// describe its waves and {} for a filter.
std::array<std::string, 2> term_of(const View& view, const passes::PixelsWave& wave) {
    const auto table = static_cast<std::size_t>(wave.table);
    const passes::Line x = view.table<passes::Line>(0)[table], y = view.table<passes::Line>(1)[table];
    const float ratio = wave.radius.y / wave.radius.x;
    return {glsl("GaborPlace(ivec2({}, {}), {} + here.position * {}, {}, ivec2({}, {}), 0.0)", x.cell, y.cell,
                 view.request.view.has_horizon() ? wave.camera : passes::vec2{x.local, y.local},
                 std::array{wave.nodes.x / wave.radius.x, wave.nodes.y / wave.radius.y}, wave.nodes,
                 wave.period.x, wave.period.y),
            glsl("gabor_field{{}}, gabor_{}({}, {}){}",
                 view.request.recipe.is_lattice() ? "wave_vector" : "kernel", wave.frequency,
                 wave.orientation, ratio == 1 ? "" : glsl(" * vec2(1.0, {})", ratio))};
}

std::array<std::string, 2> term_of(const View& view, const passes::SolidWave& wave) {
    const bool surface = view.request.view.along_surface();
    const std::string direction = glsl("{}vec3({}, 0.0)", surface ? ", " : " * ", wave.direction);
    return {glsl("gabor_place_3d_at(p / {})", wave.radius),
            glsl("gabor_field_{}{}{{}}, {}{}{}", surface ? "surface" : "3d",
                 wave.isotropic ? "_isotropic" : "", surface ? "normal, " : "", wave.frequency,
                 wave.isotropic ? "" : direction)};
}

// Sums the noises of a table of the plan.
template <typename Wave>
std::string terms(const View& view, std::size_t table) {
    const double evolution = render::wrapped_evolution(view.request);
    const std::string_view filter = !view.request.filter ? "(place"
                                    : view.in_space()    ? "_filtered(place, dFdx(p) / {0}, dFdy(p) / {0}"
                                                         : "_filtered(place, here.dx / {0}, here.dy / {0}";
    std::string text = glsl("    GaborPlace{} place;\n", view.in_space() ? "3d" : ""), place;
    for (const Wave& wave : view.table<Wave>(table)) {
        const auto [at, field] = term_of(view, wave);
        if (std::exchange(place, at) != at)
            text += glsl("    place = {};\n{}", place,
                         evolution == 0 ? "" : glsl("    place.evolution = {};\n", evolution));
        const std::string noise =
            glsl("noise_of({}, {}u), {})", glsl(field, glsl(filter, wave.radius)), wave.seed, wave.radius);
        text += view.request.colour
                    ? glsl("    add_weighted(sum, {}, {});\n", noise, std::to_array(wave.weights))
                    : glsl("    add_noise(sum, {}, {});\n", noise, wave.amplitude);
    }
    return text;
}

// Declares what `pixel` shows of the plane, `here`, in kernel radii from the first pixel or the camera.
template <typename Push>
std::string footprint_of(const View& view, std::string_view sky) {
    const auto push = view.push<Push>();
    return glsl(view.request.view.has_horizon()
                    ? "{}    Footprint here = footprint_below_horizon(at, {}, {});\n"
                    : "{0}    Footprint here = footprint_from_above((pixel - 0.5) * {1}, {1});\n",
                below_horizon(view, sky), push.pixel, push.focal_length);
}

// The GLSL function that returns the noise or, if the request has colours, its colour.
std::string of_noise(const View& view) {
    const auto [name, sum, seen, sky] =
        view.request.colour
            ? std::array{"vec3 colour", "Components sum = Components(vec3(0.0), vec3(0.0))",
                         "noise_colour(sum.value, sum.removed)", "noise_colour(vec3(0.0), vec3(1.0))"}
            : std::array{"Noise noise", "Noise sum = Noise(vec2(0.0), vec3(0.0), 0.0)", "sum",
                         "Noise(vec2(0.0), vec3(0.0), 1.0)"};
    return glsl("\n{}    {};\n{}    return {};\n}}\n", head(view, name), sum,
                view.in_space()
                    ? terms<passes::SolidWave>(view, 0)
                    : footprint_of<passes::PixelsPush>(view, sky) + terms<passes::PixelsWave>(view, 2),
                seen);
}

std::string stripes(const View& view, std::string_view noise) {
    return glsl("viewer_stripes({}.complex, {}, {})", noise, view.profile, view.display.turns);
}

// GLSL for the colour of the noise `seen`.
std::string shown(const View& view) {
    const passes::DisplayPush& look = view.display;
    if (view.output == Output::gradient)
        return glsl("viewer_gradient(seen.slope.xy, {}, {}, {})", look.deviation, look.contrast, look.green);
    if (view.output == Output::phase)
        return glsl("viewer_phase(seen.complex, {})", view.colours);
    const bool striped = view.output == Output::phasor || view.output == Output::lit_phasor;
    const std::string share =
        striped                            ? stripes(view, "seen")
        : view.output == Output::intensity ? glsl("viewer_intensity(seen.complex, {})", look.contrast)
        : view.output != Output::variance  ? glsl("viewer_value(seen.complex.y, {})", look.contrast)
        : view.in_space()                  ? "1.0"
                                           : "viewer_variance(seen.removed)";
    return view.colours == passes::own_colours ? glsl("viewer_own_colour({}, {})", stops_of(view), share)
                                               : glsl("viewer_colour({}, {})", view.colours, share);
}

// GLSL for the slope, along the picture's axes, of the surface that a lit output shows.
std::string slope_of(const View& view) {
    const double relief = 0.5 * view.display.contrast / view.display.deviation;
    if (view.output == Output::lit)
        return glsl("{} * seen.slope", relief);
    const auto left = view.in_space() ? "body(p - dFdx(p), normal)" : "view(pixel - vec2(1.0, 0.0))";
    const auto above = view.in_space() ? "body(p + dFdy(p) * sign(dot(dFdy(p), axes.up)), normal)"
                                       : "view(pixel - vec2(0.0, 1.0))";
    return glsl("{} * vec3({} - vec2({}, {}), 0.0)", 2 * relief / view.display.spacing, stripes(view, "seen"),
                stripes(view, glsl("noise_of_{}", left)), stripes(view, glsl("noise_of_{}", above)));
}

// GLSL for the pixel that shows `p`.
std::string pixel_of(const View& view) {
    if (!view.in_space())
        return "pixel";
    const auto push = view.push<passes::SolidPush>();
    return view.shows_body()
               ? glsl("place_of_body(p, {}, axes) / {} + {}", push.unit, push.pixel, push.center)
               : glsl("p.xy / {} - vec2({}, {})", push.pixel, push.first_column, push.first_row);
}

// The GLSL function for the colours that the window shows.
std::string of_colours(const View& view) {
    const bool lit = is_lit(view);
    std::string colour = shown(view), seen = "view(pixel);\n", normal = "vec3(0.0, 0.0, 1.0)";
    if (view.in_space()) {
        const auto push = view.push<passes::SolidPush>();
        seen = glsl("body(p, normal);\n    Axes axes = {};\n    seen.slope = in_picture(seen.slope, axes);\n",
                    axes_of(view, push.yaw, push.pitch));
        normal = "in_picture(normal, axes)";
    }
    if (lit)
        colour = glsl("viewer_lit({}, bumped_normal({}, {}), picture_place({}, vec2({}, {})), {}, {})",
                      colour, normal, slope_of(view), pixel_of(view), view.extent.width, view.extent.height,
                      view.display.lamp, view.shows_body());
    return shaders({"colours.glsl"}) + (lit ? lighting(view) + shaders({"surface.glsl"}) : "") +
           glsl("\n// The colour that the viewer showed.\n{}    Noise seen = noise_of_{}    return {};\n}}\n",
                head(view, "vec3 colour"), seen, colour);
}

// A GLSL function that sets the material's parameters and evaluates it.
std::string material_function(const View& view) {
    const render::Request& request = view.request;
    std::string function = request.material, type = "-" + function; // brushed-metal: GaborBrushedMetal
    std::ranges::replace(function, '-', '_');
    for (std::size_t dash = 0; (dash = type.find('-', dash)) != std::string::npos;)
        type.replace(dash, 2, 1, static_cast<char>(std::toupper(static_cast<unsigned char>(type[dash + 1]))));
    const bool boards = request.boards;
    const std::string seed = fmt::format("{}u", request.seed);
    const std::string tile =
        request.view.tileable
            ? literal(std::array{request.width / request.scale, request.height / request.scale})
            : "vec2(0.0)";
    const std::string material =
        glsl(request.filter ? "gabor_{0}_filtered_at({1}{4}, {1}dx, {1}dy, {2}, m, {1}{3})"
                            : "gabor_{0}_at({1}{4}, {2}, m, {1}{3})",
             function, boards ? "board." : "", boards ? "vec2(0.0)" : tile, boards ? "seed" : seed,
             boards ? "position" : "p");
    std::string laid = boards ? glsl("gabor_laid({}, board, boards)", material) : material;
    if (request.coat)
        laid = glsl(request.filter ? "gabor_coated_filtered({}, p, dx, dy, {}, {}, coat, {})"
                                   : "gabor_coated({}, p, {}, {}, coat, {})",
                    laid, tile, boards ? "board.to_edge" : "vec2(1000.0)",
                    boards ? glsl("coat.edge_wear > 0.0 ? board.seed : {}", seed) : seed);
    return glsl("\n// The material at p, in its own units; dx and dy lead to the next pixels.\n"
                "GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy)\n{{\n    Gabor{} m = "
                "gabor_{}_default();\n{}",
                type, function, members_of(view, render::Parameter::Group::material)) +
           (!boards ? ""
                    : glsl("    GaborBoards boards = gabor_boards_default();\n{}"
                           "    GaborBoard board = gabor_board(p, {}, {}, boards, {});\n",
                           members_of(view, render::Parameter::Group::boards, "boards"),
                           request.filter ? "dx, dy" : "vec2(0.0), vec2(0.0)", tile, seed)) +
           (!request.coat ? ""
                          : glsl("    GaborCoat coat = gabor_coat_default();\n{}",
                                 members_of(view, render::Parameter::Group::coat, "coat"))) +
           (!request.finish ? ""
                            : glsl("    GaborFinish finish = gabor_finish_default();\n{}",
                                   members_of(view, render::Parameter::Group::finish, "finish"))) +
           glsl("    return {};\n}}\n\n",
                request.finish
                    ? glsl(request.filter ? "gabor_finished_filtered({}, p, dx, dy, {}, finish, {})"
                                          : "gabor_finished({}, p, {}, finish, {})",
                           laid, tile, seed)
                    : laid);
}

// GLSL for the colour that each Look shows of the Sample `here`.
constexpr std::array<std::string_view, look_names.size()> looks_as{
    "srgb(lit_sample(here, {0}, {1}))",         "srgb(here.material.colour)",
    "viewer_height(here.material.height, {2})", "viewer_normal(normalize(vec3(-here.slope.xy, 1.0)), {3})",
    "vec3(gabor_roughness(here.material))",     "vec3(here.material.metalness)"};

std::string material_snippet(const View& view) {
    const auto push = view.push<passes::MaterialPush>();
    const std::string sky =
        view.look == Look::lit ? glsl("srgb(sky_colour(-at.y / {}))", push.sky) : "vec3(0.0)";
    const std::string point =
        glsl(view.in_space() ? "point_of_body(p / {5}, dFdx(p) / {5}, dFdy(p) / {5}, normal, {5}, axes)"
                             : "point_of_pixel(pixel, {0}, {1}, {2}, {3}, {4})",
             push.center, push.corner, push.pixel, push.sky, push.size.x, push.unit);
    return includes({"noise", "spectrum", "fractal", "materials",
                     view.request.boards || view.request.coat || view.request.finish ? "compose" : ""}) +
           material_function(view) + lighting(view) +
           shaders({"plane.glsl", "camera.glsl", "relief.glsl", "colours.glsl"}) +
           glsl("\n// The colour that the viewer showed there; on a body, for fragment shaders.\n"
                "{}{}    Axes axes = {};\n    Sample here = sample_at({}, {}, axes);\n    return {};\n}}\n",
                head(view, "vec3 colour"), below_horizon(view, sky), axes_of(view, push.yaw, push.pitch),
                point,
                !view.in_space()                                             ? 0
                : view.request.view.projection == render::Projection::sphere ? 1
                                                                             : 2,
                glsl(looks_as.at(static_cast<std::size_t>(view.look)), view.display.lamp, view.shows_body(),
                     view.display.contrast, view.display.green));
}

std::string terrain_snippet(const View& view) {
    const auto push = view.push<passes::TerrainPush>();
    const std::string seen =
        view.request.view.is_flat()
            ? glsl("seen_from_above(ground, {} + {} * pixel, {})", push.corner, push.pixel, push.pixel)
            : glsl("seen_by_camera(ground, {}, {}, {}, {}, pixel - {}, {})", push.corner, push.distance,
                   push.yaw, push.pitch, push.center, push.pixel);
    return includes({"noise", "erosion", "fractal"}) +
           shaders({"srgb.glsl", "ground.glsl", "ranges.glsl", "landscape.glsl"}) +
           glsl("\n// The colour for the screen.\n{}    GaborErosion m = gabor_erosion();\n{}"
                "    Ground ground = Ground(ivec2({}, {}), {}, {}u, m, {}, {}, {}, {});\n"
                "    return srgb(exposed({}.light));\n}}\n",
                head(view, "vec3 colour"), members_of(view, render::Parameter::Group::erosion), push.cell.x,
                push.cell.y, push.period, push.seed, push.reach, push.sun, view.request.cover, push.water,
                seen);
}

std::string sea_snippet(const View& view) {
    const auto push = view.push<passes::OceanPush>();
    return fmt::format("#define GABOR_OCEAN_BANDS {}\n", GABOR_OCEAN_BANDS) +
           includes({"noise", "fractal", "ocean"}) + shaders({"srgb.glsl", "seascape.glsl"}) +
           glsl("\n// The colour for the screen. Compute `sea` once.\n{}    GaborSea m = gabor_sea();\n{}"
                "    m.loop_seconds = {};\n    Sea sea = sea_of(gabor_ocean_of(m), {}u, {}, {}, {});\n"
                "    return srgb(seen_at_sea_in_pixel(sea, {}, {}, {}, pixel - {}, {}).light);\n}}\n",
                head(view, "vec3 colour"), members_of(view, render::Parameter::Group::sea),
                view.request.sea.loop_seconds, push.seed, push.second, push.fraction, push.sun, push.altitude,
                push.yaw, push.pitch, push.center, push.pixel);
}

std::string noise_snippet(const View& view) {
    const bool space = view.in_space(), filter = view.request.filter;
    const noise::Recipe recipe = render::drawing_recipe(view.request);
    std::string text;
    for (const noise::Macro& macro : noise::macros(recipe))
        text += fmt::format("#define {} {}\n", macro.name, macro.value);
    text += includes({recipe.is_lattice() ? "noise" : "sparse", filter ? "filter" : "",
                      space ? "noise_3d" : "", space && filter ? "filter_3d" : ""}) +
            shaders({"sum.glsl", space ? "camera.glsl" : "plane.glsl"});
    if (view.request.colour)
        return text + "\n" + fit::colour_function("noise", *view.request.colour) + of_noise(view);
    return text + of_noise(view) + of_colours(view);
}

std::string fractal_snippet(const View& view) {
    const auto push = view.push<passes::FractalPush>();
    const passes::Line x = view.table<passes::Line>(0).front(), y = view.table<passes::Line>(1).front();
    const render::Fractal& fractal = view.request.fractal;
    return includes({"noise", "fractal"}) + shaders({"sum.glsl", "plane.glsl", "swirls.glsl"}) +
           glsl("\n{}{}    GaborPlace place = GaborPlace(ivec2({}, {}), {} + here.position * {}, {}, "
                "ivec2({}, {}), {});\n"
                "    GaborFractal fractal = GaborFractal({}, {}, {}, {}, {}, {});\n"
                "    GaborFractalNoise noise = warped_noise(place, {}, here.dx, here.dy, {}, fractal, {}u);\n"
                "    return Noise(vec2(0.0, noise.noise), vec3(noise.gradient, 0.0), noise.removed);\n}}\n",
                head(view, "Noise noise"),
                footprint_of<passes::FractalPush>(view, "Noise(vec2(0.0), vec3(0.0), 1.0)"), x.cell, y.cell,
                view.request.view.has_horizon() ? push.camera : passes::vec2{x.local, y.local}, push.nodes,
                push.nodes, view.request.view.tileable ? push.period.x : 0,
                view.request.view.tileable ? push.period.y : 0, push.time, push.octaves, push.gain,
                push.lacunarity, push.turn, fractal.basis, fractal.shape - 1, view.request.filter, push.warp,
                push.seed) +
           of_colours(view);
}

std::string text_of(const View& view) {
    switch (view.request.kind) {
    case render::Kind::material:
        return material_snippet(view);
    case render::Kind::terrain:
        return terrain_snippet(view);
    case render::Kind::sea:
        return sea_snippet(view);
    case render::Kind::fractal:
        return fractal_snippet(view);
    case render::Kind::noise:
        break;
    }
    return noise_snippet(view);
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    View view{document, extent, {}, display_push(document, 1, document.camera.zoom)};
    const bool painted = !std::exchange(view.request.paint, {}).empty();
    if (!can_show(view.request, view.output))
        view.output = Output::value;
    if (view.output != Output::value) // a photograph's colours are those of its value
        view.request.colour.reset();
    const Drawing drawing = drawing_of(view);
    render::Viewport viewport = viewport_of(drawing, view.camera, extent);
    viewport.blocks = render::Blocks::none;
    view.plan = render::plan(drawing.request, viewport);
    return glsl(
        "// What gabor-viewer showed in a view of {} x {} pixels. Put this after #version.\n{}"
        "// pixel: in that view, from the upper left corner, with y pointing down.\n"
        "// p: a point of the body, in kernel radii or units of the material. normal: the normal.\n{}",
        extent.width, extent.height, painted ? "// The paint is left out.\n" : "", text_of(view));
}

} // namespace gabor::viewer
