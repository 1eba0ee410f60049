"""Runs gabor-viewer under Xvfb with the validation layers; any message from them is a failure."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli")) # for the tests that read pictures

VIEWER = os.environ["GABOR_VIEWER"]
PROGRAM = os.environ["GABOR_PROGRAM"]
SHADERS = pathlib.Path(os.environ["GABOR_SHADERS"])


class ViewerTest(unittest.TestCase):
    """A test with a display of its own and an empty folder in which programs run."""

    screen_size = "1600x1000"

    @classmethod
    def setUpClass(cls):
        reading, writing = os.pipe()
        cls.screen_folder = tempfile.TemporaryDirectory(prefix="gabor-screen-")
        cls.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{cls.screen_size}x24", "-fbdir", cls.screen_folder.name,
             "-nolisten", "tcp", "-noreset"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            cls.display = ":" + pipe.readline().strip()

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()
        cls.screen_folder.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gabor-viewer-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def environment(self, **changes):
        merged = {"GABOR_VALIDATION": "1", **os.environ, "DISPLAY": self.display,
                  "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_RUNTIME_DIR": str(self.folder), **changes}
        return {name: value for name, value in merged.items() if value is not None}

    def start(self, *arguments, program=VIEWER, **changes):
        return subprocess.Popen([program, *map(str, arguments)], cwd=self.folder, env=self.environment(**changes),
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def gabor(self, *arguments):
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=self.environment(),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)

    def assert_fails(self, status, words, *arguments, **changes):
        process = self.start(*arguments, **changes)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (status, ""), err)
        self.assertRegex(err, r"\Agabor-viewer: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, err)
