"""Draws the scene in one dialect: run.py glsl|hlsl|dxc|unity|unreal|metal|cpp VALUES.raw DROP_IN [NAME=VALUE].
GABOR_SCENES is the folder with the compiled programs, and GABOR_DXC the DirectX shader compiler's library, for dxc, unity and
unreal."""

import json
import os
import pathlib
import re
import subprocess
import sys

import metal

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "engines"))
from packaged import packaged  # noqa: E402

SHADERS = HERE.parents[1] / "shaders"
SCENES = pathlib.Path(os.environ["GABOR_SCENES"])

dialect, values, drop_in, *macros = sys.argv[1:]
os.environ.setdefault("GABOR_VALIDATION", "1")


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def pasted(scene, text, ending):
    """Writes the scene with the macros, and with the drop-in in place of its include; returns the file."""
    include = re.search(r'#include "gabor_.*\n', scene)[0]
    text = "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros) + text
    path = pathlib.Path(values).with_suffix(ending)
    path.write_text(scene.replace(include, text))
    return path


def with_node(scene):
    """Returns the scene's text with the files of the dialect's package in place of their includes."""
    node = packaged(dialect, f"{values}.{dialect}")

    def expanded(path):
        return re.sub(r'^#include "(.*)"$', lambda match: expanded(node / match[1]), path.read_text(), flags=re.MULTILINE)
    return expanded(HERE / scene)


def drawn_by_vulkan():
    spirv = f"{values}.spv"
    if dialect == "glsl":
        shader = pasted((HERE / "scene.comp").read_text(), (SHADERS / f"{drop_in}.glsl").read_text(), ".comp")
        run("glslangValidator", "--quiet", "-V", "-S", "comp", "-o", spirv, shader)
    elif dialect == "unreal":
        shader = pathlib.Path(values).with_suffix(".hlsl")
        shader.write_text(with_node("scene_unreal.hlsl"))
        run(sys.executable, "-B", HERE / "dxc.py", shader, spirv)
    else:
        shader = pasted((HERE / "scene.hlsl").read_text(), (SHADERS / "translations" / f"{drop_in}.hlsl").read_text(),
                        ".hlsl")
        if dialect == "dxc":
            run(sys.executable, "-B", HERE / "dxc.py", shader, spirv)
        else:
            run("glslangValidator", "--quiet", "-V", "-D", "-S", "comp", "-e", "main", "-o", spirv, shader)
    driver = run(SCENES / "scene_vulkan", spirv, values).strip()
    if dialect == "unreal":  # its node has no gabor_noise_at
        drawn = pathlib.Path(values)
        drawn.write_bytes(drawn.read_bytes()[:4 * 256 * 256])
    return driver


UNITY = {  # the same functions as in reference.FUNCTIONS
    "noise": "noise",
    "complex": "quadrature",
    "gradient": "noise + dot(gradient, float2(1.0, 2.0)) / 32.0",
    "stripes": "dot(stripes, float3(0.25, 0.5, 0.75))",
}


def drawn_by_unity():
    shader, spirv, pictures = pathlib.Path(values).with_suffix(".hlsl"), f"{values}.spv", b""
    scene = with_node("scene_unity.hlsl")
    for value in UNITY.values():
        shader.write_text(f"#define VALUE ({value})\n" + scene)
        run(sys.executable, "-B", HERE / "dxc.py", shader, spirv)
        driver = run(SCENES / "scene_vulkan", spirv, values).strip()
        pictures += pathlib.Path(values).read_bytes()[:4 * 256 * 256]
    pathlib.Path(values).write_bytes(pictures)
    return driver


def drawn_by_cpp():
    compiler = os.environ.get("CXX", "c++")
    text, options = (SHADERS / "translations" / f"{drop_in}.{'hpp' if dialect == 'cpp' else 'metal'}").read_text(), ["-std=c++11"]
    if dialect == "metal":
        text, options = metal.as_cpp(text), metal.options(compiler)
    program = pathlib.Path(values).with_suffix("")
    run(compiler, "-O1", *options, "-o", program, pasted((HERE / "scene.cpp").read_text(), text, ".cpp"))
    run(program, values)
    return "CPU"


driver = drawn_by_cpp() if dialect in ("cpp", "metal") else drawn_by_unity() if dialect == "unity" else drawn_by_vulkan()
engine, version, language = {
    "glsl": ("Vulkan", "1.1", "GLSL 450"),
    "hlsl": ("Vulkan", "1.1", "HLSL by glslang"),
    "dxc": ("Vulkan", "1.1", "HLSL by DXC"),
    "metal": ("none: a C++ compiler", "-", "Metal, as C++"),
    "unity": ("Unity's functions", "-", "HLSL by DXC"),
    "unreal": ("Unreal's Custom node", "-", "HLSL by DXC"),
    "cpp": ("none: a C++ compiler", "-", "C++ 11"),
}[dialect]
functions = {"functions": list(UNITY)} if dialect == "unity" else {}
print(json.dumps({"engine": engine, "version": version, "dialect": language, "driver": driver, **functions}))
