#pragma once

#include "image/exr.hpp"
#include "render/camera.hpp"
#include "render/load.hpp"

#include "passes/constants.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace gabor::render {

using Bytes = std::vector<std::byte>;

/// The specialization constants of a pass, by the ids in passes/constants.h, as 32 bits each.
using Constants = std::array<std::uint32_t, passes::constant_count>;

/// Those of passes/recipe.glsl, which come first.
std::array<std::uint32_t, passes::window_id + 3> recipe_constants(const noise::Recipe& recipe);

/// The pass PASS for a recipe's drop-in: PASS, or PASS@TAPS for the lattice.
std::string recipe_pass(std::string_view pass, const noise::Recipe& recipe);

/// The time within its period, in [0, 1), as the passes take it.
float wrapped_time(const Request& request);

/// Columns and rows of invocations.
struct Block {
    int columns = 1;
    int rows = 1;
    bool operator==(const Block&) const = default;
};

/// Consecutive rows of a region.
struct Band {
    int first_row;
    int rows;
};

/// One dispatch of a compute pass over a band of the region.
struct Step {
    std::string shader; ///< PASS or PASS@VARIANT, as shaders/CMakeLists.txt lists them
    Constants constants{};
    Bytes push;     ///< begins with passes::Band, that of the whole region
    int across = 0; ///< invocations along a row
    Block group;    ///< that a work group covers
    std::vector<std::pair<int, int>>
        runs; ///< first row and count; a row of groups each. Empty: group.rows each
};

/// Everything that a device needs to draw values of a picture.
struct Plan {
    std::vector<std::string> channels; ///< of each value, side by side
    int width = 0;                     ///< values
    int height = 0;
    std::vector<Bytes> tables; ///< the storage buffers 1, 2, ...; buffer 0 has the values, row by row
    std::vector<Step> steps;   ///< each sees what those before it wrote
};

/// Whether a picture is filled block by block, which is faster than pixel by pixel. Colours and sums come out
/// within 2e-5 of each other either way.
enum class Blocks {
    fitted, ///< where that is possible, by blocks that fit the cells
    fixed,  ///< where it is faster too, by blocks of one size: a window needs one pipeline at all scales
    none
};

enum class DeviceKind { cpu, gpu };

/// What of a picture is drawn, and how finely.
struct Viewport {
    Camera camera;
    int width = 0; ///< pixels of the view, which a horizon or a body fits
    int height = 0;
    image::Rect region; ///< of the view's values
    int stride = 1;     ///< a value stands for stride x stride pixels; waves too fine for that fade
    Blocks blocks = Blocks::fitted;
    bool normals = false; ///< of bodies: adds normal.x, normal.y, normal.z and gradient.z before `A`, along
                          ///< the picture's right and down and to the eye
};

/// The viewport of a part of the request's own picture.
Viewport viewport_of(const Request& request, const image::Rect& region);

/// Whether the picture is drawn block by block.
bool uses_blocks(const Request& request, const Viewport& viewport);

/// How to draw what the viewport shows of a checked request. `paint`: that of the request, load_paint.
Plan plan(const Request& request, const Viewport& viewport, const Paint& paint = {},
          DeviceKind device = DeviceKind::cpu);

/// The region cut into bands of at most `most_rows`, or the fewest rows that can be filled where that is
/// more, from top to bottom.
std::vector<Band> bands(const Plan& plan, int most_rows);

/// A line for each step: its pass, work groups and constants other than 0, and the sizes of the tables.
std::string to_string(const Plan& plan);

/// In the paint, cycles per kernel radius.
double highest_frequency(const Paint& paint);

template <typename T>
Bytes bytes_of(const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

template <typename T>
Bytes bytes_of(const T& value) {
    return bytes_of(std::vector{value});
}

/// The values of a table, or the push constants in front.
template <typename T>
std::vector<T> values_of(const Bytes& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

} // namespace gabor::render
