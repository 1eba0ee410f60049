"""Runs gabor-viewer.exe under Wine in an X server: it must draw a preset and the panel, take keys, save a preset and its settings,
and end. GABOR_VIEWER runs it in Wine; the screenshot stays in build/windows/viewer.png."""

import json
import os
import pathlib
import subprocess
import sys
import time
import unittest

import numpy as np
from PIL import ImageGrab

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, environment  # noqa: E402

VIEWER = os.environ["GABOR_VIEWER"]
SCREENSHOT = pathlib.Path(__file__).parents[2] / "build" / "windows" / "viewer.png"


def xdotool(*arguments):
    return subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, text=True).stdout.split()


class Viewer(ProgramTest):
    def wait(self, what, seconds=60):
        for _ in range(10 * seconds):
            if found := what():
                return found
            time.sleep(0.1)
        self.fail("nothing happened")

    def test_a_session(self):
        settings = pathlib.Path(os.environ["WINEPREFIX"]) / "drive_c/users" / os.environ.get("USER", "root") / "AppData/Roaming/gabor-noise/viewer.json"
        settings.unlink(missing_ok=True)
        (self.folder / "sand.json").write_text('{"material": "sand", "seed": 5}')
        process = subprocess.Popen([VIEWER, "sand.json", "--window", "900x600"], cwd=self.folder, env=environment(),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        window = self.wait(lambda: process.poll() is not None or xdotool("search", "--name", "gabor"))
        self.assertIsNone(process.poll(), process.communicate()[1] if process.poll() is not None else "")
        window = window[-1]
        print(f"  the view has {self.wait(self.colours)} colours")
        xdotool("windowfocus", window, "key", "n")  # the next seed
        time.sleep(3)
        xdotool("windowfocus", window, "key", "ctrl+s")
        time.sleep(3)
        xdotool("windowfocus", window, "key", "Return")  # overwrite a file of another session
        self.wait(lambda: json.loads((self.folder / "sand.json").read_text())["seed"] == 6)
        ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).save(SCREENSHOT)
        xdotool("windowfocus", window, "key", "ctrl+q")
        _, stderr = process.communicate(timeout=60)
        self.assertEqual((process.returncode, stderr), (0, ""))
        self.assertEqual(json.loads(json.loads(settings.read_text())["document"])["seed"], 6)

    def colours(self):
        """Returns the number of colours on the left of the screen once it shows a picture, which has hundreds."""
        values = np.asarray(ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).convert("RGB"))
        found = len(np.unique(values[:, :300].reshape(-1, 3), axis=0))
        return found if found > 200 else None


if __name__ == "__main__":
    unittest.main()
