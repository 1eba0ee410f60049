"""Draws an Open Shading Language shader with Blender's Cycles: run.py SHADER.osl VALUES.raw. Needs a Python that has bpy."""

import pathlib
import sys
import tempfile

import bpy
from cycles_scene import lit_by, math, red_and_green, render, script_node, seen_from_above, vector

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import report  # noqa: E402

shader, values = map(pathlib.Path, sys.argv[1:])
folder = tempfile.TemporaryDirectory(prefix="gabor-")
tree, pixel = seen_from_above()
noise = script_node(tree, shader, folder.name, Scale=1.0, Frequency=4.0, Orientation=0.7854, Seed=7)
output = noise.outputs.get("Noise") or noise.outputs[0]  # MaterialX's shader has one output, and sets its own inputs
if "Vector" in noise.inputs:
    place = vector(tree, "MULTIPLY", vector(tree, "ADD", pixel, (0.5, 0.5, 0.0)), (1 / 32, 1 / 32, 0))
    tree.links.new(place, noise.inputs["Vector"])

# Light cannot be negative, so red carries the noise above 0, and green the noise below.
lit_by(tree, red_and_green(tree, math(tree, "MAXIMUM", output, 0.0),
                           math(tree, "MAXIMUM", math(tree, "MULTIPLY", output, -1.0), 0.0)))
pixels = render(256, 256, 1, folder.name)
report(values, pixels[..., 0] - pixels[..., 1], "Blender, Cycles", bpy.app.version_string, "OSL", "CPU")
