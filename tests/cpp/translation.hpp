#pragma once

#include <array>
#include <cstdint>

// What a translation to C++ gives, compiled by itself with the options that are to be tested.

namespace gabor::test {

struct Values {
    std::array<float, 3> gradient;
    std::array<float, 3> stripes;
    float at;
    float tiled;
    float animated;
};

struct Arguments {
    float x = 0, y = 0;
    std::int32_t column = 0, row = 0;
    float local_x = 0.5f, local_y = 0.5f;
    float frequency = 4, orientation = 0.7854f;
    float wave_x = 1, wave_y = 2;
    float period_x = 4, period_y = 4;
    float time = 0;
    std::uint32_t seed = 7;
};

Values values(int taps, const Arguments& a);

struct Pixel {
    float dx[2];
    float dy[2];
};

struct Filtered {
    std::array<float, 2> deviations; ///< of gabor_footprint along x and y
    std::array<float, 4> noise;      ///< gabor_noise_filtered_gradient
};

Filtered filtered(const Arguments& a, const Pixel& pixel);

struct Eroded {
    std::array<float, 4> base; ///< height, slope and ridge
    std::array<float, 4> terrain;
};

/// At a cell and an offset within it: of gabor_terrain_at, or of a base with height x, slope wave and ridge
/// time.
Eroded eroded(int taps, const Arguments& a, const Pixel& pixel, bool hills);

} // namespace gabor::test
