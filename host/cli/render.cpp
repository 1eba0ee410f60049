#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "render/output/file.hpp"
#include "render/output/maps.hpp"
#include "render/output/texture.hpp"
#include "render/request/load.hpp"
#include "vulkan/device.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace gabor::cli {

namespace {

// The command-line options. Values that are not given come from --like or --preset, or are defaults.
struct RenderOptions {
    std::optional<std::string> output;
    std::optional<std::string> png;
    std::optional<std::string> maps;
    bool directx = false;
    std::optional<std::string> normal_bits;
    std::optional<std::string> metres;
    std::optional<std::string> size;
    std::optional<std::string> region;
    std::optional<std::string> like;
    std::optional<std::string> preset;
    std::optional<std::string> frames;
    std::optional<std::string> level;
    std::string compression = "none";
    std::string device;
    std::optional<std::string> heightmap;
    std::optional<std::string> elevation;
    bool texture = false;
    bool half = false;
    ParameterOptions parameters; // all but width and height, which are in `size`
};

struct Work {
    render::Request request;
    image::Rect region;
    bool scaled = false; ///< whether an option, a preset or another file sets the scale
    int side = 0;        ///< shorter side of the picture, before options change it
};

// Returns the parameters that the options set, including --size.
render::Values values_of(const RenderOptions& options) {
    render::Values values = given_values(options.parameters);
    if (options.size) {
        const render::Parameter& width = render::parameter("width");
        const auto sides = parse_size(*options.size, static_cast<int>(width.range.high));
        values.emplace_back(&width, static_cast<double>(sides[0]));
        values.emplace_back(&render::parameter("height"), static_cast<double>(sides[1]));
    }
    return values;
}

Work make_work(const RenderOptions& options) {
    Work work;
    std::optional<image::Rect> region;
    if (options.preset && options.like)
        throw RequestError(
            "--preset and --like cannot be combined: each sets all options that are not given");
    if (options.preset)
        work.request = render::preset(*options.preset);
    if (options.like) {
        render::Loaded like = with_prefix("--like: ", [&] { return render::load_request(*options.like); });
        work.request = std::move(like.request);
        if (!options.size)
            region = like.region;
    }
    work.side = std::min(work.request.width, work.request.height);
    const render::Values given = values_of(options);
    render::set(work.request, given, render::option_name);
    work.scaled = options.preset || options.like ||
                  std::ranges::any_of(given, [](const auto& value) { return value.first->name == "scale"; });
    if (work.request.kind == render::Kind::terrain && !work.scaled) // show two hills
        work.request.scale = std::max(work.request.width / 8.0, render::parameter("scale").range.low);
    // Mip levels are filtered. Terrain, which has no filter, is refused below.
    work.request.filter |= (options.texture || options.level) && render::is_pattern(work.request.kind);
    render::check(work.request);
    if (options.level) {
        const image::Rect whole{0, 0, work.request.width, work.request.height};
        render::check_texture(work.request, whole);
        const int last = render::drawn_levels(whole) - 1;
        work.request = render::texture_level(
            work.request, parse_integer("--level", *options.level, 0, last, " at this size"));
    }
    if (options.region)
        region = parse_region(*options.region);
    work.region = region.value_or(image::Rect{0, 0, work.request.width, work.request.height});
    check_within(work.region, work.request.width, work.request.height,
                 options.region ? "--region"
                                : fmt::format("--like '{}': its region", options.like.value_or("")),
                 "picture");
    if (options.texture)
        render::check_texture(work.request, work.region);
    return work;
}

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
    if (options.elevation && !options.heightmap)
        throw RequestError("--elevation requires --write-heightmap");

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
    if (options.heightmap)
        files.heightmap = *options.heightmap;
    if (options.elevation)
        files.elevation = parse_elevation(*options.elevation);
    if (options.texture && options.level)
        throw RequestError("--texture and --level cannot be combined: a level is written as a plain picture");
    if (options.texture && options.compression != "none")
        throw RequestError(
            "--compression cannot be combined with --texture, which programs read tile by tile");
    if (!files.exr && options.compression != "none")
        throw RequestError("--compression requires an EXR");
    files.compression = options.compression;
    if (options.texture && (files.png || files.heightmap))
        throw RequestError("--texture cannot be combined with a PNG or a heightmap: a texture is an EXR");
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

// What was drawn, as in "material wood".
std::string subject(const render::Request& request) {
    switch (request.kind) {
    case render::Kind::terrain:
        return "terrain";
    case render::Kind::sea:
        return "ocean";
    case render::Kind::material:
        return "material " + request.material;
    case render::Kind::noise:
        break;
    }
    return fmt::format("recipe {}", render::drawing_recipe(request).name);
}

// Renders a set of maps. Unless a scale is given, the shorter side spans 4 units of a material, 8 of terrain.
// They tile and have sides of map_side, unless options or a file to reproduce say otherwise.
void render_map_set(const RenderOptions& options) {
    if (options.output || options.png || options.heightmap || options.elevation || options.region ||
        options.frames || options.level)
        throw RequestError(
            "--maps writes a whole set of maps: it cannot be combined with -o, --png, --write-heightmap, "
            "--elevation, --region, --frames or --level");
    const std::string bits = options.normal_bits.value_or("16");
    if (bits != "8" && bits != "16")
        refuse("--normal-bits", bits, "8 or 16");
    render::MapFormat format{options.directx, options.texture, options.half, bits == "8" ? 8 : 16};
    format.compression = options.compression;
    if (options.metres)
        format.metres = parse_positive("--width-metres", *options.metres, "a width above 0");
    Work work = make_work(options);
    const render::Values given = given_values(options.parameters);
    const auto gives = [&](std::string_view name) {
        return std::ranges::any_of(given, [&](const auto& value) { return value.first->name == name; });
    };
    render::Request& request = work.request;
    request = render::from_above(request);
    render::check_maps(request);
    if (!options.size && !options.like)
        request.width = request.height = render::map_side;
    if (options.preset && !gives("scale")) // as much as the preset's picture shows
        request.scale *= static_cast<double>(std::min(request.width, request.height)) / work.side;
    const bool terrain = request.kind == render::Kind::terrain;
    if (!work.scaled)
        request.scale = std::max(2.0, std::min(request.width, request.height) / (terrain ? 8.0 : 4.0));
    if (!options.like && !gives("tileable"))
        render::make_tile(request);
    render::check(request);
    request.filter = !terrain;
    const vulkan::Device device(options.device);
    {
        Progress progress("rendering", image::Rect{0, 0, request.width, request.height}.pixels());
        render::render_maps(device, request, *options.maps, format,
                            [&](std::uint64_t done) { progress.advance(done); });
    }
    fmt::print("{}: maps of {} x {} pixels, {}, on {}\n", *options.maps, request.width, request.height,
               subject(request), device.info().name);
}

void render_pictures(const RenderOptions& options) {
    note_interrupts();
    if (options.half && !options.texture)
        throw RequestError("--half requires --texture: plain pictures have 32-bit floats");
    if (options.maps)
        return render_map_set(options);
    if (!options.output && !options.png && !options.heightmap)
        throw RequestError("--output is missing: give -o FILE, or --maps FOLDER for a material or terrain");
    for (const auto& [name, given] : {std::pair{"--directx", options.directx},
                                      {"--normal-bits", options.normal_bits.has_value()},
                                      {"--width-metres", options.metres.has_value()}})
        if (given)
            throw RequestError(fmt::format("{} requires --maps", name));
    const Work work = make_work(options);
    const image::Rect& region = work.region;
    const render::Files files = files_of(options);
    const int frames =
        options.frames ? parse_integer("--frames", *options.frames, 1, render::most_frames) : 1;
    check_channels(options, files);
    warn_above_nyquist(work.request);

    const vulkan::Device device(options.device);
    const std::uint64_t pixels = region.pixels() * static_cast<std::uint64_t>(frames);
    std::optional<Progress> progress(std::in_place, "rendering",
                                     options.texture ? render::texture_pixels(pixels) : pixels);
    for (int frame = 0; frame < frames; ++frame) {
        const render::Request request = render::frame_of(work.request, frame, frames);
        render::Files here = files;
        for (std::optional<std::filesystem::path>* path : {&here.exr, &here.png, &here.heightmap})
            if (*path)
                *path = render::frame_path(**path, frame, frames);
        const auto advance = [&](std::uint64_t done) { progress->advance(done); };
        options.texture ? render::render_texture(device, request, region, *here.exr, options.half, advance)
                        : render::render_file(device, request, region, here, advance);
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
  gabor render --material wood --wood.rings 20 --width-metres 0.5 --maps wood
  gabor render --view terrain --preset canyon --png canyon.png --write-heightmap canyon.r16

`gabor materials NAME` lists the options of a material, and `gabor erode --help` those of a
terrain's erosion. --no-FLAG takes back a flag of the noise or the view, as in --no-tileable.
)");
    const render::Request defaults;
    const auto option = [&](const std::string& name, auto& value, const std::string& type,
                            const std::string& help) { add_option(*command, name, value, type, help); };
    const auto parameters = [&](const std::string& title, render::Parameter::Group group) {
        begin_group(*command, title);
        for (const render::Parameter& p : render::parameters())
            if (p.group == group)
                add_parameter(*command, options->parameters, p, defaults);
    };

    begin_group(*command, "Output");
    option("-o,--output", options->output, "FILE",
           "Output: NAME.exr, with the noise as 32-bit floats in channel Y, or NAME.png, in which black and "
           "white are -2 and 2 standard deviations");
    option("--png", options->png, "FILE", "Also write a PNG");
    option("--size", options->size, "WIDTHxHEIGHT",
           fmt::format("Size of the picture in pixels, up to {0} x {0} [{1}x{2}]",
                       render::parameter("width").range.high, defaults.width, defaults.height));
    option("--region", options->region, "X,Y,WIDTH,HEIGHT",
           "Render only this part of the picture; its pixels equal those of a full render [all of it]");
    option("--preset", options->preset, "NAME",
           fmt::format("Take all other options from a preset: {}, or a file NAME.json from gabor fit",
                       fmt::join(render::preset_names(), ", ")));
    option("--like", options->like, "FILE", "Take all other options from an earlier EXR or a JSON file");
    option("--frames", options->frames, "NUMBER",
           fmt::format(
               "Render one period of the animation, or one loop of a sea, in this many frames, from 1 to {}; "
               "those of an endless sea are 1/25 s apart: "
               "NAME.0001.exr, NAME.0002.exr ... [1]",
               render::most_frames));
    add_compression_option(*command, options->compression);
    add_device_option(*command, options->device);

    parameters("Noise", render::Parameter::Group::noise);
    parameters("View and light", render::Parameter::Group::view);
    parameters("View and light", render::Parameter::Group::light);
    parameters("Terrain", render::Parameter::Group::terrain);
    option(
        "--write-heightmap", options->heightmap, "FILE",
        "Also write 16-bit heights to this PNG or .r16, with their scale in a .json file beside it (for the "
        "terrain view)");
    add_elevation_option(*command, options->elevation, "the full possible range");
    parameters("Ocean", render::Parameter::Group::sea);

    begin_group(*command, "Textures");
    option("--maps", options->maps, "FOLDER",
           fmt::format(
               "Instead of -o: write the maps of a material or of terrain to this folder: PNGs of base "
               "colour, normals, height, roughness, metalness and occlusion, one EXR with all of them, and "
               "material.mtlx, material.gltf and material.json. They tile, and are {0}x{0}, unless "
               "--no-tileable, --size or --like says otherwise",
               render::map_side));
    option("--width-metres", options->metres, "NUMBER",
           "With --maps: their width, to scale the heights too; otherwise a terrain's extent, or 1");
    command->add_flag("--directx", options->directx, "With --maps: also write normals for DirectX");
    option("--normal-bits", options->normal_bits, "BITS",
           "With --maps: 8 dithers normals to 8 bits, for programs that do not read all 16");
    command->add_flag(
        "--texture", options->texture,
        "Write a tiled, mip-mapped texture for renderers, filtered at every level; both sides must be powers "
        "of two. With --maps: write maps.exr as such a texture, with more roughness where its normals are "
        "averaged");
    command->add_flag("--half", options->half, "Store the texture as 16-bit floats");
    option("--level", options->level, "NUMBER",
           "Render only this mip level of the texture, for `gabor join --texture`; 0 is the largest");

    for (const auto group : {render::Parameter::Group::erosion, render::Parameter::Group::material,
                             render::Parameter::Group::boards})
        parameters("", group); // `gabor erode` and `gabor materials` list them
    command->callback([options] { render_pictures(*options); });
}

} // namespace gabor::cli
