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
#include <vector>

namespace gabor::render {

/// What a picture shows.
enum class Kind {
    noise,
    fractal,  ///< a sum of octaves: see Fractal
    material, ///< the one that Request::material names
    terrain,  ///< eroded hills, which are about four kernel radii wide
    sea       ///< water under a clear sky
};

/// Whether pictures of a kind show a surface in the light, in colour, instead of the values of a noise.
constexpr bool is_surface(Kind kind) {
    return kind != Kind::noise && kind != Kind::fractal;
}

/// Whether a kind fills any plane or body, instead of being a place with views of its own.
constexpr bool is_pattern(Kind kind) {
    return kind != Kind::terrain && kind != Kind::sea;
}

/// How a picture shows its kind.
enum class Projection {
    flat,    ///< from above: pixel (x, y), y growing downwards, shows (x + 0.5, y + 0.5) / scale kernel radii
    horizon, ///< the plane in perspective under an empty sky, with the request's scale at its bottom row
    slice,   ///< a cut through noise in space: the plane z = depth
    sphere,  ///< around the z axis, fitting the shorter side; the scale applies at the nearest point
    torus,   ///< around the z axis, fitting the shorter side
    place    ///< terrain or a sea in perspective under a sky
};

/// A camera that turns around a body, around the middle of the terrain seen from above, or above a sea.
struct Orbit {
    double yaw = 0;    ///< azimuth in degrees
    double pitch = 30; ///< degrees above the equator or the ground, or by which it looks down on a sea
    double zoom = 1;   ///< 1 fits a body to the picture, or shows about as much as the flat view
    double focal_length = 28.8; ///< of a place, in mm: see `focal_ratio`
    double altitude = 8;        ///< above a sea, in metres
    bool operator==(const Orbit&) const = default;
};

/// The camera that shows a kind unless asked for otherwise.
constexpr Orbit default_orbit(Kind kind) {
    return kind == Kind::terrain ? Orbit{215, 20} : kind == Kind::sea ? Orbit{250, 6} : Orbit{};
}

struct View {
    Projection projection = Projection::flat;
    bool tileable = false; ///< opposite edges of a flat view match
    double depth = 0;      ///< of a slice, in kernel radii
    bool solid = false;    ///< a body carved out of noise in space; otherwise waves lie in the tangent plane
    Orbit orbit = {};
    bool operator==(const View&) const = default;

    bool is_body() const { return projection == Projection::sphere || projection == Projection::torus; }
    /// Whether the view is a plane seen from straight above.
    bool is_flat() const { return projection == Projection::flat || projection == Projection::slice; }
    /// Whether the view shows a pattern in space.
    bool in_space() const { return projection == Projection::slice || is_body(); }
    /// Whether waves run along a body's surface instead of through it.
    bool along_surface() const { return is_body() && !solid; }
    /// Whether the camera turns around what the view shows.
    bool has_orbit() const { return is_body() || projection == Projection::place; }
    bool has_horizon() const { return projection == Projection::horizon; }
};

/// What becomes of octaves, and the noise of an octave: GABOR_FBM and GABOR_SMOOTH of gabor_fractal.glsl and
/// their like, after the value that draws no fractal noise.
inline constexpr std::array<std::string_view, 4> fractal_shapes{"none", "fbm", "billow", "ridged"};
inline constexpr std::array<std::string_view, 2> fractal_bases{"smooth", "perlin"};

/// Fractal noise, as GaborFractal has it.
struct Fractal {
    int shape = 0; ///< an index in `fractal_shapes`: not 0 if the kind is fractal noise
    int basis = 0; ///< an index in `fractal_bases`
    double octaves = 5;
    double gain = 0.5;
    double lacunarity = 2;
    double turn = 36.87; ///< degrees between octaves
    double warp = 0;     ///< strength of a warp by fBm of the same octaves, in kernel radii
    bool operator==(const Fractal&) const = default;
};

/// The time of a sea. Request::look has its waves. The wind blows along +x.
struct Sea {
    int loop_seconds = 0; ///< after which all repeats, a power of 2, or 0
    double seconds = 0;   ///< time
    bool operator==(const Sea&) const = default;
};

/// What can surround a lit surface, as in shaders/passes/light.glsl.
inline constexpr std::array<std::string_view, 3> environments{"room", "overcast", "dark"};

/// The heights of hills stay within this distance of 0.
inline constexpr double hill_reach = 2;

/// What can cover terrain, as in shaders/passes/landscape.glsl.
inline constexpr std::array<std::string_view, 4> covers{"alpine", "meadow", "desert", "badlands"};

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
    Kind kind = Kind::noise;
    View view = {};
    std::string material{no_material}; ///< `no_material` unless the kind is a material; see material.hpp
    std::map<std::string_view, std::array<double, 3>> look =
        {};                      ///< parameters of the material, erosion or sea
                                 ///< that differ from their defaults, by name
    double light_azimuth = -135; ///< degrees; azimuth of a material's lamp or of the sun over terrain
    double light_elevation = 38;
    bool boards = false; ///< lay the material as planks or tiles
    bool coat = false;   ///< coat the material
    bool finish = false; ///< give the material a finish
    Sea sea = {};
    Fractal fractal = {};
    double extent = 0; ///< width of terrain in the unit of heights; 0 gives heights in kernel radii
    double water_level = -hill_reach; ///< of lakes in kernel radii; this one is below all ground
    int cover = 0;                    ///< what covers terrain: an index in `covers`
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

/// The components, to the right and down, of the unit vector towards the lamp or the sun.
std::array<double, 2> light_direction(const Request& request);

/// The recipe that draws the request; in space, always `lattice`.
inline noise::Recipe drawing_recipe(const Request& request) {
    return request.view.in_space() ? noise::find_recipe("lattice") : request.recipe;
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
