#include "viewer/snippet.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gabor::viewer {

namespace {

// A float literal of GLSL, as short as it can be and still the same number.
std::string literal(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

std::string macros(const noise::Recipe& recipe) {
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
    return text;
}

} // namespace

std::string snippet(const Document& document, Extent extent) {
    const render::Picture& picture = document.picture;
    const noise::Recipe& recipe = noise::find_recipe(picture.recipe);
    // The middle of the first pixel.
    const auto first = [&](const Coordinate& middle, int pixels) {
        return place_at(middle, (0.5 - pixels / 2.0) / picture.scale, recipe.radius);
    };
    const AxisPlace x = first(document.camera.x, extent.width);
    const AxisPlace y = first(document.camera.y, extent.height);
    const double cells_per_pixel = recipe.radius / picture.scale;
    const double radians = std::remainder(picture.orientation, 360.0) * std::numbers::pi / 180;
    const double time = picture.time - std::floor(picture.time);

    return fmt::format(R"(// Gabor noise, as gabor-viewer showed it: put after #version.
{}#include "gabor_noise.glsl" // or paste it here

// pixel: the place in the picture in pixels, from its upper left corner, y growing downwards.
// Mean 0, variance 1; gabor_unorm(noise_of_view(pixel)) is what to show.
float noise_of_view(vec2 pixel)
{{
    GaborPlace place = gabor_place(ivec2({}, {}), vec2({}, {}) + (pixel - 0.5) * {});
    place.time = {};
    GaborKernel kernel = gabor_kernel({}, {});
    return gabor_field(place, kernel, {}u).value.y;
}}
)",
                       macros(recipe), x.cell, y.cell, literal(x.local), literal(y.local),
                       literal(cells_per_pixel), literal(time), literal(picture.frequency), literal(radians),
                       picture.seed);
}

} // namespace gabor::viewer
