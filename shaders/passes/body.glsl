// A sphere or torus as a camera sees it. The including file defines the constants `view` and `rays`, and the push constants
// center, pixel, yaw and pitch of passes/solid_interface.h.
//
// The unit of length is the radius of the sphere. The torus lies inside the sphere.

#include "camera.glsl"

const float torus_large = 0.68; // radius of the circle around the z axis
const float torus_small = 0.3;  // radius of the tube

struct Hit {
    bool found;
    float gap;      // estimate of the ray's distance from the body, at most twice the true distance
    float distance; // distance along the ray, relative to the length of the ray's vector
    vec3 p;         // hit point, in radii of the sphere
    vec3 normal;
};

float distance_to_torus(vec3 p) {
    return length(vec2(length(p.xy) - torus_large, p.z)) - torus_small;
}

float distance_to_body(vec3 p) {
    return view == view_sphere ? length(p) - 1.0 : distance_to_torus(p);
}

vec3 torus_normal(vec3 p) {
    return normalize(p - vec3(torus_large * normalize(p.xy), 0.0));
}

// The direction of a ray from the eye, with length 1 along the camera's axis.
vec3 ray_of(vec2 at, Axes axes) {
    vec2 plane = pixel * (at - center);
    return plane.x * axes.right - plane.y * axes.up - axes.toward_eye;
}

// Starts at the point on the ray nearest to the centre, which avoids the cancellation in the quadratic formula.
Hit sphere_hit(vec3 eye, vec3 ray) {
    float foot = -dot(eye, ray) / dot(ray, ray);
    vec3 nearest = eye + foot * ray;
    float square = 1.0 - dot(nearest, nearest);
    float t = foot - sqrt(max(square, 0.0) / dot(ray, ray));
    vec3 p = normalize(eye + t * ray);
    return Hit(square > 0.0, length(nearest) - 1.0, t, p, p);
}

// Finds the hit by sphere tracing with a minimum step. It can miss only rays whose path through the body is shorter than
// 0.001, and so no deeper than 10^-6. A step that ends inside the body is halved until it finds the surface.
Hit torus_hit(vec3 eye, vec3 ray) {
    float side = length(ray);
    float t = (eye_distance - torus_large - torus_small) / side;
    float gap = distance_to_torus(eye + t * ray);
    float least = gap;
    for (int i = 0; i < 160 && gap > 0.0 && t * side < eye_distance + 1.0; ++i) {
        t += max(gap, 0.001) / side;
        gap = distance_to_torus(eye + t * ray);
        least = min(least, gap);
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
    return Hit(found, least, t, p - distance_to_torus(p) * normal, normal);
}

Hit hit_of(vec2 at, Axes axes) {
    vec3 eye = eye_distance * axes.toward_eye;
    if (view == view_sphere)
        return sphere_hit(eye, ray_of(at, axes));
    return torus_hit(eye, ray_of(at, axes));
}

// The part of the body that a pixel shows.
struct Seen {
    bool found;
    float coverage;
    vec3 p; // hit point of the pixel's central ray or, if it misses, of the first other ray that hits
    vec3 normal;
    vec3 dx; // change of the hit point in the tangent plane from one pixel to the next
    vec3 dy;
};

// Whether it is certain that all rays of the pixel hit the body, or that all miss it. Hits are at most `reach` apart, and no
// body is thinner than the torus's tube.
bool all_alike(Hit hit, vec3 ray) {
    float reach = 0.75 * pixel * (eye_distance + 1.0);
    float facing = dot(normalize(ray), hit.normal);
    return hit.found ? 0.5 * torus_small * facing * facing > reach : hit.gap > 2.0 * reach;
}

// `corner` is the pixel's upper left corner.
Seen seen_at(vec2 corner, Axes axes) {
    Hit hit = hit_of(corner + 0.5, axes);
    float coverage = hit.found ? 1.0 : 0.0;
    if (!all_alike(hit, ray_of(corner + 0.5, axes))) {
        coverage = 0.0;
        for (int i = 0; i < rays * rays; ++i) {
            vec2 within = (vec2(float(i % rays), float(i / rays)) + 0.5) / float(rays);
            Hit other = hit_of(corner + within, axes);
            if (other.found) {
                coverage += 1.0 / float(rays * rays);
                if (!hit.found)
                    hit = other;
            }
        }
    }
    // Igehy, "Tracing ray differentials", 1999.
    vec3 ray = hit.p - eye_distance * axes.toward_eye;
    float facing = min(dot(ray, hit.normal), -1.0e-4);
    vec3 dx = hit.distance * pixel * axes.right;
    vec3 dy = -hit.distance * pixel * axes.up;
    dx -= dot(dx, hit.normal) / facing * ray;
    dy -= dot(dy, hit.normal) / facing * ray;
    return Seen(hit.found, coverage, hit.p, hit.normal, dx, dy);
}

// The floor below a body where the ray through a pixel meets it: how much of the sky and of the lamp's light the body
// leaves, and how much the floor differs from the backdrop there.
struct Floor {
    float open;
    float lamp_open;
    float near;
};

// `toward_lamp` is the direction to the lamp, in space.
Floor floor_at(vec2 at, vec3 toward_lamp, Axes axes) {
    vec3 eye = eye_distance * axes.toward_eye, ray = ray_of(at, axes);
    float level = view == view_sphere ? -1.0 : -torus_small, t = (level - eye.z) / ray.z;
    Floor seen = Floor(1.0, 1.0, 0.0);
    if (t <= 0.0 || ray.z >= 0.0)
        return seen;
    vec3 p = eye + t * ray;
    seen.near = exp(-0.3 * dot(p.xy, p.xy));
    float far = 0.06;
    for (int i = 0; i < 5; ++i, far *= 1.8) // Evans, Fast approximations for global illumination on dynamic scenes, 2006
        seen.open -= 0.35 * (1.0 - clamp(distance_to_body(p + vec3(0.0, 0.0, far)) / far, 0.0, 1.0));
    seen.open = max(seen.open, 0.1);
    far = 0.02;
    for (int j = 0; j < 24; ++j) { // the narrowest cone towards the lamp that the body leaves
        float gap = distance_to_body(p + far * toward_lamp);
        seen.lamp_open = min(seen.lamp_open, 0.5 + 2.5 * gap / far);
        far += clamp(gap, 0.03, 0.4);
    }
    seen.lamp_open = smoothstep(0.0, 1.0, seen.lamp_open);
    return seen;
}
