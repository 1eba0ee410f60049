#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::noise {

/// A noise of the drop-ins, with its compile-time trade-offs: for the sparse one the GABOR_ macros of
/// shaders/gabor_noise.glsl.
struct Recipe {
    enum class Kind { sparse }; ///< which drop-in

    std::string_view name;
    int impulses;                ///< N, impulses per cell (GABOR_IMPULSES)
    float radius;                ///< R, cells per kernel radius (GABOR_RADIUS)
    float weight_floor;          ///< A, magnitudes are A or 1, equally likely (GABOR_WEIGHT_FLOOR)
    int phases;                  ///< 2 is a sine with random sign (GABOR_PHASES)
    std::array<float, 3> window; ///< c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2 (GABOR_WINDOW)
    std::string_view is;         ///< what it is, for help texts
    Kind kind = Kind::sparse;

    bool operator==(const Recipe&) const = default;
};

/// The known recipes; the first is the default.
std::span<const Recipe> recipes();

/// The recipe of that name, or the one that is `spelled_out`, by its name where it has one. Throws
/// RequestError, saying what is accepted, for anything else.
Recipe find_recipe(std::string_view text);

/// What `find_recipe` accepts, for help texts and messages.
std::string accepted_recipes();

/// The name of a known recipe; else its values: "N=1,R=1,A=0.675,phases=256,window=3:-4.5:2.5".
std::string spelled_out(const Recipe& recipe);

/// A macro to define before the drop-in.
struct Macro {
    std::string_view name;
    std::string value;
};

/// Those of a recipe that differ from the drop-in's own.
std::vector<Macro> macros(const Recipe& recipe);

/// Whether these are values that the drop-in takes, and within reason.
bool acceptable(const Recipe& recipe);
constexpr int most_impulses = 16;
constexpr float largest_radius = 3;

/// Cells visited along each axis: ceil(2 R) + 1.
int visited_cells(const Recipe& recipe);

/// Impulses visited for each evaluation of the noise: (ceil(2 R) + 1)^2 N.
int visited_impulses(const Recipe& recipe);

} // namespace gabor::noise
