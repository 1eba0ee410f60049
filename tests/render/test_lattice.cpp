// Compares every function of the lattice noise on the device with the double-precision reference.

#include "lattice_sampler.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;
using test::LatticeSample;

namespace {

constexpr std::size_t per_batch = 1 << 14;

// Draws places near the origin, in all quadrants up to 10^5 nodes, or in any cell up to 2^31. One coordinate
// in four is on or next to a cell border, where a window ends.
LatticeSample draw_sample(Draw& draw, int taps) {
    const float radius = 0.5f * static_cast<float>(taps);
    LatticeSample s{};
    for (int axis = 0; axis < 2; ++axis) {
        const float reach = std::exp2(draw.uniform(0, 17));
        s.p[axis] = draw.uniform(-reach, reach);
        float& local = s.local[axis];
        s.cell[axis] = draw.word() % 2 ? draw.cell() : static_cast<std::int32_t>(draw.uniform(-5, 5));
        local = draw.uniform(-2, 3);
        if (draw.word() % 4 == 0)
            local = 0.5f * std::round(2 * local);
        if (draw.word() % 4 == 0)
            local = std::nextafter(0.5f * std::round(2 * local), draw.word() % 2 ? 1e9f : -1e9f);
        s.radius[axis] = radius * draw.uniform(0.8, 1.3);
        s.period[axis] = draw.word() % 2 ? taps + static_cast<std::int32_t>(draw.word() % 50) : 0;
        s.tile[axis] = draw.word() % 4 ? draw.uniform(0.1, 20) : std::round(draw.uniform(1, 20));
    }
    s.animated = draw.word() % 2;
    s.time = draw.uniform(-2, 2);
    s.frequency = draw.word() % 16 == 0 ? 0 : std::exp2(draw.uniform(-5, 6));
    s.orientation = draw.uniform(-8, 8);
    s.seed = draw.word() % 16 == 0 ? 0 : draw.word();
    for (float& wave : s.wave)
        wave = draw.word() % 16 == 0 ? 0 : draw.uniform(-1, 1) * std::max(s.frequency, 1.0f);
    s.sharpness = draw.word() % 16 == 0 ? 0 : draw.uniform(0, 4);
    return s;
}

// 1.5e-5 at frequency 4 and orientation 2 radians; rounding grows in proportion to both.
double tolerance(const LatticeSample& s) {
    return 1.5e-5 * std::max(1.0, s.frequency / 4.0) * std::max(1.0, std::abs(s.orientation) / 2.0);
}

double slope_tolerance(const LatticeSample& s) {
    return tolerance(s) * (2 * std::numbers::pi * s.frequency + 4);
}

// Returns the place that the drop-in computes from a position: the product is rounded once.
noise::LatticePlace place_at(const LatticeSample& s, int taps) {
    const float radius = 0.5f * static_cast<float>(taps);
    noise::LatticePlace place;
    place.local_x = s.p[0] * radius;
    place.local_y = s.p[1] * radius;
    place.radius_x = place.radius_y = radius;
    return place;
}

noise::LatticePlace tile_at(const LatticeSample& s, int taps) {
    noise::LatticePlace place;
    const auto along = [&](double p, double period, double& local, double& radius, std::int32_t& nodes) {
        nodes = std::max(static_cast<std::int32_t>(std::floor(period * 0.5 * taps + 0.5)), taps);
        radius = nodes / period;
        local = (p / period - std::floor(p / period)) * nodes;
    };
    along(s.p[0], s.tile[0], place.local_x, place.radius_x, place.period_x);
    along(s.p[1], s.tile[1], place.local_y, place.radius_y, place.period_y);
    return place;
}

// Evaluates random samples with each number of taps; `see` compares one sample's answers, given the
// tolerances of values and of slopes.
template <typename See>
void compare(unsigned seed, std::size_t functions, const See& see) {
    const vulkan::Device device;
    for (const int taps : {2, 3, 4}) {
        Draw draw(seed + static_cast<unsigned>(taps));
        test::LatticeSampler sampler(device, taps, per_batch);
        Differences differences;
        for (int batch = 0; batch < 6; ++batch) {
            for (LatticeSample& sample : sampler.samples())
                sample = draw_sample(draw, taps);
            const auto answers = sampler.answers(per_batch);
            for (std::size_t i = 0; i < per_batch; ++i) {
                const LatticeSample& s = sampler.samples()[i];
                see(differences, s, answers[i], taps, tolerance(s), slope_tolerance(s));
            }
        }
        fmt::print("{} taps on {}; largest differences in units of the tolerance\n", taps,
                   device.info().name);
        test::check(differences, functions);
    }
}

// Tolerance that rounding adds to a tile: both p in node spacings and the number of nodes per radius are
// rounded. Tiles are compared only where that is small.
double tile_rounding(const LatticeSample& s, const noise::LatticePlace& tile) {
    const double cycles = s.frequency + std::max(tile.radius_x, tile.radius_y);
    const double position = std::max(std::abs(s.p[0]), std::abs(s.p[1])) * std::exp2(-21);
    return 2 * std::numbers::pi * cycles * position;
}

} // namespace

