"""Tests the Python module as its users have it: run with a Python that has gabor_noise and Pillow installed.

    python3 module_test.py [DOCS]    DOCS: the folder of python.md and its pictures
"""

import inspect
import pathlib
import re
import runpy
import sys
import tempfile
import threading
import unittest
import unittest.mock

import gabor_noise as gn
import numpy as np
from gabor_noise._heightmap import smoothed
from PIL import Image

POINTS = dict(x=np.linspace(-3, 40, 24), y=np.linspace(7, 0.1, 24))
POINTS_3D = POINTS | dict(z=np.linspace(0.2, 9, 24))
WAVE = dict(frequency=[1.0, 3.0, 5.5], orientation=[0.0, 1.1, 2.5])
COMMON = dict(seed=[1, 2**32 - 1, -5], evolution=[0.0, 0.3, 4.4])
PICTURE = dict(shape=(3, 8), scale=4.0)
SEA = dict(seconds=[0.0, 3.5, 1e6 + 0.25], wind=[3.0, 8.0, 20.0], direction=[0.0, 1.0, 2.0], fetch=[1e4, 1e5, 5e5], swell_height=[0.0, 1.0, 3.0],
           water_depth=[0.0, 20.0, 4.0], loop_seconds=[0, 8, 4096], seed=[1, 2, 3])
SIDES = [(0.5, 0.0), (0.0, 0.5), (0.5, 0.5)]  # of pixels: each has an effect
OCTAVES = dict(octaves=[1.0, 2.5, 6.0], gain=[0.3, 0.5, 0.9], lacunarity=[1.5, 2.0, 3.1], turn=[0.0, 0.4, 2.0])


def warped(**given):
    """Returns moved coordinates along a last axis."""
    return np.stack(gn.warp(**given), -1)


# Each function, its fixed arguments, and three values of each argument that may be an array.
CASES = [
    (gn.noise, POINTS, WAVE | COMMON),
    (gn.noise, POINTS | dict(period=(6, 9)), WAVE | COMMON),
    (gn.noise_gradient, POINTS, WAVE | COMMON),
    (gn.noise_quadrature, POINTS, WAVE | COMMON),
    (gn.noise_isotropic, POINTS, dict(frequency=[0.5, 2.0, 4.0]) | COMMON),
    (gn.noise_spread, POINTS, WAVE | COMMON | dict(frequency_spread=[0.0, 0.3, 1.0], orientation_spread=[0.0, 0.4, np.pi / 2])),
    (gn.noise_filtered, POINTS | dict(pixel_size=0.1), WAVE | COMMON),
    (gn.noise_filtered, POINTS | dict(frequency=1.0), dict(pixel_size=SIDES)),
    (gn.noise_3d, POINTS_3D, dict(frequency=[0.5, 2.0, 4.0]) | COMMON),
    (gn.noise_3d, POINTS_3D | dict(direction=(1, 2, 3), period=5), dict(frequency=[0.5, 2.0, 4.0]) | COMMON),
    (gn.noise_3d, POINTS_3D, dict(direction=[(1, 0, 0), (0, 3, 0), (-1, 1, 2)])),
    (gn.stripes, POINTS | dict(wave_x=2.0, wave_y=1.0), COMMON | dict(wave_x=[0.0, 1.0, 4.0], wave_y=[0.0, 1.0, 4.0], sharpness=[0.1, 1.0, 9.0])),
    (gn.fbm, POINTS, OCTAVES | COMMON),
    (gn.fbm, POINTS | dict(basis="perlin", shape="ridged"), OCTAVES | COMMON),
    (gn.fbm, POINTS | dict(period=(6, 9)), dict(octaves=[1.0, 2.5, 6.0]) | COMMON),
    (gn.fbm_gradient, POINTS, dict(octaves=[1.0, 2.5, 4.0]) | COMMON),
    (gn.fbm_filtered, POINTS | dict(pixel_size=0.1), OCTAVES | COMMON),
    (gn.fbm_filtered, POINTS, dict(pixel_size=SIDES)),
    (gn.fbm_3d, POINTS_3D, OCTAVES | COMMON),
    (gn.fbm_3d, POINTS_3D | dict(period=5), COMMON),
    (gn.perlin, POINTS, dict(seed=[1, 2**32 - 1, -5])),
    (warped, POINTS | dict(strength=0.5), OCTAVES | COMMON),
    (warped, POINTS, dict(strength=[-0.5, 0.0, 2.0])),
    (gn.image, PICTURE, WAVE | COMMON),
    (gn.image, PICTURE | dict(isotropic=True), dict(frequency=[0.5, 2.0, 4.0]) | COMMON),
    (gn.image, PICTURE | dict(frequency_spread=0.5), WAVE | dict(orientation_spread=[0.0, 0.4, 1.5])),
    (gn.image, PICTURE | dict(orientation_spread=0.5), dict(frequency_spread=[0.0, 0.3, 1.0])),
    (gn.image, PICTURE | dict(lobes=[(3, 0.4), (1,)]), COMMON),
    (gn.volume, dict(shape=(2, 3, 4), scale=4.0), dict(frequency=[0.5, 2.0, 4.0]) | COMMON),
    (gn.terrain, POINTS, dict(seed=[1, 2, 3], pixel_size=SIDES)),
    (gn.terrain, POINTS | dict(base=(0.1, 0.5, -0.3, 0.2)), dict(pixel_size=SIDES)),
    (gn.terrain, POINTS | dict(base=(0.1, 0.5, -0.3, 0.2, 0.1, 0.2, 0.3)), dict(seed=[1, 2, 3])),
    (gn.terrain, POINTS, dict(base=[(0.1, 0.05, -0.03, 0.2), (0.3, 0.1, -0.03, 0.2), (0.1, 0.05, -0.03, 0.9)])),
    (gn.erode, dict(heights=np.sin(np.arange(48.0)).reshape(6, 8), extent=8.0, gully_frequency=0.2), dict(seed=[1, 2, 3])),
    (gn.water, POINTS, SEA | dict(pixel_size=SIDES)),
    (gn.water, POINTS | dict(swell_height=2.0), dict(swell_period=[5.0, 9.0, 20.0], swell_direction=[0.0, 1.0, 3.0])),
    (gn.water_height, POINTS, SEA),
    (gn.water_height, POINTS | dict(swell_height=2.0), dict(swell_period=[5.0, 9.0, 20.0], swell_direction=[0.0, 1.0, 3.0])),
]
EROSION = dict(octaves=[1, 2, 7], gully_frequency=[0.5, 1.0, 3.0], strength=[0.0, 0.1, 0.4], lacunarity=[1.5, 2.0, 3.0], gain=[0.2, 0.5, 0.8],
               onset_slope=[0.1, 0.5, 2.0], detail=[0.3, 1.5, 6.0], uniformity=[0.5, 2.0, 7.0], ridge_rounding=[0.0, 0.4, 2.0],
               crease_rounding=[0.0, 0.4, 2.0], gully_weight=[0.0, 0.5, 1.0], branching=[0.0, 0.7, 2.0])
