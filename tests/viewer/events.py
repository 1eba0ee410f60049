"""Drives a viewer as a user would, with display events for pointer, keys and dropped files. After each event it waits for the
viewer's report, never for a fixed time. Commands on the viewer's stdin do the rest."""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import threading
import time

import numpy as np

from viewer import ViewerTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from exr import Exr
from png import read_colour_png

DRIVEN_VIEWER = os.environ["GABOR_DRIVEN_VIEWER"]
DROP_FILE = os.environ["GABOR_DROP_FILE"]
COMMANDS = "set", "resize", "open", "save", "copy", "export", "screenshot", "window", "quit" # the commands of driven_viewer.cpp
PATIENCE = 120 # seconds; a longer wait is a failure, even on a slow machine


class EventsTest(ViewerTest):
    shift = 0, 0 # see origin()

    def open(self, *arguments, **changes):
        self.shift = 0, 0
        self.process = self.start(*arguments, program=DRIVEN_VIEWER, **changes)
        self.addCleanup(self.process.kill)
        self.said = threading.Condition()
        self.state = None
        self.ended = False
        self.listener = threading.Thread(target=self.listen, args=(self.process,), daemon=True)
        self.listener.start()
        self.wait_for(lambda state: True)
        self.window = self.state["window"]
        self.xdotool("windowfocus", "--sync", self.window)
        self.point(200, 200)

    def listen(self, process):
        for line in process.stdout:
            with self.said:
                self.state = json.loads(line)
                self.said.notify()
        with self.said:
            self.ended = True
            self.said.notify()

    def wait_for(self, condition, or_end=False, timeout=PATIENCE):
        """Waits until the viewer's report meets a condition, or, with `or_end`, until it exits."""
        deadline = time.monotonic() + timeout
        with self.said:
            while self.ended or self.state is None or not condition(self.state):
                if self.ended:
                    if or_end:
                        return
                    self.fail(f"the viewer ended: {self.process.wait()}, {self.process.stderr.read()}")
                if not self.said.wait(deadline - time.monotonic()):
                    self.fail(f"timed out; the viewer says {self.state}")

    def command(self, line, timeout=PATIENCE):
        """Sends a command and waits until the viewer has obeyed it."""
        done = self.state["commands"]
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        self.wait_for(lambda state: state["commands"] > done, or_end=line == "quit", timeout=timeout)

    def play(self, script, *arguments, timeout=PATIENCE):
        """Plays a script in a viewer without saved settings, so that it always finds the same window. A line is a method of
        this class with its arguments, or a command, which may take `timeout` seconds."""
        shutil.rmtree(self.folder / "config", ignore_errors=True)
        self.open(*arguments)
        for line in filter(None, map(str.strip, script.splitlines())):
            name, *words = line.split()
            if name in COMMANDS:
                self.command(line, timeout)
            else:
                getattr(self, name)(*(int(word) if word.isdigit() else word for word in words))
        self.command("quit")
        self.end()

    def preset(self, name, **parameters):
        """Writes a preset; returns its name."""
        (self.folder / name).write_text(json.dumps(parameters))
        return name

    def compare_with_render(self, cases, more="", inside=False):
        """Opens presets in one viewer and checks that its pictures are what gabor render draws; with `inside`, compares only the body.
        cases: the parameters of each preset, by name. more: the rest of the viewer's script. Returns the pictures by name."""
        for name, parameters in cases.items():
            self.preset(f"{name}.json", **parameters)
        script = ["keys p", *(f"open {name}.json\nscreenshot {name}.png" for name in cases)] # the gallery hides the view
        self.play("\n".join(script) + more, self.preset("plain.json"), "--window", "480x320")
        pictures = {}
        for name in cases:
            self.gabor("render", "--like", f"{name}.json", "--png", "expected.png", "-o", "expected.exr")
            pictures[name], expected = (read_colour_png(self.folder / f"{file}.png") for file in (name, "expected"))
            seen = Exr(self.folder / "expected.exr").channels["A"] == 1 if inside else np.ones(expected.shape[:2], bool)
            off = np.abs(pictures[name] - expected).max(axis=2)[seen]
            self.assertGreater(seen.mean(), 0.1)
            self.assertLessEqual(np.quantile(off, 0.995), 1, f"{name}: {off.max()}")
            self.assertGreater(pictures[name][seen].std(axis=0).max(), 10, name)
        return pictures

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment(), check=True, stdout=subprocess.PIPE)

    def keys(self, *names):
        """Presses keys, each after the viewer has seen the one before."""
        for name in names:
            before = self.state["keys"]
            self.xdotool("key", name)
            self.wait_for(lambda state: state["keys"] > before, or_end=True)

    def origin(self, label):
        """Counts pixels from a label's upper left corner from now on."""
        self.shift = 0, 0
        left, top, _, _ = self.place(label)
        self.shift = round(left), round(top)

    def point(self, x, y):
        x, y = x + self.shift[0], y + self.shift[1]
        self.xdotool("mousemove", "--window", self.window, x, y)
        self.wait_for(lambda state: state["pointer"] == [x, y])

    def drag(self, x, y, to_x, to_y):
        self.point(x, y)
        self.xdotool("mousedown", 1)
        self.frames(2)
        for step in (0.2, 0.4, 0.6, 0.8, 1):
            self.point(round(x + step * (to_x - x)), round(y + step * (to_y - y)))
        self.xdotool("mouseup", 1)
        self.frames(2)

    @contextlib.contextmanager
    def long_frame(self):
        """Stops the viewer, so that all events sent within this context reach it at once."""
        self.process.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, self.process.pid, os.WSTOPPED | os.WNOWAIT)
        yield
        self.process.send_signal(signal.SIGCONT)
        self.frames(12) # a frame may handle only some of the events

    def click(self, x, y):
        self.point(x, y)
        before = self.state["clicks"]
        self.xdotool("mousedown", 1)
        self.frames(2) # about as long as a person holds the button
        self.xdotool("mouseup", 1)
        self.wait_for(lambda state: state["clicks"] > before)

    def place(self, label):
        """Returns left, top, right and bottom of a label in the window."""
        self.frames(3)
        self.command(f"find {label}")
        self.assertIsNotNone(self.state["found"], f"the window shows no '{label}'")
        x, y = self.shift
        left, top, right, bottom = self.state["found"]
        return left - x, top - y, right - x, bottom - y

    def middle(self, label):
        left, top, right, bottom = self.place(label)
        return round((left + right) / 2), round((top + bottom) / 2)

    def press(self, label):
        """Presses the button, check box, picture or entry of a list with this label."""
        self.click(*self.middle(label))

    def beside(self, label, share=0.5):
        """Returns the point at this share of the width of the control whose label stands to its right: a slider, list or field."""
        left, top, _, bottom = self.place(label)
        begin = self.state["panel"] - self.shift[0]
        return round(begin + share * (left - 6 - begin)), round((top + bottom) / 2)

    def choose(self, label, entry):
        """Opens a list, and chooses an entry."""
        self.click(*self.beside(label))
        self.press(entry)

    def reset(self, label):
        """Double-clicks a slider."""
        self.double_click(*self.beside(label, 0.3))

    def double_click(self, x, y):
        with self.long_frame(): # so that slow frames cannot separate the clicks
            self.xdotool("mousemove", "--window", self.window, x + self.shift[0], y + self.shift[1], "click", 1, "click", 1)

    def resize(self, width, height):
        self.xdotool("windowsize", "--sync", self.window, width, height)
        self.wait_for(lambda state: state["size"] == [width, height])

    def turn_wheel(self, *buttons):
        for button in buttons:
            before = self.state["wheel"]
            self.xdotool("click", button)
            self.wait_for(lambda state: state["wheel"] != before)

    def frames(self, count):
        last = self.state["frames"] + count
        self.wait_for(lambda state: state["frames"] >= last)

    def pause(self, seconds):
        """Lets time pass without frames."""
        self.process.send_signal(signal.SIGSTOP)
        time.sleep(seconds)
        self.process.send_signal(signal.SIGCONT)

    def rest(self):
        self.pause(0.4) # so that two clicks are not a double click

    def fine(self):
        self.frames(3)
        self.wait_for(lambda state: state["fine"])

    def shown(self, x, y, width, height):
        """Returns the pixels of this part of the window once the final picture is on the display."""
        self.wait_for(lambda state: state["fine"])
        self.frames(3)
        return self.screen(x, y, width, height)

    def fitted(self):
        self.frames(3)
        self.wait_for(lambda state: not state["fitting"])

    def says(self, *words):
        self.wait_for(lambda state: " ".join(words) in state["message"])

    def drop(self, name):
        subprocess.run([DROP_FILE, str(self.window), self.folder / name], env=self.environment(), check=True,
                       timeout=PATIENCE)
        self.frames(2)

    def type(self, name):
        """Types into the dialog once its text field has the focus."""
        self.frames(2)
        self.wait_for(lambda state: state["dialog"] and state["dialog"]["typed"])
        for end in range(1, len(name) + 1): # one by one, because a press before the last release may be missed
            self.xdotool("type", name[end - 1])
            self.wait_for(lambda state, typed=name[:end]: state["dialog"]["name"] == typed)
        self.frames(3) # the key press may arrive after its letter

    def screen(self, x, y, width, height):
        """Returns the RGB pixels that the display shows in this part of the window."""
        dump = (pathlib.Path(self.screen_folder.name) / "Xvfb_screen0").read_bytes()
        header = np.frombuffer(dump, ">u4", 25)
        size, columns, rows, line, colours = (int(header[i]) for i in (0, 4, 5, 12, 19))
        pixels = np.frombuffer(dump, "u1", rows * line, size + 12 * colours).reshape(rows, line // 4, 4)
        return pixels[y:y + height, x:x + width, 2::-1].astype(int)

    def exported(self):
        self.wait_for(lambda state: not state["exporting"])

    @property
    def document(self):
        return self.state["document"]

    def end(self, expected=0):
        """Waits for a viewer that was asked to quit; it must exit without any message."""
        status = self.process.wait(PATIENCE)
        self.listener.join()
        complaint = self.process.stderr.read()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            pipe.close()
        self.assertEqual((status, complaint), (expected, ""))

    def close(self):
        self.keys("ctrl+q")
        if not self.ended: # the viewer asks whether to save
            self.keys("d")
        self.end()

    def saved(self, name="noise.json"):
        """Presses Ctrl+S, accepts the name that the viewer offers, if it does, and returns the JSON that this writes."""
        (self.folder / name).unlink(missing_ok=True)
        self.keys("ctrl+s")
        self.frames(3)
        if self.state["dialog"]:
            self.keys("Return")
        return json.loads(self.read(name))

    def read(self, name):
        path = self.folder / name
        return path.read_bytes() if path.exists() else None
