// Tests the parts of a fit on spectra and values with known answers.

#include "../largest.hpp"
#include "fit/axis_spectrum.hpp"
#include "fit/fit.hpp"
#include "fit/structure.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <tuple>

using namespace gabor::fit;
using std::numbers::pi;

namespace {

// Hann's window, by its definition.
double hann(double x) {
    return std::abs(x) < 1 ? (1 + std::cos(pi * x)) / 2 : 0;
}

// The autocorrelation of Hann's window, by the midpoint rule.
double integrated_correlation(double t) {
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < 4000; ++i) {
        const double x = (i + 0.5) / 2000 - 1;
        sum += hann(x) * hann(x + t);
        squares += hann(x) * hann(x);
    }
    return sum / squares;
}

// The expected power E |sum_p w(p) n(p) e^(-2 pi i k p)|^2 / sum_p w(p)^2 of a noise n with autocovariance
// g(t / radius) e^(2 pi i frequency t), where w is Hann's window and g is integrated_correlation.
double expected_power(double k, double frequency, double radius) {
    std::vector<double> correlations;
    for (int t = 0; t < 64; ++t)
        correlations.push_back(integrated_correlation(t / radius));
    std::complex<double> sum = 0;
    double squares = 0;
    for (int p = 0; p < 64; ++p) {
        const double w = 0.5 - 0.5 * std::cos(2 * pi * p / 64);
        squares += w * w;
        for (int q = 0; q < 64; ++q) {
            const double v = 0.5 - 0.5 * std::cos(2 * pi * q / 64);
            sum += w * v * correlations[static_cast<std::size_t>(std::abs(p - q))] *
                   std::exp(std::complex<double>(0, 2 * pi * (frequency - k) * (p - q)));
        }
    }
    return sum.real() / squares;
}

// An exemplar whose components have variance 1 and exactly the spectra of the waves.
Exemplar exemplar_of(const std::vector<Wave>& waves, int side) {
    Exemplar exemplar;
    exemplar.width = exemplar.height = side;
    const Eigen::Index components = waves.front().weight.size();
    exemplar.channels = components == 1 ? 1 : 3;
    exemplar.mean = Eigen::VectorXd::Constant(exemplar.channels, 0.5);
    exemplar.components = Eigen::MatrixXd::Identity(exemplar.channels, components);
    for (Eigen::Index c = 0; c < components; ++c)
        exemplar.components.col(c) *= 0.2 / static_cast<double>(c + 1);
    exemplar.spectra = model(waves, static_cast<int>(components));
    exemplar.histograms.resize(static_cast<std::size_t>(components));
    for (Histogram& histogram : exemplar.histograms)
        for (int i = -100; i <= 100; ++i)
            histogram.add(static_cast<float>(i / 50.0));
    return exemplar;
}

Eigen::VectorXcd weights(std::initializer_list<std::complex<double>> values) {
    Eigen::VectorXcd result(std::ssize(values));
    std::copy(values.begin(), values.end(), result.begin());
    return result;
}

// Returns the wave whose frequency is nearest to that of `to` or of its mirror image, which is equivalent.
const Wave& nearest(const std::vector<Wave>& waves, const Wave& to) {
    const auto distance = [&](const Wave& wave) {
        return std::min((wave.frequency - to.frequency).norm(), (wave.frequency + to.frequency).norm());
    };
    return *std::min_element(waves.begin(), waves.end(),
                             [&](const Wave& a, const Wave& b) { return distance(a) < distance(b); });
}

// The mean square of a lobe's frequencies along an axis: the power spectrum of Hann's window has variance 1 /
// (12 radius^2).
double mean_square(const Wave& wave, int axis) {
    return std::pow(wave.frequency[axis], 2) + 1 / (12 * std::pow(wave.radius[axis], 2));
}

} // namespace

TEST_CASE("the correlation of kernels equals the integrated autocorrelation of Hann's window") {
    gabor::test::Largest largest;
    for (double t = -2.5; t <= 2.5; t += 0.05)
        largest.see(kernel_correlation(t), integrated_correlation(t), 1e-6,
                    [&] { return fmt::format("{}", t); });
    largest.check("correlation");
}

