// Kernels of noise in the plane and in 3D.

#include "kernel.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_filter.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_fractal_points.hpp"

#include <algorithm>
#include <type_traits>

namespace {

// A noise repeats after an evolution of 1.
float evolution_of(const Input& turns, std::size_t i) {
    return static_cast<float>(turns.exact(i) - std::floor(turns.exact(i)));
}

const char* const place_inputs = "x y period.x period.y evolution seed ";

GaborPlace place_of(const Block& block, std::size_t i) {
    const std::vector<Input>& in = block.in;
    GaborPlace place = gabor_place_tiled({0.0f, 0.0f}, {in[2][i], in[3][i]});
    const Split across(in[0].exact(i), place.cells_per_radius.x),
        down(in[1].exact(i), place.cells_per_radius.y);
    place.cell = {across.cell, down.cell};
    place.local = {across.local, down.local};
    place.evolution = evolution_of(in[4], i);
    return place;
}

// ---- Noise with one wave vector: loops that compilers vectorize ------------------------------------------

struct Waves {
    std::size_t count;
    Input x, y;
    gabor_vec2 period;
    float evolution;
    std::uint32_t seed;
    Input wave_x, wave_y;
};

template <std::size_t channels>
void put(float* out, const GaborField& field) {
    out[0] = field.noise;
    if (channels == 2)
        out[Block::size] = field.quadrature;
    if (channels == 3) {
        out[Block::size] = field.gradient.x;
        out[2 * Block::size] = field.gradient.y;
    }
}

// Choices that hold for all points are template parameters, so that the loop has no branches. There are 1 to
// 3 channels: (noise), (noise, quadrature) or (noise and its gradient).
template <std::size_t channels, bool tiled, bool animated, bool one_wave>
void fill_waves(const Waves& waves, float* out) {
    const GaborPlace origin = gabor_place_tiled({0.0f, 0.0f}, waves.period);
    int cell_x[Block::size], cell_y[Block::size];
    float local_x[Block::size], local_y[Block::size];
    for (std::size_t i = 0; i < waves.count; ++i) {
        const Split across(waves.x.exact(i), origin.cells_per_radius.x),
            down(waves.y.exact(i), origin.cells_per_radius.y);
        cell_x[i] = across.cell;
        local_x[i] = across.local;
        cell_y[i] = down.cell;
        local_y[i] = down.local;
    }
    const gabor_vec2 first{waves.wave_x[0], waves.wave_y[0]};
    const float evolution = animated ? waves.evolution : 0.0f;
    if (animated && evolution == 0.0f)
        return; // never: it tells compilers that the evolution is not 0, so that they vectorize the loop
    for (std::size_t i = 0; i < waves.count; ++i) {
        GaborPlace place = tiled ? origin : gabor_place({0, 0}, {0.0f, 0.0f});
        place.cell = {cell_x[i], cell_y[i]};
        place.local = {local_x[i], local_y[i]};
        place.evolution = evolution;
        const gabor_vec2 wave = one_wave ? first : gabor_vec2(waves.wave_x[i], waves.wave_y[i]);
        put<channels>(out + i, gabor_field(place, wave, waves.seed));
    }
}

template <std::size_t channels>
void fill_waves(const Waves& waves, float* out) {
    const auto choose = [](bool flag, auto next) { flag ? next(std::true_type()) : next(std::false_type()); };
    choose(waves.period.x > 0 || waves.period.y > 0, [&](auto tiled) {
        choose(waves.evolution != 0.0f, [&](auto animated) {
            choose(waves.wave_x.constant && waves.wave_y.constant, [&](auto one_wave) {
                fill_waves<channels, decltype(tiled)::value, decltype(animated)::value,
                           decltype(one_wave)::value>(waves, out);
            });
        });
    });
}

bool constant(const Block& block, std::size_t first, std::size_t end) {
    return std::all_of(&block.in[first], &block.in[first] + (end - first),
                       [](const Input& in) { return in.constant; });
}

// The same for the inputs of a place.
template <std::size_t channels>
void fill_waves(const Block& block, const Input& wave_x, const Input& wave_y, float* out) {
    const std::vector<Input>& in = block.in;
    if (constant(block, 2, 6))
        fill_waves<channels>({block.count,
                              in[0],
                              in[1],
                              {in[2][0], in[3][0]},
                              evolution_of(in[4], 0),
                              block.seed(5, 0),
                              wave_x,
                              wave_y},
                             out);
    else
        for (std::size_t i = 0; i < block.count; ++i)
            put<channels>(out + i, gabor_field(place_of(block, i), {wave_x[i], wave_y[i]}, block.seed(5, i)));
}

template <std::size_t channels>
void fill_noise(const Block& block) {
    double wave_x[Block::size], wave_y[Block::size];
    const bool one_wave = block.in[6].constant && block.in[7].constant;
    for (std::size_t i = 0; i < (one_wave ? 1 : block.count); ++i) {
        const gabor_vec2 wave = gabor_wave_vector(block.in[6][i], block.in[7][i]);
        wave_x[i] = wave.x;
        wave_y[i] = wave.y;
    }
    if (one_wave) {
        std::fill_n(wave_x, block.count, wave_x[0]);
        std::fill_n(wave_y, block.count, wave_y[0]);
    }
    fill_waves<channels>(block, {wave_x, one_wave}, {wave_y, one_wave}, block.out);
}

void fill_stripes(const Block& block) {
    float values[2 * Block::size];
    fill_waves<2>(block, block.in[6], block.in[7], values);
    for (std::size_t i = 0; i < block.count; ++i) {
        GaborField field{};
        field.noise = values[i];
        field.quadrature = values[Block::size + i];
        const gabor_vec3 stripes = gabor_stripes_of(field, block.in[8][i]);
        block.put(0, i, stripes.x);
        block.put(1, i, stripes.y);
        block.put(2, i, stripes.z);
    }
}

// ---- Sums of noises --------------------------------------------------------------------------------------

// Adds a lobe of a sum, if it is the same for all points.
void add_lobe(const Block& block, const GaborLobe& lobe, float amplitude, std::uint32_t seed) {
    const std::vector<Input>& in = block.in;
    double x[Block::size], y[Block::size];
    for (std::size_t i = 0; i < block.count; ++i) {
        x[i] = in[0].exact(i) / double(lobe.radius.x);
        y[i] = in[1].exact(i) / double(lobe.radius.y);
    }
    const gabor_vec2 wave = gabor_impl_lobe_wave(lobe),
                     period{in[2][0] / lobe.radius.x, in[3][0] / lobe.radius.y};
    const double wave_x = wave.x, wave_y = wave.y; // the only values that a constant input needs here
    float noise[Block::size];
    fill_waves<1>({block.count,
                   {x, false},
                   {y, false},
                   period,
                   evolution_of(in[4], 0),
                   seed,
                   {&wave_x, true},
                   {&wave_y, true}},
                  noise);
    for (std::size_t i = 0; i < block.count; ++i)
        block.out[i] += amplitude * noise[i];
}

// Five inputs per lobe follow those of the place.
GaborLobes lobes_of(const Block& block, std::size_t i) {
    GaborLobes lobes{};
    lobes.count = static_cast<int>(block.in.size() - 6) / 5;
    for (int k = 0; k < lobes.count; ++k) {
        const Input* of = &block.in[std::size_t(6 + 5 * k)];
        lobes.lobe[k] = {of[0][i], of[1][i], {of[2][i], of[3][i]}, of[4][i]};
    }
    return lobes;
}

void fill_lobes(const Block& block) {
    if (!constant(block, 2, block.in.size())) {
        for (std::size_t i = 0; i < block.count; ++i)
            block.put(0, i,
                      gabor_field_lobes(place_of(block, i), lobes_of(block, i), block.seed(5, i)).noise);
        return;
    }
    const GaborLobes lobes = lobes_of(block, 0);
    const float power = gabor_impl_lobes_power(lobes);
    std::fill_n(block.out, block.count, 0.0f);
    for (int k = 0; k < lobes.count; ++k)
        add_lobe(block, lobes.lobe[k], std::sqrt(lobes.lobe[k].power / power),
                 gabor_derived_seed(block.seed(5, 0), k));
}

// The lobes of gabor_field_spread.
void add_spread(const Block& block, float frequency, float orientation, float frequency_spread,
                float orientation_spread) {
    frequency = gabor_cpp_min(std::fabs(frequency), 1.0e6f);
    orientation_spread = gabor_cpp_min(orientation_spread, 1.5707963f);
    const float shells = gabor_cpp_clamp(2.857f * frequency_spread * frequency + 0.8f, 1.0f, 16.0f);
    for (int j = 0; j < gabor_impl_pieces(shells); ++j) {
        const gabor_vec3 shell = gabor_impl_piece(j, shells);
        const float magnitude = frequency * (1.0f + frequency_spread * shell.x);
        const float directions = gabor_cpp_clamp(
            0.63661977f * orientation_spread * (4.44f * magnitude + 0.6f) + 0.8f, 1.0f, 64.0f);
        for (int i = 0; i < gabor_impl_pieces(directions); ++i) {
            const gabor_vec3 direction = gabor_impl_piece(i, directions);
            add_lobe(block, gabor_lobe(magnitude, orientation + orientation_spread * direction.x, 1.0f, 1.0f),
                     std::sqrt(shell.y * direction.y),
                     gabor_derived_seed(block.seed(5, 0), int(128.0f * shell.z + direction.z)));
        }
    }
}

void fill_spread(const Block& block) {
    const std::vector<Input>& in = block.in;
    if (constant(block, 2, block.in.size())) {
        std::fill_n(block.out, block.count, 0.0f);
        add_spread(block, in[6][0], in[7][0], in[8][0], in[9][0]);
        return;
    }
    for (std::size_t i = 0; i < block.count; ++i)
        block.put(
            0, i,
            gabor_field_spread(place_of(block, i), in[6][i], in[7][i], in[8][i], in[9][i], block.seed(5, i))
                .noise);
}

void fill_isotropic(const Block& block) {
    for (std::size_t i = 0; i < block.count; ++i)
        block.put(0, i, gabor_field_isotropic(place_of(block, i), block.in[6][i], block.seed(5, i)).noise);
}

void fill_filtered(const Block& block) {
    const std::vector<Input>& in = block.in;
    for (std::size_t i = 0; i < block.count; ++i) {
        const GaborField field =
            gabor_field_filtered(place_of(block, i), {in[8][i], 0.0f}, {0.0f, in[9][i]},
                                 gabor_wave_vector(in[6][i], in[7][i]), block.seed(5, i));
        block.put(0, i, field.noise);
        block.put(1, i, field.removed);
    }
}

// ---- 3D --------------------------------------------------------------------------------------------------

const char* const place_3d_inputs = "x y z period.x period.y period.z evolution seed ";

GaborPlace3d place_3d_of(const Block& block, std::size_t i) {
    const std::vector<Input>& in = block.in;
    GaborPlace3d place = gabor_place_3d_tiled({0.0f, 0.0f, 0.0f}, {in[3][i], in[4][i], in[5][i]});
    const Split x(in[0].exact(i), place.cells_per_radius.x), y(in[1].exact(i), place.cells_per_radius.y),
        z(in[2].exact(i), place.cells_per_radius.z);
    place.cell = {x.cell, y.cell, z.cell};
    place.local = {x.local, y.local, z.local};
    place.evolution = evolution_of(in[6], i);
    return place;
}

void fill_3d(const Block& block) {
    const std::vector<Input>& in = block.in;
    for (std::size_t i = 0; i < block.count; ++i) {
        const gabor_vec3 direction{in[9][i], in[10][i], in[11][i]};
        const gabor_vec3 wave = std::fabs(in[8][i]) * gabor_impl_unit(direction);
        block.put(0, i, gabor_field_3d(place_3d_of(block, i), wave, block.seed(7, i)).noise);
    }
}

void fill_3d_isotropic(const Block& block) {
    for (std::size_t i = 0; i < block.count; ++i)
        block.put(0, i,
                  gabor_field_3d_isotropic(place_3d_of(block, i), block.in[8][i], block.seed(7, i)).noise);
}

// ---- Fractal noise ---------------------------------------------------------------------------------------

// Four inputs follow those of a place; the last two are the basis and the shape.
GaborFractal fractal_of(const Block& block, std::size_t i, std::size_t first = 6) {
    const std::vector<Input>& in = block.in;
    return {in[first][i],     in[first + 1][i],          in[first + 2][i],
            in[first + 3][i], int(in[in.size() - 2][i]), int(in[in.size() - 1][i])};
}

// The places of a block, if they have the same period and evolution.
void places_of(const Block& block, const gabor_vec2& period, float evolution, double scale,
               GaborPlace* places) {
    const GaborPlace origin = gabor_place_tiled({0.0f, 0.0f}, period);
    for (std::size_t i = 0; i < block.count; ++i) {
        const Split across(scale * block.in[0].exact(i), origin.cells_per_radius.x),
            down(scale * block.in[1].exact(i), origin.cells_per_radius.y);
        places[i] = origin;
        places[i].cell = {across.cell, down.cell};
        places[i].local = {across.local, down.local};
        places[i].evolution = evolution;
    }
}

// The same, if all inputs but the position are constant; else returns false.
bool places_of(const Block& block, GaborPlace* places) {
    const std::vector<Input>& in = block.in;
    const bool same = constant(block, 2, in.size());
    if (same)
        places_of(block, {in[2][0], in[3][0]}, evolution_of(in[4], 0), 1, places);
    return same;
}

GaborFractalNoise fractal_at(const Block& block, std::size_t i, std::uint32_t seed) {
    return gabor_impl_fractal_point(place_of(block, i), fractal_of(block, i), seed);
}

void fill_fractal(const Block& block) {
    GaborPlace places[Block::size];
    if (places_of(block, places))
        gabor_fractal_points(places, block.count, fractal_of(block, 0), block.seed(5, 0), block.out);
    else
        for (std::size_t i = 0; i < block.count; ++i)
            block.put(0, i, fractal_at(block, i, block.seed(5, i)).noise);
}

void fill_fractal_gradient(const Block& block) {
    GaborPlace places[Block::size];
    if (places_of(block, places))
        gabor_fractal_points_gradient(places, block.count, fractal_of(block, 0), block.seed(5, 0), block.out,
                                      block.out + Block::size, block.out + 2 * Block::size);
    else
        for (std::size_t i = 0; i < block.count; ++i) {
            const GaborFractalNoise here = fractal_at(block, i, block.seed(5, i));
            block.put(0, i, here.noise);
            block.put(1, i, here.gradient.x);
            block.put(2, i, here.gradient.y);
        }
}

void fill_fractal_filtered(const Block& block) {
    const std::vector<Input>& in = block.in;
    for (std::size_t i = 0; i < block.count; ++i) {
        const GaborFractalNoise here = gabor_fractal_noise_filtered(
            place_of(block, i), {in[10][i], 0.0f}, {0.0f, in[11][i]}, fractal_of(block, i), block.seed(5, i));
        block.put(0, i, here.noise);
        block.put(1, i, here.removed);
    }
}

void fill_perlin(const Block& block) {
    GaborFractal fractal = gabor_fractal(1.0f, 0.0f);
    fractal.basis = GABOR_PERLIN;
    GaborPlace places[Block::size];
    places_of(block, {0.0f, 0.0f}, 0.0f, 1.186, places); // as in gabor_perlin
    if (block.in[2].constant)
        gabor_fractal_points(places, block.count, fractal, block.seed(2, 0), block.out);
    else
        for (std::size_t i = 0; i < block.count; ++i)
            block.put(0, i, gabor_impl_fractal_point(places[i], fractal, block.seed(2, i)).noise);
}

// How far a warp moves each point.
void fill_warp(const Block& block) {
    GaborPlace places[Block::size];
    const bool same = places_of(block, places);
    for (int axis = 0; axis < 2; ++axis) {
        float* const out = block.out + std::size_t(axis) * Block::size;
        if (same)
            gabor_fractal_points(places, block.count, fractal_of(block, 0),
                                 gabor_derived_seed(block.seed(5, 0), axis), out);
        else
            for (std::size_t i = 0; i < block.count; ++i)
                out[i] = fractal_at(block, i, gabor_derived_seed(block.seed(5, i), axis)).noise;
        for (std::size_t i = 0; i < block.count; ++i)
            out[i] *= block.in[10][i];
    }
}

void fill_fractal_3d(const Block& block) {
    GaborPlace3d places[Block::size];
    for (std::size_t i = 0; i < block.count; ++i)
        places[i] = place_3d_of(block, i);
    if (constant(block, 3, block.in.size()))
        gabor_fractal_points_3d(places, block.count, fractal_of(block, 0, 8), block.seed(7, 0), block.out);
    else
        for (std::size_t i = 0; i < block.count; ++i)
            block.put(0, i,
                      gabor_impl_fractal_point(places[i], fractal_of(block, i, 8), block.seed(7, i)).noise);
}

void fill_uniform(const Block& block) {
    for (std::size_t i = 0; i < block.count; ++i)
        block.put(0, i, gabor_uniform(block.in[0][i]));
}

} // namespace

