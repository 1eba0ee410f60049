// Compares the results of the drop-ins' C++ translations with a file in this folder, or writes it if
// GABOR_GOLDEN=write: functions FILE. A line of it is a call and 16 numbers, each a sum over 4 points.

#include "file.hpp"

#include <bit>
#include <cmath>

#define vec2 gabor_vec2
#define vec3 gabor_vec3
#define vec4 gabor_vec4
#define ivec2 gabor_ivec2
#define ivec3 gabor_ivec3
#define uint std::uint32_t

#include "sets.h"
#if defined GOLDEN_NOISE
#include "gabor_noise.hpp"
#else
#include "gabor_lattice.hpp"
#endif
#if defined GOLDEN_EROSION
#include "gabor_erosion.hpp"
#elif defined GOLDEN_DIRECTION
#define GABOR_DIRECTION(p) (0.3f * (p))
#include "gabor_direction.hpp"
#elif !defined GOLDEN_NOISE && !defined GOLDEN_LATTICE
#include "gabor_spectrum.hpp"
#endif
#if defined GOLDEN_LATTICE_3D
#include "gabor_lattice_3d.hpp"
#endif
#if defined GOLDEN_MATERIALS
#include "gabor_materials.hpp"
#endif

namespace {

[[maybe_unused]] float exp2(float x) {
    return std::exp2(x);
}
[[maybe_unused]] float abs(float x) {
    return std::abs(x);
}
[[maybe_unused]] float sin(float x) {
    return std::sin(x);
}
[[maybe_unused]] float floor(float x) {
    return std::floor(x);
}
[[maybe_unused]] float dot(vec2 a, vec2 b) {
    return gabor_cpp_dot(a, b);
}

gabor::test::Rows rows;
bool only_hash = false;
std::uint32_t hash = 2166136261u; // the hash of Fowler, Noll and Vo, applied to words

void see(const char* call, float value) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 16777619u;
    if (!only_hash)
        rows.see(call, value);
}
#define SEE(call) see(#call, call);
#define precise volatile
#include "functions.glsl"

} // namespace

int main(int count, char** arguments) {
    only_hash = count == 3;
    if (only_hash) {
        for (int point = 0; point < std::atoi(arguments[2]); ++point)
            see_all(point);
        std::printf("%08x\n", hash);
        return 0;
    }
    for (int point = 0; point < gabor::test::Rows::points; ++point) {
        rows.begin(point);
        see_all(point);
    }
#if defined GABOR_ROUNDING // unrounded products move places far away
    return rows.compare(arguments[1], 1e-4, 0.2) ? 0 : 1;
#else
    return rows.compare(arguments[1], 2e-6, 2e-6) ? 0 : 1;
#endif
}
