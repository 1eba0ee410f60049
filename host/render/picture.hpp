#pragma once

#include "noise/recipe.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::render {

/// Everything that decides the pixels of a picture. They are within 2e-5 standard deviations of the exact
/// noise up to frequency 4; above, and for the sine kernels of `paper` below 0.1, in proportion to the
/// frequency and its inverse. Pixel (x, y), rows growing downwards, shows the noise at
/// ((x + 0.5) / scale, (y + 0.5) / scale) kernel radii.
struct Picture {
    int width = 1024;
    int height = 1024;
    double scale = 32;      ///< pixels per kernel radius, in [2, 4096]
    double frequency = 4;   ///< cycles per kernel radius, in [0.001, 1024]
    double orientation = 0; ///< direction of the wave vector in degrees, from right towards down
    std::uint32_t seed = 0;
    std::string recipe = std::string(noise::recipes().front().name);
    bool tileable =
        false; ///< whether it continues from each edge at the opposite one; needs 2 kernel radii each way
    double time = 0;         ///< in periods of an animation that ends where it began
    bool quadrature = false; ///< whether the noise with cosines for sines stands beside it
    bool gradient = false;   ///< and its derivatives, per kernel radius
};

/// The channels of a picture's pixels, in the order of their values, as EXR names them: `Y` is the noise.
std::vector<std::string> channels(const Picture& picture);

constexpr int largest_side = 65536;
constexpr double smallest_scale = 2;
constexpr double largest_scale = 4096;
constexpr double smallest_frequency = 0.001;
constexpr double largest_frequency = 1024;

/// Throws RequestError when a value is outside its range, naming it and the range.
void check(const Picture& picture);

/// The picture as one JSON object, as kept in the `gabor` attribute of our EXR files, and back.
/// `from_json` lets absent values be; throws RequestError on anything that it does not know.
std::string to_json(const Picture& picture);
Picture from_json(std::string_view json);

} // namespace gabor::render
