#pragma once

#include <array>
#include <cstdint>

// The results of a C++ translation, compiled separately with the options under test.

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

using Vector = std::array<float, 3>;

/// gabor_noise_3d, gabor_noise_3d_isotropic and gabor_noise_surface_isotropic. The direction is the normal
/// too.
std::array<float, 3> solid(const Vector& p, float frequency, const Vector& direction, std::uint32_t seed);

struct Eroded {
    std::array<float, 4> base; ///< height, slope and ridge
    std::array<float, 4> terrain;
};

/// At a cell and an offset within it: of gabor_terrain_at, or of a base with height x, slope wave and ridge
/// time.
Eroded eroded(int taps, const Arguments& a, const Pixel& pixel, bool hills);

struct Waves {
    float wave[9][2];
};

/// gabor_field_waves: value, slope_x, slope_y.
std::array<float, 6> directed(const Arguments& a, const Waves& waves);

/// gabor_profile_sine, _triangle, _sawtooth, _pulse, _ridges.
std::array<float, 5> profiles(float phase, float duty, float width);

/// gabor_stripes_sine, _triangle, _sawtooth, _pulse, _ridges.
std::array<float, 5> stripe_profiles(float cosine, float sine, float duty);

/// gabor_stripes_filtered.
std::array<float, 4> filtered_stripes(const Arguments& a, const Pixel& pixel, float sharpness);

/// gabor_stripes_filtered_at of a point, in any cell at any time, with a period of 7 by 5 nodes.
std::array<float, 4> filtered_stripes_at(const Arguments& a, float sharpness);

} // namespace gabor::test
