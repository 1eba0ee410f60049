// Compares each material's filtered form with the average of many sharp samples, its tiles with each other,
// and its pictures with its function.

#include "gabor_noise.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_fractal.hpp"

#include "gabor_materials.hpp"

#include "golden/file.hpp"
#include "largest.hpp"
#include "render/output/renderer.hpp"
#include "render/request/load.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"

#include <boost/math/distributions/normal.hpp>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <vector>

using namespace gabor;
using render::Request;

namespace {

constexpr std::size_t channels = passes::material_lit; // the channels of GaborMaterial
constexpr std::size_t height_channel = passes::material_height;

// A point or, if dx or dy is not 0, a pixel to filter for.
struct Pixel {
    gabor_vec2 p;
    gabor_vec2 dx{};
    gabor_vec2 dy{};
    gabor_vec2 period{};
};

// A material that takes its parameters as an array of numbers, in the order of its struct.
struct Material {
    std::string_view name;
    std::vector<float> (*by_default)();
    GaborMaterial (*at)(const Pixel& pixel, const std::vector<float>& numbers, std::uint32_t seed);
};

template <typename T, T (*by_default)(), GaborMaterial (*at)(gabor_vec2, gabor_vec2, T, std::uint32_t),
          GaborMaterial (*filtered)(gabor_vec2, gabor_vec2, gabor_vec2, gabor_vec2, T, std::uint32_t)>
constexpr Material made(std::string_view name) {
    return {name,
            [] {
                const T parameters = by_default();
                std::vector<float> numbers(sizeof(T) / sizeof(float));
                std::memcpy(numbers.data(), &parameters, sizeof(T));
                return numbers;
            },
            [](const Pixel& pixel, const std::vector<float>& numbers, std::uint32_t seed) {
                T parameters;
                std::memcpy(&parameters, numbers.data(), sizeof(T));
                const auto& [p, dx, dy, period] = pixel;
                return dx.x != 0 || dy.y != 0 ? filtered(p, dx, dy, period, parameters, seed)
                                              : at(p, period, parameters, seed);
            }};
}

#define GABOR_MATERIAL(function, Parameters, name)                                                           \
    made<Parameters, gabor_##function##_default, gabor_##function##_at, gabor_##function##_filtered_at>(name),
const Material materials[]{
#include "render/request/material_rows.inc"
};
#undef GABOR_MATERIAL

Request request_of(std::string_view material) {
    return {.kind = render::Kind::material, .material = std::string(material)};
}

// Returns the parameters of a request's material as packed numbers, without the padding of a GPU buffer.
std::vector<float> numbers_of(const Request& request) {
    std::vector<float> numbers;
    for (const render::Parameter& p : render::parameters()) {
        const auto value = p.group == render::Parameter::Group::material ? p.get(request) : std::nullopt;
        if (!value)
            continue;
        if (const auto* colour = std::get_if<std::array<double, 3>>(&*value))
            for (const double part : *colour)
                numbers.push_back(static_cast<float>(part));
        else
            numbers.push_back(static_cast<float>(p.type == render::Parameter::Type::angle
                                                     ? noise::radians(std::get<double>(*value))
                                                     : std::get<double>(*value)));
    }
    return numbers;
}

// Sets every parameter of the material to a random value; colours are dark, so that no shade of them
// exceeds 1.
void randomize(Request& request, std::mt19937& random) {
    const auto unit = [&] {
        return static_cast<double>(random()) * 0x1p-32;
    }; // the same numbers with every standard library
    for (const render::Parameter& p : render::parameters()) {
        if (p.group != render::Parameter::Group::material || !p.get(request))
            continue;
        const auto [low, high] = p.range;
        const double share = unit();
        if (p.type == render::Parameter::Type::colour)
            p.place.put(request, std::array{0.02 + 0.3 * share, 0.02 + 0.3 * unit(), 0.02 + 0.3 * unit()});
        else
            p.place.put(request, low > 0 ? low * std::pow(high / low, share) : low + share * (high - low));
    }
}

std::array<float, channels> values_of(const GaborMaterial& m) {
    return {m.colour.x, m.colour.y, m.colour.z, m.height, gabor_roughness(m), m.metalness};
}

// Draws a square, `units` wide, in `side` x `side` pixels, using the translation of the drop-ins to C++.
std::vector<float> drawn(const Material& material, const std::vector<float>& numbers, bool filtered,
                         bool tiled, int side, double units, std::uint32_t seed) {
    const float step = static_cast<float>(units / side);
    std::vector<float> pixels;
    for (int i = 0; i < side * side; ++i) {
        const gabor_vec2 p((static_cast<float>(i % side) + 0.5f) * step,
                           (static_cast<float>(i / side) + 0.5f) * step);
        Pixel pixel{p};
        if (filtered)
            pixel = {p, gabor_vec2(step, 0), gabor_vec2(0, step)};
        if (tiled)
            pixel.period = gabor_vec2(static_cast<float>(side) * step);
        const auto values = values_of(material.at(pixel, numbers, seed));
        pixels.insert(pixels.end(), values.begin(), values.end());
    }
    return pixels;
}

bool is_in_range(const std::array<float, channels>& values) {
    for (std::size_t c = 0; c < channels; ++c)
        if (!std::isfinite(values[c]) || (c != height_channel && (values[c] < 0 || values[c] > 1)))
            return false;
    return true;
}

// Compares filtered pixels of 1/64 unit at random points with the mean of sharp samples under a normal
// density with a standard deviation of half a pixel.
void compare(const Material& material, const std::vector<float>& numbers) {
    INFO(material.name);
    constexpr int places = 1000, strata = 12, samples = strata * strata;
    constexpr float side = 1 / 64.0f;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(0, 30);
    std::uniform_real_distribution<double> unit(1e-9, 1);
    const auto offset = [&](int stratum) {
        return side / 2 *
               static_cast<float>(quantile(boost::math::normal(), (stratum + unit(random)) / strata));
    };
    std::array<double, channels> sum{}, square{}, error{};
    int wrong = 0;
    for (int i = 0; i < places; ++i) {
        const gabor_vec2 p(place(random), place(random));
        const auto seed = static_cast<std::uint32_t>(random());
        std::array<double, channels> mean{};
        for (int k = 0; k < samples; ++k) {
            const gabor_vec2 at(p.x + offset(k % strata), p.y + offset(k / strata));
            const auto sharp = values_of(material.at({at}, numbers, seed));
            wrong += !is_in_range(sharp);
            for (std::size_t c = 0; c < channels; ++c) {
                const double value = static_cast<double>(sharp[c]);
                mean[c] += value / samples;
                sum[c] += value / (places * samples);
                square[c] += value * value / (places * samples);
            }
        }
        const auto filtered =
            values_of(material.at({p, gabor_vec2(side, 0), gabor_vec2(0, side)}, numbers, seed));
        wrong += !is_in_range(filtered);
        for (std::size_t c = 0; c < channels; ++c)
            error[c] += std::pow(static_cast<double>(filtered[c]) - mean[c], 2) / places;
    }
    CHECK(wrong == 0);
    for (std::size_t c = 0; c <= height_channel; ++c) {
        const double contrast = std::sqrt(square[c] - sum[c] * sum[c]), rms = std::sqrt(error[c]);
        fmt::print("  {:<14} {:<7} contrast {:.4f}, error {:.4f}, {:.3f} of the contrast\n", material.name,
                   render::material_channels[c], contrast, rms, rms / contrast);
        CHECK(rms < 0.38 * contrast);
        CHECK((c == height_channel || rms < 0.038));
    }
}

} // namespace

