// For tests that use a device: turns validation layers on unless GABOR_VALIDATION says otherwise, and makes
// any message from them a failure. Catch2 provides main; a custom main would have to compile Catch2 again,
// which takes 20 seconds.

#include "vulkan/device.hpp"

#include <cstdio>
#include <cstdlib>

[[maybe_unused]] static const bool validates = [] {
    setenv("GABOR_VALIDATION", "1", 0);
    return std::atexit([] {
               if (gabor::vulkan::validation_messages() == 0)
                   return;
               std::fflush(nullptr);
               std::_Exit(1);
           }) == 0;
}();
