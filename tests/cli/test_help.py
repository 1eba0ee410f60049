"""Tests `gabor devices`, --help and --version."""

import json
import pathlib
import re
import unittest

from program import ProgramTest


GULLIES = ("--octaves", "--gully-frequency", "--strength", "--lacunarity", "--gain", "--onset", "--detail", "--uniformity", "--ridge-rounding",
           "--crease-rounding", "--gully-weight", "--branching")


class Help(ProgramTest):
    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"\Agabor \d+\.\d+\.\d+\n\Z")

    def test_help_lists_every_command(self):
        self.assertEqual(self.succeed("--help"), self.succeed("-h"))
        for command in ("render", "erode", "join", "stats", "fit", "devices", "recipes", "materials"):
            self.assertRegex(self.succeed("--help"), rf"(?m)^ +{command} +[A-Z]")
            self.assertIn(f"gabor {command}", self.succeed(command, "--help"))

    def test_help_lists_every_option(self):
        options = {"render": ("-o,--output", "--size", "--scale", "--frequency", "--orientation", "--seed", "--recipe",
                              "--region", "--tileable", "--time", "--frames", "--frequency-spread",
                              "--orientation-spread", "--lobes", "--preset", "--paint", "--filter", "--view",
                              "--values", "--solid", "--depth", "--phasor", "--quadrature", "--gradient", "--like",
                              "--png", "--texture", "--half", "--level", "--compression", "--device", "--verbose", "--yaw", "--pitch",
                              "--zoom", "--material", "--terrain", "--heightmap", "--elevation", "--extent", *GULLIES,
                              "--maps", "--directx", "--light-azimuth", "--light-elevation", "--environment"),
                   "erode": ("MAP", "-o,--output", "--size", "--region", "--extent", "--elevation", "--preset", *GULLIES,
                             "--seed", "--tileable", "--device"),
                   "join": ("REGION", "-o,--output", "--texture", "--half"),
                   "fit": ("IMAGE", "-o,--output", "--lobes", "--glsl"),
                   "stats": ("FILE", "--channel", "--json"), "devices": (), "recipes": ("--json",), "materials": ("MATERIAL",)}
        for command, names in options.items():
            text = self.succeed(command, "--help")
            listed = {name.split(",--no-")[0] for name in re.findall(r"(?m)^  ([-\w,]+)(?: |$)", text)}
            self.assertEqual(listed, {"-h,--help", *names}, command)
            self.assertNotIn("TEXT", text)
        self.assertIn('[{"frequency": 4, "orientation": 45, "power": 1}]', self.succeed("render", "--help"))

    def test_recipes_match_the_page(self):
        page = (pathlib.Path(__file__).parents[2] / "docs" / "recipes.md").read_text()
        recipes = json.loads(self.succeed("recipes", "--json"))
        self.assertEqual([(recipe["file"], recipe["macros"]) for recipe in recipes[:3]],
                         [("gabor_noise.glsl", macros) for macros in ({}, {"GABOR_TAPS": "2"}, {"GABOR_TAPS": "4"})])
        text = self.succeed("recipes")
        for recipe in recipes:
            self.assertIn(f"{recipe['name']} ", text)
            self.assertIn(recipe["file"], text)
        self.assertEqual(re.findall(r"(?m)^\| `([\w-]+)` \| \d+ \|", page),
                         [recipe["name"] for recipe in recipes])
        for recipe in recipes:
            row = re.search(rf"(?m)^\| `{recipe['name']}` \| (\d+) \|.*\|([^|]*)\|$", page)
            self.assertEqual(int(row[1]), recipe["visited"])
            macros = dict(macro.split(" ", 1) for macro in re.findall(r"`([^`]+)`", row[2]))
            self.assertEqual(macros, recipe["macros"])
            for macro in recipe["macros"].items():
                self.assertIn("#define {} {}\n".format(*macro), text)

    def test_materials_and_their_options(self):
        materials = self.succeed("materials").split()
        self.assertEqual(len(materials), 12)
        for material in materials:
            options = re.findall(r"(?m)^--(\S+) +[A-Z].*\[\S+\]$", self.succeed("materials", material))
            self.assertTrue(5 <= len(options) <= 8, material)
            self.assertEqual({option.partition(".")[0] for option in options}, {material})
        self.assertRegex(self.succeed("materials", "wood"), r"--wood.rings +Growth rings per unit: a number from 2 to 60 \[13\]")

    def test_help_writes_nothing(self):
        self.succeed("render", "-o", "out.exr", "--help")
        self.assertEqual(self.files(), {})

    def test_devices(self):
        blocks = re.split(r"(?m)^(?=\d)", self.succeed("devices"))[1:]
        self.assertGreater(len(blocks), 0)
        for index, block in enumerate(blocks):
            self.assertRegex(block, rf"\A{index}  \S")
            for limit in ("kind", "driver", "Vulkan", "memory", "storage buffer", "workgroup", "GPU timing"):
                self.assertRegex(block, rf"(?m)^   {limit} +\S")
            self.assertRegex(block, r"(?m)^   memory +\d{2,7} MiB$")


if __name__ == "__main__":
    unittest.main()
