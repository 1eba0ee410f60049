#version 450
#extension GL_GOOGLE_include_directive : require

// Draws solid noise: a flat slice, or a sphere or torus in perspective. With GABOR_OF_surface, waves are tangent to the body.
// Solid and surface noise are two modules, because drivers take seconds to compile both in one.

#include "passes/solid_interface.h"

layout(constant_id = view_id) const uint view = view_slice;
layout(constant_id = isotropic_id) const bool some_isotropic = false; // whether any noise is isotropic
layout(constant_id = directed_id) const bool some_directed = false;
layout(constant_id = filter_id) const bool filtered = true;     // whether to filter for the pixel's footprint
const int rays = 4; // rays along each axis of a pixel, to measure coverage
layout(constant_id = animated_id) const bool animated = false; // whether time is not 0

#include "gabor_noise.glsl"
#include "gabor_filter.glsl"
#include "gabor_noise_3d.glsl"
#include "gabor_filter_3d.glsl"

layout(local_size_x = solid_group, local_size_y = solid_group) in;

layout(std430, set = 0, binding = 1) readonly buffer Waves { SolidWave wave_table[]; };

#include "body.glsl"
const int colour_binding = 2;
#include "values.glsl"

GaborField3d plain_wave(SolidWave wave, bool isotropic, GaborPlace3d place, vec3 normal) {
    vec3 along = vec3(wave.direction, 0.0);
#ifdef GABOR_OF_surface
    if (isotropic)
        return gabor_field_surface_isotropic(place, normal, wave.frequency, wave.seed);
    return gabor_field_surface(place, normal, wave.frequency, along, wave.seed);
#else
    if (isotropic)
        return gabor_field_3d_isotropic(place, wave.frequency, wave.seed);
    return gabor_field_3d(place, wave.frequency * along, wave.seed);
#endif
}

GaborField3d filtered_wave(SolidWave wave, bool isotropic, GaborPlace3d place, vec3 dx, vec3 dy, vec3 normal) {
    vec3 along = vec3(wave.direction, 0.0);
#ifdef GABOR_OF_surface
    if (isotropic)
        return gabor_field_surface_isotropic_filtered(place, dx, dy, normal, wave.frequency, wave.seed);
    return gabor_field_surface_filtered(place, dx, dy, normal, wave.frequency, along, wave.seed);
#else
    if (isotropic)
        return gabor_field_3d_isotropic_filtered(place, dx, dy, wave.frequency, wave.seed);
    return gabor_field_3d_filtered(place, dx, dy, wave.frequency * along, wave.seed);
#endif
}

Values values_at(vec3 p, vec3 normal, vec3 dx, vec3 dy) {
    Values sum = no_values;
    for (int i = 0; i < waves; ++i) {
        SolidWave wave = wave_table[i];
        bool isotropic = some_isotropic && (!some_directed || wave.isotropic == 1u);
        GaborPlace3d place = gabor_place_3d_at(p / wave.radius);
        place.evolution = animated ? time : 0.0;
        GaborField3d field;
        if (filtered)
            field = filtered_wave(wave, isotropic, place, dx / wave.radius, dy / wave.radius, normal);
        else
            field = plain_wave(wave, isotropic, place, normal);
        add_wave(sum, noise_of(field, wave.radius), wave.amplitude, wave.weights);
    }
    return sum;
}

void write_pixel(int at, Values here, vec3 normal, float coverage, Axes axes) {
    vec3 slope = in_picture(here.noise.slope, axes);
    vec3 colour = coloured ? colour_of(here.components.value, here.components.removed) : vec3(0.0);
    write_values(at, here, slope.xy, colour);
    if (normal_at >= 0) {
        vec3 seen = in_picture(normal, axes);
        for (int i = 0; i < 3; ++i)
            picture[at + normal_at + i] = seen[i];
        picture[at + normal_at + 3] = slope.z;
    }
    picture[at + coverage_at] = coverage;
}

void main() {
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 corner = vec2(here + ivec2(first_column, first_row));
    if (view == view_slice) {
        Axes axes = flat_axes();
        vec3 p = vec3(pixel * (corner + 0.5), depth);
        Values seen = values_at(p, axes.toward_eye, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0));
        write_pixel(at, seen, axes.toward_eye, 1.0, axes);
        return;
    }
    Axes axes = camera_axes(yaw, pitch);
    Seen seen = seen_at(corner, axes);
    if (!seen.found) {
        for (int i = 0; i < channels; ++i)
            picture[at + i] = 0.0;
        return;
    }
    Values sum = values_at(unit * seen.p, seen.normal, share * unit * seen.dx, share * unit * seen.dy);
    write_pixel(at, sum, seen.normal, seen.coverage, axes);
}
