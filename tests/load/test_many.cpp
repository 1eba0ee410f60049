// A process that renders repeatedly leaks neither memory nor descriptors. GABOR_RENDERS is the number of
// renders.

#include "../image/scratch_folder.hpp"
#include "image/exr.hpp"
#include "render/output/renderer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

using namespace gabor;

namespace {

int renders() {
    const char* text = std::getenv("GABOR_RENDERS");
    return text ? std::atoi(text) : 40;
}

std::ptrdiff_t descriptors() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

// The resident memory now, in MiB.
double memory() {
    std::ifstream statm("/proc/self/statm");
    long size = 0, resident = 0;
    statm >> size >> resident;
    return static_cast<double>(resident * ::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void render_file(const vulkan::Device& device, const std::filesystem::path& path, int seed) {
    const render::Request request{.width = 300, .height = 200, .seed = static_cast<std::uint32_t>(seed)};
    image::ExrWriter exr(path, {{0, 0, 300, 200}, {0, 0, 300, 200}, render::channels(request), "zip", ""});
    render::render_region(device, request, {0, 0, 300, 200},
                          [&](std::span<const float> values) { exr.write_rows(values); });
    exr.commit();
}

// Runs `work` a few times before counting, so that permanent allocations exist.
template <typename Work>
void check_growth(const char* name, int times, double limit, Work work) {
    const int before = times / 4;
    for (int i = 0; i < before; ++i)
        work(i);
    const std::ptrdiff_t descriptors_before = descriptors();
    const double memory_before = memory();
    for (int i = before; i < times; ++i)
        work(i);
    const double grown = memory() - memory_before;
    fmt::print("{} {}: memory {:.1f} MiB and {:+.2f}, descriptors {} and {:+}\n", times, name, memory_before,
               grown, descriptors_before, descriptors() - descriptors_before);
    CHECK(descriptors() == descriptors_before);
    CHECK(grown < limit);
}

} // namespace

TEST_CASE("repeated renders on one device, and on a new device each, leak nothing", "[load]") {
    const ScratchFolder folder;
    const std::filesystem::path path = folder / "many.exr";
    // Keeps the driver loaded: SwiftShader leaks a descriptor whenever it is unloaded.
    const vulkan::Device device;
    // In MiB: the memory that allocators keep in reserve varies by less than 4. Mesa 25 keeps 1.6 for each
    // device.
    const int devices = renders() / 5;
    check_growth("renders", renders(), 4, [&](int i) { render_file(device, path, i); });
    check_growth("devices", devices, 4 + 2 * devices, [&](int i) { render_file(vulkan::Device(), path, i); });
}
