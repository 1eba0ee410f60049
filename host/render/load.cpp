#include "render/load.hpp"

#include "error.hpp"
#include "render/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace gabor::render {

namespace {

// Limits the size, so that a wrong name cannot fill the memory.
std::string read_text(const std::string& path) {
    constexpr std::size_t most = 1 << 20;
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open())
        throw RequestError(
            fmt::format("cannot read '{}': {}; it takes a JSON file", path, std::strerror(errno)));
    std::string text(most + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad() || text.empty() || text.size() > most)
        throw RequestError(fmt::format("cannot read '{}': it takes a JSON file of at most 1 MiB", path));
    return text;
}

} // namespace

Loaded load_request(const std::string& path) {
    if (path.ends_with(".json")) {
        const std::string text = read_text(path);
        return {with_prefix(fmt::format("'{}': ", path), [&] { return from_json(text); }), {}, text};
    }
    const image::ExrReader file(path);
    if (file.parameters().empty())
        throw RequestError(fmt::format(
            "'{}' has no 'gabor' attribute: it takes an EXR that gabor rendered, or its JSON", path));
    return {with_prefix(fmt::format("'{}': ", path), [&] { return from_json(file.parameters()); }),
            file.window(), file.parameters()};
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
    const auto found = std::ranges::find(presets(), name, &Preset::name);
    if (found == presets().end())
        throw RequestError(fmt::format("unknown preset '{}': the presets are {}, and files NAME.json", name,
                                       fmt::join(preset_names(), ", ")));
    return from_json(found->json);
}

Paint load_paint(const std::string& path) {
    if (path.empty())
        return {};
    constexpr std::size_t most = std::size_t{1} << 24;
    image::ExrReader file(path, {"frequency", "orientation"});
    const image::Rect& window = file.window();
    const std::size_t samples =
        static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
    if (samples > most)
        throw RequestError(fmt::format("paint '{}' has {} x {} pixels: at most {} in all are accepted", path,
                                       window.width, window.height, most));
    const std::span<const float> values = file.read_rows(window.height);
    Paint paint{window.width, window.height, {values.begin(), values.end()}};
    for (std::size_t i = 0; i < paint.samples.size(); ++i) {
        if (!std::isfinite(paint.samples[i]))
            throw RequestError(
                fmt::format("paint '{}': a value of channel {} is not finite", path, file.channels()[i % 2]));
        if (i % 2 == 1)
            paint.samples[i] = static_cast<float>(noise::radians(double{paint.samples[i]}));
    }
    return paint;
}

} // namespace gabor::render
