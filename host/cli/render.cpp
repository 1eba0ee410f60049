#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/request.hpp"
#include "cli/terminal.hpp"
#include "render/output/file.hpp"
#include "vulkan/device.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace gabor::cli {

namespace {

struct RenderOptions : RequestOptions {
    std::optional<std::string> output;
    std::optional<std::string> png;
    std::optional<std::string> frames;
    std::string compression = "none";
    std::string device;
    std::optional<std::string> heightmap;
    std::optional<std::string> elevation;
    bool full_range = false;
};

void warn_above_nyquist(const render::Request& request) {
    if (request.filter || request.kind != render::Kind::noise ||
        request.view.projection != render::Projection::flat || !request.paint.empty())
        return;
    double highest = 0;
    for (const noise::Lobe& lobe : request.lobes) {
        const double along = lobe.orientation_spread > 0 ? 1
                                                         : std::max(std::abs(std::cos(lobe.angle())),
                                                                    std::abs(std::sin(lobe.angle())));
        highest = std::max(highest, lobe.frequency * (1 + lobe.frequency_spread) * along / request.scale);
    }
    if (highest > 0.5)
        fmt::print(
            stderr,
            "gabor: warning: the frequency is {:.3g} cycles per pixel; above 0.5, waves alias to lower "
            "frequencies. --filter removes them\n",
            highest);
}

// Tells whether two paths name the same file, even if it does not exist yet.
bool same_file(const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path here = fs::current_path();
    return fs::weakly_canonical(here / a, ignored) == fs::weakly_canonical(here / b, ignored);
}

// The output files of -o, --png and --write-heightmap.
render::Files files_of(const RenderOptions& options) {
    using Output = std::pair<const char*, const std::optional<std::string>&>;
    const std::array outputs{Output{"-o", options.output}, Output{"--png", options.png},
                             Output{"--write-heightmap", options.heightmap}};
    for (const auto& [name, path] : outputs)
        for (const auto& [other_name, other] : outputs)
            if (&path != &other && path && other && same_file(*path, *other))
                throw RequestError(fmt::format("{} and {} both name '{}': give two different files", name,
                                               other_name, *path));
    if ((options.elevation || options.full_range) && !options.heightmap)
        throw RequestError(
            fmt::format("{} requires --write-heightmap", options.elevation ? "--elevation" : "--full-range"));
    if (options.elevation && options.full_range)
        throw RequestError("--elevation and --full-range exclude each other");

    render::Files files;
    if (options.output) {
        const bool png = check_extension("-o", *options.output, {".exr", ".png"}, false) == ".png";
        (png ? files.png : files.exr) = *options.output;
    }
    if (options.png) {
        if (files.png)
            throw RequestError("-o and --png both name a PNG: use -o for the EXR");
        check_extension("--png", *options.png, {".png"}, false);
        files.png = *options.png;
    }
    if (options.heightmap) {
        files.heightmap = *options.heightmap;
        check_extension("--write-heightmap", *files.heightmap,
                        {render::height_extensions.begin(), render::height_extensions.end()}, true);
        check_height_options(*files.heightmap, options.full_range, options.compression,
                             files.exr.has_value());
    }
    if (options.elevation) {
        files.elevation = parse_elevation(*options.elevation);
        if (!render::is_16_bit(*files.heightmap))
            throw RequestError(
                fmt::format("--elevation is for 16-bit heights: '{}' has floats", files.heightmap->string()));
    }
    files.full_range = options.full_range;
    if (!files.exr && !files.heightmap && options.compression != "none")
        throw RequestError("--compression requires an EXR");
    files.compression = options.compression;
    return files;
}

// Refuses options that only add channels to an EXR, if none is written.
void check_channels(const RenderOptions& options, const render::Files& files) {
    for (const auto& [parameter, value] : given_values(options.parameters))
        if (!files.exr && (parameter->name == "gradient" || parameter->name == "phasor") &&
            value == render::Value(true))
            throw RequestError(
                fmt::format("{} adds channels to an EXR, and a PNG does not have them: give -o "
                            "NAME.exr, and --png NAME.png for the picture",
                            render::option_name(*parameter)));
}

void render_pictures(const RenderOptions& options) {
    system::note_interrupts();
    if (!options.output && !options.png && !options.heightmap)
        throw RequestError("--output is missing: give -o FILE");
    const Asked asked = asked_by(options);
    render::check(asked.request);
    const image::Rect region = asked.region(options);
    const render::Files files = files_of(options);
    const int frames = frames_of(options.frames);
    check_channels(options, files);
    warn_above_nyquist(asked.request);

    const vulkan::Device device(options.device);
    const std::uint64_t pixels = region.pixels() * static_cast<std::uint64_t>(frames);
    std::optional<Progress> progress(std::in_place, "rendering", pixels);
    for (int frame = 0; frame < frames; ++frame) {
        const render::Request request = render::frame_of(asked.request, frame, frames);
        render::Files here = files;
        for (std::optional<std::filesystem::path>* path : {&here.exr, &here.png, &here.heightmap})
            if (*path)
                *path = render::frame_path(**path, frame, frames);
        render::render_file(device, request, region, here,
                            [&](std::uint64_t done) { progress->advance(done); });
        if (frame + 1 == frames)
            progress.reset();
        fmt::print("{}: {} x {} pixels, {}, on {}\n",
                   (here.exr   ? *here.exr
                    : here.png ? *here.png
                               : *here.heightmap)
                       .string(),
                   region.width, region.height, subject(request), device.info().name);
    }
}

} // namespace

