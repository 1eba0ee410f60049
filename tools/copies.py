"""Other files made from the drop-ins: the page that contains them, and the program's table of their structs' members.
tools/translate calls this module."""

import math
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
DROP_INS = sorted((ROOT / "shaders").glob("gabor_*.glsl"))
# The page that contains shaders: it opens from disk, where a browser cannot read other files.
DEMO = ROOT / "docs" / "demo" / "index.html"
IN_PAGE = re.compile(r'(<script type="text/plain" id="(\w+)\.glsl">\n)(?:.*\n)*?(</script>\n)')


def needed(path):
    """Returns the drop-ins that may come before one, in order: those whose guards it tests."""
    text = re.sub(r"#ifdef .*\n#error .*", "", path.read_text())  # this one must not come before it
    tested = re.findall(r"(GABOR_\w+)_GLSL", "".join(re.findall(r"^#(?:if|elif).*", text, re.MULTILINE)))
    others = [other for other in DROP_INS if other.stem in map(str.lower, tested) and other.stem != path.stem]
    return list(dict.fromkeys(each for other in others for each in [*needed(other), other]))


def struct_rows(*trees):
    """Returns the program's table of the parameters of materials, boards and erosion: the members of the structs, with the defaults that
    their functions return. A comment is "about, low to high, usually low to high: more"; angles become degrees."""
    lines = ["// Generated from gabor_materials.glsl, gabor_compose.glsl and gabor_erosion.glsl by tools/translate: change those files, not this one."]
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
    trees = {path.stem: shader(path) for path in DROP_INS}
    yield ROOT / "host" / "render" / "struct_rows.inc", struct_rows(*(trees[f"gabor_{name}"] for name in ("materials", "compose", "erosion")))
    texts = {name: tree.text for name, tree in trees.items()}
    texts |= {path.stem: path.read_text() for path in (ROOT / "shaders" / "passes").glob("*.glsl")}
    yield DEMO, IN_PAGE.sub(lambda match: match[1] + texts[match[2]] + match[3], DEMO.read_text())
