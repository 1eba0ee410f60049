// A gabor-viewer that reports its state: a line of JSON on stdout after each frame. Real display events drive
// it, as they drive gabor-viewer; the sender waits for its reports instead of a fixed time. Commands on
// stdin, one per line, do the rest:
//
//     set NAME VALUE                      a parameter of the preset, or output, look, colours, contrast
//     resize FACTOR                       all pixels of the picture
//     open FILE | save FILE | copy FILE   copy writes the clipboard's text to the file
//     maps SIDE                           the sides of exported maps
//     export FILE | screenshot FILE | window FILE    screenshot: the picture; window: also the panels
//     find TEXT       reports where the window shows this text, and no more of the same label, as `found`
//     quit

#include "viewer/app.hpp"
#include "viewer/dear_imgui.hpp"
#include "viewer/document_json.hpp"
#include "viewer/photograph.hpp"

#include "error.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <poll.h>
#include <string_view>
#include <vector>

// As in GLFW/glfw3native.h, which would need X11 headers.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

namespace {

using namespace gabor::viewer;
using nlohmann::json;

// The events that have reached a frame so far.
struct Seen {
    std::uint64_t frames = 0;
    std::uint64_t keys = 0;   ///< pressed, except modifiers
    std::uint64_t clicks = 0; ///< buttons pressed and released
    double wheel = 0;
    std::uint64_t commands = 0;
    std::array<bool, GLFW_KEY_LAST + 1> down{};
    bool button = false;

    // Call this once Dear ImGui has received the frame's events.
    void add(const ImGuiIO& io) {
        ++frames;
        wheel += double{io.MouseWheel};
        for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
            const bool modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
            const bool is_down = dear_imgui::is_down(key);
            bool& was_down = down.at(static_cast<std::size_t>(key));
            keys += is_down && !was_down && !modifier;
            was_down = is_down;
        }
        clicks += button && !io.MouseDown[0];
        button = io.MouseDown[0];
    }
};

// Where a draw list shows a text, and no more of the same label: left, top, right and bottom of its first
// place from the top. Letters are quads of the font's glyphs.
std::optional<std::array<float, 4>> place_in(const ImVector<ImDrawVert>& corners, std::string_view text) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    std::vector<const ImFontGlyph*> glyphs;
    for (const char letter : text)
        if (letter != ' ')
            glyphs.push_back(&dear_imgui::glyph(static_cast<ImWchar>(letter)));
    const int length = 4 * static_cast<int>(glyphs.size());
    const auto touches = [&](int letter, ImVec2 end) {
        return letter >= 0 && letter < corners.Size &&
               (corners[letter].uv.x != white.x || corners[letter].uv.y != white.y) &&
               std::abs(corners[letter].pos.y - end.y) < ImGui::GetFontSize() &&
               std::abs(corners[letter].pos.x - end.x) < 0.6f * ImGui::GetFontSize();
    };
    std::optional<std::array<float, 4>> place;
    for (int first = 0; first + length <= corners.Size; ++first) {
        const ImVec2 begin = corners[first].pos, end = corners[first + length - 2].pos;
        bool same = !touches(first + length, end) && !touches(first - 2, begin);
        for (int i = 0; same && i < length; i += 4)
            same = corners[first + i].uv.x == glyphs[static_cast<std::size_t>(i / 4)]->U0 &&
                   corners[first + i].uv.y == glyphs[static_cast<std::size_t>(i / 4)]->V0;
        if (same && (!place || begin.y < place->at(1)))
            place = {begin.x, begin.y, end.x, end.y};
    }
    return place;
}

// Where the last frame showed a text: in the front window that does, with its children.
json place_of(std::string_view text) {
    std::optional<std::array<float, 4>> place;
    const ImGuiWindow* root = nullptr;
    const auto& windows = ImGui::GetCurrentContext()->Windows;
    for (int w = windows.Size; w-- > 0 && (!place || windows[w]->RootWindow == root);) {
        const auto found = windows[w]->WasActive && !windows[w]->Hidden
                               ? place_in(windows[w]->DrawList->VtxBuffer, text)
                               : std::nullopt;
        if (!found || (place && place->at(1) < found->at(1)))
            continue;
        place = found;
        root = windows[w]->RootWindow;
    }
    return place ? json(*place) : json();
}