MATERIALS = re.findall(r"^    (\S+):$", gn.material.__doc__.partition("Angles are in radians")[2], re.MULTILINE)


def flat(result):
    """Returns a material's values as channels along a last axis."""
    if not isinstance(result, dict):
        return result
    return np.concatenate([part if name in ("colour", "slope", "shift", "lost", "velocity") else part[..., None] for name, part in result.items()], -1)


def points(function, fixed):
    return len(fixed["shape"]) if isinstance(fixed.get("shape"), tuple) else np.ndim(fixed["heights"]) if "heights" in fixed else 1


class Arrays(unittest.TestCase):
    def check(self, function, fixed, name, values, vector):
        """An array of a parameter gives what a loop over its values gives, and each value gives something else."""
        column = np.asarray(values).reshape(3, *[1] * points(function, fixed), *[-1] * vector)
        together = flat(function(**fixed | {name: column}))
        apart = np.array([flat(function(**fixed | {name: value})) for value in values])
        self.assertEqual(together.shape, apart.shape)
        difference = np.abs(together - apart)
        self.assertTrue(difference.max() < 2e-5, f"{name}: largest difference {difference.max()} at "
                                                 f"{np.unravel_index(difference.argmax(), difference.shape)}")
        for one, other in ((0, 1), (1, 2), (0, 2)):
            self.assertGreater(np.abs(apart[one] - apart[other]).max(), 1e-4, f"{name} has no effect")

    def test_each_parameter(self):
        for function, fixed, parameters in CASES:
            for name, values in parameters.items():
                with self.subTest(function.__name__, name=name, **{key: fixed[key] for key in fixed.keys() - POINTS_3D.keys()}):
                    self.check(function, fixed, name, values, np.ndim(values) > 1)

    def test_each_parameter_of_erosion(self):
        documented = set(inspect.signature(gn.terrain).parameters) - {"x", "y", "base", "pixel_size", "seed", "period", "workers", "dtype"}
        self.assertEqual(documented, set(EROSION))
        for name, values in EROSION.items():
            with self.subTest(name):
                self.check(gn.terrain, POINTS, name, values, False)

    def test_each_parameter_of_each_material(self):
        functions = re.findall(r"(?m)^GaborMaterial gabor_(\w+)_filtered_at\(", gn.source("materials"))
        self.assertCountEqual(MATERIALS, [name.replace("_", "-") for name in functions])
        x, y = (each.ravel() for each in np.broadcast_arrays(*gn.grid((24, 24), 6)))
        lines = re.findall(r"^    (\S+):$|^        (\w+): .*?(?:, (-?[\d.]+) to ([\d.]+))? \[", gn.material.__doc__, re.MULTILINE)
        tested = 0
        for material, parameter, low, high in lines:
            name = material or name
            if not parameter or name not in MATERIALS:
                continue
            tested += 1
            values = np.linspace(float(low), float(high), 7)[1:6:2] if low else np.eye(3)
            needed = {"patina_amount": 0.5} if parameter == "patina_colour" else {}
            with self.subTest(name, parameter=parameter):
                self.check(gn.material, dict(name=name, x=x, y=y, pixel_size=0.02, seed=3, **needed), parameter, values, not low)
        self.assertGreater(tested, 70)
        for name in MATERIALS:
            with self.subTest(name, parameter="pixel_size"):
                self.check(gn.material, dict(name=name, x=x, y=y, seed=3), "pixel_size", SIDES, True)

    def test_the_sign_of_a_frequency_is_ignored(self):
        for function, fixed in ((gn.noise, POINTS), (gn.noise_isotropic, POINTS), (gn.noise_3d, POINTS_3D), (gn.noise_3d, POINTS_3D | dict(direction=(1, 2, 3)))):
            np.testing.assert_array_equal(function(**fixed, frequency=-2.5), function(**fixed, frequency=2.5))

    def test_each_member_of_a_lobe(self):
        for index, values in enumerate(([1.0, 3.0, 5.0], [0.0, 1.0, 2.0], [0.4, 1.0, 2.0], [0.1, 1.0, 5.0])):
            def lobes(value):
                return [(2.0, 0.3, 1.0, 1.0)[:index] + (value,) + (2.0, 0.3, 1.0, 1.0)[index + 1:], (3.0, 1.0, (0.5, 1.5), 2.0)]
            with self.subTest(gn.Lobe._fields[index]):
                together = gn.noise_lobes(**POINTS, seed=5, lobes=lobes(np.reshape(values, (3, 1, 1) if index == 2 else (3, 1))
                                                                         if index != 2 else np.repeat(values, 2).reshape(3, 1, 2)))
                apart = np.array([gn.noise_lobes(**POINTS, seed=5, lobes=lobes(value)) for value in values])
                np.testing.assert_allclose(together, apart, rtol=0, atol=1e-4)  # positions of varying lobes are floats
                self.assertGreater(np.abs(apart[0] - apart[1]).max(), 1e-2)


