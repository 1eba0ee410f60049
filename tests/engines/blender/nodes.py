"""Draws the node group of shaders/nodes/blender/gabor_noise in Cycles without OSL, or in Eevee: nodes.py cycles|eevee
VALUES.raw. Needs a Python that has bpy. The amplitudes come from White Noise nodes. The script draws them too, and
compares the noise with the equations applied to them."""

import pathlib
import sys
import tempfile

import bpy
import numpy as np
from cycles_scene import lit_by, math, red_and_green, render, seen_from_above, vector

ENGINES = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ENGINES), str(ENGINES.parents[1] / "shaders" / "nodes" / "blender")]
import gabor_noise  # noqa: E402
import reference  # noqa: E402
from scene import report  # noqa: E402

engine, values = sys.argv[1:]
SEED = 7.0
FIRST = -4  # the first column and row whose amplitude is drawn


def drawn(folder, value, least, steps):
    """Draws value(tree, (x, y)), which must exceed `least`, for the column and row of each pixel.
    Eevee's light has only 11 bits, so red carries whole steps of size 1 / `steps`, and green the rest."""
    tree, pixel = seen_from_above()
    scaled = math(tree, "MULTIPLY_ADD", value(tree, pixel), steps, -least * steps)
    lit_by(tree, red_and_green(tree, math(tree, "FLOOR", scaled), math(tree, "FRACT", scaled)))
    light = render(256, 256, 1, folder, "CYCLES" if engine == "cycles" else "BLENDER_EEVEE", osl=False).astype(float)
    return (light[..., 0] + light[..., 1]) / steps + least


def amplitude(part):
    def value(tree, pixel):
        white = tree.nodes.new("ShaderNodeTexWhiteNoise")
        white.noise_dimensions = "4D"
        white.inputs["W"].default_value = SEED
        tree.links.new(vector(tree, "ADD", pixel, (FIRST, FIRST, 0)), white.inputs["Vector"])
        parts = tree.nodes.new("ShaderNodeSeparateXYZ")
        tree.links.new(white.outputs["Color"], parts.inputs[0])
        return parts.outputs[part]
    return value


def noise(output):
    def value(tree, pixel):
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = gabor_noise.field_group()
        node.inputs["Scale"].default_value, node.inputs["Seed"].default_value = 1.0, SEED
        node.inputs["Frequency"].default_value = reference.FREQUENCY
        node.inputs["Orientation"].default_value = reference.ORIENTATION
        place = vector(tree, "MULTIPLY", vector(tree, "ADD", pixel, (0.5, 0.5, 0)), (1 / 32, 1 / 32, 0))
        tree.links.new(place, node.inputs["Vector"])
        return node.outputs[output]
    return value


with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
    white = 2 * np.dstack([drawn(folder, amplitude(part), 0, 1024) for part in (0, 1)]) - 1
    picture = np.array([drawn(folder, noise(output), -8, 64) for output in ("Noise", "Quadrature")])
nodes = (reference.law(white) / reference.DEVIATION) @ (1, 1j)
x, y = np.meshgrid((np.arange(256) + 0.5) / 32, (np.arange(256) + 0.5) / 32)
wanted = reference.complex_lattice((0, 0), 1.5 * x, 1.5 * y, amplitudes=lambda i, j: nodes[j - FIRST, i - FIRST])
law = {"mean": float(nodes.real.mean()), "variance": float((abs(nodes) ** 2).mean() / 2)} # from 2 x 65536 parts
if abs(law["mean"]) > 0.02 or abs(law["variance"] - 1) > 0.02 or not 0.5 < picture[0].std() < 2:
    sys.exit(f"White Noise's amplitudes have the wrong distribution: {law}")
report(values, picture.astype("<f4"), f"Blender, {engine.title()}", bpy.app.version_string, "its own nodes",
       "CPU" if engine == "cycles" else "llvmpipe",
       functions={"noise": abs(picture[0] - wanted.imag).max(), "complex": abs(picture[1] - wanted.real).max()})