TEST_CASE("every filtered material is close to the mean over its pixel", "[material]") {
    CHECK(std::ranges::equal(materials, render::materials, {}, &Material::name));
    for (const Material& material : materials)
        compare(material, material.by_default());
}

TEST_CASE("materials with random parameters have this version's golden values", "[material]") {
    std::mt19937 random(2);
    test::Rows rows;
    int lost = 0;
    bool clamped = true;
    for (int point = 0; point < test::Rows::points; ++point) {
        rows.begin(point);
        const auto unit = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
        const gabor_vec2 p{30 * unit(), 30 * unit()};
        const gabor_vec2 dx{0.03f * unit(), 0.01f}, dy{-0.01f, 0.03f * unit()};
        const float turn = static_cast<float>(point);
        const gabor_vec2 period{6 + 5.5f * std::sin(turn), 6 + 5.5f * std::sin(2 * turn + 1)};
        for (const Material& material : materials) {
            Request request = request_of(material.name);
            randomize(request, random);
            const auto see = [&](std::string_view form, const Pixel& pixel) {
                const GaborMaterial found =
                    material.at(pixel, numbers_of(request), static_cast<std::uint32_t>(point));
                lost += form == "sharp" && (found.lost.x != 0 || found.lost.y != 0 || found.lost.z != 0);
                double sum = 0;
                for (const float value : values_of(found))
                    sum = 0.8 * sum + static_cast<double>(value); // each channel has a different weight
                rows.see(fmt::format("{} {}", form, material.name), sum);
                const auto& [x, y, mixed] = found.lost;
                const float slopes = found.slope.x + 0.7f * found.slope.y + x + 0.7f * y - 0.5f * mixed;
                rows.see(fmt::format("slopes of {} {}", form, material.name),
                         std::asinh(static_cast<double>(slopes))); // some are hundreds
            };
            see("sharp", {p});
            see("filtered", {p, dx, dy});
            see("tiled", {p, {}, {}, period});
            see("filtered tiled", {p, dx, dy, period});
            double defaults = 0;
            for (const float number : material.by_default())
                defaults = 0.8 * defaults + static_cast<double>(number);
            rows.see(fmt::format("defaults of {}", material.name), defaults);
            for (const render::Parameter& parameter :
                 render::parameters()) // the brightest colours are clamped
                if (parameter.type == render::Parameter::Type::colour && parameter.get(request))
                    parameter.place.put(request, std::array{1.0, 1.0, 1.0});
            for (const Pixel& pixel : {Pixel{p}, Pixel{p, dx, dy}})
                clamped &= is_in_range(
                    values_of(material.at(pixel, numbers_of(request), static_cast<std::uint32_t>(point))));
        }
    }
    CHECK(rows.compare(GABOR_GOLDEN_FOLDER "/material_parameters.txt", 2e-4, 2e-4));
    CHECK(clamped);
    CHECK(lost == 0); // without a filter, nothing is lost, not even by rounding
}

