#pragma once

#include "viewer/document.hpp"
#include "viewer/drawing.hpp"
#include "viewer/export.hpp"
#include "viewer/file_dialog.hpp"
#include "viewer/fitting.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::viewer {

/// A line shown over the view for some seconds.
struct Message {
    std::string text;
    bool error = false;
    double until = 0; ///< when to hide it, on Dear ImGui's clock
};

/// A question that blocks everything else until it is answered.
struct Question {
    struct Answer {
        std::string label;
        std::function<void()> act;
        int key = 0; ///< a letter; Enter also gives the first answer
    };

    std::string text;
    std::vector<Answer> answers; ///< Cancel, which does nothing, is added to these
};

enum class Closing { no, asked, after_export, now };

/// Everything that panels, shortcuts and tests see and change.
struct Session {
    explicit Session(const Document& document, std::string device)
        : history(document), saved(document), exporter(std::move(device)) {}

    Document& document() { return history.now; }

    History history;
    Document saved;                  ///< the document as last opened or saved
    std::vector<std::string> recent; ///< files opened or saved, the most recent first
    /// The files that this session wrote. The user is asked before others are overwritten.
    std::map<std::filesystem::path, FileStamp> written;
    std::string exported_from; ///< path of the document that was last exported
    Exporter exporter;
    ExportTarget export_target;
    bool exported = true;         ///< whether the result of the last export has been shown
    bool scrolled_back = true;    ///< whether the panel has scrolled to its top for the new document
    bool exporting_asked = false; ///< whether to open the export section
    Fitter fitter;
    std::optional<FittedPreset> fitted; ///< the last fit, to the photograph `fitted_path`
    std::string fitted_path;
    bool photograph_beside = true; ///< show the photograph beside its noise
    float divider = 0.5f;          ///< between photograph and noise, as a share of the width
    bool dragging_divider = false;
    bool gallery = false; ///< show the presets in place of the view
    std::string search;   ///< words that select presets
    std::size_t selected_lobe = 0;
    std::size_t selected_stop = 0; ///< index in the colour map

    Extent view;        ///< size of the view in pixels
    bool tiles = false; ///< show tileable pictures two by two
    std::optional<Tiling> tiling;
    bool playing = false;
    static constexpr float default_period = 8;
    float period = default_period; ///< seconds that the evolution takes to go from 0 to 1
    bool panels = true;
    bool full_screen = false;
    bool help = false;
    float ui_scale = 1;  ///< size of panels and text, relative to the desktop's
    std::string reading; ///< describes the pixel under the pointer; empty for none

    std::optional<Question> question;
    std::optional<FileDialog> dialog;
    Message message;
    Closing closing = Closing::no;
};

// Actions of shortcuts, buttons and tests. Failures become messages.

/// Opens a preset, or fits a noise to a photograph.
void open_file(Session& session, const std::string& path);
void open_preset(Session& session, const std::string& path);
/// Opens a document that has no file, under this name.
void open_document(Session& session, Document document, const std::string& path);
/// Names the next export after the document, and scrolls the panel to its top.
void reset_panel(Session& session);
/// Tells whether Save writes to a file that the document was read from or saved to before.
bool has_file(const Document& document);
/// Saves the document to its file, or asks for a name if it has none.
void save_preset(Session& session);
/// Saves the document to its path, with the extension .json.
void write_preset(Session& session);
void start_export(Session& session);
/// Asks whether to export, and says which files that would write.
void ask_about_export(Session& session);
/// Shows the result of an export that has ended. Call it in each frame.
void poll_exporter(Session& session);
void copy_glsl(Session& session);
void reset_camera(Session& session);
/// Moves or adds a file to the top of the list of recent files.
void add_recent(Session& session, const std::string& path);
/// A file's extension in lower case, with its dot.
std::string lower_extension(const std::filesystem::path& path);
/// Answers the question with the choice of that index, or cancels the question.
void answer(Session& session, std::optional<std::size_t> number);
/// Whether saving would write anything new.
bool is_changed(const Session& session);
/// Asks about unsaved changes and exports, then quits. Call it in each frame while `closing` is set.
void continue_closing(Session& session);
/// Runs an action; its exceptions become messages.
void attempt(Session& session, const std::function<void()>& action);
void notify(Session& session, std::string text, bool error = false);
/// Hides the message after a few seconds, even the result of an export. Called when the user does something.
void hide_message_soon(Session& session);
/// The texts on the screen that contain file names, which may be in any script.
std::vector<std::string> file_names(const Session& session);

/// Reads a document from a JSON file, from an EXR that gabor rendered, or from a preset's name. `defaults` is
/// as for document_from_json. Throws RequestError if there is no such document or its paint is missing.
Document load_document(const std::string& path, const Document& defaults = {});

} // namespace gabor::viewer
