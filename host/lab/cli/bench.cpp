#include "bench/bench.hpp"
#include "bench/subjects.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "image/output_file.hpp"
#include "lab/cli/commands.hpp"
#include "render/output/renderer.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gabor::lab {

namespace {

using nlohmann::ordered_json;

struct BenchOptions {
    std::string device;
    std::optional<std::string> json;
    bool quick = false;
    bool isa = false;
    std::vector<std::string> files;
};

const bench::Row& find(const std::vector<bench::Row>& rows, std::string_view name) {
    return *std::ranges::find(rows, name, &bench::Row::name);
}

void print_base(const std::vector<bench::Row>& rows) {
    const double seminal = find(rows, bench::seminal_yardstick).seconds.median;
    const double advice = find(rows, bench::advice_yardstick).seconds.median;
    const double perlin = find(rows, bench::perlin_yardstick).seconds.median;
    const bench::Row& first = rows.front();
    fmt::print("{0} x {0} pixels, {1} pixels per kernel radius, frequency {2}\n", first.side, first.scale,
               first.frequency);
    fmt::print("{:<40}{:>8}{:>10}{:>23}{:>10}{:>9}{:>10}{:>10}  {}\n", "", "visited", "ns/pixel", "quartiles",
               "seminal/", "advice/", "/Perlin", "pipeline", "cvm");
    for (const bench::Row& row : rows) {
        const double to_nanoseconds = 1e9 / row.side / row.side;
        const std::string cvm =
            row.cvm ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", row.cvm->value, row.cvm->low, row.cvm->high)
                    : "";
        fmt::print("{:<40}{:>8}{:>10.4f}{:>23}{:>10.1f}{:>9.2f}{:>10.2f}{:>7.1f} ms  {}\n", row.name,
                   row.visited > 0 ? fmt::format("{:.0f}", row.visited) : "", row.nanoseconds_per_pixel(),
                   fmt::format("{:.4f} to {:.4f}", row.seconds.lower * to_nanoseconds,
                               row.seconds.upper * to_nanoseconds),
                   seminal / row.seconds.median, advice / row.seconds.median, row.seconds.median / perlin,
                   row.pipeline * 1e3, cvm);
    }
}

// Prints a row as in docs/benchmark.html: milliseconds per megapixel.
void print_row(const vulkan::Device& device, const std::vector<bench::Row>& rows) {
    fmt::print("\n| device | API | gabor_noise | 2 taps | Perlin | simplex | advice | seminal |\n"
               "| --- | --- | --- | --- | --- | --- | --- | --- |\n| {} | Vulkan |",
               device.info().name);
    for (const std::string_view name :
         {std::string_view("gabor_noise, lattice"), std::string_view("gabor_noise, lattice-2"),
          bench::perlin_yardstick, bench::simplex_yardstick, bench::advice_yardstick,
          bench::seminal_yardstick})
        fmt::print(" {:.3g} |", find(rows, name).nanoseconds_per_pixel());
    fmt::print("\n");
}

void print_trends(const std::vector<bench::Row>& rows) {
    fmt::print("\n{:<22}{:>8}{:>8}{:>11}{:>10}{:>19}\n", "", "side", "scale", "frequency", "ns/pixel",
               "quartiles");
    for (const bench::Row& row : rows) {
        const double to_nanoseconds = 1e9 / row.side / row.side;
        fmt::print("{:<22}{:>8}{:>8}{:>11}{:>10.4f}{:>19}\n", row.name, row.side, row.scale, row.frequency,
                   row.nanoseconds_per_pixel(),
                   fmt::format("{:.4f} to {:.4f}", row.seconds.lower * to_nanoseconds,
                               row.seconds.upper * to_nanoseconds));
    }
}

ordered_json to_json(const std::vector<bench::Row>& rows) {
    ordered_json result = ordered_json::array();
    for (const bench::Row& row : rows) {
        ordered_json cvm;
        if (row.cvm)
            cvm = {{"value", row.cvm->value}, {"low", row.cvm->low}, {"high", row.cvm->high}};
        result.push_back({{"name", row.name},
                          {"visited", row.visited},
                          {"side", row.side},
                          {"scale", row.scale},
                          {"frequency", row.frequency},
                          {"seconds", row.seconds.median},
                          {"seconds_low", row.seconds.lower},
                          {"seconds_high", row.seconds.upper},
                          {"ns_per_pixel", row.nanoseconds_per_pixel()},
                          {"pipeline_seconds", row.pipeline},
                          {"cvm", cvm}});
    }
    return result;
}

void print_device(const vulkan::Device& device) {
    fmt::print("{}, {}\n", device.info().name, device.info().driver);
}

ordered_json time_all(const vulkan::Device& device, bool quick) {
    bench::Effort effort;
    if (quick)
        effort = {3, 256, 1};
    else if (render::kind_of(device) == render::DeviceKind::gpu)
        effort.side = 4096; // 1024 x 1024 pixels take only microseconds
    std::optional<cli::Progress> progress(std::in_place, "measuring",
                                          static_cast<std::uint64_t>(bench::steps(effort)));
    const bench::Report report = bench::run(device, effort, [&] { progress->advance(1); });
    progress.reset();
    print_device(device);
    print_base(report.base);
    print_trends(report.trends);
    print_row(device, report.base);
    fmt::print("\npeak resident memory: {} MiB\n", system::peak_memory() >> 20);
    return {{"base", to_json(report.base)},
            {"trends", to_json(report.trends)},
            {"peak_memory", system::peak_memory()}};
}

ordered_json count_code(const vulkan::Device& device, const std::vector<std::string>& files) {
    const std::vector<bench::Code> codes =
        files.empty() ? bench::measure_code(device) : bench::measure_code(device, files);
    print_device(device);
    ordered_json result = ordered_json::array();
    fmt::print("{:<38}{:>14}{:>12}{:>12}{:>12}\n", "per pixel", "instructions", "cycles", "registers",
               "to compile");
    for (const bench::Code& code : codes) {
        fmt::print("{:<38}{:>14.1f}{:>12.1f}{:>12}{:>10.2f} s\n", code.name, code.instructions,
                   code.throughput, code.registers, code.seconds);
        result.push_back({{"name", code.name},
                          {"instructions", code.instructions},
                          {"inverse_throughput", code.throughput},
                          {"registers", code.registers},
                          {"pipeline_seconds", code.seconds}});
    }
    return {{"code", result}};
}

void run_bench(const BenchOptions& options) {
    std::optional<image::OutputFile> file;
    if (options.json)
        file.emplace(*options.json);
    const vulkan::Device device(options.device);
    system::note_interrupts();
    ordered_json json{{"device", device.info().name}, {"driver", device.info().driver}};
    json.update(options.isa ? count_code(device, options.files) : time_all(device, options.quick));
    if (file) {
        file->write(json.dump(2) + "\n");
        file->commit();
    }
}

} // namespace

void add_bench_command(CLI::App& app) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* command =
        app.add_subcommand("bench", "Time all noises by a GPU's clock or by CPU time, and compare them");
    command->add_option("--json", options->json, "Also write all figures to this file")->type_name("FILE");
    cli::add_device_option(*command, options->device);
    command->add_flag("--quick", options->quick,
                      "Use few repetitions and a small picture, to check that everything runs");
    CLI::Option* isa = command->add_flag(
        "--isa", options->isa,
        "Report the compiler's statistics instead of times. Needs RADV but no GPU: see tools/isa");
    command->add_option("files", options->files, "SPIR-V files to report on instead of the noises")
        ->type_name("FILE")
        ->check(CLI::Validator(CLI::ExistingFile).description(""))
        ->needs(isa);
    command->callback([options] { run_bench(*options); });
}

} // namespace gabor::lab
