#pragma once

#include "study/table.hpp"
#include "vulkan/device.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace gabor::study {

/// How many samples to take.
struct Effort {
    std::uint64_t samples;     ///< values of independent instances, per row
    std::uint64_t windows;     ///< windows of independent instances, per row
    std::uint64_t places;      ///< instances at each position in a cell, per row
    std::uint64_t law;         ///< values at each position in a cell, and pairs of values, per row
    std::vector<int> impulses; ///< the values of N in figures
    std::vector<double> radii; ///< the values of R in `frontier`, in cells
    int picture_bits;          ///< pictures have 2^bits x 2^bits pixels
    int timings;               ///< number of timings whose median is taken

    /// Seven million samples as in the paper, and N up to 30: every N up to 10, then only some.
    static Effort full();
    /// Few samples: all studies take two minutes on a CPU driver.
    static Effort quick();
};

/// A figure of the paper, or a question beyond it: its tables, and a function that writes its pictures.
struct Study {
    std::string_view name;
    std::string_view description; ///< shown in help texts
    std::vector<Table> (*tables)(const vulkan::Device& device, const Effort& effort);
    /// Null if there are no pictures.
    void (*pictures)(const vulkan::Device& device, const Effort& effort, const std::filesystem::path& folder);
};

/// All studies, in the order of the help text.
std::span<const Study> studies();

/// Returns the study with that name, or all studies for `all`. Throws RequestError, listing the known names,
/// if there is none.
std::vector<Study> find_studies(std::string_view name);

} // namespace gabor::study
