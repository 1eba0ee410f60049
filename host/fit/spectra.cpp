#include "fit/spectra.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace gabor::fit {

namespace {

// The largest side of a window, in samples, and the smallest one that is worth an estimate.
constexpr int large_window = 256;
constexpr int least_window = 32;
// Decimates by 4 with a triangle filter of eight samples.
constexpr int decimation = 4;
constexpr std::array<double, 2 * decimation> triangle{1 / 32.0, 3 / 32.0, 5 / 32.0, 7 / 32.0,
                                                      7 / 32.0, 5 / 32.0, 3 / 32.0, 1 / 32.0};

int decimated(int length) {
    return (length - static_cast<int>(triangle.size())) / decimation + 1;
}

Eigen::ArrayXd autocorrelation(const Eigen::ArrayXd& values) {
    Eigen::ArrayXd result(values.size());
    for (Eigen::Index t = 0; t < values.size(); ++t)
        result[t] = (values.head(values.size() - t) * values.tail(values.size() - t)).sum();
    return result;
}

// The weights of pixels in a sample, which results from repeated decimation.
Eigen::ArrayXd averaging_weights(int spacing) {
    Eigen::ArrayXd weights = Eigen::ArrayXd::Ones(1);
    for (int s = 1; s < spacing; s *= decimation) {
        const Eigen::Index size = std::ssize(triangle);
        Eigen::ArrayXd next = Eigen::ArrayXd::Zero(weights.size() + (size - 1) * s);
        for (Eigen::Index i = 0; i < size; ++i)
            next.segment(i * s, weights.size()) += triangle[static_cast<std::size_t>(i)] * weights;
        weights = next;
    }
    return weights;
}

Eigen::ArrayXd hann_window(int side) {
    Eigen::ArrayXd hann(side);
    for (int i = 0; i < side; ++i)
        hann[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / side);
    return hann;
}

SpectrumScale make_scale(int spacing, int window, int grid) {
    SpectrumScale scale{.spacing = spacing, .window = window, .grid = grid};
    scale.area = std::pow(2.0 * window_side / (grid * spacing), 2);
    const Eigen::ArrayXd hann = hann_window(window);
    scale.lag_window.fill(autocorrelation(hann / hann.matrix().norm()));
    scale.averaging = autocorrelation(averaging_weights(spacing));
    scale.cosine.resize(grid, window);
    scale.sine.resize(grid, window);
    for (int k = 0; k < grid; ++k)
        for (int t = 0; t < window; ++t) {
            const double phase = 2 * std::numbers::pi * (k * t % grid) / grid;
            scale.cosine(k, t) = std::cos(phase);
            scale.sine(k, t) = std::sin(phase);
        }
    for (int y = 0; y < grid; ++y)
        for (int x = 0; x <= grid / 2; ++x)
            scale.frequencies.push_back({x, y, x == 0 || 2 * x == grid ? 1.0 : 2.0});
    return scale;
}

// The total power of all channels at any frequency of a grid.
class Power {
  public:
    Power() = default;
    Power(const SpectrumScale& scale, const Eigen::MatrixXd& values, int channels)
        : grid_(scale.grid), values_(total(values, Eigen::VectorXd::Ones(channels))) {}

    double at(int x, int y) const {
        x = (x + grid_) % grid_;
        y = (y + grid_) % grid_;
        if (2 * x > grid_) {
            x = grid_ - x;
            y = (grid_ - y) % grid_;
        }
        return values_[y * (grid_ / 2 + 1) + x];
    }
    /// The mean power in a square of 3 x 3 frequencies.
    double around(int x, int y) const {
        double sum = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                sum += at(x + dx, y + dy);
        return sum / 9;
    }

