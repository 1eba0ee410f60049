"""Gabor and fractal noise with mean 0 and variance 1, materials, eroded mountains and a sea, on numpy arrays; and their shaders' source.

    import gabor_noise
    picture = gabor_noise.image((512, 512), scale=32, frequency=4.0, orientation=0.7854, seed=7)
    x, y = gabor_noise.grid((512, 512), scale=128)
    wood = gabor_noise.material("wood", x, y, rings=20)["colour"]
    wgsl = gabor_noise.source("noise", "wgsl")

Positions are in kernel radii, a frequency is in cycles per kernel radius, and an angle in radians from +x towards +y; each is a
number or an array, from -10^9 to 10^9 for positions. Positions and parameters broadcast against each other, except periods. So
`seed=np.arange(8)[:, None, None]` makes a batch of eight pictures. Values equal those of the shaders up to rounding, wherever the
positions are; those of materials get coarser far from the origin.

All functions take these keywords:
    seed     an integer of 32 bits; different seeds give independent noises. A numpy.random.Generator draws one
    period   units after which the pattern repeats exactly, one number or one for each axis; 0 or None for no repetition
    workers  the number of cores to use, without holding the GIL; None for all
    dtype    of the result: float32, in which values are computed, or float64
They raise ValueError for a value out of its range, masked elements and shapes that do not broadcast, and TypeError for an unknown
keyword.
"""

from __future__ import annotations

import importlib.resources
import inspect
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._arguments import MEMBERS, Seed, choice, evaluate, fill_grid, members, number, numbers, periods, refuse, sides, vector
from ._heightmap import smoothed, sobel
from ._movie import Movie, movie

__all__ = ["image", "volume", "grid", "noise", "noise_gradient", "noise_quadrature", "noise_isotropic", "noise_spread", "noise_lobes", "Lobe",
           "noise_filtered", "noise_3d", "stripes", "fbm", "fbm_gradient", "fbm_filtered", "fbm_3d", "perlin", "warp", "uniform",
           "terrain", "erode", "material", "water", "water_height", "movie", "Movie", "source"]
__version__ = "@VERSION@"


# ---- Grids ---------------------------------------------------------------------------------------------------------

def grid(shape: Sequence[int], scale: float = 32.0) -> tuple[NDArray[np.float64], ...]:
    """Return the positions of the pixels' centres, as arrays that broadcast to the shape.

    shape: (height, width), which gives x and y; or (depth, height, width), which gives x, y and z.
    scale: pixels per unit.
    """
    return _axes(shape, scale, 2, 3)


def _axes(shape: Sequence[int], scale: float, *dimensions: int) -> tuple[NDArray[np.float64], ...]:
    pixels = number("scale", scale)
    axes = [(np.arange(side) + 0.5) / pixels for side in sides(shape, *dimensions)]
    return tuple(reversed(np.meshgrid(*axes, indexing="ij", sparse=True)))


