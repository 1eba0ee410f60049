// Shows a material on a ball, or flat, as the page does: seen from far away, with a lamp in a room. Include it after gabor_materials.glsl,
// room.glsl, light.glsl and srgb.glsl. The picture's x runs to the right, y down, and z towards the eye.

// What a pixel shows: a point p of the material, the normal there, the directions in which p grows, and how much of the pixel it covers.
struct Spot {
    vec2 p;
    vec3 normal;
    vec3 across;
    vec3 along;
    float covered;
};

// `place` runs from -1 to 1 along the picture's shorter side, and a pixel is `wide`. The ball's radius is `size` units of the material;
// `turned` is its angle.
Spot spot_on_ball(vec2 place, float wide, float size, float turned) {
    vec2 d = place / 0.86;
    float inside = 1.0 - dot(d, d);
    vec3 normal = inside > 0.0 ? vec3(d, sqrt(inside)) : vec3(0.0, 0.0, 1.0);
    vec3 across = normalize(vec3(normal.z, 0.0, -normal.x));
    vec2 p = size * vec2(atan(d.x, sqrt(max(inside, 0.0))) + turned, asin(clamp(d.y, -1.0, 1.0)));
    return Spot(p, normal, across, cross(normal, across), clamp((1.0 - length(d)) * 0.86 / wide, 0.0, 1.0));
}

Spot flat_spot(vec2 p) {
    return Spot(p, vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), 1.0);
}

// The material's colour for a screen, before the backdrop. `lamp` is the direction to the lamp.
vec3 colour_of_spot(Spot spot, GaborMaterial m, vec3 lamp) {
    vec3 normal = normalize(spot.normal - spot.across * m.slope.x - spot.along * m.slope.y);
    vec3 light = lit(Surface(m.colour, gabor_roughness(m), m.metalness), normal, vec3(0.0, 0.0, 1.0), lamp, vec3(0.0, -1.0, 0.0));
    return mix(srgb(backdrop), srgb(light / (1.0 + 0.3 * light)), spot.covered);
}