class Pictures(unittest.TestCase):
    def test_have_the_values_of_their_pixels_centres(self):
        x, y = np.meshgrid((np.arange(40) + 0.5) / 7, (np.arange(30) + 0.5) / 7)
        wave = dict(frequency=3.0, orientation=0.7, seed=9, period=(5, 3), evolution=0.2)
        lobes = [gn.Lobe(3.0, 0.4, 0.5), gn.Lobe(2.0, 1.4, (1.5, 0.6), 3.0)]
        for picture, values in (
                (gn.image((30, 40), scale=7, **wave), gn.noise(x, y, **wave)),
                (gn.image((30, 40), scale=7, isotropic=True, seed=9), gn.noise_isotropic(x, y, seed=9)),
                (gn.image((30, 40), scale=7, frequency_spread=0.4, **wave), gn.noise_spread(x, y, frequency_spread=0.4, orientation_spread=0, **wave)),
                (gn.image((30, 40), scale=7, lobes=lobes), gn.noise_lobes(x, y, lobes)),
                (gn.volume((2, 30, 40), scale=7)[1], gn.noise_3d(x, y, 1.5 / 7)),
                (gn.volume((2, 30, 40), scale=7, direction=(0, 1, 1))[0], gn.noise_3d(x, y, 0.5 / 7, direction=(0, 1, 1)))):
            np.testing.assert_allclose(picture, values, rtol=0, atol=2e-5)
            self.assertGreater(values.std(), 0.5)

    def test_precise_far_away(self):
        # 2^20 kernel radii hold whole periods of every kernel.
        far = 2.0**20 * 3
        for function, place in ((gn.noise, (0.3, 0.4)), (gn.noise_isotropic, (0.3, 0.4)), (gn.noise_3d, (0.3, 0.4, 0.5))):
            near = function(*place, seed=3, period=2.0**20)
            self.assertAlmostEqual(float(function(*(each + far for each in place), seed=3, period=2.0**20)), float(near), delta=2e-5)


class Fractals(unittest.TestCase):
    def test_cover_their_share_of_the_area(self):
        x, y = gn.grid((512, 512), scale=4)
        for values in (gn.fbm(x, y, seed=3), gn.perlin(x, y, seed=3), gn.fbm_3d(x, y, 0.3, octaves=2)):
            rank = gn.uniform(values)
            self.assertEqual(rank.dtype, np.float32)
            for share in (0.1, 0.3, 0.8):
                self.assertAlmostEqual((rank < share).mean(), share, delta=0.02)
        np.testing.assert_allclose(gn.uniform([-9, -1, 0, 2]), [0, 0.1586553, 0.5, 0.9772499], rtol=0, atol=2e-5)

    def test_precise_far_away(self):
        # 3 * 2^20 kernel radii hold whole periods of 4.
        far, place = 3 * 2.0**20, (0.3, 0.4)
        near = gn.fbm(*place, seed=3, period=4)
        self.assertAlmostEqual(float(gn.fbm(*(each + far for each in place), seed=3, period=4)), float(near), delta=2e-5)


