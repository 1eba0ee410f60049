#include "render/output/maps.hpp"
#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/request.hpp"
#include "cli/terminal.hpp"
#include "render/output/texture.hpp"
#include "vulkan/device.hpp"

#include <algorithm>
#include <memory>

namespace gabor::cli {

namespace {

struct MapsOptions : RequestOptions {
    std::string output;
    bool directx = false;
    std::string normal_bits = "16";
    std::optional<std::string> metres;
    bool texture = false;
    bool floats = false;
    std::string compression = "zip";
    std::string device;
};

// Unless a scale is given, the shorter side spans 4 units of a material, 8 of terrain. Maps tile and have
// sides of map_side, unless options or the file of --like say otherwise.
render::Request request_of(const MapsOptions& options) {
    const Asked asked = asked_by(options);
    render::check(asked.request);
    render::Request request = render::from_above(asked.request);
    render::check_maps(request);
    if (!options.size && !options.like)
        request.width = request.height = render::map_side;
    const int side = std::min(request.width, request.height);
    const bool terrain = request.kind == render::Kind::terrain;
    if (options.preset && !is_given(options.parameters, "scale")) // as much as the preset's picture shows
        request.scale *= static_cast<double>(side) / asked.side;
    if (!asked.scaled)
        request.scale = std::max(2.0, side / (terrain ? 8.0 : 4.0));
    if (!options.like && !is_given(options.parameters, "tileable"))
        render::make_tile(request);
    render::check(request);
    if (options.texture)
        render::check_texture(request, {0, 0, request.width, request.height});
    request.filter = !terrain;
    return request;
}

void render_maps(const MapsOptions& options) {
    system::note_interrupts();
    if (options.normal_bits != "8" && options.normal_bits != "16")
        refuse("--normal-bits", options.normal_bits, "8 or 16");
    if (options.output.ends_with(".png") || options.output.ends_with(".exr"))
        refuse("--output", options.output, "a folder for the maps");
    render::MapFormat format{options.directx, options.texture, options.floats,
                             options.normal_bits == "8" ? 8 : 16, options.compression};
    if (options.metres)
        format.metres = parse_positive("--width-metres", *options.metres, "a width above 0");
    const render::Request request = request_of(options);
    const vulkan::Device device(options.device);
    {
        Progress progress("rendering", image::Rect{0, 0, request.width, request.height}.pixels());
        render::render_maps(device, request, options.output, format,
                            [&](std::uint64_t done) { progress.advance(done); });
    }
    fmt::print("{}: maps of {} x {} pixels, {}, on {}\n", options.output, request.width, request.height,
               subject(request), device.info().name);
}

// Tells whether a parameter changes maps, which have no light and one view of each kind.
bool changes_maps(const render::Parameter& p) {
    const render::Request material{.kind = render::Kind::material}, terrain{.kind = render::Kind::terrain};
    return p.name != "filter" && p.name != "fractal" && (p.scope.holds(material) || p.scope.holds(terrain));
}

} // namespace

void add_maps_command(CLI::App& app) {
    auto options = std::make_shared<MapsOptions>();
    CLI::App* command =
        app.add_subcommand("maps", "Render the maps of a material or of terrain, for other programs");
    command->footer(R"(
Examples:
  gabor maps --material wood --wood.rings 20 --width-metres 0.5 -o wood
  gabor maps --preset canyon --width-metres 2000 -o canyon

`gabor materials NAME` lists the options of a material, and `gabor erode --help` those of a
terrain's erosion.
)");
    begin_group(*command, "Output");
    add_option(
        *command, "-o,--output", options->output, "FOLDER",
        "Folder of the maps: PNGs of base colour, normals, height, roughness, metalness and occlusion, "
        "one EXR with all of them, and material.mtlx, material.gltf and material.json. The maps tile, unless "
        "--no-tileable or --like says otherwise")
        ->required();
    add_source_options(*command, *options, render::most_map_side, fmt::format("{0}x{0}", render::map_side));
    add_option(*command, "--width-metres", options->metres, "NUMBER",
               "Width of the maps, which also scales the heights; by default, the extent of a terrain, or 1");
    command->add_flag("--directx", options->directx, "Also write normals for DirectX");
    add_option(*command, "--normal-bits", options->normal_bits, "BITS",
               "Bits of the normals: 16, or 8 with dithering, for programs that do not read 16 [16]");
    command->add_flag("--texture", options->texture,
                      "For a material: write maps.exr as a tiled, mip-mapped texture, with more roughness "
                      "where averaging flattens normals; both sides must be powers of two");
    command->add_flag("--float", options->floats,
                      "Store all channels of maps.exr as 32-bit floats, not only heights in metres");
    add_compression_option(*command, options->compression);
    add_device_option(*command, options->device);
    using Group = render::Parameter::Group;
    for (const auto& [title, group] : {std::pair("Surface", Group::noise),
                                       {"Surface", Group::view},
                                       {"Surface", Group::terrain},
                                       {"", Group::erosion},
                                       {"", Group::material},
                                       {"", Group::boards},
                                       {"", Group::coat},
                                       {"", Group::finish}})
        add_group(*command, *options, title, group,
                  *title || group == Group::erosion ? changes_maps : nullptr);
    command->get_option("--view")->description("flat for a material, or terrain [flat]");
    command->callback([options] { render_maps(*options); });
}

} // namespace gabor::cli
