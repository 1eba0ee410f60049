#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/picture.hpp"
#include "render/erosion.hpp"
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
    std::optional<std::string> elevation;
    std::string extent = fmt::format("{}", 2 * preset_hill);
    std::string preset = "alps";
    ParameterOptions parameters; // the seed and the erosion; these override those of the preset
    bool tileable = false;
    std::string device;
};

// The terrain whose erosion and seed a map gets, before any options.
render::Request defaults_of(const std::string& preset) {
    render::Request request = render::preset(preset);
    request.seed = 0;
    return request;
}

// Returns a terrain with the map's extent and its erosion.
render::Request request_of(const ErodeOptions& options) {
    const std::vector<std::string_view> names = terrain_presets();
    if (std::ranges::find(names, options.preset) == names.end())
        refuse("--preset", options.preset, fmt::format("{}", fmt::join(names, ", ")));
    render::Request request = defaults_of(options.preset);
    const render::Parameter& extent = render::parameter("extent");
    render::set(request,
                {{&extent, with_prefix("--extent ", [&] { return render::read(extent, options.extent); })}});
    const double width = std::get<render::Terrain>(request.view).extent;
    if (width == 0)
        refuse("--extent", options.extent, "the width of the map, above 0");
    const render::Parameter& frequency = render::parameter("gully_frequency");
    frequency.place.put(request, std::get<double>(*frequency.get(request)) * 2 * preset_hill / width);
    render::set(request, given_values(options.parameters), render::option_name);
    return request;
}

// Returns a function that opens the map.
auto reader_of(const ErodeOptions& options) {
    const bool raw = has_extension(options.map, ".r16");
    if (raw != options.size.has_value())
        throw RequestError(raw ? "a .r16 file has no header: give its WIDTHxHEIGHT with --size"
                               : "--size is for .r16 files: other files store their size");
    const auto size = raw ? parse_size(*options.size, most_side) : std::array{0, 0};
    return [path = options.map, raw, size] {
        return raw ? image::open_raw16(path, size[0], size[1]) : image::open_picture(path, "height");
    };
}

// Returns the map, whose heights are floats or stand for heights in the range `elevation`.
render::HeightMap map_of(const ErodeOptions& options, double extent, const render::Elevation& elevation) {
    const auto open = reader_of(options);
    const image::PictureReader::Format format = open()->format();
    if (format.channels != 1)
        throw RequestError(
            fmt::format("'{}' is in colour: a heightmap has one channel", options.map.string()));
    if (std::max(format.width, format.height) > most_side)
        throw RequestError(fmt::format("'{}' has {} x {} pixels; at most {} per side are supported",
                                       options.map.string(), format.width, format.height, most_side));
    const bool floats = has_extension(options.map, ".exr");
    return {.open = open,
            .width = format.width,
            .height = format.height,
            .pixel = extent / format.width,
            .scale = floats ? 1 : elevation.high - elevation.low,
            .offset = floats ? 0 : elevation.low,
            .tileable = options.tileable};
}

void check_output(const ErodeOptions& options) {
    check_extension("-o", options.output, {".exr", ".png", ".r16"}, true);
    std::error_code ignored;
    if (std::filesystem::equivalent(options.map, options.output, ignored))
        throw RequestError(
            fmt::format("-o '{}' is the map itself; give another file", options.output.string()));
    if (has_extension(options.map, ".exr") && !has_extension(options.output, ".exr") && !options.elevation)
        throw RequestError("an EXR has no range of heights: use --elevation LOW,HIGH to set the heights that "
                           "become 0 and 65535 in 16 bits");
}

// Erodes a region, and writes all channels to an EXR or heights in `range` to a PNG or .r16.
void write(const ErodeOptions& options, const vulkan::Device& device, const render::HeightMap& map,
           const render::Request& request, const image::Rect& region, const render::Elevation& range) {
    constexpr const auto& channels = render::erosion_channels;
    std::optional<image::ExrWriter> exr;
    std::optional<render::HeightWriter> heights;
    if (has_extension(options.output, ".exr"))
        exr.emplace(options.output, image::ExrHeader{.picture = {0, 0, map.width, map.height},
                                                     .window = region,
                                                     .channels = {channels.begin(), channels.end()}});
    else
        heights.emplace(options.output, region, range, map.pixel);
    {
        Progress progress("eroding", region.pixels());
        render::erode(device, map, request, region, [&](std::span<const float> rows) {
            if (exr)
                exr->write_rows(rows);
            else
                heights->write_rows(rows, channels.size(), 0);
            progress.advance(rows.size() / channels.size());
        });
    }
    exr ? exr->commit() : heights->commit();
}

void erode(const ErodeOptions& options) {
    const render::Request request = request_of(options);
    check_output(options);
    const double extent = std::get<render::Terrain>(request.view).extent;
    const render::Elevation elevation =
        options.elevation ? parse_elevation(*options.elevation) : render::Elevation{0, extent / 8};
    const render::HeightMap map = map_of(options, extent, elevation);
    const image::Rect region =
        options.region ? parse_region(*options.region) : image::Rect{0, 0, map.width, map.height};
    check_within(region, map.width, map.height, "--region", "map");
    // Erosion changes a height by at most `reach`.
    const double reach =
        render::erosion_reach(request) * std::get<double>(*render::parameter("gully_weight").get(request));

    note_interrupts();
    const vulkan::Device device(options.device);
    write(options, device, map, request, region, {elevation.low - reach, elevation.high + reach});
    fmt::print("{}: {} x {} pixels, on {}\n", options.output.string(), region.width, region.height,
               device.info().name);
}

} // namespace

void add_erode_command(CLI::App& app) {
    auto options = std::make_shared<ErodeOptions>();
    CLI::App* command = app.add_subcommand("erode", "Add gullies and ridges to a heightmap");
    add_option(*command, "MAP", options->map, "FILE", "EXR with heights, 16-bit PNG, or .r16 with --size")
        ->required();
    begin_group(*command, "Output");
    add_option(*command, "-o,--output", options->output, "FILE",
               "EXR with height, slope, ridge and erosion; or 16-bit heights in a PNG or .r16, with their "
               "scale in a .json file beside it")
        ->required();
    add_option(*command, "--region", options->region, "X,Y,WIDTH,HEIGHT",
               "Write only this part of the eroded map [all of it]");
    add_device_option(*command, options->device);
    begin_group(*command, "Map");
    add_option(*command, "--size", options->size, "WIDTHxHEIGHT", "Size of a .r16 file");
    add_option(*command, "--extent", options->extent, "NUMBER",
               fmt::format("Width of the map, in the same unit as its heights [{}]", options->extent));
    add_elevation_option(*command, options->elevation, "0 and an eighth of --extent");
    command->add_flag("--tileable", options->tileable, "The map tiles without seams, and so does the output");
    begin_group(*command, "Erosion");
    add_option(*command, "--preset", options->preset, "NAME",
               fmt::format("Shape of the gullies, with the defaults of all options below: {} [{}]",
                           fmt::join(terrain_presets(), ", "), options->preset));
    const render::Request defaults = defaults_of(options->preset);
    for (const render::Parameter& p : render::parameters())
        if (p.name == "seed" || p.group == render::Parameter::Group::erosion)
            add_parameter(*command, options->parameters, p, defaults);
    command->callback([options] { erode(*options); });
}

} // namespace gabor::cli
