#pragma once

#include "render/filler.hpp"
#include "render/runs.hpp"

#include <array>
#include <vector>

namespace gabor::render {

/// The specialization constants of passes/recipe.glsl.
std::array<std::uint32_t, 7> recipe_constants(const noise::Recipe& recipe);

/// As in passes/bake.comp.
struct BakePush {
    float wave_x, wave_y;
    float column_turn_x, column_turn_y;
    float row_turn_x, row_turn_y;
    float radius_x, radius_y;
    std::int32_t period_x, period_y;
    float time;
    float amplitude;
    float pixel;
    std::uint32_t seed;
    std::int32_t width;
    std::int32_t height;
    std::int32_t first_row;
    std::uint32_t column_runs;
    std::uint32_t first_row_run;
};

/// The pixels that one invocation of passes/bake.comp fills.
struct Block {
    int columns;
    int rows; ///< at most; the last of a cell has fewer
};

/// A CPU has few lanes to fill and large caches: `cpu_block`. A GPU wants many small blocks, whose impulses
/// fit its registers.
constexpr Block cpu_block{8, 32};
Block gpu_block(const noise::Recipe& recipe);

/// The pipeline of passes/bake.comp for a picture's recipe and channels. `fixed_rows`: see there, with
/// statistics asked for; 0 to fill pictures.
vulkan::Pass make_bake_pass(const vulkan::Device& device, const Picture& picture, int block_columns,
                            int fixed_rows = 0);

/// The pass that fills a region of a picture block by block, passes/bake.comp, with its tables on the device.
class Bake : public Filler {
  public:
    /// Whether it can: flat pictures of one lobe without spread, seen sharply.
    static bool can_fill(const Picture& picture);

    /// `picture` must have passed `check`, and `region` lie within it.
    Bake(const vulkan::Device& device, const Picture& picture, const image::Window& region);

    /// Bands of the rows of one block at least.
    std::vector<Band> bands(int most_rows) const override;
    vulkan::Job job(const vulkan::Device& device, const vulkan::Buffer& result) const override;
    void submit(vulkan::Job& job, const Band& band,
                const std::optional<vulkan::Job::Copy>& copy = {}) const override;

  private:
    Block block_;
    int height_;
    std::vector<Run> column_runs_;
    std::vector<Run> row_runs_;
    vulkan::Pass pass_;
    vulkan::Buffer columns_;
    vulkan::Buffer rows_;
    BakePush push_;
};

} // namespace gabor::render
