#include "viewer/snippet.hpp"

#include "viewer/noise_pass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gabor::viewer {

namespace {

// A float literal of GLSL, as short as it can be and still the same number.
std::string literal(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

std::string vec2(double x, double y) {
    return fmt::format("vec2({}, {})", literal(x), literal(y));
}

std::string lobe(const noise::Lobe& lobe) {
    return fmt::format("gabor_lobe({}, {}, {}, {}, {})", literal(lobe.frequency), literal(lobe.angle()),
                       literal(lobe.frequency_spread), literal(noise::radians(lobe.orientation_spread)),
                       literal(lobe.power));
}

bool on_lattice(const render::Request& request) {
    return render::drawing_recipe(request).is_lattice();
}

// The noise at `place`, as seen through `footprint` where there is a filter.
std::string value(const render::Request& request, std::string_view kernel, std::string_view seed) {
    return request.filter ? fmt::format("gabor_field_filtered(place, {}, footprint, {}).y", kernel, seed)
                          : fmt::format("gabor_field(place, {}, {}).value.y", kernel, seed);
}

std::string noise_at_place(const render::Request& request) {
    const std::vector<noise::Lobe>& lobes = request.lobes;
    const std::string seed = fmt::format("{}u", request.seed);
    const noise::Lobe& first = lobes.front();
    if (lobes.size() == 1 && first.is_one_wave())
        return fmt::format("    GaborKernel kernel = gabor_kernel({}, {});\n{}    return {};\n",
                           literal(first.frequency), literal(first.angle()),
                           on_lattice(request) && render::axis_along(request, request.width).period > 0
                               ? "    kernel = gabor_kernel_stretched(kernel, place.radius);\n"
                               : "",
                           value(request, "kernel", seed));
    if (lobes.size() == 1)
        return fmt::format("    GaborKernel kernel = gabor_kernel_lobe({});\n    return {};\n", lobe(first),
                           value(request, "kernel", seed));
    std::string text = fmt::format("    GaborLobes lobes;\n    lobes.count = {};\n", lobes.size());
    double total_power = 0;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        text += fmt::format("    lobes.lobe[{}] = {};\n", i, lobe(lobes[i]));
        total_power += lobes[i].power;
    }
    return text + fmt::format(R"(    float sum = 0.0; // of independent noises
    for (int i = 0; i < {}; ++i) {{
        uint own_seed = gabor_lobe_seed({}, i);
        GaborKernel kernel = gabor_kernel_lobe(lobes.lobe[i]);
        sum += sqrt(lobes.lobe[i].power / {}) * {};
    }}
    return sum;
)",
                              lobes.size(), seed, literal(total_power), value(request, "kernel", "own_seed"));
}

