"""Checks textures with OpenImageIO, which most renderers use: every level has the variance that `removed` leaves, unlike
the levels of maketx. Checks that it finds the heights of eroded maps.

tools/test-long farm runs this file with a Python that has OpenImageIO; GABOR_PROGRAM is the program.
"""

import pathlib
import subprocess
import sys
import unittest

import OpenImageIO as oiio

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from program import ProgramTest  # noqa: E402

PROGRAMS = pathlib.Path(sys.executable).parent # maketx and oiiotool come with the package


def noise(side):
    return f"--size={side}x{side}", "--scale=8", "--frequency=2", "--orientation=60", "--seed=7", "--tileable"


def variances(path):
    """Returns the mean square of Y for each level, and the mean of `removed` if it exists."""
    source = oiio.ImageInput.open(str(path))
    levels = []
    while source.seek_subimage(0, len(levels)):
        pixels = source.read_image(0, len(levels), 0, 2, oiio.FLOAT).astype(float)
        channels = dict(zip(source.spec().channelnames, pixels.reshape(-1, pixels.shape[-1]).T))
        levels.append(((channels["Y"]**2).mean(), channels["removed"].mean() if "removed" in channels else None))
    return levels


class OpenImageIO(ProgramTest):
    def run_tool(self, name, *arguments):
        return subprocess.run([PROGRAMS / name, *arguments], cwd=self.folder, check=True, stdout=subprocess.PIPE,
                              text=True).stdout

    def test_levels_have_the_variance_that_the_filter_leaves(self):
        side = 4096 # 512 x 512 kernel radii, so that the sampling error is 0.3 %
        self.succeed("texture", *noise(side), "-o", "ours.exr")
        self.succeed("render", *noise(side), "-o", "flat.exr")
        self.run_tool("maketx", "--filter", "box", "--wrap", "periodic", "flat.exr", "-o", "maketx.exr")
        ours, theirs = variances(self.folder / "ours.exr"), variances(self.folder / "maketx.exr")
        self.assertEqual(len(ours), side.bit_length())
        self.assertEqual(len(theirs), len(ours))
        print("\n| level | 1 - `removed` | `gabor texture` | maketx |\n|---|---|---|---|")
        for level, ((kept, removed), (averaged, _)) in enumerate(zip(ours[:4], theirs)):
            print(f"| {side >> level} x {side >> level} | {1 - removed:.4f} | {kept:.4f} | {averaged:.4f} |")
            self.assertLess(abs(kept - (1 - removed)), 0.01 * max(1 - removed, 0.02), f"level {level}")
        self.assertGreater(1 - ours[0][1], 0.4)
        self.assertLess(ours[3][0], 1e-5)
        self.assertGreater(theirs[3][0], 1e-3, "aliasing")

    def test_it_is_a_texture(self):
        side = 1024
        self.succeed("texture", *noise(side), "-o", "ours.exr")
        said = self.run_tool("oiiotool", "--info", "-v", "ours.exr")
        for words in ('textureformat: "Plain Texture"', 'wrapmodes: "periodic,periodic"', "tile size: 64 x 64",
                      "oiio:AverageColor", "MIP-map levels: 1024x1024 512x512 256x256", " 2x2 1x1\n"):
            self.assertIn(words, said)

        # Samples a pixel that covers one texel, and a distant one that covers 64 x 64 texels and shows only the mean.
        texture, options = oiio.TextureSystem(), oiio.TextureOpt()
        for pixels, smallest, largest, removed in ((1, 1, 5, 0.466), (64, -0.01, 0.01, 1)):
            seen = [texture.texture(str(self.folder / "ours.exr"), options, u / 97, 0.4, pixels / side, 0, 0, pixels / side, 2)
                    for u in range(97)]
            self.assertEqual(texture.geterror(), "")
            highest = max(value for value, _ in seen)
            self.assertTrue(smallest < highest < largest, f"{pixels} pixels: {highest}")
            for _, share in seen:
                self.assertAlmostEqual(share, removed, delta=0.001)


class Heights(ProgramTest):
    def test_the_first_channel_is_the_height(self):
        for name in "all.exr", "one.exr", "map.tif":
            self.succeed("render", "--view=terrain", "--size=64x48", "--seed=3", "--write-heightmap=heights.exr")
            self.succeed("erode", "heights.exr", "-o", name, "--masks=masks", *(["--only-height"] if name == "one.exr" else []))
            pixels = oiio.ImageBuf(str(self.folder / name)).get_pixels(oiio.FLOAT)
            masks = oiio.ImageBuf(str(self.folder / "masks" / "masks.exr"))
            self.assertEqual(masks.spec().channelnames[0], "Y")
            self.assertGreater(pixels[..., 0].std(), 0.1)
            self.assertTrue((pixels[..., 0] == masks.get_pixels(oiio.FLOAT)[..., 0]).all(), name)


if __name__ == "__main__":
    unittest.main()
