#pragma once

// Shared by the files that read and write EXR.

#include "image/exr.hpp"

#include <ImfFrameBuffer.h>
#include <ImfThreading.h>

#include <mutex>
#include <thread>

namespace gabor::image {

/// Gives OpenEXR's thread pool, which starts empty, one thread per core.
inline void start_exr_threads() {
    static std::once_flag once;
    std::call_once(once,
                   [] { Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency())); });
}

/// Describes rows of interleaved channels. The first value belongs to the pixel `corner`.
template <typename Value>
Imf::FrameBuffer frame_buffer(Imf::PixelType type, const Value* values,
                              const std::vector<std::string>& channels, const Imath::V2i& corner, int width,
                              int rows) {
    const std::size_t pixel = channels.size() * sizeof(Value);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels.size(); ++c)
        frame.insert(channels[c], Imf::Slice::Make(type, values + c, corner, width, rows, pixel,
                                                   pixel * static_cast<std::size_t>(width)));
    return frame;
}

/// Throws RequestError for a truncated or damaged file; `how` is OpenEXR's message.
[[noreturn]] void refuse_damaged_exr(const std::filesystem::path& path, std::string_view how);

/// Returns how many threads may decode the file. Throws RequestError if the file is not safe to open.
int inspect_exr(const std::filesystem::path& path);

} // namespace gabor::image
