"""Generates the parts of shaders/nodes that are translations of their own: TSL for three.js, and MaterialX's library in GLSL, OSL
and MDL. The library has a few functions of gabor_noise.glsl, rewritten for languages without structs or unsigned
integers. tools/translate calls this module."""

import ast
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
NODES = ROOT / "shaders" / "nodes"
LIBRARY = NODES / "materialx" / "libraries" / "gabor"
COMMON = LIBRARY / "genglsl" / "lib" / "mx_gabor.glsl"

# Functions that the library takes unchanged from the drop-in.
FUNCTIONS = ["gabor_impl_mix", "gabor_lobe_seed", "gabor_impl_salt", "gabor_impl_line_word", "gabor_impl_amplitude",
             "gabor_impl_product", "gabor_impl_half_turn", "gabor_impl_wave"]
TAKEN = r"(// ---- From gabor_noise\.glsl ----\n)(?:.*\n)*?(// ---- End ----\n)"
FUNCTION = re.compile(r"^(?P<type>\w+) (?P<name>\w+)\((?P<parameters>[^)]*)\)\s*\{\n(?P<body>.*?)^\}\n",
                      re.MULTILINE | re.DOTALL)
LICENSE = "// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT\n"


# ---- Text ----------------------------------------------------------------------------------------------------------

def arguments(text, opening):
    """Finds the parenthesis that closes the one at `opening`, and the arguments between them."""
    depth, parts, start = 0, [], opening + 1
    for place in range(opening, len(text)):
        depth += (text[place] in "([{") - (text[place] in ")]}")
        if depth == 0 or depth == 1 and text[place] == ",":
            parts.append(text[start:place])
            start = place + 1
        if depth == 0:
            return place, parts
    raise ValueError(f"unclosed parenthesis: {text[opening:opening + 40]}")


def each_call(text, name, rewritten):
    """Replaces each call of a function whose name matches the pattern `name` by the result of rewritten(name, arguments)."""
    pattern, result, place = re.compile(rf"(?<![\w.])(?<!struct )({name})\("), "", 0
    while match := pattern.search(text, place):
        end, parts = arguments(text, match.end() - 1)
        result += text[place:match.start()] + rewritten(match[1], [each_call(part, name, rewritten) for part in parts])
        place = end + 1
    return result + text[place:]


# ---- MaterialX: GLSL without structs -------------------------------------------------------------------------------

def macro(source, name):
    return re.search(rf"#define {name} (\S+)", source)[1]


def constants(source):
    """Returns the hash salts, and the factors that scale sums in the plane and in space to variance 1."""
    lattice, others = source("gabor_noise"), source("gabor_spectrum") + source("gabor_noise_3d")
    deviation = float(macro(lattice, "GABOR_IMPL_DEVIATION"))
    return {"ROWS": macro(lattice, "GABOR_IMPL_ROWS"), "SLICES": macro(others, "GABOR_IMPL_SLICES"),
            "SCALE2D": f"{1 / (deviation * 1.125):.8g}", "SCALE3D": f"{1 / (deviation * 1.125**1.5):.8g}"}


def common(source):
    """Returns the GLSL of the MaterialX library: the drop-in's functions and constants under MaterialX's names."""
    lattice = source("gabor_noise")
    found = {match["name"]: match for match in FUNCTION.finditer(lattice)}
    text = "".join(f"#define MX_GABOR_{name} {number}\n" for name, number in constants(source).items())
    for name in FUNCTIONS:
        match = found[name]
        text += f"\n{match['type']} {name}({match['parameters']})\n{{\n{match['body']}}}\n"
    text = re.sub(r"\bgabor_(impl_)?", "mx_gabor_", re.sub(r" *//.*", "", text))
    return re.sub(TAKEN, lambda match: f"{match[1]}\n{text}\n{match[2]}", COMMON.read_text())


def integers(text, shifted):
    """Replaces uint by int, which behaves identically except for >>, and each >> by `shifted`."""
    text = re.sub(r"\buint\b", "int", re.sub(r"\b(0x[0-9a-f]+|\d+)u\b", r"\1", text))
    return re.sub(r"(\((?:[^()]|\([^()]*\))*\)|\w+) >> (\d+)", shifted, text)


