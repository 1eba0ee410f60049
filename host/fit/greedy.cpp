#include "fit/greedy.hpp"

#include "fit/axis_spectrum.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace gabor::fit {

namespace {

using Eigen::Index;

// Returns the values at all frequencies of the first scale's grid, from the stored half. The value at an
// opposite frequency is multiplied by `opposite`, 1 or -1.
Eigen::MatrixXf whole_plane(const SpectrumScale& scale, const Eigen::ArrayXd& half, float opposite) {
    const int grid = scale.grid;
    Eigen::MatrixXf plane(grid, grid);
    Index at = 0;
    for (const SpectrumScale::Frequency& k : scale.frequencies) {
        const auto value = static_cast<float>(half[at++]);
        if (2 * k.x != grid && k.x != 0)
            plane((grid - k.y) % grid, grid - k.x) = opposite * value;
        plane(k.y, k.x) = value;
    }
    return plane;
}

// The largest eigenvalue of a Hermitian matrix of at most three rows, by its characteristic polynomial [Smith
// 1961].
float largest_eigenvalue(const Eigen::Matrix3cf& m, int rows) {
    if (rows == 1)
        return m(0, 0).real();
    const float middle = m.trace().real() / 3;
    const Eigen::Matrix3cf rest = m - middle * Eigen::Matrix3cf::Identity();
    const float size = std::sqrt(rest.squaredNorm() / 6);
    if (!(size > 0))
        return middle;
    const float cosine = std::clamp((rest / size).determinant().real() / 2, -1.0f, 1.0f);
    return middle + 2 * size * std::cos(std::acos(cosine) / 3);
}

// Radii from `from` to `to`, each twice the one before.
std::vector<double> radii(double from, double to) {
    std::vector<double> result;
    for (double radius = from; radius < 1.01 * to; radius *= 2)
        result.push_back(radius);
    return result;
}

// The frequencies of a scale at which a single wave would reduce the residual most, in cycles per pixel.
std::vector<Eigen::Vector2d> peaks(const TargetSpectra& target, const Eigen::MatrixXd& left,
                                   const SpectrumScale& scale) {
    constexpr std::size_t most = 8;
    constexpr int apart = 3;
    const Eigen::ArrayXd power = total(left.middleRows(scale.begin, std::ssize(scale.frequencies)),
                                       Eigen::VectorXd::Ones(target.channels));
    std::vector<Index> order(scale.frequencies.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, std::greater(), [&](Index i) { return power[i]; });
    std::vector<Eigen::Vector2d> found;
    for (const Index i : order) {
        const SpectrumScale::Frequency& k = scale.frequencies[static_cast<std::size_t>(i)];
        Eigen::Vector2d place(k.x, 2 * k.y > scale.grid ? k.y - scale.grid : k.y);
        if (!(power[i] > 0) || found.size() == most)
            break;
        if (std::ranges::all_of(found, [&](const Eigen::Vector2d& other) {
                return (other - place).cwiseAbs().maxCoeff() >= apart &&
                       (other + place).cwiseAbs().maxCoeff() >= apart;
            }))
            found.push_back(place);
    }
    for (Eigen::Vector2d& place : found)
        place /= scale.grid * scale.spacing;
    return found;
}

} // namespace

WaveSearch::Axis WaveSearch::axis_of(const SpectrumScale& scale, int which, double largest_radius,
                                     int lowest) {
    Axis axis;
    for (const double radius : radii(2, std::min<double>(largest_radius, scale.length()))) {
        // The distance between the frequencies to try. Narrow kernels have wide lobes, so few frequencies are
        // enough.
        const int stride = std::max(1, static_cast<int>(16 / radius));
        for (int k = lowest / stride * stride; k <= scale.grid / 2; k += stride) {
            axis.frequency.push_back(k);
            axis.radius.push_back(radius);
        }
    }
    axis.frequency.push_back(0); // white noise
    axis.radius.push_back(smallest_radius);
    const auto count = std::ssize(axis.frequency);
    axis.spectra.resize(count, scale.grid);
    axis.mirrored.resize(count, scale.grid);
    for (Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Eigen::ArrayXd spectrum =
            axis_spectrum(scale, which, static_cast<double>(axis.frequency[at]) / scale.grid, axis.radius[at],
                          false)
                .value;
        for (int k = 0; k < scale.grid; ++k) {
            axis.spectra(i, k) = static_cast<float>(spectrum[k]);
            axis.mirrored(i, k) = static_cast<float>(spectrum[k] * spectrum[(scale.grid - k) % scale.grid]);
        }
    }
    return axis;
}

