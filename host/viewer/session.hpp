#pragma once

#include "viewer/document.hpp"
#include "viewer/export.hpp"
#include "viewer/measure.hpp"

#include <string>
#include <vector>

namespace gabor::viewer {

/// One side of the view, as panels tell of it.
struct Side {
    std::string name;
    double visited = 0;      ///< impulses for each pixel
    double milliseconds = 0; ///< of a frame of the view's size in full resolution
    double nanoseconds = 0;  ///< per pixel
    int stride = 1;          ///< pixels per value just now
    Measured measured;
};

/// Where an export goes.
struct ExportPlan {
    std::string path = "noise.exr"; ///< a PNG goes beside it
    bool png = true;
};

/// All that panels, short cuts and scripts see and change.
struct Session {
    explicit Session(Document document, std::string device)
        : history(std::move(document)), exporter(std::move(device)) {}

    History history;
    std::vector<Side> sides; ///< one, or two in the split view
    Extent view;             ///< of one side, in pixels
    Exporter exporter;
    ExportPlan plan;
    std::string preset = "noise.json";
    std::size_t lobe = 0; ///< that is chosen
    bool playing = false;
    float period = 8; ///< seconds for time to go by 1
    bool panels = true;
    bool help = false;
    float divider = 0.5f; ///< where the split view is split
    std::string shader_error;
    std::string note; ///< shown for a while
    double note_until = 0;

    Document& document() { return history.now; }
};

/// What short cuts, buttons and scripts do. Failures become notes.
void open_preset(Session& session, const std::string& path);
void save_preset(Session& session, const std::string& path);
void copy_glsl(Session& session);
void start_export(Session& session);
void go_home(Session& session);
void say(Session& session, std::string note);

/// The parameters in a JSON file, in an EXR that gabor rendered, or of a preset by its name. Throws
/// RequestError where there are none.
render::Picture read_preset(const std::string& path);

} // namespace gabor::viewer
