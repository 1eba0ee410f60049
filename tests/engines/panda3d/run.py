"""Draws a drop-in in a GLSL 330 fragment shader with Panda3D, without a window: run.py VALUES.raw DROP_IN [NAME=VALUE]"""

import os
import pathlib
import sys

import panda3d
from direct.showbase.ShowBase import ShowBase
from panda3d.core import CardMaker, FrameBufferProperties, GraphicsOutput, GraphicsPipe, NodePath, OrthographicLens
from panda3d.core import Camera, Shader, Texture, WindowProperties, loadPrcFileData

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import FRAGMENT, drop_in, report  # noqa: E402

path, name, *macros = sys.argv[1:]

VERTEX = """#version 330
in vec4 p3d_Vertex;
uniform mat4 p3d_ModelViewProjectionMatrix;
void main() { gl_Position = p3d_ModelViewProjectionMatrix * p3d_Vertex; }
"""

os.environ.setdefault("EGL_PLATFORM", "surfaceless")
loadPrcFileData("", "load-display p3headlessgl\nwindow-type offscreen\ngl-version 3 3\naudio-library-name null\n"
                    "textures-power-2 none\n")
base = ShowBase()
wanted = FrameBufferProperties()
wanted.set_rgba_bits(32, 32, 32, 32)
wanted.set_float_color(True)
target = base.graphicsEngine.make_output(base.pipe, "noise", 0, wanted,
                                         WindowProperties.size(256, 257), GraphicsPipe.BF_refuse_window,
                                         base.win.gsg, base.win)
texture = Texture()
target.add_render_texture(texture, GraphicsOutput.RTM_copy_ram, GraphicsOutput.RTP_color)

card = CardMaker("card")
card.set_frame(-1, 1, -1, 1)
scene = NodePath("scene")
scene.attach_new_node(card.generate()).set_shader(Shader.make(
    Shader.SL_GLSL, VERTEX, "#version 330\n" + drop_in(name, macros) + FRAGMENT))
lens = OrthographicLens()
lens.set_film_size(2, 2)
lens.set_near_far(-1, 1)
target.make_display_region().set_camera(scene.attach_new_node(Camera("camera", lens)))
base.graphicsEngine.render_frame()

# Takes only red from the pixels, which are BGRA. The lowest row comes first, as in gl_FragCoord.
report(path, texture.get_ram_image_as("R"), "Panda3D", panda3d.__version__, "GLSL 330", target.gsg.driver_renderer)
