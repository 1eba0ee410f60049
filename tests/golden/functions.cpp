// `functions FILE` compares the results of the drop-ins' C++ translations with a file in this folder, or
// writes the file if GABOR_GOLDEN=write. It also checks that results for arbitrary arguments are finite. A
// line of the file has a call and 16 numbers, each a sum over 4 points. `functions FIRST COUNT` writes floats
// to stdout: the results of all calls at point FIRST, then at the next, and so on for COUNT points.

#include "file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#define vec2 gabor_vec2
#define vec3 gabor_vec3
#define vec4 gabor_vec4
#define ivec2 gabor_ivec2
#define ivec3 gabor_ivec3
#define uint std::uint32_t

#include "sets.h"
#if defined GOLDEN_SPARSE
#include "gabor_sparse.hpp"
#else
#include "gabor_noise.hpp"
#endif
#if defined GOLDEN_EROSION
#include "gabor_erosion.hpp"
#elif defined GOLDEN_FRACTAL
#include "gabor_fractal.hpp"
#elif defined GOLDEN_OCEAN
#include "gabor_ocean.hpp"
#elif defined GOLDEN_DIRECTION
#define GABOR_DIRECTION(p) (0.3f * (p))
#include "gabor_direction.hpp"
#elif defined GOLDEN_NOISE_3D
#include "gabor_filter.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_filter_3d.hpp"
#elif defined GOLDEN_SPECTRUM
#include "gabor_spectrum.hpp"

#include "gabor_filter.hpp"
#elif defined GOLDEN_MATERIALS
#include "gabor_spectrum.hpp"

#include "gabor_fractal.hpp"

#include "gabor_materials.hpp"

#include "gabor_compose.hpp"
#endif

namespace {

using std::abs;
using std::exp2;
using std::floor;
using std::max;
using std::min;
using std::sin;
[[maybe_unused]] float uintBitsToFloat(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}
[[maybe_unused]] float dot(vec2 a, vec2 b) {
    return gabor_cpp_dot(a, b);
}

gabor::test::Rows rows;
int out_of_range = 0;

enum class What { rows, values, range } what = What::rows;
int point = 0;

void see(const char* call, float value) {
    if (what == What::rows)
        rows.see(call, value);
    else if (what == What::values)
        std::fwrite(&value, sizeof value, 1, stdout);
    else if (!gabor::test::is_in_range(call, point, value) && ++out_of_range < 20)
        std::printf("%s is %g at point %d\n", call, static_cast<double>(value), point);
}
#define SEE(call) see(#call, call);
#define precise volatile
#include "functions.glsl"

} // namespace

int main(int count, char** arguments) {
    if (count == 3) {
        what = What::values;
        const int first = std::atoi(arguments[1]);
        for (point = first; point < first + std::atoi(arguments[2]); ++point)
            see_all(point);
        return std::fflush(stdout);
    }
    for (point = 0; point < gabor::test::Rows::points; ++point) {
        rows.begin(point);
        see_all(point);
    }
#if defined GABOR_ROUNDING // fused products are not rounded, which shifts distant points
    const bool same = rows.compare(arguments[1], 1e-4, 0.2);
#else
    const bool same = rows.compare(arguments[1], 2e-6, 2e-6);
#endif
    what = What::range;
#if !defined GOLDEN_MATERIALS
    for (point = -1; point > -4096; --point)
        see_all(point);
#endif
    return same && out_of_range == 0 ? 0 : 1;
}
