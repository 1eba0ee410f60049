// The axes of a camera that looks at a body. The passes and copied code include it.

const float eye_distance = 4.0; // from the eye to the middle of the body, in radii of the sphere

// The camera's axes, of length 1.
struct Axes {
    vec3 right;
    vec3 up;
    vec3 toward_eye;
};

// `yaw` and `pitch`: cosine and sine of the eye's angles around the z axis and above the plane z = 0.
Axes camera_axes(vec2 yaw, vec2 pitch) {
    vec3 right = vec3(yaw.x, yaw.y, 0.0);
    vec3 toward_eye = vec3(yaw.y * pitch.x, -yaw.x * pitch.x, pitch.y);
    return Axes(right, vec3(-yaw.y * pitch.y, yaw.x * pitch.y, pitch.x), toward_eye);
}

// The axes of a slice, which are those of the plane, with y pointing down.
Axes flat_axes() {
    return Axes(vec3(1.0, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, 1.0));
}

// A vector's components to the right, down, and towards the eye.
vec3 in_picture(vec3 v, Axes axes) {
    return vec3(dot(v, axes.right), -dot(v, axes.up), dot(v, axes.toward_eye));
}

// Where the eye sees the point p of a body, in the plane at distance 1 from the eye. `unit`: the radius of the sphere.
vec2 place_of_body(vec3 p, float unit, Axes axes) {
    return in_picture(p, axes).xy / (unit * eye_distance - dot(p, axes.toward_eye));
}
