"""Draws with OpenGL ES alone, without a window. Draws a drop-in in a GLSL 300 es fragment shader, after a given header:
run.py HEADER VALUES.raw DROP_IN [NAME=VALUE]
or a custom shader, to which it adds the version and the header: run.py HEADER VALUES.raw SHADER.frag"""

import ctypes
import pathlib
import sys
from ctypes import byref, c_char_p, c_int, c_uint, c_void_p

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import FRAGMENT, drop_in, report  # noqa: E402

header, path, name, *macros = sys.argv[1:]

VERTEX = """#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
"""
scene = pathlib.Path(name).read_text() if name.endswith(".frag") else drop_in(name, macros) + FRAGMENT
fragment = f"#version 300 es\n{header}\n{scene}"

egl = ctypes.CDLL("libEGL.so.1")
egl.eglGetProcAddress.restype = c_void_p


def function(name, result, *types):
    """Returns a function of EGL or OpenGL ES."""
    return ctypes.CFUNCTYPE(result, *types)(egl.eglGetProcAddress(name.encode()))


def make_context():
    """Makes an OpenGL ES 3 context current, without a surface."""
    display = function("eglGetPlatformDisplay", c_void_p, c_uint, c_void_p, c_void_p)(0x31DD, None, None)  # surfaceless
    function("eglInitialize", c_uint, c_void_p, c_void_p, c_void_p)(display, None, None)
    function("eglBindAPI", c_uint, c_uint)(0x30A0)  # OpenGL ES
    config, count = c_void_p(), c_int()
    function("eglChooseConfig", c_uint, c_void_p, c_void_p, c_void_p, c_int, c_void_p)(
        display, (c_int * 3)(0x3040, 0x40, 0x3038), byref(config), 1, byref(count))  # renderable: OpenGL ES 3
    context = function("eglCreateContext", c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)(
        display, config, None, (c_int * 3)(0x3098, 3, 0x3038))  # version 3
    if not function("eglMakeCurrent", c_uint, c_void_p, c_void_p, c_void_p, c_void_p)(display, None, None, context):
        sys.exit("no OpenGL ES 3 without a surface")


def make_program():
    program = function("glCreateProgram", c_uint)()
    log = ctypes.create_string_buffer(4096)
    for kind, source in ((0x8B31, VERTEX), (0x8B30, fragment)):
        shader = function("glCreateShader", c_uint, c_uint)(kind)
        function("glShaderSource", None, c_uint, c_int, c_void_p, c_void_p)(
            shader, 1, (c_char_p * 1)(source.encode()), None)
        function("glCompileShader", None, c_uint)(shader)
        function("glGetShaderInfoLog", None, c_uint, c_int, c_void_p, c_void_p)(shader, 4096, None, log)
        if log.value:
            sys.exit(log.value.decode())
        function("glAttachShader", None, c_uint, c_uint)(program, shader)
    function("glLinkProgram", None, c_uint)(program)
    function("glUseProgram", None, c_uint)(program)


def draw():
    """Draws into four channels, since OpenGL ES can only read floats as RGBA, and returns the red one."""
    names = (c_uint * 2)()
    function("glGenTextures", None, c_int, c_void_p)(1, byref(names, 0))
    function("glBindTexture", None, c_uint, c_uint)(0x0DE1, names[0])
    function("glTexStorage2D", None, c_uint, c_int, c_uint, c_int, c_int)(0x0DE1, 1, 0x8814, 256, 257)  # RGBA32F
    function("glGenFramebuffers", None, c_int, c_void_p)(1, byref(names, 4))
    function("glBindFramebuffer", None, c_uint, c_uint)(0x8D40, names[1])
    function("glFramebufferTexture2D", None, c_uint, c_uint, c_uint, c_uint, c_int)(0x8D40, 0x8CE0, 0x0DE1, names[0], 0)
    function("glViewport", None, c_int, c_int, c_int, c_int)(0, 0, 256, 257)
    function("glDrawArrays", None, c_uint, c_int, c_int)(4, 0, 3)  # triangles
    pixels = (ctypes.c_float * (4 * 256 * 257))()
    function("glReadPixels", None, c_int, c_int, c_int, c_int, c_uint, c_uint, c_void_p)(
        0, 0, 256, 257, 0x1908, 0x1406, pixels)
    if error := function("glGetError", c_uint)():
        sys.exit(f"OpenGL ES error {error:#x}")
    return pixels[::4]


make_context()
make_program()
text = function("glGetString", c_char_p, c_uint)
report(path, (ctypes.c_float * (256 * 257))(*draw()), "OpenGL ES", text(0x1F02).decode().removeprefix("OpenGL ES "),
       f"GLSL 300 es, {header}", text(0x1F01).decode())
