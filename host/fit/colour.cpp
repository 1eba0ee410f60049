#include "fit/colour.hpp"

#include <Eigen/Eigenvalues>

#include <complex>

namespace gabor::fit {

Eigen::VectorXd component_scales(const Exemplar& exemplar) {
    return exemplar.components.colwise().norm().array().pow(0.8).matrix().transpose();
}

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

} // namespace gabor::fit
