"""moderngl: a drop-in in a fragment shader: run.py "330 core"|"300 es" VALUES.raw DROP_IN [NAME=VALUE]"""

import json
import pathlib
import sys

import moderngl
import numpy as np

SHADERS = pathlib.Path(__file__).resolve().parents[3] / "shaders"

VERTEX = """
in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
"""
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
head = f"#version {version}\n" + "precision highp float;\n" * version.endswith("es")
noise = "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros)
noise += (SHADERS / f"{drop_in}.glsl").read_text()

context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
program = context.program(vertex_shader=head + VERTEX, fragment_shader=head + noise + FRAGMENT)
corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
target = context.framebuffer([context.texture((256, 257), 1, dtype="f4")])
target.use()
context.vertex_array(program, corners, "corner").render(vertices=3)

pathlib.Path(values).write_bytes(target.read(components=1, dtype="f4"))
print(json.dumps({"engine": "moderngl", "version": moderngl.__version__, "dialect": f"GLSL {version}",
                  "driver": context.info["GL_RENDERER"]}))