def image(shape: Sequence[int], *, scale: float = 32.0, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0,
          isotropic: bool = False, frequency_spread: ArrayLike = 0.0, orientation_spread: ArrayLike = 0.0,
          lobes: Sequence[Lobe] | None = None, seed: Seed = 0, period: ArrayLike | None = None,
          evolution: ArrayLike | None = None, workers: int | None = None, dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return a picture of noise, with one value per pixel: mean 0, variance 1.

    shape: (height, width) in pixels.
    scale: pixels per kernel radius. Waves are scale / frequency pixels long.
    isotropic: waves in all directions, as in `noise_isotropic`.
    frequency_spread, orientation_spread: a range of waves, as in `noise_spread`.
    lobes: a sum of noises, as in `noise_lobes`.
    period: kernel radii, so width / scale gives a picture that tiles.
    The other arguments are those of `noise`. The result has this shape, or the one that it broadcasts to with the arguments.
    """
    x, y = _axes(shape, scale, 2)
    given = {**locals(), "x": x, "y": y}
    spread = np.any(frequency_spread) or np.any(orientation_spread)
    if bool(isotropic) + bool(spread) + (lobes is not None) > 1:
        raise ValueError("isotropic, a spread and lobes were given: expected at most one of them")
    if lobes is not None:
        return evaluate("lobes", given, _inputs(lobes))
    plain = None if isotropic or spread else fill_grid((y.size, x.size), given)
    return evaluate("isotropic" if isotropic else "spread" if spread else "noise", given) if plain is None else plain


def volume(shape: Sequence[int], *, scale: float = 32.0, frequency: ArrayLike = 4.0, direction: ArrayLike | None = None,
           seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
           dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return noise in 3D, with one value per voxel: mean 0, variance 1.

    shape: (depth, height, width) in voxels.
    scale: voxels per kernel radius.
    The other arguments are those of `noise_3d`.
    """
    x, y, z = _axes(shape, scale, 3)
    return noise_3d(x, y, z, frequency=frequency, direction=direction, seed=seed, period=period, evolution=evolution, workers=workers,
                    dtype=dtype)


# ---- Noise ---------------------------------------------------------------------------------------------------------

def noise(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: Seed = 0,
          period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
          dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return Gabor noise at (x, y): mean 0, variance 1 at every point.

    frequency: cycles per kernel radius, up to 10^6.
    orientation: direction of the wave vector in radians; waves run along it.
    period: kernel radii, at least 1/1024.
    evolution: time in an animation that repeats after 1, in turns; 0 or None for none.
    """
    return evaluate("noise", locals())


def noise_gradient(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: Seed = 0,
                   period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
                   dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return (noise, d/dx, d/dy) along a last axis of 3, with derivatives per kernel radius. Arguments are those of `noise`."""
    return evaluate("gradient", locals())


def noise_quadrature(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0, seed: Seed = 0,
                  period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
                  dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return (noise, quadrature) along a last axis of 2. The quadrature is the same pattern with its waves a quarter period
    ahead; arctan2(noise, quadrature) is the phase of stripes of even contrast. Arguments are those of `noise`."""
    return evaluate("quadrature", locals())


def noise_isotropic(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, seed: Seed = 0,
                    period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
                    dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return noise of waves in all directions, at the same cost for every frequency. Arguments are those of `noise`."""
    return evaluate("isotropic", locals())


def noise_spread(x: ArrayLike, y: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0,
                 frequency_spread: ArrayLike = 0.0, orientation_spread: ArrayLike = np.pi / 2, seed: Seed = 0,
                 period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
                 dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return noise of a range of waves, a sum of up to 1024 noises: of 10 for all directions at frequency 2.

    frequency_spread: frequencies are within this fraction of the frequency, 0 to 1.
    orientation_spread: directions are within so many radians of the orientation, 0 to pi/2, which is all directions.
    The other arguments are those of `noise`.
    """
    return evaluate("spread", locals())


class Lobe(NamedTuple):
    """Noise around one wave vector, as a part of `noise_lobes`. Each member is a number, or an array that broadcasts."""

    cycles_per_unit: ArrayLike  # the waves' frequency per unit of x and y, whatever the radius
    orientation: ArrayLike = 0.0  # as in `noise`
    radius: ArrayLike = 1.0  # radius of the kernels along x and y, one number or a pair along the last axis
    power: ArrayLike = 1.0  # power relative to the other lobes, 0 or more


def noise_lobes(x: ArrayLike, y: ArrayLike, lobes: Sequence[Lobe], *, seed: Seed = 0, period: ArrayLike | None = None,
                evolution: ArrayLike | None = None, workers: int | None = None, dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return a sum of independent noises: mean 0, variance 1. Its spectrum has a lobe around each wave vector, with a standard
    deviation of 1/sqrt(12) / radius cycles per unit.

    lobes: 1 to 16 of them; or tuples like them, such as (cycles_per_unit, orientation).
    The other arguments are those of `noise`.
    """
    return evaluate("lobes", locals(), _inputs(lobes))


def _inputs(lobes: Sequence[Lobe]) -> list[NDArray[np.float64]]:
    """Return five inputs for each lobe."""
    expected = "1 to 16 lobes: (cycles_per_unit, orientation, radius, power), of which the last three may be left out"
    try:
        complete = [Lobe(*lobe) for lobe in lobes]
    except TypeError:
        raise refuse("lobes", lobes, expected) from None
    if not 1 <= len(complete) <= 16:
        raise refuse("lobes", lobes, expected)
    inputs: list[NDArray[np.float64]] = []
    for index, lobe in enumerate(complete):
        try:
            inputs += [numbers("cycles_per_unit", lobe.cycles_per_unit), numbers("orientation", lobe.orientation),
                       *vector("radius", lobe.radius, 2), numbers("power", lobe.power)]
        except ValueError as error:
            raise ValueError(f"lobes[{index}]: {error}") from None
    if not np.any(sum(inputs[4::5])):
        raise ValueError("the lobes have no power: expected one with a power above 0")
    return inputs


def noise_filtered(x: ArrayLike, y: ArrayLike, pixel_size: ArrayLike, *, frequency: ArrayLike = 4.0, orientation: ArrayLike = 0.0,
                   seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None,
                   workers: int | None = None, dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return (noise averaged over a pixel, share of the variance that averaging removed) along a last axis of 2.

    pixel_size: the pixel's sides in kernel radii, one number or a pair along the last axis.
    The other arguments are those of `noise`.
    """
    return evaluate("filtered", locals())


def noise_3d(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, frequency: ArrayLike = 4.0, direction: ArrayLike | None = None,
             seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
             dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return noise at (x, y, z): mean 0, variance 1 at every point.

    direction: a vector of any length along the wave vector, three numbers along the last axis; None for waves in all
    directions, at several times the cost.
    The other arguments are those of `noise`; a period may have three numbers.
    """
    if direction is None:
        return evaluate("3d_isotropic", locals())
    if (np.asarray(direction) == 0).all(axis=-1).any():
        raise refuse("direction", direction, "nonzero vectors, or None for all directions")
    return evaluate("3d", locals())


def stripes(x: ArrayLike, y: ArrayLike, wave_x: ArrayLike, wave_y: ArrayLike, *, sharpness: ArrayLike = 2.0, seed: Seed = 0,
            period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
            dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return stripes of even contrast along a map of wave vectors: (cosine, sine, intensity) along a last axis of 3.

    wave_x, wave_y: the wave vector in cycles per kernel radius, across the stripes; (0, 0) where the map has no direction.
    sharpness: (cosine, sine) has length 1 where the intensity exceeds 1 / sharpness, and fades below that, where stripes fork.
    The other arguments are those of `noise`.
    """
    return evaluate("stripes", locals())


# ---- Fractal noise -------------------------------------------------------------------------------------------------

_PERIOD = 8 / 3  # the shortest, in kernel radii
_TURN = float(np.arctan(0.75))  # of gabor_fractal


def _words(given: Mapping[str, Any]) -> list[NDArray[np.float64]]:
    return [choice("basis", given["basis"], ("smooth", "perlin")), choice("shape", given["shape"], ("fbm", "billow", "ridged"))]


def fbm(x: ArrayLike, y: ArrayLike, *, octaves: ArrayLike = 5.0, gain: ArrayLike = 0.5, lacunarity: ArrayLike = 2.0,
        basis: Literal["smooth", "perlin"] = "smooth", shape: Literal["fbm", "billow", "ridged"] = "fbm", turn: ArrayLike = _TURN,
        seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
        dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return a sum of octaves of noise at (x, y): mean 0, variance 1 at every point.

    octaves: 1 to 16; the last one fades in with the fraction.
    gain: amplitude of an octave relative to the previous one, 0 to 4.
    lacunarity: frequency of an octave relative to the previous one, 1 to 4.
    basis: the noise of an octave: "smooth", mostly of low frequencies, or "perlin", whose octaves are narrower.
    shape: what each octave n becomes: "fbm", n; "billow", |n|; "ridged", -|n|.
    turn: angle by which an octave is turned against the previous one; unused with a period.
    period: kernel radii, at least 8/3; the noise then takes up to ten times as long.
    evolution: time in an animation that repeats after 1, in turns; 0 or None for none.
    """
    return evaluate("fractal", locals(), _words(locals()), _PERIOD)


def fbm_gradient(x: ArrayLike, y: ArrayLike, *, octaves: ArrayLike = 5.0, gain: ArrayLike = 0.5, lacunarity: ArrayLike = 2.0,
                 basis: Literal["smooth", "perlin"] = "smooth", shape: Literal["fbm", "billow", "ridged"] = "fbm",
                 turn: ArrayLike = _TURN, seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None,
                 workers: int | None = None, dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return (noise, d/dx, d/dy) along a last axis of 3, with derivatives per kernel radius. Arguments are those of `fbm`."""
    return evaluate("fractal_gradient", locals(), _words(locals()), _PERIOD)


def fbm_filtered(x: ArrayLike, y: ArrayLike, pixel_size: ArrayLike, *, octaves: ArrayLike = 5.0, gain: ArrayLike = 0.5,
                 lacunarity: ArrayLike = 2.0, basis: Literal["smooth", "perlin"] = "smooth",
                 shape: Literal["fbm", "billow", "ridged"] = "fbm", turn: ArrayLike = _TURN, seed: Seed = 0,
                 period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
                 dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return (noise averaged over a pixel, share of the variance that averaging removed) along a last axis of 2.

    pixel_size: the pixel's sides in kernel radii, one number or a pair along the last axis.
    The other arguments are those of `fbm`.
    """
    return evaluate("fractal_filtered", locals(), _words(locals()), _PERIOD)


def fbm_3d(x: ArrayLike, y: ArrayLike, z: ArrayLike, *, octaves: ArrayLike = 5.0, gain: ArrayLike = 0.5, lacunarity: ArrayLike = 2.0,
           basis: Literal["smooth", "perlin"] = "smooth", shape: Literal["fbm", "billow", "ridged"] = "fbm", turn: ArrayLike = _TURN,
           seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
           dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return a sum of octaves of noise at (x, y, z): mean 0, variance 1 at every point. Arguments are those of `fbm`; a period may
    have three numbers."""
    return evaluate("fractal_3d", locals(), _words(locals()), _PERIOD)


def perlin(x: ArrayLike, y: ArrayLike, *, seed: Seed = 0, workers: int | None = None,
           dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return noise that replaces Perlin and simplex noise: mean 0, variance 1 at every point. x and y are in the cells of Perlin noise,
    so both have the same size; to match its contrast, multiply by 0.25 to 0.3."""
    return evaluate("perlin", locals())


def warp(x: ArrayLike, y: ArrayLike, *, strength: ArrayLike, octaves: ArrayLike = 5.0, gain: ArrayLike = 0.5, lacunarity: ArrayLike = 2.0,
         basis: Literal["smooth", "perlin"] = "smooth", shape: Literal["fbm", "billow", "ridged"] = "fbm", turn: ArrayLike = _TURN,
         seed: Seed = 0, period: ArrayLike | None = None, evolution: ArrayLike | None = None, workers: int | None = None,
         dtype: DTypeLike = np.float64) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the coordinates (x, y), moved along two noises, at which any noise shows marble, smoke or swirls.

    strength: deviation of the shift along x and y, in kernel radii.
    The other arguments are those of `fbm`.
    """
    shift = evaluate("warp", locals(), _words(locals()), _PERIOD)
    moved = numbers("x", x) + shift[..., 0], numbers("y", y) + shift[..., 1]
    return moved[0].astype(dtype, copy=False), moved[1].astype(dtype, copy=False)


def uniform(noise: ArrayLike, *, workers: int | None = None, dtype: DTypeLike = np.float32) -> NDArray[Any]:
    """Return the rank of normal noise among all values, uniform in [0, 1], within 2e-5: `uniform(fbm(x, y)) < 0.3` is 30 % of the
    area."""
    return evaluate("uniform", locals())


# ---- Terrain -------------------------------------------------------------------------------------------------------

def terrain(x: ArrayLike, y: ArrayLike, base: ArrayLike | None = None, *, pixel_size: ArrayLike = 0.0, seed: Seed = 0,
            period: ArrayLike | None = None, workers: int | None = None, dtype: DTypeLike = np.float32,
            **erosion: ArrayLike) -> NDArray[Any]:
    """Return eroded mountains: (height, d/dx, d/dy, ridge) along a last axis of 4. Heights are in the unit of x and y;
    ridge ranges from -1 in valleys to 1 on ridges.

    base: the same four values of a terrain to erode, along its last axis, or seven with its curvature (xx, xy, yy), without
    which slopes err by 0.45 times the rms slope; None for hills about four units wide.
    pixel_size: the pixel's sides, one number or a pair, to leave out finer features; 0 for none.
    period: units after which the terrain repeats, at least 4.
    erosion:
    """
    if base is None:
        return evaluate("terrain", locals(), members("terrain", erosion, "terrain()"), 4.0)
    given = numbers("base", base)
    if given.ndim == 0 or given.shape[-1] not in (4, 7):
        raise refuse("base", base, "4 values along its last axis: height, d/dx, d/dy, ridge; or 7 with xx, xy, yy")
    base = np.concatenate([given, np.zeros((*given.shape[:-1], 7 - given.shape[-1]))], -1)
    return evaluate("eroded", locals(), members("eroded", erosion, "terrain()"), 4.0)


_SLOPE = 0.637  # rms, of the hills of `terrain`, for which parameters are chosen
# As `gabor erode`: the preset alps, adapted to maps.
_OF_MAPS = {"gully_frequency": 1.5, "strength": 0.15, "onset_slope": 2 * _SLOPE, "detail": 2.5, "uniformity": 2.5, "crease_rounding": 0.4}


def erode(heights: ArrayLike, extent: ArrayLike, *, gully_width: float | None = None, tileable: bool = False, seed: Seed = 0,
          workers: int | None = None, dtype: DTypeLike = np.float32, **erosion: ArrayLike) -> NDArray[Any]:
    """Return a heightmap with gullies and ridges, in proportion to its slopes and width: (height, d/dx, d/dy, ridge) along a last
    axis of 4. Gullies follow the map smoothed to their scale. Parameters and defaults are those of `gabor erode`.

    heights: an array of at least 3 x 3 heights.
    extent: the map's width, or its width and height, in the unit of its heights.
    gully_width: width of the widest gullies, in the unit of extent, in place of gully_frequency.
    tileable: the map tiles without seams, and so does the result.
    erosion: for any map, these parameters mean what they mean for one that is 8 units wide with an rms slope of 0.637, that of the
        hills of `terrain`. So there are 8 * gully_frequency gullies across the map. Without strength, heights change by at most an
        eighth of their range.
    """
    here = numbers("heights", heights)
    if here.ndim != 2 or min(here.shape) < 3:
        raise refuse("heights", here, "an array of at least 3 x 3 heights")
    sides = numbers("extent", extent).ravel()
    if sides.size not in (1, 2) or not np.all(sides > 0):
        raise refuse("extent", extent, "a width above 0, or a width and a height")
    tall = sides[-1] / sides[0] * here.shape[1] / here.shape[0] if sides.size == 2 else 1.0
    pixel, unit = 8 / here.shape[1], float(sides[0]) / 8
    if gully_width is not None:
        if "gully_frequency" in erosion:
            raise TypeError("erode() takes gully_width or gully_frequency, not both")
        erosion["gully_frequency"] = unit / number("gully_width", gully_width)
    chosen = {**_OF_MAPS, **erosion}
    members("terrain", chosen, "erode()")
    frequency = number("gully_frequency", chosen["gully_frequency"])
    surface, slope = smoothed(here, max(here.shape[1] / 8 / frequency / 7, 1.0), tall, tileable)
    steepness = _SLOPE / (slope / (pixel * unit)) if slope > 0 else 1.0
    if "strength" not in erosion:
        octaves, gain, weight = (float(np.max(chosen.get(name, MEMBERS["terrain"][name].default))) for name in ("octaves", "gain", "gully_weight"))
        most = _OF_MAPS["strength"] / frequency * sum(gain**k for k in range(int(octaves))) * weight * unit / steepness
        chosen["strength"] = _OF_MAPS["strength"] * min(1.0, np.ptp(here) / 8 / most if most > 0 else 1.0)
    scaled = [each * (steepness / unit / pixel**order / tall**down) for each, order, down in zip(surface, (0, 1, 1, 2, 2, 2), (0, 0, 1, 0, 1, 2))]
    x, y = grid(here.shape, 1 / pixel)
    y = y * tall
    base = np.stack([*scaled[:3], np.zeros_like(here), *scaled[3:]], -1)
    period = (8, pixel * tall * here.shape[0]) if tileable else None
    terrain_there = terrain(x, y, base, pixel_size=(pixel, pixel * tall), seed=seed, period=period, workers=workers, dtype=np.float64, **chosen)
    result = np.empty(terrain_there.shape, float)
    result[..., 0] = here + (terrain_there[..., 0] - scaled[0]) * (unit / steepness)
    for channel, size, own in zip((1, 2), (1, tall), sobel(here, tileable)):
        result[..., channel] = own / (pixel * size * unit) + (terrain_there[..., channel] - scaled[channel]) / steepness
    result[..., 3] = terrain_there[..., 3]
    return result.astype(dtype, copy=False)


# ---- Materials -----------------------------------------------------------------------------------------------------

def material(name: str, x: ArrayLike, y: ArrayLike, *, pixel_size: ArrayLike = 0.0, seed: Seed = 0,
             period: ArrayLike | None = None, workers: int | None = None, dtype: DTypeLike = np.float32,
             **parameters: ArrayLike) -> dict[str, NDArray[Any]]:
    """Return a material, as a dict of arrays: colour (red, green and blue along a last axis of 3; linear, 0 to 1), height, slope
    (d/dx, d/dy along a last axis of 2), roughness, metalness, and lost, the covariance of the slopes that the filter removed (xx,
    yy, xy along a last axis of 3). A picture of four by four units shows a material well.

    pixel_size: the pixel's sides, one number or a pair, over which to average; 0 for none.
    period: as above, along both axes or neither; a short one compresses the material's large-scale variation.
    parameters: of the material, such as wood. Angles are in radians.
    """
    kernel = str(name).replace("-", "_")
    if kernel.replace("_", "-") not in _MATERIALS:
        raise refuse("name", name, f"one of {', '.join(_MATERIALS)}")
    if sum(each > 0 for each in periods(period, 2, 2.0**-10)) == 1:
        raise refuse("period", period, "one along both axes or neither")
    values = evaluate(kernel, locals(), members(kernel, parameters, f"material({name!r})"))
    return {"colour": values[..., :3], "height": values[..., 3], "slope": values[..., 4:6], "roughness": values[..., 6],
            "metalness": values[..., 7], "lost": values[..., 8:]}


_MATERIALS = [name.replace("_", "-") for name in MEMBERS if name not in ("terrain", "eroded", "water", "water_height")]


# ---- The sea -------------------------------------------------------------------------------------------------------

def water(x: ArrayLike, y: ArrayLike, *, seconds: ArrayLike = 0.0, direction: ArrayLike = 0.0, loop_seconds: ArrayLike = 0,
          pixel_size: ArrayLike = 0.0, seed: Seed = 0, workers: int | None = None, dtype: DTypeLike = np.float32,
          **sea: ArrayLike) -> dict[str, NDArray[Any]]:
    """Return the water that is at (x, y) when at rest, as a dict of arrays: height in metres, normally distributed around 0; slope,
    the derivatives of the height by x and y; shift, the horizontal displacement in metres; jacobian, of (x, y) + shift by (x, y): 1 at
    rest and lower where the water folds; lost, the covariance (xx, yy, xy) of the slopes of finer waves; velocity, along x, along y and
    up, in metres per second. Slope, shift, lost and velocity have a last axis.

    x, y: metres. Values equal those of the shader `gabor_ocean.glsl`, wherever and whenever they are.
    seconds: time.
    direction: where the wind and its waves go.
    loop_seconds: the seconds after which all repeats, a power of 2 from 8 to 4096, or 0. Groups of waves then stand still, and each wave's
    period becomes an integer fraction of the loop, which should last several periods of the swell.
    pixel_size: the pixel's sides in metres, one number or a pair, to leave out finer waves; 0 for none.
    sea: directions in radians.
    """
    values = evaluate("water", locals(), members("water", sea, "water()"))
    return {"height": values[..., 0], "slope": values[..., 1:3], "shift": values[..., 3:5], "jacobian": values[..., 5],
            "lost": values[..., 6:9], "velocity": values[..., 9:]}


def water_height(x: ArrayLike, y: ArrayLike, *, seconds: ArrayLike = 0.0, direction: ArrayLike = 0.0, loop_seconds: ArrayLike = 0,
                 seed: Seed = 0, workers: int | None = None, dtype: DTypeLike = np.float32, **sea: ArrayLike) -> NDArray[Any]:
    """Return the height of the water above the fixed place (x, y), where a boat floats. Arguments are those of `water`:
    """
    return evaluate("water_height", locals(), members("water_height", sea, "water_height()"))


# ---- Source --------------------------------------------------------------------------------------------------------

_ENDINGS = {"glsl": "glsl", "hlsl": "hlsl", "metal": "metal", "wgsl": "wgsl", "godot": "gdshaderinc", "cpp": "hpp"}


def source(name: str = "noise", language: Literal["glsl", "hlsl", "metal", "wgsl", "godot", "cpp"] = "glsl") -> str:
    """Return the text of a drop-in: name is "noise", "spectrum", "filter", "noise_3d", "filter_3d", "materials", "compose",
    "erosion", "ocean", "direction", "fractal" or "sparse".

    Paste all but "sparse" after "noise", "materials" after "spectrum" and "filter" too, "compose" after "materials", and
    "filter_3d" after "filter" and "noise_3d".
    """
    folder = importlib.resources.files(__name__) / "source"
    if language not in _ENDINGS:
        raise ValueError(f"language is {language!r}: expected one of {', '.join(_ENDINGS)}")
    file = folder / f"gabor_{name}.{_ENDINGS[language]}"
    if not file.is_file():
        names = sorted(each.name[len("gabor_"):-len(".glsl")] for each in folder.iterdir() if each.name.endswith(".glsl"))
        raise ValueError(f"name is {name!r}: expected one of {', '.join(names)}")
    return file.read_text(encoding="utf-8")


# ---- Signatures and help of the functions whose parameters are members of structs ----------------------------------------------

def _describe(kernel: str, defaults: Mapping[str, float] = {}) -> str:
    lines = []
    for member in MEMBERS[kernel].values():
        span = "" if member.kind == "colour" else f", {member.low:.5g} to {member.high:.5g}"
        lines.append(f"        {member.name}: {member.about[0].lower()}{member.about[1:]}{span} [{defaults.get(member.name, member.default)}]")
    return "\n".join(lines)


def _document(function: Callable[..., object], kernel: str, defaults: Mapping[str, float] = {}) -> None:
    """Add the members of a struct to a function's signature and help."""
    signature = inspect.signature(function)
    function.__signature__ = signature.replace(parameters=[  # type: ignore[attr-defined]
        *list(signature.parameters.values())[:-1],
        *(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=defaults.get(name, member.default), annotation="ArrayLike")
          for name, member in MEMBERS[kernel].items())])
    function.__doc__ = f"{function.__doc__.rstrip()}\n{_describe(kernel, defaults)}\n"  # type: ignore[union-attr]


_document(terrain, "terrain")
_document(erode, "terrain", _OF_MAPS)
_document(water, "water")
_document(water_height, "water")
material.__doc__ = f"{material.__doc__.rstrip()}\n\n" + "".join(  # type: ignore[union-attr]
    f"    {name}:\n{_describe(name.replace('-', '_'))}\n" for name in _MATERIALS)
