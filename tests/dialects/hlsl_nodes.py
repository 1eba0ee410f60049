"""Draws each node of Unity's or Unreal's package as the engine's compiler would call it, and compares it with the drop-ins:
hlsl_nodes.py unity|unreal dxc|fxc VALUES.raw

GABOR_DXC is the DirectX shader compiler's library; GABOR_DIRECT3D is the folder of FXC, which Wine runs."""

import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "engines"), str(HERE.parents[1] / "tools")]
import hlsl_nodes  # noqa: E402
import reference  # noqa: E402
from scene import on_vulkan, packaged, report  # noqa: E402

STEPS = "float2(0.012, 0.005)", "float2(-0.003, 0.015)"  # of a pixel
# The first nodes with the arguments of reference.FUNCTIONS, and these functions as weighted sums of the outputs.
EQUATIONS = {
    "Noise": (dict(Frequency=4.0, Orientation=0.7854, Seed=7.0), {"noise": "Noise", "complex": "Quadrature"}),
    "Stripes": (dict(Wave="gabor_wave_vector(4.0, 0.7854)", Sharpness=2.0, Seed=7.0), {
        "gradient": "Noise + dot(Gradient, float2(1.0, 2.0)) / 32.0", "stripes": "dot(Stripes, float3(0.25, 0.5, 0.75))"}),
    "Fractal": (dict(Octaves=3.3, Lacunarity=2.0, Gain=0.5, Shape=0.0, Basis=0.0, Seed=7.0), {"fbm": "Noise"}),
}
# The other nodes in GLSL, which other tests compare with the equations: the column of the table in which their errors are, a call,
# and what the outputs are made of. MEMBERS stands for the struct's members.
CALLS = {
    "Fractal Filtered": ("fractal", "GaborFractalNoise made = gabor_fractal_noise_filtered(gabor_place_at(p), dx, dy, GaborFractal(Octaves, Gain, Lacunarity, "
                         "gabor_fractal(1.0, 0.5).turn, int(Basis), int(Shape)), seed);", "made.noise made.gradient.x made.gradient.y"),
    "Terrain": ("erosion", "GaborTerrainPlace ground = GaborTerrainPlace(ivec2(0), p, vec2(0.0));\n"
                "vec2 wide = vec2(PixelSize, 0.0), high = vec2(0.0, PixelSize);\n"
                "GaborTerrain made = gabor_eroded_at(ground, wide, high, gabor_terrain_at(ground, wide, high, seed), MEMBERS, seed);\n"
                "vec4 cover = gabor_ground_cover(made);",
                "made.height made.slope.x made.slope.y made.ridge cover.x cover.y cover.z cover.w"),
    "Sea": ("sea", "GaborWater made = gabor_water_filtered(p, vec2(PixelSize, 0.0), vec2(0.0, PixelSize), Seconds, "
            "gabor_ocean_of(GaborSea(Wind, Fetch, SwellHeight, SwellPeriod, SwellDirection, WaterDepth, Direction, int(Loop))), seed);",
            "made.height made.shift.x made.shift.y made.slope.x made.slope.y made.jacobian"),
}
MATERIAL = ("materials", "GaborMaterial made = gabor_NAME_filtered_at(p, dx, dy, vec2(0.0), MEMBERS, seed);\n"
            "vec3 normal = normalize(vec3(-made.slope, 1.0));",
            "made.colour.x made.colour.y made.colour.z normal.x normal.y normal.z gabor_roughness(made) made.metalness made.height")
GLSL = """layout(local_size_x = 8) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };
void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    vec2 p = (vec2(pixel) + 0.5) / 32.0;
    CALL
    values[pixel.y * 256u + pixel.x] = VALUE;
}
"""
HLSL = """#define ddx(at) STEP_X
#define ddy(at) STEP_Y
BEFORE
RWStructuredBuffer<float> values : register(u0);
[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    MAIN
    values[pixel.y * 256 + pixel.x] = VALUE;
}
"""


def given(node):
    """Returns a value for each input but Place: near its default, or above it where that is 0, and within the range."""
    values = {each.name: tuple(min(max(each.low, (0.8 + 0.3 * (0.618 * (3 * i + k) % 1)) * (number or 0.3 * each.high)), each.high)
                               for k, number in enumerate(each.value)) for i, each in enumerate(node.inputs) if each.name != "Place"}
    whole = {"Seed": -9.0, "Octaves": 2.5, "Shape": 2.0, "Basis": 1.0, "Loop": 64.0, "Weave": 1.0, "PixelSize": 0.06, "Seconds": 100.3, "WaterDepth": 15.0}
    return values | {name: (value,) for name, value in whole.items() if name in values}


