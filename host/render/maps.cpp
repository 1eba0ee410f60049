#include "render/maps.hpp"

#include "error.hpp"
#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/png.hpp"
#include "render/material.hpp"
#include "render/parameters.hpp"
#include "render/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gabor::render {

namespace {

const std::vector<std::string> map_channels{"R",         "G",        "B",        "height",   "roughness",
                                            "metalness", "normal.x", "normal.y", "normal.z", "occlusion"};
constexpr std::size_t height_channel = 3;
constexpr std::size_t roughness_channel = 4;
constexpr std::size_t normal_channel = 6;
constexpr std::size_t occlusion_channel = 9;

// All channels of all pixels, row by row.
struct Maps {
    int width;
    int height;
    bool tiled;
    double scale; // pixels per unit
    std::vector<float> values;

    float* at(int x, int y) {
        return &values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)) *
                       map_channels.size()];
    }

    // Beyond an edge, a tile wraps around, and other maps repeat the nearest pixel.
    double height_at(int x, int y) {
        const auto within = [this](int i, int side) {
            return tiled ? (i % side + side) % side : std::clamp(i, 0, side - 1);
        };
        return double{at(within(x, width), within(y, height))[height_channel]};
    }

    // Sets the share of the sky's light that reaches the pixel: the mean of cos^2 of the horizon's elevation.
    void add_occlusion(int x, int y) {
        constexpr std::array<std::array<int, 2>, 8> directions{
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
        const double here = height_at(x, y);
        double open = 0;
        for (const auto& [dx, dy] : directions) {
            double steepest = 0;
            for (int step = 1; step <= 32; step *= 2)
                steepest = std::max(steepest, (height_at(x + step * dx, y + step * dy) - here) * scale /
                                                  (step * std::hypot(dx, dy)));
            open += 1 / (1 + steepest * steepest) / static_cast<double>(directions.size());
        }
        at(x, y)[occlusion_channel] = static_cast<float>(open);
    }
};

// Replaces the channels that mip levels cannot average: the roughness r with r^4, the second moment of the
// microfacets' slopes, and the normal with the slopes along x and y and the sum of their squares.
std::vector<float> averaged_from(std::span<const float> maps) {
    std::vector<float> averaged(maps.begin(), maps.end());
    for (std::size_t i = 0; i < averaged.size(); i += map_channels.size()) {
        float* const pixel = &averaged[i];
        float* const normal = pixel + normal_channel;
        pixel[roughness_channel] = std::pow(pixel[roughness_channel], 4.0f);
        const float right = -normal[0] / normal[2];
        const float down = normal[1] / normal[2];
        normal[0] = right;
        normal[1] = down;
        normal[2] = right * right + down * down;
    }
    return averaged;
}

// Converts averages back to maps. The slopes that averaging removed make the surface rougher: alpha^2 = r^4
// grows by twice their variance along an axis (an isotropic form of Olano and Baker, "LEAN mapping", 2010;
// Walter et al. 2007 define alpha for Beckmann and GGX).
std::vector<float> maps_from(std::span<const float> averaged) {
    std::vector<float> maps(averaged.begin(), averaged.end());
    for (std::size_t i = 0; i < maps.size(); i += map_channels.size()) {
        float* const pixel = &maps[i];
        float* const normal = pixel + normal_channel;
        const float right = normal[0];
        const float down = normal[1];
        // The variance of the lost slopes, summed over both axes.
        const float lost = std::max(normal[2] - right * right - down * down, 0.0f);
        pixel[roughness_channel] = std::pow(std::min(pixel[roughness_channel] + lost, 1.0f), 0.25f);
        const float length = std::sqrt(right * right + down * down + 1);
        normal[0] = -right / length;
        normal[1] = down / length;
        normal[2] = 1 / length;
    }
    return maps;
}

// Writes the levels after the first.
void write_levels(image::ExrWriter& writer, std::span<const float> maps, int width, int height) {
    std::vector<float> level = averaged_from(maps);
    while (width > 1 || height > 1) {
        level = halved(level, width, height, map_channels.size());
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        writer.write_rows(maps_from(level));
    }
}

// Appends the maps of a rendered pixel, except for its occlusion.
void add_maps(std::span<const float> pixel, bool terrain, std::vector<float>& maps) {
    constexpr std::size_t height = 3;
    constexpr std::size_t terrain_slope = 4;
    constexpr float rough_ground = 1;
    const std::size_t slope = terrain ? terrain_slope : pixel.size() - 2;
    maps.insert(maps.end(), pixel.begin(), pixel.begin() + height + 1);
    maps.push_back(terrain ? rough_ground : pixel[roughness_channel]);
    maps.push_back(terrain ? 0 : pixel[roughness_channel + 1]);
    const double right = -double{pixel[slope]};
    const double up = double{pixel[slope + 1]};
    const double length = std::sqrt(right * right + up * up + 1);
    for (const double part : {right, up, 1.0})
        maps.push_back(static_cast<float>(part / length));
}

// One PNG of the set, with the channels that it stores.
struct Png {
    std::string_view name;
    std::vector<std::size_t> channels;
    int bits = 8;
    float (*shown)(float) = [](float value) { return value; };
};

float unit_to_colour(float part) {
    return 0.5f + 0.5f * part;
}

constexpr std::string_view directx_normal = "normal_directx";

