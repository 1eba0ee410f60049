// Evaluates the C++ translations of the drop-ins on numpy arrays, on all cores. __init__.py broadcasts the
// arguments and documents the functions.

#include "gabor_noise.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_filter.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_erosion.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <vector>

namespace nb = nanobind;

namespace {

// A flat array with one value per point, or a single value for all points.
template <typename T>
struct Values {
    using Array = nb::ndarray<const T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
    const T* data;
    std::size_t step;

    explicit Values(const Array& array) : data(array.data()), step(array.size() == 1 ? 0 : 1) {}
    T operator[](std::size_t i) const { return data[i * step]; }
};

using Doubles = Values<double>::Array;
using Floats = Values<float>::Array;

// Splits a coordinate in kernel radii into its cell and the offset in it, so that a float offset is precise
// at any distance from the origin.
struct Split {
    int cell;
    float local;

    Split(double position, float nodes) { // nodes per kernel radius
        const double at = position * double(nodes);
        std::int64_t whole = static_cast<std::int64_t>(at);
        whole -= at < static_cast<double>(whole); // floor, without a function call
        cell = static_cast<int>(static_cast<std::uint32_t>(whole));
        local = static_cast<float>(at - static_cast<double>(whole));
    }
};

GaborPlace place_of(double x, double y) {
    const Split across(x, GABOR_RADIUS), down(y, GABOR_RADIUS);
    return gabor_place({across.cell, down.cell}, {across.local, down.local});
}

// Returns an array of `channels` rows of `count` values, filled in chunks on all cores with the GIL released.
template <typename Fill>
nb::ndarray<nb::numpy, float, nb::ndim<2>> evaluate(std::size_t count, std::size_t channels,
                                                    const Fill& fill) {
    auto* values = new float[count * channels];
    nb::capsule owner(values, [](void* data) noexcept { delete[] static_cast<float*>(data); });
    {
        nb::gil_scoped_release release;
        constexpr std::size_t least = 1 << 14; // the fewest points worth a thread
        const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
        const std::size_t threads = std::clamp<std::size_t>(count / least, 1, cores);
        std::vector<std::thread> others;
        for (std::size_t t = 1; t < threads; ++t)
            others.emplace_back([&, t] { fill(values, count * t / threads, count * (t + 1) / threads); });
        fill(values, 0, count / threads);
        for (std::thread& other : others)
            other.join();
    }
    return {values, {channels, count}, owner};
}

// Cells and offsets of a block of points, computed before the noise, so that compilers vectorize the loop
// over the noise.
struct Block {
    static constexpr std::size_t size = 256;
    int cell_x[size], cell_y[size];
    float local_x[size], local_y[size];

    Block(const Values<double>& x, const Values<double>& y, std::size_t begin, std::size_t count,
          gabor_vec2 nodes) {
        for (std::size_t i = 0; i < count; ++i) {
            const Split across(x[begin + i], nodes.x), down(y[begin + i], nodes.y);
            cell_x[i] = across.cell;
            local_x[i] = across.local;
            cell_y[i] = down.cell;
            local_y[i] = down.local;
        }
    }
};

struct Common {
    gabor_vec2 period;
    float time;
    std::uint32_t seed;
};

// Choices that hold for all points are template parameters, so that the loop has no branches.
template <bool tiled, bool animated, bool one_wave, typename Store>
void fill_field(float* values, std::size_t total, std::size_t begin, std::size_t end, const Values<double>& x,
                const Values<double>& y, const Values<float>& frequency, const Values<float>& orientation,
                const Common& common, const Store& store) {
    const GaborPlace origin = gabor_place_tiled({0.0f, 0.0f}, common.period);
    const gabor_vec2 first = gabor_wave_vector(frequency[0], orientation[0]);
    const float time = animated ? common.time : 0.0f;
    if (animated && time == 0.0f)
        return; // never: it tells compilers that the time is not 0, so that they vectorize the loop
    for (std::size_t start = begin; start < end; start += Block::size) {
        const std::size_t count = std::min(Block::size, end - start);
        const Block block(x, y, start, count, origin.radius);
        for (std::size_t i = 0; i < count; ++i) {
            GaborPlace place = tiled ? origin : gabor_place({0, 0}, {0.0f, 0.0f});
            place.cell = {block.cell_x[i], block.cell_y[i]};
            place.local = {block.local_x[i], block.local_y[i]};
            place.moment = time;
            const gabor_vec2 wave =
                one_wave ? first : gabor_wave_vector(frequency[start + i], orientation[start + i]);
            store(values + start + i, total, gabor_field(place, wave, common.seed));
        }
    }
}

// Returns what `store` keeps of the field at each point, with one wave vector for all points or one per
// point.
template <std::size_t channels, typename Store>
nb::object evaluate_field(const Doubles& x, const Doubles& y, const Floats& frequency,
                          const Floats& orientation, const Common& common, const Store& store) {
    const Values<double> across(x), down(y);
    const Values<float> frequencies(frequency), orientations(orientation);
    const bool one_wave = frequencies.step + orientations.step == 0;
    const std::size_t count = x.size();
    return nb::cast(evaluate(count, channels, [=](float* values, std::size_t begin, std::size_t end) {
        const auto choose = [](bool flag, auto next) {
            flag ? next(std::true_type()) : next(std::false_type());
        };
        choose(common.period.x > 0 || common.period.y > 0, [&](auto tiled) {
            choose(common.time != 0.0f, [&](auto moving) {
                choose(one_wave, [&](auto one) {
                    fill_field<decltype(tiled)::value, decltype(moving)::value, decltype(one)::value>(
                        values, count, begin, end, across, down, frequencies, orientations, common, store);
                });
            });
        });
    }));
}

} // namespace

