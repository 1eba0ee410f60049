// Compares the sea with the JONSWAP spectrum and linear wave theory, in double precision and from the
// equations.

#include "compare.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include "gabor_noise.hpp"

#include "gabor_ocean.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <vector>

using gabor::statistics::Moments;
using gabor::test::Random;

namespace {

constexpr double pi = std::numbers::pi, gravity = 9.81;

GaborOcean ocean_of(float wind, float direction, float fetch, gabor_vec3 swell, int loop, float depth = 0) {
    GaborSea sea = gabor_sea();
    sea.wind = wind;
    sea.direction = direction;
    sea.fetch = fetch;
    sea.swell_height = swell.x;
    sea.swell_period = swell.y;
    sea.swell_direction = swell.z;
    sea.loop_seconds = loop;
    sea.water_depth = depth;
    return gabor_ocean_of(sea);
}

// The wave number in radians per metre, by bisection.
double wave_number(double frequency, double depth) {
    const double square = std::pow(2 * pi * frequency, 2);
    if (depth == 0)
        return square / gravity;
    double low = 0, high = square / gravity + 2 * pi * frequency / std::sqrt(gravity * depth) + 1;
    for (int i = 0; i < 100; ++i) {
        const double k = (low + high) / 2;
        (gravity * k * std::tanh(k * depth) < square ? low : high) = k;
    }
    return low;
}

// The spectrum of Hasselmann and others (1973) with the spread of Hasselmann, Dunckel and Ewing (1980), and
// the factor of Bouws and others (1985) in finite depth, as a sum of many plane waves.
struct Wave {
    double frequency, x, y, power; // turns per second, cycles per metre, variance of the height
};
std::vector<Wave> waves(double wind, double direction, double fetch, double low, double high, int rings,
                        int spokes, double depth = 0) {
    const double reach = std::min(gravity * fetch / (wind * wind), 2.15e4); // fully developed
    const double peak = 3.5 * gravity / wind * std::pow(reach, -0.33), alpha = 0.076 * std::pow(reach, -0.22);
    std::vector<Wave> all;
    for (int i = 0; i < rings; ++i) {
        const double f = low * std::pow(high / low, (i + 0.5) / rings),
                     width = f * std::log(high / low) / rings;
        const double sigma = f < peak ? 0.07 : 0.09;
        const double k = wave_number(f, depth), slow = std::tanh(depth == 0 ? 99 : k * depth),
                     shallow = depth == 0 ? 0 : 2 * k * depth / std::sinh(std::min(2 * k * depth, 300.0));
        const double power = slow * slow / (1 + shallow) * alpha * gravity * gravity * std::pow(2 * pi, -4) *
                             std::pow(f, -5) * std::exp(-1.25 * std::pow(peak / f, 4)) *
                             std::pow(3.3, std::exp(-std::pow(f / peak - 1, 2) / (2 * sigma * sigma))) *
                             width;
        const double age = std::min(2 * pi * peak * wind / gravity, 2.0); // wind over the peak's phase speed
        const double s = f < peak ? 6.97 * std::pow(f / peak, 4.06)
                                  : 9.77 * std::pow(f / peak, -2.33 - 1.45 * (age - 1.17));
        double sum = 0;
        const std::size_t first = all.size();
        for (int j = 0; j < spokes; ++j) {
            const double angle = 2 * pi * (j + 0.5) / spokes - pi;
            const double spread = std::pow(std::abs(std::cos(angle / 2)), 2 * s);
            sum += spread;
            all.push_back({f, k / (2 * pi) * std::cos(angle + direction),
                           k / (2 * pi) * std::sin(angle + direction), spread});
        }
        for (std::size_t j = first; j < all.size(); ++j)
            all[j].power *= power / sum;
    }
    return all;
}

// The frequencies of a sea's bands in Hz.
double lowest(const GaborOcean& sea) {
    return static_cast<double>(sea.band[0].low) / 65536;
}
double highest(const GaborOcean& sea) {
    int last = GABOR_OCEAN_BANDS - 1; // shorter waves than 0.1 m are left out
    while (sea.band[last].amplitude == 0)
        --last;
    return static_cast<double>(sea.band[last].low) / 65536 * std::sqrt(2);
}

struct Place {
    gabor_ivec2 cell;
    gabor_vec2 local;
    int second;
    float fraction;
    std::uint32_t seed;

    GaborWater water(const GaborOcean& sea, double x = 0, double y = 0, double time = 0,
                     float pixel = 0) const {
        const double at = fraction + time, whole = std::floor(at);
        return gabor_water_at(cell, local + gabor_vec2(static_cast<float>(x), static_cast<float>(y)),
                              second + static_cast<int>(whole), static_cast<float>(at - whole), {pixel, 0},
                              {0, pixel}, sea, seed);
    }
};
Place anywhere(Random& random) {
    return {{static_cast<int>(random.word() % 200000) - 100000,
             static_cast<int>(random.word() % 200000) - 100000},
            random.uniform<gabor_vec2>(0, 1),
            static_cast<int>(random.word() % 20000000) - 10000000,
            random.uniform(0, 1),
            random.word()};
}

const GaborOcean seas[]{gabor_ocean(12), ocean_of(3, 0.8f, 3e3f, {0, 0, 0}, 0),
                        ocean_of(22, -2.5f, 8e5f, {0, 0, 0}, 0)};

double power_of(const GaborOceanBand& band) {
    return static_cast<double>(band.amplitude * band.amplitude);
}

} // namespace

