#include "cli/commands.hpp"
#include "cli/heightmap.hpp"
#include "cli/options.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/picture.hpp"
#include "names.hpp"
#include "render/output/erosion.hpp"
#include "render/output/file.hpp"
#include "render/request/load.hpp"
#include "vulkan/device.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace gabor::cli {

namespace {

using render::has_extension;

constexpr double typical_slope = 0.2; // rms, of mountains at the scale of large gullies

std::vector<std::string_view> terrain_presets() {
    std::vector<std::string_view> names = render::preset_names();
    std::erase_if(names,
                  [](std::string_view name) { return render::preset(name).kind != render::Kind::terrain; });
    return names;
}

struct ErodeOptions {
    HeightmapOptions map;
    std::filesystem::path output;
    std::optional<std::filesystem::path> masks;
    std::optional<std::string> region;
    std::optional<std::string> gully_width;
    std::optional<std::string> offset;
    std::optional<std::string> steepness;
    std::optional<std::string> relief;
    bool full_range = false;
    bool only_height = false;
    std::string preset = "alps";
    ParameterOptions parameters; // the seed and the erosion; these override those of the preset
    std::string compression = "none";
    std::string device;
};

void multiply(render::Request& request, const char* name, double factor) {
    const render::Parameter& parameter = render::parameter(name);
    parameter.place.put(request, factor * std::get<double>(*parameter.get(request)));
}

// Returns the terrain that gives a map its erosion and seed, before any options.
render::Request defaults_of(const std::string& preset) {
    render::Request request = render::preset(preset);
    request.seed = 0;
    // Twice the rms slope of a map: a smaller onset would dam valleys.
    render::parameter("onset_slope").place.put(request, 2 * render::preset_slope);
    // Maps show more hills than the views that presets are made for.
    multiply(request, "gully_frequency", 1.5);
    // Sharp creases leave pits where they cross the valleys of a map.
    multiply(request, "crease_rounding", 4);
    return request;
}

// Returns a terrain with the map's erosion.
render::Request request_of(const ErodeOptions& options) {
    const std::vector<std::string_view> names = terrain_presets();
    const std::string preset(in_any_case(options.preset, names));
    if (std::ranges::find(names, preset) == names.end())
        throw RequestError(fmt::format("--preset '{}': {}", options.preset, expected(options.preset, names)));
    render::Request request = defaults_of(preset);
    render::set(request, given_values(options.parameters), render::option_name);
    return request;
}

double gully_frequency(const render::Request& request) {
    return std::get<double>(*render::parameter("gully_frequency").get(request));
}

// Returns the place of the map in a world. Maps of a world agree if they share steepness, relief and gullies.
std::optional<std::array<int, 2>> world_of(const ErodeOptions& options) {
    if (!options.offset)
        return {};
    constexpr int furthest = 1 << 24; // so that the pixels between two kernels stay far below 2^31
    constexpr std::string_view accepted = "X,Y, whole pixels from -16777216 to 16777216";
    const auto offset = parse_numbers<int, 2>("--offset", *options.offset, ',', accepted);
    if (std::ranges::min(offset) < -furthest || std::ranges::max(offset) > furthest)
        refuse("--offset", *options.offset, accepted);
    if (!options.steepness || !options.relief || !options.gully_width)
        throw RequestError("--offset needs --steepness, --relief and --gully-width, the same for each map");
    if (options.map.tileable)
        throw RequestError("--offset and --tileable exclude each other: a tile is its own world");
    return offset;
}

struct Map : Heightmap {
    explicit Map(Heightmap map) : Heightmap(std::move(map)), side(extent()[0]) {}

