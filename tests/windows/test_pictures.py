"""Compares gabor.exe under Wine with gabor on Linux: files byte for byte, exit statuses and messages. GABOR_PROGRAM runs
gabor.exe in Wine, and GABOR_LINUX is the program for Linux."""

import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, gabor  # noqa: E402

LINUX = os.environ["GABOR_LINUX"]
PRESETS = pathlib.Path(__file__).parents[2] / "host" / "render" / "request" / "presets"
SIZE = "--size=96x64"
MATERIALS = ("wood", "fabric", "leather", "marble", "sand", "brushed_metal", "scratches", "zebra", "bark", "carbon_fibre", "strata")


class Same(ProgramTest):
    def compare(self, *arguments):
        """Runs both programs in folders that already have equal files."""
        results = []
        for system, command in (("linux", {"command": (LINUX,)}), ("windows", {})):
            (self.folder / system).mkdir(exist_ok=True)
            results.append(gabor(*arguments, cwd=self.folder / system, **command))
        linux, windows = results
        self.assertEqual((windows.returncode, windows.stdout, windows.stderr), (linux.returncode, linux.stdout, linux.stderr))
        files = self.files()
        names = [name.partition("/")[2] for name in files if name.startswith("linux/")]
        self.assertEqual({name for name in files if "/" in name}, {f"{system}/{name}" for system in ("linux", "windows") for name in names})
        for name in names:
            self.assertTrue(files[f"linux/{name}"] == files[f"windows/{name}"], f"{arguments}: {name} differs")
        type(self).compared = getattr(type(self), "compared", 0) + len(names)

    def test_presets(self):
        presets = sorted(path.stem for path in PRESETS.glob("*.json"))
        self.assertTrue(presets)
        for preset in presets:
            with self.subTest(preset):
                self.compare("render", "--preset", preset, "--png", f"{preset}.png", "-o", f"{preset}.exr", SIZE)
        print(f"  {self.compared} pairs of files compared")

    def test_materials(self):
        for material in MATERIALS:
            with self.subTest(material):
                self.compare("render", "--material", material, "-o", f"{material}.exr", SIZE)
        self.compare("maps", "--material", "wood", "-o", "maps", "--size=128x128")

    def test_noises(self):
        for number, options in enumerate((("--frequency=4", "--seed=3"), ("--orientation-spread=90", "--half"),
                                          ("--position=123456789.25,-987654.5",), ("--compression=zip",), ("--tileable",),
                                          ("--recipe=paper",), ("--recipe=one",), ("--gradient",), ("--evolution=0.3",))):
            with self.subTest(options):
                self.compare("render", "-o", f"{number}.exr", "--size=200x150", *options)

    def test_terrain(self):
        self.compare("render", "--view=terrain", "--strength=0", "--heightmap", "heights.png", SIZE)
        self.compare("erode", "heights.png", "-o", "eroded.exr")
        self.compare("erode", "heights.png", "-o", "eroded.png")
        self.compare("stats", "eroded.exr", "--json", "-")

    def test_join(self):
        self.compare("render", "-o", "a.exr", "--size=200x150", "--region=0,0,100,150")
        self.compare("render", "-o", "b.exr", "--size=200x150", "--region=100,0,100,150")
        self.compare("join", "a.exr", "b.exr", "-o", "joined.exr")
        self.compare("stats", "joined.exr")

    def test_texts(self):
        for arguments in (["--help"], ["--version"], ["recipes"], ["materials"], ["materials", "wood"], ["render", "--help"],
                          ["stats", "--help"], ["render", "--frequncy=3", "-o", "q.exr"], ["render", "--frequency=abc", "-o", "q.exr"]):
            with self.subTest(arguments):
                self.compare(*arguments)


if __name__ == "__main__":
    unittest.main()
