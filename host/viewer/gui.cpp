#include "viewer/gui.hpp"

#include "system/desktop.hpp"
#include "viewer/dear_imgui.hpp"
#include "viewer/target.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui_internal.h>

#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace gabor::viewer {

namespace {

// A press of a key with its character, or a press or release of a mouse button, that no frame has processed
// yet. A press counts even if it ends before the next frame.
struct Press {
    int key; ///< -1 for others
    int button;
    bool down;
    int modifiers;
    ImVec2 at;                  ///< the pointer's position
    double time;                ///< in seconds
    unsigned int character = 0; ///< that a key typed
};
std::deque<Press> presses;
ImVec2 pointer;

void note_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    const bool is_modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    if (action == GLFW_PRESS && key >= 0 && !is_modifier)
        presses.push_back({key, -1, true, modifiers, pointer, glfwGetTime()});
    else
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
}

void note_button(GLFWwindow*, int button, int action, int modifiers) {
    if (button < IM_ARRAYSIZE(ImGuiIO::MouseDown))
        presses.push_back({-1, button, action == GLFW_PRESS, modifiers, pointer, glfwGetTime()});
}

void note_character(GLFWwindow*, unsigned int character) {
    if (presses.empty() || presses.back().key < 0 || presses.back().character) // a held key, or a composition
        presses.push_back({-1, -1, false, 0, pointer, glfwGetTime()});
    presses.back().character = character;
}

void note_pointer(GLFWwindow*, double x, double y) {
    pointer = {static_cast<float>(std::floor(x)), static_cast<float>(std::floor(y))};
}

void check_result(VkResult result) {
    if (result < 0)
        throw std::runtime_error(vk::to_string(static_cast<vk::Result>(result)));
}

// A dark style that does not distract from the picture.
void set_style(float density) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = style.ScrollbarRounding = 3;
    style.WindowBorderSize = 0;
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.WindowPadding = {14, 12};
    style.IndentSpacing = 12;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 1;
    ImVec4* colour = style.Colors;
    const ImVec4 accent{0.91f, 0.68f, 0.36f, 1};
    const ImVec4 dim{accent.x, accent.y, accent.z, 0.55f};
    colour[ImGuiCol_WindowBg] = {0.085f, 0.088f, 0.095f, 1};
    colour[ImGuiCol_PopupBg] = {0.11f, 0.115f, 0.125f, 0.98f};
    colour[ImGuiCol_Text] = {0.86f, 0.86f, 0.85f, 1};
    colour[ImGuiCol_TextDisabled] = {0.52f, 0.53f, 0.54f, 1};
    colour[ImGuiCol_FrameBg] = {0.15f, 0.155f, 0.165f, 1};
    colour[ImGuiCol_FrameBgHovered] = {0.20f, 0.205f, 0.22f, 1};
    colour[ImGuiCol_FrameBgActive] = {0.24f, 0.245f, 0.26f, 1};
    colour[ImGuiCol_Header] = {0.13f, 0.135f, 0.145f, 1};
    colour[ImGuiCol_HeaderHovered] = {0.18f, 0.185f, 0.2f, 1};
    colour[ImGuiCol_HeaderActive] = {0.21f, 0.215f, 0.23f, 1};
    colour[ImGuiCol_Button] = {0.18f, 0.185f, 0.2f, 1};
    colour[ImGuiCol_ButtonHovered] = {0.25f, 0.255f, 0.27f, 1};
    colour[ImGuiCol_ButtonActive] = dim;
    colour[ImGuiCol_SliderGrab] = colour[ImGuiCol_SliderGrabActive] = {}; // slider() draws a line
    colour[ImGuiCol_CheckMark] = accent;
    colour[ImGuiCol_PlotHistogram] = dim;
    colour[ImGuiCol_Separator] = {0.2f, 0.205f, 0.22f, 1};
    colour[ImGuiCol_NavHighlight] = accent;
    colour[ImGuiCol_TitleBg] = colour[ImGuiCol_TitleBgActive] = colour[ImGuiCol_Header];
    colour[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.5f};
    style.ScaleAllSizes(density);
}

