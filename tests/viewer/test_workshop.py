"""Tests presets shown as pictures, tiles shown two by two, and exports of frames, textures and maps."""

import json
import pathlib
import shutil
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from outputs import COLOURED
from png import read_colour_png, read_deep_png

WINDOW = "--window", "820x700"
VIEW = 456 # the view's width, without the panels
PRESETS = pathlib.Path(__file__).resolve().parents[2] / "host/render/request/presets"
KINDS = "a picture", "an animation", "a texture", "a set of maps" # the list of what to export
ANIMATION, TEXTURE, MAPS = 1, 2, 3


class Workshop(EventsTest):
    def show_exports(self):
        """Scrolls the panel to the section with the exports."""
        self.press("Export")
        self.frames(3)

    def export_as(self, kind):
        """Chooses what to export, and exports it."""
        self.choose("kind", KINDS[kind])
        self.assertEqual(self.state["export"], kind)
        if kind == ANIMATION:
            self.click(*self.beside("frames", 0.01)) # the smallest number
            self.assertEqual(self.state["animation"], 2)
        self.keys("ctrl+e", "Return")
        self.exported()

    def test_presets_are_pictures(self):
        self.open("--window", "1400x980", self.preset("plain.json", width=64)) # large enough to show pictures unscaled
        self.keys("p")
        self.frames(3)
        # Below the noises, bark is sixth, after five kinds of wood. A picture's name covers its lower edge.
        left, top = 14 + 5 * 136, 108
        seen = self.screen(left, top, 128, 100)
        preset = self.preset("bark.json", **json.loads((PRESETS / "bark.json").read_text()) | {"width": 128, "height": 128, "scale": 32})
        self.gabor("render", "--like", preset, "-o", "bark.png")
        off = np.abs(seen - read_colour_png(self.folder / "bark.png")[:100])[4:, 4:-4]
        print(f"bark differs from its picture by {off.mean():.1f} of 255; its standard deviation is {seen.std():.1f}")
        self.assertLess(off.mean(), 0.25 * seen.std()) # JPEG compression error
        self.keys("Escape")
        self.assertFalse(self.state["gallery"])
        # In a small window names stay readable, and the pictures scroll.
        self.resize(640, 480)
        self.keys("p")
        self.point(200, 200)
        self.xdotool("click", "--repeat", 80, "--delay", 1, 5)
        self.frames(3)
        self.press("storm")
        self.assertFalse(self.state["gallery"])
        self.assertEqual(pathlib.Path(self.state["path"]).name, "storm.json")
        self.keys("p")
        self.frames(3)
        self.xdotool("type", "dark oak planks")
        self.wait_for(lambda state: state["search"] == "dark oak planks")
        self.keys("Return")
        self.assertFalse(self.state["gallery"])
        self.assertEqual(pathlib.Path(self.state["path"]).name, "oak-planks.json")
        self.close()

    def test_tiles_are_shown_two_by_two_without_seams(self):
        preset = self.preset("tile.json", width=120, height=120, scale=24, frequency=2, orientation=30, tileable=True)
        self.open(*WINDOW, preset)

        def seam():
            """Returns the steps across seams relative to those within a tile, for the worse of the two axes."""
            self.wait_for(lambda state: state["tiles"] == [120, 120] and state["fine"])
            self.frames(3)
            copies = self.screen(VIEW // 2 - 120, 230, 240, 240)
            self.assertTrue((copies[:, :120] == copies[:, 120:]).all() and (copies[:120] == copies[120:]).all())
            steps = [np.abs(np.diff(copies[..., 0], axis=axis)).mean(axis=axis - 1) for axis in (0, 1)]
            return max(each[119] / np.median(each) for each in steps)

        self.keys("t")
        self.assertLess(seam(), 1.5)
        self.keys("n") # a second noise, whose tiles must match too
        self.assertLess(seam(), 1.5)
        self.keys("t")
        self.assertIsNone(self.state["tiles"])
        self.close()

    def test_exports_have_the_bytes_of_gabor_render(self):
        preset = self.preset("cloth.json", width=64, height=64, scale=16, frequency=3, orientation=30, tileable=True)
        self.open(*WINDOW, preset)
        self.show_exports()

        def check(kind, count, *options, command="render"):
            self.export_as(kind)
            self.gabor(command, "--like", preset, *options, "-o", "expected.exr")
            expected = sorted(path.name for path in self.folder.glob("expected*"))
            self.assertEqual(len(expected), count)
            for each in expected:
                self.assertEqual(self.read(each.replace("expected", "cloth")), self.read(each), each)
                (self.folder / each).unlink()

        check(ANIMATION, 4, "--frames", 2, "--png", "expected.png")
        check(TEXTURE, 1, command="texture")
        self.close()

    def test_maps_have_the_bytes_of_gabor_render(self):
        for name, parameters in (("leather", {"material": "leather", "tileable": True, "scale": 16}),
                                 ("valley", {"view": "landscape", "octaves": 1, "scale": 8, "extent": 900})):
            preset = self.preset(f"{name}.json", width=64, height=48, seed=5, **parameters)
            self.open(*WINDOW, self.preset("plain.json"))
            self.keys("p") # the gallery hides the view, which would take longer than the maps
            self.command(f"open {preset}")
            self.show_exports()
            self.choose("kind", KINDS[MAPS])
            self.command("maps 64")
            self.press("Export now")
            self.wait_for(lambda state: f"wrote maps to the folder {self.folder / name}" in state["message"])
            # As much as the shorter side showed. A tile of mountains shows at least four kernel radii.
            from_above = ["--view=terrain"] if name == "valley" else []
            self.gabor("maps", "--like", preset, *from_above, "--size=64", f"--scale={parameters['scale'] * (64 / 48)!r}", "--tileable",
                       "-o", "expected")
            names = sorted(path.name for path in (self.folder / "expected").iterdir())
            self.assertEqual(sorted(path.name for path in (self.folder / name).iterdir()), names)
            self.assertEqual(len(names), 11)
            for each in names:
                self.assertEqual(self.read(f"{name}/{each}"), self.read(f"expected/{each}"), each)
            if name == "leather":
                self.press("Export now") # an export may overwrite its own files
                self.wait_for(lambda state: not state["exporting"])
                self.assertIsNone(self.state["question"])
                (self.folder / name / "height.png").write_bytes(b"mine")
                self.press("Export now")
                self.assertIn("height.png", self.state["question"])
                self.keys("Escape")
            self.close()
            shutil.rmtree(self.folder / "expected")

    def test_exports_have_the_name_of_their_document_and_ask_before_they_replace_another(self):
        self.open(*WINDOW, self.preset("steel.json", material="brushed-metal", width=64, height=48))
        self.show_exports()
        self.command("maps 64")
        self.keys("ctrl+e", "Return")
        self.exported()
        steel = self.read("steel/base_color.png")
        self.pause(6) # the message stays until the next action
        self.frames(2)
        self.assertLess(self.screen(20, 670, 100, 4).mean(), 60)
        for name in ("hill", "valley"):
            self.rest()
            self.press("Export to...")
            self.type(name) # replaces the name in the field, the second time too
            self.keys("Escape")
        self.command("open steel.json") # scrolls the panel to its top
        self.frames(3)
        self.click(*self.beside("metal colour", 0.97))
        self.frames(2)
        self.assertTrue(self.state["popup"])
        self.keys("Escape")
        self.assertFalse(self.state["popup"])
        self.keys("p")
        self.frames(3)
        self.press("walnut")
        self.assertFalse(self.state["gallery"])
        self.assertEqual(self.state["export_name"], self.state["path"].removesuffix(".json"))
        self.assertEqual(self.read("steel/base_color.png"), steel)
        for name in ("one", "two"):
            self.command("open " + self.preset(f"{name}.json", width=64, height=48))
            self.command("export same.exr")
            self.exported()
        self.assertIn("same.exr", self.state["question"])
        self.keys("Escape")
        self.close()

    def test_a_press_beside_the_colour_picker_closes_it_and_acts(self):
        self.open(*WINDOW, self.preset("steel.json", material="brushed-metal", width=64, height=48))
        x, y = self.beside("metal colour", 0.97)
        for down, opens in ((0, True), (2, False), (0, True)):
            self.rest()
            self.click(x, y + down)
            self.frames(2)
            self.assertEqual(self.state["popup"], opens)
        azimuth = self.document["light_azimuth"]
        self.drag(*self.beside("azimuth", 0.15), *self.beside("azimuth", 0.62))
        self.assertFalse(self.state["popup"])
        self.assertGreater(self.document["light_azimuth"], azimuth + 30)
        self.close()

    def test_the_noise_of_a_photograph_has_a_map(self):
        preset = self.preset("cloth.json", width=64, height=64, scale=32, seed=2, **COLOURED, viewer={"output": "value"})
        self.open(*WINDOW, preset)
        self.show_exports()
        self.command("maps 64")
        self.export_as(MAPS)
        # A tile shows at least two radii of the widest lobe.
        self.gabor("render", "--like", preset, "--tileable", f"--scale={64 / 3!r}", "-o", "expected.exr", "--png", "expected.png")
        self.assertEqual([path.name for path in (self.folder / "cloth").iterdir()], ["base_color.png"])
        off = read_colour_png(self.folder / "cloth/base_color.png") - read_colour_png(self.folder / "expected.png")
        self.assertLessEqual(np.abs(off).max(), 1)
        self.close()

    def test_stripes_have_maps(self):
        preset = self.preset("corduroy.json", width=96, height=48, scale=24, frequency=3, seed=2, tileable=True,
                             viewer={"output": "lit stripes", "colours": "ember", "contrast": 1, "normals": "OpenGL"})
        self.open(*WINDOW, preset)
        self.show_exports()
        self.command("maps 64")
        self.export_as(MAPS)
        self.assertEqual(sorted(path.name for path in (self.folder / "corduroy").iterdir()),
                         ["base_color.png", "height.png", "normal.png"])
        colour, normal = (read_colour_png(self.folder / f"corduroy/{name}.png").astype(float) for name in ("base_color", "normal"))
        height = read_deep_png(self.folder / "corduroy/height.png") / 65535
        self.assertGreater(np.corrcoef(height.ravel(), colour.sum(axis=2).ravel())[0, 1], 0.9) # ember brightens upwards
        # The stripes range from -1 to 1; a slope of 2 / `contrast` standard deviations makes 45 degrees.
        right, up, out = (normal[..., i] / 127.5 - 1 for i in range(3))
        relief = 0.5 * 1 / (2 * np.pi * 3 / np.sqrt(2))
        for axis, seen, sign in ((1, right, -1), (0, up, 1)):
            slope = 2 * 32 * relief * np.diff(height, axis=axis)
            inside = (slice(None), slice(1, None)) if axis == 1 else (slice(1, None), slice(None))
            self.assertLess(np.quantile(np.abs((seen / out)[inside] - sign * slope), 0.95), 0.03)
            self.assertGreater(np.abs(slope).max(), 0.1)
        self.close()


if __name__ == "__main__":
    unittest.main()
