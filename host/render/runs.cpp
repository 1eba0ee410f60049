#include "render/runs.hpp"

#include <cmath>

namespace gabor::render {

std::vector<Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest) {
    const auto position = [&](int pixel) { return (pixel + 0.5) * cells_per_pixel; };
    const auto cell_of = [&](int pixel) {
        return static_cast<std::int32_t>(std::floor(position(pixel) - radius));
    };
    // The first pixel that visits no cell before this one: an estimate, which rounding may have put one off.
    const auto start_of = [&](std::int32_t cell) {
        int pixel = static_cast<int>(std::ceil((cell + radius) / cells_per_pixel - 0.5));
        while (cell_of(pixel) >= cell)
            --pixel;
        while (cell_of(pixel) < cell)
            ++pixel;
        return pixel;
    };

    std::vector<Run> runs;
    const int start = start_of(cell_of(first));
    int pixel = start + (first - start) / longest * longest;
    while (pixel < first + count) {
        const std::int32_t cell = cell_of(pixel);
        int length = 1;
        while (length < longest && cell_of(pixel + length) == cell)
            ++length;
        runs.push_back({cell, static_cast<float>(position(pixel) - cell - 1), pixel - first, length});
        pixel += length;
    }
    return runs;
}

} // namespace gabor::render
