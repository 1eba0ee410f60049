#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "error.hpp"
#include "image/exr.hpp"
#include "image/raw16.hpp"
#include "render/erosion.hpp"
#include "render/heightmap.hpp"
#include "render/load.hpp"
#include "render/parameters.hpp"
#include "vulkan/device.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gabor::cli {

namespace {

using render::has_extension;

constexpr int most_side = 16384;
constexpr double preset_hill = 4; // the width of the hills that presets are designed for

// The options for gullies: a preset, and single parameters that override it.
struct GullyOptions {
    std::string preset = "alps";
    std::vector<std::string> members; // values in the order of render::erosion_parameters; empty if not given

    void add_to(CLI::App& command);
    // Returns gullies for hills that are `hill` wide. Throws RequestError for an unknown preset or a number
    // out of range.
    render::Erosion erosion(double hill) const;
};

std::vector<std::string_view> terrain_presets() {
    std::vector<std::string_view> names = render::preset_names();
    std::erase_if(names, [](std::string_view name) { return !render::has_terrain(render::preset(name)); });
    return names;
}

void GullyOptions::add_to(CLI::App& command) {
    command
        .add_option("--preset", preset,
                    fmt::format("Shape of the gullies: {} [alps]", fmt::join(terrain_presets(), ", ")))
        ->type_name("NAME");
    const auto parameters = render::erosion_parameters();
    members.resize(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i)
        command.add_option(render::option_name(*parameters[i]), members[i], std::string(parameters[i]->help))
            ->type_name("NUMBER");
}

render::Erosion GullyOptions::erosion(double hill) const {
    const std::vector<std::string_view> names = terrain_presets();
    if (std::ranges::find(names, preset) == names.end())
        throw RequestError(fmt::format("--preset '{}': expected {}", preset, fmt::join(names, ", ")));
    render::Request request = render::preset(preset);
    std::get<render::Terrain>(request.view).erosion.frequency *= preset_hill / hill;
    const auto parameters = render::erosion_parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (!members[i].empty())
            with_prefix(render::option_name(*parameters[i]) + ' ', [&] {
                render::set(request, parameters[i]->name, render::read(*parameters[i], members[i]));
            });
    return std::get<render::Terrain>(request.view).erosion;
}

struct ErodeOptions {
    std::filesystem::path map;
    std::filesystem::path output;
    std::vector<int> size;
    std::vector<int> region;
    std::vector<double> elevation;
    double extent = 2 * preset_hill;
    GullyOptions gullies;
    std::uint32_t seed = 0;
    bool tileable = false;
    std::string device;
};

render::HeightMap map_of(const ErodeOptions& options) {
    render::HeightMap map;
    const bool raw = has_extension(options.map, ".r16");
    if (raw != !options.size.empty())
        throw RequestError(raw ? "a .r16 file has no header: give its WIDTHxHEIGHT with --size"
                               : "--size is for .r16 files: other files store their size");
    if (raw && (options.size[0] < 1 || options.size[1] < 1))
        throw RequestError("--size takes WIDTHxHEIGHT, each at least 1");
    map.open = [options] {
        return has_extension(options.map, ".r16")
                   ? image::open_raw16(options.map, options.size[0], options.size[1])
                   : image::open_picture(options.map, "height");
    };
    const image::PictureReader::Format format = map.open()->format();
    if (format.channels != 1)
        throw RequestError(
            fmt::format("'{}' is in colour: a heightmap has one channel", options.map.string()));
    if (std::max(format.width, format.height) > most_side)
        throw RequestError(fmt::format("'{}' has {} x {} pixels; at most {} per side are supported",
                                       options.map.string(), format.width, format.height, most_side));
    map.width = format.width;
    map.height = format.height;
    map.pixel = options.extent / format.width;
    map.tileable = options.tileable;
    return map;
}

void erode(const ErodeOptions& options) {
    if (!(options.extent > 0 && options.extent < 1e9))
        throw RequestError(fmt::format("--extent {}: expected the map's width, more than 0", options.extent));
    const bool to_exr = has_extension(options.output, ".exr");
    if (!to_exr && !has_extension(options.output, ".png") && !has_extension(options.output, ".r16"))
        throw RequestError(fmt::format("-o '{}': expected the name of a file that ends in .exr, .png or .r16",
                                       options.output.string()));
    std::error_code ignored;
    if (std::filesystem::equivalent(options.map, options.output, ignored))
        throw RequestError(
            fmt::format("-o '{}' is the map itself; give another file", options.output.string()));
    const render::Erosion erosion = options.gullies.erosion(options.extent / 2);
    render::HeightMap map = map_of(options);
    image::Rect region{0, 0, map.width, map.height};
    if (!options.region.empty())
        region = {options.region[0], options.region[1], options.region[2], options.region[3]};
    check_within(region, map.width, map.height, "--region", "map");

    const bool floats = has_extension(options.map, ".exr");
    if (floats && !to_exr && options.elevation.empty())
        throw RequestError(
            "an EXR stores heights: say with --elevation which of them become 0 and 65535 in 16 bits");
    render::Elevation elevation{0, options.extent / 8};
    if (!options.elevation.empty())
        elevation = {options.elevation[0], options.elevation[1]};
    if (!(elevation.low < elevation.high && std::isfinite(elevation.high - elevation.low)))
        throw RequestError("--elevation takes LOW,HIGH, the lower height first");
    if (!floats) {
        map.scale = elevation.high - elevation.low;
        map.offset = elevation.low;
    }
    // Erosion keeps heights from the map's range within this one.
    const double reach = render::erosion_reach(erosion) * erosion.gully_weight;
    const render::Elevation range{elevation.low - reach, elevation.high + reach};

    note_interrupts();
    const vulkan::Device device(options.device);
    std::optional<image::ExrWriter> exr;
    std::optional<render::HeightWriter> heights;
    if (to_exr)
        exr.emplace(options.output,
                    image::ExrWriter::Description{
                        .picture = {0, 0, map.width, map.height},
                        .window = region,
                        .channels = {render::erosion_channels.begin(), render::erosion_channels.end()},
                        .parameters = {}});
    else
        heights.emplace(options.output, region, range, map.pixel);
    {
        Progress progress("eroding", static_cast<std::uint64_t>(region.width) *
                                         static_cast<std::uint64_t>(region.height));
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
    command->add_option("MAP", options->map, "EXR with heights, 16-bit PNG, or .r16 with --size")
        ->type_name("FILE")
        ->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "EXR with height, slope, ridge and erosion; or 16-bit heights in a PNG or .r16, with their "
            "scale in a .json file beside it")
        ->type_name("FILE")
        ->required();
    command->add_option("--size", options->size, "WIDTHxHEIGHT of a .r16 file")
        ->type_name("SIZE")
        ->delimiter('x')
        ->expected(2);
    command
        ->add_option("--region", options->region,
                     "X,Y,WIDTH,HEIGHT: write only this part, with the same pixels")
        ->type_name("RECTANGLE")
        ->delimiter(',')
        ->expected(4);
    command->add_option("--extent", options->extent, "Width of the map, in the unit of heights [8]")
        ->type_name("NUMBER");
    command
        ->add_option("--elevation", options->elevation,
                     "LOW,HIGH: heights of 0 and 65535 in a 16-bit map [0 and an eighth of --extent]")
        ->type_name("RANGE")
        ->delimiter(',')
        ->expected(2);
    options->gullies.add_to(*command);
    command->add_option("--seed", options->seed, "Another seed gives other gullies [0]")->type_name("NUMBER");
    command->add_flag("--tileable", options->tileable, "The map tiles, and so does the output");
    add_device_option(*command, options->device);
    command->callback([options] { erode(*options); });
}

} // namespace gabor::cli