// A sea is fully developed where the wind has blown over 2.15e4 wind^2 / g: at 3 m/s, 20 km. Beyond the
// ranges, each argument is as at its end.
TEST_CASE("the sea grows with wind and fetch up to a fully developed one, and within the ranges", "[ocean]") {
    double before = 0;
    for (const float wind : {2.0f, 3.0f, 5.0f, 8.0f, 12.0f, 20.0f, 30.0f})
        for (const float fetch : {1e3f, 2e4f, 2e5f, 1e6f}) {
            const GaborOcean sea = ocean_of(wind, 0, fetch, {0, 0, 0}, 0);
            double expected = 0, found = 0, slopes = 0;
            for (const Wave& wave : waves(wind, 0, fetch, lowest(sea), highest(sea), 20000, 1))
                expected += wave.power;
            for (const GaborOceanBand& band : sea.band) {
                found += power_of(band);
                slopes += static_cast<double>(band.slopes.x + band.slopes.y);
            }
            INFO(wind << " m/s, " << fetch << " m: " << 4 * std::sqrt(found) << " m");
            CHECK(found == Approx(expected).epsilon(0.02));
            CHECK((sea.tail.x >= 0 && sea.tail.y >= 0));
            // Cox and Munk: 0.003 + 0.00512 wind in all, of which the bands have at most 1.8 times that
            CHECK(slopes < 1.8 * (0.003 + 0.00512 * static_cast<double>(wind)) + 1e-3);
            if (fetch == 1e6f) {
                CHECK(found > before);
                before = found;
            }
        }
    // At 3 m/s, a fully developed sea is 0.28 m high.
    double calm = 0;
    for (const GaborOceanBand& band : gabor_ocean(3).band)
        calm += power_of(band);
    CHECK(4 * std::sqrt(calm) == Approx(0.28).margin(0.01));

    const auto same = [](const GaborOcean& beyond, const GaborOcean& end) {
        CHECK(beyond.wind == end.wind);
        CHECK(beyond.fetch == end.fetch);
        CHECK(beyond.loop_seconds == end.loop_seconds);
        CHECK(beyond.tail.x == end.tail.x);
        for (int i = 0; i < GABOR_OCEAN_BANDS + 2; ++i) {
            CHECK(beyond.band[i].amplitude == end.band[i].amplitude);
            CHECK(beyond.band[i].low == end.band[i].low);
            CHECK(beyond.band[i].drift.x == end.band[i].drift.x);
        }
    };
    const auto of = [](float wind, float fetch, float height, float period, int loop) {
        return ocean_of(wind, 0, fetch, {height, period, 0}, loop);
    };
    same(of(0, 2e5f, 1, 10, 0), of(2, 2e5f, 1, 10, 0));
    same(of(-5, 2e5f, 1, 10, 0), of(2, 2e5f, 1, 10, 0));
    same(of(99, 2e5f, 1, 10, 0), of(30, 2e5f, 1, 10, 0));
    same(of(12, 0, 1, 10, 0), of(12, 1e3f, 1, 10, 0));
    same(of(12, 9e9f, 1, 10, 0), of(12, 1e6f, 1, 10, 0));
    same(of(12, 2e5f, -1, 10, 0), of(12, 2e5f, 0, 10, 0));
    same(of(12, 2e5f, 99, 10, 0), of(12, 2e5f, 30, 10, 0));
    same(of(12, 2e5f, 1, 1, 0), of(12, 2e5f, 1, 5, 0));
    same(of(12, 2e5f, 1, 99, 0), of(12, 2e5f, 1, 25, 0));
    for (const auto& [asked, given] : {std::pair(1, 8),
                                       {8, 8},
                                       {9, 8},
                                       {15, 8},
                                       {16, 16},
                                       {100, 64},
                                       {4095, 2048},
                                       {4096, 4096},
                                       {99999, 4096},
                                       {-3, 0}})
        CHECK(of(12, 2e5f, 1, 10, asked).loop_seconds == given);
}

TEST_CASE("heights and slopes of the sea have the spectrum's variance and are normal", "[ocean][law]") {
    for (const GaborOcean& sea : seas) {
        double height = 0, slopes = 0;
        for (const Wave& wave :
             waves(sea.wind, sea.direction, sea.fetch, lowest(sea), highest(sea), 20000, 1)) {
            height += wave.power;
            slopes += wave.power * std::pow(2 * pi, 2) * (wave.x * wave.x + wave.y * wave.y);
        }
        Random random(1);
        Moments heights, slope_x, slope_y;
        for (int i = 0; i < 1 << 18; ++i) {
            const GaborWater water = anywhere(random).water(sea);
            heights.add(water.height);
            slope_x.add(water.slope.x);
            slope_y.add(water.slope.y);
        }
        const double error = std::sqrt(2.0 / (1 << 18)); // of a variance, relative
        const double tall = heights.variance() / height,
                     steep = (slope_x.variance() + slope_y.variance()) / slopes;
        fmt::print("wind {}: variance of heights {:.4f}, of slopes {:.4f} (+- {:.4f}), kurtosis {:+.3f} and "
                   "{:+.3f}\n",
                   sea.wind, tall, steep, 2 * error, heights.excess_kurtosis(), slope_x.excess_kurtosis());
        CHECK(std::abs(tall - 1) < 0.005 + 2 * error);
        CHECK(std::abs(steep - 1) < 0.005 + 2 * error);
        CHECK(std::abs(heights.mean()) < 4 * std::sqrt(height / (1 << 18)));
        CHECK(std::abs(heights.excess_kurtosis()) < 0.05);
    }
}

