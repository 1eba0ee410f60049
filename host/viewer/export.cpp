#include "viewer/export.hpp"

#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/png.hpp"
#include "render/output/texture.hpp"
#include "render/request/parameters.hpp"
#include "seconds.hpp"
#include "system/desktop.hpp"
#include "viewer/display.hpp"
#include "viewer/drawing.hpp"

#include <fmt/format.h>

namespace gabor::viewer {

namespace {

image::Rect whole(const render::Request& request) {
    return {0, 0, request.width, request.height};
}

// A map of a noise, and the document that draws it.
struct NoiseMap {
    const char* name;
    Document shown;
    bool normals = false;
    int channels = 3;
    int bits = 8;
};

// Noise fitted to a colour photograph has a colour but no height.
std::vector<NoiseMap> noise_maps(const Document& document, bool coloured) {
    const bool stripes = document.output == Output::phasor || document.output == Output::lit_phasor;
    std::vector<NoiseMap> maps{{"base_color.png", document}};
    if (coloured || is_lit(document) || shows_normals(document))
        maps[0].shown.output = stripes && !coloured ? Output::phasor : Output::value;
    if (coloured)
        return maps;
    maps.push_back({"normal.png", document, true, 3, 16});
    maps.push_back({"height.png", document, false, 1, 16});
    maps[1].shown.output = stripes ? Output::lit_phasor : Output::lit;
    maps[2].shown.output = stripes ? Output::phasor : Output::value;
    maps[2].shown.colours = 0;
    return maps;
}

} // namespace

std::string path_from_home(const std::filesystem::path& path) {
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    const std::filesystem::path below = whole.lexically_relative(system::home_folder());
    const bool is_below = !below.empty() && *below.begin() != ".." && *below.begin() != ".";
    return (is_below ? "~" / below : whole).string();
}

bool can_export_maps(const render::Request& request) {
    return render::has_maps(render::from_above(request)) ||
           (!render::is_surface(request.kind) && request.view.projection == render::Projection::flat);
}

ExportTarget ExportTarget::of(const Document& document) const {
    const render::Request& request = document.request;
    ExportTarget target = *this;
    const std::string name = std::filesystem::path(document.path).replace_extension().string() +
                             (document.photograph.empty() ? "" : "-noise"); // must not replace the photograph
    target.path = path.empty() ? name + ".exr" : path;
    target.folder = folder.empty() ? name : folder;
    target.of_noise = !render::is_surface(request.kind);
    target.coloured = request.colour.has_value();
    const bool maps = !target.of_noise && (request.kind == render::Kind::material || request.view.is_flat());
    target.as = chosen.value_or(maps ? ExportAs::maps : ExportAs::picture);
    if (target.as == ExportAs::maps && !can_export_maps(request))
        target.as = ExportAs::picture;
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
    }
    return files;
}

std::vector<std::filesystem::path> paths_of(const ExportTarget& target) {
    std::vector<std::filesystem::path> paths;
    if (target.as == ExportAs::maps && !target.of_noise)
        return render::map_paths(target.folder, {.directx = target.directx});
    if (target.as == ExportAs::maps) {
        for (const NoiseMap& map : noise_maps({}, target.coloured))
            paths.push_back(std::filesystem::path(target.folder) / map.name);
        return paths;
    }
    for (const render::Files& files : files_of(target))
        for (const std::optional<std::filesystem::path>& path : {files.exr, files.png})
            if (path)
                paths.push_back(*path);
    return paths;
}

render::Request exported(const Document& document, const ExportTarget& target) {
    render::Request request = with_output(document.request, document.output);
    const bool maps = target.as == ExportAs::maps;
    if (maps) {
        request = render::from_above(request);
        render::set_side(request, target.map_side);
        if (target.tileable)
            render::make_tile(request);
    }
    request.filter |= target.as == ExportAs::texture || (maps && request.kind == render::Kind::material);
    return request;
}

void Exporter::start(const Document& document, const ExportTarget& target) {
    const render::Request request = exported(document, target);
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
                            : fmt::format("cancelled; {} finished files were kept", written_.size());
}

