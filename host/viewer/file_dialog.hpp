#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gabor::viewer {

struct Session;

/// A question for a file: a folder's contents, those of late, and a field for the name.
struct FileDialog {
    std::string title;
    std::string action;               ///< on its button
    std::vector<std::string> endings; ///< of the files that are listed, in small letters
    std::filesystem::path folder = {};
    std::string name = {};                        ///< in the field
    std::function<void(const std::string&)> take; ///< what is done with the path
    bool recent = false;                          ///< lists what was opened or saved lately too

    std::filesystem::path listed = {}; ///< the folder whose contents these are
    std::vector<std::string> folders = {};
    std::vector<std::string> files = {};
};

/// Asks for what to open, save and export.
void ask_for_file(Session& session);
void ask_for_photograph(Session& session);
void ask_for_paint(Session& session);
void ask_where_to_save(Session& session);
void ask_where_to_export(Session& session);

/// Does what the dialog is for: opens the folder that its field names, or takes the file.
void answer_dialog(Session& session);

/// Draws the dialog where one is open, after all other windows.
void dialog_window(Session& session);

} // namespace gabor::viewer
