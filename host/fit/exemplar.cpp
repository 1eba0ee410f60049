#include "fit/exemplar.hpp"

#include "error.hpp"
#include "image/picture.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace gabor::fit {

namespace {

// A deviation smaller than the rounding error of 16 bits counts as 0.
constexpr double least_deviation = 1e-5;
// Components with less than this share of the first component's deviation are left out.
constexpr double least_share = 0.01;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw RequestError(fmt::format("'{}' {}", path.string(), reason));
}

/// Reads rows of a picture as red, green and blue, or as one channel if the picture is grey.
class Rows {
  public:
    /// Pixels brighter than `limit` are fireflies.
    Rows(const std::filesystem::path& path, bool as_grey, float limit)
        : path_(path), picture_(image::open_picture(path)), limit_(limit),
          as_grey_(as_grey && picture_->format().channels == 3),
          row_(static_cast<std::size_t>(format().width) * static_cast<std::size_t>(format().channels)),
          seen_(static_cast<std::size_t>(format().width)) {}

    const image::PictureReader::Format& format() const { return picture_->format(); }
    /// 1 for each pixel of the row, or 0 if it is transparent or a firefly; its values are then 0 too.
    std::span<const float> seen() const { return seen_; }
    std::int64_t transparent() const { return transparent_; }
    std::int64_t fireflies() const { return fireflies_; }

    std::span<float> next() {
        picture_->read_row(row_);
        const std::span<const float> alpha = picture_->alpha();
        const auto channels = static_cast<std::size_t>(format().channels);
        for (std::size_t x = 0; x < seen_.size(); ++x) {
            const auto pixel = std::span(row_).subspan(x * channels, channels);
            const bool transparent = !alpha.empty() && !(alpha[x] > 0.5f);
            if (!transparent && !std::ranges::all_of(pixel, [](float value) { return std::isfinite(value); }))
                refuse(path_, "has a value that is not finite");
            const bool firefly = !transparent && std::ranges::max(pixel) > limit_;
            transparent_ += transparent ? 1 : 0;
            fireflies_ += firefly ? 1 : 0;
            seen_[x] = transparent || firefly ? 0.0f : 1.0f;
            if (seen_[x] == 0)
                std::ranges::fill(pixel, 0.0f);
            else if (as_grey_)
                row_[x] = pixel[0];
        }
        return as_grey_ ? std::span(row_).first(seen_.size()) : std::span(row_);
    }

  private:
    std::filesystem::path path_;
    std::unique_ptr<image::PictureReader> picture_;
    float limit_;
    bool as_grey_;
    std::vector<float> row_;
    std::vector<float> seen_;
    std::int64_t transparent_ = 0;
    std::int64_t fireflies_ = 0;
};

/// Counts pixels by their brightness.
class Brightness {
  public:
    void add(float value) { ++counts_[key(value)]; }

    /// Returns the limit above which pixels are fireflies: the 95 % quantile plus four times its distance
    /// from the 5 % quantile, and at least 1, which only pictures in OpenEXR exceed.
    float limit() const {
        const float low = quantile(0.05);
        const float high = quantile(0.95);
        return high > low ? std::max(high + 4 * (high - low), 1.0f) : std::numeric_limits<float>::infinity();
    }

  private:
    // The upper half of a float's bits, arranged so that keys are in the order of values.
    static std::uint32_t key(float value) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        return (bits >> 31 ? ~bits : bits | 0x80000000u) >> 16;
    }
    static float value(std::uint32_t key) {
        const std::uint32_t bits = key << 16;
        return std::bit_cast<float>(bits >> 31 ? bits & 0x7fffffffu : ~bits);
    }
    float quantile(double share) const {
        const auto all = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
        const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(all));
        std::uint32_t key = 0;
        for (std::uint64_t below = counts_[0]; below <= wanted && below < all; below += counts_[key])
            ++key;
        return value(key);
    }

    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(1 << 16);
};

