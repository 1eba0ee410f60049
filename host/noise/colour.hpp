#pragma once

#include <array>
#include <vector>

namespace gabor::noise {

/// How to turn the complex noises of lobes into colours. Three components are normal noises of variance 1,
/// independent at each point: component c is the sum over lobes of weights[lobe][c] . (quadrature, noise). An
/// increasing polynomial gives each component its own distribution with mean 0 and variance 1, and
///     colour = mean + mixing * (histogram_0(component_0), histogram_1(component_1),
///     histogram_2(component_2)).
struct Colour {
    struct Weight {
        double quadrature = 0;
        double noise = 0;
        bool operator==(const Weight&) const = default;
    };
    std::vector<std::array<Weight, 3>> weights; ///< weights of each lobe
    std::array<std::array<double, 6>, 3> histogram =
        {};                                           ///< coefficients of 1, z, ... z^5; z is clamped to +-4
    std::array<double, 3> mean = {};                  ///< red, green, blue
    std::array<std::array<double, 3>, 3> mixing = {}; ///< one row each for red, green, blue

    bool linear = false; ///< whether the photograph's values are linear light, as in OpenEXR, instead of sRGB

    bool operator==(const Colour&) const = default;
};

} // namespace gabor::noise
