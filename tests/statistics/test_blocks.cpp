#include "statistics/blocks.hpp"

#include "samples.hpp"
#include "statistics/estimate.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace gabor::statistics;

namespace {

constexpr int block_side = 256;
constexpr int repetitions = 120;
const samples::Lobe lobe{2.0}; // the correlation is exp(-|d|^2 / 16): 1e-7 at 16 pixels, the side of a block
constexpr double correlation = 16;

void add_picture(Blocks& blocks, const std::vector<float>& picture, int width) {
    const std::span<const float> pixels = picture;
    const auto columns = static_cast<std::size_t>(width);
    for (std::size_t y = 0; y * columns < pixels.size(); ++y)
        blocks.add(0, static_cast<int>(y), pixels.subspan(y * columns, columns));
}

/// The estimates from many pictures, and how many of their intervals contain `truth`.
struct Trial {
    double truth;
    Moments estimates;
    double covered = 0;

    void add(const Estimate& estimate) {
        estimates.add(estimate.value);
        covered += estimate.low <= truth && truth <= estimate.high;
    }
};

void check(const char* name, const Trial& trial) {
    const double mean = trial.estimates.mean(), error = std::sqrt(trial.estimates.variance() / repetitions);
    INFO(name << ": truth " << trial.truth << ", mean " << mean << " +- " << error << ", covered "
              << trial.covered << " of " << repetitions);
    CHECK(std::abs(mean - trial.truth) < 3 * error);
    CHECK(trial.covered > 0.9 * repetitions);
}

} // namespace

TEST_CASE("estimates from blocks are unbiased, and their intervals cover the truth") {
    const double c = GENERATE(0.0, 0.1);
    const samples::Bent bent{c};
    Trial mean{5, {}};
    Trial variance{4, {}};
    Trial analytic{bent.index(), {}};
    Trial measured{bent.index(), {}};
    for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
        std::vector<float> picture = samples::picture(block_side, block_side, lobe, seed);
        bent.apply(picture);
        Moments moments;
        for (float& value : picture)
            value = 5 + 2 * value;
        moments.add(picture);

        Blocks against_theory(block_side, block_side, {5, 2, false});
        add_picture(against_theory, picture, block_side);
        const auto known = against_theory.estimate(correlation);
        REQUIRE(known);
        CHECK(known->blocks_per_side == 16);
        mean.add(known->mean);
        variance.add(known->variance);
        analytic.add(known->cvm);

        Blocks against_itself(block_side, block_side, fitted_normal(moments));
        add_picture(against_itself, picture, block_side);
        measured.add(against_itself.estimate(correlation)->cvm);
    }
    check("mean", mean);
    check("variance", variance);
    check("cvm against theory", analytic);
    check("cvm against the picture itself", measured);
}

TEST_CASE("the index is the mean over all pairs of pixels in blocks that do not touch") {
    // The integral over u of ([a <= u] - u) ([b <= u] - u) is 1/3 + (a^2 + b^2) / 2 - max(a, b).
    constexpr int small = 32; // blocks of 2 x 2
    const std::vector<float> picture = samples::picture(small, small, {2}, 7);
    double sum = 0;
    double pairs = 0;
    for (int i = 0; i < small * small; ++i)
        for (int j = 0; j < small * small; ++j) {
            if (std::abs(i / small / 2 - j / small / 2) <= 1 && std::abs(i % small / 2 - j % small / 2) <= 1)
                continue;
            const double a = normal_cdf(picture[static_cast<std::size_t>(i)]);
            const double b = normal_cdf(picture[static_cast<std::size_t>(j)]);
            sum += 1.0 / 3 + (a * a + b * b) / 2 - std::max(a, b);
            ++pairs;
        }
    Blocks blocks(small, small, {});
    add_picture(blocks, picture, small);
    CHECK(blocks.estimate(2)->cvm.value == Approx(262144 * sum / pairs).epsilon(0.002));
}

TEST_CASE("the index of a large picture of independent pixels is right") {
    const samples::Bent bent{0.2};
    std::vector<float> picture = samples::normal(2000 * 1000, 3);
    bent.apply(picture);
    Blocks blocks(2000, 1000, {});
    add_picture(blocks, picture, 2000);
    const auto estimates = blocks.estimate(1);
    REQUIRE(estimates);
    CHECK(estimates->cvm.value == Approx(bent.index()).epsilon(0.012));
    CHECK(estimates->cvm.high - estimates->cvm.low < 0.03 * bent.index());
    CHECK(estimates->variance.value == Approx(1).epsilon(0.01));
    CHECK(estimates->mean.value == Approx(0).margin(0.003));
}

TEST_CASE("blocks are merged until they exceed the correlation length, or there is no estimate") {
    Blocks blocks(256, 160, {});
    add_picture(blocks, samples::normal(256 * 160, 4), 256);
    CHECK(blocks.estimate(10)->blocks_per_side == 16);
    CHECK(blocks.estimate(11)->blocks_per_side == 8);
    CHECK(blocks.estimate(20)->blocks_per_side == 8);
    CHECK_FALSE(blocks.estimate(21));
    CHECK_FALSE(blocks.estimate(std::numeric_limits<double>::quiet_NaN()));
    CHECK(blocks.estimate(20)->mean.value == Approx(blocks.moments().mean()));
    CHECK(blocks.estimate(20)->variance.value == Approx(blocks.moments().variance()));
}

TEST_CASE("a constant picture has no estimates") {
    const std::vector<float> flat(64 * 64, 0.5f);
    Moments moments;
    moments.add(flat);
    const NormalDistribution reference = fitted_normal(moments);
    CHECK(reference.mean == 0.5);
    CHECK(reference.deviation == 1);
    Blocks blocks(64, 64, reference);
    add_picture(blocks, flat, 64);
    CHECK_FALSE(blocks.estimate(1));
    CHECK(fitted_normal(Moments()).deviation == 1);
    Moments one;
    one.add(std::vector{0.5f});
    CHECK(fitted_normal(one).mean == 0.5);
}
