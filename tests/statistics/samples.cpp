#include "samples.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

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

    // Filters along rows, discards the margins, and exchanges rows and columns.
    const auto along = [&](const std::vector<float>& in, std::size_t rows) {
        const std::size_t columns = in.size() / rows, kept = columns - kernel.size() + 1;
        std::vector<float> out(kept * rows);
        for (std::size_t y = 0; y < rows; ++y)
            for (std::size_t k = 0; k < kernel.size(); ++k)
                for (std::size_t x = 0; x < kept; ++x)
                    out[x * rows + y] += kernel[k] * in[y * columns + x + k];
        return out;
    };
    const std::size_t margin = kernel.size() - 1, columns = static_cast<std::size_t>(width) + margin,
                      rows = static_cast<std::size_t>(height) + margin;
    return along(along(normal(columns * rows, seed), rows), columns - margin);
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
    const boost::math::normal normal;
    const auto square = [&](double x) {
        const double y = (*this)(x), slope = (1 + 3 * c * x * x) / norm();
        return std::pow(cdf(normal, x) - cdf(normal, y), 2) * pdf(normal, y) * slope;
    };
    return 262144 * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(square, -10.0, 10.0);
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
