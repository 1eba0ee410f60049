#include "cli/commands.hpp"
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

constexpr int most_side = 16384;
constexpr double typical_slope = 0.2; // rms, of mountains at the scale of large gullies
constexpr render::Elevation typical_elevation{0, 1000};

std::vector<std::string_view> terrain_presets() {
    std::vector<std::string_view> names = render::preset_names();
    std::erase_if(names,
                  [](std::string_view name) { return render::preset(name).kind != render::Kind::terrain; });
    return names;
}

struct ErodeOptions {
    std::filesystem::path map;
    std::filesystem::path output;
    std::optional<std::filesystem::path> masks;
    std::optional<std::string> size;
    std::optional<std::string> region;
    std::optional<std::string> elevation;
    std::optional<std::string> extent;
    std::optional<std::string> gully_width;
    std::optional<std::string> nodata;
    std::string preset = "alps";
    ParameterOptions parameters; // the seed and the erosion; these override those of the preset
    bool tileable = false;
    std::string compression = "none";
    std::string device;
};

void multiply(render::Request& request, const char* name, double factor) {
    const render::Parameter& parameter = render::parameter(name);
    parameter.place.put(request, factor * std::get<double>(*parameter.get(request)));
}

// The terrain whose erosion and seed a map gets, before any options.
render::Request defaults_of(const std::string& preset) {
    render::Request request = render::preset(preset);
    request.seed = 0;
    // Twice the rms slope of a map: less would dam its valleys.
    render::parameter("onset_slope").place.put(request, 2 * render::preset_slope);
    // Maps show more hills than the views that presets are made for.
    multiply(request, "gully_frequency", 1.5);
    // Sharp creases leave pits where they cross the valleys of a map.
    multiply(request, "crease_rounding", 4);
    return request;
}

// Returns a terrain with the map's erosion. `extent` is the map's width, if known.
render::Request request_of(const ErodeOptions& options, std::optional<double> extent) {
    const std::vector<std::string_view> names = terrain_presets();
    const std::string preset(in_any_case(options.preset, names));
    if (std::ranges::find(names, preset) == names.end())
        throw RequestError(fmt::format("--preset '{}': {}", options.preset, expected(options.preset, names)));
    render::Request request = defaults_of(preset);
    if (options.gully_width) {
        if (!extent)
            throw RequestError("--gully-width needs the width of the map: give --extent");
        const double width =
            parse_positive("--gully-width", *options.gully_width, "a width above 0, in the unit of --extent");
        const double frequency = *extent / render::preset_side / width;
        const render::Parameter& parameter = render::parameter("gully_frequency");
        if (!(frequency >= parameter.range.low && frequency <= parameter.range.high))
            refuse("--gully-width", *options.gully_width, "a width that suits the map");
        parameter.place.put(request, frequency);
    }
    render::set(request, given_values(options.parameters), render::option_name);
    return request;
}

using Open = std::function<std::unique_ptr<image::PictureReader>()>;

// Returns a function that opens the map.
Open reader_of(const ErodeOptions& options) {
    std::optional<std::array<int, 2>> size;
    if (options.size)
        size = parse_size(*options.size, most_side);
    return [path = options.map, size] {
        return size ? image::open_raw(path, (*size)[0], (*size)[1])
                    : image::open_picture(path, "height",
                                          "; heights without a header need --size WIDTHxHEIGHT");
    };
}

// A map, its width in the unit of its heights, and what erosion needs to know about it.
struct Map : render::HeightMap {
    double extent = 0;
    std::array<int, 2> corner{}; // of the data window
    render::SmoothedMap smoothed;
};

// Opens and smooths the map. Prints what it has to guess.
Map map_of(const ErodeOptions& options, const Open& open, const image::PictureReader::Format& format,
           std::optional<render::Elevation> heights, std::optional<double> extent, double gully_frequency) {
    Map map;
    map.open = open;
    const std::string name = options.map.string();
    if (std::max(format.width, format.height) > most_side)
        throw RequestError(fmt::format("'{}' has {} x {} pixels; at most {} per side are supported", name,
                                       format.width, format.height, most_side));
    map.width = format.width;
    map.height = format.height;
    map.channels = format.channels;
    map.tileable = options.tileable;
    map.corner = {format.left, format.top};
    if (options.nodata)
        map.missing = parse_numbers<float, 1>("--nodata", *options.nodata, ',', "a number")[0];
    else
        map.missing = format.missing;
    if (format.bits < 32) {
        const render::Elevation elevation =
            heights.value_or(extent ? render::Elevation{0, *extent / 8} : typical_elevation);
        map.scale = elevation.high - elevation.low;
        map.offset = elevation.low;
        if (map.missing) // --nodata is the value in the file
            map.missing = *map.missing / static_cast<float>(format.bits == 8 ? 255 : 65535);
    } else if (options.elevation) {
        throw RequestError("--elevation is for maps of integers: this one has heights");
    }
    const double gully = map.width / render::preset_side / gully_frequency; // pixels
    map.smoothed = render::smoothed(map, std::max(gully / 7, 1.0));
    if (format.bits == 8)
        fmt::print(stderr, "gabor: warning: '{}' has 8 bits per height: its steps show as terraces\n", name);
    map.extent = extent                   ? *extent
                 : map.smoothed.slope > 0 ? map.smoothed.slope * map.width / typical_slope
                                          : map.width;
    const bool guessed = format.bits < 32 && !heights;
    if (!extent || guessed)
        fmt::print("{}: heights from {:.6g} to {:.6g}{}, {:.4g} wide{}\n", name, map.smoothed.range[0],
                   map.smoothed.range[1], guessed ? " (a guess: give --elevation)" : "", map.extent,
                   extent ? "" : " (a guess from typical slopes: give --extent)");
    return map;
}

