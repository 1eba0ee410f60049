#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

namespace gabor::fit {

/// The factors of components of variance 1: their deviations to the power 0.8. Weak ones count for a little
/// more than their power, to keep hues.
Eigen::VectorXd component_scales(const Exemplar& exemplar);

/// Makes the covariance of the components the unit matrix with the least change, as far as possible: a single
/// wave has at most two independent components.
void normalize(std::vector<Wave>& waves);

/// From waves in components to colours. In the first component waves have no quadrature: phases common to all
/// components do not matter.
noise::Colour colour_of(const Exemplar& exemplar, const std::vector<Wave>& waves);

} // namespace gabor::fit
