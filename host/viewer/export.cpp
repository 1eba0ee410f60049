#include "viewer/export.hpp"

#include "render/parameters.hpp"
#include "viewer/show.hpp"

#include <fmt/format.h>

#include <chrono>

namespace gabor::viewer {

namespace {

struct Cancelled {};

} // namespace

Exporter::~Exporter() {
    cancelled_ = true;
    if (thread_.joinable())
        thread_.join();
}

void Exporter::start(const Document& document, Shaders shaders, const std::filesystem::path& exr,
                     const std::optional<std::filesystem::path>& png) {
    const render::Request request = exported(document);
    render::check(request);
    if (thread_.joinable())
        thread_.join();
    cancelled_ = false;
    done_ = 0;
    written_.clear();
    failed_ = false;
    total_ = static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height);
    running_ = true;
    thread_ = std::thread([this, document, request, shaders = std::move(shaders), exr, png] {
        const auto start = std::chrono::steady_clock::now();
        try {
            const vulkan::Device device(selector_);
            render::Files files{.exr = exr, .png = png, .code = shaders.pass};
            std::optional<FileColours> colours;
            if (png && !shows_plainly(document)) {
                colours.emplace(device, shaders.colours, document, render::channels(request));
                files.colours = [&](std::span<const float> values) { return colours->of(values); };
            }
            render::render_file(device, request, {0, 0, request.width, request.height}, files,
                                [this](std::uint64_t pixels) {
                                    if (cancelled_)
                                        throw Cancelled();
                                    done_ += pixels;
                                });
            for (const std::optional<std::filesystem::path>& path : {std::optional(exr), png})
                if (path)
                    written_[std::filesystem::absolute(*path)] = file_stamp(*path);
            result_ =
                fmt::format("{}: {} x {} pixels in {:.2f} s", exr.string(), request.width, request.height,
                            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        } catch (const Cancelled&) {
            result_ = "cancelled; no file was written";
        } catch (const std::exception& error) {
            result_ = error.what();
            failed_ = true;
        }
        running_ = false;
    });
}

double Exporter::progress() const {
    return static_cast<double>(done_) / static_cast<double>(total_);
}

} // namespace gabor::viewer
