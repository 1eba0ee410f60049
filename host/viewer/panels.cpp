#include "viewer/panels.hpp"

#include "render/load.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gabor::viewer {

namespace {

// What a row of the table is called, and what it says.
std::string label_of(const render::Parameter& parameter) {
    std::string label(parameter.name);
    std::ranges::replace(label, '_', ' ');
    return label;
}

std::string help_of(const render::Parameter& parameter) {
    return parameter.unit.empty() ? std::string(parameter.help)
                                  : fmt::format("{} ({})", parameter.help, parameter.unit);
}

// A control by the kind of its parameter, and the value that it was given just now.
std::optional<render::Value> edit(const render::Parameter& parameter, const render::Value& value) {
    using Kind = render::Parameter::Kind;
    const std::string label = label_of(parameter);
    switch (parameter.kind) {
    case Kind::flag: {
        bool on = std::get<bool>(value);
        return ImGui::Checkbox(label.c_str(), &on) ? std::optional<render::Value>(on) : std::nullopt;
    }
    case Kind::integer: {
        auto number = static_cast<std::uint32_t>(std::get<double>(value));
        const std::uint32_t step = 1;
        if (!ImGui::InputScalar(label.c_str(), ImGuiDataType_U32, &number, &step))
            return {};
        return std::clamp(static_cast<double>(number), parameter.range.low, parameter.range.high);
    }
    case Kind::number:
    case Kind::angle: {
        double number = std::get<double>(value);
        if (!number_slider(label.c_str(), number, parameter.range, parameter.slider))
            return {};
        return number;
    }
    case Kind::choice:
    case Kind::recipe: {
        std::optional<render::Value> chosen;
        const std::string& now = std::get<std::string>(value);
        if (ImGui::BeginCombo(label.c_str(), now.c_str())) {
            for (const std::string_view name : render::choices(parameter)) {
                if (ImGui::Selectable(std::string(name).c_str(), name == now))
                    chosen = std::string(name);
                if (parameter.kind == Kind::recipe)
                    tooltip(std::string(noise::find_recipe(name).is).c_str());
            }
            ImGui::EndCombo();
        }
        return chosen;
    }
    case Kind::text: {
        std::string text = std::get<std::string>(value);
        if (ImGui::InputText(label.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue))
            return text;
        return {};
    }
    case Kind::lobes: // spectrum_panel
        break;
    }
    return {};
}

// The control of a parameter, where the view and the lobes have it.
void control(Session& session, std::string_view name) {
    const render::Parameter& parameter = render::parameter(name);
    const std::optional<render::Value> value = parameter.get(session.document().request);
    if (!value)
        return;
    const std::optional<render::Value> edited = edit(parameter, *value);
    tooltip(help_of(parameter).c_str());
    if (edited)
        attempt(session, [&] { set_parameter(session.document(), name, *edited); });
}

void recipe_ingredients(render::Request& request) {
    noise::Recipe recipe = request.recipe;
    bool changed = ImGui::SliderInt("impulses N", &recipe.impulses, 1, noise::most_impulses);
    tooltip("Impulses per cell");
    changed |= ImGui::SliderFloat("radius R", &recipe.radius, 1, noise::largest_radius, "%.2f cells");
    tooltip("Cells per kernel radius: (ceil(2 R) + 1)^2 N impulses are visited for each pixel");
    changed |= ImGui::SliderFloat("floor A", &recipe.weight_floor, 0, 1, "%.3f");
    tooltip("A weight's magnitude is A or 1, equally likely");
    int power = static_cast<int>(std::lround(std::log2(recipe.phases)));
    constexpr std::array names{"2, a sine", "4", "8", "16", "32", "64", "128", "256"};
    if (ImGui::SliderInt("phases", &power, 1, 8,
                         names.at(static_cast<std::size_t>(std::clamp(power, 1, 8) - 1)),
                         ImGuiSliderFlags_NoInput)) {
        recipe.phases = 1 << std::clamp(power, 1, 8);
        changed = true;
    }
    tooltip(
        "Phases that impulses have, evenly spread over a turn; with 2 each kernel integrates to exactly 0");
    changed |= ImGui::DragFloat3("window", recipe.window.data(), 0.01f, -10, 10, "%.2f");
    tooltip("c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2");
    if (changed && noise::acceptable(recipe))
        request.recipe = noise::find_recipe(noise::spelled_out(recipe));
}

// Parameters that have a place of their own, here and in spectrum_panel.cpp. All others stand beside the
// export.
constexpr std::array<std::string_view, 19> placed{"recipe",
                                                  "scale",
                                                  "seed",
                                                  "paint",
                                                  "time",
                                                  "view",
                                                  "tileable",
                                                  "depth",
                                                  "solid",
                                                  "yaw",
                                                  "pitch",
                                                  "zoom",
                                                  "filter",
                                                  "lobes",
                                                  "frequency",
                                                  "orientation",
                                                  "frequency_spread",
                                                  "orientation_spread"};

constexpr std::array outputs{"value", "gradient", "phase", "intensity", "variance"};
constexpr std::array output_tips{
    "The noise itself, of mean 0 and variance 1", "Its analytic gradient, as a normal map",
    "The phase of the complex noise, for patterns of even contrast", "The magnitude of the complex noise",
    "The share of its variance that the filter leaves at each place; all of it without a filter"};
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

void comparison_choice(Comparison& comparison) {
    auto* ingredients = std::get_if<study::Ingredients>(&comparison);
    const bool seminal = ingredients && *ingredients == study::Ingredients{};
    const bool paper = ingredients && *ingredients == study::recommended;
    const std::string shown = seminal       ? "seminal, N = 30"
                              : paper       ? "the paper's advice, N = 2"
                              : ingredients ? "ingredients"
                                            : noise::spelled_out(std::get<noise::Recipe>(comparison));
    if (ImGui::BeginCombo("against", shown.c_str())) {
        if (ImGui::Selectable("seminal, N = 30", seminal))
            comparison = study::Ingredients{};
        if (ImGui::Selectable("the paper's advice, N = 2", paper))
            comparison = study::recommended;
        for (const noise::Recipe& recipe : noise::recipes())
            if (ImGui::Selectable(std::string(recipe.name).c_str(), comparison == Comparison(recipe)))
                comparison = recipe;
        ImGui::EndCombo();
    }
    tooltip("What stands on the right, with the same parameters");
    ingredients = std::get_if<study::Ingredients>(&comparison);
    if (ingredients && ImGui::TreeNode("its ingredients")) {
        choice("points", ingredients->points, study::all_points);
        choice("weights", ingredients->weights, study::all_weights);
        choice("kernel", ingredients->kernel, study::all_kernels);
        choice("envelope", ingredients->envelope, study::all_envelopes);
        ImGui::SliderInt("N", &ingredients->impulses, 1, 64, "%d",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        tooltip("Impulses per cell; the mean for Poisson points");
        ImGui::TreePop();
    }
}

void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = ImGui::GetStyle().FramePadding.x;
    draw.AddRectFilled({at.x, at.y}, {at.x + size.x + 2 * pad, at.y + size.y + pad},
                       IM_COL32(12, 13, 15, 200), ImGui::GetStyle().FrameRounding);
    draw.AddText({at.x + pad, at.y + pad / 2}, colour, text.c_str());
}

} // namespace

