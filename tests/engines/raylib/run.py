"""Draws a drop-in into a texture of floats with raylib and a GLSL 330 fragment shader:
run.py VALUES.raw DROP_IN [NAME=VALUE]. Needs a display; without one, use xvfb-run -a python run.py ..."""

import ctypes
import pathlib
import sys

import raylib
from raylib import ffi, rl

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import FRAGMENT, drop_in, report  # noqa: E402

path, name, *macros = sys.argv[1:]
rl.SetTraceLogLevel(rl.LOG_WARNING)
rl.SetConfigFlags(rl.FLAG_WINDOW_HIDDEN)
rl.InitWindow(256, 257, b"Gabor noise")
fragment = "#version 330\n" + drop_in(name, macros) + FRAGMENT
shader = rl.LoadShaderFromMemory(ffi.NULL, fragment.encode())  # no vertex shader: NULL, not ""

# LoadRenderTexture only creates 8-bit targets, so this code attaches a float texture itself.
target = rl.rlLoadFramebuffer()
texture = rl.rlLoadTexture(ffi.NULL, 256, 257, rl.PIXELFORMAT_UNCOMPRESSED_R32G32B32A32, 1)
rl.rlFramebufferAttach(target, texture, rl.RL_ATTACHMENT_COLOR_CHANNEL0, rl.RL_ATTACHMENT_TEXTURE2D, 0)

rl.BeginTextureMode(ffi.new("RenderTexture *", {
    "id": target, "texture": {"id": texture, "width": 256, "height": 257, "mipmaps": 1}})[0])
rl.BeginShaderMode(shader)
rl.DrawRectangle(0, 0, 256, 257, [255] * 4)
rl.EndShaderMode()
rl.EndTextureMode()

pixels = rl.rlReadTexturePixels(texture, 256, 257, rl.PIXELFORMAT_UNCOMPRESSED_R32G32B32A32)
values = ffi.unpack(ffi.cast("float *", pixels), 4 * 256 * 257)[::4]
get_string = ctypes.CDLL("libGL.so.1").glGetString
get_string.restype = ctypes.c_char_p
driver = get_string(0x1F01).decode()  # GL_RENDERER
rl.CloseWindow()
report(path, ffi.buffer(ffi.new("float[]", values)), "raylib", raylib.__version__, "GLSL 330", driver)
