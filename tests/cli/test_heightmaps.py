"""Checks that `gabor erode` reads heightmaps as the world writes them, and that other programs read what it writes."""

import json
import pathlib
import unittest

import matplotlib
import numpy as np
import PIL.Image
from exr import Exr, write_exr
from png import read_deep_png
from program import ProgramTest, gabor
from tiff import write_tiff

METRES, DEGREES = 1, 2  # models of GeoTIFF
LUXEMBOURG = pathlib.Path("/usr/lib/R/site-library/terra/ex/elev.tif")  # of Debian's r-cran-terra, 1.7-3


def keys(model, **codes):
    """Returns the tag of GeoTIFF's keys. codes: k3076=9002 has the value 9002; k3077=("d", 0) is the first of the doubles."""
    entries = {1024: (0, 1, model)}
    for name, code in codes.items():
        entries[int(name[1:])] = (34736, 1, code[1]) if isinstance(code, tuple) else (0, 1, code)
    flat = [number for key in sorted(entries) for number in (key, *entries[key])]
    return ("H", 1, 1, 0, len(entries), *flat)


def metres_per_degree(latitude):
    """The series of https://en.wikipedia.org/wiki/Geographic_coordinate_system#Latitude_and_longitude for WGS 84, along x and y."""
    phi = np.radians(latitude)
    return (111412.84 * np.cos(phi) - 93.5 * np.cos(3 * phi) + 0.118 * np.cos(5 * phi),
            111132.92 - 559.82 * np.cos(2 * phi) + 1.175 * np.cos(4 * phi) - 0.0023 * np.cos(6 * phi))


def hills(rows=60, columns=80):
    y, x = np.mgrid[:rows, :columns]
    return np.round(500 + 200 * np.sin(x / 9) * np.cos(y / 7) + x).astype("f4")


def jacksboro():
    """Returns real heights, and the tags of a GeoTIFF that places them."""
    file = np.load(pathlib.Path(matplotlib.get_data_path(), "sample_data", "jacksboro_fault_dem.npz"))
    top = float(max(file["ymin"], file["ymax"]))
    return file["elevation"], {"t33550": ("d", float(file["dx"]), float(file["dy"]), 0), "t33922": ("d", 0, 0, 0, float(file["xmin"]), top, 0),
                               "t34735": keys(DEGREES, k1025=1, k2048=4326)}


class HeightmapTest(ProgramTest):
    def read(self, name, *options):
        """Returns the map as it is read: without octaves, the output has its heights."""
        self.said = self.succeed("erode", name, "-o", "out.exr", "--octaves=0", *options)
        return Exr(self.folder / "out.exr")

    def assert_read(self, values, extent, name, *options):
        found = self.read(name, *options)
        np.testing.assert_allclose(found.channels["Y"], values, rtol=1e-6, err_msg=name)
        np.testing.assert_allclose(found.parameters["extent"], extent, rtol=1e-6, err_msg=name)

    def mean_slope(self, found):
        """In degrees, of pixels with eight neighbours, as gdaldem counts them."""
        known = found.channels["Y"] != found.parameters.get("nodata", np.nan)
        inner = np.lib.stride_tricks.sliding_window_view(np.pad(known, 1), (3, 3)).all((2, 3))
        return np.degrees(np.arctan(np.hypot(found.channels["slope.x"], found.channels["slope.y"])))[inner].mean()


