// Evaluates the lattice's functions over all floats, as docs/gallery.md promises for arguments out of range.

#include "lattice_sampler.hpp"
#include "range.hpp"
#include "sampler_lattice_3d.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

using namespace gabor;

namespace {

constexpr std::size_t per_batch = 1 << 14;

// Evaluates samples from `make` with each number of taps and checks all answers.
template <typename Make>
void check_finite(Make make) {
    const vulkan::Device device;
    for (int taps = 2; taps <= 4; ++taps) {
        test::LatticeSampler sampler(device, taps, per_batch);
        test::AnyFloat draw;
        const float nodes = static_cast<float>(taps) / 2;
        for (test::LatticeSample& s : sampler.samples()) {
            s = {{3, -4}, {0.3f, 0.8f}, {3.3f, 4.8f}, {nodes, nodes}, {0, 0}, 1, 0.3f,
                 4,       0.7f,         draw.word(),  {4, 4}};
            make(s, draw, nodes);
        }
        const auto answers = sampler.answers(per_batch);
        test::Broken broken[] = {{"values"}, {"slopes"}, {"gabor_unorm"}, {"gabor_phasor"}};
        for (std::size_t i = 0; i < per_batch; ++i) {
            const test::LatticeSample& sample = sampler.samples()[i];
            const test::LatticeAnswer& a = answers[i];
            for (const std::span<const float> values :
                 {std::span<const float>(a.value), std::span<const float>(a.complex),
                  std::span<const float>(a.four), std::span<const float>(&a.noise, 1),
                  std::span<const float>(&a.tiled, 1), std::span<const float>(&a.animated, 1),
                  std::span<const float>(&a.at, 1)})
                broken[0].see(values, test::largest_noise, sample);
            const float any = std::numeric_limits<float>::max();
            broken[1].see(a.slope_x, any, sample);
            broken[1].see(a.slope_y, any, sample);
            broken[1].see(a.gradient, any, sample);
            broken[2].see({&a.unorm, 1}, 1, sample);
            broken[3].see(a.phasor, test::largest_noise, sample);
        }
        for (const test::Broken& function : broken) {
            INFO(taps << " taps, " << function.function << ": " << function.where);
            CHECK(function.times == 0);
        }
    }
}

} // namespace

TEST_CASE("any frequency and any finite orientation give finite noise on the lattice", "[range]") {
    check_finite([](test::LatticeSample& s, test::AnyFloat& draw, float) {
        s.frequency = draw.within(test::infinity);
        s.orientation = draw.within(std::numeric_limits<float>::max());
    });
}

TEST_CASE("any cell, any place and any finite time give finite noise on the lattice", "[range]") {
    check_finite([](test::LatticeSample& s, test::AnyFloat& draw, float nodes) {
        for (int axis = 0; axis < 2; ++axis) {
            s.cell[axis] = draw.cell();
            s.period[axis] = draw.cell() & 0x7fffffff;
            s.local[axis] = draw.within(64);
            s.p[axis] = draw.within(test::world / nodes);
        }
        s.time = draw.within(std::numeric_limits<float>::max());
    });
}

TEST_CASE("any period gives finite noise on the lattice", "[range]") {
    check_finite([](test::LatticeSample& s, test::AnyFloat& draw, float nodes) {
        for (int axis = 0; axis < 2; ++axis) {
            s.tile[axis] = draw.within(test::infinity);
            // As long as positions in nodes do not overflow: see docs/gallery.md.
            s.p[axis] =
                draw.within(std::min(7e8f * std::max(s.tile[axis], 1.0f / 1024), test::world / (2 * nodes)));
        }
    });
}

TEST_CASE("any float gives finite noise in space", "[range]") {
    const vulkan::Device device;
    for (const auto entry : {test::Entry3d::field, test::Entry3d::surface, test::Entry3d::tiled,
                             test::Entry3d::animated, test::Entry3d::filtered, test::Entry3d::isotropic,
                             test::Entry3d::surface_isotropic, test::Entry3d::noise_isotropic_filtered}) {
        test::LatticeSampler3d sampler(device, per_batch, entry);
        test::AnyFloat draw;
        const auto drawn = [&draw](float most) {
            return std::array{draw.within(most), draw.within(most), draw.within(most)};
        };
        for (std::size_t i = 0; i < per_batch; ++i) {
            test::LatticeSample3d s;
            s.place.local = s.p = {0.3f, 0.8f, 3.1f};
            s.seed = draw.word();
            if (i % 4 == 0) {
                s.frequency = draw.within(test::infinity);
                s.direction = drawn(test::infinity);
                s.normal = drawn(test::infinity);
            } else if (i % 4 == 1) {
                s.dx = drawn(test::infinity);
                s.dy = drawn(test::infinity);
            } else if (i % 4 == 2) {
                s.tile = drawn(test::infinity);
                for (std::size_t axis = 0; axis < 3; ++axis) // as long as periods do not overflow
                    s.p[axis] =
                        draw.within(std::min(7e8f * std::max(s.tile[axis], 1.0f / 1024), test::world / 3));
            } else {
                s.p = drawn(test::world / 3);
                s.place.local = drawn(64);
                s.place.cell = {draw.cell(), draw.cell(), draw.cell()};
                for (std::int32_t& period : s.place.period)
                    period = draw.cell() & 0x7fffffff;
                s.place.time = draw.within(std::numeric_limits<float>::max());
            }
            sampler.samples()[i] = s;
        }
        const auto answers = sampler.answers(per_batch);
        test::Broken broken{fmt::format("entry {}", static_cast<int>(entry))};
        const bool by_place = entry <= test::Entry3d::surface_isotropic;
        for (std::size_t i = 0; i < per_batch; ++i) {
            const std::span<const float> values = answers[i].value;
            broken.see(values.first(by_place ? 2 : 1), test::largest_noise, sampler.samples()[i]);
            broken.see(values.first(by_place ? 9 : 4), std::numeric_limits<float>::max(),
                       sampler.samples()[i]);
        }
        INFO(broken.function << ": " << broken.where);
        CHECK(broken.times == 0);
    }
}
