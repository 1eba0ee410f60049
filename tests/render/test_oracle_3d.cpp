// Every function of the drop-in in space, on the device, against the double-precision reference.

#include "sampler_3d.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

using namespace gabor;
using test::Kind;

namespace {

constexpr std::size_t per_batch = 1 << 11;

// The largest difference of one function, in units of its tolerance, and where it was.
struct Largest {
    std::size_t points = 0;
    double difference = 0;
    std::string where = "nowhere";

    void see(double value, double expected, double tolerance, const test::Sample3d& sample) {
        ++points;
        const double scaled = std::abs(value - expected) / tolerance;
        if (scaled <= difference) // a NaN is seen
            return;
        difference = scaled;
        const noise::Place3d& p = sample.place;
        where = fmt::format("{} instead of {} at cell {} + {}, radius {}, period {}, time {}, frequency {}, "
                            "direction {}, normal {}, seed {}",
                            value, expected, p.cell, p.local, p.radius, p.period, p.time, sample.frequency,
                            sample.direction, sample.normal, sample.seed);
    }

    void check(std::string_view name) const {
        fmt::print("  {:<32} {:.3f} in {} points: {}\n", name, difference, points, where);
        INFO(name);
        CHECK(points > 0);
        CHECK(difference <= 1);
    }
};

// 1e-5 up to frequency 4, above in proportion to it: single precision carries no more of the phase.
double tolerance(double frequency) {
    return 1e-5 * std::max(1.0, frequency / 4);
}

// On a surface what is left of a direction near the normal is up to eight times shorter than its rounding is.
double tolerance(double frequency, Kind kind) {
    return tolerance(frequency) * (kind == Kind::surface || kind == Kind::surface_isotropic ? 8 : 1);
}

// A derivative is as large as the wave turns.
double slope_tolerance(double frequency, Kind kind) {
    return tolerance(frequency, kind) * (2 * std::numbers::pi * frequency + 2);
}

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}

    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    float uniform(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }
    std::array<float, 3> vector(double low, double high) {
        return {uniform(low, high), uniform(low, high), uniform(low, high)};
    }

    // In all octants up to 10^6, or in any cell; one coordinate in four on or next to a cell's edge.
    noise::Place3d place(const noise::Recipe& recipe) {
        const float reach = std::exp2(uniform(0, 20));
        noise::Place3d p;
        p.radius.fill(recipe.radius);
        const bool far = word() % 2;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float& local = p.local[axis];
            local = uniform(-reach, reach);
            if (word() % 4 == 0)
                local = word() % 2 ? std::round(local)
                                   : std::nextafter(std::round(local), word() % 2 ? 1e9f : -1e9f);
            if (far) {
                p.cell[axis] = static_cast<std::int32_t>(word());
                local -= std::floor(local);
            }
        }
        return p;
    }

  private:
    std::mt19937 random_;
};

// Where the functions of a position evaluate: in cells, in single precision as they do.
noise::Place3d near_origin(const noise::Recipe& recipe, const test::Sample3d& sample) {
    noise::Place3d place;
    place.radius.fill(recipe.radius);
    for (std::size_t axis = 0; axis < 3; ++axis)
        place.local[axis] = sample.position[axis] * recipe.radius;
    return place;
}

} // namespace

