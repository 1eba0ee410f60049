// For tests that use a device: validation layers, unless GABOR_VALIDATION says otherwise, any message of
// which is a failure. Catch2 brings main; a main of its own would compile Catch2 once more, for 20 seconds.

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
