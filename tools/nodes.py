"""Generates the parts of shaders/nodes that come from the drop-ins: WGSL modules for Bevy, TSL for three.js, and MaterialX's library
in GLSL, OSL and MDL. The library has a few functions of gabor_noise.glsl, rewritten for languages without structs or unsigned
integers. tools/translate calls this module."""

import json
import pathlib
import re

from glsl import Printer, Refused, Shader, changes, without_comments

ROOT = pathlib.Path(__file__).resolve().parents[1]
NODES = ROOT / "shaders" / "nodes"
LIBRARY = NODES / "materialx" / "libraries" / "gabor"
COMMON = LIBRARY / "genglsl" / "lib" / "mx_gabor.glsl"
MANIFEST = NODES / "blender" / "gabor_noise" / "blender_manifest.toml"
OSL_SHADERS = NODES / "osl" / "gabor_noise.osl", NODES / "osl" / "gabor_erosion.osl"

# Functions that the library takes unchanged from the drop-in.
FUNCTIONS = ["gabor_impl_mix", "gabor_lobe_seed", "gabor_impl_salt", "gabor_impl_line_word", "gabor_impl_amplitude",
             "gabor_impl_product", "gabor_impl_half_turn", "gabor_impl_wave"]
TAKEN = "From gabor_noise.glsl", "End"
LICENSE = "// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT\n"


# ---- Bevy: WGSL with imports ---------------------------------------------------------------------------------------

# Each module's drop-in, and the modules that it imports.
MODULES = {
    "noise": ("gabor_noise", []),
    "spectrum": ("gabor_spectrum", ["noise"]),
    "noise_3d": ("gabor_noise_3d", ["noise", "spectrum"]),
    "materials": ("gabor_materials", ["noise", "spectrum"]),
    "erosion": ("gabor_erosion", ["noise"]),
    "direction": ("gabor_direction", ["noise"]),
}


def bevy_modules():
    """Yields the path and text of each module. naga_oil allows no override constants in modules."""
    texts = {module: (ROOT / "shaders" / "translations" / f"{name}.wgsl").read_text() for module, (name, _) in MODULES.items()}
    defined = {module: re.findall(r"^(?:fn|struct|const|override) (\w+)", text, re.MULTILINE) for module, text in texts.items()}
    for module, (name, needed) in MODULES.items():
        used = set(re.findall(r"\b[Gg]abor_?\w+|\bGABOR_\w+", re.sub("//.*", "", texts[module]))) - set(defined[module])
        imports = "".join(f"#import gabor_noise::{other}::{{{', '.join(names)}}}\n" for other in needed
                          if (names := [name for name in defined[other] if name in used]))
        text = re.sub(" Paste or include it after .*|\n// Digest of .*", "", re.sub("^override ", "const ", texts[module], flags=re.MULTILINE))
        yield NODES / "bevy" / f"{module}.wgsl", f"#define_import_path gabor_noise::{module}\n{imports}\n{text}"


# ---- MaterialX: GLSL without structs -------------------------------------------------------------------------------

class Library(Printer):
    """Gives the drop-in's functions MaterialX's names, and removes comments."""

    def word(self, word):
        return "mx_" + word.replace("gabor_impl_", "gabor_") if word.startswith("gabor_") else word

    def function(self, node):
        self.edit(node.closing.end, node.body.start, "\n")


def taken(lattice):
    """Returns the functions of the drop-in that the library takes."""
    found = {item.name.text: item for item in lattice.items if item.kind == "function"}
    return [found[name] for name in FUNCTIONS]


def constants(shader):
    """Returns the hash salts, and the factors that scale sums in the plane and in space to variance 1."""
    number = {name: macro.body[0].text for name, macro in shader("gabor_noise_3d").macros.items() if macro.body}
    deviation = float(number["GABOR_IMPL_DEVIATION"])
    return {"ROWS": number["GABOR_IMPL_ROWS"], "SLICES": number["GABOR_IMPL_SLICES"],
            "SCALE2D": f"{1 / (deviation * 1.125):.8g}", "SCALE3D": f"{1 / (deviation * 1.125**1.5):.8g}"}


def marked(text, marks, inner):
    """Returns the text with another part between two marks."""
    first, last = (f"// ---- {mark} ----\n" for mark in marks)
    before, _, rest = text.partition(first)
    return before + first + "\n" + inner + "\n" + last + rest.partition(last)[2]


def common(shader):
    """Returns the GLSL of the MaterialX library: the drop-in's functions and constants under MaterialX's names."""
    printer = Library(shader("gabor_noise"))
    text = "".join(f"#define MX_GABOR_{name} {number}\n" for name, number in constants(shader).items())
    text += "".join(f"\n{printer.text(item.start, item.end)}\n" for item in taken(printer.shader))
    return marked(COMMON.read_text(), TAKEN, without_comments(text))