class Movies(unittest.TestCase):
    def spectrum(self, side, frames):
        """Returns the summed power of the frames, and its frequencies in cycles per pixel: their lengths, and their parts along x and y."""
        window = np.hanning(side) * np.hanning(side)[:, None]
        y, x = np.meshgrid(np.fft.fftfreq(side), np.fft.rfftfreq(side), indexing="ij")
        return sum(np.abs(np.fft.rfft2(frame * window)) ** 2 for frame in frames), np.hypot(x, y), (x, y)

    def peak(self, places, density, full):
        """Returns the middle and the full width of a density over places at half its height."""
        edges = np.linspace(-0.75 * full, 0.75 * full, 41)
        centres, bins = 0.5 * (edges[1:] + edges[:-1]), np.digitize(places, edges)
        means = np.array([density[bins == k].mean() for k in range(1, 41)])
        high = means > 0.25 * means.max()
        x = np.linspace(*centres[high][[0, -1]], 9999)
        fitted = np.polyval(np.polyfit(centres[high], np.log(means[high]), 4), x)
        left, right = x[fitted > fitted.max() - np.log(2)][[0, -1]]
        return 0.5 * (left + right), right - left

    def test_have_the_spectrum_that_they_name(self):
        for bandwidth, across, frequency, orientation in ((1.0, 0.5, 0.2, 0.6), (2.0, 0.8, 0.12, 2.0), (1.0, None, 0.2, 0.0)):
            frames = (gn.movie((256, 256), 1, frequency=frequency, bandwidth=bandwidth, orientation=orientation,
                               orientation_bandwidth=across, seed=seed)[0] for seed in range(200))
            power, f, (x, y) = self.spectrum(256, frames)
            f[0, 0] = 1
            octaves = np.log2(f / frequency)
            angles = (np.arctan2(y, x) - orientation + np.pi / 2) % np.pi - np.pi / 2
            near = np.abs(angles) < (across or 9)
            middle, width = self.peak(octaves[near], (power * f * f)[near], bandwidth)
            print(f"peak off by {middle:.4f} octaves, width times {width / bandwidth:.4f}", end="")
            self.assertLess(abs(middle), 0.02 / np.log(2))
            self.assertLess(abs(width / bandwidth - 1), 0.02)
            if across:
                near = np.abs(octaves) < bandwidth
                middle, width = self.peak(angles[near], (power * f * f)[near], across)
                print(f"; {middle:.4f} radians, width times {width / across:.4f}", end="")
                self.assertLess(abs(middle), 0.02 * across)
                self.assertLess(abs(width / across - 1), 0.02)
            print()

    def test_have_their_contrast_and_mean(self):
        frames = (gn.movie((128, 128), 1, frequency=0.2, contrast=0.3, seed=seed)[0].astype(float) for seed in range(300))
        for values, truth in zip(np.array([(frame.mean(), (frame**2).mean()) for frame in frames]).T, (0.0, 0.09)):
            error = 4 * values.std() / len(values) ** 0.5
            self.assertLess(abs(values.mean() - truth), error)
        self.assertLess(error, 0.02 * 0.09)  # an error of 1 % in contrast fails

    def test_drift_as_a_whole(self):
        movie = gn.movie((120, 160), 9, frequency=0.1, orientation=0.9, orientation_bandwidth=np.log(2), drift_per_frame=-1.3, contrast=0.4, seed=-2)
        self.assertEqual(len(movie.lobes), 16)
        x, y = gn.grid((120, 160), scale=1)
        for index, frame in enumerate(movie):
            moved = gn.noise_lobes(x + 1.3 * index * np.cos(0.9), y + 1.3 * index * np.sin(0.9), movie.lobes, seed=-2)
            np.testing.assert_allclose(frame, 0.4 * moved, rtol=0, atol=1e-5)
            np.testing.assert_array_equal(movie[index - 9], frame)
        self.assertEqual(len(movie), 9)
        self.assertEqual([each.shape for each in movie[7:]], [(120, 160)] * 2)
        with self.assertRaisesRegex(IndexError, "frame 9 of 9"):
            movie[9]
        # The phase of each wave of a window that moves with the pattern tells its speed.
        first, second = (np.fft.fft2(movie[index] * np.hanning(120)[:, None] * np.hanning(160)) for index in (0, 1))
        fy, fx = np.meshgrid(np.fft.fftfreq(120), np.fft.fftfreq(160), indexing="ij")
        weight, turn = np.abs(first * second).ravel() ** 0.5, np.angle(second * first.conj()).ravel() / (-2 * np.pi)
        step = np.linalg.lstsq(np.stack([fx.ravel(), fy.ravel()], 1) * weight[:, None], turn * weight, rcond=None)[0]
        print(f"speed {np.hypot(*step):.4f} for 1.3")
        np.testing.assert_allclose(step, [-1.3 * np.cos(0.9), -1.3 * np.sin(0.9)], rtol=0, atol=0.05)

    def test_degrees_of_visual_angle(self):
        given = dict(bandwidth=0.8, orientation=2.2, seed=4)
        np.testing.assert_array_equal(gn.movie((40, 50), 3, frequency=3.2, drift_per_frame=0.05, pixels_per_degree=32, **given)[2],
                                      gn.movie((40, 50), 3, frequency=0.1, drift_per_frame=1.6, **given)[2])


