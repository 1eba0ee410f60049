// Lights a noise as the height of a surface. Include it after light.glsl and srgb.glsl. Copied code includes it.

// The place of a pixel, as in lamp_above, in a picture of this size.
vec2 picture_place(vec2 pixel, vec2 size) {
    return (pixel - 0.5 * size) / max(size.x, size.y);
}

// The colour of a surface with this normal, along the picture's axes. `place` is as in lamp_above, `body` as in sky_above.
vec3 viewer_lit(vec3 colour, vec3 normal, vec2 place, vec2 lamp, bool body) {
    Surface surface = Surface(pow(colour, vec3(2.2)), 0.45, 0.0);
    return srgb(lit(surface, normal, eye_above(place), lamp_above(place, lamp), sky_above(body)));
}
