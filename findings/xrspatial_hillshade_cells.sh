#!/bin/sh
# xarray-spatial's hillshade ignores the size of cells: a map in metres is shaded the same with cells of 1 m
# and of 30 m, though its slopes differ by a factor of 30; slope() of the same package knows the difference.
# Versions: xarray-spatial 0.5.3, xarray 2026.9.0, numba 0.68.1, datashader 0.19.1, numpy 2.2.6 (PyPI); Python 3.11.
# Surprise: the map has coordinates and `res`, and slope() and curvature() use them. hillshade() assumes cells of size
# 1, so maps with cells of 30 m look far too steep, and the picture changes with the resolution.
# Who is hit: whoever shades elevation models or synthetic terrain, or compares shading between resolutions.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir" xarray-spatial==0.5.3 datashader==0.19.1 xarray==2026.9.0 numba==0.68.1 \
    numpy==2.2.6
PYTHONPATH=$dir NUMBA_CACHE_DIR=$dir/cache python3 - <<'PY'
import sys
import numpy as np
import xarray
import xrspatial

axis = np.arange(60.0)
heights = np.tile(20 * np.sin(axis / 6), (60, 1)).astype(np.float32)
shade, slope = [], []
for cell in (1.0, 30.0):
    terrain = xarray.DataArray(heights, dims=("y", "x"), coords={"y": axis * cell, "x": axis * cell},
                               attrs={"res": (cell, cell)})
    shade.append(float(xrspatial.hillshade(terrain)[30, 20]))
    slope.append(float(xrspatial.slope(terrain)[30, 20]))
print("xarray-spatial", xrspatial.__version__)
print(f"cells of 1 m and 30 m: slopes {slope[0]:.1f} and {slope[1]:.1f} degrees")
print(f"shading: expected two values; seen {shade[0]:.4f} and {shade[1]:.4f}")
if shade[0] != shade[1] or slope[0] - slope[1] < 60:
    sys.exit("the behaviour has changed")
PY
