// Compares each material's filtered form with the average of many sharp samples.

#include "gabor_lattice.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_materials.hpp"

#include "error.hpp"
#include "largest.hpp"
#include "render/load.hpp"
#include "render/material.hpp"
#include "render/parameters.hpp"
#include "render/renderer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace gabor;
using render::Request;

namespace {

constexpr std::size_t channels = 6; // of GaborMaterial
constexpr std::size_t height_channel = 3;

struct Material {
    std::string_view name;
    GaborMaterial (*sharp)(gabor_vec2 p, std::uint32_t seed);
    GaborMaterial (*filtered)(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed);
};

const Material materials[]{{"wood", gabor_wood, gabor_wood_filtered},
                           {"fabric", gabor_fabric, gabor_fabric_filtered},
                           {"leather", gabor_leather, gabor_leather_filtered},
                           {"marble", gabor_marble, gabor_marble_filtered},
                           {"sand", gabor_sand, gabor_sand_filtered},
                           {"ripples", gabor_ripples, gabor_ripples_filtered},
                           {"brushed-metal", gabor_brushed_metal, gabor_brushed_metal_filtered},
                           {"scratches", gabor_scratches, gabor_scratches_filtered},
                           {"zebra", gabor_zebra, gabor_zebra_filtered},
                           {"bark", gabor_bark, gabor_bark_filtered},
                           {"carbon-fibre", gabor_carbon_fibre, gabor_carbon_fibre_filtered},
                           {"strata", gabor_strata, gabor_strata_filtered}};

// Draws a square of `units` with `side` pixels, by the translation of the drop-ins to C++.
std::vector<float> drawn(const Material& material, bool filtered, int side, double units) {
    const float step = static_cast<float>(units / side);
    std::vector<float> pixels;
    for (int i = 0; i < side * side; ++i) {
        const gabor_vec2 p((static_cast<float>(i % side) + 0.5f) * step,
                           (static_cast<float>(i / side) + 0.5f) * step);
        const GaborMaterial m = filtered ? material.filtered(p, gabor_vec2(step, 0), gabor_vec2(0, step), 7)
                                         : material.sharp(p, 7);
        pixels.insert(pixels.end(), {m.colour.x, m.colour.y, m.colour.z, m.height, m.roughness, m.metalness});
    }
    return pixels;
}

// Blurs one channel with a normal filter of half a pixel, for pixels `block` times as large.
class Blurred {
  public:
    Blurred(const std::vector<float>& picture, int side, int block, std::size_t channel)
        : side_(side), block_(block), reach_(2 * block), rows_(picture.size() / channels) {
        std::vector<double> values(rows_.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<double>(picture[i * channels + channel]);
        for (int y = 0; y < side; ++y)
            for (int x = reach_; x < side - reach_; ++x)
                rows_[at(x, y)] = weighted([&](int i) { return values[at(x + i, y)]; });
    }

    // At the middle of large pixel (x, y).
    double operator()(int x, int y) const {
        const auto column = [&](int i) {
            return weighted([&](int j) { return rows_[at(i, y * block_ + block_ / 2 + j)]; });
        };
        return (column(x * block_ + block_ / 2 - 1) + column(x * block_ + block_ / 2)) / 2;
    }

  private:
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * side_ + x); }

    template <typename Value>
    double weighted(Value value) const {
        double sum = 0;
        double weights = 0;
        for (int i = -reach_; i <= reach_; ++i) {
            const double weight = std::exp(-0.5 * std::pow(2.0 * i / block_, 2));
            sum += weight * value(i);
            weights += weight;
        }
        return sum / weights;
    }

    int side_, block_, reach_;
    std::vector<double> rows_;
};

double mean_of(const std::vector<float>& picture, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < picture.size(); i += channels)
        sum += static_cast<double>(picture[i]);
    return sum * static_cast<double>(channels) / static_cast<double>(picture.size());
}

double deviation_of(const std::vector<float>& picture, std::size_t channel) {
    const double mean = mean_of(picture, channel);
    double sum = 0;
    for (std::size_t i = channel; i < picture.size(); i += channels)
        sum += std::pow(static_cast<double>(picture[i]) - mean, 2);
    return std::sqrt(sum * static_cast<double>(channels) / static_cast<double>(picture.size()));
}

