"""Renders a plane with a Script node of the Open Shading Language in Blender's Cycles. Needs a Python that has bpy."""

import pathlib
import shutil
import sys

import bpy
import numpy as np

# bpy does not look in its own bundled packages, which include the one that reads shaders.
sys.path.insert(0, str(next(pathlib.Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))))

import cycles.osl  # noqa: E402


class Said:
    """Collects Cycles' messages about a shader."""

    def __call__(self, kinds, message):
        if kinds & {"ERROR"}:
            sys.exit(message)


def script_node(tree, shader, folder, **inputs):
    """Makes a Script node and sets the inputs that the shader has. The folder is for the compiled shader, which Blender
    writes beside its source."""
    shutil.copytree(shader.parent, folder, dirs_exist_ok=True)
    node = tree.nodes.new("ShaderNodeScript")
    node.mode, node.filepath = "EXTERNAL", f"{folder}/{shader.name}"
    cycles.osl.update_script_node(node, Said())
    for name, value in inputs.items():
        if name in node.inputs:
            node.inputs[name].default_value = value
    return node


def math(tree, operation, *inputs, kind="ShaderNodeMath"):
    """Makes a math node and returns its output. The inputs are values or other nodes' outputs."""
    node = tree.nodes.new(kind)
    node.operation = operation
    for value, put in zip(inputs, node.inputs):
        if isinstance(value, bpy.types.NodeSocket):
            tree.links.new(value, put)
        else:
            put.default_value = value
    return node.outputs[0]


def vector(tree, operation, *inputs):
    return math(tree, operation, *inputs, kind="ShaderNodeVectorMath")


def red_and_green(tree, *values):
    colour = tree.nodes.new("ShaderNodeCombineColor")
    for value, put in zip(values, colour.inputs):
        tree.links.new(value, put)
    return colour.outputs[0]


def lit_by(tree, colour):
    """Makes the surface emit this colour, without tone mapping."""
    emission = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(colour, emission.inputs["Color"])
    tree.links.new(emission.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])


def plane(size, location):
    """Makes a horizontal square; returns its material's empty node tree."""
    bpy.ops.mesh.primitive_plane_add(size=size, location=location)
    material = bpy.data.materials.new("material")
    material.use_nodes = True
    bpy.context.object.data.materials.append(material)
    material.node_tree.nodes.clear()
    return material.node_tree


def seen_from_above():
    """Makes a square of 256 x 256 units seen from above, one pixel per unit. Returns its material's node tree, and the column and
    row of the pixel, since samples may be anywhere in it."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    tree = plane(256, (128, 128, 0))
    bpy.ops.object.camera_add(location=(128, 128, 10))
    scene = bpy.context.scene
    scene.camera = bpy.context.object
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 256
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    return tree, vector(tree, "FLOOR", tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"])


def render(width, height, samples, folder, engine="CYCLES", osl=True):
    """Returns red, green, blue and alpha, with the lowest row first."""
    scene = bpy.context.scene
    scene.render.engine = engine
    scene.cycles.shading_system = osl
    scene.eevee.taa_render_samples = samples
    scene.render.filter_size = 0.01
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.view_settings.view_transform = "Raw"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = f"{folder}/values.exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    image.colorspace_settings.name = "Non-Color"
    return np.array(image.pixels, "<f4").reshape(height, width, 4)
