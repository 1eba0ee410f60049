#include <fstream>

#include "gabor_noise.hpp"

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 257; ++y) {
        for (int x = 0; x < 256; ++x) {
            const gabor_vec2 p = (gabor_vec2(float(x), float(y)) + 0.5f) / 32.0f;
            const float value = y < 256 ? gabor_noise(p, 4.0f, 0.7854f, 7u)
                                        : gabor_noise_at(gabor_ivec2(1000000000, -1000000000), p,
                                                         gabor_kernel(4.0f, 0.7854f), 7u);
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
}
