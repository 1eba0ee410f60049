"""Tests `gabor maps`, which writes a material's maps for other programs."""

import json
import pathlib
import subprocess
import unittest
from xml.etree import ElementTree

import numpy as np

from exr import Exr, Texture, header, read_channel_types
from png import read_colour_png, read_deep_colour_png, read_deep_png, read_grey_png
from program import RenderTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = {"base_color.png", "normal.png", "height.png", "roughness.png", "metalness.png", "occlusion.png", "orm.png", "maps.exr",
         "material.mtlx", "material.gltf", "material.json"}
WIDTH, HEIGHT = 96, 64
PLAIN = "--float", "--compression=none"  # what Exr reads
VALIDATE = """
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
const [folder, validator] = process.argv.slice(1), read = name => new Uint8Array(readFileSync(`${folder}/${name}`));
const report = await createRequire(import.meta.url)(validator).validateBytes(read("material.gltf"),
    { externalResourceFunction: async name => read(name) });
console.log(JSON.stringify(report.issues.messages.filter(message => message.severity < 2))); // errors and warnings
"""
# Prints the factors by which MaterialX's shader of the node `metres` multiplies the lowest and the highest height.
CONVERTED = """
import re, sys
import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader as generation
document, library = mx.createDocument(), mx.createDocument()
mx.readFromXmlFile(document, sys.argv[1])
mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
document.importLibrary(library)
generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
system, converters, distance = generation.UnitSystem.create(generator.getTarget()), mx.UnitConverterRegistry.create(), library.getUnitTypeDef("distance")
converters.addUnitConverter(distance, mx.LinearUnitConverter.create(distance))
system.loadLibrary(library)
system.setUnitConverterRegistry(converters)
generator.setUnitSystem(system)
context = generation.GenContext(generator)
context.registerSourceCodeSearchPath(mx.getDefaultDataSearchPath())
context.getOptions().targetDistanceUnit = sys.argv[2]
text = generator.generate("metres", document.getNode("metres"), context).getSourceCode("pixel")
print(*re.findall("metres_out(?:low|high)_unit_in2 = ([0-9.]+)", text))
"""


def encoded(light):
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


