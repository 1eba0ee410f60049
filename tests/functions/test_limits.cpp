// Checks that arguments beyond their documented range count as the nearest value within, and that they do not
// count as that value before the range ends.

#include "compare.hpp"

#include "gabor_noise.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_fractal.hpp"

#include "gabor_ocean.hpp"

#include "gabor_materials.hpp"

#include "gabor_compose.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using gabor::test::Random;
using Values = std::vector<float>;

struct Limit {
    const char* name;
    float beyond, end, within;
    std::function<Values(float argument, gabor_vec2 p, gabor_vec2 q)> values;
};

Values all(const auto& noise) {
    return {noise.noise,  noise.gradient.x, noise.gradient.y, noise.removed,
            noise.lost.x, noise.lost.y,     noise.lost.z};
}
Values all_3d(const auto& noise) {
    return {noise.noise, noise.gradient.x, noise.gradient.y, noise.gradient.z, noise.removed, noise.lost.x};
}

// Fractal noise, plain and filtered, in the plane and in a volume, where one member has a value.
template <typename Member>
auto fractal_of(Member member, float period = 0) {
    return [=](float x, gabor_vec2 p, gabor_vec2 q) {
        auto fractal = gabor_fractal(4.5f, 0.7f);
        member(fractal) = x;
        const auto place = gabor_place_tiled(p, gabor_vec2(period));
        const auto place_3d = gabor_place_3d_tiled(gabor_vec3(p.x, p.y, q.x), gabor_vec3(period));
        Values values = all(gabor_fractal_noise(place, fractal, 7));
        for (const Values& more :
             {all(gabor_fractal_noise_filtered(place, 0.1f * q, gabor_vec2(0, 0.1f), fractal, 7)),
              all_3d(gabor_fractal_noise_3d(place_3d, fractal, 7)),
              all_3d(gabor_fractal_noise_3d_filtered(place_3d, gabor_vec3(0.1f, 0, 0),
                                                     gabor_vec3(0, 0.1f, 0.1f), fractal, 7))})
            values.insert(values.end(), more.begin(), more.end());
        return values;
    };
}

template <typename Member>
auto sea_of(Member member) {
    return [=](float x, gabor_vec2 p, gabor_vec2 q) {
        GaborSea sea = gabor_sea();
        sea.swell_height = 2;
        sea.swell_period = 9;
        member(sea) = x;
        const GaborOcean ocean = gabor_ocean_of(sea);
        const GaborWater water = gabor_water(20.0f * p, 5 * q.x, ocean, 7);
        return Values{water.height, water.slope.x, water.shift.y, water.velocity.z};
    };
}

const std::vector<Limit>& limits() {
    static const auto octaves = [](auto& f) -> float& { return f.octaves; };
    static const auto lacunarity = [](auto& f) -> float& { return f.lacunarity; };
    static const auto depth = [](auto& s) -> float& { return s.water_depth; };
    static const auto wind = [](auto& s) -> float& { return s.wind; };
    static const auto fetch = [](auto& s) -> float& { return s.fetch; };
    static const auto swell_height = [](auto& s) -> float& { return s.swell_height; };
    static const auto swell_period = [](auto& s) -> float& { return s.swell_period; };
    static const auto spread = [](float frequency, float width, float turn) {
        return [=](float x, gabor_vec2 p, gabor_vec2) {
            return Values{gabor_noise_spread(p, frequency < 0 ? x : frequency, 0.5f, width < 0 ? x : width,
                                             turn < 0 ? x : turn, 7)};
        };
    };
    static const auto finished = [](float x, gabor_vec2 p, gabor_vec2) {
        GaborMaterial wood = gabor_wood(p, 7);
        wood.roughness = x;
        GaborFinish finish = gabor_finish_default();
        finish.dust_amount = finish.dirt_amount = finish.roughness_variation = 0;
        return Values{gabor_finished(wood, p, gabor_vec2(0.0f), finish, 7).roughness};
    };
    static const std::vector<Limit> all_limits{
        {"octaves, low", 0.25f, 1, 1.5f, fractal_of(octaves)},
        {"octaves, high", 20, 16, 15.5f, fractal_of(octaves)},
        {"lacunarity, low", 0.5f, 1, 1.25f, fractal_of(lacunarity)},
        {"lacunarity, high", 9, 4, 3.5f, fractal_of(lacunarity)},
        {"lacunarity of a period, low", 0.5f, 1, 1.5f, fractal_of(lacunarity, 6)},
        {"lacunarity of a period, high", 9, 4, 3.5f, fractal_of(lacunarity, 6)},
        {"spread of frequency, low", -0.5f, 0, 0.5f, spread(3, -1, 0.2f)},
        {"spread of frequency, high", 1.5f, 1, 0.5f, spread(3, -1, 0.2f)},
        {"spread of orientation, low", -0.5f, 0, 1, spread(3, 0.2f, -1)},
        {"spread of orientation, high", 2, 1.5707963f, 1, spread(3, 0.2f, -1)},
        {"depth of water, low", 0.25f, 1, 2, sea_of(depth)},
        {"depth of water, high", 1e6f, 1e4f, 100, sea_of(depth)},
        {"wind, low", 0.5f, 2, 3, sea_of(wind)},
        {"wind, high", 50, 30, 25, sea_of(wind)},
        {"fetch, low", 10, 1000, 3000, sea_of(fetch)},
        {"height of a swell, low", -1, 0, 1, sea_of(swell_height)},
        {"period of a swell, low", 2, 5, 8, sea_of(swell_period)},
        {"period of a swell, high", 40, 25, 20, sea_of(swell_period)},
        {"roughness, low", 0.001f, 0.03f, 0.1f, finished},
        {"roughness, high", 1.5f, 1, 0.9f, finished},
    };
    return all_limits;
}

} // namespace

TEST_CASE("arguments beyond their range count as its end") {
    for (const Limit& limit : limits()) {
        CAPTURE(limit.name);
        Random random(1);
        bool inner_differs = false;
        for (int i = 0; i < 64; ++i) {
            const auto p = random.uniform<gabor_vec2>(-3, 3), q = random.uniform<gabor_vec2>(-1, 1);
            CAPTURE(p.x, p.y, q.x, q.y);
            const Values end = limit.values(limit.end, p, q);
            for (const float value : end)
                REQUIRE(std::isfinite(value));
            CHECK(limit.values(limit.beyond, p, q) == end);
            inner_differs = inner_differs || limit.values(limit.within, p, q) != end;
        }
        CHECK(inner_differs);
    }
}

TEST_CASE("an infinite wave vector counts as one of 10^6") {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float p : {0.0f, 0.25f, 1.5f}) {
        CAPTURE(p);
        const gabor_vec2 at(p, -p);
        CHECK(gabor_noise(at, infinity, 0, 7) == gabor_noise(at, 1e6f, 0, 7));
        CHECK(gabor_noise(at, -1e9f, 0, 7) == gabor_noise(at, 1e6f, 0, 7));
        CHECK(gabor_noise_spread(at, infinity, 0, 0, 0, 7) == gabor_noise_spread(at, 1e6f, 0, 0, 0, 7));
        CHECK(gabor_field(gabor_place_at(at), gabor_vec2(-infinity, 1e8f), 7).noise ==
              gabor_field(gabor_place_at(at), gabor_vec2(-1e6f, 1e6f), 7).noise);
    }
}
