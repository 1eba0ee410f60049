// Lets one header declare push constants and group sizes for C++ and GLSL alike, so that the two cannot
// differ: PASS_interface.h beside the pass. C++ finds the declarations in gabor::passes, with vectors aligned
// as in GLSL.

#ifndef GABOR_INTERFACE_H
#define GABOR_INTERFACE_H

#ifdef __cplusplus

#include <cstdint>

namespace gabor::passes {

using uint = std::uint32_t;
struct alignas(8) vec2 {
    float x, y;
};
struct alignas(8) ivec2 {
    int x, y;
};
struct alignas(16) vec4 {
    float x, y, z, w;
};

} // namespace gabor::passes

#define GABOR_INTERFACE_BEGIN namespace gabor::passes {
#define GABOR_INTERFACE_END }
#define GABOR_PUSH_CONSTANTS(name) struct name

#else

#define GABOR_INTERFACE_BEGIN
#define GABOR_INTERFACE_END
#define GABOR_PUSH_CONSTANTS(name) layout(push_constant) uniform name

#endif

#endif // GABOR_INTERFACE_H
