#include "fit/greedy.hpp"

#include "fit/atoms.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gabor::fit {

namespace {

using Eigen::Index;

// All frequencies of the grid, from those of the half that is kept: opposite ones are the same, or negative.
Eigen::MatrixXf whole_plane(const Eigen::ArrayXd& half, float opposite) {
    Eigen::MatrixXf plane(grid_side, grid_side);
    for (int y = 0; y < grid_side; ++y)
        for (int x = 0; x < grid_side; ++x) {
            const bool kept = x < grid_columns;
            const int ky = kept ? y : (grid_side - y) % grid_side;
            const int kx = kept ? x : grid_side - x;
            plane(y, x) = (kept ? 1.0f : opposite) * static_cast<float>(half[ky * grid_columns + kx]);
        }
    return plane;
}

// The largest eigenvalue of a Hermitian matrix of at most three rows, by its characteristic polynomial [Smith
// 1961].
float largest_eigenvalue(const Eigen::Matrix3cf& m, int rows) {
    if (rows == 1)
        return m(0, 0).real();
    if (rows == 2) {
        const float middle = 0.5f * (m(0, 0).real() + m(1, 1).real());
        const float apart = 0.5f * (m(0, 0).real() - m(1, 1).real());
        return middle + std::sqrt(apart * apart + std::norm(m(0, 1)));
    }
    const float middle = m.trace().real() / 3;
    const Eigen::Matrix3cf rest = m - middle * Eigen::Matrix3cf::Identity();
    const float size = std::sqrt(rest.squaredNorm() / 6);
    if (!(size > 0))
        return middle;
    const float cosine = std::clamp((rest / size).determinant().real() / 2, -1.0f, 1.0f);
    return middle + 2 * size * std::cos(std::acos(cosine) / 3);
}

// How far apart frequencies need to be tried: lobes of narrow kernels are wide.
int stride_of(double radius) {
    return std::max(1, static_cast<int>(16 / radius));
}

} // namespace

Search::Search(const TargetSpectra& target) : channels_(target.channels), weight_(target.weight) {
    const Eigen::MatrixXf weight = whole_plane(target.weight.square() / multiplicities(), 1);
    for (double radius = smallest_radius; radius < 1.01 * target.largest_radius;
         radius *= std::numbers::sqrt2) {
        Scale scale;
        scale.radius = std::min(radius, target.largest_radius);
        const int stride = stride_of(radius);
        for (int k = -(grid_side / 2 - 1) / stride * stride; k <= grid_side / 2; k += stride)
            scale.rows.push_back(k);
        for (int k = 0; k <= grid_side / 2; k += stride)
            scale.columns.push_back(k);
        const Eigen::ArrayXd atom = axis_atom(0, scale.radius).value;
        const auto shifted = [&](const std::vector<int>& frequencies, int sign) {
            Eigen::MatrixXf rows(std::ssize(frequencies), grid_side);
            for (Index f = 0; f < rows.rows(); ++f)
                for (int k = 0; k < grid_side; ++k)
                    rows(f, k) = static_cast<float>(
                        atom[(k - sign * frequencies[static_cast<std::size_t>(f)] + 2 * grid_side) %
                             grid_side]);
            return rows;
        };
        scale.atoms_y = shifted(scale.rows, 1);
        scale.atoms_x = shifted(scale.columns, 1);
        // Of the atom with itself, and with its mirrored part: see `Parts` of the refinement.
        const Eigen::MatrixXf mirrored_y = scale.atoms_y.cwiseProduct(shifted(scale.rows, -1));
        const Eigen::MatrixXf mirrored_x = scale.atoms_x.cwiseProduct(shifted(scale.columns, -1));
        scale.square = 0.25f * (scale.atoms_y.cwiseAbs2() * weight * scale.atoms_x.cwiseAbs2().transpose() +
                                mirrored_y * weight * mirrored_x.transpose());
        scales_.push_back(std::move(scale));
    }
}

Wave Search::best(const Residual& left) const {
    const auto planes = [&](const Eigen::MatrixXd& columns, const std::vector<Pair>& pairs, float opposite) {
        std::vector<Eigen::MatrixXf> result;
        for (Index i = 0; i < columns.cols(); ++i) {
            const auto& [c, d] = pairs[static_cast<std::size_t>(i)];
            const double single = c == d ? 1 : 1 / std::numbers::sqrt2;
            result.push_back(
                whole_plane(single * columns.col(i).array() * weight_ / multiplicities(), opposite));
        }
        return result;
    };
    const std::vector<Pair> real = real_pairs(channels_);
    const std::vector<Pair> imaginary = imaginary_pairs(channels_);
    const std::vector<Eigen::MatrixXf> even = planes(left.real, real, 1);
    const std::vector<Eigen::MatrixXf> odd = planes(left.imaginary, imaginary, -1);

    // With the products C of residual and atom, a wave of weights W gains most where W is C's first
    // eigenvector.
    double most = 0;
    double gained = 0;
    Eigen::Matrix3cf products = Eigen::Matrix3cf::Zero();
    Wave wave{{0, 0}, smallest_radius, Eigen::VectorXcd::Zero(channels_)};
    Eigen::Matrix3cf at = Eigen::Matrix3cf::Zero();
    for (const Scale& scale : scales_) {
        const auto correlate = [&](const std::vector<Eigen::MatrixXf>& from) {
            std::vector<Eigen::MatrixXf> result;
            for (const Eigen::MatrixXf& plane : from)
                result.push_back(0.5f * (scale.atoms_y * plane * scale.atoms_x.transpose()));
            return result;
        };
        const std::vector<Eigen::MatrixXf> re = correlate(even);
        const std::vector<Eigen::MatrixXf> im = correlate(odd);
        for (Index x = 0; x < scale.square.cols(); ++x)
            for (Index y = 0; y < scale.square.rows(); ++y) {
                for (std::size_t i = 0; i < real.size(); ++i)
                    at(real[i].c, real[i].d) = re[i](y, x);
                for (std::size_t i = 0; i < imaginary.size(); ++i)
                    at(imaginary[i].c, imaginary[i].d).imag(im[i](y, x));
                for (const auto& [c, d] : imaginary)
                    at(d, c) = std::conj(at(c, d));
                const double value = largest_eigenvalue(at, channels_);
                const double gain = value > 0 ? value * value / scale.square(y, x) : 0;
                if (gain <= gained)
                    continue;
                gained = gain;
                most = value / scale.square(y, x);
                products = at;
                wave.frequency = {scale.columns[static_cast<std::size_t>(x)],
                                  scale.rows[static_cast<std::size_t>(y)]};
                wave.frequency /= grid_side;
                wave.radius = scale.radius;
            }
    }
    if (most > 0) {
        const Eigen::MatrixXcd block =
            products.topLeftCorner(channels_, channels_).cast<std::complex<double>>();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(block);
        wave.weight = std::sqrt(most) * solver.eigenvectors().col(channels_ - 1);
    }
    return wave;
}

} // namespace gabor::fit