class Calls(unittest.TestCase):
    def test_workers_and_types(self):
        one = gn.image((300, 300), seed=4, workers=1)
        self.assertEqual(one.dtype, np.float32)
        for more in (2, 3, 64, None):
            np.testing.assert_array_equal(gn.image((300, 300), seed=4, workers=more), one)
        double = gn.image((300, 300), seed=4, dtype=np.float64)
        self.assertEqual(double.dtype, np.float64)
        np.testing.assert_array_equal(double.astype(np.float32), one)
        for function, fixed, parameters in CASES:
            firsts = {name: values[0] for name, values in parameters.items()}
            for dtype in (np.float32, np.float64):
                values = flat(function(**(fixed | firsts), dtype=dtype, workers=1))
                self.assertEqual(values.dtype, dtype, function.__name__)
        self.assertEqual(gn.noise(0, 0).shape, ())
        self.assertEqual(gn.noise([], []).shape, (0,))
        self.assertEqual(gn.noise_gradient(np.zeros((3, 1)), np.zeros(2)).shape, (3, 2, 3))
        np.testing.assert_array_equal(gn.noise(np.arange(9)[::-2], 0), gn.noise([8, 6, 4, 2, 0], 0))

    def test_generators_draw_a_seed(self):
        drawn = np.random.default_rng(5).integers(2**32, size=2)
        self.assertNotEqual(*drawn)
        for call in (lambda seed: gn.image((4, 4), seed=seed), lambda seed: gn.image((4, 4), isotropic=True, seed=seed),
                     lambda seed: gn.noise_lobes(1, 2, [(1,), (2,)], seed=seed), lambda seed: gn.fbm(1, 2, seed=seed),
                     lambda seed: gn.erode(np.eye(8), 8, seed=seed), lambda seed: np.stack(gn.warp(1, 2, strength=1.0, seed=seed)),
                     lambda seed: gn.volume((2, 2, 2), seed=seed), lambda seed: gn.water_height(1, 2, seed=seed),
                     lambda seed: gn.movie((4, 4), 2, seed=seed)[1]):
            generator = np.random.default_rng(5)
            for seed in drawn:  # the second call goes on where the first one stopped
                np.testing.assert_array_equal(call(generator), call(int(seed)))

    def test_masked_elements_are_refused(self):
        x = np.ma.masked_greater(np.arange(4.0), 2)
        for name, call in (("x", lambda: gn.noise(x, 0)), ("seed", lambda: gn.image((4, 4), seed=x.astype(int))),
                           ("heights", lambda: gn.erode(np.ma.masked_equal(np.eye(4), 0), 8)), ("wave_x", lambda: gn.stripes(0, 0, x, 1)),
                           ("pixel_size", lambda: gn.noise_filtered(0, 0, (x[3], 0.1))), ("period", lambda: gn.noise(0, 0, period=x[2:])),
                           ("lobes[0]: orientation", lambda: gn.noise_lobes(0, 0, [(1, x)])), ("rings", lambda: gn.material("wood", 0, 0, rings=x))):
            with self.assertRaisesRegex(ValueError, re.escape(f"{name} has masked elements: expected none")):
                call()
        np.testing.assert_array_equal(gn.noise(np.ma.array([1.0, 2.0]), 0), gn.noise([1, 2], 0))  # nothing is masked

    def test_other_threads_run_meanwhile(self):
        started = threading.Event()

        def work():
            started.set()
            gn.image((1500, 1500), workers=1)
        thread = threading.Thread(target=work)
        thread.start()
        started.wait()
        turns = 0
        while thread.is_alive():
            turns += 1
        thread.join()
        self.assertGreater(turns, 1000)

    def test_wrong_arguments_are_named(self):
        x = np.zeros((2, 3))
        for call, said in (
                (lambda: gn.image((4, 4), seed=1.5), "seed is 1.5: expected an integer"),
                (lambda: gn.movie((4, 4, 4), 1), "shape is (4, 4, 4): expected (height, width)"),
                (lambda: gn.movie((4, 4), 0), "frames is 0: expected an integer, 1 or more"),
                (lambda: gn.movie((4, 4), 1, frequency=0.3), "frequency is 0.3: expected a number from 1e-06 to 0.25 cycles per pixel"),
                (lambda: gn.movie((4, 4), 1, frequency=9, pixels_per_degree=32), "frequency is 9: expected a number from 3.2e-05 to 8 cycles per degree"),
                (lambda: gn.movie((4, 4), 1, bandwidth=0), "bandwidth is 0: expected a number from 0.01 to 4"),
                (lambda: gn.movie((4, 4), 1, orientation_bandwidth=3), "orientation_bandwidth is 3: expected a number from 0.01 to 2"),
                (lambda: gn.movie((4, 4), 1, seed=[1, 2]), "seed is [1, 2]: expected an integer of 32 bits"),
                (lambda: gn.image((4, 4), seed=2**32), "seed is 4294967296"),
                (lambda: gn.image((4, 4), seed="7"), "seed is '7'"),
                (lambda: gn.image((4, 4), seed=True), "seed is True"),
                (lambda: gn.image((4, 0)), "shape[1] is 0: expected an integer, 1 or more"),
                (lambda: gn.image((4, 4, 4)), "shape is (4, 4, 4): expected (height, width)"),
                (lambda: gn.image(4), "shape is 4"),
                (lambda: gn.volume((4, 4)), "shape is (4, 4): expected (depth, height, width)"),
                (lambda: gn.image((4, 4), scale=0), "scale is 0: expected a number from 1e-09"),
                (lambda: gn.image((4, 4), scale=[1, 2]), "scale is [1, 2]: expected one number"),
                (lambda: gn.image((4, 4), frequency=None), "frequency is None"),
                (lambda: gn.image((4, 4), frequency=2e6), "frequency is 2000000.0: expected a number from -1000000 to 1000000"),
                (lambda: gn.image((4, 4), orientation="north"), "orientation is 'north': expected a finite number"),
                (lambda: gn.image((4, 4), orientation=np.zeros((3, 3))), "do not broadcast: x (1, 4), y (4, 1), orientation (3, 3)"),
                (lambda: gn.image((4, 4), period=-1), "period is -1"),
                (lambda: gn.image((4, 4), period=(1, 2, 3)), "period is (1, 2, 3)"),
                (lambda: gn.image((4, 4), evolution=np.inf), "evolution is inf"),
                (lambda: gn.image((4, 4), workers=0), "workers is 0: expected an integer, 1 or more, or None for all cores"),
                (lambda: gn.image((4, 4), dtype="int32"), "dtype is 'int32': expected float32 or float64"),
                (lambda: gn.image((4, 4), dtype="real"), "dtype is 'real': expected float32 or float64"),
                (lambda: gn.image((4, 4), isotropic=True, lobes=[(1,)]), "at most one of them"),
                (lambda: gn.image((4, 4), lobes=[]), "lobes is []: expected 1 to 16 lobes"),
                (lambda: gn.image((4, 4), lobes=[(1,)] * 17), "expected 1 to 16 lobes"),
                (lambda: gn.image((4, 4), lobes=[(1,), (2, 0, 1, -1)]), "lobes[1]: power is -1: expected a number, 0 or more"),
                (lambda: gn.image((4, 4), lobes=[(1, 0, 1, 0)]), "lobes have no power"),
                (lambda: gn.noise(np.where(x, 0, np.nan), 0), "x[0, 0] is nan: expected a number from -1e+09 to 1e+09"),
                (lambda: gn.noise(1j, 0), "x is 1j"),
                (lambda: gn.noise([0, 1], [0, 1, 2]), "x (2,), y (3,)"),
                (lambda: gn.noise_spread(0, 0, orientation_spread=2), "orientation_spread is 2: expected a number from 0 to 1.570797"),
                (lambda: gn.noise_filtered(0, 0, (1, 2, 3)), "pixel_size is (1, 2, 3): expected one number, or 2 numbers along the last axis"),
                (lambda: gn.fbm(0, 0, octaves=17), "octaves is 17: expected a number from 1 to 16"),
                (lambda: gn.fbm(0, 0, gain=-1), "gain is -1: expected a number from 0 to 4"),
                (lambda: gn.fbm(0, 0, lacunarity=5), "lacunarity is 5: expected a number from 1 to 4"),
                (lambda: gn.fbm(0, 0, turn="left"), "turn is 'left': expected a number from -1000000 to 1000000"),
                (lambda: gn.fbm(0, 0, basis="simplex"), "basis is 'simplex': expected one of smooth, perlin"),
                (lambda: gn.fbm_3d(0, 0, 0, shape=2), "shape is 2: expected one of fbm, billow, ridged"),
                (lambda: gn.fbm_gradient(0, 0, period=2.5), "period is 2.5: expected a number or one for each axis, 0 for no repetition or 2.66667"),
                (lambda: gn.fbm_filtered(0, 0, -1), "pixel_size is -1: expected a number, 0 or more"),
                (lambda: gn.warp(0, 0, strength=np.inf), "strength is inf"),
                (lambda: gn.uniform(np.nan), "noise is nan: expected a finite number"),
                (lambda: gn.noise_3d(0, 0, 0, direction=(0, 0, 0)), "direction is (0, 0, 0)"),
                (lambda: gn.material("wood", 0, 0, period=(3, 0)), "period is (3, 0): expected one along both axes or neither"),
                (lambda: gn.material("wood", 0, 0, period=(0, 3)), "period is (0, 3): expected one along both axes or neither"),
                (lambda: gn.noise_3d(0, 0, 0, direction=1), "direction is 1: expected 3 numbers along the last axis"),
                (lambda: gn.terrain(0, 0, [1, 2, 3]), "base is [1, 2, 3]: expected 4 values"),
                (lambda: gn.terrain(0, 0, period=3), "period is 3"),
                (lambda: gn.terrain(0, 0, octaves=2.5), "octaves is 2.5: expected an integer from 0 to 16"),
                (lambda: gn.erode(np.zeros(5), 2), "heights is an array of shape (5,)"),
                (lambda: gn.material("wod", 0, 0), "name is 'wod': expected one of wood"),
                (lambda: gn.material("wood", 0, 0, rings=300), "rings is 300: expected a number from 2 to 60"),
                (lambda: gn.material("wood", 0, 0, earlywood_colour=0.5), "earlywood_colour is 0.5: expected a linear colour"),
                (lambda: gn.source("noise", "basic"), "language is 'basic'"),
                (lambda: gn.source("perlin"), "name is 'perlin'")):
            with self.assertRaises(ValueError, msg=said) as caught:
                call()
            self.assertIn(said, str(caught.exception))
        for call, said in ((lambda: gn.terrain(0, 0, sharpness=2), "terrain() has no argument 'sharpness': expected octaves"),
                           (lambda: gn.material("wood", 0, 0, rngs=2), "material('wood') has no argument 'rngs': expected early")):
            with self.assertRaises(TypeError, msg=said) as caught:
                call()
            self.assertIn(said, str(caught.exception))

    def test_defaults(self):
        common = "seed=0, period=None, evolution=None, workers=None, dtype=float32"
        wave = f"x, y, frequency=4.0, orientation=0.0, {common}"
        octaves = f"octaves=5.0, gain=0.5, lacunarity=2.0, basis=smooth, shape=fbm, turn={np.arctan(0.75)}, {common}"
        ground = common.replace("evolution=None, ", "")
        sea = "x, y, seconds=0.0, direction=0.0, loop_seconds=0, seed=0, workers=None, dtype=float32, wind=10.0, fetch=200000.0, swell_height=0.0, " \
              "swell_period=12.0, swell_direction=1.047198, water_depth=0.0"
        for name, expected in {
                "image": "shape, scale=32.0, frequency=4.0, orientation=0.0, isotropic=False, frequency_spread=0.0, orientation_spread=0.0, "
                         f"lobes=None, {common}",
                "volume": f"shape, scale=32.0, frequency=4.0, direction=None, {common}",
                "grid": "shape, scale=32.0",
                "noise": wave, "noise_gradient": wave, "noise_quadrature": wave,
                "noise_isotropic": wave.replace("orientation=0.0, ", ""),
                "noise_spread": wave.replace("seed", f"frequency_spread=0.0, orientation_spread={np.pi / 2}, seed"),
                "noise_lobes": f"x, y, lobes, {common}",
                "Lobe": "cycles_per_unit, orientation=0.0, radius=1.0, power=1.0",
                "noise_filtered": wave.replace("y,", "y, pixel_size,"),
                "noise_3d": f"x, y, z, frequency=4.0, direction=None, {common}",
                "stripes": f"x, y, wave_x, wave_y, sharpness=2.0, {common}",
                "fbm": f"x, y, {octaves}", "fbm_gradient": f"x, y, {octaves}", "fbm_filtered": f"x, y, pixel_size, {octaves}",
                "fbm_3d": f"x, y, z, {octaves}", "warp": f"x, y, strength, {octaves.replace('float32', 'float64')}",
                "perlin": "x, y, seed=0, workers=None, dtype=float32", "uniform": "noise, workers=None, dtype=float32",
                "terrain": f"x, y, base=None, pixel_size=0.0, {ground}",
                "erode": f"heights, extent, gully_width=None, tileable=False, {ground.replace('period=None, ', '')}",
                "material": f"name, x, y, pixel_size=0.0, {ground}, parameters",
                "water": sea.replace("seed", "pixel_size=0.0, seed"), "water_height": sea,
                "movie": "shape, frames, frequency=0.05, bandwidth=1.0, orientation=0.0, orientation_bandwidth=0.5, drift_per_frame=1.0, contrast=1.0, "
                         "seed=0, pixels_per_degree=None, workers=None",
                "source": "name=noise, language=glsl"}.items():
            found = [f"{each.name}={getattr(each.default, '__name__', each.default)}" if each.default is not each.empty else each.name
                     for each in inspect.signature(getattr(gn, name)).parameters.values() if each.name not in EROSION or name not in ("terrain", "erode")]
            self.assertEqual(", ".join(found), expected, name)

    def test_help(self):
        self.assertEqual(inspect.signature(gn.terrain).parameters["octaves"].default, 5)
        self.assertEqual(inspect.signature(gn.erode).parameters["gully_weight"].default, 0.5)
        self.assertEqual(inspect.signature(gn.erode).parameters["strength"].default, 0.15)
        self.assertIn("        rings: growth rings per unit, 2 to 60 [13.0]\n", gn.material.__doc__)
        for name in gn.__all__:
            self.assertTrue(getattr(gn, name).__doc__, name)


