"""Draws each material's exported maps under three lights in three.js, Blender's Cycles and MaterialX' renderer, and compares them
with the lit view of gabor: look.py PROGRAM PICTURE.jpg

`tools/test-engines three blender` installs what it needs. Differences are in levels of an 8-bit sRGB picture."""

import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image, ImageDraw, ImageFont

ENGINES = pathlib.Path(__file__).resolve().parent
ROOT = ENGINES.parents[1]
sys.path.insert(0, str(ENGINES.parent / "cli"))
from exr import Exr  # noqa: E402

program, sheet = map(pathlib.Path, sys.argv[1:])
MATERIALS = ("wood", "fabric", "leather", "marble", "sand", "ripples", "brushed-metal", "scratches", "zebra", "bark", "carbon-fibre",
             "strata")
LIGHTS = {"from the upper left": (-135, 38), "low from the right": (0, 15), "high": (90, 70)}
SIDE, SCALE = 320, 48
blender = os.environ.get("BLENDER_PYTHON", ROOT / "build" / "blender" / "bin" / "python")


def levels(light):
    light = np.clip(light, 0, 1)
    return 255 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def draw(engine, maps, values):
    lights = [f"{azimuth}/{elevation}" for azimuth, elevation in LIGHTS.values()]
    page = f"{(ENGINES / 'three' / 'material.html').relative_to(ROOT)}?maps=/{maps.relative_to(ROOT)}&lights={';'.join(lights)}"
    commands = {
        "three.js": ["node", ENGINES / "browser" / "run.mjs", "chrome", page, values],
        "three.js, open": ["node", ENGINES / "browser" / "run.mjs", "chrome", f"{page}&open=", values],
        "Cycles": [blender, "-B", ENGINES / "blender" / "material.py", maps, values, *lights],
        "MaterialX": ["xvfb-run", "-a", blender, "-B", ENGINES / "materialx" / "material.py", maps, values, *lights],
    }
    subprocess.run(list(map(str, commands[engine])), check=True, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
    return np.fromfile(values, "<f4").reshape(len(LIGHTS), SIDE, SIDE, 4)[..., :3].astype(float)


ENGINES_COMPARED = "three.js, open", "three.js", "Cycles", "MaterialX"
shown = {name: [] for name in ("gabor", *ENGINES_COMPARED)}
errors = {name: [] for name in ENGINES_COMPARED}
with tempfile.TemporaryDirectory(prefix="look-", dir=ROOT / "build") as scratch:
    scratch = pathlib.Path(scratch)
    for material in MATERIALS:
        common = ["--material", material, "--filter", "--size", f"{SIDE}x{SIDE}", "--scale", str(SCALE)]
        subprocess.run([program, "render", *common, "--maps", scratch / material], check=True, stdout=subprocess.DEVNULL)
        ours = []
        for azimuth, elevation in LIGHTS.values():
            subprocess.run([program, "render", *common, f"--light-azimuth={azimuth}", f"--light-elevation={elevation}", "-o",
                            scratch / "lit.exr"], check=True, stdout=subprocess.DEVNULL)
            channels = Exr(scratch / "lit.exr").channels
            ours.append(levels(np.dstack([channels[f"lit.{c}"] for c in "RGB"]).astype(float)))
        shown["gabor"].append(ours)
        for engine in ENGINES_COMPARED:
            theirs = levels(draw(engine, scratch / material, scratch / "values.raw"))
            shown[engine].append(theirs)
            difference = theirs - np.array(ours)
            errors[engine].append([(d.mean(), np.sqrt((d ** 2).mean())) for d in difference])
            print(f"{material:14} {engine:15}" + "".join(f"  mean {mean:+6.2f}, rms {rms:5.2f}" for mean, rms in errors[engine][-1]),
                  flush=True)

print("\n| renderer | light | mean difference | rms | worst material |\n| --- | --- | --- | --- | --- |")
for engine, found in errors.items():
    for i, light in enumerate(LIGHTS):
        means, rms = np.array(found)[:, i].T
        print(f"| {engine} | {light} | {means.mean():+.1f} | {np.sqrt((rms ** 2).mean()):.1f} "
              f"| {MATERIALS[rms.argmax()]}: {rms.max():.1f} |")

rows = "gabor", "three.js", "Cycles", "MaterialX"
chosen = [MATERIALS.index(name) for name in ("leather", "brushed-metal", "carbon-fibre", "fabric", "bark", "scratches")]
part = 160
picture = Image.new("RGB", (part * len(chosen), (part + 1) * len(rows) - 1))
pen = ImageDraw.Draw(picture)
for row, name in enumerate(rows):
    for column, material in enumerate(chosen):
        tile = np.round(shown[name][material][0][:part, :part]).astype(np.uint8)
        picture.paste(Image.fromarray(tile), (column * part, row * (part + 1)))
    pen.text((4, row * (part + 1) + 2), name, fill="white", stroke_width=2, stroke_fill="black", font=ImageFont.truetype("DejaVuSans.ttf", 13))
picture.save(sheet, quality=85)
