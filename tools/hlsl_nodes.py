"""Generates the nodes of Unity's and Unreal's packages from one table: HLSL for Unity's Custom Function nodes and for
Unreal's Custom nodes. Inputs shared with MaterialX's nodes come from the table of tools/nodes.py, and inputs of
materials and erosion from the structs of the drop-ins. tools/package and tools/unity.py call this module."""

import functools
import math
import pathlib
import re
import textwrap
from typing import NamedTuple

import copies
import glsl
import nodes

ROOT = pathlib.Path(__file__).resolve().parents[1]
UNITY, UNREAL = (ROOT / "shaders" / "nodes" / name for name in ("unity", "unreal"))
TRANSLATIONS = ROOT / "shaders" / "translations"


class Input(NamedTuple):
    name: str
    value: tuple  # the default: one number for each component
    low: float
    high: float
    about: str
    member: str = ""  # the member of the drop-in's struct that it sets
    cast: str = ""  # of that member, if it is an integer


class Node(NamedTuple):
    name: str
    file: str  # of Unity's package
    drop_in: str  # whose file, with those that it needs, has what the code calls
    about: str
    inputs: list
    outputs: dict  # the number of components of each
    code: str  # sets the outputs; `seed` is the seed, and FILTER stands for dx and dy, the pixel's steps of Place


def described(text, name=None, value=None, about=None):
    """Returns an input shared with MaterialX's nodes: "name type attributes"."""
    given = dict(re.findall(r'(\w+)="([^"]*)"', text))
    choices = zip(given.get("enumvalues", "").split(", "), given.get("enum", "").split(", "))
    words = about or ": ".join([*filter(None, [given.get("doc"), ", ".join(f"{number} {word}" for number, word in choices if number)])])
    high = given.get("uimax", given.get("uisoftmax", given.get("enumvalues", "16.0").split(", ")[-1]))
    return Input(name or given["uiname"].replace(" ", ""), (float(given["value"]) if value is None else value,), float(given.get("uimin", 0)),
                 float(high), words[0].lower() + words[1:])


PLACE = Input("Place", (0.0, 0.0), 0.0, 16.0, "position in kernel radii, for example texture coordinates times 8")
FREQUENCY, ORIENTATION = described(nodes.FREQUENCY), described(
    nodes.FLAT[2], value=0.7854, about="direction of the waves, in radians from x towards y")._replace(high=3.1416)
SEED = described(nodes.SEED, value=7.0, about="a whole number; each gives an independent noise")
WAVE = Input("Wave", (2.83, 2.83), 0.0, 16.0, "wave vector in cycles per kernel radius; it may follow a direction map")
SHARPNESS = Input("Sharpness", (2.0,), 0.0, 8.0, "full contrast where the intensity is above 1 / Sharpness")
PIXEL = Input("PixelSize", (0.0,), 0.0, 16.0, "sides of a pixel or distance of vertices, to leave out what is finer, 0 for none")
SUM = [described(each, {"diminish": "Gain"}.get(each.partition(" ")[0])) for each in nodes.SUM[:-1]]
SECONDS = Input("Seconds", (0.0,), 0.0, 3600.0, "time")
COURSE = [Input("Direction", (0.0,), 0.0, 6.2832, "where the wind and its waves go, in radians from x towards y", "direction"),
          Input("Loop", (0.0,), 0.0, 4096.0, "seconds after which all repeats, a power of 2 from 8, or 0", "loop_seconds", "(int)")]
FRACTAL = """GaborFractal fractal = gabor_fractal(Octaves, Gain);
fractal.lacunarity = Lacunarity;
fractal.shape = (int)(Shape + 0.5);
fractal.basis = (int)(Basis + 0.5);
FILTERGaborFractalNoise made = CALL;
Noise = made.noise;
Gradient = made.gradient;
"""
MATERIAL = """STRUCT given;
SETFILTERGaborMaterial made = gabor_NAME_filtered_at(Place, dx, dy, (float2)0.0, given, seed);
Colour = made.colour;
Normal = normalize(float3(-made.slope, 1.0));
Roughness = gabor_roughness(made);
Metalness = made.metalness;
Height = made.height;
"""
TERRAIN = """GaborErosion given;
SETGaborTerrainPlace ground;
ground.cell = (int2)0;
ground.local = Place;
ground.period = (float2)0.0;
float2 dx = float2(PixelSize, 0.0), dy = float2(0.0, PixelSize);
GaborTerrain made = gabor_eroded_at(ground, dx, dy, gabor_terrain_at(ground, dx, dy, seed), given, seed);
Height = made.height;
Slope = made.slope;
Ridge = made.ridge;
Cover = gabor_ground_cover(made);
"""
WATER = """GaborSea given;
SETGaborWater made = gabor_water_filtered(Place, float2(PixelSize, 0.0), float2(0.0, PixelSize), Seconds, gabor_ocean_of(given), seed);
Height = made.height;
Shift = made.shift;
Slope = made.slope;
Jacobian = made.jacobian;
"""


