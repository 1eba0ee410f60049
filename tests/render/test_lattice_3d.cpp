// Every function of gabor_lattice_3d.glsl, on the device, against the double-precision reference.

#include "sampler_lattice_3d.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>

using namespace gabor;
using noise::Lattice3d;
using test::Largest;
using test::LatticeAnswer3d;
using test::LatticeSample3d;
using test::LatticeSampler3d;

namespace {

constexpr std::size_t per_batch = 1 << 9;

Lattice3d::Vector wave_of(const LatticeSample3d& sample) {
    Lattice3d::Vector wave = test::unit(sample.direction);
    for (double& coordinate : wave)
        coordinate *= sample.frequency;
    return wave;
}

std::array<float, 3> vector(test::Draw& draw, float reach) {
    return {draw.uniform(-reach, reach), draw.uniform(-reach, reach), draw.uniform(-reach, reach)};
}

// In all octants up to 10^6, or in any cell; one coordinate in four on or next to where the nodes change, and
// one in eight next to a node.
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

// A position in all octants, and the place that the functions of a position see: p * 1.5 in single precision.
Lattice3d::Place draw_position(test::Draw& draw, std::array<float, 3>& p) {
    const float reach = std::exp2(draw.uniform(0, 18));
    p = vector(draw, reach);
    Lattice3d::Place place;
    for (std::size_t axis = 0; axis < 3; ++axis)
        place.local[axis] = p[axis] * 1.5f;
    return place;
}

// Waves turn by up to 2 pi F per radius, and the shader's phases are single precision.
double tolerance(double frequency) {
    return 2e-5 * std::max(1.0, frequency / 4);
}

double slope_tolerance(double frequency) {
    return tolerance(frequency) * (2 * std::numbers::pi * frequency + 4);
}

double sum_of(const std::vector<noise::WeightedWave>& waves, const Lattice3d::Place& place) {
    double sum = 0;
    for (const noise::WeightedWave& w : waves)
        sum += w.weight * Lattice3d(w.wave, w.seed).field(place).value.imag();
    return sum;
}

Lattice3d::Filtered sum_of(const std::vector<noise::WeightedWave>& waves, const Lattice3d::Place& place,
                           const Lattice3d::Vector& dx, const Lattice3d::Vector& dy) {
    Lattice3d::Filtered sum{};
    for (const noise::WeightedWave& w : waves) {
        const Lattice3d::Filtered one = Lattice3d(w.wave, w.seed).filtered(place, dx, dy);
        sum.value += w.weight * one.value;
        sum.removed += w.weight * w.weight * one.removed;
    }
    return sum;
}

} // namespace

TEST_CASE("noise on the lattice in space agrees with the reference", "[oracle]") {
    const vulkan::Device device;
    test::Draw draw(21);
    LatticeSampler3d sampler(device, per_batch);
    Largest value, quadrature, slope, noise, gradient, complex, four, animated, tiled;
    for (int batch = 0; batch < 24; ++batch) {
        // The frequencies cover 0.1 to 64 evenly in octaves.
        const float frequency = batch == 0 ? 0 : 0.1f * static_cast<float>(std::exp2(batch * 0.405));
        std::array<Lattice3d::Place, per_batch> here;
        for (std::size_t i = 0; i < per_batch; ++i) {
            LatticeSample3d& sample = sampler.samples()[i];
            sample = {draw_place(draw), frequency, vector(draw, 3)};
            here[i] = draw_position(draw, sample.p);
            sample.seed = draw.word();
            sample.place.animated = batch % 3 == 1;
            sample.place.time = draw.uniform(-2, 2);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (batch % 3 == 2) {
                    sample.place.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                    sample.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
                }
                sample.tile[axis] = draw.uniform(0.5f, 9);
            }
        }
        const auto answers = sampler.ask(per_batch, LatticeSampler3d::all);
        const double tight = tolerance(frequency);
        const double loose = slope_tolerance(frequency);
        for (std::size_t i = 0; i < per_batch; ++i) {
            const LatticeSample3d& sample = sampler.samples()[i];
            const LatticeAnswer3d& answer = answers[i];
            const Lattice3d reference(wave_of(sample), sample.seed);
            const Lattice3d::Field field = reference.field(sample.place);
            value.see(answer.field[0][1], field.value.imag(), tight, sample);
            value.see(answer.value[0], field.value.imag(), tight, sample);
            quadrature.see(answer.field[0][0], field.value.real(), tight, sample);
            const Lattice3d::Field position = reference.field(here[i]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                slope.see(answer.field[axis + 1][1], field.slope[axis].imag(), loose, sample);
                slope.see(answer.field[axis + 1][0], field.slope[axis].real(), loose, sample);
                gradient.see(answer.gradient[axis + 1], position.slope[axis].imag(), loose, sample);
            }
            noise.see(answer.noise, position.value.imag(), tight, sample);
            gradient.see(answer.gradient[0], position.value.imag(), tight, sample);
            complex.see(answer.complex[0], position.value.real(), tight, sample);
            complex.see(answer.complex[1], position.value.imag(), tight, sample);
            for (int channel = 0; channel < 4; ++channel)
                four.see(answer.four[channel],
                         Lattice3d(wave_of(sample), sample.seed, channel).field(here[i]).value.imag(), tight, sample);
            Lattice3d::Place moving = here[i];
            moving.animated = 1;
            moving.time = sample.place.time;
            animated.see(answer.animated, reference.field(moving).value.imag(), tight, sample);
            // Where a float still holds it: p rounds on its way by 10^-6, and the wave turns by 2 pi F in a radius.
            Lattice3d::Place tile;
            bool held = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double period = sample.tile[axis];
                const double p = sample.p[axis];
                held = held && std::abs(p) <= 8;
                const double nodes = std::max(std::floor(period * 1.5 + 0.5), 3.0);
                tile.radius[axis] = static_cast<float>(nodes / period);
                tile.local[axis] = static_cast<float>(p * nodes / period);
                tile.period[axis] = static_cast<std::int32_t>(nodes);
            }
            if (held)
                tiled.see(answer.tiled, reference.field(tile).value.imag(), 4e-5 * (1 + frequency), sample);
        }
    }
    fmt::print("lattice in space on {}; largest differences in units of the tolerance\n", device.info().name);
    value.check("value by place");
    quadrature.check("quadrature by place");
    slope.check("slopes by place");
    noise.check("gabor_noise_3d");
    gradient.check("_gradient");
    complex.check("_complex");
    four.check("_four");
    animated.check("_animated");
    tiled.check("_tiled");
}

