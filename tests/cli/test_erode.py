"""Checks that `gabor erode` adds gullies to heightmaps of every format, that regions match the whole, and that tiles have no
seams."""

import json
import unittest

import numpy as np
from exr import Exr, write_exr
from png import read_deep_png
from program import ProgramTest

SIDE = 96


def hills(side=SIDE, rows=None):
    """Returns smooth heights in [0, 1] that tile along both axes."""
    x = 2 * np.pi * np.arange(side) / side
    y = 2 * np.pi * np.arange(rows or side)[:, None] / (rows or side)
    return (0.5 + 0.2 * np.sin(x + 1) * np.cos(y) + 0.2 * np.sin(2 * y - x)).astype("f4")


class Erode(ProgramTest):
    def setUp(self):
        super().setUp()
        self.map = hills()
        write_exr(self.folder / "map.exr", {"Y": self.map})

    def eroded(self, *options, map="map.exr"):
        self.succeed("erode", map, "-o", "out.exr", *options)
        return Exr(self.folder / "out.exr").channels

    def test_gullies_are_added_and_reported(self):
        out = self.eroded()
        self.assertEqual(set(out), {"height", "slope.x", "slope.y", "ridge", "erosion"})
        np.testing.assert_allclose(out["height"], self.map + out["erosion"], atol=1e-6)
        self.assertGreater(out["erosion"].std(), 0.01)
        self.assertLess(np.abs(out["ridge"]).max(), 1.001)
        self.assertGreater(out["ridge"].std(), 0.2)

    def test_without_octaves_the_map_stays_and_slopes_are_smoothed_differences(self):
        """The weights are 1, 4, 6, 4, 1 across the slope and -1, -2, 0, 2, 1 along it, divided by 128."""
        rough = np.random.default_rng(1).random((SIDE, SIDE), "f4")
        write_exr(self.folder / "rough.exr", {"Y": rough})
        across, along, pixel = np.array([1, 4, 6, 4, 1]), np.array([-1, -2, 0, 2, 1]), 8 / SIDE
        for options, mode in ([], "edge"), (["--tileable"], "wrap"):
            out = self.eroded("--octaves=0", "--extent=8", *options, map="rough.exr")
            np.testing.assert_array_equal(out["height"], rough)
            around = np.lib.stride_tricks.sliding_window_view(np.pad(rough, 2, mode=mode), (5, 5)) / (128 * pixel)
            np.testing.assert_allclose(out["slope.x"], np.einsum("yxji,j,i->yx", around, across, along), atol=1e-5)
            np.testing.assert_allclose(out["slope.y"], np.einsum("yxji,j,i->yx", around, along, across), atol=1e-5)

    def test_regions_match_the_whole(self):
        for tileable in ([], ["--tileable"]):
            whole = self.eroded(*tileable)
            for x, y, width, height in ((0, 0, 40, 30), (33, 21, 40, 50), (90, 94, 6, 2), (0, 1, 96, 1)):
                part = self.eroded(*tileable, f"--region={x},{y},{width},{height}")
                for name, values in whole.items():
                    np.testing.assert_array_equal(part[name], values[y:y + height, x:x + width], name)

    def test_tiles_have_no_seam(self):
        """Checks that a tile's steps across its edges are no larger than those inside, and that without --tileable they are larger."""
        def edges(values):
            return np.abs(values[0] - values[-1]).mean() + np.abs(values[:, 0] - values[:, -1]).mean()
        inner = lambda values: np.abs(np.diff(values, axis=0)).mean() + np.abs(np.diff(values, axis=1)).mean()
        tile, patch = self.eroded("--seed=3", "--tileable")["height"], self.eroded("--seed=3")["height"]
        # With seeds 1 to 12, edges / inner is 0.90 to 1.05 for tiles (mean 0.97) and 1.26 to 1.90 for patches (mean 1.55).
        self.assertLess(edges(tile), 1.15 * inner(tile))
        self.assertGreater(edges(patch), 1.3 * inner(patch))

    def test_bands_do_not_show(self):
        """Compares a map of several bands with a part of it that fits in one."""
        write_exr(self.folder / "wide.exr", {"Y": np.tile(hills(1024, 64), (24, 8))})
        whole = self.eroded(map="wide.exr")
        part = self.eroded("--region=100,200,64,64", map="wide.exr")
        for name, values in whole.items():
            np.testing.assert_array_equal(part[name], values[200:264, 100:164], name)

    def test_16_bits(self):
        levels = np.round(65535 * self.map)
        (self.folder / "map.r16").write_bytes(levels.astype("<u2").tobytes())
        from_raw = self.eroded("--size=96x96", "--elevation=-1,2", map="map.r16")
        base = from_raw["height"] - from_raw["erosion"]
        np.testing.assert_allclose(base, -1 + 3 * levels / 65535, atol=2e-6)
        for name in ("out.png", "out.r16"):
            ranges = set()
            for region in ([], ["--region=10,20,30,40"]):
                self.succeed("erode", "map.r16", "--size=96x96", "--elevation=-1,2", "-o", name, *region)
                scale = json.loads((self.folder / f"{name}.json").read_text())
                low, high = scale["elevation"]
                ranges.add((low, high))
                found = read_deep_png(self.folder / name) if name == "out.png" else np.fromfile(self.folder / name, "<u2")
                found = found.reshape(scale["height"], scale["width"])
                wanted = from_raw["height"][20:60, 10:40] if region else from_raw["height"]
                np.testing.assert_allclose(low + (high - low) * found / 65535, wanted, atol=0.51 * (high - low) / 65535 + 1e-6)
            self.assertEqual(len(ranges), 1)
            self.assertLess(low, -1)
        again = self.eroded("--elevation=-1,2", map="out.png") # the program reads what it writes
        self.assertEqual(again["height"].shape, (40, 30))

    def test_presets_and_options_change_the_shape(self):
        seen = [self.eroded()["height"]] # alps is the default preset
        np.testing.assert_array_equal(self.eroded("--preset=alps")["height"], seen[0])
        seen += [self.eroded(f"--preset={name}")["height"] for name in ("badlands", "canyon", "hills")]
        seen += [self.eroded(option)["height"] for option in
                 ("--octaves=2", "--gully-frequency=3", "--strength=0.05", "--lacunarity=2.5", "--gain=0.3", "--onset=2",
                  "--detail=5", "--uniformity=1", "--ridge-rounding=1", "--crease-rounding=1", "--gully-weight=1",
                  "--branching=0", "--seed=3", "--extent=5")]
        for i, one in enumerate(seen):
            for other in seen[:i]:
                self.assertGreater(np.abs(one - other).max(), 1e-3)

    def test_wrong_requests(self):
        (self.folder / "map.r16").write_bytes(b"\0" * 10)
        write_exr(self.folder / "nan.exr", {"Y": np.full((4, 4), np.nan, "f4")})
        for words, options in {
            ("-o 'out.tif'", ".exr, .png or .r16"): ("map.exr", "-o", "out.tif"),
            ("'none.exr'",): ("none.exr", "-o", "out.exr"),
            ("the map itself",): ("map.exr", "-o", "map.exr"),
            ("--size", "WIDTHxHEIGHT"): ("map.r16", "-o", "out.exr"),
            ("10 bytes", "take 18432"): ("map.r16", "--size=96x96", "-o", "out.exr"),
            ("--size is for .r16",): ("map.exr", "--size=96x96", "-o", "out.exr"),
            ("--elevation",): ("map.exr", "-o", "out.png"),
            ("LOW,HIGH",): ("map.exr", "--elevation=2,1", "-o", "out.png"),
            ("--region", "96 x 96"): ("map.exr", "--region=90,0,10,10", "-o", "out.exr"),
            ("--preset 'dunes'", "alps, badlands, canyon, hills"): ("map.exr", "--preset=dunes", "-o", "out.exr"),
            ("--octaves '2.5'", "whole number"): ("map.exr", "--octaves=2.5", "-o", "out.exr"),
            ("--gain '3'", "from 0 to 2"): ("map.exr", "--gain=3", "-o", "out.exr"),
            ("--extent",): ("map.exr", "--extent=0", "-o", "out.exr"),
            ("row 0", "finite"): ("nan.exr", "-o", "out.exr"),
        }.items():
            self.assert_refused(words, "erode", *options)


if __name__ == "__main__":
    unittest.main()
