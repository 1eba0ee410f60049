#!/bin/sh
# OpenImageIO's texture lookup blurs what it magnifies: at the centre of a pixel it does not return this pixel, and a
# checker pattern of single pixels keeps a ninth of its contrast, without any filter width or blur.
# Versions: OpenImageIO 3.2.2.0, numpy 2.2.6 (PyPI). Seen with Python 3.11.
# Surprise: the default, "smart bicubic", is a B-spline that smooths but does not interpolate. Lookups on the pixel
# grid, of zero width, on the finest level of detail, lose detail all the same; bilinear lookups return the pixels.
# Who is hit: renderers that read displacement, bump or noise through OpenImageIO (OSL's texture() among them): peaks
# become lower, and slopes of the finest detail flatter, than the file says.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" OpenImageIO==3.2.2.0 numpy==2.2.6
PYTHONPATH=$dir/py python3 - "$dir/checker.exr" <<'PY'
import sys
import numpy as np
import OpenImageIO as oiio

size = 64
checker = (np.indices((size, size)).sum(0) % 2).astype(np.float32)[..., None]
oiio.ImageBuf(checker).write(sys.argv[1])
textures = oiio.TextureSystem()


def contrast(options):
    values = [textures.texture(sys.argv[1], options, (x + 0.5) / size, (31 + 0.5) / size, 0, 0, 0, 0, 1)[0]
              for x in range(24, 40)]
    return max(values) - min(values)


default, bilinear = oiio.TextureOpt(), oiio.TextureOpt()
bilinear.interpmode = oiio.InterpMode.Bilinear
seen, line = contrast(default), contrast(bilinear)
print("OpenImageIO", oiio.VERSION_STRING)
print(f"contrast at pixel centres: expected 1; seen {seen:.4f} (bilinear {line:.4f})")
if abs(seen - 1 / 9) > 1e-4 or abs(line - 1) > 1e-4:
    sys.exit("the behaviour has changed")
PY
