#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::noise {

/// A noise with its compile-time options: the GABOR_ macros of shaders/gabor_noise.glsl, or of
/// shaders/gabor_sparse.glsl, the sparse noise.
struct Recipe {
    std::string_view name;
    int impulses;                ///< N, impulses per cell (GABOR_IMPULSES)
    float radius;                ///< R, cells per kernel radius (GABOR_CELLS_PER_RADIUS)
    float weight_floor;          ///< A; magnitudes are A or 1, equally likely (GABOR_WEIGHT_FLOOR)
    int phases;                  ///< number of phases; 2 gives a sine with random sign (GABOR_PHASES)
    std::array<float, 3> window; ///< c in q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2 (GABOR_WINDOW)
    std::string_view summary;    ///< description for help texts
    int taps = 0; ///< nodes along each axis that reach a point (GABOR_TAPS), twice R; 0 for sparse noise

    bool is_lattice() const { return taps > 0; }
    bool operator==(const Recipe&) const = default;
};

/// The known recipes; the first is the default.
std::span<const Recipe> recipes();

/// The known recipes of the sparse noise; the first is its drop-in's default.
std::span<const Recipe> sparse_recipes();

/// The drop-in's file in shaders/.
std::string_view drop_in(const Recipe& recipe);

/// The known recipe of that name. Throws std::out_of_range if there is none.
const Recipe& find_recipe(std::string_view name);

/// A macro to define before including the drop-in.
struct Macro {
    std::string_view name;
    std::string value;
    bool operator==(const Macro&) const = default;
};

/// The macros of a recipe that differ from its drop-in's defaults.
std::vector<Macro> macros(const Recipe& recipe);

/// The number of cells summed along each axis: ceil(2 R) + 1, or for a lattice the number of taps.
int visited_cells(const Recipe& recipe);

/// Impulses, or nodes, summed for each value of the noise.
int visited_impulses(const Recipe& recipe);

} // namespace gabor::noise
