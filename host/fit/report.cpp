#include "fit/report.hpp"

#include "error.hpp"
#include "fit/preset.hpp"
#include "fit/random_phase.hpp"
#include "image/output_file.hpp"
#include "image/picture.hpp"
#include "image/png.hpp"
#include "render/renderer.hpp"
#include "vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace gabor::fit {

namespace {

constexpr int largest_side = 512;
constexpr std::size_t bins = 64;

/// A square picture, the channels of each pixel side by side.
struct Picture {
    int side = 0;
    int channels = 0;
    std::vector<float> values;

    std::size_t pixels() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }
};

// The middle of the exemplar, as it is and without its trend.
struct Crop {
    Picture as_is;
    Picture flat;
};

Crop read_crop(const std::filesystem::path& image, const Exemplar& exemplar) {
    const auto source = image::open_picture(image);
    const auto in_file = static_cast<std::size_t>(source->format().channels);
    const auto channels = static_cast<std::size_t>(exemplar.channels);
    const int side = std::min({exemplar.width, exemplar.height, largest_side}) / 2 * 2;
    const int left = (exemplar.width - side) / 2;
    const int top = (exemplar.height - side) / 2;
    Crop crop{{side, exemplar.channels, {}}, {side, exemplar.channels, {}}};
    std::vector<float> row(static_cast<std::size_t>(exemplar.width) * in_file);
    std::vector<float> kept(static_cast<std::size_t>(exemplar.width) * channels);
    for (int y = 0; y < top + side; ++y) {
        source->read_row(row);
        if (y < top)
            continue;
        for (std::size_t x = 0; x < static_cast<std::size_t>(exemplar.width); ++x)
            for (std::size_t c = 0; c < channels; ++c)
                kept[x * channels + c] = row[x * in_file + c];
        const auto begin = static_cast<std::ptrdiff_t>(left) * exemplar.channels;
        const auto end = static_cast<std::ptrdiff_t>(left + side) * exemplar.channels;
        crop.as_is.values.insert(crop.as_is.values.end(), kept.begin() + begin, kept.begin() + end);
        exemplar.trend.subtract(y, kept);
        for (std::size_t i = 0; i < kept.size(); ++i)
            kept[i] += static_cast<float>(exemplar.mean[static_cast<Eigen::Index>(i % channels)]);
        crop.flat.values.insert(crop.flat.values.end(), kept.begin() + begin, kept.begin() + end);
    }
    return crop;
}

Picture random_phase_of(const Picture& picture) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<float> planes(picture.values.size());
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        for (std::size_t c = 0; c < channels; ++c)
            planes[c * picture.pixels() + i] = picture.values[i * channels + c];
    planes = random_phase(planes, picture.side, 1);
    Picture result = picture;
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        for (std::size_t c = 0; c < channels; ++c)
            result.values[i * channels + c] = planes[c * picture.pixels() + i];
    return result;
}

// As gabor render draws it; in grey too with the exemplar's mean and histogram.
Picture rendered(const Exemplar& exemplar, const Texture& texture, int side) {
    render::Request request = request_of(exemplar, texture);
    request.width = request.height = side;
    request.colour = texture.colour;
    const vulkan::Device device("");
    Picture picture{side, exemplar.channels, {}};
    const auto stride = static_cast<std::size_t>(3 / exemplar.channels);
    render::render_region(device, request, {0, 0, side, side}, [&](std::span<const float> values) {
        for (std::size_t i = 0; i < values.size(); i += stride)
            picture.values.push_back(values[i]);
    });
    return picture;
}

Spectra spectra_of(const Picture& picture, const Exemplar& exemplar) {
    SpectraEstimate estimate(picture.side, picture.side, picture.channels);
    const auto row_size = static_cast<std::size_t>(picture.side * picture.channels);
    std::vector<float> row(row_size);
    for (std::size_t begin = 0; begin < picture.values.size(); begin += row_size) {
        for (std::size_t i = 0; i < row_size; ++i)
            row[i] =
                picture.values[begin + i] -
                static_cast<float>(
                    exemplar.mean[static_cast<Eigen::Index>(i % static_cast<std::size_t>(picture.channels))]);
        estimate.add_row(row);
    }
    return estimate.spectra();
}

void write_png(const std::filesystem::path& path, int width, int height, int channels,
               std::span<const float> values) {
    image::PngWriter png(path, width, height, channels);
    png.write_rows(values);
    png.commit();
}

