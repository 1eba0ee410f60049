#include "viewer/panels.hpp"

#include "render/load.hpp"
#include "viewer/document_json.hpp"
#include "viewer/effect.hpp"
#include "viewer/slider.hpp"

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

// What the parameter is in a view like this one, where nobody has set it.
double default_of(const render::Parameter& parameter, const render::Request& request) {
    render::Request fresh;
    render::set(fresh, "view", *render::parameter("view").get(request));
    return std::get<double>(*parameter.get(fresh));
}

// A control by the kind of its parameter, and the value that it was given just now.
std::optional<render::Value> edit(const render::Parameter& parameter, const render::Value& value,
                                  const render::Request& request) {
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
        if (!number_slider(label.c_str(), number, parameter.range, parameter.slider,
                           default_of(parameter, request)))
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
                    tooltip(noise::find_recipe(name).summary);
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
    const render::Request& request = session.document().request;
    const std::optional<render::Value> value = parameter.get(request);
    if (!value)
        return;
    std::optional<render::Value> edited;
    explained(disabled_reason(session.document(), name), help_of(parameter),
              [&] { edited = edit(parameter, *value, request); });
    if (edited)
        attempt(session, [&] { set_parameter(session.document(), name, *edited); });
}

void recipe_ingredients(render::Request& request) {
    noise::Recipe recipe = request.recipe;
    bool changed = slider("impulses N", recipe.impulses, 1, noise::most_impulses, "%d");
    tooltip("Impulses per cell");
    changed |= slider("radius R", recipe.radius, 1.0f, noise::largest_radius, "%.2f cells");
    tooltip("Cells per kernel radius: (ceil(2 R) + 1)^2 N impulses are visited for each pixel");
    changed |= slider("floor A", recipe.weight_floor, 0.0f, 1.0f, "%.3f");
    tooltip("A weight's magnitude is A or 1, equally likely");
    int power = static_cast<int>(std::lround(std::log2(recipe.phases)));
    constexpr std::array names{"2, a sine", "4", "8", "16", "32", "64", "128", "256"};
    if (slider("phases", power, 1, 8, names.at(static_cast<std::size_t>(std::clamp(power, 1, 8) - 1)),
               ImGuiSliderFlags_NoInput)) {
        recipe.phases = 1 << std::clamp(power, 1, 8);
        changed = true;
    }
    tooltip(
        "Phases that impulses have, evenly spread over a turn; with 2 each kernel integrates to exactly 0");
    changed |= ImGui::DragFloat3("window", recipe.window.data(), 0.01f, -10, 10, "%.2f");
    tooltip("c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2");
    if (changed && noise::acceptable(recipe))
        request.recipe = noise::find_recipe(noise::to_string(recipe));
}

// Parameters that have a place of their own, here and in spectrum_panel.cpp. All others stand beside the
// export.
constexpr std::array<std::string_view, 19> placed{"material",
                                                  "recipe",
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

constexpr std::array output_tips{
    "The noise itself, of mean 0 and variance 1",
    "Its analytic gradient, as a normal map",
    "The phase of the complex noise, for patterns of even contrast",
    "The magnitude of the complex noise",
    "The share of its variance that the filter leaves at each place; all of it without a filter",
    "A wave of the same height everywhere, along the phase",
    "The value as a height, under a lamp"};

constexpr std::array look_tips{"Under a lamp",
                               "The base colour of physically based shading",
                               "How high the surface stands; mean height is grey",
                               "A normal map of the height",
                               "Dark is smooth; its square is the width of the microfacets' slopes",
                               "White where the base colour is that of its reflections"};

// A name from a list, by its number.
template <typename Tip>
bool choose(const char* label, int& number, std::span<const std::string_view> names, Tip tip) {
    bool changed = false;
    if (ImGui::BeginCombo(label, std::string(names[static_cast<std::size_t>(number)]).c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(std::string(names[i]).c_str(), static_cast<int>(i) == number)) {
                number = static_cast<int>(i);
                changed = true;
            }
            tip(i);
        }
        ImGui::EndCombo();
    }
    return changed;
}

