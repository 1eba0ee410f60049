#include "viewer/panels.hpp"

#include "render/load.hpp"
#include "viewer/preset_pictures.hpp"

#include <imgui.h>

#include <algorithm>

namespace gabor::viewer {

namespace {

constexpr float usual_font = 14; // at this size a pixel of a picture is a unit

} // namespace

GalleryPlace gallery_place(float width, float height) {
    const Extent extent = preset_pictures().extent;
    const auto all_width = static_cast<float>(extent.width);
    const auto all_height = static_cast<float>(extent.height);
    const float scale = std::min({ImGui::GetFontSize() / usual_font, width / all_width, height / all_height});
    return {(width - scale * all_width) / 2, (height - scale * all_height) / 2, scale};
}

void gallery_window(Session& session, float width, float height) {
    if (!session.gallery)
        return;
    const GalleryPlace place = gallery_place(width, height);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("presets", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float margin = place.scale * (PresetPictures::cell - PresetPictures::side) / 2;
    const float side = place.scale * PresetPictures::side;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    std::size_t index = 0;
    for (const render::Preset& preset : render::presets()) {
        const std::string name(preset.name);
        const auto column = static_cast<float>(index % PresetPictures::columns);
        const auto row = static_cast<float>(index / PresetPictures::columns);
        const ImVec2 corner{place.x + place.scale * PresetPictures::cell * column + margin,
                            place.y + place.scale * PresetPictures::cell * row + margin};
        const ImVec2 end{corner.x + side, corner.y + side};
        ImGui::SetCursorScreenPos(corner);
        const bool chosen = ImGui::InvisibleButton(name.c_str(), {side, side});
        tooltip(name);
        draw.AddRect(corner, end,
                     ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Separator), 0,
                     0, 2);
        draw.PushClipRect(corner, end, true);
        label(draw, {corner.x + 2, end.y - ImGui::GetFrameHeight()}, name, text);
        draw.PopClipRect();
        if (chosen) {
            open_preset(session, name);
            session.gallery = false;
        }
        ++index;
    }
    ImGui::End();
}

} // namespace gabor::viewer
