// Macros for headers that both C++ and GLSL include, so that their declarations cannot differ.
// PASS_interface.h declares the push constants and group size of a pass. In C++ the declarations are in
// gabor::passes, with vectors aligned as in GLSL.

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
struct alignas(16) uvec4 {
    uint x, y, z, w;
};

} // namespace gabor::passes

#define GABOR_INTERFACE_BEGIN namespace gabor::passes {
#define GABOR_INTERFACE_END }
#define GABOR_PUSH_CONSTANTS(name) struct name

#else // GLSL

#define GABOR_INTERFACE_BEGIN
#define GABOR_INTERFACE_END
#define GABOR_PUSH_CONSTANTS(name) layout(push_constant) uniform name

#endif

// The push constants of every pass over a picture begin with the band that it fills:
//   first_column, first_row   of the band, counted in the pass's tables or in the picture
//   width, height             pixels
//   before                    number of pixels in the buffer before the band
//   first_run                 the first run of the band's rows, in passes/bake.comp
#define GABOR_BAND                                                                                           \
    int first_column;                                                                                        \
    int first_row;                                                                                           \
    int width;                                                                                               \
    int height;                                                                                              \
    int before;                                                                                              \
    uint first_run;

#ifdef __cplusplus
namespace gabor::passes {
struct Band {
    GABOR_BAND
};
} // namespace gabor::passes
#endif

#endif // GABOR_INTERFACE_H
