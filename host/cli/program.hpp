#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gabor::cli {

/// A command-line program. Each of `commands` adds one subcommand, whose callback does the work.
struct Program {
    std::string name;
    std::string description; ///< one sentence for the help text
    std::vector<void (*)(CLI::App&)> commands;
    std::string examples = {}; ///< the end of the help text
};

/// Adds the option --device to a command.
void add_device_option(CLI::App& command, std::string& device);

/// Adds --compression, which takes one of image::exr_compressions.
void add_compression_option(CLI::App& command, std::string& compression);

/// Runs the command line and returns the exit status: 0 for success, 1 if the work failed, 2 if the request
/// was wrong. Prints errors as one line on stderr. After SIGINT or SIGTERM it cleans up and does not return:
/// the signal terminates the process.
int run(const Program& program, int argc, const char* const* argv);

/// The program `gabor`.
Program gabor_program();

} // namespace gabor::cli
