"""Generates MaterialX's library: functions in GLSL, OSL and MDL, some of them from gabor_noise.glsl for languages
without structs or unsigned integers; definitions; and graphs. tools/translate and tools/package call this module."""

import itertools
import pathlib
import re

from glsl import Printer, SHAPES, Shader, changes, without_comments

ROOT = pathlib.Path(__file__).resolve().parents[1]
LIBRARY = ROOT / "shaders" / "nodes" / "materialx" / "libraries" / "gabor"
COMMON = LIBRARY / "genglsl" / "lib" / "mx_gabor.glsl"
FRACTAL = COMMON.with_name("mx_gabor_fractal.glsl")
MARK, END = "// ---- From gabor_noise.glsl ----\n", "// ---- End ----\n"

# ---- Functions -----------------------------------------------------------------------------------------------------

# Functions that the library takes unchanged from the drop-in.
FUNCTIONS = ["gabor_impl_mix", "gabor_derived_seed", "gabor_impl_salt", "gabor_impl_line_word", "gabor_impl_amplitude",
             "gabor_impl_product", "gabor_impl_half_turn", "gabor_impl_wave"]
# GLSL's functions that OSL and MDL have, too.
PORTABLE = set("abs ceil clamp cos dot exp floor inversesqrt length log max min normalize pow sin sqrt".split())


class Integers(Printer):
    """Replaces uint by int, which behaves identically except for >>."""

    words = {"uint": "int"}

    def call(self, node):
        odd = node.what == "vector" and len(node.parts) != SHAPES[node.name.text][1]
        if odd or node.what in ("struct", "macro") or node.what == "builtin" and node.name.text not in PORTABLE:
            self.refuse(f"{node.name.text} with these arguments, to OSL or MDL,", node)

    def member(self, node):
        if len(node.name.text) > 1:
            self.refuse(f".{node.name.text}, to OSL or MDL,", node)

    def signed(self, number):
        value = int(number.rstrip("u"), 16) if number.startswith("0x") else 0
        return str(value - (value >> 31 << 32)) if value else number.rstrip("u")

    def number(self, node):
        self.replace(node, self.signed(node.name.text))

    def function(self, node):
        if any(part in changes(node) and not part.out for part in node.parameters):
            self.refuse("a change of a parameter, to OSL or MDL,", node)


class Osl(Integers):
    """Turns vec2 and vec3 into vectors, and vec4 into MaterialX's struct. A node's vec2 becomes a struct, too."""

    words = Integers.words | {"vec2": "vector", "vec3": "vector", "vec4": "vector4"}
    start = ("// Shifts an integer to the right as if it were unsigned.\nint mx_gabor_right(int word, int bits)\n"
             "{\n    return (word >> bits) & ((1 << (32 - bits)) - 1);\n}\n\n")

    @property
    def of_node(self):
        """Tells whether the file has the function of a node, not of the library."""
        return pathlib.PurePath(self.shader.path).parent.name != "lib"

    def parameter(self, node):
        if self.of_node and node.type == "vec2":
            self.replace(node.type_name, "vector2")
        if node.out:
            self.edit(node.start, node.type_name.start, "output ")

    def member(self, node):
        super().member(node)
        vector, declared = node.parts[0], node.parts[0].declared
        of_node = self.of_node and declared and declared.kind == "parameter"
        if vector.type == "vec3" or vector.type == "vec2" and not of_node:
            self.edit(vector.end, node.end, f"[{'xyz'.index(node.name.text)}]")

    def call(self, node):
        super().call(node)
        if node.name.text == "vec2":
            self.edit(node.end - 1, node.end - 1, ", 0")

    def binary(self, node):
        if node.sign.text == ">>":
            self.before(node, "mx_gabor_right(")
            self.edit(node.parts[0].end, node.parts[1].start, ", ")
            self.after(node, ")")


class Mdl(Integers):
    """Turns a node's output parameter into its return value, and writes the values of macros."""

    words = Integers.words | {"vec2": "float2", "vec3": "float3", "vec4": "float4", "inversesqrt": "rsqrt"}

    def macro_name(self, node):
        self.replace(node, self.signed(self.shader.macros[node.name.text].body[0].text))

    def function(self, node):
        super().function(node)
        if node.type == "void":
            *_, last, result = node.parameters
            self.edit(node.start, node.name.start, f"export {self.word(result.type)} ")
            self.edit(last.end, result.end, "")

    def assign(self, node):
        if getattr(node.parts[0].declared, "out", False):
            self.edit(node.start, node.parts[1].start, "return ")

    def binary(self, node):
        if node.sign.text == ">>":
            self.replace(node.sign, ">>>")


