#include "statistics/blocks.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>

namespace gabor::statistics {

namespace {

constexpr int finest = 16;  ///< largest number of blocks per side
constexpr int coarsest = 8; ///< smallest number: 64 blocks in 16 groups
constexpr std::size_t bins_per_block =
    256; ///< enough, because deviations from a normal distribution are smooth: see test_blocks.cpp

/// The jackknife leaves out groups of blocks, each a sixteenth of the picture, so that correlation across
/// their borders matters little.
constexpr int groups_per_side = 4;
constexpr int groups = groups_per_side * groups_per_side;

struct Grid {
    int side;

    int blocks() const { return side * side; }
    int group(int block) const {
        return block / side * groups_per_side / side * groups_per_side +
               block % side * groups_per_side / side;
    }
    bool touch(int a, int b) const {
        return std::abs(a / side - b / side) <= 1 && std::abs(a % side - b % side) <= 1;
    }
};

/// The first pixel of block `index` along a side of `length` pixels.
int block_begin(int index, int length) {
    return static_cast<int>((std::int64_t(index) * length + finest - 1) / finest);
}

int block_of(int place, int length) {
    return static_cast<int>(std::int64_t(place) * finest / length);
}

/// Joins 2 x 2 blocks.
std::vector<Blocks::Block> coarsen(std::span<const Blocks::Block> blocks, int side) {
    const auto n = static_cast<std::size_t>(side);
    std::vector<Blocks::Block> joined(blocks.size() / 4);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        Blocks::Block& into = joined[i / n / 2 * (n / 2) + i % n / 2];
        into.moments.merge(blocks[i].moments);
        into.counts.resize(bins_per_block);
        add_to(into.counts, blocks[i].counts);
    }
    return joined;
}

/// The quantile of Student's t for a 95 % interval.
const double t_quantile = boost::math::quantile(boost::math::students_t(groups - 1), 0.975);

/// Returns a mean over all pixels with its interval; `excess` has each block's sum minus its expected share.
/// Across borders, noise is as often anticorrelated as correlated, so the interval is on the safe side.
Estimate mean_interval(double value, double pixels, std::span<const double> excess, const Grid& grid) {
    std::vector<double> sums(groups);
    for (int i = 0; i < grid.blocks(); ++i)
        sums[static_cast<std::size_t>(grid.group(i))] += excess[static_cast<std::size_t>(i)];
    double squares = 0;
    for (const double sum : sums)
        squares += sum * sum;
    return score_interval(value, squares / (pixels * pixels) * groups / (groups - 1.0), 0, t_quantile);
}

struct PairIndex {
    Estimate index;
    double smallest; ///< smallest index that can be distinguished from a normal distribution's
};

/// Estimates the index from pairs of blocks that do not touch. For such a pair, the G_i = n_i (F_i - Phi) are
/// independent, and their expectation is n_i times the true deviation, so that
///     sum_ij G_i . G_j / sum_ij n_i n_j
/// estimates the integral of (F - Phi)^2 dPhi without bias.
///
/// This estimate, U, is a U-statistic. Let h_IJ be the sum of G_i . G_j - index n_i n_j over the pairs from
/// groups I and J. Leaving out one group at a time gives, to first order, the variance
/// 4 sum_I (sum_J h_IJ)^2 / (sum n n)^2. For a normal distribution, U is degenerate, and its variance,
/// 2 sum_IJ h_IJ^2 / (sum n n)^2, is half of that (Hoeffding, 1948). As in Gaussianity::index, the first
/// variance is taken to be proportional to the index, with noise included in both.
PairIndex pair_index(const std::vector<std::vector<double>>& deviation, std::span<const Blocks::Block> blocks,
                     const Grid& grid) {
    std::vector<double> sum(bins_per_block);
    double pixels = 0;
    std::vector<double> products(groups * groups);
    std::vector<double> weights(groups * groups);
    for (int i = 0; i < grid.blocks(); ++i) {
        for (int j = 0; j < grid.blocks(); ++j) {
            if (grid.touch(i, j))
                continue;
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            const auto place = static_cast<std::size_t>(grid.group(i) * groups + grid.group(j));
            products[place] += integrate_product(deviation[a], deviation[b]);
            weights[place] += static_cast<double>(blocks[a].moments.count()) *
                              static_cast<double>(blocks[b].moments.count());
        }
        const auto a = static_cast<std::size_t>(i);
        add_to(sum, deviation[a]);
        pixels += static_cast<double>(blocks[a].moments.count());
    }

    // This estimate uses all pairs, so it is positive and includes the noise.
    const double biased = integrate_product(sum, sum) / (pixels * pixels);
    const double weight = std::reduce(weights.begin(), weights.end());
    const double index = std::reduce(products.begin(), products.end()) / weight;
    double jackknife = 0;
    double degenerate = 0;
    for (int a = 0; a < groups; ++a) {
        double row = 0;
        for (int b = 0; b < groups; ++b) {
            const auto place = static_cast<std::size_t>(a * groups + b);
            const double h = products[place] - index * weights[place];
            row += h;
            degenerate += 2 * h * h;
        }
        jackknife += 4 * row * row;
    }
    const double variance_scale = cvm_scale * cvm_scale / (weight * weight);
    const double slope = variance_scale * jackknife / (cvm_scale * biased);
    const double null_variance = variance_scale * degenerate;
    return {score_interval(cvm_scale * index, null_variance, slope, t_quantile),
            t_quantile * std::sqrt(null_variance)};
}

} // namespace

