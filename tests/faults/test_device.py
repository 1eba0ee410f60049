"""If the device runs out of memory or is lost, at any call, the program exits with status 1, prints one line, writes no
file and leaves an older one as it was. The layer in layer.cpp injects the faults."""

import itertools
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import LAVAPIPE, ProgramTest, gabor  # noqa: E402

LAB = os.environ["GABOR_LAB"]
LAYER = os.environ["GABOR_FAULT_LAYER"]
SEVERAL_BANDS = ("--size=2200x4000",)


def broken(function, call):
    """Returns the environment for this fault. Validation is off, because its messages would add lines to stderr."""
    return {"GABOR_VALIDATION": None, "VK_ADD_LAYER_PATH": LAYER, "VK_INSTANCE_LAYERS": "VK_LAYER_GABOR_fault",
            "GABOR_FAULT": f"{function}:{call}"}


class Device(ProgramTest):
    def fail_at_every_call(self, function, words, least, *arguments):
        """Fails all calls from the first on, then from the second on, and so on, until none is left to fail."""
        for call in range(1, 100):
            before = self.files()
            result = gabor(*arguments, cwd=self.folder, env=broken(function, call))
            if result.returncode == 0:
                break
            self.assert_failed(1, words, result, before)
        self.assertGreater(call, least, f"{function}: fewer calls than expected")

    def test_a_lack_of_memory_or_a_loss_while_rendering_is_reported(self):
        for function, words, least in (("vkAllocateMemory", ["out of memory: ", "llocateMemory"], 4),
                                       ("vkCreateComputePipelines", ["OutOfDeviceMemory"], 1),
                                       ("vkCreateDevice", ["OutOfDeviceMemory"], 1), ("vkQueueSubmit", ["DeviceLost"], 2),
                                       ("vkWaitForFences", ["DeviceLost"], 2)):
            for output in ("new.exr", "old.exr"):
                with self.subTest(function, output=output):
                    (self.folder / "old.exr").write_text("older")
                    (self.folder / "new.exr").unlink(missing_ok=True)
                    self.fail_at_every_call(function, words, least, "render", "-o", output, *SEVERAL_BANDS)

    @unittest.skipUnless(LAVAPIPE, "needs Mesa's lavapipe, which the loader lists twice")
    def test_the_fastest_kind_of_device_is_chosen(self):
        other, integrated, discrete, virtual, cpu = range(5)
        order = [discrete, integrated, virtual, cpu, other]
        for name in "one.json", "two.json":
            (self.folder / name).write_text(pathlib.Path(LAVAPIPE).read_text())
        drivers = f"{self.folder}/one.json:{self.folder}/two.json"
        for first, second in itertools.permutations(order, 2):
            result = gabor("render", "-o", "out.exr", "--size=8x8", cwd=self.folder,
                           env=broken("none", 1) | {"VK_ICD_FILENAMES": drivers, "VK_DRIVER_FILES": None, "GABOR_FAULT_TYPES": f"{first}{second}"})
            self.assertEqual(result.returncode, 0, result.stderr)
            best = int(order.index(second) < order.index(first))
            self.assertIn(f"on device {best}", result.stdout + result.stderr, (first, second))

    def test_a_loss_during_a_study_is_reported(self):
        result = gabor("study", "figure1", "--quick", "-o", ".", command=(LAB,), cwd=self.folder,
                       env=broken("vkWaitForFences", 3))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Agabor-lab: [^\n]*DeviceLost[^\n]*\n\Z")
        self.assertEqual(self.files(), {})


if __name__ == "__main__":
    unittest.main()
