"""Runs gabor.exe under Wine where Windows differs: names, devices, files that are read-only or in use, a full disk, and the
end of a process. GABOR_PROGRAM runs gabor.exe in Wine, GABOR_CONTROL control.exe, and GABOR_EXE is the path of gabor.exe."""

import os
import pathlib
import re
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import PROGRAM, ProgramTest, environment, gabor, start  # noqa: E402

CONTROL, EXE = os.environ["GABOR_CONTROL"], os.environ["GABOR_EXE"]
SMALL = ("--size=64x64",)
LARGE = ("--size=8000x8000", "--fractal=fbm", "--fractal.octaves=8")  # takes ten seconds or more
INTERRUPTED, CONTROL_C_EXIT = "gabor: interrupted; no half-written file was kept\n", "c000013a"


class Names(ProgramTest):
    def test_names_in_any_script(self):
        self.succeed("render", "-o", "plain.exr", *SMALL)
        plain = (self.folder / "plain.exr").read_bytes()
        (self.folder / "Ordner \u00e4").mkdir()
        for name in ("Gr\u00f6\u00dfe \u96ea \U0001f30a.exr", "Ordner \u00e4/\u0436.exr", "\u96ea" * 80 + ".exr"):
            self.succeed("render", "-o", name, *SMALL)
            self.assertEqual((self.folder / name).read_bytes(), plain, name)
            self.assertIn("mean", self.succeed("stats", name))
        self.succeed("maps", "--material=wood", "-o", "Karten \u0436", *SMALL)
        self.assertTrue((self.folder / "Karten \u0436" / "height.png").exists())
        self.assert_refused(["fehlt \u00fc \u96ea.exr"], "stats", "fehlt \u00fc \u96ea.exr")

    def test_long_paths(self):
        folder = pathlib.Path(*["a" * 100] * 4)
        (self.folder / folder).mkdir(parents=True)
        self.succeed("render", "-o", str(folder / "out.exr"), *SMALL)
        self.succeed("stats", str(folder / "out.exr"))

    def test_a_name_that_is_too_long(self):
        self.assert_refused(["cannot write"], "render", "-o", "n" * 260 + ".exr", *SMALL)

    def test_forbidden_letters(self):
        self.assert_refused(["cannot write"], "render", "-o", "a?b.exr", *SMALL)

    def test_drives_and_backslashes(self):
        self.succeed("render", "-o", f"Z:{self.folder}\\out.exr".replace("/", "\\"), *SMALL)
        self.assertEqual(list(self.files()), ["out.exr"])

    def test_the_null_device(self):
        for name in ("NUL", "nul"):
            self.succeed("render", "-o", name, *SMALL)
            self.assertEqual(self.files(), {})


class Targets(ProgramTest):
    def test_a_read_only_file_is_replaced(self):
        path = self.folder / "out.exr"
        path.write_text("older")
        path.chmod(0o444)
        self.succeed("render", "-o", "out.exr", *SMALL)
        self.assertEqual(list(self.files()), ["out.exr"])
        self.assertGreater(path.stat().st_size, 5)

    def test_a_folder(self):
        (self.folder / "folder").mkdir()
        self.assert_refused(["it is a folder"], "render", "-o", "folder", *SMALL)

    def test_a_missing_folder(self):
        self.assert_refused(["missing"], "render", "-o", "missing/out.exr", *SMALL)

    def test_a_full_disk(self):
        # In this namespace of mounts, which has Wine's server, too.
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", self.folder], capture_output=True).returncode != 0:
            self.skipTest("not allowed to mount a small disk")
        self.addCleanup(subprocess.run, ["umount", "--lazy", self.folder])
        (self.folder / "old.exr").write_text("older")
        for output in ("old.exr", "new.exr"):
            result = gabor("render", "-o", output, "--size=512x512", cwd=self.folder)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertRegex(result.stderr, rf"\Agabor: cannot write {output}: [^\n]+\n\Z")
            self.assertEqual(self.files(), {"old.exr": b"older"})

    def test_four_writers_of_one_name(self):
        self.succeed("render", "-o", "alone.exr", *SMALL)
        alone = (self.folder / "alone.exr").read_bytes()
        (self.folder / "alone.exr").unlink()
        for process in [start("render", "-o", "out.exr", *SMALL, cwd=self.folder) for _ in range(4)]:
            stdout, stderr = process.communicate(timeout=300)
            self.assertEqual((process.returncode, stderr), (0, ""))
        self.assertEqual(self.files(), {"out.exr": alone})


class End(ProgramTest):
    def control(self, event, milliseconds, *arguments):
        """Starts gabor.exe, and ends it after this time. Returns its exit status and what it printed."""
        result = subprocess.run([CONTROL, event, str(milliseconds), EXE, *arguments], cwd=self.folder, env=environment(),
                                capture_output=True, text=True, timeout=300)
        return result.stdout.split()[-1], result.stderr

    def test_interrupted(self):
        (self.folder / "old.exr").write_text("older")
        for output in ("old.exr", "new.exr"):
            status, said = self.control("c", 2500, "render", "-o", output, *LARGE)
            self.assertEqual((status, said), (CONTROL_C_EXIT, INTERRUPTED), output)
            self.assertEqual(self.files(), {"old.exr": b"older"})

    def test_interrupted_twice(self):
        status, _ = self.control("twice", 2500, "render", "-o", "new.exr", *LARGE)
        self.assertEqual(status, CONTROL_C_EXIT)
        self.assertEqual(self.files(), {})

    def test_terminated(self):
        for milliseconds in (1000, 2000, 3000):
            status, said = self.control("kill", milliseconds, "render", "-o", "new.exr", *LARGE)
            self.assertEqual((status, said), ("9", ""))
            self.assertEqual(self.files(), {})

    def test_killed(self):
        """Wine's server closes the files of a process that the system kills, as Windows does."""
        for seconds in (1, 2, 3):
            process = start("render", "-o", "new.exr", *LARGE, cwd=self.folder)
            time.sleep(seconds)
            hidden = [name for name in self.files() if re.fullmatch(r"\.new\.exr\.gabor-[0-9a-f]{8}", name)]
            process.kill()
            process.communicate(timeout=60)
            for _ in range(100):
                if not self.files():
                    break
                time.sleep(0.05)
            self.assertEqual(self.files(), {}, hidden)


if __name__ == "__main__":
    unittest.main()
