// gabor_noise_grid.hpp: fills a rectangle of pixels with the noise of gabor_noise.hpp, 5 to 10 times as fast
// as a loop over pixels.
//
//     GaborGrid grid;                                // 512 x 512 pixels, 32 per kernel radius
//     grid.wave = gabor_wave_vector(4.0f, 0.7854f);  // frequency and orientation
//     grid.seed = 7u;
//     std::vector<float> noise(512 * 512);
//     gabor_noise_grid(grid, noise.data());
//
// Values equal those of gabor_field at each pixel within 2e-5 up to frequency 20. Compile with -O3, and with
// -mavx2 or -march=native for twice the speed. Needs C++17 and 3 taps. Unlike its neighbours, this file is
// not a translation.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_GRID_HPP
#define GABOR_NOISE_GRID_HPP

#include "gabor_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

static_assert(GABOR_TAPS == 3, "gabor_noise_grid.hpp needs GABOR_TAPS 3");

struct GaborGrid {
    std::size_t width = 512;
    std::size_t height = 512;
    // Position of the first pixel in kernel radii, anywhere in a world of 2^32 nodes along each axis.
    double x = 0.5 / 32;
    double y = 0.5 / 32;
    double step = 1.0 / 32;               // kernel radii from pixel to pixel, above 0
    gabor_vec2 wave = gabor_vec2(0.0f);   // the wave vector in cycles per kernel radius
    gabor_vec2 period = gabor_vec2(0.0f); // kernel radii, as in gabor_place_tiled; 0 for none
    float evolution = 0.0f;               // in turns, as in gabor_noise_animated
    std::uint32_t seed = 0u;
};

// void gabor_noise_grid(const GaborGrid& grid, float* noise)
//     Writes height rows of width values.

// void gabor_noise_grid_quadrature(const GaborGrid& grid, float* noise, float* quadrature)
//     The noise and its quadrature.

// void gabor_noise_grid_gradient(const GaborGrid& grid, float* noise, float* along_x, float* along_y)
//     The noise and its derivatives per kernel radius.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Next to node (0, 0), the noise is Im sum_k X_k(x) sum_j Y_j(y) A_kj, where X_k(x) = K h(x - x_k) e^(2 pi i
// F_x (x - x_k)), and Y_j alike. The X_k of a column serve for all rows, and sum_j Y_j A_kj for all pixels of
// a row that are next to the same node: what is left for each pixel are three products.

// Complex numbers.
struct GaborGridNumbers {
    std::vector<float> real, imaginary;
    void resize(std::size_t size) {
        real.assign(size, 0.0f);
        imaginary.assign(size, 0.0f);
    }
    void set(std::size_t i, gabor_vec2 z) {
        real[i] = z.x;
        imaginary[i] = z.y;
    }
};

constexpr std::size_t gabor_impl_grid_lanes = 8; // loops of this length become vectors

// The pixels along an axis, in runs of pixels next to the same node.
struct GaborGridAxis {
    std::vector<std::size_t> run;                   // the first pixel of each run, and the number of pixels
    std::array<std::vector<std::uint32_t>, 3> word; // of the three nodes of each run
    std::array<GaborGridNumbers, 3> factor, slope;  // X_k of each pixel, and its derivative
};

