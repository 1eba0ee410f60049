#include "render/output/texture.hpp"
#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/request.hpp"
#include "cli/terminal.hpp"
#include "vulkan/device.hpp"

#include <memory>

namespace gabor::cli {

namespace {

struct TextureOptions : RequestOptions {
    std::string output;
    std::optional<std::string> level;
    std::optional<std::string> frames;
    bool half = false;
    std::string device;
};

void render_textures(const TextureOptions& options) {
    system::note_interrupts();
    check_extension("-o", options.output, {".exr"}, false);
    if (options.level && options.half)
        throw RequestError("--half and --level cannot be combined: a level is written as a plain picture");
    Asked asked = asked_by(options);
    render::Request& request = asked.request;
    request.filter |= render::is_pattern(request.kind); // other kinds have no filter, and are refused below
    render::check(request);
    if (options.level) {
        const image::Rect whole{0, 0, request.width, request.height};
        render::check_texture(request, whole);
        const int last = render::drawn_levels(whole) - 1;
        request = render::texture_level(request,
                                        parse_integer("--level", *options.level, 0, last, " at this size"));
    }
    const image::Rect region = asked.region(options);
    if (!options.level)
        render::check_texture(request, region);
    const int frames = frames_of(options.frames);

    const vulkan::Device device(options.device);
    const std::uint64_t pixels = region.pixels() * static_cast<std::uint64_t>(frames);
    std::optional<Progress> progress(std::in_place, "rendering",
                                     options.level ? pixels : render::texture_pixels(pixels));
    const auto advance = [&](std::uint64_t done) { progress->advance(done); };
    for (int frame = 0; frame < frames; ++frame) {
        const render::Request now = render::frame_of(request, frame, frames);
        const std::filesystem::path path = render::frame_path(options.output, frame, frames);
        options.level ? render::render_file(device, now, region, {.exr = path, .png = {}}, advance)
                      : render::render_texture(device, now, region, path, options.half, advance);
        if (frame + 1 == frames)
            progress.reset();
        fmt::print("{}: {} x {} pixels, {}, on {}\n", path.string(), region.width, region.height,
                   subject(request), device.info().name);
    }
}

// Tells whether a parameter changes a filtered picture of a plane.
bool changes_textures(const render::Parameter& p) {
    const render::Request noise, fractal{.kind = render::Kind::fractal},
        material{.kind = render::Kind::material};
    return p.name != "filter" && (p.scope.holds(noise) || p.scope.holds(fractal) || p.scope.holds(material));
}

} // namespace

void add_texture_command(CLI::App& app) {
    auto options = std::make_shared<TextureOptions>();
    CLI::App* command =
        app.add_subcommand("texture", "Render noise or a material as a texture with filtered mip levels");
    command->footer(R"(
Example:
  gabor texture --tileable --size 512 --scale 32 --frequency 2 -o bark.exr

`gabor materials NAME` lists the options of a material.
)");
    begin_group(*command, "Output");
    add_option(*command, "-o,--output", options->output, "FILE",
               "Output: NAME.exr, in tiles, as renderers expect; both sides must be powers of two")
        ->required();
    add_source_options(*command, *options, render::parameter("width").range.high, "1024x1024");
    add_region_option(*command, *options);
    add_option(*command, "--level", options->level, "NUMBER",
               "Render only this mip level, as a plain picture for `gabor join --texture`; 0 is the largest");
    command->add_flag("--half", options->half, "Store 16-bit floats");
    add_frames_option(*command, options->frames);
    add_device_option(*command, options->device);
    using Group = render::Parameter::Group;
    for (const auto& [title, group] : {std::pair("Noise", Group::noise),
                                       {"View and light", Group::view},
                                       {"View and light", Group::light},
                                       {"", Group::material},
                                       {"", Group::boards},
                                       {"", Group::coat},
                                       {"", Group::finish}})
        add_group(*command, *options, title, group, *title ? changes_textures : nullptr);
    command->get_option("--view")->description(
        "Only flat, which overrides the view of --preset or --like [flat]");
    command->callback([options] { render_textures(*options); });
}

} // namespace gabor::cli
