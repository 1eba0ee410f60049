// Spreads, lobes and the filter, on the device, against the double-precision reference.

#include "sampler.hpp"
#include "statistics/moments.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

using namespace gabor;
using test::Draw;
using test::Largest;

namespace {

constexpr float pi = 3.14159265f;

void set_lobe(test::SpectraSample& sample, std::size_t i, const std::array<float, 5>& lobe) {
    std::ranges::copy(lobe, sample.lobes + 5 * i);
}

// Three lobes of frequencies up to 8, spread or not; one in eight has no power.
void draw_lobes(test::SpectraSample& sample, Draw& draw) {
    for (std::size_t i = 0; i < 3; ++i)
        set_lobe(sample, i,
                 {draw.uniform(0.5, 8), draw.uniform(-8, 8), draw.word() % 2 ? draw.uniform(0, 0.5) : 0,
                  draw.word() % 2 ? draw.uniform(0, pi / 2) : 0, draw.word() % 8 ? draw.uniform(0, 3) : 0});
}

std::vector<noise::Lobe> all_lobes(const test::SpectraSample& sample) {
    return {sample.lobe(0), sample.lobe(1), sample.lobe(2)};
}

// The noise through a normal filter of half a pixel's standard deviation, by n x n samples over seven of
// them.
double supersampled(const noise::Reference& reference, const test::SpectraSample& sample, int n) {
    double sum = 0;
    double weights = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double u = 3.5 * ((i + 0.5) / n - 0.5);
            const double v = 3.5 * ((j + 0.5) / n - 0.5);
            const double weight = std::exp(-2 * (u * u + v * v));
            noise::Place place = sample.place;
            place.local_x += static_cast<float>((u * sample.dx[0] + v * sample.dy[0]) * place.radius_x);
            place.local_y += static_cast<float>((u * sample.dx[1] + v * sample.dy[1]) * place.radius_y);
            sum += weight * reference(place);
            weights += weight;
        }
    }
    return sum / weights;
}

} // namespace

TEST_CASE("spreads and lobes agree with the reference", "[oracle]") {
    const vulkan::Device device;
    Draw draw(11);
    constexpr std::size_t batch = 1 << 13;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::SpectraSampler sampler(device, recipe, batch);
        Largest value, slope, spread, chosen, sum;
        for (int round = 0; round < 16; ++round) {
            test::SpectraSample common{};
            common.seed = draw.word();
            draw_lobes(common, draw);
            for (test::SpectraSample& sample : sampler.samples()) {
                sample = common;
                sample.place = draw.place(recipe);
                test::move_to(sample, sample.place.local_x, sample.place.local_y);
                sample.place.time = draw.uniform(-1, 1);
            }
            const noise::Reference reference(recipe, all_lobes(common), common.seed);
            const noise::Reference first(recipe, {common.lobe(0)}, common.seed);
            std::vector<noise::Reference> independent;
            for (std::size_t i = 0; i < 3; ++i)
                independent.emplace_back(recipe, std::vector{common.lobe(i)},
                                         noise::lobe_seed(common.seed, static_cast<int>(i)));
            const double power = common.lobes[4] + common.lobes[9] + common.lobes[14];
            // Frequencies reach 12 and orientations a float's rounding.
            const double tight = 2 * test::tolerance(12);
            const auto answers = sampler.answers(batch);
            for (std::size_t i = 0; i < batch; ++i) {
                const test::SpectraSample& sample = sampler.samples()[i];
                const noise::Reference::Field field = reference.field(sample.place);
                value.see(answers[i].value[1], field.value.imag(), tight, sample);
                value.see(answers[i].value[0], field.value.real(), tight, sample);
                slope.see(answers[i].slope_x[1], field.slope_x.imag(), 2 * test::slope_tolerance(12), sample);
                slope.see(answers[i].slope_y[1], field.slope_y.imag(), 2 * test::slope_tolerance(12), sample);
                const noise::Place here = test::here(sample, recipe);
                spread.see(answers[i].spread, first(here), tight, sample);
                chosen.see(answers[i].chosen, reference(here), tight, sample);
                double expected = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    expected += std::sqrt(common.lobes[5 * k + 4] / power) * independent[k](here);
                sum.see(answers[i].sum, expected, tight, sample);
            }
        }
        fmt::print("{}, spectra; largest differences in units of the tolerance\n", recipe.name);
        value.check("gabor_field of lobes");
        slope.check("  its gradient");
        spread.check("gabor_noise_spread");
        chosen.check("gabor_noise_lobes");
        sum.check("gabor_noise_sum");
    }
}

