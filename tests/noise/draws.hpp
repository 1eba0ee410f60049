#pragma once

#include <cstdint>
#include <cstdlib>

/// The number of draws per figure in a test of randomness.
inline std::uint64_t draws() {
    const char* text = std::getenv("GABOR_DRAWS");
    return text ? std::strtoull(text, nullptr, 10) : 2'000'000;
}
