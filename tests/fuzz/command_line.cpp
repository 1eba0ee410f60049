// Parses a command line, one word per line of the input, and stops where a device is needed.

#include "program.hpp"

#include <algorithm>
#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string text(reinterpret_cast<const char*>(data), size);
    std::ranges::replace(text, '/', '_'); // no path may leave the folder
    std::istringstream lines(text);
    std::vector<std::string> arguments;
    for (std::string line; std::getline(lines, line);)
        arguments.push_back(line);
    gabor::fuzz::run(arguments);
    return 0;
}