TEST_CASE("solid and surface noise agree with the reference", "[oracle]") {
    const vulkan::Device device;
    Draw draw(1);
    for (const noise::Recipe& recipe : {noise::recipe_3d(), noise::pure_recipe_3d()}) {
        test::Sampler3d sampler(device, recipe, per_batch);
        Largest value[4], quadrature[4], slope[4], at, plain, isotropic, gradient, complex, surface,
            surface_isotropic;
        std::size_t points = 0;
        for (int batch = 0; batch < 40; ++batch) {
            const int kind = batch % 4;
            // The frequencies cover 0.1 to 64 evenly in octaves.
            const float frequency = 0.1f * static_cast<float>(std::exp2(batch / 4 * 1.0355));
            for (test::Sample3d& sample : sampler.samples()) {
                sample = {draw.place(recipe), frequency, draw.vector(-3, 3), draw.vector(-3, 3)};
                sample.seed = draw.word();
                sample.kind = Kind{kind};
                if (draw.word() % 8 == 0) // near where the projection ends
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        sample.direction[axis] = sample.normal[axis] + draw.uniform(-0.3, 0.3);
            }
            const auto answers = sampler.answers(per_batch);
            const double tight = tolerance(frequency, Kind{kind});
            const double loose = slope_tolerance(frequency, Kind{kind});
            for (std::size_t i = 0; i < per_batch; ++i) {
                const test::Sample3d& sample = sampler.samples()[i];
                const test::Answer3d& answer = answers[i];
                const auto reference = [&](Kind of) {
                    return noise::Reference3d(recipe, test::waves_of(sample, of), sample.seed);
                };
                const noise::Reference3d::Field field = reference(sample.kind).field(sample.place);
                value[kind].see(answer.value[1], field.value.imag(), tight, sample);
                quadrature[kind].see(answer.value[0], field.value.real(), tight, sample);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    slope[kind].see(answer.slope[axis][1], field.slope[axis].imag(), loose, sample);
                    slope[kind].see(answer.slope[axis][0], field.slope[axis].real(), loose, sample);
                }
                at.see(answer.at, field.value.imag(), tight, sample);
                const noise::Place3d here = near_origin(recipe, sample);
                const noise::Reference3d::Field oriented = reference(Kind::oriented).field(here);
                const double flat = tolerance(frequency);
                const double bent = tolerance(frequency, Kind::surface);
                const double flat_slope = slope_tolerance(frequency, Kind::oriented);
                plain.see(answer.noise, oriented.value.imag(), flat, sample);
                complex.see(answer.complex[0], oriented.value.real(), flat, sample);
                complex.see(answer.complex[1], oriented.value.imag(), flat, sample);
                gradient.see(answer.gradient[0], oriented.value.imag(), flat, sample);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    gradient.see(answer.gradient[axis + 1], oriented.slope[axis].imag(), flat_slope, sample);
                isotropic.see(answer.isotropic, reference(Kind::isotropic)(here), flat, sample);
                surface.see(answer.surface, reference(Kind::surface)(here), bent, sample);
                surface_isotropic.see(answer.surface_isotropic, reference(Kind::surface_isotropic)(here),
                                      bent, sample);
            }
            points += per_batch;
        }
        fmt::print("{}: {} points on {}; largest differences in units of the tolerance\n", recipe.name,
                   points, device.info().name);
        const char* kinds[] = {"oriented", "isotropic", "surface", "isotropic on the surface"};
        for (std::size_t kind = 0; kind < 4; ++kind) {
            value[kind].check(kinds[kind]);
            quadrature[kind].check("  its real part");
            slope[kind].check("  its gradient");
        }
        at.check("gabor_noise_3d_at");
        plain.check("gabor_noise_3d");
        gradient.check("gabor_noise_3d_gradient");
        complex.check("gabor_noise_3d_complex");
        isotropic.check("gabor_noise_3d_isotropic");
        surface.check("gabor_noise_surface");
        surface_isotropic.check("gabor_noise_surface_isotropic");
    }
}

TEST_CASE("periods of noise in space, and in time, agree with the reference", "[oracle]") {
    const vulkan::Device device;
    Draw draw(5);
    for (const noise::Recipe& recipe : {noise::recipe_3d(), noise::pure_recipe_3d()}) {
        test::Sampler3d sampler(device, recipe, per_batch);
        Largest value, slope, tiled, animated;
        for (int batch = 0; batch < 12; ++batch) {
            const float frequency = draw.uniform(0.5, 8);
            for (test::Sample3d& sample : sampler.samples()) {
                sample = {draw.place(recipe), frequency, draw.vector(-3, 3), draw.vector(-3, 3)};
                sample.seed = draw.word();
                sample.kind = Kind{batch % 4};
                noise::Place3d& p = sample.place;
                p.time = draw.uniform(-2, 2);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    p.period[axis] = static_cast<std::int32_t>(draw.word() % 7);
                    p.radius[axis] = recipe.radius * draw.uniform(0.5, 1);
                    sample.tile[axis] = draw.uniform(1.5, 9);
                }
            }
            const auto answers = sampler.answers(per_batch);
            // Fewer cells per radius: fewer and so larger impulses.
            const double tight = 3 * tolerance(frequency, Kind{batch % 4});
            const double loose = 3 * slope_tolerance(frequency, Kind{batch % 4});
            for (std::size_t i = 0; i < per_batch; ++i) {
                const test::Sample3d& sample = sampler.samples()[i];
                const noise::Reference3d reference(recipe, test::waves_of(sample, sample.kind), sample.seed);
                const noise::Reference3d::Field field = reference.field(sample.place);
                value.see(answers[i].value[1], field.value.imag(), tight, sample);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    slope.see(answers[i].slope[axis][1], field.slope[axis].imag(), loose, sample);

                // The functions of a position, where a float still holds it: it rounds on its way by 10^-6,
                // and the wave turns by 2 pi F in a radius.
                const double rounded = 4e-5 * (1 + frequency);
                noise::Place3d still = near_origin(recipe, sample);
                noise::Place3d tile;
                bool held = true;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double p = sample.position[axis];
                    held = held && std::abs(p) <= 8;
                    const double period = std::max(double{sample.tile[axis]}, 2.0);
                    const double cells = std::floor(period * recipe.radius);
                    tile.radius[axis] = static_cast<float>(cells / period);
                    tile.local[axis] = static_cast<float>(p * cells / period);
                    tile.period[axis] = static_cast<std::int32_t>(cells);
                }
                if (!held)
                    continue;
                const noise::Reference3d oriented(recipe, test::waves_of(sample, Kind::oriented),
                                                  sample.seed);
                still.time = sample.place.time;
                animated.see(answers[i].animated, oriented(still), rounded, sample);
                tiled.see(answers[i].tiled, oriented(tile), rounded, sample);
            }
        }
        fmt::print("{}, with periods; largest differences in units of the tolerance\n", recipe.name);
        value.check("gabor_field_3d");
        slope.check("  its gradient");
        tiled.check("gabor_noise_3d_tiled");
        animated.check("gabor_noise_3d_animated");
    }
}

