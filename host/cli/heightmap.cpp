#include "cli/heightmap.hpp"

#include "cli/options.hpp"
#include "names.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gabor::cli {

namespace {

using render::has_extension;

constexpr int most_side = 16384;
constexpr render::Elevation typical_elevation{0, 1000};
constexpr std::array<std::string_view, 2> byte_orders{"little", "big"}, encodings{"terrain-rgb", "terrarium"};

// Returns whether `name` is the second of the names; throws RequestError if it is neither.
bool is_second(std::string_view option, std::string_view name, const std::array<std::string_view, 2>& names) {
    const std::string_view found = in_any_case(name, names);
    if (std::ranges::find(names, found) == names.end())
        throw RequestError(fmt::format("{} '{}': {}", option, name, expected(name, names)));
    return found == names[1];
}

using Open = std::function<std::unique_ptr<image::PictureReader>()>;

// Returns a function that opens the map.
Open reader_of(const HeightmapOptions& options) {
    const std::filesystem::path& path = options.path;
    std::optional<std::array<int, 2>> size;
    if (options.size)
        size = parse_size(*options.size, most_side);
    if (options.byte_order && (!size || has_extension(path, ".hgt")))
        throw RequestError("--byte-order is for heights without a header: give --size");
    if (options.encoding) {
        if (size)
            throw RequestError("--encoding is for pictures, which have a size: leave out --size");
        const bool terrarium = is_second("--encoding", *options.encoding, encodings);
        return [path, terrarium] { return image::open_encoded(path, terrarium); };
    }
    if (has_extension(path, ".hgt"))
        return [path, size] { return image::open_hgt(path, size); };
    if (!size)
        return [path] {
            return image::open_picture(path, "height", "; heights without a header need --size WIDTHxHEIGHT");
        };
    const auto [width, height] = *size;
    bool big = false;
    if (options.byte_order) {
        big = is_second("--byte-order", *options.byte_order, byte_orders);
    } else {
        big = image::byte_order_of(path, width, height) == std::endian::big;
        fmt::print(
            "{}: {} byte first, as neighbouring heights differ less that way; --byte-order {} reads it the "
            "other way\n",
            path.string(), big ? "high" : "low", byte_orders[big ? 0 : 1]);
    }
    return [path, width, height, big] {
        return image::open_raw(path, width, height, big ? std::endian::big : std::endian::little);
    };
}

// Reads WIDTH or WIDTH,HEIGHT; HEIGHT is 0 if it is not given.
std::array<double, 2> parse_extent(std::string_view text) {
    constexpr std::string_view accepted = "the width of the map, above 0, or WIDTH,HEIGHT";
    if (text.find(',') == text.npos)
        return {parse_positive("--extent", text, accepted), 0};
    const auto both = parse_numbers<double, 2>("--extent", text, ',', accepted);
    if (!(std::min(both[0], both[1]) > 0 && std::isfinite(both[0] * both[1])))
        refuse("--extent", text, accepted);
    return both;
}

// Finds the sides of a pixel from the options, the file, or the JSON file beside it.
void set_pixel(Heightmap& map, const HeightmapOptions& options,
               const std::optional<render::MapScale>& beside) {
    const std::array<double, 2> given = options.extent ? parse_extent(*options.extent) : std::array{0.0, 0.0};
    map.has_extent = true;
    if (given[1] > 0) {
        map.pixel = {given[0] / map.width, given[1] / map.height};
    } else if (map.geo.exist()) {
        try {
            image::PixelSize stated = image::pixel_size(map.geo, map.width, map.height);
            map.pixel = stated.sides;
            map.unit = std::move(stated.unit);
            map.remark = std::move(stated.assumed);
        } catch (const RequestError& error) {
            image::refuse_picture(options.path,
                                  fmt::format("{}; expected a map in metres, feet or degrees, or "
                                              "--extent WIDTH,HEIGHT",
                                              error.what()));
        }
    } else if (beside) {
        map.pixel = {beside->extent[0] / map.width, beside->extent[1] / map.height};
    } else {
        map.has_extent = options.extent.has_value();
    }
    if (given[0] > 0 && given[1] == 0)
        map.pixel = {given[0] / map.width, given[0] / map.width * (map.pixel[1] / map.pixel[0])};
}

} // namespace

