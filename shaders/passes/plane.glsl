// Where pixels see a plane, from above or from a camera that looks horizontally. The passes and copied code include it.

// The point that a pixel shows, and the steps to those that the next pixels show.
struct Footprint {
    vec2 position;
    vec2 dx;
    vec2 dy;
};

Footprint footprint_from_above(vec2 p, float pixel) {
    return Footprint(p, vec2(pixel, 0.0), vec2(0.0, pixel));
}

// The camera is above the point 0, at `height`. `at` is the pixel's place, in pixels from the middle of the horizon, which must be
// above it: depth = height * focal length / rows below the horizon.
Footprint footprint_below_horizon(vec2 at, float height, float focal_length) {
    float near = height / at.y;
    return Footprint(near * vec2(at.x, -focal_length), vec2(near, 0.0), near / at.y * vec2(-at.x, focal_length));
}

// The direction to that camera: to the right, down, and out of the picture of the plane from above.
vec3 eye_above_horizon(vec2 at, float focal_length) {
    return normalize(vec3(-at.x, focal_length, at.y));
}