TEST_CASE("axis spectra equal the expected windowed spectra of a wave") {
    const SpectrumScale& scale = first_scale()->front();
    for (const auto& [frequency, radius] :
         {std::pair(0.0, 7.0), std::pair(0.31, 20.0), std::pair(-0.48, 2.5)}) {
        const AxisSpectrum spectrum = axis_spectrum(scale, 0, frequency, radius, true);
        gabor::test::Largest largest;
        for (int k = 0; k < 128; k += 9)
            largest.see(spectrum.value[k], expected_power(k / 128.0, frequency, radius), 1e-5,
                        [&] { return fmt::format("{} cycles / 128", k); });
        largest.check(fmt::format("frequency {}, radius {}", frequency, radius));

        constexpr double h = 1e-6;
        const Eigen::ArrayXd by_frequency = (axis_spectrum(scale, 0, frequency + h, radius, true).value -
                                             axis_spectrum(scale, 0, frequency - h, radius, true).value) /
                                            (2 * h);
        CHECK((by_frequency - spectrum.by_frequency).abs().maxCoeff() <
              1e-4 * spectrum.by_frequency.abs().maxCoeff());
        const Eigen::ArrayXd by_radius =
            (axis_spectrum(scale, 0, frequency, radius * std::exp(h), true).value -
             axis_spectrum(scale, 0, frequency, radius * std::exp(-h), true).value) /
            (2 * h);
        CHECK((by_radius - spectrum.by_log_radius).abs().maxCoeff() <
              1e-4 * spectrum.by_log_radius.abs().maxCoeff());
    }
}

TEST_CASE("axis spectra of averaged samples equal their expected windowed spectra") {
    // Samples four pixels apart are weighted averages of eight pixels, those 16 pixels apart of eight such
    // samples. The expected spectra are brute-force sums over every pair of pixels that contribute to two
    // samples of a window.
    const std::vector<SpectrumScale> scales = scales_of(4096, 4096);
    REQUIRE(scales.size() == 4);
    // A scale's weights add up to the area of its whole grid, in cells of the first scale.
    for (const SpectrumScale& each : scales)
        CHECK(measures({each}).sum() == Approx(std::pow(2.0 * window_side / each.spacing, 2)));
    const std::vector<double> triangle{1 / 32.0, 3 / 32.0, 5 / 32.0, 7 / 32.0,
                                       7 / 32.0, 5 / 32.0, 3 / 32.0, 1 / 32.0};
    std::vector<double> twice(4 * 7 + 8);
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
            twice[4 * i + j] += triangle[i] * triangle[j];
    for (const auto& [index, frequency, radius] :
         {std::tuple(2u, 0.004, 150.0), {2u, 0.21, 40.0}, {3u, 0.004, 150.0}}) {
        const SpectrumScale& scale = scales[index];
        REQUIRE(scale.spacing == (index == 2 ? 4 : 16));
        const std::vector<double>& averaging = index == 2 ? triangle : twice;
        const AxisSpectrum spectrum = axis_spectrum(scale, 0, frequency, radius, false);
        std::vector<std::complex<double>> covariance; // of samples
        for (int t = -(scale.window - 1); t < scale.window; ++t) {
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i < averaging.size(); ++i)
                for (std::size_t j = 0; j < averaging.size(); ++j) {
                    const int lag = scale.spacing * t + static_cast<int>(i) - static_cast<int>(j);
                    sum += averaging[i] * averaging[j] * kernel_correlation(lag / radius) *
                           std::exp(std::complex<double>(0, 2 * pi * frequency * lag));
                }
            covariance.push_back(static_cast<double>(scale.spacing) * sum * scale.lag_window[0][std::abs(t)]);
        }
        gabor::test::Largest largest;
        for (int k = 0; k < scale.grid; k += 5) {
            std::complex<double> sum = 0;
            for (int t = -(scale.window - 1); t < scale.window; ++t)
                sum += covariance[static_cast<std::size_t>(t + scale.window - 1)] *
                       std::exp(std::complex<double>(0, -2 * pi * k * t / scale.grid));
            largest.see(spectrum.value[k], sum.real(), 1e-9 * spectrum.value.maxCoeff(),
                        [&] { return fmt::format("frequency {} of {}", k, scale.grid); });
        }
        largest.check(fmt::format("frequency {}, radius {}", frequency, radius));
    }
}

