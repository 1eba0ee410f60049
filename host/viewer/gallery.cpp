#include "viewer/panels.hpp"

#include "image/picture.hpp"
#include "render/load.hpp"
#include "viewer/embedded.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

const PresetPictures& preset_pictures() {
    static const PresetPictures pictures = [] {
        const std::span<const unsigned char> jpeg = embedded("presets.jpg");
        const auto reader = image::open_jpeg(
            "presets.jpg",
            {::fmemopen(const_cast<unsigned char*>(jpeg.data()), jpeg.size(), "rb"), std::fclose});
        PresetPictures all;
        all.extent = {reader->format().width, reader->format().height};
        const std::size_t row = 3 * static_cast<std::size_t>(all.extent.width);
        all.colours.resize(row * static_cast<std::size_t>(all.extent.height));
        for (std::span<float> rest = all.colours; !rest.empty(); rest = rest.subspan(row))
            reader->read_row(rest.first(row));
        return all;
    }();
    return pictures;
}

Gallery gallery_window(Session& session, float width, float height) {
    if (!session.gallery)
        return {};
    const std::span<const render::Preset> presets = render::presets();
    const auto count = static_cast<int>(presets.size());
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x;
    float least = 0; // cell width that the longest name needs
    for (const render::Preset& preset : presets)
        least = std::max(least, ImGui::CalcTextSize(std::string(preset.name).c_str()).x +
                                    style.FramePadding.x / 2 + gap);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("presets", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    // Chooses the largest cells for which all presets are visible. If their names would not fit, the window
    // scrolls.
    const ImVec2 room = ImGui::GetContentRegionAvail();
    float cell = 0;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        cell =
            std::max(cell, std::min(room.x / static_cast<float>(columns), room.y / static_cast<float>(rows)));
    }
    cell = std::floor(std::max(cell, std::min(least, room.x)));
    const int columns = std::max(static_cast<int>(room.x / cell), 1);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float left = origin.x + (room.x - cell * static_cast<float>(columns) + gap) / 2;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    Gallery gallery{cell - gap, {}};
    for (int index = 0; index < count; ++index) {
        const std::string name(presets[static_cast<std::size_t>(index)].name);
        const ImVec2 corner{left + cell * static_cast<float>(index % columns),
                            origin.y + cell * static_cast<float>(index / columns)};
        const ImVec2 end{corner.x + gallery.picture_side, corner.y + gallery.picture_side};
        gallery.corners.push_back(corner);
        ImGui::SetCursorScreenPos(corner);
        const bool chosen =
            ImGui::InvisibleButton(name.c_str(), {gallery.picture_side, gallery.picture_side});
        draw.AddRect(corner, end,
                     ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Separator), 0,
                     0, 2);
        label(draw, {corner.x, end.y - ImGui::GetFontSize() - style.FramePadding.x}, name,
              ImGui::GetColorU32(ImGuiCol_Text));
        if (chosen) {
            open_preset(session, name);
            session.gallery = false;
        }
    }
    ImGui::End();
    return gallery;
}

} // namespace gabor::viewer
