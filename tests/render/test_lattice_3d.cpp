// Compares every function of gabor_lattice_3d.glsl on the device with the double-precision reference.

#include "reference/lattice.hpp"
#include "sampler_lattice_3d.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace gabor;
using noise::Lattice3d;
using test::Entry3d;
using test::Largest;
using test::LatticeSample3d;
using test::LatticeSampler3d;
using test::random_unit;
using Vector = Lattice3d::Vector;

namespace {

constexpr std::size_t per_batch = 1 << 9;

Vector wave_of(const LatticeSample3d& sample) {
    Vector wave = test::unit(sample.direction);
    for (double& coordinate : wave)
        coordinate *= sample.frequency;
    return wave;
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<float, 3> vector(test::Draw& draw, float reach) {
    return {draw.uniform(-reach, reach), draw.uniform(-reach, reach), draw.uniform(-reach, reach)};
}

// Draws places in all octants up to 10^6, or in any cell. One coordinate in four is on or next to a change of
// nodes, one in eight next to a node.
Lattice3d::Place draw_place(test::Draw& draw) {
    const float reach = std::exp2(draw.uniform(0, 20));
    Lattice3d::Place place;
    const bool far = draw.word() % 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float& local = place.local[axis];
        local = draw.uniform(-reach, reach);
        if (draw.word() % 4 == 0)
            local = std::nextafter(std::round(local) + (draw.word() % 3 ? 0.5f : 0.0f),
                                   draw.word() % 2 ? 1e9f : -1e9f);
        if (far) {
            place.cell[axis] = draw.cell();
            local -= std::floor(local);
        }
    }
    return place;
}

// Draws a position in any octant, and the place its functions see: p * 1.5 in single precision.
Lattice3d::Place draw_position(test::Draw& draw, std::array<float, 3>& p) {
    const float reach = std::exp2(draw.uniform(0, 18));
    p = vector(draw, reach);
    Lattice3d::Place place;
    for (std::size_t axis = 0; axis < 3; ++axis)
        place.local[axis] = p[axis] * 1.5f;
    return place;
}

// Waves turn by up to 2 pi F per radius, in single precision.
double tolerance(double frequency) {
    return 2e-5 * std::max(1.0, frequency / 4);
}

double slope_tolerance(double frequency) {
    return tolerance(frequency) * (2 * std::numbers::pi * frequency + 4);
}

enum class Period { none, any };

// Draws samples at a frequency; `here` receives the place of each position.
struct Samples {
    std::vector<LatticeSample3d> all;
    std::vector<Lattice3d::Place> here;

    Samples(test::Draw& draw, std::size_t count, float frequency, Period period) {
        for (std::size_t i = 0; i < count; ++i) {
            LatticeSample3d sample{draw_place(draw), frequency, vector(draw, 3), vector(draw, 3)};
            here.push_back(draw_position(draw, sample.p));
            sample.seed = draw.word();
            sample.place.time = here.back().time = draw.uniform(-2, 2);
            if (draw.word() % 4 == 0) // near the limit of the projection to the tangent plane
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sample.direction[axis] = sample.normal[axis] + draw.uniform(-0.3f, 0.3f);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (period == Period::any) {
                    sample.place.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                    sample.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
                }
                sample.tile[axis] = draw.uniform(0.5f, 9);
            }
            all.push_back(sample);
        }
    }
};

// Values and their tolerances, in the order of an answer.
using Numbers = std::vector<std::array<double, 2>>;

// For a field by place.
Numbers numbers_of(const Lattice3d::Field& field, const LatticeSample3d& sample) {
    const double tight = tolerance(sample.frequency);
    // Where a window ends, the derivative of its slope jumps by pi^2 / 2 within the rounding of `local`.
    double loose = slope_tolerance(sample.frequency);
    for (const float local : sample.place.local)
        loose = std::max(loose, 5 * 0x1p-23 * std::abs(double{local}));
    Numbers numbers{{field.value.real(), tight}, {field.value.imag(), tight}};
    for (const auto& slope : field.slope) {
        numbers.push_back({slope.real(), loose});
        numbers.push_back({slope.imag(), loose});
    }
    numbers.push_back({0, tight}); // nothing is removed
    return numbers;
}

void add(Lattice3d::Field& all, double weight, const Lattice3d::Field& one) {
    all.value += weight * one.value;
    for (std::size_t axis = 0; axis < 3; ++axis)
        all.slope[axis] += weight * one.slope[axis];
}

