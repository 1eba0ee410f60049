// The erosion filter of runevision, "Fast and gorgeous erosion filter", March 2026, whose stripes are sums of
// random splats. In each octave, each of the 4 x 4 cells around a point has one splat at a random position: a
// wave under a round window, whose stripes run downhill at the point. The benchmark compares this filter with
// gabor_eroded, which has the same structs and parameters.

// Two random numbers in [0, 1] for a cell: PCG2D by Jarzynski and Olano, "Hash functions for GPU rendering", 2020.
vec2 gabor_splat_place(ivec2 cell, uint seed) {
    uvec2 word = uvec2(cell) * 1664525u + (1013904223u + seed);
    word.x += word.y * 1664525u;
    word.y += word.x * 1664525u;
    word ^= word >> 16u;
    word.x += word.y * 1664525u;
    word.y += word.x * 1664525u;
    word ^= word >> 16u;
    return vec2(word) / 4294967296.0;
}

// Returns the cosine and sine of stripes: a sum of mean square 2, scaled by the sharpness and compressed to a length
// below 1. p is in cells, and wave in cycles per cell.
vec2 gabor_splat_stripes(vec2 p, vec2 wave, float sharpness, uint seed) {
    vec2 corner = floor(p - 0.5);
    ivec2 cell = ivec2(corner);
    vec2 offset = p - corner;
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 2; ++j) {
        for (int i = -1; i <= 2; ++i) {
            vec2 d = offset - vec2(float(i), float(j)) - gabor_splat_place(cell + ivec2(i, j), seed);
            float window = max(exp(-2.0 * dot(d, d)) - 0.0111, 0.0); // ends 1.5 cells away, nearer than any splat outside these cells
            float phase = 6.2831853 * dot(d, wave);
            sum += window * vec2(cos(phase), sin(phase));
        }
    }
    sum *= 1.63 * sharpness;
    return sum * inversesqrt(1.0 + dot(sum, sum));
}

float gabor_splat_mask(float t, float rounding) {
    float s = 1.0 - min(t < rounding ? 0.5 * t * t / rounding : t - 0.5 * rounding, 1.0);
    return 1.0 - s * s;
}

GaborTerrain gabor_splat_eroded(vec2 p, GaborTerrain base, GaborErosion erosion, uint seed) {
    GaborTerrain terrain = base;
    float gully = base.ridge;
    vec2 gully_slope = vec2(0.0);
    vec2 steer = base.slope;
    float frequency = erosion.gully_frequency;
    float depth = erosion.strength / erosion.gully_frequency;
    float mask = 1.0;
    float rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * base.ridge);
    for (int i = 0; i < erosion.octaves; ++i) {
        float steep = max(length(steer), 1.0e-9);
        float full = gabor_splat_mask(steep / erosion.onset_slope, rounding);
        mask *= full * full;
        vec2 across = vec2(-steer.y, steer.x) / steep;
        float cells = frequency / 0.9; // a window has as many waves as in gabor_eroded
        vec2 z = gabor_splat_stripes(p * cells, 0.9 * across, erosion.uniformity, seed + uint(i) * 0x9e3779b9u);
        gully = mix(gully, erosion.gully_weight * z.x, mask);
        gully_slope = mix(gully_slope, -6.2831853 * frequency * erosion.gully_weight * z.y * across, mask);
        terrain.ridge = mix(terrain.ridge, z.x, mask);
        terrain.height += depth * gully;
        terrain.slope += depth * gully_slope;
        float side = z.y < 0.0 ? -6.2831853 : 6.2831853;
        steer -= side * erosion.branching * erosion.gully_weight * frequency * depth * mask * across;
        rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * z.x);
        mask = mask * erosion.detail / (1.0 + mask * (erosion.detail - 1.0))
             * gabor_splat_mask(abs(z.y), rounding * frequency / erosion.gully_frequency);
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return terrain;
}
