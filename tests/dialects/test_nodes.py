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
from packaged import packaged  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
NODES = ROOT / "shaders" / "nodes"
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
import { float, vec2, vec3 } from "./three_tsl.mjs";
import * as gabor from "./gabor_noise.mjs";

const points = Array.from({ length: 256 * 32 }, (_, i) => i);
const node = values => { const made = float(0); made.parts = [Float32Array.from(values)]; return made; };
const p = vec2(node(points.map(i => (i % 256 + 0.5) / 32)), node(points.map(i => (Math.floor(i / 256) + 0.5) / 32)));
const functions = (await import("./functions.mjs")).functions(gabor, { float, vec2, vec3 }, p);
writeFileSync(process.argv[2], Buffer.concat(Object.values(functions).map(value => Buffer.from(value.parts[0].buffer))));
console.log(JSON.stringify(Object.keys(functions)));
"""


# Writes quadrature and gradient in the plane, and noise and gradient in space, at the scene's points.
BESIDE = """
#include "gabor_noise.hpp"
#include "gabor_spectrum.hpp"
#include "gabor_noise_3d.hpp"
#include <fstream>
int main(int, char** argv)
{
    std::ofstream file(argv[1], std::ios::binary);
    for (int i = 0; i < 256 * 256; ++i) {
        const gabor_vec2 p((float(i % 256) + 0.5f) / 32.0f, (float(i / 256) + 0.5f) / 32.0f);
        const gabor_vec3 plane = gabor_noise_gradient(p, 4.0f, 0.7854f, 7u);
        const gabor_vec4 space = gabor_noise_3d_gradient(gabor_vec3(p, 0.3f), 4.0f, gabor_vec3(1.0f, 2.0f, 3.0f), 7u);
        const float values[] = {gabor_noise_complex(p, 4.0f, 0.7854f, 7u).x, plane.y, plane.z, space.x, space.y, space.z, space.w};
        file.write(reinterpret_cast<const char*>(values), sizeof values);
    }
}
"""


class ByHand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gabor-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.values = self.folder / "values.raw"

    def compare(self, *command):
        """Compares the pictures that a program writes, one per function, with the reference."""
        said = subprocess.run([*command, self.values], check=True, stdout=subprocess.PIPE, text=True).stdout
        functions = json.loads(said or '["noise"]')
        for function, values in zip(functions, np.split(np.fromfile(self.values, "<f4"), len(functions))):
            with self.subTest(function):
                error, place = reference.largest_difference(function, values)
                print(f"{function}: largest difference {error:.2g} at row and column {place}")
                self.assertLess(error, 1e-5)

    def run_osl(self, name, scene):
        """Returns the output of a scene that calls an OSL shader as a C++ function."""
        shader, compiler = self.folder / "shader.hpp", os.environ.get("CXX", "c++")
        text = (packaged("osl", self.folder / "osl") / name).read_text()
        text = re.sub(r" = [^\[\n]*\[\[.*\]\]", "", re.sub(r"^shader ", "void ", text, flags=re.MULTILINE))
        text = re.sub(r"output (\w+ \w+\[)", r"\1", text)  # arrays are passed by reference anyway
        shader.write_text(re.sub(r"output (\w+) (\w+)", r"\1& \2", text))
        subprocess.run([compiler, *metal.options(compiler), "-O1", "-fwrapv", f'-DGABOR_OSL="{shader}"', "-I",
                        ROOT / "shaders" / "translations", HERE / scene, "-o", self.folder / "program"], check=True)
        subprocess.run([self.folder / "program", self.values], check=True)
        return np.fromfile(self.values, "<f4")

    def test_open_shading_language(self):
        """Compares the noise with the reference and the shader's other outputs with the translation to C++."""
        values = self.run_osl("gabor_noise.osl", "scene_osl.cpp")
        plane, space = values.reshape(-1, 2, 7).transpose(1, 2, 0).astype(float)
        error, place = reference.largest_difference("lattice", plane[0].astype("<f4"))
        print(f"largest difference {error:.2g} at row and column {place}")
        self.assertLess(error, 1e-5)

        subprocess.run([os.environ.get("CXX", "c++"), "-std=c++11", "-O1", "-x", "c++", "-", "-I", ROOT / "shaders" / "translations", "-o",
                        self.folder / "beside"], input=BESIDE, text=True, check=True)
        subprocess.run([self.folder / "beside", self.values], check=True)
        expected = np.fromfile(self.values, "<f4").reshape(-1, 7).T.astype(float)
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
        values = self.run_osl("gabor_erosion.osl", "scene_osl_erosion.cpp").reshape(-1, 2, 4).astype(float)
        error = np.abs(values[:, 0] - values[:, 1]).max(axis=0)
        print(f"largest differences of height, ridge and slopes: {error}")
        self.assertTrue((error < [1e-5, 1e-3, 1e-3, 1e-3]).all())

    def test_nodes_of_three(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed")
        source = (NODES / "three" / "gabor_noise.tsl.js").read_text()
        functions = HERE.parent / "engines" / "tsl" / "functions.mjs"
        for name, text in {"functions.mjs": functions.read_text(), "three_tsl.mjs": (HERE / "three_tsl.mjs").read_text(), "scene.mjs": TSL,
                           "gabor_noise.mjs": source.replace('"three/tsl"', '"./three_tsl.mjs"')}.items():
            (self.folder / name).write_text(text)
        self.compare("node", self.folder / "scene.mjs")


if __name__ == "__main__":
    unittest.main()
