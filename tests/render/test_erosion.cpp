// Hills and erosion on the device: against the double-precision reference, and the properties of a good
// terrain.

#include "reference/erosion.hpp"
#include "sampler.hpp"

#include "passes/sample_erosion.h"
#include "passes/sample_erosion_lattice_2.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

using namespace gabor;
using test::Draw;
using test::Largest;

namespace {

constexpr std::size_t per_batch = 1 << 14;

// As in passes/sample_erosion.comp.
struct Parameters {
    std::int32_t octaves = 5;
    float frequency = 1.5f, strength = 0.12f, lacunarity = 2, gain = 0.5f, onset = 0.5f, detail = 1.5f,
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

// The terrain to measure: eroded by the drop-in, or by random splats.
class Terrains {
  public:
    Terrains(const vulkan::Device& device, int taps, test::Wanted wanted)
        : sampler_(device, taps, per_batch), wanted_(wanted) {}

    std::vector<Answer> at(std::span<const Sample> samples) {
        std::vector<Answer> all;
        for (std::size_t first = 0; first < samples.size(); first += per_batch) {
            const std::size_t count = std::min(per_batch, samples.size() - first);
            std::ranges::copy(samples.subspan(first, count), sampler_.samples().begin());
            std::ranges::copy(sampler_.answers(count, wanted_), std::back_inserter(all));
        }
        return all;
    }

    std::vector<Answer> beside(std::span<const Sample> samples, float x, float y) {
        std::vector<Sample> moved(samples.begin(), samples.end());
        for (Sample& sample : moved) {
            sample.local[0] += x;
            sample.local[1] += y;
        }
        return at(moved);
    }

  private:
    Sampler sampler_;
    test::Wanted wanted_;
};

constexpr auto by_drop_in = test::Wanted::at;
constexpr auto by_splats = test::Wanted::moving;

// Each sample is in a terrain of its own.
std::vector<Sample> anywhere(std::size_t count, unsigned seed) {
    Draw draw(seed);
    std::vector<Sample> samples(count);
    for (Sample& sample : samples) {
        sample.local[0] = draw.uniform(0, 8);
        sample.local[1] = draw.uniform(0, 8);
        sample.seed = draw.word();
    }
    return samples;
}

// One octave of gullies on a plane that falls towards any side.
std::vector<Sample> on_planes(std::size_t count, unsigned seed) {
    std::vector<Sample> samples = anywhere(count, seed);
    Draw draw(seed + 1);
    for (Sample& sample : samples) {
        const double turn = draw.uniform(0, 6.2831853);
        sample.own_base = 1;
        sample.slope[0] = static_cast<float>(std::cos(turn));
        sample.slope[1] = static_cast<float>(std::sin(turn));
        sample.erosion.octaves = 1;
    }
    return samples;
}

// The largest step of the height from a point to one 1/64 away, and after 6 and 12 halvings of the distance,
// always to the half with the larger step: a jump keeps its size.
std::array<double, 3> largest_steps(Terrains& terrains) {
    std::vector<Sample> left = anywhere(per_batch, 1), right = left;
    for (Sample& sample : right)
        sample.local[0] += 1.0f / 64;
    std::vector<Answer> low = terrains.at(left), high = terrains.at(right);
    std::array<double, 3> largest{};
    for (int halvings = 0; halvings <= 12; ++halvings) {
        if (halvings % 6 == 0)
            for (std::size_t i = 0; i < left.size(); ++i)
                largest.at(static_cast<std::size_t>(halvings / 6)) =
                    std::max<double>(largest.at(static_cast<std::size_t>(halvings / 6)),
                                     std::abs(high[i].eroded.height - low[i].eroded.height));
        std::vector<Sample> middle = left;
        for (std::size_t i = 0; i < left.size(); ++i)
            middle[i].local[0] = 0.5f * (left[i].local[0] + right[i].local[0]);
        const std::vector<Answer> between = terrains.at(middle);
        for (std::size_t i = 0; i < left.size(); ++i) {
            const float here = between[i].eroded.height;
            const bool lower = std::abs(here - low[i].eroded.height) > std::abs(high[i].eroded.height - here);
            (lower ? right : left)[i] = middle[i];
            (lower ? high : low)[i] = between[i];
        }
    }
    return largest;
}

// Mean angle in degrees between the gullies of one octave and the slope of the hills, weighted by the square
// of the gullies' own slope.
double gully_angle(Terrains& terrains) {
    std::vector<Sample> samples = anywhere(per_batch, 2);
    const float step = 1.0f / 256;
    for (Sample& sample : samples)
        sample.erosion.octaves = 1;
    const auto left = terrains.beside(samples, -step, 0), right = terrains.beside(samples, step, 0),
               down = terrains.beside(samples, 0, -step), up = terrains.beside(samples, 0, step),
               here = terrains.at(samples);
    const auto gully = [](const Answer& answer) { return static_cast<double>(answer.eroded.ridge); };
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double x = gully(right[i]) - gully(left[i]), y = gully(up[i]) - gully(down[i]);
        const double fall_x = here[i].hills.slope[0], fall_y = here[i].hills.slope[1];
        const double power = x * x + y * y, fall = std::hypot(fall_x, fall_y);
        if (fall < 0.3 || power == 0)
            continue;
        sum += power * std::asin(std::abs(x * fall_x + y * fall_y) / (std::sqrt(power) * fall));
        weight += power;
    }
    return sum / weight * 180 / std::numbers::pi;
}

// Local minima per unit area (lower than all eight neighbours, 1/64 away): those of the terrain minus those
// of the hills.
double pits(Terrains& terrains) {
    constexpr std::size_t side = 128;
    int count = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        std::vector<Sample> samples(side * side);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].local[0] = static_cast<float>(i % side) / 64;
            samples[i].local[1] = static_cast<float>(i / side) / 64;
            samples[i].seed = seed;
        }
        const std::vector<Answer> answers = terrains.at(samples);
        const auto lowest = [&](std::size_t i, auto height) {
            for (const std::size_t j :
                 {i - 1, i + 1, i - side, i + side, i - side - 1, i - side + 1, i + side - 1, i + side + 1})
                if (height(answers[j]) <= height(answers[i]))
                    return 0;
            return 1;
        };
        for (std::size_t y = 1; y + 1 < side; ++y)
            for (std::size_t x = 1; x + 1 < side; ++x)
                count += lowest(y * side + x, [](const Answer& a) { return a.eroded.height; }) -
                         lowest(y * side + x, [](const Answer& a) { return a.hills.height; });
    }
    return count / (8 * std::pow((side - 2) / 64.0, 2));
}