void noise_panel(Session& session) {
    render::Request& request = session.document().request;
    control(session, "recipe");
    if (!request.recipe.is_lattice() && ImGui::TreeNode("ingredients")) {
        recipe_ingredients(request);
        ImGui::TreePop();
    }
    for (const char* name : {"scale", "seed", "paint"})
        control(session, name);
    if (ImGui::Button(session.playing ? "pause" : "play"))
        session.playing = !session.playing;
    tooltip("Space: lets time go by, and begin again after 1");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - ImGui::GetCursorPosX() +
                            ImGui::GetStyle().WindowPadding.x);
    control(session, "time");
    ImGui::SliderFloat("period", &session.period, 1, 60, "%.1f s",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    tooltip("Seconds for time to go from 0 to 1");
}

void output_panel(Session& session) {
    Document& document = session.document();
    for (const char* name : {"view", "tileable", "depth", "solid", "yaw", "pitch", "zoom", "filter"})
        control(session, name);
    auto output = static_cast<int>(document.output);
    if (ImGui::BeginCombo("show", outputs.at(static_cast<std::size_t>(output)))) {
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            if (ImGui::Selectable(outputs[i], static_cast<int>(i) == output))
                document.output = static_cast<Output>(i);
            tooltip(output_tips.at(i));
        }
        ImGui::EndCombo();
    }
    tooltip("What is drawn, keys 1 to 5");
    ImGui::Combo("colours", &document.colours, maps.data(), static_cast<int>(maps.size()));
    tooltip("The colour map; a gradient is a normal map, and a phase goes round all hues, or is grey");
    ImGui::SliderFloat("contrast", &document.contrast, 0.5f, 6, "%.2f sd",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    tooltip("Standard deviations from the mean to the ends of the colour map; 2 in the pictures of gabor "
            "render");
    const bool one_recipe = render::in_space(document.request);
    ImGui::BeginDisabled(one_recipe);
    bool split = document.comparison.has_value();
    if (ImGui::Checkbox("split view", &split))
        document.comparison = split ? std::optional(Comparison()) : std::nullopt;
    tooltip(one_recipe ? "Noise in space has one recipe: there is nothing to compare it with"
                       : "Tab: two noises side by side, with their times");
    if (document.comparison)
        comparison_choice(*document.comparison);
    ImGui::EndDisabled();
}

