#include "script.hpp"

#include "error.hpp"
#include "image/output_file.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <sstream>

namespace gabor::viewer {

namespace {

constexpr int drag_frames = 12;
constexpr double patience = 300;    // seconds to wait for the picture to settle
constexpr double expectation = 120; // and for an expectation to hold

const std::map<std::string, std::size_t, std::less<>> words_needed{
    {"move", 2},   {"doubleclick", 2}, {"click", 2},      {"drag", 4},     {"scroll", 3},  {"key", 1},
    {"type", 1},   {"set", 2},         {"resize", 2},     {"minimize", 0}, {"restore", 0}, {"hide", 0},
    {"show", 0},   {"open", 1},        {"save", 1},       {"copy", 1},     {"export", 1},  {"exported", 0},
    {"fitted", 0}, {"fine", 0},        {"screenshot", 1}, {"window", 1},   {"wait", 1},    {"settle", 0},
    {"sleep", 1},  {"expect", 2},      {"random", 2},     {"quit", 0}};

const std::map<std::string, int, std::less<>> named_keys{
    {"tab", GLFW_KEY_TAB},       {"space", GLFW_KEY_SPACE}, {"home", GLFW_KEY_HOME},
    {"escape", GLFW_KEY_ESCAPE}, {"enter", GLFW_KEY_ENTER}, {"left", GLFW_KEY_LEFT},
    {"right", GLFW_KEY_RIGHT},   {"up", GLFW_KEY_UP},       {"down", GLFW_KEY_DOWN},
    {"plus", GLFW_KEY_EQUAL},    {"minus", GLFW_KEY_MINUS}, {"backspace", GLFW_KEY_BACKSPACE},
    {"delete", GLFW_KEY_DELETE}};

int key_of(std::string_view name) {
    if (const auto found = named_keys.find(name); found != named_keys.end())
        return found->second;
    if (name.size() > 1 && name[0] == 'F') {
        int number = 0;
        std::from_chars(name.data() + 1, name.data() + name.size(), number);
        if (number >= 1 && number <= 12)
            return GLFW_KEY_F1 + number - 1;
    }
    if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z')
        return GLFW_KEY_A + (name[0] - 'a');
    if (name.size() == 1 && name[0] >= '0' && name[0] <= '9')
        return GLFW_KEY_0 + (name[0] - '0');
    throw RequestError(fmt::format("there is no key '{}'", name));
}

} // namespace

double Script::Command::number(std::size_t i) const {
    double value = 0;
    const std::string& word = words.at(i);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        throw RequestError(fmt::format("line {}: '{}' is no number", line, word));
    return value;
}

std::string Script::Command::rest(std::size_t from) const {
    return fmt::format("{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(from), words.end(), " "));
}

Script::Script(const std::filesystem::path& path) : path_(path) {
    std::ifstream file(path);
    if (!file)
        throw RequestError(fmt::format("--script '{}' cannot be read", path.string()));
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        std::istringstream words(line);
        Command command{number, {}, {}};
        if (!(words >> command.name) || command.name[0] == '#')
            continue;
        for (std::string word; words >> word;)
            command.words.push_back(word);
        const auto known = words_needed.find(command.name);
        if (known == words_needed.end() || command.words.size() < known->second) {
            std::vector<std::string> names;
            for (const auto& [name, count] : words_needed)
                names.push_back(name);
            throw RequestError(fmt::format("{}:{}: '{}': the commands are {}", path.string(), number, line,
                                           fmt::join(names, ", ")));
        }
        commands_.push_back(std::move(command));
    }
}

bool Script::play(App& app) {
    wheel_ = 0;
    keys_.clear();
    if (at_ < commands_.size()) {
        const Command& command = commands_[at_];
        if (started_ < 0)
            started_ = ImGui::GetTime();
        if (command.name == "quit")
            return false;
        bool done = false;
        try {
            done = execute(command, app);
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("{}:{}: {}", path_.string(), command.line, error.what()));
        }
        if (done) {
            ++at_;
            step_ = 0;
            started_ = -1;
        }
    }
    apply();
    return true;
}