std::vector<Png> pngs_of(const MapFormat& format) {
    std::vector<Png> pngs{{.name = "base_color", .channels = {0, 1, 2}, .shown = srgb},
                          {.name = "normal", .channels = {6, 7, 8}, .shown = unit_to_colour},
                          {.name = "height", .channels = {3}, .bits = 16},
                          {.name = "roughness", .channels = {4}},
                          {.name = "metalness", .channels = {5}},
                          {.name = "occlusion", .channels = {9}},
                          {.name = "orm", .channels = {9, 4, 5}}};
    if (format.directx)
        pngs.push_back({.name = directx_normal, .channels = {6, 7, 8}, .shown = unit_to_colour});
    return pngs;
}

std::filesystem::path png_path(const std::filesystem::path& folder, const Png& png) {
    return folder / fmt::format("{}.png", png.name);
}

constexpr const char* exr_name = "maps.exr";
constexpr const char* materialx_name = "material.mtlx";
constexpr const char* gltf_name = "material.gltf";

void write_maps(const vulkan::Device& device, const Request& request, const std::filesystem::path& folder,
                const MapFormat& format, const image::Advance& advance) {
    const bool terrain = has_terrain(request);
    const bool tileable =
        terrain ? std::get<Terrain>(request.view).tileable : std::get<Plane>(request.view).tileable;
    const std::size_t row = static_cast<std::size_t>(request.width) * map_channels.size();
    const std::vector<Png> pngs = pngs_of(format);
    std::vector<image::PngWriter> writers; // opened before the work begins, to fail early
    for (const Png& png : pngs)
        writers.emplace_back(png_path(folder, png), request.width, request.height,
                             static_cast<int>(png.channels.size()), png.bits);
    const image::Rect whole{0, 0, request.width, request.height};
    image::ExrHeader header = exr_header(request, whole, software(device));
    header.channels = map_channels;
    if (format.texture)
        header.texture = image::ExrHeader::Texture{format.half, tileable};
    image::ExrWriter exr(folder / exr_name, header);
    image::OutputFile materialx(folder / materialx_name);
    image::OutputFile scene(folder / gltf_name);

    const double unit = terrain ? terrain_unit(request) : 1; // height units per kernel radius
    Maps maps{request.width, request.height, tileable, request.scale / unit, {}};
    maps.values.reserve(row * static_cast<std::size_t>(request.height));
    render_region(device, request, whole, [&](std::span<const float> rows) {
        const std::size_t channels = terrain ? terrain_channels.size() : material_channels.size();
        advance(rows.size() / channels);
        for (std::size_t i = 0; i < rows.size(); i += channels) {
            add_maps(rows.subspan(i, channels), terrain, maps.values);
            maps.values.push_back(0); // occlusion
        }
    });
    float low = maps.values[height_channel];
    float high = low;
    for (std::size_t i = height_channel; i < maps.values.size(); i += map_channels.size()) {
        low = std::min(low, maps.values[i]);
        high = std::max(high, maps.values[i]);
    }
    std::vector<float> shown;
    for (int y = 0; y < request.height; ++y) {
        advance(0);
        for (int x = 0; x < request.width; ++x)
            maps.add_occlusion(x, y);
        const std::span<const float> values(maps.at(0, y), row);
        exr.write_rows(values);
        for (std::size_t k = 0; k < pngs.size(); ++k) {
            shown.clear();
            for (std::size_t i = 0; i < row; i += map_channels.size())
                for (const std::size_t channel : pngs[k].channels) {
                    float value = values[i + channel];
                    if (channel == height_channel)
                        value = high > low ? (value - low) / (high - low) : 0.5f;
                    if (channel == normal_channel + 1 && pngs[k].name == directx_normal)
                        value = -value;
                    shown.push_back(pngs[k].shown(value));
                }
            writers[k].write_rows(shown);
        }
    }
    if (format.texture)
        write_levels(exr, maps.values, request.width, request.height);
    const auto write = [&](image::OutputFile& file, std::string_view text) {
        const double longer = std::max(request.width, request.height);
        const std::string filled = fmt::format(
            fmt::runtime(text), fmt::arg("name", terrain ? "terrain" : std::string_view(request.material)),
            fmt::arg("version", GABOR_VERSION), fmt::arg("low", low), fmt::arg("high", high),
            fmt::arg("width",
                     text == materialx_template ? request.width / request.scale : request.width / longer),
            fmt::arg("height", request.height / longer));
        file.write(filled);
    };
    write(materialx, materialx_template);
    write(scene, gltf_template);
    for (image::PngWriter& writer : writers)
        writer.commit();
    exr.commit();
    materialx.commit();
    scene.commit();
}

} // namespace

bool has_maps(const Request& request) {
    const auto* terrain = std::get_if<Terrain>(&request.view);
    return terrain ? !terrain->perspective
                   : has_material(request) && std::holds_alternative<Plane>(request.view);
}

std::vector<std::filesystem::path> map_paths(const std::filesystem::path& folder, const MapFormat& format) {
    std::vector<std::filesystem::path> paths;
    for (const Png& png : pngs_of(format))
        paths.push_back(png_path(folder, png));
    for (const char* name : {exr_name, materialx_name, gltf_name})
        paths.push_back(folder / name);
    return paths;
}

void render_maps(const vulkan::Device& device, const Request& request, const std::filesystem::path& folder,
                 const MapFormat& format, const image::Advance& advance) {
    if (!has_maps(request))
        throw RequestError(
            "--maps requires either --view terrain or a material in --view flat, such as --material wood");
    if (std::max(request.width, request.height) > most_map_side)
        throw RequestError(fmt::format("maps of {} x {} pixels are too large: at most {} x {} are supported",
                                       request.width, request.height, most_map_side, most_map_side));
    const image::OutputFolder created(folder);
    write_maps(device, request, folder, format, advance);
}

} // namespace gabor::render