// Loads the main font and, for characters that it lacks, one desktop font per script.
void build_fonts(float pixels, const std::set<ImWchar>& characters) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    std::deque<ImVector<ImWchar>> kept; // must live until the atlas is built
    const auto add = [&](const system::Font& font, const auto& wanted) {
        ImFontConfig config;
        config.MergeMode = !atlas.Fonts.empty(); // adds only characters that are still missing
        config.FontNo = font.second;
        ImFontGlyphRangesBuilder ranges;
        ranges.AddRanges(atlas.GetGlyphRangesDefault());
        for (const unsigned character : wanted)
            ranges.AddChar(static_cast<ImWchar>(character));
        ranges.BuildRanges(&kept.emplace_back());
        if (std::filesystem::exists(font.first))
            atlas.AddFontFromFileTTF(font.first.c_str(), pixels, &config, kept.back().Data);
    };
    add(system::sans_font(), characters);
    if (atlas.Fonts.empty()) {
        ImFontConfig config;
        config.SizePixels = std::round(13.0f / 14.0f * pixels);
        atlas.AddFontDefault(&config); // Dear ImGui's built-in font
    }
    std::map<int, std::vector<unsigned>> scripts;
    for (const ImWchar c : characters)
        scripts[c < 0x3000 || c >= 0xa000 ? c >> 8 : 0x30].push_back(
            c); // Chinese and Japanese share one font
    for (const auto& [script, wanted] : scripts)
        for (const system::Font& font : system::fonts_with(wanted))
            add(font, wanted);
    dear_imgui::build(atlas);
}

// Closes colour pickers and drop-down lists that a press at `at` misses, so that the press also reaches the
// control there. On the row of the control that opened them, Dear ImGui closes them and uses up the press:
// otherwise the control would open them again.
void close_popups(ImVec2 at) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const auto& open = context.OpenPopupStack;
    if (open.empty() || ImGui::GetTopMostPopupModal() ||
        std::abs(at.y - open.front().OpenMousePos.y) < ImGui::GetFrameHeight() / 2)
        return;
    ImGui::ClosePopupsOverWindow(context.HoveredWindow, true);
}

vk::raii::DescriptorPool make_descriptors(const vulkan::Device& device) {
    constexpr std::uint32_t textures = 8; // Dear ImGui 1.92 asks for so many
    const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, textures);
    return {device.state().device, vk::DescriptorPoolCreateInfo(
                                       vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, textures, size)};
}

} // namespace

Gui::Gui(const vulkan::Device& device, const Window& window, vk::RenderPass pass, std::uint32_t images,
         float scale)
    : device_(device), window_(window.handle()), pass_(pass), density_(window.density()), scale_(scale) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // settings.hpp keeps the viewer's settings
    dear_imgui::process_events_at_once(); // take_press delays presses
    set_style(density_ * scale);
    // Dear ImGui's callback, if it has one, calls this.
    glfwSetCursorPosCallback(window.handle(), note_pointer);
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
    glfwSetKeyCallback(window.handle(), note_key);
    glfwSetCharCallback(window.handle(), note_character);
    glfwSetMouseButtonCallback(window.handle(), note_button);
    const vulkan::Device::State& state = device.state();
    info_.Instance = *state.instance;
    info_.PhysicalDevice = *state.physical;
    info_.Device = *state.device;
    info_.QueueFamily = state.family;
    info_.Queue = *state.queue;
    info_.MinImageCount = 2;
    info_.ImageCount = std::max(images, 2u);
    info_.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info_.CheckVkResultFn = check_result;
    load_fonts();
}

// Restarts Dear ImGui's renderer, which frees font textures only when it shuts down.
void Gui::load_fonts() {
    if (std::exchange(loaded_, true))
        return;
    if (info_.DescriptorPool) {
        device_.state().device.waitIdle();
        ImGui_ImplVulkan_Shutdown();
    }
    build_fonts(std::round(14.0f * density_ * scale_), characters_); // Dear ImGui 1.90 would round down
    descriptors_ = make_descriptors(device_);
    info_.DescriptorPool = *descriptors_;
    dear_imgui::start_renderer(device_, info_, pass_);
}