inline GaborGridAxis gabor_impl_grid_axis(double first, double step, std::size_t count, int period,
                                          std::uint32_t salt, float wave, float radius, float scale) {
    GaborGridAxis axis;
    for (int k = 0; k < 3; ++k) {
        axis.factor[k].resize(count + gabor_impl_grid_lanes);
        axis.slope[k].resize(count + gabor_impl_grid_lanes);
    }
    std::int64_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = (first + static_cast<double>(i) * step) * static_cast<double>(radius),
                     cell = std::floor(at);
        const int index = static_cast<int>(static_cast<std::uint32_t>(static_cast<std::int64_t>(cell)));
        const float local = static_cast<float>(at - cell);
        const GaborImplAxis here = gabor_impl_axis(index, local, period, salt, wave, radius);
        const std::int64_t node = static_cast<std::int64_t>(cell) + (local >= 0.5f ? 1 : 0);
        if (i == 0 || node != before) {
            axis.run.push_back(i);
            for (int k = 0; k < 3; ++k)
                axis.word[k].push_back(here.word[k]);
        }
        before = node;
        const gabor_vec2 turn = scale * gabor_impl_wave(here.offset * here.turns);
        for (int k = 0; k < 3; ++k) {
            const gabor_vec4 both = here.node[k];
            const gabor_vec2 value = gabor_impl_product(both.xy(), turn);
            axis.factor[k].set(i, value);
            axis.slope[k].set(i, radius / GABOR_CELLS_PER_RADIUS * gabor_impl_product(both.zw(), turn) +
                                     6.2831853f * wave * gabor_vec2(-value.y, value.x));
        }
    }
    axis.run.push_back(count);
    return axis;
}

// The amplitudes of a row of nodes.
inline void gabor_impl_grid_amplitudes(const std::vector<std::uint32_t>& words, std::uint32_t row,
                                       float evolution, GaborGridNumbers& amplitudes) {
    float* const real = amplitudes.real.data();
    float* const imaginary = amplitudes.imaginary.data();
    if (evolution == 0.0f) // a loop that becomes vectors
        for (std::size_t i = 0; i < words.size(); ++i) {
            const gabor_vec2 z = gabor_impl_amplitude(words[i] * row);
            real[i] = z.x;
            imaginary[i] = z.y;
        }
    else
        for (std::size_t i = 0; i < words.size(); ++i)
            amplitudes.set(i, gabor_impl_amplitude_at(words[i] * row, evolution));
}

// For each run of columns, sum_j Y_j A_kj.
inline void gabor_impl_grid_row(const std::array<std::array<GaborGridNumbers, 3>, 3>& amplitude,
                                std::size_t runs, const std::array<GaborGridNumbers, 3>& y, std::size_t row,
                                std::array<GaborGridNumbers, 3>& sums) {
    for (int k = 0; k < 3; ++k) {
        float* const real = sums[k].real.data();
        float* const imaginary = sums[k].imaginary.data();
        const float *a = amplitude[0][k].real.data(), *b = amplitude[0][k].imaginary.data();
        const float *c = amplitude[1][k].real.data(), *d = amplitude[1][k].imaginary.data();
        const float *e = amplitude[2][k].real.data(), *f = amplitude[2][k].imaginary.data();
        const float p = y[0].real[row], q = y[0].imaginary[row], r = y[1].real[row], s = y[1].imaginary[row];
        const float t = y[2].real[row], u = y[2].imaginary[row];
        for (std::size_t i = 0; i < runs; ++i) {
            real[i] = a[i] * p - b[i] * q + c[i] * r - d[i] * s + e[i] * t - f[i] * u;
            imaginary[i] = a[i] * q + b[i] * p + c[i] * s + d[i] * r + e[i] * u + f[i] * t;
        }
    }
}

// For each pixel of a row, the imaginary or the real part of sum_k X_k times its run's sum. A run's last
// vector may reach into the next run, which is written later.
template <bool real_part>
inline void gabor_impl_grid_pixels(const GaborGridAxis& axis, const std::array<GaborGridNumbers, 3>& x,
                                   const std::array<GaborGridNumbers, 3>& sums, float* out) {
    const float *a = x[0].real.data(), *b = x[0].imaginary.data(), *c = x[1].real.data(),
                *d = x[1].imaginary.data();
    const float *e = x[2].real.data(), *f = x[2].imaginary.data();
    for (std::size_t r = 0; r + 1 < axis.run.size(); ++r) {
        const float re[3] = {sums[0].real[r], sums[1].real[r], sums[2].real[r]};
        const float im[3] = {sums[0].imaginary[r], sums[1].imaginary[r], sums[2].imaginary[r]};
        const float p = real_part ? re[0] : im[0], q = real_part ? -im[0] : re[0],
                    s = real_part ? re[1] : im[1];
        const float t = real_part ? -im[1] : re[1], u = real_part ? re[2] : im[2],
                    v = real_part ? -im[2] : re[2];
        for (std::size_t i = axis.run[r]; i < axis.run[r + 1]; i += gabor_impl_grid_lanes) {
            float block[gabor_impl_grid_lanes]; // which no input overlaps
            for (std::size_t lane = 0; lane < gabor_impl_grid_lanes; ++lane)
                block[lane] = p * a[i + lane] + q * b[i + lane] + s * c[i + lane] + t * d[i + lane] +
                              u * e[i + lane] + v * f[i + lane];
            std::copy_n(block, gabor_impl_grid_lanes, out + i);
        }
    }
}

