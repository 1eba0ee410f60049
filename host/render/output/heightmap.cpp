#include "render/output/heightmap.hpp"

#include "error.hpp"
#include "names.hpp"

#include "passes/channels.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace gabor::render {

namespace {

std::filesystem::path beside(const std::filesystem::path& map) {
    return map.string() + ".json";
}

nlohmann::ordered_json scale_of(const image::Rect& region, const std::array<double, 2>& pixel,
                                std::optional<float> missing) {
    nlohmann::ordered_json scale{{"width", region.width},
                                 {"height", region.height},
                                 {"extent", {region.width * pixel[0], region.height * pixel[1]}}};
    if (missing)
        scale["missing"] = *missing;
    return scale;
}

constexpr Elevation no_range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};

} // namespace

bool has_extension(const std::filesystem::path& path, const char* extension) {
    return lower(path.extension().string()) == extension;
}

std::optional<MapScale> scale_beside(const std::filesystem::path& map) {
    std::ifstream file(beside(map));
    const auto json = nlohmann::ordered_json::parse(file, nullptr, false);
    try {
        const auto& extent = json.at("extent");
        MapScale scale{{}, {extent.at(0), extent.at(1)}, {}};
        if (json.contains("elevation"))
            scale.elevation = {json["elevation"].at(0), json["elevation"].at(1)};
        if (json.contains("missing") && json["missing"].is_number())
            scale.missing = json["missing"];
        else if (json.contains("missing") && json["missing"].is_null()) // JSON has no NaN
            scale.missing = std::numeric_limits<float>::quiet_NaN();
        const auto is_positive = [](double side) { return side > 0 && std::isfinite(side); };
        if (std::ranges::all_of(scale.extent, is_positive) &&
            (!scale.elevation || scale.elevation->low < scale.elevation->high))
            return scale;
    } catch (const nlohmann::ordered_json::exception&) { // another program's, or none
    }
    return std::nullopt;
}

bool is_tiff(const std::filesystem::path& path) {
    return has_extension(path, ".tif") || has_extension(path, ".tiff");
}

bool is_16_bit(const std::filesystem::path& path) {
    return std::ranges::any_of(std::array{".png", ".r16", ".raw"},
                               [&](const char* extension) { return has_extension(path, extension); });
}

HeightWriter::HeightWriter(const std::filesystem::path& path, const image::Rect& region, HeightFormat format)
    : region_(region), format_(std::move(format)), waiting_(nullptr, std::fclose), found_(no_range) {
    if (is_tiff(path))
        tiff_.emplace(path, region.width, region.height, format_.geo, format_.missing,
                      format_.exr.compression != "none");
    else
        scale_.emplace(beside(path));
    if (tiff_)
        return;
    if (has_extension(path, ".exr")) {
        format_.exr.channels = {"Y"};
        exr_.emplace(path, format_.exr);
    } else if (has_extension(path, ".png")) {
        png_.emplace(path, region.width, region.height, 1, 16);
    } else if (floats_ = has_extension(path, ".r32"); floats_ || is_16_bit(path)) {
        raw_.emplace(path);
    } else {
        throw RequestError(fmt::format("heightmap '{}': expected a file name that ends in {}", path.string(),
                                       fmt::join(height_extensions, ", ")));
    }
    if (!is_16_bit(path))
        return;
    if (format_.full_range)
        waiting_.reset(std::tmpfile());
    else
        write_scale();
    if (format_.full_range && !waiting_)
        throw std::runtime_error(fmt::format("cannot create a temporary file: {}", std::strerror(errno)));
}

bool HeightWriter::is_missing(float height) const {
    return std::isnan(height) || height == format_.missing;
}

// Writes the JSON file. If some pixels may have no height, 0 stands for that, and 1 for the lowest height.
void HeightWriter::write_scale() {
    Elevation& elevation = format_.elevation;
    const bool levels = !exr_ && !floats_;
    if (levels && format_.missing)
        elevation.low -= (elevation.high - elevation.low) / 65534;
    nlohmann::ordered_json scale =
        scale_of(region_, format_.pixel, levels && format_.missing ? 0.0f : format_.missing);
    if (levels)
        scale["elevation"] = {elevation.low, elevation.high};
    scale_->write(scale.dump(2) + "\n");
}

