"""The scene in one dialect: run.py glsl|hlsl|metal VALUES.raw, with the programs of this folder in GABOR_SCENES."""

import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SHADERS = HERE.parents[1] / "shaders"
SCENES = pathlib.Path(os.environ["GABOR_SCENES"])

dialect, values = sys.argv[1:]
os.environ.setdefault("GABOR_VALIDATION", "1")


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def on_vulkan(*options):
    spirv = f"{values}.spv"
    run("glslangValidator", "--quiet", "-V", *options, "-o", spirv)
    return run(SCENES / "scene_vulkan", spirv, values).strip()


if dialect == "glsl":
    engine, language = "Vulkan", "GLSL 450"
    driver = on_vulkan(f"-I{SHADERS}", HERE / "scene.comp")
elif dialect == "hlsl":
    engine, language = "Vulkan", "HLSL by glslang"
    driver = on_vulkan("-D", "-S", "comp", "-e", "main", f"-I{SHADERS / 'translations'}", HERE / "scene.hlsl")
else:
    engine, language, driver = "none: a C++ compiler", "Metal, as C++", "CPU"
    run(SCENES / "scene_metal", values)

print(json.dumps({"engine": engine, "version": "-" if dialect == "metal" else "1.1", "dialect": language,
                  "driver": driver}))