def files(drop_in):
    """Returns the paths of a drop-in and, before it, of those that it needs."""
    path = ROOT / "shaders" / f"gabor_{drop_in}.glsl"
    return [*copies.needed(path), path]


@functools.cache
def tree(*paths):
    """Returns the syntax tree of the last file."""
    *others, last = paths
    return glsl.Shader(last.read_text(), last, tree(*others) if others else None)


def members(owner):
    """Returns the inputs for the members of a struct, by copies.parameters."""
    shader = tree(*files({"": "erosion", "sea": "ocean"}.get(owner, "materials")))
    function = {"": "gabor_erosion", "sea": "gabor_sea"}.get(owner, f"gabor_{owner}_default")
    made = next(item for item in shader.items if item.kind == "function" and item.name.text == function).body.parts[0].parts[0]
    written = dict(zip(shader.structs[made.type].fields, made.parts))
    for option, kind, unit, bounds, _, numbers, about in copies.parameters(shader):
        of, _, member = option.rpartition(".")
        if of.replace("-", "_") == owner:
            if kind == "angle":  # rounded to degrees, it would miss the drop-in's default in the last bit, and scratches would end elsewhere
                bounds = [math.radians(min(max(each, -360), 360)) for each in bounds]  # of a slider
                numbers, unit = [float(node.name.text) for node in written[member].walk() if node.kind == "number"], "radians"
            about += f", in {unit}" if unit else ""
            name = "".join(word.capitalize() for word in member.split("_"))
            name = f"Base{name}" if name in ("Colour", "Roughness") else name  # which outputs are called
            yield Input(name, tuple(float(f"{each:.8g}") for each in numbers), *map(float, bounds),
                        (about[0].lower() + about[1:]).replace("kernel radius", "unit"), member, "(int)" if kind == "integer" else "")


def setting(inputs):
    return "".join(f"given.{each.member} = {each.cast}{each.name};\n" for each in inputs if each.member)


@functools.cache
def table():
    """Returns all nodes."""
    made = [
        Node("Noise", "Noise", "noise", "Gabor noise and its quadrature, whose waves are a quarter of a period ahead: each of mean 0 and variance 1",
             [PLACE, FREQUENCY, ORIENTATION, SEED], {"Noise": 1, "Quadrature": 1},
             "float2 made = gabor_noise_quadrature(Place, Frequency, Orientation, seed);\nNoise = made.x;\nQuadrature = made.y;\n"),
        Node("Stripes", "Noise", "noise", "Gabor noise, its gradient, and stripes of even contrast: cosine, sine and intensity",
             [PLACE, WAVE, SHARPNESS, SEED], {"Noise": 1, "Gradient": 2, "Stripes": 3},
             "GaborField made = gabor_field(gabor_place_at(Place), Wave, seed);\nNoise = made.noise;\nGradient = made.gradient;\n"
             "Stripes = gabor_stripes_of(made, Sharpness);\n"),
        *(Node(f"Fractal{' Filtered' * filtered}", "Noise", "fractal", f"fBm, billows or ridges, and their gradient{', averaged over the pixel' * filtered}",
               [PLACE, *SUM, SEED], {"Noise": 1, "Gradient": 2},
               FRACTAL.replace("FILTER", "FILTER" * filtered).replace("CALL", (
                   "gabor_fractal_noise_filtered(gabor_place_at(Place), dx, dy, fractal, seed)" if filtered else
                   "gabor_fractal_noise(gabor_place_at(Place), fractal, seed)"))) for filtered in (False, True))]
    unit = PLACE._replace(about="position in units, of which a picture of four by four shows the material well")
    names = [option.partition(".")[0] for option, *_ in copies.parameters(tree(*files("materials")))]
    for name in dict.fromkeys(each.replace("-", "_") for each in names):
        inputs = [*members(name)]
        words = name.replace("_", " ").title()
        made.append(Node(words, "Materials", "materials", f"the material {name.replace('_', ' ')}, averaged over the pixel",
                         [unit, *inputs, SEED], {"Colour": 3, "Normal": 3, "Roughness": 1, "Metalness": 1, "Height": 1},
                         MATERIAL.replace("STRUCT", "Gabor" + words.replace(" ", "")).replace("SET", setting(inputs)).replace("NAME", name)))
    inputs = [*members("")]
    made.append(Node("Terrain", "Terrain", "erosion", "eroded mountains: height, slope, ridge, and shares of grass, scree, rock and snow",
                     [PLACE._replace(about="position in units; hills are about four units wide"), PIXEL, *inputs, SEED],
                     {"Height": 1, "Slope": 2, "Ridge": 1, "Cover": 4}, TERRAIN.replace("SET", setting(inputs))))
    inputs = [*members("sea"), *COURSE]
    made.append(Node("Sea", "Sea", "ocean", "water whose place at rest is Place: height, horizontal shift, slope, and a jacobian that is lower where it folds",
                     [PLACE._replace(about="position in metres"), PIXEL, SECONDS, *(each._replace(member="") for each in inputs), SEED],
                     {"Height": 1, "Shift": 2, "Slope": 2, "Jacobian": 1}, WATER.replace("SET", setting(inputs))))
    return made


