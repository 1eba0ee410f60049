#include "cli/heights.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace gabor::cli {

namespace {

std::string preset_names() {
    std::string names;
    for (const render::ErosionPreset& preset : render::erosion_presets())
        names += (names.empty() ? "" : ", ") + std::string(preset.name);
    return names;
}

} // namespace

bool has_extension(const std::filesystem::path& path, std::string_view extension) {
    std::string own = path.extension().string();
    std::ranges::transform(own, own.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return own == extension;
}

void GullyOptions::add_to(CLI::App& command) {
    command.add_option("--preset", preset, fmt::format("Shape of the gullies: {} [alps]", preset_names()))
        ->type_name("NAME");
    const auto parameters = render::erosion_parameters();
    members.resize(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i)
        command
            .add_option(fmt::format("--{}", parameters[i].name), members[i],
                        std::string(parameters[i].summary))
            ->type_name("NUMBER");
}

render::Erosion GullyOptions::erosion(double hill) const {
    const auto presets = render::erosion_presets();
    const auto found = std::ranges::find(presets, preset, &render::ErosionPreset::name);
    if (found == presets.end())
        throw RequestError(fmt::format("--preset '{}': it takes {}", preset, preset_names()));
    render::Erosion erosion = found->erosion;
    erosion.frequency *= preset_hill / hill;
    const auto parameters = render::erosion_parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!members[i])
            continue;
        const render::ErosionParameter& parameter = parameters[i];
        const double value = *members[i];
        const bool octaves = parameter.member == &render::Erosion::octaves;
        if (!(value >= parameter.low && value <= parameter.high) || (octaves && value != std::floor(value)))
            throw RequestError(fmt::format("--{} {}: it takes {} from {} to {}", parameter.name, value,
                                           octaves ? "a whole number" : "a number", parameter.low,
                                           parameter.high));
        erosion.*parameter.member = value;
    }
    return erosion;
}

image::Rect region_within(const std::vector<int>& region, int width, int height) {
    if (region.empty())
        return {0, 0, width, height};
    const image::Rect r{region[0], region[1], region[2], region[3]};
    if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.width > width - r.x || r.height > height - r.y)
        throw RequestError(fmt::format("--region {},{},{},{} is not within the map of {} x {} pixels", r.x,
                                       r.y, r.width, r.height, width, height));
    return r;
}

HeightWriter::HeightWriter(const std::filesystem::path& path, const image::Rect& region, Elevation elevation,
                           double pixel)
    : elevation_(elevation), scale_(path.string() + ".json") {
    if (has_extension(path, ".png"))
        png_.emplace(path, region.width, region.height, 1, 16);
    else
        raw_.emplace(path);
    const nlohmann::ordered_json scale{{"width", region.width},
                                       {"height", region.height},
                                       {"extent", {region.width * pixel, region.height * pixel}},
                                       {"elevation", {elevation.low, elevation.high}}};
    const std::string text = scale.dump(2) + "\n";
    scale_.write(std::as_bytes(std::span(text)));
}

void HeightWriter::write_rows(std::span<const float> eroded) {
    levels_.clear();
    for (std::size_t i = 0; i < eroded.size(); i += render::erosion_channels.size())
        levels_.push_back(
            static_cast<float>((eroded[i] - elevation_.low) / (elevation_.high - elevation_.low)));
    if (png_)
        png_->write_rows(levels_);
    else
        raw_->write_rows(levels_);
}

void HeightWriter::commit() {
    if (png_)
        png_->commit();
    else
        raw_->commit();
    scale_.commit();
}

} // namespace gabor::cli
