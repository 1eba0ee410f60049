"""Tests `gabor render --view ocean`, which draws a sea in perspective."""

import unittest

import numpy as np
from exr import Exr
from program import ProgramTest


def variance(wind, fetch):
    """The integral of the JONSWAP spectrum: square metres."""
    reach = min(9.81 * fetch / wind**2, 2.15e4) # fully developed
    peak, alpha = 3.5 * 9.81 / wind * reach**-0.33, 0.076 * reach**-0.22
    f = np.linspace(0.3 * peak, 20 * peak, 200000)
    width = np.where(f < peak, 0.07, 0.09)
    density = (alpha * 9.81**2 / (2 * np.pi) ** 4 / f**5 * np.exp(-1.25 * (peak / f) ** 4)
               * 3.3 ** np.exp(-0.5 * ((f / peak - 1) / width) ** 2))
    return density.sum() * (f[1] - f[0])


class Ocean(ProgramTest):
    def drawn(self, *options, size="96x64"):
        self.succeed("render", "--view=ocean", f"--size={size}", "-o", "out.exr", *options)
        return Exr(self.folder / "out.exr").channels

    def test_the_sky_has_no_water_and_its_sun_shines_on_the_sea(self):
        sea = self.drawn("--wind=8", "--seed=3", "--light-azimuth=70", "--light-elevation=6", "--yaw=250", "--pitch=4")
        self.assertEqual(set(sea), {"R", "G", "B", "height", "slope.x", "slope.y", "lit.R", "lit.G", "lit.B", "jacobian", "foam"})
        water = sea["jacobian"] > 0
        self.assertFalse(water[:20].any())
        self.assertTrue(water[40:].all())
        for name in sea:
            self.assertTrue(np.isfinite(sea[name]).all(), name)
        self.assertFalse(sea["height"][:20].any())
        self.assertTrue((sea["foam"] >= 0).all() and (sea["foam"] <= 1).all())
        red = sea["lit.R"][29:37].mean(axis=0) # the sun is in the middle of the picture
        self.assertGreater(red[40:56].mean(), 1.5 * np.concatenate((red[:20], red[-20:])).mean())
        high = self.drawn("--wind=8", "--altitude=30", "--light-azimuth=0", "--light-elevation=60", "--yaw=180", "--pitch=60")
        water = high["lit.R"][high["foam"] < 0.01]  # below the sun, in which few facets sparkle
        below = self.drawn("--wind=8", "--altitude=1000", "--pitch=90", "--zoom=2", size="33x33")["lit.R"]
        print(f"brightest water {water.max():.3f}, {(water > 0.9).mean():.4f} of it above 0.9; straight down {below[16, 16]:.4f}, beside it {below[16, 0]:.4f}")
        self.assertGreater(water.max(), 0.5)
        self.assertLess((water > 0.9).mean(), 0.02)
        self.assertGreater(below[16, 16], 0.9 * below[16, 0])

    def test_heights_have_the_variance_of_the_spectrum(self):
        def shares(wind, fetch, altitude, seeds):
            return [self.drawn(f"--wind={wind}", f"--fetch={1000 * fetch}", f"--seed={seed}", f"--altitude={altitude}", "--pitch=90", "--zoom=0.6",
                               size="400x400")["height"].var() / variance(wind, 1000 * fetch) for seed in seeds]
        storm = shares(20, 200, 1000, range(12))
        print(f"{np.mean(storm):.3f} of the variance, +- {np.std(storm) / np.sqrt(12):.3f}")
        self.assertAlmostEqual(np.mean(storm), 1, delta=0.15)
        np.testing.assert_allclose(shares(10, 50, 250, range(2)), storm[:2], rtol=0.02)  # waves a quarter as long, and as near

    def test_foam_covers_as_much_of_the_sea_as_was_measured(self):
        for wind, seeds in ((10, 4), (18, 8)):  # from so high that hundreds of waves are seen, as foam comes in patches
            covered = np.mean([self.drawn(f"--wind={wind}", "--fetch=30000", "--altitude=1000", "--pitch=90", "--zoom=0.25",
                                          f"--seed={seed}", size="1024x48")["foam"].mean() for seed in range(seeds)])
            measured = 3.84e-6 * wind**3.41  # Monahan and O'Muircheartaigh, 1980
            print(f"wind {wind}: {covered:.4f} of the sea is foam, {measured:.4f} was measured")
            self.assertAlmostEqual(covered / measured, 1, delta=0.1)

    def test_a_pixel_near_the_horizon_shows_the_mean_of_its_foam(self):
        once, parts = (np.hstack([self.drawn("--wind=18", "--altitude=15", f"--seed={seed}", size=size)["foam"] for seed in (2, 3, 4)])
                       for size in ("160x80", "960x480"))
        mean = parts.reshape(80, 6, 480, 6).mean(axis=(1, 3))
        for rows in slice(30, 40), slice(40, 60), slice(60, 80):
            contrast, error = once[rows].std() / mean[rows].std(), (once - mean)[rows].std() / mean[rows].std()
            print(f"rows {rows.start} to {rows.stop}: {contrast:.2f} of the contrast, off by {error:.2f} of it")
            self.assertLess(contrast, 1.1)
            self.assertLess(error, 0.7)

    def test_it_moves_and_a_part_equals_the_whole(self):
        first, later = (self.drawn(f"--seconds={time}", "--seed=5") for time in (1e6, 1e6 + 1.5))
        water = first["jacobian"] > 0
        self.assertGreater(np.abs(first["height"] - later["height"])[water].mean(), 0.05)
        part = self.drawn("--seconds=1e6", "--seed=5", "--region=16,40,32,16")
        for name, values in part.items():
            np.testing.assert_array_equal(values, first[name][40:56, 16:48], name)

    def test_frames_are_a_25th_of_a_second_apart(self):
        self.succeed("render", "--view=ocean", "--size=8x8", "-o", "out.exr", "--frames=2", "--seconds=3")
        times = [Exr(self.folder / f"out.000{frame}.exr").parameters["seconds"] for frame in (1, 2)]
        np.testing.assert_allclose(times, (3, 3.04))
        said = self.succeed("render", "--view=ocean", "--size=8x8", "-o", "out.exr", "--frames=4", "--loop-seconds=32")  # which they share
        self.assertTrue(said.startswith("out.0001.exr: 8 x 8 pixels, ocean, on "), said)
        self.assertEqual([Exr(self.folder / f"out.000{frame}.exr").parameters["seconds"] for frame in (1, 2, 4)], [0, 8, 24])

    def test_a_swell_adds_its_height_and_a_loop_repeats(self):
        above = "--altitude=500", "--pitch=90", "--zoom=0.5", "--wind=4"
        def seas(seeds, *more):
            return np.array([self.drawn(*above, f"--seed={seed}", *more, size="64x64")["height"] for seed in range(seeds)])
        plain, swell = seas(8), seas(8, "--swell-height=4")
        self.assertAlmostEqual((swell - plain).std(), 1, delta=0.25)
        self.assertGreater((swell[:2] - seas(2, "--swell-height=4", "--swell-direction=150")).std(), 1)
        longer = seas(8, "--swell-height=4", "--swell-period=20") - plain
        self.assertLess(np.abs(np.diff(longer)).mean(), 0.6 * np.abs(np.diff(swell - plain)).mean())
        first, later, between = (self.drawn("--loop-seconds=16", "--swell-height=2", f"--seconds={time}")["height"] for time in (3.25, 19.25, 11.25))
        np.testing.assert_array_equal(first, later)
        (self.folder / "loop.json").write_text('{"view": "ocean", "width": 96, "height": 64, "loop_seconds": 16, "swell_height": 2, "seconds": 3.25}')
        self.succeed("render", "--like=loop.json", "-o", "like.exr")
        np.testing.assert_array_equal(Exr(self.folder / "like.exr").channels["height"], first)
        self.assertGreater(np.abs(first - between).mean(), 0.05)

    def test_what_does_not_fit_is_refused(self):
        for option in ("material=wood", "scale=8", "filter", "wind=1", "fetch=999", "swell-height=-1", "swell-period=4", "loop-seconds=12", "tileable"):
            self.assert_refused([option.split("=")[0]], "render", "--view=ocean", "-o", "out.exr", f"--{option}")
        self.assert_refused(["--wind needs --view ocean\n"], "render", "-o", "out.exr", "--wind=8")
        self.assert_refused(["maps require"], "maps", "--view=ocean", "-o", "maps")


if __name__ == "__main__":
    unittest.main()
