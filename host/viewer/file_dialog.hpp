#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gabor::viewer {

struct Session;

/// A dialog that asks for a file: a list of a folder, and a field for the name.
struct FileDialog {
    std::string title;
    std::string action;               ///< label of the button
    std::vector<std::string> endings; ///< extensions of the files that are listed, in lower case
    std::filesystem::path folder = {};
    std::string name = {};                        ///< text of the field
    std::function<void(const std::string&)> take; ///< called with the chosen path
    bool folder_wanted = false;                   ///< whether an empty name chooses the folder

    std::filesystem::path listed = {}; ///< folder of the two lists below
    std::vector<std::string> folders = {};
    std::vector<std::string> files = {};
};

/// Each opens a dialog for one purpose.
void ask_for_file(Session& session);
void ask_for_photograph(Session& session);
void ask_for_paint(Session& session);
void ask_where_to_save(Session& session);
void ask_where_to_export(Session& session);

/// Enters the folder named in the field, or chooses the file.
void answer_dialog(Session& session);
/// Also cancels closing, which may have asked for a name to save.
void cancel_dialog(Session& session);

/// Draws the dialog. Call it after drawing all other windows.
void dialog_window(Session& session);

} // namespace gabor::viewer
