"""Checks that Unity graphs refer only to existing objects, and that hand-written ports to other languages give the same
noise as the GLSL. This test runs the ports on the CPU; tools/test-engines runs them in renderers and browsers."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "engines"))
import metal  # noqa: E402
import reference  # noqa: E402
from scene import SHADERS, in_cpp, packaged  # noqa: E402

NODES = SHADERS / "nodes"
UNITY = NODES / "unity"


def guid(path):
    return re.search(r"^guid: ([0-9a-f]{32})$", (path.parent / f"{path.name}.meta").read_text(), re.MULTILINE)[1]


class UnityNoise(unittest.TestCase):
    graph_file = "Gabor Noise.shadersubgraph"

    def setUp(self):
        text = (UNITY / self.graph_file).read_text()
        objects = [json.loads(part) for part in text.split("\n\n")]
        self.objects = {each["m_ObjectId"]: each for each in objects}
        self.assertEqual(len(self.objects), len(objects))
        self.graph = objects[0]

    def one(self, kind):
        found = [each for each in self.objects.values() if each["m_Type"].endswith("." + kind)]
        self.assertEqual(len(found), 1)
        return found[0]

    def slots(self, node):
        return {slot["m_Id"]: slot for slot in (self.objects[each["m_Id"]] for each in node["m_Slots"])}

    def test_graph_refers_to_existing_things(self):
        def references(value):
            if isinstance(value, dict):
                if set(value) == {"m_Id"} and value["m_Id"]:
                    yield value["m_Id"]
                for each in value.values():
                    yield from references(each)
            elif isinstance(value, list):
                for each in value:
                    yield from references(each)
        referred = {name for each in self.objects.values() for name in references(each)}
        self.assertEqual(referred | {self.graph["m_ObjectId"]}, set(self.objects))

    def test_edges_join_slots_of_one_kind(self):
        ends = []
        for edge in self.graph["m_Edges"]:
            out, into = (self.slots(self.objects[end["m_Node"]["m_Id"]])[end["m_SlotId"]]
                         for end in (edge["m_OutputSlot"], edge["m_InputSlot"]))
            self.assertEqual((out["m_SlotType"], into["m_SlotType"]), (1, 0))
            self.assertEqual(out["m_Type"], into["m_Type"])
            self.assertEqual(out["m_DisplayName"], into["m_DisplayName"])
            ends.append(into["m_ObjectId"])
        node, output = self.one("CustomFunctionNode"), self.one("SubGraphOutputNode")
        inputs = [slot["m_ObjectId"] for each in (node, output) for slot in self.slots(each).values() if not slot["m_SlotType"]]
        self.assertEqual(sorted(ends), sorted(inputs))

    def test_function_matches_the_file(self):
        node = self.one("CustomFunctionNode")
        self.assertEqual(node["m_FunctionSource"], guid(UNITY / "GaborNoise.hlsl"))
        source = (UNITY / "GaborNoise.hlsl").read_text()
        for kind in ("float", "half"):
            arguments = re.search(rf"void {node['m_FunctionName']}_{kind}\((.*)\)", source)[1]
            slots = [(" out" * slot["m_SlotType"] + {"Vector1": f" {kind}", "Vector2": f" {kind}2", "Vector3": f" {kind}3"}[
                re.search(r"(Vector\d)MaterialSlot", slot["m_Type"])[1]] + f" {slot['m_ShaderOutputName']}").strip()
                for slot in self.slots(node).values()]
            self.assertEqual(arguments.split(", "), slots)


class UnityStripes(UnityNoise):
    graph_file = "Gabor Stripes.shadersubgraph"


# Writes the values of functions.mjs, one for each function of gabor_noise.tsl.js, at the scene's points.
TSL = """
import { writeFileSync } from "node:fs";
import { dot, float, normalize, vec2, vec3 } from "./three_tsl.mjs";
import * as gabor from "./gabor_noise.mjs";

const points = Array.from({ length: 256 * 32 }, (_, i) => i);
const node = values => { const made = float(0); made.parts = [Float32Array.from(values)]; return made; };
const p = vec2(node(points.map(i => (i % 256 + 0.5) / 32)), node(points.map(i => (Math.floor(i / 256) + 0.5) / 32)));
const functions = (await import("./functions.mjs")).functions(gabor, { dot, normalize, vec2, vec3 }, p);
writeFileSync(process.argv[2], Buffer.concat(Object.values(functions).map(value => Buffer.from(value.parts[0].buffer))));
console.log(JSON.stringify(Object.keys(functions)));
"""


# The outputs of the shaders, which are C++ functions in the namespace osl, and those of the drop-ins.
NOISE = """
    vector gradient(0), gradient_3d(0);
    float noise, value, phase, intensity, noise_3d, value_3d, phase_3d, intensity_3d;
    const vector place = vector(p.x, p.y, 0.3f) * 0.25f, along(1, 2, 3);
    osl::gabor_noise(place, 4, 4, 0.7854f, 7, 0, along, value, phase, intensity, noise, gradient);
    osl::gabor_noise(place, 4, 4, 0.7854f, 7, 1, along, value_3d, phase_3d, intensity_3d, noise_3d, gradient_3d);
    const gabor_vec3 plane = gabor_noise_gradient(p, 4.0f, 0.7854f, 7u);
    const GaborField3d space = gabor_field_3d(gabor_place_3d_at(gabor_vec3(p, 0.3f)),
                                              4.0f * gabor_impl_unit(gabor_vec3(1.0f, 2.0f, 3.0f)), 7u);