def constant(numbers, vector="float"):
    """Returns a number or a vector in HLSL, or in GLSL with "vec"."""
    if isinstance(numbers, str):
        return numbers
    numbers = (numbers,) if isinstance(numbers, float) else numbers
    listed = ", ".join(repr(float(f"{each:.7g}")) for each in numbers)
    return listed if len(numbers) == 1 else f"{vector}{len(numbers)}({listed})"


def weighted(node):
    """Returns the HLSL of a sum of all outputs with different weights."""
    parts = [f"{each}{'.' + 'xyzw'[k] if size > 1 else ''}" for each, size in node.outputs.items() for k in range(size)]
    return " + ".join(f"{0.5 + 0.25 * i} * {part}" for i, part in enumerate(parts))


def expanded(folder, text):
    """Returns HLSL with the package's files in place of their includes."""
    return re.sub(r'^#include "(?:/Project/)?(.*)"$', lambda match: expanded(folder, (folder / match[1]).read_text()), text, flags=re.MULTILINE)


def in_unity(folder, node, arguments, value, kind):
    """Half precision is not used by these compilers, so both functions must have the same values."""
    inputs = [f"({hlsl_nodes.typed(kind, len(each.value))})({'p' if each.name == 'Place' else constant(arguments[each.name])})" for each in node.inputs]
    main = "".join(f"{hlsl_nodes.typed(kind, size)} {name};\n    " for name, size in node.outputs.items())
    main += f"Gabor{node.name.replace(' ', '')}_{kind}({', '.join([*inputs, *node.outputs])});"
    return expanded(folder, f'#include "Gabor{node.file}.hlsl"\n'), main, value


def in_unreal(folder, node, arguments, value, _):
    """The code that Unreal's material compiler generates from a Custom node, except for the names of its first parameters."""
    code = (folder / f"Gabor {node.name}.hlsl").read_text()
    include = re.search("Include File Paths: (.*)", code)[1]
    (first, size), *more = node.outputs.items()
    inputs = [each for each in node.inputs if not each.member]
    listed = ", ".join([f"MaterialFloat{len(each.value) if len(each.value) > 1 else ''} {each.name}" for each in inputs]
                       + [f"inout MaterialFloat{size if size > 1 else ''} {name}" for name, size in more])
    declared = ", ".join("p" if each.name == "Place" else constant(arguments[each.name]) for each in inputs)
    main = "".join(f"{hlsl_nodes.typed('float', size)} {name} = 0.0;\n    " for name, size in more)
    main += f"{hlsl_nodes.typed('float', size)} {first} = CustomExpression0(Parameters, {', '.join([declared, *(name for name, _ in more)])});\n"
    before = ("#define PIXELSHADER 1\n#define MaterialFloat float\n#define MaterialFloat2 float2\n#define MaterialFloat3 float3\n"
              "#define MaterialFloat4 float4\n" + expanded(folder, f'#include "{include}"\n')
              + "struct FMaterialPixelParameters { float4 SvPosition; };\n"
              f"MaterialFloat{size if size > 1 else ''} CustomExpression0(FMaterialPixelParameters Parameters, {listed})\n{{\n{code}\n}}\n")
    return before, "FMaterialPixelParameters Parameters;\n    Parameters.SvPosition = float4(p, 0.0, 1.0);\n    " + main, \
        f"{value} + 0.0 * {first}{'.x' * (size > 1)}"  # so that the compiler finds no unused variable


def drawn_by(compiler, folder, shaders):
    """Returns the driver's name and the pictures that compute shaders draw. Wine, which takes longest to start, starts once."""
    sources, made = [folder / f"node{i}.hlsl" for i in range(len(shaders))], folder / "nodes.raw"
    for source, shader in zip(sources, shaders):
        source.write_text(shader)
    if compiler == "fxc":
        said = subprocess.run([sys.executable, "-B", HERE.parent / "engines/direct3d/run.py", "fxc", made, *sources], check=True, stdout=subprocess.PIPE,
                              text=True).stdout
        return json.loads(said.splitlines()[-1])["driver"], np.split(np.fromfile(made, "<f4"), len(shaders))
    for source in sources:
        subprocess.run([sys.executable, "-B", HERE / "dxc.py", source, source.with_suffix(".spv"), "-Wno-unused-parameter"], check=True)
    driver, *pictures = on_vulkan(*(source.with_suffix(".spv") for source in sources))
    return driver, pictures


