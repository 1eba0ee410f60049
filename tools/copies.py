"""Generates other files made from the drop-ins: the texts of the live page, and the program's tables of materials and of struct
members. tools/translate calls this module."""

import json
import math
import pathlib
import re

import glsl

ROOT = pathlib.Path(__file__).resolve().parents[1]
# gabor_float.glsl has the names of gabor_noise.glsl, and languages with integers do not need it.
DROP_INS = sorted(path for path in (ROOT / "shaders").glob("gabor_*.glsl") if path.stem != "gabor_float")
DEMO = ROOT / "docs" / "demo"


def needed(path):
    """Returns the drop-ins that may come before one, in order: those whose guards it tests."""
    text = re.sub(r"#ifdef .*\n#error .*", "", path.read_text())  # this one must not come before it
    tested = re.findall(r"(GABOR_\w+)_GLSL", "".join(re.findall(r"^#(?:if|elif).*", text, re.MULTILINE)))
    others = [other for other in DROP_INS if other.stem in map(str.lower, tested) and other.stem != path.stem]
    return list(dict.fromkeys(each for other in others for each in [*needed(other), other]))


def required(path):
    """Returns the drop-ins without which this one does not compile, and those that they require."""
    said = "".join(re.findall(r"#error Include (?!.* not both)(.*) before", path.read_text()))
    others = [other for other in needed(path) if re.search(rf"\b{other.name}", said)]
    return list(dict.fromkeys(each for other in others for each in [*required(other), other]))


def parameters(*trees):
    """Yields the parameters of materials, boards, erosion and the sea: the members of the structs that have a range, with the defaults
    that their functions return. A comment's first line is "about, low to high unit, usually low to high: more"; angles become degrees."""
    for tree, function in ((tree, item) for tree in trees for item in tree.items if item.kind == "function"):
        name, made, _ = function.name.text.removeprefix("gabor_").partition("_default")
        if function.parameters or not function.name.text.endswith(("_default", "_erosion", "_sea")):
            continue
        call = function.body.parts[0].parts[0]
        for field, value in zip((field for line in call.callee.parts for field in line.parts), call.parts):
            numbers = [float(node.name.text) for node in value.walk() if node.kind == "number"]
            comment = next(comment.text for comment in tree.comments if comment.line == field.line).removeprefix("// ")
            about, low, high, unit, usual_low, usual_high = re.fullmatch(
                r"(?:(.*?)(?:, |$))??(?:([-\d.]+) to ([-\d.]+)(?: (radians|metres per second|metres|seconds))?)?"
                r"(?:, usually (\S+) to ([\d.]+))?(?::.*)?", comment).groups()
            radians = unit == "radians"
            if low is None and field.type != "vec3":
                continue
            kind = {"vec3": "colour", "int": "integer", "float": "angle" if radians else "number"}[field.type]
            bounds = [0, 1] if kind == "colour" else [float(low), float(high)]
            if radians:
                bounds, numbers = [round(math.degrees(bound)) for bound in bounds], [round(math.degrees(numbers[0]), 2)]
            usual = [usual_low, usual_high] if usual_low else [-180, 180] if radians and bounds[0] < 0 else bounds
            member = field.name.text
            about = (about or member).replace("unit of p", "kernel radius")
            about = f"{member} {about}" if about.startswith("of ") else about
            option = f"{name.replace('_', '-')}.{member}" if made or name == "sea" else member
            yield option, kind, "degrees" if radians else unit or "", bounds, list(map(float, usual)), numbers, about[0].upper() + about[1:]


def struct_rows(*trees):
    """Returns the program's table of the parameters."""
    lines = ["// Generated from gabor_materials.glsl, gabor_compose.glsl, gabor_erosion.glsl and gabor_ocean.glsl by tools/translate: change those files, not this one."]
    for option, kind, unit, *numbers, about in parameters(*trees):
        braced = ("{" + ", ".join(f"{float(number):g}" for number in each) + "}" for each in numbers)
        lines.append(f'{{"{option}", Type::{kind}, "{unit}", {", ".join(braced)}, "{about}"}},')
    return "\n".join(lines) + "\n"


def material_rows(tree):
    """Returns the program's list of materials: the name without prefix of a function and the struct of its parameters, and the name for
    options."""
    lines = ["// Generated from gabor_materials.glsl by tools/translate: change that file, not this one."]
    for item in tree.items:
        if item.kind == "function" and item.name.text.endswith("_default"):
            name = item.name.text.removeprefix("gabor_").removesuffix("_default")
            lines.append(f'GABOR_MATERIAL({name}, {item.type}, "{name.replace("_", "-")}")')
    return "\n".join(lines) + "\n"


def controls(tree):
    """Returns the page's JSON for the controls of materials, or of boards."""
    return ",\n".join(json.dumps({"name": option, "kind": kind, "min": usual[0], "max": usual[1],
                                  "value": numbers if kind == "colour" else numbers[0], "about": about})
                      for option, kind, _, _, usual, numbers, about in parameters(tree))


