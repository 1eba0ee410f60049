#include "render/plan/plan_parts.hpp"
#include "render/request/material.hpp"

#include "passes/ocean_interface.h"

#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"

#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace gabor::render {

// The drop-in orders members so that C++ and std430 lay them out alike.
static_assert(offsetof(GaborOcean, band) % 16 == 0 && sizeof(GaborOceanBand) % 16 == 0);

std::vector<std::byte> ocean_table(const Request& request) {
    GaborSea sea = gabor_sea();
    const std::vector<float> values = struct_values(request);
    if (values.size() * sizeof(float) != offsetof(GaborSea, direction))
        throw std::logic_error("the parameters of the sea are not those of GaborSea");
    std::memcpy(&sea, values.data(), offsetof(GaborSea, direction));
    sea.loop_seconds = request.sea.loop_seconds;
    return bytes_of(gabor_ocean_of(sea));
}

} // namespace gabor::render
