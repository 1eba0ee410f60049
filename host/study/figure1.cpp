// The point sets, for 16 impulses per cell.

#include "study/figures.hpp"
#include "study/point_set.hpp"

#include <fmt/format.h>

namespace gabor::study {

Tables figure1(const vulkan::Device& device, const Effort&) {
    constexpr int side = 3; // cells
    Table table{"figure1", "points,N,point,x,y", {}};
    for (const Points points : all_points) {
        const PointSet set = point_set(device, {.points = points, .impulses = 16}, side, 1);
        int index = 0;
        for (const std::vector<Point>& cell : set)
            for (const Point& point : cell)
                table.rows.push_back(
                    {fmt::format("{},16,{}", name(points), index++), 0, [point](std::uint32_t) -> Numbers {
                         return {point.x, point.y};
                     }});
    }
    return {table};
}

} // namespace gabor::study
