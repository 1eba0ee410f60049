#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "render/parameters.hpp"
#include "statistics/picture.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace gabor::cli {

namespace {

using nlohmann::json;
using statistics::BlockEstimates;
using statistics::Estimate;
using statistics::PictureReport;
using statistics::SpectrumSummary;

// The smallest cvm at which a deviation from the normal distribution is visible.
constexpr double visible_cvm = 0.5;

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
    json parameters = {};             // null without a `gabor` attribute
    std::optional<double> scale = {}; // pixels per kernel radius
    statistics::NormalDistribution expected = {};
    std::uint64_t outside = 0; // pixels excluded because the body does not cover them entirely
    PictureReport report = {};

    const char* reference() const { return expected.fitted ? "measured" : "analytic"; }
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

// The theoretical variance of a channel, according to the parameters in the file's header.
std::optional<double> known_variance(const std::string& channel, const std::string& parameters) {
    try {
        return render::known_variance(render::from_json(parameters), channel);
    } catch (const RequestError&) {
        return {}; // the file was not written by gabor
    }
}

// Measures a channel. If its variance is unknown, first reads the whole channel for its mean and variance.
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

    const std::optional<double> variance = deep ? std::nullopt : known_variance(measured.channel, attribute);
    Progress progress("measuring", variance ? window.pixels() : 2 * window.pixels());
    if (variance && *variance > 0) {
        measured.expected = {0, std::sqrt(*variance), false};
    } else {
        statistics::Moments moments;
        read_bands(options, reader, progress, [&](auto band) { statistics::add_finite(moments, band); });
        measured.expected = statistics::fitted_normal(moments);
    }
    statistics::PictureStatistics statistics(measured.width, measured.height, measured.expected);
    measured.outside = read_bands(options, reader, progress, [&](auto band) { statistics.add_rows(band); });
    measured.report = statistics.report();
    measured.report.not_finite -= measured.outside;
    return measured;
}

json interval(const Estimate& estimate) {
    return {{"low", estimate.low}, {"high", estimate.high}};
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
            {"correlation_length", spectrum.correlation},
            {"radial", std::move(radial)}};
}

// Writes NaN and infinity as null, and replaces invalid UTF-8, which a channel's name may contain.
std::string to_json(const Measured& measured) {
    const PictureReport& report = measured.report;
    const statistics::Moments& moments = report.moments;
    const auto& blocks = report.blocks;
    json cvm = blocks ? interval(blocks->cvm) : json();
    if (blocks)
        cvm["value"] = blocks->cvm.value;
    const json result = {
        {"width", measured.width},
        {"height", measured.height},
        {"channel", measured.channel},
        {"parameters", measured.parameters},
        {"pixels", moments.count()},
        {"not_finite", report.not_finite},
        {"outside", measured.outside},
        {"mean", moments.count() > 0 ? json(moments.mean()) : json()},
        {"mean_interval", blocks ? interval(blocks->mean) : json()},
        {"variance", moments.variance()},
        {"variance_interval", blocks ? interval(blocks->variance) : json()},
        {"skewness", moments.skewness()},
        {"excess_kurtosis", moments.excess_kurtosis()},
        {"minimum", moments.minimum()},
        {"maximum", moments.maximum()},
        {"cvm", cvm},
        {"cvm_reference", measured.reference()},
        {"reference_mean", measured.expected.mean},
        {"reference_variance", measured.expected.variance()},
        {"smallest_cvm", blocks ? json(blocks->smallest_cvm) : json()},
        {"blocks_per_side", blocks ? json(blocks->blocks_per_side) : json()},
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

// Returns false for small pictures, in which chance can hide a visible deviation.
bool has_cvm(const std::optional<BlockEstimates>& blocks) {
    return blocks && !(blocks->smallest_cvm > visible_cvm && blocks->cvm.low < visible_cvm);
}

// Returns the side, a power of two, of the smallest square picture in which a visible cvm exceeds chance. The
// largest cvm that chance explains is inversely proportional to the number of pixels.
double side_for_cvm(const Measured& measured, const BlockEstimates& blocks) {
    const double pixels = static_cast<double>(measured.report.moments.count());
    const double needed = std::sqrt(pixels * blocks.smallest_cvm / visible_cvm);
    return std::exp2(std::ceil(std::log2(needed)));
}

void print_limits(const Measured& measured) {
    const PictureReport& report = measured.report;
    const auto& blocks = report.blocks;
    if (report.moments.variance() == 0) {
        fmt::print("  No intervals and no cvm: all pixels are equal.\n");
    } else if (!report.spectrum) {
        fmt::print("  No spectrum, intervals or cvm: the picture is smaller than 16 x 16 pixels.\n");
    } else if (!blocks) {
        fmt::print(
            "  No intervals and no cvm: pixels are correlated over about {:.0f} pixels, and the shorter "
            "side of the picture is less than 8 times that.\n",
            report.spectrum->correlation);
    } else {
        fmt::print(
            "  Intervals come from {0} x {0} blocks; pixels are correlated over about {1:.0f} pixels.\n",
            blocks->blocks_per_side, report.spectrum->correlation);
        if (!has_cvm(blocks))
            fmt::print(
                "  The picture is too small to test its distribution; render at least {0} x {0} pixels.\n",
                side_for_cvm(measured, *blocks));
    }
}

void print_report(const StatsOptions& options, const Measured& measured) {
    const PictureReport& report = measured.report;
    const statistics::Moments& moments = report.moments;
    const auto between = [&](const Estimate BlockEstimates::*member) {
        if (!report.blocks)
            return std::string();
        const Estimate& estimate = (*report.blocks).*member;
        return fmt::format("95 %: {:.6g} to {:.6g}", estimate.low, estimate.high);
    };
    const std::string from = options.files.size() == 1 ? options.files.front().string()
                                                       : fmt::format("{} regions", options.files.size());
    fmt::print("{}: channel {}, {} x {} pixels, {} not finite{}\n", from, measured.channel, measured.width,
               measured.height, report.not_finite,
               measured.outside == 0
                   ? ""
                   : fmt::format(", {} excluded as outside the body (A below 1)", measured.outside));
    if (moments.count() == 0)
        return;
    print_line("mean", moments.mean(), between(&BlockEstimates::mean));
    print_line("variance", moments.variance(), between(&BlockEstimates::variance));
    print_line("skewness", moments.skewness());
    print_line("excess kurtosis", moments.excess_kurtosis());
    print_line("minimum", moments.minimum());
    print_line("maximum", moments.maximum());
    if (has_cvm(report.blocks))
        print_line(
            "cvm", report.blocks->cvm.value,
            fmt::format("{}, compared with a normal distribution of {} mean {:.6g} and variance {:.6g}",
                        between(&BlockEstimates::cvm), measured.reference(), measured.expected.mean,
                        measured.expected.variance()));
    if (measured.has_spectrum() && report.spectrum->power > 0)
        print_spectrum(*report.spectrum, measured.scale);
    if (measured.outside > 0)
        fmt::print("  No spectrum: perspective distorts frequencies.\n");
    print_limits(measured);
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

    note_interrupts();
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
    CLI::App* command =
        app.add_subcommand("stats", "Measure an OpenEXR picture: moments, Gaussianity, spectrum");
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