TEST_CASE("cords of filtered fabric are close to their mean over a pixel", "[material]") {
    Request request = request_of("fabric");
    for (const auto& [name, number] : {std::pair("threads", 60.0), {"relief", 2.0}, {"cords", 20.0}})
        render::set(request, fmt::format("fabric.{}", name), number);
    compare(materials[1], numbers_of(request));
}

// The amplitude of the fundamental wave of the profile 1 - cos(pi x)^4 is half the cords' height.
TEST_CASE("corduroy has five cords per unit", "[material]") {
    constexpr int side = 256;
    constexpr int units = 4;
    const Request request = render::preset("corduroy");
    const auto number = [&](const char* name) {
        return std::get<double>(*render::parameter(fmt::format("fabric.{}", name)).get(request));
    };
    REQUIRE(number("cords") == 5);
    const std::vector<float> picture = drawn(materials[1], numbers_of(request), true, false, side, units, 1);
    double amplitude = 0;
    for (std::size_t y = 0; y < side; ++y) {
        std::complex<double> wave;
        for (std::size_t x = 0; x < side; ++x)
            wave += std::polar(2.0 / side, 2 * std::numbers::pi * 5 * units * static_cast<double>(x) / side) *
                    static_cast<double>(picture[(y * side + x) * channels + height_channel]);
        amplitude += std::abs(wave) / side;
    }
    CHECK(amplitude == Approx(0.5 * 0.3 * number("relief") / 5).epsilon(0.1));
}

