#include "viewer/panels.hpp"

#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <type_traits>

namespace gabor::viewer {

namespace {

// Whether the grab is in the left half.
bool is_low(double value, double low, double high, bool logarithmic) {
    return logarithmic ? value * value < low * high : value < (low + high) / 2;
}

} // namespace

template <typename T>
bool slider(const char* label, T& value, T low, T high, const char* format, ImGuiSliderFlags flags) {
    constexpr ImGuiDataType type = std::is_same_v<T, int> ? ImGuiDataType_S32 : ImGuiDataType_Float;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcItemWidth();
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID(label));
    if (!typing) // hides the number that ImGui draws in the middle
        ImGui::PushStyleColor(ImGuiCol_Text, {0, 0, 0, 0});
    const bool moved = ImGui::SliderScalar(label, type, &value, &low, &high, format, flags);
    if (typing)
        return moved;
    ImGui::PopStyleColor();
    std::array<char, 64> number{};
    std::snprintf(number.data(), number.size(), format, value);
    const bool left = !is_low(value, low, high, (flags & ImGuiSliderFlags_Logarithmic) != 0);
    const ImVec2 corner = ImGui::GetItemRectMin();
    const float y = corner.y + style.FramePadding.y;
    const float end = corner.x + width - style.FramePadding.x - ImGui::CalcTextSize(number.data()).x;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
    draw.AddText({left ? corner.x + style.FramePadding.x : end, y}, colour, number.data());
    draw.AddText({corner.x + width + style.ItemInnerSpacing.x, y}, colour, label,
                 ImGui::FindRenderedTextEnd(label));
    return moved;
}

template bool slider(const char*, float&, float, float, const char*, ImGuiSliderFlags);
template bool slider(const char*, int&, int, int, const char*, ImGuiSliderFlags);

} // namespace gabor::viewer
