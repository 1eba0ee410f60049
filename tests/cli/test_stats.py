"""Compares `gabor stats` with numpy on the same pixels and with what was rendered."""

import json
import pathlib
import unittest

import numpy as np

from exr import START, Exr, write_exr
from program import ProgramTest

KEYS = {"mean", "variance", "skewness", "excess_kurtosis", "minimum", "maximum", "pixels", "not_finite",
        "expected_variance", "spectrum", "width", "height", "channel", "parameters"}
SPECTRUM_KEYS = {"peak_frequency", "peak_orientation", "bandwidth", "resolution", "radial"}


def no_constant(name):
    raise ValueError(f"{name} is not JSON")


class StatsTest(ProgramTest):
    def stats(self, file="in.exr", *options):
        self.succeed("stats", file, "--json", "out.json", *options)
        return json.loads((self.folder / "out.json").read_text(), parse_constant=no_constant)

    def write(self, parameters=None, **channels):
        write_exr(self.folder / "in.exr", channels, parameters)

    def assert_moments(self, stats, pixels):
        pixels = pixels.astype(float).ravel()
        centred = pixels - pixels.mean()
        variance = np.mean(centred ** 2)
        self.assertEqual(stats["pixels"], pixels.size)
        self.assertEqual((stats["minimum"], stats["maximum"]), (pixels.min(), pixels.max()))
        self.assertAlmostEqual(stats["mean"], pixels.mean(), delta=1e-12 * np.abs(pixels).max())
        self.assertAlmostEqual(stats["variance"] / variance, 1, delta=1e-11)
        self.assertAlmostEqual(stats["skewness"], np.mean(centred ** 3) / variance ** 1.5, delta=1e-10)
        self.assertAlmostEqual(stats["excess_kurtosis"], np.mean(centred ** 4) / variance ** 2 - 3, delta=1e-10)


