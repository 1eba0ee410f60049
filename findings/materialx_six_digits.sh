#!/bin/sh
# MaterialX keeps six significant digits of a number: setValue(1234567.0) followed by getValue() gives 1234570, and the
# generated GLSL says 1234570.000000.
# Versions: MaterialX 1.39.5 (PyPI). Seen with Python 3.11.
# Surprise: no file is written in between. A value becomes text the moment it is set, with fewer digits than a float
# holds; the shader then prints the rounded number with six decimals, so that nothing in it looks rounded.
# Who is hit: noise graphs with offsets, seeds or the constants of a hash (43758.5453), and positions in metres of a
# map.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir" MaterialX==1.39.5
PYTHONPATH=$dir python3 - <<'PY'
import sys
import MaterialX as mx
import MaterialX.PyMaterialXGenGlsl as glsl
import MaterialX.PyMaterialXGenShader as shader

library, document = mx.createDocument(), mx.createDocument()
mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
document.setDataLibrary(library)

graph = document.addNodeGraph("graph")
scaled = graph.addNode("multiply", "scaled", "vector2")
scaled.setConnectedNode("in1", graph.addNode("texcoord", "uv", "vector2"))
scaled.setInputValue("in2", mx.Vector2(1234567.0, 43758.5453))
noise = graph.addNode("noise2d", "noise", "float")
noise.setConnectedNode("texcoord", scaled)
output = graph.addOutput("out", "float")
output.setConnectedNode(noise)

generator = glsl.GlslShaderGenerator.create()
context = shader.GenContext(generator)
context.registerSourceCodeSearchPath(mx.getDefaultDataSearchPath())
code = generator.generate("shader", output, context).getSourceCode(shader.PIXEL_STAGE)
line = next(line for line in code.splitlines() if "scaled_in2" in line)
seen = list(scaled.getInputValue("in2"))

print("MaterialX", mx.getVersionString())
print("expected [1234567.0, 43758.546875], the nearest floats; seen", seen)
print("GLSL:", line)
if seen != [1234570.0, 43758.5] or "vec2(1234570.000000, 43758.500000)" not in line:
    sys.exit("the behaviour has changed")
PY
