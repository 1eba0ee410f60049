#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gabor::cli {

namespace {

struct JoinOptions {
    std::vector<std::string> regions;
    std::string output;
};

void join(const JoinOptions& options) {
    const std::vector<std::filesystem::path> paths(options.regions.begin(), options.regions.end());
    note_interrupts();
    const image::Window picture = image::ExrReader(paths.front()).picture();
    Progress progress("joining",
                      static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height));
    image::join_exr(paths, options.output, [&](std::uint64_t pixels) {
        check_interrupt();
        progress.advance(pixels);
    });
    fmt::print("{}: {} x {} pixels, from {} regions\n", options.output, picture.width, picture.height,
               paths.size());
}

} // namespace

void add_join_command(CLI::App& app) {
    auto options = std::make_shared<JoinOptions>();
    CLI::App* command =
        app.add_subcommand("join", "Put regions of one picture together, exactly as if rendered at once");
    command->add_option("REGION", options->regions, "EXR files of `gabor render --region`, in any order")
        ->type_name("FILE")
        ->required();
    command->add_option("-o,--output", options->output, "The EXR of the whole picture")
        ->type_name("FILE")
        ->required();
    command->callback([options] { join(*options); });
}

} // namespace gabor::cli