void add_heightmap(CLI::App& command, HeightmapOptions& options) {
    add_option(command, "MAP", options.path, "FILE",
               "The heightmap: EXR, TIFF, .hgt, .asc, .npy or 16-bit PNG; with --size, also 16-bit integers "
               "or floats without a header")
        ->required();
}

void add_heightmap_options(CLI::App& command, HeightmapOptions& options) {
    begin_group(command, "Map");
    add_option(command, "--size", options.size, "WIDTHxHEIGHT",
               "Size of a file without a header, such as .r16, .raw or .r32");
    add_option(command, "--byte-order", options.byte_order, "NAME",
               fmt::format("Byte order of a file without a header: {}; by default, the one in which "
                           "neighbouring heights differ less",
                           fmt::join(byte_orders, " or ")));
    add_option(command, "--encoding", options.encoding, "NAME",
               fmt::format("How red, green and blue encode heights: {}", fmt::join(encodings, " or ")));
    add_option(
        command, "--extent", options.extent, "WIDTH[,HEIGHT]",
        "Size of the map, in the unit of the heights. By default, a GeoTIFF, .hgt or .asc states it, or the "
        ".json file beside a map that gabor wrote; otherwise gabor guesses it from the slopes, and prints "
        "the guess. Without HEIGHT, pixels keep the proportions that the file states, or are square");
    add_elevation_option(command, options.elevation, "0 to extent/8 if --extent is given, else 0,1000");
    add_option(command, "--nodata", options.nodata, "NUMBER",
               "Value of pixels that have no height; by default, the one that the file states");
    command.add_flag("--tileable", options.tileable,
                     "Treat the map as a tile, so that the output tiles without seams");
}

Heightmap open_heightmap(const HeightmapOptions& options) {
    Heightmap map;
    map.open = reader_of(options);
    const image::PictureReader::Format format = map.open()->format();
    if (std::max(format.width, format.height) > most_side)
        throw RequestError(fmt::format("'{}' has {} x {} pixels; at most {} per side are supported",
                                       options.path.string(), format.width, format.height, most_side));
    map.width = format.width;
    map.height = format.height;
    map.channels = format.channels;
    map.scale = format.scale;
    map.offset = format.offset;
    map.tileable = options.tileable;
    map.corner = {format.left, format.top};
    map.geo = format.geo;

    const bool levels = format.bits < 32;
    std::optional<render::Elevation> heights;
    std::optional<render::MapScale> beside;
    if (options.elevation)
        heights = parse_elevation(*options.elevation);
    if (heights && !levels)
        throw RequestError("--elevation is for maps of integers: this one has heights");
    if (!options.elevation && !options.extent)
        beside = render::scale_beside(options.path);
    if (beside && beside->elevation.has_value() == levels)
        heights = beside->elevation;
    else
        beside.reset();
    set_pixel(map, options, beside);
    if (options.nodata)
        map.missing = parse_numbers<float, 1>("--nodata", *options.nodata, ',', "a number")[0];
    else
        map.missing = format.missing ? format.missing : beside ? beside->missing : std::nullopt;
    if (!levels)
        return map;
    map.guessed_heights = !heights;
    const auto [low, high] = heights          ? *heights
                             : map.has_extent ? render::Elevation{0, map.extent()[0] / 8}
                                              : typical_elevation;
    map.scale = high - low;
    map.offset = low;
    if (map.missing) // the value in the file
        map.missing = *map.missing / static_cast<float>(format.bits == 8 ? 255 : 65535);
    map.has_steps = format.bits == 8;
    return map;
}

} // namespace gabor::cli
