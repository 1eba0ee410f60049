"""Draws planes to the horizon in Blender's Cycles, each with a mip-mapped texture: texture.py PICTURE.npy TEXTURE.exr...
Needs a Python that has bpy. First, OpenImageIO's maketx adds mip levels, averages of 2 x 2, to each texture that has none."""

import math
import pathlib
import sys
import tempfile

import bpy
import numpy as np
from cycles_scene import lit_by, plane, render, script_node

import OpenImageIO as oiio  # cycles_scene finds it inside bpy

picture, *textures = map(pathlib.Path, sys.argv[1:])
SIDE, TILE = 512, 4.0  # the picture's side in pixels, and the texture's in camera heights


def with_levels(texture, folder):
    """Returns the texture itself if it has levels, otherwise the file that maketx makes from it."""
    if oiio.ImageInput.open(str(texture)).seek_subimage(0, 1):
        return texture
    options = oiio.ImageSpec()
    options.attribute("maketx:filtername", "box")
    options.attribute("wrapmodes", "periodic,periodic")
    made = pathlib.Path(folder) / "maketx.exr"
    if not oiio.ImageBufAlgo.make_texture(oiio.MakeTxTexture, str(texture), str(made), options):
        sys.exit(oiio.geterror())
    return made


def drawn(texture):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    tree = plane(4000, (0, 0, 0))
    bpy.ops.object.camera_add(location=(0, 0, 1), rotation=(math.radians(73), 0, 0))
    bpy.context.scene.camera = bpy.context.object
    with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
        shader = pathlib.Path(__file__).with_name("texture.osl")
        node = script_node(tree, shader, folder, File=str(with_levels(texture, folder)), Tile=TILE)
        lit_by(tree, node.outputs["Value"])
        return render(SIDE, SIDE, 32, folder)[::-1, :, 0]


np.save(picture, [drawn(texture) for texture in textures])
