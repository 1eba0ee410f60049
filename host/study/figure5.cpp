// Time of the recommended noise against the seminal one, of the same quality and of the same number of
// impulses.

#include "study/figures.hpp"
#include "study/pictures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gabor::study {

Tables figure5(const vulkan::Device& device, const Effort& effort) {
    const Ingredients one_each{.points = Points::stratified, .weights = Weights::bernoulli, .impulses = 1};
    // Both kurtoses fall as 1 / N: the same quality is the same kurtosis.
    const double equivalent =
        poisson_kurtosis({.impulses = 1}, {}) / std::abs(stratified_kurtosis(one_each, {}));
    Table table{
        "figure5", "N,n_star,pixels,seconds,seconds_poisson,seconds_seminal,ratio_quality,ratio_count", {}};
    for (const int n : effort.impulses) {
        const int n_star = static_cast<int>(std::round(equivalent * n));
        const int bits = effort.picture_bits - 1;
        const int timings = effort.timings;
        table.rows.push_back({fmt::format("{},{},{}", n, n_star, 1 << 2 * bits),
                              static_cast<double>(n_star) * timings * std::pow(4, bits),
                              [&device, n, n_star, bits, timings](std::uint32_t) -> Numbers {
                                  Ingredients noise = recommended;
                                  noise.impulses = n;
                                  Ingredients poisson = noise;
                                  poisson.points = Points::poisson;
                                  Noise noises[]{Noise(device, noise), Noise(device, poisson),
                                                 Noise(device, Ingredients{.impulses = n_star})};
                                  const std::vector<double> s = picture_seconds(noises, bits, timings);
                                  return {s[0], s[1], s[2], s[2] / s[0], s[1] / s[0]};
                              }});
    }
    return {table};
}

} // namespace gabor::study