def copied(parameters, body):
    """Copies parameters that the body assigns to: OSL would change the caller's variable, and MDL forbids it."""
    for kind, name in re.findall(r"(\w+) (\w+)(?:,|$)", parameters):
        if "out " not in parameters and re.search(rf"\b{name} [-+*/]?= ", body):
            parameters = re.sub(rf"\b{name}\b", f"{name}_", parameters)
            body = f"    {kind} {name} = {name}_;\n" + body
    return parameters, body


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


def osl_function(match):
    """Turns vec2 and vec3 into vectors, and vec4 into MaterialX's struct."""
    parameters, body = copied(match["parameters"], match["body"])
    if match["type"] == "void":
        parameters = re.sub(r"\bvec2\b", "vector2", parameters)
    text = f"{match['type']} {match['name']}({parameters})\n{{\n{body}}}\n"
    for name in set(re.findall(r"\bvec[23] (\w+)", text)):
        text = re.sub(rf"(?<![\w.]){name}\.([xyz])\b", lambda part: f"{name}[{'xyz'.index(part[1])}]", text)
    text = each_call(text, "vec2", lambda _, parts: f"vector({','.join(parts)}, 0)")
    text = each_call(text, "vec3", lambda _, parts: f"vector({','.join(parts)})")
    text = re.sub(r"\bvec4\b", "vector4", re.sub(r"\bvec[23]\b", "vector", text))
    return re.sub(r"\bout ", "output ", text)


def osl(text):
    body = integers(text[re.search("^(#|uint|void)", text, re.MULTILINE).start():], r"mx_gabor_right(\1, \2)")
    body = FUNCTION.sub(osl_function, body).replace(".glsl\"", ".osl\"")
    return body.replace("\nint mx_gabor_mix", "\n" + OSL_RIGHT + "int mx_gabor_mix")


# ---- MDL -----------------------------------------------------------------------------------------------------------

def signed(match):
    number = int(match[0], 16)
    return str(number - (number >> 31 << 32))


def mdl_function(match):
    """Copies parameters that are assigned to, and turns a node's output parameter into its return value."""
    node, parameters, body = match["type"] == "void", match["parameters"], match["body"]
    kind = match["type"]
    if node:
        parameters, _, kind = re.fullmatch(r"(.*), out ((\w+)) result", parameters).groups()
        body = body.replace("result = ", "return ")
    parameters, body = copied(parameters, body)
    text = f"{'export ' * node}{kind} {match['name']}({parameters})\n{{\n{body}}}\n"
    return re.sub(r"\bvec([234])\b", r"float\1", text).replace("inversesqrt(", "rsqrt(")


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


def mdl(texts):
    """Returns one module with all nodes."""
    whole = "\n".join(re.sub("(?:.*\n)*?(?=^(#define|uint|void))", "", text, count=1, flags=re.MULTILINE) for text in texts)
    whole = integers(whole, r"\1 >>> \2").replace("// ---- End ----\n\n", "")
    for name, number in re.findall(r"^#define (\w+) (\S+)\n", whole, re.MULTILINE):
        whole = re.sub(rf"\b{name}\b", number, re.sub(rf"^#define {name} .*\n", "", whole, flags=re.MULTILINE))
    whole = FUNCTION.sub(mdl_function, re.sub(r"\b0x[0-9a-f]+\b", signed, whole))
    whole = "\n".join([whole, *mdl_variants()])
    return "mdl 1.6;\n\nimport ::math::*;\n\n" + whole.lstrip("\n")


# ---- TSL, three.js's nodes in JavaScript -----------------------------------------------------------------------------

TSL = NODES / "three" / "gabor_noise.tsl.js"
METHODS = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.BitXor: "bitXor", ast.BitOr: "bitOr", ast.LShift: "shiftLeft",
           ast.RShift: "shiftRight", ast.Lt: "lessThan"}