class GeoTiff(HeightmapTest):
    def write(self, values=None, name="map.tif", **tags):
        write_tiff(self.folder / name, hills() if values is None else values, **tags)

    def extent(self, *options, **tags):
        self.write(**tags)
        return self.read("map.tif", *options).parameters["extent"]

    def test_both_sides_of_pixels(self):
        """The same hills with pixels of 90 x 180 m and with twice as many rows have the same slopes."""
        y, x = np.mgrid[:120, :80] * 90.0 + np.array([45, 45])[:, None, None]
        self.write((300 * np.sin(x / 800) * np.cos(y / 700)).astype("f4"), t33550=("d", 90, 90, 0), t34735=keys(METRES, k3076=9001))
        square = self.read("map.tif", "--gully-frequency=0.6")
        y, x = np.mgrid[:60, :80] * np.array([180.0, 90.0])[:, None, None] + np.array([90, 45])[:, None, None]
        self.write((300 * np.sin(x / 800) * np.cos(y / 700)).astype("f4"), t33550=("d", 90, 180, 0), t34735=keys(METRES, k3076=9001))
        found = self.read("map.tif", "--gully-frequency=0.6")
        self.assertEqual(found.parameters["extent"], [7200, 10800])
        self.assertAlmostEqual(found.parameters["slope"] / square.parameters["slope"], 1, delta=0.01)
        for name in "slope.x", "slope.y":
            self.assertAlmostEqual(found.channels[name].std() / square.channels[name].std(), 1, delta=0.02)

    def test_gullies_have_one_width_along_both_axes(self):
        """Erosion of a map and of the same map with every other row: what it adds is the same there."""
        y, x = np.mgrid[:256, :128] * 1.0
        heights = (8 * np.sin(x / 20) * np.cos(y / 17)).astype("f4")
        added = []
        for rows, side in (heights, 1), (heights[::2] / 2 + heights[1::2] / 2, 2):
            self.write(rows, t33550=("d", 1, side, 0), t34735=keys(METRES, k3076=9001))
            self.succeed("erode", "map.tif", "-o", "out.exr", "--octaves=1", "--gully-frequency=0.7")
            added.append(Exr(self.folder / "out.exr").channels["erosion"])
        error = added[1] - (added[0][::2] + added[0][1::2]) / 2
        print(f"largest difference {np.abs(error).max():.4f} of {np.abs(added[0]).max():.4f}, at {np.unravel_index(np.abs(error).argmax(), error.shape)}")
        self.assertLess(np.abs(error).max(), 0.05 * np.abs(added[0]).max())
        self.assertGreater(added[0].std(), 0.01)

    def test_degrees_become_metres_at_the_middle_latitude(self):
        step, west = 1 / 1200, 6
        for latitude in 49.8, -33, 0.1, 78:
            for point in 1, 2:
                top = latitude + step * (30 - (point == 2) / 2)  # the tie point is the corner or the centre of the first pixel
                found = self.extent(t33550=("d", step, step, 0), t33922=("d", 0, 0, 0, west, top, 0), t34735=keys(DEGREES, k1025=point))
                wide, high = metres_per_degree(latitude)
                np.testing.assert_allclose(found, [80 * step * wide, 60 * step * high], rtol=2e-6, err_msg=f"{latitude}")
                self.assertIn("in m", self.said)
        for unit, degrees in (9101, 180 / np.pi), (9104, 1 / 3600), (9105, 0.9), (9106, 0.9):
            found = self.extent(t33550=("d", step / degrees, step / degrees, 0), t33922=("d", 40, 30, 0, 0, 45 / degrees, 0), t34735=keys(DEGREES, k2054=unit))
            np.testing.assert_allclose(found, np.multiply(metres_per_degree(45), (80 * step, 60 * step)), rtol=2e-6, err_msg=f"{unit}")
        found = self.extent(t33550=("d", step, step, 0), t33922=("d", 40, 30, 0, 6, 45, 0))
        np.testing.assert_allclose(found, np.multiply(metres_per_degree(45), (80 * step, 60 * step)), rtol=2e-6)
        self.assertIn("taken as degrees", self.said)

    def test_matrices(self):
        """A matrix may turn the map, or have its first row in the south."""
        for angle in 0, 30, 200:
            for south in 1, -1:
                c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
                matrix = np.array([[25 * c, -south * 50 * s, 0, 4e5], [25 * s, south * 50 * c, 0, 5e6], [0, 0, 0, 0], [0, 0, 0, 1]])
                for kind in "<f4", "<u2":
                    self.write(hills().astype(kind), t34264=("d", *matrix.ravel()), t34735=keys(METRES, k3076=9001))
                    self.assert_read(hills(), [80 * 25, 60 * 50], "map.tif")

    def test_feet(self):
        foot, survey_foot = 0.3048, 1200 / 3937
        scale = {"t33550": ("d", 300, 600, 0)}
        unit = lambda name: {"t42112": ("s", f'<GDALMetadata>\n<Item name="UNITTYPE" sample="0" role="unittype">{name}</Item>\n</GDALMetadata>'.encode())}
        sides = np.array([300 * 80, 600 * 60])
        for codes, tags, factor, said in (({"k3076": 9002}, {}, 1, "in ft"), ({"k3076": 9002}, unit("m"), foot, "in m"),
                                          ({"k3076": 9001}, unit("ft"), 1 / foot, "in ft"), ({"k3076": 9003}, unit("metre"), survey_foot, "in m"),
                                          ({"k3076": 9003, "k4099": 9001}, {}, survey_foot, "in m"), ({"k3076": 9001, "k4099": 9003}, {}, 1 / survey_foot, "in US survey ft"),
                                          ({"k3076": 9003, "k4096": 5703}, {}, survey_foot, "in m"), ({"k3076": 9001, "k4096": 6360}, {}, 1 / survey_foot, "in US survey ft"),
                                          ({"k3076": 32767, "k3077": ("d", 0), "k4099": 9001}, {"t34736": ("d", 0.5)}, 0.5, "in m"),
                                          ({}, {}, 1, "taken as metres")):
            np.testing.assert_allclose(self.extent(t34735=keys(METRES, **codes), **scale, **tags), factor * sides, rtol=1e-9, err_msg=f"{codes}")
            self.assertIn(said, self.said)
        step = {"t33550": ("d", 1e-3, 1e-3, 0), "t33922": ("d", 40, 30, 0, 0, 45, 0), "t34735": keys(DEGREES, k4099=9002)}
        np.testing.assert_allclose(self.extent(**step), np.multiply(metres_per_degree(45), (0.08, 0.06)) / foot, rtol=2e-6)

    def test_every_type_of_value(self):
        place = {"t33550": ("d", 10, 10, 0), "t34735": keys(METRES, k3076=9001)}
        for kind in "<f8", ">f8", "<i4", "<u4", ">i4", "<i2", "<u2":
            self.write(hills().astype(kind), **place)
            self.assert_read(hills(), [800, 600], "map.tif")
        for kind in "u1", "i1":
            values = (hills() / 10 - (60 if kind == "i1" else 0)).astype(kind)
            self.write(values, **place)
            self.assert_read(values, [800, 600], "map.tif")
        levels = np.round(hills() / 4).astype("u1")  # of no GeoTIFF
        self.write(levels)
        result = gabor("erode", "map.tif", "-o", "out.exr", "--octaves=0", "--elevation=-1,254", cwd=self.folder)
        self.assertIn("8 bits per height", result.stderr)
        np.testing.assert_allclose(Exr(self.folder / "out.exr").channels["Y"], levels - 1.0, rtol=1e-5)

    def test_scale_offset_and_missing_heights(self):
        items = b'<GDALMetadata>\n<Item name="a&lt;b">1</Item>\n<Item name="OFFSET" sample="0" role="offset">-50</Item>\n<Item name="SCALE" sample="0" role="scale">0.25</Item>\n<Item name="SCALE" sample="1" role="scale">9</Item></GDALMetadata>'
        place = {"t33550": ("d", 10, 10, 0), "t34735": keys(METRES, k3076=9001)}
        for kind, text in ("<i2", b"-32768"), ("<f4", b"-3.40282346638529e+38"), ("<f8", b"-1.7976931348623157e+308"), ("<f4", b"nan"), ("u1", b"255"):
            values = np.round(hills() / 4).astype(kind)
            values[5:9, 7:20] = np.array(float(text), values.dtype) if b"e+38" not in text else np.finfo("f4").min
            self.write(values, t42112=("s", items), t42113=("s", text), **place)
            out = "out.tif"  # as an EXR of these tests must be finite
            self.succeed("erode", "map.tif", "-o", out, "--octaves=0")
            with PIL.Image.open(self.folder / out) as image:
                found, tags = np.array(image), image.tag_v2
            there = np.ones(values.shape, bool)
            there[5:9, 7:20] = False
            np.testing.assert_allclose(found[there], values[there] * 0.25 - 50, rtol=1e-6, err_msg=text)
            missing = np.float32(tags[42113])
            self.assertTrue(np.isnan(found[~there]).all() if np.isnan(missing) else (found[~there] == missing).all(), text)

    def test_real_maps_have_the_slopes_of_gdaldem(self):
        """gdaldem 3.6.2 finds a mean slope of 12.853 degrees at Jacksboro, warped by gdalwarp to UTM with pixels of 74.5 x 92.5 m and
        the nearest heights, and 1.617 degrees in Luxembourg, with 599.7 x 926.9 m."""
        heights, tags = jacksboro()
        self.write(heights.astype("<i2"), **tags)
        maps = [(self.folder / "map.tif", 12.853, (30.0e3, 31.8e3))]
        if LUXEMBOURG.exists():
            maps.append((LUXEMBOURG, 1.617, (57.0e3, 83.4e3)))
        for path, expected, extent in maps:
            found = self.read(str(path))
            slope = self.mean_slope(found)
            print(f"{path.name}: mean slope {slope:.3f} degrees for {expected}, {found.parameters['extent']} m")
            self.assertAlmostEqual(slope / expected, 1, delta=0.02)
            np.testing.assert_allclose(found.parameters["extent"], extent, rtol=2e-3)

    @unittest.skipUnless(LUXEMBOURG.exists(), "Luxembourg's elev.tif comes with r-cran-terra, which is not installed")
    def test_luxembourg(self):
        found = self.read(str(LUXEMBOURG))
        np.testing.assert_allclose(found.parameters["extent"], (56975, 83419), rtol=1e-4)

    def test_an_extent_that_is_given_wins(self):
        self.write(t33550=("d", 10, 20, 0), t34735=keys(METRES, k3076=9001))
        for given, expected in ("1600", [1600, 2400]), ("1600,700", [1600, 700]):
            self.assertEqual(self.read("map.tif", f"--extent={given}").parameters["extent"], expected)

    def test_what_is_not_understood_is_refused_by_name(self):
        scale = {"t33550": ("d", 10, 10, 0)}
        turned = np.array([[1e-3, 5e-4, 0, 6], [5e-4, -1e-3, 0, 60], [0, 0, 0, 0], [0, 0, 0, 1]])
        skewed = np.array([[10, 5, 0, 4e5], [0, -10, 0, 5e6], [0, 0, 0, 0], [0, 0, 0, 1]])
        for words, tags in ((["control points"], {"t33922": ("d", *range(18)), "t34735": keys(METRES, k3076=9001)}),
                            (["unit 9036 of EPSG"], {**scale, "t34735": keys(METRES, k3076=9036)}),
                            (["angular unit 9107"], {**scale, "t34735": keys(DEGREES, k2054=9107)}),
                            (["heights", "unit 9030"], {**scale, "t34735": keys(METRES, k3076=9001, k4099=9030)}),
                            (["heights", "'fathom'"], {**scale, "t34735": keys(METRES), "t42112": ("s", b'<Item name="UNITTYPE" sample="0" role="unittype">fathom</Item>')}),
                            (["kind 3 of GeoTIFF"], {**scale, "t34735": keys(3)}),
                            (["no size"], {"t33550": ("d", 0, 10, 0), "t34735": keys(METRES, k3076=9001)}),
                            (["unit of length has no size"], {**scale, "t34735": keys(METRES, k3076=32767)}),
                            (["beyond the poles"], {**scale, "t34735": keys(DEGREES)}),
                            (["right angles"], {"t34264": ("d", *turned.ravel()), "t34735": keys(DEGREES)}),
                            (["right angles"], {"t34264": ("d", *skewed.ravel()), "t34735": keys(METRES, k3076=9001)})):
            self.write(**tags)
            self.assert_refused([*words, "'map.tif'", "--extent WIDTH,HEIGHT"], "erode", "map.tif", "-o", "out.exr")
            self.assertEqual(self.read("map.tif", "--extent=50,60").parameters["extent"], [50, 60])


