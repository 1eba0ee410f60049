#include "render/output/maps.hpp"

#include "error.hpp"
#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/png.hpp"
#include "render/output/texture.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace gabor::render {

namespace {

constexpr std::size_t height_channel = passes::material_height;
constexpr std::size_t roughness_channel = passes::material_roughness;
constexpr std::size_t normal_channel = passes::material_lit;
constexpr std::size_t occlusion_channel = normal_channel + 3;

// The channels of a material up to its light, then the normal and the occlusion.
const std::vector<std::string> map_channels = [] {
    std::vector<std::string> names(material_channels.begin(), material_channels.begin() + normal_channel);
    names.insert(names.end(), {"normal.x", "normal.y", "normal.z", "occlusion"});
    return names;
}();

constexpr int horizon = 32; // pixels that occlusion looks far

// The heights of maps in metres, row by row, with `horizon` more pixels on each side: beyond an edge, a tile
// wraps around, and other maps repeat the nearest pixel.
class Heights {
  public:
    explicit Heights(const Request& request)
        : columns_(request.width), rows_(request.height), tiled_(request.view.tileable),
          values_(static_cast<std::size_t>(columns_ + 2 * horizon) *
                  static_cast<std::size_t>(rows_ + 2 * horizon)) {}

    // Sets row y from maps, and the rows beyond the edges that repeat it.
    void set(int y, const float* maps) {
        float* const row = at(y);
        for (int x = -horizon; x < columns_ + horizon; ++x)
            row[x] =
                maps[static_cast<std::size_t>(within(x, columns_)) * map_channels.size() + height_channel];
        for (int i = 0; i < horizon; ++i)
            for (const int beyond : {-1 - i, rows_ + i})
                if (within(beyond, rows_) == y)
                    std::copy(row - horizon, row + columns_ + horizon, at(beyond) - horizon);
    }

    std::span<const float> row(int y) const { return {at(y), static_cast<std::size_t>(columns_)}; }

    std::pair<float, float> range() const {
        auto [low, high] = std::pair(*at(0), *at(0));
        for (int y = 0; y < rows_; ++y) {
            const auto [lowest, highest] = std::ranges::minmax(row(y));
            low = std::min(low, lowest);
            high = std::max(high, highest);
        }
        return {low, high};
    }

    void set_occlusion(int y, double pixels_per_metre, float* maps) const;

  private:
    int within(int i, int side) const {
        if (!tiled_)
            return std::clamp(i, 0, side - 1);
        const int rest = i % side;
        return rest < 0 ? rest + side : rest;
    }
    std::ptrdiff_t down() const { return columns_ + 2 * horizon; }
    const float* at(int y) const {
        return &values_[static_cast<std::size_t>((y + horizon) * down() + horizon)];
    }
    float* at(int y) { return &values_[static_cast<std::size_t>((y + horizon) * down() + horizon)]; }

