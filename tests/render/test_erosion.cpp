// Hills and erosion on the device: against the double-precision reference, and what a terrain must have.

#include "reference/erosion.hpp"
#include "sampler.hpp"

#include "passes/sample_erosion.h"
#include "passes/sample_erosion_lattice_2.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace gabor;
using test::Draw;
using test::Largest;

namespace {

constexpr std::size_t per_batch = 1 << 14;

// As in passes/sample_erosion.comp.
struct Parameters {
    std::int32_t octaves = 5;
    float frequency = 1.5f, strength = 0.12f, lacunarity = 2, gain = 0.5f, onset = 0.6f, detail = 1.5f,
          sharpness = 2, ridge_rounding = 0.1f, crease_rounding = 0.1f, gully_weight = 0.5f, branching = 1;
};
struct Sample {
    std::int32_t cell[2] = {};
    float local[2] = {};
    float period[2] = {};
    float dx[2] = {};
    float dy[2] = {};
    float slope[2] = {};
    float height = 0;
    float ridge = 0;
    std::int32_t own_base = 0;
    std::uint32_t seed = 7;
    Parameters erosion;

    noise::Ground ground() const {
        return {{cell[0], cell[1]}, {local[0], local[1]}, {period[0], period[1]}};
    }
    noise::Erosion reference() const {
        const Parameters& e = erosion;
        return {e.octaves, e.frequency, e.strength,       e.lacunarity,      e.gain,         e.onset,
                e.detail,  e.sharpness, e.ridge_rounding, e.crease_rounding, e.gully_weight, e.branching};
    }
};

std::string to_string(const Sample& s) {
    const Parameters& e = s.erosion;
    return fmt::format("cell ({}, {}) + ({}, {}), period ({}, {}), pixel ({}, {}) ({}, {}), base {} {} ({}, "
                       "{}) {}, seed {}, "
                       "erosion {} {} {} {} {} {} {} {} {} {} {} {}",
                       s.cell[0], s.cell[1], s.local[0], s.local[1], s.period[0], s.period[1], s.dx[0],
                       s.dx[1], s.dy[0], s.dy[1], s.own_base, s.height, s.slope[0], s.slope[1], s.ridge,
                       s.seed, e.octaves, e.frequency, e.strength, e.lacunarity, e.gain, e.onset, e.detail,
                       e.sharpness, e.ridge_rounding, e.crease_rounding, e.gully_weight, e.branching);
}

struct Terrain {
    float height;
    float slope[2];
    float ridge;
};
struct Answer {
    Terrain hills;
    Terrain eroded;
    Terrain plain;
};

struct Sampler : test::Probe<Sample, Answer> {
    Sampler(const vulkan::Device& device, int taps, std::size_t capacity)
        : Probe(device, capacity,
                taps == 2 ? std::span<const std::uint32_t>(sample_erosion_lattice_2_spirv)
                          : sample_erosion_spirv,
                {}) {}
};

Sample draw_sample(Draw& draw) {
    Sample s;
    const bool far = draw.word() % 2, tiled = draw.word() % 4 == 0;
    for (int axis = 0; axis < 2; ++axis) {
        s.cell[axis] = tiled ? 0 : far ? draw.cell() : static_cast<std::int32_t>(draw.uniform(-5, 5));
        s.local[axis] = draw.word() % 8 ? draw.uniform(0, 1) : std::round(draw.uniform(-2, 2));
        s.period[axis] = tiled && draw.word() % 4 ? std::round(draw.uniform(4, 9)) : 0;
        if (draw.word() % 2) {
            s.dx[axis] = draw.uniform(-0.2, 0.2);
            s.dy[axis] = draw.uniform(-0.2, 0.2);
        }
        s.slope[axis] = draw.uniform(-1, 1);
    }
    s.ridge = draw.uniform(-1, 1);
    s.height = draw.uniform(-1, 1);
    s.own_base = draw.word() % 2;
    s.seed = draw.word();
    Parameters& e = s.erosion;
    e.octaves = static_cast<std::int32_t>(draw.word() % 7);
    e.frequency = std::exp2(draw.uniform(-2, 4));
    e.strength = draw.uniform(0, 0.3);
    e.lacunarity = draw.word() % 2 ? 2 : draw.uniform(1.5, 2.5);
    e.gain = draw.uniform(0.3, 0.7);
    e.onset = draw.uniform(0.2, 2);
    e.detail = draw.uniform(1, 3);
    e.sharpness = draw.uniform(1, 4);
    e.ridge_rounding = draw.word() % 4 ? draw.uniform(0, 0.5) : 0;
    e.crease_rounding = draw.word() % 4 ? draw.uniform(0, 0.5) : 0;
    e.gully_weight = draw.uniform(0, 1);
    e.branching = draw.uniform(0, 1.5);
    return s;
}

} // namespace

