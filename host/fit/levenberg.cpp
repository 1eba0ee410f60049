#include "fit/levenberg.hpp"

#include "fit/axis_spectrum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace gabor::fit {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double root_2 = std::numbers::sqrt2;
constexpr double largest_stretch = 99; // presets accept at most 100
// The number of functions for each wave: its spectrum, and the spectrum's derivatives with respect to the
// frequencies along x and y and to the logarithms of both radii.
constexpr int functions = 5;

// A spectrum on the grid has a part for the wave and a mirrored part for its opposite. The real parts of
// cross-spectra contain the sum of the two, the imaginary parts their difference. A single channel has no
// imaginary parts, and leaves `difference` empty.
struct Parts {
    Eigen::MatrixXd sum;
    Eigen::MatrixXd difference;
};

void put(Parts& parts, Index column, const SpectrumScale& scale, const Eigen::ArrayXd& x,
         const Eigen::ArrayXd& y) {
    const auto mirrored = [&](int k) { return k == 0 ? 0 : scale.grid - k; };
    const bool several = parts.difference.size() > 0;
    Index at = scale.begin;
    for (const SpectrumScale::Frequency& k : scale.frequencies) {
        const double a = 0.5 * x[k.x] * y[k.y];
        const double b = 0.5 * x[mirrored(k.x)] * y[mirrored(k.y)];
        parts.sum(at, column) = a + b;
        if (several)
            parts.difference(at, column) = a - b;
        ++at;
    }
}

// Returns one column for each wave or, with derivatives, `functions` columns. Each row is multiplied by the
// weight of its frequency. Reuses the memory of `parts`.
Parts parts_of(const std::vector<Wave>& waves, int channels, const SpectrumScales& scales,
               bool with_derivatives, const Eigen::ArrayXd& weight, Parts parts = {}) {
    const Index each = with_derivatives ? functions : 1;
    parts.sum.resize(weight.size(), each * std::ssize(waves));
    if (channels > 1)
        parts.difference.resize(weight.size(), parts.sum.cols());
    Index column = 0;
    for (const Wave& wave : waves) {
        for (const SpectrumScale& scale : *scales) {
            const AxisSpectrum x =
                axis_spectrum(scale, 0, wave.frequency.x(), wave.radius.x(), with_derivatives);
            const AxisSpectrum y =
                axis_spectrum(scale, 1, wave.frequency.y(), wave.radius.y(), with_derivatives);
            put(parts, column, scale, x.value, y.value);
            if (with_derivatives) {
                put(parts, column + 1, scale, x.by_frequency, y.value);
                put(parts, column + 2, scale, x.value, y.by_frequency);
                put(parts, column + 3, scale, x.by_log_radius, y.value);
                put(parts, column + 4, scale, x.value, y.by_log_radius);
            }
        }
        column += each;
    }
    parts.sum.array().colwise() *= weight;
    if (channels > 1)
        parts.difference.array().colwise() *= weight;
    return parts;
}

// The factor that makes the sum of squares of the stored entries equal to that of the whole matrix.
double factor(const MatrixEntry& entry) {
    return entry.c == entry.d ? 1 : root_2;
}

// Returns the stored entries of a Hermitian matrix, multiplied by their factors.
Eigen::RowVectorXd stored(const Eigen::MatrixXcd& matrix) {
    Eigen::RowVectorXd result(matrix.size());
    Index at = 0;
    for (const MatrixEntry& entry : entries(static_cast<int>(matrix.rows()))) {
        const Complex value = factor(entry) * matrix(entry.c, entry.d);
        result[at++] = entry.imaginary ? value.imag() : value.real();
    }
    return result;
}

// The products of the parts and the residual: a row for each column of the parts, a column for each entry.
Eigen::MatrixXd products(const Parts& parts, const Eigen::MatrixXd& left, int channels) {
    const Index reals = real_entries(channels);
    const Index others = left.cols() - reals;
    Eigen::MatrixXd result(parts.sum.cols(), left.cols());
    result.leftCols(reals).noalias() = parts.sum.transpose() * left.leftCols(reals);
    if (others > 0)
        result.rightCols(others).noalias() = parts.difference.transpose() * left.rightCols(others);
    return result;
}

