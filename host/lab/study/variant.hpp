#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::study {

/// Options, numbered as in host/lab/passes/variants.comp.
enum class Lattice { square, brick };
enum class Magnitudes { uniform, two_point, rayleigh };
enum class Shape { separable, radial, gaussian };

/// Returns an option's name, as tables show it.
std::string_view name(Lattice lattice);
std::string_view name(Magnitudes magnitudes);
std::string_view name(Shape shape);

/// A window: q(x) q(y) or q(|d|), where q(x) = u^2 (c0 + c1 u + c2 u^2) and u = 1 - x^2, or the truncated
/// Gaussian.
struct Window {
    std::string_view name;
    Shape shape = Shape::separable;
    std::array<double, 3> c{1, 0, 0};
};

/// Returns the value of the window at (x, y), in kernel radii.
double value(const Window& window, double x, double y);

/// A recipe with random phases and choices that the drop-in does not offer.
struct Variant {
    Window window;
    int impulses = 1;  ///< N, impulses per cell
    double radius = 1; ///< R, in cells
    Lattice lattice = Lattice::square;
    Magnitudes magnitudes = Magnitudes::two_point; ///< magnitudes of the amplitudes; phases are random
    double floor = 1;                              ///< A; unused by the Rayleigh distribution
    double jitter = 1; ///< 1: impulses are anywhere in their cell; 0: at its centre
};

/// Returns the specialization constants of passes/variants.comp.
std::vector<std::uint32_t> constants(const Variant& variant);

/// Returns N R^2 E[w^2] integral(window^2) / 2: the mean variance over all positions and, if jitter is 1,
/// the variance at each position.
double variance(const Variant& variant);

/// Returns the mean number of impulses in the cells whose impulses can reach a point: N (2 R + jitter)^2.
double visited(const Variant& variant);

/// Returns the floor, in steps of 1/1000, for which the cumulants of orders 4 and 6 together predict the
/// smallest Cramér-von Mises index.
double best_floor(const Variant& variant);

/// How much of a kernel's power is outside its main lobe. The spectrum of a kernel is that of its window,
/// shifted to the wave vector: a lobe up to the first minimum, then sidelobes.
struct SpectralPurity {
    double sidelobe = 0; ///< power of the largest sidelobe, in dB relative to the lobe's peak
    double outside = 0;  ///< share of the power that is outside the lobe
};

/// Computes the purity of a window q(x) q(y), or of a round one q(|d|), by quadrature of its Fourier
/// transform.
SpectralPurity spectral_purity(const std::function<double(double)>& q, bool separable);
SpectralPurity spectral_purity(const Window& window);

} // namespace gabor::study
