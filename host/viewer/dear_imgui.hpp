#pragma once

// What differs between versions 1.86 and 1.92 of Dear ImGui. Keys are those of GLFW.

#include "vulkan/device.hpp"

#include <vulkan/vulkan_raii.hpp>

#include <imgui.h>

#include <backends/imgui_impl_vulkan.h>

namespace gabor::viewer::dear_imgui {

/// Tell Dear ImGui the state of the pointer, a button and keys.
void set_pointer(ImVec2 at);
void set_button(int button, bool down);
void set_key(int key, bool down);
void set_modifiers(bool ctrl, bool shift);
/// Whether a key is down, and whether it went down in this frame or, with `repeat`, is held.
bool is_down(int key);
bool went_down(int key, bool repeat);

/// Lets a frame process all events that have arrived.
void process_events_at_once();

/// Starts the renderer, and uploads the fonts.
void start_renderer(const vulkan::Device& device, ImGui_ImplVulkan_InitInfo& info, vk::RenderPass pass);

/// Draws the fonts' letters into the atlas.
void build(ImFontAtlas& atlas);

/// A letter of the current font.
const ImFontGlyph& glyph(ImWchar letter);

/// Presses a button or a check box in the next frame.
void activate(ImGuiID item);

} // namespace gabor::viewer::dear_imgui
