"""Draws a drop-in in a fragment shader with moderngl: run.py "330 core"|"300 es" VALUES.raw DROP_IN [NAME=VALUE]"""

import json
import pathlib
import sys

import moderngl
from draw import drawn

SHADERS = pathlib.Path(__file__).resolve().parents[3] / "shaders"

FRAGMENT = """
out float value;
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    value = gl_FragCoord.y < 256.0 ? gabor_noise(p, 4.0, 0.7854, 7u)
          : gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u);
}
"""

version, values, drop_in, *macros = sys.argv[1:]
noise = "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros)
noise += (SHADERS / f"{drop_in}.glsl").read_text()
head = f"#version {version}\n" + "precision highp float;\n" * version.endswith("es")

pixels, driver = drawn(head, noise + FRAGMENT, (256, 257))
pathlib.Path(values).write_bytes(pixels)
print(json.dumps({"engine": "moderngl", "version": moderngl.__version__, "dialect": f"GLSL {version}", "driver": driver}))
