#pragma once

#include "noise/lobe.hpp"
#include "noise/recipe.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::render {

/// One lobe of a spectrum: as noise::Lobe, with angles in degrees.
struct Lobe {
    double frequency = 4;          ///< cycles per kernel radius, in [0.001, 1024]
    double orientation = 0;        ///< degrees, from right towards down
    double frequency_spread = 0;   ///< waves are evenly spread within frequency (1 +- this), in [0, 1]
    double orientation_spread = 0; ///< and within orientation +- this, degrees in [0, 90]; 90 is isotropic
    double power = 1;              ///< in proportion to other lobes', at least 0
};

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
    double time = 0;               ///< in periods of an animation that ends where it began
    bool quadrature = false;       ///< whether the noise with cosines for sines stands beside it
    bool gradient = false;         ///< and its derivatives, per kernel radius
    double frequency_spread = 0;   ///< as in Lobe
    double orientation_spread = 0; ///< as in Lobe
    std::vector<Lobe> lobes = {};  ///< where there are any, instead of the four values of the one lobe
    bool sum = false;              ///< whether lobes are independent noises, not chosen for each impulse
    bool filter = false;           ///< whether pixels are seen through a normal filter of half a pixel
    std::string view = "flat";     ///< of `views`: `horizon` is a plane in perspective, of the scale at its
                                   ///< bottom row; see SolidPicture for `slice`, `sphere` and `torus`
    std::string paint = {}; ///< an EXR with channels `frequency` and `orientation`, in degrees, that is
                            ///< stretched over the picture and takes the place of these two values
    bool phasor = false;    ///< whether phase, in turns, and intensity stand beside the noise
    int values = 1;         ///< uncorrelated noises in each pixel, 1 to 4
    bool solid = false;     ///< whether a body is cut out of noise in space, not covered with surface noise
    double depth = 0;       ///< of a slice, kernel radii, in [-1e6, 1e6]
};

/// The names that Picture::view may have, in the order in which help texts list them.
std::span<const std::string_view> views();

/// Whether the view is of noise in space: with a recipe of its own, and either one orientation or all.
bool is_in_space(const Picture& picture);

/// The lobes in effect, angles in radians.
std::vector<noise::Lobe> spectrum(const Picture& picture);

/// The channels of a picture's pixels, in the order of their values, as EXR names them: `Y` is the noise.
std::vector<std::string> channels(const Picture& picture);

constexpr int largest_side = 65536;
constexpr double smallest_scale = 2;
constexpr double largest_scale = 4096;
constexpr double smallest_frequency = 0.001;
constexpr double largest_frequency = 1024;
constexpr std::size_t largest_spectrum = 16; ///< lobes

/// Throws RequestError when a value is outside its range, naming it and the range.
void check_range(std::string_view name, double value, double low, double high);

/// Throws RequestError when a value is outside its range, or excludes another.
void check(const Picture& picture);

/// The picture as one JSON object, as kept in the `gabor` attribute of our EXR files, and back.
/// `from_json` lets absent values be; throws RequestError on anything that it does not know.
std::string to_json(const Picture& picture);
Picture from_json(std::string_view json);

/// The lobes of a JSON list, or of the `lobes` of a picture's object; throws RequestError where there are
/// none.
std::vector<Lobe> lobes_from_json(std::string_view json);

} // namespace gabor::render
