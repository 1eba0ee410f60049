#version 450
#extension GL_GOOGLE_include_directive : require

// Shows the values of a grid, coarse or fine, through a colour map.

#include "colours.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; };

// Constants, because a CPU would go through every branch.
layout(constant_id = 0) const int shown = 0;    // 0 value, 1 gradient, 2 phase, 3 intensity, 4 variance
layout(constant_id = 1) const int colours = 0;  // the colour map
layout(constant_id = 2) const int channels = 1;
layout(constant_id = 3) const int coarse = 0;   // 1 where the grid is coarser than the pixels
layout(constant_id = 4) const int last = 0;     // the last channel: 1 variance removed by the filter, 2 coverage

layout(push_constant) uniform Push {
    vec2 origin;    // of the canvas in the framebuffer, pixels
    ivec2 grid;     // values each way
    float stride;   // pixels per value
    float contrast; // standard deviations from the mean to the ends
    float slope;    // standard deviation of a derivative, per kernel radius
};

layout(location = 0) out vec4 colour;

float value_at(ivec2 at, int channel)
{
    at = clamp(at, ivec2(0), grid - 1);
    return values[(at.y * grid.x + at.x) * channels + channel];
}

// Linear between the values of a coarse grid; exactly the value where there is one for each pixel.
float value(vec2 pixel, int channel)
{
    if (coarse == 0)
        return value_at(ivec2(pixel), channel);
    vec2 at = pixel / stride - 0.5;
    ivec2 corner = ivec2(floor(at));
    vec2 f = at - vec2(corner);
    return mix(mix(value_at(corner, channel), value_at(corner + ivec2(1, 0), channel), f.x),
               mix(value_at(corner + ivec2(0, 1), channel), value_at(corner + 1, channel), f.x), f.y);
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - origin;
    float noise = value(pixel, 0);
    vec3 seen;
    if (shown == 1) {
        vec3 normal = normalize(vec3(-value(pixel, 1), -value(pixel, 2), 2.0 * slope / contrast));
        seen = 0.5 + 0.5 * normal;
    } else if (shown == 2 || shown == 3) {
        float other = value(pixel, 1);
        float phase = fract(atan(noise, other) / 6.2831853);
        if (shown == 2)
            seen = colours == 0 ? vec3(phase) : viewer_cycle(phase);
        else
            seen = viewer_colour(colours, length(vec2(noise, other)) / (1.5 * contrast));
    } else if (shown == 4) {
        seen = viewer_colour(colours, last == 1 ? 1.0 - value(pixel, channels - 1) : 1.0);
    } else {
        seen = viewer_colour(colours, 0.5 + 0.5 * noise / contrast);
    }
    float coverage = last == 2 ? value(pixel, channels - 1) : 1.0;
    colour = vec4(mix(vec3(0.05, 0.05, 0.055), clamp(seen, 0.0, 1.0), coverage), 1.0);
}
