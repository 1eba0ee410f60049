"""The Open Shading Language in Blender's Cycles: run.py SHADER.osl VALUES.raw, by a Python that has bpy."""

import json
import pathlib
import shutil
import sys
import tempfile

import bpy

# bpy does not look for the packages that it brings along, and the one that reads shaders is among them.
sys.path.insert(0, str(next(pathlib.Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))))

import cycles.osl
import numpy as np

shader, values = sys.argv[1:]


class Said:
    """Takes what Cycles says of a shader."""

    def __call__(self, kinds, message):
        if kinds & {"ERROR"}:
            sys.exit(message)


def script_node(tree, path, **inputs):
    node = tree.nodes.new("ShaderNodeScript")
    node.mode, node.filepath = "EXTERNAL", path
    cycles.osl.update_script_node(node, Said())
    for name, value in inputs.items():
        if name in node.inputs:
            node.inputs[name].default_value = value
    return node


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


# A square of 256 x 256, a pixel to each unit, seen from above.
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
bpy.ops.mesh.primitive_plane_add(size=256, location=(128, 128, 0))
plane = bpy.context.object
bpy.ops.object.camera_add(location=(128, 128, 10))
scene.camera = bpy.context.object
scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 256

material = bpy.data.materials.new("noise")
material.use_nodes = True
plane.data.materials.append(material)
tree = material.node_tree
tree.nodes.clear()
folder = tempfile.TemporaryDirectory(prefix="gabor-")  # Blender puts what it compiles beside the shader
shutil.copytree(pathlib.Path(shader).parent, folder.name, dirs_exist_ok=True)
noise = script_node(tree, f"{folder.name}/{pathlib.Path(shader).name}", Scale=1.0, Frequency=4.0, Orientation=0.7854, Seed=7)
output = noise.outputs.get("Noise") or noise.outputs[0]  # MaterialX's has one, and its inputs in the text
position = tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"]
pixel = math(tree, "ADD", math(tree, "FLOOR", position), (0.5, 0.5, 0.0))  # a sample may be anywhere in its pixel
if "Vector" in noise.inputs:
    tree.links.new(math(tree, "MULTIPLY", pixel, (1 / 32, 1 / 32, 0)), noise.inputs["Vector"])

# Light is not negative: what the noise has above 0 in red, and below in green.
colour = tree.nodes.new("ShaderNodeCombineColor")
tree.links.new(scalar(tree, "MAXIMUM", output, 0.0), colour.inputs[0])
tree.links.new(scalar(tree, "MAXIMUM", scalar(tree, "MULTIPLY", output, -1.0), 0.0), colour.inputs[1])
emission = tree.nodes.new("ShaderNodeEmission")
tree.links.new(colour.outputs[0], emission.inputs["Color"])
tree.links.new(emission.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])

scene.render.engine = "CYCLES"
scene.cycles.shading_system = True
scene.cycles.samples = 1
scene.cycles.use_denoising = False
scene.cycles.pixel_filter_type = "BOX"
scene.cycles.filter_width = 0.01
scene.view_settings.view_transform = "Raw"
scene.render.resolution_x = scene.render.resolution_y = 256
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = f"{folder.name}/values.exr"
bpy.ops.render.render(write_still=True)
image = bpy.data.images.load(scene.render.filepath)
image.colorspace_settings.name = "Non-Color"
pixels = np.array(image.pixels, "<f4").reshape(256, 256, 4)
pathlib.Path(values).write_bytes((pixels[..., 0] - pixels[..., 1]).tobytes())
print(json.dumps({"engine": "Blender, Cycles", "version": bpy.app.version_string, "dialect": "OSL", "driver": "CPU"}))
