"""Files that contain drop-ins or their translations unchanged: pages, nodes, bundles, and the program's table of materials.
tools/translate calls this module."""

import json
import math
import pathlib
import re

import glsl

ROOT = pathlib.Path(__file__).resolve().parents[1]
NODES = ROOT / "shaders" / "nodes"
TRANSLATIONS = ROOT / "shaders" / "translations"

# The drop-ins in each single-file bundle.
BUNDLES = {
    "noise": ["gabor_noise"],
    "materials": ["gabor_noise", "gabor_spectrum", "gabor_materials"],
    "noise_3d": ["gabor_noise", "gabor_spectrum", "gabor_noise_3d"],
    "direction": ["gabor_noise", "gabor_direction"],
    "erosion": ["gabor_noise", "gabor_erosion"],
}
# Files that contain a drop-in between two marker lines.
# Files that contain a drop-in between two marker lines.
BETWEEN = r"(// ---- (gabor_\w+\.\w+) unchanged ----\n)(?:.*\n)*?()(?=// ---- (?:gabor_\w+\.\w+ unchanged|your code) ----\n)"
IN_PAGE = r'(<script type="text/plain" id="((?:gabor_\w+|yardsticks)\.\w+)">\n)(?:.*\n)*?(</script>\n)'
EMBEDDING = {
    "shaders/nodes/shadertoy/gabor_noise.frag": BETWEEN,
    "shaders/nodes/shadertoy/gabor_erosion.frag": BETWEEN,
    "docs/demo/index.html": IN_PAGE,
    "docs/benchmark.html": IN_PAGE,
}
# Material Maker's nodes are JSON.
MATERIAL_MAKER = NODES / "material_maker" / "gabor_noise.mmg"
# Files of nodes that are unchanged copies of translations.
COPIES = {
    "shaders/nodes/unity/gabor_noise.hlsl": "shaders/translations/gabor_noise.hlsl",
    "shaders/nodes/slang/gabor_noise.slang": "shaders/translations/gabor_noise.hlsl",
    "shaders/nodes/unreal/gabor_noise.ush": "shaders/translations/gabor_noise.hlsl",
    "shaders/nodes/godot/addons/gabor_noise/gabor_noise.gdshaderinc": "shaders/translations/gabor_noise.gdshaderinc",
}
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
    """Yields the path and text of each module."""
    texts = {module: (TRANSLATIONS / f"{name}.wgsl").read_text() for module, (name, _) in MODULES.items()}
    defined = {module: re.findall(r"^(?:fn|struct|const) (\w+)", text, re.MULTILINE) for module, text in texts.items()}
    for module, (name, needed) in MODULES.items():
        used = set(re.findall(r"\b[Gg]abor_?\w+|\bGABOR_\w+", re.sub("//.*", "", texts[module]))) - set(defined[module])
        imports = "".join(f"#import gabor_noise::{other}::{{{', '.join(names)}}}\n" for other in needed
                          if (names := [name for name in defined[other] if name in used]))
        text = re.sub(" Paste or include it after .*|\n// Digest of .*", "", texts[module])
        yield NODES / "bevy" / f"{module}.wgsl", f"#define_import_path gabor_noise::{module}\n{imports}\n{text}"


def material_rows(tree):
    """Returns the program's table of the materials' parameters, with angles in degrees."""
    lines = ["// Generated from shaders/gabor_materials.glsl by tools/translate: change that file, not this one."]
    for function in tree.items:
        if function.kind != "function" or not function.name.text.endswith("_default"):
            continue
        call = function.body.parts[0].parts[0]
        for field, value in zip((field for line in call.callee.parts for field in line.parts), call.parts):
            numbers = [float(node.name.text) for node in value.walk() if node.kind == "number"]
            comment = next(comment.text for comment in tree.comments if comment.line == field.line).removeprefix("// ")
            about, low, high, radians = re.fullmatch(r"(?:(.*?)(?:, |$))??(?:(\S+) to (\S+)( radians)?)?", comment).groups()
            row, bounds = "colour", ["0", "1"]
            if field.type == "float":
                row, bounds = "number", [low, high]
            if radians:
                row, bounds = "angle", [f"{math.degrees(float(bound)):.0f}" for bound in bounds]
                numbers = [round(math.degrees(numbers[0]), 2)]
            member, material = field.name.text, function.name.text.removeprefix("gabor_").removesuffix("_default").replace("_", "-")
            about = about or member
            about = f"{member} {about}" if about.startswith("of ") else about
            lines.append(f'{{"{material}.{member}", Kind::{row}, {{{", ".join(bounds)}}}, '
                         f'{{{", ".join(f"{number:g}" for number in numbers)}}}, "{about[0].upper() + about[1:]}"}},')
    return "\n".join(lines) + "\n"


def made(shader, plain, wgsl, missing):
    """Yields the path and text of each file. `shader` returns the syntax tree of a drop-in, `plain` prints it without precision
    statements, and `wgsl` translates it, or raises the exception `missing`."""
    yield ROOT / "host" / "render" / "material_rows.inc", material_rows(shader("gabor_materials"))
    yield from bevy_modules()
    for path, original in COPIES.items():
        yield ROOT / path, (ROOT / original).read_text()
    node, noise = json.loads(MATERIAL_MAKER.read_text()), shader("gabor_noise")
    node["shader_model"]["global"] = plain(noise).text(noise.start)
    yield MATERIAL_MAKER, json.dumps(node, indent="\t") + "\n"

    def filled(match):
        try:
            return match[1] + embedded(match[2]) + match[3]
        except missing:  # without naga, keep the existing text
            return match[0]

    def embedded(name):
        """Returns a drop-in, in the language of the file's extension."""
        if name == "yardsticks.wgsl":
            return wgsl("yardsticks")
        return (TRANSLATIONS / name).read_text() if name.endswith(".wgsl") else shader(name.removesuffix(".glsl")).text

    for path, pattern in EMBEDDING.items():
        yield ROOT / path, re.sub(pattern, filled, (ROOT / path).read_text())


def bundles(shader):
    """Yields the name and text of each bundle, with and without comments."""
    for bundle, names in BUNDLES.items():
        text = "\n".join(shader(name).text for name in names)
        notice = next(comment.text for comment in shader(names[0]).comments if comment.text.startswith("// Copyright"))
        lines = [line.rstrip() for line in glsl.without_comments(text).splitlines()]
        files = ", ".join(f"{name}.glsl" for name in names)
        yield f"gabor_bundle_{bundle}.glsl", text
        yield f"gabor_bundle_{bundle}.min.glsl", f"// {files}, without comments. {notice[3:]}\n" + "\n".join(filter(None, lines)) + "\n"