def mdl_variants():
    """Yields a node for each type, because MaterialX 1.39 does not import the MDL module for nodes inside graphs."""
    kinds = ("float", 1), ("vector2", 2), ("vector3", 3), ("vector4", 4), ("color3", 3)
    for dim, place, along in ("2d", "2 texcoord", " orientation"), ("3d", "3 position", "3 direction"):
        inputs = f"float{place}, float frequency, float{along}, int seed"
        given = f"{place[2:]}, frequency, {along[1:].strip()}"
        seeds = ["seed", *(f"mx_gaborseed(seed, -{index})" for index in (1, 2, 3))]
        noises = [f"mx_gaborfield{dim}({given}, {seed}).x" for seed in seeds]
        for (kind, count), suffix in itertools.product(kinds, ("", "FA")):
            noise = ",\n        ".join(noises[:count])
            type = f"float{count}".rstrip("1")
            value = f"amplitude * {noise if count == 1 else f'{type}({noise})'} + pivot"
            result, value = ("color", f"color({value})") if kind == "color3" else (type, value)
            if count > 1 or not suffix:
                yield (f"export {result} mx_gabornoise{dim}_{kind}{suffix}({'float' if suffix else type} amplitude, "
                       f"float pivot, {inputs})\n{{\n    return {value};\n}}\n")


def made(shader):
    """Yields the path and text of the library in GLSL, with the drop-ins' functions and constants between two marks."""
    tree, space = (shader(ROOT / "shaders" / f"gabor_{name}.glsl") for name in ("noise", "noise_3d"))
    before, _, rest = COMMON.read_text().partition(MARK)
    constants = {name: space.macros[f"GABOR_IMPL_{name}"].body[0].text for name in ("ROWS", "SLICES", "DEVIATION")}
    scale = 1 / (1.125 * float(constants.pop("DEVIATION")))  # gives the sum in the plane the variance 1
    constants |= {"SCALE2D": f"{scale:.8g}", "SCALE3D": f"{scale / 1.125**0.5:.8g}"}
    text = "".join(f"#define MX_GABOR_{name} {number}\n" for name, number in constants.items())
    functions = [tree.functions[name] for name in FUNCTIONS]
    text += "".join(f"\n{tree.text[node.start:node.end]}\n" for node in functions)
    text = re.sub(r"\bgabor_(impl_)?", "mx_gabor_", without_comments(text)).replace(" {", "\n{")
    yield COMMON, f"{before}{MARK}\n{text}\n{END}{rest.partition(END)[2]}"


# ---- Definitions and graphs ----------------------------------------------------------------------------------------

DOCUMENT = """<?xml version="1.0"?>
<materialx version="1.39">
  <!--
    Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT
{}  -->

{}</materialx>
"""
ABOUT = """
    Gabor noise on a lattice: positions are in kernel radii, frequencies in cycles per kernel radius. Only gaborfield2d, gaborfield3d,
    gaborfractalfield2d, gaborfractalfield3d and gaborseed have an implementation for each target; the other nodes are graphs of these.
"""
COUNTS = {"float": 1, "vector2": 2, "vector3": 3, "vector4": 4, "color3": 3, "color4": 4}
# The inputs of most nodes, as "name type attributes".
PIVOT = 'pivot float value="0.0" uiname="Pivot"'
FREQUENCY = 'frequency float value="4.0" uimin="0.0" uisoftmax="16.0" uiname="Frequency" doc="Cycles per kernel radius"'
SEED = 'seed integer value="0" uiname="Seed" doc="Each seed gives an independent noise"'
FLAT = ('texcoord vector2 defaultgeomprop="UV0" uiname="Texture Coordinates" doc="Position in kernel radii"', FREQUENCY,
        'orientation float value="45.0" unittype="angle" unit="degree" uisoftmin="0.0" uisoftmax="180.0" uiname="Orientation" '
        'doc="Direction of the wave vector, from x towards y"', SEED)
SOLID = ('position vector3 defaultgeomprop="Pobject" uiname="Position" doc="Position in kernel radii"', FREQUENCY,
         'direction vector3 value="1.0, 1.0, 1.0" uiname="Direction" doc="Direction of the wave vector, of any length"', SEED)
