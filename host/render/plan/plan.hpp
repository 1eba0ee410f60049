#pragma once

#include "image/exr.hpp"
#include "render/plan/camera.hpp"
#include "render/request/load.hpp"

#include "passes/constants.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace gabor::render {

using Bytes = std::vector<std::byte>;

/// The specialization constants of a pass as 32-bit words, indexed by the ids in passes/constants.h.
using Constants = std::array<std::uint32_t, passes::constant_count>;

/// The constants of passes/recipe.glsl, whose ids are the lowest.
std::array<std::uint32_t, passes::window_id + 3> recipe_constants(const noise::Recipe& recipe);

/// The variant of a pass for a recipe: PASS, or PASS@TAPS for the lattice.
std::string recipe_pass(std::string_view pass, const noise::Recipe& recipe);

/// The index of a channel, or -1 if there is none of this name.
int channel_index(std::span<const std::string> channels, std::string_view name);

/// The fraction of the request's evolution, in [0, 1).
float wrapped_evolution(const Request& request);

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
    std::string shader; ///< PASS or PASS@VARIANT, as listed in shaders/CMakeLists.txt
    Constants constants{};
    Bytes push;     ///< push constants; they start with passes::Band for the whole region
    int across = 0; ///< invocations along a row
    Block group;    ///< invocations in a work group
    /// The first row and the number of rows that each row of work groups fills. If the list is empty, each
    /// fills group.rows rows.
    std::vector<std::pair<int, int>> runs;
};

/// A map that passes read band by band: the rows of a band, and `halo` more rows above and below.
struct Source {
    int width = 0; ///< values in a row; 0 for no map
    int halo = 0;
    std::size_t values(int rows) const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows + 2 * halo);
    }
};

/// Everything that a device needs to draw a picture.
struct Plan {
    std::vector<std::string> channels; ///< channels of each value
    int width = 0;                     ///< size in values
    int height = 0;
    std::vector<Bytes> tables; ///< the storage buffers 1, 2, ...; buffer 0 has the values, row by row
    std::vector<Step> steps;   ///< steps in order; each reads what earlier steps wrote
    Source source = {};        ///< map in the storage buffer that follows the tables
};

/// When to fill a picture block by block, which is usually faster than pixel by pixel. The results differ by
/// less than 2e-5.
enum class Blocks {
    fitted, ///< whenever possible, with blocks that fit the cells
    fixed,  ///< when it is faster, with blocks of one size, so that the viewer needs one pipeline for all
            ///< scales
    none
};

enum class DeviceKind { cpu, gpu };

/// The part of a picture to draw, and how finely.
struct Viewport {
    Camera camera;
    int width = 0; ///< size of the view in pixels; a horizon or a body fills it
    int height = 0;
    image::Rect region; ///< the values to draw, within the view
    int stride = 1;     ///< a value stands for stride x stride pixels; finer waves fade
    Blocks blocks = Blocks::fitted;
    bool normals = false; ///< whether to draw normals: see render::channels
    bool lit =
        true; ///< whether to draw the light of a material or terrain; otherwise its channels are undefined
};

/// The viewport of a region of the picture that gabor render draws.
Viewport viewport_of(const Request& request, const image::Rect& region);

/// Tells whether the picture is drawn block by block.
bool uses_blocks(const Request& request, const Viewport& viewport);

/// Plans the drawing of a checked request in a viewport. `paint` is the result of load_paint for the request.
Plan plan(const Request& request, const Viewport& viewport, const Paint& paint = {},
          DeviceKind device = DeviceKind::cpu);

/// Returns the band that begins at `first_row`, where a band may begin: at most `most_rows` rows or, if the
/// plan fills more rows at a time, that many.
Band band_at(const Plan& plan, int first_row, int most_rows);
/// The most rows that `band_at` returns for `most_rows`.
int most_rows_of_a_band(const Plan& plan, int most_rows);

/// The highest frequency that the paint of a request gives its lobe, in cycles per kernel radius.
double highest_frequency(const Request& request, const Paint& paint);

template <typename T>
Bytes bytes_of(const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

template <typename T>
Bytes bytes_of(const T& value) {
    return bytes_of(std::vector{value});
}

/// Reads the values of a table, or the leading push constants.
template <typename T>
std::vector<T> values_of(const Bytes& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

} // namespace gabor::render