// Fills those of the outputs that are not null.
inline void gabor_impl_grid(const GaborGrid& grid, float* quadrature, float* noise, float* along_x,
                            float* along_y) {
    const gabor_vec2 wave = gabor_cpp_clamp(grid.wave, -1.0e6f, 1.0e6f);
    const GaborPlace place = gabor_place_tiled(gabor_vec2(0.0f), grid.period);
    const std::uint32_t salt = gabor_impl_salt(grid.seed);
    const float scale = 1.0f / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    const GaborGridAxis x = gabor_impl_grid_axis(grid.x, grid.step, grid.width, place.period.x, salt, wave.x,
                                                 place.cells_per_radius.x, 1.0f);
    const GaborGridAxis y =
        gabor_impl_grid_axis(grid.y, grid.step, grid.height, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                             place.cells_per_radius.y, scale);
    const std::size_t runs = x.word[0].size();
    std::array<std::array<GaborGridNumbers, 3>, 3> amplitude; // [row][column] of the nine nodes
    std::array<GaborGridNumbers, 3> sums, sloping;
    for (int k = 0; k < 3; ++k) {
        sums[k].resize(runs);
        sloping[k].resize(runs);
        for (int j = 0; j < 3; ++j)
            amplitude[j][k].resize(runs);
    }
    std::vector<float> pixels(grid.width + gabor_impl_grid_lanes);
    const auto write = [&](float* out, std::size_t row, const std::array<GaborGridNumbers, 3>& factors,
                           const std::array<GaborGridNumbers, 3>& of, auto real_part) {
        gabor_impl_grid_pixels<decltype(real_part)::value>(x, factors, of, pixels.data());
        std::copy_n(pixels.data(), grid.width, out + row * grid.width);
    };
    for (std::size_t band = 0; band < y.word[0].size(); ++band) {
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                gabor_impl_grid_amplitudes(x.word[k], y.word[j][band], grid.evolution, amplitude[j][k]);
        for (std::size_t row = y.run[band]; row < y.run[band + 1]; ++row) {
            gabor_impl_grid_row(amplitude, runs, y.factor, row, sums);
            if (noise)
                write(noise, row, x.factor, sums, std::false_type());
            if (quadrature)
                write(quadrature, row, x.factor, sums, std::true_type());
            if (along_x)
                write(along_x, row, x.slope, sums, std::false_type());
            if (along_y) {
                gabor_impl_grid_row(amplitude, runs, y.slope, row, sloping);
                write(along_y, row, x.factor, sloping, std::false_type());
            }
        }
    }
}

inline void gabor_noise_grid(const GaborGrid& grid, float* noise) {
    gabor_impl_grid(grid, nullptr, noise, nullptr, nullptr);
}

inline void gabor_noise_grid_quadrature(const GaborGrid& grid, float* noise, float* quadrature) {
    gabor_impl_grid(grid, quadrature, noise, nullptr, nullptr);
}

inline void gabor_noise_grid_gradient(const GaborGrid& grid, float* noise, float* along_x, float* along_y) {
    gabor_impl_grid(grid, nullptr, noise, along_x, along_y);
}

#endif // GABOR_NOISE_GRID_HPP