class Rendered(StatsTest):
    def render(self, *options):
        self.succeed("render", "-o", "in.exr", *options)

    def test_numbers(self):
        self.render("--size=701x499", "--scale=16", "--seed=5")
        stats = self.stats()
        self.assertLessEqual(KEYS, set(stats))
        self.assertLessEqual(SPECTRUM_KEYS, set(stats["spectrum"]))
        exr = Exr(self.folder / "in.exr")
        self.assert_moments(stats, exr.pixels)
        self.assertEqual(stats["not_finite"], 0)
        self.assertEqual((stats["width"], stats["height"], stats["channel"]), (701, 499, "Y"))
        self.assertEqual(stats["parameters"], exr.parameters)
        self.assertEqual(stats["expected_variance"], 1)

    def test_pixels_outside_a_body_do_not_count(self):
        for options in (("--view=sphere",), ("--view=torus", "--solid", "--region=20,40,300,310")):
            self.render("--size=384x384", "--scale=24", "--seed=5", *options)
            channels = Exr(self.folder / "in.exr").channels
            inside = channels["A"] == 1
            for channel in set(channels) - {"A"}:
                stats = self.stats("in.exr", f"--channel={channel}")
                self.assertEqual(stats["outside"], np.count_nonzero(~inside), options)
                self.assertEqual(stats["expected_variance"], 1)
                self.assert_moments(stats, channels[channel][inside])
                self.assert_plausible(np.where(inside, channels[channel].astype(float), np.nan) ** 2, 1, (options, channel))

    def test_a_region_is_measured_by_itself(self):
        self.render("--size=300x200", "--region=31,17,200,101")
        stats = self.stats()
        self.assert_moments(stats, Exr(self.folder / "in.exr").pixels)
        self.assertEqual((stats["width"], stats["height"], stats["parameters"]["width"]), (200, 101, 300))

    def test_joined_regions_give_the_numbers_of_the_whole(self):
        # Three cases: more rows than are read at once, a variance known from another channel, and one that must be measured.
        for options, channel in ((["--size=1500x1100", "--scale=9"], "Y"),
                                 (["--size=300x200", "--filter", "--scale=9"], "Y"),
                                 (["--size=300x200", "--phasor"], "intensity")):
            width, height = map(int, options[0].split("=")[1].split("x"))
            self.succeed("render", "-o", "whole.exr", *options)
            whole = self.succeed("stats", "whole.exr", "--json=-", "--channel", channel)
            text = self.succeed("stats", "whole.exr", "--channel", channel)
            strips = [(0, 0, width, 77), (0, 77, width, 23), (0, 100, width, height - 100)]
            for windows in [strips] * (channel == "Y") + [[(0, 0, 200, height), (200, 0, width - 200, 60), (200, 60, width - 200, height - 60)]]:
                names = []
                for window in windows:
                    names.append(f"{len(names)}.exr")
                    self.succeed("render", "-o", names[-1], f"--region={','.join(map(str, window))}", *options)
                regions = [*names[1:], names[0]]
                self.assertEqual(self.succeed("stats", *regions, "--json=-", "--channel", channel), whole)
                self.assertEqual(self.succeed("stats", *regions, "--channel", channel),
                                 text.replace("whole.exr", "3 regions"))
                self.assert_refused(["no region contains the pixel"], "stats", *regions[:-1])
            self.assert_refused(["0.exr", "give another file"], "stats", *regions, "--json=0.exr")

    def test_the_peak_is_where_requested(self):
        # Angles turn from right to down. If they turned the other way, 20, 120 and -60 degrees would read as 160, 60 and 60.
        for frequency, scale, orientation in [(4, 16, 0), (4, 16, 20), (4, 16, 45), (4, 16, 90), (4, 16, 120),
                                              (4, 16, -60), (3, 32, 200), (6, 13, 150)]:
            with self.subTest(frequency=frequency, scale=scale, orientation=orientation):
                self.render("--size=800x600", f"--scale={scale}", f"--frequency={frequency}",
                            f"--orientation={orientation}")
                spectrum = self.stats()["spectrum"]
                self.assertAlmostEqual(spectrum["peak_frequency"] * scale / frequency, 1, delta=0.05)
                error = (spectrum["peak_orientation"] - orientation + 90) % 180 - 90
                self.assertAlmostEqual(error, 0, delta=3)
                self.assertTrue(0 <= spectrum["peak_orientation"] < 180)

    def test_figures_per_kernel_radius_are_those_per_pixel_times_the_scale(self):
        for scale in (8, 21.5):
            self.render("--size=512x512", f"--scale={scale}", "--frequency=3", "--orientation=30")
            spectrum = self.stats()["spectrum"]
            for name in ("peak_frequency", "bandwidth"):
                self.assertAlmostEqual(spectrum[f"{name}_per_radius"], scale * spectrum[name], places=12)
            self.assertAlmostEqual(spectrum["peak_frequency_per_radius"], 3, delta=0.1)
            text = self.succeed("stats", "in.exr")
            for name, value in (("peak frequency", spectrum["peak_frequency_per_radius"]),
                                ("bandwidth", spectrum["bandwidth_per_radius"])):
                self.assertRegex(text, rf"(?m)^ +{name} .*, {value:.4g} per kernel radius$")

    def test_text(self):
        self.render("--frequency=1", "--scale=3", "--size=1024x1024")
        text, stats = self.succeed("stats", "in.exr"), self.stats()
        self.assertIn("in.exr", text)
        self.assertIn("1024 x 1024", text)
        for name in ("mean", "variance", "skewness", "excess kurtosis", "minimum", "maximum"):
            self.assertRegex(text, rf"(?m)^ +{name} +{stats[name.replace(' ', '_')]:.6g}\b")
        for name in ("peak frequency", "peak orientation", "bandwidth"):
            self.assertRegex(text, rf"(?m)^ +{name} +-?\d")

    def test_json_on_stdout(self):
        self.render("--size=64x64")
        line = self.succeed("stats", "in.exr", "--json", "-")
        self.assertEqual(json.loads(line), self.stats())
        self.assertEqual(line.count("\n"), 1)  # one for each picture, for programs that read lines