// Beside the field of its name.
void paint_button(Session& session) {
    ImGui::SameLine();
    explained(disabled_reason(session.document(), "paint"), "Choose a file", [&] {
        if (ImGui::SmallButton("..."))
            ask_for_paint(session);
    });
}

} // namespace

void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = ImGui::GetStyle().FramePadding.x;
    draw.AddRectFilled({at.x, at.y}, {at.x + size.x + 2 * pad, at.y + size.y + pad},
                       IM_COL32(12, 13, 15, 200), ImGui::GetStyle().FrameRounding);
    draw.AddText({at.x + pad, at.y + pad / 2}, colour, text.c_str());
}

void noise_panel(Session& session) {
    render::Request& request = session.document().request;
    control(session, "recipe");
    if (!request.recipe.is_lattice() && !render::has_material(request) && ImGui::TreeNode("ingredients")) {
        recipe_ingredients(request);
        ImGui::TreePop();
    }
    for (const char* name : {"scale", "seed", "paint"})
        control(session, name);
    paint_button(session);
    if (ImGui::Button(session.playing ? "pause" : "play"))
        session.playing = !session.playing;
    tooltip("Space: lets time go by, and begin again after 1");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - ImGui::GetCursorPosX() +
                            ImGui::GetStyle().WindowPadding.x);
    control(session, "time");
    slider("period", session.period, 1.0f, 60.0f, "%.1f s",
           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (reset_asked("period"))
        session.period = Session::default_period;
    tooltip("Seconds for time to go from 0 to 1");
}

void output_panel(Session& session) {
    Document& document = session.document();
    for (const char* name : {"material", "view", "tileable"})
        control(session, name);
    explained(
        disabled_reason(document, "tiles"),
        "T: four copies of the picture, as tiles: a seam between them would show. The view has a scale of "
        "its own then.",
        [&] { ImGui::Checkbox("2 x 2 tiles", &session.tiles); });
    for (const char* name : {"depth", "solid", "yaw", "pitch", "zoom", "filter"})
        control(session, name);
    if (render::has_material(document.request)) {
        auto look = static_cast<int>(document.look);
        if (choose("show", look, look_names(), [](std::size_t i) { tooltip(look_tips.at(i)); }))
            document.look = static_cast<Look>(look);
        tooltip("What of the material is drawn, keys 1 to 6");
    } else {
        auto output = static_cast<int>(document.output);
        if (choose("show", output, output_names(), [](std::size_t i) { tooltip(output_tips.at(i)); }))
            document.output = static_cast<Output>(output);
        tooltip("What is drawn, keys 1 to 7");
    }
    ImGui::Checkbox("DirectX normals", &document.directx_normals);
    tooltip("Normal maps have green for down, as DirectX, and not for up, as OpenGL");
    explained(disabled_reason(document, "colours"), "The colour map; a phase goes round all hues, or is grey",
              [&] { choose("colours", document.colours, colour_names(), [](std::size_t) {}); });
    explained(
        disabled_reason(document, "contrast"),
        "Standard deviations from the mean to the ends of the colour map; 2 in the pictures of gabor render",
        [&] {
            slider("contrast", document.contrast, least_contrast, most_contrast, "%.2f sd",
                   ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
            if (reset_asked("contrast"))
                document.contrast = Document().contrast;
        });
}

void files_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Button("Copy GLSL", {width, 0}))
        copy_glsl(session);
    tooltip("Ctrl C: a function that draws this view with the drop-in, on the clipboard");

    if (ImGui::Button("Presets...", {width, 0}))
        session.gallery = true;
    tooltip("P: those that come with the program, as pictures");
    ImGui::InputText("preset", &session.preset_path);
    tooltip(
        "A JSON file of parameters, which gabor render takes too, or an EXR that it rendered. Files can be "
        "dropped "
        "on the window.");
    const float third = (width - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button("Open...", {third, 0}))
        ask_for_file(session);
    tooltip("Ctrl O: a preset, an EXR that gabor rendered, or a photograph, to which a noise is fitted");
    ImGui::SameLine();
    if (ImGui::Button("Save", {third, 0}))
        save_preset(session);
    tooltip("Ctrl S");
    ImGui::SameLine();
    if (ImGui::Button("Save as...", {third, 0}))
        ask_where_to_save(session);

    if (ImGui::BeginCombo("interface", fmt::format("{:.0f} %", 100 * session.ui_scale).c_str())) {
        for (const float scale : {0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f})
            if (ImGui::Selectable(fmt::format("{:.0f} %", 100 * scale).c_str(), scale == session.ui_scale))
                session.ui_scale = scale;
        ImGui::EndCombo();
    }
    tooltip("How large panels and text are; letters are sharp from the next start on");
}