TEST_CASE("mean 0 and variance 1 of every spectrum", "[instances]") {
    const vulkan::Device device;
    constexpr std::size_t batch = 1 << 19;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::SpectraSampler sampler(device, recipe, batch);
        Draw draw(12);
        statistics::Moments field, spread, chosen, sum;
        for (int round = 0; round < 8; ++round) {
            for (test::SpectraSample& sample : sampler.samples()) {
                sample = {noise::place_at(recipe, 0, 0, draw.uniform(0, 8), draw.uniform(0, 8)),
                          draw.word(),
                          {},
                          {},
                          {}};
                set_lobe(sample, 0, {4, 0.3f, 0.2f, pi / 2, 2});
                set_lobe(sample, 1, {0.3f, 1, 0, 0, 1});
                set_lobe(sample, 2, {6, 2, 0, 0.1f, 0.5f});
            }
            for (const test::SpectraAnswer& answer : sampler.answers(batch)) {
                field.add(answer.value[1]);
                spread.add(answer.spread);
                chosen.add(answer.chosen);
                sum.add(answer.sum);
            }
        }
        for (const statistics::Moments& moments : {field, spread, chosen, sum}) {
            INFO(recipe.name);
            CHECK(moments.mean() == Approx(0).margin(0.002)); // four standard errors
            CHECK(moments.variance() == Approx(1).margin(0.003));
        }
    }
}

TEST_CASE("the filtered noise is the noise through the filter", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t places = 96;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        Draw draw(13);
        test::SpectraSampler sampler(device, recipe, places);
        double worst = 0;
        double worst_lobes = 0;
        std::string where;
        for (int round = 0; round < 30; ++round) {
            test::SpectraSample common{};
            common.seed = draw.word();
            draw_lobes(common, draw);
            // Sides of up to a kernel radius, one in three of them a line.
            const float length = std::sqrt(draw.uniform(0, 1));
            const float width = round % 3 ? length * draw.uniform(0, 1) : 0;
            const float angle = draw.uniform(0, pi);
            common.dx[0] = length * std::cos(angle);
            common.dx[1] = length * std::sin(angle);
            common.dy[0] = -width * std::sin(angle);
            common.dy[1] = width * std::cos(angle);
            // Half of the waves run along the longer side, and are hardly filtered.
            common.lobes[0] = 0.2f * std::exp2(draw.uniform(0, 5));
            common.lobes[1] = round % 2 ? angle + pi / 2 + draw.uniform(-0.2, 0.2) : draw.uniform(0, pi);
            for (test::SpectraSample& sample : sampler.samples()) {
                sample = common;
                sample.place = noise::place_at(recipe, 0, 0, 0, 0);
                const float x = draw.uniform(0, 99);
                test::move_to(sample, x, draw.uniform(0, 99));
            }
            const noise::Reference single(recipe, common.lobes[0], common.lobes[1], common.seed);
            const noise::Reference lobes(recipe, all_lobes(common), common.seed);
            const auto answers = sampler.answers(places);
            const auto samples_for = [&](double frequency) { return frequency * length < 3 ? 16 : 48; };
            double squares = 0;
            double squares_lobes = 0;
            const double highest = 1.5 * std::max({common.lobes[0], common.lobes[5], common.lobes[10], 0.0f});
            for (std::size_t i = 0; i < places; ++i) {
                const test::SpectraSample& sample = sampler.samples()[i];
                if (i % 8 == 0)
                    squares_lobes += std::pow(
                        answers[i].value_filtered[1] - supersampled(lobes, sample, samples_for(highest)), 2);
                squares += std::pow(
                    answers[i].filtered[0] - supersampled(single, sample, samples_for(common.lobes[0])), 2);
            }
            const double error = std::sqrt(squares / places);
            const double error_lobes = std::sqrt(squares_lobes * 8 / places);
            worst_lobes = std::max(worst_lobes, error_lobes);
            if (error > worst) {
                worst = error;
                where = to_string(sampler.samples()[0]);
            }
        }
        fmt::print("{}: filtered, largest RMSE {:.4f} at {}; of lobes {:.4f}\n", recipe.name, worst, where,
                   worst_lobes);
        CHECK(worst < 0.02);
        CHECK(worst_lobes < 0.02);
    }
}

