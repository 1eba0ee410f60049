"""Generates the parts of shaders/nodes that are translations: TSL for three.js, and MaterialX's library in GLSL, OSL
and MDL, with a few functions of gabor_noise.glsl for languages without structs or unsigned integers. tools/translate
calls this module."""

import itertools
import pathlib

from glsl import COMPARISONS, Printer, Refused, SHAPES, Shader, changes, without_comments

ROOT = pathlib.Path(__file__).resolve().parents[1]
NODES = ROOT / "shaders" / "nodes"
LIBRARY = NODES / "materialx" / "libraries" / "gabor"
COMMON = LIBRARY / "genglsl" / "lib" / "mx_gabor.glsl"
TSL = NODES / "three" / "gabor_noise.tsl.js"
LICENSE = "// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT\n"

# Functions that the library takes unchanged from the drop-in.
FUNCTIONS = ["gabor_impl_mix", "gabor_lobe_seed", "gabor_impl_salt", "gabor_impl_line_word", "gabor_impl_amplitude",
             "gabor_impl_product", "gabor_impl_half_turn", "gabor_impl_wave"]
# GLSL's functions that OSL and MDL have, too.
PORTABLE = set("abs ceil clamp cos dot exp floor inversesqrt length log max min normalize pow sin sqrt".split())


def taken(tree):
    """Returns these functions of the drop-in."""
    found = {item.name.text: item for item in tree.items if item.kind == "function"}
    if missing := [name for name in FUNCTIONS if name not in found]:
        raise Refused(f"{tree.path}:1: {missing[0]}, which MaterialX's library needs, is missing")
    return [found[name] for name in FUNCTIONS]


def between(path, mark, text):
    """Returns a file with another text between two marker lines."""
    before, first, rest = path.read_text().partition(f"// ---- {mark} ----\n")
    return f"{before}{first}\n{text}\n" + "".join(rest.partition("// ---- End ----\n")[1:])


# ---- MaterialX: GLSL without structs -------------------------------------------------------------------------------

class Library(Printer):
    """Gives the drop-in's functions MaterialX's names."""

    def word(self, word):
        return "mx_" + word.replace("gabor_impl_", "gabor_") if word.startswith("gabor_") else word

    def function(self, node):
        self.edit(node.head, node.body.start, "\n")


def constants(shader):
    """Returns the hash salts, and the factors that scale sums in the plane and in space to variance 1."""
    number = {name: macro.body[0].text for name, macro in shader("gabor_noise_3d").macros.items() if macro.body}
    deviation = float(number["GABOR_IMPL_DEVIATION"])
    return {"ROWS": number["GABOR_IMPL_ROWS"], "SLICES": number["GABOR_IMPL_SLICES"],
            "SCALE2D": f"{1 / (deviation * 1.125):.8g}", "SCALE3D": f"{1 / (deviation * 1.125**1.5):.8g}"}


def common(shader):
    """Returns the GLSL of the MaterialX library: the drop-in's functions and constants under MaterialX's names."""
    printer = Library(shader("gabor_noise"))
    text = "".join(f"#define MX_GABOR_{name} {number}\n" for name, number in constants(shader).items())
    text += "".join(f"\n{printer.text(item.start, item.end)}\n" for item in taken(printer.shader))
    return between(COMMON, "From gabor_noise.glsl", without_comments(text))


def title(tree, language):
    """Returns the header of a file's translation."""
    folder = "../genglsl/lib" if "tools/translate" in tree.text else "../genglsl"
    return (f"// Generated from {folder} by tools/translate, for {language}: change that file, not this one.\n"
            f"//\n{LICENSE}\n")


