"""Runs the golden functions, compiled for Windows, under Wine: they must have their golden values, and the values that Linux computes
at other points, but for the rounding of the C library. GABOR_WINE runs programs for Windows, GABOR_LINUX is the build for Linux,
and GABOR_FUNCTIONS the folder with functions of each set, golden_SET.exe."""

import os
import pathlib
import re
import subprocess
import unittest

import numpy as np

GOLDEN = pathlib.Path(__file__).parents[1] / "golden"
FUNCTIONS, LINUX = pathlib.Path(os.environ["GABOR_FUNCTIONS"]), pathlib.Path(os.environ["GABOR_LINUX"]) / "tests"
POINTS = "20", "1000"  # the first, and how many
LARGEST = 1e-6


class Functions(unittest.TestCase):
    def test_golden_values_and_linux_values(self):
        sets = re.findall(r"defined GABOR_OF_(\w+)", (GOLDEN / "sets.h").read_text())
        self.assertGreater(len(sets), 10)
        for name in sets:
            with self.subTest(name):
                windows = [os.environ["GABOR_WINE"], FUNCTIONS / f"golden_{name}.exe"]
                golden = subprocess.run([*windows, GOLDEN / f"{name}.txt"], capture_output=True, text=True, timeout=600)
                self.assertEqual(golden.returncode, 0, golden.stdout + golden.stderr)
                # Windows writes each line feed as two characters.
                there = subprocess.run([*windows, *POINTS], capture_output=True, check=True, timeout=600).stdout.replace(b"\r\n", b"\n")
                here = subprocess.run([LINUX / f"golden_{name}", *POINTS], capture_output=True, check=True).stdout
                self.assertEqual(len(there), len(here))
                there, here = np.frombuffer(there, "<f4").astype(float), np.frombuffer(here, "<f4").astype(float)
                finite = np.isfinite(here)  # materials have no finite values beyond their ranges
                self.assertGreater(np.count_nonzero(finite), 0.99 * here.size)
                np.testing.assert_array_equal(there[~finite], here[~finite])
                there, here = there[finite], here[finite]
                apart = np.abs(there - here) / np.maximum(np.abs(here), 1)
                print(f"  {name}: {np.count_nonzero(apart)} of {here.size} values differ, by at most {apart.max():.1e}")
                self.assertLess(apart.max(), LARGEST)


if __name__ == "__main__":
    unittest.main()
