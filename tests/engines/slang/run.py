"""Functions of the module of shaders/nodes/slang, imported, compiled to SPIR-V and run on Vulkan: run.py VALUES.raw"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import slangpy

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENE = """import gabor_lattice;
[[vk::binding(0)]] RWStructuredBuffer<float> values;
[shader("compute")][numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256 + pixel.x] = VALUE;
}
"""
# As reference.FUNCTIONS.
FUNCTIONS = {
    "noise": "gabor_noise(p, 4.0, 0.7854, 7u)",
    "complex": "gabor_noise_complex(p, 4.0, 0.7854, 7u).x",
    "gradient": "dot(gabor_noise_gradient(p, 4.0, 0.7854, 7u), float3(1.0, 1.0 / 32.0, 1.0 / 16.0))",
    "four": "dot(gabor_noise_four(p, 4.0, 0.7854, 7u), float4(0.25, 0.5, 0.75, 1.0))",
    "tiled": "gabor_noise_tiled(p, float2(2.0, 1.0), 4.0, 0.7854, 7u)",
    "animated": "gabor_noise_animated(p, 0.3, 4.0, 0.7854, 7u)",
    "stripes": "dot(gabor_stripes(p, gabor_kernel(4.0, 0.7854).wave, 2.0, 7u), float3(0.25, 0.5, 0.75))",
}


def drawn(value, folder):
    source, spirv, values = (folder / name for name in ("scene.slang", "scene.spv", "values.raw"))
    source.write_text(SCENE.replace("VALUE", value))
    (folder / "gabor_lattice.slang").write_text((ROOT / "shaders/nodes/slang/gabor_lattice.slang").read_text())
    subprocess.run([sys.executable, "-B", ROOT / "tests/dialects/slangc.py", source, "main", "compute", spirv], check=True)
    scene = subprocess.run([pathlib.Path(os.environ["GABOR_SCENES"]) / "scene_vulkan", spirv, values], check=True,
                           stdout=subprocess.PIPE, text=True)
    return scene.stdout.strip(), np.fromfile(values, "<f4")[:65536]


with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
    drivers, pictures = zip(*(drawn(value, pathlib.Path(folder)) for value in FUNCTIONS.values()))
pathlib.Path(sys.argv[1]).write_bytes(np.concatenate(pictures).tobytes())
print(json.dumps({"engine": "Slang", "version": slangpy.__version__, "dialect": "a module, to SPIR-V", "driver": drivers[0],
                  "functions": list(FUNCTIONS)}))
