#!/bin/sh
# OpenEXR's Python class File writes into the two dictionaries that it is given: the header gets the size of this image,
# so that the same header is refused for an image of another size, and each array among the channels becomes a Channel.
# Versions: OpenEXR 3.5.3, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: only File(header, channels) was called, nothing was read. A header with compression and attributes, made
# once for a set of maps, fits the first map alone; arrays in the dictionary can no longer be calculated with.
# Who is hit: scripts that write many files in a loop: maps of several resolutions, or a copy at half of the brightness.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" OpenEXR==3.5.3 numpy==2.2.6
PYTHONPATH=$dir/py python3 - "$dir" <<'PY'
import sys
import numpy as np
import OpenEXR

header = {"compression": OpenEXR.ZIP_COMPRESSION}
small = {"Y": np.zeros((4, 6), np.float32)}
OpenEXR.File(header, small).write(f"{sys.argv[1]}/small.exr")
print("OpenEXR", OpenEXR.__version__)
print(f"header afterwards: expected compression alone, seen {sorted(header)}")
print(f"Y afterwards: expected ndarray, seen {type(small['Y']).__name__}")
error = "nothing"
try:
    OpenEXR.File(header, {"Y": np.zeros((8, 8), np.float32)}).write(f"{sys.argv[1]}/large.exr")
except ValueError as seen:
    error = str(seen)
print(f"an image of 8 x 8 with the same header: expected a file, seen {error!r}")
if "dataWindow" not in header or isinstance(small["Y"], np.ndarray) or "dataWindow" not in error:
    sys.exit("the behaviour has changed")
PY
