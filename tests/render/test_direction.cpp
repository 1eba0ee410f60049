// Compares gabor_direction.glsl on the device with the double-precision reference.

#include "oracle.hpp"
#include "reference/lattice.hpp"
#include "sampler.hpp"

#include "passes/sample_direction.h"

#include <array>
#include <cmath>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;

namespace {

/// As in passes/sample_direction.comp.
struct Sample {
    std::int32_t cell[2];
    float local[2];
    float radius[2];
    std::int32_t period[2];
    float p[2];
    float tile[2];
    float time;
    std::int32_t animated;
    std::uint32_t seed;
    float sharpness;
    float waves[9][2];
};

struct Field {
    float value[2];
    float slope_x[2];
    float slope_y[2];
};

struct Answer {
    Field given;
    Field field;
    float nodes[9][2];
    float complex[2];
    float gradient[3];
    float noise;
    float stripes[3];
    float tiled;
    float stripes_tiled[3];
    float padding;
    float stripes_at[4];
};

std::string to_string(const Sample& s) {
    return fmt::format("cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), p ({}, {}), tile ({}, "
                       "{}), time {}, seed {}, "
                       "sharpness {}",
                       s.cell[0], s.cell[1], s.local[0], s.local[1], s.radius[0], s.radius[1], s.period[0],
                       s.period[1], s.p[0], s.p[1], s.tile[0], s.tile[1], s.animated ? s.time : 0, s.seed,
                       s.sharpness);
}

std::array<double, 2> map_at(double x, double y) {
    return x + y > 1 ? std::array<double, 2>{1.5, 0.25 * y} : std::array<double, 2>{-0.5 * x, 2};
}

double wrapped(double index, double period) {
    return period > 0 ? index - std::floor(index / period) * period : index;
}

// The positions of the nine nodes around a place, row by row.
std::array<std::array<double, 2>, 9> nodes_around(const noise::LatticePlace& place) {
    std::array<std::array<double, 2>, 9> nodes{};
    for (int k = 0; k < 9; ++k) {
        const double i = place.cell_x + std::floor(place.local_x + 0.5) + k % 3 - 1;
        const double j = place.cell_y + std::floor(place.local_y + 0.5) + k / 3 - 1;
        nodes.at(static_cast<std::size_t>(k)) = {wrapped(i, place.period_x) / place.radius_x,
                                                 wrapped(j, place.period_y) / place.radius_y};
    }
    return nodes;
}

noise::Lattice::Field along_map(const noise::LatticePlace& place, std::uint32_t seed) {
    noise::Lattice::Waves waves;
    const auto nodes = nodes_around(place);
    for (std::size_t k = 0; k < 9; ++k)
        waves.at(k) = map_at(nodes.at(k)[0], nodes.at(k)[1]);
    return noise::Lattice::field(place, waves, seed);
}

// Whether rounding can choose other nodes around the place, or the other side of the map's jump at a node.
bool is_ambiguous(const noise::LatticePlace& place) {
    const auto near_edge = [](double local) {
        return std::abs(local + 0.5 - std::round(local + 0.5)) < 1e-4;
    };
    bool ambiguous = near_edge(place.local_x) || near_edge(place.local_y);
    for (const auto& [x, y] : nodes_around(place))
        ambiguous |= std::abs(x + y - 1) < 1e-4;
    return ambiguous;
}

Sample drawn(Draw& draw) {
    Sample s{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        s.cell[axis] = draw.cell();
        s.local[axis] = draw.word() % 4 ? draw.uniform(-2, 3) : std::round(draw.uniform(-2, 3));
        s.period[axis] = draw.word() % 2 ? 3 + static_cast<std::int32_t>(draw.word() % 9) : 0;
        s.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
        s.p[axis] = draw.word() % 4 ? draw.uniform(-8, 8) : 2 * std::round(draw.uniform(-4, 4));
        s.tile[axis] = draw.uniform(1.5, 9);
    }
    s.animated = draw.word() % 2;
    s.time = draw.uniform(-2, 2);
    s.seed = draw.word();
    s.sharpness = draw.uniform(0, 4);
    for (auto& wave : s.waves)
        for (float& part : wave)
            part = draw.word() % 8 ? draw.uniform(-4, 4) : 0;
    return s;
}

} // namespace

