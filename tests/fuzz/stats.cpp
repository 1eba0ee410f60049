// Runs `gabor stats` on a file of arbitrary bytes: the EXR reader, the statistics and their JSON.

#include "program.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const gabor::fuzz::MemoryFile file({data, size});
    gabor::fuzz::run({"stats", file.path(), "--json", "-"});
    return 0;
}