TEST_CASE("the filter says what variance it took", "[instances]") {
    const vulkan::Device device;
    constexpr std::size_t batch = 1 << 17;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::SpectraSampler sampler(device, recipe, batch);
        Draw draw(14);
        Largest single, lobes;
        for (int round = 0; round < 10; ++round) {
            test::SpectraSample common{};
            const float length = 2 * std::sqrt(draw.uniform(0, 1)); // also more than a kernel radius
            const float angle = draw.uniform(0, pi);
            common.dx[0] = length * std::cos(angle);
            common.dx[1] = length * std::sin(angle);
            common.dy[0] = -0.3f * common.dx[1];
            common.dy[1] = 0.3f * common.dx[0];
            set_lobe(common, 0, {1.5f + 2 * draw.uniform(0, 1), draw.uniform(0, pi), 0, 0, 1});
            set_lobe(common, 1, {draw.uniform(0.5, 4), 0, draw.uniform(0, 0.5), pi / 2, 1});
            set_lobe(common, 2, {2, 1, 0, draw.uniform(0, 1), draw.uniform(0, 1)});
            statistics::Moments of_single, of_lobes;
            for (test::SpectraSample& sample : sampler.samples()) {
                sample = common;
                sample.seed = draw.word();
                sample.place = noise::place_at(recipe, 0, 0, 0, 0);
                const float x = draw.uniform(0, 1);
                test::move_to(sample, x, draw.uniform(0, 1));
            }
            const auto answers = sampler.answers(batch);
            for (const test::SpectraAnswer& answer : answers) {
                of_single.add(answer.filtered[0]);
                of_lobes.add(answer.value_filtered[1]);
            }
            // 0.01 of the variance, and four standard errors of what is left of it.
            const auto margin = [&](double kept) {
                return 0.01 + 4 * kept * std::sqrt(2.0 / static_cast<double>(batch));
            };
            single.see(of_single.variance(), 1 - answers[0].filtered[1], margin(1 - answers[0].filtered[1]),
                       common);
            lobes.see(of_lobes.variance(), 1 - answers[0].removed, margin(1 - answers[0].removed), common);
        }
        fmt::print("{}, variance after the filter; largest differences in units of the tolerance\n",
                   recipe.name);
        single.check("gabor_noise_filtered");
        lobes.check("gabor_removed of lobes");
    }
}

TEST_CASE("footprints and lobes outside their range give no NaN", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t batch = 1 << 14;
    std::mt19937 random(15);
    const auto any = [&] {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        constexpr float edges[] = {0, -0.0f, 1e-45f, 1e-30f, 1, 1e3f, 1e30f, infinity, -infinity, NAN};
        return random() % 2 ? edges[random() % std::size(edges)]
                            : std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    };
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::SpectraSampler sampler(device, recipe, batch);
        for (test::SpectraSample& sample : sampler.samples()) {
            sample = {noise::place_at(recipe, 3, 4, 0.3f, 0.8f), 5, {any(), any()}, {any(), any()}, {}};
            std::ranges::generate(sample.lobes, any);
        }
        const auto answers = sampler.answers(batch);
        for (std::size_t i = 0; i < batch; ++i) {
            const test::SpectraAnswer& answer = answers[i];
            INFO(recipe.name << ": " << to_string(sampler.samples()[i]));
            bool finite = true;
            for (const float value :
                 {answer.value[0], answer.value[1], answer.value_filtered[0], answer.value_filtered[1],
                  answer.filtered[0], answer.spread, answer.chosen, answer.sum})
                finite &= std::isfinite(value);
            REQUIRE(finite);
            REQUIRE((answer.removed >= 0 && answer.removed <= 1));
            REQUIRE((answer.filtered[1] >= 0 && answer.filtered[1] <= 1));
        }
    }
}
