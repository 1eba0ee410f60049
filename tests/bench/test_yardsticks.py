"""Checks the laws of the noises that gabor_noise is compared with, and their hash, in C++."""

import ctypes
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOISES = {name: f"{name}_noise(p, f, 0.7f, s)" for name in ("advice", "gabor_72", "seminal_183", "seminal")} | {
    "perlin": "perlin_noise(p, f, s)", "simplex": "simplex_noise(p, f, s)",
    **{f"gradient_{axis}": f"perlin_noise_gradient(p, f, s).{axis}" for axis in "xyz"},
    **{f"fbm_{axis}": f"perlin_fbm(p, f, 0.6f, s).{axis}" for axis in "xyz"}, "lowest_octave": "perlin_fbm(p, f, 0.0f, s).x"}
SIDE, STEP = 1024, 0.125


def periodogram(field):
    """Returns the power of each frequency, apart from the mean and what has no mirror image."""
    return np.abs(np.fft.rfft2(field - field.mean()))[:, 1:-1] ** 2


def unevenness(values, count):
    """Returns by how many standard deviations the chi-square of `count` equally probable values exceeds its mean."""
    counts = np.bincount(values.ravel(), minlength=count)
    return (((counts - counts.mean())**2 / counts.mean()).sum() - (count - 1)) / (2 * (count - 1))**0.5


class Yardsticks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gabor-"))
        subprocess.run([sys.executable, "-B", ROOT / "tools/translate", "cpp", ROOT / "host/lab/passes/bench/yardsticks.glsl", "-o", folder], check=True)
        functions = "".join(f"""
extern "C" void {name}(int count, const float* points, float f, const unsigned* seeds, float* out) {{
    for (int i = 0; i < count; ++i) {{
        gabor_vec2 p(points[2 * i], points[2 * i + 1]);
        unsigned s = seeds[i];
        out[i] = {call};
    }}
}}""" for name, call in NOISES.items())
        code = pathlib.Path(folder) / "yardsticks.cpp"
        code.write_text(f"""#include "yardsticks.hpp"{functions}
extern "C" void words(int side, int first, unsigned seed, unsigned* out) {{
    for (int i = 0; i < side * side; ++i)
        out[i] = yardstick_word(yardstick_state(gabor_ivec2(first + i % side, first + i / side), seed));
}}""")
        subprocess.run([os.environ["CXX"], "-std=c++17", "-O2", "-shared", "-fPIC", "-I", folder, "-I", ROOT / "shaders/translations", code, "-o", f"{code}.so"],
                       check=True)
        cls.library = ctypes.CDLL(f"{code}.so")

    def values(self, name, points, frequency, seeds=7):
        points = np.ascontiguousarray(points, np.float32)
        out = np.empty(points.shape[:-1], np.float32)
        seeds = np.ascontiguousarray(np.broadcast_to(seeds, out.shape), np.uint32)
        pointer = ctypes.c_void_p
        getattr(self.library, name)(out.size, pointer(points.ctypes.data), ctypes.c_float(frequency), pointer(seeds.ctypes.data), pointer(out.ctypes.data))
        self.assertTrue(np.isfinite(out).all() and out.size)
        return out.astype(float)

    def test_mean_0_and_variance_1(self):
        generator = np.random.default_rng(7)
        for name in ("perlin", "simplex", "fbm_x", "advice", "gabor_72", "seminal_183", "seminal"):
            count = 1 << (18 if "_" in name or name == "seminal" else 20)
            values = self.values(name, generator.uniform(0, 64, (count, 2)), 4, generator.integers(2**32, size=count))
            squares = values**2
            print(f"  {name}: mean {values.mean():.4f}, variance {squares.mean():.4f}")
            self.assertLess(abs(values.mean()), 4.5 * values.std() / count**0.5, name)
            self.assertLess(abs(squares.mean() - 1), 4.5 * squares.std() / count**0.5 + 1e-3, name)

    def test_frequency_is_the_centroid_of_the_spectrum(self):
        points = STEP * np.stack(np.mgrid[:SIDE, :SIDE], -1)
        along = np.hypot(np.fft.fftfreq(SIDE, STEP)[:, None], np.fft.rfftfreq(SIDE, STEP)[1:-1])
        for name in "perlin", "simplex":
            power = periodogram(self.values(name, points, 1) * np.outer(np.hanning(SIDE), np.hanning(SIDE)))
            centroid = (along * power).sum() / power.sum()
            print(f"  {name}: {centroid:.4f}")
            self.assertLess(abs(centroid - 1), 0.01, name)

    def test_gradients(self):
        points = np.random.default_rng(7).uniform(-4, 4, (1 << 16, 2)).astype(np.float32)
        self.assertEqual(abs(self.values("lowest_octave", points, 4) - self.values("perlin", points, 4)).max(), 0)
        self.assertLess(abs(self.values("gradient_x", points, 4) - self.values("perlin", points, 4)).max(), 1e-5)
        for name in "gradient", "fbm":
            for axis, step in ("y", (2.0**-10, 0)), ("z", (0, 2.0**-10)):
                change = self.values(f"{name}_x", points + np.float32(step), 0.25) - self.values(f"{name}_x", points - np.float32(step), 0.25)
                errors = abs(self.values(f"{name}_{axis}", points, 0.25) - change / 2**-9)
                print(f"  {name}, {axis}: largest difference {errors.max():.1g} at {points[errors.argmax()]}")
                self.assertLess(errors.max(), 0.01, name)

    def test_corners_are_independent(self):
        """Words of corners have a flat spectrum, and pairs of near corners and all four of a cell are uniform."""
        side = 512
        for seed, first in (7, -256), (0, 100000), (0xdeadbeef, -70000):
            words = np.empty((side, side), np.uint32)
            self.library.words(side, ctypes.c_int(first), ctypes.c_uint(seed), ctypes.c_void_p(words.ctypes.data))
            parts = [words.astype(np.int32) / 2.0**31, (words << np.uint32(16)).astype(np.int32) / 2.0**31]
            peaks = [(power := periodogram(field)).max() / power.mean() for part in parts for field in (part, np.sign(part), part**2)]
            eighths = [np.floor(4 * part + 4).astype(int) for part in parts]
            deviations = []
            for one, other in ((one, other) for one in eighths for other in eighths):
                for x, y in ((1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1), (1, 2), (3, 0), (0, 3)):
                    deviations.append(unevenness(8 * one[y:, x:] + other[:side - y, :side - x], 64))
            deviations += [unevenness(512 * each[1:, 1:] + 64 * each[1:, :-1] + 8 * each[:-1, 1:] + each[:-1, :-1], 4096) for each in eighths]
            print(f"  seed {seed}: peak {max(peaks):.1f}, chi-square {max(deviations):.1f} standard deviations")
            self.assertLess(max(peaks), 25)  # of 130 000 exponential values: chance exceeds it once in 500 000 spectra
            self.assertLess(max(deviations), 6)


if __name__ == "__main__":
    unittest.main()
