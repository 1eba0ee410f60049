// Compares pictures of one or several lobes, drawn block by block and pixel by pixel, with the sum of the
// lobes' noises from the double-precision reference.

#include "gabor_fractal.hpp"
#include "largest.hpp"
#include "reference/reference.hpp"
#include "reference/sum.hpp"
#include "render/output/renderer.hpp"
#include "render/request/parameters.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace gabor;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<float> rendered(const vulkan::Device& device, const render::Request& request,
                            const image::Rect& region) {
    render::check(request);
    std::vector<float> pixels;
    render::render_region(device, request, region, [&](std::span<const float> rows) {
        pixels.insert(pixels.end(), rows.begin(), rows.end());
    });
    return pixels;
}

// Returns the noises of a request's lobes, in the request's kernel radii, by the rule documented at
// gabor_noise_lobes and gabor_noise_spread.
std::vector<noise::SpectrumLobe> terms_of(const render::Request& request) {
    std::vector<noise::SpectrumLobe> terms;
    for (std::size_t i = 0; i < request.lobes.size(); ++i) {
        const noise::Lobe& lobe = request.lobes[i];
        const std::uint32_t seed = request.lobes.size() == 1
                                       ? request.seed
                                       : noise::lattice_derived_seed(request.seed, static_cast<int>(i));
        const double angle = noise::radians(lobe.orientation);
        if (lobe.is_one_wave()) {
            terms.push_back({lobe.frequency, angle, lobe.radii(), lobe.power, seed});
            continue;
        }
        // A spread uses the longer of the lobe's own kernel radii as its unit.
        const double unit = std::ranges::max(lobe.radii());
        for (noise::SpectrumLobe term :
             noise::spread_lobes(lobe.frequency * unit, angle, lobe.frequency_spread,
                                 noise::radians(lobe.orientation_spread), seed)) {
            term.frequency /= unit;
            term.radius = lobe.radii();
            term.power *= lobe.power;
            terms.push_back(term);
        }
    }
    return terms;
}

// Returns the position of a pixel, in node spacings or cells, for a noise with these kernel radii.
noise::Place<2> place_of(const render::Request& request, std::array<int, 2> pixel,
                         const noise::Vector<2>& radius) {
    noise::Place<2> place;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double standard = request.recipe.radius, pixels = request.scale * radius[axis];
        const double length = (axis ? request.height : request.width) / pixels; // in kernel radii
        if (request.view.tileable)
            place.period[axis] = static_cast<std::int32_t>(length * standard);
        place.radius[axis] = place.period[axis] ? place.period[axis] / length : standard;
        const double at = (pixel.at(axis) + 0.5) / pixels * place.radius[axis];
        place.cell[axis] = static_cast<std::int32_t>(std::floor(at));
        place.local[axis] = at - std::floor(at);
    }
    place.time = request.evolution - std::floor(request.evolution);
    return place;
}

// Returns a function of a pixel: its noise.
auto expected(const render::Request& request, const std::vector<noise::SpectrumLobe>& terms) {
    double power = 0;
    for (const noise::SpectrumLobe& term : terms)
        power += term.power;
    std::vector<std::function<noise::Field<2>(const noise::Place<2>&)>> noises;
    const auto add = [&](const auto& noise) {
        noises.emplace_back([noise](const noise::Place<2>& place) { return noise.field(place); });
    };
    for (const noise::SpectrumLobe& term : terms) {
        noise::Vector<2> wave = noise::wave_along(term.frequency, term.orientation);
        for (std::size_t axis = 0; axis < 2; ++axis)
            wave[axis] *= term.radius[axis];
        if (request.recipe.is_lattice())
            add(noise::wave_noise(request.recipe.taps, wave, term.seed));
        else
            add(noise::Reference(request.recipe, noise::length(wave), term.orientation, term.seed));
    }
    return [&request, terms, noises, power](int x, int y) {
        noise::Field<2> sum;
        for (std::size_t i = 0; i < terms.size(); ++i)
            sum.add(std::sqrt(terms[i].power / power), noises[i](place_of(request, {x, y}, terms[i].radius)),
                    terms[i].radius);
        return sum;
    };
}

