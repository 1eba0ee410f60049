#pragma once

#include "noise/spectrum.hpp"
#include "render/renderer.hpp"

#include "passes/bake_interface.h"
#include "passes/colour.h"

#include <array>
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

/// The specialization constants of passes/recipe.glsl.
std::array<std::uint32_t, 7> recipe_constants(const noise::Recipe& recipe);

/// The runs of at most `longest` pixels that cover the pixels first, ..., first + count - 1. Pixel i is
/// centred at (i + 0.5) * cells_per_pixel cells and visits the cells within `radius` of there. Where runs
/// begin depends on the grid alone, so that every part of a picture is cut in the same way; the first and the
/// last run may reach beyond what was asked for.
std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest);

/// The pixels that one invocation of passes/bake.comp fills.
struct Block {
    int columns;
    int rows; ///< at most; the last of a cell has fewer
};

/// A CPU has few lanes to fill and large caches: `cpu_block`, for the lattice about as many pixels. A GPU
/// wants many small blocks, whose impulses fit its registers.
constexpr Block cpu_block{8, 32};
Block gpu_block(const noise::Recipe& recipe);

/// The pipeline of passes/bake.comp for a request's recipe, spectrum and channels. `fixed_rows`: see there,
/// with statistics asked for; 0 to fill pictures.
vulkan::Pass make_bake_pass(const vulkan::Device& device, const Request& request, int block_columns,
                            int fixed_rows = 0);

/// The pass that fills a region of a picture block by block, passes/bake.comp, with its tables on the device.
class Bake : public RegionRenderer {
  public:
    /// Whether it can: flat pictures and slices seen sharply, without paint, of channels that add up as
    /// noises do, or in colour.
    static bool can_fill(const Request& request);

    /// `request` must have passed `check`, and `region` lie within it.
    Bake(const vulkan::Device& device, const Request& request, const image::Window& region);

    /// Bands of the rows of one block at least.
    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    /// The noises of one kernel radius, whose pixels fall into the same runs: what is pushed for the whole
    /// region.
    struct Grid {
        passes::BakePush push;
        std::vector<passes::Run> row_runs;
    };

    /// Of all grids.
    struct Tables {
        std::vector<passes::Run> columns;
        std::vector<passes::Run> rows;
        std::vector<passes::BakeWave> waves;
        std::vector<Grid> grids;
    };
    static Tables make_tables(const Request& request, const image::Window& region, const Block& block);

    Bake(const vulkan::Device& device, const Request& request, const image::Window& region,
         const Block& block);
    Bake(const vulkan::Device& device, const Tables& tables, vulkan::Pass pass,
         const passes::PixelsColour& colour, int height);

    int height_;
    std::vector<Grid> grids_;
    vulkan::Pass pass_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    vulkan::Buffer waves_;
    vulkan::Buffer colour_;
};

} // namespace gabor::render
