// Stripes that follow a vortex. The direction map is read at the nine nodes around a pixel, so stripes stay whole everywhere.
#import gabor_noise::noise::{gabor_place_at, gabor_stripes_of}
#import gabor_noise::direction::{GaborWaves, gabor_field_waves, gabor_node_position}

@group(0) @binding(0) var<storage, read_write> pixels: array<u32>;

// The wave vector at p, in cycles per kernel radius. The stripes spiral around (12, 6).
fn vortex(p: vec2f) -> vec2f {
    let r = p - vec2f(12.0, 6.0);
    return 3.0 * (r + 0.35 * vec2f(-r.y, r.x)) / max(length(r), 0.5);
}

@compute @workgroup_size(8, 8) fn draw(@builtin(global_invocation_id) pixel: vec3u) {
    let place = gabor_place_at(vec2f(pixel.xy) / 32.0); // 32 pixels per kernel radius
    var waves: GaborWaves;
    for (var node = 0; node < 9; node++) {
        waves.wave[node] = vortex(gabor_node_position(place, node));
    }
    let stripes = gabor_stripes_of(gabor_field_waves(place, waves, 7u), 3.0);
    let colour = mix(vec3f(0.16, 0.10, 0.30), vec3f(1.0, 0.82, 0.55), 0.5 + 0.5 * stripes.x);
    pixels[768u * pixel.y + pixel.x] = pack4x8unorm(vec4f(colour, 1.0));
}
