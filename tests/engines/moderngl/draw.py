"""Draws a fragment shader with moderngl, without a window, into a texture of floats."""

import moderngl
import numpy as np

VERTEX = """
in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
"""


def drawn(head, fragment, size, components=1):
    """Returns the floats that the shader writes, row by row, and the driver's name; `head` comes before both stages."""
    context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
    program = context.program(vertex_shader=head + VERTEX, fragment_shader=head + fragment)
    corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
    target = context.framebuffer([context.texture(size, components, dtype="f4")])
    target.use()
    context.vertex_array(program, corners, "corner").render(vertices=3)
    return target.read(components=components, dtype="f4"), context.info["GL_RENDERER"]
