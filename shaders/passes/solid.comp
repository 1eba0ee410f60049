#version 450
#extension GL_GOOGLE_include_directive : require

// Draws solid noise: a flat slice, or a sphere or torus in perspective. With GABOR_OF_surface, waves are tangent to the body.
// Solid and surface noise are two modules, because drivers take seconds to compile both in one.

#include "passes/solid_interface.h"

layout(constant_id = view_id) const uint view = view_slice;
layout(constant_id = isotropic_id) const bool some_isotropic = false; // whether any noise is isotropic
layout(constant_id = directed_id) const bool some_directed = false;
layout(constant_id = filter_id) const bool filtered = true;     // whether to filter for the pixel's footprint
layout(constant_id = quadrature_id) const bool with_quadrature = false;
layout(constant_id = gradient_id) const bool with_gradient = false; // whether to write the derivatives (right, down)
layout(constant_id = phasor_id) const bool with_phasor = false;
const int rays = 4; // rays along each axis of a pixel, to measure coverage
layout(constant_id = animated_id) const bool animated = false; // whether time is not 0
layout(constant_id = coloured_id) const bool coloured = false; // whether to write red, green and blue instead of the noise
// Whether to write the normal (right, down, towards the eye) and the derivative towards the eye.
layout(constant_id = normals_id) const bool with_normal = false;
const int channels = (coloured ? 3 : 1) + 1 + (with_quadrature ? 1 : 0) + (with_gradient ? 2 : 0) + (with_phasor ? 2 : 0)
                   + (with_normal ? 4 : 0);

#include "gabor_noise.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_noise_3d.glsl"

layout(local_size_x = solid_group, local_size_y = solid_group) in;

layout(std430, set = 0, binding = 1) readonly buffer Waves { SolidWave wave_table[]; };
layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };

#include "body.glsl"
const int colour_binding = 2;
#include "colour.glsl"

GaborField3d wave_at(SolidWave wave, GaborPlace3d place, vec3 normal) {
    bool isotropic = some_isotropic && (!some_directed || wave.isotropic == 1u);
    vec3 along = vec3(wave.direction, 0.0);
#ifdef GABOR_OF_surface
    if (isotropic)
        return gabor_field_surface_isotropic(place, normal, wave.frequency, wave.seed);
    return gabor_field_surface(place, normal, wave.frequency, along, wave.seed);
#else
    if (isotropic)
        return gabor_field_3d_isotropic(place, wave.frequency, wave.seed);
    return gabor_field_3d(place, wave.frequency, along, wave.seed);
#endif
}

struct Values {
    float noise;  // apart from complex.y, so that its last bit is the same whatever else is drawn
    vec2 complex; // quadrature and noise
    vec3 slope;
    Components components;
};

Values values_at(vec3 p, vec3 normal, vec3 dx, vec3 dy) {
    Values sum = Values(0.0, vec2(0.0), vec3(0.0), Components(vec3(0.0), vec3(0.0)));
    for (int i = 0; i < waves; ++i) {
        SolidWave wave = wave_table[i];
        GaborPlace3d place = gabor_place_3d(ivec3(0), p * (GABOR_RADIUS / wave.radius));
        place.animated = animated;
        place.time = time;
        place.filtered = filtered;
        place.dx = dx / wave.radius;
        place.dy = dy / wave.radius;
        GaborField3d field = wave_at(wave, place, normal);
        sum.noise += wave.amplitude * field.noise;
        sum.complex += wave.amplitude * vec2(field.quadrature, field.noise);
        sum.slope += wave.amplitude / wave.radius * field.gradient;
        if (coloured)
            add_to(sum.components, wave.weights, vec2(field.quadrature, field.noise), field.removed);
    }
    return sum;
}

void write_pixel(int at, Values here, vec3 normal, float coverage, Axes axes) {
    if (coloured) {
        vec3 shown = colour_of(here.components.value, here.components.removed);
        for (int i = 0; i < 3; ++i)
            picture[at++] = shown[i];
    } else {
        picture[at++] = here.noise;
    }
    if (with_quadrature)
        picture[at++] = here.complex.x;
    if (with_gradient) {
        picture[at++] = dot(here.slope, axes.right);
        picture[at++] = dot(here.slope, -axes.up);
    }
    if (with_phasor) {
        vec2 phasor = gabor_phasor(here.complex);
        picture[at++] = phasor.x;
        picture[at++] = phasor.y;
    }
    if (with_normal) {
        vec3 seen = in_picture(normal, axes);
        for (int i = 0; i < 3; ++i)
            picture[at++] = seen[i];
        picture[at++] = dot(here.slope, axes.toward_eye);
    }
    picture[at] = coverage;
}

void main() {
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 corner = vec2(here + ivec2(first_column, first_row));
    if (view == view_slice) { // a slice has the plane's axes, with y pointing down
        Axes flat_axes = Axes(vec3(1.0, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, 1.0));
        vec3 p = vec3(pixel * (corner + 0.5), depth);
        Values here_values = values_at(p, flat_axes.toward_eye, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0));
        write_pixel(at, here_values, flat_axes.toward_eye, 1.0, flat_axes);
        return;
    }
    Axes axes = camera_axes();
    Seen seen = seen_at(corner, axes);
    if (!seen.found) {
        for (int i = 0; i < channels; ++i)
            picture[at + i] = 0.0;
        return;
    }
    write_pixel(at, values_at(unit * seen.p, seen.normal, share * unit * seen.dx, share * unit * seen.dy), seen.normal, seen.coverage, axes);
}
