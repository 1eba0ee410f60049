#pragma once

#include "noise/spectrum.hpp"
#include "render/renderer.hpp"

#include "passes/bake_interface.h"
#include "passes/colour.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace gabor::render {

/// A pass that includes passes/recipe.glsl, compiled for each drop-in.
struct RecipeModules {
    std::span<const std::uint32_t> sparse;
    std::array<std::span<const std::uint32_t>, 3> lattice; ///< with 2, 3 and 4 taps

    std::span<const std::uint32_t> of(const noise::Recipe& recipe) const {
        return recipe.is_lattice() ? lattice.at(static_cast<std::size_t>(recipe.taps - 2)) : sparse;
    }
};

/// The pass of that name as `pass_of` has it.
std::string recipe_pass(std::string_view name, const noise::Recipe& recipe);

/// The specialization constants of passes/recipe.glsl.
std::array<std::uint32_t, 7> recipe_constants(const noise::Recipe& recipe);

/// The runs of at most `longest` pixels that cover the pixels first, ..., first + count - 1. Pixel i is
/// centred at (i + 0.5) * cells_per_pixel cells and visits the cells within `radius` of there. Where runs
/// begin depends on the grid alone, so that every part of a picture is cut in the same way; the first and the
/// last run may reach beyond what was asked for.
/// `origin`: the cells from where cells are counted to where pixels are, at most one.
std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin = 0);

/// The pixels that one invocation of passes/bake.comp fills.
struct Block {
    int columns;
    int rows; ///< at most; the last of a cell has fewer
};

/// A CPU has few lanes to fill and large caches: `cpu_block`, for the lattice about as many pixels. A GPU
/// wants many small blocks, whose impulses fit its registers.
constexpr Block cpu_block{8, 32};
Block gpu_block(const noise::Recipe& recipe);

/// The specialization constants of passes/bake.comp for a request's recipe, spectrum and channels.
std::vector<std::uint32_t> bake_constants(const Request& request, int block_columns, int fixed_rows = 0);

/// Its pipeline. `fixed_rows`: see there, with statistics asked for; 0 to fill pictures.
vulkan::Pass make_bake_pass(const vulkan::Device& device, const Request& request, int block_columns,
                            int fixed_rows = 0, Code code = {});

/// Pixels along an axis: pixel i is centred (i + 0.5) / scale kernel radii from `origin`.
struct BakeAxis {
    int first = 0; ///< pixel
    int count = 0;
    double scale = 32; ///< pixels per kernel radius
    /// Where the pixels are counted from, in cells of so many to a kernel radius: a cell, and the place in
    /// it.
    std::function<std::pair<std::int32_t, double>(double)> origin;
};

/// What passes/bake.comp reads to fill a region.
struct BakeTables {
    /// The noises of one kernel radius, whose pixels fall into the same runs: what is pushed for the whole
    /// region.
    struct Grid {
        passes::BakePush push;
        std::vector<passes::Run> row_runs;
        int block_columns;
        const vulkan::Pass* pass = nullptr; ///< with blocks of that width; null: that of the job
    };

    std::vector<passes::Run> columns;
    std::vector<passes::Run> rows;
    std::vector<passes::BakeWave> waves;
    std::vector<Grid> grids;
    const vulkan::Pass* colouring = nullptr; ///< after them, passes/bake_colour.comp in colour

    /// Has `job`, of a bake's pass with these tables, fill any rows of the region. `before`: pixels in its
    /// buffer before those.
    void submit(vulkan::Job& job, const RegionRenderer::Band& band, int before,
                const std::optional<vulkan::Job::Copy>& copy) const;
};

/// What a bake of `request` reads, for pixels along these axes, cut into the blocks that `block_of` gives for
/// noises of so many pixels per kernel radius.
BakeTables make_bake_tables(const Request& request, const BakeAxis& across, const BakeAxis& down,
                            const std::function<Block(double)>& block_of);

/// The pass that fills a region of a picture block by block, passes/bake.comp, with its tables on the device.
class Bake : public RegionRenderer {
  public:
    /// Whether it can: flat pictures and slices seen sharply, without paint, of channels that add up as
    /// noises do, or in colour. Isotropic noise in space has no wave that all nodes share.
    static bool can_fill(const Request& request);

    /// `request` must have passed `check`, and `region` lie within it.
    Bake(const vulkan::Device& device, const Request& request, const image::Window& region, Code code = {});

    /// Bands of the rows of one block at least.
    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Bake(const vulkan::Device& device, BakeTables tables, const passes::PixelsColour& colour, int height);

    int height_;
    BakeTables tables_;
    std::map<int, vulkan::Pass> passes_; ///< by the columns of their blocks
    std::unique_ptr<vulkan::Pass> colouring_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer waves_;
    vulkan::Buffer colour_;
};

} // namespace gabor::render
