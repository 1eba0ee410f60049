#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "render/output/texture.hpp"

#include <filesystem>
#include <memory>

namespace gabor::cli {

namespace {

struct JoinOptions {
    std::vector<std::filesystem::path> regions;
    std::string output;
    bool texture = false;
    bool half = false;
};

image::Rect join_picture(const JoinOptions& options, const image::Advance& advance) {
    image::ExrReader reader(std::span(options.regions));
    const image::ExrHeader& header = reader.header();
    image::ExrWriter writer(options.output, header);
    reader.read_bands([&](std::span<const float> band) {
        writer.write_rows(band);
        advance(band.size() / header.channels.size());
    });
    writer.commit();
    return header.picture;
}

void join(const JoinOptions& options) {
    if (options.half && !options.texture)
        throw RequestError("--half requires --texture: plain pictures have 32-bit floats");
    check_extension("-o", options.output, {".exr"}, false);
    std::uint64_t pixels = 0;
    for (const std::filesystem::path& region : options.regions) {
        std::error_code ignored;
        if (std::filesystem::equivalent(region, options.output, ignored))
            throw RequestError(fmt::format("cannot join: -o '{}' is one of the regions; choose another file",
                                           options.output));
        pixels += image::ExrReader(region).header().window.pixels();
    }
    system::note_interrupts();
    Progress progress("joining", pixels);
    const auto advance = [&](std::uint64_t done) { progress.advance(done); };
    const image::Rect picture =
        options.texture ? render::join_texture(options.regions, options.output, options.half, advance)
                        : join_picture(options, advance);
    const std::size_t count = options.regions.size();
    fmt::print("{}: {} x {} pixels, from {} region{}\n", options.output, picture.width, picture.height, count,
               count == 1 ? "" : "s");
}

} // namespace

void add_join_command(CLI::App& app) {
    auto options = std::make_shared<JoinOptions>();
    CLI::App* command =
        app.add_subcommand("join", "Join regions of one picture, as a single render would write it");
    add_option(*command, "REGION", options->regions, "FILE",
               "EXR files of `gabor render --region`, in any order")
        ->required();
    add_option(*command, "-o,--output", options->output, "FILE", "The EXR of the whole picture")->required();
    command->add_flag("--texture", options->texture,
                      "Assemble a texture from levels rendered by `gabor texture --level`");
    command->add_flag("--half", options->half, "Store the texture as 16-bit floats");
    command->callback([options] { join(*options); });
}

} // namespace gabor::cli