std::vector<Kernel> noise_kernels() {
    const std::string place = place_inputs, wave = place + "frequency orientation",
                      place_3d = place_3d_inputs, wave_3d = place_3d + "frequency",
                      octaves = "octaves gain lacunarity turn";
    return {
        {"noise", wave, 1, fill_noise<1>, {}},
        {"quadrature", wave, 2, fill_noise<2>, {}},
        {"gradient", wave, 3, fill_noise<3>, {}},
        {"isotropic", place + "frequency", 1, fill_isotropic, {}},
        {"spread", wave + " frequency_spread orientation_spread", 1, fill_spread, {}},
        {"lobes", place_inputs, 1, fill_lobes, {}},
        {"filtered", wave + " pixel_size.x pixel_size.y", 2, fill_filtered, {}},
        {"stripes", place + "wave_x wave_y sharpness", 3, fill_stripes, {}},
        {"3d", wave_3d + " direction.x direction.y direction.z", 1, fill_3d, {}},
        {"3d_isotropic", wave_3d, 1, fill_3d_isotropic, {}},
        {"fractal", place + octaves, 1, fill_fractal, {}},
        {"fractal_gradient", place + octaves, 3, fill_fractal_gradient, {}},
        {"fractal_filtered", place + octaves + " pixel_size.x pixel_size.y", 2, fill_fractal_filtered, {}},
        {"fractal_3d", place_3d + octaves, 1, fill_fractal_3d, {}},
        {"warp", place + octaves + " strength", 2, fill_warp, {}},
        {"perlin", "x y seed", 1, fill_perlin, {}},
        {"uniform", "noise", 1, fill_uniform, {}}};
}
