// Gaussianity against N, with uniform weights.

#include "study/convergence.hpp"
#include "study/figures.hpp"
#include "study/pictures.hpp"

#include <fmt/format.h>

namespace gabor::study {

Tables figure2(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure2", std::string(convergence_columns), {}};
    for (const Points points : all_points)
        for (const int n : effort.impulses)
            table.rows.push_back(convergence_row(device, {.points = points, .impulses = n}, effort));
    return {table};
}

// The instances of the inset: seminal noise of about 50, 5 and 0.5.
void figure2_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder) {
    for (const int n : {4, 10, 30}) {
        Noise noise(device, Ingredients{.impulses = n});
        const std::vector<float> pixels = picture(noise, effort.picture_bits, 1);
        write_exr(folder / fmt::format("figure2_n{}", n), pixels);
        write_png(folder / fmt::format("figure2_n{}", n), pixels);
    }
}

} // namespace gabor::study
