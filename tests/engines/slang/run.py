"""Imports functions from the module in the package for Slang, compiles them to SPIR-V and runs them on Vulkan: run.py VALUES.raw"""

import pathlib
import re
import subprocess
import sys

import numpy as np
import slangpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import CALLS, ROOT, SLANG, calls_on_vulkan, report  # noqa: E402


def compiled(source, spirv):
    subprocess.run([sys.executable, "-B", ROOT / "tests/dialects/slangc.py", source, "main", "compute", spirv], check=True)


calls = [re.sub(r"\bvec(?=\d)", "float", call.replace("ivec", "int")) for call in CALLS.values()]
driver, values = calls_on_vulkan("slang", "slang", "import gabor_noise;" + SLANG, calls, compiled)
_, sums = calls_on_vulkan("slang", "slang", "import gabor_fractal;" + SLANG, ["gabor_fbm(p, 3.3, 0.5, 7u)"], compiled)
report(sys.argv[1], np.concatenate([values, sums]), "Slang", slangpy.__version__, "a module, to SPIR-V", driver, functions=[*CALLS, "fbm"])
