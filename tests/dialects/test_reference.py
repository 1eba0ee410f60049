"""Compares the reference of tests/engines with the program, which has its own reference in tests/reference."""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path[:0] = (str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("engines", "cli"))
import reference  # noqa: E402
from exr import Exr  # noqa: E402


class Reference(unittest.TestCase):
    def test_it_matches_the_program(self):
        side = reference.WIDTH
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            picture = pathlib.Path(folder) / "noise.exr"
            subprocess.run([os.environ["GABOR_PROGRAM"], "render", "-o", picture, f"--size={side}x{side}", "--scale=32",
                            f"--frequency={reference.FREQUENCY}", f"--seed={reference.SEED}", "--compression=none", "--recipe=one",
                            f"--orientation={math.degrees(reference.ORIENTATION)}"], check=True, timeout=50)
            pixels = Exr(picture).pixels
        difference = np.abs(pixels - reference.values("one")[:side])
        place = np.unravel_index(difference.argmax(), difference.shape)
        print(f"largest difference {difference.max():.2g} at row and column {place}")
        self.assertLess(difference.max(), 1e-5)

    def test_a_wrong_value_is_found(self):
        for scene in reference.SCENES:
            drawn = reference.values(scene).copy()
            drawn[256, 3] += 1e-4
            error, place = reference.largest_difference(scene, drawn)
            self.assertAlmostEqual(error, 1e-4)
            self.assertEqual(place, (256, 3))


if __name__ == "__main__":
    unittest.main()
