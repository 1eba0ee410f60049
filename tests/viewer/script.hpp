#pragma once

#include "viewer/app.hpp"

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace gabor::viewer {

/// Plays input from a file, one command a line, for tests and for pictures of the window:
///
///     move X Y | click X Y | doubleclick X Y | drag X Y TO_X TO_Y | scroll X Y AMOUNT
///     key NAME | key ctrl+NAME            a letter, a digit, F1 to F12, tab, space, home, escape ...
///     type TEXT                           into the field that has the keyboard
///     set NAME VALUE                      a parameter of the preset, or output, look, colours, contrast
///     resize WIDTH HEIGHT | minimize | restore | hide | show
///     open FILE | save FILE | copy FILE   copy: puts what is on the clipboard into a file
///     export FILE | screenshot FILE | window FILE    of the picture; of the window with its panels
///     exported                                       waits until the last export has ended
///     wait FRAMES | fine | settle | sleep SECONDS    fine: until full resolution; settle: and nothing runs
///     expect message TEXT                 waits for it, for two minutes at most
///     random SEED SECONDS                 random input
///     quit
///
/// Positions are in the window's units. Lines that begin with # are ignored.
class Script {
  public:
    /// Throws RequestError if the file is missing or a line is not a command.
    explicit Script(const std::filesystem::path& path);

    /// Plays one frame's input; call it between Dear ImGui's input and NewFrame. Throws std::runtime_error
    /// if an expectation fails. Returns false once the viewer should quit.
    bool play(App& app);

  private:
    struct Command {
        int line;
        std::string name;
        std::vector<std::string> words;
        double number(std::size_t i) const;
        std::string rest(std::size_t from = 0) const;
    };

    bool execute(const Command& command, App& app);
    bool drag(const Command& command);
    bool key(const Command& command);
    void set(const Command& command, Session& session);
    bool expect(const Command& command, const Session& session) const;
    bool random(const Command& command, App& app);
    void apply() const;

    std::filesystem::path path_;
    std::vector<Command> commands_;
    std::size_t at_ = 0;
    int step_ = 0;        ///< of a command that takes several frames
    double started_ = -1; ///< when the command was first tried
    float x_ = 40;
    float y_ = 40;
    bool down_ = false;
    float wheel_ = 0;
    std::vector<int> keys_;
    std::mt19937 generator_;
    int held_frames_ = 0;
    double next_rest_ = 0;
};

} // namespace gabor::viewer
