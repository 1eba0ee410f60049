"""Draws the scene in one dialect: run.py glsl|hlsl|dxc|metal|cpp|mingw VALUES.raw DROP_IN
[NAME=VALUE]. GABOR_SCENES is the folder with the compiled programs, and GABOR_DXC the DirectX shader compiler's library, for
dxc. mingw compiles C++ with CXX after windows.h, and GABOR_WINE runs it."""

import os
import pathlib
import subprocess
import sys

import metal

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "engines"))
from scene import SHADERS, compute_shader, drop_in, in_cpp, on_vulkan, report  # noqa: E402

dialect, path, name, *macros = sys.argv[1:]
values = pathlib.Path(path)
os.environ.setdefault("GABOR_VALIDATION", "1")
os.environ.setdefault("CXX", "c++")

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


driver = "CPU"
if dialect in ("cpp", "mingw"):
    before, options = ("#include <windows.h>\n", ["-static"]) if dialect == "mingw" else ("", [])
    picture = in_cpp(values.parent, before + drop_in(name, macros, "hpp"), [CPP], "-std=c++11", "-O1", *options, "-I",
                     SHADERS / "translations")
elif dialect == "metal":
    picture = in_cpp(values.parent, metal.as_cpp(drop_in(name, macros, "metal")), [CPP], "-O1", *metal.options(os.environ["CXX"]))
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
    "cpp": ("none: a C++ compiler", "-", "C++ 11"),
    "mingw": ("Wine", "-", "C++ 11 by MinGW, after windows.h"),
}[dialect]
report(path, picture, engine, version, language, driver)
