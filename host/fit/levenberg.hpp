#pragma once

#include "fit/spectra.hpp"

#include <Eigen/Core>

#include <vector>

namespace gabor::fit {

/// Waves around one wave vector in several channels. If z is the complex noise of such a wave, with E[z(p +
/// t) z(p)*] = 2 exp(2 pi i frequency.t) g(t.x / radius.x) g(t.y / radius.y) and g = kernel_correlation,
/// channel c is Re(weight_c z), and the cross-spectra are proportional to weight_c weight_d*.
struct Wave {
    Eigen::Vector2d frequency; ///< cycles per pixel
    Eigen::Vector2d radius;    ///< pixels, along x and y
    Eigen::VectorXcd weight;   ///< weights of the channels; real if there is only one channel
};

/// The spectra that waves are fitted to, weighted for least squares: each frequency is divided by the root of
/// P + 0.01 mean P, where P is the power there. Unweighted least squares would leave weak frequencies empty,
/// and dividing by P would give most weight to frequencies whose estimate is low by chance. SpectrumScales
/// with few windows count less; otherwise lobes would be spent on peaks that occur by chance.
struct TargetSpectra {
    int channels;
    SpectrumScales scales;
    Eigen::MatrixXd values;    ///< as in Spectra, times `weight` and, off the diagonal, the root of 2
    Eigen::ArrayXd importance; ///< of each frequency: its share of the plane times the scale's confidence
    Eigen::ArrayXd weight;     ///< root of the weight of each frequency in the sum of squares
    double largest_radius;     ///< allowed for waves

    TargetSpectra(const Spectra& spectra, double largest_radius);

    /// Returns a copy in which the weight of each frequency in the sum of squares is inversely proportional
    /// to an error: the residual of `waves` there plus the error of the estimate. A fit to the copy then
    /// nearly minimizes absolute errors: iteratively reweighted least squares.
    TargetSpectra reweighed(const std::vector<Wave>& waves) const;
};

/// Returns the residual: the target's values minus those of the waves. Its squared norm is the cost of a fit.
Eigen::MatrixXd residual(const TargetSpectra& target, const std::vector<Wave>& waves);

/// How much an additional wave with the best weights reduces the cost, and these weights.
struct Gain {
    double cost = 0;
    Eigen::VectorXcd weight;
};
Gain gain(const TargetSpectra& target, const Eigen::MatrixXd& left, const Eigen::Vector2d& frequency,
          const Eigen::Vector2d& radius);

/// The expected estimate of the waves' spectra.
Spectra model(const std::vector<Wave>& waves, int channels, const SpectrumScales& scales = first_scale());

/// Which parameters may change: only weights, or also frequencies and radii.
enum class FreeParameters { weights, all };

/// Reduces the cost by the Levenberg-Marquardt method, in at most `steps` steps. Stops once a step reduces it
/// by less than a ten-thousandth.
void refine(const TargetSpectra& target, std::vector<Wave>& waves, FreeParameters free, int steps);

} // namespace gabor::fit