  private:
    int grid_ = 0;
    Eigen::ArrayXd values_;
};

// The rows of a scale's frequencies that windows of the previous scale cannot resolve: those of long waves,
// and those around peaks that rise above the spectrum seen by these windows.
std::vector<Eigen::Index> unresolved(const SpectrumScale& scale, const Power& fine,
                                     const SpectrumScale& before, const Power& coarse) {
    constexpr double peak = 2.5;
    constexpr double highest = 0.2; // cycles per sample; averaging attenuates higher frequencies
    constexpr std::size_t most = 4096;
    const int grid = scale.grid;
    const int low = 4 * grid * scale.spacing / before.length();
    const double step = static_cast<double>(before.grid * before.spacing) / (grid * scale.spacing);
    const auto centered = [&](int k) { return 2 * k > grid ? k - grid : k; };
    const int columns = grid / 2 + 1;
    std::vector<bool> chosen(scale.frequencies.size());
    std::vector<std::pair<double, Eigen::Index>> peaks;
    for (std::size_t row = 0; row < chosen.size(); ++row) {
        const auto& [x, y, multiplicity] = scale.frequencies[row];
        const int ky = centered(y);
        chosen[row] = std::max(x, std::abs(ky)) <= low;
        if (chosen[row] || (scale.spacing > 1 && std::max(x, std::abs(ky)) > highest * grid))
            continue;
        const double power = fine.around(x, ky);
        if (power > peak * coarse.at(static_cast<int>(std::lround(x * step)),
                                     static_cast<int>(std::lround(ky * step))))
            peaks.emplace_back(power, static_cast<Eigen::Index>(row));
    }
    std::ranges::sort(peaks, std::greater());
    peaks.resize(std::min(peaks.size(), most / 8));
    for (const auto& [power, row] : peaks)
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx) {
                const auto x = static_cast<int>(row % columns) + dx;
                const auto y = (static_cast<int>(row / columns) + dy + grid) % grid;
                if (x >= 0 && x < columns)
                    chosen[static_cast<std::size_t>(y * columns + x)] = true;
            }
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < chosen.size(); ++row)
        if (chosen[row])
            rows.push_back(static_cast<Eigen::Index>(row));
    return rows;
}

} // namespace

const SpectrumScales& first_scale() {
    static const SpectrumScales scales = [] {
        return std::make_shared<const std::vector<SpectrumScale>>(
            1, make_scale(1, window_side, 2 * window_side));
    }();
    return scales;
}

std::vector<SpectrumScale> scales_of(int width, int height) {
    std::vector<SpectrumScale> scales{first_scale()->front()};
    int side = std::min(width, height);
    for (int spacing = 1; side / 2 >= least_window; spacing *= decimation, side = decimated(side)) {
        const int window = std::min(large_window, side / 32 * 16); // multiples of 16 have fast transforms
        if (spacing * window >= 1.5 * scales.back().length())
            scales.push_back(make_scale(spacing, window, window));
        if (side < static_cast<int>(triangle.size()))
            break;
    }
    for (SpectrumScale& scale : scales) {
        // A Hann window's squared autocorrelation adds up to nearly half its side.
        const double windows = static_cast<double>(width) * height / std::pow(0.468 * scale.length(), 2);
        scale.confidence = windows / (windows + 100);
    }
    return scales;
}

std::vector<MatrixEntry> entries(int channels) {
    std::vector<MatrixEntry> result;
    for (const bool imaginary : {false, true})
        for (int c = 0; c < channels; ++c)
            for (int d = imaginary ? c + 1 : c; d < channels; ++d)
                result.push_back({c, d, imaginary});
    return result;
}

Eigen::ArrayXd measures(const std::vector<SpectrumScale>& scales) {
    std::vector<double> result;
    for (const SpectrumScale& scale : scales)
        for (const SpectrumScale::Frequency& frequency : scale.frequencies)
            result.push_back(frequency.multiplicity * scale.area);
    return Eigen::Map<const Eigen::ArrayXd>(result.data(), std::ssize(result));
}

Spectra::Spectra(int count, const SpectrumScales& of) : channels(count), scales(of) {
    const Eigen::Index rows = scales->back().begin + std::ssize(scales->back().frequencies);
    values = Eigen::MatrixXd::Zero(rows, count * count);
}

Eigen::ArrayXd total(const Eigen::MatrixXd& values, const Eigen::VectorXd& weights) {
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(values.rows());
    Eigen::Index column = 0;
    for (Eigen::Index c = 0; c < weights.size(); column += weights.size() - c++) // the diagonal
        sum += weights[c] * values.col(column).array();
    return sum;
}

