// The functions of a shader in the Open Shading Language, the file GABOR_OSL, as C++ on the CPU:
// scene_osl VALUES.raw
#include <algorithm>
#include <cmath>
#include <fstream>

struct vector {
    float x, y, z;
    explicit vector(float all) : x(all), y(all), z(all) {}
    vector(float x, float y, float z) : x(x), y(y), z(z) {}
    float operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    void operator+=(vector v) { *this = vector(x + v.x, y + v.y, z + v.z); }
};
vector operator*(float s, vector v) {
    return vector(s * v.x, s * v.y, s * v.z);
}
vector operator/(vector v, float s) {
    return vector(v.x / s, v.y / s, v.z / s);
}

const float M_2PI = 6.2831853f;
using std::abs, std::clamp, std::cos, std::floor, std::min, std::sin;

#include GABOR_OSL

int main(int, char** argv) {
    std::ofstream file(argv[1], std::ios::binary);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const float value =
                gabor_noise_complex((float(x) + 0.5f) / 32, (float(y) + 0.5f) / 32, 4, 0.7854f, 7)[1];
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
}
