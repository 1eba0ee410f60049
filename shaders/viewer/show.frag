#version 450
#extension GL_GOOGLE_include_directive : require

// Shows the values of a grid, coarse or fine, through a colour map.

#include "colours.glsl"
#include "passes/light.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; };

// Constants, because a CPU would go through every branch.
// 0 value, 1 gradient, 2 phase, 3 intensity, 4 variance, 5 phasor, 6 a lit height, 7 colours; of a material: 8 lit,
// 9 colour, 10 height, 11 normal, 12 roughness, 13 metalness
layout(constant_id = 0) const int shown = 0;
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
    float step;     // of a material: from value to value, in its units
    float green;    // of normals: 1 for up, as OpenGL has it, -1 for down, as DirectX
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

vec3 three(vec2 pixel, int first)
{
    return vec3(value(pixel, first), value(pixel, first + 1), value(pixel, first + 2));
}

// A normal along the picture's right and down and to the eye, as colours.
vec3 normal_map(vec3 normal)
{
    return 0.5 + 0.5 * normal * vec3(1.0, -green, 1.0);
}

vec3 srgb(vec3 light)
{
    light = clamp(light, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
}

// The noise as a height: a body has its own normal, after the gradient along the picture.
vec3 lit_noise(vec2 pixel, vec3 colour)
{
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec3 bump = vec3(value(pixel, 1), value(pixel, 2), 0.0);
    if (last == 2 && channels == 8) {
        normal = normalize(three(pixel, 3));
        bump.z = value(pixel, 6);
        bump -= dot(bump, normal) * normal;
    }
    normal = normalize(normal - bump * (0.5 * contrast / slope));
    vec2 size = vec2(grid) * stride;
    vec2 place = (pixel - 0.5 * size) / max(size.x, size.y);
    vec3 linear = pow(colour, vec3(2.2));
    return srgb(lit(Surface(linear, 0.45, 0.0), normal, eye_above(place), lamp_above(place)));
}

vec3 material(vec2 pixel)
{
    const int height = 3;
    if (shown == 8)
        return srgb(three(pixel, 6));
    if (shown == 9)
        return srgb(three(pixel, 0));
    if (shown == 10)
        return vec3(0.5 + value(pixel, height) / (0.1 * contrast));
    if (shown == 11) {
        float across = value(pixel + vec2(stride, 0.0), height) - value(pixel - vec2(stride, 0.0), height);
        float down = value(pixel + vec2(0.0, stride), height) - value(pixel - vec2(0.0, stride), height);
        return normal_map(normalize(vec3(-across, -down, 2.0 * step)));
    }
    return vec3(value(pixel, shown == 12 ? 4 : 5));
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - origin;
    float noise = value(pixel, 0);
    vec3 seen;
    if (shown >= 8) {
        seen = material(pixel);
    } else if (shown == 7) {
        seen = three(pixel, 0);
    } else if (shown == 1) {
        seen = normal_map(normalize(vec3(-value(pixel, 1), -value(pixel, 2), 2.0 * slope / contrast)));
    } else if (shown == 5) {
        seen = viewer_colour(colours, 0.5 + 0.5 * noise / max(length(vec2(noise, value(pixel, 1))), 1e-6));
    } else if (shown == 6) {
        seen = lit_noise(pixel, viewer_colour(colours, 0.5 + 0.5 * noise / contrast));
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
    float coverage = last == 2 && shown != 8 ? value(pixel, channels - 1) : 1.0; // light falls past a body too
    colour = vec4(mix(vec3(0.05, 0.05, 0.055), clamp(seen, 0.0, 1.0), coverage), 1.0);
}
