#pragma once

#include <cstdint>
#include <cstdlib>

/// Draws per figure of a test of randomness.
inline std::uint64_t draws() {
    const char* text = std::getenv("GABOR_DRAWS");
    return text ? std::strtoull(text, nullptr, 10) : 2'000'000;
}