void compare(const Material& material) {
    INFO(material.name);
    // Pixels of 1/64 unit, each from 16 x 16 samples.
    constexpr int side = 256;
    constexpr int block = 16;
    constexpr int large = side / block;
    const std::vector<float> sharp = drawn(material, false, side, 0.25);
    const std::vector<float> filtered = drawn(material, true, large, 0.25);
    for (const std::vector<float>& picture : {sharp, filtered})
        for (std::size_t i = 0; i < picture.size(); i += channels) {
            for (std::size_t k = 0; k < channels; ++k)
                REQUIRE(std::isfinite(picture[i + k]));
            for (const std::size_t k : {0u, 1u, 2u, 4u, 5u})
                REQUIRE((picture[i + k] >= 0 && picture[i + k] <= 1));
        }

    // Far away: pixels of half a unit against sharp samples over the same area, out of step with the weaves.
    constexpr double units = 15.7;
    const std::vector<float> samples = drawn(material, false, side, units);
    const std::vector<float> far = drawn(material, true, 32, units);
    for (const std::size_t channel : {std::size_t{0}, std::size_t{1}, std::size_t{2}, height_channel}) {
        const double contrast = deviation_of(samples, channel);
        if (contrast == 0)
            continue;
        const Blurred brute(sharp, side, block, channel);
        double square = 0;
        int points = 0;
        for (int y = 2; y < large - 2; ++y)
            for (int x = 2; x < large - 2; ++x, ++points)
                square +=
                    std::pow(static_cast<double>(
                                 filtered[static_cast<std::size_t>(y * large + x) * channels + channel]) -
                                 brute(x, y),
                             2);
        const double error = std::sqrt(square / points) / contrast;
        const double mean = (mean_of(far, channel) - mean_of(samples, channel)) / contrast;
        fmt::print("  {:<14} {:<7} contrast {:.4f}, in it: error {:.3f} in {} pixels, far mean {:+.4f}, left "
                   "far {:.3f}\n",
                   material.name, render::material_channels[channel], contrast, error, points, mean,
                   deviation_of(far, channel) / contrast);
        // Seed 7 reaches 0.353 (scratches) and 0.0325 (fabric). The error depends on the seed: seeds 1 to 8
        // reach 0.55 in scratches (on average 0.38) and 0.038 in fabric (on average 0.028).
        CHECK(error < 0.38);
        CHECK((channel == height_channel || error * contrast < 0.036));
        CHECK(std::abs(mean) < 0.05);
    }
}

} // namespace

TEST_CASE("every material as a pixel sees it is the mean of what it covers", "[material]") {
    CHECK(std::ranges::equal(materials, render::materials, {}, &Material::name));
    for (const Material& material : materials)
        compare(material);
}

TEST_CASE("a picture of a material is its function at each pixel", "[material]") {
    const vulkan::Device device;
    const Material& sand = materials[4];
    constexpr int side = 48;
    for (const bool filter : {false, true}) {
        const Request request{.width = side,
                              .height = side,
                              .scale = 20,
                              .seed = 7,
                              .material = std::string(sand.name),
                              .filter = filter};
        render::check(request);
        std::vector<float> pixels;
        render::render_region(device, request, {0, 0, side, side}, [&](std::span<const float> rows) {
            pixels.insert(pixels.end(), rows.begin(), rows.end());
        });
        const std::vector<float> expected = drawn(sand, filter, side, side / request.scale);
        constexpr std::size_t all = render::material_channels.size();
        REQUIRE(pixels.size() / all == expected.size() / channels);
        test::Largest largest;
        for (std::size_t i = 0; i < expected.size(); ++i)
            largest.see(pixels[i / channels * all + i % channels], expected[i], 1e-5,
                        [&] { return fmt::format("channel {} of pixel {}", i % channels, i / channels); });
        largest.check(filter ? "filtered sand" : "sand");
    }
}

TEST_CASE("materials have presets of their names", "[material]") {
    for (const std::string_view material : render::materials) {
        const Request request = render::preset(material);
        CHECK(request.material == material);
        CHECK(request.filter);
    }
}

TEST_CASE("beside a material there is no noise", "[material]") {
    const auto refused = [](Request request, const char* words) {
        CHECK_THROWS_WITH(render::check(request), Catch::Contains(words));
    };
    refused({.material = "plastic"}, "material 'plastic': it takes none, wood, fabric");
    refused({.lobes = {{.frequency = 3}}, .material = "wood"}, "frequency conflicts with material wood");
    refused({.material = "wood", .gradient = true}, "gradient conflicts with material wood");
    refused({.view = render::Slice{}, .material = "wood"}, "materials lie on planes and bodies");
    Request request{.time = 0.5, .material = "sand"};
    render::drop_conflicting(request, "material");
    CHECK(request == Request{.material = "sand"});
    request.phasor = true;
    render::drop_conflicting(request, "phasor");
    CHECK(request == Request{.phasor = true});
}
