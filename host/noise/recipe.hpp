#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::noise {

/// A noise of the drop-ins, with its compile-time trade-offs: the GABOR_ macros of
/// shaders/gabor_lattice.glsl, or of shaders/gabor_noise.glsl, the sparse one.
struct Recipe {
    std::string_view name;
    int impulses;                ///< N, impulses per cell (GABOR_IMPULSES)
    float radius;                ///< R, cells per kernel radius (GABOR_RADIUS)
    float weight_floor;          ///< A, magnitudes are A or 1, equally likely (GABOR_WEIGHT_FLOOR)
    int phases;                  ///< 2 is a sine with random sign (GABOR_PHASES)
    std::array<float, 3> window; ///< c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2 (GABOR_WINDOW)
    std::string_view summary;    ///< for help texts
    int taps = 0; ///< nodes along each axis that reach a point (GABOR_TAPS), R is half of it; 0: sparse

    bool is_lattice() const { return taps > 0; }
    bool operator==(const Recipe&) const = default;
};

/// The known recipes; the first is the default.
std::span<const Recipe> recipes();

/// Those of the sparse noise; the first is what its drop-in does by itself.
std::span<const Recipe> sparse_recipes();

/// The drop-in's file in shaders/.
std::string_view drop_in(const Recipe& recipe);

/// The recipe of that name, or of the values that `to_string` gives, by its name where it has one. Throws
/// RequestError, saying what is accepted, for anything else.
Recipe find_recipe(std::string_view text);

/// What `find_recipe` accepts, for help texts and messages.
std::string accepted_recipes();

/// The name of a known recipe; else its values: "N=1,R=1,A=0.675,phases=256,window=3:-4.5:2.5".
std::string to_string(const Recipe& recipe);

/// A macro to define before the drop-in.
struct Macro {
    std::string_view name;
    std::string value;
};

/// Those of a recipe that differ from its drop-in's own.
std::vector<Macro> macros(const Recipe& recipe);

/// Whether these are values that the sparse noise takes, and within reason.
bool acceptable(const Recipe& recipe);
constexpr int most_impulses = 16;
constexpr float largest_radius = 3;

/// Cells visited along each axis: ceil(2 R) + 1, or the lattice's nodes.
int visited_cells(const Recipe& recipe);

/// Impulses, or nodes, visited for each evaluation of the noise.
int visited_impulses(const Recipe& recipe);

} // namespace gabor::noise
