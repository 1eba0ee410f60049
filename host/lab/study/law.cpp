// Effects that averaging over positions hides: the distribution at each position in a cell, the distribution
// of pairs, the dependence of the covariance on position, and traces of the cells in power spectra.

#include "study/figures.hpp"

#include "image/png.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/lines.hpp"
#include "statistics/moments.hpp"
#include "study/lattice.hpp"
#include "study/measures.hpp"

#include <boost/math/distributions/normal.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace gabor::study {

namespace {

struct Subject {
    std::string name;
    double visited; ///< impulses per value
    double cells_per_radius;
    int taps; ///< taps of the lattice; 0 for other noises
    std::function<Noise(const vulkan::Device&, const PlaneWave&)> make;
};

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    const auto add_ingredients = [&](const char* name, const Ingredients& ingredients) {
        all.push_back({name, 9.0 * ingredients.impulses, 1, 0,
                       [ingredients](const vulkan::Device& device, const PlaneWave& wave) {
                           return Noise(device, ingredients, wave);
                       }});
    };
    add_ingredients("seminal", Ingredients{});
    add_ingredients("advice", recommended);
    for (const noise::Recipe& recipe : noise::recipes())
        all.push_back(
            {recipe.is_lattice() ? fmt::format("lattice_{}", recipe.taps) : std::string(recipe.name),
             static_cast<double>(noise::visited_impulses(recipe)), recipe.radius, recipe.taps,
             [recipe](const vulkan::Device& device, const PlaneWave& wave) {
                 return Noise(device, recipe, wave);
             }});
    return all;
}

// A noise that is created when first used, and reused for the other rows of a table.
using Source = std::function<Noise&()>;

Source source(const vulkan::Device& device, const Subject& subject, const PlaneWave& wave) {
    return [&device, make = subject.make, wave, made = std::make_shared<std::optional<Noise>>()]() -> Noise& {
        if (!*made)
            made->emplace(make(device, wave));
        return **made;
    };
}

// Returns the values of several instances. Equal seeds give equal instances, at the same positions.
std::vector<float> draw(Noise& noise, std::uint64_t instances, const Grid& grid, std::uint32_t seed) {
    std::vector<float> values(instances << 2 * grid.bits);
    noise.fill(values, grid, 0, seed, ~seed);
    return values;
}

void append(Numbers& numbers, const statistics::Estimate& estimate) {
    numbers.insert(numbers.end(), {estimate.value, estimate.low, estimate.high});
}

ValueStatistics statistics_of(std::span<const float> values, double deviation = 1) {
    ValueStatistics result{{}, statistics::Gaussianity(deviation)};
    result.moments.add(values);
    result.gaussianity.add(values);
    return result;
}

constexpr std::string_view law_columns = "cvm,cvm_low,cvm_high,excess_kurtosis,beyond_3.5";

// The distribution of one value per instance.
Numbers law_of(Noise& noise, const Grid& grid, std::uint64_t instances, std::uint32_t seed) {
    const std::vector<float> values = draw(noise, instances, grid, seed);
    const ValueStatistics statistics = statistics_of(values);
    Numbers numbers;
    append(numbers, statistics.gaussianity.index());
    const auto far = std::ranges::count_if(values, [](float value) { return std::abs(value) > 3.5f; });
    numbers.push_back(statistics.moments.excess_kurtosis());
    numbers.push_back(static_cast<double>(far) / static_cast<double>(instances));
    return numbers;
}

constexpr int side = 8; // positions in a cell along an axis, the first at its corner

Table places(const vulkan::Device& device, const Effort& effort) {
    Table table{"law_places", fmt::format("noise,x,y,instances,{}", law_columns), {}};
    for (const Subject& subject : subjects()) {
        const Source noise = source(device, subject, {});
        for (int place = 0; place < side * side; ++place) {
            const double x = place % side / double{side};
            const double y = place / side / double{side};
            const double radius = subject.cells_per_radius;
            const Grid grid{.random = false, .shift = {x / radius, y / radius}};
            table.rows.push_back({fmt::format("{},{:g},{:g},{}", subject.name, x, y, effort.law),
                                  subject.visited * static_cast<double>(effort.law),
                                  [noise, grid, instances = effort.law](std::uint32_t seed) {
                                      return law_of(noise(), grid, instances, seed);
                                  }});
        }
    }
    return table;
}

Table pooled(const vulkan::Device& device, const Effort& effort) {
    Table table{"law", fmt::format("noise,samples,{}", law_columns), {}};
    for (const Subject& subject : subjects())
        table.rows.push_back({fmt::format("{},{}", subject.name, effort.samples),
                              subject.visited * static_cast<double>(effort.samples),
                              [noise = source(device, subject, {}), samples = effort.samples](
                                  std::uint32_t seed) { return law_of(noise(), {}, samples, seed); }});
    return table;
}

