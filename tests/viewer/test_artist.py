"""What artists come for: materials, photographs, a dialog for files."""

import json
import pathlib
import sys
import time
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (it finds the next one)
from png import read_colour_png

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "fit"))
from textures import colour_noise, write_png  # noqa: E402

MATERIALS = {
    "flat": {"material": "carbon-fibre", "filter": True, "seed": 3},
    "horizon": {"material": "carbon-fibre", "filter": True, "view": "horizon"},
    "sphere": {"material": "brushed-metal", "view": "sphere", "yaw": 40},
    "torus": {"material": "brushed-metal", "view": "torus", "pitch": 50},
}


class Artist(EventsTest):
    def choose(self, name):
        """Types into the dialog that opens."""
        time.sleep(1) # until its field has the keyboard
        self.xdotool("type", "--delay", 15, name)
        self.keys("Return")

    def test_materials_look_as_gabor_render_draws_them(self):
        for name, parameters in MATERIALS.items():
            text = json.dumps({"width": 160, "height": 120, "scale": 40, **parameters})
            (self.folder / f"{name}.json").write_text(text)
        self.play("\n".join(f"open {name}.json\nscreenshot {name}.png" for name in MATERIALS) + """
            set look 3
            screenshot normal.png
            set look 1
            screenshot colour.png
            key h
            wait 3
            key ctrl+c
            copy material.glsl
            quit""", "--window", "480x320")
        for name in MATERIALS:
            self.gabor("render", "--like", f"{name}.json", "--png", "expected.png", "-o", "expected.exr")
            seen, expected = (read_colour_png(self.folder / f"{file}.png").astype(int) for file in (name, "expected"))
            off = np.abs(seen - expected).max(axis=2)
            self.assertLessEqual(np.quantile(off, 0.995), 1, f"{name}: {off.max()}")
            self.assertGreater(seen.std(), 10, name)
        normal, colour, lit = (read_colour_png(self.folder / f"{file}.png").astype(int)
                               for file in ("normal", "colour", "torus"))
        inside = (colour.min(axis=2) > 100)
        self.assertGreater(inside.mean(), 0.1)
        self.assertGreater(normal[inside][:, 2].mean(), 200) # towards the eye
        self.assertGreater(np.abs(colour - lit)[inside].mean(), 10)
        self.assertIn("gabor_brushed_metal(", (self.folder / "material.glsl").read_text())

    def test_a_photograph_becomes_a_noise(self):
        write_png(self.folder / "small.png", colour_noise(32))
        write_png(self.folder / "cloth.png", colour_noise(160))
        self.open("--window", "1000x700")
        self.drop("small.png") # which is refused
        time.sleep(1)
        self.assertNotIn("colour", self.saved())
        self.drop("cloth.png")

        def fitted():
            self.keys("ctrl+s")
            return self.read("cloth.json")

        fit = json.loads(self.wait_for(fitted))
        self.assertIn("colour", fit)
        self.assertEqual((fit["width"], fit["height"]), (160, 160))
        self.gabor("fit", "cloth.png", "-o", "expected.json")
        expected = json.loads(self.read("expected.json"))
        for each in ("lobes", "colour", "scale"):
            self.assertEqual(fit[each], expected[each])
        self.keys("Tab", "Tab")
        self.close()

    def test_files_are_chosen_in_a_dialog(self):
        (self.folder / "folder").mkdir()
        (self.folder / "folder/mine.json").write_text('{"frequency": 3, "width": 64, "height": 64}')
        self.open("--window", "1000x700")
        self.keys("ctrl+o")
        self.choose("folder") # is entered
        time.sleep(1)
        self.keys("n") # no shortcut: a letter of the name
        self.keys("BackSpace")
        self.choose("mine.json")
        saved = self.saved("folder/mine.json")
        self.assertEqual((saved["frequency"], saved["seed"]), (3, 0))
        for keys in ("ctrl+o", "Escape", "n"):
            self.keys(keys)
            time.sleep(1)
        self.assertEqual(self.saved("folder/mine.json")["seed"], 1)
        self.close()


if __name__ == "__main__":
    unittest.main()