    int columns_;
    int rows_;
    bool tiled_;
    std::vector<float> values_;
};

// Sets the share of the sky's light that reaches the pixels of row y: the mean of cos^2 of the horizon's
// elevation. A row at a time, which compilers turn into vectors.
void Heights::set_occlusion(int y, double pixels_per_metre, float* maps) const {
    constexpr std::array<std::array<int, 2>, 8> directions{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const auto width = static_cast<std::size_t>(columns_);
    const float* const here = at(y);
    std::vector<float> steepest(width), open(width);
    for (const auto& [dx, dy] : directions) {
        std::ranges::fill(steepest, 0.0f);
        for (int step = 1; step <= horizon; step *= 2) {
            const float* const there = here + step * (dy * down() + dx);
            const auto share = static_cast<float>(pixels_per_metre / (step * std::hypot(dx, dy)));
            for (std::size_t x = 0; x < width; ++x)
                steepest[x] = std::max(steepest[x], share * (there[x] - here[x]));
        }
        for (std::size_t x = 0; x < width; ++x)
            open[x] += 1 / (1 + steepest[x] * steepest[x]);
    }
    for (std::size_t x = 0; x < width; ++x)
        maps[x * map_channels.size() + occlusion_channel] = open[x] / static_cast<float>(directions.size());
}

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

// Converts averages back to maps. The slopes that averaging removed make the surface rougher, as in
// gabor_roughness: alpha^2 = r^4 grows with their variance (an isotropic form of Olano and Baker, "LEAN
// mapping", 2010).
std::vector<float> maps_from(std::span<const float> averaged) {
    std::vector<float> maps(averaged.begin(), averaged.end());
    for (std::size_t i = 0; i < maps.size(); i += map_channels.size()) {
        float* const pixel = &maps[i];
        float* const normal = pixel + normal_channel;
        const float right = normal[0];
        const float down = normal[1];
        // The variance of the lost slopes, summed over both axes.
        const float lost = std::max(normal[2] - right * right - down * down, 0.0f);
        pixel[roughness_channel] = std::pow(std::min(pixel[roughness_channel] + 0.5f * lost, 1.0f), 0.25f);
        const float length = std::sqrt(right * right + down * down + 1);
        normal[0] = -right / length;
        normal[1] = down / length;
        normal[2] = 1 / length;
    }
    return maps;
}

// Sets the maps of a rendered pixel, except for its occlusion. `unit` is that of heights, in metres.
void set_maps(std::span<const float> pixel, bool terrain, float unit, float* maps) {
    constexpr float rough_ground = 1;
    const std::size_t slope = terrain ? passes::terrain_slope : passes::material_slope;
    std::ranges::copy(pixel.first(height_channel), maps);
    maps[height_channel] = unit * pixel[height_channel];
    maps[roughness_channel] = terrain ? rough_ground : pixel[roughness_channel];
    maps[passes::material_metalness] = terrain ? 0 : pixel[passes::material_metalness];
    const float right = -pixel[slope];
    const float up = pixel[slope + 1];
    const float length = std::sqrt(right * right + up * up + 1);
    maps[normal_channel] = right / length;
    maps[normal_channel + 1] = up / length;
    maps[normal_channel + 2] = 1 / length;
}

constexpr int band = 16; // rows of maps that are written together: few enough for a cache

// Draws the maps, with their heights, and passes bands of whole rows to `use`, with the index of the first.
void draw_maps(const vulkan::Device& device, const Request& request, double metres, Heights& heights,
               const image::Advance& advance, const std::function<void(std::span<const float>, int)>& use) {
    const bool terrain = request.kind == Kind::terrain;
    const auto unit =
        static_cast<float>(metres / request.width * request.scale / (terrain ? terrain_unit(request) : 1));
    const std::size_t channels = render::channels(request).size();
    const std::size_t row_values = static_cast<std::size_t>(request.width) * map_channels.size();
    std::vector<float> waiting; // rows whose occlusion needs heights that are not drawn yet
    const auto add_rows = [&](std::span<const float> pixels) {
        const std::size_t before = waiting.size();
        waiting.resize(before + pixels.size() / channels * map_channels.size());
        float* next = waiting.data() + before;
        for (std::size_t i = 0; i < pixels.size(); i += channels, next += map_channels.size())
            set_maps(pixels.subspan(i, channels), terrain, unit, next);
    };
    Renderer renderer(device);
    const auto draw = [&](int first, int rows, const Sink& take) {
        Viewport viewport = viewport_of(request, {0, first, request.width, rows});
        viewport.lit = false;
        renderer.set(plan(request, viewport, {}, kind_of(device)));
        render_plan(device, renderer, take);
    };
    if (const int rows = std::min(horizon, request.height); request.view.tileable) { // beyond the upper edge
        draw(request.height - rows, rows, add_rows);
        for (int i = 0; i < rows; ++i)
            heights.set(request.height - rows + i, &waiting[static_cast<std::size_t>(i) * row_values]);
        waiting.clear();
    }
    int drawn = 0;
    int used = 0;
    draw(0, request.height, [&](std::span<const float> pixels) {
        advance(pixels.size() / channels);
        add_rows(pixels);
        const auto end = used + static_cast<int>(waiting.size() / row_values);
        for (; drawn < end; ++drawn)
            heights.set(drawn, &waiting[static_cast<std::size_t>(drawn - used) * row_values]);
        std::size_t done = 0;
        while (used < drawn && (drawn == request.height || used + band + horizon <= drawn)) {
            advance(0);
            const int rows = std::min(band, drawn - used);
            for (int i = 0; i < rows; ++i)
                heights.set_occlusion(used + i, request.width / metres,
                                      &waiting[done + static_cast<std::size_t>(i) * row_values]);
            const auto used_values = static_cast<std::size_t>(rows) * row_values;
            use(std::span(waiting).subspan(done, used_values), used);
            done += used_values;
            used += rows;
        }
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(done));
    });
}

constexpr std::string_view directx_name = "normal_directx";
constexpr float flat_grey = 0.5f; // of height.png where all heights are equal

// One PNG of the set, with the channels that it stores.
struct Png {
    std::string_view name;
    std::vector<std::size_t> channels;
    int bits = 8;
};

std::vector<Png> pngs_of(const MapFormat& format) {
    const std::vector<std::size_t> normal{normal_channel, normal_channel + 1, normal_channel + 2};
    std::vector<Png> pngs{{"base_color", {0, 1, 2}},
                          {"normal", normal, format.normal_bits},
                          {"height", {height_channel}, 16},
                          {"roughness", {roughness_channel}},
                          {"metalness", {passes::material_metalness}},
                          {"occlusion", {occlusion_channel}},
                          {"orm", {occlusion_channel, roughness_channel, passes::material_metalness}}};
    if (format.directx)
        pngs.push_back({directx_name, normal, format.normal_bits});
    return pngs;
}

std::filesystem::path png_path(const std::filesystem::path& folder, const Png& png) {
    return folder / fmt::format("{}.png", png.name);
}

constexpr const char* exr_name = "maps.exr";
constexpr const char* materialx_name = "material.mtlx";
constexpr const char* gltf_name = "material.gltf";
constexpr const char* summary_name = "material.json";

image::ExrHeader header_of(const vulkan::Device& device, const Request& request, const MapFormat& format,
                           double metres) {
    image::ExrHeader header = exr_header(request, {0, 0, request.width, request.height}, software(device));
    header.channels = map_channels;
    if (!format.floats)
        std::ranges::copy_if(map_channels, std::back_inserter(header.halves),
                             [](const std::string& name) { return name != map_channels[height_channel]; });
    header.metres = metres;
    header.compression = format.compression;
    if (format.texture)
        header.texture = image::ExrHeader::Texture{request.view.tileable};
    return header;
}

// What to add before rounding to 8 bits, in steps, so that reflections have no bands: neighbours share evenly
// between -1/2 and 1/2 (Jimenez, "Next generation post processing in Call of Duty", 2014).
float dither(std::size_t x, std::size_t y) {
    const double wave = 0.06711056 * static_cast<double>(x) + 0.00583715 * static_cast<double>(y);
    return static_cast<float>(std::fmod(52.9829189 * std::fmod(wave, 1.0), 1.0) - 0.5);
}

// Returns what a PNG shows of whole rows, but for heights; `y` is the first.
std::vector<float> shown_rows(const Png& png, std::span<const float> rows, std::size_t width, std::size_t y) {
    const std::size_t count = png.channels.size();
    std::vector<float> shown(rows.size() / map_channels.size() * count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t channel = png.channels[k];
        const auto set = [&](auto show) {
            const float* from = &rows[channel];
            for (std::size_t i = k; i < shown.size(); i += count, from += map_channels.size())
                shown[i] = show(*from);
        };
        if (channel < height_channel) {
            set(srgb);
        } else if (channel < normal_channel || channel == occlusion_channel) {
            set([](float value) { return value; });
        } else {
            const float half = channel == normal_channel + 1 && png.name == directx_name ? -0.5f : 0.5f;
            set([half](float value) { return 0.5f + half * value; });
        }
    }
    if (png.channels.front() == normal_channel && png.bits == 8)
        for (std::size_t i = 0; i < shown.size(); ++i)
            shown[i] += dither(i / 3 % width + 32 * (i % 3), y + i / 3 / width) / 255;
    return shown;
}

bool shows_heights(const Png& png) {
    return png.channels.front() == height_channel;
}

void write_heights(image::PngWriter& writer, const Heights& heights, int rows, float low, float high) {
    const float share = high > low ? 1 / (high - low) : 0;
    std::vector<float> shown;
    for (int y = 0; y < rows; ++y) {
        shown.clear();
        for (const float height : heights.row(y))
            shown.push_back(share > 0 ? (height - low) * share : flat_grey);
        writer.write_rows(shown);
    }
}

// Writes the levels after the first, which has this size. `level` is the second, from averaged_from.
void write_levels(image::ExrWriter& writer, std::vector<float> level, int width, int height) {
    while (width > 1 || height > 1) {
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        writer.write_rows(maps_from(level));
        level = halved(level, width, height, map_channels.size());
    }
}

void write_maps(const vulkan::Device& device, const Request& request, const std::filesystem::path& folder,
                const MapFormat& format, const image::Advance& advance) {
    const std::vector<Png> pngs = pngs_of(format);
    std::vector<image::PngWriter> writers; // opened before the work begins, to fail early
    for (const Png& png : pngs)
        writers.emplace_back(png_path(folder, png), request.width, request.height,
                             static_cast<int>(png.channels.size()), png.bits);
    const bool terrain = request.kind == Kind::terrain;
    const double metres = format.metres.value_or(terrain && request.extent > 0 ? request.extent : 1);
    image::ExrWriter exr(folder / exr_name, header_of(device, request, format, metres));
    image::OutputFile materialx(folder / materialx_name);
    image::OutputFile gltf(folder / gltf_name);
    image::OutputFile json(folder / summary_name);

    Heights heights(request);
    std::vector<float> level; // the second of a texture
    const auto width = static_cast<std::size_t>(request.width);
    draw_maps(device, request, metres, heights, advance, [&](std::span<const float> rows, int y) {
        exr.write_rows(rows);
        for (std::size_t k = 0; k < pngs.size(); ++k)
            if (!shows_heights(pngs[k]))
                writers[k].write_rows(shown_rows(pngs[k], rows, width, static_cast<std::size_t>(y)));
        if (format.texture) {
            const auto count = static_cast<int>(rows.size() / (width * map_channels.size()));
            const auto half = halved(averaged_from(rows), request.width, count, map_channels.size());
            level.insert(level.end(), half.begin(), half.end());
        }
    });
    const auto [low, high] = heights.range();
    for (std::size_t k = 0; k < pngs.size(); ++k)
        if (shows_heights(pngs[k]))
            write_heights(writers[k], heights, request.height, low, high);
    if (format.texture)
        write_levels(exr, std::move(level), request.width, request.height);
    // Heights are span * (shown - midlevel): Blender's Strength or Scale, and Midlevel.
    const float span = high > low ? high - low : 1;
    const float midlevel = (high > low ? 0 : flat_grey) - low / span;
    std::string name = terrain ? "terrain" : request.material;
    std::ranges::replace(name, '-', '_'); // as MaterialX requires
    const auto filled = [&](std::string_view text) {
        return fmt::format(fmt::runtime(text), fmt::arg("name", name), fmt::arg("version", GABOR_VERSION),
                           fmt::arg("low", low), fmt::arg("high", high), fmt::arg("span", span),
                           fmt::arg("midlevel", midlevel), fmt::arg("width", metres),
                           fmt::arg("height", metres * request.height / request.width),
                           fmt::arg("columns", request.width), fmt::arg("rows", request.height),
                           fmt::arg("tileable", request.view.tileable));
    };
    materialx.write(filled(materialx_template));
    gltf.write(filled(gltf_template));
    json.write(filled(json_template));
    for (image::PngWriter& writer : writers)
        writer.commit();
    exr.commit();
    materialx.commit();
    gltf.commit();
    json.commit();
}

} // namespace

