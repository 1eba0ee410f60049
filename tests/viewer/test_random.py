"""After ten minutes of random input, the viewer has printed nothing and leaked no memory."""

import os
import pathlib
import time
import unittest

from viewer import ViewerTest

SECONDS = int(os.environ.get("GABOR_VIEWER_SECONDS", "600"))


def resident(process):
    """Resident bytes, or None once the process has ended."""
    try:
        for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
            if line.startswith("VmRSS"):
                return int(line.split()[1]) * 1024
    except FileNotFoundError:
        pass
    return None


class Random(ViewerTest):
    def test_random_input(self):
        process = self.start_script(f"random 7 {SECONDS}\nwait 3\nquit\n")
        start, sizes = time.monotonic(), []
        while process.poll() is None and time.monotonic() - start < SECONDS + 120:
            size = resident(process)
            if size:
                sizes.append((time.monotonic() - start, size))
            time.sleep(1)
        self.finish(process, timeout=60)
        # Window sizes, pipelines and files come and go, but steady growth is a leak.
        third = [size for at, size in sizes if SECONDS / 3 < at < 2 * SECONDS / 3]
        last = [size for at, size in sizes if at >= 2 * SECONDS / 3 and at < SECONDS]
        grown = sum(last) / len(last) - sum(third) / len(third)
        print(f"resident: {sum(third) / len(third) / 2**20:.1f} MiB in the second third, "
              f"{grown / 2**20:+.1f} MiB in the last, {max(size for _, size in sizes) / 2**20:.1f} MiB at most")
        self.assertLess(grown, 64 * 2**20)


if __name__ == "__main__":
    unittest.main()