void add_render_command(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "Render noise, a material, terrain or a sea to OpenEXR or PNG");
    command->footer(R"(
Examples:
  gabor render --scale 32 --frequency 8 --orientation 30deg -o stripes.png
  gabor render --material wood --wood.rings 20 --view torus --png torus.png
  gabor render --view terrain --preset canyon --png canyon.png --write-heightmap canyon.r16

`gabor materials NAME` lists the options of a material, and `gabor erode --help` those of a
terrain's erosion. --no-FLAG turns off a flag of the noise or the view, as in --no-tileable.
)");
    const auto option = [&](const std::string& name, auto& value, const std::string& type,
                            const std::string& help) { add_option(*command, name, value, type, help); };
    const auto parameters = [&](const std::string& title, render::Parameter::Group group) {
        add_group(*command, *options, title, group);
    };

    begin_group(*command, "Output");
    option("-o,--output", options->output, "FILE",
           "Output: NAME.exr, with the noise as 32-bit floats in channel Y, or NAME.png, in which black and "
           "white are -2 and 2 standard deviations");
    option("--png", options->png, "FILE", "Also write a PNG");
    add_source_options(*command, *options, render::parameter("width").range.high, "1024x1024");
    add_region_option(*command, *options);
    add_frames_option(*command, options->frames);
    add_compression_option(*command, options->compression);
    add_device_option(*command, options->device);

    parameters("Noise", render::Parameter::Group::noise);
    parameters("View and light", render::Parameter::Group::view);
    parameters("View and light", render::Parameter::Group::light);
    parameters("Terrain", render::Parameter::Group::terrain);
    option("--write-heightmap", options->heightmap, "FILE",
           "Also write the heights to this file: 16 bits in a PNG, .r16 or .raw, floats in an EXR, TIFF or "
           ".r32; beside all but a TIFF, a .json file gives the scale (for the terrain view)");
    add_elevation_option(*command, options->elevation, "the full possible range");
    add_full_range_option(*command, options->full_range);
    parameters("Ocean", render::Parameter::Group::sea);
    for (const auto group :
         {render::Parameter::Group::erosion, render::Parameter::Group::material,
          render::Parameter::Group::boards, render::Parameter::Group::coat, render::Parameter::Group::finish})
        parameters("", group); // `gabor erode` and `gabor materials` list them
    for (const auto& [name, other] :
         {std::pair("--maps", "maps"), {"--texture", "texture"}, {"--level", "texture"}})
        command
            ->add_option_function<std::vector<std::string>>(
                name,
                [=](const auto&) {
                    throw RequestError(
                        fmt::format("{} is of another command: see gabor {} --help", name, other));
                })
            ->expected(0, 1);
    command->callback([options] { render_pictures(*options); });
}

} // namespace gabor::cli
