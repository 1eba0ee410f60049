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

// The drawing of the frequency plane: which point of the screen is which wave vector, in cycles per kernel
// radius.
struct Plane {
    ImVec2 middle;
    float half;     ///< side, in pixels
    double reaches; ///< frequency at the edge

    ImVec2 at(double fx, double fy) const {
        return {middle.x + half * static_cast<float>(fx / reaches),
                middle.y + half * static_cast<float>(fy / reaches)};
    }
};

void draw_measured(ImDrawList& draw, const Plane& plane, const MeasuredSpectrum& spectrum) {
    const double cell = 2 * plane.reaches / cells_across;
    for (int y = 0; y < cells_across; ++y)
        for (int x = 0; x < cells_across; ++x) {
            const double fx = -plane.reaches + x * cell;
            const double fy = -plane.reaches + y * cell;
            // The strongest of what falls into the cell: a narrow lobe must not get lost.
            const auto first = [&](double f) {
                return static_cast<int>(std::floor(f / spectrum.step + 0.5)) + spectrum.side / 2;
            };
            const int last_x = std::max(first(fx) + 1, first(fx + cell));
            const int last_y = std::max(first(fy) + 1, first(fy + cell));
            float strongest = floor_decibels;
            for (int j = std::max(first(fy), 0); j < std::min(last_y, spectrum.side); ++j)
                for (int i = std::max(first(fx), 0); i < std::min(last_x, spectrum.side); ++i)
                    strongest =
                        std::max(strongest, spectrum.decibels[static_cast<std::size_t>(j) *
                                                                  static_cast<std::size_t>(spectrum.side) +
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

// Where a lobe's waves are: its middle, and the outline of its spread.
void draw_lobe(ImDrawList& draw, const Plane& plane, const noise::Lobe& lobe, bool chosen) {
    const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    const ImU32 colour = chosen ? ImGui::GetColorU32(accent) : IM_COL32(210, 210, 205, 190);
    const float radius = ImGui::GetFontSize() * 0.38f;
    const auto point = [&](double frequency, double degrees) {
        return plane.at(frequency * std::cos(noise::radians(degrees)),
                        frequency * std::sin(noise::radians(degrees)));
    };
    for (const double half : {0.0, 180.0}) {
        if (lobe.frequency_spread > 0 || lobe.orientation_spread > 0) {
            constexpr int steps = 24;
            for (const double edge : {1 - lobe.frequency_spread, 1 + lobe.frequency_spread})
                for (int i = 0; i <= steps; ++i) {
                    // Out along one edge and back along the other.
                    const int step = edge < 1 ? i : steps - i;
                    draw.PathLineTo(
                        point(lobe.frequency * edge,
                              half + lobe.orientation + lobe.orientation_spread * (2.0 * step / steps - 1)));
                }
            draw.PathStroke(colour, ImDrawFlags_Closed, 1);
        }
        draw.AddCircle(point(lobe.frequency, half + lobe.orientation), half == 0 ? radius : 0.6f * radius,
                       colour, 0, half == 0 ? 2.0f : 1.0f);
    }
}

// The lobe nearest to a point of the screen.
std::size_t nearest(const Plane& plane, const std::vector<noise::Lobe>& lobes, ImVec2 point) {
    std::size_t best = 0;
    float closest = 1e9f;
    for (std::size_t i = 0; i < lobes.size(); ++i)
        for (const double sign : {1.0, -1.0}) {
            const double angle = lobes[i].angle();
            const ImVec2 at = plane.at(sign * lobes[i].frequency * std::cos(angle),
                                       sign * lobes[i].frequency * std::sin(angle));
            const float distance = std::hypot(at.x - point.x, at.y - point.y);
            if (distance < closest) {
                closest = distance;
                best = i;
            }
        }
    return best;
}

void drag_lobe(const Plane& plane, noise::Lobe& lobe) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double fx = double{mouse.x - plane.middle.x} / double{plane.half} * plane.reaches;
    const double fy = double{mouse.y - plane.middle.y} / double{plane.half} * plane.reaches;
    if (std::hypot(fx, fy) < 0.02 * plane.reaches)
        return;
    const render::Range range = render::parameter("frequency").range;
    lobe.frequency = std::clamp(std::hypot(fx, fy), range.low, range.high);
    lobe.orientation = noise::degrees(std::atan2(fy, fx));
}

// The list of lobes, beside the drawing.
bool lobe_list(Session& session, std::vector<noise::Lobe>& lobes) {
    bool changed = false;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const std::string text =
            fmt::format("{:.3g} at {:.0f}##{}", lobes[i].frequency, lobes[i].orientation, i);
        if (ImGui::Selectable(text.c_str(), i == session.selected_lobe))
            session.selected_lobe = i;
    }
    if (ImGui::SmallButton("add")) {
        noise::Lobe lobe = lobes[session.selected_lobe];
        lobe.orientation = std::remainder(lobe.orientation + 45, 360.0);
        lobes.push_back(lobe);
        session.selected_lobe = lobes.size() - 1;
        changed = true;
    }
    tooltip("Another lobe; each impulse has a wave of one of them, so that many cost as much as one");
    if (lobes.size() > 1) {
        ImGui::SameLine();
        if (ImGui::SmallButton("remove")) {
            lobes.erase(lobes.begin() + static_cast<std::ptrdiff_t>(session.selected_lobe));
            session.selected_lobe = std::min(session.selected_lobe, lobes.size() - 1);
            changed = true;
        }
    }
    ImGui::EndGroup();
    return changed;
}

bool lobe_sliders(noise::Lobe& lobe, bool one_of_many) {
    bool changed = false;
    for (const render::LobeParameter& p : render::lobe_parameters()) {
        if (p.member == &noise::Lobe::power && !one_of_many)
            continue;
        std::string label(p.name);
        std::ranges::replace(label, '_', ' ');
        changed |= number_slider(label.c_str(), lobe.*p.member, p.range, p.slider);
        tooltip(fmt::format("{} ({})", p.help, p.unit).c_str());
    }
    return changed;
}

} // namespace

void spectrum_panel(Session& session) {
    std::vector<noise::Lobe> lobes = session.document().request.lobes;
    session.selected_lobe = std::min(session.selected_lobe, lobes.size() - 1);
    const float side = 0.68f * ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("frequency plane", {side, side});
    const bool dragging = ImGui::IsItemActive();
    const bool begun = ImGui::IsItemActivated();

    // The plane reaches past all lobes to a power of two, and stays as it is while one is dragged.
    double highest = 0;
    for (const noise::Lobe& lobe : lobes)
        highest = std::max(highest, lobe.frequency * (1 + lobe.frequency_spread));
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("reaches");
    const auto wanted = static_cast<float>(std::exp2(std::ceil(2 * std::log2(1.35 * highest)) / 2));
    const float reaches = dragging ? storage.GetFloat(id, wanted) : wanted;
    storage.SetFloat(id, reaches);
    const Plane plane{{corner.x + side / 2, corner.y + side / 2}, side / 2, double{reaches}};

    if (begun)
        session.selected_lobe = nearest(plane, lobes, ImGui::GetIO().MousePos);
    if (dragging) {
        drag_lobe(plane, lobes[session.selected_lobe]);
    } else if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "The frequency plane, in cycles per kernel radius: what was measured in the picture,\n"
            "50 dB from dark to bright, and the lobes that were asked for. Drag them.");
    }

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(corner, {corner.x + side, corner.y + side}, true);
    draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, IM_COL32(8, 9, 11, 255));
    if (!session.panes.empty() && session.panes[0].measured.spectrum &&
        is_flat(session.document().request.view))
        draw_measured(draw, plane, *session.panes[0].measured.spectrum);
    draw_scale(draw, plane);
    for (std::size_t i = 0; i < lobes.size(); ++i)
        draw_lobe(draw, plane, lobes[i], i == session.selected_lobe);
    draw.PopClipRect();

    ImGui::SameLine();
    bool changed = lobe_list(session, lobes);
    changed |= lobe_sliders(lobes[session.selected_lobe], lobes.size() > 1);
    if (changed || dragging)
        attempt(session, [&] { set_parameter(session.document(), "lobes", lobes); });
}

} // namespace gabor::viewer
