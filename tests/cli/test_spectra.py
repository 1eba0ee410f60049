"""Tests `gabor render` with spectra, the filter, views, paint, several values and the phasor."""

import json
import re
import unittest

import numpy as np
from matplotlib.image import imsave

from exr import write_exr
from png import read_colour_png
from program import RenderTest

LOBES = [{"frequency": 3.2, "orientation": 0, "power": 3}, {"frequency": 3.2, "orientation": 45, "power": 2.5, "radius": 2},
         {"frequency": 3.2, "orientation": 90, "power": 2}, {"frequency": 3.2, "orientation": 135, "power": 1.5},
         {"frequency": 1.3, "orientation": 20, "power": 1, "radius": 0.8}]


def power(values):
    """Returns the power spectrum, normalized so that variance 1 gives mean 1."""
    return np.abs(np.fft.fft2(values - values.mean())) ** 2 / values.size


def frequencies(side, scale):
    """Returns the x and y frequency of each sample of the spectrum, in cycles per kernel radius."""
    return np.meshgrid(np.fft.fftfreq(side, 1 / scale), np.fft.fftfreq(side, 1 / scale))


class SpectraTest(RenderTest):
    def write_lobes(self, lobes, name="lobes.json"):
        (self.folder / name).write_text(json.dumps(lobes))
        return name


