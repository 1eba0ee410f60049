#pragma once

#include "image/picture.hpp"
#include "render/output/erosion.hpp"
#include "render/output/heightmap.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace gabor::cli {

/// The options that say what a heightmap's file means.
struct HeightmapOptions {
    std::filesystem::path path;
    std::optional<std::string> size;
    std::optional<std::string> byte_order;
    std::optional<std::string> encoding;
    std::optional<std::string> extent;
    std::optional<std::string> elevation;
    std::optional<std::string> nodata;
    bool tileable = false;
};

/// Add the argument for the map, and the group of options.
void add_heightmap(CLI::App& command, HeightmapOptions& options);
void add_heightmap_options(CLI::App& command, HeightmapOptions& options);

/// A map, and what is known about it.
struct Heightmap : render::HeightMap {
    std::array<int, 2> corner{}; ///< of the data window
    image::GeoTags geo;
    std::string unit;             ///< of heights, if known
    bool has_extent = false;      ///< otherwise pixels count as 1 x 1
    bool guessed_heights = false; ///< the heights that integers stand for
    bool has_steps = false;       ///< of 8 bits
    std::string remark;           ///< what was found out about the file, if anything

    std::optional<float> missing_height() const {
        return missing ? std::optional(static_cast<float>(offset + scale * *missing)) : std::nullopt;
    }
};

/// Opens a map. Prints the byte order, if no option states it.
Heightmap open_heightmap(const HeightmapOptions& options);

} // namespace gabor::cli
