#!/bin/sh
# NVIDIA Warp's periodic noise, wp.pnoise(), does not repeat across zero: at negative coordinates it has other values
# than one period further on, so a tile centred on the origin has a seam.
# Versions: warp-lang 1.19.0, numpy 2.2.6 (PyPI); on the CPU. Seen with Python 3.11.
# Surprise: between 0 and any positive number of periods the repetition is exact. Below 0 the cell's index is reduced by
# a remainder that keeps the sign, so cell -3 of period 8 is not cell 5, and the noise differs by up to its whole range.
# Who is hit: simulations that seed periodic domains such as -1 to 1 with noise, and textures drawn around the origin.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" warp-lang==1.19.0 numpy==2.2.6
cat >"$dir/periods.py" <<'PY'
import sys
import numpy as np
import warp as wp

wp.config.quiet = True
wp.config.kernel_cache_dir = sys.argv[1]
wp.init()


@wp.kernel
def periodic(points: wp.array(dtype=wp.vec2), values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = wp.pnoise(wp.rand_init(1), points[i], 8, 8)


def noise(points):
    values = wp.zeros(len(points), dtype=float, device="cpu")
    wp.launch(periodic, len(points), [wp.array(points, dtype=wp.vec2, device="cpu"), values], device="cpu")
    return values.numpy()


points = (np.random.default_rng(1).integers(0, 8 * 64, (4000, 2)) / 64).astype(np.float32)  # exact in 32-bit floats
period = np.float32([8, 0])
above = np.abs(noise(points + period) - noise(points)).max()
below = np.abs(noise(points - period) - noise(points)).max()
print("Warp", wp.__version__)
print(f"largest difference between x and x + 8: expected 0, seen {above:.1e}")
print(f"largest difference between x and x - 8: expected 0, seen {below:.2f}, of a deviation of {noise(points).std():.2f}")
if above > 1e-5 or below < 0.5:
    sys.exit("the behaviour has changed")
PY
PYTHONPATH=$dir/py python3 "$dir/periods.py" "$dir/cache"
