"""What the scripts that draw the scene of reference.py share: its code in GLSL, Slang and C++, the drop-ins' texts, packages,
and the report that tools/test-engines reads."""

import functools
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHADERS = ROOT / "shaders"

FRAGMENT = """
out vec4 value;
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    float noise = gabor_noise(p, 4.0, 0.7854, 7u);
    value = vec4(vec3(noise), 1.0); // some engines blend by alpha
}
"""
CPP = """#include <fstream>
#include <vector>
BEFORE
int main(int, char** argv)
{
    std::vector<float> values;
    for (int i = 0; i < 256 * ROWS; ++i) {
        gabor_vec2 p = (gabor_vec2(float(i % 256), float(i / 256)) + 0.5f) / 32.0f;
        CODE
        values.insert(values.end(), {VALUES});
    }
    std::ofstream(argv[1], std::ios::binary).write(reinterpret_cast<const char*>(values.data()), 4 * values.size());
}
"""
SLANG = """
[[vk::binding(0)]] RWStructuredBuffer<float> values;
[shader("compute")][numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256 + pixel.x] = VALUE;
}
"""
# The functions of reference.FUNCTIONS as GLSL calls. For other languages, tests rename the vectors.
CALLS = {
    "noise": "gabor_noise(p, 4.0, 0.7854, 7u)",
    "complex": "gabor_noise_quadrature(p, 4.0, 0.7854, 7u).y",
    "gradient": "dot(gabor_noise_gradient(p, 4.0, 0.7854, 7u), vec3(1.0, 1.0 / 32.0, 1.0 / 16.0))",
    "tiled": "gabor_noise_tiled(p, vec2(2.0, 1.0), 4.0, 0.7854, 7u)",
    "animated": "gabor_noise_animated(p, 0.3, 4.0, 0.7854, 7u)",
    "stripes": "dot(gabor_stripes(p, gabor_wave_vector(4.0, 0.7854), 2.0, 7u), vec3(0.25, 0.5, 0.75))",
    "far": "gabor_field(gabor_place(ivec2(1000000000, -1000000000), p), gabor_wave_vector(4.0, 0.7854), 7u).noise",
}


@functools.cache
def printed(language):
    """Returns a folder, while the program runs, with the drop-ins in a language that the repository does not have."""
    folder = tempfile.TemporaryDirectory(prefix="gabor-")
    subprocess.run([sys.executable, "-B", ROOT / "tools" / "translate", language, "-o", folder.name], check=True)
    return folder


def drop_in_path(name, ending="glsl"):
    """Returns the file of a drop-in or its translation."""
    if language := {"metal": "metal", "gdshaderinc": "godot"}.get(ending):
        return pathlib.Path(printed(language).name) / f"{name}.{ending}"
    return SHADERS / ("" if ending == "glsl" else "translations") / f"{name}.{ending}"


def drop_in(name, macros, ending="glsl"):
    """Returns the text of a drop-in or its translation after the macros, each given as NAME=VALUE."""
    return "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros) + drop_in_path(name, ending).read_text()


def compute_shader(name, macros):
    """Returns Godot's compute shader with the drop-in in place of its include."""
    return (ROOT / "tests/engines/godot/noise.comp").read_text().replace('#include "gabor_noise.glsl"\n', drop_in(name, macros))


def packaged(name, folder):
    """Writes the files of a package to the folder, as its users get them, and returns it."""
    subprocess.run([sys.executable, "-B", ROOT / "tools" / "package", name, "--stage", folder], check=True)
    return pathlib.Path(folder)


def report(path, values, engine, version, dialect, driver, **functions):
    """Writes the drawn floats, and prints what drew them."""
    pathlib.Path(path).write_bytes(bytes(values))
    print(json.dumps({"engine": engine, "version": version, "dialect": dialect, "driver": driver, **functions}))


def on_vulkan(*shaders, rows=257, pictures=1):
    """Returns the driver's name and the values that compute shaders write, which are in SPIR-V: for each, a number of pictures of 256
    values by the rows."""
    program, files = pathlib.Path(os.environ["GABOR_SCENES"]) / "scene_vulkan", [f"{shader}.raw" for shader in shaders]
    command = [program, str(rows), str(pictures), *itertools.chain(*zip(shaders, files))]
    driver = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    return driver, *(np.fromfile(file, "<f4") for file in files)


def calls_on_vulkan(package, ending, shader, calls, compiled):
    """Returns the driver's name and the values of the calls, each in place of VALUE in a shader that uses a package's files.
    `compiled(source, spirv)` compiles it, in the folder of these files."""
    with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
        folder, made = packaged(package, folder), []
        for call in calls:
            made.append(folder / f"{len(made)}.spv")
            (folder / f"scene.{ending}").write_text(shader.replace("VALUE", call))
            compiled(folder / f"scene.{ending}", made[-1])
        driver, *drawn = on_vulkan(*made, rows=256)
    return driver, np.concatenate(drawn)


def run_cpp(folder, source, *options):
    """Compiles a C++ program with CXX, and runs it, by GABOR_WINE if set, with the name of a file, into which it writes words of
    32 bits. Returns these and the compiler's messages."""
    program, values = (pathlib.Path(folder) / f"program.{kind}" for kind in ("out", "raw"))
    made = subprocess.run([os.environ.get("CXX", "c++"), *options, "-x", "c++", "-", "-o", program], input=source, text=True,
                          stderr=subprocess.PIPE)
    if made.returncode != 0:
        raise AssertionError(made.stderr)
    subprocess.run([*filter(None, [os.environ.get("GABOR_WINE")]), program, values], check=True)
    return np.fromfile(values, "<u4"), made.stderr


def in_cpp(folder, before, values, *options, code="", rows=257):
    """Returns the values of C++ expressions of p at all points of the scene, or of its first rows, a picture for each. `before` is the
    text before the program's main function, and `code` that before the expressions."""
    source = CPP.replace("BEFORE", before).replace("CODE", code).replace("VALUES", ", ".join(values)).replace("ROWS", str(rows))
    return run_cpp(folder, source, *options)[0].view("<f4").reshape(rows, 256, len(values)).transpose(2, 0, 1)
