"""Tests `gabor render --maps`, which writes a material's maps for other programs."""

import json
import unittest
from xml.etree import ElementTree

import numpy as np

from exr import Exr, Texture
from png import read_colour_png, read_deep_colour_png, read_deep_png, read_grey_png
from program import RenderTest

FILES = {"base_color.png", "normal.png", "height.png", "roughness.png", "metalness.png", "occlusion.png", "orm.png", "maps.exr",
         "material.mtlx", "material.gltf"}
WIDTH, HEIGHT = 96, 64


def encoded(light):
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


class Maps(RenderTest):
    def maps(self, *options, material="bark"):
        self.succeed("render", "--material", material, f"--size={WIDTH}x{HEIGHT}", "--maps", "set", *options)
        folder = self.folder / "set"
        channels = Exr(folder / "maps.exr").channels
        return folder, {name: values.astype(float) for name, values in channels.items()}

    def test_images_show_the_channels(self):
        folder, maps = self.maps()
        self.assertEqual({path.name for path in folder.iterdir()}, FILES)
        colour = np.dstack([maps[name] for name in "RGB"])
        normal = np.dstack([maps[f"normal.{axis}"] for axis in "xyz"])
        orm = np.dstack([maps[name] for name in ("occlusion", "roughness", "metalness")])
        height = maps["height"]
        self.assertLessEqual(np.abs(read_deep_colour_png(folder / "normal.png") - 65535 * (0.5 + 0.5 * normal)).max(), 0.51)
        for name, expected in (("base_color", encoded(colour)), ("orm", orm)):
            self.assertLessEqual(np.abs(read_colour_png(folder / f"{name}.png") - 255 * expected).max(), 0.51, name)
        for name in ("roughness", "metalness", "occlusion"):
            self.assertLessEqual(np.abs(read_grey_png(folder / f"{name}.png") - 255 * maps[name]).max(), 0.51, name)
        expected = 65535 * (height - height.min()) / (height.max() - height.min())
        self.assertLessEqual(np.abs(read_deep_png(folder / "height.png") - expected).max(), 1)
        np.testing.assert_allclose((normal ** 2).sum(axis=2), 1, atol=1e-6)
        self.assertTrue(((maps["occlusion"] > 0) & (maps["occlusion"] <= 1)).all())

    def test_normals_match_the_height(self):
        """A normal's x axis points right and its y axis up. At this scale, the height is smooth over two pixels."""
        scale = 4000
        _, maps = self.maps(f"--scale={scale}")
        down, right = np.gradient(maps["height"], 1 / scale)
        for axis, slope in (("x", -right), ("y", down)):
            error = (maps[f"normal.{axis}"] / maps["normal.z"] - slope)[1:-1, 1:-1]
            self.assertLess(error.std(), 0.02 * slope.std(), axis)
            self.assertLess(abs(error.mean()), 0.01 * slope.std(), axis)

    def test_hollows_are_darker(self):
        _, maps = self.maps()
        height, occlusion = maps["height"], maps["occlusion"]
        low = height < np.quantile(height, 0.1)
        self.assertLess(occlusion[low].mean(), 0.9 * occlusion[height > np.quantile(height, 0.9)].mean())

    def test_tiles_have_no_seam_in_any_map(self):
        _, maps = self.maps("--tileable", material="leather")
        for name, values in maps.items():
            for axis in (0, 1):
                seam = np.abs(values.take(0, axis) - values.take(-1, axis)).mean()
                self.assertLessEqual(seam, 1.6 * np.abs(np.diff(values, axis=axis)).mean(), name)

    def test_directx(self):
        folder, maps = self.maps("--directx")
        ours, theirs = (read_deep_colour_png(folder / f"{name}.png") for name in ("normal", "normal_directx"))
        np.testing.assert_array_equal(ours[..., ::2], theirs[..., ::2])
        self.assertLessEqual(np.abs(ours[..., 1] + theirs[..., 1] - 65535).max(), 1)

    def test_dithered_normals_keep_their_local_mean(self):
        """The mean over 8 x 8 pixels is within a fifth of a step, that of rounded normals is not."""
        folder, maps = self.maps("--normal-bits=8", "--scale=4000", material="marble")
        wanted = 255 * (0.5 + 0.5 * np.dstack([maps["normal.x"], maps["normal.y"]]))
        off = read_colour_png(folder / "normal.png")[..., :2] - wanted
        means = off.reshape(HEIGHT // 8, 8, WIDTH // 8, 8, 2).mean((1, 3))
        print(f"dithered normals are off by at most {np.abs(off).max():.2f} steps, their means by {np.abs(means).max():.3f}")
        self.assertLess(np.abs(off).max(), 1.01)
        self.assertLess(np.abs(means).max(), 0.2)

    def test_documents_name_files_of_the_set(self):
        folder, maps = self.maps("--bark.depth=0.2")
        scene = json.loads((folder / "material.gltf").read_text())
        self.assertEqual({image["uri"] for image in scene["images"]}, {"base_color.png", "normal.png", "orm.png"})
        height = scene["materials"][0]["extras"]["height"]
        np.testing.assert_allclose((height["low"], height["high"]), (maps["height"].min(), maps["height"].max()), rtol=1e-6)
        parameters = Exr(folder / "maps.exr").parameters
        self.assertEqual(parameters["bark.depth"], 0.2)
        np.testing.assert_allclose(scene["nodes"][0]["scale"], (1, HEIGHT / WIDTH, 1), rtol=1e-8)
        text = (folder / "material.mtlx").read_text()
        self.assertIn(f"{height['low']:.9g} to {height['high']:.9g}, for a picture {WIDTH / parameters['scale']:g} wide", text)
        document = ElementTree.fromstring(text)
        files = {each.get("value") for each in document.iterfind(".//input[@name='file']")}
        self.assertEqual(files, {"base_color.png", "roughness.png", "metalness.png", "normal.png"})
        self.assertEqual(Exr(folder / "maps.exr").attributes["oiio:ColorSpace"][1], b"lin_rec709")

    def test_levels_reflect_a_light_as_their_pixels_do(self):
        """Compares the GGX highlight on each pixel of a mip level with the mean highlight on the fine pixels that it covers."""
        side, block = 256, 16
        self.succeed("render", "--material=leather", f"--size={side}x{side}", "--maps", "set", "--texture")
        levels = Texture(self.folder / "set" / "maps.exr").levels
        fine, coarse = levels[0], levels[block.bit_length() - 1]

        def means(values):
            return values.reshape(side // block, block, side // block, block).mean((1, 3))

        def highlight(level, roughness, light):
            normal = np.dstack([level[f"normal.{axis}"] for axis in "xyz"]).astype(float)
            between = (light + [0, 0, 1]) / np.linalg.norm(light + [0, 0, 1])
            cosine = np.clip(normal @ between, 0, None)
            return np.clip(normal @ light, 0, None) * roughness**4 / (cosine**2 * (roughness**4 - 1) + 1)**2

        for name in "RGB":
            np.testing.assert_allclose(coarse[name], means(fine[name]), rtol=1e-4)
        error, careless = [], []
        for elevation, azimuth in ((0.1, 0), (0.4, 2), (0.4, 4), (0.8, 1)):
            light = np.array([np.sin(elevation) * np.cos(azimuth), np.sin(elevation) * np.sin(azimuth), np.cos(elevation)])
            wanted = means(highlight(fine, fine["roughness"].astype(float), light))
            for errors, roughness in ((error, coarse["roughness"].astype(float)), (careless, means(fine["roughness"]))):
                errors.append(np.sqrt(np.mean((highlight(coarse, roughness, light) - wanted)**2) / np.mean(wanted**2)))
        print(f"highlights are off by {np.mean(error):.2f} of their rms, and by {np.mean(careless):.2f} with the mean roughness")
        self.assertLess(np.mean(error), 0.35)
        self.assertGreater(np.mean(careless), 3 * np.mean(error))

    def test_what_is_refused(self):
        for words, options in ((["--maps", "a material"], []), (["view flat"], ["--material=wood", "--view=sphere"]),
                               (["at most 8192 x 8192"], ["--material=wood", "--size=8193x64"]),
                               *((["--maps", "combined with -o"], ["--material=wood", *other]) for other in
                                 (["-o", "a.exr"], ["--png=a.png"], ["--heightmap=a.png"], ["--elevation=0,1"],
                                  ["--region=0,0,8,8"], ["--frames=2"], ["--level=1"]))):
            self.assert_refused(words, "render", "--maps", "set", *options)
            self.assertEqual(self.files(), {})
        self.assert_refused(["power of two"], "render", "--material=wood", "--size=96x96", "--maps", "set", "--texture")
        self.assert_refused(["--half requires --texture"], "render", "--material=wood", "--maps", "set", "--half")
        self.assertEqual(self.files(), {})
        for option in ("--directx", "--normal-bits=8"):
            self.assert_refused([f"{option.partition('=')[0]} requires --maps"], "render", "--material=wood", "-o", "a.exr", option)
        self.assert_refused(["--normal-bits '12': expected 8 or 16"], "render", "--material=wood", "--maps", "set", "--normal-bits=12")
        (self.folder / "file").write_text("mine")
        self.assert_refused(["cannot create the folder 'file'"], "render", "--material=wood", "--maps", "file")
        self.assertEqual((self.folder / "file").read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
