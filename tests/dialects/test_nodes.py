"""Packages: their files are all there, and refer to each other as they must."""

import json
import pathlib
import re
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NODES = ROOT / "shaders" / "nodes"
UNITY = NODES / "unity"


def guid(path):
    return re.search(r"^guid: ([0-9a-f]{32})$", (path.parent / f"{path.name}.meta").read_text(), re.MULTILINE)[1]


class Unity(unittest.TestCase):
    def setUp(self):
        text = (UNITY / "Gabor Noise.shadersubgraph").read_text()
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

    def test_each_asset_has_a_guid(self):
        assets = [path for path in UNITY.iterdir() if path.suffix != ".meta"]
        self.assertEqual(sorted(f"{path.name}.meta" for path in assets), sorted(path.name for path in UNITY.glob("*.meta")))
        self.assertEqual(len({guid(path) for path in assets}), len(assets))

    def test_graph_refers_to_what_there_is(self):
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

    def test_function_is_that_of_the_file(self):
        node = self.one("CustomFunctionNode")
        self.assertEqual(node["m_FunctionSource"], guid(UNITY / "GaborNoise.hlsl"))
        source = (UNITY / "GaborNoise.hlsl").read_text()
        for kind in ("float", "half"):
            arguments = re.search(rf"void {node['m_FunctionName']}_{kind}\((.*)\)", source)[1]
            slots = [(" out" * slot["m_SlotType"] + {"Vector1": f" {kind}", "Vector2": f" {kind}2"}[
                re.search(r"(Vector\d)MaterialSlot", slot["m_Type"])[1]] + f" {slot['m_ShaderOutputName']}").strip()
                for slot in self.slots(node).values()]
            self.assertEqual(arguments.split(", "), slots)

    def test_version(self):
        package = json.loads((ROOT / "package.json").read_text())
        self.assertEqual(json.loads((UNITY / "package.json").read_text())["version"], package["version"])


class Package(unittest.TestCase):
    def test_npm_packs_every_file(self):
        if not shutil.which("npm"):
            self.skipTest("npm is not installed")
        said = subprocess.run(["npm", "pack", "--dry-run", "--json", "--offline"], cwd=ROOT, check=True, capture_output=True)
        packed = {each["path"] for each in json.loads(said.stdout)[0]["files"]}
        wanted = {str(path.relative_to(ROOT)) for folder in ("translations", "nodes")
                  for path in (ROOT / "shaders" / folder).rglob("*")
                  if path.is_file() and path.suffix != ".oso" and "node_modules" not in path.parts}
        wanted |= {str(path.with_suffix(".glsl").relative_to(ROOT)).replace("translations/", "")
                   for path in (ROOT / "shaders" / "translations").glob("*.hlsl")}
        self.assertGreater(len(wanted), 50)
        self.assertEqual(wanted - packed, set())


if __name__ == "__main__":
    unittest.main()