// A parameter of the fit. As it changes, the model changes by one of the wave's functions times `change`.
struct Parameter {
    Index wave;
    Index function;
    Eigen::RowVectorXd change;
};

// Weights change relative to the length of the wave's weight vector. The weight of a single channel is real.
std::vector<Parameter> parameters_of(const std::vector<Wave>& waves, FreeParameters free) {
    std::vector<Parameter> parameters;
    for (Index j = 0; j < std::ssize(waves); ++j) {
        const Eigen::VectorXcd& w = waves[static_cast<std::size_t>(j)].weight;
        for (Index c = 0; c < w.size(); ++c)
            for (const Complex unit : {Complex(1, 0), Complex(0, 1)}) {
                if (w.size() == 1 && unit.imag() != 0)
                    continue;
                Eigen::VectorXcd change = Eigen::VectorXcd::Zero(w.size());
                change[c] = w.norm() * unit;
                parameters.push_back({j, 0, stored(change * w.adjoint() + w * change.adjoint())});
            }
        if (free == FreeParameters::all)
            for (Index f = 1; f < functions; ++f)
                parameters.push_back({j, f, stored(w * w.adjoint())});
    }
    return parameters;
}

// The normal equations of a step.
struct Normal {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd slope;
};

Normal normal_equations(const std::vector<Parameter>& parameters, const Parts& parts, Index each,
                        const Eigen::MatrixXd& left, int channels) {
    const auto gram = [](const Eigen::MatrixXd& m) {
        Eigen::MatrixXd product = Eigen::MatrixXd::Zero(m.cols(), m.cols());
        product.selfadjointView<Eigen::Lower>().rankUpdate(m.transpose());
        return Eigen::MatrixXd(product.selfadjointView<Eigen::Lower>());
    };
    const bool several = channels > 1;
    const Index reals = real_entries(channels);
    const Index others = left.cols() - reals;
    const Eigen::MatrixXd sums = gram(parts.sum);
    const Eigen::MatrixXd differences = several ? gram(parts.difference) : Eigen::MatrixXd();
    const Eigen::MatrixXd residuals = products(parts, left, channels);

    const Index count = std::ssize(parameters);
    Normal normal{Eigen::MatrixXd(count, count), Eigen::VectorXd(count)};
    for (Index i = 0; i < count; ++i) {
        const Parameter& p = parameters[static_cast<std::size_t>(i)];
        const Index row = p.wave * each + p.function;
        normal.slope[i] = residuals.row(row).dot(p.change);
        for (Index k = 0; k <= i; ++k) {
            const Parameter& q = parameters[static_cast<std::size_t>(k)];
            const Index column = q.wave * each + q.function;
            double entry = sums(row, column) * p.change.head(reals).dot(q.change.head(reals));
            if (several)
                entry += differences(row, column) * p.change.tail(others).dot(q.change.tail(others));
            normal.matrix(i, k) = normal.matrix(k, i) = entry;
        }
    }
    return normal;
}

// The damping added to the diagonal, up to a factor. All weights of a wave share one value, because a common
// phase has no effect. Without a lower bound, a frequency of 0 or an irrelevant radius would get no damping.
Eigen::VectorXd damping(const std::vector<Parameter>& parameters, const std::vector<Wave>& waves,
                        const Normal& normal) {
    Eigen::VectorXd power = Eigen::VectorXd::Zero(std::ssize(waves));
    for (Index i = 0; i < std::ssize(parameters); ++i)
        if (const Parameter& p = parameters[static_cast<std::size_t>(i)]; p.function == 0)
            power[p.wave] += normal.matrix(i, i);
    Eigen::VectorXd result(std::ssize(parameters));
    for (Index i = 0; i < result.size(); ++i) {
        const Parameter& p = parameters[static_cast<std::size_t>(i)];
        const Eigen::Vector2d& radius = waves[static_cast<std::size_t>(p.wave)].radius;
        const double least = p.function == 0   ? power[p.wave]
                             : p.function >= 3 ? 0.01 * power[p.wave]
                                               : 0.01 * std::pow(radius[p.function - 1], 2) * power[p.wave];
        result[i] = std::max(normal.matrix(i, i), least);
    }
    return result;
}

