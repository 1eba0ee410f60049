#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "render/bands.hpp"
#include "render/picture.hpp"
#include "vulkan/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace gabor::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_frames = 9999;
constexpr std::string_view frames_accepted = "a whole number from 1 to 9999";

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// The options as given; what is absent comes from --like, or else from Picture's defaults.
struct RenderOptions {
    std::optional<std::string> size;
    std::optional<std::string> scale;
    std::optional<std::string> frequency;
    std::optional<std::string> orientation;
    std::optional<std::string> seed;
    std::optional<std::string> recipe;
    std::optional<std::string> time;
    std::optional<std::string> region;
    std::optional<std::string> like;
    std::optional<std::string> png;
    std::string output;
    std::string compression =
        "none"; // noise hardly compresses: zip saves a fortieth and takes ten times as long
    std::string device;
    std::optional<std::string> frames;
    bool tileable = false;
    bool quadrature = false;
    bool gradient = false;
    bool verbose = false;
};

struct Request {
    render::Picture picture;
    image::Window region;
};

Request make_request(const RenderOptions& options) {
    Request request;
    render::Picture& picture = request.picture;
    std::optional<image::Window> region;
    if (options.like) {
        const image::ExrReader file(*options.like);
        if (file.parameters().empty())
            throw RequestError(fmt::format(
                "--like '{}' has no 'gabor' attribute: it takes an EXR that gabor rendered", *options.like));
        try {
            picture = render::from_json(file.parameters());
        } catch (const RequestError& error) {
            throw RequestError(fmt::format("--like '{}': {}", *options.like, error.what()));
        }
        if (!options.size)
            region = file.window();
    }
    if (options.size) {
        const auto [width, height] =
            parse_integers<2>("--size", *options.size, 'x',
                              fmt::format("WIDTHxHEIGHT, each from 1 to {}", render::largest_side));
        picture.width = width;
        picture.height = height;
    }
    if (options.scale)
        picture.scale = parse_number<double>("--scale", *options.scale, "a number, pixels per kernel radius");
    if (options.frequency)
        picture.frequency =
            parse_number<double>("--frequency", *options.frequency, "a number, cycles per kernel radius");
    if (options.orientation)
        picture.orientation =
            parse_number<double>("--orientation", *options.orientation, "a number, degrees");
    if (options.seed)
        picture.seed =
            parse_number<std::uint32_t>("--seed", *options.seed, "a whole number from 0 to 4294967295");
    if (options.recipe)
        picture.recipe = *options.recipe;
    if (options.time)
        picture.time = parse_number<double>("--time", *options.time, "a number, periods of the animation");
    picture.tileable |= options.tileable;
    picture.quadrature |= options.quadrature;
    picture.gradient |= options.gradient;
    render::check(picture);

    if (options.region) {
        const auto [x, y, width, height] =
            parse_integers<4>("--region", *options.region, ',',
                              "X,Y,WIDTH,HEIGHT in pixels from the picture's upper left corner");
        region = image::Window{x, y, width, height};
    }
    request.region = region.value_or(image::Window{0, 0, picture.width, picture.height});
    const image::Window& r = request.region;
    if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.width > picture.width - r.x ||
        r.height > picture.height - r.y)
        throw RequestError(
            fmt::format("{} {},{},{},{} is not within the picture of {} x {} pixels",
                        options.region ? "--region" : fmt::format("--like '{}': its region", *options.like),
                        r.x, r.y, r.width, r.height, picture.width, picture.height));
    return request;
}

void warn_above_nyquist(const render::Picture& picture) {
    const double radians = picture.orientation * std::numbers::pi / 180;
    const double highest = picture.frequency *
                           std::max(std::abs(std::cos(radians)), std::abs(std::sin(radians))) / picture.scale;
    if (highest > 0.5)
        fmt::print(stderr,
                   "gabor: warning: the frequency is {:.3g} cycles per pixel, above the picture's limit of "
                   "0.5: it shows as a lower one\n",
                   highest);
}

