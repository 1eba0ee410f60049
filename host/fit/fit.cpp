#include "fit/fit.hpp"

#include "fit/axis_spectrum.hpp"
#include "fit/greedy.hpp"
#include "noise/lobe.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace gabor::fit {

namespace {

// Whether chance can explain the error of a fit to a picture of this size. Random errors are inversely
// proportional to the number of windows along a side, of which at most 28 count. Also accepts errors of
// strong frequencies (l2) and of autocorrelations if they are too small to see.
bool is_chance(const FitError& error, const Exemplar& exemplar) {
    const double side = std::sqrt(static_cast<double>(exemplar.width) * exemplar.height);
    const double windows = std::min(side / window_side, 28.0);
    return error.l1 < 0.44 / windows && error.l2 < std::max(0.38 / windows, 0.0475) &&
           error.autocorrelation < std::max(2 * error.chance, 0.03);
}

// The unit of length of a preset, in pixels: the radius of the strongest lobe, or the nearest length of at
// least 2 for which the radii of all lobes are between 0.01 and 100 units.
double unit_of(const std::vector<Wave>& waves) {
    double least = waves.front().radius.minCoeff();
    double most = waves.front().radius.maxCoeff();
    const double first = std::sqrt(least * most);
    for (const Wave& wave : waves) {
        least = std::min(least, wave.radius.minCoeff());
        most = std::max(most, wave.radius.maxCoeff());
    }
    return std::max({2.0, std::min(first, 100 * least), most / 100});
}

// Raises frequencies near 0 to the lowest that a preset accepts. All frequencies that low look the same.
void keep_from_zero(std::vector<Wave>& waves) {
    const double least = 0.0011 / unit_of(waves);
    for (Wave& wave : waves)
        if (wave.frequency.norm() < least)
            wave.frequency = {least, 0};
}

void drop_empty(std::vector<Wave>& waves) {
    double all = 0;
    for (const Wave& wave : waves)
        all += wave.weight.squaredNorm();
    std::erase_if(waves, [&](const Wave& wave) { return wave.weight.squaredNorm() < 1e-5 * all; });
}

// Adds the lobe that reduces the residual most, then refines all lobes.
void add_lobe(const TargetSpectra& target, const WaveSearch& search, std::vector<Wave>& waves) {
    Wave next = search.best(target, residual(target, waves));
    if (next.weight.isZero())
        return;
    waves.push_back(std::move(next));
    refine(target, waves, FreeParameters::weights, 4);
    refine(target, waves, FreeParameters::all, 6);
    drop_empty(waves);
}

// Replaces lobes that are no longer the best choice, now that more lobes have been added.
void exchange_lobes(const TargetSpectra& target, const WaveSearch& search, std::vector<Wave>& waves,
                    const Advance& advance) {
    const std::size_t count = waves.size();
    for (std::size_t i = count; i-- > 0 && waves.size() == count && count > 1;) {
        std::vector<Wave> others = waves;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        refine(target, others, FreeParameters::all, 4);
        add_lobe(target, search, others);
        if (residual(target, others).squaredNorm() < 0.999 * residual(target, waves).squaredNorm())
            waves = std::move(others);
        advance(1 - 0.5 * static_cast<double>(i) / static_cast<double>(count));
    }
}

// Refines waves to reduce the sum of absolute errors instead of the sum of squared errors.
std::vector<Wave> with_absolute_errors(const TargetSpectra& target, std::vector<Wave> waves) {
    for (int round = 0; round < 2; ++round)
        refine(target.reweighed(waves), waves, FreeParameters::all, 10);
    return waves;
}

// Returns a factor for the values of each component, which have variance 1: the component's standard
// deviation in the photograph to the power 0.8. Weak components therefore count for a little more than their
// power, which preserves hues.
Eigen::VectorXd component_scales(const Exemplar& exemplar) {
    return exemplar.components.colwise().norm().array().pow(0.8).matrix().transpose();
}

// Changes the weights as little as possible so that the covariance of the components becomes the identity
// matrix. This succeeds only partly with few waves: each has at most two independent components.
void normalize(std::vector<Wave>& waves) {
    const Eigen::Index components = waves.front().weight.size();
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(components, components);
    for (const Wave& wave : waves)
        covariance += (wave.weight * wave.weight.adjoint()).real();
    // Limits gains to 4, in case the lobes contain almost nothing of a component.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    const Eigen::VectorXd gains = solver.eigenvalues().cwiseMax(1.0 / 16).cwiseInverse().cwiseSqrt();
    const Eigen::MatrixXd root =
        solver.eigenvectors() * gains.asDiagonal() * solver.eigenvectors().transpose();
    for (Wave& wave : waves)
        wave.weight = root * wave.weight;
}

// The noise's colours: the weights of the waves in each component, and the photograph's mean and histograms.
// A phase that all components share has no effect, so it is chosen to leave no quadrature in the first
// component.
noise::Colour colour_of(const Exemplar& exemplar, const std::vector<Wave>& waves) {
    noise::Colour colour;
    for (const Wave& wave : waves) {
        // The wave is Re(W z) with z = quadrature + i noise. W is turned so that W_0 becomes -i |W_0|.
        const std::complex<double> first = wave.weight[0];
        const double length = std::abs(first);
        const std::complex<double> turn =
            std::complex<double>(0, -1) * (length > 0 ? std::conj(first) / length : std::complex<double>(1));
        auto& weights = colour.weights.emplace_back();
        for (Eigen::Index c = 0; c < wave.weight.size(); ++c) {
            const std::complex<double> w = wave.weight[c] * turn;
            weights[static_cast<std::size_t>(c)] = {c == 0 ? 0 : w.real(), -w.imag()};
        }
    }
    colour.linear = exemplar.linear;
    colour.histogram.fill({0, 1, 0, 0, 0, 0});
    for (std::size_t c = 0; c < exemplar.histograms.size(); ++c)
        colour.histogram[c] = exemplar.histograms[c].polynomial();
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Index channel = exemplar.channels == 1 ? 0 : static_cast<Eigen::Index>(i);
        colour.mean[i] = exemplar.mean[channel];
        for (Eigen::Index c = 0; c < exemplar.components.cols(); ++c)
            colour.mixing[i][static_cast<std::size_t>(c)] = exemplar.components(channel, c);
    }
    return colour;
}