SUM = ('octaves float value="5.0" uimin="1.0" uimax="16.0" uiname="Octaves" doc="The last octave fades in with the fraction"',
       'lacunarity float value="2.0" uimin="1.0" uimax="4.0" uiname="Lacunarity" doc="Frequency of an octave relative to the previous one"',
       'diminish float value="0.5" uimin="0.0" uisoftmax="1.0" uiname="Diminish" doc="Amplitude of an octave relative to the previous one"',
       'shape integer value="0" enum="fBm, Billows, Ridges" enumvalues="0, 1, 2" uiname="Shape"',
       'basis integer value="0" enum="Smooth, Perlin" enumvalues="0, 1" uiname="Basis" doc="The noise of an octave"', SEED)
FLAT_SUM, SOLID_SUM = (FLAT[0], *SUM), (SOLID[0], *SUM)
# What nodes call their arguments, if not in, or in1, in2 and so on.
ARGUMENTS = {"extract": "in index", "constant": "value", "gaborseed": "seed index",
             "gaborfield2d": "texcoord frequency orientation seed", "gabornoise2d": "amplitude pivot texcoord frequency orientation seed",
             "gaborfield3d": "position frequency direction seed", "gabornoise3d": "amplitude pivot position frequency direction seed",
             "gaborfractalfield2d": "texcoord octaves lacunarity diminish shape basis seed",
             "gaborfractalfield3d": "position octaves lacunarity diminish shape basis seed"}


def several(kind, number):
    return ", ".join(COUNTS[kind] * [number])


def definition(name, group, about, inputs, outputs):
    """Returns a node's definition. Inputs are "name type attributes", and outputs "name type description"."""
    lines = [f'  <nodedef name="ND_{name}" node="{name.partition("_")[0]}" nodegroup="procedural{group}" version="1.0" isdefaultversion="true" '
             f'doc="{about}">']
    lines += ['    <input name="{}" type="{}" {} />'.format(*each.split(" ", 2)) for each in inputs]
    for name, kind, *about in (each.split(" ", 2) for each in outputs):
        default = "0" if kind == "integer" else several(kind, "0.0")
        lines.append(f'    <output name="{name}" type="{kind}" default="{default}"' + "".join(f' doc="{each}"' for each in about) + " />")
    return "\n".join([*lines, "  </nodedef>\n"])


def graph(name, inputs, outputs, nodes):
    """Returns a node's graph. Each of its nodes is "name type = category(argument; argument)": arguments are values, or names of
    inputs or of earlier nodes. Outputs have the names of nodes."""
    lines, kinds, made = [f'  <nodegraph name="NG_{name}" nodedef="ND_{name}">'], dict(each.split()[:2] for each in inputs), {}
    for name, kind, category, given in re.findall(r"(\w+) (\w+) = (\w+)\((.*?)\)", nodes):
        values = given.split("; ")
        names = ARGUMENTS[category].split() if category in ARGUMENTS else [f"in{k}" for k in (1, 2, 3, 4)] if len(values) > 1 else ["in"]
        lines.append(f'    <{category} name="N_{name}" type="{kind}">')
        for put, value in zip(names, values):
            if value in made | kinds:
                lines.append(f'      <input name="{put}" type="{(kinds | made)[value]}" '
                             + (f'nodename="N_{value}" />' if value in made else f'interfacename="{value}" />'))
            elif value:
                type = "integer" if put == "index" else kind if "," in value else "float"
                lines.append(f'      <input name="{put}" type="{type}" value="{value}" />')
        lines.append(f"    </{category}>")
        made[name] = kind
    lines += [f'    <output name="{name}" type="{kind}" nodename="N_{name}" />' for name, kind, *_ in map(str.split, outputs)]
    return "\n".join([*lines, "  </nodegraph>\n"])


