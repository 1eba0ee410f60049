// Fly over mountains around lakes; drag the mouse to look around. Paste all of this into shadertoy.com, and change the code at the
// end as you like.

// ---- gabor_noise.glsl, gabor_erosion.glsl and gabor_fractal.glsl unchanged ----
#include "../../gabor_noise.glsl"
#include "../../gabor_erosion.glsl"
#include "../../gabor_fractal.glsl"
// ---- the ground, and how it looks ----
#include "../../passes/srgb.glsl"
#include "../../passes/ground.glsl"
#include "../../passes/ranges.glsl"
#include "../../passes/landscape.glsl"
// ---- your code ----

void mainImage(out vec4 color, vec2 pixel) {
    GaborErosion erosion = gabor_erosion();
    erosion.gully_frequency = 1.0;
    erosion.strength = 0.15;
    erosion.detail = 2.5;
    float reach = 0.3, water = -0.2; // reach: strength / gully_frequency / (1 - gain)
    Ground ground = Ground(ivec2(0), vec2(0.0), 9u, erosion, reach, vec2(0.17, -0.96), 0, water);

    float time = 0.12 * iTime;
    vec2 turn = iMouse.z > 0.0 ? (iMouse.xy / iResolution.xy - 0.5) * vec2(6.2831853, 1.2) : vec2(0.0);
    float heading = 0.34 + 0.5 * sin(0.23 * time) + turn.x, pitch = -0.08 + turn.y;
    vec3 ahead = vec3(cos(heading) * cos(pitch), sin(pitch), sin(heading) * cos(pitch));
    vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)));
    vec3 eye = vec3(-1.56 + 2.0 * time, 0.71, 0.07);
    eye.y = height_of_eye(ground, eye, normalize(ahead.xz), 5.0);
    vec2 screen = (2.0 * pixel - iResolution.xy) / iResolution.y;
    vec3 ray = normalize(2.8 * ahead + screen.x * right + screen.y * cross(right, ahead));
    color = vec4(srgb(exposed(seen_along(ground, eye, ray, 0.71 / iResolution.y, 5.0).light)), 1.0);
}
