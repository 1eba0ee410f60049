#pragma once

#include "statistics/estimate.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

/// The normal distribution with which a picture is compared.
struct NormalDistribution {
    double mean = 0;
    double deviation = 1;
    bool fitted = false; ///< to the same picture, not known from theory
};

/// For a picture of which nothing is known beforehand. A picture without variance gets the deviation 1.
NormalDistribution fitted_normal(const Moments& moments);

/// What can be said of the noise behind one picture, whose pixels are correlated.
struct BlockEstimates {
    int blocks_per_side = 0;
    Estimate mean;
    Estimate variance;
    Estimate cvm;            ///< index as in Gaussianity
    double smallest_cvm = 0; ///< what 95 % of normal pictures of this size do not exceed

    bool operator==(const BlockEstimates&) const = default;
};

/// A picture cut into 16 x 16 blocks. Blocks that do not touch are independent where the correlation is
/// shorter than a block; estimates rest on such pairs only. Blocks are joined, 2 x 2 at a time, until they
/// are longer than the correlation.
class Blocks {
  public:
    Blocks(int width, int height, const NormalDistribution& expected);

    /// Adds pixels of row `y`, from column `x` on. Throws std::domain_error at a NaN.
    void add(int x, int y, std::span<const float> pixels);

    /// Of all pixels so far.
    Moments moments() const;

    /// `correlation`: the distance in pixels beyond which pixels are independent.
    /// Nothing when that leaves fewer than 8 x 8 blocks.
    std::optional<BlockEstimates> estimate(double correlation) const;

  private:
    int width_;
    int height_;
    NormalDistribution expected_;
    std::vector<Moments> moments_; ///< row by row of blocks, as are the counts
    std::vector<Counts> counts_;
};

} // namespace gabor::statistics
