#version 450
#extension GL_GOOGLE_include_directive : require

// Noise in space for the viewer: a sphere or a torus that carries it, seen in perspective and turned by hand.
//
// Bodies are in a unit of their own, in which the sphere has radius 1, and are looked at from a distance of 4.

#include "../passes/recipe_3d.glsl"
#include "view.glsl"

layout(constant_id = 12) const int view = 0;     // 0 sphere, 1 torus, 2 the plane z = 0.5, for the law of the values
layout(constant_id = 13) const int waves = 0;    // 0 oriented, 1 isotropic, 2 and 3 the same along the surface
layout(constant_id = 14) const int filtered = 0; // by the pixel's footprint
layout(constant_id = 15) const int with_quadrature = 0;
layout(constant_id = 16) const int with_gradient = 0;
const int channels = 1 + with_quadrature + 2 * with_gradient;

const float eye_distance = 4.0;
const float torus_large = 0.68; // radius of the circle around the axis z, and of the tube
const float torus_small = 0.3;

GaborKernel3d kernel_at(vec3 normal)
{
    vec3 direction = vec3(cos(orientation), sin(orientation), 0.0);
    if (waves == 1)
        return gabor_kernel_isotropic_3d(frequency);
    if (waves == 2)
        return gabor_kernel_surface(frequency, direction, normal);
    if (waves == 3)
        return gabor_kernel_surface_isotropic(frequency, normal);
    return gabor_kernel_3d(frequency, direction);
}

void write(GaborField3d field, vec3 tangent, vec3 bitangent, int at)
{
    picture[at++] = field.value.y;
    if (with_quadrature == 1)
        picture[at++] = field.value.x;
    if (with_gradient == 1) {
        vec3 slope = vec3(field.slope_x.y, field.slope_y.y, field.slope_z.y);
        picture[at++] = dot(slope, tangent);
        picture[at++] = dot(slope, bitangent);
    }
}

float distance_to_torus(vec3 p)
{
    return length(vec2(length(p.xy) - torus_large, p.z)) - torus_small;
}

// Where a ray from the eye meets the body, or nothing.
bool hit(vec3 eye, vec3 ray, out vec3 p, out vec3 normal)
{
    float foot = -dot(eye, ray) / dot(ray, ray);
    vec3 nearest = eye + foot * ray;
    float square = 1.0 - dot(nearest, nearest);
    if (view == 0) {
        p = normalize(eye + (foot - sqrt(max(square, 0.0) / dot(ray, ray))) * ray);
        normal = p;
        return square > 0.0;
    }
    // The torus is within the sphere: sphere tracing between where the ray enters and leaves it.
    float side = length(ray);
    float within = sqrt(max(square, 0.0)) / side;
    float t = foot - within;
    float gap = square > 0.0 ? distance_to_torus(eye + t * ray) : 1.0;
    for (int i = 0; i < 96 && square > 0.0 && gap > 1.0e-5 && t < foot + within; ++i) {
        t += max(gap, 2.0e-4) / side;
        gap = distance_to_torus(eye + t * ray);
    }
    p = eye + t * ray;
    normal = normalize(p - vec3(torus_large * normalize(p.xy), 0.0));
    p -= gap * normal;
    return square > 0.0 && gap < 1.0e-3;
}

void main()
{
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    Line column = columns[here.x];
    Line row = rows[here.y + first_row];
    vec3 right = vec3(cos(yaw), sin(yaw), 0.0);
    vec3 toward_eye = vec3(sin(yaw) * cos(pitch), -cos(yaw) * cos(pitch), sin(pitch));
    vec3 up = cross(toward_eye, right);
    if (view == 2) {
        GaborPlace3d place = gabor_place_3d(ivec3(column.cell, row.cell, 0), vec3(column.local, row.local, 0.5));
        write(gabor_field_3d(place, kernel_at(vec3(0.0, 0.0, 1.0)), seed), right, up, at);
        return;
    }
    vec3 eye = eye_distance * toward_eye;
    vec3 ray = (column.local * right - row.local * up) / focal_length - toward_eye;
    vec3 p;
    vec3 normal;
    if (!hit(eye, ray, p, normal)) {
        for (int i = 0; i < channels; ++i)
            picture[at + i] = i == 0 ? 1.0e9 : 0.0; // what show.frag takes for the background
        return;
    }
    GaborKernel3d kernel = kernel_at(normal);
    if (filtered == 1) {
        // How far the ray's end moves in the tangent plane (Igehy, "Tracing ray differentials", 1999).
        vec3 along = p - eye;
        float facing = min(dot(along, normal), -1.0e-4);
        float step_side = stride * length(along) / (length(ray) * focal_length);
        vec3 dx = step_side * right;
        vec3 dy = -step_side * up;
        dx -= dot(dx, normal) / facing * along;
        dy -= dot(dy, normal) / facing * along;
        kernel = gabor_filtered_3d(kernel, pixel * dx, pixel * dy);
    }
    GaborPlace3d place = gabor_place_3d(ivec3(0), pixel * p * GABOR_3D_RADIUS);
    place.time = time;
    write(gabor_field_3d(place, kernel, seed), right, -up, at);
}
