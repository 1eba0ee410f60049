#include "viewer/export.hpp"

#include "image/exr.hpp"
#include "render/maps.hpp"
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

ExportTarget ExportTarget::of(const render::Request& request) const {
    ExportTarget target = *this;
    if (as == ExportAs::maps && !render::has_maps(render::from_above(request)))
        target.as = ExportAs::picture;
    target.heightmap &= render::has_terrain(request) && target.as == ExportAs::picture;
    return target;
}

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
        if (target.heightmap)
            each.heightmap = std::filesystem::path(exr).replace_extension(".heightmap.png");
        each.compression = image::compression_names()[target.compression];
    }
    return files;
}

std::vector<std::filesystem::path> paths_of(const ExportTarget& target) {
    if (target.as == ExportAs::maps)
        return render::map_paths(target.folder, {.directx = target.directx});
    std::vector<std::filesystem::path> paths;
    for (const render::Files& files : files_of(target))
        for (const std::optional<std::filesystem::path>& path : {files.exr, files.png, files.heightmap})
            if (path)
                paths.push_back(*path);
    return paths;
}

render::Request exported(const Document& document, ExportAs as) {
    render::Request request = with_output(document.request, document.output);
    if (as == ExportAs::maps)
        request = render::from_above(request);
    request.filter |= as == ExportAs::texture || (as == ExportAs::maps && !render::has_terrain(request));
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
    const std::vector<render::Files> all = files_of(target);
    const auto frames = static_cast<int>(all.size());
    const auto picture =
        static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height);
    const std::uint64_t total = target.as == ExportAs::texture
                                    ? render::texture_pixels(picture)
                                    : picture * (all.size() + (target.heightmap ? 1 : 0));
    std::uint64_t done = 0;
    const auto advance = [&](std::uint64_t pixels) {
        done += pixels;
        work_.advance(static_cast<double>(done) / static_cast<double>(total));
    };
    if (target.as == ExportAs::maps) {
        render::render_maps(device, request, target.folder, {.directx = target.directx}, advance);
    } else if (target.as == ExportAs::texture) {
        render::render_texture(device, request, whole(request), *all.front().exr,
                               {all.front().compression, target.half}, advance);
    } else {
        std::optional<FileColours> colours;
        for (int frame = 0; frame < frames; ++frame) {
            render::Files files = all[static_cast<std::size_t>(frame)];
            const render::Files heights{
                .exr = {}, .png = {}, .heightmap = std::exchange(files.heightmap, {})};
            if (files.png && !shows_plainly(document)) {
                if (!colours)
                    colours.emplace(device, document, render::channels(request));
                files.colours = [&](std::span<const float> values) { return colours->of(values); };
            }
            render::render_file(device, render::frame_of(request, frame, frames), whole(request), files,
                                advance);
            if (heights.heightmap) {
                const render::Request above = render::from_above(request);
                render::render_file(device, above, whole(above), heights, advance);
            }
            for (const std::optional<std::filesystem::path>& path : {files.exr, files.png, heights.heightmap})
                if (path)
                    written_[std::filesystem::absolute(*path)] = file_stamp(*path);
        }
    }
    for (const std::filesystem::path& path : paths_of(target))
        written_[std::filesystem::absolute(path)] = file_stamp(path);
    const std::string size =
        fmt::format("{} x {} pixels in {:.2f} s", request.width, request.height, seconds_since(start));
    if (target.as == ExportAs::maps)
        result_ = fmt::format("maps in {}: {}", target.folder, size);
    else if (target.as == ExportAs::texture)
        result_ = fmt::format("{}: a texture of {}", target.path, size);
    else
        result_ = fmt::format("{}{}: {}", all.front().exr->string(),
                              frames > 1 ? " to " + all.back().exr->string() : "", size);
}

} // namespace gabor::viewer
