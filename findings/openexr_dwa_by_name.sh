#!/bin/sh
# DWAA compression of OpenEXR looks at a channel's name: the same floats are lossless as "height" and lossy as "Y" or
# "R" (errors of 20 in values near 1000, and 70000 becomes 64704).
# Versions: OpenEXR 3.5.3, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: loss depends neither on type nor on values, but on spelling: R, G, B, Y, RY and BY (behind a layer's name
# too) are compressed as colours, through 16-bit floats that end near 65504; any other name is kept bit for bit.
# Who is hit: heights, displacement, positions and wave data in channels Y, R or RGB, and readers that rename channels
# between two saves.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" OpenEXR==3.5.3 numpy==2.2.6
PYTHONPATH=$dir/py python3 - "$dir/map.exr" <<'PY'
import os, sys
import numpy as np
import OpenEXR

heights = (1000 + 50 * np.random.default_rng(1).uniform(-1, 1, (64, 64))).astype(np.float32)
heights[5, 5] = 70000
print("OpenEXR", OpenEXR.__version__)
print("expected: the same error for every name")
lossy = {}
for name in ("height", "Z", "X", "A", "R", "G", "B", "Y", "RY", "BY", "normal.R"):
    header = {"compression": OpenEXR.DWAA_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {name: heights}).write(sys.argv[1])
    with OpenEXR.File(sys.argv[1]) as file:
        again = file.channels()[name].pixels
    wrong = np.abs(again - heights)
    wrong[5, 5] = 0
    lossy[name] = bool(wrong.max() > 1)
    print(f"{name}: seen {again.dtype}, error {wrong.max():.2f}, 70000 as {again[5, 5]:.0f}, "
          f"{os.path.getsize(sys.argv[1])} bytes")
    if not lossy[name] and not np.array_equal(again, heights):
        sys.exit("the behaviour has changed")
if [name for name in lossy if lossy[name]] != ["R", "G", "B", "Y", "RY", "BY", "normal.R"]:
    sys.exit("the behaviour has changed")
PY
