// Every function of the drop-in over every float that a parameter can be, and over the whole world of cells:
// what the drop-in promises to be finite is, on any driver.

#include "sampler.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

using namespace gabor;

namespace {

constexpr std::size_t per_batch = 1 << 14;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float world = 2147483520; // the last float below 2^31

// No noise of variance 1 made of so few impulses is as large as this.
constexpr float largest_noise = 40;

const float edges[] = {0,
                       std::numeric_limits<float>::denorm_min(),
                       1e-40f,
                       std::numeric_limits<float>::min(),
                       1e-30f,
                       1e-20f,
                       1e-10f,
                       std::numeric_limits<float>::epsilon(),
                       1e-6f,
                       0.1f,
                       0.25f,
                       0.5f,
                       0.99999994f,
                       1,
                       1.0000001f,
                       1.5f,
                       2,
                       4,
                       64,
                       400,
                       16777215,
                       16777216,
                       1e9f,
                       world,
                       2147483648.0f,
                       4294967296.0f,
                       1e15f,
                       1e20f,
                       1e30f,
                       std::numeric_limits<float>::max(),
                       infinity,
                       std::numeric_limits<float>::quiet_NaN()};

constexpr std::int32_t cell_edges[] = {0,
                                       1,
                                       -1,
                                       2,
                                       0x00ffffff,
                                       0x01000000,
                                       std::numeric_limits<std::int32_t>::max(),
                                       std::numeric_limits<std::int32_t>::max() - 1,
                                       std::numeric_limits<std::int32_t>::min(),
                                       std::numeric_limits<std::int32_t>::min() + 1};

class Draw {
  public:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }

    // Half of them edges of either sign, half any bits at all.
    float any() {
        if (word() % 2)
            return std::bit_cast<float>(word());
        const float edge = edges[word() % std::size(edges)];
        return word() % 2 ? -edge : edge;
    }

    // Of those only what is within [-most, most].
    float within(float most) {
        float value = any();
        while (!(std::abs(value) <= most))
            value = any();
        return value;
    }

    std::int32_t cell() {
        return word() % 2 ? static_cast<std::int32_t>(word()) : cell_edges[word() % std::size(cell_edges)];
    }

  private:
    std::mt19937 random_{11};
};

std::string describe(const test::Sample& s) {
    const noise::Place& p = s.place;
    return fmt::format("cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), time {}, frequency {}, "
                       "orientation {}, seed {}, tiled with ({}, {})",
                       p.cell_x, p.cell_y, p.local_x, p.local_y, p.radius_x, p.radius_y, p.period_x,
                       p.period_y, p.time, s.frequency, s.orientation, s.seed, s.period_x, s.period_y);
}

// How often one function was not what it promises, and where first.
struct Broken {
    std::string function;
    std::size_t times = 0;
    std::string where = {};

    void see(std::span<const float> values, float most, const test::Sample& sample) {
        for (const float value : values) {
            if (std::abs(value) <= most) // false for a NaN
                continue;
            if (times++ == 0)
                where = fmt::format("{} at {}", value, describe(sample));
        }
    }
};

// Asks for samples made by `make` and checks all answers.
template <typename Make>
void check_finite(const noise::Recipe& recipe, Make make) {
    const vulkan::Device device;
    test::Sampler sampler(device, recipe, per_batch);
    Draw draw;
    Broken broken[] = {{"gabor_field"},          {"its real part"},     {"its slopes"},
                       {"gabor_noise_at"},       {"gabor_noise"},       {"gabor_noise_complex"},
                       {"gabor_noise_gradient"}, {"gabor_noise_tiled"}, {"gabor_noise_animated"},
                       {"gabor_unorm"},          {"gabor_phasor"}};
    for (int batch = 0; batch < 8; ++batch) {
        for (test::Sample& sample : sampler.samples()) {
            sample = {noise::place_at(recipe, 3, -4, 0.3f, 0.8f), 4, 0.7f, draw.word()};
            make(sample, draw);
        }
        const auto answers = sampler.answers(per_batch);
        for (std::size_t i = 0; i < per_batch; ++i) {
            const test::Sample& sample = sampler.samples()[i];
            const test::Answer& a = answers[i];
            // A slope is as large as the wave turns, 10^6 times at most. What is not the noise itself is only
            // promised to be finite: with sines for a kernel its quadrature grows where the frequency falls.
            const float any = std::numeric_limits<float>::max();
            broken[0].see({&a.value[1], 1}, largest_noise, sample);
            broken[1].see(a.value, any, sample);
            broken[2].see(a.slope_x, any, sample);
            broken[2].see(a.slope_y, any, sample);
            broken[3].see({&a.at, 1}, largest_noise, sample);
            broken[4].see({&a.noise, 1}, largest_noise, sample);
            broken[5].see(a.complex, any, sample);
            broken[6].see(a.gradient, any, sample);
            broken[7].see({&a.tiled, 1}, largest_noise, sample);
            broken[8].see({&a.animated, 1}, largest_noise, sample);
            broken[9].see({&a.unorm, 1}, 1, sample);
            broken[10].see(a.phasor, any, sample);
        }
    }
    for (const Broken& function : broken) {
        INFO(recipe.name << ", " << function.function << ": " << function.where);
        CHECK(function.times == 0);
    }
}

} // namespace

TEST_CASE("any frequency at all gives a finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, Draw& draw) { s.frequency = draw.any(); });
}

TEST_CASE("any orientation at all gives a finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, Draw& draw) {
            s.frequency = draw.any();
            s.orientation = draw.any();
        });
}

TEST_CASE("any cell of the world and any place in it give a finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [&](test::Sample& s, Draw& draw) {
            s.place.cell_x = draw.cell();
            s.place.cell_y = draw.cell();
            const float x = draw.within(world / 2);
            test::move_to(s, x, draw.within(world / 2));
            s.place.period_x = draw.cell() & 0x7fffffff;
            s.place.period_y = draw.cell() & 0x7fffffff;
        });
}

TEST_CASE("any finite time gives a finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, Draw& draw) {
            s.frequency = draw.any();
            s.place.time = draw.within(std::numeric_limits<float>::max());
        });
}

TEST_CASE("any period of the world, and those that are too short, give a finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, Draw& draw) {
            test::move_to(s, draw.within(world / 2), s.place.local_y);
            s.period_x = draw.within(world / 2);
            s.period_y = draw.word() % 8 ? draw.within(world / 2) : -infinity;
        });
}