void Exporter::write_noise_maps(const vulkan::Device& device, const Document& document,
                                const ExportTarget& target,
                                const std::function<void(std::uint64_t)>& advance) const {
    const std::filesystem::path folder = target.folder;
    const image::OutputFolder created(folder);
    auto maps = noise_maps(document, document.request.colour.has_value());
    std::vector<image::PngWriter> writers; // opened before the work begins, to fail early
    for (const NoiseMap& map : maps)
        writers.emplace_back(folder / map.name, target.map_side, target.map_side, map.channels, map.bits);
    for (std::size_t i = 0; i < maps.size(); ++i) {
        NoiseMap& map = maps[i];
        const render::Request& request = map.shown.request = exported(map.shown, target);
        FileColours colours(device, map.shown, render::channels(request), map.normals);
        render::render_region(device, request, whole(request), [&](std::span<const float> values) {
            const std::span<const float> shown = colours.of(values);
            advance(shown.size() / 3);
            std::vector<float> row;
            for (std::size_t at = 0; at < shown.size(); at += map.channels == 1 ? 3 : 1)
                row.push_back(shown[at]);
            writers[i].write_rows(row);
        });
    }
    for (image::PngWriter& writer : writers)
        writer.commit();
}

void Exporter::run(const Document& document, const ExportTarget& target, const render::Request& request) {
    const Clock::time_point start = Clock::now();
    const vulkan::Device device(selector_);
    const std::vector<render::Files> all = files_of(target);
    const auto frames = static_cast<int>(all.size());
    const auto picture =
        static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height);
    const std::uint64_t total = target.as == ExportAs::texture ? render::texture_pixels(picture)
                                : target.as == ExportAs::maps && target.of_noise
                                    ? picture * noise_maps(document, target.coloured).size()
                                    : picture * all.size();
    std::uint64_t done = 0;
    const auto advance = [&](std::uint64_t pixels) {
        done += pixels;
        work_.advance(static_cast<double>(done) / static_cast<double>(total));
    };
    if (const std::filesystem::path folder = target.folder;
        target.as == ExportAs::maps && folder.has_parent_path())
        std::filesystem::create_directories(folder.parent_path());
    if (target.as == ExportAs::maps && target.of_noise) {
        write_noise_maps(device, document, target, advance);
    } else if (target.as == ExportAs::maps) {
        render::render_maps(
            device, request, target.folder,
            {.directx = target.directx,
             .metres = request.kind == render::Kind::terrain ? std::nullopt : std::optional(target.metres)},
            advance);
    } else if (target.as == ExportAs::texture) {
        render::render_texture(device, request, whole(request), *all.front().exr, target.half, advance);
    } else {
        std::optional<FileColours> colours;
        for (int frame = 0; frame < frames; ++frame) {
            render::Files files = all[static_cast<std::size_t>(frame)];
            if (files.png && !shows_plainly(document)) {
                files.normals = drawing_of(document).normals;
                if (!colours)
                    colours.emplace(device, document, render::channels(request, files.normals));
                files.colours = [&](std::span<const float> values) { return colours->of(values); };
            }
            render::render_file(device, render::frame_of(request, frame, frames), whole(request), files,
                                advance);
            for (const std::optional<std::filesystem::path>& path : {files.exr, files.png})
                if (path)
                    written_[std::filesystem::absolute(*path)] = file_stamp(*path);
        }
    }
    for (const std::filesystem::path& path : paths_of(target))
        written_[std::filesystem::absolute(path)] = file_stamp(path);
    const std::string size =
        fmt::format("{} x {} pixels in {:.2f} s", request.width, request.height, seconds_since(start));
    if (target.as == ExportAs::maps)
        result_ = target.of_noise && target.coloured
                      ? fmt::format("wrote {}: {}; a photograph's noise has no height",
                                    path_from_home(paths_of(target).front()), size)
                      : fmt::format("wrote maps to the folder {}: {}", path_from_home(target.folder), size);
    else if (target.as == ExportAs::texture)
        result_ = fmt::format("wrote the texture {}: {}", path_from_home(target.path), size);
    else
        result_ = fmt::format("wrote {}{}: {}", path_from_home(*all.front().exr),
                              frames > 1 ? " to " + all.back().exr->filename().string() : "", size);
}

} // namespace gabor::viewer
