"""Checks that a viewer killed while it exports leaves complete files or none."""

import os
import pathlib
import random
import signal
import time
import unittest

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from atomic import can_hide_files, check_files, prepare

ROUNDS = int(os.environ.get("GABOR_ROUNDS", 4))


class Export(EventsTest):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.out.mkdir()
        self.preset("preset.json", width=2200, height=2200)  # two bands

    def begin(self, older=False):
        """Opens a viewer and waits until its export begins by opening an unnamed file in the folder."""
        self.open("--preset", "preset.json", "--window", "480x320")
        self.process.stdin.write("export out/noise.exr\n")
        self.process.stdin.flush()
        if older:
            self.wait_for(lambda state: state["question"])
            self.xdotool("key", "Return") # lets the export replace the files
        descriptors = pathlib.Path(f"/proc/{self.process.pid}/fd")

        def has_begun():
            try:
                return any(os.readlink(entry).startswith(str(self.out)) for entry in descriptors.iterdir())
            except FileNotFoundError: # a file was closed in the meantime
                return False

        self.wait(has_begun)

    def wait(self, condition):
        end = time.monotonic() + 60
        while not condition():
            self.assertFalse(self.ended)
            self.assertLess(time.monotonic(), end, "timed out")
            time.sleep(0.001)

    def kill(self):
        self.process.kill()
        self.end(-signal.SIGKILL)

    def test_killed(self):
        if not can_hide_files(self.out):
            self.skipTest("needs a file system with O_TMPFILE")
        names = ("noise.exr", "noise.png")
        self.begin()
        began = time.monotonic()
        self.wait(lambda: all((self.out / name).exists() for name in names))
        duration = time.monotonic() - began
        self.kill()
        complete = {name: (self.out / name).read_bytes() for name in names}
        self.gabor("render", "--like", "preset.json", "-o", "noise.exr", "--png", "noise.png")
        for name in names:
            self.assertEqual(complete[name], (self.folder / name).read_bytes(), name)

        moments = random.Random(3)
        whole = 0
        for turn in range(ROUNDS):
            prepare(self.out, names, older=turn % 2)
            self.begin(older=turn % 2)
            time.sleep(duration * moments.choice([moments.uniform(0, 1), moments.uniform(0.7, 1.2)]))
            self.kill()
            whole += len(check_files(self, self.out, complete, older=turn % 2)) == len(names)
        print(f"{ROUNDS} exports killed within {1.2 * duration:.2f} s, {whole} of them complete")


if __name__ == "__main__":
    unittest.main()
