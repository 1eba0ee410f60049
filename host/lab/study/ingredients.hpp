#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::study {

/// The wave of a kernel. The study uses an oblique wave, so that no grid axis is special.
struct PlaneWave {
    double frequency = 4;                      ///< cycles per kernel radius
    double orientation = std::numbers::pi / 4; ///< radians
};

/// The ingredients, numbered as in passes/gabor_ingredients.glsl.
enum class Points { poisson, stratified, jittered, jittered_hex, sobol, scrambled_sobol };
enum class Weights { uniform, bernoulli, none };
enum class Kernel { cosine, sine, random_phase };
enum class Envelope { gaussian, c0, c1_radial, c1_separable };

/// All ingredients of each kind.
inline constexpr std::array all_points{Points::poisson,      Points::stratified, Points::jittered,
                                       Points::jittered_hex, Points::sobol,      Points::scrambled_sobol};
inline constexpr std::array all_weights{Weights::uniform, Weights::bernoulli, Weights::none};
inline constexpr std::array all_kernels{Kernel::cosine, Kernel::sine, Kernel::random_phase};
inline constexpr std::array all_envelopes{Envelope::gaussian, Envelope::c0, Envelope::c1_radial,
                                          Envelope::c1_separable};

/// Returns an ingredient's name in the paper, in lower case, as tables show it.
std::string_view name(Points points);
std::string_view name(Weights weights);
std::string_view name(Kernel kernel);
std::string_view name(Envelope envelope);

/// One of the noises compared in [TNVT19]; the default is the seminal noise. A cell's side is the kernel
/// radius.
struct Ingredients {
    Points points = Points::poisson;
    Weights weights = Weights::uniform;
    Kernel kernel = Kernel::cosine;
    Envelope envelope = Envelope::gaussian;
    int impulses = 30; ///< N, impulses per cell; for Poisson points, their mean
    int period = 0;    ///< period in cells, at least 3; 0 for an instance that does not repeat

    bool operator==(const Ingredients&) const = default;
};

/// The paper's advice: stratified points, Bernoulli weights and two impulses per cell.
inline constexpr Ingredients recommended{
    Points::stratified, Weights::bernoulli, Kernel::cosine, Envelope::gaussian, 2, 0};

/// Returns the values of the columns "points,weights,kernel,envelope,N", with which tables begin.
std::string csv_fields(const Ingredients& ingredients);

/// The lattice (i / n, i step / n) mod 1: n points in each unit cell, the same in all cells. Its Voronoi
/// cells are equal hexagons that tile the plane.
struct HexagonalLattice {
    int step = 0;
    std::array<double, 2> a{}; ///< a reduced basis with a.b >= 0
    std::array<double, 2> b{};
    double overhang = 0; ///< how far hexagons extend beyond the unit cell, at most 1/2
};

/// Returns the lattice with n points per cell that maximizes the least distance between points.
HexagonalLattice hexagonal_lattice(int n);

/// Returns the specialization constants of passes/ingredients.glsl.
std::vector<std::uint32_t> constants(const Ingredients& ingredients);

/// Returns the variance of the sum by Campbell's theorem: N E[w^2] times the energy of the kernel. Exact for
/// weights with mean 0 and for Poisson points; other points without weights have a smaller variance.
double variance(const Ingredients& ingredients, const PlaneWave& wave);

/// Returns the excess kurtosis of the sum with Poisson points: N E[w^4] integral(g^4) / variance^2 by
/// Campbell's theorem.
double poisson_kurtosis(const Ingredients& ingredients, const PlaneWave& wave);

/// Returns the excess kurtosis of the sum with stratified points, averaged over the positions in a cell:
/// sum_c N (m4 - 3 m2^2) / variance^2, where m2 and m4 are moments of one impulse of cell c. Only for the
/// cosine and the sine.
double stratified_kurtosis(const Ingredients& ingredients, const PlaneWave& wave);

} // namespace gabor::study
