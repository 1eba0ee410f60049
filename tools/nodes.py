"""Generates the parts of shaders/nodes that are translations: MaterialX's library in GLSL, OSL and MDL, with a few
functions of gabor_noise.glsl for languages without structs or unsigned integers. tools/translate calls this module."""

import itertools
import pathlib
import re

from glsl import Printer, SHAPES, Shader, changes, without_comments

ROOT = pathlib.Path(__file__).resolve().parents[1]
LIBRARY = ROOT / "shaders" / "nodes" / "materialx" / "libraries" / "gabor"
COMMON = LIBRARY / "genglsl" / "lib" / "mx_gabor.glsl"
MARK, END = "// ---- From gabor_noise.glsl ----\n", "// ---- End ----\n"

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

    def parameter(self, node):
        if self.shader.before and node.type == "vec2":
            self.replace(node.type_name, "vector2")
        if node.out:
            self.edit(node.start, node.type_name.start, "output ")

    def member(self, node):
        super().member(node)
        vector, declared = node.parts[0], node.parts[0].declared
        of_node = self.shader.before and declared and declared.kind == "parameter"
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


def packaged():
    """Yields the path and text of each file of MaterialX's library that only its package has."""
    header = ("// Generated from ../genglsl by tools/translate: change those files, not this one.\n"
              "//\n// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT\n\n")
    library = Shader(COMMON.read_text(), COMMON.relative_to(ROOT))
    nodes = sorted(COMMON.parents[1].glob("*.glsl"))
    trees = [library, *(Shader(path.read_text(), path.relative_to(ROOT), library) for path in nodes)]
    for tree in trees:
        path = (LIBRARY / "genosl" / (ROOT / tree.path).relative_to(COMMON.parents[1])).with_suffix(".osl")
        text = Osl.start * (tree == library) + Osl(tree).text(tree.start).replace('.glsl"', '.osl"')
        yield path, header + text
    whole = "\n".join([*(Mdl(tree).text(tree.items[0].start) for tree in trees), *mdl_variants()])
    whole = whole.replace(END + "\n", "")
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", f"{header}mdl 1.6;\n\nimport ::math::*;\n\n{whole}"
