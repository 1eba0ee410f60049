#pragma once

namespace gabor::noise {

/// Waves around one frequency and orientation, as GaborLobe in shaders/gabor_noise.glsl.
struct Lobe {
    double frequency = 4;          ///< cycles per kernel radius
    double orientation = 0;        ///< radians, of the wave vector
    double frequency_spread = 0;   ///< waves are evenly spread within frequency (1 +- this), in [0, 1]
    double orientation_spread = 0; ///< and within orientation +- this, radians; pi/2 is every direction
    double power = 1;              ///< in proportion to other lobes'
};

} // namespace gabor::noise