def tsl_expression(text):
    """Turns an expression of GLSL into method calls. Python's parser can read it, because the operators are the same."""
    text = re.sub(r"\b(0x[0-9a-f]+|\d+)u\b", r"uint(\1)", text)
    text = re.sub(r"([^(),]+) \? ([^:]+) : ([^),]+)", r"(\2 if \1 else \3)", text)

    def emitted(node, alone=True):
        if isinstance(node, ast.Constant):
            number = f"{node.value:#x}" if isinstance(node.value, int) and node.value > 255 else repr(node.value)
            return number if alone else f"float({number})"
        if isinstance(node, ast.Name):
            return node.id
        if isinstance(node, ast.Attribute):
            return f"{emitted(node.value)}.{node.attr}"
        if isinstance(node, ast.UnaryOp):
            return f"{emitted(node.operand, False)}.negate()" if not isinstance(node.operand, ast.Constant) else f"-{node.operand.value}"
        if isinstance(node, ast.Call):
            return f"{node.func.id}({', '.join(map(emitted, node.args))})"
        if isinstance(node, ast.IfExp):
            return f"select({', '.join(map(emitted, (node.test, node.body, node.orelse)))})"
        left, right = (node.left, node.comparators[0]) if isinstance(node, ast.Compare) else (node.left, node.right)
        operator = node.ops[0] if isinstance(node, ast.Compare) else node.op
        return f"{emitted(left, False)}.{METHODS[type(operator)]}({emitted(right)})"

    return emitted(ast.parse(text.strip(), mode="eval").body)


def tsl_function(match):
    parameters, body = copied(match["parameters"], match["body"])
    lines = [f"const {match['name']} = ({', '.join(each.split()[1] for each in parameters.split(', '))}) => {{"]
    for statement in re.findall(r"\s*(.*?);", re.sub(r" *//.*", "", body), re.DOTALL):
        if returned := re.fullmatch(r"return (.*)", statement, re.DOTALL):
            lines.append(f"    return {tsl_expression(returned[1])};")
        elif declared := re.fullmatch(r"(?:float|vec2|uint|int) (\w+ = .*)", statement, re.DOTALL):
            for name, value in re.findall(r"(\w+) = (.*?)(?:, (?=\w+ = )|$)", declared[1], re.DOTALL):
                lines.append(f"    {'let' if re.search(rf'{name} [-+*]?= ', body.partition(value)[2]) else 'const'} {name} = "
                             f"{tsl_expression(value)}.toVar();")
        else:
            name, operator, value = re.fullmatch(r"(\w+) ([-+*]?)= (.*)", statement, re.DOTALL).groups()
            lines.append(f"    {name} = {tsl_expression(f'{name} {operator} ({value})' if operator else value)}.toVar();")
    return "\n".join([*lines, "};\n"])


def tsl(source):
    """Returns the module of TSL with the drop-in's constants and functions between its marker lines."""
    lattice = source("gabor_noise")
    found = {match["name"]: match for match in FUNCTION.finditer(lattice)}
    numbers = [f"const {name} = {number.removesuffix('u')};\n" for name, number in constants(source).items()]
    text = "".join(numbers) + "\n" + "\n".join(tsl_function(found[name]) for name in FUNCTIONS)
    text = text.replace("gabor_lobe_seed", "gabor_impl_lobe_seed")
    return re.sub(TAKEN, lambda match: f"{match[1]}\n{text}\n{match[2]}", TSL.read_text())


# ---- Files ---------------------------------------------------------------------------------------------------------

def made(source):
    """Yields the path and text of each file. `source` returns the text of a drop-in."""
    glsl = common(source)
    yield COMMON, glsl
    yield TSL, tsl(source)
    nodes = {path: path.read_text() for path in sorted(COMMON.parents[1].glob("*.glsl"))}
    for path, text in ({COMMON: glsl} | nodes).items():
        yield (LIBRARY / "genosl" / path.relative_to(COMMON.parents[1])).with_suffix(".osl"), title(text, "OSL") + osl(text)
    yield LIBRARY / "genmdl" / "mx_gabor.mdl", title(glsl, "MDL") + mdl([glsl, *nodes.values()])