class Integers(Printer):
    """Replaces uint by int, which behaves identically except for >>. Copies parameters that a function changes, because
    OSL would change the caller's variable, and MDL forbids it."""

    words = {"uint": "int"}

    def call(self, node):
        odd = node.what == "vector" and len(node.parts) != SHAPES[node.name.text][1]
        if odd or node.what in ("struct", "macro") or node.what == "builtin" and node.name.text not in PORTABLE:
            self.refuse(f"{node.name.text} with these arguments, to OSL or MDL,", node)

    def member(self, node):
        if len(node.name.text) > 1:
            self.refuse(f".{node.name.text}, to OSL or MDL,", node)

    def number(self, node):
        self.replace(node, node.name.text.rstrip("u"))

    def function(self, node):
        for part in [part for part in node.parameters if part in changes(node) and not part.out]:
            self.after(part, "_")
            copy = f"\n    {self.word(part.type)} {part.name.text} = {part.name.text}_;"
            self.edit(node.body.start + 1, node.body.start + 1, copy)


# ---- The Open Shading Language -------------------------------------------------------------------------------------

OSL_RIGHT = """// Shifts an integer to the right as if it were unsigned.
int mx_gabor_right(int word, int bits)
{
    return (word >> bits) & ((1 << (32 - bits)) - 1);
}

"""


class Osl(Integers):
    """Turns vec2 and vec3 into vectors, and vec4 into MaterialX's struct. A node's vec2 becomes a struct, too."""

    words = Integers.words | {"vec2": "vector", "vec3": "vector", "vec4": "vector4"}

    def function(self, node):
        super().function(node)
        if node.name.text == "mx_gabor_mix":
            self.before(node, OSL_RIGHT)

    def parameter(self, node):
        if node.function.type == "void" and node.type == "vec2":
            self.replace(node.type_name, "vector2")
        if node.out:
            self.edit(node.start, node.type_name.start, "output ")

    def member(self, node):
        super().member(node)
        declared = getattr(node.parts[0], "declared", node)
        in_node = declared.kind == "parameter" and declared.function.type == "void" and declared.type == "vec2"
        if node.parts[0].type in ("vec2", "vec3") and not in_node:
            self.edit(node.parts[0].end, node.end, f"[{'xyz'.index(node.name.text)}]")

    def call(self, node):
        super().call(node)
        if node.name.text == "vec2":
            self.edit(node.end - 1, node.end - 1, ", 0")

    def binary(self, node):
        if node.sign.text == ">>":
            self.before(node, "mx_gabor_right(")
            self.edit(node.parts[0].end, node.parts[1].start, ", ")
            self.after(node, ")")


def osl(tree):
    return Osl(tree).text(tree.start).replace('.glsl"', '.osl"')


# ---- MDL -----------------------------------------------------------------------------------------------------------

class Mdl(Integers):
    """Turns a node's output parameter into its return value, and writes the values of macros."""

    words = Integers.words | {"vec2": "float2", "vec3": "float3", "vec4": "float4", "inversesqrt": "rsqrt"}

    def signed(self, text):
        number = int(text.rstrip("u"), 16) if text.startswith("0x") else 0
        return str(number - (number >> 31 << 32)) if number else text.rstrip("u")

    def number(self, node):
        self.replace(node, self.signed(node.name.text))

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
        given = ", ".join(each.split()[1] for each in inputs.split(", ")[:-1])
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


def mdl(trees):
    """Returns one module with all nodes."""
    whole = "\n".join([*(Mdl(tree).text(tree.items[0].start) for tree in trees), *mdl_variants()])
    return "mdl 1.6;\n\nimport ::math::*;\n\n" + whole.replace("// ---- End ----\n\n", "")


# ---- TSL, three.js's nodes in JavaScript -----------------------------------------------------------------------------

METHODS = {sign: function for function, sign in COMPARISONS.items()} | {
    "+": "add", "-": "sub", "*": "mul", "/": "div", "&": "bitAnd", "|": "bitOr", "^": "bitXor", "<<": "shiftLeft",
    ">>": "shiftRight"}
RENAMED = {"gabor_lobe_seed": "gabor_impl_lobe_seed"}  # the module has a public function of the first name


