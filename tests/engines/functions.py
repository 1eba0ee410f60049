"""The functions of reference.FUNCTIONS as GLSL calls. For other languages, tests rename the vectors."""

import os
import pathlib
import subprocess

import numpy as np

CALLS = {
    "noise": "gabor_noise(p, 4.0, 0.7854, 7u)",
    "complex": "gabor_noise_complex(p, 4.0, 0.7854, 7u).x",
    "gradient": "dot(gabor_noise_gradient(p, 4.0, 0.7854, 7u), vec3(1.0, 1.0 / 32.0, 1.0 / 16.0))",
    "four": "dot(gabor_noise_four(p, 4.0, 0.7854, 7u), vec4(0.25, 0.5, 0.75, 1.0))",
    "tiled": "gabor_noise_tiled(p, vec2(2.0, 1.0), 4.0, 0.7854, 7u)",
    "animated": "gabor_noise_animated(p, 0.3, 4.0, 0.7854, 7u)",
    "stripes": "dot(gabor_stripes(p, gabor_kernel(4.0, 0.7854).wave, 2.0, 7u), vec3(0.25, 0.5, 0.75))",
}


def on_vulkan(spirv, values):
    """Returns the driver's name and the 256 x 256 values that a compute shader writes."""
    program = pathlib.Path(os.environ["GABOR_SCENES"]) / "scene_vulkan"
    driver = subprocess.run([program, spirv, values], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    return driver, np.fromfile(values, "<f4")[:65536]
