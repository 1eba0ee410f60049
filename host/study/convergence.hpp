#pragma once

#include "study/ingredients.hpp"
#include "study/study.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace gabor::study {

inline constexpr std::string_view convergence_columns =
    "points,weights,kernel,envelope,N,samples,cvm,cvm_low,cvm_high,variance";

/// The Gaussianity and the variance of one noise, over `effort.samples` instances.
Row convergence_row(const vulkan::Device& device, const Ingredients& ingredients, const Effort& effort);

/// N* of a cvm: the N with which the seminal noise has it, from that noise's own measured curve, interpolated
/// in logarithms; beyond that curve by the law that it follows, cvm = 2^18 (k / (24 N))^2 C with its excess
/// kurtosis k / N (Edgeworth's series, C = integral of (He3 phi)^2 dPhi = 7 / (9 sqrt(3) pi)). Infinite where
/// cvm is not positive.
class SeminalCurve {
  public:
    void add(int n, double cvm);
    double equivalent(double cvm) const;

  private:
    std::vector<std::pair<double, double>> points_; ///< log cvm, log N
};

} // namespace gabor::study
