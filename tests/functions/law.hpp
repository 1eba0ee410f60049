#pragma once

// Compares a noise's distribution over independent instances with the normal distribution.

#include "largest.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gabor::test {

/// The number of samples per statistic: GABOR_LAW_SAMPLES, or 2^21 if it is not set. With half of these, an
/// error of 1 % in the variance is still 7 standard errors.
inline double law_samples() {
    const char* text = std::getenv("GABOR_LAW_SAMPLES");
    return text ? std::strtod(text, nullptr) : 1 << 21;
}

/// A value computed from one instance's numbers. In theory, it is normal with mean 0.
struct Statistic {
    std::string name;
    double deviation;
    std::function<double(std::span<const float>)> of;
};

/// A term in a weighted sum of an instance's numbers.
struct Term {
    std::size_t number;
    double factor = 1;
};
inline Statistic sum_of(std::string name, double deviation, std::vector<Term> terms) {
    return {std::move(name), deviation, [terms = std::move(terms)](std::span<const float> numbers) {
                double sum = 0;
                for (const auto& [number, factor] : terms)
                    sum += factor * numbers[number];
                return sum;
            }};
}

/// Compares statistics with the normal distribution over `share` times law_samples() samples. Each call of
/// `instance()` returns the numbers of another instance as an array.
template <typename Instance>
void check_laws(double share, const Instance& instance, const std::vector<Statistic>& statistics) {
    std::vector<statistics::Moments> moments(statistics.size());
    std::vector<statistics::Gaussianity> laws;
    for (const Statistic& statistic : statistics)
        laws.emplace_back(statistic.deviation);
    for (double i = 0; i < share * law_samples(); ++i) {
        const auto numbers = instance();
        for (std::size_t k = 0; k < statistics.size(); ++k) {
            const double value = statistics[k].of(numbers);
            moments[k].add(value);
            laws[k].add(value);
        }
    }
    for (std::size_t k = 0; k < statistics.size(); ++k) {
        const statistics::Estimate cvm = laws[k].index();
        const double n = static_cast<double>(laws[k].count());
        const double mean = moments[k].mean() / statistics[k].deviation;
        const double variance = moments[k].variance() / std::pow(statistics[k].deviation, 2);
        fmt::print(
            "  {:<34} mean {:8.5f}, variance {:.5f}, excess kurtosis {:7.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
            statistics[k].name, mean, variance, moments[k].excess_kurtosis(), cvm.value, cvm.low, cvm.high);
        INFO(statistics[k].name);
        CHECK(std::abs(mean) < 5 / std::sqrt(n));
        CHECK(std::abs(variance - 1) < 5 * std::sqrt(2 / n));
        CHECK(cvm.low < 0.05);
    }
}

/// Compares the covariance of complex noise at two points with theory. An instance's numbers 0 and 1 are the
/// parts at one point, and 2 and 3 those at the other.
template <typename Instance>
void check_covariance(Largest& largest, const Instance& instance, double expected, const std::string& name) {
    statistics::Moments products;
    for (double i = 0; i < law_samples() / 32; ++i) {
        const std::array<float, 4> numbers = instance();
        products.add(double{numbers[0]} * numbers[2]);
        products.add(double{numbers[1]} * numbers[3]);
    }
    const double error = std::sqrt(products.variance() / static_cast<double>(products.count()));
    largest.see(products.mean(), expected, 4.5 * error, name);
    CHECK(error < 0.01);
}

/// Offsets from a cell's corner to side^N evenly spaced points; the first point is the corner.
template <std::size_t N>
std::vector<std::array<double, N>> places_of_cell(std::size_t side) {
    std::vector<std::array<double, N>> places(static_cast<std::size_t>(std::pow(side, N)));
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::size_t rest = k;
        for (double& coordinate : places[k]) {
            coordinate = static_cast<double>(rest % side) / static_cast<double>(side);
            rest /= side;
        }
    }
    return places;
}

/// Collects the same number of values for each point of a cell or each normal of a surface. In theory, all
/// values are standard normal.
class Laws {
  public:
    /// `each` has the points or normals, which fmt::format turns into names.
    template <typename Each>
    explicit Laws(const std::vector<Each>& each) : moments_(each.size()), laws_(each.size()) {
        for (const Each& one : each)
            names_.push_back(fmt::format("{}", one));
    }

    /// Adds values. `instance(k)` returns an array of an instance's numbers at the k-th point or normal.
    template <typename Instance>
    void add(double count, const Instance& instance) {
        for (std::size_t i = 0; static_cast<double>(i) < count; ++i) {
            const std::size_t k = i % laws_.size();
            for (const float number : instance(k)) {
                moments_[k].add(number);
                laws_[k].add(number);
            }
        }
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
        // Chi-square per degree of freedom shows whether means and variances differ only by chance.
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
            "    {} each: chi-square of means {:.2f}, of variances {:.2f}, the largest excess {:+.5f}; cvm "
            "{:.4f} +- {:.4f} on average, {:.3f} at worst, {}\n",
            title, n * count, together.mean(), together.variance(), n, means, variances, furthest,
            cvms.mean(), error, cvms.maximum(), worst);
        INFO(title);
        CHECK(std::abs(together.mean()) < 5 / std::sqrt(n * count));
        CHECK(std::abs(together.variance() - 1) < 5 * std::sqrt(2 / (n * count)));
        CHECK(std::abs(means - 1) < 5 * std::sqrt(2 / count));
        CHECK(std::abs(variances - 1) < 5 * std::sqrt(2 / count));
        CHECK(cvms.mean() - 4 * error < 0.05);
        // The largest of 2304 Cramér-von Mises statistics T of normal samples exceeds their mean of 1/6 by
        // about 1.2, and in one case of 75 by more than 2.
        CHECK(cvms.maximum() < 0.5 + 2 * statistics::cvm_scale / n);
    }

  private:
    std::vector<std::string> names_;
    std::vector<statistics::Moments> moments_;
    std::vector<statistics::Gaussianity> laws_;
};

} // namespace gabor::test
