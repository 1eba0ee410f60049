"""Draws an Open Shading Language shader with Blender's Cycles: run.py SHADER.osl VALUES.raw. Needs a Python that has bpy."""

import json
import pathlib
import sys
import tempfile

import bpy
from cycles_scene import lit_by, plane, render, script_node

shader, values = map(pathlib.Path, sys.argv[1:])


def math(tree, operation, vector, with_=None):
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = operation
    tree.links.new(vector, node.inputs[0])
    if with_ is not None:
        node.inputs[1].default_value = with_
    return node.outputs[0]


def scalar(tree, operation, a, b):
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = operation
    for value, put in zip((a, b), node.inputs):
        if isinstance(value, float):
            put.default_value = value
        else:
            tree.links.new(value, put)
    return node.outputs[0]


# A square of 256 x 256 units seen from above, one pixel per unit.
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
tree = plane(256, (128, 128, 0))
bpy.ops.object.camera_add(location=(128, 128, 10))
scene.camera = bpy.context.object
scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 256

folder = tempfile.TemporaryDirectory(prefix="gabor-")
noise = script_node(tree, shader, folder.name, Scale=1.0, Frequency=4.0, Orientation=0.7854, Seed=7)
output = noise.outputs.get("Noise") or noise.outputs[0]  # MaterialX's shader has one output, and sets its own inputs
position = tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"]
pixel = math(tree, "ADD", math(tree, "FLOOR", position), (0.5, 0.5, 0.0))  # samples may be anywhere in a pixel
if "Vector" in noise.inputs:
    tree.links.new(math(tree, "MULTIPLY", pixel, (1 / 32, 1 / 32, 0)), noise.inputs["Vector"])

# Light cannot be negative, so red carries the noise above 0, and green the noise below.
colour = tree.nodes.new("ShaderNodeCombineColor")
tree.links.new(scalar(tree, "MAXIMUM", output, 0.0), colour.inputs[0])
tree.links.new(scalar(tree, "MAXIMUM", scalar(tree, "MULTIPLY", output, -1.0), 0.0), colour.inputs[1])
lit_by(tree, colour.outputs[0])

scene.cycles.pixel_filter_type = "BOX"
scene.cycles.filter_width = 0.01
pixels = render(256, 256, 1, folder.name)
values.write_bytes((pixels[..., 0] - pixels[..., 1]).tobytes())
print(json.dumps({"engine": "Blender, Cycles", "version": bpy.app.version_string, "dialect": "OSL", "driver": "CPU"}))
