#include "study/study.hpp"

#include "cli/terminal.hpp"
#include "error.hpp"
#include "lab/cli/commands.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gabor::lab {

using cli::check_interrupt;
using cli::note_interrupts;
using cli::Progress;

namespace {

using nlohmann::json;

constexpr int most_parts = 9999;

struct StudyOptions {
    std::string name;
    std::string folder;
    std::string device;
    std::optional<std::string> part;
    bool quick = false;
};

// Progress counts in whole numbers.
std::uint64_t units(double cost) {
    return static_cast<std::uint64_t>(std::ceil(cost / 1024));
}

study::Part parse_part(const std::string& text) {
    study::Part part;
    const char* end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, part.index);
    const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
    const auto count = slash ? std::from_chars(index.ptr + 1, end, part.count) : index;
    if (!slash || count.ec != std::errc() || count.ptr != end || part.index < 1 || part.index > part.count ||
        part.count > most_parts)
        throw RequestError(
            fmt::format("--part '{}': it takes K/N, the K-th of N parts, of at most {}", text, most_parts));
    return part;
}

// All tables of the studies, in their order.
std::vector<study::Table> tables_of(const std::vector<study::Study>& studies, const vulkan::Device& device,
                                    const study::Effort& effort) {
    std::vector<study::Table> tables;
    for (const study::Study& study : studies)
        std::ranges::move(study.tables(device, effort), std::back_inserter(tables));
    return tables;
}

void make_pictures(const std::vector<study::Study>& studies, const vulkan::Device& device,
                   const study::Effort& effort, const std::filesystem::path& folder) {
    for (const study::Study& study : studies) {
        check_interrupt();
        if (study.pictures)
            study.pictures(device, effort, folder);
    }
}

study::Effort effort_of(bool quick) {
    return quick ? study::Effort::quick() : study::Effort::full();
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw RequestError(fmt::format("cannot make the folder '{}' ({}): -o takes a folder to write in",
                                       folder, error.message()));
}

void make_study(const StudyOptions& options) {
    const std::vector<study::Study> studies = study::find_studies(options.name);
    const std::optional<study::Part> part =
        options.part ? std::optional(parse_part(*options.part)) : std::nullopt;
    const std::filesystem::path folder = options.folder;
    make_folder(options.folder);
    const vulkan::Device device(options.device);
    const study::Effort effort = effort_of(options.quick);
    note_interrupts();

    if (part) {
        const json study = {{"version", GABOR_VERSION},      {"study", options.name},
                            {"quick", options.quick},        {"part", part->index},
                            {"parts", part->count},          {"device", device.info().name},
                            {"driver", device.info().driver}};
        const std::string name = fmt::format("study.{}-of-{}", part->index, part->count);
        if (const auto before = study::read_record(folder / (name + ".rows"));
            before && before->study == study.dump())
            return; // it is complete
        study::Journal journal(folder, study.dump(), name);
        const std::vector<study::Table> tables = tables_of(studies, device, effort);
        Progress progress("measuring", units(study::cost_of_part(tables, *part, journal)));
        study::measure_part(tables, *part, journal, [&](double cost) {
            progress.advance(units(cost));
            check_interrupt();
        });
        if (part->index == 1)
            make_pictures(studies, device, effort, folder);
        journal.complete();
        return;
    }

    study::Journal journal(folder, fmt::format("gabor {} study {}, on {}, {}", GABOR_VERSION,
                                               options.quick ? "quick" : "full", device.info().name,
                                               device.info().driver));
    const std::vector<study::Table> tables = tables_of(studies, device, effort);
    Progress progress("measuring", units(study::cost_of_part(tables, {}, journal)));
    for (const study::Table& table : tables)
        study::write_table(table, folder, journal, [&](double cost) {
            progress.advance(units(cost));
            check_interrupt();
        });
    make_pictures(studies, device, effort, folder);
    journal.remove();
}

struct MergeOptions {
    std::vector<std::string> parts;
    std::string folder;
    std::string device;
};

[[noreturn]] void refuse_merge(std::string_view what) {
    throw RequestError(fmt::format("cannot merge: {}", what));
}

// The parts of one study, all and each once.
study::Record merged(const std::vector<std::string>& paths) {
    constexpr std::string_view accepted = "accepted are the files study.K-of-N.rows of one study";
    study::Record all;
    std::map<int, std::string> found;
    for (const std::string& path : paths) {
        std::optional<study::Record> record = study::read_record(path);
        json study = json::parse(record ? record->study : "", nullptr, false);
        if (!path.ends_with(".rows") || !study.is_object() ||
            !study.value("part", json()).is_number_integer())
            refuse_merge(fmt::format("'{}' is no complete part of a study; {}", path, accepted));
        const int part = study["part"];
        study.erase("part");
        if (all.study.empty())
            all.study = study.dump();
        if (study.dump() != all.study)
            refuse_merge(fmt::format("'{}' is of {}, '{}' of {}; {}", path, study.dump(), paths.front(),
                                     all.study, accepted));
        if (const auto [other, added] = found.emplace(part, path); !added)
            refuse_merge(fmt::format("'{}' and '{}' are the same part; {}", other->second, path, accepted));
        all.rows.merge(record->rows);
    }
    const int count = json::parse(all.study)["parts"];
    for (int part = 1; part <= count; ++part)
        if (!found.contains(part))
            refuse_merge(fmt::format("part {} of {} is missing; {}", part, count, accepted));
    return all;
}

void merge(const MergeOptions& options) {
    study::Record record = merged(options.parts);
    const json study = json::parse(record.study);
    if (study["version"] != GABOR_VERSION)
        refuse_merge(fmt::format("the parts are of version {}, and this is {}",
                                 study["version"].get<std::string>(), GABOR_VERSION));
    make_folder(options.folder);
    const vulkan::Device device(options.device);
    const std::vector<study::Table> tables =
        tables_of(study::find_studies(study["study"].get<std::string>()), device, effort_of(study["quick"]));
    study::Journal journal(std::move(record.rows));
    if (const std::string missing = study::missing_row(tables, journal); !missing.empty())
        refuse_merge(fmt::format("no part has the row {}", missing));
    for (const study::Table& table : tables)
        study::write_table(table, options.folder, journal, [](double) {});
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
    command
        ->add_option("--part", options->part,
                     "K/N: only the K-th of N parts, into study.K-of-N.rows, for `gabor-lab merge`")
        ->type_name("K/N");
    command->callback([options] { make_study(*options); });
}

void add_merge_command(CLI::App& app) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command =
        app.add_subcommand("merge", "Make of a study's parts the tables that one run would have made");
    command->add_option("PART", options->parts, "All files study.K-of-N.rows of `gabor-lab study --part`")
        ->type_name("FILE")
        ->required();
    command->add_option("-o,--output", options->folder, "The folder for its tables")
        ->type_name("FOLDER")
        ->required();
    command
        ->add_option("--device", options->device,
                     "Vulkan device that lists the rows; it measures none [the fastest kind]")
        ->type_name("NAME");
    command->callback([options] { merge(*options); });
}

} // namespace gabor::lab
