#pragma once

#include "viewer/file_dialog.hpp"

#include <optional>
#include <string>

namespace gabor::viewer {

/// The desktop's own file dialog, run as a process: zenity or kdialog, one of which most desktops have.
class DesktopDialog {
  public:
    DesktopDialog() = default;
    ~DesktopDialog(); ///< closes it
    DesktopDialog(const DesktopDialog&) = delete;
    DesktopDialog& operator=(const DesktopDialog&) = delete;

    /// Opens it. Returns false outside a desktop, or if neither program is installed.
    bool open(const FileDialog& dialog);
    bool is_open() const { return process_ > 0; }
    /// Polls the last dialog; call in each frame. Returns the chosen path, empty if the user cancelled;
    /// nothing while the dialog is open or if it failed. Once it has ended, `is_open` returns false.
    std::optional<std::string> poll();

  private:
    int process_ = 0; ///< 0 for none
    int pipe_ = -1;   ///< its output
    std::string said_;
};

} // namespace gabor::viewer