TEST_CASE("the lattice noise agrees with the reference at any place", "[lattice]") {
    compare(0, 5,
            [](Differences& of, const LatticeSample& s, const test::LatticeAnswer& answer, int taps,
               double tight, double loose) {
                const noise::Lattice reference(taps, s.frequency, s.orientation, s.seed);
                const auto field = reference.field(s.place());
                of["gabor_field"].see(answer.value[1], field.value.imag(), tight, s);
                of["gabor_field, real part"].see(answer.value[0], field.value.real(), tight, s);
                of["gabor_field, gradient"].see(answer.slope_x[1], field.slope_x.imag(), loose, s);
                of["gabor_field, gradient"].see(answer.slope_y[1], field.slope_y.imag(), loose, s);
                of["gabor_unorm"].see(answer.unorm, std::clamp(0.5 + 0.25 * field.value.imag(), 0.0, 1.0),
                                      tight, s);
                noise::LatticePlace place{s.cell[0], s.cell[1], s.local[0], s.local[1]};
                place.radius_x = place.radius_y = 0.5 * taps;
                of["gabor_noise_at"].see(answer.at, reference.field(place).value.imag(), tight, s);
            });
}

TEST_CASE("functions of a position agree with the reference", "[lattice]") {
    std::size_t near_tiles = 0;
    compare(10, 6,
            [&](Differences& of, const LatticeSample& s, const test::LatticeAnswer& answer, int taps,
                double tight, double loose) {
                const noise::Lattice reference(taps, s.frequency, s.orientation, s.seed);
                noise::LatticePlace place = place_at(s, taps);
                const auto here = reference.field(place);
                of["gabor_noise"].see(answer.noise, here.value.imag(), tight, s);
                of["gabor_noise_complex"].see(answer.complex[0], here.value.real(), tight, s);
                of["gabor_noise_complex"].see(answer.complex[1], here.value.imag(), tight, s);
                of["gabor_noise_gradient"].see(answer.gradient_noise, here.value.imag(), tight, s);
                of["gabor_noise_gradient"].see(answer.gradient[0], here.slope_x.imag(), loose, s);
                of["gabor_noise_gradient"].see(answer.gradient[1], here.slope_y.imag(), loose, s);
                for (std::size_t c = 0; c < 4; ++c)
                    of["gabor_noise_four"].see(answer.four[c], here.four[c], tight, s);
                place.animated = true;
                place.time = s.time;
                of["gabor_noise_animated"].see(answer.animated, reference.field(place).value.imag(), tight,
                                               s);
                const noise::LatticePlace tile = tile_at(s, taps);
                const double rounding = tile_rounding(s, tile);
                if (rounding < 1e-3) {
                    ++near_tiles;
                    of["gabor_noise_tiled"].see(answer.tiled, reference.field(tile).value.imag(),
                                                tight + rounding, s);
                }
            });
    CHECK(near_tiles > 3 * per_batch);
}

