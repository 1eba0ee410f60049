// gabor_fractal_points.hpp: the noise of gabor_fractal.hpp at many points, 5 to 10 times as fast as a loop
// over them.
//
//     std::vector<GaborPlace> place;  // of each point, such as gabor_place_at({x, y})
//     std::vector<float> noise(place.size());
//     gabor_fractal_points(place.data(), place.size(), gabor_fractal(5.0f, 0.5f), 7u, noise.data());
//
// Values equal those of gabor_fractal_noise, up to rounding. Compile with -O3, and with -mavx2 or
// -march=native for more than twice the speed. Places with a period take as long as in a loop. Needs C++17.
// Unlike its neighbours, this file is not a translation.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_FRACTAL_POINTS_HPP
#define GABOR_FRACTAL_POINTS_HPP

#include "gabor_fractal.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

// All functions: places have the period, the evolution and the cells per radius of the first one.

// void gabor_fractal_points(const GaborPlace* place, std::size_t count, GaborFractal fractal,
//                           std::uint32_t seed, float* noise)
// void gabor_fractal_points_3d(const GaborPlace3d* place, std::size_t count, GaborFractal fractal,
//                              std::uint32_t seed, float* noise)
//     Writes `count` values.

// void gabor_fractal_points_gradient(const GaborPlace* place, std::size_t count, GaborFractal fractal,
//                                    std::uint32_t seed, float* noise, float* along_x, float* along_y)
//     The noise and its derivatives per kernel radius.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Compilers vectorize only innermost loops without branches. gabor_fractal_noise has a loop over octaves; so
// here, loops over the points of a block are inside it, and choices that hold for all points are template
// parameters.

constexpr std::size_t gabor_impl_fractal_block = 64;

// Overloads for the plane and for a volume.
GABOR_INLINE GaborImplOctave gabor_impl_first_octave(const GaborPlace& place) {
    const gabor_vec2 size = place.cells_per_radius;
    return {place.cell, place.local, place.period, {size.x, 0.0f}, {0.0f, size.y}};
}
GABOR_INLINE GaborImplOctave3d gabor_impl_first_octave(const GaborPlace3d& place) {
    const gabor_vec3 size = place.cells_per_radius;
    return {place.cell,           place.local,          place.period,
            {size.x, 0.0f, 0.0f}, {0.0f, size.y, 0.0f}, {0.0f, 0.0f, size.z}};
}
GABOR_INLINE void gabor_impl_next_octave(GaborImplOctave3d& octave, GaborPlace3d place, gabor_vec3 by,
                                         float lacunarity, int i) {
    gabor_impl_next_octave_3d(octave, place, by, lacunarity, i);
}
GABOR_INLINE gabor_vec3 gabor_impl_points_noise(GaborImplOctave octave, std::uint32_t salt, int basis,
                                                float evolution) {
    return gabor_impl_octave_noise(octave, salt, gabor_vec2(0.0f), basis, false, evolution);
}
GABOR_INLINE gabor_vec4 gabor_impl_points_noise(GaborImplOctave3d octave, std::uint32_t salt, int basis,
                                                float evolution) {
    return gabor_impl_octave_noise_3d(octave, salt, gabor_vec3(0.0f), basis, false, evolution);
}
GABOR_INLINE GaborFractalNoise gabor_impl_points_octave(GaborImplOctave octave, int shape, float amplitude,
                                                        gabor_vec3 noise) {
    GaborFractalNoise one{};
    gabor_impl_add_octave(one, octave, shape, amplitude, noise, 1.0f, gabor_vec2(0.0f));
    return one;
}
GABOR_INLINE GaborFractalNoise3d gabor_impl_points_octave(GaborImplOctave3d octave, int shape,
                                                          float amplitude, gabor_vec4 noise) {
    GaborFractalNoise3d one{};
    gabor_impl_add_octave_3d(one, octave, shape, amplitude, noise, 1.0f, gabor_vec3(0.0f));
    return one;
}

// The octaves of a block of points. Points after the last one compute values that nobody reads.
template <int axes, typename Octave>
struct GaborImplPoints {
    Octave common; // all but cell and local
    int cell[axes][gabor_impl_fractal_block] = {};
    float local[axes][gabor_impl_fractal_block] = {};
    float noise[axes + 1][gabor_impl_fractal_block];
    float sum[axes + 1][gabor_impl_fractal_block] = {};

    GABOR_INLINE Octave octave(std::size_t i) const {
        Octave here = common;
        for (int k = 0; k < axes; ++k) {
            here.cell[k] = cell[k][i];
            here.local[k] = local[k][i];
            here.period[k] = 0;
        }
        return here;
    }

    GABOR_INLINE void set(std::size_t i, const Octave& here) {
        for (int k = 0; k < axes; ++k) {
            cell[k][i] = here.cell[k];
            local[k][i] = here.local[k];
        }
    }

    template <typename Place, typename Step>
    void next(Place place, Step by, float lacunarity, int index) {
        for (int k = 0; k < axes; ++k) {
            place.period[k] = 0;
            place.cell[k] = 1; // a cell of 0 gets the same value without the branch for it
        }
        for (std::size_t i = 0; i < gabor_impl_fractal_block; ++i) {
            Octave here = octave(i);
            gabor_impl_next_octave(here, place, by, lacunarity, index);
            set(i, here);
        }
        gabor_impl_next_octave(common, place, by, lacunarity, index);
    }

    template <int basis, bool animated, bool sloped>
    void fill(std::uint32_t salt, float evolution) {
        if (animated && evolution == 0.0f)
            return; // never: it tells compilers that the evolution is not 0, so that they vectorize the loop
        for (std::size_t i = 0; i < gabor_impl_fractal_block; ++i) {
            const auto values = gabor_impl_points_noise(octave(i), salt, basis, animated ? evolution : 0.0f);
            for (int k = 0; k < (sloped ? axes + 1 : 1); ++k)
                noise[k][i] = values[k];
        }
    }