class Reading(HeightmapTest):
    def test_hgt(self):
        """SRTM's files: high byte first, a degree from the lower left height, whose place their names have, and voids."""
        heights = np.round(hills(121, 121) - 600)
        heights[50:60, 20:40] = -32768
        for name, latitude in ("N49E006.hgt", 49.5), ("s34w071.HGT", -33.5):
            (self.folder / name).write_bytes(heights.astype(">i2").tobytes())
            self.assert_read(heights, np.multiply(metres_per_degree(latitude), 121 / 120), name)
            self.assertEqual(Exr(self.folder / "out.exr").parameters["nodata"], -32768)
        (self.folder / "tile.hgt").write_bytes(heights.astype(">i2").tobytes())
        self.assert_read(heights, [70, 80], "tile.hgt", "--extent=70,80")
        self.assertIn("a guess", self.succeed("erode", "tile.hgt", "-o", "out.exr"))
        (self.folder / "N60E010.hgt").write_bytes(heights[:99].astype(">i2").tobytes())
        self.assert_read(heights[:99], np.multiply(metres_per_degree(60.5), (121 / 120, 99 / 98)), "N60E010.hgt", "--size=121x99")
        self.assert_refused(["'N60E010.hgt'", "23958 bytes", "square"], "erode", "N60E010.hgt", "-o", "out.exr")
        self.succeed("erode", "N49E006.hgt", "-o", "out.tif", "--octaves=0")
        with PIL.Image.open(self.folder / "out.tif") as image:
            np.testing.assert_array_equal(np.array(image), heights)
            self.assertEqual(image.tag_v2[33922][3:5], (6, 50))  # the first height's centre
            self.assertEqual(image.tag_v2[42113], "-32768")

    def test_asc(self):
        heights = hills(6, 8)
        heights[2, 3] = -1
        header = "NCOLS 8\nnrows 6\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value -1\n"
        text = "\n".join(" ".join(f"{value:g}" for value in row) for row in heights)
        for prj, corner, cell, extent in (("", (4e5, 5e6), 25, [200, 150]),
                                          ("", (6, 45), 0.01, np.multiply(metres_per_degree(45.03), (0.08, 0.06))),
                                          ('GEOGCS["WGS 84",UNIT["Degree",0.0174532925199433]]', (0, 45), 0.01, np.multiply(metres_per_degree(45.03), (0.08, 0.06))),
                                          ('PROJCS["Tennessee",GEOGCS["x",UNIT["Degree",0.0174]],UNIT["Foot_US",0.3048006]]', (4e5, 5e6), 25, [200, 150])):
            (self.folder / "map.asc").write_text(header.format(*corner, cell) + text)
            (self.folder / "map.prj").write_text(prj)
            self.assert_read(heights, extent, "map.asc")
        (self.folder / "map.asc").write_text("ncols 8\nnrows 6\nxllcenter 100\nyllcenter 200\ndx 2\ndy 3\n" + text.replace("\n", " "))
        self.assert_read(heights, [16, 18], "map.asc")
        self.succeed("erode", "map.asc", "-o", "out.tif", "--octaves=0")
        with PIL.Image.open(self.folder / "out.tif") as image:
            self.assertEqual(image.tag_v2[33922][3:5], (99, 216.5))  # the upper left corner of the first pixel
        (self.folder / "map.asc").write_text(header.format(0, 0, 1).replace("-1", "nan") + "nan" + text[text.index(" "):].replace("-1", "nan"))
        self.succeed("erode", "map.asc", "-o", "out.tif", "--octaves=0")  # as an EXR of these tests must be finite
        with PIL.Image.open(self.folder / "out.tif") as image:
            there = np.array(image)
        self.assertTrue(np.isnan(there[[0, 2], [0, 3]]).all())
        np.testing.assert_array_equal(np.where(np.isnan(there), heights, there), heights)
        good = header.format(0, 0, 1) + text
        for bad, words in ((good[:-30], "ends early"), (good + " 7", "more heights"), (good.replace("500", "5oo", 1), "'5oo' is not a number"),
                           (good.replace("nrows 6", "nrows 0"), "ncols and nrows"), (good.replace("cellsize 1", ""), "cellsize")):
            (self.folder / "bad.asc").write_text(bad)
            self.assert_refused(["'bad.asc'", words], "erode", "bad.asc", "-o", "out.exr", "--extent=9")

    def test_npy(self):
        for kind in "<f4", ">f4", "<f8", "<i2", ">i2", "<u2", "<i4", "<i8", "i1", "u1":
            values = (hills() / 10 - (60 if "i" in kind else 0)).astype(kind)
            for version in (1, 0), (2, 0):
                with open(self.folder / "map.npy", "wb") as file:
                    np.lib.format.write_array(file, values, version)
                self.assert_read(values, [80, 60], "map.npy", "--extent=80")
        for bad, words in ((np.asfortranarray(hills()), "ascontiguousarray"), (hills()[0], "two dimensions"), (hills() > 3, "integers or floats"),
                           (hills().astype("f2"), "16-bit floats")):
            np.save(self.folder / "bad.npy", bad)
            self.assert_refused(["'bad.npy'", words], "erode", "bad.npy", "-o", "out.exr", "--extent=9")
        (self.folder / "cut.npy").write_bytes((self.folder / "map.npy").read_bytes()[:-3])
        self.assert_refused(["'cut.npy'", "ends early"], "erode", "cut.npy", "-o", "out.exr", "--extent=9")

    def test_heights_in_colours(self):
        heights = hills() - 700.5
        rgb = np.round((heights + 10000) * 10).astype(int)
        terrarium = np.round((heights + 32768) * 256).astype(int)
        for name, value in ("terrain-rgb", rgb), ("Terrarium", terrarium):
            colours = np.dstack([value >> 16, value >> 8 & 255, value & 255]).astype("u1")
            PIL.Image.fromarray(colours).save(self.folder / "map.png")
            self.assert_read(heights, [80, 60], "map.png", "--extent=80", f"--encoding={name}")
            alpha = np.full(heights.shape, 255, "u1")
            alpha[3:9, 4:30] = 0
            PIL.Image.fromarray(np.dstack([colours, alpha])).save(self.folder / "map.png")
            self.assert_read(np.where(alpha > 0, heights, -32768), [80, 60], "map.png", "--extent=80", f"--encoding={name}")
        self.assert_refused(["in colour", "--encoding"], "erode", "map.png", "-o", "out.exr", "--extent=9")
        self.assert_refused(["--encoding 'rgb'", "terrain-rgb, terrarium"], "erode", "map.png", "-o", "out.exr", "--encoding=rgb")
        PIL.Image.fromarray(np.zeros((4, 4), "u1")).save(self.folder / "grey.png")
        self.assert_refused(["8 bits in red, green and blue"], "erode", "grey.png", "-o", "out.exr", "--encoding=terrarium")

    def test_the_byte_order_is_that_of_smoother_neighbours(self):
        heights, real = hills(), np.ascontiguousarray(jacksboro()[0])
        for name, values in ("smooth", heights), ("real", real), ("negative", heights - 800), ("small", heights / 1e4):
            rows, columns = values.shape
            for order, said in ("<", "low byte first"), (">", "high byte first"):
                for kind, scale in ("f4", ()), ("u2", ("--elevation=0,65535",)):
                    if kind == "u2" and name in ("negative", "small"):
                        continue
                    (self.folder / "map.raw").write_bytes(values.astype(order + kind).tobytes())
                    size = f"--size={columns}x{rows}"
                    self.assert_read(values, [80, 80 * rows / columns], "map.raw", "--extent=80", size, *scale)
                    self.assertIn(said, self.said)
                    if name == "smooth":
                        option = {"<": "little", ">": "Big"}[order]
                        self.assert_read(values, [80, 60], "map.raw", "--extent=80", size, *scale, f"--byte-order={option}")
                        self.assertNotIn("byte first", self.said)
        self.assert_refused(["--byte-order 'middle'"], "erode", "map.raw", "--size=80x60", "--byte-order=middle", "-o", "out.exr")
        self.assert_refused(["--byte-order", "--size"], "erode", "map.raw", "--byte-order=big", "-o", "out.exr")


