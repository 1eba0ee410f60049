#pragma once

#include "image/exr.hpp"
#include "render/request/request.hpp"

#include <optional>
#include <span>

namespace gabor::render {

/// A request read from a file, and the region whose pixels the file holds, if any.
struct Loaded {
    Request request;
    std::optional<image::Rect> region;
    std::string json; ///< text of the request in the file
};

/// Reads the `gabor` attribute of an EXR, or a file whose name ends in `.json`. Throws RequestError, naming
/// the file.
Loaded load_request(const std::string& path);

/// Reads a JSON file with a list of lobes, or with a request that has lobes. Throws RequestError, naming the
/// file.
std::vector<noise::Lobe> load_lobes(const std::string& path);

/// A preset shipped with the program: a file in host/render/request/presets.
struct Preset {
    std::string_view name;
    std::string_view json;
};

/// All presets, sorted by name.
std::span<const Preset> presets();
std::vector<std::string_view> preset_names();
/// Returns the preset with that name, in upper or lower case, or reads a file NAME.json. Throws RequestError
/// if there is no such preset.
Request preset(std::string_view name);

/// Frequencies and orientations painted over a picture.
struct Paint {
    int width = 1;
    int height = 1;
    std::vector<float> samples{0, 0}; ///< row by row: cycles per kernel radius, radians
    bool relative = false;            ///< samples multiply the lobe's frequency and add to its orientation
};

/// Tells whether a paint file contains only directions, as every format except EXR does.
bool has_only_directions(const std::string& path);

/// Reads a picture of at most 2^24 pixels. An EXR has channels `frequency` and `orientation` (degrees). In
/// other pictures, red and green minus one half are the components, to the right and down, of a vector along
/// the crests of the waves. Returns one sample of zeros for an empty path. Throws RequestError if the file
/// cannot be read or a value is not finite.
Paint load_paint(const std::string& path);

} // namespace gabor::render
