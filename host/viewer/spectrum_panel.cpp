#include "viewer/spectrum_panel.hpp"

#include "noise/spectrum.hpp"
#include "viewer/widgets.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gabor::viewer {

namespace {

constexpr std::size_t no_lobe = static_cast<std::size_t>(-1);
constexpr double floor_decibels = -50;
constexpr int cells_across = 72; // cells along a side of the drawn spectrum

// Maps wave vectors, in cycles per kernel radius, to the screen.
struct Plane {
    ImVec2 middle;
    float half;     ///< half its side, in pixels
    double reaches; ///< frequency at the edge

    ImVec2 at(double fx, double fy) const {
        return {middle.x + half * static_cast<float>(fx / reaches),
                middle.y + half * static_cast<float>(fy / reaches)};
    }
};

// The power at f cycles per kernel radius of the lattice's window: a Hann window, two kernel radii wide.
double window_power(double f) {
    const double x = std::numbers::pi * 2 * f;
    if (std::abs(f) < 1e-6 || std::abs(std::abs(f) - 0.5) < 1e-6)
        return std::abs(f) < 0.25 ? 1 : 0.25;
    return std::pow(std::sin(x) / (x * (1 - 4 * f * f)), 2);
}

// The power spectrum of the lobes' noise in the cells of the drawing, row by row. Each cell has the strongest
// power within it, so that narrow lobes show.
std::vector<double> power_in_cells(const std::vector<noise::Lobe>& lobes, double reaches) {
    const double cell = 2 * reaches / cells_across;
    std::vector<double> powers(cells_across * cells_across);
    for (const noise::Wave& wave : noise::waves(lobes, 0))
        for (const double sign : {1.0, -1.0}) {
            const auto along = [&](double frequency, double radius) {
                std::array<double, cells_across> factors{};
                for (std::size_t i = 0; i < factors.size(); ++i) {
                    const double middle = -reaches + (static_cast<double>(i) + 0.5) * cell;
                    const double away = std::max(std::abs(middle - sign * frequency) - cell / 2, 0.0);
                    factors.at(i) = radius * window_power(away * radius);
                }
                return factors;
            };
            const auto x = along(wave.frequency * std::cos(wave.angle), wave.radius[0]);
            const auto y = along(wave.frequency * std::sin(wave.angle), wave.radius[1]);
            for (std::size_t i = 0; i < powers.size(); ++i)
                powers[i] += wave.share * x.at(i % cells_across) * y.at(i / cells_across);
        }
    return powers;
}

void draw_power(ImDrawList& draw, const Plane& plane, const std::vector<noise::Lobe>& lobes) {
    static std::vector<noise::Lobe> drawn; // kept, because a spread may consist of hundreds of waves
    static double reached = 0;
    static std::vector<double> powers;
    if (drawn != lobes || reached != plane.reaches)
        powers = power_in_cells(drawn = lobes, reached = plane.reaches);
    const double strongest = *std::ranges::max_element(powers);
    const double cell = 2 * plane.reaches / cells_across;
    for (int i = 0; i < cells_across * cells_across; ++i) {
        const double decibels = 10 * std::log10(powers[static_cast<std::size_t>(i)] / strongest);
        if (!(decibels > floor_decibels))
            continue;
        const double t = 1 - decibels / floor_decibels;
        const auto channel = [&](double power, double top) {
            return static_cast<int>(top * std::pow(t, power));
        };
        const double fx = -plane.reaches + i % cells_across * cell;
        const double fy = -plane.reaches + i / cells_across * cell;
        draw.AddRectFilled(plane.at(fx, fy), plane.at(fx + cell, fy + cell),
                           IM_COL32(channel(1.2, 190), channel(1.5, 200), channel(1.0, 215), 255));
    }
}

// Draws rings at round frequencies, and the axes.
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

// Draws the centre of a lobe and the outline of its spread.
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
                    // out along one edge, back along the other
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

// One of the two handles of a lobe: at its wave vector (sign 1) or at the opposite one (sign -1).
struct Handle {
    std::size_t lobe;
    double sign;
    ImVec2 at;
};

// Returns the handle at a point of the screen, if any.
std::optional<Handle> handle_at(const Plane& plane, const std::vector<noise::Lobe>& lobes, ImVec2 point) {
    std::optional<Handle> best;
    float closest = 0.8f * ImGui::GetFontSize();
    for (std::size_t i = 0; i < lobes.size(); ++i)
        for (const double sign : {1.0, -1.0}) {
            const double angle = lobes[i].angle();
            const ImVec2 at = plane.at(sign * lobes[i].frequency * std::cos(angle),
                                       sign * lobes[i].frequency * std::sin(angle));
            const float distance = std::hypot(at.x - point.x, at.y - point.y);
            if (distance <= closest) {
                closest = distance;
                best = Handle{i, sign, at};
            }
        }
    return best;
}

// Moves a lobe so that its handle with this sign is at `handle`.
void move_lobe(const Plane& plane, noise::Lobe& lobe, double sign, ImVec2 handle) {
    const double fx = sign * double{handle.x - plane.middle.x} / double{plane.half} * plane.reaches;
    const double fy = sign * double{handle.y - plane.middle.y} / double{plane.half} * plane.reaches;
    if (std::hypot(fx, fy) < 0.02 * plane.reaches)
        return;
    const render::Range range = render::parameter("frequency").range;
    lobe.frequency = std::clamp(std::hypot(fx, fy), range.low, range.high);
    lobe.orientation = noise::degrees(std::atan2(fy, fx));
}

void add_lobe(Session& session, std::vector<noise::Lobe>& lobes, const noise::Lobe& lobe) {
    lobes.push_back(lobe);
    session.selected_lobe = lobes.size() - 1;
}

bool remove_lobe(Session& session, std::vector<noise::Lobe>& lobes) {
    if (lobes.size() < 2 || session.selected_lobe >= lobes.size())
        return false;
    lobes.erase(lobes.begin() + static_cast<std::ptrdiff_t>(session.selected_lobe));
    session.selected_lobe = std::min(session.selected_lobe, lobes.size() - 1);
    return true;
}

// Handles the mouse in the frequency plane, which must be the last item. Returns whether lobes changed.
bool edit_plane(Session& session, const Plane& plane, std::vector<noise::Lobe>& lobes) {
    static std::optional<Handle> grabbed; // `at` is relative to the pointer
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !handle_at(plane, lobes, mouse)) {
        noise::Lobe lobe;
        move_lobe(plane, lobe, 1, mouse);
        add_lobe(session, lobes, lobe);
        grabbed = Handle{session.selected_lobe, 1, {0, 0}};
        return true;
    }
    if (ImGui::IsItemActivated()) {
        grabbed = handle_at(plane, lobes, mouse);
        session.selected_lobe = grabbed ? grabbed->lobe : no_lobe;
        if (grabbed)
            grabbed->at = {grabbed->at.x - mouse.x, grabbed->at.y - mouse.y};
    }
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(0) || !grabbed ||
        session.selected_lobe >= lobes.size())
        return false;
    move_lobe(plane, lobes[session.selected_lobe], grabbed->sign,
              {mouse.x + grabbed->at.x, mouse.y + grabbed->at.y});
    return true;
}