TEST_CASE("a grey texture's lobes are found from its spectrum") {
    const std::vector<Wave> waves{
        {{0.11, 0.07}, {12, 5}, weights({0.7})},
        {{-0.21, 0.173}, {6, 18}, weights({0.45})},
        {{0.025, -0.0433}, {7.2, 7.2}, weights({0.45})}, // close to its mirror image
        {{0.0, 0.0}, {25, 25}, weights({0.324})}};       // powers add up to 1, like fitted powers
    const FittedNoise fitted = fit(exemplar_of(waves, 1 << 14), 16, [](double) {});
    for (const Wave& known : waves) {
        const Wave& found = nearest(fitted.waves, known);
        const double apart =
            std::min((found.frequency - known.frequency).norm(), (found.frequency + known.frequency).norm());
        INFO("frequency " << known.frequency.transpose() << ": off by " << apart << ", radius "
                          << found.radius.transpose() << " instead of " << known.radius.transpose()
                          << ", power " << found.weight.squaredNorm() << " instead of "
                          << known.weight.squaredNorm());
        CHECK(found.weight.squaredNorm() == Approx(known.weight.squaredNorm()).epsilon(0.1));
        if (known.frequency.isZero()) { // a lobe and its mirror image look like one lobe of smaller radius
            for (int axis : {0, 1})
                CHECK(mean_square(found, axis) == Approx(mean_square(known, axis)).epsilon(0.01));
            continue;
        }
        CHECK(apart < 0.0005);
        CHECK(found.radius.x() == Approx(known.radius.x()).epsilon(0.03));
        CHECK(found.radius.y() == Approx(known.radius.y()).epsilon(0.03));
    }
    CHECK(fitted.error.l1 < 0.02);
}

TEST_CASE("the errors show that a model's long waves are too strong") {
    const Wave noise{{0.2, 0.1}, {6, 6}, weights({0.8})};
    Wave swell{{0.004, 0}, {160, 90}, weights({0.6})};
    Exemplar exemplar = exemplar_of({noise, swell}, 1024);
    exemplar.components *= 3; // a variance of 0.36
    exemplar.spectra = model({noise, swell}, 1, std::make_shared<const std::vector<SpectrumScale>>([] {
                                 std::vector<SpectrumScale> scales = scales_of(1024, 1024);
                                 for (std::size_t i = 1; i < scales.size(); ++i)
                                     scales[i].begin =
                                         scales[i - 1].begin + std::ssize(scales[i - 1].frequencies);
                                 return scales;
                             }()));
    // On the last scale, whose samples are 4 pixels apart, the autocorrelation is exp(-t^2 / (2 14^2)).
    for (const SpectrumScale& scale : *exemplar.spectra.scales) {
        const auto t = Eigen::ArrayXd::LinSpaced(scale.lags(), 0, static_cast<double>(scale.lags() - 1));
        const Eigen::VectorXd along = 0.6 * (t.square() / -392).exp().matrix();
        exemplar.autocovariances.push_back({along * along.transpose(), along * along.transpose()});
    }
    const FitError none = fit_error(exemplar, {noise, swell});
    CHECK(exemplar.spectra.scales->back().spacing == 4);
    CHECK(none.chance == Approx(std::sqrt(pi) * 14 * 4 / 1024).epsilon(0.05)); // Bartlett's formula
    CHECK(none.l1 < 1e-9);
    CHECK(none.low < 1e-9);
    CHECK(none.low_share == Approx(0.36).epsilon(0.02));
    swell.weight *= std::sqrt(1.5);
    const FitError error = fit_error(exemplar, {noise, swell});
    CHECK(error.l1 == Approx(0.5 * 0.36).epsilon(0.01));
    CHECK(error.low == Approx(0.5).epsilon(0.01)); // the swell is the only long wave
}

