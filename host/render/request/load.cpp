#include "render/request/load.hpp"

#include "error.hpp"
#include "image/picture.hpp"
#include "names.hpp"
#include "render/request/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

namespace gabor::render {

namespace {

// Limits the size, so that a huge file cannot fill the memory.
std::string read_text(const std::string& path) {
    constexpr std::size_t most = 1 << 20;
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open())
        throw RequestError(
            fmt::format("cannot read '{}': {}; expected a JSON file", path, std::strerror(errno)));
    std::string text(most + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad() || text.empty() || text.size() > most)
        throw RequestError(fmt::format("cannot read '{}': expected a JSON file of at most 1 MiB", path));
    return text;
}

void check_paint_size(const std::string& path, int width, int height) {
    constexpr std::size_t most = std::size_t{1} << 24;
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > most)
        throw RequestError(fmt::format("paint '{}' has {} x {} pixels: at most {} in total are accepted",
                                       path, width, height, most));
}

Paint load_directions(const std::string& path) {
    const std::unique_ptr<image::PictureReader> file = image::open_picture(path);
    const int width = file->format().width, height = file->format().height;
    check_paint_size(path, width, height);
    if (file->format().channels != 3)
        throw RequestError(fmt::format("paint '{}' is grey: expected a picture whose red and green encode "
                                       "directions, or an EXR with channels frequency and orientation",
                                       path));
    Paint paint{width, height, {}, true};
    std::vector<float> row(3 * static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        file->read_row(row);
        for (std::size_t i = 0; i < row.size(); i += 3) {
            const float along = std::atan2(row[i + 1] - 0.5f, row[i] - 0.5f);
            paint.samples.insert(paint.samples.end(), {1, along + std::numbers::pi_v<float> / 2});
        }
    }
    return paint;
}

} // namespace

Loaded load_request(const std::string& path) {
    Loaded loaded;
    if (path.ends_with(".json")) {
        loaded.json = read_text(path);
    } else {
        const image::ExrHeader file = image::ExrReader(path).header();
        loaded.json = file.parameters;
        loaded.region = file.window;
    }
    if (loaded.json.empty())
        throw RequestError(fmt::format(
            "'{}' has no 'gabor' attribute: expected an EXR that gabor rendered, or its JSON", path));
    loaded.request = with_prefix(fmt::format("'{}': ", path), [&] { return from_json(loaded.json); });
    return loaded;
}

std::vector<noise::Lobe> load_lobes(const std::string& path) {
    const std::string text = read_text(path);
    return with_prefix(fmt::format("'{}': ", path), [&] { return lobes_from_json(text); });
}

std::vector<std::string_view> preset_names() {
    std::vector<std::string_view> names;
    std::ranges::transform(presets(), std::back_inserter(names), &Preset::name);
    return names;
}

Request preset(std::string_view name) {
    if (name.ends_with(".json"))
        return load_request(std::string(name)).request;
    const std::vector<std::string_view> names = preset_names();
    const auto found = std::ranges::find(presets(), in_any_case(name, names), &Preset::name);
    if (found == presets().end())
        throw RequestError(fmt::format("unknown preset '{}': {}`gabor render --help` lists the presets; the "
                                       "name of a file ends in .json",
                                       name, did_you_mean(name, names)));
    return from_json(found->json);
}

bool has_only_directions(const std::string& path) {
    return !path.empty() && !path.ends_with(".exr");
}

Paint load_paint(const std::string& path) {
    if (path.empty())
        return {};
    if (has_only_directions(path))
        return load_directions(path);
    image::ExrReader file(path, {"frequency", "orientation"});
    const image::Rect& window = file.header().window;
    check_paint_size(path, window.width, window.height);
    const std::span<const float> values = file.read_rows(window.height);
    Paint paint{window.width, window.height, {values.begin(), values.end()}};
    for (std::size_t i = 0; i < paint.samples.size(); ++i) {
        if (!std::isfinite(paint.samples[i]))
            throw RequestError(fmt::format("paint '{}': a value of channel {} is not finite", path,
                                           file.header().channels[i % 2]));
        if (i % 2 == 1)
            paint.samples[i] = static_cast<float>(noise::radians(double{paint.samples[i]}));
    }
    return paint;
}

} // namespace gabor::render
