// Gabor noise: waves whose frequency and direction you choose. Drag the mouse to the right for higher frequencies, and
// upwards to turn the waves. Paste all of this into shadertoy.com, and change mainImage, at the end, as you like.

// ---- gabor_noise.glsl unchanged ----
#include "../../gabor_noise.glsl"
// ---- your code ----

void mainImage(out vec4 color, vec2 pixel)
{
    vec2 p = pixel / 32.0; // 32 pixels per kernel radius
    float frequency = 4.0;
    float orientation = 0.7854;
    if (iMouse.z > 0.0) {
        frequency = 8.0 * iMouse.x / iResolution.x;
        orientation = 3.1416 * iMouse.y / iResolution.y;
    }
    float n = gabor_noise(p, frequency, orientation, 7u);
    color = vec4(vec3(gabor_unorm(n)), 1.0);
}
