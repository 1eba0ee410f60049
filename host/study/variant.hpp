#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::study {

// In the order of shaders/passes/recipes.comp.
enum class Lattice { square, brick };
enum class Law { uniform, two_point, rayleigh };
enum class Shape { separable, radial, gaussian };

std::string_view name(Lattice lattice);
std::string_view name(Law law);
std::string_view name(Shape shape);

/// A window: q(x) q(y), q(|d|) with q(x) = u^2 (c0 + c1 u + c2 u^2), u = 1 - x^2, or the truncated Gaussian.
struct Window {
    std::string_view name;
    Shape shape = Shape::separable;
    std::array<double, 3> c{1, 0, 0};
};

double value(const Window& window, double x, double y);

/// A recipe around the drop-in's: random phases, and choices that the drop-in does not have.
struct Variant {
    Window window;
    int impulses = 1;  ///< N, per cell
    double radius = 1; ///< R, cells
    Lattice lattice = Lattice::square;
    Law law = Law::two_point; ///< of the magnitudes, whose phases are random
    double floor = 1;         ///< A; unused by the Rayleigh law
    double jitter = 1;        ///< how far impulses are from the centre of their cell; 0 for a regular grid
};

/// The specialization constants of passes/recipes.comp.
std::vector<std::uint32_t> constants(const Variant& variant);

/// N R^2 E[w^2] integral(window^2) / 2: the mean over all places, and at each place where jitter is 1.
double variance(const Variant& variant);

/// How many impulses there are, on average, in the cells whose impulses can reach a place: N (2 R +
/// jitter)^2.
double visited(const Variant& variant);

/// The floor, in steps of 1/1000, with which the noise is nearest to a normal law by its cumulants of orders
/// 4 and 6, which a Cramér-von Mises index sees together.
double best_floor(const Variant& variant);

} // namespace gabor::study
