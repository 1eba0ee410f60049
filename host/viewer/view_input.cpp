#include "viewer/view_input.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

namespace {

constexpr double wheel_step = 1.15;
constexpr int colour_maps = 5;

// What is under a point stays under it. The point in pixels from the middle of the view.
void zoom(Document& document, double factor, double x, double y) {
    const double before = document.picture.scale;
    const double after = std::clamp(before * factor, render::smallest_scale, render::largest_scale);
    document.picture.scale = after;
    document.camera = document.camera.moved(x / before - x / after, y / before - y / after);
}

void pan(Document& document, double x, double y) {
    document.camera = document.camera.moved(-x / document.picture.scale, -y / document.picture.scale);
}

void turn(Pose& pose, float x, float y) {
    pose.yaw = std::remainder(pose.yaw - 0.4f * x / pose.nearness, 360.0f);
    pose.pitch = std::clamp(pose.pitch + 0.4f * y / pose.nearness, -89.0f, 89.0f);
}

// A drag moves a plane and turns a body.
void drag(Document& document, float x, float y, float density) {
    if (on_body(document.view()))
        turn(document.pose, x, y);
    else
        pan(document, double{x * density}, double{y * density});
}

void next_recipe(render::Picture& picture) {
    const auto all = noise::recipes();
    const auto found = std::ranges::find(all, picture.recipe, &noise::Recipe::name);
    picture.recipe = found == all.end() || found + 1 == all.end() ? all.front().name : (found + 1)->name;
}

void toggle_filter(render::Picture& picture) {
    picture.filter = !picture.filter;
    if (picture.filter) { // they exclude each other
        picture.gradient = false;
        picture.values = 1;
    }
}

bool pressed(int key) {
    return ImGui::IsKeyPressed(key, false);
}

bool control_keys(Session& session) {
    if (pressed(GLFW_KEY_Z))
        ImGui::GetIO().KeyShift ? session.history.redo() : session.history.undo();
    if (pressed(GLFW_KEY_Y))
        session.history.redo();
    if (pressed(GLFW_KEY_O))
        open_preset(session, session.preset);
    if (pressed(GLFW_KEY_S))
        save_preset(session, session.preset);
    if (pressed(GLFW_KEY_C))
        copy_glsl(session);
    if (pressed(GLFW_KEY_E))
        start_export(session);
    return pressed(GLFW_KEY_Q);
}

void plain_keys(Session& session, float density) {
    Document& document = session.document();
    for (int i = 0; i < 5; ++i)
        if (pressed(GLFW_KEY_1 + i))
            document.output = static_cast<Output>(i);
    if (pressed(GLFW_KEY_C))
        document.colours = (document.colours + 1) % colour_maps;
    if (pressed(GLFW_KEY_R))
        next_recipe(document.picture);
    if (pressed(GLFW_KEY_N))
        ++document.picture.seed;
    if (pressed(GLFW_KEY_TAB)) {
        if (document.rival)
            document.rival.reset();
        else
            document.rival.emplace();
    }
    if (pressed(GLFW_KEY_V))
        document.set_view(static_cast<View>((static_cast<int>(document.view()) + 1) % 4));
    if (pressed(GLFW_KEY_F))
        toggle_filter(document.picture);
    if (pressed(GLFW_KEY_SPACE))
        session.playing = !session.playing;
    if (pressed(GLFW_KEY_HOME))
        go_home(session);
    if (pressed(GLFW_KEY_H))
        session.panels = !session.panels;
    const double step = 40.0 * double{density};
    const auto held = [](int key) { return ImGui::IsKeyPressed(key, true) ? 1.0 : 0.0; };
    const double x = held(GLFW_KEY_RIGHT) - held(GLFW_KEY_LEFT);
    const double y = held(GLFW_KEY_DOWN) - held(GLFW_KEY_UP);
    if (x != 0 || y != 0)
        pan(document, -step * x, -step * y);
    if (ImGui::IsKeyPressed(GLFW_KEY_EQUAL) || ImGui::IsKeyPressed(GLFW_KEY_KP_ADD))
        zoom(document, wheel_step, 0, 0);
    if (ImGui::IsKeyPressed(GLFW_KEY_MINUS) || ImGui::IsKeyPressed(GLFW_KEY_KP_SUBTRACT))
        zoom(document, 1 / wheel_step, 0, 0);
}

bool keys(Session& session, float density) {
    const ImGuiIO& io = ImGui::GetIO();
    if (pressed(GLFW_KEY_F1))
        session.help = !session.help;
    if (pressed(GLFW_KEY_F11))
        session.panels = !session.panels;
    if (pressed(GLFW_KEY_ESCAPE))
        session.help = false;
    if (io.WantTextInput)
        return false;
    if (io.KeyCtrl)
        return control_keys(session);
    plain_keys(session, density);
    return false;
}

void mouse(Session& session, float width, float height, float density) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse)
        return;
    Document& document = session.document();
    const bool split = document.rival && !on_body(document.view());
    const float divider = width * session.divider;
    static bool moving_divider = false; // between a press and its release
    if (ImGui::IsMouseClicked(0))
        moving_divider = split && std::abs(io.MousePos.x - divider) < 6;
    if (split && (moving_divider || std::abs(io.MousePos.x - divider) < 6))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsMouseDragging(0, 0) && moving_divider) {
        session.divider = std::clamp(io.MousePos.x / width, 0.1f, 0.9f);
        return;
    }
    if (ImGui::IsMouseDragging(0, 0) || ImGui::IsMouseDragging(2, 0))
        drag(document, io.MouseDelta.x, io.MouseDelta.y, density);
    const bool inside =
        io.MousePos.x >= 0 && io.MousePos.x < width && io.MousePos.y >= 0 && io.MousePos.y < height;
    if (inside && ImGui::IsMouseDoubleClicked(0))
        go_home(session);
    if (inside && io.MouseWheel != 0 && on_body(document.view())) {
        document.pose.nearness = std::clamp(
            document.pose.nearness * static_cast<float>(std::pow(wheel_step, io.MouseWheel)), 0.3f, 20.0f);
    } else if (inside && io.MouseWheel != 0) {
        const bool right = split && io.MousePos.x >= divider;
        const float left = right ? divider : 0;
        const float across = !split ? width : right ? width - divider : divider;
        zoom(document, std::pow(wheel_step, io.MouseWheel),
             double{(io.MousePos.x - left - across / 2) * density},
             double{(io.MousePos.y - height / 2) * density});
    }
}

} // namespace

bool view_input(Session& session, float width, float height, float density) {
    mouse(session, width, height, density);
    return keys(session, density);
}

} // namespace gabor::viewer
