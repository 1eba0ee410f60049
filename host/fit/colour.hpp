#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

namespace gabor::fit {

/// Returns a factor for the values of each component, which have variance 1: the component's standard
/// deviation in the photograph to the power 0.8. Weak components therefore count for a little more than their
/// power, which preserves hues.
Eigen::VectorXd component_scales(const Exemplar& exemplar);

/// Changes the weights as little as possible so that the covariance of the components becomes the identity
/// matrix. This succeeds only partly with few waves: each has at most two independent components.
void normalize(std::vector<Wave>& waves);

/// Returns the noise's colours: the weights of the waves in each component, and the photograph's mean and
/// histograms. A phase that all components share has no effect, so it is chosen to leave no quadrature in the
/// first component.
noise::Colour colour_of(const Exemplar& exemplar, const std::vector<Wave>& waves);

} // namespace gabor::fit
