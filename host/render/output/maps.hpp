#pragma once

#include "image/exr.hpp"
#include "render/request/request.hpp"
#include "vulkan/device.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace gabor::render {

/// The largest side of maps, in pixels. Maps keep 4 bytes per pixel in memory, or 14 with mip levels.
constexpr int most_map_side = 8192;

/// The sides of maps, in pixels, unless asked for otherwise.
constexpr int map_side = 2048;

struct MapFormat {
    bool directx = false; ///< also write normal_directx.png
    bool texture = false; ///< write mip levels to maps.exr; slopes that averaging removes become roughness
    bool floats = false;  ///< store 32-bit floats in maps.exr; otherwise only heights have 32 bits
    int normal_bits = 16; ///< of normal.png; 8 bits are dithered
    std::string compression = "zip";   ///< of maps.exr: see image::exr_compressions
    std::optional<double> metres = {}; ///< the width of the maps; if not set, a terrain's extent or 1
};

/// The fmt templates of material.mtlx, material.gltf, which shows a rectangle, and material.json. Their files
/// are in host/render/output/scenes.
extern const std::string_view materialx_template, gltf_template, json_template;

/// Tells whether the request has maps: a material in the plane, or terrain from above.
bool has_maps(const Request& request);

/// Throws RequestError if the request has no maps.
void check_maps(const Request& request);

/// Makes the picture square, with as much in it as its shorter side showed.
void set_side(Request& request, int side);

/// Makes the picture tile. If it shows too little for a tile, it then shows more.
void make_tile(Request& request);

/// Lists all files that render_maps writes.
std::vector<std::filesystem::path> map_paths(const std::filesystem::path& folder, const MapFormat& format);

/// Writes a checked request's material, or terrain from above, as images for other programs: base_color.png
/// (sRGB), normal.png (OpenGL, 16 bits), height.png (16 bits, from the lowest to the highest point),
/// roughness.png, metalness.png, occlusion.png, orm.png (occlusion, roughness and metalness, as glTF packs
/// them), maps.exr with all of them and heights in metres, material.mtlx, material.gltf and material.json,
/// which state the size and the range of heights in metres. The files appear together when all are complete;
/// the folder is created if there is none. Calls `advance` with the number of pixels in each band. Throws
/// RequestError if the request has no maps or is too large.
void render_maps(const vulkan::Device& device, const Request& request, const std::filesystem::path& folder,
                 const MapFormat& format, const image::Advance& advance);

} // namespace gabor::render
