#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// Pictures of noise in space: a flat slice, or a sphere or a torus that carries it, seen in perspective.
//
// Bodies are in a unit of their own, in which the sphere has radius 1. The camera looks at their centre from a distance
// of 4, from 30 degrees above the plane z = 0.

layout(constant_id = 0) const int view = 0;     // 0 slice, 1 sphere, 2 torus
layout(constant_id = 1) const int waves = 0;    // 0 oriented, 1 isotropic, 2 and 3 the same tangent to the surface
layout(constant_id = 2) const int filtered = 1; // by the pixel's footprint

#define GABOR_UNROLL [[unroll]]
#include "gabor_noise.glsl"
#include "gabor_noise_3d.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) writeonly buffer Pixels { vec2 pixels[]; }; // noise, coverage

layout(push_constant) uniform Push {
    float center_x; // of the picture, in pixels from the corner
    float center_y;
    float pixel;    // side of a pixel: of the slice in kernel radii, else in the plane at distance 1
    float unit;     // kernel radii in a body's unit
    float depth;    // z of the slice, kernel radii
    float frequency;
    float direction_x;
    float direction_y;
    float direction_z;
    uint seed;
    int first_column; // of these pixels in the picture
    int first_row;
    int columns;
    int rows;
};

const vec3 toward_eye = vec3(0.0, -0.8660254, 0.5);
const vec3 right = vec3(1.0, 0.0, 0.0);
const vec3 up = vec3(0.0, 0.5, 0.8660254);
const float eye_distance = 4.0;
const float torus_large = 0.68; // radius of the circle around the axis z, and of the tube
const float torus_small = 0.3;

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
vec3 ray_of(vec2 at)
{
    vec2 plane = pixel * (at - vec2(center_x, center_y));
    return plane.x * right - plane.y * up - toward_eye;
}

Hit sphere_hit(vec3 ray)
{
    vec3 eye = eye_distance * toward_eye;
    // From the ray's foot, where it is nearest to the centre: the quadratic equation without its cancellation.
    float foot = -dot(eye, ray) / dot(ray, ray);
    vec3 nearest = eye + foot * ray;
    float square = 1.0 - dot(nearest, nearest);
    float t = foot - sqrt(max(square, 0.0) / dot(ray, ray));
    vec3 p = normalize(eye + t * ray);
    return Hit(square > 0.0, t, p, p);
}

// By sphere tracing with a shortest step: what it steps over is a chord of 0.001, 10^-6 below the surface. A step that
// ends inside the body is halved until the surface is found.
Hit torus_hit(vec3 ray)
{
    vec3 eye = eye_distance * toward_eye;
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

Hit hit_of(vec2 at)
{
    if (view == 1)
        return sphere_hit(ray_of(at));
    return torus_hit(ray_of(at));
}

float noise_at(vec3 p, vec3 normal, vec3 dx, vec3 dy)
{
    vec3 direction = vec3(direction_x, direction_y, direction_z);
    GaborKernel3d kernel = gabor_kernel_3d(frequency, direction);
    if (waves == 1)
        kernel = gabor_kernel_isotropic_3d(frequency);
    if (waves == 2)
        kernel = gabor_kernel_surface(frequency, direction, normal);
    if (waves == 3)
        kernel = gabor_kernel_surface_isotropic(frequency, normal);
    if (filtered == 1)
        kernel = gabor_filtered_3d(kernel, dx, dy);
    return gabor_noise_3d_at(ivec3(0), p * GABOR_3D_RADIUS, kernel, seed);
}

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= columns || at.y >= rows)
        return;
    int index = at.y * columns + at.x;
    vec2 corner = vec2(at + ivec2(first_column, first_row));
    if (view == 0) {
        vec3 p = vec3(pixel * (corner + 0.5), depth);
        vec3 normal = vec3(0.0, 0.0, 1.0);
        pixels[index] = vec2(noise_at(p, normal, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0)), 1.0);
        return;
    }
    // Coverage by 16 rays; where the central one misses, the noise is that of the first that hit.
    Hit hit = hit_of(corner + 0.5);
    float coverage = 0.0;
    for (int i = 0; i < 16; ++i) {
        Hit other = hit_of(corner + (vec2(float(i & 3), float(i >> 2)) + 0.5) * 0.25);
        if (other.found) {
            coverage += 0.0625;
            if (!hit.found)
                hit = other;
        }
    }
    if (!hit.found) {
        pixels[index] = vec2(0.0);
        return;
    }
    // How far the ray's end moves in the tangent plane (Igehy, "Tracing ray differentials", 1999).
    vec3 ray = hit.p - eye_distance * toward_eye;
    float facing = min(dot(ray, hit.normal), -1.0e-4);
    vec3 dx = hit.distance * pixel * right;
    vec3 dy = -hit.distance * pixel * up;
    dx -= dot(dx, hit.normal) / facing * ray;
    dy -= dot(dy, hit.normal) / facing * ray;
    pixels[index] = vec2(noise_at(unit * hit.p, hit.normal, unit * dx, unit * dy), coverage);
}
