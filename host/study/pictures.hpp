#pragma once

#include "study/noise.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace gabor::study {

/// Seconds on the device for a picture of 2^bits x 2^bits pixels, 32 to a kernel radius: the median over
/// `timings` rounds in which the noises take turns, so that what else the machine does touches all alike.
std::vector<double> picture_seconds(std::span<Noise> noises, int bits, int timings);

/// The picture itself.
std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed);

/// Writes a square picture's values as `path`.exr.
void write_exr(const std::filesystem::path& path, std::span<const float> pixels);

/// Writes a square picture as `path`.png: mean 0.5, two standard deviations to the ends.
void write_png(const std::filesystem::path& path, std::span<const float> pixels);

} // namespace gabor::study
