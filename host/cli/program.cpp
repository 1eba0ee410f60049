#include "cli/program.hpp"

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "error.hpp"
#include "vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

namespace gabor::cli {

namespace {

// One line on stderr, whatever the message holds: names from files may hold control characters.
int fail(int status, std::string message) {
    std::ranges::replace_if(
        message, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    std::fputs(fmt::format("gabor: {}\n", message).c_str(),
               stderr); // if nobody reads it, the status still tells
    return status;
}

int parse_and_work(int argc, const char* const* argv) {
    CLI::App app("Renders Gabor noise, and measures it.", "gabor");
    app.set_version_flag("--version", "gabor " GABOR_VERSION);
    app.option_defaults()->disable_flag_override(); // --verbose=3 is no flag
    app.require_subcommand(0, 1);                   // with 1, CLI11 would not say which word it does not know
    add_render_command(app);
    add_stats_command(app);
    add_bench_command(app);
    add_study_command(app);
    add_devices_command(app);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty())
            throw RequestError("a subcommand is required (gabor --help lists what is accepted)");
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
            return fail(2, fmt::format("{} (gabor --help lists what is accepted)", error.what()));
        app.exit(error); // prints what --help and --version ask for
    } catch (const RequestError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        return fail(1, "cannot write to the standard output");
    if (const int messages = vulkan::validation_messages())
        return fail(1, fmt::format("{} message(s) from the validation layers", messages));
    return 0;
}

} // namespace

int run(int argc, const char* const* argv) {
    try {
        return parse_and_work(argc, argv);
    } catch (const Interrupted& interrupted) {
        fail(1, "interrupted; nothing half-done was kept");
        // End as the signal would have, so that shells and queues see why.
        std::signal(interrupted.signal, SIG_DFL);
        std::raise(interrupted.signal);
        return 1;
    }
}

} // namespace gabor::cli
