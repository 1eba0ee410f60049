"""Draws a sea up to the horizon under a low lamp, one picture below the other: lost.py PICTURE.npy WIDTH HEIGHT

Without what the filter removed of the slopes; with it, by the recipe of docs/materials.md; and the mean of 256 samples a pixel."""

import pathlib
import re
import sys

import numpy as np
from draw import drawn

ROOT = pathlib.Path(__file__).resolve().parents[3]
DROP_INS = [(ROOT / "shaders" / f"gabor_{name}.glsl").read_text() for name in ("noise", "spectrum", "filter", "materials", "ocean")]
RECIPE = re.search(r"(?ms)^```glsl\n(.*?)^```", (ROOT / "docs" / "materials.md").read_text())[1]
FRAGMENT = """
out vec4 result;

vec3 lit(GaborMaterial m, vec3 eye) {
    vec3 lamp = normalize(vec3(0.1, 1.0, 0.4)), h = normalize(eye + lamp), normal = normalize(vec3(-m.slope, 1.0));
    float k = 0.5 * pow(gabor_roughness(m), 2.0), l = max(dot(normal, lamp), 0.0), e = max(dot(normal, eye), 0.001);
    float fresnel = 0.04 + 0.96 * pow(1.0 - dot(eye, h), 5.0);
    return m.colour * (l + 0.15) + 3.0 * l * fresnel * facets(m, h) / (4.0 * mix(l, 1.0, k) * mix(e, 1.0, k));
}

GaborMaterial sea(GaborWater w) {
    return GaborMaterial(vec3(0.01, 0.1, 0.13), w.height, w.slope, 0.1, 0.0, w.lost);
}

// The place on the plane that a camera 12 m above it sees, and the direction to the camera.
vec2 seen(vec2 pixel, out vec3 eye) {
    eye = -normalize(vec3((2.0 * pixel - size) / size.y + vec2(0.0, -0.9), 2.2).xzy);
    return -12.0 * eye.xy / eye.z;
}

void main() {
    vec3 eye, beside;
    vec2 p = seen(gl_FragCoord.xy, eye);
    if (eye.z < 0.005) {
        result = vec4(0.5, 0.6, 0.75, 1.0);
        return;
    }
    GaborOcean ocean = gabor_ocean_of(GaborSea(7.0, 2.0e4, 0.0, 12.0, 0.0, 0.0, 0.8, 0));
    GaborMaterial m = sea(gabor_water_filtered(p, seen(gl_FragCoord.xy + vec2(1.0, 0.0), beside) - p,
                                               seen(gl_FragCoord.xy + vec2(0.0, 1.0), beside) - p, 0.0, ocean, 7u));
    if (!with_lost)
        m.lost = vec3(0.0);
    vec3 colour = samples == 0 ? lit(m, eye) : vec3(0.0);
    for (int i = 0; i < samples * samples; ++i) {
        p = seen(gl_FragCoord.xy + (vec2(i / samples, i % samples) + 0.5) / float(samples) - 0.5, eye);
        colour += lit(sea(gabor_water_filtered(p, vec2(0.0), vec2(0.0), 0.0, ocean, 7u)), eye) / float(samples * samples);
    }
    result = vec4(pow(colour, vec3(1.0 / 2.2)), 1.0);
}
"""

path, width, height = sys.argv[1], *map(int, sys.argv[2:])
pictures = []
for with_lost, samples in (("false", 0), ("true", 0), ("false", 16)):
    head = (f"#version 330\nconst vec2 size = vec2({width}, {height});\nconst bool with_lost = {with_lost};\n"
            f"const int samples = {samples};\n")
    pixels, _ = drawn(head, "".join(DROP_INS) + RECIPE + FRAGMENT, (width, height), 3)
    pictures.append(np.frombuffer(pixels, "f4").reshape(height, width, 3)[::-1])
np.save(path, np.vstack(pictures))
