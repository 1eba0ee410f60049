#!/bin/sh
# PsychoPy's imifft() loses the sign: noise between -1 and 1 that goes through imfft() and imifft() comes back as its
# absolute value, so filtered noise has no negative half, a higher mean and doubled frequencies.
# Versions: PsychoPy 2026.2.5, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: -1 to 1 is PsychoPy's own range for textures, and the two functions are given as a pair, with Butterworth
# filters beside them. Pictures from 0 to 1 come back right, so a test with a photograph passes.
# Who is hit: experiments with band-limited noise or filtered gratings made with psychopy.visual.filters: mean
# luminance, contrast and spatial frequency are not those asked for.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" numpy==2.2.6
python3 -m pip install --quiet --no-deps --target "$dir/psychopy" psychopy==2026.2.5
PYTHONPATH=$dir/py python3 - "$dir/psychopy" <<'PY'
import runpy, sys
import numpy as np

# The module needs numpy alone; importing it through the package would need a graphics stack.
filters = runpy.run_path(sys.argv[1] + "/psychopy/visual/filters.py")
noise = np.random.default_rng(1).uniform(-1, 1, (64, 64))
again = filters["imifft"](filters["imfft"](noise))
band = filters["butter2d_bp"]((64, 64), cutin=0.05, cutoff=0.15, n=5)
filtered = filters["imifft"](filters["imfft"](noise) * band)

print("PsychoPy 2026.2.5")
print(f"there and back: expected a difference of 0; seen {np.abs(again - noise).max():.3f},",
      "equal to the absolute value:", np.allclose(again, np.abs(noise)))
print(f"band-passed noise: expected mean 0 and negative values; seen mean {filtered.mean():.3f} at deviation "
      f"{filtered.std():.3f}, least value {filtered.min():.4f}")
if not np.allclose(again, np.abs(noise)) or filtered.min() < 0 or filtered.mean() < filtered.std():
    sys.exit("the behaviour has changed")
PY
