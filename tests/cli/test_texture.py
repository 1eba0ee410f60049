"""Checks that each level of `gabor texture` is the filtered flat picture of its size."""

import struct
import unittest

import numpy as np

from exr import Exr, Texture
from program import WINDOWS, ProgramTest

NOISE = ["--frequency=1.5", "--orientation-spread=20", "--seed=7"]
SCALED = 4 # the number of levels whose scales `gabor render` accepts for flat pictures


def text(texture, name):
    kind, value = texture.attributes[name]
    assert kind == "string"
    return value.decode()


class TextureTest(ProgramTest):
    made = {} # the bytes of each texture, by its options

    def flat(self, width, height, scale, *options):
        self.succeed("render", f"--size={width}x{height}", *NOISE, f"--scale={scale}", "--filter", "-o", "flat.exr",
                     *options)
        return Exr(self.folder / "flat.exr")

    def texture(self, width, height, *options, scale=16):
        given, path = (f"--size={width}x{height}", f"--scale={scale}", *options), self.folder / "texture.exr"
        if given not in self.made:
            self.succeed("texture", *NOISE, "-o", path.name, *given)
            self.made[given] = path.read_bytes()
        path.write_bytes(self.made[given])
        return Texture(path)


class Levels(TextureTest):
    def test_every_level_is_the_filtered_picture_of_its_size(self):
        for options, levels in ([], range(SCALED)), (["--tileable"], [1]):
            texture = self.texture(256, 128, *options)
            self.assertEqual([level["Y"].shape for level in texture.levels],
                             [(max(1, 128 >> k), 256 >> k) for k in range(9)])
            for k in levels:
                flat = self.flat(256 >> k, 128 >> k, 16 / 2**k, *options)
                for channel in ("Y", "removed"):
                    np.testing.assert_array_equal(texture.levels[k][channel], flat.channels[channel], f"level {k}")

    def test_the_last_level_is_averaged_in_every_channel(self):
        texture = self.texture(256, 128, "--gradient", scale=100)
        last, before = texture.levels[8], texture.levels[7]
        self.assertEqual(len({values[0, 0] for values in last.values()}), len(last))
        for channel, values in last.items():
            self.assertEqual(values[0, 0], (before[channel][0, 0] + before[channel][0, 1]) / 2, channel)

    def test_levels_lose_the_variance_that_the_channel_removed_states(self):
        texture = self.texture(512, 512, scale=8)
        kept = [(level["Y"].astype(float)**2).mean() for level in texture.levels]
        said = [1 - level["removed"].mean() for level in texture.levels]
        np.testing.assert_allclose(kept[:3], said[:3], rtol=0.08) # 64 x 64 radii have a sampling error of 2 %
        self.assertGreater(said[0], 0.6)
        self.assertLess(max(kept[4:]), 0.01)
        self.assertGreater(min(level["removed"].min() for level in texture.levels[5:]), 0.99)

    def test_a_tile_of_a_larger_picture(self):
        whole = self.flat(256, 256, 16)
        texture = self.texture(256, 256, "--region=128,64,128,64")
        self.assertEqual(texture.window, (0, 0, 128, 64))
        np.testing.assert_array_equal(texture.levels[0]["Y"], whole.pixels[64:128, 128:])
        half = self.flat(128, 128, 8)
        np.testing.assert_array_equal(texture.levels[1]["Y"], half.pixels[32:64, 64:])

    def test_half(self):
        single, half = self.texture(256, 128), self.texture(256, 128, "--half")
        for a, b in zip(single.levels, half.levels):
            self.assertEqual(b["Y"].dtype, np.float16)
            np.testing.assert_array_equal(a["Y"].astype(np.float16), b["Y"])


    def test_frames_share_a_period_of_the_evolution(self):
        given = ["texture", "--size=16", *NOISE, "--scale=8", "-o"]
        self.succeed(*given, "out.exr", "--frames=2", "--evolution=0.25")
        for frame, evolution in (1, 0.25), (2, 0.75):
            self.succeed(*given, "one.exr", f"--evolution={evolution}")
            self.assertEqual(self.files()[f"out.000{frame}.exr"], self.files()["one.exr"])


