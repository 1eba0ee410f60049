// Channels of a picture as colours: what the window and files share.

#include "viewer/show_interface.h"
#include "viewer/colours.glsl"

// Constants, because a CPU would go through every branch.
layout(constant_id = 0) const int output_shown = 0;  // 0 value, 1 gradient, 2 phase, 3 intensity, 4 variance
layout(constant_id = 1) const int colours = 0;       // the colour map
layout(constant_id = 2) const int channels = 1;
layout(constant_id = 3) const int companion = 0;     // the first channel that the output needs beside the noise
layout(constant_id = 4) const int coverage_at = -1;  // the channel of the coverage, -1 for none
layout(constant_id = 5) const bool coarse = false;   // whether the grid is coarser than the pixels

// A channel at a pixel.
float value_at(vec2 pixel, int channel);

vec3 shown(vec2 pixel)
{
    float noise = value_at(pixel, 0);
    vec3 seen;
    if (output_shown == 1)
        seen = viewer_gradient(vec2(value_at(pixel, companion), value_at(pixel, companion + 1)), deviation, contrast);
    else if (output_shown == 2)
        seen = viewer_phase(vec2(value_at(pixel, companion), noise), colours);
    else if (output_shown == 3)
        seen = viewer_intensity(vec2(value_at(pixel, companion), noise), contrast, colours);
    else if (output_shown == 4)
        seen = viewer_variance(companion > 0 ? value_at(pixel, companion) : 0.0, colours);
    else
        seen = viewer_value(noise, contrast, colours);
    float coverage = coverage_at >= 0 ? value_at(pixel, coverage_at) : 1.0;
    return mix(vec3(0.05, 0.05, 0.055), clamp(seen, 0.0, 1.0), coverage);
}
