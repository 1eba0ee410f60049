"""A viewer killed while it exports leaves complete files or none."""

import json
import os
import pathlib
import random
import time
import unittest

from viewer import ViewerTest  # noqa: I001 (first: it adds the folder of the next one to sys.path)
from atomic import can_hide_files, check_files, prepare

PRESET = {"width": 2200, "height": 2200} # two bands
# Enter confirms overwriting older files.
SCRIPT = "export out/noise.exr\nkey enter\nsleep 60"
ROUNDS = int(os.environ.get("GABOR_ROUNDS", 4))


class Export(ViewerTest):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.out.mkdir()
        (self.folder / "preset.json").write_text(json.dumps(PRESET))

    def begin(self):
        """A viewer whose export has just begun: it holds an unnamed file open in the folder."""
        process = self.start_script(SCRIPT, "--preset", "preset.json", "--window", "480x320")
        descriptors = pathlib.Path(f"/proc/{process.pid}/fd")

        def has_begun():
            try:
                return any(os.readlink(entry).startswith(str(self.out)) for entry in descriptors.iterdir())
            except FileNotFoundError: # one file was just closed
                return False

        self.wait(process, has_begun)
        return process

    def wait(self, process, condition):
        end = time.monotonic() + 60
        while not condition():
            self.assertIsNone(process.poll(), f"the viewer ended: {process.returncode}")
            self.assertLess(time.monotonic(), end, "the export did not get this far")
            time.sleep(0.001)

    def kill(self, process):
        process.kill()
        process.communicate(timeout=60)

    def test_killed(self):
        if not can_hide_files(self.out):
            self.skipTest("needs a file system with O_TMPFILE")
        names = ("noise.exr", "noise.png")
        process = self.begin()
        began = time.monotonic()
        self.wait(process, lambda: all((self.out / name).exists() for name in names))
        duration = time.monotonic() - began
        self.kill(process)
        complete = {name: (self.out / name).read_bytes() for name in names}
        self.gabor("render", "--like", "preset.json", "-o", "noise.exr", "--png", "noise.png")
        for name in names:
            self.assertEqual(complete[name], (self.folder / name).read_bytes(), name)

        moments = random.Random(3)
        whole = 0
        for turn in range(ROUNDS):
            prepare(self.out, names, older=turn % 2)
            process = self.begin()
            time.sleep(duration * moments.choice([moments.uniform(0, 1), moments.uniform(0.7, 1.2)]))
            self.kill(process)
            whole += len(check_files(self, self.out, complete, older=turn % 2)) == len(names)
        print(f"{ROUNDS} exports killed within {1.2 * duration:.2f} s, {whole} of them complete")


if __name__ == "__main__":
    unittest.main()
