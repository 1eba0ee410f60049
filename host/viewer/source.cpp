#include "viewer/source.hpp"

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

Subject of_drop_in(const render::Picture& picture, View view) {
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

Subject of_ingredients(const render::Picture& picture, View view, const study::Ingredients& ingredients) {
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

Subject of_body(const render::Picture& picture, View view, Waves waves) {
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

Axes axes_of(const Subject& subject) {
    if (subject.ingredients)
        return {{1, 0}, {1, 0}};
    if (on_body(subject.view)) {
        const double radius = noise::recipe_3d().radius;
        return {{radius, 0}, {radius, 0}};
    }
    return {render::axis_along(subject.picture, subject.picture.width),
            render::axis_along(subject.picture, subject.picture.height)};
}

void add_pixels(std::vector<AxisPlace>& places, int cell, int pixels, int stride, double middle) {
    for (int i = 0; i * stride < pixels; ++i)
        places.push_back({cell, static_cast<float>((i + 0.5) * stride - middle)});
}

} // namespace

std::vector<Subject> subjects(const Document& document) {
    const render::Picture picture = with_channels(document.picture, document.output);
    const View view = document.view();
    if (on_body(view)) // there is one recipe in space
        return {of_body(picture, view, document.waves)};
    std::vector<Subject> all{of_drop_in(picture, view)};
    if (document.rival && document.rival->recipe.empty()) {
        all.push_back(of_ingredients(picture, view, document.rival->ingredients));
    } else if (document.rival) {
        render::Picture other = picture;
        other.recipe = document.rival->recipe;
        all.push_back(of_drop_in(other, view));
    }
    return all;
}

Subject in_plane(Subject subject) {
    if (on_body(subject.view)) {
        subject.constants[12] = flat_solid;
        return subject;
    }
    subject.picture.view = "flat";
    subject.picture.paint.clear();
    if (subject.ingredients)
        return of_ingredients(subject.picture, View::plane, *subject.ingredients);
    subject.picture.filter = false;
    subject.picture.quadrature = false;
    subject.picture.gradient = false;
    return of_drop_in(subject.picture, View::plane);
}

Look look_of(const Subject& subject, const Document& document, Extent extent) {
    const render::Picture& picture = subject.picture;
    const noise::Lobe first = render::spectrum(picture).front();
    const Axes axes = axes_of(subject);
    Look look;
    look.lobes = render::pass_lobes(picture);
    render::PixelsPush& push = look.push.pixels;
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
    look.push.amplitude = 1;
    if (subject.ingredients)
        look.push.amplitude = static_cast<float>(
            1 / std::sqrt(study::variance(*subject.ingredients, {first.frequency, first.orientation})));
    if (subject.view == View::perspective) {
        push.pixel =
            static_cast<float>((extent.height - 0.5 - render::sky_rows(extent.height)) / picture.scale);
        push.camera_x = place_at(document.camera.x, 0, axes.x.radius).local;
        push.camera_y = place_at(document.camera.y, 0, axes.y.radius).local;
    } else if (on_body(subject.view)) {
        // A body fits the view, and is as coarse, as it is in the pictures of render::SolidPicture.
        const render::SolidPicture like{.width = picture.width,
                                        .height = picture.height,
                                        .view = render::SolidView::sphere,
                                        .scale = picture.scale};
        push.pixel = static_cast<float>(render::sphere_radius(like));
        push.focal_length =
            static_cast<float>(std::min(extent.width, extent.height) * double{document.pose.nearness} /
                               (2 * 1.05 * std::tan(std::asin(0.25))));
        look.push.yaw = static_cast<float>(double{document.pose.yaw} * degree);
        look.push.pitch = static_cast<float>(double{document.pose.pitch} * degree);
    }
    return look;
}

Places places_of(const Subject& subject, const Document& document, Extent extent, int stride) {
    const Axes axes = axes_of(subject);
    Places places;
    switch (subject.view) {
    case View::plane:
        add_places(places.columns, document.camera.x, extent.width, subject.picture.scale, stride,
                   axes.x.radius);
        add_places(places.rows, document.camera.y, extent.height, subject.picture.scale, stride,
                   axes.y.radius);
        break;
    case View::perspective:
        add_pixels(places.columns, place_at(document.camera.x, 0, axes.x.radius).cell, extent.width, stride,
                   extent.width / 2.0);
        add_pixels(places.rows, place_at(document.camera.y, 0, axes.y.radius).cell, extent.height, stride,
                   render::sky_rows(extent.height));
        break;
    default:
        add_pixels(places.columns, 0, extent.width, stride, extent.width / 2.0);
        add_pixels(places.rows, 0, extent.height, stride, extent.height / 2.0);
    }
    return places;
}

Places random_places(const Subject& subject, int columns, int rows, std::uint32_t draw) {
    // Further apart than two impulses of one kernel can be: a diameter and a cell.
    const Axes axes = axes_of(subject);
    const int apart = static_cast<int>(std::ceil(2 * std::max(axes.x.radius, axes.y.radius))) + 2;
    std::mt19937 generator(draw);
    const auto place = [&](int i) {
        return AxisPlace{i * apart, static_cast<float>(generator() >> 8) * 0x1p-24f};
    };
    Places places;
    for (int i = 0; i < columns; ++i)
        places.columns.push_back(place(i));
    for (int i = 0; i < rows; ++i)
        places.rows.push_back(place(i));
    return places;
}

} // namespace gabor::viewer