class Erosion(unittest.TestCase):
    HILLS = gn.terrain(*gn.grid((240, 240), 30), octaves=0, dtype=np.float64)[..., 0]

    def test_returned_slopes_are_those_of_the_result(self):
        result = gn.erode(self.HILLS, 8, gully_width=2, **dict(octaves=2, strength=0.12, onset_slope=0.5, detail=1.5, uniformity=2, crease_rounding=0.1), dtype=np.float64)
        self.assertGreater((result[..., 0] - self.HILLS).std(), 0.01)
        for channel, axis in ((1, 1), (2, 0)):
            numeric = np.gradient(result[..., 0], 1 / 30, axis=axis)
            error = (result[..., channel] - numeric)[4:-4, 4:-4].std() / numeric.std()
            self.assertLess(error, 0.2, f"channel {channel}")  # 0.11 to 0.15; without the curvature: about 0.45

    def test_is_in_proportion_to_slopes_and_width(self):
        result = gn.erode(self.HILLS, 8, seed=5, dtype=np.float64)
        for width, height in ((8, 3.0), (25000.0, 1.0), (25000.0, 900.0)):
            other = gn.erode(height * self.HILLS, width, seed=5, dtype=np.float64)
            np.testing.assert_allclose(other[..., 0], height * result[..., 0], rtol=0, atol=2e-5 * height)
            np.testing.assert_allclose(other[..., 1:3] * (width / 8), height * result[..., 1:3], rtol=0, atol=1e-3 * height)

    def test_changes_are_at_most_an_eighth_of_the_range(self):
        x, y = gn.grid((160, 160), 20)
        steep = np.sin(12 * x) + 0 * y
        most = np.ptp(steep) / 8
        self.assertLess(np.abs(gn.erode(steep, 8)[..., 0] - steep).max(), most)
        self.assertGreater(np.abs(gn.erode(steep, 8, strength=0.15)[..., 0] - steep).max(), most)
        with self.assertRaisesRegex(TypeError, "gully_width or gully_frequency"):
            gn.erode(steep, 8, gully_width=1, gully_frequency=1)

    def test_a_map_is_smoothed_alike_along_both_axes(self):
        for tileable in False, True:
            (surface, slope), (turned, turned_slope) = (smoothed(each, 5.0, 1.0, tileable) for each in (self.HILLS[:90, :200], self.HILLS[:90, :200].T))
            self.assertAlmostEqual(slope, turned_slope, delta=1e-12)
            self.assertAlmostEqual(slope, np.hypot(surface[1].std(), surface[2].std()), delta=0.1 * slope)
            for one, other in zip(surface, (turned[k].T for k in (0, 2, 1, 5, 4, 3))):
                np.testing.assert_allclose(one, other, rtol=0, atol=1e-12)

    def test_pixels_may_be_higher_than_wide(self):
        whole = gn.erode(self.HILLS, 8, seed=5, dtype=np.float64)
        pairs = lambda values: (values[::2] + values[1::2]) / 2
        tall = gn.erode(pairs(self.HILLS), (8, 8), seed=5, dtype=np.float64)
        for channel in range(3):
            error = (tall - pairs(whole))[2:-2, 2:-2, channel].std() / pairs(whole)[..., channel].std()
            self.assertLess(error, (0.01, 0.2, 0.2)[channel], f"channel {channel}")
        with self.assertRaisesRegex(ValueError, "extent"):
            gn.erode(self.HILLS, (8, 8, 8))

    def test_without_octaves_the_map_stays(self):
        for tileable in (False, True):
            self.assertLess(np.abs(gn.erode(self.HILLS, 8, octaves=0, tileable=tileable)[..., 0] - self.HILLS).max(), 1e-6)
        np.testing.assert_array_equal(gn.erode(np.full((9, 9), 7.0), 8)[..., 0], 7)

    def test_a_tile_has_no_seam(self):
        x, y = gn.grid((80, 160), 20)
        for extent in 8, (8, 5):  # pixels may be higher than wide
            tile = gn.erode(np.sin(np.pi / 2 * x + 0.8) + np.cos(np.pi * y + 0.8), extent, tileable=True)[..., 0]
            for axis in (0, 1):
                bends = np.abs(np.roll(tile, 1, axis) - 2 * tile + np.roll(tile, -1, axis)).mean(1 - axis)
                self.assertLess(max(bends[0], bends[-1]), 1.5 * bends.mean())  # with the period of the other axis: 3 times

    def test_slopes_of_a_tile_are_right_at_the_edges_too(self):
        x, y = gn.grid((80, 160), 20)
        tile = gn.erode(np.sin(np.pi / 2 * x + 0.8) + np.cos(np.pi * y + 0.8), 8, tileable=True, octaves=0, dtype=np.float64)
        for channel, axis in ((1, 1), (2, 0)):
            height = tile[..., 0]
            np.testing.assert_allclose(tile[..., channel], (np.roll(height, -1, axis) - np.roll(height, 1, axis)) * 10, rtol=0, atol=1e-4)