# ---- Unity ---------------------------------------------------------------------------------------------------------

def typed(kind, size):
    return kind + str(size) * (size > 1)


def indented(text):
    return textwrap.indent(text, "    ")


def in_unity(node):
    """Returns the functions of a node: Shader Graph calls that which has the suffix of the graph's precision."""
    name = f"Gabor{node.name.replace(' ', '')}"
    sizes = [(each.name, len(each.value)) for each in node.inputs]
    code = node.code.replace("FILTER", "float2 dx = ddx(Place), dy = ddy(Place);\n")
    def head(kind):
        listed = [f"{typed(kind, size)} {each}" for each, size in sizes] + [f"out {typed(kind, size)} {each}" for each, size in node.outputs.items()]
        return f"void {name}_{kind}({', '.join(listed)})\n"
    given = [f"({typed('float', size)}){each}" for each, size in sizes]
    local = "".join(f"{typed('float', size)} float_{each};\n" for each, size in node.outputs.items())
    back = "".join(f"{each} = ({typed('half', size)})float_{each};\n" for each, size in node.outputs.items())
    call = f"{name}_float({', '.join([*given, *(f'float_{each}' for each in node.outputs)])});\n"
    notes = "".join(f"//   {each.name + ' ':<20}{each.about}\n" for each in node.inputs)
    return (f"// {node.about[0].upper()}{node.about[1:]}.\n{notes}{head('float')}{{\n{indented('uint seed = (uint)(int)Seed;' + chr(10) + code)}}}\n"
            f"{head('half')}{{\n{indented(local + call + back)}}}\n")


def unity_files():
    """Yields the name and text of each file of HLSL in Unity's package."""
    for path in sorted(TRANSLATIONS.glob("*.hlsl")):
        yield path.name, path.read_text()
    for file in dict.fromkeys(node.file for node in table()):
        of = [node for node in table() if node.file == file]
        drop_ins = dict.fromkeys(path for node in of for path in files(node.drop_in))
        guard = f"GABOR_{file.upper()}_NODES_HLSL"
        includes = "".join(f'#include "{path.stem}.hlsl"\n' for path in drop_ins)
        yield f"Gabor{file}.hlsl", (
            "// Generated by tools/package: the functions that Shader Graph's Custom Function nodes call. Nodes that average over the pixel are\n"
            f"// for fragment stages alone.\n#ifndef {guard}\n#define {guard}\n\n{includes}\n" + "\n".join(map(in_unity, of)) + "\n#endif\n")


# ---- Unreal --------------------------------------------------------------------------------------------------------

INCLUDED = re.compile(r'^#ifndef \w+\n#include "\w+\.hlsl"\n#endif\n|^#if !defined\(\w+\) && defined\(__has_include\)\n(?:.*\n){3}#endif\n', re.MULTILINE)
FILTER = """#if PIXELSHADER
float2 dx = ddx(Place), dy = ddy(Place);
#else
float2 dx = 0.0, dy = 0.0;
#endif
"""


def number(value):
    return ", ".join(f"{each!r}" for each in value) if len(value) == 1 else f"float{len(value)}({', '.join(f'{each!r}' for each in value)})"


def in_unreal(node):
    """Returns the text of a Custom node. Members of structs, which are many, are numbers in its code."""
    inputs = [each for each in node.inputs if not each.member]
    code = node.code.replace("FILTER", FILTER)
    for each in node.inputs:
        if each.member:
            value = f"{each.value[0]:.0f}" if each.cast else number(each.value)
            code = code.replace(f"given.{each.member} = {each.cast}{each.name};", f"given.{each.member} = {value}; // {each.about}")
    first, *more = node.outputs
    listed = ", ".join(f"{each} (Float {node.outputs[each]})" for each in more)
    notes = "".join(f"//     {each.name + ' ':<18}{each.about}\n" for each in inputs)
    return (f"// {node.about[0].upper()}{node.about[1:]}.\n// Include File Paths: /Project/gabor_{node.drop_in}.ush\n"
            f"// Output Type: CMOT Float {node.outputs[first]}, the {first.lower()}. Additional Outputs: {listed or 'none'}\n// Inputs:\n{notes}"
            f"uint seed = (uint)(int)Seed;\n{typed('float', node.outputs[first])} {first};\n{code}return {first};\n")


def unreal_files():
    """Yields the name and text of each file of Unreal's package. A file has the texts that it needs, since Unreal looks for all files
    that are named."""
    for path in copies.DROP_INS:
        texts = [(TRANSLATIONS / f"{each.stem}.hlsl").read_text() for each in (*copies.needed(path), path)]
        yield UNREAL / f"{path.stem}.ush", "\n".join(INCLUDED.sub("", text) for text in texts)
    for node in table():
        yield UNREAL / f"Gabor {node.name}.hlsl", in_unreal(node)