class Maps(RenderTest):
    def maps(self, *options, material="strata"):
        self.succeed("maps", "--material", material, f"--size={WIDTH}x{HEIGHT}", "-o", "set", "--no-tileable", *PLAIN, *options)
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
        _, maps = self.maps("--scale=4000", "--width-metres=0.3")
        down, right = np.gradient(maps["height"], 0.3 / WIDTH)
        for axis, slope in (("x", -right), ("y", down)):
            error = (maps[f"normal.{axis}"] / maps["normal.z"] - slope)[1:-1, 1:-1]
            self.assertLess(error.std(), 0.02 * slope.std(), axis)
            self.assertLess(abs(error.mean()), 0.01 * slope.std(), axis)

    def test_occlusion_is_the_mean_over_eight_horizons(self):
        """Beyond an edge, a tile goes on at the other side, and other maps repeat their last pixel."""
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        for options, mode in ([], "clip"), (["--tileable"], "wrap"):
            _, maps = self.maps(*options, "--scale=20", "--bark.depth=0.13", material="bark")
            height, open_sky = maps["height"], 0
            for right, down in ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)):
                slopes = [0 * height]
                for step in 1, 2, 4, 8, 16, 32:
                    at = np.ravel_multi_index((y + step * down, x + step * right), height.shape, mode=mode)
                    slopes.append((height.ravel()[at] - height) * WIDTH / (step * np.hypot(right, down)))
                open_sky = open_sky + 1 / (1 + np.max(slopes, axis=0) ** 2) / 8
            np.testing.assert_allclose(maps["occlusion"], open_sky, atol=1e-6, err_msg=mode)
            self.assertLess(open_sky.min(), 0.7)

    def test_maps_of_terrain(self):
        """Are those of the picture from above: the ground is rough and no metal, and normals follow from its slopes."""
        land = (*PLAIN, "--view=terrain", f"--size={WIDTH}x{HEIGHT}", "--scale=12", "--extent=800", "--seed=3")
        self.succeed("maps", *land, "-o", "land", "--no-tileable")
        self.succeed("render", *land[2:], "--compression=none", "-o", "above.exr")
        maps, above = (Exr(self.folder / name).channels for name in ("land/maps.exr", "above.exr"))
        self.assertEqual(set(maps), {"R", "G", "B", "height", "roughness", "metalness", "normal.x", "normal.y", "normal.z", "occlusion"})
        for name in ("R", "G", "B", "height"):
            np.testing.assert_array_equal(maps[name], above[name], name)
        self.assertEqual((np.ptp(maps["roughness"]), maps["roughness"][0, 0], np.ptp(maps["metalness"]), maps["metalness"][0, 0]), (0, 1, 0, 0))
        for axis, slope in (("x", -above["slope.x"]), ("y", above["slope.y"])):
            np.testing.assert_allclose(maps[f"normal.{axis}"] / maps["normal.z"], slope, rtol=1e-4, atol=1e-5)
        self.assertLess(maps["occlusion"].min(), 0.8)
        for extent in 8, 8000:
            self.succeed("maps", *(each for each in land if "extent" not in each), f"--extent={extent}", "-o", "same", "--no-tileable")
            same = Exr(self.folder / "same/maps.exr").channels
            np.testing.assert_allclose(same["height"], maps["height"] * extent / 800, rtol=1e-5, atol=1e-6 * extent)
            for name in maps.keys() - {"height"}:
                np.testing.assert_allclose(same[name], maps[name], rtol=1e-5, atol=1e-5, err_msg=f"{name} of a land of {extent} m")

    def test_heights_alone_have_32_bits_unless_asked_for(self):
        """The others are the nearest halves."""
        _, whole = self.maps()
        for options, method in ((["--compression=none"], 0), ([], 3), (["--texture", "--compression=none"], 0)):
            size = "64" if "--texture" in options else f"{WIDTH}x{HEIGHT}"
            self.succeed("maps", "--material=strata", f"--size={size}", "-o", "halves", "--no-tileable", *options)
            attributes = header(self.folder / "halves/maps.exr")
            self.assertEqual(attributes["compression"][1], bytes([method]))
            types = read_channel_types(attributes["channels"][1])
            self.assertEqual({name for name, kind in types.items() if kind == "<f4"}, {"height"})
            self.assertEqual(set(types.values()), {"<f2", "<f4"})
            if options == ["--compression=none"]:
                for name, values in Exr(self.folder / "halves/maps.exr").channels.items():
                    np.testing.assert_array_equal(values, whole[name].astype(types[name]), name)

    def test_tiles_have_no_seam_in_any_map(self):
        _, maps = self.maps("--tileable", material="leather")
        for name, values in maps.items():
            for axis in (0, 1):
                seam = np.abs(values.take(0, axis) - values.take(-1, axis)).mean()
                self.assertLessEqual(seam, 1.6 * np.abs(np.diff(values, axis=axis)).mean(), name)

    def test_scratches_of_a_tile_are_as_thin_as_others(self):
        """Measures the largest square within scratches, in pixels."""
        for option in ("--tileable", "--no-tileable"):
            self.succeed("maps", "--material=scratches", "--seed=5", "--size=384", "--scale=96", "--width-metres=4", *PLAIN, option, "-o", "set")
            inside, side = Exr(self.folder / "set/maps.exr").channels["height"] < -0.25 * 0.0025, 0
            while inside.any():
                inside, side = inside[:-1, :-1] & inside[1:, :-1] & inside[:-1, 1:] & inside[1:, 1:], side + 1
            print(f"{option}: {side}")
            self.assertLessEqual(side, 5, option)

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
        folder, maps = self.maps("--strata.relief=0.2")
        scene = json.loads((folder / "material.gltf").read_text())
        self.assertEqual({image["uri"] for image in scene["images"]}, {"base_color.png", "normal.png", "orm.png"})
        self.assertEqual(Exr(folder / "maps.exr").parameters["strata.relief"], 0.2)
        document = ElementTree.fromstring((folder / "material.mtlx").read_text())
        files = {node.get("name"): node.find("input[@name='file']").get("value") for node in document.iterfind("tiledimage")}
        self.assertEqual(files, {name: f"{name}.png" for name in ("base_color", "roughness", "metalness", "normal", "height")})
        surface = {each.get("name"): each.get("nodename") for each in document.find("standard_surface") if each.get("nodename")}
        self.assertEqual(surface, {"base_color": "base_color", "specular_roughness": "roughness", "metalness": "metalness", "normal": "bumped"})
        material, = scene["materials"]
        for part, file in ((material["pbrMetallicRoughness"]["baseColorTexture"], "base_color"), (material["normalTexture"], "normal"),
                           (material["pbrMetallicRoughness"]["metallicRoughnessTexture"], "orm"), (material["occlusionTexture"], "orm")):
            self.assertEqual(scene["images"][scene["textures"][part["index"]]["source"]]["uri"], f"{file}.png")
        described = json.loads((folder / "material.json").read_text())
        self.assertEqual({described["name"], material["name"], document.find("surfacematerial").get("name")}, {"strata"})
        for name in ("base_color", "normal", "height", "roughness", "metalness", "occlusion"):
            self.assertEqual(described[name]["file"], f"{name}.png")
            self.assertEqual(described[name]["color_space"], "sRGB" if name == "base_color" else "Non-Color")
        self.assertEqual(Exr(folder / "maps.exr").attributes["oiio:ColorSpace"][1], b"lin_rec709")

    def test_documents_state_the_size_and_the_heights_in_metres(self):
        for options, metres in (([], 1), (["--width-metres=0.2"], 0.2)):
            folder, maps = self.maps(*options)
            scale = Exr(folder / "maps.exr").parameters["scale"]
            self.succeed("render", "--material=strata", f"--size={WIDTH}x{HEIGHT}", f"--scale={scale}", "--filter", "-o", "picture.exr")
            radius = metres * scale / WIDTH
            np.testing.assert_allclose(maps["height"], radius * Exr(self.folder / "picture.exr").channels["height"], rtol=1e-6)
            self.assert_metres(folder, (metres, metres * HEIGHT / WIDTH), maps["height"])
        for options, metres in (([], 8000), (["--width-metres=2"], 2)):
            self.succeed("maps", "--view=terrain", f"--size={WIDTH}", "--extent=8000", "-o", "land", *PLAIN, *options)
            self.succeed("render", "--view=terrain", f"--size={WIDTH}", "--extent=8000", "--like=land/maps.exr", "-o", "above.exr")
            heights = Exr(self.folder / "land/maps.exr").channels["height"]
            np.testing.assert_allclose(heights, Exr(self.folder / "above.exr").channels["height"] * (metres / 8000), rtol=1e-6)
            self.assert_metres(self.folder / "land", (metres, metres), heights)
        self.succeed("maps", "--material=strata", "--strata.relief=0", "--size=32", "-o", "flat", *PLAIN)
        heights = Exr(self.folder / "flat/maps.exr").channels["height"]
        self.assertEqual(np.ptp(heights), 0)
        self.assert_metres(self.folder / "flat", (1, 1), heights)

    def assert_metres(self, folder, size, heights):
        """Checks the sizes and ranges of heights that all documents state, and that Blender's formula, strength * (pixel - midlevel),
        makes these heights of height.png."""
        attributes = Exr(folder / "maps.exr").attributes
        self.assertEqual((attributes["gabor.width"], attributes["gabor.unit"]), (("float", np.float32(size[0]).tobytes()), ("string", b"metre")))
        described = json.loads((folder / "material.json").read_text())
        scene = json.loads((folder / "material.gltf").read_text())
        document = ElementTree.parse(folder / "material.mtlx")

        def values(name):
            return [[float(number) for number in each.get("value").split(",")] for each in document.iterfind(f".//input[@name='{name}']")]

        for found in (described["metres"], scene["nodes"][0]["scale"][:2], *values("realworldimagesize"), *values("realworldtilesize")):
            np.testing.assert_allclose(found, size, rtol=1e-6)
        for low, high in ((described["height"]["low"], described["height"]["high"]), (values("outlow")[0][0], values("outhigh")[0][0]),
                          [scene["materials"][0]["extras"]["height"][end] for end in ("low", "high")]):
            np.testing.assert_allclose((low, high), (heights.min(), heights.max()), rtol=1e-5)
        self.assertEqual({(each.get("unittype"), each.get("unit")) for name in ("outlow", "outhigh")
                          for each in document.iterfind(f".//input[@name='{name}']")}, {("distance", "meter")})
        strength, midlevel = described["height"]["strength"], described["height"]["midlevel"]
        shown = strength * (read_deep_png(folder / "height.png") / 65535 - midlevel)
        np.testing.assert_allclose(shown, heights, rtol=0, atol=2e-5 * strength)

    def test_maps_tile_and_have_2048_pixels_unless_asked_for_otherwise(self):
        def described(*options):
            self.succeed("maps", "-o", "set", *PLAIN, *options)
            facts = json.loads((self.folder / "set/material.json").read_text())
            return *facts["pixels"], facts["tileable"], Exr(self.folder / "set/maps.exr").parameters["scale"]

        self.assertEqual(described("--view=terrain", "--octaves=0"), (2048, 2048, True, 256))
        self.assertEqual(described("--material=wood", "--size=64"), (64, 64, True, 16))
        self.assertEqual(described("--material=wood", "--size=32x16", "--no-tileable"), (32, 16, False, 4))
        self.assertEqual(described("--preset=hills", "--size=64"), (64, 64, True, 16))  # a landscape, from above: the least tile
        width, height, scale = (json.loads((ROOT / "host/render/request/presets/walnut.json").read_text()).get(name, 1024) for name in ("width", "height", "scale"))
        for size in ((64, 32), (32, 64)):
            self.assertEqual(described("--preset=walnut", f"--size={size[0]}x{size[1]}"), (*size, True, scale * 32 / min(width, height)))
        self.assertEqual(described("--preset=hills", "--size=64x32"), (64, 32, True, 8))  # its shorter side is the least
        self.assertEqual(described("--preset=walnut", "--size=32", "--scale=9"), (32, 32, True, 9))
        self.assertEqual(described("--preset=walnut", "--size=32", "--scale=40"), (32, 32, True, 40))  # a tile of any size
        self.succeed("render", "--material=wood", "--size=40x30", "--scale=10", "-o", "earlier.exr")
        self.assertEqual(described("--like=earlier.exr"), (40, 30, False, 10))

    def test_documents_are_valid(self):
        gltf = ROOT / "tests/engines/three/node_modules/gltf-validator"
        mxvalidate = ROOT / "build/venv/bin/mxvalidate"
        if missing := [path.name for path in (gltf, mxvalidate) if not path.exists()]:
            self.skipTest(f"not installed: {', '.join(missing)}; tools/test-engines three materialx-glsl installs them")
        folder, _ = self.maps(material="brushed-metal")  # a name with a hyphen
        valid = subprocess.run([mxvalidate, folder / "material.mtlx"], capture_output=True, text=True).stdout
        self.assertIn("is a valid MaterialX document", valid)
        report = subprocess.run(["node", "--input-type=module", "--eval", VALIDATE, folder, gltf], capture_output=True, text=True)
        self.assertEqual(json.loads(report.stdout), [], report.stderr)

    def test_blender_displaces_by_the_heights(self):
        python = ROOT / "build/blender/bin/python"
        if not python.exists():
            self.skipTest("not installed: bpy; tools/test-engines blender installs it")
        folder, maps = self.maps("--width-metres=0.3")
        heights = self.folder / "heights.npy"
        subprocess.run([python, ROOT / "tests/engines/blender/displaced.py", folder, heights], check=True, capture_output=True)
        error = np.abs(np.load(heights) - maps["height"])
        print(f"Blender's heights differ by at most {error.max() / np.ptp(maps['height']):.2g} of their range, at {np.unravel_index(error.argmax(), error.shape)}")
        self.assertLess(error.max(), 2e-5 * np.ptp(maps["height"]))

    def test_materialx_converts_heights_to_the_unit_of_a_scene(self):
        python = ROOT / "build/venv/bin/python"
        if not (ROOT / "build/venv/bin/mxvalidate").exists():
            self.skipTest("not installed: MaterialX; tools/test-engines materialx-glsl installs it")
        folder, _ = self.maps()
        for unit, factor in (("meter", 1), ("centimeter", 100)):
            factors = subprocess.run([python, "-c", CONVERTED, folder / "material.mtlx", unit], check=True, capture_output=True, text=True).stdout
            self.assertEqual([float(each) for each in factors.split()], [factor, factor])

    def test_levels_reflect_a_light_as_their_pixels_do(self):
        """Compares the GGX highlight on each pixel of a mip level with the mean highlight on the fine pixels that it covers."""
        self.succeed("maps", "--material=leather", "--size=8x32", "-o", "oblong", "--texture", *PLAIN)
        self.assertEqual([level["R"].shape for level in Texture(self.folder / "oblong" / "maps.exr").levels], [(32 >> k, max(8 >> k, 1)) for k in range(6)])
        side, block = 256, 16
        self.succeed("maps", "--material=leather", "--leather.relief=1.67", f"--size={side}x{side}", "-o", "set", "--texture", *PLAIN)
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
        slopes = [fine[f"normal.{axis}"].astype(float) / fine["normal.z"] for axis in "xy"]
        for axis, slope in zip("xy", slopes):
            np.testing.assert_allclose(coarse[f"normal.{axis}"] / coarse["normal.z"], means(slope), rtol=0, atol=1e-4)
        lost = sum(means(slope**2) - means(slope)**2 for slope in slopes)
        np.testing.assert_allclose(coarse["roughness"]**4, np.minimum(means(fine["roughness"]**4) + 0.5 * lost, 1), rtol=1e-3)
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
        for words, options in ((["maps require", "a material"], []), (["view flat"], ["--material=wood", "--view=sphere"]),
                               (["at most 8192 x 8192"], ["--material=wood", "--size=8193x64"]),
                               (["unknown '--frames=2'", "gabor maps --help"], ["--material=wood", "--frames=2"])):
            self.assert_refused(words, "maps", "-o", "set", *options)
            self.assertEqual(self.files(), {})
        self.assert_refused(["power of two"], "maps", "--material=wood", "--size=96x96", "-o", "set", "--texture")
        self.assert_refused(["--width-metres '-1': expected a width above 0"], "maps", "--material=wood", "-o", "set", "--width-metres=-1")
        self.assert_refused(["--maps", "gabor maps --help"], "render", "--material=wood", "--maps", "set")
        self.assert_refused(["--normal-bits '12': expected 8 or 16"], "maps", "--material=wood", "-o", "set", "--normal-bits=12")
        (self.folder / "file").write_text("mine")
        self.assert_refused(["cannot create the folder 'file'"], "maps", "--material=wood", "-o", "file")
        self.assert_refused(["--output 'wood.png': expected a folder for the maps"], "maps", "--material=wood", "-o", "wood.png")
        self.assertEqual((self.folder / "file").read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
