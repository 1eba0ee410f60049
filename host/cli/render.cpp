#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/terminal.hpp"
#include "render/file.hpp"
#include "render/likeness.hpp"
#include "render/presets.hpp"
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
    std::optional<std::string> preset;
    std::optional<std::string> lobes;
    std::optional<std::string> frequency_spread;
    std::optional<std::string> orientation_spread;
    std::optional<std::string> view;
    std::optional<std::string> paint;
    std::optional<std::string> values;
    std::optional<std::string> depth;
    bool solid = false;
    bool tileable = false;
    bool sum = false;
    bool filter = false;
    bool quadrature = false;
    bool gradient = false;
    bool phasor = false;
    bool verbose = false;
};

struct Request {
    render::Picture picture;
    image::Window region;
};

// Says of which option a wrong request speaks.
template <typename Read>
auto of_option(std::string_view option, Read read) {
    try {
        return read();
    } catch (const RequestError& error) {
        throw RequestError(fmt::format("{}: {}", option, error.what()));
    }
}

// Takes the spectrum's options. Lobes have frequencies and orientations of their own.
void take_spectrum(const RenderOptions& options, render::Picture& picture) {
    if (options.lobes)
        picture.lobes = of_option("--lobes", [&] { return render::read_lobes(*options.lobes); });
    const auto take = [&](std::string_view name, const std::optional<std::string>& text, double& value,
                          std::string_view accepted) {
        if (!text)
            return;
        if (!picture.lobes.empty())
            throw RequestError(fmt::format("{} with lobes: they have their own", name));
        value = parse_number<double>(name, *text, accepted);
    };
    take("--frequency", options.frequency, picture.frequency, "a number, cycles per kernel radius");
    take("--orientation", options.orientation, picture.orientation, "a number, degrees");
    take("--frequency-spread", options.frequency_spread, picture.frequency_spread,
         "a share of the frequency, 0 to 1");
    take("--orientation-spread", options.orientation_spread, picture.orientation_spread,
         "a number of degrees, 0 to 90");
}

Request make_request(const RenderOptions& options) {
    Request request;
    render::Picture& picture = request.picture;
    std::optional<image::Window> region;
    if (options.preset && options.like)
        throw RequestError("--preset and --like: one of them, for both say what is not given");
    if (options.preset)
        picture = render::from_json(render::find_preset(*options.preset).json);
    if (options.like) {
        const render::Likeness like =
            of_option("--like", [&] { return render::read_likeness(*options.like); });
        picture = like.picture;
        if (!options.size)
            region = like.region;
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
    take_spectrum(options, picture);
    if (options.seed)
        picture.seed =
            parse_number<std::uint32_t>("--seed", *options.seed, "a whole number from 0 to 4294967295");
    if (options.recipe)
        picture.recipe = *options.recipe;
    if (options.time)
        picture.time = parse_number<double>("--time", *options.time, "a number, periods of the animation");
    if (options.view)
        picture.view = *options.view;
    if (options.paint)
        picture.paint = *options.paint;
    if (options.values)
        picture.values = parse_number<int>("--values", *options.values, "a whole number from 1 to 4");
    if (options.depth)
        picture.depth = parse_number<double>("--depth", *options.depth, "a number, kernel radii");
    picture.solid |= options.solid;
    picture.tileable |= options.tileable;
    picture.sum |= options.sum;
    picture.filter |= options.filter;
    picture.phasor |= options.phasor;
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
    if (picture.filter || picture.view != "flat" || !picture.paint.empty())
        return;
    double highest = 0;
    for (const noise::Lobe& lobe : render::spectrum(picture)) {
        const double along = lobe.orientation_spread > 0 ? 1
                                                         : std::max(std::abs(std::cos(lobe.orientation)),
                                                                    std::abs(std::sin(lobe.orientation)));
        highest = std::max(highest, lobe.frequency * (1 + lobe.frequency_spread) * along / picture.scale);
    }
    if (highest > 0.5)
        fmt::print(stderr,
                   "gabor: warning: the frequency is {:.3g} cycles per pixel, above the picture's limit of "
                   "0.5: it shows as a lower one, unless --filter takes it away\n",
                   highest);
}

// Also for files that are still to be made, and however they are written.
bool same_file(const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path here = fs::current_path();
    return fs::weakly_canonical(here / a, ignored) == fs::weakly_canonical(here / b, ignored);
}

// name.exr becomes name.0001.exr for the first of several frames.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames) {
    if (frames == 1)
        return path;
    return path.parent_path() /
           fmt::format("{}.{:04}{}", path.stem().string(), frame + 1, path.extension().string());
}

void print_times(const render::FileTimes& times, const vulkan::Device& device, double pixels,
                 double device_ready, double wall) {
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
    render::FileTimes total;
    for (int frame = 0; frame < frames; ++frame) {
        render::Picture picture = request.picture;
        picture.time += static_cast<double>(frame) / frames;
        const std::filesystem::path output = frame_path(options.output, frame, frames);
        std::optional<std::filesystem::path> png;
        if (options.png)
            png = frame_path(*options.png, frame, frames);
        const render::FileTimes times = render::render_file(
            device, picture, region, {output, png, options.compression}, [&](std::uint64_t done) {
                check_interrupt();
                progress->advance(done);
            });
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
    std::vector<std::string_view> presets;
    for (const render::Preset& preset : render::presets())
        presets.push_back(preset.name);
    command->add_option("--frequency-spread", options->frequency_spread,
                        fmt::format("Waves of all frequencies within this share of it, 0 to 1 [{}]",
                                    defaults.frequency_spread));
    command->add_option("--orientation-spread", options->orientation_spread,
                        fmt::format("And of all orientations within these degrees, 0 to 90: isotropic [{}]",
                                    defaults.orientation_spread));
    command->add_option("--lobes", options->lobes,
                        "A JSON list of lobes: frequency, orientation, frequency_spread, orientation_spread, "
                        "power; chosen for each impulse");
    command->add_flag("--sum", options->sum, "Let lobes be independent noises instead, at the cost of each");
    command->add_option("--preset", options->preset,
                        fmt::format("Take what is not given from a preset: {}", fmt::join(presets, ", ")));
    command->add_option(
        "--paint", options->paint,
        "An EXR with channels `frequency` and `orientation`, in degrees, to lay over the picture");
    command->add_flag("--filter", options->filter,
                      "See pixels through a normal filter of half a pixel: no aliasing. Adds a channel "
                      "`removed`, the share of the variance that this takes");
    command->add_option(
        "--view", options->view,
        fmt::format("{} [{}]: `horizon` is a plane in perspective, of the scale at its bottom row; `slice` "
                    "one through noise in space; bodies have surface noise",
                    fmt::join(render::views(), ", "), defaults.view));
    command->add_flag("--solid", options->solid, "Cut a sphere or a torus out of noise in space instead");
    command->add_option("--depth", options->depth,
                        fmt::format("Where a slice is, in kernel radii [{}]", defaults.depth));
    command->add_option("--values", options->values,
                        fmt::format("Uncorrelated noises in each pixel, 1 to 4 [{}]", defaults.values));
    command->add_flag("--phasor", options->phasor, "Add channels `phase`, in turns, and `intensity`");
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
    command->add_option(
        "--like", options->like,
        "Take what is not given from the header of an EXR rendered before, or from a JSON file");
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