def wanted(engine, node, arguments, folder):
    """Returns the weighted sum of the outputs that the drop-ins compute in GLSL."""
    name = node.name.lower().replace(" ", "_")
    _, call, outputs = CALLS.get(node.name, MATERIAL)
    listed = ", ".join(f"int({constant(arguments[each.name])})" if each.cast else constant(arguments[each.name], "vec") for each in node.inputs if each.member)
    members = {"unity": f"{'GaborErosion' if node.name == 'Terrain' else 'Gabor' + node.name.replace(' ', '')}({listed})",
               "unreal": "gabor_erosion()" if node.name == "Terrain" else f"gabor_{name}_default()"}[engine]  # Unreal's code has the defaults
    call = call.replace("NAME", name).replace("MEMBERS", members)
    for each in node.inputs:
        if not each.member and each.name != "Place":
            call = re.sub(rf"\b{each.name}\b", constant(arguments[each.name], "vec"), call)
    call = "\n".join([f"uint seed = uint({int(arguments['Seed'][0])});", *(f"vec2 {step} = {text.replace('float2', 'vec2')};" for step, text in zip(("dx", "dy"), STEPS)), call])
    value = " + ".join(f"{0.5 + 0.25 * i} * {part}" for i, part in enumerate(outputs.split()))
    source, spirv = folder / "wanted.comp", folder / "wanted.spv"
    source.write_text("#version 450\n" + "".join(path.read_text() for path in hlsl_nodes.files(node.drop_in)) + GLSL.replace("CALL", call).replace("VALUE", value))
    subprocess.run(["glslangValidator", "--quiet", "-V", "-o", spirv, source], check=True)
    return on_vulkan(spirv)[1]


def main():
    engine, compiler, path = sys.argv[1:]
    call, kinds = {"unity": (in_unity, ["float", "half"]), "unreal": (in_unreal, ["float"])}[engine]
    errors, cases, shaders = {}, [], []  # the first case is the noise
    with tempfile.TemporaryDirectory(prefix="gabor-") as scratch:
        scratch = pathlib.Path(scratch)
        folder = packaged(engine, scratch / "package")
        for node in hlsl_nodes.table():
            arguments, values = EQUATIONS.get(node.name, (given(node), {node.name: weighted(node)}))
            # FXC takes twice as long for both precisions in one shader as in two.
            for (name, value), kind in itertools.product(values.items(), kinds):
                before, main, value = call(folder, node, arguments, value, kind)
                shaders.append(HLSL.replace("STEP_X", STEPS[0]).replace("STEP_Y", STEPS[1]).replace("BEFORE", before).replace("MAIN", main).replace("VALUE", value))
                cases.append((node, arguments, name, kind))
        driver, pictures = drawn_by(compiler, scratch, shaders)
        for (node, arguments, name, kind), drawn in zip(cases, pictures, strict=True):
            if node.name in EQUATIONS:
                column, (error, at), limit = name, reference.largest_difference(name, drawn[:256 * 256]), 1e-5
            else:
                known = wanted(engine, node, arguments, scratch)
                difference = np.abs(drawn[:256 * 256] - known[:256 * 256])
                column, at = CALLS.get(node.name, MATERIAL)[0], divmod(int(difference.argmax()), 256)
                # FXC rounds differently, which hairline scratches, borders of grass or snow, and derivatives of octaves magnify. Both
                # compilers multiply a scratch's density, position and cells per radius in orders of their own: where both products
                # are `precise`, 999 of 1000 pixels of scratches are within 6e-5.
                limit = {"materials": 1e-3, "fractal": 5e-4, "erosion": 5e-4}.get(column, 1e-4) if compiler == "fxc" else 1e-4
                # Normals jump at threads, where rounding decides: leaves out one pixel in 1000.
                error = (np.quantile(difference, 0.999) if column == "materials" else difference.max()) / known.std()
            print(f"{engine}, {compiler}: {name}, {kind}: largest difference {error:.2g} at row and column {at}", file=sys.stderr, flush=True)
            if not error < limit:
                sys.exit(f"{node.name} differs by more than {limit:g}")
            errors[column] = max(errors.get(column, 0.0), float(error))
    said = {"dxc": "HLSL by DXC", "fxc": "HLSL by FXC"}[compiler]
    report(path, pictures[0], {"unity": "Unity's functions", "unreal": "Unreal's Custom node"}[engine], "-", said, driver, functions=errors)


main()
