#include "render/plan_parts.hpp"

#include "passes/ocean_interface.h"

#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"

namespace gabor::render {

namespace {

// GaborOcean and its bands as passes/ocean.comp reads them (std430).
struct alignas(16) Band {
    float amplitude;
    passes::vec2 slopes;
    int exponent, low, quarter;
    alignas(16) int share[3];
    alignas(16) int lean[4];
    passes::ivec2 spread, drift;
};
struct Ocean {
    float wind, direction, fetch;
    passes::vec2 tail;
    Band band[GABOR_OCEAN_BANDS];
};
static_assert(sizeof(Ocean) == 32 + GABOR_OCEAN_BANDS * 80);

} // namespace

std::vector<std::byte> ocean_table(const Sea& sea) {
    const GaborOcean made =
        gabor_ocean_of(static_cast<float>(sea.wind), 0, static_cast<float>(1000 * sea.fetch));
    Ocean table{made.wind, made.direction, made.fetch, {made.tail.x, made.tail.y}, {}};
    for (std::size_t i = 0; i < GABOR_OCEAN_BANDS; ++i) {
        const GaborOceanBand& b = made.band[i];
        table.band[i] = {b.amplitude,
                         {b.slopes.x, b.slopes.y},
                         b.exponent,
                         b.low,
                         b.quarter,
                         {b.share.x, b.share.y, b.share.z},
                         {b.lean.x, b.lean.y, b.lean.z, b.lean.w},
                         {b.spread.x, b.spread.y},
                         {b.drift.x, b.drift.y}};
    }
    return bytes_of(table);
}

} // namespace gabor::render
