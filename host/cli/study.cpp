#include "study/study.hpp"

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gabor::cli {

namespace {

struct StudyOptions {
    std::string name;
    std::string folder;
    std::string device;
    bool quick = false;
};

// Progress counts in whole numbers.
std::uint64_t units(double cost) {
    return static_cast<std::uint64_t>(std::ceil(cost / 1024));
}

void make_study(const StudyOptions& options) {
    std::vector<study::Study> chosen;
    if (options.name == "all")
        chosen.assign(study::studies().begin(), study::studies().end());
    else
        chosen.push_back(study::find_study(options.name));

    const std::filesystem::path folder = options.folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw RequestError(fmt::format("cannot make the folder '{}' ({}): -o takes a folder to write in",
                                       options.folder, error.message()));

    const vulkan::Device device(options.device);
    const study::Effort effort = options.quick ? study::Effort::quick() : study::Effort::full();
    study::Journal journal(folder, fmt::format("gabor {} study {}, on {}, {}", GABOR_VERSION,
                                               options.quick ? "quick" : "full", device.info().name,
                                               device.info().driver));
    std::vector<std::vector<study::Table>> tables;
    std::uint64_t total = 0;
    for (const study::Study& study : chosen) {
        tables.push_back(study.tables(device, effort));
        for (const study::Table& table : tables.back())
            for (const study::Row& row : table.rows)
                total += journal.find(table, row) ? 0 : units(row.cost);
    }

    note_interrupts();
    Progress progress("measuring", total);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        for (const study::Table& table : tables[i])
            study::write_table(table, folder, journal, [&](double cost) {
                progress.advance(units(cost));
                check_interrupt();
            });
        if (chosen[i].pictures)
            chosen[i].pictures(device, effort, folder);
        check_interrupt();
    }
    journal.remove();
}

} // namespace

void add_study_command(CLI::App& app) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* command =
        app.add_subcommand("study", "Measure the figures of [TNVT19], and what lies past them");
    std::string names;
    for (const study::Study& study : study::studies())
        names += fmt::format("{} ({}); ", study.name, study.description);
    command->add_option("NAME", options->name, fmt::format("Which: {}all", names))->type_name("")->required();
    command
        ->add_option("-o,--output", options->folder,
                     "The folder for its tables and pictures; a study that was interrupted goes on there")
        ->type_name("FOLDER")
        ->required();
    command->add_flag("--quick", options->quick, "Fewer samples: two minutes for all, without a GPU");
    command
        ->add_option("--device", options->device,
                     "Vulkan device: its index, or a part of its name [the fastest kind]")
        ->type_name("NAME");
    command->callback([options] { make_study(*options); });
}

} // namespace gabor::cli
