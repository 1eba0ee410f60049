#include "viewer/panels.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

namespace gabor::viewer {

namespace {

struct ShortCut {
    const char* key;
    const char* does;
};

constexpr std::array short_cuts{
    ShortCut{"drag", "move the plane, endlessly, or turn the body"},
    ShortCut{"wheel", "zoom about the pointer"},
    ShortCut{"double click", "back to where gabor render begins (Home)"},
    ShortCut{"arrows, + and -", "the same from the keyboard"},
    ShortCut{"1 to 5", "show value, gradient, phase, intensity, variance"},
    ShortCut{"V", "the next view: plane, plane in perspective, sphere, torus"},
    ShortCut{"F", "filtering on and off"},
    ShortCut{"C", "the next colour map"},
    ShortCut{"R", "the next recipe"},
    ShortCut{"N", "the next seed"},
    ShortCut{"Tab", "split view; its divider can be dragged"},
    ShortCut{"Space", "play time, in a loop"},
    ShortCut{"Ctrl Z, Ctrl Y", "undo, redo"},
    ShortCut{"Ctrl O, Ctrl S", "open and save the preset"},
    ShortCut{"Ctrl C", "copy the GLSL of this view"},
    ShortCut{"Ctrl E", "export EXR and PNG"},
    ShortCut{"F11 or H", "hide and show the panels"},
    ShortCut{"F1", "this page"},
    ShortCut{"Ctrl Q", "quit"},
};

} // namespace

void help_window(Session& session) {
    if (!session.help)
        return;
    const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    if (ImGui::Begin("Help", &session.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const ShortCut& cut : short_cuts) {
                ImGui::TableNextColumn();
                ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", cut.key);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(cut.does);
            }
            ImGui::EndTable();
        }
        ImGui::Separator();
        ImGui::TextUnformatted(
            "Ctrl and a click on a slider lets you type. Hold the pointer over anything to\n"
            "read what it is. Drag a lobe in the drawing of the frequency plane.\n"
            "Shaders are read again whenever one is saved; the last good picture stays.");
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

namespace {

void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = ImGui::GetStyle().FramePadding.x;
    draw.AddRectFilled({at.x, at.y}, {at.x + size.x + 2 * pad, at.y + size.y + pad},
                       IM_COL32(12, 13, 15, 200), ImGui::GetStyle().FrameRounding);
    draw.AddText({at.x + pad, at.y + pad / 2}, colour, text.c_str());
}

} // namespace

void overlay(const Session& session, float width, float height) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float line = ImGui::GetFrameHeight() + 4;
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const bool split = session.sides.size() > 1;
    for (std::size_t i = 0; split && i < session.sides.size(); ++i) {
        const Side& side = session.sides[i];
        const float left = i == 0 ? 0 : width * session.divider;
        label(draw, {left + margin, margin},
              fmt::format("{}   {:.1f} ns per pixel   {:.0f} impulses", side.name, side.nanoseconds,
                          side.visited),
              text);
        if (i == 1) {
            draw.AddLine({left, 0}, {left, height}, IM_COL32(12, 13, 15, 255), 3);
            const double times = side.nanoseconds / session.sides[0].nanoseconds;
            label(draw, {left + margin, margin + line},
                  times >= 1 ? fmt::format("takes {:.1f} times as long", times)
                             : fmt::format("takes {:.2f} of the time", times),
                  ImGui::GetColorU32(ImGuiCol_CheckMark));
        }
    }
    if (!session.note.empty() && ImGui::GetTime() < session.note_until)
        label(draw, {margin, height - line - margin}, session.note, text);
    if (!session.shader_error.empty())
        label(draw, {margin, height - 2 * line - margin}, session.shader_error, IM_COL32(255, 120, 100, 255));
}

void tip(const char* text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(text);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

} // namespace gabor::viewer
