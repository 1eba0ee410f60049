#pragma once

#include "fit/fit.hpp"

#include <string>
#include <vector>

namespace gabor::fit {

/// Returns one sentence for each warning: pixels that were left out, and features of the photograph that the
/// noise lacks.
std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
