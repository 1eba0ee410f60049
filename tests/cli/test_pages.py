"""Checks that the examples and figures of README.md and docs are true."""

import gzip
import importlib.util
import pathlib
import re
import sys
import types
import unittest

import numpy as np
from PIL import Image

from exr import Exr
from program import ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "engines"))
import reference  # noqa: E402

README = (ROOT / "README.md").read_text()
RECIPES = (ROOT / "docs" / "recipes.md").read_text()
ENGINES = (ROOT / "docs" / "engines.md").read_text()


class Readme(ProgramTest):
    def test_its_example_is_a_typical_picture(self):
        example = re.search(r"(?m)^ +build/demo/gabor (render .*) -o noise\.png$", README)[1]
        self.succeed(*example.split(), "-o", "noise.exr")
        pixels = Exr(self.folder / "noise.exr").pixels.astype(float)
        for power, truth in ((1, 0), (2, 1), (3, 0), (4, 3)):
            self.assert_plausible(pixels ** power, truth, f"mean of the power {power}")

    def test_commands_of_pages_have_options_that_exist(self):
        known = {}
        for command in ("render", "maps", "texture", "erode", "join", "stats", "fit", "devices", "recipes", "materials"):
            known[command] = set(re.findall(r"--[a-z][\w-]*(?:\.[\w.-]*\w)?", self.succeed(command, "--help")))
        known["render"] |= known["erode"]  # the parameters of erosion
        known["render"] |= {f"--no-{option[2:]}" for option in known["render"]}
        for line in [*self.succeed("materials").splitlines(), "boards", "coat", "finish"]:
            if line:
                for command in ("render", "maps", "texture"):
                    known[command] |= set(re.findall(r"--[a-z][\w-]*\.[\w.-]*\w", self.succeed("materials", line.split()[0])))
        every, seen = set().union(*known.values()), 0
        for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
            text = page.read_text()
            uses = [(known[command], given) for command, given in re.findall(r"\bgabor (%s)\b([^`\n#|]*)" % "|".join(known), text)]
            if page.name in ("gallery.md", "heightmaps.md", "by-example.md"):  # whose other options are gabor's, too
                uses += [(every, given) for given in re.findall(r"`(--[^`]*)`", text)]
            for options, given in uses:
                for option in re.findall(r"(?<![\w-])--[a-z][\w-]*(?:\.[\w.-]*\w)?", given):
                    seen += 1
                    self.assertTrue(option in options, f"{page.name} has {option}, which is no option: {given}")
        self.assertGreater(seen, 60)

    def test_the_cycles_of_recipes_match_the_performance_page(self):
        performance = (ROOT / "docs" / "performance.md").read_text()
        rows = re.findall(r"(?m)^\| `(\S+)` \|.* dB \| (\d+) \|", RECIPES)
        self.assertGreater(len(rows), 4)
        for recipe, cycles in rows:
            self.assertRegex(performance, rf"(?m)^\| gabor_noise, {recipe} \|.* \| {cycles} \| \S+ \|$")


class LivePage(unittest.TestCase):
    def test_it_is_small(self):
        page = ROOT / "docs" / "demo"
        size = sum(len(gzip.compress((page / name).read_bytes())) for name in ("index.html", "page.js", "texts.js", "still.webp", "photograph.webp"))
        print(f"  {size / 1000:.1f} kB compressed")
        self.assertLess(size, 270_000)


class Engines(ProgramTest):
    def test_the_reference_of_the_engines_is_the_noise(self):
        """Compares tests/engines/reference.py with the program, which other tests compare with tests/reference."""
        side, degrees = reference.WIDTH, np.degrees(reference.ORIENTATION)
        self.succeed("render", "-o", "noise.exr", f"--size={side}x{side}", "--scale=32", f"--frequency={reference.FREQUENCY}",
                     f"--orientation={degrees}", f"--seed={reference.SEED}", "--recipe=one")
        error, place = reference.largest_difference("one", Exr(self.folder / "noise.exr").pixels)
        print(f"largest difference {error:.2g} at row and column {place}")
        self.assertLess(error, 1e-5)

    def test_the_reference_finds_a_wrong_value(self):
        for scene in reference.SCENES:
            drawn = reference.values(scene).copy()
            drawn[256, 3] += 1e-4
            error, place = reference.largest_difference(scene, drawn)
            self.assertAlmostEqual(error, 1e-4)
            self.assertEqual(place, (256, 3))

    def test_every_snippet_draws_the_readmes_picture(self):
        """Evaluates each snippet's position, counting rows as its engine does, and the noise there."""
        side = 96
        self.succeed("render", "-o", "noise.exr", f"--size={side}x{side}", "--scale=32", "--frequency=4",
                     "--orientation=45", "--seed=7")
        picture = Exr(self.folder / "noise.exr").pixels
        snippets = re.findall(r"gabor_noise\((.*) / 32\.0, 4\.0, 0\.7854, 7u\)", ENGINES)
        self.assertGreater(len(snippets), 3)
        x, down = np.meshgrid(np.arange(side) + 0.5, np.arange(side) + 0.5)
        vec2 = lambda x, y: types.SimpleNamespace(x=x, y=y, xy=(x, y))
        for snippet in snippets:
            upwards = "gl_FragCoord" in snippet  # OpenGL counts rows from the bottom, other engines from the top
            place = eval(snippet.replace(".xy", ""), {
                "gl_FragCoord": vec2(x, side - down), "FRAGCOORD": vec2(x, down), "position": vec2(x, down),
                "vec2": vec2, "height": side})
            drawn = reference.lattice((0, 0), 1.5 * place.x / 32, 1.5 * place.y / 32)
            difference = np.abs(drawn - picture).max()
            print(f"  {snippet}, y {'up' if upwards else 'down'}: differs by {difference:.1e}")
            self.assertLess(difference, 1e-4, snippet)  # 0.7854 is not quite 45 degrees

    def test_pictures_are_what_tools_gallery_draws(self):
        """Of pictures of each kind, a cheap one."""
        script = ROOT / "tools" / "gallery"
        gallery = {"__file__": str(script), "__name__": "gallery"}
        exec(script.read_text().removesuffix("main()\n"), gallery)
        names = ["noise.png", "recipe-lattice-2",
                 *(f"gallery/{name}" for name in "wood gradient phasor horizon tiled lobes painted animated slice sphere reflections".split())]
        if importlib.util.find_spec("moderngl"):
            names += ["direction-maps", "gallery/fractal"]
        for name in names:
            drawn = gallery["PICTURES"][name]()
            ending = "" if "." in name else ".webp" if isinstance(drawn, list) else ".jpg"
            with self.subTest(name), Image.open(ROOT / "docs" / f"{name}{ending}") as kept:
                if ending == ".webp":
                    self.assertEqual((kept.n_frames, kept.info["loop"]), (len(drawn), 0))
                    kept.seek(5)
                    drawn = drawn[5]
                error = 255 * np.abs(np.asarray(kept.convert("RGB")) / 255 - np.clip(drawn, 0, 1)).mean()
                print(f"{name}: mean difference {error:.2f} of 255")
                self.assertLess(error, 5)


if __name__ == "__main__":
    unittest.main()
