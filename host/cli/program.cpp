#include "cli/program.hpp"

#include "cli/terminal.hpp"
#include "error.hpp"
#include "image/exr.hpp"
#include "names.hpp"
#include "system/process.hpp"
#include "vulkan/device.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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

// Shows each option once, with our name for its type and the description wrapped, and leaves one line between
// groups.
class Formatter : public CLI::Formatter {
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        std::string text = CLI::Formatter::make_help(app, name, mode);
        for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != text.npos;)
            text.erase(at, 1);
        return text;
    }

    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        constexpr std::size_t column = 30, width = 100;
        const std::string names = make_option_name(option, is_positional);
        std::string line = "  " + names.substr(0, names.find(",--no-"));
        if (option->get_type_size() != 0 && !option->get_type_name().empty())
            line += " " + option->get_type_name();
        std::string text = line.size() < column ? "" : std::exchange(line, "") + "\n";
        line.resize(column, ' ');
        std::istringstream paragraphs(option->get_description() +
                                      (option->get_required() ? " (required)" : ""));
        std::string paragraph;
        std::getline(paragraphs, paragraph);
        do {
            std::istringstream words(paragraph);
            for (std::string word; words >> word; line += line.size() == column ? word : " " + word)
                if (line.size() > column && line.size() + 1 + word.size() > width) {
                    text += line + "\n";
                    line.assign(column, ' ');
                }
            text += line + "\n";
            line.assign(column, ' ');
        } while (std::getline(paragraphs, paragraph));
        return text;
    }
};

// Suggests options or subcommands that are similar to an unknown word; returns "" if none is.
std::string suggestion(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    if (word.starts_with('-')) {
        for (const CLI::Option* option : (chosen.empty() ? app : *chosen.front()).get_options())
            for (const std::string& name : option->get_lnames())
                known.push_back(name);
    } else if (chosen.empty()) {
        for (const CLI::App* command : app.get_subcommands({}))
            known.push_back(command->get_name());
    }
    const std::size_t start = std::min(word.find_first_not_of('-'), word.size());
    const std::vector<std::string_view> names(known.begin(), known.end());
    return did_you_mean(word.substr(start, word.find('=') - start), names, start > 0 ? "--" : "");
}

// Names the command that lists what is accepted, in general or instead of an unknown word.
std::string where_to_look(const CLI::App& app, const std::string& word = "") {
    if (const std::size_t dot = word.find('.'); word.starts_with("--") && dot != word.npos)
        return fmt::format("{} materials {} lists what is accepted", app.get_name(), word.substr(2, dot - 2));
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return fmt::format("{} {}--help lists what is accepted", app.get_name(),
                       chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

int parse_and_work(const Program& program, int argc, const char* const* argv) {
    CLI::App app(program.description, program.name);
    app.allow_windows_style_options(false); // /name is a path
    app.formatter(std::make_shared<Formatter>());
    app.set_version_flag("--version", program.name + " " GABOR_VERSION);
    app.option_defaults()->disable_flag_override(); // reject --gradient=3
    app.require_subcommand(0, 1); // with (1, 1), CLI11's message would not name the unknown word
    for (const auto& add : program.commands)
        add(app);
    app.footer(program.examples); // last: commands inherit what is there when they are added
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
                        fmt::format("unknown '{}': {}{}", words.front(), suggestion(app, words.front()),
                                    where_to_look(app, words.front())));
        else
            return fail(program, 2, fmt::format("{} ({})", error.what(), where_to_look(app)));
    } catch (const RequestError& error) {
        return fail(program, 2, error.what());
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::broken_pipe) // a reader such as `head` has seen enough
            return 0;
        return fail(program, 1,
                    (vulkan::out_of_memory(error.code()) ? "out of memory: " : "") +
                        std::string(error.what()));
    } catch (const std::bad_alloc&) {
        return fail(program, 1, "out of memory");
    } catch (const std::exception& error) {
        return fail(program, 1, error.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        return errno == EPIPE ? 0 : fail(program, 1, "cannot write to standard output");
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

void add_compression_option(CLI::App& command, std::string& compression) {
    const std::string accepted = fmt::format("{}", fmt::join(image::exr_compressions, ", "));
    command
        .add_option_function<std::string>(
            "--compression",
            [&compression](const std::string& name) {
                compression = in_any_case(name, image::exr_compressions);
                if (std::ranges::find(image::exr_compressions, compression) == image::exr_compressions.end())
                    throw RequestError(
                        fmt::format("--compression '{}': {}", name, expected(name, image::exr_compressions)));
            },
            fmt::format("Lossless compression of the EXR. It helps where large parts of the picture are "
                        "equal, such as sky, but hardly with noise: {} [{}]",
                        accepted, compression))
        ->type_name("NAME");
}

int run(const Program& program, int argc, const char* const* argv) {
    system::prepare();
    try {
        return parse_and_work(program, argc, argv);
    } catch (const Interrupted& interrupted) {
        fail(program, 1, "interrupted; no half-written file was kept");
        system::end_by(interrupted.by);
    }
}

} // namespace gabor::cli