class Integers(Printer):
    """Replaces uint by int, which behaves identically except for >>, and copies parameters that a function changes: OSL would
    change the caller's variable, and MDL forbids it."""

    def word(self, word):
        return "int" if word == "uint" else word

    def number(self, node):
        self.replace(node, node.name.text.rstrip("u"))

    def function(self, node):
        found = changes(node.body)
        if all(part.how == "in" for part in node.parameters):
            copied = [part for part in node.parameters if part in found]
            for part in copied:
                self.after(part, "_")
            if copied:
                self.edit(node.body.start + 1, node.body.start + 1, "".join(
                    f"\n    {self.word(part.type)} {part.name.text} = {part.name.text}_;" for part in copied))



def title(text, language):
    """Returns the header of a file's translation."""
    return (f"// Generated from ../genglsl{'/lib' if 'tools/translate' in text else ''} by tools/translate, for {language}: change "
            f"that file, not this one.\n//\n{LICENSE}\n")


# ---- The Open Shading Language -------------------------------------------------------------------------------------

OSL_RIGHT = """// Shifts an integer to the right as if it were unsigned.
int mx_gabor_right(int word, int bits)
{
    return (word >> bits) & ((1 << (32 - bits)) - 1);
}

"""


class Osl(Integers):
    """Turns vec2 and vec3 into vectors, and vec4 into MaterialX's struct."""

    def word(self, word):
        return {"vec2": "vector", "vec3": "vector", "vec4": "vector4", "out": "output"}.get(word, super().word(word))

    def function(self, node):
        super().function(node)
        if node.name.text == "mx_gabor_mix":
            self.before(node, OSL_RIGHT)

    def is_vector2(self, parameter):
        """Tells whether a parameter is one of a node, where vec2 becomes a struct."""
        return parameter.kind == "parameter" and parameter.type == "vec2" and parameter.function.type == "void"

    def parameter(self, node):
        if self.is_vector2(node):
            self.replace(node.type_name, "vector2")
        if node.how == "out":
            self.edit(node.start, node.type_name.start, "output ")

    def member(self, node):
        place = node.parts[0]
        if place.type in ("vec2", "vec3") and not (place.kind == "name" and self.is_vector2(place.declared)):
            self.edit(place.end, node.end, f"[{'xyz'.index(node.name.text)}]")

    def call(self, node):
        if node.name.text == "vec2":
            self.edit(node.closing.start, node.closing.start, ", 0")

    def binary(self, node):
        if node.sign.text == ">>":
            self.before(node, "mx_gabor_right(")
            self.edit(node.parts[0].end, node.parts[1].start, ", ")
            self.after(node, ")")


def osl(shader):
    start = min(place.start for place in shader.directives + shader.items)
    return Osl(shader).text(start).replace('.glsl"', '.osl"')


def osl_shader(path, library):
    """Returns a shader of shaders/nodes/osl with the library's functions, under the drop-in's names, between its marker lines."""
    functions = library[library.index("#define"):].replace("MX_GABOR", "GABOR_IMPL").replace("mx_gabor_", "gabor_impl_")
    return marked(path.read_text(), ("From MaterialX's library", "End"), functions.replace("// ---- End ----\n\n", ""))


# ---- MDL -----------------------------------------------------------------------------------------------------------

class Mdl(Integers):
    """Turns a node's output parameter into its return value."""

    def word(self, word):
        number = self.shader.macros.get(word)
        return self.signed(number.body[0].text) if number else f"float{word[3]}" if word in ("vec2", "vec3", "vec4") else (
            "rsqrt" if word == "inversesqrt" else super().word(word))

    def signed(self, text):
        if not text.startswith("0x"):
            return text.rstrip("u")
        number = int(text.rstrip("u"), 16)
        return str(number - (number >> 31 << 32))

    def number(self, node):
        self.replace(node, self.signed(node.name.text))

    def function(self, node):
        super().function(node)
        if node.type == "void":
            *given, result = node.parameters
            self.edit(node.start, node.name.start, f"export {self.word(result.type)} ")
            self.edit(given[-1].end, result.end, "")

    def assign(self, node):
        target = node.parts[0]
        if target.kind == "name" and getattr(target.declared, "how", "in") == "out":
            self.edit(node.start, node.parts[1].start, "return ")

    def binary(self, node):
        if node.sign.text == ">>":
            self.replace(node.sign, ">>>")


def mdl_variants():
    """Yields a node for each type, because MaterialX 1.39 does not import the MDL module for nodes inside graphs."""
    for dim, place, direction in (("2d", "float2 texcoord", "float orientation"),
                                  ("3d", "float3 position", "float3 direction")):
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


def mdl(shaders):
    """Returns one module with all nodes."""
    lines = "\n".join(Mdl(shader).text(shader.items[0].start) for shader in shaders).splitlines(keepends=True)
    whole = "".join(line for line in lines if not line.startswith("#")).replace("// ---- End ----\n\n", "")
    return "mdl 1.6;\n\nimport ::math::*;\n\n" + "\n".join([whole, *mdl_variants()]).lstrip("\n")


