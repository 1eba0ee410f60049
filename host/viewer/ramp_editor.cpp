#include "viewer/ramp_editor.hpp"

#include "viewer/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

namespace {

std::array<float, 3> colour_at(const std::vector<ColourStop>& ramp, float at) {
    std::array<float, 3> colour = ramp.front().colour;
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        const float t =
            std::clamp((at - ramp[i - 1].at) / std::max(ramp[i].at - ramp[i - 1].at, 0.001f), 0.0f, 1.0f);
        for (std::size_t c = 0; c < colour.size(); ++c)
            colour[c] = std::lerp(colour[c], ramp[i].colour[c], t);
    }
    return colour;
}

ImU32 shown(const std::array<float, 3>& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1});
}

} // namespace

void ramp_editor(Session& session) {
    std::vector<ColourStop>& ramp = session.document().ramp;
    std::size_t& selected = session.selected_stop;
    selected = std::min(selected, ramp.size() - 1);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::CalcItemWidth(), 1.5f * ImGui::GetFrameHeight()};
    ImGui::InvisibleButton("ramp", size);
    const float reach = 0.4f * ImGui::GetFontSize(); // half the width of a stop's handle
    const auto place = [&](float at) { return corner.x + reach + at * (size.x - 2 * reach); };
    const float pointed =
        std::clamp((ImGui::GetIO().MousePos.x - place(0)) / (place(1) - place(0)), 0.0f, 1.0f);
    const auto nearest = static_cast<std::size_t>(
        std::ranges::min_element(ramp, {}, [&](const ColourStop& s) { return std::abs(s.at - pointed); }) -
        ramp.begin());
    const bool at_stop = std::abs(ramp[nearest].at - pointed) * (size.x - 2 * reach) <= 1.5f * reach;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !at_stop && ramp.size() < most_stops) {
        const auto next = std::ranges::upper_bound(ramp, pointed, {}, &ColourStop::at);
        selected = static_cast<std::size_t>(next - ramp.begin());
        ramp.insert(next, {pointed, colour_at(ramp, pointed)});
    } else if (ImGui::IsItemActivated()) {
        selected = nearest;
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) { // stays between its neighbours
        const float low = selected > 0 ? ramp[selected - 1].at : 0;
        const float high = selected + 1 < ramp.size() ? ramp[selected + 1].at : 1;
        ramp[selected].at = std::clamp(pointed, low, high);
    }
    tooltip("Drag a colour to move it; double-click between two to add one");

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float bottom = corner.y + size.y - 2 * reach;
    constexpr int pieces = 64;
    for (int i = 0; i < pieces; ++i) {
        const auto share = [](int piece) { return static_cast<float>(piece) / pieces; };
        const ImU32 left = shown(colour_at(ramp, share(i)));
        const ImU32 right = shown(colour_at(ramp, share(i + 1)));
        draw.AddRectFilledMultiColor({place(share(i)), corner.y}, {place(share(i + 1)), bottom}, left, right,
                                     right, left);
    }
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        const ImVec2 middle{place(ramp[i].at), bottom + reach};
        draw.AddCircleFilled(middle, reach, shown(ramp[i].colour));
        draw.AddCircle(middle, reach, ImGui::GetColorU32(i == selected ? ImGuiCol_CheckMark : ImGuiCol_Text),
                       0, 1.5f);
    }
    attempt(session, [&] { colour_field("colour", ramp[selected].colour); });
    if (ramp.size() > 2) {
        ImGui::SameLine();
        if (ImGui::Button("remove"))
            ramp.erase(ramp.begin() + static_cast<std::ptrdiff_t>(selected));
    }
}

} // namespace gabor::viewer
