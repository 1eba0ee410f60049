#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "fit/glsl.hpp"
#include "image/output_file.hpp"

#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace gabor::cli {

namespace {

constexpr std::uint64_t progress_steps = 1000;

struct FitOptions {
    std::string image;
    std::string output;
    std::string lobes = std::to_string(fit::most_lobes);
    std::optional<std::string> glsl;
};

// Returns a function that takes the progress of one part of the work and advances the total from `from` to
// `to`.
fit::Advance part_of(Progress& progress, double from, double to) {
    return [&progress, from, to, shown = std::uint64_t{0}](double share) mutable {
        check_interrupt();
        const auto now = static_cast<std::uint64_t>(progress_steps * (to - from) * share);
        progress.advance(now - shown);
        shown = now;
    };
}

void print_fit(const FitOptions& options, const fit::Exemplar& exemplar, const fit::FittedNoise& fitted) {
    const fit::FitError& error = fitted.error;
    fmt::print("{}: {} lobes for {} x {} pixels, {}\n", options.output, fitted.waves.size(), exemplar.width,
               exemplar.height, exemplar.channels == 1 ? "grey" : "colour");
    fmt::print("  spectrum         within {:.3f} (L1) and {:.3f} (L2) of the photograph's\n", error.l1,
               error.l2);
    if (error.low > 0)
        fmt::print("  long waves       within {:.3f} (L1), for waves longer than {} pixels\n", error.low,
                   fit::window_side);
    fmt::print("  autocorrelation  within {:.3f} up to lags of {} pixels, a quarter of the photograph\n",
               error.autocorrelation, error.furthest_lag);
    for (const std::string& line : fit::warnings(exemplar, fitted))
        fmt::print("  {}\n", line);
}

void fit_picture(const FitOptions& options) {
    system::note_interrupts();
    const int lobes = parse_integer("--lobes", options.lobes, 1, fit::most_lobes);
    const std::optional<std::string> name =
        options.glsl ? std::optional(fit::function_name(*options.glsl)) : std::nullopt;
    check_extension("-o", options.output, {".json"}, true);
    image::OutputFile output(options.output);
    std::optional<image::OutputFile> glsl;
    if (options.glsl)
        glsl.emplace(*options.glsl);

    std::optional<Progress> progress(std::in_place, "fitting", progress_steps);
    const fit::Exemplar exemplar = fit::read_exemplar(options.image, part_of(*progress, 0, 0.3));
    const fit::FittedNoise fitted = fit::fit(exemplar, lobes, part_of(*progress, 0.3, 1));
    const render::Request request = fit::request_of(exemplar, fitted);
    progress.reset();
    output.write(render::to_json(request) + "\n");
    output.commit();
    if (glsl) {
        glsl->write(fit::glsl_of(*name, options.image, exemplar, fitted));
        glsl->commit();
    }
    print_fit(options, exemplar, fitted);
}

} // namespace

void add_fit_command(CLI::App& app) {
    auto options = std::make_shared<FitOptions>();
    CLI::App* command = app.add_subcommand("fit", "Fit Gabor noise to a photograph of a texture");
    add_option(*command, "IMAGE", options->image, "FILE",
               "The photograph: PNG, JPEG, TGA, TIFF or OpenEXR, at least 128x128 pixels")
        ->required();
    add_option(*command, "-o,--output", options->output, "FILE",
               "Output: a preset NAME.json for gabor render --preset")
        ->required();
    add_option(*command, "--lobes", options->lobes, "NUMBER",
               fmt::format("Maximum number of lobes, 1 to {}; each costs as much as one noise [{}]",
                           fit::most_lobes, options->lobes));
    add_option(*command, "--glsl", options->glsl, "FILE",
               "Also write NAME.glsl with vec3 NAME(vec2 p) and its filtered form, to include after "
               "gabor_noise.glsl and gabor_filter.glsl");
    command->callback([options] { fit_picture(*options); });
}

} // namespace gabor::cli
