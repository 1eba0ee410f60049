#include "viewer/widgets.hpp"

#include "error.hpp"
#include "viewer/dear_imgui.hpp"
#include "viewer/document.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>

namespace gabor::viewer {

void progress_bar(double done, float width) {
    ImGui::ProgressBar(static_cast<float>(done), {width, 0}, fmt::format("{:.0f} %", 100 * done).c_str());
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

bool slider(const char* label, float& value, float low, float high, const char* format, int flags) {
    const float width = ImGui::CalcItemWidth();
    const bool moved = ImGui::SliderFloat(label, &value, low, high, format, flags);
    const float share = flags & ImGuiSliderFlags_Logarithmic
                            ? std::log(std::max(value, low) / low) / std::log(high / low)
                            : (value - low) / (high - low);
    const ImVec2 left{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y};
    ImGui::GetWindowDrawList()->AddRectFilled({left.x, left.y - ImGui::GetFontSize() / 5},
                                              {left.x + width * std::clamp(share, 0.0f, 1.0f), left.y},
                                              ImGui::GetColorU32(ImGuiCol_CheckMark));
    return moved;
}

bool number_slider(const char* label, double& value, const render::Range& range, const render::Range& usual,
                   double by_default) {
    auto shown = static_cast<float>(value);
    const ImGuiSliderFlags logarithmic = usual.low > 0 ? ImGuiSliderFlags_Logarithmic : 0;
    const char* const format = std::abs(shown) < 1000 ? "%.3g" : "%.0f"; // kilometres as metres, not 2e+05
    const bool moved = slider(label, shown, static_cast<float>(usual.low), static_cast<float>(usual.high),
                              format, logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    if (reset_asked(label)) {
        const bool changed = value != by_default;
        value = by_default;
        return changed;
    }
    if (moved)
        value = std::clamp(double{shown}, range.low, range.high);
    return moved;
}

bool pressed(int key, bool repeat) {
    return dear_imgui::went_down(key, repeat);
}

bool key_went_down() {
    return std::ranges::any_of(std::views::iota(GLFW_KEY_SPACE, GLFW_KEY_LAST + 1),
                               [](int key) { return pressed(key); });
}

void tooltip(std::string_view text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive())
        return;
    constexpr double delay =
        0.5; // seconds that the pointer must rest on an item; items are identified by their position
    static ImVec2 place;
    static int frame = 0;
    static double since = 0;
    const ImVec2 here = ImGui::GetItemRectMin();
    if (here.x != place.x || here.y != place.y || ImGui::GetFrameCount() > frame + 1)
        since = ImGui::GetTime();
    place = here;
    frame = ImGui::GetFrameCount();
    if (key_went_down()) // a shortcut was used; the pointer must rest on another item
        since = std::numeric_limits<double>::infinity();
    if (ImGui::GetTime() - since < delay)
        return;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = ImGui::FindWindowByName("panels")->Pos.x - style.ItemSpacing.x;
    const float wrap = std::min(24 * ImGui::GetFontSize(), right - 2 * style.WindowPadding.x);
    const char* const end = text.data() + text.size();
    const float height = ImGui::CalcTextSize(text.data(), end, false, wrap).y + 2 * style.WindowPadding.y;
    ImGui::SetNextWindowPos({right, std::min(here.y, ImGui::GetIO().DisplaySize.y - height)},
                            ImGuiCond_Always, {1, 0});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(style.WindowPadding.x + wrap);
    ImGui::TextUnformatted(text.data(), end);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string label_of(std::string_view name) {
    if (name == "scale")
        return "pattern size";
    std::string label(name.substr(name.find('.') + 1)); // the name may be MATERIAL.PARAMETER
    std::ranges::replace(label, '_', ' ');
    return label;
}

bool choose_number(const char* label, std::size_t& number, std::span<const std::string_view> names,
                   std::span<const char* const> tips) {
    const std::size_t before = number;
    if (ImGui::BeginCombo(label, std::string(names[number]).c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(std::string(names[i]).c_str(), i == before))
                number = i;
            if (i < tips.size())
                tooltip(tips[i]);
        }
        ImGui::EndCombo();
    }
    if (before < tips.size())
        tooltip(tips[before]);
    return number != before;
}

namespace {

// The colour of six hexadecimal digits after an optional #.
std::optional<std::array<float, 3>> colour_of(std::string_view code) {
    code.remove_prefix(code.starts_with('#') ? 1 : 0);
    if (code.size() != 6 || code.find_first_not_of("0123456789abcdefABCDEF") != code.npos)
        return {};
    const unsigned long bits = std::stoul(std::string(code), nullptr, 16);
    const auto part = [bits](int shift) { return static_cast<float>(bits >> shift & 255) / 255; };
    return std::array{part(16), part(8), part(0)};
}

} // namespace

bool colour_field(const char* label, std::array<float, 3>& colour) {
    static std::string typed; // in the field that is being edited
    const float between = ImGui::GetStyle().ItemInnerSpacing.x;
    std::array<char, 32> code{};
    hex(colour).copy(code.data(), code.size() - 1);
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - between);
    const bool edited = ImGui::InputText(fmt::format("##{}", label).c_str(), code.data(), code.size());
    if (edited)
        typed = code.data();
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    ImGui::SameLine(0, between);
    const bool picked = ImGui::ColorEdit3(label, colour.data(),
                                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_DisplayHex);
    if (!edited && !left)
        return picked;
    const auto read = colour_of(typed);
    if (!read && left)
        throw RequestError(fmt::format("'{}' is no colour: expected six hexadecimal digits, such as {}",
                                       typed, hex(colour)));
    colour = read.value_or(colour);
    return picked || read;
}

void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour, float wrap) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const float pad = ImGui::GetStyle().FramePadding.x;
    draw.AddRectFilled({at.x, at.y}, {at.x + size.x + 2 * pad, at.y + size.y + pad},
                       IM_COL32(12, 13, 15, 200), ImGui::GetStyle().FrameRounding);
    draw.AddText(nullptr, 0, {at.x + pad, at.y + pad / 2}, colour, text.c_str(), nullptr, wrap);
}

} // namespace gabor::viewer
