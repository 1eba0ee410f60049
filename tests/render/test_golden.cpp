// The values of golden/functions.glsl on the device, where they compile within seconds: all of them are
// compared in C++, by golden/functions.cpp. After an intended change of pixels, rewrite the files and review
// the diff:
//
//     GABOR_GOLDEN=write ctest --preset dev -R '^golden_'

#include "golden/file.hpp"
#include "vulkan/pass.hpp"

#include "passes/golden_lattice_2.h"
#include "passes/golden_lattice_3.h"
#include "passes/golden_lattice_4.h"
#include "passes/golden_noise_one.h"
#include "passes/golden_noise_own.h"
#include "passes/golden_noise_paper.h"
#include "passes/golden_noise_pure.h"
#include "passes/golden_spectrum.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

using gabor::test::Rows;

TEST_CASE("public functions give the values of this version", "[golden]") {
    const gabor::vulkan::Device device;
    struct Set {
        const char* name;
        std::span<const std::uint32_t> spirv;
    };
    for (const auto& [name, spirv] :
         {Set{"noise_one", golden_noise_one_spirv}, Set{"noise_pure", golden_noise_pure_spirv},
          Set{"noise_paper", golden_noise_paper_spirv}, Set{"noise_own", golden_noise_own_spirv},
          Set{"lattice_2", golden_lattice_2_spirv}, Set{"lattice_3", golden_lattice_3_spirv},
          Set{"lattice_4", golden_lattice_4_spirv}, Set{"spectrum", golden_spectrum_spirv}}) {
        constexpr std::size_t points = Rows::points, most = 64; // calls
        const gabor::vulkan::Buffer buffer(device, points * most * sizeof(float),
                                           gabor::vulkan::Memory::readback);
        const std::span<float> values = buffer.as<float>();
        std::ranges::fill(values, std::numeric_limits<float>::quiet_NaN());
        const gabor::vulkan::Pass pass(device, spirv, {1});
        gabor::vulkan::Job job(device, pass, {buffer});
        const gabor::vulkan::Job::Dispatch dispatch{{}, {1}};
        job.submit(std::span(&dispatch, 1));
        job.wait();
        Rows rows;
        for (std::size_t point = 0; point < points; ++point) {
            rows.begin(static_cast<int>(point));
            for (std::size_t call = 0; call < most && !std::isnan(values[points * call]); ++call)
                rows.see("", double{values[points * call + point]});
        }
        INFO(name);
        CHECK(rows.compare(std::string(GABOR_GOLDEN_FOLDER "/") + name + ".txt", 5e-5, 5e-5));
    }
}
