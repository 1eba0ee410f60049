#include "fit/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gabor::fit {

namespace {

// Larger differences are visible in most textures.
constexpr double l1_limit = 0.2;
constexpr double low_limit = 0.4;
constexpr double autocorrelation_limit = 0.2;

} // namespace

std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted) {
    std::vector<std::string> lines;
    const FitError& error = fitted.error;
    if (exemplar.transparent > 0)
        lines.push_back(fmt::format("Left out {:.3g} % of the pixels: they are transparent.",
                                    100 * exemplar.transparent));
    if (exemplar.fireflies > 0)
        lines.push_back(fmt::format("Left out {:.3g} % of the pixels: they are far brighter than all others.",
                                    100 * exemplar.fireflies));
    if (exemplar.structure > Structure::limit)
        lines.push_back(fmt::format(
            "The photograph has edges or objects, which no sum of waves can reproduce: the noise keeps the "
            "colours and scales but loses the objects (the photograph's distance from normal is {:.1f}). To "
            "keep them, blend pieces of the photograph and preserve its histogram: Heitz and Neyret 2018, "
            "Deliot and Heitz 2019.",
            exemplar.structure));
    if (error.l1 > l1_limit)
        lines.push_back(fmt::format(
            "The noise differs visibly from the photograph: {} lobes cannot follow its spectrum (L1 {:.2f}).",
            fitted.waves.size(), error.l1));
    if (error.low > low_limit)
        lines.push_back(
            fmt::format("Large features may be too weak or too strong: the spectrum of waves longer "
                        "than {} pixels is off by {:.2f} (L1).",
                        window_side, error.low));
    if (error.autocorrelation > std::max(autocorrelation_limit, 4 * error.chance))
        lines.push_back(
            fmt::format("Something in the photograph repeats or continues further than the noise can "
                        "(autocorrelations differ by {:.2f}).",
                        error.autocorrelation));
    return lines;
}

} // namespace gabor::fit