void other_parameters(Session& session) {
    for (const render::Parameter& parameter : render::parameters())
        if (std::ranges::find(placed, parameter.name) == placed.end())
            control(session, parameter.name);
}

void view_overlay(const Session& session) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    if (session.tiling)
        label(draw, {margin, margin},
              fmt::format("2 x 2 tiles at {:.0f} %", 100 * session.tiling->camera.zoom), text);
    else if (const double zoom = session.history.now.camera.zoom; zoom != 1)
        label(draw, {margin, margin}, fmt::format("view at {:.0f} %", 100 * zoom), text);
}

void message_overlay(const Session& session, float height) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const ImU32 red = IM_COL32(255, 120, 100, 255);
    const auto say = [&](int line, const std::string& what, ImU32 colour) { // lines from below
        const float up = static_cast<float>(line) * (ImGui::GetFrameHeight() + 4);
        label(draw, {margin, height - up - margin}, what, colour);
    };
    if (const Message& message = session.message; ImGui::GetTime() < message.until)
        say(1, message.text, message.error ? red : text);
    if (session.exporter.running() && session.closing == Closing::after_export)
        say(2,
            fmt::format("closing once {} is written: {:.0f} %", session.export_target.path,
                        100 * session.exporter.progress()),
            text);
    const std::optional<FrameMeter::Figures> figures = session.meter.figures();
    if (session.metered && figures)
        say(3,
            fmt::format("{:.0f} frames per second, {:.0f} ms from input to picture at most", figures->rate,
                        1e3 * figures->latency),
            text);
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
        std::optional<std::size_t> chosen;
        for (std::size_t i = 0; i < session.question->answers.size(); ++i) {
            const Question::Answer& each = session.question->answers[i];
            const std::string key = i == 0 ? "Enter" : std::string(1, static_cast<char>(each.key));
            if (ImGui::Button(fmt::format("{} ({})", each.label, key).c_str()))
                chosen = i;
            ImGui::SameLine();
        }
        if (ImGui::Button("Cancel (Esc)"))
            answer(session, {});
        else if (chosen)
            answer(session, chosen);
    }
    if (!session.question)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool reset_asked(const char* label) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(label);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        storage.SetBool(id, true);
    const bool asked = storage.GetBool(id);
    if (asked && !ImGui::IsMouseDown(0))
        storage.SetBool(id, false);
    return asked;
}

bool number_slider(const char* label, double& value, const render::Range& range, const render::Range& usual,
                   double by_default) {
    auto shown = static_cast<float>(value);
    const ImGuiSliderFlags logarithmic = usual.low > 0 ? ImGuiSliderFlags_Logarithmic : 0;
    const bool moved = slider(label, shown, static_cast<float>(usual.low), static_cast<float>(usual.high),
                              "%.3g", logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    if (reset_asked(label)) {
        const bool changed = value != by_default;
        value = by_default;
        return changed;
    }
    if (moved)
        value = std::clamp(double{shown}, range.low, range.high);
    return moved;
}

void explained(std::string_view dead, std::string_view help, const std::function<void()>& draw) {
    ImGui::BeginDisabled(!dead.empty());
    draw();
    ImGui::EndDisabled();
    tooltip(dead.empty() ? help : dead);
}

void tooltip(std::string_view text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive())
        return;
    // Not while the pointer only passes by: items are told by their place.
    constexpr double delay = 0.5; // seconds
    static ImVec2 place;
    static int frame = 0;
    static double since = 0;
    const ImVec2 here = ImGui::GetItemRectMin();
    if (here.x != place.x || here.y != place.y || ImGui::GetFrameCount() > frame + 1)
        since = ImGui::GetTime();
    place = here;
    frame = ImGui::GetFrameCount();
    if (ImGui::GetTime() - since < delay)
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

} // namespace gabor::viewer