class Spectra(SpectraTest):
    def test_header_keeps_every_field_of_lobes(self):
        lobes = [{"frequency": 3.25, "orientation": -12.5, "frequency_spread": 0.125, "orientation_spread": 7.5,
                  "power": 2.75, "radius": 0.625, "stretch": 1.75},
                 {"frequency": 1.75, "orientation": 210.25, "frequency_spread": 0.375, "orientation_spread": 80.5,
                  "power": 0.3, "radius": 1.0, "stretch": 1.0}]
        first = self.render(output="a.exr", lobes=self.write_lobes({"lobes": lobes}), size="64x48", scale=16)
        self.assertEqual(first.parameters["lobes"], lobes)
        (self.folder / "a.json").write_text(json.dumps(first.parameters))
        for like in ("a.exr", "a.json"):
            again = self.render(output="b.exr", like=like)
            self.assertEqual(again.parameters, first.parameters)
            self.assert_same_bits(again.pixels, first.pixels)

    def test_presets(self):
        listed = re.search(r"other options from a preset: (.*?),\s+or\s+a\s+file", self.succeed("render", "--help"), re.DOTALL)[1]
        self.assertGreaterEqual(len(listed.split(",")), 41)
        height = self.render(preset="wood", size="96x64").channels["height"]
        self.assertTrue(np.isfinite(height).all())
        self.assertGreater(height.std(), 0)

    def test_a_material_has_its_channels_and_is_shown_lit(self):
        whole = self.render("--png=whole.png", material="zebra", size="40x30", scale=20, seed=3).channels
        self.assertEqual({*whole}, {"R", "G", "B", "height", "roughness", "metalness", "lit.R", "lit.G", "lit.B",
                                  "slope.x", "slope.y"})
        light = np.clip(np.dstack([whole[f"lit.{colour}"] for colour in "RGB"]).astype(float), 0, 1)
        shown = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        self.assertLess(np.abs(read_colour_png(self.folder / "whole.png") - 255 * shown).max(), 0.51)

    def test_slopes_that_face_the_light_are_bright(self):
        for options, lights in (({"material": "leather", "scale": 128}, (("x", -1, 0), ("y", 1, -90))),
                                ({"view": "terrain"}, (("x", 1, 180), ("y", -1, 90)))):
            for axis, sign, azimuth in lights:
                channels = self.render(size="64x64", light_azimuth=azimuth, light_elevation=30, **options).channels
                alike = np.corrcoef((channels["lit.G"] / channels["G"]).ravel(), channels[f"slope.{axis}"].ravel())[0, 1]
                self.assertGreater(sign * alike, 0.25, (options, azimuth))
        self.assert_refused(["--light-azimuth", "needs --material NAME, or --view terrain, landscape or ocean"], "render", "-o", "out.exr", "--light-azimuth=30")

    def test_the_light_of_an_overcast_sky_equals_its_integral(self):
        """Compares the sky's light with a sum over the hemisphere above each pixel's normal. In the dark environment,
        only the lamp shines."""
        rough = {"material": "fabric", "fabric.roughness": 1, "size": "12x12", "scale": 12}
        sky, dark = (self.render(environment=each, **rough).channels for each in ("overcast", "dark"))
        cosine, turn = np.meshgrid((np.arange(400) + 0.5) / 400, 2 * np.pi * (np.arange(200) + 0.5) / 200)
        sine = np.sqrt(1 - cosine ** 2)
        for y, x in np.ndindex(12, 12):
            normal = np.array([-sky["slope.x"][y, x], -sky["slope.y"][y, x], 1])
            normal /= np.linalg.norm(normal)
            up = cosine * normal[2] + sine * np.cos(turn) * np.hypot(*normal[:2])
            mean = 2 * (cosine * np.where(up > 0, (1 + 2 * up) / 3, 0.2 * 7 / 9)).mean()
            share = 0.0113 # share of the light that a rough surface reflects uncoloured
            colour = (1 - share) * sky["G"][y, x] + share
            self.assertAlmostEqual(sky["lit.G"][y, x] - dark["lit.G"][y, x], 0.6 * mean * colour, delta=0.015 * mean)
        self.assertEqual(self.render("--like=out.exr", output="again.exr").parameters["environment"], "dark")
        self.assert_refused(["--environment needs --material NAME\n"], "render", "-o", "out.exr", "--environment=dark")

    def test_a_body_has_all_of_a_material_on_every_side(self):
        metal = self.render(material="brushed-metal", view="sphere", size="80x60", scale=20).channels
        np.testing.assert_allclose(metal["metalness"][metal["A"] == 1], 1, atol=0.02)  # blended from up to three planes

    def test_contradictory_requests(self):
        good = self.write_lobes(LOBES)
        (self.folder / "lobes-preset.json").write_text(json.dumps({"lobes": LOBES}))
        (self.folder / "cut.json").write_text('[{"frequency": 3}')
        for words, arguments in [
            (["--lobes", "cannot read", "absent.json"], ["--lobes=absent.json"]),
            (["list of lobes"], ["--lobes", self.write_lobes(3, "number.json")]),
            (["empty"], ["--lobes", self.write_lobes([], "none.json")]),
            (["a JSON list of lobes"], ["--lobes", "cut.json"]),
            (["16"], ["--lobes", self.write_lobes([{}] * 17, "many.json")]),
            (["'colour'", "frequency_spread"], ["--lobes", self.write_lobes([{"colour": 1}], "unknown.json")]),
            (["power", "number"], ["--lobes", self.write_lobes([{"power": "x"}], "text.json")]),
            (["power"], ["--lobes", self.write_lobes([{"power": 0}], "powerless.json")]),
            (["frequency", "0.001"], ["--lobes", self.write_lobes([{"frequency": -1}], "negative.json")]),
            (["radius 0 of a lobe", "0.01 to 100", "kernel radii"],
             ["--lobes", self.write_lobes([{"radius": 0}], "pointlike.json")]),
            (["filter", "recipe", "the lattice recipe"], ["--filter", "--recipe=lattice-4"]),
            (["--orientation-spread", "90"], ["--orientation-spread=91"]),
            (["--frequency-spread", "1"], ["--frequency-spread=1.5"]),
            (["'sideways'", "flat", "horizon"], ["--view=sideways"]),
            (["tileable", "--view flat or terrain"], ["--view=horizon", "--tileable"]),
            (["unknown preset 'woood': did you mean wood? "], ["--preset=woood"]),
            (["--preset", "--like"], ["--preset=wood", f"--like={good}"]),
            (["recipe", "slice"], ["--view=slice", "--recipe=pure"]),
            (["--paint", "a single lobe with --view flat, not 5 lobes"], ["--lobes", good, "--paint=x.exr"]),
            (["absent.exr"], ["--paint=absent.exr"]),
            (["stretched kernels require a lattice recipe"], ["--recipe=one", "--lobes", self.write_lobes([{"stretch": 2}], "oval.json")]),
            (["two kernel radii", "widest lobe"], ["--lobes", good, "--tileable", "--scale=16.1"]),
            (["--material 'mable': did you mean marble? Expected none, wood, "], ["--material=mable"]),
            (["--view 'slcie': did you mean slice? Expected flat, horizon, "], ["--view=slcie"]),
            (["--recipe 'latice-4': did you mean lattice-4? Expected lattice, lattice-2, "], ["--recipe=latice-4"]),
            (["--frequency needs noise of a single lobe, not wood"], ["--material=wood", "--frequency=3"]),
            (["--gradient needs noise, not wood"], ["--material=wood", "--gradient"]),
            (["lobes conflicts with wood: it needs noise"], ["--preset=lobes-preset.json", "--material=wood"]),
            (["only planes and bodies have materials"], ["--material=wood", "--view=slice"]),
        ]:
            self.assert_refused(words, "render", "-o", "out.exr", "--size=64x64", *arguments)
        self.render("--tileable", lobes=good, size="64x64", scale=16)  # the widest radius is 32 pixels


