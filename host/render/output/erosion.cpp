#include "render/output/erosion.hpp"

#include "error.hpp"
#include "render/plan/plan_parts.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"

#include "passes/erode_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gabor::render {

namespace {

// Heights that usually mean that there is none.
bool is_absurd(float height) {
    return !std::isfinite(height) || std::abs(height) >= 1e9f || height == -9999 || height == -99999 ||
           height == -32768 || height == -32767;
}

// The rows of a map. Reads each row once if rows are requested from top to bottom. Beyond the edges, a tile
// repeats and other maps keep the height of the edge.
class MapRows {
  public:
    explicit MapRows(const HeightMap& map)
        : map_(map), heights_(static_cast<std::size_t>(map.width)),
          values_(heights_.size() * static_cast<std::size_t>(map.channels)) {}

    const std::vector<float>& operator[](int y) {
        const int row =
            map_.tileable ? (y % map_.height + map_.height) % map_.height : std::clamp(y, 0, map_.height - 1);
        if (!reader_ || row < read_ - 1) {
            reader_ = map_.open();
            read_ = 0;
        }
        for (; read_ <= row; ++read_)
            read_row();
        return heights_;
    }

  private:
    void read_row() {
        reader_->read_row(values_);
        const auto channels = static_cast<std::size_t>(map_.channels);
        for (std::size_t x = 0; x < heights_.size(); ++x) {
            float& height = heights_[x];
            height = values_[channels * x];
            if (channels == 3 && (values_[3 * x + 1] != height || values_[3 * x + 2] != height))
                throw RequestError(fmt::format("the map is in colour, for example at pixel ({}, {}): a "
                                               "heightmap is grey, or needs --encoding",
                                               x, read_));
            if (map_.missing && (height == *map_.missing || std::isnan(height))) {
                height = passes::missing_height;
                continue;
            }
            if (is_absurd(height))
                throw RequestError(fmt::format("pixel ({}, {}) of the map has the height {:.9g}: if that "
                                               "means that it has none, give --nodata {:.9g}",
                                               x, read_, height, height));
            height = static_cast<float>(map_.offset + map_.scale * height);
        }
    }

    const HeightMap& map_;
    std::unique_ptr<image::PictureReader> reader_;
    int read_ = 0;
    std::vector<float> heights_; // heights of the last row read
    std::vector<float> values_;
};

// The four nodes of a cubic B-spline that reach a pixel, and their weights.
struct Reach {
    std::size_t first;
    std::array<double, 4> weight;
};
std::vector<Reach> reaches(int pixels, const SplineAxis& axis) {
    std::vector<Reach> all;
    for (int i = 0; i < pixels; ++i) {
        const double at = axis.phase + (i + 0.5) * axis.nodes / axis.pixels, t = at - std::floor(at),
                     u = 1 - t;
        all.push_back(
            {static_cast<std::size_t>(at),
             {u * u * u / 6, (4 - 3 * t * t * (1 + u)) / 6, (4 - 3 * u * u * (1 + t)) / 6, t * t * t / 6}});
    }
    return all;
}

// Adds the nodes at and beyond the right edge of a tile to those at the left edge, which repeat there.
void wrap(std::vector<double>& sums, int intervals, std::size_t stride, std::size_t lines,
          std::size_t line_stride) {
    const std::size_t period = static_cast<std::size_t>(intervals) * stride;
    for (std::size_t line = 0; line < lines; ++line)
        for (std::size_t i = 0; i < 3; ++i) {
            double& low = sums[line * line_stride + i * stride];
            double& high = sums[line * line_stride + i * stride + period];
            low = high = low + high;
        }
}

double steepness_of(const SmoothedMap& smoothed) {
    return smoothed.slope > 0 ? preset_slope / smoothed.slope : 1;
}

// Nodes a whole number of which fits the map; in a world, those that are a multiple of `spacing` from its
// origin.
SplineAxis axis_of(int pixels, double spacing, std::optional<int> first) {
    if (!first) {
        const double intervals = std::clamp(std::round(pixels / spacing), 3.0, std::max(3.0, 1.0 * pixels));
        return {intervals, 1.0 * pixels, 0, static_cast<int>(intervals)};
    }
    const double at = *first / spacing, phase = at - std::floor(at);
    return {1, spacing, phase, static_cast<int>(std::ceil(phase + pixels / spacing))};
}

} // namespace

