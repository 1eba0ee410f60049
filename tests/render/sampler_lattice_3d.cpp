#include "sampler_lattice_3d.hpp"

#include "passes/sample_lattice_3d_animated.h"
#include "passes/sample_lattice_3d_complex.h"
#include "passes/sample_lattice_3d_field.h"
#include "passes/sample_lattice_3d_filtered.h"
#include "passes/sample_lattice_3d_four.h"
#include "passes/sample_lattice_3d_gradient.h"
#include "passes/sample_lattice_3d_isotropic.h"
#include "passes/sample_lattice_3d_noise.h"
#include "passes/sample_lattice_3d_noise_isotropic.h"
#include "passes/sample_lattice_3d_noise_isotropic_filtered.h"
#include "passes/sample_lattice_3d_noise_isotropic_gradient.h"
#include "passes/sample_lattice_3d_noise_surface.h"
#include "passes/sample_lattice_3d_noise_surface_isotropic.h"
#include "passes/sample_lattice_3d_surface.h"
#include "passes/sample_lattice_3d_surface_isotropic.h"
#include "passes/sample_lattice_3d_tiled.h"

namespace gabor::test {

std::span<const std::uint32_t> spirv_of(Entry3d entry) {
    const std::span<const std::uint32_t> passes[]{sample_lattice_3d_field_spirv,
                                                  sample_lattice_3d_isotropic_spirv,
                                                  sample_lattice_3d_surface_spirv,
                                                  sample_lattice_3d_surface_isotropic_spirv,
                                                  sample_lattice_3d_noise_spirv,
                                                  sample_lattice_3d_complex_spirv,
                                                  sample_lattice_3d_gradient_spirv,
                                                  sample_lattice_3d_four_spirv,
                                                  sample_lattice_3d_tiled_spirv,
                                                  sample_lattice_3d_animated_spirv,
                                                  sample_lattice_3d_filtered_spirv,
                                                  sample_lattice_3d_noise_isotropic_spirv,
                                                  sample_lattice_3d_noise_isotropic_gradient_spirv,
                                                  sample_lattice_3d_noise_isotropic_filtered_spirv,
                                                  sample_lattice_3d_noise_surface_spirv,
                                                  sample_lattice_3d_noise_surface_isotropic_spirv};
    return passes[static_cast<std::size_t>(entry)];
}

} // namespace gabor::test