def noises(dim, where, wave):
    """Yields a noise for each type. FA is for an amplitude that is one float, as for MaterialX's noise2d."""
    about = f"Gabor noise in {where}, times amplitude, plus pivot. The noise is normal, with mean 0 and variance 1 at every point"
    for (kind, count), suffix in itertools.product(COUNTS.items(), ("", "FA")):
        vector, noise = kind.replace("color", "vector"), f"gabornoise{dim}(AMPLITUDE; {ARGUMENTS[f'gabornoise{dim}'][10:].replace(' ', '; ')})"
        fields = [f"seed{k} integer = gaborseed(seed; -{k}) " * (k > 0) + f"field{k} vector4 = gaborfield{dim}("
                  + ARGUMENTS[f"gaborfield{dim}"].replace(" ", "; ") + f"{k or ''}) noise{k} float = extract(field{k}; 0) " for k in range(count)]
        if suffix:
            nodes = f"amplitudes {vector} = convert(amplitude) out {kind} = {noise.replace('AMPLITUDE', 'amplitudes')}"
        elif kind != vector:
            nodes = f"noise {vector} = {noise.replace('AMPLITUDE', 'amplitude')} out {kind} = convert(noise)"
        else:
            all = f"noise {kind} = combine{count}({'; '.join(f'noise{k}' for k in range(count))}) " * (count > 1)
            nodes = "".join(fields) + all + f"scaled {kind} = multiply(noise{'0' * (count == 1)}; amplitude) out {kind} = add(scaled; pivot)"
        if count > 1 or not suffix:
            type = "float" if suffix else vector
            yield (f"gabornoise{dim}_{kind}{suffix}", dim, about, [f'amplitude {type} value="{several(type, "1.0")}" uiname="Amplitude"', PIVOT, *wave],
                   [f"out {kind}"], nodes)


def described():
    """Yields the name, group, description, inputs, outputs and graph of each node. The first ones have source code instead."""
    yield "gaborfield2d", "2d", "Gabor noise, its quadrature, and the noise's derivatives along x and y per kernel radius", FLAT, ["out vector4"], ""
    yield "gaborfield3d", "3d", "Gabor noise in space, and its derivatives along x, y and z per kernel radius", SOLID, ["out vector4"], ""
    yield ("gaborseed", "", "The seed of one noise in a sum of independent noises", ['seed integer value="0"', 'index integer value="0"'],
           ["out integer"], "")
    yield ("gaborfractalfield2d", "2d", "fBm, billows or ridges, and their derivatives along x and y per kernel radius", FLAT_SUM, ["out vector3"], "")
    yield ("gaborfractalfield3d", "3d", "fBm, billows or ridges in space, and their derivatives along x, y and z per kernel radius", SOLID_SUM,
           ["out vector4"], "")
    yield from noises("2d", "the plane", FLAT)
    yield from noises("3d", "space", SOLID)
    mean, gradient = "noise float Mean 0 and variance 1", "Gradient of the noise, per kernel radius"
    yield ("gaborwave2d", "2d", "Gabor noise as a complex number, and its gradient", FLAT,
           [mean, "quadrature float The noise with cosines instead of sines; at each point the two are independent", f"gradient vector2 {gradient}"], """
           field vector4 = gaborfield2d(texcoord; frequency; orientation; seed)
           noise float = extract(field; 0) quadrature float = extract(field; 1) x float = extract(field; 2) y float = extract(field; 3)
           gradient vector2 = combine2(x; y)""")
    yield "gaborwave3d", "3d", "Gabor noise in space and its gradient", SOLID, [mean, f"gradient vector3 {gradient}"], """
           field vector4 = gaborfield3d(position; frequency; direction; seed)
           noise float = extract(field; 0) x float = extract(field; 1) y float = extract(field; 2) z float = extract(field; 3)
           gradient vector3 = combine3(x; y; z)"""
    yield "gaborfractal2d", "2d", "fBm, billows or ridges", FLAT_SUM, [mean, f"gradient vector2 {gradient}"], """
           field vector3 = gaborfractalfield2d(texcoord; octaves; lacunarity; diminish; shape; basis; seed)
           noise float = extract(field; 0) x float = extract(field; 1) y float = extract(field; 2) gradient vector2 = combine2(x; y)"""
    yield "gaborfractal3d", "3d", "fBm, billows or ridges in space", SOLID_SUM, [mean, f"gradient vector3 {gradient}"], """
           field vector4 = gaborfractalfield3d(position; octaves; lacunarity; diminish; shape; basis; seed)
           noise float = extract(field; 0) x float = extract(field; 1) y float = extract(field; 2) z float = extract(field; 3)
           gradient vector3 = combine3(x; y; z)"""
    streaks = "".join(f"""
           place{k} vector2 = multiply(texcoord; {0.3 + 0.12 * 2**k:g}, {9 * 2**k}) seed{k} integer = gaborseed(seed; {k})
           streak{k} vector4 = gaborfield2d(place{k}; 0.0; ; seed{k})
           relief{k} float = extract(streak{k}; 1) height{k} float = multiply(relief{k}; {0.0012 / 2**k:g}) tone{k} float = extract(streak{k}; 0)"""
                      for k in range(5))
    sums = " ".join(f"{each}s{k} float = add({each}{'s' * (k > 1)}{k - 1}; {each}{k})" for k in (1, 2, 3) for each in ("height", "tone"))
    yield ("gaborbrushedmetal", "2d", "Streaks along x, for a metalness of 1 and a roughness of 0.36: gabor_brushed_metal of gabor_materials.glsl",
           [FLAT[0].partition(" doc")[0], SEED.replace("an independent noise", "another piece of metal")],
           ["base_color color3", "height float In units of texcoord"], f"""{streaks}
           {sums} height float = add(heights3; height4) tones4 float = add(tones3; tone4)
           contrast float = multiply(tones4; 0.040249224) mean float = subtract(contrast; 0.00405) factor float = exp(mean)
           metal color3 = constant(0.55, 0.555, 0.565) bright color3 = multiply(metal; factor) base_color color3 = clamp(bright)""")
    yield ("gaborstripes2d", "2d", "Stripes of even contrast across the wave vector", [*FLAT[:3], 'sharpness float value="2.0" uimin="0.0" uisoftmax="8.0" '
           'uiname="Sharpness" doc="Stripes have full contrast where the intensity is above 1 / sharpness"', SEED.replace("noise", "pattern")],
           ["cosine float", "sine float", "intensity float Intensity of the waves before their contrast is evened out"], """
           field vector4 = gaborfield2d(texcoord; frequency; orientation; seed)
           y float = extract(field; 0) x float = extract(field; 1) wave vector2 = combine2(x; y) intensity float = magnitude(wave)
           length float = max(intensity; 1e-10) inverse float = divide(1.0; length) factor float = min(inverse; sharpness)
           cosine float = multiply(x; factor) sine float = multiply(y; factor)""")


