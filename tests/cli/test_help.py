"""Tests `gabor devices`, --help and --version."""

import json
import pathlib
import re
import unittest

import numpy as np

from exr import write_exr
from program import ProgramTest, gabor

COMMANDS = ("render", "maps", "texture", "erode", "join", "stats", "fit", "devices", "recipes", "materials")

FRACTAL = ("--fractal", *(f"--fractal.{member}" for member in ("octaves", "gain", "lacunarity", "turn", "basis", "warp")))
GULLIES = ("--octaves", "--gully-frequency", "--strength", "--lacunarity", "--gain", "--onset-slope", "--detail", "--uniformity", "--ridge-rounding",
           "--crease-rounding", "--gully-weight", "--branching")


class Help(ProgramTest):
    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"\Agabor \d+\.\d+\.\d+\n\Z")

    def test_help_lists_every_command(self):
        self.assertEqual(self.succeed("--help"), self.succeed("-h"))
        for command in COMMANDS:
            self.assertRegex(self.succeed("--help"), rf"(?m)^ +{command} +[A-Z]")
            self.assertIn(f"gabor {command}", self.succeed(command, "--help"))

    def test_help_lists_every_option(self):
        options = {"render": ("-o,--output", "--size", "--scale", "--frequency", "--orientation", "--seed", "--recipe",
                              "--region", "--tileable", "--evolution", "--seconds", "--frames", "--frequency-spread",
                              "--orientation-spread", "--lobes", "--preset", "--paint", "--filter", "--view",
                              "--solid", "--depth", "--phasor", "--gradient", "--like",
                              "--png", "--compression", "--device", "--yaw", "--pitch",
                              "--zoom", "--focal-length", "--material", "--write-heightmap", "--full-range", "--elevation", "--extent", "--cover", "--water-level", "--boards", "--coat", "--finish",
                              "--wind", "--fetch", "--swell-height", "--swell-period", "--swell-direction", "--water-depth", "--loop-seconds", "--altitude",
                              "--light-azimuth", "--light-elevation", "--environment", *FRACTAL),
                   "maps": ("-o,--output", "--size", "--preset", "--like", "--width-metres", "--directx", "--normal-bits", "--texture", "--float",
                            "--compression", "--device", "--material", "--boards", "--coat", "--finish", "--scale", "--seed", "--view", "--tileable", "--extent", "--cover", "--water-level"),
                   "texture": ("-o,--output", "--size", "--preset", "--like", "--region", "--level", "--half", "--frames", "--device", "--material",
                               "--boards", "--coat", "--finish", "--scale", "--recipe", "--frequency", "--orientation", "--frequency-spread", "--orientation-spread",
                               "--lobes", "--seed", "--evolution", "--paint", "--gradient", "--phasor", "--view", "--tileable", "--light-azimuth",
                               "--light-elevation", "--environment", *FRACTAL),
                   "erode": ("MAP", "-o,--output", "--masks", "--size", "--region", "--extent", "--elevation", "--preset", *GULLIES,
                             "--gully-width", "--nodata", "--byte-order", "--encoding", "--full-range", "--only-height", "--offset", "--steepness", "--relief", "--compression", "--seed", "--tileable", "--device"),
                   "join": ("REGION", "-o,--output", "--texture", "--half"),
                   "fit": ("IMAGE", "-o,--output", "--lobes", "--glsl"),
                   "stats": ("FILE", "--channel", "--json"), "devices": (), "recipes": ("--json",), "materials": ("MATERIAL",)}
        for command, names in options.items():
            text = self.succeed(command, "--help")
            listed = re.findall(r"(?m)^  ((?:-|[A-Z]{2})[-\w.,]*)(?: |$)", text)
            self.assertCountEqual(listed, ["-h,--help", *names], command)  # each once

    def test_help_reads_well(self):
        for command in ([], *([command] for command in COMMANDS)):
            text = self.succeed(*command, "--help")
            self.assertLessEqual(max(map(len, text.splitlines())), 100, command)
            self.assertIsNone(re.search(r"TEXT|FLOAT|U?INT\b|RANGE|REQUIRED|Excludes|Needs| x \d\b(?! \d)| in \[|\{|\n\n\n",
                                        text.replace('[{"frequency": 4, ', "")), command)
        text = self.succeed("render", "--help")
        self.assertEqual(re.findall(r"(?m)^(\w.*):$", text),
                         ["Options", "Output", "Noise", "View and light", "Terrain", "Ocean", "Examples"])
        self.assertEqual(len(re.findall(r"(?m)^  gabor render ", text)), 3)

    def test_examples_are_accepted(self):
        """Each example in the help needs nothing but a device and the heightmap that it names."""
        self.succeed("render", "--size=24", "-o", "heights.png")
        examples = [example.split()[1:] for command in ([], ["render"], ["maps"], ["texture"]) for example in
                    re.findall(r"(?m)^  (gabor (?:render|maps|texture|erode) .*)$", self.succeed(*command, "--help").partition("Example")[2])]
        self.assertEqual(len(examples), 10)
        for example in examples:
            said = gabor(*example, "--device=none", cwd=self.folder)
            self.assertEqual(said.returncode, 2, example)
            self.assertIn("gabor: --device 'none' matches no device", said.stderr, example)

    def test_each_view_has_a_line_in_the_help(self):
        text = self.succeed("render", "--help").partition("--view NAME")[2]
        views = re.findall(r"(?m)^ {30}([\w, ]+): \w", text.partition("[flat]")[0])
        self.assertEqual(", ".join(views), "flat, horizon, slice, sphere, torus, terrain, landscape, ocean")

    def defaults(self, command):
        """Yields each option of a command that has a default, with the default: "V, or W in the X view" gives two."""
        for option in re.findall(r"(?m)^  (?:-o,)?(--.*\n(?: {30}.*\n)*)", self.succeed(command, "--help")):
            words = " ".join(option.split())
            if found := re.search(r"\[([^][{]+)\]$", words):
                value, *others = re.split(r", or (?=\S+ in the \w+ view)", found[1])
                yield words.split()[0], value, None
                for other, view in (re.fullmatch(r"(\S+) in the (\w+) view", other).groups() for other in others):
                    yield words.split()[0], other, view

    def test_leaving_an_option_out_is_the_same_as_giving_its_default(self):
        write_exr(self.folder / "map.exr", {"Y": np.random.default_rng(1).random((24, 24), "f4")})
        (self.folder / "map.r16").write_bytes(np.arange(24 * 24, dtype="<u2").tobytes())
        terrain = ["--view=terrain", "--write-heightmap=out.png"]
        which = {**dict.fromkeys(("--yaw", "--pitch", "--zoom", "--light-azimuth", "--light-elevation", "--environment"), ["--material=sand", "--view=sphere"]), "--depth": ["--view=slice"], "--focal-length": ["--view=landscape"],
                 **dict.fromkeys(("--wind", "--fetch", "--swell-height", "--swell-period", "--swell-direction", "--water-depth", "--loop-seconds", "--seconds", "--altitude"), ["--view=ocean"]), **dict.fromkeys(FRACTAL[1:], ["--fractal=fbm"]), "--extent": terrain, "--cover": terrain, "--water-level": terrain, "--elevation": terrain}
        meant = {"all of it": "0,0,24,24", "a GPU, if there is one": "0", "the full possible range": None, "0 to extent/8 if --extent is given, else 0,1000": "0,1000"}
        for command, number in ("render", 47), ("erode", 18):
            found = [(option, meant.get(value, value), view) for option, value, view in self.defaults(command)]
            self.assertEqual(len(found), number, found)
            given = {}  # the defaults of each command line's options; a file of heights has a range of its own
            for option, value, view in found:
                command_line = [command, "-o", "out.exr"]
                if command == "erode":
                    command_line += ["map.r16", "--size=24x24"] if option == "--elevation" else ["map.exr"]
                else:
                    command_line += [f"--view={view}"] if view else which.get(option, [])
                    command_line += ["--region=0,0,24,24"] if option == "--size" else ["--size=24x24"]
                given.setdefault(tuple(command_line), {})[option] = value
            for command_line, values in given.items():
                self.succeed(*command_line)
                files = self.files()
                for option, value in values.items():
                    if value is None:  # the JSON beside the heights has the range
                        values[option] = ",".join(map(str, json.loads(files["out.png.json"])["elevation"]))
                self.succeed(*command_line, *(f"{option}={value}" for option, value in values.items()))
                self.assertEqual(self.files(), files, (command_line, values))

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
        self.assertEqual(len(materials), 11)
        for material in [*materials, "boards", "coat", "finish"]:
            options = re.findall(r"(?m)^--(\S+) +[A-Z].*\[\S+\]$", self.succeed("materials", material))
            self.assertTrue(5 <= len(options) <= 14, material)
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
            self.assertRegex(block, r"(?m)^   storage buffer +\d{3,7} MiB at most$") # Vulkan demands 128 MiB
            group, subgroup = map(int, re.search(r"(?m)^   workgroup +(\d+) invocations at most, (\d+) per subgroup$", block).groups())
            self.assertGreaterEqual(group, 128) # as Vulkan demands
            self.assertLessEqual(subgroup, 128)
            if "llvmpipe" in block:
                self.assertIn("   GPU timing      yes\n", block)
            if "llvmpipe Mesa 22.3" in block:
                self.assertIn("   memory          2048 MiB\n   storage buffer  128 MiB at most\n", block)


if __name__ == "__main__":
    unittest.main()
