#version 450
#extension GL_GOOGLE_include_directive : require

// Pictures of noise in space: a flat slice, or a sphere or a torus that carries it, seen in perspective.
//
// Bodies are in a unit of their own, in which the sphere has radius 1. The camera looks at their centre from a distance
// of 4. The torus lies within the sphere.

#include "passes/solid_interface.h"

layout(constant_id = 0) const int view = 0;             // 0 slice, 1 sphere, 2 torus
layout(constant_id = 1) const bool some_isotropic = false; // of the noises
layout(constant_id = 2) const bool some_directed = false;
layout(constant_id = 3) const bool on_surface = false;  // waves are tangent to the surface
layout(constant_id = 4) const bool filtered = true;     // by the pixel's footprint
layout(constant_id = 5) const int values = 1; // independent ones
layout(constant_id = 6) const bool with_quadrature = false;
layout(constant_id = 7) const bool with_gradient = false; // along the picture's right and down
layout(constant_id = 8) const bool with_phasor = false;
layout(constant_id = 9) const int rays = 4; // through a pixel for its coverage, along each axis; 0: that of its centre
layout(constant_id = 10) const bool animated = false; // whether time is not 0
const int channels = values + 1 + (with_quadrature ? 1 : 0) + (with_gradient ? 2 : 0) + (with_phasor ? 2 : 0);

#include "gabor_lattice.glsl"
#include "gabor_lattice_3d.glsl"

