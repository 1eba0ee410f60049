"""If the device runs out of memory or is lost, at any call, the program exits with status 1, prints one line, writes no
file and leaves an older one as it was. The layer in layer.cpp injects the faults."""

import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, gabor  # noqa: E402

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

    def test_a_loss_during_a_study_is_reported(self):
        result = gabor("study", "figure1", "--quick", "-o", ".", command=(LAB,), cwd=self.folder,
                       env=broken("vkWaitForFences", 3))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Agabor-lab: [^\n]*DeviceLost[^\n]*\n\Z")
        self.assertEqual(self.files(), {})


if __name__ == "__main__":
    unittest.main()
