#include "viewer/panels.hpp"

#include "render/output/file.hpp"
#include "render/request/load.hpp"
#include "viewer/document_json.hpp"
#include "viewer/photograph.hpp"
#include "viewer/ramp_editor.hpp"
#include "viewer/spectrum_panel.hpp"
#include "viewer/widgets.hpp"

#include "viewer/display_interface.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace gabor::viewer {

namespace {

// Returns the first sentence of a parameter's help, with its unit. The rest is about command-line options and
// files.
std::string help_of(const render::Parameter& parameter) {
    if (parameter.name == "scale")
        return "Size of everything in the picture: the pixels of one unit, in which other controls count "
               "threads, rings or waves";
    const std::string_view help =
        parameter.help.substr(0, std::min(parameter.help.find(". "), parameter.help.find(".\n")));
    return parameter.unit.empty() ? std::string(help) : fmt::format("{} ({})", help, parameter.unit);
}

// Draws the control that suits a parameter's type, and returns the value if it was changed.
std::optional<render::Value> edit(const render::Parameter& parameter, const render::Value& value,
                                  const render::Request& request) {
    using Type = render::Parameter::Type;
    const std::string label = label_of(parameter.name);
    switch (parameter.type) {
    case Type::flag: {
        bool on = std::get<bool>(value);
        return ImGui::Checkbox(label.c_str(), &on) ? std::optional<render::Value>(on) : std::nullopt;
    }
    case Type::integer: {
        auto number = static_cast<std::uint32_t>(std::get<double>(value));
        const std::uint32_t step = 1;
        if (!ImGui::InputScalar(label.c_str(), ImGuiDataType_U32, &number, &step))
            return {};
        return std::clamp(static_cast<double>(number), parameter.range.low, parameter.range.high);
    }
    case Type::number:
    case Type::angle: {
        double number = std::get<double>(value);
        if (parameter.type == Type::angle && parameter.slider.high == 180) // the slider covers a full circle
            number = std::remainder(number, 360);
        if (!number_slider(label.c_str(), number, parameter.range, parameter.slider,
                           std::get<double>(*render::default_of(parameter, request))))
            return {};
        return number;
    }
    case Type::choice: {
        std::optional<render::Value> chosen;
        const std::string& now = std::get<std::string>(value);
        if (ImGui::BeginCombo(label.c_str(), now.c_str())) {
            for (const std::string_view name : parameter.choices) {
                if (ImGui::Selectable(std::string(name).c_str(), name == now))
                    chosen = std::string(name);
                if (parameter.name == "recipe")
                    tooltip(noise::find_recipe(name).summary);
            }
            ImGui::EndCombo();
        }
        return chosen;
    }
    case Type::text: {
        std::string text = std::get<std::string>(value);
        if (ImGui::InputText(label.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue))
            return text;
        return {};
    }
    case Type::colour: { // shown as sRGB, like all colours
        std::array<float, 3> shown{};
        const auto& colour = std::get<std::array<double, 3>>(value);
        std::ranges::transform(colour, shown.begin(),
                               [](double part) { return render::srgb(static_cast<float>(part)); });
        if (!colour_field(label.c_str(), shown))
            return {};
        return render::read(parameter, hex(shown));
    }
    case Type::lobes: // spectrum_panel edits these
        break;
    }
    return {};
}

// Draws the control of a parameter if it has an effect.
void control(Session& session, std::string_view name) {
    const render::Parameter& parameter = render::parameter(name);
    const render::Request& request = session.document().request;
    const std::optional<render::Value> value = parameter.get(request);
    if (!value || !has_effect(session.document(), name))
        return;
    std::optional<render::Value> edited;
    attempt(session, [&] { edited = edit(parameter, *value, request); });
    tooltip(help_of(parameter));
    if (edited)
        attempt(session, [&] { set_parameter(session.document(), name, *edited); });
}

void controls(Session& session, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        control(session, name);
}

void controls_of(Session& session, render::Parameter::Group group) {
    for (const render::Parameter& parameter : render::parameters())
        if (parameter.group == group)
            control(session, parameter.name);
}

constexpr const char* output_tips[]{
    "The noise itself, of mean 0 and variance 1",
    "The gradient of the noise, as a normal map",
    "The phase of the complex noise, for patterns of even contrast",
    "The magnitude of the complex noise",
    "The share of the variance that the filter leaves; all of it without a filter",
    "The phase as waves of equal height",
    "The value as a height, lit by a lamp",
    "Stripes as a height, lit by a lamp"};
constexpr const char* look_tips[]{"Lit by a lamp",
                                  "Base colour, for physically based shading",
                                  "Height of the surface; mean height is grey",
                                  "Normal map of the height",
                                  "Roughness: dark is smooth",
                                  "Metalness: white where reflections have the base colour"};

constexpr const char* environment_tips[]{"A room with a window", "An overcast sky, equally bright all round",
                                         "Nothing but the lamp"};

// A slider that a double click resets.
void resettable(const char* label, float& value, float low, float high, const char* format,
                float by_default) {
    slider(label, value, low, high, format, ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (reset_asked(label))
        value = by_default;
}

// A field for a path. While it is not being edited, it shows the end of a path that is too long.
void path_field(const char* label, std::string& path, std::string shown) {
    if (ImGui::InputText(label, &shown))
        path = shown;
    const ImVec2 pad = ImGui::GetStyle().FramePadding;
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 from{corner.x + pad.x, corner.y + pad.y};
    const ImVec2 to{corner.x + ImGui::CalcItemWidth(), from.y + ImGui::GetFontSize()};
    const float hidden = ImGui::CalcTextSize(shown.c_str()).x - (to.x - pad.x - from.x);
    if (hidden <= 0 || ImGui::IsItemActive())
        return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(from, to, true);
    draw.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw.AddText({from.x - hidden, from.y}, ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
    draw.PopClipRect();
}

// The forms of an export, in the order of ExportAs.
constexpr std::string_view exports[]{"a picture", "an animation", "a texture", "a set of maps"};
constexpr const char* export_tips[]{
    "An EXR of 32-bit floats with its parameters in the header",
    "NAME.0001.exr and so on: the frames of one period, or of a sea's loop; those of an endless sea are 1/25 "
    "s apart",
    "A tiled EXR for renderers, with filtered mip-map levels. Its sides must be powers of two.",
    "A folder of images for other programs: base colour, normal and height; for a material, also roughness, "
    "metalness, occlusion, an EXR with all of them, a MaterialX document and a glTF scene; for a "
    "photograph's noise, only the base colour"};

// Draws the controls of the lobes, unless a paint replaces them, and of the paint.
void waves_panel(Session& session) {
    if (has_effect(session.document(), "lobes"))
        spectrum_panel(session);
    control(session, "paint");
    if (has_effect(session.document(), "paint")) {
        ImGui::SameLine();
        if (ImGui::Button("..."))
            ask_for_paint(session);
        tooltip("Choose a file");
    }
}

void material_panel(Session& session) {
    control(session, "material");
    controls_of(session, render::Parameter::Group::material);
    controls(session, {"scale", "seed"});
    control(session, "boards");
    controls_of(session, render::Parameter::Group::boards);
    control(session, "coat");
    controls_of(session, render::Parameter::Group::coat);
    control(session, "finish");
    controls_of(session, render::Parameter::Group::finish);
}

void terrain_panel(Session& session) {
    controls(session, {"scale", "seed", "extent", "cover", "water_level"});
    controls_of(session, render::Parameter::Group::erosion);
}

void ocean_panel(Session& session) {
    controls_of(session, render::Parameter::Group::sea);
    control(session, "seed");
}

void animation_panel(Session& session) {
    if (ImGui::Button(session.playing ? "pause" : "play"))
        session.playing = !session.playing;
    tooltip("Space: play the evolution in a loop from 0 to 1, or a sea on and on");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - ImGui::GetCursorPosX());
    controls(session, {"evolution", "seconds"});
    resettable("period", session.period, 1, 60, "%.1f s", Session::default_period);
    tooltip("Seconds that the evolution takes to go from 0 to 1");
}

void view_panel(Session& session) {
    Document& document = session.document();
    if (render::is_surface(document.request.kind))
        choose("show", document.look, looks(document.request), look_tips);
    else
        choose("show", document.output, output_names, output_tips);
    if (!can_show(document.request, document.output))
        document.output = Output::value;
    if (shows_normals(document)) {
        ImGui::Checkbox("DirectX normals", &document.directx_normals);
        tooltip("Let green point down, as DirectX does; in OpenGL it points up");
    }
    if (has_effect(document, "profile"))
        choose("profile", document.profile, profile_names);
    if (has_effect(document, "colours")) {
        choose("colours", document.colours, colour_names);
        if (document.colours == passes::own_colours)
            ramp_editor(session);
    }
    if (has_effect(document, "contrast")) {
        resettable("contrast", document.contrast, least_contrast, most_contrast, "%.2f", Document().contrast);
        tooltip("Standard deviations from the mean to either end of the colour map; gabor render uses 2");
    }
    controls_of(session, render::Parameter::Group::view);
    if (has_effect(document, "tiles")) {
        ImGui::Checkbox("2 x 2 tiles", &session.tiles);
        tooltip("T: show four copies of the picture, to look for seams. This view sets its own zoom.");
    }
}

void light_panel(Session& session) {
    render::Request& request = session.document().request;
    if (render::is_pattern(request.kind))
        choose("environment", request.environment, render::environments, environment_tips);
    for (auto [name, angle] : {std::pair("light_azimuth", &render::Request::light_azimuth),
                               std::pair("light_elevation", &render::Request::light_elevation)}) {
        const render::Parameter& parameter = render::parameter(name);
        number_slider(label_of(std::string_view(name).substr(6)).c_str(), request.*angle, parameter.range,
                      parameter.slider, render::Request().*angle);
        tooltip(help_of(parameter) + ". Or drag over the view with the right button.");
    }
}

void file_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float third = (width - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button("Open...", {third, 0}))
        ask_for_file(session);
    tooltip("Ctrl O: open a preset, an EXR that gabor rendered, or a photograph to fit. You can also drop "
            "files on the window.");
    ImGui::SameLine();
    if (ImGui::Button("Save", {third, 0}))
        save_preset(session);
    tooltip(has_file(session.document()) ? "Ctrl S: save to " + session.document().path
                                         : "Ctrl S: choose where to save");
    ImGui::SameLine();
    if (ImGui::Button("Save as...", {third, 0}))
        ask_where_to_save(session);

    if (!session.recent.empty() && ImGui::BeginCombo("##recent", "Recent files")) {
        for (const std::string& path : std::vector(session.recent)) { // opening one changes the list
            if (ImGui::Selectable(std::filesystem::path(path).filename().string().c_str()))
                open_file(session, path);
            tooltip(path);
        }
        ImGui::EndCombo();
    }
    if (ImGui::BeginCombo("interface", fmt::format("{:.0f} %", 100 * session.ui_scale).c_str())) {
        for (const float scale : {0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f})
            if (ImGui::Selectable(fmt::format("{:.0f} %", 100 * scale).c_str(), scale == session.ui_scale))
                session.ui_scale = scale;
        ImGui::EndCombo();
    }
    tooltip("Size of panels and text; 100 % follows the desktop's scale or the height of the screen");
}

void export_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = (width - ImGui::GetStyle().ItemSpacing.x) / 2;
    const render::Request& request = session.document().request;
    ExportTarget& target = session.export_target;
    const ExportTarget now = target.of(session.document());
    ExportAs as = now.as;
    const std::size_t forms = can_export_maps(request) ? std::size(exports) : std::size(exports) - 1;
    if (choose("kind", as, std::span(exports).first(forms), export_tips)) {
        target.chosen = as;
        session.exporting_asked = true; // the section changes its height
    }
    if (as == ExportAs::maps) {
        auto power = static_cast<float>(std::bit_width(static_cast<unsigned>(target.map_side)) - 1);
        if (slider("side", power, 8, 13, fmt::format("{} pixels", target.map_side).c_str()))
            target.map_side = 1 << std::clamp(static_cast<int>(std::round(power)), 8, 13);
        tooltip("The maps are square, and show as much as the shorter side of the picture");
    } else {
        controls(session, {"width", "height"});
        for (const auto& [label, factor] : {std::pair("half size", 0.5), std::pair("double size", 2.0)}) {
            if (ImGui::Button(label, {half, 0}))
                attempt(session, [&, by = factor] { resize(session.document(), by); });
            tooltip("Change the pixels of the picture, but not what it shows");
            ImGui::SameLine();
        }
        ImGui::NewLine();
    }
    if (as == ExportAs::frames) {
        auto frames = static_cast<float>(target.frames);
        slider("frames", frames, 2, 240, "%.0f");
        target.frames = std::clamp(static_cast<int>(frames), 1, render::most_frames);
    }
    const bool surface = render::is_surface(request.kind);
    if (as == ExportAs::maps && surface) {
        if (request.kind == render::Kind::material) {
            ImGui::InputDouble("metres", &target.metres, 0, 0, "%g");
            target.metres = std::clamp(target.metres, 1e-6, 1e9);
            tooltip("The width of the maps in metres, which also scales their heights");
        }
        ImGui::Checkbox("DirectX normals", &target.directx);
        tooltip("Also write normal_directx.png, whose green points down");
    }
    if (as == ExportAs::maps) {
        if (surface)
            ImGui::SameLine();
        ImGui::Checkbox("tileable##maps", &target.tileable);
        tooltip("Opposite edges match");
    }
    if (as == ExportAs::texture) {
        control(session, "tileable");
        ImGui::Checkbox("16-bit floats", &target.half);
    }
    if (as == ExportAs::picture || as == ExportAs::frames) {
        ImGui::Checkbox("also write PNG", &target.png);
        tooltip("A PNG beside the EXR that looks like the window");
    }
    if (as == ExportAs::maps) {
        path_field("folder", target.folder, now.folder);
        tooltip("The folder to write the maps to");
    } else {
        path_field("file", target.path, now.path);
        tooltip("The EXR to write; an animation numbers its frames: NAME.0001.exr");
    }
    if (session.exporter.running()) {
        progress_bar(session.exporter.progress(), half);
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {half, 0}))
            session.exporter.cancel();
    } else {
        if (ImGui::Button("Export now", {half, 0}))
            start_export(session);
        tooltip("Export in the background while you keep working (Ctrl E)");
        ImGui::SameLine();
        if (ImGui::Button("Export to...", {half, 0}))
            ask_where_to_export(session);
    }
}