// Draws the list of lobes beside the frequency plane. Returns whether lobes changed.
bool lobe_list(Session& session, std::vector<noise::Lobe>& lobes) {
    bool changed = false;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const std::string text =
            fmt::format("{:.3g}, {:.0f}°##{}", lobes[i].frequency, std::round(lobes[i].orientation) + 0.0, i);
        if (ImGui::Selectable(text.c_str(), i == session.selected_lobe))
            session.selected_lobe = i;
    }
    if (ImGui::SmallButton("add")) {
        noise::Lobe lobe = lobes[std::min(session.selected_lobe, lobes.size() - 1)];
        lobe.orientation = std::remainder(lobe.orientation + 22.5, 360.0); // beside the selected one
        add_lobe(session, lobes, lobe);
        changed = true;
    }
    tooltip("Add a lobe; each costs as much as a plain noise");
    if (lobes.size() > 1 && session.selected_lobe < lobes.size()) {
        if (ImGui::SmallButton("remove"))
            changed |= remove_lobe(session, lobes);
        tooltip("Delete: remove the selected lobe");
    }
    ImGui::EndGroup();
    return changed;
}

bool lobe_sliders(const Document& document, noise::Lobe& lobe, bool one_of_many) {
    bool changed = false;
    const auto slide = [&](const render::LobeParameter& p) {
        changed |= number_slider(label_of(p.name).c_str(), lobe.*p.member, p.range, p.slider,
                                 noise::Lobe().*p.member);
        tooltip(fmt::format("{} ({})", p.help, p.unit));
    };
    // The power comes last, so that the other sliders do not move when a second lobe adds it.
    constexpr auto is_power = [](const render::LobeParameter& p) { return p.member == &noise::Lobe::power; };
    for (const render::LobeParameter& p : render::lobe_parameters())
        if (!is_power(p) && has_effect(document, p.name))
            slide(p);
    if (one_of_many)
        slide(*std::ranges::find_if(render::lobe_parameters(), is_power));
    return changed;
}

} // namespace

void spectrum_panel(Session& session) {
    std::vector<noise::Lobe> lobes = session.document().request.lobes;
    if (lobes.size() == 1)
        session.selected_lobe = 0;
    const float room = ImGui::GetContentRegionAvail().x;
    const float side = std::min( // leaves room for the list
        0.68f * room, room - ImGui::GetStyle().ItemSpacing.x - ImGui::CalcTextSize("0.0001, -180°").x);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("frequency plane", {side, side});
    const bool dragging = ImGui::IsItemActive();

    // The plane extends beyond all lobes. Its size does not change while a lobe is dragged.
    double highest = 0;
    for (const noise::Lobe& lobe : lobes)
        highest = std::max(highest, lobe.frequency * (1 + lobe.frequency_spread));
    static double reaches = 0;
    if (!dragging || reaches == 0)
        reaches = std::exp2(std::ceil(2 * std::log2(1.35 * highest)) / 2);
    const Plane plane{{corner.x + side / 2, corner.y + side / 2}, side / 2, reaches};

    bool changed = edit_plane(session, plane, lobes);
    tooltip("The frequency plane, in cycles per kernel radius: the power spectrum, 50 dB from dark to "
            "bright, and the lobes. Drag a lobe to move it, double-click to add one, press Delete to "
            "remove one.");
    if (!ImGui::GetIO().WantTextInput && pressed(GLFW_KEY_DELETE))
        changed |= remove_lobe(session, lobes);

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(corner, {corner.x + side, corner.y + side}, true);
    draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, IM_COL32(8, 9, 11, 255));
    draw_power(draw, plane, lobes);
    draw_scale(draw, plane);
    for (std::size_t i = 0; i < lobes.size(); ++i)
        draw_lobe(draw, plane, lobes[i], i == session.selected_lobe);
    draw.PopClipRect();

    ImGui::SameLine();
    changed |= lobe_list(session, lobes);
    if (session.selected_lobe < lobes.size())
        changed |= lobe_sliders(session.document(), lobes[session.selected_lobe], lobes.size() > 1);
    if (changed)
        attempt(session, [&] { set_parameter(session.document(), "lobes", lobes); });
}

} // namespace gabor::viewer
