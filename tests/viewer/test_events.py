"""The pointer, keys and dropped files, and that nothing is lost."""

import json
import time
import unittest

from events import EventsTest


class Events(EventsTest):
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

    def test_changes_are_not_lost_on_closing(self):
        self.open("--window", "1000x700")
        self.keys("n", "Tab", "3", "ctrl+q", "Escape")
        self.assert_goes_on()
        self.keys("n", "ctrl+q", "d")
        self.finish(self.process)
        self.assertIsNone(self.read("noise.json"))
        self.open("--window", "1000x700") # the session comes back
        self.assertEqual(self.saved()["viewer"]["output"], "phase")
        self.keys("n", "ctrl+q", "Return") # it asks, and saves
        self.finish(self.process)
        last = json.loads(self.read("noise.json"))
        self.assertEqual((last["seed"], last["viewer"]["output"]), (3, "phase"))
        self.assertEqual(last["viewer"]["compared"]["impulses"], 30)
        self.gabor("render", "--like", "noise.json", "--size", "16x16", "-o", "again.exr")
        remembered = json.loads((self.folder / "config/gabor-noise/viewer.json").read_text())
        self.assertEqual(remembered["recent"], [str(self.folder / "noise.json")])

    def test_an_export_is_not_lost_on_closing(self):
        for answer, size, complete in (("e", 16384, False), ("Return", 1500, True)):
            (self.folder / "body.json").write_text(json.dumps({"width": size, "height": size, "view": "sphere",
                                                               "frequency": 2}))
            self.open("--window", "600x400", "body.json")
            self.keys("ctrl+e", "ctrl+q")
            self.assertTrue(complete or self.process.poll() is None)
            self.keys(answer)
            self.finish(self.process)
            self.assertEqual(self.read("noise.exr") is not None, complete, answer)

    def test_the_wheel_zooms_the_view_alone(self):
        self.open("--window", "1000x700")
        for _ in range(3):
            self.xdotool("click", 4)
        self.wait_for(lambda: self.saved()["viewer"]["camera"]["zoom"] > 1.4)
        self.assertEqual(self.saved()["scale"], 32)
        self.keys("Home")
        self.assertEqual(self.saved()["viewer"]["camera"]["zoom"], 1)
        self.keys("F11", "F11")
        self.close()

    def test_quick_chords_are_not_lost(self):
        self.open("--window", "1000x700")
        for chord in ("n", "n", "ctrl+z", "n", "ctrl+s"): # 1, 2, 1, 2: each its own step of undo
            self.xdotool("key", "--delay", 0, chord)
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
