"""Material Maker's node, expanded as Material Maker does, in a fragment shader: run.py VALUES.raw"""

import json
import pathlib
import re
import sys

import moderngl
import numpy as np

NODE = pathlib.Path(__file__).resolve().parents[3] / "shaders" / "nodes" / "material_maker" / "gabor_noise.mmg"
VERTEX = """#version 330
in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
"""
FRAGMENT = """
out float value;
void main()
{
    vec2 uv = gl_FragCoord.xy / 256.0;
    value = VALUE;
}
"""

node = json.loads(NODE.read_text())
model = node["shader_model"]
given = node["parameters"] | {"orientation": np.degrees(np.float32(0.7854))}  # the scene's, which is not quite 45 degrees
missing = {parameter["name"] for parameter in model["parameters"]} ^ set(given)
if missing:
    sys.exit(f"not both declared and given: {missing}")
output = model["outputs"][0]["f"]
value = re.sub(r"\$(\w+)", lambda name: "uv" if name[1] == "uv" else f"{float(given[name[1]]):.9f}", output)
value = value.replace("gabor_unorm", "")  # which would cut the largest values
if value == output:
    sys.exit("the node shows no gabor_unorm")

context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
program = context.program(vertex_shader=VERTEX,
                          fragment_shader="#version 330\n" + model["global"] + FRAGMENT.replace("VALUE", value))
target = context.framebuffer([context.texture((256, 256), 1, dtype="f4")])
target.use()
corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
context.vertex_array(program, corners, "corner").render(vertices=3)
pathlib.Path(sys.argv[1]).write_bytes(target.read(components=1, dtype="f4"))
print(json.dumps({"engine": "Material Maker's node", "version": "-", "dialect": "GLSL 330",
                  "driver": context.info["GL_RENDERER"]}))
