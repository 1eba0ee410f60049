// Brings light to the range of a screen. After Narkowicz, ACES filmic tone mapping curve, 2016.
vec3 exposed(vec3 light) {
    vec3 c = 0.8 * light;
    return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
}

// Encodes light for a screen.
vec3 srgb(vec3 light) {
    light = clamp(light, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}
