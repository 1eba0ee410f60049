"""Draws with Direct3D 11 in Wine: run.py fxc|angle VALUES.raw DROP_IN [NAME=VALUE], where fxc without macros first compiles each
function of the drop-ins that need no other one before DROP_IN, for each stage, with and without optimization;
or custom shaders, whose pictures follow each other: run.py fxc VALUES.raw SHADER.hlsl..., run.py angle VALUES.raw SHADER.frag

GABOR_DIRECT3D is the folder with direct3d.exe, the libraries of FXC and ANGLE, and Wine's files; DROP_IN.txt there receives
FXC's time for each function."""

import concurrent.futures
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import FRAGMENT, ROOT, drop_in, report  # noqa: E402

FOLDER = pathlib.Path(os.environ["GABOR_DIRECT3D"])
STAGES = {
    "ps_5_0": "float4 main() : SV_Target { return value(); }",
    "vs_5_0": "float4 main() : SV_Position { return value(); }",
    "cs_5_0": "RWBuffer<float> values;\n[numthreads(1, 1, 1)] void main() { values[0] = value(); }",
}
OPTIMIZED, SKIP_OPTIMIZATION = 0, 4


def direct3d(mode, *arguments, **options):
    """Returns what the program prints in Wine. Wine's desktop, which outlives the program, would lose its display, and Xvfb
    may outlive both: neither may hold the lock. Its debugger would wait for ever where one of its services fails."""
    folder = FOLDER / f"wine-{mode}"
    display = ["flock", "--close", f"{folder}.lock", "xvfb-run", "-a", "sh", "-c", '"$@"; status=$?; /usr/lib/wine/wineserver -k; exit $status', "-"]
    command = [*(display if mode != "compile" else []), "/usr/lib/wine/wine64", FOLDER / "direct3d.exe", mode, *arguments]
    settings = {"WINEPREFIX": str(folder), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "d3dcompiler_47=n;mscoree,mshtml=;winedbg.exe=d"}
    return subprocess.run(command, env=os.environ | settings, text=True, stdout=subprocess.PIPE, **options).stdout


def draw(dialect, path, name, macros):
    ending, engine, language = ("hlsl", "FXC", "HLSL by FXC") if dialect == "fxc" else ("frag", "ANGLE", "GLSL 300 es")
    if name.endswith(ending):
        said = direct3d(dialect, name, *macros, path)
    else:
        if dialect == "fxc":
            scene = (ROOT / "tests/dialects/scene.hlsl").read_text()
            text = scene.replace('#include "gabor_noise.hlsl"\n', drop_in(name, macros, "hlsl"))
        else:
            text = "#version 300 es\nprecision highp float;\n" + drop_in(name, macros) + FRAGMENT
        with tempfile.NamedTemporaryFile("w", suffix=f".{ending}") as shader:
            shader.write(text)
            shader.flush()
            said = direct3d(dialect, shader.name, path)
    if "done" not in said:
        sys.exit(f"{engine} failed")
    version = re.search(r"ANGLE ([.\d]+).*Direct3D11|d3dcompiler_(\d+)", said, re.DOTALL)
    report(path, pathlib.Path(path).read_bytes(), engine, version[1] or version[2], language, "Direct3D 11 of Wine, llvmpipe")


def numbers(shader, type, value):
    """Yields an expression for each number or vector in a value."""
    if type in shader.structs:
        for name, field in shader.structs[type].fields.items():
            array = field.type.endswith("[]")
            yield from numbers(shader, field.type.removesuffix("[]"), f"{value}.{name}{'[0]' * array}")
    else:
        yield f"dot({value}, 1)"


def caller(function, shader, kinds):
    """Returns an HLSL function `value` that calls a function with arguments that FXC does not know."""
    parts = [(kinds.get(part.type, part.type), f"local_{i}", part) for i, part in enumerate(function.parameters)]
    shown = [("result", function.type)] + [(local, part.type) for _, local, part in parts if part.out]
    return "".join([
        "cbuffer Given {\n", *(f"    {kind} given_{local};\n" for kind, local, _ in parts), "};\nfloat value() {\n",
        *(f"    {kind} {local} = given_{local};\n" for kind, local, _ in parts),
        f"    {kinds.get(function.type, function.type)} result = {function.name.text}({', '.join(local for _, local, _ in parts)});\n",
        f"    return {' + '.join(number for name, type in shown for number in numbers(shader, type, name))};\n}}\n"])


def callers(first):
    """Yields the name of each public function of the drop-ins that start with `first`, and HLSL that calls it."""
    sys.path.append(str(ROOT / "tools"))
    loader = importlib.machinery.SourceFileLoader("translate", str(ROOT / "tools" / "translate"))
    translate = importlib.util.module_from_spec(importlib.util.spec_from_loader("translate", loader))
    loader.exec_module(translate)
    for path in translate.copies.DROP_INS:
        files = [file.stem for file in (*translate.copies.needed(path), path)]
        if files[0] == first:
            text = "#define GABOR_DIRECTION(p) (0.3 * (p))\n" + "".join(drop_in(file, [], "hlsl") for file in files)
            for item in translate.shader(path).items:
                if item.kind == "function" and not item.name.text.startswith("gabor_impl"):
                    yield item.name.text, text + caller(item, translate.shader(path), translate.VECTORS)


def compile_functions(name):
    with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
        lists = {(stage, flags): "" for stage in STAGES for flags in (OPTIMIZED, SKIP_OPTIMIZATION)}
        for function, value in callers(name):
            for stage, main in STAGES.items():
                path = pathlib.Path(folder) / f"{function}.{stage}.hlsl"
                path.write_text(value + main)
                for flags in (OPTIMIZED, SKIP_OPTIMIZATION):
                    lists[stage, flags] += f"{path} {stage} {flags}\n"
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            said = "".join(pool.map(lambda lines: direct3d("compile", input=lines), lists.values()))
    said = said.replace(f"{folder}/", "")
    (FOLDER / f"{name}.txt").write_text(said)
    if "error" in said or said.count("_5_0 ") != sum(lines.count("\n") for lines in lists.values()):
        sys.exit(f"FXC refuses a function:\n{said}")


if __name__ == "__main__":
    dialect, values, given, *definitions = sys.argv[1:]
    if dialect == "fxc" and "." not in given and not definitions:
        compile_functions(given)
    draw(dialect, values, given, definitions)
