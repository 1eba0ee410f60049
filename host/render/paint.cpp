#include "render/paint.hpp"

#include "error.hpp"
#include "image/exr.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gabor::render {

Paint read_paint(const std::string& path) {
    if (path.empty())
        return {};
    constexpr std::size_t most = std::size_t{1} << 24;
    const auto read = [&](const char* channel) {
        image::ExrReader file(path, channel);
        const auto width = static_cast<std::size_t>(file.window().width);
        const auto height = static_cast<std::size_t>(file.window().height);
        if (width * height > most)
            throw RequestError(fmt::format("paint '{}' has {} x {} pixels: it may have {} in all", path,
                                           width, height, most));
        std::vector<float> values;
        while (values.size() < width * height) {
            const std::span<const float> rows = file.read_rows(256);
            values.insert(values.end(), rows.begin(), rows.end());
        }
        for (const float value : values)
            if (!std::isfinite(value))
                throw RequestError(
                    fmt::format("paint '{}': a value of channel {} is not finite", path, channel));
        return std::pair(values, file.window());
    };
    const auto [frequencies, window] = read("frequency");
    const auto [orientations, same] = read("orientation");
    Paint paint{window.width, window.height, {}};
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        paint.samples.push_back(frequencies[i]);
        paint.samples.push_back(static_cast<float>(orientations[i] * std::numbers::pi / 180));
    }
    return paint;
}

} // namespace gabor::render