// Compares a region with the reference. The tolerance covers the phase's rounding in single precision and, at
// low frequency, the small values of a sine, which normalization amplifies.
void compare(test::Largest& largest, const vulkan::Device& device, const render::Request& request,
             const image::Rect& region, const std::string& name) {
    const std::vector<noise::SpectrumLobe> terms = terms_of(request);
    const std::vector<float> pixels = rendered(device, request, region);
    const std::vector<std::string> channels = render::channels(request);
    REQUIRE(pixels.size() == channels.size() * static_cast<std::size_t>(region.width * region.height));
    double highest = 0;
    for (const noise::SpectrumLobe& term : terms)
        highest = std::max(highest, term.frequency * std::ranges::max(term.radius));
    const double tolerance =
        1.5e-5 * std::max({1.0, highest / 4, request.recipe.phases == 2 ? 0.1 / highest : 0});
    const double of_slopes = tolerance * (2 * pi * highest + 2);
    const auto expected_at = expected(request, terms);
    auto value = pixels.begin();
    for (int i = 0; i < region.width * region.height; ++i) {
        const int x = region.x + i % region.width;
        const int y = region.y + i / region.width;
        const noise::Field<2> field = expected_at(x, y);
        for (const std::string& channel : channels) {
            const auto see = [&](double wanted, double within) {
                largest.see(*value, wanted, within,
                            [&] { return fmt::format("{} of pixel {}, {}, {}", channel, x, y, name); });
            };
            if (channel == "Y")
                see(field.value.imag(), tolerance);
            else if (channel == "quadrature")
                see(field.value.real(), tolerance);
            else if (channel == "gradient.x")
                see(field.slope[0].imag(), of_slopes);
            else if (channel == "gradient.y")
                see(field.slope[1].imag(), of_slopes);
            else if (channel == "intensity")
                see(std::abs(field.value), tolerance);
            ++value;
        }
    }
}

const std::vector<noise::Lobe> one_wave{{4, 70}};
const std::vector<noise::Lobe> one_spread{{2.5, 20, 0.4, 60}};
const std::vector<noise::Lobe> several{
    {.frequency = 3, .orientation = 20, .power = 2},
    {.frequency = 5, .orientation = -70, .power = 1, .radius = 0.6},
    {.frequency = 1, .orientation_spread = 90, .power = 0.5, .radius = 1.7},
    {.frequency = 9, .power = 0, .radius = 0.9}};
const std::vector<noise::Lobe> stretched{
    {.frequency = 3, .orientation = 20, .orientation_spread = 10, .power = 2, .stretch = 2.5},
    {.frequency = 5, .orientation = -70, .power = 1, .radius = 0.6, .stretch = 2.9},
    {.frequency = 1, .orientation_spread = 90, .power = 0.5, .radius = 1.7, .stretch = 0.7},
    {.frequency = 9, .power = 0, .radius = 0.9}};

} // namespace

TEST_CASE("each pixel equals the reference at its centre, at any scale", "[render]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::recipes()) {
        test::Largest largest;
        // The pixels resolve the frequency at each scale.
        for (const auto& [scale, frequency] :
             {std::pair(2.0, 0.9), std::pair(2.3, 0.001), std::pair(7.77, 2.0), std::pair(31.7, 4.0),
              std::pair(32.0, 0.1), std::pair(500.0, 64.0), std::pair(4096.0, 4.0),
              std::pair(4096.0, 1000.0)}) {
            const render::Request request{.width = 65536,
                                          .height = 65536,
                                          .scale = scale,
                                          .recipe = recipe,
                                          .lobes = {{frequency, 123}},
                                          .seed = 99};
            compare(largest, device, request, {65536 - 70, 65536 - 45, 70, 45},
                    fmt::format("scale {}, frequency {}", scale, frequency));
        }
        largest.check(recipe.name);
    }
}