class Distributions(StatsTest):
    """Tests that a channel's variance is the one in theory, if the header determines it."""

    def render(self, *options, size="512x512", scale=16):
        self.succeed("render", "-o", "in.exr", f"--size={size}", f"--scale={scale}", *options)

    def assert_known(self, variance, channel):
        stats = self.stats("in.exr", "--channel", channel)
        self.assertAlmostEqual(stats["expected_variance"] / variance, 1, delta=1e-5, msg=channel)
        print(f"  {channel}: {stats['variance']:.5g} for {variance:.5g}")
        self.assert_plausible(Exr(self.folder / "in.exr").channels[channel].astype(float) ** 2, variance, channel)
        self.assertIn(f"theory: {stats['expected_variance']:.6g}\n", self.succeed("stats", "in.exr", "--channel", channel))

    def test_gradients(self):
        """A slope's variance is the wave's contribution plus the window's, which is the energy of the window's derivative divided
        by the window's energy, both summed on a grid."""
        x = (np.arange(4000) + 0.5) / 4000
        window = (1 + np.cos(np.pi * x)) / 2
        energy = np.sum(np.gradient(window, x) ** 2) / np.sum(window**2)
        self.render("--gradient", "--frequency=1.5", "--orientation=30")
        self.assert_known((3 * np.pi * np.cos(np.pi / 6)) ** 2 + energy, "gradient.x")
        self.assert_known((3 * np.pi * np.sin(np.pi / 6)) ** 2 + energy, "gradient.y")
        self.assert_known(1, "Y")

    def test_filtered(self):
        """The variance is a product over both axes: for each, the energy of the blurred windowed wave, or of its derivative,
        divided by the window's energy."""
        x = np.arange(-8, 8, 1 / 512)
        window = np.where(np.abs(x) < 1, (1 + np.cos(np.pi * x)) / 2, 0)
        def left(frequency, scale):
            blur = np.exp(-2 * (x * scale) ** 2)
            wave = window * np.exp(2j * np.pi * frequency * x)
            return [np.sum(np.abs(np.convolve(wave, kernel / blur.sum(), "same")) ** 2) / np.sum(window ** 2)
                    for kernel in (blur, -4 * scale ** 2 * x * blur)]
        self.render("--filter", "--frequency=1.5", "--orientation=30", "--gradient", scale=4)
        across, down = left(1.5 * np.cos(np.pi / 6), 4), left(1.5 * np.sin(np.pi / 6), 4)
        self.assert_known(across[0] * down[0], "Y")
        self.assert_known(across[1] * down[0], "gradient.x")
        self.assert_known(across[0] * down[1], "gradient.y")
        removed = Exr(self.folder / "in.exr").channels["removed"]
        self.assertGreater(removed.min(), 0.1)
        self.assertAlmostEqual(1 - removed.min(), across[0] * down[0], delta=0.0105)

    def test_sums_of_waves(self):
        """The predicted variance holds for sums, and for tiles, whose windows stretch to fit a whole number of
        nodes."""
        lobes = [{"frequency": 2, "orientation": 20, "power": 3}, {"frequency": 1, "radius": 2, "stretch": 0.7, "power": 1}]
        (self.folder / "lobes.json").write_text(json.dumps(lobes))
        self.render("--lobes=lobes.json", "--gradient", "--tileable", "--seed=1", size="540x512", scale=8)
        slopes = np.zeros(2)
        for lobe in lobes:
            angle = np.radians(lobe.get("orientation", 0))
            wave = 2 * np.pi * lobe["frequency"] * np.array([np.cos(angle), np.sin(angle)])
            radius = lobe.get("radius", 1) * np.array([1, lobe.get("stretch", 1)])
            length = np.array([540, 512]) / 8 / radius
            nodes = np.floor(1.5 * length) / length / radius
            slopes += lobe["power"] / 4 * (wave ** 2 + np.pi ** 2 / 3 * (nodes / 1.5) ** 2)
        self.assert_known(slopes[0], "gradient.x")
        self.assert_known(slopes[1], "gradient.y")

    def test_filtered_tiles(self):
        """In a wide window, a filter leaves exp(-(2 pi f s)^2) of a wave's variance, however the tile stretches the window."""
        (self.folder / "lobes.json").write_text(json.dumps([{"frequency": 2, "orientation": 40, "radius": 30}]))
        self.render("--lobes=lobes.json", "--filter", "--tileable", size="540x512", scale=8)
        left = np.exp(-(2 * np.pi * 2 * 0.5 / 8) ** 2)
        self.assertAlmostEqual(self.stats()["expected_variance"] / left, 1, delta=0.002)

    def test_unknown_variances(self):
        for radius, stretch, unknown in ((0.51, 1, False), (0.49, 1, True), (0.6, 0.8, True)):  # a pixel is wider than a kernel radius
            (self.folder / "lobes.json").write_text(json.dumps([{"frequency": 1, "radius": radius, "stretch": stretch}]))
            self.render("--filter", "--lobes=lobes.json", scale=2)
            self.assertEqual(self.stats()["expected_variance"] is None, unknown, (radius, stretch))
        for channel, options in (("phase", ["--phasor"]), ("intensity", ["--phasor"]),
                                 ("Y", ["--filter", "--view=horizon"]), ("Y", ["--filter", "--view=sphere"]),
                                 ("gradient.x", ["--gradient", "--recipe=paper"]), ("gradient.y", ["--gradient", "--recipe=lattice-2"])):
            self.render(*options)
            self.assertIsNone(self.stats("in.exr", "--channel", channel)["expected_variance"], (channel, options))
            self.assertNotIn("theory", self.succeed("stats", "in.exr", "--channel", channel))

    def test_undefined_numbers_are_null(self):
        self.render(size="1x1")
        self.assertEqual({self.stats()[name] for name in ("skewness", "excess_kurtosis", "spectrum")}, {None})
        text = self.succeed("stats", "in.exr")
        self.assertNotIn("nan", text)
        self.assertRegex(text, r"(?m)^  skewness +none  all pixels are equal$")
        self.render(size="15x300")
        self.assertIsNone(self.stats()["spectrum"])
        self.assertIn("smaller than 16 x 16 pixels", self.succeed("stats", "in.exr"))
        self.render("--phasor")
        spectrum = self.stats("in.exr", "--channel=intensity")["spectrum"]
        self.assertEqual((spectrum["peak_frequency"], spectrum["peak_orientation"]), (None, None))
        self.assertRegex(self.succeed("stats", "in.exr", "--channel=intensity"), r"(?m)^  peak frequency +none  ")