std::string of_plane(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const render::Axis x_axis = render::axis_along(request, request.width);
    const render::Axis y_axis = render::axis_along(request, request.height);
    const bool horizon = std::holds_alternative<render::Horizon>(request.view);
    // The middle of the first pixel; or where the camera stands.
    const auto place = [&](const Coordinate& middle, int pixels, double radius) {
        return axis_point(middle, horizon ? 0 : (0.5 - pixels / 2.0) / request.scale, radius);
    };
    const passes::Line x = place(document.camera.x, extent.width, x_axis.radius);
    const passes::Line y = place(document.camera.y, extent.height, y_axis.radius);
    const double time = request.time - std::floor(request.time);
    std::string text = fmt::format(R"(
// pixel: the place in a picture of {} x {}, in pixels from its upper left corner, y growing downwards.
// Mean 0, variance 1; gabor_unorm(noise_of_view(pixel)) is what to show.
float noise_of_view(vec2 pixel)
{{
    GaborPlace place = GaborPlace(ivec2({}, {}), {}, {}, ivec2({}, {}), {}{});
)",
                                   extent.width, extent.height, x.cell, y.cell, vec2(x.local, y.local),
                                   vec2(x_axis.radius, y_axis.radius), x_axis.period, y_axis.period,
                                   !on_lattice(request) ? ""
                                   : time != 0          ? "true, "
                                                        : "false, ",
                                   literal(time));
    if (horizon) {
        const double sky = render::sky_rows(extent.height);
        text +=
            fmt::format(R"(    vec2 at = pixel - {};
    if (at.y <= 0.0)
        return 0.0;
    float near = {} / at.y; // kernel radii per pixel
    place.local += near * vec2(at.x, {}) * place.radius;
    vec2 dx = vec2(near, 0.0);
    vec2 dy = near / at.y * vec2(-at.x, {});
)",
                        vec2(extent.width / 2.0, sky), literal((extent.height - 0.5 - sky) / request.scale),
                        literal(-extent.width), literal(extent.width));
    } else {
        text += fmt::format("    place.local += (pixel - 0.5) * {} * place.radius;\n",
                            literal(1 / request.scale));
        if (request.filter)
            text += fmt::format("    vec2 dx = {};\n    vec2 dy = {};\n", vec2(1 / request.scale, 0),
                                vec2(0, 1 / request.scale));
    }
    if (request.filter)
        text += "    GaborFootprint footprint = gabor_footprint(dx, dy);\n";
    return text + noise_at_place(request) + "}\n";
}

std::string of_space(const render::Request& request) {
    const noise::Lobe& lobe = request.lobes.front();
    const render::Body* body = std::get_if<render::Body>(&request.view);
    const bool on_surface = body && !body->solid;
    const std::string frequency = literal(lobe.frequency);
    const std::string direction =
        fmt::format("vec3({}, {}, 0.0)", literal(std::cos(lobe.angle())), literal(std::sin(lobe.angle())));
    std::string field = fmt::format("gabor_field_3d(place, gabor_wave_3d({}, {})", frequency, direction);
    if (on_surface && render::is_isotropic(lobe))
        field = fmt::format("gabor_surface_isotropic_3d(place, normal, {}", frequency);
    else if (on_surface)
        field = fmt::format("gabor_surface_3d(place, normal, {}, {}", frequency, direction);
    else if (render::is_isotropic(lobe))
        field = fmt::format("gabor_isotropic_3d(place, {}", frequency);
    std::string settings;
    if (const double time = render::wrapped_time(request); time != 0)
        settings += fmt::format("    place.animated = true;\n    place.time = {};\n", literal(time));
    if (request.filter)
        settings += R"(    place.filtered = true;
    place.dx = dFdx(p); // in a fragment shader
    place.dy = dFdy(p);
)";
    return fmt::format(R"(#include "gabor_lattice_3d.glsl" // and this one

// p: a point on or in the body, in kernel radii. normal: of the surface there, of length 1.
// Mean 0, variance 1; gabor_unorm(noise_of_body(p, normal)) is what to show.
float noise_of_body(vec3 p, vec3 normal)
{{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
{}    return {}, {}u).value.y;
}}
)",
                       settings, field, request.seed);
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    const render::Request& request = document.request;
    const bool space = render::in_space(request);
    const noise::Recipe recipe = render::drawing_recipe(request);
    std::string text = "// Gabor noise, as gabor-viewer showed it: put after #version.\n";
    if (!space) {
        for (const noise::Macro& macro : noise::macros(recipe))
            text += fmt::format("#define {} {}\n", macro.name, macro.value);
        if (request.lobes.size() > 1)
            text += fmt::format("#define GABOR_LOBES {}\n", request.lobes.size());
    }
    if (!request.paint.empty())
        text += "// Frequency and orientation were painted; here they are those beside the paint.\n";
    text += fmt::format("#include \"{}\" // or paste it here\n", noise::drop_in(recipe));
    return text + (space ? of_space(request) : of_plane(document, extent));
}

} // namespace gabor::viewer
