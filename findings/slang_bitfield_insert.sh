#!/bin/sh
# Slang writes bitfieldInsert(a, b, 2, 4) + 1u to HLSL without brackets around the insertion, so that HLSL adds first
# and inserts afterwards: 13 instead of 14 for a = 5, b = 3.
# Versions: Slang 2026.12, in slangpy 0.43.1 (PyPI; only its compiler is used, no GPU). Seen with Python 3.11.
# Surprise: the GLSL that Slang writes from the same source is right; and so is HLSL where the insertion stands alone.
# In HLSL + binds tighter than |.
# Who is hit: integer hashes, random numbers and packed lattice coordinates that come to HLSL through Slang.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --no-deps --target "$dir/py" slangpy==0.43.1
cat >"$dir/insert.glsl" <<'GLSL'
#version 450
layout(location = 0) flat in uvec2 k;
layout(location = 0) out uvec4 o;
void main() { uint r = bitfieldInsert(k.x, k.y, 2, 4) + 1u; o = uvec4(r, r, r, r); }
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
    words = [w.encode() for w in [str(here / "insert.glsl"), *words]]
    slang.spProcessCommandLineArguments(request, (text * len(words))(*words), len(words))
    failed = slang.spCompile(request) < 0
    messages = slang.spGetDiagnosticOutput(request).decode()
    if failed or messages:
        sys.exit(f"changed: Slang now says: {messages}")
    return ctypes.string_at(slang.spGetEntryPointSource(request, 0)).decode()


print("Slang", slang.spGetBuildTagString().decode())
expression = re.search(r"uint r_0 = (.*);", translate("hlsl")).group(1)
print("HLSL of bitfieldInsert(k.x, k.y, 2, 4) + 1u:", expression)
# HLSL and Python agree on the order of + << & |, so Python can take the value for k = (5, 3).
for pattern, value in ((r"\w+\.x", "5"), (r"\w+\.y", "3"), (r"uint\((\d+)\)", r"\1"), (r"\b(\d+)U\b", r"\1")):
    expression = re.sub(pattern, value, expression)
expected, seen = (5 & ~(15 << 2) | 3 << 2) + 1, eval(expression)
print(f"expected {expected}; seen {seen}; GLSL: {re.search('r_0 = (.*);', translate('glsl')).group(1)}")
if (expected, seen) != (14, 13):
    sys.exit("the behaviour has changed")
PY
