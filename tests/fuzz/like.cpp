// Runs `gabor render --like` on a file of arbitrary bytes, and stops where a device is needed.

#include "program.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const gabor::fuzz::MemoryFile file({data, size});
    gabor::fuzz::run({"render", "--like", file.path(), "-o", "none.exr"});
    return 0;
}