class Foreign(StatsTest):
    def setUp(self):
        super().setUp()
        self.random = np.random.default_rng(1)

    def normal(self, height=120, width=150):
        return self.random.normal(3, 2, (height, width)).astype("f4")

    def test_reports_are_those_of_this_version(self):
        white = self.random.normal(size=(200, 240))
        wave = np.sin(np.arange(240) * 0.9 + np.arange(200)[:, None] * 0.4)
        radius = np.hypot(np.fft.fftfreq(240), np.fft.fftfreq(200)[:, None])
        smooth = np.fft.ifft2(np.fft.fft2(white) * np.exp(-2 * (np.pi * 2.8 * radius) ** 2)).real
        texts = []
        for pixels, parameters in ((white + np.roll(white, 1, 0) + 0.5 * wave, None), (smooth / smooth.std(), '{"scale": 9}')):
            self.write(parameters, Y=pixels.astype("f4"))
            texts.append(self.succeed("stats", "in.exr") + self.succeed("stats", "in.exr", "--json=-"))
        self.assert_numbers(pathlib.Path(__file__).with_name("stats.txt"), texts)

    def test_channels(self):
        red, green, blue = self.normal(), self.normal().astype("f2"), self.normal()
        self.write(R=red, G=green, B=blue, id=np.ones(red.shape, "u4"))
        for options, channel, pixels in [((), "R", red), (("--channel=G",), "G", green), (("--channel=B",), "B", blue)]:
            stats = self.stats("in.exr", *options)
            self.assertEqual((stats["channel"], stats["parameters"]), (channel, None))
            self.assert_moments(stats, pixels)
        self.write(Z=green, id=np.ones(red.shape, "u4"))
        self.assertEqual(self.stats()["channel"], "Z")

    def test_a_constant_picture(self):
        self.write(Y=np.full((64, 64), 0.25, "f4"))
        stats = self.stats()
        self.assertEqual((stats["mean"], stats["variance"], stats["minimum"], stats["maximum"]), (0.25, 0, 0.25, 0.25))
        self.assertEqual((stats["skewness"], stats["excess_kurtosis"]), (None, None))
        self.succeed("stats", "in.exr")

    def test_pixels_that_are_not_finite_are_counted_and_left_out(self):
        pixels = self.normal()
        pixels[3, 5] = np.nan
        pixels[7, 1:4] = np.inf
        pixels[119, 149] = -np.inf
        self.write(Y=pixels)
        stats = self.stats()
        self.assertEqual(stats["not_finite"], 5)
        self.assert_moments(stats, pixels[np.isfinite(pixels)])
        self.write(Y=np.where(np.isfinite(pixels), pixels, np.float32(stats["mean"]))) # to the spectrum, they are the mean
        np.testing.assert_allclose(stats["spectrum"]["radial"], self.stats()["spectrum"]["radial"], rtol=1e-5)

    def test_pixels_outside_are_counted_and_left_out(self):
        pixels = self.normal()
        alpha = np.ones(pixels.shape, "f4")
        alpha[20:60, 30:90] = 0
        alpha[60, 30:90] = 0.75
        pixels[20:30, 30:90] = np.nan
        pixels[0, 0] = np.inf
        self.write(Y=pixels, A=alpha)
        stats = self.stats()
        self.assertEqual((stats["outside"], stats["not_finite"], stats["spectrum"]), (41 * 60, 1, None))
        self.assert_moments(stats, pixels[(alpha == 1) & np.isfinite(pixels)])
        self.assertIn("1 not finite, 2460 excluded as outside the body (A below 1)", self.succeed("stats", "in.exr"))
        self.assertEqual(self.stats("in.exr", "--channel=A")["outside"], 0)

    def test_a_picture_without_finite_values(self):
        self.write(Y=np.full((32, 32), np.nan, "f4"))
        stats = self.stats()
        self.assertEqual((stats["pixels"], stats["not_finite"]), (0, 1024))
        self.assertEqual({stats[name] for name in ("mean", "variance", "minimum", "maximum")}, {None})
        self.succeed("stats", "in.exr")

    def test_broken_parameters_are_ignored(self):
        for parameters in ("", "{", "[1]", "7", '{"scale": "x"}', '{"scale": -1}', '{"scale": 1e999}'):
            self.write(parameters, Y=self.normal())
            self.assertEqual(self.stats()["channel"], "Y", parameters)

    def test_deeply_nested_parameters(self):
        self.write('[' * 200000 + ']' * 200000, Y=np.zeros((4, 4), "f4"))
        self.assertIsNone(self.stats()["parameters"])
        self.assert_refused(["not a JSON object"], "render", "--like", "in.exr", "-o", "out.exr")


