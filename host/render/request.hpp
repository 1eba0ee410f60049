#pragma once

#include "noise/colour.hpp"
#include "noise/lobe.hpp"
#include "noise/recipe.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gabor::render {

/// The noise in the plane: pixel (x, y), rows growing downwards, shows it at
/// ((x + 0.5) / scale, (y + 0.5) / scale) kernel radii.
struct Plane {
    bool tileable = false; ///< continues from each edge at the opposite one; needs 2 kernel radii each way
    bool operator==(const Plane&) const = default;
};

/// A plane in perspective, of the request's scale at its bottom row, under an empty sky.
struct Horizon {
    bool operator==(const Horizon&) const = default;
};

/// The plane z = depth of noise in space.
struct Slice {
    double depth = 0; ///< kernel radii
    bool operator==(const Slice&) const = default;
};

enum class Shape { sphere, torus };

/// A sphere or a torus around the axis z that carries noise, in perspective. It fits the shorter side of the
/// picture, and has the request's scale where a sphere is nearest.
struct Body {
    Shape shape = Shape::sphere;
    bool solid = false; ///< cut out of noise in space; else waves lie in the tangent plane of its surface
    double yaw = 0;     ///< of the eye around the axis, degrees
    double pitch = 30;  ///< of the eye above the equator, degrees
    double zoom = 1;    ///< how much larger than to fit the picture the body is
    bool operator==(const Body&) const = default;
};

using View = std::variant<Plane, Horizon, Slice, Body>;

/// Everything that decides the pixels of a picture. render/parameters.hpp has the table of what is in it:
/// names, units, ranges, help. Pixels are within 2e-5 standard deviations of the exact noise up to frequency
/// 4; above, and for the sine kernels of `paper` below 0.1, in proportion to the frequency and its inverse.
struct Request {
    int width = 1024;  ///< pixels
    int height = 1024; ///< pixels
    double scale = 32; ///< pixels per kernel radius
    noise::Recipe recipe = noise::recipes().front();
    std::vector<noise::Lobe> lobes = std::vector<noise::Lobe>(1); ///< at least one
    std::uint32_t seed = 0;
    double time = 0; ///< in periods of an animation that ends where it began
    View view = Plane();
    std::string material =
        "none"; ///< what to make of noises of its own, in place of the noise: see render/material.hpp
    bool filter = false;    ///< pixels are seen through a normal filter with a deviation of half a pixel
    std::string paint = {}; ///< an EXR with channels `frequency` and `orientation`, in degrees, stretched
                            ///< over the picture in place of those of the lobe; empty for none

    // What stands beside the noise in each pixel.
    bool quadrature = false; ///< the noise with cosines for sines
    bool gradient = false;   ///< derivatives per kernel radius; on a body along the picture's right and down
    bool phasor = false;     ///< phase, in turns, and intensity
    int values = 1;          ///< uncorrelated noises, 1 to 4

    /// Channels R, G and B in place of the noise. Its weights are of the lobes, in their order.
    std::optional<noise::Colour> colour = {};

    bool operator==(const Request&) const = default;
};

/// Whether a view shows a plane from above, at one scale.
bool is_flat(const View& view);

/// Whether it is seen in perspective on a horizon.
bool in_perspective(const Request& request);

/// Whether the waves run along a body's surface, and not through it.
bool along_surface(const Request& request);

/// Whether the view is of noise in space, a slice or a body.
bool in_space(const Request& request);

/// Whether it is a picture of a material in place of the noise.
bool has_material(const Request& request);

/// The recipe that draws it: the one asked for, but in space always `lattice`.
noise::Recipe drawing_recipe(const Request& request);

/// Whether its pixels can be filtered: in the plane by the recipe `lattice` alone.
bool can_filter(const Request& request);

/// Whether waves have all orientations: noise in space has one, or all.
bool is_isotropic(const noise::Lobe& lobe);

/// The channels of a picture's pixels, in the order of their values, as EXR names them: `Y` is the noise, and
/// in space `A`, the last one, the share of the pixel that is covered.
std::vector<std::string> channels(const Request& request);

} // namespace gabor::render
