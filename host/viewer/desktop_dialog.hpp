#pragma once

#include "viewer/file_dialog.hpp"

#include <optional>
#include <string>

namespace gabor::viewer {

/// The desktop's own file dialog, run as a process: zenity or kdialog, one of which most desktops have.
class DesktopDialog {
  public:
    DesktopDialog() = default;
    ~DesktopDialog(); ///< closes the dialog
    DesktopDialog(const DesktopDialog&) = delete;
    DesktopDialog& operator=(const DesktopDialog&) = delete;

    /// Opens a dialog. Returns false outside a desktop, or if neither program is installed.
    bool open(const FileDialog& dialog);
    bool is_open() const { return process_ > 0; }
    /// Polls the last dialog; call it every frame. Returns the chosen path, which is empty if the user
    /// cancelled, or nothing while the dialog is open or if it failed. Once it has ended, `is_open` returns
    /// false.
    std::optional<std::string> poll();

  private:
    int process_ = 0; ///< 0 for none
    int pipe_ = -1;   ///< the process's output
    std::string said_;
};

} // namespace gabor::viewer