class Writing(HeightmapTest):
    def setUp(self):
        super().setUp()
        self.heights = hills()
        self.heights[20:24, 30:40] = -9999
        self.tags = {"t33550": ("d", 10, 20, 0), "t33922": ("d", 0, 0, 0, 4e5, 5e6, 0), "t34735": keys(METRES, k1025=1, k3072=32632, k3076=9001, k1026=("d", 0)),
                     "t34736": ("d", 0.25), "t34737": ("s", b"WGS 84 / UTM zone 32N|"), "t42113": ("s", b"-9999")}
        write_tiff(self.folder / "map.tif", self.heights, **self.tags)
        self.succeed("erode", "map.tif", "-o", "plain.exr", "--gully-frequency=1")
        self.expected = Exr(self.folder / "plain.exr").channels["Y"]

    def write(self, name, *options):
        self.succeed("erode", "map.tif", "-o", name, "--gully-frequency=1", *options)
        path = self.folder / f"{name}.json"
        return json.loads(path.read_text()) if path.exists() else None

    def test_tiffs_keep_the_place_of_the_map(self):
        for options, corner, part in ([], (4e5, 5e6), np.s_[:, :]), (["--region=8,6,40,30"], (4e5 + 80, 5e6 - 120), np.s_[6:36, 8:48]):
            for compression in "none", "zip":
                for name in "out.tif", "out.TIFF":
                    self.assertIsNone(self.write(name, f"--compression={compression}", *options))
                    with PIL.Image.open(self.folder / name) as image:
                        np.testing.assert_array_equal(np.array(image), self.expected[part])
                        tags = image.tag_v2
                        self.assertEqual(tags[33550], (10, 20, 0))
                        self.assertEqual(tags[33922], (0, 0, 0, *corner, 0))
                        self.assertEqual(tags[34735], tuple(self.tags["t34735"][1:]))
                        self.assertEqual((tags[34736], tags[34737]), (0.25, "WGS 84 / UTM zone 32N|"))
                        self.assertEqual(tags[42113], "-9999")
        matrix = np.array([[8, 6, 0, 4e5], [6, -8, 0, 5e6], [0, 0, 0, 0], [0, 0, 0, 1]])
        write_tiff(self.folder / "map.tif", self.heights, t34264=("d", *matrix.ravel()), t34735=keys(METRES, k3076=9001))
        self.succeed("erode", "map.tif", "-o", "out.tif", "--nodata=-9999", "--region=8,6,40,30")
        with PIL.Image.open(self.folder / "out.tif") as image:
            np.testing.assert_allclose(np.reshape(image.tag_v2[34264], (4, 4))[:2, 3], matrix[:2] @ [8, 6, 0, 1])

    def test_a_map_without_a_place_keeps_its_extent(self):
        write_exr(self.folder / "map.exr", {"Y": hills()})
        self.succeed("erode", "map.exr", "-o", "out.tif", "--extent=320,120")
        self.assertEqual(self.read("out.tif").parameters["extent"], [320, 120])

    def test_rasterio_reads_the_place(self):
        try:
            import rasterio
        except ImportError as error:
            self.skipTest(f"rasterio is not installed: {error}")
        heights, tags = jacksboro()
        write_tiff(self.folder / "real.tif", heights.astype("<i2"), **tags, t42113=("s", b"-32768"))
        for source in "map.tif", "real.tif":
            for region in None, (8, 6, 40, 30):
                self.succeed("erode", source, "-o", "out.tif", *([f"--region={','.join(map(str, region))}"] if region else []))
                with rasterio.open(self.folder / source) as before, rasterio.open(self.folder / "out.tif") as after:
                    self.assertEqual((before.crs, before.nodata), (after.crs, after.nodata))
                    self.assertEqual(after.dtypes, ("float32",))
                    x, y = region[:2] if region else (0, 0)
                    moved = dict(a=0, b=0, c=before.transform.a * x, d=0, e=0, f=before.transform.e * y)
                    for name, step in moved.items():
                        self.assertAlmostEqual(getattr(after.transform, name), getattr(before.transform, name) + step, delta=1e-9, msg=name)

    def test_floats_and_levels_without_a_header(self):
        scale = self.write("out.r32")
        np.testing.assert_array_equal(np.fromfile(self.folder / "out.r32", "<f4").reshape(60, 80), self.expected)
        self.assertEqual(scale, {"width": 80, "height": 60, "extent": [800, 1200], "missing": -9999})
        again = self.read("out.r32", "--size=80x60")
        np.testing.assert_array_equal(again.channels["Y"], self.expected)
        self.assertEqual((again.parameters["nodata"], again.parameters["extent"]), (-9999, [800, 1200]))
        there = self.expected != -9999
        for full in [], ["--full-range"]:
            for name in "out.raw", "out.r16", "out.png":
                scale = self.write(name, *full)
                levels = read_deep_png(self.folder / name) if name == "out.png" else np.fromfile(self.folder / name, "<u2").reshape(60, 80)
                low, high = scale.pop("elevation")
                self.assertEqual(scale, {"width": 80, "height": 60, "extent": [800, 1200], "missing": 0})
                np.testing.assert_array_equal(levels == 0, ~there)
                np.testing.assert_allclose((low + (high - low) / 65535 * levels)[there], self.expected[there], atol=0.51 * (high - low) / 65535 + 1e-4)
                if full:
                    self.assertEqual((levels[there].min(), levels.max()), (1, 65535))
                again = self.read(name, *(["--size=80x60"] if name != "out.png" else []))
                np.testing.assert_array_equal(again.channels["Y"] == np.float32(again.parameters["nodata"]), ~there)
                np.testing.assert_allclose(again.channels["Y"][there], self.expected[there], atol=0.51 * (high - low) / 65535 + 1e-4)
        write_exr(self.folder / "map.exr", {"Y": hills()})
        self.succeed("erode", "map.exr", "-o", "full.png", "--extent=9", "--full-range")
        levels = read_deep_png(self.folder / "full.png")
        self.assertEqual((levels.min(), levels.max()), (0, 65535))
        write_exr(self.folder / "flat.exr", {"Y": np.full((9, 9), 3, "f4")})
        self.succeed("erode", "flat.exr", "-o", "flat.png", "--extent=9", "--full-range")
        self.assertEqual(json.loads((self.folder / "flat.png.json").read_text())["elevation"], [3, 4])
        self.assertEqual(self.write("one.exr", "--only-height"), {"width": 80, "height": 60, "extent": [800, 1200], "missing": -9999})
        one = Exr(self.folder / "one.exr").channels
        self.assertEqual(list(one), ["Y"])
        np.testing.assert_array_equal(one["Y"], self.expected)
        self.assertEqual(self.read("one.exr").parameters["extent"], [800, 1200])
        self.assert_refused(["--only-height is for an EXR"], "erode", "map.tif", "-o", "out.png", "--only-height")
        for name in "out.tif", "out.exr", "out.r32":
            self.assert_refused(["--full-range", "16-bit", f"'{name}'"], "erode", "map.tif", "-o", name, "--full-range")

    def test_heights_that_are_missing_as_nan_are_read_again(self):
        self.heights[self.heights == -9999] = np.nan
        write_tiff(self.folder / "map.tif", self.heights, **self.tags | {"t42113": ("s", b"nan")})
        for name, size in ("out.r32", ["--size=80x60"]), ("out.png", []):
            self.write(name)
            self.succeed("erode", name, *size, "-o", "again.tif", "--octaves=0")
            with PIL.Image.open(self.folder / "again.tif") as image:
                again = np.array(image)
                missing = np.float32(image.tag_v2[42113])
            np.testing.assert_array_equal(np.isnan(self.heights), np.isnan(again) if np.isnan(missing) else again == missing)

    def test_heightmaps_of_terrain(self):
        terrain = ["render", "--view=terrain", "--size=64x48", "--extent=640", "--seed=3"]
        self.succeed(*terrain, "-o", "all.exr")
        expected = Exr(self.folder / "all.exr").channels["height"]
        for name in "h.exr", "h.r32", "h.tif":
            self.succeed(*terrain, "--write-heightmap", name)
            if name == "h.exr":
                self.assertEqual(set(Exr(self.folder / name).channels), {"Y"})
            found = self.read(name, *(["--size=64x48"] if name == "h.r32" else []))
            np.testing.assert_array_equal(found.channels["Y"], expected)
            self.assertEqual(found.parameters["extent"], [640, 480])
        self.succeed(*terrain, "--region=40,10,20,30", "--write-heightmap", "part.tif")
        with PIL.Image.open(self.folder / "part.tif") as image:
            np.testing.assert_array_equal(np.array(image), expected[10:40, 40:60])
            np.testing.assert_allclose((*image.tag_v2[33922], *image.tag_v2[33550]), (0, 0, 0, 400, -100, 0, 10, 10, 0), rtol=1e-12)
        self.succeed(*terrain, "--write-heightmap", "h.raw", "--full-range")
        levels, (low, high) = np.fromfile(self.folder / "h.raw", "<u2").reshape(48, 64), json.loads((self.folder / "h.raw.json").read_text())["elevation"]
        self.assertEqual((levels.min(), levels.max(), low, high), (0, 65535, expected.min(), expected.max()))
        for words, options in ((["--elevation", "'h.exr' has floats"], ("--write-heightmap=h.exr", "--elevation=0,9")),
                               (["exclude"], ("--write-heightmap=h.png", "--elevation=0,9", "--full-range")),
                               (["--full-range requires --write-heightmap"], ("-o", "a.exr", "--full-range")),
                               (["none or zip"], ("--write-heightmap=h.tif", "--compression=piz"))):
            self.assert_refused(words, *terrain, *options)


