#include "viewer/snippet.hpp"

#include "viewer/noise_pass.hpp"

#include "render/axis.hpp"
#include "render/pixels.hpp"

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

std::string macros(const noise::Recipe& recipe, std::size_t lobes) {
    const noise::Recipe& standard = noise::recipes().front();
    std::string text;
    if (recipe.impulses != standard.impulses)
        text += fmt::format("#define GABOR_IMPULSES {}\n", recipe.impulses);
    if (recipe.radius != standard.radius)
        text += fmt::format("#define GABOR_RADIUS {}\n", literal(recipe.radius));
    if (recipe.weight_floor != standard.weight_floor)
        text += fmt::format("#define GABOR_WEIGHT_FLOOR {}\n", literal(recipe.weight_floor));
    if (recipe.phases != standard.phases)
        text += fmt::format("#define GABOR_PHASES {}\n", recipe.phases);
    if (recipe.window != standard.window)
        text += fmt::format("#define GABOR_WINDOW vec3({}, {}, {})\n", literal(recipe.window[0]),
                            literal(recipe.window[1]), literal(recipe.window[2]));
    if (lobes > 1)
        text += fmt::format("#define GABOR_LOBES {}\n", lobes);
    return text;
}

std::string lobe(const noise::Lobe& lobe) {
    return fmt::format("gabor_lobe({}, {}, {}, {}, {})", literal(lobe.frequency), literal(lobe.orientation),
                       literal(lobe.frequency_spread), literal(lobe.orientation_spread), literal(lobe.power));
}

// The noise at `place`, as seen through `footprint` where there is a filter.
std::string value(const render::Picture& picture, std::string_view kernel, std::string_view seed) {
    return picture.filter ? fmt::format("gabor_field_filtered(place, {}, footprint, {}).y", kernel, seed)
                          : fmt::format("gabor_field(place, {}, {}).value.y", kernel, seed);
}

std::string noise_at_place(const render::Picture& picture) {
    const std::vector<noise::Lobe> lobes = render::spectrum(picture);
    const std::string seed = fmt::format("{}u", picture.seed);
    const noise::Lobe& first = lobes.front();
    if (lobes.size() == 1 && first.frequency_spread == 0 && first.orientation_spread == 0)
        return fmt::format("    GaborKernel kernel = gabor_kernel({}, {});\n    return {};\n",
                           literal(first.frequency), literal(first.orientation),
                           value(picture, "kernel", seed));
    if (lobes.size() == 1)
        return fmt::format("    GaborKernel kernel = gabor_kernel_lobe({});\n    return {};\n", lobe(first),
                           value(picture, "kernel", seed));
    std::string text = fmt::format("    GaborLobes lobes;\n    lobes.count = {};\n", lobes.size());
    double together = 0;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        text += fmt::format("    lobes.lobe[{}] = {};\n", i, lobe(lobes[i]));
        together += lobes[i].power;
    }
    if (!picture.sum)
        return text + fmt::format("    GaborKernel kernel = gabor_kernel_lobes(lobes);\n    return {};\n",
                                  value(picture, "kernel", seed));
    return text + fmt::format(R"(    float sum = 0.0; // of independent noises
    for (int i = 0; i < {}; ++i) {{
        uint own_seed = gabor_mix({} + uint(i) * GABOR_SPREAD_IMPULSES, GABOR_SPREAD);
        GaborKernel kernel = gabor_kernel_lobe(lobes.lobe[i]);
        sum += sqrt(lobes.lobe[i].power / {}) * {};
    }}
    return sum;
)",
                              lobes.size(), seed, literal(together), value(picture, "kernel", "own_seed"));
}