// An octave's rounding turns the gullies of the next.
TEST_CASE("hills and erosion agree with the reference", "[erosion]") {
    const vulkan::Device device;
    for (const int taps : {2, 3}) {
        Draw draw(static_cast<unsigned>(taps));
        Sampler sampler(device, taps, per_batch);
        Largest hills, hill_slopes, heights, slopes, ridges, plain;
        for (int batch = 0; batch < 4; ++batch) {
            for (Sample& sample : sampler.samples())
                sample = draw_sample(draw);
            const auto answers = sampler.answers(per_batch);
            for (std::size_t i = 0; i < per_batch; ++i) {
                const Sample& s = sampler.samples()[i];
                const Answer& answer = answers[i];
                const noise::Terrain wanted = noise::terrain(s.ground(), s.seed);
                hills.see(answer.hills.height, wanted.height, 5e-7, s);
                hills.see(answer.hills.ridge, wanted.ridge, 1e-6, s);
                for (std::size_t axis = 0; axis < 2; ++axis)
                    hill_slopes.see(answer.hills.slope[axis], wanted.slope[axis], 2e-6, s);
                const noise::Terrain base{s.own_base ? s.height : answer.hills.height,
                                          {s.own_base ? s.slope[0] : answer.hills.slope[0],
                                           s.own_base ? s.slope[1] : answer.hills.slope[1]},
                                          s.own_base ? s.ridge : answer.hills.ridge};
                const noise::Terrain eroded = noise::eroded(taps, s.ground(), {s.dx[0], s.dx[1]},
                                                            {s.dy[0], s.dy[1]}, base, s.reference(), s.seed);
                const double finest =
                    s.erosion.frequency * std::pow(s.erosion.lacunarity, s.erosion.octaves - 1);
                heights.see(answer.eroded.height, eroded.height, 5e-6, s);
                ridges.see(answer.eroded.ridge, eroded.ridge, 2e-4, s);
                for (std::size_t axis = 0; axis < 2; ++axis)
                    slopes.see(answer.eroded.slope[axis], eroded.slope[axis], 1e-5 + 2e-6 * finest, s);
                const bool near = s.cell[0] == 0 && s.cell[1] == 0 && !s.own_base &&
                                  (s.period[0] > 0) == (s.period[1] > 0) &&
                                  !(s.period[0] > 0 && (s.dx[0] != 0));
                if (near && s.dx[0] == 0 && s.dx[1] == 0 && s.dy[0] == 0 && s.dy[1] == 0)
                    plain.see(answer.plain.height, answer.eroded.height, 1e-5, s);
            }
        }
        fmt::print("{} taps on {}; largest differences in units of the tolerance\n", taps,
                   device.info().name);
        hills.check("gabor_terrain_at");
        hill_slopes.check("  its slope");
        heights.check("gabor_eroded_at");
        slopes.check("  its slope");
        ridges.check("  its ridge");
        plain.check("gabor_eroded, _tiled");
    }
}
