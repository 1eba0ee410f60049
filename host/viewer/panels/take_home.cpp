#include "viewer/panels.hpp"

#include "render/presets.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace gabor::viewer {

void take_home_panel(Session& session) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = (width - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ImGui::Button("Copy GLSL", {width, 0}))
        copy_glsl(session);
    tip("Ctrl C: a function that draws this view with gabor_noise.glsl, on the clipboard");

    if (ImGui::BeginCombo("begin with", "a preset")) {
        for (const render::Preset& preset : render::presets()) {
            const std::string name(preset.name);
            if (ImGui::Selectable(name.c_str())) {
                open_preset(session, name);
                session.preset = name + ".json";
            }
        }
        ImGui::EndCombo();
    }
    tip("What the program knows: the paper's figure 6, and materials");
    ImGui::InputText("preset", &session.preset);
    tip("A JSON file of parameters, which gabor render takes too, or an EXR that it rendered. Files can be "
        "dropped "
        "on the window.");
    if (ImGui::Button("Open", {half, 0}))
        open_preset(session, session.preset);
    tip("Ctrl O");
    ImGui::SameLine();
    if (ImGui::Button("Save", {half, 0}))
        save_preset(session, session.preset);
    tip("Ctrl S");

    render::Picture& picture = session.document().picture;
    int size[] = {picture.width, picture.height};
    if (ImGui::InputInt2("size", size)) {
        picture.width = std::clamp(size[0], 1, render::largest_side);
        picture.height = std::clamp(size[1], 1, render::largest_side);
    }
    tip("Of the exported picture, in pixels, up to 65536 x 65536");
    ImGui::InputText("file", &session.plan.path);
    tip("The EXR to write, 32-bit float, its parameters in the header");
    ImGui::Checkbox("PNG beside it", &session.plan.png);
    if (session.exporter.running()) {
        ImGui::ProgressBar(static_cast<float>(session.exporter.progress()), {half, 0});
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {half, 0}))
            session.exporter.cancel();
    } else if (ImGui::Button("Export", {width, 0})) {
        start_export(session);
    }
    tip("Ctrl E: rendered beside the window by the code of gabor render");
    if (const std::string result = session.exporter.result(); !result.empty())
        ImGui::TextWrapped("%s", result.c_str());
}

} // namespace gabor::viewer