TEST_CASE("every channel of a picture or a tile is the sum of its lobes' noises, at any time", "[render]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::recipes()) {
        test::Largest largest;
        std::vector<std::vector<noise::Lobe>> cases{one_wave, one_spread,
                                                    recipe.is_lattice() ? stretched : several};
        if (recipe == noise::recipes().front()) { // as many waves as passes/pixels.comp unrolls
            std::vector<noise::Lobe>& sixteen = cases.emplace_back();
            for (int i = 0; i < 16; ++i)
                sixteen.push_back({.frequency = 1 + 0.3 * i, .orientation = 11.0 * i});
        }
        for (const std::vector<noise::Lobe>& lobes : cases) {
            const bool is_wave = lobes == one_wave;
            render::Request far{.width = 65536,
                                .height = 65536,
                                .scale = 17.3,
                                .recipe = recipe,
                                .lobes = lobes,
                                .seed = 77,
                                .gradient = true};
            render::Request tile = far;
            tile.width = 101;
            tile.height = 94;
            tile.evolution = 3.3;
            tile.quadrature = true;
            tile.view.tileable = true;
            for (render::Request& request : {std::ref(far), std::ref(tile)}) {
                const bool is_tile = request == tile;
                if (!is_tile && !is_wave && recipe != noise::recipes().front())
                    continue;
                const image::Rect region = is_tile && is_wave
                                               ? image::Rect{0, 0, 101, 94}
                                               : image::Rect{request.width - 17, request.height - 12, 17, 12};
                for (const bool phasor : {false, true}) { // a phasor is drawn pixel by pixel
                    request.phasor = phasor;
                    CHECK(render::uses_blocks(request, render::viewport_of(request, {})) == !phasor);
                    compare(largest, device, request, region,
                            fmt::format("{}, {}, {} lobes", is_tile ? "tile" : "far",
                                        phasor ? "pixels" : "blocks", lobes.size()));
                }
            }
        }
        largest.check(recipe.name);
    }
}

TEST_CASE("a picture in colour mixes polynomials of its lobes' weighted noises", "[render]") {
    const vulkan::Device device;
    const noise::Colour colour{.weights = {{{{0, 0.8}, {0.3, 0.2}, {-0.1, 0.4}}},
                                           {{{0, 0.5}, {0.1, -0.9}, {0.5, 0.3}}},
                                           {{{0, 0.3}, {-0.2, 0.1}, {0.6, -0.4}}}},
                               .histogram = {{{0.05, 0.9, -0.05, 0.02, 0.003, 0.001},
                                              {0, 1, 0, 0, 0, 0},
                                              {-0.1, 0.8, 0.1, 0.05, -0.004, 0.002}}},
                               .mean = {0.5, 0.4, 0.3},
                               .mixing = {{{0.2, 0.05, -0.03}, {0.15, -0.1, 0.02}, {0.1, 0.02, 0.08}}}};
    for (const noise::Recipe* recipe : {&noise::recipes().front(), &noise::sparse_recipes().front()}) {
        test::Largest largest;
        for (const bool tileable : {false, true}) {
            render::Request request{.width = 94,
                                    .height = 101,
                                    .scale = 17.3,
                                    .recipe = *recipe,
                                    .lobes = {several[0], several[1], {.frequency = 1, .radius = 1.7}},
                                    .seed = 77};
            request.view.tileable = tileable;
            request.colour = colour;
            REQUIRE(render::uses_blocks(request, render::viewport_of(request, {})));
            const image::Rect region{43, 50, 17, 12};
            std::vector<float> blocks = rendered(device, request, region);
            std::vector<float> pixels;
            render::Viewport one_by_one = render::viewport_of(request, region);
            one_by_one.blocks = render::Blocks::none;
            render::render_plan(
                device, render::Renderer(device, render::plan(request, one_by_one)),
                [&](std::span<const float> rows) { pixels.insert(pixels.end(), rows.begin(), rows.end()); });
            REQUIRE(blocks.size() == 3u * 17 * 12);
            REQUIRE(pixels.size() == blocks.size());
            std::vector<decltype(expected(request, {}))> terms;
            for (const noise::SpectrumLobe& term : terms_of(request))
                terms.push_back(expected(request, {term}));
            for (int i = 0; i < region.width * region.height; ++i) {
                const int x = region.x + i % region.width;
                const int y = region.y + i / region.width;
                std::array<double, 3> components{};
                for (std::size_t lobe = 0; lobe < terms.size(); ++lobe) {
                    const std::complex<double> noise = terms[lobe](x, y).value;
                    for (std::size_t c = 0; c < 3; ++c)
                        components[c] += colour.weights[lobe][c].quadrature * noise.real() +
                                         colour.weights[lobe][c].noise * noise.imag();
                }
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    double value = colour.mean[channel];
                    for (std::size_t c = 0; c < 3; ++c)
                        for (std::size_t n = 0; n < 6; ++n)
                            value += colour.mixing[channel][c] * colour.histogram[c][n] *
                                     std::pow(components[c], static_cast<double>(n));
                    for (const std::vector<float>* picture : {&blocks, &pixels})
                        largest.see((*picture)[3 * static_cast<std::size_t>(i) + channel], value, 2e-5, [&] {
                            return fmt::format("channel {} of pixel {}, {}, {}, {}", channel, x, y,
                                               picture == &blocks ? "blocks" : "pixels",
                                               tileable ? "tile" : "plane");
                        });
                }
            }
        }
        largest.check(fmt::format("{} in colour", recipe->name));
    }
}

