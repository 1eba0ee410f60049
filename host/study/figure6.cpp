// The real case: six lobes of three kernels under a colour map, seminal and recommended.

#include "image/png.hpp"
#include "render/file.hpp"
#include "study/figures.hpp"
#include "study/measures.hpp"
#include "study/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace gabor::study {

namespace {

constexpr Ingredients seminal{};

// Each real kernel has a lobe on either side of the origin.
std::vector<Noise> six_lobes(const vulkan::Device& device, const Ingredients& ingredients) {
    std::vector<Noise> sum;
    sum.emplace_back(device, ingredients, Wave{2.5, 0.35}, 0.5);
    sum.emplace_back(device, ingredients, Wave{4, 1.4}, 0.3);
    sum.emplace_back(device, ingredients, Wave{6, 2.45}, 0.2);
    return sum;
}

std::vector<float> sum_picture(std::vector<Noise> sum, int bits) {
    std::vector<float> total(std::size_t{1} << 2 * bits);
    std::uint32_t seed = 0;
    for (Noise& noise : sum)
        std::ranges::transform(total, picture(noise, bits, ++seed), total.begin(), std::plus<>());
    return total;
}

// Sharp veins on a gradient: where the noise is off by a little the picture is off by much.
std::array<float, 3> colour(float noise) {
    const float t = std::clamp(render::unorm(noise), 0.0f, 1.0f);
    const float vein = std::exp(-40 * noise * noise);
    const float band = 0.5f + 0.5f * std::cos(25 * t);
    return {0.15f + 0.75f * t + 0.1f * band - 0.7f * vein, 0.1f + 0.6f * t * t + 0.15f * band - 0.4f * vein,
            0.35f - 0.25f * t + 0.15f * band + 0.1f * vein};
}

} // namespace

Tables figure6(const vulkan::Device& device, const Effort& effort) {
    Table table{
        "figure6",
        "samples,windows,seconds_seminal,seconds_recommended,time_ratio,cvm_seminal,cvm_seminal_low,"
        "cvm_seminal_high,cvm_recommended,cvm_recommended_low,cvm_recommended_high,interdecile_seminal,"
        "interdecile_recommended",
        {}};
    const auto measure = [&device, effort](std::uint32_t seed) -> Numbers {
        std::vector<Noise> all = six_lobes(device, seminal);
        std::ranges::move(six_lobes(device, recommended), std::back_inserter(all));
        const std::vector<double> seconds = picture_seconds(all, effort.picture_bits, effort.timings);
        const double slow = std::accumulate(seconds.begin(), seconds.begin() + 3, 0.0);
        const double fast = std::accumulate(seconds.begin() + 3, seconds.end(), 0.0);
        const std::span<Noise> halves[]{std::span(all).first(3), std::span(all).last(3)};
        Numbers numbers{slow, fast, slow / fast};
        for (const std::span<Noise> sum : halves) {
            const statistics::Estimate cvm = measure_values(sum, effort.samples, seed).gaussianity.index();
            numbers.insert(numbers.end(), {cvm.value, cvm.low, cvm.high});
        }
        for (const std::span<Noise> sum : halves)
            numbers.push_back(measure_windows(sum, effort.windows, seed).contrast().interdecile);
        return numbers;
    };
    const double impulses = 3 * (seminal.impulses + recommended.impulses);
    table.rows.push_back(
        {fmt::format("{},{}", effort.samples, effort.windows),
         impulses * (static_cast<double>(effort.samples) + 256 * static_cast<double>(effort.windows) +
                     effort.timings * std::pow(4, effort.picture_bits)),
         measure});
    return {table};
}

void figure6_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder) {
    const int side = 1 << effort.picture_bits;
    const std::vector<float> left = sum_picture(six_lobes(device, seminal), effort.picture_bits);
    const std::vector<float> right = sum_picture(six_lobes(device, recommended), effort.picture_bits);
    write_exr(folder / "figure6_seminal", left);
    write_exr(folder / "figure6_recommended", right);
    image::PngWriter png(folder / "figure6_pair.png", 2 * side, side, 3);
    for (int y = 0; y < side; ++y) {
        std::vector<float> row;
        for (const std::vector<float>* half : {&left, &right})
            for (int x = 0; x < side; ++x)
                for (const float channel : colour((*half)[static_cast<std::size_t>(y * side + x)]))
                    row.push_back(channel);
        png.write_rows(row);
    }
    png.commit();
}

} // namespace gabor::study
