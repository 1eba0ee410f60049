#include "render/heightmap.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <strings.h>

namespace gabor::render {

bool has_extension(const std::filesystem::path& path, const char* extension) {
    return ::strcasecmp(path.extension().c_str(), extension) == 0;
}

HeightWriter::HeightWriter(const std::filesystem::path& path, const image::Rect& region, Elevation elevation,
                           double pixel)
    : elevation_(elevation), scale_(path.string() + ".json") {
    if (has_extension(path, ".png"))
        png_.emplace(path, region.width, region.height, 1, 16);
    else if (has_extension(path, ".r16"))
        raw_.emplace(path);
    else
        throw RequestError(
            fmt::format("heightmap '{}': expected a file name that ends in .png or .r16", path.string()));
    const nlohmann::ordered_json scale{{"width", region.width},
                                       {"height", region.height},
                                       {"extent", {region.width * pixel, region.height * pixel}},
                                       {"elevation", {elevation.low, elevation.high}}};
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

} // namespace gabor::render