// The distributions of the sum and the difference of two values a given lag apart, at a random position,
// divided by their sample deviation, which depends on the lag.
Table pairs(const vulkan::Device& device, const Effort& effort) {
    constexpr double largest = 2; // largest standard deviation of the sum of two values with variance 1
    Table table{"law_pairs",
                "noise,lag,direction,pairs,correlation,cvm_sum,cvm_sum_low,cvm_sum_high,cvm_difference,"
                "cvm_difference_low,cvm_difference_high",
                {}};
    for (const Subject& subject : subjects()) {
        const Source noise = source(device, subject, {});
        for (int k = 1; k <= 10; ++k) {
            const double lag = 0.15 * k;
            const int degrees = 55 * k % 180;
            const double angle = degrees * std::numbers::pi / 180;
            const std::array shift{lag * std::cos(angle), lag * std::sin(angle)};
            table.rows.push_back(
                {fmt::format("{},{:g},{},{}", subject.name, lag, degrees, effort.law),
                 2 * subject.visited * static_cast<double>(effort.law),
                 [noise, shift, pairs = effort.law](std::uint32_t seed) {
                     const std::vector<float> here = draw(noise(), pairs, {}, seed);
                     const std::vector<float> there = draw(noise(), pairs, {.shift = shift}, seed);
                     std::vector<float> sums;
                     std::vector<float> differences;
                     for (std::size_t i = 0; i < here.size(); ++i) {
                         sums.push_back(here[i] + there[i]);
                         differences.push_back(here[i] - there[i]);
                     }
                     const ValueStatistics sum = statistics_of(sums, largest);
                     const ValueStatistics difference = statistics_of(differences, largest);
                     const double of_sum = sum.moments.variance();
                     const double of_difference = difference.moments.variance();
                     Numbers numbers{(of_sum - of_difference) / (of_sum + of_difference)};
                     append(numbers, sum.gaussianity.index(std::sqrt(of_sum) / largest));
                     append(numbers, difference.gaussianity.index(std::sqrt(of_difference) / largest));
                     return numbers;
                 }});
        }
    }
    return table;
}

// The covariance of two values a lag apart at each position in a cell, and its differences from the mean
// where the two are in different cells. A whole number of periods of the wave lies between the two values, so
// their covariance is that of the windows.
constexpr PlaneWave whole_turns{4, 0};

constexpr std::size_t place_count = side * side;

// Returns the mean product of two values at this lag, at each position in a cell.
std::array<double, place_count> covariances(Noise& noise, const std::array<double, 2>& lag,
                                            double cells_per_radius, std::uint64_t instances,
                                            std::uint32_t seed) {
    // A grid's positions are at the centres of squares; this undoes the offset.
    const double half = 0.5 / side / cells_per_radius;
    const Grid first{3, 1 / cells_per_radius, false, {-half, -half}};
    Grid second = first;
    second.shift = {lag[0] - half, lag[1] - half};
    const std::vector<float> here = draw(noise, instances, first, seed);
    const std::vector<float> there = draw(noise, instances, second, seed);
    std::array<double, place_count> means{};
    for (std::size_t i = 0; i < here.size(); ++i)
        means[i % place_count] += double{here[i]} * there[i] / static_cast<double>(instances);
    return means;
}

Numbers covariance_row(std::span<const double, place_count> covariances, const std::array<double, 2>& lag,
                       double cells_per_radius, std::uint64_t instances) {
    double mean = 0;
    for (const double value : covariances)
        mean += value / place_count;
    double squares = 0;
    double largest = 0;
    double crossing = 0;
    for (std::size_t place = 0; place < place_count; ++place) {
        const double x = static_cast<double>(place % side) / side + lag[0] * cells_per_radius;
        const double y = static_cast<double>(place / side) / side + lag[1] * cells_per_radius;
        if (x < 1 && y < 1)
            continue;
        const double difference = covariances[place] - mean;
        squares += difference * difference;
        largest = std::max(largest, std::abs(difference));
        ++crossing;
    }
    // The product of two normal variables has the variance 1 + correlation^2.
    const double chance = std::sqrt((1 + mean * mean) / static_cast<double>(instances));
    return {mean, std::sqrt(squares / crossing), chance, largest,
            chance * quantile(boost::math::normal(), 1 - 0.05 / (2 * crossing))};
}