void files_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = (width - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ImGui::Button("Copy GLSL", {width, 0}))
        copy_glsl(session);
    tooltip("Ctrl C: a function that draws this view with the drop-in, on the clipboard");

    if (ImGui::BeginCombo("begin with", "a preset")) {
        for (const render::Preset& preset : render::presets()) {
            const std::string name(preset.name);
            if (ImGui::Selectable(name.c_str())) {
                open_preset(session, name);
                session.preset_path = name + ".json";
            }
        }
        ImGui::EndCombo();
    }
    tooltip("Requests that come with the program: the paper's figure 6, and materials");
    ImGui::InputText("preset", &session.preset_path);
    tooltip(
        "A JSON file of parameters, which gabor render takes too, or an EXR that it rendered. Files can be "
        "dropped "
        "on the window.");
    if (ImGui::Button("Open", {half, 0}))
        open_preset(session, session.preset_path);
    tooltip("Ctrl O");
    ImGui::SameLine();
    if (ImGui::Button("Save", {half, 0}))
        save_preset(session);
    tooltip("Ctrl S");

    for (const render::Parameter& parameter : render::parameters())
        if (std::ranges::find(placed, parameter.name) == placed.end())
            control(session, parameter.name);
    ImGui::InputText("file", &session.export_target.path);
    tooltip("The EXR to write, 32-bit float, its parameters in the header");
    ImGui::Checkbox("PNG beside it", &session.export_target.png);
    if (session.exporter.running()) {
        ImGui::ProgressBar(static_cast<float>(session.exporter.progress()), {half, 0});
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {half, 0}))
            session.exporter.cancel();
    } else if (ImGui::Button("Export", {width, 0})) {
        start_export(session);
    }
    tooltip("Ctrl E: rendered beside the window by the code of gabor render");
    if (const std::string result = session.exporter.result(); !result.empty())
        ImGui::TextWrapped("%s", result.c_str());
}

void overlay(const Session& session, float width, float height) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float line = ImGui::GetFrameHeight() + 4;
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const bool split = session.panes.size() > 1;
    for (std::size_t i = 0; split && i < session.panes.size(); ++i) {
        const PaneReport& pane = session.panes[i];
        const float left = i == 0 ? 0 : width * session.divider;
        label(draw, {left + margin, margin},
              fmt::format("{}   {:.1f} ns per pixel   {:.0f} impulses", pane.name, pane.nanoseconds,
                          pane.visited),
              text);
        if (i == 1) {
            draw.AddLine({left, 0}, {left, height}, IM_COL32(12, 13, 15, 255), 3);
            const double times = pane.nanoseconds / session.panes[0].nanoseconds;
            label(draw, {left + margin, margin + line},
                  times >= 1 ? fmt::format("takes {:.1f} times as long", times)
                             : fmt::format("takes {:.2f} of the time", times),
                  ImGui::GetColorU32(ImGuiCol_CheckMark));
        }
    }
    const ImU32 red = IM_COL32(255, 120, 100, 255);
    const Message& message = session.message;
    if (ImGui::GetTime() < message.until)
        label(draw, {margin, height - line - margin}, message.text, message.error ? red : text);
    if (!session.shader_error.empty())
        label(draw, {margin, height - 2 * line - margin}, session.shader_error, red);
}

void question_window(Session& session) {
    constexpr const char* title = "Please confirm";
    if (session.question && !ImGui::IsPopupOpen(title))
        ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
        return;
    if (session.question) {
        ImGui::TextUnformatted(session.question->text.c_str());
        const std::string accept = session.question->accept + " (Enter)";
        if (ImGui::Button(accept.c_str()))
            answer(session, true);
        ImGui::SameLine();
        if (ImGui::Button("Cancel (Esc)"))
            answer(session, false);
    }
    if (!session.question)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool number_slider(const char* label, double& value, const render::Range& range,
                   const render::Range& slider) {
    auto shown = static_cast<float>(value);
    const ImGuiSliderFlags logarithmic = slider.low > 0 ? ImGuiSliderFlags_Logarithmic : 0;
    if (!ImGui::SliderFloat(label, &shown, static_cast<float>(slider.low), static_cast<float>(slider.high),
                            "%.3g", logarithmic | ImGuiSliderFlags_NoRoundToFormat))
        return false;
    value = std::clamp(double{shown}, range.low, range.high);
    return true;
}

void tooltip(const char* text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(text);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

} // namespace gabor::viewer
