#include "viewer/noise_pass.hpp"

#include "noise/reference_3d.hpp"
#include "render/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gabor::viewer {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::uint32_t flat_solid = 2; // in shaders/viewer/solid.comp

// The picture with those channels alone that an output is made of.
render::Picture with_channels(render::Picture picture, Output output) {
    picture.gradient = output == Output::gradient;
    picture.quadrature = output == Output::phase || output == Output::intensity;
    picture.phasor = false;
    picture.values = 1;
    picture.filter = picture.filter && !picture.gradient;
    return picture;
}

NoisePass of_drop_in(const render::Picture& picture, View view) {
    const noise::Recipe recipe = noise::find_recipe(picture.recipe);
    return {"passes/pixels.comp",
            render::pixels_constants(picture),
            picture,
            view,
            {},
            std::string(recipe.name),
            static_cast<double>(noise::visited_impulses(recipe)),
            static_cast<int>(render::channels(picture).size())};
}

NoisePass of_ingredients(const render::Picture& picture, View view, const study::Ingredients& ingredients) {
    std::vector<std::uint32_t> constants = study::constants(ingredients);
    constants.resize(12, 0);
    constants.push_back(view == View::perspective);
    const double across = ingredients.points == study::Points::jittered_hex ? 4 : 3;
    const std::string name =
        ingredients == study::Ingredients{} ? "seminal"
        : ingredients == study::recommended
            ? "the paper's advice"
            : fmt::format("{}, {}, {}, {}, N = {}", study::name(ingredients.points),
                          study::name(ingredients.weights), study::name(ingredients.kernel),
                          study::name(ingredients.envelope), ingredients.impulses);
    return {"viewer/ingredients.comp",
            constants,
            picture,
            view,
            ingredients,
            name,
            across * across * ingredients.impulses,
            1};
}

NoisePass of_body(const render::Picture& picture, View view, Waves waves) {
    const noise::Recipe& recipe = noise::recipe_3d();
    using vulkan::constant;
    std::vector<std::uint32_t> constants{constant(recipe.impulses), constant(recipe.radius),
                                         constant(recipe.window[0]), constant(recipe.window[1]),
                                         constant(recipe.window[2])};
    constants.resize(12, 0);
    constants.push_back(view == View::torus);
    constants.push_back(static_cast<std::uint32_t>(waves));
    constants.push_back(picture.filter);
    constants.push_back(picture.quadrature);
    constants.push_back(picture.gradient);
    return {"viewer/solid.comp",
            constants,
            picture,
            view,
            {},
            "in space",
            static_cast<double>(noise::visited_impulses_3d(recipe)),
            1 + picture.quadrature + 2 * picture.gradient};
}

// Cells per kernel radius, and the period, along each axis.
struct Axes {
    render::Axis x;
    render::Axis y;
};

Axes axes_of(const NoisePass& noise) {
    if (noise.ingredients)
        return {{1, 0}, {1, 0}};
    if (on_body(noise.view)) {
        const double radius = noise::recipe_3d().radius;
        return {{radius, 0}, {radius, 0}};
    }
    return {render::axis_along(noise.picture, noise.picture.width),
            render::axis_along(noise.picture, noise.picture.height)};
}

void add_pixels(std::vector<AxisPoint>& points, int cell, int pixels, int stride, double middle) {
    for (int i = 0; i * stride < pixels; ++i)
        points.push_back({cell, static_cast<float>((i + 0.5) * stride - middle)});
}

} // namespace

AxisPoint axis_point(const Coordinate& coordinate, double by, double radius) {
    const long double far = static_cast<long double>(coordinate.whole) * radius;
    const long double base = std::floor(far);
    const double cells = static_cast<double>(far - base) + (coordinate.part + by) * radius;
    const double whole = std::floor(cells);
    const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(whole);
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), static_cast<float>(cells - whole)};
}

void add_points(std::vector<AxisPoint>& points, const Coordinate& middle, int pixels, double scale,
                int stride, double radius) {
    const int count = (pixels + stride - 1) / stride;
    for (int i = 0; i < count; ++i)
        points.push_back(axis_point(middle, ((i + 0.5) * stride - pixels / 2.0) / scale, radius));
}

std::vector<NoisePass> noise_passes(const Document& document) {
    const render::Picture picture = with_channels(document.picture, document.output);
    const View view = document.view();
    if (on_body(view)) // there is one recipe in space
        return {of_body(picture, view, document.waves)};
    std::vector<NoisePass> all{of_drop_in(picture, view)};
    if (document.comparison && document.comparison->recipe.empty()) {
        all.push_back(of_ingredients(picture, view, document.comparison->ingredients));
    } else if (document.comparison) {
        render::Picture other = picture;
        other.recipe = document.comparison->recipe;
        all.push_back(of_drop_in(other, view));
    }
    return all;
}

