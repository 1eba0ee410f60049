#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

namespace gabor::fit {

/// Returns a factor for each component, whose values have variance 1: its standard deviation to the power
/// 0.8. Weak components therefore count for a little more than their power, which preserves hues.
Eigen::VectorXd component_scales(const Exemplar& exemplar);

/// Changes the weights as little as possible so that the covariance of the components becomes the identity
/// matrix. This succeeds only partly with few waves: each has at most two independent components.
void normalize(std::vector<Wave>& waves);

/// Returns the colour of waves that are given in components. Since phases common to all components do not
/// matter, waves have no quadrature in the first component.
noise::Colour colour_of(const Exemplar& exemplar, const std::vector<Wave>& waves);

} // namespace gabor::fit
