// A sea of three bands for test_ocean.cpp, in a namespace because its structs differ from those of nine
// bands.

#include <cmath>
#include <cstdint>
#include <cstring>

#define GABOR_OCEAN_BANDS 3

namespace {
#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"
} // namespace

double coarse_height(const float* p, float pixel, float seconds);

double coarse_height(const float* p, float pixel, float seconds) {
    static const GaborOcean sea = gabor_ocean_of(12, 0.5f, 2e5f, {3, 12, 1}, 0);
    return gabor_water_filtered({p[0], p[1]}, {pixel, 0}, {0, pixel}, seconds, sea, 7u).height;
}