void write_png(const std::filesystem::path& path, const Picture& picture) {
    write_png(path, picture.side, picture.side, picture.channels, picture.values);
}

// The total power in decibels, from 60 below `most` to white, frequency 0 in the middle.
void write_spectrum(const std::filesystem::path& path, const Spectra& spectra, double most) {
    const Eigen::ArrayXd power = spectra.total();
    std::vector<float> values;
    for (int y = 0; y < grid_side; ++y)
        for (int x = 0; x < grid_side; ++x) {
            const int fx = x - grid_side / 2;
            const int fy = y - grid_side / 2;
            const int ky = ((fx < 0 ? -fy : fy) + grid_side) % grid_side;
            const double value = power[ky * grid_columns + std::abs(fx)];
            values.push_back(static_cast<float>(1 + 10 * std::log10(std::max(value / most, 1e-9)) / 60));
        }
    write_png(path, grid_side, grid_side, 1, values);
}

// From -1 to 1, 0 in grey.
void write_autocorrelation(const std::filesystem::path& path, const Spectra& spectra) {
    const Eigen::MatrixXd values = autocorrelation(spectra);
    std::vector<float> shown;
    for (Eigen::Index y = 0; y < values.rows(); ++y)
        for (Eigen::Index x = 0; x < values.cols(); ++x)
            shown.push_back(static_cast<float>(0.5 + 0.5 * values(y, x)));
    write_png(path, static_cast<int>(values.cols()), static_cast<int>(values.rows()), 1, shown);
}

// The share of pixels in each bin, of one channel between two values.
std::array<double, bins> histogram(const Picture& picture, int channel, double low, double high) {
    std::array<double, bins> shares{};
    for (auto i = static_cast<std::size_t>(channel); i < picture.values.size();
         i += static_cast<std::size_t>(picture.channels)) {
        const double place = (static_cast<double>(picture.values[i]) - low) / (high - low) * bins;
        if (place >= 0 && place < bins)
            shares[static_cast<std::size_t>(place)] += 1 / static_cast<double>(picture.pixels());
    }
    return shares;
}

std::string polyline(const std::array<double, bins>& shares, double most, std::string_view colour) {
    std::string points;
    for (std::size_t i = 0; i < bins; ++i)
        points +=
            fmt::format("{:.1f},{:.1f} ", 4.0 * (static_cast<double>(i) + 0.5), 120 - 110 * shares[i] / most);
    return fmt::format(R"(<polyline points="{}" fill="none" stroke="{}"/>)", points, colour);
}

// One drawing for each channel: of the exemplar, its random-phase noise and the fit.
std::string histograms(const std::array<const Picture*, 3>& pictures, const Exemplar& exemplar) {
    constexpr std::array colours{"black", "#3a7", "#c33"};
    std::string svgs;
    for (int c = 0; c < exemplar.channels; ++c) {
        const double deviation = exemplar.components.row(c).norm();
        const double low = exemplar.mean[c] - 4 * deviation;
        const double high = exemplar.mean[c] + 4 * deviation;
        std::array<std::array<double, bins>, 3> all{};
        double most = 0;
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            all[i] = histogram(*pictures[i], c, low, high);
            most = std::max(most, std::ranges::max(all[i]));
        }
        svgs += R"(<svg width="256" height="122" viewBox="0 0 256 122">)";
        for (std::size_t i = 0; i < all.size(); ++i)
            svgs += polyline(all[i], most, colours[i]);
        svgs += "</svg>\n";
    }
    return svgs;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
}

std::string row_of(std::string_view name, const Figures& figures) {
    return fmt::format("<tr><td>{}<td>{:.3f}<td>{:.3f}<td>{:.3f}\n", name, figures.l1, figures.l2,
                       figures.autocorrelation);
}

} // namespace

