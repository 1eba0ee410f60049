"""Draws eroded mountains to terrain.jpg, with a grid that gabor_erosion.osl displaces. After tools/package osl, run it with
blender --background --python terrain.py, or in Python with the module bpy."""

import math
import pathlib
import sys

import bpy

sys.path[:0] = map(str, pathlib.Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/*/site-packages"))

import cycles.osl

HERE = pathlib.Path(__file__).resolve().parent

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
bpy.ops.mesh.primitive_grid_add(x_subdivisions=768, y_subdivisions=768, size=8)
bpy.ops.object.shade_smooth()
material = bpy.data.materials.new("mountains")
material.use_nodes = True
material.displacement_method = "DISPLACEMENT"
bpy.context.object.data.materials.append(material)
tree = material.node_tree

mountains = tree.nodes.new("ShaderNodeScript")
mountains.mode, mountains.filepath = "EXTERNAL", str(HERE.parents[2] / "build/packages/staged/osl/gabor_erosion.osl")
cycles.osl.update_script_node(mountains, lambda kinds, message: print(message))
mountains.inputs["Seed"].default_value = 7
# Displacement changes only z of object coordinates, which the shader ignores.
tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["Object"], mountains.inputs["Vector"])
displacement = tree.nodes.new("ShaderNodeDisplacement")
displacement.inputs["Midlevel"].default_value, displacement.inputs["Scale"].default_value = 0, 1
tree.links.new(mountains.outputs["Height"], displacement.inputs["Height"])
tree.links.new(displacement.outputs[0], tree.nodes["Material Output"].inputs["Displacement"])

# Creases are dark and ridges light, with snow at the top.
rock = tree.nodes.new("ShaderNodeMix")
rock.data_type = "RGBA"
rock.inputs[6].default_value, rock.inputs[7].default_value = (0.06, 0.06, 0.03, 1), (0.22, 0.19, 0.16, 1)
crest = tree.nodes.new("ShaderNodeMapRange")
crest.inputs["From Min"].default_value = -1
tree.links.new(mountains.outputs["Ridge"], crest.inputs["Value"])
tree.links.new(crest.outputs[0], rock.inputs["Factor"])
snow = tree.nodes.new("ShaderNodeMix")
snow.data_type = "RGBA"
snow.inputs[7].default_value = (0.9, 0.9, 0.9, 1)
above = tree.nodes.new("ShaderNodeMapRange")
above.inputs["From Min"].default_value, above.inputs["From Max"].default_value = 0.3, 0.5
tree.links.new(mountains.outputs["Height"], above.inputs["Value"])
tree.links.new(above.outputs[0], snow.inputs["Factor"])
tree.links.new(rock.outputs[2], snow.inputs[6])
surface = tree.nodes["Principled BSDF"]
surface.inputs["Roughness"].default_value = 1
tree.links.new(snow.outputs[2], surface.inputs["Base Color"])

scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.25, 0.36, 0.55, 1)
bpy.ops.object.light_add(type="SUN", rotation=(math.radians(65), 0, math.radians(-70)))
bpy.context.object.data.energy, bpy.context.object.data.color = 5, (1, 0.9, 0.75)
bpy.ops.object.camera_add(location=(0, -8.5, 3.0), rotation=(math.radians(73), 0, 0))
scene.camera = bpy.context.object

scene.render.engine = "CYCLES"
scene.cycles.shading_system = True
scene.cycles.samples = 24
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 900, 506, 100
scene.render.image_settings.file_format = "JPEG"
scene.render.filepath = str(HERE / "terrain.jpg")
bpy.ops.render.render(write_still=True)
