// C++ versions of the Open Shading Language's types and functions that the shaders in shaders/nodes/osl need.
#include <algorithm>
#include <cmath>

struct vector {
    float x, y, z;
    vector(float all) : x(all), y(all), z(all) {} // like OSL, which converts a number to a vector
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
vector operator/(vector u, float divisor) {
    return {u.x / divisor, u.y / divisor, u.z / divisor};
}
vector clamp(vector v, float low, float high) {
    return {std::clamp(v.x, low, high), std::clamp(v.y, low, high), std::clamp(v.z, low, high)};
}
vector& operator+=(vector& u, vector v) {
    return u = u + v;
}
vector& operator-=(vector& u, vector v) {
    return u = u - v;
}
vector& operator*=(vector& u, vector v) {
    return u = u * v;
}
vector& operator/=(vector& u, float divisor) {
    return u = u / divisor;
}
float dot(vector u, vector v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}
float length(vector v) {
    return std::sqrt(dot(v, v));
}
template <typename T>
T mix(T a, T b, float t) {
    return a * (1 - t) + b * t;
}
using std::abs, std::clamp, std::floor, std::max, std::sqrt;

double mod(double a, double b) {
    return a - b * std::floor(a / b);
}
double min(double a, double b) {
    return std::min(a, b);
}
double max(float a, double b) {
    return std::max<double>(a, b);
}
vector normalize(vector v) {
    return v * vector(1 / std::hypot(v.x, v.y, v.z));
}
const float M_2PI = 6.2831853f;
using std::atan2, std::hypot;
using point = vector;
