"""Tests what the viewer's window shows, does and refuses."""

import json
import shutil
import subprocess
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from png import read_colour_png


class Window(EventsTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plain.json").write_text("{}") # a noise, not the material shown on first start

    def test_keys_work_from_the_start(self):
        # Tab must not move the focus into a field of the panel, which would then receive the keys.
        self.play("""
            keys Tab
            keys n
            save after.json""", "plain.json", "--window", "640x480")
        self.assertEqual(json.loads((self.folder / "after.json").read_text())["seed"], 1)

    def test_the_panel_works_with_the_mouse(self):
        self.play("""
            fine
            save before.json
            choose material fabric
            save after.json
            keys ctrl+z
            save undone.json
            keys ctrl+y
            save redone.json
            keys ctrl+z
            choose fractal ridged
            save fractal.json""", "plain.json", "--window", "860x500")
        materials = [json.loads((self.folder / f"{name}.json").read_text())["material"]
                     for name in ("before", "after", "undone", "redone")]
        self.assertEqual(materials, ["none", "fabric", "none", "fabric"])
        self.assertEqual(json.loads((self.folder / "fractal.json").read_text())["fractal"], "ridged")

    def test_saving_over_another_document_asks(self):
        self.play("""
            save one.json
            keys n
            save two.json
            save one.json
            keys Escape
            save two.json
            open missing.json
            says cannot read""", "plain.json", "--window", "640x480")
        seeds = [json.loads((self.folder / f"{name}.json").read_text())["seed"] for name in ("one", "two")]
        self.assertEqual(seeds, [0, 1])

    def test_lobes_are_edited_in_the_frequency_plane(self):
        # From the title of the section, frequency 0 is at (72, 131), and the lobe of frequency 4 at (150, 131).
        self.play("""
            fine
            origin Spectrum
            drag 152 135 74 63
            save moved.json
            click 22 199
            rest
            drag 22 199 32 179
            keys Delete
            save same.json
            double_click 127 186
            save added.json
            keys Delete
            save removed.json
            press add
            press add
            save more.json
            keys ctrl+z
            keys ctrl+z
            reset frequency
            save reset.json
            drag 72 209 122 157
            save mirrored.json""", "plain.json", "--window", "860x500")

        def lobes(name):
            saved = json.loads((self.folder / f"{name}.json").read_text())
            return [(lobe["frequency"], lobe["orientation"]) for lobe in saved.get("lobes", [saved])]

        (frequency, orientation), = lobes("moved")
        self.assertAlmostEqual(frequency, 4 * 72 / 78, delta=0.06) # the lobe keeps its distance from the pointer
        self.assertAlmostEqual(orientation, -90, delta=0.7)
        self.assertEqual(lobes("same"), lobes("moved")) # a click on an empty spot deselects
        self.assertEqual(lobes("added")[0], lobes("moved")[0])
        self.assertAlmostEqual(lobes("added")[1][1], 45, delta=1)
        self.assertEqual(lobes("removed"), lobes("moved"))
        self.assertEqual(len({round(orientation, 1) for _, orientation in lobes("more")}), 3)
        self.assertEqual(lobes("reset")[0][0], 4)
        (frequency, orientation), = lobes("mirrored") # its other handle is at (50, 26)
        self.assertAlmostEqual(frequency, 4 * np.hypot(50, 26) / 78, delta=0.06)
        self.assertAlmostEqual(orientation, np.degrees(np.arctan2(-26, -50)), delta=1)

    def test_the_frequency_plane_shows_the_power_of_the_lobes(self):
        self.play("""
            point 300 300
            place Spectrum
            window lobe.png""", "plain.json", "--window", "860x500")
        left, top, _, _ = map(round, self.state["found"])
        plane = read_colour_png(self.folder / "lobe.png")[top:, left:] # as above
        pixels = 78 / 4 # per cycle per kernel radius; the positions are as in the test above
        cell = 2 * 2**2.5 / 72

        def power(f):
            """Returns the power spectrum of the lattice's window, (1 + cos(pi x)) / 2."""
            return (np.sinc(2 * f) / (1 - 4 * f**2))**2

        for x in range(11, 18): # to the right of the lobe and below the axis, where the power falls
            y = 6
            seen = plane[131 + y, 150 + x, 2]
            low, high = (215 * (1 + np.log10(power(max(x / pixels - less, 0)) * power(max(y / pixels - less, 0))) / 5)
                         for less in (0, cell))
            self.assertTrue(low - 6 <= seen <= high + 6, f"{low:.0f} {seen} {high:.0f}")
        self.assertLess(plane[47:107, 52:92].max(), 60) # far from the lobe, only the axes and rings are drawn

    def test_nothing_hides_the_number_of_a_slider(self):
        self.play("""
            point 300 300
            place rings
            window panel.png""", "walnut", "--window", "860x500")
        top = round(self.state["found"][1]) - 9
        sliders = read_colour_png(self.folder / "panel.png")[top:top + 112, 510:716] # rings, waviness, pores and roughness
        colourful = (np.ptp(sliders, axis=2) > 40).reshape(4, 28, -1).sum(axis=2)
        self.assertTrue((colourful[:, 17:].sum(axis=1) > 40).all()) # each has a line at its place
        self.assertEqual(colourful[:, :17].sum(), 0) # the line is below the number
        self.assertGreater((sliders[:, 90:116].min(axis=2) > 150).sum(), 40) # the numbers

    def test_a_tooltip_covers_no_control(self):
        self.open("walnut", "--window", "860x800")
        self.point(600, 760) # below all controls
        x, y = self.beside("rings", 0.44)
        around = lambda: self.shown(0, y + 20, 860, 300) # below the slider and the pointer
        before = around()
        self.point(x, y) # the slider, whose tooltip is as high as its control
        self.wait_for(lambda state: np.abs(around() - before).max() > 20)
        self.frames(3)
        covered = np.abs(around() - before).max(axis=2) > 20
        self.assertGreater(covered[:, :496].sum(), 100) # the tooltip is on the picture
        self.assertEqual(covered[:, 496:].sum(), 0)
        self.close()

    def test_what_has_no_effect_says_so(self):
        self.play("""
            keys p
            set view sphere
            set orientation_spread 90
            set width 64
            set height 64
            screenshot body.png
            set orientation 60
            screenshot turned.png
            keys Escape
            keys t
            says no tiles
            keys p
            set view flat
            set output 1
            screenshot normals.png
            set colours 3
            screenshot coloured.png
            save after.json""", "plain.json", "--window", "640x480")
        files = {name: (self.folder / f"{name}.png").read_bytes() for name in ("body", "turned", "normals", "coloured")}
        self.assertEqual(files["body"], files["turned"])
        self.assertEqual(files["normals"], files["coloured"])
        self.assertFalse(json.loads((self.folder / "after.json").read_text())["filter"])

    def test_dragging_away_and_back_shows_the_same_picture(self):
        self.play("""
            set scale 8
            point 780 700
            fine
            window here.png
            drag 100 300 400 300
            drag 400 500 100 500
            point 780 700
            fine
            window back.png""", "plain.json", "--window", "860x800")
        # Compares only the part above the message about the opened file.
        here, back = (read_colour_png(self.folder / f"{name}.png")[:720, :480] for name in ("here", "back"))
        self.assertLessEqual(np.abs(here - back).max(), 1)
        self.assertGreater(here.std(), 30)

    def test_the_highlight_of_metal_is_not_burnt_out(self):
        self.play("""
            open brushed-metal
            fine
            window metal.png""", "plain.json", "--window", "1000x700")
        view = read_colour_png(self.folder / "metal.png")[:, :630]
        burnt = (view.min(axis=2) >= 254).mean()
        print(f"{100 * burnt:.2f} % of the pixels are white")
        self.assertLess(burnt, 0.01)

    def x11(self, program, *arguments):
        return subprocess.run([program, *map(str, arguments)], env=self.environment(), capture_output=True, text=True, check=True).stdout

    def test_the_window_has_the_same_size_at_each_start_and_fits_the_screen(self):
        fonts = {}
        self.addCleanup(self.x11, "xprop", "-root", "-remove", "RESOURCE_MANAGER")
        for dpi, size in ((192, [1600, 1000]), (120, [1600, 1000]), (96, [1440, 900]), (72, [1080, 675])):
            self.x11("xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER", f"Xft.dpi: {dpi}")
            shutil.rmtree(self.folder / "config", ignore_errors=True)
            for start in range(3):
                self.open("plain.json")
                self.frames(2)
                self.assertEqual(self.state["size"], size, f"start {start} at {dpi} dpi")
                fonts[dpi] = self.state["font"]
                self.command("quit")
                self.end()
        for dpi, font in fonts.items():
            self.assertAlmostEqual(font / fonts[96], dpi / 96, delta=0.1, msg=f"{dpi} dpi")

    def test_a_window_that_was_elsewhere_appears_on_the_screen(self):
        settings = self.folder / "config" / "gabor-noise" / "viewer.json"
        settings.parent.mkdir(parents=True)
        settings.write_text(json.dumps({"placement": {"x": 5000, "y": 900, "width": 800, "height": 600, "maximized": False}}))
        self.open("plain.json")
        self.frames(2)
        place = self.x11("xdotool", "getwindowgeometry", "--shell", self.state["window"])
        place = dict(line.split("=") for line in place.split())
        self.assertEqual([int(place[name]) for name in ("X", "Y", "WIDTH", "HEIGHT")], [800, 400, 800, 600])
        self.close()

    def test_settings_that_cannot_be_kept_are_no_secret(self):
        (self.folder / "config").write_text("no folder")
        self.open("plain.json")
        self.wait_for(lambda state: "cannot keep settings" in state["message"])
        self.assertNotIn("\n", self.state["message"])
        self.close()

    def test_a_code_that_is_no_colour_is_refused(self):
        self.preset("steel.json", material="brushed-metal", width=64, height=64)
        self.open("steel.json", "--window", "860x500")
        self.frames(3)
        before = self.state["document"]
        for typed, says in (("purple", "six hexadecimal digits"), ("12345", "six hexadecimal digits"), ("12ab4f", "")):
            self.click(600, 135)
            self.keys("ctrl+a")
            for letter in typed:
                self.xdotool("type", letter)
                self.frames(3) # a press before the last release may be missed
            self.xdotool("key", "Return")
            self.frames(4)
            if says:
                self.assertIn(says, self.state["message"])
                self.assertEqual(self.state["document"], before)
        self.assertNotEqual(self.state["document"], before)
        self.close()

    def test_the_key_for_tiles_makes_tiles(self):
        self.preset("steel.json", material="brushed-metal", width=512, height=512)
        self.open("steel.json", "--window", "860x500")
        self.keys("t")
        self.wait_for(lambda state: state["tiles"])
        self.assertTrue(self.state["document"]["tileable"])
        self.close()

    def test_without_a_display(self):
        self.assert_fails(1, ["no display"], DISPLAY=None, WAYLAND_DISPLAY=None)

    def test_wrong_requests(self):
        (self.folder / "wrong.json").write_text('{"frequncy": 4}')
        self.assert_fails(2, ["wrong.json", "frequncy", "frequency"], "--preset", "wrong.json")
        self.assert_fails(2, ["missing.json", "JSON"], "--preset", "missing.json")
        self.assert_fails(2, ["--window", "480x320"], "--window", "10x10")
        self.assert_fails(2, ["--help"], "--nonsense")


if __name__ == "__main__":
    unittest.main()
