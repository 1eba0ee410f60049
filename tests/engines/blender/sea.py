"""Draws a sea with a floating box to sea.jpg, with heights from the Python module gabor_noise; frames move both. Run it with
blender --background --python sea.py, or in Python with the module bpy. Install gabor_noise into Blender's Python first."""

import math
import pathlib

import bpy
import gabor_noise
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
SIDE, VERTICES, WIND, SEED = 120.0, 1000, 9.0, 7  # metres, vertices along each side, metres per second

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
bpy.ops.mesh.primitive_grid_add(x_subdivisions=VERTICES - 1, y_subdivisions=VERTICES - 1, size=SIDE)
bpy.ops.object.shade_smooth()
sea = bpy.context.object
rest = np.empty(3 * len(sea.data.vertices), "f4")
sea.data.vertices.foreach_get("co", rest)
x, y = rest[::3], rest[1::3]
bpy.ops.mesh.primitive_cube_add(size=3)
box = bpy.context.object


def move(scene, _=None):
    """Moves the sea and the box to where they are in the scene's frame."""
    seconds = scene.frame_current / scene.render.fps
    water = gabor_noise.water(x, y, seconds=seconds, wind=WIND, pixel=SIDE / VERTICES, seed=SEED)
    sea.data.vertices.foreach_set("co", np.column_stack([x + water["shift"][:, 0], y + water["shift"][:, 1], water["height"]]).ravel())
    sea.data.update()
    a, b, c, d = gabor_noise.water_height([-1.5, 1.5, -1.5, 1.5], [-1.5, -1.5, 1.5, 1.5], seconds=seconds, wind=WIND, seed=SEED)
    box.location = 0, 0, (a + b + c + d) / 4 + 0.5
    box.rotation_euler = math.atan((c + d - a - b) / 6), math.atan((a + c - b - d) / 6), 0.6


bpy.app.handlers.frame_change_pre.append(move)
scene.frame_set(60)


def material(name, object_, **inputs):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    for key, value in inputs.items():
        made.node_tree.nodes["Principled BSDF"].inputs[key.replace("_", " ")].default_value = value
    object_.data.materials.append(made)


# The waves that are too short for the vertices make the water rough: gabor_noise.water's `lost`.
lost = float(gabor_noise.water(0.0, 0.0, wind=WIND, pixel=SIDE / VERTICES, seed=SEED)["lost"][..., :2].sum())
material("water", sea, Base_Color=(0.01, 0.06, 0.07, 1), Roughness=(0.61 * lost) ** 0.25, IOR=1.333)
material("box", box, Base_Color=(0.6, 0.12, 0.03, 1), Roughness=0.6)

scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.35, 0.48, 0.65, 1)
bpy.ops.object.light_add(type="SUN", rotation=(math.radians(72), 0, math.radians(150)))
bpy.context.object.data.energy, bpy.context.object.data.color = 4, (1, 0.85, 0.65)
bpy.ops.object.camera_add(location=(4, -22, 5), rotation=(math.radians(80), 0, math.radians(8)))
scene.camera = bpy.context.object

scene.render.engine = "CYCLES"
scene.cycles.samples = 48
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 900, 506, 100
scene.render.image_settings.file_format = "JPEG"
scene.render.filepath = str(HERE / "sea.jpg")
bpy.ops.render.render(write_still=True)
