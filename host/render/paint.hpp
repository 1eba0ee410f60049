#pragma once

#include <string>
#include <vector>

namespace gabor::render {

/// Frequencies and orientations that are painted over a picture.
struct Paint {
    int width = 1;
    int height = 1;
    std::vector<float> samples{0, 0}; ///< row by row: cycles per kernel radius, radians
};

/// The channels `frequency` and `orientation`, in degrees, of an EXR of at most 2^24 pixels; where `path` is
/// empty a sample of zeros. Throws RequestError when it cannot be read or a value is not finite.
Paint read_paint(const std::string& path);

} // namespace gabor::render