// Buttons for the most common actions.
void start_buttons(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float room = width - 2 * ImGui::GetStyle().ItemSpacing.x;
    const float longest = std::max(room / 3, 6.3f * ImGui::GetFontSize());
    const float other = (room - longest) / 2;
    if (ImGui::Button("Materials and presets", {width, 0}))
        session.gallery = !session.gallery;
    if (!session.gallery) // whose field for searching it would cover
        tooltip("Choose a material or preset (P)");
    if (ImGui::Button("Photograph", {longest, 0}))
        ask_for_photograph(session);
    tooltip("Fit a noise to a PNG, JPEG, TGA or EXR of a texture, at least 128 x 128 pixels. You can also "
            "drop it on the window.");
    ImGui::SameLine();
    if (ImGui::Button("Copy code", {other, 0}))
        copy_glsl(session);
    tooltip("Ctrl C: copy GLSL that draws this view");
    ImGui::SameLine();
    session.exporting_asked |= ImGui::Button("Export", {other, 0});
    tooltip("Pictures, animations, textures, and sets of maps");
}

} // namespace

void side_panel(Session& session) {
    start_buttons(session);
    const render::Request& request = session.document().request;
    const auto shows = [kind = request.kind](render::Kind other) { return kind == other; };
    struct Section {
        const char* title;
        void (*panel)(Session&);
        bool open;
        bool applies = true;
    };
    const std::array sections{
        Section{"Noise",
                [](Session& s) {
                    controls(s, {"material", "fractal", "scale", "seed"});
                },
                true, shows(render::Kind::noise)},
        Section{"Fractal noise",
                [](Session& s) {
                    controls(s, {"fractal", "fractal.basis", "fractal.octaves", "fractal.gain",
                                 "fractal.lacunarity", "fractal.turn", "fractal.warp", "scale", "seed",
                                 "gradient"});
                },
                true, shows(render::Kind::fractal)},
        Section{"Material", material_panel, true, shows(render::Kind::material)},
        Section{"Terrain", terrain_panel, true, shows(render::Kind::terrain)},
        Section{"Ocean", ocean_panel, true, shows(render::Kind::sea)},
        Section{"Photograph", photograph_panel, true, !session.fitter.path().empty()},
        Section{"Spectrum", waves_panel, true, shows(render::Kind::noise)},
        Section{"View", view_panel, true},
        Section{"Light", light_panel, true, is_lit(session.document())},
        Section{"Animation", animation_panel, false, has_effect(session.document(), "animation")},
        Section{"Export", export_panel, false},
        Section{"File", file_panel, false},
        Section{"Laboratory",
                [](Session& s) {
                    controls(s, {"recipe", "gradient", "phasor"});
                },
                false, !render::is_surface(request.kind)}};
    ImGui::BeginChild("sections", {}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar); // below the buttons
    if (!std::exchange(session.scrolled_back, true))
        ImGui::SetScrollY(0);
    ImGui::PushItemWidth(-9.4f * ImGui::GetFontSize());
    for (const Section& section : sections) {
        if (!section.applies)
            continue;
        const bool asked = section.panel == export_panel && std::exchange(session.exporting_asked, false);
        if (asked)
            ImGui::SetNextItemOpen(true);
        if (!ImGui::CollapsingHeader(section.title, section.open ? ImGuiTreeNodeFlags_DefaultOpen : 0))
            continue;
        ImGui::PushID(section.title);
        section.panel(session);
        ImGui::PopID();
        ImGui::Spacing();
        if (asked)
            ImGui::SetScrollHereY(1);
    }
    ImGui::PopItemWidth();
    ImGui::EndChild();
}

void unfold_button(Session& session) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(size, ImGuiCond_Always, {1, 1});
    ImGui::Begin("unfold", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::Button("Controls"))
        session.panels = true;
    ImGui::End();
}

} // namespace gabor::viewer
