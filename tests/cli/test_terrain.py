"""Tests `gabor render --view terrain`, which draws eroded mountains."""

import json
import unittest

import numpy as np
from exr import Exr
from png import read_deep_png
from program import ProgramTest

GROUND = "render", "--view=terrain", "--size=160x96", "--seed=5"


class Terrain(ProgramTest):
    def drawn(self, *options, size="160x96"):
        self.succeed("render", "--view=terrain", f"--size={size}", "--seed=5", "-o", "out.exr", *options)
        return Exr(self.folder / "out.exr").channels

    def test_hills_plus_erosion_give_the_height(self):
        hills, mountains = self.drawn("--octaves=0"), self.drawn()
        self.assertEqual(set(mountains), {"R", "G", "B", "height", "slope.x", "slope.y", "lit.R", "lit.G", "lit.B", "ridge", "erosion"})
        self.assertGreater(hills["height"].std(), 0.1)
        self.assertGreater(mountains["erosion"].std(), 0.01)
        np.testing.assert_allclose(mountains["height"], hills["height"] + mountains["erosion"], atol=1e-6)
        self.assertGreater(mountains["ridge"].std(), 0.2)

    def test_the_slope_of_the_hills_matches_height_differences(self):
        hills, pixel = self.drawn("--octaves=0", "--scale=160"), 1 / 160
        for name, axis in (("slope.x", 1), ("slope.y", 0)):
            middle = np.take(hills[name], range(1, hills[name].shape[axis] - 1), axis)
            upper, lower = (np.take(hills["height"], range(start, hills[name].shape[axis] - 2 + start), axis) for start in (2, 0))
            np.testing.assert_allclose(middle, (upper - lower) / (2 * pixel), atol=0.002)

    def test_tiles_have_no_seam(self):
        tile = self.drawn("--tileable", "--scale=12", size="96x96")["height"]
        for tile in (tile, tile.T):
            steps = np.abs(np.diff(tile, axis=0))
            self.assertLess(np.abs(tile[0] - tile[-1]).mean(), 2 * steps.mean())
            self.assertLess(np.abs(tile[0] - tile[-1]).max(), 1.5 * steps.max())

    def test_units(self):
        small, large = self.drawn(), self.drawn("--extent=8000") # eight kernel radii
        for name, factor in (("height", 1000), ("erosion", 1000), ("slope.x", 1), ("ridge", 1)):
            np.testing.assert_allclose(large[name], factor * small[name], atol=2e-4 * factor)

    def test_regions_of_a_heightmap_have_the_range_of_the_whole(self):
        self.succeed(*GROUND, "--write-heightmap", "whole.png", "-o", "whole.exr", "--png", "view.png")
        self.succeed(*GROUND, "--write-heightmap", "part.r16", "--region=10,20,40,30")
        scales = [json.loads((self.folder / f"{name}.json").read_text()) for name in ("whole.png", "part.r16")]
        self.assertEqual(scales[0]["elevation"], scales[1]["elevation"])
        np.testing.assert_allclose([scale["extent"] for scale in scales], [[8, 4.8], [2, 1.5]])
        highest = 2 + 0.12 / 1.5 * sum(0.5**octave for octave in range(5))  # that of the hills, and the strength of each octave of gullies
        np.testing.assert_allclose(scales[0]["elevation"], [-highest, highest], rtol=1e-6)
        levels = read_deep_png(self.folder / "whole.png")
        part = np.frombuffer((self.folder / "part.r16").read_bytes(), "<u2").reshape(30, 40)
        np.testing.assert_array_equal(part, levels[20:50, 10:50])
        low, high = scales[0]["elevation"]
        heights = Exr(self.folder / "whole.exr").channels["height"]
        np.testing.assert_allclose(low + (high - low) * levels / 65535, heights, atol=(high - low) / 65535)
        self.assertGreater((self.folder / "view.png").stat().st_size, 10000)

    def test_a_heightmap_of_given_heights_is_clamped_to_them(self):
        heights = self.drawn("--extent=100")["height"].astype(float)
        low, high = np.quantile(heights, (0.1, 0.7)).round(1)
        for name in "a.png", "b.r16":
            self.succeed(*GROUND, "--extent=100", "--write-heightmap", name, f"--elevation={low},{high}")
            levels = read_deep_png(self.folder / name) if name == "a.png" else np.fromfile(self.folder / name, "<u2").reshape(96, 160)
            np.testing.assert_allclose(levels / 65535, np.clip((heights - low) / (high - low), 0, 1), atol=1e-5)
            scale = json.loads((self.folder / f"{name}.json").read_text())
            self.assertEqual(scale, {"width": 160, "height": 96, "extent": [100, 60], "elevation": [low, high]})

    def test_the_header_draws_it_again(self):
        expected = self.drawn("--preset=canyon", "--scale=20", "--octaves=3")
        self.succeed("render", "--like", "out.exr", "-o", "again.exr")
        np.testing.assert_array_equal(Exr(self.folder / "again.exr").channels["height"], expected["height"])

    def test_a_landscape_is_the_terrain_in_perspective(self):
        for width, height in (160, 120), (120, 160):
            size = f"--size={width}x{height}", "--scale=20", "--seed=5"
            self.succeed("render", "--view=landscape", *size, "--pitch=90", "--yaw=0", "-o", "down.exr")
            self.succeed("render", "--view=terrain", *size, "-o", "map.exr")
            # Looking straight down with a yaw of 0, the camera shows the middle of the map, with east at the top.
            down, above = (Exr(self.folder / f"{name}.exr").channels["height"] for name in ("down", "map"))
            row, middle = round(0.65 * height), width // 2
            self.assertAlmostEqual(down[row, middle], above[height // 2, middle], delta=0.1)
            self.assertAlmostEqual(down.std(), above.std(), delta=0.5 * above.std())
            down = np.rot90(down[row - 40:row + 40, middle - 40:middle + 40])
            above = above[height // 2 - 40:height // 2 + 40, middle - 40:middle + 40]
            self.assertGreater(np.corrcoef(down.ravel(), above.ravel())[0, 1], 0.98, size)
        self.succeed("render", "--view=landscape", "--size=160x120", "--scale=20", "--pitch=0", "-o", "sky.exr")
        sky = Exr(self.folder / "sky.exr").channels
        empty = sky["R"][:10] == 0
        self.assertGreater(empty.mean(), 0.2)
        self.assertGreater((sky["lit.B"] - sky["lit.R"])[:10][empty].min(), 0) # blue
        self.assertGreater(sky["R"][-1].min(), 0)

    def test_lakes_are_blue_and_keep_the_height_of_their_bed(self):
        dry, wet = self.drawn("--scale=10"), self.drawn("--scale=10", "--water-level=-0.1")
        np.testing.assert_array_equal(wet["height"], dry["height"])
        deep, high = wet["height"] < -0.25, wet["height"] > 0.05
        self.assertGreater(min(deep.mean(), high.mean()), 0.05)
        for of in "lit.", "":
            np.testing.assert_array_equal(wet[f"{of}G"][high], dry[f"{of}G"][high])
            self.assertGreater((wet[f"{of}B"] - wet[f"{of}R"])[deep].min(), 0)
            self.assertLess((dry[f"{of}B"] - dry[f"{of}R"])[deep].mean(), 0)

    def test_hills_before_a_camera_raise_it_above_them(self):
        for seed in range(6): # the camera looks along the ground, and its horizon is 0.65 of the picture's height below its top
            self.succeed("render", "--view=landscape", "--size=96x64", "--scale=12", f"--seed={seed}", "--pitch=0", "-o", "far.exr")
            ground = Exr(self.folder / "far.exr").channels["R"] > 0
            self.assertLess(ground[20].mean(), 0.4, f"seed {seed}") # a third of the height down
            self.assertGreater(ground[-1].mean(), 0.99, f"seed {seed}")

    def test_wrong_requests(self):
        for options, words in (([], ["--output is missing", "-o"]), (["-o", "a.tif"], ["a.tif", ".exr"]),
                               (["--write-heightmap", "a.tga"], ["a.tga", ".png, .r16, .raw, .r32, .exr, .tif or .tiff"]),
                               (["--png", "a.png", "--write-heightmap", "a.png"], ["--png and --write-heightmap both name 'a.png'"]),
                               (["-o", "a.png", "--write-heightmap", "./a.png"], ["-o and --write-heightmap both name 'a.png'"]),
                               (["-o", "a.exr", "--size=0x4"], ["--size"]), (["-o", "a.exr", "--extent=-1"], ["--extent"]),
                               (["-o", "a.exr", "--tileable", "--scale=32"], ["tile of 160 x 96", "128"]),
                               (["-o", "a.exr", "--frequency=2"], ["--frequency", "not terrain"]),
                               (["-o", "a.exr", "--preset=moon"], ["unknown preset 'moon'"]),
                               (["-o", "a.exr", "--octaves=2.5"], ["whole number"]),
                               (["-o", "a.exr", "--region=0,0,161,1"], ["--region"]),
                               (["--write-heightmap", "a.png", "--elevation=2,1"], ["LOW,HIGH"]),
                               (["-o", "a.exr", "--elevation=1,2"], ["--elevation", "--write-heightmap"])):
            with self.subTest(options):
                self.assert_refused(words, *GROUND, *options)
        for view in "landscape", "flat":
            self.assert_refused(["--write-heightmap needs --view terrain"], "render", f"--view={view}", "--size=8x8", "--write-heightmap=a.png")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