TEST_CASE("colour pictures of noise in space mix the values of grey ones", "[render]") {
    const vulkan::Device device;
    const image::Rect region{0, 0, 90, 60};
    const double share = std::sqrt(2 / 3.0); // weight of the first lobe, which has two thirds of the variance
    const double rest = std::sqrt(1 / 3.0);
    const noise::Colour colour{.weights = {{{{0, share}, {share, 0}, {0.6 * share, 0.8 * share}}},
                                           {{{0, rest}, {rest, 0}, {0.6 * rest, 0.8 * rest}}}},
                               .histogram = {{{0, 1, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}}},
                               .mean = {0.5, 0, 0},
                               .mixing = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    const std::pair<const char*, render::View> views[]{
        {"slice", {.projection = render::Projection::slice, .depth = 2.7}},
        {"sphere", {.projection = render::Projection::sphere}},
        {"solid torus", {.projection = render::Projection::torus, .solid = true}}};
    for (const auto& [name, view] : views) {
        for (const bool filter : {false, true}) {
            render::Request request{.width = 90,
                                    .height = 60,
                                    .scale = 17.3,
                                    .lobes = {several[0], several[1]},
                                    .seed = 77,
                                    .evolution = 0.3,
                                    .view = view,
                                    .filter = filter,
                                    .quadrature = true};
            const std::vector<float> grey = rendered(device, request, region); // noise, quadrature, coverage
            request.quadrature = false;
            request.colour = colour;
            CHECK_NOTHROW(render::check(request));
            const std::vector<float> colours =
                rendered(device, request, region); // red, green, blue, coverage
            REQUIRE(grey.size() == 3u * 90 * 60);
            REQUIRE(colours.size() == 4u * 90 * 60);
            test::Largest largest;
            for (std::size_t i = 0; i < 90u * 60; ++i) {
                const double y = grey[3 * i];
                const double q = grey[3 * i + 1];
                const double coverage = grey[3 * i + 2];
                const auto law = [](double z) { return std::clamp(z, -4.0, 4.0); };
                std::array expected{0.5 + law(y), law(q), law(0.6 * q + 0.8 * y), coverage};
                if (coverage == 0) // the pixel misses the body
                    expected.fill(0);
                for (std::size_t c = 0; c < 4; ++c)
                    largest.see(colours[4 * i + c], expected[c], 5e-6,
                                [&] { return fmt::format("channel {} of pixel {}", c, i); });
            }
            largest.check(fmt::format("{}{} in colour", filter ? "filtered " : "", name));
        }
    }
}

TEST_CASE("filtered colours of noise in space keep their mean", "[render]") {
    const vulkan::Device device;
    render::Request request{.width = 96,
                            .height = 96,
                            .scale = 2,
                            .seed = 77,
                            .view = {.projection = render::Projection::slice, .depth = 2.7},
                            .filter = true};
    request.lobes.front().frequency = 0.3;
    const std::vector<float> grey = rendered(device, request, {0, 0, 96, 96});
    request.colour =
        noise::Colour{.weights = {{{{0, 1}, {1, 0}, {0.6, 0.8}}}},
                      .histogram = {{{0, 0, 1, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}}},
                      .mean = {0, 0, 0},
                      .mixing = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    const std::vector<float> colours = rendered(device, request, {0, 0, 96, 96});
    double square = 0;
    std::array<double, 3> mean{};
    for (std::size_t i = 0; i < 96u * 96; ++i) {
        square += double{grey[2 * i]} * double{grey[2 * i]} / (96 * 96);
        for (std::size_t c = 0; c < 3; ++c)
            mean[c] += double{colours[4 * i + c]} / (96 * 96);
    }
    fmt::print("variance {:.2f} of the filtered noise, means of z^2 and z^4 {:.3f} {:.3f} {:.3f}\n", square,
               mean[0], mean[1], mean[2]);
    CHECK(square < 0.8);
    CHECK(mean[0] == Approx(1).margin(0.06));
    CHECK(mean[1] == Approx(1).margin(0.06));
    CHECK(mean[2] == Approx(3).margin(0.4));
}

TEST_CASE("bands begin small and grow slowly, so that work can end soon", "[render]") {
    const vulkan::Device device;
    for (const char* view : {"flat", "ocean"}) {
        INFO(view);
        render::Request request{.width = 400, .height = 300, .seed = 1};
        render::set(request, "view", std::string(view));
        const std::size_t channels = render::channels(request).size();
        std::vector<std::size_t> bands; // their pixels
        std::vector<float> pixels;
        render::render_region(device, request, {0, 0, 400, 300}, [&](std::span<const float> values) {
            bands.push_back(values.size() / channels);
            pixels.insert(pixels.end(), values.begin(), values.end());
        });
        CHECK(bands.size() > 2);
        std::size_t most = 1 << 14;
        for (const std::size_t band : bands) {
            CHECK(band <= most);
            most = 4 * band;
        }
        // However it is cut, the picture is the same.
        std::vector<float> rows;
        for (int y = 0; y < 300; y += 100) {
            const std::vector<float> part = rendered(device, request, {0, y, 400, 100});
            rows.insert(rows.end(), part.begin(), part.end());
        }
        CHECK(pixels == rows);
    }
}

TEST_CASE("an exception from the sink stops rendering", "[render]") {
    const vulkan::Device device;
    const render::Request request{.width = 4096, .height = 8192, .seed = 1};
    int bands = 0;
    const auto sink = [&](std::span<const float>) {
        if (++bands == 2)
            throw 7;
    };
    CHECK_THROWS_AS(render::render_region(device, request, {0, 0, 4096, 8192}, sink), int);
    CHECK(bands == 2);
}

TEST_CASE("a filtered spectrum is the sum of its filtered lobes", "[render]") {
    const vulkan::Device device;
    for (const bool horizon : {false, true}) {
        render::Request request{
            .width = 40, .height = 40, .scale = 5, .lobes = stretched, .seed = 3, .filter = true};
        if (horizon)
            request.view.projection = render::Projection::horizon;
        const std::vector<float> pixels = rendered(device, request, {0, 0, 40, 40});
        const noise::Sum<2> spectrum = noise::spectrum(terms_of(request));
        double squares = 0;
        test::Largest removed;
        int count = 0;
        for (int y = horizon ? 20 : 1; y < 40; y += 6) {
            for (int x = 2; x < 40; x += 13) {
                noise::Vector<2> at{(x + 0.5) / 5, (y + 0.5) / 5}, dx{0.2, 0}, dy{0, 0.2};
                if (horizon) { // the horizon is in row 10
                    const double rows = y + 0.5 - 10;
                    const double near = (40 - 0.5 - 10) / 5.0 / rows;
                    at = {near * (x + 0.5 - 20), -near * 40};
                    dx = {near, 0};
                    dy = {-near / rows * (x + 0.5 - 20), near / rows * 40};
                }
                const float* pixel = &pixels[static_cast<std::size_t>(y * 40 + x) * 2];
                noise::Place<2> place;
                place.local = noise::scaled(1.5, at);
                squares += std::pow(pixel[0] - spectrum.filtered(place, dx, dy).value.imag(), 2);
                removed.see(pixel[1], spectrum.removed(place, dx, dy), 0.01,
                            [&] { return fmt::format("pixel {}, {}", x, y); });
                ++count;
            }
        }
        const double error = std::sqrt(squares / count);
        fmt::print("filtered{}: RMSE {:.4f} over {} pixels\n", horizon ? ", horizon" : "", error, count);
        CHECK(count > 10);
        CHECK(error < 0.02);
        removed.check("removed variance");
    }
}

// The C++ translation, which tests/functions compares with the double-precision reference.
TEST_CASE("fractal noise is that of the drop-in at the centre of each pixel", "[render]") {
    const vulkan::Device device;
    test::Largest values, slopes, removed;
    int seen = 0;
    for (const auto& [shape, basis, options] : {std::tuple{"fbm", "smooth", 0},
                                                {"billow", "smooth", 1},
                                                {"ridged", "perlin", 2},
                                                {"fbm", "perlin", 3}}) {
        render::Request request{.width = 96, .height = 80, .scale = 20, .seed = 7, .gradient = true};
        const bool tile = options == 1, filter = options >= 2;
        render::set(request, "fractal", std::string(shape));
        render::set(request, "fractal.basis", std::string(basis));
        render::set(request, "fractal.octaves", 3.5 + options);
        render::set(request, "fractal.gain", 0.6);
        render::set(request, "fractal.lacunarity", 1.8);
        render::set(request, "fractal.turn", 25.0);
        render::set(request, "evolution", 0.2 * options);
        request.fractal.warp = options == 3 ? 0.3 : 0;
        request.view.tileable = tile;
        request.filter = filter;
        const std::vector<float> pixels = rendered(device, request, {0, 0, 96, 80});
        const std::size_t channels = render::channels(request).size();
        REQUIRE(channels == (filter ? 4u : 3u));
        GaborFractal fractal(
            static_cast<float>(3.5 + options), 0.6f, 1.8f, static_cast<float>(noise::radians(25.0)),
            std::string(basis) == "perlin" ? GABOR_PERLIN : GABOR_SMOOTH, request.fractal.shape - 1);
        for (int y = 0; y < 80; y += 3)
            for (int x = 0; x < 96; x += 3) {
                const gabor_vec2 p((static_cast<float>(x) + 0.5f) / 20, (static_cast<float>(y) + 0.5f) / 20);
                gabor_vec2 dx(filter ? 0.05f : 0.0f, 0), dy(0, filter ? 0.05f : 0.0f);
                GaborPlace place = tile ? gabor_place_tiled(p, gabor_vec2(4.8f, 4.0f)) : gabor_place_at(p);
                place.evolution = static_cast<float>(0.2 * options);
                GaborWarp warp{place, gabor_vec2(1, 0), gabor_vec2(0, 1), gabor_vec3(0, 0, 0)};
                if (options == 3)
                    warp = gabor_warp_filtered(place, dx, dy, 0.3f, fractal, gabor_derived_seed(7u, 0));
                const GaborFractalNoise expected =
                    filter ? gabor_fractal_noise_filtered(warp.place, dx.x * warp.dx + dx.y * warp.dy,
                                                          dy.x * warp.dx + dy.y * warp.dy, fractal, 7u)
                           : gabor_fractal_noise(warp.place, fractal, 7u);
                const float* pixel = &pixels[static_cast<std::size_t>(y * 96 + x) * channels];
                const auto here = [&, at = std::array{x, y}] {
                    return fmt::format("{}, {} of {}", at[0], at[1], options);
                };
                values.see(pixel[0], expected.noise, 1e-4, here);
                const auto along = [&](gabor_vec2 step) {
                    return expected.gradient.x * step.x + expected.gradient.y * step.y;
                };
                // the gradient of |n| jumps where n is 0
                if (options == 0 || options == 3) {
                    slopes.see(pixel[1], along(warp.dx), 5e-3, here);
                    slopes.see(pixel[2], along(warp.dy), 5e-3, here);
                }
                if (filter)
                    removed.see(pixel[3], expected.removed, 1e-4, here);
                ++seen;
            }
    }
    CHECK(seen == 4 * 27 * 32);
    values.check("values");
    slopes.check("slopes");
    removed.check("removed");
}