TEST_CASE("sums of directions and surface noise on the lattice agree with the reference", "[oracle]") {
    const vulkan::Device device;
    test::Draw draw(22);
    LatticeSampler3d sampler(device, per_batch);
    Largest isotropic, surface, surface_isotropic, removed, at;
    for (int batch = 0; batch < 10; ++batch) {
        const float frequency = 0.2f * static_cast<float>(batch);
        const bool filtered = batch % 2;
        std::array<Lattice3d::Place, per_batch> here;
        for (std::size_t i = 0; i < per_batch; ++i) {
            LatticeSample3d& sample = sampler.samples()[i];
            sample = {draw_place(draw), frequency, vector(draw, 3), vector(draw, 3)};
            here[i] = draw_position(draw, sample.p);
            sample.seed = draw.word();
            if (draw.word() % 4 == 0) // near where the projection ends
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sample.direction[axis] = sample.normal[axis] + draw.uniform(-0.3f, 0.3f);
            if (filtered) {
                const float reach = std::exp2(draw.uniform(-8, 1));
                sample.dx = vector(draw, reach);
                sample.dy = vector(draw, reach);
            }
        }
        const auto answers = sampler.ask(per_batch, LatticeSampler3d::all);
        for (std::size_t i = 0; i < per_batch; ++i) {
            const LatticeSample3d& sample = sampler.samples()[i];
            const LatticeAnswer3d& answer = answers[i];
            const auto normal = test::unit(sample.normal);
            const auto direction = test::unit(sample.direction);
            if (std::abs(std::abs(direction[2]) - 0.7) < 1e-5) // either axis is right
                continue;
            const auto all = noise::isotropic_waves(frequency, sample.seed);
            const auto along = noise::surface_waves(normal, frequency, direction, sample.seed);
            const auto tangents = noise::surface_isotropic_waves(normal, frequency, sample.seed);
            // A direction near the normal keeps a quarter of its length at least.
            const double tight = 4 * tolerance(frequency);
            const auto compare = [&](Largest& largest, const float* value, const auto& waves, double position) {
                largest.see(position, sum_of(waves, here[i]), tight, sample);
                const auto expected =
                    filtered ? sum_of(waves, sample.place, test::wide(sample.dx), test::wide(sample.dy))
                             : Lattice3d::Filtered{sum_of(waves, sample.place), 0};
                largest.see(value[0], expected.value, tight, sample);
                removed.see(value[1], expected.removed, tight, sample);
            };
            if (i % 16 == 0) // each has up to 32 directions
                compare(isotropic, answer.isotropic, all, answer.noise_isotropic);
            compare(surface, answer.surface, along, answer.noise_surface);
            compare(surface_isotropic, answer.surface_isotropic, tangents, answer.noise_surface_isotropic);
        }
    }
    fmt::print("sums on the lattice in space; largest differences in units of the tolerance\n");
    isotropic.check("isotropic");
    surface.check("surface");
    surface_isotropic.check("surface, isotropic");
    removed.check("variance removed");
}

