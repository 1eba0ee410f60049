#include "viewer/source.hpp"

#include "noise/reference_3d.hpp"
#include "render/bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::viewer {

namespace {

double radians(const render::Picture& picture) {
    return std::remainder(picture.orientation, 360.0) * std::numbers::pi / 180;
}

int channels_for(Output output) {
    switch (output) {
    case Output::value:
        return 1;
    case Output::gradient:
        return 4;
    default:
        return 2;
    }
}

constexpr std::size_t channels_constant = 12; // in shaders/viewer/grid.glsl

} // namespace

double Subject::radius() const {
    if (on_body(view))
        return double{noise::recipe_3d().radius};
    return recipe.empty() ? 1 : double{noise::find_recipe(recipe).radius};
}

double Subject::visited() const {
    if (on_body(view))
        return noise::visited_impulses_3d(noise::recipe_3d());
    if (!recipe.empty())
        return noise::visited_impulses(noise::find_recipe(recipe));
    const double across = ingredients.points == study::Points::jittered_hex ? 4 : 3;
    return across * across * ingredients.impulses;
}

std::string Subject::name() const {
    if (on_body(view))
        return "in space";
    if (!recipe.empty())
        return recipe;
    if (ingredients == study::Ingredients{})
        return "seminal";
    return fmt::format("{}, {}, {}, {}, N = {}", study::name(ingredients.points), study::name(ingredients.weights),
                       study::name(ingredients.kernel), study::name(ingredients.envelope), ingredients.impulses);
}

std::vector<Subject> subjects(const Document& document) {
    const int channels = channels_for(document.output);
    const View view = document.view;
    if (on_body(view)) // there is one recipe in space
        return {{{}, {}, channels, view, document.waves, document.filtered}};
    const bool filtered = document.filtered && view == View::perspective;
    std::vector<Subject> all{{document.picture.recipe, {}, channels, view, Waves::oriented, filtered}};
    if (document.rival) {
        const bool ingredients = document.rival->recipe.empty();
        all.push_back({document.rival->recipe, document.rival->ingredients, ingredients ? 1 : channels, view,
                       Waves::oriented, filtered && !ingredients});
    }
    return all;
}

std::string_view shader_of(const Subject& subject) {
    if (on_body(subject.view))
        return "viewer/solid.comp";
    return subject.recipe.empty() ? "viewer/ingredients.comp" : "viewer/noise.comp";
}

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject,
                       const std::vector<std::uint32_t>& spirv) {
    std::vector<std::uint32_t> constants;
    if (on_body(subject.view)) {
        const noise::Recipe& recipe = noise::recipe_3d();
        constants = {vulkan::constant(recipe.impulses), vulkan::constant(recipe.radius),
                     vulkan::constant(recipe.window[0]), vulkan::constant(recipe.window[1]),
                     vulkan::constant(recipe.window[2])};
    } else if (subject.recipe.empty()) {
        constants = study::constants(subject.ingredients);
    } else {
        const auto of_recipe = render::recipe_constants(noise::find_recipe(subject.recipe));
        constants.assign(of_recipe.begin(), of_recipe.end());
    }
    constants.resize(channels_constant, 0);
    constants.push_back(vulkan::constant(subject.channels));
    constants.push_back(vulkan::constant(static_cast<std::int32_t>(subject.view)));
    constants.push_back(vulkan::constant(static_cast<std::int32_t>(subject.waves)));
    constants.push_back(subject.filtered);
    return {device, spirv, {2, sizeof(FieldPush)}, constants};
}

FieldPush make_push(const Subject& subject, const Document& document, Extent extent) {
    const render::Picture& picture = document.picture;
    FieldPush push{};
    push.frequency = static_cast<float>(picture.frequency);
    push.orientation = static_cast<float>(radians(picture));
    push.time = static_cast<float>(picture.time - std::floor(picture.time));
    push.amplitude = 1;
    if (subject.recipe.empty() && !on_body(subject.view))
        push.amplitude = static_cast<float>(
            1 / std::sqrt(study::variance(subject.ingredients, {picture.frequency, radians(picture)})));
    push.seed = picture.seed;
    if (subject.view == View::plane)
        return push; // the places say it all
    push.middle_x = static_cast<float>(extent.width) / 2;
    push.middle_y = static_cast<float>(extent.height) / 2;
    const double shorter = std::min(extent.width, extent.height);
    constexpr double degree = std::numbers::pi / 180;
    if (subject.view == View::perspective) {
        push.focal = static_cast<float>(1.1 * shorter);
        push.unit = static_cast<float>(double{push.focal} / picture.scale);
        push.pitch = static_cast<float>(double{document.pose.tilt} * degree);
        const AxisPlace x = place_at(document.camera.x, 0, subject.radius());
        const AxisPlace y = place_at(document.camera.y, 0, subject.radius());
        push.cell_x = x.cell;
        push.cell_y = y.cell;
        push.local_x = x.local;
        push.local_y = y.local;
        return push;
    }
    // A body fits the view as it does in the pictures of render::SolidPicture.
    const render::SolidPicture like{
        .width = picture.width, .height = picture.height, .view = render::SolidView::sphere, .scale = picture.scale};
    push.focal = static_cast<float>(shorter * double{document.pose.nearness} /
                                    (2 * 1.05 * std::tan(std::asin(0.25))));
    push.unit = static_cast<float>(render::sphere_radius(like));
    push.yaw = static_cast<float>(double{document.pose.yaw} * degree);
    push.pitch = static_cast<float>(double{document.pose.pitch} * degree);
    return push;
}

} // namespace gabor::viewer
