#include "viewer/panels.hpp"

#include <imgui.h>

#include <array>

namespace gabor::viewer {

namespace {

constexpr std::array outputs{"value", "gradient", "phase", "intensity", "variance"};
constexpr std::array output_tips{
    "The noise itself, of mean 0 and variance 1", "Its analytic gradient, as a normal map",
    "The phase of the complex noise, for patterns of even contrast", "The magnitude of the complex noise",
    "The share of its variance that the filter leaves at each place; all of it without a filter"};
constexpr std::array views{"plane", "plane in perspective", "sphere", "torus"};
constexpr std::array waves{"one direction, in space", "all directions, in space",
                           "one direction, along the surface", "all directions, along the surface"};
constexpr std::array maps{"grey", "viridis", "cool to warm", "ember", "sea"};

template <typename Enum, std::size_t count>
bool choice(const char* label, Enum& value, const std::array<Enum, count>& all) {
    bool changed = false;
    if (ImGui::BeginCombo(label, std::string(study::name(value)).c_str())) {
        for (const Enum each : all)
            if (ImGui::Selectable(std::string(study::name(each)).c_str(), each == value)) {
                value = each;
                changed = true;
            }
        ImGui::EndCombo();
    }
    return changed;
}

void rival_choice(Document& document) {
    Rival& rival = *document.rival;
    const bool seminal = rival.recipe.empty() && rival.ingredients == study::Ingredients{};
    const bool paper = rival.recipe.empty() && rival.ingredients == study::recommended;
    const char* shown = seminal                ? "seminal, N = 30"
                        : paper                ? "the paper's advice, N = 2"
                        : rival.recipe.empty() ? "ingredients"
                                               : rival.recipe.c_str();
    if (ImGui::BeginCombo("against", shown)) {
        if (ImGui::Selectable("seminal, N = 30", seminal))
            rival = {};
        if (ImGui::Selectable("the paper's advice, N = 2", paper))
            rival = {{}, study::recommended};
        for (const noise::Recipe& recipe : noise::recipes())
            if (ImGui::Selectable(std::string(recipe.name).c_str(), rival.recipe == recipe.name))
                rival = {std::string(recipe.name), {}};
        ImGui::EndCombo();
    }
    tip("What stands on the right, on the same parameters");
    if (rival.recipe.empty() && ImGui::TreeNode("its ingredients")) {
        study::Ingredients& i = rival.ingredients;
        choice("points", i.points, study::all_points);
        choice("weights", i.weights, study::all_weights);
        choice("kernel", i.kernel, study::all_kernels);
        choice("envelope", i.envelope, study::all_envelopes);
        ImGui::SliderInt("N", &i.impulses, 1, 64, "%d", ImGuiSliderFlags_Logarithmic);
        tip("Impulses per cell; the mean for Poisson points");
        ImGui::TreePop();
    }
}

void view_choice(Document& document) {
    auto view = static_cast<int>(document.view());
    if (ImGui::Combo("view", &view, views.data(), static_cast<int>(views.size())))
        document.set_view(static_cast<View>(view));
    tip("V: a drag moves planes and turns bodies");
    if (document.body) {
        auto chosen = static_cast<int>(document.waves);
        if (ImGui::Combo("waves", &chosen, waves.data(), static_cast<int>(waves.size())))
            document.waves = static_cast<Waves>(chosen);
        tip("Solid noise, whose waves go through the body, or surface noise, whose waves go along its "
            "surface");
    }
    if (ImGui::Checkbox("filtered", &document.picture.filter) && document.picture.filter) {
        document.picture.gradient = false; // they exclude each other
        document.picture.values = 1;
    }
    tip("F: seen through the footprints of pixels, so that nothing flickers in the distance");
}

} // namespace

void output_panel(Session& session) {
    Document& document = session.document();
    view_choice(document);
    auto output = static_cast<int>(document.output);
    if (ImGui::BeginCombo("show", outputs.at(static_cast<std::size_t>(output)))) {
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            if (ImGui::Selectable(outputs[i], static_cast<int>(i) == output))
                document.output = static_cast<Output>(i);
            tip(output_tips.at(i));
        }
        ImGui::EndCombo();
    }
    tip("What is drawn, keys 1 to 5");
    ImGui::Combo("colours", &document.colours, maps.data(), static_cast<int>(maps.size()));
    tip("The colour map; a gradient is a normal map, and a phase goes round all hues, or is grey");
    ImGui::SliderFloat("contrast", &document.contrast, 0.5f, 6, "%.2f sd", ImGuiSliderFlags_Logarithmic);
    tip("Standard deviations from the mean to the ends of the colour map; 2 in the pictures of gabor render");
    bool split = document.rival.has_value();
    if (ImGui::Checkbox("split view", &split)) {
        if (split)
            document.rival.emplace();
        else
            document.rival.reset();
    }
    tip("Tab: two recipes side by side, with their times");
    if (document.rival && !document.body)
        rival_choice(document);
}

} // namespace gabor::viewer