SmoothedMap smoothed(const HeightMap& map, double spacing) {
    SmoothedMap result;
    const auto origin = [&](std::size_t axis) {
        return map.world ? std::optional((*map.world)[axis]) : std::nullopt;
    };
    result.axes = {axis_of(map.width, spacing, origin(0)),
                   axis_of(map.height, spacing * map.pixel[0] / map.pixel[1], origin(1))};
    const auto& [axis_x, axis_y] = result.axes;
    const std::vector<Reach> columns = reaches(map.width, axis_x), rows = reaches(map.height, axis_y);
    const auto across = static_cast<std::size_t>(axis_x.intervals + 3),
               down = static_cast<std::size_t>(axis_y.intervals + 3);
    std::vector<double> sums(across * down), weights(across * down), line(across), line_weights(across);
    float low = std::numeric_limits<float>::max(), high = -low;
    MapRows heights(map);
    for (int y = 0; y < map.height; ++y) {
        std::ranges::fill(line, 0.0);
        std::ranges::fill(line_weights, 0.0);
        const std::vector<float>& row = heights[y];
        for (std::size_t x = 0; x < row.size();) {
            const std::size_t first = columns[x].first;
            std::array<double, 4> sum{}, weight{}; // of the pixels between two nodes
            for (; x < row.size() && columns[x].first == first; ++x) {
                if (row[x] == passes::missing_height)
                    continue;
                low = std::min(low, row[x]);
                high = std::max(high, row[x]);
                for (std::size_t i = 0; i < 4; ++i) {
                    sum[i] += columns[x].weight[i] * row[x];
                    weight[i] += columns[x].weight[i];
                }
            }
            for (std::size_t i = 0; i < 4; ++i) {
                line[first + i] += sum[i];
                line_weights[first + i] += weight[i];
            }
        }
        const Reach& reach = rows[static_cast<std::size_t>(y)];
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < across; ++i) {
                sums[(reach.first + j) * across + i] += reach.weight[j] * line[i];
                weights[(reach.first + j) * across + i] += reach.weight[j] * line_weights[i];
            }
    }
    if (low > high)
        throw RequestError("the map has no heights: every pixel has the value of --nodata");
    if (map.tileable)
        for (std::vector<double>* each : {&sums, &weights}) {
            wrap(*each, axis_x.intervals, 1, down, across);
            wrap(*each, axis_y.intervals, across, across, 1);
        }
    result.range = {low, high};
    constexpr double no_weight = 1e-9;
    const float middle = low / 2 + high / 2;
    for (std::size_t i = 0; i < sums.size(); ++i)
        result.heights.push_back(weights[i] > no_weight ? static_cast<float>(sums[i] / weights[i]) : middle);

    const auto at = [&](std::size_t x, std::size_t y) { return double{result.heights[y * across + x]}; };
    const auto along = [&](auto height) { // the derivative at the middle node of 3 x 3
        double slope = 0;
        for (int i = 0; i < 3; ++i)
            slope += (i == 1 ? 4.0 : 1.0) / 12 * (height(2, i) - height(0, i));
        return slope;
    };
    const auto is_known = [&](std::size_t x, std::size_t y) { // all of the 3 x 3 nodes
        for (std::size_t i = 0; i < 9; ++i)
            if (weights[(y + i / 3) * across + x + i % 3] <= no_weight)
                return false;
        return true;
    };
    double power = 0, nodes = 0;
    for (std::size_t y = 0; y + 2 < down; ++y)
        for (std::size_t x = 0; x + 2 < across; ++x) {
            if (!is_known(x, y))
                continue;
            ++nodes;
            const auto offset = [](int i) { return static_cast<std::size_t>(i); };
            const double to_right = along([&](int i, int j) { return at(x + offset(i), y + offset(j)); });
            const double to_bottom = along([&](int i, int j) { return at(x + offset(j), y + offset(i)); });
            power += std::pow(to_right * axis_x.nodes / axis_x.pixels / map.pixel[0], 2) +
                     std::pow(to_bottom * axis_y.nodes / axis_y.pixels / map.pixel[1], 2);
        }
    result.slope = std::sqrt(power / std::max(nodes, 1.0));
    return result;
}

double erosion_reach(const SmoothedMap& smoothed, double side, const Request& request) {
    return erosion_reach(request) * std::get<double>(*parameter("gully_weight").get(request)) * side /
           preset_side / steepness_of(smoothed);
}

Plan erosion_plan(const HeightMap& map, const SmoothedMap& smoothed, double side, const Request& request,
                  const image::Rect& region, bool cover) {
    auto push = push_of<passes::ErodePush>(region);
    const auto& [axis_x, axis_y] = smoothed.axes;
    const std::array pixel{preset_side * map.pixel[0] / side, preset_side * map.pixel[1] / side};
    if (map.tileable)
        push.period = vec2_of(pixel[0] * map.width, pixel[1] * map.height);
    push.nodes = vec2_of(axis_x.nodes / axis_x.pixels, axis_y.nodes / axis_y.pixels);
    push.phase = vec2_of(axis_x.phase, axis_y.phase);
    push.pixel = vec2_of(pixel[0], pixel[1]);
    if (map.world) {
        const double x = pixel[0] * (*map.world)[0], y = pixel[1] * (*map.world)[1];
        push.cell = {static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
        push.local = vec2_of(x - std::floor(x), y - std::floor(y));
    }
    push.unit = static_cast<float>(side / preset_side);
    push.steepness = static_cast<float>(steepness_of(smoothed));
    push.missing = static_cast<float>(map.offset + map.scale * map.missing.value_or(0));
    push.middle = std::midpoint(smoothed.range[0], smoothed.range[1]);
    push.relief = std::max(smoothed.range[1] - push.middle, std::numeric_limits<float>::min());
    push.seed = request.seed;
    push.map_width = map.width;
    push.table_width = axis_x.intervals + 3;
    push.tileable = map.tileable;
    constexpr int group = passes::erode_group;
    Constants constants{};
    constants[passes::channels_id] = cover ? erosion_channels.size() : passes::erosion_cover;
    return {{erosion_channels.begin(), erosion_channels.begin() + constants[passes::channels_id]},
            region.width,
            region.height,
            {bytes_of(struct_values(request)), bytes_of(smoothed.heights)},
            {{"erode", constants, bytes_of(push), region.width, {group, group}, {}}},
            {map.width, passes::erode_halo}};
}

void erode(const vulkan::Device& device, const HeightMap& map, const SmoothedMap& smoothed, double side,
           const Request& request, const image::Rect& region, bool cover, const Sink& write) {
    const Renderer renderer(device, erosion_plan(map, smoothed, side, request, region, cover));
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
