#pragma once

#include "noise/colour.hpp"
#include "noise/lobe.hpp"
#include "noise/recipe.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gabor::render {

/// The plane: pixel (x, y), with y growing downwards, shows the noise at ((x + 0.5) / scale, (y + 0.5) /
/// scale) kernel radii.
struct Plane {
    bool tileable = false; ///< opposite edges match; each side must be at least 2 kernel radii
    bool operator==(const Plane&) const = default;
};

/// A plane in perspective under an empty sky, with the request's scale at its bottom row.
struct Horizon {
    bool operator==(const Horizon&) const = default;
};

/// A cut through noise in space: the plane z = depth.
struct Slice {
    double depth = 0; ///< depth in kernel radii
    bool operator==(const Slice&) const = default;
};

enum class Shape { sphere, torus };

/// A sphere or a torus around the z axis, in perspective. It fits the shorter side of the picture; the scale
/// applies at the nearest point of a sphere.
struct Body {
    Shape shape = Shape::sphere;
    bool solid = false; ///< carved out of noise in space; otherwise waves lie in the tangent plane
    double yaw = 0;     ///< camera azimuth, in degrees
    double pitch = 30;  ///< camera elevation above the equator, in degrees
    double zoom = 1;    ///< 1 fits the body to the picture
    bool operator==(const Body&) const = default;
};

/// Eroded hills, which are about four kernel radii wide.
struct Terrain {
    bool perspective = false; ///< shown in perspective under a sky; otherwise from above
    double extent = 0;     ///< width of the picture in the unit of heights; 0 gives heights in kernel radii
    bool tileable = false; ///< opposite edges match; only from above
    double yaw = 215;      ///< camera azimuth in degrees; only in perspective
    double pitch = 20;     ///< camera elevation, in degrees
    double zoom = 1;       ///< 1 shows about as much as the view from above
    double focal_length = 28.8; ///< of the camera, in mm: see `focal_ratio`
    bool operator==(const Terrain&) const = default;
};

/// A sea in perspective under a clear sky. The wind blows along +x.
struct Sea {
    double wind = 10;            ///< metres per second
    double fetch = 200000;       ///< metres of open water upwind
    double swell_height = 0;     ///< significant height in metres, 0 for none
    double swell_period = 12;    ///< seconds
    double swell_direction = 60; ///< where it goes: degrees from +x towards +y
    int loop_seconds = 0;        ///< after which all repeats, a power of 2, or 0
    double seconds = 0;          ///< time
    double altitude = 8;         ///< of the camera, in metres
    double yaw = 250;            ///< camera azimuth in degrees
    double pitch = 6;            ///< angle by which the camera looks down, in degrees
    double zoom = 1;             ///< factor of the focal length
    double focal_length = 28.8;  ///< of the camera, in mm: see `focal_ratio`
    bool operator==(const Sea&) const = default;
};

/// What can surround a lit surface, as in shaders/passes/light.glsl.
inline constexpr std::array<std::string_view, 3> environments{"room", "overcast", "dark"};

/// What can cover terrain, as in shaders/passes/landscape.glsl.
inline constexpr std::array<std::string_view, 4> covers{"alpine", "meadow", "desert", "badlands"};

using View = std::variant<Plane, Horizon, Slice, Body, Terrain, Sea>;

/// The value of `material` that draws the noise itself.
constexpr std::string_view no_material = "none";

/// Everything that decides the pixels of a picture. render/request/parameters.hpp has the table of names,
/// units, ranges and help. Pixels are within 2e-5 standard deviations of the exact noise up to frequency 4.
/// Above that, the error grows with the frequency; with the sine kernels of `paper`, it also grows as the
/// frequency falls below 0.1.
struct Request {
    int width = 1024;  ///< pixels
    int height = 1024; ///< pixels
    double scale = 32; ///< pixels per kernel radius
    noise::Recipe recipe = noise::recipes().front();
    std::vector<noise::Lobe> lobes = std::vector<noise::Lobe>(1); ///< at least one
    std::uint32_t seed = 0;
    double evolution = 0; ///< of the noise in place, which repeats after 1; see Sea::seconds
    View view = Plane();
    std::string material{no_material}; ///< drawn in place of the noise; see render/request/material.hpp
    std::map<std::string_view, std::array<double, 3>> look = {}; ///< parameters of the material or of erosion
                                                                 ///< that differ from their defaults, by name
    double light_azimuth = -135; ///< degrees; azimuth of a material's lamp or of the sun over terrain
    double light_elevation = 38;
    bool boards = false;    ///< lay the material as planks or tiles
    int cover = 0;          ///< what covers terrain: an index in `covers`
    int environment = 0;    ///< what surrounds a material besides its lamp: an index in `environments`
    bool filter = false;    ///< antialias with a Gaussian filter (standard deviation: half a pixel)
    std::string paint = {}; ///< a map of frequency and orientation, stretched over the picture: see
                            ///< load_paint; empty for none

