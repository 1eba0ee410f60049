"""Draws a drop-in into a texture of floats with raylib and a GLSL 330 fragment shader:
run.py VALUES.raw DROP_IN [NAME=VALUE]. Needs a display; without one, use xvfb-run -a python run.py ..."""

import ctypes
import json
import pathlib
import sys

import raylib
from raylib import ffi, rl

SHADERS = pathlib.Path(__file__).resolve().parents[3] / "shaders"
path, drop_in, *macros = sys.argv[1:]

MACROS = "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros)
FRAGMENT = "#version 330\n" + MACROS + (SHADERS / f"{drop_in}.glsl").read_text() + """
out vec4 value;
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    float noise = gl_FragCoord.y < 256.0 ? gabor_noise(p, 4.0, 0.7854, 7u)
        : gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u);
    value = vec4(vec3(noise), 1.0); // raylib blends by alpha
}
"""

rl.SetTraceLogLevel(rl.LOG_WARNING)
rl.SetConfigFlags(rl.FLAG_WINDOW_HIDDEN)
rl.InitWindow(256, 257, b"Gabor noise")
shader = rl.LoadShaderFromMemory(ffi.NULL, FRAGMENT.encode())  # no vertex shader: NULL, not ""

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
pathlib.Path(path).write_bytes(ffi.buffer(ffi.new("float[]", values)))
get_string = ctypes.CDLL("libGL.so.1").glGetString
get_string.restype = ctypes.c_char_p
driver = get_string(0x1F01).decode()  # GL_RENDERER
rl.CloseWindow()
print(json.dumps({"engine": "raylib", "version": raylib.__version__, "dialect": "GLSL 330",
                  "driver": driver}))
