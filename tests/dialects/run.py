"""Draws the scene in one dialect: run.py glsl|hlsl|dxc|unity|unreal|metal|cpp|mingw VALUES.raw DROP_IN
[NAME=VALUE]. GABOR_SCENES is the folder with the compiled programs, and GABOR_DXC the DirectX shader compiler's library, for
dxc, unity and unreal. mingw compiles C++ with CXX after windows.h, and GABOR_WINE runs it."""

import os
import pathlib
import re
import subprocess
import sys

import metal

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "engines"))
from scene import SHADERS, compute_shader, drop_in, in_cpp, on_vulkan, packaged, report  # noqa: E402

dialect, path, name, *macros = sys.argv[1:]
values = pathlib.Path(path)
os.environ.setdefault("GABOR_VALIDATION", "1")
os.environ.setdefault("CXX", "c++")

UNITY = {  # the same functions as in reference.FUNCTIONS
    "noise": "noise",
    "complex": "quadrature",
    "gradient": "noise + dot(gradient, float2(1.0, 2.0)) / 32.0",
    "stripes": "dot(stripes, float3(0.25, 0.5, 0.75))",
    "fbm": "fractal",
}
UNREAL = {
    "noise": "CustomExpression0(Parameters, Place, 4.0, 0.7854, 7.0)",
    "fbm": "CustomExpression1(Parameters, Place, 3.3, 0.5, 0.0, 0.0, 7.0)",
}
CPP = "gabor_noise(p, 4.0f, 0.7854f, 7u)"


def drawn(shader):
    """Returns the driver's name and the values of a compute shader."""
    source, spirv = values.with_suffix(".comp" if dialect == "glsl" else ".hlsl"), values.with_suffix(".spv")
    source.write_text(shader)
    if dialect in ("glsl", "hlsl"):
        hlsl = ["-D", "-e", "main"] if dialect == "hlsl" else []
        subprocess.run(["glslangValidator", "--quiet", "-V", "-S", "comp", *hlsl, "-o", spirv, source], check=True)
    else:
        subprocess.run([sys.executable, "-B", HERE / "dxc.py", source, spirv], check=True)
    return on_vulkan(spirv)


def with_node(scene):
    """Returns the scene's text with the files of the dialect's package in place of their includes."""
    node = packaged(dialect, f"{values}.{dialect}")

    def expanded(file):
        return re.sub(r'^#include "(.*)"$', lambda match: expanded(node / match[1]), file.read_text(), flags=re.MULTILINE)
    return expanded(HERE / scene)


driver, functions = "CPU", {}
if dialect in ("cpp", "mingw"):
    before, options = ("#include <windows.h>\n", ["-static"]) if dialect == "mingw" else ("", [])
    picture = in_cpp(values.parent, before + drop_in(name, macros, "hpp"), [CPP], "-std=c++11", "-O1", *options, "-I",
                     SHADERS / "translations")
elif dialect == "metal":
    picture = in_cpp(values.parent, metal.as_cpp(drop_in(name, macros, "metal")), [CPP], "-O1", *metal.options(os.environ["CXX"]))
elif dialect == "unity":
    scene, functions = with_node("scene_unity.hlsl"), {"functions": list(UNITY)}
    drivers, pictures = zip(*(drawn(f"#define VALUE ({value})\n{scene}") for value in UNITY.values()))
    driver, picture = drivers[0], b"".join(bytes(each[:65536]) for each in pictures)
elif dialect == "unreal":
    scene, functions = with_node("scene_unreal.hlsl"), {"functions": list(UNREAL)}
    drivers, pictures = zip(*(drawn(f"#define VALUE {value}\n{scene}") for value in UNREAL.values()))
    driver, picture = drivers[0], b"".join(bytes(each[:65536]) for each in pictures)
elif dialect == "glsl":
    driver, picture = drawn(compute_shader(name, macros))
else:
    scene = (HERE / "scene.hlsl").read_text()
    driver, picture = drawn(scene.replace('#include "gabor_noise.hlsl"\n', drop_in(name, macros, "hlsl")))
engine, version, language = {
    "glsl": ("Vulkan", "1.1", "GLSL 450"),
    "hlsl": ("Vulkan", "1.1", "HLSL by glslang"),
    "dxc": ("Vulkan", "1.1", "HLSL by DXC"),
    "metal": ("none: a C++ compiler", "-", "Metal, as C++"),
    "unity": ("Unity's functions", "-", "HLSL by DXC"),
    "unreal": ("Unreal's Custom node", "-", "HLSL by DXC"),
    "cpp": ("none: a C++ compiler", "-", "C++ 11"),
    "mingw": ("Wine", "-", "C++ 11 by MinGW, after windows.h"),
}[dialect]
report(path, picture, engine, version, language, driver, **functions)
