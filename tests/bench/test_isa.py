"""Checks that the shaders cost at most 5 % more on an AMD Navi 21 than navi21.txt says. RADV's compiler estimates the cost
without the GPU; tools/performance writes the file."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

driver, *rows = [line for line in pathlib.Path(__file__).with_name("navi21.txt").read_text().splitlines() if line[0] != "#"]
recorded = [(name, *map(int, figures)) for *figures, name in (row.split(" ", 3) for row in rows)]
assert len(recorded) > 30
with tempfile.TemporaryDirectory() as folder:
    measured_file = pathlib.Path(folder) / "isa.json"
    subprocess.run([os.environ["GABOR_ISA"], os.environ["GABOR_PROGRAM"], "--json", measured_file], check=True)
    measured = json.loads(measured_file.read_text())

if measured["driver"] != driver:
    print(f"skipped: navi21.txt was recorded with {driver}, but this is {measured['driver']}")
    sys.exit(77)

now = {code["name"]: code for code in measured["code"]}
worse = []
for name, *before in recorded:
    if name not in now:
        worse.append(f"{name}: gone")
        continue
    # The file is rounded, and registers are allocated in steps of eight.
    for figure, was, slack in zip(("instructions", "inverse_throughput", "registers"), before, (0.5, 0.5, 8)):
        if not 0 < now[name][figure] <= slack + (was if figure == "registers" else 1.05 * was):
            worse.append(f"{name}: {figure} {now[name][figure]:.1f}, recorded {was}")
print("\n".join(worse) or "no cost has risen")
sys.exit(bool(worse))
