"""Checks that ten minutes of random input make the viewer print nothing and leak no memory."""

import os
import pathlib
import random
import re
import time
import unittest

from events import EventsTest

SECONDS = int(os.environ.get("GABOR_VIEWER_SECONDS", "600"))


def resident(process):
    """Returns the resident bytes of a running process."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return 1024 * int(re.search(r"VmRSS:\s*(\d+)", status)[1])


KEYS = *"cezynrvf12345", "Tab", "space", *(f"ctrl+{key}" for key in "ceznyrvf12345"), "F1", "Delete", "Escape", "Return"


class Random(EventsTest):
    def event(self, draw):
        """Returns words for xdotool that move, click, drag, scroll, resize, or press any key except the one that quits."""
        width, height = self.state["size"]
        to = "mousemove", "--window", self.window, draw.randrange(int(width)), draw.randrange(int(height))
        press = "mousedown", 1, "mousemove_relative", "--", draw.randint(-200, 200), draw.randint(-200, 200), "mouseup", 1
        size = "windowsize", self.window, draw.randint(480, 1380), draw.randint(320, 920)
        wheel = "click", draw.choice((1, 4, 5))
        key = "key", draw.choice(KEYS)
        return draw.choices((to, press, wheel, key, size), (6, 6, 4, 6, 0.1))[0]

    def test_random_input(self):
        self.open("--window", "1280x800")
        draw, start, sizes = random.Random(7), time.monotonic(), []
        while (at := time.monotonic() - start) < SECONDS:
            self.xdotool(*self.event(draw))
            if max(self.document["width"], self.document["height"]) > 2048: # exporting the largest picture would take all day
                self.command("set width 2048")
                self.command("set height 2048")
            sizes.append((at, resident(self.process)))
        self.command("quit")
        self.end()
        # Memory varies with window sizes, pipelines and files, but steady growth is a leak.
        third = [size for at, size in sizes if SECONDS / 3 < at < 2 * SECONDS / 3]
        last = [size for at, size in sizes if at >= 2 * SECONDS / 3 and at < SECONDS]
        grown = sum(last) / len(last) - sum(third) / len(third)
        print(f"resident: {sum(third) / len(third) / 2**20:.1f} MiB in the second third, "
              f"{grown / 2**20:+.1f} MiB in the last third, {max(size for _, size in sizes) / 2**20:.1f} MiB at most")
        self.assertLess(grown, 64 * 2**20)


if __name__ == "__main__":
    unittest.main()
