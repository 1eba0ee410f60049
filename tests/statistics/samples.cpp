#include "samples.hpp"

#include "statistics/estimate.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace samples {

namespace {

/// White noise filtered by exp(-|d|^2 / (2 spread^2)), cut off at 4 spreads, with unit variance.
std::vector<float> smooth(int width, int height, double spread, std::uint64_t seed) {
    const int reach = static_cast<int>(std::ceil(4 * spread));
    std::vector<float> kernel;
    double squares = 0;
    for (int d = -reach; d <= reach; ++d) {
        kernel.push_back(static_cast<float>(std::exp(-d * d / (2 * spread * spread))));
        squares += kernel.back() * kernel.back();
    }
    for (float& tap : kernel)
        tap /= static_cast<float>(std::sqrt(squares));

    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t padded_columns = columns + kernel.size() - 1;
    const std::size_t padded_rows = rows + kernel.size() - 1;
    const std::vector<float> white = normal(padded_columns * padded_rows, seed);
    std::vector<float> along(columns * padded_rows);
    for (std::size_t y = 0; y < padded_rows; ++y)
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (std::size_t x = 0; x < columns; ++x)
                along[y * columns + x] += kernel[k] * white[y * padded_columns + x + k];
    std::vector<float> result(columns * rows);
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (std::size_t x = 0; x < columns; ++x)
                result[y * columns + x] += kernel[k] * along[(y + k) * columns + x];
    return result;
}

} // namespace

std::vector<float> normal(std::size_t count, std::uint64_t seed, double mean, double deviation) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> law;
    std::vector<float> values(count);
    for (float& value : values)
        value = static_cast<float>(mean + deviation * law(generator));
    return values;
}

double Bent::norm() const {
    return std::sqrt(1 + 6 * c + 15 * c * c);
}

double Bent::index() const {
    using gabor::statistics::normal_cdf;
    using gabor::statistics::normal_density;
    const int places = 20000; // points of the midpoint rule over x in [-10, 10]
    const double step = 20.0 / places;
    double sum = 0;
    for (int i = 0; i < places; ++i) {
        const double x = -10 + (i + 0.5) * step;
        const double y = (*this)(x);
        const double slope = (1 + 3 * c * x * x) / norm();
        const double d = normal_cdf(x) - normal_cdf(y);
        sum += d * d * normal_density(y) * slope * step;
    }
    return 262144 * sum;
}

void Bent::apply(std::span<float> values) const {
    for (float& value : values)
        value = static_cast<float>((*this)(value));
}

std::vector<float> picture(int width, int height, const Lobe& lobe, std::uint64_t seed) {
    std::vector<float> a = smooth(width, height, lobe.spread, 2 * seed);
    if (lobe.fx == 0 && lobe.fy == 0)
        return a;
    const std::vector<float> b = smooth(width, height, lobe.spread, 2 * seed + 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = static_cast<double>(i % static_cast<std::size_t>(width));
        const double y = static_cast<double>(i / static_cast<std::size_t>(width));
        const double phase = 2 * std::numbers::pi * (lobe.fx * x + lobe.fy * y);
        a[i] = static_cast<float>(a[i] * std::cos(phase) + b[i] * std::sin(phase));
    }
    return a;
}

} // namespace samples