NormalDistribution fitted_normal(const Moments& moments) {
    const double variance = moments.variance();
    return {moments.count() > 0 ? moments.mean() : 0, variance > 0 ? std::sqrt(variance) : 1, true};
}

Blocks::Blocks(int width, int height, const NormalDistribution& expected)
    : width_(width), height_(height), expected_(expected),
      blocks_(finest * finest, {{}, Counts(bins_per_block)}) {}

void Blocks::add(int x, int y, std::span<const float> pixels) {
    const int row = block_of(y, height_);
    while (!pixels.empty()) {
        const int column = block_of(x, width_);
        const auto length = static_cast<std::size_t>(block_begin(column + 1, width_) - x);
        const auto part = pixels.first(std::min(length, pixels.size()));
        Block& block = blocks_[static_cast<std::size_t>(row * finest + column)];
        block.moments.add(part);
        count_uniform(part, expected_.mean, expected_.deviation, block.counts);
        x += static_cast<int>(part.size());
        pixels = pixels.subspan(part.size());
    }
}

Moments Blocks::moments() const {
    Moments all;
    for (const Block& block : blocks_)
        all.merge(block.moments);
    return all;
}

std::optional<BlockEstimates> Blocks::estimate(double correlation) const {
    Grid grid{finest};
    std::vector<Block> blocks = blocks_;
    const int shortest = std::min(width_, height_);
    for (; grid.side > coarsest && shortest / grid.side < correlation; grid.side /= 2)
        blocks = coarsen(blocks, grid.side);
    if (!(correlation <= shortest / grid.side))
        return {};

    const Moments all = this->moments();
    if (!(all.variance() > 0))
        return {};
    const double pixels = static_cast<double>(all.count());
    const double sigma = std::sqrt(all.variance());

    std::vector<double> mean_excess;
    std::vector<double> variance_excess;
    std::vector<std::vector<double>> deviation;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Moments& moments = blocks[i].moments;
        const double n = static_cast<double>(moments.count());
        const double d = moments.mean() - all.mean();
        mean_excess.push_back(n * d);
        variance_excess.push_back(moments.squared_deviations() + n * d * d - n * all.variance());
        deviation.push_back(deviations(blocks[i].counts));
        if (!expected_.fitted)
            continue;
        // A normal distribution fitted to all blocks makes them dependent. To first order, this correction
        // compares block i with its own mean and variance, which do not depend on other blocks.
        for (std::size_t k = 0; k + 1 < bins_per_block; ++k) {
            const double z = normal_quantile(static_cast<double>(k + 1) / bins_per_block);
            deviation[i][k] +=
                normal_density(z) * (mean_excess[i] / sigma + z * variance_excess[i] / (2 * all.variance()));
        }
    }

    const PairIndex cvm = pair_index(deviation, blocks, grid);
    return BlockEstimates{grid.side, mean_interval(all.mean(), pixels, mean_excess, grid),
                          mean_interval(all.variance(), pixels, variance_excess, grid), cvm.index,
                          cvm.smallest};
}

} // namespace gabor::statistics
