#pragma once

#include "fit/fit.hpp"

#include <string>
#include <vector>

namespace gabor::fit {

/// Returns one sentence for each thing that a user should know: pixels that were left out, and what the noise
/// lacks of the photograph.
std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