class Filter(SpectraTest):
    def test_it_works_with_time_and_tiles(self):
        # The filter changes noise of this scale by at most 2 %; a larger difference means that it ignores time or tiles.
        options = {"frequency": 2, "scale": 40, "size": "100x100", "seed": 5, "evolution": 0.3}
        for more in ([], ["--tileable"]):
            with self.subTest(more):
                plain = self.render(*more, output="plain.exr", **options).pixels
                error = self.render("--filter", *more, **options).pixels - plain
                self.assertLess(np.sqrt(np.mean(error ** 2)), 0.04)
                self.assertLess(np.abs(error).max(), 0.2)
                self.assertGreater(plain.std(), 0.5)

    def test_each_channel_is_the_normal_filter_of_a_finer_picture(self):
        options = {"orientation": 40, "frequency": 1.2, "seed": 4}
        more = ("--gradient", "--phasor")
        names = {"Y", "quadrature", "gradient.x", "gradient.y"}
        at = (np.arange(1024) + 0.5) / 16
        def weights(pixels):
            weight = np.exp(-2 * (at[None, :16 * pixels] - (np.arange(pixels)[:, None] + 0.5)) ** 2)
            return weight / weight.sum(axis=1, keepdims=True)
        inside = (slice(3, -3), slice(3, -3))  # where the fine picture covers the whole filter
        for time in (0, 0.3):
            seen = self.render("--filter", *more, size="64x48", scale=4, evolution=time, **options).channels
            fine = self.render(*more, output="fine.exr", size="1024x768", scale=64, evolution=time, **options).channels
            self.assertEqual(set(seen), names - {"quadrature"} | {"phase", "intensity", "removed"})
            for channels in (seen, fine):
                channels["quadrature"] = channels["intensity"] * np.cos(2 * np.pi * channels["phase"])
            for name in names:
                expected = weights(48) @ fine[name] @ weights(64).T
                error = np.sqrt(np.mean((seen[name] - expected)[inside] ** 2)) / fine[name].std()
                self.assertLess(error, 0.02, (name, time))
            turn = 2 * np.pi * seen["phase"]
            np.testing.assert_allclose(seen["intensity"] * np.sin(turn), seen["Y"], atol=1e-5)

    def test_removed_variance_has_its_own_channel(self):
        exr = self.render("--filter", frequency=3, scale=6, size="1024x1024")
        removed = exr.channels["removed"]
        self.assertEqual(removed.min(), removed.max())
        self.assertAlmostEqual(exr.pixels.var(), 1 - removed[0, 0], delta=0.01)

    def test_a_plane_to_the_horizon(self):
        exr = self.render("--filter", view="horizon", size="320x240", scale=24, frequency=2, orientation=90)
        removed = exr.channels["removed"]
        self.assertTrue((removed[:60] == 1).all() and (exr.pixels[:60] == 0).all())  # the sky
        self.assertTrue((np.diff(removed[61:].mean(axis=1)) <= 1e-6).all())  # decreasing towards the viewer
        self.assertLess(removed[-1].mean(), 0.25)
        self.assertGreater(removed[62].mean(), 0.99)
        self.assertTrue(np.isfinite(exr.pixels).all())
        near = slice(-60, None)
        self.assertAlmostEqual(exr.pixels[near].var() / (1 - removed[near].mean()), 1, delta=0.25)


