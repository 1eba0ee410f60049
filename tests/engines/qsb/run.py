"""Draws a drop-in with Qt Quick's ShaderEffect, whose shader qsb has translated: run.py VALUES.raw DROP_IN [NAME=VALUE]. Needs a
display; without one, use xvfb-run -a python3 run.py ..."""

import ctypes
import os
import pathlib
import subprocess
import sys

import numpy as np

os.environ |= {"QSG_RHI_BACKEND": "opengl", "QT_SCALE_FACTOR": "1"}
from PyQt6.QtCore import QT_VERSION_STR, QUrl  # noqa: E402
from PyQt6.QtGui import QGuiApplication, QImage, QOpenGLContext  # noqa: E402
from PyQt6.QtQuick import QQuickView  # noqa: E402

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import drop_in, report  # noqa: E402

# The window has 8 bits a channel: red, green and blue are the digits of noise from -8 to 8.
FRAGMENT = """
layout(location = 0) out vec4 value;
layout(std140, binding = 0) uniform Given { mat4 qt_Matrix; float qt_Opacity; };
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    uint word = uint((gabor_noise(p, 4.0, 0.7854, 7u) + 8.0) * 1048576.0 + 0.5);
    value = vec4(vec3(uvec3(word >> 16, word >> 8, word) & 255u) / 255.0, 1.0);
}
"""
QML = 'import QtQuick\nShaderEffect { width: 256; height: 257; blending: false; fragmentShader: "noise.frag.qsb" }\n'

path, name, *macros = sys.argv[1:]
folder = pathlib.Path(path).parent
(folder / "noise.frag").write_text(f"#version 440\n{drop_in(name, macros)}{FRAGMENT}")
(folder / "noise.qml").write_text(QML)
subprocess.run(["/usr/lib/qt6/bin/qsb", "--glsl", "300 es,330", "--hlsl", "50", "--msl", "12", "-o", folder / "noise.frag.qsb", folder / "noise.frag"],
               check=True)

application = QGuiApplication([])
view = QQuickView(QUrl.fromLocalFile(str(folder / "noise.qml")))
if view.errors():
    sys.exit("".join(error.toString() + "\n" for error in view.errors()))
view.show()
picture = view.grabWindow().convertToFormat(QImage.Format.Format_RGBX8888)
digits = np.frombuffer(picture.constBits().asstring(4 * 256 * 257), "u1").reshape(257, 256, 4)[::-1].astype(float)
values = np.float32((digits[..., :3] @ [65536, 256, 1]) / 1048576 - 8)

get_string = ctypes.CDLL("libGL.so.1").glGetString
get_string.restype = ctypes.c_char_p
context = QOpenGLContext()
context.create()
context.makeCurrent(view)
report(path, values, "Qt's ShaderEffect", QT_VERSION_STR, "GLSL 440 by qsb", get_string(0x1F01).decode())  # GL_RENDERER
