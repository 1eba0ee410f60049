#include "viewer/app.hpp"

#include "error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gabor::viewer {

namespace {

// Prints one line on stderr.
int fail(int status, std::string message) {
    std::ranges::replace(message, '\n', ' ');
    fmt::print(stderr, "gabor-viewer: {}\n", message);
    return status;
}

Extent parse_size(const std::string& text) {
    int width = 0;
    int height = 0;
    int length = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &length) != 2 ||
        static_cast<std::size_t>(length) != text.size() || width < 480 || height < 320 || width > 16384 ||
        height > 16384)
        throw RequestError(
            fmt::format("--window '{}': expected WIDTHxHEIGHT, from 480x320 to 16384x16384", text));
    return {width, height};
}

// Makes glibc return memory that software drivers free on other threads. After two minutes of use, the viewer
// takes 184 MiB with these settings and 288 MiB without.
void return_memory() {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_TRIM_THRESHOLD, 1 << 17);
#endif
}

int run(int argc, char** argv, const App::FrameHook& hook) {
    return_memory();
    CLI::App app("Interactive viewer for Gabor noise", "gabor-viewer");
    app.set_version_flag("--version", "gabor-viewer " GABOR_VERSION);
    std::string preset;
    std::string size;
    Options options;
    app.add_option("FILE,--preset", preset,
                   "Open a JSON file of parameters, an EXR that gabor rendered, or a preset by name")
        ->type_name("FILE");
    app.add_option("--window", size, "Window size")->type_name("WIDTHxHEIGHT");
    app.add_option("--ui-scale", options.ui_scale,
                   "Scale of panels and text, relative to the desktop's [as in the last session]")
        ->type_name("NUMBER")
        ->check(CLI::Range(least_ui_scale, most_ui_scale));
    app.add_option("--device", options.device,
                   "Vulkan device: its index or part of its name [the fastest kind]")
        ->type_name("NAME");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
            return fail(2, fmt::format("{} (gabor-viewer --help lists what is accepted)", error.what()));
        app.exit(error);
        return 0;
    }
    options.preset = preset;
    if (!preset.empty())
        options.document = load_document(preset);
    if (!size.empty())
        options.size = parse_size(size);
    int signal = 0;
    {
        App viewer(options);
        signal = viewer.run(hook);
    }
    if (signal) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    if (const int messages = vulkan::validation_messages())
        return fail(1, fmt::format("{} message(s) from the validation layers", messages));
    return 0;
}

} // namespace

int run_viewer(int argc, char** argv, const App::FrameHook& hook) {
    try {
        return run(argc, argv, hook);
    } catch (const RequestError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}

} // namespace gabor::viewer
