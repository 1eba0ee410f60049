#include "viewer/panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gabor::viewer {

namespace {

void recipe_choice(render::Picture& picture) {
    const noise::Recipe recipe = noise::find_recipe(picture.recipe);
    if (ImGui::BeginCombo("recipe", std::string(recipe.name).c_str())) {
        for (const noise::Recipe& known : noise::recipes()) {
            if (ImGui::Selectable(std::string(known.name).c_str(), known.name == picture.recipe))
                picture.recipe = known.name;
            tip(std::string(known.is).c_str());
        }
        ImGui::EndCombo();
    }
    tip("How quality is bought: impulses per cell, cells per radius, weights, phases, and the window");
}

void ingredients(render::Picture& picture) {
    noise::Recipe recipe = noise::find_recipe(picture.recipe);
    bool changed = ImGui::SliderInt("impulses N", &recipe.impulses, 1, noise::most_impulses);
    tip("Impulses per cell");
    changed |= ImGui::SliderFloat("radius R", &recipe.radius, 1, noise::largest_radius, "%.2f cells");
    tip("Cells per kernel radius: (ceil(2 R) + 1)^2 N impulses are visited for each pixel");
    changed |= ImGui::SliderFloat("floor A", &recipe.weight_floor, 0, 1, "%.3f");
    tip("A weight's magnitude is A or 1, equally likely");
    int power = static_cast<int>(std::lround(std::log2(recipe.phases)));
    constexpr std::array names{"2, a sine", "4", "8", "16", "32", "64", "128", "256"};
    if (ImGui::SliderInt("phases", &power, 1, 8,
                         names.at(static_cast<std::size_t>(std::clamp(power, 1, 8) - 1)),
                         ImGuiSliderFlags_NoInput)) {
        recipe.phases = 1 << std::clamp(power, 1, 8);
        changed = true;
    }
    tip("Phases that impulses have, evenly spread over a turn; with 2 each kernel integrates to exactly 0");
    changed |= ImGui::DragFloat3("window", recipe.window.data(), 0.01f, -10, 10, "%.2f");
    tip("c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2");
    if (changed && noise::acceptable(recipe))
        picture.recipe = noise::spelled_out(recipe);
}

} // namespace

void noise_panel(Session& session) {
    render::Picture& picture = session.document().picture;
    recipe_choice(picture);
    if (ImGui::TreeNode("ingredients")) {
        ingredients(picture);
        ImGui::TreePop();
    }

    auto scale = static_cast<float>(picture.scale);
    if (ImGui::SliderFloat("scale", &scale, static_cast<float>(render::smallest_scale),
                           static_cast<float>(render::largest_scale), "%.1f px",
                           ImGuiSliderFlags_Logarithmic))
        picture.scale = std::clamp(double{scale}, render::smallest_scale, render::largest_scale);
    tip("Pixels per kernel radius, which the wheel changes too");
    const std::uint32_t step = 1;
    ImGui::InputScalar("seed", ImGuiDataType_U32, &picture.seed, &step);
    tip("Which instance of the noise");

    auto time = static_cast<float>(picture.time - std::floor(picture.time));
    if (ImGui::Button(session.playing ? "pause" : "play"))
        session.playing = !session.playing;
    tip("Space: lets time go by, and begin again after 1");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - ImGui::GetCursorPosX() +
                            ImGui::GetStyle().WindowPadding.x);
    if (ImGui::SliderFloat("time", &time, 0, 1, "%.3f"))
        picture.time = time;
    tip("In periods of an animation in place that ends where it began");
    ImGui::SliderFloat("period", &session.period, 1, 60, "%.1f s", ImGuiSliderFlags_Logarithmic);
    tip("Seconds for time to go from 0 to 1");
}

} // namespace gabor::viewer
