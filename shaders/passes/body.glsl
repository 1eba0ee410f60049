// A sphere or a torus as a camera sees it. What includes this has the constants `view` and
// `rays`, and pushes center, pixel, yaw and pitch as passes/solid_interface.h says.
//
// Bodies are in a unit of their own, in which the sphere has radius 1. The camera looks at their centre from a distance
// of 4. The torus lies within the sphere.

const float eye_distance = 4.0;
const float torus_large = 0.68; // radius of the circle around the axis z, and of the tube
const float torus_small = 0.3;

// Of the camera, of length 1.
struct Axes {
    vec3 right;
    vec3 up;
    vec3 toward_eye;
};

Axes camera_axes() {
    vec3 right = vec3(yaw.x, yaw.y, 0.0);
    vec3 toward_eye = vec3(yaw.y * pitch.x, -yaw.x * pitch.x, pitch.y);
    return Axes(right, vec3(-yaw.y * pitch.y, yaw.x * pitch.y, pitch.x), toward_eye);
}

// A vector along the picture's right and down, and to the eye.
vec3 in_picture(vec3 v, Axes axes) {
    return vec3(dot(v, axes.right), -dot(v, axes.up), dot(v, axes.toward_eye));
}

struct Hit {
    bool found;
    float gap;      // how far from the body the ray passes; it may be half as far
    float distance; // along the ray, in its direction's length
    vec3 p;         // in the body's unit
    vec3 normal;
};

float distance_to_torus(vec3 p) {
    return length(vec2(length(p.xy) - torus_large, p.z)) - torus_small;
}

vec3 torus_normal(vec3 p) {
    return normalize(p - vec3(torus_large * normalize(p.xy), 0.0));
}

// A ray from the eye; its direction has length 1 along the axis of the camera.
vec3 ray_of(vec2 at, Axes axes) {
    vec2 plane = pixel * (at - center);
    return plane.x * axes.right - plane.y * axes.up - axes.toward_eye;
}

// From the ray's foot, where it is nearest to the centre: the quadratic equation without its cancellation.
Hit sphere_hit(vec3 eye, vec3 ray) {
    float foot = -dot(eye, ray) / dot(ray, ray);
    vec3 nearest = eye + foot * ray;
    float square = 1.0 - dot(nearest, nearest);
    float t = foot - sqrt(max(square, 0.0) / dot(ray, ray));
    vec3 p = normalize(eye + t * ray);
    return Hit(square > 0.0, length(nearest) - 1.0, t, p, p);
}

// By sphere tracing with a shortest step: what it steps over is a chord of 0.001, 10^-6 below the surface. A step that
// ends inside the body is halved until the surface is found.
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

// What a pixel sees of the body, its upper left corner at `corner`.
struct Seen {
    bool found;
    float coverage;
    vec3 p; // where the pixel's central ray hits, or where it misses the first other one
    vec3 normal;
    vec3 dx; // how far the ray's end moves in the tangent plane to the next pixels
    vec3 dy;
};

// Whether all rays of the pixel hit, or none: they are at most `reach` apart on the body, and a body is at least as
// deep under a point of its surface as the tube of the torus.
bool all_alike(Hit hit, vec3 ray) {
    float reach = 0.75 * pixel * (eye_distance + 1.0);
    float facing = dot(normalize(ray), hit.normal);
    return hit.found ? 0.5 * torus_small * facing * facing > reach : hit.gap > 2.0 * reach;
}

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
