"""Compares gabor.exe under Wine with gabor on Linux: files byte for byte, exit statuses and messages. GABOR_PROGRAM runs
gabor.exe in Wine, and GABOR_LINUX is the build for Linux."""

import os
import pathlib
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from exr import Exr  # noqa: E402
from program import ProgramTest, gabor  # noqa: E402

LINUX = os.environ["GABOR_LINUX"] + "/gabor"
PROJECT = pathlib.Path(__file__).parents[2]
PRESETS = PROJECT / "host" / "render" / "request" / "presets"
PICTURES = PROJECT / "tests" / "fuzz" / "corpus" / "picture"
SIZE = "--size=96x64"
LIBM = {"masks/masks.exr": 1e-5}  # degrees of slope, by atan of the C library, whose last bit differs


class Same(ProgramTest):
    commands = pairs = 0

    @classmethod
    def tearDownClass(cls):
        print(f"  {cls.commands} commands and {cls.pairs} pairs of files compared")

    def setUp(self):
        super().setUp()
        self.folders = {LINUX: self.folder / "linux", os.environ["GABOR_PROGRAM"]: self.folder / "windows"}
        for folder in self.folders.values():
            folder.mkdir()

    def compare(self, *arguments, status=0):
        """Runs both programs, each in its folder. Both folders must then have the same files."""
        results = [gabor(*arguments, cwd=folder, command=(program,)) for program, folder in self.folders.items()]
        linux, windows = ((result.returncode, result.stdout, result.stderr) for result in results)
        self.assertEqual(linux[0], status, linux[2])
        self.assertEqual(windows, linux)
        linux, windows = ({path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
                          for folder in self.folders.values())
        self.assertEqual(windows.keys(), linux.keys())
        differ = [str(name) for name in linux if windows[name] != linux[name]]
        for name in filter(LIBM.get, list(differ)):
            here, there = (Exr(folder / name) for folder in self.folders.values())
            self.assertEqual(there.attributes, here.attributes)
            largest = {channel: abs(there.channels[channel] - here.channels[channel]).max() for channel in here.channels}
            print(f"  {name} differs by at most {largest}")
            self.assertLess(max(largest.values()), LIBM[name])
            differ.remove(name)
        self.assertEqual(differ, [], arguments)
        Same.commands += 1
        Same.pairs += len(linux)

    def clear(self):
        for folder in self.folders.values():
            shutil.rmtree(folder)
            folder.mkdir()

    def test_presets(self):
        presets = sorted(path.stem for path in PRESETS.glob("*.json"))
        self.assertTrue(presets)
        for preset in presets:
            with self.subTest(preset):
                self.compare("render", "--preset", preset, "--png", "out.png", "-o", "out.exr", SIZE)
            self.clear()

    def test_noises(self):
        for options in (["--frequency=4", "--seed=3"], ["--orientation-spread=90", "--tileable"], ["--compression=zip"],
                        ["--recipe=paper"], ["--recipe=one"], ["--gradient", "--evolution=0.3"], ["--phasor", "--filter"],
                        ["--fractal=ridged", "--fractal.warp=1"], ["--view=sphere", "--solid"], ["--view=horizon", "--filter"],
                        [f"--paint={PICTURES / 'profile.jpg'}"], ["--frames=2"], ["--region=100,20,40,50"]):
            with self.subTest(options):
                self.compare("render", "-o", "out.exr", "--size=200x150", *options)
            self.clear()

    def test_materials(self):
        self.compare("maps", "--material=wood", "-o", "maps", "--size=128x128")
        self.compare("maps", "--preset=alps", "-o", "alps", "--size=128x128")
        self.compare("texture", "--material=leather", "--finish", "-o", "texture.exr", "--size=128x128")

    def test_terrain(self):
        for name in ("heights.png", "full.r16", "heights.tif", "heights.r32", "heights.exr"):
            full = ["--full-range"] if name == "full.r16" else []
            self.compare("render", "--view=terrain", "--extent=1000", "-o", "terrain.exr", "--write-heightmap", name, *full, SIZE)
        for name in ("heights.png", "heights.tif", "heights.exr"):
            for output in ("eroded.exr", "eroded.png", "eroded.tif"):
                self.compare("erode", name, "-o", output)
        self.compare("erode", "full.r16", SIZE, "-o", "eroded.exr", "--masks", "masks")
        self.compare("stats", "eroded.exr", "--json", "-")

    def test_formats_of_heights(self):
        for name in ("geo.tif", "grey16.png", "heights.npy"):
            with self.subTest(name):
                self.compare("erode", str(PICTURES / name), "--extent=100", "-o", "eroded.exr")
        for folder in self.folders.values():
            (folder / "map.asc").write_text("ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 2.5\nNODATA_value -9999\n"
                                            + "".join(" ".join(f"{x * y % 17 + x * .25:g}" for x in range(40)) + "\n" for y in range(40)))
        self.compare("erode", "map.asc", "-o", "eroded.tif")

    def test_join(self):
        for name, region in (("a.exr", "0,0,100,150"), ("b.exr", "100,0,100,150")):
            self.compare("render", "-o", name, "--size=200x150", f"--region={region}")
        self.compare("join", "a.exr", "b.exr", "-o", "joined.exr")
        self.compare("stats", "joined.exr")

    def test_texts(self):
        for arguments in (["--help"], ["--version"], ["recipes"], ["materials"], ["materials", "wood"], ["render", "--help"],
                          ["stats", "--help"], ["devices"]):
            with self.subTest(arguments):
                self.compare(*arguments)
        for arguments in (["render", "--frequncy=3", "-o", "q.exr"], ["render", "--frequency=abc", "-o", "q.exr"], ["stats", "none.exr"],
                          ["erode", "none.png", "-o", "q.exr"]):
            with self.subTest(arguments):
                self.compare(*arguments, status=2)


if __name__ == "__main__":
    unittest.main()