Eigen::MatrixXd Spectra::covariance() const {
    const std::vector<SpectrumScale> first{scales->front()};
    const Eigen::VectorXd weight = measures(first) / (first.front().grid * first.front().grid);
    const Eigen::VectorXd integral = values.topRows(weight.size()).transpose() * weight;
    Eigen::MatrixXd result(channels, channels);
    Eigen::Index at = 0;
    for (int c = 0; c < channels; ++c)
        for (int d = c; d < channels; ++d)
            result(c, d) = result(d, c) = integral[at++];
    return result;
}

Spectra Spectra::mapped(const Eigen::MatrixXd& map) const {
    Spectra result(static_cast<int>(map.rows()), scales);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(values.cols(), result.values.cols());
    Eigen::Index column = 0;
    for (const auto& [c, d, imaginary] : entries(result.channels)) {
        Eigen::Index row = 0;
        for (const auto& [a, b, of_imaginary] : entries(channels)) {
            const double mirrored = a == b ? 0 : (imaginary ? -1 : 1) * map(c, b) * map(d, a);
            if (imaginary == of_imaginary)
                matrix(row, column) = map(c, a) * map(d, b) + mirrored;
            ++row;
        }
        ++column;
    }
    result.values = values * matrix;
    return result;
}

/// Welch's estimate on one scale, at all frequencies of its grid.
class SpectraEstimate::Welch {
  public:
    Welch(SpectrumScale& scale, int width, int height, int channels)
        : scale_(&scale), channels_(channels), margin_(scale.window / 2),
          segments_(width + scale.window, height + scale.window, channels + 1, scale.window,
                    (scale.window + 2) /
                        3), // squares of windows a third of their side apart add up to a constant
          padded_(static_cast<std::size_t>((width + scale.window) * (channels + 1))), rows_left_(height),
          window_(static_cast<std::size_t>(scale.grid) * static_cast<std::size_t>(scale.grid)),
          transform_(scale.grid), transformed_(static_cast<std::size_t>(channels)),
          sums_(Eigen::MatrixXd::Zero(std::ssize(scale.frequencies), channels * channels)) {
        scale.lag_window = {seen_window(segments_.columns(), width), seen_window(segments_.lines(), height)};
        weight_ = {seen_weights(segments_.columns(), width), seen_weights(segments_.lines(), height)};
        for (int y = 0; y < margin_; ++y)
            segments_.add_row(padded_);
    }

    /// Adds the next row: for each sample its channels, then whether it is seen.
    void add_row(std::span<const float> row) {
        std::ranges::copy(row, padded_.begin() + margin_ * (channels_ + 1));
        add_padded();
        if (--rows_left_ > 0)
            return;
        std::ranges::fill(padded_, 0.0f);
        for (int y = 0; y < scale_->window - margin_; ++y)
            add_padded();
    }

    int windows() const { return windows_; }
    /// The mean of the windows' cross-spectra.
    Eigen::MatrixXd mean() const { return sums_ * (scale_->spacing * scale_->spacing / power_); }

  private:
    /// For windows that begin at `begins` along an axis of `length` samples, returns the sum and the sum of
    /// squares of the weights that lie within the picture.
    std::vector<std::array<double, 2>> seen_weights(const std::vector<int>& begins, int length) const {
        std::vector<std::array<double, 2>> result;
        for (const int begin : begins) {
            const Eigen::ArrayXd seen = seen_part(begin, length);
            result.push_back({seen.sum(), seen.square().sum()});
        }
        return result;
    }

    Eigen::ArrayXd seen_window(const std::vector<int>& begins, int length) const {
        Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(scale_->window);
        for (const int begin : begins)
            sum += autocorrelation(seen_part(begin, length));
        return sum / sum[0];
    }

    Eigen::ArrayXd seen_part(int begin, int length) const {
        Eigen::ArrayXd hann = hann_window(scale_->window);
        for (int i = 0; i < scale_->window; ++i)
            if (begin + i < margin_ || begin + i >= margin_ + length)
                hann[i] = 0;
        return hann;
    }