def documents():
    """Yields the path and text of each of the library's documents."""
    nodes = [*described()]
    yield LIBRARY / "gabor_defs.mtlx", DOCUMENT.format(ABOUT, "".join(definition(*node[:-1]) for node in nodes))
    yield LIBRARY / "gabor_ng.mtlx", DOCUMENT.format("", "\n".join(graph(name, *rest) for name, _, _, *rest in nodes if rest[-1]))
    coded, of_mdl = [name for name, *_, last in nodes if not last], [name for name, *_ in nodes if re.match("gabornoise(?!.*color4)", name)]
    for target, names in {"genglsl": coded, "genosl": coded, "genmdl": coded + of_mdl}.items():
        file = "gabor/genmdl/mx_gabor.mdl" if target == "genmdl" else f"mx_{{0}}.{target[3:]}"
        line = f'  <implementation name="IM_{{0}}_{target}" nodedef="ND_{{0}}" file="{file}" function="mx_{{0}}" target="{target}" />\n'
        yield LIBRARY / target / f"gabor_{target}_impl.mtlx", DOCUMENT.format("", "".join(map(line.format, names)))


def packaged():
    """Yields the path and text of each file of MaterialX's library that only its package has."""
    header = ("// Generated from ../genglsl by tools/translate: change those files, not this one.\n"
              "//\n// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT\n\n")
    library = Shader(COMMON.read_text(), COMMON.relative_to(ROOT))
    trees = [library]
    for path in (FRACTAL, *sorted(COMMON.parents[1].glob("*.glsl"))):
        trees.append(Shader(path.read_text(), path.relative_to(ROOT), trees[min(len(trees), 2) - 1]))
    for tree in trees:
        path = (LIBRARY / "genosl" / (ROOT / tree.path).relative_to(COMMON.parents[1])).with_suffix(".osl")
        text = Osl.start * (tree == library) + Osl(tree).text(tree.start).replace('.glsl"', '.osl"')
        yield path, header + text
    whole = "\n".join([*(Mdl(tree).text(tree.items[0].start) for tree in trees), *mdl_variants()])
    whole = whole.replace(END + "\n", "")
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", f"{header}mdl 1.6;\n\nimport ::math::*;\n\n{whole}"
    yield from documents()
