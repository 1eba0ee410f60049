// The figures of [TNVT19].

#include "study/figures.hpp"

#include "image/exr.hpp"
#include "image/png.hpp"
#include "render/output/file.hpp"
#include "study/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace gabor::study {

namespace {

constexpr Ingredients seminal{};

constexpr std::string_view convergence_columns =
    "points,weights,kernel,envelope,N,samples,cvm,cvm_low,cvm_high,variance";

// The Gaussianity and the variance of one noise.
Row convergence_row(const vulkan::Device& device, const Ingredients& ingredients, const Effort& effort) {
    const std::uint64_t samples = effort.samples;
    return {fmt::format("{},{}", csv_fields(ingredients), samples),
            static_cast<double>(ingredients.impulses) * static_cast<double>(samples),
            [&device, ingredients, samples](std::uint32_t seed) -> Numbers {
                Noise noise(device, ingredients);
                const ValueStatistics values = measure_values(single(noise), samples, seed);
                const statistics::Estimate cvm = values.gaussianity.index();
                return {cvm.value, cvm.low, cvm.high, values.moments.variance()};
            }};
}

int side_of(std::span<const float> pixels) {
    return static_cast<int>(std::lround(std::sqrt(pixels.size())));
}

void write_exr(const std::filesystem::path& path, std::span<const float> pixels) {
    const int side = side_of(pixels);
    const image::Rect window{0, 0, side, side};
    image::ExrWriter writer(path.string() + ".exr",
                            {.picture = window, .window = window, .channels = {"Y"}, .parameters = {}});
    writer.write_rows(pixels);
    writer.commit();
}

void write_png(const std::filesystem::path& path, std::span<const float> pixels) {
    const int side = side_of(pixels);
    std::vector<float> shown;
    for (const float noise : pixels)
        shown.push_back(render::unorm(noise));
    image::PngWriter writer(path.string() + ".png", side, side, 1);
    writer.write_rows(shown);
    writer.commit();
}

} // namespace

// Figure 1: the point sets, for 16 impulses per cell.

Tables figure1(const vulkan::Device& device, const Effort&) {
    constexpr int side = 3; // cells
    Table table{"figure1", "points,N,point,x,y", {}};
    for (const Points points : all_points) {
        const PointSet set = point_set(device, {.points = points, .impulses = 16}, side, 1);
        int index = 0;
        for (const std::vector<Point>& cell : set)
            for (const Point& point : cell)
                table.rows.push_back(
                    {fmt::format("{},16,{}", name(points), index++), 0, [point](std::uint32_t) -> Numbers {
                         return {point.x, point.y};
                     }});
    }
    return {table};
}

// Figure 2: Gaussianity against N, with uniform weights.

Tables figure2(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure2", std::string(convergence_columns), {}};
    for (const Points points : all_points)
        for (const int n : effort.impulses)
            table.rows.push_back(convergence_row(device, {.points = points, .impulses = n}, effort));
    return {table};
}

// Writes the pictures of the insets: seminal noise with a cvm of about 50, 5 and 0.5.
void figure2_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder) {
    for (const int n : {4, 10, 30}) {
        Noise noise(device, Ingredients{.impulses = n});
        const std::vector<float> pixels = picture(noise, effort.picture_bits, 1);
        write_exr(folder / fmt::format("figure2_n{}", n), pixels);
        write_png(folder / fmt::format("figure2_n{}", n), pixels);
    }
}

// Figure 3: N* (see SeminalCurve) against N.

void SeminalCurve::add(int n, double cvm) {
    // Keeps only the falling part, because chance can make the curve rise at its low end.
    if (cvm > 0 && (points_.empty() || std::log(cvm) < points_.back().first))
        points_.emplace_back(std::log(cvm), std::log(n));
}

double SeminalCurve::equivalent(double cvm) const {
    if (!(cvm > 0))
        return std::numeric_limits<double>::infinity();
    const double wanted = std::log(cvm);
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const auto [upper, n_upper] = points_[i - 1];
        const auto [lower, n_lower] = points_[i];
        if (wanted <= upper && wanted >= lower)
            return std::exp(std::lerp(n_upper, n_lower, (upper - wanted) / (upper - lower)));
    }
    const Ingredients single{.impulses = 1};
    constexpr double squares = 7 / (9 * std::numbers::sqrt3 * std::numbers::pi);
    return poisson_kurtosis(single, {}) / 24 * std::sqrt(statistics::cvm_scale * squares / cvm);
}

Tables figure3(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure3", std::string(convergence_columns), {}};
    for (const Weights weights : {Weights::uniform, Weights::bernoulli})
        for (const Points points : all_points)
            for (const int n : effort.impulses)
                table.rows.push_back(
                    convergence_row(device, {.points = points, .weights = weights, .impulses = n}, effort));
    table.derived = "n_star,n_star_low,n_star_high";
    table.derive = [impulses = effort.impulses](std::vector<Numbers>& rows) {
        SeminalCurve curve;
        for (std::size_t i = 0; i < impulses.size(); ++i) // the first rows are those of the seminal noise
            curve.add(impulses[i], rows[i][0]);
        for (Numbers& row : rows)
            for (const double cvm : {row[0], row[2], row[1]})
                row.push_back(curve.equivalent(cvm));
    };
    return {table};
}

// Figure 4: fluctuations of the windowed contrast against N.

