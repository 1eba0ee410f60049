"""Terrain from above and in perspective: rendering, copied code and exports match the view."""

import json
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (it finds the next ones)
from outputs import HEIGHT, WIDTH, OutputsTest
from png import read_colour_png

WINDOW = "--window", "1000x700"
TERRAIN = {"width": WIDTH, "height": HEIGHT, "scale": 40, "octaves": 4, "strength": 0.15, "seed": 3}
VIEWS = {"terrain": {**TERRAIN, "view": "terrain"}, "landscape": {**TERRAIN, "view": "landscape", "pitch": 30, "yaw": 20}}


class Copied(OutputsTest):
    def test_the_window_the_file_and_the_copied_code_agree(self):
        script = []
        for name, parameters in VIEWS.items():
            (self.folder / f"{name}.json").write_text(json.dumps(parameters))
            script += [f"open {name}.json", "keys ctrl+c", f"copy {name}.glsl", f"screenshot {name}.png"]
        self.play("\n".join(script), "terrain.json", "--window", f"{WIDTH}x{HEIGHT}", timeout=900)
        for name in VIEWS:
            with self.subTest(name):
                seen = read_colour_png(self.folder / f"{name}.png").astype(int)
                self.gabor("render", "--like", f"{name}.json", "-o", "expected.png")
                self.assertGreater(seen.std(), 20)
                rendered = np.abs(seen - read_colour_png(self.folder / "expected.png").astype(int)).max(axis=2)
                self.assertLessEqual(np.quantile(rendered, 0.99), 1)
                code = (self.folder / f"{name}.glsl").read_text()
                colours = self.run_code(code, "colour = colour_of_view(at); pixels = vec4(0.0);")[1]
                copied = np.abs(seen - 255 * colours).max(axis=2)
                print(f"{name}: the copied code is off by {np.quantile(copied, 0.99):.2f} of 255 in 99 %")
                self.assertLess(np.quantile(copied, 0.99), 6 if name == "landscape" else 2) # some rays end elsewhere


class Terrain(EventsTest):
    def test_the_mouse_turns_and_zooms(self):
        (self.folder / "hills.json").write_text(json.dumps(VIEWS["landscape"]))
        self.open(*WINDOW, "hills.json")
        before = self.document
        self.point(300, 300)
        self.xdotool("mousedown", 1)
        self.frames(2)
        self.point(350, 280)
        self.frames(2)
        self.xdotool("mouseup", 1)
        self.wait_for(lambda state: state["document"]["yaw"] != before["yaw"])
        self.assertAlmostEqual(self.document["yaw"] - before["yaw"], 20, delta=3)
        self.assertAlmostEqual(self.document["pitch"] - before["pitch"], -8, delta=3)
        self.turn_wheel(4)
        self.assertAlmostEqual(self.document["zoom"], 1.15, delta=0.01)
        self.keys("Home")
        self.assertEqual((self.document["yaw"], self.document["zoom"]), (215, 1))
        self.wait_for(lambda state: state["fine"])
        self.point(300, 600)
        self.wait_for(lambda state: "height" in state["reading"])
        self.point(300, 20) # the sky has no height
        self.wait_for(lambda state: state["reading"] == "")
        self.keys("n")
        self.assertEqual(self.document["seed"], before["seed"] + 1)
        self.keys("ctrl+z")
        self.assertEqual(self.document["seed"], before["seed"])
        self.close()

    def test_every_parameter_has_a_control_that_redraws(self):
        text = json.dumps(VIEWS["terrain"])
        (self.folder / "hills.json").write_text(text)
        names = ("octaves 2", "gully_frequency 4", "strength 0.4", "onset 2", "branching 0", "extent 100")
        self.play("\n".join(f"set {name}\nfine\nscreenshot {name.split()[0]}.png" for name in names),
                  "hills.json", *WINDOW)
        pictures = [read_colour_png(self.folder / f"{name.split()[0]}.png").astype(int) for name in names]
        for earlier, later in zip(pictures[:-2], pictures[1:-1]):
            self.assertGreater(np.abs(earlier - later).mean(), 0.5)


if __name__ == "__main__":
    unittest.main()
