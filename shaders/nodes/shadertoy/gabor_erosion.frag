// Fly over eroded mountains; drag the mouse to look around. Paste all of this into shadertoy.com, and change the code at the
// end as you like.

// ---- gabor_noise.glsl unchanged ----
#include "../../gabor_noise.glsl"
// ---- gabor_erosion.glsl unchanged ----
#include "../../gabor_erosion.glsl"
// ---- your code ----

const uint seed = 5u;
const float water = -0.42;
const vec3 sun = vec3(-0.80, 0.38, -0.46);

// The ground at p, without gullies that are too fine for a pixel of width `pixel`.
GaborTerrain ground(vec2 p, float pixel) {
    GaborErosion erosion = gabor_erosion();
    erosion.octaves = 7;
    erosion.detail = 3.0;
    GaborTerrainPlace here = GaborTerrainPlace(ivec2(0), p, vec2(0.0));
    return gabor_eroded_at(here, vec2(pixel, 0.0), vec2(0.0, pixel), gabor_terrain(p, seed), erosion, seed);
}

// A lower bound on a point's height above the ground. Erosion adds at most 0.16 to the hills, which are cheap to compute.
float clearance(vec3 at, float pixel) {
    float above = at.y - gabor_terrain(at.xz, seed).height;
    return above > 0.24 ? above - 0.16 : at.y - ground(at.xz, pixel).height;
}

// The distance at which the ray meets the ground, or -1. Steps grow with the height above the ground and the distance.
float march(vec3 eye, vec3 ray, float pixel) {
    float t = 0.02, before = t;
    for (int i = 0; i < 160 && t < 40.0; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.6 && ray.y > 0.0) break;
        float above = clearance(at, pixel * t);
        if (above < 0.0) { // the ground is between the last two steps: bisect
            for (int j = 0; j < 6; ++j) {
                float middle = 0.5 * (before + t);
                vec3 there = eye + middle * ray;
                if (there.y > ground(there.xz, pixel * middle).height) before = middle; else t = middle;
            }
            return t;
        }
        before = t;
        t += max(0.42 * above, pixel * t);
    }
    return -1.0;
}

// The visible share of the sun. The ground that hides it has about two octaves of erosion; shadows have soft edges.
float sunlight(vec3 at) {
    float light = 1.0, t = 0.03;
    for (int i = 0; i < 18 && light > 0.0; ++i) {
        vec3 there = at + t * sun;
        float above = there.y - ground(there.xz, 0.12).height;
        light = min(light, 0.5 + 12.0 * above / t);
        t += clamp(0.7 * above, 0.03, 0.5);
    }
    return smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0));
}

vec3 sky(vec3 ray) {
    float up = max(ray.y, 0.0), toward = max(dot(ray, sun), 0.0);
    vec3 color = mix(vec3(0.50, 0.58, 0.66), vec3(0.08, 0.20, 0.46), 1.0 - exp(-5.0 * up));
    float glow = 0.35 * pow(toward, 8.0) + 0.6 * pow(toward, 200.0) + 4.0 * pow(toward, 3000.0);
    return color + vec3(1.0, 0.68, 0.36) * glow;
}

// The colour of rock, grass, scree or snow, depending on height, slope and ridge.
vec3 colour(vec3 at, vec3 normal, float ridge) {
    vec3 color = mix(vec3(0.24, 0.19, 0.15), vec3(0.34, 0.31, 0.28), smoothstep(-0.2, 0.6, at.y + 0.2 * ridge));
    float grass = smoothstep(0.62, 0.85, normal.y) * smoothstep(0.30, -0.05, at.y + 0.08 * ridge);
    color = mix(color, mix(vec3(0.08, 0.11, 0.045), vec3(0.20, 0.20, 0.085), 0.5 + 0.5 * ridge), grass);
    color = mix(color, vec3(0.36, 0.33, 0.27), 0.5 * smoothstep(-0.3, -0.9, ridge) * (1.0 - grass));
    color = mix(color, vec3(0.46, 0.42, 0.32), smoothstep(water + 0.025, water + 0.005, at.y));
    float snow = smoothstep(0.30, 0.55, at.y - 0.12 * ridge) * smoothstep(0.50, 0.75, normal.y);
    return mix(color, vec3(0.86, 0.89, 0.93), snow);
}

vec3 lit(vec3 at, float pixel) {
    GaborTerrain here = ground(at.xz, pixel);
    vec3 normal = normalize(vec3(-here.slope.x, 1.0, -here.slope.y));
    float open = 0.65 + 0.35 * here.ridge; // creases see less of the sky
    vec3 light = 2.3 * vec3(1.0, 0.80, 0.58) * max(dot(normal, sun), 0.0) * sunlight(at + 0.004 * normal)
               + open * mix(vec3(0.10, 0.08, 0.06), vec3(0.17, 0.25, 0.40), 0.5 + 0.5 * normal.y);
    return colour(at, normal, here.ridge) * light;
}

void mainImage(out vec4 color, vec2 pixel) {
    vec2 screen = (2.0 * pixel - iResolution.xy) / iResolution.y;
    float time = 0.12 * iTime;
    vec2 turn = iMouse.z > 0.0 ? (iMouse.xy / iResolution.xy - 0.5) * vec2(6.2831853, 1.2) : vec2(0.0);
    vec3 eye = vec3(3.0 * sin(0.31 * time) - 0.6, 0.0, 0.8 - 2.0 * time);
    for (int i = -1; i <= 3; ++i) { // keeps the eye above the ground ahead
        float hills = gabor_terrain(eye.xz - vec2(0.0, 0.5 * float(i)), seed).height;
        eye.y = max(eye.y, hills + 0.45);
    }
    float heading = 0.5 * sin(0.23 * time) + turn.x, pitch = -0.16 + turn.y;
    vec3 ahead = vec3(sin(heading) * cos(pitch), sin(pitch), -cos(heading) * cos(pitch));
    vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)));
    vec3 ray = normalize(1.6 * ahead + screen.x * right + screen.y * cross(right, ahead));
    float wide = 1.25 / iResolution.y; // a pixel at distance 1
    float t = march(eye, ray, wide), wet = (water - eye.y) / ray.y;
    vec3 view = sky(ray);
    if (wet > 0.0 && (t < 0.0 || wet < t) && wet < 40.0) {
        vec3 at = eye + wet * ray;
        vec2 waves = 0.004 * exp(-0.3 * wet) * gabor_noise_gradient(30.0 * at.xz + 0.2 * iTime, 1.0, 0.6, seed).yz;
        vec3 normal = normalize(vec3(waves.x, 1.0, waves.y));
        vec3 mirror = reflect(ray, normal);
        mirror.y = abs(mirror.y);
        float back = march(at + vec3(0.0, 0.002, 0.0), mirror, 8.0 * wide);
        vec3 seen = back > 0.0 ? lit(at + back * mirror, 16.0 * wide * back) : sky(mirror);
        float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(normal, -ray), 0.0), 5.0);
        view = mix(vec3(0.03, 0.07, 0.08), seen, clamp(fresnel, 0.0, 1.0));
        t = wet;
    } else if (t > 0.0)
        view = lit(eye + t * ray, wide * t);
    if (t > 0.0) view = mix(sky(normalize(vec3(ray.x, max(ray.y, 0.02), ray.z))), view, exp(-0.0018 * t * t - 0.012 * t));
    view = view * (2.51 * view + 0.03) / (view * (2.43 * view + 0.59) + 0.14); // tone mapping [Narkowicz 2015]
    color = vec4(pow(clamp(view, 0.0, 1.0), vec3(0.4545)), 1.0);
}
