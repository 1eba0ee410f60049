#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

namespace gabor::fit {

/// What weighs components against one another: each one's spectrum is divided by the root of its variance, so
/// that weak ones count, and not as much as strong ones. A factor for each component of variance 1.
Eigen::VectorXd component_scales(const Exemplar& exemplar);

/// Makes the covariance of the components the unit matrix, by the least change, as far as waves can have it:
/// a single one has two independent components at most.
void normalize(std::vector<Wave>& waves);

/// From waves in components to colours. In the first component waves have no quadrature: phases common to all
/// components do not matter.
noise::Colour colour_of(const Exemplar& exemplar, const std::vector<Wave>& waves);

} // namespace gabor::fit
