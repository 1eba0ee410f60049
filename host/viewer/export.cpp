#include "viewer/export.hpp"

#include "render/parameters.hpp"
#include "render/texture.hpp"
#include "seconds.hpp"
#include "viewer/show.hpp"

#include <fmt/format.h>

#include <utility>

namespace gabor::viewer {

namespace {

image::Rect whole(const render::Request& request) {
    return {0, 0, request.width, request.height};
}

} // namespace

std::vector<render::Files> files_of(const ExportTarget& target) {
    const std::filesystem::path exr = target.path;
    const std::filesystem::path png = std::filesystem::path(exr).replace_extension(".png");
    const int frames = target.as == ExportAs::frames ? target.frames : 1;
    std::vector<render::Files> files;
    for (int frame = 0; frame < frames; ++frame) {
        render::Files& each = files.emplace_back();
        each.exr = render::frame_path(exr, frame, frames);
        if (target.png && target.as != ExportAs::texture)
            each.png = render::frame_path(png, frame, frames);
        if (target.heightmap && target.as == ExportAs::picture)
            each.heightmap = std::filesystem::path(exr).replace_extension(".heightmap.png");
    }
    return files;
}

render::Request exported(const Document& document, ExportAs as) {
    render::Request request = with_output(document.request, document.output);
    request.filter |= as == ExportAs::texture; // each level is filtered
    return request;
}

void Exporter::start(const Document& document, const ExportTarget& target) {
    const render::Request request = exported(document, target.as);
    render::check(request);
    if (target.as == ExportAs::texture)
        render::check_texture(request, whole(request));
    result_.clear();
    written_.clear();
    work_.start([=, this] { run(document, target, request); });
}

std::string Exporter::result() const {
    if (running())
        return {};
    if (!work_.was_cancelled())
        return failed() ? work_.error() : result_;
    return written_.empty() ? "cancelled; no file was written"
                            : fmt::format("cancelled after {} files", written_.size());
}

void Exporter::run(const Document& document, const ExportTarget& target, const render::Request& request) {
    const Clock::time_point start = Clock::now();
    const vulkan::Device device(selector_);
    const bool texture = target.as == ExportAs::texture;
    const std::vector<render::Files> all = files_of(target);
    const auto frames = static_cast<int>(all.size());
    const auto picture =
        static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height);
    const bool heightmap = target.heightmap && render::has_terrain(request);
    const std::uint64_t total =
        texture ? render::texture_pixels(picture) : picture * (all.size() + (heightmap ? 1 : 0));
    std::uint64_t done = 0;
    const auto advance = [&](std::uint64_t pixels) {
        done += pixels;
        work_.advance(static_cast<double>(done) / static_cast<double>(total));
    };
    std::optional<FileColours> colours;
    for (int frame = 0; frame < frames; ++frame) {
        render::Files files = all[static_cast<std::size_t>(frame)];
        if (!render::has_terrain(request))
            files.heightmap.reset();
        const render::Files heights{.exr = {}, .png = {}, .heightmap = std::exchange(files.heightmap, {})};
        if (files.png && !shows_plainly(document)) {
            if (!colours)
                colours.emplace(device, document, render::channels(request));
            files.colours = [&](std::span<const float> values) { return colours->of(values); };
        }
        if (texture)
            render::render_texture(device, request, whole(request), *files.exr, {.half = target.half},
                                   advance);
        else
            render::render_file(device, render::frame_of(request, frame, frames), whole(request), files,
                                advance);
        if (heights.heightmap) {
            render::Request above = request;
            std::get<render::Terrain>(above.view).perspective = false;
            render::render_file(device, above, whole(above), heights, advance);
        }
        for (const std::optional<std::filesystem::path>& path : {files.exr, files.png, heights.heightmap})
            if (path)
                written_[std::filesystem::absolute(*path)] = file_stamp(*path);
    }
    std::string names = all.front().exr->string();
    if (frames > 1)
        names += " to " + all.back().exr->string();
    result_ = fmt::format("{}: {}{} x {} pixels in {:.2f} s", names, texture ? "a texture of " : "",
                          request.width, request.height, seconds_since(start));
}

} // namespace gabor::viewer