    void add_padded() {
        const std::span<const int> columns = segments_.add_row(padded_);
        for (std::size_t i = 0; i < columns.size(); ++i)
            add_window(columns[i], weight_[0][i], weight_[1][band_]);
        if (!columns.empty())
            ++band_;
    }

    void add_window(int left, const std::array<double, 2>& across, const std::array<double, 2>& down) {
        const int channels = channels_;
        segments_.copy_windowed(left, channels, window_, scale_->grid);
        double seen = 0;
        for (const float value : window_)
            seen += static_cast<double>(value);
        if (!(seen >= 0.9 * across[0] * down[0]) || seen == 0)
            return;
        ++windows_;
        power_ += across[1] * down[1];
        for (int c = 0; c < channels; ++c) {
            segments_.copy_windowed(left, c, window_, scale_->grid);
            const auto values = transform_(window_);
            transformed_[static_cast<std::size_t>(c)] =
                Eigen::Map<const Eigen::ArrayXcf>(values.data(), std::ssize(values));
        }
        Eigen::Index column = 0;
        for (const auto& [c, d, imaginary] : entries(channels)) {
            const auto product = transformed_[static_cast<std::size_t>(c)] *
                                 transformed_[static_cast<std::size_t>(d)].conjugate();
            if (imaginary)
                sums_.col(column++).array() += product.imag().cast<double>();
            else
                sums_.col(column++).array() += product.real().cast<double>();
        }
    }

    const SpectrumScale* scale_;
    int channels_;
    int margin_; ///< samples added on each side of the picture
    statistics::Segments segments_;
    std::vector<float> padded_; ///< a row with its margins
    int rows_left_;
    std::array<std::vector<std::array<double, 2>>, 2> weight_; ///< seen_weights of columns and of rows
    std::size_t band_ = 0;
    double power_ = 0;          ///< sum of the windows' squared weights
    std::vector<float> window_; ///< the rest of the grid stays 0
    statistics::FourierTransform transform_;
    std::vector<Eigen::ArrayXcf> transformed_; ///< transform of each channel
    Eigen::MatrixXd sums_;                     ///< sum of the windows' cross-spectra
    int windows_ = 0;
};

/// Filters with the triangle along both axes and keeps every fourth value.
class SpectraEstimate::Decimation {
  public:
    Decimation(int width, int values)
        : values_(values), columns_(decimated(width)), sums_(2, Eigen::ArrayXf::Zero(columns_ * values)) {}

    /// Adds the next row. Returns the row of averages that it completes, if any.
    std::optional<std::span<const float>> add_row(std::span<const float> row) {
        Eigen::ArrayXf across = Eigen::ArrayXf::Zero(columns_ * values_);
        for (int x = 0; x < columns_; ++x)
            for (std::size_t i = 0; i < triangle.size(); ++i)
                across.segment(x * values_, values_) +=
                    static_cast<float>(triangle[i]) *
                    Eigen::Map<const Eigen::ArrayXf>(
                        row.data() + (decimation * x + static_cast<std::ptrdiff_t>(i)) * values_, values_);
        const int phase = row_++ % decimation;
        sums_[1] += static_cast<float>(triangle[static_cast<std::size_t>(phase)]) * across;
        sums_[0] += static_cast<float>(triangle[static_cast<std::size_t>(decimation + phase)]) * across;
        if (phase + 1 < decimation)
            return {};
        std::swap(sums_[0], complete_);
        std::swap(sums_[0], sums_[1]);
        sums_[1].setZero(columns_ * values_);
        if (row_ == decimation) // this row got only the second half of the triangle
            return {};
        return std::span<const float>(complete_.data(), static_cast<std::size_t>(complete_.size()));
    }

  private:
    int values_;
    Eigen::Index columns_;
    std::vector<Eigen::ArrayXf> sums_; ///< sums of incomplete rows, the older one first
    Eigen::ArrayXf complete_;
    int row_ = 0;
};