TEST_CASE("a huge pixel has the mean colour, whatever the parameters", "[material]") {
    const char* given = std::getenv("GABOR_MATERIAL_SETTINGS"); // 100 settings took six minutes
    const int settings = given ? std::atoi(given) : 2;
    constexpr int samples = 100'000;
    std::mt19937 random(7);
    for (const Material& material : materials) {
        INFO(material.name);
        double largest = 0;
        double largest_error = 0;
        for (int i = 0; i < settings;) {
            Request request = request_of(material.name);
            if (i > 0) // the first settings are the defaults
                randomize(request, random);
            const std::vector<float> numbers = numbers_of(request);
            std::uniform_real_distribution<float> place(0, 3000);
            std::array<double, 3> sum{}, square{};
            bool clamped = false; // whether these random settings clamp a colour
            for (int k = 0; k < samples && !clamped; ++k) {
                const Pixel pixel{gabor_vec2(place(random), place(random))};
                const auto values =
                    values_of(material.at(pixel, numbers, static_cast<std::uint32_t>(random())));
                for (std::size_t c = 0; c < 3; ++c) {
                    const double value = static_cast<double>(values[c]);
                    clamped |= i > 0 && value >= 1;
                    sum[c] += value;
                    square[c] += value * value;
                }
            }
            if (clamped)
                continue;
            ++i;
            const auto far = values_of(
                material.at({gabor_vec2(3, 4), gabor_vec2(3000, 0), gabor_vec2(0, 3000)}, numbers, 7));
            for (std::size_t c = 0; c < 3; ++c) {
                const double mean = sum[c] / samples;
                const double error = std::sqrt((square[c] / samples - mean * mean) / samples) / mean;
                const double off = std::abs(static_cast<double>(far[c]) / mean - 1);
                if (off > largest) {
                    largest = off;
                    largest_error = error;
                }
                INFO(render::to_json(request));
                CHECK(off < 0.01 + 3 * error);
            }
        }
        fmt::print(
            "  {:<14} {} settings: the mean colour is off by at most {:.2f} % (standard error {:.2f} %)\n",
            material.name, settings, 100 * largest, 100 * largest_error);
    }
}

TEST_CASE("every material repeats after its period without a seam", "[material]") {
    const gabor_vec2 period(8, 4);
    constexpr float near = 0.001953125f;
    std::mt19937 random(5);
    for (const Material& material : materials)
        for (const bool filter : {false, true}) {
            Request request = request_of(material.name);
            randomize(request, random);
            const std::vector<float> numbers = numbers_of(request);
            const auto at = [&](float x, float y) {
                const gabor_vec2 p(x, y);
                const gabor_vec2 dx(filter ? 0.01f : 0, 0), dy(0, dx.x);
                return values_of(material.at({p, dx, dy, period}, numbers, 7));
            };
            const auto step = [](const auto& a, const auto& b) {
                double sum = 0;
                for (std::size_t k = 0; k < channels; ++k)
                    sum += std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
                return sum;
            };
            std::uniform_int_distribution<int> place(0, 4095);
            double seam = 0;
            double elsewhere = 0; // in the middle of the period, which is an edge between threads too
            for (int i = 0; i < 2000; ++i) {
                const float x = static_cast<float>(place(random)) / 512;
                const float y = static_cast<float>(place(random)) / 1024;
                REQUIRE(at(x, y) == at(x + period.x, y - 2 * period.y));
                seam += step(at(-near, y), at(near, y)) + step(at(x, -near), at(x, near));
                elsewhere += step(at(4 - near, y), at(4 + near, y)) + step(at(x, 2 - near), at(x, 2 + near));
            }
            fmt::print("  {:<14} {:<9} steps at the seam {:.2f} times those elsewhere\n", material.name,
                       filter ? "filtered" : "", seam / elsewhere);
            CHECK(seam < 2.5 * elsewhere);
        }
}

