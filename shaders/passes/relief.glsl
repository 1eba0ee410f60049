// Puts a material on a surface in space, and lights it. Include it after plane.glsl, camera.glsl, light.glsl and the definition of
// material_at(p, dx, dy), a material in the plane. The pass and copied code include it.

// The material at a point on the surface, and the slope of its relief, in space.
struct Relief {
    GaborMaterial material;
    vec3 slope;
};

// A plane in space, covered with the material. `origin` is the position of the plane's origin on the material. It differs
// between planes, because they would otherwise mirror each other where they meet.
struct Plane {
    vec3 right;
    vec3 down;
    vec2 origin;
};

Plane plane_along(int axis) {
    return Plane(axis == 0 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0),
                 axis == 2 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, -1.0), vec2(64.0 * float(2 - axis)));
}

vec2 on_plane(vec3 v, Plane plane) {
    return vec2(dot(v, plane.right), dot(v, plane.down));
}

// The relief at p, in units of the material; dx and dy are the steps to the next pixels. For a body, the material is projected
// from three planes along the axes, weighted by how much the surface faces each; otherwise from the plane z = 0. Of `lost`, only
// the sum of xx and yy is right. The loop keeps compilers from inlining the material three times.
Relief relief_at(vec3 p, vec3 dx, vec3 dy, vec3 normal, bool body) {
    vec3 facing = body ? pow(abs(normal), vec3(8.0)) : vec3(0.0, 0.0, 1.0);
    facing /= facing.x + facing.y + facing.z;
    GaborMaterial m = GaborMaterial(vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, vec3(0.0));
    vec3 slope = vec3(0.0);
    for (int axis = body ? 0 : 2; axis < 3; ++axis) {
        float share = facing[axis];
        if (share < 0.01)
            continue;
        Plane plane = plane_along(axis);
        GaborMaterial there = material_at(plane.origin + on_plane(p, plane), on_plane(dx, plane), on_plane(dy, plane));
        m.colour += share * there.colour;
        m.height += share * there.height;
        m.roughness += share * there.roughness;
        m.metalness += share * there.metalness;
        slope += share * (there.slope.x * plane.right + there.slope.y * plane.down);
        vec2 n = on_plane(normal, plane); // slopes along the normal do not tilt the surface
        m.lost.x += share * share * dot(there.lost, vec3(1.0 - n * n, -2.0 * n.x * n.y));
    }
    return Relief(m, slope);
}

// A point of the surface that a pixel shows, and how it is seen.
struct SurfacePoint {
    vec3 position;
    vec3 dx; // steps to the points that the next pixels show
    vec3 dy;
    vec3 normal;
    vec3 eye;   // direction to the eye, along the axes of the picture
    vec2 place; // as in lamp_above
};

SurfacePoint point_of_plane(Footprint here, vec3 eye, vec2 place) {
    return SurfacePoint(vec3(here.position, 0.0), vec3(here.dx, 0.0), vec3(here.dy, 0.0), vec3(0.0, 0.0, 1.0), eye, place);
}

// The point of the plane that a pixel shows, from above or, if `sky` rows are above the horizon, in perspective. The parameters are
// those of passes/material_interface.h.
SurfacePoint point_of_pixel(vec2 pixel_at, vec2 center, vec2 corner, float pixel, float sky, float focal_length) {
    if (sky > 0.0) {
        vec2 at = pixel_at - vec2(center.x, sky);
        Footprint here = footprint_below_horizon(at, pixel, focal_length);
        here.position += corner;
        return point_of_plane(here, eye_above_horizon(at, focal_length), vec2(0.0));
    }
    vec2 place = (pixel_at - center) / (2.0 * max(center.x, center.y));
    return point_of_plane(footprint_from_above(corner + pixel * pixel_at, pixel), eye_above(place), place);
}

// p, dx and dy are in radii of the sphere, which is `unit` units of the material.
SurfacePoint point_of_body(vec3 p, vec3 dx, vec3 dy, vec3 normal, float unit, Axes axes) {
    vec3 eye = normalize(in_picture(eye_distance * axes.toward_eye - p, axes));
    return SurfacePoint(unit * p, unit * dx, unit * dy, normal, eye, vec2(0.0));
}

// A piece of the surface as it is seen, along the axes of the picture.
struct Sample {
    GaborMaterial material;
    vec3 slope;
    vec3 normal; // with the relief
    vec3 eye;
    vec2 place;
};

// A shader should call this once: each call compiles the material again.
Sample sample_at(SurfacePoint here, bool body, Axes axes) {
    Relief relief = relief_at(here.position, here.dx, here.dy, here.normal, body);
    Sample seen = Sample(relief.material, relief.slope, bumped_normal(here.normal, relief.slope), here.eye, here.place);
    if (body) { // planes have the axes of the picture
        seen.slope = in_picture(seen.slope, axes);
        seen.normal = in_picture(seen.normal, axes);
    }
    return seen;
}

// The light of the sample to the eye: see lit() in light.glsl. `lamp` is as in lamp_above, `body` as in sky_above.
vec3 lit_sample(Sample here, vec2 lamp, bool body) {
    GaborMaterial m = here.material;
    return lit(Surface(m.colour, gabor_roughness(m), m.metalness), here.normal, here.eye, lamp_above(here.place, lamp), sky_above(body));
}