// Makes erosion change heights by at most an eighth of their range.
void limit_strength(render::Request& request, const Map& map) {
    const double most = (map.smoothed.range[1] - map.smoothed.range[0]) / 8;
    const double reach = render::erosion_reach(map.smoothed, map.width, map.extent, request);
    if (reach > most)
        multiply(request, "strength", most / reach);
}

void check_output(const ErodeOptions& options) {
    check_extension("-o", options.output, {".exr", ".png", ".r16"}, true);
    std::error_code ignored;
    if (std::filesystem::equivalent(options.map, options.output, ignored))
        throw RequestError(
            fmt::format("-o '{}' is the map itself; give another file", options.output.string()));
    if (!has_extension(options.output, ".exr") && !options.masks && options.compression != "none")
        throw RequestError("--compression requires an EXR");
}

// Returns the text of the output's header. `join` refuses pieces whose headers differ.
std::string header_of(const ErodeOptions& options, const Map& map, const render::Request& request) {
    nlohmann::ordered_json json{{"eroded", options.map.filename().string()},
                                {"width", map.width},
                                {"height", map.height},
                                {"heights", map.smoothed.range},
                                {"slope", map.smoothed.slope},
                                {"extent", map.extent},
                                {"tileable", map.tileable}};
    if (map.missing)
        json["nodata"] = map.offset + map.scale * *map.missing;
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
    const double pixel = map.extent / map.width;
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
        masks.emplace(*options.masks, header, pixel, reach);
    if (has_extension(options.output, ".exr"))
        exr.emplace(options.output, header);
    else
        heights.emplace(options.output, region,
                        render::Elevation{map.smoothed.range[0] - reach, map.smoothed.range[1] + reach},
                        pixel);
    {
        std::vector<float> without_cover;
        Progress progress("eroding", region.pixels());
        render::erode(device, map, map.smoothed, map.extent, request, region, masks.has_value(),
                      [&](std::span<const float> rows) {
                          if (masks)
                              masks->write_rows(rows);
                          if (heights) {
                              heights->write_rows(rows, channels, 0);
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
    const Open open = reader_of(options);
    const image::PictureReader::Format format = open()->format();
    std::optional<render::Elevation> heights;
    std::optional<double> extent = format.extent;
    if (options.elevation)
        heights = parse_elevation(*options.elevation);
    if (options.extent)
        extent = parse_positive("--extent", *options.extent, "the width of the map, above 0");
    if (!options.elevation && !options.extent)
        if (const auto scale = render::scale_beside(options.map)) {
            heights = scale->elevation;
            extent = scale->extent;
        }
    render::Request request = request_of(options, extent);
    const Map map = map_of(options, open, format, heights, extent,
                           std::get<double>(*render::parameter("gully_frequency").get(request)));
    if (!is_given(options.parameters, "strength"))
        limit_strength(request, map);
    const image::Rect region =
        options.region ? parse_region(*options.region) : image::Rect{0, 0, map.width, map.height};
    check_within(region, map.width, map.height, "--region", "map");
    const double reach = render::erosion_reach(map.smoothed, map.width, map.extent, request);

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
    add_option(
        *command, "MAP", options->map, "FILE",
        "EXR or TIFF with heights, 16-bit PNG; or, with --size, 16-bit integers or floats without a header")
        ->required();
    begin_group(*command, "Output");
    add_option(*command, "-o,--output", options->output, "FILE",
               "EXR with height, slope, ridge and erosion; or 16-bit heights in a PNG or .r16, with their "
               "scale in a .json file beside it")
        ->required();
    add_option(
        *command, "--masks", options->masks, "FOLDER",
        "Also write masks to this folder: 16-bit PNGs of ridges, creases, slope, erosion, and the shares of "
        "grass, scree, rock and snow; masks.exr with all of them, and masks.json with their scale");
    add_option(*command, "--region", options->region, "X,Y,WIDTH,HEIGHT",
               "Write only this part of the eroded map [all of it]");
    add_compression_option(*command, options->compression);
    add_device_option(*command, options->device);
    begin_group(*command, "Map");
    add_option(*command, "--size", options->size, "WIDTHxHEIGHT",
               "Size of a file without a header, such as .r16, .raw or .r32");
    add_option(*command, "--extent", options->extent, "NUMBER",
               "Width of the map, in the same unit as its heights; without it, that of a GeoTIFF or of the "
               ".json file beside a map that gabor wrote, or a guess from the slopes, which is printed");
    add_elevation_option(*command, options->elevation, "0 to extent/8 if --extent is given, else 0,1000");
    add_option(*command, "--nodata", options->nodata, "NUMBER",
               "Value of pixels that have no height; without it, that of a GeoTIFF");
    command->add_flag("--tileable", options->tileable, "The map tiles without seams, and so does the output");
    begin_group(*command, "Erosion");
    add_option(*command, "--gully-width", options->gully_width, "NUMBER",
               "Width of the widest gullies, in the unit of --extent, in place of --gully-frequency");
    add_option(*command, "--preset", options->preset, "NAME",
               fmt::format("Shape of the gullies, with the defaults of all options below, but without "
                           "--strength, heights change by at most an eighth of their range: {} [{}]",
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
