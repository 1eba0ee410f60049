#pragma once

#include <chrono>

namespace gabor {

using Clock = std::chrono::steady_clock;

/// The seconds that have passed since `start`.
inline double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace gabor