// Also for files that are still to be made, and however they are written.
bool same_file(const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path here = fs::current_path();
    return fs::weakly_canonical(here / a, ignored) == fs::weakly_canonical(here / b, ignored);
}

// Where the time of rendering files went, in seconds.
struct FileTimes {
    render::Times rendering;
    double writing = 0;
    double closing = 0;

    void operator+=(const FileTimes& other) {
        rendering.waiting += other.rendering.waiting;
        rendering.gpu += other.rendering.gpu;
        writing += other.writing;
        closing += other.closing;
    }
};

FileTimes render_file(const vulkan::Device& device, const render::Picture& picture,
                      const image::Window& region, const std::filesystem::path& output,
                      const std::optional<std::filesystem::path>& shown_as, std::string_view compression,
                      Progress& progress) {
    const std::vector<std::string> channels = render::channels(picture);
    image::ExrWriter exr(output, {.picture = {0, 0, picture.width, picture.height},
                                  .window = region,
                                  .channels = channels,
                                  .compression = compression,
                                  .parameters = render::to_json(picture)});
    std::optional<image::PngWriter> png;
    if (shown_as)
        png.emplace(*shown_as, region.width, region.height, 1);

    FileTimes times;
    std::vector<float> shown;
    times.rendering = render::render_bands(device, picture, region, [&](std::span<const float> values) {
        check_interrupt();
        const Clock::time_point before = Clock::now();
        exr.write_rows(values);
        if (png) {
            shown.clear();
            for (std::size_t i = 0; i < values.size(); i += channels.size())
                shown.push_back(0.5f + 0.25f * values[i]);
            png->write_rows(shown);
        }
        times.writing += seconds_since(before);
        progress.advance(values.size() / channels.size());
    });
    check_interrupt();
    const Clock::time_point before = Clock::now();
    exr.commit();
    if (png)
        png->commit();
    times.closing = seconds_since(before);
    return times;
}

// name.exr becomes name.0001.exr for the first of several frames.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames) {
    if (frames == 1)
        return path;
    return path.parent_path() /
           fmt::format("{}.{:04}{}", path.stem().string(), frame + 1, path.extension().string());
}

void print_times(const FileTimes& times, const vulkan::Device& device, double pixels, double device_ready,
                 double wall) {
    const double gpu = times.rendering.gpu;
    fmt::print("  driver                  {}\n", device.info().driver);
    fmt::print("  start to first dispatch {:8.3f} s\n", device_ready + times.rendering.first_dispatch);
    fmt::print("  GPU                     {:8.3f} s, {:.2f} ns per pixel\n", gpu, gpu / pixels * 1e9);
    fmt::print("  compression and writing {:8.3f} s, then {:.3f} s until on the disk\n", times.writing,
               times.closing);
    fmt::print("  everything              {:8.3f} s\n", wall);
    fmt::print("  host overhead           {:8.3f} s\n",
               wall - times.rendering.waiting - times.writing - times.closing);
    fmt::print("  resident memory         {:8} MiB at most\n", peak_memory() >> 20);
}

