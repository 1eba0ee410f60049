#!/bin/sh
# OpenCV's generator is linear in a small seed: the first uniform numbers of seeds 1, 2, 3... form an arithmetic
# sequence (modulo 1), and the first normal number of each of 1000 seeds lies within 2e-6 of 0.
# Versions: opencv-python-headless 5.0.0.93, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: setRNGSeed does not mix the seed. The generator multiplies with carry, and starts at the seed itself.
# Who is hit: noise with one seed for each tile, cell or trial: cells numbered in order hold a ramp instead of random
# values, and normal noise has the value 0 at the first pixel of every tile.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir" opencv-python-headless==5.0.0.93 numpy==2.2.6
PYTHONPATH=$dir python3 - <<'PY'
import sys
import cv2
import numpy as np

seeds = range(1, 1001)
uniform, normal = (np.empty((len(seeds), 4), np.float32) for _ in range(2))
for row, seed in enumerate(seeds):
    cv2.setRNGSeed(seed)
    cv2.randu(uniform[row:row + 1], 0, 1)
    cv2.setRNGSeed(seed)
    cv2.randn(normal[row:row + 1], 0, 1)

steps = np.diff(uniform.astype(float), axis=0) % 1
turn = np.exp(2j * np.pi * steps)
scatter = 1 - np.abs(turn.mean(0))  # 0: the same step between all seeds; near 1: random
largest = np.abs(normal[:, 0]).max()
print("OpenCV", cv2.__version__)
print("step from seed to seed, of the first four uniform numbers: expected random; seen",
      (np.angle(turn.mean(0)) / (2 * np.pi) % 1).round(4), "scatter", scatter.round(6))
print(f"first normal number of 1000 seeds: expected deviation 1; seen all within {largest:.1e} of 0")
print("(the others have deviation", normal[:, 1:].std(0).round(2), ")")
if scatter.max() > 1e-3 or largest > 2e-6:
    sys.exit("the behaviour has changed")
PY
