"""Presets as pictures, tiles two by two, frames and textures, and what the window says of its own speed."""

import json
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (it finds the next one)
from png import read_colour_png

WINDOW = "--window", "1100x700"
VIEW = 736 # its width, beside the panels
ANIMATION, TEXTURE = 1, 2 # what is exported


class Workshop(EventsTest):
    def preset(self, name, **parameters):
        (self.folder / name).write_text(json.dumps(parameters))
        return name

    def test_presets_are_pictures(self):
        self.open("--window", "1400x900") # large enough to show the pictures at their size
        self.keys("p")
        self.frames(3)
        # The fourth of seven in a row, in cells of 144 pixels in the middle of the view. Its name is at its lower edge.
        left, top = (1036 - 7 * 144) // 2 + 8 + 3 * 144, (900 - 6 * 144) // 2 + 8
        seen = self.screen(left, top, 128, 100)
        preset = self.preset("bark.json", material="bark", seed=12, filter=True, width=128, height=128, scale=32)
        self.gabor("render", "--like", preset, "-o", "bark.png")
        off = np.abs(seen - read_colour_png(self.folder / "bark.png")[:100].astype(int))[4:, 4:-4]
        print(f"bark differs from its picture by {off.mean():.1f} of 255, its standard deviation is {seen.std():.1f}")
        self.assertLess(off.mean(), 0.25 * seen.std()) # the error of a JPEG file
        self.click(left + 64, top + 64)
        self.assertFalse(self.state["gallery"])
        self.assertEqual(self.document["material"], "bark")
        self.keys("p", "Escape")
        self.assertFalse(self.state["gallery"])
        self.close()

    def test_tiles_show_their_seams(self):
        preset = self.preset("tile.json", width=120, height=120, scale=24, frequency=2, orientation=30, tileable=True)
        self.open(*WINDOW, preset)

        def seam():
            """The step from tile to tile, in those within a tile: across and down."""
            self.wait_for(lambda state: state["tiles"] == [120, 120] and state["fine"])
            self.frames(3)
            copies = self.screen(VIEW // 2 - 120, 230, 240, 240)
            self.assertTrue((copies[:, :120] == copies[:, 120:]).all() and (copies[:120] == copies[120:]).all())
            steps = [np.abs(np.diff(copies[..., 0], axis=axis)).mean(axis=axis - 1) for axis in (0, 1)]
            return max(each[119] / np.median(each) for each in steps)

        self.keys("t")
        self.assertLess(seam(), 1.5)
        self.keys("n") # another noise, whose tiles must fit as well
        self.assertLess(seam(), 1.5)
        self.keys("t")
        self.assertIsNone(self.state["tiles"])
        self.close()

    def test_exports_have_the_bytes_of_gabor_render(self):
        preset = self.preset("cloth.json", width=64, height=64, scale=16, frequency=3, orientation=30, tileable=True)
        self.open(*WINDOW, preset)
        self.point(900, 100)
        self.xdotool("click", "--repeat", 40, "--delay", 0, 5) # to the end of the panel
        self.wait_for(lambda state: state["wheel"] == -40)
        self.frames(2)

        def check(kind, count, *options):
            self.click(900, 560) # what to export as
            self.click(900, 590 + 20 * kind)
            self.assertEqual(self.state["export"], kind)
            if kind == ANIMATION:
                self.click(756, 588) # the least number of frames
                self.assertEqual(self.state["animation"], 2)
            self.keys("ctrl+e")
            self.exported()
            self.gabor("render", "--like", preset, *options, "-o", "expected.exr")
            expected = sorted(path.name for path in self.folder.glob("expected*"))
            self.assertEqual(len(expected), count)
            for each in expected:
                self.assertEqual(self.read(each.replace("expected", "noise")), self.read(each), each)
                (self.folder / each).unlink()

        check(ANIMATION, 4, "--frames", 2, "--png", "expected.png")
        check(TEXTURE, 1, "--texture")
        self.close()

    def test_the_window_says_how_fast_it_is(self):
        self.open(*WINDOW)
        self.assertIsNone(self.state["rate"])
        self.keys("m")
        self.wait_for(lambda state: state["rate"])
        self.keys("m")
        self.assertIsNone(self.state["rate"])
        self.close()


if __name__ == "__main__":
    unittest.main()
