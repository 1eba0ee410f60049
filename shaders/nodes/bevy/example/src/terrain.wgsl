// Eroded mountains from above, lit from the upper left.
#import gabor_noise::erosion::{gabor_eroded, gabor_erosion, gabor_terrain}

@group(0) @binding(0) var<storage, read_write> pixels: array<u32>;

@compute @workgroup_size(8, 8) fn draw(@builtin(global_invocation_id) pixel: vec3u) {
    let p = vec2f(pixel.xy) / 64.0; // hills are about four units wide
    var erosion = gabor_erosion();
    erosion.octaves = 6;
    let ground = gabor_eroded(p, gabor_terrain(p, 5u), erosion, 5u);
    let normal = normalize(vec3f(-ground.slope, 1.0));
    let light = max(dot(normal, normalize(vec3f(-1.0, -1.0, 1.1))), 0.0) + 0.15;
    let rock = mix(vec3f(0.25, 0.21, 0.17), vec3f(0.9, 0.92, 0.95), smoothstep(0.2, 0.5, ground.height - 0.1 * ground.ridge));
    let colour = mix(vec3f(0.13, 0.17, 0.07), rock, smoothstep(-0.2, 0.15, ground.height));
    pixels[768u * pixel.y + pixel.x] = pack4x8unorm(vec4f(sqrt(1.2 * light * colour), 1.0));
}
