#version 450
#extension GL_GOOGLE_include_directive : require

// Draws a picture pixel by pixel: any sum of noises, in any view of the plane, optionally painted, filtered or in colour.

#include "passes/pixels_interface.h"
#include "recipe.glsl"
#if GABOR_TAPS == 3
#include "gabor_filter.glsl"
#endif
const int colour_binding = 5;
#include "values.glsl"
#include "plane.glsl"

layout(constant_id = filter_id) const bool filtered = false; // whether to filter, with GABOR_TAPS 3
layout(constant_id = view_id) const uint view = view_flat;
const bool horizon = view == view_horizon; // a plane in perspective
layout(constant_id = painted_id) const bool painted = false;
layout(constant_id = tiled_id) const bool tiled = false; // whether opposite edges match; divisions make this slow on CPUs
layout(constant_id = animated_id) const bool animated = false; // whether time is not 0
layout(constant_id = few_waves_id) const int few_waves = 0; // the number of waves if their loop is unrolled, else 0
// If the loop is unrolled, narrow_waves has a bit for each wave whose filter needs only its narrow form, and wide_waves for each
// wave whose filter needs only its wide form.
layout(constant_id = narrow_waves_id) const uint narrow_waves = 0u;
layout(constant_id = wide_waves_id) const uint wide_waves = 0u;

layout(local_size_x = pixels_group, local_size_y = pixels_group) in;

layout(std430, set = 0, binding = 1) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 2) readonly buffer Rows { Line rows[]; };
layout(std430, set = 0, binding = 3) readonly buffer Waves { PixelsWave wave_table[]; };
layout(std430, set = 0, binding = 4) readonly buffer Paint { vec2 paint[]; }; // frequency and orientation

// Changes a sample's orientation by whole turns, so that it is within half a turn of another's.
vec2 nearest_turn(vec2 sampled, vec2 other) {
    return vec2(sampled.x, sampled.y - 6.2831853 * floor((sampled.y - other.y) * 0.15915494 + 0.5));
}

// Frequency and orientation at a pixel, interpolated between the samples of the paint.
vec2 painted_at(vec2 pixel) {
    vec2 at = clamp(paint_corner + (pixel + 0.5) * paint_scale - 0.5, vec2(0.0), vec2(paint_size - 1));
    ivec2 low = ivec2(at);
    ivec2 high = min(low + 1, paint_size - 1);
    vec2 between = at - vec2(low);
    vec2 corner = paint[low.y * paint_size.x + low.x];
    vec2 right = nearest_turn(paint[low.y * paint_size.x + high.x], corner);
    vec2 below = nearest_turn(paint[high.y * paint_size.x + low.x], corner);
    vec2 opposite = nearest_turn(paint[high.y * paint_size.x + high.x], corner);
    return mix(mix(corner, right, between.x), mix(below, opposite, between.x), between.y);
}

// Adds a wave at a pixel that shows `here`; in perspective, relative to the camera.
void add_wave_at(inout Values sum, int index, ivec2 pixel_at, Footprint here) {
    PixelsWave wave = wave_table[index];
    Line column = columns[pixel_at.x * tables + wave.table];
    Line row = rows[pixel_at.y * tables + wave.table];
    vec2 local = horizon ? here.position * (wave.nodes / wave.radius) + wave.camera : vec2(column.local, row.local);
    ivec2 cell = ivec2(column.cell, row.cell);
    vec2 paint_here = painted ? painted_at(vec2(pixel_at)) : vec2(1.0, 0.0);
    float frequency = paint_here.x * wave.frequency;
    float orientation = paint_here.y + wave.orientation;
    GaborPlace place = GaborPlace(cell, local, wave.nodes, tiled ? wave.period : ivec2(0), animated ? time : 0.0);
#ifdef GABOR_TAPS
    vec2 along = gabor_wave_vector(frequency, orientation);
    along.y *= wave.radius.y / wave.radius.x;
#else
    GaborKernel along = gabor_kernel(frequency, orientation);
#endif
    GaborField field;
#if GABOR_TAPS == 3
    vec2 nodes = wave.nodes / (GABOR_CELLS_PER_RADIUS * wave.radius);
    GaborImplFootprint footprint = gabor_impl_footprint(nodes * here.dx, nodes * here.dy);
    bool narrow = few_waves > 0 && (narrow_waves >> index & 1u) == 1u;
    bool wide = few_waves > 0 && (wide_waves >> index & 1u) == 1u;
    float wide_share = narrow ? 0.0 : wide ? 1.0 : gabor_impl_wide_share(footprint);
    if (filtered)
        field = gabor_impl_filtered(place, footprint, wide_share, along, wave.seed);
    else
#endif
        field = gabor_field(place, along, wave.seed);
    add_wave(sum, noise_of(field, wave.radius), wave.amplitude, wave.weights);
}

Values values_at(ivec2 pixel_at, Footprint here) {
    Values sum = no_values;
    if (few_waves == 0) {
        for (int i = 0; i < waves; ++i)
            add_wave_at(sum, i, pixel_at, here);
    }
    // No loop: drivers do not unroll loops that contain loops.
#define ADD(i) if (few_waves > i) add_wave_at(sum, i, pixel_at, here);
    ADD(0) ADD(1) ADD(2) ADD(3) ADD(4) ADD(5) ADD(6) ADD(7) ADD(8) ADD(9) ADD(10) ADD(11) ADD(12) ADD(13) ADD(14) ADD(15)
    return sum;
}

// Without an early return, lavapipe loads shared values once instead of once per invocation.
void main() {
    ivec2 pixel_at = ivec2(gl_GlobalInvocationID.xy);
    bool inside = pixel_at.x < width && pixel_at.y < height;
    pixel_at = min(pixel_at, ivec2(width, height) - 1);
    int at = (before + pixel_at.y * width + pixel_at.x) * channels;
    pixel_at.y += first_row;
    Footprint here = footprint_from_above(vec2(0.0), pixel);
    bool in_sky = false;
    if (horizon) {
        vec2 seen = vec2(columns[pixel_at.x * tables].local, rows[pixel_at.y * tables].local);
        in_sky = seen.y <= 0.0;
        here = footprint_below_horizon(in_sky ? vec2(seen.x, 1.0) : seen, pixel, focal_length);
    }
    Values sum = values_at(pixel_at, here);
    if (in_sky) {
        sum = no_values;
        sum.noise.removed = 1.0;
        sum.components.removed = vec3(1.0);
    }
    vec3 colour = coloured ? colour_of(sum.components.value, sum.components.removed) : vec3(0.0);
    if (!inside)
        return;
    write_values(at, sum, sum.noise.slope.xy, colour);
    if (removed_at >= 0)
        picture[at + removed_at] = sum.noise.removed;
}
