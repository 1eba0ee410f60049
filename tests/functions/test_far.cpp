// Tests points far from the origin with fused multiply-adds, which GPU compilers also use. Their different
// rounding must not move a point out of its cell.

#include "noise.hpp"

#include <algorithm>

using namespace gabor;
using test::Random;

namespace {

template <typename Functions>
void check_variance(Functions n) {
    constexpr int count = 20000;
    Random random(3);
    for (const double reach : {1.0, 1e5, 1e6, 1e7, 3e7, 1e8, 1e9, 4.29e9 / Functions::taps}) {
        double sum = 0, largest = 0;
        for (int i = 0; i < count; ++i) {
            const double noise =
                n.gabor_noise(random.uniform<gabor_vec2>(-reach, reach), 4, 0.7854f, random.word());
            sum += noise * noise;
            largest = std::max(largest, std::abs(noise));
        }
        INFO(Functions::taps << " taps, |p| < " << reach << ": variance " << sum / count << ", largest "
                             << largest);
        CHECK(std::abs(sum / count - 1) < 5 * std::sqrt(2.0 / count));
        CHECK(largest < 6);
    }
}

} // namespace

TEST_CASE("the variance is 1 at any distance from the origin", "[far]") {
    check_variance(test::Lattice2());
    check_variance(test::Lattice3());
    check_variance(test::Lattice4());
}

TEST_CASE("the variance of noise in space is 1 at any distance from the origin", "[far]") {
    constexpr int count = 20000;
    test::Lattice3 n;
    for (const double reach : {16.0, 1e5, 1e7, 3e7, 1e8, 1e9, 1.43e9}) {
        Random random(3);
        std::array<double, 3> power{};
        for (int i = 0; i < count; ++i) {
            const auto p = random.uniform<gabor_vec3>(-reach, reach),
                       along = random.uniform<gabor_vec3>(-1, 1);
            const float frequency = random.uniform(0, 4);
            const std::uint32_t seed = random.word();
            power[0] += std::pow(n.gabor_noise_3d(p, frequency, along, seed), 2);
            power[1] += std::pow(n.gabor_noise_3d_isotropic(p, frequency, seed), 2);
            power[2] += std::pow(n.gabor_noise_surface_isotropic(p, along, frequency, seed), 2);
        }
        for (std::size_t k = 0; k < power.size(); ++k) {
            INFO("noise " << k << ", |p| < " << reach << ": variance " << power[k] / count);
            CHECK(std::abs(power[k] / count - 1) < 5 * std::sqrt(2.0 / count));
        }
    }
}