TEST_CASE("heights and slopes of the sea are normal at any one place and time", "[ocean][law]") {
    for (const GaborOcean& sea : seas) {
        double height = 0;
        gabor_vec2 slopes{0, 0};
        const GaborOcean calm =
            ocean_of(sea.wind, 0, sea.fetch, {0, 0, 0}, 0); // whose slopes are along x and y
        for (const GaborOceanBand& band : calm.band) {
            height += static_cast<double>(band.amplitude * band.amplitude);
            slopes += band.slopes;
        }
        gabor::statistics::Gaussianity heights(std::sqrt(height)),
            along(std::sqrt(static_cast<double>(slopes.x))), across(std::sqrt(static_cast<double>(slopes.y)));
        for (std::uint32_t seed = 0; seed < 1 << 19; ++seed) {
            const GaborWater water = gabor_water({0, 0}, 0, calm, seed * 0x9e3779b9u);
            heights.add(static_cast<double>(water.height));
            along.add(static_cast<double>(water.slope.x));
            across.add(static_cast<double>(water.slope.y));
        }
        fmt::print("wind {}: cvm of heights {:.3f}, of slopes {:.2f} along the wind and {:.2f} across\n",
                   sea.wind, heights.index().value, along.index().value, across.index().value);
        CHECK(heights.index().value < 0.5);
        CHECK(along.index().value < 3);
        CHECK(across.index().value < 3);
    }
}

// Compares how much the direction and the strength of slopes' anisotropy vary between patches of 16 m. They
// vary more where fewer waves meet in a patch; from above, such a sea looks woven.
TEST_CASE("as many waves meet in a patch of water as in a sea of plane waves", "[ocean][law]") {
    constexpr int side = 16, patches = 300;
    for (const float wind : {12.0f, 20.0f}) {
        const GaborOcean sea = gabor_ocean(wind);
        const std::vector<Wave> plane = waves(wind, 0, sea.fetch, lowest(sea), highest(sea), 60, 60);
        Random random(1);
        const auto scatter = [&](const auto& slope_of) { // of (xx - yy, 2 xy) / (xx + yy)
            Moments share, turn;
            for (int patch = 0; patch < patches; ++patch) {
                double xx = 0, yy = 0, xy = 0;
                slope_of([&](double x, double y) {
                    xx += x * x;
                    yy += y * y;
                    xy += x * y;
                });
                share.add((xx - yy) / (xx + yy));
                turn.add(2 * xy / (xx + yy));
            }
            return share.variance() + turn.variance();
        };
        const double seen = scatter([&](const auto& add) {
            const Place place = anywhere(random);
            for (int i = 0; i < side * side; ++i) {
                const gabor_vec2 slope = place.water(sea, i % side, i / side).slope;
                add(static_cast<double>(slope.x), static_cast<double>(slope.y));
            }
        });
        const double ideal = scatter([&](const auto& add) {
            std::vector<std::complex<double>> slopes_x(side * side), slopes_y(side * side);
            for (const Wave& wave : plane) {
                const double phase = 2 * pi * static_cast<double>(random.uniform(0, 1));
                const std::complex<double> right = std::polar(1.0, 2 * pi * wave.x),
                                           up = std::polar(1.0, 2 * pi * wave.y);
                std::complex<double> row = std::polar(2 * pi * std::sqrt(2 * wave.power), phase);
                for (int y = 0; y < side; ++y, row *= up) {
                    std::complex<double> value = row;
                    for (int x = 0; x < side; ++x, value *= right) {
                        slopes_x[static_cast<std::size_t>(side * y + x)] += wave.x * value;
                        slopes_y[static_cast<std::size_t>(side * y + x)] += wave.y * value;
                    }
                }
            }
            for (std::size_t i = 0; i < slopes_x.size(); ++i)
                add(slopes_x[i].real(), slopes_y[i].real());
        });
        fmt::print("wind {}: slopes of patches scatter by {:.4f}, those of plane waves by {:.4f}\n", wind,
                   seen, ideal);
        CHECK(seen < 1.45 * ideal);
        CHECK(seen > 0.8 * ideal);
    }
}