// The largest curvature of gullies on planes over its root mean square: spikes could appear where waves
// cancel.
double spikes(Terrains& terrains) {
    const std::vector<Sample> samples = on_planes(8 * per_batch, 3);
    const float step = 1.0f / 64;
    const auto left = terrains.beside(samples, -step, 0), right = terrains.beside(samples, step, 0),
               down = terrains.beside(samples, 0, -step), up = terrains.beside(samples, 0, step),
               here = terrains.at(samples);
    double largest = 0, square = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double curvature = left[i].eroded.height + right[i].eroded.height + down[i].eroded.height +
                                 up[i].eroded.height - 4.0 * here[i].eroded.height;
        largest = std::max(largest, std::abs(curvature));
        square += curvature * curvature;
    }
    return largest / std::sqrt(square / static_cast<double>(samples.size()));
}

// How much more of the slopes' power lies along the axes than along the diagonals.
double axes(Terrains& terrains) {
    double fourfold = 0, power = 0;
    for (const Answer& answer : terrains.at(anywhere(16 * per_batch, 5))) {
        const std::complex<double> slope(answer.eroded.slope[0], answer.eroded.slope[1]);
        if (slope != 0.0)
            fourfold += std::norm(slope) * std::cos(4 * std::arg(slope));
        power += std::norm(slope);
    }
    return fourfold / power;
}

// By how much the mean square of gullies on planes depends on where in a cell of their lattice, `cell` wide,
// they are: (largest - least) / mean over 4 x 4 places.
double cells(Terrains& terrains, double cell) {
    const std::vector<Sample> samples = on_planes(16 * per_batch, 7);
    const auto answers = terrains.at(samples);
    std::array<double, 16> square{}, count{};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto part = [&](double p) {
            return static_cast<std::size_t>(4 * (p / cell - std::floor(p / cell))) % 4;
        };
        const std::size_t place = 4 * part(samples[i].local[1]) + part(samples[i].local[0]);
        square.at(place) += std::pow(answers[i].eroded.ridge, 2);
        ++count.at(place);
    }
    double mean = 0, least = 1e9, most = 0;
    for (std::size_t i = 0; i < square.size(); ++i) {
        const double value = square.at(i) / count.at(i);
        mean += value / 16;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return (most - least) / mean;
}