// Finds the size, mean, trend and components of the picture. If `limit` is infinite and there are fireflies,
// returns nothing and sets the limit that leaves them out.
std::optional<Exemplar> first_pass(const std::filesystem::path& path, float& limit, const Advance& advance) {
    Rows rows(path, false, limit);
    const auto& format = rows.format();
    if (std::min(format.width, format.height) < least_side)
        refuse(path, fmt::format("has {} x {} pixels; a fit needs at least {} x {}", format.width,
                                 format.height, least_side, least_side));
    PixelSums sums(format.width, format.height, format.channels);
    Brightness brightness;
    float brightest = -std::numeric_limits<float>::infinity();
    bool grey = true;
    for (int y = 0; y < format.height; ++y) {
        const std::span<const float> row = rows.next();
        sums.add_row(row, rows.seen());
        const auto channels = static_cast<std::size_t>(format.channels);
        for (std::size_t x = 0; x < rows.seen().size(); ++x)
            if (rows.seen()[x] != 0) {
                const float value = std::ranges::max(row.subspan(x * channels, channels));
                brightness.add(value);
                brightest = std::max(brightest, value);
            }
        for (std::size_t i = 0; grey && format.channels == 3 && i < row.size(); i += 3)
            grey = row[i] == row[i + 1] && row[i] == row[i + 2];
        advance(static_cast<double>(y + 1) / format.height);
    }
    const double pixels = static_cast<double>(format.width) * format.height;
    if (static_cast<double>(rows.transparent()) == pixels)
        refuse(path, "is transparent everywhere");
    if (limit == std::numeric_limits<float>::infinity() && brightest > brightness.limit()) {
        limit = brightness.limit();
        return {};
    }
    const PixelStatistics found = sums.statistics();
    Exemplar exemplar;
    exemplar.width = format.width;
    exemplar.height = format.height;
    exemplar.channels = grey ? 1 : 3;
    exemplar.profile = format.profile;
    exemplar.linear = format.linear;
    exemplar.transparent = static_cast<double>(rows.transparent()) / pixels;
    exemplar.fireflies = static_cast<double>(rows.fireflies()) / pixels;
    exemplar.trend = found.trend;
    exemplar.trend.coefficients = found.trend.coefficients.leftCols(exemplar.channels).eval();
    exemplar.mean = found.mean.head(exemplar.channels);

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        found.covariance.topLeftCorner(exemplar.channels, exemplar.channels));
    const Eigen::VectorXd deviations = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    if (!(deviations[0] > least_deviation))
        refuse(path, "has no texture: apart from a smooth trend, all pixels are equal");
    const auto kept = (deviations.array() > least_share * deviations[0]).count();
    exemplar.components = solver.eigenvectors().rowwise().reverse().leftCols(kept);
    for (Eigen::Index c = 0; c < kept; ++c) {
        auto component = exemplar.components.col(c);
        component *= std::copysign(deviations[c], component.sum()); // positive values are brighter
    }
    return exemplar;
}

} // namespace

Exemplar read_exemplar(const std::filesystem::path& path, const Advance& advance) {
    float limit = std::numeric_limits<float>::infinity();
    const auto half = [&, done = 0.0](double share) mutable { advance(done = std::max(done, share / 2)); };
    std::optional<Exemplar> first = first_pass(path, limit, half);
    if (!first)
        first = first_pass(path, limit, half);
    Exemplar& exemplar = *first;
    const auto count = static_cast<int>(exemplar.components.cols());
    const Eigen::VectorXd variances = exemplar.components.colwise().squaredNorm();
    const Eigen::MatrixXf map =
        (variances.cwiseInverse().asDiagonal() * exemplar.components.transpose()).cast<float>();
    SpectraEstimate estimate(exemplar.width, exemplar.height, count);
    exemplar.histograms.resize(static_cast<std::size_t>(count));
    Rows rows(path, exemplar.channels == 1, limit);
    Structure structure(exemplar.width);
    Eigen::MatrixXf values(count, exemplar.width);
    std::vector<float> strongest(static_cast<std::size_t>(exemplar.width)); // the strongest component
    for (int y = 0; y < exemplar.height; ++y) {
        const std::span<float> row = rows.next();
        exemplar.trend.subtract(y, row);
        values.noalias() =
            map * Eigen::Map<const Eigen::MatrixXf>(row.data(), exemplar.channels, exemplar.width);
        const std::span<const float> seen = rows.seen();
        for (int x = 0; x < exemplar.width; ++x) {
            if (seen[static_cast<std::size_t>(x)] != 0) {
                strongest[static_cast<std::size_t>(x)] = values(0, x);
                for (int c = 0; c < count; ++c)
                    exemplar.histograms[static_cast<std::size_t>(c)].add(values(c, x));
            } else {
                strongest[static_cast<std::size_t>(x)] = std::numeric_limits<float>::quiet_NaN();
                values.col(x).setZero();
            }
        }
        structure.add_row(strongest);
        estimate.add_row({values.data(), static_cast<std::size_t>(values.size())}, seen);
        advance((1 + static_cast<double>(y + 1) / exemplar.height) / 2);
    }
    exemplar.spectra = estimate.spectra();
    exemplar.autocovariances = estimate.autocovariances(variances);
    exemplar.structure = structure.excess();
    return std::move(exemplar);
}

} // namespace gabor::fit
