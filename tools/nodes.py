"""Generates the parts of shaders/nodes that are translations: TSL for three.js, and MaterialX's library in GLSL, OSL and MDL.
The library has a few functions of gabor_noise.glsl, rewritten for languages without structs or unsigned integers. tools/translate
calls this module."""

import pathlib

from glsl import SHAPES, Printer, Refused, Shader, changes, without_comments

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
    return (f"// Generated from ../genglsl{'/lib' if 'tools/translate' in tree.text else ''} by tools/translate, for {language}: change "
            f"that file, not this one.\n//\n{LICENSE}\n")


class Integers(Printer):
    """Replaces uint by int, which behaves identically except for >>. Copies parameters that a function changes, because OSL would
    change the caller's variable, and MDL forbids it."""

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
        copied = [part for part in node.parameters if part in changes(node) and not part.out]
        for part in copied:
            self.after(part, "_")
        self.edit(node.body.start + 1, node.body.start + 1, "".join(
            f"\n    {self.word(part.type)} {part.name.text} = {part.name.text}_;" for part in copied))


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
    for dim, place, direction in (("2d", "float2 texcoord", "float orientation"), ("3d", "float3 position", "float3 direction")):
        inputs = f"{place}, float frequency, {direction}, int seed"
        field = f"mx_gaborfield{dim}({', '.join(each.split()[1] for each in inputs.split(', '))})".replace("seed", "SEED")
        parts = [field.replace("SEED", f"mx_gaborseed(seed, -{index})" if index else "seed") + ".x" for index in range(4)]
        for kind, count, amplitude in (("float", 1, "float"), ("vector2", 2, "float2"), ("vector3", 3, "float3"),
                                       ("vector4", 4, "float4"), ("color3", 3, "float3")):
            for suffix, given in (("", amplitude), ("FA", "float"))[:2 if count > 1 else 1]:
                value = parts[0] if count == 1 else f"float{count}(" + ",\n        ".join(parts[:count]) + ")"
                value = f"amplitude * {value} + pivot"
                value, result = (f"color({value})", "color") if kind == "color3" else (value, f"float{count}".rstrip("1"))
                yield (f"export {result} mx_gabornoise{dim}_{kind}{suffix}({given} amplitude, float pivot, {inputs})\n"
                       f"{{\n    return {value};\n}}\n")


def mdl(trees):
    """Returns one module with all nodes."""
    whole = "\n".join([*(Mdl(tree).text(tree.items[0].start) for tree in trees), *mdl_variants()])
    return "mdl 1.6;\n\nimport ::math::*;\n\n" + whole.replace("// ---- End ----\n\n", "")


# ---- TSL, three.js's nodes in JavaScript -----------------------------------------------------------------------------

METHODS = {"+": "add", "-": "sub", "*": "mul", "/": "div", "&": "bitAnd", "|": "bitOr", "^": "bitXor", "<<": "shiftLeft", ">>": "shiftRight",
           "<": "lessThan", ">": "greaterThan", "<=": "lessThanEqual", ">=": "greaterThanEqual", "==": "equal", "!=": "notEqual"}
NAMES = {"gabor_lobe_seed": "gabor_impl_lobe_seed"}  # the module has a public function of the first name


def tsl_expression(node, alone=True):
    """Returns an expression in JavaScript, where operators are methods of nodes. If not alone, a method follows."""
    parts = node.parts
    if node.kind == "group":
        return tsl_expression(parts[0], alone)
    if node.kind == "number" and node.type == "uint":
        return f"uint({node.name.text[:-1]})"
    if node.kind == "number":
        number = repr(float(node.name.text)) if node.type == "float" else node.name.text
        return number if alone else f"float({number})"
    if node.kind == "name":
        return node.name.text
    if node.kind == "member":
        return f"{tsl_expression(parts[0])}.{node.name.text}"
    if node.kind == "unary" and node.sign.text == "-":
        return f"-{tsl_expression(parts[0])}" if parts[0].kind == "number" else f"{tsl_expression(parts[0], False)}.negate()"
    if node.kind == "call" or node.kind == "choice":
        return f"{NAMES.get(node.name.text, node.name.text) if node.kind == 'call' else 'select'}({', '.join(map(tsl_expression, parts))})"
    if node.kind == "binary" and node.sign.text in METHODS:
        return f"{tsl_expression(parts[0], False)}.{METHODS[node.sign.text]}({tsl_expression(parts[1])})"
    raise Refused(f"shaders/gabor_noise.glsl:{node.line}: this {node.kind} has no translation to TSL")


def tsl_function(function):
    changed = changes(function)
    names = [part.name.text + "_" * (part in changed) for part in function.parameters]
    yield f"const {NAMES.get(function.name.text, function.name.text)} = ({', '.join(names)}) => {{"
    yield from (f"    let {name[:-1]} = {name}.toVar();" for name in names if name.endswith("_"))
    for part in [part for statement in function.body.parts for part in (statement.parts if statement.kind in ("declare", "expression") else [statement])]:
        if part.kind == "return":
            yield f"    return {tsl_expression(part.parts[0])};"
        elif part.kind == "variable" and part.value:
            yield f"    {'let' if part in changed else 'const'} {part.name.text} = {tsl_expression(part.value)}.toVar();"
        elif part.kind == "assign" and part.parts[0].kind == "name":
            left, right = map(tsl_expression, part.parts)
            yield f"    {left} = {f'{left}.{METHODS[part.sign.text[0]]}({right})' if part.sign.text != '=' else right}.toVar();"
        else:
            tsl_expression(part)
    yield "};\n"


def tsl(shader):
    """Returns the module of TSL with the drop-in's constants and functions between its marker lines."""
    lines = [f"const {name} = {number.removesuffix('u')};" for name, number in constants(shader).items()] + [""]
    return between(TSL, "From gabor_noise.glsl", "\n".join(lines + [line for function in taken(shader("gabor_noise")) for line in tsl_function(function)]))


# ---- Files ---------------------------------------------------------------------------------------------------------

def made(shader):
    """Yields the path and text of each file with code of the drop-ins. `shader` returns the syntax tree of a drop-in."""
    yield COMMON, common(shader)
    yield TSL, tsl(shader)


def packaged():
    """Yields the path and text of each file of MaterialX's library that only its package has."""
    library = Shader(COMMON.read_text(), COMMON.relative_to(ROOT))
    trees = [library, *(Shader(path.read_text(), path.relative_to(ROOT), library) for path in sorted(COMMON.parents[1].glob("*.glsl")))]
    for tree in trees:
        path = (ROOT / tree.path).relative_to(COMMON.parents[1])
        yield (LIBRARY / "genosl" / path).with_suffix(".osl"), title(tree, "OSL") + osl(tree)
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", title(library, "MDL") + mdl(trees)