template <typename Expected>
void compare(LatticeSampler3d& sampler, const Samples& samples, Largest& largest, const Expected& expected) {
    std::ranges::copy(samples.all, sampler.samples().begin());
    const auto answers = sampler.answers(samples.all.size());
    for (std::size_t i = 0; i < samples.all.size(); ++i) {
        const Numbers numbers = expected(samples.all[i], samples.here[i]);
        for (std::size_t c = 0; c < numbers.size(); ++c)
            largest.see(answers[i].value[c], numbers[c][0], numbers[c][1], samples.all[i]);
    }
}

} // namespace

TEST_CASE("noise on the lattice in space agrees with the reference", "[oracle]") {
    const vulkan::Device device;
    fmt::print("lattice in space on {}; largest differences in units of the tolerance\n", device.info().name);
    const auto check = [&](const char* name, Entry3d entry, bool animated, Period period,
                           const auto& expected) {
        test::Draw draw(21);
        LatticeSampler3d sampler(device, per_batch, entry, false, animated);
        Largest largest;
        for (int batch = 0; batch < 16; ++batch) {
            // The frequencies cover 0.1 to 64 evenly in octaves.
            const float frequency = batch == 0 ? 0 : 0.1f * static_cast<float>(std::exp2(batch * 0.62));
            compare(sampler, Samples(draw, per_batch, frequency, period), largest, expected);
        }
        largest.check(name);
    };
    const auto field_of = [](const LatticeSample3d& sample, const Lattice3d::Place& place,
                             bool animated = false) {
        return Lattice3d(wave_of(sample), sample.seed, animated).field(place);
    };
    const auto by_place = [&](bool animated) {
        return [&, animated](const LatticeSample3d& sample, const Lattice3d::Place&) {
            return numbers_of(field_of(sample, sample.place, animated), sample);
        };
    };
    check("gabor_field_3d", Entry3d::field, false, Period::none, by_place(false));
    check("  with periods", Entry3d::field, false, Period::any, by_place(false));
    check("  animated", Entry3d::field, true, Period::none, by_place(true));
    check("gabor_noise_3d", Entry3d::noise, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
              return Numbers{{field_of(sample, here).value.imag(), tolerance(sample.frequency)}};
          });
    check("gabor_noise_3d_complex", Entry3d::complex, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
              const Lattice3d::Field field = field_of(sample, here);
              const double tight = tolerance(sample.frequency);
              return Numbers{{field.value.real(), tight}, {field.value.imag(), tight}};
          });
    check("gabor_noise_3d_gradient", Entry3d::gradient, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
              const Lattice3d::Field field = field_of(sample, here);
              const double loose = slope_tolerance(sample.frequency);
              return Numbers{{field.value.imag(), tolerance(sample.frequency)},
                             {field.slope[0].imag(), loose},
                             {field.slope[1].imag(), loose},
                             {field.slope[2].imag(), loose}};
          });
    check("gabor_noise_3d_four", Entry3d::four, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
              Numbers numbers;
              for (int channel = 0; channel < 4; ++channel)
                  numbers.push_back(
                      {Lattice3d(wave_of(sample),
                                 channel ? noise::lattice_lobe_seed(sample.seed, -channel) : sample.seed)
                           .field(here)
                           .value.imag(),
                       tolerance(sample.frequency)});
              return numbers;
          });
    check("gabor_noise_3d_animated", Entry3d::animated, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
              return Numbers{{field_of(sample, here, true).value.imag(), tolerance(sample.frequency)}};
          });
    check("gabor_noise_3d_tiled", Entry3d::tiled, false, Period::none,
          [&](const LatticeSample3d& sample, const Lattice3d::Place&) {
              // Only where a float resolves it: p rounds by 10^-6, and the wave turns by 2 pi F per radius.
              Lattice3d::Place tile;
              for (std::size_t axis = 0; axis < 3; ++axis) {
                  const double period = sample.tile[axis];
                  const double p = sample.p[axis];
                  if (std::abs(p) > 8)
                      return Numbers{};
                  const double nodes = std::max(std::floor(period * 1.5 + 0.5), 3.0);
                  tile.radius[axis] = static_cast<float>(nodes / period);
                  tile.local[axis] = static_cast<float>(p * nodes / period);
                  tile.period[axis] = static_cast<std::int32_t>(nodes);
              }
              return Numbers{{field_of(sample, tile).value.imag(), 1e-4 * (1 + sample.frequency)}};
          });
}

