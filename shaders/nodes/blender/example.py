"""Draws brushed metal, stripes and sand to example.png, with gabor_noise.osl in a Script node. Run it with
blender --background --python example.py, or in Python with the module bpy."""

import math
import pathlib
import sys

import bpy

sys.path[:0] = map(str, pathlib.Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))

import cycles.osl

HERE = pathlib.Path(__file__).resolve().parent
SHADER = HERE.parent / "osl" / "gabor_noise.osl"


def noise(tree, coordinates, **inputs):
    """Adds a Script node with the noise at texture coordinates."""
    node = tree.nodes.new("ShaderNodeScript")
    node.mode, node.filepath = "EXTERNAL", str(SHADER)
    cycles.osl.update_script_node(node, lambda kinds, message: print(message))
    for name, value in inputs.items():
        node.inputs[name].default_value = value
    tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs[coordinates], node.inputs["Vector"])
    return node


def material(name, colours, output, strength, metallic, **inputs):
    """Makes a material whose colour and height follow an output of the noise."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    surface = tree.nodes["Principled BSDF"]
    surface.inputs["Metallic"].default_value, surface.inputs["Roughness"].default_value = metallic, 0.35
    source = noise(tree, "UV", **inputs).outputs[output]
    mix = tree.nodes.new("ShaderNodeMix")
    mix.data_type = "RGBA"
    tree.links.new(source, mix.inputs["Factor"])
    mix.inputs[6].default_value, mix.inputs[7].default_value = colours
    tree.links.new(mix.outputs[2], surface.inputs["Base Color"])
    bump = tree.nodes.new("ShaderNodeBump")
    bump.inputs["Strength"].default_value, bump.inputs["Distance"].default_value = strength, 0.02
    tree.links.new(source, bump.inputs["Height"])
    tree.links.new(bump.outputs["Normal"], surface.inputs["Normal"])
    return made


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.world = bpy.data.worlds.new("sky")
scene.world.color = (0.6, 0.7, 0.8)

bpy.ops.mesh.primitive_plane_add(size=12)
bpy.context.object.data.materials.append(material(
    "sand", ((0.35, 0.2, 0.1, 1), (0.8, 0.6, 0.4, 1)), "Value", 0.6, 0.0, Scale=24.0, Frequency=1.0, Orientation=1.2))
bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=1.2, location=(-1.4, 0, 1.2))
bpy.ops.object.shade_smooth()
bpy.context.object.data.materials.append(material(
    "metal", ((0.3, 0.3, 0.35, 1), (0.9, 0.85, 0.8, 1)), "Value", 0.3, 1.0, Scale=24.0, Frequency=3.0, Orientation=1.5708))
bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=1.2, location=(1.4, 0, 1.2))
bpy.ops.object.shade_smooth()
bpy.context.object.data.materials.append(material(
    "stripes", ((0.05, 0.1, 0.3, 1), (0.9, 0.8, 0.6, 1)), "Phase", 0.2, 0.0, Scale=12.0, Frequency=1.5, Orientation=0.7))

bpy.ops.object.light_add(type="SUN", rotation=(0.7, 0.3, 0.4))
bpy.context.object.data.energy = 3
bpy.ops.object.camera_add(location=(0, -9.5, 3.6), rotation=(math.radians(75), 0, 0))
scene.camera = bpy.context.object

scene.render.engine = "CYCLES"
scene.cycles.shading_system = True
scene.cycles.samples = 24
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 600, 340, 100
scene.render.filepath = str(HERE / "example.png")
bpy.ops.render.render(write_still=True)
