#include "viewer/session.hpp"
#include "viewer/document_json.hpp"
#include "viewer/photograph.hpp"
#include "viewer/snippet.hpp"

#include "error.hpp"
#include "image/output_file.hpp"
#include "render/request/load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>
#include <utility>

namespace gabor::viewer {

namespace {

constexpr double message_seconds = 5;

// Returns the file to which a document read from `path` is saved.
std::filesystem::path json_path(std::filesystem::path path) {
    const std::string extension = lower_extension(path);
    if (extension == ".exr")
        return path.replace_extension(".json");
    return extension == ".json" ? path : path += ".json";
}

// Calls `write`, but asks first if that would overwrite a file that this session did not write. If the files
// do not `belong` to the document, asks before overwriting any file.
void overwrite(Session& session, const std::vector<std::filesystem::path>& paths, bool belong,
               std::function<void()> write) {
    std::vector<std::string> foreign;
    for (const std::filesystem::path& path : paths) {
        std::error_code unknown;
        const auto own = session.written.find(std::filesystem::absolute(path));
        if (std::filesystem::exists(path, unknown) &&
            (!belong || own == session.written.end() || own->second != file_stamp(path)))
            foreign.push_back(path.string());
    }
    if (foreign.empty())
        return attempt(session, write);
    constexpr std::size_t most_named = 3;
    if (const std::size_t count = foreign.size(); count > most_named) {
        foreign.resize(most_named - 1);
        foreign.push_back(fmt::format("{} more", count - foreign.size()));
    }
    session.question = {fmt::format("Overwrite {}? This session did not write {} from this document.",
                                    fmt::join(foreign, " and "), foreign.size() > 1 ? "them" : "it"),
                        {{"Overwrite", [&session, write] { attempt(session, write); }, 'O'}}};
}

} // namespace

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void notify(Session& session, std::string text, bool error) {
    session.message = {std::move(text), error, ImGui::GetTime() + message_seconds};
}

void hide_message_soon(Session& session) {
    session.message.until = std::min(session.message.until, ImGui::GetTime() + message_seconds);
}

void attempt(Session& session, const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        notify(session, error.what(), true);
    }
}

void answer(Session& session, std::optional<std::size_t> number) {
    const std::optional<Question> question = std::exchange(session.question, {});
    if (question && number)
        question->answers.at(*number).act();
    else
        session.closing = Closing::no;
}

bool is_changed(const Session& session) {
    return content_of(session.history.now) != content_of(session.saved);
}

void continue_closing(Session& session) {
    if (session.closing == Closing::no || session.closing == Closing::now || session.question ||
        session.dialog)
        return;
    if (session.exporter.running()) {
        if (session.closing == Closing::asked)
            session.question =
                Question{"An export is running.",
                         {{"Wait for it", [&session] { session.closing = Closing::after_export; }, 'W'},
                          {"End it",
                           [&session] {
                               session.exporter.cancel();
                               session.closing = Closing::after_export;
                           },
                           'E'}}};
        return;
    }
    if (session.closing == Closing::after_export && session.exporter.failed()) {
        session.closing = Closing::no;
        return notify(session, session.exporter.result(), true);
    }
    if (!is_changed(session)) {
        session.closing = Closing::now;
        return;
    }
    session.question =
        Question{fmt::format("Save the changes to {}?", session.document().path),
                 {{"Save", [&session] { save_preset(session); }, 'S'},
                  {"Close without saving", [&session] { session.closing = Closing::now; }, 'D'}}};
}

Document load_document(const std::string& path, const Document& defaults) {
    const auto named = std::ranges::find(render::presets(), path, &render::Preset::name);
    if (named != render::presets().end())
        return document_from_json(named->json, defaults);
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown))
        throw RequestError(fmt::format("cannot read '{}': expected a JSON file of parameters, an EXR that "
                                       "gabor rendered, or a preset's name",
                                       path));
    Document document = document_from_json(render::load_request(path).json, defaults);
    render::load_paint(document.request.paint); // throws if the file is missing
    return document;
}

void add_recent(Session& session, const std::string& path) {
    constexpr std::size_t most_recent = 10;
    const std::string whole = std::filesystem::absolute(path).string();
    std::erase(session.recent, whole);
    session.recent.insert(session.recent.begin(), whole);
    session.recent.resize(std::min(session.recent.size(), most_recent));
}

namespace {

// Whether a file is an EXR that gabor did not render.
bool is_foreign_exr(const std::string& path) {
    if (lower_extension(path) != ".exr" || !std::filesystem::exists(path))
        return false;
    try {
        render::load_request(path);
        return false;
    } catch (const RequestError&) {
        return true;
    }
}

} // namespace

