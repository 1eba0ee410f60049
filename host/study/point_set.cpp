#include "study/point_set.hpp"

#include "vulkan/pass.hpp"

#include "passes/points.h"
#include "passes/points_interface.h"

#include <cmath>
#include <stdexcept>

namespace gabor::study {

PointSet point_set(const vulkan::Device& device, const Ingredients& ingredients, int side,
                   std::uint32_t seed) {
    // Poisson counts stay within twelve standard deviations.
    const double capacity = ingredients.impulses + 12 * std::sqrt(ingredients.impulses) + 12;
    const passes::PointsPush push{static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(capacity),
                                  seed};
    const std::size_t cells = std::size_t{push.side} * push.side;
    const vulkan::Pass pass(device, points_spirv, {2, sizeof(push)}, constants(ingredients));
    const vulkan::Buffer counts(device, cells * sizeof(std::int32_t), vulkan::Memory::readback);
    const vulkan::Buffer places(device, cells * push.capacity * sizeof(Point), vulkan::Memory::readback);
    vulkan::Job job(device, pass, {counts, places});
    const std::uint32_t groups = (push.side + passes::points_group - 1) / passes::points_group;
    job.submit(push, {groups, groups});
    job.wait();

    PointSet set;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const auto count = static_cast<std::size_t>(counts.as<std::int32_t>()[cell]);
        if (count > push.capacity)
            throw std::runtime_error("a cell has more impulses than a Poisson count should have");
        const auto first = places.as<Point>().subspan(cell * push.capacity, count);
        set.emplace_back(first.begin(), first.end());
    }
    return set;
}

} // namespace gabor::study
