#include "viewer/overlays.hpp"

#include "viewer/widgets.hpp"

#include <fmt/format.h>

namespace gabor::viewer {

void view_overlay(const Session& session, double refining) {
    constexpr double soon = 0.4; // seconds
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    if (session.tiling)
        label(draw, {margin, margin},
              fmt::format("2 x 2 tiles at {:.0f} %", 100 * session.tiling->camera.zoom), text);
    else if (const double zoom = session.history.now.camera.zoom; zoom != 1)
        label(draw, {margin, margin}, fmt::format("view at {:.0f} %", 100 * zoom), text);
    if (refining > soon)
        label(draw, {margin, 2 * margin + ImGui::GetFontSize()}, "refining", text);
}

void reading_overlay(const Session& session, float width) {
    if (session.reading.empty())
        return;
    const float margin = ImGui::GetStyle().WindowPadding.x; // below the label of a photograph's noise
    label(*ImGui::GetBackgroundDrawList(),
          {width - 9.5f * ImGui::GetFontSize(), 2 * margin + ImGui::GetFontSize()}, session.reading,
          ImGui::GetColorU32(ImGuiCol_Text));
}

void message_overlay(const Session& session, float width, float height) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float left = style.WindowPadding.x;
    const float wrap = width - 2 * (left + style.FramePadding.x);
    float bottom = height - style.WindowPadding.y;
    const auto say = [&](const std::string& what, ImU32 colour) {
        bottom -= ImGui::CalcTextSize(what.c_str(), nullptr, false, wrap).y + style.FramePadding.x;
        label(*ImGui::GetForegroundDrawList(), {left, bottom}, what, colour, wrap);
        bottom -= style.ItemSpacing.y;
    };
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    if (const Message& message = session.message; ImGui::GetTime() < message.until)
        say(message.text, message.error ? IM_COL32(255, 120, 100, 255) : text);
    if (session.exporter.running())
        say(fmt::format("exporting: {:.0f} %{}", 100 * session.exporter.progress(),
                        session.closing == Closing::after_export ? ", then closing" : ""),
            text);
    if (session.fitter.running())
        say(fmt::format("fitting a noise: {:.0f} %", 100 * session.fitter.progress()), text);
}

void question_window(Session& session) {
    constexpr const char* title = "Please confirm";
    if (session.question && !ImGui::IsPopupOpen(title))
        ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
        return;
    if (session.question) {
        ImGui::TextUnformatted(session.question->text.c_str());
        std::optional<std::size_t> chosen;
        for (std::size_t i = 0; i < session.question->answers.size(); ++i) {
            const Question::Answer& each = session.question->answers[i];
            const std::string key = i == 0 ? "Enter" : std::string(1, static_cast<char>(each.key));
            if (ImGui::Button(fmt::format("{} ({})", each.label, key).c_str()))
                chosen = i;
            ImGui::SameLine();
        }
        if (ImGui::Button("Cancel (Esc)"))
            answer(session, {});
        else if (chosen)
            answer(session, chosen);
    }
    if (!session.question)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

} // namespace gabor::viewer
