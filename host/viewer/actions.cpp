#include "viewer/session.hpp"
#include "viewer/snippet.hpp"

#include "error.hpp"
#include "image/output_file.hpp"
#include "render/likeness.hpp"
#include "render/paint.hpp"
#include "render/presets.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace gabor::viewer {

namespace {

constexpr double note_seconds = 5;

} // namespace

void say(Session& session, std::string note) {
    session.note = std::move(note);
    session.note_until = ImGui::GetTime() + note_seconds;
}

render::Picture read_preset(const std::string& path) {
    const auto named = std::ranges::find(render::presets(), path, &render::Preset::name);
    if (named != render::presets().end())
        return render::from_json(named->json);
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown))
        throw RequestError(fmt::format("cannot read '{}': it takes a JSON file of parameters, an EXR that "
                                       "gabor rendered, or a preset's name",
                                       path));
    return render::read_likeness(path).picture;
}

void open_preset(Session& session, const std::string& path) {
    try {
        Document opened = document_of(read_preset(path));
        const Document& now = session.history.now;
        render::read_paint(opened.picture.paint); // it must be there
        if (!opened.body)
            opened.waves = now.waves;
        opened.output = now.output;
        opened.colours = now.colours;
        opened.contrast = now.contrast;
        opened.rival = now.rival;
        session.history.now = opened;
        session.preset = path;
        say(session, fmt::format("opened {}", path));
    } catch (const std::exception& error) {
        say(session, error.what());
    }
}

void save_preset(Session& session, const std::string& path) {
    try {
        const std::string text = render::to_json(session.document().exported()) + "\n";
        image::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
        say(session, fmt::format("saved {}", path));
    } catch (const std::exception& error) {
        say(session, error.what());
    }
}

void copy_glsl(Session& session) {
    ImGui::SetClipboardText(snippet(session.document(), session.view).c_str());
    say(session, "the GLSL of this view is on the clipboard");
}

void start_export(Session& session) {
    if (session.exporter.running())
        return;
    try {
        const std::filesystem::path exr = session.plan.path;
        std::optional<std::filesystem::path> png;
        if (session.plan.png)
            png = std::filesystem::path(exr).replace_extension(".png");
        session.exporter.start(session.document().exported(), exr, png);
    } catch (const std::exception& error) {
        say(session, error.what());
    }
}

void go_home(Session& session) {
    session.document().camera = home_of(session.document());
    session.document().pose = {};
}

} // namespace gabor::viewer