WaveSearch::WaveSearch(const TargetSpectra& target)
    : x_(axis_of(target.scales->front(), 0, target.largest_radius, 0)),
      y_(axis_of(target.scales->front(), 1, target.largest_radius, 1 - target.scales->front().grid / 2)) {
    const SpectrumScale& scale = target.scales->front();
    const Index rows = std::ssize(scale.frequencies);
    const Eigen::MatrixXf weight =
        whole_plane(scale, target.weight.head(rows).square() / measures({scale}), 1);
    square_ = 0.25f * (y_.spectra.cwiseAbs2() * weight * x_.spectra.cwiseAbs2().transpose() +
                       y_.mirrored * weight * x_.mirrored.transpose());
}

Wave WaveSearch::best(const TargetSpectra& target, const Eigen::MatrixXd& left) const {
    const SpectrumScale& first = target.scales->front();
    const Index rows = std::ssize(first.frequencies);
    const Eigen::ArrayXd factor = target.weight.head(rows) / measures({first});
    const std::vector<MatrixEntry> stored = entries(target.channels);
    std::vector<Eigen::MatrixXf> products;
    for (const auto& [c, d, imaginary] : stored) {
        const double single = c == d ? 0.5 : 0.5 / std::numbers::sqrt2;
        const auto half = left.col(std::ssize(products)).head(rows).array();
        const Eigen::MatrixXf plane = whole_plane(first, single * half * factor, imaginary ? -1 : 1);
        products.push_back(y_.spectra * plane * x_.spectra.transpose());
    }
    Wave wave{{0, 0}, {smallest_radius, smallest_radius}, Eigen::VectorXcd::Zero(target.channels)};
    double gained = 0;
    Eigen::Matrix3cf at = Eigen::Matrix3cf::Zero();
    for (Index x = 0; x < square_.cols(); ++x)
        for (Index y = 0; y < square_.rows(); ++y) {
            const double rx = x_.radius[static_cast<std::size_t>(x)];
            const double ry = y_.radius[static_cast<std::size_t>(y)];
            if ((rx < 2) != (ry < 2))
                continue;
            for (std::size_t i = 0; i < stored.size(); ++i) {
                const auto& [c, d, imaginary] = stored[i];
                if (imaginary)
                    at(c, d).imag(products[i](y, x));
                else
                    at(c, d) = products[i](y, x);
                at(d, c) = std::conj(at(c, d));
            }
            const double value = largest_eigenvalue(at, target.channels);
            const double gain = value > 0 ? value * value / static_cast<double>(square_(y, x)) : 0;
            if (gain <= gained)
                continue;
            gained = gain;
            wave.frequency = Eigen::Vector2d(x_.frequency[static_cast<std::size_t>(x)],
                                             y_.frequency[static_cast<std::size_t>(y)]) /
                             first.grid;
            wave.radius = {rx, ry};
        }

    // Replaces that wave if a wave at a peak of another scale gains more over all scales.
    Gain most = gain(target, left, wave.frequency, wave.radius);
    for (std::size_t s = 1; s < target.scales->size(); ++s) {
        const SpectrumScale& scale = (*target.scales)[s];
        const double narrowest = (*target.scales)[s - 1].length() / 4;
        const std::vector<double> wide =
            radii(narrowest, std::min<double>(target.largest_radius, scale.length()));
        for (const Eigen::Vector2d& frequency : peaks(target, left, scale))
            for (const double rx : wide)
                for (const double ry : wide) {
                    const Gain here = gain(target, left, frequency, {rx, ry});
                    if (here.cost > most.cost) {
                        most = here;
                        wave.frequency = frequency;
                        wave.radius = {rx, ry};
                    }
                }
    }
    wave.weight = most.weight;
    return wave;
}

} // namespace gabor::fit
