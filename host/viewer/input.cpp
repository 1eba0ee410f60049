#include "viewer/input.hpp"

#include "viewer/document_json.hpp"
#include "viewer/photograph.hpp"
#include "viewer/widgets.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gabor::viewer {

namespace {

constexpr double wheel_step = 1.15;

// The number of window pixels per unit of Dear ImGui.
float pixels_per_unit() {
    return ImGui::GetIO().DisplayFramebufferScale.x;
}

double within(std::string_view parameter, double value) {
    const render::Range& range = render::parameter(parameter).range;
    return std::clamp(value, range.low, range.high);
}

// Zooms about a point, given in pixels from the middle of the view.
void zoom(Session& session, double factor, double x, double y) {
    if (session.tiling)
        return notify(session, "Tiles set their own zoom");
    Document& document = session.document();
    render::Request& request = document.request;
    if (request.view.has_orbit()) {
        double& zoom = request.view.orbit.zoom;
        zoom = within("zoom", zoom * factor);
        return;
    }
    // Only the view zooms: the picture and its exports keep their scale.
    const double before = request.scale * document.camera.zoom;
    const double scale = within("scale", before * factor);
    document.camera = document.camera.moved(x / before - x / scale, y / before - y / scale);
    document.camera.zoom = scale / request.scale;
}

// Moves a plane with the pointer, or turns a body or a landscape.
void drag(Session& session, double x, double y) {
    Document& document = session.document();
    render::View& view = document.request.view;
    if (view.has_orbit()) {
        const bool body = view.is_body();
        const double degrees_per_pixel = 0.4 / ((body ? view.orbit.zoom : 1) * double{pixels_per_unit()});
        view.orbit.yaw = std::remainder(view.orbit.yaw + (body ? -1 : 1) * degrees_per_pixel * x, 360.0);
        view.orbit.pitch = std::clamp(view.orbit.pitch + degrees_per_pixel * y, body ? -89.0 : 0.0, 89.0);
    } else {
        const Camera& camera = session.tiling ? session.tiling->camera : document.camera;
        const double scale = document.request.scale * camera.zoom;
        document.camera = document.camera.moved(-x / scale, -y / scale);
    }
}

// Puts the lamp over the pointer. It is highest in the middle of the view and lower towards the edges.
void move_lamp(render::Request& request, double x, double y, double reach) {
    request.light_azimuth = noise::degrees(std::atan2(y, x));
    request.light_elevation = std::clamp(90 * (1 - std::hypot(x, y) / reach), 5.0, 90.0);
}

// Advances a choice parameter to its next value that keeps the material and the paint.
void next_choice(Session& session, std::string_view name) {
    const render::Parameter& parameter = render::parameter(name);
    const std::vector<std::string_view>& all = parameter.choices;
    const render::Request& now = session.document().request;
    auto at = static_cast<std::size_t>(std::ranges::find(all, std::get<std::string>(*parameter.get(now))) -
                                       all.begin());
    for (std::size_t i = 1; i < all.size(); ++i) {
        at = (at + 1) % all.size();
        Document next = session.document();
        set_parameter(next, name, std::string(all[at]));
        if (next.request.material == now.material && next.request.paint == now.paint) {
            session.document() = next;
            return;
        }
    }
    notify(session, fmt::format("No other {} keeps the material and the paint", name));
}

constexpr int ctrl = 1 << 16; // added to the keys of shortcuts with Ctrl

struct Shortcut {
    const char* name;
    const char* effect;
    int key = 0; ///< 0 if handled elsewhere
    void (*act)(Session&) = nullptr;
    std::string_view control = {}; ///< control that must have an effect; empty for none
    const char* without = "";      ///< message if the control has no effect
};

constexpr std::array shortcuts{
    Shortcut{"drag", "move the plane, or turn the body or the landscape"},
    Shortcut{"right drag", "move the light of a lit view"},
    Shortcut{"wheel", "zoom the view about the pointer; exports stay the same"},
    Shortcut{"arrows, + and -", "move and zoom from the keyboard"},
    Shortcut{"double click, Home", "return to the view that gabor render draws", GLFW_KEY_HOME, reset_camera},
    Shortcut{"1 to 8", "choose what is shown: value to lit stripes, or the looks of a material"},
    Shortcut{"V", "choose the next view", GLFW_KEY_V, [](Session& s) { next_choice(s, "view"); }},
    Shortcut{"F", "turn the filter on or off", GLFW_KEY_F,
             [](Session& s) { set_parameter(s.document(), "filter", !s.document().request.filter); },
             "filter", "Nothing can be filtered here"},
    Shortcut{"C", "choose the next colour map", GLFW_KEY_C,
             [](Session& s) {
                 s.document().colours = (s.document().colours + 1) % static_cast<int>(colour_names.size());
             },
             "colours", "This view has its own colours"},
    Shortcut{"N", "choose the next seed", GLFW_KEY_N, [](Session& s) { ++s.document().request.seed; }},
    Shortcut{"Tab", "show the photograph beside its noise, or the noise alone", GLFW_KEY_TAB,
             [](Session& s) { s.photograph_beside ^= s.fitter.photograph() != nullptr; }},
    Shortcut{"T", "show a tileable picture two by two, to look for seams", GLFW_KEY_T,
             [](Session& s) {
                 s.tiles = !s.tiles;
                 if (s.tiles && !has_effect(s.document(), "tiles"))
                     set_parameter(s.document(), "tileable", true);
             },
             "tileable", "This view has no tiles"},
    Shortcut{"P", "show the presets as pictures", GLFW_KEY_P, [](Session& s) { s.gallery = !s.gallery; }},
    Shortcut{"Space", "play or pause the animation", GLFW_KEY_SPACE,
             [](Session& s) { s.playing = !s.playing; }, "animation", "Nothing here changes with time"},
    Shortcut{"Ctrl Z", "undo", ctrl + GLFW_KEY_Z,
             [](Session& s) { ImGui::GetIO().KeyShift ? s.history.redo() : s.history.undo(); }},
    Shortcut{"Ctrl Y, Ctrl Shift Z", "redo", ctrl + GLFW_KEY_Y, [](Session& s) { s.history.redo(); }},
    Shortcut{"Ctrl O", "open a preset, or fit a noise to a photograph", ctrl + GLFW_KEY_O, ask_for_file},
    Shortcut{"Ctrl S", "save; the first time, choose where", ctrl + GLFW_KEY_S, save_preset},
    Shortcut{"Ctrl C", "copy GLSL that draws this view", ctrl + GLFW_KEY_C, copy_glsl},
    Shortcut{"Ctrl E", "export: a question says where to and what", ctrl + GLFW_KEY_E, ask_about_export},
    Shortcut{"H", "hide or show the panels", GLFW_KEY_H, [](Session& s) { s.panels = !s.panels; }},
    Shortcut{"F11", "fill the screen"},
    Shortcut{"F1", "show this page"},
    Shortcut{"Ctrl Q", "quit", ctrl + GLFW_KEY_Q, [](Session& s) { s.closing = Closing::asked; }},
};

// Handles keys that repeat while held, and the digit keys.
void held_keys(Session& session) {
    Document& document = session.document();
    const bool material = render::is_surface(document.request.kind);
    const auto shown = static_cast<int>(material ? looks(document.request).size() : output_names.size());
    for (int i = 0; i < shown; ++i)
        if (pressed(GLFW_KEY_1 + i)) {
            if (material)
                document.look = static_cast<Look>(i);
            else if (can_show(document.request, static_cast<Output>(i)))
                document.output = static_cast<Output>(i);
        }
    const double step = 40.0 * double{pixels_per_unit()};
    const auto held = [](int key) { return pressed(key, true) ? 1.0 : 0.0; };
    const double x = held(GLFW_KEY_RIGHT) - held(GLFW_KEY_LEFT);
    const double y = held(GLFW_KEY_DOWN) - held(GLFW_KEY_UP);
    if (x != 0 || y != 0)
        drag(session, -step * x, -step * y);
    if (pressed(GLFW_KEY_EQUAL, true) || pressed(GLFW_KEY_KP_ADD, true))
        zoom(session, wheel_step, 0, 0);
    if (pressed(GLFW_KEY_MINUS, true) || pressed(GLFW_KEY_KP_SUBTRACT, true))
        zoom(session, 1 / wheel_step, 0, 0);
}

void keys(Session& session) {
    const ImGuiIO& io = ImGui::GetIO();
    if (session.question) {
        for (std::size_t i = session.question->answers.size(); i-- > 0;)
            if (!io.KeyCtrl && pressed(session.question->answers[i].key))
                return answer(session, i);
        if (pressed(GLFW_KEY_ENTER) || pressed(GLFW_KEY_KP_ENTER))
            answer(session, 0);
        else if (pressed(GLFW_KEY_ESCAPE))
            answer(session, {});
        return;
    }
    if (session.dialog) {
        if (pressed(GLFW_KEY_ESCAPE))
            cancel_dialog(session);
        return;
    }
    if (pressed(GLFW_KEY_F1))
        session.help = !session.help;
    if (pressed(GLFW_KEY_F11))
        session.full_screen = !session.full_screen;
    if (pressed(GLFW_KEY_ESCAPE)) {
        if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) // a colour picker or a list
            return ImGui::ClosePopupToLevel(0, true);
        session.help = session.gallery = false;
    }
    if (io.WantTextInput)
        return;
    for (const auto& [name, effect, key, act, control, without] : shortcuts)
        if (key && (key >= ctrl) == io.KeyCtrl && pressed(key % ctrl)) {
            if (control.empty() || has_effect(session.document(), control))
                act(session);
            else
                notify(session, without);
        }
    if (!io.KeyCtrl)
        held_keys(session);
}