bool Script::execute(const Command& command, App& app) {
    Session& session = app.session();
    GLFWwindow* window = app.window().handle();
    const std::string& name = command.name;
    if (name == "move") {
        x_ = static_cast<float>(command.number(0));
        y_ = static_cast<float>(command.number(1));
    } else if (name == "click") {
        x_ = static_cast<float>(command.number(0));
        y_ = static_cast<float>(command.number(1));
        down_ = step_ == 1;
        return ++step_ == 3;
    } else if (name == "doubleclick") {
        x_ = static_cast<float>(command.number(0));
        y_ = static_cast<float>(command.number(1));
        down_ = step_ == 1 || step_ == 3;
        ImGui::GetIO().MouseDoubleClickTime = step_ < 4 ? 10.0f : 0.3f; // however slow frames are
        return ++step_ == 5;
    } else if (name == "drag") {
        return drag(command);
    } else if (name == "scroll") {
        x_ = static_cast<float>(command.number(0));
        y_ = static_cast<float>(command.number(1));
        wheel_ = step_ == 1 ? static_cast<float>(command.number(2)) : 0;
        return ++step_ == 3;
    } else if (name == "key") {
        return key(command);
    } else if (name == "type") {
        for (const char c : command.rest())
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    } else if (name == "set") {
        set(command, session);
    } else if (name == "resize") {
        glfwSetWindowSize(window, static_cast<int>(command.number(0)), static_cast<int>(command.number(1)));
    } else if (name == "minimize") {
        glfwIconifyWindow(window);
    } else if (name == "restore") {
        glfwRestoreWindow(window);
    } else if (name == "hide") {
        glfwHideWindow(window);
    } else if (name == "show") {
        glfwShowWindow(window);
    } else if (name == "open") {
        open_file(session, command.rest());
    } else if (name == "save") {
        session.document().path = command.rest();
        save_preset(session);
    } else if (name == "copy") {
        const char* held = ImGui::GetClipboardText();
        const std::string text = held ? held : "";
        image::OutputFile file(command.rest());
        file.write(std::as_bytes(std::span(text)));
        file.commit();
    } else if (name == "export") {
        session.export_target.path = command.rest();
        start_export(session);
    } else if (name == "fine") {
        return ++step_ > 3 && app.fine();
    } else if (name == "fitted") {
        return ++step_ > 3 && !session.fitter.running();
    } else if (name == "exported") {
        if (session.exporter.failed())
            throw std::runtime_error(session.exporter.result());
        return !session.exporter.running();
    } else if (name == "screenshot") {
        app.save_picture(command.rest());
    } else if (name == "window") {
        app.save_window(command.rest());
    } else if (name == "wait") {
        return ++step_ >= command.number(0);
    } else if (name == "sleep") {
        return ImGui::GetTime() - started_ >= command.number(0);
    } else if (name == "settle") {
        if (ImGui::GetTime() - started_ > patience)
            throw std::runtime_error("nothing settles");
        return ++step_ > 3 && app.settled();
    } else if (name == "expect") {
        return expect(command, session);
    } else if (name == "random") {
        return random(command, app);
    }
    return true;
}

bool Script::drag(const Command& command) {
    const float t = std::clamp(static_cast<float>(step_ - 2) / drag_frames, 0.0f, 1.0f);
    x_ = std::lerp(static_cast<float>(command.number(0)), static_cast<float>(command.number(2)), t);
    y_ = std::lerp(static_cast<float>(command.number(1)), static_cast<float>(command.number(3)), t);
    down_ = step_ >= 1 && step_ <= drag_frames + 3;
    return ++step_ > drag_frames + 5;
}

bool Script::key(const Command& command) {
    std::string_view name = command.words[0];
    if (step_ == 1) {
        if (name.starts_with("ctrl+")) {
            keys_.push_back(GLFW_KEY_LEFT_CONTROL);
            name.remove_prefix(5);
        }
        keys_.push_back(key_of(name));
    }
    return ++step_ == 3;
}

