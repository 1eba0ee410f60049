"""Imports functions from the module in the package for Slang, compiles them to SPIR-V and runs them on Vulkan: run.py VALUES.raw"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import slangpy

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "tests" / "engines"))
from functions import CALLS, on_vulkan  # noqa: E402
from packaged import packaged  # noqa: E402

SCENE = """import gabor_noise;
[[vk::binding(0)]] RWStructuredBuffer<float> values;
[shader("compute")][numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256 + pixel.x] = VALUE;
}
"""
FUNCTIONS = {name: call.replace("vec", "float") for name, call in CALLS.items()}


def drawn(value, folder):
    source, spirv, values = (folder / name for name in ("scene.slang", "scene.spv", "values.raw"))
    source.write_text(SCENE.replace("VALUE", value))
    subprocess.run([sys.executable, "-B", ROOT / "tests/dialects/slangc.py", source, "main", "compute", spirv], check=True)
    return on_vulkan(spirv, values)


with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
    module = packaged("slang", folder)
    drivers, pictures = zip(*(drawn(value, module) for value in FUNCTIONS.values()))
pathlib.Path(sys.argv[1]).write_bytes(np.concatenate(pictures).tobytes())
print(json.dumps({"engine": "Slang", "version": slangpy.__version__, "dialect": "a module, to SPIR-V", "driver": drivers[0],
                  "functions": list(FUNCTIONS)}))
