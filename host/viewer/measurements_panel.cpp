#include "viewer/panels.hpp"

#include "statistics/estimate.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gabor::viewer {

namespace {

ImU32 pane_colour(std::size_t pane, float alpha) {
    const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    const ImVec4 other{0.45f, 0.72f, 0.90f, 1};
    ImVec4 colour = pane == 0 ? accent : other;
    colour.w = alpha;
    return ImGui::GetColorU32(colour);
}

// The histograms of both panes, and the normal curve that they should follow.
void histogram(const std::vector<PaneReport>& panes) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 6 * ImGui::GetTextLineHeight()};
    ImGui::InvisibleButton("histogram", size);
    tooltip(
        "Values at random points of independent instances, in standard deviations; the line is the normal "
        "distribution");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    constexpr double highest = 0.5; // of the density shown
    const auto place = [&](double value, double density) {
        return ImVec2(at.x + size.x * static_cast<float>((value / histogram_end + 1) / 2),
                      at.y + size.y * static_cast<float>(1 - std::min(density / highest, 1.0)));
    };
    constexpr double bar = 2 * histogram_end / histogram_bars;
    for (std::size_t pane = 0; pane < panes.size(); ++pane) {
        const Measurements& measured = panes[pane].measured;
        const auto count = static_cast<double>(measured.moments.count());
        if (count == 0)
            continue;
        for (int i = 0; i < histogram_bars; ++i) {
            const double density =
                static_cast<double>(measured.histogram[static_cast<std::size_t>(i)]) / (count * bar);
            const double left = -histogram_end + i * bar;
            const ImVec2 top = place(left, density);
            const ImVec2 bottom = place(left + bar, 0);
            if (pane == 0)
                draw.AddRectFilled(top, {bottom.x - 1, bottom.y}, pane_colour(pane, 0.45f));
            else
                draw.AddLine(top, {bottom.x, top.y}, pane_colour(pane, 1), 1.5f);
        }
    }
    std::array<ImVec2, 97> curve;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double x = histogram_end * (2.0 * static_cast<double>(i) / (curve.size() - 1) - 1);
        curve[i] = place(x, std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi));
    }
    draw.AddPolyline(curve.data(), static_cast<int>(curve.size()), ImGui::GetColorU32(ImGuiCol_Text), 0,
                     1.2f);
}

void row(const char* name, const char* meaning, const std::vector<PaneReport>& panes,
         const std::function<std::string(const PaneReport&)>& value) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    tooltip(meaning);
    for (std::size_t pane = 0; pane < panes.size(); ++pane) {
        ImGui::TableNextColumn();
        const std::string text = value(panes[pane]);
        ImGui::TextUnformatted(text.c_str());
        tooltip(meaning);
    }
}

std::string samples(std::uint64_t count) {
    return count < 1'000'000 ? fmt::format("{} k", count / 1000)
                             : fmt::format("{:.1f} M", static_cast<double>(count) * 1e-6);
}

} // namespace

void measurements_panel(Session& session) {
    const std::vector<PaneReport>& panes = session.panes;
    if (panes.empty())
        return;
    histogram(panes);
    if (!ImGui::BeginTable("measured", static_cast<int>(1 + panes.size())))
        return;
    if (panes.size() > 1) {
        ImGui::TableNextColumn();
        for (std::size_t pane = 0; pane < panes.size(); ++pane) {
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, pane_colour(pane, 1));
            ImGui::TextUnformatted(panes[pane].name.substr(0, 18).c_str());
            ImGui::PopStyleColor();
        }
    }
    const auto timed = [](double time, const char* unit) {
        return std::isnan(time) ? std::string("-") : fmt::format("{:.1f} {}", time, unit);
    };
    std::string meaning = "Pasted into a shader, on the device's own clock, as gabor bench times it:";
    for (const PaneReport& pane : panes)
        meaning += fmt::format("\n{}", pane.function.empty() ? "- (it times no such noise)" : pane.function);
    meaning += "\ntimes the number of waves. Not while an export runs.";
    row("per pixel", meaning.c_str(), panes,
        [&](const PaneReport& pane) { return timed(pane.nanoseconds, "ns"); });
    row("frame", "That for a frame of this size", panes,
        [&](const PaneReport& pane) { return timed(pane.milliseconds, "ms"); });
    row("visits", "Impulses, or nodes of the lattice, that each pixel visits, of all lobes", panes,
        [](const PaneReport& pane) { return pane.visits; });
    const auto known = [](const PaneReport& pane) { return pane.measured.moments.count() > 0; };
    row("mean", "Of the samples; 0 is exact", panes, [&](const PaneReport& pane) {
        return known(pane) ? fmt::format("{:+.4f}", pane.measured.moments.mean()) : "-";
    });
    row("variance", "Of the samples; 1 is exact", panes, [&](const PaneReport& pane) {
        return known(pane) ? fmt::format("{:.4f}", pane.measured.moments.variance()) : "-";
    });
    row("cvm",
        "How far the values are from a normal distribution: the Cramer-von Mises index at 2^18 samples, with "
        "its "
        "95 % interval. 0.5 is where one stops to see it, 0 is perfect.",
        panes, [&](const PaneReport& pane) {
            const statistics::Estimate& cvm = pane.measured.cvm;
            return known(pane) ? fmt::format("{:.2f} +-{:.2f}", cvm.value, (cvm.high - cvm.low) / 2) : "-";
        });
    row("samples", "Values measured so far, at random points of independent instances", panes,
        [](const PaneReport& pane) { return samples(pane.measured.moments.count()); });
    ImGui::EndTable();
    ImGui::Checkbox("frame rate and latency", &session.metered);
    tooltip("M: in the view, while the window draws without a rest");
}

} // namespace gabor::viewer
