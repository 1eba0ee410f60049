// Kernels of materials.

#include "kernel.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_fractal.hpp"

#include "gabor_materials.hpp"

#include <cstring>

namespace {

template <typename Members>
using Material = GaborMaterial (*)(gabor_vec2 p, gabor_vec2 period, Members members, std::uint32_t seed);
template <typename Members>
using Filtered = GaborMaterial (*)(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, gabor_vec2 period,
                                   Members members, std::uint32_t seed);

void put(const Block& block, std::size_t i, const GaborMaterial& material) {
    const float values[] = {material.colour.x, material.colour.y, material.colour.z,  material.height,
                            material.slope.x,  material.slope.y,  material.roughness, material.metalness,
                            material.lost.x,   material.lost.y,   material.lost.z};
    for (std::size_t c = 0; c < sizeof values / sizeof *values; ++c)
        block.put(c, i, values[c]);
}

// All members of these structs are floats and vectors of floats.
template <typename Members, Material<Members> material, Filtered<Members> filtered>
void fill(const Block& block) {
    const std::vector<Input>& in = block.in;
    for (std::size_t i = 0; i < block.count; ++i) {
        float values[sizeof(Members) / sizeof(float)];
        std::size_t input = 7;
        for (float& value : values)
            value = in[input++][i];
        Members members;
        std::memcpy(&members, values, sizeof members);
        const gabor_vec2 p{in[0][i], in[1][i]}, period{in[2][i], in[3][i]}, pixel{in[4][i], in[5][i]};
        const std::uint32_t seed = block.seed(6, i);
        put(block, i,
            pixel.x > 0.0f || pixel.y > 0.0f
                ? filtered(p, {pixel.x, 0.0f}, {0.0f, pixel.y}, period, members, seed)
                : material(p, period, members, seed));
    }
}

template <typename Members, Material<Members> material, Filtered<Members> filtered>
Kernel kernel(const char* name, const Members& defaults) {
    std::vector<float> values(sizeof defaults / sizeof(float));
    std::memcpy(values.data(), &defaults, sizeof defaults);
    return {name, "x y period.x period.y pixel_size.x pixel_size.y seed ", 11,
            fill<Members, material, filtered>, values};
}

} // namespace

std::vector<Kernel> material_kernels() {
#define GABOR_MATERIAL(name, Members, option)                                                                \
    kernel<Members, gabor_##name##_at, gabor_##name##_filtered_at>(#name, gabor_##name##_default()),
    return {
#include "material_rows.inc"
    };
#undef GABOR_MATERIAL
}
