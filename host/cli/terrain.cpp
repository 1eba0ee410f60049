#include "cli/commands.hpp"
#include "cli/heights.hpp"
#include "cli/terminal.hpp"
#include "error.hpp"
#include "vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace gabor::cli {

namespace {

constexpr int most_side = 65536;

struct TerrainOptions {
    std::filesystem::path output, png, heightmap;
    std::vector<int> size{1024, 1024};
    std::vector<int> region;
    std::vector<double> elevation;
    double extent = 2 * preset_hill;
    std::optional<double> hills;
    GullyOptions gullies;
    std::uint32_t seed = 0;
    bool tileable = false;
    std::string device;
};

using Colour = std::array<double, 3>;

Colour mix(const Colour& a, const Colour& b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double srgb(double linear) {
    return linear < 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

// Grass, dry ground, rock where it is steep and snow where it is high, lit by a sun in the upper left and the
// sky. `height` is in hills' own unit.
Colour shaded(double height, double slope_x, double slope_y, double ridge) {
    const double steep = std::hypot(slope_x, slope_y);
    Colour ground =
        mix({0.1, 0.155, 0.05}, {0.3, 0.245, 0.145}, smoothstep(-0.3, 0.35, height + 0.1 * ridge));
    ground = mix(ground, {0.26, 0.23, 0.205}, smoothstep(0.55, 1.0, steep));
    ground = mix(ground, {0.68, 0.7, 0.73},
                 smoothstep(0.42, 0.62, height + 0.08 * ridge) * (1 - smoothstep(0.9, 1.5, steep)));
    const double length = std::sqrt(1 + steep * steep);
    const double sun = std::max((slope_x + slope_y + 1.1) / length / std::sqrt(3.21), 0.0);
    const double sky = 0.5 + 0.5 / length;
    const double hollow = 1 + 0.25 * std::clamp(ridge, -1.0, 1.0);
    const Colour light{1.32 * sun + 0.2 * sky, 1.23 * sun + 0.25 * sky, 1.08 * sun + 0.33 * sky};
    Colour result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = srgb(std::min(hollow * light[i] * ground[i], 1.0));
    return result;
}

// Rows in the unit of --extent, from rows in the hills' own.
void scale_heights(std::vector<float>& rows, double unit) {
    for (std::size_t i = 0; i < rows.size(); i += render::erosion_channels.size()) {
        rows[i] = static_cast<float>(rows[i] * unit);
        rows[i + 4] = static_cast<float>(rows[i + 4] * unit);
    }
}

void draw_terrain(const TerrainOptions& options) {
    if (options.output.empty() && options.png.empty() && options.heightmap.empty())
        throw RequestError("nothing to write: give -o FILE.exr, --png FILE or --heightmap FILE");
    if (!options.output.empty() && !has_extension(options.output, ".exr"))
        throw RequestError(
            fmt::format("-o '{}': it takes the name of a file that ends in .exr", options.output.string()));
    if (!options.png.empty() && !has_extension(options.png, ".png"))
        throw RequestError(
            fmt::format("--png '{}': it takes the name of a file that ends in .png", options.png.string()));
    if (!options.heightmap.empty() && !has_extension(options.heightmap, ".png") &&
        !has_extension(options.heightmap, ".r16"))
        throw RequestError(
            fmt::format("--heightmap '{}': it takes the name of a file that ends in .png or .r16",
                        options.heightmap.string()));
    if (options.png == options.heightmap && !options.png.empty())
        throw RequestError("--png and --heightmap name the same file");
    const int width = options.size[0], height = options.size[1];
    if (std::min(width, height) < 1 || std::max(width, height) > most_side)
        throw RequestError(fmt::format("--size takes WIDTHxHEIGHT, each from 1 to {}", most_side));
    if (!(options.extent > 0 && options.extent < 1e9))
        throw RequestError(
            fmt::format("--extent {}: it takes the picture's width, more than 0", options.extent));
    const double hill = options.hills.value_or(options.extent / 2);
    if (!(hill > 0 && options.extent / hill <= 4096))
        throw RequestError(
            fmt::format("--hills {}: it takes a width of at least 1/4096 of the extent", hill));
    const double unit = hill / preset_hill; // of --extent, in the hills' own
    render::Erosion erosion = options.gullies.erosion(hill);
    erosion.frequency *= unit;
    render::HeightMap ground;
    ground.width = width;
    ground.height = height;
    ground.pixel = options.extent / unit / width;
    ground.tileable = options.tileable;
    const image::Rect region = region_within(options.region, width, height);
    const double reach = unit * (render::hill_reach + render::erosion_reach(erosion) / erosion.frequency);
    Elevation elevation{-reach, reach};
    if (!options.elevation.empty())
        elevation = {options.elevation[0], options.elevation[1]};
    if (!(elevation.low < elevation.high && std::isfinite(elevation.high - elevation.low)))
        throw RequestError("--elevation takes LOW,HIGH, the lower height first");

    note_interrupts();
    const vulkan::Device device(options.device);
    std::optional<image::ExrWriter> exr;
    std::optional<image::PngWriter> picture;
    std::optional<HeightWriter> heights;
    if (!options.output.empty())
        exr.emplace(options.output,
                    image::ExrWriter::Description{
                        .picture = {0, 0, width, height},
                        .window = region,
                        .channels = {render::erosion_channels.begin(), render::erosion_channels.end()},
                        .parameters = {}});
    if (!options.png.empty())
        picture.emplace(options.png, region.width, region.height, 3);
    if (!options.heightmap.empty())
        heights.emplace(options.heightmap, region, elevation, options.extent / width);
    {
        Progress progress("drawing", static_cast<std::uint64_t>(region.width) *
                                         static_cast<std::uint64_t>(region.height));
        std::vector<float> rows, colours;
        render::erode(device, ground, erosion, options.seed, region, [&](std::span<const float> drawn) {
            check_interrupt();
            rows.assign(drawn.begin(), drawn.end());
            if (picture) {
                colours.clear();
                for (std::size_t i = 0; i < rows.size(); i += render::erosion_channels.size())
                    for (const double part : shaded(rows[i], rows[i + 1], rows[i + 2], rows[i + 3]))
                        colours.push_back(static_cast<float>(part));
                picture->write_rows(colours);
            }
            scale_heights(rows, unit);
            if (exr)
                exr->write_rows(rows);
            if (heights)
                heights->write_rows(rows);
            progress.advance(rows.size() / render::erosion_channels.size());
        });
    }
    if (exr)
        exr->commit();
    if (picture)
        picture->commit();
    if (heights)
        heights->commit();
    for (const std::filesystem::path& path : {options.output, options.png, options.heightmap})
        if (!path.empty())
            fmt::print("{}: {} x {} pixels, on {}\n", path.string(), region.width, region.height,
                       device.info().name);
}

} // namespace

void add_terrain_command(CLI::App& app) {
    auto options = std::make_shared<TerrainOptions>();
    CLI::App* command =
        app.add_subcommand("terrain", "Draw eroded mountains; also as gabor render --terrain");
    command
        ->add_option("-o,--output", options->output, "EXR with height, slope, ridge, and what erosion added")
        ->type_name("FILE");
    command->add_option("--png", options->png, "PNG, coloured and lit")->type_name("FILE");
    command
        ->add_option("--heightmap", options->heightmap,
                     "Heights of 16 bits, a PNG or .r16, with their scale in a .json file beside it")
        ->type_name("FILE");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels [1024x1024]")
        ->type_name("SIZE")
        ->delimiter('x')
        ->expected(2);
    command
        ->add_option("--region", options->region,
                     "X,Y,WIDTH,HEIGHT: only this part, with the pixels of the whole")
        ->type_name("RECTANGLE")
        ->delimiter(',')
        ->expected(4);
    command->add_option("--extent", options->extent, "Width of the picture, in the unit of heights [8]")
        ->type_name("NUMBER");
    command->add_option("--hills", options->hills, "Width of a hill, in the same unit [half of --extent]")
        ->type_name("NUMBER");
    command
        ->add_option("--elevation", options->elevation,
                     "LOW,HIGH: heights that 0 and 65535 stand for in --heightmap [all that there can be]")
        ->type_name("RANGE")
        ->delimiter(',')
        ->expected(2);
    options->gullies.add_to(*command);
    command->add_option("--seed", options->seed, "Another seed gives other mountains [0]")
        ->type_name("NUMBER");
    command->add_flag("--tileable", options->tileable, "Repeat exactly in both directions");
    command
        ->add_option("--device", options->device,
                     "Vulkan device: its index, or a part of its name [the fastest kind]")
        ->type_name("NAME");
    command->callback([options] { draw_terrain(*options); });
}

} // namespace gabor::cli