// Larger differences are visible in most textures.
constexpr double l1_limit = 0.2;
constexpr double low_limit = 0.4;
constexpr double low_power_limit = 0.001; // their error, relative to the whole power: 3 % of the deviation
constexpr double autocorrelation_limit = 0.2;

} // namespace

FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance) {
    const Eigen::VectorXd scales = component_scales(exemplar);
    const Spectra spectra = exemplar.spectra.mapped(scales.asDiagonal());
    // Limits the kernels' radius so that the texture can be tiled at the picture's size.
    const TargetSpectra target(spectra, std::min(exemplar.width, exemplar.height) / 2.0);
    const auto unscaled = [&](std::vector<Wave> of) {
        for (Wave& wave : of)
            wave.weight = scales.cwiseInverse().asDiagonal() * wave.weight;
        return of;
    };
    const WaveSearch search(target);
    std::vector<Wave> waves;
    for (int i = 0; i < lobes; ++i) {
        add_lobe(target, search, waves);
        if (std::ssize(waves) <= i)
            break;
        advance(0.5 * (i + 1) / lobes);
        if (is_chance(fit_error(exemplar, unscaled(waves)), exemplar))
            break;
    }
    refine(target, waves, FreeParameters::all, 30);
    exchange_lobes(target, search, waves, advance);
    refine(target, waves, FreeParameters::all, 100);
    std::vector<Wave> closer = unscaled(with_absolute_errors(target, waves));
    waves = unscaled(std::move(waves));
    // If lobes can follow the spectrum exactly, least squares finds them best, so the fit with absolute
    // errors must be better by a margin.
    FitError error = fit_error(exemplar, waves);
    const FitError after = fit_error(exemplar, closer);
    if (after.l1 < 0.97 * error.l1 && after.l2 <= error.l2) {
        waves = std::move(closer);
        error = after;
    }
    const auto power = [&](const Wave& wave) { return (exemplar.components * wave.weight).squaredNorm(); };
    std::ranges::sort(waves, std::greater(), power);
    normalize(waves);
    keep_from_zero(waves);
    advance(1);
    return {waves, colour_of(exemplar, waves), error};
}

render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted) {
    render::Request request;
    request.width = exemplar.width;
    request.height = exemplar.height;
    request.scale = unit_of(fitted.waves);
    request.lobes.clear();
    for (const Wave& wave : fitted.waves) {
        noise::Lobe lobe;
        lobe.frequency = wave.frequency.norm() * request.scale;
        lobe.orientation = noise::degrees(std::atan2(wave.frequency.y(), wave.frequency.x()));
        lobe.radius = wave.radius.x() / request.scale;
        lobe.stretch = wave.radius.y() / wave.radius.x();
        lobe.power = (exemplar.components * wave.weight).squaredNorm() / exemplar.components.squaredNorm();
        request.lobes.push_back(lobe);
    }
    request.colour = fitted.colour;
    return request;
}

std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted) {
    std::vector<std::string> lines;
    const FitError& error = fitted.error;
    if (!exemplar.profile.empty())
        lines.push_back(fmt::format("The photograph's colours are read as sRGB, but its ICC profile is '{}': "
                                    "convert it to sRGB.",
                                    exemplar.profile));
    if (exemplar.transparent > 0)
        lines.push_back(fmt::format("Left out {:.3g} % of the pixels: they are transparent.",
                                    100 * exemplar.transparent));
    if (exemplar.fireflies > 0)
        lines.push_back(fmt::format("Left out {:.3g} % of the pixels: they are far brighter than all others.",
                                    100 * exemplar.fireflies));
    if (exemplar.structure > Structure::limit)
        lines.push_back(fmt::format(
            "The photograph has edges or objects, which no sum of waves can reproduce: the noise keeps the "
            "colours and scales but loses the objects (the photograph's distance from normal is {:.1f}). To "
            "keep them, blend pieces of the photograph and preserve its histogram: Heitz and Neyret 2018, "
            "Deliot and Heitz 2019.",
            exemplar.structure));
    if (error.l1 > l1_limit)
        lines.push_back(fmt::format(
            "The noise differs visibly from the photograph: {} lobes cannot follow its spectrum (L1 {:.2f}).",
            fitted.waves.size(), error.l1));
    if (error.low > low_limit && error.low * error.low_share > low_power_limit)
        lines.push_back(
            fmt::format("Large features may be too weak or too strong: the spectrum of waves longer "
                        "than {} pixels is off by {:.2f} (L1).",
                        window_side, error.low));
    if (error.autocorrelation > std::max(autocorrelation_limit, 4 * error.chance))
        lines.push_back(
            fmt::format("Something in the photograph repeats or continues further than the noise can "
                        "(autocorrelations differ by {:.2f}).",
                        error.autocorrelation));
    return lines;
}

} // namespace gabor::fit