    double side; // what counts as render::preset_side, in the unit of heights
    render::SmoothedMap smoothed;
};

// Makes gullies as wide as --gully-width: through gully_frequency or, in a world, through the side, so that
// all maps of the world agree.
void set_gully_width(const ErodeOptions& options, Map& map, render::Request& request) {
    if (!options.gully_width)
        return;
    if (is_given(options.parameters, "gully_frequency"))
        throw RequestError("--gully-width and --gully-frequency say the same: give one");
    if (!map.has_extent)
        throw RequestError("--gully-width needs the width of the map: give --extent");
    const double width =
        parse_positive("--gully-width", *options.gully_width, "a width above 0, in the unit of --extent");
    const double frequency = map.side / render::preset_side / width;
    const render::Parameter& parameter = render::parameter("gully_frequency");
    if (!(frequency >= parameter.range.low && frequency <= parameter.range.high))
        refuse("--gully-width", *options.gully_width, "a width that suits the map");
    if (map.world)
        map.side = width * render::preset_side * gully_frequency(request);
    else
        parameter.place.put(request, frequency);
}

// Prints what the map's file states, and what we guessed.
void print_scale(const ErodeOptions& options, const Map& map) {
    if (map.has_extent && !map.guessed_heights && map.unit.empty() && map.remark.empty())
        return;
    const auto [width, height] = map.extent();
    fmt::print("{}: heights from {:.6g} to {:.6g}{}, {:.4g} wide and {:.4g} high{}{}{}\n",
               options.map.path.string(), map.smoothed.range[0], map.smoothed.range[1],
               map.guessed_heights ? " (a guess: give --elevation)" : "", width, height,
               map.has_extent ? "" : " (a guess from typical slopes: give --extent)",
               map.unit.empty() ? "" : fmt::format(", in {}", map.unit),
               map.remark.empty() ? "" : "; " + map.remark);
}

// Opens and smooths the map. Prints guesses.
Map map_of(const ErodeOptions& options, render::Request& request) {
    Map map(open_heightmap(options.map));
    map.world = world_of(options);
    set_gully_width(options, map, request);
    const double gully = map.side / map.pixel[0] / render::preset_side / gully_frequency(request); // pixels
    map.smoothed = render::smoothed(map, std::max(gully / 7, 1.0));
    if (map.has_steps)
        fmt::print(stderr, "gabor: warning: '{}' has 8 bits per height: its steps show as terraces\n",
                   options.map.path.string());
    if (!map.has_extent && map.smoothed.slope > 0) {
        const double pixel = map.smoothed.slope / typical_slope;
        for (double* length : {&map.pixel[0], &map.pixel[1], &map.side})
            *length *= pixel;
        map.smoothed.slope = typical_slope;
    }
    print_scale(options, map);
    return map;
}

// Treats the map as part of a world with this steepness and these heights.
void set_world(const ErodeOptions& options, render::SmoothedMap& smoothed) {
    if (options.steepness)
        smoothed.slope = parse_positive("--steepness", *options.steepness, "an rms slope above 0");
    if (!options.relief)
        return;
    constexpr std::string_view accepted = "LOW,HIGH, the lower height first";
    const auto relief = parse_numbers<float, 2>("--relief", *options.relief, ',', accepted);
    if (!(relief[0] < relief[1] && std::isfinite(relief[1] - relief[0])))
        refuse("--relief", *options.relief, accepted);
    if (!(relief[0] <= smoothed.range[0] && relief[1] >= smoothed.range[1]))
        refuse("--relief", *options.relief,
               fmt::format("a range that holds the heights of this map, {:.6g} to {:.6g}", smoothed.range[0],
                           smoothed.range[1]));
    smoothed.range = relief;
}

// Makes erosion change heights by at most an eighth of their range.
void limit_strength(render::Request& request, const Map& map) {
    const double most = (map.smoothed.range[1] - map.smoothed.range[0]) / 8;
    const double reach = render::erosion_reach(map.smoothed, map.side, request);
    if (reach > most)
        multiply(request, "strength", most / reach);
}

void check_output(const ErodeOptions& options) {
    check_extension("-o", options.output,
                    {render::height_extensions.begin(), render::height_extensions.end()}, true);
    std::error_code ignored;
    if (std::filesystem::equivalent(options.map.path, options.output, ignored))
        throw RequestError(
            fmt::format("-o '{}' is the map itself; give another file", options.output.string()));
    if (options.only_height && !has_extension(options.output, ".exr"))
        throw RequestError("--only-height is for an EXR: other files have nothing else");
    check_height_options(options.output, options.full_range, options.compression, options.masks.has_value());
}

// Returns the text of the output's header. `join` refuses pieces whose headers differ.
std::string header_of(const ErodeOptions& options, const Map& map, const render::Request& request) {
    nlohmann::ordered_json json{{"eroded", options.map.path.filename().string()},
                                {"width", map.width},
                                {"height", map.height},
                                {"heights", map.smoothed.range},
                                {"slope", map.smoothed.slope},
                                {"extent", map.extent()},
                                {"tileable", map.tileable}};
    if (map.world)
        json["offset"] = *map.world;
    if (map.missing)
        json["nodata"] = *map.missing_height();
    for (const render::Parameter& p : render::parameters())
        if (p.name == "seed" || p.group == render::Parameter::Group::erosion)
            json[std::string(p.name)] = render::to_text(*p.get(request));
    return json.dump();
}

// Erodes a region, and writes the output and the masks. Erosion changes a height by at most `reach`.
void write(const ErodeOptions& options, const vulkan::Device& device, const Map& map,
           const render::Request& request, const image::Rect& region, double reach) {
    constexpr std::size_t kept = passes::erosion_cover; // the channels of an EXR without masks
    const std::size_t channels = options.masks ? render::erosion_channels.size() : kept;
    const auto [left, top] = map.corner;
    const image::ExrHeader header{
        .picture = {left, top, map.width, map.height},
        .window = {left + region.x, top + region.y, region.width, region.height},
        .channels = {render::erosion_channels.begin(), render::erosion_channels.begin() + kept},
        .parameters = header_of(options, map, request),
        .software = render::software(device),
        .compression = options.compression,
    };
    std::optional<image::ExrWriter> exr;
    std::optional<render::HeightWriter> heights;
    std::optional<render::MaskWriter> masks;
    if (options.masks)
        masks.emplace(*options.masks, header, map.pixel, map.missing_height(), reach);
    if (has_extension(options.output, ".exr") && !options.only_height)
        exr.emplace(options.output, header);
    else
        heights.emplace(
            options.output, region,
            render::HeightFormat{.elevation = {map.smoothed.range[0] - reach, map.smoothed.range[1] + reach},
                                 .full_range = options.full_range,
                                 .pixel = map.pixel,
                                 .missing = map.missing_height(),
                                 .geo = image::moved(map.geo.exist() ? map.geo : image::plain_tags(map.pixel),
                                                     region.x, region.y),
                                 .exr = header});
    {
        std::vector<float> without_cover;
        Progress progress("eroding", region.pixels());
        render::erode(device, map, map.smoothed, map.side, request, region, masks.has_value(),
                      [&](std::span<const float> rows) {
                          if (masks)
                              masks->write_rows(rows);
                          if (heights) {
                              heights->write_rows(rows, channels, passes::erosion_height);
                          } else if (!masks) {
                              exr->write_rows(rows);
                          } else {
                              without_cover.clear();
                              for (std::size_t i = 0; i < rows.size(); ++i)
                                  if (i % channels < kept)
                                      without_cover.push_back(rows[i]);
                              exr->write_rows(without_cover);
                          }
                          progress.advance(rows.size() / channels);
                      });
    }
    exr ? exr->commit() : heights->commit();
    if (masks)
        masks->commit();
}

void erode(const ErodeOptions& options) {
    check_output(options);
    render::Request request = request_of(options);
    Map map = map_of(options, request);
    set_world(options, map.smoothed);
    if (!is_given(options.parameters, "strength"))
        limit_strength(request, map);
    const image::Rect region =
        options.region ? parse_region(*options.region) : image::Rect{0, 0, map.width, map.height};
    check_within(region, map.width, map.height, "--region", "map");
    const double reach = render::erosion_reach(map.smoothed, map.side, request);

    system::note_interrupts();
    const vulkan::Device device(options.device);
    write(options, device, map, request, region, reach);
    fmt::print("{}: {} x {} pixels, on {}\n", options.output.string(), region.width, region.height,
               device.info().name);
}

} // namespace

