#include "viewer/file_dialog.hpp"

#include "system/desktop.hpp"
#include "viewer/photograph.hpp"
#include "viewer/session.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace gabor::viewer {

namespace {

void ask(Session& session, FileDialog dialog, const std::filesystem::path& beside) {
    std::error_code unknown;
    dialog.folder = std::filesystem::absolute(beside, unknown).parent_path();
    if (!std::filesystem::is_directory(dialog.folder, unknown))
        dialog.folder = std::filesystem::current_path(unknown);
    session.message = {};
    session.dialog = std::move(dialog);
}

// Asks for a file with one of these endings, a photograph, or an EXR, which may be either.
void ask_to_open(Session& session, const char* title, std::vector<std::string> endings,
                 const std::filesystem::path& beside) {
    endings.emplace_back(".exr");
    endings.insert(endings.end(), photograph_endings.begin(), photograph_endings.end());
    ask(session,
        {.title = title,
         .action = "Open",
         .endings = std::move(endings),
         .take = [&session](const std::string& path) { open_file(session, path); }},
        beside);
}

// Reads the folder. If that fails, shows an empty list and a message.
void list(Session& session, FileDialog& dialog) {
    dialog.listed = dialog.folder;
    dialog.folders.clear();
    dialog.files.clear();
    std::error_code unknown;
    for (const auto& entry : std::filesystem::directory_iterator(dialog.folder, unknown)) {
        std::error_code hidden;
        const std::string name = entry.path().filename().string();
        if (name.starts_with('.'))
            continue;
        if (entry.is_directory(hidden))
            dialog.folders.push_back(name);
        else if (std::ranges::find(dialog.endings, lower_extension(name)) != dialog.endings.end())
            dialog.files.push_back(name);
    }
    if (unknown)
        notify(session, dialog.folder.string() + ": " + unknown.message(), true);
    std::ranges::sort(dialog.folders);
    std::ranges::sort(dialog.files);
}

// Draws the list of files. Returns whether an entry was double-clicked.
bool contents(FileDialog& dialog) {
    bool twice = false;
    const auto entry = [&](const std::string& shown, const std::string& name) {
        if (ImGui::Selectable(shown.c_str(), name == dialog.name, ImGuiSelectableFlags_AllowDoubleClick)) {
            dialog.name = name;
            twice = ImGui::IsMouseDoubleClicked(0);
        }
    };
    entry("..", "..");
    if (dialog.folder == dialog.folder.root_path())
        for (const std::string& drive : system::drives())
            entry(drive, drive);
    for (const std::string& name : dialog.folders)
        entry(name + "/", name);
    for (const std::string& name : dialog.files)
        entry(name, name);
    return twice;
}

} // namespace

void ask_for_file(Session& session) {
    ask_to_open(session, "Open", {".json"}, session.document().path);
}

void ask_for_photograph(Session& session) {
    ask_to_open(session, "Fit a noise to a photograph", {},
                session.fitter.path().empty() ? session.document().path : session.fitter.path());
}

void ask_for_paint(Session& session) {
    ask(session,
        {.title = "A map of directions: red and green point along the waves",
         .action = "Open",
         .endings = {".png", ".jpg", ".jpeg", ".tga", ".tif", ".tiff", ".exr"},
         .take =
             [&session](const std::string& path) {
                 attempt(session, [&] { set_parameter(session.document(), "paint", path); });
             }},
        session.document().path);
}

void ask_where_to_save(Session& session) {
    ask(session,
        {.title = "Save as a preset",
         .action = "Save",
         .endings = {".json"},
         .name = std::filesystem::path(session.document().path).filename().string(),
         .take =
             [&session](const std::string& path) {
                 session.document().path = path;
                 write_preset(session);
             }},
        session.document().path);
}

void ask_where_to_export(Session& session) {
    const ExportTarget target = session.export_target.of(session.document());
    const bool maps = target.as == ExportAs::maps;
    ask(session,
        {.title = maps ? "Export maps to a folder" : "Export to a file",
         .action = "Export",
         .endings = maps ? std::vector<std::string>{} : std::vector<std::string>{".exr"},
         .name = std::filesystem::path(target.name()).filename().string(),
         .take =
             [&session, maps](const std::string& path) {
                 (maps ? session.export_target.folder : session.export_target.path) = path;
                 start_export(session);
             },
         .folder_wanted = maps},
        target.name());
}

void answer_dialog(Session& session) {
    FileDialog& dialog = *session.dialog;
    if (dialog.name.empty() && !dialog.folder_wanted)
        return;
    const std::filesystem::path path = (dialog.folder / dialog.name).lexically_normal();
    std::error_code unknown;
    if (!dialog.name.empty() && std::filesystem::is_directory(path, unknown)) {
        dialog.folder = path.has_filename() ? path : path.parent_path();
        dialog.name.clear();
        return;
    }
    const FileDialog answered = *std::exchange(session.dialog, {});
    answered.take(path.string());
}

void cancel_dialog(Session& session) {
    session.dialog.reset();
    session.closing = Closing::no;
}

void dialog_window(Session& session) {
    constexpr const char* id = "###file dialog";
    if (session.dialog && !ImGui::IsPopupOpen(id))
        ImGui::OpenPopup(id);
    const float em = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(44 * em, room.x - em), std::min(34 * em, room.y - em)});
    const std::string title = (session.dialog ? session.dialog->title : "") + id;
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    if (!session.dialog) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    FileDialog& dialog = *session.dialog;
    if (dialog.listed != dialog.folder)
        list(session, dialog);
    ImGui::TextUnformatted(dialog.folder.string().c_str());
    ImGui::BeginChild("contents", {0, -ImGui::GetFrameHeightWithSpacing()}, true);
    const bool twice = contents(dialog);
    ImGui::EndChild();
    if (ImGui::IsWindowAppearing())
        ImGui::SetKeyboardFocusHere();
    const float buttons = 8 * em;
    ImGui::SetNextItemWidth(-buttons * 2 - 2 * ImGui::GetStyle().ItemSpacing.x);
    const bool entered = ImGui::InputText(
        "##name", &dialog.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (entered) // keep the focus for the next name after entering a folder
        ImGui::SetKeyboardFocusHere(-1);
    ImGui::SameLine();
    const bool taken = ImGui::Button(dialog.action.c_str(), {buttons, 0});
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {buttons, 0}))
        cancel_dialog(session);
    else if (entered || taken || twice)
        answer_dialog(session);
    ImGui::EndPopup();
}

} // namespace gabor::viewer
