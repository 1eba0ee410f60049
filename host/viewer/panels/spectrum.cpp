#include "viewer/panels.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::viewer {

namespace {

constexpr float floor_decibels = -50;
constexpr int cells_across = 72; ///< of the measured spectrum's drawing

// The drawing of the frequency plane: which point of the screen is which wave vector, in cycles per kernel radius.
struct Plane {
    ImVec2 middle;
    float half;     ///< side, in pixels
    double reaches; ///< frequency at the edge

    ImVec2 at(double fx, double fy) const {
        return {middle.x + half * static_cast<float>(fx / reaches), middle.y + half * static_cast<float>(fy / reaches)};
    }
};

void draw_measured(ImDrawList& draw, const Plane& plane, const MeasuredSpectrum& spectrum) {
    const double cell = 2 * plane.reaches / cells_across;
    for (int y = 0; y < cells_across; ++y)
        for (int x = 0; x < cells_across; ++x) {
            const double fx = -plane.reaches + x * cell;
            const double fy = -plane.reaches + y * cell;
            // The strongest of what falls into the cell: a narrow lobe must not get lost.
            const auto first = [&](double f) { return static_cast<int>(std::floor(f / spectrum.step + 0.5)) + spectrum.side / 2; };
            const int last_x = std::max(first(fx) + 1, first(fx + cell));
            const int last_y = std::max(first(fy) + 1, first(fy + cell));
            float strongest = floor_decibels;
            for (int j = std::max(first(fy), 0); j < std::min(last_y, spectrum.side); ++j)
                for (int i = std::max(first(fx), 0); i < std::min(last_x, spectrum.side); ++i)
                    strongest = std::max(
                        strongest,
                        spectrum.decibels[static_cast<std::size_t>(j) * static_cast<std::size_t>(spectrum.side) +
                                          static_cast<std::size_t>(i)]);
            if (strongest <= floor_decibels)
                continue;
            const float t = 1 - strongest / floor_decibels;
            const auto channel = [&](float power, float top) {
                return static_cast<int>(top * std::pow(t, power));
            };
            draw.AddRectFilled(plane.at(fx, fy), plane.at(fx + cell, fy + cell),
                               IM_COL32(channel(1.2f, 190), channel(1.5f, 200), channel(1.0f, 215), 255));
        }
}

// Rings at round frequencies, and the axes.
void draw_scale(ImDrawList& draw, const Plane& plane) {
    const ImU32 faint = IM_COL32(255, 255, 255, 28);
    draw.AddLine(plane.at(-plane.reaches, 0), plane.at(plane.reaches, 0), faint);
    draw.AddLine(plane.at(0, -plane.reaches), plane.at(0, plane.reaches), faint);
    const double step = std::exp2(std::floor(std::log2(plane.reaches)) - 1);
    for (double ring = step; ring < plane.reaches; ring += step) {
        draw.AddCircle(plane.middle, plane.half * static_cast<float>(ring / plane.reaches), faint, 64);
        const ImVec2 at = plane.at(ring, 0);
        draw.AddText({at.x + 2, at.y + 1}, IM_COL32(255, 255, 255, 110), fmt::format("{:g}", ring).c_str());
    }
}

} // namespace

void spectrum_panel(Session& session) {
    render::Picture& picture = session.document().picture;
    const float side = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("frequency plane", {side, side});
    const bool dragging = ImGui::IsItemActive();

    // The plane reaches past the lobe to a power of two, and stays as it is while the lobe is dragged.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("reaches");
    const auto wanted = static_cast<float>(std::exp2(std::ceil(std::log2(1.35 * picture.frequency))));
    const float reaches = dragging ? storage.GetFloat(id, wanted) : wanted;
    storage.SetFloat(id, reaches);
    const Plane plane{{corner.x + side / 2, corner.y + side / 2}, side / 2, double{reaches}};

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(corner, {corner.x + side, corner.y + side}, true);
    draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, IM_COL32(8, 9, 11, 255));
    if (!session.sides.empty() && session.sides[0].measured.spectrum)
        draw_measured(draw, plane, *session.sides[0].measured.spectrum);
    draw_scale(draw, plane);

    const double radians = picture.orientation * std::numbers::pi / 180;
    if (dragging) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const double fx = double{mouse.x - plane.middle.x} / double{plane.half} * plane.reaches;
        const double fy = double{mouse.y - plane.middle.y} / double{plane.half} * plane.reaches;
        if (std::hypot(fx, fy) > 0.02 * plane.reaches) {
            picture.frequency = std::clamp(std::hypot(fx, fy), render::smallest_frequency, render::largest_frequency);
            picture.orientation = std::atan2(fy, fx) * 180 / std::numbers::pi;
        }
    } else if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("The frequency plane, in cycles per kernel radius: what was measured in the picture,\n"
                          "50 dB from dark to bright, and the lobe that was asked for. Drag it.");
    }
    const double fx = picture.frequency * std::cos(radians);
    const double fy = picture.frequency * std::sin(radians);
    const ImU32 accent = ImGui::GetColorU32(ImGuiCol_CheckMark);
    const float radius = ImGui::GetFontSize() * 0.45f;
    draw.AddCircle(plane.at(fx, fy), radius, accent, 0, 2);
    draw.AddCircle(plane.at(-fx, -fy), radius * 0.7f, accent, 0, 1);
    draw.PopClipRect();
    ImGui::TextDisabled("%s", fmt::format("{:.3g} cycles per radius at {:.1f} degrees", picture.frequency,
                                          picture.orientation)
                                  .c_str());
}

} // namespace gabor::viewer
