#include "cli/program.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

int main(int argc, char** argv) {
    std::vector<char*> words(argv, argv + argc);
    // gabor render --terrain runs the command terrain, which has other options.
    const auto terrain = std::ranges::find(words, std::string_view("--terrain"),
                                           [](const char* word) { return std::string_view(word); });
    static char command[] = "terrain";
    if (argc > 2 && words[1] == std::string_view("render") && terrain != words.end()) {
        words.erase(terrain);
        words[1] = command;
    }
    return gabor::cli::run(gabor::cli::gabor_program(), static_cast<int>(words.size()), words.data());
}