void HeightWriter::write_rows(std::span<const float> rows, std::size_t channels, std::size_t height) {
    heights_.clear();
    for (std::size_t i = height; i < rows.size(); i += channels)
        heights_.push_back(rows[i]);
    if (!waiting_)
        return write_heights();
    for (const float each : heights_)
        if (!is_missing(each))
            found_ = {std::min<double>(found_.low, each), std::max<double>(found_.high, each)};
    if (std::fwrite(heights_.data(), sizeof(float), heights_.size(), waiting_.get()) != heights_.size())
        throw std::runtime_error(fmt::format("cannot write a temporary file: {}", std::strerror(errno)));
}

// Writes `heights_` in the file's format.
void HeightWriter::write_heights() {
    if (tiff_)
        return tiff_->write_rows(heights_);
    if (exr_)
        return exr_->write_rows(heights_);
    if (floats_) {
        bytes_.clear();
        for (const float height : heights_)
            for (unsigned shift = 0; shift < 32; shift += 8)
                bytes_.push_back(static_cast<std::byte>(std::bit_cast<std::uint32_t>(height) >> shift));
        return raw_->write(bytes_);
    }
    const auto [low, high] = format_.elevation;
    for (float& height : heights_)
        height = is_missing(height) ? 0.0f
                                    : std::max(static_cast<float>((height - low) / (high - low)),
                                               format_.missing ? 1.0f / 65535 : 0.0f);
    if (png_)
        return png_->write_rows(heights_);
    bytes_.clear();
    for (const float share : heights_) {
        const std::uint32_t level = image::quantize(share, 16);
        bytes_.push_back(static_cast<std::byte>(level & 0xffu));
        bytes_.push_back(static_cast<std::byte>(level >> 8));
    }
    raw_->write(bytes_);
}

void HeightWriter::commit() {
    if (waiting_) {
        if (found_.low > found_.high) // no pixel has a height
            found_ = {0, 1};
        format_.elevation = {found_.low, found_.high > found_.low ? found_.high : found_.low + 1};
        write_scale();
        std::rewind(waiting_.get());
        heights_.resize(static_cast<std::size_t>(region_.width));
        for (int y = 0; y < region_.height; ++y) {
            if (std::fread(heights_.data(), sizeof(float), heights_.size(), waiting_.get()) !=
                heights_.size())
                throw std::runtime_error("cannot read a temporary file");
            write_heights();
        }
    } else if (scale_ && (exr_ || floats_)) {
        write_scale();
    }
    if (png_)
        png_->commit();
    if (raw_)
        raw_->commit();
    if (tiff_)
        tiff_->commit();
    if (exr_)
        exr_->commit();
    if (scale_)
        scale_->commit();
}

MaskWriter::MaskWriter(const std::filesystem::path& folder, image::ExrHeader header,
                       const std::array<double, 2>& pixel, std::optional<float> missing, double reach)
    : folder_(folder), scale_(folder / "masks.json") {
    const image::Rect& region = header.window;
    nlohmann::ordered_json scale = scale_of(region, pixel, missing);
    header.channels = {"Y"};
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
    const std::size_t kept = 1 + masks_.size();
    std::vector<float> values;
    for (; !rows.empty(); rows = rows.subspan(channels)) {
        const float ridge = rows[passes::erosion_ridge];
        const float slope = std::hypot(rows[passes::erosion_slope], rows[passes::erosion_slope + 1]);
        values.insert(values.end(),
                      {rows[passes::erosion_height], std::max(ridge, 0.0f), std::max(-ridge, 0.0f),
                       std::atan(slope) * 180 / std::numbers::pi_v<float>});
        values.insert(values.end(), rows.begin() + passes::erosion_added, rows.begin() + channels);
    }
    exr_->write_rows(values);
    std::vector<float> levels;
    for (std::size_t k = 0; k < masks_.size(); ++k) {
        Mask& mask = masks_[k];
        levels.clear();
        for (std::size_t i = 1 + k; i < values.size(); i += kept)
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