Table stationary(const vulkan::Device& device, const Effort& effort) {
    Table table{
        "law_covariance", "noise,lag_x,lag_y,instances,covariance,rms,rms_chance,largest,largest_chance", {}};
    const std::uint64_t instances = effort.places / 2;
    // Covariance depends on position only for the lattice: random signs and phases have mean 0.
    std::vector<Numbers> theory;
    for (const Subject& subject : subjects()) {
        const Source noise = source(device, subject, whole_turns);
        const double radius = subject.cells_per_radius;
        for (const std::array<double, 2> lag : {std::array{0.25, 0.0},
                                                {0.5, 0.0},
                                                {0.75, 0.0},
                                                {1.0, 0.0},
                                                {1.25, 0.0},
                                                {1.5, 0.0},
                                                {1.75, 0.0},
                                                {0.5, 0.5},
                                                {1.0, 1.0}}) {
            const CovarianceOverCell expected =
                subject.taps > 0 ? lattice_covariance(subject.taps, lag, side) : CovarianceOverCell();
            theory.push_back({expected.rms, expected.largest});
            table.rows.push_back({fmt::format("{},{:g},{:g},{}", subject.name, lag[0], lag[1], instances),
                                  2.0 * side * side * subject.visited * static_cast<double>(instances),
                                  [noise, lag, radius, instances](std::uint32_t seed) {
                                      return covariance_row(
                                          covariances(noise(), lag, radius, instances, seed), lag, radius,
                                          instances);
                                  }});
        }
    }
    table.derived = "rms_theory,largest_theory";
    table.derive = [theory](std::vector<Numbers>& rows) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].insert(rows[i].end(), theory[i].begin(), theory[i].end());
    };
    return table;
}

// Peaks at the cells' frequencies in power spectra of independent instances.
Table spectra(const vulkan::Device& device, const Effort& effort) {
    constexpr std::uint64_t pictures = 12;
    Table table{"law_spectra", "noise,pictures,side,value,square,magnitude,fourth_power,beyond_2.5", {}};
    const int pixels = 1 << effort.picture_bits;
    for (const Subject& subject : subjects()) {
        const Grid grid{.bits = static_cast<unsigned>(effort.picture_bits),
                        .side = pixels / statistics::Lines::pixels_per_cell / subject.cells_per_radius,
                        .random = false};
        table.rows.push_back({fmt::format("{},{},{}", subject.name, pictures, pixels),
                              subject.visited * static_cast<double>(pictures) * pixels * pixels,
                              [noise = source(device, subject, {}), grid, pixels](std::uint32_t seed) {
                                  const std::vector<float> values = draw(noise(), pictures, grid, seed);
                                  statistics::NoiseLines lines(pixels);
                                  const auto width = static_cast<std::size_t>(pixels);
                                  for (std::size_t i = 0; i < values.size(); i += width)
                                      lines.add_row(std::span(values).subspan(i, width));
                                  const auto largest = lines.largest();
                                  return Numbers(largest.begin(), largest.end());
                              }});
    }
    return table;
}

} // namespace

Tables law(const vulkan::Device& device, const Effort& effort) {
    return {places(device, effort), pooled(device, effort), pairs(device, effort), stationary(device, effort),
            spectra(device, effort)};
}

// Writes a picture with one noise per column. Its rows show frequencies 1.5 and 4 over eight kernel radii,
// the same zoomed to two radii, and frequency 1.5 over 4095 cells, with one value per sixteen cells at a
// position that moves across the cell once.
void law_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder) {
    struct View {
        double frequency;
        double radii;
        double cells;
    };
    const unsigned bits = static_cast<unsigned>(effort.picture_bits) - 1;
    const std::size_t across = std::size_t{1} << bits;
    const std::size_t gap = across / 32;
    const std::array columns{"seminal", "advice", "one", "lattice_2", "lattice_3", "lattice_4"};
    const std::vector<Subject> all = subjects();
    const std::size_t width = columns.size() * (across + gap) - gap;
    std::vector<float> pixels;
    for (const View& view : {View{1.5, 8, 0}, {4, 8, 0}, {1.5, 2, 0}, {4, 2, 0}, {1.5, 0, 4095}}) {
        const std::size_t top = pixels.size() + (pixels.empty() ? 0 : gap * width);
        pixels.resize(top + across * width, 1);
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const Subject& subject = *std::ranges::find(all, columns[column], &Subject::name);
            Noise noise = subject.make(device, {view.frequency, 0.5});
            const Grid grid{bits, view.radii + view.cells / subject.cells_per_radius, false};
            const std::vector<float> values = draw(noise, 1, grid, 1);
            for (std::size_t i = 0; i < values.size(); ++i)
                pixels[top + i / across * width + column * (across + gap) + i % across] =
                    0.5f + 0.25f * values[i];
        }
    }
    image::PngWriter png(folder / "law_noises.png", static_cast<int>(width),
                         static_cast<int>(pixels.size() / width), 1);
    png.write_rows(pixels);
    png.commit();
}

} // namespace gabor::study