// Bins have 20 degrees of direction and a tenth of an octave of wavelength. The windows blur each wave, here
// as much as a normal distribution of their derivatives' variance. Short waves are up to 6 % longer and
// 3 % lower than the spectrum's, which makes up for the slopes that their windows add.
TEST_CASE("the waves of the sea's nodes have its spectrum by direction and wavelength", "[ocean][law]") {
    for (const GaborOcean& sea : seas) {
        std::map<std::array<int, 2>, std::array<double, 4>> bins; // height found and expected, slope likewise
        std::mt19937 random(7);
        std::normal_distribution<> normal;
        const GaborOcean calm =
            ocean_of(sea.wind, -0.785398f, sea.fetch, {0, 0, 0}, 0); // along x of the lattices
        for (int i = 0; i < GABOR_OCEAN_BANDS && calm.band[i].amplitude > 0; ++i) {
            const GaborOceanBand& band = calm.band[i];
            const float size = std::exp2(static_cast<float>(band.exponent));
            const double blur = std::sqrt(2 * 3.372) / (2 * pi * static_cast<double>(size));
            const auto add = [&](double x, double y, double power, std::size_t of) {
                x += blur * normal(random);
                y += blur * normal(random);
                const double k = std::hypot(x, y);
                auto& bin = bins[{static_cast<int>(std::floor(std::atan2(y, x) * 9 / pi)),
                                  static_cast<int>(std::floor(10 * std::log2(k)))}];
                bin[of] += power;
                bin[2 + of] += power * k * k;
            };
            const double low = static_cast<double>(band.low) / 65536;
            const double high = i + 1 < GABOR_OCEAN_BANDS ? static_cast<double>(calm.band[i + 1].low) / 65536
                                                          : low * std::sqrt(2);
            for (const Wave& wave : waves(sea.wind, 0, sea.fetch, low, high, 500, 720))
                add(wave.x, wave.y, wave.power, 1);
            constexpr int count = 1 << 18;
            for (int draw = 0; draw < count; ++draw) {
                const auto seed = static_cast<std::uint32_t>(random()), salt = gabor_impl_salt(seed);
                const gabor_vec2 shift(static_cast<float>(salt & 0xffffu), static_cast<float>(salt >> 16u));
                const auto node = [&](float time) { // the water at a node, where the others have no weight
                    GaborWater sum{};
                    gabor_vec3 squeeze{0, 0, 0};
                    gabor_impl_add_band(sum, squeeze, band, i < 5, {1, 0}, {1, 1}, 0, {0, 0},
                                        -size / 65536 * shift, 0, time, {0, 0}, {0, 0}, seed);
                    return sum;
                };
                const GaborWater now = node(0);
                // The real part is positive if the height, an imaginary part, falls.
                const float soon = 0.002f * 65536 / band.low, fall = now.height - node(soon).height;
                const float length = std::hypot(now.shift.x, now.shift.y);
                if (length == 0)
                    continue;
                const float k = (fall > 0 ? 1 : -1) / (length * static_cast<float>(2 * pi));
                add(static_cast<double>(k * now.slope.x), static_cast<double>(k * now.slope.y),
                    static_cast<double>(band.amplitude * band.amplitude) / count, 0);
            }
        }
        std::array<double, 2> apart{}, total{};
        for (const auto& [at, power] : bins)
            for (const std::size_t of : {0u, 1u}) {
                apart[of] += std::abs(power[2 * of] - power[2 * of + 1]);
                total[of] += power[2 * of + 1];
            }
        fmt::print("wind {}: L1 {:.3f} in height and {:.3f} in slope, in {} bins\n", sea.wind,
                   apart[0] / total[0], apart[1] / total[1], bins.size());
        CHECK(apart[0] < 0.1 * total[0]);
        CHECK(apart[1] < 0.12 * total[1]);
    }
}

// With the sign of the drift's phase flipped, the correlation along the wind errs by up to 0.5.
TEST_CASE("the sea's waves travel as the dispersion relation says", "[ocean][law]") {
    const GaborOcean sea = ocean_of(12, 0.8f, 2e5f, {0, 0, 0}, 0);
    const std::vector<Wave> theory =
        waves(sea.wind, sea.direction, sea.fetch, lowest(sea), highest(sea), 400, 90);
    double power = 0;
    for (const Wave& wave : theory)
        power += wave.power;
    const double along_x = std::cos(0.8), along_y = std::sin(0.8);
    double worst = 0, worst_apart = 0;
    for (const auto& [distance, across, time] : std::to_array<std::array<double, 3>>({{0, 0, 2},
                                                                                      {0, 0, 5},
                                                                                      {0, 0, 10},
                                                                                      {0, 0, 20},
                                                                                      {0, 0, 60},
                                                                                      {20, 0, 0},
                                                                                      {50, 0, 0},
                                                                                      {0, 30, 0},
                                                                                      {25, 0, 2},
                                                                                      {60, 0, 5},
                                                                                      {-40, 0, 4},
                                                                                      {126, 0, 10},
                                                                                      {63, 0, 10},
                                                                                      {252, 0, 20},
                                                                                      {126, 40, 20},
                                                                                      {200, 0, 30}})) {
        const double x = distance * along_x - across * along_y, y = distance * along_y + across * along_x;
        double expected = 0;
        for (const Wave& wave : theory)
            expected +=
                wave.power / power * std::cos(2 * pi * (wave.x * x + wave.y * y - wave.frequency * time));
        Random random(2);
        double product = 0, here_power = 0, there_power = 0;
        for (int i = 0; i < 1 << 16; ++i) {
            const Place place = anywhere(random);
            const double here = place.water(sea).height, there = place.water(sea, x, y, time).height;
            product += here * there;
            here_power += here * here;
            there_power += there * there;
        }
        const double found = product / std::sqrt(here_power * there_power);
        fmt::print(
            "{:4} m along and {:2} m across the wind, {:2} s later: correlation {:+.3f}, expected {:+.3f}\n",
            distance, across, time, found, expected);
        double& of = distance == 0 && across == 0 ? worst : worst_apart;
        of = std::max(of, std::abs(found - expected));
    }
    const double chance = 2 / std::sqrt(1 << 16);
    CHECK(worst < 0.03 + chance);
    CHECK(worst_apart < 0.05 + chance); // bands widen the peak of the spectrum
}

