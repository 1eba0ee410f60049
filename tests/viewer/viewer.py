"""Runs gabor-viewer under Xvfb with the validation layers; any message of theirs is a failure."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli")) # for the tests that read pictures

VIEWER = os.environ["GABOR_VIEWER"]
SCRIPTED_VIEWER = os.environ["GABOR_SCRIPTED_VIEWER"] # the same, driven by a script
PROGRAM = os.environ["GABOR_PROGRAM"]
SHADERS = pathlib.Path(os.environ["GABOR_SHADERS"])


class ViewerTest(unittest.TestCase):
    """A display, and an empty folder in which the programs run."""

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
        merged = {"GABOR_VALIDATION": "1", **os.environ, "DISPLAY": self.display, "XDG_CURRENT_DESKTOP": None,
                  "XDG_CONFIG_HOME": str(self.folder / "config"), **changes}
        return {name: value for name, value in merged.items() if value is not None}

    def start(self, *arguments, program=VIEWER, **changes):
        return subprocess.Popen([program, *map(str, arguments)], cwd=self.folder, env=self.environment(**changes),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def start_script(self, text, *arguments):
        """A viewer without saved settings, so that a script always finds the same window."""
        shutil.rmtree(self.folder / "config", ignore_errors=True)
        script = self.folder / "script.txt"
        script.write_text(text)
        return self.start(script, *arguments, program=SCRIPTED_VIEWER)

    def finish(self, process, timeout=300):
        try:
            out, err = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            self.fail(f"still running after {timeout} s: {process.communicate()}")
        self.assertEqual((process.returncode, out, err), (0, "", ""))

    def run_viewer(self, *arguments, timeout=300, **changes):
        self.finish(self.start(*arguments, **changes), timeout)

    def play(self, text, *arguments, timeout=300):
        self.finish(self.start_script(text, *arguments), timeout)

    def gabor(self, *arguments):
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=self.environment(),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)

    def assert_fails(self, status, words, *arguments, program=VIEWER, **changes):
        process = self.start(*arguments, program=program, **changes)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (status, ""), err)
        self.assertRegex(err, rf"\A{pathlib.Path(program).name}: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, err)