std::string of_plane(const Document& document, Extent extent) {
    const render::Picture& picture = document.picture;
    const render::Axis x_axis = render::axis_along(picture, picture.width);
    const render::Axis y_axis = render::axis_along(picture, picture.height);
    const bool horizon = document.view() == View::perspective;
    // The middle of the first pixel; or where the camera stands.
    const auto place = [&](const Coordinate& middle, int pixels, double radius) {
        return axis_point(middle, horizon ? 0 : (0.5 - pixels / 2.0) / picture.scale, radius);
    };
    const AxisPoint x = place(document.camera.x, extent.width, x_axis.radius);
    const AxisPoint y = place(document.camera.y, extent.height, y_axis.radius);
    const double time = picture.time - std::floor(picture.time);
    std::string text =
        fmt::format(R"(
// pixel: the place in a picture of {} x {}, in pixels from its upper left corner, y growing downwards.
// Mean 0, variance 1; gabor_unorm(noise_of_view(pixel)) is what to show.
float noise_of_view(vec2 pixel)
{{
    GaborPlace place = GaborPlace(ivec2({}, {}), {}, {}, ivec2({}, {}), {});
)",
                    extent.width, extent.height, x.cell, y.cell, vec2(x.local, y.local),
                    vec2(x_axis.radius, y_axis.radius), x_axis.period, y_axis.period, literal(time));
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
                        vec2(extent.width / 2.0, sky), literal((extent.height - 0.5 - sky) / picture.scale),
                        literal(-extent.width), literal(extent.width));
    } else {
        text += fmt::format("    place.local += (pixel - 0.5) * {} * place.radius;\n",
                            literal(1 / picture.scale));
        if (picture.filter)
            text += fmt::format("    vec2 dx = {};\n    vec2 dy = {};\n", vec2(1 / picture.scale, 0),
                                vec2(0, 1 / picture.scale));
    }
    if (picture.filter)
        text += "    GaborFootprint footprint = gabor_footprint(dx, dy);\n";
    return text + noise_at_place(picture) + "}\n";
}

std::string of_body(const Document& document) {
    const render::Picture& picture = document.picture;
    const noise::Lobe first = render::spectrum(picture).front();
    const std::string frequency = literal(first.frequency);
    const std::string direction = fmt::format("vec3({}, {}, 0.0)", literal(std::cos(first.orientation)),
                                              literal(std::sin(first.orientation)));
    std::string kernel;
    switch (document.waves) {
    case Waves::oriented:
        kernel = fmt::format("gabor_kernel_3d({}, {})", frequency, direction);
        break;
    case Waves::isotropic:
        kernel = fmt::format("gabor_kernel_isotropic_3d({})", frequency);
        break;
    case Waves::surface:
        kernel = fmt::format("gabor_kernel_surface({}, {}, normal)", frequency, direction);
        break;
    case Waves::surface_isotropic:
        kernel = fmt::format("gabor_kernel_surface_isotropic({}, normal)", frequency);
        break;
    }
    const std::string filtered =
        !picture.filter ? ""
                        : R"(    kernel = gabor_filtered_3d(kernel, dFdx(p), dFdy(p)); // in a fragment shader
)";
    return fmt::format(R"(#include "gabor_noise_3d.glsl" // and this one

// p: a place on or in the body, in kernel radii. normal: of the surface there, of length 1.
// Mean 0, variance 1; gabor_unorm(noise_of_body(p, normal)) is what to show.
float noise_of_body(vec3 p, vec3 normal)
{{
    GaborKernel3d kernel = {};
{}    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_3D_RADIUS);
    place.time = {};
    return gabor_field_3d(place, kernel, {}u).value.y;
}}
)",
                       kernel, filtered, literal(picture.time - std::floor(picture.time)), picture.seed);
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    const render::Picture& picture = document.picture;
    std::string text = "// Gabor noise, as gabor-viewer showed it: put after #version.\n";
    if (!document.body)
        text += macros(noise::find_recipe(picture.recipe), render::spectrum(picture).size());
    if (!picture.paint.empty())
        text += "// Frequency and orientation were painted; here they are those beside the paint.\n";
    text += "#include \"gabor_noise.glsl\" // or paste it here\n";
    return text + (document.body ? of_body(document) : of_plane(document, extent));
}

} // namespace gabor::viewer