TEST_CASE("isotropic noise and surface noise on the lattice agree with the reference", "[oracle]") {
    const vulkan::Device device;
    fmt::print("isotropic and surface noise on the lattice in space; largest differences in units of the "
               "tolerance\n");
    constexpr std::size_t few = 1 << 8;
    const auto check = [&](const char* name, Entry3d by_place, Entry3d by_position, bool animated,
                           Period period, const auto& field_of) {
        test::Draw draw(22);
        LatticeSampler3d place(device, few, by_place, false, animated);
        LatticeSampler3d position(device, few, by_position);
        Largest largest;
        for (int batch = 0; batch < 16; ++batch) {
            const float frequency = batch == 0 ? 0 : 0.1f * static_cast<float>(std::exp2(batch * 0.62));
            const Samples samples(draw, few, frequency, period);
            compare(place, samples, largest, [&](const LatticeSample3d& sample, const Lattice3d::Place&) {
                return numbers_of(field_of(sample, sample.place), sample);
            });
            if (!animated && period == Period::none)
                compare(position, samples, largest,
                        [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
                            return Numbers{{field_of(sample, here).value.imag(), tolerance(frequency)}};
                        });
        }
        largest.check(name);
    };
    const auto isotropic = [](bool animated) {
        return [animated](const LatticeSample3d& sample, const Lattice3d::Place& place) {
            return noise::Isotropic3d(sample.frequency, sample.seed, animated).field(place);
        };
    };
    const auto surface_isotropic = [](const LatticeSample3d& sample, const Lattice3d::Place& place) {
        Lattice3d::Field all{};
        for (const auto& [weight, noise] :
             noise::surface_isotropic(test::unit(sample.normal), sample.frequency, sample.seed))
            add(all, weight, noise.field(place));
        return all;
    };
    check("isotropic", Entry3d::isotropic, Entry3d::noise_isotropic, false, Period::none, isotropic(false));
    check("  with periods", Entry3d::isotropic, Entry3d::noise_isotropic, false, Period::any,
          isotropic(false));
    check("  animated", Entry3d::isotropic, Entry3d::noise_isotropic, true, Period::none, isotropic(true));
    check("surface", Entry3d::surface, Entry3d::noise_surface, false, Period::none,
          [](const LatticeSample3d& sample, const Lattice3d::Place& place) {
              Lattice3d::Field all{};
              for (const noise::WeightedWave& w :
                   noise::surface_waves(test::unit(sample.normal), sample.frequency,
                                        test::unit(sample.direction), sample.seed))
                  add(all, w.weight, Lattice3d(w.wave, w.seed).field(place));
              return all;
          });
    check("surface, isotropic", Entry3d::surface_isotropic, Entry3d::noise_surface_isotropic, false,
          Period::none, surface_isotropic);
    check("  with periods", Entry3d::surface_isotropic, Entry3d::noise_surface_isotropic, false, Period::any,
          surface_isotropic);

    test::Draw draw(23);
    LatticeSampler3d gradient(device, few, Entry3d::noise_isotropic_gradient);
    Largest largest;
    compare(gradient, Samples(draw, few, 2, Period::none), largest,
            [&](const LatticeSample3d& sample, const Lattice3d::Place& here) {
                const Lattice3d::Field field = noise::Isotropic3d(sample.frequency, sample.seed).field(here);
                Numbers numbers{{field.value.imag(), tolerance(2)}};
                for (const auto& slope : field.slope)
                    numbers.push_back({slope.imag(), slope_tolerance(2)});
                return numbers;
            });
    largest.check("gabor_noise_3d_isotropic_gradient");
}

TEST_CASE("the gradient on the lattice equals differences of the reference", "[oracle]") {
    test::Draw draw(24);
    for (int i = 0; i < 500; ++i) {
        const Lattice3d reference({draw.uniform(-3, 3), draw.uniform(-3, 3), draw.uniform(-3, 3)},
                                  draw.word());
        Lattice3d::Place place;
        for (float& coordinate : place.local) // exact in a float, like their neighbours
            coordinate = std::floor(draw.uniform(-8, 8) * 256) / 256;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr float h = 0x1p-12f;
            Lattice3d::Place before = place;
            Lattice3d::Place after = place;
            before.local[axis] -= h;
            after.local[axis] += h;
            const double difference =
                (reference.field(after).value.imag() - reference.field(before).value.imag()) / (2 * h) * 1.5;
            REQUIRE(reference.field(place).slope[axis].imag() == Approx(difference).margin(5e-3));
        }
    }
}