TEST_CASE("lobes are added until chance can explain the error") {
    struct Limit {
        int width, height;
        double radius; // of the second lobe
        double FitError::*error;
        double least;
    };
    for (const Limit& limit : {Limit{160, 128, 3, &FitError::l1, 0.44 * 64 / std::sqrt(160 * 128)},
                               {1 << 14, 1 << 13, 3, &FitError::l1, 0.44 / 28},
                               {160, 128, 30, &FitError::l2, 0.38 * 64 / std::sqrt(160 * 128)},
                               {1 << 14, 1 << 13, 60, &FitError::l2, 0.0475}})
        for (const double share : {0.98, 1.02}) {
            const Wave first{{0.2, 0.1}, {8, 8}, weights({1})};
            Wave second{{-0.15, 0.3}, {limit.radius, limit.radius}, weights({0.3})};
            Exemplar exemplar;
            for (int i = 0; i < 20; ++i) {
                exemplar = exemplar_of({first, second}, limit.width);
                second.weight *= std::sqrt(share * limit.least / (fit_error(exemplar, {first}).*limit.error));
            }
            exemplar.height = limit.height;
            INFO(limit.width << " pixels, radius " << limit.radius << ", " << share << " of the limit");
            CHECK((fit(exemplar, 16, [](double) {}).waves.size() == 1) == (share < 1));
        }
}

TEST_CASE("frequencies near 0 become the lowest of a preset") {
    const Exemplar exemplar = exemplar_of({{{0, 0}, {2, 8}, weights({1})}}, 1024);
    const auto lobe = request_of(exemplar, fit(exemplar, 1, [](double) {})).lobes.at(0);
    CHECK(lobe.frequency == Approx(0.0011));
    CHECK(lobe.orientation == 0);
}

TEST_CASE("the squared error counts the spectra of two channels twice") {
    const Wave known{{0.12, 0.05}, {10, 10}, weights({0.7, 0.4, -0.3})};
    Wave other = known;
    other.weight = weights({0.6, -0.5, 0.6});
    const Exemplar exemplar = exemplar_of({known}, 1024);
    const auto matrix = [&](const Wave& wave) -> Eigen::MatrixXcd {
        const Eigen::VectorXcd colour = exemplar.components * wave.weight;
        return colour * colour.adjoint();
    };
    CHECK(fit_error(exemplar, {other}).l2 ==
          Approx((matrix(other) - matrix(known)).norm() / matrix(known).norm()).epsilon(1e-6));
}

