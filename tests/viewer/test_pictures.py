"""Compares what the viewer shows of bodies and exports with what gabor render draws from the same parameters; tests presets."""

import json
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (it finds the next two)
from exr import Exr
from png import read_colour_png

LATER = {"recipe": "pure", "frequency": 6, "orientation": -77, "seed": 4000000000, "time": 0.3}
SPELLED_OUT = {"recipe": "N=2,R=1.2,A=0.5,phases=64,window=1:0.5:0", "frequency": 3, "scale": 40}


class Pictures(EventsTest):
    def preset(self, name, **parameters):
        path = self.folder / name
        path.write_text(json.dumps({"width": 320, "height": 240, "scale": 24, **parameters}))
        return path

    def render(self, preset, *more):
        """The noise that gabor render draws from the preset alone."""
        self.gabor("render", "--like", preset, "-o", "noise.exr", *more)
        return Exr(self.folder / "noise.exr").pixels

    def test_exports_are_those_of_gabor_render(self):
        preset = self.preset("preset.json", **LATER)
        self.play("""
            export out.exr
            exported""", "--preset", preset, "--window", "480x320")
        self.render(preset, "--png", "noise.png")
        for mine, theirs in (("out.exr", "noise.exr"), ("out.png", "noise.png")):
            self.assertEqual((self.folder / mine).read_bytes(), (self.folder / theirs).read_bytes(), mine)

    def test_lit_bodies_are_exported_as_they_are_shown(self):
        preset = self.preset("preset.json", view="torus", frequency=2, yaw=20, filter=True,
                             viewer={"output": "lit", "colours": "ember", "light": [30, 50]})
        self.play("""
            export out.exr
            exported
            screenshot seen.png""", "--preset", preset, "--window", "480x320")
        self.render(preset, "--gradient")
        self.assertEqual((self.folder / "out.exr").read_bytes(), (self.folder / "noise.exr").read_bytes())
        seen, written = (read_colour_png(self.folder / name).astype(int) for name in ("seen.png", "out.png"))
        covered = Exr(self.folder / "noise.exr").channels["A"] == 1
        off = np.abs(seen - written).max(axis=2)[covered]
        self.assertGreater(seen[covered].std(), 20)
        self.assertLessEqual(np.quantile(off, 0.99), 1)

    def test_presets_survive_saving_and_opening(self):
        preset = self.preset("preset.json", **SPELLED_OUT)
        self.play("""
            open preset.json
            says opened
            save again.json
            open missing.json
            says cannot read""")
        self.assertEqual({**json.loads((self.folder / "again.json").read_text()), **json.loads(preset.read_text())},
                         json.loads((self.folder / "again.json").read_text()))
        self.play("""
            set output 3
            set colours 2
            set contrast 3
            point 200 200
            turn_wheel 4 4
            save shown.json
            set output 0
            set colours 0
            keys Home
            open shown.json
            save back.json""")
        shown = (self.folder / "shown.json").read_bytes()
        self.assertEqual(json.loads(shown)["viewer"]["output"], "intensity")
        self.assertEqual((self.folder / "back.json").read_bytes(), shown)
        self.gabor("render", "--like", "shown.json", "--size", "16x16", "-o", "shown.exr")


if __name__ == "__main__":
    unittest.main()
