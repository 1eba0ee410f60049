#pragma once

#include <numbers>

namespace gabor::study {

/// The wave of a kernel. The study looks at an oblique one, so that no axis of the grid is special.
struct Wave {
    double frequency = 4;                      ///< cycles per kernel radius
    double orientation = std::numbers::pi / 4; ///< radians
};

} // namespace gabor::study