TEST_CASE("waves of shallow water have its heights, slopes and speed", "[ocean][law]") {
    for (const auto& [wind, depth] : {std::pair(12.0f, 6.0f), {8.0f, 2.0f}}) {
        const GaborOcean sea = ocean_of(wind, 0.8f, 2e5f, {0, 0, 0}, 0, depth);
        const std::vector<Wave> theory =
            waves(sea.wind, 0, sea.fetch, lowest(sea), highest(sea), 1000, 90, depth);
        double power = 0, steep = 0, worst = 0;
        for (const Wave& wave : theory) {
            power += wave.power;
            steep += wave.power * std::pow(2 * pi, 2) * (wave.x * wave.x + wave.y * wave.y);
        }
        const double period = 1 / (lowest(sea) * 1.5), length = 2 * pi / wave_number(1 / period, depth);
        Moments heights, slope_x, slope_y;
        for (const auto& [distance, time] : std::to_array<std::array<double, 2>>(
                 {{0, 0.3}, {0, 1}, {0.3, 0}, {0.5, 0.5}, {0.5, 0}, {1, 1}, {2, 2}})) {
            const double along = distance * length, later = time * period;
            double expected = 0;
            for (const Wave& wave : theory)
                expected += wave.power / power * std::cos(2 * pi * (wave.x * along - wave.frequency * later));
            Random random(12);
            double product = 0;
            constexpr int count = 1 << 15;
            for (int i = 0; i < count; ++i) {
                const Place place = anywhere(random);
                const GaborWater here = place.water(sea);
                heights.add(here.height);
                slope_x.add(here.slope.x);
                slope_y.add(here.slope.y);
                product += here.height *
                           place.water(sea, along * std::cos(0.8), along * std::sin(0.8), later).height /
                           power / count;
            }
            fmt::print("{} m deep: {:.1f} m along, {:.1f} s later: correlation {:+.3f}, expected {:+.3f}\n",
                       depth, along, later, product, expected);
            worst = std::max(worst, std::abs(product - expected));
        }
        const double slopes = slope_x.variance() + slope_y.variance();
        fmt::print("{} m deep: variance of heights {:.4f} of {:.4f}, of slopes {:.5f} of {:.5f}\n", depth,
                   heights.variance(), power, slopes, steep);
        CHECK(worst < 0.06);
        CHECK(heights.variance() == Approx(power).epsilon(0.02));
        CHECK(slopes == Approx(steep).epsilon(0.02));
    }
    // A depth that waves do not feel changes nothing much.
    CHECK(ocean_of(12, 0, 2e5f, {0, 0, 0}, 0, 1e4f).band[2].amplitude ==
          Approx(ocean_of(12, 0, 2e5f, {0, 0, 0}, 0).band[2].amplitude));
}

TEST_CASE("a swell is at most 0.07 of its wavelength high", "[ocean]") {
    const auto height = [](float asked, float period, float depth) {
        const GaborOcean sea = ocean_of(10, 0, 2e5f, {asked, period, 0}, 0, depth);
        return 4 *
               std::sqrt(power_of(sea.band[GABOR_OCEAN_BANDS]) + power_of(sea.band[GABOR_OCEAN_BANDS + 1]));
    };
    CHECK(height(2, 5, 0) == Approx(2).epsilon(0.003));
    CHECK(height(30, 5, 0) == Approx(0.07 * gravity / (2 * pi) * 25).epsilon(0.003));
    const double k = wave_number(0.1, 3);
    CHECK(height(30, 10, 3) == Approx(0.07 * 2 * pi / k * std::tanh(3 * k)).epsilon(0.003));
}

TEST_CASE("a sea that turns as a whole is as high along its wind", "[ocean]") {
    const GaborOcean sea = ocean_of(12, 0, 2e5f, {4, 11, 0.4f}, 0);
    for (const float angle : {0.7f, 1.6f, -2.5f}) {
        const GaborOcean turned = ocean_of(12, angle, 2e5f, {4, 11, angle + 0.4f}, 0);
        CHECK(turned.high.x == Approx(sea.high.x).epsilon(1e-4));
        CHECK(turned.high.y == Approx(sea.high.y).epsilon(1e-4));
    }
    CHECK(ocean_of(12, 0, 2e5f, {4, 11, 1.5f}, 0).high.y < 0.8 * sea.high.y); // whose swell crosses the wind
}

