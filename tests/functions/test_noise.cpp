// Compares every function of gabor_noise.glsl with the double-precision reference.

#include "compare.hpp"
#include "noise.hpp"

using namespace gabor;
using test::Differences;
using test::Largest;
using test::place_of;
using test::Random;

namespace {

struct Sample {
    noise::Place<2> place;
    gabor_vec2 p, tile, wave;
    float frequency, orientation, sharpness;
    std::uint32_t seed;

    float time() const { return static_cast<float>(place.time); }
};

std::string to_string(const Sample& s) {
    return fmt::format("{}, p ({}, {}), tile ({}, {}), wave ({}, {}), frequency {}, orientation {}, "
                       "sharpness {}, seed {}",
                       test::to_string(s.place), s.p.x, s.p.y, s.tile.x, s.tile.y, s.wave.x, s.wave.y,
                       s.frequency, s.orientation, s.sharpness, s.seed);
}

// Draws all arguments. The coordinates of p go up to 10^5 kernel radii.
Sample drawn(Random& random, int taps) {
    Sample s{};
    s.place = test::any_lattice_place(random, taps);
    for (int axis = 0; axis < 2; ++axis) {
        const float reach = std::exp2(random.uniform(0, 17));
        s.p[axis] = random.uniform(-reach, reach);
        s.tile[axis] = random.one_in(4) ? std::round(random.uniform(1, 20)) : random.uniform(0.1, 20);
    }
    s.frequency = random.one_in(16) ? 0 : std::exp2(random.uniform(-5, 6));
    s.orientation = random.uniform(-8, 8);
    for (int axis = 0; axis < 2; ++axis)
        s.wave[axis] = random.one_in(16) ? 0 : random.uniform(-1, 1) * std::max(s.frequency, 1.0f);
    s.sharpness = random.one_in(16) ? 0 : random.uniform(0, 4);
    s.seed = random.one_in(16) ? 0 : random.word();
    return s;
}

template <typename Functions>
void compare(Functions n) {
    constexpr int taps = Functions::taps;
    Random random(taps);
    Differences of;
    int near_tiles = 0;
    for (int i = 0; i < 60000; ++i) {
        const Sample s = drawn(random, taps);
        // Rounding errors grow in proportion to frequency and orientation.
        const double tight =
            1.5e-5 * std::max(1.0, s.frequency / 4.0) * std::max(1.0, std::abs(s.orientation) / 2.0);
        const double loose = tight * (2 * std::numbers::pi * s.frequency + 4);
        const auto kernel = n.gabor_kernel(s.frequency, s.orientation);
        const noise::Vector<2> turned = noise::wave_along(s.frequency, s.orientation);
        const auto reference = noise::wave_noise(taps, turned, s.seed);
        const auto field = n.gabor_field(place_of(n, s.place), kernel, s.seed);
        see(of["gabor_field"], of["gabor_field, gradient"], field, reference.field(s.place), tight, loose, s);
        of["gabor_unorm"].see(n.gabor_unorm(field.value.y), std::clamp(0.5 + 0.25 * field.value.y, 0.0, 1.0),
                              1e-6, s);
        noise::Place<2> still{s.place.cell, s.place.local};
        still.radius.fill(0.5 * taps);
        of["gabor_noise_at"].see(
            n.gabor_noise_at(place_of(n, still).cell, place_of(n, still).local, kernel, s.seed),
            reference.field(still).value.imag(), tight, s);

        // Functions of a position multiply the position by the nodes per radius in single precision.
        noise::Place<2> place = test::lattice_place(taps, s.p);
        const auto here = reference.field(place);
        of["gabor_noise"].see(n.gabor_noise(s.p, s.frequency, s.orientation, s.seed), here.value.imag(),
                              tight, s);
        see(of["gabor_noise_complex"], n.gabor_noise_complex(s.p, s.frequency, s.orientation, s.seed),
            here.value, tight, s);
        see_gradient(of["gabor_noise_gradient"], of["gabor_noise_gradient"],
                     n.gabor_noise_gradient(s.p, s.frequency, s.orientation, s.seed), here, tight, loose, s);
        const auto four = n.gabor_noise_four(s.p, s.frequency, s.orientation, s.seed);
        of["gabor_noise_four"].see(four.x, here.value.imag(), tight, s);
        for (int c = 1; c < 4; ++c) {
            const auto other = noise::wave_noise(taps, turned, noise::lattice_lobe_seed(s.seed, -c));
            of["gabor_noise_four"].see(four[c], other.field(place).value.imag(), tight, s);
        }

        const auto along_wave = noise::wave_noise(taps, test::wide(s.wave), s.seed);
        const auto there = along_wave.field(place);
        const double steep = tight * std::max(1.0f, s.sharpness);
        const auto stripes = [&](const noise::Field<2>& of_field) {
            return noise::lattice_stripes(of_field.value, s.sharpness);
        };
        of["gabor_noise_wave"].see(n.gabor_noise_wave(s.p, s.wave, s.seed), there.value.imag(), tight, s);
        see(of["gabor_noise_wave_complex"], n.gabor_noise_wave_complex(s.p, s.wave, s.seed), there.value,
            tight, s);
        see_gradient(of["gabor_noise_wave_gradient"], of["gabor_noise_wave_gradient"],
                     n.gabor_noise_wave_gradient(s.p, s.wave, s.seed), there, tight, loose, s);
        see(of["gabor_stripes"], n.gabor_stripes(s.p, s.wave, s.sharpness, s.seed), stripes(there), steep, s);
        see(of["gabor_stripes_at"], n.gabor_stripes_at(place_of(n, s.place), s.wave, s.sharpness, s.seed),
            stripes(along_wave.field(s.place)), steep, s);

        place.animated = true;
        place.time = s.place.time;
        of["gabor_noise_animated"].see(
            n.gabor_noise_animated(s.p, s.time(), s.frequency, s.orientation, s.seed),
            reference.field(place).value.imag(), tight, s);
        // Tiled functions round both p, in node spacings, and the number of nodes per radius. Tiles are
        // compared only where this adds little error.
        const noise::Place<2> tile = test::lattice_tile(taps, s.p, s.tile);
        const double rounding = 2 * std::numbers::pi * (s.frequency + std::ranges::max(tile.radius)) *
                                std::max(std::abs(s.p.x), std::abs(s.p.y)) * std::exp2(-21);
        if (rounding > 1e-3)
            continue;
        ++near_tiles;
        of["gabor_noise_tiled"].see(n.gabor_noise_tiled(s.p, s.tile, s.frequency, s.orientation, s.seed),
                                    reference.field(tile).value.imag(), tight + rounding, s);
        const auto repeated = along_wave.field(tile);
        of["gabor_noise_wave_tiled"].see(n.gabor_noise_wave_tiled(s.p, s.tile, s.wave, s.seed),
                                         repeated.value.imag(), tight + rounding, s);
        see(of["gabor_stripes_tiled"], n.gabor_stripes_tiled(s.p, s.tile, s.wave, s.sharpness, s.seed),
            stripes(repeated), steep * (1 + rounding / tight), s);
    }
    fmt::print("{} taps; largest differences in units of the tolerance\n", taps);
    test::check(of, 17);
    CHECK(near_tiles > 10000);
}

template <typename Functions>
void check_repeats(Functions n) {
    Random random(6);
    Largest tiles, times;
    for (int i = 0; i < 10000; ++i) {
        Sample s = drawn(random, Functions::taps);
        for (int axis = 0; axis < 2; ++axis) { // few bits, so that sums are exact
            s.tile[axis] = std::round(s.tile[axis] * 16) / 16 + 0.25f;
            s.p[axis] = std::round(random.uniform(-40, 40) * 1024) / 1024;
        }
        const gabor_vec2 elsewhere(s.p.x + s.tile.x, s.p.y - 3 * s.tile.y);
        tiles.see(n.gabor_noise_tiled(elsewhere, s.tile, s.frequency, s.orientation, s.seed),
                  n.gabor_noise_tiled(s.p, s.tile, s.frequency, s.orientation, s.seed),
                  1e-4 * std::max(1.0f, s.frequency), s);
        const float time = std::round(s.time() * 1024) / 1024;
        times.see(n.gabor_noise_animated(s.p, time + 1, s.frequency, s.orientation, s.seed),
                  n.gabor_noise_animated(s.p, time, s.frequency, s.orientation, s.seed), 1e-9, s);
    }
    tiles.check(fmt::format("tiles, {} taps", Functions::taps));
    times.check("time");
}

} // namespace

TEST_CASE("every function of the lattice noise agrees with the reference", "[lattice][oracle]") {
    compare(test::Lattice2());
    compare(test::Lattice3());
    compare(test::Lattice4());
}

TEST_CASE("the lattice noise repeats in tiles and in time", "[lattice][oracle]") {
    check_repeats(test::Lattice2());
    check_repeats(test::Lattice3());
    check_repeats(test::Lattice4());
}