Tables figure4(const vulkan::Device& device, const Effort& effort) {
    // Contrasts are those of noise with a standard deviation of 1/4, which puts 95 % of the histogram in
    // [0, 1].
    constexpr double shown = 0.25;
    Table table{
        "figure4",
        "points,weights,kernel,envelope,N,windows,variance_median,variance_interdecile,deviation_median",
        {}};
    for (const Weights weights : {Weights::bernoulli, Weights::uniform})
        for (const Points points : all_points)
            for (const int n : effort.impulses) {
                const Ingredients ingredients{.points = points, .weights = weights, .impulses = n};
                const std::uint64_t windows = effort.windows;
                table.rows.push_back(
                    {fmt::format("{},{}", csv_fields(ingredients), windows),
                     256.0 * n * static_cast<double>(windows),
                     [&device, ingredients, windows](std::uint32_t seed) -> Numbers {
                         Noise noise(device, ingredients);
                         const statistics::InstanceStationarity w =
                             measure_windows(single(noise), windows, seed);
                         return {w.contrast().median, w.contrast().interdecile, shown * w.median_deviation()};
                     }});
            }
    return {table};
}

// Figure 5: the times of the recommended noise, of the same noise with Poisson points, and of the seminal
// noise with the same quality.

namespace {

// Returns N* (see SeminalCurve): from the cvm if that is clearly above 0, otherwise from the excess kurtosis.
double seminal_equivalent(const ValueStatistics& values, const Ingredients& ingredients) {
    const statistics::Estimate cvm = values.gaussianity.index();
    if (cvm.low > cvm.value / 2)
        return std::round(SeminalCurve().equivalent(cvm.value));
    return std::round(poisson_kurtosis({.impulses = 1}, {}) / std::abs(stratified_kurtosis(ingredients, {})));
}

} // namespace

Tables figure5(const vulkan::Device& device, const Effort& effort) {
    Table table{"figure5",
                "N,samples,pixels,n_star,seconds,seconds_poisson,seconds_seminal,ratio_quality,ratio_count",
                {}};
    const int bits = effort.picture_bits - 1;
    for (const int n : effort.impulses) {
        Ingredients stratified = recommended;
        stratified.impulses = n;
        table.rows.push_back(
            {fmt::format("{},{},{}", n, effort.samples, 1 << 2 * bits),
             n * (static_cast<double>(effort.samples) +
                  25.0 * static_cast<double>(effort.timings) * std::pow(4, bits)),
             [&device, stratified, effort, bits](std::uint32_t seed) -> Numbers {
                 Ingredients poisson = stratified;
                 poisson.points = Points::poisson;
                 std::vector<Noise> noises;
                 noises.emplace_back(device, stratified);
                 const double n_star =
                     seminal_equivalent(measure_values(noises, effort.samples, seed), stratified);
                 noises.emplace_back(device, poisson);
                 noises.emplace_back(device, Ingredients{.impulses = static_cast<int>(n_star)});
                 const std::vector<double> s = picture_seconds(noises, bits, effort.timings);
                 return {n_star, s[0], s[1], s[2], s[2] / s[0], s[1] / s[0]};
             }});
    }
    return {table};
}

// Figure 6: six lobes of three kernels under a colour map, for the seminal and the recommended noise.

namespace {

// Each real kernel has a lobe on either side of the origin.
std::vector<Noise> six_lobes(const vulkan::Device& device, const Ingredients& ingredients) {
    std::vector<Noise> sum;
    sum.emplace_back(device, ingredients, PlaneWave{2.5, 0.35}, 0.5);
    sum.emplace_back(device, ingredients, PlaneWave{4, 1.4}, 0.3);
    sum.emplace_back(device, ingredients, PlaneWave{6, 2.45}, 0.2);
    return sum;
}

std::vector<float> sum_picture(std::vector<Noise> sum, int bits) {
    constexpr double scale = 80; // makes the thinnest lines of the colour map a few pixels wide
    std::vector<float> total(std::size_t{1} << 2 * bits);
    std::uint32_t seed = 0;
    for (Noise& noise : sum)
        std::ranges::transform(total, picture(noise, bits, ++seed, scale), total.begin(), std::plus<>());
    return total;
}

// Sharp veins on a gradient: small differences in the noise change the picture a lot.
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
    const auto measure = [&device, effort](std::uint32_t seed) {
        std::vector<Noise> noises = six_lobes(device, seminal);
        std::ranges::move(six_lobes(device, recommended), std::back_inserter(noises));
        const std::vector<double> seconds = picture_seconds(noises, effort.picture_bits, effort.timings);
        const double slow = std::accumulate(seconds.begin(), seconds.begin() + 3, 0.0);
        const double fast = std::accumulate(seconds.begin() + 3, seconds.end(), 0.0);
        const std::array sums{std::span(noises).first(3), std::span(noises).last(3)};
        Numbers numbers{slow, fast, slow / fast};
        for (const std::span<Noise>& sum : sums) {
            const statistics::Estimate cvm = measure_values(sum, effort.samples, seed).gaussianity.index();
            numbers.insert(numbers.end(), {cvm.value, cvm.low, cvm.high});
        }
        for (const std::span<Noise>& sum : sums)
            numbers.push_back(measure_windows(sum, effort.windows, seed).contrast().interdecile);
        return numbers;
    };
    const double impulses = 3 * (seminal.impulses + recommended.impulses);
    table.rows.push_back(
        {fmt::format("{},{}", effort.samples, effort.windows),
         impulses * (static_cast<double>(effort.samples) + 256 * static_cast<double>(effort.windows) +
                     static_cast<double>(effort.timings) * std::pow(4, effort.picture_bits)),
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