NB_MODULE(_native, module) {
    module.def("field",
               [](const Doubles& x, const Doubles& y, const Floats& frequency, const Floats& orientation,
                  std::uint32_t seed, float period_x, float period_y, float time, int channels) {
                   const Common common{{period_x, period_y}, time, seed};
                   if (channels == 1)
                       return evaluate_field<1>(
                           x, y, frequency, orientation, common,
                           [](float* out, std::size_t, const GaborField& field) { *out = field.noise; });
                   if (channels == 2)
                       return evaluate_field<2>(x, y, frequency, orientation, common,
                                                [](float* out, std::size_t total, const GaborField& field) {
                                                    out[0] = field.quadrature;
                                                    out[total] = field.noise;
                                                });
                   return evaluate_field<3>(x, y, frequency, orientation, common,
                                            [](float* out, std::size_t total, const GaborField& field) {
                                                out[0] = field.noise;
                                                out[total] = field.gradient.x;
                                                out[2 * total] = field.gradient.y;
                                            });
               });
    module.def("spread", [](const Doubles& x, const Doubles& y, float frequency, float orientation,
                            float frequency_spread, float orientation_spread, std::uint32_t seed) {
        const Values<double> across(x), down(y);
        return evaluate(x.size(), 1, [=](float* values, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                values[i] = gabor_field_spread(place_of(across[i], down[i]), frequency, orientation,
                                               frequency_spread, orientation_spread, seed)
                                .noise;
        });
    });
    module.def("filtered", [](const Doubles& x, const Doubles& y, float width_x, float width_y,
                              const Floats& frequency, const Floats& orientation, std::uint32_t seed) {
        const Values<double> across(x), down(y);
        const Values<float> frequencies(frequency), orientations(orientation);
        const std::size_t count = x.size();
        return evaluate(count, 2, [=](float* values, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const GaborField field =
                    gabor_field_filtered(place_of(across[i], down[i]), {width_x, 0.0f}, {0.0f, width_y},
                                         gabor_wave_vector(frequencies[i], orientations[i]), seed);
                values[i] = field.noise;
                values[count + i] = field.removed;
            }
        });
    });
    module.def("stripes", [](const Doubles& x, const Doubles& y, const Floats& wave_x, const Floats& wave_y,
                             float period_x, float period_y, float sharpness, std::uint32_t seed) {
        const Values<double> across(x), down(y);
        const Values<float> waves_x(wave_x), waves_y(wave_y);
        const GaborPlace origin = gabor_place_tiled({0.0f, 0.0f}, {period_x, period_y});
        const std::size_t count = x.size();
        return evaluate(count, 3, [=](float* values, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Split right(across[i], origin.radius.x), below(down[i], origin.radius.y);
                GaborPlace place = origin;
                place.cell = {right.cell, below.cell};
                place.local = {right.local, below.local};
                const gabor_vec3 stripes =
                    gabor_stripes_of(gabor_field(place, {waves_x[i], waves_y[i]}, seed), sharpness);
                values[i] = stripes.x;
                values[count + i] = stripes.y;
                values[2 * count + i] = stripes.z;
            }
        });
    });
    module.def("terrain", [](const Doubles& x, const Doubles& y, const std::vector<Floats>& base,
                             const nb::bytes& members, float period, std::uint32_t seed) {
        const Values<double> across(x), down(y);
        std::vector<Values<float>> given;
        for (const Floats& each : base)
            given.emplace_back(each);
        GaborErosion erosion;
        if (members.size() != sizeof erosion)
            throw std::invalid_argument("terrain: the members of GaborErosion have another size");
        std::memcpy(&erosion, members.c_str(), sizeof erosion);
        const std::size_t count = x.size();
        return evaluate(count, 4, [=](float* values, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Split right(across[i], 1.0f), below(down[i], 1.0f);
                const GaborTerrainPlace ground{
                    {right.cell, below.cell}, {right.local, below.local}, {period, period}};
                const gabor_vec2 point{0.0f, 0.0f};
                GaborTerrain terrain =
                    given.empty() // without a base, generates hills
                        ? gabor_terrain_at(ground, point, point, seed)
                        : GaborTerrain{given[0][i], {given[1][i], given[2][i]}, given[3][i], {}, {}};
                if (erosion.octaves > 0)
                    terrain = gabor_eroded_at(ground, point, point, terrain, erosion, seed);
                values[i] = terrain.height;
                values[count + i] = terrain.slope.x;
                values[2 * count + i] = terrain.slope.y;
                values[3 * count + i] = terrain.ridge;
            }
        });
    });
    module.def("solid", [](const Doubles& x, const Doubles& y, const Doubles& z, float frequency, float dx,
                           float dy, float dz, bool isotropic, std::uint32_t seed) {
        const Values<double> xs(x), ys(y), zs(z);
        const gabor_vec3 direction{dx, dy, dz};
        return evaluate(x.size(), 1, [=](float* values, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const gabor_vec3 p{float(xs[i]), float(ys[i]), float(zs[i])};
                values[i] = isotropic ? gabor_noise_3d_isotropic(p, frequency, seed)
                                      : gabor_noise_3d(p, frequency, direction, seed);
            }
        });
    });
}
