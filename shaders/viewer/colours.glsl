// Turns a noise into the viewer's colours: in the window, in exported PNGs, and in copied code.

vec3 viewer_ramp(float t, vec3 a, vec3 b, vec3 c, vec3 d, vec3 e) {
    t *= 4.0;
    vec3 low = t < 1.0 ? mix(a, b, t) : mix(b, c, t - 1.0);
    vec3 high = t < 3.0 ? mix(c, d, t - 2.0) : mix(d, e, t - 3.0);
    return t < 2.0 ? low : high;
}

// Colour maps for t in [0, 1]: 0 grey, 1 viridis, 2 blue to red through white, 3 ember, 4 sea. Map 1 interpolates five colours
// by van der Walt and Smith, map 2 five colours of Moreland's `cool to warm`.
vec3 viewer_colour(int map, float t) {
    t = clamp(t, 0.0, 1.0);
    if (map == 1)
        return viewer_ramp(t, vec3(0.267, 0.005, 0.329), vec3(0.229, 0.322, 0.546), vec3(0.128, 0.567, 0.551),
                           vec3(0.369, 0.789, 0.383), vec3(0.993, 0.906, 0.144));
    if (map == 2)
        return viewer_ramp(t, vec3(0.230, 0.299, 0.754), vec3(0.552, 0.691, 0.996), vec3(0.865, 0.865, 0.865),
                           vec3(0.957, 0.598, 0.477), vec3(0.706, 0.016, 0.150));
    if (map == 3)
        return viewer_ramp(t, vec3(0.03, 0.02, 0.05), vec3(0.34, 0.06, 0.14), vec3(0.78, 0.24, 0.09),
                           vec3(0.98, 0.64, 0.25), vec3(1.0, 0.97, 0.84));
    if (map == 4)
        return viewer_ramp(t, vec3(0.02, 0.07, 0.16), vec3(0.05, 0.26, 0.38), vec3(0.14, 0.50, 0.55),
                           vec3(0.55, 0.78, 0.70), vec3(0.96, 0.96, 0.86));
    return vec3(t);
}

// The colour at t in a colour map of eight stops: red, green, blue and position.
vec3 viewer_own_colour(vec4 stops[8], float t) {
    vec3 colour = stops[0].rgb;
    for (int i = 1; i < 8; ++i)
        colour = mix(colour, stops[i].rgb, clamp((t - stops[i - 1].a) / max(stops[i].a - stops[i - 1].a, 0.001), 0.0, 1.0));
    return colour;
}

// A cycle of all hues with equal brightness.
vec3 viewer_cycle(float t) {
    return 0.5 + 0.38 * cos(6.2831853 * (t - vec3(0.0, 0.333333, 0.666667)));
}

// The position of a noise in a colour map, 0 to 1. The ends are `contrast` standard deviations from the mean.
float viewer_value(float noise, float contrast) {
    return 0.5 + 0.5 * noise / contrast;
}

// The position of a complex noise's intensity in a colour map. `value` is (quadrature, noise).
float viewer_intensity(vec2 value, float contrast) {
    return length(value) / (1.5 * contrast);
}

// The position in a colour map of the variance that a filter keeps.
float viewer_variance(float removed) {
    return 1.0 - removed;
}

// The position of stripes in a colour map. Their `profile` along the phase is 0 sine, 1 triangle, 2 sawtooth, 3 bands or 4
// ridges. The phase changes by `turns` per pixel.
float viewer_stripes(vec2 value, int profile, float turns) {
    vec2 wave = value / max(length(value), 1.0e-6);
    float phase = fract(atan(wave.y, wave.x) / 6.2831853);
    if (profile == 1)
        return 1.0 - abs(2.0 * phase - 1.0);
    if (profile == 2)
        return min(phase, (1.0 - phase) / max(turns, 0.001));
    if (profile == 3)
        return 0.5 + clamp(wave.y / (6.2831853 * max(turns, 0.001)), -0.5, 0.5);
    if (profile == 4)
        return 1.0 - abs(wave.y);
    return 0.5 + 0.5 * wave.y;
}

// The colour of the phase of a complex noise.
vec3 viewer_phase(vec2 value, int map) {
    float phase = fract(atan(value.y, value.x) / 6.2831853);
    return map == 0 ? vec3(phase) : viewer_cycle(phase);
}

// The colour of a normal with components to the right, down, and towards the eye. `green` is 1 for up, as in OpenGL, and -1 for
// down, as in DirectX.
vec3 viewer_normal(vec3 normal, float green) {
    return 0.5 + 0.5 * normal * vec3(1.0, -green, 1.0);
}

// The colour of a normal map whose height is the noise; `deviation` is the standard deviation of a derivative.
vec3 viewer_gradient(vec2 gradient, float deviation, float contrast, float green) {
    return viewer_normal(normalize(vec3(-gradient, 2.0 * deviation / contrast)), green);
}

// The grey of a material's height.
vec3 viewer_height(float height, float contrast) {
    return vec3(0.5 + height / (0.1 * contrast));
}
