// Clouds over half of the sky. Drag to the right for rougher clouds, and upwards for more of them. Paste all of this into
// shadertoy.com, and change the code at the end as you like.

// ---- gabor_noise.glsl unchanged ----
#include "../../gabor_noise.glsl"
// ---- gabor_fractal.glsl unchanged ----
#include "../../gabor_fractal.glsl"
// ---- your code ----

void mainImage(out vec4 color, vec2 pixel)
{
    GaborFractal fractal = gabor_fractal(7.0, iMouse.z > 0.0 ? iMouse.x / iResolution.x : 0.5);
    float clear = iMouse.z > 0.0 ? 1.0 - iMouse.y / iResolution.y : 0.5;
    GaborPlace place = gabor_place_at(pixel / 120.0 + vec2(0.2 * iTime, 0.0)); // 120 pixels per kernel radius
    place.evolution = 0.02 * iTime;
    place = gabor_warp(place, 0.2, gabor_fractal(3.0, 0.5), 8u).place;
    float cover = gabor_uniform(gabor_fractal_noise(place, fractal, 7u).noise);
    color = vec4(mix(vec3(0.2, 0.42, 0.75), vec3(1.0), smoothstep(clear - 0.15, clear + 0.15, cover)), 1.0);
}
