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

// Draws the histogram of values, and the normal distribution.
void histogram(const Measurements& measured) {
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
    const auto count = static_cast<double>(measured.moments.count());
    for (int i = 0; i < histogram_bars && count > 0; ++i) {
        const double density =
            static_cast<double>(measured.histogram[static_cast<std::size_t>(i)]) / (count * bar);
        const double left = -histogram_end + i * bar;
        const ImVec2 bottom = place(left + bar, 0);
        draw.AddRectFilled(place(left, density), {bottom.x - 1, bottom.y},
                           ImGui::GetColorU32(ImGuiCol_CheckMark, 0.45f));
    }
    std::array<ImVec2, 97> curve;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double x = histogram_end * (2.0 * static_cast<double>(i) / (curve.size() - 1) - 1);
        curve[i] = place(x, std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi));
    }
    draw.AddPolyline(curve.data(), static_cast<int>(curve.size()), ImGui::GetColorU32(ImGuiCol_Text), 0,
                     1.2f);
}

void row(const char* name, const char* meaning, const std::string& value) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    tooltip(meaning);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
    tooltip(meaning);
}

std::string samples(std::uint64_t count) {
    return count < 1'000'000 ? fmt::format("{} k", count / 1000)
                             : fmt::format("{:.1f} M", static_cast<double>(count) * 1e-6);
}

} // namespace

void measurements_panel(Session& session) {
    const Measurements& measured = session.measurer.measured();
    histogram(measured);
    if (!ImGui::BeginTable("measured", 2))
        return;
    const statistics::Moments& moments = measured.moments;
    const bool known = moments.count() > 0;
    row("mean", "0 in theory", known ? fmt::format("{:+.4f}", moments.mean()) : "-");
    row("variance", "1 in theory", known ? fmt::format("{:.4f}", moments.variance()) : "-");
    const statistics::Estimate& cvm = measured.cvm;
    row("cvm",
        "Distance from a normal distribution: the Cramer-von Mises index at 2^18 samples, with its 95 % "
        "interval. Below 0.5 it is invisible.",
        known ? fmt::format("{:.2f} +-{:.2f}", cvm.value, (cvm.high - cvm.low) / 2) : "-");
    row("samples", "Values measured so far, at random points of independent instances",
        samples(moments.count()));
    ImGui::EndTable();
    ImGui::Checkbox("frame rate and latency", &session.metered);
    tooltip("M: show them in the view; the window then draws without pause");
}

} // namespace gabor::viewer
