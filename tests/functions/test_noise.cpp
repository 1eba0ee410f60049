// Compares the functions of gabor_noise.glsl, for each number of taps, and the noises of the drop-ins after
// it with the double-precision reference.

#include "noise.hpp"

using namespace gabor;
using test::Differences;
using test::Largest;
using test::n;
using test::place_of;
using test::Random;

namespace {

struct Arguments {
    noise::Place<2> place;
    gabor_vec2 p, tile, wave;
    float frequency, orientation, sharpness;
    std::uint32_t seed;

    float time() const { return static_cast<float>(place.time); }
};

std::string to_string(const Arguments& s) {
    return fmt::format("{}, p ({}, {}), tile ({}, {}), wave ({}, {}), frequency {}, orientation {}, "
                       "sharpness {}, seed {}",
                       test::to_string(s.place), s.p.x, s.p.y, s.tile.x, s.tile.y, s.wave.x, s.wave.y,
                       s.frequency, s.orientation, s.sharpness, s.seed);
}

// Draws all arguments. The coordinates of p go up to 10^5 kernel radii.
Arguments drawn(Random& random, int taps) {
    Arguments s{};
    s.place = test::any_lattice_place<2>(random, taps);
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
void compare(Functions functions) {
    constexpr int taps = Functions::taps;
    Random random(taps);
    Differences of;
    int near_tiles = 0;
    for (int i = 0; i < 60000; ++i) {
        const Arguments s = drawn(random, taps);
        // Rounding errors grow in proportion to frequency and orientation.
        const double tight =
            1.5e-5 * std::max(1.0, s.frequency / 4.0) * std::max(1.0, std::abs(s.orientation) / 2.0);
        const double loose = tight * (2 * std::numbers::pi * s.frequency + 4);
        const gabor_vec2 wave = functions.gabor_wave_vector(s.frequency, s.orientation);
        const noise::Vector<2> turned = noise::wave_along(s.frequency, s.orientation);
        see(of["gabor_wave_vector"], wave, turned, tight * (1 + s.frequency), s);
        const auto reference = noise::wave_noise(taps, turned, s.seed);
        const auto field = functions.gabor_field(place_of(functions, s.place), wave, s.seed);
        see(of["gabor_field"], of["gabor_field, gradient"], field, reference.field(s.place), tight, loose, s);
        if (i % 8 == 0)
            see(of["gabor_field_isotropic"], of["gabor_field_isotropic, gradient"],
                functions.gabor_field_isotropic(place_of(functions, s.place), s.frequency, s.seed),
                noise::isotropic_noise(s.frequency, s.seed, taps).field(s.place), tight, loose, s);
        of["gabor_unorm"].see(functions.gabor_unorm(field.noise),
                              std::clamp(0.5 + 0.25 * field.noise, 0.0, 1.0), 1e-6, s);

        // Functions of a position multiply the position by the nodes per radius in single precision.
        noise::Place<2> place = test::lattice_place(taps, s.p);
        const auto here = reference.field(place);
        of["gabor_noise"].see(functions.gabor_noise(s.p, s.frequency, s.orientation, s.seed),
                              here.value.imag(), tight, s);
        see(of["gabor_noise_quadrature"],
            functions.gabor_noise_quadrature(s.p, s.frequency, s.orientation, s.seed),
            test::noise_and_quadrature(here.value), tight, s);
        see_gradient(of["gabor_noise_gradient"], of["gabor_noise_gradient"],
                     functions.gabor_noise_gradient(s.p, s.frequency, s.orientation, s.seed), here, tight,
                     loose, s);
        const auto there = noise::wave_noise(taps, test::wide(s.wave), s.seed).field(place);
        see(of["gabor_stripes"], functions.gabor_stripes(s.p, s.wave, s.sharpness, s.seed),
            noise::lattice_stripes(there.value, s.sharpness), tight * std::max(1.0f, s.sharpness), s);

        place.time = s.place.time;
        of["gabor_noise_animated"].see(
            functions.gabor_noise_animated(s.p, s.time(), s.frequency, s.orientation, s.seed),
            reference.field(place).value.imag(), tight, s);
        // Tiled functions round both p, in node spacings, and the number of nodes per radius. Tiles are
        // compared only where this adds little error.
        const noise::Place<2> tile = test::lattice_tile(taps, s.p, s.tile);
        const double rounding = 2 * std::numbers::pi * (s.frequency + std::ranges::max(tile.radius)) *
                                std::max(std::abs(s.p.x), std::abs(s.p.y)) * std::exp2(-21);
        if (rounding > 1e-3)
            continue;
        ++near_tiles;
        of["gabor_noise_tiled"].see(
            functions.gabor_noise_tiled(s.p, s.tile, s.frequency, s.orientation, s.seed),
            reference.field(tile).value.imag(), tight + rounding, s);
    }
    fmt::print("{} taps; largest differences in units of the tolerance\n", taps);
    test::check(of, 12);
    CHECK(near_tiles > 10000);
}

template <typename Functions>
void check_repeats(Functions functions) {
    Random random(6);
    Largest tiles, times;
    for (int i = 0; i < 10000; ++i) {
        Arguments s = drawn(random, Functions::taps);
        for (int axis = 0; axis < 2; ++axis) { // few bits, so that sums are exact
            s.tile[axis] = std::round(s.tile[axis] * 16) / 16 + 0.25f;
            s.p[axis] = std::round(random.uniform(-40, 40) * 1024) / 1024;
        }
        const gabor_vec2 elsewhere(s.p.x + s.tile.x, s.p.y - 3 * s.tile.y);
        tiles.see(functions.gabor_noise_tiled(elsewhere, s.tile, s.frequency, s.orientation, s.seed),
                  functions.gabor_noise_tiled(s.p, s.tile, s.frequency, s.orientation, s.seed),
                  2e-4 * std::max(1.0f, s.frequency), s);
        const float time = std::round(s.time() * 1024) / 1024;
        times.see(functions.gabor_noise_animated(s.p, time + 1, s.frequency, s.orientation, s.seed),
                  functions.gabor_noise_animated(s.p, time, s.frequency, s.orientation, s.seed), 3e-6, s);
    }
    tiles.check(fmt::format("tiles, {} taps", Functions::taps));
    times.check("time");
}

// Compares a noise, and its filter with a pixel of size 0, in any cell, with any period, at any time. The
// frequencies cover 0.1 to 64 evenly in octaves.
template <std::size_t N>
void compare_fields(std::initializer_list<test::Noise<N>> noises) {
    Random random(21);
    Differences of;
    for (int i = 0; i < 1 << 13; ++i) {
        const int octave = i % 16;
        test::Sample<N> s = test::somewhere<N>(random, octave == 0 ? 0 : 0.1 * std::exp2(octave * 0.62));
        s.place = test::any_lattice_place<N>(random, 3);
        if constexpr (N == 3)
            if (random.one_in(4)) // near the normal, where the noise switches to another direction
                s.direction = test::wide(test::narrow(noise::sum(1, s.normal, 0.3, s.direction)));
        const double tight = 3 * test::tolerance(s.frequency), loose = 3 * test::slope_tolerance(s.frequency);
        for (const test::Noise<N>& noise : noises) {
            const noise::Field<N> expected = noise.reference(s).field(s.place);
            const auto field = noise.field(s), filtered = noise.filtered(s);
            see(of[noise.name], of[fmt::format("{}, gradient", noise.name)], field, expected, tight, loose,
                s);
            const std::string name = fmt::format("{}, filtered", noise.name);
            see(of[name], of[name + ", gradient"], filtered, expected, 2 * tight, loose + 5e-3, s);
            of["removed"].see(field.removed, 0, 1e-9, s);
            of["removed"].see(filtered.removed, 0, 1e-6, s);
        }
    }
    test::check(of, 4 * noises.size() + 1);
}

// Compares noises of a frequency and of its opposite, with and without a filter.
template <std::size_t N>
void see_signs(Differences& of, Random& random, std::initializer_list<test::Noise<N>> noises) {
    for (const test::Noise<N>& noise : noises) {
        test::Sample<N> s = test::somewhere<N>(random, random.uniform(0.5, 4));
        s.dx[0] = s.dy[1] = 0.1f;
        const auto field = noise.field(s), filtered = noise.filtered(s);
        s.frequency = -s.frequency;
        of[noise.name].see(noise.field(s).noise, field.noise, 1e-6, s);
        of[fmt::format("{}, filtered", noise.name)].see(noise.filtered(s).noise, filtered.noise, 1e-6, s);
    }
}

// Compares noises of frequencies around the highest, 10^6.
template <std::size_t N>
void check_highest(std::initializer_list<test::Noise<N>> noises) {
    Random random(25);
    for (const test::Noise<N>& noise : noises)
        for (const bool filtered : {false, true}) {
            INFO(noise.name << (filtered ? ", filtered" : ""));
            double apart = 0;
            for (int i = 0; i < 16; ++i) {
                test::Sample<N> s = test::somewhere<N>(random, 1);
                s.direction = {1}; // each axis has the same limit
                if constexpr (N == 3)
                    s.normal = {0, 0, 1};
                const auto at = [&](float frequency) {
                    s.frequency = frequency;
                    return filtered ? noise.filtered(s).noise : noise.field(s).noise;
                };
                const float highest = at(1.0e6f);
                CHECK(at(4.0e6f) == highest);
                apart += static_cast<double>(std::abs(at(0.97e6f) - highest)) / 16;
            }
            CHECK(apart > 0.1);
        }
}

// Compares a place with the reference's, which has the same period and lies whole periods away.
void see_place(Largest& largest, const auto& place, const auto& expected, const auto& where) {
    for (std::size_t axis = 0; axis < expected.local.size(); ++axis) {
        const int a = static_cast<int>(axis);
        const double period = expected.period[axis], apart = place.local[a] - expected.local[axis];
        largest.see(place.period[a], period, 0.1, where);
        largest.see(place.cells_per_radius[a], expected.radius[axis], 1e-6 * expected.radius[axis], where);
        largest.see(apart, period ? std::round(apart / period) * period : 0, 1e-5, where);
    }
    largest.see(place.evolution, 0, 1e-9, where);
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

TEST_CASE("fields agree with the reference, also with a filter for a pixel of size 0",
          "[lattice][isotropic][space][oracle]") {
    compare_fields<2>({test::plane, test::isotropic});
    compare_fields<3>({test::solid, test::surface, test::isotropic_3d, test::isotropic_surface});
}

TEST_CASE("a phase is below 1, however little below a whole turn", "[lattice]") {
    for (int bit = 1; bit < 120; ++bit) {
        const float below = -std::exp2(static_cast<float>(-bit)),
                    phase = n.gabor_turns_intensity({below, 1}).x;
        CHECK((phase >= 0.5f && phase < 1));
    }
}

TEST_CASE("the sign of a frequency is ignored", "[spectrum][isotropic][space]") {
    Random random(24);
    Differences of;
    for (int i = 0; i < 1 << 8; ++i) {
        see_signs<2>(of, random, {test::isotropic});
        see_signs<3>(of, random, {test::surface, test::isotropic_3d, test::isotropic_surface});
        const auto p = random.uniform<gabor_vec2>(-8, 8);
        const float frequency = random.uniform(0.5, 4), turn = random.uniform(-3, 3);
        const auto spread = [&](float f) { return n.gabor_noise_spread(p, f, turn, 0.4f, 0.7f, 7); };
        of["gabor_noise_spread"].see(spread(-frequency), spread(frequency), 1e-6, test::Sample<2>{});
        see(of["gabor_wave_vector"], n.gabor_wave_vector(-frequency, turn),
            test::wide(n.gabor_wave_vector(frequency, turn)), 1e-9, test::Sample<2>{});
    }
    test::check(of, 10);
}

TEST_CASE("frequencies count up to 10^6, and periods from 1/1024 to 10^9", "[spectrum][isotropic][space]") {
    check_highest<2>({test::plane, test::isotropic});
    check_highest<3>({test::solid, test::surface, test::isotropic_3d, test::isotropic_surface});
    for (const float f : {1.0e6f, 4.0e6f, -4.0e6f})
        CHECK(n.gabor_wave_vector(f, 0).x == Approx(1.0e6));
    CHECK(n.gabor_wave_vector(0.97e6f, 0).x == Approx(0.97e6));
    for (const auto& [period, radius, nodes] : {std::tuple(1.0e-9f, 3072.0f, 3),
                                                {1 / 1024.0f, 3072.0f, 3},
                                                {1 / 512.0f, 1536.0f, 3},
                                                {0.5e9f, 1.5f, 750000000},
                                                {1.0e9f, 1.5f, 1500000000},
                                                {4.0e9f, 1.5f, 1500000000}}) {
        const auto flat = n.gabor_place_tiled({0.1f, 0.2f}, {period, 0});
        const auto deep = n.gabor_place_3d_tiled({0.1f, 0.2f, 0.3f}, {0, 5, period});
        INFO(period);
        CHECK(std::pair(flat.cells_per_radius.x, flat.period.x) == std::pair(radius, nodes));
        CHECK(std::pair(deep.cells_per_radius.z, deep.period.z) == std::pair(radius, nodes));
    }
}

TEST_CASE("places have the position and the period that they are made from", "[lattice][space][oracle]") {
    Random random(22);
    Largest here, tiles;
    for (int i = 0; i < 1 << 12; ++i) {
        const auto p = random.uniform<gabor_vec3>(-8, 8);
        auto tile = random.uniform<gabor_vec3>(0.5, 9);
        tile[static_cast<int>(random.word() % 3)] = 0; // endless
        const gabor_vec2 q(p.x, p.y), side(tile.x, tile.y);
        const auto where = [&] { return fmt::format("{}, tile {}", test::wide(p), test::wide(tile)); };
        see_place(here, n.gabor_place_at(q), test::lattice_place(3, q), where);
        see_place(here, n.gabor_place_3d_at(p), test::lattice_place(3, p), where);
        see_place(tiles, n.gabor_place_tiled(q, side), test::lattice_tile(3, q, side), where);
        see_place(tiles, n.gabor_place_3d_tiled(p, tile), test::lattice_tile(3, p, tile), where);
    }
    here.check("places");
    tiles.check("places with a period");
}

TEST_CASE("functions of a position in 3D agree with the reference", "[space][oracle]") {
    Random random(23);
    Differences of;
    for (int i = 0; i < 1 << 12; ++i) {
        test::Sample<3> s = test::somewhere<3>(random, i % 16 ? std::exp2(random.uniform(-4, 6)) : 0);
        const double reach = std::exp2(random.uniform(0, 18)), tight = 2 * test::tolerance(s.frequency);
        const auto p = random.uniform<gabor_vec3>(-reach, reach);
        s.place = test::lattice_place(3, p);
        const auto direction = test::narrow(s.direction), normal = test::narrow(s.normal);
        const auto see = [&](const char* name, float found, const test::Noise<3>& noise) {
            of[name].see(found, noise.reference(s).field(s.place).value.imag(), tight, s);
        };
        for (const float f : {s.frequency, -s.frequency}) { // the sign is ignored
            see("gabor_noise_3d", n.gabor_noise_3d(p, f, 1e14f * direction, s.seed), test::solid);
            see("gabor_noise_3d_isotropic", n.gabor_noise_3d_isotropic(p, f, s.seed), test::isotropic_3d);
            see("gabor_noise_surface", n.gabor_noise_surface(p, 3.0f * normal, f, direction, s.seed),
                test::surface);
        }
    }
    test::check(of, 3);
}
