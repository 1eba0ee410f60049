#include "viewer/panels.hpp"

#include "viewer/slider.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

namespace gabor::viewer {

namespace {

constexpr std::array exports{"a picture", "an animation", "a texture"}; ///< in the order of ExportAs
constexpr std::array tips{
    "An EXR, 32-bit float, its parameters in the header",
    "NAME.0001.exr and on: frames of one period of time, which begins again after the last",
    "A mip-mapped EXR in tiles, for renderers: each level as the filter sees it. Sides are "
    "powers of two."};

void choose_kind(ExportTarget& target) {
    const auto now = static_cast<std::size_t>(target.as);
    if (ImGui::BeginCombo("as", exports.at(now))) {
        for (std::size_t i = 0; i < exports.size(); ++i) {
            if (ImGui::Selectable(exports.at(i), i == now))
                target.as = static_cast<ExportAs>(i);
            tooltip(tips.at(i));
        }
        ImGui::EndCombo();
    }
    tooltip(tips.at(now));
    if (target.as == ExportAs::frames) {
        slider("frames", target.frames, 2, 240, "%d");
        target.frames = std::clamp(target.frames, 1, render::most_frames);
    }
    if (target.as == ExportAs::texture)
        ImGui::Checkbox("16-bit floats", &target.half);
    explained(target.as == ExportAs::texture ? "A texture is an EXR" : "", "What the window shows of it",
              [&] { ImGui::Checkbox("PNG beside it", &target.png); });
}

} // namespace

void export_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = (width - ImGui::GetStyle().ItemSpacing.x) / 2;
    other_parameters(session);
    choose_kind(session.export_target);
    ImGui::InputText("file", &session.export_target.path);
    tooltip("The EXR to write; of an animation NAME.exr for NAME.0001.exr and on");
    if (session.exporter.running()) {
        ImGui::ProgressBar(static_cast<float>(session.exporter.progress()), {half, 0});
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {half, 0}))
            session.exporter.cancel();
    } else {
        if (ImGui::Button("Export", {half, 0}))
            start_export(session);
        tooltip("Ctrl E: rendered in the background by the code of gabor render");
        ImGui::SameLine();
        if (ImGui::Button("Export as...", {half, 0}))
            ask_where_to_export(session);
    }
    if (const std::string result = session.exporter.result(); !result.empty())
        ImGui::TextWrapped("%s", result.c_str());
}

} // namespace gabor::viewer
