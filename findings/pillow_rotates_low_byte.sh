#!/bin/sh
# Pillow rotates 16-bit images wrongly: with BILINEAR or BICUBIC, rotate() and transform() return the low byte of each
# value (1000 becomes 232), and between pixels a mixture of low and high bytes. resize() and NEAREST are right.
# Versions: Pillow 13.0.0, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: mode I;16 is what a 16-bit PNG opens as, and these filters, which do not support it, raise no error: the
# result has the right mode and size.
# Who is hit: whoever turns, shears or warps height maps and displacement maps, or augments data with 16-bit images.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir" Pillow==13.0.0 numpy==2.2.6
PYTHONPATH=$dir python3 - "$dir/flat.png" <<'PY'
import sys
import numpy as np
import PIL
from PIL import Image

Image.fromarray(np.full((65, 65), 1000, np.uint16)).save(sys.argv[1])
flat = Image.open(sys.argv[1])
print("Pillow", PIL.__version__, "mode", flat.mode)
print("a flat map of 1000, turned by 45 degrees: expected 1000 in the middle")
filters, seen = Image.Resampling, {}
for name in ("NEAREST", "BILINEAR", "BICUBIC"):
    turned = flat.rotate(45, getattr(filters, name))
    half = flat.transform((65, 65), Image.Transform.AFFINE, (1, 0, 0.5, 0, 1, 0), getattr(filters, name))
    smaller = flat.resize((40, 40), getattr(filters, name))
    seen[name] = tuple(int(image.getpixel((image.width // 2,) * 2)) for image in (turned, half, smaller))
    print(f"{name}: seen {seen[name][0]}; shifted by half a pixel {seen[name][1]}; resized {seen[name][2]}")
if seen != {"NEAREST": (1000, 1000, 1000), "BILINEAR": (232, 117, 1000), "BICUBIC": (232, 117, 1000)}:
    sys.exit("the behaviour has changed")
PY
