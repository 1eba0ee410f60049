#include "viewer/session.hpp"
#include "viewer/document_json.hpp"
#include "viewer/material_snippet.hpp"
#include "viewer/photograph.hpp"
#include "viewer/snippet.hpp"

#include "error.hpp"
#include "image/output_file.hpp"
#include "render/load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace gabor::viewer {

namespace {

constexpr double message_seconds = 5;

/// The name under which the parameters of what was opened from `path` are saved.
std::filesystem::path json_path(std::filesystem::path path) {
    const std::string extension = lower_extension(path);
    if (extension == ".json")
        return path;
    if (extension == ".exr")
        return path.replace_extension(".json");
    return path += ".json";
}

/// Does `write` at once where it replaces no file but those that this session wrote; else asks first.
void overwrite(Session& session, const std::vector<std::filesystem::path>& paths,
               std::function<void()> write) {
    std::vector<std::string> foreign;
    for (const std::filesystem::path& path : paths) {
        std::error_code unknown;
        if (!std::filesystem::exists(path, unknown))
            continue;
        const auto own = session.written.find(std::filesystem::absolute(path));
        if (own == session.written.end() || own->second != file_stamp(path))
            foreign.push_back(path.string());
    }
    if (foreign.empty())
        return attempt(session, write);
    constexpr std::size_t most_named = 3;
    if (const std::size_t count = foreign.size(); count > most_named) {
        foreign.resize(most_named - 1);
        foreign.push_back(fmt::format("{} more", count - foreign.size()));
    }
    session.question = Question{fmt::format("Overwrite {}? This session did not write {}.",
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
    const auto preset = [](Document document) {
        document.camera = {}; // looking around changes nothing
        document.request.time = 0;
        return document;
    };
    return preset(session.history.now) != preset(session.kept);
}

void go_on_closing(Session& session) {
    if (session.closing == Closing::no || session.closing == Closing::now || session.question)
        return;
    if (session.exporter.running()) {
        if (session.closing == Closing::asked)
            session.question =
                Question{fmt::format("{} is being exported.", session.export_target.path),
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
        Question{fmt::format("What has changed since it was opened or saved is not in {} yet.",
                             json_path(session.preset_path).string()),
                 {{"Save", [&session] { save_preset(session); }, 'S'},
                  {"Close without saving", [&session] { session.closing = Closing::now; }, 'D'}}};
}

Document load_document(const std::string& path, const Document& defaults) {
    const auto named = std::ranges::find(render::presets(), path, &render::Preset::name);
    if (named != render::presets().end())
        return document_from_json(named->json, defaults);
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown))
        throw RequestError(fmt::format("cannot read '{}': it takes a JSON file of parameters, an EXR that "
                                       "gabor rendered, or a preset's name",
                                       path));
    Document document = document_from_json(render::load_request(path).json, defaults);
    render::load_paint(document.request.paint); // it must be there
    return document;
}

void keep_recent(Session& session, const std::string& path) {
    constexpr std::size_t most_recent = 10;
    const std::string whole = std::filesystem::absolute(path).string();
    std::erase(session.recent, whole);
    session.recent.insert(session.recent.begin(), whole);
    session.recent.resize(std::min(session.recent.size(), most_recent));
}

namespace {

void keep(Session& session, const std::string& path) {
    session.preset_path = path;
    session.kept = session.history.now;
    keep_recent(session, path);
}

// Whether it is an EXR that gabor did not render.
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

void open_file(Session& session, const std::string& path) {
    if (is_photograph(path) || is_foreign_exr(path))
        open_photograph(session, path);
    else
        open_preset(session, path);
}

void open_preset(Session& session, const std::string& path) {
    attempt(session, [&] {
        session.history.now = load_document(path, session.history.now);
        if (std::filesystem::exists(path)) {
            keep(session, path);
        } else {
            session.preset_path = path + ".json"; // one that comes with the program
            session.kept = session.history.now;
        }
        notify(session, fmt::format("opened {}", path));
    });
}

void save_preset(Session& session) {
    const std::filesystem::path path = json_path(session.preset_path);
    overwrite(session, {path}, [&session, path] {
        const std::string text = to_json(session.document());
        image::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
        session.written[std::filesystem::absolute(path)] = file_stamp(path);
        keep(session, path.string());
        notify(session, fmt::format("saved {}", path.string()));
    });
}

void start_export(Session& session) {
    if (session.exporter.running())
        return;
    const ExportTarget target = session.export_target;
    if (lower_extension(target.path) != ".exr")
        return notify(session, "an export takes a name that ends in .exr", true);
    std::vector<std::filesystem::path> paths;
    for (const render::Files& files : files_of(target))
        for (const std::optional<std::filesystem::path>& path : {files.exr, files.png})
            if (path)
                paths.push_back(*path);
    for (const auto& [path, stamp] : session.exporter.written())
        session.written[path] = stamp;
    overwrite(session, paths, [&session, target] { session.exporter.start(session.document(), target); });
}

void copy_glsl(Session& session) {
    const Document& document = session.document();
    const std::optional<std::string> fitted = fitted_glsl(session);
    const std::string code = fitted ? *fitted
                             : render::has_material(document.request)
                                 ? material_snippet(document, session.view)
                                 : snippet(document, session.view);
    ImGui::SetClipboardText(code.c_str());
    notify(session, "the GLSL of this view is on the clipboard");
}

void reset_camera(Session& session) {
    Document& document = session.document();
    document.camera = render::default_camera(document.request);
    if (auto* body = std::get_if<render::Body>(&document.request.view))
        *body = {body->shape, body->solid};
}

} // namespace gabor::viewer
