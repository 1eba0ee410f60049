"""Imports functions from the modules in the package for Bevy, composes them with naga_oil as Bevy does, and runs them on
Vulkan: run.py VALUES.raw"""

import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent))
from scene import CALLS, calls_on_vulkan, report  # noqa: E402

MODULES = "noise", "spectrum", "filter", "noise_3d", "filter_3d", "materials", "erosion", "direction", "fractal"  # each after those that it imports
SCENE = """#import gabor_noise::noise::{gabor_field, gabor_noise, gabor_noise_animated, gabor_noise_quadrature,
    gabor_noise_gradient, gabor_noise_tiled, gabor_place, gabor_place_3d_at, gabor_stripes, gabor_wave_vector}
#import gabor_noise::noise_3d::gabor_field_3d
#import gabor_noise::materials::gabor_brushed_metal
#import gabor_noise::fractal::gabor_fbm
fn solid(p: vec2f) -> f32 {
    let field = gabor_field_3d(gabor_place_3d_at(vec3f(p, 0.3)), 4.0 * normalize(vec3f(1.0, 2.0, 3.0)), 7u);
    return field.noise + dot(field.gradient, vec3f(1.0, 2.0, 3.0)) / 64.0;
}
@group(0) @binding(0) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(8) fn main(@builtin(global_invocation_id) pixel: vec3u) {
    let p = (vec2f(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256u + pixel.x] = VALUE;
}
"""
FUNCTIONS = {name: re.sub(r"\bvec(\d)\(", r"vec\1f(", call.replace("ivec2", "vec2i")) for name, call in CALLS.items()} | {"solid": "solid(p)", "fbm": "gabor_fbm(p, 3.3, 0.5, 7u)"}


def compiled(source, spirv):
    modules = (source.parent / "src" / f"{module}.wgsl" for module in MODULES)
    subprocess.run([os.environ["GABOR_COMPOSE"], spirv, source, *modules], check=True)
    subprocess.run(["spirv-opt", "-O", spirv, "-o", spirv], check=True)  # lavapipe compiles naga's loops slowly


driver, values = calls_on_vulkan("bevy", "wgsl", SCENE, FUNCTIONS.values(), compiled)
version = re.search(r'naga_oil = \{ version = "([^"]*)', (HERE / "Cargo.toml").read_text())[1]
report(sys.argv[1], values, "Bevy's naga_oil", version, "modules of WGSL", driver, functions=list(FUNCTIONS))