void mouse(Session& session, float width, float height) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse)
        return;
    const float density = pixels_per_unit();
    const bool split = shows_photograph(session);
    const float divider = width * session.divider;
    const bool at_divider = split && std::abs(io.MousePos.x - divider) < 6;
    if (ImGui::IsMouseClicked(0))
        session.dragging_divider = at_divider;
    if (at_divider || (split && session.dragging_divider))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsMouseDragging(0, 0) && session.dragging_divider) {
        session.divider = std::clamp(io.MousePos.x / width, 0.1f, 0.9f);
        return;
    }
    if (ImGui::IsMouseDragging(0, 0) || ImGui::IsMouseDragging(2, 0))
        drag(session, double{io.MouseDelta.x * density}, double{io.MouseDelta.y * density});
    if (ImGui::IsMouseDragging(1, 0) && is_lit(session.document()))
        move_lamp(session.document().request, double{io.MousePos.x - width / 2},
                  double{io.MousePos.y - height / 2}, double{std::max(width, height) / 2});
    const bool inside =
        io.MousePos.x >= 0 && io.MousePos.x < width && io.MousePos.y >= 0 && io.MousePos.y < height;
    if (!inside)
        return;
    if (ImGui::IsMouseDoubleClicked(0))
        reset_camera(session);
    if (io.MouseWheel != 0) {
        const bool right = split && io.MousePos.x >= divider;
        const float left = right ? divider : 0;
        const float across = !split ? width : right ? width - divider : divider;
        zoom(session, std::pow(wheel_step, io.MouseWheel),
             double{(io.MousePos.x - left - across / 2) * density},
             double{(io.MousePos.y - height / 2) * density});
    }
}

} // namespace

void handle_input(Session& session, float width, float height) {
    if (key_went_down() || ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1))
        hide_message_soon(session);
    mouse(session, width, height);
    keys(session);
}

void help_window(Session& session) {
    if (!session.help)
        return;
    const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    if (ImGui::Begin("Help", &session.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const Shortcut& shortcut : shortcuts) {
                ImGui::TableNextColumn();
                ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", shortcut.name);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(shortcut.effect);
            }
            ImGui::EndTable();
        }
        ImGui::Separator();
        ImGui::TextUnformatted(
            "Ctrl-click a slider to type a number; double-click it to reset it. Rest the pointer on a "
            "control to\n"
            "read what it does. In the frequency plane, click a lobe to select it, drag it to move it,\n"
            "double-click to add one, and press Delete to remove the selected one.");
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

} // namespace gabor::viewer