layout(local_size_x = solid_group, local_size_y = solid_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Waves { SolidWave wave_table[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Picture { float picture[]; };

const float eye_distance = 4.0;
const float torus_large = 0.68; // radius of the circle around the axis z, and of the tube
const float torus_small = 0.3;

// Of the camera, of length 1.
struct Axes {
    vec3 right;
    vec3 up;
    vec3 toward_eye;
};

Axes camera_axes()
{
    vec3 right = vec3(yaw.x, yaw.y, 0.0);
    vec3 toward_eye = vec3(yaw.y * pitch.x, -yaw.x * pitch.x, pitch.y);
    return Axes(right, vec3(-yaw.y * pitch.y, yaw.x * pitch.y, pitch.x), toward_eye);
}

struct Hit {
    bool found;
    float distance; // along the ray, in its direction's length
    vec3 p;         // in the body's unit
    vec3 normal;
};

float distance_to_torus(vec3 p)
{
    return length(vec2(length(p.xy) - torus_large, p.z)) - torus_small;
}

vec3 torus_normal(vec3 p)
{
    return normalize(p - vec3(torus_large * normalize(p.xy), 0.0));
}

// A ray from the eye; its direction has length 1 along the axis of the camera.
vec3 ray_of(vec2 at, Axes axes)
{
    vec2 plane = pixel * (at - center);
    return plane.x * axes.right - plane.y * axes.up - axes.toward_eye;
}

// From the ray's foot, where it is nearest to the centre: the quadratic equation without its cancellation.
Hit sphere_hit(vec3 eye, vec3 ray)
{
    float foot = -dot(eye, ray) / dot(ray, ray);
    vec3 nearest = eye + foot * ray;
    float square = 1.0 - dot(nearest, nearest);
    float t = foot - sqrt(max(square, 0.0) / dot(ray, ray));
    vec3 p = normalize(eye + t * ray);
    return Hit(square > 0.0, t, p, p);
}

// By sphere tracing with a shortest step: what it steps over is a chord of 0.001, 10^-6 below the surface. A step that
// ends inside the body is halved until the surface is found.
Hit torus_hit(vec3 eye, vec3 ray)
{
    float side = length(ray);
    float t = (eye_distance - torus_large - torus_small) / side;
    float gap = distance_to_torus(eye + t * ray);
    for (int i = 0; i < 160 && gap > 0.0 && t * side < eye_distance + 1.0; ++i) {
        t += max(gap, 0.001) / side;
        gap = distance_to_torus(eye + t * ray);
    }
    bool found = gap <= 0.0;
    float step_side = 0.001 / side;
    t -= step_side;
    for (int i = 0; i < 12; ++i) {
        step_side *= 0.5;
        t += distance_to_torus(eye + (t + step_side) * ray) > 0.0 ? step_side : 0.0;
    }
    vec3 p = eye + t * ray;
    vec3 normal = torus_normal(p);
    return Hit(found, t, p - distance_to_torus(p) * normal, normal);
}

Hit hit_of(vec2 at, Axes axes)
{
    vec3 eye = eye_distance * axes.toward_eye;
    if (view == 1)
        return sphere_hit(eye, ray_of(at, axes));
    return torus_hit(eye, ray_of(at, axes));
}

GaborField3d wave_at(SolidWave wave, GaborPlace3d place, vec3 normal)
{
    if (some_isotropic && (!some_directed || wave.isotropic == 1u)) {
        if (on_surface)
            return gabor_surface_isotropic_3d(place, normal, wave.frequency, wave.seed);
        return gabor_isotropic_3d(place, wave.frequency, wave.seed);
    }
    vec3 along = vec3(wave.direction, 0.0);
    if (on_surface)
        return gabor_surface_3d(place, normal, wave.frequency, along, wave.seed);
    return gabor_field_3d(place, gabor_wave_3d(wave.frequency, along), wave.seed);
}

struct Values {
    vec4 values;
    vec2 complex;
    vec3 slope;
};

Values values_at(vec3 p, vec3 normal, vec3 dx, vec3 dy)
{
    Values sum = Values(vec4(0.0), vec2(0.0), vec3(0.0));
    for (int i = 0; i < waves; ++i) {
        SolidWave wave = wave_table[i];
        GaborPlace3d place = gabor_place_3d(ivec3(0), p * (GABOR_RADIUS / wave.radius));
        place.animated = animated;
        place.time = time;
        place.filtered = filtered;
        place.dx = dx / wave.radius;
        place.dy = dy / wave.radius;
        uint seed = wave.seed;
        for (int channel = 0; channel < values; ++channel) {
            wave.seed = channel == 0 ? seed : gabor_lobe_seed(seed, -channel);
            GaborField3d field = wave_at(wave, place, normal);
            sum.values[channel] += wave.amplitude * field.value.y;
            if (channel == 0) {
                sum.complex += wave.amplitude * field.value;
                sum.slope += wave.amplitude / wave.radius * vec3(field.slope_x.y, field.slope_y.y, field.slope_z.y);
            }
        }
    }
    return sum;
}

void write_pixel(int at, Values here, float coverage, Axes axes)
{
    for (int i = 0; i < values; ++i)
        picture[at++] = here.values[i];
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
    picture[at] = coverage;
}

void main()
{
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 corner = vec2(here + ivec2(first_column, first_row));
    if (view == 0) { // its axes are those of the plane, y growing downwards
        Axes flat_axes = Axes(vec3(1.0, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, 1.0));
        vec3 p = vec3(pixel * (corner + 0.5), depth);
        Values here_values = values_at(p, flat_axes.toward_eye, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0));
        write_pixel(at, here_values, 1.0, flat_axes);
        return;
    }
    // Where the central ray misses, the noise is that of the first that hits.
    Axes axes = camera_axes();
    Hit hit = hit_of(corner + 0.5, axes);
    float coverage = hit.found && rays == 0 ? 1.0 : 0.0;
    for (int i = 0; i < rays * rays; ++i) {
        vec2 within = (vec2(float(i % rays), float(i / rays)) + 0.5) / float(rays);
        Hit other = hit_of(corner + within, axes);
        if (other.found) {
            coverage += 1.0 / float(rays * rays);
            if (!hit.found)
                hit = other;
        }
    }
    if (!hit.found) {
        for (int i = 0; i < channels; ++i)
            picture[at + i] = 0.0;
        return;
    }
    // How far the ray's end moves in the tangent plane (Igehy, "Tracing ray differentials", 1999).
    vec3 ray = hit.p - eye_distance * axes.toward_eye;
    float facing = min(dot(ray, hit.normal), -1.0e-4);
    vec3 dx = hit.distance * pixel * axes.right;
    vec3 dy = -hit.distance * pixel * axes.up;
    dx -= dot(dx, hit.normal) / facing * ray;
    dy -= dot(dy, hit.normal) / facing * ray;
    write_pixel(at, values_at(unit * hit.p, hit.normal, unit * dx, unit * dy), coverage, axes);
}