@unittest.skipUnless(sys.argv[1:], "no folder of python.md given")
class Documentation(unittest.TestCase):
    """Runs the blocks of python.md one after another: they write the page's pictures."""

    def test_code_makes_the_pictures(self):
        docs = pathlib.Path(sys.argv[1])
        page = (docs / "python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        shown = re.findall(r"!\[.*?\]\((.*?)\)", page)
        self.assertGreaterEqual(len(shown), 6)
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            names: dict = {}
            for block in blocks:
                exec(block.replace('save("', f'save("{here.as_posix()}/'), names)
            for name in shown:
                with Image.open(here / name) as made, Image.open(docs / name) as committed:
                    self.assertEqual(made.size, committed.size, name)
                    difference = np.abs(np.asarray(made, float) - np.asarray(committed, float)).mean()
                    print(f"{name}: mean difference {difference:.2f} of 255")
                    self.assertLess(difference, 1.0, name)

    def test_an_example_saves_frames(self):
        example = pathlib.Path(sys.argv[1]).parent / "packages" / "pypi" / "examples" / "vision.py"
        with tempfile.TemporaryDirectory() as folder:
            movie = gn.movie
            with unittest.mock.patch.object(sys, "argv", [str(example), "--save", f"{folder}/frames"]), \
                    unittest.mock.patch.object(gn, "movie", lambda shape, *others, **options: movie((64, shape[1]), *others, **options)):
                runpy.run_path(str(example))
            frames = [np.asarray(Image.open(path), float) for path in sorted(pathlib.Path(folder, "frames").iterdir())]
        self.assertEqual(len(frames), 120)
        # The pattern moves 32 pixels to the right in 15 frames.
        self.assertLess(np.abs(frames[40][:, 32:] - frames[25][:, :-32]).max(), 1.1)
        self.assertLess(abs(np.std(frames) / 127.5 - 0.25), 0.01)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
