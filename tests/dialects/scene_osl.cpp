// Runs a shader in the Open Shading Language as C++: scene_osl VALUES.raw. In the file GABOR_OSL the shader
// is a function of its parameters. Writes Noise, Gradient, Value, Phase and Intensity for each place, first
// in the plane, then in space.
#include <algorithm>
#include <cmath>
#include <fstream>

struct vector {
    float x, y, z;
    vector(float all) : x(all), y(all), z(all) {} // as in OSL, where a number is a vector of three
    vector(float x, float y, float z) : x(x), y(y), z(z) {}
    float operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
vector operator+(vector u, vector v) {
    return {u.x + v.x, u.y + v.y, u.z + v.z};
}
vector operator-(vector u, vector v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
}
vector operator*(vector u, vector v) {
    return {u.x * v.x, u.y * v.y, u.z * v.z};
}
vector clamp(vector v, float low, float high) {
    return {std::clamp(v.x, low, high), std::clamp(v.y, low, high), std::clamp(v.z, low, high)};
}
using std::abs, std::clamp, std::floor;

double mod(double a, double b) {
    return a - b * std::floor(a / b);
}
double min(double a, double b) {
    return std::min(a, b);
}
vector normalize(vector v) {
    return v * vector(1 / std::hypot(v.x, v.y, v.z));
}
const float M_2PI = 6.2831853f;
using std::atan2, std::hypot;
using point = vector;

#include GABOR_OSL

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            vector gradient(0);
            float noise, value, phase, intensity;
            const vector p((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32, 0.3f);
            for (const int solid : {0, 1}) {
                gabor_lattice(p * 0.25f, 4, 4, 0.7854f, 7, solid, vector(1, 2, 3), value, phase, intensity,
                              noise, gradient);
                const float outputs[]{noise, gradient.x, gradient.y, gradient.z, value, phase, intensity};
                file.write(reinterpret_cast<const char*>(outputs), sizeof outputs);
            }
        }
    }
}
