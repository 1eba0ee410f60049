"""The pixels of this version: 8 x 8 of them for each recipe, block by block and pixel by pixel, in the first and in the
last corner of the largest picture. On Mesa 22.3's lavapipe, Debian 12's, they are the numbers of tests/golden/pixels.txt
bit for bit; on other drivers within the tolerance that render/request.hpp states. Whoever changes them changes the
version. After a change that is meant, this writes the file anew, and the diff shows what changed:

    GABOR_PROGRAM=$PWD/build/dev/gabor GABOR_GOLDEN=write python3 tests/cli/test_golden.py
"""

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

    def write(self, blocks):
        lines = [f"version {VERSION}"]
        for name, values in blocks.items():
            lines += [name, *(" ".join(f"{value:.9g}" for value in row) for row in values)]
        GOLDEN.write_text("\n".join(lines) + "\n")
        self.fail(f"{GOLDEN} is written: look at what changed, and run the test without GABOR_GOLDEN")

    def read(self):
        version, *lines = GOLDEN.read_text().splitlines()
        self.assertEqual(version, f"version {VERSION}", "these are the pixels of another version")
        return {lines[i]: np.loadtxt(lines[i + 1:i + 1 + SIDE], dtype="f4") for i in range(0, len(lines), SIDE + 1)}

    def test_pixels_are_those_of_this_version(self):
        blocks = self.rendered()
        if os.environ.get("GABOR_GOLDEN") == "write":
            self.write(blocks)
        exact = "Mesa 22.3" in self.succeed("devices").split("\n1 ")[0]
        expected = self.read()
        self.assertEqual(list(blocks), list(expected))
        largest = 0
        for name, values in blocks.items():
            self.assertEqual(values.shape, (SIDE, SIDE))
            if exact:
                self.assertEqual(values.tobytes(), expected[name].tobytes(), name)
                continue
            difference = np.abs(values - expected[name])
            if name.endswith("phase"):  # turns; 0 is 1
                difference = np.minimum(difference, 1 - difference)
            tolerance = 2 * np.pi * FREQUENCY * 2e-5 if "gradient." in name else 2e-4 if name.endswith("phase") else 2e-5
            self.assertLessEqual(difference.max(), tolerance, name)
            largest = max(largest, difference.max() / tolerance)
        print(f"{len(blocks)} blocks,", "bit for bit" if exact else f"the largest difference {largest:.2f} of its tolerance")


if __name__ == "__main__":
    unittest.main()
