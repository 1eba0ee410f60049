#include "translation.hpp"

#include <cmath>
#include <cstring>

// A namespace for each number of taps, with its own vectors and functions.
#define GABOR_TAPS 2
namespace taps_2 {
#include "gabor_lattice.hpp"

#include "gabor_erosion.hpp"
} // namespace taps_2
#undef GABOR_LATTICE_HPP
#undef GABOR_EROSION_HPP
#undef GABOR_VECTORS_HPP
#undef GABOR_TAPS
#define GABOR_TAPS 4
namespace taps_4 {
#include "gabor_lattice.hpp"

#include "gabor_erosion.hpp"
} // namespace taps_4
#undef GABOR_LATTICE_HPP
#undef GABOR_EROSION_HPP
#undef GABOR_VECTORS_HPP
#undef GABOR_TAPS
namespace taps_3 {
#include "gabor_lattice.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"

#include "gabor_lattice_3d.hpp"

#include "gabor_direction.hpp"
} // namespace taps_3

namespace gabor::test {

// Compiled once for each namespace.
#define VALUES_OF(taps)                                                                                      \
    [[gnu::noinline]] Values values_##taps(const Arguments& a) {                                             \
        using namespace taps_##taps;                                                                         \
        const auto gradient = gabor_noise_gradient({a.x, a.y}, a.frequency, a.orientation, a.seed);          \
        const auto stripes = gabor_stripes({a.x, a.y}, {a.wave_x, a.wave_y}, 2.0f, a.seed);                  \
        return {{gradient.x, gradient.y, gradient.z},                                                        \
                {stripes.x, stripes.y, stripes.z},                                                           \
                gabor_noise_at({a.column, a.row}, {a.local_x, a.local_y},                                    \
                               gabor_kernel(a.frequency, a.orientation), a.seed),                            \
                gabor_noise_tiled({a.x, a.y}, {a.period_x, a.period_y}, a.frequency, a.orientation, a.seed), \
                gabor_noise_animated({a.x, a.y}, a.time, a.frequency, a.orientation, a.seed)};               \
    }
VALUES_OF(2)
VALUES_OF(3)
VALUES_OF(4)

#define ERODED_OF(taps)                                                                                      \
    [[gnu::noinline]] Eroded eroded_##taps(const Arguments& a, const Pixel& pixel, bool hills) {             \
        using namespace taps_##taps;                                                                         \
        const GaborGround ground{{a.column, a.row}, {a.local_x, a.local_y}, {a.period_x, a.period_y}};       \
        GaborTerrain base{a.x, {a.wave_x, a.wave_y}, a.time};                                                \
        if (hills)                                                                                           \
            base = gabor_terrain_at(ground, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]}, a.seed); \
        const GaborTerrain terrain = gabor_eroded_at(                                                        \
            ground, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]}, base, gabor_erosion(), a.seed);  \
        return {{base.height, base.slope.x, base.slope.y, base.ridge},                                       \
                {terrain.height, terrain.slope.x, terrain.slope.y, terrain.ridge}};                          \
    }
ERODED_OF(2)
ERODED_OF(3)

Eroded eroded(int taps, const Arguments& a, const Pixel& pixel, bool hills) {
    return taps == 2 ? eroded_2(a, pixel, hills) : eroded_3(a, pixel, hills);
}

Values values(int taps, const Arguments& a) {
    return taps == 2 ? values_2(a) : taps == 3 ? values_3(a) : values_4(a);
}

Filtered filtered(const Arguments& a, const Pixel& pixel) {
    using namespace taps_3;
    const gabor_vec2 dx(pixel.dx[0], pixel.dx[1]);
    const gabor_vec2 dy(pixel.dy[0], pixel.dy[1]);
    const GaborFootprint footprint = gabor_footprint(dx, dy);
    const gabor_vec4 noise =
        gabor_noise_filtered_gradient({a.x, a.y}, dx, dy, a.frequency, a.orientation, a.seed);
    return {{std::sqrt(footprint.resolved.x), std::sqrt(footprint.resolved.y)},
            {noise.x, noise.y, noise.z, noise.w}};
}

std::array<float, 3> solid(const Vector& p, float frequency, const Vector& direction, std::uint32_t seed) {
    using namespace taps_3;
    const gabor_vec3 at(p[0], p[1], p[2]), along(direction[0], direction[1], direction[2]);
    return {gabor_noise_3d(at, frequency, along, seed), gabor_noise_3d_isotropic(at, frequency, seed),
            gabor_noise_surface_isotropic(at, along, frequency, seed)};
}

std::array<float, 6> directed(const Arguments& a, const Waves& waves) {
    using namespace taps_3;
    GaborPlace place = gabor_place({a.column, a.row}, {a.local_x, a.local_y});
    place.animated = a.time != 0;
    place.time = a.time;
    GaborWaves given;
    for (int k = 0; k < 9; ++k)
        given.wave[k] = gabor_vec2(waves.wave[k][0], waves.wave[k][1]);
    const GaborField field = gabor_field_waves(place, given, a.seed);
    return {field.value.x, field.value.y, field.slope_x.x, field.slope_x.y, field.slope_y.x, field.slope_y.y};
}

std::array<float, 5> profiles(float phase, float duty, float width) {
    using namespace taps_3;
    return {gabor_profile_sine(phase, width), gabor_profile_triangle(phase, width),
            gabor_profile_sawtooth(phase, width), gabor_profile_pulse(phase, duty, width),
            gabor_profile_ridges(phase, width)};
}

std::array<float, 5> stripe_profiles(float cosine, float sine, float duty) {
    using namespace taps_3;
    const gabor_vec2 stripes(cosine, sine);
    return {gabor_stripes_sine(stripes), gabor_stripes_triangle(stripes), gabor_stripes_sawtooth(stripes),
            gabor_stripes_pulse(stripes, duty), gabor_stripes_ridges(stripes)};
}

std::array<float, 4> filtered_stripes(const Arguments& a, const Pixel& pixel, float sharpness) {
    using namespace taps_3;
    const gabor_vec4 stripes =
        gabor_stripes_filtered({a.x, a.y}, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]},
                               {a.wave_x, a.wave_y}, sharpness, a.seed);
    return {stripes.x, stripes.y, stripes.z, stripes.w};
}

std::array<float, 4> filtered_stripes_at(const Arguments& a, float sharpness) {
    using namespace taps_3;
    GaborPlace place = gabor_place({a.column, a.row}, {a.local_x, a.local_y});
    place.period = {7, 5};
    place.animated = true;
    place.time = a.time;
    const gabor_vec4 stripes = gabor_stripes_filtered_at(place, {a.wave_x, a.wave_y},
                                                         gabor_footprint({0, 0}, {0, 0}), sharpness, a.seed);
    return {stripes.x, stripes.y, stripes.z, stripes.w};
}

} // namespace gabor::test