TEST_CASE("noise along a map agrees with the reference in any cell, with any period, at any time",
          "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 15;
    test::Probe<Sample, Answer> sampler(device, count, sample_direction_spirv, {});
    Draw draw(71);
    for (Sample& s : sampler.samples())
        s = drawn(draw);
    Differences of;
    // Waves of up to 6 cycles, at offsets rounded to 1e-7 of 8 kernel radii.
    constexpr double value_tolerance = 3e-5, slope_tolerance = 5e-4;
    const auto see_field = [](Largest& values, Largest& slopes, const Field& found,
                              const noise::Lattice::Field& expected, double tolerance, double steep,
                              const Sample& s) {
        values.see(found.value[0], expected.value.real(), tolerance, s);
        values.see(found.value[1], expected.value.imag(), tolerance, s);
        slopes.see(found.slope_x[0], expected.slope_x.real(), steep, s);
        slopes.see(found.slope_x[1], expected.slope_x.imag(), steep, s);
        slopes.see(found.slope_y[0], expected.slope_y.real(), steep, s);
        slopes.see(found.slope_y[1], expected.slope_y.imag(), steep, s);
    };
    const auto see_stripes = [](Largest& largest, const float* found, const noise::Lattice::Field& expected,
                                const Sample& s) {
        const auto of_value = noise::lattice_stripes(expected.value, s.sharpness);
        for (std::size_t c = 0; c < 3; ++c)
            largest.see(found[c], of_value[c], value_tolerance * std::max(1.0, double{s.sharpness}), s);
    };
    std::size_t left_out = 0;
    const auto answers = sampler.answers(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Sample& s = sampler.samples()[i];
        const Answer& a = answers[i];
        noise::LatticePlace place{s.cell[0],   s.cell[1],   s.local[0],  s.local[1],      s.radius[0],
                                  s.radius[1], s.period[0], s.period[1], s.animated != 0, s.time};
        noise::Lattice::Waves waves;
        const auto around = nodes_around(place);
        for (std::size_t k = 0; k < 9; ++k) {
            waves.at(k) = {s.waves[k][0], s.waves[k][1]};
            for (std::size_t axis = 0; axis < 2; ++axis)
                if (std::abs(around.at(k).at(axis)) < 2e9 && s.period[axis])
                    of["gabor_node_position"].see(a.nodes[k][axis], around.at(k).at(axis), 1e-5, s);
        }
        see_field(of["gabor_field_waves"], of["gabor_field_waves, slopes"], a.given,
                  noise::Lattice::field(place, waves, s.seed), 2e-5, 6e-4, s);

        place.cell_x = place.cell_y = 0;
        if (is_ambiguous(place))
            ++left_out;
        else {
            const auto expected = along_map(place, s.seed);
            see_field(of["gabor_field_direction"], of["gabor_field_direction, slopes"], a.field, expected,
                      value_tolerance, slope_tolerance, s);
            see_stripes(of["gabor_stripes_direction_at"], a.stripes_at, expected, s);
        }

        noise::LatticePlace here;
        here.local_x = s.p[0] * 1.5f;
        here.local_y = s.p[1] * 1.5f;
        if (is_ambiguous(here))
            ++left_out;
        else {
            const auto expected = along_map(here, s.seed);
            of["gabor_noise_direction"].see(a.noise, expected.value.imag(), value_tolerance, s);
            of["gabor_noise_direction_complex"].see(a.complex[0], expected.value.real(), value_tolerance, s);
            of["gabor_noise_direction_complex"].see(a.complex[1], expected.value.imag(), value_tolerance, s);
            of["gabor_noise_direction_gradient"].see(a.gradient[0], expected.value.imag(), value_tolerance,
                                                     s);
            of["gabor_noise_direction_gradient"].see(a.gradient[1], expected.slope_x.imag(), slope_tolerance,
                                                     s);
            of["gabor_noise_direction_gradient"].see(a.gradient[2], expected.slope_y.imag(), slope_tolerance,
                                                     s);
            see_stripes(of["gabor_stripes_direction"], a.stripes, expected, s);
        }

        noise::LatticePlace tile;
        const auto repeat = [](double p, double period, double& local, double& radius, std::int32_t& nodes) {
            nodes = std::max(static_cast<std::int32_t>(std::floor(period * 1.5 + 0.5)), 3);
            radius = nodes / period;
            local = (p / period - std::floor(p / period)) * nodes;
        };
        repeat(s.p[0], s.tile[0], tile.local_x, tile.radius_x, tile.period_x);
        repeat(s.p[1], s.tile[1], tile.local_y, tile.radius_y, tile.period_y);
        if (is_ambiguous(tile))
            ++left_out;
        else {
            const auto expected = along_map(tile, s.seed);
            of["gabor_noise_direction_tiled"].see(a.tiled, expected.value.imag(), value_tolerance, s);
            see_stripes(of["gabor_stripes_direction_tiled"], a.stripes_tiled, expected, s);
        }
    }
    test::check(of, 12);
    CHECK(left_out < count / 10);
}
