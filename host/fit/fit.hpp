#pragma once

#include "fit/exemplar.hpp"
#include "fit/fit_error.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"
#include "render/request.hpp"

#include <string>
#include <vector>

namespace gabor::fit {

/// The largest number of lobes in a preset.
constexpr int most_lobes = 16;

/// A texture of Gabor noise.
struct FittedNoise {
    std::vector<Wave> waves; ///< the most powerful first, with weights in components of variance 1
    noise::Colour colour;
    FitError error; ///< before correction to the exemplar's exact covariance
};

/// Fits at most `lobes` lobes: fewer if more would overfit an exemplar of that size.
///
/// Adds one lobe at a time, the one that reduces the residual of the spectra most, then refines all of them
/// by least squares. Based on [GLLD12] Galerne, Lagae, Lefebvre, Drettakis, "Gabor noise by example", 2012.
FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance);

/// The request for a picture of the texture, with the exemplar's size and scale.
render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted);

/// Returns one sentence for each warning: pixels that were left out, and features of the photograph that the
/// noise lacks.
std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
