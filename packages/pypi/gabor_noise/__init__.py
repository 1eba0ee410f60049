"""Fast Gabor noise with unit variance, on numpy arrays and as shader source.

    import numpy as np, gabor_noise
    y, x = np.mgrid[0:512, 0:512] / 32.0                                      # 32 pixels per kernel radius
    n = gabor_noise.noise(x, y, frequency=4.0, orientation=np.pi / 4, seed=7)  # mean 0, variance 1, float32
    wgsl = gabor_noise.source("noise", "wgsl")                              # for wgpu, moderngl, vispy

Positions are in kernel radii and broadcast against each other; except in noise_3d, values are as precise far from the origin
as near it. A frequency is in cycles per kernel radius, an orientation in radians from +x towards +y; both may be arrays with
one value per point. A seed is any 32-bit integer. Values equal those of the shaders up to rounding. All functions use all
cores and return float32. They raise ValueError for shapes that do not broadcast.
"""

from __future__ import annotations

import importlib.resources
import inspect
import re
import struct
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native

__all__ = ["noise", "noise_gradient", "noise_complex", "noise_spread", "noise_filtered", "noise_3d", "stripes", "terrain",
           "source"]
__version__ = "@VERSION@"


def _points(*positions: ArrayLike, also: tuple[ArrayLike, ...] = ()) -> tuple[tuple[int, ...], list, list]:
    """Return the common shape, the positions as flat float64 arrays, and the parameters as flat float32 arrays, of length 1
    for scalars."""
    arrays = [np.asarray(position, np.float64) for position in positions]
    others = [np.asarray(other, np.float32) for other in also]
    shape = np.broadcast_shapes(*(array.shape for array in arrays + others))
    flat = [np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1) for array in arrays]
    return shape, flat, [other.reshape(1) if other.ndim == 0 else np.ascontiguousarray(np.broadcast_to(other, shape)).reshape(-1)
                         for other in others]