# ---- TSL, three.js's nodes in JavaScript -----------------------------------------------------------------------------

TSL = NODES / "three" / "gabor_noise.tsl.js"
METHODS = {"+": "add", "-": "sub", "*": "mul", "/": "div", "%": "mod", "&": "bitAnd", "|": "bitOr", "^": "bitXor", "<<": "shiftLeft",
           ">>": "shiftRight", "<": "lessThan", ">": "greaterThan", "<=": "lessThanEqual", ">=": "greaterThanEqual", "==": "equal",
           "!=": "notEqual", "&&": "and", "||": "or"}


class Tsl:
    """Turns a function of GLSL into one of JavaScript, in which operators are method calls."""

    def __init__(self, shader, function):
        self.shader, self.function, self.changed = shader, function, changes(function.body)

    def word(self, word):
        return "gabor_impl_lobe_seed" if word == "gabor_lobe_seed" else word

    def number(self, node, alone):
        text = node.name.text
        if node.type == "float":
            text = repr(float(text))
        elif node.type == "uint":
            return f"uint({text[:-1]})"
        return text if alone else f"float({text})"

    def expression(self, node, alone=True):
        """Returns an expression in JavaScript. If not alone, a method follows, so it must be a node of TSL."""
        parts = node.parts
        if node.kind == "number":
            return self.number(node, alone)
        if node.kind == "name":
            return node.name.text
        if node.kind == "group":
            return self.expression(parts[0], alone)
        if node.kind == "member":
            return f"{self.expression(parts[0])}.{node.name.text}"
        if node.kind == "unary" and node.sign.text == "-":
            return f"-{self.expression(parts[0])}" if parts[0].kind == "number" else f"{self.expression(parts[0], False)}.negate()"
        if node.kind == "call":
            return f"{self.word(node.name.text)}({', '.join(map(self.expression, parts))})"
        if node.kind == "choice":
            return f"select({', '.join(map(self.expression, parts))})"
        if node.kind == "binary":
            return f"{self.expression(parts[0], False)}.{METHODS[node.sign.text]}({self.expression(parts[1])})"
        raise Refused(self.shader.path, node.line, f"a {node.kind} has no translation to TSL")

    def lines(self):
        function = self.function
        given = [part.name.text + "_" * (part in self.changed) for part in function.parameters]
        yield f"const {self.word(function.name.text)} = ({', '.join(given)}) => {{"
        yield from (f"    let {name[:-1]} = {name}.toVar();" for name in given if name.endswith("_"))
        for statement in function.body.parts:
            if statement.kind == "return":
                yield f"    return {self.expression(statement.parts[0])};"
            elif statement.kind == "declare":
                for part in statement.parts:
                    yield f"    {'let' if part in self.changed else 'const'} {part.name.text} = {self.expression(part.value)}.toVar();"
            elif statement.kind == "expression" and statement.parts[0].kind == "assign" and statement.parts[0].parts[0].kind == "name":
                (left, right), sign = statement.parts[0].parts, statement.parts[0].sign.text[:-1]
                value = f"{left.name.text}.{METHODS[sign]}({self.expression(right)})" if sign else self.expression(right)
                yield f"    {left.name.text} = {value}.toVar();"
            else:
                raise Refused(self.shader.path, statement.line, f"a {statement.kind} has no translation to TSL")
        yield "};\n"


def tsl(shader):
    """Returns the module of TSL with the drop-in's constants and functions between its marker lines."""
    lattice = shader("gabor_noise")
    numbers = [f"const {name} = {number.removesuffix('u')};\n" for name, number in constants(shader).items()]
    text = "".join(numbers) + "\n" + "\n".join("\n".join(Tsl(lattice, function).lines()) for function in taken(lattice))
    return marked(TSL.read_text(), TAKEN, text)


# ---- Files ---------------------------------------------------------------------------------------------------------

def made(shader):
    """Yields the path and text of each file. `shader` returns the syntax tree of a drop-in."""
    glsl = common(shader)
    yield from bevy_modules()
    yield COMMON, glsl
    library = Shader(glsl, COMMON.relative_to(ROOT))
    yield from ((path, osl_shader(path, osl(library))) for path in OSL_SHADERS)
    version = json.loads((ROOT / "package.json").read_text())["version"]
    yield TSL, tsl(shader)
    yield MANIFEST, re.sub(r'(?m)^version = ".*"', f'version = "{version}"', MANIFEST.read_text())
    files = {COMMON: library} | {path: Shader(path.read_text(), path.relative_to(ROOT), [library]) for path in sorted(COMMON.parents[1].glob("*.glsl"))}
    for path, tree in files.items():
        yield (LIBRARY / "genosl" / path.relative_to(COMMON.parents[1])).with_suffix(".osl"), title(tree.text, "OSL") + osl(tree)
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", title(glsl, "MDL") + mdl(files.values())
