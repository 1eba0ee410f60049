#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "render/plan/variance.hpp"
#include "render/request/parameters.hpp"
#include "statistics/picture.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace gabor::cli {

namespace {

using json = nlohmann::ordered_json;
using statistics::PictureReport;
using statistics::SpectrumSummary;

// gabor's own JSON has few levels. JSON deeper than this is ignored: writing it could overflow the stack.
constexpr int deepest_parameters = 16;

struct StatsOptions {
    std::vector<std::filesystem::path> files;
    std::optional<std::string> channel;
    std::optional<std::string> json;
};

struct Measured {
    int width = 0;
    int height = 0;
    std::string channel;
    json parameters = {};                         // null without a `gabor` attribute
    std::optional<double> scale = {};             // pixels per kernel radius
    std::optional<double> expected_variance = {}; // by theory, if the parameters determine it
    std::uint64_t outside = 0; // pixels excluded because the body does not cover them entirely
    PictureReport report = {};

    // Returns false for pictures of a body, because perspective distorts frequencies.
    bool has_spectrum() const { return report.spectrum && outside == 0; }
};

// Opens the picture. A single file may be any EXR; several must be regions of one picture.
image::ExrReader open_picture(const StatsOptions& options, const std::vector<std::string>& channels) {
    return options.files.size() == 1 ? image::ExrReader(options.files.front(), channels)
                                     : image::ExrReader(std::span(options.files), channels);
}

// Reads a channel. If there is a channel A, sets pixels with A below 1 to NaN and returns their number.
template <typename Use>
std::uint64_t read_bands(const StatsOptions& options, const image::ExrReader& of, Progress& progress,
                         Use use) {
    const std::string& channel = of.header().channels.front();
    const bool covered = channel != "A" && of.has_channel("A");
    image::ExrReader reader =
        open_picture(options, covered ? std::vector{channel, std::string("A")} : std::vector{channel});
    std::vector<float> inside;
    std::uint64_t outside = 0;
    reader.read_bands([&](std::span<const float> band) {
        if (covered) {
            inside.clear();
            for (std::size_t i = 0; i < band.size(); i += 2) {
                const bool out = band[i + 1] < 1;
                inside.push_back(out ? std::numeric_limits<float>::quiet_NaN() : band[i]);
                outside += out;
            }
            band = inside;
        }
        use(band);
        progress.advance(band.size());
    });
    return outside;
}

// Returns the theoretical variance of a channel for the parameters in the file's header.
std::optional<double> known_variance(const std::string& channel, const std::string& parameters) {
    try {
        return render::known_variance(render::from_json(parameters), channel);
    } catch (const RequestError&) {
        return {}; // the file was not written by gabor
    }
}

// Measures a channel. Unless theory says that the mean is 0, first reads the whole channel to find the mean.
Measured measure(const StatsOptions& options) {
    const std::string channel = options.channel
                                    ? *options.channel
                                    : image::ExrReader(options.files.front()).header().channels.front();
    const image::ExrReader reader = open_picture(options, {channel});
    const image::Rect& window = reader.header().window;
    Measured measured{.width = window.width, .height = window.height, .channel = channel};
    const std::string& attribute = reader.header().parameters;
    bool deep = false;
    json parsed = json::parse(
        attribute,
        [&](int depth, json::parse_event_t, json&) { return !(deep |= depth > deepest_parameters); }, false);
    if (!deep && !parsed.is_discarded())
        measured.parameters = std::move(parsed);
    if (measured.parameters.is_object())
        if (const json scale = measured.parameters.value("scale", json()); scale.is_number() && scale > 0)
            measured.scale = scale.get<double>();

    if (!deep)
        measured.expected_variance = known_variance(measured.channel, attribute);
    const bool known = measured.expected_variance.value_or(0) > 0;
    Progress progress("measuring", known ? window.pixels() : 2 * window.pixels());
    statistics::Moments moments;
    if (!known)
        read_bands(options, reader, progress, [&](auto band) { statistics::add_finite(moments, band); });
    statistics::PictureStatistics statistics(measured.width, measured.height, moments.mean());
    measured.outside = read_bands(options, reader, progress, [&](auto band) { statistics.add_rows(band); });
    measured.report = statistics.report();
    measured.report.not_finite -= measured.outside;
    return measured;
}

json to_json(const SpectrumSummary& spectrum, const std::optional<double>& scale) {
    json radial = json::array();
    for (std::size_t k = 0; k < spectrum.radial.size(); ++k)
        radial.push_back({static_cast<double>(k) * spectrum.radial_step, spectrum.radial[k]});
    const std::optional<statistics::SpectralPeak>& peak = spectrum.peak;
    return {{"power", spectrum.power},
            {"peak_frequency", peak ? json(peak->frequency) : json()},
            {"peak_orientation", peak ? json(peak->orientation) : json()},
            {"bandwidth", spectrum.bandwidth},
            {"resolution", spectrum.resolution},
            {"peak_frequency_per_radius", peak && scale ? json(peak->frequency * *scale) : json()},
            {"bandwidth_per_radius", scale ? json(spectrum.bandwidth * *scale) : json()},
            {"radial", std::move(radial)}};
}

// Writes NaN and infinity as null, and replaces invalid UTF-8, which a channel's name may contain.
std::string to_json(const Measured& measured) {
    const PictureReport& report = measured.report;
    const statistics::Moments& moments = report.moments;
    const json result = {
        {"width", measured.width},
        {"height", measured.height},
        {"channel", measured.channel},
        {"parameters", measured.parameters},
        {"pixels", moments.count()},
        {"not_finite", report.not_finite},
        {"outside", measured.outside},
        {"mean", moments.count() > 0 ? json(moments.mean()) : json()},
        {"variance", moments.variance()},
        {"expected_variance", measured.expected_variance ? json(*measured.expected_variance) : json()},
        {"skewness", moments.skewness()},
        {"excess_kurtosis", moments.excess_kurtosis()},
        {"minimum", moments.minimum()},
        {"maximum", moments.maximum()},
        {"spectrum", measured.has_spectrum() ? to_json(*report.spectrum, measured.scale) : json()},
    };
    return result.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

void print_line(const char* name, double value, const std::string& note = {}) {
    if (std::isnan(value))
        return fmt::print("  {:<18}{:>13}  all pixels are equal\n", name, "none");
    fmt::print("  {:<18}{:>13.6g}{}{}\n", name, value, note.empty() ? "" : "  ", note);
}

void print_spectrum(const SpectrumSummary& spectrum, const std::optional<double>& scale) {
    const auto per_radius = [&](double frequency) {
        return scale ? fmt::format(", {:.4g} per kernel radius", frequency * *scale) : "";
    };
    if (const std::optional<statistics::SpectralPeak>& peak = spectrum.peak) {
        print_line("peak frequency", peak->frequency, "cycles per pixel" + per_radius(peak->frequency));
        print_line("peak orientation", peak->orientation, "degrees clockwise from right");
    } else {
        fmt::print("  {:<18}{:>13}  indistinguishable from 0\n", "peak frequency", "none");
    }
    print_line("bandwidth", spectrum.bandwidth, "cycles per pixel" + per_radius(spectrum.bandwidth));
    print_line("resolution", spectrum.resolution, "cycles per pixel; narrower peaks look this wide");
    print_line("spectral power", spectrum.power, "the variance, computed from the spectrum");
}

void print_report(const StatsOptions& options, const Measured& measured) {
    const PictureReport& report = measured.report;
    const statistics::Moments& moments = report.moments;
    const std::string from = options.files.size() == 1 ? options.files.front().string()
                                                       : fmt::format("{} regions", options.files.size());
    fmt::print("{}: channel {}, {} x {} pixels, {} not finite{}\n", from, measured.channel, measured.width,
               measured.height, report.not_finite,
               measured.outside == 0
                   ? ""
                   : fmt::format(", {} excluded as outside the body (A below 1)", measured.outside));
    if (moments.count() == 0)
        return;
    print_line("mean", moments.mean());
    print_line("variance", moments.variance(),
               measured.expected_variance ? fmt::format("theory: {:.6g}", *measured.expected_variance) : "");
    print_line("skewness", moments.skewness());
    print_line("excess kurtosis", moments.excess_kurtosis());
    print_line("minimum", moments.minimum());
    print_line("maximum", moments.maximum());
    if (measured.has_spectrum() && report.spectrum->power > 0)
        print_spectrum(*report.spectrum, measured.scale);
    if (measured.outside > 0)
        fmt::print("  No spectrum: perspective distorts frequencies.\n");
    else if (!report.spectrum)
        fmt::print("  No spectrum: the picture is smaller than 16 x 16 pixels.\n");
}

void report_statistics(const StatsOptions& options) {
    namespace fs = std::filesystem;
    std::optional<image::OutputFile> output;
    std::error_code ignored;
    for (const fs::path& file : options.files)
        if (options.json && fs::equivalent(*options.json, file, ignored))
            throw RequestError(
                fmt::format("--json '{}' is the picture itself; give another file", *options.json));
    if (options.json && *options.json != "-")
        output.emplace(*options.json);

    system::note_interrupts();
    const Measured measured = measure(options);
    if (options.json == "-")
        fmt::print("{}", to_json(measured));
    else
        print_report(options, measured);
    if (output) {
        output->write(to_json(measured));
        output->commit();
    }
}

} // namespace

void add_stats_command(CLI::App& app) {
    auto options = std::make_shared<StatsOptions>();
    CLI::App* command = app.add_subcommand("stats", "Measure an OpenEXR picture: moments and spectrum");
    add_option(*command, "FILE", options->files, "",
               "The EXR to measure; regions of one picture are measured together")
        ->required();
    add_option(*command, "--channel", options->channel, "NAME",
               "The channel to measure [Y, else R, else the first]");
    add_option(*command, "--json", options->json, "FILE",
               "Also write the numbers to this file as JSON; '-' prints JSON instead of text");
    command->callback([options] { report_statistics(*options); });
}

} // namespace gabor::cli
