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
    bool fitted = false; ///< fitted to this picture rather than known from theory

    double variance() const { return deviation * deviation; }
};

/// Fits a normal distribution to a picture's moments. If the variance is 0, the deviation is set to 1.
NormalDistribution fitted_normal(const Moments& moments);

/// Estimates for the noise behind one picture, whose pixels are correlated.
struct BlockEstimates {
    int blocks_per_side = 0;
    Estimate mean;
    Estimate variance;
    Estimate cvm;            ///< index as defined in Gaussianity
    double smallest_cvm = 0; ///< 95 % of pictures of normal noise of this size are below this

    bool operator==(const BlockEstimates&) const = default;
};

/// A picture cut into 16 x 16 blocks. Blocks are joined 2 x 2 until they are longer than the distance over
/// which pixels are correlated. Then blocks that do not touch are independent, and the cvm is estimated from
/// pairs of such blocks.
class Blocks {
  public:
    Blocks(int width, int height, const NormalDistribution& expected);

    /// Adds pixels of row `y`, starting at column `x`. Throws std::domain_error for NaN.
    void add(int x, int y, std::span<const float> pixels);

    /// Returns the moments of all pixels so far.
    Moments moments() const;

    /// `correlation` is the distance in pixels beyond which pixels are independent. Returns nothing if that
    /// leaves fewer than 8 x 8 blocks, or if all pixels are equal.
    std::optional<BlockEstimates> estimate(double correlation) const;

    /// The pixels of one block.
    struct Block {
        Moments moments;
        Counts counts;
    };

  private:
    int width_;
    int height_;
    NormalDistribution expected_;
    std::vector<Block> blocks_; ///< in row-major order
};

} // namespace gabor::statistics
