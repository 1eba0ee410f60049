"""A folder that `gabor render --maps` wrote, in the room and under the lamp of the viewer's lit view
(shaders/passes/light.glsl), in Blender's Cycles: material.py FOLDER VALUES.raw AZIMUTH/ELEVATION..."""

import json
import math
import pathlib
import sys
import tempfile

import bpy
import numpy as np
from cycles_scene import plane, render

folder, values = map(pathlib.Path, sys.argv[1:3])
lights = [tuple(map(float, light.split("/"))) for light in sys.argv[3:]]
SAMPLES = 64


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def room(tree, height):
    """The environment texture that Cycles expects, rows from the lowest up. The picture's up is +y, and the eye is at +z."""
    up = np.pi * ((np.arange(height) + 0.5) / height - 0.5)[:, None]
    around = np.pi * (np.arange(2 * height) + 0.5)[None] / height
    x, down = -np.cos(up) * np.cos(around), -np.cos(up) * np.sin(around)
    window = smoothstep(-0.3, 0.3, 0.35 - abs(x + 0.12 - 0.2 * down)) * smoothstep(-0.3, 0.3, 0.4 - down)
    image = bpy.data.images.new("room", 2 * height, height, alpha=False, float_buffer=True, is_data=True)
    image.pixels = np.dstack([*(np.array([0.13, 0.14, 0.16]) + np.multiply.outer(window, [0.8, 0.85, 0.95])).transpose(2, 0, 1),
                              np.ones_like(window)]).ravel()
    node = tree.nodes.new("ShaderNodeTexEnvironment")
    node.image = image
    return node


def texture(tree, name, linear=True):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(str(folder.resolve() / f"{name}.png"))
    node.image.colorspace_settings.name = "Non-Color" if linear else "sRGB"
    node.interpolation = "Closest"
    return node


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
tree = plane(1, (0, 0, 0))
colour = texture(tree, "base_color", linear=False)
width, height = colour.image.size
bpy.context.object.scale = (width / max(width, height), height / max(width, height), 1)
surface = tree.nodes.new("ShaderNodeBsdfPrincipled")
normal = tree.nodes.new("ShaderNodeNormalMap")
tree.links.new(colour.outputs[0], surface.inputs["Base Color"])
tree.links.new(texture(tree, "roughness").outputs[0], surface.inputs["Roughness"])
tree.links.new(texture(tree, "metalness").outputs[0], surface.inputs["Metallic"])
tree.links.new(texture(tree, "normal").outputs[0], normal.inputs["Color"])
tree.links.new(normal.outputs[0], surface.inputs["Normal"])
tree.links.new(surface.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])

world = scene.world = bpy.data.worlds.new("room")
world.use_nodes = True
world.node_tree.links.new(room(world.node_tree, 256).outputs[0], world.node_tree.nodes["Background"].inputs["Color"])

bpy.ops.object.camera_add(location=(0, 0, 1.8))
scene.camera = bpy.context.object
scene.camera.data.angle = 2 * math.atan(0.5 / 1.8)  # of the longer side

bpy.ops.object.light_add(type="POINT")
lamp = bpy.context.object
lamp.data.shadow_soft_size = 0
lamp.data.color = 1, 0.96, 0.9
lamp.data.energy = 4 * math.pi * 0.7 * math.pi  # W: its intensity, W/sr, is this / (4 pi) without falloff
lamp.data.use_nodes = True
falloff = lamp.data.node_tree.nodes.new("ShaderNodeLightFalloff")
falloff.inputs["Strength"].default_value = 1
emission = lamp.data.node_tree.nodes["Emission"]
lamp.data.node_tree.links.new(falloff.outputs["Constant"], emission.inputs["Strength"])

scene.cycles.pixel_filter_type = "BOX"
pictures = []
with tempfile.TemporaryDirectory(prefix="gabor-") as scratch:
    for azimuth, elevation in lights:
        a, e = math.radians(azimuth), math.radians(elevation)
        lamp.location = 2.5 * math.cos(e) * math.cos(a), -2.5 * math.cos(e) * math.sin(a), 2.5 * math.sin(e)
        pictures.append(render(width, height, SAMPLES, scratch, osl=False)[::-1])
values.write_bytes(np.array(pictures, "<f4").tobytes())
print(json.dumps({"engine": "Blender, Cycles", "version": bpy.app.version_string}))