TEST_CASE("the water's velocity is the derivative of its place", "[ocean]") {
    for (const GaborOcean& sea :
         {seas[0], seas[2], ocean_of(12, 0.8f, 2e5f, {3, 11, 2}, 0), ocean_of(12, 0.8f, 2e5f, {3, 11, 2}, 64),
          ocean_of(10, 0.4f, 2e5f, {0, 0, 0}, 0, 5)}) {
        Random random(13);
        std::array<double, 3> apart{}, total{};
        for (int i = 0; i < 4000; ++i) {
            const Place place = anywhere(random);
            const GaborWater here = place.water(sea), soon = place.water(sea, 0, 0, 0.02),
                             before = place.water(sea, 0, 0, -0.02);
            const gabor_vec2 side = 25.0f * (soon.shift - before.shift);
            const float up = 25 * (soon.height - before.height);
            const std::array found{here.velocity.x, here.velocity.y, here.velocity.z},
                expected{side.x, side.y, up};
            for (std::size_t c = 0; c < 3; ++c) {
                apart[c] += std::pow(found[c] - expected[c], 2);
                total[c] += std::pow(expected[c], 2);
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            fmt::print("wind {}, depth {}: rms velocity {:.3f} m/s, error {:.4f}\n", sea.wind,
                       sea.water_depth, std::sqrt(total[c] / 4000), std::sqrt(apart[c] / 4000));
            CHECK(std::sqrt(apart[c] / total[c]) < 0.03);
        }
    }
}

// Monahan and O'Muircheartaigh, 1980.
TEST_CASE("foam covers as much of the sea as was measured, at any fetch and in any pixel", "[ocean][law]") {
    for (const float wind : {4.0f, 6.0f, 10.0f, 15.0f, 25.0f})
        for (const float fetch : {2e4f, 1e6f})
            for (const float pixel : {0.0f, 4.0f, 40.0f}) {
                const GaborOcean sea = ocean_of(wind, 0.6f, fetch, {0, 0, 0}, 0);
                Random random(14);
                double covered = 0;
                const int count = pixel == 0 && wind < 12 ? 1 << 17 : 1 << 14;
                for (int i = 0; i < count; ++i) {
                    const gabor_vec2 p = random.uniform<gabor_vec2>(-20000, 20000), dx{pixel, 0},
                                     dy{0, pixel};
                    const std::uint32_t seed = random.word();
                    covered += gabor_foam(p, dx, dy,
                                          gabor_water_filtered(p, dx, dy, random.uniform(0, 5000), sea, seed),
                                          sea, seed);
                }
                const double measured = 3.84e-6 * std::pow(wind, 3.41);
                fmt::print("wind {}, fetch {}, pixel {} m: foam on {:.5f} of the sea, measured {:.5f}\n",
                           wind, fetch, pixel, covered / count, measured);
                if (wind < 6)
                    CHECK(covered / count < 0.0015);
                else
                    CHECK(covered / count == Approx(measured).epsilon(0.2));
            }
}

TEST_CASE("a patch of foam lasts", "[ocean][law]") {
    const GaborOcean sea = ocean_of(10, 0.6f, 2e5f, {0, 0, 0}, 0);
    Random random(15);
    std::array<double, 4> product{};
    double sum = 0, square = 0;
    constexpr int count = 1 << 16;
    for (int i = 0; i < count; ++i) {
        const gabor_vec2 p = random.uniform<gabor_vec2>(-20000, 20000);
        const float time = random.uniform(0, 5000);
        const std::uint32_t seed = random.word();
        const auto foam = [&](float later) {
            return static_cast<double>(
                gabor_foam(p, {0, 0}, {0, 0}, gabor_water(p, time + later, sea, seed), sea, seed));
        };
        const double now = foam(0);
        sum += now / count;
        square += now * now / count;
        for (std::size_t later = 1; later < 4 && now > 1e-4; ++later)
            product[later] += now * foam(static_cast<float>(later)) / count;
    }
    for (std::size_t later = 1; later < 4; ++later)
        fmt::print("correlation of foam after {} s: {:.3f}\n", later,
                   (product[later] - sum * sum) / (square - sum * sum));
    CHECK(product[2] - sum * sum > 0.5 * (square - sum * sum));
}

TEST_CASE("the sea moves on without a jump, after any time", "[ocean]") {
    Random random(6);
    gabor::test::Largest jump;
    const GaborOcean ripples = ocean_of(3, 0, 3e3f, {0, 0, 0}, 0); // whose nodes pass fastest, along x
    for (int bit = 0; bit < 31; ++bit)
        for (const GaborOcean& sea : {seas[0], seas[1], seas[2], ripples}) {
            Place place = anywhere(random);
            const auto second = static_cast<int>((std::uint32_t{1} << bit) - 1);
            for (const int last : {second, -second - 2}) {
                place.second = last;
                place.fraction = 1;
                const GaborWater before = place.water(sea, 0, 0, -1e-6);
                jump.see(place.water(sea).height, before.height, 1e-3,
                         [&] { return fmt::format("after second {}", last); });
            }
        }
    jump.check("height");
}

TEST_CASE("a swell has its height, period and direction and rides on the sea", "[ocean][law]") {
    const GaborOcean sea = ocean_of(12, 0.8f, 2e5f, {3, 14, -2}, 0),
                     calm = ocean_of(12, 0.8f, 2e5f, {0, 0, 0}, 0);
    std::vector<Wave> remote; // JONSWAP's form with a peak raised eight times, and cos(d / 2)^150
    double remote_power = 0;
    for (double f = 0.6 / 14; f < 2.06 / 14; f += 0.002 / 14) {
        const double sigma = f < 1 / 14.0 ? 0.07 : 0.09, k = f * f * 2 * pi / gravity;
        const double power = std::pow(14 * f, -5) * std::exp(-1.25 * std::pow(14 * f, -4)) *
                             std::pow(8, std::exp(-std::pow(14 * f - 1, 2) / (2 * sigma * sigma)));
        double spread = 0;
        for (double d = -0.8; d < 0.8; d += 0.05)
            spread += std::pow(std::cos(d / 2), 150);
        for (double d = -0.8; d < 0.8; d += 0.05)
            remote.push_back(
                {f, k * std::cos(d), k * std::sin(d), power * std::pow(std::cos(d / 2), 150) / spread});
        remote_power += power;
    }
    const auto expected = [&](double along, double across, double time) {
        double sum = 0;
        for (const Wave& wave : remote)
            sum += wave.power / remote_power *
                   std::cos(2 * pi * (wave.x * along + wave.y * across - wave.frequency * time));
        return sum;
    };
    Random random(8);
    Moments both;
    double swell = 0, cosines = 0, later = 0, there = 0, across = 0;
    constexpr int count = 1 << 17;
    const double wavelength = gravity * 14 * 14 / (2 * pi);
    const auto swell_at = [&](const Place& place, double x, double y, double time) {
        return static_cast<double>(place.water(sea, x, y, time).height -
                                   place.water(calm, x, y, time).height);
    };
    for (int i = 0; i < count; ++i) {
        const Place place = anywhere(random);
        both.add(place.water(sea).height);
        const double here = swell_at(place, 0, 0, 0);
        swell += here * here / count;
        if (i >= count / 8)
            continue;
        cosines += here * here;
        later += here * swell_at(place, 0, 0, 7);
        there += here * swell_at(place, wavelength / 2 * std::cos(-2), wavelength / 2 * std::sin(-2), 7);
        across += here * swell_at(place, -wavelength / 2 * std::sin(-2), wavelength / 2 * std::cos(-2), 0);
    }
    const double wind_sea = [&] {
        double power = 0;
        for (const Wave& wave : waves(12, 0, 2e5, lowest(sea), highest(sea), 20000, 1))
            power += wave.power;
        return power;
    }();
    fmt::print(
        "variance of the swell {:.4f} of {:.4f}, of both {:.4f} of {:.4f}; correlation half a period "
        "later {:.3f} of {:.3f}, and half a wave on {:.3f} of {:.3f}; half a wave across {:.3f} of {:.3f}\n",
        swell, 9 / 16.0, both.variance(), 9 / 16.0 + wind_sea, later / cosines, expected(0, 0, 7),
        there / cosines, expected(wavelength / 2, 0, 7), across / cosines, expected(0, wavelength / 2, 0));
    CHECK(std::abs(swell / (9 / 16.0) - 1) < 0.005 + 2 * std::sqrt(2.0 / count));
    CHECK(std::abs(both.variance() / (9 / 16.0 + wind_sea) - 1) < 0.005 + 2 * std::sqrt(2.0 / count));
    CHECK(std::abs(later / cosines - expected(0, 0, 7)) < 0.05);
    CHECK(std::abs(there / cosines - expected(wavelength / 2, 0, 7)) < 0.05);
    CHECK(std::abs(across / cosines - expected(0, wavelength / 2, 0)) < 0.05);
    CHECK(sea.tail.x == calm.tail.x); // a swell takes no roughness from the wind's sea
    CHECK(sea.tail.y == calm.tail.y);
}

TEST_CASE("a sea that loops is the same after a loop, bit by bit, and has the same law", "[ocean][law]") {
    for (const int loop : {8, 64, 4096}) {
        const GaborOcean sea = ocean_of(12, 0.8f, 2e5f, {2, 11, 0}, loop),
                         endless = ocean_of(12, 0.8f, 2e5f, {2, 11, 0}, 0);
        CHECK(ocean_of(12, 0.8f, 2e5f, {2, 11, 0}, loop - 1).loop_seconds == std::max(loop / 2, 8));
        Random random(9);
        Moments heights, slopes, heights_endless, slopes_endless;
        double half = 0;
        int differ = 0;
        constexpr int count = 1 << 16;
        for (int i = 0; i < count; ++i) {
            Place place = anywhere(random);
            const GaborWater now = place.water(sea), other = place.water(endless);
            heights.add(now.height);
            slopes.add(now.slope.x);
            heights_endless.add(other.height);
            slopes_endless.add(other.slope.x);
            place.second += loop;
            const GaborWater later = place.water(sea);
            differ +=
                now.height != later.height || now.slope.x != later.slope.x || now.jacobian != later.jacobian;
            place.second -= loop / 2;
            half += now.height * place.water(sea).height;
        }
        const double tall = heights.variance() / heights_endless.variance(),
                     steep = slopes.variance() / slopes_endless.variance();
        fmt::print("loop of {} s: {} of {} differ after it; variance of heights {:.3f} and slopes {:.3f} of "
                   "an endless sea's; correlation "
                   "after half of it {:.3f}\n",
                   loop, differ, count, tall, steep, half / count / heights.variance());
        CHECK(differ == 0);
        CHECK(std::abs(tall - 1) < 0.02);
        CHECK(std::abs(steep - 1) < 0.02 + 1.0 / loop); // frequencies are rounded
        CHECK(std::abs(half / count / heights.variance()) < 0.9);
    }
}

TEST_CASE("in a loop, each wave has a whole number of periods, and at least one", "[ocean]") {
    for (const float wind : {12.0f, 30.0f}) {
        const GaborOcean sea = ocean_of(wind, 0.8f, 1e6f, {3, 25, 0}, 8);
        Moments means, heights;
        for (int i = 0; i < 64; ++i) {
            Moments there;
            for (int k = 0; k < 64; ++k)
                there.add(gabor_water_at({977 * i, 31 * i * i}, {0.5f, 0.5f}, k / 8, float(k % 8) / 8, {0, 0},
                                         {0, 0}, sea, std::uint32_t(i))
                              .height);
            means.add(there.mean());
            heights.merge(there);
        }
        fmt::print(
            "wind {}: means of a loop from {:.1e} to {:.1e} m, of heights with a deviation of {:.2f} m\n",
            wind, means.minimum(), means.maximum(), std::sqrt(heights.variance()));
        CHECK(std::max(-means.minimum(), means.maximum()) < 1e-4);
        CHECK(heights.variance() > 1);
    }
}

TEST_CASE("slopes, shifts and folds of the sea are derivatives of its heights and shifts", "[ocean]") {
    Random random(3);
    gabor::test::Largest slope, fold;
    for (const GaborOcean& sea : seas)
        for (int i = 0; i < 2000; ++i) {
            const Place place = anywhere(random);
            const double step = std::exp2(sea.band[GABOR_OCEAN_BANDS - 1].exponent - 9), half = 0.5 / step;
            const GaborWater here = place.water(sea), right = place.water(sea, step),
                             left = place.water(sea, -step), up = place.water(sea, 0, step),
                             down = place.water(sea, 0, -step);
            const auto where = [&] { return fmt::format("wind {}, point {}", sea.wind, i); };
            slope.see(here.slope.x, half * (right.height - left.height), 5e-3, where);
            slope.see(here.slope.y, half * (up.height - down.height), 5e-3, where);
            const gabor_vec2 along_x = static_cast<float>(half) * (right.shift - left.shift),
                             along_y = static_cast<float>(half) * (up.shift - down.shift);
            fold.see(here.jacobian, (1 + along_x.x) * (1 + along_y.y) - along_x.y * along_y.x, 0.15, where);
        }
    slope.check("slope");
    fold.check("jacobian");
}

TEST_CASE("the sea's filter keeps or loses all variance of the slopes, and the rest is Cox and Munk's",
          "[ocean]") {
    for (const GaborOcean& sea : seas)
        for (const float pixel : {0.05f, 0.5f, 5.0f, 50.0f, 1000.0f}) {
            Random random(4);
            gabor_vec3 plain{0, 0, 0}, kept{0, 0, 0}, lost{0, 0, 0};
            constexpr int count = 1 << 15;
            for (int i = 0; i < count; ++i) {
                const Place place = anywhere(random);
                const GaborWater sharp = place.water(sea), soft = place.water(sea, 0, 0, 0, pixel);
                const auto squares = [](gabor_vec2 s) { return gabor_vec3(s.x * s.x, s.y * s.y, s.x * s.y); };
                plain += squares(sharp.slope) / static_cast<float>(count);
                kept += squares(soft.slope) / static_cast<float>(count);
                lost += (soft.lost - sharp.lost) / static_cast<float>(count);
            }
            const double total = plain.x + plain.y, found = kept.x + kept.y + lost.x + lost.y;
            fmt::print("wind {}, pixel {} m: kept {:.5f}, lost {:.5f}, of {:.5f}: {:.3f}\n", sea.wind, pixel,
                       kept.x + kept.y, lost.x + lost.y, total, found / total);
            CHECK(std::abs(found / total - 1) < 0.02);
            if (pixel == 1000 && sea.tail.x > 0 && sea.tail.y > 0) {
                const double all = total + sea.tail.x + sea.tail.y;
                CHECK(std::abs(all / (0.003 + 0.00508 * sea.wind) - 1) < 0.02);
            }
        }
}

TEST_CASE("a boat floats on the water above its place", "[ocean]") {
    Random random(5);
    double worst = 0, square = 0;
    int seen = 0;
    for (const GaborOcean& sea : seas)
        for (int i = 0; i < 1000; ++i) {
            const gabor_vec2 p = random.uniform<gabor_vec2>(-500, 500);
            const float time = random.uniform(0, 500);
            const std::uint32_t seed = random.word();
            gabor_vec2 at = p;
            GaborWater water = gabor_water(at, time, sea, seed);
            for (int step = 0; step < 200; ++step) { // small steps converge wherever the water does not fold
                at = at + 0.3f * (p - at - water.shift);
                water = gabor_water(at, time, sea, seed);
            }
            const gabor_vec2 apart = p - at - water.shift;
            if (water.jacobian < 0.3f || std::hypot(apart.x, apart.y) > 1e-3f)
                continue;
            const double error = std::abs(gabor_water_height(p, time, sea, seed) - water.height);
            worst = std::max(worst, error);
            square += error * error;
            ++seen;
        }
    fmt::print("{} places: rms error {:.4f} m, at worst {:.4f} m\n", seen, std::sqrt(square / seen), worst);
    CHECK(seen > 2500);
    CHECK(worst < 0.01);
}

// test_coarse_ocean.cpp: the height of a sea with a swell of 3 m and three bands.
double coarse_height(const float* p, float pixel, float seconds);

TEST_CASE("the swell and long waves are the same for any number of bands", "[ocean]") {
    const GaborOcean sea = ocean_of(12, 0.5f, 2e5f, {3, 12, 1}, 0);
    Random random(10);
    gabor::test::Largest height;
    for (int i = 0; i < 1000; ++i) { // the pixel shows three bands and the swell
        const float p[]{random.uniform(-900, 900), random.uniform(-900, 900)},
            seconds = random.uniform(0, 500);
        height.see(coarse_height(p, 60, seconds),
                   gabor_water_filtered({p[0], p[1]}, {60, 0}, {0, 60}, seconds, sea, 7u).height, 1e-3,
                   [&] { return fmt::format("point {}", i); });
    }
    height.check("height");
}
