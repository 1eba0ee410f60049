#include "viewer/export.hpp"

#include "render/parameters.hpp"
#include "render/texture.hpp"
#include "viewer/show.hpp"

#include <fmt/format.h>

#include <chrono>

namespace gabor::viewer {

namespace {

struct Cancelled {};

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
    }
    return files;
}

render::Request exported(const Document& document, ExportAs as) {
    render::Request request = with_output(document.request, document.output);
    request.filter |= as == ExportAs::texture; // whose levels are seen through it
    return request;
}

Exporter::~Exporter() {
    cancelled_ = true;
    if (thread_.joinable())
        thread_.join();
}

void Exporter::start(const Document& document, const ExportTarget& target) {
    Work work{document, target, exported(document, target.as)};
    render::check(work.request);
    if (target.as == ExportAs::texture)
        render::check_texture(work.request, whole(work.request));
    if (thread_.joinable())
        thread_.join();
    cancelled_ = false;
    done_ = 0;
    written_.clear();
    failed_ = false;
    const auto pixels =
        static_cast<std::uint64_t>(work.request.width) * static_cast<std::uint64_t>(work.request.height);
    total_ = target.as == ExportAs::texture  ? render::texture_pixels(pixels)
             : target.as == ExportAs::frames ? pixels * static_cast<std::uint64_t>(target.frames)
                                             : pixels;
    running_ = true;
    thread_ = std::thread([this, work = std::move(work)] {
        try {
            result_ = run(work);
        } catch (const Cancelled&) {
            result_ = written_.empty() ? "cancelled; no file was written"
                                       : fmt::format("cancelled after {} files", written_.size());
        } catch (const std::exception& error) {
            result_ = error.what();
            failed_ = true;
        }
        running_ = false;
    });
}

std::string Exporter::run(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    const vulkan::Device device(selector_);
    const render::Request& request = work.request;
    const auto advance = [this](std::uint64_t pixels) {
        if (cancelled_)
            throw Cancelled();
        done_ += pixels;
    };
    std::optional<FileColours> colours;
    const std::vector<render::Files> all = files_of(work.target);
    const auto frames = static_cast<int>(all.size());
    for (int frame = 0; frame < frames; ++frame) {
        render::Files files = all[static_cast<std::size_t>(frame)];
        if (files.png && !shows_plainly(work.document)) {
            if (!colours)
                colours.emplace(device, work.document, render::channels(request));
            files.colours = [&](std::span<const float> values) { return colours->of(values); };
        }
        if (work.target.as == ExportAs::texture)
            render::render_texture(device, request, whole(request), *files.exr, {.half = work.target.half},
                                   advance);
        else
            render::render_file(device, render::frame_of(request, frame, frames), whole(request), files,
                                advance);
        for (const std::optional<std::filesystem::path>& path : {files.exr, files.png})
            if (path)
                written_[std::filesystem::absolute(*path)] = file_stamp(*path);
    }
    const std::string which =
        frames > 1 ? fmt::format("{} to {}", all.front().exr->string(), all.back().exr->string())
                   : all.front().exr->string();
    return fmt::format("{}: {}{} x {} pixels in {:.2f} s", which,
                       work.target.as == ExportAs::texture ? "a texture of " : "", request.width,
                       request.height,
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

double Exporter::progress() const {
    return static_cast<double>(done_) / static_cast<double>(total_);
}

} // namespace gabor::viewer
