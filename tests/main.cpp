// Catch2's main with validation layers, unless GABOR_VALIDATION says otherwise; any message of theirs is a
// failure.

#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "vulkan/device.hpp"

#include <cstdlib>

int main(int argc, char** argv) {
    setenv("GABOR_VALIDATION", "1", 0);
    const int failed = Catch::Session().run(argc, argv);
    return failed ? failed : gabor::vulkan::validation_messages() != 0;
}
