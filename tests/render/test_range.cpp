// Evaluates every function of the drop-in over all floats and all cells, and checks that results documented
// as finite are.

#include "range.hpp"
#include "sampler.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

using namespace gabor;

namespace {

constexpr std::size_t per_batch = 1 << 14;

// Evaluates samples from `make` and checks all answers.
template <typename Make>
void check_finite(const noise::Recipe& recipe, Make make) {
    const vulkan::Device device;
    test::Sampler sampler(device, recipe, per_batch);
    test::AnyFloat draw;
    test::Broken broken[] = {{"gabor_field"},          {"its real part"},     {"its slopes"},
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
            // Slopes are at most 10^6 times the noise. Other results are only promised to be finite: the
            // quadrature of a sine kernel grows as the frequency falls.
            const float any = std::numeric_limits<float>::max();
            broken[0].see({&a.value[1], 1}, test::largest_noise, sample);
            broken[1].see(a.value, any, sample);
            broken[2].see(a.slope_x, any, sample);
            broken[2].see(a.slope_y, any, sample);
            broken[3].see({&a.at, 1}, test::largest_noise, sample);
            broken[4].see({&a.noise, 1}, test::largest_noise, sample);
            broken[5].see(a.complex, any, sample);
            broken[6].see(a.gradient, any, sample);
            broken[7].see({&a.tiled, 1}, test::largest_noise, sample);
            broken[8].see({&a.animated, 1}, test::largest_noise, sample);
            broken[9].see({&a.unorm, 1}, 1, sample);
            broken[10].see(a.phasor, any, sample);
        }
    }
    for (const test::Broken& function : broken) {
        INFO(recipe.name << ", " << function.function << ": " << function.where);
        CHECK(function.times == 0);
    }
}

} // namespace

TEST_CASE("any frequency gives finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, test::AnyFloat& draw) { s.frequency = draw.any(); });
}

TEST_CASE("any orientation gives finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, test::AnyFloat& draw) {
            s.frequency = draw.any();
            s.orientation = draw.any();
        });
}

TEST_CASE("any cell and any offset within it give finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [&](test::Sample& s, test::AnyFloat& draw) {
            s.place.cell_x = draw.cell();
            s.place.cell_y = draw.cell();
            const float x = draw.within(test::world / 2);
            test::move_to(s, x, draw.within(test::world / 2));
            s.place.period_x = draw.cell() & 0x7fffffff;
            s.place.period_y = draw.cell() & 0x7fffffff;
        });
}

TEST_CASE("any finite time gives finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, test::AnyFloat& draw) {
            s.frequency = draw.any();
            s.place.time = draw.within(std::numeric_limits<float>::max());
        });
}

TEST_CASE("any period, even one that is too short, gives finite noise", "[range]") {
    for (const noise::Recipe& recipe : noise::sparse_recipes())
        check_finite(recipe, [](test::Sample& s, test::AnyFloat& draw) {
            test::move_to(s, draw.within(test::world / 2), s.place.local_y);
            s.period_x = draw.within(test::world / 2);
            s.period_y = draw.word() % 8 ? draw.within(test::world / 2) : -test::infinity;
        });
}
