#pragma once

// Compares a noise's distribution over independent instances with the normal law.

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace gabor::test {

/// Number of samples per statistic: GABOR_LAW_SAMPLES, or 2^21 if it is not set.
inline double law_samples() {
    const char* text = std::getenv("GABOR_LAW_SAMPLES");
    return text ? std::strtod(text, nullptr) : 1 << 21;
}

/// Checks random numbers against the normal law with mean 0 and the predicted deviation.
class Figure {
  public:
    explicit Figure(double deviation = 1) : deviation_(deviation), gaussianity_(deviation) {}

    void add(double value) {
        moments_.add(value);
        gaussianity_.add(value);
    }

    void check(const std::string& name) const {
        const statistics::Estimate cvm = gaussianity_.index();
        const double n = static_cast<double>(gaussianity_.count());
        const double variance = moments_.variance() / (deviation_ * deviation_);
        fmt::print(
            "  {:<34} mean {:8.5f}, variance {:.5f}, excess kurtosis {:7.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
            name, moments_.mean(), variance, moments_.excess_kurtosis(), cvm.value, cvm.low, cvm.high);
        INFO(name);
        CHECK(std::abs(moments_.mean()) < 5 * deviation_ / std::sqrt(n));
        CHECK(std::abs(variance - 1) < 5 * std::sqrt(2 / n));
        CHECK(cvm.low < 0.05);
    }

  private:
    double deviation_;
    statistics::Moments moments_;
    statistics::Gaussianity gaussianity_;
};

/// Offsets of side^axes places in a cell from its corner; the first is the corner.
inline std::vector<std::vector<float>> places_of_cell(std::size_t side, std::size_t axes) {
    std::vector<std::vector<float>> places{{}};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        std::vector<std::vector<float>> longer;
        for (const std::vector<float>& place : places) {
            for (std::size_t step = 0; step < side; ++step) {
                longer.push_back(place);
                longer.back().push_back(static_cast<float>(step) / static_cast<float>(side));
            }
        }
        places = longer;
    }
    return places;
}

/// Equally many values for each place of a cell or each normal of a surface, all predicted to be standard
/// normal.
class Laws {
  public:
    /// `each` is described by fmt::format.
    template <typename Each>
    explicit Laws(const std::vector<Each>& each) : moments_(each.size()), laws_(each.size()) {
        for (const Each& one : each)
            names_.push_back(fmt::format("{}", one));
    }

    void add(std::size_t index, double value) {
        moments_[index].add(value);
        laws_[index].add(value);
    }

    void merge(const Laws& other) {
        for (std::size_t i = 0; i < laws_.size(); ++i) {
            moments_[i].merge(other.moments_[i]);
            laws_[i].merge(other.laws_[i]);
        }
    }

    void check(const std::string& title) const {
        const double n = static_cast<double>(moments_.front().count());
        const double count = static_cast<double>(laws_.size());
        // Means and variances differ only by chance: chi-square per degree of freedom.
        double means = 0, variances = 0, furthest = 0;
        statistics::Moments together, cvms;
        std::string worst;
        for (std::size_t i = 0; i < laws_.size(); ++i) {
            const double excess = moments_[i].variance() - 1;
            together.merge(moments_[i]);
            means += std::pow(moments_[i].mean(), 2) * n / count;
            variances += std::pow(excess, 2) * n / 2 / count;
            if (std::abs(excess) > std::abs(furthest))
                furthest = excess;
            const double cvm = laws_[i].index().value;
            if (!(cvm < cvms.maximum()))
                worst = names_[i];
            cvms.add(cvm);
        }
        const double error = std::sqrt(cvms.variance() / count);
        fmt::print(
            "  {}, {:.3g} values: mean {:.5f}, variance {:.5f}\n"
            "    {} of each: chi-square of means {:.2f}, of variances {:.2f}, the furthest {:+.5f}; cvm "
            "{:.4f} +- {:.4f} on average, {:.3f} at the worst, {}\n",
            title, n * count, together.mean(), together.variance(), n, means, variances, furthest,
            cvms.mean(), error, cvms.maximum(), worst);
        INFO(title);
        CHECK(std::abs(together.mean()) < 5 / std::sqrt(n * count));
        CHECK(std::abs(together.variance() - 1) < 5 * std::sqrt(2 / (n * count)));
        CHECK(std::abs(means - 1) < 5 * std::sqrt(2 / count));
        CHECK(std::abs(variances - 1) < 5 * std::sqrt(2 / count));
        CHECK(cvms.mean() - 4 * error < 0.05);
        // Of 2304 normal laws the largest T - 1/6 is about 1.2, and in one case of 75 more than 2.
        CHECK(cvms.maximum() < 0.5 + 2 * statistics::cvm_scale / n);
    }

  private:
    std::vector<std::string> names_;
    std::vector<statistics::Moments> moments_;
    std::vector<statistics::Gaussianity> laws_;
};

} // namespace gabor::test
