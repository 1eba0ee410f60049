#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gabor::cli {

/// A command-line program. Each of `commands` adds one subcommand, which does its work in its callback.
struct Program {
    std::string name;
    std::string description; ///< one sentence, for its help
    std::vector<void (*)(CLI::App&)> commands;
};

/// Does what the command line asks for and returns the exit status: 0 done, 1 failed while working, 2 the
/// request was wrong. Errors are one line on stderr. After SIGINT or SIGTERM it cleans up and does not
/// return: the signal ends the process.
int run(const Program& program, int argc, const char* const* argv);

/// The program `gabor`.
Program gabor_program();

} // namespace gabor::cli
