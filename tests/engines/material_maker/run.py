"""Expands the Material Maker node as Material Maker does, and draws it in a fragment shader: run.py VALUES.raw"""

import json
import pathlib
import re
import sys
import tempfile

import numpy as np

ENGINES = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(ENGINES), str(ENGINES / "moderngl")]
from draw import drawn  # noqa: E402
from scene import packaged, report  # noqa: E402

FRAGMENT = """
out float value;
void main()
{
    vec2 uv = gl_FragCoord.xy / 256.0;
    value = VALUE;
}
"""

with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
    node = json.loads((packaged("material_maker", folder) / "gabor_noise.mmg").read_text())
model = node["shader_model"]
given = node["parameters"] | {"orientation": np.degrees(np.float32(0.7854))}  # the scene's orientation, slightly different from 45 degrees
missing = {parameter["name"] for parameter in model["parameters"]} ^ set(given)
if missing:
    sys.exit(f"parameters not declared, or not passed: {missing}")
output = model["outputs"][0]["f"]
names = {"uv": "uv", "seed": "uintBitsToFloat(7u)"} | {name: f"{float(number):.9f}" for name, number in given.items()}
value = re.sub(r"\$(\w+)", lambda name: names[name[1]], output)
value = value.replace("gabor_unorm", "")  # gabor_unorm would clamp the largest values
if value == output:
    sys.exit("the node's output has no gabor_unorm")

pixels, driver = drawn("#version 330\n", model["global"] + FRAGMENT.replace("VALUE", value), (256, 256))
report(sys.argv[1], pixels, "Material Maker's node", "-", "GLSL 330", driver)