TEST_CASE("functions of a wave vector, and stripes, agree with the reference", "[lattice]") {
    compare(20, 7,
            [](Differences& of, const LatticeSample& s, const test::LatticeAnswer& answer, int taps,
               double tight, double loose) {
                const noise::Lattice reference(taps, {s.wave[0], s.wave[1]}, s.seed);
                const auto here = reference.field(place_at(s, taps));
                of["gabor_noise_wave"].see(answer.wave[3], here.value.imag(), tight, s);
                of["gabor_noise_wave_complex"].see(answer.wave_complex[0], here.value.real(), tight, s);
                of["gabor_noise_wave_complex"].see(answer.wave_complex[1], here.value.imag(), tight, s);
                of["gabor_noise_wave_gradient"].see(answer.wave[0], here.value.imag(), tight, s);
                of["gabor_noise_wave_gradient"].see(answer.wave[1], here.slope_x.imag(), loose, s);
                of["gabor_noise_wave_gradient"].see(answer.wave[2], here.slope_y.imag(), loose, s);
                const double steep = std::max(1.0, static_cast<double>(s.sharpness));
                const auto expected = noise::lattice_stripes(here.value, s.sharpness);
                for (std::size_t c = 0; c < 3; ++c)
                    of["gabor_stripes"].see(answer.stripes[c], expected[c], steep * tight, s);
                const auto packed = [&](const noise::Field& field) {
                    const auto v = noise::lattice_stripes(field.value, s.sharpness);
                    return v[0] + 2 * v[1] + 4 * v[2];
                };
                of["gabor_stripes_at"].see(answer.stripes[3], packed(reference.field(s.place())),
                                           7 * steep * tight, s);
                const noise::LatticePlace tile = tile_at(s, taps);
                const double rounding = tile_rounding(s, tile);
                if (rounding < 1e-3) {
                    const auto repeated = reference.field(tile);
                    of["gabor_noise_wave_tiled"].see(answer.wave_tiled, repeated.value.imag(),
                                                     tight + rounding, s);
                    of["gabor_stripes_tiled"].see(answer.stripes_tiled, packed(repeated),
                                                  7 * steep * (tight + rounding), s);
                }
            });
}

TEST_CASE("node words agree bit for bit, and match known values", "[lattice]") {
    const vulkan::Device device;
    test::LatticeSampler sampler(device, 3, per_batch);
    Draw draw(5);
    for (LatticeSample& sample : sampler.samples())
        sample = draw_sample(draw, 3);
    const auto answers = sampler.answers(per_batch);
    for (std::size_t i = 0; i < per_batch; ++i) {
        const LatticeSample& s = sampler.samples()[i];
        REQUIRE(answers[i].word == noise::lattice_word(s.cell[0], s.cell[1], s.seed));
    }
    CHECK(noise::lattice_word(0, 0, 0) == 0x650b7b8fu);
    CHECK(noise::lattice_word(3, -5, 7) == 0xf610971fu);
    CHECK(noise::lattice_word(1000000000, -1000000000, 0xffffffffu) == 0x5f532683u);
}

TEST_CASE("the lattice noise repeats exactly in tiles and in time", "[lattice]") {
    const vulkan::Device device;
    Draw draw(6);
    for (const int taps : {2, 3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::vector<LatticeSample> samples(per_batch / 2);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            LatticeSample s = draw_sample(draw, taps);
            for (int axis = 0; axis < 2; ++axis) { // few bits, so that sums are exact
                s.tile[axis] = std::round(s.tile[axis] * 16) / 16 + 0.25f;
                s.p[axis] = std::round(draw.uniform(-40, 40) * 1024) / 1024;
            }
            s.time = std::round(s.time * 1024) / 1024;
            samples[i] = s;
            sampler.samples()[i] = s;
            s.p[0] += s.tile[0];
            s.p[1] -= 3 * s.tile[1];
            s.time += 1;
            sampler.samples()[i + samples.size()] = s;
        }
        const auto answers = sampler.answers(per_batch);
        Largest tiles;
        for (std::size_t i = 0; i < samples.size(); ++i)
            tiles.see(answers[i].tiled, answers[i + samples.size()].tiled,
                      1e-4 * std::max(1.0f, samples[i].frequency), samples[i]);
        tiles.check(fmt::format("tiles, {} taps", taps));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            LatticeSample s = samples[i];
            sampler.samples()[i] = s;
            s.time += 1;
            sampler.samples()[i + samples.size()] = s;
        }
        const auto later = sampler.answers(per_batch);
        for (std::size_t i = 0; i < samples.size(); ++i)
            REQUIRE(later[i].animated == later[i + samples.size()].animated);
    }
}
