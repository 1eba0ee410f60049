// Puts a material on a surface in space. Include it after the definition of material_at(p, dx, dy), a material in the plane.

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
// from three planes along the axes, weighted by how much the surface faces each; otherwise from the plane z = 0. Slopes are
// finite differences over a pixel's smaller side. The outer loop keeps compilers from inlining the material three times.
Relief relief_at(vec3 p, vec3 dx, vec3 dy, vec3 normal, bool body) {
    vec3 facing = body ? pow(abs(normal), vec3(8.0)) : vec3(0.0, 0.0, 1.0);
    facing /= facing.x + facing.y + facing.z;
    GaborMaterial m = GaborMaterial(vec3(0.0), 0.0, 0.0, 0.0);
    vec3 slope = vec3(0.0);
    for (int axis = body ? 0 : 2; axis < 3; ++axis) {
        float share = facing[axis];
        if (share < 0.01)
            continue;
        Plane plane = plane_along(axis);
        vec2 step_x = on_plane(dx, plane);
        vec2 step_y = on_plane(dy, plane);
        float side = min(length(step_x), length(step_y));
        for (int i = 0; i < 5; ++i) { // p, then half a side to the right, left, down and up
            vec2 along = i == 0 ? vec2(0.0) : (i % 2 == 0 ? -0.5 : 0.5) * (i < 3 ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
            GaborMaterial there = material_at(plane.origin + on_plane(p, plane) + side * along, step_x, step_y);
            if (i == 0) {
                m.colour += share * there.colour;
                m.height += share * there.height;
                m.roughness += share * there.roughness;
                m.metalness += share * there.metalness;
            } else {
                slope += share * there.height / side * (2.0 * along.x * plane.right + 2.0 * along.y * plane.down);
            }
        }
    }
    return Relief(m, slope);
}

vec3 bumped_normal(vec3 normal, vec3 slope) {
    return normalize(normal - (slope - dot(slope, normal) * normal));
}