NoisePass in_plane(NoisePass noise) {
    if (on_body(noise.view)) {
        noise.constants[12] = flat_solid;
        return noise;
    }
    noise.picture.view = "flat";
    noise.picture.paint.clear();
    if (noise.ingredients)
        return of_ingredients(noise.picture, View::plane, *noise.ingredients);
    noise.picture.filter = false;
    noise.picture.quadrature = false;
    noise.picture.gradient = false;
    return of_drop_in(noise.picture, View::plane);
}

ViewParameters view_parameters(const NoisePass& noise, const Document& document, Extent extent) {
    const render::Picture& picture = noise.picture;
    const noise::Lobe first = render::spectrum(picture).front();
    const Axes axes = axes_of(noise);
    ViewParameters parameters;
    parameters.lobes = render::pass_lobes(picture);
    render::PixelsPush& push = parameters.push.pixels;
    push.radius_x = static_cast<float>(axes.x.radius);
    push.radius_y = static_cast<float>(axes.y.radius);
    push.period_x = axes.x.period;
    push.period_y = axes.y.period;
    push.time = static_cast<float>(picture.time - std::floor(picture.time));
    push.frequency = static_cast<float>(first.frequency);
    push.orientation = static_cast<float>(first.orientation);
    push.pixel = static_cast<float>(1 / picture.scale);
    push.focal_length = static_cast<float>(extent.width);
    push.seed = picture.seed;
    push.paint_width = push.paint_height = 1;
    parameters.push.amplitude = 1;
    if (noise.ingredients)
        parameters.push.amplitude = static_cast<float>(
            1 / std::sqrt(study::variance(*noise.ingredients, {first.frequency, first.orientation})));
    if (noise.view == View::perspective) {
        push.pixel =
            static_cast<float>((extent.height - 0.5 - render::sky_rows(extent.height)) / picture.scale);
        push.camera_x = axis_point(document.camera.x, 0, axes.x.radius).local;
        push.camera_y = axis_point(document.camera.y, 0, axes.y.radius).local;
    } else if (on_body(noise.view)) {
        // A body fits the view, and is as coarse, as it is in the pictures of render::SolidPicture.
        const render::SolidPicture like{.width = picture.width,
                                        .height = picture.height,
                                        .view = render::SolidView::sphere,
                                        .scale = picture.scale};
        push.pixel = static_cast<float>(render::sphere_radius(like));
        push.focal_length =
            static_cast<float>(std::min(extent.width, extent.height) * double{document.orbit.zoom} /
                               (2 * 1.05 * std::tan(std::asin(0.25))));
        parameters.push.yaw = static_cast<float>(double{document.orbit.yaw} * degree);
        parameters.push.pitch = static_cast<float>(double{document.orbit.pitch} * degree);
    }
    return parameters;
}

SamplePoints sample_points(const NoisePass& noise, const Document& document, Extent extent, int stride) {
    const Axes axes = axes_of(noise);
    SamplePoints points;
    switch (noise.view) {
    case View::plane:
        add_points(points.columns, document.camera.x, extent.width, noise.picture.scale, stride,
                   axes.x.radius);
        add_points(points.rows, document.camera.y, extent.height, noise.picture.scale, stride, axes.y.radius);
        break;
    case View::perspective:
        add_pixels(points.columns, axis_point(document.camera.x, 0, axes.x.radius).cell, extent.width, stride,
                   extent.width / 2.0);
        add_pixels(points.rows, axis_point(document.camera.y, 0, axes.y.radius).cell, extent.height, stride,
                   render::sky_rows(extent.height));
        break;
    default:
        add_pixels(points.columns, 0, extent.width, stride, extent.width / 2.0);
        add_pixels(points.rows, 0, extent.height, stride, extent.height / 2.0);
    }
    return points;
}

SamplePoints random_points(const NoisePass& noise, int columns, int rows, std::uint32_t draw) {
    // Further apart than two impulses of one kernel can be: a diameter and a cell.
    const Axes axes = axes_of(noise);
    const int apart = static_cast<int>(std::ceil(2 * std::max(axes.x.radius, axes.y.radius))) + 2;
    std::mt19937 generator(draw);
    const auto place = [&](int i) {
        return AxisPoint{i * apart, static_cast<float>(generator() >> 8) * 0x1p-24f};
    };
    SamplePoints points;
    for (int i = 0; i < columns; ++i)
        points.columns.push_back(place(i));
    for (int i = 0; i < rows; ++i)
        points.rows.push_back(place(i));
    return points;
}

} // namespace gabor::viewer
