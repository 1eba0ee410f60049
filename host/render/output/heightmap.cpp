#include "render/output/heightmap.hpp"

#include "error.hpp"
#include "names.hpp"

#include "passes/channels.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace gabor::render {

namespace {

std::filesystem::path beside(const std::filesystem::path& map) {
    return map.string() + ".json";
}

nlohmann::ordered_json scale_of(const image::Rect& region, double pixel) {
    return {{"width", region.width},
            {"height", region.height},
            {"extent", {region.width * pixel, region.height * pixel}}};
}

} // namespace

bool has_extension(const std::filesystem::path& path, const char* extension) {
    return lower(path.extension().string()) == extension;
}

std::optional<MapScale> scale_beside(const std::filesystem::path& map) {
    std::ifstream file(beside(map));
    const auto json = nlohmann::ordered_json::parse(file, nullptr, false);
    try {
        const auto& elevation = json.at("elevation");
        const MapScale scale{{elevation.at(0), elevation.at(1)}, json.at("extent").at(0)};
        if (scale.elevation.low < scale.elevation.high && scale.extent > 0)
            return scale;
    } catch (const nlohmann::ordered_json::exception&) { // another program's, or none
    }
    return std::nullopt;
}

HeightWriter::HeightWriter(const std::filesystem::path& path, const image::Rect& region, Elevation elevation,
                           double pixel)
    : elevation_(elevation), scale_(beside(path)) {
    if (has_extension(path, ".png"))
        png_.emplace(path, region.width, region.height, 1, 16);
    else if (has_extension(path, ".r16"))
        raw_.emplace(path);
    else
        throw RequestError(
            fmt::format("heightmap '{}': expected a file name that ends in .png or .r16", path.string()));
    nlohmann::ordered_json scale = scale_of(region, pixel);
    scale["elevation"] = {elevation.low, elevation.high};
    scale_.write(scale.dump(2) + "\n");
}

void HeightWriter::write_rows(std::span<const float> rows, std::size_t channels, std::size_t height) {
    levels_.clear();
    for (std::size_t i = height; i < rows.size(); i += channels)
        levels_.push_back(
            static_cast<float>((rows[i] - elevation_.low) / (elevation_.high - elevation_.low)));
    if (png_)
        return png_->write_rows(levels_);
    bytes_.clear();
    for (const float height_level : levels_) {
        const std::uint32_t level = image::quantize(height_level, 16);
        bytes_.push_back(static_cast<std::byte>(level & 0xffu));
        bytes_.push_back(static_cast<std::byte>(level >> 8));
    }
    raw_->write(bytes_);
}

void HeightWriter::commit() {
    if (png_)
        png_->commit();
    else
        raw_->commit();
    scale_.commit();
}

MaskWriter::MaskWriter(const std::filesystem::path& folder, image::ExrHeader header, double pixel,
                       double reach)
    : folder_(folder), scale_(folder / "masks.json") {
    const image::Rect& region = header.window;
    nlohmann::ordered_json scale = scale_of(region, pixel);
    header.channels.clear();
    const auto add = [&](std::string_view name, double low, double high) {
        masks_.push_back(
            {low, high, {folder / fmt::format("{}.png", name), region.width, region.height, 1, 16}});
        header.channels.emplace_back(name);
        scale["masks"][std::string(name)] = {low, high};
    };
    add("ridge", 0, 1);
    add("crease", 0, 1);
    add("slope", 0, 90);
    add("erosion", -reach, reach);
    for (const char* name : {"grass", "scree", "rock", "snow"})
        add(name, 0, 1);
    exr_.emplace(folder / "masks.exr", header);
    scale_.write(scale.dump(2) + "\n");
}

void MaskWriter::write_rows(std::span<const float> rows) {
    constexpr std::size_t channels = passes::erosion_channels.size();
    std::vector<float> values;
    for (; !rows.empty(); rows = rows.subspan(channels)) {
        const float ridge = rows[passes::erosion_ridge];
        const float slope = std::hypot(rows[passes::erosion_slope], rows[passes::erosion_slope + 1]);
        values.insert(values.end(), {std::max(ridge, 0.0f), std::max(-ridge, 0.0f),
                                     std::atan(slope) * 180 / std::numbers::pi_v<float>});
        values.insert(values.end(), rows.begin() + passes::erosion_added, rows.begin() + channels);
    }
    exr_->write_rows(values);
    std::vector<float> levels;
    for (std::size_t k = 0; k < masks_.size(); ++k) {
        Mask& mask = masks_[k];
        levels.clear();
        for (std::size_t i = k; i < values.size(); i += masks_.size())
            levels.push_back(static_cast<float>((values[i] - mask.low) / (mask.high - mask.low)));
        mask.png.write_rows(levels);
    }
}

void MaskWriter::commit() {
    for (Mask& mask : masks_)
        mask.png.commit();
    exr_->commit();
    scale_.commit();
}

} // namespace gabor::render
