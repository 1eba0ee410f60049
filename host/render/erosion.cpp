#include "render/erosion.hpp"

#include "error.hpp"
#include "render/renderer.hpp"
#include "vulkan/pass.hpp"

#include "passes/erode.h"
#include "passes/erode_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace gabor::render {

namespace {

constexpr int map_halo = passes::erode_halo;
constexpr std::size_t most_band_pixels = std::size_t{1} << 20;

// Rows of a map from two above the first that is wanted on, in order. Beyond its edges a tile repeats, and
// others keep the height of the edge.
class MapRows {
  public:
    MapRows(const HeightMap& map, int first) : map_(map), reader_(map.open()), next_(first - map_halo) {
        if (map.tileable && first < map_halo)
            read_last_rows();
    }

    void next(std::span<float> row) {
        const int y = next_++;
        if (y < 0) {
            if (!map_.tileable)
                peek_first();
            std::ranges::copy(map_.tileable ? last_[static_cast<std::size_t>(y + map_halo)] : first_.front(),
                              row.begin());
        } else if (y < map_.height) {
            while (read_ <= y)
                read();
            std::ranges::copy(current_, row.begin());
        } else {
            while (read_ < map_.height)
                read();
            std::ranges::copy(
                map_.tileable ? first_[static_cast<std::size_t>((y - map_.height) % map_.height)] : current_,
                row.begin());
        }
    }

  private:
    void peek_first() {
        if (read_ == 0)
            read();
    }

    void read() {
        current_.resize(static_cast<std::size_t>(map_.width));
        reader_->read_row(current_);
        for (float& height : current_) {
            height = static_cast<float>(map_.offset + map_.scale * height);
            if (!std::isfinite(height))
                throw RequestError(
                    fmt::format("row {} of the map holds a value that is no finite number", read_));
        }
        if (read_ < map_halo)
            first_.push_back(current_);
        ++read_;
    }

    void read_last_rows() {
        while (read_ < map_.height) {
            read();
            last_.push_back(current_);
            if (last_.size() > map_halo)
                last_.erase(last_.begin());
        }
        reader_ = map_.open();
        first_.clear();
        read_ = 0;
    }

    const HeightMap& map_;
    std::unique_ptr<image::PictureReader> reader_;
    int next_;
    int read_ = 0;
    std::vector<float> current_;
    std::vector<std::vector<float>> first_;
    std::vector<std::vector<float>> last_;
};

passes::ErodePush push_of(const HeightMap& map, const Erosion& erosion, std::uint32_t seed,
                          const image::Rect& region) {
    passes::ErodePush push{};
    const auto single = [](double value) { return static_cast<float>(value); };
    if (map.tileable)
        push.period = {single(map.pixel * map.width), single(map.pixel * map.height)};
    push.pixel = single(map.pixel);
    push.seed = seed;
    push.map_width = map.width;
    push.tileable = map.tileable;
    push.hills = !map.open;
    push.first_column = region.x;
    push.width = region.width;
    push.octaves = erosion.octaves;
    push.frequency = single(erosion.frequency);
    push.strength = single(erosion.strength);
    push.lacunarity = single(erosion.lacunarity);
    push.gain = single(erosion.gain);
    push.onset = single(erosion.onset);
    push.detail = single(erosion.detail);
    push.sharpness = single(erosion.sharpness);
    push.ridge_rounding = single(erosion.ridge_rounding);
    push.crease_rounding = single(erosion.crease_rounding);
    push.gully_weight = single(erosion.gully_weight);
    push.branching = single(erosion.branching);
    return push;
}

} // namespace

void erode(const vulkan::Device& device, const HeightMap& map, const Erosion& erosion, std::uint32_t seed,
           const image::Rect& region, const std::function<void(std::span<const float>)>& write) {
    const auto width = static_cast<std::size_t>(map.width);
    const int rows = std::clamp(static_cast<int>(most_band_pixels / width), 1, region.height);
    const auto most = static_cast<std::size_t>(rows);
    const bool hills = !map.open;
    const vulkan::Buffer heights(device,
                                 hills ? sizeof(float) : (most + 2 * map_halo) * width * sizeof(float),
                                 vulkan::Memory::upload);
    const std::size_t values = static_cast<std::size_t>(region.width) * passes::erode_channels;
    const vulkan::Buffer eroded(device, most * values * sizeof(float), vulkan::Memory::readback);
    const vulkan::Pass pass(device, erode_spirv, {2, sizeof(passes::ErodePush)});
    vulkan::Job job(device, pass, {heights, eroded});

    passes::ErodePush push = push_of(map, erosion, seed, region);
    std::optional<MapRows> source;
    if (!hills)
        source.emplace(map, region.y);
    const std::span<float> band = heights.as<float>();
    int filled = 0; // rows in the band's buffer
    for (int done = 0; done < region.height; done += push.height) {
        push.first_row = region.y + done;
        push.height = std::min(rows, region.height - done);
        for (; source && filled < push.height + 2 * map_halo; ++filled)
            source->next(band.subspan(static_cast<std::size_t>(filled) * width, width));
        job.submit(push, {groups(push.width, passes::erode_group), groups(push.height, passes::erode_group)});
        job.wait();
        write(eroded.as<float>().first(static_cast<std::size_t>(push.height) * values));
        if (hills)
            continue;
        const auto kept =
            static_cast<std::size_t>(2 * map_halo) * width; // the last rows are the next band's first
        std::ranges::copy(band.subspan(static_cast<std::size_t>(push.height) * width, kept), band.begin());
        filled = 2 * map_halo;
    }
}

} // namespace gabor::render