// Keeps a radius at its bound if the step would cross it.
void freeze_bounded(const std::vector<Parameter>& parameters, const std::vector<Wave>& waves, double largest,
                    Normal& normal) {
    for (Index i = 0; i < std::ssize(parameters); ++i) {
        const Parameter& p = parameters[static_cast<std::size_t>(i)];
        if (p.function < 3)
            continue;
        const double radius = waves[static_cast<std::size_t>(p.wave)].radius[p.function - 3];
        const double slope = normal.slope[i];
        if (!((radius <= smallest_radius && slope < 0) || (radius >= largest && slope > 0)))
            continue;
        normal.matrix.row(i).setZero();
        normal.matrix.col(i).setZero();
        normal.matrix(i, i) = 1;
        normal.slope[i] = 0;
    }
}

// The waves after a step, limited to where the linearization is valid.
std::vector<Wave> moved(std::vector<Wave> waves, const Eigen::VectorXd& step, FreeParameters free,
                        double largest) {
    Index at = 0;
    for (Wave& wave : waves) {
        const Index channels = wave.weight.size();
        Eigen::VectorXcd change(channels);
        for (Index c = 0; c < channels; ++c) {
            const double real = step[at++];
            change[c] = {real, channels > 1 ? step[at++] : 0};
        }
        const double most = 0.5 / std::max(change.norm(), 0.5);
        wave.weight += most * wave.weight.norm() * change;
        if (free != FreeParameters::all)
            continue;
        const Eigen::Array2d turn(step[at], step[at + 1]);
        const double most_turn = std::max(1.0, 2 * (turn * wave.radius.array()).matrix().norm());
        wave.frequency.array() += turn / most_turn;
        wave.frequency.array() -= (wave.frequency.array() + 0.5).floor(); // wraps around to an alias
        for (Index axis = 0; axis < 2; ++axis)
            wave.radius[axis] =
                std::clamp(wave.radius[axis] * std::exp(std::clamp(step[at + 2 + axis], -0.5, 0.5)),
                           smallest_radius, largest);
        wave.radius.y() =
            std::clamp(wave.radius.y(), wave.radius.x() / largest_stretch, wave.radius.x() * largest_stretch);
        at += 4;
    }
    return waves;
}

// Adds the waves, times `sign`, to spectra whose entries are multiplied by their factors.
void add(Eigen::MatrixXd& spectra, const std::vector<Wave>& waves, const Parts& parts, Index each,
         double sign) {
    for (Index j = 0; j < std::ssize(waves); ++j) {
        const Eigen::VectorXcd& w = waves[static_cast<std::size_t>(j)].weight;
        const Index reals = real_entries(static_cast<int>(w.size()));
        const Index others = spectra.cols() - reals;
        const Eigen::RowVectorXd of = sign * stored(w * w.adjoint());
        spectra.leftCols(reals).noalias() += parts.sum.col(each * j) * of.head(reals);
        if (others > 0)
            spectra.rightCols(others).noalias() += parts.difference.col(each * j) * of.tail(others);
    }
}

} // namespace

TargetSpectra::TargetSpectra(const Spectra& spectra, double radius)
    : channels(spectra.channels), scales(spectra.scales), values(spectra.values),
      importance(measures(*scales)), largest_radius(radius) {
    for (const SpectrumScale& scale : *scales)
        importance.segment(scale.begin, std::ssize(scale.frequencies)) *= scale.confidence;
    const Eigen::ArrayXd power = total(values, Eigen::VectorXd::Ones(channels));
    weight = (importance / (power + 0.01 * spectra.covariance().trace())).sqrt();
    Index column = 0;
    for (const MatrixEntry& entry : entries(channels))
        values.col(column++).array() *= factor(entry) * weight;
}

