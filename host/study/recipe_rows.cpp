#include "study/recipe_rows.hpp"

#include "study/measures.hpp"
#include "study/purity.hpp"

#include <fmt/format.h>

namespace gabor::study {

namespace {

constexpr Window gaussian{"gaussian", Shape::gaussian};

Numbers criteria(Noise noise, const Window& window, double visits, double cell, const Effort& effort,
                 std::uint32_t seed) {
    const std::span<Noise> sum(&noise, 1);
    const OneValue values = measure_values(sum, effort.samples, seed);
    const statistics::Estimate cvm = values.gaussianity.index();
    const statistics::ProcessStationarity places = measure_places(sum, cell, effort.places, seed);
    const statistics::InstanceStationarity windows = measure_windows(sum, effort.windows, seed);
    const Purity pure = purity(window);
    return {visits,
            cvm.value,
            cvm.low,
            cvm.high,
            values.moments.variance(),
            places.variance().interdecile,
            places.chance_interdecile(),
            windows.contrast().interdecile,
            pure.sidelobe,
            pure.outside};
}

double cost(double visits, const Effort& effort) {
    return visits * (static_cast<double>(effort.samples) + 64 * static_cast<double>(effort.places) +
                     256 * static_cast<double>(effort.windows));
}

} // namespace

Row recipe_row(const vulkan::Device& device, const Variant& variant, const Effort& effort) {
    const double visits = visited(variant);
    return {fmt::format("{},{},{},{:.3f},{:g},{},{:g},{}", variant.window.name, name(variant.lattice),
                        name(variant.law), variant.floor, variant.jitter, variant.impulses, variant.radius,
                        effort.samples),
            cost(visits, effort), [&device, variant, visits, effort](std::uint32_t seed) {
                return criteria(Noise(device, variant), variant.window, visits, 1 / variant.radius, effort,
                                seed);
            }};
}

Row seminal_row(const vulkan::Device& device, const Effort& effort) {
    const Ingredients seminal;
    const double visits = 9 * seminal.impulses;
    return {fmt::format("gaussian,poisson,uniform_signed,0.000,1,{},1,{}", seminal.impulses, effort.samples),
            cost(visits, effort), [&device, seminal, visits, effort](std::uint32_t seed) {
                return criteria(Noise(device, seminal), gaussian, visits, 1, effort, seed);
            }};
}

} // namespace gabor::study
