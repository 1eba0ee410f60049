"""Checks that `gabor erode` adds gullies to heightmaps of every format, that regions match the whole, and that tiles have no
seams."""

import itertools
import json
import pathlib
import re
import unittest

import matplotlib
import numpy as np
import PIL.Image
from exr import Exr, write_exr
from png import read_deep_png
from program import ProgramTest, gabor
from tiff import write_tiff

SIDE = 96


def hills(side=SIDE, rows=None):
    """Returns smooth heights in [0, 1] that tile along both axes."""
    x = 2 * np.pi * np.arange(side) / side
    y = 2 * np.pi * np.arange(rows or side)[:, None] / (rows or side)
    return (0.5 + 0.2 * np.sin(x + 1) * np.cos(y) + 0.2 * np.sin(2 * y - x)).astype("f4")


def spline(pixels, spacing, wrap):
    """Returns the share of each node of a uniform cubic B-spline at the centre of each pixel, and the nodes per pixel."""
    count = round(min(max(pixels / spacing, 3), pixels))
    at = (np.arange(pixels) + 0.5) * count / pixels
    distance = np.abs(at[:, None] - np.arange(-1, count + 2))
    share = np.where(distance < 1, 2 / 3 - distance**2 + distance**3 / 2, np.clip(2 - distance, 0, None)**3 / 6)
    if wrap:  # the last three nodes are the first three
        share[:, :3] += share[:, -3:]
        share[:, -3:] = share[:, :3]
    return share, count / pixels


def rms_slope(heights, spacing, wrap):
    """Returns the rms slope per pixel at the nodes of a spline, each of which is a mean of the pixels that it reaches, without NaN."""
    (down, rows), (across, columns) = (spline(pixels, spacing, wrap) for pixels in heights.shape)
    known = np.isfinite(heights)
    weights = down.T @ known @ across
    nodes = down.T @ np.where(known, heights, 0) @ across / np.where(weights > 1e-9, weights, np.nan)
    along, beside = np.array([-1, 0, 1]) / 2, np.array([1, 4, 1]) / 6
    around = np.lib.stride_tricks.sliding_window_view(nodes, (3, 3))
    return np.sqrt(np.nanmean((columns * np.einsum("yxji,j,i->yx", around, beside, along))**2
                              + (rows * np.einsum("yxji,j,i->yx", around, along, beside))**2))


def minima(heights):
    """Returns how many pixels are lower than their eight neighbours."""
    around = np.lib.stride_tricks.sliding_window_view(heights, (3, 3)).reshape(-1, 9)
    return np.sum(around[:, 4] < np.delete(around, 4, axis=1).min(1))


