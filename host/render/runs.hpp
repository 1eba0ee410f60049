#pragma once

#include <cstdint>
#include <vector>

namespace gabor::render {

/// Consecutive pixels that visit the same cells along an axis; as in passes/bake.comp.
struct Run {
    std::int32_t cell;  ///< the first cell visited
    float local;        ///< place of the first pixel's centre, in cells from where the next cell begins
    std::int32_t first; ///< that pixel, counted from the first one asked for: it may be negative
    std::int32_t count;
};

/// The runs of at most `longest` pixels that cover the pixels first, ..., first + count - 1. Pixel i is
/// centred at (i + 0.5) * cells_per_pixel cells and visits the cells within `radius` of there. Where runs
/// begin depends on the grid alone, so that every part of a picture is cut in the same way; the first and the
/// last run may reach beyond what was asked for.
std::vector<Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest);

} // namespace gabor::render
