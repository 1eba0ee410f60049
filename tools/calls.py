"""Makes compute shaders that each call one function of the drop-ins, for tools/isa and
tests/shaders/test_instructions.py, which only compile them. The calls are in tests/shaders/instructions.txt."""

import pathlib
import re

import copies

ROOT = pathlib.Path(__file__).resolve().parents[1]
DROP_INS = {path: path.read_text() for path in sorted((ROOT / "shaders").glob("gabor_*.glsl")) if path.stem not in ("gabor_sparse", "gabor_float")}
# What a call may use, and its number of components: the shaders read all from a buffer, so that no compiler folds a call.
ARGUMENTS = {"p": 2, "dx": 2, "dy": 2, "wave": 2, "period": 2, "q": 3, "dx_3d": 3, "dy_3d": 3, "wave_3d": 3, "normal": 3,
             "direction": 3, "frequency": 1, "orientation": 1, "spread": 1, "time": 1, "seed": 1}
VARIABLES = {"lobes": ("GaborLobes", "lobes.count = 3;\n" + "".join(
              f"lobes.lobe[{i}] = gabor_lobe(frequency, orientation, time + {i}.0, 1.0);\n" for i in range(3))),
          "waves": ("GaborWaves", "".join(f"waves.wave[{i}] = {i}.0 * wave;\n" for i in range(9)))}


def table():
    """Yields each call and the largest number of instructions that it may have."""
    for line in (ROOT / "tests" / "shaders" / "instructions.txt").read_text().splitlines():
        if not line.startswith("#"):
            most, call = line.split(maxsplit=1)
            yield call, int(most)


def shader(call, language):
    """Returns a shader in "glsl" or "wgsl" that stores the sum of all components of a call's result."""
    found = [(path, kind) for name in re.findall(r"gabor_\w+", call) for path, text in DROP_INS.items()
             for kind in re.findall(rf"^(\w+) {name}\([^)]*\)\s*\{{", text, re.MULTILINE)]
    kind, paths = found[0][1], dict.fromkeys(each for path, _ in found for each in [*copies.needed(path), path])
    texts = [DROP_INS[path] if language == "glsl" else (ROOT / "shaders" / "translations" / f"{path.stem}.wgsl").read_text() for path in paths]
    struct = re.search(rf"^struct {kind} \{{(.*?)^\}};", "".join(DROP_INS.values()), re.MULTILINE | re.DOTALL)
    members = re.findall(r"^    (\w+) (\w+);", struct[1], re.MULTILINE) if struct else [(kind, "")]
    parts = [f"result.{member}".rstrip(".") for _, member in members]
    total = " + ".join(part if kind == "float" else f"dot({part}, {kind}(1.0))" for part, (kind, _) in zip(parts, members))

    lines, read = [], 0
    for argument, size in ARGUMENTS.items():
        value = ", ".join(f"values[{read + i}]" for i in range(size))
        read += size
        lines.append(("uint", argument, f"uint({value})") if argument == "seed" else
                     ("float", argument, value) if size == 1 else (f"vec{size}", argument, f"vec{size}({value})"))
    lines.append((kind, "result", call))
    if language == "glsl":
        code = [f"{kind} {argument} = {value};" for kind, argument, value in lines]
        code[-1:-1] = [f"{kind} {argument};\n{text}" for argument, (kind, text) in VARIABLES.items() if argument in call]
        before, main = "#version 450\n#define GABOR_DIRECTION(p) (p)\n", "layout(local_size_x = 64) in;\nlayout(std430, binding = 0) buffer Values { float values[]; };\nvoid main() {\n"
    else:
        code = [f"let {argument} = {value.replace('uint(', 'u32(')};" for _, argument, value in lines]
        code[-1:-1] = [f"var {argument}: {kind};\n{text}" for argument, (kind, text) in VARIABLES.items() if argument in call]
        before, main = "", "@group(0) @binding(0) var<storage, read_write> values: array<f32>;\n@compute @workgroup_size(64) fn main() {\n"
    return before + "\n".join(texts) + main + "\n".join(code) + f"\nvalues[0] = {total};\n}}\n"
