"""A viewer that is driven as a user does it: the pointer, keys and dropped files, by events of the display."""

import json
import os
import subprocess
import time

from viewer import ViewerTest

DROP_FILE = os.environ["GABOR_DROP_FILE"]


class EventsTest(ViewerTest):
    def open(self, *arguments):
        self.preset = next((name for name in arguments if name.endswith(".json")), "noise.json")
        self.process = self.start(*arguments)
        self.addCleanup(self.process.kill)
        self.window = self.wait_for(self.find_window)
        self.xdotool("windowfocus", "--sync", self.window)
        self.xdotool("mousemove", "--window", self.window, 200, 200)
        self.wait_for(self.answers)
        if self.preset not in arguments:
            (self.folder / self.preset).unlink()

    def answers(self):
        """Whether the viewer takes keys already: it saves the preset."""
        self.keys("ctrl+s", "Return")
        return b'"viewer"' in (self.read(self.preset) or b"")

    def find_window(self):
        found = subprocess.run(["xdotool", "search", "--all", "--onlyvisible", "--pid", str(self.process.pid),
                                "--name", "^Gabor noise$"],
                               env=self.environment(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return found.stdout.strip()

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment(), check=True, stdout=subprocess.PIPE)

    def keys(self, *names):
        """As a hand presses them."""
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
        self.keys("ctrl+q", "d") # where it asks: without saving
        self.finish(self.process)

    def assert_goes_on(self):
        """A viewer that was asked to close and did not still saves."""
        self.saved("noise.json")
        (self.folder / "noise.json").unlink()

    def saved(self, name="noise.json"):
        """What Ctrl S writes now."""
        (self.folder / name).unlink(missing_ok=True)
        self.keys("ctrl+s")
        return json.loads(self.wait_for(lambda: self.read(name)))

    def drop(self, name):
        subprocess.run([DROP_FILE, self.window, self.folder / name], env=self.environment(), check=True, timeout=60)

    def read(self, name):
        path = self.folder / name
        return path.read_bytes() if path.exists() else None

    def assert_unchanged(self, name, content):
        time.sleep(0.5)
        self.assertEqual(self.read(name), content, name)