TEST_CASE("phases between channels are found from cross-spectra") {
    using namespace std::complex_literals;
    const std::vector<Wave> waves{{{0.12, 0.05}, {10, 10}, weights({0.7, 0.5i, -0.3 + 0.4i})},
                                  {{-0.09, 0.2}, {8, 8}, weights({0.5, -0.6, 0.5})},
                                  {{0.27, -0.11}, {14, 14}, weights({0.4i, 0.5 + 0.2i, 0.5})}};
    const Exemplar exemplar = exemplar_of(waves, 1 << 14);
    const FittedNoise fitted = fit(exemplar, 16, [](double) {});
    CAPTURE(fitted.error.l1, fitted.error.l2, fitted.waves.size());
    CHECK(fitted.error.l2 < 0.02);

    // The covariance of the drawn colours is the identity, whatever the fit.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& w : fitted.colour.weights)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t d = 0; d < 3; ++d)
                covariance(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(d)) +=
                    w[c].quadrature * w[d].quadrature + w[c].noise * w[d].noise;
    CHECK((covariance - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("spectra under a linear map are those of the mapped channels") {
    using namespace std::complex_literals;
    const std::vector<Wave> waves{{{0.12, 0.05}, {10, 10}, weights({0.7, 0.5i, -0.3 + 0.4i})}};
    Eigen::Matrix3d map;
    map << 1, 2, -1, 0.5, -3, 0.25, 2, 0, 1;
    std::vector<Wave> mapped = waves;
    mapped.front().weight = map * mapped.front().weight;
    const Spectra direct = model(mapped, 3);
    const Spectra through = model(waves, 3).mapped(map);
    CHECK((direct.values - through.values).cwiseAbs().maxCoeff() < 1e-9);
    CHECK((direct.covariance() - map * model(waves, 3).covariance() * map.transpose()).cwiseAbs().maxCoeff() <
          1e-9);
}

TEST_CASE("the spectrum estimated from white noise is flat and has the noise's variance") {
    constexpr int side = 784; // the smallest side with a scale of averaged samples
    std::mt19937 generator(5);
    std::normal_distribution<float> normal;
    SpectraEstimate estimate(side, side, 2);
    std::vector<float> row(2 * side);
    const std::vector<float> seen(side, 1);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            row[static_cast<std::size_t>(2 * x)] = normal(generator);
            row[static_cast<std::size_t>(2 * x + 1)] =
                0.5f * row[static_cast<std::size_t>(2 * x)] + normal(generator);
        }
        estimate.add_row(row, seen);
    }
    const Spectra spectra = estimate.spectra();
    Eigen::Matrix2d expected;
    expected << 1, 0.5, 0.5, 1.25;
    const Eigen::MatrixXd covariance = spectra.covariance();
    INFO(covariance);
    CHECK((covariance - expected).cwiseAbs().maxCoeff() < 0.01);
    REQUIRE(spectra.scales->size() == 3);
    for (const SpectrumScale& scale : *spectra.scales) {
        const Eigen::VectorXd power =
            spectra.values.col(0).segment(scale.begin, std::ssize(scale.frequencies));
        INFO("windows of " << scale.length() << " pixels: mean " << power.mean() << ", from "
                           << power.minCoeff() << " to " << power.maxCoeff());
        CHECK(power.mean() == Approx(1).epsilon(0.1));
        if (scale.begin == 0) { // other scales average fewer windows
            CHECK(power.maxCoeff() < 1.6);
            CHECK(power.minCoeff() > 0.5);
        }
    }
}

TEST_CASE("large windows count for long waves and around peaks, also across the edges of the half plane") {
    constexpr int side = 448;
    constexpr int grid = side / 2;
    const std::vector<std::pair<int, int>> peaks{{49, -63}, {1, -70}, {grid / 2, 28}}; // cycles / grid
    std::mt19937 generator(5);
    std::normal_distribution<double> normal;
    SpectraEstimate estimate(side, side, 1);
    const std::vector<float> seen(side, 1);
    for (int y = 0; y < side; ++y) {
        std::vector<float> row;
        for (int x = 0; x < side; ++x) {
            double value = normal(generator);
            for (const auto& [kx, ky] : peaks)
                value += 0.2 * std::cos(2 * pi * (kx * x + ky * y) / grid + 1);
            row.push_back(static_cast<float>(value));
        }
        estimate.add_row(row, seen);
    }
    const std::vector<SpectrumScale> scales = *estimate.spectra().scales;
    REQUIRE(scales.size() == 2);
    REQUIRE(scales[1].grid == grid);
    std::vector<bool> chosen((grid / 2 + 1) * grid);
    for (const auto& [x, y, multiplicity] : scales[1].frequencies)
        chosen.at(static_cast<std::size_t>(y * (grid / 2 + 1) + x)) = true;
    std::string wrong;
    for (int y = 0; y < grid; ++y)
        for (int x = 0; x <= grid / 2; ++x) {
            int nearest = grid;
            for (const auto& [kx, ky] : peaks)
                for (const int sign : {1, -1})
                    nearest = std::min(
                        nearest, static_cast<int>(std::max(std::abs(std::remainder(x - sign * kx, grid)),
                                                           std::abs(std::remainder(y - sign * ky, grid)))));
            const bool is_long = std::max<double>(x, std::abs(std::remainder(y, grid))) <= 4 * grid / 64.0;
            if (chosen[static_cast<std::size_t>(y * (grid / 2 + 1) + x)] != (is_long || nearest <= 3))
                wrong += fmt::format(" ({}, {}, {})", x, y, nearest);
        }
    INFO("x, y, distance from a peak:" << wrong);
    CHECK(wrong.empty());
}

TEST_CASE("a histogram's polynomial is increasing, matches the distribution, and has mean 0 and variance 1") {
    const auto check = [](const std::array<double, 6>& c, double tolerance, auto law) {
        const auto value = [&](double z) {
            double sum = 0;
            for (std::size_t n = c.size(); n-- > 0;)
                sum = sum * z + c[n];
            return sum;
        };
        double mean = 0;
        double square = 0;
        gabor::test::Largest largest;
        for (double z = -8; z <= 8; z += 1.0 / 256) {
            const double p = std::exp(-z * z / 2) / std::sqrt(2 * pi) / 256;
            mean += p * value(z);
            square += p * value(z) * value(z);
            if (std::abs(z) < 2)
                largest.see(value(z), law(z), tolerance, [&] { return fmt::format("{}", z); });
            if (std::abs(z) < 4)
                REQUIRE(value(z + 1.0 / 256) >= value(z));
        }
        INFO("mean " << mean << ", mean square " << square);
        CHECK(std::abs(mean) < 1e-9);
        CHECK(square == Approx(1).epsilon(1e-9));
        largest.check("law");
    };
    std::mt19937 generator(7);
    std::normal_distribution<double> normal;
    Histogram cubic; // a histogram that a polynomial reproduces exactly
    const auto cube = [](double z) {
        return (z + 0.15 * (z * z - 1) + 0.05 * z * z * z) / std::sqrt(1.15 * 1.15 + 0.045 + 6 * 0.0025);
    };
    Histogram uniform; // a histogram that a polynomial does not reproduce exactly
    Histogram two;     // a histogram of only two values
    for (int i = 0; i < 200000; ++i) {
        const double z = normal(generator);
        cubic.add(static_cast<float>(cube(z)));
        uniform.add(static_cast<float>(std::sqrt(3) * std::erf(z / std::numbers::sqrt2)));
        two.add(z > 0 ? 1.0f : -1.0f);
    }
    check(cubic.polynomial(), 0.02, cube);
    check(uniform.polynomial(), 0.15,
          [](double z) { return std::sqrt(3) * std::erf(z / std::numbers::sqrt2); });
    check(two.polynomial(), 2, [](double z) { return z; });
}

TEST_CASE("only a quadratic trend is removed") {
    constexpr int width = 96;
    constexpr int height = 64;
    const auto trend = [](double u, double v) {
        return 0.3 + 0.1 * u - 0.2 * v + 0.05 * u * u + 0.07 * u * v - 0.1 * v * v;
    };
    std::mt19937 generator(3);
    std::uniform_real_distribution<float> uniform(-0.1f, 0.1f);
    std::vector<std::vector<float>> rows;
    const std::vector<float> all(width, 1);
    PixelSums with(width, height, 1);
    PixelSums without(width, height, 1);
    for (int y = 0; y < height; ++y) {
        std::vector<float> noise(width);
        std::vector<float> row(width);
        for (std::size_t x = 0; x < width; ++x) {
            noise[x] = uniform(generator);
            row[x] = noise[x] + static_cast<float>(trend((2.0 * static_cast<double>(x) + 1) / width - 1,
                                                         (2.0 * y + 1) / height - 1));
        }
        with.add_row(row, all);
        without.add_row(noise, all);
        rows.push_back(row);
        rows.push_back(noise);
    }
    const PixelStatistics a = with.statistics();
    const PixelStatistics b = without.statistics();
    CHECK(a.covariance(0, 0) == Approx(b.covariance(0, 0)).epsilon(1e-4));
    CHECK(a.covariance(0, 0) == Approx(0.04 / 12).epsilon(0.03));
    gabor::test::Largest largest;
    for (int y = 0; y < height; ++y) {
        std::vector<float>& left = rows[static_cast<std::size_t>(2 * y)];
        std::vector<float>& right = rows[static_cast<std::size_t>(2 * y + 1)];
        a.trend.subtract(y, left);
        b.trend.subtract(y, right);
        for (std::size_t x = 0; x < width; ++x)
            largest.see(left[x], right[x], 1e-5, [&] { return fmt::format("pixel {}, {}", x, y); });
    }
    largest.check("rows");

    // Two channels show the same texture under light of mean 1. Its contrast follows the root of the light.
    Trend light{width, height, Eigen::Matrix<double, 6, Eigen::Dynamic>(6, 2), 0.5};
    light.coefficients.col(0) << 0.3, 0.1, -0.2, 0.05, 0.07, -0.1;
    light.coefficients.col(1) = 2 * light.coefficients.col(0);
    gabor::test::Largest evened;
    for (int y = 0; y < height; ++y) {
        std::vector<float> row;
        std::vector<double> expected;
        for (int x = 0; x < width; ++x) {
            const double here = trend((2.0 * x + 1) / width - 1, (2.0 * y + 1) / height - 1);
            for (const double channel : {1.0, 2.0}) {
                row.push_back(static_cast<float>(channel * (here + 1)));
                expected.push_back(channel / std::sqrt(std::max(here / (0.3 - 0.05 / 3), 0.1)));
            }
        }
        light.subtract(y, row);
        for (std::size_t i = 0; i < row.size(); ++i)
            evened.see(row[i], expected[i], 1e-5, [&] { return fmt::format("value {} of row {}", i, y); });
    }
    evened.check("evened contrast");
}

TEST_CASE("warnings are given from their thresholds on") {
    Exemplar exemplar = exemplar_of({{{0.2, 0.1}, {6, 6}, weights({1})}}, 256);
    const auto warned = [&](const FitError& error) {
        std::string text;
        for (const std::string& line : warnings(exemplar, {{}, {}, error}))
            text += line.substr(0, line.find(' ', 10)) + ";";
        return text;
    };
    CHECK(warned({.l1 = 0.198, .low = 0.396, .low_share = 1, .autocorrelation = 0.198}).empty());
    CHECK(warned({.l1 = 0.202}) == "The noise differs;");
    CHECK(warned({.low = 0.404, .low_share = 1}) == "Large features;");
    CHECK(warned({.low = 0.5, .low_share = 0.00202}) == "Large features;");
    CHECK(warned({.low = 0.5, .low_share = 0.00198}).empty());
    CHECK(warned({.autocorrelation = 0.202, .chance = 0.05}) == "Something in;");
    CHECK(warned({.autocorrelation = 0.404, .chance = 0.1}) == "Something in;");
    CHECK(warned({.autocorrelation = 0.396, .chance = 0.1}).empty());
    exemplar.transparent = 0.25;
    CHECK(warnings(exemplar, {}).front() == "Left out 25 % of the pixels: they are transparent.");
}

TEST_CASE("a preset's unit of length is the strongest lobe's radius, unless other lobes are far from it") {
    struct Case {
        Eigen::Vector2d first, second;
        double unit;
    };
    for (const Case& radii : {Case{{16, 4}, {20, 3}, 8},
                              {{4, 4}, {4, 320}, 4},
                              {{1, 1.5}, {1, 1}, 2},
                              {{128, 128}, {100, 0.75}, 75},
                              {{9, 9}, {3000, 40}, 30}}) {
        const std::vector<Wave> waves{{{0.2, 0.1}, radii.first, weights({0.8})},
                                      {{0.1, 0.2}, radii.second, weights({0.6})}};
        CHECK(request_of(exemplar_of(waves, 256), {waves, {}, {}}).scale == Approx(radii.unit));
    }
}

TEST_CASE("structure distinguishes edges and ridges from waves and from normal noise") {
    constexpr int side = 128;
    const auto structure = [&](auto value, int rows = 128) {
        Structure result(side);
        std::vector<float> row(side);
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < side; ++x)
                row[static_cast<std::size_t>(x)] = static_cast<float>(value(x, y));
            result.add_row(row);
        }
        return result.excess();
    };
    std::mt19937 generator(9);
    std::normal_distribution<double> normal;
    CHECK(structure([&](int, int) { return normal(generator); }) < 0.5);
    CHECK(structure([](int x, int y) { return (x / 8 + y / 16) % 2; }) > Structure::limit);
    const auto edge = [](int x, int) { return x / 64; };
    CHECK(structure([&](int x, int y) { return edge(y, x); }) > Structure::limit);
    CHECK(structure(edge, 4) > Structure::limit); // derivatives need at least four rows
    CHECK(structure(edge, 3) == 0);
    // Kurtosis cannot tell four waves from their absolute value, which has creases.
    const auto waves = [](int x, int y) {
        const double w = 2 * pi / 24;
        return std::sin(w * x) + std::sin(w * (0.6 * x + 0.8 * y)) + std::sin(w * (0.8 * y - 0.6 * x)) +
               std::sin(w * y + 1);
    };
    CHECK(structure(waves) < Structure::limit);
    CHECK(structure([&](int x, int y) { return waves(y, x); }) == Approx(structure(waves)).epsilon(1e-4));
    for (const double sign : {1.0, -1.0})
        CHECK(structure([&](int x, int y) { return sign * std::abs(waves(x, y)); }) > 3 * Structure::limit);
}
