// A sea in a wind that rises to the right of the mouse; the sun rises with it. Paste all of this into shadertoy.com, and change
// the code at the end as you like.

// ---- gabor_noise.glsl unchanged ----
#include "../../gabor_noise.glsl"
// ---- gabor_ocean.glsl unchanged ----
#include "../../gabor_ocean.glsl"
// ---- your code ----

const uint seed = 5u;

vec3 sky(vec3 ray, vec3 sun) {
    float up = max(ray.y, 0.0), toward = max(dot(ray, sun), 0.0);
    vec3 color = mix(vec3(0.55, 0.64, 0.72), vec3(0.10, 0.24, 0.52), 1.0 - exp(-3.5 * up));
    return color + vec3(1.0, 0.75, 0.45) * (0.25 * pow(toward, 6.0) + 0.5 * pow(toward, 120.0));
}

// The light of water seen along a ray: the sky and the sun in facets, whose slopes spread by w.lost, and light from below.
vec3 seen(GaborWater w, float foam, vec3 ray, vec3 sun) {
    vec3 normal = normalize(vec3(-w.slope.x, 1.0, -w.slope.y));
    float facing = max(dot(normal, -ray), 0.02), spread = w.lost.x + w.lost.y;
    float fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0) / (1.0 + 22.0 * sqrt(spread)); // [Bruneton, Neyret, Holzschuch 2010]
    vec3 mirror = reflect(ray, normal);
    mirror.y = abs(mirror.y) + 0.6 * sqrt(spread); // rough water reflects higher parts of the sky
    vec3 middle = normalize(sun - ray); // facets with this normal reflect the sun
    vec2 apart = -middle.xz / middle.y - w.slope, c = w.lost.xy + 1.0e-4;
    float determinant = max(c.x * c.y - w.lost.z * w.lost.z, 1.0e-9);
    float chance = exp(-0.5 * (c.y * apart.x * apart.x + c.x * apart.y * apart.y - 2.0 * w.lost.z * apart.x * apart.y) / determinant)
                 / (6.2831853 * sqrt(determinant));
    float glitter = 0.0002 * chance * (0.02 + 0.98 * pow(1.0 - max(dot(middle, sun), 0.0), 5.0)) / (pow(middle.y, 4.0) * facing);
    vec3 below = vec3(0.006, 0.035, 0.05) + vec3(0.01, 0.07, 0.06) * clamp(0.4 + 0.35 * w.height, 0.0, 1.5) * (0.4 + 0.6 * sun.y);
    vec3 light = mix(below, sky(normalize(mirror), sun), fresnel) + 40.0 * vec3(1.0, 0.85, 0.6) * glitter;
    return mix(light, vec3(0.75, 0.8, 0.85), 0.9 * foam);
}

void mainImage(out vec4 color, vec2 pixel) {
    vec2 mouse = iMouse.z > 0.0 ? iMouse.xy / iResolution.xy : vec2(0.4, 0.3);
    GaborOcean ocean = gabor_ocean_of(GaborSea(mix(3.0, 25.0, mouse.x), 2.0e5, 0.0, 12.0, 0.0, 0.0, 0.9, 0));
    float high = 0.06 + 0.5 * mouse.y;
    vec3 sun = normalize(vec3(-0.25, high, 1.0));
    vec2 screen = (2.0 * pixel - iResolution.xy) / iResolution.y;
    vec3 eye = vec3(0.0, 3.0 + 0.35 * ocean.wind, 0.0), ray = normalize(vec3(screen.x, screen.y - 0.35, 1.9));
    vec3 view = sky(ray, sun);
    if (ray.y < -0.004) {
        float wide = 1.05 / iResolution.y, t = eye.y / -ray.y;
        float foam = 0.0;
        GaborWater w = GaborWater(0.0, vec2(0.0), vec2(0.0), 1.0, vec3(0.0), vec3(0.0));
        for (int i = 0; i < 6; ++i) { // where the ray meets the waves, filtered for the pixel there
            vec2 p = eye.xz + t * ray.xz, across = wide * t * normalize(vec2(ray.z, -ray.x));
            vec2 along = wide * t / max(-ray.y, 0.02) * normalize(ray.xz);
            p -= w.shift;
            w = gabor_water_filtered(p, across, along, iTime, ocean, seed);
            if (i == 5) foam = gabor_foam(p, across, along, w, ocean, seed);
            else t = max(t + 0.6 * (eye.y + t * ray.y - w.height) / (0.12 - ray.y), 1.0);
        }
        vec3 air = sky(normalize(vec3(ray.x, 0.02, ray.z)), sun);
        view = mix(air, seen(w, foam, ray, sun), exp(-0.00025 * t));
    }
    view = view * (2.51 * view + 0.03) / (view * (2.43 * view + 0.59) + 0.14); // tone mapping [Narkowicz 2015]
    color = vec4(pow(clamp(view, 0.0, 1.0), vec3(0.4545)), 1.0);
}
