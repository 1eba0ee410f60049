#pragma once

// The figures of the paper (figures.cpp), and further questions, each in the file of that name.

#include "noise/recipe.hpp"
#include "study/study.hpp"
#include "study/variant.hpp"

#include <utility>

namespace gabor::study {

using Tables = std::vector<Table>;
using Folder = std::filesystem::path;

/// The figures of the paper and of this study. They write pictures into `folder`.
Tables figure1(const vulkan::Device& device, const Effort& effort);
Tables figure2(const vulkan::Device& device, const Effort& effort);
void figure2_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder);
Tables figure3(const vulkan::Device& device, const Effort& effort);
Tables figure4(const vulkan::Device& device, const Effort& effort);
Tables figure5(const vulkan::Device& device, const Effort& effort);
Tables figure6(const vulkan::Device& device, const Effort& effort);
void figure6_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder);
Tables stationarity(const vulkan::Device& device, const Effort& effort);
Tables law(const vulkan::Device& device, const Effort& effort);
void law_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder);
Tables frontier(const vulkan::Device& device, const Effort& effort);
Tables future(const vulkan::Device& device, const Effort& effort);

/// N* of a cvm: the N at which the seminal noise has this cvm, interpolated in logarithms from its measured
/// curve. Beyond the curve, its asymptote is used: cvm = 2^18 (k / (24 N))^2 C with its excess kurtosis k / N
/// (Edgeworth's series, C = integral of (He3 phi)^2 dPhi = 7 / (9 sqrt(3) pi)). Infinite unless cvm is
/// positive.
class SeminalCurve {
  public:
    void add(int n, double cvm);
    double equivalent(double cvm) const;

  private:
    std::vector<std::pair<double, double>> points_; ///< log cvm, log N
};

inline constexpr std::string_view recipe_columns =
    "window,lattice,law,floor,jitter,N,R,samples,visited,cvm,cvm_low,cvm_high,variance,places_interdecile,"
    "places_chance,contrast_interdecile,sidelobe_db,outside,cvm_places,cvm_places_low,cvm_places_high";

/// All criteria of one recipe: Gaussianity over all places and at each place of a cell, variance at each
/// place, contrast of windows, spectral purity.
Row recipe_row(const vulkan::Device& device, const Variant& variant, const Effort& effort);

/// The same for a recipe of the lattice.
Row lattice_row(const vulkan::Device& device, const noise::Recipe& recipe, const Effort& effort);

/// The same for the seminal noise.
Row seminal_row(const vulkan::Device& device, const Effort& effort);

/// Appends 1 to each of these rows that is on the Pareto front, 0 to the others. On the front, the variance
/// is stationary, and no other such row is at least as good in visits, Gaussianity at places and sidelobes,
/// and better in one.
void mark_pareto(std::vector<Numbers>& rows);

} // namespace gabor::study
