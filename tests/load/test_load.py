"""Runs many processes, and renders large pictures in limited memory. GABOR_LONG=1 runs everything, which takes half an
hour and 10 GiB of disk."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import PROGRAM, ProgramTest, environment  # noqa: E402

LONG = os.environ.get("GABOR_LONG")
MIB = 1 << 20

# The limit on resident memory for any picture. Most of this memory belongs to the driver and grows with the number of threads.
BOUND = 512 * MIB


class Load(ProgramTest):
    def run_measured(self, *arguments):
        """Runs the program, which must succeed, and returns its peak resident memory in bytes."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, env=environment(GABOR_VALIDATION=None),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        stderr = process.stderr.read()
        process.stderr.close()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual((process.returncode, stderr), (0, b""))
        return usage.ru_maxrss * 1024

    def test_later_processes_need_no_more_memory(self):
        count = 200 if LONG else 12
        peaks = [self.run_measured("render", "-o", "out.exr", "--size=300x200") for _ in range(count)]
        print(f"  {count} processes, one after another: {min(peaks) // MIB} to {max(peaks) // MIB} MiB each")
        quarter = max(count // 4, 1)
        self.assertLess(np.median(peaks[-quarter:]), 1.05 * np.median(peaks[:quarter]))
        self.assertEqual(set(self.files()), {"out.exr"})

    def test_processes_at_once_write_whole_files(self):
        """Concurrent processes write to different names, then all to one name."""
        self.run_measured("render", "-o", "alone.exr", "--size=900x900")
        names = [f"{i}.exr" for i in range(8)]
        for outputs in (names, ["one.exr"] * 8):
            processes = [subprocess.Popen([PROGRAM, "render", "-o", name, "--size=900x900"], cwd=self.folder,
                                          env=environment(GABOR_VALIDATION=None), stdout=subprocess.DEVNULL,
                                          stderr=subprocess.PIPE) for name in outputs]
            for process in processes:
                _, stderr = process.communicate(timeout=240)
                self.assertEqual((process.returncode, stderr), (0, b""))
        files = self.files()
        self.assertEqual(set(files), {*names, "one.exr", "alone.exr"})
        self.assertEqual(len(set(files.values())), 1)

    def test_large_pictures_need_bounded_memory(self):
        """Renders a picture (with GABOR_LONG, 32768 x 32768 pixels, 4 GiB), measures it, and fits noise to its PNG."""
        side = 32768 if LONG else 4096
        if shutil.disk_usage(self.folder).free < 5 * side * side:
            self.skipTest("needs more disk space")
        rendering = self.run_measured("render", "-o", "large.exr", "--png", "large.png", f"--size={side}x{side}")
        size = (self.folder / "large.exr").stat().st_size
        self.assertGreater(size, 4 * side * side)
        measuring = self.run_measured("stats", "large.exr", "--json", "large.json")
        fitting = self.run_measured("fit", "large.png", "--lobes", "1", "-o", "fit.json")
        print(f"  {side} x {side}, {size / MIB:.0f} MiB: {rendering // MIB} MiB to render, "
              f"{measuring // MIB} MiB to measure, {fitting // MIB} MiB to fit")
        self.assertLess(rendering, BOUND)
        self.assertLess(measuring, BOUND)
        self.assertLess(fitting, BOUND / 4)
        (self.folder / "large.exr").unlink()


if __name__ == "__main__":
    unittest.main()
