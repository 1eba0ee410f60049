#include "cli/request.hpp"

#include "render/output/file.hpp"
#include "render/request/load.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace gabor::cli {

namespace {

// Returns the parameters that the options set, including --size.
render::Values values_of(const RequestOptions& options) {
    render::Values values = given_values(options.parameters);
    if (options.size) {
        const render::Parameter& width = render::parameter("width");
        const auto sides = parse_size(*options.size, static_cast<int>(width.range.high));
        values.emplace_back(&width, static_cast<double>(sides[0]));
        values.emplace_back(&render::parameter("height"), static_cast<double>(sides[1]));
    }
    return values;
}

} // namespace

Asked asked_by(const RequestOptions& options) {
    Asked asked;
    if (options.preset && options.like)
        throw RequestError(
            "--preset and --like cannot be combined: each sets all options that are not given");
    if (options.preset)
        asked.request = render::preset(*options.preset);
    if (options.like) {
        render::Loaded like = with_prefix("--like: ", [&] { return render::load_request(*options.like); });
        asked.request = std::move(like.request);
        if (!options.size)
            asked.like_region = like.region;
    }
    asked.side = std::min(asked.request.width, asked.request.height);
    render::set(asked.request, values_of(options), render::option_name);
    asked.scaled = options.preset || options.like || is_given(options.parameters, "scale");
    if (asked.request.kind == render::Kind::terrain && !asked.scaled)
        asked.request.scale = std::max(asked.request.width / 8.0, render::parameter("scale").range.low);
    return asked;
}

image::Rect Asked::region(const RequestOptions& options) const {
    const image::Rect region = options.region
                                   ? parse_region(*options.region)
                                   : like_region.value_or(image::Rect{0, 0, request.width, request.height});
    check_within(region, request.width, request.height,
                 options.region ? "--region"
                                : fmt::format("--like '{}': its region", options.like.value_or("")),
                 "picture");
    return region;
}

void add_source_options(CLI::App& command, RequestOptions& options, double most, std::string_view size) {
    add_option(command, "--size", options.size, "WIDTHxHEIGHT",
               fmt::format("Size of the picture in pixels, up to {0} x {0} [{1}]", most, size));
    add_option(command, "--preset", options.preset, "NAME",
               fmt::format("Take all other options from a preset: {}, or a file NAME.json from gabor fit",
                           fmt::join(render::preset_names(), ", ")));
    add_option(command, "--like", options.like, "FILE",
               "Take all other options from an earlier EXR or a JSON file");
}

void add_region_option(CLI::App& command, RequestOptions& options) {
    add_option(command, "--region", options.region, "X,Y,WIDTH,HEIGHT",
               "Render only this part of the picture; its pixels equal those of a full render [all of it]");
}

void add_group(CLI::App& command, RequestOptions& options, const std::string& title,
               render::Parameter::Group group, bool (*offers)(const render::Parameter&)) {
    begin_group(command, title);
    for (const render::Parameter& p : render::parameters())
        if (p.group == group && (!offers || offers(p)))
            add_parameter(command, options.parameters, p, {});
}

void add_frames_option(CLI::App& command, std::optional<std::string>& frames) {
    add_option(
        command, "--frames", frames, "NUMBER",
        fmt::format("Render one period of the animation, or one loop of a sea, in this many frames, from 1 "
                    "to {}: NAME.0001.exr, NAME.0002.exr ... Frames of an endless sea are 1/25 s apart [1]",
                    render::most_frames));
}

int frames_of(const std::optional<std::string>& frames) {
    return frames ? parse_integer("--frames", *frames, 1, render::most_frames) : 1;
}

std::string subject(const render::Request& request) {
    using render::Kind;
    return request.kind == Kind::terrain    ? "terrain"
           : request.kind == Kind::sea      ? "ocean"
           : request.kind == Kind::material ? "material " + request.material
           : request.kind == Kind::fractal
               ? fmt::format("fractal {}",
                             render::fractal_shapes.at(static_cast<std::size_t>(request.fractal.shape)))
               : fmt::format("recipe {}", render::drawing_recipe(request).name);
}

} // namespace gabor::cli
