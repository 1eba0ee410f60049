// Tests the functions of golden/functions.glsl on the device. Thousands of values must equal those of the
// translation to C++. tests/functions compares this translation with the reference, and tests/golden with
// this version's recorded values. After an intended change of pixels, rewrite the files and review the diff:
//
//     GABOR_GOLDEN=write ctest --preset dev -R '^golden_'

#include "golden/file.hpp"
#include "largest.hpp"
#include "vulkan/pass.hpp"

#include "passes/golden_direction.h"
#include "passes/golden_erosion.h"
#include "passes/golden_fractal.h"
#include "passes/golden_lattice_2.h"
#include "passes/golden_lattice_3.h"
#include "passes/golden_lattice_4.h"
#include "passes/golden_noise_3d.h"
#include "passes/golden_ocean.h"
#include "passes/golden_sparse_one.h"
#include "passes/golden_sparse_own.h"
#include "passes/golden_sparse_paper.h"
#include "passes/golden_sparse_pure.h"
#include "passes/golden_spectrum.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

using gabor::test::Rows;

namespace {

struct Set {
    const char* name;
    std::span<const std::uint32_t> spirv;

    std::string file() const { return std::string(GABOR_GOLDEN_FOLDER "/") + name + ".txt"; }
};

const Set core[]{{"sparse_one", golden_sparse_one_spirv}, {"lattice_3", golden_lattice_3_spirv}};
const Set others[]{{"sparse_pure", golden_sparse_pure_spirv}, {"sparse_paper", golden_sparse_paper_spirv},
                   {"sparse_own", golden_sparse_own_spirv},   {"lattice_2", golden_lattice_2_spirv},
                   {"lattice_4", golden_lattice_4_spirv},     {"spectrum", golden_spectrum_spirv},
                   {"direction", golden_direction_spirv},     {"noise_3d", golden_noise_3d_spirv},
                   {"erosion", golden_erosion_spirv},         {"ocean", golden_ocean_spirv},
                   {"fractal", golden_fractal_spirv}};

// The first 64 points have golden values, the next 4096 have arbitrary arguments.
constexpr std::size_t compared = 64 * 65, groups = 65 + 256, points = 64 * groups;

// Runs all calls of a set at all points on the device, and keeps the results.
class Values {
  public:
    Values(const gabor::vulkan::Device& device, const Set& set)
        : calls_(gabor::test::calls(set.file())),
          buffer_(device, points * calls_.size() * sizeof(float), gabor::vulkan::Memory::readback) {
        const gabor::vulkan::Pass pass(device, set.spirv, {1});
        gabor::vulkan::Job job(device, pass, {buffer_});
        const gabor::vulkan::Job::Dispatch dispatch{{}, {groups}};
        const auto start = std::chrono::steady_clock::now();
        job.submit(std::span(&dispatch, 1));
        const double seconds = job.wait();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        CHECK((seconds > elapsed.count() / 1e4 && seconds < 1.01 * elapsed.count()) != std::isnan(seconds));
    }

    const std::vector<std::string>& calls() const { return calls_; }
    float at(std::size_t call, std::size_t point) const { return buffer_.as<float>()[points * call + point]; }

  private:
    std::vector<std::string> calls_;
    gabor::vulkan::Buffer buffer_;
};

// Returns the results of the translation to C++ at the points to compare: those of all calls at the first
// point, then at the next.
std::vector<float> translated(const Set& set, std::size_t calls) {
    const std::string command =
        fmt::format(GABOR_FUNCTIONS_FOLDER "/golden_{} {} {}", set.name, compared, points - compared);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::vector<float> values(calls * (points - compared) + 1); // one more than expected, to notice a surplus
    values.resize(std::fread(values.data(), sizeof(float), values.size(), pipe.get()));
    REQUIRE(values.size() == calls * (points - compared));
    return values;
}

// Returns how many times more sensitive a result is to the rounding of its arguments than most results are.
// GPUs fuse products and sums, without rounding the product, which shifts distant points, as in
// functions.cpp.
double sensitivity(const std::string& call, std::size_t point, bool fused) {
    const auto has = [&](const char* word) { return call.find(word) != std::string::npos; };
    if (fused && (has("gabor_er") || has("gabor_terrain"))) // where stripes vanish, their phase is arbitrary
        return 10000;
    if (fused && point / 4 % 4 == 3)
        return 6000;
    if (fused && has("gabor_water_at")) // waves about to be left out
        return 100;
    if (fused && (point % 16 == 1 || point % 16 == 7)) // the highest frequencies, and pixels that are lines
        return 16;
    if (has("filtered") && point % 16 == 15) // pixels a thousand times as long as wide
        return 1000;
    if (has("gabor_foam")) // edges of patches are steep
        return 20;
    if (has("gabor_er") && point / 4 % 4 == 3) // far from the origin, each octave rounds its position
        return 400;
    if ((has("3d") || has("surface")) && point % 16 == 1) // the highest frequencies
        return 4;
    // Phases of small values and sums of many waves are more sensitive.
    return has("turns_intensity") || has("SPREAD") || has("isotropic") ? 4 : 1;
}

void check(std::span<const Set> sets) {
    const gabor::vulkan::Device device;
    for (const Set& set : sets) {
        const Values values(device, set);
        INFO(set.name);
        // SwiftShader's sine and arctangent are off by 2e-4.
        const double tolerance = device.info().name.find("SwiftShader") == std::string::npos ? 5e-5 : 5e-4;
        const bool fused = device.info().kind != "CPU";
        const std::size_t count = values.calls().size();
        const std::vector<float> expected = translated(set, count);
        gabor::test::Largest largest;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const std::string& call = values.calls()[i % count];
            const std::size_t point = compared + i / count;
            largest.see(double{values.at(i % count, point)}, double{expected[i]},
                        tolerance * sensitivity(call, point, fused) *
                            std::max(1.0, std::abs(double{expected[i]})),
                        [&] { return fmt::format("{}, point {}", call, point); });
        }
        largest.check(set.name);
        for (std::size_t call = 0; call < count; ++call)
            for (std::size_t point = Rows::points; point < compared; ++point) {
                const float value = values.at(call, point);
                if (!gabor::test::is_in_range(values.calls()[call], -static_cast<int>(point), value))
                    FAIL_CHECK(values.calls()[call] << " is " << value << " at point " << point);
            }
    }
}

} // namespace

TEST_CASE("noise functions give the same values on the device as in C++, and finite values for any arguments",
          "[golden][core]") {
    check(core);
}

TEST_CASE("functions with other macros, and of other drop-ins, give the same values on the device as in C++",
          "[golden]") {
    check(others);
}
