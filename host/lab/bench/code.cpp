#include "bench/bench.hpp"
#include "bench/subjects.hpp"
#include "render/output/renderer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace gabor::bench {

namespace {

using Statistics = std::map<std::string, std::uint64_t>;

double value(const Statistics& statistics, const char* name) {
    const auto found = statistics.find(name);
    return found == statistics.end() ? 0 : static_cast<double>(found->second);
}

Code unrolled(std::string name, const vulkan::Device& device, const vulkan::Pass& pass) {
    const Statistics statistics = pass.statistics(device);
    return {std::move(name), value(statistics, "Instructions"), value(statistics, "Inverse Throughput"),
            static_cast<int>(value(statistics, "VGPRs")), pass.seconds()};
}

// A block's code has a part before its rows and a part for each row. The cost of a row is that of two rows
// minus that of one.
Code baked(const vulkan::Device& device, const noise::Recipe& recipe) {
    render::Request request;
    request.recipe = recipe;
    const render::Plan plan =
        render::plan(request, render::viewport_of(request, {0, 0, 64, 64}), {}, render::DeviceKind::gpu);
    render::Step step = plan.steps.front();
    const auto pass = [&](std::uint32_t rows) {
        step.constants[passes::fixed_rows_id] = rows;
        return render::make_pass(device, plan, step, true);
    };
    const vulkan::Pass of_one = pass(1), of_two = pass(2);
    const Statistics one = of_one.statistics(device), two = of_two.statistics(device);
    const int columns = static_cast<int>(step.constants[passes::block_columns_id]);
    constexpr int rows = 16; // rows per block on GPUs
    const auto per_pixel = [&](const char* name) {
        const double first = value(one, name);
        return (first + (rows - 1) * (value(two, name) - first)) / (rows * columns);
    };
    return {fmt::format("bake, {}", recipe.name), per_pixel("Instructions"), per_pixel("Inverse Throughput"),
            static_cast<int>(value(two, "VGPRs")), of_two.seconds()};
}

// The compiler can only guess how often a loop runs. So this counts the code without the loop, and adds the
// cost of one iteration for each octave.
Code multiplied_out(const vulkan::Device& device, Subject subject) {
    subject.options.back() = 0;
    const Statistics none = make_pass(device, subject, Use::statistics).statistics(device);
    subject.options.back() = 1;
    const vulkan::Pass pass = make_pass(device, subject, Use::statistics);
    const Statistics one = pass.statistics(device);
    const auto total = [&](const char* name) {
        return value(none, name) + subject.octaves * (value(one, name) - value(none, name));
    };
    return {subject.name, total("Instructions"), total("Inverse Throughput"),
            static_cast<int>(value(one, "VGPRs")), pass.seconds()};
}

} // namespace

std::vector<Code> measure_code(const vulkan::Device& device) {
    std::vector<Code> codes;
    for (const Subject& subject : subjects()) {
        if (subject.has_loops)
            continue;
        codes.push_back(subject.octaves > 0
                            ? multiplied_out(device, subject)
                            : unrolled(subject.name, device, make_pass(device, subject, Use::statistics)));
    }
    for (const noise::Recipe& recipe : noise::recipes())
        codes.push_back(baked(device, recipe));
    return codes;
}

std::vector<Code> measure_code(const vulkan::Device& device, const std::vector<std::string>& files) {
    std::vector<Code> codes;
    for (const std::string& path : files) {
        std::ifstream file(path, std::ios::binary);
        std::vector<std::uint32_t> words(std::filesystem::file_size(path) / sizeof(std::uint32_t));
        file.read(reinterpret_cast<char*>(words.data()),
                  static_cast<std::streamsize>(words.size() * sizeof(std::uint32_t)));
        codes.push_back(unrolled(std::filesystem::path(path).stem().string(), device,
                                 {device, words, {.statistics = true}}));
    }
    return codes;
}

} // namespace gabor::bench
