#include "cli/program.hpp"

#include "cli/terminal.hpp"
#include "error.hpp"
#include "vulkan/device.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace gabor::cli {

namespace {

// Prints one line on stderr. Replaces control characters, which text from files may contain, with spaces.
int fail(const Program& program, int status, std::string message) {
    std::ranges::replace_if(
        message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    std::fputs(fmt::format("{}: {}\n", program.name, message).c_str(),
               stderr); // if this fails, the exit status still reports the error
    return status;
}

// Removes the suffix that CLI11 adds to negated flags in the help, as in --no-filter{false}.
class Formatter : public CLI::Formatter {
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
        const std::string name = CLI::Formatter::make_option_name(option, is_positional);
        return name.substr(0, name.find('{'));
    }
};

// The edit distance between two words: how many letters to change, add or remove.
std::size_t edits(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t kept = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({kept, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

// Suggests the option or subcommand most similar to an unknown word; empty if none is similar enough.
std::string suggestion(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    for (const CLI::Option* option : (chosen.empty() ? app : *chosen.front()).get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back("--" + name);
    for (const CLI::App* command : app.get_subcommands({}))
        known.push_back(command->get_name());
    const auto distance = [name = word.substr(0, word.find('='))](const std::string& other) {
        return edits(name, other);
    };
    const auto closest = std::ranges::min_element(known, {}, distance);
    return distance(*closest) <= 2 ? fmt::format(": did you mean {}?", *closest) : "";
}

std::string where_to_look(const CLI::App& app) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return fmt::format("{} {}--help lists what is accepted", app.get_name(),
                       chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

int parse_and_work(const Program& program, int argc, const char* const* argv) {
    CLI::App app(program.description, program.name);
    app.formatter(std::make_shared<Formatter>());
    app.set_version_flag("--version", program.name + " " GABOR_VERSION);
    app.option_defaults()->disable_flag_override(); // reject --verbose=3
    app.require_subcommand(0, 1); // with (1, 1), CLI11's message would not name the unknown word
    for (const auto& add : program.commands)
        add(app);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty())
            fmt::print("{}", app.help());
    } catch (const CLI::ParseError& error) {
        const std::vector<std::string> words = app.remaining(true);
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            app.exit(error);     // prints --help or --version
        else if (!words.empty()) // unknown words come first: one may be a misspelled required option
            return fail(program, 2,
                        fmt::format("unknown '{}'{} ({})", words.front(), suggestion(app, words.front()),
                                    where_to_look(app)));
        else
            return fail(program, 2, fmt::format("{} ({})", error.what(), where_to_look(app)));
    } catch (const RequestError& error) {
        return fail(program, 2, error.what());
    } catch (const std::exception& error) {
        return fail(program, 1, error.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        return fail(program, 1, "cannot write to standard output");
    if (const int messages = vulkan::validation_messages())
        return fail(program, 1, fmt::format("{} message(s) from the validation layers", messages));
    return 0;
}

} // namespace

void add_device_option(CLI::App& command, std::string& device) {
    command
        .add_option("--device", device,
                    "Vulkan device: its index or part of its name [a GPU, if there is one]")
        ->type_name("NAME");
}

int run(const Program& program, int argc, const char* const* argv) {
    // If a standard stream is closed, the next file to be opened would take its descriptor and receive what
    // is printed. Open a read-only file in its place, so that printing fails instead.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
            ::open("/dev/null", O_RDONLY);
    // Report a closed pipe and a file that is too large like any other error.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return parse_and_work(program, argc, argv);
    } catch (const Interrupted& interrupted) {
        fail(program, 1, "interrupted; no half-written file was kept");
        // Terminate by the same signal, so that shells and job schedulers see the reason.
        std::signal(interrupted.signal, SIG_DFL);
        std::raise(interrupted.signal);
        return 1;
    }
}

} // namespace gabor::cli
