"""The viewer driven as a user does it: the pointer, keys and dropped files, by events of the display."""

import json
import os
import subprocess
import time
import unittest

from viewer import ViewerTest

DROP_FILE = os.environ["GABOR_DROP_FILE"]


class Events(ViewerTest):
    def open(self, *arguments):
        self.process = self.start(*arguments)
        self.addCleanup(self.process.kill)
        self.window = self.wait_for(self.find_window)
        self.xdotool("windowfocus", "--sync", self.window)
        self.xdotool("mousemove", "--window", self.window, 200, 200)
        self.wait_for(self.answers)
        (self.folder / "noise.json").unlink()

    def answers(self):
        """Whether the viewer takes keys already: it saves the preset."""
        self.keys("ctrl+s")
        return self.read("noise.json")

    def find_window(self):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Gabor noise$"],
                               env=self.environment(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return found.stdout.strip()

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment(), check=True, stdout=subprocess.PIPE)

    def keys(self, *names):
        for name in names:
            self.xdotool("key", name)
            time.sleep(0.3)

    def wait_for(self, condition):
        deadline = time.monotonic() + 60
        while not (result := condition()):
            if self.process.poll() is not None:
                self.fail(f"the viewer ended: {self.process.communicate()}")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        return result

    def close(self):
        self.keys("ctrl+q")
        self.finish(self.process)

    def drop(self, name):
        subprocess.run([DROP_FILE, self.window, self.folder / name], env=self.environment(), check=True, timeout=60)

    def read(self, name):
        path = self.folder / name
        return path.read_bytes() if path.exists() else None

    def assert_unchanged(self, name, content):
        time.sleep(1)
        self.assertEqual(self.read(name), content, name)

    def test_pointer_and_keys(self):
        self.open("--window", "1000x700")
        self.xdotool("mousedown", 1)
        for x in range(200, 400, 20):
            self.xdotool("mousemove", "--window", self.window, x, 220)
            time.sleep(0.02)
        self.xdotool("mouseup", 1)
        for button in (4, 4, 5):
            self.xdotool("click", button)
        self.xdotool("windowsize", "--sync", self.window, 900, 600)
        self.xdotool("windowunmap", "--sync", self.window)
        time.sleep(0.5)
        self.xdotool("windowmap", "--sync", self.window)
        time.sleep(0.5)
        self.xdotool("windowfocus", "--sync", self.window)
        self.keys("3", "Tab", "c", "F1", "F1")
        self.close()
        remembered = json.loads((self.folder / "config/gabor-noise/viewer.json").read_text())
        self.assertEqual((remembered["width"], remembered["height"]), (900, 600))

    def test_quick_chords_are_not_lost(self):
        self.open("--window", "1000x700")
        for chord in ("n", "n", "ctrl+z", "n", "ctrl+s"): # 1, 2, 1, 2
            self.xdotool("key", "--delay", 0, chord)
            if chord == "n":
                time.sleep(1) # each its own step of undo
        # What `answers` sent more than once may be saved before.
        self.wait_for(lambda: json.loads(self.read("noise.json") or b"{}").get("seed") == 2)
        self.close()

    def test_a_dropped_picture_is_never_overwritten(self):
        self.gabor("render", "--size", "32x32", "--frequency", 7, "-o", "painted.exr")
        picture = self.read("painted.exr")
        self.open("--window", "1000x700")
        self.drop("painted.exr")
        self.keys("ctrl+s")
        self.wait_for(lambda: self.read("painted.json"))
        self.assertEqual(json.loads(self.read("painted.json"))["frequency"], 7)
        self.assert_unchanged("painted.exr", picture)
        self.close()
        self.assertEqual(self.read("painted.exr"), picture)

    def test_files_of_others_are_overwritten_after_a_question(self):
        own = b'{"frequency": 3, "width": 64, "height": 64}'
        (self.folder / "mine.json").write_bytes(own)
        (self.folder / "noise.exr").write_bytes(b"a picture")
        self.open("--window", "1000x700")
        self.drop("mine.json")
        self.keys("ctrl+s")
        self.assert_unchanged("mine.json", own)
        self.keys("Escape", "ctrl+s", "n", "ctrl+s") # while it is asked no key does anything else
        self.assert_unchanged("mine.json", own)
        self.keys("Return")
        self.wait_for(lambda: self.read("mine.json") != own)
        self.assertEqual(json.loads(self.read("mine.json")).items() & {"frequency": 3, "seed": 1}.items(),
                         {("frequency", 3)})
        self.keys("n", "ctrl+s") # now it is the session's own
        self.wait_for(lambda: json.loads(self.read("mine.json")).get("seed") == 1)
        (self.folder / "mine.json").write_bytes(own) # until another program writes it
        self.keys("ctrl+s")
        self.assert_unchanged("mine.json", own)
        self.keys("Escape", "ctrl+e")
        self.assert_unchanged("noise.exr", b"a picture")
        self.keys("Escape", "ctrl+e", "Return")
        self.wait_for(lambda: self.read("noise.png"))
        first = self.read("noise.exr")
        self.assertGreater(len(first), 64 * 64 * 4)
        self.keys("n", "ctrl+e")
        self.wait_for(lambda: self.read("noise.exr") != first)
        self.close()


if __name__ == "__main__":
    unittest.main()
