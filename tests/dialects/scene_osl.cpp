// The functions of a shader in the Open Shading Language, the file GABOR_OSL, as C++ on the CPU:
// scene_osl VALUES.raw
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

#include GABOR_OSL

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const vector p((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32, 0);
            const float value = gabor_impl_field2d(p, 4.0f * gabor_impl_wave(0.7854f / 6.2831853f), 7).x;
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
}