"""
EROSION = """
    float height, ridge;
    osl::gabor_erosion(vector(0.5f * p.x, 0.5f * p.y, 0), 2, 7, 5, 1.5f, 0.12f, 2, 0.5f, 0.5f, 1.5f, 2, 0.1f, 0.1f, 0.5f, 1, height, ridge);
    const GaborTerrain expected = gabor_eroded(p, gabor_terrain(p, 7), gabor_erosion(), 7);
"""


class ByHand(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def compare(self, function, values):
        error, place = reference.largest_difference(function, values)
        print(f"{function}: largest difference {error:.2g} at row and column {place}")
        self.assertLess(error, 1e-5)

    def osl(self, name, drop_ins, code, values):
        """Returns the values of expressions after code that calls an OSL shader as a C++ function."""
        text = (packaged("osl", self.folder / "osl") / name).read_text()
        text = re.sub(r" = [^\[\n]*\[\[.*\]\]", "", re.sub(r"^shader ", "void ", text, flags=re.MULTILINE))
        text = re.sub(r"output (\w+ \w+\[)", r"\1", text)  # arrays are passed by reference anyway
        text = re.sub(r"output (\w+) (\w+)", r"\1& \2", text)
        includes = "".join(f'#include "{file}.hpp"\n' for file in drop_ins)
        return in_cpp(self.folder, f'#include "osl.hpp"\nnamespace osl {{\n{text}}}\n{includes}', values, "-O1", "-fwrapv", "-I",
                      SHADERS / "translations", *metal.options(os.environ.get("CXX", "c++")), code=code)[:, :256].astype(float)

    def test_open_shading_language(self):
        """Compares the noise with the reference and the shader's other outputs with the translation to C++."""
        made = self.osl("gabor_noise.osl", ["gabor_noise", "gabor_noise_3d"], NOISE, [
            *"noise gradient.x gradient.y gradient.z value phase intensity".split(),
            *"noise_3d gradient_3d.x gradient_3d.y gradient_3d.z value_3d phase_3d intensity_3d".split(),
            "gabor_noise_complex(p, 4.0f, 0.7854f, 7u).x", *"plane.y plane.z space.noise space.gradient.x space.gradient.y space.gradient.z".split()])
        plane, space, expected = np.split(made, 3)
        self.compare("lattice", plane[0])
        self.assertLess(np.abs(plane[1:3] - expected[1:3]).max(), 2e-3)
        self.assertLess(np.abs(space[0] - expected[3]).max(), 3e-5)
        self.assertLess(np.abs(space[1:4] - expected[4:]).max(), 2e-3)
        for noise, *_, value, phase, intensity in (plane, space):
            self.assertLess(np.abs(value - np.clip(0.5 + 0.25 * noise, 0, 1)).max(), 1e-6)
        self.assertEqual(np.abs(plane[3]).max(), 0)
        phase, intensity = plane[5:]
        self.assertLess(np.abs(intensity * np.sin(2 * np.pi * phase) - plane[0]).max(), 1e-5)
        self.assertLess(np.abs(intensity * np.cos(2 * np.pi * phase) - expected[0]).max(), 2e-5)
        self.assertTrue(((0 <= phase) & (phase <= 1)).all())

    def test_erosion_in_open_shading_language(self):
        outputs = "2.0f*height ridge expected.height expected.ridge".split()
        made, expected = np.split(self.osl("gabor_erosion.osl", ["gabor_noise", "gabor_erosion"], EROSION, outputs), 2)
        error = np.abs(made - expected).max(axis=(1, 2))
        print(f"largest differences of height and ridge: {error}")
        self.assertTrue((error < [1e-5, 1e-3]).all())

    def test_nodes_of_three(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed")
        source = (NODES / "three" / "gabor_noise.tsl.js").read_text()
        functions = HERE.parent / "engines" / "tsl" / "functions.mjs"
        for name, text in {"functions.mjs": functions.read_text(), "three_tsl.mjs": (HERE / "three_tsl.mjs").read_text(), "scene.mjs": TSL,
                           "gabor_noise.mjs": source.replace('"three/tsl"', '"./three_tsl.mjs"')}.items():
            (self.folder / name).write_text(text)
        values = self.folder / "values.raw"
        said = subprocess.run(["node", self.folder / "scene.mjs", values], check=True, stdout=subprocess.PIPE, text=True).stdout
        names = json.loads(said)
        for name, picture in zip(names, np.split(np.fromfile(values, "<f4"), len(names))):
            with self.subTest(name):
                self.compare(name, picture)


if __name__ == "__main__":
    unittest.main()
