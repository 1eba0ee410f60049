#include "render/plan/plan_parts.hpp"

#include "passes/ocean_interface.h"

#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"

namespace gabor::render {

namespace {

// GaborOcean and its bands as passes/ocean.comp reads them (std430).
struct alignas(16) OceanBand {
    float amplitude;
    passes::vec2 slopes;
    int exponent;
    float low;
    alignas(16) float early[3];
    alignas(16) float late[3];
    alignas(16) float spread[3];
    passes::vec2 widen;
    passes::ivec2 drift;
};
struct Ocean {
    float wind, direction, fetch;
    alignas(16) float swell[3];
    int loop_seconds;
    passes::vec2 tail;
    OceanBand band[GABOR_OCEAN_BANDS + 1];
};
static_assert(sizeof(Ocean) == 48 + (GABOR_OCEAN_BANDS + 1) * 96);

} // namespace

std::vector<std::byte> ocean_table(const Sea& sea) {
    const auto single = [](double value) { return static_cast<float>(value); };
    const GaborOcean made = gabor_ocean_of(
        single(sea.wind), 0, single(sea.fetch),
        {single(sea.swell_height), single(sea.swell_period), single(noise::radians(sea.swell_direction))},
        sea.loop_seconds);
    Ocean table{made.wind,
                made.direction,
                made.fetch,
                {made.swell.x, made.swell.y, made.swell.z},
                made.loop_seconds,
                {made.tail.x, made.tail.y},
                {}};
    for (std::size_t i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        const GaborOceanBand& b = made.band[i];
        table.band[i] = {b.amplitude,
                         {b.slopes.x, b.slopes.y},
                         b.exponent,
                         b.low,
                         {b.early.x, b.early.y, b.early.z},
                         {b.late.x, b.late.y, b.late.z},
                         {b.spread.x, b.spread.y, b.spread.z},
                         {b.widen.x, b.widen.y},
                         {b.drift.x, b.drift.y}};
    }
    return bytes_of(table);
}

} // namespace gabor::render
