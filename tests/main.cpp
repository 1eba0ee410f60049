// Catch2's main, and after the run: any message of the validation layers is a failure.

#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "vulkan/device.hpp"

int main(int argc, char** argv) {
    const int failed = Catch::Session().run(argc, argv);
    return failed ? failed : gabor::vulkan::validation_messages() != 0;
}
