#pragma once

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

} // namespace gabor::image