TEST_CASE("noise on the lattice seen through a footprint agrees with the reference", "[oracle]") {
    const vulkan::Device device;
    test::Draw draw(23);
    LatticeSampler3d sampler(device, per_batch);
    Largest value, removed, position;
    for (int batch = 0; batch < 12; ++batch) {
        const float frequency = draw.uniform(0, batch % 2 ? 2 : 16);
        std::array<Lattice3d::Place, per_batch> here;
        for (std::size_t i = 0; i < per_batch; ++i) {
            LatticeSample3d& sample = sampler.samples()[i];
            sample = {draw_place(draw), frequency, vector(draw, 3)};
            here[i] = draw_position(draw, sample.p);
            sample.seed = draw.word();
            const float reach = std::exp2(draw.uniform(-8, 2));
            sample.dx = vector(draw, reach);
            sample.dy = vector(draw, reach);
            if (draw.word() % 4 == 0) // thin, and nearly parallel
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sample.dy[axis] = sample.dx[axis] * 0.3f + draw.uniform(-1e-3f, 1e-3f);
            if (batch % 4 == 3)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sample.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
        }
        const auto answers = sampler.ask(per_batch, LatticeSampler3d::all);
        for (std::size_t i = 0; i < per_batch; ++i) {
            const LatticeSample3d& sample = sampler.samples()[i];
            const Lattice3d reference(wave_of(sample), sample.seed);
            const auto dx = test::wide(sample.dx);
            const auto dy = test::wide(sample.dy);
            const Lattice3d::Filtered at = reference.filtered(sample.place, dx, dy);
            const double tight = 2 * tolerance(frequency);
            value.see(answers[i].value[0], at.value, tight, sample);
            removed.see(answers[i].value[1], at.removed, tight, sample);
            position.see(answers[i].filtered[0], reference.filtered(here[i], dx, dy).value, tight, sample);
        }
    }
    fmt::print("the lattice in space through a footprint; largest differences in units of the tolerance\n");
    value.check("value by place");
    removed.check("variance removed");
    position.check("gabor_noise_3d_filtered");
}

TEST_CASE("the gradient on the lattice is what differences of the reference say", "[oracle]") {
    test::Draw draw(24);
    for (int i = 0; i < 500; ++i) {
        const Lattice3d reference({draw.uniform(-3, 3), draw.uniform(-3, 3), draw.uniform(-3, 3)}, draw.word());
        Lattice3d::Place place;
        for (float& coordinate : place.local) // a float holds them, and those next to them
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

TEST_CASE("odd requests to the lattice in space give what is documented and never NaN", "[oracle]") {
    const vulkan::Device device;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float odd[] = {0, -0.0f, 1e-38f, 1e-30f, -3, 1e30f, 3e38f, infinity, -infinity};
    constexpr std::size_t count = std::size(odd) * 5;
    LatticeSampler3d sampler(device, count);
    std::size_t i = 0;
    for (const float x : odd) {
        for (int where = 0; where < 5; ++where) {
            LatticeSample3d sample;
            sample.place.local = {0.3f, 0.8f, 0.1f};
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
            sampler.samples()[i++] = sample;
        }
    }
    const auto answers = sampler.ask(count, LatticeSampler3d::all);
    for (i = 0; i < count; ++i) {
        INFO("sample " << i << ": " << to_string(sampler.samples()[i]));
        for (const float value : {answers[i].value[0], answers[i].isotropic[0], answers[i].surface[0],
                                  answers[i].surface_isotropic[0], answers[i].filtered[0]})
            CHECK(std::abs(value) < 10);
        for (const auto& slope : answers[i].field)
            CHECK(std::isfinite(slope[1]));
    }
    // A frequency counts by its magnitude, a direction without its length.
    LatticeSample3d plain;
    plain.place.local = {0.3f, 0.8f, 0.1f};
    plain.frequency = 3;
    sampler.samples()[0] = sampler.samples()[1] = sampler.samples()[2] = plain;
    sampler.samples()[1].frequency = -3;
    sampler.samples()[2].direction = {1e20f, 0, 0};
    const auto same = sampler.ask(3, LatticeSampler3d::value);
    CHECK(same[1].value[0] == same[0].value[0]);
    CHECK(same[2].value[0] == same[0].value[0]);
}
