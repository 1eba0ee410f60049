// Runs gabor_erosion.osl as C++ and the drop-in's translation: scene_osl_erosion VALUES.raw. Writes the
// Height, Ridge and Slope of both at each point.
#include "osl.hpp"

#include <fstream>

namespace osl {
#include GABOR_OSL
}

#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const float u = (float(x) + 0.5f) / 32, v = (float(y) + 0.5f) / 32;
            float height, ridge;
            vector slope(0);
            osl::gabor_erosion(vector(u, v, 0), 1, 7, 5, 1.5f, 0.12f, 2, 0.5f, 0.5f, 1.5f, 2, 0.1f, 0.1f,
                               0.5f, 1, height, slope, ridge);
            const gabor_vec2 p{u, v};
            const GaborTerrain expected = gabor_eroded(p, gabor_terrain(p, 7), gabor_erosion(), 7);
            const float outputs[]{height,          ridge,          slope.x,          slope.y,
                                  expected.height, expected.ridge, expected.slope.x, expected.slope.y};
            file.write(reinterpret_cast<const char*>(outputs), sizeof outputs);
        }
    }
}
