#!/bin/sh
# Slang reads the GLSL expression mat3(1.0) as a matrix of nine ones, where GLSL says identity. The HLSL and GLSL that
# Slang writes contain the nine ones, and Slang prints neither an error nor a warning.
# Versions: Slang 2026.12, in slangpy 0.43.1 (PyPI; only its compiler is used, no GPU). Seen with Python 3.11.
# Surprise: -lang glsl with -allow-glsl exists to compile GLSL as it stands, and the shader compiles. One scalar in a
# constructor follows HLSL's rule (fill) instead of GLSL's (diagonal; section 5.4.2 of the specification).
# Who is hit: anyone who brings GLSL to HLSL with Slang: mat2(1.0) as the start of a product of rotations (fractal
# noise), mat3(s) as a scale, mat4(1.0) as a transform.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --no-deps --target "$dir/py" slangpy==0.43.1
cat >"$dir/identity.glsl" <<'GLSL'
#version 450
layout(location = 0) in vec3 v;
layout(location = 0) out vec4 o;
void main() { o = vec4(mat3(1.0) * v, 1.0); }
GLSL
python3 - "$dir" <<'PY'
import ctypes, pathlib, re, sys

here = pathlib.Path(sys.argv[1])
slang = ctypes.CDLL(str(next((here / "py/slangpy").glob("libslang-compiler.so*"))))
pointer, text = ctypes.c_void_p, ctypes.c_char_p
slang.spCreateCompileRequest.restype = slang.spGetEntryPointSource.restype = pointer
slang.spGetBuildTagString.restype = slang.spGetDiagnosticOutput.restype = text


class Description(ctypes.Structure):  # SlangGlobalSessionDesc
    _fields_ = [("size", ctypes.c_uint32), ("api", ctypes.c_uint32), ("language", ctypes.c_uint32),
                ("glsl", ctypes.c_bool), ("reserved", ctypes.c_uint32 * 16)]


wanted, session = Description(ctypes.sizeof(Description), 0, 2018, True), pointer()
slang.slang_createGlobalSession2(ctypes.byref(wanted), ctypes.byref(session))


def translate(target):
    request = pointer(slang.spCreateCompileRequest(session))
    words = f"-lang glsl -allow-glsl -target {target} -entry main -stage fragment".split()
    words = [w.encode() for w in [str(here / "identity.glsl"), *words]]
    slang.spProcessCommandLineArguments(request, (text * len(words))(*words), len(words))
    failed = slang.spCompile(request) < 0
    messages = slang.spGetDiagnosticOutput(request).decode()
    if failed or messages:
        sys.exit(f"changed: Slang now says: {messages}")
    return ctypes.string_at(slang.spGetEntryPointSource(request, 0)).decode()


print("Slang", slang.spGetBuildTagString().decode())
seen = []
for target, name in (("hlsl", "float3x3"), ("glsl", "mat3x3")):
    numbers = re.search(name + r"\(([^()]*)\)", translate(target)).group(1)
    matrix = [float(n.rstrip("f")) for n in numbers.split(",")]
    seen.append(matrix)
    print(f"{target}: expected {[1.0, 0, 0, 0, 1.0, 0, 0, 0, 1.0]}; seen {matrix}")
if seen != [[1.0] * 9] * 2:
    sys.exit("the behaviour has changed")
PY
