"""Runs the program under test, `GABOR_PROGRAM`, and checks its exit status and messages."""

import glob
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy as np

from exr import Exr

PROGRAM = os.environ["GABOR_PROGRAM"]
WINDOWS = "GABOR_WINDOWS" in os.environ # gabor.exe runs in Wine: tests/windows has what differs
NAME = pathlib.Path(PROGRAM).stem
LAVAPIPE = next(iter(glob.glob("/usr/share/vulkan/icd.d/lvp_icd*.json")), None) # Mesa's driver, if installed


def environment(**changes):
    """Returns this process's environment with these changes; None removes a variable. Vulkan's validation layers are on unless
    GABOR_VALIDATION says otherwise, and any message from them is a failure."""
    merged = {"GABOR_VALIDATION": "1", **os.environ, **changes}
    return {name: value for name, value in merged.items() if value is not None}


def gabor(*arguments, cwd, command=(PROGRAM,), env={}, stdout=subprocess.PIPE):
    """Runs the program to completion. command: the program, or a wrapper around it; env: changes to its environment."""
    return subprocess.run([*command, *arguments], cwd=cwd, env=environment(**env), stdout=stdout,
                          stderr=subprocess.PIPE, text=True, errors="replace", timeout=900)


def start(*arguments, cwd, command=(PROGRAM,)):
    return subprocess.Popen([*command, *arguments], cwd=cwd, env=environment(), stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


class ProgramTest(unittest.TestCase):
    """A test that runs the program in an empty folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gabor-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def files(self):
        """Returns the contents of the folder: the bytes of each file, and None for each folder."""
        return {str(path.relative_to(self.folder)): None if path.is_dir() else path.read_bytes()
                for path in self.folder.rglob("*")}

    def succeed(self, *arguments, **options):
        """Runs the program, which must succeed and print nothing on stderr; returns its stdout."""
        result = gabor(*arguments, cwd=self.folder, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""), f"{NAME} {arguments}")
        return result.stdout

    def assert_fails(self, status, words, *arguments, **options):
        """Runs the program, which must exit with this status, print one line on stderr that contains these words and
        nothing on stdout, and leave the folder as it was."""
        before = self.files()
        self.assert_failed(status, words, gabor(*arguments, cwd=self.folder, **options), before)

    def assert_failed(self, status, words, result, before):
        """Checks the result of a run as `assert_fails` does. before: the contents of the folder before the run."""
        case = f"{NAME} {result.args[1:]}: {result.stderr!r}"
        self.assertEqual(result.returncode, status, case)
        self.assertRegex(result.stderr, rf"\A{NAME}: [^\n]+\n\Z", case)
        for word in words:
            self.assertIn(word, result.stderr, case)
        self.assertFalse(result.stdout, case)
        self.assertEqual(self.files(), before, case)

    def assert_refused(self, words, *arguments, **options):
        self.assert_fails(2, words, *arguments, **options)

    def assert_plausible(self, values, truth, name):
        """Checks that the mean of a picture's values, without NaN, lies within 1.5 times its 95 % interval around the true
        mean. The interval comes from the means of 4 x 4 parts of the picture."""
        parts = [np.nanmean(part) for rows in np.array_split(values, 4) for part in np.array_split(rows, 4, axis=1)]
        half = 2.13 * np.std(parts, ddof=1) / 4
        self.assertLess(abs(np.mean(parts) - truth), 1.5 * half, f"{name}: {truth}, {np.mean(parts)} +- {half}")

    def assert_numbers(self, path, texts):
        """Checks that the numbers in each text equal those in the corresponding line of the file, within 0.1 %. With
        GABOR_GOLDEN=write, writes the file and fails."""
        found = [re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text) for text in texts]
        if os.environ.get("GABOR_GOLDEN") == "write":
            path.write_text("".join(" ".join(f"{float(number):.6g}" for number in numbers) + "\n" for numbers in found))
            self.fail(f"wrote {path}: review what changed, then run the test without GABOR_GOLDEN")
        for numbers, line in zip(found, path.read_text().splitlines(), strict=True):
            np.testing.assert_allclose(np.array(numbers, float), np.array(line.split(), float), rtol=1e-3, atol=1e-5)


class RenderTest(ProgramTest):
    def render(self, *flags, output="out.exr", **options):
        """Renders with these flags and with --name=value for each option; returns the file."""
        options = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
        self.succeed("render", "-o", output, *flags, *options)
        return Exr(self.folder / output)

    def assert_same_bits(self, a, b):
        self.assertEqual((a.shape, a.tobytes()), (b.shape, b.tobytes()))
