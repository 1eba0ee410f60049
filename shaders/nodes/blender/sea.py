"""Draws a sea that gabor_ocean.osl moves, with a floating box, to sea.jpg; frames move both. After tools/package osl, run it with
blender --background --python sea.py, or with python -P sea.py and the module bpy. Install the Python module gabor_noise into
Blender's Python first, for the box. -P avoids the folder gabor_noise here, which is Blender's extension."""

import math
import pathlib
import sys

import bpy

sys.path[:0] = map(str, pathlib.Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))

import cycles.osl
import gabor_noise

HERE = pathlib.Path(__file__).resolve().parent
SIDE, WIND, SEED, RATE = 200.0, 15.0, 7, 24  # metres, metres per second, frames per second

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material(name, **inputs):
    """Gives the active object a material, and returns its nodes."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    for key, value in inputs.items():
        made.node_tree.nodes["Principled BSDF"].inputs[key.replace("_", " ")].default_value = value
    made.displacement_method = "DISPLACEMENT"
    bpy.context.object.data.materials.append(made)
    return made.node_tree


bpy.ops.mesh.primitive_grid_add(x_subdivisions=1000, y_subdivisions=1000, size=SIDE)
bpy.ops.object.shade_smooth()
tree = material("water", Roughness=0.43, IOR=1.333)  # as rough as waves shorter than those of the shader make it

water = tree.nodes.new("ShaderNodeScript")
water.mode, water.filepath = "EXTERNAL", str(HERE.parents[2] / "build/packages/staged/osl/gabor_ocean.osl")
cycles.osl.update_script_node(water, lambda kinds, message: print(message))
water.inputs["Wind"].default_value, water.inputs["Seed"].default_value = WIND, SEED
water.inputs["Seconds"].driver_add("default_value").driver.expression = f"frame / {RATE}"
# Displacement changes object coordinates, but not those of the texture.
place = tree.nodes.new("ShaderNodeMapping")
place.inputs["Location"].default_value, place.inputs["Scale"].default_value = 3 * [-SIDE / 2], 3 * [SIDE]
tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["UV"], place.inputs["Vector"])
tree.links.new(place.outputs[0], water.inputs["Vector"])
displacement = tree.nodes.new("ShaderNodeVectorDisplacement")
displacement.space = "OBJECT"
displacement.inputs["Midlevel"].default_value, displacement.inputs["Scale"].default_value = 0, 1
tree.links.new(water.outputs["Displacement"], displacement.inputs["Vector"])
tree.links.new(displacement.outputs[0], tree.nodes["Material Output"].inputs["Displacement"])

foam = tree.nodes.new("ShaderNodeMapRange")
foam.inputs["From Min"].default_value, foam.inputs["From Max"].default_value = 0.75, 0.5
tree.links.new(water.outputs["Jacobian"], foam.inputs["Value"])
colour = tree.nodes.new("ShaderNodeMix")
colour.data_type = "RGBA"
colour.inputs[6].default_value, colour.inputs[7].default_value = (0.01, 0.06, 0.07, 1), (0.8, 0.8, 0.8, 1)
tree.links.new(foam.outputs[0], colour.inputs["Factor"])
tree.links.new(colour.outputs[2], tree.nodes["Principled BSDF"].inputs["Base Color"])

bpy.ops.mesh.primitive_cube_add(size=3)
material("box", Base_Color=(0.6, 0.12, 0.03, 1), Roughness=0.6)
box = bpy.context.object
box.rotation_mode = "ZXY"  # it heads, then tilts


def float_box(scene, _=None):
    """Moves the box to where it floats in the scene's frame."""
    a, b, c, d = gabor_noise.water_height([-1.5, 1.5, -1.5, 1.5], [-1.5, -1.5, 1.5, 1.5], wind=WIND, seed=SEED,
                                          seconds=scene.frame_current / RATE)
    box.location = 0, 0, (a + b + c + d) / 4 + 0.5
    box.rotation_euler = math.atan((c + d - a - b) / 6), math.atan((a + c - b - d) / 6), 0.6


bpy.app.handlers.frame_change_pre.append(float_box)
scene.frame_set(144)

scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.35, 0.48, 0.65, 1)
bpy.ops.object.light_add(type="SUN", rotation=(math.radians(60), 0, math.radians(120)))
bpy.context.object.data.energy, bpy.context.object.data.color = 5, (1, 0.85, 0.65)
bpy.ops.object.camera_add(location=(5, -27, 7), rotation=(math.radians(79), 0, math.radians(8)))
scene.camera = bpy.context.object

scene.render.engine = "CYCLES"
scene.cycles.shading_system = True
scene.cycles.samples = 24
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 900, 506, 100
scene.render.image_settings.file_format = "JPEG"
scene.render.filepath = str(HERE / "sea.jpg")
bpy.ops.render.render(write_still=True)
