// Time of the recommended noise against the seminal one, of the same quality and of the same number of
// impulses.

#include "study/convergence.hpp"
#include "study/figures.hpp"
#include "study/measures.hpp"
#include "study/pictures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gabor::study {

namespace {

// N* by Gaussianity where that is measured well, and by the excess kurtosis, from which it follows, where the
// noise is too close to a normal law.
double seminal_equivalent(Noise& noise, const Ingredients& ingredients, const Effort& effort,
                          std::uint32_t seed) {
    const OneValue values = measure_values(std::span(&noise, 1), effort.samples, seed);
    const statistics::Estimate cvm = values.gaussianity.index();
    if (cvm.low > cvm.value / 2)
        return SeminalCurve().equivalent(cvm.value);
    return poisson_kurtosis({.impulses = 1}, {}) / std::abs(stratified_kurtosis(ingredients, {}));
}

} // namespace

Tables figure5(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure5",
                "N,samples,pixels,n_star,seconds,seconds_poisson,seconds_seminal,ratio_quality,ratio_count",
                {}};
    const int bits = effort.picture_bits - 1;
    for (const int n : effort.impulses) {
        Ingredients stratified = recommended;
        stratified.impulses = n;
        table.rows.push_back(
            {fmt::format("{},{},{}", n, effort.samples, 1 << 2 * bits),
             n * (static_cast<double>(effort.samples) + 25.0 * effort.timings * std::pow(4, bits)),
             [&device, stratified, effort, bits](std::uint32_t seed) -> Numbers {
                 Ingredients poisson = stratified;
                 poisson.points = Points::poisson;
                 std::vector<Noise> noises;
                 noises.emplace_back(device, stratified);
                 noises.emplace_back(device, poisson);
                 const double n_star = std::round(seminal_equivalent(noises[0], stratified, effort, seed));
                 noises.emplace_back(device, Ingredients{.impulses = static_cast<int>(n_star)});
                 const std::vector<double> s = picture_seconds(noises, bits, effort.timings);
                 return {n_star, s[0], s[1], s[2], s[2] / s[0], s[1] / s[0]};
             }});
    }
    return {table};
}

} // namespace gabor::study