TEST_CASE("a tile that is filtered for a tiny pixel is the plain tile, at random parameters", "[material]") {
    constexpr float tiny = 1e-5f;
    std::mt19937 random(6);
    std::uniform_real_distribution<float> place(0, 4);
    for (const Material& material : materials) {
        test::Largest largest;
        for (int i = 0; i < 12; ++i) {
            Request request = request_of(material.name);
            randomize(request, random);
            if (material.name == "fabric") // each weave as often
                render::set(request, "fabric.weave", i % 3 * 1.0);
            const std::vector<float> numbers = numbers_of(request);
            for (int k = 0; k < 20; ++k) {
                const gabor_vec2 p(place(random), place(random)), period(4, 6);
                const auto seed = static_cast<std::uint32_t>(i);
                const auto plain = values_of(material.at({p, {0, 0}, {0, 0}, period}, numbers, seed)),
                           filtered =
                               values_of(material.at({p, {tiny, 0}, {0, tiny}, period}, numbers, seed));
                for (std::size_t c = 0; c < channels; ++c)
                    if (c != height_channel + 1) // for such a pixel, the roughness has rounding errors
                        largest.see(filtered[c], plain[c], 2e-3, [&] { return render::to_json(request); });
            }
        }
        largest.check(std::string(material.name));
    }
}

TEST_CASE("each pixel of a material's picture equals the material's function", "[material]") {
    const vulkan::Device device;
    constexpr int side = 48;
    std::mt19937 random(3);
    bool filter = false; // filters and tiles every other material, because compiling each pass takes a while
    for (const Material& material : materials) {
        filter = !filter;
        Request request{.width = side,
                        .height = side,
                        .scale = 12,
                        .seed = 7,
                        .kind = render::Kind::material,
                        .view = {.tileable = filter},
                        .material = std::string(material.name),
                        .filter = filter};
        CHECK(numbers_of(request).size() == material.by_default().size());
        for (std::size_t i = 0; i < material.by_default().size(); ++i)
            CHECK(numbers_of(request)[i] == Approx(material.by_default()[i]).epsilon(1e-6));
        randomize(request, random);
        render::check(request);
        CHECK(render::from_json(render::to_json(request)) == request);
        std::vector<float> pixels;
        render::render_region(device, request, {0, 0, side, side}, [&](std::span<const float> rows) {
            pixels.insert(pixels.end(), rows.begin(), rows.end());
        });
        const std::vector<float> expected =
            drawn(material, numbers_of(request), filter, filter, side, side / request.scale, request.seed);
        constexpr std::size_t all = render::material_channels.size();
        REQUIRE(pixels.size() / all == expected.size() / channels);
        test::Largest largest;
        for (std::size_t i = 0; i < expected.size(); ++i)
            largest.see(pixels[i / channels * all + i % channels], expected[i], 1e-4,
                        [&] { return fmt::format("channel {} of pixel {}", i % channels, i / channels); });
        largest.check(fmt::format("{}{}", filter ? "filtered, tiled " : "", material.name));
    }
}

TEST_CASE("each material has at least two presets, one of them named after it with the default look",
          "[material]") {
    std::map<std::string, int> counts;
    for (const std::string_view name : render::preset_names()) {
        const Request request = render::preset(name);
        if (request.kind != render::Kind::material)
            continue;
        ++counts[request.material];
        CHECK(request.filter);
        const auto is_own = [&](const auto& member) {
            return member.first.starts_with(request.material + ".");
        };
        CHECK(std::ranges::none_of(request.look, is_own) == (name == request.material)); // besides its finish
    }
    for (const std::string_view material : render::materials) {
        CHECK(render::preset(material).material == material);
        CHECK(counts[std::string(material)] >= 2);
    }
}
