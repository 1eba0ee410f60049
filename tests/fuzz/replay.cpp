// COPIES FOLDER... runs the target on every file in the folders, like libFuzzer's main with -runs=0, and on
// so many copies of each with flipped bits, half of which end early.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
    const int copies = std::atoi(argv[1]);
    std::size_t inputs = 0;
    for (int i = 2; i < argc; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::absolute(argv[i]))) {
            std::ifstream file(entry.path(), std::ios::binary);
            std::string input(std::istreambuf_iterator<char>(file), {});
            std::fprintf(stderr, "%s\n", entry.path().c_str()); // after a crash, the last name is the culprit
            const std::string whole = input;
            std::mt19937 random;
            for (int copy = 0; copy <= copies; ++copy) {
                LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
                input = whole.substr(0, copy % 2 ? whole.npos : random() % (whole.size() + 1));
                for (int bits = copy % 4; bits >= 0 && !input.empty(); --bits)
                    input[random() % input.size()] ^= static_cast<char>(1 << random() % 8);
            }
            ++inputs;
        }
    }
    std::fprintf(stderr, "%zu inputs\n", inputs);
    return inputs == 0;
}