def with_members(presets, pattern):
    """Returns the presets without what is no part of a picture's content: pixels and files."""
    return {name: {key: value for key, value in preset.items() if re.match(pattern, key)} for name, preset in presets.items()}


def data(of_materials, of_boards, of_erosion):
    """Returns the page's JSON: the controls of materials, boards and erosion, and the program's presets of materials and places."""
    presets = {path.stem: json.loads(path.read_text()) for path in sorted((ROOT / "host" / "render" / "request" / "presets").glob("*.json"))}
    materials = with_members({name: preset for name, preset in presets.items() if "material" in preset}, r"material|seed|boards|coat|finish|.*\.")
    places = {view: with_members({name: preset for name, preset in presets.items() if preset.get("view") == view}, "(?!view|width|height)")
              for view in ("landscape", "ocean")}
    parts = {"presets": materials, **places}
    listed = (f'"{part}": {{\n' + ",\n".join(f"{json.dumps(name)}: {json.dumps(preset)}" for name, preset in named.items()) + "}"
              for part, named in parts.items())
    return (f'{{"controls": [\n{controls(of_materials)}],\n"boards": [\n{controls(of_boards)}],\n"erosion": [\n{controls(of_erosion)}],\n'
            + ",\n".join(listed) + "}\n")


# What the page adds to drop-ins, in order, each after those before it; and macros. The page's sea has more bands than the translation.
PASSES = {
    ("gabor_fractal", "gabor_erosion"): ((), ["srgb", "ground", "ranges", "landscape"]),
    ("gabor_fractal", "gabor_ocean"): (("GABOR_OCEAN_BANDS=12",), ["srgb", "seascape"]),
    ("gabor_materials",): ((), ["room", "light", "srgb", "ball"]),
}
FIT = DEMO / "photograph.glsl"  # by gabor fit, of photograph.webp


def brief(text):
    """Returns a shader for the page: its first line, its license and the code, without the manual, other comments and includes."""
    title, code, license = text.partition("\n")[0], glsl.without_comments(text), re.search("// Copyright.*", text)
    code = re.sub(r"(?m)^#(?:ifndef|if !defined).*\n(?:#if .*\n)?#include .*\n(?:#endif\n)+", "", code)
    return "\n".join([title, *([license[0]] if license else []), *filter(None, code.split("\n"))]) + "\n"


def made(shader, translation):
    """Yields the path and text of each file. `shader` returns the syntax tree of a drop-in, and `translation` a file in a language, given
    its macros and the files before it."""
    trees = {path.stem: shader(path) for path in DROP_INS}
    parts = [trees[f"gabor_{name}"] for name in ("materials", "compose", "erosion", "ocean")]
    yield ROOT / "host" / "render" / "request" / "struct_rows.inc", struct_rows(*parts)
    yield ROOT / "host" / "render" / "request" / "material_rows.inc", material_rows(trees["gabor_materials"])
    shaders = ROOT / "shaders"
    sources = [*DROP_INS, *(shaders / "passes").glob("*.glsl"), *(shaders / "translations").glob("*.wgsl"),
               *(shaders / "translations").glob("*.hlsl"), *(shaders / "nodes" / "three").glob("*.js")]
    texts = {path.name: path.read_text() for path in sources} | {"presets.json": data(*parts[:3])}
    for names, (macros, passes) in PASSES.items():
        drop_ins = [shaders / f"{name}.glsl" for name in names]
        before = tuple(dict.fromkeys(each for path in drop_ins for each in (*needed(path), path)))
        for path in (shaders / "passes" / f"{each}.glsl" for each in passes):
            texts[f"{path.stem}.wgsl"] = translation(path, "wgsl", macros=macros, before=before)
            texts[f"{path.stem}.hlsl"] = translation(path, "hlsl", before=before)
            before = (*before, path)
        for path in drop_ins if macros else ():
            texts[f"{path.stem}.wgsl"] = translation(path, "wgsl", macros=macros, before=tuple(needed(path)))
    texts |= {FIT.name: FIT.read_text()} | {f"{FIT.stem}.{ending}": translation(FIT, ending) for ending in ("wgsl", "hlsl")}
    texts |= {name: brief(text) for name, text in texts.items() if name.endswith((".glsl", ".wgsl", ".hlsl"))}
    # A page opened from disk cannot read text files, but can load scripts.
    endings = "glsl", "wgsl", "hlsl"
    quoted = dict.fromkeys(re.findall(r'"(\w+)"', (DEMO / "page.js").read_text()))
    shown = [name for name in quoted if all(f"{name}.{ending}" in texts for ending in endings)]
    listed = []
    for name in (*(f"{name}.{ending}" for ending in endings for name in shown), "gabor_noise.tsl.js", "presets.json"):
        literal = re.sub(r"[`$\\]", r"\\\g<0>", texts[name])
        listed.append(f'"{name}": `{literal}`,\n')
    yield DEMO / "texts.js", f"// Generated by tools/translate: change the shaders, not this file.\nconst TEXTS = {{\n{''.join(listed)}}};\n"
