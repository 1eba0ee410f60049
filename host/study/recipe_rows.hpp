#pragma once

#include "study/study.hpp"
#include "study/variant.hpp"

namespace gabor::study {

inline constexpr std::string_view recipe_columns =
    "window,lattice,law,floor,jitter,N,R,samples,visited,cvm,cvm_low,cvm_high,variance,places_interdecile,"
    "places_chance,contrast_interdecile,sidelobe_db,outside";

/// Every criterion of one recipe: Gaussianity, the variance at each place of a
/// cell, the contrast of windows, spectral purity.
Row recipe_row(const vulkan::Device& device, const Variant& variant, const Effort& effort);

/// The same of the seminal noise, which is no variant.
Row seminal_row(const vulkan::Device& device, const Effort& effort);

} // namespace gabor::study
