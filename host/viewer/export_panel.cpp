#include "viewer/panels.hpp"

#include "viewer/slider.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace gabor::viewer {

namespace {

constexpr std::string_view exports[]{"a picture", "an animation", "a texture"}; // as in ExportAs
constexpr const char* tips[]{
    "An EXR of 32-bit floats with its parameters in the header",
    "NAME.0001.exr and so on: the frames of one period, which loops",
    "A mip-mapped, tiled EXR for renderers, with each level filtered. Sides must be powers of two."};

void choose_kind(ExportTarget& target) {
    choose("as", target.as, exports, tips);
    if (target.as == ExportAs::frames) {
        slider("frames", target.frames, 2, 240, "%d");
        target.frames = std::clamp(target.frames, 1, render::most_frames);
    }
    if (target.as == ExportAs::texture)
        ImGui::Checkbox("16-bit floats", &target.half);
    explained(target.as == ExportAs::texture ? "A texture is an EXR" : "", "Also write what the window shows",
              [&] { ImGui::Checkbox("PNG beside it", &target.png); });
}

} // namespace

void export_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = (width - ImGui::GetStyle().ItemSpacing.x) / 2;
    other_parameters(session);
    choose_kind(session.export_target);
    ImGui::InputText("file", &session.export_target.path);
    tooltip("The EXR to write; an animation numbers its frames: NAME.0001.exr");
    if (session.exporter.running()) {
        ImGui::ProgressBar(static_cast<float>(session.exporter.progress()), {half, 0});
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {half, 0}))
            session.exporter.cancel();
    } else {
        if (ImGui::Button("Export", {half, 0}))
            start_export(session);
        tooltip("Ctrl E: render in the background, as gabor render does");
        ImGui::SameLine();
        if (ImGui::Button("Export as...", {half, 0}))
            ask_where_to_export(session);
    }
    if (const std::string result = session.exporter.result(); !result.empty())
        ImGui::TextWrapped("%s", result.c_str());
}

} // namespace gabor::viewer
