// Runs an Open Shading Language shader as C++: scene_osl VALUES.raw. The file GABOR_OSL defines the shader as
// a function of its parameters. Writes Noise, Gradient, Value, Phase and Intensity at each point, first in
// the plane, then in space.
#include "osl.hpp"

#include <fstream>

#include GABOR_OSL

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            vector gradient(0);
            float noise, value, phase, intensity;
            const vector p((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32, 0.3f);
            for (const int solid : {0, 1}) {
                gabor_noise(p * 0.25f, 4, 4, 0.7854f, 7, solid, vector(1, 2, 3), value, phase, intensity,
                            noise, gradient);
                const float outputs[]{noise, gradient.x, gradient.y, gradient.z, value, phase, intensity};
                file.write(reinterpret_cast<const char*>(outputs), sizeof outputs);
            }
        }
    }
}