def _with_channels(values: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return the values in this shape, with a last axis for channels if there are several."""
    return values.reshape(shape) if len(values) == 1 else np.moveaxis(values.reshape(-1, *shape), 0, -1)


def _periods(period: ArrayLike | None) -> tuple[float, float]:
    x, y = np.broadcast_to(np.asarray(0.0 if period is None else period, float), 2)
    if not (np.isfinite([x, y]).all() and min(x, y) >= 0):
        raise ValueError(f"period is {period}: expected a number or a pair of numbers, 0 or more; 0 for no repetition")
    return float(x), float(y)


def _field(kind: int, x, y, frequency, orientation, seed: int, period, time) -> NDArray[np.float32]:
    shape, flat, parameters = _points(x, y, also=(frequency, orientation))
    values = _native.field(*flat, *parameters, seed & 0xFFFFFFFF, *_periods(period),
                           0.0 if time is None else float(time) % 1.0, kind)
    return _with_channels(values, shape)


def noise(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: int = 0,
          period: ArrayLike | None = None, time: float | None = None) -> NDArray[np.float32]:
    """Return Gabor noise at (x, y): mean 0, variance 1 at every point.

    period: kernel radii after which the pattern repeats exactly, one number or a pair for x and y; 0 for no repetition.
    time: time in an animation with period 1; None for no animation.
    """
    return _field(1, x, y, frequency, orientation, seed, period, time)


def noise_gradient(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: int = 0,
                   period: ArrayLike | None = None, time: float | None = None) -> NDArray[np.float32]:
    """Return (noise, d/dx, d/dy) along a last axis of 3. Arguments are those of `noise`."""
    return _field(3, x, y, frequency, orientation, seed, period, time)


def noise_complex(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: int = 0,
                  period: ArrayLike | None = None, time: float | None = None) -> NDArray[np.float32]:
    """Return (quadrature, noise) along a last axis of 2. The quadrature is the same pattern with its waves a quarter period
    ahead; arctan2(noise, quadrature) is the phase of stripes of even contrast. Arguments are those of `noise`."""
    return _field(2, x, y, frequency, orientation, seed, period, time)


def noise_spread(x: ArrayLike, y: ArrayLike, *, frequency: float = 4.0, orientation: float = 0.0,
                 frequency_spread: float = 0.0, orientation_spread: float = np.pi / 2, seed: int = 0) -> NDArray[np.float32]:
    """Return noise of waves within `orientation_spread` radians of the orientation (pi/2: all directions) and within the
    fraction `frequency_spread` (0 to 1) of the frequency. The cost grows with the number of waves: at frequency 2, all
    directions cost as much as 10 calls of `noise`."""
    shape, flat, _ = _points(x, y)
    return _native.spread(*flat, frequency, orientation, frequency_spread, orientation_spread, seed & 0xFFFFFFFF).reshape(shape)


def noise_filtered(x: ArrayLike, y: ArrayLike, pixel: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0,
                   seed: int = 0) -> NDArray[np.float32]:
    """Return (noise averaged over a pixel, share of the variance that averaging removed) along a last axis of 2.

    pixel: the pixel's sides in kernel radii, one number or a pair for x and y.
    """
    width_x, width_y = np.broadcast_to(np.asarray(pixel, float), 2)
    shape, flat, parameters = _points(x, y, also=(frequency, orientation))
    return _with_channels(_native.filtered(*flat, float(width_x), float(width_y), *parameters, seed & 0xFFFFFFFF), shape)


def noise_3d(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, frequency: float = 4.0,
             direction: tuple[float, float, float] | None = None, seed: int = 0) -> NDArray[np.float32]:
    """Return solid noise at (x, y, z), with waves along `direction`, or in all directions if it is None."""
    shape, flat, _ = _points(x, y, z)
    vector = (0.0, 0.0, 0.0) if direction is None else tuple(map(float, direction))
    if direction is not None and not any(vector):
        raise ValueError("direction is (0, 0, 0): expected a nonzero vector, or None for all directions")
    return _native.solid(*flat, frequency, *vector, direction is None, seed & 0xFFFFFFFF).reshape(shape)


def stripes(x: ArrayLike, y: ArrayLike, wave_x: ArrayLike, wave_y: ArrayLike, *, sharpness: float = 2.0, seed: int = 0,
            period: ArrayLike | None = None) -> NDArray[np.float32]:
    """Return stripes of even contrast along a map of wave vectors: (cosine, sine, intensity) along a last axis of 3.

    wave_x, wave_y: the wave vector in cycles per kernel radius, across the stripes; (0, 0) where the map has no direction.
    sharpness: (cosine, sine) has length 1 where the intensity exceeds 1 / sharpness, and fades below that, where stripes fork.
    period: as in `noise`.
    """
    shape, flat, waves = _points(x, y, also=(wave_x, wave_y))
    return _with_channels(_native.stripes(*flat, *waves, *_periods(period), float(sharpness), seed & 0xFFFFFFFF), shape)


def _erosion() -> dict[str, int | float]:
    """Return the members of GaborErosion with their defaults. Integers stay integers."""
    text = source("erosion")
    members = re.findall(r"^ +(int|float) (\w+);", text.partition("struct GaborErosion {")[2].partition("};")[0], re.MULTILINE)
    defaults = re.search(r"return GaborErosion\((.*)\);", text)[1].split(",")
    return {name: int(value) if kind == "int" else float(value) for (kind, name), value in zip(members, defaults)}


def terrain(x: ArrayLike, y: ArrayLike, base: ArrayLike | None = None, *, seed: int = 0, period: float | None = None,
            **erosion: float) -> NDArray[np.float32]:
    """Return eroded mountains: (height, d/dx, d/dy, ridge) along a last axis of 4. Heights are in the unit of x and y;
    ridge ranges from -1 in valleys to 1 on ridges.

    base: the same four values of a terrain to erode, along its last axis; None for hills about four units wide.
    period: units after which the terrain repeats, at least 4; None for no repetition.
    erosion: members of GaborErosion in gabor_erosion.glsl, such as octaves, frequency and strength; 0 octaves return the base
    alone. inspect.signature(terrain) has all of them with their defaults.
    """
    if unknown := erosion.keys() - _EROSION.keys():
        raise TypeError(f"terrain() has no argument {min(unknown)!r}: expected base, seed, period, {', '.join(_EROSION)}")
    if period is not None and not 4 <= period < np.inf:
        raise ValueError(f"period is {period}: expected at least 4, or None")
    given = () if base is None else tuple(np.moveaxis(np.asarray(base, np.float32), -1, 0))
    if base is not None and len(given) != 4:
        raise ValueError(f"base has {len(given)} values along its last axis: expected height, d/dx, d/dy, ridge")
    shape, flat, given = _points(x, y, also=given)
    members = [struct.pack("=i" if isinstance(default, int) else "=f", type(default)(erosion.get(name, default)))
               for name, default in _EROSION.items()]
    return _with_channels(_native.terrain(*flat, given, b"".join(members), period or 0.0, seed & 0xFFFFFFFF), shape)


_ENDINGS = {"glsl": "glsl", "hlsl": "hlsl", "metal": "metal", "wgsl": "wgsl", "godot": "gdshaderinc", "cpp": "hpp"}


def source(name: str = "noise", language: Literal["glsl", "hlsl", "metal", "wgsl", "godot", "cpp"] = "glsl") -> str:
    """Return the text of a drop-in: name is "noise", "spectrum", "filter", "noise_3d", "filter_3d", "materials", "erosion",
    "ocean", "direction" or "sparse".

    Paste all but "sparse" after "noise", "materials" after "spectrum" and "filter" too, and "filter_3d" after
    "filter" and "noise_3d".
    """
    folder = importlib.resources.files(__name__) / "source"
    if language not in _ENDINGS:
        raise ValueError(f"language is {language!r}: expected one of {', '.join(_ENDINGS)}")
    file = folder / f"gabor_{name}.{_ENDINGS[language]}"
    if not file.is_file():
        names = sorted(each.name[len("gabor_"):-len(".glsl")] for each in folder.iterdir() if each.name.endswith(".glsl"))
        raise ValueError(f"name is {name!r}: expected one of {', '.join(names)}")
    return file.read_text(encoding="utf-8")


_EROSION = _erosion()
_signature = inspect.signature(terrain)
terrain.__signature__ = _signature.replace(parameters=[
    *list(_signature.parameters.values())[:-1],
    *(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=type(default).__name__)
      for name, default in _EROSION.items())])
