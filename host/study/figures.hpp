#pragma once

// Each figure and question of the study, in the file of its name.

#include "study/study.hpp"

namespace gabor::study {

using Tables = std::vector<Table>;
using Folder = std::filesystem::path;

Tables figure1(const vulkan::Device& device, const Effort& effort);
Tables figure2(const vulkan::Device& device, const Effort& effort);
void figure2_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder);
Tables figure3(const vulkan::Device& device, const Effort& effort);
Tables figure4(const vulkan::Device& device, const Effort& effort);
Tables figure5(const vulkan::Device& device, const Effort& effort);
Tables figure6(const vulkan::Device& device, const Effort& effort);
void figure6_pictures(const vulkan::Device& device, const Effort& effort, const Folder& folder);
Tables stationarity(const vulkan::Device& device, const Effort& effort);
Tables frontier(const vulkan::Device& device, const Effort& effort);
Tables future(const vulkan::Device& device, const Effort& effort);

} // namespace gabor::study
