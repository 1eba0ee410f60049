"""The cost of the shaders on an AMD Navi 21, as RADV's compiler estimates it without one: no more than 5 % above
what recorded_isa.json says. A change for the better is recorded by writing that file anew:

    tools/isa PROGRAM --json tests/bench/recorded_isa.json
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

recorded = json.loads((pathlib.Path(__file__).parent / "recorded_isa.json").read_text())
with tempfile.TemporaryDirectory() as folder:
    measured_file = pathlib.Path(folder) / "isa.json"
    subprocess.run([os.environ["GABOR_ISA"], os.environ["GABOR_PROGRAM"], "--json", measured_file], check=True)
    measured = json.loads(measured_file.read_text())

if measured["driver"] != recorded["driver"]:
    print(f"skipped: recorded with {recorded['driver']}, and this is {measured['driver']}: nothing to compare")
    sys.exit(77)

now = {code["name"]: code for code in measured["code"]}
worse = []
for before in recorded["code"]:
    after = now.get(before["name"])
    if after is None:
        worse.append(f"{before['name']}: gone")
        continue
    for figure in ("instructions", "inverse_throughput", "registers"):
        # Registers come in steps of eight.
        limit = before[figure] + (8 if figure == "registers" else 0.05 * before[figure])
        if after[figure] > limit:
            worse.append(f"{before['name']}: {figure} {after[figure]:.1f}, recorded {before[figure]:.1f}")
print("\n".join(worse) or "no more than recorded")
sys.exit(bool(worse))
