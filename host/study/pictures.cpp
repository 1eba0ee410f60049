#include "study/pictures.hpp"

#include "image/exr.hpp"
#include "image/png.hpp"
#include "render/file.hpp"
#include "statistics/estimate.hpp"

#include <cmath>

namespace gabor::study {

namespace {

constexpr double pixels_per_radius = 32;

Grid picture_grid(int bits) {
    return {static_cast<unsigned>(bits), std::ldexp(1 / pixels_per_radius, bits), false};
}

int side_of(std::span<const float> pixels) {
    return static_cast<int>(std::lround(std::sqrt(pixels.size())));
}

} // namespace

std::vector<double> picture_seconds(std::span<Noise> noises, int bits, int timings) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    std::vector<std::vector<double>> seconds(noises.size());
    for (int round = 0; round < timings; ++round)
        for (std::size_t i = 0; i < noises.size(); ++i)
            seconds[i].push_back(noises[i].fill(pixels, picture_grid(bits), 0, 1, 1));
    std::vector<double> medians;
    for (const std::vector<double>& times : seconds)
        medians.push_back(statistics::quantile(times, 0.5));
    return medians;
}

std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    noise.fill(pixels, picture_grid(bits), 0, seed, 1);
    return pixels;
}

void write_exr(const std::filesystem::path& path, std::span<const float> pixels) {
    const int side = side_of(pixels);
    const image::Window window{0, 0, side, side};
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

} // namespace gabor::study