class Space(SpectraTest):
    def test_alpha_is_the_shape_of_the_body(self):
        sphere = self.render("--filter", view="sphere", size="200x200", scale=12, orientation_spread=90)
        self.assertEqual(set(sphere.channels), {"Y", "A"})
        covered = sphere.channels["A"] == 1
        self.assertAlmostEqual(covered.mean(), np.pi / 4 / 1.05 ** 2, delta=0.02)
        self.assertEqual(np.abs(sphere.pixels[sphere.channels["A"] == 0]).max(), 0)
        torus = self.render(view="torus", size="200x200", scale=12)
        self.assertLess(torus.channels["A"].mean(), covered.mean())
        solid = self.render("--solid", view="torus", size="200x200", scale=12)
        self.assertTrue((solid.channels["A"] == torus.channels["A"]).all() and (solid.pixels != torus.pixels).any())

    def test_slices_at_different_depths_cut_one_noise(self):
        slices = [self.render(view="slice", size="256x256", scale=4, frequency=1, depth=depth).pixels
                  for depth in (0, 0.01, 5)]
        correlation = [np.mean(slices[0] * other) / slices[0].var() for other in slices]
        self.assertGreater(correlation[1], 0.99)
        self.assertAlmostEqual(correlation[2], 0, delta=0.06)
        self.assertAlmostEqual(slices[0].var(), 1, delta=0.06)

    def test_spectra_in_space(self):
        """A picture of two lobes equals the weighted sum of a picture of each."""
        lobes = [{"frequency": 2, "orientation": 20, "power": 3}, {"frequency": 3, "orientation": 110, "power": 1}]
        for view, ratio in ((["--view=slice", "--depth=1.3"], 3), (["--view=sphere"], 1), (["--view=torus", "--solid"], 2)):
            # A lobe rendered alone would get a different seed than in the sum, so the other lobe stays, with hardly any power.
            second, both, first = (self.render(*view, "--gradient", size="120x100", scale=12, lobes=self.write_lobes(
                [{**lobes[0], "power": of_first}, lobes[1]])).pixels for of_first in (0, ratio, 1e9))
            share = ratio / (ratio + 1)
            # With six seeds, each picture's largest difference is 0.7e-4 to 1.24e-4.
            np.testing.assert_allclose(both, np.sqrt(share) * first + np.sqrt(1 - share) * second, atol=1.5e-4)
            self.assertGreater(np.ptp(second), 1)
            self.assertGreater(np.abs(second - first).max(), 1)
        # Kernels twice as wide at half the frequency are the same noise at twice the scale.
        wide = self.render(view="slice", lobes=self.write_lobes([{"frequency": 1, "radius": 2}]), size="80x60", scale=10)
        plain = self.render(view="slice", frequency=2, size="80x60", scale=20)
        np.testing.assert_allclose(wide.pixels, plain.pixels, atol=4e-5)
        # A narrow spread of orientation in the slice's plane gives a narrow spectrum.
        values = self.render(view="slice", frequency=3, orientation_spread=20, size="384x384", scale=8).pixels
        x, y = frequencies(384, 8)
        measured = power(values)
        self.assertAlmostEqual(values.var(), 1, delta=0.06)
        self.assertLess((measured * np.abs(y)).sum() / (measured * np.abs(x)).sum(), 0.25)

    def test_seeds_in_space_do_not_correlate(self):
        for time in (0, 0.25):
            values = np.array([self.render("--view=slice", size="256x256", scale=4, frequency=1, seed=seed, orientation_spread=90,
                                           evolution=time).pixels.ravel() for seed in range(3)])
            np.testing.assert_allclose(np.cov(values), np.eye(3), atol=0.05)