class Erode(ProgramTest):
    def setUp(self):
        super().setUp()
        self.map = hills()
        write_exr(self.folder / "map.exr", {"Y": self.map})

    def eroded(self, *options, map="map.exr"):
        wide = [] if any("gully" in option for option in options) else ["--gully-frequency=1"]  # the map is small
        self.succeed("erode", map, "-o", "out.exr", *wide, *options)
        return Exr(self.folder / "out.exr").channels

    def test_gullies_are_added_and_reported(self):
        out = self.eroded()
        self.assertEqual(set(out), {"Y", "slope.x", "slope.y", "ridge", "erosion"})
        np.testing.assert_allclose(out["Y"], self.map + out["erosion"], atol=1e-6)
        self.assertGreater(out["erosion"].std(), 0.005)
        self.assertLess(np.abs(out["ridge"]).max(), 1.001)
        self.assertGreater(out["ridge"].std(), 0.2)

    def test_without_octaves_the_map_stays_and_slopes_are_smoothed_differences(self):
        """The weights are 1, 2, 1 across the slope and -1, 0, 1 along it, divided by 8."""
        rough = np.random.default_rng(1).random((SIDE, SIDE), "f4")
        write_exr(self.folder / "rough.exr", {"Y": rough})
        across, along, pixel = np.array([1, 2, 1]), np.array([-1, 0, 1]), 8 / SIDE
        for options, mode in ([], "edge"), (["--tileable"], "wrap"):
            out = self.eroded("--octaves=0", "--extent=8", *options, map="rough.exr")
            np.testing.assert_array_equal(out["Y"], rough)
            around = np.lib.stride_tricks.sliding_window_view(np.pad(rough, 1, mode=mode), (3, 3)) / (8 * pixel)
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
        tile, patch = self.eroded("--seed=6", "--tileable")["erosion"], self.eroded("--seed=6")["erosion"]
        # With seeds 1 to 12, edges / inner is 0.55 to 0.94 for tiles (mean 0.78) and 0.86 to 2.08 for patches (mean 1.25).
        self.assertLess(edges(tile), 1.15 * inner(tile))
        self.assertGreater(edges(patch), 1.3 * inner(patch))

    def test_bands_do_not_show(self):
        """Compares a map of several bands with a part of it that fits in one."""
        write_exr(self.folder / "wide.exr", {"Y": np.tile(hills(1024, 64), (6, 8))})
        whole = self.eroded(map="wide.exr")
        part = self.eroded("--region=100,200,64,64", map="wide.exr")
        for name, values in whole.items():
            np.testing.assert_array_equal(part[name], values[200:264, 100:164], name)

    def test_16_bits(self):
        levels = np.round(65535 * self.map)
        (self.folder / "map.r16").write_bytes(levels.astype("<u2").tobytes())
        from_raw = self.eroded("--size=96x96", "--elevation=-1,2", map="map.r16")
        base = from_raw["Y"] - from_raw["erosion"]
        np.testing.assert_allclose(base, -1 + 3 * levels / 65535, atol=2e-6)
        for name in ("out.png", "out.r16"):
            ranges = set()
            for region in ([], ["--region=10,20,30,40"]):
                self.succeed("erode", "map.r16", "--size=96x96", "--elevation=-1,2", "--gully-frequency=1", "-o", name, *region)
                scale = json.loads((self.folder / f"{name}.json").read_text())
                low, high = scale["elevation"]
                ranges.add((low, high))
                found = read_deep_png(self.folder / name) if name == "out.png" else np.fromfile(self.folder / name, "<u2")
                found = found.reshape(scale["height"], scale["width"])
                wanted = from_raw["Y"][20:60, 10:40] if region else from_raw["Y"]
                np.testing.assert_allclose(low + (high - low) * found / 65535, wanted, atol=0.51 * (high - low) / 65535 + 1e-6)
            self.assertEqual(len(ranges), 1)
            self.assertLess(low, from_raw["Y"].min())
            self.assertGreater(high, from_raw["Y"].max())
        again = self.eroded("--elevation=-1,2", map="out.png") # the program reads what it writes
        self.assertEqual(again["Y"].shape, (40, 30))
        self.assertNotIn("guess", self.succeed("erode", "out.png", "-o", "same.exr")) # and its scale
        stated = [f"--elevation={low},{high}", f"--extent={scale['extent'][0]}"]
        self.succeed("erode", "out.png", "-o", "stated.exr", *stated)
        for name, values in Exr(self.folder / "stated.exr").channels.items():
            np.testing.assert_array_equal(Exr(self.folder / "same.exr").channels[name], values)
        for others in '{"extent": 4}', '{"elevation": [2, 1], "extent": [4, 4]}', '{"elevation": [1, 2], "extent": [0, 0]}', '{"extent": [1, 2]}':
            (self.folder / "out.png.json").write_text(others) # another program's
            self.assertIn("guess", self.succeed("erode", "out.png", "-o", "same.exr"))
        (self.folder / "out.png.json").write_text('{"elevation": [0, 0.1], "extent": [0.5, 0.5]}') # a narrow map
        self.assertNotIn("guess", self.succeed("erode", "out.png", "-o", "same.exr"))
        heights = self.eroded("--size=96x96", "--extent=400", "--octaves=0", map="map.r16")["Y"]
        np.testing.assert_allclose(heights, 400 / 8 * levels / 65535, atol=1e-5)

    def test_erosion_is_in_proportion_to_the_map(self):
        """A map that is higher, wider or both erodes in proportion, and --gully-width has the unit of --extent."""
        seen = self.eroded("--extent=8")["erosion"]
        write_exr(self.folder / "high.exr", {"Y": 300 * self.map})
        high = self.eroded("--extent=900", map="high.exr")
        np.testing.assert_allclose(high["erosion"], 300 * seen, atol=300 * 2e-5)
        for width in 1, 2:
            np.testing.assert_array_equal(self.eroded("--extent=8", f"--gully-width={width}")["erosion"],
                                          self.eroded("--extent=8", f"--gully-frequency={1 / width}")["erosion"])

    def test_a_map_is_smoothed_by_a_spline_and_its_rms_slope_gives_its_extent(self):
        """Nodes are a seventh of the widest gully apart, and an rms slope of 0.2 is taken as typical."""
        rough = np.random.default_rng(1).random((70, SIDE), "f4")
        rough[np.add.outer(2 * np.arange(70), np.arange(SIDE)) > 150] = np.nan
        write_exr(self.folder / "rough.exr", {"Y": np.nan_to_num(rough, nan=-9999)})
        for options, frequency in ([], 0.5), (["--tileable"], 0.7), ([], 3):  # with the last, one node for each pixel
            self.eroded("--octaves=0", "--nodata=-9999", f"--gully-frequency={frequency}", *options, map="rough.exr")
            parameters, expected = Exr(self.folder / "out.exr").parameters, rms_slope(rough, max(SIDE / 8 / frequency / 7, 1), bool(options))
            found = parameters["slope"] * parameters["extent"][0] / SIDE
            print(f"rms slope {found:.6f} per pixel for {expected:.6f}")
            self.assertAlmostEqual(found / expected, 1, delta=1e-5)
            self.assertEqual(parameters["slope"], 0.2)
            self.assertAlmostEqual(parameters["extent"][1] / parameters["extent"][0], 70 / SIDE, delta=1e-9)

    def test_maps_get_finer_gullies_and_rounder_creases_than_views(self):
        for name in "alps", "canyon":
            self.succeed("erode", "map.exr", "-o", "out.exr", f"--preset={name}", "--octaves=0")
            found = Exr(self.folder / "out.exr").parameters
            preset = json.loads((pathlib.Path(__file__).parents[2] / f"host/render/request/presets/{name}.json").read_text())
            for option, factor, by_default in ("gully_frequency", 1.5, 1.5), ("crease_rounding", 4, 0.1), ("gain", 1, 0.5):
                self.assertAlmostEqual(float(found[option]), factor * preset.get(option, by_default), msg=(name, option))
            self.assertEqual(float(found["onset_slope"]), 2 * 0.637)
            self.assertEqual(found["seed"], "0")
        self.succeed("erode", "map.exr", "-o", "out.exr", "--strength=0.15")
        found = Exr(self.folder / "out.exr").parameters
        module = (pathlib.Path(__file__).parents[2] / "packages/pypi/gabor_noise/__init__.py").read_text()
        for option, value in re.findall(r'"(\w+)": ([\d.]+)', re.search(r"_OF_MAPS = {(.*)}", module)[1].replace("2 * _SLOPE", "1.274")):
            self.assertEqual(float(found[option]), float(value), option)  # Python's erode has the same defaults

    def test_both_axes_are_alike(self):
        """A map that is not square and the same map with x and y exchanged."""
        seen = []
        for name, heights in ("map", hills(96, 160)), ("turned", hills(96, 160).T):
            write_exr(self.folder / f"{name}.exr", {"Y": heights})
            self.succeed("erode", f"{name}.exr", "-o", "out.exr", "--octaves=0", f"--extent={heights.shape[1] / 12}", "--gully-width=1")
            seen.append(Exr(self.folder / "out.exr"))
        one, turned = seen
        self.assertAlmostEqual(one.parameters["slope"], turned.parameters["slope"], delta=1e-6)
        self.assertEqual(one.parameters["heights"], turned.parameters["heights"])
        for name, other in ("Y", "Y"), ("slope.x", "slope.y"), ("slope.y", "slope.x"):
            np.testing.assert_allclose(one.channels[name], turned.channels[other].T, atol=1e-5, err_msg=name)

    def test_slopes_are_those_of_the_heights(self):
        rows, columns = 512, 768
        write_exr(self.folder / "large.exr", {"Y": hills(columns, rows)})
        out = self.eroded("--extent=8", map="large.exr")
        for name, axis in ("slope.x", 1), ("slope.y", 0):
            found = np.gradient(out["Y"].astype(float), 8 / columns, axis=axis)
            error = (out[name] - found)[4:-4, 4:-4]
            self.assertLess(error.std(), 0.1 * found.std(), name)  # of gullies as fine as pixels; 0.6 without their slope

    def test_pixels_without_a_height_stay_and_do_not_steer(self):
        holes = self.map.copy()
        holes[40:50, 30:60] = -9999
        write_exr(self.folder / "holes.exr", {"Y": holes})
        out = self.eroded("--nodata=-9999", map="holes.exr")
        missing = holes == -9999
        self.assertTrue((out["Y"][missing] == -9999).all())
        for name in ("slope.x", "slope.y", "ridge", "erosion"):
            self.assertEqual(np.abs(out[name][missing]).max(), 0)
        whole = self.eroded()
        far = np.ones_like(missing)
        far[16:74, 6:84] = False
        self.assertLess(np.abs(out["erosion"] - whole["erosion"])[far].max(), 0.1 * np.abs(whole["erosion"]).max())
        self.assertLess(np.abs(out["slope.x"])[~missing].max(), 2 * np.abs(whole["slope.x"]).max())

    def test_pixels_without_a_height_leave_the_rms_slope(self):
        slopes = []
        for missing in 0, 48:
            ramp = np.repeat(np.arange(96, dtype="f4")[:, None], 96, axis=1)
            ramp[:, 96 - missing:] = -9999
            write_exr(self.folder / "ramp.exr", {"Y": ramp})
            self.eroded("--nodata=-9999", map="ramp.exr")
            slopes.append(Exr(self.folder / "out.exr").parameters["slope"])
        self.assertAlmostEqual(*slopes, places=6)

    def test_a_real_map_without_options(self):
        """A part of 64 x 64 texels is one mountainside, the whole has 140000 texels of hills and plains."""
        source = pathlib.Path(matplotlib.get_data_path(), "sample_data", "jacksboro_fault_dem.npz")
        whole = np.load(source)["elevation"].astype("f4")
        for heights in whole, whole[200:264, 20:84]:
            write_exr(self.folder / "real.exr", {"Y": heights})
            self.succeed("erode", "real.exr", "-o", "out.exr")
            out = Exr(self.folder / "out.exr").channels
            change = out["erosion"].astype(float) / np.ptp(heights)
            rms = np.sqrt(np.mean(change**2))
            ratio = minima(out["Y"]) / minima(heights)
            print(f"{heights.shape}: largest change {np.abs(change).max():.3f} of the relief, rms {rms:.4f}, minima {ratio:.2f} times")
            self.assertLess(np.abs(change).max(), 1 / 8)
            self.assertTrue(0.005 < rms < 0.04)
            self.assertLess(ratio, 2.5)

    def test_without_strength_heights_change_by_an_eighth_at_most(self):
        """Of a range of hills, whose summits are low for so many slopes."""
        many = np.tile(hills(64), (6, 6))
        write_exr(self.folder / "many.exr", {"Y": many})
        limited, given = (np.abs(self.eroded(*options, map="many.exr")["erosion"]).max() / np.ptp(many)
                          for options in ([], ["--strength=0.15"]))
        self.assertTrue(0.11 < limited < 0.1251, limited)
        self.assertGreater(given, 0.14)

    def test_the_content_decides_the_format(self):
        levels = np.round(65535 * self.map).astype("<u2")
        (self.folder / "map.raw").write_bytes(levels.tobytes())
        (self.folder / "map.r16").write_bytes(levels.tobytes())
        (self.folder / "map.r32").write_bytes(self.map.astype("<f4").tobytes())
        raw, integers = (self.eroded("--size=96x96", map=f"map.{kind}") for kind in ("raw", "r16"))
        floats, exr = self.eroded("--size=96x96", map="map.r32"), self.eroded()
        np.testing.assert_array_equal(raw["Y"], integers["Y"])
        np.testing.assert_array_equal(floats["Y"], exr["Y"])
        for name in "named.png", "named.raw":
            (self.folder / name).write_bytes((self.folder / "map.exr").read_bytes())
            np.testing.assert_array_equal(self.eroded(map=name)["Y"], exr["Y"])
        (self.folder / "named.exr").write_bytes((self.folder / "map.r32").read_bytes())
        np.testing.assert_array_equal(self.eroded("--size=96", map="named.exr")["Y"], exr["Y"])
        grey = np.round(255 * self.map).astype("u1")
        PIL.Image.fromarray(np.dstack([grey] * 3)).save(self.folder / "rgb.png")
        PIL.Image.fromarray(grey).save(self.folder / "grey.png")
        seen = []
        for name in "rgb.png", "grey.png":
            result = gabor("erode", name, "-o", "out.exr", cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, f"gabor: warning: '{name}' has 8 bits per height: its steps show as terraces\n"))
            seen.append(Exr(self.folder / "out.exr").channels["Y"])
        np.testing.assert_array_equal(*seen)

    def test_tiffs(self):
        """Without octaves, the output has the heights of the map. Levels have --elevation, from 0 to 65535."""
        def base(*options):
            return self.eroded("--octaves=0", "--extent=8", *options, map="map.tif")["Y"]
        values = np.round(3000 * hills(96, 70)) - 1000
        layouts = [*itertools.product((None, (16, 32), (128, 128)), (False, True))]
        for number, kind in enumerate(("<i2", ">i2", "<f4", ">f4", "<u2", ">u2")):
            for big, (tile, deflate) in enumerate((layouts[number], layouts[number - 3])):
                wanted = values + 1000 if "u" in kind else values
                write_tiff(self.folder / "map.tif", wanted.astype(kind), tile, deflate, big)
                found = base("--elevation=0,65535") if "u" in kind else base()
                np.testing.assert_allclose(found, wanted, rtol=1e-6, err_msg=f"{kind} {tile} {deflate}")
        levels = PIL.Image.fromarray((values + 1000).astype("<u2"))
        for compression in "packbits", "tiff_lzw", "tiff_adobe_deflate":
            levels.save(self.folder / "map.tif", compression=compression, tiffinfo={317: 2})  # differences
            np.testing.assert_allclose(base("--elevation=0,65535"), values + 1000, rtol=1e-6, err_msg=compression)

    def test_missing_heights_are_those_in_the_file(self):
        for kind in "u1", "<u2":
            levels = np.round(200 * self.map).astype(kind)
            levels[40:50, 30:60] = 7
            PIL.Image.fromarray(levels).save(self.folder / "map.png")
            gabor("erode", "map.png", "-o", "out.exr", "--gully-frequency=1", "--extent=500", "--nodata=7", cwd=self.folder)
            out = Exr(self.folder / "out.exr")
            np.testing.assert_array_equal(out.channels["erosion"] == 0, levels == 7, kind)
            np.testing.assert_allclose(out.channels["Y"][levels == 7], out.parameters["nodata"], rtol=1e-6, err_msg=kind)

    def test_pieces_of_different_maps_are_not_joined(self):
        write_exr(self.folder / "other.exr", {"Y": 0.9 * self.map})
        self.succeed("erode", "map.exr", "-o", "left.exr", "--region=0,0,48,96")
        self.succeed("erode", "map.exr", "-o", "right.exr", "--region=48,0,48,96")
        self.succeed("join", "left.exr", "right.exr", "-o", "joined.exr")
        self.succeed("erode", "map.exr", "-o", "whole.exr")
        np.testing.assert_array_equal(Exr(self.folder / "joined.exr").channels["Y"], Exr(self.folder / "whole.exr").channels["Y"])
        self.assertRegex(Exr(self.folder / "left.exr").attributes["software"][1], rb"\Agabor [0-9.]+, ")
        for options in (["other.exr"], *(["map.exr", option] for option in
                        ("--seed=2", "--strength=0.1", "--preset=hills", "--extent=9", "--nodata=7", "--tileable"))):
            self.succeed("erode", *options, "-o", "right.exr", "--region=48,0,48,96")
            self.assert_refused(("right.exr",), "join", "left.exr", "right.exr", "-o", "bad.exr")

    def test_an_exr_keeps_its_heights_and_its_place(self):
        self.succeed("render", "--view=terrain", "--size=200x150", "--region=60,40,48,32", "-o", "part.exr")
        part = Exr(self.folder / "part.exr")
        heights = self.eroded("--octaves=0", map="part.exr")["Y"]
        np.testing.assert_array_equal(heights, part.channels["height"])
        self.assertEqual(Exr(self.folder / "out.exr").box("dataWindow"), (60, 40, 107, 71))
        corner = self.eroded("--octaves=0", "--region=40,20,8,12", map="part.exr")["Y"]
        np.testing.assert_array_equal(corner, heights[20:, 40:])
        self.assertEqual(Exr(self.folder / "out.exr").box("dataWindow"), (100, 60, 107, 71))

    def test_masks(self):
        """The shares of the ground are those with which the terrain view mixes its colours, for heights from -1 to 1."""
        options, folder = ["--extent=500", "--nodata=7", "--gully-frequency=1"], self.folder / "masks"
        heights = (50 + 300 * self.map).astype("f4")
        heights[70:80, 60:90] = 7
        write_exr(self.folder / "hills.exr", {"Y": heights})
        plain = self.eroded(*options, map="hills.exr")
        for x, y, width, height in (0, 0, SIDE, SIDE), (10, 20, 30, 40):
            region = slice(y, y + height), slice(x, x + width)
            out = self.eroded(*options, f"--region={x},{y},{width},{height}", "--masks=masks", map="hills.exr")
            self.assertEqual(set(out), set(plain))
            for name in plain:
                np.testing.assert_allclose(out[name], plain[name][region], rtol=1e-6, atol=1e-6, err_msg=name)
            masks = {name: values.astype(float) for name, values in Exr(folder / "masks.exr").channels.items()}
            scale = json.loads((folder / "masks.json").read_text())
            self.assertEqual([scale["width"], scale["height"]], [width, height])
            self.assertEqual(scale["masks"], {**dict.fromkeys(scale["masks"], [0, 1]), "slope": [0, 90], "erosion": scale["masks"]["erosion"]})
            low, high = scale["masks"]["erosion"]
            self.assertEqual(low, -high)
            self.assertGreaterEqual(high, np.abs(out["erosion"]).max())
            np.testing.assert_allclose(scale["extent"], [500 / SIDE * width, 500 / SIDE * height])
            self.assertEqual(scale["missing"], 7)
            np.testing.assert_array_equal(masks.pop("Y"), out["Y"].astype(float))
            self.assertEqual({path.name for path in folder.iterdir()},
                             {"masks.exr", "masks.json", *(f"{name}.png" for name in scale["masks"])})
            for name, (low, high) in scale["masks"].items():
                wanted = np.clip((masks[name] - low) / (high - low), 0, 1)
                self.assertLessEqual(np.abs(read_deep_png(folder / f"{name}.png") - 65535 * wanted).max(), 0.51, name)

            smooth = lambda low, high, x: (lambda t: t * t * (3 - 2 * t))(np.clip((x - low) / (high - low), 0, 1))
            there, known = heights[region] != 7, heights[heights != 7]
            relative = 2 * (out["Y"].astype(float) - known.min()) / np.ptp(known) - 1
            slope = np.hypot(out["slope.x"], out["slope.y"]).astype(float)
            scree, rock = smooth(-0.3, 0.35, relative + 0.1 * out["ridge"]), smooth(0.55, 1, slope)
            snow = smooth(0.42, 0.62, relative + 0.08 * out["ridge"]) * (1 - smooth(1.0, 1.9, slope))
            for name, wanted in {"ridge": np.maximum(out["ridge"], 0), "crease": np.maximum(-out["ridge"], 0),
                                 "slope": np.degrees(np.arctan(slope)), "erosion": out["erosion"],
                                 "grass": there * (1 - scree) * (1 - rock) * (1 - snow), "scree": there * scree * (1 - rock) * (1 - snow),
                                 "rock": there * rock * (1 - snow), "snow": there * snow}.items():
                np.testing.assert_allclose(masks.pop(name), wanted, atol=2e-4, err_msg=name)
                self.assertGreater(wanted.max(), 0.3, name)
            self.assertFalse(masks)

    def test_presets_and_options_change_the_shape(self):
        seen = [self.eroded()["Y"]] # alps is the default preset
        np.testing.assert_array_equal(self.eroded("--preset=alps")["Y"], seen[0])
        seen += [self.eroded(f"--preset={name}")["Y"] for name in ("badlands", "canyon", "hills")]
        seen += [self.eroded(option)["Y"] for option in
                 ("--octaves=2", "--gully-frequency=3", "--strength=0.05", "--lacunarity=2.5", "--gain=0.3", "--onset-slope=2",
                  "--detail=5", "--uniformity=1", "--ridge-rounding=1", "--crease-rounding=1", "--gully-weight=1",
                  "--branching=0", "--seed=3")]
        for i, one in enumerate(seen):
            for other in seen[:i]:
                self.assertGreater(np.abs(one - other).max(), 1e-3)

    def test_wrong_requests(self):
        (self.folder / "map.r16").write_bytes(b"\0" * 10)
        write_tiff(self.folder / "map.tif", self.map, (16, 16), True)
        (self.folder / "cut.tif").write_bytes((self.folder / "map.tif").read_bytes()[:-100])
        (self.folder / "damaged.tif").write_bytes((self.folder / "map.tif").read_bytes().replace(b"\x78\x9c", b"\x78\x9d"))
        write_tiff(self.folder / "halves.tif", np.ones((4, 4), "<f2"))
        write_tiff(self.folder / "colours.tif", np.ones((4, 4), "<u2"), t277=("H", 3))
        for name, tag in ("inverted", {"t262": ("H", 0)}), ("turned", {"t274": ("H", 3), "t339": ("H", 2)}), ("untyped", {"t339": ("H", 4)}):
            write_tiff(self.folder / f"{name}.tif", np.ones((4, 4), "<u2"), **tag)
        write_tiff(self.folder / "long.tif", np.ones((100000, 4), "<u2"))
        write_tiff(self.folder / "heavy.tif", np.ones((16, 16), "<u2"), (16, 16), t323=("I", 1 << 28))
        write_exr(self.folder / "nan.exr", {"Y": np.full((4, 4), np.nan, "f4")})
        write_exr(self.folder / "flat.exr", {"Y": np.ones((4, 4), "f4")})
        pit = np.ones((4, 4), "f4")
        for name, absurd in ("pit", -9999), ("pit_5", -99999), ("pit_16", -32768), ("pit_15", -32767), ("pit_9", 1e9):
            pit[1, 2] = absurd
            write_exr(self.folder / f"{name}.exr", {"Y": pit})
        for channel in range(3):
            colour = np.full((4, 4, 3), 9, "u1")
            colour[1, 2, channel] = 8
            PIL.Image.fromarray(colour).save(self.folder / f"colour{channel}.png")
        for words, options in {
            ("-o 'out.jpg'", ".png, .r16, .raw, .r32, .exr, .tif or .tiff"): ("map.exr", "-o", "out.jpg"),
            ("'none.exr'",): ("none.exr", "-o", "out.exr"),
            ("the map itself",): ("map.exr", "-o", "map.exr"),
            ("--size", "WIDTHxHEIGHT"): ("map.r16", "-o", "out.exr"),
            ("10 bytes", "take 18432", "36864"): ("map.r16", "--size=96x96", "-o", "out.exr"),
            ("bytes", "without a header"): ("map.exr", "--size=96x96", "-o", "out.exr"),
            ("--elevation", "integers"): ("map.exr", "--elevation=0,1", "-o", "out.png"),
            ("--gully-width", "--extent"): ("map.exr", "--gully-width=2", "-o", "out.png"),
            ("--gully-width '0'", "above 0"): ("map.exr", "--extent=5", "--gully-width=0", "-o", "out.png"),
            ("pixel (2, 1)", "-9999", "--nodata"): ("pit.exr", "-o", "out.exr"),
            ("pixel (2, 1)", "-99999", "--nodata"): ("pit_5.exr", "-o", "out.exr"),
            ("pixel (2, 1)", "-32768", "--nodata"): ("pit_16.exr", "-o", "out.exr"),
            ("pixel (2, 1)", "-32767", "--nodata"): ("pit_15.exr", "-o", "out.exr"),
            ("pixel (2, 1)", "--nodata", "1e+09"): ("pit_9.exr", "-o", "out.exr"),
            ("every pixel",): ("flat.exr", "--nodata=1", "-o", "out.exr"),
            ("LOW,HIGH",): ("colour0.png", "--elevation=2,1", "-o", "out.png"),
            ("--region", "96 x 96"): ("map.exr", "--extent=8", "--region=90,0,10,10", "-o", "out.exr"),
            ("--preset 'dunes'", "alps, badlands, canyon, fjord, hills"): ("map.exr", "--preset=dunes", "-o", "out.exr"),
            ("'map.r16'",): ("map.exr", "--extent=8", "--masks=map.r16", "-o", "out.exr"),
            ("--octaves '2.5'", "whole number"): ("map.exr", "--octaves=2.5", "-o", "out.exr"),
            ("--gain '3'", "from 0 to 2"): ("map.exr", "--gain=3", "-o", "out.exr"),
            ("--extent",): ("map.exr", "--extent=0", "-o", "out.exr"),
            ("'cut.tif'", "truncated"): ("cut.tif", "-o", "out.exr"),
            ("'damaged.tif'", "damaged"): ("damaged.tif", "-o", "out.exr"),
            ("'halves.tif'", "16-bit floats", "32- or 64-bit floats"): ("halves.tif", "-o", "out.exr"),
            ("'colours.tif'", "3 channels"): ("colours.tif", "-o", "out.exr"),
            ("'inverted.tif'", "from black to white"): ("inverted.tif", "-o", "out.exr"),
            ("'turned.tif'", "upper left corner"): ("turned.tif", "-o", "out.exr"),
            ("'untyped.tif'", "integers"): ("untyped.tif", "-o", "out.exr"),
            ("'long.tif'", "4 x 100000", "65536 x 65536"): ("long.tif", "-o", "out.exr"),
            ("'heavy.tif'", "256 MiB"): ("heavy.tif", "-o", "out.exr"),
            ("--elevation", "integers"): ("map.tif", "--elevation=0,1", "-o", "out.png"),
            ("pixel (0, 0)", "nan"): ("nan.exr", "-o", "out.exr"),
        }.items():
            self.assert_refused(words, "erode", *options)
        for channel in range(3):
            self.assert_refused(("in colour", "pixel (2, 1)"), "erode", f"colour{channel}.png", "-o", "out.exr")
        for width in "1e-9", "1e9":
            self.assert_refused(("--gully-width", "suits the map"), "erode", "map.exr", "--extent=5", f"--gully-width={width}", "-o", "out.exr")


if __name__ == "__main__":
    unittest.main()
