#include "viewer/dear_imgui.hpp"

#include "viewer/target.hpp"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <array>

namespace gabor::viewer::dear_imgui {

// Since version 1.87, Dear ImGui takes events, and has keys of its own; before, programs wrote its state.
#if IMGUI_VERSION_NUM < 18700

void set_pointer(ImVec2 at) {
    ImGui::GetIO().MousePos = at;
}

void set_button(int button, bool down) {
    ImGui::GetIO().MouseDown[button] = down;
}

void set_key(int key, bool down) {
    ImGui::GetIO().KeysDown[key] = down;
}

void set_modifiers(bool ctrl, bool shift) {
    ImGui::GetIO().KeyCtrl = ctrl;
    ImGui::GetIO().KeyShift = shift;
}

bool is_down(int key) {
    return ImGui::GetIO().KeysDownDuration[key] >= 0;
}

bool went_down(int key, bool repeat) {
    return ImGui::IsKeyPressed(key, repeat);
}

void process_events_at_once() {}

#else

namespace {

ImGuiKey key_of(int key) {
    struct Range {
        int first, last;
        ImGuiKey begin;
    };
    constexpr std::array ranges{Range{GLFW_KEY_0, GLFW_KEY_9, ImGuiKey_0},
                                Range{GLFW_KEY_A, GLFW_KEY_Z, ImGuiKey_A},
                                Range{GLFW_KEY_F1, GLFW_KEY_F12, ImGuiKey_F1},
                                Range{GLFW_KEY_KP_0, GLFW_KEY_KP_EQUAL, ImGuiKey_Keypad0},
                                Range{GLFW_KEY_CAPS_LOCK, GLFW_KEY_PAUSE, ImGuiKey_CapsLock}};
    for (const Range& range : ranges)
        if (key >= range.first && key <= range.last)
            return static_cast<ImGuiKey>(range.begin + key - range.first);
    switch (key) {
    case GLFW_KEY_SPACE:
        return ImGuiKey_Space;
    case GLFW_KEY_APOSTROPHE:
        return ImGuiKey_Apostrophe;
    case GLFW_KEY_COMMA:
        return ImGuiKey_Comma;
    case GLFW_KEY_MINUS:
        return ImGuiKey_Minus;
    case GLFW_KEY_PERIOD:
        return ImGuiKey_Period;
    case GLFW_KEY_SLASH:
        return ImGuiKey_Slash;
    case GLFW_KEY_SEMICOLON:
        return ImGuiKey_Semicolon;
    case GLFW_KEY_EQUAL:
        return ImGuiKey_Equal;
    case GLFW_KEY_LEFT_BRACKET:
        return ImGuiKey_LeftBracket;
    case GLFW_KEY_BACKSLASH:
        return ImGuiKey_Backslash;
    case GLFW_KEY_RIGHT_BRACKET:
        return ImGuiKey_RightBracket;
    case GLFW_KEY_GRAVE_ACCENT:
        return ImGuiKey_GraveAccent;
    case GLFW_KEY_ESCAPE:
        return ImGuiKey_Escape;
    case GLFW_KEY_ENTER:
        return ImGuiKey_Enter;
    case GLFW_KEY_TAB:
        return ImGuiKey_Tab;
    case GLFW_KEY_BACKSPACE:
        return ImGuiKey_Backspace;
    case GLFW_KEY_INSERT:
        return ImGuiKey_Insert;
    case GLFW_KEY_DELETE:
        return ImGuiKey_Delete;
    case GLFW_KEY_RIGHT:
        return ImGuiKey_RightArrow;
    case GLFW_KEY_LEFT:
        return ImGuiKey_LeftArrow;
    case GLFW_KEY_DOWN:
        return ImGuiKey_DownArrow;
    case GLFW_KEY_UP:
        return ImGuiKey_UpArrow;
    case GLFW_KEY_PAGE_UP:
        return ImGuiKey_PageUp;
    case GLFW_KEY_PAGE_DOWN:
        return ImGuiKey_PageDown;
    case GLFW_KEY_HOME:
        return ImGuiKey_Home;
    case GLFW_KEY_END:
        return ImGuiKey_End;
    default:
        return ImGuiKey_None;
    }
}

} // namespace

void set_pointer(ImVec2 at) {
    ImGui::GetIO().AddMousePosEvent(at.x, at.y);
}

void set_button(int button, bool down) {
    ImGui::GetIO().AddMouseButtonEvent(button, down);
}

void set_key(int key, bool down) {
    ImGui::GetIO().AddKeyEvent(key_of(key), down);
}

void set_modifiers(bool ctrl, bool shift) {
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, shift);
}

bool is_down(int key) {
    const ImGuiKey known = key_of(key);
    return known != ImGuiKey_None && ImGui::IsKeyDown(known);
}

bool went_down(int key, bool repeat) {
    const ImGuiKey known = key_of(key);
    return known != ImGuiKey_None && ImGui::IsKeyPressed(known, repeat);
}

void process_events_at_once() {
    ImGui::GetIO().ConfigInputTrickleEventQueue = false;
}

#endif

void start_renderer([[maybe_unused]] const vulkan::Device& device, ImGui_ImplVulkan_InitInfo& info,
                    vk::RenderPass pass) {
#if IMGUI_VERSION_NUM < 19030
    ImGui_ImplVulkan_Init(&info, pass);
#else
    info.RenderPass = pass;
    ImGui_ImplVulkan_Init(&info);
#endif
#if IMGUI_VERSION_NUM < 19000
    Commands(device).run(ImGui_ImplVulkan_CreateFontsTexture);
    ImGui_ImplVulkan_DestroyFontUploadObjects();
#elif IMGUI_VERSION_NUM < 19200 // later versions upload fonts themselves
    ImGui_ImplVulkan_CreateFontsTexture();
#endif
}

void build([[maybe_unused]] ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM < 19200 // later versions draw letters when they are needed
    atlas.Build();
#endif
}

const ImFontGlyph& glyph(ImWchar letter) {
#if IMGUI_VERSION_NUM < 19200
    return *ImGui::GetFont()->FindGlyph(letter);
#else
    return *ImGui::GetFontBaked()->FindGlyph(letter);
#endif
}

void activate(ImGuiID item) {
#if IMGUI_VERSION_NUM < 19000
    ImGui::ActivateItem(item);
#else
    ImGui::ActivateItemByID(item);
#endif
}

} // namespace gabor::viewer::dear_imgui