class Worlds(HeightmapTest):
    WORLD = ["--steepness=0.3", "--relief=-100,2000", "--gully-width=1200"]

    def test_maps_of_a_world_agree_where_they_overlap(self):
        """Four tiles of a real map, one of them smaller, each with a margin, against each other and against the whole, around the
        world's origin."""
        heights = jacksboro()[0].astype("f4")
        pixel, margin = 80, 12  # of 80 m: two thirds of a gully's width are 10 pixels

        def eroded(x, y, width, height):
            write_exr(self.folder / "tile.exr", {"Y": heights[y:y + height, x:x + width]})
            self.succeed("erode", "tile.exr", "-o", "out.exr", f"--extent={pixel * width}", f"--offset={x - 100},{y - 110}", "--masks=masks", *self.WORLD)
            return {**Exr(self.folder / "out.exr").channels, **Exr(self.folder / "masks" / "masks.exr").channels}
        whole = eroded(0, 0, 403, 344)
        self.assertGreater(np.abs(whole["erosion"]).max(), 50)
        middle_x, middle_y, worst = 200, 150, 0
        for left, right in (0, middle_x + margin), (middle_x - margin, 403):
            for top, bottom in (0, middle_y + margin), (middle_y - margin, 344):
                tile = eroded(left, top, right - left, bottom - top)
                kept = np.s_[max(top, middle_y if top else 0):bottom if bottom == 344 else middle_y + 1, max(left, middle_x if left else 0):right if right == 403 else middle_x + 1]
                inner = np.s_[kept[0].start - top:kept[0].stop - top, kept[1].start - left:kept[1].stop - left]
                for name, tolerance in ("Y", 0.01), ("slope.x", 1e-3), ("ridge", 1e-3), ("grass", 2e-3), ("rock", 2e-3):
                    error = np.abs(tile[name][inner] - whole[name][kept])
                    print(f"{name} of the tile at {left}, {top}: off by at most {error.max():.5f}, at {np.unravel_index(error.argmax(), error.shape)}")
                    self.assertLess(error.max(), tolerance, name)
                    worst = max(worst, error.max() if name == "Y" else 0)
        alone = self.succeed("erode", "tile.exr", "-o", "out.exr", f"--extent={pixel * tile['Y'].shape[1]}", "--gully-width=1200")
        self.assertGreater(np.abs(Exr(self.folder / "out.exr").channels["Y"][inner] - whole["Y"][kept]).max(), 1)

    def test_gullies_go_on_far_from_the_origin(self):
        write_exr(self.folder / "map.exr", {"Y": hills()})
        far = []
        for x in 3000000, 3000010:
            self.succeed("erode", "map.exr", "-o", "out.exr", "--extent=1600", f"--offset={x},-7000000", "--steepness=0.5", "--relief=0,1000", "--gully-width=300")
            far.append(Exr(self.folder / "out.exr").channels["ridge"])
        self.assertGreater(far[0].std(), 0.2)
        self.assertGreater(np.abs(far[0] - far[1]).max(), 0.2)

    def test_pixels_of_a_world_may_be_higher_than_wide(self):
        heights = hills(90, 60)

        def eroded(top):
            write_exr(self.folder / "map.exr", {"Y": heights[top:]})
            self.succeed("erode", "map.exr", "-o", "out.exr", f"--extent=1200,{40 * (90 - top)}", f"--offset=0,{top}", "--steepness=0.5", "--relief=0,1000", "--gully-width=300")
            return Exr(self.folder / "out.exr").channels["ridge"][50 - top:]
        whole, part = eroded(0), eroded(40)  # two thirds of a gully's width are 5 rows
        self.assertGreater(whole.std(), 0.2)
        np.testing.assert_allclose(part, whole, rtol=0, atol=1e-3)

    def test_refusals(self):
        write_exr(self.folder / "map.exr", {"Y": hills()})
        for words, options in ((["--offset needs --steepness, --relief and --gully-width"], ["--offset=0,0", "--steepness=0.3"]),
                               (["--offset '1'", "X,Y"], ["--offset=1", *self.WORLD]), (["--offset '99999999,0'"], ["--offset=99999999,0", *self.WORLD]),
                               (["--tileable"], ["--offset=0,0", "--tileable", *self.WORLD]), (["--steepness '0'"], ["--steepness=0"]),
                               (["--relief '0,200'", "314 to 771"], ["--relief=0,200"]), (["--relief '9,2'"], ["--relief=9,2"]),
                               (["--gully-width and --gully-frequency"], ["--gully-width=900", "--gully-frequency=2"])):
            self.assert_refused(words, "erode", "map.exr", "-o", "out.exr", "--extent=9000", *options)


if __name__ == "__main__":
    unittest.main()
