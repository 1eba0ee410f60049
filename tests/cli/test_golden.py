"""The pixels of this version: 8 x 8 for each recipe, drawn in blocks and pixel by pixel, in the first and the last
corner of the largest picture. On lavapipe from Mesa 22.3 (Debian 12), their hashes must match tests/golden/pixels.txt;
on other drivers, the sums of rows must agree within the tolerance in render/request.hpp. Changing pixels requires a new
version. After an intended change, regenerate the file with this command and review the diff:

    GABOR_PROGRAM=$PWD/build/dev/gabor GABOR_GOLDEN=write python3 tests/cli/test_golden.py
"""

import hashlib
import os
import pathlib
import re
import unittest

import numpy as np

from exr import Exr
from program import ProgramTest

GOLDEN = pathlib.Path(__file__).parents[1] / "golden" / "pixels.txt"
VERSION = re.search(r"VERSION ([\d.]+)", (GOLDEN.parents[2] / "CMakeLists.txt").read_text().split("project(")[1])[1]
SIDE = 8
FREQUENCY = 1.5
COMMON = ("--size=65536x65536", "--scale=3", f"--frequency={FREQUENCY}", "--orientation=40", "--seed=7")
CORNERS = {"first": 0, "last": 65536 - SIDE}
REQUESTS = [("--quadrature", "--gradient"), ("--tileable", "--time=0.3"), ("--phasor",),
            ("--phasor", "--gradient", "--tileable", "--time=0.3")]


class Golden(ProgramTest):
    def rendered(self):
        blocks = {}
        for recipe in ("one", "pure", "paper", "lattice", "lattice-2", "lattice-4"):
            for request in REQUESTS:
                for corner, at in CORNERS.items():
                    self.succeed("render", "-o", "out.exr", f"--recipe={recipe}", f"--region={at},{at},{SIDE},{SIDE}",
                                 *COMMON, *request)
                    for name, values in Exr(self.folder / "out.exr").channels.items():
                        blocks[f"{recipe} {' '.join(request)}, {corner} corner: {name}"] = values
        return blocks

    def test_pixels_match_this_version(self):
        blocks = self.rendered()
        lines = [f"{name}: {hashlib.sha256(values.tobytes()).hexdigest()[:16]} " + " ".join(f"{v:.6f}" for v in sums(name, values))
                 for name, values in blocks.items()]
        if os.environ.get("GABOR_GOLDEN") == "write":
            GOLDEN.write_text("\n".join([f"version {VERSION}", *lines]) + "\n")
            self.fail(f"{GOLDEN} is written: look at what changed, and run the test without GABOR_GOLDEN")
        version, *expected = GOLDEN.read_text().splitlines()
        self.assertEqual(version, f"version {VERSION}", "these are the pixels of another version")
        if "Mesa 22.3" in self.succeed("devices").split("\n1 ")[0]:
            self.assertEqual(lines, expected)
            return
        self.assertEqual(list(blocks), [line.rpartition(": ")[0] for line in expected])
        for (name, values), line in zip(blocks.items(), expected):
            wanted = np.array(line.rpartition(": ")[2].split()[1:], dtype=float)
            tolerance = 2 * np.pi * FREQUENCY * 4e-5 if "gradient." in name else 1e-3 if name.endswith("phase") else 4e-5
            self.assertLessEqual(np.abs(sums(name, values) - wanted).max(), tolerance, name)


def sums(name, values):
    """The sum of each row with a different weight per column, and with the sine of phases."""
    values = np.sin(2 * np.pi * values.astype(float)) if name.endswith("phase") else values.astype(float)
    return values @ [1, -0.9, 0.8, -0.7, 0.6, -0.5, 0.4, -0.3]


if __name__ == "__main__":
    unittest.main()
