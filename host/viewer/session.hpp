#pragma once

#include "viewer/document.hpp"
#include "viewer/export.hpp"
#include "viewer/measurements.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gabor::viewer {

/// What panels tell of one pane of the view: the picture's, or in the split view the compared noise's.
struct PaneReport {
    std::string name;
    double visited = 0;      ///< impulses for each pixel
    double milliseconds = 0; ///< of a frame of the pane's size in full resolution
    double nanoseconds = 0;  ///< per pixel
    Measurements measured;
};

/// Where an export goes.
struct ExportTarget {
    std::string path = "noise.exr"; ///< a PNG goes beside it
    bool png = true;
};

/// A line shown in the view for some seconds.
struct Message {
    std::string text;
    bool error = false;
    double until = 0; ///< on Dear ImGui's clock
};

/// A question that must be answered before anything else is done.
struct Question {
    std::string text;
    std::string accept; ///< label of the button that says yes
    std::function<void()> accepted;
};

/// All that panels, shortcuts and tests see and change.
struct Session {
    explicit Session(Document document, std::string device)
        : history(std::move(document)), exporter(std::move(device)) {}

    History history;
    std::vector<PaneReport> panes; ///< one, or two in the split view
    Extent view;                   ///< of the first pane, in pixels
    Exporter exporter;
    ExportTarget export_target;
    std::string preset_path = "noise.json"; ///< what is opened and saved
    /// Files that this session wrote: only they are overwritten without a question.
    std::map<std::filesystem::path, FileStamp> written;
    std::optional<Question> question;
    std::size_t selected_lobe = 0;
    bool playing = false;
    float period = 8; ///< seconds for time to go by 1
    bool panels = true;
    bool help = false;
    bool closing = false;
    float divider = 0.5f; ///< between the panes, as a share of the width
    bool dragging_divider = false;
    std::string shader_error;
    Message message;

    Document& document() { return history.now; }
};

/// What shortcuts, buttons and tests do. Failures become messages.
void open_preset(Session& session, const std::string& path);
/// Writes the parameters to `preset_path` where its name ends in .json, and else to a name made from it that
/// does.
void save_preset(Session& session);
void start_export(Session& session);
void copy_glsl(Session& session);
void reset_camera(Session& session);
void answer(Session& session, bool accept);
/// What throws becomes a message.
void attempt(Session& session, const std::function<void()>& action);
void notify(Session& session, std::string text, bool error = false);

/// The parameters in a JSON file, in an EXR that gabor rendered, or of a preset by its name. Throws
/// RequestError where there are none.
render::Request load_preset(const std::string& path);

} // namespace gabor::viewer