// RMS of the slope minus finite differences of the height, relative to the RMS of the latter.
double slope_error(Terrains& terrains) {
    const std::vector<Sample> samples = anywhere(2 * per_batch, 9);
    const float step = 1.0f / 2048;
    const auto left = terrains.beside(samples, -step, 0), right = terrains.beside(samples, step, 0),
               here = terrains.at(samples);
    double error = 0, power = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double slope = 1024.0 * (right[i].eroded.height - left[i].eroded.height);
        error += std::pow(here[i].eroded.slope[0] - slope, 2);
        power += slope * slope;
    }
    return std::sqrt(error / power);
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
                const noise::Terrain wanted =
                    noise::terrain(s.ground(), {s.dx[0], s.dx[1]}, {s.dy[0], s.dy[1]}, s.seed);
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
                    slopes.see(answer.eroded.slope[axis], eroded.slope[axis], 1.5e-5 + 2e-6 * finest, s);
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

TEST_CASE("eroded heights are continuous, and their gullies run down the slope without spikes or traces of a "
          "lattice",
          "[erosion]") {
    const vulkan::Device device;
    for (const int taps : {2, 3}) {
        Terrains terrains(device, taps, by_drop_in);
        const auto at_most = [&](const char* name, double value, double limit) {
            fmt::print("{} taps, {}: {:.3g} of {:.3g}\n", taps, name, value, limit);
            CHECK(value <= limit);
        };
        at_most("step over 1/262144", largest_steps(terrains)[2], 2e-4);
        at_most("degrees between gullies and slope", gully_angle(terrains), 22);
        at_most("pits per unit of area", pits(terrains), 6);
        at_most("spikes", spikes(terrains), 9);
        at_most("axes", std::abs(axes(terrains)), 0.015);
        at_most("cells", cells(terrains, 2 / (0.8 * taps * 1.5)), 0.05);
        at_most("error of the slope", slope_error(terrains), 0.64);
    }
}

TEST_CASE("filtering gullies keeps the mean height", "[erosion]") {
    const vulkan::Device device;
    Terrains terrains(device, 3, by_drop_in);
    std::vector<Sample> samples = anywhere(16 * per_batch, 11);
    const auto sharp = terrains.at(samples);
    double relief = 0;
    for (const Answer& answer : sharp)
        relief += std::pow(answer.eroded.height, 2) / static_cast<double>(sharp.size());
    relief = std::sqrt(relief);
    for (std::size_t i = 0; i < samples.size(); ++i) { // on hills too smooth for the filter to change
        const Terrain& hills = sharp[i].hills;
        samples[i].own_base = 1;
        samples[i].height = hills.height;
        std::ranges::copy(hills.slope, samples[i].slope);
        samples[i].ridge = hills.ridge;
    }
    for (const float pixel : {1 / 64.0f, 1 / 24.0f, 1 / 8.0f, 1 / 3.0f, 1.0f, 100.0f}) {
        for (Sample& sample : samples)
            sample.dx[0] = sample.dy[1] = pixel;
        const auto filtered = terrains.at(samples);
        for (const double low : {-1.0, -0.5, 0.5}) { // in valleys, on slopes, on peaks
            double sum = 0, square = 0, count = 0;
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (sharp[i].hills.ridge < low || sharp[i].hills.ridge >= (low == -0.5 ? 0.5 : low + 0.5))
                    continue;
                const double difference = filtered[i].eroded.height - sharp[i].eroded.height;
                sum += difference;
                square += difference * difference;
                ++count;
            }
            const double mean = sum / count,
                         error = std::sqrt(square / count - mean * mean) / std::sqrt(count);
            fmt::print("pixel {:.3f}, ridge from {}: {:.2f} +- {:.2f} % of the relief {:.3f}\n", pixel, low,
                       100 * mean / relief, 100 * error / relief, relief);
            CHECK(std::abs(mean) + 2 * error < 0.01 * relief);
        }
    }
}