TEST_CASE("kernels seen through a footprint agree with the reference", "[oracle]") {
    const vulkan::Device device;
    Draw draw(8);
    test::Sampler3d sampler(device, noise::recipe_3d(), per_batch);
    Largest value[4];
    for (int batch = 0; batch < 16; ++batch) {
        const float frequency = draw.uniform(0.5, 16);
        for (test::Sample3d& sample : sampler.samples()) {
            sample = {draw.place(noise::recipe_3d()), frequency, draw.vector(-3, 3), draw.vector(-3, 3)};
            sample.seed = draw.word();
            sample.kind = Kind{batch % 4};
            const double reach = std::exp2(draw.uniform(-8, 1));
            sample.dx = draw.vector(-reach, reach);
            sample.dy = draw.vector(-reach, reach);
        }
        const auto answers = sampler.answers(per_batch, test::Wanted::at);
        for (std::size_t i = 0; i < per_batch; ++i) {
            const test::Sample3d& sample = sampler.samples()[i];
            noise::Waves waves = test::waves_of(sample, sample.kind);
            waves.dx = test::wide(sample.dx);
            waves.dy = test::wide(sample.dy);
            const noise::Reference3d reference(noise::recipe_3d(), waves, sample.seed);
            value[batch % 4].see(answers[i].at, reference(sample.place), tolerance(frequency, sample.kind),
                                 sample);
        }
    }
    fmt::print("through a footprint; largest differences in units of the tolerance\n");
    const char* kinds[] = {"oriented", "isotropic", "surface", "isotropic on the surface"};
    for (std::size_t kind = 0; kind < 4; ++kind)
        value[kind].check(kinds[kind]);
}

TEST_CASE("a kernel seen through a footprint is nearly the average over it", "[oracle]") {
    Draw draw(9);
    constexpr int places = 100;
    constexpr int nodes = 8; // to each side of the Gaussian's middle, up to 4.5 standard deviations
    for (const Kind kind : {Kind::oriented, Kind::surface_isotropic}) {
        for (const double cycles : {0.125, 0.5, 0.75}) { // to a pixel
            test::Sample3d sample;
            sample.frequency = 4;
            double error = 0;
            double seen = 0;
            double averaged = 0;
            for (int i = 0; i < places; ++i) {
                sample.direction = draw.vector(-1, 1);
                noise::Waves waves = test::waves_of(sample, kind);
                noise::Waves filtered = waves;
                filtered.dx = {cycles / 4, 0, 0};
                filtered.dy = {0, cycles / 8, 0};
                const std::uint32_t seed = draw.word();
                const noise::Reference3d reference(noise::recipe_3d(), waves, seed);
                noise::Place3d place;
                place.local = draw.vector(0, 1);
                double sum = 0;
                double weights = 0;
                for (int k = -nodes; k <= nodes; ++k) {
                    for (int l = -nodes; l <= nodes; ++l) {
                        const double x = 4.5 * k / nodes;
                        const double y = 4.5 * l / nodes;
                        const double weight = std::exp(-(x * x + y * y) / 2);
                        noise::Place3d moved = place;
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            moved.local[axis] +=
                                static_cast<float>((x * filtered.dx[axis] + y * filtered.dy[axis]) / 2);
                        sum += weight * reference(moved);
                        weights += weight;
                    }
                }
                const double value = noise::Reference3d(noise::recipe_3d(), filtered, seed)(place);
                error += std::pow(value - sum / weights, 2) / places;
                seen += value * value / places;
                averaged += std::pow(sum / weights, 2) / places;
            }
            fmt::print("kind {}, {} cycles to a pixel: standard deviation {:.3f} for {:.3f}, error {:.4f}\n",
                       static_cast<int>(kind), cycles, std::sqrt(seen), std::sqrt(averaged),
                       std::sqrt(error));
            CHECK(std::sqrt(error) < 0.15 / 4);
            CHECK(std::sqrt(seen) == Approx(std::sqrt(averaged)).margin(0.02));
        }
    }
}

