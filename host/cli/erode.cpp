#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/picture.hpp"
#include "render/erosion.hpp"
#include "render/heightmap.hpp"
#include "render/load.hpp"
#include "vulkan/device.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace gabor::cli {

namespace {

using render::has_extension;

constexpr int most_side = 16384;
constexpr double preset_hill = 4; // the width of the hills that presets are designed for

std::vector<std::string_view> terrain_presets() {
    std::vector<std::string_view> names = render::preset_names();
    std::erase_if(names, [](std::string_view name) { return !render::has_terrain(render::preset(name)); });
    return names;
}

struct ErodeOptions {
    std::filesystem::path map;
    std::filesystem::path output;
    std::optional<std::string> size;
    std::optional<std::string> region;
    std::vector<double> elevation;
    double extent = 2 * preset_hill;
    std::string preset = "alps";
    ParameterOptions gullies; // these override those of the preset
    std::uint32_t seed = 0;
    bool tileable = false;
    std::string device;
};

// Returns the parameters of the gullies for hills that are `hill` wide.
render::Erosion erosion_of(const ErodeOptions& options, double hill) {
    const std::vector<std::string_view> names = terrain_presets();
    if (std::ranges::find(names, options.preset) == names.end())
        refuse("--preset", options.preset, fmt::format("{}", fmt::join(names, ", ")));
    render::Request request = render::preset(options.preset);
    std::get<render::Terrain>(request.view).erosion.frequency *= preset_hill / hill;
    render::set(request, given_values(options.gullies));
    return std::get<render::Terrain>(request.view).erosion;
}

render::HeightMap map_of(const ErodeOptions& options) {
    const bool raw = has_extension(options.map, ".r16");
    if (raw != options.size.has_value())
        throw RequestError(raw ? "a .r16 file has no header: give its WIDTHxHEIGHT with --size"
                               : "--size is for .r16 files: other files store their size");
    std::array<int, 2> size{};
    if (raw) {
        constexpr std::string_view accepted = "WIDTHxHEIGHT, each at least 1";
        size = parse_integers<2>("--size", *options.size, 'x', accepted);
        if (std::min(size[0], size[1]) < 1)
            refuse("--size", *options.size, accepted);
    }
    const auto open = [path = options.map, raw, size] {
        return raw ? image::open_raw16(path, size[0], size[1]) : image::open_picture(path, "height");
    };
    const image::PictureReader::Format format = open()->format();
    if (format.channels != 1)
        throw RequestError(
            fmt::format("'{}' is in colour: a heightmap has one channel", options.map.string()));
    if (std::max(format.width, format.height) > most_side)
        throw RequestError(fmt::format("'{}' has {} x {} pixels; at most {} per side are supported",
                                       options.map.string(), format.width, format.height, most_side));
    return {.open = open,
            .width = format.width,
            .height = format.height,
            .pixel = options.extent / format.width,
            .tileable = options.tileable};
}

void erode(const ErodeOptions& options) {
    if (!(options.extent > 0 && options.extent < 1e9))
        throw RequestError(
            fmt::format("--extent {}: expected the width of the map, above 0 and below 1e9", options.extent));
    const bool to_exr = has_extension(options.output, ".exr");
    if (!to_exr && !has_extension(options.output, ".png") && !has_extension(options.output, ".r16"))
        refuse("-o", options.output.string(), "a file name that ends in .exr, .png or .r16");
    std::error_code ignored;
    if (std::filesystem::equivalent(options.map, options.output, ignored))
        throw RequestError(
            fmt::format("-o '{}' is the map itself; give another file", options.output.string()));
    const render::Erosion erosion = erosion_of(options, options.extent / 2);
    render::HeightMap map = map_of(options);
    const image::Rect whole{0, 0, map.width, map.height};
    const image::Rect region = options.region ? parse_region(*options.region) : whole;
    check_within(region, map.width, map.height, "--region", "map");

    const bool floats = has_extension(options.map, ".exr");
    if (floats && !to_exr && options.elevation.empty())
        throw RequestError("an EXR has no range of heights: use --elevation LOW,HIGH to set the heights that "
                           "become 0 and 65535 in 16 bits");
    const render::Elevation elevation = options.elevation.empty()
                                            ? render::Elevation{0, options.extent / 8}
                                            : render::Elevation{options.elevation[0], options.elevation[1]};
    if (!(elevation.low < elevation.high && std::isfinite(elevation.high - elevation.low)))
        throw RequestError("--elevation takes LOW,HIGH, the lower height first");
    if (!floats) {
        map.scale = elevation.high - elevation.low;
        map.offset = elevation.low;
    }
    // Erosion changes a height by at most `reach`, so the eroded heights lie in this range.
    const double reach = render::erosion_reach(erosion) * erosion.gully_weight;
    const render::Elevation range{elevation.low - reach, elevation.high + reach};

    note_interrupts();
    const vulkan::Device device(options.device);
    std::optional<image::ExrWriter> exr;
    std::optional<render::HeightWriter> heights;
    if (to_exr)
        exr.emplace(options.output, image::ExrHeader{.picture = whole,
                                                     .window = region,
                                                     .channels = {render::erosion_channels.begin(),
                                                                  render::erosion_channels.end()}});
    else
        heights.emplace(options.output, region, range, map.pixel);
    {
        Progress progress("eroding", region.pixels());
        render::erode(device, map, erosion, options.seed, region, [&](std::span<const float> rows) {
            if (exr)
                exr->write_rows(rows);
            else
                heights->write_rows(rows, render::erosion_channels.size(), 0);
            progress.advance(rows.size() / render::erosion_channels.size());
        });
    }
    if (exr)
        exr->commit();
    else
        heights->commit();
    fmt::print("{}: {} x {} pixels, on {}\n", options.output.string(), region.width, region.height,
               device.info().name);
}

} // namespace

void add_erode_command(CLI::App& app) {
    auto options = std::make_shared<ErodeOptions>();
    CLI::App* command = app.add_subcommand("erode", "Add gullies and ridges to a heightmap");
    add_option(*command, "MAP", options->map, "FILE", "EXR with heights, 16-bit PNG, or .r16 with --size")
        ->required();
    add_option(*command, "-o,--output", options->output, "FILE",
               "EXR with height, slope, ridge and erosion; or 16-bit heights in a PNG or .r16, with their "
               "scale in a .json file beside it")
        ->required();
    add_option(*command, "--size", options->size, "SIZE", "WIDTHxHEIGHT of a .r16 file");
    add_option(*command, "--region", options->region, "RECTANGLE",
               "X,Y,WIDTH,HEIGHT: write only this part of the eroded map");
    add_option(*command, "--extent", options->extent, "NUMBER",
               "Width of the map, in the same unit as its heights [8]");
    add_elevation_option(
        *command, options->elevation,
        "LOW,HIGH: heights that 0 and 65535 stand for in 16-bit files [0 and an eighth of --extent]");
    add_option(*command, "--preset", options->preset, "NAME",
               fmt::format("Shape of the gullies: {} [alps]", fmt::join(terrain_presets(), ", ")));
    for (const render::Parameter* p : render::erosion_parameters())
        options->gullies.emplace_back(p, command->add_option(render::option_name(*p))
                                             ->type_name("NUMBER")
                                             ->description(std::string(p->help)));
    add_option(*command, "--seed", options->seed, "NUMBER", "Seed; each seed gives different gullies [0]");
    command->add_flag("--tileable", options->tileable, "The map tiles without seams, and so does the output");
    add_device_option(*command, options->device);
    command->callback([options] { erode(*options); });
}

} // namespace gabor::cli