class Channels(SpectraTest):
    def test_a_slice_drawn_pixel_by_pixel_equals_the_blocks(self):
        options = {"view": "slice", "depth": -3.3, "frequency": 1.3, "frequency_spread": 0.5, "size": "300x200", "scale": 20,
                   "orientation": 25, "evolution": 0.2}
        for spread in (40, 90):
            blocks = self.render("--gradient", output="a.exr", orientation_spread=spread, **options)
            pixels = self.render("--gradient", "--phasor", output="b.exr", orientation_spread=spread, **options)
            for name, values in blocks.channels.items():
                np.testing.assert_allclose(pixels.channels[name], values,
                                           atol=1e-3 if name.startswith("gradient") else 4e-5, err_msg=name)
            turn = 2 * np.pi * pixels.channels["phase"]
            np.testing.assert_allclose(pixels.channels["intensity"] * np.sin(turn), pixels.pixels, atol=1e-4)

    def test_headers_name_the_recipe_used_if_any(self):
        for recipe, options in (("lattice", ["--filter"]), ("lattice-4", ["--frequency-spread=0.2"]),
                                ("one", ["--orientation-spread=90"]), ("paper", ["--lobes", self.write_lobes(LOBES)])):
            self.assertEqual(self.render(*options, size="64x64", recipe=recipe).parameters["recipe"], recipe)
        for options in (["--view=slice"], ["--view=terrain"], ["--material=wood"]):
            self.assertNotIn("recipe", self.render(*options, size="64x64").parameters)

    def test_uniform_paint_is_the_plain_noise(self):
        picture = {"size": "200x150", "scale": 20}
        write_exr(self.folder / "even.exr", {"frequency": np.full((5, 7), 3, "<f4"),
                                             "orientation": np.full((5, 7), 40, "<f4")})
        spreads = {"orientation_spread": 50, "frequency_spread": 0.3}
        for flags, spread in (([], {}), ([], spreads), (["--filter"], spreads)):
            plain = self.render(*flags, output="plain.exr", frequency=3, orientation=40, **picture, **spread).pixels
            even = self.render("--paint=even.exr", *flags, **picture, **spread).pixels
            np.testing.assert_allclose(even, plain, atol=4e-5)

    def test_paint_changes_without_a_seam(self):
        """The paint changes from one noise to another across its middle quarter, from left to right or from top to bottom."""
        frequency = np.repeat(np.array([[2, 2, 5, 5]], "<f4"), 2, axis=0)
        for size, turned in (("400x200", np.asarray), ("200x400", np.transpose)):
            picture = {"size": size, "scale": 40}
            write_exr(self.folder / "ramp.exr", {"frequency": turned(frequency), "orientation": 9 * turned(frequency)})
            ramp = turned(self.render("--paint=ramp.exr", output="ramp_drawn.exr", **picture).pixels)
            first, last = (turned(self.render(frequency=f, orientation=9 * f, **picture).pixels) for f in (2, 5))
            np.testing.assert_allclose(ramp[:, :149], first[:, :149], atol=1e-4)
            np.testing.assert_allclose(ramp[:, 251:], last[:, 251:], atol=1e-4)
            self.assertLess(np.abs(np.diff(ramp, n=2, axis=1)).max(), (2 * np.pi * 6 / 40) ** 2 * 5)
            part = self.render("--paint=ramp.exr", region="100,110,90,80", **picture).pixels
            np.testing.assert_allclose(part, turned(ramp)[110:190, 100:190], atol=1e-5)

    def paint_directions(self, red, green):
        image = np.full((*np.shape(red), 3), 0.3)
        image[..., 0], image[..., 1] = red, green
        imsave(self.folder / "flow.png", image)

    def test_stripes_follow_the_directions_of_a_picture(self):
        picture = {"size": "200x150", "scale": 20, "frequency": 3}
        self.paint_directions(np.full((4, 6), 204 / 255), np.full((4, 6), 51 / 255))
        along = np.degrees(np.arctan2(51 / 255 - 0.5, 204 / 255 - 0.5))
        for turn in (0, 35):
            plain = self.render(output="plain.exr", orientation=along + 90 + turn, **picture).pixels
            painted = self.render("--paint=flow.png", orientation=turn, **picture).pixels
            np.testing.assert_allclose(painted, plain, atol=4e-5)

    def test_directions_turn_the_short_way_around(self):
        """From 177 to -177 degrees, the wave vector turns by 6 degrees and not by 354."""
        self.paint_directions(np.zeros((2, 2)), np.array([[0.53, 0.47]] * 2))
        drawn = self.render("--paint=flow.png", size="400x200", scale=40, frequency=2).pixels
        self.assertLess(np.abs(np.diff(drawn, n=2, axis=1)).max(), (2 * np.pi * 3 / 40) ** 2 * 5)

    def test_what_is_no_paint_is_refused(self):
        for name in "frequency", "orientation":
            channels = {each: np.full((2, 3), 3, "<f4") for each in ("frequency", "orientation")}
            channels[name][1, 2] = np.inf
            write_exr(self.folder / "endless.exr", channels)
            self.assert_refused([f"a value of channel {name} is not finite"], "render", "--paint=endless.exr", "-o", "x.exr")
        wide = np.zeros((257, 65536), "<f2")
        write_exr(self.folder / "large.exr", {"frequency": wide, "orientation": wide})
        self.assert_refused(["paint 'large.exr' has 65536 x 257 pixels: at most 16777216"], "render", "--paint=large.exr", "-o", "x.exr")

    def test_a_grey_picture_has_no_directions(self):
        self.render("--png=grey.png", size="64x64")
        self.assert_refused(["grey.png", "red and green"], "render", "--paint=grey.png", "-o", "x.exr")


if __name__ == "__main__":
    unittest.main()
