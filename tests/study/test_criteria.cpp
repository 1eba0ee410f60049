// Compares the study's numbers with theory or with the paper. An error of 2 % in the variance, or a doubled
// cvm, fails.

#include "study/figures.hpp"
#include "study/measures.hpp"
#include "study/variant.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

using namespace gabor;
using namespace gabor::study;

TEST_CASE("the variance is 1 with every ingredient", "[criteria]") {
    const vulkan::Device device;
    const auto check = [&](const Ingredients& it) {
        Noise noise(device, it);
        const ValueStatistics values = measure_values(single(noise), 1 << 19, 3);
        INFO(csv_fields(it) << ": variance " << values.moments.variance());
        CHECK(values.moments.variance() ==
              Approx(1).margin(0.0105)); // 3 standard errors at the largest kurtosis
        CHECK(values.moments.mean() == Approx(0).margin(0.006));
    };
    for (const Points points : all_points)
        for (const Weights weights : {Weights::uniform, Weights::bernoulli})
            check({.points = points, .weights = weights, .impulses = 7});
    for (const Kernel kernel : all_kernels)
        for (const Envelope envelope : all_envelopes)
            check({Points::stratified, Weights::bernoulli, kernel, envelope, 3, 0});
}

TEST_CASE("known noises have the expected Gaussianity", "[criteria]") {
    const vulkan::Device device;
    const auto check = [&](const Ingredients& it, std::uint64_t samples, double expected) {
        Noise noise(device, it);
        const statistics::Estimate cvm = measure_values(single(noise), samples, 5).gaussianity.index();
        INFO(csv_fields(it) << ": cvm " << cvm.value << " [" << cvm.low << ", " << cvm.high << "]");
        CHECK(cvm.low < expected);
        CHECK(cvm.high > expected);
        CHECK(cvm.high < 2 * expected);
        CHECK(cvm.low > expected / 2);
    };
    check({.impulses = 4}, 1 << 20, 39.3);
    check({.impulses = 10}, 1 << 20, 5.83);
    check({Points::stratified, Weights::bernoulli, Kernel::cosine, Envelope::gaussian, 1, 0}, 1 << 20, 7.7);
    check(recommended, 3 << 20, 0.45);
    check({Points::stratified, Weights::bernoulli, Kernel::sine, Envelope::gaussian, 2, 0}, 3 << 20, 0.45);
}

TEST_CASE("the predicted kurtosis agrees with samples", "[criteria]") {
    const vulkan::Device device;
    const Ingredients poisson{.impulses = 3};
    const Ingredients stratified{.points = Points::stratified, .impulses = 3};
    for (const auto& [it, expected] : {std::pair(poisson, poisson_kurtosis(poisson, {})),
                                       std::pair(stratified, stratified_kurtosis(stratified, {}))}) {
        Noise noise(device, it);
        INFO(csv_fields(it));
        CHECK(measure_values(single(noise), 1 << 20, 7).moments.excess_kurtosis() ==
              Approx(expected).margin(0.04));
    }
}

TEST_CASE("variants with the best floor have variance 1 and almost no excess kurtosis", "[criteria]") {
    const vulkan::Device device;
    for (const Window& window : {Window{"", Shape::separable, {3, -4.5, 2.5}},
                                 Window{"", Shape::radial, {1, 0, 0}}, Window{"", Shape::gaussian}})
        for (const Lattice lattice : {Lattice::square, Lattice::brick})
            for (const Magnitudes law : {Magnitudes::uniform, Magnitudes::two_point}) {
                Variant variant{window, 1, 1.25, lattice, law};
                variant.floor = best_floor(variant);
                Noise noise(device, variant);
                const ValueStatistics values = measure_values(single(noise), 1 << 18, 9);
                INFO(name(window.shape) << ", " << name(lattice) << ", " << name(law));
                CHECK(values.moments.variance() == Approx(1).margin(0.0105));
                CHECK(values.moments.excess_kurtosis() == Approx(0).margin(0.04));
            }
}

TEST_CASE("complex normal amplitudes on a grid give normal values", "[criteria]") {
    const vulkan::Device device;
    Noise noise(
        device,
        Variant{{"", Shape::separable, {1, -1, 1}}, 1, 1.5, Lattice::square, Magnitudes::rayleigh, 1, 0});
    const ValueStatistics values = measure_values(single(noise), 1 << 19, 4);
    CHECK(values.moments.variance() == Approx(1).margin(0.0105));
    CHECK(values.moments.excess_kurtosis() == Approx(0).margin(0.03));
}

TEST_CASE("the recommended noise has the expected contrast and stationarity", "[criteria]") {
    const vulkan::Device device;
    Noise noise(device, recommended);
    const statistics::InstanceStationarity windows = measure_windows(single(noise), 1 << 12, 1);
    CHECK(windows.contrast().interdecile == Approx(0.94).epsilon(0.06));
    CHECK(windows.median_deviation() == Approx(0.96).epsilon(0.02));
    const statistics::ProcessStationarity places = measure_places(single(noise), 1, 1 << 13, 1).stationarity;
    CHECK(places.variance().median == Approx(1).margin(0.01));
    CHECK(places.variance().interdecile < 1.3 * places.chance_interdecile());
    CHECK(places.largest_mean() < 1.3 * places.chance_largest_mean());
}

TEST_CASE("a repeating instance has mean 0 if its kernel is a sine", "[criteria]") {
    const vulkan::Device device;
    for (const Kernel kernel : {Kernel::sine, Kernel::cosine}) {
        Noise noise(device,
                    Ingredients{Points::stratified, Weights::bernoulli, kernel, Envelope::c1_separable, 2, 3},
                    PlaneWave{1});
        const std::vector<double> means = measure_means(single(noise), 3, 32, 1);
        const double largest = std::max(statistics::quantile(means, 1), -statistics::quantile(means, 0));
        if (kernel == Kernel::sine)
            CHECK(largest < 1e-5);
        else
            CHECK(largest > 1e-3);
    }
}

TEST_CASE("a row of each table has finite numbers, equal for equal seeds and different for other seeds",
          "[criteria]") {
    const vulkan::Device device;
    Effort effort = Effort::quick();
    effort.samples = 1 << 13;
    effort.windows = 1 << 5;
    effort.places = 1 << 7;
    effort.impulses = {2};
    effort.picture_bits = 6;
    effort.timings = 1;
    int tables = 0;
    for (const Study& study : studies())
        for (const Table& table : study.tables(device, effort)) {
            const auto row = std::ranges::find_if(table.rows, [](const Row& r) { return r.cost > 0; });
            if (row == table.rows.end())
                continue;
            ++tables;
            INFO(table.name << ": " << row->key);
            const Numbers numbers = row->measure(5);
            CHECK(std::ranges::count(table.columns, ',') + 1 ==
                  std::ranges::count(row->key, ',') + 1 + std::ssize(numbers));
            CHECK(std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }));
            if (table.columns.find("seconds") != std::string::npos)
                continue; // times differ on each run
            CHECK(row->measure(5) == numbers);
            CHECK(row->measure(6) != numbers);
        }
    CHECK(tables > 10);
}
