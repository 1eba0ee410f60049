// Writes a grey picture of the noise as a relief, lit from the upper left. To run it:
// c++ -std=c++11 -O3 -I ../../translations relief.cpp && ./a.out > relief.pgm
#include "gabor_noise.hpp"

#include <cstdio>

int main() {
    std::printf("P5 768 256 255\n");
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 768; ++x) {
            // From left to right, the frequency grows and the waves turn.
            const gabor_vec2 p(float(x) / 32.0f, float(y) / 32.0f);
            const gabor_vec3 n = gabor_noise_gradient(p, 0.5f + 0.1f * p.x, 0.13f * p.x, 7u);
            const float light = 0.55f - 0.02f * (n.y + n.z) + 0.08f * n.x;
            std::putchar(int(255.0f * (light < 0.0f ? 0.0f : light > 1.0f ? 1.0f : light)));
        }
    }
}
