#include "study/convergence.hpp"

#include "study/measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gabor::study {

Row convergence_row(const vulkan::Device& device, const Ingredients& ingredients, const Effort& effort) {
    const std::uint64_t samples = effort.samples;
    return {fmt::format("{},{}", key(ingredients), samples),
            static_cast<double>(ingredients.impulses) * static_cast<double>(samples),
            [&device, ingredients, samples](std::uint32_t seed) -> Numbers {
                Noise noise(device, ingredients);
                const OneValue law = measure_values(std::span(&noise, 1), samples, seed);
                const statistics::Estimate cvm = law.gaussianity.index();
                return {cvm.value, cvm.low, cvm.high, law.moments.variance()};
            }};
}

void SeminalCurve::add(int n, double cvm) {
    // Chance can make the low end of the curve rise; what does not fall adds nothing.
    if (cvm > 0 && (points_.empty() || std::log(cvm) < points_.back().first))
        points_.emplace_back(std::log(cvm), std::log(n));
}

double SeminalCurve::equivalent(double cvm) const {
    if (!(cvm > 0))
        return std::numeric_limits<double>::infinity();
    const double wanted = std::log(cvm);
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const auto [upper, n_upper] = points_[i - 1];
        const auto [lower, n_lower] = points_[i];
        if (wanted <= upper && wanted >= lower)
            return std::exp(std::lerp(n_upper, n_lower, (upper - wanted) / (upper - lower)));
    }
    const Ingredients seminal{.impulses = 1};
    constexpr double squares = 7 / (9 * std::numbers::sqrt3 * std::numbers::pi);
    return poisson_kurtosis(seminal, {}) / 24 * std::sqrt(statistics::cvm_scale * squares / cvm);
}

} // namespace gabor::study
