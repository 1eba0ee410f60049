#version 450
#extension GL_GOOGLE_include_directive : require

// A picture pixel by pixel, with all that the drop-ins can do: views, painted parameters, and with the sparse one spectra
// and the filter.

#ifndef GABOR_LOBES
#define GABOR_LOBES 16
#endif

#include "passes/pixels_interface.h"
#include "recipe.glsl"

layout(constant_id = 7) const int lobe_count = 0; // 0: one frequency and orientation
layout(constant_id = 8) const bool summed = false; // independent noises, one for each lobe
layout(constant_id = 9) const bool filtered = false;
layout(constant_id = 10) const bool horizon = false; // a plane in perspective
layout(constant_id = 11) const bool painted = false;
layout(constant_id = 12) const bool with_quadrature = false;
layout(constant_id = 13) const bool with_gradient = false;
layout(constant_id = 14) const bool with_phasor = false;
layout(constant_id = 15) const int values = 1; // uncorrelated ones
layout(constant_id = 16) const bool animated = false; // for the lattice: whether time is not 0
const int channels = values + (with_quadrature ? 1 : 0) + (with_gradient ? 2 : 0) + (with_phasor ? 2 : 0)
                   + (filtered ? 1 : 0);

layout(local_size_x = pixels_group, local_size_y = pixels_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 1) readonly buffer Rows { Line rows[]; };
layout(std430, set = 0, binding = 2) readonly buffer Lobes { Lobe lobes[]; };
layout(std430, set = 0, binding = 3) readonly buffer Paint { vec2 paint[]; }; // frequency and orientation
layout(std430, set = 0, binding = 4) writeonly buffer Picture { float picture[]; };

// Frequency and orientation at a pixel, between the samples of the paint around it.
vec2 painted_at(vec2 pixel)
{
    vec2 at = clamp(paint_corner + (pixel + 0.5) * paint_scale - 0.5, vec2(0.0), vec2(paint_size - 1));
    ivec2 low = ivec2(at);
    ivec2 high = min(low + 1, paint_size - 1);
    vec2 between = at - vec2(low);
    return mix(mix(paint[low.y * paint_size.x + low.x], paint[low.y * paint_size.x + high.x], between.x),
               mix(paint[high.y * paint_size.x + low.x], paint[high.y * paint_size.x + high.x], between.x), between.y);
}

struct Values {
    GaborField field;
    float removed;
};

#ifdef GABOR_TAPS

Values values_at(ivec2 pixel, ivec2 cell, vec2 local, vec2 dx, vec2 dy)
{
    vec2 here = painted ? painted_at(vec2(pixel)) : vec2(frequency, orientation);
    GaborKernel kernel = gabor_kernel_stretched(gabor_kernel(here.x, here.y), radius);
    GaborPlace place = GaborPlace(cell, local, radius, period, animated, time);
    return Values(gabor_field(place, kernel, seed), 0.0);
}

#else

GaborLobe lobe_at(int i)
{
    Lobe lobe = lobes[i];
    return gabor_lobe(lobe.frequency, lobe.orientation, lobe.frequency_spread, lobe.orientation_spread, lobe.power);
}

Values evaluate(GaborPlace place, GaborKernel kernel, GaborFootprint footprint, uint instance)
{
    Values result;
    result.removed = 0.0;
    if (filtered) {
        vec2 value = gabor_field_filtered(place, kernel, footprint, instance);
        result.field = GaborField(value, vec2(0.0), vec2(0.0), vec4(value.y));
        result.removed = gabor_removed(kernel, footprint);
    } else {
        result.field = gabor_field(place, kernel, instance);
    }
    return result;
}

// The sum of independent noises in proportion to the roots of their powers.
Values evaluate_sum(GaborPlace place, GaborFootprint footprint)
{
    Values sum = Values(GaborField(vec2(0.0), vec2(0.0), vec2(0.0), vec4(0.0)), 0.0);
    float total_power = 0.0;
    for (int i = 0; i < lobe_count; ++i)
        total_power += lobes[i].power;
    for (int i = 0; i < lobe_count; ++i) {
        uint instance = gabor_lobe_seed(seed, i);
        Values one = evaluate(place, gabor_kernel_lobe(lobe_at(i)), footprint, instance);
        float share = lobes[i].power / total_power;
        sum.field.value += sqrt(share) * one.field.value;
        sum.field.slope_x += sqrt(share) * one.field.slope_x;
        sum.field.slope_y += sqrt(share) * one.field.slope_y;
        sum.field.four += sqrt(share) * one.field.four;
        sum.removed += share * one.removed;
    }
    return sum;
}

GaborKernel kernel_at(vec2 pixel)
{
    vec2 wave = painted ? painted_at(pixel) : vec2(frequency, orientation);
    if (lobe_count == 0)
        return gabor_kernel(wave.x, wave.y);
    GaborLobes all;
    all.count = lobe_count;
    for (int i = 0; i < GABOR_LOBES; ++i) {
        if (i < lobe_count)
            all.lobe[i] = lobe_at(i);
    }
    if (painted)
        all.lobe[0] = gabor_lobe(wave.x, wave.y, lobes[0].frequency_spread, lobes[0].orientation_spread, 1.0);
    return gabor_kernel_lobes(all);
}

//   dx, dy  how far apart neighbouring pixels are along the picture's axes, in kernel radii
Values values_at(ivec2 pixel, ivec2 cell, vec2 local, vec2 dx, vec2 dy)
{
    GaborPlace place = GaborPlace(cell, local, radius, period, time);
    GaborFootprint footprint = gabor_footprint(dx, dy);
    return summed ? evaluate_sum(place, footprint) : evaluate(place, kernel_at(vec2(pixel)), footprint, seed);
}

#endif

void write_pixel(int at, Values values_here)
{
    GaborField field = values_here.field;
    picture[at++] = values > 1 ? field.four.x : field.value.y;
    for (int i = 1; i < values; ++i)
        picture[at++] = field.four[i];
    if (with_quadrature)
        picture[at++] = field.value.x;
    if (with_gradient) {
        picture[at++] = field.slope_x.y;
        picture[at++] = field.slope_y.y;
    }
    if (with_phasor) {
        vec2 phasor = gabor_phasor(field.value);
        picture[at++] = phasor.x;
        picture[at++] = phasor.y;
    }
    if (filtered)
        picture[at++] = values_here.removed;
}

void main()
{
    ivec2 pixel_at = ivec2(gl_GlobalInvocationID.xy);
    if (pixel_at.x >= width || pixel_at.y >= height)
        return;
    int at = (before + pixel_at.y * width + pixel_at.x) * channels;
    pixel_at.y += first_row;
    Line column = columns[pixel_at.x];
    Line row = rows[pixel_at.y];

    vec2 local = vec2(column.local, row.local);
    vec2 dx = vec2(pixel, 0.0);
    vec2 dy = vec2(0.0, pixel);
    if (horizon) {
        if (row.local <= 0.0) { // the sky
            write_pixel(at, Values(GaborField(vec2(0.0), vec2(0.0), vec2(0.0), vec4(0.0)), 1.0));
            return;
        }
        // The camera looks along the plane from its height: depth = height * focal length / rows below the horizon.
        float near = pixel / row.local;
        local = near * vec2(column.local, -focal_length) * radius + camera;
        dx = vec2(near, 0.0);
        dy = near / row.local * vec2(-column.local, focal_length);
    }
    write_pixel(at, values_at(pixel_at, ivec2(column.cell, row.cell), local, dx, dy));
}