TEST_CASE("waves of surface noise are tangent, have the requested frequency, and sum to variance 1",
          "[oracle]") {
    test::Draw draw(33);
    double longest = 0;
    double shortest = 1e9;
    for (int i = 0; i < 20000; ++i) {
        const Vector normal = random_unit(draw);
        Vector direction = random_unit(draw);
        if (i % 4 == 0) { // near and along the normal
            for (std::size_t axis = 0; axis < 3; ++axis)
                direction[axis] = normal[axis] + (i % 8 ? 0.3 : 0.01) * direction[axis];
            const double length = std::sqrt(dot(direction, direction));
            for (double& coordinate : direction)
                coordinate /= length;
        }
        const double frequency = draw.uniform(0.1f, 6);
        double power = 0;
        for (const noise::WeightedWave& w : noise::surface_waves(normal, frequency, direction, 1)) {
            power += w.weight * w.weight;
            const double length = std::sqrt(dot(w.wave, w.wave)) / frequency;
            longest = std::max(longest, length);
            shortest = std::min(shortest, length);
            REQUIRE(std::abs(dot(w.wave, normal)) < 1e-9 * frequency);
        }
        REQUIRE(power == Approx(1).margin(1e-9));
    }
    fmt::print("frequency on the surface: {:.9f} to {:.9f} of that asked for\n", shortest, longest);
    CHECK(shortest > 1 - 1e-9);
    CHECK(longest < 1 + 1e-9);
}

// Each vector of a random frame is uniform on the sphere: (u.v)^2k has the mean 1 / (2k + 1) for every v, and
// the harmonics up to degree 8 vanish.
TEST_CASE("the frames of isotropic noise are uniform over all directions", "[oracle]") {
    test::Draw draw(34);
    std::vector<Vector> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 24; ++i)
        directions.push_back(random_unit(draw));
    constexpr int count = 1 << 17;
    std::vector<std::array<statistics::Moments, 4>> powers(directions.size());
    test::Largest angles;
    for (int i = 0; i < count; ++i) {
        const auto frame = noise::isotropic_frame(draw.word() | 1u);
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                angles.see(dot(frame.at(a), frame.at(b)), a == b ? 1 : 0, 1e-12,
                           [&] { return fmt::format("{}, {}", a, b); });
        for (std::size_t k = 0; k < directions.size(); ++k) {
            std::array<double, 4> sums{};
            for (const Vector& u : frame)
                for (std::size_t n = 0; n < 4; ++n)
                    sums.at(n) += std::pow(dot(u, directions[k]), 2.0 * static_cast<double>(n + 1)) / 3;
            for (std::size_t n = 0; n < 4; ++n)
                powers[k].at(n).add(sums.at(n));
        }
    }
    angles.check("frames");
    test::Largest even; // in standard errors
    for (std::size_t k = 0; k < directions.size(); ++k) {
        for (std::size_t n = 1; n < 4; ++n) { // the squares of a frame sum to 1
            const statistics::Moments& power = powers[k].at(n);
            even.see(power.mean(), 1 / (2.0 * static_cast<double>(n + 1) + 1),
                     4.5 * std::sqrt(power.variance() / count), [&] {
                         return fmt::format("power {} along {:.2f}", 2 * (n + 1),
                                            fmt::join(directions[k], " "));
                     });
        }
    }
    even.check("powers of cosines, in 4.5 standard errors");
}

TEST_CASE("unusual arguments in space give the documented values, never NaN", "[oracle]") {
    const vulkan::Device device;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float odd[] = {0, -0.0f, 1e-38f, 1e-30f, -3, 1e30f, 3e38f, infinity, -infinity};
    std::vector<LatticeSample3d> samples;
    for (const float x : odd) {
        for (int where = 0; where < 5; ++where) {
            LatticeSample3d sample;
            sample.place.local = sample.p = {0.3f, 0.8f, 0.1f};
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
            samples.push_back(sample);
        }
    }
    LatticeSample3d nowhere;
    nowhere.dx = {0, std::numeric_limits<float>::quiet_NaN(), 0};
    samples.push_back(nowhere);
    for (const Entry3d entry : {Entry3d::field, Entry3d::isotropic, Entry3d::surface,
                                Entry3d::surface_isotropic, Entry3d::filtered}) {
        LatticeSampler3d sampler(device, samples.size(), entry);
        std::ranges::copy(samples, sampler.samples().begin());
        const auto answers = sampler.answers(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            INFO("entry " << static_cast<int>(entry) << ", " << to_string(samples[i]));
            for (int c = 0; c < (entry == Entry3d::filtered ? 2 : 9); ++c)
                CHECK(std::isfinite(answers[i].value[c]));
            CHECK(std::abs(answers[i].value[0]) < 10);
        }
    }
    // Only the magnitude of a frequency counts, and a direction's length does not.
    LatticeSampler3d sampler(device, 3, Entry3d::noise);
    for (int i = 0; i < 3; ++i) {
        LatticeSample3d& sample = sampler.samples()[static_cast<std::size_t>(i)] = samples.front();
        sample.frequency = i == 1 ? -3.0f : 3.0f;
        sample.direction = {i == 2 ? 1e20f : 1, 0, 0};
    }
    const auto same = sampler.answers(3);
    CHECK(same[1].value[0] == same[0].value[0]);
    CHECK(same[2].value[0] == same[0].value[0]);
}
