// Turns three sums of noises, the components, into the colour of a pixel. The including file defines `colour_binding`, the
// binding of the buffer.

#include "passes/colour.h"

layout(std430, set = 0, binding = colour_binding) readonly buffer Colour { PixelsColour colour; };

// A polynomial gives each component its own distribution. If a filter removed the variance v, the component is the mean of
// the polynomial at z + r, where the removed part r is normal with variance v.
vec3 colour_of(vec3 z, vec3 v) {
    z = clamp(z, -4.0, 4.0);
    vec3 s = z * z;
    vec3 even = colour.histogram[0].xyz + colour.histogram[2].xyz * (s + v)
              + colour.histogram[4].xyz * (s * (s + 6.0 * v) + 3.0 * v * v);
    vec3 odd = colour.histogram[1].xyz + colour.histogram[3].xyz * (s + 3.0 * v)
             + colour.histogram[5].xyz * (s * (s + 10.0 * v) + 15.0 * v * v);
    vec3 component = even + z * odd;
    return colour.mean.xyz + vec3(dot(colour.mixing[0].xyz, component), dot(colour.mixing[1].xyz, component),
                                  dot(colour.mixing[2].xyz, component));
}