bool has_maps(const Request& request) {
    return is_surface(request.kind) && request.view.projection == Projection::flat;
}

void check_maps(const Request& request) {
    if (!has_maps(request))
        throw RequestError(
            "maps require either --view terrain or a material in --view flat, such as --material wood");
}

void set_side(Request& request, int side) {
    request.scale *= static_cast<double>(side) / std::min(request.width, request.height);
    request.width = request.height = side;
}

void make_tile(Request& request) {
    request.view.tileable = request.view.projection == Projection::flat;
    if (const double least = least_tile(request); least > 0)
        request.scale = std::min(request.scale, std::min(request.width, request.height) / least);
}

std::vector<std::filesystem::path> map_paths(const std::filesystem::path& folder, const MapFormat& format) {
    std::vector<std::filesystem::path> paths;
    for (const Png& png : pngs_of(format))
        paths.push_back(png_path(folder, png));
    for (const char* name : {exr_name, materialx_name, gltf_name, summary_name})
        paths.push_back(folder / name);
    return paths;
}

void render_maps(const vulkan::Device& device, const Request& request, const std::filesystem::path& folder,
                 const MapFormat& format, const image::Advance& advance) {
    check_maps(request);
    if (std::max(request.width, request.height) > most_map_side)
        throw RequestError(fmt::format("maps of {} x {} pixels are too large: at most {} x {} are supported",
                                       request.width, request.height, most_map_side, most_map_side));
    const image::OutputFolder created(folder);
    write_maps(device, request, folder, format, advance);
}

} // namespace gabor::render
