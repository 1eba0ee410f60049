#include "render/erosion.hpp"

#include "error.hpp"
#include "render/material.hpp"
#include "render/plan_parts.hpp"

#include "passes/erode_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gabor::render {

namespace {

// The rows of a map. Reads each row once if rows are requested from top to bottom. Beyond the edges, a tile
// repeats and other maps keep the height of the edge.
class MapRows {
  public:
    explicit MapRows(const HeightMap& map) : map_(map), heights_(static_cast<std::size_t>(map.width)) {}

    const std::vector<float>& operator[](int y) {
        const int row =
            map_.tileable ? (y % map_.height + map_.height) % map_.height : std::clamp(y, 0, map_.height - 1);
        if (!reader_ || row < read_ - 1) {
            reader_ = map_.open();
            read_ = 0;
        }
        for (; read_ <= row; ++read_) {
            reader_->read_row(heights_);
            for (float& height : heights_) {
                height = static_cast<float>(map_.offset + map_.scale * height);
                if (!std::isfinite(height))
                    throw RequestError(
                        fmt::format("row {} of the map has a value that is not finite", read_));
            }
        }
        return heights_;
    }

  private:
    const HeightMap& map_;
    std::unique_ptr<image::PictureReader> reader_;
    int read_ = 0;
    std::vector<float> heights_; // heights of the last row read
};

} // namespace

Plan erosion_plan(const HeightMap& map, const Request& request, const image::Rect& region) {
    auto push = push_of<passes::ErodePush>(region);
    if (map.tileable)
        push.period = vec2_of(map.pixel * map.width, map.pixel * map.height);
    push.pixel = static_cast<float>(map.pixel);
    push.seed = request.seed;
    push.map_width = map.width;
    push.tileable = map.tileable;
    constexpr int group = passes::erode_group;
    return {{erosion_channels.begin(), erosion_channels.end()},
            region.width,
            region.height,
            {bytes_of(struct_values(request))},
            {{"erode", {}, bytes_of(push), region.width, {group, group}, {}}},
            {map.width, passes::erode_halo}};
}

void erode(const vulkan::Device& device, const HeightMap& map, const Request& request,
           const image::Rect& region, const Sink& write) {
    const Renderer renderer(device, erosion_plan(map, request, region));
    const auto width = static_cast<std::size_t>(map.width);
    MapRows rows(map);
    int next = region.y - passes::erode_halo;
    std::vector<float> shared; // rows shared by this band and the previous one
    render_plan(device, renderer, write, [&](std::span<float> band) {
        std::ranges::copy(shared, band.begin());
        for (std::size_t at = shared.size(); at < band.size(); at += width)
            std::ranges::copy(rows[next++], band.begin() + static_cast<std::ptrdiff_t>(at));
        const std::span<float> last = band.last(2 * passes::erode_halo * width);
        shared.assign(last.begin(), last.end());
    });
}

} // namespace gabor::render
