"""Tests the pointer, keys and dropped files, and checks that no change is ever lost."""

import json
import pathlib
import signal
import time
import unittest

from events import EventsTest
from outputs import LANDSCAPE

WINDOW = "--window", "640x480"


class Events(EventsTest):
    def remembered(self):
        return json.loads((self.folder / "config/gabor-noise/viewer.json").read_text())

    def test_pointer_and_keys(self):
        self.open(*WINDOW, self.preset("plain.json", frequency=3))
        self.assertEqual(self.state["font"], 14)
        first = self.document["viewer"]["camera"]
        self.xdotool("mousedown", 1)
        for x in range(100, 200, 20):
            self.point(x, 220)
        self.xdotool("mouseup", 1)
        self.frames(2)
        self.assertNotEqual(self.document["viewer"]["camera"], first)
        self.turn_wheel(4, 4, 4, 5, 4) # zooms the view, not the picture
        self.assertAlmostEqual(self.document["viewer"]["camera"]["zoom"], 1.15**3)
        self.assertEqual(self.document["scale"], 32)
        self.keys("Home")
        self.assertEqual(self.document["viewer"]["camera"], first)
        before = self.state["keys"]
        # Keys arrive faster than frames. GLFW merges two presses of a key within a millisecond, and takes two in a row for a held key.
        for chord in ("n", "ctrl+z", "n", "f", "n", "ctrl+s"):
            self.xdotool("key", "--delay", 0, chord)
        self.wait_for(lambda state: state["keys"] == before + 6)
        self.keys("Return") # replaces the file
        saved = json.loads(self.read("plain.json"))
        self.assertEqual((saved["seed"], saved["filter"]), (2, True))
        self.keys("F11")
        self.wait_for(lambda state: state["size"] == [1600, 1000])
        self.keys("F11")
        self.wait_for(lambda state: state["size"] == [640, 480])
        self.resize(600, 400)
        self.xdotool("windowunmap", "--sync", self.window)
        self.frames(3)
        self.xdotool("windowmap", "--sync", self.window)
        self.xdotool("windowfocus", "--sync", self.window)
        self.keys("3", "c", "F1", "F1", "Tab", "space", "space", "ctrl+y")
        self.assertEqual((self.document["viewer"]["output"], self.document["viewer"]["colours"]), ("phase", "viridis"))
        self.close()
        placement = self.remembered()["placement"]
        self.assertEqual((placement["width"], placement["height"]), (600, 400))

    def test_no_click_is_lost_in_a_long_frame(self):
        self.open(*WINDOW, self.preset("plain.json", frequency=3))
        at = "mousemove", "--window", self.window
        first = self.document["viewer"]["camera"]
        with self.long_frame():
            self.xdotool(*at, 100, 200, "mousedown", 1, *at, 164, 232, "mouseup", 1, *at, 300, 100)
        moved = self.document["viewer"]["camera"]
        for axis, pixels in (("x", 64), ("y", 32)):
            self.assertAlmostEqual(sum(first[axis]) - sum(moved[axis]), pixels / 32, delta=0.01)
        with self.long_frame(): # a double click
            self.xdotool(*at, 90, 90, "click", 1, "click", 1, *at, 300, 100)
        self.assertEqual(self.document["viewer"]["camera"], first)
        self.rest()
        presets = self.middle("Materials and presets")
        with self.long_frame(): # two clicks at different points
            self.xdotool(*at, 160, 60, "click", 1, *at, *presets, "click", 1, *at, 100, 100)
        self.assertTrue(self.state["gallery"])
        pine = self.middle("pine")
        with self.long_frame(): # a click on a preset, and a key
            self.xdotool(*at, *pine, "mousedown", 1, "mouseup", 1, *at, 20, 300, "key", "n")
        self.assertEqual((self.document["material"], self.document["seed"]), ("wood", 3)) # pine has seed 2; N adds 1
        self.close()

    def test_changes_are_not_lost_on_closing(self):
        self.open(*WINDOW, "wood")
        self.keys("n", "3", "ctrl+q", "Escape")
        self.assertIsNone(self.state["question"])
        self.keys("n", "ctrl+q", "d")
        self.end()
        self.assertIsNone(self.read("wood.json"))
        self.open(*WINDOW) # the session comes back
        self.assertEqual(self.document["viewer"]["look"], "height")
        self.keys("n", "ctrl+q", "Return") # the viewer asks whether to save, Return says yes, and the viewer asks for a name
        self.assertIsNotNone(self.state["dialog"])
        self.keys("Escape")
        self.frames(3)
        self.assertEqual((self.state["dialog"], self.state["question"]), (None, None))
        self.keys("ctrl+q", "Return")
        self.type("oak")
        self.keys("Return")
        self.end()
        last = json.loads(self.read("oak.json"))
        self.assertEqual((last["seed"], last["viewer"]["look"]), (3, "height"))
        self.gabor("render", "--like", "oak.json", "--size", "16x16", "-o", "again.exr")
        self.assertEqual(self.remembered()["recent"], [str(self.folder / "oak.json")])
        self.open(*WINDOW) # the session remembers the file too
        self.keys("n", "ctrl+s")
        self.assertIn("oak.json", self.state["question"])
        self.keys("Escape", "ctrl+q", "d")
        self.end()

    def test_the_first_save_asks_for_a_name_and_says_where_it_saved(self):
        self.open(*WINDOW, "wood")
        (self.folder / "wood").mkdir() # as from an export of maps
        self.command("open wood")
        self.keys("ctrl+s")
        self.type("dark oak")
        self.keys("Return")
        self.assertEqual(self.state["message"], f"saved {self.folder / 'dark oak.json'}")
        self.keys("n", "ctrl+s") # now the document has a file
        self.assertIsNone(self.state["dialog"])
        self.assertEqual(json.loads(self.read("dark oak.json"))["seed"], 1)
        self.assertIsNone(self.read("wood.json"))
        self.close()

    def test_text_typed_during_a_long_frame_stays_in_its_field(self):
        self.open(*WINDOW, "walnut")
        at = "mousemove", "--window", self.window

        def typed(text):
            return "key", "ctrl+a", "type", "--delay", 0, text

        fields = [self.beside(f"{wood} colour", 0.2) for wood in ("earlywood", "latewood")]
        with self.long_frame(): # two colours, one after the other, by clicks
            for field, colour in zip(fields, ("#445566", "#778899")):
                self.xdotool(*at, *field, "click", 1)
                self.xdotool(*typed(colour))
        self.frames(24)
        self.assertEqual(self.colours(), ["#445566", "#778899"])
        with self.long_frame(): # and by Tab, then the slider below them
            self.xdotool(*at, *fields[0], "click", 1)
            for text in ("#A1B2C3", "#D4E5F6", "21"):
                self.xdotool(*typed(text))
                self.xdotool("key", "Tab")
        self.frames(24)
        self.keys("Return") # leaves the last field
        self.assertEqual((self.colours(), self.document["wood.rings"]), (["#a1b2c3", "#d4e5f6"], 21))
        self.close()

    def colours(self):
        """Returns the colours of wood in sRGB."""
        return ["#" + "".join(f"{round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055)):02x}" for c in
                              self.document[f"wood.{ring}wood_colour"]) for ring in ("early", "late")]

    def test_an_export_is_not_lost_on_closing(self):
        for answer, size, complete in (("e", 16384, False), ("Return", 1500, True)):
            self.open(*WINDOW, self.preset("body.json", width=size, height=size, view="sphere", frequency=2))
            self.keys("ctrl+e", "Return", "ctrl+q")
            self.assertTrue(complete or self.state["question"])
            self.keys(answer)
            self.end()
            self.assertEqual(self.read("body.exr") is not None, complete, answer)

    def test_files_of_other_programs_are_never_lost(self):
        self.gabor("render", "--size", "32x32", "--frequency", 7, "-o", "painted.exr")
        picture = self.read("painted.exr")
        self.open(*WINDOW, self.preset("plain.json"))
        self.drop("painted.exr")
        self.keys("ctrl+s", "Return") # an EXR is not where presets are saved
        self.assertEqual(json.loads(self.read("painted.json"))["frequency"], 7)
        self.assertEqual(self.read("painted.exr"), picture)

        own = b'{"frequency": 3, "width": 64, "height": 64}'
        (self.folder / "mine.json").write_bytes(own)
        (self.folder / "mine.exr").write_bytes(b"a picture")
        self.drop("mine.json")
        self.keys("ctrl+s", "Escape", "ctrl+s", "n", "ctrl+s") # while the question is open, other keys do nothing
        self.assertIn("mine.json", self.state["question"])
        self.assertEqual(self.read("mine.json"), own)
        self.keys("Return")
        saved = json.loads(self.read("mine.json"))
        self.assertEqual((saved["frequency"], saved["seed"]), (3, 0))
        self.keys("n", "ctrl+s") # from now on, the session may replace the file
        self.assertEqual(json.loads(self.read("mine.json"))["seed"], 1)
        (self.folder / "mine.json").write_bytes(own) # until another program changes the file
        self.keys("ctrl+s")
        self.assertEqual(self.read("mine.json"), own)
        self.keys("Escape", "ctrl+e", "Return")
        self.assertIn("mine.exr? This session", self.state["question"])
        self.assertEqual(self.read("mine.exr"), b"a picture")
        self.keys("Escape", "ctrl+e")
        self.assertIn("mine.exr, mine.png", self.state["question"]) # what it writes, before it asks whether to replace it
        self.keys("Return", "Return")
        self.exported()
        first = self.read("mine.exr")
        self.assertGreater(len(first), 64 * 64 * 4)
        self.assertIsNotNone(self.read("mine.png"))
        self.keys("n", "ctrl+e", "Return")
        self.exported()
        self.assertNotEqual(self.read("mine.exr"), first)
        self.close()

    def test_after_undo_saving_writes_to_the_documents_own_file(self):
        for name, frequency in (("one.json", 3), ("two.json", 5)):
            self.preset(name, frequency=frequency, width=64, height=64)
        self.open(*WINDOW)
        for name in ("one.json", "two.json"):
            self.drop(name)
            self.keys("n", "ctrl+s", "Return") # Return confirms replacing a file that the session did not write
        two = self.read("two.json")
        self.keys("n", "ctrl+z", "ctrl+z", "ctrl+z")
        self.assertEqual(pathlib.Path(self.state["path"]).name, "one.json")
        self.keys("n", "ctrl+s") # without a question
        one = json.loads(self.read("one.json"))
        self.assertEqual((one["frequency"], one["seed"]), (3, 2))
        self.assertEqual(self.read("two.json"), two)
        self.keys("ctrl+z", "ctrl+z", "ctrl+z", "ctrl+s", "Return") # back to before any file was opened
        self.assertEqual(json.loads(self.read("desert.json"))["material"], "sand") # the material shown on first start
        self.close()

    def test_a_session_that_was_killed_is_offered_again(self):
        (self.folder / "mine.json").write_text('{"frequency": 3}')
        first = [self.preset("plain.json")]
        for number, how in enumerate((signal.SIGKILL, signal.SIGTERM), start=1):
            self.open(*WINDOW, *first)
            first = [] # from now on, the session comes back
            self.keys("n")
            if how == signal.SIGKILL: # the change is saved within seconds
                self.wait_for(lambda state: (self.folder / "config/gabor-noise/viewer.json").exists() and
                              '"seed\\": 1' in (self.folder / "config/gabor-noise/viewer.json").read_text())
            self.process.send_signal(how)
            self.end(-how)
            self.open(*WINDOW, *(["mine.json"] if how == signal.SIGTERM else []))
            self.assertIn("ended before", self.state["question"])
            self.keys("Return")
            self.assertEqual((self.document["seed"], self.document["frequency"]), (number, 4))
            self.keys("ctrl+q")
            self.assertIn("Save the changes", self.state["question"]) # they are still unsaved
            self.keys("d")
            self.end()
        self.open(*WINDOW)
        self.assertIsNone(self.state["question"])
        self.close()

    def test_time_plays_in_a_loop_or_at_sea_on_and_on(self):
        for view, name, rate, first in (("flat", "evolution", 1 / 8, 0.9), ("ocean", "seconds", 1, 5)): # a period takes 8 seconds
            self.open(*WINDOW, self.preset(f"{view}.json", view=view, width=64, height=64, **{name: first}))
            self.keys("space")
            start, before = time.monotonic(), self.document[name]
            self.wait_for(lambda state: (state["document"][name] - before) % 1e3 % (1 if view == "flat" else 1e3) > 2 * rate)
            moved = self.document[name] - before
            self.assertAlmostEqual((moved % 1 if view == "flat" else moved) / rate / (time.monotonic() - start), 1, delta=0.5)
            self.assertTrue(view == "ocean" or self.document[name] < 1)
            self.keys("space")
            still = self.document[name]
            self.frames(3)
            self.assertEqual(self.document[name], still)
            self.keys("ctrl+q") # without a question: playing changes nothing
            self.end()

    def test_the_mouse_turns_and_zooms_a_landscape(self):
        self.open(*WINDOW, self.preset("hills.json", **LANDSCAPE))
        before = self.document
        self.point(300, 300)
        self.xdotool("mousedown", 1)
        self.frames(2)
        self.point(350, 280)
        self.frames(2)
        self.xdotool("mouseup", 1)
        self.wait_for(lambda state: state["document"]["yaw"] != before["yaw"])
        self.assertAlmostEqual(self.document["yaw"] - before["yaw"], 20, delta=3)
        self.assertAlmostEqual(self.document["pitch"] - before["pitch"], -8, delta=3)
        self.turn_wheel(4)
        self.assertAlmostEqual(self.document["zoom"], 1.15, delta=0.01)
        self.keys("Home")
        self.assertEqual((self.document["yaw"], self.document["zoom"]), (215, 1))
        self.wait_for(lambda state: state["fine"])
        self.point(300, 400)
        self.wait_for(lambda state: "height" in state["reading"])
        self.point(300, 20) # the sky has no height
        self.wait_for(lambda state: state["reading"] == "")
        self.keys("n")
        self.assertEqual(self.document["seed"], before["seed"] + 1)
        self.keys("ctrl+z")
        self.assertEqual(self.document["seed"], before["seed"])
        self.close()


class LargeScreen(EventsTest):
    screen_size = "2560x1440"

    def test_text_grows_with_the_screen(self):
        self.open(*WINDOW, "wood")
        self.assertEqual(self.state["font"], round(14 * 1440 / 1080)) # 14 on smaller screens
        self.close()


if __name__ == "__main__":
    unittest.main()
