"""Tests what artists use most: materials, photographs and the file dialog."""

import json
import pathlib
import sys
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from exr import Exr
from outputs import LANDSCAPE, TERRAIN
from png import read_colour_png

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "fit"))
from textures import colour_noise, write_png  # noqa: E402

WINDOW = "--window", "640x480"
SMALL = {"width": 160, "height": 120, "scale": 40}
PICTURES = {
    "flat": {**SMALL, "material": "carbon-fibre", "filter": True, "seed": 3},
    "horizon": {**SMALL, "material": "carbon-fibre", "filter": True, "view": "horizon"},
    "sphere": {**SMALL, "material": "brushed-metal", "view": "sphere", "yaw": 40},
    "torus": {**SMALL, "material": "brushed-metal", "view": "torus", "pitch": 50, "brushed-metal.streak_contrast": 0.2,
              "brushed-metal.metal_colour": [0.6, 0.4, 0.2]},
    "terrain": {**TERRAIN, **SMALL},
    "landscape": {**LANDSCAPE, **SMALL},
}


class Artist(EventsTest):
    def test_the_window_shows_what_gabor_render_draws(self):
        pictures = self.compare_with_render(PICTURES, """
            open torus.json
            set look 3
            screenshot normal.png
            set look 1
            screenshot colour.png
            keys Escape
            keys ctrl+c
            copy material.glsl""")
        normal, colour = (read_colour_png(self.folder / f"{file}.png") for file in ("normal", "colour"))
        inside = (colour.min(axis=2) > 100)
        self.assertGreater(inside.mean(), 0.1)
        self.assertGreater(normal[inside][:, 2].mean(), 200) # towards the eye
        self.assertGreater(np.abs(colour - pictures["torus"])[inside].mean(), 10)
        copied = (self.folder / "material.glsl").read_text()
        for line in ("GaborBrushedMetal m = gabor_brushed_metal_default();", "m.streak_contrast = 0.2", "m.metal_colour = vec3(0.6, 0.4, 0.2",
                     "return gabor_brushed_metal_at(p, vec2(0.0), m, 0u);", "return srgb(here.material.colour);"):
            self.assertIn(line, copied)

    def test_a_photograph_becomes_a_noise(self):
        write_png(self.folder / "small.png", colour_noise(32))
        write_png(self.folder / "cloth.png", colour_noise(160))
        self.open(*WINDOW, self.preset("plain.json"))
        self.drop("small.png") # which is refused
        self.wait_for(lambda state: not state["fitting"])
        self.assertIn("128", self.state["message"])
        self.assertNotIn("colour", self.document)
        self.drop("cloth.png")
        self.wait_for(lambda state: "colour" in state["document"])
        fit = self.saved("cloth.json")
        self.assertEqual((fit["width"], fit["height"]), (160, 160))
        self.gabor("fit", "cloth.png", "-o", "expected.json")
        expected = json.loads(self.read("expected.json"))
        for each in ("lobes", "colour", "scale"):
            self.assertEqual(fit[each], expected[each])
        self.keys("Tab", "Tab")
        self.assertTrue(self.state["photograph"])
        self.keys("equal", "equal") # zooms in
        self.point(300, 240) # over the noise, which takes the right half of 352 pixels
        self.wait_for(lambda state: state["fine"])
        self.frames(3)
        camera = self.document["viewer"]["camera"]
        self.assertAlmostEqual(float(self.state["reading"].split()[1].strip(",")),
                               sum(camera["x"]) + (300.5 - 264) / (fit["scale"] * camera["zoom"]), delta=0.0051)
        shown = (np.floor(sum(camera[axis]) * fit["scale"] + (np.arange(-25, 25) + 0.5) / camera["zoom"]).astype(int) for axis in "yx")
        off = np.abs(self.screen(88 - 25, 240 - 25, 50, 50) - read_colour_png(self.folder / "cloth.png")[np.ix_(*shown)])
        self.assertLess(np.median(off), 5) # of 255; at another scale 16
        self.keys("ctrl+z") # back to the noise before the fit
        self.assertFalse(self.state["photograph"])
        self.keys("ctrl+s", "Return")
        self.assertNotIn("colour", json.loads(self.read("plain.json")))
        self.assertEqual(json.loads(self.read("cloth.json")), fit)
        self.keys("ctrl+y")
        self.assertTrue(self.state["photograph"])
        self.drop("expected.json") # a preset that was not fitted in this session
        self.assertFalse(self.state["photograph"])
        self.close()
        recent = json.loads((self.folder / "config/gabor-noise/viewer.json").read_text())["recent"]
        self.assertIn(str(self.folder / "cloth.png"), recent)
        self.assertNotIn(str(self.folder / "small.png"), recent)

    def test_copied_code_has_a_valid_name_whatever_the_photograph_is_called(self):
        write_png(self.folder / "steel photo (1).png", colour_noise(160))
        self.play("open steel photo (1).png\nfitted\nkeys ctrl+c\ncopy code.glsl", self.preset("plain.json"), *WINDOW)
        code = (self.folder / "code.glsl").read_text()
        self.assertIn("texture_steel_photo_1_colour", code)
        self.assertNotIn("__", code)

    def test_bodies_have_the_colours_of_a_photograph(self):
        write_png(self.folder / "cloth.png", colour_noise(160))
        self.gabor("fit", "cloth.png", "-o", "cloth.json")
        cloth = {**json.loads(self.read("cloth.json")), "width": 160, "height": 120, "filter": True}
        for name in ("recipe", "tileable"):  # of planes
            del cloth[name]
        self.compare_with_render({view: {**cloth, "view": view} for view in ("sphere", "torus", "slice")}, inside=True)

    def test_the_pixel_under_the_pointer_is_read(self):
        # Pictures are as large as the view beside the panel, so each screen pixel shows one picture pixel.
        for name, parameters in (("noise", {"frequency": 2, "scale": 60}),
                                 ("leather", {"material": "leather", "scale": 60, "filter": True})):
            self.preset(f"{name}.json", width=352, height=480, **parameters)
            self.gabor("render", "--like", f"{name}.json", "-o", "expected.exr")
            expected = Exr(self.folder / "expected.exr").channels
            self.open(*WINDOW, f"{name}.json")
            for x, y in ((40, 90), (200, 300)):
                self.point(x, y)
                self.wait_for(lambda state: state["fine"])
                self.frames(3)
                words = self.state["reading"].split()
                self.assertEqual(words[0], "at")
                for said, at in zip(words[1:3], (x, y)):
                    self.assertAlmostEqual(float(said.strip(",")), (at + 0.5) / 60, delta=0.0051)
                values = dict(zip(words[-2::-2], words[:2:-2]))
                for said, channel in (("value", "Y"), ("height", "height"), ("roughness", "roughness")):
                    if channel in expected:
                        self.assertAlmostEqual(float(values[said]), expected[channel][y, x], delta=0.006 * abs(expected[channel][y, x]))
                if name == "leather":
                    self.assertEqual(len(words[3]), 7)
                    for at, channel in ((1, "R"), (3, "G"), (5, "B")):
                        light = expected[channel][y, x]
                        encoded = 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055
                        self.assertAlmostEqual(int(words[3][at:at + 2], 16), 255 * encoded, delta=0.6)
            self.point(500, 300) # over the panel
            self.frames(2)
            self.assertEqual(self.state["reading"], "")
            self.close()

    def test_the_right_button_moves_the_light(self):
        self.open(*WINDOW, "leather")
        self.point(176, 240) # the middle of the view
        self.xdotool("mousedown", 3)
        self.frames(2)
        for x, y in ((176, 120), (176 + 60, 240), (176, 240 + 120)):
            self.point(x, y)
            self.frames(2)
            self.assertAlmostEqual(self.document["light_azimuth"], np.degrees(np.arctan2(y - 240, x - 176)), delta=0.5)
            self.assertAlmostEqual(self.document["light_elevation"], 90 * (1 - np.hypot(x - 176, y - 240) / 240), delta=0.5)
        self.xdotool("mouseup", 3)
        self.frames(3)
        lit = self.screen(0, 100, 352, 300)
        self.keys("ctrl+z") # undoes the whole drag
        self.assertEqual((self.document["light_azimuth"], self.document["light_elevation"]), (-135, 38))
        self.assertGreater(np.abs(self.shown(0, 100, 352, 300) - lit).mean(), 3)
        self.close()

    def test_the_surroundings_are_chosen_saved_and_exported(self):
        def view():
            self.point(20, 420) # no control, so there is no tooltip
            return self.shown(0, 130, 240, 270) # below the values under the pointer

        for name, parameters in (("leather", {"material": "leather"}), ("relief", {"viewer": {"output": "lit"}})):
            self.open(*WINDOW, self.preset(f"{name}.json", width=352, height=480, scale=60, **parameters))
            room = view()
            self.point(400, 300)
            self.xdotool("click", "--repeat", 30, "--delay", 1, 5) # to the end of the panel
            self.frames(3)
            self.choose("environment", "overcast")
            overcast = view()
            self.assertGreater(np.abs(overcast - room).mean(), 3)
            saved = self.saved(f"{name}.json")
            self.assertEqual((saved if name == "leather" else saved["viewer"])["environment"], "overcast")
            self.keys("ctrl+z")
            self.assertLess(np.abs(view() - room).mean(), 0.5)
            if name == "leather":
                self.gabor("render", "--like", "leather.json", "-o", "leather.exr", "--png", "leather.png")
            else:
                self.command("open relief.json")
                self.command("export relief.exr")
                self.exported()
            self.assertLess(np.abs(read_colour_png(self.folder / f"{name}.png")[130:400, :240] - overcast).mean(), 1)
            self.close()

    def test_files_are_chosen_in_a_dialog(self):
        (self.folder / "folder").mkdir()
        self.preset("folder/mine.json", frequency=3, width=64, height=64)
        self.open(*WINDOW, self.preset("plain.json"))
        self.keys("ctrl+o")
        self.type("folder")
        self.keys("Return") # opens the folder
        self.assertEqual(self.state["dialog"]["folder"], str(self.folder / "folder"))
        self.type("n") # part of the name, not a shortcut
        self.keys("BackSpace")
        self.type("mine.json")
        self.keys("Return")
        self.assertIsNone(self.state["dialog"])
        self.assertEqual((self.document["frequency"], self.document["seed"]), (3, 0))
        self.keys("ctrl+o")
        self.assertIsNotNone(self.state["dialog"])
        self.keys("Escape")
        self.assertIsNone(self.state["dialog"])
        self.keys("n")
        self.assertEqual(self.document["seed"], 1)
        self.close()

    def test_names_in_any_script_are_drawn(self):
        # No font of the panel has the last script's characters, but other installed fonts do.
        scripts = {"latin": "ab", "cyrillic": "жщ", "greek": "ψω", "arabic": "شق", "symbols": "⌶⌷"}
        seen = {}
        self.open(*WINDOW, self.preset("plain.json"))
        for name, (first, second) in scripts.items():
            with self.subTest(name):
                for character in (first, second):
                    folder = self.folder / f"{name}-{character}"
                    folder.mkdir()
                    (folder / f"{4 * character}.json").write_text("{}")
                    self.command(f"open {folder}/{4 * character}.json")
                    self.keys("ctrl+o")
                    self.frames(4)
                    row = self.screen(30, 85, 120, 24) # one row below the parent folder
                    seen[character] = row
                    self.assertGreater((row.max(axis=2) > 150).sum(), 20)
                    self.keys("Escape")
                self.assertGreater((np.abs(seen[first] - seen[second]).max(axis=2) > 100).sum(), 20)
        self.close()


if __name__ == "__main__":
    unittest.main()