def tsl_expression(node, alone=True):
    """Returns an expression in JavaScript, where operators are methods of nodes. If not alone, a method follows."""
    first, *others = node.parts or [None]
    if node.kind == "group":
        return tsl_expression(first, alone)
    if node.kind == "number" and node.type == "uint":
        return f"uint({node.name.text[:-1]})"
    if node.kind == "number":
        number = repr(float(node.name.text)) if node.type == "float" else node.name.text
        return number if alone else f"float({number})"
    if node.kind == "name":
        return node.name.text
    if node.kind == "member":
        return f"{tsl_expression(first)}.{node.name.text}"
    if node.kind == "unary" and node.sign.text == "-":
        return f"-{tsl_expression(first)}" if first.kind == "number" else f"{tsl_expression(first, False)}.negate()"
    if node.kind in ("call", "choice"):
        name = RENAMED.get(node.name.text, node.name.text) if node.kind == "call" else "select"
        return f"{name}({', '.join(map(tsl_expression, node.parts))})"
    if node.kind == "binary" and node.sign.text in METHODS:
        return f"{tsl_expression(first, False)}.{METHODS[node.sign.text]}({tsl_expression(*others)})"
    raise Refused(f"shaders/gabor_noise.glsl:{node.line}: this {node.kind} has no translation to TSL")


def tsl_statement(node, changed):
    """Returns a declaration, an assignment to a variable or a return statement; all others are refused."""
    if node.kind == "return":
        return f"    return {tsl_expression(*node.parts)};"
    if node.kind == "variable" and node.value:
        return f"    {'let' if node in changed else 'const'} {node.name.text} = {tsl_expression(node.value)}.toVar();"
    if node.kind == "assign" and node.parts[0].kind == "name":
        left, right = map(tsl_expression, node.parts)
        value = f"{left}.{METHODS[node.sign.text[:-1]]}({right})" if node.sign.text != "=" else right
        return f"    {left} = {value}.toVar();"
    raise Refused(f"shaders/gabor_noise.glsl:{node.line}: this {node.kind} has no translation to TSL")


def tsl_function(function):
    changed, name = changes(function), function.name.text
    names = [part.name.text + "_" * (part in changed) for part in function.parameters]
    yield f"const {RENAMED.get(name, name)} = ({', '.join(names)}) => {{"
    yield from (f"    let {name[:-1]} = {name}.toVar();" for name in names if name.endswith("_"))
    for node in function.body.parts:
        yield from [tsl_statement(part, changed) for part in (node.parts if node.kind == "declare" else [node])]
    yield "};\n"


def tsl(shader):
    """Returns the module of TSL with the drop-in's constants and functions between its marker lines."""
    lines = [f"const {name} = {number.removesuffix('u')};" for name, number in constants(shader).items()] + [""]
    for function in taken(shader("gabor_noise")):
        lines += tsl_function(function)
    return between(TSL, "From gabor_noise.glsl", "\n".join(lines))


# ---- Files ---------------------------------------------------------------------------------------------------------

def made(shader):
    """Yields the path and text of each file with code of the drop-ins. `shader` returns the syntax tree of a drop-in."""
    yield COMMON, common(shader)
    yield TSL, tsl(shader)


def packaged():
    """Yields the path and text of each file of MaterialX's library that only its package has."""
    library = Shader(COMMON.read_text(), COMMON.relative_to(ROOT))
    nodes = sorted(COMMON.parents[1].glob("*.glsl"))
    trees = [library, *(Shader(path.read_text(), path.relative_to(ROOT), library) for path in nodes)]
    for tree in trees:
        path = (ROOT / tree.path).relative_to(COMMON.parents[1])
        yield (LIBRARY / "genosl" / path).with_suffix(".osl"), title(tree, "OSL") + osl(tree)
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", title(library, "MDL") + mdl(trees)
