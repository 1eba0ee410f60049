// A sea in a wind that rises to the right of the mouse; the sun rises with it. Paste all of this into shadertoy.com, and change
// the code at the end as you like.

// ---- gabor_noise.glsl, gabor_fractal.glsl and gabor_ocean.glsl unchanged ----
#include "../../gabor_noise.glsl"
#include "../../gabor_fractal.glsl"
#include "../../gabor_ocean.glsl"
// ---- how the sea and the sky look ----
#include "../../passes/srgb.glsl"
#include "../../passes/seascape.glsl"
// ---- your code ----

void mainImage(out vec4 color, vec2 pixel) {
    vec2 mouse = iMouse.z > 0.0 ? iMouse.xy / iResolution.xy : vec2(0.4, 0.3);
    GaborOcean ocean = gabor_ocean_of(GaborSea(mix(3.0, 25.0, mouse.x), 2.0e5, 0.0, 12.0, 0.0, 0.0, 0.9, 0));
    vec2 sun = normalize(vec3(-0.25, 0.06 + 0.5 * mouse.y, 1.0)).xz;
    Sea sea = sea_of(ocean, 5u, int(iTime), fract(iTime), sun);
    vec2 place = (pixel - 0.5 * iResolution.xy) * vec2(1.0, -1.0);
    // The camera looks along y and down by 8 degrees.
    vec3 light = seen_at_sea_in_pixel(sea, 3.0 + 0.35 * ocean.wind, vec2(0.0, -1.0), vec2(0.99, 0.14), place, 1.05 / iResolution.y).light;
    color = vec4(srgb(light), 1.0);
}
