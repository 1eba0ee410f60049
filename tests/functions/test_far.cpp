// Tests points far from the origin with fused multiply-adds, which GPU compilers also use. Their different
// rounding must not move a point out of its cell.

#include "noise.hpp"

#include <algorithm>

using namespace gabor;
using test::Random;

namespace {

// Checks the variance of a noise, given a random position up to each distance from the origin.
template <typename Vector>
void check_variance(const char* name, std::initializer_list<double> distances, const auto& noise) {
    constexpr int count = 20000;
    Random random(3);
    for (const double reach : distances) {
        double sum = 0, largest = 0;
        for (int i = 0; i < count; ++i) {
            const double value = noise(random, random.uniform<Vector>(-reach, reach));
            sum += value * value;
            largest = std::max(largest, std::abs(value));
        }
        INFO(name << ", |p| < " << reach << ": variance " << sum / count << ", largest " << largest);
        CHECK(std::abs(sum / count - 1) < 5 * std::sqrt(2.0 / count));
        CHECK(largest < 6);
    }
}

template <typename Functions>
void check_plane(Functions functions) {
    check_variance<gabor_vec2>(
        "plane", {1.0, 1e5, 1e6, 1e7, 3e7, 1e8, 1e9, 4.29e9 / Functions::taps},
        [&](Random& random, gabor_vec2 p) { return functions.gabor_noise(p, 4, 0.7854f, random.word()); });
}

} // namespace

TEST_CASE("the variance is 1 at any distance from the origin", "[far]") {
    check_plane(test::Lattice2());
    check_plane(test::Lattice3());
    check_plane(test::Lattice4());
}

TEST_CASE("the variance of noise in 3D is 1 at any distance from the origin", "[far]") {
    for (const auto& noise : {test::solid, test::isotropic_3d, test::isotropic_surface})
        check_variance<gabor_vec3>(noise.name, {16.0, 1e5, 1e7, 3e7, 1e8, 1e9, 1.43e9},
                                   [&](Random& random, gabor_vec3 p) {
                                       auto s = test::somewhere<3>(random, random.uniform(0, 4));
                                       return noise.plain(test::n.gabor_place_3d_at(p), s).noise;
                                   });
}
