#pragma once

#include "image/exr.hpp"
#include "render/picture.hpp"

#include <optional>

namespace gabor::render {

/// What a file says of a picture, and the region of it that the file holds, if it holds pixels.
struct Likeness {
    Picture picture;
    std::optional<image::Window> region;
};

/// Reads the `gabor` attribute of an EXR, or, if the file's name ends in `.json`, what the file says. Throws
/// RequestError, with the file's name, where that is no picture's parameters.
Likeness read_likeness(const std::string& path);

/// Reads a JSON file for `lobes_from_json`. Throws RequestError, with the file's name.
std::vector<Lobe> read_lobes(const std::string& path);

} // namespace gabor::render