Gui::~Gui() {
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::set_scale(float scale) {
    if (scale == scale_)
        return;
    scale_ = scale;
    loaded_ = false;
    ImGui::GetStyle() = ImGuiStyle();
    set_style(density_ * scale);
}

void Gui::prepare(std::string_view text) {
    constexpr ImWchar last_of_latin = 0xff; // always loaded
    for (const char *at = text.data(), *const end = at + text.size(); at < end;) {
        unsigned int character = 0;
        at += ImTextCharFromUtf8(&character, at, end);
        if (character > last_of_latin && character <= IM_UNICODE_CODEPOINT_MAX &&
            characters_.insert(static_cast<ImWchar>(character)).second)
            loaded_ = false;
    }
}

void Gui::begin() {
    load_fonts();
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    take_press();
    for (std::size_t i = 0; i < buttons_.size(); ++i)
        dear_imgui::set_button(static_cast<int>(i), buttons_[i]);
    ImGui::NewFrame();
}

bool Gui::has_input() const {
    return !presses.empty();
}

// Processes the next Press, if any. A frame processes at most one.
void Gui::take_press() {
    constexpr float double_click = 0.3f; // seconds between the presses, however long a frame takes
    ImGuiIO& io = ImGui::GetIO();
    io.MouseDoubleClickTime = double_click;
    const auto is = [&](int attribute) { return glfwGetWindowAttrib(window_, attribute) == GLFW_TRUE; };
    if (is(GLFW_FOCUSED) || is(GLFW_HOVERED)) { // the last frame may have moved the pointer to a press
        double x = 0, y = 0;
        glfwGetCursorPos(window_, &x, &y);
        dear_imgui::set_pointer({static_cast<float>(x), static_cast<float>(y)});
    }
    const auto down = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
    const auto tell = [&](int key, int action) {
        ImGui_ImplGlfw_KeyCallback(window_, key, glfwGetKeyScancode(key), action, 0);
    };
    if (released_)
        tell(std::exchange(released_, 0), GLFW_RELEASE);
    dear_imgui::set_modifiers(down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL),
                              down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT));
    // A field takes all text up to the next key that edits or leaves it, without a frame for each key. The
    // last key or click may have moved to another field or closed this one, which takes two frames to show.
    const auto is_text = [&] {
        return !presses.empty() && presses.front().character && (io.WantTextInput || presses.front().key < 0);
    };
    if (is_text()) {
        if (ImGui::GetFrameCount() > taken_in_ + 2)
            for (; is_text(); presses.pop_front())
                io.AddInputCharacter(presses.front().character);
        return;
    }
    if (presses.empty())
        return;
    const Press next = presses.front();
    const bool is_key = next.key >= 0;
    if (is_key && dear_imgui::is_down(next.key))
        return tell(next.key, GLFW_RELEASE); // the press follows in the next frame
    if (!is_key) {
        dear_imgui::set_pointer(next.at);
        if (next.at.x != io.MousePosPrev.x || next.at.y != io.MousePosPrev.y)
            return; // as above
    }
    presses.pop_front();
    taken_in_ = ImGui::GetFrameCount();
    if (is_key) {
        tell(next.key, GLFW_PRESS);
        if (next.character)
            io.AddInputCharacter(next.character);
        if (!down(next.key))
            released_ = next.key;
    }
    dear_imgui::set_modifiers((next.modifiers & GLFW_MOD_CONTROL) != 0,
                              (next.modifiers & GLFW_MOD_SHIFT) != 0);
    if (is_key)
        return;
    const auto button = static_cast<std::size_t>(next.button);
    buttons_.at(button) = next.down;
    if (!next.down)
        return;
    io.MouseDoubleClickTime =
        next.time - std::exchange(pressed_at_.at(button), next.time) < double{double_click} ? FLT_MAX : 0;
    close_popups(next.at);
}

void Gui::end() {
    ImGui::Render();
}

void Gui::draw(vk::CommandBuffer commands) const {
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

} // namespace gabor::viewer