class Joined(TextureTest):
    def levels(self, width, height, options, strips=3):
        """Renders level 0 in uneven strips and the other levels whole, down to the one whose shorter side is 1."""
        regions = []
        for level in range(min(width, height).bit_length()):
            rows = [height * k // strips for k in range(strips + 1)] if level == 0 else [0, height >> level]
            for first, end in zip(rows, rows[1:]):
                regions.append(f"level{level}.{first}.exr")
                self.succeed("texture", f"--size={width}x{height}", f"--level={level}", *options, "-o", regions[-1],
                             f"--region=0,{first},{width >> level},{end - first}")
        return regions

    def test_levels_become_the_texture(self):
        for width, height, options, half in ((16, 8, [*NOISE, "--scale=16"], ["--half"]),
                                             (8, 16, [*NOISE, "--scale=4", "--tileable", "--phasor", "--gradient"], [])):
            self.succeed("texture", f"--size={width}x{height}", *options, *half, "-o", "texture.exr")
            regions = self.levels(width, height, options)
            said = self.succeed("join", "--texture", *half, *regions[2:], *regions[:2], "-o", "joined.exr")
            self.assertEqual(said, f"joined.exr: {width} x {height} pixels, from {len(regions)} regions\n")
            files = self.files()
            self.assertEqual(files["joined.exr"], files["texture.exr"], options)

    def test_a_level_is_the_filtered_picture_of_its_size(self):
        self.succeed("texture", "--size=128x64", "--level=2", *NOISE, "--scale=16", "-o", "level.exr")
        flat = self.flat(32, 16, 4)
        self.assertEqual(flat.parameters, Exr(self.folder / "level.exr").parameters)
        self.assertEqual(self.files()["level.exr"], self.files()["flat.exr"])

    def test_wrong_levels(self):
        regions = self.levels(8, 4, [*NOISE, "--scale=8"], strips=2)
        join = "join", "--texture", "-o", "new.exr"
        self.assert_refused(["no region of level 2 (2 x 1 pixels)"], *join, *(r for r in regions if "level2" not in r))
        self.assert_refused(["no region contains the pixel 0,2"], *join, *regions[:1], *regions[2:])
        self.succeed("texture", "--size=8x4", "--level=1", *NOISE, "--scale=8", "--evolution=0.3", "-o", "other.exr")
        self.assert_refused(["'other.exr' is not level 1 of 'level0.0.exr'"], *join,
                            *(r for r in regions if "level1" not in r), "other.exr")
        self.succeed("texture", "--size=16x4", "--level=2", *NOISE, "--scale=8", "-o", "other.exr")
        self.assert_refused(["'other.exr' is not a level of 'level0.0.exr'"], *join, *regions, "other.exr")
        self.succeed("render", "--size=8x4", *NOISE, "--scale=8", "-o", "sharp.exr")
        self.assert_refused(["'sharp.exr' is not filtered"], *join, "sharp.exr")
        self.assert_refused(["--half"], "join", "--half", "-o", "new.exr", *regions)
        self.assert_refused(["level0.0.exr", "is one of the regions"], "join", "--texture", *regions, "-o", regions[0])
        for level in ("5", "-1", "x"):
            self.assert_refused([f"--level '{level}'", "from 0 to 4 at this size"], "texture", "--size=32x16",
                                f"--level={level}", "-o", "new.exr")
        self.assert_refused(["power of two", "32 x 17 pixels"], "texture", "--size=32x17", "--level=1", "-o", "new.exr")
        self.assert_refused(["--half and --level"], "texture", "--half", "--level=1", "--size=32x16", "-o", "new.exr")


class Attributes(TextureTest):
    def test_attributes_of_a_texture(self):
        texture = self.texture(256, 128)
        self.assertEqual(text(texture, "textureformat"), "Plain Texture")
        self.assertEqual(text(texture, "wrapmodes"), "black,black")
        self.assertEqual(struct.unpack("<f", texture.attributes["fovcot"][1])[0], 2)
        means = [texture.levels[0][channel].astype(float).mean() for channel in ("Y", "removed")]
        said = [float(mean) for mean in text(texture, "oiio:AverageColor").split(",")]
        np.testing.assert_allclose(said, means, rtol=1e-6)
        self.assertEqual(text(self.texture(256, 128, "--tileable"), "wrapmodes"), "periodic,periodic")
        for part in "0,0,128,128", "0,0,256,64":
            tile = self.texture(256, 128, "--tileable", f"--region={part}")
            self.assertEqual(text(tile, "wrapmodes"), "black,black", part)

    def test_it_is_rendered_again_from_its_header(self):
        texture = self.texture(256, 128)
        self.succeed("texture", "--like=texture.exr", "-o", "again.exr")
        self.assertEqual(self.files()["again.exr"], self.files()["texture.exr"])
        self.assertTrue(text(texture, "gabor").startswith("{"))
        self.assertTrue(text(texture, "software").startswith("gabor "))


class Refused(TextureTest):
    def test_wrong_requests(self):
        for words, options in {
            "power of two": ["--size=100x64"], "view flat": ["--size=64x64", "--view=horizon"],
            "requires --view flat": ["--size=64x64", "--view=terrain"],
            "equal tiles": ["--size=256x256", "--region=32,0,64,64"], "unknown '--png=a.png'": ["--size=64x64", "--png=a.png"],
            "conflicts with": ["--size=64x64", "--recipe=paper"],
        }.items():
            self.assert_refused([words], "texture", *options, "-o", "new.exr")
        for size, region in (("256x256", "32,0,128,32"), ("256x256", "0,16,32,32"), ("256x256", "0,64,32,128"),  # not at a tile
                             ("96x64", "0,0,64,64"), ("96x64", "0,0,64,32"), ("64x96", "0,0,64,64"), ("64x96", "0,0,32,64")):  # no whole tiles
            self.assert_refused(["equal tiles", f"--region {region}:", f"picture of {size.replace('x', ' x ')} pixels"], "texture",
                                f"--size={size}", f"--region={region}", "-o", "new.exr")
        self.assert_refused(["a file name that ends in .exr"], "texture", "--size=64x64", "-o", "new.png")
        for option in ("--texture", "--level=1"):
            self.assert_refused(["gabor texture --help"], "render", option, "--size=64x64", "-o", "new.exr")

    @unittest.skipIf(WINDOWS, "Windows has no /dev/full; windows/test_files fills a disk")
    def test_a_full_disk(self):
        self.assert_fails(1, ["/dev/full"], "texture", "--size=64x64", "-o", "/dev/full")


if __name__ == "__main__":
    unittest.main()
