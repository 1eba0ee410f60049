// Compares every combination of points, kernel and envelope on the device with the double-precision
// reference. Weights alternate, since they only scale an impulse.

#include "ingredients_reference.hpp"
#include "largest.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>

using namespace gabor;

TEST_CASE("combinations of ingredients agree with the reference", "[ingredients]") {
    const vulkan::Device device;
    const study::PlaneWave wave{4, 0.7};
    test::Largest largest;
    std::uint32_t seed = 11;
    for (const study::Points points : study::all_points)
        for (const study::Kernel kernel : study::all_kernels)
            for (const study::Envelope envelope : study::all_envelopes) {
                constexpr int counts[]{1, 2, 3, 4, 7, 13, 29};
                const int n = counts[seed % 7];
                const study::Weights weights = study::all_weights[seed % study::all_weights.size()];
                const study::Ingredients it{points, weights, kernel, envelope, n, seed % 5 == 0 ? 3 : 0};
                study::Noise noise(device, it, wave);
                std::vector<float> values(64);
                noise.fill(values, {}, 5, ++seed, 99);
                const double amplitude = 1 / std::sqrt(study::variance(it, wave));
                for (std::uint32_t i = 0; i < values.size(); ++i) {
                    const test::Place p = test::random_place(5 + i, seed, 99);
                    const double expected = amplitude * test::ingredients_sum(it, wave, p.x, p.y, p.seed);
                    largest.see(values[i], expected, 1e-5,
                                [&] { return fmt::format("{}, value {}", study::csv_fields(it), i); });
                }
            }
    largest.check("ingredients");
}