void add_erode_command(CLI::App& app) {
    auto options = std::make_shared<ErodeOptions>();
    CLI::App* command = app.add_subcommand("erode", "Add gullies and ridges to a heightmap");
    add_heightmap(*command, options->map);
    begin_group(*command, "Output");
    add_option(*command, "-o,--output", options->output, "FILE",
               "Output: an EXR with height (channel Y), slope, ridge and erosion; or height alone, as floats "
               "in a TIFF (with the place of a GeoTIFF) or .r32, or as 16 bits in a PNG, .r16 or .raw. "
               "Beside the last four, a .json file gives the scale")
        ->required();
    command->add_flag("--only-height", options->only_height,
                      "Write an EXR with channel Y alone, which every program shows");
    add_full_range_option(*command, options->full_range);
    add_option(
        *command, "--masks", options->masks, "FOLDER",
        "Also write masks to this folder: 16-bit PNGs of ridges, creases, slope, erosion, and the shares of "
        "grass, scree, rock and snow; masks.exr with the height and all of them, and masks.json with their "
        "scale");
    add_option(*command, "--region", options->region, "X,Y,WIDTH,HEIGHT",
               "Write only this part of the eroded map [all of it]");
    add_compression_option(*command, options->compression);
    add_device_option(*command, options->device);
    add_heightmap_options(*command, options->map);
    begin_group(*command, "World");
    add_option(*command, "--offset", options->offset, "X,Y",
               "Place of the map's first pixel in a world, in pixels. Overlapping maps then agree, except in "
               "a margin two thirds of a gully wide. Requires the next two options and --gully-width, all "
               "equal for each map");
    add_option(*command, "--steepness", options->steepness, "NUMBER",
               "The world's rms slope; by default, the map's, which the header of the EXR gives as slope");
    add_option(*command, "--relief", options->relief, "LOW,HIGH",
               "The world's lowest and highest height; by default, the map's");
    begin_group(*command, "Erosion");
    add_option(*command, "--gully-width", options->gully_width, "NUMBER",
               "Width of the widest gullies, in the unit of --extent; replaces --gully-frequency");
    add_option(*command, "--preset", options->preset, "NAME",
               fmt::format("Shape of the gullies, which sets the defaults of the options below. Unless "
                           "--strength is given, heights change by at most an eighth of their range: {} [{}]",
                           fmt::join(terrain_presets(), ", "), options->preset));
    const render::Request defaults = defaults_of(options->preset);
    for (const render::Parameter& p : render::parameters())
        if (p.name == "seed" || p.group == render::Parameter::Group::erosion)
            add_parameter(*command, options->parameters, p, defaults);
    CLI::Option* const frequency = command->get_option("--gully-frequency");
    std::string help = frequency->get_description();
    const std::string_view unit = "kernel radius";
    frequency->description(help.replace(help.find(unit), unit.size(), "eighth of the map's width"));
    command->callback([options] { erode(*options); });
}

} // namespace gabor::cli
