#pragma once

#include "reference/lattice.hpp"

namespace gabor::noise {

/// Mirrors the struct GaborFractal of shaders/gabor_fractal.glsl.
struct Fractal {
    double octaves = 1;
    double gain = 0.5;
    double lacunarity = 2;
    double turn = 0.64350111f;
    bool perlin = false;
    enum class Shape { fbm, billow, ridged } shape = Shape::fbm;
};

/// A symmetric matrix: xx, yy, xy or xx, yy, zz, xy, xz, yz.
template <std::size_t N>
using Symmetric = std::array<double, N*(N + 1) / 2>;

/// The steps to the next pixels, in kernel radii. The pixel is Gaussian, with a deviation of half of them.
template <std::size_t N>
struct Pixel {
    Vector<N> dx{}, dy{};
};

template <std::size_t N>
struct FractalNoise {
    double noise = 0;
    Vector<N> gradient{}; ///< per kernel radius
    double removed = 0;
    Symmetric<N> lost{};
    double crease = 1; ///< how close billows or ridges are to a crease, where their gradient jumps
};

/// The noise of gabor_fractal_noise and of gabor_fractal_noise_filtered in two or three dimensions, in double
/// precision, written from the equations and not from the shader. Without a pixel, nothing is filtered.
template <std::size_t N>
FractalNoise<N> fractal_noise(const Place<N>& place, const Fractal& fractal, std::uint32_t seed);
template <std::size_t N>
FractalNoise<N> fractal_noise(const Place<N>& place, const Pixel<N>& pixel, const Fractal& fractal,
                              std::uint32_t seed);

/// The windows (u, v) of a node's noise along an axis at a distance in node spacings. The squares of all
/// nodes' windows sum to 1.
Vector<2> fractal_windows(bool perlin, double variance, double distance);

/// The factors of filtered windows u and v.
Vector<2> fractal_kept(double variance);

/// How far the steps between octaves, in units of 1/4096, and the nodes in periods are from rounding to
/// others.
template <std::size_t N>
double rounding_margin(const Place<N>& place, const Fractal& fractal);

} // namespace gabor::noise
