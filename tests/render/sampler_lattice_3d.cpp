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
    switch (entry) {
    case Entry3d::field:
        return sample_lattice_3d_field_spirv;
    case Entry3d::isotropic:
        return sample_lattice_3d_isotropic_spirv;
    case Entry3d::surface:
        return sample_lattice_3d_surface_spirv;
    case Entry3d::surface_isotropic:
        return sample_lattice_3d_surface_isotropic_spirv;
    case Entry3d::noise:
        return sample_lattice_3d_noise_spirv;
    case Entry3d::complex:
        return sample_lattice_3d_complex_spirv;
    case Entry3d::gradient:
        return sample_lattice_3d_gradient_spirv;
    case Entry3d::four:
        return sample_lattice_3d_four_spirv;
    case Entry3d::tiled:
        return sample_lattice_3d_tiled_spirv;
    case Entry3d::animated:
        return sample_lattice_3d_animated_spirv;
    case Entry3d::filtered:
        return sample_lattice_3d_filtered_spirv;
    case Entry3d::noise_isotropic:
        return sample_lattice_3d_noise_isotropic_spirv;
    case Entry3d::noise_isotropic_gradient:
        return sample_lattice_3d_noise_isotropic_gradient_spirv;
    case Entry3d::noise_isotropic_filtered:
        return sample_lattice_3d_noise_isotropic_filtered_spirv;
    case Entry3d::noise_surface:
        return sample_lattice_3d_noise_surface_spirv;
    case Entry3d::noise_surface_isotropic:
        return sample_lattice_3d_noise_surface_isotropic_spirv;
    }
    return {};
}

} // namespace gabor::test
