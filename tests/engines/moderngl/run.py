"""Draws a drop-in in a fragment shader with moderngl: run.py "330 core"|"130"|"300 es" VALUES.raw DROP_IN [NAME=VALUE]"""

import pathlib
import sys

import moderngl
from draw import drawn

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import FRAGMENT, drop_in, report  # noqa: E402

version, path, name, *macros = sys.argv[1:]
head = f"#version {version}\n" + "precision highp float;\n" * version.endswith("es")
pixels, driver = drawn(head, drop_in(name, macros) + FRAGMENT, (256, 257))
report(path, pixels, "moderngl", moderngl.__version__, f"GLSL {version}", driver)
