uniform bool shown;
out vec4 value;

void main() {
    vec2 p = gl_FragCoord.xy / 32.0;
    float n = gabor_noise(p, 4.0, 0.7854, 7u);
    value = vec4(vec3(shown ? gabor_unorm(n) : n), 1.0);
}
