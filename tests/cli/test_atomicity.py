"""Checks that `gabor render`, killed or interrupted, leaves its file complete or absent."""

import os
import pathlib
import random
import re
import signal
import time
import unittest

from program import WINDOWS, ProgramTest, start

REQUEST = ("render", "-o", "out.exr", "--png", "out.png", "--size=2200x2200") # several bands
ROUNDS = int(os.environ.get("GABOR_ROUNDS", 10))
OF_EACH_SIGNAL = int(os.environ.get("GABOR_ROUNDS", 5)) # both have one handler


def can_hide_files(folder):
    """Tells whether the file system supports unnamed files. Without them, a killed program leaves a hidden file."""
    try:
        os.close(os.open(folder, os.O_TMPFILE | os.O_WRONLY))
        return True
    except OSError:
        return False


def catches(process, number):
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16) >> (number - 1) & 1


@unittest.skipIf(WINDOWS, "Windows has no signals; windows/test_files interrupts and kills gabor.exe")
class Atomicity(ProgramTest):
    complete, durations = {}, [] # the files of a complete run, and how long two take

    def setUp(self):
        super().setUp()
        self.random = random.Random(7)
        while len(self.durations) < 2: # the first run may compile shaders, which takes longer
            began = time.monotonic()
            self.succeed(*REQUEST)
            self.durations.append(time.monotonic() - began)
            self.complete.update(self.files())

    def moment(self):
        """Returns a random time during a run. Half of these times are near its end, when the files appear."""
        return self.durations[1] * self.random.choice([self.random.uniform(0, 1), self.random.uniform(0.7, 1.1)])

    def begin(self, older):
        """Starts the request over no files or, with `older`, over older ones."""
        for name in self.complete:
            (self.folder / name).unlink(missing_ok=True)
            if older:
                (self.folder / name).write_text("older")
        return start(*REQUEST, cwd=self.folder)

    def check_files(self, older):
        """Checks that each file is complete, or as `begin` left it. Returns the names of the complete files.

        A program that is killed while it replaces an older file may leave the new one, complete, under a hidden name; the next
        replacement removes it."""
        for path in list(self.folder.iterdir()):
            hidden = re.fullmatch(r"\.(.+)\.gabor-[0-9a-f]{8}", path.name)
            if older and hidden and hidden[1] in self.complete:
                self.assertEqual(path.read_bytes(), self.complete[hidden[1]], f"{path.name} is not complete")
                path.unlink()
        files = self.files()
        self.assertLessEqual(files.keys(), self.complete.keys(), "an unexpected file was left")
        for name, content in self.complete.items():
            self.assertTrue(files.get(name) in [content, b"older" if older else None], f"{name} is not complete")
        return [name for name in files if files[name] == self.complete[name]]

    def test_killed(self):
        if not can_hide_files(self.folder):
            self.skipTest("needs a file system with O_TMPFILE")
        for turn in range(ROUNDS):
            process = self.begin(older=turn % 2)
            time.sleep(self.moment())
            process.kill()
            process.communicate(timeout=60)
            self.check_files(older=turn % 2)

    def interrupt(self, number, times, turn):
        process = self.begin(older=turn % 2)
        while not catches(process, number) and process.poll() is None:
            time.sleep(0.001)
        time.sleep(self.moment())
        for _ in range(times):
            process.send_signal(number)
        _, stderr = process.communicate(timeout=60)
        return process.returncode, stderr, self.check_files(older=turn % 2)

    def check_interrupts(self, number):
        turn = ended = 0
        while turn < OF_EACH_SIGNAL or ended == 0 and turn < 10 * OF_EACH_SIGNAL:
            status, stderr, complete = self.interrupt(number, 1, turn)
            turn += 1
            if status == 0: # too late: the file was being closed, or the machine has less to do than before
                self.assertEqual((stderr, len(complete)), ("", len(self.complete)))
                self.durations[1] *= 0.9
            else:
                ended += 1
                self.assertEqual(status, -number)
                self.assertRegex(stderr, r"\Agabor: interrupted[^\n]*\n\Z")
                self.assertEqual(complete, [])
        self.assertGreater(ended, 0)

    def test_interrupted_from_the_keyboard(self):
        self.check_interrupts(signal.SIGINT)

    def test_asked_to_terminate(self):
        self.check_interrupts(signal.SIGTERM)

    def test_interrupted_before_anything_is_set_up(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            for turn in range(4):
                process = self.begin(older=turn % 2)
                time.sleep(self.random.uniform(0, self.durations[1] / 8))
                process.send_signal(number)
                process.communicate(timeout=60)
                self.assertEqual(process.returncode, -number)
                self.assertEqual(self.check_files(older=turn % 2), [])

    def test_interrupted_while_it_waits(self):
        """A program that cannot go on, here for want of a preset's text, ends by the first signal too."""
        os.mkfifo(self.folder / "never.json")
        for number in (signal.SIGINT, signal.SIGTERM):
            process = start("render", "--preset=never.json", "-o", "other.exr", cwd=self.folder)
            while not catches(process, number):
                time.sleep(0.01)
            process.send_signal(number)
            try:
                _, stderr = process.communicate(timeout=60)
            finally:
                process.kill()
            self.assertEqual(process.returncode, -number)
            self.assertEqual(stderr, "gabor: interrupted; no half-written file was kept\n")
            self.assertFalse((self.folder / "other.exr").exists())

    def test_interrupted_twice(self):
        """A second signal ends the program at once: each file is complete, still the older one, or absent."""
        for turn in range(4):
            status, _, _ = self.interrupt(signal.SIGINT, 2, turn)
            self.assertIn(status, (0, -signal.SIGINT))


if __name__ == "__main__":
    unittest.main()
