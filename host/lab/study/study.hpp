#pragma once

#include "study/table.hpp"
#include "vulkan/device.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace gabor::study {

/// The numbers of samples.
struct Effort {
    std::uint64_t samples;     ///< values of independent instances, per row
    std::uint64_t windows;     ///< of independent instances, per row
    std::uint64_t places;      ///< instances per place of a cell, per row
    std::uint64_t law;         ///< values at each place of a cell, and pairs of values, per row
    std::vector<int> impulses; ///< N along the axis of a figure
    std::vector<double> radii; ///< R of recipes, cells
    int picture_bits;          ///< pictures have 2^bits x 2^bits pixels
    int timings;               ///< of which the median is taken

    /// The paper's seven million samples, and N up to 30: all up to 10, then fewer.
    static Effort full();
    /// Small numbers: the whole study in two minutes on a software device.
    static Effort quick();
};

/// A figure or a question: its tables, and a function that writes its pictures.
struct Study {
    std::string_view name;
    std::string_view description; ///< for help texts
    std::vector<Table> (*tables)(const vulkan::Device& device, const Effort& effort);
    /// May be null.
    void (*pictures)(const vulkan::Device& device, const Effort& effort, const std::filesystem::path& folder);
};

/// All of them, in reading order.
std::span<const Study> studies();

/// Throws RequestError with the known names.
const Study& find_study(std::string_view name);

/// Returns the figure of that name, or all for `all`. Throws RequestError with the known names.
std::vector<Study> find_studies(std::string_view name);

} // namespace gabor::study