TargetSpectra TargetSpectra::reweighed(const std::vector<Wave>& waves) const {
    Eigen::ArrayXd error = residual(*this, waves).rowwise().norm().array() / weight;
    error += 0.1 * (importance * error).sum() / importance.sum();
    for (const SpectrumScale& scale : *scales) {
        const auto rows = Eigen::seqN(scale.begin, std::ssize(scale.frequencies));
        // An estimate from n windows errs by 1 / sqrt(n) of the power; its confidence is n / (n + 100).
        const double chance = std::sqrt((1 - scale.confidence) / (100 * scale.confidence));
        error(rows) += chance * importance(rows) / weight(rows).square();
    }
    TargetSpectra result = *this;
    const Eigen::ArrayXd change = (importance / error).sqrt() / weight;
    result.values.array().colwise() *= change;
    result.weight *= change;
    return result;
}

Eigen::MatrixXd residual(const TargetSpectra& target, const std::vector<Wave>& waves) {
    Eigen::MatrixXd left = target.values;
    add(left, waves, parts_of(waves, target.channels, target.scales, false, target.weight), 1, -1);
    return left;
}

// The weights that gain most are an eigenvector of the matrix of products of the residual and the new wave:
// the one with the largest eigenvalue.
Gain gain(const TargetSpectra& target, const Eigen::MatrixXd& left, const Eigen::Vector2d& frequency,
          const Eigen::Vector2d& radius) {
    const Parts parts =
        parts_of({{frequency, radius, {}}}, target.channels, target.scales, false, target.weight);
    const Eigen::RowVectorXd found = products(parts, left, target.channels);
    Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(target.channels, target.channels);
    Index at = 0;
    for (const MatrixEntry& entry : entries(target.channels)) {
        const double value = found[at++] / factor(entry);
        matrix(entry.d, entry.c) += entry.imaginary ? Complex(0, -value) : Complex(value); // the lower half
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(matrix);
    const double value = solver.eigenvalues()[target.channels - 1];
    const double square = parts.sum.squaredNorm();
    if (!(value > 0) || !(square > 0))
        return {0, Eigen::VectorXcd::Zero(target.channels)};
    return {value * value / square,
            std::sqrt(value / square) * solver.eigenvectors().col(target.channels - 1)};
}

Spectra model(const std::vector<Wave>& waves, int channels, const SpectrumScales& scales) {
    Spectra result(channels, scales);
    const Parts parts = parts_of(waves, channels, scales, false, Eigen::ArrayXd::Ones(result.values.rows()));
    add(result.values, waves, parts, 1, 1);
    Index column = 0;
    for (const MatrixEntry& entry : entries(channels))
        result.values.col(column++) /= factor(entry);
    return result;
}

void refine(const TargetSpectra& target, std::vector<Wave>& waves, FreeParameters free, int steps) {
    constexpr int most_trials = 6;
    const Index each = free == FreeParameters::all ? functions : 1;
    double lambda = 0.01;
    Parts parts;
    for (int s = 0; s < steps; ++s) {
        parts = parts_of(waves, target.channels, target.scales, free == FreeParameters::all, target.weight,
                         std::move(parts));
        Eigen::MatrixXd left = target.values;
        add(left, waves, parts, each, -1);
        const double cost = left.squaredNorm();
        const std::vector<Parameter> parameters = parameters_of(waves, free);
        Normal normal = normal_equations(parameters, parts, each, left, target.channels);
        const Eigen::VectorXd diagonal = damping(parameters, waves, normal);
        freeze_bounded(parameters, waves, target.largest_radius, normal);

        bool better = false;
        double gain = 0;
        for (int trial = 0; trial < most_trials && !better; ++trial) {
            Eigen::MatrixXd damped = normal.matrix;
            damped.diagonal() += lambda * diagonal;
            std::vector<Wave> next =
                moved(waves, damped.ldlt().solve(normal.slope), free, target.largest_radius);
            gain = cost - residual(target, next).squaredNorm();
            better = gain > 0;
            if (better)
                waves = std::move(next);
            lambda = better ? std::max(0.3 * lambda, 1e-7) : 4 * lambda;
        }
        if (gain < 1e-4 * cost)
            return;
    }
}

} // namespace gabor::fit
