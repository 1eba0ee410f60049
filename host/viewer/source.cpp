#include "viewer/source.hpp"

#include "render/bake.hpp"

#include <fmt/format.h>

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
    return recipe.empty() ? 1 : double{noise::find_recipe(recipe).radius};
}

double Subject::visited() const {
    if (!recipe.empty())
        return noise::visited_impulses(noise::find_recipe(recipe));
    const double across = ingredients.points == study::Points::jittered_hex ? 4 : 3;
    return across * across * ingredients.impulses;
}

std::string Subject::name() const {
    if (!recipe.empty())
        return recipe;
    if (ingredients == study::Ingredients{})
        return "seminal";
    return fmt::format("{}, {}, {}, {}, N = {}", study::name(ingredients.points), study::name(ingredients.weights),
                       study::name(ingredients.kernel), study::name(ingredients.envelope), ingredients.impulses);
}

std::vector<Subject> subjects(const Document& document) {
    const int channels = channels_for(document.output);
    std::vector<Subject> all{{document.picture.recipe, {}, channels}};
    if (document.rival) {
        const bool ingredients = document.rival->recipe.empty();
        all.push_back({document.rival->recipe, document.rival->ingredients, ingredients ? 1 : channels});
    }
    return all;
}

std::string_view shader_of(const Subject& subject) {
    return subject.recipe.empty() ? "viewer/ingredients.comp" : "viewer/noise.comp";
}

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject,
                       const std::vector<std::uint32_t>& spirv) {
    std::vector<std::uint32_t> constants;
    if (subject.recipe.empty()) {
        constants = study::constants(subject.ingredients);
    } else {
        const auto of_recipe = render::recipe_constants(noise::find_recipe(subject.recipe));
        constants.assign(of_recipe.begin(), of_recipe.end());
    }
    constants.resize(channels_constant, 0);
    constants.push_back(vulkan::constant(subject.channels));
    return {device, spirv, {2, sizeof(FieldPush)}, constants};
}

FieldPush make_push(const Subject& subject, const render::Picture& picture) {
    FieldPush push{};
    push.frequency = static_cast<float>(picture.frequency);
    push.orientation = static_cast<float>(radians(picture));
    push.time = static_cast<float>(picture.time - std::floor(picture.time));
    push.amplitude = 1;
    if (subject.recipe.empty())
        push.amplitude = static_cast<float>(
            1 / std::sqrt(study::variance(subject.ingredients, {picture.frequency, radians(picture)})));
    push.seed = picture.seed;
    return push;
}

} // namespace gabor::viewer
