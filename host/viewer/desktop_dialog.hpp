#pragma once

#include "viewer/file_dialog.hpp"

#include <optional>
#include <string>

namespace gabor::viewer {

/// The desktop's own file dialog: zenity or kdialog, which every desktop has one of, as a process.
class DesktopDialog {
  public:
    DesktopDialog() = default;
    ~DesktopDialog(); ///< closes it
    DesktopDialog(const DesktopDialog&) = delete;
    DesktopDialog& operator=(const DesktopDialog&) = delete;

    /// Opens it. Returns false outside a desktop, and where neither program is installed.
    bool open(const FileDialog& dialog);
    bool is_open() const { return process_ > 0; }
    /// Takes the answer of the one opened last, in each frame: when it has ended, `is_open` no longer holds.
    /// Returns the path, empty if the user cancelled; nothing while it is open, and if it failed.
    std::optional<std::string> poll();

  private:
    int process_ = 0; ///< 0 for none
    int pipe_ = -1;   ///< its output
    std::string said_;
};

} // namespace gabor::viewer