    template <int shape, bool sloped>
    void add(float amplitude) {
        for (std::size_t i = 0; i < gabor_impl_fractal_block; ++i) {
            gabor_vector<float, axes + 1> values(0.0f);
            for (int k = 0; k < (sloped ? axes + 1 : 1); ++k)
                values[k] = noise[k][i];
            const auto one = gabor_impl_points_octave(common, shape, amplitude, values);
            sum[0][i] += one.noise;
            for (int k = 0; sloped && k < axes; ++k)
                sum[1 + k][i] += one.gradient[k];
        }
    }

    template <int basis, bool sloped>
    void fill(std::uint32_t salt, float evolution) {
        if (evolution == 0.0f)
            fill<basis, false, sloped>(salt, evolution);
        else
            fill<basis, true, sloped>(salt, evolution);
    }
};

// Fills out[0] with the noise, and the others with its gradient if `sloped`. None of the places has a period.
template <int axes, bool sloped, typename Place, typename Step>
inline void gabor_impl_fractal_points(const Place* place, std::size_t count, GaborFractal fractal, Step by,
                                      std::uint32_t seed, float* const* out) {
    using Octave = decltype(gabor_impl_first_octave(*place));
    const float octaves = gabor_cpp_clamp(fractal.octaves, 1.0f, 16.0f);
    for (std::size_t begin = 0; begin < count;
         begin += gabor_impl_fractal_block, place += gabor_impl_fractal_block) {
        const std::size_t here = std::min(count - begin, gabor_impl_fractal_block);
        GaborImplPoints<axes, Octave> points;
        points.common = gabor_impl_first_octave(place[0]);
        for (std::size_t i = 0; i < here; ++i)
            points.set(i, gabor_impl_first_octave(place[i]));
        float amplitude = 1.0f, power = 0.0f;
        for (int i = 0; float(i) < octaves; ++i) {
            const float weight = amplitude * gabor_cpp_min(octaves - float(i), 1.0f);
            power += weight * weight;
            amplitude *= fractal.gain;
            const std::uint32_t salt = gabor_impl_octave_salt(seed, i);
            if (fractal.basis == GABOR_PERLIN)
                points.template fill<GABOR_PERLIN, sloped>(salt, place[0].evolution);
            else
                points.template fill<GABOR_SMOOTH, sloped>(salt, place[0].evolution);
            if (fractal.shape == GABOR_FBM)
                points.template add<GABOR_FBM, sloped>(weight);
            else if (fractal.shape == GABOR_RIDGED)
                points.template add<GABOR_RIDGED, sloped>(weight);
            else
                points.template add<GABOR_BILLOW, sloped>(weight);
            points.next(place[0], by, fractal.lacunarity, i + 1);
        }
        const float scale = gabor_cpp_inversesqrt(gabor_cpp_max(power, 1.0e-30f));
        for (int k = 0; k < (sloped ? axes + 1 : 1); ++k)
            for (std::size_t i = 0; i < here; ++i)
                out[k][begin + i] = scale * points.sum[k][i];
    }
}

// The noise of one point, compiled once.
inline GaborFractalNoise gabor_impl_fractal_point(const GaborPlace& place, GaborFractal fractal,
                                                  std::uint32_t seed) {
    return gabor_fractal_noise(place, fractal, seed);
}
inline GaborFractalNoise3d gabor_impl_fractal_point(const GaborPlace3d& place, GaborFractal fractal,
                                                    std::uint32_t seed) {
    return gabor_fractal_noise_3d(place, fractal, seed);
}

inline void gabor_fractal_points(const GaborPlace* place, std::size_t count, GaborFractal fractal,
                                 std::uint32_t seed, float* noise) {
    if (count > 0 && (place[0].period.x != 0 || place[0].period.y != 0))
        for (std::size_t i = 0; i < count; ++i)
            noise[i] = gabor_impl_fractal_point(place[i], fractal, seed).noise;
    else
        gabor_impl_fractal_points<2, false>(place, count, fractal, gabor_impl_octave_step(fractal), seed,
                                            &noise);
}

inline void gabor_fractal_points_gradient(const GaborPlace* place, std::size_t count, GaborFractal fractal,
                                          std::uint32_t seed, float* noise, float* along_x, float* along_y) {
    float* const out[] = {noise, along_x, along_y};
    if (count > 0 && (place[0].period.x != 0 || place[0].period.y != 0))
        for (std::size_t i = 0; i < count; ++i) {
            const GaborFractalNoise here = gabor_impl_fractal_point(place[i], fractal, seed);
            noise[i] = here.noise;
            along_x[i] = here.gradient.x;
            along_y[i] = here.gradient.y;
        }
    else
        gabor_impl_fractal_points<2, true>(place, count, fractal, gabor_impl_octave_step(fractal), seed, out);
}

inline void gabor_fractal_points_3d(const GaborPlace3d* place, std::size_t count, GaborFractal fractal,
                                    std::uint32_t seed, float* noise) {
    if (count > 0 && (place[0].period.x != 0 || place[0].period.y != 0 || place[0].period.z != 0))
        for (std::size_t i = 0; i < count; ++i)
            noise[i] = gabor_impl_fractal_point(place[i], fractal, seed).noise;
    else
        gabor_impl_fractal_points<3, false>(place, count, fractal, gabor_impl_octave_step_3d(fractal), seed,
                                            &noise);
}

#endif // GABOR_FRACTAL_POINTS_HPP