void reset_panel(Session& session) {
    session.export_target.path.clear();
    session.export_target.folder.clear();
    session.scrolled_back = false;
}

void open_file(Session& session, const std::string& path) {
    if (is_photograph(path) || is_foreign_exr(path))
        open_photograph(session, path);
    else
        open_preset(session, path);
}

void open_preset(Session& session, const std::string& path) {
    attempt(session, [&] {
        const bool file = std::filesystem::is_regular_file(path); // a folder may be named like a preset
        open_document(session, load_document(path, session.history.now), path);
        session.history.now.origin = session.saved.origin = file ? std::filesystem::absolute(path) : "";
        if (file)
            add_recent(session, path);
    });
}

void open_document(Session& session, Document document, const std::string& path) {
    document.path = json_path(path).string();
    document.origin.clear();
    document.photograph.clear();
    session.fitter.close();
    reset_panel(session);
    session.history.now = session.saved = document;
    notify(session, fmt::format("opened {}", path));
}

bool has_file(const Document& document) {
    return document.origin == std::filesystem::absolute(json_path(document.path));
}

void save_preset(Session& session) {
    has_file(session.document()) ? write_preset(session) : ask_where_to_save(session);
}

void write_preset(Session& session) {
    const std::string path = json_path(session.document().path).string();
    overwrite(session, {path}, has_file(session.document()), [&session, path] {
        const std::string text = to_json(session.document());
        image::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
        session.written[std::filesystem::absolute(path)] = file_stamp(path);
        session.history.saved_as(path);
        session.saved = session.history.now;
        add_recent(session, path);
        notify(session, "saved " + path_from_home(path));
    });
}

void start_export(Session& session) {
    if (session.exporter.running())
        return;
    const ExportTarget target = session.export_target.of(session.document());
    if (target.as != ExportAs::maps && lower_extension(target.path) != ".exr")
        return notify(session, "the name of an export must end in .exr", true);
    for (const auto& [path, stamp] : session.exporter.written())
        session.written[path] = stamp;
    const bool same = session.exported_from == session.document().path;
    overwrite(session, paths_of(target), same, [&session, target] {
        session.exporter.start(session.document(), target);
        session.exported_from = session.document().path;
        session.exported = false;
    });
}

void ask_about_export(Session& session) {
    if (session.exporter.running())
        return notify(session, "an export is running: wait for it, or cancel it in the panel", true);
    const ExportTarget target = session.export_target.of(session.document());
    const render::Request request = exported(session.document(), target);
    std::vector<std::string> files;
    for (const std::filesystem::path& path : paths_of(target))
        files.push_back(path.filename().string());
    constexpr std::size_t most_named = 4;
    if (const std::size_t count = files.size(); count > most_named) {
        files.resize(most_named - 1);
        files.push_back(fmt::format("{} more", count - files.size()));
    }
    const auto folder = target.as == ExportAs::maps ? std::filesystem::path(target.folder)
                                                    : std::filesystem::absolute(target.path).parent_path();
    session.question = {fmt::format("Export {} x {} pixels to {}: {}?", request.width, request.height,
                                    path_from_home(folder), fmt::join(files, ", ")),
                        {{"Export", [&session] { start_export(session); }, 'E'},
                         {"Choose where...", [&session] { ask_where_to_export(session); }, 'W'}}};
}

void poll_exporter(Session& session) {
    if (session.exporter.running() || std::exchange(session.exported, true))
        return;
    notify(session, session.exporter.result(), session.exporter.failed());
    session.message.until = std::numeric_limits<double>::infinity();
}

void copy_glsl(Session& session) {
    const std::optional<std::string> fitted = fitted_glsl(session);
    ImGui::SetClipboardText(fitted.value_or(snippet(session.document(), session.view)).c_str());
    notify(session, fitted ? "copied the photograph's noise: paste it after gabor_noise.glsl and "
                             "gabor_spectrum.glsl"
                           : "copied GLSL that draws this view");
}

std::vector<std::string> file_names(const Session& session) {
    const Document& document = session.history.now;
    std::vector<std::string> names{document.path,         document.request.paint,
                                   session.message.text,  session.export_target.path,
                                   session.fitter.path(), session.export_target.folder};
    names.insert(names.end(), session.recent.begin(), session.recent.end());
    if (session.question)
        names.push_back(session.question->text);
    if (const auto& dialog = session.dialog) {
        names.insert(names.end(), {dialog->name, dialog->folder.string()});
        names.insert(names.end(), dialog->folders.begin(), dialog->folders.end());
        names.insert(names.end(), dialog->files.begin(), dialog->files.end());
    }
    return names;
}

void reset_camera(Session& session) {
    Document& document = session.document();
    document.camera = render::default_camera(document.request);
    reset_orbit(document.request);
}

} // namespace gabor::viewer
