// A sea of five bands for test_ocean.cpp, in a namespace because its structs differ from those of nine
// bands.

#include <cmath>
#include <cstdint>
#include <cstring>

#define GABOR_OCEAN_BANDS 5

namespace {
#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"
} // namespace

double coarse_height(const float* p, float pixel, float seconds);

double coarse_height(const float* p, float pixel, float seconds) {
    static const GaborOcean sea = [] {
        GaborSea made = gabor_sea();
        made.wind = 12;
        made.direction = 0.5f;
        made.swell_height = 3;
        made.swell_direction = 1;
        return gabor_ocean_of(made);
    }();
    return gabor_water_filtered({p[0], p[1]}, {pixel, 0}, {0, pixel}, seconds, sea, 7u).height;
}
