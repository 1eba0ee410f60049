#!/bin/sh
# FXC, the HLSL compiler of Direct3D 11, unrolls each loop that writes to an array in a struct at the loop's index, with a warning
# (X3550) but without an error. The same loop with the array as a variable of its own stays a loop. Code and compile time grow with
# the length of the array: here the shader is 9 times as long, and a sea of 11 bands took 40 times as long to compile.
# Versions: d3dcompiler_47 in kivy_deps_angle 0.5.0 (PyPI), in Debian's Wine. Needs wine64 and x86_64-w64-mingw32-g++-posix.
# Surprise: the two shaders differ only in where the array is, FXC keeps arrays of structs in indexable registers, and an
# assignment copies one into the other at no cost.
# Who is hit: shaders that fill a struct with an array (waves, lights, samples) for Direct3D 11 in Unity or Unreal, and WebGL in
# browsers on Windows, whose ANGLE calls FXC: pages stand still until it is done.
set -eu
dir=$(mktemp -d)
trap 'WINEPREFIX="$dir/wine" /usr/lib/wine/wineserver -k || true; rm -rf "$dir"' EXIT
python3 -m pip download --quiet --no-deps --only-binary=:all: --platform=win_amd64 --python-version=3.11 --dest "$dir" kivy_deps_angle==0.5.0
python3 - "$dir" <<'PY'
import pathlib, sys, zipfile

here = pathlib.Path(sys.argv[1])
with zipfile.ZipFile(next(here.glob("*.whl"))) as wheel:
    name = next(name for name in wheel.namelist() if name.endswith("d3dcompiler_47.dll"))
    (here / "d3dcompiler_47.dll").write_bytes(wheel.read(name))
PY
cat >"$dir/lengths.cpp" <<'CPP'
#include <d3dcompiler.h>
#include <cstdio>
#include <cstdlib>
#include <string>
const char *before = R"(
struct Wave { float4 place; float4 speed; };
struct Sea { float wind; Wave wave[32]; };
float made(float at) { for (int n = 0; n < 100; ++n) at = sin(at) + 0.5 * at * exp(-at); return at; }
Sea sea(float wind) {
    Sea made_sea;
    made_sea.wind = wind;
    Wave waves[32];
    for (int i = 0; i < 32; ++i) {
        Wave wave;
        wave.place = float4(made(wind * i), made(wind - i), made(wind / (i + 1)), made(wind + 3 * i));
        wave.speed = made(wind + i) * wave.place.yzwx + log(abs(wave.place));
)", *after = R"(
    return made_sea;
}
float wind;
RWStructuredBuffer<float> values;
[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID) {
    Wave wave = sea(wind).wave[pixel.x & 31];
    values[pixel.x] = dot(wave.place, wave.speed);
})";
int length(const std::string& text) {
    ID3DBlob *code = nullptr, *said = nullptr, *listed = nullptr;
    if (FAILED(D3DCompile(text.data(), text.size(), "sea", nullptr, nullptr, "main", "cs_5_0", 0, 0, &code, &said))) exit(2);
    D3DDisassemble(code->GetBufferPointer(), code->GetBufferSize(), 0, 0, &listed);
    const std::string lines = static_cast<const char*>(listed->GetBufferPointer());
    return std::atoi(lines.c_str() + lines.find("Approximately ") + 14);
}
int main() {
    const std::string start = before, end = after;
    const int inside = length(start + "made_sea.wave[i] = wave; }" + end);
    const int own = length(start + "waves[i] = wave; } made_sea.wave = waves;" + end);
    std::printf("instructions: expected the same; seen %d with the array in the struct, %d with its own variable\n", inside, own);
    return inside > 5 * own ? 0 : 1;
}
CPP
x86_64-w64-mingw32-g++-posix -static -o "$dir/lengths.exe" "$dir/lengths.cpp" "$dir/d3dcompiler_47.dll"
cd "$dir"
WINEPREFIX="$dir/wine" WINEDEBUG=-all WINEDLLOVERRIDES="d3dcompiler_47=n;mscoree,mshtml=" /usr/lib/wine/wine64 ./lengths.exe || {
    echo "the behaviour has changed"
    exit 1
}