// The pixel's filter is normal with a deviation of half its side; the last one shows only the mean.
TEST_CASE("filtered hills are close to the mean over each pixel, and keep the overall mean", "[erosion]") {
    const vulkan::Device device;
    Terrains terrains(device, 3, by_drop_in);
    constexpr std::size_t places = per_batch, points = 64;
    const std::vector<Sample> middles = anywhere(places, 17);
    struct {
        float pixel;
        double error; // root mean square, of the hills' deviation
    } constexpr wanted[]{{1 / 16.0f, 0.02}, {1 / 4.0f, 0.1}, {1, 0.4}, {100, 0.13}};
    for (const auto& [pixel, limit] : wanted) {
        std::vector<Sample> filtered = middles, around;
        std::mt19937 generator(19);
        std::normal_distribution<float> spread(0, pixel / 2);
        for (Sample& sample : filtered) {
            for (std::size_t n = 0; n < points; ++n) {
                around.push_back(sample);
                for (float& at : around.back().local)
                    at += spread(generator);
            }
            sample.dx[0] = sample.dy[1] = pixel;
        }
        const auto found = terrains.at(filtered), sharp = terrains.at(around);
        double error = 0, power = 0, mean = 0, relief = 0;
        for (std::size_t i = 0; i < places; ++i) {
            double hills = 0;
            for (std::size_t n = i * points; n < (i + 1) * points; ++n) {
                hills += sharp[n].hills.height / points;
                mean += sharp[n].eroded.height / (places * points);
                relief += std::pow(sharp[n].eroded.height, 2) / (places * points);
                power += std::pow(sharp[n].hills.height, 2) / (places * points);
            }
            error += std::pow(found[i].hills.height - hills, 2) / places;
            mean -= found[i].eroded.height / places;
        }
        error = std::sqrt(error / power);
        mean = std::abs(mean) / std::sqrt(relief);
        fmt::print(
            "pixel {:.3f}: {:.4f} of the hills' deviation off; mean height {:.2f} % of the relief off\n",
            pixel, error, 100 * mean);
        CHECK(error < limit);
        CHECK(mean < 0.01);
    }
}

TEST_CASE("eroded tiles have no seam", "[erosion]") {
    const vulkan::Device device;
    Draw draw(13);
    for (const int taps : {2, 3}) {
        Terrains terrains(device, taps, by_drop_in);
        std::vector<Sample> samples = anywhere(per_batch, 15), moved;
        for (Sample& sample : samples)
            for (int axis = 0; axis < 2;
                 ++axis) { // numbers with few bits, so that sums and products are exact
                sample.local[axis] = std::round(64 * sample.local[axis]) / 64;
                sample.period[axis] = static_cast<float>(4 << draw.word() % 3);
            }
        moved = samples;
        for (Sample& sample : moved)
            for (int axis = 0; axis < 2; ++axis)
                sample.local[axis] += sample.period[axis] * std::round(draw.uniform(-3, 3));
        const auto here = terrains.at(samples), there = terrains.at(moved);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            INFO(to_string(samples[i]));
            REQUIRE(here[i].hills.height == there[i].hills.height);
            REQUIRE(here[i].eroded.height == there[i].eroded.height);
            REQUIRE(here[i].eroded.slope[1] == there[i].eroded.slope[1]);
        }
        const std::vector<Sample> endless = anywhere(per_batch, 15);
        const auto untiled = terrains.at(endless);
        std::size_t equal = 0;
        for (std::size_t i = 0; i < endless.size(); ++i)
            equal += untiled[i].eroded.height == here[i].eroded.height;
        CHECK(equal < per_batch / 100); // a period changes the terrain
    }
}

TEST_CASE("erosion compared with random splats", "[.table]") {
    const vulkan::Device device;
    fmt::print("{:<28}{:>30}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "step at 1/64, 1/4096, 1/262144",
               "angle", "pits", "spikes", "axes", "cells", "slope");
    const auto row = [&](const char* name, int taps, test::Wanted wanted, double cell) {
        Terrains terrains(device, taps, wanted);
        const auto steps = largest_steps(terrains);
        fmt::print(
            "{:<28}{:>10.4f}{:>10.5f}{:>10.6f}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.3f}{:>10.3f}{:>10.3f}\n", name,
            steps[0], steps[1], steps[2], gully_angle(terrains), pits(terrains), spikes(terrains),
            axes(terrains), cells(terrains, cell), slope_error(terrains));
    };
    row("gabor_eroded, 3 taps", 3, by_drop_in, 1 / (1.2 * 1.5));
    row("gabor_eroded, 2 taps", 2, by_drop_in, 1 / (0.8 * 1.5));
    row("random splats", 3, by_splats, 0.9 / 1.5);
}
