"""Displaces a grid by a set of maps with Blender's modifier, as material.json says: displaced.py FOLDER HEIGHTS.npy, in metres, from the
top. Needs a Python that has bpy."""

import json
import pathlib
import sys

import bpy
import numpy as np

folder = pathlib.Path(sys.argv[1])
facts = json.loads((folder / "material.json").read_text())
height, (columns, rows) = facts["height"], facts["pixels"]
bpy.ops.wm.read_factory_settings(use_empty=True)
places = [((x + 0.5) / columns, (y + 0.5) / rows, 0) for y in range(rows) for x in range(columns)]
corners = [y * columns + x for y in range(rows - 1) for x in range(columns - 1)]
mesh = bpy.data.meshes.new("grid")
mesh.from_pydata(places, [], [(at, at + 1, at + columns + 1, at + columns) for at in corners])
layer = mesh.uv_layers.new()
for loop in mesh.loops:
    layer.data[loop.index].uv = places[loop.vertex_index][:2]
grid = bpy.data.objects.new("grid", mesh)
bpy.context.scene.collection.objects.link(grid)
texture = bpy.data.textures.new("height", "IMAGE")
texture.image = bpy.data.images.load(str(folder / height["file"]))
texture.image.colorspace_settings.name = height["color_space"]
texture.use_interpolation = False
texture.filter_size = 0.1
modifier = grid.modifiers.new("displaced", "DISPLACE")
modifier.texture, modifier.texture_coords, modifier.direction = texture, "UV", "Z"
modifier.strength, modifier.mid_level = height["strength"], height["midlevel"]
vertices = grid.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
np.save(sys.argv[2], np.array([vertex.co.z for vertex in vertices]).reshape(rows, columns)[::-1])
