// Turns the channels of a picture into colours, for the window and for files.

#include "viewer/display_interface.h"
#include "viewer/colours.glsl"

// These are specialization constants because CPU drivers run every branch. The outputs are 0 value, 1 gradient, 2 phase,
// 3 intensity, 4 variance, 5 stripes, 6 lit height, 7 lit stripes, 8 colours and, for materials, 9 lit, 10 colour, 11 height,
// 12 normal, 13 roughness, 14 metalness.
layout(constant_id = display_output_id) const int output_shown = 0;
layout(constant_id = display_colours_id) const int colours = 0;      // the colour map
layout(constant_id = display_channels_id) const int channels = 1;
layout(constant_id = display_companion_id) const int companion = 0;    // the first channel that the output needs besides the noise
layout(constant_id = display_normal_id) const int normal_at = -1;   // first of four channels, a body's normal and gradient.z, or -1
layout(constant_id = display_coverage_id) const int coverage_at = -1; // channel of the coverage, -1 for none
layout(constant_id = display_coarse_id) const bool coarse = false;  // whether the grid is coarser than the pixels
layout(constant_id = display_tiles_id) const bool tiles = false;   // whether to repeat the canvas two by two
layout(constant_id = display_profile_id) const int profile = 0;      // profile of stripes
layout(constant_id = display_unlit_id) const bool unlit = false;   // whether to show normals instead of light
layout(constant_id = display_environment_id) const int environment = 0; // what surrounds a lit surface

#include "passes/channels.h"
#include "passes/light.glsl"
#include "passes/srgb.glsl"
#include "viewer/surface.glsl"

// The value of a channel at a pixel.
float value_at(vec2 pixel, int channel);

vec3 three_at(vec2 pixel, int first) {
    return vec3(value_at(pixel, first), value_at(pixel, first + 1), value_at(pixel, first + 2));
}

// The colour at a position from 0 to 1 in the colour map.
vec3 mapped(float share) {
    if (colours != own_colours)
        return viewer_colour(colours, share);
    vec4 stops[8];
    for (int i = 0; i < 8; ++i)
        stops[i] = unpackUnorm4x8(i < 4 ? ramp_low[i] : ramp_high[i - 4]);
    return viewer_own_colour(stops, share);
}

// Lights a surface of the given colour. `slope` is along x and y of the view and, for a body, towards the eye. A body has its
// own normal, stored after the gradient.
vec3 lit_surface(vec2 pixel, vec3 colour, vec3 slope) {
    vec3 normal = normal_at >= 0 ? normalize(three_at(pixel, normal_at)) : vec3(0.0, 0.0, 1.0);
    normal = bumped_normal(normal, slope * (0.5 * contrast / deviation));
    if (unlit)
        return viewer_normal(normal, green);
    return viewer_lit(colour, normal, picture_place(pixel, tiles ? 2.0 * size : size), lamp, normal_at >= 0);
}

float stripes(vec2 pixel) {
    return viewer_stripes(vec2(value_at(pixel, companion), value_at(pixel, 0)), profile, turns);
}

vec3 lit_stripes(vec2 pixel) {
    float height = stripes(pixel);
    vec2 at = max(pixel, vec2(1.5 * stride)); // the first row and column use the slopes of the second
    vec2 slope = vec2(stripes(vec2(at.x, pixel.y)) - stripes(vec2(at.x - stride, pixel.y)),
                      stripes(vec2(pixel.x, at.y)) - stripes(vec2(pixel.x, at.y - stride)));
    return lit_surface(pixel, mapped(height), vec3(2.0 * slope / spacing, 0.0));
}

vec3 material(vec2 pixel) {
    const int height = material_height;
    if (output_shown == 9)
        return srgb(three_at(pixel, material_lit));
    if (output_shown == 10)
        return srgb(three_at(pixel, material_colour));
    if (output_shown == 11)
        return viewer_height(value_at(pixel, height), contrast);
    if (output_shown == 12) { // from the slopes or, on a body, from the heights
        vec2 slope = companion > 0 ? vec2(value_at(pixel, companion), value_at(pixel, companion + 1))
                                   : (value_at(pixel, height) - vec2(value_at(pixel - vec2(stride, 0.0), height),
                                                                     value_at(pixel - vec2(0.0, stride), height))) / spacing;
        return viewer_normal(normalize(vec3(-slope, 1.0)), green);
    }
    return vec3(value_at(pixel, output_shown == 13 ? material_roughness : material_metalness));
}

vec3 shown(vec2 pixel) {
    float noise = value_at(pixel, 0);
    vec3 seen;
    if (output_shown >= 9)
        seen = material(pixel);
    else if (output_shown == 8)
        seen = three_at(pixel, 0);
    else if (output_shown == 1)
        seen = viewer_gradient(vec2(value_at(pixel, companion), value_at(pixel, companion + 1)), deviation, contrast, green);
    else if (output_shown == 2)
        seen = viewer_phase(vec2(value_at(pixel, companion), noise), colours);
    else if (output_shown == 3)
        seen = mapped(viewer_intensity(vec2(value_at(pixel, companion), noise), contrast));
    else if (output_shown == 4)
        seen = mapped(viewer_variance(companion > 0 ? value_at(pixel, companion) : 0.0));
    else if (output_shown == 5)
        seen = mapped(stripes(pixel));
    else if (output_shown == 6)
        seen = lit_surface(pixel, mapped(viewer_value(noise, contrast)),
                           vec3(value_at(pixel, companion), value_at(pixel, companion + 1),
                                normal_at >= 0 ? value_at(pixel, normal_at + 3) : 0.0));
    else if (output_shown == 7)
        seen = lit_stripes(pixel);
    else
        seen = mapped(viewer_value(noise, contrast));
    // The background shows around a body.
    float coverage = coverage_at >= 0 && output_shown != 9 ? value_at(pixel, coverage_at) : 1.0;
    return mix(vec3(0.05, 0.05, 0.055), clamp(seen, 0.0, 1.0), coverage);
}
