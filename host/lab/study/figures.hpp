#pragma once

// The paper's figures (figures.cpp) and further studies, each in the file named after it.

#include "noise/recipe.hpp"
#include "study/study.hpp"
#include "study/variant.hpp"

#include <utility>

namespace gabor::study {

using Tables = std::vector<Table>;
using Folder = std::filesystem::path;

/// Each function returns the tables of a figure or study, or writes its pictures into `folder`.
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

/// Computes N* of a cvm: the N with which the seminal noise reaches that cvm. Interpolates the measured curve
/// logarithmically; beyond it, uses the limit cvm = 2^18 (k / (24 N))^2 C for the excess kurtosis k / N
/// (Edgeworth's series, C = integral of (He3 phi)^2 dPhi = 7 / (9 sqrt(3) pi)). Infinite if cvm is not
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

/// Returns a row with all criteria of one recipe: Gaussianity over all positions and at each position in a
/// cell, variance at each position, contrast of windows, and spectral purity.
Row recipe_row(const vulkan::Device& device, const Variant& variant, const Effort& effort);

/// Returns a row with the same criteria for a lattice recipe.
Row lattice_row(const vulkan::Device& device, const noise::Recipe& recipe, const Effort& effort);

/// Returns a row with the same criteria for the seminal noise.
Row seminal_row(const vulkan::Device& device, const Effort& effort);

/// Appends 1 to rows on the Pareto front and 0 to others. A row is on the front if its variance is stationary
/// and no other stationary row is at least as good in impulses visited, mean cvm over positions and
/// sidelobes, and better in one.
void mark_pareto(std::vector<Numbers>& rows);

} // namespace gabor::study
