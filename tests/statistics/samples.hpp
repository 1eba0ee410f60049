#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Data with known statistics, from fixed seeds.
namespace samples {

std::vector<float> normal(std::size_t count, std::uint64_t seed, double mean = 0, double deviation = 1);

/// A normal variable bent into another distribution of unit variance,
/// g(x) = (x + c x^3) / sqrt(1 + 6 c + 15 c^2).
struct Bent {
    double c;

    double norm() const;
    double operator()(double x) const { return (x + c * x * x * x) / norm(); }

    /// Its Cramér-von Mises index, 2^18 times the integral of (F - Phi)^2 dPhi with F(g(x)) = Phi(x).
    double index() const;

    void apply(std::span<float> values) const;
};

/// A picture of a stationary normal process with mean 0 and variance 1: A cos(2 pi f.x) + B sin(2 pi f.x),
/// where A and B are white noise filtered by exp(-|d|^2 / (2 spread^2)). Its autocorrelation is exp(-|d|^2 /
/// (4 spread^2)) cos(2 pi f.d).
struct Lobe {
    double spread; ///< pixels
    double fx = 0; ///< cycles per pixel
    double fy = 0;
};

std::vector<float> picture(int width, int height, const Lobe& lobe, std::uint64_t seed);

} // namespace samples
