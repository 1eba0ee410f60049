#include "study/study.hpp"

#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "error.hpp"
#include "lab/cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gabor::lab {

namespace {

struct StudyOptions {
    std::string name;
    std::string folder;
    std::string device;
    bool quick = false;
};

// Converts a cost to a whole number for Progress.
std::uint64_t units(double cost) {
    return static_cast<std::uint64_t>(std::ceil(cost / 1024));
}

void measure(const StudyOptions& options) {
    const std::vector<study::Study> studies = study::find_studies(options.name);
    const std::filesystem::path folder = options.folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw RequestError(fmt::format("cannot create the folder '{}' ({}); -o takes a folder to write to",
                                       options.folder, error.message()));
    const vulkan::Device device(options.device);
    const study::Effort effort = options.quick ? study::Effort::quick() : study::Effort::full();
    const std::string conditions = nlohmann::ordered_json{{"version", GABOR_VERSION},
                                                          {"device", device.info().name},
                                                          {"driver", device.info().driver},
                                                          {"quick", options.quick}}
                                       .dump(2) +
                                   "\n";
    system::note_interrupts();

    std::vector<study::Table> tables;
    for (const study::Study& study : studies)
        for (study::Table& table : study.tables(device, effort))
            if (!study::is_finished(table, folder, conditions))
                tables.push_back(std::move(table));
    cli::Progress progress("measuring", units(study::cost(tables)));
    study::MeasuredRows measured;
    for (const study::Table& table : tables)
        study::write_table(table, folder, conditions, measured,
                           [&](double cost) { progress.advance(units(cost)); });
    for (const study::Study& study : studies)
        if (study.pictures) {
            cli::check_interrupt();
            study.pictures(device, effort, folder);
        }
    fmt::print("{}: measured on {}; tools/plot {} draws the tables\n", options.folder, device.info().name,
               options.folder);
}

} // namespace

void add_study_command(CLI::App& app) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* command = app.add_subcommand("study", "Reproduce and extend the paper's figures");
    std::string names;
    for (const study::Study& study : study::studies())
        names += fmt::format("{} ({}); ", study.name, study.description);
    command->add_option("NAME", options->name, fmt::format("Study: {}all", names))->type_name("")->required();
    command
        ->add_option(
            "-o,--output", options->folder,
            "Folder for tables and pictures; finished tables of this version, device and driver are kept")
        ->type_name("FOLDER")
        ->required();
    command->add_flag("--quick", options->quick,
                      "Use fewer samples: all studies take two minutes without a GPU, but points of high "
                      "quality are missing");
    cli::add_device_option(*command, options->device);
    command->callback([options] { measure(*options); });
}

} // namespace gabor::lab
