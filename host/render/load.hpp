#pragma once

#include "image/exr.hpp"
#include "render/request.hpp"

#include <filesystem>
#include <optional>
#include <span>

namespace gabor::render {

/// A request that a file holds, and the region of it whose pixels it holds, if any.
struct Loaded {
    Request request;
    std::optional<image::Rect> region;
    std::string json; ///< as it stands in the file
};

/// From the `gabor` attribute of an EXR, or from a file whose name ends in `.json`. Throws RequestError, with
/// the file's name.
Loaded load_request(const std::string& path);

/// From a JSON file that holds a list of lobes, or a request with lobes. Throws RequestError, with the file's
/// name.
std::vector<noise::Lobe> load_lobes(const std::string& path);

/// A request worth starting from: a file of host/render/presets.
struct Preset {
    std::string_view name;
    std::string_view json;
};

/// All of them, by name.
std::span<const Preset> presets();
std::vector<std::string_view> preset_names();
/// One of them, or of a file NAME.json. Throws RequestError, listing the known names.
Request preset(std::string_view name);

/// Frequencies and orientations that are painted over a picture.
struct Paint {
    int width = 1;
    int height = 1;
    std::vector<float> samples{0, 0}; ///< row by row: cycles per kernel radius, radians
};

/// The channels `frequency` and `orientation`, in degrees, of an EXR of at most 2^24 pixels; where `path` is
/// empty one sample of zeros. Throws RequestError when it cannot be read or a value is not finite.
Paint load_paint(const std::string& path);

} // namespace gabor::render
