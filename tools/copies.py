"""Other files made from the drop-ins: the page and bundles that contain them, and the program's table of their structs'
members. tools/translate calls this module."""

import math
import pathlib
import re

import glsl

ROOT = pathlib.Path(__file__).resolve().parents[1]

# The drop-ins in each single-file bundle.
BUNDLES = {
    "noise": ["gabor_noise"],
    "filter": ["gabor_noise", "gabor_spectrum", "gabor_filter"],
    "materials": ["gabor_noise", "gabor_spectrum", "gabor_filter", "gabor_materials"],
    "noise_3d": ["gabor_noise", "gabor_noise_3d"],
    "direction": ["gabor_noise", "gabor_direction"],
    "erosion": ["gabor_noise", "gabor_erosion"],
}
# The page that contains drop-ins: it opens from disk, where a browser cannot read other files.
DEMO = ROOT / "docs" / "demo" / "index.html"
IN_PAGE = re.compile(r'(<script type="text/plain" id="(gabor_\w+)\.glsl">\n)(?:.*\n)*?(</script>\n)')


def struct_rows(*trees):
    """Returns the program's table of the parameters of materials and of erosion: the members of the structs, with the defaults that
    their functions return. A comment is "about, low to high, usually low to high: more"; angles become degrees."""
    lines = ["// Generated from gabor_materials.glsl and gabor_erosion.glsl by tools/translate: change those files, not this one."]
    for tree, function in ((tree, item) for tree in trees for item in tree.items if item.kind == "function"):
        name, made, _ = function.name.text.removeprefix("gabor_").partition("_default")
        if function.parameters or not function.name.text.endswith(("_default", "_erosion")):
            continue
        call = function.body.parts[0].parts[0]
        for field, value in zip((field for line in call.callee.parts for field in line.parts), call.parts):
            numbers = [float(node.name.text) for node in value.walk() if node.kind == "number"]
            comment = next(comment.text for comment in tree.comments if comment.line == field.line).removeprefix("// ")
            about, low, high, radians, usual_low, usual_high = re.fullmatch(
                r"(?:(.*?)(?:, |$))??(?:([-\d.]+) to ([-\d.]+)( radians)?)?(?:, usually (\S+) to ([\d.]+))?(?::.*)?", comment).groups()
            row = {"vec3": "colour", "int": "integer", "float": "angle" if radians else "number"}[field.type]
            bounds = [0, 1] if row == "colour" else [float(low), float(high)]
            if radians:
                bounds, numbers = [round(math.degrees(bound)) for bound in bounds], [round(math.degrees(numbers[0]), 2)]
            usual = [usual_low, usual_high] if usual_low else [-180, 180] if radians and bounds[0] < 0 else bounds
            member = field.name.text
            about = (about or member).replace("unit of p", "kernel radius")
            about = f"{member} {about}" if about.startswith("of ") else about
            option = f"{name.replace('_', '-')}.{member}" if made else {"frequency": "gully_frequency"}.get(member, member)
            braced = ("{" + ", ".join(f"{float(number):g}" for number in each) + "}" for each in (bounds, usual, numbers))
            lines.append(f'{{"{option}", Kind::{row}, {", ".join(braced)}, "{about[0].upper() + about[1:]}"}},')
    return "\n".join(lines) + "\n"


def made(shader):
    """Yields the path and text of each file. `shader` returns the syntax tree of a drop-in."""
    yield ROOT / "host" / "render" / "struct_rows.inc", struct_rows(shader("gabor_materials"), shader("gabor_erosion"))
    yield DEMO, IN_PAGE.sub(lambda match: match[1] + shader(match[2]).text + match[3], DEMO.read_text())


def bundles(shader):
    """Yields the name and text of each bundle, with and without comments."""
    for bundle, names in BUNDLES.items():
        text = "\n".join(shader(name).text for name in names)
        notice = next(comment.text for comment in shader(names[0]).comments if comment.text.startswith("// Copyright"))
        lines = [line.rstrip() for line in glsl.without_comments(text).splitlines()]
        files = ", ".join(f"{name}.glsl" for name in names)
        yield f"gabor_bundle_{bundle}.glsl", text
        yield f"gabor_bundle_{bundle}.min.glsl", f"// {files}, without comments. {notice[3:]}\n" + "\n".join(filter(None, lines)) + "\n"