class Errors(StatsTest):
    def refuse(self, words, *options):
        (self.folder / "old.json").write_text("older")
        self.assert_refused(words, "stats", "in.exr", *options, "--json", "old.json")

    def test_no_such_channel(self):
        self.write(G=np.zeros((4, 4), "f4"), B=np.zeros((4, 4), "f4"), id=np.zeros((4, 4), "u4"))
        self.refuse(["'Y'", "B, G"], "--channel=Y")
        self.refuse(["'id'", "half and float"], "--channel=id")
        self.write(id=np.zeros((4, 4), "u4"))
        self.refuse(["half or float", "id"])

    def test_no_such_file(self):
        self.refuse(["in.exr", "No such file"])
        (self.folder / "in.exr").mkdir()
        self.refuse(["in.exr", "not a regular file"])

    def test_not_an_exr(self):
        for content in (b"", b"Not a picture.\n", b"\x89PNG\r\n\x1a\n" + bytes(64), START, START + bytes(64)):
            (self.folder / "in.exr").write_bytes(content)
            with self.subTest(content):
                self.refuse(["in.exr", "OpenEXR"])

    def test_json_that_cannot_be_written(self):
        self.write(Y=np.zeros((4, 4), "f4"))
        for output in ("missing/out.json", "in.exr/out.json", ".", ""):
            self.assert_refused(["cannot write", output], "stats", "in.exr", "--json", output)
        self.assert_refused(["--json", "in.exr"], "stats", "in.exr", "--json", "./in.exr")
        self.assert_refused(["'in.exr' has no 'gabor' attribute"], "stats", "in.exr", "extra")


if __name__ == "__main__":
    unittest.main()
