"""Checks that a request gives the same pixels however lavapipe divides its work, and the same within the documented tolerance
on another driver, SwiftShader. GABOR_OTHER_PROGRAM can name a build by another compiler, which must give the same bytes."""

import glob
import json
import os
import pathlib
import unittest

import numpy as np

from exr import Exr
from program import LAVAPIPE, ProgramTest

SWIFTSHADER = next(iter(glob.glob("/usr/lib/chromium/vk_swiftshader_icd.json")), None)

# Adds channels to the noise. The size leaves partial cells at the right and lower edges.
COMMON = ("--size=300x200", "--scale=21.7", "--orientation=33", "--seed=7", "--gradient")
REQUESTS = [*(("--recipe", recipe) for recipe in ("one", "pure", "paper")), ("--tileable",), ("--evolution=0.3",),
            ("--frequency=9.5",), ("--region=10,20,111,77",)]


class Drivers(ProgramTest):
    def render(self, *options, **settings):
        self.succeed("render", "-o", "out.exr", *COMMON, *options, **settings)
        return (self.folder / "out.exr").read_bytes()

    @unittest.skipUnless(LAVAPIPE, "needs Mesa's lavapipe")
    def test_lavapipe_gives_the_same_bits_however_it_divides_its_work(self):
        for options in REQUESTS:
            pixels = set()
            for width, threads in (("128", "0"), ("256", "1"), ("256", "4")):
                self.render(*options, env={"VK_ICD_FILENAMES": LAVAPIPE, "LP_NATIVE_VECTOR_WIDTH": width,
                                           "LP_NUM_THREADS": threads})
                channels = Exr(self.folder / "out.exr").channels  # without the header, which names the vector width
                pixels.add(tuple((name, values.tobytes()) for name, values in sorted(channels.items())))
            self.assertEqual(len(pixels), 1, options)

    @unittest.skipUnless(LAVAPIPE and SWIFTSHADER, "needs lavapipe and SwiftShader")
    def test_two_drivers_agree(self):
        """Each driver is within 2e-5 of the exact noise up to frequency 4. Above that, its error is proportional to the
        frequency, as render/request/request.hpp says."""
        for options in REQUESTS[:-1]: # a region is a part of the picture
            pixels = []
            for driver in (LAVAPIPE, SWIFTSHADER):
                # The search for leaks crashes in SwiftShader's threads; every other test searches on lavapipe.
                leaks = {"ASAN_OPTIONS": "detect_leaks=0"} if driver == SWIFTSHADER else {}
                self.render(*options, env={"VK_ICD_FILENAMES": driver, **leaks})
                pixels.append(Exr(self.folder / "out.exr").channels)
            frequency = 9.5 if "--frequency=9.5" in options else 4
            for channel in pixels[0]:
                slope = 2 * np.pi * frequency if channel.startswith("gradient") else 1
                difference = np.abs(pixels[0][channel] - pixels[1][channel]).max()
                print(f"  {' '.join(options)}, {channel}: the drivers differ by {difference:.1e}")
                self.assertLessEqual(difference, 4e-5 * frequency / 4 * slope)

    @unittest.skipUnless(LAVAPIPE, "needs Mesa's lavapipe")
    def test_drivers_over_metal_are_listed(self):
        """The loader hides drivers that call themselves portability drivers, as MoltenVK does, unless a program asks for them."""
        driver = json.loads(pathlib.Path(LAVAPIPE).read_text())
        driver["ICD"]["is_portability_driver"] = True
        (self.folder / "driver.json").write_text(json.dumps(driver))
        drivers = {"VK_ICD_FILENAMES": f"{self.folder}/driver.json", "VK_DRIVER_FILES": None}
        self.assertIn("llvmpipe", self.succeed("devices", env=drivers))
        self.succeed("render", "-o", "out.exr", "--size=8x8", env=drivers)

    def test_two_compilers_agree(self):
        other = os.environ.get("GABOR_OTHER_PROGRAM")
        if not other:
            self.skipTest("needs GABOR_OTHER_PROGRAM")
        for options in REQUESTS:
            self.assertEqual(self.render(*options), self.render(*options, command=[other]), options)


if __name__ == "__main__":
    unittest.main()