TEST_CASE("the gradient in space is what differences of the reference say", "[oracle]") {
    Draw draw(6);
    for (const noise::Recipe& recipe : {noise::recipe_3d(), noise::pure_recipe_3d()}) {
        for (const Kind kind : {Kind::oriented, Kind::surface_isotropic}) {
            test::Sample3d sample;
            sample.frequency = 3;
            sample.direction = draw.vector(-1, 1);
            sample.normal = draw.vector(-1, 1);
            const noise::Reference3d reference(recipe, test::waves_of(sample, kind), 9);
            for (int i = 0; i < 500; ++i) {
                noise::Place3d place;
                place.radius.fill(recipe.radius);
                for (float& coordinate : place.local) // a float holds them, and those next to them
                    coordinate = std::floor(draw.uniform(-8, 8) * 256) / 256;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    constexpr float h = 0x1p-12f;
                    noise::Place3d before = place;
                    noise::Place3d after = place;
                    before.local[axis] -= h;
                    after.local[axis] += h;
                    const double difference =
                        (reference(after) - reference(before)) / (2 * h) * recipe.radius;
                    // Across the end of a window, where q'' jumps by 24, the difference is off by up to 24 h
                    // / 4.
                    REQUIRE(reference.field(place).slope[axis].imag() == Approx(difference).margin(3e-3));
                }
            }
        }
    }
}

TEST_CASE("impulses in space agree bit for bit", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 14;
    test::Sampler3d sampler(device, noise::recipe_3d(), count);
    Draw draw(2);
    for (test::Sample3d& sample : sampler.samples()) {
        constexpr std::int32_t edges[] = {0, 1, -1, std::numeric_limits<std::int32_t>::max(),
                                          std::numeric_limits<std::int32_t>::min()};
        sample = {};
        for (std::int32_t& cell : sample.place.cell)
            cell = draw.word() % 3 == 0 ? edges[draw.word() % 5] : static_cast<std::int32_t>(draw.word());
        sample.seed = draw.word() % 5 == 0 ? draw.word() % 3 : draw.word();
        sample.index = static_cast<std::int32_t>(draw.word() % 40);
    }
    const auto answers = sampler.answers(count);
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const test::Sample3d& s = sampler.samples()[i];
        const std::uint32_t word = noise::impulse_word_3d(s.place.cell, s.index, s.seed);
        REQUIRE(answers[i].word == word);
        const noise::Vector3 direction = noise::Impulse3d(word).direction;
        for (std::size_t axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(answers[i].direction[axis] - direction[axis]));
    }
    fmt::print("directions of impulses: largest difference {:.2g}\n", largest);
    CHECK(largest < 1e-6);
}

TEST_CASE("odd requests in space give what is documented and never NaN", "[oracle]") {
    const vulkan::Device device;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float odd[] = {0, -0.0f, 1e-38f, 1e-30f, -3, 1e30f, 3e38f, infinity, -infinity};
    constexpr std::size_t count = std::size(odd) * 4 * 5;
    test::Sampler3d sampler(device, noise::recipe_3d(), count);
    std::size_t i = 0;
    for (const float x : odd) {
        for (int kind = 0; kind < 4; ++kind) {
            for (int where = 0; where < 5; ++where) {
                test::Sample3d sample;
                sample.place.local = {0.3f, 0.8f, 0.1f};
                sample.kind = Kind{kind};
                if (where == 0)
                    sample.frequency = x;
                if (where == 1)
                    sample.direction = {x, 0, 0};
                if (where == 2)
                    sample.normal = {x, x, 0};
                if (where == 3)
                    sample.normal = sample.direction = {x, 0, x};
                if (where == 4)
                    sample.dx = sample.dy = {x, x, 0};
                sampler.samples()[i++] = sample;
            }
        }
    }
    const auto answers = sampler.answers(count);
    for (i = 0; i < count; ++i) {
        INFO("sample " << i);
        CHECK(std::isfinite(answers[i].at));
        CHECK(std::abs(answers[i].at) < 10);
        for (const auto& slope : answers[i].slope)
            CHECK(std::isfinite(slope[1]));
    }
    // -3 is 3, and a direction counts without its length.
    test::Sample3d sample;
    sample.place.local = {0.3f, 0.8f, 0.1f};
    sample.frequency = 3;
    for (i = 0; i < 3; ++i)
        sampler.samples()[i] = sample;
    sampler.samples()[1].frequency = -3;
    sampler.samples()[2].direction = {8, 0, 0};
    const auto same = sampler.answers(3, test::Wanted::at);
    CHECK(same[1].at == same[0].at);
    CHECK(same[2].at == same[0].at);
}
