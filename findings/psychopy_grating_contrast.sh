#!/bin/sh
# PsychoPy's makeGrating() ignores the contrast of all but sine gratings: a square grating asked for at 10 % has 100 %.
# maskMatrix() ignores its centre in the same way.
# Versions: PsychoPy 2026.2.5, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: `contr` and `center` are documented arguments, they are accepted, and they work in the neighbouring cases
# (gratType="sin"; makeMask with the same centre).
# Who is hit: contrast thresholds measured with square gratings or plaids, and patches that should lie beside fixation.
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
print("PsychoPy 2026.2.5")
seen = {}
for kind in ("sin", "sqr", "sinXsin"):
    seen[kind] = round(float(np.abs(filters["makeGrating"](64, cycles=4, gratType=kind, contr=0.1)).max()), 6)
    print(f"{kind} grating with contr=0.1: expected amplitude 0.1; seen {seen[kind]}")
where = {}
for name, patch in (
        ("makeMask", filters["makeMask"](64, "gauss", 0.5, center=(0.5, 0.5), range=(0, 1))),
        ("maskMatrix", filters["maskMatrix"](np.ones((64, 64)), "gauss", 0.5, center=(0.5, 0.5)))):
    where[name] = tuple(int(i) for i in np.unravel_index(patch.argmax(), patch.shape))
    print(f"{name} with center=(0.5, 0.5) on 64 x 64: expected its peak at (48, 48); seen {where[name]}")
if seen != {"sin": 0.1, "sqr": 1.0, "sinXsin": 1.0} or where != {"makeMask": (48, 48), "maskMatrix": (32, 32)}:
    sys.exit("the behaviour has changed")
PY