    // The following members add channels.
    bool quadrature = false; ///< the noise with cosines instead of sines; only for the viewer's phase
    bool gradient = false;   ///< derivatives to the right and down, per kernel radius
    bool phasor = false;     ///< phase, in turns, and intensity

    /// If set, channels R, G and B replace the noise. The colour's weights are in the order of the lobes.
    std::optional<noise::Colour> colour = {};

    bool operator==(const Request&) const = default;
};

/// Tells whether a view looks straight down on the plane, a slice or terrain.
bool is_flat(const View& view);

/// Tells whether the picture is a plane whose opposite edges match.
inline bool is_tiled(const Request& request) {
    const Plane* plane = std::get_if<Plane>(&request.view);
    return plane && plane->tileable;
}

/// Tells whether the view is a horizon.
inline bool in_perspective(const Request& request) {
    return std::holds_alternative<Horizon>(request.view);
}

/// Tells whether the waves run along a body's surface instead of through it.
inline bool along_surface(const Request& request) {
    const Body* body = std::get_if<Body>(&request.view);
    return body && !body->solid;
}

/// Tells whether the view shows noise in space: a slice or a body.
inline bool in_space(const Request& request) {
    return std::holds_alternative<Slice>(request.view) || std::holds_alternative<Body>(request.view);
}

/// Tells whether terrain is drawn in place of the noise.
inline bool has_terrain(const Request& request) {
    return std::holds_alternative<Terrain>(request.view);
}

/// Tells whether a sea is drawn in place of the noise.
inline bool has_sea(const Request& request) {
    return std::holds_alternative<Sea>(request.view);
}

/// Tells whether a material, terrain or a sea is drawn in place of the noise.
inline bool has_material(const Request& request) {
    return request.material != no_material || has_terrain(request) || has_sea(request);
}

/// Returns the same terrain from above instead of in perspective, or any other request unchanged.
Request from_above(Request request);

/// The shortest side of a tile, in kernel radii; 0 for a material, which fits any tile.
double least_tile(const Request& request);

/// A focal length relative to the longer side of the picture, for a sensor whose longer side has 36 mm.
constexpr double focal_ratio(double millimetres) {
    return millimetres / 36;
}

/// The number of a terrain's height units per kernel radius.
double terrain_unit(const Request& request);

/// The most that a terrain's erosion raises or lowers hills, in kernel radii.
double erosion_reach(const Request& request);

/// The heights of gabor_terrain stay within this distance of 0, which is six standard deviations.
inline constexpr double hill_reach = 2;

/// The components, to the right and down, of the unit vector towards the lamp or the sun.
std::array<double, 2> light_direction(const Request& request);

/// The recipe that draws the request; in space, always `lattice`.
inline noise::Recipe drawing_recipe(const Request& request) {
    return in_space(request) ? noise::find_recipe("lattice") : request.recipe;
}

/// Tells whether pixels can be filtered: in the plane, only with the `lattice` recipe.
inline bool can_filter(const Request& request) {
    return drawing_recipe(request) == noise::find_recipe("lattice");
}

/// Tells whether the waves of a lobe have all orientations.
constexpr bool is_isotropic(const noise::Lobe& lobe) {
    return lobe.orientation_spread == 90;
}

/// The channels of a picture's pixels, in order, as EXR names them: `Y` is the noise; in space, the last
/// channel, `A`, is the covered share of the pixel. If `normals` is set, a body also has normal.x, normal.y,
/// normal.z and gradient.z before `A`, where x points right in the picture, y down and z towards the eye.
std::vector<std::string> channels(const Request& request, bool normals = false);

} // namespace gabor::render
