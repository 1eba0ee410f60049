// C++ versions of the Open Shading Language's types and functions that the shaders in shaders/nodes/osl need.
#include "gabor_noise.hpp"

#include <algorithm>
#include <cmath>

struct vector : gabor_vec3 {
    using gabor_vec3::gabor_vec3;
    vector(float all) : gabor_vec3(all) {} // like OSL, which converts a number to a vector
    vector(gabor_vec3 v) : gabor_vec3(v) {}
};
vector clamp(vector v, float low, float high) {
    return {std::clamp(v.x, low, high), std::clamp(v.y, low, high), std::clamp(v.z, low, high)};
}
float dot(vector u, vector v) {
    return gabor_cpp_dot(u, v);
}
float length(vector v) {
    return std::sqrt(dot(v, v));
}
auto mix(auto a, auto b, float t) {
    return a * (1 - t) + b * t;
}
using std::abs, std::atan2, std::ceil, std::clamp, std::exp, std::floor, std::hypot, std::log2, std::max,
    std::min, std::pow, std::sqrt, std::trunc;

float mod(float a, float b) {
    return a - b * std::floor(a / b);
}
vector normalize(vector v) {
    return v * vector(1 / std::hypot(v.x, v.y, v.z));
}
const float M_2PI = 6.2831853f;
using point = vector;
