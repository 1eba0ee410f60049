#pragma once

#include "reference/vector.hpp"

#include <array>
#include <cstdint>

namespace gabor::noise {

/// Terrain, Erosion and Ground mirror the structs GaborTerrain, GaborErosion and GaborTerrainPlace of
/// shaders/gabor_erosion.glsl. Erosion has the same layout.
struct Terrain {
    double height = 0;
    Vector<2> slope{};
    double ridge = 0;
    std::array<double, 3> curvature{}; // xx, xy, yy
    Vector<2> ridge_slope{};
    double crease = 0; // how much the slope of eroded terrain jumps beside the point
};
struct Erosion {
    int octaves = 5;
    float gully_frequency = 1.5f;
    float strength = 0.12f;
    float lacunarity = 2;
    float gain = 0.5f;
    float onset_slope = 0.5f;
    float detail = 1.5f;
    float uniformity = 2;
    float ridge_rounding = 0.1f;
    float crease_rounding = 0.1f;
    float gully_weight = 0.5f;
    float branching = 1;
};
struct Ground {
    std::array<std::int32_t, 2> cell{};
    Vector<2> local{};
    std::array<float, 2> period{};
};

/// The hills and the erosion of shaders/gabor_erosion.glsl in double precision, written from the equations
/// and not from the shader. The slope of eroded terrain is a difference of its heights, on a base that
/// continues with its slope and curvature.
Terrain terrain(const Ground& ground, Vector<2> dx, Vector<2> dy, std::uint32_t seed);
Terrain eroded(int taps, const Ground& ground, Vector<2> dx, Vector<2> dy, const Terrain& base,
               const Erosion& erosion, std::uint32_t seed);

} // namespace gabor::noise