json dialog(const Session& session) {
    if (!session.dialog)
        return nullptr;
    return {{"folder", session.dialog->folder.string()},
            {"name", session.dialog->name},
            {"typed", ImGui::GetIO().WantTextInput}};
}

void tell(App& app, const Seen& seen, const json& found) {
    const Session& session = app.session();
    const ImGuiIO& io = ImGui::GetIO();
    const json line{
        {"window", glfwGetX11Window(app.window().handle())},
        {"frames", seen.frames},
        {"keys", seen.keys},
        {"clicks", seen.clicks},
        {"wheel", seen.wheel},
        {"commands", seen.commands},
        {"pointer", {io.MousePos.x, io.MousePos.y}},
        {"size", {io.DisplaySize.x, io.DisplaySize.y}},
        {"font", ImGui::GetFontSize()},
        {"fine", app.fine()},
        {"document", json::parse(to_json(session.history.now))},
        {"dialog", dialog(session)},
        {"question", session.question ? json(session.question->text) : json()},
        {"message", session.message.text},
        {"path", session.history.now.path},
        {"photograph", shows_photograph(session)},
        {"export", static_cast<int>(session.export_target.of(session.history.now).as)},
        {"export_name", session.export_target.of(session.history.now).name()},
        {"animation", session.export_target.frames},
        {"exporting", session.exporter.running()},
        {"fitting", session.fitter.running()},
        {"popup", ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)},
        {"gallery", session.gallery},
        {"search", session.search},
        {"tiles", session.tiling ? json({session.tiling->tile.width, session.tiling->tile.height}) : json()},
        {"reading", session.reading},
        {"found", found},
        {"panel",
         ImGui::FindWindowByName("panels") ? ImGui::FindWindowByName("panels")->DC.CursorStartPos.x : 0},
    };
    fmt::print("{}\n", line.dump());
    std::fflush(stdout);
}

void set(Document& document, const std::string& name, const std::string& value) {
    if (name == "output")
        document.output = static_cast<Output>(std::stoi(value));
    else if (name == "look")
        document.look = static_cast<Look>(std::stoi(value));
    else if (name == "colours")
        document.colours = std::stoi(value);
    else if (name == "contrast")
        document.contrast = std::stof(value);
    else
        set_parameter(document, name, gabor::render::read(gabor::render::parameter(name), value));
}

/// Returns whether to continue. `rest` is the line after its first word, and `found` the answer to `find`.
bool obey(App& app, const std::string& name, const std::string& rest, json& found) {
    Session& session = app.session();
    if (name == "quit")
        return false;
    if (name == "set") {
        const std::size_t space = rest.find(' ');
        set(session.document(), rest.substr(0, space), rest.substr(space + 1));
    } else if (name == "open") {
        open_file(session, rest);
    } else if (name == "save") {
        session.document().path = rest;
        write_preset(session);
    } else if (name == "resize") {
        resize(session.document(), std::stod(rest));
    } else if (name == "find") {
        found = place_of(rest);
    } else if (name == "copy") {
        std::ofstream(rest) << ImGui::GetClipboardText();
    } else if (name == "export") {
        session.export_target.path = rest;
        start_export(session);
    } else if (name == "maps") {
        session.export_target.map_side = std::stoi(rest);
    } else if (name == "screenshot") {
        app.save_picture(rest);
    } else if (name == "window") {
        app.save_window(rest);
    } else {
        throw gabor::RequestError(fmt::format("there is no command '{}'", name));
    }
    return true;
}

/// Obeys a command if one has arrived, and returns whether to continue. The sender waits for each command's
/// report before it sends the next.
bool listen(App& app, Seen& seen, json& found) {
    pollfd input{0, POLLIN, 0};
    const int patience = app.fine() ? 30 : 0; // in ms: most frames show what the last one showed
    std::string line;
    if (poll(&input, 1, patience) != 1 || !std::getline(std::cin, line))
        return true;
    ++seen.commands;
    const std::size_t space = line.find(' ');
    return obey(app, line.substr(0, space), space == line.npos ? "" : line.substr(space + 1), found);
}

} // namespace

int main(int argc, char** argv) {
    Seen seen;
    json found;
    return run_viewer(argc, argv, [&](App& app) {
        if (seen.frames > 0) // reports the previous frame
            tell(app, seen, found);
        seen.add(ImGui::GetIO());
        return listen(app, seen, found);
    });
}
