// Compares gabor_direction.glsl with the double-precision reference.

#include "noise.hpp"

using namespace gabor;
using test::Differences;
using test::n;
using test::place_of;
using test::Random;

namespace {

struct Sample {
    noise::Place<2> place;
    gabor_vec2 p;
    std::uint32_t seed;
    float sharpness;
};

std::string to_string(const Sample& s) {
    return fmt::format("{}, p ({}, {}), seed {}, sharpness {}", test::to_string(s.place), s.p.x, s.p.y,
                       s.seed, s.sharpness);
}

using Vectors = std::array<noise::Vector<2>, 9>;

// The positions of the nine nodes around a point, row by row.
Vectors nodes_around(const noise::Place<2>& place) {
    Vectors nodes{};
    for (int k = 0; k < 9; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double offset = axis == 0 ? k % 3 - 1 : k / 3 - 1, period = place.period[axis];
            double index = place.cell[axis] + std::floor(place.local[axis] + 0.5) + offset;
            if (period > 0)
                index -= std::floor(index / period) * period;
            nodes.at(static_cast<std::size_t>(k))[axis] = index / place.radius[axis];
        }
    }
    return nodes;
}

// Lattice3::map_at in double precision.
noise::Vector<2> map_at(const noise::Vector<2>& p) {
    return p[0] + p[1] > 1 ? noise::Vector<2>{1.5, 0.25 * p[1]} : noise::Vector<2>{-0.5 * p[0], 2};
}

noise::Field<2> along_map(const noise::Place<2>& place, std::uint32_t seed) {
    Vectors waves = nodes_around(place);
    std::ranges::transform(waves, waves.begin(), map_at);
    return noise::map_noise(waves, seed).field(place);
}

// Whether rounding can select other nodes around the point.
bool is_between_nodes(const noise::Place<2>& place) {
    return std::ranges::any_of(
        place.local, [](double local) { return std::abs(local + 0.5 - std::round(local + 0.5)) < 1e-4; });
}

// Whether rounding can select other nodes, or the other side of the map's jump at a node.
bool is_ambiguous(const noise::Place<2>& place) {
    return is_between_nodes(place) || std::ranges::any_of(nodes_around(place), [](const auto& node) {
               return std::abs(node[0] + node[1] - 1) < 1e-4;
           });
}

} // namespace

TEST_CASE("noise along a direction map agrees with the reference in any cell, with any period, at any time",
          "[direction][oracle]") {
    constexpr int count = 1 << 15;
    Random random(71);
    Differences of;
    // Within 8 radii of the origin, waves have up to 6 cycles per radius, and p is rounded by about 1e-6.
    constexpr double tight = 3e-5, loose = 5e-4;
    int left_out = 0;
    for (int i = 0; i < count; ++i) {
        Sample s{test::any_lattice_place<2>(random, 3), random.uniform<gabor_vec2>(-8, 8), random.word(),
                 random.uniform(0, 4)};
        test::Lattice3::GaborWaves given;
        Vectors waves;
        const auto around = nodes_around(s.place);
        for (std::size_t k = 0; k < 9; ++k) {
            const int index = static_cast<int>(k);
            given.wave[index] = random.uniform<gabor_vec2>(-4, 4);
            if (random.one_in(8))
                given.wave[index].x = 0;
            waves.at(k) = test::wide(given.wave[index]);
            const gabor_vec2 node = n.gabor_node_position(place_of(n, s.place), index);
            if (!is_between_nodes(s.place) && s.place.period[0] && s.place.period[1])
                see(of["gabor_node_position"], node, around.at(k), 1e-5, s);
        }
        if (!is_between_nodes(s.place))
            see(of["gabor_field_waves"], of["gabor_field_waves, slopes"],
                n.gabor_field_waves(place_of(n, s.place), given, s.seed),
                noise::map_noise(waves, s.seed).field(s.place), 2e-5, 6e-4, s);

        s.place.cell = {}; // far from the origin, the map's frequencies are too high
        const noise::Place<2> here = test::lattice_place(3, s.p);
        for (const noise::Place<2>& place : {s.place, here}) {
            if (is_ambiguous(place)) {
                ++left_out;
                continue;
            }
            const auto expected = along_map(place, s.seed);
            see(of["gabor_field_direction"], of["gabor_field_direction, slopes"],
                n.gabor_field_direction(place_of(n, place), s.seed), expected, tight, loose, s);
        }
        if (!is_ambiguous(here))
            see(of["its stripes"],
                n.gabor_stripes_of(n.gabor_field_direction(place_of(n, here), s.seed), s.sharpness),
                noise::lattice_stripes(along_map(here, s.seed).value, s.sharpness),
                tight * std::max(1.0f, s.sharpness), s);
    }
    test::check(of, 6);
    CHECK(left_out < count / 2);
}
