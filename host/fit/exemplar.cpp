#include "fit/exemplar.hpp"

#include "error.hpp"
#include "image/picture.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace gabor::fit {

namespace {

// A deviation below that of the rounding of 16 bits is none.
constexpr double least_deviation = 1e-5;
// Components of less than this share of the first one's deviation are left out.
constexpr double least_share = 0.01;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw RequestError(fmt::format("'{}' {}", path.string(), reason));
}

/// Reads rows of a picture in the order red, green, blue, and as one channel where these are the same.
class Rows {
  public:
    Rows(const std::filesystem::path& path, bool as_grey)
        : path_(path), picture_(image::open_picture(path)),
          as_grey_(as_grey && picture_->format().channels == 3),
          row_(static_cast<std::size_t>(format().width) * static_cast<std::size_t>(format().channels)) {}

    const image::PictureReader::Format& format() const { return picture_->format(); }

    std::span<float> next() {
        picture_->read_row(row_);
        for (const float value : row_)
            if (!std::isfinite(value))
                refuse(path_, "has a value that is not finite: it takes a picture of numbers");
        if (!as_grey_)
            return row_;
        for (std::size_t x = 0; 3 * x < row_.size(); ++x)
            row_[x] = row_[3 * x];
        return std::span(row_).first(row_.size() / 3);
    }

  private:
    std::filesystem::path path_;
    std::unique_ptr<image::PictureReader> picture_;
    bool as_grey_;
    std::vector<float> row_;
};

// The first pass: size, mean, trend and covariance.
Exemplar first_pass(const std::filesystem::path& path, const Advance& advance) {
    Rows rows(path, false);
    const auto& format = rows.format();
    if (std::min(format.width, format.height) < least_side)
        refuse(path, fmt::format("has {} x {} pixels: it takes at least {} x {}, to tell waves from chance",
                                 format.width, format.height, least_side, least_side));
    PixelSums sums(format.width, format.height, format.channels);
    bool grey = true;
    for (int y = 0; y < format.height; ++y) {
        const std::span<const float> row = rows.next();
        sums.add_row(row);
        for (std::size_t i = 0; grey && format.channels == 3 && i < row.size(); i += 3)
            grey = row[i] == row[i + 1] && row[i] == row[i + 2];
        advance(static_cast<double>(y + 1) / format.height);
    }
    const Survey found = sums.survey();
    Exemplar exemplar;
    exemplar.width = format.width;
    exemplar.height = format.height;
    exemplar.channels = grey ? 1 : 3;
    exemplar.alpha = format.alpha;
    exemplar.trend = {format.width, format.height, found.trend.coefficients.leftCols(exemplar.channels)};
    exemplar.mean = found.mean.head(exemplar.channels);

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        found.covariance.topLeftCorner(exemplar.channels, exemplar.channels));
    const Eigen::VectorXd deviations = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    if (!(deviations[0] > least_deviation))
        refuse(path, "is constant, but for a trend: it takes a picture of a texture");
    const auto kept = (deviations.array() > least_share * deviations[0]).count();
    exemplar.components = solver.eigenvectors().rowwise().reverse().leftCols(kept);
    for (Eigen::Index c = 0; c < kept; ++c) {
        auto component = exemplar.components.col(c);
        component *= std::copysign(deviations[c], component.sum()); // up is brighter
    }
    return exemplar;
}

} // namespace

Eigen::MatrixXd to_components(const Exemplar& exemplar) {
    const Eigen::VectorXd variances = exemplar.components.colwise().squaredNorm();
    return variances.cwiseInverse().asDiagonal() * exemplar.components.transpose();
}

Exemplar read_exemplar(const std::filesystem::path& path, const Advance& advance) {
    Exemplar exemplar = first_pass(path, [&](double share) { advance(share / 2); });
    const auto count = static_cast<int>(exemplar.components.cols());
    const Eigen::MatrixXf map = to_components(exemplar).cast<float>();
    SpectraEstimate estimate(exemplar.width, exemplar.height, count);
    exemplar.quantiles.resize(static_cast<std::size_t>(count));
    Rows rows(path, exemplar.channels == 1);
    Structure structure(exemplar.width);
    Eigen::MatrixXf values(count, exemplar.width);
    const std::vector<float> seen(static_cast<std::size_t>(exemplar.width), 1);
    std::vector<float> first(static_cast<std::size_t>(exemplar.width));
    for (int y = 0; y < exemplar.height; ++y) {
        const std::span<float> row = rows.next();
        exemplar.trend.subtract(y, row);
        values.noalias() =
            map * Eigen::Map<const Eigen::MatrixXf>(row.data(), exemplar.channels, exemplar.width);
        estimate.add_row({values.data(), static_cast<std::size_t>(values.size())}, seen);
        for (int x = 0; x < exemplar.width; ++x)
            first[static_cast<std::size_t>(x)] = values(0, x);
        structure.add_row(first);
        for (int c = 0; c < count; ++c)
            for (int x = 0; x < exemplar.width; ++x)
                exemplar.quantiles[static_cast<std::size_t>(c)].add(values(c, x));
        advance((1 + static_cast<double>(y + 1) / exemplar.height) / 2);
    }
    exemplar.spectra = estimate.spectra();
    exemplar.autocovariances = estimate.autocovariances(exemplar.components.colwise().squaredNorm());
    exemplar.structure = structure.excess();
    return exemplar;
}

} // namespace gabor::fit