void render_picture(const RenderOptions& options, Clock::time_point start) {
    note_interrupts();
    const Request request = make_request(options);
    const image::Window& region = request.region;
    if (options.png && same_file(*options.png, options.output))
        throw RequestError(
            fmt::format("--png and -o both name '{}': they take two different files", options.output));
    const int frames = options.frames ? parse_number<int>("--frames", *options.frames, frames_accepted) : 1;
    if (frames < 1 || frames > most_frames)
        throw RequestError(fmt::format("--frames '{}': it takes {}", frames, frames_accepted));
    warn_above_nyquist(request.picture);

    const vulkan::Device device(options.device);
    const double device_ready = seconds_since(start);
    const auto pixels = static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height) *
                        static_cast<std::uint64_t>(frames);
    std::optional<Progress> progress(std::in_place, "rendering", pixels);
    FileTimes total;
    for (int frame = 0; frame < frames; ++frame) {
        render::Picture picture = request.picture;
        picture.time += static_cast<double>(frame) / frames;
        const std::filesystem::path output = frame_path(options.output, frame, frames);
        std::optional<std::filesystem::path> png;
        if (options.png)
            png = frame_path(*options.png, frame, frames);
        const FileTimes times =
            render_file(device, picture, region, output, png, options.compression, *progress);
        if (frame == 0)
            total.rendering.first_dispatch = times.rendering.first_dispatch;
        total += times;
        if (frame + 1 == frames)
            progress.reset();
        fmt::print("{}: {} x {} pixels, recipe {}, on {}\n", output.string(), region.width, region.height,
                   picture.recipe, device.info().name);
    }
    if (options.verbose)
        print_times(total, device, static_cast<double>(pixels), device_ready, seconds_since(start));
}

} // namespace

void add_render_command(CLI::App& app) {
    const Clock::time_point start = Clock::now();
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Render the noise to an OpenEXR file");
    const render::Picture defaults;

    std::vector<std::string> recipes;
    for (const noise::Recipe& recipe : noise::recipes())
        recipes.push_back(fmt::format("{} ({})", recipe.name, recipe.is));

    command
        ->add_option("-o,--output", options->output,
                     "The EXR to write: one 32-bit float channel Y, variance 1")
        ->required();
    command->add_option("--size", options->size,
                        fmt::format("WIDTHxHEIGHT in pixels, up to {0} x {0} [{1}x{2}]", render::largest_side,
                                    defaults.width, defaults.height));
    command->add_option("--scale", options->scale,
                        fmt::format("Pixels per kernel radius, {} to {} [{}]", render::smallest_scale,
                                    render::largest_scale, defaults.scale));
    command->add_option("--frequency", options->frequency,
                        fmt::format("Cycles per kernel radius, {} to {} [{}]", render::smallest_frequency,
                                    render::largest_frequency, defaults.frequency));
    command->add_option(
        "--orientation", options->orientation,
        fmt::format("Direction of the waves in degrees, from right towards down [{}]", defaults.orientation));
    command->add_option("--seed", options->seed,
                        fmt::format("Which instance of the noise, 0 to 4294967295 [{}]", defaults.seed));
    command->add_option(
        "--recipe", options->recipe,
        fmt::format("How quality is bought: {} [{}]", fmt::join(recipes, "; "), defaults.recipe));
    command->add_flag("--tileable", options->tileable,
                      "Let the picture continue from each edge at the opposite one");
    command->add_option(
        "--time", options->time,
        fmt::format("Moment of an animation in place that repeats when this goes by 1 [{}]", defaults.time));
    command->add_option(
        "--frames", options->frames,
        fmt::format("Render one period of that animation as NAME.0001.exr and on: {}", frames_accepted));
    command->add_flag("--quadrature", options->quadrature, "Add a channel `quadrature`: cosines for sines");
    command->add_flag(
        "--gradient", options->gradient,
        "Add channels `gradient.x` and `gradient.y`: derivatives to the right and down, per kernel radius");
    command->add_option("--region", options->region,
                        "X,Y,WIDTH,HEIGHT: only this part, with exactly the pixels that the whole has there "
                        "on the same driver");
    command->add_option("--like", options->like,
                        "Take what is not given from the header of an EXR rendered before");
    command->add_option("--png", options->png,
                        "Also write a PNG to look at: mean 0.5, two standard deviations to the ends");
    command->add_option("--compression", options->compression,
                        fmt::format("Compression of the EXR: {} [{}]",
                                    fmt::join(image::compression_names(), ", "), options->compression));
    command->add_option("--device", options->device,
                        "Vulkan device: its index, or a part of its name [the fastest kind]");
    command->add_flag("--verbose", options->verbose, "Also print where time and memory went");
    command->callback([options, start] { render_picture(*options, start); });
}

} // namespace gabor::cli