void Script::set(const Command& command, Session& session) {
    Document& document = session.document();
    const std::string& name = command.words[0];
    if (name == "output") {
        document.output = static_cast<Output>(std::clamp(static_cast<int>(command.number(1)), 0, 7));
    } else if (name == "look") {
        document.look = static_cast<Look>(std::clamp(static_cast<int>(command.number(1)), 0, 5));
    } else if (name == "colours") {
        document.colours = static_cast<int>(command.number(1));
    } else if (name == "contrast") {
        document.contrast = static_cast<float>(command.number(1));
    } else {
        const render::Parameter& parameter = render::parameter(name);
        set_parameter(document, name, render::read(parameter, command.rest(1)));
    }
}

bool Script::expect(const Command& command, const Session& session) const {
    if (command.words[0] != "message")
        throw RequestError(fmt::format("line {}: expected expect message TEXT", command.line));
    const std::string& found = session.message.text;
    if (!found.empty() && found.find(command.rest(1)) != std::string::npos)
        return true;
    if (ImGui::GetTime() - started_ > expectation)
        throw std::runtime_error(fmt::format("expected {}, but there is '{}'", command.rest(), found));
    return false;
}

// Moves, clicks, drags, scrolls, resizes, and presses any key except the one that quits.
bool Script::random(const Command& command, App& app) {
    Session& session = app.session();
    if (step_++ == 0)
        generator_.seed(static_cast<unsigned>(command.number(0)));
    const auto draw = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); };
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const int width = std::max(static_cast<int>(size.x), 1);
    const int height = std::max(static_cast<int>(size.y), 1);
    if (held_frames_ > 0) {
        x_ += static_cast<float>(draw(61) - 30);
        y_ += static_cast<float>(draw(61) - 30);
        if (--held_frames_ == 0)
            down_ = false;
    } else {
        switch (draw(16)) {
        case 0:
        case 1:
        case 2:
            x_ = static_cast<float>(draw(width));
            y_ = static_cast<float>(draw(height));
            break;
        case 3:
        case 4:
        case 5:
            down_ = true;
            held_frames_ = 1 + draw(12);
            break;
        case 6:
        case 7:
            wheel_ = static_cast<float>(draw(5) - 2);
            break;
        case 8:
        case 9: {
            static constexpr std::string_view letters = "cezynrvf12345 ";
            if (draw(4) == 0)
                keys_.push_back(GLFW_KEY_LEFT_CONTROL);
            const char letter = letters[static_cast<std::size_t>(draw(static_cast<int>(letters.size())))];
            keys_.push_back(letter == ' ' ? GLFW_KEY_TAB : key_of(std::string(1, letter)));
            break;
        }
        case 10:
            keys_.push_back(GLFW_KEY_SPACE);
            break;
        case 11:
            if (draw(20) == 0)
                glfwSetWindowSize(app.window().handle(), 480 + draw(900), 320 + draw(600));
            break;
        case 12:
            if (draw(20) == 0)
                session.help = !session.help;
            break;
        case 13:
            if (draw(30) == 0)
                session.panels = !session.panels;
            break;
        default:
            break; // a moment's rest
        }
    }
    // Exporting the largest picture that the window offers would take all day.
    render::Request& request = session.document().request;
    request.width = std::min(request.width, 2048);
    request.height = std::min(request.height, 2048);
    const bool over = ImGui::GetTime() - started_ >= command.number(1);
    if (over)
        down_ = false;
    return over;
}

void Script::apply() const {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {x_, y_};
    for (bool& button : io.MouseDown)
        button = false;
    io.MouseDown[0] = down_;
    io.MouseWheel = wheel_;
    io.MouseWheelH = 0;
    for (bool& key : io.KeysDown)
        key = false;
    for (const int key : keys_)
        io.KeysDown[key] = true;
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL];
    io.KeyShift = io.KeyAlt = io.KeySuper = false;
}

} // namespace gabor::viewer
