#include "bench/bench.hpp"

#include "bench/subjects.hpp"
#include "error.hpp"
#include "render/output/renderer.hpp"
#include "seconds.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/quantile.hpp"
#include "system/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

namespace gabor::bench {

namespace {

constexpr int sample_side = 1024;

// A noise that fills a picture, ready to be timed repeatedly.
struct Measurement {
    Row row;
    const noise::Recipe* baked = nullptr; // the recipe, if this is a bake
    std::function<double()> run;
    std::vector<double> seconds;
};

using Measurements = std::vector<Measurement>;

template <typename Make>
auto timed(double& seconds, Make make) {
    const Clock::time_point start = Clock::now();
    auto made = make();
    seconds = seconds_since(start);
    return made;
}

Measurement per_pixel(const vulkan::Device& device, const Subject& subject, const Setting& setting,
                      const vulkan::Buffer& picture) {
    Measurement measurement;
    measurement.row = {
        subject.name, subject.visited, setting.side, setting.scale, setting.frequency, {}, 0, {}};
    const auto pass = timed(measurement.row.pipeline, [&] {
        return std::make_shared<vulkan::Pass>(make_pass(device, subject, Use::timing));
    });
    vulkan::Job::Buffers buffers{picture};
    std::shared_ptr<vulkan::Buffer> table;
    if (!subject.table.empty()) {
        table = std::make_shared<vulkan::Buffer>(render::upload(device, subject.table));
        buffers.push_back(*table);
    }
    const auto job = std::make_shared<vulkan::Job>(device, *pass, buffers);
    measurement.run = [pass, job, table, setting] {
        submit(*job, {setting.side / timed_side, setting.scale, setting.frequency}, 7);
        return job->wait();
    };
    return measurement;
}

Measurement bake(const vulkan::Device& device, const noise::Recipe& recipe, const Setting& setting,
                 const vulkan::Buffer& picture) {
    Measurement measurement;
    measurement.row = {fmt::format("bake, {}", recipe.name),
                       static_cast<double>(noise::visited_impulses(recipe)),
                       setting.side,
                       setting.scale,
                       setting.frequency,
                       {},
                       0,
                       {}};
    measurement.baked = &recipe;
    const render::Request wanted{.width = setting.side,
                                 .height = setting.side,
                                 .scale = setting.scale,
                                 .recipe = recipe,
                                 .lobes = {{.frequency = setting.frequency, .orientation = base_orientation}},
                                 .seed = 7};
    const auto renderer = timed(measurement.row.pipeline, [&] {
        const render::Viewport whole = render::viewport_of(wanted, {0, 0, setting.side, setting.side});
        return std::make_shared<render::Renderer>(device,
                                                  render::plan(wanted, whole, {}, render::kind_of(device)));
    });
    const auto job = std::make_shared<vulkan::Job>(renderer->job(picture));
    measurement.run = [renderer, job, rows = setting.side] {
        renderer->submit(*job, {0, rows});
        return job->wait();
    };
    return measurement;
}

// The CPU time of a run, shared by all cores: on a CPU, other work does not count.
double cpu_seconds(const std::function<double()>& run) {
    const double start = system::cpu_seconds();
    run();
    return (system::cpu_seconds() - start) / std::thread::hardware_concurrency();
}

// Interleaves the noises, so that other load on the machine affects all alike. An idle GPU takes a while to
// reach its full clock rate.
void interleave(Measurements& measurements, int repetitions, render::DeviceKind kind,
                const std::function<void()>& step) {
    for (const Clock::time_point start = Clock::now(); seconds_since(start) < 0.5;)
        measurements.back().run();
    for (int round = -1; round < repetitions; ++round) {
        for (Measurement& measurement : measurements) {
            const double seconds =
                kind == render::DeviceKind::cpu ? cpu_seconds(measurement.run) : measurement.run();
            if (round >= 0)
                measurement.seconds.push_back(seconds);
            step();
        }
    }
    for (Measurement& measurement : measurements) {
        const auto quantile = [&](double share) { return statistics::quantile(measurement.seconds, share); };
        measurement.row.seconds = {quantile(0.5), quantile(0.25), quantile(0.75)};
    }
}

std::vector<Row> rows(const Measurements& measurements) {
    std::vector<Row> result;
    std::ranges::transform(measurements, std::back_inserter(result), &Measurement::row);
    return result;
}

statistics::Estimate measure_cvm(const vulkan::Device& device, const Subject& subject,
                                 const vulkan::Buffer& values, int batches,
                                 const std::function<void()>& step) {
    const vulkan::Pass pass = make_pass(device, subject, Use::samples);
    vulkan::Job job(device, pass, {values});
    statistics::Gaussianity gaussianity;
    for (int batch = 0; batch < batches; ++batch) {
        submit(job, {sample_side, base_setting.scale, base_setting.frequency},
               0x51ed270bu * static_cast<std::uint32_t>(batch + 1));
        job.wait();
        gaussianity.add(values.as<float>());
        step();
    }
    return gaussianity.index();
}

std::vector<Setting> trend_settings(int side) {
    const auto [_, scale, frequency] = base_setting;
    return {
        {side / 2, scale, frequency}, {side * 2, scale, frequency}, {side, 4, 1},       {side, 8, frequency},
        {side, 128, frequency},       {side, 1024, frequency},      {side, scale, 0.5}, {side, scale, 12}};
}

} // namespace

int steps(const Effort& effort) {
    const auto all = subjects();
    const auto recipes = static_cast<int>(noise::recipes().size());
    const auto noises = static_cast<int>(std::ranges::count_if(all, &Subject::measure_cvm));
    return (effort.repetitions + 1) * (static_cast<int>(all.size()) + recipes +
                                       2 * static_cast<int>(trend_settings(effort.side).size())) +
           noises * effort.sample_batches;
}

Report run(const vulkan::Device& device, const Effort& effort, const std::function<void()>& step) {
    if (!device.info().timestamps)
        throw RequestError(
            fmt::format("{} has no timestamps, which the benchmark needs", device.info().name));
    const vulkan::Memory memory = device.unified() ? vulkan::Memory::readback : vulkan::Memory::device;
    const auto bytes = [](int side) {
        return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4;
    };
    const vulkan::Buffer picture(device, bytes(2 * effort.side), memory);
    const std::vector<Subject> all = subjects();

    Measurements measurements;
    const Setting base{effort.side, base_setting.scale, base_setting.frequency};
    for (const Subject& subject : all)
        measurements.push_back(per_pixel(device, subject, base, picture));
    for (const noise::Recipe& recipe : noise::recipes())
        measurements.push_back(bake(device, recipe, base, picture));
    const render::DeviceKind kind = render::kind_of(device);
    interleave(measurements, effort.repetitions, kind, step);

    const vulkan::Buffer values(device, bytes(sample_side), vulkan::Memory::readback);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].measure_cvm)
            continue;
        const statistics::Estimate cvm = measure_cvm(device, all[i], values, effort.sample_batches, step);
        measurements[i].row.cvm = cvm;
        for (Measurement& other : measurements) // a bake's values differ from its recipe's by at most 5e-5
            if (other.baked && other.baked == all[i].recipe)
                other.row.cvm = cvm;
    }
    Report report{rows(measurements), {}};

    const noise::Recipe& recipe = noise::recipes().front();
    const auto subject = std::ranges::find(all, &recipe, &Subject::recipe);
    Measurements trends;
    for (const Setting& setting : trend_settings(effort.side)) {
        trends.push_back(per_pixel(device, *subject, setting, picture));
        trends.push_back(bake(device, recipe, setting, picture));
    }
    interleave(trends, effort.repetitions, kind, step);
    report.trends = rows(trends);
    return report;
}

} // namespace gabor::bench