void write_report(const std::filesystem::path& folder, const std::filesystem::path& image,
                  const Exemplar& exemplar, const Texture& texture, const Advance& advance) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw RequestError(fmt::format("--report '{}': there can be no such folder", folder.string()));

    const Crop crop = read_crop(image, exemplar);
    const Picture phases = random_phase_of(crop.flat);
    advance(0.3);
    const Picture fitted = rendered(exemplar, texture, crop.flat.side);
    advance(0.8);
    write_png(folder / "exemplar.png", crop.as_is);
    write_png(folder / "random-phase.png", phases);
    write_png(folder / "fit.png", fitted);

    const Spectra measured = channel_spectra(exemplar);
    const Spectra of_phases = spectra_of(phases, exemplar);
    const double most = measured.total().maxCoeff();
    write_spectrum(folder / "exemplar-spectrum.png", measured, most);
    write_spectrum(folder / "random-phase-spectrum.png", of_phases, most);
    write_spectrum(folder / "fit-spectrum.png", texture.model, most);
    write_autocorrelation(folder / "exemplar-autocorrelation.png", measured);
    write_autocorrelation(folder / "random-phase-autocorrelation.png", of_phases);
    write_autocorrelation(folder / "fit-autocorrelation.png", texture.model);
    advance(0.9);

    std::string lobes;
    for (const Wave& wave : texture.waves)
        lobes += fmt::format("<tr><td>{:.4f}<td>{:.1f}<td>{:.1f}<td>{:.1f}\n", wave.wave.norm(),
                             std::atan2(wave.wave.y(), wave.wave.x()) * 180 / EIGEN_PI, wave.radius,
                             100 * (exemplar.components * wave.weight).squaredNorm() /
                                 exemplar.components.squaredNorm());
    const std::string warning = exemplar.structure > Structure::limit
                                    ? "<p><b>This is no texture of waves alone:</b> random-phase noise has "
                                      "lost the edges and the things that it is made of, and the fit has "
                                      "too.</p>"
                                    : "";
    const std::string page = fmt::format(
        R"(<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>{name}</title>
<style>body {{ font: 14px sans-serif; margin: 2em }} td, th {{ padding: 0.2em 0.8em; text-align: left; vertical-align: top }}
.small {{ width: 256px; image-rendering: pixelated }}</style>
<h1>{name}</h1>
<p>{width} x {height} pixels, fitted by {count} lobes. Random-phase noise is the most that any Gaussian texture can be.</p>
{warning}
<table>
<tr><th>exemplar<th>its random-phase noise<th>the fit
<tr><td><img src="exemplar.png"><td><img src="random-phase.png"><td><img src="fit.png">
<tr><th colspan="3">power spectra, 60 dB; frequency 0 in the middle, half a cycle per pixel at the edges
<tr><td><img class="small" src="exemplar-spectrum.png"><td><img class="small" src="random-phase-spectrum.png"><td><img class="small" src="fit-spectrum.png">
<tr><th colspan="3">autocorrelations up to lags of {lag} pixels, -1 black, 1 white
<tr><td><img class="small" src="exemplar-autocorrelation.png"><td><img class="small" src="random-phase-autocorrelation.png"><td><img class="small" src="fit-autocorrelation.png">
</table>
<h2>Histograms</h2>
<p>{channels}: the exemplar's in black, of its random-phase noise in green, of the fit in red.</p>
{histograms}
<h2>Figures</h2>
<table>
<tr><th>against the exemplar<th>spectrum, L1<th>L2<th>autocorrelation
{random_phase}{fit}</table>
<p>Excess kurtosis of the exemplar's derivatives, or twice its Laplacian's skewness, 0 for Gaussian textures:
{structure:.2f}</p>
<h2>Lobes</h2>
<table>
<tr><th>cycles per pixel<th>orientation, degrees<th>kernel radius, pixels<th>power, %
{lobes}</table>
)",
        fmt::arg("name", escaped(image.filename().string())), fmt::arg("width", exemplar.width),
        fmt::arg("height", exemplar.height), fmt::arg("count", texture.waves.size()),
        fmt::arg("warning", warning), fmt::arg("lag", furthest_lag),
        fmt::arg("channels", exemplar.channels == 1 ? "Grey" : "Red, green and blue"),
        fmt::arg("histograms", histograms({&crop.flat, &phases, &fitted}, exemplar)),
        fmt::arg("random_phase", row_of("random-phase noise, as measured", compare(measured, of_phases))),
        fmt::arg("fit", row_of("fit, as expected", texture.figures)),
        fmt::arg("structure", exemplar.structure), fmt::arg("lobes", lobes));
    image::OutputFile file(folder / "index.html");
    file.write(std::as_bytes(std::span(page)));
    file.commit();
    advance(1);
}

} // namespace gabor::fit
