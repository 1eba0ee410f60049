#pragma once

#include "viewer/document.hpp"
#include "viewer/export.hpp"
#include "viewer/file_dialog.hpp"
#include "viewer/fitting.hpp"
#include "viewer/frame_meter.hpp"
#include "viewer/measurements.hpp"
#include "viewer/preset_pictures.hpp"
#include "viewer/tiling.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gabor::viewer {

/// A line shown in the view for some seconds.
struct Message {
    std::string text;
    bool error = false;
    double until = 0; ///< on Dear ImGui's clock
};

/// A question that must be answered before anything else is done.
struct Question {
    struct Answer {
        std::string label;
        std::function<void()> act;
        int key = 0; ///< a letter; the first answer has Enter too
    };

    std::string text;
    std::vector<Answer> answers; ///< beside Cancel, which does nothing
};

/// How far the end of the program has come.
enum class Closing { no, asked, after_export, now };

/// All that panels, shortcuts and tests see and change.
struct Session {
    explicit Session(const Document& document, std::string device)
        : history(document), exporter(device), kept(document), preset_pictures(std::move(device)) {}

    History history;
    Measurements measured;
    Extent view;                  ///< in pixels
    bool tiles = false;           ///< whether tileable pictures are shown two by two
    std::optional<Tiling> tiling; ///< where they are
    Exporter exporter;
    ExportTarget export_target;
    std::string preset_path = "noise.json"; ///< what is opened and saved
    Document kept;                          ///< as it was opened, saved or begun with
    std::vector<std::string> recent;        ///< what was opened or saved, the last one first
    /// Files that this session wrote: only they are overwritten without a question.
    std::map<std::filesystem::path, FileStamp> written;
    std::optional<Question> question;
    std::optional<FileDialog> dialog;
    Fitter fitter;
    std::optional<FittedPreset> fitted; ///< to the photograph of that path
    std::string fitted_path;
    bool photograph_beside = true; ///< the noise, where there is one
    bool gallery = false;          ///< the presets as pictures, in place of the view
    PresetPictures preset_pictures;
    std::size_t selected_lobe = 0;
    bool playing = false;
    static constexpr float default_period = 8;
    float period = default_period; ///< seconds for time to go by 1
    bool panels = true;
    bool full_screen = false;
    bool metered = false; ///< whether the view tells its frame rate and latency
    FrameMeter meter;
    float ui_scale = 1; ///< how much larger panels and text are than the desktop asks for
    bool help = false;
    Closing closing = Closing::no;
    float divider = 0.5f; ///< between a photograph and its noise, as a share of the width
    bool dragging_divider = false;
    Message message;

    Document& document() { return history.now; }
};

/// What shortcuts, buttons and tests do. Failures become messages.
/// Opens a preset, or a photograph, to which a noise is fitted.
void open_file(Session& session, const std::string& path);
void open_preset(Session& session, const std::string& path);
/// Writes the parameters to `preset_path` where its name ends in .json, and else to a name made from it that
/// does.
void save_preset(Session& session);
void start_export(Session& session);
void copy_glsl(Session& session);
void reset_camera(Session& session);
/// Puts a file before all others that were opened or saved.
void keep_recent(Session& session, const std::string& path);
/// The end of a file's name from the last dot on, in small letters.
std::string lower_extension(const std::filesystem::path& path);
/// Gives the answer of that number, or cancels.
void answer(Session& session, std::optional<std::size_t> number);
/// Whether a preset would hold something else than the file that was opened or saved last.
bool is_changed(const Session& session);
/// Asks what must be asked before the program ends, and then has it end: for every frame while `closing`.
void go_on_closing(Session& session);
/// What throws becomes a message.
void attempt(Session& session, const std::function<void()>& action);
void notify(Session& session, std::string text, bool error = false);

/// The document in a JSON file, of the parameters of an EXR that gabor rendered, or of a preset by its name.
/// What is not in it is as in `defaults`. Throws RequestError where there is none, or its paint is not there.
Document load_document(const std::string& path, const Document& defaults = {});

} // namespace gabor::viewer