SpectraEstimate::SpectraEstimate(int width, int height, int channels)
    : channels_(channels), scales_(scales_of(width, height)) {
    for (int spacing = 1, w = width, h = height; spacing <= scales_.back().spacing;
         spacing *= decimation, w = decimated(w), h = decimated(h)) {
        for (SpectrumScale& scale : scales_)
            if (scale.spacing == spacing)
                estimates_.emplace_back(scale, w, h, channels);
        if (spacing < scales_.back().spacing)
            decimations_.emplace_back(w, channels + 1);
    }
}

SpectraEstimate::~SpectraEstimate() = default;

void SpectraEstimate::add_row(std::span<const float> row, std::span<const float> seen) {
    std::vector<float> samples;
    samples.reserve(row.size() + seen.size());
    for (std::size_t x = 0; x < seen.size(); ++x) {
        const auto pixel =
            row.subspan(x * static_cast<std::size_t>(channels_), static_cast<std::size_t>(channels_));
        samples.insert(samples.end(), pixel.begin(), pixel.end());
        samples.push_back(seen[x]);
    }
    std::span<const float> next = samples;
    for (int level = 0, spacing = 1;; ++level, spacing *= decimation) {
        for (std::size_t i = 0; i < scales_.size(); ++i)
            if (scales_[i].spacing == spacing)
                estimates_[i].add_row(next);
        if (level == std::ssize(decimations_))
            return;
        const auto averages = decimations_[static_cast<std::size_t>(level)].add_row(next);
        if (!averages)
            return;
        next = *averages;
    }
}

Spectra SpectraEstimate::spectra() const {
    std::vector<SpectrumScale> kept;
    std::vector<Eigen::MatrixXd> values;
    Power coarse;
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const Welch& estimate = estimates_[i];
        if (estimate.windows() == 0)
            continue;
        if (i > 0 && kept.empty())
            break;
        SpectrumScale scale = scales_[i];
        Eigen::MatrixXd mean = estimate.mean();
        const Power fine(scale, mean, channels_);
        if (i > 0) {
            const std::vector<Eigen::Index> rows = unresolved(scale, fine, kept.back(), coarse);
            std::vector<SpectrumScale::Frequency> frequencies;
            for (const Eigen::Index row : rows)
                frequencies.push_back(scale.frequencies[static_cast<std::size_t>(row)]);
            scale.frequencies = std::move(frequencies);
            scale.begin = kept.back().begin + std::ssize(kept.back().frequencies);
            mean = Eigen::MatrixXd(mean(rows, Eigen::all));
        }
        coarse = fine;
        kept.push_back(std::move(scale));
        values.push_back(std::move(mean));
    }
    if (kept.empty())
        throw RequestError(fmt::format("the picture has no opaque area of {0} x {0} pixels", window_side));
    Spectra result(channels_, std::make_shared<const std::vector<SpectrumScale>>(kept));
    for (std::size_t i = 0; i < kept.size(); ++i)
        result.values.middleRows(kept[i].begin, values[i].rows()) = values[i];
    return result;
}

// The inverse transform of the power at all frequencies of the grid.
std::vector<Autocovariance> SpectraEstimate::autocovariances(const Eigen::VectorXd& weights) const {
    std::vector<Autocovariance> result;
    for (std::size_t i = 0; i < scales_.size() && estimates_[i].windows() > 0; ++i) {
        const SpectrumScale& scale = scales_[i];
        const Eigen::Index columns = scale.grid / 2 + 1;
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> power(scale.grid, columns);
        const Eigen::ArrayXd mean = total(estimates_[i].mean(), weights);
        Eigen::Index row = 0;
        for (const SpectrumScale::Frequency& k : scale.frequencies)
            power(k.y, k.x) = k.multiplicity * mean[row++];
        power /= std::pow(scale.grid * scale.spacing, 2);
        const Eigen::MatrixXd cosines = scale.cosine.leftCols(scale.lags()).transpose() * power *
                                        scale.cosine.topLeftCorner(columns, scale.lags());
        const Eigen::MatrixXd sines = scale.sine.leftCols(scale.lags()).transpose() * power *
                                      scale.sine.topLeftCorner(columns, scale.lags());
        result.push_back({cosines - sines, cosines + sines});
    }
    return result;
}

} // namespace gabor::fit
