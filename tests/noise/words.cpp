// Writes the words of the first impulses of SIDE x SIDE cells around the origin to stdout, row by row, for
// tools/hash-picture: words SIDE SEED.

#include "reference/reference.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const std::int32_t side = std::atoi(argv[1]);
    const auto seed = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
    std::vector<std::uint32_t> row;
    for (std::int32_t y = -side / 2; y < side - side / 2; ++y) {
        row.clear();
        for (std::int32_t x = -side / 2; x < side - side / 2; ++x)
            row.push_back(gabor::noise::impulse_word(x, y, 0, seed));
        if (std::fwrite(row.data(), sizeof(std::uint32_t), row.size(), stdout) != row.size())
            return 1;
    }
    return std::fflush(stdout) == 0 ? 0 : 1;
}
